"""Defaults of the scenes of centre-based cells are what is validated: inputs/NAME.prm sets nothing that the scene does not have by itself."""
import os
import re
import subprocess
import unittest

PROGRAM = os.path.join(os.environ["TURGOR_BUILD"], "app", "turgor")
INPUTS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "inputs")
NAMES = ("monolayer", "spheroid_capsule", "spheroid_dextran", "spheroid_free", "spheroid_relaxation", "two_cells")


def entries(text):
    """{Section/Name: value}"""
    found, sections = {}, []
    for line in (one.split("#")[0].strip() for one in text.splitlines()):
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):].strip())
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            name, value = line[4:].split("=", 1)
            found["/".join(sections + [name.strip()])] = value.strip()
    return found


def value(text):
    """Numbers as numbers: 5e9 is 5000000000."""
    return float(text) if re.fullmatch(r"[-+]?[\d.]+(e[-+]?\d+)?", text) else text


class Defaults(unittest.TestCase):
    def test_inputs_set_what_is_default(self):
        for name in NAMES:
            with open(os.path.join(INPUTS, name + ".prm"), encoding="utf-8") as file:
                chosen = entries(file.read())
            done = subprocess.run([PROGRAM, "parameters", name], capture_output=True, text=True, check=True, timeout=60)
            default = entries(done.stdout)
            self.assertGreater(len(chosen), 3)
            differ = {entry: (text, default.get(entry)) for entry, text in chosen.items() if value(text) != value(default.get(entry, ""))}
            self.assertEqual(differ, {}, name)


if __name__ == "__main__":
    unittest.main()
