#!/usr/bin/env python3
"""Random lathe programs, each written twice: as FANUC has it for Kerf and as LinuxCNC has it for its rs274.
Both must make the same moves.

usage: random_lathe.py --kerf PATH [--programs N] [--seed S] [--only S:N] [--jobs J] [--keep FOLDER]

What both speak: diameters, G00 to G03 with I K or R, ways (U W, G91), G20 and G21, feed per revolution and per
minute, threads (G32, G33), work offsets, G53, and the passes of G76 without finishing allowance and least cut.
Every program has a seed of its own, S:0, S:1, …; the one of a failure is printed. Exit status: 0 all passed.
"""

import argparse
import concurrent.futures
import json
import math
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

from harness import Failed, check
from posted_path import Rs274

DIGIT_MM = 1.01e-4  # rs274 prints four decimals: half a digit of the end, and half a digit of an offset
SHORT_MM = 0.006
FEED = 1e-4
INCH_MM = 25.4
BOX = {"X": (2, 180), "Z": (-200, 60)}  # X as a diameter, mm


def number(value):
    return f"{value:.4f}".rstrip("0")  # the point stays


class Program:
    """The two texts, `kerf` and `rs274`, and whether a thread cycle is among them."""

    def __init__(self, dice):
        self.dice = dice
        self.kerf, self.rs274, self.has_cycle = [], [], False
        self.inch, self.mode, self.system = False, "G99", (0.0, 0.0)
        self.at = None  # (diameter, Z) of the work system, in the unit of the program
        self.begin()
        for _ in range(dice.randint(4, 20)):
            dice.choices((self.rapid, self.line, self.way, self.arc, self.arc_by_radius, self.thread, self.feed_mode,
                          self.unit, self.machine_place, self.thread_cycle), (4, 6, 4, 5, 4, 3, 2, 1, 1, 2))[0]()
        self.add("M05")
        self.add("M30", "M2")

    def add(self, kerf, rs274=None):
        self.kerf.append(kerf)
        self.rs274.append(kerf if rs274 is None else rs274)

    def begin(self):
        self.kerf.append("O1")
        self.rs274.append("G7 G18 G90 G40 G94")  # G94: rs274 knows no other before it is told
        self.add("G21 G97 S500 M03", "G21 G97 S500\nM3\nG95")
        if self.dice.random() < 0.5:
            self.add(f"G10 L2 P1 X{number(self.value(-20, 20))} Z{number(self.value(-20, 20))}")
        self.add("G54")
        self.rapid()
        self.add(f"G01 X{number(self.at[0])} F.2")

    def value(self, low, high):
        """With the digits of the unit."""
        if self.inch:
            return round(self.dice.uniform(low, high) / INCH_MM, 4)
        return round(self.dice.uniform(low, high), self.dice.choice((0, 1, 3, 3)))

    def place(self):
        return self.value(*BOX["X"]), self.value(*BOX["Z"])

    def words(self, place):
        return f"X{number(place[0])} Z{number(place[1])}"

    def rapid(self):
        self.at = self.place()
        self.add(f"G00 {self.words(self.at)}")

    def line(self):
        place = self.place()
        kind = self.dice.randrange(3)
        self.at = (place[0], self.at[1]) if kind == 0 else (self.at[0], place[1]) if kind == 1 else place
        words = (f"X{number(self.at[0])}", f"Z{number(self.at[1])}", self.words(self.at))[kind]
        self.add(f"G01 {words}{self.feed()}")

    def feed(self):
        if self.dice.random() < 0.5:
            return ""
        return f" F{number(self.dice.choice((0.05, 0.12, 0.3)) if self.mode == 'G99' else self.dice.choice((40.0, 120.5)))}"

    def way(self):
        way = self.value(-10, 10), self.value(-10, 10)
        code = self.dice.choice(("G00", "G01"))
        self.add(f"{code} U{number(way[0])} W{number(way[1])}", f"G91 {code} {self.words(way)}\nG90")
        self.at = self.at[0] + way[0], self.at[1] + way[1]

    def turned(self):
        """A centre, as a way in Z and X, and an end on its circle as far as digits go."""
        k, i = self.value(-30, 30) or 1.0, self.value(-30, 30) or 1.0
        centre = self.at[1] + k, self.at[0] / 2 + i
        radius, angle = math.hypot(k, i), self.dice.uniform(0, 2 * math.pi)
        digits = 4 if self.inch else 3
        end = (round(2 * (centre[1] + radius * math.sin(angle)), digits), round(centre[0] + radius * math.cos(angle), digits))
        return (k, i), radius, end

    def chord(self, end):
        return math.hypot(end[1] - self.at[1], (end[0] - self.at[0]) / 2)

    def arc(self):
        centre, radius, end = self.turned()
        if self.chord(end) < 0.05 * radius:
            return
        self.add(f"{self.dice.choice(('G02', 'G03'))} {self.words(end)} I{number(centre[1])} K{number(centre[0])}")
        self.at = end

    def arc_by_radius(self):
        end = self.place()
        if self.chord(end) < (0.04 if self.inch else 1):
            return
        radius = round(self.chord(end) * self.dice.uniform(0.55, 2), 3) * self.dice.choice((1, 1, -1))
        self.add(f"{self.dice.choice(('G02', 'G03'))} {self.words(end)} R{number(radius)}")
        self.at = end

    def lead(self):
        return 0.05 if self.inch else self.dice.choice((0.75, 1.5, 2.0))

    def thread(self):
        """A cylinder and often a cone behind it, as one thread."""
        lead = number(self.lead())
        ends = [(self.at[0], self.at[1] - (self.value(5, 40) or 1))]
        if self.dice.random() < 0.5:
            ends.append((round(ends[0][0] + self.value(1, 4), 4), round(ends[0][1] - (self.value(5, 10) or 1), 4)))
        for end in ends:
            self.add(f"G32 {self.words(end)} F{lead}", f"G33 {self.words(end)} K{lead}")
        self.at = ends[-1]
        self.rapid()
        self.modal_feed()

    def modal_feed(self):
        """The lead of G32 is its F; that of G33 is none."""
        self.add("G01 " + f"X{number(self.at[0])} F{number(0.2 if self.mode == 'G99' else 100.0)}")

    def thread_cycle(self):
        """m = 1, no run-out, straight infeed: the spring pass of rs274 is the finishing pass."""
        home = self.at
        height, first = self.dice.choice((0.6, 1.1, 1.8)), self.dice.choice((0.2, 0.35, 0.5))
        clear, lead = self.dice.choice((0.5, 1.0)), self.lead()
        if self.inch:
            height, first, clear = 0.05, 0.011, 0.04
        count = 10000 if self.inch else 1000
        end = round(home[0] - 2 * (clear + height), 4), round(home[1] - self.value(10, 40) - 1, 4)
        self.has_cycle = True
        self.add("G76 P010000 Q0 R0\n" + f"G76 {self.words(end)} P{height * count:.0f} Q{first * count:.0f} F{number(lead)}",
                 f"G76 P{number(lead)} Z{number(end[1])} I{number(-2 * clear)} J{number(2 * first)} K{number(2 * height)} "
                 "Q0 R2 H1 E0 L0")
        self.rapid()
        self.modal_feed()

    def feed_mode(self):
        self.mode = self.dice.choice(("G98", "G99"))
        self.add(self.mode, {"G98": "G94", "G99": "G95"}[self.mode])
        self.modal_feed()

    def unit(self):
        self.inch = not self.inch
        self.add("G20" if self.inch else "G21")
        self.rapid()
        self.modal_feed()

    def machine_place(self):
        words = self.words(self.place())
        self.add(f"G53 {words}", f"G53 G00 {words}")
        self.rapid()


class LatheMoves(Rs274):
    """Moves of X as a radius and Z in the machine, mm; a thread has its lead."""

    def __init__(self, folder, name):
        self.lead, self.per_turn, self.offset = None, False, (0.0, 0.0)
        super().__init__(folder, name)

    def take(self, name, words):
        if name == "SET_G5X_OFFSET":
            self.offset = float(words[1]) * self.scale, float(words[3]) * self.scale
        elif name == "START_SPEED_FEED_SYNC":
            self.lead = float(words[0])
        elif name == "STOP_SPEED_FEED_SYNCH":
            self.lead = None
        elif name == "SET_FEED_MODE":
            self.per_turn = words[1] == "1"
        elif name == "USE_LENGTH_UNITS":
            self.scale = INCH_MM if "INCH" in words[0] else 1.0
        else:
            super().take(name, words)

    def add(self, move):
        x, z = ((move["to"][axis] * self.scale + off for axis, off in zip("XZ", self.offset)))
        made = {"kind": move["kind"], "to": (x, z), "unit": self.scale}
        if move["kind"] == "line" and self.lead is not None:
            made.update(kind="thread", lead=self.lead * self.scale)
        elif move["kind"] != "rapid":
            made["feed"] = self.feed * self.scale
        if move["kind"] == "arc":
            centre_z, centre_x = (c * self.scale + off for c, off in zip(move["center"], self.offset[::-1]))
            made.update(centre=(centre_x, centre_z), direction=move["direction"])
        self.moves.append(made)
        self.at = move["to"]


def moves_of(records):
    moves = []
    for record in records:
        if "to" not in record:
            continue
        move = {"kind": record["kind"], "to": (record["to"]["X"] / 2, record["to"]["Z"]), "line": record["line"],
                **{key: record[key] for key in ("feed", "lead", "direction") if key in record}}
        if record["kind"] == "arc":
            move["centre"] = record["center"][1] / 2, record["center"][0]
        moves.append(move)
    return moves


def that_go(moves):
    """A straight move shorter than the digits are worth may be one for a reader and none for the other."""
    ends = [(0.0, 0.0), *(move["to"] for move in moves)]
    return [move for move, begin in zip(moves, ends) if move["kind"] == "arc" or math.dist(begin, move["to"]) > SHORT_MM]


def last_rapids(moves):
    """How the rapids of a cycle come to the next cut is the control's own matter."""
    rapid = [move["kind"] == "rapid" for move in moves] + [False]
    return [move for i, move in enumerate(moves) if not (rapid[i] and rapid[i + 1])]


def compare(wanted, got):
    for i, (ours, theirs) in enumerate(zip(wanted, got)):
        where = f"move {i} of line {ours['line']}: {ours}, rs274 {theirs}"
        check(ours["kind"] == theirs["kind"], f"kind: {where}")
        digits = DIGIT_MM * theirs["unit"]
        check(math.dist(ours["to"], theirs["to"]) <= 2 * digits, f"end: {where}")
        check(abs(ours.get("feed", 0) - theirs.get("feed", 0)) <= FEED * theirs["unit"], f"feed: {where}")
        check(abs(ours.get("lead", 0) - theirs.get("lead", 0)) <= 1e-6, f"lead: {where}")
        if ours["kind"] == "arc":
            check(ours["direction"] == theirs["direction"], f"direction: {where}")
            check(math.dist(ours["centre"], theirs["centre"]) <= 4 * digits, f"centre: {where}")
    check(len(wanted) == len(got), f"{len(wanted)} moves, rs274 makes {len(got)}")


class Case:
    def __init__(self, kerf, seed, folder):
        self.kerf, self.folder = kerf, Path(folder)
        self.program = Program(random.Random(seed))

    def ours(self):
        (self.folder / "part.nc").write_text("\n".join(self.program.kerf) + "\n")
        result = subprocess.run([self.kerf, "run", "part.nc", "--machine", "lathe2", "--motion", "run.jsonl"],
                                cwd=self.folder, capture_output=True, text=True, timeout=120, check=False)
        check(result.returncode == 0, f"kerf ends with {result.returncode}: {result.stderr[:300]}")
        return moves_of([json.loads(line) for line in (self.folder / "run.jsonl").read_text().splitlines()])

    def theirs(self):
        (self.folder / "part.ngc").write_text("\n".join(self.program.rs274) + "\n")
        return LatheMoves(self.folder, "part.ngc").moves

    def test(self):
        ours, theirs = that_go(self.ours()), that_go(self.theirs())
        if self.program.has_cycle:
            ours, theirs = last_rapids(ours), last_rapids(theirs)
        compare(ours, theirs)
        return len(ours)


def run_case(arguments):
    kerf, seed, keep = arguments
    folder = tempfile.mkdtemp(prefix="kerf-lathe-")
    try:
        return seed, None, Case(kerf, seed, folder).test()
    except Failed as failure:
        if keep:
            shutil.copytree(folder, Path(keep) / seed.replace(":", "_"), dirs_exist_ok=True)
        return seed, failure, 0
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kerf", required=True)
    parser.add_argument("--programs", type=int, default=60)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--only", default="", help="one program: the seed of a failure, S:N")
    parser.add_argument("--jobs", type=int, default=max(2, os.cpu_count() or 1))
    parser.add_argument("--keep", default="", help="folder for the files of what fails")
    options = parser.parse_args()
    if not shutil.which("rs274"):
        print("rs274 of LinuxCNC (linuxcnc-uspace) is not installed: nothing is compared")
        return 0
    seeds = [options.only] if options.only else [f"{options.seed}:{n}" for n in range(options.programs)]
    cases = [(os.path.abspath(options.kerf), seed, options.keep and os.path.abspath(options.keep)) for seed in seeds]
    begin, failed, moves = time.monotonic(), 0, 0
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        for seed, failure, made in pool.map(run_case, cases, chunksize=4):
            moves += made
            if failure is not None:
                failed += 1
                print(f"FAILED --only {seed}: {failure}", flush=True)
    print(f"{len(cases) - failed} programs passed ({moves} moves), {failed} failed, {time.monotonic() - begin:.0f} s")
    return 1 if failed or not moves else 0


if __name__ == "__main__":
    sys.exit(main())
