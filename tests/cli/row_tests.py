"""--rows: the canonical rows of moves and tool changes, held against tables worked out by hand."""

import csv
import io
import math

from harness import check, equal, near, status, test

HEAD = "O1\nG21G90G17G94\n"
COLUMNS = ["line", "G", "X", "Y", "Z", "I", "J", "K", "R", "T", "F", "A"]


def rows(box, program, *words, wanted=0):
    """Rows as lists; all but G are numbers."""
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--rows", "rows.csv", *words), wanted)
    table = list(csv.reader(io.StringIO(box.read("rows.csv").decode())))
    equal(table[0], COLUMNS, "the header")
    return [[float(cell) if name != "G" else cell for name, cell in zip(COLUMNS, row)]
            for row in table[1:]]


def columns(table, *names):
    places = [COLUMNS.index(name) for name in names]
    return [tuple(row[place] for place in places) for row in table]


# Two pockets in layers, a boss with round corners, a full circle, two holes; two tools.
PART = """N10 G21 G90 G17
N20 T1 M06
N30 G00 X0 Y0 Z5 S3000 M03
N40 G00 X20 Y20
N50 G01 Z-2 F100
N60 G01 X40 F300
N70 Y28
N80 X20
N90 Y20
N100 X15 Y15
N110 G00 Z5
N120 X80 Y10
N130 G01 Z-6 F100
N140 G01 X110 F250
N150 G03 X115 Y15 I0 J5
N160 G01 Y35
N170 G03 X110 Y40 I-5 J0
N180 G01 X80
N190 G03 X75 Y35 I0 J-5
N200 G01 Y15
N210 G03 X80 Y10 I5 J0
N220 G00 Z5
N230 X65 Y60
N240 G01 Z-3 F100
N250 G02 X65 Y60 I-3 J0 F250
N260 G00 Z5
N270 T2 M06
N280 G00 X10 Y50
N290 G01 Z-12 F80
N300 G00 Z5
N310 M30
"""

# line, G, X, Y, Z, I, J, K, R, T, F, A
PART_ROWS = """2 T 0 0 0 0 0 0 5 1 0 720
3 0 0 0 5 0 0 0 5 1 0 360
4 0 20 20 5 0 0 0 5 1 0 45
5 1 20 20 -2 0 0 0 5 1 100 360
6 1 40 20 -2 0 0 0 5 1 300 0
7 1 40 28 -2 0 0 0 5 1 300 90
8 1 20 28 -2 0 0 0 5 1 300 180
9 1 20 20 -2 0 0 0 5 1 300 270
10 1 15 15 -2 0 0 0 5 1 300 225
11 0 15 15 5 0 0 0 5 1 0 360
12 0 80 10 5 0 0 0 5 1 0 355.601295
13 1 80 10 -6 0 0 0 5 1 100 360
14 1 110 10 -6 0 0 0 5 1 250 0
15 3 115 15 -6 0 5 0 5 1 250 45
16 1 115 35 -6 0 0 0 5 1 250 90
17 3 110 40 -6 -5 0 0 5 1 250 135
18 1 80 40 -6 0 0 0 5 1 250 180
19 3 75 35 -6 0 -5 0 5 1 250 225
20 1 75 15 -6 0 0 0 5 1 250 270
21 3 80 10 -6 5 0 0 5 1 250 315
22 0 80 10 5 0 0 0 5 1 0 360
23 0 65 60 5 0 0 0 5 1 0 106.699244
24 1 65 60 -3 0 0 0 5 1 100 360
25 2 65 60 -3 -3 0 0 5 1 250 360
26 0 65 60 5 0 0 0 5 1 0 360
27 T 65 60 5 0 0 0 3 2 250 720
28 0 10 50 5 0 0 0 3 2 0 190.304846
29 1 10 50 -12 0 0 0 3 2 80 360
30 0 10 50 5 0 0 0 3 2 0 360"""


def tools(box, *diameters):
    return box.write("tools.toml", "".join(f"[[tool]]\nnumber = {n}\ndiameter = {d}\n"
                                           for n, d in enumerate(diameters, start=1)))


@test("a part with pockets, arcs, a full circle, holes and two tools has the rows of its table")
def part(box):
    table = rows(box, PART, "--decimal-point", "calculator", "--tools", tools(box, 10, 6))
    for got, line in zip(table, PART_ROWS.splitlines()):
        want = [word if place == 1 else float(word) for place, word in enumerate(line.split())]
        equal(got[:-1], want[:-1], f"row of line {want[0]:g}")
        near(got[-1], want[-1], 5e-7, f"A of line {want[0]:g}")
    equal(len(table), len(PART_ROWS.splitlines()), "rows")


@test("A is the direction of the way in XY, never printed as 360 unless there is none")
def headings(box):
    ways = {(1, 0): 0, (1, 1): 45, (0, 2): 90, (-3, 4): 126.869898, (-1, 0): 180,
            (-5, -12): 247.380135, (0, -1): 270, (1, -1): 315, (3, 4): 53.130102,
            (10, -0.001): 359.994270}
    blocks = "".join(f"G91{code}X{x:.3f}Y{y:.3f}F100\n" for x, y in ways for code in ("G00", "G01"))
    table = rows(box, HEAD + blocks + "G01Z-1.\nM30\n")
    for row, want in zip(table, [want for want in ways.values() for _ in range(2)]):
        near(row[-1], want, 5e-7, f"A of line {row[0]:g}")
    equal(columns(table, "A")[-1], (360,), "A of a plunge")


@test("arcs have the way to their centre along the axes of their plane, whatever wrote them")
def arcs(box):
    program = HEAD + ("F300\nG00X10.Y10.Z10.\nG17G02X20.Y20.R10.\nG03X10.Y10.R-10.\n"
                      "G18G02X20.Z20.R10.\nG03X10.Z10.I-10.K0\nG19G03Y20.Z20.J10.K0\n"
                      "G02Y10.Z10.R10.\nG17G03I5.Z12.\nM30\n")
    wanted = [(4, "0", 10, 10, 10, 0, 0, 0), (5, "2", 20, 20, 10, 10, 0, 0),
              (6, "3", 10, 10, 10, -10, 0, 0), (7, "2", 20, 10, 20, 0, 0, 10),
              (8, "3", 10, 10, 10, -10, 0, 0), (9, "3", 10, 20, 20, 0, 10, 0),
              (10, "2", 10, 10, 10, 0, 0, -10), (11, "3", 10, 10, 12, 5, 0, 0)]
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--motion", "m.json", "--rows", "rows.csv"), 0)
    at = {"X": 0, "Y": 0, "Z": 0}
    centres = []
    for record in box.motions("m.json"):
        if record["kind"] == "arc":
            centre = dict(zip(record["plane"], record["center"]))
            centres.append([centre[axis] - at[axis] if axis in centre else 0 for axis in "XYZ"])
        at = record.get("to", at)
    table = rows(box, program)
    equal([row[5:8] for row in table[1:]], centres, "I, J, K of the motions")
    for row, want in zip(table, wanted):
        equal(tuple(row[:5]), want[:5], f"where line {want[0]} ends")
        if row[1] != "0":
            equal(math.hypot(*row[5:8]), 5 if row[0] == 11 else 10, f"radius of line {want[0]}")
    for line in (8, 9, 11):  # centres that the program names
        row = next(row for row in table if row[0] == line)
        equal(tuple(row[5:8]), next(w for w in wanted if w[0] == line)[5:], f"I, J, K of line {line}")
    equal(columns(table, "A")[-1], (360,), "A of a whole turn")


@test("a canned cycle is the rows of its moves, each with the line that made it")
def cycles(box):
    table = rows(box, HEAD + "G00Z50.\nG99G81X10.Y10.Z-5.R2.F100\nG98X20.\n"
                             "G99G83X30.Z-10.R2.Q6.\nG80\nM30\n", "--param", "d_G83=1")
    got = columns(table, "line", "G", "X", "Z", "F", "A")
    equal(got[1:5], [(4, "0", 10, 50, 0, 45), (4, "0", 10, 2, 0, 360), (4, "1", 10, -5, 100, 360),
                     (4, "0", 10, 2, 0, 360)], "the first hole")
    equal(got[5:8], [(5, "0", 20, 2, 0, 0), (5, "1", 20, -5, 100, 360), (5, "0", 20, 50, 0, 360)],
          "the second hole")
    equal([(row[1], row[3]) for row in got[8:]],
          [("0", 50), ("0", 2), ("1", -4), ("0", 2), ("0", -3), ("1", -10), ("0", 2)], "the pecks")


@test("incremental, inch, offset and shifted programs have absolute rows in mm of the machine")
def frames(box):
    table = rows(box, "O1\nG20G91G17G94\nG00X1.Y2.\nG01X-.5F10.\nM30\n")
    equal(columns(table, "X", "Y", "F"), [(25.4, 50.8, 0), (12.7, 50.8, 254)], "an inch program")
    table = rows(box, HEAD + "G10L2P1X100.Y50.Z-20.\nG54G00X1.Y2.Z3.\nG52X5.\nG01X1.F100\nM30\n")
    equal(columns(table, "X", "Y", "Z"), [(101, 52, -17), (106, 52, -17)], "a work offset")


@test("rows of a compensated path are those of the tool's centre, R is the tool in the spindle")
def compensation(box):
    table = rows(box, HEAD + "T1M06\nG00X-20.Y-10.\nG41D1G01X0Y0F200\nY50.\nX50.\nG40X60.Y60.\nM30\n",
                 "--tools", tools(box, 8))
    inside = [row for row in table if row[0] == 6]
    equal(inside[-1][2], -4, "X of the compensated line")
    equal(set(columns(table, "R", "T")), {(4, 1)}, "R and T")


@test("R is geometry and wear of the offset with the tool's number, 0 of a tool without one")
def radius(box):
    box.write("tools.toml", "[[tool]]\nnumber = 3\ndiameter = 10\n[tool_offset.3]\nradius_wear = -0.02\n"
                            "radius_geometry = 5\n")
    program = HEAD + "G00X1.\nT3M06\nX2.\nT4M06\nX3.\nT99999999M06\nX4.\nG10L12P3R4.\nT3M06\nX5.\nM30\n"
    table = rows(box, program, "--tools", "tools.toml")
    equal(columns(table, "G", "R", "T"),
          [("0", 0, 0), ("T", 4.98, 3), ("0", 4.98, 3), ("T", 0, 4), ("0", 0, 4),
           ("T", 0, 99999999), ("0", 0, 99999999), ("T", 3.98, 3), ("0", 3.98, 3)], "rows")


@test("F is mm/min of feeds per revolution and inverse time too, 0 of a rapid")
def feeds(box):
    table = rows(box, HEAD + "S600M03\nG95G01X10.F.1\nG93G01X30.F4.\nG02X50.I10.F2.\nG94G01X0F100\n"
                             "G00X1.\nT5M06\nM30\n")
    got = columns(table, "line", "F")
    near(dict(got)[6], 2 * math.pi * 10, 1e-9, "an arc in half a minute")
    equal([pair for pair in got if pair[0] != 6], [(4, 60), (5, 80), (7, 100), (8, 0), (9, 100)],
          "feeds")


@test("probing moves and threads are told by their own codes")
def codes(box):
    table = rows(box, HEAD + "G31X10.F50\nS100M03\nG33Z-10.F1.5\nM30\n", "--skip-at", "X=7.2")
    equal(columns(table, "line", "G", "X", "Z", "F"), [(3, "31", 7.2, 0, 50), (5, "33", 7.2, -10, 150)],
          "rows")


@test("a move of rotary axes alone is a row without way, axes that the machine lacks are 0")
def other_machines(box):
    table = rows(box, HEAD + "G01X1.Y1.A10.F100\nA40.\nM30\n", "--machine", "laser5")
    equal(columns(table, "X", "Y", "Z", "A"), [(1, 1, 0, 45), (1, 1, 0, 360)], "rows of laser5")
    text = box.kerf("machines", "mill3").text
    begin = text.index('[[axis]]\nname = "Y"')
    end = text.index('[[axis]]\nname = "Z"')
    box.write("two.toml", text[:begin] + text[end:])
    table = rows(box, "O1\nG21G90G18G94\nG00X1.Z2.\nG02X3.I1.F100\nM30\n", "--machine", "two.toml")
    equal(columns(table, "G", "X", "Y", "Z", "I", "J", "K", "A"),
          [("0", 1, 0, 2, 0, 0, 0, 0), ("2", 3, 0, 2, 1, 0, 0, 0)], "rows of a machine without Y")


@test("the first row begins where the tip is at power-on")
def from_the_start(box):
    table = rows(box, HEAD + "G01X214.Y50.F600\nG03X164.Y100.I-50.J0\nM30\n", "--machine", "arm4")
    equal(columns(table, "X", "Y", "I", "J"), [(214, 50, 0, 0), (164, 100, -50, 0)], "rows")
    near(table[0][-1], 135, 1e-9, "heading from X264 Y0")
    table = rows(box, HEAD + "G93G01X200.F6.\nM30\n", "--machine", "arm4")
    near(table[0][-2], 384, 1e-9, "64 mm in 10 s")


@test("rows of an alarm are those up to it, and nothing but moves and tool changes has one")
def others(box):
    table = rows(box, HEAD + "M03S100\nM08\nG04X1.\nG00X1.\nM60\nX1.\n#1=1/0\nX2.\nM30\n", wanted=1)
    equal(columns(table, "line", "G", "X"), [(6, "0", 1)], "rows")
    box.write("part.nc", PART)
    out = box.kerf("run", "part.nc", "--rows", "-")
    status(out, 0)
    check(out.out.startswith(b"line,G,X"), "standard output")
