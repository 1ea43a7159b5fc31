"""Why a spheroid with a proliferating rim grows slower than the closed form: its balance of volume (thesis 5.4.2).

  python3 inputs/studies/spheroid_rim.py            doc/results/spheroid/rim.csv, 2 minutes of CPU time

E: edge of the spheroid (radius of growth.csv), l = 30 um, k = ln 2/T, V: volume of all cells, P: of those that proliferate,
S = 1 - (1 - l/E)^3: the rim's share of a smooth ball, phi = V/(4/3 pi E^3): fill. Without any assumption

  dE/dt = (E/3) (dlnV/dt - dlnphi/dt),      closed form:  dE/dt = (E/3) k S = l k (1 - l/E + l^2/(3 E^2))

so that the difference is, over the second half of the run, in % of the closed form at the middle radius (the row of validation):

  one_radius   the closed form is concave in E: its mean over the radii that were there lies below its value at the middle one
  share        P/V instead of S: cells whose centres lie in the rim, of a rough cluster
  production   dV/dt instead of k P: ages, time without growth, compression, steps of the cells' life
  fill         phi changes. Of it: the core's share of the ball grows (core_share; the core is fuller than the rough rim), the rim's
               own fill changes (rim_fill), the core's (core_fill)
  line         the line fitted to all samples instead of both ends
  sum          of these = row

edge beyond full: E over the radius of a ball of the same volume that has the core's fill throughout, mean over that time. rim, core:
fill of the ball's two parts. half axes: of the ellipsoid with the same second moments, at the end.
"""
import os
import sys

import numpy as np

from runs import ROOT, no_choice, results, study, write_table

sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from drawing import read_table  # noqa: E402
from fields import frames  # noqa: E402

RIM = 30e-6
RIMMED = {"Death/Rim": "quiescent", "Death/Rim thickness": str(RIM), "First phases": "spread"}
TERMS = ["row", "one_radius", "share", "production", "fill", "line", "sum", "core_share", "rim_fill", "core_fill", "edge beyond full um"]
BALL = {"First cells": "400", "End time": "277200"}


def runs():
    for name, entries in (("ten", {}), ("ball_400", BALL)):
        for seed in "1234":
            yield f"{name}_{seed}", "spheroid_free", {**RIMMED, **entries, "Cell/Seed": seed}


def balance(directory, row):
    """{term: % of the closed form at the middle radius}, and what the spheroid looks like."""
    speed, middle = (row[name] * 1e-6 / 86400 for name in ("radial_speed", "radial_speed_closed_form"))  # m/s
    k = np.log(2) / row["doubling_time_closed_form"]
    table = read_table(os.path.join(directory, "growth.csv"))
    t, E, V, P = (table[name] for name in ("time [s]", "radius [m]", "volume [m^3]", "proliferating_volume [m^3]"))
    later = t >= 0.5 * t[-1]
    t, E, V, P = t[later], E[later], V[later], P[later]
    ball, inner = 4 / 3 * np.pi * E**3, 4 / 3 * np.pi * (E - RIM) ** 3
    S = 1 - inner / ball
    phi, rim, core = V / ball, P / (ball - inner), (V - P) / inner
    between = lambda y: 0.5 * (y[1:] + y[:-1])  # noqa: E731
    over_time = lambda y: float(np.sum(between(y) * np.diff(t)))  # noqa: E731
    by_fill = lambda change: -float(np.sum(between(E / 3 / phi) * change))  # noqa: E731
    unit = middle * (t[-1] - t[0])
    closed, shared = over_time(E / 3 * k * S), over_time(E / 3 * k * P / V)
    made, grown = float(np.sum(between(E / 3) * np.diff(np.log(V)))), E[-1] - E[0]
    terms = {"row": speed / middle - 1, "one_radius": closed / unit - 1, "share": (shared - closed) / unit, "production": (made - shared) / unit,
             "fill": (grown - made) / unit, "line": speed / middle - grown / unit}
    terms["sum"] = sum(value for name, value in terms.items() if name != "row")
    terms["core_share"] = by_fill(np.diff(S) * between(rim - core)) / unit
    terms["rim_fill"] = by_fill(between(S) * np.diff(rim)) / unit
    terms["core_fill"] = by_fill(between(1 - S) * np.diff(core)) / unit
    result = {name: f"{100 * value:.2f}" for name, value in terms.items()}
    tenth = max(1, len(t) // 10)
    for name, values in (("phi", phi), ("rim", rim), ("core", core)):
        result[name + " first, last"] = f"{values[:tenth].mean():.3f}, {values[-tenth:].mean():.3f}"
    last = frames(directory, "cells")[-1]
    axes = np.sqrt(5 * np.linalg.eigvalsh(np.cov(1e6 * last.points.T)))
    away = np.linalg.norm(last.points - last.points.mean(axis=0), axis=1)
    full = np.cbrt(3 * V / (4 * np.pi * core))
    result["edge beyond full um"] = f"{1e6 * np.mean(E - full):.1f}"
    result["radius um"] = f"{1e6 * E[0]:.1f} to {1e6 * E[-1]:.1f}"
    result["half axes um"] = ", ".join(f"{axis:.0f}" for axis in axes)
    result["beyond edge %"] = f"{100 * last.field('volume')[away > E[-1]].sum() / V[-1]:.1f}"
    return result


def main():
    rows, kept = [], []
    for label, run in study("rim", runs()).items():
        if run["status"] != "finished":
            rows.append({"run": label, "failed": run["message"]})
            continue
        found = balance(run["directory"], results(run))
        kept.append((label, found))
        rows.append({"run": label, "cpu_time_s": run["cpu_time_s"], "cells": run["cells"], **found})
    for group in sorted({label[:-2] for label, _ in kept}):
        found = [terms for label, terms in kept if label[:-2] == group]
        rows.append({"run": group + " mean"} | {name: f"{np.mean([float(one[name]) for one in found]):.2f}" for name in TERMS})
    write_table("spheroid/rim.csv", rows)


if __name__ == "__main__":
    no_choice(__doc__)
    main()
