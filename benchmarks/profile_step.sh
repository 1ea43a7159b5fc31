#!/bin/sh
# Where a micro step spends its time: share of every function in whole kick-drift-kick steps of benchmark_fluid with
# viscosity, 1 thread.
#
#   benchmarks/profile_step.sh [BUILD_DIRECTORY]        default build-bench, built with -DTURGOR_BENCHMARKS=ON
#
# With perf that works: 16 x 16 cells, sampled. Else valgrind's callgrind: instructions of a few steps of one cell (the
# share of instructions, not of time; valgrind knows no AVX-512, so these are the portable sweeps). Last come the sums of:
#   density sweep (pairs, wall), force sweep, list building, wall springs and ties, integrator. Parts of a sweep that the
#   compiler put into one function are one line.
set -eu
build=${1:-build-bench}
program=$build/benchmarks/benchmark_fluid
if [ ! -x "$program" ]; then
  echo "There is no $program: cmake -S . -B $build -G Ninja -DTURGOR_BENCHMARKS=ON && ninja -C $build benchmark_fluid" >&2
  exit 2
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if command -v perf > /dev/null && perf record -q -o "$work/try" -- true > /dev/null 2>&1; then
  # The set-up anneals a reference cell: sampling begins behind it.
  perf record -q -F 999 -D 4000 -o "$work/perf.data" -- "$program" --benchmark_filter='step/cells_a_side:16/viscous:1/threads:1/' \
    --benchmark_min_time=10 > "$work/benchmark.txt" 2>&1
  cat "$work/benchmark.txt"
  perf report -i "$work/perf.data" --no-children --stdio -F overhead,symbol 2> /dev/null | sed -n 's/^ *\([0-9.]*\)% *\[.\] */\1 /p' > "$work/shares"
  echo "share of samples, perf, 16 x 16 cells"
elif command -v valgrind > /dev/null; then
  TURGOR_SIMD=avx2 valgrind --tool=callgrind --callgrind-out-file="$work/callgrind" --toggle-collect='*KickDriftKick*step*' \
    "$program" --benchmark_filter='step/cells_a_side:1/viscous:1/threads:1/' --benchmark_min_time=0.000001 > "$work/benchmark.txt" 2>&1 \
    || { cat "$work/benchmark.txt" >&2; exit 1; }
  callgrind_annotate --threshold=99.9 "$work/callgrind" | awk '/^ *[0-9,]+ \( *[0-9.]+%\)/ && !/PROGRAM TOTALS/' \
    | sed 's/^ *[0-9,]* ( *\([0-9.]*\)%) *[^:]*:/\1 /; s/ \[[^]]*\]$//' > "$work/shares"
  echo "share of instructions, callgrind, one cell"
else
  echo "This needs perf (linux-perf) or valgrind." >&2
  exit 2
fi

head -25 "$work/shares"
awk '
  function part(name) {
    if (name ~ /sum_kernels/) return "density sweep: pairs, and faces of the wall"
    if (name ~ /add_angles|push_wall/) return "density sweep: wall alone"
    if (name ~ /sph::.*density|fill_rows|apply_law|eos_pressure|sum_of/) return "density sweep: rest, or all of it if inlined"
    if (name ~ /sph::.*force/) return "force sweep"
    if (name ~ /SphLists|ListOrigin|SphFluid::build/) return "list building and its test"
    if (name ~ /RingWall|LamellaTies/) return "wall springs and ties"
    if (name ~ /KickDriftKick|drift_of_group/) return "integrator"
    if (name ~ /SphFluid/) return "fluid: copying wall and forces"
    return "other"
  }
  { share = $1; $1 = ""; sum[part($0)] += share }
  END { for (name in sum) printf "%6.1f %%  %s\n", sum[name], name }' "$work/shares" | sort -rn
