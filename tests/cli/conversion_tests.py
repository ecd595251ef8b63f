"""From one language and machine to another: what comes out is the same path, within what is stated.

The oracle is the formula of each curve, written out here. Each test prints what it measured when it
fails; FINE_MM is what chords of 0.1 degrees leave of the curves below.
"""

import csv
import math
import re

from harness import check, contains, equal, status, test
from post_tests import again, compare

FINE_MM = 1e-4
PATH_MM = 0.02  # a machine's tip from the programmed path; interpolator.tolerance is 0.01


class Track:
    """Distances from a curve, given as points in order, of places that come along it."""

    AHEAD = 400  # segments that are looked at from the nearest one

    def __init__(self, points):
        self.points, self.at = points, 0

    def distance(self, place):
        last = len(self.points) - 1
        begin, end = max(0, self.at - 5), min(last, self.at + self.AHEAD)
        best, self.at = min((self.from_segment(place, i), i) for i in range(begin, end))
        return best

    def from_segment(self, place, i):
        (x0, y0), (x1, y1) = self.points[i], self.points[i + 1]
        dx, dy = x1 - x0, y1 - y0
        square = dx * dx + dy * dy
        t = ((place[0] - x0) * dx + (place[1] - y0) * dy) / square if square else 0
        t = min(1.0, max(0.0, t))
        return math.hypot(place[0] - x0 - t * dx, place[1] - y0 - t * dy)


def rows_of(box, name, every=1):
    """One row of so many."""
    names, *rows = box.read(name).decode().splitlines()
    return list(csv.DictReader([names, *rows[::every]]))


CARDIOID = """speed(2)
power(80)
k=6
for i=0 to 360
  t=i*PI/180
  r=k*(1+cos(t))
  if i == 0 then move(r*cos(t), r*sin(t), 0)
  line(r*cos(t), r*sin(t), 0)
next
end
"""
CHORDS_MM = 4e-4  # what the program's own chords of a degree leave of the cardioid


def cardioid(degrees):
    t = math.radians(degrees)
    r = 6 * (1 + math.cos(t))
    return 120 + r * math.cos(t), 100 + r * math.sin(t)


@test("a BASIC cardioid becomes a pattern whose replay stays on the curve within the bound that is told")
def cardioid_pattern(box):
    box.write("cardioid.bas", CARDIOID)
    box.write("origin.toml", "[work.G54]\nX = 120\nY = 100\n")
    result = box.kerf("run", "cardioid.bas", "--machine", "arm4", "--offsets", "origin.toml",
                      "--pattern", "heart.pat")
    status(result, 0)
    told = re.search(r"leaves the path by at most ([\d.]+) mm", result.err)
    check(told, f"no bound is told: {result.err}")
    bound = float(told[1])
    check(bound < 0.05, f"the bound is {bound} mm")
    status(box.kerf("pattern", "replay", "heart.pat", "--points", "points.csv", "--motion",
                    "motion.json"), 0)
    cuts = {str(record["line"]) for record in box.motions("motion.json") if record["kind"] == "line"}
    places = [(float(row["X"]), float(row["Y"])) for row in rows_of(box, "points.csv", 10)
              if row["line"] in cuts and abs(float(row["Z"])) < 1e-9]
    track = Track([cardioid(i / 10) for i in range(3601)])
    farthest = max(map(track.distance, places))
    most = bound + CHORDS_MM + FINE_MM
    check(farthest <= most, f"the replay is {farthest:.5f} mm off the cardioid, told are {bound}")
    check(farthest > bound / 10, f"{farthest} mm: no arm with whole pulses is that near")
    check(track.at > 3550, f"the replay ends at {track.at / 10} degrees of the cardioid")


# A polygon, a clover by short lines and a whole circle, by macros; cuts have lines of their own.
MACROS = """O1
G21G90G17G94G54
G65P9001R12.S6.F[#500]
G65P9002R8.F[#500]
G00X10.Y0
G03I-10.F[#500]
M30
O9001
#1=0
G00X#18Y0
WHILE[#1LE#19]DO1
G01X[#18*COS[#1*360/#19]]Y[#18*SIN[#1*360/#19]]F#9
#1=#1+1
END1
M99
O9002
#1=0
G00X[#18+2]Y0
WHILE[#1LE360]DO1
#2=#18+2*COS[3*#1]
G01X[#2*COS[#1]]Y[#2*SIN[#1]]F#9
#1=#1+1
END1
M99
"""
CUT_LINES = {"6", "12", "21"}
MACHINES = {"arm4": (150, 80, 60), "laser-xtz": (60, 30, 300), "laser3": (-100, 50, 1500),
            "mill3": (100, -50, 1500)}  # origin X, Y, feed


def polar(radius, degrees):
    t = math.radians(degrees)
    return radius * math.cos(t), radius * math.sin(t)


def programmed():
    """The three cuts, one behind the other."""
    polygon = [polar(12, side * 60) for side in range(7)]
    clover = [polar(8 + 2 * math.cos(math.radians(3 * i)), i) for i in range(361)]
    circle = [polar(10, i / 10) for i in range(3601)]
    return {"12": polygon, "21": clover, "6": circle}


def macro_program(box, machine):
    x, y, feed = MACHINES[machine]
    box.write("part.nc", MACROS)
    box.write("origin.toml", f"[work.G54]\nX = {x}\nY = {y}\n")
    return ["run", "part.nc", "--machine", machine, "--offsets", "origin.toml",
            "--set", f"#500={feed}"]


def on_machine(machine):
    def run(box):
        status(box.kerf(*macro_program(box, machine), "--points", "points.csv"), 0)
        x, y, _ = MACHINES[machine]
        curves = programmed()
        tracks = {line: Track(points) for line, points in curves.items()}
        farthest, seen = 0, dict.fromkeys(curves, 0)
        for row in rows_of(box, "points.csv", 3):
            if row["line"] in tracks:
                place = float(row["X"]) - x, float(row["Y"]) - y
                farthest = max(farthest, tracks[row["line"]].distance(place))
                seen[row["line"]] += 1
        check(min(seen.values()) > 100, f"set-points of the cuts: {seen}")
        check(farthest <= PATH_MM, f"the tip is {farthest:.5f} mm off the programmed path")
        for line, track in tracks.items():
            check(track.at >= len(track.points) - 60, f"the cut of line {line} is not whole")
    return run


def posted(machine):
    def run(box):
        status(box.kerf(*macro_program(box, machine), "--post", "post.nc", "--motion", "a.json"), 0)
        text = box.read("post.nc").decode()
        check(not re.search(r"[#\[\]]|WHILE|G65|M98", text), "macros in the posted program")
        box.write("again.nc", again(text))
        status(box.kerf("run", "again.nc", "--machine", machine, "--decimal-point", "calculator",
                        "--motion", "b.json"), 0)
        compare(box.motions("a.json"), box.motions("b.json"))
    return run


for name in MACHINES:
    test(f"the tip of {name} follows a macro program of the mill within {PATH_MM} mm")(on_machine(name))
    test(f"macros posted for {name} and run again move the same")(posted(name))


@test("laser BASIC posted as G-code and run again has the same moves, and S in the place of its power")
def basic_posted(box):
    box.write("part.bas", "speed(50)\npower(80)\nmove(10,0)\nline(20,0)\npower(25)\n"
              "circle(20,10,5)\narc(0,0,4,0,810)\nend\n")
    status(box.kerf("run", "part.bas", "--post", "post.nc", "--motion", "a.json"), 0)
    text = box.read("post.nc").decode()
    contains(text, "FULL POWER IS S1000", "the head of the posted program")
    blocks = [line for line in text.splitlines() if not line.startswith("(")]
    beam = [block for block in blocks if re.match(r"(M3|M5|S)\b|S\d", block)]
    equal(beam, ["M5", "S800", "M3 S800", "M5", "M3 S250", "M5", "M3 S250", "M5"], "the beam")
    box.write("again.nc", again(text))
    status(box.kerf("run", "again.nc", "--machine", "laser3", "--decimal-point", "calculator",
                    "--motion", "b.json"), 0)
    whole = [r for r in box.motions("b.json") if r["kind"] == "arc" and r["to"]["X"] == 4]
    check(len(whole) == 2, f"810 degrees are two circles and a quarter: {whole}")
