"""The picture of a tissue_bruise run: the tissue under the tool, every RVE coloured by what has happened to it, some of them
blown up, the tissue at the end, and the forces over time.

main(directory) reads tissue.xdmf, rve_points.csv, rve_outlines.csv, impact.csv and input.prm, and writes tissue_bruise.png. The
tissue is drawn upright: x, the direction of the impact, upwards.
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.patches import ConnectionPatch

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, colour_bar, input_entries, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402
from tissue_gravity import draw_rve, read_rves  # noqa: E402

BRUISE = matplotlib.colors.LinearSegmentedColormap.from_list("bruise", ["#d9a066", "#8a4b2a", "#4a2318"])
LEAF = matplotlib.colors.LinearSegmentedColormap.from_list("leaf", ["#f1f7df", "#cfe3a4", "#8dc085", "#3f8f7f", "#1d5470"])


def points_at(table, time):
    """The rows of rve_points.csv of the frame nearest to `time`; row k is RVE k."""
    now = table["time [s]"][np.argmin(np.abs(table["time [s]"] - time))]
    return {name: column[table["time [s]"] == now] for name, column in table.items()}


def colours_of(points, stretch_norm):
    colours = LEAF(stretch_norm(points["permanent_stretch [1]"]))
    failed = points["failed [1]"] > 0
    colours[failed] = BRUISE(points["failed [1]"][failed])
    return colours


def draw_tissue(axis, frame, points, stretch_norm, size):
    where = frame.points[:, :2] * 1e3
    cells = frame.cells.reshape(-1, 4)
    edges = np.concatenate([cells[:, [k, (k + 1) % 4]] for k in range(4)])
    edges, count = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    swapped = where[:, ::-1]
    axis.add_collection(LineCollection(swapped[edges[count > 1]], colors="#9aa7a0", linewidths=0.4, zorder=2))
    axis.scatter(points["y [m]"] * 1e3, points["x [m]"] * 1e3, c=colours_of(points, stretch_norm), s=size, marker="o",
                 linewidths=0, zorder=3)
    axis.add_collection(LineCollection(swapped[edges[count == 1]], colors=INK, linewidths=1.3, zorder=4))
    axis.set_aspect("equal")
    axis.axis("off")
    return swapped


def draw_tool(axis, setup, travel, low, high):
    """The tool and the holder, in mm; low, high: corners of the tissue at rest (horizontal, vertical)."""
    face, middle = high[1] - travel * 1e3, 0.5 * (low[0] + high[0])
    if setup.get(("Impact", "Tool")) == "plate":
        axis.fill_between([low[0] - 0.3, high[0] + 0.3], face, face + 0.12, color="#56636e", zorder=5, linewidth=0)
    else:
        radius = float(setup.get(("Impact", "Radius"), 1.5e-3)) * 1e3
        reach = min(radius, 0.62 * (high[0] - low[0]))
        angle = np.linspace(-np.arcsin(reach / radius), np.arcsin(reach / radius), 100)
        x, y = middle + radius * np.sin(angle), face + radius * (1 - np.cos(angle))
        axis.fill_between(x, y, np.maximum(y, face + 0.35), color="#56636e", zorder=5, linewidth=0)
    axis.plot([low[0] - 0.05, high[0] + 0.05], [low[1], low[1]], color=INK, linewidth=2.4, zorder=5)
    axis.add_collection(LineCollection([[(x, low[1]), (x - 0.06, low[1] - 0.07)] for x in np.arange(low[0], high[0] + 0.05, 0.1)],
                                       colors=INK, linewidths=0.8, zorder=1))


def picture(directory):
    impact = read_table(os.path.join(directory, "impact.csv"))
    table = read_table(os.path.join(directory, "rve_points.csv"))
    history = frames(directory, "tissue")
    setup = input_entries(directory)
    t, travel, force = impact["time [s]"], impact["travel [m]"], impact["force [N/m]"]
    written = np.unique(table["time [s]"])
    deepest = written[np.argmax(np.interp(written, t, travel))]
    main_frame = min(history, key=lambda one: abs(one.time - deepest))
    last_frame = history[-1]
    points, last = points_at(table, main_frame.time), points_at(table, last_frame.time)
    stretch_norm = matplotlib.colors.Normalize(0, max(1e-3, table["permanent_stretch [1]"].max()))
    rest = history[0].points[:, :2] * 1e3
    low, high = rest.min(axis=0)[::-1], rest.max(axis=0)[::-1]
    share = np.interp(main_frame.time, t, impact["bruised_share [1]"])

    high_figure, wide_figure = 8.8, 13.0
    figure = plt.figure(figsize=(wide_figure, high_figure), facecolor="white")
    axis = figure.add_axes([0.17, 0.40, 0.66, 0.53])
    where = draw_tissue(axis, main_frame, points, stretch_norm, 26)
    draw_tool(axis, setup, np.interp(main_frame.time, t, travel), low, high)
    axis.set_xlim(min(low[0], where[:, 0].min()) - 0.1, max(high[0], where[:, 0].max()) + 0.1)
    axis.set_ylim(low[1] - 0.1, max(high[1], where[:, 1].max()) + 0.15)
    left = axis.get_xlim()[0] + 0.3 * (high[0] - low[0])  # clear of the lines to the cells at the sides
    scale_bar(axis, left, low[1] - 0.09, 0.6 * (high[0] - low[0]), gap=0.02)
    axis.set_title(f"Plant tissue hit at {float(setup.get(('Impact', 'Speed'), 5)):g} m/s, t = {main_frame.time * 1e3:.2f} ms "
                   f"(true scale): {100 * share:.0f} % of its cells have failed", color=INK, fontsize=13, pad=6)

    outlines = os.path.join(directory, "rve_outlines.csv")
    rves = read_rves(outlines, main_frame.time) if os.path.exists(outlines) else []
    numbers = np.unique(read_table(outlines)["rve"]).astype(int) if rves else []
    swap = np.array([[0.0, 1.0], [1.0, 0.0]])
    for number, rve in zip(numbers, rves):
        rve["number"] = number
        rve["at"], rve["periods"] = swap @ rve["at"], swap @ rve["periods"]
        rve["rings"] = [ring[:, ::-1] for ring in rve["rings"]]
    rves.sort(key=lambda r: r["at"][0])
    half = (len(rves) + 1) // 2
    columns = [(0.015, sorted(rves[:half], key=lambda r: -r["at"][1])), (0.855, sorted(rves[half:], key=lambda r: -r["at"][1]))]
    height, top, foot = 0.165, 0.93, 0.33
    dots = colours_of(points, stretch_norm)
    for side, column in columns:
        for k, rve in enumerate(column):
            place = 0.5 if len(column) == 1 else k / (len(column) - 1)
            bottom = top - height - place * (top - height - foot)
            inset = figure.add_axes([side, bottom, height * high_figure / wide_figure, height])
            number = rve["number"]
            draw_rve(inset, rve, dots[number], 0.8e6 * np.max(np.abs(rve["periods"])))
            failed = points["failed [1]"][number]
            inset.set_title(f"{'failed, ' if failed > 0 else ''}fluid pressure {rve['pressure'] / 1e3:.0f} kPa", fontsize=8,
                            color=ACCENT if failed > 0 else INK, pad=3)
            at = rve["at"] * 1e3
            axis.plot(*at, "s", markersize=7, markerfacecolor="none", markeredgecolor=INK, markeredgewidth=1.5, zorder=6)
            figure.add_artist(ConnectionPatch((1.0, 0.5) if side < 0.5 else (0.0, 0.5), at, coordsA=inset.transAxes,
                                              coordsB=axis.transData, color=INK, linewidth=0.8, zorder=5))
    if rves:
        figure.text(0.015, foot - 0.012, "fluid pressure: over that outside of the tissue", fontsize=8, color=INK, va="top")
    colour_bar(figure, [0.24, 0.355, 0.24, 0.014], stretch_norm, LEAF, "permanent stretch of the walls of whole cells")
    colour_bar(figure, [0.54, 0.355, 0.20, 0.014], matplotlib.colors.Normalize(0, 1), BRUISE, "share of failed cells")

    below = figure.add_axes([0.07, 0.075, 0.55, 0.20])
    below.plot(t * 1e3, force / 1e3, color=ACCENT, linewidth=1.8, label="on the tool")
    below.plot(t * 1e3, impact["transmitted_force [N/m]"] / 1e3, color=ALONG, linewidth=1.4, label="transmitted")
    for column in ("force [N/m]", "transmitted_force [N/m]"):
        draw_data(below, "time [s]", column, 1e3, 1e-3)
    below.axvline(main_frame.time * 1e3, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
    below.set_xlim(0, t[-1] * 1e3)
    below.set_xlabel("time [ms]", color=INK, fontsize=9)
    below.set_ylabel("force per depth [kN/m]", color=INK, fontsize=9)
    style(below)
    twin = below.twinx()
    twin.plot(t * 1e3, 100 * impact["bruised_share [1]"], color="#8a4b2a", linewidth=1.4, linestyle=(0, (5, 2)), label="failed cells")
    draw_data(twin, "time [s]", "bruised_share [1]", 1e3, 100)
    twin.set_ylabel("failed cells [%]", color="#8a4b2a", fontsize=9)
    top, (low, high) = twin.get_ylim()[1], below.get_ylim()
    twin.set_ylim(top * low / high, top)  # both zeros at one height
    twin.set_yticks([tick for tick in twin.get_yticks() if 0 <= tick <= top])
    twin.tick_params(colors="#8a4b2a", labelsize=8)
    twin.spines["top"].set_visible(False)
    lines = [line for line in [*below.get_lines(), *twin.get_lines()] if not line.get_label().startswith("_")]
    below.legend(lines, [line.get_label() for line in lines], frameon=False, fontsize=9, loc="best")

    end = figure.add_axes([0.71, 0.045, 0.27, 0.235])
    draw_tissue(end, last_frame, last, stretch_norm, 6)
    end.autoscale_view()
    end.set_title(f"at the end, t = {last_frame.time * 1e3:.2f} ms: {100 * impact['bruised_share [1]'][-1]:.0f} %", fontsize=9.5,
                  color=INK, pad=3)
    path = os.path.join(directory, "tissue_bruise.png")
    figure.savefig(path, dpi=150)
    plt.close(figure)
    return path


def main(directory):
    """Paths of the pictures made."""
    needed = ["impact.csv", "rve_points.csv", "tissue.xdmf"]
    if not all(os.path.exists(os.path.join(directory, name)) for name in needed):
        return []
    if len(read_table(os.path.join(directory, "impact.csv"))["time [s]"]) < 2:
        return []
    return [picture(directory)]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
