"""kerf run m.jsonl: what --motion wrote is a program, and everything made of it is what the run made."""

import json

import harness
from harness import alarm, check, contains, equal, refused, status, test
from reader_tests import ROOT, example_inputs

AT = {"X": 10, "Y": 5, "Z": 0}
OF = '"program":"O0000","line":'
RECORDS = [
    '{"kind":"rapid",' + OF + '2,"to":{"X":10,"Y":5,"Z":0}}',
    '{"kind":"line",' + OF + '4,"to":{"X":20,"Y":5,"Z":-1},"feed":1000,"feed_mode":"per-minute"}',
    '{"kind":"arc",' + OF + '5,"to":{"X":30,"Y":5,"Z":-1},"plane":"XY","center":[25,5],"direction":"cw","turns":0,'
    '"feed":1000,"feed_mode":"per-minute"}',
    '{"kind":"dwell",' + OF + '6,"seconds":0.5}',
    '{"kind":"end",' + OF + '7}',
]
LINE = RECORDS[1]


def jsonl(*records):
    return "".join(record + "\n" for record in records)


@test("motion records read back give the same bytes, with or without a column")
def same_bytes(box):
    box.write("m.jsonl", jsonl(*RECORDS))
    status(box.kerf("run", "m.jsonl", "--machine", "mill3", "--motion", "again.jsonl", "--summary", "s.json"), 0)
    equal(box.read("again.jsonl"), box.read("m.jsonl"), "records")
    summary = box.json("s.json")
    equal((summary["dialect"], summary["status"], summary["cut_mm"] > 25, summary["dwell_s"]), ("motion", "end", True, 0.5),
          "summary")
    box.write("m.jsonl", "\ufeff" + jsonl(*RECORDS).replace("\n", "\r\n\r\n"))
    status(box.kerf("run", "m.jsonl", "--motion", "crlf.jsonl"), 0)
    equal(box.read("crlf.jsonl"), box.read("again.jsonl"), "with a byte order mark, CR and empty lines")


# What is made of the motions, by another process or at once.
OUTPUTS = {"motion": "jsonl", "post": "nc", "rows": "csv"}
# How far ahead the planner sees in many short moves depends on how many blocks are read for them.
TIMED = {"points": "csv"}
EXAMPLES = {
    "01_flanges": {}, "04_probing": {}, "09_cam_part": {"teach": "tch"}, "31_tilted_groove": {},
    "18_shaft": {}, "21_bolt_flange": {}, "22_bushes": {}, "11_cardioid": {"teach": "tch", "pwm": "csv"},
    "17_coaster": {"pwm": "csv"}, "13_tube": {"teach": "tch", "pwm": "csv"}, "15_lens": {"pulses": "csv"},
    "16_flower": {"pattern": "pat"}}
# Inputs that the motions hold already.
SPOKEN = {"--skip-at": 1, "--set": 1, "--stock": 1, "--stock-zero": 1, "--fixture": 1, "--block-skip": 1}


def without(words, spoken):
    kept, at = [], 0
    while at < len(words):
        if words[at] in spoken:
            at += 1 + spoken[words[at]]
        else:
            kept.append(words[at])
            at += 1
    return kept


def outputs(box, more, folder):
    box.write(folder + "/.keep", "")
    return [word for name, ending in more.items() for word in (f"--{name}", box.path(folder, f"{name}.{ending}"))]


def twice(box, name, more):
    timed = name != "09_cam_part"
    more = {**OUTPUTS, **(TIMED if timed else {}), **more}
    inputs = example_inputs(ROOT / "examples" / name / "command")
    status(box.kerf(*inputs, *outputs(box, more, "once"), "--summary", box.path("s.json"), cwd=ROOT), 0)
    machine = [] if "--machine" in inputs else ["--machine", box.json("s.json")["machine"]]
    status(box.kerf("run", box.path("once", "motion.jsonl"), *machine, *without(inputs[2:], SPOKEN),
                    *outputs(box, more, "again"), "--summary", box.path("t.json"), cwd=ROOT), 0)
    for output, ending in more.items():
        equal(box.read(f"again/{output}.{ending}"), box.read(f"once/{output}.{ending}"), f"--{output} of {name}")
    first, second = box.json("s.json"), box.json("t.json")
    for key in (*["time_s"] * timed, "status", "rapid_mm", "cut_mm", "dwell_s", "extents", "tools"):
        equal(second.get(key), first.get(key), f"{key} of the summary of {name}")


for example, further in EXAMPLES.items():
    test(f"the motions of example {example} make in another process what its run makes, byte by byte")(
        lambda box, name=example, more=further: twice(box, name, more))

EVERYTHING = """O7
G21G90G17
T3M06
M03S1200
M08
G61G00X10.Y5.
G64G43H3Z5.
G84Z-3.R2.F300
G80G09G01Z-1.F200
G93X20.F2.
G94G28Z20.F100.
M01
M07
#3006=1(TURN 5" \\ OVER)
M60
G04P250
M98P9001
G31Z-5.F50
M05M09
M30
O9001
G03X20.Y5.I5.J0
M99
"""


@test("everything that motions have is in their records: modes, lengths, overrides, stops, texts")
def everything(box):
    box.write("tools.toml", "[[tool]]\nnumber = 3\nlength = 81.5\n")
    box.write("part.nc", EVERYTHING)
    outs = ("motion", "post", "rows", "points")
    words = lambda run: [w for o in outs for w in (f"--{o}", f"{run}.{o}.csv")]
    tools = ["--tools", "tools.toml", "--machine", "mill3"]
    status(box.kerf("run", "part.nc", *tools, *words("once")), 0)
    status(box.kerf("run", "once.motion.csv", "--dialect", "motion", *tools, *words("again")), 0)
    for output in outs:
        equal(box.read(f"again.{output}.csv"), box.read(f"once.{output}.csv"), output)
    text = box.read("once.motion.csv").decode()
    for part in ('"exact_stop":true', '"fixed_override":true', '"length":{"axis":"Z","mm":81.5,"offset":3}',
                 '"linear":false', '"optional":true,"passed":true', "TURN 5"):
        contains(text, part, "the records")
    equal(text.count('"length"'), 3, "lengths are said where they change")


@test("records name the file of a program that was called, and a program without a number its own")
def named_files(box):
    box.write("part.nc", "G21G90G01X5.F100\nM98P9001\nX9.\nM30\n")
    box.write("lib/O9001.nc", "O9001\nG01X7.\nM99\n")
    status(box.kerf("run", "part.nc", "--library", "lib", "--motion", "m.jsonl", "--post", "once.nc"), 0)
    first, second, *_ = box.motions("m.jsonl")
    equal((first["source"], first["program"]), ("part.nc", "O0000"), "of the first record")
    check(second["file"].endswith("O9001.nc") and "source" not in second, f"second: {second}")
    status(box.kerf("run", "m.jsonl", "--motion", "again.jsonl", "--post", "again.nc"), 0)
    equal(box.read("again.jsonl"), box.read("m.jsonl"), "records")
    equal(box.read("again.nc"), box.read("once.nc"), "posted")


WRONG = [
    ("G01 X5.", "MJ0001", 1, "no JSON"),
    ('{"kind":"line"', "MJ0001", 15, "',' or '}' is expected"),
    ('{"kind":', "MJ0001", 9, "ends inside of its object"),
    ("[1,2]", "MJ0001", 1, "no object"),
    ('{"program":"O0001"}', "MJ0001", 1, "has no kind"),
    ('{"kind":"jump",' + OF + "1}", "MJ0001", 9, "no such kind"),
    (LINE + " {}", "MJ0001", len(LINE) + 2, "text follows"),
    (LINE.replace(',"feed":1000', ""), "MJ0002", 1, "feed is missing"),
    (LINE.replace("1000", '"fast"'), "MJ0002", LINE.index("1000") + 1, "feed is not a number"),
    (LINE.replace("1000", "-5"), "MJ0002", LINE.index("1000") + 1, "feed is -5: it can be from 1e-06"),
    (LINE.replace("1000", "1e400"), "MJ0001", LINE.index("1000") + 1, "no JSON"),
    (LINE.replace("per-minute", "per-hour"), "MJ0002", LINE.index('"per-minute"') + 1, "not one of per-minute"),
    (LINE.replace('"Y":5,', ""), "MJ0002", LINE.index('{"X"') + 1, "Y is missing"),
    (LINE.replace('"O0000"', '"PART"'), "MJ0002", LINE.index('"O0000"') + 1, "program is not O and a number"),
    (LINE.replace('"feed":1000', '"feed":1000,"feed":2'), "MJ0002", None, "feed stands there twice"),
    (LINE.replace('"line":4', '"line":4.5'), "MJ0002", None, "line is no whole number"),
    (LINE.replace('"Z":-1', '"Z":-1,"A":3'), "MJ0003", LINE.index("-1") + 8, "no axis A"),
    (RECORDS[2].replace("[25,5]", "[25.2,5]"), "MJ0004", RECORDS[2].index("[25") + 1, "begins 15.2 mm"),
    (RECORDS[2].replace("[25,5]", "[10,5]"), "MJ0004", RECORDS[2].index("[25") + 1, "begins 0 mm"),
    (RECORDS[2].replace("[25,5]", "[25]"), "MJ0002", RECORDS[2].index("[25") + 1, "has 2 numbers"),
    (RECORDS[2].replace("XY", "XC"), "MJ0002", None, "plane is not one of XY, ZX, YZ"),
]


@test("a record that is none is told with line, column and what is wrong, and check tells all of them")
def wrong_records(box):
    for number, (text, code, column, sentence) in enumerate(WRONG):
        box.write("m.jsonl", jsonl(RECORDS[0], text, RECORDS[4]))
        result = box.kerf("run", "m.jsonl", "--machine", "mill3", "--post", "p.nc")
        alarm(result, code, 2)
        contains(result.err, sentence, f"wrong record {number}")
        if column is not None:
            contains(result.err, f"m.jsonl:2:{column}: error: {code}", f"wrong record {number}")
        check("p.nc" not in box.files(), "a file that drives a machine was written")
    box.write("all.jsonl", jsonl(RECORDS[0], *(text for text, *_ in WRONG), RECORDS[4]))
    result = box.kerf("check", "all.jsonl", "--machine", "mill3")
    status(result, 1)
    for number, (_, code, _, sentence) in enumerate(WRONG):
        if code != "MJ0004":
            contains(result.text, f"all.jsonl:{number + 2}:", "check")
    for code in ("MJ0001", "MJ0002", "MJ0003", "MJ0004"):
        contains(result.text, code, "check")


@test("each code of motion records is an alarm at its line")
def each_code(box):
    for text, code in (("{}", "MJ0001"), (LINE.replace("line\",", "x\",").replace("O0000", "5"), "MJ0001")):
        box.write("m.jsonl", jsonl(text))
        alarm(box.kerf("run", "m.jsonl"), "MJ0001", 1)
    box.write("m.jsonl", jsonl(LINE.replace('"feed":1000,', "")))
    alarm(box.kerf("run", "m.jsonl"), "MJ0002", 1)
    box.write("m.jsonl", jsonl(LINE.replace("Y", "W")))
    alarm(box.kerf("run", "m.jsonl", "--machine", "mill3"), "MJ0003", 1)
    box.write("m.jsonl", jsonl(RECORDS[2]))
    alarm(box.kerf("run", "m.jsonl"), "MJ0004", 1)


@test("arcs in space whose points are no arc are alarms at their record")
def space_arcs(box):
    arc = {"kind": "space-arc", "program": "O0000", "line": 1, "to": AT, "via": AT, "feed": 1, "feed_mode": "per-minute"}
    for via, to, code in (({"X": 0, "Y": 0, "Z": 0}, AT, "ARC_COINCIDENT"), ({**AT, "X": 20, "Y": 10}, AT, "ARC_COLLINEAR")):
        box.write("m.jsonl", jsonl(json.dumps({**arc, "via": via, "to": to})))
        alarm(box.kerf("run", "m.jsonl", "--machine", "mill3"), code, 1)


@test("a member that means nothing in a record is told once, and not at all where it does")
def unknown_members(box):
    box.write("m.jsonl", jsonl(*(r.replace('"line":', '"colour":"red","line":') for r in RECORDS)))
    status(box.kerf("run", "m.jsonl", "--summary", "s.json", "--motion", "again.jsonl"), 0)
    equal(box.json("s.json")["assumed"], [{"line": 1, "what": "member colour means nothing in a motion record"}], "assumed")
    equal(box.read("again.jsonl").decode(), jsonl(*RECORDS), "records")


@test("a file is motion records by its ending or its first line, and its axes choose the machine")
def chosen(box):
    point = lambda axes: json.dumps(dict.fromkeys(axes, 1)).replace(" ", "")
    for axes, beam, machine in (("XYZ", False, "mill3"), ("XYZ", True, "laser3"), ("XYZAC", True, "laser5"), ("XYZA", False, "mill4"),
                                ("XZ", False, "lathe2"), ("XZC", False, "lathe3c")):
        power = '{"kind":"power",' + OF + '1,"percent":50}'
        box.write("motions.txt", "\n" + jsonl(*[power] * beam, '{"kind":"rapid",' + OF + '1,"to":' + point(axes) + "}"))
        status(box.kerf("run", "motions.txt", "--summary", "s.json"), 0)
        equal((box.json("s.json")["machine"], box.json("s.json")["dialect"]), (machine, "motion"), axes)
    box.write("part.nc", "O1\nM30\n")
    alarm(box.kerf("run", "part.nc", "--dialect", "motion"), "MJ0001", 1)
    box.write("empty.jsonl", "")
    status(box.kerf("run", "empty.jsonl", "--summary", "s.json"), 0)
    equal(box.json("s.json")["motions"], 0, "motions of an empty file")


@test("records behind the end are not made, and --optional-stop stops where a record of M01 stands")
def stops(box):
    stop = '{"kind":"stop",' + OF + '5,"optional":true,"passed":true}'
    box.write("m.jsonl", jsonl(RECORDS[0], stop, LINE, RECORDS[4], RECORDS[0]))
    status(box.kerf("run", "m.jsonl", "--motion", "again.jsonl"), 0)
    equal(box.read("again.jsonl").decode(), jsonl(RECORDS[0], stop, LINE, RECORDS[4]), "records")
    status(box.kerf("run", "m.jsonl", "--motion", "again.jsonl", "--optional-stop", "--summary", "s.json"), 0)
    equal(box.json("s.json")["status"], "stopped", "status")
    equal(box.read("again.jsonl").decode(), jsonl(RECORDS[0], stop.replace(',"passed":true', "")), "records up to M01")


@test("motion records of any number take the memory of a few")
def long_file(box):
    peaks = []
    for count in (10_000, 400_000):
        box.write("m.jsonl", jsonl(*(LINE.replace('"X":20', f'"X":{n % 90 + 0.5}') for n in range(count)), RECORDS[4]))
        result = box.kerf("run", "m.jsonl", "--motion", "again.jsonl", "--post", "p.nc", peak=True)
        status(result, 0)
        equal(box.read("again.jsonl"), box.read("m.jsonl"), "records")
        peaks.append(result.peak_kib)
    if harness.MEASURES_MEMORY:
        check(peaks[1] < peaks[0] + 4096, f"{peaks[1]} KiB for 400,000 records, {peaks[0]} for 10,000")


@test("hostile motion records end in a sentence and take no memory")
def hostile(box):
    nested = '{"kind":"line","to":' + "[" * 100_000
    for text in (nested, '{"kind":"line",' + '"a":1,' * 2000 + '"b":2}', '{"a":"' + "x" * 3_000_000, "\0\0\0", '{"kind":"\\ud800"}',
                 '{"kind":"message","program":"O1","line":1,"text":"\\ud83d\\ude00 \\u0000 é \\q"}'):
        box.write("m.jsonl", text + "\n")
        result = box.kerf("run", "m.jsonl", "--diagnostics", "json")
        status(result, 1)
        check(len(result.err) < 5000, "it says too much")
    refused(box.kerf("run", "none.jsonl"), 3, "none.jsonl")
