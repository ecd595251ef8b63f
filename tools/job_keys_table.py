#!/usr/bin/env python3
"""Makes docs/job-keys.md from src/process/keys.def.

usage: job_keys_table.py [--check]     --check: exit 1 when the page is not what the table makes
"""

import re
import sys
from decimal import Decimal
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
TABLE = ROOT / "src/process/keys.def"
PAGE = ROOT / "docs/job-keys.md"
STRING = r'"((?:[^"\\]|\\.)*)"'
ROW = re.compile(rf"KEY\((\w+), {STRING}, (\w+)\((.*?)\), {STRING}, {STRING}, (every|of\([\w, ]+\)), (\w+), {STRING}\)$")
HEAD = """<!-- Made by tools/job_keys_table.py from src/process/keys.def: change that, run this. -->

# Keys of a job file

A job file is TOML. `job = {…}` and `[job]` are the same, and so with every table. What is not said has the value under
*otherwise*; lengths are mm. `--job-set` names a key by its path: `place.scale=2`, `operation.outline.feed=600` (an operation by
its name, or counted from 1), `operation.1.lead_in.length=2`, `text.serial.start=7`.
"""
TITLES = {
    "job": ("[job]", ""),
    "place": ("[place]", "Where the drawing lies; done in this order, whatever the order of the file is."),
    "array": ("[array]", "Copies of all of it, in a grid or round a centre."),
    "text": ("[text]", "Texts of drawings are drawn only if the job has this table."),
    "serial": ("[text.serial]", "What `{serial}` stands for in a text: a number that grows from copy to copy."),
    "line": ("[[text.line]]", "A text of the job's own. `{NAME}` is the value of `--set NAME=VALUE`, `{{` a brace."),
    "image": ("[image]", "How large pictures are, whatever they say themselves."),
    "wrap": ("[wrap]", "The surface that the drawing lies on, for a head that turns."),
    "lens": ("[lens]", ""),
    "operation": ("[[operation]]", "Made in the order of the file. A key that the process does not take is an error."),
    "lead": ("lead_in, lead_out", "Of an operation: `lead_in = {kind = \"line\", length = 2}`."),
    "tabs": ("tabs", "Of an operation: `tabs = {count = 4, width = 0.5}`."),
    "weave": ("weave", "Of an operation: `weave = {shape = \"zigzag\", width = 1, pitch = 2}`."),
    "material": ("[[material]]", "Of a file of `--materials`. A table of each process, `[material.cut]`, has what follows."),
    "preset": ("[material.cut]", "Also `.engrave .mark .fill .raster .weld .heat .drill`; mark, fill and raster without a table are as engrave."),
}


class Row(NamedTuple):
    table: str
    name: str
    takes: str
    unit: str
    otherwise: str
    processes: str
    about: str


def number(text: str) -> str:
    return format(Decimal(text), "f")


def span(values: list[str]) -> str:
    return f"{number(values[0])} to {number(values[1])}"


def in_words(form: str, arguments: str) -> str:
    """What a key takes, for the page."""
    values = [value.strip().strip('"') for value in arguments.split(",")]
    words = [", ".join(f"`{word}`" for word in value.split("|")) for value in values]
    return {
        "numbers": lambda: span(values),
        "any_number": lambda: "a number",
        "not_negative": lambda: "a number, not negative",
        "positive": lambda: "a number above 0",
        "whole_numbers": lambda: "whole, " + span(values),
        "flag": lambda: "`true`, `false`",
        "one_of": lambda: words[0],
        "text": lambda: "a text",
        "texts": lambda: "a text or a list of texts",
        "pair": lambda: "`[x, y]`",
        "size_pair": lambda: "`[width, height]`",
        "triple": lambda: "`[x, y, z]`",
        "pairs": lambda: "`[[x, y], …]`",
        "number_or_pair": lambda: f"{span(values)}, or `[x, y]`",
        "number_or_word": lambda: f"{words[2]}, or {span(values)}",
        "word_or_pair": lambda: f"{words[0]}, or `[x, y]`",
        "table": lambda: "a table",
    }[form]()


def read_row(line: str) -> Row:
    match = ROW.match(line)
    if not match:
        raise SystemExit(f"{TABLE}: cannot be read: {line}")
    table, name, form, arguments, unit, otherwise, processes, _member, about = match.groups()
    unquoted = [re.sub(r"\\(.)", r"\1", text) for text in (unit, otherwise, about)]
    taken = "" if processes == "every" else processes[3:-1]
    return Row(table, name, in_words(form, arguments), unquoted[0], unquoted[1], taken, unquoted[2])


def cell(text: str) -> str:
    return re.sub(r"([|<>])", r"\\\1", re.sub(r"(?<!`)\*(?!`)", r"\*", text))


def section(table: str, rows: list[Row]) -> str:
    title, about = TITLES[table]
    of_processes = table == "operation"
    columns = ["key", "takes", "unit", "otherwise"] + (["of"] if of_processes else []) + [""]
    lines = [f"## {title}", ""] + ([about, ""] if about else [])
    lines += [f"| {' | '.join(columns)} |".replace("|  |", "| |"), "|" + " --- |" * len(columns)]
    for row in rows:
        cells = [f"`{row.name}`", row.takes, row.unit, row.otherwise]
        cells += ([row.processes or "all"] if of_processes else []) + [row.about]
        lines.append("| " + " | ".join(map(cell, cells)) + " |")
    return "\n".join(lines) + "\n"


def page() -> str:
    text = TABLE.read_text(encoding="utf-8")
    rows = [read_row(line) for line in text.splitlines() if line.startswith("KEY(")]
    sections = [section(table, [row for row in rows if row.table == table]) for table in TITLES]
    if {row.table for row in rows} != set(TITLES):
        raise SystemExit(f"{TABLE}: a table has no title in {__file__}")
    return "\n".join([HEAD, *sections])


def main() -> int:
    wanted = page()
    is_current = PAGE.is_file() and PAGE.read_text(encoding="utf-8") == wanted
    if sys.argv[1:] == ["--check"]:
        if not is_current:
            print("docs/job-keys.md is not what the table makes: run tools/job_keys_table.py", file=sys.stderr)
        return 0 if is_current else 1
    PAGE.write_text(wanted, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
