"""kerf run --post --flavour: each flavour says what its controls take, and read again it cuts the same."""

import random
import re

from harness import check, contains, equal, refused, status, test
from reader_tests import ROOT, example_inputs
from posted_path import KERF_MM, RS274_MM, Comparison, Rs274, of_records

FLAVOURS = ("plain", "grbl", "linuxcnc", "fanuc")
TOOLS = "[[tool]]\nnumber = 1\nlength = 80\n[[tool]]\nnumber = 2\nlength = 50.5\n"
TWO_TOOLS = """O2
G21G90G17G94
T1M06
M03S1000
M08
G43H1G00X0Y0Z5.
G01Z-1.F100
G18G02X20.Z-1.R12.
G04P250
G17G00Z50.
T2M06
G00X50.
G43H2Z5.
G01Z-1.F200
G03X60.Y10.I5.J5.
G00Z50.
M30
"""
BURNS = ("O3\nG21G90G17G94\nM04S600\nG00X5.Y0\nG01X20.F600\nG02X30.Y10.I0J10.\nM03S300\nG00X50.Y50.\nG01X60.\n"
         "G00X0Y0\nG01\nG04P500\nM05\nG00X3.\nM07\nG01X9.\nM09\nM30\n")


def post(box, name, flavour, *words):
    status(box.kerf("run", name, "--post", "post.nc", "--flavour", flavour, "--summary", "s.json", *words), 0)
    return box.read("post.nc").decode().splitlines()


def blocks(lines):
    return [line for line in lines if not line.startswith("(")]


def write_two_tools(box):
    box.write("tools.toml", TOOLS)
    box.write("two.nc", TWO_TOOLS)
    return "two.nc", "--tools", "tools.toml", "--machine", "mill3"


WANTED = {
    "plain": ["G21 G90 G94 G17", "M5", "T1 M6", "G0 Z130.", "G0 X0. Y0.", "G0 Z85.", "M3 S1000", "M8", "G1 Z79. F100.", "G18",
              "G2 X20. K6.6332 I10. F100.", "G4 P0.25", "G0 Z130.", "T2 M6", "M3 S1000", "X50.", "Z55.5", "G1 Z49.5 F200.",
              "G17", "G3 X60. Y10. I5. J5. F200.", "G0 Z100.5", "M5", "M30"],
    "grbl": ["G21 G90 G94 G17 G40 G49", "M5", "M0 (TOOL 1)", "G0 Z50.", "G0 X0. Y0.", "G0 Z5.", "M3 S1000", "M8", "G1 Z-1. F100.",
             "G18", "G2 X20. K6.6332 I10. F100.", "G4 P0.25", "G0 Z50.", "M5", "M0 (TOOL 2)", "M3 S1000", "X50.",
             "G43.1 Z-29.5", "Z5.", "G1 Z-1. F200.", "G17", "G3 X60. Y10. I5. J5. F200.", "G0 Z50.", "M5 M9 M2"],
    "linuxcnc": ["G21 G90 G94 G17 G40 G49 G80 G64 P0.01", "M5", "T1 M6", "G43 H1", "G0 Z50.", "G0 X0. Y0.", "G0 Z5.",
                 "M3 S1000", "M8", "G1 Z-1. F100.", "G18", "G2 X20. K6.6332 I10. F100.", "G4 P0.25", "G0 Z50.", "T2 M6",
                 "M3 S1000", "X50.", "G43 H2", "Z5.", "G1 Z-1. F200.", "G17", "G3 X60. Y10. I5. J5. F200.", "G0 Z50.", "M5", "M2"],
    "fanuc": ["%", "O0002 (O0002)", "G21 G90 G94 G17 G40 G49 G80", "M05", "T1 M06", "G00 G43 H1 Z50.", "G00 X0. Y0.",
              "G00 Z5.", "M03 S1000", "M08", "G01 Z-1. F100.", "G18", "G02 X20. K6.6332 I10. F100.", "G04 P250", "G00 Z50.",
              "T2 M06", "M03 S1000", "X50.", "G43 H2 Z5.", "G01 Z-1. F200.", "G17", "G03 X60. Y10. I5. J5. F200.", "G00 Z50.",
              "M05", "M30", "%"],
}


@test("each flavour has its own first block, tool lengths, dwells and end")
def words_of_flavours(box):
    words = write_two_tools(box)
    for flavour in FLAVOURS:
        lines = post(box, words[0], flavour, *words[1:])
        equal(blocks(lines), WANTED[flavour], flavour)
        equal(box.json("s.json")["post"]["lost"], [], flavour)
        check(any(line.startswith("(FOR ") and flavour.upper()[:5] in line for line in lines), f"no {flavour} in the head")
        check(any(line.startswith("(TRAVEL: Z ") for line in lines), f"no travel in the head of {flavour}")
    status(box.kerf("run", *words, "--post", "none.nc"), 0)
    equal(box.read("none.nc").decode().splitlines(), post(box, words[0], "plain", *words[1:]), "without a flavour")


def beam(lines):
    return [re.sub(r" F\S+", "", line) for line in blocks(lines) if re.match(r"[MS]0?[0-9]|G0?4 |G0?1( F|$)", line)]


@test("a beam that follows its speed, a burn and air are what each flavour has for them")
def beams(box):
    box.write("burn.nc", BURNS)
    wanted = {"plain": ["M5", "M4 S600", "M3 S300", "M5", "M3 S300", "M5", "M3 S300", "G1", "G4 P0.5", "M5", "M7", "M9", "M30"],
              "linuxcnc": ["M5", "M3 S600", "M3 S300", "M5", "M3 S300", "M5", "M3 S300", "G1", "G4 P0.5", "M5", "M7", "M9", "M2"]}
    wanted["grbl"] = [*wanted["plain"][:-1], "M5 M9 M2"]
    wanted["fanuc"] = [re.sub(r"\b([GM])(\d)\b", r"\g<1>0\2", block).replace("P0.5", "P500") for block in wanted["linuxcnc"]]
    wanted["fanuc"][-1] = "M30"
    for flavour in FLAVOURS:
        lines = post(box, "burn.nc", flavour, "--machine", "laser3")
        equal(beam(lines), wanted[flavour], flavour)
        lost = box.json("s.json")["post"]["lost"]
        if flavour in ("plain", "grbl"):
            equal(lost, [], flavour)
        else:
            equal(lost, [{"what": "power that follows the speed", "count": 1, "line": 5}], flavour)
            check("(LINE 5: POWER FOLLOWS THE SPEED)" in lines, f"{flavour}: {lines}")


@test("axes that a flavour lacks are lost, told at their line, unless --axes names them")
def axes(box):
    box.write("a.nc", "O1\nG21G90G00X0Y0Z5.A10.\nG01X5.A20.F100\nA30.\nM30\n")
    lines = post(box, "a.nc", "grbl", "--machine", "mill4")
    check(not any("A" in block for block in blocks(lines)), f"A is written: {lines}")
    equal(box.json("s.json")["post"]["lost"], [{"what": "axis A", "count": 3, "line": 2}], "lost")
    check("(LINE 3: AXIS A TO 20.)" in lines and "(LOST: AXIS A, 3X, FIRST OF LINE 2)" in lines, str(lines))
    lines = post(box, "a.nc", "grbl", "--machine", "mill4", "--axes", "A")
    equal(blocks(lines)[2:-1], ["G0 Z5.", "G0 A10.", "G0 X0. Y0.", "G1 X5. A20. F100.", "A30."], "with --axes A")
    equal(box.json("s.json")["post"]["lost"], [], "with --axes A")
    refused(box.kerf("run", "a.nc", "--machine", "mill4", "--post", "p.nc", "--axes", "C"), 2, "--axes C", "mill4")


@test("--post-strict ends with 1 where something is lost, and writes nothing then but the summary")
def strict(box):
    box.write("m.nc", "O1\nG21G90G01X5.F100\nM77\nM30\n")
    box.write("good.nc", "O1\nG21G90G01X5.F100\nM30\n")
    status(box.kerf("run", "good.nc", "--post", "p.nc", "--post-strict"), 0)
    check("p.nc" in box.files(), "a program that has lost nothing is not written")
    result = box.kerf("run", "m.nc", "--post", "q.nc", "--post-strict", "--summary", "s.json", "--motion", "m.jsonl")
    status(result, 1)
    check("q.nc" not in box.files() and "m.jsonl" in box.files(), str(box.files()))
    equal(box.json("s.json")["post"]["lost"], [{"what": "M77", "count": 1, "line": 3}], "lost")
    contains(result.err, "is in 1 comment", "standard error")
    status(box.kerf("run", "m.nc", "--post", "q.nc", "--post-strict", "--keep-partial"), 1)
    check("(LINE 3: M77)" in box.read("q.nc").decode(), "with --keep-partial")


@test("--flavour, --axes, --post-tools and --post-strict are refused where they mean nothing")
def refusals(box):
    box.write("p.nc", "O1\nM30\n")
    refused(box.kerf("run", "p.nc", "--post", "q.nc", "--flavour", "siemens"), 2, "siemens", "plain, grbl, linuxcnc, fanuc")
    for words in (("--flavour", "grbl"), ("--axes", "A"), ("--post-tools", "t.tbl"), ("--post-strict",)):
        refused(box.kerf("run", "p.nc", *words), 2, words[0], "--post FILE")
    for flavour in ("plain", "grbl"):
        refused(box.kerf("run", "p.nc", "--post", "q.nc", "--flavour", flavour, "--post-tools", "t.tbl"), 2, flavour)
    for flavour in ("grbl", "linuxcnc"):
        refused(box.kerf("run", "p.nc", "--machine", "lathe2", "--post", "q.nc", "--flavour", flavour), 2, "lathe2", "fanuc")
    equal(box.files(), ["p.nc"], "files")


@test("comments of posted programs have lines of 80 bytes at most, as GRBL reads them")
def short_lines(box):
    box.write("m.nc", "O1\nG21G90G01X5.F100\n" + "\n" * 99_990 + "#3006=1(" + "LONG " * 19 + ")\nM30\n")
    lines = post(box, "m.nc", "grbl")
    check(70 < max(map(len, lines)) <= 80 and all(line.endswith(")") for line in lines if line.startswith("(")), str(lines))


def for_kerf(flavour, text):
    """Without the words that FANUC mills have not: lengths of G43.1, a tolerance, dwells in seconds, three M codes a block."""
    if flavour == "fanuc":
        return re.sub(r"^%\n(O.*\n)?", "", text, flags=re.MULTILINE)
    text = re.sub(r"^G43\.1 Z(\S+)", r"G10 L10 P90 R\1\nG43 H90", text, flags=re.MULTILINE)
    text = re.sub(r" G64 P\S+| G61", "", text)
    text = re.sub(r"^G4 P", "G4 X", text, flags=re.MULTILINE)
    return text.replace("M5 M9 M2", "M5\nM9\nM2")


def begin(rng, machine):
    place = {axis: round(rng.uniform(-45, 45), 3) for axis in ("XYZ" if machine != "mill4" else "XYZA")}
    left = rng.choice(("G18 F1.", "G19 G91", "G20", "G93", ""))
    return "G21 G90 G17 G94\nM3 S777\nG0 " + " ".join(f"{a}{v}" for a, v in place.items()) + f"\n{left}\n"


CASES = {"two tools": ("mill3", TWO_TOOLS), "a beam that burns": ("laser3", BURNS),
         "a rotary axis": ("mill4", "O1\nG21G90G94G00X0Y0Z5.A10.\nM03S900\nG01Z-1.F100\nX5.A20.\nG02X15.Y10.R10.\nG00Z5.\nM30\n")}


@test("Kerf reads every flavour back to the same cuts, wherever the machine stands before")
def round_trips(box):
    box.write("tools.toml", TOOLS)
    rng = random.Random(8)
    for what, (machine, program) in CASES.items():
        box.write("part.nc", program)
        laser = machine == "laser3"
        more = ["--machine", machine, "--tools", "tools.toml"]
        for flavour in FLAVOURS:
            status(box.kerf("run", "part.nc", *more, "--motion", "run.jsonl", "--post", "post.nc", "--flavour", flavour,
                            "--axes", "A" if machine == "mill4" else "X"), 0)
            lengths = length_in_plain(program) if flavour == "plain" else lambda record: 0
            run = of_records(box.motions("run.jsonl"), lengths, laser)
            if flavour in ("linuxcnc", "fanuc"):
                run = [{**move, "s": abs(move["s"])} for move in run]
            for _ in range(10):
                box.write("again.nc", begin(rng, machine) + for_kerf(flavour, box.read("post.nc").decode()))
                status(box.kerf("run", "again.nc", *more, "--motion", "again.jsonl", "--dialect", "fanuc-mill",
                                "--decimal-point", "increment"), 0)
                moves = of_records(box.motions("again.jsonl"), laser=laser)[1:]
                Comparison(run, moves, laser, KERF_MM)


def length_in_plain(program):
    """What a plain program adds to Z from each line on: of the length that is in force in it."""
    lengths, now = [0], 0
    for line in program.splitlines():
        h = re.search(r"G43H(\d)", line)
        now = {"1": 80, "2": 50.5}[h[1]] if h else now
        lengths.append(now)
    return lambda record: lengths[record["line"]]


@test("a fanuc program with its own punch-out of G10 runs as it stands")
def punch_out(box):
    words = write_two_tools(box)
    status(box.kerf("run", *words, "--post", "post.nc", "--flavour", "fanuc", "--post-tools", "t.g10", "--motion", "run.jsonl",
                    "--pulses", "run.csv"), 0)
    equal(box.read("t.g10").decode(), "%\nG10 L10 P1 R80.\nG10 L10 P2 R50.5\n%\n", "punch-out")
    status(box.kerf("run", "post.nc", "--offsets", "t.g10", "--machine", "mill3", "--motion", "again.jsonl"), 0)
    wanted = of_records(box.motions("run.jsonl"))
    Comparison(wanted, of_records(box.motions("again.jsonl")), False, KERF_MM)


def linuxcnc_reads(box, words, cwd=None):
    """rs274 with the table of tools of the program: Z is that of the tip, so nothing is added."""
    result = box.kerf(*words, "--post", box.path("post.nc"), "--flavour", "linuxcnc", "--post-tools", box.path("tools.tbl"),
                      "--motion", box.path("motion.json"), "--summary", box.path("summary.json"), cwd=cwd)
    if result.status == 1:  # by intention: the example shows an alarm
        check("post.nc" not in box.files(), "a run that ended in an alarm was posted")
        return
    status(result, 0)
    laser = box.json("summary.json")["machine"].startswith("laser")
    run = [{**move, "s": abs(move["s"]) if laser else move["s"]} for move in of_records(box.motions("motion.json"), laser=laser)]
    Comparison(run, Rs274(box.folder, "post.nc", laser, table="tools.tbl").moves, laser, RS274_MM)


@test("rs274 reads a linuxcnc program of two tools and its table as Kerf ran it")
def linuxcnc_tools(box):
    words = write_two_tools(box)
    linuxcnc_reads(box, ("run", *words))
    equal(box.read("tools.tbl").decode(), "T1 P1 Z80.\nT2 P2 Z50.5\n", "table")


LATHES = ("18_shaft", "19_bush", "20_pawn", "21_bolt_flange", "22_bushes")
for path in sorted(ROOT.glob("examples/*/command")):
    inputs = example_inputs(path)
    if inputs and path.parent.name not in LATHES:
        test(f"rs274 reads the linuxcnc program of example {path.parent.name} as Kerf ran it")(
            lambda box, words=inputs: linuxcnc_reads(box, words, cwd=ROOT))


@test("kerf pattern replay writes every flavour")
def patterns(box):
    box.write("w.pat", bytes.fromhex("7F00C83F0FA0400CA7FF00C8"))
    for flavour in FLAVOURS:
        status(box.kerf("pattern", "replay", "w.pat", "--post", "p.nc", "--flavour", flavour, "--axes", "C"), 0)
        check(blocks(box.read("p.nc").decode().splitlines())[-1] in (WANTED[flavour][-1]), flavour)
    status(box.kerf("pattern", "replay", "w.pat", "--post", "q.nc", "--flavour", "fanuc", "--post-tools", "t", "--post-strict"), 0)


@test("a lathe's program for fanuc has its tape and codes of two digits, and runs to the same moves")
def lathe(box):
    box.write("l.nc", "O5\nT0101\nG98\nG97S500M03\nG00X40.Z2.\nG01Z-5.F200\nG02X60.Z-15.I0K-10.\nG04X0.5\nG00X80.\nM05\nM30\n")
    lines = post(box, "l.nc", "fanuc", "--machine", "lathe2", "--motion", "run.jsonl")
    equal((lines[:2], lines[-2:]), (["%", "O0005 (O0005)"], ["M30", "%"]), "tape")
    check("G21 G18 G40 G80 G97 G98" in lines and "G04 X0.5" in lines and not re.search(r"\b[GM]\d\b", "\n".join(blocks(lines))), lines)
    status(box.kerf("run", "post.nc", "--machine", "lathe2", "--motion", "again.jsonl"), 0)
    cuts = lambda name: [(r["kind"], r["to"]) for r in box.motions(name) if r["kind"] in ("line", "arc")]
    equal(cuts("again.jsonl"), cuts("run.jsonl"), "cuts")
