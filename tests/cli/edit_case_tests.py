"""kerf edit on whole programs: which bytes become what, and that it is taken back to the byte; what is
refused writes nothing. The cases stand in edit_cases.json."""

import json
import os

from harness import contains, equal, status, test

with open(os.path.join(os.path.dirname(__file__), "edit_cases.json"), encoding="utf-8") as file:
    CASES = json.load(file)


def prepare(box, case):
    box.write("part.nc", case["program"].encode())
    edits = case["edits"]
    box.write("edits.json", edits if isinstance(edits, str) else json.dumps({"version": 1, "edits": edits}))
    words = ["--machine", case["machine"], *case["options"]]
    if case["tools"]:
        box.write("tools.toml", "\n".join(case["tools"]) + "\n")
        words += ["--tools", "tools.toml"]
    if "offsets" in case:
        box.write("offsets.nc", "\n".join(case["offsets"]) + "\n")
        words += ["--offsets", "offsets.nc"]
    return words


def whole(box, case):
    words = prepare(box, case)
    status(box.kerf("edit", "part.nc", "--edits", "edits.json", "--output", "new.nc", "--report", "r.json", *words), 0)
    equal(box.read("new.nc").decode(), case["edited"], "the edited program")
    equal(box.json("r.json")["verified"]["others_unchanged"], True, "all else")
    status(box.kerf("edit", "new.nc", "--undo", "r.json", "--output", "old.nc"), 0)
    equal(box.read("old.nc").decode(), case["program"], "what undoing gives")


def refused_edit(box, case):
    words = prepare(box, case)
    before = box.files()
    result = box.kerf("edit", "part.nc", "--edits", "edits.json", "--output", "new.nc", "--diagnostics", "json", *words)
    status(result, case["status"])
    contains(result.err, f'"{case["code"]}"', "what is told")
    equal(box.files(), before, "files behind it")


for each in CASES:
    def run(box, case=each):
        (whole if "edited" in case else refused_edit)(box, case)
    test(f"edited program: {each['name']}")(run)
