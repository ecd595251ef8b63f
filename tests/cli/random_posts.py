#!/usr/bin/env python3
"""Random programs, posted and read by two readers that stand anywhere when they begin: Kerf itself and
LinuxCNC's rs274. Both must cut what the program cut.

usage: random_posts.py --kerf PATH [--programs N] [--seed S] [--jobs J] [--machine NAME] [--keep FOLDER]

Every program has a seed of its own, S:0, S:1, …; the one of a failure is printed. A program that ends in
an alarm is none: another one takes its place. Exit status: 0 all passed, 1 otherwise.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is left behind in the sources

from harness import Failed, Skipped, check
from posted_path import KERF_MM, RS274_MM, Comparison, Rs274, of_records
from random_programs import BOXES, LANGUAGES, MILLS, TOOLS, Program, words

TRIES = 60  # at a program without an alarm


class Case:
    def __init__(self, kerf, seed, machine, folder):
        self.kerf, self.folder, self.machine = kerf, Path(folder), machine
        self.random = random.Random(seed)
        self.laser = machine.startswith("laser")

    def run(self, *arguments):
        result = subprocess.run([self.kerf, "run", *arguments, "--machine", self.machine], cwd=self.folder,
                                capture_output=True, text=True, timeout=120, check=False)
        check(result.returncode in (0, 1), f"kerf ends with {result.returncode}: {result.stderr[:300]}")
        return result

    def start(self):
        """Where the machine stands."""
        (self.folder / "none.nc").write_text("O1\nM30\n")
        self.run("none.nc", "--summary", "none.json")
        return json.loads((self.folder / "none.json").read_text())["position"]["machine"]

    def records(self, name):
        return [json.loads(line) for line in (self.folder / name).read_text().splitlines()]

    def program(self):
        """One that runs to its end and cuts, posted."""
        (self.folder / "tools.toml").write_text(TOOLS)
        for _ in range(TRIES):
            program = Program(self.random, self.machine, self.random.choice(LANGUAGES[self.machine]))
            name = f"part.{program.language}"
            (self.folder / name).write_text(program.text)
            result = self.run(name, "--tools", "tools.toml", "--motion", "run.jsonl", "--post", "post.nc",
                              "--decimal-point", "calculator")
            if result.returncode == 0:
                return program
        raise Failed(f"no program without an alarm: {result.stderr[:300]}")

    def begin(self):
        """Somewhere else, with everything that a program before may have left on."""
        place = {axis: self.random.uniform(low, high) for axis, (low, high) in BOXES[self.machine].items()}
        left = self.random.choice(("G18 F1.", "G19 G91", "G20", "G93", ""))
        return f"G21 G90 G17 G94\nM3 S777\nG0 {words(place)}\n{left}\n"

    def cuts(self, posted, run):
        begin = self.begin()
        (self.folder / "rs274.nc").write_text(begin + posted)
        kerf = re.sub(r"^G4 P", "G4 X", begin + posted, flags=re.MULTILINE)
        (self.folder / "again.nc").write_text(kerf)
        result = self.run("again.nc", "--motion", "again.jsonl", "--dialect", "fanuc-mill")
        check(result.returncode == 0, f"Kerf refuses the posted program: {result.stderr[:300]}")
        yield "Kerf", KERF_MM, self.behind_beginning(of_records(self.records("again.jsonl"), laser=self.laser))
        moves = Rs274(self.folder, "rs274.nc", self.laser).moves
        yield "rs274", RS274_MM, self.behind_beginning([{**move, "to": {k: move["to"][k] for k in BOXES[self.machine]}}
                                              for move in moves])

    @staticmethod
    def behind_beginning(moves):
        """The move that brings the reader somewhere else is ours."""
        return moves[1:]

    def test(self):
        program = self.program()
        lengths = program.lengths
        run = of_records(self.records("run.jsonl"), lambda record: lengths[record["line"]], self.laser, self.start())
        posted = (self.folder / "post.nc").read_text()
        self.look_at(posted)
        reader = "nobody"
        try:
            for reader, digits_mm, moves in self.cuts(posted, run):
                first = next((i for i, move in enumerate(moves) if move["kind"] != "rapid"), len(moves))
                check(self.machine in MILLS and reader == "Kerf" or all(move["s"] == 0 for move in moves[:min(first, 1)]),
                      "spindle or beam are on before every axis stands")
                Comparison(run, moves, self.laser, digits_mm)
        except Failed as failure:
            raise Failed(f"{reader}: {failure}") from None
        return program.language

    def look_at(self, posted):
        """What no reader shows: the head, and that every axis is brought somewhere before the first cut."""
        blocks = [line for line in posted.splitlines() if not line.startswith("(")]
        first = next((i for i, block in enumerate(blocks) if re.match(r"G[123]\b", block)), None)
        if first is None:
            return
        named = set(re.findall(r"([XYZABC])-?[\d.]+", " ".join(blocks[:first])))
        check(named == set(BOXES[self.machine]), f"before the first cut only {sorted(named)} are said")
        check(" F" in blocks[first], "the first cut has no F")
        check("M5" in blocks[:2], "M5 does not come first")
        numbers = re.findall(r"[XYZABCIJKFP]-?\d*(?:\.(\d*))?", " ".join(blocks))
        check(all(len(decimals) <= 4 for decimals in numbers), "more than four decimals")


def run_case(arguments):
    kerf, seed, machine, keep = arguments
    folder = tempfile.mkdtemp(prefix="kerf-post-")
    try:
        return seed, machine, None, Case(kerf, seed, machine, folder).test()
    except (Failed, Skipped) as failure:
        if keep:
            shutil.copytree(folder, Path(keep) / seed.replace(":", "_"), dirs_exist_ok=True)
        return seed, machine, failure, None
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kerf", required=True)
    parser.add_argument("--programs", type=int, default=160)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--only", default="", help="one program: the seed of a failure, S:N")
    parser.add_argument("--machine", default="")
    parser.add_argument("--jobs", type=int, default=max(2, os.cpu_count() or 1))
    parser.add_argument("--keep", default="", help="folder for the files of what fails")
    options = parser.parse_args()
    if not shutil.which("rs274"):
        print("rs274 of LinuxCNC (linuxcnc-uspace) is not installed: nothing is compared")
        return 0
    machines = [options.machine] if options.machine else list(BOXES)
    seeds = [options.only] if options.only else [f"{options.seed}:{n}" for n in range(options.programs)]
    cases = [(os.path.abspath(options.kerf), seed, machines[int(seed.split(":")[1]) % len(machines)],
              os.path.abspath(options.keep) if options.keep else "") for seed in seeds]
    begin, failed, counts = time.monotonic(), 0, collections.Counter()
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        for seed, machine, failure, language in pool.map(run_case, cases, chunksize=4):
            counts[f"{machine} .{language}"] += failure is None
            if failure is not None:
                failed += 1
                print(f"FAILED --only {seed} ({machine}): {failure}", flush=True)
    done = ", ".join(f"{name} {count}" for name, count in sorted(counts.items()) if count)
    print(f"{sum(counts.values())} programs passed ({done}), {failed} failed, {time.monotonic() - begin:.0f} s")
    return 1 if failed or not counts else 0


if __name__ == "__main__":
    sys.exit(main())
