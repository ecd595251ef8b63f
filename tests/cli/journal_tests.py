"""kerf replay: what was done at a panel is done again."""

import json
import os

from harness import contains, equal, refused, status, test

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "live", "journals")


def journal():
    with open(os.path.join(FOLDER, "operated.journal.json"), encoding="utf-8") as file:
        return json.load(file)


@test("kerf replay says where a journal ends")
def end(box):
    result = box.kerf("replay", os.path.join(FOLDER, "operated.journal.json"))
    status(result, 1)
    lines = result.text.splitlines()
    equal(lines[0], "status: alarm", "status")
    contains(lines[2], "alarm: part.nc:15: PS0112", "the alarm and its place")


@test("kerf replay refuses what is no journal, is damaged or has a value out of its range")
def foreign(box):
    box.write("part.nc", "O1\nM30\n")
    refused(box.kerf("replay", "part.nc"), 3, "not a journal")
    refused(box.kerf("replay", "none.json"), 3, "none.json")
    refused(box.kerf("replay"), 2, "file")
    whole = journal()
    box.write("half.json", json.dumps(whole)[:-100])
    refused(box.kerf("replay", "half.json"), 3, "not a journal")
    whole["start"]["panel"]["rapid"] = 101
    box.write("range.json", json.dumps(whole))
    refused(box.kerf("replay", "range.json"), 3, "panel", "0 to 100")


@test("kerf replay finds called programs in the folders that --library names, and keeps to its time")
def called(box):
    whole = journal()
    whole["start"]["program"] = {"name": "main.nc", "text": "O1\nM98P77\nM30\n"}
    whole["entries"] = [{"at": [0, 0], "do": "cycle-start"}]
    whole["until"] = [1000000]
    box.write("calls.json", json.dumps(whole))
    result = box.kerf("replay", "calls.json")
    status(result, 1)
    contains(result.text, "PS0076", "not found")
    os.mkdir(box.path("lib"))
    box.write("lib/O0077.nc", "O77\nG04X0.5\nM99\n")
    result = box.kerf("replay", "calls.json", "--library", "lib")
    status(result, 0)
    equal(result.text, "status: end\ntime: 0.5 s\n", "end")
    box.write("lib/O0077.nc", "O77\nN1G04X1000.\nGOTO1\n")
    whole["until"] = [10**12]
    box.write("calls.json", json.dumps(whole))
    status(box.kerf("replay", "calls.json", "--library", "lib", "--max-seconds", "0.3"), 5)
