"""The picture of a rod_migration run: the first cell in its network at the start and at the end, and the paths of all cells."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, POINT, colour_bar, input_entries, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402
from matplotlib.colors import Normalize  # noqa: E402
from rod_outline import draw_rod  # noqa: E402

SHADE = "#f3ead8"  # of the stiff half
REACH = 24.0  # µm, shown about the start


def draw_cell(axis, shape, path, norm, nucleus, title):
    lines = shape.points[:, :2][shape.cells.reshape(-1, 2)] * 1e6
    kind, tension, radius = (shape.field(name).ravel() for name in ("kind", "tension", "radius"))
    fibres = kind == 0
    axis.add_collection(LineCollection(lines[fibres], array=tension[fibres] * 1e12, cmap="coolwarm", norm=norm, linewidths=1.0, zorder=1))
    axis.add_collection(LineCollection(lines[kind == 1], color=ACCENT, linewidths=1.8, zorder=4))
    for line, R in zip(lines[kind == 2], radius[kind == 2] * 1e6):
        draw_rod(axis, line[0], line[1], R, nucleus, order=2)
    axis.plot(path[0], path[1], color=INK, linewidth=1.2, zorder=5)
    axis.set_xlim(-REACH, REACH)
    axis.set_ylim(-REACH, REACH)
    axis.set_aspect("equal")
    axis.axis("off")
    axis.set_title(title, color=INK, fontsize=9)


def draw_paths(axis, table, stiff_side):
    """stiff_side: how many times as stiff the right half of the network is."""
    most = 0.0
    seeds = np.unique(table["seed"])
    few = len(seeds) <= 12
    for seed in seeds:
        rows = table["seed"] == seed
        x, y = (table[name][rows] * 1e6 for name in ("x [m]", "y [m]"))
        axis.plot(x, y, color=ALONG, linewidth=1.0 if few else 0.4, alpha=1 if few else 0.5)
        axis.plot(x[-1:], y[-1:], "o", color=ALONG, markersize=POINT if few else 4, markeredgecolor="white", markeredgewidth=0.5, zorder=4)
        most = max(most, np.abs(x).max(), np.abs(y).max())
    most *= 1.1
    if stiff_side != 1:
        axis.axvspan(0, most, color=SHADE, zorder=0)
        ends = np.array([table["x [m]"][table["seed"] == seed][-1] for seed in seeds])
        for x, where, side in ((-most, "left", f"{np.sum(ends <= 0)} end here"), (most, "right", f"{stiff_side:g} times as stiff: {np.sum(ends > 0)} end here")):
            axis.text(x * 0.97, most * 0.97, side, color=INK, fontsize=8, ha=where, va="top", zorder=6, bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.7, "pad": 1})
    axis.set_xlim(-most, most)
    axis.set_ylim(-most, most)
    axis.set_aspect("equal")
    axis.set_xlabel("x [µm]", color=INK, fontsize=9)
    axis.set_ylabel("y [µm]", color=INK, fontsize=9)
    count = len(seeds)
    axis.set_title(f"paths of {'all ' if count > 1 else ''}{count} cell{'s' if count > 1 else ''}, {table['time [s]'].max() / 60:.0f} min" + ("" if few else "; points: where they end"), color=INK, fontsize=9)
    style(axis)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "paths.csv")
    if not os.path.exists(path):
        return []
    table = read_table(path)
    shapes = frames(directory, "cell") if os.path.exists(os.path.join(directory, "cell.xdmf")) else []
    chosen = [shapes[0], shapes[-1]] if len(shapes) > 1 else list(shapes)
    figure = plt.figure(figsize=(4.6 * (1 + len(chosen)), 5.2), facecolor="white")
    if chosen:
        nucleus = float(input_entries(directory).get(("Cell", "Nucleus radius"), 3e-6)) * 1e6
        pulled = np.concatenate([shape.field("tension").ravel()[shape.field("kind").ravel() == 0] for shape in chosen]) * 1e12
        most = max(np.percentile(np.abs(pulled), 99), 1e-3)
        norm = Normalize(-most, most)
        own = table["seed"] == table["seed"][0]
        for k, shape in enumerate(chosen):
            axis = figure.add_axes([(k + 0.02) / (1 + len(chosen)), 0.15, 0.96 / (1 + len(chosen)), 0.78])
            until = own & (table["time [s]"] <= shape.time + 1e-9)
            draw_cell(axis, shape, (table["x [m]"][until] * 1e6, table["y [m]"][until] * 1e6), norm, nucleus, f"the first cell after {shape.time / 60:.0f} min; red lines: protrusions")
            if k == 0:
                scale_bar(axis, -REACH, -REACH - 3.5, 2 * REACH, "µm")
        colour_bar(figure, [0.2, 0.1, 0.26, 0.02], norm, plt.get_cmap("coolwarm"), "tension of a fibre [pN]: blue pushed, red pulled", pulled)
    draw_paths(figure.add_axes([(len(chosen) + 0.15) / (1 + len(chosen)), 0.12, 0.8 / (1 + len(chosen)), 0.8]), table, float(input_entries(directory).get(("Network", "Stiff side"), 1)))
    path = os.path.join(directory, "rod_migration.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
