"""Spheroids and monolayers as pictures: growth curves beside growth at the input's own cycle time, and a cut through the middle
coloured by pressure, volume and state. Used by the scenes' own scripts.
"""
import os
import sys

import numpy as np
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.patches import Circle

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, beyond, input_entries, plt, read_table, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402

STATES = ["proliferating", "quiescent", "necrotic", "lysed"]
STATE_COLOURS = ["#7fb069", "#e0c060", "#8a5a44", "#4a3b35"]


def cut_of(frame, flat=False, wall=None):
    """(x, y, radius of the section, index) of the spheres that the plane through their centroid cuts, in um; inside a capsule the plane through its centre."""
    x = frame.points * 1e6
    radius = frame.field("radius") * 1e6
    x = x - (x.mean(axis=0) if wall is None else 0.0)
    away = np.zeros(len(x)) if flat else x[:, 2]
    section = np.sqrt(np.maximum(radius**2 - away**2, 0))
    index = np.flatnonzero(section > 0.3 * radius)
    return x[index, 0], x[index, 1], section[index], index


def body_of(directory, frame, flat=False):
    """Lines (um) in which the plane of cut_of cuts the rigid body of the run at the same time; none without one."""
    if not os.path.exists(os.path.join(directory, "body.xdmf")):
        return []
    body = min(frames(directory, "body"), key=lambda one: abs(one.time - frame.time))
    centre = frame.points.mean(axis=0)
    if flat:
        centre[2] = 0.0
    corners = (body.points - centre)[body.cells] * 1e6
    lines = []
    for triangle in corners:
        cut = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            high, low = triangle[a, 2], triangle[b, 2]
            if (high > 0) != (low > 0):
                cut.append((triangle[a] + (triangle[b] - triangle[a]) * high / (high - low))[:2])
        if len(cut) == 2:
            lines.append(cut)
    return lines


def draw_cells(axis, place, values, colours, norm, wall=None, body=()):
    x, y, section, index = place
    order = np.argsort(-section)
    patches = PatchCollection([Circle((x[k], y[k]), section[k]) for k in order], cmap=colours, norm=norm, edgecolor=INK, linewidth=0.25)
    patches.set_array(values[index][order])
    axis.add_collection(patches)
    reach = np.max(np.hypot(x, y) + section) * 1.03
    if wall is not None:  # um
        axis.add_patch(Circle((0, 0), wall, facecolor="none", edgecolor=ACCENT, linewidth=1.6))
        reach = max(reach, 1.03 * wall)
    if len(body):
        axis.add_collection(LineCollection(body, colors=ACCENT, linewidths=1.8))
        reach = max(reach, 1.03 * min(np.abs(np.array(body)).max(), 1.5 * reach))
    axis.set_xlim(-reach, reach)
    axis.set_ylim(-reach, reach)
    axis.set_aspect("equal")
    style(axis)
    return patches


def draw_cut(directory, flat=False, time=None, wall=None):
    """cells_cut.png of the last frame, or of the one nearest to a time (s); None without fields. wall(time): inner radius (um) of a capsule about the origin."""
    if not os.path.exists(os.path.join(directory, "cells.xdmf")):
        return None
    frame = frames(directory, "cells")[-1] if time is None else min(frames(directory, "cells"), key=lambda one: abs(one.time - time))
    wall = None if wall is None else wall(frame.time)
    place, body = cut_of(frame, flat, wall), body_of(directory, frame, flat)
    figure, panels = plt.subplots(1, 3, figsize=(14, 4.9), layout="constrained")
    pressure, volume, state = frame.field("pressure"), frame.field("volume") * 1e18, frame.field("state")
    low, high = np.percentile(pressure[place[3]], [2, 98])
    most = max(abs(low), abs(high), 1e-9)
    for axis, values, label, colours, norm in (
            (panels[0], pressure, "pressure [Pa]", "RdBu_r", Normalize(-most, most)),  # white is 0 in every run
            (panels[1], volume, "volume [µm³]", "cividis", Normalize(*np.percentile(volume[place[3]], [2, 98])))):
        bar = figure.colorbar(draw_cells(axis, place, values, colours, norm, wall, body), ax=axis, shrink=0.85, extend=beyond(norm, values[place[3]]))
        bar.ax.set_title(label, fontsize=9, color=INK)  # beside the bar it would stand at the next panel
    bar = figure.colorbar(draw_cells(panels[2], place, state, ListedColormap(STATE_COLOURS), Normalize(-0.5, 3.5), wall, body), ax=panels[2],
                          ticks=range(4), shrink=0.85)
    bar.ax.set_yticklabels(STATES, fontsize=8)
    bar.ax.set_title("state", fontsize=9, color=INK)
    for axis in panels:
        axis.set_xlabel("x [µm]", color=INK)
        axis.set_ylabel("y [µm]", color=INK)
    figure.suptitle(f"{'From above' if flat else 'Cut through the middle'} at {frame.time / 3600:.0f} h, {len(volume)} cells" + (f"; ring: the capsule's inner wall, radius {wall:.1f} µm" if wall is not None else "; line: the rigid body's surface" if len(body) else "") + "; cells overlap where they touch",
                    color=INK, fontsize=11)
    path = os.path.join(directory, "cells_cut.png")
    figure.savefig(path, dpi=110)
    plt.close(figure)
    return path


def draw_growth(directory, flat=False):
    """spheroid_growth.png: number of cells and radius over time, beside cells that all divide once a cycle of the input."""
    table = read_table(os.path.join(directory, "growth.csv"))
    cycle = float(input_entries(directory).get(("Cell", "Cycle time"), "nan")) / 3600
    t = table["time [s]"] / 3600
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.4), layout="constrained")
    cells = table["cells"]
    left.semilogy(t, cells, color=ALONG, linewidth=2, label="cells")
    if np.isfinite(cycle):
        # Through the last point: cells that begin at one age, newborn, are a quarter below a line through the first for good.
        left.semilogy(t, cells[-1] * 2 ** ((t - t[-1]) / cycle), color=INK, linewidth=1, linestyle=(0, (4, 3)),
                      label=f"doubling every {cycle:g} h (the input's Cycle time),\nthrough the last point")
    for name, colour in zip(STATES, STATE_COLOURS):
        if np.any(table[name] > 0) and np.any(table[name] < cells):
            left.semilogy(t, np.where(table[name] > 0, table[name], np.nan), color=colour, linewidth=1.3, label=name)
    draw_data(left, "time [s]", "cells", 1 / 3600)
    left.set_ylabel("cells", color=INK)
    radius = table["radius [m]"] * 1e6
    right.plot(t, radius, color=ACCENT, linewidth=2, label="radius: mean of the cells at the outside")
    right.plot(t, table["gyration_radius [m]"] * 1e6, color=ALONG, linewidth=1.2, label="radius of gyration")
    if np.isfinite(cycle):
        right.plot(t, radius[-1] * 2 ** ((t - t[-1]) / ((2 if flat else 3) * cycle)), color=INK, linewidth=1, linestyle=(0, (4, 3)),
                   label=f"{'area' if flat else 'volume'} doubling every {cycle:g} h,\nthrough the last point")
    draw_data(right, "time [s]", "radius [m]", 1 / 3600, 1e6)
    right.set_ylabel("radius [µm]", color=INK)
    for axis in (left, right):
        axis.set_xlabel("time [h]", color=INK)
        axis.legend(frameon=False, fontsize=8)
        style(axis)
    path = os.path.join(directory, "spheroid_growth.png")
    figure.savefig(path, dpi=110)
    plt.close(figure)
    return path


def main(directory, flat=False):
    """Paths of the pictures made."""
    return [path for path in (draw_growth(directory, flat), draw_cut(directory, flat)) if path]
