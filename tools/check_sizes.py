#!/usr/bin/env python3
"""Holds functions and files against the sizes at which one sees them at once.

A function counts from the line that its name stands in to its closing brace, with the functions inside of it; braces
are matched, nothing is compiled. FOLDERS says how many lines half of a folder's functions have at most, and how many
95 of 100; none has more than MOST, and no file more than MOST_OF_FILE.

usage: check_sizes.py [--show] [ROOT]      exit 1 when anything is found, one line each: file:line: what is too long
                                           --show: the figures of each folder, and its longest functions
"""

import argparse
import ast
import re
import sys
from pathlib import Path
from typing import Callable, Iterator, NamedTuple, Optional

# A test tells its whole story in one place.
FOLDERS = {"src": (5, 20), "tests": (8, 25), "tools": (7, 20), "web/src": (6, 20), "bench": (8, 25)}
MOST = 80
MOST_OF_FILE = 450
# What may be longer, with the reason.
LONG_FUNCTIONS: dict[str, str] = {}
LONG_FILES: dict[str, str] = {}

QUOTED = r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|//[^\n]*|/\*.*?\*/'
OPAQUE_CPP = re.compile(
    r'R"(\w*)\(.*?\)\1"|(?<=[\da-f])\'(?=[\da-f])|^[ \t]*#(?:\\\n|[^\n])*|' + QUOTED, re.DOTALL | re.MULTILINE
)
OPAQUE_SCRIPT = re.compile(
    # A text with values in it, or an expression where no division can stand.
    r"`(?:\\.|\$\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}|[^`\\])*`|"
    r"(?<=[=(,:!&|?])\s*/(?![/*])(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n\[])+/[a-z]*|" + QUOTED,
    re.DOTALL,
)
HEAD_CPP = re.compile(
    r"\)(?:\s|const|noexcept|override|final|mutable|&)*(?:->[\w\s:<>,*&]+)?$|\)[^=]*:.*\}\s*$", re.DOTALL
)
HEAD_SCRIPT = re.compile(r"=>\s*$|\)\s*(?::[^{}();=]*)?$")
STATEMENT = re.compile(r"\W*(?:else\s+)?(?:if|for|while|switch|catch)\b(?!.*=>\s*$)", re.DOTALL)
SCRIPT = re.compile(r"<script[^>]*>(.*?)</script>", re.DOTALL)


class Function(NamedTuple):
    line: int
    lines: int
    head: str


class Brace(NamedTuple):
    is_function: bool
    begin: int  # of what stands before it


def blank(opaque: re.Pattern, text: str) -> str:
    """The text without what only looks like code: as long, line for line."""
    return opaque.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def measured(code: str, begin: int, end: int) -> Function:
    begin += len(code[begin:end]) - len(code[begin:end].lstrip())
    head = " ".join(code[begin:end].split("{", 1)[0].split())
    return Function(code.count("\n", 0, begin) + 1, code.count("\n", begin, end) + 1, head)


def is_value(head: str) -> bool:
    """Whether what stands before a brace goes on behind it: a member or an argument has its value there."""
    return "(" in head and not head.rstrip().endswith(")")


def braced(code: str, is_head: Callable[[str], bool]) -> Iterator[Function]:
    """The outermost functions of a language with braces; is_head: what stands before a brace begins one."""
    opened: list[Brace] = []
    begin = 0
    for found in re.finditer("[;{}]", code):
        before = code[begin : found.start()]
        if found[0] == "{":
            opened.append(Brace(is_head(before), begin))
        begin = found.end()
        if found[0] != "}" or not opened:
            continue
        last = opened.pop()
        if last.is_function and not any(brace.is_function for brace in opened):
            yield measured(code, last.begin, begin)
        elif is_value(code[last.begin : code.index("{", last.begin)]):
            begin = last.begin


def functions_of_cpp(text: str) -> Iterator[Function]:
    return braced(blank(OPAQUE_CPP, text), lambda head: bool(HEAD_CPP.search(head)))


def functions_of_script(text: str) -> Iterator[Function]:
    return braced(
        blank(OPAQUE_SCRIPT, text), lambda head: bool(HEAD_SCRIPT.search(head)) and not STATEMENT.match(head)
    )


def functions_of_page(text: str) -> Iterator[Function]:
    for part in SCRIPT.finditer(text):
        above = text.count("\n", 0, part.start(1))
        for each in functions_of_script(part[1]):
            yield each._replace(line=each.line + above)


def functions_of_python(text: str) -> Iterator[Function]:
    ahead: list[ast.AST] = [ast.parse(text)]
    while ahead:
        for node in ast.iter_child_nodes(ahead.pop()):
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
                yield Function(node.lineno, (node.end_lineno or node.lineno) - node.lineno + 1, node.name)
            else:
                ahead.append(node)


READERS: dict[str, Optional[Callable[[str], Iterator[Function]]]] = {
    ".cpp": functions_of_cpp,
    ".hpp": functions_of_cpp,
    ".py": functions_of_python,
    ".ts": functions_of_script,
    ".js": functions_of_script,
    ".mjs": functions_of_script,
    ".svelte": functions_of_page,
    ".css": None,
    ".def": None,
}


def share(sizes: list[int], of_100: int) -> int:
    """So many lines have of_100 of 100 functions at most."""
    return sorted(sizes)[max(0, -(-len(sizes) * of_100 // 100) - 1)]


def is_excused(function: Function) -> bool:
    return any(re.search(rf"(?<!\w){re.escape(name)}\(", function.head) for name in LONG_FUNCTIONS)


def read(folder: Path) -> Iterator[tuple[Path, int, list[Function]]]:
    """The files of a folder, with their lines and functions."""
    for file in sorted(folder.rglob("*")):
        if file.suffix in READERS and "node_modules" not in file.parts:
            text = file.read_text(encoding="utf-8")
            reader = READERS[file.suffix]
            yield file, text.count("\n"), list(reader(text)) if reader else []


def check_file(root: Path, file: Path, lines: int, functions: list[Function]) -> Iterator[str]:
    if lines > MOST_OF_FILE and file.relative_to(root).as_posix() not in LONG_FILES:
        yield f"{file}:1: {lines} lines, more than {MOST_OF_FILE}: there is more than one idea in it"
    for function in functions:
        if function.lines > MOST and not is_excused(function):
            yield f"{file}:{function.line}: a function of {function.lines} lines, more than {MOST}"


def check_folder(root: Path, folder: str) -> tuple[int, list[str]]:
    found, sizes = [], []
    for file, lines, functions in read(root / folder):
        found += check_file(root, file, lines, functions)
        sizes += [function.lines for function in functions]
    for of_100, most in zip((50, 95), FOLDERS[folder]):
        if sizes and share(sizes, of_100) > most:
            found.append(f"{root / folder}: of 100 functions {of_100} have to {share(sizes, of_100)} lines, not {most}")
    return len(sizes), found


def check(root: Path) -> tuple[int, list[str]]:
    """Number of functions read, and the findings."""
    folders = [check_folder(root, folder) for folder in FOLDERS]
    return sum(count for count, _ in folders), [each for _, found in folders for each in found]


def show_share(name: str, sizes: list[int]) -> None:
    print(f"{name}: {len(sizes)} functions, half to {share(sizes, 50)} lines, 95 of 100 to {share(sizes, 95)}")


def show(root: Path) -> None:
    every: list[tuple[int, str]] = []
    for folder in FOLDERS:
        here = [
            (function.lines, f"{file.relative_to(root)}:{function.line}: {function.head[:70]}")
            for file, _, functions in read(root / folder)
            for function in functions
        ]
        show_share(folder, [lines for lines, _ in here])
        every += here
    show_share("all", [lines for lines, _ in every])
    for lines, where in sorted(every, reverse=True)[:20]:
        print(f"  {lines} {where}")


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--show", action="store_true")
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parent.parent)
    options = parser.parse_args()
    if options.show:
        show(options.root)
    count, findings = check(options.root)
    for finding in findings:
        print(finding.replace(f"{options.root}/", ""), file=sys.stderr)
    if count == 0:
        print(f"{options.root} holds no functions", file=sys.stderr)
    return 1 if findings or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
