"""--pwm: the laser's pulses and the registers of their timer. No G-code switches the beam: its power
is tried with motions made by hand, in tests/unit/laser_pulses_test.cpp."""

import os

from harness import alarm, check, equal, refused, status, test

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
