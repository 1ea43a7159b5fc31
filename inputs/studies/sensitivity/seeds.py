"""Four random seeds (C.3, Fig. C.4B)."""
RUNS = {f"seed_{k}": {"Cell/Seed": k} for k in (2, 3, 4)}
STATEMENTS = [
    ("four seeds differ very little (C.3): dilatation at 48 h within 10 %", ("reference", *RUNS),
     lambda r, *others: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in others)),
]
PANELS = [("seeds (Fig. C.4B)", "dilatation", tuple(RUNS))]
