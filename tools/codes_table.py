#!/usr/bin/env python3
"""Makes docs/dialect/codes.md and docs/dialect/lathe-codes.md from the tables of codes below src/control/gcode/codes/.

usage: codes_table.py [--check]     --check: exit 1 when a file is not what the tables make
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CODES = ROOT / "src/control/gcode/codes"
STRING = r'"((?:[^"\\]|\\.)*)"'
REST = rf"(\w+), (\w+), {STRING}, (\w+), (-?\d+), (\w+), {STRING},\s*{STRING}, {STRING}\)$"
M = re.compile(rf"^(?:ALSO_)?M\((\d+), (\w+), (\w+), {STRING}, {STRING}\)$", re.MULTILINE)
FUNCTIONS = """
## M codes

| code | acts | |
| --- | --- | --- |
"""
MOMENTS = {"before_motion": "before the motion", "behind_motion": "behind it", "at_end_of_block": "at the end of the block"}
MADE = "<!-- Made by tools/codes_table.py from src/control/gcode/codes/{}: change that, run this. -->\n"
MILL_HEAD = """# All codes

What each code of a machining centre does, in a sentence. The rules are in [motion.md](motion.md), [macros.md](macros.md) and
[text.md](text.md). A G code that is not here is PS0010, an M code that is not here is passed on. Those of lathes are
[a page of their own](lathe-codes.md).

## G codes
In bold what is in force at power-on. Letters are those of P L Q R I J K that the code takes.

| code | group | letters | |
| --- | --- | --- | --- |
"""
LATHE_HEAD = """# All codes of a lathe

What each code of `fanuc-lathe` does, in a sentence. The rules are in [turning.md](turning.md). A, B and C are the systems of
G codes, parameter `gsystem`; – is a code that a system lacks. A G code that is not here is PS0010, an M code that is not here
is passed on.

## G codes
In bold what is in force at power-on. Letters are those of P L Q R I J K D that the code takes. The group is the number behind
#40 of the variable that holds its code; – is a group without one.

| A | B | C | group | letters | |
| --- | --- | --- | --- | --- | --- |
"""


def name(number: str) -> str:
    if not number.isdigit():
        return "–"
    text = f"G{int(number) // 10:02}"
    return text if int(number) % 10 == 0 else f"{text}.{int(number) % 10}"


def mill_groups() -> dict[str, str]:
    text = (CODES / "code_table.hpp").read_text(encoding="utf-8")
    body = text[text.index("enum class Group") :].split("};", 1)[0]
    return {word: f"{int(number):02}" for word, number in re.findall(r"(\w+) = (\d+)", body)}


def lathe_groups() -> dict[str, str]:
    text = (CODES / "lathe_codes.cpp").read_text(encoding="utf-8")
    body = text[text.index("kNumbers = {") :].split("};", 1)[0]
    order = re.findall(r"Group::(\w+)", body)
    numbers = {word: f"{number:02}" for number, word in enumerate(order) if word != "none"}
    return {word: numbers.get(word, "–") for word in mill_groups()}


class Page:
    """A page, the table of codes it is made of, and how many systems of G codes that has."""

    def __init__(self, page: str, table: str, systems: int, head: str, groups: dict[str, str]):
        self.path = ROOT / "docs/dialect" / page
        self.table = CODES / table
        self.g = re.compile(r"^(?:ALSO_)?G\(" + r"(-?\w+), " * systems + REST, re.MULTILINE)
        self.systems = systems
        self.head = MADE.format(table) + head
        self.groups = groups

    def code(self, columns: tuple[str, ...]) -> str:
        _meaning, group, letters, _words, _value, power_on, _effect, title, sentence = columns[self.systems :]
        mark = "**" if power_on == "true" else ""
        codes = [f"{mark}{name(n)}{mark}" if n.isdigit() else "–" for n in columns[: self.systems]]
        return f"| {' | '.join(codes)} | {self.groups[group]} | {' '.join(letters)} | {title}: {sentence} |"

    def text(self) -> str:
        table = self.table.read_text(encoding="utf-8")
        codes = [self.code(columns) for columns in self.g.findall(table)]
        functions = [f"| M{int(number):02} | {MOMENTS[moment]} | {title}: {sentence} |"
                     for number, _function, moment, title, sentence in M.findall(table)]
        written = len(re.findall(r"^\w+\(", table, re.MULTILINE))
        if written != len(codes) + len(functions):
            raise SystemExit(f"{self.table}: {written} rows, of which {len(codes) + len(functions)} can be read")
        return self.head + "\n".join(codes) + "\n" + FUNCTIONS + "\n".join(functions) + "\n"


def main() -> int:
    pages = [Page("codes.md", "mill_codes.def", 1, MILL_HEAD, mill_groups()),
             Page("lathe-codes.md", "lathe_codes.def", 3, LATHE_HEAD, lathe_groups())]
    old = [page for page in pages if not page.path.is_file() or page.path.read_text(encoding="utf-8") != page.text()]
    for page in old:
        if sys.argv[1:] == ["--check"]:
            print(f"{page.path.relative_to(ROOT)} is not what the tables make: run tools/codes_table.py", file=sys.stderr)
        else:
            page.path.write_text(page.text(), encoding="utf-8")
    return 1 if old and sys.argv[1:] == ["--check"] else 0


if __name__ == "__main__":
    sys.exit(main())
