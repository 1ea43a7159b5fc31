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
from drawing import plt  # noqa: E402
import plot  # noqa: E402
import study  # noqa: E402
import tissue_gravity  # noqa: E402


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

    def test_a_line_over_another_of_the_same_course_has_gaps(self):
        t = drawing.np.linspace(0., 1., 20)
        columns = {"work": 10 * t, "dissipated": 3 * t, "heat": 3 * t + 0.01, "kinetic": 4 * t, "again": 3 * t}
        self.assertEqual(plot.covering(columns), {"heat": 0, "again": 1})

    def test_a_scale_that_does_not_hold_all_values_is_pointed_there(self):
        norm = drawing.matplotlib.colors.Normalize(1., 2.)
        self.assertEqual([drawing.beyond(norm, values) for values in ([1., 2.], [1., 3.], [0., 2.], [0., 3.])], ["neither", "max", "min", "both"])

    def test_rotation_and_shear_of_a_piece_are_told_apart(self):
        np, a = drawing.np, drawing.np.radians(10.)
        turn = np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
        for F, turned, sheared in ((turn @ np.diag([1.2, 0.9]), 10., 0.), (np.array([[1., np.tan(a)], [np.tan(a), 1.]]), 0., 20.),
                                   (np.array([[1., 0.], [np.tan(a), 1.]]), np.degrees(np.arctan(np.tan(a) / 2)), 10.), (turn.T, -10., 0.)):
            found = tissue_gravity.turn_and_shear(F)
            self.assertAlmostEqual(found[0], turned, places=9)
            self.assertAlmostEqual(found[1], sheared, places=9)

    def test_a_study_draws_what_varies_in_the_order_of_the_outputs(self):
        columns = ["cpu_time_s", "m [N]", "a [m]", "force_at_10 [N]", "same [1]", "z [s]"] + [f"n{k}" for k in range(20)]
        rows = [{name: str(1 + 0.1 * k) for name in columns} | {"same [1]": str(2. + 1e-6 * k)} for k in range(3)]
        info = {"draw": "all", "results": ["z", "force_at_*", "same"] + [f"n{k}" for k in range(20)] + ["a"]}
        panels, left_out = study.panels_of(info, columns, rows)
        self.assertEqual(panels[:3] + panels[-2:], [["m [N]"], ["z [s]"], ["force_at_10 [N]"], ["n7"], ["cpu_time_s"]])
        self.assertEqual(len(panels), study.MOST)
        self.assertEqual(left_out, [f"n{k}" for k in range(8, 20)] + ["a"])

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

    def test_of_two_pictures_of_one_name_the_later_stays_and_a_users_is_kept(self):
        # a table and its scene share a name (laplace.csv, laplace.png)
        with tempfile.TemporaryDirectory() as directory:
            with open(os.path.join(directory, "made_by_turgor.txt"), "w", encoding="utf-8") as file:
                file.write("laplace.csv\n")
            ours, theirs = os.path.join(directory, "laplace.png"), os.path.join(directory, "mine.png")
            with open(theirs, "w", encoding="utf-8") as file:
                file.write("theirs")
            for width in (1, 2):
                plt.figure(figsize=(width, 1)).savefig(ours, dpi=10)
                plt.figure(figsize=(width, 1)).savefig(theirs, dpi=10)
            drawing._name_all()
            drawing._drawn.clear()
            self.assertEqual(plt.imread(ours).shape[1], 20)
            with open(theirs, encoding="utf-8") as file:
                self.assertEqual(file.read(), "theirs")

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
