"""The picture of a texture_test run: force over travel with bio-yield and first failure, failed cells, where the work went, and the
tissue at the end, coloured by what has happened to its cells.

main(directory) reads steps.csv, energies.csv, tissue.xdmf, summary.json and input.prm, and writes texture_test.png. The tissue is
drawn upright: x, the direction of the test, upwards.
"""
import json
import os
import sys

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, colour_bar, input_entries, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402
from tissue_bruise import BRUISE, LEAF  # noqa: E402

FAILED = "#8a4b2a"


def draw_curve(axis, steps, results):
    travel, force = steps["travel [m]"] * 1e3, steps["force [N/m]"] / 1e3
    axis.plot(travel, force, color=ACCENT, linewidth=1.8, label="force on the tool")
    axis.plot(travel, force, ".", color=ACCENT, markersize=3)
    draw_data(axis, "travel [m]", "force [N/m]", 1e3, 1e-3)
    for name, words, mark in (("bio_yield", "bio-yield", "v"), ("at_first_failure", "first failed cell", "o")):
        at = ("travel_at_first_failure", "force_at_first_failure") if mark == "o" else ("bio_yield_travel", "bio_yield_force")
        if all(key in results for key in at):
            axis.plot(results[at[0]] * 1e3, results[at[1]] / 1e3, mark, markersize=8, color=INK, markerfacecolor="none",
                      markeredgewidth=1.5, label=words, linestyle="none")
    axis.set_xlabel("travel of the tool [mm]", color=INK, fontsize=9)
    axis.set_ylabel("force per depth [kN/m]", color=INK, fontsize=9)
    axis.set_ylim(0, None)
    style(axis)
    lines, labels = axis.get_legend_handles_labels()
    if steps["failed_share [1]"].max() > 0:
        twin = axis.twinx()
        lines += twin.plot(travel, 100 * steps["failed_share [1]"], color=FAILED, linewidth=1.4, linestyle=(0, (5, 2)))
        labels.append("failed cells (right)")
        twin.set_ylabel("failed cells [%]", color=FAILED, fontsize=9)
        twin.set_ylim(0, None)
        twin.tick_params(colors=FAILED, labelsize=8)
        twin.spines["top"].set_visible(False)
    axis.legend(lines, labels, frameon=False, fontsize=9, loc="upper left", bbox_to_anchor=(0.0, 1.02))


def draw_energies(axis, steps, energies):
    travel = steps["travel [m]"] * 1e3
    for column, words, colour in (("work", "work of the tool", INK), ("stored", "stored", ALONG), ("contact", "in contact", "#8795a1"),
                                  ("dissipated_by_flow", "by yielding walls", "#3f8f7f"),
                                  ("dissipated_by_failure", "by failing cells", FAILED), ("released", "dropped on failing", ACCENT)):
        values = energies[f"{column} [J/m]"]
        if column == "dissipated_by_failure":  # what breaks and what leaks after it
            values = values + energies["dissipated_by_torn_cells [J/m]"]
        if np.abs(values).max() > 0:
            axis.plot(travel, values, color=colour, linewidth=1.5, label=words)
    axis.set_xlabel("travel of the tool [mm]", color=INK, fontsize=9)
    axis.set_ylabel("energy per depth [J/m]", color=INK, fontsize=9)
    style(axis)
    axis.legend(frameon=False, fontsize=9)


def draw_tissue(axis, frame, setup, travel):
    where = frame.points[:, 1::-1] * 1e3
    cells = frame.cells.reshape(-1, 4)
    names = [name.split(" [")[0] for name in frame.names]
    failed = frame.field("failed").ravel() if "failed" in names else np.zeros(len(cells))
    stretch = frame.field("permanent stretch").ravel() if "permanent stretch" in names else np.zeros(len(cells))
    norm = Normalize(0, max(1e-3, stretch.max()))
    colours = LEAF(norm(stretch))
    colours[failed > 0] = BRUISE(failed[failed > 0])
    axis.add_collection(plt.matplotlib.collections.PolyCollection(where[cells], facecolors=colours, edgecolors="#9aa7a0", linewidths=0.4))
    rest = (frame.points - frame.field("displacement").reshape(len(frame.points), 3))[:, 1::-1] * 1e3
    low, high = rest.min(axis=0), rest.max(axis=0)
    axis.plot([low[0], high[0], high[0], low[0], low[0]], [low[1], low[1], high[1], high[1], low[1]], color="#8795a1", linewidth=1.0,
              linestyle=(0, (4, 3)))
    face, middle = high[1] - travel * 1e3, 0.5 * (low[0] + high[0])
    left, right = min(low[0], where[:, 0].min()), max(high[0], where[:, 0].max())
    thick = 0.05 * (high[1] - low[1])
    if setup.get(("Test", "Tool"), "plate") == "plate":
        axis.fill_between([left, right], face, face + thick, color="#56636e", linewidth=0, zorder=5)
    else:
        radius = float(setup.get(("Test", "Radius"), 3e-3)) * 1e3
        reach = min(radius, 0.62 * (high[0] - low[0]))
        angle = np.linspace(-np.arcsin(reach / radius), np.arcsin(reach / radius), 100)
        x, y = middle + radius * np.sin(angle), face + radius * (1 - np.cos(angle))
        axis.fill_between(x, y, np.maximum(y, face + 4 * thick), color="#56636e", linewidth=0, zorder=5)
    axis.plot([left, right], [low[1], low[1]], color=INK, linewidth=2.4, zorder=5)
    axis.add_collection(LineCollection([[(x, low[1]), (x - thick, low[1] - thick)] for x in np.linspace(left + thick, right, 40)], colors=INK,
                                       linewidths=0.8))
    scale_bar(axis, left, low[1] - 2.2 * thick, high[0] - low[0])
    axis.set_aspect("equal")
    axis.axis("off")
    axis.autoscale_view()
    return norm


def picture(directory):
    steps = read_table(os.path.join(directory, "steps.csv"))
    energies = read_table(os.path.join(directory, "energies.csv"))
    setup = input_entries(directory)
    results = {}
    summary = os.path.join(directory, "summary.json")
    if os.path.exists(summary):
        with open(summary, encoding="utf-8") as file:
            for name, entry in json.load(file).get("results", {}).items():
                results[name] = entry["value"] if isinstance(entry, dict) else entry
    frame = frames(directory, "tissue")[-1]
    figure = plt.figure(figsize=(12.5, 8.2), facecolor="white")
    travel = np.interp(frame.time, steps["time [s]"], steps["travel [m]"])
    norm = draw_tissue(figure.add_axes([0.04, 0.47, 0.92, 0.45]), frame, setup, travel)
    colour_bar(figure, [0.20, 0.455, 0.26, 0.014], norm, LEAF, "permanent stretch of the walls of whole cells")
    colour_bar(figure, [0.54, 0.455, 0.26, 0.014], Normalize(0, 1), BRUISE, "share of failed cells")
    draw_curve(figure.add_axes([0.065, 0.075, 0.40, 0.29]), steps, results)
    draw_energies(figure.add_axes([0.58, 0.075, 0.38, 0.29]), steps, energies)
    speed = float(setup.get(("Test", "Speed"), 1e-3)) * 1e3
    failed = 100 * np.interp(frame.time, steps["time [s]"], steps["failed_share [1]"])
    figure.suptitle(f"Plant tissue pressed at {speed:g} mm/s, {travel * 1e3:.2f} mm deep (true scale): {failed:.0f} % of its cells have failed",
                    color=INK, fontsize=13, y=0.975)
    path = os.path.join(directory, "texture_test.png")
    figure.savefig(path, dpi=150)
    plt.close(figure)
    return path


def main(directory):
    """Paths of the pictures made."""
    needed = ["steps.csv", "energies.csv", "tissue.xdmf"]
    if not all(os.path.exists(os.path.join(directory, name)) for name in needed):
        return []
    if len(read_table(os.path.join(directory, "steps.csv"))["time [s]"]) < 2:
        return []
    return [picture(directory)]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
