"""The picture of a tissue_gravity run: the deformed tissue with some of its RVEs blown up
beside their quadrature points, and the displacement of the probe over time.

main(directory) reads tissue.xdmf and its frames, rve_outlines.csv and probe.csv, and writes
tissue_gravity.png into the same directory: the frame nearest to the probe's deepest point.
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import ConnectionPatch

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, INK, colour_bar, has_history, plot_history, read_table, scale_bar  # noqa: E402
from fields import frames  # noqa: E402


def read_rves(path, time):
    """At the written time nearest to `time`, per RVE: position (m), F, periods (m), pressure and shear stress (Pa), rings (m)."""
    table = read_table(path)
    if not len(table["time [s]"]):  # Outlined RVEs = 0
        return []
    now = table["time [s]"][np.argmin(np.abs(table["time [s]"] - time))]
    table = {name: column[table["time [s]"] == now] for name, column in table.items()}
    rves = []
    for number in np.unique(table["rve"]):
        rows = table["rve"] == number
        first = np.flatnonzero(rows)[0]
        F = np.array([[table[f"F_{a}{b} [1]"][first] for b in "xy"] for a in "xy"])
        lattice = np.diag([table["period_x [m]"][first], table["period_y [m]"][first]])
        if "period_xy [m]" in table:  # rows of cells that are moved, or cells that are turned
            lattice[0, 1], lattice[1, 0] = table["period_xy [m]"][first], table["period_yx [m]"][first]
        rings = []
        for ring in np.unique(table["ring"][rows]):
            pick = rows & (table["ring"] == ring)
            rings.append(np.column_stack([table["x [m]"][pick], table["y [m]"][pick]]))
        rves.append(
            dict(
                at=np.array([table["point_x [m]"][first], table["point_y [m]"][first]]),
                F=F,
                periods=F @ lattice,
                square_grid=np.isclose(*np.diag(lattice)) and "period_xy [m]" not in table,
                pressure=table["pressure [Pa]"][first],
                shear_stress=table["stress_xy [Pa]"][first],
                rings=rings,
            )
        )
    return rves


def cell_lines(reference, points, period):
    """The borders of the cells, moved with the mesh: curves of points (m)."""
    xs, ys = (np.unique(np.round(reference[:, k], 12)) for k in (0, 1))
    column, row = (np.searchsorted(v, np.round(reference[:, k], 12)) for k, v in ((0, xs), (1, ys)))
    moved = np.zeros((len(xs), len(ys), 2))
    moved[column, row] = points

    def at(x, y):
        i = np.clip(np.searchsorted(xs, x) - 1, 0, len(xs) - 2)
        j = np.clip(np.searchsorted(ys, y) - 1, 0, len(ys) - 2)
        a = ((x - xs[i]) / (xs[i + 1] - xs[i]))[:, None]
        b = ((y - ys[j]) / (ys[j + 1] - ys[j]))[:, None]
        return (1 - b) * ((1 - a) * moved[i, j] + a * moved[i + 1, j]) + b * (
            (1 - a) * moved[i, j + 1] + a * moved[i + 1, j + 1]
        )

    curves = []
    for k in range(1, int(round(xs[-1] / period))):
        s = np.linspace(ys[0], ys[-1], 81)
        curves.append(at(np.full(81, k * period), s))
    for k in range(1, int(round(ys[-1] / period))):
        s = np.linspace(xs[0], xs[-1], 81)
        curves.append(at(s, np.full(81, k * period)))
    return curves


def turn_and_shear(F):
    """Degrees: of the rotation in F (positive against the clock), and by how much the right angle between its axes has become less."""
    turned = np.arctan2(F[1, 0] - F[0, 1], F[0, 0] + F[1, 1])  # of R in F = R U
    angle = np.arctan2(F[1, 1], F[0, 1]) - np.arctan2(F[1, 0], F[0, 0])
    return np.degrees(turned), 90.0 - np.degrees(angle) % 360.0


def draw_rve(axis, rve, colour, reach):
    """The RVE in the middle of its own periodic images; x, y in um about its centre."""
    centre = np.concatenate(rve["rings"]).mean(axis=0)
    for i in range(-2, 3):
        for j in range(-2, 3):
            shift = rve["periods"] @ np.array([i, j])
            own = i == 0 and j == 0
            for ring in rve["rings"]:
                axis.fill(
                    *((ring - centre + shift) * 1e6).T,
                    facecolor=colour,
                    alpha=1.0 if own else 0.30,
                    edgecolor=INK,
                    linewidth=1.3 if own else 0.5,
                    zorder=3 if own else 2,
                )
    axis.set_xlim(-reach, reach)
    axis.set_ylim(-reach, reach)
    axis.set_aspect("equal")
    axis.set_xticks([])
    axis.set_yticks([])
    for spine in axis.spines.values():
        spine.set_color(INK)
        spine.set_linewidth(0.9)


def picture(directory):
    probe_table = read_table(os.path.join(directory, "probe.csv"))
    deepest = probe_table["time [s]"][np.argmin(probe_table["displacement_y [m]"])]
    frame = min(frames(directory, "tissue"), key=lambda one: abs(one.time - deepest))
    time, points = frame.time, frame.points[:, :2]
    cells = frame.cells.reshape(-1, 4)
    reference = points - frame.field("displacement").reshape(len(points), 3)[:, :2]
    shear = np.abs(frame.field("stress").reshape(len(cells), 9)[:, 1]) / 1e3
    outlines = os.path.join(directory, "rve_outlines.csv")
    rves = read_rves(outlines, time) if os.path.exists(outlines) else []
    width = np.ptp(reference[:, 0]) * 1e3

    norm = matplotlib.colors.Normalize(0, max([shear.max(), 1e-3] + [abs(rve["shear_stress"]) / 1e3 for rve in rves]))
    colours = matplotlib.colors.LinearSegmentedColormap.from_list(
        "leaf", ["#f4f8e6", "#cfe3a4", "#8dc085", "#3f8f7f", "#1d5470"]
    )

    high_figure, wide_figure = 8.4, 12.6
    figure = plt.figure(figsize=(wide_figure, high_figure), facecolor="white")
    axis = figure.add_axes([0.22, 0.33, 0.53, 0.60])
    # The mean of each element as it is: smoothed over its neighbours it would be far off the stress of the cells beside it.
    axis.add_collection(PolyCollection(points[cells] * 1e3, array=shear, cmap=colours, norm=norm, edgecolor="face", linewidth=0.3, zorder=2))
    # Only square cells as they lie have borders that are the same lines everywhere.
    square = bool(rves) and rves[0]["square_grid"]
    period = np.linalg.norm(np.linalg.solve(rves[0]["F"], rves[0]["periods"][:, 0])) if square else np.inf
    if np.isfinite(period):
        curves = [c * 1e3 for c in cell_lines(reference, points, period)]
        axis.add_collection(LineCollection(curves, colors=INK, linewidths=0.45, alpha=0.8, zorder=3))
    low, high = reference.min(axis=0) * 1e3, reference.max(axis=0) * 1e3
    border = [np.flatnonzero(np.isclose(reference[:, k] * 1e3, v, atol=1e-6 * width)) for k, v in
              ((1, low[1]), (0, high[0]), (1, high[1]))]
    for k, side in zip((0, 1, 0), border):
        side = side[np.argsort(reference[side, k])]
        axis.plot(*points[side].T * 1e3, color=INK, linewidth=1.4, zorder=4)
    ghost = np.array([low, [high[0], low[1]], high, [low[0], high[1]], low])
    axis.plot(*ghost.T, color="#8795a1", linewidth=1.0, linestyle=(0, (4, 3)), zorder=1)
    axis.annotate("without load", (high[0], high[1]), (-2, 3), textcoords="offset points", color="#8795a1", fontsize=9, ha="right", va="bottom")
    hatch = np.linspace(low[1] + 0.03 * width, high[1], 25)
    axis.add_collection(
        LineCollection([[(low[0], y), (low[0] - 0.03 * width, y - 0.03 * width)] for y in hatch], colors=INK, linewidths=0.8)
    )
    axis.plot([low[0], low[0]], [low[1], high[1]], color=INK, linewidth=2.4, zorder=5)
    for x in low[0] + width * np.array([0.3, 0.5, 0.7]):
        y = high[1] + 0.12 * width
        axis.annotate("", (x, y - 0.1 * width), (x, y), arrowprops=dict(arrowstyle="-|>", color=ACCENT, linewidth=1.8), zorder=5)
    axis.text(low[0] + 0.73 * width, high[1] + 0.07 * width, "body force", color=ACCENT, fontsize=10, va="center")
    side = border[1][np.argsort(reference[border[1], 1])]
    half = 0.5e-3 * (low[1] + high[1])
    probe = [np.interp(half, reference[side, 1], points[side, k]) * 1e3 for k in (0, 1)]
    axis.plot(*probe, "o", markersize=9, markerfacecolor="none", markeredgecolor=ACCENT, markeredgewidth=2, zorder=6)
    axis.annotate("probe", probe, (8, -16), textcoords="offset points", color=ACCENT, fontsize=10)
    axis.set_xlim(low[0] - 0.07 * width, high[0] + 0.12 * width)
    axis.set_ylim(min(points[:, 1].min() * 1e3, low[1]) - 0.055 * width, high[1] + 0.14 * width)
    axis.set_aspect("equal")
    axis.axis("off")
    foot = min(points[:, 1].min() * 1e3, low[1]) - 0.035 * width
    scale_bar(axis, low[0], foot, width)
    axis.set_title(f"A piece of plant tissue and its cells, t = {time * 1e3:.2f} ms (true scale)", color=INK, fontsize=13, pad=4)

    rves.sort(key=lambda r: r["at"][0])
    half_count = (len(rves) + 1) // 2
    columns = [(0.02, sorted(rves[:half_count], key=lambda r: -r["at"][1])),
               (0.825, sorted(rves[half_count:], key=lambda r: -r["at"][1]))]
    height, top, foot_of_insets = 0.19, 0.955, 0.29
    for left, column in columns:
        for k, rve in enumerate(column):
            place = 0.5 if len(column) == 1 else k / (len(column) - 1)
            bottom_edge = top - height - place * (top - height - foot_of_insets)
            inset = figure.add_axes([left, bottom_edge, height * high_figure / wide_figure, height])
            reach = 0.8e6 * np.max(np.abs(rve["periods"]))
            draw_rve(inset, rve, colours(norm(abs(rve["shear_stress"]) / 1e3)), reach)
            turned, sheared = turn_and_shear(rve["F"])
            inset.set_title(f"turned {turned:+.1f}°, sheared {sheared:+.1f}°\n"
                            f"shear stress {abs(rve['shear_stress']) / 1e3:.1f} kPa, fluid {rve['pressure'] / 1e3:.0f} kPa", fontsize=8, color=INK, pad=3)
            at = rve["at"] * 1e3
            axis.plot(*at, "s", markersize=6, markerfacecolor="white", markeredgecolor=INK, markeredgewidth=1.3, zorder=6)
            edge = (1.0, 0.5) if left < 0.5 else (0.0, 0.5)
            figure.add_artist(
                ConnectionPatch(edge, at, coordsA=inset.transAxes, coordsB=axis.transData, color=INK, linewidth=0.9, zorder=5)
            )
    colour_bar(figure, [0.50, 0.325, 0.22, 0.014], norm, colours, "size of the shear stress [kPa]\n(tissue: mean of each element; cells: at their own point)")

    below = figure.add_axes([0.085, 0.075, 0.88, 0.165])
    plot_history(below, probe_table, time)
    path = os.path.join(directory, "tissue_gravity.png")
    figure.savefig(path, dpi=150)
    plt.close(figure)
    return path


def main(directory):
    """Paths of the pictures made."""
    return [picture(directory)] if has_history(directory, "tissue.xdmf") else []


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
