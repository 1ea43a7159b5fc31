"""The picture of a tissue_statics run: the tissue at rest under its load, coloured by shear stress, beside the pressure of its cells.

main(directory) reads tissue.xdmf and writes tissue_statics.png.
"""
import os
import sys

import numpy as np
from matplotlib.colors import Normalize

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import INK, plt, scale_bar  # noqa: E402
from fields import frames  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    if not os.path.exists(os.path.join(directory, "tissue.xdmf")):
        return []
    frame = frames(directory, "tissue")[-1]
    cells = frame.cells.reshape(-1, 4)
    points = frame.points[:, :2] * 1e3
    reference = points - frame.field("displacement").reshape(len(points), 3)[:, :2] * 1e3
    stress = frame.field("stress").reshape(len(cells), 9) / 1e3
    low, high = reference.min(axis=0), reference.max(axis=0)
    width = high[0] - low[0]
    figure, axes = plt.subplots(1, 2, figsize=(12, 5.4), layout="constrained")
    triangles = np.vstack([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
    shear = np.abs(stress[:, 1])
    for axis, values, colours, norm, label in (
            (axes[0], shear, "YlGnBu", Normalize(0, max(shear.max(), 1e-9)), "size of the shear stress [kPa]"),
            (axes[1], 0.5 * (stress[:, 0] + stress[:, 4]), "RdBu_r", None, "mean stress, positive in tension [kPa]")):
        if norm is None:
            most = max(np.abs(values).max(), 1e-9)
            norm = Normalize(-most, most)
        drawn = axis.tripcolor(*points.T, triangles, facecolors=np.tile(values, 2), cmap=colours, norm=norm)
        figure.colorbar(drawn, ax=axis, label=label, shrink=0.8)
        ghost = np.array([low, [high[0], low[1]], high, [low[0], high[1]], low])
        axis.plot(*ghost.T, color="#8795a1", linewidth=1.0, linestyle=(0, (4, 3)), label="without load")
        axis.plot([low[0], low[0]], [low[1], high[1]], color=INK, linewidth=3, label="held side")
        scale_bar(axis, low[0], min(points[:, 1].min(), low[1]) - 0.06 * width, width)
        axis.set_aspect("equal")
        axis.axis("off")
        axis.margins(0.08)
    axes[0].legend(frameon=False, fontsize=9, loc="upper right", bbox_to_anchor=(1, 1.08), ncols=2)
    moved = np.abs(points - reference).max() * 1e3
    figure.suptitle(f"Tissue at rest under its load (true scale); it has moved by up to {moved:.3g} µm", color=INK, fontsize=12)
    made = os.path.join(directory, "tissue_statics.png")
    figure.savefig(made, dpi=130)
    plt.close(figure)
    return [made]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
