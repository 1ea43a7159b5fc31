"""The folders may only include along micro <- rve <- coupling -> macro; app and tests see all.
macro knows no particle, micro/io knows no particle either, and neither the engine nor an RVE knows deal.II."""
import os
import re
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ALLOWED = {
    "micro": {"micro"},
    "rve": {"rve", "micro"},
    "macro": {"macro"},
    "coupling": {"coupling", "macro", "rve", "micro"},
    "app": {"app", "coupling", "macro", "rve", "micro"},
}
# What every folder may say to the person who runs it: the run's context, no particle.
SHARED = {"micro/io/run_context.h", "micro/io/field_file.h", "micro/io/number_text.h", "micro/io/input_entries.h",
          "micro/io/entry_marks.h"}


def sources(folder, tree):
    for place, _, files in os.walk(os.path.join(tree, folder)):
        for name in sorted(files):
            if name.endswith((".h", ".cc", ".def", ".inc")):
                yield os.path.join(place, name)


def includes(folder, tree):
    """(file, line number, included path, with quotes?) of every #include below the folder."""
    for path in sources(folder, tree):
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                found = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
                if found:
                    yield os.path.relpath(path, tree), number, found[2], found[1] == '"'


def wrong_folders(tree):
    wrong = []
    for folder, allowed in ALLOWED.items():
        for path, number, included, _ in includes(folder, tree):
            top = included.split("/")[0]
            if (top in ALLOWED or top == "tests") and top not in allowed and included not in SHARED:
                wrong.append(f"{path}:{number} includes {included}")
    return wrong


def wrong_paths(tree):
    return [f"{path}:{number} includes {included}" for folder in ALLOWED for path, number, included, quoted in includes(folder, tree)
            if quoted and not os.path.exists(os.path.join(tree, included))]


def wrong_particles(tree):
    return [f"{path}:{number} includes {included}" for path, number, included, quoted in includes("micro/io", tree)
            if quoted and not included.startswith("micro/io/")]


def wrong_libraries(tree):
    return [f"{path}:{number} includes {included}" for folder in ("micro", "rve") for path, number, included, _ in includes(folder, tree)
            if included.startswith("deal.II/") or included == "mpi.h"]


def wrong_numbers(tree):
    wrong = []
    for folder in ALLOWED:
        for path in sources(folder, tree):
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

    def test_input_and_output_know_no_particle(self):
        self.assertEqual(wrong_particles(SOURCE), [])

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
            put("micro/io/run_context.h", '#include "micro/engine/a.h"\n')
            put("micro/engine/a.h", '#include <vector>\n#include <deal.II/fe/fe_q.h>\n#include <mpi.h>\n')
            put("rve/b.cc", '#include "micro/engine/a.h"\n#  include "coupling/c.h"\n')
            put("macro/d.cc", '#include "micro/io/run_context.h"\n#include "micro/engine/a.h"\n#include "macro/none.h"\n')
            put("coupling/c.h", '#include "tests/e.h"\nauto text = std::to_string(1);\n')
            put("tests/e.h", "")
            self.assertEqual(wrong_folders(tree), ["rve/b.cc:2 includes coupling/c.h", "macro/d.cc:2 includes micro/engine/a.h",
                                                   "coupling/c.h:1 includes tests/e.h"])
            self.assertEqual(wrong_paths(tree), ["macro/d.cc:3 includes macro/none.h"])
            self.assertEqual(wrong_particles(tree), ["micro/io/run_context.h:1 includes micro/engine/a.h"])
            self.assertEqual(wrong_libraries(tree), ["micro/engine/a.h:2 includes deal.II/fe/fe_q.h", "micro/engine/a.h:3 includes mpi.h"])
            self.assertEqual(wrong_numbers(tree), ["coupling/c.h"])


if __name__ == "__main__":
    unittest.main()
