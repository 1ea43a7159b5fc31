"""The folders may only include along run <- micro <- rve <- coupling -> macro -> run, and those of micro along
geometry, laws <- solve, engine <- terms <- cells <- processes <- scenes; app and tests see all. run knows no physics, macro no particle,
and neither particles nor an RVE know deal.II."""
import os
import re
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# folder: the folders that it may include beside itself
GEOMETRY = ["run", "micro/geometry"]
LAWS = GEOMETRY + ["micro/laws"]
SOLVE = LAWS + ["micro/solve"]
ENGINE = SOLVE + ["micro/engine"]
TERMS = ENGINE + ["micro/terms"]
CELLS = TERMS + ["micro/cells"]
PROCESSES = CELLS + ["micro/processes"]
REFERENCE = PROCESSES + ["micro/scenes/reference"]
ALLOWED = {
    "run": [],
    "micro/geometry": ["run"],
    "micro/laws": GEOMETRY,
    "micro/solve": LAWS,
    "micro/engine": SOLVE,
    "micro/terms": ENGINE,
    "micro/cells": TERMS,
    "micro/processes": CELLS,
    "micro/scenes/reference": PROCESSES,
    "micro/scenes": REFERENCE,
    "rve": PROCESSES,
    "macro": ["run"],
    "coupling": PROCESSES + ["micro/scenes", "rve", "macro"],
    "app": PROCESSES + ["rve", "macro", "coupling", "micro/scenes"],
}
TOPS = {"run", "micro", "rve", "macro", "coupling", "app", "tests", "benchmarks"}


def folder_of(path):
    """The longest entry of ALLOWED that the path is below, or None."""
    return max((folder for folder in ALLOWED if path.startswith(folder + "/")), key=len, default=None)


def sources(tree):
    for folder in sorted({name.split("/")[0] for name in ALLOWED}):
        for place, _, files in os.walk(os.path.join(tree, folder)):
            for name in sorted(files):
                if name.endswith((".h", ".cc", ".def", ".inc")):
                    yield os.path.join(place, name)


def includes(tree):
    """(file, line number, included path, with quotes?) of every #include."""
    for path in sources(tree):
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                found = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
                if found:
                    yield os.path.relpath(path, tree), number, found[2], found[1] == '"'


def wrong_folders(tree):
    wrong = []
    for path, number, included, _ in includes(tree):
        if included.split("/")[0] in TOPS:
            folder, other = folder_of(path), folder_of(included)
            if folder is None or other is None or (other != folder and other not in ALLOWED[folder]):
                wrong.append(f"{path}:{number} includes {included}")
    return wrong


def wrong_paths(tree):
    return [f"{path}:{number} includes {included}" for path, number, included, quoted in includes(tree)
            if quoted and not os.path.exists(os.path.join(tree, included))]


def wrong_libraries(tree):
    return [f"{path}:{number} includes {included}" for path, number, included, _ in includes(tree)
            if path.split("/")[0] in ("run", "micro", "rve") and (included.startswith("deal.II/") or included == "mpi.h")]


def wrong_numbers(tree):
    wrong = []
    for path in sources(tree):
        if os.path.basename(path) != "number_text.h":
            with open(path, encoding="utf-8") as file:
                if "std::to_string" in file.read():
                    wrong.append(os.path.relpath(path, tree))
    return wrong


class IncludeDirection(unittest.TestCase):
    def test_folders(self):
        self.assertEqual(wrong_folders(SOURCE), [])

    def test_quoted_paths_begin_at_the_root(self):
        self.assertEqual(wrong_paths(SOURCE), [])

    def test_particles_know_no_deal_ii_and_no_mpi(self):
        self.assertEqual(wrong_libraries(SOURCE), [])

    def test_numbers_are_printed_by_number_text(self):
        """std::to_string prints 3.5e-9 as 0.000000."""
        self.assertEqual(wrong_numbers(SOURCE), [])

    def test_the_checks_see_what_is_wrong(self):
        """Each check on a tree of its own, with one fault for it and one include that is allowed."""
        with tempfile.TemporaryDirectory() as tree:
            def put(path, text):
                os.makedirs(os.path.join(tree, os.path.dirname(path)), exist_ok=True)
                with open(os.path.join(tree, path), "w", encoding="utf-8") as file:
                    file.write(text)
            put("run/run_context.h", '#include "micro/engine/a.h"\n')
            put("micro/engine/a.h", '#include <vector>\n#include <deal.II/fe/fe_q.h>\n#include <mpi.h>\n#include "micro/terms/t.h"\n')
            put("micro/terms/t.h", '#include "micro/engine/a.h"\n')
            put("micro/scenes/tissue/s.h", '#include "micro/terms/t.h"\n#include "micro/scenes/reference/r.h"\n')
            put("micro/scenes/reference/r.h", '#include "micro/scenes/tissue/s.h"\n')
            put("rve/b.cc", '#include "micro/engine/a.h"\n#  include "coupling/c.h"\n')
            put("macro/d.cc", '#include "run/run_context.h"\n#include "micro/engine/a.h"\n#include "macro/none.h"\n')
            put("coupling/c.h", '#include "tests/e.h"\nauto text = std::to_string(1);\n')
            put("tests/e.h", "")
            self.assertEqual(wrong_folders(tree), [
                "coupling/c.h:1 includes tests/e.h", "macro/d.cc:2 includes micro/engine/a.h", "micro/engine/a.h:4 includes micro/terms/t.h",
                "micro/scenes/reference/r.h:1 includes micro/scenes/tissue/s.h", "run/run_context.h:1 includes micro/engine/a.h",
                "rve/b.cc:2 includes coupling/c.h"])
            self.assertEqual(wrong_paths(tree), ["macro/d.cc:3 includes macro/none.h"])
            self.assertEqual(wrong_libraries(tree), ["micro/engine/a.h:2 includes deal.II/fe/fe_q.h", "micro/engine/a.h:3 includes mpi.h"])
            self.assertEqual(wrong_numbers(tree), ["coupling/c.h"])


if __name__ == "__main__":
    unittest.main()
