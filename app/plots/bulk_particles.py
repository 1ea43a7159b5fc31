"""What pictures of Stokes particles share: layers of particles beside a closed form, and particles in the colours of a field."""
import os
import sys

import numpy as np
from matplotlib.colors import Normalize

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, POINT, colour_bar, in_prefix, style  # noqa: E402


def draw_layers(axis, profile, name, unit, exact, times):
    """Means of layers (points) beside the closed form (lines) over the height, at the times given: columns `name [unit]` and
    `exact_name [unit]` of the table; `exact` is what the legend calls the closed form. Returns the unit that the axis has."""
    of_length, length = in_prefix("m", [profile["height [m]"]])
    of_value, value = in_prefix(unit, [profile[f"exact_{name} [{unit}]"]])
    for k, time in enumerate(times):
        rows = profile["time [s]"] == time
        order = np.argsort(profile["height [m]"][rows])
        height = profile["height [m]"][rows][order] * of_length
        axis.plot(profile[f"exact_{name} [{unit}]"][rows][order] * of_value, height, color=ALONG, linewidth=1.6, label=exact if k == 0 else None)
        axis.plot(profile[f"{name} [{unit}]"][rows][order] * of_value, height, "o", color=ACCENT, markersize=POINT, label="particles, mean of each layer" if k == 0 else None)
    axis.set_ylabel(f"height over the lower plate [{length}]", color=INK, fontsize=9)
    return value


def draw_coloured(figure, axis, place, frame, values, unit, named, signed=False, **marks):
    """Particles of a frame coloured by `values` (in `unit`) with a bar at `place`; from 0, or symmetric about it where `signed`."""
    points = np.asarray(frame.points)
    of_length, length = in_prefix("m", [points[:, :2].ravel()])
    of_value, shown = in_prefix(unit, [np.abs(values)])
    largest = max(np.abs(values).max() * of_value, 1e-300)
    norm, colours = Normalize(-largest if signed else 0, largest), "RdBu_r" if signed else "viridis"
    axis.scatter(points[:, 0] * of_length, points[:, 1] * of_length, c=values * of_value, cmap=colours, norm=norm, linewidths=0, **{"s": 14, **marks})
    axis.set_aspect("equal")
    axis.set_xlabel(f"x [{length}]", color=INK, fontsize=9)
    axis.set_ylabel(f"y [{length}]", color=INK, fontsize=9)
    style(axis)
    colour_bar(figure, place, norm, colours, f"{named} [{shown}]")
    return of_length
