"""The picture of an rbc_tweezers run: the cell at rest and pulled, coloured by in-plane stress, and both diameters over the force beside the experiment."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cell_surface import COLOURS, draw_surface, stress_scale  # noqa: E402
from drawing import ACCENT, ALONG, INK, POINT, colour_bar, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402


def draw_cells(figure, directory, table):
    shapes = frames(directory, "surface")
    count = min(len(shapes), len(table["force [N]"]))
    chosen = sorted({round(k * (count - 1) / 3) for k in range(4)})
    norm = stress_scale([shapes[k] for k in chosen])
    axis = figure.add_axes([0.0, 0.16, 0.53, 0.80])
    foot = 0.0
    for k in chosen:
        x = shapes[k].points * 1e6
        half = 0.5 * (x.max(axis=0) - x.min(axis=0))
        foot -= half[1]
        draw_surface(axis, shapes[k], norm, (1, 0, 0), (0, 1, 0), (0.0, foot))
        draw_surface(axis, shapes[k], norm, (1, 0, 0), (0, 0, 1), (17.5, foot))
        axis.text(-8.6, foot, f"{table['force [N]'][k] * 1e12:.0f} pN", color=INK, fontsize=9, ha="right", va="center")
        foot -= half[1] + 1.2
    axis.text(0, 1.0, "from above", color=INK, fontsize=9, ha="center")
    axis.text(17.5, 1.0, "from the side", color=INK, fontsize=9, ha="center")
    axis.set_xlim(-13, 26)
    axis.set_ylim(foot - 1.5, 2.2)
    scale_bar(axis, -4.5, foot - 0.4, 15, "µm")
    axis.axis("off")
    values = np.concatenate([shapes[k].field("in_plane_stress").ravel() * 1e6 for k in chosen])
    colour_bar(figure, [0.12, 0.115, 0.28, 0.02], norm, COLOURS, "in-plane stress of the net [µN/m]: blue compressed, red stretched", values)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "diameters.csv")
    if not os.path.exists(path) or not os.path.exists(os.path.join(directory, "surface.xdmf")):
        return []
    table = read_table(path)
    figure = plt.figure(figsize=(11.5, 5.2), facecolor="white")
    draw_cells(figure, directory, table)
    axis = figure.add_axes([0.59, 0.12, 0.40, 0.84])
    other = os.path.join(directory, "comparison.csv")
    measured = read_table(other) if os.path.exists(other) else None
    force = table["force [N]"] * 1e12
    for which, (column, colour, label) in enumerate((("axial_diameter [m]", ACCENT, "axial: along the force"),
                                                     ("transverse_diameter [m]", ALONG, "transverse: across it"))):
        axis.plot(force, table[column] * 1e6, "-o", color=colour, linewidth=1.8, markersize=POINT, label=label + ", this run")
        if measured is not None:
            rows = measured["transverse"] == which
            mean, low, high = (measured[name][rows] * 1e6 for name in ("measured [m]", "low [m]", "high [m]"))
            axis.errorbar(measured["force [N]"][rows] * 1e12, mean, [mean - low, high - mean], fmt="s", color=INK, ecolor=INK, elinewidth=0.8, capsize=2.5,
                          markersize=POINT, markerfacecolor="white", label="experiment (Suresh et al. 2005), mean and range" if which == 0 else None)
        draw_data(axis, "force [N]", column, 1e12, 1e6)
    axis.set_xlabel("force at each end [pN]", color=INK, fontsize=9)
    axis.set_ylabel("diameter [µm]", color=INK, fontsize=9)
    axis.set_ylim(0, None)
    axis.set_xlim(-4, None)
    axis.legend(frameon=False, fontsize=8.5, loc="lower left")
    style(axis)
    figure.text(0.5, 1.0, "A red cell pulled between two tweezers: its shape, and both diameters", fontsize=11, color=INK, ha="center", va="bottom")
    path = os.path.join(directory, "rbc_tweezers.png")
    figure.savefig(path, dpi=140, bbox_inches="tight", pad_inches=0.08)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
