"""`turgor study` through the built program: exit codes, and what is refused before the first run."""
import csv
import os
import subprocess
import tempfile
import unittest

PROGRAM = os.path.join(os.environ["TURGOR_BUILD"], "app", "turgor")
INPUTS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "inputs")


class Study(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = temporary.name

    def study(self, code, text, *arguments):
        with open(os.path.join(self.directory, "s.prm"), "w", encoding="utf-8") as file:
            file.write(text)
        done = subprocess.run([PROGRAM, "study", "s.prm", *arguments], cwd=self.directory, capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_every_point_of_a_sweep_is_checked_before_the_first_run(self):
        said = self.study(2, f"set Input = {INPUTS}/wall_uniaxial.prm\nsubsection Run a\nend\n"
                             "subsection Run drop\nset Grid = Yield drop = 0.5 | x | 0.9 | 7\nend\n")
        self.assertIn("run 'drop x'", said)
        self.assertIn("run 'drop 7'", said)
        self.assertEqual(os.listdir(self.directory), ["s.prm"])

    def test_every_ready_made_study_is_accepted(self):
        for folder, _, files in os.walk(os.path.join(INPUTS, "studies")):
            for name in sorted(name for name in files if name.endswith(".prm")):
                with self.subTest(study=name):
                    done = subprocess.run([PROGRAM, "study", os.path.join(folder, name), "--list"], cwd=self.directory, capture_output=True, text=True)
                    self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_wrong_column_is_told_after_the_first_run_of_many(self):
        said = self.study(2, f"set Input = {INPUTS}/wall_uniaxial.prm\nsubsection Run drop\nset Grid = Yield drop = 0 | 0.5 | 0.9\nend\n"
                             "subsection Measure m\nset Result = largest_erorr\nset Reference = 0\nend\n")
        self.assertIn("Did you mean 'largest_error'?", said)
        self.assertEqual(said.count("Running"), 1)

    def test_a_wrong_name_to_draw_is_told_before_the_first_run(self):
        said = self.study(2, f"set Input = {INPUTS}/wall_uniaxial.prm\nset Draw = largest_eror\nsubsection Run drop\nset Grid = Yield drop = 0 | 0.5\nend\n")
        self.assertIn("Did you mean 'largest_error'?", said)
        self.assertEqual(said.count("Running"), 0)

    def test_what_only_some_runs_have_can_be_drawn(self):
        # the first of these never reaches 30 %
        self.study(0, f"set Input = {INPUTS}/cell_compression.prm\nset Draw = force_at_05 + force_at_30\n"
                      "set Overrides = Dimension=2; Cell/Radius=50e-6; Cell/Wall thickness=1e-6; Cell/Wall density=32500; Cell/Fluid=pressure; Frames=0; Speed=20\n"
                      "subsection Run to\nset Grid = Deformation = 0.06 | 0.31\nend\n")

    def test_a_study_of_errors_that_computes_none_fails(self):
        said = self.study(1, f"set Input = {INPUTS}/wall_uniaxial.prm\nset Reference = drop 0\n"
                             "subsection Run drop\nset Grid = Yield drop = 0\nend\n"
                             "subsection Measure m\nset Result = largest_error\nset Relative to = 1\nend\n")
        self.assertIn("no run could be compared", said)

    def test_errors_of_a_result_against_a_closed_form(self):
        self.study(0, f"set Input = {INPUTS}/wall_uniaxial.prm\nsubsection Run drop\nset Grid = Yield drop = 0 | 0.5\nend\n"
                      "subsection Measure m\nset Result = largest_error\nset Reference = 0\nset Relative to = 1\nend\n")
        with open(os.path.join(self.directory, "runs", "s", "error_vs_time.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["Yield drop"] for row in rows], ["0", "0.5"])
        for row in rows:
            self.assertEqual(row["m [1]"], row["error_m"])
            self.assertGreater(float(row["cpu_time_s"]), 0)

    def test_every_run_has_the_value_of_every_swept_entry_and_one_asked_for_twice_is_computed_once(self):
        said = self.study(0, f"set Input = {INPUTS}/wall_uniaxial.prm\nsubsection Run drop\nset Grid = Yield drop = 0.5 | 0.9\nend\n"
                             "subsection Run fine\nset Grid = Points = 11 | 21\nend\n"
                             "subsection Run again\nset Overrides = Yield drop = 0.9\nend\n"
                             "subsection Measure m\nset Result = largest_error\nend\n")
        self.assertIn("again is there already: it is the run drop 0.9.", said)
        self.assertNotIn("Running again", said)
        with open(os.path.join(self.directory, "runs", "s", "results.csv"), newline="", encoding="utf-8") as file:
            rows = {row["run"]: row for row in csv.DictReader(file)}
        self.assertTrue(all(row["Yield drop"] and row["Points"] for row in rows.values()), rows)
        self.assertEqual(rows["again"]["Yield drop"], rows["drop 0.9"]["Yield drop"])
        self.assertEqual(rows["again"]["directory"], rows["drop 0.9"]["directory"])

    def test_own_measurements_are_compared_in_their_own_units_and_a_value_is_named_by_what_it_is(self):
        cell = "Dimension=2; Cell/Radius=50e-6; Cell/Wall thickness=1e-6; Cell/Wall density=32500; Cell/Fluid=pressure; Frames=0; Speed=20; Deformation=0.06"
        text = (f"set Input = {INPUTS}/cell_compression.prm\nset Overrides = {cell}\nsubsection Run a\nend\n"
                "subsection Measure force\nset Table = force\nset Columns = force_lower\nset Reference = FILE\nend\n")
        errors = {}
        for name, header, scale in (("si.csv", "time [s],force_lower [N]", (1, 1)), ("mine.csv", "time [us],force_lower [mN]", (1e6, 1e3)),
                                    ("wrong.csv", "time [s],force_lower [mPa]", (1, 1))):
            with open(os.path.join(self.directory, name), "w", encoding="utf-8") as file:
                file.write(header + "\n" + "".join(f"{x * scale[0]!r},{(1 + x) * scale[1]!r}\n" for x in (0.0, 3e-7)))
            said = self.study(2 if name == "wrong.csv" else 0, text.replace("FILE", name), "--fresh")
            if name == "wrong.csv":
                self.assertIn("'force_lower' has the unit [mPa]", said)
                self.assertIn("the unit [N]", said)
                self.assertNotIn("Running", said)
                continue
            with open(os.path.join(self.directory, "runs", "s", "error_vs_time.csv"), newline="", encoding="utf-8") as file:
                row = next(csv.DictReader(file))
            self.assertIn("force_rms [N]", row)
            errors[name] = float(row["error_force"])
        self.assertAlmostEqual(errors["mine.csv"], errors["si.csv"], places=5)

    def test_everything_is_below_the_chosen_directory_and_told_from_the_table(self):
        text = f"set Input = {INPUTS}/wall_uniaxial.prm\nsubsection Run a\nend\n"
        for arguments, place in ((["-o", "chosen"], "chosen"), (["-o", os.path.join(self.directory, "deep", "chosen")], "deep/chosen"), ([], "runs/s")):
            self.study(0, text, *arguments)
            with open(os.path.join(self.directory, place, "results.csv"), newline="", encoding="utf-8") as file:
                told = next(csv.DictReader(file))["directory"]
            self.assertFalse(os.path.isabs(told))
            self.assertTrue(os.path.exists(os.path.join(self.directory, place, told, "summary.json")), told)
            self.assertEqual(told.startswith("cache" + os.sep), bool(arguments), told)
            self.assertEqual(os.path.exists(os.path.join(self.directory, "runs")), not arguments)


if __name__ == "__main__":
    unittest.main()
