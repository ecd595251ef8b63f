"""--points: where the axes are at every period of the servo, held against formulas."""

import csv
import io
import math

import harness
from harness import check, equal, in_time, near, status, test

HEAD = "O1\nG21G90G17G94\n"


def rows_of(text):
    """Each row as a dictionary of numbers."""
    rows = csv.reader(io.StringIO(text))
    names = next(rows)
    return [dict(zip(names, map(float, row), strict=True)) for row in rows]


def points(box, program, *words, wanted=0):
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--points", "points.csv", *words), wanted)
    return rows_of(box.read("points.csv").decode())


def header(box, machine):
    box.write("part.nc", HEAD + "M30\n")
    status(box.kerf("run", "part.nc", "--machine", machine, "--points", "points.csv"), 0)
    return box.read("points.csv").decode()


def bang_bang(length, acceleration, t):
    """Way after t from rest to rest, as fast as the acceleration allows."""
    half = math.sqrt(length / acceleration)
    if t >= 2 * half:
        return length
    if t <= half:
        return acceleration * t * t / 2
    return length - acceleration * (2 * half - t) ** 2 / 2


@test("the columns of --points are those that the machine has")
def columns(box):
    wanted = {"mill3": "t,X,Y,Z,j1,j2,j3,line\n",
              "mill5": "t,X,Y,Z,A,C,j1,j2,j3,j4,j5,line\n",
              "laser3": "t,X,Y,Z,power,j1,j2,j3,line\n",
              "laser5": "t,X,Y,Z,A,C,power,j1,j2,j3,j4,j5,line\n",
              "laser-xtz": "t,X,Y,Z,power,j1,j2,j3,line\n",
              "arm4": "t,X,Y,Z,C,j1,j2,j3,j4,line\n"}
    for machine, line in wanted.items():
        equal(header(box, machine), line, f"the file of {machine} for a program without motions")


@test("a rapid accelerates and brakes as its axis can, a row a period from the first one on")
def rapid_rows(box):
    rows = points(box, HEAD + "G00X10.\nM30\n")
    equal(len(rows), math.ceil(2 * math.sqrt(10 / 3000) * 1000), "rows")
    for number, row in enumerate(rows, start=1):
        equal(row["t"], number / 1000, "time")
        near(row["X"], bang_bang(10, 3000, row["t"]), 1e-9, f"X at {row['t']} s")
        equal((row["Y"], row["Z"], row["line"]), (0, 0, 3), f"Y, Z and line at {row['t']} s")
    equal(rows[-1]["X"], 10, "the end")


@test("times are printed as a person would write them, whatever their number")
def times(box):
    box.write("part.nc", HEAD + "G04X2.\nM30\n")
    status(box.kerf("run", "part.nc", "--points", "points.csv"), 0)
    got = [line.split(",")[0] for line in box.read("points.csv").decode().splitlines()[1:]]
    equal(got, [f"{k / 1000:.3f}".rstrip("0").rstrip(".") for k in range(1, 2001)], "times")


@test("a row belongs to the line whose motion it ends, and a standstill is exactly the programmed end")
def lines_of_rows(box):
    program = HEAD + "G00X10.03\nG04X.005\nG01G09X20.07Y-3.3F6000\nG00X20.Z-1.\nM30\n"
    rows = points(box, program)
    ends = {3: (10.03, 0, 0), 4: (10.03, 0, 0), 5: (20.07, -3.3, 0), 6: (20, -3.3, -1)}
    for line, end in ends.items():
        own = [row for row in rows if row["line"] == line]
        equal((own[-1]["X"], own[-1]["Y"], own[-1]["Z"]), end, f"the last row of line {line}")
    equal([row["line"] for row in rows], sorted(row["line"] for row in rows), "order of the lines")
    dwell = [row["X"] for row in rows if row["line"] == 4]
    equal(dwell, [10.03] * 5, "the dwell of 5 ms")
    check(next(row for row in rows if row["line"] == 5)["X"] > 10.03,
          "the start is a row of the new line")


@test("rows on an arc lie on the circle, and the feed is that of the program")
def arc_rows(box):
    rows = points(box, HEAD + "G00X10.\nG03X-10.I-10.F3000\nM30\n")
    arc = [row for row in rows if row["line"] == 4]
    for row in arc:
        near(math.hypot(row["X"], row["Y"]), 10, 1e-9, f"radius at {row['t']} s")
    speeds = [math.dist((a["X"], a["Y"]), (b["X"], b["Y"])) * 1000 for a, b in zip(arc, arc[1:])]
    check(max(speeds) <= 50 + 1e-6, f"{max(speeds)} mm/s, wanted at most 50")
    near(sorted(speeds)[len(speeds) // 2], 50, 1e-3, "the usual speed, mm/s")


@test("the joints of a Cartesian machine are its axes; a laser that nothing switches has power 0")
def cartesian_joints(box):
    rows = points(box, HEAD + "G01X3.Y4.Z1.F600\nM30\n", "--machine", "laser3")
    for row in rows:
        equal((row["j1"], row["j2"], row["j3"]), (row["X"], row["Y"], row["Z"]), "joints")
        equal(row["power"], 0, "power")


def carriage(row, r_a=150, r_c=80):
    a, c = math.radians(row["A"]), math.radians(row["C"])
    return (row["X"] + r_a * math.sin(a) * math.sin(c) - r_c * math.cos(c),
            row["Y"] - r_a * math.sin(a) * math.cos(c) - r_c * math.sin(c),
            row["Z"] + r_a * math.cos(a), row["A"], row["C"])


@test("the joints of a head are the carriage that its radii ask for, every 8 ms")
def head_joints(box):
    rows = points(box, HEAD + "G01X30.Y-20.Z10.A40.C-70.F3000\nM30\n", "--machine", "laser5")
    equal([row["t"] for row in rows[:3]], [0.008, 0.016, 0.024], "times")
    for row in rows:
        for joint, wanted in enumerate(carriage(row), start=1):
            near(row[f"j{joint}"], wanted, 1e-9, f"j{joint} at {row['t']} s")
    equal([rows[-1][axis] for axis in "XYZAC"], [30, -20, 10, 40, -70], "the end")


ARM_PROGRAM = HEAD + "G00X200.Y50.\nG01X150.Y80.C20.F60\nM30\n"


@test("the joints of the arm hold the tip at every row")
def arm_joints(box):
    for row in points(box, ARM_PROGRAM, "--machine", "arm4"):
        upper, forearm = math.radians(row["j2"]), math.radians(row["j1"] + row["j2"])
        near(132 * (math.cos(upper) + math.cos(forearm)), row["X"], 1e-6, "X of the joints")
        near(132 * (math.sin(upper) + math.sin(forearm)), row["Y"], 1e-6, "Y of the joints")
        near(row["j4"], row["Z"], 1e-9, "the lift")
        near(math.remainder(row["j1"] + row["j2"] + row["j3"] - row["C"], 180), 0, 1e-6, "heading")


@test("points, summary and picture of an arm begin where it stands stretched out")
def from_the_stretched_arm(box):
    rows = points(box, HEAD + "G01X200.Y50.F600\nM30\n", "--machine", "arm4",
                  "--summary", "s.json", "--plot", "p.svg")
    equal([rows[-1][axis] for axis in "XYZC"], [200, 50, 0, 0], "the end")
    for axis, start in (("X", 264), ("Y", 0), ("Z", 0), ("C", 0), ("j1", 0), ("j2", 0), ("j3", 0)):
        near(rows[0][axis], start, 1e-4, f"{axis} of the first row")
    summary = box.json("s.json")
    near(summary["cut_mm"], math.hypot(64, 50), 1e-9, "length of the cut")
    equal(summary["extents"]["X"], [200, 200], "extents: the start does not count")
    check(b">264<" in box.read("p.svg"), "X264 among the extents of the picture")


def fastest(rows, joint):
    return max(abs(b[joint] - a[joint]) / (b["t"] - a["t"]) for a, b in zip(rows, rows[1:]))


@test("short lines along the rim of the reach are not smoothed beyond it")
def along_the_rim(box):
    ring = "".join(f"X{math.floor(264000 * math.cos(a)) / 1000:.3f}"
                   f"Y{math.floor(264000 * math.sin(a)) / 1000:.3f}\n"
                   for a in (n * 0.005 for n in range(1, 60)))
    rows = points(box, HEAD + "G01X263.99Y0F600\n" + ring + "M30\n", "--machine", "arm4")
    for joint in ("j1", "j2"):
        check(fastest(rows, joint) <= 2 + 1e-6, f"{joint} no faster than 120 degrees/min")


@test("where the axes of a rapid are done one after the other, a linkage stays near the corners")
def rapid_legs(box):
    program = HEAD + "G01X150.Y50.F6000\nG00X120.Y-52.\nX-90.Y48.\nM30\n"
    rows = points(box, program, "--machine", "arm4", "--param", "LRP=0",
                  *(word for key in ("kinematics.forearm=100", "tip.velocity=24000",
                                     "axis.T1.velocity=6000", "axis.T2.velocity=6000",
                                     "axis.T1.acceleration=100", "axis.T2.acceleration=100",
                                     "axis.T1.jerk=1000", "axis.T2.jerk=1000")
                    for word in ("--machine-set", key)))
    check(max(abs(row["j1"]) for row in rows) < 163.835, "T1 within its limit")


@test("equal steps of the arm begin where it stands")
def steps_of_the_arm(box):
    rows = points(box, HEAD + "G01X200.Y50.F600\nM30\n", "--machine", "arm4",
                  "--machine-set", "interpolator.step_mm=10")
    near(math.hypot(rows[0]["X"] - 264, rows[0]["Y"]), 10, 1e-9, "way to the first point")
    near(rows[0]["j1"], 27.935935661, 1e-6, "T1 there")  # 2 acos(|tip| / 264)


@test("a move out of reach has no record, row or time, nor has anything behind it")
def out_of_reach(box):
    program = HEAD + "G01X200.Y100.F3000\n%sM08\nG01X100.\nM30\n"
    whole = points(box, program % "M30\n", "--machine", "arm4")
    for bad in ("X260.\n", "G00X260.\n", "G31X260.\n", "G02Y-100.R110.\n", "G28X210.Y180.\n"):
        rows = points(box, program % bad, "--machine", "arm4", "--motion", "m.json",
                      "--summary", "s.json", wanted=1)
        equal(rows, whole, f"rows with {bad}")
        equal([record["line"] for record in box.motions("m.json")], [3], f"records with {bad}")
        summary = box.json("s.json")
        equal((summary["alarm"]["code"], summary["alarm"]["line"]), ("OUT_OF_REACH", 4), bad)
        equal(summary["time_s"], whole[-1]["t"], f"time with {bad}")
        equal(summary["position"]["machine"]["X"], 200, f"position with {bad}")


@test("an arm bends to the side of the elbow that its machine file names, and the tip is the same")
def elbow(box):
    program = HEAD + "G01X120.Y-80.F600\nX200.Y40.\nM30\n"
    for side, wanted in (("plus", [(22755, -18115), (15766, -5621)]), ("minus", [(-22755, 4639), (-15766, 10145)])):
        rows = points(box, program, "--machine", "arm4", "--machine-set", f"kinematics.elbow={side}",
                      "--machine-set", "interpolator.tolerance=0")
        ends = [[row for row in rows if row["line"] == line][-1] for line in (3, 4)]
        equal([(row["X"], row["Y"]) for row in ends], [(120, -80), (200, 40)], f"the tip with {side}")
        equal([(round(200 * row["j1"]), round(200 * row["j2"])) for row in ends], wanted, f"steps with {side}")


@test("--points writes what was made up to an alarm, and a budget of time ends a long dwell")
def partial_points(box):
    rows = points(box, HEAD + "G00X10.\n#1=1/0\nM30\n", wanted=1)
    equal((rows[-1]["X"], rows[-1]["line"]), (10, 3), "the last row before an alarm")
    box.write("part.nc", HEAD + "G04X90000.\nM30\n")
    result = box.kerf("run", "part.nc", "--points", "points.csv", "--max-seconds", "0.2",
                      "--summary", "s.json")
    status(result, 5)
    in_time(result, 5)
    rows = rows_of(box.read("points.csv").decode())
    equal(box.json("s.json")["status"], "budget", "status")
    equal(box.json("s.json")["time_s"], rows[-1]["t"], "time of the summary and of the last row")


@test("an hour of set-points needs no more memory than a second of them")
def memory(box):
    box.write("part.nc", HEAD + "G04X3600.\nM30\n")
    result = box.kerf("run", "part.nc", "--points", "/dev/null", peak=True)
    status(result, 0)
    if harness.MEASURES_MEMORY:
        check(0 < result.peak_kib < 64 * 1024, f"{result.peak_kib} KiB of memory")


# X, C and Z of the lens machine at five points, and how long it takes from each to the next at
# 100 mm/s, 90 degrees/s and 10 mm/s: worked out by hand from the equations of docs/kinematics.md.
LENS_POINTS = [((60, 0, 0), (35, -10, -5), 0.5), ((0, 60, 0), (35, 80, -5), 1),
               ((-50, 20, 0), (28.851648, 148.198591, -5), 0.757762),
               ((-40, -30, 0), (25, 206.869898, -5), 0.651903),
               ((30, -45, 0), (29.083269, 293.690068, -5), 0.964669)]
WITHOUT_RAMPS = [word for axis in "XCZ" for key in ("acceleration=1e12", "jerk=0")
                 for word in ("--machine-set", f"axis.{axis}.{key}")]


@test("point to point, the axes of the lens machine start and stop together, in the time of the slowest")
def point_to_point(box):
    program = HEAD + "".join(f"G00X{x}.Y{y}.Z{z}.\n" for (x, y, z), _, _ in LENS_POINTS) + "M30\n"
    for words in (WITHOUT_RAMPS, ["--machine-set", "interpolator.mode=tail"]):
        rows = points(box, program, "--machine", "laser-xtz", *words)
        start_s, stood = 0.0, (0, 0, 0)
        for line, (_, joints, lasts_s) in enumerate(LENS_POINTS, start=3):
            of_line = [row for row in rows if row["line"] == line]
            for row in of_line[:-1]:
                share = (row["t"] - start_s) / lasts_s
                for n, (begin, end) in enumerate(zip(stood, joints), start=1):
                    near(row[f"j{n}"], begin + share * (end - begin), 0.3, f"j{n} at {row['t']} s, {words}")
            for n, joint in enumerate(joints, start=1):
                near(of_line[-1][f"j{n}"], joint, 1e-6, f"j{n} behind line {line}")
            near(of_line[-1]["t"] - start_s, lasts_s, 0.00101, f"time of line {line}, {words}")
            start_s, stood = of_line[-1]["t"], joints


def chords(begin, end, count=20000):
    """Length of the way in proportion from one radius, angle and height to another, mm."""
    def at(share):
        r, degrees, z = (b + share * (e - b) for b, e in zip(begin, end))
        return r * math.cos(math.radians(degrees)), r * math.sin(math.radians(degrees)), z
    points = [at(n / count) for n in range(count + 1)]
    return sum(math.dist(a, b) for a, b in zip(points, points[1:]))


@test("tip.rapid chooses between straight rapids of the lens machine and those from point to point")
def rapids_of_the_lens_machine(box):
    program = HEAD + "G00X60.Y0.Z0.\nX0.Y60.\nM30\n"
    def nearest(*words):
        rows = points(box, program, "--machine", "laser-xtz", "--summary", "s.json", *words)
        return min(math.hypot(row["X"], row["Y"]) for row in rows if row["line"] == 4)
    near(nearest(), 60, 1e-9, "round the axis")
    near(box.json("s.json")["rapid_mm"], chords((25, 10, 5), (60, 0, 0)) + math.pi * 30, 1e-6, "length")
    near(nearest("--machine-set", "tip.rapid=straight"), 60 / math.sqrt(2), 0.01, "straight")
