#!/usr/bin/env python3
"""Holds the #include lines of src/ against the rooms and what each may use.

A room may include itself and what ROOMS lets it use, with all that this uses in turn; only rooms that its own
kerf_room(… LINKS …) names, and nothing of another room's internal/ folder. The elementary functions of the C
library stay out of all rooms: math has them, with the same bits everywhere. Text of numbers is read and written
by base/decimal alone, or by fmt: both know no locale. Code numbers stand in the tables of control/gcode/codes and in
no switch. A folder holds at most MOST_CLASSES classes, a source and its header counted once. The members of a class
are defined in one source: where they would fill several, its parts want to be objects. A room has a README.md of at
most MOST_README_LINES lines.

usage: check_rooms.py [ROOT]      exit 1 when anything is found, one line each: file:line: what is wrong
"""

import re
import sys
from pathlib import Path
from typing import Iterable, Iterator, NamedTuple, Optional

# Each room below src/, top to bottom, with those that it may use; what they use is allowed as well. A room inside of
# another one's folder is not part of that: control/gcode is what drives control/gcode/path.
ROOMS = {
    "math": [],
    "base": [],
    "geometry": ["math", "base"],
    "geometry/contour": ["geometry"],
    "geometry/mesh": ["geometry"],
    "drawing": ["geometry/contour"],
    "drawing/dxf": ["drawing"],
    "drawing/trace": ["drawing"],
    "drawing/contours": ["drawing"],
    "drawing/image": ["drawing"],
    "drawing/font": ["drawing"],
    "drawing/svg": ["drawing/image"],
    "motion": ["geometry"],
    "stock/tool": ["geometry/contour"],
    "stock/sweep": ["stock/tool"],
    "stock/cutting": ["stock/sweep", "motion", "geometry/mesh"],
    "stock/field": ["stock/sweep"],
    "stock/dexel": ["stock/sweep", "geometry/mesh"],
    "stock/turned": ["stock/sweep"],
    "stock/turnmill": ["stock/turned", "stock/dexel"],
    "stock/sheet": ["stock/cutting", "geometry/contour"],
    "stock/surface": ["stock/field", "stock/dexel", "stock/turned", "stock/sheet", "geometry/contour", "geometry/mesh"],
    "stock/saved": ["stock/surface", "stock/cutting"],
    "stock/replay": ["stock/field", "stock/dexel", "stock/turned", "stock/sheet"],
    "stock/compare": ["stock/field", "stock/dexel", "stock/turned", "stock/sheet", "geometry/mesh"],
    "features/path": ["stock/tool", "motion"],
    "features/tree": ["features/path"],
    "features/literal": ["features/tree"],
    "features/milling": ["features/literal"],
    "features/turning": ["features/tree", "stock/turned"],
    "features/edit": ["features/tree"],
    "features": ["features/milling", "features/turning"],
    "features/edit": ["features/tree"],
    "lang/vm": ["base"],
    "lang/gcode": ["lang/vm", "math"],
    "lang/basic": ["lang/vm", "math"],
    "lang/teach": ["lang/vm", "geometry"],
    "lang/records": ["lang/vm", "motion"],
    "control/core": ["motion", "lang/vm"],
    "control/gcode/codes": ["control/core", "lang/gcode"],
    "control/gcode/words": ["control/gcode/codes"],
    "control/gcode/frames": ["control/core"],
    "control/gcode/path": ["control/gcode/frames", "control/gcode/words"],
    "control/gcode/acts": ["control/gcode/path"],
    "control/gcode/cycles": ["control/gcode/acts"],
    "control/gcode/macro": ["control/gcode/acts"],
    "control/gcode": ["control/gcode/cycles", "control/gcode/macro"],
    "control/laser": ["control/core", "lang/basic"],
    "control/teach": ["control/core", "lang/teach"],
    "control/plan": ["control/core"],
    "control/records": ["control/core", "lang/records"],
    "planner": ["motion"],
    "kinematics": ["base", "geometry"],
    "process": ["drawing/image", "motion", "kinematics"],
    "drive": ["base", "geometry"],
    "drive/pattern": ["drive"],
    "machine/definition/tools": ["stock/tool"],
    "machine/definition": ["machine/definition/tools", "geometry/mesh", "control/core", "planner", "kinematics", "drive/pattern", "stock/cutting"],
    "machine/dialect": ["control/gcode", "control/laser", "control/teach", "control/plan", "control/records", "machine/definition"],
    "machine/run": ["machine/dialect"],
    "machine/panel": ["machine/run"],
    "output/writing": ["motion", "machine/definition"],
    "output/drawings": ["output/writing", "process"],
    "output/picture/drawing": ["output/writing"],
    "output/picture/solid": ["output/picture/drawing", "geometry/mesh"],
    "output/picture": ["output/picture/drawing"],
    "output/programs": ["output/writing", "lang/teach"],
    "output/records": ["output/picture", "output/programs"],
    "output/reports": ["output/writing", "stock/compare"],
    "output/features": ["output/reports", "features"],
    "output/solid": ["stock/surface"],
    "output/part": ["output/picture/solid", "output/reports", "output/solid"],
    "engraver": ["machine/run", "output/picture", "output/reports"],
    "features/rewrite": ["features/tree"],
    "features/merge": ["features/rewrite"],
    "features/plan": ["features/edit", "features/rewrite"],
    "job": ["machine/run", "features/edit", "features/merge", "features/plan", "output/features", "output/records", "output/reports", "output/part", "output/solid", "stock/field", "stock/dexel", "stock/turned", "stock/turnmill", "stock/sheet", "stock/saved"],
    "job/drawing": ["output/drawings", "drawing/dxf", "drawing/svg", "drawing/trace", "drawing/contours", "drawing/font", "machine/run"],
    "job/live": ["job", "stock/replay"],
    "training": ["job", "stock/compare"],
    "face/server/protocol": ["machine/panel", "output/writing", "job/live"],
    "face/server/store": ["face/server/protocol"],
    "face/server/hub": ["face/server/store", "training"],
    "face/server/transport": ["face/server/hub"],
    "face/cli": ["engraver", "job", "machine/panel", "job/drawing"],
    "face": ["face/cli", "face/server/transport"],
}

MOST_CLASSES = 30
MOST_README_LINES = 10
SOURCE_SUFFIXES = {".cpp", ".hpp", ".def", ".inc"}
# Each library rounds them in its own way, and one may choose by the processor. What is exact everywhere, as sqrt, is not here.
ELEMENTARY = (
    r"(a?(?:sin|cos|tan)h?|atan2|exp2?|expm1|log(?:2|10|1p|b)?|pow|hypot|cbrt|[tl]gamma|erfc?|lerp)[fl]?\b"
)
FROM_LIBRARY = re.compile(r"(?:\bstd|(?<![\w:>]))::" + ELEMENTARY)
UNQUALIFIED = re.compile(r"(?:(\w+) )?(?<![\w:.>&*])" + ELEMENTARY + r"\(")
# What goes by the locale, by the C library's rounding, or by how long its long double is; and what should be in one place.
BORDER = "base/decimal.cpp"
NUMBER_TEXT = re.compile(
    r"\b(?:strto(?:[dfl]|ld|ll|ull?|[iu]max)|ato(?:[fil]|ll)|sto(?:[dfil]|ld|ll|ull?)|(?:from|to)_chars"
    r"|[vfsw]*scanf|v?s[nw]?printf|setlocale|imbue)\s*\("
    r"|#\s*include\s*<(?:sstream|strstream|iomanip|iostream|ostream|istream|locale|clocale|locale\.h)>"
    r"|\w*printf\s*\((?:[^;](?!printf))*?%[-+ #0-9.*]*[hlLjzt]*[aAeEfFgG]"
    r"|\{[^{}\"]*:[^{}\"]*L[a-zA-Z]?\}"
)
# A member as it is defined: at the beginning of a line, its class in front of it.
MEMBER = re.compile(r"^(?=\w)[^;=(\"'\n]*?((?:\b[A-Z]\w*(?:<[^()]*?>)?::)+)(?:~?\w+|operator[^(]+)\(", re.MULTILINE)
CODE_NUMBER = re.compile(r"\bcase\s+[GM]?\d+\s*:")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
KERF_ROOM = re.compile(r"\bkerf_room\s*\(([^)]*)\)")


class Include(NamedTuple):
    line: int
    path: str
    quoted: bool


class Links(NamedTuple):
    """What one kerf_room(…) call says: where it stands and which rooms it names."""

    file: Path
    line: int
    rooms: list[str]


def room_of(path: str) -> Optional[str]:
    """The room that a path below src/ lies in: of nested ones the inner one."""
    inside = [room for room in ROOMS if path.startswith(room + "/")]
    return max(inside, key=len, default=None)


def target_of(room: str) -> str:
    return "kerf_" + room.replace("/", "_")


ROOM_OF_TARGET = {target_of(room): room for room in ROOMS}


def reach_of(room: str) -> set[str]:
    """The rooms that a room may use, the ones behind them included."""
    reach: set[str] = set()
    ahead = list(ROOMS[room])
    while ahead:
        used = ahead.pop()
        if used not in reach:
            reach.add(used)
            ahead += ROOMS[used]
    return reach


REACH = {room: reach_of(room) for room in ROOMS}


def objection(user: str, used: str) -> Optional[str]:
    """Why the room `user` may not know the room `used`; None when it may."""
    if user == used or used in REACH[user]:
        return None
    if user in REACH[used]:
        return f"{used} stands below {user}"
    return f"{used} is not among what {user} uses"


def includes_of(file: Path) -> Iterator[Include]:
    for number, text in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
        match = INCLUDE.match(text)
        if match:
            yield Include(number, match[1] or match[2], match[1] is not None)


def linked_targets(arguments: str) -> list[str]:
    words = arguments.split()
    after = words[words.index("LINKS") + 1 :] if "LINKS" in words else []
    return [word for word in after if word not in ("SOURCES", "EXCEPT")]


def read_links(src: Path) -> dict[str, Links]:
    """The LINKS of every room: its folder's kerf_room(…) call."""
    links = {}
    for file in sorted(src.rglob("CMakeLists.txt")):
        text = re.sub(r"#[^\n]*", "", file.read_text(encoding="utf-8"))
        for call in KERF_ROOM.finditer(text):
            room = file.parent.relative_to(src).as_posix()
            if room not in ROOMS:
                raise SystemExit(f"{file}: {room} is not among the ROOMS of {__file__}")
            named = [ROOM_OF_TARGET[t] for t in linked_targets(call[1]) if t in ROOM_OF_TARGET]
            links[room] = Links(file, text.count("\n", 0, call.start()) + 1, named)
    return links


def check_links(links: dict[str, Links]) -> Iterator[str]:
    for room, entry in links.items():
        for used in entry.rooms:
            reason = objection(room, used)
            if reason:
                yield f"{entry.file}:{entry.line}: {room} may not link {used}: {reason}"


def check_include(room: str, include: Include, links: dict[str, Links]) -> Optional[str]:
    used = room_of(include.path)
    if used is None:
        if include.quoted:
            return f'"{include.path}" is in no room; write the path from src/: "room/file.hpp"'
        return None
    if used == room:
        return None
    reason = objection(room, used)
    if reason:
        return f'{room} may not include "{include.path}": {reason}'
    if "internal" in include.path[len(used) :].split("/"):
        return f'{room} may not include "{include.path}": internal/ is for {used} alone'
    target = target_of(used)
    if room not in links:
        return f'{room} includes "{include.path}" but has no kerf_room(… LINKS {target})'
    if used not in links[room].rooms:
        where = f"{links[room].file}:{links[room].line}"
        return f'{room} includes "{include.path}" but does not link {target} ({where})'
    return None


def elementary_calls(file: Path) -> Iterator[str]:
    """Lines that call such a function of the C library; unqualified ones where nothing of math is meant."""
    text = file.read_text(encoding="utf-8")
    for number, line in enumerate(text.splitlines(), start=1):
        code = line.split("//", 1)[0]
        calls = [call[0] for call in FROM_LIBRARY.finditer(code)]
        for call in UNQUALIFIED.finditer(code):
            is_declared = call[1] not in (None, "return") or f"using math::{call[2]};" in text
            calls += [] if is_declared else [call[0]]
        for call in calls:
            yield f"{file}:{number}: {call} differs by library and processor; math/math.hpp has it"


def without_comments(text: str) -> str:
    """The same lines, each up to its //."""
    return "\n".join(line.split("//", 1)[0] for line in text.splitlines())


def number_texts(file: Path) -> Iterator[str]:
    """Places that read or write text of numbers in another way than base/decimal."""
    code = without_comments(file.read_text(encoding="utf-8"))
    for found in NUMBER_TEXT.finditer(code):
        line = code.count("\n", 0, found.start()) + 1
        what = " ".join(found[0].split()).rstrip("( ")
        yield f"{file}:{line}: {what} may differ by locale and library; base/decimal.hpp reads and writes numbers"


def code_numbers(file: Path) -> Iterator[str]:
    """Cases of a switch that are numbers: in a control they are codes."""
    for number, line in enumerate(without_comments(file.read_text(encoding="utf-8")).splitlines(), start=1):
        for found in CODE_NUMBER.finditer(line):
            yield f"{file}:{number}: {found[0]} is a number; a code has a row in control/gcode/codes, and a meaning"


def full_folders(files: list[Path]) -> Iterator[str]:
    folders: dict[Path, set[str]] = {}
    for file in files:
        folders.setdefault(file.parent, set()).add(file.stem)
    for folder, classes in sorted(folders.items()):
        if len(classes) > MOST_CLASSES:
            yield f"{folder}:1: {len(classes)} classes in a folder, more than {MOST_CLASSES}: nobody finds one"


def untold_rooms(src: Path, rooms: Iterable[str]) -> Iterator[str]:
    """Rooms that no README.md tells of, or one that nobody reads to its end."""
    for room in rooms:
        readme = src / room / "README.md"
        count = len(readme.read_text(encoding="utf-8").splitlines()) if readme.exists() else 0
        if count == 0:
            yield f"{readme}:1: {room} has no README.md: what it is, what it may use, where to begin"
        elif count > MOST_README_LINES:
            yield f"{readme}:{count}: {count} lines, more than {MOST_README_LINES}: a stranger wants to begin"


def classes_of(file: Path) -> Iterator[tuple[str, int]]:
    """The classes whose members a source defines, each with the line of the first."""
    seen = set()
    code = without_comments(file.read_text(encoding="utf-8"))
    for found in MEMBER.finditer(code):
        name = re.sub(r"<.*?>", "", found[1]).removesuffix("::")
        if name not in seen:
            seen.add(name)
            yield name, code.count("\n", 0, found.start()) + 1


def scattered_classes(src: Path, files: list[Path]) -> Iterator[str]:
    """Classes whose members stand in more than one source of a room."""
    homes: dict[tuple[Optional[str], str], Path] = {}
    for file in (f for f in files if f.suffix == ".cpp"):
        for name, line in classes_of(file):
            home = homes.setdefault((room_of(file.relative_to(src).as_posix()), name), file)
            if home != file:
                yield f"{file}:{line}: {name} has members in {home.name}, too; its parts want to be objects"


def check_file(src: Path, file: Path, links: dict[str, Links]) -> Iterator[str]:
    room = room_of(file.relative_to(src).as_posix())
    if room is None:
        yield f"{file}:1: this folder is no room; rooms stand in the ROOMS of {__file__}"
        return
    for include in includes_of(file):
        finding = check_include(room, include, links)
        if finding:
            yield f"{file}:{include.line}: {finding}"
    if room != "math":
        yield from elementary_calls(file)
    if file != src / BORDER:
        yield from number_texts(file)
    if room.startswith("control/"):
        yield from code_numbers(file)


def check(root: Path) -> tuple[int, list[str]]:
    """Number of files read, and the findings."""
    src = root / "src"
    links = read_links(src)
    files = sorted(f for f in src.rglob("*") if f.suffix in SOURCE_SUFFIXES)
    findings = [*check_links(links), *full_folders(files), *scattered_classes(src, files), *untold_rooms(src, links)]
    for file in files:
        findings += check_file(src, file, links)
    return len(files), findings


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    count, findings = check(root)
    for finding in findings:
        print(finding.replace(f"{root}/", ""), file=sys.stderr)
    if count == 0:
        print(f"{root}/src holds no sources", file=sys.stderr)
    return 1 if findings or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
