"""Stability of stepping of centre-based cells: longest stable steps and errors under five disturbances.

  python3 inputs/studies/cell_steps.py steps [--program build/app/turgor] [--directory runs]

Results go to doc/results/spheroid/steps.csv; the picture from the runs:
  python3 app/plots/cell_steps.py doc/results/spheroid/cell_steps.png "compressed 1.3=runs/steps/mild" "newborn pairs=runs/steps/newborn" ...
"""
from table_of_runs import main

SMALL = {"Cells": 60, "Halvings": 10}


def steps():
    yield "mild", "cell_steps", SMALL
    yield "newborn", "cell_steps", {**SMALL, "Newborn share": 0.1}
    yield "tenfold", "cell_steps", {**SMALL, "Compression": 10}
    yield "stiff", "cell_steps", {**SMALL, "Stiffer": 1000, "Duration": 60}
    yield "slippery", "cell_steps", {**SMALL, "Less friction": 1000, "Duration": 60}


if __name__ == "__main__":
    main({"steps": steps}, "spheroid", __doc__)
