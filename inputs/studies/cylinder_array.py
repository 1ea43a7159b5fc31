"""Drag on a square array of cylinders against Sangani and Acrivos 1982 over seeds, and what the gap left at the cylinder and the settling do to it.

  python3 inputs/studies/cylinder_array.py        doc/results/stokes/cylinder_array.csv, about two minutes of CPU time

Five seeds of the packing, porosities 0.5, 0.75 and 0.95, 30 particles a period. A row: error of the drag in percent, mean over the seeds, the half width of its 95 %
band (Student's t), the least and the largest. Gap and settling steps one at a time off the scene's own, 0.05 spacings and 400 steps, both chosen after errors had been seen.
"""
import sys

from runs import no_choice, results, study, write_table

SEEDS, POROSITIES = range(1, 6), ("0.5", "0.75", "0.95")
VARIANTS = [(0.05, 400), (0, 400), (0.1, 400), (0.2, 400), (0.35, 400), (0.05, 0), (0.05, 100), (0.05, 1600)]
STUDENT = 2.776  # of five


def row_of(gap, steps, porosity, errors):
    mean = sum(errors) / len(errors)
    band = STUDENT * (sum((one - mean) ** 2 for one in errors) / (len(errors) - 1) / len(errors)) ** 0.5
    return {"gap dx": gap, "settling steps": steps, "porosity": porosity, "seeds": len(errors), "drag error %": f"{mean:.3f}", "95 % band %": f"{band:.3f}", "least %": f"{min(errors):.3f}", "largest %": f"{max(errors):.3f}"}


def main():
    no_choice(__doc__)
    label = "gap {:g} steps {:g} porosity {} seed {}".format
    runs = [(label(gap, steps, porosity, seed), "cylinder_array", {"Frames": 0, "Samples": 4, "End time": 0.02, "Porosity": porosity, "Gap": gap, "Packing/Settling steps": steps, "Packing/Seed": seed})
            for gap, steps in VARIANTS for porosity in POROSITIES for seed in SEEDS]
    rows = study("cylinder_array", runs)
    failed = [f"{name}: {row['message']}" for name, row in rows.items() if row["status"] != "finished"]
    for one in failed:
        print(one)
    write_table("stokes/cylinder_array.csv", [
        row_of(gap, steps, porosity, errors) for gap, steps in VARIANTS for porosity in POROSITIES
        if len(errors := [100 * results(row)["drag_error"] for seed in SEEDS if (row := rows[label(gap, steps, porosity, seed)])["status"] == "finished"]) > 1])
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
