"""What the pictures say: published numbers over the published input only, the user's own points where columns match,
no zigzag of a table that is no series."""
import os
import subprocess
import sys
import tempfile
import unittest

PLOTS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "app", "plots")
sys.path.insert(0, PLOTS)
import deformation  # noqa: E402
import drawing  # noqa: E402
from drawing import plt  # noqa: E402
import legible  # noqa: E402
import own_data  # noqa: E402
import plot  # noqa: E402
import rve_response  # noqa: E402
import study  # noqa: E402
import study_curves  # noqa: E402
import study_tables  # noqa: E402
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

    def test_a_tissue_without_outlined_rves_has_a_picture(self):
        empty = self.write("rve_outlines.csv", "time [s],rve,ring,x [m],y [m]\n")
        self.assertEqual(tissue_gravity.read_rves(empty, 0.1), [])

    def test_a_study_draws_what_varies_in_the_order_of_the_outputs(self):
        columns = ["cpu_time_s", "m [N]", "a [m]", "force_at_10 [N]", "same [1]", "z [s]"] + [f"n{k}" for k in range(20)]
        rows = [{name: str(1 + 0.1 * k) for name in columns} | {"same [1]": str(2. + 1e-6 * k)} for k in range(3)]
        info = {"draw": "all", "results": ["z", "force_at_*", "same"] + [f"n{k}" for k in range(20)] + ["a"]}
        panels, left_out = study.panels_of(info, columns, rows)
        self.assertEqual(panels[:3] + panels[-2:], [["m [N]"], ["z [s]"], ["force_at_10 [N]"], ["n7"], ["cpu_time_s"]])
        self.assertEqual(len(panels), study.MOST)
        self.assertEqual(left_out, [f"n{k}" for k in range(8, 20)] + ["a"])

    def test_a_value_that_a_run_has_but_that_is_not_swept_there_is_no_point_of_the_sweep(self):
        self.write("results.csv", "run,directory,A [m],B\nx,d1,1,5\ny,d2,2,6\nz,d1,1,5\n")
        info = {"entries": ["A [m]", "B"], "swept": {"x": ["A [m]"], "y": ["B"], "z": []}}
        rows = study_tables.rows_of(self.directory, "results.csv", info)
        self.assertEqual([(row["A [m]"], row["B"]) for row in rows], [("1", ""), ("", "6"), ("", "")])
        self.assertEqual(study_tables.same_runs(rows), {"z": "x"})
        self.assertEqual(study_tables.settings_of({"Cell/Fluid viscosity [Pa s]": "1e-3", "N": "4"}, ["Cell/Fluid viscosity [Pa s]", "N"]),
                         "Fluid viscosity 1e-3 Pa s, N 4")

    def test_own_measurements_stand_in_a_studys_curves_in_the_units_of_the_runs(self):
        self.write("force.csv", "time [s],force [N]\n0,0\n1,2\n")
        self.write("mine.csv", "force [mN],time [min]\n500,0.01\n")
        one = {"table": "force", "against": "", "reference": "mine.csv", "reference_table": "mine.csv"}
        runs = [{"run": "a", "method": "a", "settings": "", "directory": "."}]
        label, found, _, _ = study_curves.curves_of(one, "force", runs, self.directory, [])[-1]
        self.assertEqual((label, found[0], found[2]), ("mine.csv (reference)", "time [s]", "force [N]"))
        self.assertAlmostEqual(found[1][0], 0.6)
        self.assertAlmostEqual(found[3][0], 0.5)

    def test_published_numbers_need_the_published_input(self):
        self.write("input.prm", "subsection Cell\n  set Cycle time = 61200 # s\nend\n")
        self.assertTrue(drawing.input_is(self.directory, {("Cell", "Cycle time"): 61200}))
        self.assertFalse(drawing.input_is(self.directory, {("Cell", "Cycle time"): 50000}))
        self.assertFalse(drawing.input_is(self.directory, {("Cell", "Modulus"): 450}))

    def test_scale_bars_follow_the_size(self):
        self.assertEqual([drawing.round_length(x) for x in (0.07, 0.3, 1.2, 5.0)], [0.05, 0.2, 1.0, 5.0])

    def test_units_take_the_prefix_that_fits(self):
        for unit, largest, factor, word in (("m", 3e-5, 1e6, "\u00b5m"), ("Pa", 2e5, 1e-3, "kPa"), ("s", 3e-4, 1e6, "\u00b5s"), ("s", 2e5, 1 / 3600, "h"),
                                            ("1", 3e-5, 1., "1"), ("m", 0., 1., "m"), ("J/m", 1000., 1e-3, "kJ/m"), ("m^3", 1e-12, 1e18, "µm³"),
                                            ("m^2", 2e-4, 1e6, "mm²"), ("1/(100 um^2)", 0.5, 1., "1/(100 µm²)")):
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

    def plot_with(self, own):
        """Code, message and pictures of `plot DIR --data` with a file of this text, over a run with one table."""
        self.write("input.prm", "set Scenario = none\n")
        self.write("growth.csv", "time [s],radius [m],strain [1],cells\n0,1,0,1\n1,2,0.1,1\n2,4,0.3,2\n")
        run = [sys.executable, os.path.join(PLOTS, "plot.py"), self.directory, "--data", self.write("own.txt", own)]
        done = subprocess.run(run, capture_output=True, text=True)
        return done.returncode, done.stderr, [os.path.basename(line) for line in done.stdout.split()]

    def test_own_points_are_drawn_in_any_unit_of_the_quantity(self):
        for own, pictures in (("time [s],radius [m]\n0.5,1.5\n", ["growth.png"]), ("time [min],radius [um]\n0.01,1.5e6\n", ["growth.png"]),
                              ("strain [%],radius[mm]\n5,1500\n", ["growth.png", "growth_over_strain.png"])):
            with self.subTest(own=own):
                self.assertEqual(self.plot_with(own), (0, "", pictures))

    def test_own_points_come_out_where_they_belong(self):
        figure, axis = plt.subplots()
        own_data.DATA[:] = [("own.csv", {"time [h]": drawing.np.array([2.]), "radius [um]": drawing.np.array([30.])})]
        self.addCleanup(own_data.DATA.clear)
        own_data.draw_data(axis, "time [s]", "radius [m]", 1 / 3600, 1e6)
        self.assertAlmostEqual(axis.lines[0].get_xdata()[0], 2., places=12)
        self.assertAlmostEqual(axis.lines[0].get_ydata()[0], 30., places=12)
        self.assertEqual(axis.lines[0].get_label(), "own.csv: radius")
        plt.close(figure)

    def test_own_points_that_are_drawn_nowhere_are_told_with_the_reason(self):
        for own, code, words in (("words\n", 1, "needs one header line"), ("foo,bar\n1,2\n", 1, "has a column of this name"),
                                 ("radius [mm]\n1\n", 1, "a second column is needed to draw it over, such as 'time [s]' of growth.csv"),
                                 ("time [s],radius\n1,2\n", 1, "'radius': it has no unit; it is 'radius [m]' in growth.csv"),
                                 ("time [s],radius [N]\n1,2\n", 1, "'radius [N]': its unit does not convert"),
                                 ("time [s],radius [m],radus [m]\n1,2,3\n", 0, "'radus [m]': no table of the run has a column of this name (did you mean 'radius'?)")):
            with self.subTest(own=own):
                found = self.plot_with(own)
                self.assertEqual(found[0], code, found)
                self.assertIn(words, found[1])

    def test_a_compression_is_an_axis_for_runs_and_for_own_points(self):
        np = drawing.np
        factor, origin, words = deformation.strain_axis("F_yy [1]", [np.array([1., 0.8])])
        self.assertEqual((round(factor * (0.8 - origin), 9), words), (20., "compression along y [%]"))
        self.assertEqual(deformation.strain_axis("F_xy [1]", [np.array([0., 0.3])]), (100., 0., "shear, x over y [%]"))
        self.assertIsNone(deformation.strain_axis("F_dot_yy [1/s]", [np.array([0., 1.])]))
        self.assertEqual([deformation.stress_words(c) for c in ("sigma_yy [Pa]", "P_xx [Pa]", "sigma [Pa]")],
                         ["Cauchy stress sigma_yy,\npositive in tension", "nominal stress (first Piola-Kirchhoff) P_xx,\npositive in tension", None])
        own = {"compression along y [%]": np.array([5.]), "compressive_stress_y [kPa]": np.array([30.]), "sigma_xx [Pa]": np.array([1.])}
        for column, value in (("F_yy [1]", 0.95), ("sigma_yy [Pa]", -3e4), ("sigma_xx [Pa]", 1.), ("F_xx [1]", None), ("P_yy [Pa]", None)):
            found = own_data.own_column(own, column)
            self.assertTrue(found is value is None or abs(found[0] - value) <= 1e-9 * abs(value), column)
        self.assertIn("(did you mean 'compression_along_y'?)", own_data.why_not("compression [%]", own, {"stress.csv": ["time [s]", "F_yy [1]"]}))

    def run_of_an_rve(self, name, factor):
        """A pressed piece of tissue whose stress is this many times the strain; sides free."""
        os.makedirs(os.path.join(self.directory, name))
        self.write(name + "/input.prm", "subsection Path\n  set Stress components = xx\nend\n")
        head = "time [s]," + ",".join(f"F_{c} [1]" for c in deformation.COMPONENTS) + "," + ",".join(f"sigma_{c} [Pa]" for c in deformation.COMPONENTS)
        self.write(name + "/stress.csv", head + "".join(f"\n{t},{1 + t / 10},0,0,{1 - t / 5},0,0,0,{-factor * t}" for t in (0, 0.5, 1)) + "\n")

    def test_a_study_of_rves_draws_stress_over_strain_and_the_band_of_its_seeds(self):
        np = drawing.np
        entries, runs = ["Structure/Structure", "Structure/Structure seed"], []
        for k, (layout, seed, factor) in enumerate((("brick", "1", 1.), ("brick", "2", 3.), ("brick", "3", 2.), ("square", "1", 5.))):
            self.run_of_an_rve(f"d{k}", factor)
            runs.append({"run": f"r{k}", "method": "r", "settings": "", "status": "finished", "directory": f"d{k}", entries[0]: layout, entries[1]: seed})
        one = {"table": "stress", "against": "F_yy", "reference": "", "reference_table": ""}
        drawn = study_curves.curves_of(one, "sigma_yy", runs, self.directory, entries)
        self.assertEqual([label for label, _, _, _ in drawn], ["r  Structure brick: mean of 3 seeds", "r  Structure square"])
        (_, x, _, mean), half = drawn[0][1], drawn[0][3]
        self.assertTrue(np.allclose(x, [0.8, 0.9, 1.]) and np.allclose(mean, [-2., -1., 0.]))
        self.assertTrue(np.allclose(half, 4.303 / np.sqrt(3) * np.array([1., 0.5, 0.])))  # the standard deviation of 1, 2, 3 is 1
        self.assertIsNone(drawn[1][3])
        same = study_curves.curves_of(one, "sigma_yy", [dict(run, directory="d1") for run in runs[:3]], self.directory, entries)
        self.assertEqual([(label, half) for label, _, _, half in same], [("r  Structure brick: 3 seeds, all alike", None)])
        self.assertAlmostEqual(study_curves.confidence(11) / 2.228, 1., delta=0.02)
        self.assertAlmostEqual(study_curves.confidence(30) / 2.045, 1., delta=0.01)
        study_curves.plot_curves(runs, {"measures": [], "entries": entries}, self.directory)
        self.assertEqual([name for name in os.listdir(self.directory) if name.endswith(".png")], ["stress_strain.png"])

    def test_a_logarithmic_axis_has_three_labels_wherever_it_begins_and_ends(self):
        for low, high in ((0.03, 0.07), (0.9, 1.1), (4., 30.), (0.02, 0.5), (1e-9, 1e3), (1e-5, 1e6), (200., 210.), (3e-8, 4e-6)):
            with self.subTest(low=low, high=high):
                figure, axis = plt.subplots()
                axis.plot([1, 2], [low, high])
                axis.set_yscale("log")
                axis.set_ylim(low, high)
                drawing.style(axis)
                figure.canvas.draw()
                labels = [tick.label1.get_text() for tick in axis.yaxis.get_major_ticks() if low <= tick.get_loc() <= high]
                self.assertTrue(3 <= len(labels) <= 12, labels)
                self.assertEqual(len(set(labels)), len(labels))
                self.assertIn(sum("10^" in label for label in labels), (0, len(labels)))
                plt.close(figure)

    def test_a_legend_covers_no_data(self):
        np = drawing.np
        x = np.linspace(0., 1., 50)
        for curves in ([1 - x], [x], [1 - x, x, 0 * x, 0 * x + 1, 0 * x + 0.5, 0 * x + 0.8, 0 * x + 0.2]):  # the last leaves no place free
            for scale in ("linear", "log"):
                figure, axis = plt.subplots(layout="constrained")
                for k, y in enumerate(curves):
                    axis.plot(x, 0.1 + y, "o-", label=f"curve {k}")
                axis.set_yscale(scale)
                axis.legend(loc="upper left")
                figure.savefig(os.path.join(self.directory, "legend.png"))
                box = axis.get_legend().get_window_extent(figure.canvas.get_renderer())
                at = legible.points_in_view(axis)
                self.assertFalse(np.any((at[:, 0] > box.x0) & (at[:, 0] < box.x1) & (at[:, 1] > box.y0) & (at[:, 1] < box.y1)), (len(curves), scale))
                plt.close(figure)

    def test_rounding_is_no_panel(self):
        np = drawing.np
        table = {"time [s]": np.arange(3.), "a [Pa]": np.array([0., 1e5, 2e5]), "b [Pa]": np.array([0., 1e-6, -2e-6]), "u [m]": np.array([0., 1., 2.]),
                 "v [m]": np.array([0., 1e-15, 0.]), "gap [1]": np.array([1e-12, 3e-12, 2e-12]), "n": np.array([1., 2., 3.])}
        panels, remarks = plot.panels_of(table)
        self.assertEqual([list(columns) for _, columns in panels], [["a [Pa]"], ["u [m]"], ["n"]])
        self.assertEqual(remarks, ["zero but for rounding and what solvers leave: b, v, gap"])
        rows = [{"sigma [Pa]": "1e5", "free [Pa]": "1e-6"}, {"sigma [Pa]": "2e5", "free [Pa]": "-7e-7"}]
        self.assertEqual([name for name in rows[0] if study.varies(rows, name, rows[0])], ["sigma [Pa]"])

    def test_no_curve_of_a_study_hides_another(self):
        np, t = drawing.np, drawing.np.linspace(0., 1., 20)
        solid = dict(ls="-")
        drawn = [(name, ("t", x, "u", y), look, None) for name, x, y, look in
                 (("a", t, t, solid), ("b", t, t ** 3, solid), ("c", t[::2], t[::2] + 1e-3, solid), ("d", t[::-1], t[::-1], solid), ("points", t, t, dict(ls="")),
                  ("cells", t, t, dict(ls="-", zorder=0)))]
        dashes = study_curves.interleaved(drawn)
        self.assertEqual(dashes, {2: (12, (6, 12)), 3: (6, (6, 12))})  # a is whole below, c and d a third of it each, one after the other
        self.write("t.csv", "t [s],u [m]\n0,0\n1,1\n")
        runs = [{"run": name, "method": name, "settings": "", "status": "finished", "directory": "."} for name in ("cells", "FE2", "other tissue")]
        one = {"table": "t", "against": "", "columns": ["u"], "curve": True, "reference": "cells", "reference_table": ""}
        seen, draw = [], study_curves.draw_panels
        study_curves.draw_panels = lambda panels, count, path: seen.extend(label.strip() for label, *_ in panels[0])
        self.addCleanup(setattr, study_curves, "draw_panels", draw)
        study_curves.plot_curves(runs, {"measures": [one], "entries": [], "not_compared": ["other tissue"]}, self.directory)
        self.assertEqual(seen, ["FE2", "cells   (reference)"])

    def test_the_title_of_an_rve_says_cells_air_and_load(self):
        structure = "subsection Structure\n  set Structure = brick\n  set Gap = 2e-05\n  set Air = {}\nend\nsubsection RVE\n  set Columns = 2\n  set Rows = 3\nend\n"
        self.write("input.prm", structure.format("connected"))
        self.assertEqual(rve_response.what_is_loaded(self.directory, ["none"]), "brick cells, 2 x 3; air (gap 20 µm), which leaves freely; F given")
        self.write("input.prm", structure.format("isothermal"))
        self.write("summary.json", '{"results": {"air_share_at_rest": {"value": 0.0601, "unit": "1"}}}')
        self.assertEqual(rve_response.what_is_loaded(self.directory, ["xx"]),
                         "brick cells, 2 x 3; 6 % air at rest (gap 20 µm), shut in (isothermal), which stiffens; P_xx given, F else")

    def test_where_a_closed_form_does_not_apply_its_line_has_a_gap(self):
        table = plot.with_gaps({"time [s]": drawing.np.arange(3.), "closed_form_applies": drawing.np.array([1., 0., 1.]),
                                "closed_sigma_xx [Pa]": drawing.np.array([5., 0., 6.])})
        self.assertEqual([bool(gap) for gap in drawing.np.isnan(table["closed_sigma_xx [Pa]"])], [False, True, False])
        self.assertFalse(drawing.np.any(drawing.np.isnan(table["closed_form_applies"])))

    def test_a_panel_is_named_by_what_its_lines_have_in_common(self):
        for columns, name in ((["sigma_xx [Pa]", "sigma_xy [Pa]"], "sigma"), (["gyration_radius [m]", "radius [m]"], "radius"), (["radius [m]"], "radius"),
                              (["pressure [Pa]", "stress [Pa]"], "stress, pressure"), (["cells", "dead"], "counts, each of its own"), (["a [kg]", "b [kg]"], "value")):
            self.assertEqual(plot.quantity_of(columns), name)

    def test_a_panel_holds_no_more_lines_than_are_told_apart(self):
        columns = [f"{name}_{c} [Pa]" for name in ("sigma", "P") for c in ("xx", "xy", "yy")] + ["pressure [Pa]", "spread [Pa]", "closed_sigma_xx [Pa]"]
        self.assertEqual([len(one) for one in plot.few_at_a_time(columns)], [3, 3, 3])
        self.assertEqual(plot.few_at_a_time(columns[:4]), [columns[:4]])


if __name__ == "__main__":
    unittest.main()
