#!/usr/bin/python3
"""From a label image to stress-strain with a band: two pictures of about 200 cells, each to RVEs with its mean area and scatter.

    /usr/bin/python3 inputs/studies/label_image.py     writes doc/results/rve/image.md and image.png, half a minute of CPU time

Both pictures are grey PNG of 16 bits, 2 um a pixel. `laguerre`: 14 x 14 cells that the program itself laid and brought to turgor (cells.csv of an RVE),
drawn whole, parted by lines of one pixel without a label. `ragged`: made by this script alone, nearest of 260 random places relaxed twice, the edges
made ragged by noise, with cells on the border, a cell that is missing and a cell with a hole. It is refused as it is and mended as the sentence says,
until it is read.

The RVE is a random (Laguerre) tissue that takes two numbers from the picture, mean area and scatter of the areas; it has none of the picture's own cells,
and nothing of their aspect, contacts and air spaces. `by hand`: Structure = voronoi with these two numbers of the polygons that the first picture was
drawn from, which never saw a pixel. `own cells`: that picture's 196 cells themselves, one run (100 um before turgor, 103 um in the picture, which the
others take as before turgor).

16 cells (4 x 4), 12 nodes a side, lamella ratio 1, turgor 200 kPa, dense, pressed along y to 20 % in steps of 1 % with free sides; four seeds, mean and
95 % confidence of the mean (Student's t). Moduli at rest, means over all directions.
"""
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

from label_pictures import PIXEL, SIDES, beside, drawn_picture, holes_filled, pieces_joined, ragged_picture, without_border_cells, write_png
from rve_size import CELL, checked, mean_and_band, numbers, rows_of
from runs import PROGRAM, ROOT, no_choice, results, study

sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
FOLDER = os.path.join(ROOT, "runs", "label_image")
SEEDS = (1, 2, 3, 4)
STRAINS = (5, 10, 20)
OWN = {"Structure/Structure": "voronoi", "RVE/Columns": 14, "RVE/Rows": 14}
AT_REST = {"Path/F": "1, 0; 0, 1", "Path/F_dot": "0, 0; 0, 0", "Path/Stress components": "none", "Path/Tangents": "false"}
MENDED = (("touches the border", "cells on the border left out", without_border_cells),
          ("lies in two pieces", "stray pixels given to the cell beside them", pieces_joined),
          ("has a hole", "holes filled with the label around them", holes_filled))
PRESSED = {**CELL, "RVE/Columns": 4, "RVE/Rows": 4, "Path/Points": 21, "Path/Keyframes": "0 : 1, 0; 0, 1 | 1 : 1, 0; 0, 0.8"}


def laid():
    """Cells that the program laid and brought to turgor, as rows (cell, x, y)."""
    entries = {entry: value for entry, value in {**CELL, **OWN}.items() if not entry.startswith("Path/")}
    run = checked(study("label_image_cells", [("cells", "rve_response", {**entries, **AT_REST})]))["cells"]
    return [(row["cell"], row["x"], row["y"]) for row in rows_of(run, "cells")]


def sentence(file):
    """What the program says of the picture; empty where it reads it."""
    with tempfile.TemporaryDirectory() as place:
        said = subprocess.run([PROGRAM, "run", os.path.join(ROOT, "inputs", "rve_response.prm"), "-o", os.path.join(place, "run"), "--quiet",
                               *(f for entry, value in {**CELL, **like_picture(file), **AT_REST}.items()
                                 for f in ("--set", f"{entry}={value}"))], capture_output=True, text=True)
    return "" if said.returncode == 0 else said.stderr.strip().rpartition(os.path.basename(file) + ": ")[2]


def mended(labels, file):
    """Writes the picture as the program reads it: (labels, [(sentence, what was done)])."""
    told = []
    while True:
        write_png(file, labels)
        said = sentence(file)
        if not said:
            return labels, told
        does = [(done, mend) for words, done, mend in MENDED if words in said]
        if not does or len(told) == 10:
            raise SystemExit(said)
        done, mend = does[0]
        told.append((said, done))
        labels = mend(labels)


# What is measured


def like_picture(file):
    return {"Structure/Structure": "image", "Structure/Tissue file": file, "Structure/Pixel size": PIXEL}


def polygon_area(p):
    return 0.5 * abs(np.sum(p[:, 0] * np.roll(p[:, 1], -1) - np.roll(p[:, 0], -1) * p[:, 1]))


def counted(labels, areas=None):
    """Number, mean area, scatter and contacts, without the program: from pixels, or from areas that are known."""
    if areas is None:
        areas = PIXEL ** 2 * np.bincount(labels.ravel())[1:]
        areas = areas[areas > 0]
    pairs = set()
    for side in SIDES:
        other = beside(labels, side)
        at = (labels != 0) & (other != 0) & (labels != other)
        pairs |= set(zip(labels[at].tolist(), other[at].tolist()))
    return {"cells": len(areas), "area": np.mean(areas), "scatter": np.std(areas) / np.mean(areas), "contacts": len(pairs) / len(areas)}


def response(name, entries, seeds=SEEDS):
    """Found numbers, curves (kPa, one a seed), moduli and cost of the seeds."""
    rows = checked(study("label_image_" + name.replace(" ", "_"), [(f"seed_{seed}", "rve_response", {**PRESSED, **entries, "Structure/Structure seed": seed})
                                               for seed in seeds])).values()
    tables = [rows_of(run, "stress") for run in rows]
    first = [results(run) for run in rows]
    area = [(one["period_xx"] * one["period_yy"] - one["period_xy"] * one["period_yx"]) / (16 if len(seeds) > 1 else 196) for one in first]
    return {"strain": [100 * (1 - row["F_yy"]) for row in tables[0]], "curves": [[-row["P_yy"] / 1e3 for row in table] for table in tables],
            "moduli": [numbers(run) for run in rows], "found": first[0], "turgid": sum(area) / len(area),
            "cpu": sum(float(run["cpu_time_s"]) for run in rows), "wall": sum(float(run["wall_time_s"]) for run in rows)}


def with_band(values):
    if len(values) == 1:
        return f"{values[0]:.4g}"
    mean, band = mean_and_band(values)
    return f"{mean:.4g} +- {band:.2g}"


def at(found, strain):
    k = min(range(len(found["strain"])), key=lambda i: abs(found["strain"][i] - strain))
    return [curve[k] for curve in found["curves"]]


def taken_table(found, counts):
    yield "| picture | | cells | mean area [um^2] | scatter of areas | contacts a cell | void fraction | aspect | cell of the RVE at turgor [um^2] |"
    yield "|---|---|---|---|---|---|---|---|---|"
    for name, count in counts.items():
        got = found[name]["found"]
        yield (f"| {name} | program | {got['given_cells']:.0f} | {1e12 * got['given_mean_area']:.1f} | {got['given_area_scatter']:.4f} | {got['given_contacts']:.3f} | "
               f"{got['given_void_fraction']:.5f} | {got['given_aspect']:.3f} | {1e12 * found[name]['turgid']:.0f} |")
        yield f"| {name} | beside it | {count['cells']} | {1e12 * count['area']:.1f} | {count['scatter']:.4f} | {count['contacts']:.3f} | | | |"


def stress_table(found, mending):
    yield ("| RVE like | " + " | ".join(f"stress at {strain} % [kPa]" for strain in STRAINS) +
           " | Young's modulus [MPa] | shear modulus [kPa] | CPU of the runs [s] | mending, CPU [s] | wall clock of both [s] |")
    yield "|---" * (len(STRAINS) + 6) + "|"
    for name, one in found.items():
        cpu, wall = mending.get(name, (0, 0))
        yield (f"| {name} | " + " | ".join(with_band(at(one, strain)) for strain in STRAINS) + " | " +
               " | ".join(with_band([row[key] for row in one["moduli"]]) for key in ("young", "shear")) + f" | {one['cpu']:.1f} | {cpu:.1f} | {one['wall'] + wall:.1f} |")


WORDS = {"laguerre": "RVE from the picture laguerre", "ragged": "RVE from the picture ragged", "by hand": "laguerre, its two numbers by hand",
         "own cells": "laguerre, all its own 196 cells"}


def draw(pictures, found):
    from drawing import ACCENT, ALONG, INK, plt, style
    figure, axes = plt.subplots(1, 3, figsize=(16, 5.6), layout="constrained")
    for axis, (name, labels) in zip(axes, pictures.items()):
        shade = np.where(labels == 0, np.nan, 0.25 + 0.5 * ((labels * 7919) % 13) / 12)
        size = 1e6 * PIXEL * np.array([0, labels.shape[1], 0, labels.shape[0]])
        axis.imshow(shade, origin="lower", extent=size, cmap="Greens", vmin=0, vmax=1.3, interpolation="nearest")
        edges = np.any([beside(labels, side) != labels for side in SIDES], axis=0)
        axis.imshow(np.where(edges, 1.0, np.nan), origin="lower", extent=size, cmap="Greys", vmin=0, vmax=1.2, interpolation="nearest")
        axis.set_xlabel("x [µm]", color=INK)
        axis.set_ylabel("y [µm]", color=INK)
        axis.set_title(f"{name}: {found[name]['found']['given_cells']:.0f} cells, as the program reads it", color=INK, fontsize=11)
        style(axis)
    for (name, one), colour, line in zip(found.items(), (ALONG, ACCENT, INK, "#6b8e4e"), ("-", "-", "--", "-.")):
        values = list(zip(*one["curves"]))
        mean = [sum(some) / len(some) for some in values]
        axes[2].plot(one["strain"], mean, line, color=colour, linewidth=1.8, label=WORDS[name])
        if line == "-":
            bands = [mean_and_band(some)[1] for some in values]
            axes[2].fill_between(one["strain"], [m - b for m, b in zip(mean, bands)], [m + b for m, b in zip(mean, bands)], color=colour, alpha=0.18, linewidth=0)
    axes[2].set(xlim=(0, 20), ylim=(0, None))
    axes[2].set_xlabel("pressed along y [%], sides free", color=INK)
    axes[2].set_ylabel("stress over undeformed area [kPa]", color=INK)
    axes[2].set_title("16 random cells of that mean area and scatter", color=INK, fontsize=11)
    axes[2].legend(frameon=False, fontsize=9, loc="upper left")
    style(axes[2])
    figure.suptitle("Two label images, and what tissue with their mean area and scatter answers: mean of four seeds, band: 95 % confidence of the mean", color=INK, fontsize=12)
    figure.savefig(os.path.join(ROOT, "doc", "results", "rve", "image.png"), dpi=100)
    plt.close(figure)


def main():
    no_choice(__doc__)
    os.makedirs(FOLDER, exist_ok=True)
    lined, whole, polygons = drawn_picture(laid())
    pictures, told, mending = {"laguerre": lined, "ragged": ragged_picture()}, {}, {}
    for name, labels in pictures.items():
        cpu, wall = sum(os.times()[:4]), time.perf_counter()
        pictures[name], told[name] = mended(labels, os.path.join(FOLDER, name + ".png"))
        mending[name] = sum(os.times()[:4]) - cpu, time.perf_counter() - wall
    found = {name: response(name, like_picture(os.path.join(FOLDER, name + ".png"))) for name in pictures}
    counts = {"laguerre": {**counted(whole), **counted(whole, [polygon_area(p) for p in polygons])}, "ragged": counted(pictures["ragged"])}
    found["by hand"] = response("by hand", {"Structure/Structure": "voronoi", "Cell/Period": float(np.sqrt(counts["laguerre"]["area"])),
                                            "Structure/Area scatter": float(counts["laguerre"]["scatter"])})
    found["own cells"] = response("own cells", OWN, SEEDS[:1])
    head, _, rest = __doc__.partition("\n\n")
    lines = ["# " + head, "", *rest.strip().split("\n"), "", "![the two pictures and stress against strain](image.png)", "",
             "What the program finds in the pictures; beside it the same without the program: of `laguerre` from the polygons drawn, of `ragged` from its pixels "
             "(contacts of both from pixels, before lines were drawn). The last column is what turgor makes of the cells: the picture's area counts as that before turgor.", "",
             *taken_table(found, counts), "", *stress_table(found, mending), "",
             "Picture to band, CPU time: " + ", ".join(f"{name} {found[name]['cpu'] + mending[name][0]:.1f} s" for name in pictures) +
             " (mending includes writing the PNG and the program's sentences; wall clock: one run after the other, as the machine was). The seeds, and so "
             "places and order of the cells, are the same in the first three rows: their bands are not independent.", "",
             "## What was said of the pictures", ""]
    for name, sentences in told.items():
        lines += [f"`{name}`: " + ("read as it is." if not sentences else "read after"), ""]
        lines += [f"{k}. \"{said}\": {done}" for k, (said, done) in enumerate(sentences, 1)] + [""] * bool(sentences)
    with open(os.path.join(ROOT, "doc", "results", "rve", "image.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines).rstrip() + "\n")
    print("\n".join(lines))
    draw(pictures, found)


if __name__ == "__main__":
    main()
