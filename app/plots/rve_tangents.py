"""Pictures of an rve_response run's tangents: moduli and viscosities against direction (polar.csv), moduli along the path and the smallest
eigenvalue of the acoustic tensor with the direction of its band (tangent.csv).

draw(directory, over) -> paths of the pictures made, rve_polar.png and rve_tangents.png; over: (words, times, values) of what rises along the path
and is the abscissa of the latter, time where that is None.
"""
import os

import numpy as np
from matplotlib.ticker import MaxNLocator

from drawing import ACCENT, ALONG, INK, POINT, in_prefix, plt, read_table, style

GREEN = "#6b8e4e"


def table_of(directory, name):
    path = os.path.join(directory, name)
    return read_table(path) if os.path.exists(path) else {}


def clear_direction(curves, degrees, rings):
    """The angle, off the written ones, at which the numbers of these rings are farthest from the curves."""
    most = max(np.max(values) for values in curves)

    def covered(direction):
        near = np.abs((degrees - direction + 180) % 360 - 180) <= 8
        return sum(np.exp(-(np.min(np.abs(values[near] - ring)) / (0.06 * most)) ** 2) for values in curves for ring in rings if np.any(near))

    return min((15.0 + 45 * k + off for k in range(8) for off in (7.5, 0.0, 15.0)), key=covered)


def draw_polar(directory):
    table = table_of(directory, "polar.csv")
    if not len(table.get("direction [deg]", [])):
        return []
    angle = np.radians(np.concatenate([table["direction [deg]"], table["direction [deg]"] + 180, [360]]))
    around = lambda name: np.concatenate([table[name], table[name], table[name][:1]])  # noqa: E731
    panels = [("Young's modulus, sides free", "young_modulus [Pa]", "Pa", ACCENT), ("Shear modulus", "shear_modulus [Pa]", "Pa", ALONG),
              ("Viscosity: along (sides free) and in shear", "extensional_viscosity [Pa s]", "Pa s", ACCENT)]
    if not np.any(table["extensional_viscosity [Pa s]"] > 0):
        panels.pop()
    figure, axes = plt.subplots(1, len(panels), figsize=(4.8 * len(panels), 5.3), subplot_kw={"projection": "polar"}, layout="constrained")
    for axis, (title, name, unit, colour) in zip(axes, panels):
        shear = name.startswith("ext") and "shear_viscosity [Pa s]"
        factor, prefixed = in_prefix(unit, [table[name]])
        if unit == "Pa s" and table[name].max() < 0.1:
            factor, prefixed = 1e3, "mPa s"
        axis.plot(angle, factor * around(name), color=colour, linewidth=2, label="along the direction" if shear else None)
        if shear:
            axis.plot(angle, factor * around(shear), color=ALONG, linewidth=2, label="in shear along it")
            axis.legend(frameon=False, fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.06), ncols=2).set_in_layout(False)
        axis.set_ylim(0, 1.12 * factor * table[name].max())
        axis.set_title(f"{title} [{prefixed}]", fontsize=10, color=INK, pad=14)
        axis.tick_params(colors=INK, labelsize=8)
        rings = MaxNLocator(4, min_n_ticks=3).tick_values(0, axis.get_ylim()[1])
        rings = rings[(rings > 0) & (rings < axis.get_ylim()[1])]
        axis.set_yticks(rings)
        axis.set_axisbelow(False)  # the numbers stand above the curves, on white
        axis.set_rlabel_position(clear_direction([factor * around(one) for one in (name, shear) if one], np.degrees(angle), rings))
        for text in axis.get_yticklabels():
            text.set_bbox(dict(facecolor="white", edgecolor="none", alpha=0.8, pad=0.6))
        axis.grid(alpha=0.4)
    figure.supxlabel("the tissue at rest, against direction: 0° is x, 90° is y", color=INK, fontsize=10)
    made = os.path.join(directory, "rve_polar.png")
    figure.savefig(made, dpi=130)
    plt.close(figure)
    return [made]


def draw_path(directory, over):
    table, stress = table_of(directory, "tangent.csv"), table_of(directory, "stress.csv")
    if len(table.get("time [s]", [])) < 2:
        return []
    time = table["time [s]"]
    factor, unit = in_prefix("s", [time])
    words, along = (over[0], np.interp(time, over[1], over[2])) if over else (f"time [{unit}]", factor * time)
    panels = [("Tangent modulus, sides free", {"along x": "path_modulus_x [Pa]", "along y": "path_modulus_y [Pa]", "shear, x over y": "path_shear_modulus [Pa]"}),
              ("Tangent modulus, sides held", {"along x": "path_held_modulus_x [Pa]", "along y": "path_held_modulus_y [Pa]"}),
              ("Smallest eigenvalue of the\nacoustic tensor", {"": "acoustic [Pa]"})]
    figure, axes = plt.subplots(1, 4, figsize=(17, 4.2), layout="constrained")
    for axis, (title, lines) in zip(axes, panels):
        values = [table[name] for name in lines.values()]
        factor, prefixed = in_prefix("Pa", values)
        for (label, name), colour, dash in zip(lines.items(), (ACCENT, ALONG, GREEN), ("-", (0, (5, 3)), "-")):
            axis.plot(along, factor * table[name], color=colour, linestyle=dash, linewidth=1.8, label=label or None)
        axis.set_ylabel(f"{title.replace(chr(10), ' ')} [{prefixed}]", color=INK)
        if min(np.min(v) for v in values) < 0:
            axis.axhline(0, color=INK, linewidth=0.8)
        if len(lines) > 1:
            axis.legend(frameon=False, fontsize=9)
    lost = table["acoustic [Pa]"] <= 0
    if lost.any():
        first = along[np.argmax(lost)]
        axes[2].axvspan(first, along[-1], color=ACCENT, alpha=0.12, linewidth=0)
        axes[2].text(first, axes[2].get_ylim()[1], " no longer elliptic", color=ACCENT, fontsize=8, va="top", ha="right", rotation=90)
    for name, label, colour in (("acoustic_normal [deg]", "normal of the band", ACCENT), ("acoustic_motion [deg]", "its motion", ALONG)):
        axes[3].plot(along, table[name], ".", color=colour, markersize=POINT, label=label)
    axes[3].set_ylim(-5, 185)
    axes[3].set_yticks(range(0, 181, 45))
    axes[3].set_ylabel("Direction of that band, from x [°]", color=INK)
    axes[3].legend(frameon=False, fontsize=9)
    for axis in axes:
        axis.set_xlabel(words, color=INK)
        style(axis)
    if len(stress.get("time [s]", [])) > len(time):
        figure.text(0.01, 0.005, f"{len(stress['time [s]']) - len(time)} points without a tangent are left out", fontsize=8, color=INK)
    figure.suptitle("Tangents along the path, and how far the tissue is from sliding by itself in a band (zero: ellipticity is lost)", color=INK, fontsize=12)
    made = os.path.join(directory, "rve_tangents.png")
    figure.savefig(made, dpi=130)
    plt.close(figure)
    return [made]


def draw(directory, over=None):
    return draw_polar(directory) + draw_path(directory, over)
