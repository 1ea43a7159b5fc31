"""Where the scenes of centre-based cells break: one entry at a time driven up and down until a run fails or is refused.

  python3 inputs/studies/spheroid_extremes.py all [--program build/app/turgor] [--directory runs] [--only-table]

Small scenes of one to ten seconds: a capsule of R = 30 um for a day after confluence, 100 cells under 5 kPa of dextran for two days, a monolayer for three
days, 60 cells that relax. The table goes to doc/results/spheroid/extremes.csv: what a run ended with, its CPU time, or the sentence it failed with.
"""
import csv
import os
import re

from table_of_runs import ROOT, options_of, row_of, run_all

BASE = {
    "spheroid_capsule": {"First cells": 30, "Capsule/Radius": 3e-5, "Capsule/Thickness": 2.4e-6, "Capsule/Time confined": 86400, "Duration": 600000,
                         "Frames": 0, "Checkpoints": 2},
    "spheroid_dextran": {"First cells": 100, "Duration": 172800, "Frames": 0, "Checkpoints": 2},
    "monolayer": {"Duration": 259200, "Frames": 0, "Checkpoints": 2},
    "spheroid_relaxation": {"First cells": 60, "Frames": 0, "Checkpoints": 2},
    "spheroid_free": {"Duration": 259200, "Frames": 0, "Checkpoints": 2},
}
DRIVEN = [
    ("spheroid_capsule", "Cell/Modulus", (4.5e1, 4.5e3, 4.5e5, 4.5e7)),
    ("spheroid_capsule", "Cell/Bulk modulus", (100, 1000, 1e5, 1e7)),
    ("spheroid_capsule", "Contact/Medium friction", (5e4, 5e6, 5e10, 5e12)),
    ("spheroid_capsule", "Contact/Normal friction", (0, 5e7, 5e13)),
    ("spheroid_capsule", "Contact/Adhesion", (1e-6, 2.7e-4)),
    ("spheroid_capsule", "Contact/Local stiffness", ("none", "closest", "B19")),
    ("spheroid_capsule", "Capsule/Modulus", (1e2, 1e3, 1e6, 1e9)),
    ("spheroid_capsule", "Capsule/Thickness", (1e-7, 3e-5, 1e-3)),
    ("spheroid_capsule", "Motion/Tolerance", (1e-4, 1e-1, 1)),
    ("spheroid_capsule", "Motion/Growth tolerance", (1e-3, 5e-2, 1e-1)),
    ("spheroid_capsule", "Motion/Method", ("euler", "heun")),
    ("spheroid_capsule", "Cell/Cycle time", (12000, 600000)),
    ("spheroid_capsule", "Motion/Motility", (1e-14, 1e-12)),
    ("spheroid_capsule", "Motion/Migration force", (1e-9, 1e-8, 1e-7)),
    ("spheroid_capsule", "Cell/Variability", (0, 0.24)),
    ("spheroid_dextran", "Dextran/Pressure", (100, 2e4, 5e4)),
    ("spheroid_dextran", "Cell/Modulus", (45, 4.5e4)),
    ("spheroid_dextran", "Cell/Bulk modulus", (500, 1e6)),
    ("spheroid_dextran", "Contact/Local stiffness", ("closest",)),
    ("spheroid_dextran", "Contact/Medium friction", (5e5, 5e10)),
    ("monolayer", "Cell/Modulus", (45, 4.5e5)),
    ("monolayer", "Contact/Medium friction", (5e6, 5e12)),
    ("monolayer", "Motion/Migration force", (1e-9, 1e-8)),
    ("spheroid_relaxation", "Compressed size", (0.8, 0.6, 0.5)),
    ("spheroid_relaxation", "Cell/Modulus", (4.5, 4.5e6)),
    ("spheroid_free", "Contact/Adhesion", (1e-6, 2e-4, 2.7e-4)),
    ("spheroid_free", "Motion/Growth tolerance", (1e-4, 1e-1)),
]


def runs():
    for scene, base in BASE.items():
        yield scene, scene, base
    for scene, entry, values in DRIVEN:
        for value in values:
            yield re.sub(r"[ /]", "_", f"{scene}_{entry}_{value}"), scene, {**BASE[scene], entry: value}


def main():
    options = options_of(["all"], __doc__)
    options.study = "spheroid_extremes"
    columns = ["run", "cpu_time_s", "cells", "pressure [Pa]", "radius [m]", "steps", "rejected_steps", "failed"]
    with open(os.path.join(ROOT, "doc", "results", "spheroid", "extremes.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, columns, extrasaction="ignore")
        table.writeheader()
        for label, place, failed in run_all(options, runs()):
            table.writerow(row_of(label, place, failed))


if __name__ == "__main__":
    main()
