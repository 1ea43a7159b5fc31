"""The five cell lines of experiment II (thesis 5.4.2, Fig. 5.1B, D-G): each free and under dextran, nothing refitted.

  python3 inputs/studies/spheroid_dextran.py NAME

small        400 first cells (about 60 um of radius where the experiment has 100 um), 3 days; BC52 and FHI 2 more after the change of their
             rim, which comes after 3 days here instead of 9. FHI's control also with the rim of the thesis, which counts from the mean edge
full         2000 first cells, 9 days, BC52 and FHI 14, AB6's control 5; 80 minutes of CPU time
The tables go to doc/results/spheroid/dextran_<name>.csv with the ratio of the pressed line's speed to its control, the picture
beside them.
"""
import os
import sys

from runs import ROOT, choice, study, table_row, write_table

LINES = {"CT26": 5000, "AB6": 5000, "HT29": 10000, "BC52": 5000, "FHI": 5000}  # Pa
TWO_REGIMES = ("BC52", "FHI")
DAY = 86400


def runs(name):
    cells, first, second = {"small": (400, 3 * DAY, 2 * DAY), "full": (2000, 9 * DAY, 5 * DAY)}[name]
    for line, pressure in LINES.items():
        entries = {"First cells": cells, "Frames": 0, "Checkpoints": 0, "Samples": 150, "Dextran/Cell line": line,
                   "Dextran/Regime change": first, "End time": first + second * (line in TWO_REGIMES)}
        short = {"End time": 5 * DAY} if line == "AB6" and name == "full" else {}  # 30 000 cells by then, as free growth has no end
        yield f"{line}_free", "spheroid_dextran", {**entries, **short, "Dextran/Pressure": 0}
        yield f"{line}_{pressure // 1000}kPa", "spheroid_dextran", {**entries, "Dextran/Pressure": pressure}
        if line == "FHI" and name == "small":
            yield "FHI_free_edge", "spheroid_dextran", {**entries, "Dextran/Pressure": 0, "Death/Rim from": "edge"}


def main():
    name = choice(["small", "full"], __doc__)
    done = study("dextran_" + name, runs(name))
    rows, speed = [], {}
    for label, run in done.items():
        rows.append(table_row(run))
        line = label.split("_")[0]
        for key in ("radial_speed", "radial_speed_first", "radial_speed_second"):
            value = float(rows[-1].get(f"{key} [um/d]") or "nan")
            rows[-1][f"{key} [um/h]"] = f"{value / 24:.4g}" if value == value else ""
            if label.endswith("free"):
                speed[line, key] = value
            elif value == value:
                rows[-1][f"{key}_over_control"] = f"{value / speed[line, key]:.4g}"
    write_table(f"spheroid/dextran_{name}.csv", rows)
    shown = [(label.replace("_", " "), run["directory"]) for label, run in done.items() if run["status"] == "finished"]
    if shown:
        sys.path.insert(0, os.path.join(ROOT, "app", "plots"))
        from spheroid_dextran import draw
        draw(shown, os.path.join(ROOT, "doc", "results", "spheroid", f"dextran_{name}.png"), 3. if name == "small" else 9.)


if __name__ == "__main__":
    main()
