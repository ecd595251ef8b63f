"""kerf stock: parts against closed formulas, what is found and what is not, the report, wrong words."""

import math

from harness import contains, equal, near, refused, status, test

FLAT = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 10\n'
HEAD = "O1\nT1M06\nS3000M03\nG90G54"
TAIL = "\nG00Z50.\nM30\n"


def cut(box, moves, *words, stock="box:0,0,-20,70,40,0", tools=FLAT, machine="mill3", wanted=0):
    """The report of a program of these moves."""
    box.write("part.nc", HEAD + moves + TAIL)
    box.write("tools.toml", tools)
    result = box.kerf("stock", "part.nc", "--machine", machine, "--stock", stock, "--tools", "tools.toml",
                      "--report", "r.json", "--diagnostics", "json", *words)
    status(result, wanted)
    return box.json("r.json")


def found(report):
    return [(f["code"], f["line"]) for f in report["findings"]]


SLOT = "G00X10.Y20.Z5.\nG01Z-5.F300\nX60.F600"
SLOT_MM3 = 10 * 50 * 5 + math.pi * 25 * 5


@test("stock: a slot has the volume of its formula with both models")
def slot(box):
    for model, cell in (("zmap", "0.1"), ("tridexel", "0.25")):
        report = cut(box, SLOT, "--model", model, "--cell", cell)
        near(report["removed_mm3"], SLOT_MM3, 0.05 * float(cell) * SLOT_MM3, model)
        near(report["removed_mm3"] + report["left_mm3"], 70 * 40 * 20, 1e-6, "together")
        equal(report["model"]["kind"], model, "kind")
        equal(report["findings"], [], "findings")


@test("stock: a T-slot cutter is cut with dexels, whatever was begun with")
def undercut(box):
    tools = FLAT.replace("10", "8") + ('[[tool]]\nnumber = 2\ntype = "t-slot"\ndiameter = 16\nwidth = 4\n'
                                       'neck_diameter = 7\n')
    way = "G00X-15.Y20.Z5.\nG01Z-10.F300\nX75.F600\nG00Z5.\n"
    moves = way + "T2M06\nS3000M03\n" + way.rstrip()
    report = cut(box, moves, "--cell", "0.25", stock="box:0,0,-30,60,40,0", tools=tools)
    near(report["removed_mm3"], 6720, 0.07, "removed")
    equal(report["model"]["kind"], "tridexel", "kind")
    equal(found(report), [], "findings")


@test("stock: a table turns the work: two holes across each other")
def cross_holes(box):
    tools = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 20\nflute_length = 50\n'
    moves = "G00X0Y0Z45.A0\nG00Z45.\nG01Z-25.F300\nG00Z45.\nG00A90.\nG00Z45.\nG01Z-25.F300"
    report = cut(box, moves, "--cell", "0.5", "--machine-set", "kinematics.primary_point=0,0,0",
                 stock="box:-20,-20,-20,20,20,20", tools=tools, machine="mill4")
    wanted = 2 * math.pi * 100 * 40 - 16 / 3 * 1000
    near(report["removed_mm3"], wanted, 0.025 * wanted, "removed")


@test("stock: a rapid along a cut slot is none of the findings, one beside it is")
def rapids(box):
    equal(found(cut(box, SLOT + "\nG00X10.\nZ5.", "--cell", "0.1")), [], "along")
    report = cut(box, SLOT + "\nG01Z5.\nG00Y21.\nZ-5.\nX10.", "--cell", "0.1", wanted=1)
    equal(found(report), [("RAPID_IN_STOCK", 9), ("RAPID_IN_STOCK", 10)], "beside")
    equal(report["counts"], {"RAPID_IN_STOCK": 2}, "counts")
    first = report["findings"][0]
    equal((first["severity"], first["program"], first["tool"], first["count"]), ("error", "O0001", 1, 1), "finding")
    near(first["depth_mm"], 5, 0.02, "depth")


@test("stock: each check has a program that raises it and a twin that must not")
def checks(box):
    long = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 10\nflute_length = 20\nstickout = {}\n{}'
    deep = "box:0,0,-60,60,60,0"
    thin = "shank = [ {height = 40, diameter = 10} ]"
    holder = "holder = [ {height = 50, diameter = 40} ]"
    stopped = "G00X10.Y20.Z5.\nM05\nG01Z-5.F300"
    side = "G00X15.Y20.Z5.\nG01Z-{}F100\nX44.F200"
    face = '[[tool]]\nnumber = 1\ntype = "face"\ndiameter = 30\n'
    drill = '[[tool]]\nnumber = 1\ntype = "drill"\ndiameter = 6\n'
    probe = '[[tool]]\nnumber = 1\ntype = "probe"\ndiameter = 4\n'
    cases = (
        ("SPINDLE_STOPPED", stopped, FLAT, deep, ()),
        (None, stopped.replace("M05", "M03"), FLAT, deep, ()),
        ("SPINDLE_DIRECTION", stopped.replace("M05", "M04"), FLAT, deep, ()),
        (None, stopped.replace("M05", "M04"), FLAT + 'hand = "left"\n', deep, ()),
        ("FLUTE_LENGTH", side.format("26."), long.format(60, thin), deep, ()),
        (None, side.format("18."), long.format(60, thin), deep, ()),
        ("SHANK_COLLISION", side.format("26."), long.format(60, thin.replace("10", "12")), deep, ()),
        ("HOLDER_COLLISION", "G00X30.Y30.Z5.\nG01Z-35.F100", long.format(30, holder), deep, ()),
        (None, "G00X30.Y30.Z5.\nG01Z-15.F100", long.format(30, holder), deep, ()),
        ("FIXTURE_COLLISION", "G00X10.Y15.Z25.\nG01Z-2.F300\nG00Z10.\nX90.Y45.", FLAT, deep,
         ("--fixture", "box:40,30,0,60,50,15")),
        (None, "G00X10.Y15.Z25.\nG01Z-2.F300\nG00Z16.\nX90.Y45.", FLAT, deep,
         ("--fixture", "box:40,30,0,60,50,15")),
        ("NOT_CENTRE_CUTTING", "G00X30.Y30.Z5.\nG01Z-1.F100", face, deep, ()),
        (None, "G00X-30.Y30.Z5.\nG01Z-1.F100\nX90.", face, deep, ()),
        ("AXIAL_TOOL_SIDEWAYS", side.format("5."), drill, deep, ()),
        (None, "G00X15.Y20.Z5.\nG01Z-5.F100\nG00Z5.\nX44.", drill, deep, ()),
        ("PROBE_IN_STOCK", "G00X15.Y20.Z5.\nG01Z-1.F100", probe, deep, ()),
        (None, "G00X15.Y20.Z5.\nG01Z0.F100", probe, deep, ()),
        ("STOCK_MISSED", "G00X115.Y20.Z5.\nG01Z-1.F100", FLAT, deep, ()),
    )
    for code, moves, tools, stock, words in cases:
        box.write("tools.toml", tools)
        report = cut(box, moves, "--cell", "0.2", *words, stock=stock, tools=tools, wanted=0 if code is None else 1)
        codes = {c for c, _ in found(report)}
        if code == "FLUTE_LENGTH":
            codes -= {"SHANK_COLLISION"}  # the thin shank goes as deep
        if code == "SHANK_COLLISION":
            codes -= {"FLUTE_LENGTH"}
        equal(codes, set() if code is None else {code}, moves)


@test("stock: a check can be left out, and what fails is a choice")
def choices(box):
    moves = "G00X10.Y20.Z5.\nM05\nG01Z-5.F300"
    equal(found(cut(box, moves, "--no-check", "SPINDLE_STOPPED")), [], "left out")
    equal(len(found(cut(box, moves, "--fail-on", "never"))), 1, "never")
    missed = "G00X115.Y20.Z5.\nG01Z-1.F100"
    equal(len(found(cut(box, missed, "--fail-on", "error"))), 1, "a warning")
    cut(box, missed, wanted=1)


@test("stock: what is not said is told: stock, zero, tool")
def assumed(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    status(box.kerf("stock", "part.nc", "--report", "r.json"), 0)
    report = box.json("r.json")
    equal(report["stock"]["zero"], "G54", "zero")
    equal(report["stock"]["extents"], {"X": [2, 68], "Y": [12, 28], "Z": [-10, 0]}, "stock")
    equal(report["tools"][0]["source"], "assumed", "tool")
    texts = " ".join(a["what"] for a in report["assumed"])
    contains(texts, "box around", "stock")
    contains(texts, "T1", "tool")


@test("stock: the zero of the stock is the work system of the first cut")
def zero(box):
    text = ("O1\nT1M06\nS3000M03\nG10L2P2X100.Y50.Z-130.\nG90G55G00X10.Y20.Z5.\nG01Z-5.F300\nX60.F600" + TAIL)
    box.write("part.nc", text)
    box.write("tools.toml", FLAT)
    for words in ((), ("--stock-zero", "G55")):
        status(box.kerf("stock", "part.nc", "--stock", "box:0,0,-20,70,40,0", "--tools", "tools.toml",
                        "--cell", "0.1", "--report", "r.json", *words), 0)
        report = box.json("r.json")
        equal(report["stock"]["zero"], "G55", "zero")
        equal(report["stock"]["origin"], {"X": 100, "Y": 50, "Z": -130}, "origin")
        near(report["removed_mm3"], SLOT_MM3, 16, "removed")


@test("stock: a zero that moves behind the first cut is told")
def zero_moves(box):
    report = cut(box, SLOT + "\nG10L2P1X1.\nG01X50.", wanted=1)
    equal(found(report), [("STOCK_ZERO_MOVED", 8)], "findings")


@test("stock: before the first tool change there is no tool, and a program without one has T0")
def no_tool(box):
    box.write("part.nc", "O1\nS3000M03\nG90G54" + SLOT + TAIL)
    status(box.kerf("stock", "part.nc", "--stock", "box:0,0,-20,70,40,0", "--cell", "0.1", "--report", "r.json"), 0)
    equal([t["tool"] for t in box.json("r.json")["tools"]], [0], "T0")
    box.write("part.nc", "O1\nS3000M03\nG90G54G00X10.Y20.Z5.\nG01Z-5.F300\nG00Z5.\nT1M06\nM03\nG01Z-3." + TAIL)
    status(box.kerf("stock", "part.nc", "--stock", "box:0,0,-20,70,40,0", "--cell", "0.1", "--report", "r.json"), 0)
    equal([t["tool"] for t in box.json("r.json")["tools"]], [1], "T1 alone")


@test("stock: threads share the work and change no byte of the report")
def threads(box):
    reports = []
    for model in ("zmap", "tridexel"):
        for jobs in ("1", "2", "7"):
            cut(box, SLOT + "\nG02X40.Y10.R30.", "--jobs", jobs, "--model", model, "--cell", "0.2")
            reports.append(box.read("r.json"))
        equal(len(set(reports)), 1, model)
        reports.clear()


@test("stock: cells that do not fit into the memory are enlarged, and told")
def memory(box):
    report = cut(box, SLOT, "--cell", "0.000001", "--memory", "16", wanted=1)
    equal([c for c, _ in found(report)], ["CELL_ENLARGED"], "told")
    assert report["model"]["bytes"] <= 16 << 20, report["model"]


@test("stock: a program on standard input is kept for a second pass")
def standard_input(box):
    text = (HEAD + SLOT + TAIL).encode()
    status(box.kerf("stock", "-", "--report", "r.json", stdin=text), 0)
    near(box.json("r.json")["removed_mm3"], 6 * 50 * 5 + math.pi * 9 * 5, 20, "removed")


@test("stock: wrong words are sentences")
def wrong(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    for words in (("--stock", "box:0,0,0,0,1,1"), ("--stock", "box:1,2,3"), ("--stock", "cylinder:Q,0,0,0,1,2"),
                  ("--stock", "tube:Z,0,0,0,1,2,3"), ("--stock", "extents:-1"), ("--stock", "bar:10,-5,0"),
                  ("--stock", "sheet:0,0,1,1,1"), ("--stock-zero", "G60"),
                  ("--cell", "0"), ("--cell", "x"), ("--fixture", "bar:1,2,3"), ("--model", "voxel")):
        refused(box.kerf("stock", "part.nc", *words), 2, words[0])
    box.write("tools.toml", '[[tool]]\nnumber = 1\ntype = "bull"\ndiameter = 4\ncorner_radius = 3\n')
    refused(box.kerf("stock", "part.nc", "--tools", "tools.toml"), 3, "tools.toml:5")
    refused(box.kerf("stock", "part.nc", "--stock", "nothing.stl"), 3, "nothing.stl")


@test("stock: behind an alarm the part is as it was cut, and the status says so")
def alarm(box):
    box.write("part.nc", HEAD + SLOT + "\nG01X#9999999" + TAIL)
    box.write("tools.toml", FLAT)
    status(box.kerf("stock", "part.nc", "--tools", "tools.toml", "--stock", "box:0,0,-20,70,40,0", "--cell", "0.1",
                    "--report", "r.json"), 1)
    report = box.json("r.json")
    equal(report["status"], "alarm", "status")
    near(report["removed_mm3"], SLOT_MM3, 16, "removed")


@test("stock: a check never rests on what is assumed, and says so")
def not_checked(box):
    moves = SLOT + "\nG01Z5.\nG00Y21.\nZ-5.\nX10."
    equal(found(cut(box, moves, wanted=1)), [("RAPID_IN_STOCK", 9), ("RAPID_IN_STOCK", 10)], "described")
    for words, what in (((), "the stock is assumed"), (("--stock", "box:0,0,-20,70,40,0"), "the shape of T1 is assumed")):
        tools = ("--tools", "tools.toml") if not words else ()
        status(box.kerf("stock", "part.nc", "--report", "r.json", *words, *tools), 0)
        report = box.json("r.json")
        equal(report["findings"], [], "findings")
        contains(" ".join(report["not_checked"]), "RAPID_IN_STOCK: " + what, "told")
    contains(" ".join(report["not_checked"]), "HOLDER_COLLISION: T1 has no holder", "holder")


@test("stock: what a machine cannot cut is refused")
def other_machines(box):
    box.write("part.nc", "O1\nT0101\nG97S500M03\nG00X20.Z2.\nG01Z-5.F.2\nM30\n")
    refused(box.kerf("stock", "part.nc", "--machine", "arm4"), 2, "mills, lathes and lasers")


@test("stock: a bar is turned, and what is assumed of the default one begins before the face")
def lathe(box):
    box.write("part.nc", "O1\nT0101\nG97S1000M03\nG00X54.Z2.\nX40.\nG01Z-60.F.2\nX52.\nG00X200.Z100.\nM30\n")
    box.write("tools.toml", '[[tool]]\nnumber = 1\ntype = "turning"\ninsert = "CNMG120408"\nnose_radius = 0\n'
                            'ic = 40\nkapr = 95\ntip = 3\n')
    status(box.kerf("stock", "part.nc", "--machine", "lathe2", "--tools", "tools.toml", "--stock", "bar:50,-80,0",
                    "--report", "r.json"), 0)
    report = box.json("r.json")
    near(report["removed_mm3"], 42411.5008, 0.05, "removed")  # π (25² - 20²) 60
    equal(report["model"]["kind"], "profile", "model")
    status(box.kerf("stock", "part.nc", "--machine", "lathe2", "--tools", "tools.toml", "--report", "r.json"), 0)
    equal(box.json("r.json")["stock"]["extents"]["Z"], [-65, 1], "default bar")
