"""What a stopped run, study or validation says to type is the whole command that goes on, quoted for a shell."""
import json
import os
import shlex
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.path.join(os.environ["TURGOR_BUILD"], "app", "turgor")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STEPS = "Steps=100000000"


class CommandAgain(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = temporary.name
        shutil.copy(os.path.join(SOURCE, "inputs", "cell_endurance.prm"), os.path.join(self.directory, "it's mine.prm"))

    def write(self, name, text):
        os.makedirs(os.path.dirname(os.path.join(self.directory, name)), exist_ok=True)
        with open(os.path.join(self.directory, name), "w", encoding="utf-8") as file:
            file.write(text)

    def tables(self):
        return [os.stat(os.path.join(place, name)).st_mtime_ns for place, _, names in os.walk(self.directory) for name in names if name == "endurance.csv"]

    def stopped(self, *words):
        """The words of the command that is told at Ctrl-C."""
        before = self.tables()
        child = subprocess.Popen([PROGRAM, *words], cwd=self.directory, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                 env={**os.environ, "TURGOR_CALLED_AS": "./turgor"})
        self.addCleanup(child.kill)
        end = time.time() + 60
        while self.tables() == before and time.time() < end:
            time.sleep(0.02)
        time.sleep(0.2)
        child.send_signal(signal.SIGINT)
        said = child.communicate(timeout=60)[1]
        self.assertEqual(child.returncode, 130, said)
        commands = [line for line in said.splitlines() if line.startswith("  ./turgor ")]
        self.assertEqual(len(commands), 1, said)
        return shlex.split(commands[0])

    def test_of_a_run(self):
        words = ["run", "it's mine.prm", "-o", "my out", "--set", STEPS, "--set", "F_dot=0, 10; 0, 0", "--quiet"]
        told = self.stopped(*words, "--overwrite")
        self.assertEqual(told, ["./turgor", *words, "--resume"])
        self.assertEqual(self.stopped(*told[1:]), told)  # and it is taken: it goes on, and tells the same again

    def test_of_a_study(self):
        self.write("my study.prm", f"set Input = it's mine.prm\nset Overrides = {STEPS}\nsubsection Run a\nend\n")
        words = ["study", "my study.prm", "-o", "there"]
        self.assertEqual(self.stopped(*words, "--fresh"), ["./turgor", *words])  # --fresh would begin again

    def test_of_a_validation(self):
        run = {"input": os.path.join(self.directory, "it's mine.prm"), "overrides": [STEPS]}
        self.write("inputs/validation/one.json", json.dumps({"runs": {"": run}, "rows": [
            {"quantity": "steps", "source": "none", "result": "steps", "most": 1}]}))
        words = ["validate", "one", "--root", ".", "-o", "there"]
        self.assertEqual(self.stopped(*words), ["./turgor", *words])


if __name__ == "__main__":
    unittest.main()
