"""The deformation gradient F on an axis: which component leads a path, in what words it is drawn, and the names under which somebody's own
measurements may have it: `compression_along_y [%]` is 1 - F_yy, `compressive_stress_y [kPa]` is -sigma_yy (Cauchy: force over the area as it
is), `compressive_nominal_stress_y` is -P_yy (force over the undeformed area).
"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from units import bare  # noqa: E402

COMPONENTS = ("xx", "xy", "yx", "yy")
NAMES = {"xx": "stretch along x", "yy": "stretch along y", "xy": "shear, x over y", "yx": "shear, y over x"}
# {name: (column of a run, what it is at no deformation, sign)}
OWN_NAMES = {}
for _x in "xy":
    OWN_NAMES |= {f"compression_along_{_x}": (f"F_{2 * _x}", 1.0, -1.0), f"stretch_along_{_x}": (f"F_{2 * _x}", 1.0, 1.0),
                  f"compressive_stress_{_x}": (f"sigma_{2 * _x}", 0.0, -1.0), f"compressive_nominal_stress_{_x}": (f"P_{2 * _x}", 0.0, -1.0)}
STRESSES = {"sigma": "Cauchy stress", "P": "nominal stress (first Piola-Kirchhoff)"}


def parts_of_path(strain, found):
    """[(component, rows)]: for the one or two components that lead most of the path, the rows where they change most, contiguous pieces joined.
    Components that are found, not given, lead only where nothing else changes: then the one that moves most does, all the way."""
    given = [c for c in COMPONENTS if c not in found and np.ptp(strain[c]) > 1e-9]
    if not given:
        return [(max(COMPONENTS, key=lambda c: np.ptp(strain[c])), [(k, k + 1) for k in range(len(strain["xx"]) - 1)])]
    steps = {c: np.abs(np.diff(strain[c])) * (c in given) for c in COMPONENTS}
    leading = np.array(COMPONENTS)[np.argmax([steps[c] for c in COMPONENTS], axis=0)]
    length = {c: steps[c][leading == c].sum() for c in COMPONENTS}
    chosen = [c for c in sorted(COMPONENTS, key=lambda one: -length[one])[:2] if length[c] > 0.02 * max(length.values())]
    return [(c, [(k, k + 1) for k in np.flatnonzero(leading == c)]) for c in chosen]


def abscissa(strain, lead):
    """(sign, words): a component that is mostly pressed is drawn as a compression, to the right. strain: {component: F - I in %}."""
    pressed = lead in ("xx", "yy") and -strain[lead].min() > strain[lead].max()
    return (-1, f"compression along {lead[0]} [%]") if pressed else (1, f"{NAMES[lead]} [%]")


def component_of(column, kind):
    """"yy" of "F_yy [1]" (kind "F"); None where the column is no such component."""
    name = bare(column)
    return name[-2:] if name[:-2] == kind + "_" and name[-2:] in COMPONENTS else None


def strain_axis(column, curves):
    """(factor, origin, words) with which a column F_xx ... is drawn as factor (F - origin), in percent; None for any other column."""
    lead = component_of(column, "F")
    if lead is None:
        return None
    origin = float(lead in ("xx", "yy"))
    sign, words = abscissa({lead: np.concatenate([100 * (np.asarray(one) - origin) for one in curves])}, lead)
    return 100.0 * sign, origin, words


def stress_words(column):
    """"Cauchy stress sigma_yy, positive in tension"; None where the column is no stress of an RVE."""
    return next((f"{words} {kind}_{c},\npositive in tension" for kind, words in STRESSES.items() if (c := component_of(column, kind))), None)


def is_named(own, column):
    """Whether a column of somebody's own table means this one of the run: by its name, or by one of OWN_NAMES."""
    meant = OWN_NAMES.get(bare(own).lower().replace(" ", "_"))
    return bare(own) == bare(column) or (meant is not None and meant[0] == bare(column))


def as_in_run(own, column, values):
    """Values under such a name, already in the unit of the run's column, as the run has them."""
    if bare(own) == bare(column):
        return values
    _, origin, sign = OWN_NAMES[bare(own).lower().replace(" ", "_")]
    return origin + sign * values
