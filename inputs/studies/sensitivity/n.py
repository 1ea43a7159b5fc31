"""Hill exponent n of the inhibition of growth (5.2; 5.4.2, Fig. 5.5A)."""
RUNS = {f"n_{n}": {"Growth/Exponent": n} for n in (2, 4, 1000)}
STATEMENTS = [
    ("n = 1 and n = 2 hardly differ (5.4.2): dilatation at 48 h within 10 %", ("reference", "n_2"),
     lambda r, a: abs(a["d48"] / r["d48"] - 1) < 0.1),
    ("n = 4 grows faster in the beginning than n = 1 (5.4.2): dilatation at 24 h", ("reference", "n_4"), lambda r, a: a["d24"] > r["d24"]),
    ("n = 4 flattens the residual growth (5.4.2): rate below 3/4 of that of n = 1", ("reference", "n_4"),
     lambda r, a: a["rate"] < 0.75 * r["rate"]),
    ("n -> infinity leads to a plateau (5.4.2): rate below 1/4", ("reference", "n_1000"), lambda r, a: a["rate"] < 0.25 * r["rate"]),
]
PANELS = [("Hill exponent n (Fig. 5.5A)", "dilatation", tuple(RUNS))]
