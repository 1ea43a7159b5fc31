"""The picture of a protrusion run: force and number of bonds over time on each matrix, and both at the work limit over its stiffness beside the closed forms."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, INK, POINT, plt, read_table, style  # noqa: E402
from own_data import draw_data  # noqa: E402

COLOURS = plt.get_cmap("viridis")


def draw_courses(axes, table):
    stiffnesses = np.unique(table["stiffness [N/m]"])
    for k, stiffness in enumerate(stiffnesses):
        rows = table["stiffness [N/m]"] == stiffness
        colour = COLOURS(0.9 * k / max(1, len(stiffnesses) - 1))
        for axis, name, factor in zip(axes, ("force [N]", "bonds"), (1e12, 1)):
            axis.plot(table["time [s]"][rows], table[name][rows] * factor, color=colour, linewidth=1.5, label=f"{stiffness:.3g} N/m")
    for axis, label in zip(axes, ("force of the protrusion [pN]", "bonds of its adhesion")):
        axis.set_xlabel("time since it took hold [s]", color=INK, fontsize=9)
        axis.set_ylabel(label, color=INK, fontsize=9)
        axis.set_ylim(0, None)
        style(axis)
    draw_data(axes[0], "time [s]", "force [N]", 1, 1e12)
    axes[0].legend(frameon=False, fontsize=8.5, title="stiffness of the matrix", title_fontsize=8.5)


def draw_peaks(axes, table):
    for axis, name, closed, factor, label, said in zip(axes, ("force [N]", "bonds"), ("force_by_work [N]", "bonds_at_rest"), (1e12, 1), ("force at the work limit [pN]", "bonds at the work limit"),
                                                       (r"$\sqrt{2 K_{eff} W_{max}}$", "mean field at rest")):
        axis.plot(table["stiffness [N/m]"], table[closed] * factor, color=INK, linewidth=1.2, linestyle=(0, (4, 3)), label=said)
        axis.plot(table["stiffness [N/m]"], table[name] * factor, "o", color=ACCENT, markersize=POINT, markerfacecolor="white", label="computed")
        axis.set_xscale("log")
        axis.set_xlabel("stiffness of the matrix [N/m]", color=INK, fontsize=9)
        axis.set_ylabel(label, color=INK, fontsize=9)
        axis.set_ylim(0, None)
        axis.legend(frameon=False, fontsize=8.5)
        style(axis)


def main(directory):
    """Paths of the pictures made."""
    paths = [os.path.join(directory, name) for name in ("history.csv", "peaks.csv")]
    if not all(os.path.exists(path) for path in paths):
        return []
    history, peaks = (read_table(path) for path in paths)
    figure, axes = plt.subplots(2, 2, figsize=(11.5, 7), facecolor="white", gridspec_kw={"width_ratios": [1.6, 1], "hspace": 0.28, "wspace": 0.2, "left": 0.06, "right": 0.985, "top": 0.98, "bottom": 0.075})
    draw_courses(axes[:, 0], history)
    draw_peaks(axes[:, 1], peaks)
    path = os.path.join(directory, "protrusion.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
