"""--post: the posted program, run again, makes the same path."""

import re

from harness import check, equal, near, status, test

TOLERANCE = 1e-3
HEAD = "O1\nG21G90G17G94\n"

PROGRAMS = {
    "lines and rapids": HEAD + "G00X10.Y20.Z5.\nG01Z-1.F100\nX30.F250.5\nG91Y-.125\nG90G00Z5.\nM30\n",
    "arcs by R in all planes": HEAD + "F300\nG00X10.Y10.Z10.\nG17G02X20.Y20.R10.\nG03X10.Y10.R-10.\n"
        "G18G02X20.Z20.R12.\nG03X10.Z10.R-15.\nG19G03Y20.Z20.R10.\nG02Y10.Z10.R20.\nM30\n",
    "arcs by I, J, K in all planes": HEAD + "F300\nG00X10.Y10.Z10.\nG02X20.I5.\nG03X10.I-5.\n"
        "G18G02X20.I5.\nG03X10.I-5.\nG19G02Z20.K5.\nG03Z10.K-5.\nM30\n",
    "full circles and helices": HEAD + "F300\nG00X10.\nG02I5.\nG03J-7.5\nG02I5.Z-3.\nG03X20.I5.Z-4.\n"
        "G18G02K3.\nG03K3.Y2.\nG19G03J2.X5.\nM30\n",
    "arcs whose centre is no decimal": HEAD + "F300\nG00X0Y0\n#1=0\nWHILE[#1LT40]DO1\n"
        "G02X[#1*1.7]Y[#1*0.3+1]R[20+#1]\nG03X[#1*1.1]Y[#1*0.7]R-[30+#1/3]\n#1=#1+1\nEND1\nM30\n",
    "canned cycles": HEAD + "G00Z50.\nG98G81X10.Y10.Z-5.R2.F100\nX20.\nG99X30.\nG82X10.Y20.P500Z-6.\n"
        "G83X5.Y5.Z-10.R2.Q4.\nG73X6.Z-10.Q3.\nG98G85X1.Z-3.R1.\nG86X2.\nG89X3.P250\nG76X4.Q1.\n"
        "G80G00X0\nM30\n",
    "tapping and back boring": HEAD + "S500M03\nG00Z50.\nG84X10.Z-5.R2.F100P100\nG74X20.\n"
        "G87X30.Z-10.R-20.Q2.\nG88X40.Z-2.R1.\nG80\nM30\n",
    "rows of holes": HEAD + "G00Z10.\nG91G99G81X10.Z-12.R-8.K3F100\nY10.L2\nG80G90\nM30\n",
    "a macro with a loop": HEAD + "G65P9207X0Y0R25.A30.H7.Z-3.\nG65P9207X5.Y5.R10.H3.Z-1.\nM30\n"
        "O9207\n#31=1\nG00X#24Y#25Z5.\nWHILE[#31LE#11]DO1\n"
        "G00X[#24+#18*COS[#1+[#31-1]*360/#11]]Y[#25+#18*SIN[#1+[#31-1]*360/#11]]\nG01Z#26F200\n"
        "G00Z5.\n#31=#31+1\nEND1\nM99\n",
    "subprograms and modal calls": HEAD + "G00Z5.\nM98P51002\nG66P1003A2.\nX1.\nX2.\nG67\nM30\n"
        "O1002\nG91G00X1.5Y.25\nG90M99\nO1003\nG01Z-#1F100\nG00Z5.\nM99\n",
    "work offsets and shifts": HEAD + "G10L2P1X100.Y50.Z-20.\nG10L2P2X-3.333\nG54G00X0Y0Z0\nG55X1.\n"
        "G52X5.Y5.\nG01X0Y0F100\nG52X0Y0\nG92X0Y0\nG01X10.\nG53X0Y0\nG28Z0\nM30\n",
    "tool length": HEAD + "G10L10P1R50.\nT1M06\nG43H1G00Z100.\nG01Z-1.F100\nG49G00Z100.\nM30\n",
    "cutter compensation": HEAD + "G10L12P1R5.\nG00X-20.Y-10.\nG41D1G01X0Y0F200\nY50.\nX50.\n"
        "G02X70.Y30.R20.\nG03X90.Y10.R20.\nG01Y0\nX0\nG40X-20.Y-10.\nM30\n",
    "rounded corners of the compensation": HEAD + "G10L12P1R4.\nG00X-20.Y-10.\nG41D1G01X0Y0F200\n"
        "X20.Y40.\nX40.Y0\nX0\nG40X-20.Y-10.\nM30\n",
    "rotation, scaling and mirror": HEAD + "F200\nG68X10.Y5.R33.3\nG01X20.Y7.\nG02X30.R9.\nG69\n"
        "G51X0Y0Z0P2500\nG01X3.Y4.Z-1.\nG03X5.Y6.R4.\nG50\nG51.1X50.\nG01X40.Y10.\nG02X45.Y12.R8.\n"
        "G50.1X0\nG51X1.Y2.I2000J-2000K1000\nG01X3.Y4.\nG03X7.Y8.R9.\nG50\nM30\n",
    "polar coordinates": HEAD + "G16\nG00X50.Y0\nG81X50.Y30.Z-5.R2.F200\nY60.\nY90.\nG80\nG15\nM30\n",
    "an inch program": "O1\nG20G90G17G94\nG00X1.Y2.Z.5\nG01Z-.125F10.\nG02X2.Y3.R1.5\nG03X1.5I-.25\n"
        "G81X.1Y.2Z-.3R.1F5.\nG80\nM30\n",
    "feed per revolution and inverse time": HEAD + "S600M03\nG95G01X10.F.1\nY5.\nG93G01X20.F4.\n"
        "G02X30.R8.F3.\nG94G01X0F100\nM30\n",
    "probing": HEAD + "G31X10.F50\nG31Z-5.\nG01X0\nM30\n",
    "spindle, tool, coolant, dwell and stop": HEAD + "T7M06\nM03S1200.\nM08\nG04P1500\nG04X.25\nM00\n"
        "M04S800\nM07\nM05M09\nM30\n".replace("S1200.", "S1200"),
    "single precision traps": HEAD + "G00X123456.789Y-99999.999\nG01X-0.001Y0.0005F0.5\nX.0004\nM30\n",
}


def again(post):
    """What the control reads in place of the posted program: its P of G4 counts seconds."""
    return re.sub(r"^G4 P(\S+)$", lambda m: f"G4 X{float(m[1]):f}", post, flags=re.MULTILINE)


def path_of(records):
    """What moves: kind and numbers. A probing move is posted as a line."""
    for record in records:
        if "to" in record:
            kind = "line" if record["kind"] == "probe" else record["kind"]
            yield {**record, "kind": kind}


def differs(a, b):
    return any(abs(a[key] - b[key]) > TOLERANCE for key in a)


def compare(first, second):
    one, two = list(path_of(first)), list(path_of(second))
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
    """Everything else that the posted program must do as well, in order."""
    for record in records:
        kind = record["kind"]
        if kind == "spindle" and record["direction"] != "orient":
            yield kind, record["direction"], record["speed"] * (record["direction"] != "stop")
        elif kind in ("tool", "coolant", "stop", "end"):
            yield kind, record.get("tool"), record.get("state")
        elif kind == "dwell":
            yield kind, round(record["seconds"], 6), None


def post_and_run(box, program, *words):
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--post", "post.nc", "--motion", "first.json", *words), 0)
    box.write("again.nc", again(box.read("post.nc").decode()))
    result = box.kerf("run", "again.nc", "--decimal-point", "calculator", "--motion", "again.json",
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


@test("the posted program of a four-axis part turns the same way")
def four_axes(box):
    first, second = post_and_run(box, HEAD + "G00X10.A90.\nG01A180.F500\nX20.A-45.5\nM30\n",
                                 "--machine", "mill4")
    compare(first, second)


def swept(records):
    """Length of all arcs, from their own records."""
    import math
    at, total = None, 0
    for record in records:
        if record["kind"] == "arc":
            u, v = record["center"]
            a = math.atan2(at["Y"] - v, at["X"] - u)
            b = math.atan2(record["to"]["Y"] - v, record["to"]["X"] - u)
            turn = (b - a) if record["direction"] == "ccw" else (a - b)
            same = (at["X"], at["Y"]) == (record["to"]["X"], record["to"]["Y"])
            turn = 2 * math.pi if same else turn % (2 * math.pi)
            total += turn * math.hypot(at["X"] - u, at["Y"] - v)
        at = record.get("to", at)
    return total


@test("a posted arc that is shorter than a digit of the output does not become a full circle")
def tiny_arc(box):
    first, second = post_and_run(
        box, HEAD + "G00X10.Y0\nG51X0Y0P10\nG01X10.Y0F100\nG03X10.Y.001I-10.J0\nG50\nM30\n")
    near(swept(second), swept(first), TOLERANCE, "length of all arcs")


@test("a posted program posts itself, once its numbers are those of the control")
def itself(box):
    for name, program in PROGRAMS.items():
        box.write("part.nc", program)
        posted = "part.nc"
        for generation in ("one", "two", "three"):
            words = ["--decimal-point", "calculator"] if generation != "one" else []
            status(box.kerf("run", posted, "--post", generation, *words), 0)
            posted = box.write(generation + ".nc", again(box.read(generation).decode()))
        check(box.read("two") == box.read("three"), f"the post of the post of {name} differs")
