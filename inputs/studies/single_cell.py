"""Tables of the single-cell scenes: each named study is a list of runs whose results make the rows of one CSV.

  python3 inputs/studies/single_cell.py NAME [--program build/app/turgor] [--directory runs] [--only-table]

NAME: laplace_convergence, laplace_support, laplace_ordering, shell_modes, impact_matrix, failure, compression_2d. Runs that are
finished in the directory are not repeated. The table goes to doc/results/single_cell/NAME.csv.
"""
import argparse
import csv
import json
import os
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
FLAT = {"Dimension": 2, "Cell/Radius": 50e-6, "Cell/Wall thickness": 1e-6, "Cell/Wall density": 1300,
        "Cell/Anneal steps": 3000}


def laplace_convergence():
    for nodes, fluid in ((36, 60), (50, 121), (71, 242), (100, 484), (141, 968), (200, 1936)):
        yield f"2D_{nodes}", "laplace", {**FLAT, "Cell/Ring nodes": nodes, "Cell/Fluid particles": fluid,
                                         "Cell/Anneal steps": 30 * nodes}
    for nu, fluid in ((4, 120), (6, 390), (8, 930), (10, 1820)):
        yield f"3D_{nu}", "laplace", {"Cell/Frequency": nu, "Cell/Fluid particles": fluid, "Cell/Anneal steps": 200 * nu}


def laplace_support():
    for ratio in (2.0, 2.2, 2.4, 2.6, 3.0, 3.4):
        yield f"2D_{ratio}", "laplace", {**FLAT, "Cell/Fluid particles": 484, "Cell/Support ratio": ratio}


def laplace_ordering():
    for ordering in (0, 0.001, 0.003, 0.01, 0.03):
        yield f"2D_{ordering}", "laplace", {**FLAT, "Cell/Fluid particles": 484, "Cell/Ordering": ordering}


def shell_modes():
    for nu in (4, 6, 8, 12):
        yield f"empty_{nu}", "shell_oscillation", {"Filled": "false", "Cell/Frequency": nu, "Samples per period": 200}
    for c in (50, 250):
        for nu, fluid in ((6, 390), (8, 930)):
            yield f"c{c}_{nu}", "shell_oscillation", {"Sound speed": c, "Cell/Frequency": nu, "Cell/Fluid particles": fluid,
                                                          "Cell/Anneal steps": 1500}


def impact_matrix():
    for stiffness in (100, 1000):
        for viscosity in (1e-3, 1e-2, 1e-1, 1):
            yield f"G{stiffness}_mu{viscosity}", "cell_impact", {
                "Cell/Frequency": 6, "Cell/Fluid particles": 600, "Cell/Anneal steps": 1500, "Frames": 6,
                "Cell/Wall stiffness": stiffness, "Cell/Fluid viscosity": viscosity}


def failure():
    size = {"Cell/Frequency": 6, "Cell/Fluid particles": 600, "Cell/Anneal steps": 1500, "Frames": 8}
    slow = {"Speed": 0.5, "Both plates move": "true", "Damping": 2e5, "Cell/Wall density": 32500}
    for stretch in (1.03, 1.05):
        yield f"slow_{stretch}", "cell_failure", {**size, **slow, "Critical stretch": stretch}
        for viscosity in (1e-3, 1):
            yield f"impact_{stretch}_mu{viscosity}", "cell_failure", {**size, "Critical stretch": stretch,
                                                                      "Cell/Fluid viscosity": viscosity}


def compression_2d():
    for drop in (0, 0.9):
        for fluid in ("pressure", "sph"):
            yield f"B{drop}_{fluid}", "cell_compression", {
                **FLAT, "Cell/Fluid particles": 484, "Cell/Yield drop": drop, "Cell/Fluid": fluid, "Frames": 6,
                "Cell/Wall density": 32500}


STUDIES = {f.__name__: f for f in (laplace_convergence, laplace_support, laplace_ordering, shell_modes, impact_matrix, failure,
                                   compression_2d)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", choices=sorted(STUDIES))
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "app", "turgor"))
    parser.add_argument("--directory", default="runs")
    parser.add_argument("--only-table", action="store_true", help="of the runs that are there")
    options = parser.parse_args()
    rows, columns = [], ["run", "cpu_time_s"]
    for label, scene, entries in STUDIES[options.study]():
        place = os.path.join(options.directory, options.study, label)
        summary = os.path.join(place, "summary.json")
        finished = os.path.exists(summary) and json.load(open(summary, encoding="utf-8"))["status"] == "finished"
        if not finished:
            if options.only_table:
                continue
            command = [options.program, "run", os.path.join(ROOT, "inputs", scene + ".prm"), "-o", place, "--quiet"]
            for name, value in entries.items():
                command += ["--set", f"{name}={value}"]
            done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
            if done.returncode != 0:
                rows.append({"run": label, "failed": (done.stdout + done.stderr).strip().splitlines()[-1]})
                columns += [name for name in ("failed",) if name not in columns]
                continue
        result = json.load(open(summary, encoding="utf-8"))
        row = {"run": label, "cpu_time_s": result["cpu_time_s"]}
        for name, entry in result["results"].items():
            column = f"{name} [{entry['unit']}]" if entry["unit"] else name
            row[column] = f"{entry['value']:.6g}"
            columns += [column] if column not in columns else []
        rows.append(row)
        print(label, flush=True)
    folder = os.path.join(ROOT, "doc", "results", "single_cell")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, options.study + ".csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
