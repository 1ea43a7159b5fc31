#!/usr/bin/python3
"""Tables and pictures of what tissue_impact_matrix.py has measured.

    /usr/bin/python3 inputs/studies/tissue_impact_figures.py [cells]

Prints the tables of its README (Markdown) and writes failure.png (share of failed cells over strain, a logistic curve fitted to the
mean of the tissues: share = F/(1 + exp(-(strain - e0)/w))), impact.png (force on both plates) and compression.png (stress, and
modulus over void fraction) beside the tables. What has not been run is left out.
cells: of runs made by tissue_impact_matrix.py --fields also the cells themselves, at true scale: PART_cells.png.
"""
import csv
import os
import re
import sys

import matplotlib
import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from aggregate import draw  # noqa: E402
from drawing import ACCENT, ALONG, INK, plt, read_table, style  # noqa: E402
from fields import frames  # noqa: E402

CELLS = 25


def read(directory, part):
    """{run: results}, {run: {column: array}}; runs that ended with a sentence are left out."""
    def rows(name):
        path = os.path.join(directory, name)
        if not os.path.exists(path):
            return []
        with open(path, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))
    results = {r["run"]: {k: float(v) for k, v in r.items() if v and k not in ("run", "status", "failed")}
               for r in rows(part + ".csv") if not r.get("failed") and r.get("status", "finished") == "finished"}
    curves = {}
    for row in rows(part + "_curves.csv"):
        for name, value in row.items():
            if name != "run":
                curves.setdefault(row["run"], {}).setdefault(name, []).append(float(value))
    return results, {run: {k: np.array(v) for k, v in curve.items()} for run, curve in curves.items()}


def logistic(strain, share):
    """F, e0, w and the share of the variance that the curve explains; least squares on a grid of e0 and w."""
    best = None
    for e0 in np.linspace(0.02, 0.3, 141):
        for w in np.geomspace(0.002, 0.1, 60):
            shape = 1 / (1 + np.exp(-(strain - e0) / w))
            height = min(1.0, (shape @ share) / (shape @ shape))
            left = ((share - height * shape) ** 2).sum()
            if best is None or left < best[0]:
                best = (left, height, e0, w)
    return best[1], best[2], best[3], 1 - best[0] / ((share - share.mean()) ** 2).sum()


def table(head, lines):
    print("| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    for line in lines:
        print("| " + " | ".join(line) + " |")
    print()


def spread(values, scale=1.0, digits=3):
    """mean +- its standard error (least ... most)"""
    values = [scale * v for v in values]
    if not values:
        return "-"
    text = "%.*g" % (digits, np.mean(values))
    if len(values) == 1:
        return text
    return text + " +- %.2g (%.*g ... %.*g)" % (np.std(values, ddof=1) / len(values) ** 0.5, digits, min(values), digits, max(values))


def failure(directory):
    results, curves = read(directory, "failure")
    kinds = {}
    for run in results:
        kinds.setdefault(re.sub(", tissue [0-9]", "", run), []).append(run)
    if not kinds:
        return
    at = np.linspace(0, 0.299, 150)
    shown = {k: r for k, r in kinds.items() if re.fullmatch(".*viscosity x 10*", k)}
    figure, axes = plt.subplots(1, max(1, len(shown)), figsize=(3.1 * max(1, len(shown)), 2.9), sharey=True, squeeze=False)
    lines = []
    panel = 0
    for kind, runs in kinds.items():
        def of(name):
            return [results[r][name] for r in runs if name in results[r]]
        shares = np.array([np.interp(at, curves[r]["strain [1]"], curves[r]["failed_cells"] / CELLS) for r in runs])
        F, e0, w, explained = logistic(at, shares.mean(axis=0)) if shares.max() > 0.1 else (0, 0, 0, 0)
        first = [e for e in of("strain_at_first_failure") if e >= 0]
        peel = [(results[r]["first_ties_from_wall_end"], results[r]["last_ties_from_wall_end"]) for r in runs if results[r].get("broken_ties", 0) >= 10]
        lines.append([kind, str(len(runs)), spread(first, 100), spread(of("strain_at_50_percent_of_failures"), 100), spread(of("failed_share"), 100),
                      "%.3g, %.2g, %.2f" % (100 * e0, 100 * w, explained) if F else "-",
                      spread(of("failed_depth_first"), 1, 2), spread(of("failed_depth"), 1, 2), spread(of("broken_bonds_at_junctions"), 100, 2),
                      spread(of("broken_ties")), "; ".join("%.0f, %.0f" % (1e6 * a, 1e6 * b) for a, b in peel) or "-",
                      "%.1g" % max(abs(x) for x in of("energy_balance_error")), "%g" % max(of("most_crossed_bonds"))])
        if kind in shown:
            axis = axes[0][panel]
            for share in shares:
                axis.plot(100 * at, 100 * share, color=ALONG, linewidth=0.8, alpha=0.6)
            axis.plot(100 * at, 100 * shares.mean(axis=0), color=INK, linewidth=1.8, label="mean of %d tissues" % len(runs) if len(runs) > 1 else "one tissue")
            if F:
                axis.plot(100 * at, 100 * F / (1 + np.exp(-(at - e0) / w)), "--", color=ACCENT, linewidth=1.4, label="logistic")
            axis.set_title(kind, fontsize=9, color=INK)
            axis.set_xlabel("strain [%]", fontsize=9, color=INK)
            axis.legend(frameon=False, fontsize=8, loc="upper left")
            axis.set_ylim(0, 100)
            style(axis)
            panel += 1
    axes[0][0].set_ylabel("failed cells [%]", fontsize=9, color=INK)
    figure.tight_layout()
    figure.savefig(os.path.join(directory, "failure.png"), dpi=130)
    table(["tissue", "runs", "first failure, % strain", "half of the failures, %", "failed at the end, %", "logistic: e0 %, w %, R^2", "depth of the first quarter",
           "depth at the end", "broken bonds at junctions, %", "broken ties", "ties from the end of their wall, first and last fifth, um", "energy balance, most", "crossed bonds"], lines)


def impact(directory):
    results, curves = read(directory, "impact")
    names = [("centre_of_flattening_at_5_percent", 1, "centre of flattening at 5 %"), ("centre_of_flattening_at_10_percent", 1, "at 10 %"),
             ("flattest_cell_at_5_percent", 100, "flattest cell at 5 %, %"), ("stretch_near_plate_at_5_percent", 1, "stretch below the plate at 5 %"),
             ("stress_lower_at_5_percent", 1e-3, "transmitted at 5 %, kPa"), ("stress_lower_at_10_percent", 1e-3, "at 10 %, kPa"),
             ("largest_stress_lower", 1e-6, "peak, MPa"), ("stress_lower_oscillation", 1, "falls over range"),
             ("largest_stretch_at_10_percent", 1, "largest stretch at 10 %"), ("energy_balance_error", 1, "energy balance"),
             ("most_crossed_bonds", 1, "crossed bonds")]
    table(["run"] + [n[2] for n in names], [[run] + ["%.3g" % (scale * r[name]) if scale != 1 or "stretch" not in name else "%.3f" % r[name]
                                                     for name, scale, _ in names] for run, r in results.items()])
    chosen = [(s, w) for s in ("dense", "sparse") for w in (1, 10) if any(r.startswith("%s, wall x %d," % (s, w)) for r in results)]
    if not chosen:
        return
    figure, axes = plt.subplots(1, len(chosen), figsize=(3.4 * len(chosen), 2.9), squeeze=False)
    for axis, (structure, wall) in zip(axes[0], chosen):
        for k, viscosity in enumerate((1, 10, 100, 1000)):
            curve = curves.get("%s, wall x %d, viscosity x %d" % (structure, wall, viscosity))
            if curve:
                axis.plot(100 * curve["strain [1]"], curve["stress_lower [Pa]"] / 1e6, color=plt.get_cmap("viridis")(0.28 * k), linewidth=1.4,
                          label="viscosity x %d" % viscosity)
        axis.set_title("%s, wall x %d" % (structure, wall), fontsize=9, color=INK)
        axis.set_xlabel("strain [%]", fontsize=9, color=INK)
        axis.legend(frameon=False, fontsize=8)
        style(axis)
    axes[0][0].set_ylabel("transmitted stress [MPa]", fontsize=9, color=INK)
    figure.tight_layout()
    figure.savefig(os.path.join(directory, "impact.png"), dpi=130)


def compression(directory):
    results, curves = read(directory, "compression")
    if not results:
        return
    def modulus(run, low, high):
        curve = curves[run]
        strain, force = curve["strain [1]"], 0.5 * (curve["stress_upper [Pa]"] + curve["stress_lower [Pa]"])
        inside = (strain >= low) & (strain <= high)
        return np.polyfit(strain[inside], force[inside], 1)[0] / 1e6

    def stress(run, strain):
        curve = curves[run]
        return 0.5e-3 * np.interp(strain, curve["strain [1]"], np.convolve(curve["stress_upper [Pa]"] + curve["stress_lower [Pa]"], np.ones(3) / 3, "same"))

    table(["run", "void fraction, %", "modulus at 2 to 10 %, MPa", "at 20 to 29 %, MPa", "ratio", "stress at 10 %, kPa", "at 20 %", "at 29 %",
           "on the moving plate over the fixed one at 20 %", "crossed bonds"],
          [[run, "%.2g" % (100 * r["void_fraction"]), "%.3g" % modulus(run, 0.02, 0.1), "%.3g" % modulus(run, 0.2, 0.29),
            "%.2f" % (modulus(run, 0.2, 0.29) / modulus(run, 0.02, 0.1))] + ["%.3g" % stress(run, e) for e in (0.1, 0.2, 0.29)]
           + ["%.2f" % (r["stress_upper_at_20_percent"] / r["stress_lower_at_20_percent"]), "%g" % r["most_crossed_bonds"]]
           for run, r in results.items()])
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.6, 3.1))
    for run, r in results.items():
        curve = curves[run]
        if run.startswith("9 cells") and any(not other.startswith("9 cells") and "yielding" in other and "gap 16" in other for other in results):
            continue # shown where the larger tissues are missing
        smooth = np.convolve(curve["stress_lower [Pa]"], np.ones(5) / 5, "same")[2:-2]
        left.plot(100 * curve["strain [1]"][2:-2], smooth / 1e3, "--" if "elastic" in run else ":" if run.startswith("9 cells") else "-", linewidth=1.4,
                  color=plt.get_cmap("viridis")(min(0.9, 10 * r["void_fraction"])),
                  label="%.1f %% void%s%s" % (100 * r["void_fraction"], ", elastic" if "elastic" in run else "", ", 9 cells" if run.startswith("9 cells") else ""))
    left.set_xlabel("strain [%]", fontsize=9, color=INK)
    left.set_ylabel("stress [kPa]", fontsize=9, color=INK)
    left.legend(frameon=False, fontsize=8)
    style(left)
    for kind, mark, colour, label in (("gap .*yielding", "o", ACCENT, "25 cells, yielding walls"), ("gap .*elastic", "s", ALONG, "25 cells, elastic walls"),
                                      ("9 cells.*yielding", "^", INK, "9 cells, yielding walls")):
        points = sorted((100 * r["void_fraction"], modulus(run, 0.02, 0.1)) for run, r in results.items() if re.match(kind, run))
        if points:
            right.plot(*zip(*points), mark + "-", color=colour, linewidth=1.2, label=label)
    right.set_xlabel("void fraction [%]", fontsize=9, color=INK)
    right.set_ylabel("modulus at 2 to 10 % strain [MPa]", fontsize=9, color=INK)
    right.set_ylim(bottom=0)
    right.legend(frameon=False, fontsize=8)
    style(right)
    figure.tight_layout()
    figure.savefig(os.path.join(directory, "compression.png"), dpi=130)


def cells(directory, part, chosen, moments):
    """Runs (label, title) below each other, at the given frames beside each other."""
    study = os.path.join(ROOT, "runs", "tissue_impact_" + part)
    with open(os.path.join(study, "results.csv"), newline="", encoding="utf-8") as file:
        places = {row["run"]: os.path.join(study, row["directory"]) for row in csv.DictReader(file) if row["status"] == "finished"}
    chosen = [(places[label], title) for label, title in chosen if label in places]
    if not chosen:
        return
    figure, axes = plt.subplots(len(chosen), len(moments), figsize=(2.5 * len(moments), 2.15 * len(chosen)), squeeze=False)
    norm = matplotlib.colors.Normalize(100, 500)
    for row, (run, title) in zip(axes, chosen):
        table = read_table(os.path.join(run, "loading.csv"))
        every = frames(run, "cells")
        start = (every[0].points[:, 1].min() * 1e6, table["plate_upper [m]"][0] * 1e6, -150, 780)
        for axis, moment in zip(row, moments):
            draw(axis, every[moment * (len(every) - 1) // 12], table, start, norm, plt.get_cmap("viridis"))
        row[0].text(-0.02, 0.5, title, rotation=90, fontsize=9, color=INK, transform=row[0].transAxes, va="center", ha="right")
    figure.tight_layout()
    figure.savefig(os.path.join(directory, part + "_cells.png"), dpi=100)


if __name__ == "__main__":
    where = os.path.join(ROOT, "doc", "results", "tissue_impact")
    for work in (compression, impact, failure):
        work(where)
    if len(sys.argv) > 1:
        cells(where, "failure", [("%s, viscosity x %d, tissue 1" % (s, v), "%s, viscosity x %d" % (s, v)) for s in ("dense", "sparse") for v in (1, 1000)],
              (0, 4, 6, 8, 12))
        names = ["%s, wall x %d, viscosity x %d" % one for one in (("dense", 1, 1), ("dense", 1, 1000), ("dense", 10, 1), ("sparse", 1, 1))]
        cells(where, "impact", [(name, name) for name in names], (0, 2, 4, 8, 12))
        cells(where, "compression", [("gap %d um, yielding" % g, "gap %d um" % g) for g in (0, 8, 16, 24)], (0, 4, 8, 12))
