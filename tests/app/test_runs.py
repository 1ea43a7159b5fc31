"""inputs/studies/runs.py: a run of a script is taken again exactly where its entries, the bytes of the files it names and the program are the same."""
import os
import shutil
import sys
import tempfile
import unittest

PROGRAM = os.path.join(os.environ["TURGOR_BUILD"], "app", "turgor")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(SOURCE, "inputs", "studies"))
import runs  # noqa: E402

ENTRIES = {"First cells": 4, "Duration": 3600, "Samples": 10, "Frames": 0, "Contact/Local stiffness": "law.csv"}  # Duration: End time, by its former name


def another_build(program, place):
    """The same program with another build id, the note by which it knows itself."""
    with open(program, "rb") as file:
        content = bytearray(file.read())
    note = content.find(b"\x03\0\0\0GNU\0")
    if note < 0:
        raise unittest.SkipTest("the program was linked without a build id")
    content[note + 8] ^= 0xFF
    with open(place, "wb") as file:
        file.write(content)
    shutil.copymode(program, place)
    return place


class Runs(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = temporary.name
        for name, value in (("ROOT", self.root), ("PROGRAM", PROGRAM)):
            self.addCleanup(setattr, runs, name, getattr(runs, name))
            setattr(runs, name, value)
        os.mkdir(os.path.join(self.root, "inputs"))
        shutil.copy(os.path.join(SOURCE, "inputs", "spheroid_free.prm"), os.path.join(self.root, "inputs"))
        self.law("0.1,450\n0.3,4500\n")

    def law(self, rows):
        with open(os.path.join(self.root, "inputs", "law.csv"), "w", encoding="utf-8") as file:
            file.write("compression,modulus\n" + rows)

    def run_of(self, label="one", study="some", **more):
        """Where the run is and when its summary was written."""
        row = runs.study(study, [(label, "spheroid_free", {**ENTRIES, **more})])[label]
        self.assertEqual(row["status"], "finished", row["message"])
        self.assertGreaterEqual(len(runs.results(row)), 5)
        return row["directory"], os.stat(os.path.join(row["directory"], "summary.json")).st_mtime_ns

    def test_the_same_run_is_taken_again(self):
        first = self.run_of()
        self.assertEqual(self.run_of(), first)
        self.assertEqual(self.run_of(label="another", study="elsewhere"), first)
        self.assertEqual(self.run_of(Duration="3.6e3"), first)  # another spelling of the same number

    def test_other_entries_bytes_or_program_are_another_run(self):
        first = self.run_of()
        self.assertNotEqual(self.run_of(Duration=7200)[0], first[0])
        self.law("0.1,450\n0.3,4501\n")
        other = self.run_of()
        self.assertNotEqual(other[0], first[0])
        self.law("0.1,450\n0.3,4500\n")
        self.assertEqual(self.run_of(), first)
        runs.PROGRAM = another_build(PROGRAM, os.path.join(self.root, "turgor"))
        built = self.run_of()
        self.assertNotEqual(built[0], first[0])
        self.assertEqual(self.run_of(), built)
        runs.PROGRAM = PROGRAM
        self.assertEqual(self.run_of(), first)


if __name__ == "__main__":
    unittest.main()
