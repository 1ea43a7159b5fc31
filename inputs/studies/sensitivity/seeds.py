"""Four random seeds (C.3, Fig. C.4B): every run of the sensitivity study is repeated with them; here the reference runs one by one."""
RUNS = {}
STATEMENTS = [
    ("four seeds differ very little (C.3): dilatation at 48 h of each within 10 % of the mean", ("reference",),
     lambda r: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in r["each"])),
]
PANELS = [("seeds (Fig. C.4B)", "dilatation", ("reference_seed_2", "reference_seed_3", "reference_seed_4"))]
