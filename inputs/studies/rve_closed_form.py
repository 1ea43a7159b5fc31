#!/usr/bin/python3
"""Stress and pressure of RVEs against the closed form of flat walls, over annealed seeds.

    /usr/bin/python3 inputs/studies/rve_closed_form.py -o doc/results/rve/closed_form.csv
    /usr/bin/python3 inputs/studies/rve_closed_form.py --table doc/results/rve/closed_form.csv     print the table again

One process per seed and rule walks a path of F (rve_response, F_dot = 0). Columns: deviatoric
components against the closed form (Pa), the fluid's mean EOS pressure and its virial pressure against p(A). The virial
pressure is p(A) - (tr sigma - tr sigma_closed)/2: what is left of the trace when the flat walls' part is taken out. It is
turgor at F = I by calibration (micro/cells/annealed_cells.h), so its p(A) has no offset; for the EOS mean the closed form
is shifted to the density that the seed's own EOS mean has at F = I.
"""
import argparse
import collections
import csv
import os

from runs import study

TURGOR = 200e3  # Pa, Cell/Turgor
MODULUS = 6e6   # Pa, Cell/Fluid modulus


def stretch(a):
    return ("isochoric %g" % a, (a, 0., 0., 1. / a))


def shear(b):
    return ("shear %g" % b, (1., b, 0., 1.))


IDENTITY = ("I", (1., 0., 0., 1.))
# A name that begins with "way" is only walked through: relaxing starts from the last state moved affinely.
PATH = [IDENTITY, stretch(.99), stretch(.98), ("way", stretch(.99)[1]), ("way", IDENTITY[1]), stretch(1.01),
        stretch(1.02), ("way", stretch(1.01)[1]), shear(.02), shear(.05), ("way", shear(.15)[1]), shear(.3),
        ("way", shear(.5)[1]), ("way", shear(.75)[1]), shear(1.)]


# What a row is called -> the entries that make it.
FLUIDS = {"hydrostatic": {"RVE/Fluid": "hydrostatic"},
          "sph": {"RVE/Fluid": "sph"},
          "sph summed": {"RVE/Fluid": "sph", "SPH/Volume": "summed"},
          "thesis": {"RVE/Fluid": "sph", "SPH/Formulation": "thesis"}}


def entries_of(path, fluid, rule, seed, more):
    keyframes = " | ".join("%d : %.17g, %.17g; %.17g, %.17g" % ((k,) + F) for k, (_, F) in enumerate(path))
    return {"Path/Keyframes": keyframes, "Path/Points": len(path), "Path/F_dot": "0, 0; 0, 0", "RVE/Rule": rule, "SPH/Seed": seed,
            **FLUIDS[fluid], **more}


def walk(directory):
    """Rows of stress.csv; those that a failed run had before it ended."""
    table = os.path.join(directory, "stress.csv")
    if not os.path.exists(table):
        return []
    with open(table, encoding="utf-8") as file:
        return [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def eos_pressure(p_reference, J):
    """p at the density of p_reference over J: Eq. 2.22."""
    return MODULUS * ((1. + p_reference / MODULUS) / J ** 7 - 1.)


def compare(directory, path, fluid, rule, seed):
    result, eos_at_I = [], None
    for (name, F), row in zip(path, walk(directory)):
        if name == "I":
            eos_at_I = row["pressure"]
        if name.startswith("way"):
            continue
        J = F[0] * F[3] - F[1] * F[2]
        half_sum = .5 * (row["sigma_xx"] + row["sigma_yy"])
        closed_half_sum = .5 * (row["closed_sigma_xx"] + row["closed_sigma_yy"])
        result.append(collections.OrderedDict(
            fluid=fluid, rule=rule, seed=seed, deformation=name,
            F_xx=F[0], F_xy=F[1], F_yx=F[2], F_yy=F[3],
            half_difference=.5 * (row["sigma_xx"] - row["sigma_yy"]),
            closed_half_difference=.5 * (row["closed_sigma_xx"] - row["closed_sigma_yy"]),
            sigma_xy=row["sigma_xy"], closed_sigma_xy=row["closed_sigma_xy"],
            deviatoric_error=row["deviatoric_deviation"],
            mean_eos_pressure=row["pressure"], eos_closed_form=eos_pressure(eos_at_I, J),
            virial_pressure=row["closed_pressure"] - (half_sum - closed_half_sum),
            closed_pressure=row["closed_pressure"],
            residual=row["residual"], iterations=row["iterations"], cpu_seconds=row["cpu_time"]))
    return result


def print_table(rows):
    groups = collections.OrderedDict()
    for row in rows:
        groups.setdefault((row["fluid"], row["rule"], row["deformation"]), []).append(row)
    print("Deviatoric: largest over the seeds of max(|(sxx-syy)/2|, |sxy|) error; allowed max(1 %, 0.5 % of turgor). "
          "Pressures: mean (least ... most) over the seeds of p - p(A), in % of turgor.\n")
    print("| fluid, rule | F | seeds | closed form, kPa | stress (mean), kPa | largest error, kPa | of allowed | spread "
          "over seeds, kPa | EOS mean - p(A), % | virial - p(A), % | largest residual | steps | CPU s |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    for (fluid, rule, name), group in groups.items():
        values = [{k: float(v) for k, v in row.items() if k not in ("fluid", "rule", "deformation")} for row in group]
        mean = lambda key: sum(v[key] for v in values) / len(values)
        shown = "sigma_xy" if name.startswith("shear") else "half_difference"
        closed = values[0]["closed_" + shown]
        size = max(abs(values[0]["closed_half_difference"]), abs(values[0]["closed_sigma_xy"]))
        allowed = max(.01 * size, .005 * TURGOR)
        error = max(v["deviatoric_error"] for v in values)
        spread = max(v[shown] for v in values) - min(v[shown] for v in values)

        def off(a, b):
            all_off = [100. * (v[a] - v[b]) / TURGOR for v in values]
            return "%+.2f (%+.2f ... %+.2f)" % (sum(all_off) / len(all_off), min(all_off), max(all_off))
        print("| %s, %s | %s | %d | %.2f | %.2f | %.3f | %.2f | %.3f | %s | %s | %.1g | %.0f | %.2f |" % (
            fluid, rule, name, len(values), 1e-3 * closed, 1e-3 * mean(shown), 1e-3 * error, error / allowed,
            1e-3 * spread, off("mean_eos_pressure", "eos_closed_form"), off("virial_pressure", "closed_pressure"),
            max(v["residual"] for v in values), mean("iterations"), mean("cpu_seconds")))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="closed_form.csv")
    parser.add_argument("--table", help="print the table of this file and stop")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--relax-steps", type=int, default=6000)
    parser.add_argument("--tolerance", type=float, default=2e-3)
    parser.add_argument("--rules", default="hydrostatic/cauchy_born,hydrostatic/elastic_equilibrium,"
                                           "sph/cauchy_born,sph/elastic_equilibrium,"
                                           "sph summed/elastic_equilibrium,thesis/cauchy_born,thesis/elastic_equilibrium")
    parser.add_argument("--only", help="walk from I straight to this deformation alone, e.g. 'shear 1'")
    parser.add_argument("--set", action="append", default=[], help="further entries, Section/Name=value")
    options = parser.parse_args()
    if options.table:
        with open(options.table) as file:
            return print_table(list(csv.DictReader(file)))
    path = PATH if not options.only else [IDENTITY] + [point for point in PATH if point[0] == options.only]
    asked = {}
    for kind in options.rules.split(","):
        fluid, rule = kind.split("/")
        entries = {"RVE/Relax steps": options.relax_steps, "RVE/Tolerance": options.tolerance} if fluid != "hydrostatic" else {}
        entries.update(item.split("=", 1) for item in options.set)
        for seed in range(1, (1 if fluid == "hydrostatic" else options.seeds) + 1):
            asked[f"{fluid}, {rule}, seed {seed}"] = (fluid, rule, seed, entries)
    runs = study("rve_closed_form", [(label, "rve_response", entries_of(path, *one)) for label, one in asked.items()])
    rows = [row for label, one in asked.items() for row in compare(runs[label]["directory"], path, *one[:3])]
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({k: "%.9g" % v if isinstance(v, float) else v for k, v in row.items()})
    print_table(rows)


if __name__ == "__main__":
    main()
