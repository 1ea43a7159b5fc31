"""Whole small scenes against stored numbers: NAME.prm is run and its tables are compared with NAME.json.

After a change that is meant to change numbers, all or some are written anew by
    TURGOR_BUILD=build python3 tests/golden/test_golden.py --regenerate [NAME...]
and the difference belongs into the commit of that change, with the reason.

Two values agree within a share of the largest golden value of their unit in their table (displacement_x is compared
with the size of displacement, not with itself: where symmetry makes it small, it is rounding).

  hydrostatic scenes  1e-9. One order of arithmetic on every machine; RVE/Tolerance = 1e-12 in the inputs, so that an
                      iteration more or less, where rounding decides about it, is below that too.
  SPH scenes          1e-8. The sweeps sum in another order on AVX2 than on AVX-512, and particles make much of little.
                      Both sets are run where the machine has both. Compared is what is a sum over many particles or
                      belongs to the walls: over so few steps, and with an annealing that ends at rest, these differ
                      by up to 1e-10 between the sets, and by 1e-5 for a viscosity changed by 1e-4 (both measured
                      when this was written). Single fluid particles and counts of list builds are left out.
  spheroids           1e-6. One order of arithmetic on every machine, but a hundred cells that touch and let go make much of little.
"""
import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
PROGRAM = os.path.join(os.path.abspath(os.environ["TURGOR_BUILD"]), "app", "turgor")

# Scene -> tolerance, instruction sets, tables with the columns that count (None: all).
STRESS = ["sigma_xx", "sigma_xy", "sigma_yx", "sigma_yy", "P_xx", "P_xy", "P_yx", "P_yy", "pressure", "energy"]
CASES = {
    "rve_response": (1e-9, [None], {"stress.csv": STRESS}),
    "tissue_gravity": (1e-9, [None], {"probe.csv": None, "energies.csv": None, "cell_displacement.csv": None}),
    "full_micro": (1e-8, [None, "avx2", "portable"], {"probe.csv": None, "cell_displacement.csv": None,
                                          "energy.csv": ["time", "potential", "kinetic", "dissipated", "mean_pressure"]}),
    "spheroid_capsule": (1e-6, [None], {"growth.csv": None}),
}


def measured(name, instruction_set=None):
    """What the golden file of a scene holds, from a run of today's program."""
    environment = dict(os.environ)
    if instruction_set:
        environment["TURGOR_SIMD"] = instruction_set
    found = {}
    with tempfile.TemporaryDirectory() as directory:
        done = subprocess.run([PROGRAM, "run", os.path.join(HERE, name + ".prm"), "-o", directory, "--quiet"],
                              capture_output=True, text=True, timeout=600, stdin=subprocess.DEVNULL, env=environment)
        if done.returncode != 0:
            raise RuntimeError(f"{name}: {done.stdout}{done.stderr}")
        for table, wanted in CASES[name][2].items():
            with open(os.path.join(directory, table), newline="", encoding="utf-8") as file:
                header, *rows = csv.reader(file)
            found[table] = {column: [float(row[k]) for row in rows] for k, column in enumerate(header)
                            if wanted is None or column.split(" [")[0] in wanted}
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        found["active_terms"], found["fields"] = summary["active_terms"], summary["fields"]
    return found


def golden_file(name):
    return os.path.join(HERE, name + ".json")


class Golden(unittest.TestCase):
    def compare(self, name, instruction_set):
        tolerance, _, tables = CASES[name]
        with open(golden_file(name), encoding="utf-8") as file:
            golden = json.load(file)
        found = measured(name, instruction_set)
        for words in ("active_terms", "fields"):
            self.assertEqual(found[words], golden[words])
        for table in tables:
            self.assertEqual(list(found[table]), list(golden[table]), table)
            scale = {}
            for column, values in golden[table].items():
                unit = column.split(" [")[-1]
                scale[unit] = max([scale.get(unit, 0.)] + [abs(value) for value in values])
            for column, values in golden[table].items():
                self.assertEqual(len(found[table][column]), len(values), f"rows of {table}")
                for row, (is_now, was) in enumerate(zip(found[table][column], values)):
                    self.assertLessEqual(abs(is_now - was), tolerance * scale[column.split(" [")[-1]],
                                         f"{name}, {table}, {column}, row {row + 1}: {is_now!r}, golden {was!r}; if that "
                                         "is meant: " + __doc__.splitlines()[3].strip())


def add(name, instruction_set):
    setattr(Golden, f"test_{name}_{instruction_set or 'own_instruction_set'}",
            lambda self: self.compare(name, instruction_set))


for scene, (_, instruction_sets, _) in CASES.items():
    for one in instruction_sets:
        add(scene, one)


def regenerate(names):
    for name in names or CASES:
        with open(golden_file(name), "w", encoding="utf-8") as file:
            json.dump(measured(name), file, indent=1)
            file.write("\n")
        print("written: " + os.path.relpath(golden_file(name)))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--regenerate", nargs="*", metavar="NAME", choices=list(CASES))
    options = parser.parse_args()
    if options.regenerate is None:
        unittest.main(argv=sys.argv[:1])
    regenerate(options.regenerate)
