"""Solids as STL files, for designs that parts are compared with."""

import math
import struct


def stl(points, triangles):
    out = [b"\0" * 80, struct.pack("<I", len(triangles))]
    for triangle in triangles:
        corners = [c for k in triangle for c in points[k]]
        out.append(struct.pack("<12fH", 0, 0, 0, *corners, 0))
    return b"".join(out)


def bar(outline, caps, x0, x1):
    """A counterclockwise outline in (Y, Z), its triangles as `caps` numbers its corners, from x0 to x1."""
    n = len(outline)
    points = [(x, *corner) for x in (x0, x1) for corner in outline]
    sides = [t for i in range(n) for k in [(i + 1) % n] for t in ((i, n + i, n + k), (i, n + k, k))]
    sides = [tuple(reversed(t)) for t in sides]
    ends = [tuple(reversed(cap)) for cap in caps] + [tuple(n + k for k in cap) for cap in caps]
    return stl(points, sides + ends)


def box(low, high):
    (x0, y0, z0), (x1, y1, z1) = low, high
    return bar([(y0, z0), (y1, z0), (y1, z1), (y0, z1)], [(0, 1, 2), (0, 2, 3)], x0, x1)


def turned(outline, sides=360):
    """Corners (Z, radius) from low to high Z, without those on the axis, turned about Z."""
    points = [(0, 0, outline[0][0]), (0, 0, outline[-1][0])]
    for z, radius in outline:
        points += [(radius * math.cos(math.tau * k / sides), radius * math.sin(math.tau * k / sides), z) for k in range(sides)]
    triangles = []
    last = 2 + (len(outline) - 1) * sides
    for k in range(sides):
        n = (k + 1) % sides
        triangles += [(0, 2 + n, 2 + k), (1, last + k, last + n)]
        for ring in range(2, last, sides):
            triangles += [(ring + k, ring + n, ring + sides + n), (ring + k, ring + sides + n, ring + sides + k)]
    return stl(points, triangles)
