"""Where the volume that a spheroid's growth makes goes: balance of a capsule run between two times after confluence.

  python3 inputs/studies/spheroid_budget.py LABEL=DIRECTORY ... [--from 48] [--to 168] [--csv FILE]

DIRECTORY: of a finished spheroid_capsule run. All rates as speeds of the capsule's wall, um/d: volume over time and over the mean inner surface.

  wall's speed = growth + lysis + compression + voids, each with its sign
  growth, lysis    uncompressed volume made by living cells (positive), lost by dying ones (negative; growth.csv: grown_volume, drained_volume)
  compression      change of the present over the uncompressed volume of all cells (negative while they are pressed together)
  voids            change of the space inside the capsule that no cell fills (spheres overlap: that space may be negative)
"""
import argparse
import csv
import json
import math
import os


def balance(directory, begin, end):
    """[(name, um/d)] of one run, and the wall's speed last."""
    with open(os.path.join(directory, "growth.csv"), encoding="utf-8") as file:
        rows = list(csv.reader(file))
    table = {name.split(" [")[0]: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}
    start = json.load(open(os.path.join(directory, "summary.json"), encoding="utf-8"))["results"]["confluence_time"]["value"]
    hours = [(t - start) / 3600 for t in table["time"]]
    first = min(range(len(hours)), key=lambda k: abs(hours[k] - begin))
    last = min(range(len(hours)), key=lambda k: abs(hours[k] - end))
    inside = [4 / 3 * math.pi * r**3 for r in table["capsule_radius"]]
    r = 0.5 * (table["capsule_radius"][first] + table["capsule_radius"][last])
    scale = 1e6 * 24 / (hours[last] - hours[first]) / (4 * math.pi * r * r)

    def change(values):
        return scale * (values[last] - values[first])

    grown, drained, cells, wall = (change(values) for values in (table["grown_volume"], table["drained_volume"], table["volume"], inside))
    return [("growth", grown), ("lysis", -drained), ("compression", cells - (grown - drained)), ("voids", wall - cells), ("wall", wall)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+")
    parser.add_argument("--from", dest="begin", type=float, default=48., help="hours after confluence")
    parser.add_argument("--to", dest="end", type=float, default=168.)
    parser.add_argument("--csv")
    options = parser.parse_args()
    lines = []
    for item in options.runs:
        label, directory = item.split("=", 1)
        parts = balance(directory, options.begin, options.end)
        lines.append([label, *(f"{value:.3f}" for _, value in parts), f"{100 * parts[-1][1] / parts[0][1]:.1f}"])
    head = ["run", *(f"{name} [um/d]" for name, _ in parts), "wall over growth [%]"]
    for line in [head, *lines]:
        print("  ".join(f"{cell:>20}" for cell in line))
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([head, *lines])


if __name__ == "__main__":
    main()
