"""The picture of a two_cells run: force against overlap, the way in and the way out, with the closed-form pull-off.

main(directory) reads approach.csv and summary.json and writes two_cells.png there.
"""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import ACCENT, ALONG, INK, plt, read_table, style  # noqa: E402
from own_data import draw_data  # noqa: E402


def main(directory):
    """Paths of the pictures made."""
    table = read_table(os.path.join(directory, "approach.csv"))
    overlap, force = table["overlap [m]"] * 1e6, table["force [N]"] * 1e9
    turn = int(np.argmax(overlap))
    figure, axis = plt.subplots(figsize=(7.5, 5), layout="constrained")
    axis.axhline(0, color="#c8d0d6", linewidth=0.8)
    axis.plot(overlap[:turn + 1], force[:turn + 1], color=ALONG, linewidth=2.2, label="brought together")
    axis.plot(overlap[turn:], force[turn:], color=ACCENT, linewidth=1.4, linestyle=(0, (5, 2)), label="drawn apart")
    draw_data(axis, "overlap [m]", "force [N]", 1e6, 1e9)
    try:
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            results = json.load(file)["results"]
    except OSError:
        results = {}
    if "pull_off_closed_form" in results:
        level = -results["pull_off_closed_form"]["value"] * 1e9
        axis.axhline(level, color=INK, linewidth=0.9, linestyle=(0, (2, 3)))
        axis.annotate(f"closed-form pull-off {-level:.4f} nN; the run's differs by {results['pull_off_error']['value']:.1e} of it",
                      (overlap.max(), level), xytext=(0, -5), textcoords="offset points", ha="right", va="top", fontsize=9, color=INK)
        axis.margins(y=0.1)
    axis.set_title("Two cells brought together and drawn apart: the force between them", fontsize=11, color=INK)
    axis.set_xlabel("overlap [µm]", color=INK)
    axis.set_ylabel("force, positive apart [nN]", color=INK)
    axis.legend(frameon=False, fontsize=9)
    style(axis)
    path = os.path.join(directory, "two_cells.png")
    figure.savefig(path, dpi=150)
    plt.close(figure)
    return [path]


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
