#!/usr/bin/env python3
"""Writes tube.tch: what a person would teach at a tube that stands upright, 80 mm in diameter.

A window in its side and a mitre at its end, as arcs of three points on the surface, the beam square to it
at each. A tube's normal is level, so A is 90; C is 90 more than the angle around the tube.
"""

import math

CENTRE_X, RADIUS = 250.0, 40.0
ABOVE_Z = 300.0  # free of the tube
CLEAR = 25.0  # mm between tube and focus on the way from cut to cut
WINDOW_Z, WINDOW_REACH, WINDOW_STRAIGHT = 60.0, 24.0, 14.0
ARCS_OF_A_ROUND = 8  # of each half of the window
MITRE_Z, MITRE_DEG = 120.0, 25.0
ARCS_OF_THE_MITRE = 16
MOST_OFF_TUBE = 0.02  # mm that an arc of the window leaves the surface between its points


def number(value):
    return f"{value:.4f}".rstrip("0").rstrip(".") if round(value, 4) else "0"


def pose(angle_deg, z, off=0.0):
    """x y z a c of the point at an angle around the tube, the focus `off` outside of it."""
    angle = math.radians(angle_deg)
    reach = RADIUS + off
    values = (CENTRE_X + reach * math.cos(angle), reach * math.sin(angle), z, 90, angle_deg + 90)
    return " ".join(number(value) for value in values)


def rounds(centre_z, upwards):
    """Angle and height along one half of the window's outline, as the tube unrolled shows it."""
    steps = 2 * ARCS_OF_A_ROUND
    for i in range(1, steps + 1):
        turn = math.pi * i / steps
        side = -math.cos(turn) if upwards else math.cos(turn)
        rise = math.sin(turn) if upwards else -math.sin(turn)
        yield math.degrees(WINDOW_REACH * side / RADIUS), centre_z + WINDOW_REACH * rise


def mitre(angle_deg):
    return angle_deg, MITRE_Z + RADIUS * math.cos(math.radians(angle_deg)) * math.tan(
        math.radians(MITRE_DEG))


def arcs(points):
    """Every second point is the middle of an arc."""
    for via, to in zip(points[::2], points[1::2]):
        yield f"ARC {pose(*via)}  {pose(*to)}"


def pierce(angle_deg, z, name):
    yield f"POINT {pose(angle_deg, z, CLEAR)}"
    yield f"POINT {pose(angle_deg, z)} {name}"
    yield "LASER ON 80"
    yield "DWELL 0.3"


def leave(angle_deg, z):
    yield "LASER OFF"
    yield f"POINT {pose(angle_deg, z, CLEAR)}"


def off_tube(points):
    """How far the middle between two neighbours of an arc may leave the tube: measured on chords of the
    circle through three of them."""
    worst = 0.0
    for a, b, c in zip(points[::2], points[1::2], points[2::2]):
        p = [tuple(float(v) for v in pose(*q).split()[:3]) for q in (a, b, c)]
        worst = max(worst, *(abs(math.hypot(x - CENTRE_X, y) - RADIUS) for x, y, _ in circle_points(*p)))
    return worst


def circle_points(p1, p2, p3):
    def minus(a, b):
        return tuple(x - y for x, y in zip(a, b))

    def dot(a, b):
        return sum(x * y for x, y in zip(a, b))

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    u, v = minus(p2, p1), minus(p3, p1)
    w = cross(u, v)
    to_centre = [(dot(v, v) * x + dot(u, u) * y) / (2 * dot(w, w))
                 for x, y in zip(cross(w, u), cross(v, w))]
    centre = tuple(a + b for a, b in zip(p1, to_centre))
    e1 = minus(p1, centre)
    e2 = tuple(x / math.sqrt(dot(w, w)) for x in cross(w, e1))
    end = minus(p3, centre)
    sweep = math.atan2(dot(end, e2), dot(end, e1)) % (2 * math.pi)
    for i in range(33):
        t = sweep * i / 32
        yield tuple(c + math.cos(t) * a + math.sin(t) * b for c, a, b in zip(centre, e1, e2))


def window():
    low, high = WINDOW_Z - WINDOW_STRAIGHT, WINDOW_Z + WINDOW_STRAIGHT
    side = math.degrees(WINDOW_REACH / RADIUS)
    top, bottom = list(rounds(high, True)), list(rounds(low, False))
    off = max(off_tube([(-side, high), *top]), off_tube([(side, low), *bottom]))
    assert off < MOST_OFF_TUBE, f"the focus leaves the tube by {off:.3f} mm"
    yield f"POINT {pose(-side, ABOVE_Z, CLEAR)} above"
    yield "; The window: up one side, round the top, down the other side, round the bottom."
    yield from pierce(-side, low, "window")
    yield f"LINE {pose(-side, high)}"
    yield from arcs(top)
    yield f"LINE {pose(side, low)}"
    yield from arcs(bottom)
    yield from leave(-side, low)


def mitred_end():
    steps = 2 * ARCS_OF_THE_MITRE
    points = [mitre(360 * i / steps) for i in range(steps + 1)]
    yield "; The mitre: once round, C from 90 to 450."
    yield from pierce(*points[0], "mitre")
    yield from arcs(points[1:])
    yield from leave(*points[-1])
    yield f"POINT {pose(360, ABOVE_Z, CLEAR)}"


def program():
    yield "TEACH 1  ; a tube, upright, 80 mm in diameter, its axis at X 250 Y 0"
    yield "UNITS MM DEG"
    yield "PERIOD 8"
    yield "RADII 150 80"
    yield "FEED 2400"
    yield from window()
    yield from mitred_end()
    yield "END"


if __name__ == "__main__":
    print("\n".join(program()))
