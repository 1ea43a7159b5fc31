"""The launcher on a tree of its own whose program is a script: CMake and ninja are real, apt and dpkg are not."""
import os
import shutil
import stat
import subprocess
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
NOBODY = 65534
TREE = """cmake_minimum_required(VERSION 3.25)
project(turgor NONE)
file(GLOB words CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/*.txt.in)
add_custom_command(OUTPUT made BYPRODUCTS app/turgor DEPENDS ${words} ${CMAKE_SOURCE_DIR}/program
  COMMAND sleep 0.2 && mkdir -p app && cat ${CMAKE_SOURCE_DIR}/program ${words} > app/turgor && chmod +x app/turgor && echo x >> built && touch made)
add_custom_target(turgor DEPENDS made)
"""
INSTALLED = 'for package in "$@"; do [[ "$package" == -* || "$package" == *Status* ]] || echo "installed $package"; done'


class Help(unittest.TestCase):
    def test_options_of_the_tests_are_told_before_anything_is_built(self):
        with tempfile.TemporaryDirectory() as directory:
            build = os.path.join(directory, "build")
            told = subprocess.run([os.path.join(SOURCE, "turgor"), "test", "--fast", "--help"], capture_output=True, text=True,
                                  env={**os.environ, "TURGOR_BUILD": build})
            self.assertEqual(told.returncode, 0, told.stderr)
            self.assertIn("--fast", told.stdout)
            self.assertFalse(os.path.exists(build))


class Launcher(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = temporary.name
        os.chmod(self.directory, 0o755)
        self.fakes = os.path.join(self.directory, "fakes")
        os.mkdir(self.fakes)
        self.fake("dpkg-query", INSTALLED)
        self.fake("apt-get", "echo unexpected; exit 9")
        self.tree = os.path.join(self.directory, "tree")
        os.mkdir(self.tree)
        shutil.copy(os.path.join(SOURCE, "turgor"), self.tree)
        self.write("CMakeLists.txt", TREE)
        self.write("program", '#!/bin/sh\necho "program of $(dirname "$0") $*"\n')

    def write(self, name, text):
        with open(os.path.join(self.tree, name), "w", encoding="utf-8") as file:
            file.write(text)

    def fake(self, name, script):
        path = os.path.join(self.fakes, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/bash\n" + script + "\n")
        os.chmod(path, 0o755)

    def start(self, *arguments, tree=None, build=None, user=None):
        environment = {key: value for key, value in os.environ.items() if not key.startswith("TURGOR_")}
        environment["PATH"] = self.fakes + ":" + environment["PATH"]
        if build:
            environment["TURGOR_BUILD"] = build
        return subprocess.Popen([os.path.join(tree or self.tree, "turgor"), *arguments], env=environment, cwd=self.directory,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, user=user)

    def call(self, *arguments, code=0, **options):
        process = self.start(*arguments, **options)
        out, messages = process.communicate(timeout=60)
        self.assertEqual(process.returncode, code, out + messages)
        return out, messages

    def built(self, tree=None):
        with open(os.path.join(tree or self.tree, "build", "built"), encoding="utf-8") as file:
            return len(file.read().split())

    def picture(self):
        """Times of all files and folders of the tree: any write shows."""
        return {path: os.lstat(path).st_ctime_ns for folder, _, files in os.walk(self.tree)
                for path in [folder] + [os.path.join(folder, name) for name in files]}

    def test_the_first_call_says_what_it_costs_and_the_next_nothing(self):
        out, messages = self.call("list")
        self.assertEqual(out, f"program of {self.tree}/build/app list\n")
        self.assertIn("turgor: first call: the program is built in", messages)
        before = self.picture()
        self.assertEqual(self.call("list"), (out, ""))
        self.assertEqual(self.picture(), before)

    def test_a_changed_and_an_added_source_are_built(self):
        self.call("list")
        self.write("more.txt.in", "echo added\n")
        self.assertIn("added", self.call("list")[0])
        self.write("more.txt.in", "echo changed\n")
        self.assertIn("changed", self.call("list")[0])
        self.write("CMakeLists.txt", TREE.replace("sleep 0.2", "sleep 0.1"))
        self.call("list")
        self.assertEqual(self.built(), 4)
        self.assertEqual(self.call("list")[1], "")

    def test_a_copied_clone_runs_its_own_program(self):
        self.call("list")
        copy = os.path.join(self.directory, "copy")
        shutil.copytree(self.tree, copy)
        with open(os.path.join(copy, "program"), "a", encoding="utf-8") as file:
            file.write("echo copied\n")
        out, messages = self.call("list", tree=copy)
        self.assertEqual(out, f"program of {copy}/build/app list\ncopied\n")
        self.assertIn("configuring it anew", messages)
        self.assertEqual(self.call("list"), (f"program of {self.tree}/build/app list\n", ""))
        self.assertEqual(self.call("list", tree=copy), (out, ""))

    def test_a_moved_tree_is_built_again_in_its_place(self):
        self.call("list")
        moved = os.path.join(self.directory, "moved")
        os.rename(self.tree, moved)
        self.assertEqual(self.call("list", tree=moved)[0], f"program of {moved}/build/app list\n")

    def test_calls_at_the_same_time_build_once(self):
        calls = [self.start("list") for _ in range(4)]
        ends = [call.communicate(timeout=60) + (call.returncode,) for call in calls]
        self.assertEqual([end[0] for end in ends], [f"program of {self.tree}/build/app list\n"] * 4, ends)
        self.assertEqual([end[2] for end in ends], [0] * 4)
        self.assertEqual(self.built(), 1)
        self.assertEqual(sum("waiting for it" in end[1] for end in ends), 3, ends)

    def lock_up(self):
        """The user who may read the tree and not write it."""
        for folder, _, files in os.walk(self.tree):
            for path in [folder] + [os.path.join(folder, name) for name in files]:
                mode = os.stat(path).st_mode
                os.chmod(path, mode & ~0o222 | 0o444 | (0o111 if stat.S_ISDIR(mode) or mode & 0o100 else 0))
                self.addCleanup(lambda path=path, mode=mode: os.chmod(path, mode))
        return NOBODY if os.geteuid() == 0 else None

    def test_a_built_read_only_tree_runs(self):
        out, _ = self.call("list")
        user = self.lock_up()
        self.assertEqual(self.call("list", user=user), (out, ""))

    def test_a_read_only_tree_is_built_elsewhere(self):
        user = self.lock_up()
        _, messages = self.call("list", user=user, code=1)
        self.assertIn("cannot be written", messages)
        self.assertIn("TURGOR_BUILD=DIR", messages)
        elsewhere = os.path.join(self.directory, "elsewhere")
        os.mkdir(elsewhere)
        if user:
            os.chown(elsewhere, user, user)
        self.assertEqual(self.call("list", user=user, build=elsewhere)[0], f"program of {elsewhere}/app list\n")

    def test_a_build_directory_of_another_tree_is_refused(self):
        self.call("list")
        other = os.path.join(self.directory, "other")
        shutil.copytree(self.tree, other, ignore=shutil.ignore_patterns("build"))
        before = self.picture()
        _, messages = self.call("list", tree=other, build=os.path.join(self.tree, "build"), code=2)
        self.assertIn(f"is the build directory of {self.tree}", messages)
        self.assertEqual(self.picture(), before)

    def test_packages_are_announced_and_installed(self):
        log = os.path.join(self.directory, "apt.log")
        self.fake("dpkg-query", f"[[ -e {log}.installed ]] || shift 4; {INSTALLED}")
        self.fake("sudo", 'exec "$@"')
        self.fake("apt-get", f"""echo "$@" >> {log}
[[ "$*" != *assume-no* ]] || {{ echo 'Need to get 12.3 MB of archives.'; echo 'After this operation, 45 MB of it.'; exit 1; }}
[[ "$*" != *'install -y'* ]] || touch {log}.installed""")
        _, messages = self.call("list")
        with open(log, encoding="utf-8") as file:
            update, cost, install = file.read().splitlines()
        self.assertIn("336 MB to download, 2.2 GB on disk", messages)
        self.assertIn("turgor: Need to get 12.3 MB of archives. After this operation, 45 MB of it.", messages)
        self.assertIn("update", update)
        self.assertIn("install", cost)
        self.assertTrue(install.endswith("--no-install-recommends g++"), install)

    def test_what_fails_ends_with_a_sentence(self):
        self.fake("sudo", 'exec "$@"')
        self.fake("dpkg-query", "exit 1")
        self.fake("apt-get", "echo no route to host >&2; exit 100")
        _, messages = self.call("list", code=1)
        self.assertIn("no route to host", messages)
        self.assertIn("turgor: apt-get update has failed", messages)
        self.fake("apt-get", '[[ "$*" == *update* ]] || { echo disk full >&2; exit 100; }')
        self.assertIn("turgor: apt-get install has failed", self.call("list", code=1)[1])
        self.fake("dpkg-query", INSTALLED)
        self.write("CMakeLists.txt", TREE + 'message(FATAL_ERROR "no deal.II")\n')
        _, messages = self.call("list", code=1)
        self.assertIn("no deal.II", messages)
        self.assertIn("turgor: cmake has failed", messages)
        self.write("CMakeLists.txt", TREE.replace("sleep 0.2", "false"))
        self.assertIn("turgor: the build has failed", self.call("list", code=1)[1])
        self.write("CMakeLists.txt", TREE)
        self.call("list")


if __name__ == "__main__":
    unittest.main()
