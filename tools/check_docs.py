#!/usr/bin/env python3
"""Holds the Markdown files against what they speak of.

- a relative link leads to a file, and its #fragment to a heading of that file
- a path in backquotes, with a folder of ours in front or a suffix of ours behind, exists
- a function in backquotes, name() or Class::name(), and its class exist in src/ or tests/
- a rule that code or tests cite (LEX-9, ARC-5) stands in docs/dialect/
- docs/parameters.md has a row for each parameter of the control, docs/machine-file.md one for each key of a machine

usage: check_docs.py [ROOT]      exit 1 when anything is found, one line each: file:line: what is wrong
"""

import re
import subprocess
import sys
from pathlib import Path
from typing import Iterator

LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\s]+)`")
OUR_PATH = re.compile(r"(?:src|tests|tools|docs|examples|machines|bench|cmake)/[\w./-]+")
OUR_SOURCE = re.compile(r"[\w./-]+\.(?:cpp|hpp|def)")
FUNCTION = re.compile(r"((?:\w+::)*)(\w+)\(.*\)")
RULE = re.compile(
    r"\b(?:LEX|NUM|VAR|NUL|EXP|CTL|CALL|M99|M198|NEST|ARG|CODE|OUT|G10|G|ARC|WCS|TLC|TRF|REF|CRC|CYC)-\d+\b"
)
RULE_RANGE = re.compile(r"\*\*([A-Z]+)-(\d+)\*\* to \*\*\1-(\d+)\*\*")
PARAMETER_ROW = re.compile(r'^    \{"([^"]+)", "([^"]*)", &Parameters::', re.MULTILINE)
MACHINE_ROW = re.compile(r'^    \{"(\w+)", "(\w+)",', re.MULTILINE)


def tracked(root: Path, *patterns: str) -> list[Path]:
    command = ["git", "-c", f"safe.directory={root}", "ls-files", "-z", "--", *patterns]
    names = subprocess.run(command, cwd=root, check=True, capture_output=True, text=True).stdout
    return [root / name for name in names.split("\0") if name and (root / name).is_file()]


def lines_of(file: Path) -> Iterator[tuple[int, str]]:
    """The lines outside of code blocks."""
    inside = False
    for number, text in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
        if text.startswith("```"):
            inside = not inside
        elif not inside:
            yield number, text


def anchors(file: Path) -> set[str]:
    """The fragments that headings make, as code hosts form them."""
    found = set()
    for _, text in lines_of(file):
        if text.startswith("#") and text.lstrip("#").startswith(" "):
            heading = text.lstrip("#").strip().replace("`", "").lower()
            found.add(re.sub(r"[^\w\- ]", "", heading).replace(" ", "-"))
    return found


def broken_link(file: Path, target: str) -> bool:
    if re.match(r"[a-z]+:", target):
        return False
    path, _, fragment = target.partition("#")
    to = file.parent / path if path else file
    return not to.exists() or bool(fragment and to.is_file() and fragment not in anchors(to))


def missing_path(root: Path, word: str, names: set[str]) -> bool:
    if any(c in word for c in "*…<>{}$"):
        return False
    if OUR_PATH.fullmatch(word):
        return not (root / word).exists()
    if OUR_SOURCE.fullmatch(word):
        return not any(name == word or name.endswith("/" + word) for name in names)
    return False


def missing_function(word: str, identifiers: set[str]) -> bool:
    match = FUNCTION.fullmatch(word)
    if not match or "[" in word:
        return False
    parts = [part for part in match[1].split("::") if part] + [match[2]]
    return any(part not in identifiers for part in parts)


def check_markdown(root: Path, file: Path, names: set[str], identifiers: set[str]) -> Iterator[str]:
    for number, text in lines_of(file):
        for target in LINK.findall(text):
            if broken_link(file, target):
                yield f"{file}:{number}: the link {target} leads nowhere"
        for word in CODE.findall(text):
            if missing_path(root, word, names) or missing_function(word, identifiers):
                yield f"{file}:{number}: there is no {word}"


def identifiers_of(root: Path) -> set[str]:
    words: set[str] = set()
    for file in tracked(root, "src", "tests/*pp", "tools", "cmake", "*CMakeLists.txt"):
        words |= set(re.findall(r"\w+", file.read_bytes().decode("utf-8", errors="replace")))
    return words


def documented_rules(root: Path) -> set[str]:
    text = "".join(file.read_text(encoding="utf-8") for file in sorted((root / "docs/dialect").glob("*.md")))
    rules = set(re.findall(rf"\*\*({RULE.pattern})\*\*", text))
    for family, first, last in RULE_RANGE.findall(text):
        rules |= {f"{family}-{n}" for n in range(int(first), int(last) + 1)}
    return rules


def check_rules(root: Path) -> Iterator[str]:
    rules = documented_rules(root)
    for file in tracked(root, "src", "tests", "docs/*.md", ":!tests/fuzz/*_corpus/*"):
        text = file.read_bytes().decode("utf-8", errors="replace")
        for number, line in enumerate(text.split("\n"), start=1):
            for rule in RULE.findall(line):
                if rule not in rules:
                    yield f"{file}:{number}: {rule} does not stand in docs/dialect/"


def check_parameters(root: Path) -> Iterator[str]:
    document = root / "docs/parameters.md"
    text = document.read_text(encoding="utf-8")
    for key, number in PARAMETER_ROW.findall((root / "src/control/core/parameters.cpp").read_text(encoding="utf-8")):
        row = next((line for line in text.splitlines() if line.startswith("| ") and f"`{key}`" in line), None)
        if row is None or number not in row:
            yield f"{document}:1: no row for {key} {number}"


def check_machine_keys(root: Path) -> Iterator[str]:
    document = root / "docs/machine-file.md"
    rows = document.read_text(encoding="utf-8").splitlines()
    source = root / "src/machine/definition/internal/machine_keys.cpp"
    for table, key in MACHINE_ROW.findall(source.read_text(encoding="utf-8")):
        if not any(row.startswith(f"| {table} | `{key}` |") for row in rows):
            yield f"{document}:1: no row for {table} {key}"


def main() -> int:
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    names = {file.relative_to(root).as_posix() for file in tracked(root)}
    identifiers = identifiers_of(root)
    findings = list(check_rules(root)) + list(check_parameters(root)) + list(check_machine_keys(root))
    for file in tracked(root, "*.md"):
        findings += check_markdown(root, file, names, identifiers)
    for finding in findings:
        print(finding.replace(f"{root}/", ""), file=sys.stderr)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
