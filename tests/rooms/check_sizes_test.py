#!/usr/bin/env python3
"""Holds tools/check_sizes.py against small texts: which functions it sees in them, and how long they are.

usage: check_sizes_test.py
"""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import check_sizes  # noqa: E402

CPP = {
    "one line": ("int f() { return 1; }\n", [1]),
    "a member": ("Outcome<int> Mill::turn(\n    int n) const {\n  return n;\n}\n", [4]),
    "values of members": ("Mill::Mill()\n    : a_{1},\n      b_(2) {\n  turn();\n}\nint g() {}\n", [5, 1]),
    "inside of a class": ("namespace a {\nclass B {\n public:\n  int f() {\n    return 1;\n  }\n};\n}\n", [4]),
    "a lambda belongs to its function": ("void f() {\n  run([] {\n    go();\n  });\n}\n", [5]),
    "a type behind": ("auto f() -> int {\n}\n", [2]),
    "no function": ("struct A {\n  int b{1};\n};\nenum class C { d };\nconst int e[] = {1, 2};\nint f();\n", []),
    "braces of texts": ('void f() {\n  go("}", \'{\', R"(})");  // }\n}\nvoid g() {}\n', [3, 1]),
}
SCRIPT = {
    "a function": ("export function f(a: number): void {\n  go();\n}\n", [3]),
    "an arrow": ("const f = (a) => {\n  go();\n};\n", [3]),
    "a method": ("class A {\n  f(): void {\n  }\n}\n", [2]),
    "a text with values": ("function f() {\n  return `}${g({ a })}`;\n}\n", [3]),
    "an expression": ("function f() {\n  return a.replace(/[{\"]/, b);\n}\n", [3]),
    "a statement": ("if (a) {\n  go();\n}\nfunction f() {}\n", [1]),
}
PYTHON = {
    "a method": ("class A:\n    def f(self):\n        return 1\n", [2]),
    "one inside belongs to it": ("def f():\n    def g():\n        pass\n    return g\n", [4]),
}


class Functions(unittest.TestCase):
    def sees(self, cases, functions_of):
        for name, (text, lines) in cases.items():
            with self.subTest(name):
                self.assertEqual([function.lines for function in functions_of(text)], lines)

    def test_of_cpp(self):
        self.sees(CPP, check_sizes.functions_of_cpp)

    def test_of_scripts(self):
        self.sees(SCRIPT, check_sizes.functions_of_script)

    def test_of_python(self):
        self.sees(PYTHON, check_sizes.functions_of_python)

    def test_of_a_component_keep_their_lines(self):
        found = list(check_sizes.functions_of_page("<p>{a}</p>\n<script>\n  function f() {\n  }\n</script>\n"))
        self.assertEqual([(function.line, function.lines) for function in found], [(3, 2)])


class Rules(unittest.TestCase):
    def found(self, text: str) -> list[str]:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "src/a.cpp"
            file.parent.mkdir()
            file.write_text(text)
            return check_sizes.check(Path(folder))[1]

    def test_short_functions_are_left_alone(self):
        self.assertEqual(self.found("void f() {\n}\n" * 30), [])

    def test_a_function_has_so_many_lines(self):
        many = "void f() {}\n" * 30
        for lines, found in ((check_sizes.MOST, 0), (check_sizes.MOST + 1, 1)):
            text = many + "void g() {\n" + "  go();\n" * (lines - 2) + "}\n"
            self.assertEqual(len(self.found(text)), found)

    def test_a_file_has_so_many_lines(self):
        for lines, found in ((check_sizes.MOST_OF_FILE, 0), (check_sizes.MOST_OF_FILE + 1, 1)):
            self.assertEqual(len(self.found("void f() {}\n" + "\n" * (lines - 1))), found)

    def test_half_of_the_functions_are_short(self):
        found = self.found("void f() {\n  a();\n  b();\n  c();\n  d();\n}\n" * 30)
        self.assertEqual(len(found), 1)
        self.assertIn("of 100 functions 50 have to 6 lines, not 5", found[0])

    def test_nearly_all_are(self):
        found = self.found("void f() {}\n" * 18 + ("void g() {\n" + "  go();\n" * 19 + "}\n") * 2)
        self.assertIn("of 100 functions 95 have to 21 lines, not 20", found[0])


if __name__ == "__main__":
    unittest.main()
