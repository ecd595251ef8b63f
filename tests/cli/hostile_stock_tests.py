"""Stock that cannot be, or hardly: tiny cells, large tools, little memory, places out of reach. Sentences, never a crash."""

import math
import struct

from harness import check, contains, equal, near, refused, status, test
from set_up_tests import block, stl
from stock_tests import FLAT, HEAD, SLOT, SLOT_MM3, TAIL, cut, found


@test("hostile stock: cells of a nanometre and little memory make larger cells, and say so")
def tiny_cells(box):
    for words in (("--cell", "1e-6", "--memory", "64"), ("--cell", "1e-300", "--memory", "8"),
                  ("--cell", "1e-6", "--memory", "64", "--model", "tridexel"), ("--memory", "0")):
        report = cut(box, SLOT, *words, wanted=1)
        equal([c for c, _ in found(report)], ["CELL_ENLARGED"], "told")
        most = int(words[words.index("--memory") + 1]) if "--memory" in words else 1024
        check(most == 0 or report["model"]["bytes"] <= 1.3 * (most << 20), f"{report['model']['bytes']} bytes of {most} MiB")


@test("hostile stock: a tool of one metre cuts all that there is")
def large_tool(box):
    tools = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 1000\n'
    for model in ("zmap", "tridexel"):
        report = cut(box, "G00X-600.Y20.Z5.\nG01Z-5.F3000\nX35.", "--model", model, "--cell", "1", tools=tools)
        near(report["removed_mm3"], 70 * 40 * 5, 1e-3, model)
    report = cut(box, "G00X-600.Y20.Z5.\nG01Z-30.F3000\nX35.", "--cell", "1", tools=tools)
    near(report["left_mm3"], 0, 1e-3, "nothing is left")
    equal(report["extents"], {}, "extents")
    refused(box.kerf("stock", "part.nc", "--tools", "tools.toml", "--stock", "box:0,0,-20,70,40,0", "--cell", "1",
                     "--save", "p.kstock"), 3, "nothing is left")


@test("hostile stock: far outside of the travel it is missed, and that is told")
def out_of_reach(box):
    report = cut(box, SLOT, "--cell", "1", stock="box:90000,90000,-20,90070,90040,0", wanted=1)
    equal([c for c, _ in found(report)], ["STOCK_MISSED"], "missed")
    report = cut(box, SLOT, "--cell", "1", "--stock-place", "99999,99999,99999,0,0,0", wanted=1)
    equal([c for c, _ in found(report)], ["STOCK_MISSED"], "placed there")


@test("hostile stock: numbers that are none and numbers that are too large are wrong usage")
def wild_numbers(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    for shape in ("box:nan,0,0,1,1,1", "box:0,0,0,inf,1,1", "box:0,0,0,1e300,1,1", "box:-1e300,0,0,1,1,1", "box:0,0,0,1e-400,1,1",
                  "cylinder:Z,0,0,0,1,nan", "tube:Z,0,0,0,1,1e300,1", "extents:nan", "extents:1e300", "box:0,0,0,1,1,",
                  "box:,,,,,", "box:0x1,0,0,2,1,1", "box:" + "1," * 500 + "1"):
        result = box.kerf("stock", "part.nc", "--stock", shape)
        status(result, 2)
        contains(result.err, "--stock", shape[:40])
    for option in ("--stock-place", "--start"):
        for text in ("nan,0,0", "1e300,0,0", "0,0", "0,0,0,0,0,0,0", "", ",,"):
            result = box.kerf("stock", "part.nc", "--stock", "box:0,0,-20,70,40,0", option + "=" + text)
            check(result.status in (0, 2), f"{option} {text}: {result.status} {result.err}")
    for words in (("--memory", "-1"), ("--memory", "nan"), ("--cell", "nan"), ("--cell", "-1")):
        refused(box.kerf("stock", "part.nc", *words), 2, words[0])
    cut(box, SLOT, "--memory", "1000000000000000000", "--cell", "1")


@test("hostile stock: a flat mesh, a thin one and one of many shells are what they are")
def odd_meshes(box):
    thin = block((0, 0, -20), (70, 40, -20 + 1e-4))
    many = [t for i in range(20) for t in block((3 * i, 0, -5), (3 * i + 2, 40, -1))]
    box.write("flat.stl", stl([t for t in block((0, 0, -20), (70, 40, -20))]))
    box.write("thin.stl", stl(thin))
    box.write("many.stl", stl(many))
    box.write("part.nc", HEAD + SLOT + TAIL)
    refused(box.kerf("stock", "part.nc", "--stock", "flat.stl"), 3, "flat.stl")
    report = cut(box, SLOT, "--cell", "1", stock="thin.stl", wanted=1)
    equal([c for c, _ in found(report)], ["STOCK_MISSED"], "thin")
    report = cut(box, SLOT, "--cell", "0.5", stock="many.stl")
    near(report["stock"]["volume_mm3"], 20 * 2 * 40 * 4, 1e-3, "volume")
    near(report["removed_mm3"], SLOT_MM3 / 5 * 4 * 2 / 3, 0.15 * SLOT_MM3, "two thirds of the slot, 4 deep")


@test("hostile stock: more triangles than the memory has room for are refused before they are read")
def many_triangles(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    box.write("many.stl", stl(block((0, 0, -20), (70, 40, 0)) * 2000))
    refused(box.kerf("stock", "part.nc", "--stock", "many.stl", "--memory", "1"), 3, "24000 triangles")
    size = 84 + 50 * 12
    claimed = b"\0" * 80 + struct.pack("<I", 2 ** 32 - 1)
    box.write("claims.stl", claimed + b"\0" * (size - len(claimed)))
    refused(box.kerf("stock", "part.nc", "--stock", "claims.stl"), 3, "claims.stl")


@test("hostile stock: a stock as thin as a hair and one as long as a hall are cut")
def extremes(box):
    report = cut(box, "G00X10.Y0.005Z5.\nG01Z-5.F300\nX60.", "--cell", "0.1", stock="box:0,0,-20,70,0.01,0")
    near(report["removed_mm3"], 60 * 5 * 0.01, 0.1, "thin")
    report = cut(box, SLOT, "--memory", "64", stock="box:-50000,-50000,-20,50000,50000,0", wanted=1)
    contains(" ".join(c for c, _ in found(report)), "CELL_ENLARGED", "a hall")
    check(math.isfinite(report["removed_mm3"]), "removed")
