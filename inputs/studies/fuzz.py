#!/usr/bin/python3
"""Random scenes drawn by seed inside the allowed ranges of the entries, each run through the program: no crash, no
hang, no NaN in any file, no wrong input without a sentence, no energy from nothing.

    /usr/bin/python3 inputs/studies/fuzz.py -n 1000 -o doc/results/fuzz          all scenes of `turgor list`, in turn
    /usr/bin/python3 inputs/studies/fuzz.py --repeat 417                         one again, with what it was given and said
    /usr/bin/python3 inputs/studies/fuzz.py --edges --time 0.3                   every entry of every scene at its limits, one at a time
    /usr/bin/python3 inputs/studies/fuzz.py --decades -n 200 --time 30           entries at 1e-6, 1e-3, 1e3, 1e6 times their default, one at a time,
                                                                                 also of the other structures, strips and bodies (BASES)

Drawn: one to four entries over their whole range (logarithmically where it spans decades), a third of the others
within a factor of three of their default. The tables SMALL and DRAWN size the scenes down and know entries that are texts.

Verdicts: ok, refused (exit code 2, a sentence, nothing written), failed (1, a sentence), long (alive after --time seconds of CPU, then stopped
cleanly when asked), and the bad ones: crash (or a sanitizer's report), hang, nan, silent (no sentence), energy, unchecked (refused by
`run` before its first step, but called ok by `check`).
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import math
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BAD = ("crash", "hang", "nan", "silent", "energy", "unchecked")

# Entries of every scene that only decide how long it takes, or that most draws would have refused: (least, most) to draw from, a list to choose
# from, or a fixed value. "Section/" of any depth.
SMALL = {"Cell/Nodes per side": (3, 10), "SPH/Particles per side": (6, 10), "SPH/Anneal steps": (200, 20000), "Samples": (10, 50),
         "Frames": (0, 2), "Checkpoints": (0, 3), "Columns": (1, 2), "Rows": (1, 2), "RVE/Columns": 1, "RVE/Rows": 1,
         "RVE/Relax steps": (50, 1000), "Relax steps": (0, 2000), "Steps": (100, 20000)}
SMALL_TISSUE = {"Columns": (1, 3), "Rows": (1, 3), "End strain": 0.1, "Speed": (5, 20), "Cell/Nodes per side": [4, 6, 8, 10]}
SMALL_ROUND = {"Cell/Frequency": (3, 6), "Cell/Fluid particles": (100, 600), "Cell/Anneal steps": (100, 2000), "Cell/Rest steps": (0, 3000),
               "Cell/Yield drop": [0, 0, 0, 0.5]}
SMALL_SPHEROID = {"First cells": (1, 20), "End time": (3600, 200000), "Most cells": (21, 100)}
SCENES = {
    "spheroid_free": SMALL_SPHEROID,
    "monolayer": SMALL_SPHEROID,
    "spheroid_dextran": SMALL_SPHEROID,
    "spheroid_relaxation": dict(SMALL_SPHEROID, **{"Settling time": 7200}),
    "full_micro": {"End time": 1e-6},
    "stability": {"Hold steps": (100, 500), "Bisections": 2},
    "static_lattice": {"Columns": (1, 4), "Rows": (1, 4)},
    "rve_response": {"Path/Points": (2, 4), "Structure/Void fraction": 0.0},
    "tissue_gravity": {"Tissue gravity/Cells": (1, 4), "Tissue/Elements": (1, 2), "Tissue/Degree": 1, "Time/End time": 2e-5,
                       "Tissue gravity/Outlined RVEs": (0, 2)},
    "tissue_compression": SMALL_TISSUE,
    "tissue_impact": SMALL_TISSUE,
    "tissue_failure": SMALL_TISSUE,
    "wall_uniaxial": {},
    "cell_steps": {"Cells": (2, 30), "End time": (1, 100), "Halvings": (1, 4)},
    "spheroid_capsule": {"First cells": (2, 30), "End time": (1e3, 5e4), "Capsule/Radius": 50e-6},
    "laplace": SMALL_ROUND,
    "shell_oscillation": dict(SMALL_ROUND, Periods=4),
    "cell_compression": dict(SMALL_ROUND, Speed=(20, 50), Deformation=0.1),
    "cell_impact": dict(SMALL_ROUND, Speed=(20, 50), Deformation=0.1),
    "cell_failure": dict(SMALL_ROUND, Speed=(20, 50), Deformation=0.1),
    "rbc_tweezers": {"Forces": "1e-11", "Cell/Frequency": (2, 4)},
    "spreading": {"Cell/Frequency": (2, 4), "End time": (1, 1e4)},
    "pull_off": {"Cell/Frequency": (2, 4), "Settling time": (1, 1e4), "Pull distance": (1e-7, 2e-6)},
    "doublet": {"Cell/Frequency": (2, 4), "End time": (1, 1e4)},
    "capsule_compression": {"Cell/Frequency": (2, 4), "Cells": (2, 5), "Last radius": (15e-6, 19e-6), "Compression time": (10, 600), "Hold time": (0, 60)},
    "spheroid_deformable": {"Cell/Frequency": (3, 4), "First cells": (1, 3), "End time": (1e3, 6e3), "Frames": (1, 3), "Longest step": (20, 100), "Cell/Cycle time": (5e3, 2e4)},
    "cell_between_plates": {"Cell/Frequency": (2, 5), "Compression time": (5, 60), "Hold time": (0, 20), "Plate distance": (12e-6, 20e-6)},
    "poiseuille": {"Particles across": (4, 8), "Particles along": (4, 6), "End time": 1e-4, "Packing/Settling steps": (0, 20)},
    "creep": {"Particles across": (4, 8), "Particles along": (5, 6), "End time": 0.02, "Packing/Settling steps": (0, 20)},
    "rotating_block": {"Particles": (4, 8), "Stretching steps": (1, 20), "Steps per turn": (4, 40), "Turns": (1, 2)},
    "cylinder_array": {"Particles across": (8, 16), "Porosity": (0.6, 0.95), "Gap": (0., 0.4), "End time": 1e-3, "Packing/Settling steps": (0, 20)},
    "matrix_migration": {"Width": 2e-4, "Length": 2e-4, "Spacing": (8e-6, 1.2e-5), "Cell/Radius": (2.4e-5, 3e-5), "End time": 0.3, "Packing/Settling steps": (0, 20)},
    "couette": {"Particles across": (4, 8), "Particles along": (4, 6), "End time": 1e-4, "Packing/Settling steps": (0, 20)},
    "optical_stretcher": {"Cell/Frequency": (2, 4), "Powers": [1.1, 0.3]},
    "network_shear": {"Pore sizes": "2e-6", "Side": 2e-5, "Stiffnesses": [1e-3, 10.0], "Kept bonds": [1.0, 0.9], "Seeds": (1, 2), "Steps": (1, 5)},
    "protrusion": {"Stiffnesses": ["1e-4", "1e-5, 1e-2"], "Length": 20e-6, "Longest step": (0.05, 0.5), "Protrusion/Lifetime": (1, 100), "Protrusion/Work limit": 1e-15, "Protrusion/Stiffness": (1e-4, 1e-2),
                   "Protrusion/Stall step": (1e-11, 1e-9)},
    "rod_migration": {"Seeds": (1, 2), "End time": (10, 200), "Network/Stiff side": [1, 10, 1000], "Network/Pore size": [4e-6, 6e-6, 12e-6], "Network/Side": 9e-5, "Longest step": (0.2, 1.5), "Network/Node radius": (1e-7, 1e-6), "Protrusion/Reach": (8e-6, 15e-6),
                      "Cell/Radius": 6e-6, "Cell/Nucleus radius": [0.0, 3e-6, 5e-6], "Samples": (2, 10), "Frames": (0, 2)},
    "invasion": {"Cells": [1, 7, 40], "End time": (10, 60), "Network/Pore size": [4e-6, 6e-6, 12e-6], "Network/Side": 2e-4, "Longest step": (0.2, 1.5), "Network/Node radius": (1e-7, 1e-6), "Protrusion/Reach": (8e-6, 15e-6),
                 "Cell/Radius": 6e-6, "Cell/Nucleus radius": [0.0, 3e-6, 5e-6], "Samples": (2, 10), "Frames": (0, 2)},
    "rod_squeeze": {"Compression time": (5, 60), "Hold time": (0, 20), "Plate distance": (3e-6, 10e-6), "Cell/Radius": 6e-6, "Cell/Nucleus radius": [0.0, 3e-6, 5e-6]},
    "tissue_bruise": {"Impact/Depth": 1e-5, "Tissue/Elements x": (1, 3), "Tissue/Elements y": (2, 3), "Tissue/Degree": 1},
    "texture_test": {"Test/Depth": 1e-5, "Tissue/Elements x": (1, 3), "Tissue/Elements y": (2, 3), "Tissue/Degree": 1,
                     "Load steps/Smallest": 1e-3, "Load steps/First": 0.05, "Load steps/Largest": 0.1},
    "tissue_statics": {"Tissue statics/Cells": (1, 4), "Tissue statics/Elements": (1, 2), "Tissue statics/Degree": 1},
}


def matrix(rng, centre, size):
    return "%.6g, %.6g; %.6g, %.6g" % tuple((centre if k in (0, 3) else 0) + rng.uniform(-size, size) for k in range(4))


PILLAR = {"Body/File": os.path.join(ROOT, "inputs", "reference", "pillar.off"), "Body/Position": "45e-6, 0, 0", "Body/Load": "-1e-9, 0, 0"}
STRUCTURES = [{"Structure/Structure": kind} for kind in ("brick", "hexagon", "voronoi")]
STRIPS = [{"Sides": sides, "Structure/Structure": kind} for sides, kind in (("periodic", "brick"), ("widening", "hexagon"))] + [
    {"Sides": "periodic", "Structure/Gap": 20e-6}, {"Sides": "cut", "Rows": 2}]
# What else of a scene is driven to extremes: settings beside its defaults.
BASES = {"rve_response": STRUCTURES, "tissue_gravity": STRUCTURES, "tissue_statics": STRUCTURES, "tissue_bruise": STRUCTURES[:1],
         "tissue_compression": STRIPS, "tissue_impact": STRIPS, "tissue_failure": STRIPS,
         "spheroid_free": [PILLAR, {**PILLAR, "Body/Motion": "drag", "Body/Turning drag": 1e-8}]}


# Entries that are texts.
DRAWN = {"F": lambda rng: matrix(rng, 1, rng.choice([0.02, 0.3, 1])), "Path/F": lambda rng: matrix(rng, 1, rng.choice([0.02, 0.3, 1])),
         "F_dot": lambda rng: matrix(rng, 0, 10 ** rng.uniform(1, 4)), "Path/F_dot": lambda rng: matrix(rng, 0, 10 ** rng.uniform(1, 5))}


def entries_of(program, scene):
    """[(Section/Name, default, allowed in words)] from `turgor parameters`."""
    text = subprocess.run([program, "parameters", scene], capture_output=True, text=True, check=True).stdout
    entries, sections, comment = [], [], ""
    for line in (one.strip() for one in text.splitlines()):
        if line.startswith("#"):
            comment += " " + line[1:].strip()
        elif line.startswith("subsection "):
            sections.append(line[len("subsection "):])
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            name, value = (part.strip() for part in line[4:].split("=", 1))
            if name != "Scenario":
                entries.append(("/".join(sections + [name]), value, comment.rpartition("Allowed: ")[2].rstrip(".")))
            comment = ""
        elif not line:
            comment = ""
    return entries


def within(rng, low, high, default, wild):
    """A number of the range: near the default, or anywhere."""
    if not wild and default:
        return min(high, max(low, default * 10 ** rng.uniform(-0.5, 0.5)))
    if low > 0 and high / low > 100:
        return math.exp(rng.uniform(math.log(low), math.log(high)))
    if high > 1000 and low <= 0:
        size = 10 ** rng.uniform(-6, math.log10(high))
        return max(low, rng.choice([0, size, -size]) if low < 0 else rng.choice([0, size, size, size]))
    return rng.uniform(low, high)


def draw(rng, scene, entries, sizes_only=False):
    """Settings; with sizes_only those alone that make the scene small."""
    chosen, small = {}, dict(SMALL, **SCENES.get(scene, {}))
    wild = set(rng.sample([name for name, _, _ in entries], min(len(entries), rng.randint(1, 4))))
    for name, default, allowed in entries:
        size = small.get(name)
        if size is not None:
            one = (lambda values: values[0]) if sizes_only else rng.choice  # the first of a list is always allowed
            between = rng.uniform if isinstance(size, tuple) and any(isinstance(end, float) for end in size) else rng.randint
            chosen[name] = between(*size) if isinstance(size, tuple) else one(size) if isinstance(size, list) else size
            continue
        if sizes_only or (name not in wild and rng.random() > 0.33):
            continue
        numbers = re.match(r"a (finite|whole) number from (\S+) to (\S+)", allowed)
        if name in DRAWN:
            chosen[name] = DRAWN[name](rng)
        elif numbers:
            value = within(rng, float(numbers[2]), float(numbers[3]), float(default), name in wild)
            chosen[name] = int(round(value)) if numbers[1] == "whole" else "%.6g" % value
        elif allowed.startswith("one of "):
            chosen[name] = rng.choice(allowed[len("one of "):].split(", "))
        elif allowed == "true or false":
            chosen[name] = rng.choice(["true", "false"])
    return chosen


def edges(scene, entries):
    """Settings: every entry at its limits and at each of its words, the scene small otherwise."""
    small = draw(random.Random(1), scene, entries, sizes_only=True)
    for name, default, allowed in entries:
        numbers = re.match(r"a (finite|whole) number from (\S+) to (\S+)", allowed)
        values = list(numbers.groups()[1:]) if numbers else allowed[len("one of "):].split(", ") if allowed.startswith("one of ") else \
            ["true", "false"] if allowed == "true or false" else []
        for value in values:
            if value != default:
                yield {**small, name: value}


def decades(scene, entries):
    """Settings: every number a thousand and a million times smaller and larger than it is, the scene small otherwise and as in BASES."""
    small = draw(random.Random(1), scene, entries, sizes_only=True)
    for base in [{}] + BASES.get(scene, []):
        for name, default, allowed in entries:
            numbers = re.match(r"a (finite|whole) number from (\S+) to (\S+)", allowed)
            value = float(base.get(name, default)) if numbers else 0.0
            for factor in (1e-6, 1e-3, 1e3, 1e6) if value != 0 else ():
                number = round(value * factor) if numbers[1] == "whole" else float("%.6g" % (value * factor))
                if float(numbers[2]) <= number <= float(numbers[3]) and number != value:
                    yield {**small, **base, name: number}


def energy_gain(directory, least_rows):
    """The most that potential + kinetic energy rises above an earlier value, over the largest energy; None where none is written.

    full_micro: loads that are switched on before t = 0, whose potential is in the sum; tissues: kinetic + stored energy less the work of
    the loads. The other scenes watch their energy by themselves and fail with a sentence.
    """
    for name, parts, total_of in (("energy.csv", ("potential", "kinetic"), lambda row: row["potential"] + row["kinetic"]),
                                  ("energies.csv", ("kinetic", "stored", "work"), lambda row: -row["dissipated"])):
        path = os.path.join(directory, name)
        if not os.path.exists(path):
            continue
        with open(path, newline="", encoding="utf-8") as file:
            rows = [{key.split(" [")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        if len(rows) < least_rows or not set(parts) <= set(rows[0]):
            continue
        size = max(sum(abs(row[part]) for part in parts) for row in rows)
        if size < 1e-14:
            continue  # round-off
        least, gain = math.inf, 0.0
        for row in rows:
            least = min(least, total_of(row))
            gain = max(gain, total_of(row) - least)
        return gain / size
    return None


def not_finite(directory):
    """The first text file with a number that is none, or None."""
    for folder, _, files in os.walk(directory):
        for name in files:
            if name.endswith((".csv", ".json")):
                with open(os.path.join(folder, name), encoding="utf-8", errors="replace") as file:
                    if re.search(r"(?i)(?<![a-z])[-+]?(nan|inf|infinity)(?![a-z])", re.sub(r'"message":.*', "", file.read())):
                        return name
    return None


def ended(process, seconds):
    """Waits until the process has ended, used so many seconds of CPU, or used none for two minutes."""
    before, since, tick = -1.0, time.monotonic(), os.sysconf("SC_CLK_TCK")
    while process.poll() is None:
        with open(f"/proc/{process.pid}/stat", encoding="utf-8") as file:
            used = sum(int(x) for x in file.read().rpartition(")")[2].split()[11:13]) / tick
        if used != before:
            before, since = used, time.monotonic()
        if used > seconds or time.monotonic() - since > 120.0:
            return False
        time.sleep(0.02)
    return True


def run_one(program, scene, entries, seed, seconds):
    """(seed, scene, verdict, sentence, settings)"""
    settings = draw(random.Random(seed), scene, entries)
    return (seed, scene) + run_scene(program, scene, settings, seconds) + (settings,)


def run_scene(program, scene, settings, seconds):
    """(verdict, sentence) of a scene that is asked to stop after so many seconds of CPU."""
    with tempfile.TemporaryDirectory() as directory:
        source, out = os.path.join(directory, "scene.prm"), os.path.join(directory, "out")
        with open(source, "w", encoding="utf-8") as file:
            file.write(f"set Scenario = {scene}\n")
        command = [program, "run", source, "-o", out, "--quiet", "--threads", "1"]
        for name, value in settings.items():
            command += ["--set", f"{name}={value}"]
        said_to = os.path.join(directory, "stderr")
        with open(said_to, "w", encoding="utf-8") as said:
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=said, stdin=subprocess.DEVNULL, cwd=directory)
        late = not ended(process, seconds)
        if late:
            process.terminate()
            if not ended(process, seconds + 20.0):
                process.kill()
                process.wait()
                return "hang", "does not stop when asked"
        with open(said_to, encoding="utf-8", errors="replace") as file:
            words = file.read()
        code, bad_file = process.returncode, not_finite(out)
        said = words.strip().splitlines()
        sentence = said[0] if said else ""
        report = re.search(r".*(?:Sanitizer:|runtime error:).*", words)
        if report:
            verdict, sentence = "crash", report[0]
        elif late and code == -signal.SIGTERM:
            verdict, sentence = "long", "stopped before it began"  # a program that is being loaded may simply be ended
        elif code < 0 or code >= 132:
            verdict, sentence = "crash", f"signal {-code if code < 0 else code - 128}: {sentence}"
        elif bad_file:
            verdict, sentence = "nan", f"{bad_file}: {sentence}"
        elif (late and code in (0, 130)) or code == 0:
            # The first steps have next to no energy to compare with: a node that a tool strikes has (omega dt)^2/4 of its penalty
            # energy too much after one step, and nothing else is there yet.
            gain = energy_gain(out, 20 if code == 0 else 100)
            verdict = "energy" if gain is not None and gain > 1e-2 else "long" if code == 130 else "ok"
            sentence = f"gained {gain:.2g} of the largest energy" if verdict == "energy" else remark_of(out) if verdict == "long" else ""
            if code == 0 and not os.path.exists(os.path.join(out, "summary.json")):
                verdict, sentence = "silent", "exit code 0 without a summary"
        elif not sentence.startswith("turgor: ") or len(sentence) < 30:
            verdict = "silent"
        elif code == 2:
            verdict = "refused" if not os.path.exists(os.path.join(out, "summary.json")) else "failed"
            checked = [program, "check", source] + command[command.index("1") + 1:]
            if subprocess.run(checked, capture_output=True, cwd=directory, stdin=subprocess.DEVNULL, timeout=300).returncode != 2:
                verdict = "unchecked"
        else:
            verdict = "failed"
        return verdict, sentence


def remark_of(directory):
    """That no end is in sight, where the run has said so."""
    try:
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            return "no end is in sight" if "no_end_in_sight" in json.load(file).get("notes", {}) else ""
    except OSError:
        return ""


def kind_of(sentence):
    """Sentences that differ in their numbers only are of one kind."""
    sentence = re.sub(r"\S*/scene\.prm: ", "", sentence)
    return re.sub(r"[-+]?\d[\d.e+-]*", "#", sentence)[:140]


def write(directory, counts, example, bad):
    os.makedirs(directory, exist_ok=True)
    for name, head, rows in (("verdicts.csv", ("scene", "verdict", "count", "first_seed", "sentence"),
                              [(s, v, n, example[s, v, k], k) for (s, v, k), n in sorted(counts.items())]),
                             ("bad.csv", ("seed", "scene", "verdict", "sentence", "settings"), bad)):
        with open(os.path.join(directory, name), "w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerows([head] + rows)


def read(directory):
    """What write() has written: counts, example, bad."""
    counts, example, bad = collections.Counter(), {}, []
    if os.path.exists(os.path.join(directory, "verdicts.csv")):
        with open(os.path.join(directory, "verdicts.csv"), newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                key = (row["scene"], row["verdict"], row["sentence"])
                counts[key], example[key] = int(row["count"]), int(row["first_seed"])
        with open(os.path.join(directory, "bad.csv"), newline="", encoding="utf-8") as file:
            bad = [tuple(row.values()) for row in csv.DictReader(file)]
    return counts, example, bad


def listed(program):
    """Names of all scenes."""
    text = subprocess.run([program, "list"], capture_output=True, text=True, check=True).stdout
    return [line for line in text.splitlines() if line and not line.startswith(" ")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-n", type=int, default=1000, help="how many scenes")
    parser.add_argument("--seed", type=int, default=1, help="of the first; the others follow")
    parser.add_argument("--time", type=float, default=10.0, help="CPU seconds before a scene is asked to stop")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--scenes", help="names, separated by commas (default: all)")
    parser.add_argument("-o", "--output", help="directory for verdicts.csv and bad.csv")
    parser.add_argument("--add", action="store_true", help="to what is in that directory: the seeds from --seed on, in pieces")
    parser.add_argument("--edges", action="store_true", help="every entry at its limits instead")
    parser.add_argument("--decades", action="store_true", help="numbers at 1e-6 ... 1e6 times their default instead: -n of these cases, drawn by --seed")
    parser.add_argument("--repeat", type=int, help="one seed, in full")
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "app", "turgor"))
    options = parser.parse_args()
    names = options.scenes.split(",") if options.scenes else listed(options.program)
    entries = {name: entries_of(options.program, name) for name in names}

    cases = [(name, settings) for name in names for settings in edges(name, entries[name])] if options.edges else []
    if options.decades:
        cases = [(name, settings) for name in names for settings in decades(name, entries[name])]
        cases = random.Random(options.seed).sample(cases, min(options.n, len(cases)))
    listed_cases = options.edges or options.decades
    first, count = (0, len(cases)) if listed_cases else (options.seed, options.n)

    def one(seed):
        if listed_cases:
            scene, settings = cases[seed]
            return (seed, scene) + run_scene(options.program, scene, settings, options.time) + (settings,)
        scene = names[seed % len(names)]
        return run_one(options.program, scene, entries[scene], seed, options.time)

    if options.repeat is not None:
        seed, scene, verdict, sentence, settings = one(options.repeat)
        print(f"{scene}: {verdict}\n{sentence}\n" + " ".join(f"--set '{name}={value}'" for name, value in settings.items()))
        return 0
    counts, example, bad = read(options.output) if options.add else (collections.Counter(), {}, [])
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done, result in enumerate(pool.map(one, range(first, first + count)), 1):
            seed, scene, verdict, sentence, settings = result
            key = (scene, verdict, kind_of(sentence))
            counts[key] += 1
            example.setdefault(key, seed)
            if verdict in BAD:
                bad.append((seed, scene, verdict, kind_of(sentence), json.dumps(settings)))
                print(f"seed {seed}: {scene}: {verdict}: {sentence}", flush=True)
            if done % 50 == 0:
                print(f"{done} of {count}", file=sys.stderr, flush=True)
            if options.output and (done % 50 == 0 or done == count):
                write(options.output, counts, example, bad)
    total = collections.Counter()
    for (_, verdict, _), n in counts.items():
        total[verdict] += n
    print(", ".join(f"{n} {verdict}" for verdict, n in total.most_common()))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
