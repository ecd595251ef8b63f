#!/usr/bin/env python3
"""Holds tools/check_rooms.py against small trees of rooms: what each of its rules must find, and what none may.

usage: check_rooms_test.py
"""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import check_rooms  # noqa: E402

LINKS = {
    "math": "kerf_room()",
    "base": "kerf_room(SOURCES made.cpp)",
    "lang/gcode": "kerf_room(LINKS kerf_base)",
    "lang/basic": "kerf_room(LINKS kerf_base)",
    "control/gcode": "kerf_room(\n  LINKS kerf_lang_gcode kerf_base kerf_math fmt::fmt)",
}

FOUND = {
    "a room below": ("base/a.cpp", '#include "control/gcode/b.hpp"\n', "control/gcode stands below base"),
    "a room beside": ("lang/basic/a.cpp", '#include "lang/gcode/b.hpp"\n', "is not among what lang/basic uses"),
    "a room that is not linked": ("lang/gcode/a.cpp", '#include "math/math.hpp"\n', "does not link kerf_math"),
    "the inside of another room": ("control/gcode/a.cpp", '#include "base/internal/b.hpp"\n', "internal/ is for base"),
    "a path from elsewhere": ("control/gcode/a.cpp", '#include "b.hpp"\n', "is in no room"),
    "a folder that is no room": ("attic/a.cpp", "", "is no room"),
    "a sine of the library": ("control/gcode/a.cpp", "double y = std::sin(x);\n", "std::sin"),
    "a global one": ("control/gcode/a.cpp", "double y = ::pow(x, 2);\n", "::pow"),
    "one without a name in front": ("control/gcode/a.cpp", "return hypot(x, y);\n", "hypot"),
    "strtod": ("control/gcode/a.cpp", "const double x = std::strtod(text, nullptr);\n", "strtod"),
    "strtol": ("control/gcode/a.cpp", "long n = strtol(text, &end, 10);\n", "strtol"),
    "stod": ("control/gcode/a.cpp", "return std::stod(text);\n", "stod"),
    "stoi": ("control/gcode/a.cpp", "return stoi (text);\n", "stoi"),
    "atof": ("control/gcode/a.cpp", "x = atof(text);\n", "atof"),
    "from_chars": ("control/gcode/a.cpp", "std::from_chars(begin, end, x);\n", "from_chars"),
    "to_chars beside the border": ("base/a.cpp", "std::to_chars(begin, end, x);\n", "to_chars"),
    "sscanf": ("control/gcode/a.cpp", 'std::sscanf(text, "%lf", &x);\n', "sscanf"),
    "snprintf": ("control/gcode/a.cpp", 'std::snprintf(text, 9, "%d", n);\n', "snprintf"),
    "a float of printf": ("control/gcode/a.cpp", 'std::fprintf(stderr,\n             "at %-8.3f", x);\n', "printf"),
    "a stream of text": ("control/gcode/a.cpp", "#include <sstream>\n", "<sstream>"),
    "manipulators": ("control/gcode/a.cpp", "# include <iomanip>\n", "<iomanip>"),
    "the locale": ("control/gcode/a.cpp", 'std::setlocale(LC_ALL, "");\n', "setlocale"),
    "the locale by fmt": ("control/gcode/a.cpp", 'fmt::format("{:.2Lf}", x);\n', "L"),
    "a code in a switch": ("control/gcode/a.cpp", "    case 540: return work(0);\n", "case 540:"),
    "one with its letter": ("control/gcode/a.cpp", "  case M30: break;\n", "case M30:"),
    "behind another": ("control/gcode/a.cpp", 'std::printf("%d", n);\nstd::printf("%g", x);\n', "a.cpp:2"),
}

NOT_FOUND = {
    "rooms above": ("control/gcode/a.cpp", '#include "base/b.hpp"\n#include "control/gcode/internal/c.hpp"\n'),
    "headers of the library": ("control/gcode/a.cpp", "#include <cmath>\n#include <string>\n"),
    "math's own sine": ("control/gcode/a.cpp", "double y = math::sin(x);\n"),
    "a sine that is named": ("control/gcode/a.cpp", "using math::sin;\ndouble y = sin(x);\n"),
    "what is exact everywhere": ("control/gcode/a.cpp", "std::sqrt(x) + std::floor(x) + std::fmod(x, y);\n"),
    "math itself": ("math/a.cpp", "double y = std::log(x);\n"),
    "the border": ("base/decimal.cpp", "std::from_chars(begin, end, x);\nstd::to_chars(begin, end, x);\n"),
    "printf without floats": ("control/gcode/a.cpp", 'std::fprintf(stderr, "%s: %llu %d %%\\n", text, n, i);\nx = a % f;\n'),
    "fmt": ("control/gcode/a.cpp", 'fmt::format("{:.2f} {:02X} {}: {}", x, n, text, text);\n'),
    "comments": ("control/gcode/a.cpp", "// not by strtod(text) or std::sin(x)\n"),
    "a number in another room": ("base/a.cpp", "    case 2: return 1;\n"),
    "names that contain one": ("control/gcode/a.cpp", "restrtod(x); my_atoi(y); histoi(z);\n"),
}


def findings(files: dict[str, str], links: dict[str, str] = LINKS) -> list[str]:
    """What is found in a tree of the rooms `links`, with these files."""
    with tempfile.TemporaryDirectory() as folder:
        src = Path(folder) / "src"
        rooms = {f"{room}/CMakeLists.txt": call for room, call in links.items()}
        readmes = {f"{room}/README.md": f"# {room}\n" for room in links}
        for path, text in (rooms | readmes | files).items():
            (src / path).parent.mkdir(parents=True, exist_ok=True)
            (src / path).write_text(text)
        return check_rooms.check(Path(folder))[1]


class Rules(unittest.TestCase):
    def one_finding(self, wanted: str, found: list[str]) -> None:
        self.assertEqual(len(found), 1, found)
        self.assertIn(wanted, found[0])

    def test_finds(self):
        for name, (path, text, wanted) in FOUND.items():
            with self.subTest(name):
                self.one_finding(wanted, findings({path: text}))

    def test_leaves_alone(self):
        for name, (path, text) in NOT_FOUND.items():
            with self.subTest(name):
                self.assertEqual(findings({path: text}), [])

    def test_a_folder_holds_so_many_classes(self):
        for count, found in ((check_rooms.MOST_CLASSES, 0), (check_rooms.MOST_CLASSES + 1, 1)):
            files = {f"base/class_{i}.{suffix}": "" for i in range(count) for suffix in ("cpp", "hpp")}
            self.assertEqual(len(findings(files)), found)

    def test_a_class_has_one_source(self):
        one = "namespace kerf {\n\nvoid Mill::turn() {\n  Lathe::turn();\n}\n"
        others = {
            "Mill::~Mill() = default;\n": 1,
            "Outcome<std::vector<int>> Mill::run(\n    int count) {}\n": 1,
            "std::strong_ordering Mill::operator<=>(const Mill& other) const {}\n": 1,
            "void Lathe::turn() {}\n": 0,
            "void Mill::Spindle::turn() {}\n": 0,
            "const double top = Mill::turn(2);\n": 0,
            "// as in void Mill::turn()\n": 0,
            "void turn(Mill& mill) {\n  Mill::turn();\n}\n": 0,
        }
        for other, found in others.items():
            with self.subTest(other):
                files = {"base/mill.cpp": one, "base/internal/mill_more.cpp": other}
                self.assertEqual(len(findings(files)), found)

    def test_a_room_may_not_link_one_below(self):
        found = findings({}, {"base": "kerf_room(LINKS kerf_control_gcode)\n"})
        self.one_finding("base may not link control/gcode", found)

    def test_a_room_has_a_short_readme(self):
        most = check_rooms.MOST_README_LINES
        self.one_finding("has no README.md", findings({"base/README.md": ""}))
        self.one_finding(f"{most + 1} lines", findings({"base/README.md": "a line\n" * (most + 1)}))
        self.assertEqual(findings({"base/README.md": "a line\n" * most}), [])


if __name__ == "__main__":
    unittest.main()
