"""Features on the panel: what the loaded program machines, edits that are tried, made and taken back."""

import json
import math
import subprocess
import sys
import time
from pathlib import Path

import harness  # noqa: F401
from harness import *  # noqa: F403
from stock_tests import LATHE, LATHE_SET_UP

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "programs"))
from feature_programs import FLATS, POCKET  # noqa: E402

SET_UP = FLATS
CONTOUR = [[10, 10, 0], [50, 10, 0], [50, 38, 0], [10, 38, 0]]
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


def in_library(client):
    return [p["name"] for p in client.do("programs")["programs"] if p["name"] == "part.nc"]


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


@test("a contour that cannot be is told with where it fails, and shown all the same")
def _(place):
    client = miller(place)
    for one, code, at, message, words in (
        ({"op": "delete", "feature": "F1", "element": 1}, "EDIT_OPEN", [50, 10], "OPEN BY 28 mm", {}),
        ({"op": "modify-line", "feature": "F1", "element": 0, "from": [10, 10], "to": [50, 60]}, "EDIT_CROSSES_ITSELF", None, "CROSS AT", {}),
        ({"op": "fillet", "feature": "F1", "corner": 0, "r": 100}, "EDIT_DOES_NOT_FIT", None, "FILLET", {}),
        (replaced(feature="F9"), "EDIT_FEATURE_UNKNOWN", None, "F9", {}),
        (replaced(layer=7), "EDIT_LAYER_UNKNOWN", None, "LAYER 7", {}),
    ):
        for until in ("contour", "paths", "verified"):
            answer = client.do("feature_preview", edits=edits(replaced(layer=1, contour=CONTOUR), one), until=until)
            problem = answer["problem"]
            equal((problem["edit"], problem["line"], problem["column"], problem["code"]), (1, 3, 1, code), f"{one} until {until}")
            says(problem["message"], message)
            if at is not None:
                equal(problem["at"], at, "where it fails")
            check("loops" not in answer and "report" not in answer and answer["contours"], f"{answer}")
    crossing = client.do("feature_preview", edits=edits(moved(0, [10, 10], [50, 60])))
    equal([len(c["elements"]) for c in crossing["contours"]], [4, 4], "both layers, as they cross")
    check(isinstance(crossing["problem"]["at"], list), "the crossing has a place")
    for text, line, column in (("", 1, 1), ('{"version":2}', 1, 12), ("[1,2", 1, 5), ('{"version":1,"edits":[{"op":"fly"}]}', 1, None), ("\x00\xff", 1, 1)):
        problem = client.do("feature_preview", edits=text)["problem"]
        equal((problem["edit"], problem["code"], problem["line"]), (None, "EDIT_FILE", line), f"{text!r}")
        says(problem["message"], "the edits file cannot be read: ")
    says(client.refused("feature_preview", edits="x" * 1_000_001), "edits")
    says(client.refused("feature_preview", edits=edits(), until="never"), "until")


@test("a preview that is verified has the report of the edit, and what does not fit is a problem")
def _(place):
    client = miller(place)
    text = edits(replaced())
    answer = client.do("feature_preview", edits=text, until="verified")
    (place.folder / "edits.json").write_text(text)
    told_by_command(place)
    made = subprocess.run([place.kerf, "edit", "part.nc", "--machine", "mill3", "--setup", "setup.toml", "--edits", "edits.json", "--diff", "-",
                           "--report", "report.json"], cwd=place.folder, capture_output=True, text=True, timeout=60 * harness.PATIENCE)
    equal(made.returncode, 0, made.stderr)
    equal(answer["report"], json.loads((place.folder / "report.json").read_text()), "the report")
    equal(answer["diff"], made.stdout, "the diff")
    small = [[10, 10, 0], [18, 10, 0], [18, 18, 0], [10, 18, 0]]
    problem = client.do("feature_preview", edits=edits(replaced(contour=small)))["problem"]
    equal(problem["code"], "EDIT_TOOL_TOO_BIG", "a pocket that is narrower than the tool")


@test("an edit that is made becomes the next revision and is loaded, and is taken back to the byte, also after a restart")
def _(place):
    client = miller(place)
    says(client.refused("feature_undo"), "part.nc")
    wider = [[10, 10, 0], [54, 10, 0], [54, 38, 0], [10, 38, 0]]
    first = client.do("feature_apply", edits=edits(replaced(layer=1, contour=wider)))
    equal((first["name"], first["report"]["verified"]["recognised"]), ("part.nc", True), "what is told")
    once = client.do("read", name="part.nc")["text"]
    check(once != POCKET and "X54" not in once and "X49." in once, "the text")
    client.wait_for(lambda: [e for e in client.events if e["event"] == "features"][-1]["revision"] == first["revision"], "the event")
    tree = client.do("features")
    equal((tree["revision"], tree["features"]), (first["revision"], told_by_command(place, once)), "what is loaded now")
    deeper = client.do("feature_apply", edits=edits({"op": "hole-move", "feature": "H1", "to": [12, 52]}))
    twice = client.do("read", name="part.nc")["text"]
    check(deeper["library_revision"] > first["library_revision"] and twice != once, "the second one")
    kept = [r["revision"] for r in client.do("revisions", name="part.nc")["revisions"]]
    texts = [client.do("read", name="part.nc", revision=r)["text"] for r in kept]
    equal(texts, [twice, once, POCKET], "revisions, the newest first")
    place.servers[0].stop()
    again = place.serve().client().watch("miller")
    answer = again.do("feature_undo")
    equal((answer["left"], answer["name"]), (1, "part.nc"), "how many are left")
    equal(again.do("read", name="part.nc")["text"], once, "one is taken back")
    equal(again.do("features")["features"], told_by_command(place, once), "and loaded")
    again.do("write", name="part.nc", text=once + "(NOTE)\n")
    equal(again.ask("feature_undo")["code"], "EDIT_CHANGED_SINCE", "something else was written")
    again.do("write", name="part.nc", text=once)
    equal(again.do("feature_undo")["left"], 0, "the first one")
    equal(again.do("read", name="part.nc")["text"], POCKET, "to the byte")
    equal(again.ask("feature_undo")["code"], "nothing-to-undo", "no more")


@test("what is refused writes nothing, and nothing is made or taken back while the program runs")
def _(place):
    client = miller(place)
    answer = client.ask("feature_apply", edits=edits(replaced(), {"op": "delete", "feature": "F1", "layer": 2, "element": 1}))
    equal((answer["ok"], answer["code"], answer["values"]["edit"], answer["values"]["line"]), (False, "EDIT_OPEN", "1", "3"), "refused")
    equal(client.ask("feature_apply", edits="{")["code"], "EDIT_FILE", "no edits file")
    equal(in_library(client), [], "nothing is written")
    same = client.do("feature_apply", edits=edits(replaced(contour=CONTOUR)))
    equal((same["library_revision"], [w["code"] for w in same["report"]["warnings"]]), (None, ["EDIT_NO_CHANGE"]), "no change")
    equal(in_library(client), [], "nor then")
    looker = Client(place.servers[0])
    looker.watch("miller", operate=False)
    equal(looker.ask("feature_apply", edits=edits(replaced()))["code"], "operated-by", "who only looks")
    check(looker.do("feature_preview", edits=edits(replaced()))["problem"] is None, "may try")
    client.do("mode", mode="auto")
    client.do("cycle-start")
    client.wait_for_status("running")
    for do in ("feature_apply", "feature_undo"):
        answer = client.ask(do, **({"edits": edits(replaced())} if do == "feature_apply" else {}))
        says(answer["error"], "running")
        equal(answer["ok"], False, do)
    check(client.do("feature_preview", edits=edits(replaced()))["problem"] is None, "trying is no work of the machine")
    equal(in_library(client), [], "nothing is written")


@test("of a client's previews the newest is answered, of two clients each his own")
def _(place):
    client = miller(place)
    client.do("features")
    numbers = [client.post("feature_preview", edits=edits(replaced()), until="verified") for _ in range(12)]
    answers = [client.answer(n) for n in numbers]
    check(answers[-1]["ok"] and answers[-1]["report"], "the last one")
    for answer in answers:
        check(answer["ok"] or answer["code"] == "preview-replaced", f"{answer}")
    check(sum(a["ok"] for a in answers) < 12, "some have been replaced")
    other = Client(place.servers[0])
    other.watch("miller", operate=False)
    for _ in range(5):
        pair = [(who, who.post("feature_preview", edits=edits(replaced(contour=contour))))
                for who, contour in ((client, NARROWER), (other, CONTOUR))]
        mine, his = (who.answer(number) for who, number in pair)
        check(mine["changes"] and not his["changes"], "each has what he asked for")
    other.close()
    check(client.do("feature_preview", edits=edits(replaced()))["ok"], "one leaves")


@test("another set-up, another program and another machine file are another revision")
def _(place):
    client = miller(place)
    first = client.do("features")
    equal(first["features"]["stock"]["source"], "assumed", "nobody has said what lies there")
    set_up = '[stock]\nshape = "box:0,0,-20,70,60,0"\n' + SET_UP
    client.do("stock", toml=set_up)
    second = client.do("features")
    check(second["revision"] > first["revision"], "it grows")
    equal(second["features"], told_by_command(place, POCKET, set_up), "with the stock")
    client.load(POCKET.replace("Z-4.", "Z-3."), "other.nc")
    third = client.do("features")
    check(third["revision"] > second["revision"] and third["features"]["features"][0]["depth"] == 3, "the other program")
    revisions = [e["revision"] for e in client.events if e["event"] == "features"]
    equal(revisions, sorted(revisions), "events")


@test("a set-up that is answered is the one that features are told with")
def _(place):
    client = miller(place)
    before = client.do("features")["revision"]
    for depth in range(20, 50):
        client.do("stock", toml=f'[stock]\nshape = "box:0,0,-{depth},70,60,0"\n' + SET_UP)
        told = client.do("features")
        equal(told["features"]["stock"]["extents"]["Z"], [-depth, 0], "told with the new one")
        check(told["revision"] > before, "it grows")
        before = told["revision"]


@test("without a program, of an alarm and of no mill there are sentences")
def _(place):
    server = place.serve()
    client = server.client()
    client.do("create", name="miller", definition="mill3")
    client.watch("miller")
    for do, more in (("features", {}), ("feature_preview", {"edits": edits()}), ("feature_apply", {"edits": edits()}), ("feature_undo", {}), ("insight", {})):
        equal(client.ask(do, **more)["code"], "no-program", do)
    client.load(POCKET.replace("N430 T2 M06", "N430 G01 X[1/0]"), "alarm.nc")
    client.do("stock", toml=SET_UP)
    answer = client.do("features")["features"]
    equal((answer["status"], [f["type"] for f in answer["features"]]), ("alarm", ["pocket"]), "up to the alarm")
    problem = client.do("feature_preview", edits=edits(replaced()))["problem"]
    says(problem["message"], "THE PROGRAM ENDS IN AN ALARM")
    equal(client.ask("feature_apply", edits=edits(replaced()))["code"], "EDIT_NOT_EDITABLE", "nor made")
    client.do("create", name="fourth", definition="arm4")
    client.watch("fourth")
    client.load("MOVE(10,10,0)\nEND\n", "arm.bas")
    says(client.refused("features"), "mills and lathes")


@test("the contour of a turned part is edited like any other")
def _(place):
    client = place.serve().client()
    client.do("create", name="turner", definition="lathe2")
    client.watch("turner")
    client.load(LATHE, "shaft.nc")
    client.do("stock", toml=LATHE_SET_UP)
    answer = client.do("features")
    equal(answer["features"], told_by_command(place, LATHE, LATHE_SET_UP, machine="lathe2", file="shaft.nc"), "the tree")
    (turning,) = [f for f in answer["features"]["features"] if f["type"] == "turning"]
    contour = turning["contour"]
    farther = [[-12 if z == -10 else z, x, b] for z, x, b in contour]
    text = edits({"op": "replace", "feature": turning["id"], "contour": farther})
    preview = client.do("feature_preview", edits=text, until="verified")
    equal(preview["problem"], None, "problem")
    equal([[e["from"] for e in c["elements"]] for c in preview["contours"]], [[p[:2] for p in farther[:-1]]], "elements")
    check(preview["added"] and not preview["removed"], "more is cut")
    ends = {z for loop in preview["loops"] for path in loop["paths"] for z, _, _ in path}
    check(-12 in ends, f"where the ways end: {ends}")
    check(abs(preview["report"]["verified"]["difference_mm3"] - math.pi * (20**2 - 15**2) * 2) < 1e-3, "what is cut more")


@test("a program that never ends holds nobody up: another one is loaded, and told at once")
def _(place):
    client = miller(place)
    client.do("load", name="endless.nc", text="O1\nS1000 M03\nT1 M06\nG00 X0. Y0. Z5.\nN1 G01 Z-1. F100\nX10.\nG00 Z5.\nX0.\nGOTO 1\nM30\n")
    waiting = [client.post("features"), client.post("feature_preview", edits=edits(replaced()), until="paths"), client.post("insight")]
    time.sleep(0.3)
    begin = time.monotonic()
    check(client.do("machines")["machines"], "the server goes on")
    client.do("load", name="part.nc", text=POCKET)
    tree, preview, card = (client.answer(number) for number in waiting)
    check(time.monotonic() - begin < 20 * harness.PATIENCE, "soon")
    equal(tree["features"], told_by_command(place), "the one that is loaded now")
    check(preview["problem"] is None and card["size"]["bytes"] == len(POCKET), f"{preview['problem']}, {card['size']}")
    revision = client.do("features")["revision"]
    client.do("load", name="endless.nc", text="O1\nS1000 M03\nT1 M06\nN1 G01 X10. F100\nX0.\nGOTO 1\nM30\n")
    client.post("features")
    place.servers[0].client().do("machines")
    client.close()
    begin = time.monotonic()
    equal(place.servers[0].stop(), 0, "it ends")
    check(time.monotonic() - begin < 10 * harness.PATIENCE and revision > 0, "and soon")


@test("the card of a program tells its size, tools, ways and features, and what nobody has")
def _(place):
    client = miller(place)
    answer = client.do("insight")
    client.do("features")
    answer = client.do("insight")
    equal(answer["size"], {"lines": POCKET.count("\n"), "bytes": len(POCKET)}, "size")
    equal([(t["tool"], t["description"]) for t in answer["tools"]], [(1, "Ø10 flat"), (2, "Ø6 flat")], "tools")
    equal(answer["features"], {"pocket": 1, "hole": 1}, "features")
    equal((answer["status"], answer["alarm"], answer["missing"], answer["not_understood"]), ("end", None, [], []), "how it ends")
    path = [e for e in client.events if e["event"] == "path"][-1]
    check(abs(answer["time_s"] - path["time_s"]) < 1e-6, f"{answer['time_s']} s, and the preview {path['time_s']} s")
    check(abs(sum(t["time_s"] for t in answer["tools"]) - answer["time_s"]) < 0.1 * answer["time_s"], "the tools' times")
    first, second = answer["tools"]
    check(abs(first["cut_mm"] - (7 + 9 + 2 * (56 + 96 + math.hypot(5, 5)))) < 1e-3, f"T1 cuts {first['cut_mm']} mm")
    check(abs(second["cut_mm"] - 17) < 1e-9 and second["cut_s"] > 0, f"T2 cuts {second['cut_mm']} mm")
    equal(second["lines"][0] > first["lines"][0], True, "lines")
    z = [t for t in answer["travel"] if t["axis"] == "Z"][0]
    equal((z["from"], z["limit_from"] < z["from"]), (-12, True), "travel")
    client.load(POCKET.replace("N430", "M98 P1234\nG01 X[1/0]\nN430"), "calls.nc")
    answer = client.do("insight")
    equal([(m["line"]) for m in answer["missing"]], [28], "calls")
    equal(answer["missing"][0]["program"], "O1234", "whose program is missing")
    says(answer["missing"][0]["message"], "there is no program O1234")
    equal([f["line"] for f in answer["not_understood"]], [29], "findings")
    equal(answer["status"], "alarm", "status")
