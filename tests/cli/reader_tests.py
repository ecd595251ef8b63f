"""--post, read by LinuxCNC's interpreter: rs274 makes the motions that Kerf made.

rs274 prints what it would have a machine do, to four decimals; so does --post write. Ends, centres
and what arcs rise by must agree within TOLERANCE_MM.
"""

import math
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

from harness import Skipped, check, equal, near, status, test

ROOT = Path(__file__).resolve().parents[2]
TOLERANCE_MM = 2e-4
CHORD_MM = 1e-3  # of arcs in space, docs/command-line.md
INPUTS = {"--machine": 1, "--dialect": 1, "--library": 1, "--set": 1, "--param": 1,
          "--machine-set": 1, "--decimal-point": 1, "--skip-at": 1, "--tools": 1, "--offsets": 1,
          "--block-skip": 1, "--optional-stop": 0}
NORMAL = {"XY": "Z", "ZX": "Y", "YZ": "X"}


class Reader:
    """What rs274 makes of a program: moves, each with feed and S of a spindle that turns."""

    def __init__(self, folder, name):
        if not shutil.which("rs274"):
            raise Skipped("rs274 of LinuxCNC (linuxcnc-uspace) is not installed")
        program = Path(folder, name).read_text()
        tools = sorted(set(re.findall(r"^T(\d+) M6$", program, re.MULTILINE)), key=int)
        table = "".join(f"T{tool} P{tool} D1 Z0 ;\n" for tool in tools)
        Path(folder, "tools.tbl").write_text(table)
        home = {**os.environ, "HOME": str(folder)}  # where it keeps the tools of a run
        result = subprocess.run(["rs274", "-g", "-t", "tools.tbl", name], cwd=folder, env=home,
                                capture_output=True, text=True, timeout=60, check=False)
        check(result.returncode == 0 and "error" not in result.stderr.lower(),
              f"rs274 refuses the posted program: {(result.stderr or result.stdout)[-300:]}")
        self.moves = []
        self.plane, self.feed, self.s, self.on = "XY", 0.0, 0.0, False
        self.at = dict.fromkeys("XYZABC", 0.0)
        calls = re.findall(r"^\s*\d+ \S+\s+(\w+)\((.*)\)$", result.stdout, re.MULTILINE)
        for name, text in calls:
            self.take(name, [word.strip() for word in text.split(",")])
        check("PROGRAM_END" in result.stdout, "rs274 does not come to the end of the program")

    def take(self, name, words):
        if name == "SELECT_PLANE":
            self.plane = {"XY": "XY", "XZ": "ZX", "YZ": "YZ"}[words[0][-2:]]
        elif name == "SET_FEED_RATE":
            self.feed = float(words[0])
        elif name == "SET_SPINDLE_SPEED":
            self.s = float(words[-1])
        elif name.startswith(("START_SPINDLE", "STOP_SPINDLE")):
            self.on = name.startswith("START")
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            kind = "rapid" if name.endswith("TRAVERSE") else "line"
            to = dict(zip("XYZABC", map(float, words)))
            if kind == "rapid" or to != self.at:  # G1 alone turns a beam on where it stands
                self.add({"kind": kind, "to": to})
        elif name == "ARC_FEED":
            self.arc([float(word) for word in words])

    def arc(self, words):
        first, second = self.plane
        to = dict(zip("ABC", words[6:9]), **{first: words[0], second: words[1],
                                             NORMAL[self.plane]: words[5]})
        self.add({"kind": "arc", "to": to, "center": words[2:4], "plane": self.plane,
                  "direction": "ccw" if words[4] > 0 else "cw", "whole": abs(words[4]) == 1})

    def add(self, move):
        self.moves.append({**move, "from": self.at, "feed": self.feed, "s": self.s * self.on})
        self.at = move["to"]


def digits(to):
    """As --post rounds."""
    return {axis: math.floor(abs(value) * 1e4 + 0.5) * (1 if value > 0 else -1)
            for axis, value in to.items()}


def close(got, wanted, what):
    for axis, value in wanted.items():
        near(got[axis], value, TOLERANCE_MM, f"{what}: {axis}")


class Comparison:
    """Goes along the moves of both."""

    def __init__(self, records, moves):
        self.moves, self.next, self.beam = moves, 0, None
        self.at = dict.fromkeys(next((r["to"] for r in records if "to" in r), {}), 0.0)
        for record in records:
            self.take(record)
        equal(self.next, len(moves), "moves that rs274 makes")

    def take(self, record):
        if record["kind"] == "power":
            self.beam = record["percent"] * record.get("beam", True)
        if "to" not in record:
            return
        where = f"line {record['line']}, {record['kind']}"
        kind = {"probe": "line", "thread": "line"}.get(record["kind"], record["kind"])
        getattr(self, kind.replace("-", "_"))(record, where)
        self.at = record["to"]

    def pull(self, kinds, where):
        check(self.next < len(self.moves), f"{where}: rs274 makes no move")
        move = self.moves[self.next]
        self.next += 1
        check(move["kind"] in kinds, f"{where}: rs274 makes a {move['kind']} to {move['to']}")
        return move

    def cut(self, record, kinds, where):
        move = self.pull(kinds, where)
        if record.get("feed_mode") == "per-minute":
            near(move["feed"], record["feed"], TOLERANCE_MM, f"{where}: feed")
        if self.beam is not None:
            near(move["s"], 10 * self.beam, 1e-3, f"{where}: S")
        return move

    def goes(self, to):
        return digits(to) != digits(self.at)

    def rapid(self, record, where):
        move = self.pull(["rapid"], where)
        close(move["to"], record["to"], where)
        if self.beam is not None:
            equal(move["s"], 0, f"{where}: S")

    def line(self, record, where):
        if self.goes(record["to"]):
            close(self.cut(record, ["line"], where)["to"], record["to"], where)

    def arc(self, record, where):
        first, second = record["plane"]
        closes = digits(record["to"])[first] == digits(self.at)[first] and \
            digits(record["to"])[second] == digits(self.at)[second]
        if closes and not self.sweep(record) > math.pi and record["turns"] == 0:
            return self.line(record, where)
        for turn in range(record["turns"] + 1):
            move = self.cut(record, ["arc"], where)
            equal((move["plane"], move["direction"], move["whole"]),
                  (record["plane"], record["direction"], True), f"{where}: plane, direction, turns")
            for got, wanted in zip(move["center"], record["center"]):
                near(got, wanted, TOLERANCE_MM, f"{where}: centre")
            if turn < record["turns"]:
                share = (turn + 1) / (record["turns"] + self.sweep(record) / (2 * math.pi))
                close(move["to"], {axis: value if axis in record["plane"] else
                                   value + (record["to"][axis] - value) * share
                                   for axis, value in self.at.items()}, f"{where}: turn {turn + 1}")
        close(move["to"], record["to"], where)

    def sweep(self, record):
        """Without whole turns more, (0, 2 pi]."""
        first, second = record["plane"]
        u, v = record["center"]
        a = math.atan2(self.at[second] - v, self.at[first] - u)
        b = math.atan2(record["to"][second] - v, record["to"][first] - u)
        way = (b - a if record["direction"] == "ccw" else a - b) % (2 * math.pi)
        return way or 2 * math.pi

    def space_arc(self, record, where):
        """One arc of a plane, or chords whose ends and middles lie on the circle."""
        centre = record["center"]
        radius = math.dist([self.at[axis] for axis in "XYZ"], centre)
        while True:
            move = self.cut(record, ["arc", "line"], where)
            if move["kind"] == "line":
                ends = [[move[end][axis] for axis in "XYZ"] for end in ("from", "to")]
                middle = [(a + b) / 2 for a, b in zip(*ends)]
                near(math.dist(ends[1], centre), radius, 2 * TOLERANCE_MM, f"{where}: radius")
                near(math.dist(middle, centre), radius, CHORD_MM + 2 * TOLERANCE_MM, f"{where}: chord")
            if digits(move["to"]) == digits({**move["to"], **record["to"]}) or \
                    all(abs(move["to"][axis] - value) < TOLERANCE_MM
                        for axis, value in record["to"].items()):
                return


def compare(box, *command, cwd=None):
    result = box.kerf(*command, "--post", box.path("post.nc"), "--motion", box.path("motion.json"),
                      cwd=cwd)
    if result.status == 1:  # by intention: the example shows an alarm
        check("post.nc" not in box.files(), "a run that ended in an alarm was posted")
        return
    status(result, 0)
    reader = Reader(box.folder, "post.nc")
    Comparison(box.motions("motion.json"), reader.moves)


def example_inputs(path):
    """The words of an example's command that say how it runs; None: it is no kerf run."""
    words = shlex.split(path.read_text())
    if words[1:2] != ["run"]:
        return None
    kept, at = ["run"], 2
    while at < len(words):
        word = words[at]
        takes = not word.startswith("-") or word == "-" or word in INPUTS
        count = INPUTS.get(word, 1 if word.startswith("--") and word != "--plot-speed" and
                           word != "--plot-energy" and word != "--keep-partial" else 0)
        if takes:
            kept += words[at:at + 1 + count]
        at += 1 + count
    return kept


def add_examples():
    for path in sorted(ROOT.glob("examples/*/command*")):
        inputs = example_inputs(path)
        if inputs and not path.name.startswith("command_as_printed"):
            name = f"{path.parent.name}{path.name.removeprefix('command')}"
            test(f"rs274 reads the posted program of example {name} as Kerf ran it")(
                lambda box, words=inputs: compare(box, *words, cwd=ROOT))


add_examples()

BASIC = {
    "a circle and all forms of arcs":
        "speed(50)\npower(80)\nmove(10,0)\nline(20,0)\ncircle(40,40,5)\ncircle(40,40,2,5)\n"
        "arc(50,60,4,0,900)\narc(50,60,4,30,-45)\narc(50,60,4,10,-1090)\narc(50,60,4,90,450)\n"
        "move(50,50,0)\narc(60,60,0,70,50,0)\narc(80,60,20,1)\narc(100,70,-30,-1)\n"
        "arc(110,80,5,120,70,-5)\nend\n",
    "powers that change in and between cuts":
        "power(10)\nspeed(20)\nline(5,0)\npower(55.5)\nline(5,5)\npower(0)\nline(0,5)\n"
        "power(100)\nline(0,0)\nmove(3,3)\npower(30)\npower(40)\nline(9,9)\nhome\nend\n",
    "a spiral of lines":
        "speed(100)\npower(33.3)\nfor i=1 to 200\nline(i*cos(i/9)/8, i*sin(i/9)/8, i/300)\nnext\nend\n",
}


def basic(program, *words):
    def run(box):
        box.write("part.bas", program)
        compare(box, "run", "part.bas", *words)
    return run


for title, text in BASIC.items():
    test(f"rs274 reads posted laser BASIC, {title}, as Kerf ran it")(basic(text))
test("rs274 reads the posted beam of M4 as that of M3")(
    basic(BASIC["powers that change in and between cuts"], "--machine-set", "drive.post_beam=M4"))
