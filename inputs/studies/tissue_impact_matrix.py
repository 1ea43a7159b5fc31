#!/usr/bin/python3
"""Compression, impact and failure of aggregates of cells (thesis 3.3.2, 3.3.3): every run of the comparison.

    /usr/bin/python3 inputs/studies/tissue_impact_matrix.py             all parts
    /usr/bin/python3 inputs/studies/tissue_impact_matrix.py failure     one part

Parts: compression (untied ends of walls from 0 to 24 um, that is, four void fractions; elastic or yielding walls), impact (viscosity
x 1, 10, 100, 1000; wall x 1, x 10; dense, sparse), failure (viscosity x 1, x 1000; dense, sparse; six tissues of each; slow; weak lamella).
Writes PART.csv (one row a run: all its results) and PART_curves.csv (strain, stress on both plates, depth of flattening, failed
cells) to doc/results/tissue_impact. tissue_impact_figures.py makes the pictures and the tables.
"""
import argparse
import csv
import os

from runs import study, table_row, write_table

# Moderate: 25 cells, the size at which the whole matrix takes minutes.
SIZE = {"Columns": "5", "Rows": "5", "Cell/Nodes per side": "12", "SPH/Particles per side": "10", "Checkpoints": "0"}
STRUCTURE = {"dense": {"Gap": "0"}, "sparse": {"Gap": "20e-6"}}
GAPS = (0, 8, 16, 24) # um: with 8.3 um from node to node no, one, two, three ties less at each end of a wall
SEEDS = (1, 2, 3, 4, 5, 6)
KEPT = ["strain [1]", "stress_upper [Pa]", "stress_lower [Pa]", "centre_of_flattening [1]", "failed_cells", "broken_ties"]


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


def curve(label, run):
    with open(os.path.join(run["directory"], "loading.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    # every fourth sample is plenty for a curve
    return [{"run": label, **{name: "%.6g" % float(row[name]) for name in KEPT}} for row in rows[::4]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", default=["compression", "impact", "failure"])
    parser.add_argument("--fields", action="store_true", help="with the fields that pictures of the cells need")
    options = parser.parse_args()
    for part in options.parts:
        entries = dict(SIZE, Frames="12" if options.fields else "0")
        rows = study("tissue_impact_" + part, ((label, "tissue_" + part, dict(entries, **own)) for label, own in runs(part)))
        write_table(f"tissue_impact/{part}.csv", [table_row(run) for run in rows.values()])
        write_table(f"tissue_impact/{part}_curves.csv", [point for label, run in rows.items() if run["status"] == "finished" for point in curve(label, run)])


if __name__ == "__main__":
    main()
