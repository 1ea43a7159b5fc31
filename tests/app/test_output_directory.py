"""Through the built program: nothing in an output directory is replaced that the program did not write, one run at a time."""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.path.join(os.environ["TURGOR_BUILD"], "app", "turgor")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
QUICK = os.path.join(SOURCE, "inputs", "wall_uniaxial.prm")
LONG = [os.path.join(SOURCE, "inputs", "cell_endurance.prm"), "--set", "Steps=100000000"]


def tree(directory):
    """{path: bytes, or where a link leads} of everything in it."""
    found = {}
    for folder, _, names in os.walk(directory):
        for name in names:
            path = os.path.join(folder, name)
            if os.path.islink(path):
                found[path] = os.readlink(path)
            else:
                with open(path, "rb") as file:
                    found[path] = file.read()
    return found


class Case(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.directory = self.temporary.name

    def path(self, *names):
        return os.path.join(self.directory, *names)

    def write(self, text, *names):
        os.makedirs(os.path.dirname(self.path(*names)), exist_ok=True)
        with open(self.path(*names), "w", encoding="utf-8") as file:
            file.write(text)

    def turgor(self, *arguments, environment=None, launcher=()):
        return subprocess.run([*launcher, PROGRAM, *arguments], cwd=self.directory, capture_output=True, text=True, timeout=300,
                              stdin=subprocess.DEVNULL, env={**os.environ, **(environment or {})})

    def refused(self, *arguments, says, **options):
        """Exit code 2, the sentence once, nothing written."""
        before = tree(self.directory)
        done = self.turgor(*arguments, **options)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stderr.count(says), 1, done.stderr)
        self.assertEqual(tree(self.directory), before)
        return done

    def accepted(self, *arguments, **options):
        done = self.turgor(*arguments, **options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def quick(self, *arguments):
        return ["run", QUICK, "--quiet", "-o", "out", *arguments]

    def summary(self, *names):
        with open(self.path(*names, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def started(self, *arguments):
        """A long run that has its directory."""
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.directory, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   stdin=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, condition):
        end = time.time() + 120
        while not condition() and time.time() < end:
            time.sleep(0.05)
        self.assertTrue(condition())


class OutputDirectory(Case):
    def test_two_runs_at_once(self):
        first = self.started("run", *LONG, "-o", "out", "--quiet")
        self.wait_for(lambda: os.path.exists(self.path("out", "input.prm")))
        second = self.turgor(*self.quick())
        self.assertEqual(second.returncode, 2)
        self.assertIn(f"in use by process {first.pid} on ", second.stderr)
        with open(self.path("out", "input.prm"), encoding="utf-8") as file:
            self.assertIn("cell_endurance", file.read())
        first.send_signal(signal.SIGKILL)  # the lock dies with its process, whatever it leaves
        first.wait()
        self.assertTrue(os.path.exists(self.path("out", ".turgor.lock")))
        self.accepted(*self.quick())
        self.assertFalse(os.path.exists(self.path("out", ".turgor.lock")))

    def test_two_studies_at_once(self):
        self.write(f"subsection Run x\nset Input = {LONG[0]}\nset Overrides = {LONG[2]}\nset Axes = Samples = 10 | 20\nend\n", "study.prm")
        first = self.started("study", "study.prm", "-o", "out")
        self.wait_for(lambda: os.path.exists(self.path("out", ".turgor.lock")))
        second = self.turgor("study", "study.prm", "-o", "out")
        self.assertEqual(second.returncode, 2)
        self.assertIn(f"in use by process {first.pid} on ", second.stderr)
        first.send_signal(signal.SIGTERM)
        self.assertEqual(first.wait(120), 130)

    def test_a_stopped_run_is_not_replaced_by_one_that_forgot_to_resume(self):
        first = self.started("run", *LONG, "-o", "out", "--quiet")
        self.wait_for(lambda: os.path.exists(self.path("out", "endurance.csv")))
        first.send_signal(signal.SIGTERM)
        self.assertEqual(first.wait(120), 130)
        self.refused("run", *LONG, "-o", "out", "--quiet", says="can go on: add --resume")
        self.refused(*self.quick(), says="can go on: add --resume")
        self.accepted(*self.quick(), "--overwrite")

    def test_the_input_is_not_replaced_by_its_copy(self):
        self.accepted(*self.quick())
        with open(QUICK, encoding="utf-8") as file:
            text = file.read()
        self.write(text, "input.prm")
        self.refused("run", "input.prm", "-o", ".", says="would be replaced")
        self.refused("run", "out/input.prm", "-o", "out", says="would be replaced")
        self.refused("run", QUICK, "-o", ".", says="input.prm was not written by this program")

    def test_files_of_a_person_stay(self):
        for name in ("summary.json", "wall.csv", "checkpoint.0"):
            with self.subTest(name):
                self.write("mine", name.split(".")[0], name)
                self.refused("run", QUICK, "-o", name.split(".")[0], says="was not written by this program")

    def test_links_are_not_followed(self):
        self.write("mine", "elsewhere")
        for name in ("summary.json", "wall.csv", "made_by_turgor.txt", "input.prm"):
            with self.subTest(name):
                os.makedirs(self.path("in " + name))
                os.symlink(self.path("elsewhere"), self.path("in " + name, name))
                self.refused("run", QUICK, "-o", "in " + name, says="is a symbolic link")
        self.accepted(*self.quick())  # a directory may be one
        os.symlink(self.path("out"), self.path("link"))
        self.accepted("run", QUICK, "--quiet", "-o", "link")

    def test_a_picture_of_a_person_stays(self):
        self.accepted(*self.quick())
        self.write("mine", "out", "wall_uniaxial.png")
        done = self.turgor("plot", "out")
        self.assertIn("was not drawn by turgor", done.stderr)
        with open(self.path("out", "wall_uniaxial.png"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "mine")

    def test_a_finished_run_of_another_input(self):
        self.accepted(*self.quick())
        other = self.quick("--set", "Largest stretch=1.2")
        self.refused(*other, says="holds a finished run of another input")
        self.refused(*other, "--resume", says="holds a finished run of another input")
        before = self.summary("out")["input_hash"]
        self.accepted(*self.quick())  # the same again may replace itself
        self.assertEqual(self.summary("out")["input_hash"], before)
        self.accepted(*other, "--overwrite")
        self.assertNotEqual(self.summary("out")["input_hash"], before)
        self.assertFalse(os.path.exists(self.path("out", "turgor_earlier_run")))

    def test_a_run_without_checkpoint_is_not_replaced_by_a_resume_of_another(self):
        self.accepted(*self.quick())
        other = self.quick("--set", "Largest stretch=1.2", "--resume")
        summary = self.summary("out")
        self.write(json.dumps({**summary, "status": "stopped"}), "out", "summary.json")
        self.refused(*other, says="holds a run of another input")
        os.remove(self.path("out", "summary.json"))  # killed
        self.refused(*other, says="holds a run of another input")
        self.accepted(*self.quick("--resume"))
        self.write(json.dumps({**summary, "status": "failed"}), "out", "summary.json")
        self.accepted(*other, "--overwrite")
        self.assertNotEqual(self.summary("out")["input_hash"], summary["input_hash"])

    def test_resume_of_a_finished_run_leaves_it(self):
        self.accepted(*self.quick())
        before = tree(self.directory)
        self.accepted(*self.quick("--resume"))
        self.assertEqual(tree(self.directory), before)

    def test_resume_of_a_run_that_was_killed_while_it_drew_draws(self):
        run = subprocess.Popen([PROGRAM, "run", QUICK, "-o", "out"], cwd=self.directory, stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
        while not os.path.exists(self.path("out", "summary.json")):
            self.assertIsNone(run.poll())
        run.kill()
        run.wait()
        with open(self.path("out", "made_by_turgor.txt"), "a", encoding="utf-8") as file:
            file.write("wall_uniaxial.png.part\n")
        self.write("half a picture", "out", "wall_uniaxial.png.part")
        self.assertFalse(os.path.exists(self.path("out", "wall_uniaxial.png")))
        done = self.accepted("run", QUICK, "-o", "out", "--resume")
        self.assertIn("has finished already: its pictures are drawn.", done.stdout)
        with open(self.path("out", "wall_uniaxial.png"), "rb") as file:
            self.assertEqual(file.read(4), b"\x89PNG")
        before = tree(self.directory)
        done = self.accepted("run", QUICK, "-o", "out", "--resume")
        self.assertIn("has finished already: nothing is left to do.", done.stdout)
        self.assertEqual(tree(self.directory), before)

    def test_where_there_is_nothing_to_draw_no_advice_is_given_to_draw(self):
        one_point = ["run", os.path.join(SOURCE, "inputs", "rve_response.prm"), "--set", "Path/F=1, 0.05; 0, 1", "--set", "Path/Tangents=false", "-o",
                     "out"]
        for again in ([], ["--resume"]):
            done = self.accepted(*one_point, *again)
            for word in ("plot", "drawn"):
                self.assertNotIn(word, done.stdout + done.stderr)
        done = self.turgor("plot", "out")
        self.assertEqual(done.returncode, 1)
        self.assertIn("There is nothing to plot in out", done.stderr)

    def test_a_wish_to_stop_while_pictures_are_drawn(self):
        run = subprocess.Popen([PROGRAM, "run", QUICK, "-o", "out"], cwd=self.directory, stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True)
        while not os.path.exists(self.path("out", "summary.json")):
            self.assertIsNone(run.poll())
        with open(self.path("out", "made_by_turgor.txt"), "a", encoding="utf-8") as file:
            file.write("wall_uniaxial.png.part\n")
        self.write("half a picture", "out", "wall_uniaxial.png.part")
        run.send_signal(signal.SIGINT)
        said = run.communicate(timeout=60)[0]
        self.assertEqual(run.returncode, 0, said)
        self.assertIn("Stopped before the pictures were drawn; to draw them: turgor plot out", said)
        self.assertEqual([name for name in os.listdir(self.path("out")) if ".png" in name], [])
        self.assertEqual(self.turgor("plot", "out").returncode, 0)


class Account(Case):
    def test_time_and_memory_before_exec_do_not_count(self):
        """The launcher compiles for minutes, then becomes the program: none of that is the run's."""
        burn = ("import os, subprocess, sys, time\n"
                "burner = 'import time\\nx = b\"1\" * 600000000\\nwhile time.process_time() < 1: pass'\n"
                "subprocess.run([sys.executable, '-c', burner])\n"
                "exec(burner.replace('< 1', '< 1.5'))\n"
                "os.execv(sys.argv[1], sys.argv[1:])\n")
        done = self.turgor(*self.quick("--threads", "1"), launcher=(sys.executable, "-c", burn))
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = self.summary("out")
        self.assertLess(summary["cpu_time_s"], 1.)
        self.assertLess(summary["cpu_time_s"], summary["wall_time_s"] + 0.05)  # one thread: both clocks over the same span
        self.assertLess(summary["peak_memory_bytes"], 4e8)


class Launchers(Case):
    SRUN = {"SLURM_JOB_ID": "7", "SLURM_NTASKS": "2", "SLURM_STEP_ID": "0", "SLURM_STEP_NUM_TASKS": "2"}
    FE2 = ["run", os.path.join(SOURCE, "inputs", "tissue_gravity.prm"), "--set", "Time/End time=1e-6", "--quiet"]

    def mpirun(self, *options):
        return ["mpirun", *(["--allow-run-as-root"] if os.geteuid() == 0 else []), "--oversubscribe", *options]

    def test_a_scene_without_ranks_is_refused_once(self):
        self.refused(*self.quick(), says="does not share its work over ranks", launcher=self.mpirun("-n", "2"))
        self.refused("study", "study.prm", says="start it once", launcher=self.mpirun("-n", "2"))
        self.accepted(*self.quick(), launcher=self.mpirun("-n", "1"))

    def test_srun_and_other_launchers_are_refused_once(self):
        for rank, times in (("0", 1), ("1", 0)):
            for environment in ({**self.SRUN, "SLURM_PROCID": rank}, {"PMI_SIZE": "2", "PMI_RANK": rank}):
                for arguments in (self.FE2, self.quick(), ["validate"]):
                    done = self.turgor(*arguments, environment=environment)
                    self.assertEqual((done.returncode, done.stderr.count("turgor: ")), (2, times), done.stderr)
        self.assertEqual(os.listdir(self.directory), [])

    def test_a_batch_script_is_no_launcher(self):
        self.accepted(*self.quick(), environment={"SLURM_JOB_ID": "7", "SLURM_NTASKS": "2", "SLURM_PROCID": "0"})
        self.accepted(*self.quick(), environment={**self.SRUN, "SLURM_STEP_NUM_TASKS": "1", "SLURM_PROCID": "0"})

    def test_copies_that_mpirun_starts_are_the_ranks_of_one_run(self):
        self.refused(*self.FE2, "-o", "other", "--ranks", "3", says="--ranks 3 is another number", launcher=self.mpirun("-n", "2"))
        self.accepted(*self.FE2, "-o", "joined", "--threads", "1", launcher=self.mpirun("-n", "2"))
        self.accepted(*self.FE2, "-o", "serial", "--threads", "1")
        self.assertEqual(self.summary("joined")["ranks"], 2)
        with open(self.path("joined", "probe.csv"), "rb") as one, open(self.path("serial", "probe.csv"), "rb") as other:
            self.assertEqual(one.read(), other.read())


if __name__ == "__main__":
    unittest.main()
