"""Units of a user's columns: the list that those of the program are tested with as well."""
import csv
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "app", "plots"))
from units import unit_factor  # noqa: E402


class Units(unittest.TestCase):
    def test_factors_between_units(self):
        with open(os.path.join(HERE, "units.csv"), newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                with self.subTest(**row):
                    factor = unit_factor(row["from"], row["to"])
                    self.assertEqual(factor is not None, bool(row["factor"]))
                    if factor is not None:
                        self.assertAlmostEqual(factor / float(row["factor"]), 1.0, places=13)


if __name__ == "__main__":
    unittest.main()
