#!/usr/bin/env python3
"""Writes bracket.nc to standard output, the way a CAM system writes a part: no variables, no
loops, some thousand numbered blocks, words left out where nothing changes. Every run writes the
same bytes.

usage: generate.py > bracket.nc
"""

import math
import sys
from dataclasses import dataclass

LENGTH, WIDTH, THICKNESS = 140.0, 90.0, 20.0  # the part; X0 Y0 lower left, Z0 its top
STOCK_TOP = 1.5
CORNER = 12.0
SAFE, CLEARANCE = 25.0, 2.0

POCKET_CENTRE = (48.0, 45.0)
POCKET_SIZE = (72.0, 50.0)
POCKET_CORNER = 9.0
POCKET_DEPTH = 12.0

GRIP_CENTRE = (114.0, 45.0)  # the freeform area
GRIP_SIZE = (34.0, 56.0)
GRIP_WAVE = 28.0

SCREWS = ((10.0, 10.0), (130.0, 10.0), (130.0, 80.0), (10.0, 80.0))
PINS = ((70.0, 10.0), (70.0, 80.0))


@dataclass(frozen=True)
class Tool:
    number: int
    diameter: float
    speed: int
    name: str

    @property
    def radius(self) -> float:
        return self.diameter / 2


FACE_MILL = Tool(1, 50.0, 3200, "FACE MILL")
ROUGHING = Tool(2, 12.0, 8000, "END MILL, ROUGHING")
FINISHING = Tool(3, 10.0, 9500, "END MILL, FINISHING")
SPOT = Tool(4, 10.0, 3000, "SPOT DRILL")
DRILL = Tool(5, 6.8, 3700, "DRILL")
TAP = Tool(6, 8.0, 600, "TAP M8 X 1.25")
PIN_DRILL = Tool(7, 5.8, 4100, "DRILL")
REAMER = Tool(8, 6.0, 900, "REAMER H7")
BALL = Tool(9, 8.0, 14000, "BALL NOSE")
TOOLS = (FACE_MILL, ROUGHING, FINISHING, SPOT, DRILL, TAP, PIN_DRILL, REAMER, BALL)


def word(letter: str, value: float) -> str:
    """At most three decimals, always a decimal point: X12. Y0.5 Z-3.125"""
    text = f"{value:.3f}".rstrip("0")
    return letter + ("0." if text == "-0." else text)


class Post:
    """Numbers the blocks and leaves out the words that would only repeat the last ones."""

    def __init__(self):
        self.lines = []
        self.number = 0
        self.known = {}  # address -> its last word; "G" -> the motion code in force

    def comment(self, text: str) -> None:
        self.lines.append(f"({text})")

    def block(self, *words: str) -> None:
        self.number += 10
        self.lines.append(" ".join([f"N{self.number}", *words]))

    def forget(self) -> None:
        self.known.clear()

    def move(self, code: str, before=(), feed=None, extra=(), **axes: float) -> None:
        words = list(before)
        if self.known.get("G") != code:
            words.append(code)
        moved = False
        for letter, value in axes.items():
            text = word(letter, value)
            if self.known.get(letter) != text:
                words.append(text)
                moved = True
            self.known[letter] = text
        if not moved and not extra:
            return  # goes nowhere
        words.extend(extra)
        if feed is not None and self.known.get("F") != feed:
            words.append(word("F", feed))
            self.known["F"] = feed
        self.known["G"] = code
        self.block(*words)

    def rapid(self, **axes: float) -> None:
        self.move("G00", **axes)

    def line(self, feed: float, before=(), **axes: float) -> None:
        self.move("G01", before=before, feed=feed, **axes)

    def arc(self, code: str, feed: float, i: float, j: float, **axes: float) -> None:
        self.move(code, feed=feed, extra=(word("I", i), word("J", j)), **axes)

    def start(self, tool: Tool, title: str, x: float, y: float, following: Tool) -> None:
        """Calls the tool and goes above x, y; the magazine gets `following` ready."""
        self.forget()
        self.lines.append("")
        self.comment(title)
        self.block(f"T{tool.number} M06")
        self.comment(f"T{tool.number} D={tool.diameter:g} {tool.name}")
        self.block(f"T{following.number}")
        self.block(f"S{tool.speed} M03")
        self.block("G54 M08")
        self.rapid(X=x, Y=y)
        self.block("G43", word("Z", SAFE), f"H{tool.number}")
        self.known["Z"] = word("Z", SAFE)

    def carry_on(self, title: str, x: float, y: float) -> None:
        """The next operation of the same tool, from above x, y."""
        self.rapid(Z=SAFE)
        self.comment(title)
        self.rapid(X=x, Y=y)

    def finish(self) -> None:
        self.rapid(Z=SAFE)
        self.block("M09")
        self.block("M05")
        self.block("G49 G53 G00 Z0.")
        self.block("M01")
        self.forget()


def face(post: Post) -> None:
    edge = FACE_MILL.radius + 5.0
    rows = [12.0, WIDTH / 2, WIDTH - 12.0]
    post.start(FACE_MILL, "FACE", -edge, rows[0], ROUGHING)
    for z in (0.5, 0.0):
        post.rapid(X=-edge, Y=rows[0])
        post.rapid(Z=STOCK_TOP + CLEARANCE)
        post.line(1500.0, Z=z)
        x = -edge
        for y in rows:
            post.line(1800.0, Y=y)
            x = LENGTH + edge if x < 0 else -edge
            post.line(1800.0, X=x)
        post.rapid(Z=STOCK_TOP + CLEARANCE)
    post.finish()


def outline(post: Post, offset: int, z: float, feed: float, out: float) -> None:
    """Once around the part, clockwise, in and out on an arc; `out` is kept as allowance."""
    left, right = -out, LENGTH + out
    low, high, corner, lead = -out, WIDTH + out, CORNER + out, 10.0
    middle = WIDTH / 2
    post.rapid(X=left - 2 * lead - 6, Y=middle)
    post.rapid(Z=z)
    post.line(feed, before=("G41",), X=left - lead, Y=middle - lead)
    post.lines[-1] += f" D{offset}"
    post.arc("G03", feed, 0, lead, X=left, Y=middle)
    post.line(feed, Y=high - corner)
    post.arc("G02", feed, corner, 0, X=left + corner, Y=high)
    post.line(feed, X=right - corner)
    post.arc("G02", feed, 0, -corner, X=right, Y=high - corner)
    post.line(feed, Y=low + corner)
    post.arc("G02", feed, -corner, 0, X=right - corner, Y=low)
    post.line(feed, X=left + corner)
    post.arc("G02", feed, 0, corner, X=left, Y=low + corner)
    post.line(feed, Y=middle)
    post.arc("G03", feed, -lead, 0, X=left - lead, Y=middle + lead)
    post.line(feed, before=("G40",), X=left - 2 * lead - 6, Y=middle)


def roughing(post: Post) -> None:
    post.start(ROUGHING, "OUTLINE, ROUGHING", -26.3, WIDTH / 2, FINISHING)
    for z in (-5.0, -10.0, -15.0, -20.5):
        outline(post, ROUGHING.number, z, 2200.0, 0.3)
    clearing(post)
    post.finish()


def clearing(post: Post) -> None:
    """The pocket in two depths: down on a helix, out on a spiral of quarter circles, then peeling
    cuts that turn from half circles into the straight end walls; each goes back on a small arc."""
    allowance, link, step, feed, back = 0.3, 2.0, 1.6, 2600.0, 6000.0
    cx, cy = POCKET_CENTRE
    half_x = POCKET_SIZE[0] / 2 - ROUGHING.radius - allowance
    half_y = POCKET_SIZE[1] / 2 - ROUGHING.radius - allowance
    reach = half_y - link
    helix = 4.0
    post.carry_on("POCKET, CLEARING", cx + helix, cy)
    top = 0.5
    post.rapid(Z=CLEARANCE)
    for bottom in (-POCKET_DEPTH / 2, -POCKET_DEPTH + 0.2):
        post.rapid(X=cx + helix, Y=cy)
        post.rapid(Z=top + 1)
        post.line(1000.0, Z=top)
        turns = math.ceil((top - bottom) / 1.0)
        for turn in range(turns):
            for half, x in ((0.5, -helix), (1.0, helix)):
                z = top + (bottom - top) * (turn + half) / turns
                post.arc("G03", 1200.0, x, 0, X=cx + x, Y=cy, Z=z)
        post.arc("G03", 1200.0, -helix, 0)

        # Quarter circles about centres that move: the radius grows by step / 4 each.
        radius, (px, py), quarter = helix, (cx + helix, cy), 0
        while radius < reach:
            grown = min(radius + step / 4, reach)
            inward = ((-1, 0), (0, -1), (1, 0), (0, 1))[quarter % 4]
            onward = ((0, 1), (-1, 0), (0, -1), (1, 0))[quarter % 4]
            mx, my = px + inward[0] * grown, py + inward[1] * grown
            nx, ny = mx + onward[0] * grown, my + onward[1] * grown
            post.arc("G03", feed, mx - px, my - py, X=nx, Y=ny)
            radius, (px, py), quarter = grown, (nx, ny), quarter + 1
        post.line(feed, X=cx + reach, Y=cy)
        post.arc("G03", feed, -reach, 0)

        for side in (1, -1):  # to the right, then the same turned by 180 degrees
            peel(post, side, half_x, reach, link, step, bottom, feed, back)

        post.line(back, Z=bottom + 0.3)  # the wall once around, at full width of the allowance
        x, y = half_x, half_y
        corner = POCKET_CORNER - ROUGHING.radius - allowance
        post.line(back, X=cx, Y=cy - y + 3)
        post.line(1000.0, Z=bottom)
        post.arc("G03", feed, 0, -1.5, X=cx, Y=cy - y)
        post.line(feed, X=cx + x - corner)
        post.arc("G03", feed, 0, corner, X=cx + x, Y=cy - y + corner)
        post.line(feed, Y=cy + y - corner)
        post.arc("G03", feed, -corner, 0, X=cx + x - corner, Y=cy + y)
        post.line(feed, X=cx - x + corner)
        post.arc("G03", feed, 0, -corner, X=cx - x, Y=cy + y - corner)
        post.line(feed, Y=cy - y + corner)
        post.arc("G03", feed, corner, 0, X=cx - x + corner, Y=cy - y)
        post.line(feed, X=cx)
        post.arc("G03", feed, 0, 1.5, X=cx, Y=cy - y + 3)
        post.rapid(Z=CLEARANCE)
        top = bottom + 0.5


def peel(post: Post, side: int, half_x: float, reach: float, link: float, step: float,
         bottom: float, feed: float, back: float) -> None:
    """Cuts from the circle of radius `reach` to the end wall at `half_x`; side -1 mirrors through
    the centre of the pocket."""
    cx, cy = POCKET_CENTRE

    def at(x: float, y: float) -> dict:
        return {"X": cx + side * x, "Y": cy + side * y}

    count = math.ceil((half_x - link) / step)
    for k in range(1, count + 1):
        edge = (half_x - link) * k / count  # x where the cut begins and ends, y = -+ reach
        bulge = reach * (1 - k / count) + link * k / count
        radius = (reach * reach + bulge * bulge) / (2 * bulge)
        centre = edge + bulge - radius
        heading = math.atan2(-reach, edge - centre) + math.pi / 2  # at the start of the cut

        # In on an arc of radius `link` that turns from straight down to the heading of the cut.
        normal = (-math.sin(heading), math.cos(heading))
        in_centre = (edge + link * normal[0], -reach + link * normal[1])
        in_start = (in_centre[0] - link, in_centre[1])
        post.line(back, Z=bottom + 0.3)
        post.line(back, **at(*in_start))
        post.arc("G03", feed, side * link, 0, **at(edge, -reach), Z=bottom)
        post.arc("G03", feed, side * (centre - edge), side * reach, **at(edge, reach))
        # Out on its mirror image.
        out = (in_start[0], -in_start[1])
        post.arc("G03", back, side * link * normal[0], side * -link * normal[1], **at(*out),
                 Z=bottom + 0.3)


def walls(post: Post) -> None:
    cx, cy = POCKET_CENTRE
    x, y, corner, lead = POCKET_SIZE[0] / 2, POCKET_SIZE[1] / 2, POCKET_CORNER, 8.0
    post.start(FINISHING, "POCKET, WALLS AND OUTLINE, FINISHING", cx, cy, SPOT)
    post.rapid(Z=CLEARANCE)
    post.line(1500.0, Z=-POCKET_DEPTH)
    for ring in (2.0, 8.0, 14.0):  # the floor
        wide = x - y + ring
        post.line(1500.0, X=cx + wide, Y=cy - ring)
        post.line(1500.0, Y=cy + ring)
        post.line(1500.0, X=cx - wide)
        post.line(1500.0, Y=cy - ring)
        post.line(1500.0, X=cx + wide)
    post.line(1500.0, X=cx, Y=cy - y + 2 * lead)
    post.line(1200.0, before=("G41",), X=cx - lead, Y=cy - y + lead)
    post.lines[-1] += f" D{FINISHING.number}"
    post.arc("G03", 1200.0, lead, 0, X=cx, Y=cy - y)
    post.line(1200.0, X=cx + x - corner)
    post.arc("G03", 1200.0, 0, corner, X=cx + x, Y=cy - y + corner)
    post.line(1200.0, Y=cy + y - corner)
    post.arc("G03", 1200.0, -corner, 0, X=cx + x - corner, Y=cy + y)
    post.line(1200.0, X=cx - x + corner)
    post.arc("G03", 1200.0, 0, -corner, X=cx - x, Y=cy + y - corner)
    post.line(1200.0, Y=cy - y + corner)
    post.arc("G03", 1200.0, corner, 0, X=cx - x + corner, Y=cy - y)
    post.line(1200.0, X=cx)
    post.arc("G03", 1200.0, 0, lead, X=cx + lead, Y=cy - y + lead)
    post.line(1200.0, before=("G40",), X=cx, Y=cy - y + 2 * lead)
    post.rapid(Z=SAFE)
    outline(post, FINISHING.number, -THICKNESS - 0.5, 1400.0, 0.0)
    post.finish()


def drilling(post: Post, tool: Tool, title: str, places: tuple, cycle: str, words: tuple,
             following: Tool, before: tuple = ()) -> None:
    post.start(tool, title, *places[0], following)
    for text in before:
        post.block(text)
    x, y = places[0]
    post.block("G98", cycle, word("X", x), word("Y", y), *words)
    for x, y in places[1:]:
        post.block(word("X", x), word("Y", y))
    post.block("G80")
    post.forget()
    post.finish()


def grip_height(x: float, y: float) -> tuple:
    """Height of the freeform area and its slopes along X and Y; x, y from its centre."""
    u, v = 2 * math.pi * y / GRIP_WAVE, math.pi * x / GRIP_SIZE[0]
    depth = -2.6 - 1.4 * math.cos(u)
    return (depth * math.cos(v) ** 2,
            depth * -2 * math.cos(v) * math.sin(v) * math.pi / GRIP_SIZE[0],
            1.4 * math.sin(u) * 2 * math.pi / GRIP_WAVE * math.cos(v) ** 2)


def grip_tip(x: float, y: float) -> tuple:
    """Tip of the ball where it touches the surface above x, y."""
    z, along_x, along_y = grip_height(x, y)
    length = math.sqrt(along_x ** 2 + along_y ** 2 + 1)
    r = BALL.radius
    return (GRIP_CENTRE[0] + x - r * along_x / length, GRIP_CENTRE[1] + y - r * along_y / length,
            z + r / length - r)


def thinned(points: list, tolerance: float) -> list:
    """The points that a polyline within `tolerance` of all of them needs (Douglas and Peucker)."""
    if len(points) < 3:
        return points
    a, b = points[0], points[-1]
    ab = [q - p for p, q in zip(a, b)]
    length = math.sqrt(sum(c * c for c in ab))

    def distance(p: tuple) -> float:
        ap = [q - s for s, q in zip(a, p)]
        t = sum(u * w for u, w in zip(ap, ab)) / (length * length)
        return math.sqrt(sum((u - t * w) ** 2 for u, w in zip(ap, ab)))

    far = max(range(1, len(points) - 1), key=lambda i: distance(points[i]))
    if distance(points[far]) <= tolerance:
        return [a, b]
    return thinned(points[:far + 1], tolerance)[:-1] + thinned(points[far:], tolerance)


def grip(post: Post) -> None:
    rows, samples = 48, 200
    half_x, half_y = GRIP_SIZE[0] / 2, GRIP_SIZE[1] / 2
    lines = []
    for row in range(rows + 1):
        x = -half_x + GRIP_SIZE[0] * row / rows
        line = [grip_tip(x, -half_y + GRIP_SIZE[1] * k / samples) for k in range(samples + 1)]
        line = thinned(line, 0.002)
        lines.append(line if row % 2 == 0 else line[::-1])
    post.start(BALL, "GRIP, FINISHING", *lines[0][0][:2], FACE_MILL)
    post.rapid(Z=CLEARANCE)
    for line in lines:
        for x, y, z in line:
            post.line(2400.0, X=x, Y=y, Z=z)
    post.finish()


def program() -> str:
    post = Post()
    post.lines += ["%", "O0009 (BRACKET)"]
    post.comment("STOCK 150 X 100 X 26, ALUMINIUM")
    post.comment("X0 Y0 LOWER LEFT CORNER OF THE PART, Z0 ITS TOP")
    for tool in TOOLS:
        post.comment(f"T{tool.number} D={tool.diameter:g} {tool.name}")
    post.block("G90 G94 G17 G40 G49 G80")
    post.block("G21")
    post.block("G53 G00 Z0.")
    face(post)
    roughing(post)
    walls(post)
    depth = (word("R", CLEARANCE),)
    drilling(post, SPOT, "ALL HOLES, SPOT DRILLING", SCREWS + PINS, "G82",
             (word("Z", -4.2), *depth, "P200", "F300."), DRILL)
    drilling(post, DRILL, "M8, DRILLING", SCREWS, "G83",
             (word("Z", -22.0), *depth, "Q4.", "F450."), TAP)
    drilling(post, TAP, "M8, TAPPING", SCREWS, "G84",
             (word("Z", -20.0), word("R", 5.0), "F750."), PIN_DRILL, before=("M29 S600",))
    drilling(post, PIN_DRILL, "PIN HOLES, DRILLING", PINS, "G73",
             (word("Z", -22.0), *depth, "Q3.", "F400."), REAMER)
    drilling(post, REAMER, "PIN HOLES, REAMING", PINS, "G85",
             (word("Z", -20.5), *depth, "F200."), BALL)
    grip(post)
    del post.lines[-1]  # M30 instead of the last M01
    post.number -= 10
    post.block("M30")
    post.lines.append("%")
    return "\n".join(post.lines) + "\n"


if __name__ == "__main__":
    sys.stdout.write(program())
