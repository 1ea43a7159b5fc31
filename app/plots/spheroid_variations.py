"""Dilatation of a capsule over time where one thing is varied: the counterpart of thesis Fig. 5.5A, 5.6A, C.2, C.3, C.4 in a small capsule.

draw(groups, path): groups are (title, column, [(label, directory)]); column: dilatation, density or pressure.
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, plt, style  # noqa: E402
from spheroid_capsule import after_confluence  # noqa: E402

COLOURS = (INK, ACCENT, ALONG, "#6b8e4e", "#8a6fb0", "#c28b2c")
NAMES = {"dilatation": "dilatation of the capsule [%]", "density": "density over that at confluence",
         "pressure": "pressure on the capsule [kPa]"}


def draw(groups, path, columns=4):
    rows = -(-len(groups) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(3.7 * columns, 3.1 * rows), layout="constrained", squeeze=False)
    axes = axes.ravel()
    for axis, (title, column, runs) in zip(axes, groups):
        for colour, (label, directory) in zip(COLOURS, runs):
            data = after_confluence(directory)
            if data is None:
                continue
            t, radius, pressure, density, rest, _ = data
            values = {"dilatation": 100 * (radius / rest - 1), "pressure": pressure,
                      "density": density / np.interp(0, t, density)}[column]
            shown = t > -0.1
            axis.plot(t[shown], values[shown], color=colour, linewidth=1.6, label=label)
        if column == "density":
            axis.errorbar([2], [2.175], yerr=0.175, fmt="none", ecolor=INK, capsize=4, elinewidth=1.4, label="experiment: 2 to 2.35 at 48 h")
        axis.set_title(title, fontsize=10, color=INK, loc="left")
        axis.set_ylabel(NAMES[column], color=INK, fontsize=9)
        axis.set_xlabel("time after confluence [d]", color=INK, fontsize=9)
        axis.legend(frameon=False, fontsize=7.5, loc="upper left")
        axis.set_ylim(top=axis.get_ylim()[1] + 0.3 * np.ptp(axis.get_ylim()))
        style(axis)
    for axis in axes[len(groups):]:
        axis.set_visible(False)
    figure.savefig(path, dpi=100)
    plt.close(figure)
    return path
