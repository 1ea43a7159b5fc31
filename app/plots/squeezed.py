"""The picture of a cell between plates (cell_compression, cell_impact, cell_failure): the cell at a few moments above, forces and what
they are compared with below."""
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


def picture(directory, name, title):
    table = read_table(os.path.join(directory, "force.csv"))
    deformation = table["deformation [1]"]
    moments = cell_frames(directory)
    # a plate with mass may have left the cell again
    touched = [m for m in moments if np.interp(m[0].time, table["time [s]"], deformation) > -0.02]
    moments = touched if len(touched) > 1 else moments
    # the start, the end, and two between; with a wall that breaks the first frame after that
    chosen = sorted({0, len(moments) // 3, 2 * len(moments) // 3, len(moments) - 1})
    flat = moments[0][0].cells.shape[1] == 2
    if flat:
        values = np.concatenate([m[1].field("pressure").ravel() / 1e3 for m in (moments[k] for k in chosen) if m[1]])
    else:
        values = np.concatenate([moments[k][0].field("stretch").ravel() for k in chosen])
        values = values[values > 0]
    norm = matplotlib.colors.Normalize(*np.percentile(values, [1, 99]))
    colours = "viridis" if flat else "inferno"
    figure = plt.figure(figsize=(11.5, 7.6), facecolor="white")
    axis_of_height = 1 if flat else 2
    reach = np.abs(moments[-1][0].points[:, 0]).max() * 1e6
    top = moments[0][0].points[:, axis_of_height].max() * 1e6
    bottom = moments[0][0].points[:, axis_of_height].min() * 1e6
    for k, index in enumerate(chosen):
        wall, fluid = moments[index]
        axis = figure.add_axes([0.02 + 0.245 * k, 0.55, 0.235, 0.36])
        height = wall.points[:, axis_of_height] * 1e6
        draw_cell(axis, wall, fluid, norm, reach, plates=(height.min(), height.max()), colours=colours)
        axis.set_ylim(bottom - 0.12 * (top - bottom), top + 0.12 * (top - bottom))
        reached = np.interp(wall.time, table["time [s]"], deformation)
        axis.set_title(f"{100 * reached:.0f} %", fontsize=10, color=INK)
    figure.suptitle(title, fontsize=12, color=INK, y=0.975)
    colour_bar(figure, [0.36, 0.525, 0.28, 0.014], norm, plt.get_cmap(colours),
               "fluid pressure [kPa]" if flat else "stretch of the wall", values)

    left = figure.add_axes([0.075, 0.085, 0.52, 0.345])
    unit = 1e3
    slow = os.path.join(directory, "mean_force.csv")
    thick = 0.6 if os.path.exists(slow) else 1.8
    left.plot(100 * deformation, unit * table["force_upper [N]"], color=ACCENT, linewidth=thick, label="upper plate")
    left.plot(100 * deformation, unit * table["force_lower [N]"], color=ALONG, linewidth=thick, label="lower plate")
    if os.path.exists(slow):
        mean = read_table(slow)
        left.plot(100 * mean["deformation [1]"], unit * mean["force [N]"], color=ACCENT, linewidth=2.2, label="mean over 2 % of deformation")
    balloon = os.path.join(directory, "balloon.csv")
    if os.path.exists(balloon):
        model = read_table(balloon)
        for kind, dash, label in ((0, "--", "balloon, spring net"), (1, ":", "balloon, neo-Hookean")):
            mine = model["membrane"] == kind
            left.plot(100 * model["deformation [1]"][mine], unit * model["force [N]"][mine], color=INK, linestyle=dash,
                      linewidth=1.2, label=label)
    for column in ("force_upper [N]", "force_lower [N]"):
        draw_data(left, "deformation [1]", column, 100, unit)
    if os.path.exists(slow):
        draw_data(left, "deformation [1]", "force [N]", 100, unit)
    left.set_xlabel("deformation [%]", fontsize=9, color=INK)
    left.set_ylabel("force on a plate [mN]", fontsize=9, color=INK)
    left.set_xlim(0, 100 * deformation.max())
    left.set_ylim(0, None)
    left.legend(frameon=False, fontsize=9)
    style(left)

    right = figure.add_axes([0.68, 0.085, 0.265, 0.345])
    right.plot(100 * deformation, table["mean_stretch_upper [1]"], color=ACCENT, linewidth=1.6, label="upper half")
    right.plot(100 * deformation, table["mean_stretch_lower [1]"], color=ALONG, linewidth=1.6, label="lower half")
    for column in ("mean_stretch_upper [1]", "mean_stretch_lower [1]"):
        draw_data(right, "deformation [1]", column, 100)
    right.set_xlabel("deformation [%]", fontsize=9, color=INK)
    right.set_ylabel("mean stretch of the wall", fontsize=9, color=INK)
    right.set_xlim(0, 100 * deformation.max())
    right.legend(frameon=False, fontsize=9, loc="best")
    style(right)
    if table["broken_bonds"][-1] > 0:
        count = right.twinx()
        count.plot(100 * deformation, table["broken_bonds"], color=INK, linestyle="--", linewidth=1.2)
        count.set_ylabel("broken bonds (dashed)", fontsize=9, color=INK)
        count.tick_params(colors=INK, labelsize=8)
        count.spines["top"].set_visible(False)
    path = os.path.join(directory, name + ".png")
    figure.savefig(path, dpi=150)
    plt.close(figure)
    return path


def pictures(directory, name, title):
    rows = read_table(os.path.join(directory, "force.csv")) if os.path.exists(os.path.join(directory, "force.csv")) else {}
    if not has_cell(directory) or not rows or len(rows["time [s]"]) < 2:
        return []
    return [picture(directory, name, title)]
