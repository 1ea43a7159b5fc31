"""The pictures of the scenes with an aggregate of cells between plates (tissue_compression, tissue_impact, tissue_failure): cells as
filled polygons coloured by pressure, failed ones hatched, escaped fluid as dots, plates as bars, and the curves of the run below.

picture(directory, name) reads cells.xdmf and its frames and loading.csv, and writes DIR/NAME.png.
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Polygon, Rectangle
from matplotlib.path import Path

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, colour_bar, read_table, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402


def cells_of(frame):
    """Per cell: outline (um), mean fluid pressure (kPa), failed, fluid outside its outline (um)."""
    points = frame.points[:, :2] * 1e6
    wall = frame.field("wall").ravel() > 0.5
    cell = frame.field("cell").ravel().astype(int)
    pressure = frame.field("pressure").ravel() / 1e3
    failed = frame.field("failed").ravel() > 0.5
    for c in range(cell.max() + 1):
        own = cell == c
        outline, fluid = points[own & wall], points[own & ~wall]
        gone = failed[own].any()
        outside = fluid[~Path(outline).contains_points(fluid)] if gone else np.empty((0, 2))
        yield outline, pressure[own & ~wall].mean(), gone, outside


def draw(axis, frame, table, start, norm, colours, plates=True):
    k = int(np.argmin(np.abs(table["time [s]"] - frame.time)))
    for outline, pressure, failed, outside in cells_of(frame):
        axis.add_patch(Polygon(outline, closed=True, facecolor="#d9d2c8" if failed else colours(norm(pressure)),
                               edgecolor=ACCENT if failed else INK, linewidth=1.1 if failed else 0.7,
                               hatch="////" if failed else None))
        if len(outside):
            axis.plot(*outside.T, ".", color="#4a90c2", markersize=1.5)
    low, high, left, right = start
    axis.set_xlim(left, right)
    axis.set_ylim(low - 30, high + 30)
    axis.set_aspect("equal")
    axis.axis("off")
    if plates:
        for y, height in ((low - 12, 12), (table["plate_upper [m]"][k] * 1e6, 12)):
            axis.add_patch(Rectangle((left, y), right - left, height, facecolor="#8795a1", edgecolor="none"))
    axis.set_title(f"strain {100 * table['strain [1]'][k]:.0f} %", color=INK, fontsize=11)
    return k


def picture(directory, name):
    table = read_table(os.path.join(directory, "loading.csv"))
    every = frames(directory, "cells")
    chosen = [every[k] for k in sorted({0, len(every) // 3, (2 * len(every)) // 3, len(every) - 1})]
    points = np.concatenate([f.points[:, :2][f.field("wall").ravel() > 0.5] for f in chosen]) * 1e6
    first = chosen[0].points[:, 1] * 1e6
    margin = 25
    start = (first.min(), table["plate_upper [m]"][0] * 1e6, points[:, 0].min() - margin, points[:, 0].max() + margin)
    values = [p for f in chosen for _, p, gone, _ in cells_of(f) if not gone]
    norm = matplotlib.colors.Normalize(min(values), max(np.percentile(values, 95), min(values) + 1))
    colours = plt.get_cmap("viridis")

    failing = table["failed_cells"].max() > 0 or table["broken_ties"].max() > 0
    # Four pictures in a row at true scale; everything below in inches
    wide, each = 12.5, 12.5 * 0.94 / len(chosen)
    tall = min(each * (start[1] - start[0] + 60) / (start[3] - start[2]), 6.0)
    total = tall + 3.9
    figure = plt.figure(figsize=(wide, total), facecolor="white")
    for k, frame in enumerate(chosen):
        axis = figure.add_axes([0.02 + 0.97 * k / len(chosen), 3.5 / total, 0.94 / len(chosen), tall / total])
        draw(axis, frame, table, start, norm, colours)
    colour_bar(figure, [0.35, 3.35 / total, 0.3, 0.1 / total], norm, colours, "mean fluid pressure of a cell [kPa]" + (", failed cells hatched, fluid that has left them blue" if failing else ""), values)

    strain = 100 * table["strain [1]"]
    left = figure.add_axes([0.07, 0.6 / total, 0.40 if failing else 0.56, 1.9 / total])
    left.plot(strain, table["stress_upper [Pa]"] / 1e3, color=ACCENT, linewidth=1.2, label="moving plate")
    left.plot(strain, table["stress_lower [Pa]"] / 1e3, color=ALONG, linewidth=1.8, label="fixed plate (transmitted)")
    for column in ("stress_upper [Pa]", "stress_lower [Pa]"):
        draw_data(left, "strain [1]", column, 100, 1e-3)
    left.set_xlabel("strain [%]", color=INK, fontsize=9)
    left.set_ylabel("force over area [kPa]", color=INK, fontsize=9)
    left.legend(frameon=False, fontsize=9)
    style(left)
    right = figure.add_axes([0.56 if failing else 0.71, 0.6 / total, 0.38 if failing else 0.27, 1.9 / total])
    if failing:
        right.plot(strain, table["failed_cells"], color=ACCENT, linewidth=1.8, label="failed cells")
        draw_data(right, "strain [1]", "failed_cells", 100)
        right.set_ylabel("failed cells", color=ACCENT, fontsize=9)
        right.yaxis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))
        right.set_ylim(bottom=0)
        if table["broken_ties"].max() > 0:
            twin = right.twinx()
            twin.plot(strain, table["broken_ties"], color=ALONG, linewidth=1.4)
            twin.set_ylabel("broken lamella ties", color=ALONG, fontsize=9)
            twin.set_ylim(bottom=0)
            twin.yaxis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))
            twin.tick_params(labelsize=8, colors=INK)
            twin.spines["top"].set_visible(False)
    else:
        rows = read_table(os.path.join(directory, "rows.csv"))
        names = [n for n in rows if n.startswith("row_")]
        for k, row in enumerate(names):
            share = k / max(1, len(names) - 1)
            right.plot(100 * rows["strain [1]"], 100 * rows[row], color=plt.get_cmap("cividis")(0.9 * share), linewidth=1.3,
                       label={0: "lowest row", len(names) - 1: "row at the moving plate"}.get(k))
        right.set_ylabel("flattening of the rows of cells [%]", color=INK, fontsize=9)
        right.legend(frameon=False, fontsize=8)
    right.set_xlabel("strain [%]", color=INK, fontsize=9)
    style(right)
    path = os.path.join(directory, name + ".png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return path


def pictures(directory, name):
    """Paths of the pictures made."""
    fields, table = os.path.join(directory, "cells.xdmf"), os.path.join(directory, "loading.csv")
    if not (os.path.exists(fields) and os.path.exists(table) and len(read_table(table)["time [s]"]) >= 2):
        return []
    return [picture(directory, name)]
