"""What the growth of a spheroid in a thin capsule is sensitive to: the thesis's statements (5.4.2, C.2, C.3), each as a measured yes or no.

  python3 inputs/studies/spheroid_sensitivity.py NAME [--program build/app/turgor] [--directory runs] [--only-table]

NAME: n, eps_tr, alpha_qui, K, T_lys, timer, friction, W, D, seeds, growth_law, calibration (each with the reference run), or all.

A smaller capsule of the same H/R, R = 30 um and H = 2.4 um (the same pressure at the same strain), from confluence to 75 h after it: a
fortieth of the cells. Measured: dilatation (R - R_0)/R_0 at 24 and 48 h, its rate from 48 h to 75 h, density
at 48 h over that at confluence. The runs' results go to doc/results/spheroid/sensitivity.csv, the statements to statements.csv and,
for all, the curves to sensitivity.png beside it.
"""
import csv
import json
import os
import sys

from table_of_runs import ROOT, options_of, row_of, run_all, write_table

R_0 = 30e-6
SMALL = {"Capsule/Radius": R_0, "Capsule/Thickness": 2.4e-6, "Capsule/Time confined": 270000, "First cells": 30,
         "Frames": 0, "Checkpoints": 2}
FRICTION = {"Contact/Normal friction": 5e10, "Contact/Tangential friction": 5e10, "Contact/Medium friction": 5e8, "Capsule/Friction": 2e10}


def times(factor):
    return {name: value * factor for name, value in FRICTION.items()}


STUDIES = {
    "n": {"n_2": {"Growth/Exponent": 2}, "n_4": {"Growth/Exponent": 4}, "n_1000": {"Growth/Exponent": 1000}},
    "eps_tr": {"eps_0.2": {"Growth/Threshold": 0.2}, "eps_0.5": {"Growth/Threshold": 0.5}},
    "alpha_qui": {"qui_0.33": {"Growth/Quiescence below": 0.33}, "qui_0.5": {"Growth/Quiescence below": 0.5}},
    "K": {f"K_{K / 1000:g}k": {"Cell/Bulk modulus": K, "Cell/Strain hardening": "false", "Growth/Inhibition": "none"}
          for K in (2500, 10000, 150000)} | {"K_hardening": {"Growth/Inhibition": "none"}},  # K_2.5k: see CUT_SHORT
    "T_lys": {"lys_5h": {"Death/Lysis time": 18000}, "lys_14d": {"Death/Lysis time": 1209600}},
    "timer": {"timer": {"Growth/Division at": "time"}},
    "friction": {"friction_1%": times(0.01), "friction_200%": times(2)},
    "W": {"W_10%": {"Contact/Adhesion": 1e-5}, "W_250%": {"Contact/Adhesion": 2.5e-4}},
    "D": {"D_10%": {"Motion/Motility": 1e-17}, "D_500%": {"Motion/Motility": 5e-16}},
    "seeds": {f"seed_{k}": {"Cell/Seed": k} for k in (2, 3, 4)},
    "growth_law": {"constant": {"Growth/Inhibition": "none"}, "linear_0.35": {"Growth/Inhibition": "linear"},
                   "linear_0.8": {"Growth/Inhibition": "linear", "Growth/Threshold": 0.8}},
    "calibration": {"uncalibrated": {"Contact/Local stiffness": "none"}},
}

# Later the centre of a cell passes the wall and the run fails: soft cells under constant growth (at 70 h), contacts without calibration (36 h).
CUT_SHORT = {"K_2.5k": 180000, "uncalibrated": 90000}


def at(t, times, values):
    """Linear interpolation."""
    for k in range(1, len(times)):
        if t <= times[k]:
            share = (t - times[k - 1]) / (times[k] - times[k - 1])
            return values[k - 1] + share * (values[k] - values[k - 1])
    return values[-1]


def slope(times, values):
    """Of the least squares line."""
    mean_t, mean_v = sum(times) / len(times), sum(values) / len(values)
    return sum((t - mean_t) * (v - mean_v) for t, v in zip(times, values)) / sum((t - mean_t)**2 for t in times)


def measure(place):
    """{name: number} of a run."""
    with open(os.path.join(place, "growth.csv"), encoding="utf-8") as file:
        rows = list(csv.reader(file))
    table = {name.split(" [")[0]: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}
    start = json.load(open(os.path.join(place, "summary.json"), encoding="utf-8"))["results"]["confluence_time"]["value"]
    hours = [(t - start) / 3600 for t in table["time"]]
    strain = [r / R_0 - 1 for r in table["capsule_radius"]]
    late = [k for k, t in enumerate(hours) if t >= 48]
    return {"d24": at(24, hours, strain), "d48": at(48, hours, strain) if late else 0.,
            "rate": 24 * slope([hours[k] for k in late], [strain[k] for k in late]) if len(late) > 2 else 0.,  # 0: ended before
            "density": at(48, hours, table["density"]) / at(0, hours, table["density"]) if late else 0.}


# (study, statement of the thesis, runs it needs, what has to hold for a yes)
STATEMENTS = [
    ("n", "n = 1 and n = 2 hardly differ (5.4.2): dilatation at 48 h within 10 %", ("reference", "n_2"),
     lambda r, a: abs(a["d48"] / r["d48"] - 1) < 0.1),
    ("n", "n = 4 grows faster in the beginning than n = 1 (5.4.2): dilatation at 24 h", ("reference", "n_4"), lambda r, a: a["d24"] > r["d24"]),
    ("n", "n = 4 flattens the residual growth (5.4.2): rate below 3/4 of that of n = 1", ("reference", "n_4"),
     lambda r, a: a["rate"] < 0.75 * r["rate"]),
    ("n", "n -> infinity leads to a plateau (5.4.2): rate below 1/4", ("reference", "n_1000"), lambda r, a: a["rate"] < 0.25 * r["rate"]),
    ("eps_tr", "a larger threshold dilates faster over the whole time (5.4.2): at 24 h, 48 h and in rate", ("eps_0.2", "reference", "eps_0.5"),
     lambda a, r, b: all(a[k] < r[k] < b[k] for k in ("d24", "d48", "rate"))),
    ("alpha_qui", "alpha_qui up to 0.33 changes little (5.4.2): dilatation at 48 h within 10 %", ("reference", "qui_0.33"),
     lambda r, a: abs(a["d48"] / r["d48"] - 1) < 0.1),
    ("alpha_qui", "alpha_qui = 0.5 stalls the growth (5.4.2): rate below 3/4", ("reference", "qui_0.5"), lambda r, a: a["rate"] < 0.75 * r["rate"]),
    ("K", "K = 10 kPa makes the density rise less than K = 2.5 kPa, 150 kPa less still (C.2.3)", ("K_2.5k", "K_10k", "K_150k"),
     lambda a, b, c: a["density"] > b["density"] > c["density"]),
    ("K", "K = 150 kPa overestimates the first growth (C.2.3): dilatation at 24 h above that of K = 10 kPa", ("K_10k", "K_150k"),
     lambda a, b: b["d24"] > a["d24"]),
    ("K", "hardening alone does not slow the residual growth to that with inhibition (C.2.3): rate above 4/3", ("reference", "K_hardening"),
     lambda r, a: a["rate"] > r["rate"] / 0.75),
    ("T_lys", "the shorter T_lys, the more the curve bends off in the beginning (C.2.3): dilatation at 24 h", ("lys_5h", "reference", "lys_14d"),
     lambda a, r, b: a["d24"] < r["d24"] < b["d24"]),
    ("timer", "dividing at a fixed time makes the density at 48 h too high (Fig. C.3C): above the reference by more than 10 %",
     ("reference", "timer"), lambda r, a: a["density"] > 1.1 * r["density"]),
    ("friction", "1 % and 200 % of all friction leave the result largely unaffected (C.3): dilatation at 48 h within 10 %",
     ("reference", "friction_1%", "friction_200%"), lambda r, a, b: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in (a, b))),
    ("W", "adhesion makes no significant change (C.3; here to 250 %, beyond it contacts are as wide as cells): within 10 %",
     ("reference", "W_10%", "W_250%"), lambda r, a, b: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in (a, b))),
    ("D", "motility between 10 % and 500 % makes no significant change (C.3): within 10 %", ("reference", "D_10%", "D_500%"),
     lambda r, a, b: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in (a, b))),
    ("seeds", "four seeds differ very little (C.3): dilatation at 48 h within 10 %", ("reference", "seed_2", "seed_3", "seed_4"),
     lambda r, *others: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in others)),
    ("growth_law", "a constant rate makes the residual growth too fast (5.4.2): rate above 4/3", ("reference", "constant"),
     lambda r, a: a["rate"] > r["rate"] / 0.75),
    ("growth_law", "a linear law with the same half point does about as well in the capsule (5.4.2): dilatation at 48 h within 15 %",
     ("reference", "linear_0.35"), lambda r, a: abs(a["d48"] / r["d48"] - 1) < 0.15),
    ("growth_law", "a linear law with a longer reach overestimates it (5.4.2): dilatation at 48 h above 1.15", ("reference", "linear_0.8"),
     lambda r, a: a["d48"] > 1.15 * r["d48"]),
    ("calibration", "contacts without calibrated stiffness give an unrealistic dilatation (C.3.1): off by more than 25 % at 24 h (the run does"
     " not reach 48 h)", ("reference", "uncalibrated"), lambda r, a: abs(a["d24"] / r["d24"] - 1) > 0.25),
]

# Panels of sensitivity.png: (title, what is drawn, runs beside the reference)
PANELS = [
    ("Hill exponent n (Fig. 5.5A)", "dilatation", ("n_2", "n_4", "n_1000")),
    ("threshold eps_tr (Fig. 5.6A)", "dilatation", ("eps_0.2", "eps_0.5")),
    ("alpha_qui (Fig. 5.5A)", "dilatation", ("qui_0.33", "qui_0.5")),
    ("laws of growth (Fig. C.4G)", "dilatation", ("linear_0.35", "linear_0.8", "constant")),
    ("K, constant growth (Fig. C.2A)", "dilatation", ("K_2.5k", "K_10k", "K_150k", "K_hardening")),
    ("K, constant growth (Fig. C.2B)", "density", ("K_2.5k", "K_10k", "K_150k", "K_hardening")),
    ("K, constant growth (Fig. C.2C)", "pressure", ("K_2.5k", "K_10k", "K_150k", "K_hardening")),
    ("T_lys (Fig. C.3A)", "dilatation", ("lys_5h", "lys_14d")),
    ("T_lys, timer (Fig. C.3B, C)", "density", ("lys_5h", "lys_14d", "timer")),
    ("friction (Fig. C.4A)", "dilatation", ("friction_1%", "friction_200%")),
    ("seeds (Fig. C.4B)", "dilatation", ("seed_2", "seed_3", "seed_4")),
    ("calibration, W, D (Fig. C.4C, E, F)", "dilatation", ("uncalibrated", "W_10%", "W_250%", "D_10%", "D_500%")),
]


def draw_panels(places):
    sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
    from spheroid_variations import draw
    draw([(title, column, [(label, places[label]) for label in ("reference", *labels) if label in places]) for title, column, labels in PANELS],
         os.path.join(ROOT, "doc", "results", "spheroid", "sensitivity.png"))


def main():
    options = options_of(list(STUDIES) + ["all"], __doc__)
    chosen = list(STUDIES) if options.study == "all" else [options.study]
    options.study = "sensitivity"
    variants = {"reference": {}}
    for name in chosen:
        variants.update(STUDIES[name])
    for label, seconds in CUT_SHORT.items():
        if label in variants:
            variants[label] = {**variants[label], "Capsule/Time confined": seconds}
    done = run_all(options, ((label, "spheroid_capsule", {**SMALL, **entries}) for label, entries in variants.items()))
    measured, rows = {}, []
    for label, place, failed in done:
        rows.append(row_of(label, place, failed))
        if place is not None:
            measured[label] = measure(place)
            rows[-1].update({"dilatation_24h": f"{measured[label]['d24']:.4g}", "dilatation_48h_over_radius": f"{measured[label]['d48']:.4g}",
                             "rate_per_day": f"{measured[label]['rate']:.4g}", "density_48h_over_confluence": f"{measured[label]['density']:.4g}"})
    write_table("spheroid", "sensitivity", rows)
    if chosen == list(STUDIES):
        draw_panels({label: place for label, place, _ in done if place is not None})
    verdicts = []
    for study, statement, needed, holds in STATEMENTS:
        if study in chosen and all(label in measured for label in needed):
            values = [measured[label] for label in needed]
            verdicts.append({"study": study, "statement": statement, "measured": "yes" if holds(*values) else "no",
                             "numbers": "; ".join(f"{label}: " + ", ".join(f"{k} {v:.3g}" for k, v in one.items())
                                                  for label, one in zip(needed, values))})
            print(verdicts[-1]["measured"], statement)
    if verdicts:
        write_table("spheroid", "statements", verdicts)


if __name__ == "__main__":
    main()
