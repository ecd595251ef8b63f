#!/usr/bin/env python3
"""Writes the benchmark programs: the same bytes every time, from formulas and one fixed seed.

usage: programs.py OUTDIR [--scale S] [--only a,b] [--ten-million]

A program exists once per language that takes part: NAME.nc for Kerf (FANUC macro B), NAME.for.bas
and NAME.goto.bas for Kerf (laser BASIC), NAME.ngc for LinuxCNC (o-words), NAME.lua. Twins do the same work in the same order with the same numbers.
Millimetres throughout. --scale 0.01 makes every program a hundredth as long.
"""

import argparse
import math
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Iterator

from dialects import FANUC, NGC, Dialect, Expect, tool_table
from mixed_program import write_mixed
from turning_programs import (write_moves_of_roughing, write_roughing, write_turning,
                              write_turning_of_mill)

MILLION = 1_000_000


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
    others: dict = field(default_factory=dict)  # writers by ending, of FANUC programs for the same work


BENCHMARKS = (
    Benchmark("a", "finishing", "1,000,000 short G01", MILLION, write_finishing),
    Benchmark("s", "sharp", "1,000,000 short G01, all of them sharp turns", MILLION, write_sharp),
    Benchmark("b", "mixed", "200,000 lines of mixed work", MILLION // 5, write_mixed),
    Benchmark("c", "loop", "1,000,000 passes of arithmetic", MILLION, write_loop, LOOP_TWINS),
    Benchmark("d", "loop_move", "1,000,000 passes with a G01", MILLION, write_loop_with_move),
    Benchmark("e", "calls", "200,000 G65 calls", MILLION // 5, write_calls),
    Benchmark("t", "turning", "1,000,000 short G01 of a lathe", MILLION, write_turning,
              others={".mill.nc": write_turning_of_mill}),
    Benchmark("u", "roughing", "10,000 passes of G71 along 1,000 blocks", MILLION // 1000, write_roughing,
              others={".moves.nc": write_moves_of_roughing}),
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
    for suffix, write in benchmark.others.items() if peers else ():
        write(folder / (benchmark.name + suffix), size)
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
