#!/usr/bin/python3
"""Two builds against each other, in turns on the same machine: every benchmark of both, and whole runs of the golden scenes with both programs.

    cmake -S . -B build-bench -G Ninja -DTURGOR_BENCHMARKS=ON && ninja -C build-bench        (and the same in the other checkout)
    /usr/bin/python3 benchmarks/pairs.py OTHER/build-bench build-bench
    /usr/bin/python3 benchmarks/pairs.py OTHER/build-bench build-bench --only 'cells/friction|scene/spheroid' --pairs 10

Prints the median CPU time with either and the median, smallest and largest ratio of a pair, second build over first: below 1 is faster. Which
of the two comes first changes from pair to pair.
"""
import argparse
import json
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import time

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
GOLDEN = os.path.join(SOURCE, "tests", "golden")
PROGRAMS = ["benchmark_cells", "benchmark_fluid", "benchmark_fluid_3d", "benchmark_sweeps", "benchmark_rve", "benchmark_rods", "benchmark_surfaces"]


def names_of(build):
    """{"cells/friction/1000": program} of all benchmarks, and "scene/NAME" of all golden scenes."""
    found = {}
    for program in PROGRAMS:
        path = os.path.join(build, "benchmarks", program)
        if os.path.exists(path):
            listed = subprocess.run([path, "--benchmark_list_tests"], check=True, capture_output=True, text=True).stdout
            found.update({program.removeprefix("benchmark_") + "/" + name: program for name in listed.split()})
    found.update({"scene/" + name.removesuffix(".prm"): None for name in sorted(os.listdir(GOLDEN)) if name.endswith(".prm")})
    return found


def children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def once(build, name, program, seconds):
    """CPU seconds of one benchmark's iteration or of one run."""
    short = name.split("/", 1)[1]
    if program:
        out = subprocess.run([os.path.join(build, "benchmarks", program), f"--benchmark_filter=^{re.escape(short)}$", "--benchmark_format=json",
                              f"--benchmark_min_time={seconds}"], check=True, capture_output=True, text=True).stdout
        result = json.loads(out)["benchmarks"][0]
        return result["cpu_time"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.}[result["time_unit"]]
    with tempfile.TemporaryDirectory() as directory:
        before = children()
        subprocess.run([os.path.join(build, "app", "turgor"), "run", os.path.join(GOLDEN, short + ".prm"), "-o", os.path.join(directory, "run"),
                        "--quiet", "--threads", "1"], check=True, capture_output=True, stdin=subprocess.DEVNULL)
        return children() - before


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("first")
    asked.add_argument("second")
    asked.add_argument("--only", default="", help="regular expression of names")
    asked.add_argument("--pairs", type=int, default=10)
    asked.add_argument("--seconds", type=float, default=0.05, help="of one benchmark's repetitions")
    asked = asked.parse_args()
    other = names_of(asked.first)
    print(f"{'':44s} {'first':>10s} {'second':>10s}  ratio (smallest .. largest of {asked.pairs} pairs)")
    began = time.monotonic()
    for name, program in names_of(asked.second).items():
        if name not in other or not re.search(asked.only, name):
            continue
        times = ([], [])
        for pair in range(asked.pairs):
            for which in (0, 1) if pair % 2 == 0 else (1, 0):
                times[which].append(once((asked.first, asked.second)[which], name, program, asked.seconds))
        ratios = [b / a for a, b in zip(*times)]
        print(f"{name:44s} {statistics.median(times[0]):10.3g} {statistics.median(times[1]):10.3g}  {statistics.median(ratios):.3f}"
              f" ({min(ratios):.3f} .. {max(ratios):.3f})", flush=True)
    print(f"{time.monotonic() - began:.0f} s", file=sys.stderr)


if __name__ == "__main__":
    main()
