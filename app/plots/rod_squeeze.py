"""The picture of a rod_squeeze run: the cell at three times, and the plates' force and the cell's length over their distance beside the balance in closed form and its limits."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, input_entries, plt, read_table, scale_bar, style  # noqa: E402
from own_data import draw_data  # noqa: E402
from rod_outline import draw_rod  # noqa: E402


def draw_cells(axis, table, nucleus):
    """At the start, half way and at the end, from above one another."""
    distance = table["distance [m]"] * 1e6
    chosen = sorted({0, int(np.argmin(np.abs(distance - 0.5 * (distance[0] + distance[-1])))), len(distance) - 1})
    width = 1.15 * max(table["length [m]"] + 2 * table["radius [m]"]) * 1e6
    foot = 0.0
    for k in chosen:
        D, L, R, tilt = (table[name][k] for name in ("distance [m]", "length [m]", "radius [m]", "tilt [degrees]"))
        D, L, R, tilt = D * 1e6, L * 1e6, R * 1e6, np.radians(tilt)
        foot -= D + 4
        for height in (foot, foot + D):
            axis.plot([-0.6 * width, 0.6 * width], [height, height], color=INK, linewidth=1.6)
        half = 0.5 * L * np.array([np.cos(tilt), np.sin(tilt)])
        middle = np.array([0.0, foot + 0.5 * D])
        draw_rod(axis, middle - half, middle + half, R, nucleus, inside=(foot, foot + D))
        axis.text(-0.6 * width, foot + D + 0.5, f"{table['time [s]'][k]:.0f} s, gap {D:.1f} µm", color=INK, fontsize=9)
    axis.set_aspect("equal")
    scale_bar(axis, -0.6 * width, foot - 3, 0.6 * width, "µm")
    axis.text(0.6 * width, foot - 3, "dark: nucleus; flat: pressed in", color=INK, fontsize=8, ha="right", va="bottom")
    axis.axis("off")


def draw_force(axis, table):
    distance = table["distance [m]"] * 1e6
    for name, label, colour, dashes in (("force_of_volume [N]", "volume alone", ALONG, (0, (1, 2))), ("force_of_rigid_shape [N]", "Hertz alone, shape kept", ALONG, (0, (4, 3))), ("force_at_rest [N]", "balance at rest, closed form", INK, (0, (4, 3)))):
        axis.plot(distance, table[name] * 1e9, color=colour, linewidth=1.3, linestyle=dashes, label=label)
    axis.plot(distance, table["force [N]"] * 1e9, color=ACCENT, linewidth=1.8, label="force on a plate")
    draw_data(axis, "distance [m]", "force [N]", 1e6, 1e9)
    top = 1.3 * max(table["force [N]"].max(), table["force_of_rigid_shape [N]"].max()) * 1e9
    axis.set_ylim(0, top)
    axis.set_ylabel("force [nN]", color=INK, fontsize=9)


def draw_length(axis, table):
    distance = table["distance [m]"] * 1e6
    axis.plot(distance, table["length_at_rest [m]"] * 1e6, color=INK, linewidth=1.3, linestyle=(0, (4, 3)), label="length at rest, closed form")
    axis.plot(distance, table["length [m]"] * 1e6, color=ACCENT, linewidth=1.8, label="length of the rod")
    axis.plot(distance, table["radius [m]"] * 1e6, color=ALONG, linewidth=1.4, label="its radius")
    axis.set_ylabel("length, radius [µm]", color=INK, fontsize=9)
    axis.set_ylim(0, None)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "history.csv")
    if not os.path.exists(path):
        return []
    table = read_table(path)
    nucleus = float(input_entries(directory).get(("Cell", "Nucleus radius"), 3e-6)) * 1e6
    figure = plt.figure(figsize=(11.5, 6), facecolor="white")
    draw_cells(figure.add_axes([0.01, 0.03, 0.46, 0.94]), table, nucleus)
    for place, draw in (([0.55, 0.57, 0.43, 0.4], draw_force), ([0.55, 0.09, 0.43, 0.4], draw_length)):
        axis = figure.add_axes(place)
        draw(axis, table)
        axis.set_xlabel("distance of the plates [µm]", color=INK, fontsize=9)
        axis.invert_xaxis()
        axis.legend(frameon=False, fontsize=8.5, loc="upper left" if draw is draw_length else "upper center")
        style(axis)
    path = os.path.join(directory, "rod_squeeze.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
