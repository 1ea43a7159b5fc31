"""Lysis time (C.2.3, Fig. C.3); 5 d in the text, 6 d in Table C.2."""
RUNS = {"lys_5h": {"Death/Lysis time": 18000}, "lys_6d": {"Death/Lysis time": 518400}, "lys_14d": {"Death/Lysis time": 1209600}}
STATEMENTS = [
    ("the shorter T_lys, the more the curve bends off in the beginning (C.2.3): dilatation at 24 h", ("lys_5h", "reference", "lys_14d"),
     lambda a, r, b: a["d24"] < r["d24"] < b["d24"]),
]
PANELS = [("T_lys (Fig. C.3A)", "dilatation", tuple(RUNS)), ("T_lys (Fig. C.3B)", "density", tuple(RUNS))]
