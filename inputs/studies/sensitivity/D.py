"""Motility of the cells (C.3, Fig. C.4F)."""
RUNS = {"D_10%": {"Motion/Motility": 1e-17}, "D_500%": {"Motion/Motility": 5e-16}}
STATEMENTS = [
    ("motility between 10 % and 500 % makes no significant change (C.3): within 10 %", ("reference", "D_10%", "D_500%"),
     lambda r, a, b: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in (a, b))),
]
PANELS = [("motility D (Fig. C.4F)", "dilatation", tuple(RUNS))]
