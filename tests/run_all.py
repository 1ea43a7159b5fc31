"""Runs every Boost test program of a build and every Python test, and counts single cases.

The last line is "N passed, N failed"; the exit code is 0 when nothing failed.
  ./turgor test [--fast] [--disturb N] [PART...]              builds what is missing first
  run_all.py --build DIR [--fast] [--disturb N] [PART...]     of a build that is there
PART is a test program (app, coupling, macro, micro, run, rve) or python; without one all run. One suite or one case:
build/tests/test_PART --run_test=SUITE/CASE, all names: build/tests/test_PART --list_content.
--fast leaves out Boost cases labelled "slow" and is what the sanitizer build runs.
--disturb N runs the test programs with every instruction set this processor has (TURGOR_SIMD), each of them undisturbed and with
the start of all scenes moved by round-off in N ways (TURGOR_DISTURB, see disturbance.cc). Nothing may fail: no test asks one chaotic
trajectory for an exact outcome.
"""
import argparse
import concurrent.futures
import json
import os
import re
import subprocess
import sys
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))


def programs(build):
    """(name, command) of every test CMake knows."""
    text = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, check=True, capture_output=True, text=True).stdout
    return [(test["name"], test["command"]) for test in json.loads(text)["tests"] if "command" in test]


def instruction_sets():
    """Values of TURGOR_SIMD that this processor can run (micro/terms/sph_sweeps.cc)."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        flags = set(re.search(r"^flags\s*:(.*)$", file.read(), re.M)[1].split())
    return ["avx512"] * ({"avx512f", "avx512dq"} <= flags) + ["avx2", "portable"]


def run_program(name, command, fast):
    extra = ["--report_level=short", "--color_output=no"] + (["--run_test=!@slow"] if fast else [])
    start = time.time()
    try:
        done = subprocess.run(command[:1] + extra, capture_output=True, text=True, errors="replace", timeout=1200,
                              stdin=subprocess.DEVNULL)
        output, code = done.stdout + done.stderr, done.returncode
    except subprocess.TimeoutExpired:
        output, code = "It did not end within 20 minutes.", 1
    count = lambda verdict: sum(int(n) for n in re.findall(rf"^\s*(\d+) test cases? out of \d+ {verdict}", output, re.M))
    passed, failed = count("passed"), count("failed") + count("aborted")
    if code != 0 and failed == 0:
        failed = 1  # it died before it could report
    if passed + failed == 0:
        failed, output = 1, output + "\nIt reported no test case."
    print(f"{name}: {passed} passed, {failed} failed ({time.time() - start:.1f} s)", flush=True)
    if failed:
        print(output, flush=True)
    return passed, failed


def python_classes():
    """(file name without .py, name of a test class) of every Python test, files with many tests first: they last longest."""
    classes = []
    for folder, _, files in sorted(os.walk(HERE)):
        for name in sorted(files):
            if name.startswith("test_") and name.endswith(".py"):
                sys.path.insert(0, folder)
                found = {}
                for test in flat(unittest.defaultTestLoader.loadTestsFromName(name[:-3])):
                    found.setdefault(f"{name[:-3]}.{type(test).__name__}", []).append(test)
                classes += [(len(tests), name) for name, tests in found.items()]
    return [name for _, name in sorted(classes, reverse=True)]


def flat(suite):
    for test in suite:
        yield from flat(test) if isinstance(test, unittest.TestSuite) else [test]


def run_class(name):
    """(name, seconds, run, skipped, [(what failed, text)]) of one class of Python tests."""
    start = time.time()
    with open(os.devnull, "w") as nowhere:
        result = unittest.TextTestRunner(stream=nowhere).run(unittest.defaultTestLoader.loadTestsFromName(name))
    bad = [(test.id(), text) for test, text in result.failures + result.errors]
    bad += [(test.id(), "It was expected to fail and has passed.") for test in result.unexpectedSuccesses]
    return name, time.time() - start, result.testsRun, len(result.skipped), bad


def run_python(build):
    """Classes beside each other, as many as there are processors to use: most of their time goes into programs they start."""
    os.environ["TURGOR_BUILD"] = os.path.abspath(build)
    names = python_classes()
    start, run, skipped, bad, times = time.time(), 0, 0, [], []
    with concurrent.futures.ProcessPoolExecutor(min(4, len(os.sched_getaffinity(0)))) as pool:
        for name, seconds, run_here, skipped_here, bad_here in pool.map(run_class, names):
            run, skipped, bad = run + run_here, skipped + skipped_here, bad + bad_here
            times.append((seconds, name))
    failed = len({test for test, _ in bad})
    slowest = ", ".join(f"{name} {seconds:.0f} s" for seconds, name in sorted(times, reverse=True)[:4])
    print(f"python: {run - failed - skipped} passed, {failed} failed, {skipped} skipped ({time.time() - start:.1f} s; {slowest})", flush=True)
    for test, text in bad:
        print(f"{test}\n{text}", flush=True)
    return max(run - failed - skipped, 0), failed


def main():
    parser = argparse.ArgumentParser(prog="./turgor test", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, metavar="DIR", help="build directory; ./turgor test gives its own")
    parser.add_argument("--fast", action="store_true", help="without the slow cases")
    parser.add_argument("--disturb", type=int, metavar="N", help="every instruction set, undisturbed and moved by round-off in N ways")
    parser.add_argument("names", nargs="*", metavar="PART", help="app, coupling, macro, micro, run, rve or python; all without one")
    options = parser.parse_args()
    passed = failed = 0
    ways = [{}]
    if options.disturb is not None:
        ways = [{"TURGOR_SIMD": simd, "TURGOR_DISTURB": str(seed)} for simd in instruction_sets() for seed in range(options.disturb + 1)]
    for way in ways:
        os.environ.update(way)
        for name, command in programs(options.build):
            if not options.names or name in options.names:
                good, bad = run_program(", ".join([name] + [f"{key}={value}" for key, value in way.items()]), command, options.fast)
                passed, failed = passed + good, failed + bad
    if options.disturb is None and (not options.names or "python" in options.names):
        good, bad = run_python(options.build)
        passed, failed = passed + good, failed + bad
    print(f"{passed} passed, {failed} failed")
    return 0 if failed == 0 and passed > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
