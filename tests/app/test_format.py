"""All C++ of the repository is as clang-format 14 leaves it (.clang-format), in lines of 110 columns but for what cannot be broken.
Another version formats otherwise: then nothing is checked. .ci/run installs the right one."""
import os
import re
import shutil
import subprocess
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDERS = ["app", "benchmarks", "coupling", "macro", "micro", "run", "rve", "tests"]
VERSION = 14


def formatter():
    """The command, or None."""
    for name in (f"clang-format-{VERSION}", "clang-format"):
        if shutil.which(name):
            said = subprocess.run([name, "--version"], capture_output=True, text=True).stdout
            if re.search(rf"version {VERSION}\.", said):
                return name
    return None


def sources():
    for folder in FOLDERS:
        for place, _, files in sorted(os.walk(os.path.join(SOURCE, folder))):
            yield from (os.path.join(place, name) for name in sorted(files) if name.endswith((".h", ".cc")))


class Format(unittest.TestCase):
    def test_all_files(self):
        command = formatter()
        if command is None:
            self.assertFalse(os.environ.get("CI"), f"clang-format {VERSION} is not installed.")
            self.skipTest(f"clang-format {VERSION} is not installed")
        wrong, files = set(), list(sources())
        for first in range(0, len(files), 100):
            said = subprocess.run([command, "--dry-run", "-Werror"] + files[first:first + 100], capture_output=True, text=True).stderr
            wrong |= set(re.findall(r"^([^\s:]+):\d+:\d+: error: code should be clang-formatted", said, re.M))
        self.assertEqual(sorted(os.path.relpath(path, SOURCE) for path in wrong), [], f"run {command} -i on these")


if __name__ == "__main__":
    unittest.main()
