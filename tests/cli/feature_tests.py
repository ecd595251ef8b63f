"""kerf features: the tree of programs whose figures are known, as JSON and as text."""

import json
import sys
from pathlib import Path
from xml.etree import ElementTree

from harness import contains, equal, near, refused, status, test

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "programs"))
from feature_programs import FLATS, PART  # noqa: E402

MACRO = """O1
T1 M6
S2000 M3
G90 G54 G0 X0 Y0
G43 H1 Z20.
G65 P9100 X40. Y10. Z-3. F200. W5
M30
O9100
G0 X10. Y10.
G1 Z#26 F100.
X#24 F#9
G0 Z5.
M99
"""


@test("features: --probe-arguments says what each argument of a call reaches")
def probe_arguments(box):
    box.write("part.nc", MACRO)
    box.write("tools.toml", FLATS)
    words = ("features", "part.nc", "--tools", "tools.toml", "--format", "json")
    call = json.loads(box.kerf(*words).text)["calls"][0]
    equal({one["letter"]: one["affects"] for one in call["arguments"]}, dict.fromkeys("XYZFW"), "not asked")
    call = json.loads(box.kerf(*words, "--probe-arguments").text)["calls"][0]
    equal({one["letter"]: one["affects"] for one in call["arguments"]},
          {"X": ["position", "contour"], "Y": ["nothing"], "Z": ["depth"], "F": ["feed"], "W": ["nothing"]}, "reached")


def tree_of(box, program, *words, tools=FLATS, wanted=0):
    """The JSON of a program."""
    box.write("part.nc", program)
    box.write("tools.toml", tools)
    result = box.kerf("features", "part.nc", "--format", "json", "--tools", "tools.toml", *words)
    status(result, wanted)
    return json.loads(result.text)


@test("features: rows alone tell layers, loops, pockets, side milling and holes")
def literal(box):
    tree = tree_of(box, PART)["literal"]
    equal([layer["lines"] for layer in tree["layers"]], [[6, 14], [18, 26], [30, 37], [41, 41]], "lines")
    equal([layer["z"] for layer in tree["layers"]], [-2, -4, -6, -3], "z")
    for layer in tree["layers"][:2]:
        equal((layer["perimeters"], layer["areas"]), ([56, 96], [160, 540]), "loops")
    near(tree["layers"][2]["perimeters"][0], 131.415927, 1e-6, "perimeter")
    near(tree["layers"][2]["areas"][0], 1178.539816, 1e-6, "area")
    near(tree["layers"][3]["areas"][0], -28.274334, 1e-6, "area of the circle")
    found = [(f["layers"], f["type"], f["kind"], f["order"]) for f in tree["features"]]
    equal(found, [([1, 2], "pocket", 1, "inside-out"), ([3], "side-milling", None, "undefined"),
                  ([4], "pocket", 2, "undefined")], "features")
    equal([(h["at"], h["z"], h["line"]) for h in tree["holes"]], [([10, 50], -12, 45), ([30, 50], -12, 48)], "holes")


@test("features: an operation tells its lines, feeds and how far it cut")
def operations(box):
    tree = tree_of(box, PART)
    first, second = tree["operations"]
    equal((first["tool"], second["tool"]), (1, 2), "tools")
    equal(first["feeds"], {"cut": [300, 250], "entry": [100]}, "feeds")
    near(first["cut_mm"], 503.407618, 1e-6, "cut")
    equal(tree["stock"]["extents"], {"X": [2, 125], "Y": [0, 73], "Z": [-17, 0]}, "assumed stock")
    equal((tree["status"], tree["kerf"], tree["version"]), ("end", "features", 1), "head")


@test("features: after an alarm the tree has what was cut up to it")
def alarm(box):
    tree = tree_of(box, PART.replace("T2 M06", "#1=1/0"), wanted=1)
    equal((tree["status"], len(tree["literal"]["layers"]), tree["literal"]["holes"]), ("alarm", 4, []), "tree")
    equal(tree["alarm"]["line"], 43, "place")


@test("features: a laser has none")
def laser(box):
    box.write("part.nc", PART)
    refused(box.kerf("features", "part.nc", "--machine", "laser3"), 2, "features are recognised on mills and lathes")


def feature(tree, number):
    return tree["features"][number - 1]


@test("features: what is swept tells pocket, profile and holes, with their figures")
def swept(box):
    tree = tree_of(box, PART)
    equal([f["type"] for f in tree["features"]], ["pocket", "outside-profile", "pocket"], "types")
    pocket = feature(tree, 1)
    near(pocket["volume_mm3"], 4394.159265, 1e-5, "volume")
    equal((pocket["key"], pocket["order"], pocket["strategy"], pocket["direction"]),
          ("5b3956dc", "inside-out", "contour-parallel", "climb"), "pocket")
    equal([point[:2] for point in pocket["nominal"]], [[10, 10], [50, 10], [50, 38], [10, 38]], "nominal")
    equal([layer["lines"] for layer in pocket["layers"]], [[6, 14], [18, 26]], "layers")
    near(feature(tree, 2)["volume_mm3"], 7884.955592, 1e-5, "profile")
    equal([(h["at"], h["form"], h["depth"]) for h in tree["holes"]],
          [([10, 50], "plain", 12), ([30, 50], "plain", 12)], "holes")
    equal((tree["unrecognised"], tree["disagreements"]), ([], []), "nothing is left")


@test("features: one method alone")
def methods(box):
    equal(tree_of(box, PART, "--method", "literal")["features"], [], "swept ones")
    tree = tree_of(box, PART, "--method", "swept")
    equal((len(tree["features"]), tree["literal"]["layers"], feature(tree, 1)["literal"]), (3, [], None), "literal ones")


@test("features: the tree as text hangs layers on features, and tells what is assumed")
def text(box):
    box.write("part.nc", PART)
    box.write("tools.toml", FLATS)
    result = box.kerf("features", "part.nc", "--tools", "tools.toml")
    status(result, 0)
    for line in ("S1 G54", "├ O1 T1 Ø10 flat S3000",
                 "│ ├ F1 pocket 40 × 28  Z0…-4  2 layers  inside-out  climb  1098.540 mm²  4394.159 mm³  lines 4-27",
                 "│ │ ├ 1  Z-2  lines 6-14  2 loops", "H1 hole plain Ø6  X10 Y50  Z0…-12", "assumed: the stock is a box"):
        contains(result.text, line, "tree")


@test("features: the picture has a group for each feature and hole")
def picture(box):
    box.write("part.nc", PART)
    box.write("tools.toml", FLATS)
    result = box.kerf("features", "part.nc", "--tools", "tools.toml", "--format", "svg")
    status(result, 0)
    root = ElementTree.fromstring(result.text)
    groups = {g.get("id"): g for g in root.iter("{http://www.w3.org/2000/svg}g")}
    equal(sorted(groups), ["F1", "F2", "F3", "H1", "H2", "part"], "groups")
    equal((groups["F1"].get("class"), groups["F1"].get("data-key"), groups["F1"].get("data-lines")),
          ("pocket", "5b3956dc", "4-27"), "pocket")
    classes = [path.get("class") for path in groups["F1"].iter("{http://www.w3.org/2000/svg}path")]
    equal(classes, ["layer", "layer", "nominal", "tool", "tool"], "paths")


@test("features: with a stock that is known, ends are open and holes go through")
def stock(box):
    program = "T1M06\nS2000M03\nG90G54G00X-8.Y20.\nG43H01Z5.\nG01Z-3.F200.\nX68.F500.\nG00Z5.\nT2M06\nG00X30.Y5.\nG01Z-21.F80.\nG00Z5.\nM30\n"
    tree = tree_of(box, program, "--stock", "box:0,0,-20,60,40,0")
    slot, hole = feature(tree, 1), tree["holes"][0]
    equal((slot["type"], slot["width"], slot["length"], slot["open_ends"]), ("slot", 10, 60, 2), "slot")
    equal((hole["through"], slot["confidence"]), (True, 1), "sure")


@test("features: what of the table has no effect is told, and what cannot have one is refused")
def table(box):
    tree = tree_of(box, PART, "--fixture", "box:0,0,-40,10,10,-20", "--stock", "box:0,0,-20,130,80,0")
    told = [one["what"] for one in tree["assumed"] if "has no effect" in one["what"]]
    equal(len(told), 1, "notes")
    refused(box.kerf("features", "part.nc", "--start", "0,0,0"), 2, "--start")


@test("features: a set-up says what lies on the table")
def set_up(box):
    box.write("table.toml", '[stock]\nshape = "box:0,0,-20,130,80,0"\nplace = [0, 0, 0]\nzero = "G54"\n')
    tree = tree_of(box, PART, "--setup", "table.toml")
    equal(tree["stock"]["source"], "given", "stock")
    words = ("--stock-zero", "G54", "--stock-place", "0,0,-1", "--stock-unit", "mm")
    tree = tree_of(box, PART, "--stock", "box:0,0,-20,130,80,0", *words)
    equal(tree["stock"]["extents"]["Z"], [-21, -1], "placed stock")


LOOP = """T1M06
S3000M03
G90G54G00X30.Y25.
G43H01Z5.
G01Z-4.F100.
#2=0
WHILE[#2LE10]DO1
#3=10+#2
G01X[30-#3]Y[25-#2]F400.
X[30+#3]
Y[25+#2]
X[30-#3]
Y[25-#2]
#2=#2+5
END1
G00Z5.
M98P200L2
G65P9100X90.Y40.A3
M30
O200
G00X100.Y10.
G01Z-3.F100.
X120.F300.
G00Z5.
M99
O9100
#5=0
WHILE[#5LT#1]DO1
G00X[#24+#5*10]Y#25
G01Z-9.F80.
G00Z5.
#5=#5+1
END1
M99
"""


@test("features: a contour knows whether a loop, a call or an argument has made it")
def origins(box):
    tree = tree_of(box, LOOP)
    pocket, slot = feature(tree, 1), feature(tree, 2)
    equal((pocket["origin"]["kind"], pocket["origin"]["lines"], pocket["editable"]), ("loop", [7, 15], "unroll"), "loop")
    equal((slot["origin"]["kind"], slot["editable"]), ("shared", "shared"), "subprogram that runs twice")
    hole = tree["holes"][0]
    call = tree["calls"][int(hole["origin"]["call"][1:]) - 1]
    equal((hole["origin"]["kind"], hole["editable"]), ("expression", "argument"), "argument")
    equal((call["code"], call["program"], call["line"]), ("G65", "O9100", 18), "call")
    equal([(a["letter"], a["variable"], a["text"]) for a in call["arguments"]],
          [("X", 24, "90."), ("Y", 25, "40."), ("A", 1, "3")], "arguments")


INSERTS = """[[tool]]
number = 1
type = "turning"
nose_radius = 0
tip = 3
kapr = 95
tip_angle = 80
ic = 40
[[tool]]
number = 3
type = "grooving"
width = 3
tip = 3
[[tool]]
number = 5
type = "drill"
diameter = 10
[[tool]]
number = 6
type = "threading"
profile_angle = 60
[[tool]]
number = 8
type = "boring-bar"
nose_radius = 0
tip = 2
"""

TURNED = """G97S1000M03
T0101
G00X52.Z0.
G01X-1.F0.2
G00Z2.
G00X46.
G01Z-60.F0.25
G00X48.Z2.
G00X40.
G01Z-60.F0.25
X50.
G00X100.Z50.
T0303
G00X42.Z-30.
G01X34.F0.05
G00X42.
Z-32.
G01X34.
G00X42.
G00X100.Z50.
T0505
G00X0.Z2.
G01Z-25.F0.1
G00Z2.
G00X100.Z50.
T0606
G00X44.Z5.
G92X39.4Z-20.F1.5
X38.6
X38.16
G00X100.Z50.
T0808
G00X9.Z2.
G00X16.
G01Z-12.F0.1
X12.Z-14.
X10.
G00Z50.
M30
"""


@test("features: a facing cut may be fed in before, and lie beyond the axis")
def infed_facing(box):
    for side in ("", "-"):
        program = (f"O1\nT0101\nG97S900M03\nG00X{side}54.Z2.\nG01Z-1.F0.2\nX0.\nG00Z2.\nX{side}54.\n"
                   "G01Z-2.\nX0.\nG00Z2.\nX100.Z50.\nM30\n")
        tree = tree_of(box, program, "--machine", "lathe2", "--stock", "bar:50,-100,0", tools=INSERTS)
        equal([(feature["type"], feature["z"]) for feature in tree["features"]], [("facing", [0, -2])], "on side " + side)


@test("features: a lathe's are faces, contours with their elements, grooves, threads and bores")
def lathe(box):
    tree = tree_of(box, TURNED, "--machine", "lathe2", "--stock", "bar:50,-100,1", tools=INSERTS)
    equal([f["type"] for f in tree["features"]],
          ["facing", "turning", "groove", "drilling", "thread", "boring"], "types")
    face, turned, groove, drilled, thread, bored = tree["features"]
    equal(face["z"], [1, 0], "face")
    equal((turned["contour"], [p["x"] for p in turned["passes"]]),
          ([[0, 40, 0], [-60, 40, 0], [-60, 50, 0]], [46, 40]), "turning")
    near(turned["volume_mm3"], 42411.500823, 1e-5, "turned volume")
    equal((groove["width"], groove["bottom_x"], groove["z"], groove["parent"]["id"]), (5, 34, [-27, -32], "F2"), "groove")
    near(groove["volume_mm3"], 1743.583925, 1e-5, "volume of the groove")
    equal((drilled["diameter"], drilled["depth"], drilled["steps"][0]["how"]), (10, 25, "drill"), "drilling")
    equal((thread["pitch"], thread["major"], thread["minor"], thread["hand"], thread["starts"], thread["z"]),
          (1.5, 40, 38.16, "right", 1, [5, -20]), "thread")
    equal((bored["outer"], [e["kind"] for e in bored["elements"]]), (False, ["cylinder", "chamfer", "shoulder"]), "boring")
    equal(tree["unrecognised"], [], "nothing is left")


@test("features: the shape of G71 and G70 is one contour, roughed and finished")
def lathe_shape(box):
    program = "T0101\nG97S900M03\nG00X62.Z2.\nG71U2.R0.5\nG71P10Q20U0.4W0.1F0.25\nN10G00X20.\nG01Z-20.F0.12\nX30.Z-30.\nZ-50.\nN20X62.\nG70P10Q20\nG00X100.Z50.\nM30\n"
    tree = tree_of(box, program, "--machine", "lathe2", "--stock", "bar:60,-100,0", tools=INSERTS)
    equal(len(tree["features"]), 1, "features")
    turned = feature(tree, 1)
    equal((turned["origin"]["kind"], turned["origin"]["shape"], turned["editable"]), ("cycle-shape", [6, 10], "contour"), "origin")
    equal([cut["role"] for cut in turned["cuts"]], ["rough", "finish"], "cuts")
    equal(turned["contour"], [[0, 20, 0], [-20, 20, 0], [-30, 30, 0], [-50, 30, 0], [-50, 60, 0]], "contour")


@test("features: beyond --max-seconds or --memory the rest is told as not recognised, and the exit status is 5")
def bounds(box):
    lines = "".join(f"X{i * 37 % 100}.Y{i * 61 % 80}.\n" for i in range(30000))
    box.write("part.nc", f"T1M06\nS1000M03\nG00X0Y0Z5.\nG01Z-2.F100\n{lines}G00Z5.\nM30\n")
    for bound in (["--memory", "1"], ["--max-seconds", "0.02"]):
        result = box.kerf("features", "part.nc", "--format", "json", *bound)
        equal(result.status, 5, f"status with {bound}")
        contains(result.err, "BUDGET", f"what is told with {bound}")
