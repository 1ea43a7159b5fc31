"""The picture of a network_shear run: the sheared network coloured by tension, its stress over the strain beside the affine limit, and the moduli of all networks beside theirs."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, POINT, colour_bar, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402
from matplotlib.colors import Normalize  # noqa: E402
from own_data import draw_data  # noqa: E402


def draw_networks(figure, directory, area):
    shapes = frames(directory, "network")
    chosen = [shapes[0], shapes[-1]] if len(shapes) > 1 else list(shapes)
    tensions = [shape.field("tension").ravel() * 1e9 for shape in chosen]
    most = max(max(np.abs(t).max() for t in tensions), 1e-300)
    norm = Normalize(-most, most)
    axis = figure.add_axes(area)
    foot = 0.0
    for shape, tension in zip(chosen, tensions):
        x = shape.points[:, :2] * 1e6
        low, high = x.min(axis=0), x.max(axis=0)
        lines = x[shape.cells.reshape(-1, 2)] - np.array([low[0], high[1] - foot])
        axis.add_collection(LineCollection(lines, array=tension, cmap="coolwarm", norm=norm, linewidths=1.1))
        axis.text(0, foot + 0.015 * (high[1] - low[1]), "at rest" if shape.time == 0 else f"sheared by {100 * shape.time:.0f} %", color=INK, fontsize=9, va="bottom")
        foot -= 1.16 * (high[1] - low[1])
        width = high[0] - low[0]
    axis.autoscale()
    axis.set_aspect("equal")
    scale_bar(axis, 0, foot + 0.1 * width, width, "µm")
    axis.axis("off")
    if len(chosen) > 1:
        colour_bar(figure, [area[0] + 0.02, 0.075, area[2] - 0.05, 0.018], norm, plt.get_cmap("coolwarm"), "tension of a fibre [nN]: blue pushed, red pulled", tensions[-1])


def draw_shear(axis, directory):
    table = read_table(os.path.join(directory, "shear.csv"))
    strain = table["strain [1]"] * 100
    axis.plot(strain, table["affine_shear_stress [Pa]"], color=INK, linewidth=1.2, linestyle=(0, (4, 3)), label="affine limit")
    axis.plot(strain, table["shear_stress [Pa]"], color=ACCENT, linewidth=2, label="shear stress")
    axis.plot(strain, table["normal_stress_y [Pa]"], color=ALONG, linewidth=1.2, label="normal stress across")
    draw_data(axis, "strain [1]", "shear_stress [Pa]", 100, 1)
    axis.axhline(0, color="#c8d0d6", linewidth=0.8)
    axis.set_xlabel("shear of the first network [%]", color=INK, fontsize=9)
    axis.set_ylabel("stress [Pa]", color=INK, fontsize=9)
    axis.legend(frameon=False, fontsize=8.5)
    style(axis)


def draw_moduli(axis, directory):
    """Against the stiffness over the pore size, which alone they follow while nothing else changes."""
    table = read_table(os.path.join(directory, "moduli.csv"))
    over = table["stiffness [N/m]"] / table["pore_size [m]"]
    for name, colour, label, symbol in (("young_modulus [Pa]", ACCENT, "Young's modulus", "o"), ("shear_modulus [Pa]", ALONG, "shear modulus", "s")):
        places = np.unique(over)
        affine = [table["affine_" + name][over == place].mean() for place in places]
        axis.plot(places, affine, color=colour, linewidth=1.1, linestyle=(0, (4, 3)), label=label + ", affine limit (mean)")
        shown = table[name] > 0
        axis.plot(over[shown], table[name][shown], symbol, color=colour, markersize=POINT, markerfacecolor="white", label=label)
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_xlabel("stiffness of the fibres over pore size [Pa]", color=INK, fontsize=9)
    axis.set_ylabel("modulus of the network [Pa]", color=INK, fontsize=9)
    axis.legend(frameon=False, fontsize=8.5)
    style(axis)


def main(directory):
    """Paths of the pictures made."""
    if not os.path.exists(os.path.join(directory, "moduli.csv")):
        return []
    has_frames, is_sheared = (os.path.exists(os.path.join(directory, name)) for name in ("network.xdmf", "shear.csv"))
    figure = plt.figure(figsize=(11.5, 6.2), facecolor="white")
    if has_frames:
        draw_networks(figure, directory, [0.01, 0.11, 0.42, 0.86])
    left = 0.52 if has_frames else 0.1
    if is_sheared:
        draw_shear(figure.add_axes([left, 0.58, 0.98 - left, 0.39]), directory)
    draw_moduli(figure.add_axes([left, 0.09, 0.98 - left, 0.38 if is_sheared else 0.86]), directory)
    path = os.path.join(directory, "network_shear.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
