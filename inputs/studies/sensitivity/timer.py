"""Division after a fixed time instead of at a fixed size (C.2.3, Fig. C.3C)."""
RUNS = {"timer": {"Growth/Division at": "time"}}
STATEMENTS = [
    ("dividing at a fixed time makes the density at 48 h too high (Fig. C.3C): above the reference by more than 10 %",
     ("reference", "timer"), lambda r, a: a["density"] > 1.1 * r["density"]),
]
PANELS = [("timer (Fig. C.3C)", "density", tuple(RUNS))]
