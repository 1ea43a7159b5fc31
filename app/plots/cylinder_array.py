"""The picture of a cylinder_array run: drag over time beside the exact one, the particles of a period with their speed."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bulk_particles import draw_coloured  # noqa: E402
from drawing import ACCENT, ALONG, INK, POINT, in_prefix, plt, read_table, style  # noqa: E402
from fields import frames  # noqa: E402


def draw_drag(axis, drag):
    of_time, clock = in_prefix("s", [drag["time [s]"]])
    exact = drag["drag [1]"][-1] / (1 + drag["drag_error [1]"][-1])
    axis.axhline(exact, color=ALONG, linewidth=1.6, label="exact")
    axis.plot(drag["time [s]"] * of_time, drag["drag [1]"], "o-", color=ACCENT, markersize=POINT, linewidth=1, label="particles")
    axis.set_xlabel(f"time [{clock}]", color=INK, fontsize=9)
    axis.set_ylabel("drag / (viscosity × superficial speed)", color=INK, fontsize=9)
    axis.set_ylim(0, 1.1 * exact)
    axis.set_title(f"drag of a cylinder; error at the end {100 * drag['drag_error [1]'][-1]:.2g} %", color=INK, fontsize=10)
    axis.legend(frameon=False, fontsize=8)
    style(axis)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "drag.csv")
    if not os.path.exists(path) or len(read_table(path)["time [s]"]) < 2:
        return []
    figure = plt.figure(figsize=(10, 4.8), facecolor="white")
    draw_drag(figure.add_axes([0.08, 0.12, 0.38, 0.78]), read_table(path))
    if os.path.exists(os.path.join(directory, "fluid.xdmf")):
        frame = frames(directory, "fluid")[-1]
        speed = np.linalg.norm(np.asarray(frame.field("velocity")), axis=1)
        axis = figure.add_axes([0.55, 0.27, 0.42, 0.63])
        draw_coloured(figure, axis, [0.63, 0.11, 0.26, 0.03], frame, speed, "m/s", "speed")
        axis.set_title("particles of one period at the end; flow to the right", color=INK, fontsize=10)
    path = os.path.join(directory, "cylinder_array.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
