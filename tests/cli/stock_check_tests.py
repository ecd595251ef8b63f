"""kerf stock: each check has a program that raises it and a twin that must not; cutting data, ends, paths."""

import csv
import math

from harness import contains, equal, near, refused, status, test

HEAD = "O1\nT1M06\nS3000M03\nG90G54"
TAIL = "\nG00Z50.\nM30\n"
FLAT = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 10\n'
MILL = FLAT + "flutes = 3\n"
SLOT = "G00X10.Y20.Z5.\nG01Z-5.F300\nX60.F900"
PLATE = "box:0,0,-20,70,40,0"


def cut(box, moves, *words, stock=PLATE, tools=FLAT, machine="mill3", wanted=0, head=HEAD, cell="0.2"):
    """The report of a program of these moves."""
    box.write("part.nc", head + moves + TAIL)
    box.write("tools.toml", tools)
    result = box.kerf("stock", "part.nc", "--machine", machine, "--stock", stock, "--tools", "tools.toml",
                      "--report", "r.json", "--diagnostics", "json", "--cell", cell, *words)
    status(result, wanted)
    return box.json("r.json")


def found(report):
    return [(f["code"], f["line"]) for f in report["findings"]]


def rows_of(box):
    return list(csv.DictReader(box.read("b.csv").decode().splitlines()))


@test("stock: each limit of a tool has a program that exceeds it and a twin within 2 %")
def limits(box):
    side = "G00X-10.Y{}Z5.\nG01Z-4.F300\nX80.F900"  # from outside: Y is the tool's middle
    for limit, code, moves, low, high in (
            ("fz", "FEED_PER_TOOTH", side.format("-1."), 0.097, 0.1),
            ("ap", "CUT_DEPTH", SLOT, 4.8, 5),
            ("ae", "CUT_WIDTH", side.format("-1."), 3.7, 4),
            ("vc", "CUTTING_SPEED", side.format("-1."), 92, 94.2)):
        for value, wanted in ((low, {code}), (high, set())):
            tools = MILL + f"limits = {{{limit} = {value}}}\n"
            report = cut(box, moves, tools=tools, wanted=1 if wanted else 0)
            equal({c for c, _ in found(report)}, wanted, f"{limit} {value}")
            equal({f["severity"] for f in report["findings"]}, {"warning"} if wanted else set(), "severity")


@test("stock: power is held against that of the spindle where machine and material tell it")
def power(box):
    words = ("--material", "P", "--machine-set")
    report = cut(box, SLOT, *words, "spindle.power_kw=2", tools=MILL, wanted=1)
    equal(found(report), [("CUTTING_POWER", 6)], "2 kW")
    equal(found(cut(box, SLOT, *words, "spindle.main.power_kw=2.6", tools=MILL)), [], "2.6 kW")
    report = cut(box, SLOT, tools=MILL)
    contains(" ".join(report["not_checked"]), "CUTTING_POWER: the material is not known", "told")
    report = cut(box, SLOT, "--material", "P", tools=MILL)
    contains(" ".join(report["not_checked"]), "CUTTING_POWER: the machine file has no spindle.power_kw", "told")
    report = cut(box, SLOT, *words, "spindle.power_kw=2")
    contains(" ".join(report["not_checked"]), "CUTTING_POWER: T1 has no flutes", "told")


@test("stock: a row of --blocks has the engagement, forces and the planner's times of its motion")
def blocks(box):
    moves = SLOT + "\nG00Z5.\nX-10.Y37.\nG01Z-5.F300\nX80.F900\nG00Z5.\nX80.Y3.\nG01Z-5.F300\nX-10.F900"
    cut(box, moves, "--material", "P", "--blocks", "b.csv", cell="0.1", tools=MILL)
    rows = rows_of(box)
    equal(list(rows[0]), ("motion,line,file,tool,kind,start_s,end_s,length_mm,removed_mm3,mrr_mm3_s,ae_mm,ap_mm,"
                          "phi_deg,side,fz_mm,hm_mm,vc_m_min,power_kw,torque_nm").split(","), "columns")
    by_line = {int(row["line"]): row for row in rows}
    slot = by_line[6]
    near(float(slot["ae_mm"]), 10, 1e-6, "ae")
    near(float(slot["ap_mm"]), 5, 1e-6, "ap")
    near(float(slot["phi_deg"]), 180, 1e-6, "phi")
    equal(slot["side"], "slot", "side")
    near(float(slot["hm_mm"]), 0.0636619772, 1e-8, "hm")
    near(float(slot["power_kw"]), 2.53828366, 0.02, "power")
    near(float(slot["torque_nm"]), float(slot["power_kw"]) * 30000 / math.pi / 3000, 1e-9, "torque")
    near(float(slot["mrr_mm3_s"]), 2500 / (float(slot["end_s"]) - float(slot["start_s"])), 1e-6, "rate")
    # Y37 leaves 37+5 > 40: 8 of 10 mm lie in the plate, going +X its material is on the right.
    for line, side in ((10, "climb"), (14, "climb")):
        row = by_line[line]
        near(float(row["ae_mm"]), 8, 1e-6, "ae")
        near(float(row["phi_deg"]), math.degrees(math.acos(1 - 2 * 8 / 10)), 1e-4, "phi")
        equal(row["side"], side, f"line {line}")
    for before, after in zip(rows, rows[1:]):
        assert float(before["end_s"]) <= float(after["start_s"]) + 1e-12, (before, after)
    near(float(rows[-1]["end_s"]), box.json("r.json")["time_s"], 0.002, "all of the time")


@test("stock: the rows are the same whatever holds the part and however many threads cut")
def same_rows(box):
    tables = []
    for model, jobs in (("zmap", "1"), ("zmap", "3"), ("tridexel", "1")):
        cut(box, SLOT, "--blocks", "b.csv", "--model", model, "--jobs", jobs, "--material", "P", tools=MILL)
        tables.append(rows_of(box))
    equal(tables[0], tables[1], "threads")
    for a, b in zip(tables[0], tables[2]):
        for key in ("ae_mm", "ap_mm", "phi_deg", "removed_mm3"):
            near(float(b[key] or 0), float(a[key] or 0), 0.02 * (1 + float(a[key] or 0)), f"{key} of {a['motion']}")


@test("stock: a drill's power is that of its feed and section")
def drilling(box):
    tools = '[[tool]]\nnumber = 1\ntype = "drill"\ndiameter = 10\nangle = 118\n'
    moves = "G81X30.Y20.Z-15.R2.F400"
    cut(box, moves, "--material", "P", "--blocks", "b.csv", tools=tools, head=HEAD.replace("3000", "2000"))
    row = [r for r in rows_of(box) if r["kind"] == "line"][0]
    near(float(row["power_kw"]), 1.64505774, 1e-6, "power")
    near(float(row["hm_mm"]), 0.1 * math.sin(math.radians(59)), 1e-9, "chip")


@test("stock: turning has depth, force and power of its half section")
def turning(box):
    box.write("part.nc", "O1\nT0101\nG96S200M03\nG50S4000\nG00X60.Z2.\nX55.\nG01Z-40.F.3\nX62.\nG00X200.Z100.\nM30\n")
    box.write("tools.toml", '[[tool]]\nnumber = 1\ntype = "turning"\ninsert = "CNMG120408"\nnose_radius = 0\n'
                            'ic = 40\nkapr = 95\ntip = 3\nlimits = {ap = 2, fz = 0.25}\n')
    status(box.kerf("stock", "part.nc", "--machine", "lathe2", "--tools", "tools.toml", "--stock", "bar:60,-80,0",
                    "--material", "P", "--blocks", "b.csv", "--report", "r.json"), 1)
    row = {int(r["line"]): r for r in rows_of(box)}[7]
    # Two millimetres of the way are in front of the bar, and the edge leans by 5 degrees.
    ap = (2.5 * 40 - 2.5 * 2.5 / 2 * math.tan(math.radians(5))) / 42
    near(float(row["ap_mm"]), ap, 1e-6, "ap")
    near(float(row["vc_m_min"]), 200, 1e-6, "vc")
    near(float(row["power_kw"]), 5.74807678 * ap / 2.5, 1e-5, "power")
    equal(box.json("r.json")["counts"], {"CUT_DEPTH": 1, "FEED_PER_TOOTH": 2}, "limits")


@test("stock: under G96 a cut to the axis is as fast as it is where it is widest")
def facing(box):
    box.write("part.nc", "O1\nT0101\nG50S2500\nG96S180M03\nG00X64.Z0.\nG01X-1.6F.2\nG00X200.Z100.\nM30\n")
    box.write("tools.toml", '[[tool]]\nnumber = 1\ntype = "turning"\ninsert = "CNMG120408"\ntip = 3\n'
                            'limits = {vc = 180}\n')
    status(box.kerf("stock", "part.nc", "--machine", "lathe2", "--tools", "tools.toml", "--stock", "bar:60,-80,1.5",
                    "--report", "r.json"), 0)
    near(box.json("r.json")["tools"][0]["max"]["vc_m_min"], 180, 1e-9, "speed")


@test("stock: what a holder tears off is no chip of the tool")
def torn(box):
    tools = MILL + 'flute_length = 20\nstickout = 22\nholder = [ {height = 40, diameter = 40} ]\nlimits = {ap = 5}\n'
    moves = "G00X35.Y20.Z5.\n" + "\n".join(f"G01Z-{z}.F300" for z in range(4, 25, 4))
    report = cut(box, moves, stock="box:0,0,-30,70,40,0", tools=tools, wanted=1)
    equal(found(report), [("HOLDER_COLLISION", 10)], "findings")
    level = cut(box, moves.replace("G01Z-24.F300", ""), stock="box:0,0,-30,70,40,0", tools=tools)
    equal(found(level), [], "above the holder")


@test("stock: a tap wants a hole of its minor diameter, and the lead of its pitch")
def tapping(box):
    tools = ('[[tool]]\nnumber = 1\ntype = "drill"\ndiameter = 6.8\n'
             '[[tool]]\nnumber = 2\ntype = "tap"\ndiameter = 8\npitch = 1.25\n')
    drill = "G81X30.Y20.Z-18.R2.F200\nG80\n"
    tap = "T2M06\nS400M03\nM29S400\nG84X30.Y20.Z-10.R5.F{}\nG80"
    equal(found(cut(box, drill + tap.format("500."), tools=tools)), [], "drilled")
    report = cut(box, tap.format("500."), tools=tools, wanted=1)
    equal({c for c, _ in found(report)}, {"TAP_WITHOUT_HOLE"}, "not drilled")
    report = cut(box, drill + tap.format("600."), tools=tools, wanted=1)
    equal({c for c, _ in found(report)}, {"THREAD_PITCH"}, "1.5 mm a turn")
    contains(report["findings"][0]["message"], "1.5 mm a turn", "values")


@test("stock: a length offset that is not the tool's length is told, and --lengths real shows what it does")
def lengths(box):
    tools = FLAT + "length = 100\n" + FLAT.replace("number = 1", "number = 2") + "length = 130\n"
    with_h = "G00X10.Y20.\nG43H{}Z5.\nG01Z-5.F300\nX60.F600"
    equal(found(cut(box, with_h.format(1), tools=tools)), [], "right")
    report = cut(box, with_h.format(2), tools=tools, wanted=1)
    equal(found(report), [("TOOL_LENGTH", 6)], "wrong H")
    contains(report["findings"][0]["message"], "30 mm higher", "by how much")
    report = cut(box, SLOT, tools=tools, wanted=1)
    equal(found(report), [("TOOL_LENGTH", 5)], "none in force")
    report = cut(box, with_h.format(2), "--lengths", "real", tools=tools, wanted=1)
    equal(report["removed_mm3"], 0, "30 mm above")
    tools = tools.replace("length = 130", "length = 98")
    report = cut(box, with_h.format(2), "--lengths", "real", tools=tools, wanted=1)
    near(report["removed_mm3"], (500 + math.pi * 25) * 7, 30, "2 mm deeper")
    contains(" ".join(cut(box, SLOT)["not_checked"]), "TOOL_LENGTH: T1 has no length", "not known")


@test("stock: axes that leave their travel are told without stopping, where the work has a place")
def travel(box):
    def moved(x):
        return f"\nG10L2P1X{x}Y-100.Z-200.\n" + SLOT
    report = cut(box, moved("350."), wanted=1)
    equal(found(report), [("OT0500", 8)], "beyond +X")
    equal(report["status"], "end", "goes on")
    contains(report["findings"][0]["message"], "X would go to 410", "values")
    equal(found(cut(box, moved("300."))), [], "within")
    report = cut(box, moved("-420."), wanted=1)
    equal([c for c, _ in found(report)], ["OT0501"], "beyond -X")
    contains(" ".join(cut(box, SLOT)["not_checked"]), "OT0500, OT0501: no work offset", "not known")
    equal(found(cut(box, moved("350."), "--no-check", "OT0500")), [], "left out")


@test("stock: a ramp within the tool's angle is no plunge of a tool that does not cut at its centre")
def ramps(box):
    face = '[[tool]]\nnumber = 1\ntype = "face"\ndiameter = 30\nlimits = {{ramp_deg = {}}}\n'
    ramp = "G00X20.Y30.Z0.\nG01X40.Z-{}F300"
    steep, flat = ramp.format("3."), ramp.format("0.5")
    for moves, angle, wanted in ((steep, 5, ["NOT_CENTRE_CUTTING"]), (flat, 5, []), (flat, 1, ["NOT_CENTRE_CUTTING"])):
        report = cut(box, moves, tools=face.format(angle), stock="box:0,0,-60,60,60,0", wanted=1 if wanted else 0)
        equal([c for c, _ in found(report)], wanted, f"{moves} {angle}")


@test("stock: a piece that was sawn off is told as loose when it is cut again")
def loose(box):
    saw = FLAT + '[[tool]]\nnumber = 2\ntype = "saw"\ndiameter = 60\nwidth = 3\nneck_diameter = 12\n'
    off = "T2M06\nS500M03\nG00X-8.Y-40.Z5.\nZ-8.\nG01Y80.F200\nG00Z50."
    stock = "box:0,0,-20,20,40,0"
    equal(found(cut(box, off, tools=saw, stock=stock)), [], "off")
    report = cut(box, off, tools=saw, stock=stock)
    equal([p["held"] for p in report["pieces"]], [True, False], "pieces")
    near(sum(p["volume_mm3"] for p in report["pieces"]), report["left_mm3"], 60, "volumes")
    again = off + "\nT1M06\nS3000M03\nG00X10.Y20.Z5.\nG01Z-2.F100\nG00Z50."
    report = cut(box, again, tools=saw, stock=stock, wanted=1)
    equal(found(report), [("STOCK_LOOSE", 13)], "cut again")
    equal(found(cut(box, again, "--fixture", "box:0,0,0,2,2,10", tools=saw, stock=stock)), [], "clamped")
    before = "T1M06\nS3000M03\nG00X10.Y20.Z5.\nG01Z-2.F100\nG00Z50.\n" + off
    equal(found(cut(box, before, tools=saw, stock=stock)), [], "cut before")


@test("stock: what is not understood of a tool is told with its number")
def imports(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    box.write("tools.json", '{"data":[{"type":"flat end mill","unit":"millimeters","geometry":{"DC":10},'
                            '"post-process":{"number":1}},{"type":"magic wand","unit":"millimeters",'
                            '"geometry":{"DC":3},"post-process":{"number":7}}]}')
    words = ("stock", "part.nc", "--stock", PLATE, "--tools", "tools.json", "--report", "r.json")
    status(box.kerf(*words), 1)
    report = box.json("r.json")
    equal([(f["code"], f["tool"], f["line"]) for f in report["findings"]], [("TOOL_IMPORT", 7, 0)], "told")
    status(box.kerf(*words, "--no-check", "TOOL_IMPORT"), 0)


@test("stock: a finding has the calls that led to it for its hint, and the column of its block")
def hints(box):
    moves = "G00X10.Y20.Z5.\nM98P2"
    box.write("part.nc", HEAD + moves + "\nG00Z50.\nM30\nO2\nG91G00X10.\n  G00Z-10.\nG90M99\n")
    box.write("tools.toml", FLAT)
    result = box.kerf("stock", "part.nc", "--stock", PLATE, "--tools", "tools.toml", "--report", "r.json",
                      "--diagnostics", "json")
    status(result, 1)
    contains(result.err, '"hint":"called from line 5 of O0001"', "hint")
    first = box.json("r.json")["findings"][0]
    equal((first["line"], first["column"], first["program"]), (10, 3, "O0002"), "place")


@test("stock: the part is cut until a line or a second")
def until(box):
    whole = cut(box, SLOT)["removed_mm3"]
    plunge = cut(box, SLOT, "--until", "6")["removed_mm3"]
    near(plunge, math.pi * 25 * 5, 12, "before line 6")
    equal(cut(box, SLOT, "--until", "7")["removed_mm3"], whole, "before line 7")
    cut(box, SLOT, "--blocks", "b.csv")
    row = [r for r in rows_of(box) if r["line"] == "6"][0]
    half = (float(row["start_s"]) + float(row["end_s"])) / 2
    near(cut(box, SLOT, "--until", f"{half}s")["removed_mm3"], (whole + plunge) / 2, 6, "half of the slot")
    report = cut(box, SLOT, "--until", "1000s")
    equal(report["removed_mm3"], whole, "all of it")
    contains(" ".join(a["what"] for a in report["assumed"]), "the run ends before 1000 s", "told")
    equal(cut(box, SLOT, "--until", "0s")["removed_mm3"], 0, "nothing")


@test("stock: the first finding can be the end of what is cut")
def stop(box):
    moves = SLOT + "\nG01Z5.\nG00Y31.\nZ-5.\nX10.\nG01Y5."
    wanted = cut(box, moves, "--until", "10", wanted=1)
    report = cut(box, moves, "--stop-at-finding", wanted=1)
    equal(found(report), [("RAPID_IN_STOCK", 9)], "the first")
    equal((report["status"], report["removed_mm3"]), ("stopped", wanted["removed_mm3"]), "the part")
    report = cut(box, moves, "--stop-at-finding", "--no-check", "RAPID_IN_STOCK")
    equal((report["status"], report["findings"]), ("end", []), "left out")


@test("stock: along the set-points corners are rounded, and what stops is exact")
def set_points(box):
    corner = "G00X10.Y10.Z5.\nG01Z-5.F300\nX60.F3000\nY30."
    sharp = cut(box, corner, cell="0.1")["removed_mm3"]
    along = ("--path", "interpolated", "--machine-set", "interpolator.tolerance=2")
    stops = cut(box, corner.replace("G01", "G61G01"), *along, cell="0.1")
    equal((stops["removed_mm3"], found(stops)), (sharp, []), "exact stops")
    rounded = cut(box, corner, *along, cell="0.1")
    assert 1 < sharp - rounded["removed_mm3"] < 60, rounded["removed_mm3"]
    equal(found(rounded), [], "findings")


@test("stock: an alarm before the first cut is told as such, whatever lies on the table")
def early_alarm(box):
    for machine in ("mill3", "lathe2"):
        box.write("part.nc", "O1\nM03S1000\nG01X#9999999\nM30\n")
        status(box.kerf("stock", "part.nc", "--machine", machine, "--report", "r.json"), 1)
        report = box.json("r.json")
        equal((report["status"], report["findings"], report["removed_mm3"]), ("alarm", [], 0), machine)
        contains(" ".join(a["what"] for a in report["assumed"]), "before the first cut", "told")


@test("stock: of a program that an alarm ends before it cuts nobody says that its stock stands wrong")
def missed_before_alarm(box):
    report = cut(box, "G00X10.Y20.Z5.\nG01Z2.F300\nG01X#9999999", wanted=1)
    equal((report["status"], report["counts"], report["removed_mm3"]), ("alarm", {}, 0), "alarm")


@test("stock: extents are those of what is cut with a tool, T0 too where it was changed to")
def extents_of_tool_0(box):
    for change in ("M06T0", ""):
        box.write("part.nc", f"O1\n{change}\nS3000M03\nG90G54G00X0.Y0.Z5.\nG01Z-2.F300\nX60.\nM30\n")
        status(box.kerf("stock", "part.nc", "--report", "r.json"), 0)
        extents = box.json("r.json")["stock"]["extents"]
        equal(extents, {"X": [-8, 68], "Y": [-8, 8], "Z": [-7, 0]}, change)
    box.write("part.nc", "O1\nS3000M03\nG90G54G00X0.Y0.Z5.\nG01Z-9.F300\nZ5.\nM06T1\nZ-2.\nX60.\nM30\n")
    status(box.kerf("stock", "part.nc", "--report", "r.json"), 0)
    equal(box.json("r.json")["stock"]["extents"]["Z"], [-7, 0], "before the first change there is no tool")


@test("stock: wrong words of checks are sentences")
def wrong(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    for words in (("--material", "X"), ("--material", "0,0.2"), ("--material", "1700,1"), ("--until", "x"),
                  ("--until", "-3s"), ("--until", "0"), ("--no-check", "NOTHING"), ("--lengths", "x"), ("--path", "x")):
        refused(box.kerf("stock", "part.nc", *words), 2, words[0])
    refused(box.kerf("stock", "part.nc", "--blocks", "no/such/b.csv"), 3, "b.csv")


@test("stock: threads of a tap and of a thread mill are told with their measures, and drawn")
def threads(box):
    tools = ('[[tool]]\nnumber = 1\ntype = "drill"\ndiameter = 8.5\n[[tool]]\nnumber = 2\ntype = "tap"\ndiameter = 10\npitch = 1.5\n'
             '[[tool]]\nnumber = 3\ntype = "flat"\ndiameter = 16\n'
             '[[tool]]\nnumber = 4\ntype = "thread-mill"\ndiameter = 12\npitch = 2\nneck_diameter = 9\nflute_length = 3\n')
    bore = "".join(f"G01Z-{z}.\nG03I-5.\n" for z in (5, 10, 15, 20, 25))
    moves = ("G00X15.Y20.Z5.\nG81Z-26.R2.F150\nG80\nT2M06\nS400M03\nM29S400\nG84X15.Y20.Z-20.R5.F600\nG80\n"
             f"T3M06\nS3000M03\nG00X50.Y20.Z5.\nG01Z0F400\n{bore}G00X45.Z5.\n"
             "T4M06\nS3000M03\nG00X45.Y20.Z-20.\nG01X52.5F300\nG03I-7.5Z-18.\nI-7.5Z-16.\nI-7.5Z-14.\nG01X45.\nG00Z5.")
    report = cut(box, moves, "--picture", "p.svg", tools=tools, stock="box:0,0,-30,70,40,0")
    equal(found(report), [], "findings")
    tap, mill = report["threads"]
    equal([tap[key] for key in ("axis", "hand", "starts", "pitch", "major")], ["Z", "right", 1, 1.5, 10], "the tap")
    near(tap["from"], 0, 1e-4, "from")
    near(tap["to"], -17, 1e-4, "to, two pitches above the tip")
    near(tap["minor"], 10 - 1.082531755 * 1.5, 1e-6, "minor")
    depth = 1.082531755 * 0.75
    middle = tap["minor"] / 2 + depth / 3 * (0.75 + 2 * 0.125) / 0.875
    near(tap["volume_mm3"], 0.4375 * 1.5 * depth * 2 * math.pi * middle * 17 / 1.5, 1e-3, "volume")
    equal([mill[key] for key in ("axis", "hand", "starts", "pitch", "major")], ["Z", "right", 1, 2, 27], "the mill")
    near(mill["to"] - mill["from"], -6, 1e-4, "three turns")
    milled = next(t for t in report["tools"] if t["tool"] == 4)
    near(mill["volume_mm3"], milled["removed_mm3"], 0.03 * milled["removed_mm3"], "what it removed, but for its way in")
