"""Free growth and growth in capsules on one picture, over R_0 = 100 um (thesis Fig. 5.1B, 5.6B).

  python3 app/plots/spheroid_overview.py PICTURE LABEL=DIRECTORY ...        (runs of spheroid_free and spheroid_capsule)

Time begins where the spheroid's radius passes 99 um; drawn in: a volume that doubles in 17 h, slopes of the experiment.
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, plt, read_table, style  # noqa: E402

DAY, R_0 = 86400.0, 100e-6
COLOURS = (ACCENT, ALONG, "#6b8e4e", "#8a6fb0", "#c28b2c")


def draw(runs, path):
    figure, axis = plt.subplots(figsize=(7.5, 5), layout="constrained")
    for colour, (label, directory) in zip(COLOURS, runs):
        table = read_table(os.path.join(directory, "growth.csv"))
        t, radius = table["time [s]"], table["radius [m]"]
        k = int(np.argmax(radius >= 0.99 * R_0))
        shown = radius
        if "capsule_radius [m]" in table:  # in contact the wall is the edge
            shown = np.where(np.arange(len(t)) >= k, table["capsule_radius [m]"], radius)
        axis.plot((t - t[k]) / DAY, shown / R_0, color=colour, linewidth=1.8, label=label)
    t = np.array([0.0, 1.0]) * 7
    early = np.linspace(-2.5, 1.2, 60)
    axis.plot(early, 0.99 * 2 ** (early * 24 / 17 / 3), color=INK, linewidth=1, linestyle=(0, (4, 3)), label="volume doubling in 17 h")
    for at, slope, style_of, name in ((1.106, 2.0, (0, (5, 2)), "experiment, thin: 2 µm/d (slope only)"),
                                      (1.044, 0.7, (0, (1, 2)), "experiment, thick: 0.7 µm/d (slope only)")):
        late = np.array([2.0, t[-1]])
        axis.plot(late, at + slope * 0.01 * (late - 2), color=INK, linewidth=1.2, linestyle=style_of, label=name)
    axis.set_ylim(0.5, 1.75)
    axis.set_xlim(-2.7, 7.2)
    axis.set_xlabel("time after confluence [d]", color=INK)
    axis.set_ylabel("radius over 100 µm", color=INK)
    axis.legend(frameon=False, fontsize=8, loc="upper right")
    style(axis)
    figure.savefig(path, dpi=120)
    plt.close(figure)
    return path


if __name__ == "__main__":
    draw([tuple(item.split("=", 1)) for item in sys.argv[2:]], sys.argv[1])
