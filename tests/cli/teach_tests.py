"""Taught points: .tch files run, checked and written; the tables of line, arc and head from
set-points that the program prints."""

import csv
import io
import random

import harness
from harness import check, contains, equal, near, refused, status, test

HEAD = "TEACH 1\nUNITS MM DEG\nPERIOD 8\nRADII 150 80\n"
PRINTED = 5.1e-7  # the tables have six decimals


def tch(lines):
    return HEAD + lines + "\nEND\n"


def numbers(values):
    return " ".join(str(value) for value in values)


def run(box, text, *words, name="part.tch", wanted=0):
    box.write(name, text)
    result = box.kerf("run", name, *words)
    status(result, wanted)
    return result


def points(box, text, *words):
    """The rows of --points, their columns as numbers."""
    run(box, text, "--points", "points.csv", *words)
    rows = csv.DictReader(io.StringIO(box.read("points.csv").decode()))
    return [{key: float(value) for key, value in row.items()} for row in rows]


def same_point(row, wanted, what, tolerance=PRINTED, columns="XYZAC"):
    for letter, value in zip(columns, wanted):
        near(row[letter], value, tolerance, f"{what}, {letter}")


# Steps of constant feed along a line: feed 3000, 8 ms.
LINE = "POINT 0 0 0 0 0\nFEED 3000\nLINE 100 50 25 30 90"
LINE_POINTS = {
    "tail": {1: (0.349149, 0.174574, 0.087287, 0.104745, 0.314234),
             2: (0.698297, 0.349149, 0.174574, 0.209489, 0.628468),
             100: (34.914862, 17.457431, 8.728716, 10.474459, 31.423376),
             200: (69.829725, 34.914862, 17.457431, 20.948917, 62.846752),
             286: (99.856507, 49.928253, 24.964127, 29.956952, 89.870856),
             287: (100, 50, 25, 30, 90)},
    "equal": {1: (0.348432, 0.174216, 0.087108, 0.104530, 0.313589),
              100: (34.843206, 17.421603, 8.710801, 10.452962, 31.358885),
              286: (99.651568, 49.825784, 24.912892, 29.895470, 89.686411),
              287: (100, 50, 25, 30, 90)},
}


@test("a taught line is interpolated at constant feed as the printed table says, A and C going along")
def line(box):
    for mode, wanted in LINE_POINTS.items():
        rows = points(box, tch(LINE), "--machine-set", f"interpolator.mode={mode}")
        rows = [row for row in rows if row["line"] == 7]
        equal(len(rows), 287, f"points in mode {mode}")
        for n, point in wanted.items():
            same_point(rows[n - 1], point, f"{mode} point {n}")


# Arcs of three points: the points with their A and C, feed, number of set-points, some of them.
ARCS = {
    "A1": (((40, 0, 0, 0, 0), (0, 40, 0, 10, 45), (-40, 0, 0, 30, 90)), 3000, 315,
           {1: (39.998000, 0.399993, 0.000000, 0.063662, 0.286479),
            78: (28.436542, 28.131177, 0.000000, 4.965634, 22.345354),
            157: (0.031853, 39.999987, 0.000000, 9.994930, 44.977187),
            314: (-39.999949, 0.063706, 0.000000, 29.979722, 89.954374),
            315: (-40, 0, 0, 30, 90)}),
    "A2": (((10, 0, 0, 5, 0), (0, 10, 5, 20, 30), (-6, -2, 12, -10, 50)), 3000, 85,
           {1: (9.955014, 0.393615, -0.054980, 5.355044, 0.710088),
            21: (6.607343, 7.377441, 0.810821, 12.455920, 14.911840),
            42: (0.079326, 10.008447, 4.940832, 19.911840, 29.823681),
            84: (-6.102022, -1.615858, 11.988318, -9.302290, 49.534860),
            85: (-6, -2, 12, -10, 50)}),
    "A3": (((10, 0, 0, 0, 0), (0, -10, 0, 15, -30), (0, 10, 0, 30, 60)), 6000, 59,
           {1: (9.968017, -0.799147, 0.000000, 0.763944, -1.527887),
            14: (4.356824, -9.001004, 0.000000, 10.695212, -21.390424),
            29: (-6.810559, -7.322314, 0.000000, 18.577184, -8.536896),
            58: (-0.723258, 9.973811, 0.000000, 29.654368, 57.926208),
            59: (0, 10, 0, 30, 60)}),
    "A4": (((0, 0, 0, 0, 0), (30, 0, 40, 20, -10), (60, 0, 0, 5, -40)), 3000, 290,
           {1: (-0.109539, 0.000000, 0.384706, 0.138036, -0.069018),
            72: (4.893621, 0.000000, 27.357316, 9.938582, -4.969291),
            145: (30.044049, 0.000000, 39.999969, 19.988599, -10.022801),
            289: (60.085837, 0.000000, 0.299857, 5.080726, -39.838549),
            290: (60, 0, 0, 5, -40)}),
    "A5": (((50, 20, 10, 40, 170), (55, 25, 10, 35, 190), (60, 20, 10, 20, 200)), 1500, 79,
           {1: (50.003999, 20.199947, 10.000000, 39.872676, 170.509296),
            19: (51.375820, 23.444607, 10.000000, 37.580845, 179.676621),
            39: (54.946019, 24.999709, 10.000000, 35.034366, 189.862537),
            78: (59.998834, 20.107955, 10.000000, 20.206195, 199.862537),
            79: (60, 20, 10, 20, 200)}),
}


def arc_file(three):
    first, second, third = (numbers(point) for point in three)
    return tch(f"POINT {first}\nFEED %s\nARC {second}  {third}")


@test("taught arcs of three points are interpolated as the printed tables say, in every plane and sweep")
def arcs(box):
    for name, (three, feed, count, wanted) in ARCS.items():
        rows = points(box, arc_file(three) % feed, "--machine-set", "interpolator.mode=tail")
        rows = [row for row in rows if row["line"] == 7]
        equal(len(rows), count, f"set-points of {name}")
        for n, point in wanted.items():
            same_point(rows[n - 1], point, f"{name} point {n}")


# Focus with A and C, and where the carriage of a head with r_a 150, r_c 80 stands.
CARRIAGE = {
    (0, 0, 0, 0, 0): (-80, 0, 150),
    (100, 50, 25, 30, 90): (175, -30, 154.903811),
    (10, 20, 30, -45, 10): (-87.202791, 110.562782, 136.066017),
    (10, 20, 30, 45, 190): (70.366450, 138.346490, 136.066017),
    (-12.5, 7.25, 3, 90, 0): (-92.5, -142.75, 3),
    (0, 0, 0, 15, -120): (6.378420, 88.693461, 144.888874),
    (200, -80, 60, 62.5, 233.1): (141.634275, 63.861659, 129.262292),
}


@test("the head stands over every taught point as the printed table of the transformation says")
def carriage(box):
    lines = [f"POINT {numbers(pose)}" for pose in CARRIAGE]
    rows = points(box, tch("DWELL 0.008\n" + "\n".join(lines)))
    for number, (pose, joints) in enumerate(CARRIAGE.items()):
        row = [row for row in rows if row["line"] == 6 + number]
        row = row[-1] if row else rows[0]  # the machine stands at the first one
        same_point(row, pose, f"tip {pose}", 1e-9)
        same_point(row, joints, f"joints at {pose}", PRINTED, ("j1", "j2", "j3"))
        equal((row["j4"], row["j5"]), (pose[3], pose[4]), "A and C")


@test("an arc over a point between its ends is two lines, each with its own turn of A and C")
def straight_arc(box):
    run(box, tch("POINT 0 0 0 0 0\nFEED 600\nARC 10 0 0 20 5  30 0 0 0 90"), "--motion", "m.jsonl")
    lines = [m for m in box.motions("m.jsonl") if m["kind"] == "line"]
    equal([list(m["to"].values()) for m in lines], [[10, 0, 0, 20, 5], [30, 0, 0, 0, 90]], "lines")
    equal([m["line"] for m in lines], [7, 7], "their line")


@test("records are the motions that they say: rapids, lines, arcs in space, dwells, power and an end")
def motions(box):
    run(box, tch("POINT 1 2 3 4 5 here\nFEED 600\nLASER ON 40\nLINE 10 2 3 4 5\n"
                 "ARC 20 12 3 4 5 30 2 3 4 9\nCIRCLE 40 12 3 0 0  50 2 3 1 1\nLASER OFF\nDWELL .5\n"
                 "LASER ON\nPOINT 1 2 3 4 5\nLINE 1 2 3 4 5"), "--motion", "m.jsonl",
        "--summary", "s.json")
    found = box.motions("m.jsonl")
    equal([(m["kind"], m["line"]) for m in found],
          [("rapid", 5), ("power", 7), ("line", 8), ("space-arc", 9), ("space-arc", 10),
           ("power", 11), ("dwell", 12), ("power", 13), ("rapid", 14), ("power", 16), ("end", 16)],
          "motions")
    equal([m["percent"] for m in found if m["kind"] == "power"], [40, 0, 40, 0], "power")
    summary = box.json("s.json")
    equal((summary["program"], summary["machine"], summary["dialect"], summary["status"]),
          ("O0000", "laser5", "teach", "end"), "summary")
    equal(summary["blocks"], 16, "blocks")
    equal([(a["line"], "beam is on" in a["what"]) for a in summary["assumed"]], [(14, True)],
          "assumed")


@test("the power column of --points and --pwm follow LASER ON and OFF")
def power(box):
    rows = points(box, tch("POINT 0 0 0 0 0\nFEED 600\nLINE 1 0 0 0 0\nLASER ON 25\n"
                           "LINE 2 0 0 0 0\nLASER OFF\nLINE 3 0 0 0 0"), "--pwm", "pwm.csv")
    for row in rows:
        equal(row["power"], 25 if row["line"] == 9 else 0, f"power in line {row['line']}")
    duties = [line.split(",")[3] for line in box.read("pwm.csv").decode().splitlines()[1:]]
    equal(duties, ["0", "0.25", "0"], "duties")


# What is wrong with a file, where, and what for: from line 5 on, unless it begins with TEACH.
MISTAKES = {
    "LIN 1 2 3 4 5": ("TEACH_RECORD", 5, 1),
    "LASER DIM": ("TEACH_RECORD", 5, 7),
    "POINT 1 2 3 4": ("TEACH_COUNT", 5, 1),
    "POINT 1 2 3 4 5 a b": ("TEACH_COUNT", 5, 19),
    "DWELL 1 2": ("TEACH_COUNT", 5, 9),
    "POINT 1 2,,3. 4e 5": ("TEACH_NUMBER", 5, 15),
    "FEED 0": ("TEACH_RANGE", 5, 6),
    "LASER ON 100.5": ("TEACH_RANGE", 5, 10),
    "FEED 5\nLINE 1 2 3 4 5": ("TEACH_ORDER", 6, 1),
    "FEED 5\n  ARC 1 2 3 4 5 6 7 8 9 1": ("TEACH_ORDER", 6, 3),
    "POINT 1 2 3 4 5\nLINE 1 2 3 4 6": ("TEACH_ORDER", 6, 1),
    "POINT 0 0 0 0 0\nFEED 5\nARC 2 0 0 0 0 1 0 0 0 0": ("ARC_COLLINEAR", 7, 1),
    "POINT 0 0 0 0 0\nFEED 5\nCIRCLE 1 0 0 0 0 2 0 0 0 0": ("ARC_COLLINEAR", 7, 1),
    "POINT 0 0 0 0 0\nFEED 5\nARC 0 0 0 1 1 1 0 0 0 0": ("ARC_COINCIDENT", 7, 1),
    "POINT 0 0 0 180.001 0": ("LIMIT", 5, 13),
    "POINT 0 0 0 0 0\nFEED 5\nARC 1 1 0 0 0  2 0 0 -181 0": ("LIMIT", 7, 22),
    "UNITS INCH DEG": ("TEACH_UNIT", 5, 7),
    "UNITS MM RAD": ("TEACH_UNIT", 5, 10),
    "END\n;\n POINT 1 2 3 4 5": ("TEACH_ORDER", 7, 2),
    "TEACH 2\nEND": ("TEACH_VERSION", 1, 7),
    "POINT 1 2 3 4 5\nTEACH 1": ("TEACH_ORDER", 6, 1),
}

def placed(result, name, number, line, column):
    status(result, 1)
    contains(result.err + result.text, f"{name}:{line}:{column}: error: {number} ", "the diagnostic")


@test("every mistake in a file of taught points is an alarm with line and column")
def mistakes(box):
    for text, (number, line, column) in MISTAKES.items():
        whole = text + "\n" if text.startswith("TEACH") else tch(text)
        box.write("bad.tch", whole)
        result = box.kerf("run", "bad.tch", "--summary", "s.json")
        placed(result, "bad.tch", number, line, column)
        found = box.json("s.json")["alarm"]
        equal((found["code"], found["line"], found["column"], found["program"]),
              (number, line, column, "O0000"), text)
        placed(box.kerf("check", "bad.tch"), "bad.tch", number, line, column)


@test("a byte order mark before TEACH is no part of a taught program")
def byte_order_mark(box):
    box.write("good.tch", b"\xef\xbb\xbf" + tch("POINT 1 2 3 4 5").encode())
    status(box.kerf("run", "good.tch"), 0)
    box.write("bad.tch", b"\xef\xbb\xbfTEACH 2\nEND\n")
    placed(box.kerf("run", "bad.tch"), "bad.tch", "TEACH_VERSION", 1, 10)
    box.write("bad.tch", tch("POINT 1 2 3 4 5").encode() + b"\xef\xbb\xbf")
    placed(box.kerf("run", "bad.tch"), "bad.tch", "TEACH_ORDER", 6 + 1, 1)


@test("a file of taught points that begins with anything but TEACH 1 says so")
def no_version(box):
    box.write("bad.tch", "; points\nUNITS MM DEG\nEND\n")
    placed(box.kerf("run", "bad.tch"), "bad.tch", "TEACH_VERSION", 2, 1)


@test("a file of taught points without END is an alarm behind its moves, and drives nothing")
def no_end(box):
    box.write("cut.tch", HEAD + "POINT 1 2 3 4 5\nFEED 100\n; and then\n")
    result = box.kerf("run", "cut.tch", "--motion", "m.jsonl", "--post", "p.nc", "--teach", "t.tch")
    placed(result, "cut.tch", "TEACH_ORDER", 6, 1)
    equal([m["kind"] for m in box.motions("m.jsonl")], ["rapid"], "motions")
    equal(box.files(), ["cut.tch", "m.jsonl"], "files")


@test("nonsense as taught points is told in a sentence with a place: no bytes, random bytes, long lines")
def nonsense(box):
    noise = bytes(random.Random(5).randrange(256) for _ in range(50_000))
    files = {b"": "EMPTY_PROGRAM", b"; only this\n\n": "EMPTY_PROGRAM",
             noise: "TEACH_", b"TEACH 1\n" + b"x" * 3_000_000: "BLOCK_TOO_LONG",
             b"TEACH 1\n" + b"9 " * 400_000: "TEACH_RECORD", b"\0" * 1000: "TEACH_RECORD",
             b"TEACH 1\n\xff\xfe\n": "TEACH_RECORD"}
    for data, number in files.items():
        box.write("bad.tch", data)
        for command in ("run", "check"):
            result = box.kerf(command, "bad.tch")
            status(result, 1)
            contains(result.err + result.text, f"error: {number}", f"{command} of {data[:20]!r}")
            check(len(result.err) < 4000, "the diagnostic is long")


@test("kerf check tells all mistakes of a file of taught points at once")
def check_all(box):
    box.write("bad.tch", tch("POINT 1 2 3 4\nFEED x\nPOINT 0 0 0 0 0\nARC 1 0 0 0 0 1 0 0 0 0\nLASERS"))
    text = box.kerf("check", "bad.tch")
    status(text, 1)
    for place in ("5:1: error: TEACH_COUNT", "6:6: error: TEACH_NUMBER",
                  "8:1: error: ARC_COINCIDENT", "9:1: error: TEACH_RECORD"):
        contains(text.text, f"bad.tch:{place} ", "what check says")


@test("a taught move that the head cannot follow is refused at its record")
def beyond_travel(box):
    box.write("far.tch", tch("POINT 0 0 0 0 0\nFEED 1000\nLINE 900 0 0 0 0"))
    result = box.kerf("run", "far.tch", "--motion", "m.jsonl")
    placed(result, "far.tch", "LIMIT", 7, 1)
    contains(result.err, "X", "the sentence")
    equal(box.motions("m.jsonl"), [], "motions")


@test("PERIOD and RADII that are not the machine's stand in assumed, and the machine's count")
def assumed(box):
    box.write("part.tch", "TEACH 1\nPERIOD 4\nRADII 150 81\nPOINT 0 0 0 0 0\nEND\n")
    result = box.kerf("run", "part.tch", "--summary", "s.json")
    status(result, 0)
    found = {a["line"]: a["what"] for a in box.json("s.json")["assumed"]}
    equal(sorted(found), [2, 3], "lines")
    contains(found[2], "PERIOD 4: the servo of this machine has 8 ms", "assumed")
    contains(found[3], "RADII 150 81: the head of this machine has 150 80", "assumed")
    contains(result.err, "assumed, line 3: RADII", "the summary")
    status(box.kerf("run", "part.tch", "--machine-set", "interpolator.period_ms=4", "--machine-set",
                    "kinematics.r_c=81", "--summary", "s.json"), 0)
    equal(box.json("s.json")["assumed"], [], "assumed on that machine")


@test("taught points run on machines without a head, and without A and C where these are 0")
def other_machines(box):
    text = tch("POINT 1 2 3 0 0\nFEED 100\nLINE 4 5 6 0 0\nLASER ON")
    for machine in ("mill3", "mill5", "laser3", "laser5"):
        box.write("part.tch", text)
        status(box.kerf("run", "part.tch", "--machine", machine, "--summary", "s.json"), 0)
        equal(box.json("s.json")["dialect"], "teach", "dialect")
        position = list(box.json("s.json")["position"]["machine"].values())
        equal(position[:3], [4, 5, 6], machine)
        what = " ".join(a["what"] for a in box.json("s.json")["assumed"])
        equal("has no laser" in what, machine.startswith("mill"), f"laser of {machine}")
        equal("has no such head" in what, machine != "laser5", f"head of {machine}")
    box.write("part.tch", tch("POINT 1 2 3 0 7"))
    placed(box.kerf("run", "part.tch", "--machine", "mill3"), "part.tch", "TEACH_RANGE", 5, 15)


@test("text that begins with TEACH is taught points, whatever its file is called")
def by_text(box):
    text = "; from a pendant\n  teach 1\nPOINT 1 2 3 4 5\nEND\n"
    result = box.kerf("run", "-", "--summary", "s.json", stdin=text)
    status(result, 0)
    equal((box.json("s.json")["machine"], box.json("s.json")["dialect"]), ("laser5", "teach"), "both")
    box.write("points.txt", text)
    status(box.kerf("run", "points.txt", "--dialect", "teach", "--machine", "mill5"), 0)
    refused(box.kerf("run", "points.txt", "--set", "#1=2"), 2, "variables")


@test("coverage, kerf time and a budget know the lines of taught points")
def panel(box):
    box.write("part.tch", tch("POINT 0 0 0 0 0\nFEED 600\nLINE 100 0 0 0 0\n; c\nLINE 100 10 0 0 0"))
    status(box.kerf("run", "part.tch", "--coverage", "c.csv"), 0)
    counts = [line.split(",")[1:3] for line in box.read("c.csv").decode().splitlines()[1:]]
    equal(counts, [[str(n), str(int(n != 8))] for n in range(1, 11)], "how often lines ran")
    contains(box.kerf("time", "part.tch").text, "part.tch:7", "kerf time")
    result = box.kerf("run", "part.tch", "--max-motions", "1")
    status(result, 5)


@test("taught points of any number run in the same memory")
def memory(box):
    if not harness.MEASURES_MEMORY:
        raise harness.Skipped("a sanitizer needs memory of its own")
    peaks = []
    for count in (10_000, 300_000):
        zigzag = "".join(f"LINE {n % 2} {n % 3} 0 0 {n % 5}\n" for n in range(count))
        box.write("long.tch", tch("POINT 0 0 0 0 0\nFEED 6000\n" + zigzag))
        result = box.kerf("run", "long.tch", "--machine", "mill5", "--machine-set",
                          "interpolator.mode=equal", "--max-seconds", "0", peak=True)
        status(result, 0)
        peaks.append(result.peak_kib)
    check(peaks[1] < peaks[0] + 1024, f"{peaks[1]} KiB for 300,000 records, {peaks[0]} for 10,000")


@test("an arc that is nearly straight is driven by every machine")
def nearly_straight(box):
    for machine in ("laser5", "laser-xtz", "mill5"):
        for height, way in ((1.1e-7, 100), (1e-6, 100), (1e-5, 100), (1e-8, 2), (1e-7, 2)):
            box.write("flat.tch", f"TEACH 1\nFEED 1000\nPOINT 10 0 0 0 0\nARC {10 + way / 2} {height} 0 0 0 "
                                  f"{10 + way} 0 0 0 0\nEND\n")
            if machine != "laser-xtz":
                result = box.kerf("run", "flat.tch", "--machine", machine, "--summary", "s.json")
                status(result, 0)
                near(box.json("s.json")["cut_mm"], way, 1e-6, f"{height} over {way} on {machine}")
            box.write("flat.bas", f"power(1)\nmove(10,0)\narc({10 + way / 2},{height},zpos,{10 + way},0,zpos)\n")
            status(box.kerf("run", "flat.bas", "--machine", machine, "--summary", "s.json"), 0)
            near(box.json("s.json")["cut_mm"], way, 1e-6, f"{height} over {way} on {machine}, BASIC")
