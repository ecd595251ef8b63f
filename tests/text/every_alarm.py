#!/usr/bin/env python3
"""Every alarm in the table of codes is raised somewhere in the sources and by a test program.

usage: every_alarm.py    Exit status 1 and one line for each that is not.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CODE = re.compile(r'^CODE\((\w+), "([^"]+)"', re.M)


def all_text(folder, *patterns):
    files = sorted(path for pattern in patterns for path in (ROOT / folder).rglob(pattern))
    return "\n".join(path.read_text(encoding="latin-1") for path in files)


def main():
    sources = all_text("src", "*.cpp", "*.hpp")
    programs = all_text("tests/text", "*.nc", "*.bas")
    commands = all_text("tests/cli", "*.py") + all_text("tests/live", "*.cpp")
    codes = CODE.findall((ROOT / "src/base/diagnostic_codes.def").read_text(encoding="utf-8"))
    problems = []
    for name, number in codes:
        if not re.search(rf"Code::{name}\b", sources):
            problems.append(f"{number} ({name}) is raised nowhere")
        raised = re.search(rf"\((expect|finally) (alarm|warning) {number}\b", programs) or \
            re.search(rf'(alarm\(|code, ).*"{number}"', commands)
        if re.match(r"(PS|OT|MC|LB|LW)\d", number) and not raised:
            problems.append(f"{number} ({name}) has no test")
    print("\n".join(problems) or f"{len(codes)} codes, all raised, all alarms tested")
    return 1 if problems or not codes else 0


if __name__ == "__main__":
    sys.exit(main())
