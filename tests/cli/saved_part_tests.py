"""--save and --stock FILE.kstock: two programs in a row cut what one would, clamped anew or not; and what is refused."""

import math

from harness import contains, equal, near, refused, status, test
from stock_tests import FLAT, HEAD, TAIL, cut, found

BOX = "box:0,0,-20,70,40,0"
FIRST = "G00X10.Y20.Z5.\nG01Z-5.F300\nX60.F600\nG00Z5."
SECOND = "G00X10.Y12.Z5.\nG01Z-3.F300\nX50.Y30.F600"
ALL = ("left_mm3", "extents", "pieces")


def second(box, moves, *words, part="p.kstock", wanted=0):
    return cut(box, moves, *words, stock=part, wanted=wanted)


@test("saved part: what is cut in two programs is what one program cuts, with heights and with dexels")
def in_two_programs(box):
    for model in ("zmap", "tridexel"):
        words = ("--model", model, "--cell", "0.2")
        whole = cut(box, FIRST + "\n" + SECOND, *words, "--stl", "whole.stl", stock=BOX)
        first = cut(box, FIRST, *words, "--save", "p.kstock", stock=BOX)
        report = second(box, SECOND, "--stl", "parts.stl", *words)
        near(report["stock"]["volume_mm3"], first["left_mm3"], 0, "volume of the stock")
        equal(report["extents"], whole["extents"], "extents")
        within = 1e-6 if model == "zmap" else whole["model"]["error_mm3"]  # each run counts by its best grid
        near(report["left_mm3"], whole["left_mm3"], within, "left")
        near(report["removed_mm3"], first["left_mm3"] - report["left_mm3"], 1e-6, "removed by this run")
        equal(report["model"]["kind"], model, "model")
        equal(report["model"]["cell_mm"], whole["model"]["cell_mm"], "cells")
        equal(box.read("parts.stl"), box.read("whole.stl"), "the surface, byte by byte")


@test("saved part: a program that cuts nothing saves the same part again, whatever the number of threads")
def again(box):
    for model in ("zmap", "tridexel"):
        files = []
        for jobs in ("1", "3"):
            cut(box, FIRST, "--model", model, "--cell", "0.25", "--jobs", jobs, "--save", "p.kstock", stock=BOX)
            files.append(box.read("p.kstock"))
        equal(files[0] == files[1], True, "threads")
        report = second(box, "G00X0Y0Z100.", "--save", "again.kstock", "--model", model)
        equal(report["left_mm3"], report["stock"]["volume_mm3"], "volume")
        tiles = [data[data.index(b"}") + 1:-4] for data in (files[0], box.read("again.kstock"))]
        equal(tiles[0] == tiles[1], True, "tiles")


@test("saved part: turned by 180 degrees it is cut from behind")
def behind(box):
    for model in ("zmap", "tridexel"):
        words = ("--model", model, "--cell", "0.2")
        first = cut(box, FIRST, *words, "--save", "p.kstock", stock=BOX)
        # The slot lies below now, from Z-20 to Z-15; a hole from above meets it.
        report = second(box, "G00X30.Y20.Z5.\nG01Z-17.F100", *words, "--stock-place", "0,40,-20,180,0,0")
        near(report["stock"]["volume_mm3"], first["left_mm3"], 1e-9, "stock")
        near(report["removed_mm3"], math.pi * 25 * 15, 0.01 * math.pi * 25 * 15, model)
        equal(report["extents"], {"X": [0, 70], "Y": [0, 40], "Z": [-20, 0]}, "extents")
        equal(found(report), [], "findings")


@test("saved part: on its side a height field becomes dexels, at other angles its surface is sampled anew, and both are told")
def other_places(box):
    first = cut(box, FIRST, "--cell", "0.5", "--save", "p.kstock", stock=BOX)
    for place, kind, told in (("0,0,0,90,0,0", "tridexel", None), ("0,0,0,0,0,45", None, "sampled anew"),
                              ("0,0,0,30,0,0", "tridexel", "sampled anew")):
        report = second(box, "G00X0Y0Z100.", "--stock-place", place)
        near(report["left_mm3"], first["left_mm3"], 1e-6, place)
        equal(report["model"]["kind"], kind or report["model"]["kind"], "model")
        texts = " ".join(a["what"] for a in report["assumed"])
        if told:
            contains(texts, told, place)


@test("saved part: a T-slot cutter makes dexels of a height field, and says so")
def converted(box):
    through = "G00X-15.Y20.Z5.\nG01Z-5.F300\nX85.F600\nG00Z5."
    cut(box, through, "--cell", "0.25", "--save", "p.kstock", stock=BOX)
    tools = FLAT + '[[tool]]\nnumber = 2\ntype = "t-slot"\ndiameter = 16\nwidth = 2\nneck_diameter = 7\n'
    moves = "G00Z50.\nT2M06\nS1000M03\nG00X-15.Y20.Z5.\nG01Z-5.F300\nX85.F600"
    report = cut(box, moves, stock="p.kstock", tools=tools)
    equal(report["model"]["kind"], "tridexel", "model")
    contains(" ".join(a["what"] for a in report["assumed"]), "became dexels", "told")
    near(report["removed_mm3"], 2 * 2 * 3 * 70, 1e-3, "3 on either side of the slot, 2 high")


@test("saved part: smaller cells are sampled anew, larger ones are not asked for")
def cells(box):
    cut(box, FIRST, "--cell", "0.5", "--save", "p.kstock", stock=BOX)
    report = second(box, SECOND, "--cell", "2")
    equal(report["model"]["cell_mm"], [0.5, 0.5], "as saved")
    report = second(box, SECOND, "--cell", "0.25")
    equal(report["model"]["cell_mm"][:2], [0.25, 0.25], "finer")
    contains(" ".join(a["what"] for a in report["assumed"]), "sampled anew", "told")


@test("saved part: a turned part is turned round and cut from its other end; a mill takes it, too")
def lathe(box):
    tools = ('[[tool]]\nnumber = 1\ntype = "turning"\ninsert = "CNMG120408"\nnose_radius = 0\nic = 40\nkapr = 95\ntip = 3\n')
    head = "O1\nT0101\nG97S1000M03\n"
    box.write("tools.toml", tools)
    box.write("one.nc", head + "G00X54.Z2.\nX40.\nG01Z-30.F.2\nX52.\nG00X200.Z100.\nM30\n")
    box.write("two.nc", head + "G00X54.Z2.\nX44.\nG01Z-20.F.2\nX52.\nG00X200.Z100.\nM30\n")
    words = ("--machine", "lathe2", "--tools", "tools.toml", "--report", "r.json")
    status(box.kerf("stock", "one.nc", *words, "--stock", "bar:50,-80,0", "--save", "p.kstock"), 0)
    first = box.json("r.json")
    status(box.kerf("stock", "two.nc", *words, "--stock", "p.kstock", "--stock-place", "0,0,-80,180,0,0"), 0)
    report = box.json("r.json")
    near(report["removed_mm3"], math.pi * (25 ** 2 - 22 ** 2) * 20, 1e-6, "removed")
    near(report["stock"]["volume_mm3"], first["left_mm3"], 0, "stock")
    equal(report["extents"]["Z"], [-80, 0], "extents")
    box.write("flat.toml", FLAT)
    box.write("flat.nc", HEAD + "G00X0Y0Z5.\nG01Z-10.F100" + TAIL)
    status(box.kerf("stock", "flat.nc", "--tools", "flat.toml", "--stock", "p.kstock", "--cell", "0.25",
                    "--report", "r.json"), 0)
    report = box.json("r.json")
    near(report["removed_mm3"], math.pi * 25 * 10, 0.02 * math.pi * 250, "a hole in its face")
    contains(" ".join(a["what"] for a in report["assumed"]), "sampled anew", "told")


@test("saved part: driven tools mill a part that was turned before, and what they leave is kept")
def turned_and_milled(box):
    box.write("tools.toml", '[[tool]]\nnumber = 1\ntype = "turning"\ninsert = "CNMG120408"\nnose_radius = 0\nic = 40\nkapr = 95\n'
                            'tip = 3\n[[tool]]\nnumber = 2\ntype = "drill"\ndiameter = 6\nflute_length = 40\n')
    box.write("one.nc", "O1\nT0101\nG97S1000M03\nG00X54.Z2.\nX40.\nG01Z-30.F.2\nX52.\nG00X200.Z100.\nM30\n")
    box.write("two.nc", "O2\nT0202\nG97S1000M133\nG00X20.Z2.C0.\nG01Z-10.F.1\nG00Z5.\nM30\n")
    words = ("--machine", "lathe3c", "--tools", "tools.toml", "--report", "r.json", "--fail-on", "error")
    status(box.kerf("stock", "one.nc", *words, "--stock", "bar:50,-80,0", "--save", "p.kstock"), 0)
    first = box.json("r.json")
    status(box.kerf("stock", "two.nc", *words, "--stock", "p.kstock", "--cell", "0.25", "--save", "q.kstock"), 0)
    report = box.json("r.json")
    near(report["stock"]["volume_mm3"], first["left_mm3"], 0, "stock")
    hole = math.pi * 9 * (10 - 2 * 3 / math.tan(math.radians(59)) / 3)  # its point is a cone
    near(report["removed_mm3"], hole, 0.02 * hole, "hole")
    box.write("flat.toml", FLAT)
    box.write("flat.nc", HEAD + "G00X0Y0Z100." + TAIL)
    status(box.kerf("stock", "flat.nc", "--tools", "flat.toml", "--stock", "q.kstock", "--report", "s.json"), 0)
    near(box.json("s.json")["left_mm3"], report["left_mm3"], 0, "on a mill")


@test("saved part: a sheet is cut on, and what was cut before counts once")
def sheets(box):
    square = "O3\nG90G54\nG00X{0}Y0\nM03S1000\nG01X{1}F1500\nY20.\nX{0}\nY0\nM05\nM30\n"
    box.write("one.nc", square.format("0", "20."))
    box.write("two.nc", square.format("10.", "30."))
    words = ("--machine", "laser3", "--kerf", "0.2", "--report", "r.json")
    status(box.kerf("stock", "one.nc", *words, "--stock", "sheet:-5,-5,35,25,2", "--save", "p.kstock"), 0)
    first = box.json("r.json")
    status(box.kerf("stock", "two.nc", *words, "--stock", "p.kstock", "--profile", "left.csv"), 0)
    report = box.json("r.json")
    near(report["stock"]["volume_mm3"], first["left_mm3"], 0, "stock")
    # Two of its sides lie in the first square's sides for 10 mm each, and two cross them.
    near(report["sheet"]["cut_mm2"], first["sheet"]["cut_mm2"] - 2 * 10 * 0.2, 0.1, "cut by this run")
    equal(len(report["sheet"]["pieces"]), 4, "pieces")
    near(sum(p["area_mm2"] for p in report["sheet"]["pieces"]) * 2, report["left_mm3"], 1e-6, "pieces make what is left")
    equal(len({line.split(",")[0] for line in box.read("left.csv").decode().splitlines()[1:]}) > 0, True, "outline")
    refused(box.kerf("stock", "two.nc", *words, "--stock", "p.kstock", "--stock-place", "0,0,0,180,0,0"), 2, "sheet")


@test("saved part: after an alarm nothing is saved but on demand, and what was there stays")
def alarm(box):
    box.write("part.nc", HEAD + FIRST + "\nG01X#9999999" + TAIL)
    box.write("tools.toml", FLAT)
    box.write("p.kstock", "what was there")
    words = ("stock", "part.nc", "--tools", "tools.toml", "--stock", BOX, "--cell", "0.5", "--save", "p.kstock", "--report",
             "r.json")
    result = box.kerf(*words)
    status(result, 1)
    contains(result.err, "p.kstock was not written", "told")
    equal(box.read("p.kstock"), b"what was there", "the file")
    equal(box.json("r.json")["status"], "alarm", "the report is written")
    status(box.kerf(*words, "--keep-partial"), 1)
    equal(box.read("p.kstock")[:8], b"KSTOCK1\n", "partial")


@test("saved part: what is no such file, damaged, cut off or newer is refused with a sentence")
def damaged(box):
    cut(box, FIRST, "--cell", "1", "--save", "p.kstock", stock=BOX)
    data = box.read("p.kstock")
    box.write("part.nc", HEAD + SECOND + TAIL)
    middle = len(data) // 2
    for content, part in ((data[:-1], "cut off"), (data[:middle], "damaged"), (data + b"x", "follow"),
                          (data[:middle] + bytes([data[middle] ^ 1]) + data[middle + 1:], "damaged"),
                          (b"KSTOCK2\n" + data[8:], "newer"), (b"KSTOCK", "damaged")):
        box.write("wrong.kstock", content)
        for command in ("stock", "run"):
            refused(box.kerf(command, "part.nc", "--stock", "wrong.kstock"), 3, "wrong.kstock", part)
    refused(box.kerf("stock", "part.nc", "--fixture", "p.kstock"), 2, "--fixture")
    refused(box.kerf("stock", "part.nc", "--stock", "p.kstock", "--save", "p.kstock"), 2, "p.kstock")
    refused(box.kerf("stock", "part.nc", "--stock", "p.kstock", "--memory", "0"), 3, "0 MiB")
    refused(box.kerf("stock", "part.nc", "--machine", "laser3", "--stock", "p.kstock"), 2, "sheet")


@test("saved part: kerf run goes on with a part, and its probes meet it")
def probed(box):
    cut(box, FIRST, "--cell", "0.5", "--save", "p.kstock", stock=BOX)
    box.write("probe.toml", '[[tool]]\nnumber = 1\ntype = "probe"\ndiameter = 4\n')
    box.write("probe.nc", "O1\nT1M06\nG90G54G00X30.Y20.Z5.\nG31Z-15.F100\n#500=#5063\nG00Z50.\nM30\n")
    status(box.kerf("run", "probe.nc", "--tools", "probe.toml", "--stock", "p.kstock", "--summary", "s.json"), 0)
    near(box.json("s.json")["variables"]["#500"], -5, 1e-3, "the floor of the slot")
