"""How far single cells of the rod model come through fibre networks (thesis 6.4, Fig. 6.3B-E): pore size with and without degradation and for rigid cells, nucleus, stiffness, durotaxis.

  /usr/bin/python3 inputs/studies/rod_migration.py     doc/results/matrix/rods.csv, rods_said.csv and rods.png

Ten cells a row (100 of durotaxis), an hour each, in networks of their own; the seeds of a row are those of every other. Displacement: mean and the half width of its 95 % band
(Student's t). A statement of the thesis is "yes" or "no" where the difference of two means leaves out nothing at 95 % (Welch's t), "not told" where it does not.
The size of a cell is its diameter, 12 um. What a protrusion pulls with is not in the thesis: work limits of 1, 4 and 16 fJ are run, which are 1, 2 and 4 nN on the network's own
stiffness (F^2 = 2 K W, K = 0.5e-3 N/m); degradation, rigid cells, nuclei and moduli with 2 nN.
"""
import csv
import os
import sys

from runs import ROOT, no_choice, results, study, write_table

sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from drawing import ACCENT, ALONG, INK, plt, style  # noqa: E402

SIZE = 12e-6
PORES = [0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2]
NARROW = 0.4  # cell sizes, where nucleus and stiffness are varied
COMMON = {"Seeds": 10, "Frames": 0, "Network/Side": "1.2e-4"}
PULL = "Protrusion/Work limit"
FORCES = {1: {PULL: "1e-15"}, 2: {PULL: "4e-15"}, 4: {PULL: "1.6e-14"}}  # nN
KINDS = {"2 nN": FORCES[2], "1 nN": FORCES[1], "4 nN": FORCES[4], "2 nN, degradation 0.01/s": {**FORCES[2], "Network/Degradation": 0.01}, "2 nN, rigid cell": {**FORCES[2], "Cell/Modulus": "5e4"}}
PLAIN, MMP, RIGID = "2 nN", "2 nN, degradation 0.01/s", "2 nN, rigid cell"
NUCLEI = [1.5e-6, 3e-6, 4.5e-6, 5.5e-6]
MODULI = [150, 300, 500, 1000]
STEPS = [1, 10]
STUDENT = {9: 2.262, 99: 1.984}  # 97.5 % of Student's t


def wanted():
    """{label: (what is varied, series, its value, entries)}."""
    runs = {}

    def add(what, series, value, entries):
        runs[f"{what}_{list(KINDS).index(series)}_{value:g}"] = (what, series, value, {**KINDS[series], **entries})

    for series in KINDS:
        for pore in PORES:
            add("pore", series, pore, {"Network/Pore size": pore * SIZE})
    for series in (PLAIN, MMP):
        for radius in NUCLEI:
            add("nucleus", series, 1e6 * radius, {"Network/Pore size": NARROW * SIZE, "Cell/Nucleus radius": radius})
        for modulus in MODULI:
            add("modulus", series, modulus, {"Network/Pore size": NARROW * SIZE, "Cell/Modulus": modulus})
    for series in ("2 nN", "1 nN", "4 nN"):
        for step in STEPS:
            add("durotaxis", series, step, {"Network/Stiff side": step})
    return runs


def displacements(row):
    with open(os.path.join(row["directory"], "cells.csv"), newline="", encoding="utf-8") as file:
        return [1e6 * float(one["displacement [m]"]) for one in csv.DictReader(file)]


def mean_and_variance(values):
    mean = sum(values) / len(values)
    return mean, sum((one - mean) ** 2 for one in values) / (len(values) - 1)


def row_of(what, series, value, row):
    said = {"varied": what, "series": series, "value": f"{value:g}"}
    if row["status"] != "finished":
        return {**said, "failed": row["message"]}
    run = results(row)
    mean, variance = mean_and_variance(displacements(row))
    n = int(run["cells"])
    return {**said, "cells": n, "displacement um": f"{mean:.3g}", "95 % band um": f"{STUDENT[n - 1] * (variance / n) ** 0.5:.2g}", "path um": f"{1e6 * run['path']:.3g}", "rod length um": f"{1e6 * run['rod_length']:.3g}",
            "protrusions": f"{run['protrusions']:.3g}", "rounded up": f"{run['rounded_up']:.3g}", "at border": f"{run['at_border']:g}", "right share": f"{run['right_share']:.3g}", "right share low": f"{run['right_share_low']:.3g}",
            "right share high": f"{run['right_share_high']:.3g}", "right shift um": f"{1e6 * run['right_shift']:.3g}", "its error um": f"{1e6 * run['right_shift_error']:.2g}", "energy lost": f"{run['energy_lost']:.2g}", "cpu s": f"{float(row['cpu_time_s']):.3g}", "failed": ""}


def compared(first, second):
    """"more", "less" or "not told": the first mean against the second; with their difference (um) and its 95 % half width (Welch, t of the fewer cells)."""
    (a, va), (b, vb) = mean_and_variance(first), mean_and_variance(second)
    half = STUDENT[min(len(first), len(second)) - 1] * (va / len(first) + vb / len(second)) ** 0.5
    return ("more" if a - b > half else "less" if b - a > half else "not told"), a - b, half


def statements(rows, runs):
    """Rows of rods_said.csv."""
    found = {}
    for label, (what, series, value, _) in runs.items():
        if rows[label]["status"] == "finished":
            found[what, series, value] = displacements(rows[label])
    said = []

    def ask(statement, first, second, expected):
        if first in found and second in found:
            answer, difference, half = compared(found[first], found[second])
            said.append({"statement": statement, "first": f"{first[1]} {first[2]:g}", "second": f"{second[1]} {second[2]:g}", "difference um": f"{difference:.3g}", "95 % half width um": f"{half:.2g}",
                         "answer": "yes" if answer == expected else answer if answer == "not told" else "no"})

    for series in ("1 nN", "2 nN", "4 nN"):
        soft = {pore: sum(found["pore", series, pore]) for pore in PORES if ("pore", series, pore) in found}
        best = max(soft, key=soft.get)
        for end in (PORES[0], PORES[-1]):
            ask("an optimum of the pore size: farther at the best than at the ends", ("pore", series, best), ("pore", series, end), "more")
    for pore in PORES:
        ask("degradation helps in small pores (and only there)", ("pore", MMP, pore), ("pore", PLAIN, pore), "more")
    for pore in PORES:
        ask("rigid cells go less far", ("pore", RIGID, pore), ("pore", PLAIN, pore), "less")
    for series in (PLAIN, MMP):
        ask("a larger nucleus goes less far (largest against smallest)", ("nucleus", series, 1e6 * NUCLEI[-1]), ("nucleus", series, 1e6 * NUCLEI[0]), "less")
        ask("a stiffer cell goes less far (1000 against 150 Pa)", ("modulus", series, MODULI[-1]), ("modulus", series, MODULI[0]), "less")
    for label, (what, series, step, _) in runs.items():
        if what == "durotaxis" and rows[label]["status"] == "finished":
            run = results(rows[label])
            said.append({"statement": f"most cells go to the right side, {step} times as stiff, {series}", "first": f"share {run['right_share']:.3g}", "second": f"95 %: {run['right_share_low']:.3g} to {run['right_share_high']:.3g}",
                         "difference um": f"{1e6 * run['right_shift']:.3g}", "95 % half width um": f"{1.984e6 * run['right_shift_error']:.2g}", "answer": "yes" if run["right_share_low"] > 0.5 else "no" if run["right_share_high"] < 0.5 else "not told"})
    return said


def draw(table):
    figure, axes = plt.subplots(1, 3, figsize=(14.5, 4.6), facecolor="white")
    panels = (("pore", "pore size over the cell's diameter", list(KINDS)), ("nucleus", f"radius of the nucleus [µm] (cell: 6), pores of {NARROW:g} diameters", [PLAIN, MMP]),
              ("modulus", f"modulus of the cell [Pa], pores of {NARROW:g} diameters", [PLAIN, MMP]))
    for axis, (what, label, kinds) in zip(axes, panels):
        for kind in kinds:
            k = list(KINDS).index(kind)
            kept = [row for row in table if row["varied"] == what and row["series"] == kind and not row["failed"]]
            x = [float(row["value"]) * (1 + 0.012 * (k - 2)) for row in kept]  # bands beside each other
            y, band = ([float(row[name]) for row in kept] for name in ("displacement um", "95 % band um"))
            axis.errorbar(x, y, yerr=band, color=(ALONG, "#9db8d2", "#1b2f4a", ACCENT, "#8a8a8a")[k], marker="ov^sD"[k], markersize=4, linewidth=1.2, capsize=2, label=kind)
        axis.set_xlabel(label, color=INK, fontsize=9)
        axis.set_ylim(bottom=0)
        axis.legend(frameon=True, edgecolor="none", framealpha=1, fontsize=8)
        style(axis)
    axes[0].set_ylabel("displacement after an hour [µm]\nmean of ten cells and its 95 % band", color=INK, fontsize=9)
    figure.tight_layout()
    figure.savefig(os.path.join(ROOT, "doc", "results", "matrix", "rods.png"), dpi=140)


def main():
    no_choice(__doc__)
    runs = wanted()
    rows = study("rod_migration", [(label, "durotaxis" if what == "durotaxis" else "rod_migration", entries if what == "durotaxis" else {**COMMON, **entries}) for label, (what, _, _, entries) in runs.items()])
    table = [row_of(what, series, value, rows[label]) for label, (what, series, value, _) in runs.items()]
    write_table("matrix/rods.csv", table)
    said = statements(rows, runs)
    write_table("matrix/rods_said.csv", said)
    for row in said:
        print(", ".join(f"{name}: {value}" for name, value in row.items()))
    draw(table)
    return 1 if any(row["failed"] for row in table) else 0


if __name__ == "__main__":
    sys.exit(main())
