"""Draws a round cell of wall.xdmf and fluid.xdmf: in 3D its wall as triangles seen from the side, coloured by stretch, fluid behind
what is broken away; in 2D particles coloured by pressure within the ring."""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK  # noqa: E402
from fields import frames  # noqa: E402


def has_cell(directory):
    return os.path.exists(os.path.join(directory, "wall.xdmf"))


def cell_frames(directory):
    """(wall frame, fluid frame or None) over time."""
    walls = frames(directory, "wall")
    fluid = {f.time: f for f in frames(directory, "fluid")} if os.path.exists(os.path.join(directory, "fluid.xdmf")) else {}
    return [(w, fluid.get(w.time)) for w in walls]


def draw_cell(axis, wall, fluid, norm, reach, plates=(), colours="inferno", ahead=(0.45, -1.0, 0.25)):
    """Lengths in um. norm: of the stretch (3D) or pressure in kPa (2D)."""
    cmap = plt.get_cmap(colours)
    x = wall.points * 1e6
    cells = wall.cells
    flat = cells.shape[1] == 2
    if flat:
        if fluid is not None:
            axis.scatter(*(fluid.points[:, :2] * 1e6).T, c=fluid.field("pressure").ravel() / 1e3, s=9, cmap=cmap, norm=norm,
                         linewidths=0)
        axis.add_collection(LineCollection(x[cells][:, :, :2], colors=INK, linewidths=1.6))
    else:
        view = np.array(ahead) / np.linalg.norm(ahead)
        right = np.cross(view, [0, 0, 1.0])
        right /= np.linalg.norm(right)
        up = np.array([0, 0, 1.0]) - 0.0
        # a side view: heights are true, so that plates are lines
        view = np.cross(up, right)
        to_plane = lambda p: np.stack([p @ right, p @ up], axis=-1)
        if fluid is not None:
            f = fluid.points * 1e6
            axis.scatter(*to_plane(f).T, s=5, color="#7fb2d9", linewidths=0)
        corners = x[cells]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normal /= np.linalg.norm(normal, axis=1)[:, None] + 1e-300
        facing = -(normal @ view) if (corners.mean(axis=1) * normal).sum() > 0 else normal @ view
        front = facing > 0
        order = np.argsort((corners[front].mean(axis=1)) @ -view)
        # faint, so that the colours stay those of the bar
        stretch = wall.field("stretch").ravel()[cells][front].mean(axis=1)
        light = 0.85 + 0.15 * np.clip(normal[front] @ (-0.7 * view + 0.55 * up - 0.35 * right), 0, 1)
        colour = cmap(norm(stretch))
        colour[:, :3] *= light[:, None]
        axis.add_collection(PolyCollection(to_plane(corners[front])[order], facecolors=colour[order],
                                           edgecolors=(0, 0, 0, 0.10), linewidths=0.2))
    for height in plates:
        axis.plot([-1.25 * reach, 1.25 * reach], [height, height], color=INK, linewidth=4, solid_capstyle="butt")
    axis.set_aspect("equal")
    axis.set_xlim(-1.3 * reach, 1.3 * reach)
    axis.axis("off")
