"""(b) Mixed: small workshop features one after the other."""

import math
import random
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator

from dialects import TOOL_LENGTHS, Dialect, Expect, number

SEED = 5


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
