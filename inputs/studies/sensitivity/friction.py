"""All friction, with cells, medium and capsule (C.3, Fig. C.4A)."""
FRICTION = {"Contact/Normal friction": 5e10, "Contact/Tangential friction": 5e10, "Contact/Medium friction": 5e8, "Capsule/Friction": 2e10}
RUNS = {f"friction_{name}": {entry: value * factor for entry, value in FRICTION.items()} for name, factor in (("1%", 0.01), ("200%", 2))}
STATEMENTS = [
    ("1 % and 200 % of all friction leave the result largely unaffected (C.3): dilatation at 48 h within 10 %",
     ("reference", *RUNS), lambda r, *others: all(abs(x["d48"] / r["d48"] - 1) < 0.1 for x in others)),
]
PANELS = [("friction (Fig. C.4A)", "dilatation", tuple(RUNS))]
