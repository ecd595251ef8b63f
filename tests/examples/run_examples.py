#!/usr/bin/env python3
"""Runs every example as its README tells the user to, and compares what comes out.

usage: run_examples.py --kerf PATH [--update] [NAME ...]

An example is a folder examples/NN_name/ with these files; each kind may also come in variants, with
an ending _VARIANT before the point:

  command        one line, as typed in the root of the repository: ./kerf run examples/..., ./kerf
                 stock, ./kerf features or ./kerf edit. Only kerf features ends in "> FILE"
  expected.json  the stable part of the summary that --summary writes, of kerf stock and kerf edit of
                 the --report, of kerf features of what it tells with --format json
  picture.svg    what --plot wrote, where the command has it (or .png)
  part.png       likewise of --picture
  pattern.svg    likewise of --pattern-plot
  printed.txt    what --dprnt wrote, where the command has it; of kerf features the tree, unless it
                 goes to a picture
  NAME.nc        what kerf edit wrote to --output NAME.nc; other commands may go on with it
  generate.py    writes the program of `command`, where a script made it
  README.md      quotes every command

docs/command-line.md has a table of how long the plain commands of kerf run take, which must be right
too. Findings of the virtual part must be those that are expected, and make the exit status 1.

--update rewrites expected files, pictures, printed texts and that table, but never accepts another ending: a
new run must reach status end without a finding, and a run that used to end in an alarm, or with
findings, must end in the same one, with as many of the same. To expect an alarm or findings, first
write {"status": "alarm", "alarm": {"code": "PS0112"}}, or {"status": "end", "counts":
{"RAPID_IN_STOCK": 1}}, into expected_VARIANT.json.

Exit status: 0 all well, 1 an example fails, 2 wrong usage.
"""

import argparse
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from stable_summary import differences, stable

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
TIMES = ROOT / "docs/command-line.md"
TIMES_HEAD = "| example | time s | without acceleration s | ratio |\n| --- | ---: | ---: | ---: |\n"

SPOKEN_OF = (".nc", ".bas", ".tch", ".json", ".svg", ".png", ".txt", ".stl", ".toml")
PICTURES = {"--plot": "picture", "--picture": "part", "--pattern-plot": "pattern"}
SUMMARIES = {"run": "--summary", "stock": "--report", "edit": "--report", "features": ""}
PICTURE_BYTES = {"run": (4_000, 450_000), "stock": (4_000, 450_000), "features": (1_000, 100_000)}
PICTURE_HEADS = {".svg": (b"<?xml", b"<svg "), ".png": b"\x89PNG\r\n\x1a\n"}
EXIT_STATUS = {"end": 0, "stopped": 0, "alarm": 1}
SECONDS = 60


class Failed(Exception):
    """An example does not do what it should; the text says what."""


@dataclass
class Result:
    """What one command left behind."""

    exit_status: int
    errors: str
    summary: dict
    pictures: dict = field(default_factory=dict)  # place in the example: file that was written
    printed: Path = None
    edited: Path = None


@dataclass
class Variant:
    """One command of an example, and the files that belong to it."""

    folder: Path
    ending: str  # "" or "_as_printed"
    words: list = field(default_factory=list)

    @property
    def command(self) -> Path:
        return self.folder / f"command{self.ending}"

    @property
    def expected(self) -> Path:
        return self.folder / f"expected{self.ending}.json"

    @property
    def printed(self) -> Path:
        return self.folder / f"printed{self.ending}.txt"

    @property
    def program(self) -> Path:
        return ROOT / self.words[2]

    @property
    def edited(self) -> Path:
        return self.folder / self.option("--output")

    @property
    def summary(self) -> str:
        return self.option(SUMMARIES[self.words[1]])

    @property
    def tells_features(self) -> bool:
        return self.words[1] == "features"

    def picture(self, kind: str, suffix: str) -> Path:
        return self.folder / f"{kind}{self.ending}{suffix}"

    def option(self, name: str) -> str:
        """The value of an option of the command, "" without it."""
        return self.words[self.words.index(name) + 1] if name in self.words else ""

    def read(self, readme: str) -> None:
        text = self.command.read_text()
        if text.count("\n") != 1 or not text.endswith("\n"):
            raise Failed(f"{self.command.name}: must be one line")
        self.words = shlex.split(text)
        if self.words[0] != "./kerf" or self.words[1] not in SUMMARIES:
            raise Failed(f"{self.command.name}: must begin with ./kerf run, stock, features or edit")
        if self.program.parent != self.folder or not self.program.is_file():
            raise Failed(f"{self.command.name}: {self.words[2]} is no program of this example")
        if not self.tells_features and not self.summary:
            raise Failed(f"{self.command.name}: needs {SUMMARIES[self.words[1]]}")
        if text.strip() not in readme:
            raise Failed(f"README.md does not quote {self.command.name}")


def variants_of(folder: Path) -> list:
    """All commands of an example, read, the plain one first."""
    readme = folder / "README.md"
    if not readme.is_file() or not (folder / "command").is_file():
        raise Failed("needs README.md and command")
    found = [Variant(folder, path.name[len("command"):]) for path in folder.glob("command*")]
    found.sort(key=lambda variant: variant.ending)
    for variant in found:
        variant.read(readme.read_text())
    if not any(found[0].option(option) for option in ("--plot", "--picture", ">")):
        raise Failed("command: needs a picture: --plot, --picture or >")
    return found


def check_no_orphans(folder: Path, variants: list) -> None:
    """Programs, tools, expectations and pictures that no command speaks of."""
    known = {variant.program.name for variant in variants}
    for variant in variants:
        known |= {Path(word).name for word in variant.words if (ROOT / word).parent == folder}
        known |= {variant.expected.name, variant.printed.name, variant.edited.name}
        known |= {variant.picture(kind, suffix).name
                  for kind in PICTURES.values() for suffix in PICTURE_HEADS}
    for path in sorted(folder.iterdir()):
        if path.suffix in SPOKEN_OF and path.name not in known:
            raise Failed(f"no command speaks of {path.name}")


def check_generator(folder: Path, variants: list) -> None:
    """generate.py must write the program of `command`, byte for byte."""
    generator = folder / "generate.py"
    if not generator.is_file():
        return
    made = subprocess.run([sys.executable, str(generator)], capture_output=True, timeout=SECONDS)
    if made.returncode != 0 or made.stdout != variants[0].program.read_bytes():
        raise Failed(f"generate.py does not write {variants[0].program.name}")


def call(variant: Variant, kerf: Path, place: Path, words: list) -> subprocess.CompletedProcess:
    """Runs kerf in `place`, a copy of the repository that holds only the examples."""
    return subprocess.run([str(kerf), *words], cwd=place, capture_output=True, text=True,
                          timeout=SECONDS)


def run(variant: Variant, kerf: Path, place: Path) -> Result:
    if variant.tells_features:
        return run_features(variant, kerf, place)
    done = call(variant, kerf, place, variant.words[1:])
    summary = place / variant.summary
    if not summary.is_file():
        raise Failed(f"{variant.command.name}: exit status {done.returncode} and no summary\n"
                     + done.stderr.rstrip())
    result = Result(done.returncode, done.stderr, stable(json.loads(summary.read_text())))
    for option, kind in PICTURES.items():
        if variant.option(option):
            drawn = place / variant.option(option)
            result.pictures[variant.picture(kind, drawn.suffix)] = drawn
    if variant.option("--dprnt"):
        result.printed = place / variant.option("--dprnt")
    if variant.option("--output"):
        result.edited = place / variant.option("--output")
    return result


def run_features(variant: Variant, kerf: Path, place: Path) -> Result:
    """What is told goes where the command says, and once more as JSON into the expectation."""
    target = variant.option(">")
    words = variant.words[1:-2] if target else variant.words[1:]
    told = call(variant, kerf, place, words)
    written = place / (target or "printed.txt")
    written.write_text(told.stdout)
    as_json = call(variant, kerf, place, [*without_format(words), "--format", "json"])
    if told.returncode != as_json.returncode or not as_json.stdout:
        raise Failed(f"{variant.command.name}: exit status {told.returncode}, "
                     f"as JSON {as_json.returncode}\n" + told.stderr.rstrip())
    result = Result(told.returncode, told.stderr, stable(json.loads(as_json.stdout)))
    if target:
        result.pictures[variant.picture("picture", written.suffix)] = written
    else:
        result.printed = written
    return result


def without_format(words: list) -> list:
    if "--format" not in words:
        return words
    at = words.index("--format")
    return words[:at] + words[at + 2:]


def ending(summary: dict) -> str:
    alarm = summary.get("alarm")
    found = [f"{count} {code}" for code, count in (summary.get("counts") or {}).items()]
    return (summary["status"] + (f" {alarm['code']}" if alarm else "")
            + (" with " + ", ".join(found) if found else ""))


def wanted_exit_status(variant: Variant, summary: dict) -> int:
    fails_on = variant.option("--fail-on") or "warning"
    severities = [finding["severity"] for finding in summary.get("findings") or []]
    fails = fails_on != "never" and (fails_on == "warning" and severities or "error" in severities)
    return 1 if fails else EXIT_STATUS.get(summary["status"])


def check_ending(variant: Variant, result: Result) -> None:
    """Refuses a run that failed, or that does not end as it did before."""
    before = {"status": "end"}
    if variant.expected.is_file():
        before = json.loads(variant.expected.read_text())
    if ending(result.summary) != ending(before):
        raise Failed(f"{variant.command.name}: must reach {ending(before)}, "
                     f"reached {ending(result.summary)}\n" + result.errors.rstrip())
    if result.exit_status != wanted_exit_status(variant, result.summary):
        raise Failed(f"{variant.command.name}: exit status {result.exit_status} "
                     f"with status {result.summary['status']}")


def check_outputs(variant: Variant, result: Result) -> None:
    """Pictures are pictures of decent size, and what was asked for is there."""
    for drawn in result.pictures.values():
        if not drawn.is_file():
            raise Failed(f"{variant.command.name}: no picture was written to {drawn.name}")
        data = drawn.read_bytes()
        if not data.startswith(PICTURE_HEADS[drawn.suffix]):
            raise Failed(f"{drawn.name}: is not {drawn.suffix}")
        least, most = PICTURE_BYTES[variant.words[1]]
        if not least <= len(data) <= most:
            raise Failed(f"{drawn.name}: {len(data)} bytes, not within {least} to {most}")
    if result.printed is not None and not result.printed.is_file():
        raise Failed(f"{variant.command.name}: nothing was printed to {result.printed.name}")
    if result.edited is not None and not result.edited.is_file():
        raise Failed(f"{variant.command.name}: no program was written to {result.edited.name}")


def compare(variant: Variant, result: Result) -> None:
    if not variant.expected.is_file():
        raise Failed(f"{variant.expected.name} is missing; --update writes it")
    found = differences(json.loads(variant.expected.read_text()), result.summary)
    if result.printed is not None:
        before = variant.printed.read_text() if variant.printed.is_file() else ""
        if result.printed.read_text() != before:
            found.append(f"{variant.printed.name}: expected\n{before}got\n"
                         + result.printed.read_text().rstrip())
    if result.edited is not None and (not variant.edited.is_file()
                                      or variant.edited.read_bytes() != result.edited.read_bytes()):
        found.append(f"{variant.edited.name} is not what was written; --update writes it")
    found += [f"{picture.name} is {state}; --update writes it"
              for picture, drawn in result.pictures.items()
              if (state := state_of_picture(picture, drawn))]
    if found:
        raise Failed(f"{variant.command.name}: " + "\n".join(found))


def state_of_picture(picture: Path, drawn: Path) -> str:
    """"" if it may stay. Pixels are those of one processor, lines and letters are not."""
    if not picture.is_file():
        return "missing"
    is_lines = picture.suffix == ".svg" and b"data:image/png" not in drawn.read_bytes()
    return "old" if is_lines and picture.read_bytes() != drawn.read_bytes() else ""


def update(variant: Variant, result: Result) -> None:
    lines = [f"  {json.dumps(key)}: {json.dumps(value)}" for key, value in result.summary.items()]
    replace(variant.expected, ("{\n" + ",\n".join(lines) + "\n}\n").encode())
    if result.printed is not None:
        replace(variant.printed, result.printed.read_bytes())
    if result.edited is not None:
        replace(variant.edited, result.edited.read_bytes())
    for picture, drawn in result.pictures.items():
        replace(picture, drawn.read_bytes())


def replace(path: Path, data: bytes) -> None:
    if path.is_file() and path.read_bytes() == data:
        return
    part = path.with_name(path.name + ".part")
    part.write_bytes(data)
    os.replace(part, path)
    print(f"     wrote {path.relative_to(ROOT)}")


def times_row(name: str, summary: dict) -> str:
    time_s, feed_s = summary["time_s"], summary["time_feed_s"]
    return f"| {name} | {time_s:.1f} | {feed_s:.1f} | x {feed_s / time_s:.2f} |\n"


def check_times(rows: list, rewrite: bool) -> None:
    """The table of times in the document is the one of these runs."""
    document = TIMES.read_text()
    before, head, behind = document.partition(TIMES_HEAD)
    if not head:
        raise Failed(f"no table begins with {TIMES_HEAD.splitlines()[0]}")
    rest = re.sub(r"\A(\|.*\n)*", "", behind)
    wanted = before + head + "".join(rows) + rest
    if rewrite:
        replace(TIMES, wanted.encode())
    elif document != wanted:
        raise Failed("the table of times should be\n" + "".join(rows) + "--update writes it")


def try_example(folder: Path, kerf: Path, place: Path, rewrite: bool) -> list:
    """The summaries of a good example, that of the plain command first. With `rewrite`, all of its
    runs must be good before one file is rewritten."""
    variants = variants_of(folder)
    check_no_orphans(folder, variants)
    check_generator(folder, variants)
    results = [run(variant, kerf, place) for variant in variants]
    for variant, result in zip(variants, results):
        check_ending(variant, result)
        check_outputs(variant, result)
        if not rewrite:
            compare(variant, result)
    if rewrite:
        for variant, result in zip(variants, results):
            update(variant, result)
    return [result.summary for result in results]


def main() -> int:
    parser = argparse.ArgumentParser(description="runs the examples and compares what comes out")
    parser.add_argument("--kerf", type=Path, required=True, help="the program kerf")
    parser.add_argument("--update", action="store_true", help="rewrites what is expected")
    parser.add_argument("names", nargs="*", metavar="NAME", help="only these examples")
    options = parser.parse_args()
    if not os.access(options.kerf, os.X_OK):
        parser.error(f"{options.kerf} is no program")
    folders = sorted(path for path in EXAMPLES.glob("*/") if path.is_dir())
    unknown = set(options.names) - {folder.name for folder in folders}
    if unknown:
        parser.error("no example " + ", ".join(sorted(unknown)))
    if options.names:
        folders = [folder for folder in folders if folder.name in options.names]
    if not folders:
        print("FAIL there are no examples in examples/")
        return 1

    failures = commands = 0
    times = []
    with tempfile.TemporaryDirectory() as scratch:
        for folder in folders:
            place = Path(scratch) / folder.name  # a root of its own: outputs never meet
            shutil.copytree(folder, place / "examples" / folder.name)
            try:
                summaries = try_example(folder, options.kerf.resolve(), place, options.update)
                count = len(summaries)
                commands += count
                if "time_feed_s" in summaries[0]:
                    times.append(times_row(folder.name, summaries[0]))
                print(f"ok   {folder.name}: {count} run{'s' if count > 1 else ''}")
            except (Failed, subprocess.TimeoutExpired) as problem:
                failures += 1
                print(f"FAIL {folder.name}: {problem}".replace("\n", "\n     "))
            except (ValueError, LookupError) as problem:  # a command or an expectation is misspelt
                failures += 1
                print(f"FAIL {folder.name}: {type(problem).__name__}: {problem}")
    try:
        if not options.names and not failures:
            check_times(times, options.update)
    except Failed as problem:
        failures += 1
        print(f"FAIL {TIMES.relative_to(ROOT)}: {problem}".replace("\n", "\n     "))
    print(f"{len(folders)} examples, {failures} failed" if failures
          else f"{len(folders)} examples, {commands} runs, all as expected")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
