#!/usr/bin/env python3
"""Makes docs/dialect/codes.md from the tables of codes below src/control/gcode/codes/.

usage: codes_table.py [--check]     --check: exit 1 when the file is not what the tables make
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TABLE = ROOT / "src/control/gcode/codes/mill_codes.def"
PAGE = ROOT / "docs/dialect/codes.md"
STRING = r'"((?:[^"\\]|\\.)*)"'
G = re.compile(
    rf"^(?:ALSO_)?G\((\d+), (\w+), (\w+), {STRING}, (\w+), (-?\d+), (\w+), {STRING},\s*{STRING}, {STRING}\)$", re.MULTILINE
)
M = re.compile(rf"^(?:ALSO_)?M\((\d+), (\w+), (\w+), {STRING}, {STRING}\)$", re.MULTILINE)
HEAD = """<!-- Made by tools/codes_table.py from src/control/gcode/codes/mill_codes.def: change that, run this. -->
# All codes

What each code of a machining centre does, in a sentence. The rules are in [motion.md](motion.md), [macros.md](macros.md) and
[text.md](text.md). A G code that is not here is PS0010, an M code that is not here is passed on.

## G codes
In bold what is in force at power-on. Letters are those of P L Q R I J K that the code takes.

| code | group | letters | |
| --- | --- | --- | --- |
"""
FUNCTIONS = """
## M codes

| code | acts | |
| --- | --- | --- |
"""
MOMENTS = {"before_motion": "before the motion", "behind_motion": "behind it", "at_end_of_block": "at the end of the block"}


def name(number: int) -> str:
    text = f"G{number // 10:02}"
    return text if number % 10 == 0 else f"{text}.{number % 10}"


def group_numbers() -> dict[str, int]:
    text = (TABLE.parent / "code_table.hpp").read_text(encoding="utf-8")
    body = text[text.index("enum class Group") :].split("};", 1)[0]
    return {word: int(number) for word, number in re.findall(r"(\w+) = (\d+)", body)}


def rows(table: str) -> tuple[list[str], list[str]]:
    groups = group_numbers()
    codes, functions = [], []
    for number, _meaning, group, letters, _words, _value, power_on, effect, title, sentence in G.findall(table):
        code = name(int(number))
        code = f"**{code}**" if power_on == "true" else code
        codes.append(f"| {code} | {groups[group]:02} | {' '.join(letters)} | {title}: {sentence} |")
    for number, _function, moment, title, sentence in M.findall(table):
        functions.append(f"| M{int(number):02} | {MOMENTS[moment]} | {title}: {sentence} |")
    return codes, functions


def page() -> str:
    table = TABLE.read_text(encoding="utf-8")
    codes, functions = rows(table)
    written = len(re.findall(r"^\w+\(", table, re.MULTILINE))
    if written != len(codes) + len(functions):
        raise SystemExit(f"{TABLE}: {written} rows, of which {len(codes) + len(functions)} can be read")
    return HEAD + "\n".join(codes) + "\n" + FUNCTIONS + "\n".join(functions) + "\n"


def main() -> int:
    text = page()
    if sys.argv[1:] == ["--check"]:
        if PAGE.is_file() and PAGE.read_text(encoding="utf-8") == text:
            return 0
        print(f"{PAGE.relative_to(ROOT)} is not what the tables make: run tools/codes_table.py", file=sys.stderr)
        return 1
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
