#!/usr/bin/python3
"""What FE2 of struck bricks has to cost: how few elements, and what leaving out RVE calls saves, before the forces of the plates change by 2 %.

Verdict: two elements a row of bricks are the coarsest within 2 % of the limit (dense 1.4, sparse 1.6 %); one a row, 2.8 and 3.1 %, is not. There a
strip of 2 cells across costs particles 52 x FE2 if it is dense, RVE calls are skipped and no fields are written, 1.1 x if it is sparse: 1000 x is missed. What FE2
costs does not depend on the cells across, as nothing does across such a strip, so that wider strips would pay more, 1000 x from 39 dense cells
across on and never within 24 sparse ones (13 x): a projection from the 2 cells that were run. Of the process the loader takes 0.35 s more (performance.md).

    /usr/bin/python3 inputs/studies/brick_strips_cost.py        writes doc/results/rve/strips_cost.md and strips_cost.png
    /usr/bin/python3 inputs/studies/brick_strips_cost.py draw   the picture alone, from the tables that are there

The strip of 24 rows of brick_strips.py, struck at 5 m/s with its sides held, as FE2: two elements across as there (the fewest that periodic sides
take), n along, the piece as wide as makes the elements square but no narrower than there (the step is that of the shorter side, and nothing depends
on the place across); Skipping = certified for dense tissue (air spaces refuse it); without the 120 fields that a run of strips.md writes for pictures. Error: of the
mean over 0 to 4, 4 to 8, 8 to 12 % of strain of the force on either plate, the largest of the six, against the limit of the two
finest, whose error is of first order (twice 96 elements less 48); a plate that no front has reached (a mean below 1 kPa) is left out. Particles: the strip of 2 bricks by 24 rows.
"""
import argparse
import os
import sys

from brick_strips import STRUCK, TISSUES, WINDOWS, alone, mean_between, table
from brick_strips import wanted as strips
from runs import ROOT, results, study

ROWS = STRUCK[-1]
ELEMENTS = (4 * ROWS, 2 * ROWS, ROWS, ROWS // 2, ROWS // 3, ROWS // 4, ROWS // 6)  # along, the finest first
NARROWEST = 2e-4  # m
COLUMNS = 2  # of the particles


def wanted(tissue, row):
    base = {name: (scene, entries) for name, scene, entries in strips(tissue, row)}
    yield (f"{tissue}_particles", *base[f"{tissue}_struck_{ROWS}"])
    scene, entries = base[f"{tissue}_struck_fe2_{ROWS}"]
    for along in ELEMENTS:
        mesh = {**entries, "Tissue/Elements x": along, "Tissue/Height": width(along, row)}
        yield f"{tissue}_{along}", scene, mesh
        bare = {**mesh, "Time/Output interval": entries["Time/End time"]}
        if tissue == "dense":
            yield f"{tissue}_{along}_skipped", scene, {**mesh, "Skipping/Skipping": "certified"}
            bare["Skipping/Skipping"] = "certified"
        if along <= 2 * ROWS:
            yield f"{tissue}_{along}{'_skipped' if tissue == 'dense' else ''}_bare", scene, bare


def width(along, row):
    return max(NARROWEST, 2 * ROWS * row / along)


def forces(run, along, row):
    """Mean nominal stress (kPa) on the plate that hits and on the other in each window of strain."""
    hit = table(run, "impact.csv")
    strain = [way / (ROWS * row) for way in hit["travel"]]
    return [mean_between(strain, [f / width(along, row) / 1e3 for f in hit[name]], *window) for window in WINDOWS for name in ("force", "transmitted_force")]


def lines_of(tissue, runs, row):
    finest, next_finest = (forces(runs[f"{tissue}_{along}"], along, row) for along in ELEMENTS[:2])
    limit = [2 * a - b for a, b in zip(finest, next_finest)]
    particles = float(runs[f"{tissue}_particles"]["cpu_time_s"])
    yield f"| {tissue}: elements along | RVE calls | largest error | CPU s | particles over it | the same for each cell across | 24 cells across, projected |"
    yield "|---|---|---|---|---|---|---|"
    for name, run in runs.items():
        if not name.startswith(tissue) or name.endswith("particles"):
            continue
        along = int(name.split("_")[1])
        error = max(abs(a / b - 1) for a, b in zip(forces(run, along, row), limit) if b > 1)
        cost = float(run["cpu_time_s"])
        label = f"{along}{', calls skipped' if 'skipped' in name else ''}{', no fields' if name.endswith('bare') else ''}"
        yield (f"| {label} | {results(run)['rve_calls']:.0f} | {100 * error:.2g} % | {cost:.3g} | {particles / cost:.3g} | {particles / COLUMNS / cost:.3g} | "
               f"{particles / COLUMNS * ROWS / cost:.3g} |")
    yield f"| particles, {COLUMNS} x {ROWS} bricks | | | {particles:.3g} | | | |"


def cases(text):
    """{tissue: ({kind of run: [(elements, CPU s, error in %)]}, CPU s of the particles)} of the tables of strips_cost.md."""
    found, tissue = {}, None
    for line in text.split("\n"):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if ": elements along" in cells[0]:
            tissue = cells[0].split(":")[0]
            found[tissue] = ({}, None)
        elif tissue and cells[0].startswith("particles, "):
            found[tissue] = (found[tissue][0], float(cells[3]))
        elif tissue and cells[0][:1].isdigit():
            elements, _, kind = cells[0].partition(", ")
            found[tissue][0].setdefault(kind, []).append((int(elements), float(cells[3]), float(cells[2].rstrip(" %"))))
    return found


KINDS = {"": ("every RVE called, 120 frames of fields written", "#b03a2e", "o"), "calls skipped": ("RVE calls skipped, fields written", "#2e6f9e", "s"),
         "calls skipped, no fields": ("RVE calls skipped, no fields", "#3f8f7f", "D"), "no fields": ("every RVE called, no fields", "#d08a2e", "^")}


def draw(text, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
    from drawing import INK, style
    figure, all_axes = plt.subplots(1, 2, figsize=(12.5, 5.4), sharey=True, constrained_layout=True)
    for axis, (tissue, (kinds, particles)) in zip(all_axes, cases(text).items()):
        for kind, points in kinds.items():
            words, colour, marker = KINDS[kind]
            axis.plot([cpu for _, cpu, _ in points], [error for _, _, error in points], color=colour, marker=marker, markersize=5, linewidth=1, label=words)
            for elements, cpu, error in points:
                axis.annotate(str(elements), (cpu, error), xytext=(-5, -9) if kind == "no fields" else (5, 4), textcoords="offset points",
                              fontsize=7.5, color=colour, ha="right" if kind == "no fields" else "left")
        axis.axhline(2, color=INK, linewidth=0.8, linestyle=":")
        axis.annotate("2 % allowed", (0, 2), xycoords=("axes fraction", "data"), xytext=(4, 3), textcoords="offset points", fontsize=8.5, color=INK)
        axis.axvline(particles, color=INK, linewidth=1.2)
        axis.annotate(f"all cells as particles, {COLUMNS} x {ROWS}: {particles:g} s", (particles, 0.97), xycoords=("data", "axes fraction"), xytext=(-4, 0),
                      textcoords="offset points", fontsize=8.5, color=INK, ha="right", va="top", rotation=90)
        axis.set_xscale("log")
        axis.set_xlim(0.02, 100)
        axis.set_ylim(-0.6, 21.5)
        axis.set_xticks([0.03, 0.1, 0.3, 1, 3, 10, 30, 100], ["0.03", "0.1", "0.3", "1", "3", "10", "30", "100"])
        axis.minorticks_off()
        axis.set_title(f"{tissue} tissue" + (" (air between the cells)" if tissue == "sparse" else ""), fontsize=11, color=INK)
        axis.set_xlabel("CPU time of the whole run [s]", color=INK)
        axis.legend(frameon=False, fontsize=8.5, loc="upper left")
        style(axis)
    all_axes[0].set_ylabel("largest change of a plate's mean force\nagainst the limit of fine meshes [%]", color=INK)
    figure.suptitle(f"How few elements does FE² need? A strip of {ROWS} rows of bricks struck at 5 m/s: error over cost\n(numbers at the points: elements along "
                    "the strip; left and low is good)", fontsize=11.5, color=INK)
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="?", choices=["draw"], help="the picture alone")
    folder = os.path.join(ROOT, "doc", "results", "rve")
    if parser.parse_args().what == "draw":
        with open(os.path.join(folder, "strips_cost.md"), encoding="utf-8") as file:
            return draw(file.read(), os.path.join(folder, "strips_cost.png"))
    reference = study("brick_strips_cost_alone", [run for tissue in TISSUES for run in alone(tissue) if run[0].endswith("_rve")])
    row = {tissue: results(reference[f"{tissue}_rve"])["period_yy"] for tissue in TISSUES}
    runs = study("brick_strips_cost", [run for tissue in TISSUES for run in wanted(tissue, row[tissue])])
    for name, run in runs.items():
        if run["status"] != "finished":
            raise SystemExit(f"{name}: {run['message']}")
    lines = __doc__.strip().split("\n")
    for tissue in TISSUES:
        lines += ["", *lines_of(tissue, runs, row[tissue])]
    lines += ["", NOTES]
    with open(os.path.join(folder, "strips_cost.md"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")
    draw("\n".join(lines), os.path.join(folder, "strips_cost.png"))
    print("\n".join(lines))


NOTES = """![Error over CPU time for each number of elements](strips_cost.png)

- Skipped calls: with 48 elements 441 600 become 1156, with 24 121 536 become 434; no error changes by a digit that is shown while fields are written.
- Errors halve with twice the elements, at the other plate and in the first window most: fronts get as wide as elements.
- The step is the longest that is stable (explicit); it grows with the elements.
- Sparse: an RVE with contact takes some 40 us a call, 3 times the dense one, and is called at every point in every step, since tissue with air refuses
  Skipping (its table takes all of the area for cells, doc/skipping.md)."""

if __name__ == "__main__":
    main()
