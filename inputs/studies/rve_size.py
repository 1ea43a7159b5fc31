#!/usr/bin/python3
"""How many cells an RVE needs: 1 ... n cells a side, seeds, and three boundaries, of Laguerre cells and of bricks.

    /usr/bin/python3 inputs/studies/rve_size.py        writes doc/results/rve/size.md, size.csv and size.png, some minutes of CPU time

100 um before turgor, 12 nodes a side, lamella ratio 1, turgor 200 kPa, dense. Each run: moduli at rest, then pressed along y by 5 % with free sides in
steps of 1 %. Boundaries: uniform_traction (softest), periodic, linear_displacement (stiffest), windows cut along walls. Mean over the seeds and its
95 % confidence (Student's t); moduli are means over all directions. In order: of how many seeds Young's and shear moduli in every direction rise from
the first boundary to the last, as theory has it (energies: tests/rve/test_boundary.cc).

Answer: periodic Laguerre cells have Young's moduli of 1.23, 1.47 and 1.54 MPa with 4, 9 and 16 cells, the last +- 13 %: not settled at 16. The band is that of
the mean of four seeds; it does not show the bias of a small RVE. Bricks (jitter 0.06 here) have 1.29, 1.30, 1.31 MPa with 1, 4, 9: one cell is enough.
"""
import csv
import math
import os
import sys

from runs import ROOT, no_choice, study, write_table

sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
BOUNDARIES = ("uniform_traction", "periodic", "linear_displacement")
CELL = {"Cell/Period": 100e-6, "Cell/Nodes per side": 12, "Cell/Lamella ratio": 1, "Cell/Fluid viscosity": 0, "Path/F_dot": "0, 0; 0, 0", "Path/Points": 6,
        "Path/Keyframes": "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.95", "Path/Stress components": "xx"}
TISSUES = {"voronoi": ({"Structure/Structure": "voronoi"}, (2, 3, 4), (1, 2, 3, 4)),
           "brick": ({"Structure/Structure": "brick", "Structure/Corner jitter": 0.06}, (1, 2, 3), (1, 2, 3))}
QUANTITIES = (("young", "Young's modulus [MPa]"), ("shear", "shear modulus [kPa]"), ("pressed", "stress at 5 %, sides free [kPa]"))
T95 = {2: 12.706, 3: 4.303, 4: 3.182, 5: 2.776, 6: 2.571}


def label(tissue, n, seed, boundary):
    return f"{tissue}_{n}_{seed}_{boundary}"


def entries(tissue, n, seed, boundary):
    return {**CELL, **TISSUES[tissue][0], "Structure/Structure seed": seed, "RVE/Columns": n, "RVE/Rows": n, "RVE/Boundary": boundary}


def cases():
    for tissue, (_, sizes, seeds) in TISSUES.items():
        for n in sizes:
            for seed in seeds:
                yield tissue, n, seed


def rows_of(run, name):
    with open(os.path.join(run["directory"], name + ".csv"), newline="", encoding="utf-8") as file:
        return [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def numbers(run):
    polar, last = rows_of(run, "polar"), rows_of(run, "stress")[-1]
    mean = lambda name: sum(row[name] for row in polar) / len(polar)  # noqa: E731
    return {"young": mean("young_modulus") / 1e6, "shear": mean("shear_modulus") / 1e3, "pressed": -last["P_yy"] / 1e3,
            "all": [row[name] for row in polar for name in ("young_modulus", "shear_modulus")]}


def in_order(found, case):
    """Whether every modulus rises from the softest boundary to the stiffest."""
    return all(soft <= mid * (1 + 1e-9) and mid <= stiff * (1 + 1e-9) for soft, mid, stiff in zip(*(found[(*case, one)]["all"] for one in BOUNDARIES)))


def checked(runs):
    failed = [f"{name}: {run['message']}" for name, run in runs.items() if run["status"] != "finished"]
    if failed:
        raise SystemExit("\n".join(failed))
    return runs


def mean_and_band(values):
    mean = sum(values) / len(values)
    spread = math.sqrt(sum((v - mean) ** 2 for v in values) / (len(values) - 1))
    return mean, T95[len(values)] * spread / math.sqrt(len(values))


def table(found):
    for tissue, (_, sizes, seeds) in TISSUES.items():
        for n in sizes:
            for boundary in BOUNDARIES:
                row = {"tissue": tissue, "cells": n * n, "seeds": len(seeds), "boundary": boundary}
                for name, _ in QUANTITIES:
                    row[name], row[name + "_band"] = mean_and_band([found[tissue, n, seed, boundary][name] for seed in seeds])
                row["in_order"] = sum(in_order(found, (tissue, n, seed)) for seed in seeds)
                yield row


def draw(rows):
    from drawing import ACCENT, INK, plt, style
    colours = dict(zip(BOUNDARIES, ("#6b8e4e", INK, ACCENT)))
    figure, axes = plt.subplots(len(TISSUES), len(QUANTITIES), figsize=(13, 7.6), layout="constrained", squeeze=False)
    for line, tissue in zip(axes, TISSUES):
        for axis, (name, words) in zip(line, QUANTITIES):
            for boundary in BOUNDARIES:
                mine = [row for row in rows if row["tissue"] == tissue and row["boundary"] == boundary]
                x, y, band = ([row[key] for row in mine] for key in ("cells", name, name + "_band"))
                axis.plot(x, y, "o-", color=colours[boundary], markersize=4, linewidth=1.8, label=boundary.replace("_", " "))
                axis.fill_between(x, [a - b for a, b in zip(y, band)], [a + b for a, b in zip(y, band)], color=colours[boundary], alpha=0.16, linewidth=0)
            axis.set_xscale("log", base=2)
            axis.set_xticks(sorted({row["cells"] for row in rows if row["tissue"] == tissue}))
            axis.xaxis.set_major_formatter("{x:g}")
            axis.minorticks_off()
            axis.set_ylim(bottom=0)
            axis.set_xlabel(f"cells of the RVE ({tissue})", color=INK)
            axis.set_ylabel(words, color=INK)
            style(axis)
    axes[0, 0].legend(frameon=False, fontsize=9, loc="center left", bbox_to_anchor=(0.02, 0.44))
    figure.suptitle("What an RVE says against how many cells it has, and what holds its boundary: mean over seeds, band: 95 % confidence of the mean",
                    color=INK, fontsize=12)
    figure.savefig(os.path.join(ROOT, "doc", "results", "rve", "size.png"), dpi=110)
    plt.close(figure)


def main():
    no_choice(__doc__)
    runs = checked(study("rve_size", [(label(*case, boundary), "rve_response", entries(*case, boundary)) for case in cases() for boundary in BOUNDARIES]))
    found = {(*case, boundary): numbers(runs[label(*case, boundary)]) for case in cases() for boundary in BOUNDARIES}
    rows = list(table(found))
    write_table("rve/size.csv", [{key: f"{value:.5g}" if isinstance(value, float) else value for key, value in row.items()} for row in rows])
    head, _, rest = __doc__.partition("\n\n")
    lines = ["# " + head, "", *rest.strip().split("\n"), "", "![mean and band](size.png)", "",
             "| tissue | cells | boundary | " + " | ".join(words for _, words in QUANTITIES) + " | in order |", "|---|---|---|---|---|---|---|"]
    for row in rows:
        lines.append(f"| {row['tissue']} | {row['cells']} | {row['boundary'].replace('_', ' ')} | " +
                     " | ".join(f"{row[name]:.4g} +- {row[name + '_band']:.2g}" for name, _ in QUANTITIES) + f" | {row['in_order']} of {row['seeds']} |")
    with open(os.path.join(ROOT, "doc", "results", "rve", "size.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    print("\n".join(lines))
    draw(rows)


if __name__ == "__main__":
    main()
