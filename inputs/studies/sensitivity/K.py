"""Bulk modulus of the cells under constant growth (C.2.3, Fig. C.2)."""
RUNS = {f"K_{K / 1000:g}k": {"Cell/Bulk modulus": K, "Cell/Strain hardening": "false", "Growth/Inhibition": "none"}
        for K in (2500, 10000, 150000)} | {"K_hardening": {"Growth/Inhibition": "none"}}
STATEMENTS = [
    ("K = 10 kPa makes the density rise less than K = 2.5 kPa, 150 kPa less still (C.2.3)", ("K_2.5k", "K_10k", "K_150k"),
     lambda a, b, c: a["density"] > b["density"] > c["density"]),
    ("K = 150 kPa overestimates the first growth (C.2.3): dilatation at 24 h above that of K = 10 kPa", ("K_10k", "K_150k"),
     lambda a, b: b["d24"] > a["d24"]),
    ("hardening alone does not slow the residual growth to that with inhibition (C.2.3): rate above 4/3", ("reference", "K_hardening"),
     lambda r, a: a["rate"] > r["rate"] / 0.75),
]
PANELS = [(f"K, constant growth (Fig. C.2{letter})", what, tuple(RUNS))
          for letter, what in (("A", "dilatation"), ("B", "density"), ("C", "pressure"))]
