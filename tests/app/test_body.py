"""A rigid body among centre-based cells (spheroid_free, subsection Body) against closed forms, and what is refused of it."""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

BUILD = os.environ["TURGOR_BUILD"]
PROGRAM = os.path.join(BUILD, "app", "turgor")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(SOURCE, "app", "plots"))
from fields import frames  # noqa: E402

BLOCK = os.path.join(SOURCE, "inputs", "reference", "block.off")  # 20 um high, flat below
RADIUS, MODULUS, FRICTION = 6e-6, 450.0, 5e8
# One cell that hardly grows (2e-4 of its radius in a run), at the origin; the block above it, pulled down.
ALONE = ["First cells=1", "Cell/Cycle time=1e8", "Motion/Growth tolerance=1e-6", "Cell/Bulk modulus=1e12", "Cell/Variability=0", "Motion/Motility=0", f"Cell/Modulus={MODULUS}",
         f"Cell/Birth radius={RADIUS}", f"Contact/Medium friction={FRICTION}", "Cell/Poisson ratio=0.3", "Samples=100", "Frames=1",
         f"Body/File={BLOCK}", "Body/Motion=drag"]


class Body(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.out = os.path.join(self.temporary.name, "out")

    def tearDown(self):
        self.temporary.cleanup()

    def run_program(self, *values):
        command = [PROGRAM, "run", os.path.join(SOURCE, "inputs", "spheroid_free.prm"), "-o", self.out, "--quiet", "--threads", "1"]
        for value in values:
            command += ["--set", value]
        return subprocess.run(command, capture_output=True, text=True, timeout=300, stdin=subprocess.DEVNULL)

    def table(self):
        with open(os.path.join(self.out, "growth.csv"), newline="", encoding="utf-8") as file:
            return [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def test_alone_it_falls_at_load_over_drag(self):
        done = self.run_program(*ALONE, "Body/Position=0, 0, 1", "Body/Load=0, 3e-9, -4e-9", "Body/Drag=2", "End time=1000")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.out, "summary.json"), encoding="utf-8") as file:
            travel = json.load(file)["results"]["body_travel"]["value"]
        self.assertAlmostEqual(travel / (5e-9 / 2 * 1000), 1.0, delta=1e-6)  # the place is known to 1e-16 m

    def test_a_cell_before_it_is_pressed_by_hertz_and_both_go_on_together(self):
        """v = F/(drag + gamma), between them gamma v, the overlap of Hertz with a plane."""
        load, drag = 1e-10, 0.5
        done = self.run_program(*ALONE, "Body/Position=0, 0, 17e-6", f"Body/Load=0, 0, {-load}", f"Body/Drag={drag}", "Body/Modulus=2000",
                                "Body/Poisson ratio=0.4", "End time=60000")
        self.assertEqual(done.returncode, 0, done.stderr)
        last, before = self.table()[-1], self.table()[-11]
        cell = frames(self.out, "cells")[-1]
        radius = cell.field("radius")[0]
        gamma = 4 * math.pi * radius**2 * FRICTION
        speed = load / (drag + gamma)
        self.assertEqual(last["cells_on_body"], 1)
        self.assertAlmostEqual((before["body_z"] - last["body_z"]) / (last["time"] - before["time"]) / speed, 1, delta=1e-2)  # 0.33 %
        self.assertAlmostEqual(last["body_pressing"] / (gamma * speed), 1, delta=3e-2)  # 1.5 %
        reduced = 1 / ((1 - 0.3**2) / MODULUS + (1 - 0.4**2) / 2000)
        overlap = radius - (last["body_z"] - 10e-6 - cell.points[0][2])
        self.assertAlmostEqual(4 / 3 * reduced * math.sqrt(radius) * overlap**1.5 / last["body_pressing"], 1, delta=1e-3)
        self.assertLess(last["body_imbalance"], 1e-12)

    def test_what_rubs_much_goes_along(self):
        """The block leans on the cell and is pulled aside: with much friction they travel as one, v = F/(drag + gamma), however much it is."""
        load, drag, end = 1e-10, 0.5, 6000
        gamma = 4 * math.pi * RADIUS**2 * FRICTION
        for friction in (1e13, 1e15, 1e17):
            self.tearDown()
            self.setUp()
            done = self.run_program(*ALONE, "Body/Position=0, 0, 15.5e-6", f"Body/Load={load}, 0, {-load}", f"Body/Drag={drag}", f"Body/Friction={friction}",
                                    f"End time={end}")
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = self.table()
            self.assertAlmostEqual((rows[-1]["body_x"] - rows[0]["body_x"]) / (load / (drag + gamma) * end), 1, delta=3e-3, msg=str(friction))

    def test_little_drag_against_turning(self):
        """It turns at once to where no moment acts, by any method of motion."""
        for method, turning in (("implicit", 1.95e-14), ("euler", 1e-12), ("heun", 3.84e-11)):
            self.tearDown()
            self.setUp()
            done = self.run_program("First cells=6", f"Body/File={BLOCK}", "Body/Motion=drag", "Body/Position=3e-6, 0, 27e-6", "Body/Load=0, 0, -1e-8", "Body/Friction=0",
                                    "Frames=0", "End time=20000", f"Motion/Method={method}", f"Body/Turning drag={turning}")
            self.assertEqual(done.returncode, 0, f"{method} {turning}: {done.stderr}")

    def test_what_drives_the_cells_too_far_is_named(self):
        done = self.run_program(*ALONE, "Motion/Growth tolerance=2e-3", "Body/Position=0, 0, 17e-6", "Body/Load=0, 0, -4e-6", "Body/Drag=1000", "End time=1.3e7")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("Use less that drives the cells (Body/Load), more friction", done.stderr)

    def test_what_is_refused(self):
        for values, words in ((["Body/Position=0, 0, 12e-6"], ["Body/Position is 0, 0, 12e-6", "in the body or deep in its surface", "Body/Unit"]),
                              (["Body/Unit=1e-3"], ["would be in the body"]),
                              (["Body/Unit=1e-9"], ["Body/Unit is 1e-09 m", "less than a tenth of a cell's radius", "at least 6e-07 m"]),
                              (["Body/Load=0, 0, -1e-3"], ["Body/Load over Body/Drag moves the body by", "Body/Load of at most", "End time of at most"]),
                              (["Body/Turning drag=1e-30"], ["Body/Turning drag is 1e-30 N m s", "Use at least 1.92e-14 N m s"]),
                              (["Body/File=no_such.off"], ["no_such.off"])):
            done = self.run_program(*ALONE, "Body/Position=0, 0, 17e-6", *values) if "Position" not in values[0] else self.run_program(*ALONE, *values)
            self.assertEqual(done.returncode, 2, done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)


if __name__ == "__main__":
    unittest.main()
