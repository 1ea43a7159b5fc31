"""The folders may only include along micro <- rve <- coupling -> macro; app and tests see all.
macro knows no particle, micro/io knows no particle either, and neither the engine nor an RVE knows deal.II."""
import os
import re
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
SHARED = {"micro/io/run_context.h", "micro/io/field_file.h", "micro/io/number_text.h", "micro/io/input_entries.h"}


def includes(folder):
    """(file, line number, included path, with quotes?) of every #include below the folder."""
    for place, _, files in os.walk(os.path.join(SOURCE, folder)):
        for name in sorted(files):
            if name.endswith((".h", ".cc", ".def", ".inc")):
                path = os.path.join(place, name)
                with open(path, encoding="utf-8") as file:
                    for number, line in enumerate(file, 1):
                        found = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
                        if found:
                            yield os.path.relpath(path, SOURCE), number, found[2], found[1] == '"'


class IncludeDirection(unittest.TestCase):
    def test_folders(self):
        wrong = []
        for folder, allowed in ALLOWED.items():
            for path, number, included, _ in includes(folder):
                top = included.split("/")[0]
                if (top in ALLOWED or top == "tests") and top not in allowed and included not in SHARED:
                    wrong.append(f"{path}:{number} includes {included}")
        self.assertEqual(wrong, [])

    def test_quoted_paths_begin_at_the_root(self):
        wrong = [f"{path}:{number} includes {included}" for folder in ALLOWED
                 for path, number, included, quoted in includes(folder)
                 if quoted and not os.path.exists(os.path.join(SOURCE, included))]
        self.assertEqual(wrong, [])

    def test_input_and_output_know_no_particle(self):
        wrong = [f"{path}:{number} includes {included}" for path, number, included, quoted in includes("micro/io")
                 if quoted and not included.startswith("micro/io/")]
        self.assertEqual(wrong, [])

    def test_particles_know_no_deal_ii_and_no_mpi(self):
        wrong = [f"{path}:{number} includes {included}" for folder in ("micro", "rve")
                 for path, number, included, _ in includes(folder) if included.startswith("deal.II/") or included == "mpi.h"]
        self.assertEqual(wrong, [])

    def test_numbers_are_printed_by_number_text(self):
        """std::to_string prints 3.5e-9 as 0.000000."""
        wrong = []
        for folder in ALLOWED:
            for place, _, files in os.walk(os.path.join(SOURCE, folder)):
                for name in files:
                    if name.endswith((".h", ".cc", ".inc")) and name != "number_text.h":
                        with open(os.path.join(place, name), encoding="utf-8") as file:
                            if "std::to_string" in file.read():
                                wrong.append(os.path.relpath(os.path.join(place, name), SOURCE))
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
