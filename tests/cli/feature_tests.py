"""kerf features: the tree of programs whose figures are known, as JSON and as text."""

import json

from harness import equal, near, refused, status, test

FLATS = """[[tool]]
number = 1
type = "flat"
diameter = 10
[[tool]]
number = 2
type = "flat"
diameter = 6
"""

# Two layers of two loops, a profile with four arcs, a circle, two plunges.
PART = """G21 G90 G17
T1 M06
G00 X0. Y0. Z5. S3000 M03
G00 X20. Y20.
G01 Z-2. F100
G01 X40. F300
Y28.
X20.
Y20.
X15. Y15.
X45.
Y33.
X15.
Y15.
G00 Z5.
X20. Y20.
G01 Z-4. F100
X40. F300
Y28.
X20.
Y20.
X15. Y15.
X45.
Y33.
X15.
Y15.
G00 Z5.
X80. Y10.
G01 Z-6. F100
G01 X110. F250
G03 X115. Y15. I0 J5.
G01 Y35.
G03 X110. Y40. I-5. J0
G01 X80.
G03 X75. Y35. I0 J-5.
G01 Y15.
G03 X80. Y10. I5. J0
G00 Z5.
X65. Y60.
G01 Z-3. F100
G02 X65. Y60. I-3. J0 F250
G00 Z5.
T2 M06
G00 X10. Y50.
G01 Z-12. F80
G00 Z5.
X30. Y50.
G01 Z-12.
G00 Z5.
M30
"""


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
