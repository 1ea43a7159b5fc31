"""Other laws of inhibition: none, linear with the same half point, linear with a longer reach (5.4.2, Fig. C.4G)."""
RUNS = {"constant": {"Growth/Inhibition": "none"}, "linear_0.35": {"Growth/Inhibition": "linear"},
        "linear_0.8": {"Growth/Inhibition": "linear", "Growth/Threshold": 0.8}}
STATEMENTS = [
    ("a constant rate makes the residual growth too fast (5.4.2): rate above 4/3", ("reference", "constant"),
     lambda r, a: a["rate"] > r["rate"] / 0.75),
    ("a linear law with the same half point does about as well in the capsule (5.4.2): dilatation at 48 h within 15 %",
     ("reference", "linear_0.35"), lambda r, a: abs(a["d48"] / r["d48"] - 1) < 0.15),
    ("a linear law with a longer reach overestimates it (5.4.2): dilatation at 48 h above 1.15", ("reference", "linear_0.8"),
     lambda r, a: a["d48"] > 1.15 * r["d48"]),
]
PANELS = [("laws of growth (Fig. C.4G)", "dilatation", tuple(RUNS))]
