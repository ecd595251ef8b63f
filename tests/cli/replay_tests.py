"""kerf pattern replay, and kerf run of a pattern: counters, motions, set-points, travels, outputs."""

import json
import os

from harness import check, contains, equal, near, refused, status, test
from pattern_files import AXES, CIRCLE, LISTING, STEP, WORKED, decoded, forward, listed_as
from pulse_tests import csv_pulses, counts
from set_point_tests import rows_of


@test("a replay stands where the sum of its records says")
def replayed_counters(box):
    box.write("a.pat", WORKED)
    result = box.kerf("pattern", "replay", "a.pat", "--summary", "s.json", "--pulses", "p.csv")
    status(result, 0)
    contains(result.err, "4 records: 3 fast, 1 triplets", "the summary for people")
    contains(result.err, "wrote s.json\n", "the summary for people")
    summary = box.json("s.json")
    equal(summary["counters"], {"T1": 12, "T2": 3993, "T3": 0, "Z": 0}, "counters")
    equal((summary["machine"], summary["dialect"], summary["status"], summary["alarm"]),
          ("arm4", "pattern", "end", None), "the head of the summary")
    made = csv_pulses(box.read("p.csv").decode())
    equal(len(made), summary["pattern"]["pulses"], "pulses")
    equal({k: v for k, v in counts(made).items() if v}, {"T1": 12, "T2": 3993}, "sum of the pulses")
    check(all(a[0] <= b[0] for a, b in zip(made, made[1:])), "times go backwards")


@test("kerf run --dialect pattern is a replay")
def run_as_a_dialect(box):
    box.write("a.pat", WORKED)
    outputs = ["--summary", "s.json", "--motion", "m.jsonl", "--points", "p.csv", "--pulses", "q.csv",
               "--plot", "p.svg"]
    status(box.kerf("pattern", "replay", "a.pat", *outputs, "--output", "b.pat"), 0)
    files = ("s.json", "m.jsonl", "p.csv", "q.csv", "p.svg", "b.pat")
    replayed = {name: box.read(name) for name in files}
    for name in files:
        os.remove(box.path(name))
    status(box.kerf("run", "a.pat", "--dialect", "pattern", *outputs, "--pattern", "b.pat"), 0)
    for name in files:
        equal(box.read(name), replayed[name], name)
    status(box.kerf("run", "a.pat", *outputs, "--pattern", "b.pat"), 0)
    for name in files:
        equal(box.read(name), replayed[name], name + " by the file's ending")
    status(box.kerf("run", "a.pat", "--dialect", "pattern", "--machine", "cartesian-step",
                    "--machine-set", "drive.split=integer", "--summary", "s.json"), 0)
    equal(box.json("s.json")["machine"], "cartesian-step", "machine")
    box.write("a.pat", WORKED + b"\x40")
    result = box.kerf("run", "a.pat", "--dialect", "pattern", "--diagnostics", "json")
    status(result, 1)
    contains(result.err, '"code":"PATTERN_TRUNCATED"', "the alarm")


@test("kerf run --dialect pattern refuses what is for programs only")
def run_as_a_dialect_refuses(box):
    box.write("a.pat", WORKED)
    for words in (["--set", "#1=2"], ["--teach", "a.tch"], ["--optional-stop"],
                  ["--plot", "a.svg", "--plot-speed"], ["--coverage", "-"]):
        option = "--plot-speed" if "--plot-speed" in words else words[0]
        refused(box.kerf("run", "a.pat", "--dialect", "pattern", *words), 2,
                option + " does not go with --dialect pattern")
    refused(box.kerf("run", "a.pat", "--dialect", "pattern", "--machine", "mill3"), 2, "mill3")
    equal(box.files(), ["a.pat"], "files")
    refused(box.kerf("time", "a.pat"), 3, "a.pat: pattern bytes are run by `kerf pattern replay`")
    box.write("part.pat", "O1\nM30\n")
    status(box.kerf("run", "part.pat", "--dialect", "fanuc-mill"), 0)


@test("motions of a replay are the tip of the counters, rapids of fast records and lines of triplets")
def replayed_motions(box):
    box.write("a.pat", WORKED)
    status(box.kerf("pattern", "replay", "a.pat", "--motion", "m.jsonl"), 0)
    motions = box.motions("m.jsonl")
    equal([(m["kind"], m["line"]) for m in motions],
          [("rapid", 1), ("rapid", 2), ("line", 3), ("rapid", 4)], "motions")
    x, y = forward(12 * 0.005, 3993 * 0.005)
    near(motions[2]["to"]["X"], x, 1e-9, "X")
    near(motions[2]["to"]["Y"], y, 1e-9, "Y")
    near(motions[2]["to"]["C"], 4005 * 0.005, 1e-9, "C")
    check(motions[2]["feed"] > 0 and motions[2]["feed_mode"] == "per-minute", "the feed of a line")


@test("set-points of a replay follow its counters, and the tip follows the joints")
def replayed_points(box):
    box.write("a.txt", "F T1 18000\nS 3 30 -20\nS 0 -7 30\nF Z -50\n")
    status(box.kerf("pattern", "encode", "a.txt", "--output", "a.pat"), 0)
    status(box.kerf("pattern", "replay", "a.pat", "--points", "points.csv", "--pulses", "p.csv",
                    "--summary", "s.json"), 0)
    waiting = list(reversed(csv_pulses(box.read("p.csv").decode())))
    stand = dict.fromkeys(AXES, 0)
    rows = rows_of(box.read("points.csv").decode())
    for row in rows:
        while waiting and waiting[-1][0] <= row["t"] * 1e9:
            _, axis, direction = waiting.pop()
            stand[axis] += direction
        for joint, axis in enumerate(AXES):
            off = abs(row[f"j{joint + 1}"] / STEP[joint] - stand[axis])
            check(off <= 0.5 + 1e-3, f"{axis} is {off} pulses from its counter at {row['t']}")
        x, y = forward(row["j1"], row["j2"])
        near(row["X"], x, 1e-8, "X")
        near(row["Y"], y, 1e-8, "Y")
    equal(waiting, [], "pulses behind the last set-point")
    near(rows[-1]["t"], box.json("s.json")["time_s"], 0.001, "time of the last row")
    equal([rows[-1][f"j{n}"] for n in (1, 2, 3, 4)], [90.115, 0.05, 2.25, -0.5], "the last row")


@test("--return-to-start adds the records that bring every counter to 0")
def return_to_start(box):
    box.write("a.txt", "F T1 -300\nF T2 4000\nS 5 12 -7\nF Z -20\n")
    status(box.kerf("pattern", "encode", "a.txt", "--output", "a.pat"), 0)
    status(box.kerf("pattern", "replay", "a.pat", "--return-to-start", "--output", "b.pat", "--summary",
                    "s.json"), 0)
    equal(box.json("s.json")["counters"], dict.fromkeys(AXES, 0), "counters")
    equal(decoded(box, "b.pat").splitlines()[4:],
          ["F Z 220", "F T3 -5", "F T1 288", "F T2 -3993", "F Z -200"], "what was added")


@test("whole ticks of a timer overflow where one arm has far fewer pulses")
def timer_overflow(box):
    box.write("a.txt", "F Z 5\nS 0 30 1\n")
    status(box.kerf("pattern", "encode", "a.txt", "--output", "a.pat"), 0)
    status(box.kerf("pattern", "replay", "a.pat"), 0)
    result = box.kerf("pattern", "replay", "a.pat", "--machine-set", "drive.split=integer", "--summary",
                      "s.json", "--pulses", "p.csv", "--output", "b.pat")
    status(result, 1)
    contains(result.err, "a.pat:byte 3: error: TIMER_OVERFLOW ", "standard error")
    equal(box.json("s.json")["alarm"]["offset"], 3, "offset of the alarm")
    equal(box.files(), ["a.pat", "a.txt", "s.json"], "files behind it")
    result = box.kerf("pattern", "replay", "a.pat", "--machine-set", "drive.split=integer", "--pulses",
                      "p.csv", "--output", "b.pat", "--keep-partial")
    status(result, 1)
    equal(box.read("b.pat"), bytes.fromhex("7F0005"), "what was run")
    equal(counts(csv_pulses(box.read("p.csv").decode())), {"Z": 5}, "pulses")


@test("a replay beyond the travel of a joint goes on with a warning")
def beyond_travel(box):
    box.write("a.txt", "F Z 5\nF T1 40000\n")
    status(box.kerf("pattern", "encode", "a.txt", "--output", "a.pat"), 0)
    result = box.kerf("pattern", "replay", "a.pat")
    status(result, 0)
    contains(result.err, "a.pat:byte 3: warning: LIMIT ", "standard error")
    contains(result.err, "T1 goes to 200", "standard error")


@test("each joint that goes beyond its travel is told of, where it does so first")
def beyond_travels(box):
    listed_as(box, "F T1 40000\nF T1 1\nF Z 30000\nF Z 1\n")
    result = box.kerf("pattern", "replay", "a.pat")
    status(result, 0)
    equal([line.split(": ")[0] for line in result.err.splitlines() if "LIMIT" in line],
          ["a.pat:byte 0", "a.pat:byte 6"], "warnings")
    contains(result.err, "record 3: Z goes to 300, beyond its travel of -50 to 100", "standard error")


@test("a replay ends when its computing time is used up")
def replay_seconds(box):
    listed_as(box, "F T1 2147483647\nF T1 -2147483647\n")
    commands = (["pattern", "replay", "a.pat"], ["run", "a.pat"], ["pattern", "replay", "a.pat", "--points", "p.csv"])
    for command in commands:
        result = box.kerf(*command, "--max-seconds", "0.2", "--summary", "s.json")
        status(result, 5)
        contains(result.err, ": warning: BUDGET execution budget used up: 0.2 s of computing are over",
                 "standard error")
        summary = box.json("s.json")
        equal((summary["status"], summary["alarm"]), ("budget", None), "the summary")
        count = summary["pattern"]["records"]
        check(0 < count < 65000, f"{count} records were run")
        equal(summary["counters"]["T1"], 65535 * count, "T1")


@test("a replay ends in front of the record for which its motions do not suffice")
def replay_motions(box):
    box.write("a.pat", WORKED)
    outputs = ["--summary", "s.json", "--motion", "m.jsonl", "--points", "p.csv"]
    for command, bytes_to in ((["pattern", "replay"], "--output"), (["run"], "--pattern")):
        words = [*command, "a.pat", *outputs, bytes_to, "b.pat", "--max-motions"]
        result = box.kerf(*words, "2")
        status(result, 5)
        contains(result.err, "a.pat:byte 6: warning: BUDGET ", "standard error")
        equal([m["line"] for m in box.motions("m.jsonl")], [1, 2], "motions")
        summary = box.json("s.json")
        equal((summary["status"], summary["motions"], summary["pattern"]["records"]), ("budget", 2, 2), "summary")
        near(rows_of(box.read("p.csv").decode())[-1]["t"], summary["time_s"], 0.001, "time of the last row")
        check("b.pat" not in box.files(), "what drives a machine was written")
        status(box.kerf(*words, "2", "--keep-partial"), 5)
        equal(box.read("b.pat"), WORKED[:6], "what was run")
        status(box.kerf(*words, "4"), 0)
        os.remove(box.path("b.pat"))
    result = box.kerf("pattern", "replay", "a.pat", "--max-motions", "2", "--return-to-start", "--diagnostics", "json")
    status(result, 5)
    told = json.loads(result.err)
    equal((told["code"], told["offset"]), ("BUDGET", 6), "as JSON")
    contains(told["message"], "it does not return to the start", "as JSON")


@test("--return-to-start returns behind an alarm as well")
def return_behind_alarm(box):
    back = ["F Z 220", "F T3 -5", "F T1 -12", "F T2 -3993", "F Z -200"]
    wrong = {"a record that breaks off": (b"\x40", [], "PATTERN_TRUNCATED"),
             "a timer": (bytes.fromhex("401E21"), ["--machine-set", "drive.split=integer"], "TIMER_OVERFLOW")}
    for name, (more, words, code) in wrong.items():
        listed_as(box, "F T2 4000\nS 5 12 -7\nF Z -20\n", more)
        words += ["--return-to-start", "--summary", "s.json", "--output", "b.pat"]
        result = box.kerf("pattern", "replay", "a.pat", *words)
        status(result, 1)
        contains(result.err, f"a.pat:byte 9: error: {code} ", name)
        equal(box.json("s.json")["counters"], dict.fromkeys(AXES, 0), f"counters, {name}")
        check("b.pat" not in box.files(), "what drives a machine was written")
        status(box.kerf("pattern", "replay", "a.pat", *words, "--keep-partial"), 1)
        equal(decoded(box, "b.pat").splitlines()[3:], back, f"what was added, {name}")
        os.remove(box.path("b.pat"))


@test("the picture of a replay counts its motions")
def counted_in_picture(box):
    box.write("a.pat", WORKED)
    status(box.kerf("pattern", "replay", "a.pat", "--plot", "a.svg", "--summary", "s.json"), 0)
    equal(box.json("s.json")["motions"], 4, "motions")
    contains(box.read("a.svg").decode(), " 4 moves<", "the picture")


@test("a replay is drawn, and its pulses are a value change dump")
def replayed_pictures(box):
    box.write("a.pat", WORKED)
    status(box.kerf("pattern", "replay", "a.pat", "--plot", "a.svg", "--pulses", "a.vcd"), 0)
    check(box.read("a.svg").startswith(b"<svg") or b"<svg" in box.read("a.svg")[:200], "no picture")
    contains(box.read("a.vcd").decode(), "T2_step", "the dump")


@test("on cartesian-step a pattern moves X and Y")
def cartesian(box):
    box.write("a.txt", "F T1 1000\nF T2 500\nS 0 30 30\n")
    status(box.kerf("pattern", "encode", "a.txt", "--output", "a.pat"), 0)
    status(box.kerf("pattern", "replay", "a.pat", "--machine", "cartesian-step", "--summary", "s.json"), 0)
    place = box.json("s.json")["position"]["machine"]
    equal((place["X"], place["Y"]), (10.3, 5.3), "the place")


@test("kerf pattern replay writes rows and plain G-code as kerf run does, and kerf run of a pattern too")
def replay_outputs(box):
    box.write("circle.nc", CIRCLE)
    status(box.kerf("run", "circle.nc", "--machine", "cartesian-step", "--pattern", "a.pat"), 0)
    for words in (["pattern", "replay", "a.pat", "--machine", "cartesian-step"],
                  ["run", "a.pat", "--machine", "cartesian-step"]):
        status(box.kerf(*words, "--motion", "m.jsonl", "--rows", "rows.csv", "--post", "post.nc"), 0)
        moves = box.motions("m.jsonl")
        rows = box.read("rows.csv").decode().splitlines()[1:]
        equal([row.split(",")[1] for row in rows], [{"rapid": "0", "line": "1"}[move["kind"]] for move in moves], "rows")
        equal([float(row.split(",")[2]) for row in rows], [move["to"]["X"] for move in moves], "X of the rows")
        post = box.read("post.nc").decode()
        check(post.startswith("(KERF POST OF A.PAT)\n(MACHINE: CARTESIAN-STEP, AXES X Y C Z)\n"), post[:200])
        lines = sum(move["kind"] == "line" for move in moves)
        blocks = post[post.index("\nM5\n"):].splitlines()
        check(blocks[2].startswith("G0 Z") and blocks[3].startswith("G0 C") and blocks[4].startswith("G0 X"), str(blocks[:6]))
        cut, cuts = False, 0
        for block in blocks:
            cut = block.startswith("G1") or cut and not block.startswith(("G0", "M"))
            cuts += cut
        equal(cuts, lines, "cuts of the posted program")


@test("what could drive a machine of a replay is written only when it reached its end")
def replay_partial(box):
    box.write("a.pat", WORKED + b"\x40")
    status(box.kerf("pattern", "replay", "a.pat", "--post", "p.nc", "--rows", "r.csv"), 1)
    equal(box.files(), ["a.pat", "r.csv"], "files")
    status(box.kerf("pattern", "replay", "a.pat", "--post", "p.nc", "--keep-partial"), 1)
    check("M30" in box.read("p.nc").decode(), "the part has no end")


@test("--pwm of a replay is for machines with a laser, which a pattern leaves off")
def replay_pwm(box):
    box.write("a.pat", WORKED)
    refused(box.kerf("pattern", "replay", "a.pat", "--pwm", "w.csv"), 2, "--pwm", "arm4", "laser")
    laser = ["--machine-set", "drive.max_power_w=20"]
    status(box.kerf("pattern", "replay", "a.pat", "--pwm", "w.csv", *laser), 0)
    equal(box.read("w.csv").decode().splitlines()[1:], ["0,1,2000,0,12500,0"], "rows")
    bad = [*laser, "--machine-set", "drive.pwm_frequency_hz=1"]
    result = box.kerf("pattern", "replay", "a.pat", "--pwm", "w.csv", *bad)
    status(result, 1)
    contains(result.err, "PWM_RANGE", "the alarm")


LINKED = "# four at once\nL 12 -7 4 100\nF Z -100\nS 0 -12 7\n"
FOUR = ["--machine-set", "pattern.link=four"]


@test("a listing is replayed, with four linked motors where the machine links them")
def linked_motors(box):
    box.write("a.txt", LINKED)
    result = box.kerf("pattern", "replay", "a.txt", *FOUR, "--summary", "s.json", "--pulses", "p.csv",
                      "--motion", "m.jsonl", "--points", "q.csv")
    status(result, 0)
    contains(result.err, "3 records: 1 fast, 1 triplets, 1 linked", "the summary for people")
    summary = box.json("s.json")
    equal(summary["counters"], {"T1": 0, "T2": 0, "T3": 4, "Z": 0}, "counters")
    equal((summary["pattern"]["linked"], summary["pattern"]["pulses"]), (1, 123 + 100 + 19), "records")
    made = csv_pulses(box.read("p.csv").decode())
    half_ns = 4096 * 12 / 11.0592e6 * 1e9
    for axis, size in (("T1", 12), ("T2", 7), ("T3", 4), ("Z", 100)):
        times = [pulse[0] for pulse in made if pulse[1] == axis][:size]
        for k, time_ns in enumerate(times, start=1):  # pulse k rises at (2k - 1) of its half periods
            near(time_ns, (2 * k - 1) * half_ns * 100 / size, 1100, f"pulse {k} of {axis}")
    motions = box.motions("m.jsonl")
    equal([(m["kind"], m["line"]) for m in motions], [("line", 1), ("rapid", 2), ("line", 3)], "motions")
    equal(motions[0]["to"]["Z"], 1, "Z behind the linked move")
    rows = rows_of(box.read("q.csv").decode())
    half_way = min(rows, key=lambda row: abs(row["t"] - 100 * half_ns / 1e9))
    near(half_way["j4"], 0.5, 0.011, "the lift half way")
    near(half_way["j3"], 1.5, 0.76, "the wheel half way")


@test("a linked move has no bytes, and is no line for a machine that links two motors")
def linked_without_bytes(box):
    box.write("a.txt", LINKED)
    for words in (["encode", "a.txt", "--output", "a.pat"], ["replay", "a.txt"],
                  ["replay", "a.txt", *FOUR, "--output", "a.pat"]):
        result = box.kerf("pattern", *words)
        status(result, 1)
        contains(result.err, "a.txt:2:", "the place")
        contains(result.err, "PATTERN_TEXT", "the code")
        contains(result.err, "bytes", "the reason")
    equal(box.files(), ["a.txt"], "files behind it")


@test("a listing is replayed as the pattern that it becomes")
def replayed_listing(box):
    box.write("a.pat", WORKED)
    box.write("a.txt", "# as a listing\n" + decoded(box, "a.pat"))
    for name in ("a.pat", "a.txt"):
        status(box.kerf("pattern", "replay", name, "--motion", name + ".jsonl", "--output", name + ".out"), 0)
    equal(box.read("a.txt.jsonl"), box.read("a.pat.jsonl"), "motions")
    equal(box.read("a.txt.out"), WORKED, "the pattern behind it")
    box.write("a.txt", "F Z 200\nF Q 1\n")
    result = box.kerf("pattern", "replay", "a.txt", "--summary", "s.json")
    status(result, 1)
    contains(result.err, "a.txt:2:3:", "the place")
    equal((box.json("s.json")["alarm"]["code"], box.json("s.json")["alarm"]["line"]), ("PATTERN_TEXT", 2), "alarm")
    box.write("listed.pat", LISTING)
    status(box.kerf("check", "listed.pat"), 0)
    box.write("listed.pat", LISTING + "L 1 2 3 4\n")
    result = box.kerf("check", "listed.pat")
    status(result, 1)
    contains(result.text, "listed.pat:5:1: error: PATTERN_TEXT", "the finding of kerf check")
