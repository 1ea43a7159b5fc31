#!/usr/bin/python3
"""Tissue pulled and pressed: stress against strain with free sides, and how far the tissue is from sliding in a band, of squares, hexagons, bricks
and Laguerre cells.

    /usr/bin/python3 inputs/studies/rve_asymmetry.py        writes doc/results/rve/asymmetry.md, asymmetry.csv and asymmetry.png, a minute of CPU time

100 um before turgor, 12 nodes a side, lamella ratio 1, turgor 200 kPa, dense; 15 % along y in steps of 1 %, sides free to widen or narrow, no
rotation of lines along x. Laguerre cells: 3 x 3, three seeds. Nominal stress; the asymmetry is the stress pressed over the stress pulled, at the same
strain. A run that ends before 15 % says why below the table.
"""
import csv
import os
import sys

from runs import ROOT, no_choice, study, write_table

sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
CELL = {"Cell/Period": 100e-6, "Cell/Nodes per side": 12, "Cell/Lamella ratio": 1, "Cell/Fluid viscosity": 0, "Path/F_dot": "0, 0; 0, 0", "Path/Points": 16,
        "Path/Stress components": "xx"}
TISSUES = {"square": (1, (1,)), "hexagon": (1, (1,)), "brick": (1, (1,)), "voronoi": (3, (1, 2, 3))}
WAYS = {"pressed": 0.85, "pulled": 1.15}


def label(tissue, seed, way):
    return f"{tissue}_{seed}_{way}"


def rows_of(run, name):
    with open(os.path.join(run["directory"], name + ".csv"), newline="", encoding="utf-8") as file:
        return [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def curve(run):
    """[(strain %, stress kPa, acoustic kPa or None)]"""
    acoustic = {row["time"]: row["acoustic"] / 1e3 for row in rows_of(run, "tangent")}
    return [(100 * (row["F_yy"] - 1), row["P_yy"] / 1e3, acoustic.get(row["time"])) for row in rows_of(run, "stress")]


def draw(curves):
    from drawing import ACCENT, ALONG, INK, plt, style
    colours = {"square": INK, "hexagon": "#8a6fb0", "brick": ACCENT, "voronoi": ALONG}
    figure, axes = plt.subplots(1, 2, figsize=(12, 4.8), layout="constrained")
    for tissue, (_, seeds) in TISSUES.items():
        for seed in seeds:
            both = curves[tissue, seed, "pressed"][::-1] + curves[tissue, seed, "pulled"][1:]
            name = f"{tissue}, {len(seeds)} seeds" if len(seeds) > 1 else tissue
            for axis, column in zip(axes, (1, 2)):
                points = [point for point in both if point[column] is not None]
                axis.plot([p[0] for p in points], [p[column] for p in points], color=colours[tissue], linewidth=1.8 if len(seeds) == 1 else 1.1,
                          label=name if seed == seeds[0] else None)
    axes[0].set_ylabel("nominal stress along y, positive in tension [kPa]", color=INK)
    axes[1].set_ylabel("smallest eigenvalue of the acoustic tensor [kPa]", color=INK)
    for axis in axes:
        axis.axhline(0, color=INK, linewidth=0.7)
        axis.axvline(0, color=INK, linewidth=0.7)
        axis.set_xlabel("strain along y: pressed < 0 < pulled [%]", color=INK)
        style(axis)
    axes[0].legend(frameon=False, fontsize=9)
    figure.suptitle("Tissue at turgor pulled and pressed along y, sides free: stress, and (right) how far it is from sliding in a band (below zero: "
                    "it slides)", color=INK, fontsize=11)
    figure.savefig(os.path.join(ROOT, "doc", "results", "rve", "asymmetry.png"), dpi=110)
    plt.close(figure)


def main():
    no_choice(__doc__)
    runs = study("rve_asymmetry", [
        (label(tissue, seed, way), "rve_response", {**CELL, "Structure/Structure": tissue, "Structure/Structure seed": seed, "RVE/Columns": n,
                                                    "RVE/Rows": n, "Path/Keyframes": f"0 : 1, 0; 0, 1 | 1 : 1, 0; 0, {F}"})
        for tissue, (n, seeds) in TISSUES.items() for seed in seeds for way, F in WAYS.items()])
    curves = {(tissue, seed, way): curve(runs[label(tissue, seed, way)]) for tissue, (_, seeds) in TISSUES.items() for seed in seeds for way in WAYS}
    rows = []
    for tissue, (_, seeds) in TISSUES.items():
        for seed in seeds:
            pressed, pulled = curves[tissue, seed, "pressed"], curves[tissue, seed, "pulled"]
            for percent in (2, 5, 10, 15):
                if percent < min(len(pressed), len(pulled)):
                    rows.append({"tissue": tissue, "seed": seed, "strain_percent": percent, "pressed_kPa": f"{-pressed[percent][1]:.4g}",
                                 "pulled_kPa": f"{pulled[percent][1]:.4g}", "pressed_over_pulled": f"{-pressed[percent][1] / pulled[percent][1]:.3g}",
                                 "acoustic_pressed_kPa": "" if pressed[percent][2] is None else f"{pressed[percent][2]:.4g}",
                                 "acoustic_pulled_kPa": "" if pulled[percent][2] is None else f"{pulled[percent][2]:.4g}"})
    write_table("rve/asymmetry.csv", rows)
    head, _, rest = __doc__.partition("\n\n")
    lines = ["# " + head.replace("\n", " "), "", *rest.strip().split("\n"), "", "![pulled and pressed](asymmetry.png)", "",
             "| tissue | seed | strain, % | pressed, kPa | pulled, kPa | pressed over pulled | acoustic, pressed, kPa | acoustic, pulled, kPa |",
             "|---|---|---|---|---|---|---|---|"]
    lines += ["| " + " | ".join(str(value) for value in row.values()) + " |" for row in rows]
    lines += [""] + [f"{name}: {run['message']}" for name, run in runs.items() if run["status"] != "finished"]
    with open(os.path.join(ROOT, "doc", "results", "rve", "asymmetry.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines).rstrip() + "\n")
    print("\n".join(lines))
    draw(curves)


if __name__ == "__main__":
    main()
