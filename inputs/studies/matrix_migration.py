"""Speed of the cell of matrix_migration against the rate at which it degrades its matrix (thesis Fig. 6.2C): sigmoids and their plateaus.

  python3 inputs/studies/matrix_migration.py        doc/results/matrix/migration.csv, plateaus.csv and migration.png, about ten minutes of CPU time

15 rates from 0.002 to 200 1/s, three times: degraded evenly and everywhere in a disc, where both plateaus have closed forms; in the cone in front of the cell, the force
per metre of depth; and the force for the cell's own depth. Beside them other seeds and spacings. The fit is
log v = log v_low + (log v_high - log v_low)/(1 + (r_half/r)^n) by least squares over the runs of a series.
"""
import os
import sys

import numpy as np

from runs import ROOT, no_choice, results, study, write_table

sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
from drawing import ACCENT, ALONG, INK, plt, style  # noqa: E402

RATES = [float(f"{rate:.4g}") for rate in np.geomspace(0.002, 200, 15)]
COMMON = {"Spacing": "20e-6", "Samples": "10", "Frames": "0"}
EVENLY = {**COMMON, "Domain": "disc", "Cell/Force depth": "metre", "Cell/Spread": "0", "Degradation/Ring": "0", "Degradation/Angle": "180", "Degradation/Cut-off": "100", "Degradation/Decay": "1e6", "End time": "10"}
SERIES = {
    "everywhere": (EVENLY, "everywhere in a disc, force per metre"),
    "cone_metre": ({**COMMON, "Cell/Force depth": "metre", "End time": "20"}, "in the cone, force per metre"),
    "cone_cell": ({**COMMON, "Cell/Force depth": "cell", "End time": "20"}, "in the cone, force per cell depth"),
}
BESIDE = [
    ("everywhere", [RATES[0], RATES[7], RATES[-1]], [{"Packing/Seed": "2"}, {"Packing/Seed": "3"}, {"Spacing": "10e-6"}]),
    ("cone_cell", [RATES[0], RATES[7], RATES[-1]], [{"Packing/Seed": "2"}, {"Packing/Seed": "3"}, {"Spacing": "14e-6"}]),
]


def fit(rates, speeds):
    """(v_low, v_high, r_half, n) by a scan of r_half and n; the other two are linear."""
    best = None
    for half in np.geomspace(rates[0], rates[-1], 200):
        for n in np.geomspace(0.2, 5, 60):
            share = 1 / (1 + (half / rates) ** n)
            A = np.stack([1 - share, share], axis=1)
            (low, high), *_ = np.linalg.lstsq(A, np.log(speeds), rcond=None)
            miss = float(((A @ [low, high] - np.log(speeds)) ** 2).sum())
            if best is None or miss < best[0]:
                best = (miss, np.exp(low), np.exp(high), half, n)
    return best[1:]


def row_of(series, rate, entries, row):
    """A row of migration.csv."""
    said = {"series": series, "rate 1/s": f"{rate:.4g}", "seed": entries.get("Packing/Seed", "1"), "spacing um": f"{1e6 * float(entries['Spacing']):.3g}"}
    if row["status"] != "finished":
        return {**said, "failed": row["message"]}
    run = results(row)
    intact = f"{60e6 * run['mean_force'] * run['intact_compliance'] / run['end_time']:.5g}" if "intact_compliance" in run else ""
    return {**said, "speed um/min": f"{60e6 * run['speed']:.5g}", "intact closed form um/min": intact, "degraded closed form um/min": f"{60e6 * run['mean_force'] * run['degraded_mobility']:.5g}", "end s": f"{run['end_time']:.4g}",
            "way um": f"{1e6 * run['displacement']:.4g}", "most stress Pa": f"{run['most_stress']:.4g}", "energy balance": f"{run['energy_balance']:.2g}", "force balance": f"{run['force_balance']:.2g}", "cpu s": f"{float(row['cpu_time_s']):.3g}", "failed": ""}


def draw(fits, table):
    figure, axes = plt.subplots(1, len(SERIES), figsize=(13.5, 4.2), facecolor="white")
    for axis, (series, (_, text)) in zip(axes, SERIES.items()):
        low, high, half, n, rates, speeds = fits[series]
        fine = np.geomspace(RATES[0], RATES[-1], 300)
        axis.loglog(fine, np.exp(np.log(low) + np.log(high / low) / (1 + (half / fine) ** n)), color=ALONG, linewidth=1.4, label=f"fit: {low:.3g} and {high:.3g} µm/min, half way at {half:.2g} 1/s")
        axis.loglog(rates, speeds, "o", color=ACCENT, markersize=5, label="seed 1, particles 20 µm apart")
        beside = [(float(row["rate 1/s"]), float(row["speed um/min"])) for row in table if row["series"] == series and not row["failed"] and (row["seed"] != "1" or row["spacing um"] != "20")]
        if beside:
            axis.loglog(*zip(*beside), "x", color=INK, markersize=6, label="other seeds and spacings")
        forms = next(row for row in table if row["series"] == series and not row["failed"])
        for name, label in (("intact closed form um/min", "closed forms"), ("degraded closed form um/min", None if forms["intact closed form um/min"] else "closed form, all degraded")):
            if forms[name]:
                axis.axhline(float(forms[name]), color=INK, linewidth=0.8, linestyle=":", label=label)
        axis.set_title(f"degraded {text}", color=INK, fontsize=10)
        axis.set_xlabel("rate of degradation, 1/τ [1/s]", color=INK, fontsize=9)
        axis.legend(frameon=True, edgecolor="none", framealpha=1, fontsize=7)
        style(axis)
    axes[0].set_ylabel("mean speed of the cell [µm/min]", color=INK, fontsize=9)
    figure.tight_layout()
    figure.savefig(os.path.join(ROOT, "doc", "results", "matrix", "migration.png"), dpi=140)


def main():
    no_choice(__doc__)
    wanted = {f"{series}_{k}": (series, rate, entries) for series, (entries, _) in SERIES.items() for k, rate in enumerate(RATES)}
    for series, rates, changes in BESIDE:
        wanted.update({f"{series}_beside_{k}_{c}": (series, rate, {**SERIES[series][0], **change}) for k, rate in enumerate(rates) for c, change in enumerate(changes)})
    rows = study("matrix_migration", [(label, "matrix_migration", {**entries, "Degradation/Rate": f"{rate:.4g}"}) for label, (_, rate, entries) in wanted.items()])
    table = [row_of(series, rate, entries, rows[label]) for label, (series, rate, entries) in wanted.items()]
    write_table("matrix/migration.csv", table)
    fits, plateaus = {}, []
    for series in SERIES:
        kept = [row for row in table if row["series"] == series and not row["failed"] and row["seed"] == "1" and row["spacing um"] == "20"]
        rates, speeds = (np.array([float(row[name]) for row in kept]) for name in ("rate 1/s", "speed um/min"))
        low, high, half, n = fit(rates, speeds)
        fits[series] = (low, high, half, n, rates, speeds)
        intact, degraded = kept[0]["intact closed form um/min"], float(kept[0]["degraded closed form um/min"])
        plateaus.append({"series": series, "runs": str(len(kept)), "low um/min": f"{low:.4g}", "low over its closed form": f"{low / float(intact):.4f}" if intact else "", "high um/min": f"{high:.4g}",
                         "slowest run over closed form": f"{speeds[0] / float(intact):.4f}" if intact else "", "fastest run over closed form": f"{speeds[-1] / degraded:.4f}",
                         "high over its closed form": f"{high / degraded:.4f}", "half way 1/s": f"{half:.3g}", "exponent": f"{n:.3g}", "largest miss of the fit": f"{np.max(np.abs(np.log(speeds) - (np.log(low) + np.log(high / low) / (1 + (half / rates) ** n)))):.2g}"})
    write_table("matrix/plateaus.csv", plateaus)
    for row in plateaus:
        print(row)
    draw(fits, table)


if __name__ == "__main__":
    main()
