"""How a run ends that cannot go on: whatever cannot be opened, written or waited for, there is a sentence and a code, soon,
on one rank and on several; what stands on disk is as good as it can be."""
import csv
import json
import os
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

BUILD = os.environ["TURGOR_BUILD"]
PROGRAM = os.path.join(BUILD, "app", "turgor")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def scene(name, *values):
    return [os.path.join(SOURCE, "inputs", name + ".prm")] + [word for value in values for word in ("--set", value)]


# Short ones with series, fields and checkpoints, and long ones that somebody has to end.
FE2 = scene("tissue_gravity", "Time/End time=2e-6", "Time/Checkpoint interval=0")
SPHEROID = scene("spheroid_free", "End time=43200", "Frames=3", "Checkpoints=4", "Samples=20")
LONG_FE2 = scene("tissue_gravity", "Time/End time=1e-2")
LONG_CELL = scene("cell_endurance", "Steps=1e9", "Samples=1000000", "F_dot=0, 0; 0, 0", "Cell/Nodes per side=8", "SPH/Particles per side=8")


class Endings(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.directory = self.temporary.name
        self.out = os.path.join(self.directory, "out")

    def tearDown(self):
        self.temporary.cleanup()

    def run_program(self, *arguments, **more):
        return subprocess.run([PROGRAM, "run", *arguments, "-o", "out", "--quiet"], cwd=self.directory, capture_output=True,
                              text=True, timeout=120, stdin=subprocess.DEVNULL, **more)

    def start(self, *arguments, **more):
        return subprocess.Popen([PROGRAM, "run", *arguments, "-o", "out", "--quiet"], cwd=self.directory, stderr=subprocess.PIPE,
                                text=True, **more)

    def wait_for(self, child, *names):
        while child.poll() is None and not all(os.path.exists(os.path.join(self.out, name)) for name in names):
            time.sleep(0.01)
        self.assertIsNone(child.poll(), "it was done too early")

    def status(self):
        with open(os.path.join(self.out, "summary.json"), encoding="utf-8") as file:
            return json.load(file)["status"]

    def assert_refused(self, done, *words):
        """An end with a sentence: no signal, no library's own words, no success."""
        self.assertIn(done.returncode, (1, 2), done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        for word in ("terminate called", "what()", "filesystem error", "json.exception", "Aborted"):
            self.assertNotIn(word, done.stderr)

    def files_of(self, arguments):
        """Every file such a run writes, and the names it writes them under first."""
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        names = [os.path.relpath(os.path.join(place, name), self.out) for place, _, files in os.walk(self.out) for name in files]
        shutil.rmtree(self.out)
        self.assertIn("summary.json", names)
        whole = [name for name in names if not name.endswith((".csv", ".txt"))]
        return sorted(names) + [name + ".part" for name in whole]

    def every_file_is_in_the_way(self, arguments):
        for name in self.files_of(arguments):
            with self.subTest(name):
                os.makedirs(os.path.join(self.out, name, "something of the user's"))
                self.assert_refused(self.run_program(*arguments), os.path.basename(name).removesuffix(".part"))
                self.assertTrue(os.path.isdir(os.path.join(self.out, name, "something of the user's")))
                shutil.rmtree(self.out)

    def test_a_directory_in_the_place_of_every_file_of_a_tissue(self):
        self.every_file_is_in_the_way(FE2)

    def test_a_directory_in_the_place_of_every_file_of_a_spheroid(self):
        self.every_file_is_in_the_way(SPHEROID)

    def test_a_link_in_the_place_of_every_file(self):
        """It is somebody's: never followed, never replaced."""
        target = os.path.join(self.directory, "of somebody")
        for name in self.files_of(FE2):
            with self.subTest(name):
                link = os.path.join(self.out, name)
                os.makedirs(os.path.dirname(link))
                with open(target, "w", encoding="utf-8") as file:
                    file.write("mine")
                os.symlink(target, link)
                self.assert_refused(self.run_program(*FE2), os.path.basename(name).removesuffix(".part"))
                self.assertTrue(os.path.islink(link))
                with open(target, encoding="utf-8") as file:
                    self.assertEqual(file.read(), "mine")
                shutil.rmtree(self.out)

    def test_a_full_disk(self):
        """Of every size up to what the run needs, in a mount of its own."""
        def run_on(size):
            script = f"mount -t tmpfs -o size={size} none '{self.out}' && cd '{self.directory}' && exec \"$@\""
            return subprocess.run(["unshare", "--map-root-user", "--mount", "sh", "-c", script, "sh", PROGRAM, "run", *FE2, "-o", "out", "--quiet"],
                                  capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL)

        needed = len(self.files_of(FE2)) * 16384
        os.makedirs(self.out)
        roomy = run_on(64 * needed)
        if "unshare" in roomy.stderr or "mount" in roomy.stderr or roomy.returncode == 127:
            self.skipTest("no mount of one's own here: " + roomy.stderr)
        self.assertEqual(roomy.returncode, 0, roomy.stderr)
        ended = 0
        for size in range(4096, needed, needed // 12):
            with self.subTest(size=size):
                done = run_on(size)
                if done.returncode != 0:
                    self.assert_refused(done, "No space left on device")
                    ended += 1
        self.assertGreater(ended, 3)

    def stopped(self, arguments, after):
        child = self.start(*arguments)
        self.wait_for(child, *after)
        child.send_signal(signal.SIGTERM)
        said = child.communicate(timeout=60)[1]
        self.assertEqual(child.returncode, 130, said)
        return said

    def test_what_a_resumed_run_continues_is_gone_or_something_else(self):
        self.stopped(LONG_FE2, ["probe.csv", "tissue.xdmf"])
        kept = os.path.join(self.directory, "kept")
        os.rename(self.out, kept)
        names = [name for name in os.listdir(kept) if name.endswith((".csv", ".xdmf", ".frames"))]
        self.assertGreaterEqual(len(names), 5)
        for name in names:
            for instead in (None, "directory"):
                with self.subTest(name, instead=instead):
                    shutil.copytree(kept, self.out)
                    path = os.path.join(self.out, name)
                    shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)
                    if instead:
                        os.mkdir(path)
                    self.assert_refused(self.run_program(*LONG_FE2, "--resume"), name)
                    shutil.rmtree(self.out)

    def test_a_file_that_may_not_grow_ends_the_run_and_it_can_go_on(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit.bytes, limit.bytes))

        done = self.run_program(*SPHEROID)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.out, "growth.csv"), "rb") as file:
            whole = file.read()
        sizes = [os.path.getsize(os.path.join(place, name)) for place, _, files in os.walk(self.out) for name in files]
        shutil.rmtree(self.out)
        for share in (0.02, 0.3, 0.9):
            with self.subTest(share=share):
                limit.bytes = int(share * max(sizes))
                done = self.run_program(*SPHEROID, preexec_fn=limit)
                self.assert_refused(done, "cannot write")
                done = self.run_program(*SPHEROID, "--resume")
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(os.path.join(self.out, "growth.csv"), "rb") as file:
                    self.assertEqual(file.read(), whole)
                shutil.rmtree(self.out)

    def test_where_only_the_disk_has_failed_no_state_is_said_to_have(self):
        for size in (16384, 65536):
            with self.subTest(size=size):
                done = self.run_program(*FE2, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
                self.assert_refused(done, "cannot write")
                self.assertNotIn("the one that failed", done.stderr)
                self.assertEqual([name for name in os.listdir(self.out) if "at_failure" in name], [])
                shutil.rmtree(self.out)

    def test_all_ranks_end_when_one_cannot_go_on(self):
        def taken(name):
            os.makedirs(os.path.join(self.out, name, "something"))

        def a_file():
            with open(self.out, "w", encoding="utf-8") as file:
                file.write("mine")

        for what, before, words in (("the output is a file", a_file, "out is a file"),
                                    ("a table cannot be opened", lambda: taken("energies.csv"), "energies.csv"),
                                    ("a frame cannot be written", lambda: taken("tissue.frames/000000.h5"), "000000.h5"),
                                    ("no checkpoint can be written", lambda: taken("checkpoint.1"), "checkpoint.1"),
                                    ("the summary cannot be written", lambda: taken("summary.json"), "summary.json")):
            with self.subTest(what):
                before()
                begin = time.time()
                done = self.run_program(*FE2, "--ranks", "2", "--threads", "1")
                self.assertLess(time.time() - begin, 60)
                self.assert_refused(done, words)
                self.assertEqual(done.stderr.count("turgor: "), 1, done.stderr)
                shutil.rmtree(self.out) if os.path.isdir(self.out) else os.remove(self.out)

    def test_messages_never_land_in_a_table(self):
        def close():
            for number in (0, 1, 2):
                os.close(number)

        child = subprocess.run([PROGRAM, "run", *FE2, "-o", "out"], cwd=self.directory, preexec_fn=close, timeout=120, check=False)
        self.assertEqual(child.returncode, 0)
        tables = [name for name in os.listdir(self.out) if name.endswith(".csv")]
        for name in tables:
            with open(os.path.join(self.out, name), newline="", encoding="utf-8") as file:
                rows = list(csv.reader(file))
            for row in rows[1:]:
                self.assertEqual(len([float(x) for x in row]), len(rows[0]), name)
        self.assertGreaterEqual(len(tables), 4)

    def test_all_wishes_to_stop_are_alike(self):
        for wish in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU):
            with self.subTest(wish.name):
                child = self.start(*LONG_FE2)
                self.wait_for(child, "probe.csv", "tissue.xdmf")  # the table is there before the first state
                child.send_signal(wish)
                said = child.communicate(timeout=60)[1]
                self.assertEqual(child.returncode, 130, said)
                self.assertIn("continue with --resume", said)
                self.assertEqual(self.status(), "stopped")
                shutil.rmtree(self.out)

    def test_a_wish_to_stop_while_the_program_starts(self):
        for arguments in (LONG_FE2, LONG_FE2 + ["--ranks", "2"]):
            child = self.start(*arguments)
            while child.poll() is None:
                with open(f"/proc/{child.pid}/status", encoding="utf-8") as file:
                    if next(int(line.split()[1], 16) for line in file if line.startswith("SigCgt:")) >> (signal.SIGHUP - 1) & 1:
                        break
            child.send_signal(signal.SIGHUP)
            said = child.communicate(timeout=60)[1]
            self.assertEqual(child.returncode, 130, said)
            self.assertIn("topped", said)
            shutil.rmtree(self.out, ignore_errors=True)

    def test_cells_that_crawl_too_fast_end_the_run(self):
        for force in ("1e-5", "1"):
            for name in ("spheroid_free", "monolayer"):
                done = self.run_program(*scene(name, f"Motion/Migration force={force}", "First cells=4", "Frames=0"))
                self.assert_refused(done, "radii since pressures and growth of the cells were last looked at", "Motion/Migration force",
                                    "Motion/Growth tolerance")
                self.assertEqual(self.status(), "failed")
                shutil.rmtree(self.out)
        # the advice
        for advice in ("Motion/Migration force=1e-7", "Contact/Medium friction=5e12"):
            done = self.run_program(*scene("spheroid_free", "Motion/Migration force=1e-5", "First cells=4", "Frames=0", "End time=5000", advice))
            self.assertEqual(done.returncode, 0, done.stderr)
            shutil.rmtree(self.out)

    def test_a_run_with_no_end_in_sight_says_so(self):
        child = self.start(*scene("cell_endurance", "Steps=1e12", "Samples=100", "F_dot=0, 0; 0, 0", "Cell/Nodes per side=8",
                                  "SPH/Particles per side=8", "Checkpoints=0"))
        self.wait_for(child, "endurance.csv")
        time.sleep(25)
        child.send_signal(signal.SIGTERM)
        said = child.communicate(timeout=60)[1]
        self.assertEqual(child.returncode, 130, said)
        with open(os.path.join(self.out, "summary.json"), encoding="utf-8") as file:
            self.assertIn("no end is in sight", json.load(file)["notes"]["no_end_in_sight"])

    def test_nohup_goes_on_without_its_terminal(self):
        child = self.start(*LONG_CELL, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        self.wait_for(child, "endurance.csv")
        child.send_signal(signal.SIGHUP)
        time.sleep(0.3)
        self.assertIsNone(child.poll())
        child.send_signal(signal.SIGTERM)
        self.assertEqual(child.wait(timeout=60), 130, child.communicate()[1])
        child.stderr.close()

    def test_an_output_directory_that_is_taken_away(self):
        for how in (shutil.rmtree, lambda out: os.rename(out, out + "_elsewhere")):
            child = self.start(*LONG_FE2, "--set", "Time/Checkpoint interval=1")
            self.wait_for(child, "probe.csv", "tissue.xdmf")
            how(self.out)
            said = child.communicate(timeout=60)[1]
            self.assertEqual(child.returncode, 1, said)
            self.assertIn("was removed or renamed while the run was writing into it", said)
            self.assertFalse(os.path.exists(self.out))


if __name__ == "__main__":
    unittest.main()
