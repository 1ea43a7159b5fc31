"""The picture of an rve_response run: the path of deformation, stress against strain, pressure.

main(directory) reads stress.csv and writes rve_response.png; of tissue that is not square also rve_cells.png, from cells.csv and the periods in
summary.json, and what rve_tangents.py draws. A path of several parts has a stress-strain curve for each of the two components
of F that lead most of it.
"""
import json
import os
import sys

import numpy as np
from matplotlib.collections import PolyCollection

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from deformation import COMPONENTS, NAMES, abscissa, parts_of_path  # noqa: E402
from drawing import ACCENT, ALONG, INK, input_entries, plt, read_table, style  # noqa: E402
from own_data import draw_data  # noqa: E402
from rve_tangents import draw  # noqa: E402

COLOURS = {"xx": ACCENT, "yy": ALONG, "xy": "#6b8e4e", "yx": "#8a6fb0"}
WIDTHS = {"xx": 3.4, "xy": 1.8, "yy": 1.8}  # where two are zero both are seen, the later over the broader one


def found_result(directory, name):
    """A result of summary.json, or None."""
    try:
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            return json.load(file)["results"][name]["value"]
    except (OSError, ValueError, KeyError):
        return None


def air_share(directory):
    """"6 % air at rest (" by summary.json; "air (" without."""
    share = found_result(directory, "air_share_at_rest")
    return "air (" if share is None else f"{100 * share:.2g} % air at rest ("


def what_is_loaded(directory, found):
    """A line for the title: layout, cells, air, and which components of F are given or found."""
    entries = input_entries(directory)
    words = [f"{entries.get(('Structure', 'Structure'), 'square')} cells, {entries.get(('RVE', 'Columns'), '1')} x {entries.get(('RVE', 'Rows'), '1')}"]
    gap = found_result(directory, "corner_gap") or float(entries.get(("Structure", "Gap"), "0") or 0)
    if gap > 0:
        air = entries.get(("Structure", "Air"), "connected")
        words.append(f"{air_share(directory)}gap {1e6 * gap:.3g} µm), " + ("which leaves freely" if air == "connected" else f"shut in ({air}), which stiffens"))
    words.append("F given" if found == ["none"] else ", ".join(f"P_{component}" for component in found) + " given, F else")
    return "; ".join(words)


def draw_cells(directory, F):
    """The piece of tissue at turgor and at the last F, with its periodic images; None without cells.csv."""
    path, summary = os.path.join(directory, "cells.csv"), os.path.join(directory, "summary.json")
    if not (os.path.exists(path) and os.path.exists(summary)):
        return None
    table = read_table(path)
    with open(summary, encoding="utf-8") as file:
        found = json.load(file)["results"]
    H = 1e6 * np.array([found[f"period_{c}"]["value"] for c in COMPONENTS]).reshape(2, 2)
    window = input_entries(directory).get(("RVE", "Boundary"), "periodic") != "periodic"
    near = (0,) if window else (-1, 0, 1)
    figure, axes = plt.subplots(1, 2, figsize=(11, 5.4), layout="constrained")
    shapes = [1e6 * np.column_stack([table[f"{x} [m]"], table[f"{y} [m]"]]) for x, y in (("x", "y"), ("end_x", "end_y"))]
    half = 0.62 * max(np.ptp(nodes, axis=0).max() for nodes in shapes)  # one scale: the two are compared by eye
    for axis, nodes, lattice, title in zip(axes, shapes, (H, F @ H), ("at turgor", "at the end of the path")):
        cells = [nodes[table["cell"] == c] for c in np.unique(table["cell"])]
        for shift in sorted(((i, j) for i in near for j in near), key=lambda one: one == (0, 0)):  # itself last
            axis.add_collection(PolyCollection([cell + lattice @ shift for cell in cells], facecolors="#dbe7c9" if shift == (0, 0) else "#f1f3ee",
                                               edgecolors=INK if shift == (0, 0) else "#aab2b8", linewidths=1.1))
        middle = (nodes.min(axis=0) + nodes.max(axis=0)) / 2
        axis.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half), aspect="equal")
        axis.set_xlabel(f"{title}: x [µm]", color=INK)
        axis.set_ylabel("y [µm]", color=INK)
        style(axis)
    figure.suptitle("The piece of tissue, cut along its walls" if window else "The piece of tissue (green) among its periodic images", color=INK, fontsize=12)
    made = os.path.join(directory, "rve_cells.png")
    figure.savefig(made, dpi=130)
    plt.close(figure)
    return made


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "stress.csv")
    table = read_table(path) if os.path.exists(path) else {}
    if len(table.get("time [s]", [])) < 2:
        return []
    strain = {c: 100 * (table[f"F_{c} [1]"] - (c in ("xx", "yy"))) for c in COMPONENTS}
    found = input_entries(directory).get(("Path", "Stress components"), "none").replace(" ", "").split(",")
    parts = parts_of_path(strain, found)
    figure, axes = plt.subplots(1, 2 + len(parts), figsize=(4.3 * (2 + len(parts)), 4.2), layout="constrained")
    time = table["time [s]"]
    scale, unit = (1e6, "µs") if time[-1] < 1e-3 else (1e3, "ms") if time[-1] < 1 else (1, "s")
    for c in COMPONENTS:
        if np.ptp(strain[c]) > 1e-9:
            axes[0].plot(scale * time, strain[c], color=COLOURS[c], linewidth=1.8, label=NAMES[c])
    axes[0].set_ylabel("deformation F - I [%]", color=INK)
    applies = table.get("closed_form_applies", np.zeros(len(time))) > 0.5
    for axis, (lead, rows) in zip(axes[1:], parts):
        sign, words = abscissa(strain, lead)
        for c in ("xx", "xy", "yy"):
            for k, pair in enumerate(rows):
                pair = list(pair)
                axis.plot(sign * strain[lead][pair], table[f"sigma_{c} [Pa]"][pair] / 1e3, color=COLOURS[c], linewidth=WIDTHS[c],
                          label=f"$\\sigma_{{{c}}}$" if k == 0 else None)
                if applies[pair].all():
                    axis.plot(sign * strain[lead][pair], table[f"closed_sigma_{c} [Pa]"][pair] / 1e3, color=INK, linewidth=1,
                              linestyle=(0, (2, 2)), label="closed form (flat walls)" if c == "yy" and k == 0 else None)
            draw_data(axis, f"F_{lead} [1]", f"sigma_{c} [Pa]", 100 * sign, 1e-3, float(lead in ("xx", "yy")))
        axis.set_xlabel(words, color=INK)
        axis.set_ylabel("Cauchy stress, positive in tension [kPa]", color=INK)
    axes[-1].plot(scale * time, table["pressure [Pa]"] / 1e3, color=ALONG, linewidth=1.8)
    axes[-1].set_ylabel("pressure of the cells' fluid [kPa]", color=INK)
    for axis in axes:
        style(axis)
    for axis in axes[:-1]:
        axis.set_ylim(top=axis.get_ylim()[1] + 0.35 * np.ptp(axis.get_ylim()))  # room for the legend
        axis.legend(frameon=False, fontsize=9, loc="upper left", ncols=2)
    for axis in (axes[0], axes[-1]):
        axis.set_xlabel(f"time [{unit}]", color=INK)
    figure.suptitle("Path of deformation, and the stress one piece of cell structure answers with\n" + what_is_loaded(directory, found),
                    color=INK, fontsize=12)
    made = os.path.join(directory, "rve_response.png")
    figure.savefig(made, dpi=130)
    plt.close(figure)
    cells = draw_cells(directory, np.array([table[f"F_{c} [1]"][-1] for c in COMPONENTS]).reshape(2, 2))
    over = None
    if len(parts) == 1 and len(parts[0][1]) == len(time) - 1:
        lead = parts[0][0]
        sign, words = abscissa(strain, lead)
        over = (words, time, sign * strain[lead]) if np.all(np.diff(sign * strain[lead]) > 0) else None
    return [made] + ([cells] if cells else []) + draw(directory, over)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
