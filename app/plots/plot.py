"""Pictures of a run: every series whose first column rises (time, strain, ...) against it, then what the scene's own script
app/plots/<scenario>.py draws (contract: main(directory)). Tables that are no series have no picture of this kind.

  plot.py DIR [--data FILE.csv]     the user's own points as well (own_data.py)
"""
import importlib
import json
import os
import sys
import textwrap

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy as np  # noqa: E402

from drawing import NOISE, in_prefix, line_styles, of_one_scale, plt, read_table  # noqa: E402
from own_data import DATA, draw_data, pictures_of_pairs, report  # noqa: E402
from units import bare, unit_of  # noqa: E402

MOST = 8  # lines in a panel: more are not told apart
QUANTITIES = {"Pa": "stress, pressure", "N": "force", "N/m": "force over length", "J": "energy", "J/m": "energy over length", "m": "length",
              "s": "time", "m/s": "speed", "m^3": "volume", "1": "ratios, each of its own", "": "counts, each of its own"}
WORDS = {"lent": "lent by the error of the steps"}  # a column whose name alone says too little


def words_of(column):
    return WORDS.get(bare(column), bare(column).replace("_", " "))


def quantity_of(columns):
    """What the lines of a panel have in common: the words that all their names begin or end with, or what their unit measures."""
    words = [words_of(name).split() for name in columns]
    for direction in (1, -1):
        common = [same[0] for same in zip(*[one[::direction] for one in words])]
        end = next((k for k, word in enumerate(common) if any(one[::direction][k] != word for one in words)), len(common))
        if end:
            return " ".join(common[:end][::direction])
    return QUANTITIES.get(unit_of(columns[0]), "value")


def with_gaps(table):
    """A closed form, and how far the run is off it, are written as 0 where it does not apply; a line has a gap there."""
    applies = table.get("closed_form_applies")
    if applies is None:
        return table
    gone = [name for name in table if name.startswith(("closed_", "deviatoric_deviation")) and name != "closed_form_applies"]
    return {name: np.where(applies > 0.5, values, np.nan) if name in gone else values for name, values in table.items()}


def few_at_a_time(columns):
    """Lists of at most MOST columns; those whose names differ in the last word (components of a tensor) stay together."""
    if len(columns) <= MOST:
        return [columns]
    families = {}
    for name in columns:
        families.setdefault(bare(name).rsplit("_", 1)[0], []).append(name)
    alone = [name for family in families.values() if len(family) == 1 for name in family]
    lists = [family for family in families.values() if len(family) > 1] + [alone]
    return [one[k:k + MOST] for one in lists for k in range(0, len(one), MOST)]


NOTHING = 3  # exit code where there is nothing to draw; plot_command.cc knows it
LISTED = ("seed", "cell")  # first columns that number things: nothing goes from one row to the next
GAPS = ((0, (4, 4)), (0, (1.5, 4)), (0, (4, 3, 1, 3)))


def covering(columns):
    """{name: how many of those before it have its course}: lines that lie within a hundredth of the panel on another that was drawn before."""
    low, high = min(np.nanmin(values) for values in columns.values()), max(np.nanmax(values) for values in columns.values())
    covers = {}
    for k, name in enumerate(columns):
        same = [other for other in list(columns)[:k] if np.nanmax(np.abs(columns[other] - columns[name])) < 0.01 * (high - low)]
        if same:
            covers[name] = len(same) - 1
    return covers


def panels_of(table):
    """[(unit, columns)] of a table but its first column; names of those that are zero throughout but for rounding, or nowhere."""
    units, panels, zeros, nowhere, noise = {}, [], [], [], []
    for name in list(table)[1:]:
        if np.all(np.isnan(table[name])):
            nowhere.append(words_of(name))
        else:
            units.setdefault(unit_of(name), {})[name] = table[name]
    for unit, columns in units.items():
        size = {name: np.nanmax(np.abs(values)) for name, values in columns.items()}
        if unit != "":  # counts are never small; of ratios, each of its own, 1 is the measure
            small = [name for name in columns if 0 < size[name] < NOISE * (1.0 if unit == "1" else max(size.values()))]
            noise += [words_of(name) for name in small]
            columns = {name: values for name, values in columns.items() if name not in small}
        groups, zero = of_one_scale(columns)
        panels += [(unit, few) for group in groups for few in few_at_a_time(group)]
        zeros += [words_of(name) for name in zero]
    return panels, [f"{what}: {', '.join(names)}" for what, names in (("zero throughout", zeros), ("zero but for rounding and what solvers leave", noise), ("does not apply at any row", nowhere)) if names]


def plot_series(path, of=""):
    """One panel per unit and order of size below each other; the picture beside the table. Its path, or None where there is nothing to follow from row to row."""
    table = with_gaps(read_table(path))
    names = list(table)
    if len(names) < 2 or len(table[names[0]]) < 2 or np.any(np.diff(table[names[0]]) <= 0):
        return None
    shown, remarks = panels_of(table)
    if not shown:
        return None
    across = 1 if len(shown) <= 6 else 2  # no strip that a screen shows a fifth of
    down = -(-len(shown) // across)
    figure, grid = plt.subplots(down, across, figsize=(7.5 * across, 1.4 + 2.6 * down), sharex=True, squeeze=False, layout="constrained")
    panels = grid.T.ravel()  # down the first column, then the second
    for unused in panels[len(shown):]:
        unused.axis("off")
    along, unit_along = in_prefix(unit_of(names[0]), [table[names[0]]])
    for panel, (unit, columns) in zip(panels, shown):
        factor, prefixed = in_prefix(unit, [table[name] for name in columns])
        covers = covering({name: table[name] for name in columns})
        for k, (name, (colour, dash)) in enumerate(zip(columns, line_styles(len(columns)))):
            # Each line is thinner than those it is drawn over, and one of the same course has gaps, so that both are seen.
            if names[0] in LISTED:
                panel.plot(along * table[names[0]], factor * table[name], "o", label=words_of(name), color=colour, markersize=4 if len(table[name]) < 300 else 1.5)
                continue
            panel.plot(along * table[names[0]], factor * table[name], label=words_of(name), color=colour,
                       linestyle=GAPS[covers[name] % len(GAPS)] if name in covers and dash == "-" else dash,
                       lw=1.2 + 1.6 * (len(columns) - 1 - k) / max(len(columns), 4))
            draw_data(panel, names[0], name, along, factor)
        panel.set_ylabel("\n".join(textwrap.wrap(f"{quantity_of(columns)} [{prefixed}]" if prefixed not in ("", "1") else quantity_of(columns), 26)))
        panel.grid(alpha=0.3)
        if len(panel.lines) > 1:  # one line is named beside its axis
            panel.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    for foot in {down - 1, len(shown) - 1}:
        panels[foot].tick_params(labelbottom=True)
        panels[foot].set_xlabel(words_of(names[0]) + (f" [{unit_along}]" if unit_along not in ("", "1") else ""))
    figure.suptitle(f"{os.path.basename(path)}{of}", fontsize=10)
    if remarks:
        figure.text(0.5, 0.0, "\n".join(line for remark in remarks for line in textwrap.wrap(remark, 90)), fontsize=8, ha="center", va="top")
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
    scenario = scenario_of(directory)
    pictures = []
    for path in sorted(os.path.join(directory, name) for name in os.listdir(directory) if name.endswith(".csv")):
        series = plot_series(path, f" of a run of {scenario}" if scenario else "")
        pictures += ([series] if series else []) + pictures_of_pairs(path)
    if scenario.isidentifier() and os.path.exists(os.path.join(here, scenario + ".py")):
        made = importlib.import_module(scenario).main(directory)
        pictures += made if isinstance(made, list) else []
    for picture in dict.fromkeys(pictures):
        print(picture)
    if not pictures:
        return NOTHING
    return 0


if __name__ == "__main__":
    if len(sys.argv) > 3 and sys.argv[2] == "--data":
        DATA.append((os.path.basename(sys.argv[3]), read_table(sys.argv[3])))
        if not any(len(values) for values in DATA[0][1].values()):
            sys.exit(f"{sys.argv[3]} has no rows of numbers; it needs one header line such as 'time [s],radius [m]' and rows below it.")
    code = main(sys.argv[1])
    sys.exit(code if code or report(*(sys.argv[3:4] or [""]), sys.argv[1]) else 1)
