"""Orders and picture of the studies error_vs_time/laplace, single_cell/laplace_support, shell_modes and shell_support.

  python3 inputs/studies/single_cell_orders.py      -> doc/results/single_cell/convergence.png, orders.csv

Order: least-squares slope of log |deviation| against log of the particle spacing over the radius, (pi/N)^(1/2) or
(4 pi/3/N)^(1/3), and against log of the support over the spacing. Shell against resolution: mean over the seeds, bars their standard error.
"""
import csv
import math
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from drawing import ACCENT, ALONG, INK, style  # noqa: E402
from runs import no_choice  # noqa: E402

FOLDER = os.path.join(ROOT, "doc", "results", "single_cell")
PRESSURES = (("deviation_cut_eos [%]", "mean EOS pressure"), ("deviation_cut_virial [%]", "fluid's virial"))


def rows(name, column):
    """Of the study's own results or, where it was not run here, of the committed table."""
    path = os.path.join(FOLDER, name, "results.csv")
    if not os.path.exists(path):
        path = os.path.join(FOLDER, name + ".csv")
    if not os.path.exists(path):
        sys.exit(f"There is no {path}: run the study first (./turgor study, see doc/results/single_cell/README.md).")
    with open(path, encoding="utf-8") as file:
        found = [row for row in csv.DictReader(file) if row.get(column)]
    if not found or "method" not in found[0]:
        sys.exit(f"{path} has no column 'method', so it is no table of a study: run the study anew.")
    return found


def spacing(particles, dim):
    return (math.pi / particles) ** 0.5 if dim == 2 else (4 / 3 * math.pi / particles) ** (1 / 3)


def curves():
    """(panel, label, {x: [deviations in per cent]}, colour, dash)"""
    for dim, colour in ((2, ALONG), (3, ACCENT)):
        for (column, label), dash in zip(PRESSURES, ("-", "--")):
            points = {spacing(float(row["fluid_particles"]), dim): [float(row[column])]
                      for row in rows("laplace_convergence", column) if row["method"] == f"{dim}D"}
            yield 0, f"{dim}D, {label}", points, colour, dash
    for (column, label), dash in zip(PRESSURES, ("-", "--")):
        yield 1, f"2D, {label}", {float(row["Cell/Support ratio"]): [float(row[column])]
                                  for row in rows("laplace_support", column) if row["method"] == "support"}, ALONG, dash
    for c, colour in ((50, ALONG), (250, ACCENT)):
        for mode, dash in ((1, "-"), (2, "--")):
            column, points = f"mode_{mode}_deviation [%]", {}
            for row in rows("shell_modes", column):
                if row["method"] == "filled" and row["Sound speed [m/s]"] == str(c):
                    points.setdefault(spacing(float(row["Cell/Fluid particles"]), 3), []).append(float(row[column]))
            yield 2, f"c = {c} m/s, mode {mode}", points, colour, dash
    for kernel, label, colour in (("Wendland", "Wendland", ALONG), ("fourth order", "fourth order", ACCENT)):
        for mode, dash in ((1, "-"), (2, "--")):
            column = f"mode_{mode}_deviation [%]"
            yield 3, f"{label}, mode {mode}", {float(row["Cell/Support ratio"]): [float(row[column])]
                                               for row in rows("shell_support", column) if row["method"] == kernel}, colour, dash


PANELS = (("Laplace's law", "particle spacing over radius", 1), ("Laplace's law, 484 particles", "support (2 h) over particle spacing", 1),
          ("filled shell", "particle spacing over radius", 3), ("filled shell, c = 50 m/s, 930 particles", "support (2 h) over particle spacing", 3))


def main():
    figure, axes = plt.subplots(2, 2, figsize=(11.0, 9.0), facecolor="white")
    axes = axes.ravel()
    table = [["what", "against", "quantity", "points", "order", "deviation of the last [%]", "standard error [%]"]]
    for panel, label, points, colour, dash in curves():
        if len(points) < 2:
            continue
        against = "spacing" if panel % 2 == 0 else "support"
        x = np.array(sorted(points, reverse=against == "spacing"))
        mean = np.array([np.mean(points[k]) for k in x])
        error = np.array([np.std(points[k], ddof=1) / len(points[k]) ** 0.5 if len(points[k]) > 1 else 0.0 for k in x])
        order, offset = np.polyfit(np.log(x), np.log(np.abs(mean)), 1)
        axis = axes[panel]
        one_sign = bool(np.all(mean > 0) or np.all(mean < 0))
        clear = bool(np.all(np.abs(mean) > 2 * error)) and len(x) > 2
        told = "sign changes" if not one_sign else f"order {order:.1f}" if clear else "within the scatter" if len(x) > 2 else "two points"
        axis.errorbar(x, np.abs(mean), yerr=error if error.any() else None, fmt="o" if dash == "-" else "s", color=colour, markersize=5,
                      capsize=3, linewidth=1.0, label=f"{label}: {told}")
        if one_sign and clear:
            axis.plot(x, np.exp(offset) * x**order, color=colour, linewidth=1.0, linestyle=dash)
        table.append([PANELS[panel][0], against, label, len(x), f"{order:.2f}" if one_sign and clear else told, f"{mean[-1]:.3f}", f"{error[-1]:.3f}" if error[-1] else ""])
    for axis, (title, name, target) in zip(axes, PANELS):
        axis.set_visible(bool(axis.lines))  # a table that was not made
        axis.set_xscale("log")
        axis.set_yscale("log")
        if name.startswith("support"):
            axis.set_xticks([2, 2.4, 2.8, 3.2], ["2.0", "2.4", "2.8", "3.2"])
        else:
            axis.set_xticks([0.05, 0.1, 0.2], ["0.05", "0.1", "0.2"])
        axis.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        axis.axhline(target, color="#c8d0d6", linewidth=1.2, label="target")
        axis.set_title(title, color=INK, fontsize=10)
        axis.set_xlabel(name, color=INK, fontsize=9)
        axis.set_ylabel("deviation from the closed form [%]", color=INK, fontsize=9)
        axis.legend(frameon=False, fontsize=8, loc="best")
        style(axis)
    figure.tight_layout()
    figure.savefig(os.path.join(FOLDER, "convergence.png"), dpi=100)
    plt.close(figure)
    with open(os.path.join(FOLDER, "orders.csv"), "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(table)


if __name__ == "__main__":
    no_choice(__doc__)
    main()
