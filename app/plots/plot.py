"""Pictures of a run: every series against its first column, then what the scene's own script
app/plots/<scenario>.py draws (contract: main(directory)).

  plot.py DIR
"""
import importlib
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import plt, read_table  # noqa: E402


def plot_series(path):
    """One panel per unit below each other; the picture beside the table. Its path, or None without data."""
    table = read_table(path)
    names = list(table)
    if len(names) < 2 or len(table[names[0]]) < 2:
        return None
    units = {}
    for name in names[1:]:
        units.setdefault(name[name.rfind("["):] if "[" in name else "", []).append(name)
    figure, panels = plt.subplots(len(units), 1, figsize=(7, 1 + 2.6 * len(units)), sharex=True, squeeze=False,
                                  layout="constrained")
    for panel, (unit, columns) in zip(panels[:, 0], units.items()):
        for name in columns:
            panel.plot(table[names[0]], table[name], label=name.split(" [")[0], lw=1.2)
        panel.set_ylabel(unit or "1")
        panel.grid(alpha=0.3)
        if len(columns) <= 12:
            panel.legend(fontsize=8)
    panels[-1, 0].set_xlabel(names[0])
    picture = path[:-len(".csv")] + ".png"
    figure.savefig(picture, dpi=150)
    plt.close(figure)
    return picture


def scenario_of(directory):
    try:
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            return json.load(file)["scenario"]
    except (OSError, ValueError, KeyError):
        with open(os.path.join(directory, "input.prm"), encoding="utf-8") as file:
            for line in file:
                if line.startswith("set Scenario"):
                    return line.split("=")[1].strip()
    return ""


def main(directory):
    here = os.path.dirname(os.path.abspath(__file__))
    pictures = []
    for name in sorted(os.listdir(directory)):
        if name.endswith(".csv"):
            picture = plot_series(os.path.join(directory, name))
            if picture:
                pictures.append(picture)
    scenario = scenario_of(directory)
    if scenario.isidentifier() and os.path.exists(os.path.join(here, scenario + ".py")):
        made = importlib.import_module(scenario).main(directory)
        pictures += made if isinstance(made, list) else []
    for picture in pictures:
        print(picture)
    if not pictures:
        print(f"There is nothing to plot in {directory}: no series has two rows.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
