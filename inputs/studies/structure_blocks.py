#!/usr/bin/python3
"""The same tissue on both scales under a body force: clamped blocks of bricks, hexagons and Laguerre cells against FE2 with their RVE.

    /usr/bin/python3 inputs/studies/structure_blocks.py        writes doc/results/rve/blocks.md and blocks.png

  static   every wall of every cell, fluid at rest (static_lattice), against the static state of FE2 (tissue_statics): slabs (periodic
           across) and squares with frozen surfaces
  dynamic  all cells as particles (full_micro), slabs of n cells by two rows, against FE2 (tissue_gravity): amplitude and period of the swing

Both sides take the subsection Structure with the same entries; FE2 is as large as the block. Some ten minutes of CPU time.
"""
import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402

from runs import ROOT, no_choice, results, study  # noqa: E402

OUT = os.path.join(ROOT, "doc", "results", "rve")
KINDS = {"brick": "bricks", "hexagon": "hexagons"}
STATIC = {"slab": [4, 8, 16, 32], "frozen": [8, 16, 32, 48]}
SEEDS, LAGUERRE, LAGUERRE_RVE = [1, 2, 3, 4], [8, 16], 8
MOVING = {"brick": [4, 8]}
PERIOD_OF_16 = 0.47e-3  # s, about, of a tissue of 16 cells; it scales with the width
SEAT = {"slab": "periodic", "frozen": "free"}


def lattice(kind, surfaces, n, seed=1):
    return (f"{kind}_{seed}_{surfaces}_{n}", "static_lattice",
            {"Columns": n, "Rows": n, "Surfaces": surfaces, "Fields": "false", "Structure/Structure": kind,
             "Structure/Structure seed": seed})


def tissue(kind, surfaces, seed=1):
    cells = {"RVE/Columns": LAGUERRE_RVE, "RVE/Rows": LAGUERRE_RVE} if kind == "voronoi" else {}
    elements = 4 if kind == "voronoi" else 16
    return (f"{kind}_{seed}_{surfaces}_fe2", "tissue_statics",
            {"Tissue statics/Elements": elements, "Tissue statics/Degree": 2, "Tissue statics/Lateral sides": SEAT[surfaces],
             "Structure/Structure": kind, "Structure/Structure seed": seed, **cells})


def full(kind, n):
    return (f"{kind}_full_{n}", "full_micro",
            {"Columns": n, "Rows": 2, "Surfaces": "slab", "Structure/Structure": kind, "SPH/Particles per side": 14,
             "Step fraction": 1, "End time": f"{PERIOD_OF_16 * n / 16:.6g}", "Frames": 0})


def coarse(kind, n):
    return (f"{kind}_fe2_{n}", "tissue_gravity",
            {"Tissue gravity/Cells": n, "Tissue/Elements x": 8, "Tissue/Elements y": 1, "Tissue/Lateral sides": "periodic",
             "Structure/Structure": kind, "Time/End time": f"{PERIOD_OF_16 * n / 16:.6g}"})


RUNS = [*(lattice(k, s, n) for k in KINDS for s, sizes in STATIC.items() for n in sizes),
        *(tissue(k, s) for k in KINDS for s in STATIC),
        *(lattice("voronoi", "frozen", n, seed) for seed in SEEDS for n in LAGUERRE),
        *(tissue("voronoi", "frozen", seed) for seed in SEEDS),
        *(run for k, sizes in MOVING.items() for n in sizes for run in (full(k, n), coarse(k, n)))]


def finished(rows, run):
    row = rows[run[0]]
    if row["status"] != "finished":
        raise SystemExit(f"{row['run']}: {row['message']}")
    return row


def straight(sizes, values):
    """a and b of a + b/n through the two largest."""
    x, y = 1. / numpy.array(sizes[-2:], float), values[-2:]
    b = (y[1] - y[0]) / (x[1] - x[0])
    return y[1] - b * x[1], b


def swing(row):
    """Time (s) and downward displacement (m) of the probe."""
    with open(os.path.join(row["directory"], "probe.csv"), newline="", encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    return (numpy.array([float(r["time [s]"]) for r in table]), -numpy.array([float(r["displacement_y [m]"]) for r in table]))


def deepest(time, u):
    """Largest deflection and its time, by the parabola through the three highest samples."""
    k = int(numpy.clip(numpy.argmax(u), 1, len(u) - 2))
    a, b, c = numpy.polyfit(time[k - 1:k + 2] - time[k], u[k - 1:k + 2], 2)
    return c - b * b / (4. * a), time[k] - b / (2. * a)


def held(rows, kind):
    """n times the share of the tip that is missing at the longest slabs, extrapolated."""
    tip = lambda run: results(finished(rows, run))["tip_over_width"]  # noqa: E731
    fe, sizes = tip(tissue(kind, "slab")), STATIC["slab"][-2:]
    missing = [n * (1. - tip(lattice(kind, "slab", n)) / fe) for n in sizes]
    return 2. * missing[1] - missing[0]


def static_part(rows, lines):
    tip = lambda run: results(finished(rows, run))["tip_over_width"]  # noqa: E731
    for surfaces, sizes in STATIC.items():
        lines += ["", f"| static, {surfaces}: tip over width against FE2 | " + " | ".join(f"{n} x {n}" for n in sizes) +
                  " | a + b/n through the two largest | FE2 | CPU s, largest block / FE2 |", "|---" * (len(sizes) + 4) + "|"]
        for kind, name in KINDS.items():
            fe, tips = tip(tissue(kind, surfaces)), [tip(lattice(kind, surfaces, n)) for n in sizes]
            cost = [float(finished(rows, run)["cpu_time_s"]) for run in (lattice(kind, surfaces, sizes[-1]), tissue(kind, surfaces))]
            lines.append(f"| {name} | " + " | ".join(f"{100 * (t / fe - 1):+.2f} %" for t in tips) +
                         f" | **{100 * (straight(sizes, tips)[0] / fe - 1):+.2f} %** | {fe:.5f} | {cost[0]:.1f} / {cost[1]:.1f} |")
    blocks = {n: numpy.array([tip(lattice("voronoi", "frozen", n, seed)) for seed in SEEDS]) for n in LAGUERRE}
    fe = numpy.array([tip(tissue("voronoi", "frozen", seed)) for seed in SEEDS])
    of = lambda v: f"{v.mean():.5f} +- {v.std(ddof=1) / numpy.sqrt(len(v)):.5f}"  # noqa: E731
    limit = 2. * blocks[LAGUERRE[1]] - blocks[LAGUERRE[0]]
    lines += ["", f"| static, frozen: Laguerre cells, {len(SEEDS)} seeds, mean and its error | tip over width |", "|---|---|",
              *(f"| {n} x {n} cells | {of(v)} |" for n, v in blocks.items()),
              f"| 2 T({LAGUERRE[1]}) - T({LAGUERRE[0]}), seed by seed | {of(limit)} |",
              f"| FE2, RVEs of {LAGUERRE_RVE} x {LAGUERRE_RVE} cells | {of(fe)} |"]


def moving_part(rows, lines):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4), layout="constrained")
    for kind, sizes in MOVING.items():
        lines += ["", f"| dynamic, slabs of n x 2 {KINDS[kind]}, 14 x 14 particles a cell | amplitude over width | against FE2 | "
                  "time of the largest deflection, ms | against FE2 | CPU s, particles / FE2 |", "|---|---|---|---|---|---|"]
        ratios = []
        for n in sizes:
            pair = [finished(rows, run(kind, n)) for run in (full, coarse)]
            width = results(pair[1])["width"]
            (high, when), (fe_high, fe_when) = (deepest(*swing(row)) for row in pair)
            ratios.append((high / fe_high, when / fe_when))
            lines.append(f"| n = {n} | {high / width:.5f} | {100 * (high / fe_high - 1):+.2f} % | {1e3 * when:.4f} | "
                         f"{100 * (when / fe_when - 1):+.2f} % | {float(pair[0]['cpu_time_s']):.0f} / {float(pair[1]['cpu_time_s']):.1f} |")
            for row, style in zip(pair, ("-", "--")):
                time, u = swing(row)
                axes[0].plot(time / time[-1], 100. * u / width, style, color=f"C{sizes.index(n)}",
                             label=f"{n} cells, " + ("particles" if style == "-" else "FE²"))
        limits = [straight(sizes, [r[k] for r in ratios])[0] for k in (0, 1)]
        lines.append(f"| a + b/n through the two longest | | **{100 * (limits[0] - 1):+.2f} %** | | **{100 * (limits[1] - 1):+.2f} %** | |")
    axes[0].set_xlabel("time over the length of the run")
    axes[0].set_ylabel("middle of the free side, down, over width [%]")
    axes[0].set_title("Slabs of bricks under a sudden body force")
    axes[0].legend(fontsize=8)
    for kind, name in KINDS.items():
        for surfaces, sizes in STATIC.items():
            fe = results(finished(rows, tissue(kind, surfaces)))["tip_over_width"]
            tips = [100. * (results(finished(rows, lattice(kind, surfaces, n)))["tip_over_width"] / fe - 1.) for n in sizes]
            axes[1].plot([1. / n for n in sizes], tips, "o-" if surfaces == "slab" else "s--", label=f"{name}, {surfaces}",
                         color={"brick": "C0", "hexagon": "C1"}[kind])
    axes[1].axhline(0., color="k", lw=1)
    axes[1].set_xticks([1. / n for n in (4, 8, 16, 48)] + [0.], ["1/4", "1/8", "1/16", "1/48", "0"])
    axes[1].set_xlabel("1/n, cells along a side")
    axes[1].set_ylabel("tip of every cell against FE² [%]")
    axes[1].set_title("At rest: the difference goes with 1/n")
    axes[1].legend(fontsize=8)
    for axis in axes:
        axis.grid(True, alpha=0.3)
    figure.savefig(os.path.join(OUT, "blocks.png"), dpi=120)


def main():
    rows = study("structure_blocks", RUNS)
    lines = __doc__.strip().splitlines()
    static_part(rows, lines)
    moving_part(rows, lines)
    lines += ["", "![Swings and tips at rest](blocks.png)", "", "What differs between the two sides:", "",
              "- The clamp of hexagons and bricks runs along their steps: half of the rows is held half a cell further in, by itself a quarter of a "
              "cell that the block is shorter than FE2 has it, and held rows hold their neighbours there too. Of slabs the tip moves less by " +
              " and ".join(f"{held(rows, kind):.2f}/n ({name})" for kind, name in KINDS.items()) +
              ", and what that leaves goes with 1/n^2; the frozen sides of a square add what error_split has of square cells, which does not go "
              "with 1/n at these sizes.",
              "- Laguerre cells are another tissue with every seed, in the block and in the RVE: means are compared, within their errors.",
              "- Particles: the fluid resists shear a little (ordering pressure) and its viscous flow is its own; FE2 has the affine one."]
    with open(os.path.join(OUT, "blocks.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    no_choice(__doc__)
    main()
