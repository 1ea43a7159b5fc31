"""`turgor validate` through the built program: exit codes, where it writes, what it leaves alone."""
import csv
import json
import os
import subprocess
import tempfile
import unittest

PROGRAM = os.path.join(os.environ["TURGOR_BUILD"], "app", "turgor")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class Validate(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = temporary.name
        os.makedirs(os.path.join(self.directory, "inputs", "validation"))

    def validate(self, code, *arguments, most=1e-6, result="largest_error", overrides=()):
        run = {"input": os.path.join(SOURCE, "inputs", "wall_uniaxial.prm"), "overrides": list(overrides)}
        rows = [{"quantity": "error of a wall", "source": "Eq. 3.8", "result": result, "most": most}]
        with open(os.path.join(self.directory, "inputs", "validation", "wall.json"), "w", encoding="utf-8") as file:
            json.dump({"runs": {"": run}, "rows": rows}, file)
        done = subprocess.run([PROGRAM, "validate", "--root", ".", *arguments], cwd=self.directory, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def text(self, *path):
        with open(os.path.join(self.directory, *path), encoding="utf-8") as file:
            return file.read()

    def test_exit_codes_of_rows(self):
        self.assertIn("met: error of a wall", self.validate(0))
        self.assertIn("missed: error of a wall", self.validate(1, most=1e-300))
        self.assertIn("| **missed** |", self.text("runs", "validation", "validation.md"))
        self.assertIn("is no result of", self.validate(1, result="no_such_result"))
        self.assertIn(",failed", self.text("runs", "validation", "validation.csv"))
        self.assertIn("there is no entry 'Yeild drop'", self.validate(2, overrides=["Yeild drop=0"]))

    def test_the_source_changes_only_when_asked_to(self):
        os.makedirs(os.path.join(self.directory, "doc"))
        document = "# Ours\n\n<!-- turgor validate: begin -->\n<!-- turgor validate: end -->\n\nText.\n"
        with open(os.path.join(self.directory, "doc", "validation.md"), "w", encoding="utf-8") as file:
            file.write(document)
        self.validate(0, "-o", "here")
        self.assertEqual(self.text("doc", "validation.md"), document)
        self.assertFalse(os.path.exists(os.path.join(self.directory, "doc", "results")))
        self.assertIn("error of a wall", self.text("here", "validation.md"))
        self.assertFalse(os.path.exists(os.path.join(self.directory, "runs")))  # the runs are in here/cache
        self.validate(0, "-o", "here", "--update-doc")
        self.assertIn("| met |", self.text("doc", "validation.md"))
        with open(os.path.join(self.directory, "doc", "results", "validation.csv"), encoding="utf-8") as file:
            row = list(csv.DictReader(file))[0]
        self.assertIn(f"Computed by {row['program']} on {row['date']}: 1 row (wall).", self.text("doc", "validation.md"))
        self.assertRegex(row["program"] + " " + row["date"], r"^\S.* \w+ 2\d{3}-\d\d-\d\d$")
        self.assertTrue(self.text("doc", "validation.md").endswith("\n\nText.\n"))
        # A row that was met in the source and no longer is, is told.
        self.assertIn("in the source's table it is met", self.validate(1, "-o", "here", most=1e-300))

    def test_files_of_a_user_stay(self):
        for name, text in (("validation.csv", "time,mine\n1,2\n"), ("validation.md", "# My own notes\n")):
            directory = os.path.join(self.directory, name + ".d")
            os.mkdir(directory)
            with open(os.path.join(directory, name), "w", encoding="utf-8") as file:
                file.write(text)
            self.assertIn("it is not overwritten", self.validate(2, "-o", directory))
            self.assertEqual(self.text(name + ".d", name), text)


if __name__ == "__main__":
    unittest.main()
