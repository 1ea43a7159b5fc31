"""Pictures of the runs of single_cell/impact_matrix.prm and largest_stretch.prm: impact_matrix.png and largest_stretch.png in
doc/results/single_cell.

  python3 inputs/studies/single_cell_pictures.py
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from drawing import INK, read_table, style  # noqa: E402
from runs import no_choice  # noqa: E402

PLACE = os.path.join(ROOT, "doc", "results", "single_cell")
COLOURS = ("#1b6ca8", "#3a9d6e", "#d98e04", "#b5332e")


def runs(study):
    """{(values of the swept entries): directory} of the finished runs of a study in doc/results/single_cell."""
    path = os.path.join(PLACE, study, "results.csv")
    if not os.path.exists(path):
        return {}
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["status"] == "finished"]
    entries = [name for name in list(rows[0])[:list(rows[0]).index("status")] if name not in ("run", "method", "settings")]
    return {tuple(float(row[entry]) for entry in entries): os.path.join(os.path.dirname(path), row["directory"]) for row in rows}


def table(directory, name):
    path = os.path.join(directory or "", name)
    return read_table(path) if directory and os.path.exists(path) else None


def save(figure, name):
    figure.tight_layout()
    path = os.path.join(PLACE, name)
    figure.savefig(path, dpi=120)
    print(path)


def impact_matrix():
    figure, axes = plt.subplots(2, 2, figsize=(10.5, 7), sharex=True, facecolor="white")
    found, places = False, runs("impact_matrix")
    for column, (stiffness, steps) in enumerate(((100, 1000), (1000, 3000))):
        for colour, viscosity in zip(COLOURS, (1e-3, 1e-2, 1e-1, 1)):
            run = table(places.get((viscosity, stiffness, steps)), "force.csv")
            if run is None:
                continue
            found = True
            e = run["deformation [1]"]
            label = f"{viscosity:g} Pa s"
            axes[0, column].plot(100 * e, 1e3 * run["force_lower [N]"], color=colour, linewidth=1.6, label=label)
            far = e > 0.03
            share = (0.5 - run["height_share_upper [1]"] * (1 - e)) / np.where(far, e, 1)
            axes[1, column].plot(100 * e[far], share[far], color=colour, linewidth=1.6, label=label)
        axes[0, column].set_title(f"wall G t0 = {stiffness} N/m", fontsize=11, color=INK)
        axes[0, column].set_ylim(0, None)
        axes[1, column].axhline(0.5, color=INK, linewidth=0.8, linestyle=":")
        axes[1, column].set_ylim(0.2, 1.1)
        axes[1, column].set_xlabel("deformation [%]", fontsize=9, color=INK)
    axes[0, 0].set_ylabel("transmitted force [mN]", fontsize=9, color=INK)
    axes[1, 0].set_ylabel("upper half's share of the deformation", fontsize=9, color=INK)
    axes[0, 0].legend(frameon=False, fontsize=9)
    for axis in axes.ravel():
        style(axis)
    if found:
        save(figure, "impact_matrix.png")


def largest_stretch():
    figure, axes = plt.subplots(1, 2, figsize=(10.5, 4.2), facecolor="white")
    found, places = False, runs("largest_stretch")
    for colour, stiffness, steps in ((COLOURS[0], 100, 4000), (COLOURS[3], 6, 16000)):
        for nu, mark in ((6, "v"), (10, "s"), (14, "o")):
            place = places.get((nu, stiffness, steps))
            run, balloon = table(place, "force.csv"), table(place, "balloon.csv")
            if run is None or balloon is None:
                continue
            found = True
            every = slice(6, None, 12)
            e = run["deformation [1]"][every]
            angle = run["largest_stretch_angle [degrees]"][every]
            label = f"net of {10 * nu * nu + 2}, G t0 = {stiffness} N/m"
            axes[0].plot(100 * e, np.minimum(angle, 180 - angle), mark, color=colour, markersize=4, fillstyle="none", label=label)
            axes[1].plot(100 * e, run["largest_stretch [1]"][every], mark, color=colour, markersize=4, fillstyle="none")
            if nu == 14:
                mine = (balloon["membrane"] == 0) & (balloon["deformation [1]"] > 0)
                x = 100 * balloon["deformation [1]"][mine]
                axes[0].plot(x, balloon["largest_stretch_angle [degrees]"][mine], color=colour, linewidth=1.4, label="balloon")
                axes[1].plot(x, balloon["largest_stretch [1]"][mine], color=colour, linewidth=1.4)
    axes[0].set_ylabel("polar angle of the largest stretch [degrees]", fontsize=9, color=INK)
    axes[1].set_ylabel("largest stretch", fontsize=9, color=INK)
    axes[0].legend(frameon=False, fontsize=8)
    for axis in axes:
        axis.set_xlabel("deformation [%]", fontsize=9, color=INK)
        style(axis)
    if found:
        save(figure, "largest_stretch.png")


if __name__ == "__main__":
    no_choice(__doc__)
    impact_matrix()
    largest_stretch()
