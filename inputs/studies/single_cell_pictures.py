"""Pictures of the runs of single_cell.py: impact_matrix.png and largest_stretch.png in doc/results/single_cell.

  python3 inputs/studies/single_cell_pictures.py [--directory runs]
"""
import argparse
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from drawing import INK, read_table, style  # noqa: E402

PLACE = os.path.join(ROOT, "doc", "results", "single_cell")
COLOURS = ("#1b6ca8", "#3a9d6e", "#d98e04", "#b5332e")


def table(*path):
    name = os.path.join(*path)
    return read_table(name) if os.path.exists(name) else None


def save(figure, name):
    figure.tight_layout()
    path = os.path.join(PLACE, name)
    figure.savefig(path, dpi=120)
    print(path)


def impact_matrix(directory):
    figure, axes = plt.subplots(2, 2, figsize=(10.5, 7), sharex=True, facecolor="white")
    found = False
    for column, stiffness in enumerate((100, 1000)):
        for colour, viscosity in zip(COLOURS, (1e-3, 1e-2, 1e-1, 1)):
            run = table(directory, "impact_matrix", f"G{stiffness}_mu{viscosity}", "force.csv")
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


def largest_stretch(directory):
    figure, axes = plt.subplots(1, 2, figsize=(10.5, 4.2), facecolor="white")
    found = False
    for colour, stiffness in zip((COLOURS[0], COLOURS[3]), (100, 6)):
        for nu, mark in ((6, "v"), (10, "s"), (14, "o")):
            place = os.path.join(directory, "largest_stretch", f"G{stiffness}_{nu}")
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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--directory", default="runs")
    options = parser.parse_args()
    impact_matrix(options.directory)
    largest_stretch(options.directory)


if __name__ == "__main__":
    main()
