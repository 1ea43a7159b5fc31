#!/usr/bin/python3
"""RVEs of particles, one cell against several and against turned ones, over five seeds: shear stress and what is left at F = I.

    /usr/bin/python3 inputs/studies/sph_layouts.py        writes doc/results/rve/sph_layouts.md, three minutes of CPU time

Simple shear of 15 % in calls of 7.5 %, elastic equilibrium at a residual of 2e-3. Of a turned layout the shear turns with it and the stress is turned
back. Differences are from the single cell of the same layout: mean over the seeds and its error, from the scatter of both.

Verdict: copies of one cell repeat it, and a turned tissue its upright one, as they must: cells here are copies of one that is annealed, and fluid is turned
with its walls, so that both rows check the code and no more. Cells with packings of their own were not tried. What the packing amounts to was seen when
fluid was laid anew in turned walls, in rows that no longer ran along them: 0.19 +- 0.08 % (square) and 0.25 +- 0.09 % (brick) more stress. 4e-4
of turgor are left at F = I before any path (asked: 1e-3). Errors in the table are those of two independent samples, which copies are not.
"""
import csv
import math
import os
import statistics
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from runs import ROOT, no_choice, study  # noqa: E402

OUT = os.path.join(ROOT, "doc", "results", "rve", "sph_layouts.md")
SEEDS = (1, 2, 3, 4, 5)
LAYOUTS = [("square", 1, 1, 0), ("square", 2, 1, 0), ("square", 2, 2, 0), ("square", 1, 1, 30), ("brick", 1, 1, 0), ("brick", 1, 1, 30)]
TURGOR = 200e3  # Pa, default


def product(*factors):
    result = factors[0]
    for b in factors[1:]:
        result = [[sum(result[i][k] * b[k][j] for k in (0, 1)) for j in (0, 1)] for i in (0, 1)]
    return result


def turn(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[c, -s], [s, c]]


def label(layout, seed):
    return "{}_{}x{}_{}".format(*layout) + f"_seed_{seed}"


def run(layout, seed):
    kind, columns, rows, degrees = layout
    F = product(turn(degrees), [[1, 0.15], [0, 1]], turn(-degrees))
    text = "; ".join(", ".join(repr(value) for value in row) for row in F)
    return (label(layout, seed), "rve_response",
            {"Structure/Structure": kind, "Structure/Rotation": degrees, "RVE/Columns": columns, "RVE/Rows": rows, "RVE/Fluid": "sph", "SPH/Seed": seed,
             "RVE/Tolerance": 2e-3, "RVE/Relax steps": 100000, "Path/Keyframes": f"0 : 1, 0; 0, 1 | 1 : {text}", "Path/F_dot": "0, 0; 0, 0", "Path/Points": 3})


def stresses(row, degrees):
    """(at F = I, at the end): xx, xy, yy in Pa, turned back."""
    if row["status"] != "finished":
        raise SystemExit(f"{row['run']}: {row['message']}")
    with open(os.path.join(row["directory"], "stress.csv"), newline="", encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    found = []
    for line in (table[0], table[-1]):
        sigma = [[float(line[f"sigma_{a}{b} [Pa]"]) for b in "xy"] for a in "xy"]
        back = product(turn(-degrees), sigma, turn(degrees))
        found.append((back[0][0], back[0][1], back[1][1]))
    return found


def main():
    no_choice(__doc__)
    rows = study("sph_layouts", [run(layout, seed) for layout in LAYOUTS for seed in SEEDS])
    lines = [__doc__.strip(), "",
             "| cells | shear stress at 15 %, kPa | against one cell | sigma_xx - sigma_yy at 15 %, kPa | most of a stress component left at F = I, over turgor | CPU s a call |",
             "|---|---|---|---|---|---|"]
    single = {}
    for layout in LAYOUTS:
        kind, columns, n_rows, degrees = layout
        found = [stresses(rows[label(layout, seed)], degrees) for seed in SEEDS]
        shear = [end[1] for _, end in found]
        single.setdefault(kind, shear)
        mean, one = statistics.mean(shear), statistics.mean(single[kind])
        error = math.hypot(statistics.stdev(shear), statistics.stdev(single[kind])) / math.sqrt(len(SEEDS))
        normal = [end[0] - end[2] for _, end in found]
        left = max(max(abs(value) for value in start) for start, _ in found) / TURGOR
        cost = statistics.mean(float(rows[label(layout, seed)]["cpu_time_per_evaluation [s]"]) for seed in SEEDS)
        against = "-" if shear is single[kind] else f"{100 * (mean / one - 1):+.2f} +- {100 * error / one:.2f} %"
        lines.append(f"| {kind}, {columns} x {n_rows}{f', turned by {degrees} degrees' if degrees else ''} | {mean / 1e3:.2f} +- "
                     f"{statistics.stdev(shear) / 1e3 / math.sqrt(len(SEEDS)):.2f} | {against} | {statistics.mean(normal) / 1e3:.2f} +- "
                     f"{statistics.stdev(normal) / 1e3 / math.sqrt(len(SEEDS)):.2f} | {left:.1e} | {cost:.2f} |")
    with open(OUT, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
