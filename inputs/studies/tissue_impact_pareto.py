#!/usr/bin/python3
"""Error against run time of `tissue_impact`: resolution x step x multirate on/off, each against the finest run.

    /usr/bin/python3 inputs/studies/tissue_impact_pareto.py -o doc/results/tissue_impact_pareto
    /usr/bin/python3 inputs/studies/tissue_impact_pareto.py -o DIR --plot      draw the picture of DIR/pareto.csv again

Errors, relative L2 over strain: of the force that reaches the far plate, as a mean over 1/40 of the run (what is faster
is ringing of single walls), and of where the tissue is flattened (centre of the flattening). One thread; CPU seconds of the whole
run, inflation included. The front: runs that no other beats in both.
"""
import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from drawing import ACCENT, ALONG, INK, number_points, read_table, style  # noqa: E402

# Three by three cells; water's own viscosity would leave the fluid's disorder undamped, which differs from resolution to
# resolution: 0.1 Pa s damps it and not the tissue (3.3.3: no influence up to x 100).
BASE = {"Columns": "3", "Rows": "3", "Cell/Fluid viscosity": "0.1", "End strain": "0.25", "Frames": "0", "Checkpoints": "0",
        "Samples": "2000"}
# fluid particles and wall nodes a side
RESOLUTIONS = [(6, 8), (8, 10), (10, 14), (12, 16), (16, 20)]
FRACTIONS = ["0.8", "0.4"]
SUBSTEPS = ["1", "2"]
REFERENCE = ((24, 28), "0.4", "1")
STRAINS = np.linspace(0.005, 0.245, 241)


def run(program, resolution, fraction, substeps):
    particles, nodes = resolution
    settings = dict(BASE, **{"SPH/Particles per side": particles, "Cell/Nodes per side": nodes, "Step fraction": fraction,
                             "Substeps": substeps})
    with tempfile.TemporaryDirectory() as directory:
        command = [program, "run", os.path.join(ROOT, "inputs", "tissue_impact.prm"), "-o", directory, "--quiet", "--threads", "1"]
        for name, value in settings.items():
            command += ["--set", "%s=%s" % (name, value)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, stdin=subprocess.DEVNULL)
        if done.returncode != 0:
            return None, done.stderr.strip().splitlines()[-1]
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        table = read_table(os.path.join(directory, "loading.csv"))
    strain = table["strain"]
    window = max(1, len(strain) // 40)
    force = np.convolve(table["stress_bottom [Pa]"], np.ones(window) / window, mode="same")
    curves = {"force": np.interp(STRAINS, strain, force), "centre": np.interp(STRAINS, strain, table["centre"])}
    results = summary["results"]
    return {"curves": curves, "cpu": summary["cpu_time_s"], "steps": results["steps"]["value"],
            "particles": results["particles"]["value"],
            "energy": results["energy_unaccounted"]["value"] / results["plate_work"]["value"]}, ""


def difference(curves, reference, name):
    return float(np.linalg.norm(curves[name] - reference[name]) / np.linalg.norm(reference[name]))


def study(program, directory):
    os.makedirs(directory, exist_ok=True)
    jobs = [(r, f, s) for r in RESOLUTIONS for f in FRACTIONS for s in SUBSTEPS]
    reference, why = run(program, *REFERENCE)
    if reference is None:
        raise SystemExit("the reference run failed: " + why)
    print("reference: %d particles, %.0f CPU s" % (reference["particles"], reference["cpu"]), flush=True)
    rows = []
    for done, (resolution, fraction, substeps) in enumerate(jobs):
        print("[%d/%d] %d particles a side, step fraction %s, substeps %s" % (done + 1, len(jobs), resolution[0], fraction,
              substeps), flush=True)
        answer, why = run(program, resolution, fraction, substeps)
        if answer is None:
            print("   failed: " + why, flush=True)
            continue
        rows.append({"particles_per_side": resolution[0], "nodes_per_side": resolution[1], "step_fraction": fraction,
                     "substeps": substeps, "particles": int(answer["particles"]), "steps": int(answer["steps"]),
                     "cpu_s": round(answer["cpu"], 2),
                     "force_error": "%.4f" % difference(answer["curves"], reference["curves"], "force"),
                     "centre_error": "%.4f" % difference(answer["curves"], reference["curves"], "centre"),
                     "energy_unaccounted_over_work": "%.4g" % answer["energy"]})
    with open(os.path.join(directory, "pareto.csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def front(points):
    """Indices of the points (time, error) that no other point beats in both, by time."""
    order = sorted(range(len(points)), key=lambda k: points[k])
    best, kept = float("inf"), []
    for k in order:
        if points[k][1] < best:
            best = points[k][1]
            kept.append(k)
    return kept


def plot(directory):
    with open(os.path.join(directory, "pareto.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    figure, panels = plt.subplots(1, 2, figsize=(12, 5), layout="constrained")
    for axis, (key, title) in zip(panels, (("force_error", "force on the far plate"), ("centre_error", "where the tissue is flattened"))):
        points = [(float(r["cpu_s"]), 100 * float(r[key])) for r in rows]
        for substeps, colour, label in (("1", ALONG, "one step for all"), ("2", ACCENT, "walls and lamella twice a step (r-RESPA)")):
            for fraction, marker in (("0.8", "o"), ("0.4", "s")):
                chosen = [p for p, r in zip(points, rows) if r["substeps"] == substeps and r["step_fraction"] == fraction]
                if chosen:
                    axis.plot(*zip(*chosen), marker, color=colour, markersize=7, markerfacecolor="none" if marker == "s" else colour,
                              label="%s, step fraction %s" % (label, fraction))
        kept = [points[k] for k in front(points)]
        axis.step(*zip(*kept), where="post", color=INK, linewidth=1, linestyle=(0, (4, 3)), label="front")
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.set_xlabel("CPU time [s]", color=INK)
        axis.set_ylabel("error against the finest run [%]", color=INK)
        axis.set_title(title, color=INK, fontsize=11)
        style(axis)
        number_points(axis, [(*p, r["particles_per_side"], INK) for p, r in zip(points, rows) if r["step_fraction"] == "0.8"
                             and r["substeps"] == "1"])
    panels[0].legend(frameon=False, fontsize=8)
    figure.suptitle("tissue_impact: error against run time (numbers: fluid particles along a cell side)", color=INK)
    path = os.path.join(directory, "pareto.png")
    figure.savefig(path, dpi=150)
    print(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--program", default=os.path.join(ROOT, "turgor"))
    parser.add_argument("--plot", action="store_true")
    options = parser.parse_args()
    if not options.plot:
        study(options.program, options.output)
    plot(options.output)


if __name__ == "__main__":
    main()
