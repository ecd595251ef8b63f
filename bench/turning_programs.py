"""The programs of lathes: a million lines in X and Z, and a roughing cycle beside its own moves."""

import math
from bisect import bisect_right
from collections import Counter
from pathlib import Path
from typing import Iterator

from dialects import FANUC, Dialect, Expect

DEPTH, RETREAT = 0.01, 0.05  # of the cycle, mm of radius
PASSES_A_BLOCK = 10


# (t) Short lines in X and Z, 0.1 mm apart.


def wave(count: int) -> Iterator[tuple]:
    """Radius and Z of points on a spiral about (50, -100)."""
    for i in range(count):
        angle = math.sqrt(4 * math.pi * i / 2)
        radius = angle / (10 * math.pi)
        yield round(50 + radius * math.cos(angle), 3), round(-100 + radius * math.sin(angle), 3)


def write_points(path: Path, head: str, scale: int, closing: str, lines: int) -> Expect:
    """X is `scale` times the radius."""
    place, cut_mm = (60.0, -90.0), 0.0
    with path.open("w", newline="\n") as file:
        file.write(head + f"G00 X{60 * scale:.3f} Z-90.\nF1000.\n")
        for point in wave(lines):
            file.write(f"G01 X{scale * point[0]:.3f} Z{point[1]:.3f}\n")
            cut_mm += math.dist(place, point)
            place = point
        file.write("M05\n" + closing)
    return Expect(Counter(STRAIGHT_FEED=lines), cut_mm=cut_mm)


def write_turning(path: Path, dialect: Dialect, lines: int) -> Expect:
    """LinuxCNC has no part in it: whatever it is given is not run."""
    return write_points(path, "%\nO1000\nG21 G18 G98 G97 S1000 M03\n", 2, dialect.closing, lines)


def write_turning_of_mill(path: Path, lines: int) -> Expect:
    return write_points(path, FANUC.head("LINES IN X AND Z") + "S1000 M03\n", 1, FANUC.closing, lines)


# (u) Roughing: ten levels for each block of the shape.


def shape(blocks: int) -> list:
    """Diameters of thousandths and Z, rising from block to block."""
    per_block = 2 * DEPTH * PASSES_A_BLOCK
    return [(round(2 + per_block * i, 3), round(-0.1 * i - 0.05 * math.sin(i), 3)) for i in range(blocks)]


CYCLE_HEAD = "%\nO1000\nG21 G97 S1000 M03\n"


def write_roughing(path: Path, dialect: Dialect, blocks: int) -> Expect:
    points = shape(blocks)
    if dialect is FANUC:  # LinuxCNC has no such cycle
        first, *others = [f"X{x:.3f}Z{z:.3f}\n" for x, z in points]
        path.write_text(CYCLE_HEAD + f"G00X{points[-1][0]:.3f}Z2.\nG71U{DEPTH}R{RETREAT}\nG71P10Q20U0W0F.3\n"
                        f"N10G00X{points[0][0]:.3f}\nG01{first}" + "".join(others) + "N20\n" + FANUC.closing)
    moves = list(moves_of_roughing(points))
    return Expect(Counter(STRAIGHT_FEED=sum(code == "G01" for code, _, _ in moves)), cut_mm=length_of_cuts(moves))


def moves_of_roughing(points: list) -> Iterator[tuple]:
    """Code, diameter and Z."""
    top, bottom = points[-1][0], points[0][0]
    diameters = [x for x, _ in points]
    for number in range(1, math.ceil((top - bottom) / (2 * DEPTH) - 1e-9) + 1):
        level = max(top - 2 * DEPTH * number, bottom)
        end = end_of_level(points, diameters, level)
        yield "G00", level, 2.0
        yield "G01", level, end
        yield "G00", level + 2 * RETREAT, end + RETREAT
        yield "G00", level + 2 * RETREAT, 2.0
    yield "G00", bottom, 2.0
    yield from (("G01", x, z) for x, z in points)
    yield "G00", top, 2.0


def end_of_level(points: list, diameters: list, level: float) -> float:
    behind = min(max(bisect_right(diameters, level + 1e-9), 1), len(points) - 1)
    (x0, z0), (x1, z1) = points[behind - 1], points[behind]
    return z0 + (z1 - z0) * (level - x0) / (x1 - x0)


def length_of_cuts(moves: list) -> float:
    total, place = 0.0, (0.0, 2.0)
    for code, x, z in moves:
        if code == "G01":
            total += math.dist(place, (x / 2, z))
        place = (x / 2, z)
    return total


def write_moves_of_roughing(path: Path, blocks: int) -> Expect:
    """As a program without the cycle has them: one block each, the code where it changes."""
    points, last = shape(blocks), ""
    with path.open("w", newline="\n") as file:
        file.write(CYCLE_HEAD + f"G00X{points[-1][0]:.3f}Z2.\nF.3\n")
        for code, x, z in moves_of_roughing(points):
            file.write(f"{code if code != last else ''}X{x:.3f}Z{z:.3f}\n")
            last = code
        file.write(FANUC.closing)
    return Expect()
