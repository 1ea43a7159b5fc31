"""The user's own points, `turgor plot DIR --data FILE.csv`: drawn wherever a picture shows two columns of their names, in whatever unit of
the same quantity they are; what could be drawn nowhere is told, with the reason.
"""
import difflib
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from deformation import OWN_NAMES, as_in_run, is_named, strain_axis, stress_words  # noqa: E402
from drawing import ALONG, INK, POINT, in_prefix, plt, read_table, style  # noqa: E402
from units import bare, unit_factor, unit_of  # noqa: E402

DATA = []  # (name, {column: values}): set by plot.py
DRAWN = set()  # their columns of which points were drawn


def own_column(table, column):
    """The user's values of a column of a run, in its unit; None where their table has no such name, or has it in a unit of another quantity."""
    for name, values in table.items():
        factor = unit_factor(unit_of(name), unit_of(column)) if is_named(name, column) else None
        if factor is not None:
            return as_in_run(name, column, factor * values)
    return None


def draw_data(axis, first, column, unit_first=1.0, unit=1.0, origin=0.0):
    """The user's own points of this column over this first column less its origin, where their table has both, in the units of the axis."""
    for name, table in DATA:
        x, y = own_column(table, first), own_column(table, column)
        if x is not None and y is not None:
            own = {k: name for k, name in enumerate(table) if is_named(name, first) or is_named(name, column)}
            place = next(k for k, name in own.items() if is_named(name, column))
            marker = "DsP^vX"[place % 6]  # columns of one file are told apart
            axis.plot((x - origin) * unit_first, y * unit, marker, color=INK, markeredgecolor="white", markeredgewidth=0.5, markersize=POINT,
                      linestyle="none", label=f"{name}: {bare(own[place]).replace('_', ' ')}")
            DRAWN.update(own.values())


def pictures_of_pairs(path):
    """Of a table of the run in which the user's first column is not the abscissa: their columns over that one, with the run's. Paths."""
    table, made = read_table(path), []
    for _, own in DATA:
        mine = [column for column in table if own_column(own, column) is not None]
        first = next((column for column in mine if is_named(next(iter(own)), column)), None)
        others = [column for column in mine if column != first]
        if first is None or first == next(iter(table)) or not others or not len(table[first]):
            continue
        figure, panels = plt.subplots(len(others), 1, figsize=(6.5, 1.2 + 2.8 * len(others)), sharex=True, squeeze=False, layout="constrained")
        along, unit_along = in_prefix(unit_of(first), [table[first]])
        along, origin, words = strain_axis(first, [table[first]]) or (along, 0.0, with_unit(first, unit_along))
        for panel, column in zip(panels[:, 0], others):
            factor, unit = in_prefix(unit_of(column), [table[column]])
            panel.plot(along * (table[first] - origin), factor * table[column], color=ALONG, linewidth=1.4, label="the run")
            draw_data(panel, first, column, along, factor, origin)
            panel.set_ylabel(f"{stress_words(column)} [{unit}]" if stress_words(column) else with_unit(column, unit), color=INK, fontsize=9)
            panel.legend(frameon=False, fontsize=8)
            style(panel)
        panels[-1, 0].set_xlabel(words, color=INK)
        made.append(path[:-len(".csv")] + "_over_" + bare(first) + ".png")
        figure.savefig(made[-1], dpi=130)
        plt.close(figure)
    return made


def with_unit(column, unit):
    return bare(column).replace("_", " ") + (f" [{unit}]" if unit not in ("", "1") else "")


def why_not(column, own, tables):
    """Why nothing of a column of the user was drawn, with what to write instead; tables: {name: columns} of the run."""
    same = {table: known for table, columns in tables.items() for known in columns if is_named(column, known)}
    if not same:
        known = {bare(name) for columns in tables.values() for name in columns}
        known |= {name for name, meant in OWN_NAMES.items() if meant[0] in known}
        close = difflib.get_close_matches(bare(column), sorted(known), 1)
        return "no table of the run has a column of this name" + (f" (did you mean '{close[0]}'?)" if close else "")
    table, known = next(((table, known) for table, known in same.items() if unit_factor(unit_of(column), unit_of(known)) is not None),
                        next(iter(same.items())))
    if unit_factor(unit_of(column), unit_of(known)) is None:
        return f"{'its unit does not convert' if unit_of(column) else 'it has no unit'}; it is '{known}' in {table}"
    if len(own) < 2:
        return f"a second column is needed to draw it over, such as '{tables[table][0]}' of {table}"
    return f"{table} has it, but no picture shows it over another column of the file (the first one, or '{tables[table][0]}')"


def report(path, directory):
    """Tells what was not drawn; false if that is all."""
    tables = {name: list(read_table(os.path.join(directory, name))) for name in sorted(os.listdir(directory)) if name.endswith(".csv")}
    for name, own in DATA:
        left = [column for column in own if column not in DRAWN]
        if left:
            print(f"turgor: of {path} {'nothing' if len(left) == len(own) else 'this'} was {'' if len(left) == len(own) else 'not '}drawn:\n" +
                  "\n".join(f"  '{column}': {why_not(column, own, tables)}." for column in left), file=sys.stderr)
    return bool(DRAWN) or not DATA
