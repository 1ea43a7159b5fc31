"""The tables of a study as its pictures read them, and what tells its runs from each other in words."""
import csv
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import pretty  # noqa: E402
from units import bare, unit_of  # noqa: E402


def rows_of(directory, name, info):
    """Rows of a table; an entry's value stays only with the runs that it is swept in: what the others have is no point of the sweep."""
    path = os.path.join(directory, name)
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for entry in info["entries"]:
            if entry in row and entry not in info.get("swept", {}).get(row["run"], info["entries"]):
                row[entry] = ""
    return rows


def number(text):
    """A float, or None for what is none."""
    try:
        value = float(text)
    except (TypeError, ValueError):
        return None
    return value if math.isfinite(value) else None


def point_of(row, entry):
    """"Fluid viscosity 1e-3 Pa s"."""
    unit = pretty(unit_of(entry))
    return f"{bare(entry).split('/')[-1]} {row[entry]}" + (f" {unit}" if unit not in ("", "1") else "")


def settings_of(row, entries):
    """What tells a run from others of its method."""
    return ", ".join(([row["settings"]] if row.get("settings") else []) + [point_of(row, entry) for entry in entries if row.get(entry)])


def same_runs(results):
    """{label: label of the first run that it is}, of those that were asked for twice."""
    first, same = {}, {}
    for row in results:
        if first.setdefault(row["directory"], row["run"]) != row["run"] and row["directory"]:
            same[row["run"]] = first[row["directory"]]
    return same


def is_seed(entry):
    """Whether a swept entry only draws another sample of the same tissue: "Structure/Structure seed"."""
    return bare(entry).lower().endswith("seed")


def over_seeds(rows, entries):
    """{label: runs that differ in their seed alone}, in the order of the runs."""
    groups = {}
    for row in rows:
        settings = settings_of(row, [entry for entry in entries if not is_seed(entry)])
        groups.setdefault(f"{row['method']}  {settings}".strip(), []).append(row)
    return groups
