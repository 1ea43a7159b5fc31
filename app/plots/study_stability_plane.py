"""Stability planes: results.csv of a study (inputs/studies/stability_plane.prm) drawn as plane.png.

One panel a plane of two entries ("A x B = VALUE" is a row of it): filled, the largest step with an energy error below 1e-3 over the step
that the program chooses by itself (below 1: unsafe, above 2: half of it was possible); lines, the chosen step in ns.
"""
import csv
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy as np  # noqa: E402

from drawing import INK, plt, style  # noqa: E402

UNITS = {"wall stiffness": "wall stiffness G t0 [N/m]", "viscosity": "viscosity [Pa s]", "impact speed": "impact speed [m/s]"}
LEVELS = [0.5, 0.8, 1.0, 1.1, 1.2, 1.3, 1.5, 2.0, 4.0]


def planes(rows):
    """{(A, B): {(a, b): row}} of the rows' methods."""
    found = {}
    for row in rows:
        first, _, rest = row["method"].partition(" x ")
        second, _, value = rest.partition(" = ")
        found.setdefault((first, second), {})[float(row["settings"]), float(value)] = row
    return found


def grid(points, name, a, b):
    return np.array([[float(points[x, y][name]) if points[x, y].get(name) else np.nan for x in a] for y in b])


def main(directory, _=""):
    with open(os.path.join(directory, "results.csv"), newline="", encoding="utf-8") as file:
        all_planes = planes(list(csv.DictReader(file)))
    figure, panels = plt.subplots(1, len(all_planes), figsize=(5.6 * len(all_planes), 4.6), squeeze=False)
    figure.subplots_adjust(left=0.05, right=0.9, bottom=0.13, top=0.79, wspace=0.25)
    filled = None
    for panel, ((first, second), points) in zip(panels[0], all_planes.items()):
        a, b = (sorted({key[k] for key in points}) for k in (0, 1))
        ratio, chosen = grid(points, "stable_over_chosen", a, b), 1e9 * grid(points, "chosen_step", a, b)
        error = grid(points, "energy_error_chosen", a, b)
        panel.set_xscale("log")
        panel.set_yscale("log")
        filled = panel.contourf(a, b, ratio, levels=LEVELS, cmap="RdYlBu", norm=plt.matplotlib.colors.BoundaryNorm(LEVELS, 256), extend="both")
        steps = panel.contour(a, b, np.log10(chosen), levels=8, colors=INK, linewidths=0.6)
        panel.clabel(steps, fmt=lambda value: f"{10 ** value:.2g} ns", fontsize=7)
        for x in a:
            for y in b:
                done = points[x, y]["status"] == "finished"
                panel.plot(x, y, "." if done else "x", color=INK, markersize=3 if done else 6)
                if done:
                    panel.annotate(f"{float(points[x, y]['stable_over_chosen']):.2f}", (x, y), textcoords="offset points", xytext=(2, 3),
                                   fontsize=6.5, color=INK)
        panel.set_title(f"stands {np.nanmin(ratio):.2f} to {np.nanmax(ratio):.2f} x chosen\nenergy error at the chosen step: {np.nanmax(error):.1e} at most",
                        fontsize=9, color=INK, pad=14)
        panel.set_xlabel(UNITS.get(first, first), fontsize=9, color=INK)
        panel.set_ylabel(UNITS.get(second, second), fontsize=9, color=INK)
        style(panel)
    bar = figure.colorbar(filled, cax=figure.add_axes([0.92, 0.13, 0.012, 0.7]), ticks=LEVELS)
    bar.set_label("largest stable step / chosen step", fontsize=9, color=INK)
    figure.suptitle("1 to 2: the chosen step is safe and at least half of what was possible. Lines: the chosen step.", fontsize=10, color=INK)
    figure.savefig(os.path.join(directory, "plane.png"), dpi=110)
    plt.close(figure)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
