"""Share of the free growth below which cells rest (5.3.1 H.III; 5.4.2, Fig. 5.5A)."""
RUNS = {f"qui_{a}": {"Growth/Quiescence below": a} for a in (0.33, 0.5)}
STATEMENTS = [
    ("alpha_qui up to 0.33 changes little (5.4.2): dilatation at 48 h within 10 %", ("reference", "qui_0.33"),
     lambda r, a: abs(a["d48"] / r["d48"] - 1) < 0.1),
    ("alpha_qui = 0.5 stalls the growth (5.4.2): rate below 3/4", ("reference", "qui_0.5"), lambda r, a: a["rate"] < 0.75 * r["rate"]),
]
PANELS = [("alpha_qui (Fig. 5.5A)", "dilatation", tuple(RUNS))]
