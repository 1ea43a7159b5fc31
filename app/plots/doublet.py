"""The picture of a doublet run: both cells at the start and at the end, coloured by in-plane stress, one of them seen from the contact, and the contact angle over time beside Young-Dupre."""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cell_surface import COLOURS, draw_cells, stress, stress_scale  # noqa: E402
from drawing import ACCENT, ALONG, INK, colour_bar, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402


def draw_shapes(figure, shapes):
    last = shapes[-1]
    norm = stress_scale([last])
    axis = figure.add_axes([0.0, 0.2, 0.5, 0.78])
    high = max(shape.points[:, 2].max() for shape in shapes) * 1e6
    length = np.ptp(shapes[0].points[:, 0]) * 1e6
    for shape, at, title in ((shapes[0], 0.0, "at the start"), (last, 1.12 * length, "at the end")):
        draw_cells(axis, shape, norm, (1, 0, 0), (0, 0, 1), at)
        axis.text(at, high + 2, title, color=INK, fontsize=9, ha="center")
    face = 1.12 * length + 0.5 * length + 0.45 * length
    draw_cells(axis, last, norm, (0, 1, 0), (0, 0, 1), face, only=0)
    axis.text(face, high + 2, "one of them, its contact", color=INK, fontsize=9, ha="center")
    axis.set_xlim(-0.55 * length, face + 0.35 * length)
    axis.set_ylim(-high - 8, high + 6)
    scale_bar(axis, -0.5 * length, -high - 5, 40, "µm")
    axis.set_aspect("equal")
    axis.axis("off")
    colour_bar(figure, [0.1, 0.14, 0.26, 0.022], norm, COLOURS, "in-plane stress of the net [µN/m], without active tension: blue compressed, red stretched", stress(last))


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "history.csv")
    if not os.path.exists(path) or not os.path.exists(os.path.join(directory, "surface.xdmf")):
        return []
    table = read_table(path)
    figure = plt.figure(figsize=(12.5, 4.6), facecolor="white")
    draw_shapes(figure, frames(directory, "surface"))
    axis = figure.add_axes([0.57, 0.14, 0.41, 0.8])
    time, angle = table["time [s]"], table["contact_angle [degrees]"]
    axis.semilogx(time[1:], angle[1:], color=ACCENT, linewidth=1.8, label="this run")
    summary = os.path.join(directory, "summary.json")
    if os.path.exists(summary):
        with open(summary, encoding="utf-8") as file:
            results = json.load(file).get("results", {})
        if "young_dupre_angle" in results:
            axis.axhline(results["young_dupre_angle"]["value"], color=ALONG, linestyle="--", linewidth=1.4, label="Young-Dupré, cos θ = 1 - W/(2τ)")
    draw_data(axis, "time [s]", "contact_angle [degrees]", 1, 1)
    axis.set_xlabel("time [s]", color=INK, fontsize=9)
    axis.set_ylabel("contact angle [degrees]", color=INK, fontsize=9)
    axis.set_ylim(0, None)
    axis.legend(frameon=False, fontsize=8.5, loc="lower right")
    style(axis)
    path = os.path.join(directory, "doublet.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
