"""The picture of a spheroid_dextran run, or of several: radius over time and mean pressure (thesis Fig. 5.1).

main(directory) reads growth.csv and writes spheroid_dextran.png there; with fields also a cut, cells_cut.png.
draw(runs, path): runs are (label, directory); labels of one cell line begin with its name, "CT26 free", "CT26 5 kPa".
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cells_cut import draw_cut  # noqa: E402
from drawing import ACCENT, ALONG, INK, plt, read_table, style  # noqa: E402

DAY = 86400.0


def draw(runs, path):
    lines = list(dict.fromkeys(label.split()[0] for label, _ in runs))
    figure, axes = plt.subplots(1, len(lines) + 1, figsize=(3.4 * (len(lines) + 1), 3.8), layout="constrained", squeeze=False)
    axes = axes[0]
    for label, directory in runs:
        table = read_table(os.path.join(directory, "growth.csv"))
        t = table["time [s]"] / DAY
        free = "free" in label
        colour = ACCENT if free else ALONG
        axis = axes[lines.index(label.split()[0])]
        axis.plot(t, table["radius [m]"] * 1e6, color=colour, linewidth=2, linestyle="-" if free else (0, (5, 2)), label=label)
        axes[-1].plot(t, table["pressure [Pa]"] / 1e3, color=colour, linewidth=1, label=label)
    for line, axis in zip(lines, axes):
        if line == "BC52":
            t = np.array([0.0, 9.0])
            start = axis.lines[0].get_ydata()[0]
            axis.plot(t, start + 0.41 * 24 * t, color=INK, linewidth=1, linestyle=(0, (1, 2)), label="experiment, free: 0.41, then 0.29 µm/h")
            axis.plot(t + 9, start + 0.41 * 24 * 9 + 0.29 * 24 * t, color=INK, linewidth=1, linestyle=(0, (1, 2)))
        axis.set_ylabel("radius [µm]", color=INK)
    axes[-1].set_ylabel("mean pressure of living cells [kPa]", color=INK)
    for axis in axes:
        axis.set_xlabel("time [d]", color=INK)
        style(axis)
    for axis in axes[:-1]:
        axis.legend(frameon=False, fontsize=8)
    figure.savefig(path, dpi=120)
    plt.close(figure)
    return path


def main(directory):
    """Paths of the pictures made."""
    made = [draw([("run", directory)], os.path.join(directory, "spheroid_dextran.png"))]
    cut = draw_cut(directory)
    return made + ([cut] if cut else [])


if __name__ == "__main__":
    if len(sys.argv) > 3:  # PICTURE LABEL=DIR LABEL=DIR ...
        draw([tuple(item.split("=", 1)) for item in sys.argv[2:]], sys.argv[1])
    else:
        main(sys.argv[1] if len(sys.argv) > 1 else ".")
