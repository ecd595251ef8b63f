"""kerf pattern and kerf run --pattern: bytes, listings, replays, and programs as patterns."""

import json
import math
import os
import random

import harness
from harness import alarm, check, contains, equal, near, refused, status, test
from pulse_tests import csv_pulses, counts
from set_point_tests import rows_of

WORKED = bytes.fromhex("7F00C8 3F0FA0 400CA7 FF00C8")
LISTING = "F Z 200\nF T2 4000\nS 0 12 -7\nF Z -200\n"
HEAD = "O1\nG21G90G17\n"
CIRCLE = HEAD + "G00Z5.\nX175.Y60.\nG01Z-.1F60.\nG03I-25.F78.\nG00Z5.\nM30\n"
AXES = ("T1", "T2", "T3", "Z")
STEP = (1 / 200, 1 / 200, 0.75, 1 / 100)


def records_of(text):
    return [line.split() for line in text.splitlines()]


def decoded(box, name, *words):
    result = box.kerf("pattern", "decode", name, *words)
    status(result, 0)
    equal(result.err, "", "standard error")
    return result.text


@test("a pattern is listed a record a line")
def listing(box):
    box.write("a.pat", WORKED)
    equal(decoded(box, "a.pat"), LISTING, "the listing")
    status(box.kerf("pattern", "decode", "a.pat", "--output", "a.txt"), 0)
    equal(box.read("a.txt").decode(), LISTING, "the file")


@test("a listing becomes the bytes that it came from")
def bytes_again(box):
    box.write("a.txt", LISTING)
    status(box.kerf("pattern", "encode", "a.txt", "--output", "a.pat"), 0)
    equal(box.read("a.pat"), WORKED, "the pattern")


@test("listing and pattern pass through standard input and output")
def pipes(box):
    equal(decoded_from(box, WORKED), LISTING, "the listing")
    result = box.kerf("pattern", "encode", "-", "--output", "-", stdin=LISTING)
    status(result, 0)
    equal(result.out, WORKED, "the pattern")


def decoded_from(box, data, *words):
    result = box.kerf("pattern", "decode", "-", *words, stdin=data)
    status(result, 0)
    return result.text


@test("the order of the bytes of a count can be chosen")
def byte_order(box):
    data = bytes.fromhex("1FE803 9FFFFF 9F7111")
    equal(decoded_from(box, data, "--byte-order", "little"), "F T1 1000\nF T1 -65535\nF T1 -4465\n",
          "little-endian")
    result = box.kerf("pattern", "encode", "-", "--output", "-", "--byte-order", "little",
                      stdin="F T1 1000\nF T1 -70000\n")
    equal(result.out, data, "encoded")


@test("a direction bit of a zero count is listed as -0 and comes back")
def minus_zero(box):
    data = bytes.fromhex("9F0000 1F0000 C080A0 400020")
    text = decoded_from(box, data)
    equal(text, "F T1 -0\nF T1 0\nS -0 -0 -0\nS 0 0 0\n", "the listing")
    equal(box.kerf("pattern", "encode", "-", "--output", "-", stdin=text).out, data, "encoded")


@test("moves beyond a field of a listing are split")
def split(box):
    text = "F Z 65536\nF T1 -70000\nS 4 61 -100\nS 70 5 5\n"
    result = box.kerf("pattern", "encode", "-", "--output", "-", stdin=text)
    equal(result.out, bytes.fromhex("7FFFFF 7F0001 9FFFFF 9F1171 440FB9 400FB9 400FB9 4010B9"
                                    "5E0020 5E0020 4A0525"), "the pattern")


@test("random bytes come back to the last bit through their listing")
def random_round_trip(box):
    dice = random.Random(4)
    data = bytearray()
    for _ in range(40000):
        if dice.random() < 0.3:
            data += bytes([dice.getrandbits(3) << 5 | 31, dice.getrandbits(8), dice.getrandbits(8)])
        else:
            data += bytes(dice.getrandbits(1) << 7 | axis << 5 | dice.randrange(31) for axis in (2, 0, 1))
    for order in ("big", "little"):
        box.write("a.pat", bytes(data))
        status(box.kerf("pattern", "decode", "a.pat", "--output", "a.txt", "--byte-order", order), 0)
        status(box.kerf("pattern", "encode", "a.txt", "--output", "b.pat", "--byte-order", order), 0)
        check(box.read("b.pat") == bytes(data), f"the bytes differ, {order}")


WRONG_BYTES = {
    "a record that breaks off": ("7F00C8 40", "PATTERN_TRUNCATED", 3),
    "a flag in the place of T1": ("7F00C8 401F20", "PATTERN_FIELD", 4),
    "a flag in the place of T2": ("40003F", "PATTERN_FIELD", 2),
    "another axis in the place of T3": ("000020", "PATTERN_AXIS", 0),
    "another axis in the place of T1": ("402020", "PATTERN_AXIS", 1),
    "another axis in the place of T2": ("7F00C8 400000", "PATTERN_AXIS", 5),
}


def wrong_bytes(data, code, offset):
    def run(box):
        box.write("a.pat", bytes.fromhex(data))
        for command in (["decode", "a.pat", "--output", "a.txt"],
                        ["replay", "a.pat", "--output", "b.pat", "--pulses", "p.csv"]):
            result = box.kerf("pattern", *command)
            status(result, 1)
            contains(result.err, f"a.pat:byte {offset}: error: {code} ", "standard error")
            equal(box.files(), ["a.pat"], "files behind it")
            result = box.kerf("pattern", *command, "--diagnostics", "json")
            status(result, 1)
            found = json.loads(result.err.splitlines()[0])
            equal((found["code"], found["offset"], found["file"]), (code, offset, "a.pat"), "as JSON")
    return run


for name, (data, code, offset) in WRONG_BYTES.items():
    test(f"a wrong pattern tells the byte: {name}")(wrong_bytes(data, code, offset))


@test("--lenient does not look at the axes of triplets")
def lenient(box):
    equal(decoded_from(box, bytes.fromhex("0364E5"), "--lenient"), "S 3 4 -5\n", "the listing")
    box.write("a.pat", bytes.fromhex("0364E5"))
    result = box.kerf("pattern", "replay", "a.pat", "--lenient", "--byte-order", "little", "--summary", "-")
    status(result, 0)
    equal(json.loads(result.text)["counters"], {"T1": 4, "T2": -5, "T3": 3, "Z": 0}, "counters")


@test("a wrong listing tells line and column, and no pattern is written")
def wrong_listing(box):
    box.write("a.txt", "F Z 5\n\nS 1 x 3 # here\n")
    result = box.kerf("pattern", "encode", "a.txt", "--output", "a.pat")
    status(result, 1)
    contains(result.err, "a.txt:3:5: error: PATTERN_TEXT ", "standard error")
    contains(result.err, "    S 1 x 3 # here\n        ^\n", "the source line")
    equal(box.files(), ["a.txt"], "files behind it")
    result = box.kerf("pattern", "encode", "-", "--output", "-", "--diagnostics", "json",
                      stdin="F Z 5\nF Y 1\n")
    found = json.loads(result.err)
    equal((found["code"], found["line"], found["column"]), ("PATTERN_TEXT", 2, 3), "as JSON")
    equal(result.out, b"", "standard output")


@test("an empty pattern is one")
def empty(box):
    equal(decoded_from(box, b""), "", "the listing")
    result = box.kerf("pattern", "encode", "-", "--output", "a.pat", stdin="# nothing\n\n")
    status(result, 0)
    equal(box.read("a.pat"), b"", "the pattern")
    result = box.kerf("pattern", "replay", "a.pat", "--summary", "-", "--points", "p.csv")
    status(result, 0)
    summary = json.loads(result.text)
    equal((summary["status"], summary["pattern"]["records"], summary["time_s"]), ("end", 0, 0), "the summary")
    equal(len(box.read("p.csv").splitlines()), 1, "lines of set-points")


@test("a file that is missing or cannot be written is said in one sentence")
def missing(box):
    for command in (["decode", "no.pat"], ["encode", "no.txt", "--output", "a"], ["replay", "no.pat"]):
        refused(box.kerf("pattern", *command), 3, command[1])
    box.write("a.pat", WORKED)
    box.write("a.txt", LISTING)
    refused(box.kerf("pattern", "decode", "a.pat", "--output", "no/a.txt"), 3, "no/a.txt")
    refused(box.kerf("pattern", "encode", "a.txt", "--output", "no/a.pat"), 3, "no/a.pat")
    refused(box.kerf("pattern", "replay", "a.pat", "--motion", "no/m.jsonl"), 3, "no/m.jsonl")
    refused(box.kerf("pattern", "decode", "."), 3)


@test("a pattern of 30 MB needs no more memory than a short one")
def huge(box):
    with open(box.path("a.pat"), "wb") as file:
        for _ in range(100):
            file.write(bytes.fromhex("400C27 40 8C A7") * 50000)
    result = box.kerf("pattern", "decode", "a.pat", "--output", "a.txt", peak=True)
    status(result, 0)
    equal(os.path.getsize(box.path("a.txt")), 5000000 * (len("S 0 12 7\n") + len("S 0 -12 -7\n")), "bytes")
    again = box.kerf("pattern", "encode", "a.txt", "--output", "b.pat", peak=True)
    status(again, 0)
    equal(os.path.getsize(box.path("b.pat")), 30000000, "bytes of the pattern")
    if harness.MEASURES_MEMORY:
        check(0 < result.peak_kib < 16 * 1024, f"{result.peak_kib} KiB of memory")
        check(0 < again.peak_kib < 16 * 1024, f"{again.peak_kib} KiB of memory")


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


def forward(t1, t2):
    a, b = math.radians(t2), math.radians(t1 + t2)
    return 132 * (math.cos(a) + math.cos(b)), 132 * (math.sin(a) + math.sin(b))


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


def listed_as(box, text, more=b""):
    """Writes a.pat: the records of a listing, and bytes behind them."""
    result = box.kerf("pattern", "encode", "-", "--output", "-", stdin=text)
    status(result, 0)
    box.write("a.pat", result.out + more)


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
