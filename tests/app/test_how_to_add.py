"""The diffs of doc/how_to_add.md apply to today's sources, all together as well as one by one, and what they add is as clang-format leaves it."""
import os
import re
import subprocess
import tempfile
import unittest

from test_format import SOURCE, formatter


def diffs():
    with open(os.path.join(SOURCE, "doc", "how_to_add.md"), encoding="utf-8") as file:
        return re.findall(r"^```diff\n(.*?)^```", file.read(), re.S | re.M)


def names(diff):
    return re.findall(r"^\+\+\+ b/(\S+)", diff, re.M)


class HowToAdd(unittest.TestCase):
    def test_diffs_apply_and_are_formatted(self):
        blocks = diffs()
        self.assertGreater(len(blocks), 0)
        with tempfile.TemporaryDirectory() as place:
            for block in blocks:
                for name in names(block):
                    there = os.path.join(SOURCE, name)
                    if os.path.exists(there):
                        os.makedirs(os.path.dirname(os.path.join(place, name)), exist_ok=True)
                        with open(there, encoding="utf-8") as file, open(os.path.join(place, name), "w", encoding="utf-8") as copy:
                            copy.write(file.read())
            # a place of its own, so that git neither looks for a repository nor writes into one
            environment = {**os.environ, "GIT_CEILING_DIRECTORIES": os.path.dirname(os.path.realpath(place))}
            for block in blocks:
                done = subprocess.run(["git", "apply", "-"], cwd=place, input=block, text=True, capture_output=True, env=environment)
                self.assertEqual(done.returncode, 0, f"{names(block)}: {done.stderr}")
                self.assertEqual(len(names(block)), 1, block)
            command = formatter()
            if command is None:
                self.skipTest("clang-format 14 is not installed; the diffs apply")
            for name in [name for block in blocks for name in names(block) if name.endswith((".h", ".cc"))]:
                path = os.path.join(place, name)
                said = subprocess.run([command, f"--style=file:{SOURCE}/.clang-format", path], capture_output=True, text=True).stdout
                with open(path, encoding="utf-8") as file:
                    self.assertEqual(file.read(), said, name)


if __name__ == "__main__":
    unittest.main()
