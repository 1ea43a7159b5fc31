"""Whole small scenes against stored numbers: NAME.prm is run, its results and tables are compared with NAME.json.

One for every scene of `turgor list`. After a change that is meant to change numbers, all or some are written anew by
    TURGOR_BUILD=build python3 tests/golden/test_golden.py --write [NAME...]
and the difference belongs into the commit of that change, with the reason.

A value may differ by ten times what round-off at the start makes of it: the writer runs every scene five times with its start disturbed
by 1e-15 (the program turgor_disturbed, tests/disturbance.cc), with every instruction set of the machine, and stores ten times the largest
difference of a column, at least 1e-8 of its largest value (Newton's method and the like end within a tolerance). What then would be
allowed to differ by more than a thousandth of itself is noise, chaos or a clock: it is left out, and the writer says so. Of a long table
a dozen rows are kept.

Beside the numbers: a run writes everything that its scene defines (`turgor parameters`), but for what is said to be written at times only.
"""
import argparse
import csv
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from defined_outputs import defined_outputs, stands_for  # noqa: E402
from run_all import instruction_sets  # noqa: E402

BUILD = os.path.abspath(os.environ["TURGOR_BUILD"])
PROGRAM, DISTURBED = os.path.join(BUILD, "app", "turgor"), os.path.join(BUILD, "tests", "turgor_disturbed")
NAMES = sorted(name[:-4] for name in os.listdir(HERE) if name.endswith(".prm"))
ROWS, SEEDS, FACTOR, FLOOR, LARGEST = 12, 5, 10., 1e-8, 1e-3


def scene_of(name):
    """A file is named after its scene, or, where a scene has several, says it as every input does."""
    with open(os.path.join(HERE, name + ".prm"), encoding="utf-8") as file:
        return re.search(r"^set Scenario *= *(\S+)", file.read(), re.M)[1]


def measured(name, program=PROGRAM, **environment):
    """What today's program makes of a scene: its terms and fields, columns of numbers by (file, name), and all that it wrote, as (file, "name [unit]")."""
    with tempfile.TemporaryDirectory() as directory:
        done = subprocess.run([program, "run", os.path.join(HERE, name + ".prm"), "-o", directory, "--quiet", "--threads", "1"],
                              capture_output=True, text=True, timeout=600, stdin=subprocess.DEVNULL, env={**os.environ, **environment})
        if done.returncode != 0:
            raise RuntimeError(f"{name}: {done.stdout}{done.stderr}")
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        columns = {("results", key): [float(entry["value"])] for key, entry in summary["results"].items()}
        written = {("summary.json", f"{key} [{entry['unit']}]" if entry["unit"] else key) for key, entry in summary["results"].items()}
        for fields in os.listdir(directory):
            if fields.endswith(".xdmf"):
                with open(os.path.join(directory, fields), encoding="utf-8") as file:
                    written |= {(fields, name) for name in re.findall('Attribute Name="([^"]*)"', file.read())}
        for table in sorted(os.listdir(directory)):
            if table.endswith(".csv"):
                with open(os.path.join(directory, table), newline="", encoding="utf-8") as file:
                    header, *rows = csv.reader(file)
                count = min(ROWS, len(rows))
                kept = [rows[k * (len(rows) - 1) // max(count - 1, 1)] for k in range(count)]
                columns[table, "rows"] = [float(len(rows))]
                written |= {(table, column) for column in header}
                for k, column in enumerate(header):
                    try:
                        columns[table, column] = [float(row[k]) for row in kept]
                    except ValueError:
                        pass  # words
    return {"active_terms": summary["active_terms"], "fields": summary["fields"]}, columns, written


def golden_file(name):
    return os.path.join(HERE, name + ".json")


class Golden(unittest.TestCase):
    maxDiff = None

    def compare(self, name, **environment):
        with open(golden_file(name), encoding="utf-8") as file:
            golden = json.load(file)
        made_of, found, written = measured(name, **environment)
        self.assertEqual(made_of, {key: golden[key] for key in made_of})
        wrong = []
        for source, columns in golden["columns"].items():
            for column, stored in columns.items():
                now = found.get((source, column), [])
                if len(now) != len(stored["values"]):
                    wrong.append(f"{source}, {column}: {len(now)} values, {len(stored['values'])} in the golden file")
                    continue
                wrong += [f"{source}, {column}, row {row}: {is_now!r}, golden {was!r} +- {stored['tolerance']!r}"
                          for row, (is_now, was) in enumerate(zip(now, stored["values"]), 1)
                          if not abs(is_now - was) <= stored["tolerance"]][:1]
        never = [(file, defined) for file, defined, always in defined_outputs(PROGRAM, scene_of(name))
                 if always and not any(place == file and stands_for(defined, one) for place, one in written)]
        self.assertEqual(never, [], f"{name} defines these and does not write them")
        self.assertEqual(wrong, [], f"{name}; if that is meant: " + __doc__.splitlines()[3].strip())

    def test_every_scene_has_one(self):
        listed = subprocess.run([PROGRAM, "list"], capture_output=True, text=True, check=True, timeout=60).stdout
        self.assertEqual(sorted(line for line in listed.splitlines() if line and not line.startswith(" ")), sorted({scene_of(name) for name in NAMES}))


for one in NAMES:
    setattr(Golden, f"test_{one}", lambda self, name=one: self.compare(name))
for one in ("full_micro", "laplace"):  # sweeps without intrinsics, in 2D and 3D
    setattr(Golden, f"test_{one}_portable", lambda self, name=one: self.compare(name, TURGOR_SIMD="portable"))


def write(name):
    made_of, columns, _ = measured(name)
    _, again, _ = measured(name)
    _, undisturbed, _ = measured(name, DISTURBED, TURGOR_DISTURB="0")
    if any(again.get(key) == values != undisturbed.get(key) for key, values in columns.items()):
        raise SystemExit(f"{name}: the disturbed program, not disturbed, has other numbers; it is of another build: ninja turgor_tests.")
    spread = {key: 0. for key in columns}
    for simd in instruction_sets():
        for seed in range(SEEDS + 1):
            _, other, _ = measured(name, DISTURBED, TURGOR_SIMD=simd, TURGOR_DISTURB=str(seed))
            for key, values in columns.items():
                again = other.get(key, [])
                apart = max((abs(a - b) for a, b in zip(values, again)), default=0.) if len(again) == len(values) else math.inf
                spread[key] = max(spread[key], apart)
    kept, left_out = {}, []
    for (source, column), values in columns.items():
        size = max((abs(value) for value in values), default=0.)
        tolerance = max(FACTOR * spread[source, column], FLOOR * size)
        if tolerance <= LARGEST * size or tolerance == 0.:
            kept.setdefault(source, {})[column] = {"tolerance": float(f"{tolerance:.2g}"), "values": [float(f"{v:.12g}") for v in values]}
        else:
            left_out.append(f"{source}/{column}")
    if not kept:
        raise SystemExit(f"{name}: nothing of it is reproducible; make the scene shorter.")
    with open(golden_file(name), "w", encoding="utf-8") as file:
        entries = ",\n".join(f'  {json.dumps(source)}: {{\n' + ",\n".join(f'   {json.dumps(column)}: {json.dumps(stored)}'
                                                                         for column, stored in of.items()) + "\n  }"
                             for source, of in kept.items())
        made = ",\n".join(f' {json.dumps(key)}: {json.dumps(value)}' for key, value in made_of.items())
        file.write(f'{{\n{made},\n "columns": {{\n{entries}\n }}\n}}\n')
    print(f"{name}: {sum(len(of) for of in kept.values())} columns"
          + (", left out: " + ", ".join(left_out) if left_out else ""), flush=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", nargs="*", metavar="NAME", choices=NAMES)
    options = parser.parse_args()
    if options.write is None:
        unittest.main(argv=sys.argv[:1])
    for scene in options.write or NAMES:
        write(scene)
