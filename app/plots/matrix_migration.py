"""The picture of a matrix_migration run: von Mises stress of the matrix with the cell and its way at three times, way and speed over time."""
import os
import sys

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.patches import Circle

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, colour_bar, in_prefix, plt, read_table, style  # noqa: E402
from fields import frames  # noqa: E402


def cell_at(frame, migration, centre_at_start):
    """Where the cell's centre is in a frame: start plus its way then."""
    if frame.time <= 0:
        return centre_at_start
    return centre_at_start + np.array([np.interp(frame.time, migration["time [s]"], migration[f"{axis} [m]"]) for axis in "xy"])


def hole_of(frame):
    """Centre and radius of the hole that the cell leaves in the first frame: the point of a fine grid farthest from all particles."""
    points = np.asarray(frame.points)[:, :2]
    low, high = points.min(axis=0), points.max(axis=0)
    centre, step = (low + high) / 2, (high - low) / 2
    for _ in range(8):
        grid = np.stack(np.meshgrid(*[np.linspace(c - s, c + s, 41) for c, s in zip(centre, step)], indexing="ij"), axis=-1).reshape(-1, 2)
        grid = grid[np.all((grid >= low) & (grid <= high), axis=1)]
        nearest = np.array([np.min(((points - place) ** 2).sum(axis=1)) for place in grid])
        centre, step = grid[nearest.argmax()], step / 4
    return centre, np.sqrt(nearest.max())


def draw_matrix(axis, frame, norm, cell, radius, way):
    points = np.asarray(frame.points)
    of_length, length = in_prefix("m", [points[:, :2].ravel()])
    stress, intact = np.asarray(frame.field("von_mises_stress")), np.asarray(frame.field("intact"))
    size = max(0.4, 9000 / len(points))
    axis.scatter(points[:, 0] * of_length, points[:, 1] * of_length, c=stress * norm.of, cmap="viridis", norm=norm, s=size, linewidths=0)
    gone = intact < 0.5
    axis.scatter(points[gone, 0] * of_length, points[gone, 1] * of_length, s=size, color="#ff3b30", linewidths=0, label="more than half degraded")
    axis.add_patch(Circle(cell * of_length, radius * of_length, facecolor="#d9d9d9", edgecolor=INK, linewidth=1))
    if len(way):
        axis.plot(way[:, 0] * of_length, way[:, 1] * of_length, color=INK, linewidth=1)
    axis.set_aspect("equal")
    axis.set_xlabel(f"x [{length}]", color=INK, fontsize=9)
    of_time, clock = in_prefix("s", [np.array([frame.time])]) if frame.time > 0 else (1, "s")
    axis.set_title(f"t = {frame.time * of_time:.3g} {clock}", color=INK, fontsize=10)
    style(axis)
    return length


def draw_way(axis, migration):
    of_time, clock = in_prefix("s", [migration["time [s]"]])
    of_way, way = in_prefix("m", [migration["x [m]"]])
    axis.plot(migration["time [s]"] * of_time, migration["x [m]"] * of_way, color=ACCENT, linewidth=1.6, label="along the preferred direction")
    axis.plot(migration["time [s]"] * of_time, migration["y [m]"] * of_way, color=ALONG, linewidth=1.2, label="across")
    axis.set_xlabel(f"time [{clock}]", color=INK, fontsize=9)
    axis.set_ylabel(f"way of the cell [{way}]", color=INK, fontsize=9)
    axis.legend(frameon=False, fontsize=8)
    axis.set_title(f"{migration['x [m]'][-1] * of_way:.3g} {way} in {migration['time [s]'][-1] * of_time:.3g} {clock}", color=INK, fontsize=10)
    style(axis)


def main(directory):
    """Paths of the pictures made."""
    path = os.path.join(directory, "migration.csv")
    if not os.path.exists(path) or len(read_table(path)["time [s]"]) < 2:
        return []
    migration = read_table(path)
    figure = plt.figure(figsize=(14, 4.4), facecolor="white")
    shown = []
    if os.path.exists(os.path.join(directory, "solid.xdmf")):
        shown = frames(directory, "solid")
    if len(shown) > 1:
        centre, gap = hole_of(shown[0])
        spacing = np.sqrt(np.ptp(np.asarray(shown[0].points)[:, 0]) * np.ptp(np.asarray(shown[0].points)[:, 1]) / len(shown[0].points))
        radius = gap - 0.4 * spacing
        chosen = [shown[1], shown[len(shown) // 2], shown[-1]] if len(shown) > 3 else shown[1:]
        largest = max(float(np.percentile(np.asarray(frame.field("von_mises_stress")), 99.8)) for frame in chosen)
        of_stress, unit = in_prefix("Pa", [np.array([largest])])
        norm = Normalize(0, max(largest * of_stress, 1e-300))
        norm.of = of_stress
        for k, frame in enumerate(chosen):
            axis = figure.add_axes([0.045 + 0.235 * k, 0.2, 0.2, 0.7])
            past = migration["time [s]"] <= frame.time
            way = centre + np.stack([migration["x [m]"][past], migration["y [m]"][past]], axis=1)
            length = draw_matrix(axis, frame, norm, cell_at(frame, migration, centre), radius, way)
            if k == 0:
                axis.set_ylabel(f"y [{length}]", color=INK, fontsize=9)
                axis.legend(frameon=False, fontsize=8, loc="upper left", bbox_to_anchor=(0, -0.22), markerscale=3)
        colour_bar(figure, [0.25, 0.09, 0.24, 0.025], norm, "viridis", f"von Mises stress of the matrix [{unit}]")
    draw_way(figure.add_axes([0.785, 0.16, 0.2, 0.73]), migration)
    path = os.path.join(directory, "matrix_migration.png")
    figure.savefig(path, dpi=140)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
