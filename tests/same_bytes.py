#!/usr/bin/python3
"""Whether another commit's program writes the same bytes: every golden scene and the variants below, each with both programs, all CSV (but for
clocks) and the numbers of all fields compared. For work that is not meant to change any number (moves, splits, one routine in place of two):

    /usr/bin/python3 tests/same_bytes.py main~1            builds that commit beside this one (some minutes the first time)
    /usr/bin/python3 tests/same_bytes.py --program FILE    a program that is there

What differs is told with its size: the largest difference of a column over the column's largest value. The last line is "N the same, N different".
"""
import argparse
import concurrent.futures
import csv
import os
import subprocess
import sys
import tempfile

import h5py

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
GOLDEN = os.path.join(SOURCE, "tests", "golden")

# Beside the golden scenes as they are: what other branches of the same code do.
VARIANTS = {
    "tissue_gravity": [["RVE/Fluid=sph", "RVE/Rule=constrained_runs"], ["RVE/Fluid=sph", "RVE/Rule=cauchy_born"], ["Time/Integrator=dormand_prince"]],
    "rve_response": [["RVE/Fluid=sph", "RVE/Tolerance=1e-3"], ["RVE/Rule=cauchy_born"]],
    "tissue_impact": [["Cell/Fluid viscosity=1"], ["Substeps=4"], ["Gap=20e-6"], ["Sides=periodic", "Structure/Gap=20e-6", "Gap=0"]],
    "tissue_failure": [["Cell/Fluid viscosity=1"]],
    "cell_impact": [["Cell/Fluid=thesis"], ["Cell/Fluid viscosity=1"], ["Dimension=2"]],
    "cell_compression": [["Cell/Fluid=sph"], ["Dimension=2"], ["Dimension=2", "Cell/Yield drop=0.9"]],
    "spheroid_free": [["Motion/Method=euler"], ["Motion/Method=heun"], ["Motion/Method=implicit"]],
    "spheroid_capsule": [["Motion/Method=heun"]],
}


def program_of(commit, place):
    """Builds the program of a commit in a directory that is kept (below build/), so that it is built once."""
    name = subprocess.run(["git", "rev-parse", "--short", commit], cwd=SOURCE, check=True, capture_output=True, text=True).stdout.strip()
    tree = os.path.join(place, name)
    if not os.path.isdir(tree):
        subprocess.run(["git", "worktree", "add", "--detach", tree, commit], cwd=SOURCE, check=True)
    build = os.path.join(tree, "build")
    subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "-C", build, "app/all"], check=True, stdout=subprocess.DEVNULL)
    return os.path.join(build, "app", "turgor")


def run(program, name, overrides, directory):
    """"" or what the program said when it did not finish."""
    command = [program, "run", os.path.join(GOLDEN, name + ".prm"), "-o", directory, "--quiet", "--threads", "1"]
    for override in overrides:
        command += ["--set", override]
    done = subprocess.run(command, capture_output=True, text=True, timeout=1200, stdin=subprocess.DEVNULL)
    return "" if done.returncode == 0 else f"code {done.returncode}: {done.stderr.strip().splitlines()[0] if done.stderr.strip() else ''}"


def tables(directory):
    return sorted(name for name in os.listdir(directory) if name.endswith(".csv")) if os.path.isdir(directory) else []


def frames(directory):
    """{file/dataset: bytes} of all fields: HDF5 files themselves carry times of their making."""
    found = {}
    for place, _, names in os.walk(directory):
        for name in names:
            if name.endswith(".h5"):
                path = os.path.join(place, name)
                with h5py.File(path, "r") as file:
                    for key in file:
                        found[os.path.relpath(path, directory) + ":" + key] = file[key][()].tobytes()
    return found


def numbers_of(path):
    """Header and columns of a table, as text, but for those of a clock."""
    with open(path, newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    return {name: [row[k] for row in rows] for k, name in enumerate(header) if "cpu_time" not in name and "wall_time" not in name}


def difference(a, b):
    """"" or how two tables differ: the worst column by its largest difference over its largest value."""
    a, b = numbers_of(a), numbers_of(b)
    if a == b:
        return ""
    if list(a) != list(b) or len(next(iter(a.values()))) != len(next(iter(b.values()))):
        return "other columns" if list(a) != list(b) else "other rows"
    worst = (0.0, "a column of words")
    for name in a:
        try:
            x, y = [float(value) for value in a[name]], [float(value) for value in b[name]]
        except ValueError:
            continue
        worst = max(worst, (max(abs(p - q) for p, q in zip(x, y)) / (max(map(abs, x)) or 1.0), name))
    return f"{worst[1]} by {worst[0]:.1e} of its largest value"


def compare(one):
    programs, name, overrides = one
    with tempfile.TemporaryDirectory() as place:
        ours, theirs = os.path.join(place, "ours"), os.path.join(place, "theirs")
        said = [run(program, name, overrides, directory) for program, directory in zip(programs, (ours, theirs))]
        if said[0] and said[0] == said[1]:
            return [f"tests nothing, ends with {said[0]}"]
        if said[0] != said[1]:
            return [f"ends with '{said[0] or 'finished'}' here, '{said[1] or 'finished'}' there"]
        if tables(ours) != tables(theirs):
            return [f"other tables: {', '.join(tables(ours))} against {', '.join(tables(theirs))}"]
        found = {table: difference(os.path.join(ours, table), os.path.join(theirs, table)) for table in tables(ours)}
        different = [f"{table}: {how}" for table, how in found.items() if how]
        here, there = frames(ours), frames(theirs)
        return different + [f"{name}: other numbers" for name in sorted(here.keys() | there.keys()) if here.get(name) != there.get(name)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commit", nargs="?")
    parser.add_argument("--program", help="the other program, in place of a commit")
    parser.add_argument("--mine", default=os.path.join(SOURCE, "build", "app", "turgor"))
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    if bool(options.commit) == bool(options.program):
        parser.error("give a commit or --program FILE")
    other = options.program or program_of(options.commit, os.path.join(SOURCE, "build", "other_commits"))
    names = sorted(name[:-4] for name in os.listdir(GOLDEN) if name.endswith(".prm"))
    cases = [(name, overrides) for name in names for overrides in [[]] + VARIANTS.get(name, [])]
    count = {True: 0, False: 0}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for (name, overrides), found in zip(cases, pool.map(compare, [((options.mine, other), *case) for case in cases])):
            count[not found] += 1
            print(f"{'same     ' if not found else 'DIFFERENT'} {name} {' '.join(overrides)}" + "".join(f"\n    {line}" for line in found), flush=True)
    print(f"{count[True]} the same, {count[False]} different")
    return 1 if count[False] else 0


if __name__ == "__main__":
    sys.exit(main())
