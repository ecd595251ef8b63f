"""`kerf check` with what lies on the table: each option does there what it does for `kerf stock`."""

import json

from harness import check, contains, equal, refused, status, test
from stock_check_tests import FLAT, HEAD, PLATE, SLOT, TAIL

THROUGH = SLOT + "\nG00Y30."  # at depth, through what the slot has left
SQUARE = "POWER(80)\nSPEED(100)\nMOVE(0,0,0)\nLINE(20,0,0)\nLINE(20,20,0)\nLINE(0,20,0)\nLINE(0,0,0)\nEND\n"
LONG = FLAT + "length = 130\n"


def found(box, moves, words, tools=FLAT, machine="mill3", name="part.nc", table="tools.toml"):
    """What check finds; stock finds the same with the same options, and ends with the same status."""
    box.write(name, HEAD + moves + TAIL if name == "part.nc" else moves)
    box.write(table, tools)
    all_words = (name, "--machine", machine, "--tools", table, *words)
    one = box.kerf("check", *all_words, "--format", "json")
    other = box.kerf("stock", *all_words, "--report", "r.json")
    equal(one.status, other.status, f"status of check and stock with {words}")
    told = [json.loads(line) for line in one.lines()]
    places = [(f["code"], f["line"]) for f in told]
    equal(places, [(f["code"], f["line"]) for f in box.json("r.json")["findings"]], f"findings with {words}")
    return places


def by_option(option, moves, without, words, wanted, rest=(), **how):
    """Without it nothing is found; with it, what it is for."""
    @test(f"check: {option} counts as it does for kerf stock")
    def _(box):
        equal(found(box, moves, (*without, *rest), **how), [], f"without {option}")
        check(option in words, option)
        equal({code for code, _ in found(box, moves, (*words, *rest), **how)}, set(wanted), option)


STOCK = ("--stock", PLATE, "--cell", "0.5")
RISEN = "\nG00Z5.\nY30."  # beside the slot
by_option("--fixture", SLOT, STOCK, (*STOCK, "--fixture", "box:62,10,-4,70,30,15"), ["FIXTURE_COLLISION"])
by_option("--stock-place", SLOT + RISEN, STOCK, (*STOCK, "--stock-place", "0,0,8"), ["RAPID_IN_STOCK"])
by_option("--stock-zero", "\nG10L2P1X0Y0Z-8.\n" + SLOT + RISEN, STOCK, (*STOCK, "--stock-zero", "machine"), ["RAPID_IN_STOCK"],
          rest=("--no-check", "OT0500"))
by_option("--start", SLOT, STOCK, (*STOCK, "--start", "10,20,-30"), ["RAPID_IN_STOCK"])
by_option("--tools-unit", SLOT, (*STOCK, "--tools-unit", "mm"), (*STOCK, "--tools-unit", "inch"), ["FIXTURE_COLLISION"],
          table="tool.tbl", tools="T1 P1 D10.0 ;end mill\n", rest=("--fixture", "box:70,60,-4,80,70,15"))
by_option("--lengths", "G00X10.Y20.\nG43H2Z5.\nX60.", STOCK, (*STOCK, "--lengths", "real"), ["RAPID_IN_STOCK"],
          tools=FLAT + "length = 100\n" + FLAT.replace("number = 1", "number = 2") + "length = 70\n",
          rest=("--no-check", "TOOL_LENGTH"))


@test("check: what is left out with --no-check is not found, and --fail-on says what counts")
def severities(box):
    equal(found(box, THROUGH, STOCK), [("RAPID_IN_STOCK", 7)], "found")
    equal(found(box, THROUGH, (*STOCK, "--no-check", "RAPID_IN_STOCK")), [], "left out")
    equal(found(box, THROUGH, (*STOCK, "--fail-on", "never")), [("RAPID_IN_STOCK", 7)], "told")
    words = ("check", "part.nc", "--tools", "tools.toml", *STOCK)
    for severity, wanted in (("never", 0), ("error", 1), ("warning", 1)):
        for form in ("text", "junit", "sarif"):
            result = box.kerf(*words, "--fail-on", severity, "--format", form)
            status(result, wanted)
            contains(result.text, "RAPID_IN_STOCK", "told in any case")
            if form == "junit":
                contains(result.text, f'failures="{wanted}"', "what counts")


@test("check: the models find the same, and one that the machine does not have is refused")
def models(box):
    for model in ("auto", "zmap", "tridexel"):
        equal(found(box, THROUGH, (*STOCK, "--model", model)), [("RAPID_IN_STOCK", 7)], model)
    refused(box.kerf("check", "part.nc", *STOCK, "--model", "profile"), 2, "profile")


@test("check: the power of a cut is held against the spindle's when --material says what it takes")
def material(box):
    mill = box.kerf("machines", "mill3").text
    box.write("weak.toml", mill + "\n[spindle]\npower_kw = 2\n")
    tools = FLAT + "flutes = 3\n"
    equal(found(box, SLOT, STOCK, tools=tools, machine="weak.toml"), [], "of no material")
    equal(found(box, SLOT, (*STOCK, "--material", "P"), tools=tools, machine="weak.toml"), [("CUTTING_POWER", 6)], "steel")


@test("check: cells that --memory does not hold are told as for kerf stock")
def memory(box):
    equal(found(box, THROUGH, (*STOCK, "--memory", "64")), [("RAPID_IN_STOCK", 7)], "64 MiB")
    equal({code for code, _ in found(box, THROUGH, (*STOCK, "--memory", "0"))}, {"CELL_ENLARGED"}, "none at all")


@test("check: STL files have the unit that --stock-unit says")
def unit(box):
    corners = [(x, y, z) for x in (0, 70) for y in (0, 40) for z in (-20, 0)]
    faces = ((0, 1, 3), (0, 3, 2), (4, 7, 5), (4, 6, 7), (0, 5, 1), (0, 4, 5), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
             (1, 5, 7), (1, 7, 3))
    lines = ["solid block"]
    for face in faces:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {:g} {:g} {:g}".format(*corners[i]) for i in face] + ["endloop", "endfacet"]
    box.write("block.stl", "\n".join([*lines, "endsolid block", ""]))
    words = ("--stock", "block.stl", "--cell", "0.5", "--stock-unit")
    beside = "G00X200.Y20.Z5.\nG01Z-5.F300\nX180.F900\nG00X160."
    equal(found(box, SLOT + "\nG00Z5.\n" + beside, (*words, "mm")), [], "mm")
    codes = [code for code, _ in found(box, SLOT + "\nG00Z5.\n" + beside, (*words, "inch"))]
    contains(codes, "RAPID_IN_STOCK", "inches")


@test("check: a sheet's kerf is that of --kerf")
def kerf(box):
    words = ("--stock", "sheet:-10,-10,30,30,2", "--kerf")
    found(box, SQUARE, (*words, "0.2"), machine="laser3", name="square.bas")
    refused(box.kerf("check", "square.bas", "--machine", "laser3", *words, "0"), 2, "--kerf")
