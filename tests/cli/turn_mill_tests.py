"""kerf stock on lathes with driven tools, and of stock that is not round: parts against closed formulas."""

import math

from harness import check, contains, equal, near, refused, status, test

HEAD = "%\nO1\nG21G40G97G98\n"
FLAT = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = {}\n'
DRILL = '[[tool]]\nnumber = 1\ntype = "drill"\ndiameter = {}\n'


def cut(box, moves, *words, tools="", stock="bar:40,-60,0", wanted=0, cell="0.25"):
    """The report of a program of these moves on lathe3c."""
    box.write("part.nc", HEAD + moves + "\nG00X200.Z100.\nM30\n%\n")
    box.write("tools.toml", tools)
    result = box.kerf("stock", "part.nc", "--machine", "lathe3c", "--stock", stock, "--tools", "tools.toml", "--cell",
                      cell, "--param", "DPI=1", "--report", "r.json", *words)
    status(result, wanted)
    return box.json("r.json")


def found(report):
    return [(f["code"], f["line"]) for f in report["findings"]]


def integral(f, low, high, steps=20000):
    """Simpson's rule."""
    width = (high - low) / steps
    inner = sum((4 if i % 2 else 2) * f(low + i * width) for i in range(1, steps))
    return (f(low) + inner + f(high)) * width / 3


def removes(report, formula, cell=0.25):
    """As the oracles of the spec have it: 5 % of the cell, and within the bound that the report tells."""
    near(report["removed_mm3"], formula, 0.05 * cell * formula, "removed")
    check(abs(report["removed_mm3"] - formula) <= report["model"]["error_mm3"], f"not within its bound: {report['model']}")
    near(sum(t["removed_mm3"] for t in report["tools"]), formula, 0.05 * cell * formula, "of the tools")


def cross_hole(bar, hole):
    """Through the axis, radii: 8 times the integral of sqrt(R² - x²) sqrt(r² - x²)."""
    return 8 * integral(lambda a: math.sqrt(bar**2 - (hole * math.sin(a)) ** 2) * (hole * math.cos(a)) ** 2, 0, math.pi / 2)


@test("driven: holes across a bar by G87, wherever C stands")
def cross_holes(box):
    moves = "T0101\nG28H0\nS2000M133\nG00X50.Z-15.C0\nG87X-50.R-1.F100\nG80\nG00X50.Z-40.C37.\nG87X-50.R-1.F100\nG80\nM135"
    report = cut(box, moves, tools=DRILL.format(10))
    removes(report, 2 * cross_hole(20, 5))
    equal(report["model"]["kind"], "tridexel", "kind")
    contains(report["model"]["reason"], "a driven tool cuts, line 8", "reason")
    equal(found(report), [], "findings")


@test("driven: a circle of holes in the face")
def bolt_circle(box):
    holes = "".join(f"G83C{60 * i}.Z-14.R-3.F100\n" for i in range(6))
    moves = f"T0101\nG28H0\nS2000M133\nG00X26.Z5.C0\n{holes}G80\nM135"
    report = cut(box, moves, tools=DRILL.format(6))
    point = 3 / math.tan(math.radians(59))
    removes(report, 6 * math.pi * 9 * (14 - point + point / 3))
    equal(found(report), [], "findings")


@test("driven: a hexagon by G12.1 has its area")
def hexagon(box):
    a, r = 14, 8  # half of its width, and of the mill's
    corner = (a + r) / math.cos(math.pi / 6)
    points = [(corner * math.cos(math.radians(60 * i)), corner * math.sin(math.radians(60 * i))) for i in range(7)]
    way = "".join(f"G01X{2 * x:.6f}C{y:.6f}\n" for x, y in points[1:])
    moves = (f"T0101\nG28H0\nS2000M133\nG00X{2 * points[0][0]:.6f}Z2.C0\nG01Z-12.F300\nG12.1\n{way}G13.1\nG00Z2.\nM135")
    report = cut(box, moves, tools=FLAT.format(2 * r))
    left = 2 * math.sqrt(3) * a * a
    removes(report, (math.pi * 400 - left) * 12)
    equal(found(report), [], "findings")
    near(report["extents"]["X"][1], 40, 1e-3, "the bar behind it")


@test("driven: a groove round the side by G07.1, and a keyway along it")
def grooves(box):
    round_about = ("T0101\nG28H0\nS2000M133\nG00X44.Z-20.C0\nG01X30.F100\nG07.1C15.\nG01C360.F200\nG07.1C0\nG00X44.\nM135")
    report = cut(box, round_about, tools=FLAT.format(8))
    removes(report, math.pi * (400 - 225) * 8)
    equal(found(report), [], "findings")
    keyway = "T0101\nG28H0\nS2000M133\nG00X44.Z6.C90.\nX32.\nG01Z-30.F200\nG00X44.\nM135"
    tools = FLAT.format(8) + 'driven = "side"\n'
    report = cut(box, keyway, tools=tools)
    # A strip of 8 from 16 outwards, to Z-30 and half a mill beyond.
    flank = integral(lambda y: math.sqrt(400 - y * y) - 16, -4, 4)
    end = integral(lambda y: (math.sqrt(400 - y * y) - 16) * math.sqrt(16 - y * y), -4, 4)
    removes(report, flank * 30 + end)


@test("driven: turned before and behind, with a thread, and parted off")
def mixed(box):
    tools = (FLAT.format(6) + '[[tool]]\nnumber = 2\ntype = "turning"\ninsert = "CNMG120408"\nic = 60\n'
             '[[tool]]\nnumber = 3\ntype = "parting"\nwidth = 3\n[[tool]]\nnumber = 4\ntype = "threading"\npitch = 1.5\n')
    moves = ("T0202\nS1000M03\nG00X44.Z2.\nX30.\nG01Z-40.F100\nX42.\nG00X100.Z50.\nM05\n"
             "T0101\nG28H0\nS2000M133\nG00X20.Z5.C0\nG83Z-10.R-3.F100\nG83C180.\nG80\nM135\nG00X100.Z50.\n"
             "T0404\nS500M03\nG00X34.Z3.\nG99\nG92X29.Z-30.F1.5\nX28.1\nG00X100.Z50.\n"
             "T0303\nS500M03\nG00X44.Z-50.\nG01X-1.F0.1\nG00X44.\nM05")
    report = cut(box, moves, tools=tools)
    equal([p["held"] for p in report["pieces"]], [False, True], "pieces")
    turned = math.pi * (400 - 225) * 40
    parted = math.pi * 400 * 3
    holes = 2 * math.pi * 9 * 10
    near(report["removed_mm3"], turned + parted + holes, 0.05 * 0.25 * holes + 200, "removed")
    equal([(t["pitch"], t["major"]) for t in report["threads"]], [(1.5, 30)], "threads")
    equal(found(report), [], "findings")


@test("driven: what stands still, what is too long and what goes too fast is found")
def checks(box):
    tools = DRILL.format(6) + "stickout = 20\nflute_length = 15\nholder = [{height = 30, diameter = 30}]\n"
    moves = "T0101\nG28H0\nG00X20.Z5.C0\nG01Z-5.F100\nG00Z5.\nM135"
    equal(found(cut(box, moves, tools=tools, wanted=1)), [("SPINDLE_STOPPED", 7)], "no spindle")
    moves = "T0101\nG28H0\nS2000M133\nG00X20.Z5.C0\nG01Z-25.F100\nG00Z5.\nM135"
    codes = [code for code, _ in found(cut(box, moves, tools=tools, wanted=1))]
    equal(codes, ["HOLDER_COLLISION"], "too deep")
    moves = "T0101\nG28H0\nS2000M133\nG00X20.Z5.C0\nG01Z-5.F100\nG00C30.\nZ5.\nM135"
    report = cut(box, moves, tools=tools, wanted=1)
    equal(found(report)[0], ("RAPID_IN_STOCK", 9), "C at rapid in the hole")
    check(0 < report["findings"][0]["at"]["C"] <= 30.1 or report["findings"][0]["at"]["X"] > 0, "place")
    moves = "T0101\nG28H0\nS2000M133\nG00X20.Z5.C0\nG01Z-5.F100\nC30.F500\nG00Z5.\nM135"
    equal([c for c, _ in found(cut(box, moves, tools=tools, wanted=1))], ["AXIAL_TOOL_SIDEWAYS"], "a drill sideways")
    moves = "T0101\nG28H0\nS2000M133\nG00X50.Z-50.C0\nG01X30.F100\nG00X50.\nM135"
    words = ("--fixture", "cylinder:Z,0,0,-70,-45,60")
    equal([c for c, _ in found(cut(box, moves, *words, tools=tools, wanted=1))], ["FIXTURE_COLLISION"] * 3, "the chuck, there and back")


@test("driven: where nobody says how a tool stands, its moves do, and it is told")
def stands(box):
    moves = "T0101\nG28H0\nS2000M133\nG00X44.Z-20.C0\nG01X34.F100\nZ-30.\nG00X44.\nM135"
    report = cut(box, moves, tools=FLAT.format(8))
    told = [a["what"] for a in report["assumed"] if "driven along" in a["what"]]
    equal(told, ["T1: driven along X, as its first straight cut goes"], "told")
    moves = "G17\nT0101\nG28H0\nS2000M133\nG00X44.Z-20.C0\nG01X34.F100\nZ-30.\nG00X44.\nM135\nG18"
    report = cut(box, moves, tools=FLAT.format(8), wanted=1)
    equal([a for a in report["assumed"] if "driven along" in a["what"]], [], "by the plane")
    tools = FLAT.format(8) + 'driven = "top"\n'
    box.write("tools.toml", tools)
    refused(box.kerf("stock", "part.nc", "--machine", "lathe3c", "--tools", "tools.toml"), 3, "driven is face or side")


@test("a square bar is turned round, and a lathe can be asked for dexels")
def not_round(box):
    turning = '[[tool]]\nnumber = 1\ntype = "turning"\ninsert = "CNMG120408"\nnose_radius = 0\nic = 60\n'
    moves = "T0101\nS1000M03\nG00X60.Z2.\nX20.\nG01Z-40.F100\nX60.\nM05"
    report = cut(box, moves, tools=turning, stock="box:-20,-20,-60,20,20,0")
    removes(report, (1600 - math.pi * 100) * 40)
    equal(report["model"]["reason"], "the stock is no bar about the spindle", "reason")
    report = cut(box, moves, "--model", "tridexel", tools=turning)
    near(report["removed_mm3"], math.pi * 300 * 40, 1e-6 * math.pi * 300 * 40, "exact")
    equal((report["model"]["kind"], report["model"]["error_mm3"]), ("tridexel", 0), "kind")
    box.write("part.nc", HEAD + "T0101\nG28H0\nS2000M133\nG00X20.Z5.C0\nG01Z-5.F100\nM30\n%\n")
    box.write("tools.toml", FLAT.format(8))
    words = ("stock", "part.nc", "--machine", "lathe3c", "--stock", "bar:40,-60,0", "--tools", "tools.toml")
    refused(box.kerf(*words, "--model", "profile"), 2, "a driven tool cuts, line 8")
    refused(box.kerf(*words, "--model", "zmap"), 2, "no height field")


@test("driven: the same bytes whatever the number of threads, with the files of the part")
def same_bytes(box):
    box.write("part.nc", HEAD + "T0101\nG28H0\nS2000M133\nG00X20.Z5.C0\nG83Z-10.R-3.F100\nG83C90.\nG80\nM30\n%\n")
    box.write("tools.toml", DRILL.format(6))
    seen = []
    for jobs in ("1", "2", "7"):
        status(box.kerf("stock", "part.nc", "--machine", "lathe3c", "--stock", "bar:40,-30,0", "--tools", "tools.toml",
                        "--param", "DPI=1", "--cell", "0.5", "--jobs", jobs, "--report", "r.json", "--stl", "p.stl", "--profile",
                        "p.csv", "--picture", "p.svg"), 0)
        seen.append([box.read(name) for name in ("r.json", "p.stl", "p.csv", "p.svg")])
    equal(seen[1], seen[0], "two threads")
    equal(seen[2], seen[0], "seven")
    contains(box.read("p.csv").decode(), "z,x,bulge", "the contour that turning has left")
