"""kerf time: where the time of a run goes."""

import json

from harness import contains, equal, near, status, test

PROGRAM = ("O1\nG21G90G94\nT1M06\nG00X100.\nG01X0F600\nG04P1500\nT2M06\n"
           "#1=0\nWHILE[#1LT3]DO1\nG01X10.F600\nX0\n#1=#1+1\nEND1\nM30\n")
RAMP = 3000  # mm/s² of mill3


def move_s(length, speed):
    """Of a move from rest to rest, without jerk."""
    return length / speed + speed / RAMP


@test("kerf time splits the time by tool and kind of move")
def tools(box):
    box.write("part.nc", PROGRAM)
    result = box.kerf("time", "part.nc", "--format", "json")
    status(result, 0)
    report = json.loads(result.text)
    near(report["rapid_s"], move_s(100, 400), 0.001, "rapids")
    near(report["dwell_s"], 1.5, 1e-9, "dwells")
    first, second = report["tools"]
    equal((first["tool"], second["tool"]), (1, 2), "tools")
    near(first["cut_s"], move_s(100, 10), 0.001, "cuts of T1")
    near(second["cut_s"], 6 * move_s(10, 10), 0.01, "cuts of T2")
    near(report["time_s"], report["rapid_s"] + report["cut_s"] + report["dwell_s"], 1e-9, "sum")


@test("kerf time names the lines that cost most, passes of a loop together")
def places(box):
    box.write("part.nc", PROGRAM)
    places = json.loads(box.kerf("time", "part.nc", "--format", "json").text)["places"]
    equal(sorted(place["line"] for place in places[:3]), [5, 10, 11], "dearest lines")
    equal([place["runs"] for place in places[:3]], [1, 3, 3], "how often")
    near(places[0]["length_mm"], 100, 1e-6, "length of the dearest")
    equal(places[0]["programmed_mm_min"], [600, 600], "its feed")
    text = box.kerf("time", "part.nc").text
    for words in ("T2", "lines that cost most", "part.nc:5", "dwell"):
        contains(text, words, "report")


def runs_of_lines(box, name, text, *options):
    """The runs that kerf time tells, by line and kind."""
    box.write(name, text)
    result = box.kerf("time", name, "--format", "json", *options)
    status(result, 0)
    return {(place["line"], place["kind"]): place["runs"] for place in json.loads(result.text)["places"]}


@test("kerf time counts the runs of a line, also of one that runs directly behind itself")
def runs(box):
    equal(runs_of_lines(box, "part.nc", "O1\n#1=0\nN1G91G01X10.F600\n#1=#1+1\nIF[#1LT3]GOTO1\nM30\n"),
          {(3, "cut"): 3}, "a loop with one line that moves")
    equal(runs_of_lines(box, "heart.bas", "speed(50);power(60)\nfor i=1 to 3\nline(10*i,0)\nnext\n"),
          {(3, "cut"): 3}, "a loop of BASIC")
    equal(runs_of_lines(box, "part.nc", "O1\nM98P2L4\nM30\nO2\nG91G01X1.F60\nM99\n"),
          {(5, "cut"): 4}, "a subprogram that is repeated")


@test("kerf time counts a line once however many moves it makes")
def moves_of_a_line(box):
    cycle = "O1\nG90G99G83X10.Y10.Z-10.R2.Q4.F100\nX20.\nG80\nM30\n"
    runs = runs_of_lines(box, "part.nc", cycle)
    equal(runs, {(line, kind): 1 for line in (2, 3) for kind in ("rapid", "cut")}, "a canned cycle")
    equal(runs_of_lines(box, "box.bas", "power(9)\nline(9,0);line(9,9);line(0,9);line(0,0)\n"),
          {(2, "cut"): 1}, "four statements of a line")
    equal(runs_of_lines(box, "part.nc", "O1\nG91G01X1.F60;Y1.;X-1.\nM30\n"), {(2, "cut"): 1},
          "three blocks of a line")


@test("kerf time tells the lowest and the highest feed of a line that has several")
def feeds(box):
    box.write("part.nc", "O1\n#1=1\nN1G91G01X10.F[#1*60]\n#1=#1+1\nIF[#1LE3]GOTO1\nG00X1.\nM30\n")
    places = json.loads(box.kerf("time", "part.nc", "--format", "json").text)["places"]
    equal([place["programmed_mm_min"] for place in places], [[60, 180], None], "feeds")
    contains(box.kerf("time", "part.nc").text, " 1.00-3.00  part.nc:3\n", "the cut's line")


@test("the first move of kerf time begins where the tip is at power-on")
def from_the_start(box):
    box.write("part.nc", "O1\nG01X224.F60\nM30\n")
    for machine in ("arm4", "cartesian-step"):
        way = 40 if machine == "arm4" else 224
        result = box.kerf("time", "part.nc", "--machine", machine, "--format", "json")
        place = json.loads(result.text)["places"][0]
        near(place["length_mm"], way, 1e-6, f"length on {machine}")


@test("kerf time says how much of the time there would be without acceleration")
def ratio(box):
    box.write("part.nc", "O1\nG21G90G94\nG01X1.F6000\nM30\n")  # 10 ms and as long again for the ramps
    slow = ["--machine-set", "axis.X.acceleration=10000"]
    contains(box.kerf("time", "part.nc", *slow).text,
             "O0001 on mill3: 0.020 s, without acceleration 0.010 s (x 0.50)\n", "the first line")
    box.write("part.nc", "O1\nM30\n")
    contains(box.kerf("time", "part.nc").text, "without acceleration 0.000 s\n", "the first line")


@test("kerf time tells of alarms and ends like kerf run")
def alarms(box):
    box.write("part.nc", "O1\nG21G90\nG01X10.F100\nG01X[1/0]\nM30\n")
    result = box.kerf("time", "part.nc")
    status(result, 1)
    contains(result.text, "part.nc:3", "what was made before the alarm")
    contains(result.err, "PS0112", "standard error")
    status(box.kerf("time", "missing.nc"), 3)
    status(box.kerf("time"), 2)
