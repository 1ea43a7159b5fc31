"""The picture of a static_lattice run: every cell at rest under the load, coloured by its pressure, over where the cells were without it.

main(directory) reads lattice.xdmf and writes static_lattice.png.
"""
import os
import sys

import numpy as np
from matplotlib.collections import PolyCollection

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import INK, plt, scale_bar  # noqa: E402
from fields import frames  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    if not os.path.exists(os.path.join(directory, "lattice.xdmf")):
        return []
    frame = frames(directory, "lattice")[-1]
    points = frame.points[:, :2] * 1e3
    moved = frame.field("displacement").reshape(len(points), 3)[:, :2] * 1e3
    first = np.flatnonzero(np.diff(frame.field("cell").ravel(), prepend=-1.0))
    pressure = frame.field("pressure").ravel()[first] / 1e3
    now, before = np.split(points, first[1:]), np.split(points - moved, first[1:])
    figure, axis = plt.subplots(figsize=(7.5, 6.2), layout="constrained")
    axis.add_collection(PolyCollection(before, facecolors="none", edgecolors="#b9c2c9", linewidths=0.6))
    drawn = axis.add_collection(PolyCollection(now, array=pressure, cmap="viridis", edgecolors=INK, linewidths=0.4))
    figure.colorbar(drawn, ax=axis, label="pressure of the cell [kPa]", shrink=0.8)
    low, high = (points - moved).min(axis=0), (points - moved).max(axis=0)
    scale_bar(axis, low[0], min(points[:, 1].min(), low[1]) - 0.06 * (high[0] - low[0]), high[0] - low[0])
    axis.set_aspect("equal")
    axis.axis("off")
    axis.autoscale_view()
    axis.margins(0.06)
    figure.suptitle(f"{len(now)} cells at rest under their load, true scale; grey: without it\n"
                    f"the walls have moved by up to {1e3 * np.hypot(*moved.T).max():.3g} µm", color=INK, fontsize=11)
    made = os.path.join(directory, "static_lattice.png")
    figure.savefig(made, dpi=130)
    plt.close(figure)
    return [made]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
