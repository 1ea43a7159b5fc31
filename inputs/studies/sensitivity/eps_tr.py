"""Strain at which growth is half (5.2; 5.4.2, Fig. 5.6A)."""
RUNS = {f"eps_{e}": {"Growth/Threshold": e} for e in (0.2, 0.5)}
STATEMENTS = [
    ("a larger threshold dilates faster over the whole time (5.4.2): at 24 h, 48 h and in rate", ("eps_0.2", "reference", "eps_0.5"),
     lambda a, r, b: all(a[k] < r[k] < b[k] for k in ("d24", "d48", "rate"))),
]
PANELS = [("threshold eps_tr (Fig. 5.6A)", "dilatation", tuple(RUNS))]
