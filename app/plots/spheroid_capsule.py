"""The picture of a spheroid_capsule run: capsule radius, pressure and density after confluence. The experiment's numbers are drawn where the
input is the experiment's: CT26 cells in a capsule of 100 um inner radius, 8 um (thin) or 30 um (thick) wall.

main(directory) reads growth.csv and summary.json and writes spheroid_capsule.png there; with fields also a cut, cells_cut.png.
draw(runs, path) puts several runs (label, directory) on one picture.
"""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cells_cut import draw_cut  # noqa: E402
from drawing import ACCENT, ALONG, INK, input_is, plt, read_table, style  # noqa: E402

DAY = 86400.0
CT26 = {("Cell", "Birth radius"): 6e-6, ("Cell", "Cycle time"): 61200, ("Cell", "Modulus"): 450, ("Cell", "Bulk modulus"): 5000,
        ("Capsule", "Radius"): 100e-6, ("Capsule", "Modulus"): 68e3}
DOT = "24 h after confluence (capsule_pressure_24h)"
COLOURS = (ACCENT, ALONG, "#6b8e4e", "#8a6fb0", "#c28b2c", "#4d4d4d")


def after_confluence(directory):
    """Times (d), radius (um), pressure (kPa), density (1/100 um^2), rest radius (um), results; None before the wall is reached.

    Confluence as in the scene: the spheroid's edge within 1 % of the wall at rest. Results are empty while the run goes on.
    """
    table = read_table(os.path.join(directory, "growth.csv"))
    radius = table["capsule_radius [m]"] * 1e6
    reached = np.flatnonzero(table["radius [m]"] * 1e6 >= 0.99 * radius[0])
    if not len(reached):
        return None
    t = (table["time [s]"] - table["time [s]"][reached[0]]) / DAY
    try:
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            results = json.load(file).get("results", {})
    except OSError:
        results = {}
    return t, radius, table["capsule_pressure [Pa]"] / 1e3, table["density [1/(100 um^2)]"], radius[0], results


def draw(runs, path):
    figure, axes = plt.subplots(1, 3, figsize=(13, 4.2), layout="constrained")
    last = 0.1
    for k, (label, directory) in enumerate(runs):
        data = after_confluence(directory)
        if data is None:
            continue
        t, radius, pressure, density, rest, results = data
        colour = COLOURS[k % len(COLOURS)]
        shown = t > -1
        # the density as a ratio: ours counts centres, a section shows nuclei (doc/results/spheroid/density.md)
        for axis, values in zip(axes, (radius - rest, pressure, density / np.interp(0, t, density))):
            axis.plot(t[shown], values[shown], color=colour, linewidth=1.8, label=label)
        if "capsule_pressure_24h" in results:
            axes[1].plot(1, results["capsule_pressure_24h"]["value"] / 1e3, "o", color=colour, markersize=6, label=DOT if axes[1].get_label() != DOT else None)
            axes[1].set_label(DOT)  # of all dots one is named
        last = max(last, t[-1])
    # The experiment: what the thesis states (5.2, C.2.2), over its own input only.
    at = np.array([min(2.0, 0.5 * last), last])
    for slope, thickness, name, style_of in ((2.0, 8e-6, "experiment, thin: 2 µm/d (slope only)", (0, (5, 2))),
                                             (0.7, 30e-6, "experiment, thick: 0.7 µm/d (slope only)", (0, (1, 2)))):
        if any(input_is(directory, CT26 | {("Capsule", "Thickness"): thickness}) for _, directory in runs):
            axes[0].plot(at, slope * (at - at[0]) + (8 if slope > 1 else 3), color=INK, linewidth=1.1, linestyle=style_of, label=name)
    if any(input_is(directory, CT26) for _, directory in runs):
        axes[1].axhline(1.5, color=INK, linewidth=1, linestyle=(0, (5, 2)), label="experiment: about 1.5 kPa after a day")
        if last >= 2:
            axes[2].errorbar([2], [2.175], yerr=0.175, fmt="none", ecolor=INK, capsize=5, elinewidth=1.6, label="experiment: 2 to 2.35 after 48 h")
    for axis, text in zip(axes, ("capsule dilated by [µm]", "pressure on the capsule [kPa]", "cells in a section over those at confluence")):
        axis.set_xlabel("time after confluence [d]", color=INK)
        axis.set_ylabel(text, color=INK)
        axis.axvline(0, color="#c8d0d6", linewidth=0.8)
        style(axis)
    curves = {label for label, _ in runs}
    for axis in axes:
        axis.set_ylim(top=(1.5 if axis is axes[0] else 1.12) * axis.get_ylim()[1])  # room for the legend
        named = [(handle, label) for handle, label in zip(*axis.get_legend_handles_labels()) if axis is axes[0] or label not in curves]  # curves are named once
        if named:
            axis.legend(*zip(*named), frameon=False, fontsize=8, loc="upper left")
    figure.suptitle("A spheroid that grows against the wall of its capsule", fontsize=11, color=INK)
    figure.savefig(path, dpi=130)
    plt.close(figure)
    return path


def main(directory):
    """Paths of the pictures made."""
    if after_confluence(directory) is None:
        return []
    made = [draw([("this run", directory)], os.path.join(directory, "spheroid_capsule.png"))]
    table = read_table(os.path.join(directory, "growth.csv"))
    cut = draw_cut(directory, wall=lambda time: np.interp(time, table["time [s]"], table["capsule_radius [m]"] * 1e6))
    if cut:
        made.append(cut)
    return made


if __name__ == "__main__":
    if len(sys.argv) > 3:  # PICTURE LABEL=DIR LABEL=DIR ...
        draw([tuple(item.split("=", 1)) for item in sys.argv[2:]], sys.argv[1])
    else:
        main(sys.argv[1] if len(sys.argv) > 1 else ".")
