"""The picture of an invasion run: the colony in its network at the start and at the end, cells by how far they have come, and the front over time."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, colour_bar, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402
from matplotlib.colors import Normalize  # noqa: E402

MOST_FIBRES = 30000  # finer than a pixel beyond


def outlines(lines, radii):
    """A capsule as a polygon for each rod; um."""
    turn = np.linspace(-0.5, 0.5, 10) * np.pi
    all_of = []
    for (a, b), R in zip(lines, radii):
        along = b - a
        length = np.hypot(*along)
        at = np.arctan2(along[1], along[0]) if length > 0 else 0.0
        front = np.stack([np.cos(turn + at), np.sin(turn + at)], axis=1) * R
        all_of.append(np.concatenate([b + front, a - front]))
    return all_of


def draw_colony(axis, shape, way, norm, half, title):
    lines = shape.points[:, :2][shape.cells.reshape(-1, 2)] * 1e6
    kind, radius = (shape.field(name).ravel() for name in ("kind", "radius"))
    if np.sum(kind == 0) <= MOST_FIBRES:
        axis.add_collection(LineCollection(lines[kind == 0], color="#c9ced6", linewidths=0.4, zorder=1))
    rods = kind == 2
    axis.add_collection(PolyCollection(outlines(lines[rods], radius[rods] * 1e6), array=way, cmap="YlOrRd", norm=norm, edgecolors=INK, linewidths=0.3 if np.sum(rods) < 2000 else 0, zorder=2))
    axis.add_collection(LineCollection(lines[kind == 1], color=ACCENT, linewidths=0.5, zorder=3))
    axis.set_xlim(-half, half)
    axis.set_ylim(-half, half)
    axis.set_aspect("equal")
    axis.axis("off")
    axis.set_title(title, color=INK, fontsize=9)


def draw_history(axis, table):
    hours = table["time [s]"] / 60
    axis.plot(hours, (table["front [m]"] - table["front [m]"][0]) * 1e6, color=ALONG, linewidth=1.4)
    axis.set_ylabel("front: advance of the distance\nthat 95 % of the cells do not exceed [µm]", color=ALONG, fontsize=9)
    axis.set_xlabel("time [min]", color=INK, fontsize=9)
    style(axis)
    beside = axis.twinx()
    beside.plot(hours, 100 * table["invaded_share [1]"], color=ACCENT, linewidth=1.4)
    beside.set_ylabel("cells beyond the colony's first radius [%]", color=ACCENT, fontsize=9)
    beside.set_ylim(bottom=0)
    beside.tick_params(labelsize=8, colors=ACCENT)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "history.csv")
    if not os.path.exists(path):
        return []
    table = read_table(path)
    shapes = frames(directory, "colony") if os.path.exists(os.path.join(directory, "colony.xdmf")) else []
    chosen = [shapes[0], shapes[-1]] if len(shapes) > 1 else list(shapes)
    figure = plt.figure(figsize=(4.8 * (1 + len(chosen)), 5.2), facecolor="white")
    if chosen:
        def middles(shape):
            rods = shape.field("kind").ravel() == 2
            return shape.points[:, :2][shape.cells.reshape(-1, 2)[rods]].mean(axis=1) * 1e6
        start = middles(chosen[0])
        half = 1.15 * max(np.abs(middles(shape)).max() for shape in chosen) + 12
        ways = [np.hypot(*(middles(shape) - start).T) for shape in chosen]
        norm = Normalize(0, max(ways[-1].max(), 1e-3))
        for k, (shape, way) in enumerate(zip(chosen, ways)):
            axis = figure.add_axes([(k + 0.02) / (1 + len(chosen)), 0.15, 0.96 / (1 + len(chosen)), 0.78])
            draw_colony(axis, shape, way, norm, half, f"{len(start)} cells after {shape.time / 60:.0f} min; grey: fibres, red lines: protrusions")
            if k == 0:
                scale_bar(axis, -half, -1.08 * half, 2 * half, "µm")
        colour_bar(figure, [0.2, 0.1, 0.26, 0.02], norm, plt.get_cmap("YlOrRd"), "how far a cell has come [µm]", ways[-1])
    width = 1 / (1 + len(chosen))
    draw_history(figure.add_axes([(len(chosen) + 0.2) * width, 0.14, 0.6 * width, 0.76]), table)
    path = os.path.join(directory, "invasion.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
