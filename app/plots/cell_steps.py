"""The picture of a cell_steps run: error of fixed and adaptive steps against the step, and against run time.

main(directory) reads steps.csv and writes cell_steps.png there. draw(runs, path): several disturbances (label, directory) below each other.
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, POINT, plt, read_table, style  # noqa: E402

METHODS = (("euler", "#6b8e4e", "s"), ("heun", ALONG, "o"), ("implicit", ACCENT, "D"))


def draw(runs, path):
    figure, axes = plt.subplots(2, len(runs), figsize=(3.3 * len(runs) + 1, 6.4), layout="constrained", squeeze=False)
    for column, (label, directory) in enumerate(runs):
        table = read_table(os.path.join(directory, "steps.csv"))
        for m, (name, colour, marker) in enumerate(METHODS):
            here = table["method"] == m
            fixed, stable = table["adaptive"] == 0, (table["stable"] == 1) & (table["error [1]"] > 0)
            one = here & fixed & stable
            axes[0, column].loglog(table["time_step [s]"][one], table["error [1]"][one], marker, color=colour, markersize=POINT,
                                   linestyle="-", linewidth=1.2, label=f"{name}, fixed steps")
            if np.any(one):
                axes[0, column].axvline(table["time_step [s]"][one].max(), color=colour, linewidth=0.8, linestyle=(0, (2, 3)))
            axes[1, column].loglog(table["cpu_time [s]"][one], table["error [1]"][one], marker, color=colour, markersize=POINT, linestyle="-",
                                   linewidth=0.8, alpha=0.5)
            two = here & ~fixed & stable
            axes[1, column].loglog(table["cpu_time [s]"][two], table["error [1]"][two], marker, color=colour, markersize=POINT, linestyle="--",
                                   linewidth=1.2, markerfacecolor="none", label=f"{name}, adaptive")
        axes[0, column].set_title(label, fontsize=10, color=INK)
        axes[0, column].set_xlabel("step [s]; dotted: longest stable", fontsize=9, color=INK)
        axes[1, column].set_xlabel("run time [CPU s]", fontsize=9, color=INK)
        for row in (0, 1):
            style(axes[row, column])
    for row in (0, 1):
        axes[row, 0].set_ylabel("rms error of positions, over R", fontsize=9, color=INK)
        axes[row, 0].legend(frameon=False, fontsize=7.5)
    figure.savefig(path, dpi=110)
    plt.close(figure)
    return path


def main(directory):
    """Paths of the pictures made."""
    return [draw([("", directory)], os.path.join(directory, "cell_steps.png"))]


if __name__ == "__main__":
    if len(sys.argv) > 3:  # PICTURE LABEL=DIR LABEL=DIR ...
        draw([tuple(item.split("=", 1)) for item in sys.argv[2:]], sys.argv[1])
    else:
        main(sys.argv[1] if len(sys.argv) > 1 else ".")
