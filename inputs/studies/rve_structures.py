#!/usr/bin/python3
"""RVEs of hexagons, bricks and Laguerre cells against the trial of general cells: moduli and large compression, one table.

    /usr/bin/python3 inputs/studies/rve_structures.py        writes doc/results/rve/structures.md, a minute of CPU time

100 um before turgor, 12 nodes a side, lamella ratio 1, turgor 200 kPa, dense; steps of 1 %, nominal stress in kPa. The trial's numbers are those of
the network made for it (its own code, the same wall, fluid and ties); its Voronoi tissues are other random ones, so that only their range means
something. A row of several seeds is the mean, +- half of the range. Agreement is at this resolution: with 24 nodes and ratio 1 C_yy is 9 % larger (45.5 MPa,
hexagon and brick; E +1 to 2 %), for a lamella of a fixed ratio is stiffer the finer the walls are; with ratio 0.25, the same lamella, it is within 0.7 %.

Rows with held sides are as soft as their ties: a lamella of ratio 1, which the trial has, gives way where a wall of many nodes would not. Bricks with ratio 1, 4, 16, 64: C_yy 41.7, 45.6, 46.7, 47.0 MPa, held at 5, 10, 20 %
2412, 2717, 2808, 2831; 5537, 6523, 6846, 6933; 14568, 20116, 22571, 23306 kPa: 15, 20 and 38 % below stiff ties. With free sides E changes by 0.4 %
(`./turgor run inputs/rve_response.prm --set Structure/Structure=brick --set RVE/Fluid=hydrostatic --set 'Cell/Nodes per side=12' --set 'Cell/Lamella ratio=16' --set 'Cell/Fluid viscosity=0' --set 'Path/F_dot=0, 0; 0, 0' --set 'Path/Keyframes=0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.8'`).
"""
import csv
import os

from runs import ROOT, no_choice, results, study

CELL = {"Cell/Period": 100e-6, "Cell/Nodes per side": 12, "Cell/Lamella ratio": 1, "Cell/Fluid viscosity": 0, "Path/F_dot": "0, 0; 0, 0"}
PATHS = {"along y, sides free": ("0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.8", "xx", "P_yy", -1, 21, (5, 10, 20)),
         "along x, sides free": ("0 : 1, 0; 0, 1 | 1 : 0.8, 0; 0, 1", "yy", "P_xx", -1, 21, (5, 10, 20)),
         "along y, sides held": ("0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.8", "none", "P_yy", -1, 21, (5, 10, 20)),
         "shear": ("0 : 1, 0; 0, 1 | 1 : 1, 0.3; 0, 1", "none", "sigma_xy", 1, 31, (5, 10, 20, 30))}
MODULI = [("E_x", "modulus_x", 1e3), ("E_y", "modulus_y", 1e3), ("E_45", "modulus_45", 1e3), ("mu along axes", "shear_modulus_axes", 1e3),
          ("mu at 45 degrees", "shear_modulus_45", 1e3), ("C_yy, MPa", "held_modulus_y", 1e6)]
# name: (structure, cells along each side, entries, seeds, moduli of the trial, compression and shear of the trial)
TISSUES = {
    "hexagon": ("hexagon", 1, {}, (1,), (1180, 1180, 1180, 297, 297, 41.3), {
        "along y, sides free": (73, 212, 958), "along x, sides free": (66, 174, 677), "along y, sides held": (2395, 5452, 14240),
        "shear": (15.3, 33.5, 89, 187)}),
    "hexagon 2x2": ("hexagon", 2, {}, (1,), (1180, 1180, 1180, 297, 297, 41.3), {}),
    "brick": ("brick", 1, {}, (1,), (1779, 1782, 942, 450, 237, 41.7), {
        "along y, sides free": (121, 376, 1429), "along x, sides free": (96, 248, 907), "along y, sides held": (2412, 5537, 14568),
        "shear": (12.1, 26.2, 68, 141)}),
    "brick 2x2, jitter 0.06": ("brick", 2, {"Structure/Corner jitter": 0.06}, (1, 2, 3), (1792, 1795, 947, 453, 238, 41.6), {
        "along y, sides free": (121, 378, 1423), "along x, sides free": (97, 250, 914)}),
    "brick 4x4, jitter 0.06": ("brick", 4, {"Structure/Corner jitter": 0.06}, (1, 2, 3), (1795, 1798, 950, 454, 239, 41.6), {
        "along y, sides free": (122, 377, 1421), "along x, sides free": (97, 250, 913)}),
    "voronoi 4x4": ("voronoi", 4, {}, (1, 2, 3), (1423, 1423, 1552, 363, 397, 41.6), {
        "along y, sides free": (84, 231, 864), "along x, sides free": (85, 235, 923)}),
}


def label(tissue, seed, path):
    return f"{tissue}, {seed}, {path}".replace(".", "_").replace(", ", "-").replace(" ", "_")


def wanted():
    for tissue, (structure, n, more, seeds, _, trial) in TISSUES.items():
        for seed in seeds:
            for path in trial or ["shear"]:
                way, free, _, _, points, _ = PATHS[path]
                yield label(tissue, seed, path), "rve_response", {
                    **CELL, "Structure/Structure": structure, "Structure/Structure seed": seed, "RVE/Columns": n, "RVE/Rows": n, "Path/Keyframes": way,
                    "Path/Stress components": free, "Path/Points": points, **more}


def curve(run, path):
    _, _, column, sign, _, percents = PATHS[path]
    with open(os.path.join(run["directory"], "stress.csv"), newline="", encoding="utf-8") as file:
        rows = [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    return [sign * rows[percent][column] / 1e3 for percent in percents]


def cells(found, trial):
    """found: one list a seed. (found, trial, difference) as text, number by number."""
    for values, wanted_value in zip(zip(*found), trial):
        mean, half = sum(values) / len(values), (max(values) - min(values)) / 2
        text = f"{mean:.4g}" + (f" +- {half:.2g}" if len(values) > 1 else "")
        yield text, f"{wanted_value:g}", f"{100 * (mean / wanted_value - 1):+.1f} %"


def rows(runs):
    for tissue, (_, _, _, seeds, moduli, trial) in TISSUES.items():
        first = next(iter(trial or ["shear"]))
        found = [[results(runs[label(tissue, seed, first)])[name] / scale for _, name, scale in MODULI] for seed in seeds]
        for (name, _, _), cell in zip(MODULI, cells(found, moduli)):
            yield (tissue, name, *cell)
        for path, numbers in trial.items():
            answers = [curve(runs[label(tissue, seed, path)], path) for seed in seeds]
            for percent, cell in zip(PATHS[path][5], cells(answers, numbers)):
                yield (tissue, f"{path}, {percent} %", *cell)


def main():
    no_choice(__doc__)
    runs = study("rve_structures", list(wanted()))
    failed = [f"{name}: {run['message']}" for name, run in runs.items() if run["status"] != "finished"]
    if failed:
        raise SystemExit("\n".join(failed))
    head, _, rest = __doc__.partition("\n\n")
    lines = ["# " + head, "", *rest.strip().split("\n"), "", "| tissue | kPa | found | trial | difference |", "|---|---|---|---|---|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows(runs)]
    with open(os.path.join(ROOT, "doc", "results", "rve", "structures.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
