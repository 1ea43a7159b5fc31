"""Wrong input, through the built program: each case ends with exit code 2, says what is wrong in
the sentence, and has written nothing.

A case: name, input text (or None), arguments, what the message has to hold. IN is the input
file, OUT the output directory. Cases of a scene run once the scene is in the program.
"""
import os
import subprocess
import tempfile
import unittest

BUILD = os.environ["TURGOR_BUILD"]
PROGRAM = os.path.join(BUILD, "app", "turgor")
RUN = ["run", "IN", "-o", "OUT"]


def program(arguments, directory):
    return subprocess.run([PROGRAM] + arguments, cwd=directory, capture_output=True, text=True, timeout=120,
                          stdin=subprocess.DEVNULL)


SCENES = [line for line in program(["list"], ".").stdout.splitlines() if line and not line.startswith(" ")]


def defaults(scene):
    return program(["parameters", scene], ".").stdout


def general():
    """Cases of the command line and the file itself."""
    some = SCENES[0] if SCENES else "none"
    head = f"set Scenario = {some}\n"
    return [
        ("missing_file", None, ["run", "no_such.prm", "-o", "OUT"], ["There is no input file no_such.prm"]),
        ("input_is_a_directory", None, ["run", ".", "-o", "OUT"], ["it is a directory"]),
        ("no_arguments", None, [], ["subcommand is required"]),
        ("unknown_command", None, ["rum"], ["There is no command 'rum'. Did you mean 'run'?"]),
        ("unknown_option", head, RUN + ["--thread", "2"], ["--thread"]),
        ("zero_threads", head, RUN + ["--threads", "0"], ["--threads", "1"]),
        ("no_scenario", "set Steps = 3\n", RUN, ["the entry 'Scenario' is missing"]),
        ("a_study", "subsection Run a\n  set Input = a.prm\nend\n", RUN, ["is a study, not a scene"]),
        ("unknown_scenario", "set Scenario = tissue_gravitee\n", RUN, ["IN, line 1: there is no scenario 'tissue_gravitee'"]),
        ("misspelt_scenario_entry", "set Scenaro = x\n", RUN, ["line 1", "Did you mean 'Scenario'?"]),
        ("unclosed_subsection", head + "subsection A\n", RUN, ["line 2: subsection 'A' is never closed"]),
        ("end_too_many", head + "end\n", RUN, ["line 2: this 'end' closes no subsection"]),
        ("not_a_setting", head + "period: 3\n", RUN, ["line 2: 'period: 3' is not understood"]),
        ("set_twice", head + head, RUN, ["line 2: 'Scenario' is set a second time"]),
        ("not_text", "\0\0\0", RUN, ["is not a text file"]),
        ("not_utf8", (head + "set Name = \xff\n").encode("latin-1"), RUN, ["IN, line 2: it is not text in UTF-8"]),
        ("not_utf8_in_a_value", head, RUN + ["--set", b"Steps=\xff"], ["not text in UTF-8"]),
        ("nested_20000_deep", head + "subsection A\n" * 20000, RUN, ["IN, line 18: subsections are nested more than 16 deep"]),
        ("a_name_of_300_letters", head + "set " + "n" * 300 + " = 1\n", RUN, ["there is no entry 'nnn"]),
        ("a_scenario_of_300_letters", "set Scenario = " + "n" * 300 + "\n", RUN, ["there is no scenario 'nnn"]),
        ("an_output_of_300_letters", head, ["run", "IN", "-o", "n" * 300], ["nnn", "too long"]),
        ("an_input_of_300_letters", None, ["run", "n" * 300, "-o", "OUT"], ["nnn", "too long"]),
        ("a_study_of_300_letters", None, ["study", "n" * 300], ["nnn", "too long"]),
        ("a_plot_of_300_letters", None, ["plot", "n" * 300], ["There is no directory nnn"]),
        ("a_validation_nested_300000_deep", None, ["validate", "--root", "R"],
         ["R/inputs/validation/a.json, line 2: brackets are nested more than 64 deep"],
         [("R/inputs/validation/a.json", '{"runs":\n' + "[" * 300000)]),
        ("a_validation_that_is_no_json", None, ["validate", "--root", "R"], ["R/inputs/validation/a.json, line 3: this is not JSON"],
         [("R/inputs/validation/a.json", '{"runs": {},\n "rows": []\n,}')]),
        ("a_validation_with_a_text_for_a_number", None, ["validate", "--root", "R"], ["run 'a': 'threads' has to be a whole number"],
         [("R/inputs/validation/a.json", '{"runs": {"a": {"input": "x.prm", "threads": "two"}}, "rows": [{}]}')]),
        ("override_without_value", head, RUN + ["--set", "Rate"], ["write --set 'Section/Name=value'"]),
        ("plot_without_a_run", None, ["plot", "nowhere"], ["There is no directory nowhere"]),
        ("parameters_of_unknown_scene", None, ["parameters", "nonsense"], ["There is no scenario 'nonsense'"]),
        ("check_missing_file", None, ["check", "no.prm"], ["There is no input file no.prm"]),
        ("study_missing_file", None, ["study", "no.prm"], ["There is no input file no.prm"]),
    ]


def of_every_scene(scene):
    """Cases that follow from what the scene declares."""
    head = f"set Scenario = {scene}\n"
    entries, section = [], []
    for line in defaults(scene).splitlines():
        words = line.strip()
        if words.startswith("subsection "):
            section.append(words[len("subsection "):])
        elif words == "end":
            section.pop()
        elif words.startswith("# "):
            comment = (comment + " " if entries and entries[-1] is None else "") + words[2:]
            entries.append(None)
        elif words.startswith("set "):
            entries.append((tuple(section), words[4:].split(" = ")[0].strip(), comment))
    entries = [e for e in entries if e is not None]
    cases = [
        ("unknown_entry", head + "set Xyzzyx = 1\n", RUN, ["IN, line 2: there is no entry 'Xyzzyx' in the top level"]),
        ("unknown_subsection", head + "subsection Xyzzyx\nend\n", RUN, ["line 2: there is no subsection 'Xyzzyx'"]),
        ("no_write_permission", head, ["run", "IN", "-o", "/proc/turgor_out"], ["cannot be written", "-o DIR"]),
        ("corrupt_checkpoint", head, RUN + ["--resume"], ["out/checkpoint.0 was not written by this program"],
         [("out/checkpoint.0", "TURGORcp torn"), ("out/checkpoint.1", "")]),
        ("output_is_a_file", head, ["run", "IN", "-o", "IN"], ["is a file"]),
    ]
    numbers = [(path, name) for path, name, comment in entries if "Allowed: a finite number" in comment]
    if numbers:
        path, name = numbers[0]
        where = "/".join(path + (name,))
        for value in ("nan", "-inf", "1e999", "three", "1 mm", "1e5abc", "3,5", "0x10", "1 2") if scene == SCENES[0] else ("nan",):
            cases.append((f"number_{value}", head, RUN + ["--set", f"{where}={value}"],
                          [f"'{where}' = '{value}' is not allowed; allowed: a finite number"]))
        cases.append(("misspelt_entry", head, RUN + ["--set", f"{where}q=1"], [f"Did you mean '{name}'?"]))
    return cases


# Entry, wrong value, what the message has to hold beside the entry's name.
CELL = [
    ("Cell/Wall stiffness", "-1", ["a finite number from 1e-06", "N/m"]),
    ("Cell/Fluid density", "0", ["a finite number from 1", "kg/m^3"]),
    ("Cell/Fluid viscosity", "-1", ["a finite number from 0", "Pa s"]),
    ("Cell/Fluid modulus", "6", ["a finite number from 1000", "Pa"]),
    ("Cell/Period", "100", ["a finite number from 1e-07 to 0.01", "Units: m"]),  # metres instead of micrometres
    ("Cell/Nodes per side", "1", ["a whole number from 2"]),
    ("Cell/Nodes per side", "25.5", ["a whole number"]),
    ("Cell/Wall beta", "3", ["a finite number from 0 to 1"]),
    ("Cell/Wall bending", "perhaps", ["true or false"]),
    ("Cell/Wall thickness", "1e-3", ["thinner than half the period"]),
]
NO_TURGOR = ("Cell/Turgor", "0", ["Cell/Turgor is 0", "positive turgor (Pa)"])
BY_SCENE = {
    "tissue_gravity": CELL + [
        ("RVE/Rule", "cauchy_burn", ["Did you mean 'cauchy_born'?"]),
        ("RVE/Fluid", "air", ["one of"]),
        ("Tissue/Traction", "0, nan", ["a list, each entry a finite number"]),
        ("Time/End time", "-1", ["a finite number from"]),
        ("Tissue gravity/Cells", "0", ["a whole number from"]),
    ],
    "full_micro": CELL[:2] + [
        ("Columns", "0", ["a whole number from 1"]),
        ("Surfaces", "frozn", ["Did you mean 'frozen'?"]),
        ("Step fraction", "2", ["from 0.01 to 1"]),
        NO_TURGOR,
    ],
    "laplace": [("Dimension", "4", ["from 2 to 3"]), ("Cell/Turgor", "0", ["has to be positive"]),
                ("Cell/Turgor", "7e6", ["below 2 G t0/Radius"]), ("Cell/Fluid", "none", ["an empty shell holds no pressure"]),
                ("Cell/Wall thickness", "1e-5", ["thinner than a fifth of the radius"])],
    "optical_stretcher": [("Elements", "maxwel", ["one of kelvin_voigt, modified_maxwell, both"]), ("Powers", "-1", ["a finite number from 0"]), ("Powers", "0.9, 0.9", ["0.9 W twice"])],
    "network_shear": [("Side", "1e-5", ["4 to 30 are allowed"]), ("Kept bonds", "0.2", ["a finite number from 0.3"]), ("Layer height", "1e-6", ["give Anchors = true"]),
                      ("Nodes", "sixfould", ["Did you mean 'sixfold'?"]), ("Largest strain", "0", ["Frames = 1 draws the network at rest"])],
    "poiseuille": [("Particles along", "3", ["longer than 3.9", "Fluid/Support"]), ("Motion/Method", "heun", ["Fluid/Density by = summation"]), ("Fluid/Viscous form", "moris", ["one of least_squares, morris, monaghan"]), ("Speed", "0", ["a finite number from"])],
    "creep": [("Particles along", "3", ["longer than 3.9", "Solid/Support"]), ("Load", "shears", ["Did you mean 'shear'?"]), ("Solid/Poisson's ratio", "0.5", ["a finite number from 0"])],
    "rotating_block": [("Stretch along", "3", ["from 0.5 to 2"]), ("Steps per turn", "3", ["from 4"])],
    "cylinder_array": [("Porosity", "0.3", ["from 0.45"]), ("Particles across", "4", ["from 8"]), ("Motion/Method", "heun", ["Fluid/Density by = summation"])],
    "matrix_migration": [("Spacing", "3e-5", ["half of Cell/Radius"]), ("Start", "0.05", ["from the cell's centre", "Length, Width or Start"]), ("Motion/Longest step", "1", ["the viscosity over the shear modulus"]),
                         ("Spacing", "1e-6", ["at most 60000"])],
    "couette": [("Motion/Method", "heun", ["Fluid/Density by = summation"])],
    "rbc_tweezers": [("Forces", "2e-11, 1e-11", ["positive and rising", "number 2 is 1e-11 N"]), ("Experiment", "nowhere.csv", ["nowhere.csv"])],
    "spreading": [("Contact/Adhesion", "0", ["does not adhere"]), ("Contact/Range", "3e-6", ["more than a quarter of Cell/Radius", "make Contact/Range shorter"]),
                  ("Contact/Gap at rest", "1e-9", ["deviate from the sphere", "finer net (Cell/Frequency)"]), ("First step", "2e3", ["a finite number from"])],
    "pull_off": [("Contact/Adhesion", "0", ["nothing holds the cell"]), ("From", "plain", ["Did you mean 'plane'?"]), ("Settling time", "1e-4", ["shorter than Settling time"]),
                 ("Pull distance", "1e-4", ["two diameters"]), ("Pull speed", "2.5e-7", ["more than a twentieth of Pull distance", "Pull speed or Longest step smaller"])],
    "doublet": [("Contact/Adhesion", "0", ["nothing holds the two cells"]), ("Contact/Adhesion", "1.9e-3", ["spread on each other without end"]), ("End time", "1e-5", ["shorter than End time"])],
    "capsule_compression": [("Last radius", "4e-5", ["just encloses the cells"]), ("Last radius", "1e-5", ["less than half of their volume"])],
    "spheroid_deformable": [("Longest step", "3e3", ["a fiftieth of Cell/Cycle time"]), ("Most cells", "1", ["larger, or 0 for no limit"]),
                            ("Growth/Mitosis time", "8e4", ["at most half of Cell/Cycle time"]), ("Division/Direction", "rondom", ["Did you mean 'random'?"])],
    "cell_between_plates": [("Plate distance", "3e-5", ["just touch the cell"]), ("Plate distance", "4e-6", ["torn to slivers"])],
    "protrusion": [("Stiffnesses", "1e-3, 1e-4", ["have to rise", "number 2 (0.0001 N/m)"]), ("Protrusion/Work limit", "1e-13", ["reached", "smaller Protrusion/Work limit"]), ("Stiffnesses", "0", ["a finite number from"])],
    "rod_migration": [("Network/Side", "2e-5", ["4 are needed at least"]), ("Network/Side", "3e-5", ["a larger Network/Side"]), ("Protrusion/Reach", "5e-6", ["ends inside of the cell"]), ("Network/Node radius", "3e-6", ["leaves no gaps"]),
                      ("Cell/Law", "jkr", ["needs it positive"]), ("Cell/Nucleus radius", "7e-6", ["less than Cell/Radius"])],
    "invasion": [("Cells", "2000", ["the colony reaches", "a larger Network/Side"]), ("Cells", "0", ["a whole number from"]), ("Cell/Nucleus radius", "7e-6", ["less than Cell/Radius"])],
    "rod_squeeze": [("Plate distance", "3e-5", ["just touch the cell"]), ("Plate distance", "2e-6", ["flatter than 0.2 of"]), ("Cell/Nucleus radius", "7e-6", ["less than Cell/Radius"]),
                    ("Angle", "80", ["a finite number from 0 to 60"])],
    "shell_oscillation": [("Inward speed", "9", ["at most a fiftieth of Sound speed"])],
    "cell_compression": [("Critical stretch", "1.0001", ["larger than the stretch of the turgid wall"]),
                         ("Cell/Yield drop", "0.9", ["0 with Dimension = 3"])],
    "cell_impact": [("Cell/Fluid particles", "25", ["kernel's radius"]), ("Speed", "0", ["a finite number from"])],
    "cell_failure": [("Critical stretch", "0", ["needs one above 1"]), ("Cell/Kernel", "fourth_order", ["a wall that can break", "needs wendland"]),
                     ("Cell/Fluid", "pressure", ["does not have one pressure"])],
    "tissue_bruise": CELL[:1] + [
        ("Wall/Critical stretch", "1.01", ["turgor alone stretches the walls to 1.03", "0 for walls that do not break"]),
        ("Wall/Yield drop", "0", ["more than 0 with 'Yielding = plastic'"]),
        ("Wall/Yielding", "plastick", ["Did you mean 'plastic'?"]),
        ("Wall/Residue", "1", ["a finite number from 0 to 0.99"]),
        ("RVE/Fluid", "sph", ["need 'RVE/Fluid = hydrostatic'"]),
        ("RVE/Rule", "cauchy_born", ["need elastic_equilibrium"]),
        ("Impact/Depth", "2e-3", ["less than nine tenths of the tissue's width"]),
        ("Impact/Tool", "hammer", ["one of"]),
        ("Tissue/Elements y", "1", ["the cylinder would slip through between them", "of at least 2"]),
        ("Tissue/Right side", "clamped", ["it needs 'Right side = free'"]),
    ],
    "tissue_impact": [
        NO_TURGOR,
        ("Gap", "30e-6", ["Gap is 3e-05 m", "a quarter of Cell/Period"]),
        ("Structure/Gap", "20e-6", ["use Sides = cut, periodic or widening"]),
        ("Cell/Nodes per side", "9", ["even number"]),
        ("Yielding", "elastic", ["one of"]),
        ("Critical stretch", "1", ["above 1, or 0"]),
    ],
    "spheroid_free": [
        ("Contact/Adhesion", "0", ["Law = jkr needs it positive"]),
        ("Contact/Law", "jrk", ["Did you mean 'jkr'?"]),
        ("Growth/Mitosis time", "50000", ["at most half of Cell/Cycle time"]),
        ("Cell/Variability", "0.5", ["from 0 to 0.24"]),
        ("Cell/Seed", "0.5", ["whole number"]),
        ("Death/Rim", "dead", ["one of"]),
    ],
    "monolayer": [("Division/Axis", "0, 0, 1e5abc", ["a list, each entry a finite number"]),
                  ("Division/Direction", "least_stress", ["divide in its plane"]),
                  ("Motion/Preferred direction", "0, 0, 1", ["crawl in its plane"])],
    "spheroid_relaxation": [("Compressed size", "1.2", ["from 0.5 to 0.999"])],
    "cell_endurance": [NO_TURGOR, ("Steps", "2.5", ["whole number"])],
    "rve_response": CELL[:1] + [("RVE/Rule", "elastic", ["one of"]), ("Structure/Void fraction", "0.9", ["a finite number from 0 to 0.5"]), ("RVE/Columns", "0", ["a whole number from 1"]),
                                  ("RVE/Tolerance", "1e-20", ["allowed are 0"]), ("Structure/Air", "isothermal", ["with Structure/Gap = 0 there is none"]),
                                  ("Structure/Air pressure", "0", ["1000 to"])],
}


def tree(directory):
    return sorted(os.path.join(place, name) for place, folders, files in os.walk(directory) for name in folders + files)


class BadInput(unittest.TestCase):
    maxDiff = None

    def check(self, text, arguments, fragments, files=()):
        with tempfile.TemporaryDirectory() as directory:
            for name, content in files:
                os.makedirs(os.path.dirname(os.path.join(directory, name)), exist_ok=True)
                with open(os.path.join(directory, name), "w", encoding="utf-8") as file:
                    file.write(content)
            if text is not None:
                with open(os.path.join(directory, "in.prm"), "wb") as file:
                    file.write(text if isinstance(text, bytes) else text.encode())
            place = {"IN": "in.prm", "OUT": "out"}
            before = tree(directory)
            done = program([place.get(a, a) for a in arguments], directory)
            said = done.stdout + done.stderr
            for fragment in fragments:
                self.assertIn(fragment.replace("IN", "in.prm"), said)
            self.assertEqual(done.returncode, 2, said)
            self.assertEqual(tree(directory), before, "something was written")
            for words in ("json.exception", "filesystem error", "terminate"):
                self.assertNotIn(words, said)


def add(name, case):
    setattr(BadInput, "test_" + "".join(c if c.isalnum() else "_" for c in name), lambda self: self.check(*case))


def turgor_is_needed_by_the_sph_rve():
    """Cell/Turgor = 0 is wrong with one kind of RVE only."""
    for scene in ("rve_response", "tissue_gravity"):
        yield [f"turgor_of_the_sph_rve_{scene}", f"set Scenario = {scene}\n",
               RUN + ["--set", "RVE/Fluid=sph", "--set", "Cell/Turgor=0"], NO_TURGOR[2]]


for case_name, *rest in turgor_is_needed_by_the_sph_rve():
    add(case_name, rest)
add("a_tissue_larger_than_the_machine", ["set Scenario = tissue_bruise\n",
    RUN + ["--set", "Tissue/Elements x=4096", "--set", "Tissue/Elements y=4096"],
    ["4096 x 4096 elements with 6.71e+07 RVEs need about", "GB of memory, this machine has", "take fewer elements"]])
add("a_tool_on_held_nodes_only", ["set Scenario = tissue_bruise\n",
    RUN + ["--set", "Impact/Tool=plate", "--set", "Tissue/Elements y=1", "--set", "Tissue/Lateral sides=clamped"],
    ["every node that the tool touches is held", "take more elements or other lateral sides"]])
CSV = "compression,modulus\n0.1,400\n"
for case_name, rows, parts in (("a_unit", "0.2,3000 Pa\n", "line 3: column 2 (modulus) holds '3000 Pa'"),
                               ("letters", "0.2,1e5abc\n", "line 3: column 2 (modulus) holds '1e5abc'"),
                               ("decimal_commas", "0,2,3,5\n", "line 3: it has 4 fields where 2 are needed"),
                               ("a_quoted_decimal_comma", '0.2,"3,5"\n', "line 3: column 2 (modulus) holds '3,5'")):
    add("a_stiffness_with_" + case_name, ["set Scenario = spheroid_free\n", RUN + ["--set", "Contact/Local stiffness=s.csv"],
                                          ["s.csv, " + parts], [("s.csv", CSV + rows)]])
add("a_stiffness_of_300_letters", ["set Scenario = spheroid_free\n", RUN + ["--set", "Contact/Local stiffness=" + "n" * 300], ["too long"]])
for case_name, *rest in general():
    add(case_name, rest)
for scene_name in SCENES:
    for case_name, *rest in of_every_scene(scene_name):
        add(scene_name + "_" + case_name, rest)
    for entry, value, parts in BY_SCENE.get(scene_name, []):
        add(f"{scene_name}_{entry}_{value}",
            [f"set Scenario = {scene_name}\n", RUN + ["--set", f"{entry}={value}"], [entry.split("/")[-1]] + parts])

if __name__ == "__main__":
    unittest.main()
