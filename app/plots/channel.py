"""The picture of a poiseuille or couette run: profiles of the velocity over the exact ones, their error over time, the particles at the end."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bulk_particles import draw_coloured, draw_layers  # noqa: E402
from drawing import ACCENT, ALONG, INK, in_prefix, plt, read_table, style  # noqa: E402
from fields import frames  # noqa: E402


def draw_profiles(axis, profile):
    """Layers of particles of each frame as points, exact profiles as lines; of a steady flow the last."""
    times = np.unique(profile["time [s]"])
    exact = profile["exact_speed [m/s]"]
    steady = np.allclose([exact[profile["time [s]"] == time].mean() for time in times], exact[profile["time [s]"] == times[-1]].mean(), rtol=1e-2)
    shown = times[-1:] if steady else times[:: max(1, len(times) // 4)]
    speed = draw_layers(axis, profile, "speed", "m/s", "exact", shown)
    of_time, clock = in_prefix("s", [times])
    axis.set_xlabel(f"velocity along the plates [{speed}]", color=INK, fontsize=9)
    axis.set_title(("steady flow, t = " if steady else "from the start, t = ") + ", ".join(f"{t * of_time:.3g}" for t in shown) + f" {clock}", color=INK, fontsize=10)
    axis.legend(frameon=False, fontsize=8)
    style(axis)


def draw_errors(axis, flow):
    """Errors of profile and drag over time."""
    of_time, clock = in_prefix("s", [flow["time [s]"]])
    t = flow["time [s]"] * of_time
    largest = np.abs(flow["exact_lower_stress [Pa]"]).max()
    axis.plot(t, 100 * flow["profile_error [1]"], color=ACCENT, linewidth=1.6, label="profile, root mean square")
    axis.plot(t, 100 * np.abs(flow["lower_stress [Pa]"] - flow["exact_lower_stress [Pa]"]) / largest, color=ALONG, linewidth=1.6, label="drag on the lower plate")
    axis.set_xlabel(f"time [{clock}]", color=INK, fontsize=9)
    axis.set_ylabel("error [%]", color=INK, fontsize=9)
    axis.set_ylim(bottom=0)
    axis.set_title("difference from the exact solution", color=INK, fontsize=10)
    axis.legend(frameon=False, fontsize=8)
    style(axis)


def draw_particles(figure, axis, place, frame):
    """Each particle coloured by its velocity along the plates."""
    draw_coloured(figure, axis, place, frame, np.asarray(frame.field("velocity"))[:, 0], "m/s", "velocity along the plates")
    axis.set_title("particles of one period at the end", color=INK, fontsize=10)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "flow.csv")
    if not os.path.exists(path) or len(read_table(path)["time [s]"]) < 2:
        return []
    figure = plt.figure(figsize=(13, 4.6), facecolor="white")
    profile = os.path.join(directory, "profile.csv")
    if os.path.exists(profile) and len(read_table(profile)["time [s]"]) > 0:
        draw_profiles(figure.add_axes([0.05, 0.13, 0.26, 0.76]), read_table(profile))
    draw_errors(figure.add_axes([0.38, 0.13, 0.26, 0.76]), read_table(path))
    if os.path.exists(os.path.join(directory, "fluid.xdmf")):
        draw_particles(figure, figure.add_axes([0.70, 0.28, 0.27, 0.61]), [0.74, 0.12, 0.19, 0.03], frames(directory, "fluid")[-1])
    path = os.path.join(directory, "channel.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
