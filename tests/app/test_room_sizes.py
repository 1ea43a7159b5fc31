"""Small rooms: no file of the product's code has more than 300 lines and no function more than 80, from its head to its last brace.
What has to be larger is named here, with its reason."""
import os
import re
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDERS = ["app", "coupling", "macro", "micro", "run", "rve"]
LINES, FUNCTION = 300, 80
LARGER_FILES = {}      # path: why
LARGER_FUNCTIONS = {}  # (path, name): why


def blank(found):
    return re.sub(r"[^\n]", " ", found.group(0))


def code_of(text):
    """The text without comments, strings, characters and directives, every line and column in its place."""
    text = re.sub(r"""//[^\n]*|/\*.*?\*/|R"\(.*?\)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'""", blank, text, flags=re.S)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", blank, text, flags=re.M)


def opens(head):
    """What a brace behind this head opens: a scope that holds functions, a function, or anything else."""
    head = re.sub(r"template\s*<[^{}]*?>\s*(?=\w)", "", head)
    if re.match(r"(inline\s+)?namespace\b|extern\b\s*$", head):
        return "scope"
    if re.search(r"\b(class|struct|union|enum)\b", head) and not re.search(r"\)\s*(const|noexcept|override|final|\s)*(->.*)?$", head):
        return "scope"
    if re.search(r"=\s*$", head) or re.search(r"\)\s*:(?!:).*[\w>]\s*$", head, re.S):
        return "other"  # a value, or a member that a constructor begins with {}
    return "function" if ")" in head else "other"


def functions(text):
    """(line, lines, name) of every function that has a body here, those inside classes included, lambdas not."""
    code, found, open_braces, start = code_of(text), [], [], 0
    inside = lambda: any(kind == "function" for kind, _, _ in open_braces)
    for at, letter in enumerate(code):
        if letter == "{":
            head = code[start:at]
            kind = "other" if inside() else opens(head.strip())
            open_braces.append((kind, start + len(head) - len(head.lstrip()), head.strip()))
            if kind != "other" or inside():
                start = at + 1
        elif letter == "}" and open_braces:
            kind, begin, head = open_braces.pop()
            if kind == "function":
                line = code.count("\n", 0, begin) + 1
                name = re.search(r"([\w:~<>]+|operator\s*\S+)\s*\(", head)
                found.append((line, code.count("\n", 0, at) + 2 - line, name[1] if name else head))
            if kind != "other" or inside():
                start = at + 1
        elif letter == ";" and (not open_braces or open_braces[-1][0] != "other" or inside()):
            start = at + 1
    return found


def sources(tree):
    for folder in FOLDERS:
        for place, _, files in sorted(os.walk(os.path.join(tree, folder))):
            for name in sorted(files):
                if name.endswith((".h", ".cc")):
                    path = os.path.join(place, name)
                    with open(path, encoding="utf-8") as file:
                        yield os.path.relpath(path, tree), file.read()


def too_large(tree):
    wrong = []
    for path, text in sources(tree):
        if text.count("\n") > LINES and path not in LARGER_FILES:
            wrong.append(f"{path} has {text.count(chr(10))} lines")
        wrong += [f"{path}:{line} {name} has {lines} lines" for line, lines, name in functions(text)
                  if lines > FUNCTION and (path, name) not in LARGER_FUNCTIONS]
    return wrong


class RoomSizes(unittest.TestCase):
    def test_files_and_functions(self):
        self.assertEqual(too_large(SOURCE), [])

    def test_no_exception_that_nobody_needs(self):
        texts = dict(sources(SOURCE))
        for path in LARGER_FILES:
            self.assertGreater(texts[path].count("\n"), LINES, path)
        for path, name in LARGER_FUNCTIONS:
            self.assertGreater(max(lines for _, lines, found in functions(texts[path]) if found == name), FUNCTION, name)

    def test_the_check_sees_what_is_too_large(self):
        with tempfile.TemporaryDirectory() as tree:
            def put(path, text):
                os.makedirs(os.path.join(tree, os.path.dirname(path)), exist_ok=True)
                with open(os.path.join(tree, path), "w", encoding="utf-8") as file:
                    file.write(text)
            body = "  work(\"}\"); // }\n"
            put("run/long.cc", "\n" * 301)
            put("run/fits.cc", "void f()\n{\n" + body * 77 + "}\n" + "\n" * 220)
            put("micro/engine/a.h", "namespace a\n{\ntemplate <class T>\nclass B\n{\n  int list[2] = {1, 2};\n  auto f(T t) const -> int\n  {\n"
                + "    for (;;)\n    {\n    }\n" * 26 + "  }\n};\n} // namespace a\n")
            put("rve/b.cc", "B::B()\n  : x{1}\n{\n" + "  const auto g = [&] { return 1; };\n" * 78 + "}\nvoid B::C<2>::h(int)\n{\n}\n")
            self.assertEqual(too_large(tree), ["micro/engine/a.h:7 f has 81 lines", "run/long.cc has 301 lines", "rve/b.cc:1 B::B has 82 lines"])


if __name__ == "__main__":
    unittest.main()
