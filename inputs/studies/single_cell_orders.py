"""The picture and the orders of convergence of the single-cell tables in doc/results/single_cell (made by single_cell.py).

  python3 inputs/studies/single_cell_orders.py      -> doc/results/single_cell/convergence.png, orders.csv

Orders are least-squares slopes of log |deviation| against log of the spacing over the radius, (volume of the unit ball/N)^(1/dim).
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

FOLDER = os.path.join(ROOT, "doc", "results", "single_cell")


def rows(name):
    path = os.path.join(FOLDER, name + ".csv")
    return list(csv.DictReader(open(path, encoding="utf-8"))) if os.path.exists(path) else []


def spacing(particles, dim):
    return (math.pi / particles) ** 0.5 if dim == 2 else (4 / 3 * math.pi / particles) ** (1 / 3)


def series():
    """(title of the panel, label, spacings, deviations in per cent)"""
    laplace = [row for row in rows("laplace_convergence") if row.get("deviation_cut_virial [%]")]
    for dim in (2, 3):
        for column, label in (("deviation_cut_eos [%]", "mean EOS pressure"), ("deviation_cut_virial [%]", "fluid's virial")):
            points = [(spacing(float(r["fluid_particles"]), dim), float(r[column])) for r in laplace
                      if r["run"].startswith(f"{dim}D") and r.get(column)]
            if len(points) > 1:
                yield "Laplace's law", f"{dim}D, {label}", points
    shells = rows("shell_modes")
    for c in (50, 250):
        for mode in (1, 2):
            column = f"mode_{mode}_deviation [%]"
            points = [(spacing(float(r["run"].split("_")[1]), 3), float(r[column])) for r in shells
                      if r["run"].startswith(f"c{c}_") and r.get(column)]
            if len(points) > 1:
                yield "filled shell", f"c = {c} m/s, mode {mode}", points


def main():
    figure, axes = plt.subplots(1, 2, figsize=(11.0, 4.8), facecolor="white")
    panels = {"Laplace's law": axes[0], "filled shell": axes[1]}
    colours = {"Laplace's law": [ALONG, ALONG, ACCENT, ACCENT], "filled shell": [ALONG, ALONG, ACCENT, ACCENT]}
    drawn = {title: 0 for title in panels}
    table = []
    for title, label, points in series():
        h, d = np.array(sorted(points)).T
        order, offset = np.polyfit(np.log(h), np.log(np.abs(d)), 1)
        table.append([title, label, len(h), f"{order:.2f}", f"{d[0]:.3f}"])
        k = drawn[title]
        drawn[title] += 1
        axis = panels[title]
        axis.loglog(h, np.abs(d), "os"[k % 2], color=colours[title][k], markersize=5, label=f"{label}: order {order:.1f}")
        axis.loglog(h, np.exp(offset) * h**order, color=colours[title][k], linewidth=1.0, linestyle=("-", "--")[k % 2])
    for title, axis in panels.items():
        axis.set_title(title, color=INK, fontsize=10)
        axis.set_xlabel("particle spacing over radius", color=INK, fontsize=9)
        axis.set_ylabel("deviation from the closed form [%]", color=INK, fontsize=9)
        axis.axhline(1 if title == "Laplace's law" else 3, color="#c8d0d6", linewidth=1.2, label="target")
        axis.legend(frameon=False, fontsize=8, loc="upper left")
        style(axis)
    figure.tight_layout()
    figure.savefig(os.path.join(FOLDER, "convergence.png"), dpi=110)
    with open(os.path.join(FOLDER, "orders.csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["what", "quantity", "resolutions", "order", "deviation at the finest [%]"])
        writer.writerows(table)


if __name__ == "__main__":
    main()
