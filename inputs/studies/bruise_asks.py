#!/usr/bin/python3
"""What keeps the calls of a bruise's RVEs from being skipped: the shares of asks in which walls flow, stand still, have failed.

    /usr/bin/python3 inputs/studies/bruise_asks.py        prints the table of doc/skipping.md, half a minute of CPU time

inputs/tissue_bruise.prm with 5 x 10 elements (200 RVEs) and a frame at every step (each 0.5 us). A point has flowed in a step when the mean permanent
stretch of its walls has grown; it has failed when a cell of it has. Asks a call, at most: every step in which walls flow is called, and every one of
a failed cell, whose fluid leaks; in between the point answers from its own last call for as long as F_xx and F_yy have moved by less than the
reach (shear, which the table does not have, makes it less), 'any': for ever.
"""
import collections
import csv
import math
import os

from runs import no_choice, study

REACHES = (7e-4, 2e-3, math.inf)
COARSE = {"Tissue/Elements x": 5, "Tissue/Elements y": 10, "Time/Output interval": 5e-7}
RUNS = [("as_it_comes", COARSE), ("nothing_breaks", {**COARSE, "Wall/Critical stretch": 0})]


def frames(directory):
    """Per frame and point: failed share, permanent stretch, F_xx, F_yy."""
    with open(os.path.join(directory, "rve_points.csv"), newline="", encoding="utf-8") as file:
        table = csv.reader(file)
        head = [name.split(" ")[0] for name in next(table)]
        wanted = [head.index(name) for name in ("failed", "permanent_stretch", "F_xx", "F_yy")]
        by_time = collections.OrderedDict()
        for row in table:
            by_time.setdefault(row[0], []).append(tuple(float(row[k]) for k in wanted))
    return list(by_time.values())


def what_happens(before, after):
    if after[0] > 0:
        return "failed"
    if after[1] > before[1] + 1e-13:
        return "flows"
    return "stands still" if after[1] > 0 else "untouched"


def main():
    no_choice(__doc__)
    runs = study("bruise_asks", [(label, "tissue_bruise", entries) for label, entries in RUNS])
    print("| run | untouched | flows | stands still after flow | failed | asks a call at most: reach " +
          " | ".join("any" if math.isinf(reach) else f"{reach:g}" for reach in REACHES) + " |")
    print("|" + "---|" * (5 + len(REACHES)))
    for label, _ in RUNS:
        course = frames(runs[label]["directory"])
        shares, calls = collections.Counter(), [0] * len(REACHES)
        last = [[point[2:] for point in course[0]] for _ in REACHES]
        for before, after in zip(course, course[1:]):
            for p, (old, new) in enumerate(zip(before, after)):
                event = what_happens(old, new)
                shares[event] += 1
                for k, reach in enumerate(REACHES):
                    if event in ("flows", "failed") or math.dist(new[2:], last[k][p]) > reach:
                        calls[k] += 1
                        last[k][p] = new[2:]
        asks = sum(shares.values())
        print(f"| {label.replace('_', ' ')} | " + " | ".join(f"{shares[event] / asks:.3f}" for event in ("untouched", "flows", "stands still", "failed")) +
              " | " + " | ".join(f"{asks / number:.2f}" for number in calls) + " |")


if __name__ == "__main__":
    main()
