"""Pictures of a run: every series whose first column rises (time, strain, ...) against it, then what the scene's own script
app/plots/<scenario>.py draws (contract: main(directory)). Tables that are no series have no picture of this kind.

  plot.py DIR [--data FILE.csv]     the user's own points, drawn wherever a column has the same name and unit
"""
import importlib
import json
import os
import sys
import textwrap

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy as np  # noqa: E402

from drawing import DATA, draw_data, in_prefix, line_styles, of_one_scale, plt, read_table  # noqa: E402


def unit_of(column):
    return column[column.rfind("[") + 1:-1] if "[" in column else "1"


def words_of(column):
    return column.split(" [")[0].replace("_", " ")


GAPS = ((0, (4, 4)), (0, (1.5, 4)), (0, (4, 3, 1, 3)))


def covering(columns):
    """{name: how many of those before it have its course}: lines that lie within a hundredth of the panel on another that was drawn before."""
    low, high = min(np.min(values) for values in columns.values()), max(np.max(values) for values in columns.values())
    covers = {}
    for k, name in enumerate(columns):
        same = [other for other in list(columns)[:k] if np.max(np.abs(columns[other] - columns[name])) < 0.01 * (high - low)]
        if same:
            covers[name] = len(same) - 1
    return covers


def plot_series(path):
    """One panel per unit and order of size below each other; the picture beside the table. Its path, or None where there is nothing to follow from row to row."""
    table = read_table(path)
    names = list(table)
    if len(names) < 2 or len(table[names[0]]) < 2 or np.any(np.diff(table[names[0]]) <= 0):
        return None
    units, panels_of, zeros = {}, [], []
    for name in names[1:]:
        units.setdefault(unit_of(name), {})[name] = table[name]
    for unit, columns in units.items():
        groups, zero = of_one_scale(columns)
        panels_of += [(unit, group) for group in groups]
        zeros += [words_of(name) for name in zero]
    if not panels_of:
        return None
    figure, panels = plt.subplots(len(panels_of), 1, figsize=(7.5, 1.2 + 2.6 * len(panels_of)), sharex=True, squeeze=False,
                                  layout="constrained")
    along, unit_along = in_prefix(unit_of(names[0]), [table[names[0]]])
    for panel, (unit, columns) in zip(panels[:, 0], panels_of):
        factor, prefixed = in_prefix(unit, [table[name] for name in columns])
        covers = covering({name: table[name] for name in columns})
        for k, (name, (colour, dash)) in enumerate(zip(columns, line_styles(len(columns)))):
            # Each line is thinner than those it is drawn over, and one of the same course has gaps, so that both are seen.
            panel.plot(along * table[names[0]], factor * table[name], label=words_of(name), color=colour,
                       linestyle=GAPS[covers[name] % len(GAPS)] if name in covers and dash == "-" else dash,
                       lw=1.2 + 1.6 * (len(columns) - 1 - k) / max(len(columns), 4))
            draw_data(panel, names[0], name, along, factor)
        panel.set_ylabel("no unit" if prefixed in ("", "1") else prefixed)
        panel.grid(alpha=0.3)
        panel.legend(fontsize=8 if len(columns) <= 8 else 6, ncols=1 + len(columns) // 9, loc="center left", bbox_to_anchor=(1.0, 0.5),
                     frameon=False)
    panels[-1, 0].set_xlabel(words_of(names[0]) + (f" [{unit_along}]" if unit_along not in ("", "1") else ""))
    if zeros:
        figure.text(0.5, 0.0, "\n".join(textwrap.wrap("zero throughout: " + ", ".join(zeros), 90)), fontsize=8, ha="center", va="top")
    picture = path[:-len(".csv")] + ".png"
    figure.savefig(picture, dpi=150, bbox_inches="tight")
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
    for picture in dict.fromkeys(pictures):
        print(picture)
    if not pictures:
        print(f"There is nothing to plot in {directory}: no series has two rows, and the scene has no picture of its own.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    if len(sys.argv) > 3 and sys.argv[2] == "--data":
        DATA.append((os.path.basename(sys.argv[3]), read_table(sys.argv[3])))
        if not any(len(values) for values in DATA[0][1].values()):
            sys.exit(f"{sys.argv[3]} has no rows of numbers; it needs one header line such as 'time [s],radius [m]' and rows below it.")
    sys.exit(main(sys.argv[1]))
