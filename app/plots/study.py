"""Pictures of a study: error against run time, results over the swept values, curves of all runs.

  study.py DIR
reads DIR/study.json, results.csv and error_vs_time.csv (app/study_tables.h), writes error_vs_time.png (measures with a
reference), sweep.png or sweep_ENTRY.png (swept entries) and curves.png (measured columns of tables).
"""
import json
import math
import os
import sys
import textwrap
from fnmatch import fnmatchcase

from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullFormatter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import INK, NOISE, POINT, in_prefix, list_beside, number_points, plt, style  # noqa: E402
from legible import log_text  # noqa: E402
from study_curves import plot_curves  # noqa: E402
from study_tables import number, point_of, rows_of, same_runs, settings_of  # noqa: E402
from units import bare, unit_of  # noqa: E402

MARKERS = "osD^vP*X<>hp"
MOST = 12  # panels of what a study did not choose: more are not legible
COLOURS = plt.get_cmap("tab10").colors


def pareto(points):
    """The points that no other beats in both time and error, by time."""
    front, best = [], float("inf")
    for time, error in sorted(points):
        if error < best:
            front.append((time, error))
            best = error
    return front


def title_of(measure):
    """What is measured, in words: as the study calls it, else its columns or its result, and how a course became one number."""
    if measure.get("title"):
        return measure["title"]
    words = ", ".join(column.replace("_", " ") for column in measure["columns"])
    words = measure["name"] if words == measure["name"] else f"{measure['name']}: {words}"
    return words + (f" ({measure['weight']})" if measure["weight"] not in ("", measure["name"]) else "")


def plot_errors(rows, info, directory, same):
    """A panel for each measure: its error against CPU time, runs numbered as in the list beside; false without errors. A run that answers
    another question than the references is no point of it."""
    places = {row["run"]: place for place, row in enumerate(rows, 1)}
    rows = [row for row in rows if row["run"] not in info.get("not_compared", [])]
    measures = [one for one in info["measures"] if any(number(row.get("error_" + one["name"])) for row in rows)]
    if not measures:
        return False
    lines = {label: group for entry in info["entries"] for label, group in lines_of(rows, entry, info["entries"]).items()}
    line_of = {row["run"]: label for label, group in lines.items() for row in group}
    kinds = list(dict.fromkeys(line_of.get(row["run"], row["method"]) for row in rows))
    looks = {kind: dict(color=COLOURS[k % 10], marker=MARKERS[k % len(MARKERS)]) for k, kind in enumerate(kinds)}
    look = {row["run"]: looks[line_of.get(row["run"], row["method"])] for row in rows}
    columns = min(len(measures), 2)
    down = -(-len(measures) // columns)
    figure, panels = plt.subplots(down, columns, figsize=(5.2 * columns, max(4.2 * down, 0.21 * len(rows) + 1)), squeeze=False,
                                  layout="constrained")
    for panel in panels.ravel()[len(measures):]:
        panel.axis("off")
    drawn, fronts, alike, below = [], False, False, False
    for panel, measure in zip(panels.ravel(), measures):
        column, shown = "error_" + measure["name"], []
        percent = 100 if measure["relative"] else 1
        for row in rows:
            time, error = number(row["cpu_time_s"]), number(row.get(column))
            if time and error == 0:  # a logarithmic axis has no place for it
                itself = row["run"] == measure["reference"]
                panel.axvline(time, **(dict(color="0.5", ls=":") if itself else dict(color=look[row["run"]]["color"], ls="-.", lw=0.8)))
                alike = alike or not itself
            elif time and error:
                error *= percent
                shown.append((time, abs(error), str(places[row["run"]]), look[row["run"]]["color"]))
                panel.plot(time, abs(error), markersize=POINT, ls="", **look[row["run"]], **({"markerfacecolor": "white"} if error < 0 else {}))
                below = below or error < 0
        front = pareto([point[:2] for point in shown])
        # A reference that is the fastest of all: what the others differ in is no price for coming closer.
        if len(front) > 1 and not any(number(row.get(column)) == 0 and (number(row["cpu_time_s"]) or 0) <= front[0][0] for row in rows):
            panel.plot(*zip(*front), color="0.75", lw=3, zorder=0)
            fronts = True
        for label, group in lines.items():
            points = [(number(row["cpu_time_s"]), percent * abs(number(row[column]))) for row in group if number(row["cpu_time_s"]) and number(row.get(column))]
            panel.plot(*zip(*points) if points else ([], []), color=looks[label]["color"], lw=0.8)
        panel.set_xscale("log")
        panel.set_yscale("log")
        panel.margins(0.12)
        low, high = min((point[1] for point in shown), default=0), max((point[1] for point in shown), default=0)
        if 0 < low and high < 4 * low:  # errors that are nearly alike look alike
            panel.set_ylim(0.4 * math.sqrt(low * high), 2.5 * math.sqrt(low * high))
        unit = next((f" [{unit_of(name)}]" for name in rows[0] if bare(name) == measure["value"] and unit_of(name)), "")
        panel.set_title("\n".join(textwrap.wrap(f"{title_of(measure)}, against {measure['reference']}", 62)), fontsize=10, color=INK)
        panel.set_xlabel("CPU time of the run [s]", color=INK)
        panel.set_ylabel(f"size of the relative error of {measure['name']} [%]" if measure["relative"] else f"size of the error of {measure['name']}{unit}", color=INK)
        panel.grid(alpha=0.15, which="both")
        style(panel)
        drawn.append((panel, shown))
    handles = []
    for row in rows:
        again = same.get(row["run"])
        reference = any(one["reference"] == row["run"] for one in measures)
        handles.append(plt.Line2D([], [], label=f"{places[row['run']]}  {row['method']}  {settings_of(row, info['entries'])}" + " (reference)" * reference +
                                  (f" (the same run as {again})" if again else ""),
                                  **(dict(color="0.5", ls=":") if reference else dict(look[row["run"]], ls=""))))
    if alike:
        handles.append(plt.Line2D([], [], color="0.5", ls="-.", lw=0.8, label="line in a run's colour: no difference to the reference"))
    if below:
        handles.append(plt.Line2D([], [], color="0.5", marker="o", ls="", markerfacecolor="white", label="hollow: less than the reference"))
    if fronts:
        handles.append(plt.Line2D([], [], color="0.75", lw=3, label="no other numbered run is both faster and\ncloser to the reference, itself left out"))
    list_beside(figure, handles)
    figure.canvas.draw()
    figure.set_layout_engine("none")
    for panel, shown in drawn:
        number_points(panel, shown)
    figure.savefig(os.path.join(directory, "error_vs_time.png"), dpi=150)
    plt.close(figure)
    return True


def values_of(rows, column):
    return [value for value in (number(row.get(column)) for row in rows) if value is not None]


def varies(rows, column, columns=()):
    """By so much that the six digits of the tables tell a course, and that it is no rounding beside the other results (`columns`) of its unit."""
    values = values_of(rows, column)
    if len(values) < 2 or max(values) - min(values) <= 1e-4 * max(map(abs, values)):
        return False
    if unit_of(column) in ("", "1"):
        return True
    return max(map(abs, values)) > NOISE * max(abs(value) for other in {column, *columns} if unit_of(other) == unit_of(column) for value in values_of(rows, other))


def in_order(columns, defined):
    """Cost and measures, then results as the scenes define them; * in a name stands for any word."""
    return sorted(columns, key=lambda column: next((k for k, name in enumerate(defined) if fnmatchcase(bare(column), name)), -1))


def panels_of(info, columns, rows):
    """Lists of columns, one a panel: what the study chose, or those that vary, at most MOST, in the order of their definition; and what is left out."""
    if info["draw"] == "all":
        found = in_order([column for column in columns if varies(rows, column, columns)], info["results"])
        shown = [column for column in found if column != "cpu_time_s"]
        kept = shown[:MOST - 1] + ["cpu_time_s"] * ("cpu_time_s" in found)
        return [[column] for column in kept], [bare(column) for column in found if column not in kept]
    known = {bare(column): column for column in columns}
    known |= {one["name"]: known[one["value"]] for one in info.get("measures", []) if one.get("value") in known}
    for name in (name for panel in info["draw"] for name in panel):
        if name not in known:
            sys.exit(f"'Draw' names '{name}', which is no result of the runs. Known: {', '.join(known)}.")
    return [[known[name] for name in panel] for panel in info["draw"]], []


def lines_of(rows, entry, entries):
    """{label: rows} of the runs whose first swept entry this is: one line for each method and value of what changes apart from it."""
    here = [row for row in rows if row.get(entry) and not any(row.get(other) for other in entries[:entries.index(entry)])]
    apart = [other for other in entries if other != entry and
             len({(row["method"], row[entry], row.get(other)) for row in here}) > len({(row["method"], row[entry]) for row in here})]
    lines = {}
    for row in here:
        label = ", ".join([row["method"]] + [point_of(row, other) for other in apart if row.get(other)])
        lines.setdefault(label, []).append(row)
    return lines


def decades(least, most):
    """Powers of ten from least to most, at most six."""
    first, last = math.ceil(math.log10(least) - 1e-9), math.floor(math.log10(most) + 1e-9)
    return [10.0 ** k for k in range(first, last + 1, 1 + (last - first) // 6)]


def draw_panel(panel, lines, entry, columns, looks):
    texts = list(dict.fromkeys(row[entry] for rows in lines.values() for row in rows))
    numeric = all(number(text) is not None for text in texts)
    place = {text: number(text) if numeric else k for k, text in enumerate(texts)}
    values = []
    factor, unit = in_prefix(unit_of(columns[0]), [[number(row[column]) for rows in lines.values() for row in rows if number(row.get(column)) is not None]
                                                   for column in columns])
    for label, rows in lines.items():
        for k, column in enumerate(columns):
            size = abs if column.startswith("error_") else float
            points = sorted((place[row[entry]], factor * size(number(row[column]))) for row in rows if number(row.get(column)) is not None)
            if points:
                ls = ("-", "--", ":", "-.")[k % 4] if numeric or len(columns) > 1 else ""  # nothing is between words
                panel.plot(*zip(*points), ls=ls, markersize=POINT, lw=1.2, **looks[label])
                values += [y for _, y in points]
        for row in rows:
            if row["status"] == "failed":
                panel.plot(place[row[entry]], 0.02, "x", color=INK, transform=panel.get_xaxis_transform())
    positions = list(place.values())
    if not numeric:
        panel.set_xlim(min(positions) - 0.3, max(positions) + 0.3)
        panel.set_xticks(positions, texts, rotation=90 if len(texts) > 8 else 30, ha="center" if len(texts) > 8 else "right", fontsize=7 if len(texts) <= 8 else 6)
    elif min(positions) >= 0 and max(positions) > 12 * (least := min(x for x in positions if x > 0)):
        if min(positions) > 0:
            panel.set_xscale("log")
        else:  # zero stands one decade below the least
            panel.set_xscale("symlog", linthresh=least, linscale=0.5)
            panel.xaxis.set_major_locator(FixedLocator([0.0] + decades(least, max(positions))))
            panel.xaxis.set_major_formatter(FuncFormatter(lambda x, _: log_text(x)))
            panel.xaxis.set_minor_formatter(NullFormatter())
    else:
        panel.xaxis.set_major_locator(MaxNLocator(4))
        panel.ticklabel_format(axis="x", style="sci", scilimits=(-3, 4), useMathText=True)
    if values and min(values) > 0 and max(values) / min(values) > (5 if columns[0].startswith("error_") else 50):
        panel.set_yscale("log")
    panel.set_xlabel(entry, fontsize=8, color=INK)
    shown = [f"size of {column}" if column.startswith("error_") else "CPU time [s]" if column == "cpu_time_s" else bare(column) for column in columns]
    shown = [name.replace("_", " ") for name in shown]
    names = ",\n".join(f"{name} ({dash})" for name, dash in zip(shown, ("solid", "dashed", "dotted", "dash-dotted"))) if len(shown) > 1 else shown[0]
    panel.set_ylabel(names + (f" [{unit}]" if unit not in ("", "1") else ""), fontsize=8, color=INK)
    panel.grid(alpha=0.15)
    style(panel)


def plot_sweeps(results, errors, info, directory):
    entries = info["entries"]
    measured = {row["run"]: row for row in errors}
    rows = [{**measured.get(row["run"], {}), **row} for row in results]
    known = ["run", "method", "settings", "status", "threads", "directory", "message", "wall_time_s", "peak_memory_bytes", *entries]
    columns = [column for column in dict.fromkeys(name for row in rows for name in row) if column not in known]
    columns = [column for column in columns if any(number(row.get(column)) is not None for row in rows)]
    panels, left_out = panels_of(info, columns, [row for row in rows if any(row.get(entry) for entry in entries)]) if entries else ([], [])
    groups = [(entry, lines) for entry in entries if (lines := lines_of(rows, entry, entries))]
    if not panels or not groups:
        return
    pictures = [(None, groups)] if len(groups) * len(panels) <= 16 else [(entry, [(entry, lines)]) for entry, lines in groups]
    for name, shown in pictures:
        labels = list(dict.fromkeys(label for _, lines in shown for label in lines))
        looks = {label: dict(color=COLOURS[k % 10], marker=MARKERS[k % len(MARKERS)]) for k, label in enumerate(labels)}
        count = len(shown) * len(panels)
        across = min(4, count)
        down = -(-count // across)
        figure, grid = plt.subplots(down, across, figsize=(3.6 * across + (0 if across > 1 else 1.5), 2.9 * down + 0.6), squeeze=False,
                                    layout="constrained")
        for panel in grid.ravel()[count:]:
            panel.axis("off")
        for k, panel in enumerate(grid.ravel()[:count]):
            entry, lines = shown[k // len(panels)]
            draw_panel(panel, lines, entry, panels[k % len(panels)], looks)
        handles = [plt.Line2D([], [], label=label, **looks[label]) for label in labels] if len(labels) > 1 else []
        if any(row["status"] == "failed" for _, lines in shown for group in lines.values() for row in group):
            handles.append(plt.Line2D([], [], color=INK, marker="x", ls="", label="the run failed"))
        if handles:
            list_beside(figure, handles)
        stem = "sweep" if name is None else "sweep_" + "".join(c if c.isalnum() else "_" for c in bare(name))
        if left_out:
            words = f"{len(left_out)} more results vary ('Draw' of the study chooses; results.csv has all): " + ", ".join(left_out)
            figure.text(0.01, -0.01, "\n".join(textwrap.wrap(words, 55 * across)), fontsize=7, color=INK, va="top")
        figure.savefig(os.path.join(directory, stem + ".png"), dpi=130, bbox_inches="tight")
        plt.close(figure)


def main(directory):
    with open(os.path.join(directory, "study.json"), encoding="utf-8") as file:
        info = json.load(file)
    results, errors = rows_of(directory, "results.csv", info), rows_of(directory, "error_vs_time.csv", info)
    plot_errors(errors, info, directory, same_runs(results))
    plot_sweeps(results, errors, info, directory)
    plot_curves(results, info, directory)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
