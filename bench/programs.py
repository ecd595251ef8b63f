#!/usr/bin/env python3
"""Writes the benchmark programs: the same bytes every time, from formulas and one fixed seed.

usage: programs.py OUTDIR [--scale S] [--only a,b] [--ten-million]

A program exists once per language that takes part: NAME.nc for Kerf (FANUC macro B), NAME.for.bas
and NAME.goto.bas for Kerf (laser BASIC), NAME.ngc for LinuxCNC (o-words), NAME.lua. Twins do the same work in the same order with the same numbers.
Millimetres throughout. --scale 0.01 makes every program a hundredth as long.
"""

import argparse
import math
import random
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Iterator, Optional

SEED = 5
MILLION = 1_000_000


@dataclass
class Expect:
    """What a run of a program must have done, counted while the program is written."""

    calls: Counter = field(default_factory=Counter)  # canonical calls by name, as rs274 prints them
    result: Optional[float] = None  # the value of `result_variable` at the end
    result_variable: str = ""
    cut_mm: Optional[float] = None  # length of all G01

    @property
    def cutting_moves(self) -> int:
        return self.calls["STRAIGHT_FEED"] + self.calls["ARC_FEED"]


@dataclass(frozen=True)
class Dialect:
    """The words in which the two G-code twins differ."""

    suffix: str
    opening: str
    closing: str
    dwell: Callable[[int], str]  # from milliseconds
    repeat: str  # the cycle word that drills a row of holes
    settings: tuple = ()  # blocks that set the tool lengths, where the program must do that

    def head(self, title: str) -> str:
        return f"{self.opening}({title})\nG21 G17 G90 G94 G40 G49 G80\n"


TOOL_LENGTHS = {number: 25.4 * (2 + number / 8) for number in range(1, 9)}


FANUC = Dialect(".nc", "%\nO1000\n", "M30\n%\n", lambda ms: f"P{ms}", "K",
                tuple(f"G10 L10 P{tool} R{length:.3f}" for tool, length in TOOL_LENGTHS.items()))
NGC = Dialect(".ngc", "", "M30\n", lambda ms: f"P{ms / 1000:g}", "L")


def tool_table() -> str:
    """LinuxCNC's tool table. Without a configuration rs274 reads its lengths as inches."""
    rows = (f"T{tool} P{tool} Z{length / 25.4:g} D0.25\n" for tool, length in TOOL_LENGTHS.items())
    return "".join(rows)


def number(value: float) -> str:
    """At most three decimals, always a decimal point: 12. 0.5 -3.125"""
    text = f"{value:.3f}".rstrip("0")
    return "0." if text == "-0." else text


# (a) Finishing: short lines along a spiral over a wavy surface.


def spiral(count: int) -> Iterator[tuple]:
    """Points about `step` apart on a flat spiral; the height is a product of two waves."""
    step, pitch = 0.1, 0.2
    for i in range(count):
        angle = math.sqrt(4 * math.pi * step * i / pitch)
        radius = pitch * angle / (2 * math.pi)
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        z = -6 + 2.75 * math.sin(x / 9) * math.cos(y / 13)
        yield round(x, 3), round(y, 3), round(z, 3)


def write_finishing(path: Path, dialect: Dialect, lines: int) -> Expect:
    return write_points(path, dialect, "SPIRAL FINISHING", lines, spiral(lines))


def write_points(path: Path, dialect: Dialect, title: str, lines: int,
                 points: Iterator[tuple]) -> Expect:
    place, cut_mm = (0.0, 0.0, 5.0), 0.0
    with path.open("w", newline="\n") as file:
        file.write(dialect.head(title) + "S12000 M03\nG00 X0. Y0. Z5.\nF3000.\n")
        for point in points:
            file.write("G01 X%.3f Y%.3f Z%.3f\n" % point)
            cut_mm += math.dist(place, point)
            place = point
        file.write("G00 Z5.\nM05\n" + dialect.closing)
    return Expect(Counter(STRAIGHT_FEED=lines), cut_mm=cut_mm)


# (s) Sharp: the height jumps from point to point, so nothing is smooth.


def jumps(count: int) -> Iterator[tuple]:
    """Rows of 1,001 points 0.1 mm apart; each turn from line to line is a corner."""
    row = 1001
    for i in range(count):
        column = i % row if i // row % 2 == 0 else row - 1 - i % row
        z = -5 - i * 7919 % 997 / 997 * 0.4
        yield round(0.1 * column - 50, 3), round(0.1 * (i // row) - 50, 3), round(z, 3)


def write_sharp(path: Path, dialect: Dialect, lines: int) -> Expect:
    return write_points(path, dialect, "JUMPING SURFACE", lines, jumps(lines))


# (b) Mixed: small workshop features one after the other.


class Feature:
    """The blocks of one feature, with a count of the canonical calls that they must make."""

    def __init__(self, dialect: Dialect):
        self.dialect = dialect
        self.blocks = []
        self.calls = Counter()

    def add(self, *codes: str, **words: float) -> None:
        values = [letter + number(value) for letter, value in words.items()]
        self.blocks.append(" ".join([*codes, *values]))

    def rapid(self, **words: float) -> None:
        self.add("G00", **words)

    def line(self, **words: float) -> None:
        self.add("G01", **words)
        self.calls["STRAIGHT_FEED"] += 1

    def arc(self, code: str, **words: float) -> None:
        self.add(code, **words)
        self.calls["ARC_FEED"] += 1

    def dwell(self, milliseconds: int) -> None:
        self.add("G04", self.dialect.dwell(milliseconds))
        self.calls["DWELL"] += 1

    def approach(self, x: float, y: float, z: float, feed: float) -> None:
        self.rapid(X=x, Y=y)
        self.rapid(Z=2)
        self.line(Z=z, F=feed / 4)

    def retract(self) -> None:
        self.rapid(Z=5)


@dataclass(frozen=True)
class Site:
    """Where a feature lies and how fast it is cut."""

    index: int
    x: float
    y: float
    feed: float


def around(at: Site, radius: float, turn: float) -> tuple:
    angle = 2 * math.pi * turn
    return round(at.x + radius * math.cos(angle), 3), round(at.y + radius * math.sin(angle), 3)


def pocket(f: Feature, at: Site) -> None:
    """Rounded rectangles inside one another: quarter circles by their centres."""
    for ring in range(3):
        r, a, b = 2 + ring, 6 + 4 * ring, 3 + 4 * ring
        left, right, low, high = at.x - a, at.x + a, at.y - b, at.y + b
        f.approach(left + r, low, -1 - ring / 2, at.feed)
        f.line(X=right - r, F=at.feed + 10 * ring)
        f.arc("G03", X=right, Y=low + r, I=0, J=r)
        f.line(Y=high - r)
        f.arc("G03", X=right - r, Y=high, I=-r, J=0)
        f.line(X=left + r)
        f.arc("G03", X=left, Y=high - r, I=0, J=-r)
        f.line(Y=low + r)
        f.arc("G03", X=left + r, Y=low, I=r, J=0)
        f.retract()


def bore(f: Feature, at: Site) -> None:
    """Down a helix a turn at a time, a full circle at the bottom, back to the middle."""
    r = 4 + at.index % 5 / 2
    f.approach(at.x + r, at.y, 0, at.feed)
    for turn in range(1, 5):
        f.arc("G02", X=at.x + r, Y=at.y, Z=-0.75 * turn, I=-r, J=0, F=at.feed - 5 * turn)
    f.arc("G02", I=-r, J=0)
    f.arc("G02", X=at.x, Y=at.y, I=-r / 2, J=0)
    f.retract()


def flower(f: Feature, at: Site) -> None:
    """Petals by radius: the short way, or with a negative radius the long way round."""
    petals, size = 6, 12
    corners = [around(at, size, k / petals) for k in range(petals + 1)]
    f.approach(*corners[0], -2, at.feed)
    for k, (x, y) in enumerate(corners[1:]):
        radius = 9 if k % 2 else -7.5
        f.arc("G03" if k % 3 else "G02", X=x, Y=y, R=radius, F=at.feed + k)
    f.retract()


def ridge(f: Feature, at: Site) -> None:
    """Arcs that stand upright: in ZX by centre, in YZ by radius."""
    f.approach(at.x, at.y, -3, at.feed)
    f.add("G18")
    f.arc("G03", X=at.x + 8, Z=-3, I=4, K=0, F=at.feed)
    f.arc("G02", X=at.x + 14, Z=-3, I=3, K=0)
    f.line(Y=at.y + 1)
    f.arc("G02", X=at.x, Z=-3, R=11)
    f.add("G19")
    f.arc("G02", Y=at.y + 9, Z=-3, R=5)
    f.arc("G03", Y=at.y + 15, Z=-3, J=3, K=0)
    f.add("G17")
    f.retract()


def stairs(f: Feature, at: Site) -> None:
    """Steps relative to one another, each with its own feed and a rounded edge."""
    f.approach(at.x, at.y, -1, at.feed)
    f.add("G91")
    for step in range(5):
        f.line(X=1.5, Y=0.25 * step, F=at.feed + 20 * step)
        f.arc("G02", X=0.5, Y=-0.5, I=0, J=-0.5)
        f.line(Z=-0.125)
    f.add("G90")
    f.retract()


def engraving(f: Feature, at: Site) -> None:
    """Short straight pieces of a closed figure of two sines."""
    pieces = 24
    f.approach(at.x, at.y, -0.2, at.feed)
    for k in range(1, pieces + 1):
        turn = 2 * math.pi * k / pieces
        f.line(X=at.x + 7 * math.sin(2 * turn), Y=at.y + 5 * math.sin(3 * turn))
    f.retract()


def holes(f: Feature, at: Site) -> None:
    """A row of five: plain, with a dwell or with pecks, returning to either plane."""
    row = at.index // len(FEATURES)
    cycle = ("G81", "G82", "G83")[row % 3]
    f.rapid(X=at.x, Y=at.y)
    f.rapid(Z=5)
    start = ["G98" if row % 2 else "G99", cycle]
    start += [f.dialect.dwell(150)] if cycle == "G82" else []
    peck = {"Q": 3} if cycle == "G83" else {}
    f.add(*start, X=at.x + 5, Y=at.y, Z=-8, R=2, **peck, F=at.feed / 3)
    for k in range(2, 6):
        f.add(X=at.x + 5 * k, Y=at.y + k % 2)
    f.add("G80")
    f.calls["STRAIGHT_FEED"] += 5 * (4 if cycle == "G83" else 1)
    f.calls["DWELL"] += 5 if cycle == "G82" else 0
    f.retract()


def hole_row(f: Feature, at: Site) -> None:
    """Four holes from one block: relative, repeated."""
    f.rapid(X=at.x, Y=at.y)
    f.rapid(Z=5)
    f.add("G91 G99 G81", f.dialect.repeat + "4", X=6, Y=1, Z=-7, R=-3, F=at.feed / 3)
    f.add("G90 G80")
    f.calls["STRAIGHT_FEED"] += 4
    f.retract()


def tool_change(f: Feature, at: Site) -> None:
    tool = 1 + at.index // CHANGE_EVERY % len(TOOL_LENGTHS)
    f.rapid(Z=50)
    f.add("M05")
    f.add(f"T{tool} M06")
    f.add(f"S{4000 + 500 * tool} M03")
    f.dwell(500)
    f.add(f"G43 H{tool}", Z=50)
    f.retract()
    f.calls["CHANGE_TOOL"] += 1


FEATURES = (pocket, bore, flower, ridge, stairs, engraving, holes, hole_row)
CHANGE_EVERY = 40


def features(dialect: Dialect) -> Iterator[Feature]:
    """Without end; both dialects get the same places and feeds."""
    rng = random.Random(SEED)
    index = 0
    while True:
        at = Site(index, rng.randrange(200_000) / 1000, rng.randrange(150_000) / 1000,
                  300 + 5 * rng.randrange(100))
        shape = FEATURES[index % len(FEATURES)]
        feature = Feature(dialect)
        if index % CHANGE_EVERY == 0:
            tool_change(feature, at)
        feature.blocks.append(f"({shape.__name__.upper().replace('_', ' ')} {index})")
        shape(feature, at)
        yield feature
        index += 1


def write_mixed(path: Path, dialect: Dialect, lines: int) -> Expect:
    """Whole features as long as they fit, then single moves up to exactly `lines` blocks."""
    calls, left = Counter(), lines
    with path.open("w", newline="\n") as file:
        file.write(dialect.head("MIXED FEATURES"))
        file.writelines(block + "\n" for block in dialect.settings)
        for feature in features(dialect):
            if len(feature.blocks) > left:
                break
            file.writelines(block + "\n" for block in feature.blocks)
            left -= len(feature.blocks)
            calls += feature.calls
        file.writelines(f"G00 X{number(k / 8)} Y{number(k % 2)}\n" for k in range(left))
        file.write("M05\n" + dialect.closing)
    return Expect(calls)


# (c), (d) A loop of arithmetic, without and with a move. (e) Macro calls.

LOOP_NC = """\
#1=0
#3=0
WHILE[#1LT{passes}]DO1
#2=SIN[#1]*COS[#1]
#3=#3+SQRT[#2*#2+1]
{move}#1=#1+1
END1
"""
LOOP_NGC = """\
#1=0
#3=0
o100 while [#1 LT {passes}]
#2=[SIN[#1]*COS[#1]]
#3=[#3+SQRT[#2*#2+1]]
{move}#1=[#1+1]
o100 endwhile
(debug,#3)
"""
LOOP_LUA = """\
local sin, cos, rad, sqrt = math.sin, math.cos, math.rad, math.sqrt
local a, b, c = 0.0, 0.0, 0.0
while a < {passes} do
  b = sin(rad(a)) * cos(rad(a))
  c = c + sqrt(b * b + 1)
  a = a + 1
end
print(string.format("%.17g", c))
"""
LOOP_FOR = """\
LET C=0
FOR A=0 TO {passes}-1
LET B=SIN(RAD(A))*COS(RAD(A))
LET C=C+SQR(B*B+1)
NEXT A
END
"""
LOOP_GOTO = """\
LET A=0
LET C=0
100 LET B=SIN(RAD(A))*COS(RAD(A))
LET C=C+SQR(B*B+1)
LET A=A+1
IF A<{passes} GOTO 100
END
"""
LOOP_TWINS = {".lua": LOOP_LUA, ".for.bas": LOOP_FOR, ".goto.bas": LOOP_GOTO}
MOVE = "G01 X[#1*0.001] Y[#2*10]\n"

CALLS_NC = """\
#1=0
#100=0
WHILE[#1LT{passes}]DO1
G65 P9001 A#1 B2.5 C#100
#1=#1+1
END1
M30
O9001
#4=#1*#2+#3
#100=#4*0.5
M99
%
"""
CALLS_NGC = """\
o9001 sub
#4=[#1*#2+#3]
#100=[#4*0.5]
o9001 endsub
#1=0
#100=0
o100 while [#1 LT {passes}]
o9001 call [#1] [2.5] [#100]
#1=[#1+1]
o100 endwhile
(debug,#100)
M30
"""


def loop_result(passes: int) -> float:
    c = 0.0
    for a in range(passes):
        b = math.sin(math.radians(a)) * math.cos(math.radians(a))
        c += math.sqrt(b * b + 1)
    return c


def calls_result(passes: int) -> float:
    value = 0.0
    for a in range(passes):
        value = (a * 2.5 + value) * 0.5
    return value


def loop_text(dialect: Dialect, passes: int, move: str) -> str:
    loop = LOOP_NC if dialect is FANUC else LOOP_NGC
    start = "G00 X-1. Y0. Z5.\nF3000.\n" if move else ""
    body = loop.format(passes=passes, move=move)
    return dialect.head("LOOP") + start + body + dialect.closing


def write_loop(path: Path, dialect: Dialect, passes: int) -> Expect:
    path.write_text(loop_text(dialect, passes, ""))
    return Expect(result=loop_result(passes), result_variable="#3")


def write_loop_with_move(path: Path, dialect: Dialect, passes: int) -> Expect:
    path.write_text(loop_text(dialect, passes, MOVE))
    return Expect(Counter(STRAIGHT_FEED=passes), loop_result(passes), "#3")


def write_calls(path: Path, dialect: Dialect, passes: int) -> Expect:
    text = CALLS_NC if dialect is FANUC else CALLS_NGC
    path.write_text(dialect.head("CALLS") + text.format(passes=passes))
    return Expect(result=calls_result(passes), result_variable="#100")


@dataclass(frozen=True)
class Benchmark:
    key: str
    name: str
    title: str
    size: int
    write: Callable[[Path, Dialect, int], Expect]
    twins: dict = field(default_factory=dict)  # texts by ending, in languages that are no G-code


BENCHMARKS = (
    Benchmark("a", "finishing", "1,000,000 short G01", MILLION, write_finishing),
    Benchmark("s", "sharp", "1,000,000 short G01, all of them sharp turns", MILLION, write_sharp),
    Benchmark("b", "mixed", "200,000 lines of mixed work", MILLION // 5, write_mixed),
    Benchmark("c", "loop", "1,000,000 passes of arithmetic", MILLION, write_loop, LOOP_TWINS),
    Benchmark("d", "loop_move", "1,000,000 passes with a G01", MILLION, write_loop_with_move),
    Benchmark("e", "calls", "200,000 G65 calls", MILLION // 5, write_calls),
)
TEN_MILLION = Benchmark("a10", "finishing_10m", "10,000,000 short G01", 10 * MILLION,
                        write_finishing)


def generate(benchmark: Benchmark, folder: Path, scale: float = 1, peers: bool = True) -> Expect:
    """Writes the program, and with `peers` its twins, as folder/NAME.nc, .ngc, .lua and so on."""
    size = max(1, int(benchmark.size * scale))
    expect = benchmark.write(folder / (benchmark.name + FANUC.suffix), FANUC, size)
    if peers:
        benchmark.write(folder / (benchmark.name + NGC.suffix), NGC, size)
    for suffix, text in benchmark.twins.items() if peers else ():
        (folder / (benchmark.name + suffix)).write_text(text.format(passes=size))
    return expect


def keys(text: str) -> list:
    """The value of --only: benchmark letters with commas between them."""
    chosen = text.split(",")
    known = [benchmark.key for benchmark in BENCHMARKS]
    unknown = [key for key in chosen if key not in known]
    if unknown:
        text = f"no benchmark {unknown[0]!r}; there are {', '.join(known)}"
        raise argparse.ArgumentTypeError(text)
    return chosen


def main() -> None:
    parser = argparse.ArgumentParser(description="Writes the benchmark programs.")
    parser.add_argument("outdir", type=Path)
    parser.add_argument("--scale", type=float, default=1)
    parser.add_argument("--only", type=keys, default=[b.key for b in BENCHMARKS])
    parser.add_argument("--ten-million", action="store_true", help="also the 300 MB program")
    options = parser.parse_args()

    options.outdir.mkdir(parents=True, exist_ok=True)
    (options.outdir / "tool.tbl").write_text(tool_table())
    for benchmark in BENCHMARKS:
        if benchmark.key in options.only:
            generate(benchmark, options.outdir, options.scale)
    if options.ten_million:
        generate(TEN_MILLION, options.outdir, options.scale, peers=False)


if __name__ == "__main__":
    main()
