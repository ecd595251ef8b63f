"""Where programs come from: files, standard input, and what cannot be read."""

import os
import socket

from harness import Skipped, alarm, check, contains, equal, refused, status, test

PROGRAM = "O1\nG21G90\nG00X1.Y2.Z3.\nM30\n"


@test("- reads the program from standard input, and diagnostics call it -")
def standard_input(box):
    result = box.kerf("run", "-", "--summary", "s.json", stdin=PROGRAM)
    status(result, 0)
    equal(box.json("s.json")["motions"], 1, "motions")
    equal(box.json("s.json")["file"], "-", "file of the summary")
    wrong = box.kerf("run", "-", stdin="O1\nG01 5X\nM30\n")
    alarm(wrong, "PS0004")
    contains(wrong.err, "-:2:5: error:", "the diagnostic")


@test("standard input may be a pipe, a file or empty")
def kinds_of_standard_input(box):
    box.write("part.nc", PROGRAM)
    shell = ("sh", "-c")
    for command in ('"$1" run - --summary - < part.nc', 'cat part.nc | "$1" run - --summary -',
                    '(sleep 0.05; cat part.nc) | "$1" run - --summary -'):
        result = box.kerf(before=(*shell, command, "sh"))
        status(result, 0)
        contains(result.text, '"status":"end"', "the summary")
    alarm(box.kerf("run", "-", stdin=b""), "EMPTY_PROGRAM")


@test("a program that waits in a named pipe is read")
def named_pipe(box):
    box.write("part.nc", PROGRAM)
    result = box.kerf(before=("sh", "-c", 'mkfifo pipe; cat part.nc > pipe & '
                                          '"$1" run pipe --summary -', "sh"))
    status(result, 0)
    contains(result.text, '"motions":1', "the summary")


@test("a closed standard input is an input that cannot be read")
def closed_standard_input(box):
    result = box.kerf(before=("sh", "-c", '"$1" run - <&-', "sh"))
    refused(result, 3)


def with_streams(streams):
    return {"before": ("sh", "-c", f'exec "$@" {streams}', "sh")}


@test("INPUT of a closed standard input reads nothing, least of all the program")
def input_of_closed_standard_input(box):
    box.write("part.bas", "12\ninput a\n")
    result = box.kerf("run", "part.bas", **with_streams("<&-"))
    alarm(result, "LB0025", 2)
    contains(result.err, "nothing is left to read", "the diagnostic")


@test("nothing is printed into a file that was opened while standard output is closed")
def closed_standard_output(box):
    program = "REM\nprint 1\nprint 2\n"
    result = box.kerf("run", "-", "--summary", "s.json", "--motion", "m.jsonl", stdin=program,
                      **with_streams(">&-"))
    status(result, 3)
    for name in box.files():
        check(not box.read(name).startswith(b"1"), f"{name} holds what was printed")
    result = box.kerf("run", "-", "--summary", "s.json", stdin="x=1/0\n", **with_streams("2>&-"))
    status(result, 1)
    equal(box.json("s.json")["status"], "alarm", "the summary")


def missing(words, *parts):
    def run(box):
        box.write("part.nc", PROGRAM)
        box.write("folder/inside.nc", PROGRAM)
        refused(box.kerf(*words), 3, *parts)
        equal(box.files(), ["folder", "part.nc"], "files behind it")
    return run


for kind, words in {
        "a program": ["run", "gone.nc"],
        "a machine file": ["run", "part.nc", "--machine", "gone.toml"],
        "a file of tools": ["run", "part.nc", "--tools", "gone.toml"],
        "a file of offsets": ["run", "part.nc", "--offsets", "gone.toml"],
        "a library folder": ["run", "part.nc", "--library", "gone"],
        "a file to check": ["check", "gone.nc"],
        "a machine file of check": ["check", "part.nc", "--machine", "gone.toml"],
        "a library folder of check": ["check", "part.nc", "--library", "gone"],
}.items():
    test(f"{kind} that is missing is told in one sentence")(missing(words, "gone"))

for kind, words in {
        "a program": ["run", "folder"],
        "a machine file": ["run", "part.nc", "--machine", "./folder"],
        "a file of tools": ["run", "part.nc", "--tools", "folder"],
        "a file of offsets": ["run", "part.nc", "--offsets", "folder"],
        "a state": ["run", "part.nc", "--state", "folder"],
        "a file to check": ["check", "folder"],
}.items():
    test(f"{kind} that is a folder is told in one sentence")(missing(words, "folder", "folder"))


@test("a library that is a file is told in one sentence")
def library_that_is_a_file(box):
    box.write("part.nc", PROGRAM)
    refused(box.kerf("run", "part.nc", "--library", "part.nc"), 3, "part.nc")


@test("a program that may not be read is told in one sentence")
def unreadable(box):
    box.write("part.nc", PROGRAM)
    os.chmod(box.path("part.nc"), 0)
    if os.access(box.path("part.nc"), os.R_OK):
        # root reads everything, but not a socket
        listener = socket.socket(socket.AF_UNIX)
        try:
            listener.bind(box.path("socket"))
        except OSError as error:
            raise Skipped(f"no file here is unreadable: {error}") from None
        refused(box.kerf("run", "socket"), 3, "socket")
        listener.close()
        return
    refused(box.kerf("run", "part.nc"), 3, "part.nc")


@test("a missing input leaves the files that other options name untouched")
def outputs_stay(box):
    box.write("old.json", "old")
    refused(box.kerf("run", "gone.nc", "--motion", "old.json", "--summary", "new.json"), 3)
    equal(box.files(), ["old.json"], "files behind it")
    equal(box.read("old.json"), b"old", "the file that was there")


@test("a machine file with a mistake names the line and leaves nothing behind")
def wrong_machine_file(box):
    box.write("part.nc", PROGRAM)
    good = box.kerf("machines", "mill3").text
    for wrong, part in ((good.replace("velocity =", "velocitas =", 1), "velocitas"),
                        (good.replace("24000", '"fast"', 1), "velocity"),
                        (good.replace("24000", "-1", 1), "velocity"),
                        (good.replace("[[axis]]", "[[axis", 1), ":"),
                        (good.replace('name = "Y"', 'name = "X"'), "X"),
                        (good.replace("DPI", "DPX"), "DPX"),
                        ("", "name"), ("name = 'x'\n", "axis"), ("\xff\xfe\x00", "mine.toml")):
        box.write("mine.toml", wrong.encode("latin-1", "replace") if "\xff" in wrong else wrong)
        refused(box.kerf("run", "part.nc", "--machine", "mine.toml", "--motion", "m.json"), 3,
                "mine.toml", part)
        equal(box.files(), ["mine.toml", "part.nc"], "files behind it")


@test("a file name with blanks, quotes and letters of all kinds is used as it is")
def strange_names(box):
    name = box.write("a part \"1\" größe 日本.nc", PROGRAM)
    output = "die Bahn (1).json"
    status(box.kerf("run", name, "--motion", output, "--summary", "-"), 0)
    equal(len(box.motions(output)), 2, "records")


@test("a file name that begins with a dash can be given behind --")
def dash_name(box):
    box.write("-part.nc", PROGRAM)
    status(box.kerf("run", "--", "-part.nc"), 0)
    status(box.kerf("run", "./-part.nc"), 0)
