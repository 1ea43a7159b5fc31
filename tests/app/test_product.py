"""Through the built program: same bits on threads and ranks, kill -9 and resume, plot, study."""
import csv
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

BUILD = os.environ["TURGOR_BUILD"]
PROGRAM = os.path.join(BUILD, "app", "turgor")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# A few steps each.
FE2 = [os.path.join(SOURCE, "inputs", "tissue_gravity.prm"), "--set", "Time/End time=3e-6"]
FULL = [os.path.join(SOURCE, "inputs", "full_micro.prm"), "--set", "Columns=2", "--set", "Rows=2", "--set", "End time=1e-6"]
# A sheared, viscous and disturbed cell: work, dissipation and every other sum of the run is at stake.
ENDURANCE = [os.path.join(SOURCE, "inputs", "cell_endurance.prm")] + [
    word for value in ("Steps=20000", "Samples=1000", "F_dot=0, 400; 0, 0", "Start speed=0.1", "Cell/Fluid viscosity=1",
                       "Cell/Nodes per side=8", "SPH/Particles per side=8") for word in ("--set", value)]


def content(*path):
    with open(os.path.join(*path), "rb") as file:
        return file.read()


def catches_interrupt(process):
    """Whether the program has put up its handler of Ctrl-C; before that the signal just kills."""
    with open(f"/proc/{process}/status", encoding="utf-8") as file:
        caught = next(int(line.split()[1], 16) for line in file if line.startswith("SigCgt:"))
    return bool(caught >> (signal.SIGINT - 1) & 1)


class Product(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.directory = self.temporary.name

    def tearDown(self):
        self.temporary.cleanup()

    def command(self, *arguments):
        return [PROGRAM] + list(arguments)

    def run_program(self, *arguments):
        done = subprocess.run(self.command(*arguments), cwd=self.directory, capture_output=True, text=True,
                              timeout=600, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def assert_same(self, one, other, tables=("probe.csv", "cell_displacement.csv")):
        for name in tables:
            self.assertEqual(content(self.directory, one, name), content(self.directory, other, name), name)

    def test_output_that_a_full_disk_does_not_take_is_no_success(self):
        for command in (["list"], ["parameters", "two_cells"], ["check", os.path.join(SOURCE, "inputs", "two_cells.prm")], ["--help"]):
            with open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run(self.command(*command), stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
            self.assertEqual(done.returncode, 1, command)
            self.assertEqual(done.stderr, "turgor: the output could not be written whole: is its disk full?\n")
        # A reader who has read enough is no mistake.
        done = subprocess.run(["bash", "-c", 'set -o pipefail; "$0" parameters spheroid_free | head -1 > /dev/null', PROGRAM],
                              capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_same_bits_on_threads_and_ranks(self):
        self.run_program("run", *FE2, "-o", "one", "--threads", "1")
        self.run_program("run", *FE2, "-o", "two", "--threads", "2")
        self.run_program("run", *FE2, "-o", "ranks", "--threads", "1", "--ranks", "2")
        self.assert_same("one", "two")
        self.assert_same("one", "ranks")

    def test_same_bits_of_the_full_run_on_threads(self):
        self.run_program("run", *FULL, "-o", "one", "--threads", "1")
        self.run_program("run", *FULL, "-o", "two", "--threads", "2")
        self.assert_same("one", "two")

    def test_an_unknown_instruction_set_is_wrong_input(self):
        done = subprocess.run(self.command("run", *FULL, "-o", "out"), cwd=self.directory, capture_output=True, text=True, timeout=600,
                              stdin=subprocess.DEVNULL, env=dict(os.environ, TURGOR_SIMD="sse9"))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("TURGOR_SIMD=sse9", done.stderr)
        self.assertIn("portable", done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.directory, "out", "summary.json")))

    def rows(self, directory, table):
        path = os.path.join(self.directory, directory, table)
        return content(path).count(b"\n") if os.path.exists(path) else 0

    def kill_and_resume(self, arguments, tables=("probe.csv", "cell_displacement.csv")):
        """Killed in two places between its beginning and its end, it goes on from a checkpoint to the same bits."""
        self.run_program("run", *arguments, "-o", "whole", "--quiet")
        for share in (0.2, 0.6):
            shutil.rmtree(os.path.join(self.directory, "cut"), ignore_errors=True)
            child = subprocess.Popen(self.command("run", *arguments, "-o", "cut", "--quiet"), cwd=self.directory)
            while child.poll() is None and self.rows("cut", tables[0]) < share * self.rows("whole", tables[0]):
                time.sleep(0.002)
            child.send_signal(signal.SIGKILL)
            self.assertEqual(child.wait(), -signal.SIGKILL, "it was done before it could be killed")
            self.assertLess(self.rows("cut", tables[0]), self.rows("whole", tables[0]))
            self.assertIn("Resumed from checkpoint", self.run_program("run", *arguments, "-o", "cut", "--resume"))
            self.assert_same("whole", "cut", tables)

    def test_killed_fe2_resumes_to_the_same_bits(self):
        self.kill_and_resume(FE2[:1] + ["--set", "Time/End time=2e-5", "--set", "Time/Checkpoint interval=0"])

    def test_killed_full_run_resumes_to_the_same_bits(self):
        self.kill_and_resume(FULL[:-1] + ["End time=3e-6"])

    def test_killed_spheroid_beside_a_body_resumes_to_the_same_bits(self):
        self.kill_and_resume([os.path.join(SOURCE, "tests", "golden", "spheroid_body.prm"), "--set", "Frames=0", "--set", "Checkpoints=500",
                              "--set", "Samples=500"], ("growth.csv",))

    def test_killed_endurance_run_resumes_to_the_same_bits(self):
        self.kill_and_resume(ENDURANCE, ("endurance.csv",))
        # The sums over the whole run too: they are what only the checkpoint carries.
        results = []
        for directory in ("whole", "cut"):
            with open(os.path.join(self.directory, directory, "summary.json"), encoding="utf-8") as file:
                results.append(json.load(file)["results"])
        self.assertEqual(*results)

    def stop(self, *arguments, after=".turgor.lock"):
        """Ctrl-C while the scene works, once it has written the file `after`: what it said, if it ended as it should."""
        shutil.rmtree(os.path.join(self.directory, "out"), ignore_errors=True)
        child = subprocess.Popen(self.command("run", *arguments, "-o", "out", "--quiet"), cwd=self.directory,
                                 stderr=subprocess.PIPE, text=True)
        while child.poll() is None and not (catches_interrupt(child.pid) and
                                            os.path.exists(os.path.join(self.directory, "out", after))):
            time.sleep(0.005)
        time.sleep(0.3)
        self.assertIsNone(child.poll(), "it was done before it could be stopped")
        child.send_signal(signal.SIGINT)
        said = child.communicate(timeout=60)[1]
        self.assertEqual(child.returncode, 130, said)
        with open(os.path.join(self.directory, "out", "summary.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["status"], "stopped")
        return said

    def test_stop_while_annealing(self):
        said = self.stop(*FULL, "--set", "SPH/Anneal steps=10000000")
        self.assertIn("stopped while the reference cell was annealed", said)
        self.assertIn("Stopped before there was a checkpoint; run it again.", said)

    def test_stop_in_the_full_run(self):
        said = self.stop(*FULL, "--set", "SPH/Particles per side=9", "--set", "Cell/Nodes per side=10", "--set",
                         "End time=1e-2", after="probe.csv")
        self.assertIn("continue with --resume", said)

    def test_stop_on_two_ranks(self):
        said = self.stop(FE2[0], "--set", "Time/End time=1e-2", "--ranks", "2", "--threads", "1", after="probe.csv")
        self.assertIn("continue with --resume", said)

    def test_a_cell_deformed_beyond_its_first_step_takes_shorter_ones(self):
        # Sheared to three times its width; beyond four and a half its few particles leave through the corners, and a run of them fails.
        done = subprocess.run(self.command("run", *ENDURANCE, "--set", "F_dot=0, 20000; 0, 0", "--set", "Steps=2e4", "-o", "out",
                                           "--quiet"), cwd=self.directory, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.directory, "out", "summary.json"), encoding="utf-8") as file:
            self.assertLess(json.load(file)["results"]["energy_gained_over_start_energy"]["value"], 1e-3)
        self.assertNotRegex(content(self.directory, "out", "endurance.csv").decode(), "nan|inf")

    def test_stop_of_the_static_scenes(self):
        self.assertIn("stopped before the full load was carried",
                      self.stop(os.path.join(SOURCE, "inputs", "static_lattice.prm"), "--set", "Columns=40", "--set", "Rows=40"))
        self.assertIn("stopped before the full load was carried",
                      self.stop(os.path.join(SOURCE, "inputs", "tissue_statics.prm"), "--set", "Tissue statics/Elements=24"))

    def test_particles_start_without_finite_elements(self):
        needed = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, timeout=60).stdout
        self.assertIn("libtbb", needed)
        self.assertNotRegex(needed, "deal.ii|trilinos|sundials")

    def test_ranks_are_refused_by_a_scene_without_them(self):
        done = subprocess.run(self.command("run", *FULL, "-o", "out", "--ranks", "2"), cwd=self.directory,
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn("does not share its work over ranks", done.stderr)
        self.assertEqual(os.listdir(self.directory), [])

    def test_checkpoint_of_another_input_is_refused(self):
        self.run_program("run", *FULL, "-o", "out")
        done = subprocess.run(self.command("run", *FULL, "--set", "Load=1e3", "-o", "out", "--resume"), cwd=self.directory,
                              capture_output=True, text=True, timeout=60)
        if not any(name.startswith("checkpoint") for name in os.listdir(os.path.join(self.directory, "out"))):
            self.skipTest("the run was too short for a checkpoint")
        self.assertEqual(done.returncode, 2)
        self.assertIn("belongs to another input", done.stderr)

    def test_study_and_plot(self):
        with open(os.path.join(self.directory, "s.prm"), "w", encoding="utf-8") as file:
            file.write(f"set Reference = a\nset Input = {FULL[0]}\nset Overrides = Columns=1; Rows=1; End time=1e-7\n"
                       "subsection Measure history\nset Table = probe\nset Columns = displacement_x, displacement_y\nend\n"
                       "subsection Measure field\nset Table = cell_displacement\nset Columns = displacement_y\nset Match = cell_x, cell_y\nend\n"
                       "subsection Run a\nend\nsubsection Run b\nset Overrides = Load=0\nend\n"
                       "subsection Run step\nset Grid = Step fraction = 0.3 | 0.5\nend\n")
        self.run_program("study", "s.prm")
        with open(os.path.join(self.directory, "runs", "s", "error_vs_time.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(set(rows[0]), {"run", "method", "Step fraction", "history_rms [m]", "error_history", "field_rms [m]", "error_field",
                                        "cpu_time_s", "wall_time_s", "peak_memory_bytes"})
        self.assertEqual([row["run"] for row in rows], ["a", "b", "step 0.3", "step 0.5"])
        self.assertEqual([row["Step fraction"] for row in rows], ["0.9", "0.9", "0.3", "0.5"])  # the first two have it as it is in their input
        self.assertEqual(float(rows[0]["error_history"]), 0)
        self.assertGreater(float(rows[1]["error_field"]), 0.5)  # without load there is next to no displacement
        for name in ("error_vs_time.png", "sweep.png", "curves.png"):
            self.assertTrue(content(self.directory, "runs", "s", name).startswith(b"\x89PNG"))
        self.assertNotIn("Running", self.run_program("study", "s.prm"))  # all cached
        with open(os.path.join(self.directory, "runs", "s", "results.csv"), newline="", encoding="utf-8") as file:
            place = os.path.join("runs", "s", list(csv.DictReader(file))[0]["directory"])
        self.run_program("plot", place)
        self.assertTrue(content(self.directory, place, "probe.png").startswith(b"\x89PNG"))
        self.assertIn(b"probe.png", content(self.directory, place, "made_by_turgor.txt"))  # the next run removes it
        with open(os.path.join(self.directory, place, "summary.json"), encoding="utf-8") as file:
            self.assertLessEqual({"scenario", "version", "status", "wall_time_s", "cpu_time_s", "peak_memory_bytes",
                                  "active_terms", "fields", "results"}, set(json.load(file)))


if __name__ == "__main__":
    unittest.main()
