"""Taught points and plain G-code, one into the other and back."""

import csv
import io
import math
import re

from harness import alarm, check, contains, equal, near, refused, status, test
from post_tests import PROGRAMS
from teach_tests import tch

# Arcs of planes and of space, with and without turning, whole circles, lines, dwells, the beam.
ROUND_TRIP = (
    "POINT 12.5 -3 7 0 0\nFEED 1200\nLASER ON 55\nLINE 40 -3 7 0 0\n"
    "ARC 60 17 7 0 0  40 37 7 0 0\nARC 35.123 36.377 7 0 0 31.7 34.1 7 0 0\nDWELL 0.25\n"
    "ARC 31.7 44.1 17 0 0  31.7 34.1 27 0 0\nLINE 31.7 34.1 47 0 0\n"
    "ARC 41.7 34.1 57 0 0  51.7 34.1 47 0 0\nCIRCLE 61.7 44.1 47 0 0  51.7 54.1 47 0 0\n"
    "CIRCLE 51.7 44.1 57 0 0  51.7 54.1 47 0 0\nLASER OFF\nPOINT 10 0 0 5 0\nFEED 3000\n"
    "ARC 0 10 5 20 30  -6 -2 12 -10 50\nCIRCLE 10 20 30 0 0 3 4 5 1 2\nDWELL 1\n"
    "LINE 0 0 0 0 0\nARC 5 5 5 1 2 15 15 15 3 4")


CALCULATOR = ("--decimal-point", "calculator")  # the post writes X20 for 20 mm


def way(box, name, *words):
    """Where the tip is at equal steps of a program, from where its beam is on first."""
    status(box.kerf("run", name, "--machine", "laser5", "--machine-set", "interpolator.step_mm=0.1",
                    "--points", "way.csv", *words), 0)
    rows = list(csv.DictReader(io.StringIO(box.read("way.csv").decode())))
    first = next(i for i, row in enumerate(rows) if float(row["power"]) > 0)
    rows = rows[first:]
    return [tuple(float(row[letter]) for letter in "XYZAC") for row in rows]


def distance_to_segment(p, a, b):
    ab = [v - u for u, v in zip(a[:3], b[:3])]
    ap = [v - u for u, v in zip(a[:3], p[:3])]
    square = sum(v * v for v in ab)
    share = 0 if square == 0 else min(1, max(0, sum(u * v for u, v in zip(ab, ap)) / square))
    return math.dist(ap, [share * v for v in ab])


def farthest(path, other):
    """The largest distance of a point of `path` from the polyline `other`, followed in order."""
    worst, at = 0.0, 0
    for point in path:
        window = range(max(0, at - 15), min(len(other) - 1, at + 25))
        distance, at = min((distance_to_segment(point, other[i], other[i + 1]), i) for i in window)
        worst = max(worst, distance)
    return worst


@test("taught points through plain G-code and back lead the tip along the same path within 0.002 mm")
def round_trip(box):
    box.write("first.tch", tch(ROUND_TRIP))
    there = way(box, "first.tch")
    status(box.kerf("run", "first.tch", "--post", "post.nc"), 0)
    gcode = box.read("post.nc").decode().splitlines()
    equal(len([line for line in gcode if re.search(" [IJK][-.0-9]", line)]), 6, "arcs of the G-code")
    equal([line for line in gcode if line in ("G17", "G18", "G19")], ["G19", "G18", "G17", "G19"], "planes")
    box.write("post.nc", box.read("post.nc").replace(b"G4 P", b"G4 X"))
    between = way(box, "post.nc", *CALCULATOR)
    status(box.kerf("run", "post.nc", "--machine", "laser5", "--teach", "second.tch", *CALCULATOR), 0)
    text = box.read("second.tch").decode()
    equal((text.count("\nARC "), text.count("\nCIRCLE "), text.count("\nDWELL ")), (4, 2, 2),
          "records of the second file")
    back = way(box, "second.tch")
    for name, one, other in (("tch to G-code", there, between), ("and back", between, back),
                             ("all the way", there, back), ("all the way back", back, there)):
        worst = farthest(one, other)
        check(worst < 0.002, f"{name}: {worst} mm")


@test("plain G-code through taught points and back is the same plain G-code, arcs and circles included")
def gcode_again(box):
    # Points have no tool, spindle, coolant or stop, nor comments; helices are chords of them.
    def moves_of(name):
        lines = [line for line in box.read(name).decode().splitlines() if not re.match(r"[TM](?!30)|S|\(", line)]
        cuts = [i for i, line in enumerate(lines) if line.startswith(("G1 ", "G2 ", "G3 "))]
        return lines[cuts[0]:] if cuts else []
    for name, program in PROGRAMS.items():
        if "helices" in name:
            continue
        box.write("part.nc", program.replace(";", "\n"))
        status(box.kerf("run", "part.nc", "--post", "one.nc", "--teach", "part.tch"), 0)
        status(box.kerf("run", "part.tch", "--machine", "mill3", "--post", "two.nc"), 0)
        equal(moves_of("two.nc"), moves_of("one.nc"), name)


@test("--teach of taught points is the same records, and of that the same bytes")
def teach_again(box):
    box.write("first.tch", tch(ROUND_TRIP))
    status(box.kerf("run", "first.tch", "--teach", "second.tch"), 0)
    status(box.kerf("run", "second.tch", "--teach", "third.tch"), 0)
    equal(box.read("third.tch"), box.read("second.tch"), "bytes")
    first = [line.split() for line in tch(ROUND_TRIP).splitlines()]
    again = [line.split() for line in box.read("second.tch").decode().splitlines()]
    moves = ("POINT", "LINE", "ARC", "CIRCLE", "DWELL")
    got = [line for line in again if line[0] in moves]
    wanted = [line for line in first if line[0] in moves]
    wanted[-1:] = ["LINE 5 5 5 1 2".split(), "LINE 15 15 15 3 4".split()]  # an ARC on a line
    equal(got, [[word.replace("-0", "0") if word == "-0" else word for word in line]
                for line in wanted], "records")


@test("--teach makes arcs, circles and chords of any program, and comments of what points cannot say")
def teach_gcode(box):
    box.write("part.nc", "O1\nG21G90G94G17\nT3M06\nS1000M03\nG00X10.Y0Z5.\nG01Z0F300\nG03X0Y10.I-10.\n"
              "G02J-10.\nG03X-10.Y0J-10.Z-2.\nG95G01X0F.5\nG93G01X10.F20.\nM08\nG04X.5\nM30\n")
    status(box.kerf("run", "part.nc", "--teach", "part.tch"), 0)
    lines = box.read("part.tch").decode().splitlines()
    equal(lines[:9], ["TEACH 1", "; tool centre path in machine coordinates", "UNITS MM DEG", "PERIOD 1",
                      "; tool 3", "; spindle on, 1000 rpm", "POINT 10 0 5 0 0", "FEED 300",
                      "LINE 10 0 0 0 0"], "the first lines")
    quarter = [float(word) for word in lines[9].split()[1:]]
    middle = 10 * math.sqrt(0.5)
    for got, wanted in zip(quarter, (middle, middle, 0, 0, 0, 0, 10, 0, 0, 0)):
        near(got, wanted, 1e-14, "the quarter circle")
    text = "\n".join(lines)
    equal(text.count("\nCIRCLE "), 1, "circles")
    check(text.count("\nLINE ") > 50, "the helix is chords")
    for line in ("FEED 500", "FEED 200", "DWELL 0.5", "; coolant on", "END"):
        contains(text, f"\n{line}", "the file")
    status(box.kerf("run", "part.tch", "--machine", "mill3", "--summary", "s.json"), 0)
    near(box.json("s.json")["cut_mm"],
         5 + 5 * math.pi + 20 * math.pi + math.hypot(5 * math.pi, 2) + 10 + 10, 0.02, "length")


@test("--teach refuses machines with other axes, and a feed that is not known in mm/min")
def teach_refuses(box):
    box.write("part.nc", "O1\nG21G90\nG95G01X10.F.2\nM30\n")
    result = box.kerf("run", "part.nc", "--teach", "part.tch")
    alarm(result, "TEACH_RANGE", 3)
    equal(box.files(), ["part.nc"], "files")
    text = box.kerf("machines", "mill4").text.replace('name = "A"', 'name = "B"')
    box.write("mill.toml", text)
    refused(box.kerf("run", "part.nc", "--machine", "mill.toml", "--teach", "part.tch"), 2, "--teach",
            "X Y Z A C")
    refused(box.kerf("run", "part.nc", "--teach", "missing/part.tch"), 3, "missing")
