"""Features on the panel: what the loaded program machines, edits that are tried, made and taken back."""

import difflib
import json
import subprocess

import harness  # noqa: F401
from harness import *  # noqa: F403

# A pocket of two layers and a hole.
POCKET = """O1
N20 T1 M06
N30 G00 X0. Y0. Z5. S3000 M03
N40 G00 X20. Y20.
N50 G01 Z-2. F100
N60 G01 X40. F300
N70 Y28.
N80 X20.
N90 Y20.
N100 X15. Y15.
N110 X45.
N120 Y33.
N130 X15.
N140 Y15.
N150 G00 Z5.
N160 X20. Y20.
N170 G01 Z-4. F100
N180 X40. F300
N190 Y28.
N200 X20.
N210 Y20.
N220 X15. Y15.
N230 X45.
N240 Y33.
N250 X15.
N260 Y15.
N270 G00 Z5.
N430 T2 M06
N440 G00 X10. Y50.
N450 G01 Z-12. F80
N460 G00 Z5.
N500 M30
"""
SET_UP = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 10\n[[tool]]\nnumber = 2\ntype = "flat"\ndiameter = 6\n'
NARROWER = [[10, 10, 0], [40, 10, 0], [40, 38, 0], [10, 38, 0]]


def edits(*all):
    """The text of an edits file, an edit a line."""
    return '{"version":1,"edits":[\n' + ",\n".join(json.dumps(one) for one in all) + "]}\n"


def replaced(contour=NARROWER, feature="F1", layer=2):
    return {"op": "replace", "feature": feature, "layer": layer, "contour": contour}


def moved(element, start, end, **more):
    return {"op": "modify-line", "feature": "F1", "element": element, "from": start, "to": end, **more}


def miller(place, name="miller", definition="mill3", set_up=SET_UP, program=POCKET, file="part.nc"):
    client = place.serve().client()
    client.do("create", name=name, definition=definition)
    client.watch(name)
    client.load(program, file)
    if set_up is not None:
        client.do("stock", toml=set_up)
    return client


def told_by_command(place, program=POCKET, set_up=SET_UP, *words, machine="mill3", file="part.nc"):
    """What `kerf features` says of the same."""
    (place.folder / file).write_text(program)
    (place.folder / "setup.toml").write_text(set_up)
    made = subprocess.run([place.kerf, "features", file, "--machine", machine, "--setup", "setup.toml", "--format", "json", *words],
                          cwd=place.folder, capture_output=True, text=True, timeout=60 * harness.PATIENCE)
    check(made.stdout, f"kerf features: {made.stderr}")
    told = json.loads(made.stdout)
    told.pop("chosen", None)  # by the words of the command line
    return told


@test("what the loaded program machines is told as `kerf features` tells it, by each method")
def _(place):
    client = miller(place)
    answer = client.do("features")
    equal(answer["features"], told_by_command(place), "the tree")
    equal([f["type"] for f in answer["features"]["features"]], ["pocket"], "types")
    for method in ("both", "swept", "literal"):
        equal(client.do("features", method=method)["features"], told_by_command(place, POCKET, SET_UP, "--method", method), method)
    check("truncated" not in answer and answer["revision"] > 0, f"{answer['revision']}")


@test("a preview tells contours, ways, areas and the text that an edit makes, and changes nothing")
def _(place):
    client = miller(place)
    revision = client.do("features")["revision"]
    answer = client.do("feature_preview", edits=edits(replaced()))
    equal((answer["problem"], answer["revision"]), (None, revision), "problem and revision")
    (contour,) = answer["contours"]
    equal((contour["feature"], contour["layer"], contour["island"], contour["closed"]), ("F1", 2, None, True), "which contour")
    equal([(e["id"], e["from"], e["to"], e["bulge"]) for e in contour["elements"]],
          [(k, NARROWER[k][:2], NARROWER[(k + 1) % 4][:2], 0) for k in range(4)], "its elements")
    (loops,) = answer["loops"]
    equal((loops["feature"], loops["layer"], loops["z"]), ("F1", 2, -4), "which loops")
