"""The picture of a capsule_compression run: cuts through the clump at the start and at the end, lines coloured by the pressure of contacts, and pressures over time."""
import os
import sys

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cell_surface import section  # noqa: E402
from drawing import ACCENT, ALONG, INK, colour_bar, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402

PRESSURE = plt.get_cmap("viridis")


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "history.csv")
    if not os.path.exists(path) or not os.path.exists(os.path.join(directory, "surface.xdmf")):
        return []
    table = read_table(path)
    shapes = frames(directory, "surface")
    figure = plt.figure(figsize=(11.5, 4.6), facecolor="white")
    last = shapes[-1].field("contact_pressure").ravel()
    norm = Normalize(0.0, max(np.percentile(last, 95), 1e-9))
    axis = figure.add_axes([0.0, 0.2, 0.54, 0.8])
    radii = table["radius [m]"] * 1e6
    at = 0.0
    for k, (shape, radius, title) in enumerate(((shapes[0], radii[0], "at the start"), (shapes[-1], radii[-1], "at the end"))):
        ends, values = section(shape, 2e-6, shape.field("contact_pressure").ravel())
        if len(ends):
            axis.add_collection(LineCollection(ends + np.array([at, 0.0]), colors=PRESSURE(norm(values)), linewidths=1.6))
        axis.add_patch(plt.Circle((at, 0.0), radius, fill=False, edgecolor=INK, linewidth=2.2))
        axis.text(at, radii[0] + 2, title, color=INK, fontsize=9, ha="center", va="bottom")
        at += radii[0] + radii[-1] + 8
    axis.set_xlim(-radii[0] - 3, at - 8 + 3 + 0.2 * radii[0])
    axis.set_ylim(-radii[0] - 9, radii[0] + 7)
    axis.set_aspect("equal")
    scale_bar(axis, -radii[0], -radii[0] - 5, 40, "µm")
    axis.axis("off")
    colour_bar(figure, [0.12, 0.14, 0.26, 0.022], norm, PRESSURE, "pressure of contacts [Pa], on a cut 2 µm above the middle", last)
    axis = figure.add_axes([0.59, 0.14, 0.39, 0.8])
    for column, colour, dashes, label in (("pressure [Pa]", ACCENT, "-", "inside the cells (mean)"), ("wall_pressure [Pa]", ALONG, "--", "on the sphere")):
        axis.plot(table["time [s]"], table[column], color=colour, linestyle=dashes, linewidth=1.8, label=label)
        draw_data(axis, "time [s]", column, 1, 1)
    axis.set_xlabel("time [s]", color=INK, fontsize=9)
    axis.set_ylabel("pressure [Pa]", color=INK, fontsize=9)
    axis.set_ylim(0, None)
    axis.legend(frameon=False, fontsize=8.5, loc="upper left")
    style(axis)
    path = os.path.join(directory, "capsule_compression.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
