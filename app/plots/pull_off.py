"""The picture of a pull_off run: the cell at rest and drawn off, coloured by in-plane stress, and the force against displacement beside the lines of JKR, DMT and of a vesicle."""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cell_surface import COLOURS, draw_cells, stress, stress_scale  # noqa: E402
from drawing import ACCENT, ALONG, INK, colour_bar, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402


def draw_shapes(figure, shapes, on_plane):
    shown = shapes[1:] if len(shapes) > 2 else shapes
    norm = stress_scale([shown[0]])
    axis = figure.add_axes([0.0, 0.2, 0.42, 0.78])
    width = max(np.ptp(shape.points[:, 0]) for shape in shown) * 1e6
    low = min(shape.points[:, 2].min() for shape in shown) * 1e6
    high = max(shape.points[:, 2].max() for shape in shown) * 1e6
    for k, (shape, title) in enumerate(zip(shown, ("at rest", "drawn off"))):
        at = (k - 0.5) * 1.3 * width
        draw_cells(axis, shape, norm, (1, 0, 0), (0, 0, 1), at)
        axis.text(at, high + 2, title, color=INK, fontsize=9, ha="center")
    if on_plane:
        axis.plot([-1.3 * width, 1.3 * width], [0, 0], color=INK, linewidth=1.2)
        axis.text(1.3 * width, -0.6, "adhesive plane", color=INK, fontsize=8, ha="right", va="top")
    axis.set_xlim(-1.35 * width, 1.35 * width)
    axis.set_ylim(low - 7, high + 6)
    scale_bar(axis, -1.25 * width, low - 5, 40, "µm")
    axis.set_aspect("equal")
    axis.axis("off")
    colour_bar(figure, [0.08, 0.14, 0.26, 0.022], norm, COLOURS, "in-plane stress of the net [µN/m]: blue compressed, red stretched", stress(shown[0]))


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "history.csv")
    if not os.path.exists(path) or not os.path.exists(os.path.join(directory, "surface.xdmf")):
        return []
    table = read_table(path)
    results = {}
    summary = os.path.join(directory, "summary.json")
    if os.path.exists(summary):
        with open(summary, encoding="utf-8") as file:
            results = {name: one["value"] for name, one in json.load(file).get("results", {}).items()}
    figure = plt.figure(figsize=(11.5, 4.6), facecolor="white")
    shapes = frames(directory, "surface")
    draw_shapes(figure, shapes, len(np.unique(shapes[0].field("cell"))) == 1)
    axis = figure.add_axes([0.5, 0.14, 0.48, 0.8])
    way, force = table["displacement [m]"] * 1e6, table["force [N]"] * 1e9
    drawn = np.arange(len(way)) >= np.argmax(np.abs(force) > 0)
    axis.plot(way[drawn], force[drawn], color=ACCENT, linewidth=1.8, label="this run")
    if results.get("relative_pull_off"):
        unit = results["pull_off_force"] * 1e9 / results["relative_pull_off"]
        for times, dashes, label in ((1.0, ":", "vesicle, π W R*"), (1.5, "--", "JKR, 3/2 π W R*"), (2.0, "-.", "DMT, 2 π W R*")):
            axis.axhline(times * unit, color=ALONG, linestyle=dashes, linewidth=1.2, label=label)
        if "axial_relative_pull_off" in results:
            axis.axhline(results["axial_relative_pull_off"] * unit, color=INK, linewidth=1.0, label="shell of revolution, largest force")
    draw_data(axis, "displacement [m]", "force [N]", 1e6, 1e9)
    axis.set_xlabel("displacement of the cell's middle [µm]", color=INK, fontsize=9)
    axis.set_ylabel("force [nN]", color=INK, fontsize=9)
    axis.set_ylim(top=1.35 * max(axis.get_ylim()[1], force[drawn].max()))  # room for the legend over all lines
    axis.legend(frameon=False, fontsize=8.5, loc="upper center", ncol=2)
    style(axis)
    path = os.path.join(directory, "pull_off.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
