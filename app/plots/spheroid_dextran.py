"""The picture of a spheroid_dextran run, or of several: radius over time and mean pressure (thesis Fig. 5.1).

main(directory) reads growth.csv and writes spheroid_dextran.png there; with fields also a cut, cells_cut.png.
draw(runs, path): runs are (label, directory); labels of one cell line begin with its name, "CT26 free", "CT26 5 kPa".
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cells_cut import draw_cut  # noqa: E402
from drawing import ACCENT, ALONG, INK, input_entries, input_is, plt, read_table, style  # noqa: E402
from own_data import draw_data  # noqa: E402

DAY = 86400.0


def draw(runs, path, regime_change=9.0):
    """regime_change: d, when the rim of BC52 and FHI changes."""
    lines = list(dict.fromkeys(label.split()[0] for label, _ in runs))
    columns = min(3, len(lines) + 1)
    rows = -(-(len(lines) + 1) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(4.2 * columns, 3.6 * rows), layout="constrained", squeeze=False)
    axes = axes.ravel()
    last = axes[len(lines)]
    for label, directory in runs:
        table = read_table(os.path.join(directory, "growth.csv"))
        t = table["time [s]"] / DAY
        free = "free" in label and "edge" not in label
        colour = ACCENT if free else "#8a6fb0" if "edge" in label else ALONG
        axis = axes[lines.index(label.split()[0])]
        axis.plot(t, table["radius [m]"] * 1e6, color=colour, linewidth=2, linestyle="-" if free or len(runs) == 1 else (0, (5, 2)), label=label)
        draw_data(axis, "time [s]", "radius [m]", 1 / DAY, 1e6)
        last.plot(t, table["pressure [Pa]"] / 1e3, color=colour, linewidth=1)
    published = any(input_is(directory, {("Cell", "Birth radius"): 6e-6, ("Cell", "Modulus"): 450}) for _, directory in runs)
    for line, axis in zip(lines, axes):
        if line == "BC52" and published:  # the one line whose speeds the thesis states
            free = axis.lines[0]
            at = np.interp(regime_change, free.get_xdata(), free.get_ydata())
            before, after = np.array([1.0, regime_change]), np.array([regime_change, max(free.get_xdata()[-1], regime_change + 1e-3)])
            axis.plot(before, at + 0.41 * 24 * (before - regime_change), color=INK, linewidth=1.2, linestyle=(0, (1, 2)),
                      label="experiment, free: 0.41, then 0.29 µm/h")
            axis.plot(after, at + 0.29 * 24 * (after - regime_change), color=INK, linewidth=1.2, linestyle=(0, (1, 2)))
        if line in ("BC52", "FHI"):
            axis.axvline(regime_change, color="#c8d0d6", linewidth=0.8)
        axis.set_ylabel("radius [µm]", color=INK)
        axis.set_ylim(top=axis.get_ylim()[1] + 0.25 * np.ptp(axis.get_ylim()))  # room for the legend
        axis.legend(frameon=False, fontsize=8, loc="upper left")
    last.set_ylabel("mean pressure of living cells [kPa]", color=INK)
    if len(runs) > 1:
        for colour, name in ((ALONG, "under dextran"), (ACCENT, "free"), ("#8a6fb0", "free, rim from the mean edge")):
            if any(line.get_color() == colour for line in last.lines):
                last.plot([], [], color=colour, linewidth=1, label=name)
        last.set_ylim(top=last.get_ylim()[1] + 0.25 * np.ptp(last.get_ylim()))
        last.legend(frameon=False, fontsize=8, loc="upper left")
    for axis in axes[:len(lines) + 1]:
        axis.set_xlabel("time [d]", color=INK)
        style(axis)
    for axis in axes[len(lines) + 1:]:
        axis.set_visible(False)
    figure.suptitle("Growing spheroids under osmotic pressure" if len(runs) > 1 else f"A growing spheroid: {runs[0][0]}", fontsize=11, color=INK)
    figure.savefig(path, dpi=110)
    plt.close(figure)
    return path


def main(directory):
    """Paths of the pictures made."""
    have = input_entries(directory)
    pressure = float(have.get(("Dextran", "Pressure"), "nan"))
    label = f"{have.get(('Dextran', 'Cell line'), 'cells')} {'free' if pressure == 0 else f'under {pressure / 1e3:g} kPa of dextran'}"
    made = [draw([(label, directory)], os.path.join(directory, "spheroid_dextran.png"))]
    cut = draw_cut(directory)
    return made + ([cut] if cut else [])


if __name__ == "__main__":
    if len(sys.argv) > 3:  # PICTURE LABEL=DIR LABEL=DIR ...
        draw([tuple(item.split("=", 1)) for item in sys.argv[2:]], sys.argv[1])
    else:
        main(sys.argv[1] if len(sys.argv) > 1 else ".")
