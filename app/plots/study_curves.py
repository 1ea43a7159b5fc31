"""curves.png of a study: the measured columns of all its runs, over each other, with what they are compared with."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drawing import INK, in_prefix, list_beside, plt, read_table, style  # noqa: E402
from own_data import with_unit  # noqa: E402
from study_tables import settings_of  # noqa: E402
from units import bare, unit_factor, unit_of  # noqa: E402


def curve(path, against, column):
    """Abscissa with its name, values with theirs; None where the run wrote none."""
    try:
        table = read_table(path)
    except OSError:
        return None
    names = {bare(name): name for name in table}
    x = names.get(against or bare(next(iter(table), "")))
    return (x, table[x], names[column], table[names[column]]) if x and column in names else None


def in_units_of(run, other):
    """A curve in the units of another one, with its names; None where these are of other quantities."""
    factors = [unit_factor(unit_of(other[k]), unit_of(run[k])) for k in (0, 2)]
    return None if None in factors else (run[0], factors[0] * other[1], run[2], factors[1] * other[3])


def curves_of(one, column, runs, directory, entries):
    """[(label, curve, how it is drawn)] of a column of a measure; what is compared with comes last."""
    drawn, colours = [], plt.get_cmap("tab20").colors
    grey = dict(color="k", lw=2.5, alpha=0.6, zorder=0)
    for k, row in enumerate(runs):
        found = curve(os.path.join(directory, row["directory"], one["table"] + ".csv"), one["against"], column)
        if found:
            is_reference = row["run"] == one["reference"]
            look = grey if is_reference else dict(color=colours[k % 20], lw=1.2, ls=("-", "--", "-.", ":")[k // 20 % 4])
            drawn.append((f"{row['method']}  {settings_of(row, entries)}" + " (reference)" * is_reference, found, look))
    if one["reference_table"] and drawn:
        first, name = drawn[0][1], os.path.basename(one["reference"].rstrip("/"))
        of_file = name == os.path.basename(one["reference_table"])
        found = curve(os.path.join(directory, one["reference_table"]), one["against"] or bare(first[0]), column)
        found = in_units_of(first, found) if found else None
        if found:
            few = of_file and len(found[1]) <= 100
            drawn.append((f"{name} (reference)", found, dict(color=INK, marker="D", markersize=5, ls="", zorder=5) if few else grey))
    return drawn


def plot_curves(results, info, directory):
    wanted = {}
    for one in info["measures"]:
        for column in one["columns"] if one["curve"] else []:
            wanted.setdefault((one["table"], one["against"], column, one["reference"]), (one, column))
    runs = [row for row in results if row["status"] == "finished"]
    panels = [found for one, column in wanted.values() if (found := curves_of(one, column, runs, directory, info["entries"]))]
    if not panels:
        return
    figure, axes = plt.subplots(len(panels), 1, figsize=(7.5, max(1 + 2.8 * len(panels), 0.2 * len(runs) + 1)), squeeze=False, layout="constrained")
    handles = {}
    for panel, drawn in zip(axes[:, 0], panels):
        x, _, y, _ = drawn[0][1]
        along, unit_along = in_prefix(unit_of(x), [found[1] for _, found, _ in drawn])
        factor, unit = in_prefix(unit_of(y), [found[3] for _, found, _ in drawn])
        for label, found, look in drawn:
            handles[label], = panel.plot(along * found[1], factor * found[3], label=label, **look)
        panel.set_xlabel(with_unit(x, unit_along), color=INK)
        panel.set_ylabel(with_unit(y, unit), color=INK)
        panel.grid(alpha=0.2)
        style(panel)
    list_beside(figure, list(handles.values()))
    figure.savefig(os.path.join(directory, "curves.png"), dpi=130)
    plt.close(figure)
