#!/usr/bin/python3
"""Free blocks of the bricks of brick_strips.py struck by a plate at 5 m/s, as particles and as FE2 with free sides.

Verdict: while the front is on its way the struck plate feels 1.1 to 1.2 times as much in FE2 as from 16 x 16 bricks, once it is reflected both plates feel 1.2 to 1.3
times as much (8 x 8: 1.3 to 1.7, 6 x 6: 1.5 to 1.9). Free sides and domed ends take it, as in blocks pressed slowly (strips_free.md: 1.2 to 1.3, 1.5 to
1.7, 1.8 to 2.0 for the same sizes); strips without sides agree within 4 % (strips.md). It falls with the block's size and is not folded into the law.
The other plate feels FE2 earlier: a front of elements of two cells is wider than that of walls and fluid, so the first two windows say little there.

    /usr/bin/python3 inputs/studies/brick_blocks_struck.py        writes doc/results/rve/strips_free_struck.md

Particles: blocks of brick_blocks_free.py (tissue_impact, Sides = cut). FE2: a block with free sides, as wide and as high as its cells, elements of 2 x 2
cells, one cell an RVE (tissue_bruise, as the struck strips of brick_strips.py). No yielding, no failure. Force over the width of the inflated
block, which contains the bulges of its sides; strain is the plate's way over the block's height, domes included.
"""
import os

from brick_strips import CELL, STRIP, alone, mean_between, pairs, table
from runs import ROOT, no_choice, results, study

SIZES, SPEED, END = (6, 8, 16), 5, 0.2  # cells along a side, m/s, strain
WINDOWS = ((0.0, 0.05), (0.05, 0.1), (0.1, 0.15), (0.15, END))  # of strain
COLUMN = 1e-4  # m, of a brick along its row


def wanted(row):
    """row: m, height of a row of FE2, the RVE's period across rows."""
    for n in SIZES:
        height = n * row
        yield f"particles_{n}", "tissue_impact", {
            **STRIP, "Columns": n, "Rows": n, "Structure/Gap": 0, "Sides": "cut", "Speed": SPEED, "End strain": END}
        yield f"fe2_{n}", "tissue_bruise", {
            **CELL, "Structure/Structure": "brick", "Structure/Gap": 0, "Structure/Rotation": 90, "Tissue/Lateral sides": "free", "Impact/Tool": "plate",
            "Impact/Motion": "steady", "Impact/Support": "plate", "Impact/Speed": SPEED, "Impact/Depth": END * height, "Impact/Contact stiffness": 4,
            "Impact/Outlined RVEs": 0, "Tissue/Width": height, "Tissue/Height": n * COLUMN, "Tissue/Elements x": n // 2, "Tissue/Elements y": n // 2,
            "Time/End time": END * height / SPEED, "Time/Output interval": 0.001 * height / SPEED, "Wall/Yielding": "none",
            "Wall/Critical stretch": 0, "Time/Shock viscosity": 1}


def main():
    no_choice(__doc__)
    rve = study("brick_strips_cost_alone", [run for run in alone("dense") if run[0].endswith("_rve")])["dense_rve"]
    row = results(rve)["period_yy"]
    runs = study("brick_blocks_struck", list(wanted(row)))
    for name, run in runs.items():
        if run["status"] != "finished":
            raise SystemExit(f"{name}: {run['message']}")
    lines = [*__doc__.strip().split("\n"), "",
             f"| kPa, struck plate / other plate | {' | '.join(f'{100 * a:g} to {100 * b:g} %' for a, b in WINDOWS)} | CPU s |",
             "|---|" + "---|" * (len(WINDOWS) + 1)]
    for n in SIZES:
        width = results(runs[f"particles_{n}"])["inflated_width"]
        loading, hit = table(runs[f"particles_{n}"], "loading.csv"), table(runs[f"fe2_{n}"], "impact.csv")
        curve = {"particles": (loading["strain"], [s / 1e3 for s in loading["stress_upper"]], [s / 1e3 for s in loading["stress_lower"]]),
                 "fe2": ([s / (n * row) for s in hit["travel"]], [f / width / 1e3 for f in hit["force"]], [f / width / 1e3 for f in hit["transmitted_force"]])}
        means = {name: [[mean_between(of[0], of[side], *window) for window in WINDOWS] for side in (1, 2)] for name, of in curve.items()}
        for name, words in (("particles", "particles"), ("fe2", "FE2")):
            lines.append(f"| {n} x {n}, {words} | {' | '.join(f'{a:.4g} / {b:.4g}' for a, b in zip(*means[name]))} | "
                         f"{float(runs[f'{name}_{n}']['cpu_time_s']):.3g} |")
        ratio = [[f / p if p > 1 else float("nan") for f, p in zip(*both)] for both in zip(means["fe2"], means["particles"])]
        lines.append(f"| ... FE2 over particles | {' | '.join(pairs(*ratio))} | |")
    with open(os.path.join(ROOT, "doc", "results", "rve", "strips_free_struck.md"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
