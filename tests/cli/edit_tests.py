"""kerf edit: what goes together on its command line, what is written and when, diffs that `patch`
applies, edits that are taken back to the byte."""

import difflib
import json
import os
import random
import shutil
import subprocess
import zlib

from harness import Skipped, check, contains, equal, in_time, refused, status, test

TOOLS = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 10\n'

# A pocket of two layers, lines and numbers as a calculator has them.
PART = """N10 G21 G90 G17
N20 T1 M06
N30 G00 X0 Y0 Z5 S3000 M03
N40 G00 X20 Y20
N50 G01 Z-2 F100
N60 G01 X40 F300
N70 Y28
N80 X20
N90 Y20
N100 X15 Y15
N110 X45
N120 Y33
N130 X15
N140 Y15
N150 G00 Z5
N160 X20 Y20
N170 G01 Z-4 F100
N180 X40 F300
N190 Y28
N200 X20
N210 Y20
N220 X15 Y15
N230 X45
N240 Y33
N250 X15
N260 Y15
N270 G00 Z5
N280 M30
"""
POCKET = [[10, 10, 0], [50, 10, 0], [50, 38, 0], [10, 38, 0]]
NARROWER = [[10, 10, 0], [40, 10, 0], [40, 38, 0], [10, 38, 0]]
ANYWHERE = ("--tools", "tools.toml", "--decimal-point", "calculator")


def prepare(box, program=PART, contour=NARROWER, feature="F1"):
    """The files of an edit: a program, its tools, and one edit that begins at line 2, column 2."""
    one = {"op": "replace", "feature": feature, "layer": 2, "contour": contour}
    box.write("part.nc", program)
    box.write("tools.toml", TOOLS)
    box.write("edits.json", '{"version":1,"edits":[\n ' + json.dumps(one) + "]}\n")
    return box.files()


def edit(box, *words, wanted=0, program="part.nc"):
    result = box.kerf("edit", program, "--edits", "edits.json", *ANYWHERE, *words)
    status(result, wanted)
    return result


WRONG = {
    "no program": ["edit", "--edits", "edits.json", "--diff", "-"],
    "neither edits nor undo": ["edit", "part.nc", "--output", "new.nc"],
    "both edits and undo": ["edit", "part.nc", "--edits", "edits.json", "--undo", "report.json", "--diff", "-"],
    "neither output nor diff": ["edit", "part.nc", "--edits", "edits.json"],
    "no output of an undo": ["edit", "part.nc", "--undo", "report.json"],
    "a report of an undo": ["edit", "part.nc", "--undo", "report.json", "--diff", "-", "--report", "r.json"],
    "a collision of an undo": ["edit", "part.nc", "--undo", "report.json", "--diff", "-", "--allow-collision"],
    "a rest of an undo": ["edit", "part.nc", "--undo", "report.json", "--diff", "-", "--allow-rest"],
    "program and edits from one stream": ["edit", "-", "--edits", "-", "--diff", "d"],
    "an output that is the edits file": ["edit", "part.nc", "--edits", "edits.json", "--output", "edits.json"],
    "a diff that is the program": ["edit", "part.nc", "--edits", "edits.json", "--diff", "part.nc"],
    "two outputs in one file": ["edit", "part.nc", "--edits", "edits.json", "--output", "a", "--report", "a"],
    "an option of run": ["edit", "part.nc", "--edits", "edits.json", "--diff", "-", "--motion", "m"],
}
for name, words in WRONG.items():
    def wrong(box, words=words):
        files = prepare(box)
        refused(box.kerf(*words), 2)
        equal(box.files(), files, "files behind it")
    test(f"edit: wrong usage, {name}")(wrong)


@test("edit: the program, the diff and the report come together, and patch makes the one of the other")
def whole_edit(box):
    prepare(box)
    edit(box, "--output", "new.nc", "--diff", "d.diff", "--report", "r.json")
    equal(box.read("part.nc").decode(), PART, "the program")
    report = box.json("r.json")
    equal(list(report), ["kerf", "version", "edits", "changes", "bytes_changed", "blocks", "regenerated", "ids",
                         "verified", "warnings", "crc32"], "members")
    equal(report["crc32"], f"{zlib.crc32(box.read('new.nc')):08x}", "checksum")
    contains(box.read("new.nc").decode(), "\nN180 X30 F300\n", "the new program")
    head = box.read("d.diff").decode().splitlines()[:2]
    equal(head, ["--- a/part.nc", "+++ b/part.nc"], "head of the diff")
    equal(patched(box, box.read("part.nc"), box.read("d.diff")), box.read("new.nc"), "what patch makes")


@test("edit: the diff of a path from the root has names that patch -p1 takes")
def diff_of_a_path(box):
    prepare(box)
    path = box.path("part.nc")
    head = edit(box, "--diff", "-", program=path).text.splitlines()[:2]
    equal(head, [f"--- a{path}", f"+++ b{path}"], "head of the diff")


@test("edit: a diff alone writes nothing else")
def dry_run(box):
    files = prepare(box)
    result = edit(box, "--diff", "-")
    contains(result.text, "\n-N180 X40 F300\n+N180 X30 F300\n", "the diff")
    equal(box.files(), files, "files behind it")


@test("edit: the report takes the edit back, in place as well")
def round_trip(box):
    for end in ("\n", "\r\n"):
        program = PART.replace("\n", end).removesuffix(end)
        prepare(box, program.encode())
        edit(box, "--output", "part.nc", "--report", "r.json")
        check(box.read("part.nc") != program.encode(), "the program was not replaced")
        result = box.kerf("edit", "part.nc", "--undo", "r.json", "--output", "part.nc")
        status(result, 0)
        contains(result.err, "wrote part.nc", "what is told")
        equal(box.read("part.nc"), program.encode(), "the program behind it")
        equal([name for name in box.files() if name.startswith(".")], [], "temporary files")


@test("edit: what is there already is written as it is, with a warning")
def no_change(box):
    prepare(box, contour=POCKET)
    result = edit(box, "--output", "new.nc", "--diff", "d.diff", "--diagnostics", "json")
    equal((box.read("new.nc"), box.read("d.diff")), (PART.encode(), b""), "program and diff")
    told = [json.loads(line) for line in result.err.splitlines()]
    equal([(one["severity"], one["code"], one["file"], one["line"], one["column"]) for one in told],
          [("warning", "EDIT_NO_CHANGE", "edits.json", 2, 2)], "diagnostics")


@test("edit: what is refused is told at its place in the edits file, and nothing is written")
def refusal(box):
    prepare(box, feature="F99")
    box.write("new.nc", "old\n")
    files = box.files()
    words = ("--output", "new.nc", "--diff", "d.diff", "--report", "r.json", "--allow-collision", "--allow-rest")
    result = edit(box, *words, wanted=1)
    contains(result.err, "edits.json:2:2: error: EDIT_FEATURE_UNKNOWN ", "text")
    contains(result.err, "    hint: ", "text")
    result = edit(box, *words, "--diagnostics", "json", wanted=1)
    told = json.loads(result.err)
    equal((told["code"], told["line"], told["column"], bool(told["hint"])), ("EDIT_FEATURE_UNKNOWN", 2, 2, True), "JSON")
    equal((box.files(), box.read("new.nc")), (files, b"old\n"), "files behind it")


@test("edit: an edits file that is none is an input that cannot be read")
def broken_edits(box):
    files = prepare(box)
    box.write("edits.json", '{"version": 1, "edits": [')
    result = edit(box, "--output", "new.nc", wanted=3)
    contains(result.err, "edits.json:1:", "place")
    contains(result.err, ": error: EDIT_FILE the edits file cannot be read: ", "sentence")
    equal(box.files(), files, "files behind it")
    refused(box.kerf("edit", "part.nc", "--edits", "missing.json", "--diff", "-"), 3, "missing.json")
    refused(box.kerf("edit", "missing.nc", "--edits", "edits.json", "--output", "no/folder"), 3, "no/folder")


@test("edit: a program that raises an alarm or uses up its budget is not edited")
def alarm(box):
    prepare(box, PART.replace("N280 M30", "N280 #1=1/0"))
    result = edit(box, "--output", "new.nc", wanted=1)
    contains(result.err, "part.nc:28:", "the alarm")
    check("new.nc" not in box.files(), "the program was written")
    prepare(box)
    edit(box, "--output", "new.nc", "--max-motions", "3", wanted=5)
    edit(box, "--output", "new.nc", "--max-seconds", "60", "--max-motions", "0")


@test("edit: it takes what prepares a run and what lies on the table")
def preparation(box):
    prepare(box, feature="F99")
    box.write("lib/O9000.nc", "O9000\nM99\n")
    box.write("offsets.toml", "[work.G54]\nX = 0\n")
    box.write("table.toml", '[stock]\nshape = "box:0,0,-20,60,50,0"\n')
    edit(box, "--diff", "-", "--machine", "mill3", "--dialect", "fanuc-mill", "--library", "lib", "--set", "#100=5",
         "--param", "macro_levels=5", "--machine-set", "axis.X.velocity=9000", "--skip-at", "X=7",
         "--interrupt-at", "1000", "--tools-unit", "mm", "--offsets", "offsets.toml", "--state", "state",
         "--block-skip", "1", "--optional-stop", "--setup", "table.toml", "--stock", "box:0,0,-20,60,50,0",
         "--stock-unit", "mm", "--stock-zero", "G54", "--stock-place", "0,0,0", "--fixture",
         "box:0,0,-40,10,10,-30", wanted=1)


TABLE = ("--stock", "box:0,0,-20,60,50,0")


def moved(box, by, *words, wanted=0):
    prepare(box)
    box.write("edits.json", json.dumps({"version": 1, "edits": [{"op": "move", "feature": "F1", "dx": by}]}))
    return edit(box, "--output", "new.nc", "--report", "r.json", *TABLE, *words, wanted=wanted)


@test("edit: what runs into something only behind the edit is not written")
def new_findings(box):
    # The pocket ends at X50; moved by 10 its tool reaches X60, 8 mm into the clamp.
    told = moved(box, 10, "--fixture", "box:52,0,-20,70,50,5", wanted=1).err
    contains(told, "EDIT_NOT_VERIFIED FIXTURE_COLLISION LINE 6: ", "what is told")
    check("new.nc" not in box.files(), "the program was written")


@test("edit: what ran into something before as well does not refuse an edit")
def old_findings(box):
    moved(box, 1, "--fixture", "box:48,0,-20,70,50,5")
    verified = box.json("r.json")["verified"]
    equal((verified["new_findings"], verified["findings_skipped"]), ([], None), "findings")


@test("edit: another tool keeps S and F, and that is told; the old one may be without work")
def speeds_stay(box):
    prepare(box)
    box.write("tools.toml", TOOLS + TOOLS.replace("1\n", "2\n", 1).replace("10", "9"))
    box.write("edits.json", '{"version":1,"edits":[{"op":"tool","feature":"F1","tool":2}]}')
    edit(box, "--output", "new.nc", "--report", "r.json")
    equal([one["code"] for one in box.json("r.json")["warnings"]], ["EDIT_SPEEDS_STAY", "EDIT_TOOL_UNUSED"], "warnings")


@test("edit: where no part can be cut the report says that findings were not compared")
def no_part(box):
    prepare(box)
    result = edit(box, "--output", "new.nc", "--report", "r.json", "--stock", "sheet:0,0,60,50,2")
    contains(result.err, "collisions are not compared: --stock sheet: this machine has no laser", "what is told")
    contains(box.json("r.json")["verified"]["findings_skipped"], "this machine has no laser", "the report")


def patched(box, before, diff):
    """What the program `patch` makes of a file part.nc."""
    if not shutil.which("patch"):
        raise Skipped("no program patch")
    box.write("patched/part.nc", before)
    done = subprocess.run(["patch", "-p1", "--quiet"], input=diff, cwd=box.path("patched"), capture_output=True,
                          check=False)
    equal((done.returncode, done.stdout, done.stderr), (0, b"", b""), "patch")
    return box.read("patched/part.nc")


def text_of(lines, in_bytes):
    return [line.decode("latin-1" if in_bytes else "utf-8") for line in lines]


def report_of(before, after, file="part.nc", crc32=None):
    """A report of an edit between two lists of lines, made by the library of Python."""
    changes = []
    for what, a, b, c, d in difflib.SequenceMatcher(None, before, after, autojunk=False).get_opcodes():
        if what == "equal":
            continue
        try:
            change = {"old": text_of(before[a:b], False), "new": text_of(after[c:d], False)}
        except UnicodeDecodeError:
            change = {"old": text_of(before[a:b], True), "new": text_of(after[c:d], True), "encoding": "latin-1"}
        changes.append({"file": file, "first": a + 1, **change})
    crc32 = f"{zlib.crc32(b''.join(after)):08x}" if crc32 is None else crc32
    return {"kerf": "edit", "version": 1, "changes": changes, "crc32": crc32}


def changed_lines(chance, lines, end):
    """Lines with some patched, some taken out and some put in."""
    after = []
    for line in lines:
        kind = chance.random()
        if kind < 0.05:
            after.append(b"X1." + end)
        if kind > 0.1:
            after.append(line if kind > 0.2 else line.replace(b"G1", b"G01"))
    return after


@test("edit: undo gives every byte back, and its diff is one that patch applies")
def undo(box):
    chance = random.Random(11)
    for number in range(40):
        end = chance.choice([b"\n", b"\r\n"])
        comment = chance.choice([b"", b"(\xc3\xa4)", b"(\xe4\xff)"])
        before = [b"%" + end] + [b"N%d G1 X%d.%s%s" % (i, i % 7, comment, end) for i in range(chance.randrange(1, 80))]
        after = changed_lines(chance, before, end) + [b"M30" + end]
        before.append(b"M30" + end)
        if chance.random() < 0.5:
            before[-1] = after[-1] = b"M30"
        box.write("new.nc", b"".join(after))
        box.write("r.json", json.dumps(report_of(before, after)))
        status(box.kerf("edit", "new.nc", "--undo", "r.json", "--output", "old.nc", "--diff", "d.diff"), 0)
        equal(box.read("old.nc"), b"".join(before), f"program {number}")
        diff = box.read("d.diff").replace(b"/new.nc", b"/part.nc", 2)
        equal(patched(box, b"".join(after), diff), b"".join(before), f"what patch makes of program {number}")


@test("edit: undo of a text that is another one by now is refused")
def undo_of_another_text(box):
    before, after = [b"A\n", b"X40\n", b"M30\n"], [b"A\n", b"X30\n", b"M30\n"]
    box.write("r.json", json.dumps(report_of(before, after)))
    box.write("part.nc", b"A\nX35\nM30\n")
    result = box.kerf("edit", "part.nc", "--undo", "r.json", "--output", "old.nc")
    status(result, 1)
    contains(result.err, "part.nc:2:1: error: EDIT_CHANGED_SINCE ", "place")
    box.write("part.nc", b"B\nX30\nM30\n")
    result = box.kerf("edit", "part.nc", "--undo", "r.json", "--output", "old.nc", "--diagnostics", "json")
    status(result, 1)
    told = json.loads(result.err)
    equal((told["code"], told["file"], told["line"]), ("EDIT_CHANGED_SINCE", "part.nc", 0), "JSON")
    equal(box.files(), ["part.nc", "r.json"], "files behind it")


@test("edit: undo of what is no report is refused with a sentence")
def undo_of_no_report(box):
    box.write("part.nc", "M30\n")
    for text, part in (("", "no report"), ("{}", "no report"), ('{"kerf":"edit","version":2}', "version 1"),
                       ('{"kerf":"edit","version":1,"changes":[]}', '"crc32"'),
                       ('{"kerf":"edit","version":1,"crc32":"00000000"}', '"changes"')):
        box.write("r.json", text)
        refused(box.kerf("edit", "part.nc", "--undo", "r.json", "--diff", "-"), 3, "r.json", part)
    refused(box.kerf("edit", "part.nc", "--undo", "missing.json", "--diff", "-"), 3, "missing.json")


@test("edit: undo of other files needs a folder for them, and finds them in the library")
def undo_in_a_library(box):
    before, after = [b"O9100\n", b"X40\n", b"M99\n"], [b"O9100\n", b"X30\n", b"M99\n"]
    main = b"O1\nM98 P9100\nM30\n"
    report = report_of(before, after, "lib/O9100.nc", crc32=f"{zlib.crc32(main):08x}")
    report["libraries"] = [{"file": "lib/O9100.nc", "crc32": f"{zlib.crc32(b''.join(after)):08x}"}]
    box.write("r.json", json.dumps(report))
    box.write("part.nc", main)
    box.write("lib/O9100.nc", b"".join(before))
    box.write("edited/O9100.nc", b"".join(after))
    words = ("edit", "part.nc", "--undo", "r.json", "--output", "old.nc", "--library", "edited")
    result = box.kerf(*words)
    status(result, 1)
    contains(result.err, "error: EDIT_OTHER_FILE ", "refusal")
    os.mkdir(box.path("back"))
    status(box.kerf(*words, "--output-library", "back"), 0)
    equal((box.read("back/O9100.nc"), box.read("old.nc")), (b"".join(before), main), "files")


@test("edit: a pocket in a file of the library, which goes where --output-library says, and back")
def edit_in_a_library(box):
    prepare(box)
    lines = PART.splitlines(keepends=True)
    main = "".join(lines[:3]) + "M98 P9100\nM30\n"
    library = "O9100\n" + "".join(lines[3:-1]) + "M99\n"
    box.write("part.nc", main)
    box.write("lib/O9100.nc", library)
    files = box.files()
    words = ("--output", "new.nc", "--report", "r.json", "--library", "lib")
    result = edit(box, *words, wanted=1)
    contains(result.err, "error: EDIT_OTHER_FILE ", "refusal")
    contains(result.err, "--output-library", "hint")
    equal(box.files(), files, "files behind it")
    os.mkdir(box.path("changed"))
    edit(box, *words, "--output-library", "changed")
    wanted = library.replace("N180 X40 ", "N180 X30 ")
    wanted = wanted.replace("N230 X45\n", "N230 X35\n")
    equal(box.read("changed/O9100.nc").decode(), wanted, "the file of the library")
    equal((box.read("new.nc").decode(), box.read("lib/O9100.nc").decode()), (main, library), "all else")
    os.mkdir(box.path("back"))
    status(box.kerf("edit", "new.nc", "--undo", "r.json", "--output", "old.nc", "--library", "changed",
                    "--output-library", "back"), 0)
    equal(box.read("back/O9100.nc").decode(), library, "what undoing gives")


@test("edit: undo and diff of 100,000 lines take a moment")
def long_program(box):
    before = [b"N%d G1 X%d.\n" % (i, i % 7) for i in range(100_000)]
    changes = range(10, 100_000, 1000)
    after = list(before)
    for i in changes:
        after[i] = b"G0\n"
    report = report_of([], after)
    report["changes"] = [{"file": "part.nc", "first": i + 1, "old": [before[i].decode()], "new": ["G0\n"]}
                         for i in changes]
    box.write("part.nc", b"".join(after))
    box.write("r.json", json.dumps(report))
    result = box.kerf("edit", "part.nc", "--undo", "r.json", "--output", "old.nc", "--diff", "d.diff")
    status(result, 0)
    in_time(result, 1)
    equal(box.read("old.nc"), b"".join(before), "program")
    equal(box.read("d.diff").count(b"\n@@ "), len(changes), "hunks")
