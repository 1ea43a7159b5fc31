"""The stability map: what the cell stands and what the program chooses, one panel an axis.

  study_stability.py DIR        reads DIR/results.csv, writes DIR/map.png

Shaded: steps at which the cell is stable (energy error below 1e-3 over the trial). Line: the step the program chooses by
itself. Crosses: runs that ended with a sentence instead.
"""
import csv
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from matplotlib.ticker import LogLocator, NullFormatter  # noqa: E402

from drawing import ACCENT, ALONG, INK, plt, style  # noqa: E402

UNITS = {"wall stiffness": "G t0 [N/m]", "EOS stiffness": "K [Pa]", "viscosity": "viscosity [Pa s]", "lamella": "lamella ratio",
         "impact speed": "impact speed [m/s]", "wall thickness": "wall thickness [m]", "substeps": "substeps of walls"}


def abscissa(value):
    """A number, or of a deformation gradient 'xx, xy; yx, yy' what it does: shear, else the stretch in x."""
    try:
        return float(value)
    except ValueError:
        parts = [float(x) for x in value.replace(";", ",").split(",")]
        return parts[1] if parts[1] or parts[0] == 1 else parts[0]


def number(row, name):
    return float(row[name]) if row.get(name) else float("nan")


def main(directory, _=""):
    with open(os.path.join(directory, "results.csv"), newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    axes = list(dict.fromkeys(row["method"] for row in rows if row["status"] == "finished"))
    columns = 4
    lines = -(-len(axes) // columns)
    figure, panels = plt.subplots(lines, columns, figsize=(4.1 * columns, 3.1 * lines), squeeze=False)
    figure.subplots_adjust(left=0.055, right=0.985, bottom=0.075, top=0.92, hspace=0.55, wspace=0.28)
    for panel in panels.ravel()[len(axes):]:
        panel.axis("off")
    for panel, axis in zip(panels.ravel(), axes):
        here = sorted((row for row in rows if row["method"] == axis), key=lambda row: abscissa(row["settings"]))
        good = [row for row in here if row["status"] == "finished"]
        x = [abscissa(row["settings"]) for row in good]
        largest = [1e9 * number(row, "largest_stable_step") for row in good]
        chosen = [1e9 * number(row, "chosen_step") for row in good]
        positive = [value for value in x if value > 0]
        if positive and max(positive) / min(positive) > 20:
            panel.set_xscale("symlog" if min(x) <= 0 else "log", **({"linthresh": min(positive)} if min(x) <= 0 else {}))
        panel.set_yscale("log")
        panel.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        panel.yaxis.set_major_formatter("{x:g}")
        panel.yaxis.set_minor_formatter(NullFormatter())
        if good:
            bottom = 0.3 * min(chosen + largest)
            panel.fill_between(x, [bottom] * len(x), largest, color=ALONG, alpha=0.18, linewidth=0)
            panel.plot(x, largest, color=ALONG, marker="o", markersize=3.5, linewidth=1.2)
            panel.plot(x, chosen, color=ACCENT, marker="s", markersize=3, linewidth=1.4)
            panel.set_ylim(bottom, 2 * max(largest + chosen))
            ratios = [number(row, "stable_over_chosen") for row in good]
            panel.set_title(f"{axis}: stands {min(ratios):.2f} to {max(ratios):.2f} x chosen", fontsize=9, color=INK)
        for row in here:
            if row["status"] == "failed" and good:
                panel.plot(abscissa(row["settings"]), 1.3 * bottom, "x", color=INK)
        panel.set_xlabel(UNITS.get(axis.split(",")[0], axis), fontsize=8, color=INK)
        panel.set_ylabel("time step [ns]", fontsize=8, color=INK)
        style(panel)
    figure.legend(handles=[plt.Rectangle((0, 0), 1, 1, color=ALONG, alpha=0.3, label="stable: energy error below 1e-3"),
                           plt.Line2D([], [], color=ACCENT, marker="s", markersize=3, label="chosen by the program"),
                           plt.Line2D([], [], color=INK, marker="x", ls="", label="ends with a sentence")],
                  loc="upper center", ncol=3, frameon=False, fontsize=10)
    figure.savefig(os.path.join(directory, "map.png"), dpi=130)
    plt.close(figure)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
