"""Pictures of a study: error against run time with the Pareto front, and the probe's history of all methods.

  study.py DIR [REFERENCE_DIRECTORY]
reads DIR/error_vs_time.csv and DIR/runs.csv, writes error_vs_time.png and probe_history.png.
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

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
    figure, panels = plt.subplots(2, 2, figsize=(11, 8), layout="constrained")
    for line, (error, error_name) in enumerate(errors.items()):
        for place, (time, time_name) in enumerate(times.items()):
            panel, points = panels[line, place], []
            for number, method in enumerate(methods):
                mine = [(float(r[time]), float(r[error]), r["settings"]) for r in rows
                        if r["method"] == method and r[error] and r[time] and float(r[error]) > 0]
                if not mine:
                    continue
                panel.plot([m[0] for m in mine], [m[1] for m in mine], MARKERS[number % len(MARKERS)],
                           color=f"C{number % 10}", label=method)
                for x, y, settings in mine:
                    panel.annotate(settings, (x, y), xytext=(4, 4), textcoords="offset points", fontsize=6)
                points += [(m[0], m[1]) for m in mine]
            reference = [float(r[time]) for r in rows if r[error] and r[time] and float(r[error]) == 0]
            for x in reference:
                panel.axvline(x, color="0.5", ls=":", label="reference run")
            front = pareto(points)
            panel.plot([f[0] for f in front], [f[1] for f in front], color="0.3", lw=1, zorder=0, label="Pareto front")
            if points:
                panel.set_xscale("log")
                panel.set_yscale("log")
            panel.set_xlabel(time_name)
            panel.set_ylabel(error_name + " (relative L2)")
            panel.grid(alpha=0.3, which="both")
    panels[0, 0].legend(fontsize=7)
    figure.savefig(os.path.join(directory, "error_vs_time.png"), dpi=150)
    plt.close(figure)


def probe(directory):
    try:
        rows = rows_of(os.path.join(directory, "probe.csv"))
        value = lambda row, start: float(next(v for k, v in row.items() if k.startswith(start)))
        return [[value(row, name) for row in rows] for name in ("time", "displacement_x", "displacement_y")]
    except (OSError, StopIteration, ValueError):
        return None


def plot_histories(runs, reference, directory):
    figure, panels = plt.subplots(2, 1, figsize=(9, 7), sharex=True, layout="constrained")
    methods = list(dict.fromkeys(row["method"] for row in runs))
    styles, drawn = ["-", "--", "-.", ":"], {}
    for row in runs:
        history = probe(row["directory"])
        if row["status"] != "finished" or history is None:
            continue
        is_reference = bool(reference) and os.path.abspath(row["directory"]) == os.path.abspath(reference)
        number = drawn[row["method"]] = drawn.get(row["method"], -1) + 1
        look = dict(color="k", lw=2.5, alpha=0.6, zorder=0) if is_reference else \
            dict(color=f"C{methods.index(row['method']) % 10}", ls=styles[number % 4], lw=1.1)
        for panel, values in zip(panels, history[1:]):
            panel.plot([1e3 * t for t in history[0]], [1e6 * u for u in values], label=row["method"] + " " + row["settings"], **look)
    for panel, name in zip(panels, "xy"):
        panel.set_ylabel(f"probe displacement {name} [um]")
        panel.grid(alpha=0.3)
    panels[1].set_xlabel("time [ms]")
    if drawn:
        panels[0].legend(fontsize=6, ncols=2)
    figure.savefig(os.path.join(directory, "probe_history.png"), dpi=150)
    plt.close(figure)


def main(directory, reference=""):
    plot_errors(rows_of(os.path.join(directory, "error_vs_time.csv")), directory)
    plot_histories(rows_of(os.path.join(directory, "runs.csv")), reference, directory)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
