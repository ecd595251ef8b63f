"""--pwm: the laser's pulses and the registers of their timer. No G-code switches the beam: its power
is tried with laser BASIC, and with motions made by hand in tests/unit/laser_pulses_test.cpp."""

import csv
import io
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
