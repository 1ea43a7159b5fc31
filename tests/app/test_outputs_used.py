"""Rows of the validation and measures of the studies ask for results and columns that their scenes define."""
import glob
import json
import os
import re
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tests"))
from defined_outputs import defined_outputs, stands_for  # noqa: E402

PROGRAM = os.path.join(os.path.abspath(os.environ["TURGOR_BUILD"]), "app", "turgor")


def entry(text, name):
    """Of the first `set NAME = VALUE`; None without."""
    found = re.search(rf"^\s*set {name}\s*=\s*(.*?)\s*(#.*)?$", text, re.M)
    return found.group(1) if found else None


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class Used(unittest.TestCase):
    known = {}

    def defines(self, input_file, file, name):
        scene = entry(text_of(input_file), "Scenario")
        if scene not in self.known:
            self.known[scene] = defined_outputs(PROGRAM, scene)
        return any(place == file and stands_for(defined.split(" [")[0], name) for place, defined, _ in self.known[scene])

    def test_validation(self):
        rows = 0
        for path in sorted(glob.glob(os.path.join(ROOT, "inputs/validation/*.json"))):
            with open(path, encoding="utf-8") as file:
                validation = json.load(file)
            for row in validation["rows"]:
                for key in ("result", "relative_to"):
                    if ":" not in str(row.get(key, "")):
                        continue
                    run, name = row[key].split(":")
                    with self.subTest(file=os.path.basename(path), name=row[key]):
                        there = os.path.join(os.path.dirname(path), validation["runs"][run]["input"])
                        self.assertTrue(self.defines(there, "summary.json", name))
                        rows += 1
        self.assertGreater(rows, 50)

    def test_studies(self):
        measures = 0
        for path in sorted(glob.glob(os.path.join(ROOT, "inputs/studies/**/*.prm"), recursive=True)):
            text = text_of(path).replace("\\\n", " ")
            inputs = re.findall(r"^\s*set Input\s*=\s*(\S+)", text, re.M)
            for section in re.findall(r"^subsection Measure .*?^end", text, re.M | re.S):
                table, result = entry(section, "Table"), entry(section, "Result")
                wanted = [(table + ".csv", name.strip()) for key in ("Columns", "Against", "Match") for name in (entry(section, key) or "").split(",") if name.strip()] \
                    if table else [("summary.json", result)]
                for input_file in inputs:
                    for file, name in wanted:
                        with self.subTest(study=os.path.basename(path), input=input_file, name=name):
                            self.assertTrue(self.defines(os.path.join(os.path.dirname(path), input_file), file, name))
                            measures += 1
        self.assertGreater(measures, 20)


if __name__ == "__main__":
    unittest.main()
