"""--points of a lathe: X is a diameter and its axis the radius; threads keep step with the spindle, figures on
the face stay on their line."""

import csv
import io
import math

from harness import check, equal, near, status, test


def points(box, machine, program, *words):
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--machine", machine, "--points", "points.csv", *words), 0)
    text = box.read("points.csv").decode()
    return text.splitlines()[0], [{key: float(value) for key, value in row.items()}
                                  for row in csv.DictReader(io.StringIO(text))]


@test("X of a lathe's set-points is a diameter, j1 its radius")
def diameters(box):
    header, rows = points(box, "lathe2", "O1\nG98\nG00X30.Z5.\nG01X40.Z-5.F600\nM30\n")
    equal(header, "t,X,Z,j1,j2,line", "the columns")
    check(all(row["X"] == 2 * row["j1"] and row["Z"] == row["j2"] for row in rows), "X is not twice j1")
    cut = [row for row in rows if row["line"] == 4]
    for row in cut:
        near(row["X"] - 30, 5 - row["Z"], 1e-9, f"the line at {row['t']} s")
    equal((cut[-1]["X"], cut[-1]["Z"]), (40, -5), "where it ends")
    header, _ = points(box, "lathe3c", "O1\nM30\n")
    equal(header, "t,X,Z,C,j1,j2,j3,line", "the columns with a C axis")


def steady(rows, line):
    """The set-points of a line that lie behind its run-up and before it brakes."""
    cut = [row for row in rows if row["line"] == line]
    return cut[len(cut) // 4:-len(cut) // 4]


@test("a thread advances by its lead a turn, and each pass meets the same place of the spindle")
def thread_in_step(box):
    rpm, lead = 480, 2.5
    _, rows = points(box, "lathe2", f"O1\nG97S{rpm}M03\nG00X30.Z10.\nG32Z-40.F{lead}\nG00X34.\nZ10.\nX29.\n"
                                    f"G04X.123\nG32Z-40.F{lead}\nM30\n")
    starts = []
    for line in (4, 9):
        run = steady(rows, line)
        check(len(run) > 500, f"line {line} has {len(run)} set-points in the middle")
        # Turns of a spindle that has this speed from the start of the run on.
        offs = [row["Z"] + lead * row["t"] * rpm / 60 for row in run]
        near(max(offs) - min(offs), 0, lead * 1e-6, f"Z off its lead along line {line}")
        starts.append(offs[0] / lead)
    turns = starts[1] - starts[0]
    near(turns, round(turns), 1e-6, "turns between the two passes")


@test("a tapered thread keeps its lead along Z, one on a face along X")
def thread_axes(box):
    rpm = 300
    _, rows = points(box, "lathe2", f"O1\nG97S{rpm}M03\nG00X30.Z10.\nG32X40.Z-40.F2.\nG00X60.\nZ0\nG32X20.F1.5\nM30\n")
    for line, axis, lead, sign in ((4, "Z", 2, 1), (7, "j1", 1.5, 1)):
        run = steady(rows, line)
        offs = [row[axis] + sign * lead * row["t"] * rpm / 60 for row in run]
        check(len(run) > 500, f"line {line} has {len(run)} set-points in the middle")
        near(max(offs) - min(offs), 0, lead * 1e-6, f"{axis} off its lead along line {line}")


@test("a growing lead is z = L turns + K turns²/2")
def growing(box):
    rpm, lead, grows = 300, 2, 0.1
    _, rows = points(box, "lathe2", f"O1\nG97S{rpm}M03\nG00X30.Z0\nG34Z-60.F{lead}.K{grows}\nM30\n")
    run = steady(rows, 4)
    way = [-row["Z"] for row in run]
    # Where the lead has become L + K θ, v = n (L + K θ): θ from the place, held against the time.
    turns = [(math.sqrt(lead * lead + 2 * grows * z) - lead) / grows for z in way]
    offs = [theta - row["t"] * rpm / 60 for theta, row in zip(turns, run)]
    # The interpolator approaches a speed that changes along the path: 20 turns within a few thousandths.
    near(max(offs) - min(offs), 0, 3e-3, "turns off those of the spindle")


@test("set-points of G12.1 stay on the line and on the arc that were programmed on the face")
def faces(box):
    _, rows = points(box, "lathe3c", "O1\nG98\nG00X40.Z5.C0\nG12.1\nG01X0.C20.F600\nG03X-40.C0I-0J-20.\n"
                                     "G13.1\nM30\n")
    places = {line: [(row["X"] / 2 * math.cos(math.radians(row["C"])),
                      row["X"] / 2 * math.sin(math.radians(row["C"]))) for row in rows if row["line"] == line]
              for line in (5, 6)}
    check(all(len(found) > 500 for found in places.values()), "the figure has too few set-points")
    # Near the corner between them the path is rounded, within the tolerance of chords.
    for u, v in places[5]:
        near((u + v - 20) / math.sqrt(2), 0, 1e-6 if v < 19.9 else 1e-3, f"off the line at {u} {v}")
    for u, v in places[6]:
        near(math.hypot(u, v), 20, 1e-6 if abs(u) > 0.1 else 1e-3, f"off the circle at {u} {v}")
