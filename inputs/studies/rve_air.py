#!/usr/bin/python3
"""RVEs of sparse tissue: air spaces against moduli and compression, one table.

    /usr/bin/python3 inputs/studies/rve_air.py        writes doc/results/rve/air.md, a minute of CPU time

100 um before turgor, 12 nodes a side, lamella ratio 1, turgor 200 kPa, one cell; air at p = 0, free to leave. Moduli of the undeformed tissue in
kPa, held: stress over strain along y with sides held; pressed along y in steps of 1 %: nominal stress in kPa at 5, 10, 20 %, sides free and held;
air closed at: compression with held sides at which no air is left. The last row of bricks has 24 nodes a side: there the trial of general cells,
whose first tie is then at 20.8 um, has 108, 231, 663 kPa.
"""
import csv
import os

from runs import ROOT, no_choice, results, study

CELL = {"Cell/Period": 100e-6, "Cell/Lamella ratio": 1, "Cell/Fluid viscosity": 0, "Path/F_dot": "0, 0; 0, 0", "Path/Points": 21,
        "Path/Keyframes": "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.8"}
TISSUES = [("brick", gap, 12) for gap in (0, 5, 10, 15, 20, 24)] + [("brick", 20, 24)] + [
    ("hexagon", gap, 12) for gap in (0, 10, 20)] + [("square", gap, 12) for gap in (10, 20)]
SIDES = {"free": "xx", "held": "none"}


def label(tissue, sides):
    return "_".join(str(word) for word in (*tissue, sides))


def wanted():
    for tissue in TISSUES:
        for sides, found in SIDES.items():
            kind, gap, nodes = tissue
            yield label(tissue, sides), "rve_response", {**CELL, "Structure/Structure": kind, "Structure/Gap": gap * 1e-6, "Cell/Nodes per side": nodes,
                                                         "Path/Stress components": found}


def curve(run, name):
    with open(os.path.join(run["directory"], "stress.csv"), newline="", encoding="utf-8") as file:
        rows = [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    return [row[name] for row in rows] if name in rows[0] else [0.0] * len(rows)


def pressed(run):
    stress = curve(run, "P_yy")
    return " / ".join(f"{-stress[percent] / 1e3:.{0 if stress[percent] < -1e5 else 1}f}" if percent < len(stress) else "-" for percent in (5, 10, 20))


def closed(run):
    air = curve(run, "air_share")
    for percent in range(1, len(air)):
        if air[percent] <= 0 < air[percent - 1]:
            return f"{percent - 1 + air[percent - 1] / (air[percent - 1] - air[percent]):.1f} %"
    return "-"


def main():
    no_choice(__doc__)
    runs = study("rve_air", list(wanted()))
    lines = ["| cells | gap, um | nodes a side | air | E_x | E_y | E_45 | held | free 5 / 10 / 20 % | held 5 / 10 / 20 % | air closed at |",
             "|---|---|---|---|---|---|---|---|---|---|---|"]
    for tissue in TISSUES:
        free, held = (runs[label(tissue, sides)] for sides in SIDES)
        found = results(free)
        moduli = " | ".join(f"{found[name] / 1e3:.0f}" for name in ("modulus_x", "modulus_y", "modulus_45", "held_modulus_y"))
        lines.append(f"| {tissue[0]} | {tissue[1]} | {tissue[2]} | {found.get('air_share_at_rest', 0):.3f} | {moduli} | {pressed(free)} | "
                     f"{pressed(held)} | {closed(held)} |")
    lines += [f"\n{name} did not finish: {run['message']}" for name, run in runs.items() if run["status"] != "finished"]
    head, _, rest = __doc__.partition("\n\n")
    text = ["# " + head, "", *rest.strip().split("\n"), "", *lines]
    with open(os.path.join(ROOT, "doc", "results", "rve", "air.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(text) + "\n")
    print("\n".join(text))


if __name__ == "__main__":
    main()
