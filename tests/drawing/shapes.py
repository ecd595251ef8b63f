"""Lengths and extents of curves by their formulas, and of paths of lines and arcs: what drawings are compared by."""

import math
from typing import Iterable, NamedTuple, Sequence

Point = tuple[float, float]
QUARTER = math.pi / 2


class Measure(NamedTuple):
    """Length and extents of a curve."""

    length: float
    low: Point
    high: Point

    def differs(self, other: "Measure") -> float:
        pairs = zip((self.length, *self.low, *self.high), (other.length, *other.low, *other.high))
        return max(abs(a - b) for a, b in pairs)

    def scaled(self, by: float) -> "Measure":
        return Measure(*(by * self.length, tuple(by * x for x in self.low), tuple(by * x for x in self.high)))


def of_points(points: Iterable[Sequence[float]], length: float) -> Measure:
    points = list(points)
    return Measure(length, (min(p[0] for p in points), min(p[1] for p in points)),
                   (max(p[0] for p in points), max(p[1] for p in points)))


def together(parts: Iterable[Measure]) -> Measure:
    parts = list(parts)
    return of_points([p.low for p in parts] + [p.high for p in parts], sum(p.length for p in parts))


def chords(points: Sequence[Sequence[float]], closed: bool = False) -> Measure:
    pairs = list(zip(points, points[1:])) + ([(points[-1], points[0])] if closed else [])
    return of_points(points, sum(math.hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairs))


def conic(centre: Point, first: Point, second: Point, start: float, sweep: float) -> Measure:
    """centre + cos(t) first + sin(t) second, of t from `start` on by `sweep` > 0."""

    def at(t: float) -> Point:
        return (centre[0] + math.cos(t) * first[0] + math.sin(t) * second[0],
                centre[1] + math.cos(t) * first[1] + math.sin(t) * second[1])

    def speed(t: float) -> float:
        return math.hypot(math.cos(t) * second[0] - math.sin(t) * first[0],
                          math.cos(t) * second[1] - math.sin(t) * first[1])

    steps = 400  # Simpson's rule; of a circle exact
    width = sweep / steps
    weights = [1 if k in (0, steps) else 4 if k % 2 else 2 for k in range(steps + 1)]
    length = width / 3 * sum(w * speed(start + k * width) for k, w in enumerate(weights))
    places = [start, start + sweep]
    for axis in (0, 1):
        turn = math.atan2(second[axis], first[axis])
        places += [t for k in range(-6, 7) if start < (t := turn + k * math.pi) < start + sweep]
    return of_points([at(t) for t in places], length)


def arc(centre: Point, radius: float, start_deg: float, end_deg: float) -> Measure:
    sweep = (end_deg - start_deg) % 360 or 360
    return conic(centre, (radius, 0), (0, radius), math.radians(start_deg), math.radians(sweep))


def bulge(begin: Point, end: Point, value: float) -> Measure:
    chord = (end[0] - begin[0], end[1] - begin[1])
    if value == 0:
        return of_points([begin, end], math.hypot(*chord))
    factor = (1 - value * value) / (4 * value)
    centre = ((begin[0] + end[0]) / 2 - factor * chord[1], (begin[1] + end[1]) / 2 + factor * chord[0])
    sweep = 4 * math.atan(value)
    start = math.atan2(begin[1] - centre[1], begin[0] - centre[0])
    if sweep < 0:
        start, sweep = start + sweep, -sweep
    radius = math.hypot(begin[0] - centre[0], begin[1] - centre[1])
    return conic(centre, (radius, 0), (0, radius), start, sweep)


def polyline(vertices: Sequence[Sequence[float]], closed: bool) -> Measure:
    """Of vertices (x, y, bulge)."""
    if len(vertices) == 1:
        return of_points(vertices, 0)
    pairs = list(zip(vertices, vertices[1:])) + ([(vertices[-1], vertices[0])] if closed else [])
    return together(bulge(a[:2], b[:2], a[2]) for a, b in pairs)


def mirrored(measure: Measure) -> Measure:
    """x to -x."""
    return Measure(measure.length, (-measure.high[0], measure.low[1]), (-measure.low[0], measure.high[1]))


def unmatched(expected: Sequence[tuple[str, Measure, float]], found: Sequence[tuple[str, Measure]]) -> list[str]:
    """Each of `expected` (name, measure, how far off) needs one of `found` of its own: what is left over."""
    left = list(found)
    complaints = []
    for name, measure, most in expected:
        nearest = min(left, key=lambda item: item[1].differs(measure), default=None)
        if nearest is None or nearest[1].differs(measure) > most:
            complaints.append(f"{name} is not there: {measure}; nearest {nearest}")
        else:
            left.remove(nearest)
    return complaints + [f"{name} should not be there: {measure}" for name, measure in left]
