"""Orders and picture of the tables laplace_convergence and laplace_support (made by single_cell.py).

  python3 inputs/studies/laplace_orders.py      -> doc/results/single_cell/laplace_convergence.png, laplace_orders.csv

Order: least-squares slope of log |deviation| against log of the particle spacing over the radius, (pi/N)^(1/2) or
(4 pi/3/N)^(1/3), and against log of the support over the spacing.
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
PRESSURES = (("deviation_cut_eos [%]", "mean EOS pressure"), ("deviation_cut_virial [%]", "fluid's virial"))


def rows(name):
    with open(os.path.join(FOLDER, name + ".csv"), encoding="utf-8") as file:
        return [row for row in csv.DictReader(file) if row.get(PRESSURES[0][0])]


def main():
    figure, axes = plt.subplots(1, 2, figsize=(11.0, 4.6), facecolor="white")
    table = [["against", "quantity", "runs", "order", "deviation of the last [%]"]]

    def draw(axis, against, label, x, y, colour, dash):
        order, offset = np.polyfit(np.log(x), np.log(np.abs(y)), 1)
        axis.loglog(x, np.abs(y), "o" if dash == "-" else "s", color=colour, markersize=5, label=f"{label}: order {order:.1f}")
        axis.loglog(x, np.exp(offset) * np.array(x) ** order, color=colour, linewidth=1.0, linestyle=dash)
        table.append([against, label, len(x), f"{order:.2f}", f"{y[-1]:.3f}"])

    for dim, colour in ((2, ALONG), (3, ACCENT)):
        runs = [row for row in rows("laplace_convergence") if row["run"].startswith(f"{dim}D")]
        ball = math.pi if dim == 2 else 4 / 3 * math.pi
        x = [(ball / float(row["fluid_particles"])) ** (1 / dim) for row in runs]
        for (column, label), dash in zip(PRESSURES, ("-", "--")):
            if len(x) > 1:
                draw(axes[0], "spacing over radius", f"{dim}D, {label}", x, [float(row[column]) for row in runs], colour, dash)
    runs = rows("laplace_support")
    x = [float(row["run"].split("_")[1]) for row in runs]
    for (column, label), dash in zip(PRESSURES, ("-", "--")):
        draw(axes[1], "support over spacing", f"2D, {label}", x, [float(row[column]) for row in runs], ALONG, dash)
    axes[0].set_xlabel("particle spacing over radius", color=INK, fontsize=9)
    axes[1].set_xlabel("support (2 h) over particle spacing, 484 particles", color=INK, fontsize=9)
    axes[1].set_xticks([2, 2.4, 2.8, 3.2], ["2.0", "2.4", "2.8", "3.2"])
    axes[1].xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    for axis in axes:
        axis.axhline(1, color="#c8d0d6", linewidth=1.2, label="target")
        axis.set_ylabel("wall's pull against p R: deviation [%]", color=INK, fontsize=9)
        axis.legend(frameon=False, fontsize=8, loc="best")
        style(axis)
    figure.tight_layout()
    figure.savefig(os.path.join(FOLDER, "laplace_convergence.png"), dpi=110)
    plt.close(figure)
    with open(os.path.join(FOLDER, "laplace_orders.csv"), "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows(table)


if __name__ == "__main__":
    main()
