"""Through the built program: a finished run goes on to a later end with the bits of the longer run, and what only says what is written changes no state."""
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.join(os.environ["TURGOR_BUILD"], "app", "turgor")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(SOURCE, "inputs", "studies"))

FE2 = ["tissue_gravity", "Time/Output interval=2e-6"]
SPHEROID = ["spheroid_free", "Checkpoints=3", "Frames=4", "First cells=10", "Most cells=0"]
FULL = ["full_micro", "Columns=2", "Rows=2", "End time=1e-6"]
# What a run measures about itself, not about its scene.
COSTS = ("cpu", "wall", "rve_share", "step_loop")


class Identity(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.directory = self.temporary.name

    def turgor(self, scene, place, *values, resume=False):
        command = [PROGRAM, "run", os.path.join(SOURCE, "inputs", scene[0] + ".prm"), "-o", place, "--quiet"]
        for value in (*scene[1:], *values):
            command += ["--set", value]
        return subprocess.run(command + (["--resume"] if resume else []), cwd=self.directory, capture_output=True, text=True,
                              timeout=300, stdin=subprocess.DEVNULL)

    def run_scene(self, *arguments, **options):
        done = self.turgor(*arguments, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def results(self, place):
        with open(os.path.join(self.directory, place, "summary.json"), encoding="utf-8") as file:
            results = json.load(file)["results"]
        return {name: entry["value"] for name, entry in results.items() if not any(part in name for part in COSTS)}

    def rows(self, place, table):
        with open(os.path.join(self.directory, place, table), encoding="utf-8") as file:
            return list(csv.reader(file))

    def goes_on(self, scene, table, ends, between=()):
        """Ended at each of `ends`, the last of them the bits of a run that had it from the start."""
        self.run_scene(scene, "whole", *ends[-1])
        self.run_scene(scene, "parts", *ends[0])
        for end in ends[1:]:
            self.run_scene(scene, "parts", *end, *between, resume=True)
        self.assertEqual(self.rows("parts", table), self.rows("whole", table))
        self.assertEqual(self.results("parts"), self.results("whole"))

    def test_tissue_goes_on(self):
        """From an end on a whole Output interval, and from one between two."""
        self.goes_on(FE2, "probe.csv", [[f"Time/End time={end}"] for end in ("4e-6", "5e-6", "9e-6")], ["Time/Checkpoint interval=0"])

    def test_tissue_of_an_end_within_a_step_goes_on_from_before_it(self):
        """The step that was cut for the end is no part of a longer run, however often the state was saved."""
        self.goes_on(FE2, "energies.csv", [[f"Time/End time={end}"] for end in ("3.07e-6", "3.08e-6", "5e-6", "6.5e-6")], ["Time/Checkpoint interval=0"])

    def test_tissue_by_steps_of_error_control_goes_on(self):
        self.goes_on(FE2 + ["Time/Integrator=dormand_prince"], "probe.csv", [[f"Time/End time={end}"] for end in ("3.07e-6", "4.5e-6")])

    def test_spheroid_goes_on(self):
        self.goes_on(SPHEROID, "growth.csv", [["End time=36000", "Samples=10"], ["End time=72000", "Samples=20"]])
        done = self.turgor(SPHEROID, "parts", "End time=144000", "Samples=20", resume=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("End time and Samples give a row of growth.csv every", done.stderr)

    def test_entries_that_change_no_state(self):
        """As marked in `turgor parameters`."""
        for scene, table, less, more in (
                (FE2 + ["Time/End time=3e-6"], "probe.csv", ["Time/Checkpoint interval=0"], []),
                (SPHEROID + ["End time=36000", "Samples=10"], "growth.csv", ["Checkpoints=0", "Frames=0"], ["Checkpoints=5", "Frames=7"]),
                (FULL, "cell_displacement.csv", ["Checkpoints=0", "Frames=0", "Samples=7"], ["Checkpoints=5", "Frames=3"])):
            with self.subTest(scene[0]):
                self.run_scene(scene, scene[0] + "_less", *less)
                self.run_scene(scene, scene[0] + "_more", *more)
                self.assertEqual(self.rows(scene[0] + "_less", table), self.rows(scene[0] + "_more", table))
                self.assertEqual(self.results(scene[0] + "_less"), self.results(scene[0] + "_more"))


if __name__ == "__main__":
    unittest.main()
