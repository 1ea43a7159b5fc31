"""What the pictures share: tables, colours, axes, the probe's history, numbers beside points that do not cover each other.
"""
import atexit
import csv
import os
import sys

import matplotlib
import matplotlib.ticker

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from legible import clear_of_data, readable_log  # noqa: E402


def _record(path):
    """The list of what turgor made in the directory of this file, if that is one of a run."""
    return os.path.join(os.path.dirname(path), "made_by_turgor.txt")


def _is_made(path):
    with open(_record(path), encoding="utf-8") as file:
        return os.path.basename(path) in file.read().splitlines()


def _is_somebodys(path):
    """Whether something stands there, in the directory of a run, that turgor did not make (or a link to elsewhere)."""
    return os.path.lexists(path) and (os.path.islink(path) or not _is_made(path))


def _claim(path):
    if not _is_made(path):
        with open(_record(path), "a", encoding="utf-8") as file:
            file.write(os.path.basename(path) + "\n")


def _save(figure, path, *arguments, **options):
    """In the directory of a run the pictures get their names once all are drawn: one that is killed before leaves none, and may draw again."""
    clear_of_data(figure)
    if not isinstance(path, (str, os.PathLike)) or not os.path.exists(_record(os.fspath(path))):
        _savefig(figure, path, *arguments, **options)
        return
    path = os.fspath(path)
    part = path + ".part"
    if _is_somebodys(path) or _is_somebodys(part):
        print(f"{path} was not drawn by turgor; it is not replaced.", file=sys.stderr)
        return
    _claim(part)
    _savefig(figure, part, *arguments, **{"format": os.path.splitext(path)[1][1:], **options})
    if part not in _drawn:
        _drawn.append(part)


def _disclaim(path):
    """What has gone from the directory is no longer listed."""
    with open(_record(path), encoding="utf-8") as file:
        kept = [line for line in file.read().splitlines() if line != os.path.basename(path)]
    with open(_record(path) + ".new", "w", encoding="utf-8") as file:
        file.write("".join(line + "\n" for line in kept))
    os.replace(_record(path) + ".new", _record(path))


def _name_all():
    for part in _drawn:
        path = part.removesuffix(".part")
        _claim(path)
        os.replace(part, path)
        _disclaim(part)


_drawn = []
atexit.register(_name_all)
_savefig = plt.Figure.savefig
plt.Figure.savefig = _save

plt.rcParams["axes.formatter.useoffset"] = False  # not "+1.0566e3" above the axis

INK = "#22313f"
ACCENT = "#b5432e"
ALONG = "#3d6e99"
POINT = 6.0  # markersize of a point that is a value
NOISE = 1e-7  # what is below this share of the largest value beside it is rounding, or what a solver leaves


def read_table(path):
    """{column: array} of a CSV with one header line; rows that are not numbers throughout are left out."""
    with open(path, newline="", encoding="utf-8-sig") as file:  # a user's may begin with a byte-order mark and hold remarks
        rows = [row for row in csv.reader(file) if row and not row[0].lstrip().startswith("#")]
    if not rows:
        return {}
    values = []
    for row in rows[1:]:
        try:
            values.append([float(x) for x in row])
        except ValueError:
            continue
    data = np.array([v for v in values if len(v) == len(rows[0])]).reshape(-1, len(rows[0]))
    return {name.strip(): data[:, k] for k, name in enumerate(rows[0])}


def input_entries(directory):
    """{(subsection, name): text} of input.prm, where the run left one; outermost subsections only."""
    found, section = {}, []
    path = os.path.join(directory, "input.prm")
    if not os.path.exists(path):
        return found
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split("#")[0].strip()
            if words.startswith("subsection "):
                section.append(words[11:].strip())
            elif words == "end" and section:
                section.pop()
            elif words.startswith("set ") and "=" in words:
                name, value = words[4:].split("=", 1)
                found["/".join(section), name.strip()] = value.strip()
    return found


def input_is(directory, numbers):
    """Whether the run's input has these values: {(subsection, name): number}. Published results are drawn over runs of the published input only."""
    have = input_entries(directory)
    try:
        return all(abs(float(have[key]) - value) <= 1e-6 * abs(value) for key, value in numbers.items())
    except (KeyError, ValueError):
        return False


def pretty(unit):
    """As it is written beside an axis: \u00b5m\u00b2, not um^2."""
    for plain, printed in (("^2", "\u00b2"), ("^3", "\u00b3"), ("um", "\u00b5m"), ("us", "\u00b5s")):
        unit = unit.replace(plain, printed)
    return unit


def in_prefix(unit, values):
    """(factor, unit with an SI prefix) in which the largest of the values is a number from 1 to 1000: (1e6, "\u00b5m") for 3e-5 m; areas and
    volumes by their lengths. Times of an hour and more are told in hours. Units that take no prefix stay."""
    largest = max((float(np.nanmax(np.abs(v))) for v in values if np.any(np.isfinite(v))), default=0.0)
    if unit == "s" and largest >= 3600.0:
        return 1.0 / 3600.0, "h"
    if unit not in ("s", "m", "m^2", "m^3", "Pa", "N", "J", "N/m", "J/m", "m/s", "Hz", "J/m^3") or largest <= 0.0:
        return 1.0, pretty(unit)
    prefixes = {-15: "f", -12: "p", -9: "n", -6: "\u00b5", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
    dimension = int(unit[2:]) if unit.startswith("m^") else 1
    power = int(np.clip(3 * np.floor(np.log10(largest * 1.0001) / 3 / dimension), -15, 9))
    return 10.0 ** (-power * dimension), prefixes[power] + pretty(unit)


def of_one_scale(columns, spread=30.0):
    """Splits {name: values} into lists of names whose largest values are within a factor of each other, so that none is a line along zero
    only because another is large. Second: the names that are zero throughout."""
    size = {name: float(np.nanmax(np.abs(values))) for name, values in columns.items()}
    groups = []
    for name in sorted((name for name in columns if size[name] > 0.0), key=lambda name: -size[name]):
        if groups and size[groups[-1][0]] <= spread * size[name]:
            groups[-1].append(name)
        else:
            groups.append([name])
    order = list(columns)
    return [sorted(group, key=order.index) for group in groups], [name for name in columns if size[name] == 0.0]


def round_length(length):
    """The nearest 1, 2 or 5 times a power of ten below a length."""
    power = 10.0 ** np.floor(np.log10(length))
    return power * max(k for k in (1, 2, 5) if k * power <= length * 1.0001)


def scale_bar(axis, left, foot, width, unit="mm", gap=0.03):
    """A bar of about a third of `width` (in the unit of the axis) with its length beside it."""
    length = round_length(width / 3)
    axis.plot([left, left + length], [foot, foot], color=INK, linewidth=3, solid_capstyle="butt", clip_on=False)
    text = f"{length:g} {unit}" if length >= 0.1 or unit != "mm" else f"{1e3 * length:g} µm"
    axis.text(left + length + gap * width, foot, text, color=INK, fontsize=9, va="center")


def line_styles(count):
    """So many (colour, dash) that no two are alike: the ten usual colours, then the same dashed, then dotted."""
    colours = plt.rcParams["axes.prop_cycle"].by_key()["color"]
    dashes = ("-", (0, (5, 2)), (0, (1, 1.5)), (0, (5, 1, 1, 1)))
    return [(colours[k % len(colours)], dashes[k // len(colours) % len(dashes)]) for k in range(count)]


def has_history(directory, fields):
    """Whether the run wrote its fields and at least two rows of probe.csv, which a picture needs."""
    files = [os.path.join(directory, name) for name in ("probe.csv", fields)]
    return all(os.path.exists(file) for file in files) and len(read_table(files[0])["time [s]"]) >= 2


def style(axis):
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axis.spines[side].set_color(INK)
    axis.tick_params(colors=INK, labelsize=8)
    for one in (axis.xaxis, axis.yaxis):
        readable_log(one)


def beyond(norm, values):
    """At which ends of a colour scale values lie outside it: "neither", "min", "max" or "both"; there its bar is pointed."""
    return (("neither", "max"), ("min", "both"))[int(np.min(values) < norm.vmin)][int(np.max(values) > norm.vmax)]


def colour_bar(figure, place, norm, colours, label, values=None):
    """values: all that are drawn, where the scale does not hold them all."""
    bar = figure.colorbar(plt.cm.ScalarMappable(norm=norm, cmap=colours), cax=figure.add_axes(place),
                          orientation="horizontal", extend="neither" if values is None else beyond(norm, values))
    bar.formatter.set_useOffset(False)  # "1e-5+1.005" would stand on the label
    bar.locator = matplotlib.ticker.MaxNLocator(5)
    bar.update_ticks()
    bar.set_label(label, color=INK, fontsize=9)
    bar.ax.tick_params(labelsize=8, colors=INK)
    bar.outline.set_visible(False)


def plot_history(axis, table, now):
    """The probe's two displacements over time, with a line at the time `now` (s) of the picture."""
    t = table["time [s]"] * 1e3
    axis.axhline(0, color="#c8d0d6", linewidth=0.8)
    axis.plot(t, table["displacement_y [m]"] * 1e6, color=ACCENT, linewidth=2, label="down and up (y)")
    axis.plot(t, table["displacement_x [m]"] * 1e6, color=ALONG, linewidth=1.4, label="along (x)")
    axis.axvline(now * 1e3, color=INK, linewidth=0.9, linestyle=(0, (4, 3)))
    axis.set_xlim(0, t[-1])
    axis.set_xlabel("time [ms]", color=INK, fontsize=9)
    axis.set_ylabel("probe moves [µm]", color=INK, fontsize=9)
    axis.legend(frameon=False, fontsize=9, loc="best")
    style(axis)


def list_beside(figure, handles):
    """A legend in a column of its own at the right; call before the figure is drawn."""
    wide, _ = figure.get_size_inches()
    column = 0.6 + 0.068 * max(len(line) for handle in handles for line in handle.get_label().split("\n"))  # inches
    figure.set_figwidth(wide + column)
    figure.get_layout_engine().set(rect=(0, 0, wide / (wide + column), 1))
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(wide / (wide + column), 0.99), fontsize=8, frameon=False)


def number_points(axis, points, fontsize=7.5):
    """Writes a text beside each point (x, y, text, colour), where it covers no marker and no text written before.

    Limits and scales of the axis must be final. Crowded texts stand farther off, with a line to their point.
    """
    figure = axis.figure
    figure.canvas.draw()
    renderer, dot = figure.canvas.get_renderer(), figure.dpi / 72
    at = np.array([axis.transData.transform(point[:2]) for point in points]).reshape(-1, 2)
    taken = [(x - 4 * dot, y - 4 * dot, x + 4 * dot, y + 4 * dot) for x, y in at]
    inside = axis.get_window_extent(renderer)

    def overlap(a, b):
        return max(0, min(a[2], b[2]) - max(a[0], b[0])) * max(0, min(a[3], b[3]) - max(a[1], b[1]))

    for (x, y), (data_x, data_y, text, colour) in zip(at, points):
        label = axis.annotate(text, (data_x, data_y), xytext=(0, 0), textcoords="offset points", fontsize=fontsize,
                              color=colour, ha="center", va="center",
                              arrowprops=dict(arrowstyle="-", color=colour, linewidth=0.5, shrinkA=0, shrinkB=2))
        size = label.get_window_extent(renderer)
        wide, high = size.width / 2, size.height / 2

        def cost(place):
            box = (x + place[0] * dot - wide, y + place[1] * dot - high, x + place[0] * dot + wide, y + place[1] * dot + high)
            outside = max(0, inside.x0 - box[0]) + max(0, box[2] - inside.x1) + max(0, inside.y0 - box[1]) + max(0, box[3] - inside.y1)
            return sum(overlap(box, other) for other in taken) + 100 * outside, box

        places = [(r * np.cos(a), r * np.sin(a)) for r in (9, 14, 20, 27) for a in np.pi / 8 * np.arange(1, 17)]
        place = min(places, key=lambda one: (cost(one)[0], np.hypot(*one)))
        label.set_position(place)
        taken.append(cost(place)[1])
