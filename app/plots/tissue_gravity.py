"""The picture of a tissue_gravity run: the deformed tissue with some of its RVEs blown up
beside their quadrature points, and the displacement of the probe over time.

main(directory) reads tissue.xdmf/.h5, rve_outlines.csv and probe.csv and writes
tissue_gravity.png and probe.png into the same directory. Panels whose file is missing are left out.
"""
import csv
import os
import sys
import xml.etree.ElementTree as xml

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import ConnectionPatch

INK = "#22313f"
ACCENT = "#b5432e"


def read_table(path):
    """{column: array} of a CSV file with one header line."""
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    data = np.array([[float(x) for x in row] for row in rows[1:]]).reshape(-1, len(rows[0]))
    return {name.strip(): data[:, k] for k, name in enumerate(rows[0])}


def read_last_frame(path):
    """(time, points, cells, {field: values}) of the last grid of an XDMF file."""
    import h5py

    def values(item):
        name, key = item.text.strip().split(":", 1)
        with h5py.File(os.path.join(os.path.dirname(path), name), "r") as file:
            return np.array(file[key])

    grids = [g for g in xml.parse(path).getroot().iter("Grid") if g.get("GridType", "Uniform") == "Uniform"]
    grid = grids[-1]
    points = values(grid.find("Geometry").find("DataItem")).reshape(-1, 3)[:, :2]
    cells = values(grid.find("Topology").find("DataItem")).reshape(-1, 4)
    fields = {a.get("Name"): values(a.find("DataItem")) for a in grid.findall("Attribute")}
    return float(grid.find("Time").get("Value")), points, cells, fields


def field(fields, start):
    for name, values in fields.items():
        if name.startswith(start):
            return values
    return None


def read_rves(path):
    """Per RVE: position (m), F, periods (m), pressure (Pa), rings of points (m)."""
    table = read_table(path)
    rves = []
    for number in np.unique(table["rve [1]"]):
        rows = table["rve [1]"] == number
        first = np.flatnonzero(rows)[0]
        one = lambda name: table[name][first]
        F = np.array([[one("F_xx [1]"), one("F_xy [1]")], [one("F_yx [1]"), one("F_yy [1]")]])
        rings = []
        for ring in np.unique(table["ring [1]"][rows]):
            pick = rows & (table["ring [1]"] == ring)
            rings.append(np.column_stack([table["x [m]"][pick], table["y [m]"][pick]]))
        rves.append(
            dict(
                at=np.array([one("point_x [m]"), one("point_y [m]")]),
                F=F,
                periods=F @ np.diag([one("period_x [m]"), one("period_y [m]")]),
                pressure=one("pressure [Pa]"),
                rings=rings,
            )
        )
    return rves


def style(axis):
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axis.spines[side].set_color(INK)
    axis.tick_params(colors=INK, labelsize=8)


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
    time, points, cells, fields = read_last_frame(os.path.join(directory, "tissue.xdmf"))
    displacement = field(fields, "displacement")
    displacement = np.zeros((len(points), 3)) if displacement is None else displacement.reshape(len(points), -1)
    reference = points - displacement[:, :2]
    pressure = field(fields, "pressure")
    pressure = np.zeros(len(cells)) if pressure is None else pressure.reshape(len(cells)) / 1e3
    outlines = os.path.join(directory, "rve_outlines.csv")
    rves = read_rves(outlines) if os.path.exists(outlines) else []
    width = np.ptp(reference[:, 0]) * 1e3

    middle = np.median(pressure)
    spread = max(np.max(np.abs(pressure - middle)), 1e-3)
    norm = matplotlib.colors.Normalize(middle - spread, middle + spread)
    colours = plt.get_cmap("RdYlBu_r")

    figure = plt.figure(figsize=(12.6, 6.6), facecolor="white")
    axis = figure.add_axes([0.23, 0.09, 0.46, 0.82])
    axis.add_collection(
        PolyCollection(
            points[cells] * 1e3, array=pressure, cmap=colours, norm=norm, edgecolors=INK, linewidths=0.7, zorder=2
        )
    )
    low, high = reference.min(axis=0) * 1e3, reference.max(axis=0) * 1e3
    ghost = np.array([low, [high[0], low[1]], high, [low[0], high[1]], low])
    axis.plot(*ghost.T, color="#8795a1", linewidth=1.0, linestyle=(0, (4, 3)), zorder=1)
    # The clamp
    hatch = np.linspace(low[1], high[1], 25)
    axis.add_collection(
        LineCollection([[(low[0], y), (low[0] - 0.03 * width, y - 0.03 * width)] for y in hatch], colors=INK, linewidths=0.8)
    )
    axis.plot([low[0], low[0]], [low[1], high[1]], color=INK, linewidth=2.0)
    # The body force
    x, y = low[0] + 0.5 * width, high[1] + 0.13 * width
    axis.annotate(
        "", (x, y - 0.11 * width), (x, y), arrowprops=dict(arrowstyle="-|>", color=ACCENT, linewidth=2.0), zorder=5
    )
    axis.text(x + 0.03 * width, y - 0.04 * width, "body force", color=ACCENT, fontsize=10, va="center")
    # The probe
    side = np.flatnonzero(np.abs(reference[:, 0] * 1e3 - high[0]) < 1e-6 * width)
    side = side[np.argsort(reference[side, 1])]
    half = 0.5e-3 * (low[1] + high[1])
    probe = [np.interp(half, reference[side, 1], points[side, k]) * 1e3 for k in (0, 1)]
    axis.plot(*probe, "o", markersize=9, markerfacecolor="none", markeredgecolor=ACCENT, markeredgewidth=2, zorder=6)
    axis.annotate("probe", probe, (10, 8), textcoords="offset points", color=ACCENT, fontsize=10)
    axis.set_xlim(low[0] - 0.06 * width, high[0] + 0.14 * width)
    bottom = min(points[:, 1].min() * 1e3, low[1])
    axis.set_ylim(bottom - 0.05 * width, high[1] + 0.15 * width)
    axis.set_aspect("equal")
    axis.set_xlabel("x [mm]", color=INK)
    axis.set_ylabel("y [mm]", color=INK)
    style(axis)
    axis.set_title(f"Tissue and its cells at t = {time * 1e3:.3f} ms, true scale", color=INK, fontsize=12, pad=12)

    # Insets: left column for the points nearest the clamp, right column for the others.
    rves.sort(key=lambda r: r["at"][0])
    half_count = (len(rves) + 1) // 2
    columns = [(0.015, sorted(rves[:half_count], key=lambda r: -r["at"][1])),
               (0.80, sorted(rves[half_count:], key=lambda r: -r["at"][1]))]
    height = 0.27
    for left, column in columns:
        for k, rve in enumerate(column):
            gap = (0.88 - height * len(column)) / max(len(column) - 1, 1) if len(column) > 1 else 0.0
            bottom_edge = 0.93 - height - k * (height + gap) if len(column) > 1 else 0.93 - height - 0.3
            inset = figure.add_axes([left, bottom_edge, height * 6.6 / 12.6, height])
            reach = 0.85e6 * np.max(np.abs(rve["periods"]))
            draw_rve(inset, rve, colours(norm(rve["pressure"] / 1e3)), reach)
            shear = rve["F"][0, 1] + rve["F"][1, 0]
            inset.set_title(f"p = {rve['pressure'] / 1e3:.1f} kPa   shear = {shear:+.3f}", fontsize=7.5, color=INK, pad=3)
            at = rve["at"] * 1e3
            axis.plot(*at, "s", markersize=6, markerfacecolor="white", markeredgecolor=INK, markeredgewidth=1.3, zorder=6)
            edge = (1.0, 0.5) if left < 0.5 else (0.0, 0.5)
            figure.add_artist(
                ConnectionPatch(
                    edge, at, coordsA=inset.transAxes, coordsB=axis.transData, color=INK, linewidth=0.9, zorder=5, alpha=0.8
                )
            )
    bar = figure.add_axes([0.715, 0.16, 0.012, 0.5])
    scale = figure.colorbar(plt.cm.ScalarMappable(norm=norm, cmap=colours), cax=bar)
    scale.set_label("mean fluid pressure [kPa]", color=INK, fontsize=9)
    scale.ax.tick_params(labelsize=8, colors=INK)
    scale.outline.set_visible(False)
    figure.savefig(os.path.join(directory, "tissue_gravity.png"), dpi=150)
    plt.close(figure)


def history(directory):
    table = read_table(os.path.join(directory, "probe.csv"))
    figure, axis = plt.subplots(figsize=(7.2, 4.0), facecolor="white")
    t = table["time [s]"] * 1e3
    axis.axhline(0, color="#c8d0d6", linewidth=0.8)
    axis.plot(t, table["displacement_y [m]"] * 1e6, color=ACCENT, linewidth=2, label="down and up (y)")
    axis.plot(t, table["displacement_x [m]"] * 1e6, color="#3d6e99", linewidth=1.5, label="along (x)")
    axis.set_xlabel("time [ms]", color=INK)
    axis.set_ylabel("displacement [um]", color=INK)
    axis.set_title("Middle of the right side", color=INK, fontsize=11)
    axis.legend(frameon=False, fontsize=9)
    style(axis)
    figure.tight_layout()
    figure.savefig(os.path.join(directory, "probe.png"), dpi=150)
    plt.close(figure)


def main(directory):
    if os.path.exists(os.path.join(directory, "probe.csv")):
        history(directory)
    if os.path.exists(os.path.join(directory, "tissue.xdmf")):
        picture(directory)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
