"""What the command line tells of lathes: the spindles of a machine file, and the summary."""

import math

from harness import contains, equal, near, refused, status, test

GIVES_SPINDLE = "O1\nG97S3000M03\nG00X0Z0\nG01Z-10.F.2\nM05\nM30\n"


def summary(box, text, *words, machine="lathe2", wanted=0):
    box.write("part.nc", text)
    status(box.kerf("run", "part.nc", "--machine", machine, "--summary", "s.json", *words), wanted)
    return box.json("s.json")


@test("a record names the spindle that is not the main one")
def names(box):
    box.write("part.nc", "O1\nG97S800M03\nS1200M133\nS700M143\nM30\n")
    status(box.kerf("run", "part.nc", "--machine", "lathe3c", "--motion", "m.jsonl"), 0)
    records = [(r["speed"], r.get("spindle")) for r in box.motions("m.jsonl") if r["kind"] == "spindle"]
    equal(records, [(800, None), (1200, "live"), (700, "sub")], "spindles")


@test("a cut waits for the acceleration of its spindle")
def acceleration(box):
    at_once = summary(box, GIVES_SPINDLE)["time_s"]
    for rpm_s in (1500, 6000):
        slow = summary(box, GIVES_SPINDLE, "--machine-set", f"spindle.main.acceleration={rpm_s}")
        near(slow["time_s"], at_once + 3000 / rpm_s, 0.0025, f"{rpm_s} rpm/s")
        near(slow["time_feed_s"], 1.0, 1e-9, "without acceleration")


@test("the limit of a spindle can be set, that of the main one by parameter too")
def limits(box):
    text = "O1\nG97S4000M03\nS4000M133\nM30\n"
    words = ("--machine-set", "spindle.main.max_rpm=3000", "--machine-set", "spindle.live.max_rpm=2000")
    told = summary(box, text, *words, machine="lathe3c")["spindle"]
    equal((told["max_rpm_used"], told["clamped"]), (3000, True), "main")
    equal((told["live"]["max_rpm_used"], told["live"]["clamped"]), (2000, True), "live")
    told = summary(box, text, "--param", "3772=2500", machine="lathe3c")["spindle"]
    equal(told["max_rpm_used"], 2500, "by parameter")


@test("a spindle that there is not, and a key that it has not, are wrong usage")
def wrong_keys(box):
    box.write("part.nc", GIVES_SPINDLE)
    for setting in ("spindle.live.max_rpm=10", "spindle.main.speed=10", "spindle.main.max_rpm=-1",
                    "m_codes.chuck=10", "m_codes.clamp=x"):
        refused(box.kerf("run", "part.nc", "--machine", "lathe2", "--machine-set", setting), 2, setting)


@test("a machine file with a wrong spindle says the line")
def wrong_files(box):
    good = box.kerf("machines", "lathe2").text
    for old, new in (('name = "main"', 'name = "front"'), ("clockwise = 3\n", "clock = 3\n"),
                     ("p = [1, 11]", "p = [1, -11]"), ("orient = 19", "orient = 1.5")):
        box.write("bad.toml", good.replace(old, new, 1))
        box.write("part.nc", GIVES_SPINDLE)
        result = box.kerf("run", "part.nc", "--machine", "bad.toml")
        status(result, 3)
        contains(result.err, "bad.toml:", new)


@test("the summary of a lathe tells the highest speed, and whether it was clamped")
def speeds(box):
    told = summary(box, "O1\nG50S2000\nG96S100M03\nG00X100.Z1.\nG01X40.F.2\nM30\n")
    near(told["spindle"]["max_rpm_used"], 1e5 / math.pi / 40, 1e-6, "at X40")
    equal((told["spindle"]["css"], told["spindle"]["clamped"]), (True, False), "not clamped")
    told = summary(box, "O1\nG50S2000\nG96S100M03\nG00X100.Z1.\nG01X-2.F.2\nM30\n")
    equal(told["spindle"], {"max_rpm_used": 2000, "css": True, "clamped": True}, "past the centre")
    told = summary(box, "O1\nG97S700M03\nM30\n")
    equal(told["spindle"], {"max_rpm_used": 700, "css": False, "clamped": False}, "constant speed")


@test("G50 S limits what G96 asks for, and the run takes as long: 200 mm at 0.02 mm a turn")
def clamped(box):
    cut = "G96S200M03\nG00X50.Z0\nG01Z-200.F.02\nM30\n"  # 200 m/min on a diameter of 50 mm: 1273.24 rpm
    limited = summary(box, "O1\nG50S1000\n" + cut)
    near(limited["time_s"], 600, 0.5, "10,000 turns at 1000 rpm, and a rapid")
    free = summary(box, "O1\nG50S4000\n" + cut)
    near(free["time_s"] - 471.24, limited["time_s"] - 600, 0.01, "at 1273.24 rpm")
    equal((limited["spindle"]["clamped"], free["spindle"]["clamped"]), (True, False), "told")


@test("the summary of a lathe counts the passes of its threads")
def threads(box):
    text = ("O1\nG97S500M03\nG00X34.Z5.\nG76P011000Q100R.05\nG76X27.4Z-25.P1300Q400F2.\n"
            "G00X24.Z6.\nG92X19.2Z-20.F1.5\nX18.7\nX18.16\nG00X30.\n"
            "G00X27.\nG32Z-20.F2.\nG32X31.Z-26.\nG00X40.\nM30\n")
    told = summary(box, text)["threads"]
    equal([(t["lead"], t["passes"]) for t in told], [(2, 10), (1.5, 3), (2, 1)], "threads")
    for depth, wanted in zip([t["depth"] for t in told], (1.3, 0.52, 0)):
        near(depth, wanted, 1e-9, "depth")


@test("the summary of a lathe lists its cycles with their lines and passes")
def cycles(box):
    text = ("O1\nG97S500M03\nG00X90.Z3.\nG71U4.R.8\nG71P10Q50U.6W.2F.3\nN10G00X36.\n"
            "G01Z-15.F.15\nG01X50.Z-30.\nG01Z-45.\nN50G01X90.\nG70P10Q50\nG00X52.Z2.\n"
            "G90X46.Z-30.F.2\nX42.\nG00X60.\nG90X40.Z-3.\nG00X46.Z-12.\nG75R.5\n"
            "G75X34.Z-19.5P2500Q3000F.08\nM30\n")
    told = summary(box, text)["cycles"]
    equal([(c["code"], c["line"], c["passes"]) for c in told],
          [("G71", 5, 7), ("G70", 11, 1), ("G90", 13, 2), ("G90", 16, 1), ("G75", 19, 4)], "cycles")


@test("the holes of a cycle are its passes")
def holes(box):
    text = ("O1\nG97S500M133\nG00X30.Z5.C0\nG83Z-10.R-3.Q5000F.1\nC90.\nC180.\nG80\nM30\n")
    told = summary(box, text, machine="lathe3c")["cycles"]
    equal([(c["code"], c["line"], c["passes"]) for c in told], [("G83", 4, 3)], "holes")


@test("the summary of a mill tells no spindle, threads and cycles")
def mills(box):
    told = summary(box, "O1\nS500M03\nG81X1.Z-1.R1.F100\nM30\n", machine="mill3")
    equal([key for key in ("spindle", "threads", "cycles") if key in told], [], "keys")


@test("an endless bar job says so in its messages")
def bar_job(box):
    told = summary(box, "O1\nG00X50.\nG00X60.\nM99\n", "--max-motions", "10", wanted=5)
    equal((told["status"], len(told["messages"])), ("budget", 1), "status, messages")
    contains(told["messages"][0], "M99", "message")
