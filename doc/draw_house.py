#!/usr/bin/python3
"""Draws the house from the includes themselves, doc/house.png: every folder a room with its files and lines, an arrow from a room to each
room whose headers it includes (left out where the way over other rooms says the same), lower rooms knowing nothing of higher ones.

    /usr/bin/python3 doc/draw_house.py            draws, and prints the table of rooms and arrows
"""
import collections
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, SOURCE)
from tests.app.test_include_direction import folder_of, includes, sources  # noqa: E402

WHAT = {
    "run": "input, directory, archive, tables, fields",
    "micro/geometry": "box, bins, meshes, obstacles, tilings",
    "micro/laws": "pure functions of a few numbers",
    "micro/solve": "LDLT, matrix of motion, CG",
    "micro/engine": "particles, lists, steppers",
    "micro/terms": "laws on particles",
    "micro/cells": "what is where; state of cells",
    "micro/processes": "what happens between steps",
    "micro/scenes": "particle scenes and instruments",
    "micro/scenes/reference": "closed forms, other models",
    "rve": "one RVE: F, F_dot -> stress",
    "macro": "the tissue: finite elements (deal.II)",
    "coupling": "a material law made of RVEs; FE2 scenes",
    "app": "main(), command line, studies, pictures",
}
# room: (column, floor)
PLACE = {
    "app": (1.7, 9.2), "coupling": (2.5, 8.2), "micro/scenes": (0.5, 7.4), "rve": (2.3, 7.), "micro/scenes/reference": (0.35, 6.4), "macro": (3.4, 6.4),
    "micro/processes": (1.3, 5.6), "micro/cells": (1.3, 4.7), "micro/terms": (1.3, 3.8), "micro/engine": (1.3, 2.9), "micro/solve": (2., 1.95),
    "micro/laws": (0.5, 1.75), "micro/geometry": (1.4, 0.85), "run": (2.4, 0.),
}


def measure():
    """({room: [files, lines]}, {(room, room): includes})."""
    size, arrows = collections.defaultdict(lambda: [0, 0]), collections.Counter()
    for path in sources(SOURCE):
        room = folder_of(os.path.relpath(path, SOURCE))
        with open(path, encoding="utf-8") as file:
            size[room][0] += 1
            size[room][1] += sum(1 for _ in file)
    for path, _, included, quoted in includes(SOURCE):
        room, other = folder_of(path), folder_of(included)
        if quoted and other and other != room:
            arrows[room, other] += 1
    return size, arrows


def shortest(arrows):
    """The arrows that no way over other rooms replaces."""
    reach = collections.defaultdict(set)
    for a, b in arrows:
        reach[a].add(b)

    def below(room, seen):
        for other in reach[room]:
            if other not in seen:
                seen.add(other)
                below(other, seen)
        return seen
    return {(a, b): n for (a, b), n in arrows.items() if not any(b in below(c, set()) for c in reach[a] if c != b)}


def draw(size, arrows, file):
    figure, axes = plt.subplots(figsize=(12, 10.5))
    width, height, apart = 2.3, 0.62, 2.55
    for (a, b), count in shortest(arrows).items():
        (xa, ya), (xb, yb) = PLACE[a], PLACE[b]
        axes.annotate("", xy=(apart * xb, yb + height / 2 + 0.02), xytext=(apart * xa, ya - height / 2 - 0.02),
                      arrowprops={"arrowstyle": "-|>", "color": "#555555", "lw": 0.8 + min(3., count / 25.), "shrinkA": 0, "shrinkB": 0})
    for room, (column, floor) in PLACE.items():
        colour = "#dcebf7" if room.startswith("micro") else "#e8f3dc" if room in ("rve", "coupling", "macro") else "#f4ead5"
        axes.add_patch(plt.Rectangle((apart * column - width / 2, floor - height / 2), width, height, facecolor=colour, edgecolor="#333333", zorder=3))
        axes.text(apart * column, floor + 0.16, f"{room}/", ha="center", va="center", fontsize=11, fontweight="bold", zorder=4)
        axes.text(apart * column, floor - 0.03, WHAT[room], ha="center", va="center", fontsize=7.2, zorder=4)
        axes.text(apart * column, floor - 0.2, f"{size[room][0]} files, {size[room][1]} lines", ha="center", va="center", fontsize=7.5, color="#555555", zorder=4)
    axes.set_xlim(-0.4, apart * 3.4 + width / 2 + 0.2)
    axes.set_ylim(-0.5, 9.7)
    axes.axis("off")
    axes.set_title("Who includes whom: arrows point at what a folder knows; left out where a longer way leads there too", fontsize=12)
    figure.tight_layout()
    figure.savefig(file, dpi=110)


def main():
    size, arrows = measure()
    for room in PLACE:
        known = ", ".join(f"{b} ({n})" for (a, b), n in sorted(arrows.items()) if a == room)
        print(f"{room:24s} {size[room][0]:4d} files {size[room][1]:6d} lines   knows {known or 'nothing of ours'}")
    print(f"{'all':24s} {sum(n for n, _ in size.values()):4d} files {sum(n for _, n in size.values()):6d} lines")
    draw(size, arrows, os.path.join(SOURCE, "doc", "house.png"))


if __name__ == "__main__":
    main()
