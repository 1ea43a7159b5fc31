"""Draws the surface of a deformable cell of surface.xdmf, seen from the side, its triangles coloured by in-plane stress."""
import os
import sys

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import plt  # noqa: E402

COLOURS = plt.get_cmap("RdBu_r")  # red: tension, blue: compression


def stress(frame):
    """In uN/m, of each node."""
    return frame.field("in_plane_stress").ravel() * 1e6


def stress_scale(frames):
    """White at 0, equally deep in blue and red for equal stress; 99 of 100 nodes of all frames are within the ends."""
    reach = max(np.percentile(np.abs(np.concatenate([stress(frame) for frame in frames])), 99), 1e-9)
    return Normalize(-reach, reach)


def section(frame, height, values):
    """Lines in which surfaces meet the plane at a height (m): their ends in um (n x 2 x 2) and the values (of nodes) in their middles."""
    corners = frame.points[frame.cells]
    z = corners[:, :, 2] - height
    crossed = (z.min(axis=1) < 0) & (z.max(axis=1) >= 0)
    ends, middles = [], []
    for x, d, v in zip(corners[crossed], z[crossed], values[frame.cells][crossed]):
        points, at = [], []
        for k in range(3):
            n = (k + 1) % 3
            if (d[k] < 0) != (d[n] < 0):
                share = d[k] / (d[k] - d[n])
                points.append((x[k] + share * (x[n] - x[k]))[:2] * 1e6)
                at.append(v[k] + share * (v[n] - v[k]))
        ends.append(points)
        middles.append(np.mean(at))
    return np.array(ends), np.array(middles)


def draw_surface(axis, frame, norm, right, up, at=(0.0, 0.0), values=None, colours=COLOURS):
    """Lengths in um. right, up: directions of the picture; at: where the cell's middle is drawn; values: of the nodes, in-plane stress (uN/m) where none are given."""
    x = frame.points * 1e6
    _draw(axis, x - 0.5 * (x.min(axis=0) + x.max(axis=0)), frame.cells, norm, right, up, at, stress(frame) if values is None else values, colours)


def draw_cells(axis, frame, norm, right, up, at, only=None):
    """The same where the cells lie, moved by `at` (um) along `right`; only: number of the one cell that is drawn."""
    cells = frame.cells if only is None else frame.cells[frame.field("cell").ravel()[frame.cells[:, 0]] == only]
    _draw(axis, frame.points * 1e6, cells, norm, right, up, (at, 0.0), stress(frame), COLOURS)


def _draw(axis, x, cells, norm, right, up, at, values, colours):
    right, up = (np.array(v, dtype=float) / np.linalg.norm(v) for v in (right, up))
    view = np.cross(right, up)  # towards the viewer
    corners = x[cells]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1)[:, None] + 1e-300
    front = normal @ view > 0
    order = np.argsort(corners[front].mean(axis=1) @ view)
    colour = colours(norm(values[cells][front].mean(axis=1)))
    colour[:, :3] *= (0.72 + 0.28 * np.clip(normal[front] @ (0.8 * view + 0.5 * up - 0.33 * right), 0, 1))[:, None]
    flat = np.stack([corners[front] @ right, corners[front] @ up], axis=-1) + np.array(at)
    axis.add_collection(PolyCollection(flat[order], facecolors=colour[order], edgecolors=(0, 0, 0, 0.12), linewidths=0.15))
    axis.set_aspect("equal")
