"""Energy of adhesion (C.3, Fig. C.4E); beyond 250 % contacts are as wide as cells, and the input is refused."""
RUNS = {"W_10%": {"Contact/Adhesion": 1e-5}, "W_250%": {"Contact/Adhesion": 2.5e-4}}
STATEMENTS = [
    ("adhesion makes no significant change (C.3; here to 250 %, beyond it contacts are as wide as cells): within 10 %",
     ("reference", "W_10%", "W_250%"), lambda r, a, b: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in (a, b))),
]
PANELS = [("adhesion W (Fig. C.4E)", "dilatation", tuple(RUNS))]
