"""Runs a list of scenes and writes their results as one CSV: what the studies of this folder share.

main(studies, folder, text): studies {name: function that yields (label, scene, {entry: value})}; the table goes to
doc/results/<folder>/<name>.csv. Runs that are finished in the directory are not repeated.
"""
import argparse
import csv
import json
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def options_of(names, text):
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", choices=sorted(names))
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "app", "turgor"))
    parser.add_argument("--directory", default="runs")
    parser.add_argument("--only-table", action="store_true", help="of the runs that are there")
    return parser.parse_args()


def run_all(options, runs):
    """[(label, place of the run or None, sentence of a failed run)]"""
    done = []
    for label, scene, entries in runs:
        place = os.path.join(options.directory, options.study, label)
        summary = os.path.join(place, "summary.json")
        finished = os.path.exists(summary) and json.load(open(summary, encoding="utf-8"))["status"] == "finished"
        if not finished:
            if options.only_table:
                continue
            command = [options.program, "run", os.path.join(ROOT, "inputs", scene + ".prm"), "-o", place, "--quiet", "--threads", "1"]
            for name, value in entries.items():
                command += ["--set", f"{name}={value}"]
            out = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
            if out.returncode != 0:
                said = (out.stdout + out.stderr).strip().splitlines() or [f"ended with code {out.returncode}"]
                done.append((label, None, next((line for line in said if line.startswith("turgor: ")), said[-1])))
                print(label, "FAILED", done[-1][2], flush=True)
                continue
        done.append((label, place, ""))
        print(label, flush=True)
    return done


def write_table(folder, name, rows):
    columns = []
    for row in rows:
        columns += [column for column in row if column not in columns]
    place = os.path.join(ROOT, "doc", "results", folder)
    os.makedirs(place, exist_ok=True)
    with open(os.path.join(place, name + ".csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)


def row_of(label, place, failed):
    if place is None:
        return {"run": label, "failed": failed}
    summary = json.load(open(os.path.join(place, "summary.json"), encoding="utf-8"))
    row = {"run": label, "cpu_time_s": f"{summary['cpu_time_s']:.4g}"}
    for name, entry in summary["results"].items():
        row[f"{name} [{entry['unit']}]" if entry["unit"] else name] = f"{entry['value']:.6g}"
    return row


def main(studies, folder, text):
    options = options_of(studies, text)
    write_table(folder, options.study, [row_of(*one) for one in run_all(options, studies[options.study]())])
