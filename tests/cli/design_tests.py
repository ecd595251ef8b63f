"""`kerf stock`: designs that a set-up names, that are put elsewhere or are in inches, and designs of turned parts and of
sheets. What is wrong with a part follows from the numbers in its program."""

import math

from against_tests import IN_ONE, LATHE_HEAD, ROUND, SHEET_HEAD
from compare_tests import FACE, HEAD, STOCK, TAIL, codes, compared, faced, stl
from harness import check, contains, equal, near, refused, status, test
from stock_files_tests import TURNING_TOOL

DESIGN = ((0, 0, -20), (40, 30, -1))


def elsewhere(scale=1.0, shift=(0, 0, 0)):
    """The design of faced("1."), its corners moved and then multiplied."""
    return tuple(tuple(scale * (c + s) for c, s in zip(corner, shift)) for corner in DESIGN)


def by_set_up(box, table, *words, wanted=0, moves=None):
    """The report of a run that has its stock and its design from a file."""
    box.write("part.nc", HEAD + (moves or faced("1.")) + TAIL)
    box.write("tools.toml", FACE)
    box.write("job.toml", f'[stock]\nshape = "{STOCK}"\n[design]\n{table}\n')
    result = box.kerf("stock", "part.nc", "--setup", "job.toml", "--tools", "tools.toml", "--cell", "0.25", "--report", "r.json", *words)
    status(result, wanted)
    return box.json("r.json")


@test("design place: a design is moved and turned to where the part lies, and found wrong where it is not")
def place(box):
    moved = elsewhere(shift=(7, -3, 2))
    report = compared(box, faced("1."), "--design-place", "-7,3,-2", design=moved)
    equal((codes(report), report["compare"]["gouge"]["max_mm"]), ([], 0), "in its place")
    report = compared(box, faced("1."), "--design-place", "-7,3,-1.8", design=moved, wanted=1)
    equal(sorted(codes(report)), ["EXCESS", "GOUGE"], "0.2 mm too high: the top of it was cut away, and the bottom is left")
    lying = ((-30, 0, -20), (0, 40, -1))
    report = compared(box, faced("1."), "--design-place", "0,0,0,0,0,-90", design=lying)
    equal(codes(report), [], "turned about Z by -90 degrees")
    box.write("moved.stl", stl(lying))
    refused(box.kerf("stock", "part.nc", "--stock", STOCK, "--design", "moved.stl", "--design-place", "1,2"), 2, "--design-place")
    refused(box.kerf("stock", "part.nc", "--stock", STOCK, "--design-place", "1,2,3"), 2, "nothing is compared")


@test("design of a set-up: its file, place, unit and tolerance are what the part is compared by")
def of_set_up(box):
    box.write("moved.stl", stl(elsewhere(scale=1 / 25.4, shift=(5, 0, 0))))
    table = 'file = "moved.stl"\nunit = "inch"\nplace = [-5, 0, 0]'
    report = by_set_up(box, table)
    near(report["compare"]["gouge"]["max_mm"], 0, 1e-4, "in inches and moved")
    check(not any("not compared" in a["what"] for a in report["assumed"]), "it is compared")
    report = by_set_up(box, table, moves=faced("1.2"), wanted=1)
    equal([(f["code"], f["line"] in (6, 8)) for f in report["findings"]], [("GOUGE", True)], "0.2 mm too deep")
    report = by_set_up(box, table + "\ntolerance = 0.3", moves=faced("1.2"))
    equal((codes(report), report["compare"]["tolerance_mm"]), ([], 0.3), "within its tolerance")
    report = by_set_up(box, table + "\ntolerance = 0.3", "--tolerance", "0.1", moves=faced("1.2"), wanted=1)
    equal(codes(report), ["GOUGE"], "the command line counts more")
    report = by_set_up(box, table.replace("-5", "-4"), "--design-place", "-5,0,0")
    equal(codes(report), [], "its place as well")
    box.write("own.stl", stl(DESIGN))
    report = by_set_up(box, 'file = "none.stl"\ntolerance = 0.3', "--design", "own.stl", moves=faced("1.2"))
    equal(report["compare"]["tolerance_mm"], 0.3, "another file, and what the set-up says besides")
    words = ("stock", "part.nc", "--setup", "job.toml", "--tools", "tools.toml")
    refused(box.kerf(*words), 3, "none.stl")
    box.write("job.toml", f'[stock]\nshape = "{STOCK}"\n[design]\nfile = "own.stl"\nplace = [500, 0, 0]\n')
    refused(box.kerf(*words), 3, "no place in common")
    refused(box.kerf(*words, "--stl", "own.stl"), 2, "own.stl")


@test("design of a set-up: kerf run and kerf check find what differs from it, too")
def of_other_commands(box):
    box.write("own.stl", stl(DESIGN))
    by_set_up(box, 'file = "own.stl"', moves=faced("1.2"), wanted=1)
    words = ("part.nc", "--setup", "job.toml", "--tools", "tools.toml", "--cell", "0.25")
    status(box.kerf("run", *words, "--summary", "s.json"), 1)
    equal(box.json("s.json")["counts"], {"GOUGE": 1}, "run")
    result = box.kerf("check", *words)
    status(result, 1)
    contains(result.text, "GOUGE", "check")
    by_set_up(box, 'file = "own.stl"')
    status(box.kerf("run", *words, "--summary", "s.json"), 0)
    status(box.kerf("check", *words), 0)


SIDES = 360


def revolved(outline):
    """An outline of (z, radius) from axis to axis, turned about Z, as text."""
    def ring(z, radius):
        return [(radius * math.cos(2 * math.pi * i / SIDES), radius * math.sin(2 * math.pi * i / SIDES), z) for i in range(SIDES)]

    lines = ["solid turned"]
    for (z0, r0), (z1, r1) in zip(outline, outline[1:]):
        low, high = ring(z0, r0), ring(z1, r1)
        for i in range(SIDES):
            k = (i + 1) % SIDES
            triangles = [(low[i], low[k], high[k]), (low[i], high[k], high[i])]
            for triangle in triangles:
                if len(set(triangle)) == 3:
                    lines += ["facet normal 0 0 0", "outer loop", *("vertex {:.9f} {:.9f} {:.9f}".format(*p) for p in triangle),
                              "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid turned", ""])


SHAFT = [(-80, 0), (-80, 25), (-20, 25), (-20, 20), (0, 20), (0, 0)]
SAGITTA = 25 * (1 - math.cos(math.pi / SIDES))


def turned(box, moves, *words, wanted=0, outline=SHAFT):
    box.write("part.nc", LATHE_HEAD + moves + "M30\n")
    box.write("tools.toml", TURNING_TOOL)
    box.write("shaft.stl", revolved(outline))
    result = box.kerf("stock", "part.nc", "--machine", "lathe2", "--stock", "bar:50,-80,0", "--tools", "tools.toml", "--design",
                      "shaft.stl", "--report", "r.json", *words)
    status(result, wanted)
    return box.json("r.json")


@test("design of a turned part: the right one is right to the chords of the design, a thin seat is a gouge of its ring and line")
def of_turned_part(box):
    report = turned(box, IN_ONE)
    equal((codes(report), report["model"]["kind"]), ([], "profile"), "right")
    for side in ("gouge", "excess"):
        check(report["compare"][side]["max_mm"] < 1.5 * SAGITTA, f"{side}: {report['compare'][side]}")
    report = turned(box, IN_ONE.replace("X40.", "X39.6"), wanted=1)
    equal([(f["code"], f["line"], f["tool"]) for f in report["findings"]], [("GOUGE", 6, 1)], "thin")
    ring = math.pi * (20 ** 2 - 19.8 ** 2) * 20
    near(report["compare"]["gouge"]["volume_mm3"], ring, 0.03 * ring, "volume")
    near(report["compare"]["gouge"]["max_mm"], 0.2, 1.5 * SAGITTA, "deep")
    near(report["findings"][0]["at"]["X"], 39.6, 0.5, "X is a diameter")
    report = turned(box, IN_ONE.replace("Z-20.", "Z-19.7"), "--glb", "part.glb", wanted=1)
    equal([(f["code"], f["line"]) for f in report["findings"]], [("EXCESS", 7)], "too short")
    near(report["compare"]["excess"]["max_mm"], 0.3, 1e-3, "left")
    contains(box.read("part.glb")[:20000].decode("latin-1"), "_DEVIATION", "the coloured part")


@test("design of a turned part: threads share the work and change no byte")
def of_turned_part_by_threads(box):
    seen = set()
    for jobs in ("1", "2", "5"):
        turned(box, IN_ONE.replace("X40.", "X39.6"), "--jobs", jobs, wanted=1)
        seen.add(box.read("r.json"))
    equal(len(seen), 1, "reports")


def burnt(box, low, high, *words, wanted=0):
    """A square of 20 mm is cut out; the design is a plate between two corners."""
    box.write("part.nc", SHEET_HEAD + ROUND + "M05\nM30\n")
    box.write("plate.stl", stl(((*low, -2), (*high, 0))))
    result = box.kerf("stock", "part.nc", "--machine", "laser3", "--decimal-point", "calculator", "--stock", "sheet:-10,-10,30,30,2",
                      "--kerf", "0.2", "--design", "plate.stl", "--report", "r.json", *words)
    status(result, wanted)
    return box.json("r.json")


@test("design of a sheet: the piece that lies in it is compared, half a kerf too small is a gouge of the lines around it")
def of_sheet(box):
    report = burnt(box, (0.1, 0.1), (19.9, 19.9))
    equal((codes(report), report["compare"]["gouge"]["max_mm"], report["compare"]["excess"]["max_mm"]), ([], 0, 0), "right")
    report = burnt(box, (0, 0), (20, 20), wanted=1)
    equal([(f["code"], f["line"] in (5, 6, 7, 8)) for f in report["findings"]], [("GOUGE", True)], "too small")
    near(report["compare"]["gouge"]["max_mm"], 0.1 * math.sqrt(2), 1e-3, "at the corners")
    near(report["compare"]["gouge"]["volume_mm3"], (400 - 19.8 ** 2) * 2, 0.3, "volume")
    equal(sorted(line["line"] for line in report["compare"]["regions"][0]["lines"]), [5, 6, 7, 8], "all sides")
    report = burnt(box, (0.1, 0.1), (19.7, 19.9), wanted=1)
    equal([(f["code"], f["line"]) for f in report["findings"]], [("EXCESS", 6)], "one side too wide")
    near(report["compare"]["excess"]["volume_mm3"], 0.2 * 19.8 * 2, 0.1, "volume")


@test("design of a sheet: where no piece lies in it all of it is missing")
def of_missing_piece(box):
    report = burnt(box, (-9, -9), (-0.1, 29), wanted=1)
    equal(codes(report), ["GOUGE"], "of the frame a small part lies there")
    near(report["compare"]["gouge"]["volume_mm3"], 8.9 * 38 * 2, 0.01 * 8.9 * 38 * 2, "all of it")
    refused(box.kerf("stock", "part.nc", "--machine", "laser3", "--stock", "sheet:40,40,60,60,2", "--design", "plate.stl"), 3,
            "no place in common")
