"""The picture of `turgor compare`: the error of FE² and what it is made of.

  split.py DIR
reads DIR/split.csv (app/error_split.h) and study.json, writes split.png: a panel for each measure, a bar for the error and one for each
part, which multiply up to it; the rest is hatched where it leaves the error unexplained, with the reason below.
"""
import csv
import json
import os
import sys
import textwrap

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, plt, style  # noqa: E402
from study_tables import number  # noqa: E402

REST = "#a8b3bb"


def draw(axis, rows, measure, title, remarked):
    shown = [(row["what"], 100 * number(row[measure])) for row in rows if number(row[measure]) is not None]
    largest = max([abs(share) for _, share in shown] + [1e-9])
    for place, (what, share) in enumerate(shown):
        hatched = what == "rest" and remarked
        axis.barh(-place, share, height=0.62, color=ACCENT if place == 0 else REST if what == "rest" else ALONG,
                  hatch="////" if hatched else None, edgecolor=INK if hatched else "none", linewidth=0.6)
        axis.annotate(f"{share:+.2f} %", (share, -place), xytext=(4 if share >= 0 else -4, 0), textcoords="offset points", fontsize=8, color=INK,
                      ha="left" if share >= 0 else "right", va="center")
    axis.axvline(0, color=INK, linewidth=0.8)
    axis.axhline(-0.5, color="#c8d0d6", linewidth=0.8)
    axis.set_yticks([-place for place in range(len(shown))], [what for what, _ in shown])
    axis.set_xlim(-1.35 * largest, 1.35 * largest)
    axis.set_title(title, fontsize=10, color=INK)
    axis.set_xlabel("share of the value of all cells [%]", fontsize=9, color=INK)
    style(axis)


def speed_up(rows):
    """A line for the title: what both sides cost; empty where that is not known."""
    times = {row["what"]: number(row["cpu_time_s"]) for row in rows}
    coarse, fine = times.get("error of FE2"), times.get("all cells")
    if not coarse or not fine:
        return ""
    ratio = f"{fine / coarse:.3g} times as fast" if fine >= coarse else f"{coarse / fine:.3g} times as long"
    return f"\nFE² takes {coarse:.3g} s of CPU time, all cells {fine:.3g} s: {ratio}"


def main(directory):
    with open(os.path.join(directory, "split.csv"), newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    with open(os.path.join(directory, "study.json"), encoding="utf-8") as file:
        titles = {one["name"]: one["title"] for one in json.load(file)["measures"]}
    measures = [name for name in rows[0] if name in titles]
    end = next(k for k, row in enumerate(rows) if row["what"] == "rest")
    remark = rows[end]["remark"]
    figure, panels = plt.subplots(1, len(measures), figsize=(1.6 + 4.9 * len(measures), 1.6 + 0.36 * (end + 1)), squeeze=False, layout="constrained")
    for axis, measure in zip(panels[0], measures):
        draw(axis, rows[:end + 1], measure, titles[measure], f"{measure}: " in remark)
    figure.suptitle("Error of FE² against every one of its cells, and the parts that multiply up to it" + speed_up(rows), fontsize=11, color=INK)
    if remark:
        figure.text(0.02, 0.0, "\n".join(textwrap.wrap("Hatched: not explained; " + remark, 45 + 60 * len(measures))), fontsize=8, color=INK, va="top")
    figure.savefig(os.path.join(directory, "split.png"), dpi=130, bbox_inches="tight")
    plt.close(figure)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
