"""Parts of random_edits.py whose contours stand in their blocks: under G41 and G42, and turned ones; and random edits of them."""

import math

TOOLS = "".join(f'[[tool]]\nnumber = {number}\ntype = "flat"\ndiameter = {diameter}\n'
                for number, diameter in ((1, 10), (2, 8), (3, 6)))
MAY_BE_REFUSED = ("EDIT_TOOL_TOO_BIG", "EDIT_DOES_NOT_FIT")


def number(value):
    return f"{value:.3f}".rstrip("0")  # the point stays


def point(place):
    return "X{}Y{}".format(*(number(round(value, 3) + 0.0) for value in place))


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
            if elements[0][2]:
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
            lead_in = [f"G1G{side}{point(begin)}D1F300."] + [self.arc(begin, middle, centre, away)]
            lead_out = [self.arc(middle, end, centre, away), "G1G40" + point(approach)]
            elements = [(middle, to, None), *elements[1:], (at, middle, None)]
        else:
            run = 12 if self.lead == "run-in" else 0
            begin = moved(at, along, -run)
            last_at, last_to, centre = elements[-1]
            end_along = unit(last_to[0] - last_at[0], last_to[1] - last_at[1])
            approach = moved(begin, out, 22, along, -14)
            lead_in = [f"G1G{side}{point(begin)}D1F300."]
            lead_out = ["G1G40" + point(moved(approach, out, 3))]
            elements[0] = (begin, to, None)
            if not centre and run:
                elements[-1] = (last_at, moved(last_to, end_along, run), None)
        lines += ["G90G54G0" + point(approach), "G43H1Z5.", "G1Z-4.F100.", *lead_in]
        for begin, end, centre in elements:
            lines.append(self.arc(begin, end, centre, 0) if centre else "G1" + point(end))
        lines += [*lead_out, "G0Z5."]
        if self.has_numbers:
            lines = [f"N{10 * place + 10}{line}" for place, line in enumerate(lines)]
        return "\n".join(["O1", *lines, "M30"]) + "\n"

    def arc(self, begin, end, centre, turn):
        if turn == 0:
            turn = 1 if cross(begin, end, centre) > 0 else -1
        code = "G3" if turn > 0 else "G2"
        if self.has_radii:
            return f"{code}{point(end)}R{number(round(math.hypot(begin[0] - centre[0], begin[1] - centre[1]), 3))}"
        return "{}{}I{}J{}".format(code, point(end), *(number(round(c - b, 3) + 0.0) for b, c in zip(begin, centre)))



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
    x, z = part.steps[0][0], part.elements()[0][0]
    contour = [[0, x], [z, x], [z, x + 6], [z - 4, x + 10], [part.steps[-1][1], x + 10], [part.steps[-1][1], 80]]
    moves = [] if part.elements()[1][2] else [  # an arc would be turned, and cut behind its corner
        {"op": "modify-line", "element": 0, "from": [0, x + 4], "to": [z, x + 4]},
        {"op": "modify-line", "element": 0, "from": [0, x - 4], "to": [z, x - 4]},
    ]
    return chance.choice([
        *moves,
        {"op": "fillet", "corner": chance.randint(1, 3), "r": chance.choice([0.8, 1, 2, 3])},
        {"op": "chamfer", "corner": chance.randint(1, 3), "d1": 1, "d2": 1},
        {"op": "fillet-all", "r": chance.choice([0.5, 1])},
        {"op": "chamfer-all", "d1": 0.5, "d2": 0.5},
        {"op": "replace", "contour": contour},
    ])
