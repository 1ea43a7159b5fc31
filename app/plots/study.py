"""Pictures of a study: error against run time with the Pareto front, and the probe's history of all methods.

  study.py DIR [REFERENCE_DIRECTORY]
reads DIR/error_vs_time.csv and DIR/runs.csv, writes error_vs_time.png and probe_history.png.
"""
import csv
import os
import sys

from matplotlib.ticker import LogLocator, NullFormatter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import number_points, plt, read_table  # noqa: E402

MARKERS = "osD^vP*X<>hp"


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def pareto(points):
    """The points that no other beats in both time and error, by time."""
    front, best = [], float("inf")
    for time, error in sorted(points):
        if error < best:
            front.append((time, error))
            best = error
    return front


def plot_errors(rows, directory):
    errors = {"error_history": "error of the probe's history", "error_field": "error of the final field"}
    times = {"cpu_time_s": "CPU time [s]", "wall_time_s": "wall time [s]"}
    methods = list(dict.fromkeys(row["method"] for row in rows))
    colour = {method: f"C{number % 10}" for number, method in enumerate(methods)}
    marker = {method: MARKERS[number % len(MARKERS)] for number, method in enumerate(methods)}
    # Numbered like the lines of the table of runs beside the panels; there is no room for settings at every point.
    numbered = list(enumerate(rows, 1))
    is_reference = {number: all(row[error] and float(row[error]) == 0 for error in errors) for number, row in numbered}
    figure, panels = plt.subplots(2, 2, figsize=(14, 8))
    figure.subplots_adjust(left=0.06, right=0.68, bottom=0.07, top=0.97, hspace=0.2, wspace=0.25)
    handles = []
    for line, (error, error_name) in enumerate(errors.items()):
        for place, (time, time_name) in enumerate(times.items()):
            panel = panels[line, place]
            shown = [(float(row[time]), float(row[error]), number, row["method"]) for number, row in numbered
                     if row[error] and row[time] and float(row[error]) > 0]
            for x, y, number, method in shown:
                panel.plot(x, y, marker[method], color=colour[method], markersize=5)
            if shown:
                panel.set_xscale("log")
                panel.set_yscale("log")
                panel.margins(0.1)
                panel.yaxis.set_major_locator(LogLocator(subs=(1, 2, 3, 5)))
                panel.yaxis.set_major_formatter("{x:g}")
                panel.yaxis.set_minor_formatter(NullFormatter())
            for number, row in numbered:
                if is_reference[number] and row[time]:
                    panel.axvline(float(row[time]), color="0.5", ls=":")
            panel.plot(*zip(*pareto([point[:2] for point in shown])) if shown else ([], []), color="0.6", lw=1, zorder=0)
            panel.set_xlabel(time_name)
            panel.set_ylabel(error_name + " (relative L2)")
            panel.grid(alpha=0.15, which="both")
    for number, row in numbered:
        method = row["method"]
        line_look = dict(color="0.5", ls=":") if is_reference[number] else \
            dict(color=colour[method], ls="", marker=marker[method])
        handles.append(plt.Line2D([], [], label=f"{number}  {method}: {row['settings']}", **line_look))
    handles.append(plt.Line2D([], [], color="0.6", lw=1, label="Pareto front"))
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.69, 0.98), fontsize=8, frameon=False)
    for line, error in enumerate(errors):
        for place, time in enumerate(times):
            number_points(panels[line, place], [(float(row[time]), float(row[error]), str(number), colour[row["method"]])
                                                for number, row in numbered
                                                if row[error] and row[time] and float(row[error]) > 0])
    figure.savefig(os.path.join(directory, "error_vs_time.png"), dpi=150, bbox_inches="tight")
    plt.close(figure)


def probe(directory):
    """Times (s) and displacements in x and y (m), or None where the run wrote none."""
    try:
        table = read_table(os.path.join(directory, "probe.csv"))
        return [next(column for name, column in table.items() if name.startswith(start))
                for start in ("time", "displacement_x", "displacement_y")]
    except (OSError, StopIteration):
        return None


def plot_histories(runs, reference, directory):
    figure, panels = plt.subplots(2, 1, figsize=(13, 7), sharex=True)
    figure.subplots_adjust(left=0.07, right=0.66, bottom=0.08, top=0.97, hspace=0.08)
    methods = list(dict.fromkeys(row["method"] for row in runs))
    styles, colours, drawn = ["-", "--", "-.", ":"], plt.get_cmap("tab20").colors, 0
    for row in runs:
        history = probe(row["directory"])
        if row["status"] != "finished" or history is None:
            continue
        is_reference = bool(reference) and os.path.abspath(row["directory"]) == os.path.abspath(reference)
        look = dict(color="k", lw=2.5, alpha=0.6, zorder=0) if is_reference else \
            dict(color=colours[drawn % 20], ls=styles[methods.index(row["method"]) % 4], lw=1.3)
        drawn += not is_reference
        for panel, values in zip(panels, history[1:]):
            panel.plot(1e3 * history[0], 1e6 * values, label=row["method"] + ": " + row["settings"], **look)
    for panel, name in zip(panels, "xy"):
        panel.set_ylabel(f"probe displacement {name} [um]")
        panel.grid(alpha=0.3)
    panels[1].set_xlabel("time [ms]")
    handles, labels = panels[0].get_legend_handles_labels()
    if handles:
        figure.legend(handles, labels, loc="upper left", bbox_to_anchor=(0.67, 0.98), fontsize=8,
                      frameon=False)
    figure.savefig(os.path.join(directory, "probe_history.png"), dpi=150)
    plt.close(figure)


def main(directory, reference=""):
    plot_errors(rows_of(os.path.join(directory, "error_vs_time.csv")), directory)
    plot_histories(rows_of(os.path.join(directory, "runs.csv")), reference, directory)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
