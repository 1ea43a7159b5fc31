"""Every input says in the comment at its head what it takes, so that nobody has to start it to find out: a scene's CPU time and memory, a study's CPU time."""
import os
import re
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
INPUTS = os.path.join(SOURCE, "inputs")


def head(path):
    """The comment before the first line that is none."""
    with open(path, encoding="utf-8") as file:
        return re.match(r"(?:#.*\n)*", file.read()).group(0)


class InputCosts(unittest.TestCase):
    def test_scenes_say_time_and_memory(self):
        names = sorted(name for name in os.listdir(INPUTS) if name.endswith(".prm"))
        self.assertGreater(len(names), 20)
        silent = [name for name in names if not re.search(r"^# Takes (about .+|less than a second) of CPU time and \d+ MB", head(os.path.join(INPUTS, name)), re.M)]
        self.assertEqual(silent, [], "a line like '# Takes about 6 s of CPU time and 32 MB' is missing at their heads (summary.json has both numbers)")

    def test_studies_say_time(self):
        silent = [os.path.relpath(os.path.join(place, name), INPUTS)
                  for place, _, files in os.walk(os.path.join(INPUTS, "studies")) for name in files
                  if name.endswith(".prm") and "CPU time" not in head(os.path.join(place, name))]
        self.assertEqual(silent, [], "the CPU time is missing at their heads")


if __name__ == "__main__":
    unittest.main()
