"""--post of a lathe: the posted program, run again on the same lathe, makes the same moves."""

import random
import re

from harness import check, contains, equal, near, status, test

# The control reads three decimals; a centre is the sum of two numbers, as a diameter of four.
PLACE_MM, CENTRE_MM = 6e-4, 2.5e-3
OFFSETS = "G10P10001X4.Z-3.R.8Q3\nG10P10002X-2.Z1.5R.4Q3\nG10P10003X0Z0R.4Q2\n"
HEAD = "O1\n"

SHAFT = """T0101
G50S2500
G96S200M03
G00X64.Z2.
G01Z0F.2
X-1.6
G00X62.Z2.
G71U2.R.5
G71P100Q200U.4W.1F.25
N100G00X18.
G01Z0F.1
X24.Z-3.
Z-30.
X30.
G03X36.Z-33.R3.
G01Z-50.
G02X44.Z-54.R4.
G01X52.
X56.Z-56.
N200X62.
G00X100.Z50.
T0202
G42G00X62.Z2.
G70P100Q200
G40G00X100.Z50.
"""
PROGRAMS = {
    "roughing, finishing and the nose": ("lathe2", SHAFT),
    "threads": ("lathe2", "T0101\nG97S600M03\nG00X30.Z6.\nG76P020060Q100R.05\nG76X21.4Z-27.P1300Q400F2.\n"
                          "G00Z5.\nG32X22.Z-10.F1.5Q90000\nZ-20.\nG00X40.\nZ5.\nG34Z-30.F2.K.05\n"
                          "G98G01X44.F100\nM05\n"),
    "pecks and single cycles": ("lathe2", "T0202\nG97S500M04\nM08\nG00X50.Z2.\nG74R1.\nG74Z-20.Q5000F.1\n"
                                          "G90X46.Z-20.F.2\nX42.R-2.\nG00X60.\nG94X20.Z-1.F.15\nG00X70.\n"
                                          "G75R.5\nG75X50.Z-10.P3000Q2000F.1\nG04X1.5\nM09\n"),
    "arcs by their centre and by their radius": (
        "lathe2", "T0101\nG98\nG00X40.Z0\nG02X60.Z-10.I0K-10.F200\nG03X40.Z-20.I-10.K0\nG02X40.Z-30.R8.\n"
                  "G03X41.Z-31.R-5.\n"),
    "a bore, and offsets that change without the turret": (
        "lathe2", "T0303\nG97S700M03\nG00X10.Z2.\nG01Z-20.F.2\nG00X8.\nZ2.\nT0301\nG00X12.Z2.\nG01Z-10.F.1\n"
                  "T0300\nG00Z30.\n"),
    "the face and the mantle": (
        "lathe3c", "T0101\nG98\nG00X60.Z5.C0\nG01Z-2.F100\nG12.1\nG42G01X40.C0F200\nC10.\nG03X20.C20.R10.\nG01X-40.\n"
                   "G40X60.C0\nG13.1\nG00X80.Z5.\nG07.1C30.\nG01Z-10.C20.F150\nG02Z-30.C60.R25.\nG01Z-40.\nG07.1C0\n"
                   "G00X90.C370.\nG83X60.C45.Z-15.R-3.Q5000F100\nC90.\nG80\n"),
}


def moves(box, name):
    return [record for record in box.motions(name) if "to" in record]


def close(values, wanted, tolerance, what):
    for value, want in zip(values, wanted):
        near(value, want, tolerance, what)


def same(run, again, what):
    check(len(again) >= len(run), f"{what}: {len(again)} moves, wanted {len(run)}")
    first, *_ = again
    check(first["kind"] == "rapid", f"{what}: it does not begin with a rapid")
    for n, (got, want) in enumerate(zip(again[len(again) - len(run):], run)):
        where = f"{what}, move {n} of line {want['line']}"
        equal(got["kind"], want["kind"], where)
        for axis, value in want["to"].items():
            near(got["to"][axis], value, PLACE_MM, f"{where}: {axis}")
        for key in ("feed_mode", "direction", "plane", "turns"):
            equal(got.get(key), want.get(key), f"{where}: {key}")
        for key in ("feed", "lead", "lead_change", "angle_deg"):
            near(got.get(key, 0), want.get(key, 0), 1e-4, f"{where}: {key}")
        if "center" in want:
            close(got["center"], want["center"], CENTRE_MM, f"{where}: its centre")


def spindle_at_cuts(records):
    """How the spindle turns in each cut."""
    now, found = None, []
    for record in records:
        if record["kind"] == "spindle":
            turns = record["direction"] in ("cw", "ccw")
            now = {key: record.get(key) for key in ("direction", "speed", "mode", "max_rpm")} if turns else None
        elif record["kind"] in ("line", "arc", "thread"):
            found.append(now)
    return found


def again(box, machine, text, what, beginning=""):
    """Posts a program and runs what was posted, with the same offsets."""
    box.write("part.nc", HEAD + OFFSETS + text + "M30\n")
    status(box.kerf("run", "part.nc", "--machine", machine, "--motion", "run.jsonl", "--post", "post.nc"), 0)
    posted = box.read("post.nc").decode()
    box.write("again.nc", HEAD + OFFSETS + beginning + posted)
    status(box.kerf("run", "again.nc", "--machine", machine, "--motion", "again.jsonl"), 0)
    run, read = moves(box, "run.jsonl"), moves(box, "again.jsonl")
    same(run, read[1 if beginning else 0:], what)
    equal(spindle_at_cuts(box.motions("again.jsonl")), spindle_at_cuts(box.motions("run.jsonl")),
          f"{what}: the spindle in the cuts")
    return posted


@test("a posted lathe program makes the same moves: cycles, threads, noses, offsets, face and mantle")
def round_trips(box):
    for what, (machine, text) in PROGRAMS.items():
        again(box, machine, text, what)


@test("a posted lathe program does so wherever the machine stands, and begins with X outwards")
def from_anywhere(box):
    for what, (machine, text) in PROGRAMS.items():
        posted = again(box, machine, text, what, "G21G97G40\nG00X12.Z-34.\n")
        blocks = [line for line in posted.splitlines() if not line.startswith(("(", "T"))]
        equal(blocks[:2], ["G21 G18 G40 G97 G98", "M5"], f"{what}: the head")
        check(re.fullmatch(r"G0 X[\d.]+", blocks[2]) and re.fullmatch(r"G0 Z[\d.]+", blocks[3]),
              f"{what}: it goes {blocks[2:4]}")


@test("a posted lathe program has no macros, cycles, work offsets or nose compensation, numbers of four decimals")
def plain(box):
    for what, (machine, text) in PROGRAMS.items():
        posted = again(box, machine, text, what)
        blocks = " ".join(line for line in posted.splitlines() if not line.startswith("("))
        check(not re.search(r"#|G(10|41|42|5[2-9]|7[0-6]|8\d|9[024])\b|U-?\d|W-?\d", blocks), f"{what}: {blocks[:300]}")
        decimals = re.findall(r"[A-Z]-?\d*\.(\d*)", blocks)
        check(decimals and max(map(len, decimals)) <= 4, f"{what}: more than four decimals")


@test("T of a posted lathe program brings the offset of the run, with the digits of the control")
def tools(box):
    text = "T0102\nG00X40.Z2.\nT0101\nG00X41.\nM30\n"
    box.write("part.nc", HEAD + text)
    status(box.kerf("run", "part.nc", "--machine", "lathe2", "--post", "post.nc"), 0)
    equal(re.findall(r"^T\d+", box.read("post.nc").decode(), re.MULTILINE), ["T0102", "T0101"], "T")
    box.write("part.nc", HEAD + text.replace("T01", "T010"))
    status(box.kerf("run", "part.nc", "--machine", "lathe2", "--post", "post.nc", "--param", "T_digits=3"), 0)
    equal(re.findall(r"^T\d+", box.read("post.nc").decode(), re.MULTILINE), ["T01002", "T01001"], "T")


@test("what a posted lathe program cannot say is a comment, and stands in the summary")
def lost(box):
    box.write("part.nc", HEAD + "G00X40.Z2.\nM77\n#3006=1(LOOK)\nM30\n")
    result = box.kerf("run", "part.nc", "--machine", "lathe2", "--post", "post.nc", "--summary", "s.json")
    status(result, 0)
    posted = box.read("post.nc").decode()
    contains(posted, "(LINE 3: M77)", "the comment")
    contains(posted, "(LOST: M77, 1X, FIRST OF LINE 3)", "the head")
    equal([thing["what"] for thing in box.json("s.json")["post"]["lost"]], ["M77", "message"], "the summary")


class Turner:
    """A random program of a lathe, with noses, offsets, feeds and spindle modes."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.lines = []
        self.x, self.z = 60.0, 5.0
        self.tool()
        self.lines.append(f"G00X{self.x:.3f}Z{self.z:.3f}")
        for _ in range(self.random.randint(5, 25)):
            self.random.choice((self.line, self.line, self.arc, self.rapid, self.thread, self.tool, self.mode))()
        self.text = "\n".join(self.lines) + "\n"

    def somewhere(self):
        self.x = round(self.random.uniform(10, 90), self.random.choice((0, 1, 3)))
        self.z = round(self.random.uniform(-80, 5), self.random.choice((0, 1, 3)))
        return f"X{self.x:.3f}Z{self.z:.3f}"

    def tool(self):
        n = self.random.randint(1, 3)
        self.lines += [f"T0{n}0{self.random.randint(0, 3)}",
                       self.random.choice((f"G97S{self.random.randint(100, 900)}M03", f"G50S2000\nG96S{self.random.randint(50, 300)}M04")),
                       f"{self.random.choice(('G98', 'G99'))}G01F.25"]

    def mode(self):
        self.lines.append(self.random.choice(("G98G01F120.", "G99G01F.2", "M08", "M05\nM03", "G04X.5", "G97S400")))

    def line(self):
        self.lines.append(f"G01{self.somewhere()}")

    def rapid(self):
        self.lines.append(f"G00{self.somewhere()}")

    def arc(self):
        code = self.random.choice(("G02", "G03"))
        x, z = self.x / 2, self.z
        to = self.somewhere()
        chord = ((self.x / 2 - x) ** 2 + (self.z - z) ** 2) ** 0.5
        if chord > 0.1:
            self.lines.append(f"{code}{to}R{chord / 2 + self.random.uniform(0.1, 20):.3f}")

    def thread(self):
        self.lines += ["G97S300M03", f"G32Z{self.z - 12:.3f}F{self.random.choice((1, 1.5, 2.117))}", "G99G01F.25"]
        self.z -= 12


@test("random lathe programs make the same moves when they are posted and run again")
def random_programs(box):
    for seed in range(40):
        again(box, "lathe2", Turner(seed).text, f"seed {seed}")
