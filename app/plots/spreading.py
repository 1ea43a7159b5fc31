"""The picture of a spreading run: the cell at the start and at the end, coloured by in-plane stress, and the radius of its contact over time beside that of a shell of revolution."""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cell_surface import COLOURS, draw_surface, stress, stress_scale  # noqa: E402
from drawing import ACCENT, ALONG, INK, colour_bar, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402


def draw_cells(figure, shapes):
    norm = stress_scale([shapes[-1]])
    axis = figure.add_axes([0.0, 0.2, 0.42, 0.76])
    width = np.ptp(shapes[-1].points[:, 0]) * 1e6
    for k, (shape, title) in enumerate(((shapes[0], "laid down"), (shapes[-1], "at the end"))):
        z = shape.points[:, 2] * 1e6
        draw_surface(axis, shape, norm, (1, 0, 0), (0, 0.12, 1), ((k - 0.5) * 1.25 * width, 0.5 * (z.min() + z.max())))
        axis.text((k - 0.5) * 1.25 * width, 23.5, title, color=INK, fontsize=9, ha="center")
    axis.plot([-1.3 * width, 1.3 * width], [-1.0, -1.0], color=INK, linewidth=1.2)
    axis.text(1.3 * width, -1.6, "adhesive plane", color=INK, fontsize=8, ha="right", va="top")
    axis.set_xlim(-1.35 * width, 1.35 * width)
    axis.set_ylim(-7, 26)
    scale_bar(axis, -1.25 * width, -4.8, 40, "µm")
    axis.axis("off")
    colour_bar(figure, [0.08, 0.14, 0.26, 0.022], norm, COLOURS, "in-plane stress of the net [µN/m]: blue compressed, red stretched", stress(shapes[-1]))


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "history.csv")
    if not os.path.exists(path) or not os.path.exists(os.path.join(directory, "surface.xdmf")):
        return []
    table = read_table(path)
    figure = plt.figure(figsize=(11.5, 4.6), facecolor="white")
    draw_cells(figure, frames(directory, "surface"))
    axis = figure.add_axes([0.5, 0.14, 0.48, 0.8])
    time, radius = table["time [s]"], table["contact_radius [m]"] * 1e6
    axis.semilogx(time[1:], radius[1:], color=ACCENT, linewidth=1.8, label="this run")
    summary = os.path.join(directory, "summary.json")
    if os.path.exists(summary):
        with open(summary, encoding="utf-8") as file:
            results = json.load(file).get("results", {})
        for name, dashes, label in (("axial_radius", "--", "shell of revolution at rest, contact with this run's range"),
                                    ("axial_radius_sharp", ":", "the same, range of a fiftieth of the cell's radius")):
            if name in results:
                axis.axhline(results[name]["value"] * 1e6, color=ALONG, linestyle=dashes, linewidth=1.4, label=label)
    draw_data(axis, "time [s]", "contact_radius [m]", 1, 1e6)
    axis.set_xlabel("time [s]", color=INK, fontsize=9)
    axis.set_ylabel("radius of the contact [µm]", color=INK, fontsize=9)
    axis.set_ylim(0, None)
    axis.legend(frameon=False, fontsize=8.5, loc="lower right")
    style(axis)
    path = os.path.join(directory, "spreading.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
