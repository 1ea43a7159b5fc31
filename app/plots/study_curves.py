"""curves.png of a study: the measured columns of all its runs, over each other, with what they are compared with; stress_strain.png of runs
that have stress.csv (rve_response): stress over the deformation that leads their path. Runs that differ in a seed alone are one line, their
mean, in a band that is its 95 % confidence.
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from deformation import COMPONENTS, parts_of_path, strain_axis, stress_words  # noqa: E402
from drawing import INK, POINT, in_prefix, input_entries, list_beside, plt, read_table, style  # noqa: E402
from own_data import with_unit  # noqa: E402
from study_tables import over_seeds, settings_of  # noqa: E402
from units import bare, unit_factor, unit_of  # noqa: E402

T95 = (12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262)  # Student's t at 97.5 %, of 2, 3, ... samples


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


def confidence(count):
    """What the standard deviation over the root of so many samples is multiplied by: Student's t, 95 %; from 11 on within 2 % of it."""
    return T95[count - 2] if count - 2 < len(T95) else 1.96 * (1 + 1.25 / (count - 1.5))


def mean_and_band(curves):
    """(x, mean, half of the 95 % band) of curves over one abscissa, where all of them are; None where one goes back or they share no range."""
    risen = [(x, y) if x[-1] >= x[0] else (x[::-1], y[::-1]) for x, y in curves]
    low, high = max(x[0] for x, _ in risen), min(x[-1] for x, _ in risen)
    if any(np.any(np.diff(x) < 0) for x, _ in risen) or not high > low:
        return None
    finest = max(risen, key=lambda one: len(one[0]))[0]
    x = np.unique(np.concatenate([[low, high], finest[(finest > low) & (finest < high)]]))
    values = np.array([np.interp(x, *one) for one in risen])
    return x, values.mean(axis=0), confidence(len(curves)) * values.std(axis=0, ddof=1) / np.sqrt(len(curves))


def looks(count):
    """So many colours with dashes, no two alike."""
    colours = plt.get_cmap("tab10" if count <= 10 else "tab20").colors
    return [dict(color=colours[k % len(colours)], lw=1.6, ls=("-", "--", "-.", ":")[k // len(colours) % 4]) for k in range(count)]


def of_one_course(x, y, x_other, y_other, near):
    """Whether two curves over rising abscissae share nine tenths of these and are as near as that to each other all along."""
    low, high = max(x[0], x_other[0]), min(x[-1], x_other[-1])
    if high - low < 0.9 * max(x[-1] - x[0], x_other[-1] - x_other[0]):
        return False
    both = (x >= low) & (x <= high)
    return bool(np.any(both)) and np.max(np.abs(np.interp(x[both], x_other, y_other) - y[both])) < near


def interleaved(drawn):
    """{place in the list: dash} of lines that are within a hundredth of the panel on an earlier one: dashes of all that share a course take turns."""
    values = [y for _, (_, _, _, y), _, _ in drawn]
    size = max(map(np.nanmax, values)) - min(map(np.nanmin, values))
    courses = []
    for k, (_, (_, x, _, y), look, half) in enumerate(drawn):
        if half is not None or look["ls"] != "-" or look.get("zorder") == 0 or np.any(np.diff(x) * np.sign(x[-1] - x[0]) < 0):
            continue  # a band, points, a reference that lies broad below all; what goes back
        order = slice(None) if x[-1] >= x[0] else slice(None, None, -1)
        same = next((one for one in courses if of_one_course(*one[0], x[order], y[order], 0.01 * size)), None)
        if same:
            same[1].append(k)
        else:
            courses.append(((x[order], y[order]), [k]))
    return {k: (6 * (len(group) - turn), (6, 6 * (len(group) - 1))) for _, group in courses for turn, k in enumerate(group) if turn}


def curves_of(one, column, runs, directory, entries):
    """[(label, curve, how it is drawn, half of its band or None)] of a column of a measure; what is compared with comes last."""
    drawn = []
    grey = dict(color="0.6", lw=6, alpha=0.6, zorder=0, ls="-")
    groups = over_seeds([row for row in runs if row["run"] != one["reference"]], entries)
    groups |= {f"{row['method']}  {settings_of(row, entries)} (reference)": [row] for row in runs if row["run"] == one["reference"]}
    for (label, rows), look in zip(groups.items(), looks(len(groups))):
        read = {row["run"]: curve(os.path.join(directory, row["directory"], one["table"] + ".csv"), one["against"], column) for row in rows}
        found = {row["run"]: (f"{row['method']}  {settings_of(row, entries)}", read[row["run"]]) for row in rows if read[row["run"]]}
        band = mean_and_band([(x, y) for _, (_, x, _, y) in found.values()]) if len(found) > 1 else None
        if band:
            x, _, y, _ = next(iter(found.values()))[1]
            # Samples that are all the same are no samples: a band of no width would promise what nobody has drawn.
            alike = np.max(band[2]) <= 1e-6 * np.max(np.abs(band[1]))
            words = f"{len(found)} seeds, all alike" if alike else f"mean of {len(found)} seeds"
            drawn.append((f"{label}: {words}", (x, band[0], y, band[1]), dict(look, lw=2), None if alike else band[2]))
        else:
            faint = len(rows) > 1  # seeds whose abscissae go back have no mean: each for itself, in one colour
            drawn += [(text, each, dict(look, lw=1) if faint else grey if label.endswith("(reference)") else look, None)
                      for text, each in (found.values() if faint else [(label, each) for _, each in found.values()])]
    if one["reference_table"] and drawn:
        first, name = drawn[0][1], os.path.basename(one["reference"].rstrip("/"))
        of_file = name == os.path.basename(one["reference_table"])
        found = curve(os.path.join(directory, one["reference_table"]), one["against"] or bare(first[0]), column)
        found = in_units_of(first, found) if found else None
        if found:
            few = of_file and len(found[1]) <= 100
            drawn.append((f"{name} (reference)", found, dict(color=INK, marker="D", markersize=POINT, ls="", zorder=5) if few else grey, None))
    return drawn


def draw_panels(panels, count, path):
    """One panel below the other, their lines in one list beside them. count: of the runs."""
    figure, axes = plt.subplots(len(panels), 1, figsize=(7.5, max(1.2 + 3.2 * len(panels), 0.2 * count + 1)), squeeze=False, layout="constrained")
    handles, banded, turns = {}, False, False
    for panel, drawn in zip(axes[:, 0], panels):
        x, _, y, _ = drawn[0][1]
        along, unit_along = in_prefix(unit_of(x), [found[1] for _, found, _, _ in drawn])
        along, origin, words = strain_axis(x, [found[1] for _, found, _, _ in drawn]) or (along, 0.0, with_unit(x, unit_along))
        factor, unit = in_prefix(unit_of(y), [found[3] for _, found, _, _ in drawn])
        dashes = interleaved(drawn)
        turns = turns or bool(dashes)
        for k, (label, found, look, half) in enumerate(drawn):
            handles[label] = plt.Line2D([], [], label=label, **look)
            place = along * (found[1] - origin)
            panel.plot(place, factor * found[3], **dict(look, ls=dashes.get(k, look["ls"])))
            if half is not None:
                panel.fill_between(place, factor * (found[3] - half), factor * (found[3] + half), color=look["color"], alpha=0.2, lw=0)
                banded = True
        panel.set_xlabel(words, color=INK)
        panel.set_ylabel(f"{stress_words(y)} [{unit}]" if stress_words(y) else with_unit(y, unit), color=INK)
        panel.grid(alpha=0.2)
        style(panel)
    entries = list(handles.values())
    if banded:
        entries.append(plt.Rectangle((0, 0), 1, 1, color="0.5", alpha=0.3, lw=0, label="band: 95 % confidence of the mean\n(Student's t)"))
    if turns:
        entries.append(plt.Line2D([], [], color="none", label="dashes in turns: lines of one course"))
    list_beside(figure, entries)
    figure.savefig(path, dpi=130)
    plt.close(figure)


def leading(directory):
    """The components of F that lead the path of an rve_response run, the first most; none without a path."""
    try:
        table = read_table(os.path.join(directory, "stress.csv"))
    except OSError:
        return []
    if len(table.get("time [s]", [])) < 2 or any(f"{kind}_{c} [{unit}]" not in table for kind, unit in (("F", "1"), ("sigma", "Pa")) for c in COMPONENTS):
        return []
    strain = {c: 100 * (table[f"F_{c} [1]"] - (c in ("xx", "yy"))) for c in COMPONENTS}
    found = input_entries(directory).get(("Path", "Stress components"), "none").replace(" ", "").split(",")
    return [c for c, _ in parts_of_path(strain, found)]


def plot_curves(results, info, directory):
    runs = [row for row in results if row["status"] == "finished"]
    wanted, stresses = {}, {}
    for one in info["measures"]:
        for column in one["columns"] if one["curve"] else []:
            wanted.setdefault((one["table"], one["against"], column, one["reference"]), (one, column))
    leads = {row["run"]: leading(os.path.join(directory, row["directory"])) for row in runs}
    for lead in dict.fromkeys(c for found in leads.values() for c in found):
        one = {"table": "stress", "against": "F_" + lead, "reference": "", "reference_table": ""}
        stresses[lead] = curves_of(one, "sigma_" + lead, [row for row in runs if lead in leads[row["run"]]], directory, info["entries"])
    # Beside a reference there is no run that answers another question than it.
    compared = [row for row in runs if row["run"] not in info.get("not_compared", [])]
    measured = [found for one, column in wanted.values()
                if (found := curves_of(one, column, compared if one["reference"] else runs, directory, info["entries"]))]
    for panels, name in ((measured, "curves.png"), (list(stresses.values()), "stress_strain.png")):
        if panels:
            draw_panels(panels, len(runs), os.path.join(directory, name))
