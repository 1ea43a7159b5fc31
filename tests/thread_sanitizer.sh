#!/bin/bash
# Races between threads: test_micro and test_coupling with clang's ThreadSanitizer.
#
#   tests/thread_sanitizer.sh [DIRECTORY]      builds there (build-threads), some ten minutes; exit code 0 and no report: none found
#
# TBB itself is built with the sanitizer, from Debian's source, or every task would look like a race. deal.II is not: what its own tasks
# make in one thread and free in another is left out of the report. Needs clang and dpkg-dev, and a deb-src line or the network to add one.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
place=$(realpath -m "${1:-$root/build-threads}")
mkdir -p "$place"
cd "$place"

if [[ ! -d $(echo onetbb-*/ | cut -d' ' -f1) ]]; then
  list=/etc/apt/sources.list.d/turgor-source.list
  trap 'rm -f "$list"' EXIT
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian bookworm main" >"$list"
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends dpkg-dev clang >/dev/null
  apt-get source -qq onetbb
fi
cmake -S onetbb-*/ -B tbb -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DTBB_TEST=OFF -DTBB_STRICT=OFF -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_FLAGS=-fsanitize=thread >/dev/null
ninja -C tbb tbb tbbmalloc >/dev/null
cmake -S "$root" -B turgor -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_CXX_FLAGS="-fsanitize=thread -O1 -g1 -Wno-error" -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="" >/dev/null
ninja -C turgor tests/test_micro tests/test_coupling

printf 'race:dealii\ncalled_from_lib:libdeal.ii\n' >left_out
LD_LIBRARY_PATH=$(dirname "$(find "$place/tbb" -name 'libtbb.so.12' | head -1)")
export LD_LIBRARY_PATH TSAN_OPTIONS="suppressions=$place/left_out history_size=4"
for suite in cell_friction spheroid spheroid_surrounded cell_surroundings full_micro single_cell_scenes sph_fluid two_cells tissue_loading; do
  turgor/tests/test_micro --run_test="$suite"
done
# these two start the program, which is not built here
turgor/tests/test_coupling '--run_test=!tissue_bruise/the_program_on_two_ranks:!tissue_gravity/same_bits*'
