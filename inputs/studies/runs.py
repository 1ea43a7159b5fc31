"""Runs for the scripts of this folder: one call of `turgor study`, so that a run is kept by its identity and never computed twice.

  study("rim", [("ten_1", "spheroid_free", {"Cell/Seed": 1}), ...])  ->  {"ten_1": {"status": "finished", "directory": ..., ...}, ...}

What is only a list of runs and a table of their results is a study file (.prm), not a script.
"""
import argparse
import csv
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("TURGOR", os.path.join(ROOT, "turgor"))
JOBS = os.environ.get("TURGOR_JOBS", "1")  # runs beside each other


def escaped(text):
    return str(text).replace(";", "\\;")


def study(name, runs):
    """{label: row of results.csv} of runs (label, scene, {entry: value}); a run that failed has its sentence in "message".

    The study is runs/NAME below the source; what is finished there with this program is not repeated.
    """
    folder = os.path.join(ROOT, "runs", name)
    os.makedirs(folder, exist_ok=True)
    file = os.path.join(folder, os.path.basename(name) + ".prm")
    with open(file, "w", encoding="utf-8") as out:
        out.write("set Draw = none\n")
        for label, scene, entries in runs:
            overrides = "; ".join(f"{entry}={escaped(value)}" for entry, value in entries.items())
            out.write(f"subsection Run {label}\n  set Input = {ROOT}/inputs/{scene}.prm\n  set Overrides = {overrides}\nend\n")
    code = subprocess.run([PROGRAM, "study", file, "--jobs", JOBS], cwd=ROOT, stdin=subprocess.DEVNULL).returncode
    if code not in (0, 1):  # 1: some run failed, which its row tells
        raise SystemExit(code)
    with open(os.path.join(folder, "results.csv"), newline="", encoding="utf-8") as table:
        rows = {row["run"]: row for row in csv.DictReader(table)}
    for row in rows.values():
        row["directory"] = os.path.normpath(os.path.join(folder, row["directory"]))
    return rows


def results(row):
    """{name without unit: number} of a finished run."""
    first = list(row).index("message") + 1
    return {name.split(" [")[0]: float(value) for name, value in list(row.items())[first:] if value}


def choice(names, text):
    """The name that the command line chose."""
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", choices=sorted(names))
    return parser.parse_args().study


def no_choice(text):
    """A script that takes nothing: --help tells what it does, anything else is refused; neither starts a run."""
    argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()


def write_table(path, rows):
    """A CSV below doc/results of rows {column: text}; the columns are all that occur."""
    path = os.path.join(ROOT, "doc", "results", path)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(dict.fromkeys(column for row in rows for column in row)), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def table_row(row):
    """What a committed table keeps of a row of results.csv: the label, the cost and the results, or the sentence of a failed run."""
    if row["status"] != "finished":
        return {"run": row["run"], "failed": row["message"]}
    first = list(row).index("message") + 1
    return {"run": row["run"], "cpu_time_s": row["cpu_time_s"], **dict(list(row.items())[first:])}
