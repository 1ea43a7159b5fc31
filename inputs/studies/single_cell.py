"""Tables of the single-cell scenes: each named study is a list of runs whose results make the rows of one CSV.

  python3 inputs/studies/single_cell.py NAME [--program build/app/turgor] [--directory runs] [--only-table]

NAME: laplace_convergence, laplace_support, laplace_ordering, shell_modes, shell_support, impact_matrix, failure, largest_stretch, compression_2d, extremes. Runs that are
finished in the directory are not repeated. The table goes to doc/results/single_cell/NAME.csv.
"""
from table_of_runs import main

FLAT = {"Dimension": 2, "Cell/Radius": 50e-6, "Cell/Wall thickness": 1e-6, "Cell/Wall density": 1300,
        "Cell/Anneal steps": 3000}


def laplace_convergence():
    for nodes, fluid in ((36, 60), (50, 121), (71, 242), (100, 484), (141, 968), (200, 1936)):
        yield f"2D_{nodes}", "laplace", {**FLAT, "Cell/Ring nodes": nodes, "Cell/Fluid particles": fluid,
                                         "Cell/Anneal steps": 60 * nodes}
    for nu, fluid in ((4, 120), (6, 390), (8, 930), (10, 1850), (14, 5000)):
        yield f"3D_{nu}", "laplace", {"Cell/Frequency": nu, "Cell/Fluid particles": fluid, "Cell/Anneal steps": 300 * nu,
                                      "Cell/Rest residual": 0.02}


def laplace_support():
    for ratio in (2.0, 2.2, 2.4, 2.6, 3.0, 3.4):
        yield f"2D_{ratio}", "laplace", {**FLAT, "Cell/Fluid particles": 484, "Cell/Support ratio": ratio, "Cell/Anneal steps": 6000}


def laplace_ordering():
    for ordering in (0, 0.001, 0.003, 0.01, 0.03):
        yield f"2D_{ordering}", "laplace", {**FLAT, "Cell/Fluid particles": 484, "Cell/Ordering": ordering}


def shell_modes():
    for nu in (4, 6, 8, 12):
        yield f"empty_{nu}", "shell_oscillation", {"Filled": "false", "Cell/Frequency": nu, "Samples per period": 200}
    for c in (50, 250):
        for nu, fluid in ((6, 400), (8, 930), (10, 2000)):
            for seed in (1, 2, 3):
                yield f"c{c}_{fluid}_{seed}", "shell_oscillation", {
                    "Sound speed": c, "Cell/Frequency": nu, "Cell/Fluid particles": fluid, "Cell/Seed": seed}


def shell_support():
    """Both kernels over the support: what smoothing and what disorder cost."""
    for kernel, ratios in (("wendland", (2.0, 2.3, 2.6, 3.0)), ("fourth_order", (2.6, 3.0, 3.4))):
        for ratio in ratios:
            yield f"{kernel}_{ratio}", "shell_oscillation", {
                "Cell/Frequency": 8, "Cell/Fluid particles": 930, "Cell/Kernel": kernel, "Cell/Support ratio": ratio}


SMALL = {"Cell/Frequency": 4, "Cell/Fluid particles": 200, "Frames": 0}
SLOW = {"Speed": 1, "Both plates move": "true", "Damping": 2e5, "Cell/Wall density": 32500}


def impact_matrix():
    for stiffness in (100, 1000):
        for viscosity in (1e-3, 1e-2, 1e-1, 1):
            yield f"G{stiffness}_mu{viscosity}", "cell_impact", {
                **SMALL, "Cell/Anneal steps": 1000 if stiffness == 100 else 3000, "Deformation": 0.4, "Cell/Wall stiffness": stiffness, "Cell/Fluid viscosity": viscosity}


def failure():
    """Slow: the largest stretch is at the edge of the contact for small lambda_c, at the equator for a large one."""
    for stretch, deformation in ((1.04, 0.22), (1.2, 0.56)):
        entries = {**SMALL, "Cell/Anneal steps": 2500, "Critical stretch": stretch, "Deformation": deformation, "Frames": 8}
        yield f"slow_{stretch}", "cell_failure", {**entries, **SLOW}
        for viscosity in (1e-3, 1):
            yield f"impact_{stretch}_mu{viscosity}", "cell_failure", {**entries, "Cell/Fluid viscosity": viscosity}


def largest_stretch():
    """Cell of one pressure, slow: where the largest stretch lies, against the balloon's, over the net's resolution."""
    for stiffness in (100, 6):
        for nu in (6, 10, 14):
            yield f"G{stiffness}_{nu}", "cell_compression", {
                "Cell/Fluid": "pressure", "Cell/Frequency": nu, "Speed": 1, "Frames": 0, "Deformation": 0.51,
                "Cell/Wall stiffness": stiffness, "Cell/Anneal steps": 4000 if stiffness == 100 else 16000}


def compression_2d():
    for sharpness, drop in ((15, 0), (15, 0.3), (15, 0.6), (15, 0.9), (5, 0.9), (30, 0.9), (100, 0.9), (15, 1)):
        yield f"A{sharpness}_B{drop}", "cell_compression", {
            **FLAT, "Cell/Yield sharpness": sharpness, "Cell/Yield drop": drop, "Cell/Fluid": "pressure", "Frames": 0,
            "Cell/Wall density": 32500}
    for name, entries in (("plates_100", {"Plate stiffness": 100}), ("plates_10000", {"Plate stiffness": 1e4}),
                          ("slow", {"Speed": 0.02}), ("no_bending", {"Cell/Wall bending": "false"}),
                          ("beta_0.25", {"Cell/Wall beta": 0.25}), ("beta_1", {"Cell/Wall beta": 1}),
                          ("turgor_50k", {"Cell/Turgor": 50e3}), ("modulus_0.6M", {"Cell/Fluid modulus": 6e5}),
                          ("sph", {"Cell/Fluid": "sph"})):
        yield f"A15_B0.9_{name}", "cell_compression", {
            **FLAT, "Cell/Yield drop": 0.9, "Cell/Fluid particles": 484, "Cell/Fluid": "pressure", "Frames": 0,
            "Cell/Wall density": 32500, **entries}


def extremes():
    """Each scene driven, one entry at a time, until it breaks: 162 nodes, 200 particles (2D: 60, 150)."""
    tiny = {"Cell/Frequency": 4, "Cell/Fluid particles": 200, "Cell/Anneal steps": 1000, "Frames": 0, "Deformation": 0.4}
    flat = {**FLAT, **tiny, "Cell/Ring nodes": 60, "Cell/Fluid particles": 150, "Cell/Anneal steps": 3000}
    for entry, values in (("Speed", (20, 50, 100, 200, 500)), ("Deformation", (0.6, 0.75, 0.9)),
                          ("Cell/Wall stiffness", (10, 1e4, 1e5)), ("Cell/Fluid viscosity", (0, 10)),
                          ("Plate stiffness", (10, 1e5)), ("Cell/Fluid modulus", (2e5, 1e8)), ("Step fraction", (0.9, 1.0))):
        for value in values:
            yield f"impact_{entry.split('/')[-1].replace(' ', '_')}_{value:g}", "cell_impact", {**tiny, entry: value}
    for value in (50, 200):
        yield f"impact_2D_Speed_{value}", "cell_impact", {**flat, "Dimension": 2, "Speed": value}
    for value in (0.6, 0.75, 0.9):
        yield f"compression_Deformation_{value}", "cell_compression", {**tiny, "Cell/Fluid": "pressure", "Speed": 1,
                                                                        "Deformation": value}
        yield f"compression_2D_yield_Deformation_{value}", "cell_compression", {
            **flat, "Cell/Fluid": "pressure", "Speed": 1, "Deformation": value, "Cell/Yield drop": 0.9, "Cell/Wall density": 32500}
    for value in (1e6, 3e6, 5e6):
        yield f"compression_Turgor_{value:g}", "cell_compression", {**tiny, "Cell/Fluid": "pressure", "Speed": 1, "Cell/Turgor": value}
    for entry, value in (("Critical stretch", 1.02), ("Speed", 50), ("Deformation", 0.75), ("Cell/Fluid viscosity", 1)):
        yield f"failure_{entry.split('/')[-1].replace(' ', '_')}_{value:g}", "cell_failure", {**tiny, "Cell/Anneal steps": 3000, entry: value}


if __name__ == "__main__":
    main({f.__name__: f for f in (laplace_convergence, laplace_support, laplace_ordering, shell_modes, shell_support, impact_matrix, failure,
                                  largest_stretch, compression_2d, extremes)}, "single_cell", __doc__)
