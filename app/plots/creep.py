"""The picture of a creep run: displacement of the slab's top over time, profiles over the closed form, the particles at the end."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bulk_particles import draw_coloured, draw_layers  # noqa: E402
from drawing import ACCENT, ALONG, INK, POINT, in_prefix, plt, read_table, style  # noqa: E402
from fields import frames  # noqa: E402


def draw_top(axis, creep):
    """The top's way over time, and the error of all particles."""
    of_time, clock = in_prefix("s", [creep["time [s]"]])
    of_way, way = in_prefix("m", [creep["exact_top [m]"]])
    t = creep["time [s]"] * of_time
    axis.plot(t, creep["exact_top [m]"] * of_way, color=ALONG, linewidth=1.6, label="closed form")
    axis.plot(t, creep["top [m]"] * of_way, "o", color=ACCENT, markersize=POINT, label="particles")
    axis.set_xlabel(f"time [{clock}]", color=INK, fontsize=9)
    axis.set_ylabel(f"displacement of the top [{way}]", color=INK, fontsize=9)
    axis.set_title(f"creep; error of all displacements at most {100 * creep['profile_error [1]'].max():.2g} %", color=INK, fontsize=10)
    axis.set_ylim(bottom=0)
    axis.legend(frameon=False, fontsize=8, loc="lower right")
    style(axis)


def draw_profiles(axis, profile):
    """Layers of particles of each frame as points, the closed form as lines."""
    times = np.unique(profile["time [s]"])
    way = draw_layers(axis, profile, "displacement", "m", "closed form", times)
    of_time, clock = in_prefix("s", [times])
    axis.set_xlabel(f"displacement along the load [{way}]", color=INK, fontsize=9)
    axis.set_title("t = " + ", ".join(f"{t * of_time:.3g}" for t in times[:6]) + f" {clock}", color=INK, fontsize=10)
    axis.legend(frameon=False, fontsize=8, loc="upper left")
    style(axis)


def draw_particles(figure, axis, place, frame):
    """Each particle coloured by its von Mises stress."""
    draw_coloured(figure, axis, place, frame, np.asarray(frame.field("von_mises_stress")), "Pa", "von Mises stress")
    axis.axhline(0, color=INK, linewidth=2)
    axis.set_title("particles of one period at the end", color=INK, fontsize=10)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "creep.csv")
    if not os.path.exists(path) or len(read_table(path)["time [s]"]) < 2:
        return []
    figure = plt.figure(figsize=(13, 4.6), facecolor="white")
    draw_top(figure.add_axes([0.06, 0.13, 0.26, 0.76]), read_table(path))
    profile = os.path.join(directory, "profile.csv")
    if os.path.exists(profile) and len(read_table(profile)["time [s]"]) > 0:
        draw_profiles(figure.add_axes([0.39, 0.13, 0.26, 0.76]), read_table(profile))
    if os.path.exists(os.path.join(directory, "solid.xdmf")):
        draw_particles(figure, figure.add_axes([0.72, 0.28, 0.25, 0.61]), [0.75, 0.12, 0.19, 0.03], frames(directory, "solid")[-1])
    path = os.path.join(directory, "creep.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
