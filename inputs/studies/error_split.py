#!/usr/bin/python3
"""Error split of the gravity example, statically: mesh, surface and homogenisation told apart.

  inputs/studies/error_split.py

Runs tissue_statics (FE^2) over meshes and static_lattice (every cell) over n with each kind of surface, for a square and for a
beam three times as long as high, and writes static.csv, limits.csv and static.png to doc/results/error_split. Some minutes of
CPU time.
"""
import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402

from runs import ROOT, no_choice, results, study  # noqa: E402

OUT = os.path.join(ROOT, "doc", "results", "error_split")
MESHES = {1: [4, 8, 16, 32], 2: [4, 8, 16, 32]}
BLOCKS = {"slab": [4, 8, 16, 32], "frozen": [4, 8, 16, 24, 32, 48, 64], "free": [4, 8, 16, 24, 32, 48],
          "osmosis": [4, 8, 16, 24, 32, 48]}
BEAM = {"frozen": [4, 8, 16, 24], "free": [4, 8, 16, 24], "osmosis": [4, 8, 16, 24]}  # cells across; three times as many along
BEAM_MESHES = [4, 8, 16]
BEAM_LOAD = 1000.  # Pa, where the beam is still linear: tip below 1 % of its length
# How much of what is left over at frozen surfaces goes with the stiffness of the fluid (Pa), see README.md.
MODULI = ["6e5", "1.2e5"]


def tissue(elements, degree, lateral="free", modulus=None):
    entries = {"Tissue statics/Elements": elements, "Tissue statics/Degree": degree, "Tissue statics/Lateral sides": lateral}
    return (f"tissue_{lateral}_{degree}_{elements}" + (f"_{modulus}" if modulus else ""), "tissue_statics",
            {**entries, "Cell/Fluid modulus": modulus} if modulus else entries)


def lattice(n, surfaces, modulus=None):
    entries = {"Columns": n, "Rows": n, "Surfaces": surfaces, "Fields": "false"}
    return (f"lattice_{surfaces}_{n}" + (f"_{modulus}" if modulus else ""), "static_lattice",
            {**entries, "Cell/Fluid modulus": modulus} if modulus else entries)


def tissue_beam(across):
    return (f"tissue_beam_{across}", "tissue_statics",
            {"Tissue statics/Cells": 48, "Tissue statics/Cells across": 16, "Tissue statics/Elements": 3 * across,
             "Tissue statics/Elements across": across, "Tissue statics/Degree": 2, "Tissue statics/Load": BEAM_LOAD})


def lattice_beam(n, surfaces):
    return (f"lattice_beam_{surfaces}_{n}", "static_lattice",
            {"Columns": 3 * n, "Rows": n, "Surfaces": surfaces, "Fields": "false", "Load": BEAM_LOAD})


SLAB, SLAB_COARSE = tissue(16, 2, "periodic"), tissue(8, 1, "periodic")
RUNS = [*(tissue(m, d) for d, sizes in MESHES.items() for m in sizes), SLAB, SLAB_COARSE,
        *(lattice(n, s) for s, sizes in BLOCKS.items() for n in sizes),
        *(tissue_beam(m) for m in BEAM_MESHES), *(lattice_beam(n, s) for s, sizes in BEAM.items() for n in sizes),
        *(run for k in MODULI for run in (tissue(16, 2, modulus=k), lattice(16, "frozen", k), lattice(32, "frozen", k)))]


def measured(row):
    if row["status"] != "finished":
        raise SystemExit(f"{row['run']}: {row['message']}")
    result = results(row)
    iterations = result["newton_iterations"] + result.get("newton_iterations_unloaded", 0.)
    return {"tip": result["tip_over_width"], "pressure_min": result["pressure_min"], "pressure_max": result["pressure_max"],
            "iterations": iterations, "cpu": float(row["cpu_time_s"])}


def richardson(values):
    """Limit and observed order of three values on meshes halved twice."""
    ratio = (values[-2] - values[-3]) / (values[-1] - values[-2])
    return values[-1] + (values[-1] - values[-2]) / (ratio - 1.), numpy.log2(ratio)


def limit_in_cells(n, tips, powers):
    """Limit of a + b n^p + ... through the largest blocks."""
    count = len(powers) + 1
    n, tips = numpy.array(n[-count:], float), numpy.array(tips[-count:])
    return numpy.linalg.solve(numpy.stack([n ** p for p in [0, *powers]], axis=1), tips)


def main():
    os.makedirs(OUT, exist_ok=True)
    found = {label: measured(row) for label, row in study("error_split", RUNS).items()}
    of = lambda run: found[run[0]]  # noqa: E731
    mesh = {d: [of(tissue(m, d)) for m in sizes] for d, sizes in MESHES.items()}
    limits = {d: richardson([r["tip"] for r in rows]) for d, rows in mesh.items()}
    fe = limits[2][0]
    slab_fe, slab_coarse = of(SLAB), of(SLAB_COARSE)
    block = {s: [of(lattice(n, s)) for n in sizes] for s, sizes in BLOCKS.items()}
    beam_mesh = [of(tissue_beam(m)) for m in BEAM_MESHES]
    beam_fe = richardson([r["tip"] for r in beam_mesh])[0]
    beam = {s: [of(lattice_beam(n, s)) for n in sizes] for s, sizes in BEAM.items()}
    soft = {k: (of(tissue(16, 2, modulus=k)), [of(lattice(n, "frozen", k)) for n in (16, 32)]) for k in MODULI}

    def percent(tip, against=fe):
        return 100. * (tip / against - 1.)

    with open(os.path.join(OUT, "static.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["model", "kind", "fluid_modulus [Pa]", "n", "tip_over_width [1]", "against_fe2_limit [%]",
                        "pressure_min [Pa]", "pressure_max [Pa]", "newton_iterations [1]", "cpu_time [s]"])

        def row(model, kind, n, r, against, modulus="6e6"):
            table.writerow([model, kind, modulus, n, f"{r['tip']:.7f}", f"{percent(r['tip'], against):.3f}",
                            f"{r['pressure_min']:.0f}", f"{r['pressure_max']:.0f}", f"{r['iterations']:.0f}",
                            f"{r['cpu']:.2f}"])

        for d, sizes in MESHES.items():
            for m, r in zip(sizes, mesh[d]):
                row("fe2", f"degree {d}", m, r, fe)
        row("fe2", "degree 2 periodic", 16, slab_fe, slab_fe["tip"])
        row("fe2", "degree 1 periodic", 8, slab_coarse, slab_fe["tip"])
        for s, sizes in BLOCKS.items():
            for n, r in zip(sizes, block[s]):
                row("lattice", s, n, r, slab_fe["tip"] if s == "slab" else fe)
        for m, r in zip(BEAM_MESHES, beam_mesh):
            row("fe2", "degree 2, beam 3 : 1", m, r, beam_fe)
        for s, sizes in BEAM.items():
            for n, r in zip(sizes, beam[s]):
                row("lattice", f"{s}, beam 3 : 1", n, r, beam_fe)
        for k, (r, blocks) in soft.items():
            row("fe2", "degree 2", 16, r, r["tip"], k)
            for n, b in zip((16, 32), blocks):
                row("lattice", "frozen", n, b, r["tip"], k)

    with open(os.path.join(OUT, "limits.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["what", "fit", "limit_tip_over_width [1]", "against_fe2_limit [%]"])
        for d, (limit, order) in limits.items():
            table.writerow([f"fe2 degree {d}", f"observed order {order:.2f} in 1/m", f"{limit:.7f}",
                            f"{percent(limit):.3f}"])
        for s, sizes in BLOCKS.items():
            tips = [r["tip"] for r in block[s]]
            fits = {"1/n^2": [-2]} if s == "slab" else {"1/n": [-1], "1/n + 1/n^2": [-1, -2]}
            for name, powers in fits.items():
                limit = limit_in_cells(sizes, tips, powers)[0]
                table.writerow([f"lattice {s}", f"{name} through the largest {len(powers) + 1}", f"{limit:.7f}",
                                f"{percent(limit, slab_fe['tip'] if s == 'slab' else fe):.3f}"])

        for s, sizes in BEAM.items():
            tips = [r["tip"] for r in beam[s]]
            for name, powers in {"1/n": [-1], "1/n + 1/n^2": [-1, -2]}.items():
                limit = limit_in_cells(sizes, tips, powers)[0]
                table.writerow([f"lattice {s}, beam 3 : 1", f"{name} through the largest {len(powers) + 1}", f"{limit:.7f}",
                                f"{percent(limit, beam_fe):.3f}"])

    figure, (left, right, third) = plt.subplots(1, 3, figsize=(16, 4.4))
    for d, sizes in MESHES.items():
        errors = [-percent(r["tip"]) for r in mesh[d]]
        left.loglog(sizes, errors, "os"[d - 1] + "-", label=f"FE², degree {d} (order {limits[d][1]:.1f})")
    n = numpy.array(BLOCKS["slab"], float)
    errors = numpy.array([percent(r["tip"], slab_fe["tip"]) for r in block["slab"]])
    left.loglog(n, errors, "^-", color="tab:green", label="every cell, slab, against FE²")
    left.loglog(n, errors[1] * (n[1] / n) ** 2, ":", color="0.5", label="second order")
    left.set_xlabel("elements or cells along a side")
    left.set_ylabel("error of the tip [%]")
    left.set_title("What vanishes: mesh and homogenisation")
    left.set_xticks([4, 8, 16, 32], ["4", "8", "16", "32"])
    left.minorticks_off()
    left.legend(fontsize=8)
    left.grid(True, alpha=0.3)

    fine = numpy.linspace(0., 1. / 16., 100)
    colours = (("free", "tab:red"), ("osmosis", "tab:orange"), ("frozen", "tab:blue"))
    for s, colour in colours:
        sizes, tips = BLOCKS[s], [percent(r["tip"]) for r in block[s]]
        shown = [i for i, size in enumerate(sizes) if size >= 8]
        a, b, c = limit_in_cells(sizes, tips, [-1, -2])
        right.plot([1. / sizes[i] for i in shown], [tips[i] for i in shown], "o-", color=colour, label=s)
        right.plot(fine, a + b * fine + c * fine ** 2, ":", color=colour)
    right.axhline(0., color="k", lw=1, label="FE² limit")
    right.set_ylim(-3., 16.)
    right.annotate("free, 8 × 8: "
                   f"{percent(block['free'][1]['tip']):+.0f} %", (0.125, 16.), (0.075, 14.6), fontsize=8)
    sizes = [8, 16, 32, 64]
    right.set_xticks([1. / size for size in sizes] + [0.], [f"1/{size}" for size in sizes] + ["0"])
    right.set_xlabel("1/n, cells along a side")
    right.set_ylabel("tip against the FE² limit [%]")
    right.set_title("What surfaces do to a square (dotted: a + b/n + c/n²)")
    right.legend(fontsize=8, loc="upper left")
    right.grid(True, alpha=0.3)
    for s, colour in colours:
        sizes, tips = BEAM[s], [percent(r["tip"], beam_fe) for r in beam[s]]
        third.plot([1. / size for size in sizes], tips, "o-", color=colour, label=s)
    third.axhline(0., color="k", lw=1, label="FE² limit")
    third.set_xticks([1. / size for size in BEAM["free"]] + [0.], [f"1/{size}" for size in BEAM["free"]] + ["0"])
    third.set_xlim(0., 0.26)
    third.set_xlabel("1/n, cells across the beam")
    third.set_ylabel("tip against the FE² limit [%]")
    third.set_title("What surfaces do to a beam, 3n × n cells")
    third.grid(True, alpha=0.3)
    third.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(os.path.join(OUT, "static.png"), dpi=120)


if __name__ == "__main__":
    no_choice(__doc__)
    main()
