"""--rows of a lathe: its own columns, held against tables worked out by hand."""

import csv
import io
import math

from harness import check, equal, near, status, test

COLUMNS = ["line", "G", "X", "Z", "I", "K", "R", "T", "F", "A"]
HEAD = "O1\nG97S600M03\n"
# Noses of 0.8 and 0.4 mm, the second one worn.
OFFSETS = "G10P10001R.8Q3\nG10P10002R.4Q3\nG10P2R-.01Q3\n"


def rows(box, program, *words):
    """Rows as lists; all but G are numbers."""
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--machine", "lathe2", "--rows", "rows.csv", *words), 0)
    table = list(csv.reader(io.StringIO(box.read("rows.csv").decode())))
    equal(table[0], COLUMNS, "the header")
    return [[float(cell) if name != "G" else cell for name, cell in zip(COLUMNS, row)]
            for row in table[1:]]


def columns(table, *names):
    places = [COLUMNS.index(name) for name in names]
    return [tuple(row[place] for place in places) for row in table]


# line, G, X, Z, I, K, R, T, F, A: a right-hand corner is 270, the way back 180, a tangent 0.
PART = """T0101
G00X40.Z2.
G01Z-10.F.2
X50.
G02X60.Z-15.R5.
G03X70.Z-20.I0K-5.
G98G01Z-30.F120
G00X80.
M30
"""
PART_ROWS = """6 T 0 0 0 0 .8 1 0 720
7 0 40 2 0 0 .8 1 0 360
8 1 40 -10 0 0 .8 1 .2 95.710593
9 1 50 -10 0 0 .8 1 .2 270
10 2 60 -15 5 0 .8 1 .2 90
11 3 70 -20 0 -5 .8 1 .2 0
12 1 70 -30 0 0 .8 1 120 0
13 0 80 -30 0 0 .8 1 0 270"""


@test("turning, facing and arcs have the rows of their table: X is a diameter, I and K are ways")
def part(box):
    table = rows(box, HEAD + OFFSETS + PART)
    for got, line in zip(table, PART_ROWS.splitlines()):
        want = [word if place == 1 else float(word) for place, word in enumerate(line.split())]
        equal(got[:-1], want[:-1], f"row of line {want[0]:g}")
        near(got[-1], want[-1], 5e-7, f"A of line {want[0]:g}")
    equal(len(table), len(PART_ROWS.splitlines()), "rows")


@test("A is the turn from the direction before to the next one, counterclockwise in (z, x)")
def turns(box):
    ways = {0: (10, 0), 45: (10, 10), 90: (0, 10), 135: (-10, 10), 180: (-10, 0), 225: (-10, -10),
            270: (0, -10), 315: (10, -10)}
    for angle, (z, x) in ways.items():
        table = rows(box, HEAD + f"G00X100.Z0\nG98G01W10.F100\nU{2 * x}.W{z}.\nM30\n")
        near(table[-1][-1], angle, 1e-9, f"A behind a way along Z, to Z{z} X{x}")


@test("the radius of the nose is that of the offset of T, with its wear; T00 has none")
def noses(box):
    table = rows(box, HEAD + OFFSETS + "T0101\nG00X40.\nT0202\nX41.\nT0201\nX42.\nT0200\nX43.\nM30\n")
    equal(columns(table, "G", "T", "R"), [("T", 1, .8), ("0", 1, .8), ("T", 2, .39), ("0", 2, .39),
                                          ("0", 2, .8), ("0", 2, 0)], "rows")


@test("with LGN the geometry of the nose has the number of the tool")
def geometry_by_tool(box):
    table = rows(box, HEAD + OFFSETS + "T0102\nG00X40.\nM30\n", "--param", "LGN=1")
    equal(columns(table, "R"), [(.79,), (.79,)], "R")


@test("cycles are the rows of their moves, threads are G32 with their lead as F")
def cycles(box):
    table = rows(box, HEAD + "G00X40.Z2.\nG90X36.Z-10.F.2\nX32.\nG00X40.\nG92X30.Z-20.F1.5\nM30\n",
                 "--param", "chamfer_thread=0")
    equal(columns(table, "line", "G", "X", "Z", "F"),
          [(3, "0", 40, 2, 0), (4, "0", 36, 2, 0), (4, "1", 36, -10, .2), (4, "1", 40, -10, .2),
           (4, "0", 40, 2, 0), (5, "0", 32, 2, 0), (5, "1", 32, -10, .2), (5, "1", 40, -10, .2),
           (5, "0", 40, 2, 0), (7, "0", 30, 2, 0), (7, "32", 30, -20, 1.5), (7, "0", 40, -20, 0),
           (7, "0", 40, 2, 0)], "rows")


@test("rows follow the motions: same ends, same centres, a nose compensated")
def as_motions(box):
    program = HEAD + OFFSETS + ("T0101\nG00X60.Z2.\nG42G00X20.Z1.\nG01Z-10.F.2\nG02X30.Z-15.R5.\nG01X50.Z-40.\n"
                      "G40G00X80.Z5.\nM30\n")
    table = rows(box, program, "--motion", "m.jsonl")
    at, wanted = {"X": 0, "Z": 0}, []
    for record in box.motions("m.jsonl"):
        if "to" not in record:
            continue
        z, x = record.get("center", (at["Z"], at["X"]))
        wanted.append((record["line"], record["to"]["X"], record["to"]["Z"], (x - at["X"]) / 2, z - at["Z"]))
        at = record["to"]
    got = [row for row in columns(table, "line", "G", "X", "Z", "I", "K") if row[1] != "T"]
    equal(len(got), len(wanted), "moves")
    for row, want in zip(got, wanted):
        for name, value, right in zip(("line", "X", "Z", "I", "K"), (row[0], *row[2:]), want):
            near(value, right, 1e-9, f"{name} of line {want[0]}")
    radii = [math.hypot(*row[4:]) for row in got if row[1] in "23"]
    check(len(radii) == 1 and abs(radii[0] - 4.2) < 1e-9, f"the radius of the tip's arc is {radii}")


@test("a figure on the face is lines, a turn of the C axis alone has no way")
def faces(box):
    box.write("part.nc", "O1\nG98\nG00X40.Z5.C0\nC90.\nG12.1\nG01X0.C20.F100\nG13.1\nM30\n")
    status(box.kerf("run", "part.nc", "--machine", "lathe3c", "--rows", "rows.csv"), 0)
    lines = box.read("rows.csv").decode().splitlines()
    equal(lines[0].split(","), COLUMNS, "the header")
    equal(lines[2].split(",")[1:4] + lines[2].split(",")[-1:], ["0", "40", "5", "360"], "the turn")
    check(len(lines) > 6, "the line on the face is one row")
    near(float(lines[-1].split(",")[2]), 40, 1e-9, "where it ends")
