"""The picture of a full_micro run: all particles at the probe's deepest point, fluid coloured by
pressure, walls dark, one corner magnified, and the probe's history below.

main(directory) reads cells.xdmf and its frames and probe.csv, and writes full_micro.png there.
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import INK, colour_bar, has_history, plot_history, read_table  # noqa: E402
from fields import frames  # noqa: E402


def scatter(axis, points, pressure, wall, norm, colours, spacing):
    """Limits of the axis must be final: a dot fills the particles' spacing (mm), walls are thinner."""
    axis.set_aspect("equal")
    axis.figure.canvas.draw()
    pixels = np.diff(axis.transData.transform([(0, 0), (spacing, 0)])[:, 0])[0]
    spot = (0.95 * pixels * 72 / axis.figure.dpi) ** 2
    axis.scatter(*points[~wall].T, c=pressure[~wall], s=spot, cmap=colours, norm=norm, linewidths=0, rasterized=True)
    axis.scatter(*points[wall].T, color=INK, s=0.25 * spot, linewidths=0, rasterized=True)


def picture(directory):
    table = read_table(os.path.join(directory, "probe.csv"))
    deepest = table["time [s]"][np.argmin(table["displacement_y [m]"])]
    frame = min(frames(directory, "cells"), key=lambda one: abs(one.time - deepest))
    points = frame.points[:, :2] * 1e3
    reference = points - frame.field("displacement").reshape(len(points), 3)[:, :2] * 1e3
    pressure = frame.field("pressure").ravel() / 1e3
    wall = frame.field("wall").ravel() > 0.5
    low, high = reference.min(axis=0), reference.max(axis=0)
    width = high[0] - low[0]
    norm = matplotlib.colors.Normalize(*np.percentile(pressure[~wall], [2, 98]))
    colours = plt.get_cmap("viridis")

    figure = plt.figure(figsize=(11.5, 8.0), facecolor="white")
    axis = figure.add_axes([0.03, 0.30, 0.56, 0.64])
    cells = frame.field("cell").ravel()
    count = cells.max() + 1
    side = width / max(1.0, np.sqrt(count))
    spacing = side / np.sqrt(np.sum(~wall) / count)
    border = 0.03 * width
    axis.set_xlim(min(points[:, 0].min(), low[0]) - border, points[:, 0].max() + border)
    axis.set_ylim(points[:, 1].min() - border, max(points[:, 1].max(), high[1]) + border)
    scatter(axis, points, pressure, wall, norm, colours, spacing)
    axis.plot([low[0], low[0]], [low[1], high[1]], color=INK, linewidth=2.5)
    axis.axis("off")
    axis.set_title(f"Every cell as particles, t = {frame.time * 1e3:.3f} ms (true scale)", color=INK, fontsize=12)

    reach = min(1.15 * side, 0.3 * width)
    centre = np.array([low[0] + min(1.5 * side, width - reach), 0.5 * (low[1] + high[1])])
    centre = points[np.argmin(np.sum((reference - centre) ** 2, axis=1))]
    zoom = figure.add_axes([0.62, 0.36, 0.36, 0.52])
    near = np.all(np.abs(points - centre) < 1.5 * reach, axis=1)
    zoom.set_xlim(centre[0] - reach, centre[0] + reach)
    zoom.set_ylim(centre[1] - reach, centre[1] + reach)
    scatter(zoom, points[near], pressure[near], wall[near], norm, colours, spacing)
    zoom.set_xticks([])
    zoom.set_yticks([])
    axis.indicate_inset_zoom(zoom, edgecolor=INK)
    colour_bar(figure, [0.66, 0.315, 0.28, 0.014], norm, colours, "fluid pressure [kPa]", pressure[~wall])

    below = figure.add_axes([0.085, 0.075, 0.88, 0.155])
    plot_history(below, table, frame.time)
    path = os.path.join(directory, "full_micro.png")
    figure.savefig(path, dpi=150)
    plt.close(figure)
    return path


def main(directory):
    """Paths of the pictures made."""
    return [picture(directory)] if has_history(directory, "cells.xdmf") else []


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
