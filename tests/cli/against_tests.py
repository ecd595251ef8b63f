"""`kerf stock --against`: the same part by two programs is the same, and what differs is found with the lines of both;
of mills with both models, of lathes and of sheets, with other tools, and with a part that was saved."""

import json
import math
import struct

from compare_tests import FACE, STOCK, TAIL, accessor, faced
from harness import check, contains, equal, near, refused, status, test
from stock_files_tests import TURNING_TOOL

HEAD = "O1\nT1M06\nS3000M03\nG90G54\n"
FORTH = faced("1.")
# The same face in other passes, the other way, after a pass in the air.
BACK = "G00X55.Y30.Z5.\nG01Z3.F300\nX-15.F900\nX55.\nZ-.4\nX-15.\nY12.\nX55.\nY0.\nX-15.\nG00Z5.\nX55.Y30.\nG01Z-1.F300\n" \
       "X-15.F900\nY12.\nX55.\nY0.\nX-15.\n"
NOTHING = {"only_here_mm3": 0, "only_there_mm3": 0, "max_mm": 0, "regions_here": 0, "regions_there": 0, "regions": []}


def against(box, first, second, *words, wanted=0, stock=STOCK, machine="mill3", tools=FACE):
    """The report of a program, held against another one."""
    box.write("a.nc", first)
    box.write("b.nc", second)
    box.write("tools.toml", tools)
    result = box.kerf("stock", "a.nc", "--machine", machine, "--stock", stock, "--tools", "tools.toml", "--against", "b.nc",
                      "--report", "r.json", *words)
    status(result, wanted)
    return box.json("r.json")


def milled(box, first, second, *words, wanted=0):
    return against(box, HEAD + first + TAIL, HEAD + second + TAIL, "--cell", "0.25", *words, wanted=wanted)


def same(report, what):
    equal({key: report["against"][key] for key in NOTHING}, NOTHING, what)
    equal(report["findings"], [], what)


def differs(report, what):
    equal([(f["code"], f["severity"], f["line"]) for f in report["findings"]], [("DIFFERS", "warning", 0)], what)
    return report["against"]


@test("against: what two programs mill in another order is the same to the last bit, with both models")
def milled_alike(box):
    for model in ("zmap", "tridexel"):
        report = milled(box, FORTH, BACK, "--model", model)
        same(report, model)
        equal((report["against"]["file"], report["against"]["status"]), ("b.nc", "end"), "the other one")
        equal(report["model"]["kind"], model, "kind")


@test("against: what one of two milling programs cuts deeper is found, with its depth, volume and the lines of both")
def milled_otherwise(box):
    for model in ("zmap", "tridexel"):
        there = differs(milled(box, FORTH, faced("1.2"), "--model", model, wanted=1), model)
        near(there["max_mm"], 0.2, 1e-5, model)
        near(there["only_here_mm3"], 240, 1e-3, model)
        equal((there["only_there_mm3"], there["regions_here"], there["regions_there"]), (0, 1, 0), model)
        region = there["regions"][0]
        equal((region["kind"], {line["file"] for line in region["lines"]}), ("only_here", {"a.nc"}), model)
        equal({line["line"] for line in region["lines"]} <= {7, 8, 9, 10, 11}, True, model)
        equal({line["file"] for line in region["lines_there"]}, {"b.nc"}, model)
        near(sum(line["share"] for line in region["lines_there"]), 1, 1e-6, model)
        mirrored = differs(milled(box, faced("1.2"), FORTH, "--model", model, wanted=1), model)
        near(mirrored["only_there_mm3"], 240, 1e-3, model)
        equal(mirrored["only_here_mm3"], 0, model)


@test("against: a hole that only one program drills is named by its line, and within tolerance there is no finding")
def one_hole(box):
    hole = "G00Z5.\nT2M06\nM03\nG00X20.Y15.\nZ5.\nG01Z-3.F300\nG00Z5.\n"
    report = milled(box, FORTH, FORTH + hole, wanted=1)
    there = differs(report, "found")
    near(there["only_here_mm3"], 2 * math.pi * 25, 3, "volume")
    equal([line["line"] for line in there["regions"][0]["lines_there"]], [17], "line of the hole")
    contains(report["findings"][0]["message"], "only in b.nc", "message")
    near(milled(box, FORTH, faced("1.04"))["against"]["max_mm"], 0.04, 1e-5, "told within tolerance, too")
    for words in (("--tolerance", "0.3"), ("--excess", "0.3"), ("--no-check", "DIFFERS")):
        equal(milled(box, FORTH, faced("1.2"), *words)["findings"], [], words)
    status(box.kerf("stock", "a.nc", "--stock", STOCK, "--tools", "tools.toml", "--against", "b.nc", "--fail-on", "error"), 0)


@test("against: where the other program needs dexels both are held in them")
def both_in_dexels(box):
    tools = FACE + '[[tool]]\nnumber = 3\ntype = "t-slot"\ndiameter = 16\nwidth = 2\nneck_diameter = 7\n'
    slot = "G00Z5.\nT3M06\nM03\nG00X-15.Y15.\nZ-6.\nG01X55.F300\nG00Z5.\n"
    report = against(box, HEAD + FORTH + TAIL, HEAD + FORTH + slot + TAIL, "--cell", "0.25", "--fail-on", "error", tools=tools)
    equal(report["model"]["kind"], "tridexel", "kind")
    check(report["against"]["only_here_mm3"] > 16 * 2 * 40, "the slot")


@test("against: --against-tools names the tools of the other program, which may be the same")
def other_tools(box):
    box.write("worn.toml", FACE.replace("diameter = 20", "diameter = 19"))
    box.write("a.nc", HEAD + "G00X20.Y-15.Z5.\nG01Z-2.F300\nY45.F900\nG00Z5.\n" + TAIL)
    box.write("tools.toml", FACE)
    words = ("stock", "a.nc", "--stock", STOCK, "--tools", "tools.toml", "--cell", "0.25", "--against", "a.nc", "--report", "r.json")
    status(box.kerf(*words, "--against-tools", "worn.toml", "--model", "tridexel"), 1)
    found = differs(box.json("r.json"), "worn")
    near(found["only_there_mm3"], 2 * 30 * 1, 0.5, "volume")
    near(found["max_mm"], 0.5, 1e-3, "a wall each")
    equal(found["regions_there"], 2, "walls")
    status(box.kerf(*words, "--against-tools", "tools.toml"), 0)
    same(box.json("r.json"), "the same tools")
    refused(box.kerf(*words), 2, "--against", "itself")


LATHE_HEAD = "O1\nT0101\nG97S1000M03\n"
IN_TWO = "G00X46.Z2.\nG01Z-20.F0.2\nX60.\nG00Z2.\nX40.\nG01Z-20.F0.2\nX60.\n"
IN_ONE = "G00X40.Z2.\nG01Z-7.F0.2\nZ-20.\nX60.\nG00Z2.\n"


def turned(box, first, second, *words, wanted=0):
    return against(box, LATHE_HEAD + first + "M30\n", LATHE_HEAD + second + "M30\n", *words, wanted=wanted, stock="bar:50,-80,0",
                   machine="lathe2", tools=TURNING_TOOL)


@test("against: what two programs turn in other passes is the same, and a seat that is too thin is found")
def turned_alike(box):
    report = turned(box, IN_TWO, IN_ONE)
    same(report, "turned")
    equal(report["model"]["kind"], "profile", "kind")
    found = differs(turned(box, IN_TWO, IN_ONE.replace("X40.", "X39.6"), wanted=1), "thin")
    near(found["max_mm"], 0.2, 1e-9, "radius")
    ring = math.pi * (20 ** 2 - 19.8 ** 2) * 20
    near(found["only_here_mm3"], ring, 0.03 * ring, "volume")
    equal([line["line"] for line in found["regions"][0]["lines"]][:1], [9], "its line")
    check({line["line"] for line in found["regions"][0]["lines_there"]} <= {5, 6, 7}, "those there")
    near(found["regions"][0]["at"]["X"], 39.8, 0.2 + 1e-9, "X is a diameter, of one of the two")


SHEET_HEAD = "O1\nG90G54\n"


def burnt(box, first, second, *words, wanted=0):
    return against(box, SHEET_HEAD + first + "M05\nM30\n", SHEET_HEAD + second + "M05\nM30\n", "--decimal-point", "calculator",
                   "--kerf", "0.2", *words, wanted=wanted, stock="sheet:-10,-10,30,30,2", machine="laser3", tools="")


ROUND = "G00X0Y0\nM03S1000\nG01X20.F1500\nY20.\nX0\nY0\n"
# From another corner, the other way round, one side in two parts.
OTHER_WAY = "G00X20.Y20.\nM03S1000\nG01Y7.F900\nY0\nX0\nY20.\nX20.\n"


@test("against: the outline that two programs burn from other corners is the same, and a shorter side is found")
def burnt_alike(box):
    report = burnt(box, ROUND, OTHER_WAY)
    same(report, "burnt")
    equal(report["model"]["kind"], "sheet", "kind")
    found = differs(burnt(box, ROUND, OTHER_WAY.replace("X0", "X1."), wanted=1), "shorter")
    equal((found["regions_here"], found["regions_there"]), (1, 1), "its cut is at another place")
    for key in ("only_here_mm3", "only_there_mm3"):
        check(20 * 0.2 * 2 * 0.9 < found[key] < 20 * 0.2 * 2 * 1.4, f"{key} is the side: {found[key]}")
    here = [region for region in found["regions"] if region["kind"] == "only_there"][0]
    check(8 in [line["line"] for line in here["lines"]], f"the side of this one: {here['lines']}")


@test("against: a part that was saved is compared as another program's is, on each machine")
def saved(box):
    box.write("tools.toml", FACE)
    for model in ("zmap", "tridexel"):
        words = ("--stock", STOCK, "--tools", "tools.toml", "--model", model, "--report", "r.json")
        box.write("a.nc", HEAD + FORTH + TAIL)
        status(box.kerf("stock", "a.nc", *words, "--cell", "0.25", "--save", "a.kstock"), 0)
        box.write("b.nc", HEAD + BACK + TAIL)
        status(box.kerf("stock", "b.nc", *words, "--against", "a.kstock"), 0)
        same(box.json("r.json"), "the cells are those of the part")
        equal("status" in box.json("r.json")["against"], False, "nothing has run")
        box.write("b.nc", HEAD + faced("1.2") + TAIL)
        status(box.kerf("stock", "b.nc", *words, "--against", "a.kstock"), 1)
        near(differs(box.json("r.json"), model)["only_there_mm3"], 240, 1e-3, model)
    turned(box, IN_TWO, IN_ONE, "--save", "t.kstock")
    words = ("stock", "b.nc", "--machine", "lathe2", "--stock", "bar:50,-80,0", "--tools", "tools.toml", "--report", "r.json")
    status(box.kerf(*words, "--against", "t.kstock"), 0)
    same(box.json("r.json"), "turned")
    burnt(box, ROUND, OTHER_WAY, "--save", "s.kstock")
    words = ("stock", "b.nc", "--machine", "laser3", "--stock", "sheet:-10,-10,30,30,2", "--decimal-point", "calculator",
             "--kerf", "0.2", "--report", "r.json")
    status(box.kerf(*words, "--against", "s.kstock"), 0)
    same(box.json("r.json"), "burnt")


@test("against: threads share the work and change no byte, of the coloured part neither")
def threads(box):
    for model in ("zmap", "tridexel"):
        seen = set()
        for jobs in ("1", "2", "5"):
            milled(box, FORTH, faced("1.2"), "--model", model, "--jobs", jobs, "--glb", "part.glb", wanted=1)
            seen.add((box.read("r.json"), box.read("part.glb")))
        equal(len(seen), 1, model)


@test("against: the GLB has how far every point is from the other part, unless there is a design")
def colours(box):
    milled(box, FORTH, faced("1.2"), "--glb", "part.glb", wanted=1)
    data = box.read("part.glb")
    size = struct.unpack_from("<I", data, 12)[0]
    document, binary = json.loads(data[20:20 + size]), data[20 + size + 8:]
    has = document["meshes"][0]["primitives"][0]["attributes"]
    points = accessor(document, binary, has["POSITION"], "<3f")
    deviations = accessor(document, binary, has["_DEVIATION"], "<f")
    tops = [d for (x, y, z), (d,) in zip(points, deviations, strict=True) if z > -1.1 and 1 < x < 39 and 1 < y < 29]
    check(len(tops) > 0, "points of the face")
    for deviation in tops:
        near(deviation, 0.2, 1e-4, "the face")


@test("against: an alarm of the other program is told, with what it had cut by then, and is the exit status")
def other_alarm(box):
    report = milled(box, FORTH, FORTH.replace("X55.\n", "X55.\nG02X1.R0.1\n", 1), "--fail-on", "never", wanted=1)
    equal((report["status"], report["against"]["status"]), ("end", "alarm"), "ended")
    err = box.kerf("stock", "a.nc", "--stock", STOCK, "--tools", "tools.toml", "--against", "b.nc", "--fail-on", "never").err
    contains(err, "b.nc:", "the alarm")
    contains(err, "against b.nc (alarm): ", "the summary")


@test("against: the summary for people has a line of it, and both it and a design may be asked for")
def for_people(box):
    milled(box, FORTH, faced("1.2"), wanted=1)
    words = ("stock", "a.nc", "--stock", STOCK, "--tools", "tools.toml", "--cell", "0.25", "--against")
    contains(box.kerf(*words, "b.nc").err, "against b.nc: 240.0 mm³ only here, 0.0 mm³ only there, 0.200 mm at most, 1 region beyond 0.05",
             "summary")
    contains(box.kerf(*words, "-", stdin=box.read("a.nc")).err, "against -: 0.0 mm³ only here, 0.0 mm³ only there, 0.000 mm at most, within 0.05",
             "the same from standard input")


@test("against: a workpiece in a comment of the other program is told not to count")
def other_stock(box):
    piece = "(WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-{},XMAX=40,YMAX=30,ZMAX=0)\n"
    box.write("a.nc", "O1\n" + piece.format(20) + HEAD[3:] + FORTH + TAIL)
    box.write("b.nc", "O1\n" + piece.format(30) + HEAD[3:] + BACK + TAIL)
    box.write("tools.toml", FACE)
    status(box.kerf("stock", "a.nc", "--tools", "tools.toml", "--cell", "0.25", "--against", "b.nc", "--report", "r.json"), 0)
    same(box.json("r.json"), "the piece is that of the first")
    check(any("the stock of b.nc is that of a.nc" in a["what"] for a in box.json("r.json")["assumed"]), "told")


@test("against: what is no program for this machine, no part of this piece, or nothing at all is a sentence")
def wrong(box):
    milled(box, FORTH, BACK, "--save", "a.kstock")
    box.write("lathe.nc", LATHE_HEAD + IN_ONE + "G71U1.R1.\nM30\n")
    box.write("design.stl", "solid design\nendsolid design\n")
    data = box.read("a.kstock")
    box.write("cut.kstock", data[:len(data) // 2])
    words = ("stock", "a.nc", "--stock", STOCK, "--tools", "tools.toml", "--cell", "0.25")
    refused(box.kerf(*words, "--against", "none.nc"), 3, "none.nc")
    refused(box.kerf(*words, "--against", "cut.kstock"), 3, "cut.kstock")
    refused(box.kerf(*words, "--against", "design.stl"), 2, "--design")
    refused(box.kerf(*words, "--against", "a.nc"), 2, "itself")
    refused(box.kerf("stock", "-", "--stock", STOCK, "--against", "-", stdin=b"M30\n"), 2, "standard input")
    refused(box.kerf(*words, "--against", "lathe.nc"), 2, "lathe.nc", "lathe2", "mill3")
    refused(box.kerf(*words, "--against-tools", "tools.toml"), 2, "--against-tools")
    refused(box.kerf(*words, "--against", "a.kstock", "--against-tools", "tools.toml"), 2, "--against-tools", "no program")
    refused(box.kerf(*words, "--against", "b.nc", "--against-tools", "none.toml"), 3, "none.toml")
    refused(box.kerf(*words, "--against", "b.nc", "--report", "b.nc"), 2, "b.nc")
    refused(box.kerf(*words, "--against", "b.nc", "--stl", "b.nc"), 2, "b.nc")
    words = ("stock", "b.nc", "--tools", "tools.toml", "--against", "a.kstock", "--stock")
    refused(box.kerf(*words, "box:0,0,-20,40,30,1"), 3, "cut from a piece", "Z -20 to 0", "Z -20 to 1")
    box.write("turn.nc", LATHE_HEAD + IN_ONE + "M30\n")
    box.write("turning.toml", TURNING_TOOL)
    lathe = ("stock", "turn.nc", "--machine", "lathe2", "--stock", "bar:50,-80,0", "--tools", "turning.toml")
    refused(box.kerf(*lathe, "--model", "profile", "--against", "a.kstock"), 3, "a.kstock", "a milled part", "lathe2")
    status(box.kerf(*lathe, "--save", "t.kstock"), 0)
    refused(box.kerf(*words[:-3], "--stock", STOCK, "--against", "t.kstock"), 3, "t.kstock", "a turned part", "mill3")
