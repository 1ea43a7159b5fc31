"""A cell of the rod model in the plane of a picture: a rod with half circles at its ends, and its nucleus."""
import numpy as np
from matplotlib.patches import Circle, Polygon, Rectangle

BODY, RIM, NUCLEUS = "#f2c9b1", "#b5562a", "#8c3f1d"


def draw_rod(axis, a, b, radius, nucleus, order=3, inside=None):
    """a, b: centres of the half circles; inside: (least, most) height that is drawn."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    turned = np.arctan2(*(b - a)[::-1])
    arc = np.linspace(-0.5 * np.pi, 0.5 * np.pi, 40)
    outline = [end + radius * np.column_stack([np.cos(turn + arc), np.sin(turn + arc)]) for end, turn in ((b, turned), (a, turned + np.pi))]
    drawn = [Polygon(np.vstack(outline), facecolor=BODY, edgecolor=RIM, linewidth=1.2, alpha=0.85, zorder=order)]
    if nucleus > 0:
        drawn.append(Circle(0.5 * (a + b), nucleus, facecolor=NUCLEUS, edgecolor="none", alpha=0.75, zorder=order + 0.1))
    for patch in drawn:
        axis.add_patch(patch)
        if inside:
            far = 10 * (radius + np.hypot(*(b - a)))
            patch.set_clip_path(Rectangle((a[0] - far, inside[0]), 2 * far, inside[1] - inside[0], transform=axis.transData))
