"""The picture of a spheroid_deformable run: number of cells beside its closed form, size, the surfaces from outside and cut, coloured by pressure."""
import os
import sys

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.ticker import FuncFormatter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cell_surface import draw_surface, section  # noqa: E402
from drawing import ACCENT, ALONG, INK, colour_bar, input_entries, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402

PRESSURE = plt.get_cmap("viridis")


def closed_lines(ends):
    """Segments (n x 2 x 2) joined into closed lines, each k x 2."""
    left = {}
    key = lambda point: tuple(np.round(point, 7))
    for k, (a, b) in enumerate(ends):
        left.setdefault(key(a), []).append((k, b))
        left.setdefault(key(b), []).append((k, a))
    used, lines = set(), []
    for k, (a, b) in enumerate(ends):
        if k in used:
            continue
        used.add(k)
        line, at = [a, b], b
        while True:
            following = [one for one in left[key(at)] if one[0] not in used]
            if not following:
                break
            used.add(following[0][0])
            at = following[0][1]
            line.append(at)
        lines.append(np.array(line))
    return lines


def draw_cut(axis, frame, norm):
    """Cells that the plane through the middle meets, filled by their pressure."""
    middle = 0.5 * (frame.points[:, 2].min() + frame.points[:, 2].max())
    pressure, number = frame.field("pressure").ravel(), frame.field("cell").ravel()
    ends, values = section(frame, middle, pressure)
    if not len(ends):
        return
    whose = section(frame, middle, number)[1]
    polygons, colours = [], []
    for cell in np.unique(np.round(whose)):
        mine = np.abs(whose - cell) < 0.25
        for line in closed_lines(ends[mine]):
            polygons.append(line)
            colours.append(PRESSURE(norm(values[mine].mean())))
    axis.add_collection(PolyCollection(polygons, facecolors=colours, edgecolors=INK, linewidths=0.5))
    axis.autoscale_view()
    axis.set_aspect("equal")


def draw_curves(upper, lower, directory):
    table = read_table(os.path.join(directory, "history.csv"))
    entries = input_entries(directory)
    t = table["time [s]"] / 3600
    upper.set_yscale("log", base=2)
    upper.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    upper.plot(t, table["cells"], color=ALONG, linewidth=1.8, drawstyle="steps-post", label="cells")
    cycle = float(entries.get(("Cell", "Cycle time"), "nan")) / 3600
    if np.isfinite(cycle):
        upper.plot(t, table["cells"][0] * 2 ** (t / cycle), color=INK, linewidth=1, linestyle=(0, (4, 3)), label=f"doubling every {cycle:.3g} h (Cycle time)")
    draw_data(upper, "time [s]", "cells", 1 / 3600)
    upper.set_ylabel("cells", color=INK, fontsize=9)
    lower.plot(t, table["gyration_radius [m]"] * 1e6, color=ACCENT, linewidth=1.8, label="of gyration")
    lower.plot(t, table["radius [m]"] * 1e6, color=ALONG, linewidth=1.2, linestyle="--", label="of the outer cells")
    draw_data(lower, "time [s]", "gyration_radius [m]", 1 / 3600, 1e6)
    lower.set_ylabel("radius [µm]", color=INK, fontsize=9)
    lower.set_xlabel("time [h]", color=INK, fontsize=9)
    for axis in (upper, lower):
        axis.legend(frameon=False, fontsize=8)
        style(axis)


def main(directory):
    """Paths of the pictures made."""
    if not all(os.path.exists(os.path.join(directory, name)) for name in ("history.csv", "surface.xdmf")):
        return []
    shape = frames(directory, "surface")[-1]
    pressure = shape.field("pressure").ravel()
    norm = Normalize(*np.percentile(pressure, [1, 99]) + np.array([0, 1e-9]))
    figure = plt.figure(figsize=(13, 4.8), facecolor="white")
    draw_curves(figure.add_axes([0.065, 0.57, 0.26, 0.38]), figure.add_axes([0.065, 0.11, 0.26, 0.38]), directory)
    outside, cut = figure.add_axes([0.34, 0.2, 0.33, 0.72]), figure.add_axes([0.67, 0.2, 0.33, 0.72])
    draw_surface(outside, shape, norm, (1, 1, 0), (-0.3, 0.3, 1), values=pressure, colours=PRESSURE)
    outside.autoscale_view()
    draw_cut(cut, shape, norm)
    cells = int(shape.field("cell").max()) + 1
    outside.set_title(f"{cells} cells at {shape.time / 3600:.3g} h, from outside", color=INK, fontsize=9.5)
    cut.set_title("cut through the middle", color=INK, fontsize=9.5)
    for axis in (outside, cut):
        axis.axis("off")
    low, high = cut.get_xlim()
    bottom = cut.get_ylim()[0]
    scale_bar(cut, low, bottom - 0.06 * (high - low), high - low, "µm")
    colour_bar(figure, [0.5, 0.12, 0.34, 0.022], norm, PRESSURE, "pressure inside the cells [Pa]", pressure)
    path = os.path.join(directory, "spheroid_deformable.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
