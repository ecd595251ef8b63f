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

TOOLS = "".join(f'[[tool]]\nnumber = {number}\ntype = "flat"\ndiameter = {diameter}\n'
                for number, diameter in ((1, 10), (2, 8), (3, 6)))
RADIUS = 5
STEP = 4
MAY_BE_REFUSED = ("EDIT_TOOL_TOO_BIG", "EDIT_DOES_NOT_FIT")


def number(value):
    return f"{value:.3f}".rstrip("0")  # the point stays


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
                    lines.append(self.point(start))
                else:
                    lines += (["G0Z5."] if place else []) + ["G0" + self.point(start), down]
                lines.append("G1" + self.point(end) + "F300.")
            if self.has_round:
                corners = self.loop(RADIUS)
                lines += ["G0Z5.", "G0" + self.point(corners[0]), down] if self.is_one_way else [self.point(corners[0])]
                lines += self.sides(corners)
            lines.append("G0Z5.")
        return "\n".join(lines + ["M30"]) + "\n"

    @staticmethod
    def point(point):
        return "X{}Y{}".format(*(number(round(value, 3) + 0.0) for value in point))


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


class CompensatedProfile:
    """A contour under G41 or G42, outside of it or in it, with the numbers of a drawing: run in along its first element, from a corner, or
    by a quarter of a circle onto the middle of a wall."""
    words = ["--tools", "tools.toml"]
    tools = TOOLS
    refusals = MAY_BE_REFUSED

    def __init__(self, chance):
        self.x, self.y = chance.randint(-30, 30), chance.randint(-30, 30)
        self.width, self.height = chance.randint(50, 90), chance.randint(50, 90)
        self.layers = 1
        self.is_inside = chance.random() < 0.3
        self.is_clockwise = chance.random() < 0.5
        self.lead = "arc" if self.is_inside else chance.choice(["run-in", "corner", "arc"])
        self.has_radii = chance.random() < 0.5
        self.has_numbers = chance.random() < 0.4
        self.has_steps = not self.is_inside and chance.random() < 0.4
        self.rounds = [chance.choice([0, 0, 6, 8]) for _ in range(4)]
        self.cut = chance.choice([1, 2, 4]) if chance.random() < 0.5 else 0  # of the third corner

    def corners(self):
        """Of the drawing, counterclockwise: points with the radius of their rounding."""
        left, low, right, high = self.x, self.y, self.x + self.width, self.y + self.height
        points = [((left, low), self.rounds[0]), ((right, low), self.rounds[1])]
        if self.has_steps:
            points += [((right, high - 20), 0), ((right - 20, high - 20), self.rounds[2]), ((right - 20, high), 0)]
        else:
            points.append(((right, high), self.rounds[2]))
        return [*points, ((left, high), self.rounds[3])]

    def elements(self):
        """(from, to, centre or None) in the sense of the tool's way, from behind the first corner."""
        corners = self.corners()
        ways = []
        for place, ((x, y), radius) in enumerate(corners):
            (bx, by), (ax, ay) = corners[place - 1][0], corners[(place + 1) % len(corners)][0]
            to_before = unit(bx - x, by - y)
            to_behind = unit(ax - x, ay - y)
            begin = (x + radius * to_before[0], y + radius * to_before[1])
            end = (x + radius * to_behind[0], y + radius * to_behind[1])
            centre = (begin[0] + radius * to_behind[0], begin[1] + radius * to_behind[1])
            ways.append((begin, end, centre if radius else None))
        elements = []
        for place, (begin, end, centre) in enumerate(ways):
            if centre:
                elements.append((begin, end, centre))
            elements.append((end, ways[(place + 1) % len(ways)][0], None))
        first = 1 if ways[0][2] else 0
        elements = elements[first:] + elements[:first]
        if self.is_clockwise:
            elements = [(to, at, centre) for at, to, centre in reversed(elements)]
            while elements[0][2] or elements[-1][2]:  # it begins at the end of a line
                elements = elements[1:] + elements[:1]
        return elements

    def text(self):
        elements = self.elements()
        side = 41 if self.is_clockwise != self.is_inside else 42
        away = 1 if side == 41 else -1  # the tool stands to the left
        at, to, _ = elements[0]
        along = unit(to[0] - at[0], to[1] - at[1])
        out = (-away * along[1], away * along[0])
        lines = ["T1M6", "S3000M3"]
        lead_in, lead_out = [], []
        if self.lead == "arc":
            middle = ((at[0] + to[0]) / 2, (at[1] + to[1]) / 2)
            begin = moved(middle, out, 7, along, -7)
            end = moved(middle, out, 7, along, 7)
            centre = moved(middle, out, 7, along, 0)
            approach = moved(middle, out, 13 if not self.is_inside else 10, along, -12 if not self.is_inside else -9)
            lead_in = [f"G1G{side}{self.point(begin)}D1F300."] + [self.arc(begin, middle, centre, away)]
            lead_out = [self.arc(middle, end, centre, away), "G1G40" + self.point(approach)]
            elements = [(middle, to, None), *elements[1:], (at, middle, None)]
        else:
            run = 12 if self.lead == "run-in" else 0
            begin = moved(at, along, -run)
            last_at, last_to, centre = elements[-1]
            end_along = unit(last_to[0] - last_at[0], last_to[1] - last_at[1])
            approach = moved(begin, out, 22, along, -14)
            lead_in = [f"G1G{side}{self.point(begin)}D1F300."]
            lead_out = ["G1G40" + self.point(moved(approach, out, 3))]
            elements[0] = (begin, to, None)
            if not centre and run:
                elements[-1] = (last_at, moved(last_to, end_along, run), None)
        lines += ["G90G54G0" + self.point(approach), "G43H1Z5.", "G1Z-4.F100.", *lead_in]
        for begin, end, centre in elements:
            lines.append(self.arc(begin, end, centre, 0) if centre else "G1" + self.point(end))
        lines += [*lead_out, "G0Z5."]
        if self.has_numbers:
            lines = [f"N{10 * place + 10}{line}" for place, line in enumerate(lines)]
        return "\n".join(["O1", *lines, "M30"]) + "\n"

    def arc(self, begin, end, centre, turn):
        if turn == 0:
            turn = 1 if cross(begin, end, centre) > 0 else -1
        code = "G3" if turn > 0 else "G2"
        if self.has_radii:
            return f"{code}{self.point(end)}R{number(round(math.hypot(begin[0] - centre[0], begin[1] - centre[1]), 3))}"
        return "{}{}I{}J{}".format(code, self.point(end), *(number(round(c - b, 3) + 0.0) for b, c in zip(begin, centre)))

    point = staticmethod(LinedPocket.point)


def unit(x, y):
    length = math.hypot(x, y)
    return x / length, y / length


def moved(point, *ways):
    for (x, y), by in zip(ways[::2], [*ways[1::2]] if len(ways) % 2 == 0 else [0]):
        point = (point[0] + by * x, point[1] + by * y)
    return point


def cross(begin, end, centre):
    return (begin[0] - centre[0]) * (end[1] - centre[1]) - (begin[1] - centre[1]) * (end[0] - centre[0])


def random_profile_edit(chance, part):
    x, y, width, height = part.x, part.y, part.width, part.height
    wide, high = width + chance.randint(-8, 12), height + chance.randint(-8, 12)
    bent = [[x, y], [x + width, y], [x + width, y + 18], [x + 25, y + 18], [x + 25, y + height], [x, y + height]]
    slanted = [[x, y], [x + wide, y + chance.randint(-5, 9)], [x + width, y + high], [x + 3, y + height]]
    rounded = [[x, y], [x + width, y], [x + width, y + height - 8, math.tan(math.pi / 8)], [x + width - 8, y + height], [x, y + height]]
    return chance.choice([
        {"op": "replace", "contour": [[x, y], [x + wide, y], [x + wide, y + high], [x, y + high]]},
        {"op": "replace", "contour": bent},
        {"op": "replace", "contour": slanted},
        {"op": "replace", "contour": rounded},
        {"op": "fillet", "corner": chance.randint(0, 3), "r": chance.randint(5, 9)},
        {"op": "fillet-all", "r": chance.randint(5, 9)},
        {"op": "chamfer", "corner": chance.randint(0, 3), "d1": chance.randint(2, 7), "d2": chance.randint(2, 7)},
        {"op": "chamfer-all", "d1": 3, "d2": 3},
        {"op": "move", "dx": chance.randint(-9, 9), "dy": chance.randint(-9, 9)},
        {"op": "rotate", "deg": chance.choice([30, 45, 90, 17.5, 180])},
        {"op": "scale", "factor": chance.choice([0.9, 1.1, 1.23])},
        {"op": "depth", "z": -chance.randint(1, 9)},
        {"op": "feed", "cut": chance.randint(100, 900)},
    ])


class TurnedShape:
    """A shaft from a bar by G71 and G70, or by passes in long hand and a finishing cut along its contour."""
    words = ["--machine", "lathe2", "--tools", "tools.toml", "--stock", "bar:80,-120,0"]
    tools = '[[tool]]\nnumber = 1\ntype = "turning"\nnose_radius = 0\ntip = 3\nkapr = 95\ntip_angle = 80\nic = 40\n'
    refusals = MAY_BE_REFUSED
    layers = 1

    def __init__(self, chance):
        self.has_cycle = chance.random() < 0.6
        self.has_radii = chance.random() < 0.5
        self.has_numbers = not self.has_cycle and chance.random() < 0.4
        self.steps = []  # (diameter, z behind it, how it goes on: shoulder, taper, arc in, arc out)
        x, z = 2 * chance.randint(8, 12), 0
        for _ in range(chance.randint(2, 4)):
            z -= chance.randint(10, 18)
            self.steps.append((x, z, chance.choice(["shoulder", "shoulder", "taper", "in", "out"])))
            x += 2 * chance.randint(4, 6)

    def elements(self):
        """(z, x, centre z, centre x or None): where each ends; from Z0."""
        elements = []
        for place, (x, z, how) in enumerate(self.steps):
            wide = self.steps[place + 1][0] if place + 1 < len(self.steps) else 80
            rise = (wide - x) / 2
            if how in ("shoulder", "taper") or wide == 80 or rise > 6:
                elements += [(z, x, None)]
                elements += [(z - 3, wide, None)] if how == "taper" and wide < 80 else [(z, wide, None)]
            elif how == "in":
                elements += [(z + rise, x, None), (z, wide, (z + rise, wide))]
            else:
                elements += [(z, x, None), (z - rise, wide, (z - rise, x))]
        return elements

    def path(self, start):
        """Blocks along the contour; each with what comes before its words."""
        at, blocks = (start, self.steps[0][0]), []
        for z, x, centre in self.elements():
            to = (z, 86 if x == 80 else x)
            words = "".join(letter + number(new) for letter, new, old in zip("XZ", (to[1], to[0]), (at[1], at[0])) if new != old)
            if centre is None:
                blocks.append("G01" + words)
            else:
                turn = (at[0] - centre[0]) * (to[1] - centre[1]) - (at[1] - centre[1]) * (to[0] - centre[0])
                code = "G03" if turn > 0 else "G02"
                middle = f"R{number(abs(to[0] - at[0]))}" if self.has_radii else \
                    f"I{number((centre[1] - at[1]) / 2 + 0.0)}K{number(centre[0] - at[0] + 0.0)}"
                blocks.append(code + words + middle)
            at = to
        return blocks

    def text(self):
        first = f"G00X{number(self.steps[0][0])}"
        path = self.path(2)
        path[0] += "F0.12"
        head = ["O1", "T0101", "G97S900M03", "G00X82.Z2."]
        if self.has_cycle:
            lines = [*head, "G71U2.R0.5", "G71P10Q20U0.4W0.1F0.25", "N10" + first, *path[:-1], "N20" + path[-1], "G70P10Q20"]
        else:
            lines = [*head, *self.passes(), first, *path, "G00Z2."]
        if self.has_numbers:
            lines = [lines[0], *(f"N{5 * place + 5}{line}" for place, line in enumerate(lines[1:]))]
        return "\n".join([*lines, "G00X100.Z50.", "M30"]) + "\n"

    def passes(self):
        x = 80 - 4
        while x > self.steps[0][0]:
            z = max(self.end_of_pass(x), -115)
            yield f"G00X{number(x)}"
            yield f"G01Z{number(round(z + 0.2, 3))}F0.25"
            yield f"G00X{number(x + 2)}Z2."
            x -= 4

    def end_of_pass(self, x):
        """Where the contour has a diameter, from the front."""
        at = (2, self.steps[0][0])
        for z, to, centre in self.elements():
            if min(at[1], to) < x <= max(at[1], to):
                if centre is None:
                    return at[0] + (z - at[0]) * (x - at[1]) / (to - at[1])
                radius = abs(z - at[0])
                far = math.sqrt(max(0.0, radius ** 2 - ((x - centre[1]) / 2) ** 2))
                return centre[0] + far if centre[0] < max(at[0], z) else centre[0] - far
            at = (z, to)
        return at[0]


def random_turned_edit(chance, part):
    x, z, _ = part.steps[0]
    contour = [[0, x], [z, x], [z, x + 6], [z - 4, x + 10], [part.steps[-1][1], x + 10], [part.steps[-1][1], 80]]
    return chance.choice([
        {"op": "fillet", "corner": chance.randint(1, 3), "r": chance.choice([0.8, 1, 2, 3])},
        {"op": "chamfer", "corner": chance.randint(1, 3), "d1": 1, "d2": 1},
        {"op": "fillet-all", "r": chance.choice([0.5, 1])},
        {"op": "chamfer-all", "d1": 0.5, "d2": 0.5},
        {"op": "modify-line", "element": 0, "from": [0, x + 4], "to": [z, x + 4]},
        {"op": "modify-line", "element": 0, "from": [0, x - 4], "to": [z, x - 4]},
        {"op": "replace", "contour": contour},
    ])


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
