"""--pulses: the step pulses of the motors, counted, timed and read back from both kinds of file."""

import csv
import io
import math
import os
import re

import harness
from harness import alarm, check, contains, equal, near, refused, status, test
from limit_tests import fill
from set_point_tests import ARM_PROGRAM, rows_of

HEAD = "O1\nG21G90G17G94\n"
TIMING = {"pulse_width_ns": 2500, "pulse_gap_ns": 2500, "direction_setup_ns": 5000}
BAND = 1e-6

# Lines, arcs and standstills in all directions; it ends away from where it starts.
TOUR = (HEAD + "G00X10.Y-5.\nG01X3.F1500\nG02X-3.R3.\nG04X.02\nG03X-3.Y-5.I4.J1.\nG00Z-7.3\n"
        "G01X.1Y.1Z-.1F3000\nG91X-.004\nX.004\nG90G00X1.237Y-2.468Z-3.691\nM30\n")


def csv_pulses(text):
    """(time_ns, axis, direction) of each pulse."""
    table = list(csv.reader(io.StringIO(text)))
    equal(table[0], ["time_ns", "axis", "direction"], "the header")
    return [(int(time), axis, int(direction)) for time, axis, direction in table[1:]]


def pulses(box, program, *words, name="pulses.csv"):
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--pulses", name, "--points", "points.csv", *words), 0)
    return csv_pulses(box.read(name).decode()) if name.endswith(".csv") else None


def counts(made, until_ns=math.inf):
    found = {}
    for time_ns, axis, direction in made:
        if time_ns <= until_ns:
            found[axis] = found.get(axis, 0) + direction
    return found


@test("each pulse comes where the line between two set-points is half a step away")
def times(box):
    made = pulses(box, HEAD + "G00X10.\nM30\n")
    # 3000 mm/s² and 200 steps a mm: after n ms the axis is at 0.3 n² steps.
    way = [0.3 * n * n for n in range(8)]
    wanted = []
    for n in range(7):
        for step in range(1, 15):
            if way[n] < step - 0.5 + BAND <= way[n + 1]:
                part = (step - 0.5 + BAND - way[n]) / (way[n + 1] - way[n])
                wanted.append(((n + part) * 1e6, "X", 1))
    check(len(wanted) > 10, "nothing was wanted")
    for got, want in zip(made, wanted):
        equal(got[1:], want[1:], "axis and direction")
        near(got[0], want[0], 1, "ns of a pulse")
    equal(counts(made), {"X": 2000}, "steps of 10 mm")


def replay(box, made, names, steps_per_unit):
    """Where the motors stand at each set-point, from the points and from the pulses."""
    points = rows_of(box.read("points.csv").decode())
    check(len(points) > 100, f"only {len(points)} set-points")
    stand = dict.fromkeys(names, 0)
    waiting = list(reversed(made))
    for row in points:
        while waiting and waiting[-1][0] <= row["t"] * 1e9:
            _, axis, direction = waiting.pop()
            stand[axis] += direction
        for joint, name in enumerate(names, start=1):
            steps = row[f"j{joint}"] * steps_per_unit[joint - 1]
            yield row, name, stand[name], steps
    equal(waiting, [], "pulses behind the last set-point")


@test("replayed, the pulses stand at the nearest step of every set-point")
def nearest_step(box):
    made = pulses(box, TOUR)
    for row, name, stand, steps in replay(box, made, "XYZ", [200] * 3):
        near(stand, steps, 0.5 + BAND + 1e-6, f"{name} at {row['t']} s, steps")
    equal(counts(made), {"X": round(1.237 * 200), "Y": round(-2.468 * 200),
                         "Z": round(-3.691 * 200)}, "steps at the end")


@test("pulses are in the order of their times, and no motor is asked for more than its amplifier takes")
def order(box):
    made = pulses(box, TOUR)
    equal([p[0] for p in made], sorted(p[0] for p in made), "times")
    last = {}
    for time_ns, axis, direction in made:
        if axis in last:
            before_ns, before = last[axis]
            least = TIMING["pulse_width_ns"] + (TIMING["pulse_gap_ns"] if before == direction
                                                else TIMING["direction_setup_ns"])
            check(time_ns - before_ns >= least - 1, f"{axis}: {time_ns - before_ns} ns")
        last[axis] = time_ns, direction


@test("steps per unit of the machine file count, and a negative number turns the motor round")
def steps_per_unit(box):
    made = pulses(box, HEAD + "G01X5.Y5.Z-5.F600\nM30\n", "--machine-set",
                  "axis.Y.steps_per_unit=-40", "--machine-set", "axis.Z.steps_per_unit=0.1")
    equal(counts(made), {"X": 1000, "Y": -200}, "steps")


@test("the motors of a head follow the carriage, not the focus")
def head(box):
    made = pulses(box, HEAD + "G01X30.Y-20.Z10.A40.C-70.F3000\nM30\n", "--machine", "laser5")
    a, c = math.radians(40), math.radians(-70)
    carriage = {"X": 30 + 150 * math.sin(a) * math.sin(c) - 80 * math.cos(c) + 80,
                "Y": -20 - 150 * math.sin(a) * math.cos(c) - 80 * math.sin(c),
                "Z": 10 + 150 * math.cos(a) - 150}
    wanted = {axis: round(way * 200) for axis, way in carriage.items()}
    # From a carriage at (-80, 0, 150), which stands on steps.
    equal(counts(made), {**wanted, "A": 40000, "C": -70000}, "steps")


@test("the motors of the arm have their names and stand at the nearest step of every set-point")
def arm(box):
    made = pulses(box, ARM_PROGRAM, "--machine", "arm4")
    names, steps = ["T1", "T2", "T3", "Z"], [200, 200, 4 / 3, 100]
    for row, name, stand, at in replay(box, made, names, steps):  # from joints at 0
        near(stand, at, 0.501, f"{name} at {row['t']} s, steps")
    check(set(counts(made)) <= set(names), f"axes {set(counts(made))}")


# --- Value change dumps

IDENTIFIER = re.compile(r"[!-~]+")  # IEEE 1364, 18.2.1: printable characters
DECLARATIONS = {"$comment", "$date", "$enddefinitions", "$scope", "$timescale", "$upscope", "$var",
                "$version"}


def read_vcd(text):
    """Names of the wires by their codes, their first values, and (time, wire, value) of changes."""
    words = iter(text.split())
    names, first, changes = {}, {}, []
    defined, scopes, now, dumping = False, 0, None, False
    for word in words:
        if not defined:
            check(word in DECLARATIONS, f"{word} among the declarations")
            body = []
            for part in words:
                if part == "$end":
                    break
                body.append(part)
            if word == "$timescale":
                check(re.fullmatch(r"(1|10|100) ?(s|ms|us|ns|ps|fs)", " ".join(body)), "timescale")
                equal(" ".join(body), "1 ns", "timescale")
            elif word == "$scope":
                check(body[0] in ("module", "task", "function", "begin", "fork"), f"scope {body}")
                scopes += 1
            elif word == "$upscope":
                scopes -= 1
            elif word == "$var":
                kind, size, code, name = body
                equal((kind, size), ("wire", "1"), f"{name}: kind and size")
                check(IDENTIFIER.fullmatch(code) and code not in names, f"code {code!r}")
                check(re.fullmatch(r"[A-Za-z_][A-Za-z0-9_$]*", name), f"name {name!r}")
                check(scopes == 1, f"{name} outside of a scope")
                names[code] = name
            elif word == "$enddefinitions":
                equal((body, scopes), ([], 0), "the end of the declarations")
                defined = True
        elif word.startswith("#"):
            time_ns = int(word[1:])
            check(now is None or time_ns > now, f"time {time_ns} behind {now}")
            now = time_ns
        elif word == "$dumpvars":
            dumping = True
        elif word == "$end":
            check(dumping, "an $end too many")
            dumping = False
        else:
            check(word[0] in "01xz" and word[1:] in names, f"the change {word!r}")
            if dumping:
                first[names[word[1:]]] = int(word[0])
            else:
                changes.append((now, names[word[1:]], int(word[0])))
    check(defined and not dumping, "the dump breaks off")
    equal(sorted(first), sorted(names.values()), "wires with a first value")
    return names, first, changes


def vcd_pulses(text):
    """The pulses of a dump; looks at widths and at the time that a direction stands before."""
    names, level, changes = read_vcd(text)
    made, turned, rose = [], {}, {}
    for time_ns, wire, value in changes:
        check(level[wire] != value, f"{wire} changes to what it is at {time_ns}")
        level[wire] = value
        axis, kind = wire.rsplit("_", 1)
        if kind == "dir":
            check(level[axis + "_step"] == 0, f"{axis} turns while its pulse is high at {time_ns}")
            turned[axis] = time_ns
        elif value:
            check(time_ns - turned.get(axis, -math.inf) >= TIMING["direction_setup_ns"],
                  f"{axis} steps too soon after turning at {time_ns}")
            rose[axis] = time_ns
            made.append((time_ns, axis, 1 if level[axis + "_dir"] else -1))
        else:
            equal(time_ns - rose[axis], TIMING["pulse_width_ns"], f"width at {time_ns}")
    return names, made


@test("a .vcd is a dump as IEEE 1364 describes it, and holds the pulses of the .csv")
def dump(box):
    wanted = pulses(box, TOUR)
    pulses(box, TOUR, name="pulses.vcd")
    names, made = vcd_pulses(box.read("pulses.vcd").decode())
    equal(sorted(names.values()), [axis + wire for axis in "XYZ" for wire in ("_dir", "_step")],
          "wires")
    equal(sorted(made), sorted(wanted), "pulses")


@test("files of a run without motions have their heads and no pulse")
def no_pulses(box):
    for machine, axes in (("arm4", ["T1", "T2", "T3", "Z"]), ("laser-xtz", ["X", "C", "Z"])):
        equal(pulses(box, HEAD + "M30\n", "--machine", machine), [], "pulses")
        pulses(box, HEAD + "M30\n", "--machine", machine, name="pulses.vcd")
        names, made = vcd_pulses(box.read("pulses.vcd").decode())
        equal((sorted(set(name.rsplit("_", 1)[0] for name in names.values())), made),
              (sorted(axes), []), "axes and pulses")


@test("--pulses - is CSV on standard output; with the other outputs of a run it is the same bytes")
def several(box):
    box.write("part.nc", TOUR)
    out = box.kerf("run", "part.nc", "--pulses", "-")
    status(out, 0)
    everything = box.kerf("run", "part.nc", "--pulses", "a.csv", "--points", "b.csv", "--post",
                          "c.nc", "--motion", "d.json", "--plot", "e.svg", "--coverage", "f.csv",
                          "--summary", "g.json")
    status(everything, 0)
    equal(box.read("a.csv"), out.out, "pulses")
    for name in ("a.csv", "b.csv", "c.nc", "d.json", "e.svg", "f.csv", "g.json"):
        contains(everything.err, f"wrote {name}\n", "the summary")


@test("pulses go to files that end in .csv or .vcd, everything else is wrong usage")
def endings(box):
    box.write("part.nc", TOUR)
    for name in ("pulses", "pulses.txt", "pulses.csv.gz", "pulses.CSV", "csv", ".vcd/pulses"):
        refused(box.kerf("run", "part.nc", "--pulses", name), 2, name, ".csv", ".vcd")
    equal(box.files(), ["part.nc"], "files behind it")


# --- What is not written

@test("--keep-partial is what it takes to write --pulses when the end is not reached")
def keep_partial(box):
    endings = {"an alarm": ("G01X1.F100\n#1=1/0\nM30\n", [], 1),
               "a stop": ("G01X1.F100\nM01\nM30\n", ["--optional-stop"], 0),
               "a budget": ("G01X1.F100\nN1GOTO1\n", ["--max-seconds", "0.05"], 5)}
    for name, (blocks, words, wanted) in endings.items():
        box.write("part.nc", HEAD + blocks)
        command = ["run", "part.nc", "--pulses", "pulses.csv", *words]
        result = box.kerf(*command)
        status(result, wanted)
        check("pulses.csv" not in box.files(), f"--pulses was written after {name}")
        check("wrote" not in result.err, f"after {name} the summary claims that it wrote a file")
        result = box.kerf(*command, "--keep-partial")
        status(result, wanted)
        contains(result.err, "wrote pulses.csv", f"the summary after {name}")
        equal(counts(csv_pulses(box.read("pulses.csv").decode())), {"X": 200}, f"after {name}")
        os.remove(box.path("pulses.csv"))


SLOW = ("--machine-set", "drive.pulse_width_ns=40000")  # at most 23,529 steps/s


@test("steps that a motor cannot follow are an alarm at their line, and no pulses are written")
def too_fast(box):
    program = HEAD + "G01X5.F600\nG00X60.\nG01X0F600\nM30\n"
    box.write("part.nc", program)
    command = ["run", "part.nc", "--pulses", "pulses.csv", "--summary", "s.json", "--points",
               "points.csv", "--post", "post.nc", *SLOW]
    result = box.kerf(*command)
    alarm(result, "STEP_RATE", 4)
    contains(result.err, "axis X", "the sentence")
    contains(result.err, "    G00X60.\n    ^\n", "the source line")
    equal(box.files(), ["part.nc", "points.csv", "s.json"], "files behind it")
    summary = box.json("s.json")
    equal((summary["status"], summary["alarm"]["code"], summary["alarm"]["line"],
           summary["alarm"]["program"]), ("alarm", "STEP_RATE", 4, "O0001"), "the summary")
    last = rows_of(box.read("points.csv").decode())[-1]
    equal((last["t"], last["line"]), (summary["time_s"], 4), "the last set-point")
    near(summary["position"]["machine"]["X"], last["X"], 1e-5, "where the machine stands")
    check(5 < last["X"] < 60, f"it stands at {last['X']}")

    alarm(box.kerf(*command, "--keep-partial"), "STEP_RATE", 4)
    made = csv_pulses(box.read("pulses.csv").decode())
    near(counts(made)["X"], last["X"] * 200, 25, "steps up to there")
    status(box.kerf("run", "part.nc", *SLOW), 0)


@test("a motor that cannot follow in a called program is told with the file of that program")
def too_fast_elsewhere(box):
    box.write("library/O0002", "O2\n\n\nG00X60.\nM99\n")
    box.write("part.nc", HEAD + "M98P2\nM30\n")
    result = box.kerf("run", "part.nc", "--library", "library", "--pulses", "pulses.csv",
                      "--diagnostics", "json", *SLOW)
    status(result, 1)
    for part in ('"code":"STEP_RATE"', '"file":"library/O0002"', '"line":4', '"program":"O0002"'):
        contains(result.err, part, "the diagnostic")


@test("a motor that turns round before its direction has settled is an alarm")
def turns_too_soon(box):
    box.write("part.nc", HEAD + "G01X5.0025F600\nX0\nM30\n")
    words = ["--pulses", "pulses.csv", "--machine-set", "axis.X.steps_per_unit=-199.999999"]
    status(box.kerf("run", "part.nc", *words), 0)
    result = box.kerf("run", "part.nc", *words, "--machine-set",
                      "drive.direction_setup_ns=400000000")
    alarm(result, "STEP_RATE", 4)
    contains(result.err, "turns round", "the sentence")


@test("an hour of pulses needs no more memory than a second of them")
def memory(box):
    box.write("part.nc", HEAD + "#1=0\nWHILE[#1LT60]DO1\nG01X60.Y20.F120\nX0Y0\n#1=#1+1\nEND1\nM30\n")
    os.symlink("/dev/null", box.path("null.vcd"))
    result = box.kerf("run", "part.nc", "--pulses", "null.vcd", "--summary", "s.json", peak=True)
    status(result, 0)
    check(box.json("s.json")["time_s"] > 3600, "less than an hour")
    if harness.MEASURES_MEMORY:
        check(0 < result.peak_kib < 64 * 1024, f"{result.peak_kib} KiB of memory")


# Into a pipe, whose lines are counted: the pulses of hours need no disk.
COUNTED = ("sh", "-c", 'mkfifo pulses.csv; wc -l < pulses.csv > lines & "$@"; r=$?; wait; exit $r', "sh")


def pulses_of_hours(box, hours):
    """Runs this long in short lines; returns KiB of memory at the peak."""
    pairs = 30_000 * hours  # of lines that take 67 ms and a ramp, each to a standstill
    fill(box, "part.nc", HEAD.encode() + b"G61G91G01F1200\n", b"X1.2Y.6\nX-1.2Y-.6\n", pairs, b"M30\n")
    result = box.kerf("run", "part.nc", "--pulses", "pulses.csv", "--summary", "s.json", peak=True,
                      before=COUNTED)
    status(result, 0)
    check(box.json("s.json")["time_s"] > 3600 * hours, f"less than {hours} h")
    equal(int(box.read("lines")), 1 + pairs * 2 * (240 + 120), "lines of the file")
    os.remove(box.path("pulses.csv"))
    return result.peak_kib


@test("twice as long a program of pulses needs no more memory")
def memory_of_hours(box):
    one, two = (pulses_of_hours(box, hours) for hours in (1, 2))
    if harness.MEASURES_MEMORY:
        check(0 < one < 24 * 1024, f"{one} KiB of memory for an hour")
        check(two < one + 1024, f"{two} KiB of memory for two hours, {one} KiB for one")
