"""Every option of `kerf run` has the effect that its contract says."""

import math
import os
import xml.etree.ElementTree as xml

from harness import alarm, check, contains, equal, in_time, near, status, test

HEAD = "G21G90G17G94\n"


def summary(box, program, *words, stdin=b"", wanted=0):
    """Runs a program and returns its summary."""
    box.write("part.nc", program)
    result = box.kerf("run", "part.nc", "--summary", "summary.json", *words, stdin=stdin)
    status(result, wanted)
    return box.json("summary.json")


def moves(box, program, *words, wanted=0):
    """Runs a program and returns the targets of its moving records."""
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--motion", "motion.json", *words), wanted)
    return [record for record in box.motions("motion.json") if "to" in record]


@test("--machine chooses a built-in machine, and every motion carries its axes")
def machine_option(box):
    program = "O1\n" + HEAD + "G00X1.A90.\nM30\n"
    alarm(box.kerf("run", box.write("part.nc", program)), "PS0009", 3)
    records = moves(box, program, "--machine", "mill4")
    equal(records[0]["to"], {"X": 1, "Y": 0, "Z": 0, "A": 90}, "target")


@test("without --machine the summary says which machine was chosen and why")
def default_machine(box):
    box.write("part.nc", "O1\nM30\n")
    result = box.kerf("run", "part.nc")
    status(result, 0)
    contains(result.err, "mill3", "the summary")
    contains(result.err, "because", "the summary")


@test("--dialect fanuc-mill reads G-code whatever the file is called")
def dialect_option(box):
    box.write("part.bas", "O1\nG21G90\nG00X1.\nM30\n")
    status(box.kerf("run", "part.bas"), 1)
    status(box.kerf("run", "part.bas", "--dialect", "fanuc-mill", "--summary", "s.json"), 0)
    equal(box.json("s.json")["dialect"], "fanuc-mill", "dialect")


@test("--set writes local, common and system variables and the input bits before the start")
def set_option(box):
    program = ("O1\n#101=#1\n#102=#33\n#103=#1003\n#104=#1032\n#105=#5221\n#106=#500\n"
               "#107=#3011\n#108=#3012\nM30\n")
    variables = summary(box, program, "--set", "#1=1.5", "--set", "#33=-2", "--set", "#1003=1",
                        "--set", "#1000=1", "--set", "#5221=12.5", "--set", "#500=+7",
                        "--set", "#3011=20240229", "--set", "#3012=235959",
                        "--set=#199=1e3")["variables"]
    equal({k: variables.get(k) for k in ("#101", "#102", "#103", "#104", "#105", "#106", "#107",
                                         "#108", "#199")},
          {"#101": 1.5, "#102": -2, "#103": 1, "#104": 9, "#105": 12.5, "#106": 7,
           "#107": 20240229, "#108": 235959, "#199": 1000}, "variables")


@test("--param changes a parameter by its name or by its FANUC number, the last one counting")
def param_option(box):
    program = "O1\nG21G90\nG00X10\nM30\n"
    equal(moves(box, program)[0]["to"]["X"], 0.01, "X10 in least increments")
    equal(moves(box, program, "--param", "DPI=1")[0]["to"]["X"], 10, "X10 with DPI=1")
    equal(moves(box, program, "--param", "3401#0=1")[0]["to"]["X"], 10, "X10 with 3401#0=1")
    equal(moves(box, program, "--param", "DPI=1", "--param", "DPI=0")[0]["to"]["X"], 0.01,
          "X10 with DPI=1 and DPI=0")
    macro = "O1\nG12 X10. I5.\nM30\nO9010\n#100=#24\n#101=#4\nM99\n"
    variables = summary(box, macro, "--param", "6050=12")["variables"]
    equal((variables["#100"], variables["#101"]), (10, 5), "arguments of the macro")


@test("--decimal-point calculator reads numbers without a point as whole units")
def decimal_point_option(box):
    program = "O1\nG21G90\nG00X10\nM30\n"
    equal(moves(box, program, "--decimal-point", "calculator")[0]["to"]["X"], 10, "X10")
    equal(moves(box, program, "--decimal-point", "increment")[0]["to"]["X"], 0.01, "X10")


def rest_to_rest_s(length, velocity, acceleration, jerk=math.inf):
    """Whole milliseconds, the period of the servo, that a move takes which reaches its velocity."""
    ramp = velocity / acceleration + acceleration / jerk
    return math.ceil((length / velocity + ramp) * 1000 - 1e-6) / 1000


@test("--machine-set changes velocity, acceleration and jerk, and with them the time of the run")
def machine_set_option(box):
    program = "O1\nG21G90\nG00X100.\nM30\n"
    done = summary(box, program)
    near(done["time_feed_s"], 100 / 24000 * 60, 1e-9, "time at 24000 mm/min without acceleration")
    near(done["time_s"], rest_to_rest_s(100, 400, 3000), 1e-9, "time at 24000 mm/min")
    for keys, limits in ((("velocity=6000",), (100, 3000)), (("acceleration=2000",), (400, 2000)),
                         (("velocity=6000", "acceleration=1000", "jerk=10000"), (100, 1000, 10000))):
        words = [word for key in keys for word in ("--machine-set", "axis.X." + key)]
        near(summary(box, program, *words)["time_s"], rest_to_rest_s(100, *limits), 1e-9, str(keys))


@test("--skip-at ends a probing move there, one contact after the other")
def skip_at_option(box):
    program = ("O1\nG21G90F100\nG31X10.\n#101=#5061\nG31Z-10.\n#103=#5063\nG31Y5.\n#102=#5062\n"
               "M30\n")
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--motion", "m.json", "--summary", "s.json",
                    "--skip-at", "X=7.2", "--skip-at", "Z=-3"), 0)
    probes = [record for record in box.motions("m.json") if record["kind"] == "probe"]
    equal([record["contact"] for record in probes], [True, True, False], "contacts")
    equal([record["to"] for record in probes],
          [{"X": 7.2, "Y": 0, "Z": 0}, {"X": 7.2, "Y": 0, "Z": -3}, {"X": 7.2, "Y": 5, "Z": -3}],
          "where the moves ended")
    variables = box.json("s.json")["variables"]
    equal((variables["#101"], variables["#103"], variables["#102"]), (7.2, -3, 5), "skip position")


@test("--interrupt-at calls the program of M96 behind the block that the axes are in")
def interrupt_at_option(box):
    # Each cut takes 1 s and the time to come to rest; the control has read them all by then.
    cuts = "G91G61G01X10.F600\nX10.\nX10.\n"
    sub = "O2\n#500=#500+1\nG91G01Y2.\nM99\n"
    box.write("part.nc", "O1\nM96P2\n" + cuts + "M97\nX10.\nM30\n" + sub)

    def way(*options):
        status(box.kerf("run", "part.nc", "--motion", "m.json", "--summary", "s.json", *options), 0)
        moves = [record["to"] for record in box.motions("m.json") if record["kind"] == "line"]
        return [(to["X"], to["Y"]) for to in moves]

    equal(way(), [(10, 0), (20, 0), (30, 0), (40, 0)], "without a signal")
    equal(way("--interrupt-at", "1.5"), [(10, 0), (20, 0), (20, 2), (30, 2), (40, 2)], "at 1.5 s")
    equal(box.json("s.json")["variables"]["#500"], 1, "#500")
    equal(way("--interrupt-at", "2.9", "--interrupt-at", "0.5"),
          [(10, 0), (10, 2), (20, 2), (30, 2), (30, 4), (40, 4)], "twice, in the order of time")
    for late in ("3.5", "100"):
        equal(way("--interrupt-at", late), [(10, 0), (20, 0), (30, 0), (40, 0)], "behind M97")
        assumed = [each["what"] for each in box.json("s.json")["assumed"]]
        check(any("no M96 was in force" in what for what in assumed), f"{late} s: told: {assumed}")
    status(box.kerf("run", "-", "--interrupt-at", "1", stdin="O1\nM30\n"), 2)


@test("M01 stands in posted programs, and its record says where the program went on")
def optional_stop_records(box):
    box.write("part.nc", "O1\nG21G90G01X10.F600\nM01\nX20.\nM30\n")
    for options, kinds, end in (((), ["line", "stop", "line", "end"], "end"),
                                (("--optional-stop",), ["line", "stop"], "stopped")):
        status(box.kerf("run", "part.nc", "--motion", "m.json", "--summary", "s.json", *options), 0)
        equal([record["kind"] for record in box.motions("m.json")], kinds, str(options))
        equal(box.motions("m.json")[1].get("passed"), True if end == "end" else None, "passed")
        equal(box.json("s.json")["status"], end, str(options))
    status(box.kerf("run", "part.nc", "--post", "p.nc"), 0)
    lines = box.read("p.nc").split()
    check(b"M1" in lines, f"posted: {lines}")


@test("--block-skip turns on exactly the levels of its list")
def block_skip_option(box):
    program = ("O1\nG21G90\n/G00X1.\n/2X2.\n/3X3.\n/9X9.\nX5./2Y7.\nM30\n")
    everything = [1, 2, 3, 9, 5]
    for levels, wanted in ((None, everything), ("1", [2, 3, 9, 5]), ("2", [1, 3, 9, 5]),
                           ("1,3", [2, 9, 5]), ("9", [1, 2, 3, 5]), ("all", [5])):
        words = [] if levels is None else ["--block-skip", levels]
        records = moves(box, program, *words)
        equal([record["to"]["X"] for record in records], wanted, f"X with --block-skip {levels}")
        y = 0 if levels in ("2", "all") else 7
        equal(records[-1]["to"]["Y"], y, f"Y with --block-skip {levels}")


@test("--optional-stop ends the run at M01 with the status stopped")
def optional_stop_option(box):
    program = "O1\nG21G90\nG00X1.\nM01\nX2.\nM30\n"
    equal(summary(box, program)["position"]["machine"]["X"], 2, "X without the switch")
    stopped = summary(box, program, "--optional-stop")
    equal((stopped["status"], stopped["position"]["machine"]["X"]), ("stopped", 1), "end")


@test("a run goes on by itself behind M00 and #3006")
def stops_of_a_batch_run(box):
    done = summary(box, "O1\nG21G90\nG00X1.\nM00\n#3006=1(TURN THE PART)\nX2.\nM30\n")
    equal((done["status"], done["position"]["machine"]["X"]), ("end", 2), "end")
    equal(done["messages"], ["TURN THE PART"], "messages")


@test("--max-seconds ends an endless program with exit status 5 and says where it stood")
def max_seconds_option(box):
    box.write("part.nc", "O1\nN1GOTO1\n")
    result = box.kerf("run", "part.nc", "--max-seconds", "0.2", "--summary", "s.json")
    status(result, 5)
    contains(result.err, "part.nc:2:", "the notice")
    equal(box.json("s.json")["status"], "budget", "status")
    in_time(result, 5)


@test("--max-seconds 0 and --max-motions 0 set no limit")
def no_limits(box):
    equal(summary(box, "O1\nG21G90\nG00X1.\nM30\n", "--max-seconds", "0",
                  "--max-motions", "0")["status"], "end", "status")


@test("--max-motions ends a run with exit status 5 after exactly so many motions")
def max_motions_option(box):
    program = "O1\nG21G91F100\nN1G01X1.\nGOTO1\n"
    records = moves(box, program, "--max-motions", "7", "--summary", "s.json", wanted=5)
    equal(len(records), 7, "motions")
    equal(box.json("s.json")["status"], "budget", "status")
    equal(box.json("s.json")["motions"], 7, "motions of the summary")


@test("--max-motions that a program just needs lets it reach its end")
def enough_motions(box):
    program = "O1\nG21G91F100\nG01X1.\nX1.\nX1.\nM30\n"
    equal(summary(box, program, "--max-motions", "3")["status"], "end", "status")


@test("the position behind --max-motions is where the last motion ended")
def position_at_the_budget(box):
    for blocks in ("G01X1.\nX1.\nX1.\nG43H1Z1.\n", "G81X1.Z-1.R1.L5\n"):
        done = summary(box, "O1\nG21G91F100\n" + blocks + "M30\n", "--max-motions", "2",
                       "--motion", "m.json", wanted=5)
        last = [record for record in box.motions("m.json") if "to" in record][-1]
        equal(done["position"]["machine"], last["to"], f"position behind {blocks!r}")


@test("the same program with one motion more than --max-motions is a budget, whatever follows")
def one_motion_too_many(box):
    for block in ("X1.M30\n", "X1.\nM30\n", "X1.\n#1=1/0\n"):
        program = "O1\nG21G91F100\nG01X1.\nX1.\n" + block
        equal(summary(box, program, "--max-motions", "2", wanted=5)["motions"], 2, "motions")


@test("--summary has the keys of the contract, in their order")
def summary_keys(box):
    program = ("O1234\n" + HEAD + "G54G00X10.Y20.Z5.\nT3M06\nG01Z-1.F100\nX12.\nG04P500\n"
               "#100=5\n#3006=1(LOOK)\nG00Z5.\nM30\n")
    done = summary(box, program, "--set", "#5221=100")
    equal(list(done), ["program", "file", "machine", "dialect", "chosen", "status", "alarm",
                       "blocks", "motions", "time_s", "time_feed_s", "dwell_s", "rapid_mm", "cut_mm", "extents",
                       "position", "tools", "messages", "parts", "assumed", "variables"], "keys")
    equal((done["program"], done["file"], done["status"], done["alarm"]),
          ("O1234", "part.nc", "end", None), "head")
    equal(done["extents"], {"X": [110, 112], "Y": [20, 20], "Z": [-1, 5]}, "extents")
    equal(done["position"], {"work": {"X": 12, "Y": 20, "Z": 5},
                             "machine": {"X": 112, "Y": 20, "Z": 5}}, "position")
    equal((done["motions"], done["tools"], done["messages"], done["parts"], done["dwell_s"]),
          (4, [3], ["LOOK"], 1, 0.5), "counts")
    near(done["cut_mm"], 8, 1e-9, "cut_mm")
    near(done["rapid_mm"], (110**2 + 20**2 + 5**2) ** 0.5 + 6, 1e-9, "rapid_mm")
    equal(done["variables"], {"#100": 5}, "variables")


@test("the variables of the summary stand as they did before the reset of M30 or at the alarm")
def summary_variables(box):
    done = summary(box, "O1\n#1=1\n#33=33\n#100=2\n#199=3\n#500=4\n#999=5\n#2=#0\nM30\n")
    wanted = {"#1": 1, "#33": 33, "#100": 2, "#199": 3, "#500": 4, "#999": 5}
    equal(done["variables"], wanted, "variables at M30")
    done = summary(box, "O1\n#1=1\n#100=2\n#101=1/0\nM30\n", wanted=1)
    equal(done["variables"], {"#1": 1, "#100": 2}, "variables at the alarm")
    equal(done["status"], "alarm", "status")
    equal(list(done["alarm"]), ["code", "message", "file", "line", "column", "program"],
          "keys of the alarm")
    equal((done["alarm"]["code"], done["alarm"]["line"], done["alarm"]["program"]),
          ("PS0112", 4, "O0001"), "alarm")


@test("--motion writes the records of the contract, one object a line")
def motion_records(box):
    box.write("part.nc", "O1\n" + HEAD +
              "G00X10.\nG01Z-2.F200\nG03X20.Y10.I0.J10.\nG02X20.Y10.I5.J0.Z-4.\n"
              "G04P500\nT3M06\nM03S1200\nM08\nG93G01X30.F2.\nG94\n"
              "M60\nM00\n#3006=1(ATTACH)\nM09M05\nM30\n")
    status(box.kerf("run", "part.nc", "--motion", "m.json"), 0)
    records = box.motions("m.json")
    at = {"X": 20, "Y": 10, "Z": -2}
    wanted = [
        {"kind": "rapid", "program": "O0001", "line": 3, "column": 1, "to": {"X": 10, "Y": 0, "Z": 0}},
        {"kind": "line", "program": "O0001", "line": 4, "column": 1, "to": {"X": 10, "Y": 0, "Z": -2},
         "feed": 200, "feed_mode": "per-minute"},
        {"kind": "arc", "program": "O0001", "line": 5, "column": 1, "to": at, "plane": "XY",
         "center": [10, 10], "direction": "ccw", "turns": 0, "feed": 200,
         "feed_mode": "per-minute"},
        {"kind": "arc", "program": "O0001", "line": 6, "column": 1, "to": {**at, "Z": -4}, "plane": "XY",
         "center": [25, 10], "direction": "cw", "turns": 0, "feed": 200,
         "feed_mode": "per-minute"},
        {"kind": "dwell", "program": "O0001", "line": 7, "column": 1, "seconds": 0.5},
        {"kind": "tool", "program": "O0001", "line": 8, "column": 1, "tool": 3},
        {"kind": "spindle", "program": "O0001", "line": 9, "column": 1, "direction": "cw", "speed": 1200,
         "mode": "rpm"},
        {"kind": "coolant", "program": "O0001", "line": 10, "column": 1, "state": "flood"},
        {"kind": "line", "program": "O0001", "line": 11, "column": 1, "to": {"X": 30, "Y": 10, "Z": -4},
         "feed": 2, "feed_mode": "inverse-time"},
        {"kind": "mcode", "program": "O0001", "line": 13, "column": 1, "code": 60},
        {"kind": "stop", "program": "O0001", "line": 14, "column": 1, "optional": False},
        {"kind": "message", "program": "O0001", "line": 15, "column": 1, "text": "ATTACH"},
    ]
    for got, want in zip(records, wanted):
        equal(got, want, f"record of line {want['line']}")
    equal(records[-1], {"kind": "end", "program": "O0001", "line": 17, "column": 1}, "the last record")


@test("--plot draws the path as SVG or PNG by the ending of the file")
def plot_option(box):
    box.write("part.nc", "O1\n" + HEAD + "G00X10.\nG01Z-2.F200\nG03X20.Y10.I0.J10.\nM30\n")
    status(box.kerf("run", "part.nc", "--plot", "path.svg"), 0)
    equal(xml.fromstring(box.read("path.svg")).tag.split("}")[-1], "svg", "the root of the SVG")
    status(box.kerf("run", "part.nc", "--plot", "path.png"), 0)
    equal(box.read("path.png")[:8], b"\x89PNG\r\n\x1a\n", "the beginning of the PNG")


@test("--dprnt names the file for what the program prints; without it that is standard output")
def dprnt_option(box):
    box.write("part.nc", "O1\n#1=1.5\nPOPEN\nDPRNT[A*B]\nDPRNT[X#1[33]]\nPCLOS\nM30\n")
    result = box.kerf("run", "part.nc")
    equal(result.text, "A B\nX1.500\n", "standard output")
    result = box.kerf("run", "part.nc", "--dprnt", "out.txt")
    equal((result.out, box.read("out.txt")), (b"", b"A B\nX1.500\n"), "standard output, file")
    equal(box.kerf("run", "part.nc", "--dprnt", "-").text, "A B\nX1.500\n", "--dprnt -")


@test("--keep-partial is what it takes to write --post when the end is not reached")
def keep_partial_option(box):
    endings = {"an alarm": ("G01X1.F100\n#1=1/0\nM30\n", [], 1),
               "a stop": ("G01X1.F100\nM01\nM30\n", ["--optional-stop"], 0),
               "a budget": ("G01X1.F100\nN1GOTO1\n", ["--max-seconds", "0.05"], 5)}
    for name, (blocks, words, wanted) in endings.items():
        box.write("part.nc", "O1\n" + HEAD + blocks)
        command = ["run", "part.nc", "--post", "post.nc", "--motion", "m.json", *words]
        result = box.kerf(*command)
        status(result, wanted)
        check("post.nc" not in box.files(), f"--post was written after {name}")
        check("wrote post.nc" not in result.err,
              f"after {name} the summary claims that it wrote post.nc")
        check("m.json" in box.files(), f"--motion was not written after {name}")
        status(box.kerf(*command, "--keep-partial"), wanted)
        contains(box.read("post.nc").decode(), "X1", f"--post after {name}")
        os.remove(box.path("post.nc"))


@test("--post is written when the run reaches its end")
def post_option(box):
    box.write("part.nc", "O1\n" + HEAD + "G01X1.F100\nM30\n")
    status(box.kerf("run", "part.nc", "--post", "-"), 0)
    contains(box.kerf("run", "part.nc", "--post", "-").text, "G1 X1. F100.\n", "the posted program")


@test("--diagnostics json leaves nothing but JSON objects on standard error")
def diagnostics_option(box):
    box.write("part.nc", "O1\n#1=1/0\nM30\n")
    text = box.kerf("run", "part.nc", "--diagnostics", "text")
    contains(text.err, "part.nc:2:", "the text")
    json_form = box.kerf("run", "part.nc", "--diagnostics", "json")
    check(json_form.err.startswith('{"severity":"error","code":"PS0112"'),
          f"JSON was asked for: {json_form.err!r}")
    equal(len(json_form.err.splitlines()), 1, "lines of standard error")


@test("the summary for people names the files that were written, and no others")
def written_files(box):
    box.write("part.nc", "O1\n" + HEAD + "G01X1.F100\nM30\n")
    result = box.kerf("run", "part.nc", "--motion", "m.json", "--summary", "-", "--post", "p.nc")
    equal([line.strip() for line in result.err.splitlines() if "wrote" in line],
          ["wrote m.json", "wrote p.nc"], "files that it names")


@test("--coverage counts how often each line ran")
def coverage_option(box):
    box.write("part.nc", "%\nO1 (COUNT)\n#1=0\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\nM98P2L2\nGOTO9\n"
                         "#100=1\nN9M30\nO2\n(A \"COMMENT\", IT IS)\nG04P1\nM99\n%\n")
    status(box.kerf("run", "part.nc", "--coverage", "c.csv"), 0)
    rows = coverage_rows(box.read("c.csv"))
    equal(rows[0], ["file", "line", "count", "source", "assumed"], "head")
    equal([row[3] for row in rows[1:]], box.read("part.nc").decode().splitlines(), "sources")
    equal([int(row[1]) for row in rows[1:]], list(range(1, 16)), "line numbers")
    counts = {int(row[1]): int(row[2]) for row in rows[1:]}
    wanted = {3: 1, 5: 3, 7: 1, 8: 1, 9: 0, 10: 1, 12: 0, 13: 2, 14: 2, 15: 0}
    equal({line: counts[line] for line in wanted}, wanted, "counts")


def coverage_rows(content):
    import csv
    import io
    return list(csv.reader(io.StringIO(content.decode())))


@test("--coverage numbers the lines as diagnostics do, whatever ends them")
def coverage_line_ends(box):
    blocks = ["O1", "#1=1", "#1=2", "G04P1", "M30"]
    for name, end in (("LF", "\n"), ("CR LF", "\r\n"), ("CR", "\r"), ("CR CR LF", "\r\r\n")):
        box.write("part.nc", end.join(blocks) + end)
        status(box.kerf("run", "part.nc", "--coverage", "c.csv"), 0)
        rows = coverage_rows(box.read("c.csv"))[1:]
        equal([(int(row[1]), row[3]) for row in rows], list(enumerate(blocks, 1)),
              f"lines with {name}")
        equal([int(row[2]) for row in rows][1:], [1, 1, 1, 1], f"counts with {name}")


@test("--coverage keeps its line numbers behind a line of 10,000 characters")
def coverage_long_line(box):
    box.write("part.nc", "O1\n(" + "c" * 10000 + ")\n#1=1\nM30\n")
    status(box.kerf("run", "part.nc", "--coverage", "c.csv"), 0)
    rows = coverage_rows(box.read("c.csv"))[1:]
    equal([row[1] for row in rows], ["1", "2", "3", "4"], "line numbers")
    equal([row[2] for row in rows][2:], ["1", "1"], "counts of the last lines")


@test("--coverage says what was assumed in a line")
def coverage_assumed(box):
    box.write("part.nc", "O1\nG21G90\nG00X10\nM30\n")
    status(box.kerf("run", "part.nc", "--coverage", "c.csv", "--summary", "s.json"), 0)
    said = [(int(row[1]), row[4]) for row in coverage_rows(box.read("c.csv"))[1:] if row[4]]
    wanted = [(item["line"], item["what"]) for item in box.json("s.json")["assumed"]
              if item["line"]]
    check(wanted, "the run assumed nothing")
    equal(said, wanted, "assumptions by line")
