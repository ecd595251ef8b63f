#!/usr/bin/env python3
"""Random pockets of loops, lines or spirals, cut in layers, contours under G41 and G42, turned shapes and passes, and random edits of
them. What is written must have been verified, must cut what the swept area of its own motions says, and must come back to the byte; what
is refused writes nothing.

usage: random_edits.py --kerf PATH [--programs N] [--seed S] [--keep FOLDER] [--only compensated|turned|pockets]

An edit may be refused where the tool does not fit, never because its result was not verified. Two edits in one file
are the same as one after the other: the same bytes, or the same cut. Exit status: 0 all
passed.
"""

import argparse
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is left behind in the sources

from random_contours import (MAY_BE_REFUSED, TOOLS, CompensatedProfile, TurnedShape,  # noqa: E402
                             number, point, random_profile_edit, random_turned_edit)

RADIUS = 5
STEP = 4


class Pocket:
    """A rectangle, cut in closed loops, layer below layer."""
    words = ["--tools", "tools.toml"]
    tools = TOOLS

    def __init__(self, chance):
        self.x, self.y = chance.randint(-30, 30), chance.randint(-30, 30)
        self.width, self.height = chance.randint(24, 70), chance.randint(24, 70)
        self.layers = chance.randint(1, 3)
        distances = [RADIUS + STEP * i for i in range(20)]
        self.distances = [d for d in distances if min(self.width, self.height) / 2 - d > 0.2]
        if chance.random() < 0.5:
            self.distances.reverse()
        self.is_clockwise = chance.random() < 0.5

    def loop(self, distance):
        low = (self.x + distance, self.y + distance)
        high = (self.x + self.width - distance, self.y + self.height - distance)
        corners = [low, (high[0], low[1]), high, (low[0], high[1])]
        return corners[:1] + corners[:0:-1] if self.is_clockwise else corners

    def text(self):
        lines = ["O1", "T1M6", "S3000M3", "G90G54G0X0.Y0.", "G43H1Z5."]
        for layer in range(self.layers):
            for place, distance in enumerate(self.distances):
                corners = self.loop(distance)
                start = "X{}Y{}".format(*map(number, corners[0]))
                lines += [f"G1{start}"] if place else [f"G0{start}", f"G1Z{number(-2 * layer - 2)}F100."]
                lines += self.sides(corners)
            lines.append("G0Z5.")
        return "\n".join(lines + ["M30"]) + "\n"

    @staticmethod
    def sides(corners):
        at = corners[0]
        for place, to in enumerate(corners[1:] + corners[:1]):
            words = [letter + number(new) for letter, new, old in zip("XY", to, at) if new != old]
            yield "".join(words) + ("" if place else "F300.")
            at = to


class LinedPocket(Pocket):
    """A rectangle, cleared in parallel lines at any angle, one way or there and back, with a round along its
    walls or without one."""

    def __init__(self, chance):
        super().__init__(chance)
        self.is_one_way = chance.random() < 0.4
        self.has_round = chance.random() < 0.7
        self.angle = math.radians(chance.choice([0, 90, 30, 45, 17.5]) if self.has_round else chance.choice([0, 90]))
        self.step = chance.choice([3, 4, 4.7, 6])

    def line(self, across):
        """The ends of a line through where the centre of the tool may be, forwards."""
        along = (math.cos(self.angle), math.sin(self.angle))
        low, high = -1e9, 1e9
        foot = (-across * along[1], across * along[0])
        for axis, (least, most) in enumerate(self.room()):
            if abs(along[axis]) < 1e-9:
                continue
            ends = sorted((edge - foot[axis]) / along[axis] for edge in (least, most))
            low, high = max(low, ends[0]), min(high, ends[1])
        return [tuple(foot[i] + t * along[i] for i in (0, 1)) for t in (low, high)]

    def room(self):
        return ((self.x + RADIUS, self.x + self.width - RADIUS), (self.y + RADIUS, self.y + self.height - RADIUS))

    def lines(self):
        (left, right), (low, high) = self.room()
        across = [y * math.cos(self.angle) - x * math.sin(self.angle) for x in (left, right) for y in (low, high)]
        tip = 0 if self.has_round is False or self.angle in (0, math.radians(90)) else 1.5
        first, last = min(across) + tip, max(across) - tip
        count = math.ceil((last - first) / self.step - 1e-9)
        return [self.line(min(first + i * self.step, last)) for i in range(count + 1)]

    def text(self):
        lines = ["O1", "T1M6", "S3000M3", "G90G54G0X0.Y0.", "G43H1Z5."]
        for layer in range(self.layers):
            down = f"G1Z{number(-2 * layer - 2)}F100."
            for place, (start, end) in enumerate(self.lines()):
                if place % 2 and not self.is_one_way:
                    start, end = end, start
                if place and not self.is_one_way:
                    lines.append(point(start))
                else:
                    lines += (["G0Z5."] if place else []) + ["G0" + point(start), down]
                lines.append("G1" + point(end) + "F300.")
            if self.has_round:
                corners = self.loop(RADIUS)
                lines += ["G0Z5.", "G0" + point(corners[0]), down] if self.is_one_way else [point(corners[0])]
                lines += self.sides(corners)
            lines.append("G0Z5.")
        return "\n".join(lines + ["M30"]) + "\n"


class SpiralPocket(Pocket):
    """A round pocket, cleared by half circles from the middle or towards it, with a round along the wall."""

    def __init__(self, chance):
        super().__init__(chance)
        self.radius = chance.randint(24, 40)
        self.growth = chance.choice([1.5, 2, 2.3])
        self.turn = chance.choice([2, 3])
        self.is_inwards = chance.random() < 0.4

    def text(self):
        lines = ["O1", "T1M6", "S3000M3", "G90G54G0X0.Y0.", "G43H1Z5."]
        wall = self.radius - RADIUS
        offs = [2 + self.growth * i for i in range(100) if 2 + self.growth * i < wall - 0.01] + [wall]
        places = [self.x + off * (-1) ** i for i, off in enumerate(offs)]
        if self.is_inwards:
            places.reverse()
        edge = places[0] if self.is_inwards else places[-1]
        around = f"G{self.turn}X{number(edge)}Y{number(self.y)}I{number(self.x - edge)}J0."
        for layer in range(self.layers):
            lines += [f"G0X{number(places[0])}Y{number(self.y)}", f"G1Z{number(-2 * layer - 2)}F100."]
            turns = [f"G{self.turn}X{number(to)}Y{number(self.y)}I{number((to - at) / 2)}J0."
                     for at, to in zip(places, places[1:])]
            turns = [around, *turns] if self.is_inwards else [*turns, around]
            lines += [turns[0] + "F300.", *turns[1:], "G0Z5."]
        return "\n".join(lines + ["M30"]) + "\n"


def random_round_edit(chance, pocket):
    x, y, radius = pocket.x + chance.randint(-4, 4), pocket.y, chance.randint(19, 50)
    return chance.choice([
        {"op": "replace", "layer": chance.randint(1, pocket.layers), "contour": [[x - radius, y, 1], [x + radius, y, 1]]},
        {"op": "replace", "contour": [[x - radius, y, 1], [x + radius, y, 1]]},
        {"op": "scale", "factor": chance.choice([0.8, 1.1, 1.37])},
        {"op": "move", "dx": chance.randint(-9, 9), "dy": chance.randint(-9, 9)},
        {"op": "depth", "z": -chance.randint(1, 2 * pocket.layers + 5)},
        {"op": "feed", "cut": chance.randint(100, 900), "entry": chance.randint(20, 90)},
    ])


POCKETS = [Pocket, Pocket, LinedPocket, LinedPocket, SpiralPocket]
PARTS = {"pockets": POCKETS, "compensated": [CompensatedProfile], "turned": [TurnedShape]}


def random_part(chance, only):
    """What seeds made before there were other parts they still do with --only pockets."""
    kinds = PARTS[only] if only else [*POCKETS, CompensatedProfile, CompensatedProfile, TurnedShape, TurnedShape]
    return chance.choice(kinds)(chance)


def may_be_refused(pocket):
    """Where the tool does not fit; of turns and of lines without a round also what they cannot clear."""
    if isinstance(pocket, SpiralPocket) or (isinstance(pocket, LinedPocket) and not pocket.has_round):
        return (*MAY_BE_REFUSED, "EDIT_LEAVES_REST", "EDIT_NOT_EDITABLE")
    return MAY_BE_REFUSED


def random_edit(chance, pocket):
    if isinstance(pocket, SpiralPocket):
        return random_round_edit(chance, pocket)
    if isinstance(pocket, CompensatedProfile):
        return random_profile_edit(chance, pocket)
    if isinstance(pocket, TurnedShape):
        return random_turned_edit(chance, pocket)
    x, y, width, height = pocket.x, pocket.y, pocket.width, pocket.height
    layer = chance.randint(1, pocket.layers)
    right, top = x + chance.randint(14, 80), y + chance.randint(14, 80)
    bent = [[x, y], [x + width + 15, y], [x + width + 15, y + 14], [x + 14, y + 14], [x + 14, y + height], [x, y + height]]
    return chance.choice([
        {"op": "replace", "layer": layer, "contour": [[x, y], [right, y], [right, top], [x, top]]},
        {"op": "replace", "layer": layer, "contour": bent},
        {"op": "fillet-all", "r": chance.randint(6, 11)},
        {"op": "chamfer", "layer": layer, "corner": chance.randint(0, 3), "d1": chance.randint(2, 9), "d2": chance.randint(2, 9)},
        {"op": "move", "dx": chance.randint(-9, 9), "dy": chance.randint(-9, 9)},
        {"op": "rotate", "deg": chance.choice([30, 45, 90, 17.5])},
        {"op": "depth", "z": -chance.randint(1, 2 * pocket.layers + 5)},
        {"op": "feed", "cut": chance.randint(100, 900), "entry": chance.randint(20, 90)},
        {"op": "tool", "tool": chance.randint(2, 3)},
    ])


def random_edits(chance, pocket):
    """One edit, or two that may be made one after the other: the first leaves the feature one feature."""
    second = random_edit(chance, pocket)
    if chance.random() < 0.5 or isinstance(pocket, TurnedShape):
        return [second]
    first = chance.choice([
        {"op": "move", "dx": chance.randint(-9, 9), "dy": chance.randint(-9, 9)},
        {"op": "feed", "cut": chance.randint(100, 900)},
        {"op": "depth", "z": -chance.randint(1, 2 * pocket.layers + 5)},
    ])
    if first["op"] == second["op"] == "depth":
        return [second]  # the last one alone says where steps are
    if first["op"] == "depth":
        second.pop("layer", None)  # there may be others by then
    return [first, second]


def cut_of(options, folder, name):
    """What a program machines: layers with their heights, areas and contours, feeds."""
    result = subprocess.run([options.kerf, "features", name, "--tools", "tools.toml", "--format", "json"],
                            cwd=folder, capture_output=True, text=True, check=False, timeout=150)
    tree = json.loads(result.stdout)
    layers = sorted([round(layer["z"], 2), round(layer["area"], 1), feature["tool"],
                     sorted([round(x, 2), round(y, 2)] for x, y, _ in layer["contour"])]
                    for feature in tree["features"] for layer in feature["layers"])
    return layers, [operation["feeds"] for operation in tree["operations"]]


def difference_of_two_runs(options, folder, edits, refusals):
    """What two edits one after the other make otherwise than both in one file; None: nothing."""
    at = "part.nc"
    for place, edit in enumerate(edits):
        (folder / "one.json").write_text(json.dumps({"version": 1, "edits": [edit]}))
        made = kerf(options, folder, at, "--edits", "one.json", "--output", f"step{place}.nc", "--tools", "tools.toml")
        if made.returncode == 1 and any(code in made.stderr for code in refusals):
            return None
        if made.returncode != 0:
            return f"edit {place} alone: exit status {made.returncode}: {made.stderr[:200]}"
        at = f"step{place}.nc"
    if (folder / at).read_text() == (folder / "new.nc").read_text():
        return None
    return None if cut_of(options, folder, at) == cut_of(options, folder, "new.nc") else "two runs cut otherwise than one"


def kerf(options, folder, *words):
    return subprocess.run([options.kerf, "edit", *words], cwd=folder, capture_output=True, text=True, check=False, timeout=150)


def fault_of(options, folder, seed):
    """What is wrong with one edit; None: nothing."""
    chance = random.Random(seed)
    pocket = random_part(chance, options.only)
    refusals = may_be_refused(pocket)
    text = pocket.text()
    edits = [edit | {"feature": "F1"} for edit in random_edits(chance, pocket)]
    (folder / "part.nc").write_text(text)
    (folder / "tools.toml").write_text(pocket.tools)
    (folder / "edits.json").write_text(json.dumps({"version": 1, "edits": edits}))
    made = kerf(options, folder, "part.nc", "--edits", "edits.json", "--output", "new.nc", "--report", "report.json", *pocket.words)
    if made.returncode == 1 and any(code in made.stderr for code in refusals):
        return "it has written a file" if (folder / "new.nc").exists() else None
    if made.returncode != 0:
        return f"exit status {made.returncode}: {made.stderr[:200]}"
    verified = json.loads((folder / "report.json").read_text())["verified"]
    if not (verified["recognised"] and verified["others_unchanged"]) or verified["outside_mm3"] > 0.01:
        return f"verified is {verified}"
    undone = kerf(options, folder, "new.nc", "--undo", "report.json", "--output", "old.nc")
    if undone.returncode != 0 or (folder / "old.nc").read_text() != text:
        return f"not taken back: {undone.stderr[:200]}"
    return difference_of_two_runs(options, folder, edits, refusals) if len(edits) > 1 else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kerf", required=True, type=lambda path: str(Path(path).resolve()))
    parser.add_argument("--programs", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--only", choices=sorted(PARTS))
    options = parser.parse_args()
    failures = 0
    for place in range(options.programs):
        seed = f"{options.seed}:{place}"
        with tempfile.TemporaryDirectory() as name:
            folder = options.keep / seed if options.keep else Path(name)
            folder.mkdir(parents=True, exist_ok=True)
            fault = fault_of(options, folder, seed)
        if fault:
            failures += 1
            print(f"FAILED {seed}: {fault}")
    print(f"{options.programs - failures} passed, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
