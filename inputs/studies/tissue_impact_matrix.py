#!/usr/bin/python3
"""Compression, impact and failure of aggregates of cells (thesis 3.3.2, 3.3.3): every run of the comparison.

    /usr/bin/python3 inputs/studies/tissue_impact_matrix.py -o doc/results/tissue_impact             all parts
    /usr/bin/python3 inputs/studies/tissue_impact_matrix.py -o doc/results/tissue_impact failure     one part

Parts: compression (untied ends of walls from 0 to 24 um, that is, four void fractions; elastic or yielding walls), impact (viscosity
x 1, 10, 100, 1000; wall x 1, x 10; dense, sparse), failure (viscosity x 1, x 1000; dense, sparse; six tissues of each; slow; weak lamella).
Writes DIR/PART.csv (one row a run: all its results) and DIR/PART_curves.csv (strain, stress on both plates, depth of flattening, failed
cells). Runs go on side by side with --jobs; a row that is there already is kept. tissue_impact_figures.py makes the pictures and the tables.
"""
import argparse
import concurrent.futures
import csv
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Moderate: 25 cells, the size at which the whole matrix takes minutes.
SIZE = {"Columns": "5", "Rows": "5", "Cell/Nodes per side": "12", "SPH/Particles per side": "10", "Inflation time": "40e-6",
        "Frames": "0", "Checkpoints": "0"}
STRUCTURE = {"dense": {"Gap": "0"}, "sparse": {"Gap": "20e-6"}}
GAPS = (0, 8, 16, 24) # um: with 8.3 um from node to node no, one, two, three ties less at each end of a wall
SEEDS = (1, 2, 3, 4, 5, 6)
KEPT = ["strain", "stress_top [Pa]", "stress_bottom [Pa]", "centre", "failed_cells", "broken_ties"]


def runs(part):
    """(label, settings) of every run."""
    if part == "compression":
        for gap in GAPS:
            yield "gap %d um, yielding" % gap, {"Gap": "%ge-6" % gap, "Yielding": "plastic"}
        for gap in (0, 16):
            yield "gap %d um, elastic" % gap, {"Gap": "%ge-6" % gap, "Yielding": "none"}
        for gap in GAPS: # cheap
            yield "9 cells at 2 m/s, gap %d um, yielding" % gap, {"Gap": "%ge-6" % gap, "Yielding": "plastic", "Columns": "3", "Rows": "3", "Speed": "2"}
        return
    for structure, gap in STRUCTURE.items():
        if part == "impact":
            for wall in (1, 10):
                for viscosity in (1, 10, 100, 1000):
                    yield ("%s, wall x %d, viscosity x %d" % (structure, wall, viscosity),
                           dict(gap, **{"Cell/Wall stiffness": "%g" % (100 * wall), "Cell/Fluid viscosity": "%g" % (1e-3 * viscosity)}))
        else:
            for viscosity in (1, 1000):
                fluid = dict(gap, **{"Cell/Fluid viscosity": "%g" % (1e-3 * viscosity)})
                for seed in SEEDS:
                    yield "%s, viscosity x %d, tissue %d" % (structure, viscosity, seed), dict(fluid, **{"Tissue seed": "%d" % seed})
                yield "%s, viscosity x %d, weak lamella" % (structure, viscosity), dict(fluid, **{"Lamella strength": "2.5e6"})
            yield "%s, slow" % structure, dict(gap, Speed="1", Damping="2e4")


def run(program, part, label, settings, keep):
    with tempfile.TemporaryDirectory() as directory:
        if keep:
            directory, settings = os.path.join(keep, part, re.sub("[^a-z0-9]+", "_", label)), dict(settings, Frames="12")
        command = [program, "run", os.path.join(ROOT, "inputs", "tissue_%s.prm" % part), "-o", directory, "--quiet", "--threads", "1"]
        for name, value in dict(SIZE, **settings).items():
            command += ["--set", "%s=%s" % (name, value)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, stdin=subprocess.DEVNULL)
        if done.returncode != 0: # a run that failed is a result: its sentence goes into the table
            said = [line for line in done.stderr.splitlines() if line.startswith("turgor:")]
            return {"run": label, "status": said[0] if said else "failed"}, []
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        with open(os.path.join(directory, "loading.csv"), encoding="utf-8") as file:
            curve = [[label] + [row[k] for k in KEPT] for row in csv.DictReader(file)]
    row = {"run": label, "status": summary["status"], "cpu_time": summary["cpu_time_s"]}
    row.update({name: entry["value"] for name, entry in summary["results"].items()})
    return row, curve


def read(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def study(program, part, directory, jobs, only, keep):
    table, curves = os.path.join(directory, part + ".csv"), os.path.join(directory, part + "_curves.csv")
    wanted = list(runs(part))
    rows = {row["run"]: row for row in read(table)}
    points = {}
    for point in read(curves):
        points.setdefault(point["run"], []).append([point[k] for k in ["run"] + KEPT])
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        waiting = [pool.submit(run, program, part, *one, keep) for one in wanted if one[0] not in rows and re.search(only, one[0])]
        for done in concurrent.futures.as_completed(waiting):
            row, curve = done.result()
            rows[row["run"]], points[row["run"]] = row, curve[::4] # every fourth sample is plenty for a curve
            print(row["run"] + " done", file=sys.stderr, flush=True)
            order = [label for label, _ in wanted if label in rows]
            names = []
            for label in order:
                names += [name for name in rows[label] if name not in names]
            with open(table, "w", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, names, lineterminator="\n", restval="")
                writer.writeheader()
                writer.writerows(rows[label] for label in order)
            with open(curves, "w", newline="", encoding="utf-8") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(["run"] + KEPT)
                for label in order:
                    writer.writerows([p[0]] + ["%.6g" % float(x) for x in p[1:]] for p in points.get(label, []))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", default=["compression", "impact", "failure"])
    parser.add_argument("-o", "--output", default="tissue_impact")
    parser.add_argument("--program", default=os.path.join(ROOT, "turgor"))
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", default="", help="regular expression: runs with another label are left for later")
    parser.add_argument("--keep", default="", help="directory in which the runs stay, with fields for pictures")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    for part in options.parts:
        study(options.program, part, options.output, options.jobs, options.only, options.keep)


if __name__ == "__main__":
    main()
