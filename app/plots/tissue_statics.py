"""The picture of a tissue_statics run: the tissue at rest under its load, coloured by shear stress, beside the pressure of its cells.

Where loads were followed by arc length (path.csv) the load over the displacement of the free side stands in place of the pressure.

main(directory) reads tissue.xdmf, path.csv and writes tissue_statics.png.
"""
import os
import sys

import numpy as np
from matplotlib.colors import Normalize

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, INK, POINT, plt, read_table, scale_bar, style  # noqa: E402
from fields import frames  # noqa: E402


def draw_path(axis, path):
    """Share of the loads over how far the free side has gone, with the first limit and the end, which the other panel shows."""
    gone = np.hypot(path["side_displacement_x [m]"], path["side_displacement_y [m]"]) * 1e3
    share = 100 * path["load_share [1]"]
    axis.plot(gone, share, ".-", color=INK, linewidth=1.6, markersize=POINT, label="path of equilibria, step by step")
    falls = np.flatnonzero(np.diff(share) < 0)
    if len(falls) > 0:
        limit = falls[0]
        axis.plot(gone[limit], share[limit], "v", markersize=9, color=ACCENT, markerfacecolor="none", markeredgewidth=1.6,
                  label=f"limit: {share[limit]:.3g} % of the load")
        axis.axhline(share[limit], color=ACCENT, linewidth=1.0, linestyle=(0, (4, 3)), label="a load that only grows leaves the path here")
    axis.plot(gone[-1], share[-1], "o", markersize=8, color=INK, markerfacecolor="none", markeredgewidth=1.5, label="end, drawn on the right")
    axis.set_xlabel("mean displacement of the free side [mm]", color=INK, fontsize=10)
    axis.set_ylabel("load that is on [% of all]", color=INK, fontsize=10)
    axis.set_xlim(0, None)
    axis.set_ylim(min(0, share.min()), 1.3 * share.max())
    style(axis)
    axis.legend(frameon=False, fontsize=9, loc="upper left")


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
    shown = [(shear, "YlGnBu", Normalize(0, max(shear.max(), 1e-9)), "size of the shear stress [kPa]"),
             (0.5 * (stress[:, 0] + stress[:, 4]), "RdBu_r", None, "mean stress, positive in tension [kPa]")]
    path = read_table(os.path.join(directory, "path.csv")) if os.path.exists(os.path.join(directory, "path.csv")) else None
    if path is not None:
        draw_path(axes[0], path)
    drawn_on = axes if path is None else axes[1:]
    for axis, (values, colours, norm, label) in zip(drawn_on, shown):
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
    drawn_on[0].legend(frameon=False, fontsize=9, loc="upper right", bbox_to_anchor=(1, 1.08), ncols=2)
    moved = np.abs(points - reference).max() * 1e3
    figure.suptitle(f"Tissue at rest under its load (true scale); it has moved by up to {moved:.3g} µm", color=INK, fontsize=12)
    made = os.path.join(directory, "tissue_statics.png")
    figure.savefig(made, dpi=130)
    plt.close(figure)
    return [made]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
