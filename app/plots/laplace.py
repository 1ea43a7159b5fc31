"""The picture of a laplace run: the inflated cell, and both sides of Laplace's law while it is inflated."""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, colour_bar, read_table, style  # noqa: E402
from own_data import draw_data  # noqa: E402
from round_cell import cell_frames, draw_cell, has_cell  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "laplace.csv")
    if not has_cell(directory) or not os.path.exists(path):
        return []
    table = read_table(path)
    wall, fluid = cell_frames(directory)[-1]
    flat = wall.cells.shape[1] == 2
    values = fluid.field("pressure").ravel() / 1e3 if flat and fluid else wall.field("stretch").ravel()
    low, high = np.percentile(values, [1, 99])
    norm = matplotlib.colors.Normalize(low, max(high, low + 1e-9))
    colours = "viridis" if flat else "inferno"
    figure = plt.figure(figsize=(11.0, 4.6), facecolor="white")
    axis = figure.add_axes([0.02, 0.14, 0.36, 0.80])
    draw_cell(axis, wall, fluid, norm, np.abs(wall.points[:, 0]).max() * 1e6, colours=colours)
    colour_bar(figure, [0.07, 0.105, 0.26, 0.02], norm, plt.get_cmap(colours),
               "fluid pressure [kPa]" if flat else "stretch of the wall", values)
    axis = figure.add_axes([0.47, 0.13, 0.50, 0.80])
    t = table["time [s]"] * 1e6
    for column, colour, dash, label in (("pressure_eos [Pa]", ALONG, "-", "fluid: mean EOS pressure"),
                                        ("pressure_virial [Pa]", ALONG, "--", "fluid: virial"),
                                        ("pressure_from_cut_tension [Pa]", ACCENT, "-", "wall: pull across great circles"),
                                        ("pressure_from_virial_tension [Pa]", ACCENT, "--", "wall: virial")):
        axis.plot(t, table[column] / 1e3, color=colour, linestyle=dash, linewidth=1.6, label=label)
        draw_data(axis, "time [s]", column, 1e6, 1e-3)
    final = table["pressure_eos [Pa]"][-1] / 1e3
    axis.set_ylim(-0.1 * final, 1.6 * final)
    axis.set_xlim(0, t[-1])
    axis.set_xlabel("time of inflation [µs]", color=INK, fontsize=9)
    axis.set_ylabel("pressure, and pressure that the tension balances [kPa]", color=INK, fontsize=9)
    axis.legend(frameon=False, fontsize=9, loc="lower right")
    style(axis)
    figure.text(0.5, 1.0, "Law of Laplace: the pressure in an inflated cell, and the pressure that the tension of its wall balances", fontsize=11, color=INK,
                ha="center", va="bottom")
    path = os.path.join(directory, "laplace.png")
    figure.savefig(path, dpi=150, bbox_inches="tight", pad_inches=0.08)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
