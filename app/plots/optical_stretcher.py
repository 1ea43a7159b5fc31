"""The picture of an optical_stretcher run: the cell at rest and stretched, coloured by in-plane stress, and both axes over time for each power and kind of edges."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cell_surface import COLOURS, draw_surface, stress_scale  # noqa: E402
from drawing import ACCENT, ALONG, INK, colour_bar, input_entries, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from own_data import draw_data  # noqa: E402

KINDS = ("Kelvin-Voigt edges", "modified Maxwell edges")


def draw_cells(figure, directory, on, runs):
    """The cell at rest, and of the last run of each kind of edges when the light goes off and at the end."""
    shapes = frames(directory, "surface")
    shown = [(shapes[0], "at rest, no light")]
    for kind in (0, 1):
        of_kind = [k for k, run in enumerate(runs) if run["kind"] == kind]
        if of_kind and len(shapes) >= 2 * of_kind[-1] + 3:
            last = of_kind[-1]
            shown += [(shapes[2 * last + 1], f"{KINDS[kind]},\n{runs[last]['power'] * 1e3:.0f} mW, after {on:g} s of light"),
                      (shapes[2 * last + 2], f"{KINDS[kind]},\n{runs[last]['end'] - on:g} s after it")]
    norm = stress_scale([frame for frame, _ in shown])
    axis = figure.add_axes([0.0, 0.165, 1.0, 0.215])
    size = 2e6 * max(np.abs(frame.points - frame.points.mean(axis=0)).max() for frame, _ in shown)
    for k, (frame, text) in enumerate(shown):
        draw_surface(axis, frame, norm, (0, 0, 1), (0, 1, 0), (1.9 * size * k, 0.0))
        axis.text(1.9 * size * k, -0.62 * size, text, color=INK, fontsize=8, ha="center", va="top")
    axis.annotate("", (-0.55 * size, 0), (-0.85 * size, 0), arrowprops={"arrowstyle": "->", "color": ACCENT, "linewidth": 1.5})
    axis.annotate("", (0.55 * size, 0), (0.85 * size, 0), arrowprops={"arrowstyle": "->", "color": ACCENT, "linewidth": 1.5})
    axis.text(-0.9 * size, 0.1 * size, "light", color=ACCENT, fontsize=8, ha="center", va="bottom")
    axis.set_xlim(-1.2 * size, 1.9 * size * (len(shown) - 1) + 1.2 * size)
    axis.set_ylim(-0.62 * size, 0.62 * size)
    axis.axis("off")
    scale_bar(axis, -1.15 * size, -0.55 * size, 15, "µm", gap=0.06)
    values = np.concatenate([frame.field("in_plane_stress").ravel() * 1e6 for frame, _ in shown])
    colour_bar(figure, [0.33, 0.077, 0.34, 0.018], norm, COLOURS, "in-plane stress of the net [µN/m]: blue compressed, red stretched", values)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "axes.csv")
    if not os.path.exists(path):
        return []
    table = read_table(path)
    runs = []
    for number in np.unique(table["run"]):
        rows = table["run"] == number
        runs.append({"rows": rows, "power": table["power [W]"][rows][0], "kind": int(table["modified_maxwell"][rows][0]), "end": table["time [s]"][rows][-1]})
    on = runs[0]["end"] / 2
    on = float(input_entries(directory).get(("", "Time on"), on))
    kinds = sorted({run["kind"] for run in runs})
    figure = plt.figure(figsize=(11, 6.6), facecolor="white")
    largest = 100 * max(np.abs(table["long_axis [1]"]).max(), 1e-6)
    for k, kind in enumerate(kinds):
        axis = figure.add_axes([0.07 + 0.49 * k, 0.47, 0.42, 0.48])
        axis.axvspan(0, on, color="#fbe9d0", linewidth=0)
        axis.text(0.5 * on, 1.17 * largest, "light on", color=INK, fontsize=8.5, ha="center", va="top")
        axis.axhline(0, color="#c8d0d6", linewidth=0.8)
        of_kind = [run for run in runs if run["kind"] == kind]
        for run, dash in zip(of_kind, ("-", "--", ":", "-.") * 5):
            t = table["time [s]"][run["rows"]]
            for column, colour, name in (("long_axis [1]", ACCENT, "long axis, along the light"), ("short_axis [1]", ALONG, "short axis, across it")):
                axis.plot(t, 100 * table[column][run["rows"]], color=colour, linestyle=dash, linewidth=1.8, label=f"{name}, {run['power'] * 1e3:.0f} mW")
        for column in ("long_axis [1]", "short_axis [1]"):
            draw_data(axis, "time [s]", column, 1.0, 100.0)
        axis.set_ylim(-1.35 * largest, 1.2 * largest)
        axis.set_xlim(0, max(run["end"] for run in of_kind))
        axis.set_title(KINDS[kind], color=INK, fontsize=10)
        axis.set_xlabel("time [s]", color=INK, fontsize=9)
        axis.set_ylabel("change of the axis over its length at rest [%]", color=INK, fontsize=9)
        axis.legend(frameon=False, fontsize=8, loc="lower right")
        style(axis)
    if os.path.exists(os.path.join(directory, "surface.xdmf")):
        draw_cells(figure, directory, on, runs)
    path = os.path.join(directory, "optical_stretcher.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
