"""Laser BASIC from the command line: what is printed and read, how the dialect is chosen, mistakes,
limits."""

import json
import math

import harness
from harness import alarm, check, contains, equal, in_time, near, refused, status, test


SQUARE = "speed(50)\npower(60)\nmove(0,0)\nline(10,0)\nline(10,10)\nline(0,10)\nline(0,0)\n"


def run(box, text, *words, name="part.bas", stdin=b"", wanted=0, **more):
    box.write(name, text)
    result = box.kerf("run", name, *words, stdin=stdin, **more)
    status(result, wanted)
    return result


def printed(box, text, stdin=b"", wanted=0):
    """What PRINT wrote: standard output without the summary."""
    run(box, text, "--dprnt", "printed.txt", stdin=stdin, wanted=wanted)
    return box.read("printed.txt").decode()


@test("PRINT goes to standard output, or to the file of --dprnt")
def print_goes_out(box):
    result = run(box, 'print "a";1\nprint 2,3\n')
    check(result.text.startswith("a 1\n2       3\n"), f"standard output: {result.text!r}")
    equal(printed(box, 'print "a";1\nprint 2,3\n'), "a 1\n2       3\n", "the file of --dprnt")
    result = run(box, "print 1\n", "--dprnt", "printed.txt")
    check(not result.text.startswith("1\n"), "printed to both")


@test("INPUT reads a line of standard input for each number, its prompt before it")
def input_from_a_pipe(box):
    text = 'input "side",s\nprint "s=";s\ninput t\nprint s*t\n'
    equal(printed(box, text, stdin=b"12\n 2.5\t\r\n"), "sides= 12\n? 30\n", "printed")
    equal(printed(box, text, stdin=b"12\n2.5"), "sides= 12\n? 30\n", "without the last end of line")


@test("INPUT from a closed pipe or of a word ends the run in LB0025 with the beam off")
def input_of_nothing(box):
    text = "speed(10);power(50)\nline(1,0)\ninput a\nline(2,0)\n"
    for given in (b"", b"abc\n", b"\n", b"1e999\n", b"nan\n", b"\xff\x00\n", b"1 2\n"):
        result = run(box, text, "--motion", "m.jsonl", stdin=given, wanted=1)
        alarm(result, "LB0025", 3)
        kinds = [(m["kind"], m.get("percent")) for m in box.motions("m.jsonl") if m["kind"] == "power"]
        equal(kinds[-1], ("power", 0), f"the last power with {given!r}")


@test("--set gives a variable its first value by its name, in capitals or not")
def set_variables(box):
    text = "print x; long_name\ny=1\n"
    for words in (["x=1.5", "long_name=-2"], ["X=1.5", "Long_Name=-2"]):
        options = [word for item in words for word in ("--set", item)]
        check(run(box, text, *options).text.startswith("1.5 -2\n"), "printed")
    run(box, "pi=pi+1;print pi\n", "--set", "PI=3", "--summary", "s.json")
    equal(box.json("s.json")["variables"]["PI"], 4, "PI")


@test("--set of a name that the program does not have, and of a G-code variable, is refused")
def set_unknown(box):
    box.write("part.bas", "x=1\n")
    for name in ("y", "#100", "sin"):
        refused(box.kerf("run", "part.bas", "--set", f"{name}=1"), 2, name)


def summary(box, text, *words, name="part.bas", wanted=0):
    run(box, text, "--summary", "s.json", *words, name=name, wanted=wanted)
    return box.json("s.json")


@test("a program is laser BASIC by its ending, whatever it holds")
def by_ending(box):
    for name in ("part.bas", "PART.BAS", "part.Bas"):
        told = summary(box, "x=1\n", name=name)
        equal((told["dialect"], told["machine"]), ("laser-basic", "laser3"), name)
        contains(run(box, "x=1\n", name=name).err, "because of the file's ending", "the reason")


BY_TEXT = ["' a comment\nhome\n", "home\n", "\n\n  Speed(5)\n", "x=1\n", "print 1\n", "for i=1 to 2\nnext\n",
           "rem a comment\nx=1\n", "\ufeffhome\n", "let a=3\n"]


@test("a program of another ending is laser BASIC when its first line is")
def by_text(box):
    for text in BY_TEXT:
        told = summary(box, text, name="part.txt")
        equal(told["dialect"], "laser-basic", repr(text))
        contains(run(box, text, name="part.txt").err, "because of the first lines", "the reason")
    for text in ("O1\nM30\n", "G21\nM30\n", "%\nO1\nM30\n%\n", "(LINE)\nM30\n", "#1=1\nM30\n"):
        equal(summary(box, text, name="part.txt")["dialect"], "fanuc-mill", repr(text))


@test("--dialect and --machine are obeyed, and the reason names what was not asked for")
def choices(box):
    told = summary(box, SQUARE, "--dialect", "laser-basic", name="part.nc")
    equal((told["dialect"], told["machine"]), ("laser-basic", "laser3"), "by --dialect")
    contains(run(box, SQUARE, "--dialect", "laser-basic", name="part.nc").err,
             "machine laser3 because of --dialect laser-basic", "the reason")
    told = summary(box, SQUARE, "--machine", "mill3")
    equal((told["dialect"], told["machine"]), ("laser-basic", "mill3"), "by the ending on a mill")
    contains(run(box, SQUARE, "--machine", "mill3").err, "dialect laser-basic because of the file's ending",
             "the reason")
    told = summary(box, "O1\nM30\n", "--dialect", "fanuc-mill")
    equal(told["dialect"], "fanuc-mill", "against the ending")


@test("a machine file may make laser BASIC the language of its programs")
def machine_of_basic(box):
    text = box.kerf("machines", "laser3").text
    lines = ['dialect = "laser-basic"' if line.startswith("dialect") else line for line in text.splitlines()]
    box.write("mine.toml", "\n".join(lines) + "\n")
    box.write("part.txt", "100 goto 200\n200 print 5\n")
    result = box.kerf("run", "part.txt", "--machine", "mine.toml")
    status(result, 0)
    check(result.text.startswith("5\n"), result.text)


@test("the work origin is that of G54, and the travel is that of the machine")
def origin(box):
    box.write("o.toml", "[work.G54]\nX = 10\nY = -5\n[work.EXT]\nZ = 1\n")
    run(box, "home\nmove(1,2,3)\nprint xpos;ypos;zpos\n", "--offsets", "o.toml", "--motion", "m.jsonl")
    equal([[move["to"][axis] for axis in "XYZ"] for move in box.motions("m.jsonl") if move["kind"] == "rapid"],
          [[10, -5, 1], [11, -3, 4]], "targets")
    alarm(run(box, "move(341,0)\n", "--offsets", "o.toml", wanted=1), "LB0019", 1)
    run(box, "move(-360,0)\n", "--offsets", "o.toml")


@test("check lists all mistakes of a program in the order of its lines, each once")
def check_lists(box):
    text = "x=)\nif 1 print 2 else print 3\ny=$\ngoto nowhere\nz=3 4\nfor i=1 to 2\nfoo\nx=1;x=);y=)\n"
    box.write("part.bas", text)
    result = box.kerf("check", "part.bas")
    status(result, 1)
    told = [line.split() for line in (result.err + result.text).splitlines() if " error: " in line]
    wanted = [(1, "LB0003"), (2, "LB0008"), (3, "LB0026"), (4, "LB0006"), (5, "LB0001"), (6, "LB0014"),
              (7, "LB0015"), (8, "LB0003")]
    equal([(int(words[0].split(":")[1]), words[2]) for words in told], wanted, "mistakes")


@test("many mistakes are listed in time proportional to them")
def many_mistakes(box):
    box.write("part.bas", "x=)\n" * 30_000)
    result = box.kerf("check", "part.bas")
    status(result, 1)
    in_time(result, 8)


@test("a sound program passes the check; its warnings are told")
def check_passes(box):
    box.write("part.bas", SQUARE)
    status(box.kerf("check", "part.bas"), 0)
    box.write("part.bas", "print a\nspeed(120)\nline(1,0)\n")
    result = box.kerf("check", "part.bas")
    for number in ("LW0001", "LW0002", "LW0003"):
        contains(result.err + result.text, number, "the check")


@test("diagnostics as JSON hold warnings and the alarm with line and column")
def json_diagnostics(box):
    result = run(box, "print 1;a\nspeed(120)\nx=1/0\n", "--diagnostics", "json", wanted=1)
    told = [json.loads(line) for line in result.err.splitlines() if line.startswith("{")]
    got = [(item["severity"], item["code"], item["line"], item["column"]) for item in told]
    equal(sorted(got), sorted([("warning", "LW0001", 1, 9), ("warning", "LW0002", 2, 1),
                               ("error", "LB0016", 3, 4)]), "diagnostics")


@test("a program without end is stopped by the limit of statements")
def endless(box):
    for text in ("a: goto a\n", "a: x=1\nif 1 then goto a\n", "for i=1 to 2\ni=0\nnext\n",
                 "a: gosub b\ngoto a\nb: return\n", 'for i=1 to 2 step 0.5\nif 1 then i=0; next else next\n'):
        result = run(box, text, wanted=1)
        alarm(result, "LB0023")
        in_time(result, 10)
    alarm(run(box, "a: goto a\n", "--param", "statement_limit=10", wanted=1), "LB0023", 1)


@test("a recursion without end is stopped, and the calls are told")
def endless_recursion(box):
    alarm(run(box, "x=1\ns: gosub s\n", wanted=1), "LB0012", 2)


@test("the pulses of --pwm follow POWER")
def pwm(box):
    run(box, "speed(10)\npower(80)\nline(1,0)\npower(20)\nline(2,0)\nmove(3,0)\n", "--pwm", "pwm.csv")
    rows = [row.split(",") for row in box.read("pwm.csv").decode().splitlines()]
    duties = [float(row[rows[0].index("duty")]) for row in rows[1:]]
    changes = [duty for i, duty in enumerate(duties) if i == 0 or duty != duties[i - 1]]
    equal([duty for duty in changes if duty], [0.8, 0.2], "duties")
    equal(changes[-1], 0, "the last duty")


@test("a program of a million lines needs no more memory than a short one")
def long_program(box):
    box.write("part.bas", "speed(50);power(60)\nx=0\n" + "x=x+1\nif x>300 then x=0\n" * 500_000 +
              "line(x,1)\n")
    result = box.kerf("run", "part.bas", "--summary", "s.json", peak=True)
    status(result, 0)
    near(box.json("s.json")["position"]["work"]["X"], 500_000 % 301, 1e-6, "the last point")
    if harness.MEASURES_MEMORY:
        check(result.peak_kib < 100_000, f"peak memory {result.peak_kib} KiB")


@test("any bytes end in a diagnostic")
def rubbish(box):
    import random
    source = random.Random(5)
    for count in (1, 10, 1000, 100_000):
        result = run(box, bytes(source.randrange(256) for _ in range(count)) + b"$", wanted=1)
        contains(result.err, " error: LB00", "the diagnostic")
    alarm(run(box, b"\x00", wanted=1), "LB0026", 1)


@test("an empty program ends at once, one of comments too")
def empty(box):
    for text in ("' nothing\n", "\n\n", "rem", ";;;"):
        run(box, text)
    box.write("part.bas", "")
    result = box.kerf("run", "part.bas")
    check(result.status in (0, 1), f"exit status {result.status}")


@test("a line of a million brackets, signs or IFs is a mistake like another")
def deep(box):
    for text in ("x=" + "(" * 900_000, "x=" + "-" * 900_000, "x=" + "not " * 200_000, "x=" + "2^" * 400_000,
                 "x=" + "abs(" * 200_000, "if 1 then " * 90_000):
        result = run(box, text, wanted=1)
        alarm(result, "LB0001", 1)
        in_time(result, 10)


@test("a run of laser BASIC and its motions written again cut the same")
def same_motions(box):
    run(box, SQUARE, "--motion", "a.jsonl")
    run(box, SQUARE.upper().replace("\n", "\r\n"), "--motion", "b.jsonl")
    equal(box.read("a.jsonl"), box.read("b.jsonl"), "motions")


# What a sum of tenths rounds to decides neither whether an arc is a circle nor how many.
ARC_SWEEPS = [
    ("arc(38.82,8.67,1.63,433.7,793.7)", 1.63, 360),
    ("arc(38.82,8.67,1.63,-286.3+720,-286.3+720+360)", 1.63, 360),
    ("arc(-37.04,23.52,2.53,329.9+90,329.9+90+720)", 2.53, 720),
    ("arc(5,5,4,152.2,512.2)", 4, 360),
    ("arc(5,5,4,152.2,512.2-720)", 4, -360),
    ("for i=1 to 3600; a=a+0.1\nnext\narc(0,0,5,0,a)", 5, 360),
    ("arc(0,0,5,0,360.0000000001)", 5, 360),
    ("arc(0,0,5,0,359.9999999999)", 5, 360),
    ("arc(0,0,5,0,0.1+0.2-0.3)", 5, 0),
    ("arc(0,0,5,0,1e-9)", 5, 0),
    ("arc(0,0,5,0,-1e-9)", 5, 0),
    ("move(5,5e-7)\narc(0,0,5,0,1e-6)", 5, 0),
    ("move(5,-5e-7)\narc(0,0,5,0,-1e-6)", 5, 0),
    ("move(5,-5e-7)\narc(0,0,5,0,1e-6)", 5, 0),
    ("arc(0,0,5,0,0.0001)", 5, 0.0001),
    ("arc(0,0,1.1e-6,0,90)", 1.1e-6, 90),
]


@test("an arc by angles is as long as its sweep says, however its ends are rounded")
def arc_sweeps(box):
    for text, radius, sweep in ARC_SWEEPS:
        length = radius * math.radians(abs(sweep))
        made = summary(box, "power(50)\n" + text + "\nprint moved\n", "--motion", "m.jsonl")
        near(made["cut_mm"], length, 2e-6, text)
        turns = [motion["turns"] for motion in box.motions("m.jsonl") if "turns" in motion]
        equal(turns[1:], [], f"arcs of {text}")
        if abs(sweep) >= 360:
            equal(turns, [abs(sweep) // 360 - 1], f"turns of {text}")


@test("a circle whose points are all the same is none")
def no_circle(box):
    for text in ("circle(0,0,1e-7)", "circle(0,0,0.000001)", "arc(0,0,1e-7,0,90)"):
        result = run(box, f"power(50)\n{text}\n", wanted=1)
        alarm(result, "LB0024", 2)
        contains(result.err, "the radius is above 0.000001 mm", "the sentence")
