#!/usr/bin/env python3
"""Makes docs/errors.md from src/base/diagnostic_codes.def.

usage: errors_table.py            writes the document
       errors_table.py --check    exit 1 when the document is not what would be written
"""

import difflib
import re
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
TABLE = ROOT / "src/base/diagnostic_codes.def"
DOCUMENT = ROOT / "docs/errors.md"

PREFACE = """\
<!-- Made by tools/errors_table.py from src/base/diagnostic_codes.def: change that, run this. -->

# Errors and alarms

Every code that Kerf reports, in the words of the control, with what it means and what to do about it.
Codes of two letters and four digits are the control's own alarm numbers; names in capitals are Kerf's,
for what a control has no number for. A message names file, line and column, and often says more than
this table.
"""

STRING = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'
ROW = re.compile(r"CODE\(\s*(\w+)\s*,\s*" + STRING + r",\s*" + STRING + r",\s*" + STRING + r"\)\s*\Z")


class Row(NamedTuple):
    number: str
    message: str
    cause: str


class Section(NamedTuple):
    heading: str
    rows: list[Row]


def unquote(literals: str) -> str:
    """The text of one or more C string literals side by side."""
    parts = re.findall(r'"((?:[^"\\]|\\.)*)"', literals)
    return re.sub(r"\\(.)", r"\1", "".join(parts))


def read_row(statement: str, line: int) -> Row:
    match = ROW.match(statement)
    if not match:
        raise SystemExit(f'{TABLE}:{line}: expected CODE(name, "number", "message", "cause")')
    number, message, text = (unquote(match[group]) for group in (2, 3, 4))
    return Row(number, message, text.replace(" | ", " "))


def statements(text: str) -> list[tuple[int, str]]:
    """Comment lines, blank lines and whole CODE(…) rows, which may go over several lines."""
    found: list[tuple[int, str]] = []
    open_row = False
    for number, line in enumerate(text.splitlines(), start=1):
        if open_row:
            found[-1] = (found[-1][0], found[-1][1] + "\n" + line)
        else:
            found.append((number, line))
        open_row = found[-1][1].startswith("CODE(") and not found[-1][1].rstrip().endswith('")')
    return found


def read_sections(text: str) -> list[Section]:
    """A heading is the comment line directly above a row."""
    sections: list[Section] = []
    comment = ""
    for line, statement in statements(text):
        if statement.startswith("//"):
            comment = statement.removeprefix("//").strip()
        elif not statement.strip():
            comment = ""
        else:
            row = read_row(statement, line)
            if comment or not sections:
                sections.append(Section(comment or "General", []))
            sections[-1].rows.append(row)
            comment = ""
    return sections


def cell(text: str) -> str:
    return re.sub(r"([|*<>])", r"\\\1", text)


def section_text(section: Section) -> str:
    lines = [f"## {section.heading}", ""]
    lines += ["| code | message | meaning and remedy |", "| --- | --- | --- |"]
    lines += [f"| `{row.number}` | {cell(row.message)} | {cell(row.cause)} |" for row in section.rows]
    return "\n".join(lines) + "\n"


def document() -> str:
    sections = read_sections(TABLE.read_text(encoding="utf-8"))
    return "\n".join([PREFACE, *map(section_text, sections)])


def check(wanted: str) -> int:
    present = DOCUMENT.read_text(encoding="utf-8") if DOCUMENT.exists() else ""
    if present == wanted:
        return 0
    lines = difflib.unified_diff(present.splitlines(), wanted.splitlines(), n=0, lineterm="")
    print("\n".join(list(lines)[2:20]), file=sys.stderr)
    print("docs/errors.md is out of date: run tools/errors_table.py", file=sys.stderr)
    return 1


def main() -> int:
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    if sys.argv[1:]:
        return check(document())
    DOCUMENT.parent.mkdir(exist_ok=True)
    DOCUMENT.write_text(document(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
