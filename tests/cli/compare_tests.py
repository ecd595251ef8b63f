"""`kerf stock --design`: how far the part is from what it shall be, and which line is to blame. Designs are boxes of ASCII
triangles; what is wrong with a part follows from the depths in its program."""

import json
import math
import struct

from harness import check, contains, equal, near, refused, status, test

FACE = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 20\n[[tool]]\nnumber = 2\ntype = "flat"\ndiameter = 10\n'
HEAD = "O1\nT1M06\nS3000M03\nG90G54"
TAIL = "G00Z50.\nM30\n"
STOCK = "box:0,0,-20,40,30,0"
HISTOGRAM_BINS = 41


def faced(depth):
    """The top of STOCK at this depth, in passes of lines 4 to 9."""
    return f"G00X-15.Y5.Z5.\nG01Z-{depth}F300\nX55.F900\nY20.\nX-15.\nY30.\nX55.\n"


def stl(*boxes):
    """Boxes as text, corners by hand."""
    lines = ["solid design"]
    for low, high in boxes:
        corner = [tuple((low, high)[i >> k & 1][k] for k in range(3)) for i in range(8)]
        for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            for triangle in ((a, b, c), (a, c, d)):
                lines += ["facet normal 0 0 0", "outer loop", *("vertex {} {} {}".format(*corner[i]) for i in triangle),
                          "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid design", ""])


def compared(box, moves, *words, design=((0, 0, -20), (40, 30, -1)), wanted=0, cell="0.2", stock=STOCK):
    """The report of a program of these moves, with a design that is a box."""
    box.write("part.nc", HEAD + moves + TAIL)
    box.write("tools.toml", FACE)
    box.write("design.stl", stl(design))
    result = box.kerf("stock", "part.nc", "--machine", "mill3", "--stock", stock, "--tools", "tools.toml", "--cell", cell,
                      "--design", "design.stl", "--report", "r.json", *words)
    status(result, wanted)
    return box.json("r.json")


def codes(report):
    return [f["code"] for f in report["findings"]]


@test("design: a face that is cut too deep is a gouge of its depth, area and volume, whatever holds the part")
def gouge(box):
    for model in ("zmap", "tridexel"):
        report = compared(box, faced("1.2"), "--model", model, wanted=1)
        equal(codes(report), ["GOUGE"], model)
        found = report["findings"][0]
        equal((found["severity"], found["program"], found["tool"]), ("error", "O0001", 1), model)
        near(found["depth_mm"], 0.2, 1e-5, model)
        gouge = report["compare"]["gouge"]
        near(gouge["max_mm"], 0.2, 1e-5, model)
        near(gouge["volume_mm3"], 240, 1e-3, model)
        equal(gouge["regions"], 1, model)
        equal(report["compare"]["excess"], {"tolerance_mm": 0.05, "max_mm": 0, "volume_mm3": 0, "regions": 0}, model)
        region = report["compare"]["regions"][0]
        near(region["area_mm2"], 1200, 0.01, model)
        equal(sorted(line["line"] for line in region["lines"]), [6, 8], model)
        near(sum(line["share"] for line in region["lines"]), 1, 1e-6, model)
        equal(found["line"], region["lines"][0]["line"], model)


@test("design: a part as it shall be has no finding, and one that is not deep enough has material left")
def right_and_left(box):
    for model in ("zmap", "tridexel"):
        report = compared(box, faced("1."), "--model", model)
        equal((codes(report), report["compare"]["regions"]), ([], []), model)
        report = compared(box, faced(".7"), "--model", model, wanted=1)
        equal([(f["code"], f["severity"]) for f in report["findings"]], [("EXCESS", "warning")], model)
        near(report["compare"]["excess"]["max_mm"], 0.3, 1e-5, model)
        near(report["compare"]["excess"]["volume_mm3"], 360, 2e-3, model)
        equal(compared(box, faced(".7"), "--model", model, "--fail-on", "error")["counts"], {"EXCESS": 1}, model)


@test("design: tolerances say what counts, each way for itself")
def tolerances(box):
    for words, wanted in ((("--tolerance", "0.25"), []), (("--gouge", "0.25"), []), (("--excess", "0.25"), ["GOUGE"]),
                          (("--tolerance", "0.25", "--gouge", "0.1"), ["GOUGE"]), (("--no-check", "GOUGE"), [])):
        report = compared(box, faced("1.2"), *words, wanted=1 if wanted else 0)
        equal(codes(report), wanted, words)
        near(report["compare"]["gouge"]["max_mm"], 0.2, 1e-5, "told in any case")


@test("design: the histogram is the part's area by its deviation, the middle bin about 0")
def histogram(box):
    report = compared(box, faced("1.2"), "--tolerance", "0.15", wanted=1)
    bins = report["compare"]["histogram"]
    equal(len(bins), HISTOGRAM_BINS, "bins")
    width = 4 * 0.15 / HISTOGRAM_BINS
    # Columns 0.1 from a wall of the design are no farther from its surface than that.
    beside_walls = (2 * (200 + 150) - 4) * 0.2 ** 2
    near(bins[20 - round(0.2 / width)], 1200 - beside_walls, 0.01, "the face")
    near(bins[20 - round(0.1 / width)], beside_walls, 0.01, "beside the walls")
    near(bins[20], 1200, 0.01, "the bottom")
    near(sum(bins), 2400, 0.01, "all of it")


HOLE = "G00Z5.\nT2M06\nM03\nG00X20.Y15.\nZ5.\nG01Z-{}F300\nG00Z5.\n"


@test("design: a gouge names the block that cut it, in a subprogram as well, and the calls that led there")
def names_its_block(box):
    report = compared(box, faced("1.") + HOLE.format("1.5"), wanted=1)
    equal([(f["code"], f["line"], f["tool"], f["column"]) for f in report["findings"]], [("GOUGE", 16, 2, 1)], "found")
    near(report["compare"]["gouge"]["volume_mm3"], math.pi * 25 * 0.5, 0.4, "volume")
    equal([line["line"] for line in report["compare"]["regions"][0]["lines"]], [16], "lines")
    near(report["findings"][0]["at"]["X"], 20, 5.1, "place")
    box.write("O7.nc", "O7\nG00X20.Y15.\n  G01Z-1.5F300\nG00Z5.\nM99\n")
    report = compared(box, faced("1.") + "G00Z5.\nM98P7\n", wanted=1)
    found = report["findings"][0]
    equal((found["line"], found["column"], found["program"]), (3, 3, "O0007"), "found")
    contains(found["file"], "O7.nc", "file")
    equal(report["compare"]["regions"][0]["lines"][0]["file"], found["file"], "file of the line")


@test("design: places apart are regions of their own, the largest first")
def regions(box):
    moves = "\nT2M06\nM03\nG00X10.Y15.\nZ5.\nG01Z-1.5F300\nG00Z5.\nX30.\nG01Z-2.F300\n"
    report = compared(box, moves, design=((0, 0, -20), (40, 30, 0)), wanted=1)
    equal([f["line"] for f in report["findings"]], [9, 12], "in the order of the motions")
    both = report["compare"]["regions"]
    equal([region["lines"][0]["line"] for region in both], [12, 9], "the larger one first")
    near(both[0]["centre"]["X"], 30, 0.01, "centre")
    equal({axis: [round(v) for v in both[1]["extents"][axis]] for axis in "XY"}, {"X": [5, 15], "Y": [10, 20]}, "extents")


@test("design: where it is larger than the stock no line is to blame")
def larger(box):
    report = compared(box, faced("1."), design=((-5, 0, -20), (40, 30, -1)), wanted=1)
    equal([(f["code"], f["line"]) for f in report["findings"]], [("GOUGE", 0)], "found")
    contains(report["findings"][0]["message"], "where nothing was cut", "message")
    near(report["compare"]["gouge"]["max_mm"], 5, 0.01, "deep")
    report = compared(box, faced("1."), design=((0, 0, -500), (1000, 750, -25.4)), wanted=3)


@test("design: threads share the work and change no byte, of the coloured part neither")
def threads(box):
    for model in ("zmap", "tridexel"):
        seen = set()
        for jobs in ("1", "2", "7"):
            compared(box, faced("1.2"), "--model", model, "--jobs", jobs, "--glb", "part.glb", wanted=1)
            seen.add((box.read("r.json"), box.read("part.glb")))
        equal(len(seen), 1, model)


def accessor(document, binary, number, form):
    of = document["accessors"][number]
    begin = document["bufferViews"][of["bufferView"]]["byteOffset"]
    return list(struct.iter_unpack(form, binary[begin:begin + struct.calcsize(form) * of["count"]]))


@test("design: the GLB has the deviation of every point, its colour, and their scale")
def colours(box):
    compared(box, faced("1.2"), "--glb", "part.glb", wanted=1)
    data = box.read("part.glb")
    size = struct.unpack_from("<I", data, 12)[0]
    document, binary = json.loads(data[20:20 + size]), data[20 + size + 8:]
    mesh = document["meshes"][0]
    equal(mesh["extras"]["deviation_mm"], {"blue": -0.1, "grey": 0, "red": 0.1}, "scale")
    has = mesh["primitives"][0]["attributes"]
    points = accessor(document, binary, has["POSITION"], "<3f")
    deviations = accessor(document, binary, has["_DEVIATION"], "<f")
    colours = accessor(document, binary, has["COLOR_0"], "<4B")
    for (x, y, z), (deviation,), (red, _, blue, _) in zip(points, deviations, colours, strict=True):
        if z > -1.3 and 1 < x < 39 and 1 < y < 29:
            near(deviation, -0.2, 1e-4, "the face")
            check(blue > 2 * red, "the face is blue")
        elif z < -19.9:
            near(deviation, 0, 1e-4, "the bottom")
            equal(red, blue, "the bottom is grey")


@test("design: after an alarm the part up to it is compared")
def after_alarm(box):
    report = compared(box, faced("1.2") + "G02X1.R0.1\n", wanted=1)
    equal((report["status"], codes(report)), ("alarm", ["GOUGE"]), "ended")


@test("design: the summary for people has a line of it")
def for_people(box):
    compared(box, faced("1.2"), wanted=1)
    err = box.kerf("stock", "part.nc", "--stock", STOCK, "--tools", "tools.toml", "--design", "design.stl").err
    contains(err, "against the design: too deep 0.200 mm at most, 240.0 mm³ in 1 region beyond 0.05; too high 0.000 mm at most, within 0.05", "summary")
    contains(err, "part.nc:6: cut into the design: 0.2 mm at most, 240 mm³ over 1200 mm²", "summary")


@test("design: files that are none, designs elsewhere and tolerances that are none are sentences")
def wrong(box):
    box.write("part.nc", HEAD + faced("1.") + TAIL)
    box.write("tools.toml", FACE)
    good = stl(((0, 0, -20), (40, 30, -1)))
    box.write("good.stl", good)
    lines = good.splitlines(keepends=True)
    box.write("open.stl", "".join(lines[:1] + lines[8:]))
    box.write("nan.stl", good.replace("vertex 40 30 -1", "vertex nan 30 -1", 1))
    box.write("cut.stl", b"\0" * 80 + struct.pack("<I", 4_000_000_000) + b"\0" * 500)
    box.write("text.stl", "no design at all\n")
    box.write("away.stl", stl(((100, 0, -20), (140, 30, -1))))
    base = ("stock", "part.nc", "--stock", STOCK, "--tools", "tools.toml")
    for name, part in (("none.stl", "none.stl"), ("open.stl", "open edge"), ("nan.stl", "line"), ("cut.stl", "cut.stl"),
                       ("text.stl", "text.stl"), ("away.stl", "no place in common")):
        refused(box.kerf(*base, "--design", name), 3, part)
    for option in ("--tolerance", "--gouge", "--excess"):
        for word in ("0", "-1", "nan", "inf", "1e9", "wide", ""):
            result = box.kerf(*base, "--design", "good.stl", f"{option}={word}")
            if word:
                refused(result, 2, option, word)
        refused(box.kerf(*base, option, "0.1"), 2, option, "nothing is compared")
    refused(box.kerf(*base, "--design", "good.stl", "--stl", "good.stl"), 2, "good.stl")
