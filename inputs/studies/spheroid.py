"""Tables of growing spheroids: each named study is a list of runs whose results make the rows of one CSV.

  python3 inputs/studies/spheroid.py NAME [--program build/app/turgor] [--directory runs] [--only-table]

tolerance    error and cost of the engine's tolerance and of the interval between steps of the cells' life (growth inhibited, so that
             pressure acts back)
relaxation   relaxation time of a compressed spheroid over friction and over the cells' own T_rel
free         free growth over seed, friction, adhesion, direction of division
packing      a capsule of 50 um by C.9 as repaired and by the contacts of a closest packing; spheroid_density.py reads its fields
The table goes to doc/results/spheroid/NAME.csv.
"""
from table_of_runs import main

SMALL = {"Frames": 0, "Samples": 200, "Checkpoints": 0}


def tolerance():
    # a monolayer: its middle is under pressure, so that all couplings act; one deterministic division direction
    case = {**SMALL, "Duration": 250000, "Growth/Threshold": 0.01}
    yield "finest", "monolayer", {**case, "Motion/Tolerance": 2e-4, "Motion/Growth tolerance": 2e-4}
    for growth in (1e-3, 2e-3, 4e-3, 8e-3):
        yield f"growth_{growth}", "monolayer", {**case, "Motion/Tolerance": 2e-4, "Motion/Growth tolerance": growth}
    for method in ("euler", "heun", "implicit"):
        for step in (1e-3, 4e-3, 1.6e-2):
            yield f"{method}_{step}", "monolayer", {**case, "Motion/Method": method, "Motion/Tolerance": step,
                                                    "Motion/Growth tolerance": 2e-3}


def relaxation():
    for factor in (0.01, 0.1, 1, 3, 7):
        for T_rel in (0, 7200, 18000):
            yield f"friction_x{factor}_T{T_rel / 3600:g}h", "spheroid_relaxation", {
                **SMALL, "Samples": 400, "Duration": 86400 * (factor if factor < 1 else max(1, factor / 2)), "Cell/Relaxation time": T_rel,
                "Settling time": 86400 * min(1, factor),
                "Contact/Normal friction": 5e10 * factor, "Contact/Tangential friction": 5e10 * factor,
                "Contact/Medium friction": 5e8 * factor}
    for size in (0.85, 0.95):
        yield f"size_{size}", "spheroid_relaxation", {**SMALL, "Samples": 400, "Compressed size": size}
    for cells in (100, 1000):
        yield f"cells_{cells}", "spheroid_relaxation", {**SMALL, "Samples": 400, "First cells": cells}


def free():
    case = {**SMALL, "Duration": 428400}
    for seed in (1, 2, 3, 4):
        yield f"seed_{seed}", "spheroid_free", {**case, "Cell/Seed": seed}
    for factor in (0.3, 2):
        yield f"friction_x{factor}", "spheroid_free", {**case, "Contact/Normal friction": 5e10 * factor,
                                                       "Contact/Tangential friction": 5e10 * factor,
                                                       "Contact/Medium friction": 5e8 * factor}
    for factor in (0.1, 2):
        yield f"adhesion_x{factor}", "spheroid_free", {**case, "Contact/Adhesion": 1e-4 * factor}
    for direction in ("random", "least_stress"):
        yield f"division_{direction}", "spheroid_free", {**case, "Division/Direction": direction}
    yield "division_inside", "spheroid_free", {**case, "Division/Distance": "inside"}
    yield "exponential_rate", "spheroid_free", {**case, "Growth/Rate": "exponential"}
    yield "hill", "spheroid_free", {**case, "Growth/Inhibition": "hill"}
    for K in (2500, 10000):
        yield f"K_{K}_hill", "spheroid_free", {**case, "Growth/Inhibition": "hill", "Cell/Bulk modulus": K}


def packing():
    case = {"Capsule/Radius": 50e-6, "Capsule/Thickness": 4e-6, "First cells": 180, "Capsule/Time confined": 172800, "Duration": 400000,
            "Frames": 150, "Checkpoints": 0}
    for law in ("C9", "closest"):
        for seed in (1, 2):
            yield f"{law}_seed{seed}", "spheroid_capsule", {**case, "Contact/Local stiffness": law, "Cell/Seed": seed}
        yield f"{law}_solid_0.1", "spheroid_capsule", {**case, "Contact/Local stiffness": law, "Death/Solid fraction": 0.1}


if __name__ == "__main__":
    main({f.__name__: f for f in (tolerance, relaxation, free, packing)}, "spheroid", __doc__)
