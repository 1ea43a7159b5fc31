"""The picture of a cell_between_plates run: the cell at the start and squeezed, coloured by the pressure of its contacts, and the plates' force over time."""
import json
import os
import sys

import numpy as np
from matplotlib.colors import Normalize

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cell_surface import draw_surface  # noqa: E402
from drawing import ACCENT, ALONG, INK, colour_bar, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402

PRESSURE = plt.get_cmap("YlOrRd")


def draw_cells(figure, shapes, table):
    last = shapes[-1].field("contact_pressure").ravel()
    norm = Normalize(0.0, max(np.percentile(last, 99), 1e-9))
    axis = figure.add_axes([0.0, 0.2, 0.45, 0.76])
    width = np.ptp(shapes[-1].points[:, 0]) * 1e6
    for k, (shape, height, title) in enumerate(((shapes[0], table["distance [m]"][0] * 1e6, "untouched"), (shapes[-1], table["distance [m]"][-1] * 1e6, "squeezed"))):
        at = (k - 0.5) * 1.3 * width
        z = shape.points[:, 2] * 1e6
        draw_surface(axis, shape, norm, (1, 0, 0), (0, 0.25, 1), (at, 0.5 * (z.min() + z.max()) / np.hypot(1, 0.25)), shape.field("contact_pressure").ravel(), PRESSURE)
        for plate, order in ((0.0, 0), (height, 2)):
            half, depth, up = 0.62 * width, 0.24 * 0.62 * width, plate / np.hypot(1, 0.25)
            axis.add_patch(plt.Polygon([(at - half, up - depth), (at + half, up - depth), (at + half, up + depth), (at - half, up + depth)],
                                       facecolor=(0.24, 0.43, 0.6, 0.13), edgecolor=INK, linewidth=0.8, zorder=order))
        axis.text(at, 26, title, color=INK, fontsize=9, ha="center")
    axis.set_xlim(-1.35 * width, 1.35 * width)
    axis.set_ylim(-9, 29)
    scale_bar(axis, -1.25 * width, -7.5, 40, "µm")
    axis.axis("off")
    colour_bar(figure, [0.1, 0.14, 0.26, 0.022], norm, PRESSURE, "pressure on the plates [Pa]; the cell is seen a little from above", last)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "history.csv")
    if not os.path.exists(path) or not os.path.exists(os.path.join(directory, "surface.xdmf")):
        return []
    table = read_table(path)
    figure = plt.figure(figsize=(11.5, 4.6), facecolor="white")
    draw_cells(figure, frames(directory, "surface"), table)
    axis = figure.add_axes([0.53, 0.14, 0.45, 0.8])
    axis.plot(table["time [s]"], table["force [N]"] * 1e9, color=ACCENT, linewidth=1.8)
    draw_data(axis, "time [s]", "force [N]", 1, 1e9)
    axis.set_xlabel("time [s]", color=INK, fontsize=9)
    axis.set_ylabel("force on a plate [nN]", color=INK, fontsize=9)
    axis.set_ylim(0, None)
    style(axis)
    summary = os.path.join(directory, "summary.json")
    if os.path.exists(summary):
        with open(summary, encoding="utf-8") as file:
            results = json.load(file).get("results", {})
        lines = []
        for what, own, laplace, factor, unit in (("cortical tension", "tension_put_in", "tension_by_laplace", 1e3, "mN/m"), ("pressure inside", "pressure", "pressure_by_laplace", 1, "Pa")):
            if own in results and laplace in results:
                lines.append(f"{what}:\n{results[laplace]['value'] * factor:.3g} {unit} by Laplace from the force\n{results[own]['value'] * factor:.3g} {unit} put in")
        axis.text(0.98, 0.06, "\n".join(lines), color=ALONG, fontsize=9, ha="right", va="bottom", transform=axis.transAxes)
    path = os.path.join(directory, "cell_between_plates.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
