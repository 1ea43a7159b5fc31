"""Every folder of doc/results says what stands there and by which command it was made, and holds results."""
import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RESULTS = os.path.join(ROOT, "doc", "results")


class ResultFolders(unittest.TestCase):
    def test_each_names_its_command_and_holds_results(self):
        for name in sorted(os.listdir(RESULTS)):
            folder = os.path.join(RESULTS, name)
            if not os.path.isdir(folder):
                continue
            with self.subTest(folder=name):
                with open(os.path.join(folder, "README.md"), encoding="utf-8") as file:
                    text = file.read()
                self.assertRegex(text, r"(\./turgor|/usr/bin/python3|build/tests/test_\w+) \S")
                self.assertGreater(len(os.listdir(folder)), 1, "a README alone")
                for path in re.findall(r"inputs/[a-z_/0-9]+\.(?:prm|py)", text):
                    self.assertTrue(os.path.exists(os.path.join(ROOT, path)), path)


if __name__ == "__main__":
    unittest.main()
