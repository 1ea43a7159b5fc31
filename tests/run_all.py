"""Runs every Boost test program of a build and every Python test, and counts single cases.

The last line is "N passed, N failed"; the exit code is 0 when nothing failed.
  run_all.py --build DIR [--fast] [--disturb N] [NAME...]     NAME: test program (micro, rve, ...) or python
--fast leaves out Boost cases labelled "slow" and is what the sanitizer build runs.
--disturb N runs the test programs with every instruction set this processor has (TURGOR_SIMD), each of them undisturbed and with
the start of all scenes moved by round-off in N ways (TURGOR_DISTURB, see disturbance.cc). Nothing may fail: no test asks one chaotic
trajectory for an exact outcome.
"""
import argparse
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


def run_python(build):
    os.environ["TURGOR_BUILD"] = os.path.abspath(build)
    suite = unittest.TestSuite()
    for folder, _, files in sorted(os.walk(HERE)):
        for name in sorted(files):
            if name.startswith("test_") and name.endswith(".py"):
                sys.path.insert(0, folder)
                suite.addTests(unittest.defaultTestLoader.loadTestsFromName(name[:-3]))
    start = time.time()
    with open(os.devnull, "w") as nowhere:
        result = unittest.TextTestRunner(stream=nowhere).run(suite)
    bad = result.failures + result.errors
    passed = result.testsRun - len({test.id() for test, _ in bad}) - len(result.skipped)
    print(f"python: {passed} passed, {len(bad)} failed, {len(result.skipped)} skipped ({time.time() - start:.1f} s)", flush=True)
    for test, text in bad:
        print(f"{test.id()}\n{text}", flush=True)
    return max(passed, 0), len(bad)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True)
    parser.add_argument("--fast", action="store_true")
    parser.add_argument("--disturb", type=int, metavar="N")
    parser.add_argument("names", nargs="*")
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
