"""The picture of a rotating_block run: stresses over the angle, what is wrong with them, the block on its way."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bulk_particles import draw_coloured  # noqa: E402
from drawing import ACCENT, ALONG, INK, POINT, in_prefix, plt, read_table, style  # noqa: E402
from fields import frames  # noqa: E402


def draw_stresses(axis, turn):
    degrees = np.degrees(turn["angle [rad]"])
    of_stress, unit = in_prefix("Pa", [turn["exact_stress_xx [Pa]"]])
    few = slice(None, None, max(1, len(degrees) // 24))
    for name, colour in (("xx", ACCENT), ("xy", ALONG)):
        axis.plot(degrees, turn[f"exact_stress_{name} [Pa]"] * of_stress, color=colour, linewidth=1.4, label=f"{name}, exact")
        axis.plot(degrees[few], turn[f"stress_{name} [Pa]"][few] * of_stress, "o", color=colour, markersize=POINT, label=f"{name}, particles")
    axis.set_xlabel("angle of the turn [degrees]", color=INK, fontsize=9)
    axis.set_ylabel(f"deviatoric stress [{unit}]", color=INK, fontsize=9)
    axis.set_title("the stress turns along with the block", color=INK, fontsize=10)
    low, high = axis.get_ylim()
    axis.set_ylim(low, high + 0.3 * (high - low))
    axis.legend(frameon=False, fontsize=8, ncol=2, loc="upper center")
    style(axis)


def draw_errors(axis, turn):
    degrees = np.degrees(turn["angle [rad]"])
    for name, colour, label in (("stress_error [1]", ACCENT, "stress"), ("pressure_error [1]", ALONG, "pressure")):
        axis.semilogy(degrees, np.maximum(turn[name], 1e-17), color=colour, linewidth=1.4, label=label)
    axis.set_xlabel("angle of the turn [degrees]", color=INK, fontsize=9)
    axis.set_ylabel("largest relative error of a particle", color=INK, fontsize=9)
    axis.set_title("what the turn changes", color=INK, fontsize=10)
    axis.legend(frameon=False, fontsize=8)
    style(axis)


def draw_block(figure, axis, place, all_frames):
    """The block as it is laid and, stretched, on its way, coloured by its stress along x."""
    chosen = all_frames[min(2, len(all_frames) - 1)]
    start = np.asarray(all_frames[0].points)
    of_length = draw_coloured(figure, axis, place, chosen, np.asarray(chosen.field("stress_xx")), "Pa", "stress along x", signed=True, s=12, label=f"step {chosen.time:.0f}")
    axis.scatter(start[:, 0] * of_length, start[:, 1] * of_length, s=5, color="#c8c8c8", linewidths=0, label="as laid", zorder=0)
    axis.set_title("particles, stretched and on their way", color=INK, fontsize=10)
    bottom, top = axis.get_ylim()
    axis.set_ylim(bottom, top + 0.12 * (top - bottom))
    axis.legend(frameon=False, fontsize=8, loc="upper center", ncol=2)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "turn.csv")
    if not os.path.exists(path) or len(read_table(path)["angle [rad]"]) < 2:
        return []
    figure = plt.figure(figsize=(13, 4.6), facecolor="white")
    draw_stresses(figure.add_axes([0.05, 0.13, 0.27, 0.76]), read_table(path))
    draw_errors(figure.add_axes([0.39, 0.13, 0.25, 0.76]), read_table(path))
    if os.path.exists(os.path.join(directory, "block.xdmf")):
        draw_block(figure, figure.add_axes([0.70, 0.28, 0.27, 0.61]), [0.74, 0.12, 0.19, 0.03], frames(directory, "block"))
    path = os.path.join(directory, "rotating_block.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
