"""What programs are called in the outputs."""

import json

from harness import check, contains, equal, status, test

# Each moves, cuts and then makes a mistake.
UNNUMBERED = {
    "part.nc": "G90G94\nG01X10.F100\nX[1/0]\nM30\n",
    "part.bas": "speed(5);power(50)\nline(10,0)\nx=1/0\n",
    "part.tch": "TEACH 1\nPOINT 0 0 0 0 0\nFEED 100\nLINE 10 0 0 0 0\nLIN\nEND\n",
}
MISTAKES = {"part.nc": "PS0112", "part.bas": "LB0016", "part.tch": "TEACH_RECORD"}


def names_of(box, name, text):
    """What each output calls the program: summary, alarm, motions, diagnostics, `kerf check`."""
    box.write(name, text)
    status(box.kerf("run", name, "--summary", "s.json", "--motion", "m.jsonl"), 1)
    summary = box.json("s.json")
    names = {summary["program"], summary["alarm"]["program"]}
    names |= {motion["program"] for motion in box.motions("m.jsonl")}
    told = box.kerf("run", name, "--diagnostics", "json").err.splitlines()
    names |= {json.loads(line)["program"] for line in told}
    found = box.kerf("check", name, "--format", "json").lines()
    return names | {json.loads(line)["program"] for line in found}


@test("a program without an O number or a name is O0000 in every output of every language")
def unnumbered(box):
    for name, text in UNNUMBERED.items():
        equal(names_of(box, name, text), {"O0000"}, name)
    equal(names_of(box, "part.nc", "O9\n" + UNNUMBERED["part.nc"]), {"O0009"}, "a numbered one")


@test("for people a program without an O number or a name has the name of its file")
def for_people(box):
    for name, text in UNNUMBERED.items():
        box.write("folder/" + name, text)
        result = box.kerf("run", "folder/" + name, "--plot", "p.svg")
        first = result.err.splitlines()[0]
        check(MISTAKES[name] in first and "O0000" not in result.err, f"the mistake: {first}")
        contains(result.err, f"\n{name} on ", "the summary")
        contains(box.read("p.svg").decode(), f"<title>{name} on ", "the picture")
        contains(box.kerf("time", "folder/" + name).text, f"{name} on ", "the times")
    result = box.kerf("run", "-", stdin="G04P1\nM30\n")
    contains(result.err, "standard input on mill3", "the summary of standard input")
    box.write("part.nc", "<ABC>\nG04P1\nM30\n")
    contains(box.kerf("run", "part.nc").err, "ABC on mill3", "the summary of a named one")
