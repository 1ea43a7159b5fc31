"""The picture of a wall_uniaxial run: tension against stretch for every A and B, on the way out and back, with the
law of Eq. 3.8 as dots.

main(directory) reads wall.csv and writes wall_uniaxial.png there.
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import INK, POINT, read_table, style  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "wall.csv")
    if not os.path.exists(path):
        return []
    table = read_table(path)
    if not len(table.get("A [1]", [])):
        return []
    sharpness = sorted(set(table["A [1]"]))
    figure, axes = plt.subplots(1, len(sharpness), figsize=(3.8 * len(sharpness) + 0.6, 3.8), sharey=True, squeeze=False, facecolor="white")
    for axis, a in zip(axes[0], sharpness):
        drops = sorted(set(table["B [1]"][table["A [1]"] == a]))
        for k, b in enumerate(drops):
            colour = plt.get_cmap("viridis")(0.85 * k / max(1, len(drops) - 1))
            own = (table["A [1]"] == a) & (table["B [1]"] == b)
            out, back = own & (table["back"] < 0.5), own & (table["back"] > 0.5)
            axis.plot(table["stretch [1]"][out], 1e3 * table["tension [N]"][out], color=colour, linewidth=1.8, label=f"B = {b:g}")
            carried = back & (table["tension [N]"] >= 0)
            axis.plot(table["stretch [1]"][carried], 1e3 * table["tension [N]"][carried], color=colour, linewidth=1.0, linestyle=(0, (4, 2)))
            some = np.flatnonzero(out)[::6]
            axis.plot(table["stretch [1]"][some], 1e3 * table["law [N]"][some], "o", color=colour, markersize=POINT, markerfacecolor="white")
        axis.set_title(f"A = {a:g}", color=INK, fontsize=11)
        axis.set_xlabel("stretch", color=INK, fontsize=9)
        style(axis)
    axes[0][0].set_ylabel("tension [mN]", color=INK, fontsize=9)
    axes[0][0].legend(frameon=False, fontsize=9)
    figure.text(0.995, 0.01, "line: measured on the way out, dashed: on the way back, dots: Eqs. 3.4, 3.5, 3.8 (corrected)", ha="right",
                color=INK, fontsize=8)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    path = os.path.join(directory, "wall_uniaxial.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
