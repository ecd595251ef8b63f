"""What lies on the table: files of set-ups, places, starts, meshes, comments of the program; and what is refused."""

import math
import struct

from harness import contains, equal, near, refused, status, test
from stock_tests import FLAT, HEAD, SLOT, SLOT_MM3, TAIL, cut, found

BLOCK = ((0, 0, -20), (70, 40, 0))
PAST_CLAMP = "G00X10.Y15.Z25.\nG01Z-2.F300\nG00Z10.\nX60.Y25."


def block(low, high):
    """Twelve triangles, looking outwards."""
    corners = [[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)]
    faces = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6),
             (1, 3, 5), (3, 7, 5))
    return [[corners[i] for i in face] for face in faces]


def stl(triangles):
    """Binary."""
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for corner in t for x in corner), 0) for t in triangles)
    return b"by hand".ljust(80) + struct.pack("<I", len(triangles)) + body


@test("set-up: stock, clamp and checks stand in one file, and the command line counts more")
def one_file(box):
    box.write("vice.toml", '[stock]\nshape = "box:0,0,-20,70,40,0"\nzero = "G54"\n[[fixture]]\n'
                           'shape = "box:30,10,0,50,30,15"\nname = "the rear jaw"\n')
    box.write("tools.toml", FLAT)
    box.write("part.nc", HEAD + PAST_CLAMP + TAIL)
    words = ("stock", "part.nc", "--tools", "tools.toml", "--cell", "0.2", "--report", "r.json")
    status(box.kerf(*words, "--setup", "vice.toml"), 1)
    report = box.json("r.json")
    equal(found(report), [("FIXTURE_COLLISION", 7)], "findings")
    contains(report["findings"][0]["message"], "the rear jaw", "message")
    equal(report["stock"]["shape"], "box:0,0,-20,70,40,0", "shape")
    near(report["stock"]["volume_mm3"], 56000, 1e-6, "volume")
    status(box.kerf(*words, "--setup", "vice.toml", "--stock", "box:0,0,-10,70,40,0", "--fail-on", "never"), 0)
    near(box.json("r.json")["stock"]["volume_mm3"], 28000, 1e-6, "of the command line")
    box.write("lax.toml", box.read("vice.toml") + b'[checks]\nno_check = ["FIXTURE_COLLISION"]\n')
    status(box.kerf(*words, "--setup", "lax.toml"), 0)
    equal(found(box.json("r.json")), [], "left out")
    box.write("never.toml", box.read("vice.toml") + b'[checks]\nfail_on = "never"\n')
    status(box.kerf(*words, "--setup", "never.toml"), 0)
    status(box.kerf(*words, "--setup", "never.toml", "--fail-on", "error"), 1)


@test("set-up: kerf run and kerf check take the same file")
def other_commands(box):
    box.write("vice.toml", '[stock]\nshape = "box:0,0,-20,70,40,0"\n[[fixture]]\nshape = "box:30,10,0,50,30,15"\n')
    box.write("tools.toml", FLAT)
    box.write("part.nc", HEAD + PAST_CLAMP + TAIL)
    words = ("part.nc", "--tools", "tools.toml", "--cell", "0.5", "--setup", "vice.toml")
    status(box.kerf("run", *words, "--summary", "s.json"), 1)
    equal(box.json("s.json")["counts"], {"FIXTURE_COLLISION": 1}, "run")
    result = box.kerf("check", *words)
    status(result, 1)
    contains(result.text, "FIXTURE_COLLISION", "check")


@test("set-up: what is wrong with a file is a sentence with its place")
def wrong_file(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    for text, place in (("[stock]\nshape = \"cube\"\n", "cube"), ("[stock]\nform = 1\n", "vice.toml:2:1"),
                        ("[checks]\ntouch_mm = true\n", "vice.toml:2:12"), ("[stock\n", "vice.toml:1:7"),
                        ("[[fixture]]\nshape = \"box:nan,0,0,1,1,1\"\n", "vice.toml:2:9"),
                        ("[stock]\nshape = \"none.stl\"\n", "none.stl")):
        box.write("vice.toml", text)
        refused(box.kerf("stock", "part.nc", "--setup", "vice.toml"), 3, place)
    refused(box.kerf("stock", "part.nc", "--setup", "nowhere.toml"), 3, "nowhere.toml")
    box.write("vice.toml", "[stock]\nshape = \"box:0,0,-20,70,40,0\"\n")
    refused(box.kerf("stock", "part.nc", "--setup", "vice.toml", "--report", "vice.toml"), 2, "vice.toml")


@test("set-up: an STL is a stock and a clamp, in mm and in inches, and cut as the box that it is")
def meshes(box):
    box.write("raw.stl", stl(block(*BLOCK)))
    box.write("inch.stl", stl(block(*[[x / 25.4 for x in corner] for corner in BLOCK])))
    box.write("jaw.stl", stl(block((30, 10, 0), (50, 30, 15))))
    for model in ("zmap", "tridexel"):
        for words in (("raw.stl",), ("inch.stl", "--stock-unit", "inch")):
            report = cut(box, SLOT, "--model", model, "--cell", "0.2", *words[1:], stock=words[0])
            near(report["stock"]["volume_mm3"], 56000, 0.1, "stock")
            near(report["removed_mm3"], SLOT_MM3, 0.01 * SLOT_MM3, model)
    report = cut(box, PAST_CLAMP, "--cell", "0.5", "--fixture", "jaw.stl", wanted=1)
    equal(found(report), [("FIXTURE_COLLISION", 7)], "clamp")
    contains(report["findings"][0]["message"], "jaw.stl", "message")


@test("set-up: a mesh that is no solid is refused with its open edges")
def open_mesh(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    box.write("holed.stl", stl(block(*BLOCK)[:-1]))
    box.write("short.stl", stl(block(*BLOCK))[:-20])
    box.write("nan.stl", stl([[(math.nan, 0, 0)] + t[1:] for t in block(*BLOCK)]))
    box.write("many.stl", b"\0" * 80 + b"\xff\xff\xff\xff" + b"\0" * 50)
    refused(box.kerf("stock", "part.nc", "--stock", "holed.stl"), 3, "holed.stl", "3 open edges")
    refused(box.kerf("stock", "part.nc", "--stock", "short.stl"), 3, "short.stl")
    refused(box.kerf("stock", "part.nc", "--stock", "nan.stl"), 3, "nan.stl")
    refused(box.kerf("stock", "part.nc", "--stock", "many.stl"), 3, "many.stl")
    refused(box.kerf("stock", "part.nc", "--fixture", "holed.stl"), 3, "holed.stl", "3 open edges")


@test("set-up: a stock is turned about its zero and moved, and then lies there")
def placed(box):
    for place, extents in (("0,0,0,180,0,0", {"X": [0, 70], "Y": [-40, 0], "Z": [0, 20]}),
                           ("5,0,0,0,0,90", {"X": [-35, 5], "Y": [0, 70], "Z": [-20, 0]}),
                           ("0,0,70,0,90,0", {"X": [-20, 0], "Y": [0, 40], "Z": [0, 70]})):
        report = cut(box, "G00X200.Y0.Z100.", "--stock-place", place, "--cell", "1")
        equal(report["stock"]["extents"], extents, place)
        near(report["stock"]["volume_mm3"], 56000, 1e-6, place)
    report = cut(box, "G00X200.Y0.Z100.", "--stock-place", "0,0,0,0,0,45", "--cell", "1")
    near(report["stock"]["extents"]["X"][1], 70 / math.sqrt(2), 1e-6, "at 45 degrees")
    near(report["stock"]["volume_mm3"], 56000, 1e-6, "at 45 degrees")


@test("set-up: the same slot is cut into a stock that was turned, and the program with it")
def turned_alike(box):
    stock = "box:-70,-40,-20,0,0,0"
    report = cut(box, SLOT, "--stock-place", "0,0,0,0,0,180", "--cell", "0.1", stock=stock)
    near(report["removed_mm3"], SLOT_MM3, 16, "removed")


@test("set-up: a start that is named is checked")
def start(box):
    moves = "G00Z-5.\nX10.Y20.\nG01X60.F600"
    equal(found(cut(box, moves, "--cell", "0.2")), [], "nobody knows where the axes were")
    report = cut(box, moves, "--cell", "0.2", "--start", "10,20,30", wanted=1)
    equal(found(report), [("RAPID_IN_STOCK", 4)], "from above into the stock")
    box.write("part.nc", "O1\nT0101\nG97S1000M03\nG00X60.Z2.\nM30\n")
    refused(box.kerf("stock", "part.nc", "--machine", "lathe2", "--stock", "bar:50,-80,0", "--start", "1,2,3"), 2, "X,Z")


@test("set-up: without the option the comment of the program says what the stock is")
def comments(box):
    box.write("tools.toml", FLAT)
    text = "O1\n(WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-20,XMAX=70,YMAX=40,ZMAX=0)\n" + HEAD[3:] + SLOT + TAIL
    box.write("part.nc", text)
    words = ("stock", "part.nc", "--tools", "tools.toml", "--cell", "0.1", "--report", "r.json")
    status(box.kerf(*words), 0)
    report = box.json("r.json")
    equal(report["stock"]["shape"], "box:0,0,-20,70,40,0", "shape")
    near(report["removed_mm3"], SLOT_MM3, 16, "removed")
    equal([t for t in report["not_checked"] if t.startswith("RAPID_IN_STOCK")], [], "the stock is said")
    status(box.kerf(*words, "--stock", "box:0,0,-30,70,40,0"), 0)
    near(box.json("r.json")["stock"]["volume_mm3"], 84000, 1e-6, "the option counts more")
    box.write("part.nc", text.replace(",ZMAX=0", ""))
    status(box.kerf(*words), 0)
    contains(" ".join(a["what"] for a in box.json("r.json")["assumed"]), "line 2 is no stock", "told")


@test("set-up: the touch tolerance of a set-up is that of the checks")
def touch(box):
    box.write("fine.toml", "[checks]\ntouch_mm = 0.002\n")
    box.write("coarse.toml", "[checks]\ntouch_mm = 0.5\n")
    deeper = SLOT + "\nG00X58.Y20.Z-5.1"  # 0.1 mm into the floor, at rapid
    report = cut(box, deeper, "--cell", "0.1", "--setup", "fine.toml", wanted=1)
    equal(found(report), [("RAPID_IN_STOCK", 7)], "fine")
    equal(found(cut(box, deeper, "--cell", "0.1", "--setup", "coarse.toml")), [], "coarse")


@test("set-up: a lathe's insert and drill meet its chuck, and not its bore")
def chuck(box):
    box.write("tools.toml", '[[tool]]\nnumber = 1\ntype = "turning"\ninsert = "CNMG120408"\ntip = 3\n'
                            '[[tool]]\nnumber = 2\ntype = "drill"\ndiameter = 10\n')
    words = ("stock", "part.nc", "--machine", "lathe2", "--tools", "tools.toml", "--stock", "bar:50,-80,0", "--report",
             "r.json", "--fixture", "bar:120,-100,-70,30")
    head = "O1\nT{0}\nG97S1000M03\nG00X{1}Z2.\n"
    for tool, x, z, wanted in (("0101", "40.", "-60.", []), ("0101", "40.", "-75.", [("FIXTURE_COLLISION", 5), ("FIXTURE_COLLISION", 6)]),
                               ("0202", "0", "-90.", [])):
        box.write("part.nc", head.format(tool, x) + f"G01Z{z}F.2\nG00Z2.\nM30\n")
        status(box.kerf(*words), 1 if wanted else 0)
        equal(found(box.json("r.json")), wanted, f"T{tool} to Z{z}")
    box.write("part.nc", head.format("0202", "0") + "G01Z-90.F.2\nG00Z2.\nM30\n")
    status(box.kerf(*words[:-1], "bar:120,-100,-70"), 1)
    equal(found(box.json("r.json")), [("FIXTURE_COLLISION", 5), ("FIXTURE_COLLISION", 6)], "a chuck without a bore")
    status(box.kerf(*words, "--fixture", "box:-100,-100,-200,-90,-90,0"), 0)
    contains(" ".join(a["what"] for a in box.json("r.json")["assumed"]), "not round about the spindle", "told")


@test("set-up: wrong usage is told as such")
def wrong_words(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    for words, part in ((("--stock", "box:10,0,0,0,1,1"), "X0"), (("--stock", "bar:10,-5,0"), "lathe"),
                        (("--stock", "sheet:0,0,1,1,1"), "laser"), (("--stock", "box:nan,0,0,1,1,1"), "six numbers"),
                        (("--stock", "box:0,0,0,1e300,1,1"), "six numbers"), (("--fixture", "bar:1,2,3"), "lathe"),
                        (("--fixture", "sheet:0,0,1,1,1"), "box"), (("--stock-place", "1,2"), "X,Y,Z"),
                        (("--stock-place", "1,2,3"), "--stock"), (("--stock", "extents:3", "--stock-place", "1,2,3"), "place"),
                        (("--stock-place", "1,2,x,0,0,0"), "X,Y,Z"), (("--start", "1,2"), "X,Y,Z"),
                        (("--stock-unit", "foot"), "foot")):
        refused(box.kerf("stock", "part.nc", *words), 2, part)
    refused(box.kerf("run", "part.nc", "--stock-place", "1,2,3"), 2, "--stock")


@test("set-up: a sheet is moved and turned in its plane, and no further")
def sheets(box):
    box.write("cut.nc", "O3\nG90G54\nG00X0Y0\nM03S1000\nG01X20.F1500\nY20.\nX0\nY0\nM05\nM30\n")
    words = ("stock", "cut.nc", "--machine", "laser3", "--kerf", "0.2", "--report", "r.json")
    status(box.kerf(*words, "--stock", "sheet:-30,-10,10,30,2", "--stock-place", "5,0,0,0,0,180"), 0)
    report = box.json("r.json")
    equal(report["stock"]["extents"], {"X": [-5, 35], "Y": [-30, 10], "Z": [-2, 0]}, "extents")
    for place in ("0,0,1", "0,0,0,180", "0,0,0,90,0,0", "0,0,0,0,0,30"):
        refused(box.kerf(*words, "--stock", "sheet:-30,-10,10,30,2", "--stock-place", place), 2, "--stock-place")


@test("run with a stock takes the words of the table as kerf stock does")
def words_of_run(box):
    box.write("part.nc", HEAD + SLOT + TAIL)
    box.write("tools.toml", FLAT)
    words = ("--stock", "box:0,0,-20,70,40,0", "--stock-zero", "G54", "--stock-place", "0,0,0", "--stock-unit", "mm",
             "--start", "0,0,100", "--lengths", "real", "--material", "P", "--memory", "256", "--tools", "tools.toml")
    status(box.kerf("run", "part.nc", *words), 0)
    refused(box.kerf("run", "part.nc", *words, "--kerf", "0.2"), 2, "--kerf")
    box.write("sheet.bas", "END\n")
    status(box.kerf("run", "sheet.bas", "--machine", "laser3", "--stock", "sheet:0,0,10,10,1", "--kerf", "0.2"), 0)
