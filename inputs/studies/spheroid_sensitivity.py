"""What the growth of a spheroid in a thin capsule is sensitive to: the thesis's statements (5.4.2, C.2, C.3), each as a measured yes or no.

  python3 inputs/studies/spheroid_sensitivity.py NAME

NAME: n, eps_tr, alpha_qui, growth_law, K, T_lys, timer, friction, W, D, seeds, calibration (each with the reference run), or all. Each is
a file of its own in inputs/studies/sensitivity: its runs, the statements (what the thesis says, the runs it needs, what has to hold for a
yes) and its panels of the picture.

A smaller capsule of the same H/R, R = 30 um and H = 2.4 um (the same pressure at the same strain), from confluence to 75 h after it: a
fortieth of the cells, each run with four seeds. Measured: dilatation (R - R_0)/R_0 at 24 and 48 h, its rate from 48 h to 75 h, number of
cells over the capsule's volume at 48 h over that at confluence (a section of so small a spheroid has a dozen cells). Statements are
judged by the means over the seeds, given with their standard errors. The runs' results go to doc/results/spheroid/sensitivity.csv,
the statements to statements.csv and, for all, the curves of the first seed to sensitivity.png beside it.
"""
import csv
import importlib
import json
import os
import sys

from runs import ROOT, choice, study, table_row, write_table

R_0 = 30e-6
SMALL = {"Capsule/Radius": R_0, "Capsule/Thickness": 2.4e-6, "Capsule/Time confined": 270000, "First cells": 30,
         "Frames": 0, "Checkpoints": 2}
SEEDS = (1, 2, 3, 4)
STUDIES = {name: importlib.import_module(f"sensitivity.{name}") for name in (
    "n", "eps_tr", "alpha_qui", "growth_law", "K", "T_lys", "timer", "friction", "W", "D", "seeds", "calibration")}


def at(t, times, values):
    """Linear interpolation."""
    for k in range(1, len(times)):
        if t <= times[k]:
            share = (t - times[k - 1]) / (times[k] - times[k - 1])
            return values[k - 1] + share * (values[k] - values[k - 1])
    return values[-1]


def slope(times, values):
    """Of the least squares line."""
    mean_t, mean_v = sum(times) / len(times), sum(values) / len(values)
    return sum((t - mean_t) * (v - mean_v) for t, v in zip(times, values)) / sum((t - mean_t)**2 for t in times)


def measure(place):
    """{name: number} of a run."""
    with open(os.path.join(place, "growth.csv"), encoding="utf-8") as file:
        rows = list(csv.reader(file))
    table = {name.split(" [")[0]: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}
    start = json.load(open(os.path.join(place, "summary.json"), encoding="utf-8"))["results"]["confluence_time"]["value"]
    hours = [(t - start) / 3600 for t in table["time"]]
    strain = [r / R_0 - 1 for r in table["capsule_radius"]]
    dense = [n / r**3 for n, r in zip(table["cells"], table["capsule_radius"])]
    late = [k for k, t in enumerate(hours) if t >= 48]
    return {"d24": at(24, hours, strain), "d48": at(48, hours, strain) if late else 0.,
            "rate": 24 * slope([hours[k] for k in late], [strain[k] for k in late]) if len(late) > 2 else 0.,  # 0: ended before
            "density": at(48, hours, dense) / at(0, hours, dense) if late else 0.}


def mean_of(runs):
    """{name: mean}, with the single runs as "each" and {name: standard error} as "error"."""
    n = len(runs)
    mean = {name: sum(run[name] for run in runs) / n for name in runs[0]}
    error = {name: (sum((run[name] - mean[name])**2 for run in runs) / (n * max(1, n - 1)))**0.5 for name in mean}
    return {**mean, "each": runs, "error": error}


def labels_of(label):
    return [label] + [f"{label}_seed_{seed}" for seed in SEEDS[1:]]


def draw_panels(places):
    sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
    from spheroid_variations import draw
    draw([(title, column, [(label, places[label]) for label in ("reference", *labels) if label in places]) for one in STUDIES.values() for title, column, labels in one.PANELS],
         os.path.join(ROOT, "doc", "results", "spheroid", "sensitivity.png"))


def main():
    chosen = choice(list(STUDIES) + ["all"], __doc__)
    chosen = list(STUDIES) if chosen == "all" else [chosen]
    variants = {"reference": {}}
    for name in chosen:
        variants.update(STUDIES[name].RUNS)
    runs = {name: {**SMALL, **entries, "Cell/Seed": seed} for label, entries in variants.items() for name, seed in zip(labels_of(label), SEEDS)}
    done = study("sensitivity", ((label, "spheroid_capsule", entries) for label, entries in runs.items()))
    single, rows = {}, []
    for label, run in done.items():
        rows.append(table_row(run))
        if run["status"] == "finished":
            single[label] = measure(run["directory"])
            rows[-1].update({"dilatation_24h": f"{single[label]['d24']:.4g}", "dilatation_48h_over_radius": f"{single[label]['d48']:.4g}",
                             "rate_per_day": f"{single[label]['rate']:.4g}", "density_48h_over_confluence": f"{single[label]['density']:.4g}"})
    write_table("spheroid/sensitivity.csv", rows)
    measured = {label: mean_of([single[name] for name in labels_of(label) if name in single]) for label in variants
                if any(name in single for name in labels_of(label))}
    if chosen == list(STUDIES):
        draw_panels({label: run["directory"] for label, run in done.items() if run["status"] == "finished"})
    verdicts = []
    for name in chosen:
        for statement, needed, holds in STUDIES[name].STATEMENTS:
            if not all(label in measured for label in needed):
                continue
            values = [measured[label] for label in needed]
            verdicts.append({"study": name, "statement": statement, "measured": "yes" if holds(*values) else "no",
                             "numbers": "; ".join(f"{label}" + (f" ({len(one['each'])} seeds)" if len(one["each"]) < len(SEEDS) else "") + ": " + ", ".join(f"{k} {one[k]:.3g} +- {v:.1g}" for k, v in one["error"].items())
                                                  for label, one in zip(needed, values))})
            print(verdicts[-1]["measured"], statement)
    if verdicts:
        write_table("spheroid/statements.csv", verdicts)


if __name__ == "__main__":
    main()
