"""A copy of the program takes the module of the scenes with finite elements from beside its own folder: one from another build, or none,
is told in a sentence that says what to do; scenes of particles need none."""
import os
import shutil
import subprocess
import tempfile
import unittest

BUILD = os.environ["TURGOR_BUILD"]
APP = os.path.join(BUILD, "app")
ADVICE = "Copy turgor and turgor_tissue.so together into a folder 'app', both from one build, or build the program again."


class ModuleBeside(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        self.app = os.path.join(self.directory.name, "app")
        os.mkdir(self.app)
        self.module = os.path.join(self.app, "turgor_tissue.so")
        shutil.copy(os.path.join(APP, "turgor"), self.app)

    def parameters(self, scene):
        return subprocess.run([os.path.join(self.app, "turgor"), "parameters", scene], capture_output=True, text=True, timeout=60)

    def refused(self, what):
        done = self.parameters("tissue_gravity")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stderr.strip(), f"turgor: The part of the program with finite elements, {self.module}, {what} {ADVICE}")

    def test_none(self):
        self.refused("is not there.")
        self.assertEqual(self.parameters("two_cells").returncode, 0)

    def test_from_another_build(self):
        shutil.copy(os.path.join(APP, "turgor_tissue.so"), self.module)
        with open(self.module, "ab") as file:
            file.write(b"\0")  # it could still be loaded
        self.refused("is from another build than this program.")

    def test_the_right_one(self):
        shutil.copy(os.path.join(APP, "turgor_tissue.so"), self.module)
        done = self.parameters("tissue_gravity")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("set Scenario = tissue_gravity", done.stdout)


if __name__ == "__main__":
    unittest.main()
