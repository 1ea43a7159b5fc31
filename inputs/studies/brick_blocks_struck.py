#!/usr/bin/python3
"""Free blocks of the bricks of brick_strips.py struck by a plate at 5 m/s, as particles and as FE2 with free sides.

Verdict: while the front is on its way the struck plate feels 1.07 times as much in FE2 as from 16 x 16 bricks (8 x 8: 1.15, 6 x 6: 1.2 to 1.3), once it is
reflected both plates feel 1.2 to 1.3 times as much (8 x 8: 1.4 to 1.6, 6 x 6: 1.4 to 1.9). What is more than 1 falls with the size; strips without sides agree
within 4 % (strips.md), so it is free sides and domed ends, as in blocks pressed slowly (strips_free.md, 5 and 10 %: 1.27 to 1.30, 1.68 to 1.71, 1.96 to 2.02), and is not
folded into the law. Elements of 2 x 2 cells change single windows of 8 x 8 by up to 11 % of the struck plate. The other plate feels FE2 earlier: a front of elements is wider than that of walls and fluid, so its first two windows say little.

    /usr/bin/python3 inputs/studies/brick_blocks_struck.py        writes doc/results/rve/strips_free_struck.md

Particles: blocks of brick_blocks_free.py (tissue_impact, Sides = cut). FE2: a block with free sides, as wide and as high as its cells are in the RVE, an
element and an RVE a cell (tissue_bruise, as the struck strips of brick_strips.py); once with elements of 2 x 2 cells, so that the mesh is seen. No yielding, no failure. Force over the width of the inflated
block, which contains the bulges of its sides; strain is the plate's way over the block's height, domes included.
"""
import os

from brick_strips import CELL, STRIP, alone, mean_between, pairs, table
from runs import ROOT, no_choice, results, study

SIZES, SPEED, END = (6, 8, 16), 5, 0.2  # cells along a side, m/s, strain
WINDOWS = ((0.0, 0.05), (0.05, 0.1), (0.1, 0.15), (0.15, END))  # of strain
COARSE = 8, 2  # cells along a side, and along that of an element: once more with such a mesh


def of_elements(n, cells, column, row):
    height = n * row
    return "tissue_bruise", {
        **CELL, "Structure/Structure": "brick", "Structure/Gap": 0, "Structure/Rotation": 90, "Tissue/Lateral sides": "free", "Impact/Tool": "plate",
        "Impact/Motion": "steady", "Impact/Support": "plate", "Impact/Speed": SPEED, "Impact/Depth": END * height, "Impact/Contact stiffness": 4,
        "Impact/Outlined RVEs": 0, "Tissue/Width": height, "Tissue/Height": n * column, "Tissue/Elements x": n // cells, "Tissue/Elements y": n // cells,
        "Time/End time": END * height / SPEED, "Time/Output interval": 0.001 * height / SPEED, "Wall/Yielding": "none", "Wall/Critical stretch": 0,
        "Time/Shock viscosity": 1}


def wanted(column, row):
    """column, row: m, of FE2, the RVE's periods along a row and across rows."""
    for n in SIZES:
        yield f"particles_{n}", "tissue_impact", {
            **STRIP, "Columns": n, "Rows": n, "Structure/Gap": 0, "Sides": "cut", "Speed": SPEED, "End strain": END}
        yield f"fe2_{n}", *of_elements(n, 1, column, row)
    yield "fe2_coarse", *of_elements(*COARSE, column, row)


def means(curve):
    return [[mean_between(curve[0], curve[side], *window) for window in WINDOWS] for side in (1, 2)]


def line(words, values, run):
    return f"| {words} | {' | '.join(f'{a:.4g} / {b:.4g}' for a, b in zip(*values))} | {float(run['cpu_time_s']):.3g} |"


def main():
    no_choice(__doc__)
    rve = study("brick_strips_cost_alone", [run for run in alone("dense") if run[0].endswith("_rve")])["dense_rve"]
    column, row = results(rve)["period_xx"], results(rve)["period_yy"]
    runs = study("brick_blocks_struck", list(wanted(column, row)))
    for name, run in runs.items():
        if run["status"] != "finished":
            raise SystemExit(f"{name}: {run['message']}")
    lines = [*__doc__.strip().split("\n"), "",
             f"| kPa, struck plate / other plate | {' | '.join(f'{100 * a:g} to {100 * b:g} %' for a, b in WINDOWS)} | CPU s |",
             "|---|" + "---|" * (len(WINDOWS) + 1)]
    for n in SIZES:
        width = results(runs[f"particles_{n}"])["inflated_width"]
        loading = table(runs[f"particles_{n}"], "loading.csv")
        cells = means((loading["strain"], *([s / 1e3 for s in loading[f"stress_{side}"]] for side in ("upper", "lower"))))
        lines.append(line(f"{n} x {n}, particles", cells, runs[f"particles_{n}"]))
        for name, words in [(f"fe2_{n}", "FE2")] + ([("fe2_coarse", f"FE2, elements of {COARSE[1]} x {COARSE[1]} cells")] if n == COARSE[0] else []):
            hit = table(runs[name], "impact.csv")
            found = means(([s / (n * row) for s in hit["travel"]], *([f / width / 1e3 for f in hit[force]] for force in ("force", "transmitted_force"))))
            lines.append(line(f"{n} x {n}, {words}", found, runs[name]))
            ratio = [[f / p if p > 1 else float("nan") for f, p in zip(*both)] for both in zip(found, cells)]
            lines.append(f"| ... over particles | {' | '.join(pairs(*ratio))} | |")
    with open(os.path.join(ROOT, "doc", "results", "rve", "strips_free_struck.md"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
