"""What makes any panel legible: labels of logarithmic axes, legends that stand where they cover no data. drawing.py sees to both: `style(axis)`
the labels, saving a figure the legends.
"""
import matplotlib
import matplotlib.ticker
import numpy as np


class FewLogTicks(matplotlib.ticker.LogLocator):
    """Of a logarithmic axis: at least three labels in view, wherever it begins and ends, and no more than are legible."""

    def tick_values(self, vmin, vmax):
        low, high = sorted((vmin, vmax))
        if not 0 < low < high:
            return np.array([])
        first, last = int(np.floor(np.log10(low))), int(np.ceil(np.log10(high)))
        powers = 10.0 ** np.arange(first, last + 1)
        for subs in ((1,), (1, 2, 5), (1, 1.5, 2, 3, 5, 7)):
            ticks = np.outer(powers[::1 + (last - first) // 7] if subs == (1,) else powers, subs).ravel()
            ticks = ticks[(ticks >= low * (1 - 1e-9)) & (ticks <= high * (1 + 1e-9))]
            if len(ticks) >= 3:
                return ticks
        return matplotlib.ticker.MaxNLocator(4, steps=[1, 2, 5, 10]).tick_values(low, high)


def log_text(value, powers=False):
    """0.02, 5, 1000; or as powers of ten."""
    if value <= 0 or not powers:
        return f"{value:g}"
    power = int(np.floor(np.log10(value) + 1e-9))
    front = value / 10.0 ** power
    return f"$10^{{{power}}}$" if abs(front - 1) < 1e-6 else f"${front:g}\\cdot 10^{{{power}}}$"


class LogText(matplotlib.ticker.Formatter):
    """Numbers of a logarithmic axis: all of them written out, or where some would be long all as powers of ten."""

    def __call__(self, value, place=None):
        low, high = self.axis.get_view_interval()
        return log_text(value, low < 0.9e-4 or high > 2e5)


def readable_log(axis):
    """The labels of an axis (x or y) that is logarithmic; to the base ten."""
    if axis.get_scale() == "log" and getattr(axis.get_transform(), "base", 10) == 10:
        axis.set_major_locator(FewLogTicks())
        axis.set_major_formatter(LogText())
        axis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def points_in_view(axis):
    """Places in pixels along all lines and points of a panel, some pixels apart at most."""
    places = [np.empty((0, 2))]
    for line in axis.lines:
        if not line.get_visible() or line.get_transform() != axis.transData or len(line.get_xdata()) == 0:
            continue
        at = axis.transData.transform(np.column_stack([np.asarray(line.get_xdata(), float), np.asarray(line.get_ydata(), float)]))
        at = at[np.all(np.isfinite(at), axis=1)]
        if line.get_linestyle() not in ("None", "", " ") and len(at) > 1:
            fine = np.linspace(0, 1, 60)[:, None]
            at = np.concatenate([a + fine * (b - a) for a, b in zip(at[:-1], at[1:])] if len(at) < 400 else [at])
        places.append(at)
    return np.concatenate(places)


PLACES = ("upper left", "upper right", "lower left", "lower right", "upper center", "lower center", "center left", "center right")


def clear_of_data(figure):
    """Legends inside a panel of curves go where they cover none; where there is no such place, the panel grows upwards by the legend."""
    inside = [axis for axis in figure.axes if axis.lines and not axis.images and axis.get_legend() is not None and axis.name == "rectilinear" and
              not axis.collections and axis.get_aspect() == "auto" and axis.get_yscale() in ("linear", "log")]
    if not inside:
        return
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    for axis in inside:
        legend, panel = axis.get_legend(), axis.get_window_extent(renderer)
        box = legend.get_window_extent(renderer)
        if not (panel.x0 <= (box.x0 + box.x1) / 2 <= panel.x1 and panel.y0 <= (box.y0 + box.y1) / 2 <= panel.y1) or len(axis.get_shared_y_axes().get_siblings(axis)) > 1:
            continue  # beside it, or a panel that others share their scale with

        def covered(at, within):
            return int(np.sum((at[:, 0] > within.x0 - 3) & (at[:, 0] < within.x1 + 3) & (at[:, 1] > within.y0 - 3) & (at[:, 1] < within.y1 + 3)))

        twins = [other for other in figure.axes if other.get_window_extent(renderer).bounds == panel.bounds]
        at = np.concatenate([points_in_view(one) for one in twins])
        if not covered(at, box):
            continue
        legend.set_bbox_to_anchor(None)
        counts = {}
        for place in PLACES:
            legend.set_loc(place) if hasattr(legend, "set_loc") else legend._set_loc(legend.codes[place])
            counts[place] = covered(at, legend.get_window_extent(renderer))
            if not counts[place]:
                break
        best = min(counts, key=counts.get)
        if counts[best] and len(twins) == 1:  # no place is free: room above
            best = "upper left"
            low, high = axis.get_ylim()
            share = min(0.6, (box.height + 10) / panel.height)
            if axis.get_yscale() == "log":
                axis.set_ylim(low, low * (high / low) ** (1 / (1 - share)))
            else:
                axis.set_ylim(low, low + (high - low) / (1 - share))
        legend.set_loc(best) if hasattr(legend, "set_loc") else legend._set_loc(legend.codes[best])
