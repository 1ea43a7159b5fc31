"""What the pictures say: published numbers over the published input only, the user's own points where columns match,
no zigzag of a table that is no series."""
import os
import subprocess
import sys
import tempfile
import unittest

PLOTS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "app", "plots")
sys.path.insert(0, PLOTS)
import drawing  # noqa: E402
import plot  # noqa: E402


class Pictures(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.directory = self.place.name

    def tearDown(self):
        self.place.cleanup()

    def write(self, name, text):
        path = os.path.join(self.directory, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def test_only_a_rising_first_column_is_a_series(self):
        self.assertIsNotNone(plot.plot_series(self.write("rises.csv", "time [s],a [m]\n0,1\n1,2\n2,1\n")))
        self.assertIsNone(plot.plot_series(self.write("back.csv", "x [m],a [m]\n0,1\n1,2\n0.5,1\n")))
        self.assertIsNone(plot.plot_series(self.write("table.csv", "cell_x,cell_y,a [m]\n0,0,1\n0,1,2\n")))

    def test_no_line_looks_like_another(self):
        styles = drawing.line_styles(40)
        self.assertEqual(len(set(styles)), 40)

    def test_published_numbers_need_the_published_input(self):
        self.write("input.prm", "subsection Cell\n  set Cycle time = 61200 # s\nend\n")
        self.assertTrue(drawing.input_is(self.directory, {("Cell", "Cycle time"): 61200}))
        self.assertFalse(drawing.input_is(self.directory, {("Cell", "Cycle time"): 50000}))
        self.assertFalse(drawing.input_is(self.directory, {("Cell", "Modulus"): 450}))

    def test_scale_bars_follow_the_size(self):
        self.assertEqual([drawing.round_length(x) for x in (0.07, 0.3, 1.2, 5.0)], [0.05, 0.2, 1.0, 5.0])

    def test_units_take_the_prefix_that_fits(self):
        for unit, largest, factor, word in (("m", 3e-5, 1e6, "\u00b5m"), ("Pa", 2e5, 1e-3, "kPa"), ("s", 3e-4, 1e6, "\u00b5s"), ("s", 2e5, 1 / 3600, "h"),
                                            ("1", 3e-5, 1., "1"), ("m", 0., 1., "m"), ("J/m", 1000., 1e-3, "kJ/m"), ("m^3", 1e-12, 1., "m^3")):
            with self.subTest(unit=unit, largest=largest):
                found = drawing.in_prefix(unit, [drawing.np.array([0., -largest])])
                self.assertEqual(found[1], word)
                self.assertAlmostEqual(found[0] / factor, 1., places=12)

    def test_a_small_column_is_not_drawn_along_zero(self):
        columns = {"a": [1., 2.], "b": [1e-6, 0.], "c": [0., 0.], "d": [0.1, 0.]}
        self.assertEqual(drawing.of_one_scale({name: drawing.np.array(v) for name, v in columns.items()}), ([["a", "d"], ["b"]], ["c"]))

    def test_own_points_need_the_same_name_and_unit(self):
        self.write("input.prm", "set Scenario = none\n")
        self.write("growth.csv", "time [s],radius [m]\n0,1\n1,2\n")
        run = [sys.executable, os.path.join(PLOTS, "plot.py"), self.directory, "--data"]
        good = self.write("own.csv.txt", "time [s],radius [m]\n0.5,1.5\n")
        self.assertEqual(subprocess.run(run + [good], capture_output=True).returncode, 0)
        empty = self.write("empty.txt", "words\n")
        done = subprocess.run(run + [empty], capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("needs one header line", done.stderr)


if __name__ == "__main__":
    unittest.main()
