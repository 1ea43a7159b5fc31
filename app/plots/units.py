"""Units as tables have them, in the brackets of a column: "mN", "um/d", "N s/m", "kg/m^3", "min", "%". The same in C++ for the references
of a study: app/units.h; tests/app/units.csv is the test of both."""
import math
import re

# factor, powers of m, kg, s, rad; the second table takes no prefix
PREFIXED = {"m": (1.0, (1, 0, 0, 0)), "g": (1e-3, (0, 1, 0, 0)), "s": (1.0, (0, 0, 1, 0)), "N": (1.0, (1, 1, -2, 0)), "Pa": (1.0, (-1, 1, -2, 0)),
            "J": (1.0, (2, 1, -2, 0)), "W": (1.0, (2, 1, -3, 0)), "Hz": (1.0, (0, 0, -1, 0)), "bar": (1e5, (-1, 1, -2, 0))}
PLAIN = {"min": (60.0, (0, 0, 1, 0)), "h": (3600.0, (0, 0, 1, 0)), "d": (86400.0, (0, 0, 1, 0)), "rad": (1.0, (0, 0, 0, 1)),
         "deg": (math.pi / 180, (0, 0, 0, 1)), "degrees": (math.pi / 180, (0, 0, 0, 1)), "1": (1.0, (0, 0, 0, 0)), "%": (1e-2, (0, 0, 0, 0))}
PREFIXES = {"f": 1e-15, "p": 1e-12, "n": 1e-9, "u": 1e-6, "\u00b5": 1e-6, "\u03bc": 1e-6, "m": 1e-3, "c": 1e-2, "k": 1e3, "M": 1e6, "G": 1e9}
WORD = re.compile(r"\s*(\*|/)?\s*([^\s*/^]+)(?:\^(-?[1-9]))?")


def unit_of(column):
    """What stands in the brackets of "force [N]"; empty without."""
    return column[column.rfind("[") + 1:column.rfind("]")].strip() if "[" in column else ""


def bare(column):
    """The name without its unit."""
    return column.split("[")[0].strip()


def _named(word):
    if word in PREFIXED or word in PLAIN:
        return (PREFIXED | PLAIN)[word]
    if word[:1] in PREFIXES and word[1:] in PREFIXED:
        factor, powers = PREFIXED[word[1:]]
        return factor * PREFIXES[word[0]], powers
    return None


def _parsed(text):
    """A product of words, each with an integer power; / divides by the word behind it. None for what is not known."""
    factor, powers, place = 1.0, [0] * 4, 0
    text = text.strip()
    while place < len(text):
        found = WORD.match(text, place)
        named = _named(found[2]) if found else None
        if named is None:
            return None
        times = int(found[3] or 1) * (-1 if found[1] == "/" else 1)
        factor *= named[0] ** times
        powers = [a + times * b for a, b in zip(powers, named[1])]
        place = found.end()
    return factor, powers


def unit_factor(old, new):
    """What turns a number in one unit into one in the other; None where they are no units of the same quantity, or not known."""
    if old == new:
        return 1.0
    a, b = _parsed(old), _parsed(new)
    return a[0] / b[0] if a and b and a[1] == b[1] else None
