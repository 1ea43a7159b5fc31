"""A slice of inputs/studies/fuzz.py: 20 random scenes end well or with a sentence."""
import os
import subprocess
import sys
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


class Fuzz(unittest.TestCase):
    def test_twenty_random_scenes(self):
        done = subprocess.run([sys.executable, os.path.join(SOURCE, "inputs", "studies", "fuzz.py"), "-n", "20", "--seed", "1", "--time", "2",
                               "--program", os.path.join(os.environ["TURGOR_BUILD"], "app", "turgor")],
                              capture_output=True, text=True, timeout=300, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
