"""All friction, with cells, medium and capsule (C.3, Fig. C.4A); four seeds each, whose scatter is as large as the effect."""
FRICTION = {"Contact/Normal friction": 5e10, "Contact/Tangential friction": 5e10, "Contact/Medium friction": 5e8, "Capsule/Friction": 2e10}
RUNS = {f"friction_{name}" + (f"_seed_{seed}" if seed > 1 else ""):
        {entry: value * factor for entry, value in FRICTION.items()} | ({"Cell/Seed": seed} if seed > 1 else {})
        for name, factor in (("1%", 0.01), ("200%", 2)) for seed in (1, 2, 3, 4)}
RUNS |= {f"seed_{seed}": {"Cell/Seed": seed} for seed in (2, 3, 4)}


def mean(runs):
    return sum(run["d48"] for run in runs) / len(runs)


STATEMENTS = [
    (f"{name} of all friction leaves the result largely unaffected (C.3): mean dilatation of four seeds at 48 h within 10 %",
     ("reference", "seed_2", "seed_3", "seed_4", *(f"friction_{name}{seed}" for seed in ("", "_seed_2", "_seed_3", "_seed_4"))),
     lambda *runs: abs(mean(runs[4:]) / mean(runs[:4]) - 1) < 0.1) for name in ("1%", "200%")
]
PANELS = [("friction (Fig. C.4A)", "dilatation", ("friction_1%", "friction_200%"))]
