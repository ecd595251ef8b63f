"""The laser: its pulses and the registers of their timer, and what spindle codes do to its beam.
With motions made by hand: tests/unit/output/records/laser_pulses_test.cpp, spindle_beam_test.cpp."""

import csv
import io
import math
import os

from harness import alarm, check, contains, equal, near, refused, status, test

PROGRAM = "O1\nG21G90G94\nG00X5.\nG01X10.F600\nM30\n"
HEADER = "t,line,f,duty,TCNTB,TCMPB\n"


def pwm(box, *words, machine="laser3"):
    box.write("part.nc", PROGRAM)
    status(box.kerf("run", "part.nc", "--machine", machine, "--pwm", "pwm.csv", *words), 0)
    return box.read("pwm.csv").decode()


def keys(**values):
    return [word for key, value in values.items() for word in ("--machine-set", f"drive.{key}={value}")]


@test("--pwm says how the laser's timer stands when the run begins, and nothing more while it stays off")
def off(box):
    for machine in ("laser3", "laser5", "laser-xtz"):
        box.write("none.nc", "O1\nM30\n")
        status(box.kerf("run", "none.nc", "--machine", machine, "--pwm", "pwm.csv"), 0)
        equal(box.read("pwm.csv").decode(), HEADER, "without motions")
    equal(pwm(box), HEADER + "0,3,2000,0,12500,0\n", "laser3")


@test("--pwm follows clock, prescaler, divider, frequency and output of the machine file")
def registers(box):
    cases = {(): "2000,0,12500,0",
             ("pwm_frequency_hz=37000",): "37000,0,676,0",
             ("output=active_before_match",): "2000,0,12500,12500",
             ("hidden_tick=true",): "2000,0,12499,0",
             ("hidden_tick=true", "output=active_before_match"): "2000,0,12499,12499",
             ("prescaler=49", "divider=16", "pwm_frequency_hz=100"): "100,0,625,0",
             ("pclk_hz=66.5e6", "prescaler=7", "divider=4", "pwm_frequency_hz=1500"):
                 "1500,0,1385,0",
             ("pwm_frequency_hz=382",): "382,0,65445,0"}
    for settings, wanted in cases.items():
        words = keys(**dict(setting.split("=") for setting in settings))
        equal(pwm(box, *words), HEADER + f"0,3,{wanted}\n", f"with {settings}")


@test("the head of --pwm names the timer, if the machine does; timer 4 has no output")
def timer(box):
    for number in range(4):
        equal(pwm(box, *keys(timer=number)),
              HEADER.replace("TCNTB", f"TCNTB{number}").replace("TCMPB", f"TCMPB{number}")
              + "0,3,2000,0,12500,0\n", f"timer {number}")
    box.write("part.nc", PROGRAM)
    refused(box.kerf("run", "part.nc", "--machine", "laser3", *keys(timer=4)), 3, "timer 4 has no output")
    refused(box.kerf("run", "part.nc", "--machine", "laser3", *keys(timer=5)), 2, "drive.timer=5")
    text = box.kerf("machines", "laser3").text
    box.write("mine.toml", text.replace("[drive]", "[drive]\ntimer = 4", 1))
    refused(box.kerf("run", "part.nc", "--machine", "mine.toml"), 3, "mine.toml:", "timer 4 has no output")


@test("PULSE of laser BASIC is in --pwm and in the records of power, where it is not the machine's")
def program_pulses(box):
    box.write("p.bas", "speed(10)\npulse(0.4,0.6)\nburn(0.5)\npulse(0.4,0.1)\nburn(0.5)\n"
                       "pulse(1,1)\npulse(0,0)\nburn(0.5)\n")
    status(box.kerf("run", "p.bas", "--pwm", "pwm.csv", "--motion", "m.jsonl"), 0)
    equal(box.read("pwm.csv").decode(),
          HEADER + "0,3,1000,0.4,25000,10000\n0.5,5,2000,0.8,12500,10000\n1,8,2000,0.5,12500,6250\n"
          "1.5,8,2000,0,12500,0\n", "--pwm")
    told = [(m["line"], m["percent"], m.get("frequency_hz"))
            for m in box.motions("m.jsonl") if m["kind"] == "power"]
    equal(told, [(2, 40, 1000), (3, 40, 1000), (3, 0, 1000), (4, 80, None), (5, 80, None), (5, 0, None),
                 (6, 50, 500), (7, 50, None), (8, 50, None), (8, 0, None)], "power")
    status(box.kerf("run", "p.bas", "--machine-set", "drive.pwm_frequency_hz=1000", "--motion", "m.jsonl"), 0)
    told = [m.get("frequency_hz") for m in box.motions("m.jsonl") if m["kind"] == "power"]
    equal(told[:4], [None, None, None, 2000], "on a machine of 1000 Hz")


@test("a frequency that the timer cannot make is an alarm of --pwm at the line of its cut")
def program_pulse_out_of_range(box):
    box.write("p.bas", "speed(10)\npulse(2,2)\nline(5,0)\n")
    status(box.kerf("run", "p.bas"), 0)
    alarm(box.kerf("run", "p.bas", "--pwm", "pwm.csv"), "PWM_RANGE", 3)


@test("a cut whose pulses of PULSE lie apart is dotted")
def dotted_by_program(box):
    box.write("p.bas", "speed(100)\npulse(0.5,0.5)\nline(5,0)\npulse(2,2)\nline(10,0)\n")
    result = box.kerf("run", "p.bas")
    status(result, 0)
    contains(result.err, "p.bas:5:1: warning: DOTTED_CUT", "the warning")
    contains(result.err, "250 Hz", "the warning")


@test("the beam of a machine file has a kerf, a focus and a gas")
def beam_of_machine(box):
    text = box.kerf("machines", "laser3").text
    box.write("part.nc", PROGRAM)
    box.write("mine.toml", text + '\n[beam]\nkerf = 0.2\nfocus_mm = -1.5\ngas = "nitrogen, 8 bar"\n')
    status(box.kerf("run", "part.nc", "--machine", "mine.toml"), 0)
    for key in ("kerf=0.15", "focus_mm=-2", "gas=air"):
        status(box.kerf("run", "part.nc", "--machine", "laser3", "--machine-set", "beam." + key), 0)
    refused(box.kerf("run", "part.nc", "--machine", "laser3", "--machine-set", "beam.gas="), 2,
            "a name of 1 to 60 characters")
    for old, said in (('gas = 8', "beam.gas must be a name of 1 to 60 characters"),
                      ('focus_mm = "deep"', "focus_mm must be a number"),
                      ("width = 1", "there is no key beam.width")):
        box.write("mine.toml", text + f"\n[beam]\n{old}\n")
        refused(box.kerf("run", "part.nc", "--machine", "mine.toml"), 3, "mine.toml:", said)


@test("tip.z_first brings Z of a rapid to its place before the other axes move")
def z_first(box):
    box.write("part.nc", "O1\nG21G90G94\nG00X5.Z2.\nG01X10.Z1.F600\nG00X20.\nZ5.\nX0Y3.Z0\nM30\n")
    def made(*words):
        status(box.kerf("run", "part.nc", "--machine", "laser3", "--motion", "m.jsonl", *words), 0)
        return [(m["kind"], m["line"], *m["to"].values()) for m in box.motions("m.jsonl") if "to" in m]
    equal(made("--machine-set", "tip.z_first=true"),
          [("rapid", 3, 0, 0, 2), ("rapid", 3, 5, 0, 2), ("line", 4, 10, 0, 1), ("rapid", 5, 20, 0, 1),
           ("rapid", 6, 20, 0, 5), ("rapid", 7, 20, 0, 0), ("rapid", 7, 0, 3, 0)], "Z first")
    equal(len(made()), 5, "moves as they are programmed")


@test("--pwm is wrong usage on a machine without a laser")
def no_laser(box):
    box.write("part.nc", PROGRAM)
    for machine in ("mill3", "arm4"):
        refused(box.kerf("run", "part.nc", "--machine", machine, "--pwm", "pwm.csv"), 2, "--pwm",
                machine, "laser")
    refused(box.kerf("run", "part.nc", "--machine", "laser3", "--pwm", "pwm.csv",
                     *keys(max_power_w=0)), 2, "laser3")
    equal(box.files(), ["part.nc"], "files behind it")


@test("pulses that the laser's timer cannot make are an alarm at the line of the first motion")
def out_of_range(box):
    box.write("part.nc", PROGRAM)
    command = ["run", "part.nc", "--machine", "laser3", *keys(pwm_frequency_hz=381)]
    status(box.kerf(*command), 0)
    result = box.kerf(*command, "--pwm", "pwm.csv", "--pulses", "pulses.csv", "--summary", "s.json")
    alarm(result, "PWM_RANGE", 3)
    check("TCNTB 65617" in result.err, f"the sentence: {result.err}")
    equal(box.json("s.json")["alarm"]["code"], "PWM_RANGE", "alarm of the summary")
    equal(box.files(), ["part.nc", "pwm.csv", "s.json"], "files behind it")


@test("--pwm - goes to standard output, and all that follows the axes can be had at once")
def several(box):
    alone = pwm(box)
    result = box.kerf("run", "part.nc", "--machine", "laser3", "--pwm", "-", "--points", "a.csv",
                      "--pulses", "b.vcd", "--post", "c.nc")
    status(result, 0)
    equal(result.text, alone, "standard output")
    for name in ("a.csv", "b.vcd", "c.nc"):
        check(f"wrote {name}\n" in result.err, f"the summary does not tell of {name}")


@test("--pwm to a full device, to a folder and in a folder that is missing is told in one sentence")
def cannot_write(box):
    box.write("part.nc", PROGRAM)
    os.makedirs(box.path("folder"))
    for name in ("/dev/full", "folder", "missing/pwm.csv"):
        refused(box.kerf("run", "part.nc", "--machine", "laser3", "--pwm", name), 3, name)
    equal(box.files(), ["folder", "part.nc"], "files behind it")


BASIC = ("speed(50)\npower(80)\nline(20,0)\nmove(0,10)\npower(25)\nline(20,10)\n"
         "power(100)\nline(20,20)\nend\n")


@test("the duty of --pwm and the power of --points follow POWER of laser BASIC, and MOVE is off")
def basic(box):
    box.write("part.bas", BASIC)
    status(box.kerf("run", "part.bas", "--pwm", "pwm.csv", "--points", "points.csv"), 0)
    changes = [row for row in csv.DictReader(io.StringIO(box.read("pwm.csv").decode()))]
    equal([(row["line"], row["duty"], row["TCMPB"]) for row in changes],
          [("3", "0.8", "10000"), ("4", "0", "0"), ("6", "0.25", "3125"), ("8", "1", "12500"),
           ("8", "0", "0")], "changes of the duty")
    powers = {"3": "80", "4": "0", "6": "25", "8": "100"}
    for row in csv.DictReader(io.StringIO(box.read("points.csv").decode())):
        equal(row["power"], powers[row["line"]], f"power at {row['t']} s")
        while changes and float(changes[0]["t"]) < float(row["t"]):
            duty = float(changes.pop(0)["duty"])
        near(100 * duty, float(row["power"]), 1e-9, f"duty at {row['t']} s")


@test("pulses farther apart than the spot are told once, with line and numbers; joined ones are not")
def dotted(box):
    box.write("part.bas", "speed(100)\npower(50)\nmove(1,1)\nline(50,1)\nline(50,9)\nend\n")
    for setting in ("drive.pwm_frequency_hz=1000", "drive.pwm_frequency_hz=2000"):
        result = box.kerf("run", "part.bas", "--machine-set", setting)
        status(result, 0)
        check("DOTTED_CUT" not in result.err, f"with {setting}: {result.err}")
    coarse = ["--machine-set", "drive.pwm_frequency_hz=500"]
    result = box.kerf("run", "part.bas", *coarse)
    status(result, 0)
    equal(result.err.count("DOTTED_CUT"), 1, "warnings")
    first = result.err.splitlines()[:2]
    contains(first[0], "part.bas:4:1: warning: DOTTED_CUT", "the warning")
    contains(first[0], "500 Hz at 100 mm/s: a pulse every 0.2 mm, the spot has 0.1 mm", "the warning")
    contains(first[1], "line(50,1)", "the source line")
    full = box.write("full.bas", "speed(100)\npower(100)\nline(50,1)\nend\n")
    check("DOTTED" not in box.kerf("run", full, *coarse).err, "full power has no pulses")


# Constant power, power that follows the speed round a corner, a dwell, and a way back with no beam.
SPINDLE = """O1
G21 G90 G00 X5.
M03 S500
G01 X20. F1800
X30. S250
G00 X40.
M05
G01 X50.
M04 S800
X60.
Y10.
G04 P100
X50. F900
M30
"""


def spindle(box, *words, machine="laser3", text=SPINDLE):
    box.write("part.nc", text)
    result = box.kerf("run", "part.nc", "--machine", machine, "--motion", "m.jsonl", "--points", "p.csv", *words)
    status(result, 0)
    return result


def rows(box, name):
    return list(csv.DictReader(io.StringIO(box.read(name).decode())))


@test("on a machine with a laser S is its power: M03 and M04 have the beam on in cuts, M05 off")
def spindle_is_beam(box):
    for machine in ("laser3", "laser5", "laser-xtz"):
        spindle(box, machine=machine)
        told = [(m["line"], m["percent"], m.get("follows_speed", False))
                for m in box.motions("m.jsonl") if m["kind"] == "power"]
        equal(told, [(4, 50, False), (5, 25, False), (6, 0, False), (10, 80, True), (14, 0, False)],
              f"power on {machine}")
        equal([m for m in box.motions("m.jsonl") if m["kind"] == "spindle"], [], "spindle")
        constant = {"2": 0, "4": 50, "5": 25, "6": 0, "8": 0}
        for row in rows(box, "p.csv"):
            if row["line"] in constant:
                equal(float(row["power"]), constant[row["line"]], f"power at {row['t']} s")
    spindle(box, machine="mill3")
    equal([m["kind"] for m in box.motions("m.jsonl") if m["kind"] in ("power", "spindle")], ["spindle"] * 4,
          "on a mill")


@test("the power of M04 is in proportion to the speed of the tip, and the beam off while it dwells")
def power_follows_speed(box):
    spindle(box, "--pwm", "w.csv")
    feeds = {"10": 30, "11": 30, "13": 15}
    before, slow, dwells = None, 0, 0
    for row in rows(box, "p.csv"):
        if row["line"] in feeds:
            way = sum((float(row[axis]) - float(before[axis])) ** 2 for axis in "XYZ") ** 0.5
            wanted = min(100, 80 * way / (float(row["t"]) - float(before["t"])) / feeds[row["line"]])
            near(float(row["power"]), wanted, 0.0051, f"power at {row['t']} s")
            slow += float(row["power"]) < 79
        if row["line"] == "12":
            equal(row["power"], "0", f"power of the dwell at {row['t']} s")
            dwells += 1
        before = row
    check(slow > 20 and dwells > 90, f"{slow} slow periods, {dwells} of the dwell")
    for change, row in zip(rows(box, "w.csv"), range(99)):
        near(float(change["TCMPB"]), 12500 * float(change["duty"]), 0.5001, f"row {row} of the pulses")
    box.write("even.nc", "O1\nG21 G90 M04 S500\nG01 X20. F1800\nY20.\nX0.\nM30\n")
    even = box.kerf("run", "even.nc", "--machine", "laser3", "--plot", "e.svg", "--plot-energy")
    contains(even.err, "median 1 J/mm, most 1 J/mm", "the energy of an even cut")
    box.write("burnt.nc", "O1\nG21 G90 M03 S500\nG01 X20. F1800\nY20.\nX0.\nM30\n")
    burnt = box.kerf("run", "burnt.nc", "--machine", "laser3", "--plot", "e.svg", "--plot-energy")
    check("most 1 J/mm" not in burnt.err, f"constant power burns where it is slow: {burnt.err}")


@test("S alone changes the power without stopping the axes, as does S in a block that moves")
def power_in_passing(box):
    head = "O1\nG21 G90 M03 S500\nG01 X20. F1800\n"
    spindle(box, text=head + "X40.\nM30\n")
    seconds = rows(box, "p.csv")[-1]["t"]
    for change in ("S250\nX40.\n", "X40. S250\n"):
        spindle(box, text=head + change + "M30\n")
        made = [(float(row["t"]), float(row["X"]), row["power"]) for row in rows(box, "p.csv")]
        equal(rows(box, "p.csv")[-1]["t"], seconds, "time with the change")
        for (t0, x0, _), (t1, x1, power) in zip(made, made[1:]):
            if 5 < x0 and x1 < 35:
                near((x1 - x0) / (t1 - t0), 30, 1e-3, f"speed at X{x1}")
            if not 19.9 < x1 < 20.1:
                equal(power, "50" if x1 < 20 else "25", f"power at X{x1}")


@test("S above full power is full power and a warning with its line; the machine file says what full is")
def over_full(box):
    text = "O1\nG21 G90\nM03 S300\nG01 X20. F600\nM30\n"
    spindle(box, text=text)
    check("OVER_FULL" not in spindle(box, text=text).err, "300 of 1000")
    result = spindle(box, *keys(s_of_full_power=255), text=text)
    contains(result.err, "part.nc:3:1: warning: OVER_FULL_POWER", "the warning")
    contains(result.err, "S300, full power is S255", "the warning")
    equal(rows(box, "p.csv")[5]["power"], "100", "the power")
    checked = box.kerf("check", "part.nc", "--machine", "laser3")
    check("OVER_FULL" not in checked.text + checked.err, "check")
    spindle(box, *keys(s_of_full_power=600), text=text)
    equal(rows(box, "p.csv")[5]["power"], "50", "the power")


@test("the beam is off at program stops, in probing moves and when an alarm ends the run")
def off_at_rest(box):
    spindle(box, text="O1\nG21 G90\nM03 S300\nG01 X20. F600\nM00\nX30.\nG31 X40.\nX50.\nM30\n")
    told = [(m["line"], m["percent"]) for m in box.motions("m.jsonl") if m["kind"] == "power"]
    equal(told, [(4, 30), (5, 0), (6, 30), (7, 0), (8, 30), (9, 0)], "the beam")
    box.write("part.nc", "O1\nG21 G90\nM03 S300\nG01 X20. F600\n#1=1/0\nM30\n")
    alarm(box.kerf("run", "part.nc", "--machine", "laser3", "--pwm", "w.csv"), "PS0112", 5)
    equal(rows(box, "w.csv")[-1]["duty"], "0", "the last duty")


@test("a posted program has the power of the program in M3, M4 and S")
def posted_spindle(box):
    spindle(box, "--post", "out.nc")
    lines = box.read("out.nc").decode().splitlines()
    check("(LASER: FULL POWER IS S1000)" in lines, "the head has no full power")
    equal([line for line in lines if line[0] in "MS"],
          ["M5", "M3 S500", "M3 S250", "M5", "M4 S800", "M5", "M30"], "beam")


@test("taught points of a program have the beam on where its path begins, not on the way there")
def taught_spindle(box):
    spindle(box, "--teach", "out.tch", text="O1\nG21 G90 M03 S500\nG01 X20. F600\nM04\nX30.\nM30\n", machine="laser5")
    lines = [line for line in box.read("out.tch").decode().splitlines() if not line.startswith(("TEACH", "UNITS"))]
    equal(lines, ["; tool centre path in machine coordinates", "PERIOD 8", "RADII 150 80", "POINT 0 0 0 0 0",
                  "LASER ON 50", "FEED 600", "LINE 20 0 0 0 0", "; power follows the speed", "LASER ON 50",
                  "LINE 30 0 0 0 0", "LASER OFF", "END"], "taught points")


HOLE = "O1\nG21 G90\nM03 S500\nG00 X10. Y20.\n{}G04 P500\nG00 X0 Y0\nM30\n"


@test("G01 without axes turns the beam on where it stands, and the dwell behind it burns")
def pierce(box):
    result = spindle(box, text=HOLE.format("G01\n"))
    check("BEAM_OFF" not in result.err, result.err)
    told = [(m["line"], m["percent"]) for m in box.motions("m.jsonl") if m["kind"] == "power"]
    equal(told, [(5, 50), (7, 0)], "the beam")
    burning = [row for row in rows(box, "p.csv") if row["power"] == "50"]
    equal({(row["X"], row["Y"]) for row in burning}, {("10", "20")}, "where it burns")
    near(len(burning) * 0.001, 0.5, 0.0011, "how long")


@test("a dwell without the beam is a warning, once, also under M04 and for check; on a mill it is none")
def dwell_without_beam(box):
    for text, line in ((HOLE.format(""), 5), (HOLE.format("").replace("M03", "M04").replace("G04", "G01\nG04"), 6),
                       (HOLE.format("G04 P100\n"), 5)):
        result = spindle(box, text=text)
        equal(result.err.count("warning: BEAM_OFF_IN_DWELL beam off in this dwell"), 1, result.err)
        contains(result.err, f"part.nc:{line}:1: warning", "the place")
        check(not [m for m in box.motions("m.jsonl") if m["kind"] == "power" and m["percent"] > 0
                   and not m.get("follows_speed")], "no constant beam")
    checked = box.kerf("check", "part.nc", "--machine", "laser3")
    contains(checked.text, "BEAM_OFF_IN_DWELL", "check")
    check("BEAM_OFF" not in box.kerf("run", "part.nc", "--machine", "mill3").err, "a mill has no beam")
    spindle(box, text=HOLE.format("").replace("M03 S500", "M03 S0"))
    check("BEAM_OFF" not in spindle(box, text=HOLE.format("").replace("S500", "S0")).err, "without power")


@test("G01 without axes on a mill is what it was: no record")
def standing_on_a_mill(box):
    box.write("part.nc", HOLE.format("G01\n"))
    status(box.kerf("run", "part.nc", "--machine", "mill3", "--motion", "m.jsonl"), 0)
    equal([m["kind"] for m in box.motions("m.jsonl")], ["spindle", "rapid", "dwell", "rapid", "end"], "records")


BURNS = {"hole.bas": "power(50)\nmove(10,20)\nburn(0.5)\nmove(30,20)\n",
         "hole.tch": "TEACH 1\nPOINT 10 20 0 0 0\nLASER ON 50\nDWELL 0.5\nLASER OFF\nPOINT 30 20 0 0 0\nEND\n",
         "hole.nc": HOLE.format("G01\n")}


@test("a hole is the same in every language: points, pulses, time, energy; and --post burns it again")
def holes(box):
    for name, text in BURNS.items():
        box.write(name, text)
        for source in (name, "again.nc"):
            if source != name:  # P of the posted G4 counts seconds
                posted = box.read("again.nc").decode()
                contains(posted, "M3 S500\nG1 F1.\nG4 P0.5\nM5\n", f"{name}: the posted burn")
                box.write("again.nc", posted.replace("P0.5", "P500"))
            status(box.kerf("run", source, "--machine", "laser3", "--points", "p.csv", "--pwm", "w.csv", "--plot",
                            "e.svg", "--plot-energy", "--summary", "s.json", *(["--post", "again.nc"] if source == name
                                                                               else [])), 0)
            burning = [float(row["t"]) for row in rows(box, "p.csv") if row["power"] == "50"]
            near(burning[-1] - burning[0], 0.5, 0.0025, f"{source}: seconds of set-points")
            pulses = rows(box, "w.csv")
            on = [i for i, row in enumerate(pulses) if row["duty"] == "0.5"]
            equal(len(on), 1, f"{source}: times that the beam goes on")
            near(float(pulses[on[0] + 1]["t"]) - float(pulses[on[0]]["t"]), 0.5, 0.0025, f"{source}: pulses")
            near(box.json("s.json")["dwell_s"], 0.5, 1e-9, f"{source}: dwell_s")
            # 60 W, half of it, 0.5 s: 15 J on a spot of 0.1 mm
            contains(box.read("e.svg").decode(), "most 150", f"{source}: J/mm")


@test("a block whose move is refused switches nothing")
def refused_block(box):
    box.write("part.nc", "O1\nG21 G90\nG01 X10. F600\nM03 S500 M08 X5000.\nM30\n")
    alarm(box.kerf("run", "part.nc", "--machine", "laser3", "--motion", "m.jsonl"), "OT0500", 4)
    equal([m["kind"] for m in box.motions("m.jsonl")], ["line"], "what is made")
    checked = box.kerf("check", "part.nc", "--machine", "laser3")
    status(checked, 1)
    contains(checked.text, "OT0500", "check")


def distance_mm(point, a, b):
    way = [q - p for p, q in zip(a, b)]
    share = sum((x - p) * w for x, p, w in zip(point, a, way)) / sum(w * w for w in way)
    share = min(1, max(0, share))
    return math.dist(point, [p + share * w for p, w in zip(a, way)])


def focus(joints, r_a=150, r_c=80):
    x, y, z, a, c = joints
    a, c = math.radians(a), math.radians(c)
    return (x - r_a * math.sin(a) * math.sin(c) + r_c * math.cos(c),
            y + r_a * math.sin(a) * math.cos(c) + r_c * math.sin(c), z - r_a * math.cos(a))


@test("a head that turns along its cuts uses the chord tolerance, and keeps it between all set-points")
def turning_head(box):
    box.write("turn.tch", "TEACH 1\nPOINT 0 0 0 0 0\nFEED 6000\nLASER ON 80\nLINE 60 0 0 60 90\n"
                          "LINE 60 40 10 -30 -90\nEND\n")
    status(box.kerf("run", "turn.tch", "--machine", "laser5", "--points", "p.csv", "--summary", "s.json",
                    "--machine-set", "interpolator.tolerance=0"), 0)
    check(box.json("s.json")["time_s"] < 9, f'{box.json("s.json")["time_s"]} s')
    corners = [(0, 0, 0), (60, 0, 0), (60, 40, 10)]
    made = [[float(row[f"j{i}"]) for i in range(1, 6)] for row in rows(box, "p.csv")]
    most = 0
    for before, behind in zip(made, made[1:]):
        for share in range(1, 8):
            tip = focus([p + (q - p) * share / 8 for p, q in zip(before, behind)])
            most = max(most, min(distance_mm(tip, a, b) for a, b in zip(corners, corners[1:])))
    check(0.0007 < most <= 0.001, f"{most} mm of 0.001")
