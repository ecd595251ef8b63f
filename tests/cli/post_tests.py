"""--post: the posted program, run again, makes the same path."""

import re

import harness
from harness import alarm, check, equal, near, status, test

TOLERANCE = 1e-3
HEAD = "O1; G21G90G17G94; "

# Blocks end in semicolons.
PROGRAMS = {
    "lines and rapids":
        HEAD + "G00X10.Y20.Z5.; G01Z-1.F100; X30.F250.5; G91Y-.125; G90G00Z5.; M30;",
    "arcs by R in all planes":
        HEAD + "F300; G00X10.Y10.Z10.; G17G02X20.Y20.R10.; G03X10.Y10.R-10.; G18G02X20.Z20.R12.; "
        "G03X10.Z10.R-15.; G19G03Y20.Z20.R10.; G02Y10.Z10.R20.; M30;",
    "arcs by I, J, K in all planes":
        HEAD + "F300; G00X10.Y10.Z10.; G02X20.I5.; G03X10.I-5.; G18G02X20.I5.; G03X10.I-5.; "
        "G19G02Z20.K5.; G03Z10.K-5.; M30;",
    "full circles and helices":
        HEAD + "F300; G00X10.; G02I5.; G03J-7.5; G02I5.Z-3.; G03X20.I5.Z-4.; G18G02K3.; G03K3.Y2.; "
        "G19G03J2.X5.; M30;",
    "arcs whose centre is no decimal":
        HEAD + "F300; G00X0Y0; #1=0; WHILE[#1LT40]DO1; G02X[#1*1.7]Y[#1*0.3+1]R[20+#1]; "
        "G03X[#1*1.1]Y[#1*0.7]R-[30+#1/3]; #1=#1+1; END1; M30;",
    "canned cycles":
        HEAD + "G00Z50.; G98G81X10.Y10.Z-5.R2.F100; X20.; G99X30.; G82X10.Y20.P500Z-6.; "
        "G83X5.Y5.Z-10.R2.Q4.; G73X6.Z-10.Q3.; G98G85X1.Z-3.R1.; G86X2.; G89X3.P250; "
        "G76X4.Q1.; G80G00X0; M30;",
    "tapping and back boring":
        HEAD + "S500M03; G00Z50.; G84X10.Z-5.R2.F100P100; G74X20.; G87X30.Z-10.R-20.Q2.; "
        "G88X40.Z-2.R1.; G80; M30;",
    "rows of holes":
        HEAD + "G00Z10.; G91G99G81X10.Z-12.R-8.K3F100; Y10.L2; G80G90; M30;",
    "a macro with a loop":
        HEAD + "G65P9207X0Y0R25.A30.H7.Z-3.; G65P9207X5.Y5.R10.H3.Z-1.; M30; O9207; #31=1; "
        "G00X#24Y#25Z5.; WHILE[#31LE#11]DO1; "
        "G00X[#24+#18*COS[#1+[#31-1]*360/#11]]Y[#25+#18*SIN[#1+[#31-1]*360/#11]]; "
        "G01Z#26F200; G00Z5.; #31=#31+1; END1; M99;",
    "subprograms and modal calls":
        HEAD + "G00Z5.; M98P51002; G66P1003A2.; X1.; X2.; G67; M30; O1002; G91G00X1.5Y.25; G90M99; "
        "O1003; G01Z-#1F100; G00Z5.; M99;",
    "work offsets and shifts":
        HEAD + "G10L2P1X100.Y50.Z-20.; G10L2P2X-3.333; G54G00X0Y0Z0; G55X1.; G52X5.Y5.; "
        "G01X0Y0F100; G52X0Y0; G92X0Y0; G01X10.; G53X0Y0; G28Z0; M30;",
    "cutter compensation":
        HEAD + "G10L12P1R5.; G00X-20.Y-10.; G41D1G01X0Y0F200; Y50.; X50.; G02X70.Y30.R20.; "
        "G03X90.Y10.R20.; G01Y0; X0; G40X-20.Y-10.; M30;",
    "rounded corners of the compensation":
        HEAD + "G10L12P1R4.; G00X-20.Y-10.; G41D1G01X0Y0F200; X20.Y40.; X40.Y0; X0; G40X-20.Y-10.; "
        "M30;",
    "rotation, scaling and mirror":
        HEAD + "F200; G68X10.Y5.R33.3; G01X20.Y7.; G02X30.R9.; G69; G51X0Y0Z0P2500; G01X3.Y4.Z-1.; "
        "G03X5.Y6.R4.; G50; G51.1X50.; G01X40.Y10.; G02X45.Y12.R8.; G50.1X0; "
        "G51X1.Y2.I2000J-2000K1000; G01X3.Y4.; G03X7.Y8.R9.; G50; M30;",
    "polar coordinates":
        HEAD + "G16; G00X50.Y0; G81X50.Y30.Z-5.R2.F200; Y60.; Y90.; G80; G15; M30;",
    "an inch program":
        "O1; G20G90G17G94; G00X1.Y2.Z.5; G01Z-.125F10.; G02X2.Y3.R1.5; G03X1.5I-.25; "
        "G81X.1Y.2Z-.3R.1F5.; G80; M30;",
    "feed per revolution and inverse time":
        HEAD + "S600M03; G95G01X10.F.1; Y5.; G93G01X20.F4.; G02X30.R8.F3.; G94G01X0F100; M30;",
    "probing":
        HEAD + "G31X10.F50; G31Z-5.; G01X0; M30;",
    "spindle, tool, coolant, dwell and stop":
        HEAD + "T7M06; M03S1200; M08; G04P1500; G04X.25; M00; M04S800; M07; M05M09; M30;",
    "single precision traps":
        HEAD + "G00X123456.789Y-99999.999; G01X-0.001Y0.0005F0.5; X.0004; M30;",
}


def again(post):
    """What the control reads in place of the posted program, whose P of G4 counts seconds."""
    return re.sub(r"^G4 P(\S+)$", lambda m: f"G4 X{float(m[1]):f}", post, flags=re.MULTILINE)


def path_of(records):
    """What moves: kind and numbers. A probing move is posted as a line."""
    for record in records:
        if "to" in record:
            kind = "line" if record["kind"] == "probe" else record["kind"]
            yield {**record, "kind": kind}


def differs(a, b):
    return any(abs(a[key] - b[key]) > TOLERANCE for key in a)


def without_approach(moves):
    """From the first cut on, and where it begins: the rapids before it may be other ones."""
    first = next((i for i, move in enumerate(moves) if move["kind"] != "rapid"), len(moves))
    return moves[first:], moves[first - 1]["to"] if first else None


def compare(first, second):
    (one, begin), (two, begin_again) = (without_approach(list(path_of(r))) for r in (first, second))
    stands = dict.fromkeys((one or two)[0]["to"], 0) if one or two else {}
    check(not differs(begin or stands, begin_again or stands),
          f"the first cut begins at {begin_again}, wanted {begin}")
    for i, (a, b) in enumerate(zip(one, two)):
        where = f"move {i} (line {a['line']})"
        equal(b["kind"], a["kind"], f"{where}: kind")
        check(not differs(a["to"], b["to"]), f"{where}: ends at {b['to']}, wanted {a['to']}")
        if a["kind"] == "arc":
            equal((b["plane"], b["direction"], b["turns"]),
                  (a["plane"], a["direction"], a["turns"]), f"{where}: plane, direction, turns")
            for u, v in zip(a["center"], b["center"]):
                near(v, u, TOLERANCE, f"{where}: centre")
        if a.get("feed_mode") == "per-minute":
            near(b["feed"], a["feed"], TOLERANCE, f"{where}: feed")
    equal(len(two), len(one), "moves")


def others(records):
    """Everything else that the posted program must do as well, in order. What stands still need not
    be stopped, and what turns at the end is."""
    turns = False
    for record in records:
        kind = record["kind"]
        if kind == "spindle" and record["direction"] != "orient":
            if record["direction"] != "stop" or turns:
                yield kind, record["direction"], record["speed"] * (record["direction"] != "stop")
            turns = record["direction"] != "stop"
        elif kind == "end" and turns:
            yield "spindle", "stop", 0
            yield kind, None, None
        elif kind in ("tool", "coolant", "stop", "end"):
            yield kind, record.get("tool"), record.get("state")
        elif kind == "dwell":
            yield kind, round(record["seconds"], 6), None


def post_and_run(box, program, *words):
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--post", "post.nc", "--motion", "first.json", *words), 0)
    box.write("again.nc", again(box.read("post.nc").decode()))
    result = box.kerf("run", "again.nc", "--motion", "again.json",
                      *[word for word in words if word.startswith(("--machine", "mill"))])
    check(result.status == 0, f"the posted program ends with {result.status}: {result.err[:300]}")
    return box.motions("first.json"), box.motions("again.json")


def round_trip(program):
    def run(box):
        first, second = post_and_run(box, program)
        check(any("to" in record for record in first) or "spindle" in str(first), "nothing moved")
        compare(first, second)
        without_orient = [item for item in others(first)]
        stops = [item for item in others(second)]
        if not any(r["kind"] == "spindle" and r["direction"] == "orient" for r in first):
            equal(stops, without_orient, "what is no move")
    return run


for name, program in PROGRAMS.items():
    test(f"the posted program of {name} makes the same path")(round_trip(program))


@test("a posted program holds no macro, no cycle, no compensation and no offset")
def plain(box):
    for name, program in PROGRAMS.items():
        box.write("part.nc", program)
        status(box.kerf("run", "part.nc", "--post", "post.nc"), 0)
        text = box.read("post.nc").decode()
        words = set(re.findall(r"G\d+(?:\.\d+)?", text))
        allowed = {"G0", "G1", "G2", "G3", "G4", "G17", "G18", "G19", "G21", "G90", "G94"}
        equal(sorted(words - allowed), [], f"codes in the posted program of {name}")
        check(not re.search(r"[#\[\]]|GOTO|WHILE|M98|G65", text), f"macros in {name}")
        check(text.count("M30") == 1 and text.rstrip().endswith("M30"), f"the end of {name}")
        check(max(map(len, text.splitlines())) < 80, f"a long line in {name}")


@test("a posted program can be misread by no control: a point in coordinates, P of a dwell refused where it is ms")
def points_of_numbers(box):
    for name, program in PROGRAMS.items():
        box.write("part.nc", program)
        status(box.kerf("run", "part.nc", "--post", "post.nc"), 0)
        code = "\n".join(line for line in box.read("post.nc").decode().splitlines() if line[0] != "(")
        bare = re.findall(r"[XYZIJKP]-?\d+(?![\d.])", code)
        equal(bare, [], f"numbers without a point in {name}")
        check(not re.search(r"\de", code), f"an exponent in {name}")
    alarm(box.kerf("run", box.write("dwell.nc", "O1\nG4 P2.\nM30\n")), "PS0007", 2)


@test("behind a tool change the posted program switches spindle and beam on again")
def tool_change(box):
    program = HEAD + "T1M6; M3S1000; G1X10.F100; T2M6; X20.; M5; T3M6; M30;"
    for machine in ("mill3", "laser3"):
        box.write("part.nc", program)
        status(box.kerf("run", "part.nc", "--post", "post.nc", "--machine", machine), 0)
        lines = [line for line in box.read("post.nc").decode().splitlines() if line[0] in "MT"]
        equal(lines, ["M5", "T1 M6", "M3 S1000", "T2 M6", "M3 S1000", "M5", "T3 M6", "M30"], f"on {machine}")


@test("what is tapped without override is told in a comment of the posted program")
def tapping_comment(box):
    box.write("part.nc", HEAD + "S500M03; G00Z50.; G84X10.Z-5.R2.F100; X20.; G80; G1X0F100; M30;")
    status(box.kerf("run", "part.nc", "--post", "post.nc"), 0)
    equal(box.read("post.nc").decode().count(": FEED WITHOUT OVERRIDE)"), 2, "comments")


@test("the posted program of a four-axis part turns the same way")
def four_axes(box):
    first, second = post_and_run(box, HEAD + "G00X10.A90.\nG01A180.F500\nX20.A-45.5\nM30\n",
                                 "--machine", "mill4")
    compare(first, second)


@test("constant surface speed is posted as such, and ends with G97")
def surface_speed(box):
    box.write("part.nc", HEAD + "G92S3000\nG96S200M03\nG01X10.F100\nM05\nG97S800M03\nM30\n")
    status(box.kerf("run", "part.nc", "--post", "post.nc"), 0)
    lines = [line for line in box.read("post.nc").decode().splitlines() if "S" in line or "M5" in line]
    lines = [line for line in lines if not line.startswith("(")]
    equal(lines, ["M5", "G92 S3000", "G96 M3 S200", "M5", "G97 M3 S800", "M5"], "spindle blocks")


@test("a posted program posts itself, once its numbers are those of the control")
def itself(box):
    for name, program in PROGRAMS.items():
        box.write("part.nc", program)
        posted = "part.nc"
        for generation in ("one", "two", "three"):
            words = ["--decimal-point", "calculator"] if generation != "one" else []
            status(box.kerf("run", posted, "--post", generation, *words), 0)
            posted = box.write(generation + ".nc", again(box.read(generation).decode()))
        two, three = (box.read(generation).split(b"\n", 1)[1] for generation in ("two", "three"))
        check(two == three, f"the post of the post of {name} differs")


@test("what plain G-code cannot say is a comment with its source line, and the summary counts it")
def only_comments(box):
    box.write("part.nc", HEAD + "G00X1.\nM77\nG31X5.F50\n#3006=1(LOAD {PART})\nM30\n")
    result = box.kerf("run", "part.nc", "--post", "post.nc")
    status(result, 0)
    comments = [line for line in box.read("post.nc").decode().splitlines() if line.startswith("(LINE")]
    equal([line.split(":")[0] for line in comments], ["(LINE 2", "(LINE 3", "(LINE 4"], "comments")
    check("M77" in comments[0] and "PROBING" in comments[1] and "LOAD" in comments[2], str(comments))
    check("is in 3 comments" in result.err and "line 2" in result.err, result.err)


@test("the scale of S and the word of the beam are keys of the machine")
def laser_keys(box):
    box.write("part.bas", "power(50)\nline(9,0)\nend\n")
    words = ["--machine-set", "drive.s_of_full_power=255", "--machine-set", "drive.post_beam=M4"]
    status(box.kerf("run", "part.bas", "--post", "post.nc", *words), 0)
    lines = box.read("post.nc").decode().splitlines()
    check("(LASER: FULL POWER IS S255)" in lines, "the head has no full power")
    equal([line for line in lines if line[0] in "SM"], ["M5", "S127.5", "M4 S127.5", "M5", "M30"],
          "the beam")
    status(box.kerf("run", "part.bas", "--post", "post.nc", "--machine", "mill3"), 0)
    text = box.read("post.nc").decode()
    check("\nM3" not in text.replace("M30", ""), "a spindle turns on a machine without a laser")
    check("(LINE 2: LASER 50 PERCENT)" in text, text)


def posted(box, name, *words):
    """The blocks behind the head's modes, up to the end."""
    status(box.kerf("run", name, "--post", "post.nc", "--summary", "s.json", *words), 0)
    lines = box.read("post.nc").decode().splitlines()
    return lines[lines.index("G21 G90 G94 G17") + 1:]


@test("before the first cut of a posted program every axis stands, also where it is at machine zero")
def every_axis_stands(box):
    box.write("zero.nc", "O1\nG21G90G00X0Y0Z5.\nG01Z-1.F100\nX40.F300\nG00Z5.\nM30\n")
    equal(posted(box, "zero.nc"), ["M5", "G0 Z5.", "G0 X0. Y0.", "G1 Z-1. F100.", "X40. F300.", "G0 Z5.", "M30"], "G-code")
    box.write("zero.tch", "TEACH 1\nPOINT 0 0 0 0 0\nFEED 1000\nLASER ON 50\nARC 10 10 0 0 0 20 0 0 0 0\nEND\n")
    equal(posted(box, "zero.tch"), ["M5", "G0 Z0.", "G0 A0. C0.", "G0 X0. Y0.", "M3 S500", "G2 X20. I10. J0. F1000.",
                                    "M5", "M30"], "taught points")
    box.write("zero.bas", "speed(10);power(50)\nhome\nline(5,0)\nend\n")
    equal(posted(box, "zero.bas"), ["M5", "S500", "G0 Z0.", "G0 X0. Y0.", "M3 S500", "G1 X5. F600.", "M5", "M30"], "BASIC")


@test("a posted program goes up to its highest rapid before it goes anywhere")
def highest_rapid(box):
    box.write("part.nc", HEAD + "M3S900\nG0X10.Y5.Z20.\nG1Z-1.F100\nG0Z77.\nX50.\nZ2.\nG1Z-1.\nG0Z2.\nM30\n")
    equal(posted(box, "part.nc")[:5], ["M5", "G0 Z77.", "G0 X10. Y5.", "G0 Z20.", "M3 S900"], "blocks")
    box.write("part.nc", HEAD + "G0Z30.\nX10.A15.\nZ2.\nG1Z-1.F100\nM30\n")
    equal(posted(box, "part.nc", "--machine", "mill4")[:6],
          ["M5", "G0 Z30.", "G0 A15.", "G0 X10. Y0.", "G0 Z2.", "G1 Z-1. F100."], "rapids behind each other")


TWO_TOOLS = """O2
G21G90G17G94
T1M06
M03S1000
G43H1G00X0Y0Z5.
G01Z-1.F100
G18G02X20.Z-1.R12.
G17G00Z50.
T2M06
G00X50.
G43H2Z5.
G01Z-1.F200
G43H1
X60.
G49G53G00Z0.
M30
"""


@test("tool lengths are in the coordinates of a posted program and told; what they change is a rapid")
def tool_lengths(box):
    box.write("tools.toml", "[[tool]]\nnumber = 1\nlength = 80\n[[tool]]\nnumber = 2\nlength = 50.5\n")
    box.write("part.nc", TWO_TOOLS)
    equal(posted(box, "part.nc", "--tools", "tools.toml"),
          ["M5", "T1 M6", "G0 Z130.", "G0 X0. Y0.", "G0 Z85.", "M3 S1000",
           "(LINE 5: TOOL 1, H1, LENGTH 80. MM IS ADDED TO Z)", "G1 Z79. F100.",
           "G18", "G2 X20. K6.6332 I10. F100.", "G0 Z130.", "T2 M6", "M3 S1000", "X50.",
           "(LINE 11: TOOL 2, H2, LENGTH 50.5 MM IS ADDED TO Z)", "Z55.5", "G1 Z49.5 F200.",
           "(LINE 14: TOOL 2, H1, LENGTH 80. MM IS ADDED TO Z)", "G0 Z79.", "G1 X60.", "G0 Z0.", "M5", "M30"], "blocks")
    head = box.read("post.nc").decode()
    check("(TOOL LENGTHS ARE ADDED: RUN IT WITHOUT TOOL OFFSETS)" in head and "(TRAVEL: Z 0. TO 130.)" in head, head[:500])
    equal(box.json("s.json")["post"], {"lost": []}, "what was lost")
    bare = [line for line in posted(box, "part.nc") if not line.startswith("(")]
    equal(bare[bare.index("M3 S1000") + 1], "G1 Z-1. F100.", "without lengths")
    check("(NO TOOL LENGTH IS ADDED)" in box.read("post.nc").decode(), "the head says nothing of lengths")


@test("a rapid behind a change of tool length goes up before it goes across, and comes down behind")
def rapid_behind_length(box):
    box.write("tools.toml", "[[tool]]\nnumber = 1\nlength = 80\n[[tool]]\nnumber = 2\nlength = 50\n")
    box.write("part.nc", HEAD + "G43H2G0Z5.\nG1Z-1.F100\nG43H1G0X30.Z5.\nG1Z-1.\nG43H2G0X60.Z5.\nG1Z-1.\nM30\n")
    blocks = [line for line in posted(box, "part.nc", "--tools", "tools.toml") if not line.startswith("(")]
    equal(blocks[4:-1], ["G1 Z49. F100.", "G0 Z85.", "X30.", "G1 Z79.", "G0 X60.", "Z55.", "G1 Z49."], "blocks")


@test("the length of a tool at a turning head is lost, and said to be")
def length_at_head(box):
    box.write("tools.toml", "[[tool]]\nnumber = 1\nlength = 80\n")
    box.write("part.nc", "O1\nG21G90M3S500\nG43H1G0X10.Z5.\nG1X20.F500\nG28Z5.\nG0Z6.\nG1X30.\nM30\n")
    blocks = posted(box, "part.nc", "--tools", "tools.toml", "--machine", "laser5")
    check("(LINE 3: TOOL 0, H1, LENGTH 80. MM IS NOT ADDED)" in blocks and "G0 Z5." in blocks, str(blocks))
    equal(box.json("s.json")["post"]["lost"], [{"what": "tool length", "count": 1, "line": 3}], "lost")
    check("(LOST: TOOL LENGTH, 1X, FIRST OF LINE 3)" in box.read("post.nc").decode(), "the head says nothing of it")


@test("a beam that is on at a taught point is off in the posted rapid, which is told, and on behind it")
def beam_in_rapid(box):
    box.write("a.tch", "TEACH 1\nPOINT 0 0 0 0 0\nFEED 600\nLASER ON 40\nLINE 9 0 0 0 0\nPOINT 20 0 0 0 0\nLINE 30 0 0 0 0\nEND\n")
    blocks = posted(box, "a.tch")
    equal(blocks[blocks.index("M3 S400"):], ["M3 S400", "G1 X9. F600.", "(LINE 6: RAPID WITHOUT THE BEAM)", "M5", "G0 X20.",
                                           "M3 S400", "G1 X30.", "M5", "M30"], "blocks")


@test("a beam that burns before any way burns where the path begins, and what follows is a rapid")
def burn_before_any_way(box):
    box.write("a.tch", "TEACH 1\nPOINT 0 0 0 0 0\nFEED 600\nLASER ON 40\nDWELL 0.25\nPOINT 20 0 5 0 0\n"
                       "POINT -9 0 5 0 0\nLINE -9 7 5 0 0\nEND\n")
    rapid = "(LINE 6: RAPID WITHOUT THE BEAM)", "M5", "G0 X20. Z5.", "M3 S400"
    equal(posted(box, "a.tch", "--machine", "laser3"),
          ["M5", "G0 Z5.", "G0 X0. Y0.", "G0 Z0.", "M3 S400", "G1 F1.", "G4 P0.25", *rapid,
           "(LINE 7: RAPID WITHOUT THE BEAM)", "M5", "X-9.", "M3 S400", "G1 Y7. F600.", "M5", "M30"], "blocks")


@test("the head of a posted program says what is lost by kind, and so does the summary")
def lost_by_kind(box):
    loop = "#1=0\nWHILE[#1LT50]DO1\nM77\n#3006=1(PART #1)\n#1=#1+1\nEND1\n"
    box.write("part.nc", HEAD + "G0X1.\n" + loop + "G31X5.F50\nM30\n")
    posted(box, "part.nc")
    equal(box.json("s.json")["post"]["lost"],
          [{"what": "M77", "count": 50, "line": 4}, {"what": "message", "count": 50, "line": 5},
           {"what": "probing move", "count": 1, "line": 8}], "lost")
    head = [line for line in box.read("post.nc").decode().splitlines() if line.startswith("(LOST")]
    equal(head, ["(LOST: M77, 50X, FIRST OF LINE 4)", "(LOST: MESSAGE, 50X, FIRST OF LINE 5)",
                 "(LOST: PROBING MOVE, 1X, FIRST OF LINE 8)"], "head")
    box.write("bad.nc", "O1\n#1=1/0\nM30\n")
    alarm(box.kerf("run", "bad.nc", "--post", "p.nc", "--summary", "s.json"), "PS0112", 2)
    equal(box.json("s.json")["post"], None, "of a program that was not posted")


@test("no comment of a posted program holds a character that a control takes for a command")
def harmless_comments(box):
    box.write("stop! now~ 100%; [really?].nc", "G21G90G1X1.F100\n#3006=1(ARE YOU SURE? 100%! ~ ;)\nM30\n")
    posted(box, "stop! now~ 100%; [really?].nc")
    comments = [line[1:-1] for line in box.read("post.nc").decode().splitlines() if line.startswith("(")]
    check(any("STOP_ NOW_ 100__ _REALLY__.NC" in text for text in comments), str(comments))
    check(any("ARE YOU SURE_ 100__ _ _" in text for text in comments), str(comments))
    check(not re.search(r"[!~%;?()\[\]#]", "".join(comments)), str(comments))


@test("a posted program of any length takes the same memory, and its travel is that of all of it")
def long_program(box):
    peaks = []
    for count in (10_000, 400_000):
        box.write("long.nc", "O1\nG21G90G0X0Y0\n#1=0\nF900.\n" +
                  f"WHILE[#1LT{count}]DO1\nG1X[#1/1000]Y[#1-FIX[#1/2]*2]\n#1=#1+1\nEND1\nG0Z9.\nM30\n")
        result = box.kerf("run", "long.nc", "--post", "post.nc", peak=True)
        status(result, 0)
        peaks.append(result.peak_kib)
    text = box.read("post.nc").decode()
    check("(TRAVEL: X 0. TO 399.999)" in text and "(TRAVEL: Z 0. TO 9.)" in text, text[:600])
    equal(text.count("\nG0 Z9.\nG0 X0. Y0.\nG0 Z0.\n"), 1, "positions")
    check(text.count("Y") > 399_000, "lines")
    equal(box.files(), ["long.nc", "post.nc"], "files behind it")
    if harness.MEASURES_MEMORY:
        check(peaks[1] < peaks[0] + 2048, f"{peaks[1]} KiB for 400,000 blocks, {peaks[0]} for 10,000")


@test("a posted program for which the disk has no room is told, however long it is")
def no_room(box):
    box.write("long.nc", "O1\nG21G90F900.\n#1=0\nWHILE[#1LT60000]DO1\nG1X[#1/1000]\n#1=#1+1\nEND1\nM30\n")
    result = box.kerf("run", "long.nc", "--post", "/dev/full")
    status(result, 3)
    check("No space left" in result.err, result.err)
