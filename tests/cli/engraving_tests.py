"""kerf run --pattern: programs as patterns."""

import math

from harness import alarm, check, contains, equal, near, status, test
from pattern_files import AXES, CIRCLE, HEAD, decoded, forward, records_of
from pulse_tests import csv_pulses


def fields(box, name):
    """The records of a pattern; checks that no field of a triplet holds more than 30."""
    for record in records_of(decoded(box, name)):
        if record[0] == "S":
            check(all(abs(int(n)) <= 30 for n in record[1:]), f"a field of {record}")
        yield record


@test("a circle becomes a pattern whose wheel keeps to it, pulse by pulse")
def circle(box):
    box.write("part.nc", CIRCLE)
    result = box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "a.pat")
    status(result, 0)
    contains(result.err, "the wheel leaves the path by at most 0.02", "the summary")
    contains(result.err, "measured after every pulse: 0.02", "the summary")
    contains(result.err, "wrote a.pat\n", "the summary")
    records = list(fields(box, "a.pat"))
    equal(records[:3], [["F", "Z", "500"], ["F", "T2", "-5318"], ["F", "T1", "18205"]], "the travel")
    status(box.kerf("pattern", "replay", "a.pat", "--pulses", "p.csv", "--summary", "s.json"), 0)
    equal(box.json("s.json")["counters"]["T1"], 18205, "T1 behind the circle")
    stand = dict.fromkeys(AXES, 0)
    worst, last = 0, -1
    for time_ns, axis, direction in csv_pulses(box.read("p.csv").decode()):
        if time_ns != last and stand["Z"] < 0:
            x, y = forward(stand["T1"] * 0.005, stand["T2"] * 0.005)
            worst = max(worst, abs(math.hypot(x - 150, y - 60) - 25))
        stand[axis] += direction
        last = time_ns
    check(0.01 < worst < 0.0285, f"the wheel is {worst} mm off")


@test("the same program and a little tolerance make fewer triplets")
def tolerance(box):
    box.write("part.nc", HEAD + "G00Z5.\nX70.Y10.\nG01Z-.1F60.\nG03I-1.F78.\nG00Z5.\nM30\n")
    made = []
    for tolerance_mm in ("0.012", "0.1"):
        status(box.kerf("run", "part.nc", "--machine", "cartesian-step", "--pattern", "a.pat",
                        "--machine-set", f"pattern.tolerance={tolerance_mm}"), 0)
        made.append(len(list(fields(box, "a.pat"))))
    check(made[0] > 1.3 * made[1], f"records: {made}")


@test("sharp corners are turned in the air, blunt ones on the way")
def corners(box):
    box.write("part.nc", HEAD + "G00Z5.\nX100.Y50.\nG01Z-.1F60.\nX110.\nX120.Y51.\nY70.\nG00Z5.\nM30\n")
    result = box.kerf("run", "part.nc", "--machine", "cartesian-step", "--pattern", "a.pat")
    status(result, 0)
    contains(result.err, "1 corners turned in the air", "the summary")
    fast = [record[1:] for record in fields(box, "a.pat") if record[0] == "F"]
    equal(fast, [["Z", "500"], ["T2", "5000"], ["T1", "10000"], ["Z", "-510"], ["Z", "210"],
                 ["T3", "112"], ["Z", "-210"], ["Z", "510"]], "fast records")
    status(box.kerf("run", "part.nc", "--machine", "cartesian-step", "--pattern", "a.pat",
                    "--machine-set", "pattern.tangent_jump_deg=90"), 0)
    fast = [record for record in fields(box, "a.pat") if record[0] == "F"]
    equal(len(fast), 5, "fast records when every corner may be turned on the work")


@test("a cut that changes its depth along X and Y is an alarm, and no pattern is written")
def ramp(box):
    box.write("part.nc", HEAD + "G00X100.Y50.\nG01X110.Z-1.F60.\nM30\n")
    result = box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "a.pat")
    alarm(result, "PATTERN_MOTION", 4)
    equal(box.files(), ["part.nc"], "files behind it")
    alarm(box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "a.pat", "--keep-partial"),
          "PATTERN_MOTION", 4)
    equal([record[0] for record in fields(box, "a.pat")][:2], ["F", "F"], "what was made before")


BEFORE_REFUSED = "G00X150.Y0Z2.\nG01Z-.1F60.\n"
REFUSED = {
    "a cut that changes its depth": "G01X160.Z-.2",
    "a helix": "G03X160.Y10.Z-.3R10.",
    "a probing move": "G31X160.",
}


def refused_motion(block):
    def run(box):
        box.write("part.nc", HEAD + BEFORE_REFUSED + block + "\nX170.\nM30\n")
        box.write("before.nc", HEAD + BEFORE_REFUSED + "M30\n")
        outputs = ["--machine", "arm4", "--summary", "s.json", "--motion", "m.jsonl", "--points", "p.csv"]
        status(box.kerf("run", "before.nc", *outputs), 0)
        before, motions, points = box.json("s.json"), box.motions("m.jsonl"), box.read("p.csv")
        for asked in (outputs, outputs[:4]):
            alarm(box.kerf("run", "part.nc", *asked, "--pattern", "a.pat"), "PATTERN_MOTION", 5)
            summary = box.json("s.json")
            for key in ("motions", "time_s", "rapid_mm", "cut_mm", "extents", "position"):
                equal(summary[key], before[key], key)
            equal((summary["status"], summary["alarm"]["line"]), ("alarm", 5), "the alarm")
        equal(box.motions("m.jsonl"), [m for m in motions if m["kind"] != "end"], "motions")
        equal(box.read("p.csv"), points, "set-points")
    return run


for name, block in REFUSED.items():
    test(f"records of a run end before what a pattern cannot hold: {name}")(refused_motion(block))


@test("corners above the height of travel are turned in the air")
def high_corners(box):
    box.write("part.nc", HEAD + "G00Z2.\nX100.Y50.\nG01Z-.1F60.\nX120.\nY70.\nG00Z5.\nM30\n")
    box.write("z20.toml", "[work.G54]\nZ=20\n")
    result = box.kerf("run", "part.nc", "--machine", "arm4", "--offsets", "z20.toml", "--pattern", "a.pat")
    status(result, 0)
    contains(result.err, "1 corners turned in the air", "the summary")
    turns = fast_around_turns(box, "a.pat")
    equal(turns[1:], [(["Z", "200"], ["Z", "-200"])], "moves of the lift around the corner")


def fast_around_turns(box, name):
    """Fast records in front of each one of T3 and behind it."""
    fast = [record[1:] for record in fields(box, name) if record[0] == "F"]
    return [(fast[n - 1], fast[n + 1]) for n, record in enumerate(fast) if record[0] == "T3"]


@test("the wheel comes down once where a program plunges in steps, and dwells are told of")
def plunge_in_steps(box):
    box.write("part.nc", HEAD + "G00X100.Y0Z2.\nG01Z-.1F60.\nG04P500\nZ-.2\nY10.\nG00Z2.\nM30\n")
    result = box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "a.pat", "--summary", "s.json")
    status(result, 0)
    contains(result.err, "  a dwell of the program left out", "the summary")
    told = box.json("s.json")["pattern"]
    equal((told["lifts"], told["dwells"]), (0, 1), "lifts and dwells")
    equal([record[1:] for record in fields(box, "a.pat") if record[0] == "F"][3:],
          [["T3", "30"], ["Z", "-220"], ["Z", "220"]], "fast records behind the travel")


@test("a promise that cannot be kept by a hair shows the difference and names the motors")
def bound_by_a_hair(box):
    box.write("part.nc", HEAD + "G00Z5.\nX100.Y50.\nG01Z-.1F60.\nX110.Y53.\nG00Z5.\nM30\n")
    result = box.kerf("run", "part.nc", "--machine", "cartesian-step", "--pattern", "a.pat",
                      "--machine-set", "pattern.tolerance=0.01999")
    status(result, 0)
    contains(result.err, "by at most 0.02000 mm", "the summary")
    contains(result.err, "the tolerance of 0.01999 mm cannot", "the summary")
    contains(result.err, "finer steps of X and Y would be needed", "the summary")


@test("a promise that is kept but for rounding is kept")
def bound_but_for_rounding(box):
    box.write("part.nc", HEAD + "G00Z5.\nX100.3Y50.7\nG01Z-.1F60.\nX110.3\nG00Z5.\nM30\n")
    result = box.kerf("run", "part.nc", "--machine", "cartesian-step", "--pattern", "a.pat")
    status(result, 0)
    contains(result.err, "measured after every pulse: 0.0000 mm; heading", "the summary")
    box.write("part.nc", HEAD + "G00Z5.\nX33.33Y50.7\nG01Z-.1F60.\nX190.\nY70.\nX10.Y3.\nG00Z5.\nM30\n")
    result = box.kerf("run", "part.nc", "--machine", "cartesian-step", "--pattern", "a.pat")
    contains(result.err, "by at most 0.0200 mm", "the summary")
    check("cannot be promised" not in result.err, result.err)


@test("a cut near a singular position of the arm is a warning, once")
def near_singular(box):
    box.write("part.nc", HEAD + "G00X263.9Y0Z2.\nG01Z-.1F60.\nG01X263.98Y1.\nY3.\nG00Z2.\nM30\n")
    for command in (["run", "part.nc", "--machine", "arm4"], ["check", "part.nc", "--machine", "arm4"]):
        result = box.kerf(*command)
        text = result.err if command[0] == "run" else result.text
        equal(text.count("SINGULAR"), 1, "warnings")
        contains(text, "part.nc:5:1: warning: SINGULAR ", command[0])
        contains(text, "the arm is stretched out (elbow at 2.", command[0])
    box.write("part.nc", HEAD + "G00X263.99Y0Z2.\nX200.\nG01Z-.1F60.\nY3.\nG00Z2.\nM30\n")
    check("SINGULAR" not in box.kerf("run", "part.nc", "--machine", "arm4").err, "a warning of a rapid")


@test("the byte order of a machine holds for what it writes and what it runs")
def machine_byte_order(box):
    box.write("part.nc", CIRCLE)
    order = ("--machine-set", "pattern.byte_order=little")
    status(box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "a.pat", *order), 0)
    equal(box.read("a.pat")[:3], bytes.fromhex("7FF401"), "the first record")
    status(box.kerf("pattern", "replay", "a.pat", *order, "--summary", "s.json", "--output", "b.pat"), 0)
    equal(box.json("s.json")["counters"]["T1"], 18205, "T1")
    equal(box.read("b.pat"), box.read("a.pat"), "what was run")


@test("a pattern is drawn on its path as SVG and PNG, the same bytes each time")
def pattern_plot(box):
    box.write("part.nc", CIRCLE)
    made = []
    for name in ("a.svg", "b.svg", "a.png"):
        result = box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "a.pat", "--pattern-plot", name)
        status(result, 0)
        made.append(box.read(name))
    check(made[0] == made[1], "the same run gave another picture")
    contains(made[0].decode(), "deviations of the wheel", "the picture")
    equal(made[2][:4], b"\x89PNG", "head of the PNG")


@test("a pattern does not change with other outputs beside it")
def beside_others(box):
    box.write("part.nc", CIRCLE)
    status(box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "a.pat"), 0)
    status(box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "b.pat", "--points", "p.csv",
                    "--motion", "m.jsonl", "--plot", "p.svg", "--pulses", "q.csv"), 0)
    equal(box.read("a.pat"), box.read("b.pat"), "the pattern")


@test("the summary says what --pattern became, the same as the pattern itself")
def pattern_in_summary(box):
    box.write("part.nc", CIRCLE)
    status(box.kerf("run", "part.nc", "--machine", "arm4", "--pattern", "a.pat", "--summary", "s.json"), 0)
    told = box.json("s.json")["pattern"]
    listing = box.kerf("pattern", "decode", "a.pat").lines()
    equal((told["records"], told["fast"], told["triplets"], told["bytes"]),
          (len(listing), sum(line[0] == "F" for line in listing),
           sum(line[0] == "S" for line in listing), len(box.read("a.pat"))), "records")
    check(0 < told["measured_mm"] <= told["bound_mm"] < 0.03, f"deviations: {told}")
    check(0 < told["bound_pulses_mm"] <= told["bound_mm"], f"pulses: {told}")
    equal((told["bound_at"]["line"], told["tolerance_mm"], told["splits"]), (6, 0.02, 0), "the worst place")
    near(math.hypot(told["bound_at"]["X"] - 150, told["bound_at"]["Y"] - 60), 25, 1e-6, "its radius")
    status(box.kerf("pattern", "replay", "a.pat", "--summary", "r.json"), 0)
    replayed = box.json("r.json")
    equal({key: replayed["pattern"][key] for key in ("records", "fast", "triplets", "bytes")},
          {key: told[key] for key in ("records", "fast", "triplets", "bytes")}, "of the replay")
    equal(replayed["counters"], told["counters"], "counters")
    near(replayed["time_s"], told["time_s"], 1e-9, "time")


@test("the summary counts the turns and steps that one triplet cannot hold")
def splits_in_summary(box):
    box.write("part.nc", HEAD + "G00Z5.\nX175.Y60.\nG01Z-.1F60.\nC150.F600.\nX170.F78.\nG00Z5.\nM30\n")
    status(box.kerf("run", "part.nc", "--machine", "arm4", "--machine-set", "pattern.heading=program",
                    "--pattern", "a.pat", "--summary", "s.json"), 0)
    listing = box.kerf("pattern", "decode", "a.pat").lines()
    equal(sum(line.startswith("S 30 ") for line in listing), 3, "whole triplets of one long turn")
    equal(box.json("s.json")["pattern"]["splits"], 1, "splits")


@test("the summary has no pattern where none was asked for, and null where it was not written")
def no_pattern_in_summary(box):
    box.write("part.nc", CIRCLE.replace("M30", "X[1/0]"))
    box.kerf("run", "part.nc", "--machine", "arm4", "--summary", "s.json")
    check("pattern" not in box.json("s.json"), "a pattern")
    box.kerf("run", "part.nc", "--machine", "arm4", "--summary", "s.json", "--pattern", "a.pat")
    equal(box.json("s.json")["pattern"], None, "the pattern that was not written")
    box.kerf("run", "part.nc", "--machine", "arm4", "--summary", "s.json", "--pattern", "a.pat", "--keep-partial")
    equal(box.json("s.json")["pattern"]["bytes"], len(box.read("a.pat")), "of the one that was kept")
