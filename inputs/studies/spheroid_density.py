"""What the density of a spheroid in a capsule is made of (thesis Fig. 5.5B, C.2.1): measured in the fields of a spheroid_capsule run.

  python3 inputs/studies/spheroid_density.py DIRECTORY|results.csv ... [--hours 0 24 48] [--radius um of the capsule, for a run without growth.csv]

Per 1000 um^3 (a section of 10 um, 100 um^2), each at hours after confluence, within the capsule's radius (before the wall is
reached: the spheroid's):

  centres      cells whose centre lies in the section through the middle, over the circle: what growth.csv counts, and all cells over the sphere
  nuclei       centres within 5 um + half the diameter of a nucleus of 6 or 8 um: what a section shows
  N/V = fill / <V>,  <V> = <V_ref> <V>/<V_ref>
  fill         sum of the cells' volumes over the sphere's; above 1 cells would overlap everywhere
  covered      share of the sphere's volume that is inside some cell (points at random, same for all frames)
  <V_ref>      mean volume without pressure; living and dead; V/V_ref of both
  inner/outer  density within 60 % of the radius over that outside (the experiment: 1.2)
"""
import argparse
import csv
import os
import sys

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from drawing import read_table  # noqa: E402
from fields import frames  # noqa: E402


def covered_share(x, radius, R, points=4000):
    """Share of random points of the sphere that lie within a cell."""
    rng = np.random.default_rng(1)
    p = rng.normal(size=(points, 3))
    p *= (0.97 * R * rng.random(points) ** (1 / 3) / np.linalg.norm(p, axis=1))[:, None]
    inside = 0
    for block in np.array_split(p, max(1, points // 200)):
        d2 = ((block[:, None, :] - x[None, :, :]) ** 2).sum(axis=2)
        inside += int(np.any(d2 < radius[None, :] ** 2, axis=1).sum())
    return inside / points


def measure(frame, R):
    """{name: number} of a frame in a sphere of R (um) about its centroid."""
    x = (frame.points - frame.points.mean(axis=0)) * 1e6
    radius, volume = frame.field("radius") * 1e6, frame.field("volume") * 1e18
    reference = volume * np.exp(frame.field("strain"))
    dead = frame.field("state") >= 2
    r = np.linalg.norm(x, axis=1)
    sphere, circle = 4 / 3 * np.pi * R**3, np.pi * R**2
    row = {"cells": len(x), "dead": dead.mean()}
    row["centres"] = np.sum(np.abs(x[:, 2]) < 5) / circle * 100
    row["all_over_sphere"] = 1000 * len(x) / sphere
    for d in (6, 8):
        row[f"nuclei_{d}um"] = np.sum(np.abs(x[:, 2]) < 5 + d / 2) / circle * 100
    row["fill"] = volume.sum() / sphere
    row["covered"] = covered_share(x, radius, R)
    row["V_ref"] = reference.mean()
    row["V_ref_living"] = reference[~dead].mean()
    row["V_ref_dead"] = reference[dead].mean() if dead.any() else 0.
    row["V_over_V_ref"] = volume.sum() / reference.sum()
    row["V_over_V_ref_dead"] = volume[dead].sum() / reference[dead].sum() if dead.any() else 0.
    inner = r < 0.6 * R
    row["inner_over_outer"] = (inner.sum() / 0.6**3) / ((~inner).sum() / (1 - 0.6**3)) if inner.any() else 0.
    row["pressure_living"] = np.average(frame.field("pressure")[~dead], weights=volume[~dead])
    row["pressure_dead"] = np.average(frame.field("pressure")[dead], weights=volume[dead]) if dead.any() else 0.
    return row


def rows_of(directory, hours):
    table = read_table(os.path.join(directory, "growth.csv"))
    t, R, edge = table["time [s]"], table["capsule_radius [m]"], table["radius [m]"]
    start = t[np.argmax(edge >= 0.99 * R[0])]
    taken = list(frames(directory, "cells"))
    for hour in hours:
        frame = min(taken, key=lambda f: abs(f.time - start - 3600 * hour))
        at = lambda column: float(np.interp(frame.time, t, column))  # noqa: E731
        yield {"hours": (frame.time - start) / 3600, "R": 1e6 * min(at(R), at(edge)) if hour <= 0 else 1e6 * at(R),
               **measure(frame, 1e6 * (at(edge) if hour <= 0 else at(R))), "pressure_capsule": at(table["capsule_pressure [Pa]"])}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", nargs="+")
    parser.add_argument("--hours", type=float, nargs="+", default=[0, 24, 48])
    parser.add_argument("--csv", help="write the rows there")
    options = parser.parse_args()
    places = []
    for place in options.directory:
        if place.endswith(".csv"):  # the runs of a study
            with open(place, newline="", encoding="utf-8") as file:
                places += [(row["run"], os.path.join(os.path.dirname(place), row["directory"])) for row in csv.DictReader(file) if row["status"] == "finished"]
        else:
            places.append((os.path.basename(os.path.normpath(place)), place))
    rows = [{"run": label, **{k: f"{v:.4g}" for k, v in row.items()}} for label, place in places for row in rows_of(place, options.hours)]
    for name in rows[0]:
        print(f"{name:20s}", *(f"{row[name]:>10s}" for row in rows))
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
