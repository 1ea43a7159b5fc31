"""The picture of a spheroid_relaxation run: the radius of gyration after the spheroid is let go, and its relaxation time."""
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import cells_cut  # noqa: E402
from drawing import ACCENT, INK, plt, read_table, style  # noqa: E402
from own_data import draw_data  # noqa: E402


def main(directory):
    table = read_table(os.path.join(directory, "growth.csv"))
    t, radius = table["time [s]"] / 3600, table["gyration_radius [m]"] * 1e6
    figure, axis = plt.subplots(figsize=(7, 4.4), layout="constrained")
    axis.plot(t, radius, color=ACCENT, linewidth=2, label="the run")
    draw_data(axis, "time [s]", "gyration_radius [m]", 1 / 3600, 1e6)
    if len(axis.lines) > 1:
        axis.legend(frameon=False, fontsize=8)
    late = ""
    try:
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            found = json.load(file)["results"]["relaxation_time"]["value"] / 3600
        axis.axvline(found, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
        axis.annotate(f"1/e after {found:.2f} h", (found, radius.min()), xytext=(6, 4), textcoords="offset points", color=INK, fontsize=9)
        if 0 < found < 0.02 * t[-1]:  # else the curve is an edge at the left
            axis.set_xlim(-0.2 * found, 12 * found)
            late = f", shown up to {12 * found:.3g} h of {t[-1]:.3g} h"
    except (OSError, KeyError):
        pass
    axis.set_title(f"A spheroid that was pressed, let go{late}", fontsize=11, color=INK)
    axis.set_xlabel("time since it was let go [h]", color=INK)
    axis.set_ylabel("radius of gyration [µm]", color=INK)
    style(axis)
    path = os.path.join(directory, "spheroid_relaxation.png")
    figure.savefig(path, dpi=110)
    plt.close(figure)
    cut = cells_cut.draw_cut(directory)
    return [path] + ([cut] if cut else [])


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
