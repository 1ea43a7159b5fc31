#!/usr/bin/python3
"""Where the scenes with aggregates between plates break: each axis driven from its reference until a run ends with a sentence.

    /usr/bin/python3 inputs/studies/tissue_boundary.py -o doc/results/tissue_impact

Six small cells (2 x 3, 32 wall nodes, 36 fluid particles each), tissue_impact and tissue_failure (critical stretch 1.1), dense and
sparse. Adds to DIR/boundary.csv (a row that is there already is kept): axis, value, scene, status, energy balance error, crossed bonds, failed cells, CPU time.
"""
import argparse
import csv
import json
import os
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SMALL = {"Columns": "2", "Rows": "3", "Cell/Nodes per side": "8", "SPH/Particles per side": "6", "Inflation time": "20e-6", "Frames": "0",
         "Checkpoints": "0", "Samples": "200", "End strain": "0.3"}
AXES = {"Speed": ["1", "5", "10", "20", "40", "80"],
        "End strain": ["0.3", "0.5", "0.7", "0.85"],
        "Cell/Wall stiffness": ["20", "50", "100", "1e3", "1e4"],
        "Cell/Fluid viscosity": ["0", "1e-3", "1e-1", "1", "10"]}
SCENES = [("tissue_impact", "0"), ("tissue_impact", "20e-6"), ("tissue_failure", "0"), ("tissue_failure", "20e-6")]


def run(program, scene, settings, most):
    with tempfile.TemporaryDirectory() as directory:
        command = [program, "run", os.path.join(ROOT, "inputs", scene + ".prm"), "-o", directory, "--quiet", "--threads", "1"]
        for name, value in dict(SMALL, **settings).items():
            command += ["--set", "%s=%s" % (name, value)]
        try:
            done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, stdin=subprocess.DEVNULL, timeout=most)
        except subprocess.TimeoutExpired:
            return {"status": "not finished in %g s" % most}
        if done.returncode != 0:
            said = [line for line in done.stderr.splitlines() if line.startswith("turgor:")]
            return {"status": said[0] if said else "exit %d" % done.returncode}
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        results = {name: entry["value"] for name, entry in summary["results"].items()}
        return {"status": "finished", "energy_balance_error": "%.2g" % results["energy_balance_error"], "crossed_bonds": "%g" % results["crossed_bonds"],
                "failed_cells": "%g" % results.get("failed_cells", 0), "cpu_time": "%.2f" % summary["cpu_time_s"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="tissue_impact")
    parser.add_argument("--program", default=os.path.join(ROOT, "turgor"))
    parser.add_argument("--most", type=float, default=300, help="seconds a run may take")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    names = ["axis", "value", "scene", "gap", "status", "energy_balance_error", "crossed_bonds", "failed_cells", "cpu_time"]
    path = os.path.join(options.output, "boundary.csv")
    rows = []
    if os.path.exists(path):
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    there = {(r["axis"], r["value"], r["scene"], r["gap"]) for r in rows}
    for axis, values in AXES.items():
        for scene, gap in SCENES:
            for value in values:
                if (axis, value, scene, gap) in there:
                    continue
                rows.append(dict(run(options.program, scene, {"Gap": gap, axis: value}, options.most), axis=axis, value=value, scene=scene, gap=gap))
                with open(path, "w", newline="", encoding="utf-8") as file:
                    writer = csv.DictWriter(file, names, lineterminator="\n", restval="")
                    writer.writeheader()
                    writer.writerows(rows)


if __name__ == "__main__":
    main()
