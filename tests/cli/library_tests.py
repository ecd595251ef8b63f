"""Where called programs are found: the program's own file, its folder, the libraries."""

import os

from harness import alarm, check, equal, in_time, status, test

CALL = "O1\nM98P9401\n#110=1\nM30\n"


def program(value, number="O9401"):
    return f"{number}\n#100={value}\nM99\n"


def found(box, *words, wanted=0):
    """#100 behind a run of main/part.nc."""
    result = box.kerf("run", "main/part.nc", "--summary", "s.json", *words)
    status(result, wanted)
    return box.json("s.json")["variables"].get("#100")


NAMES = ["O9401", "O9401.nc", "O9401.NC", "O9401.txt", "O9401.TXT", "O9401.tap", "9401.nc", "9401",
         "o9401.nc"]
for name in NAMES:
    def in_a_library(box, name=name):
        box.write("main/part.nc", CALL)
        box.write("library/" + name, program(7))
        equal(found(box, "--library", "library"), 7, "#100")
        box.write("main/" + name, program(8))
        equal(found(box), 8, "#100 from the program's own folder")
    test(f"a called program is found in a file {name}")(in_a_library)


@test("a short program number is found with and without leading zeros")
def leading_zeros(box):
    for name in ("O0042.nc", "O42.nc", "0042.nc", "42.nc"):
        box.write("main/part.nc", "O1\nM98P42\nM30\n")
        box.write("main/" + name, program(7, "O42"))
        equal(found(box), 7, f"#100 from {name}")
        os.remove(box.path("main", name))


@test("a program without an O number has that of its file name")
def number_from_the_name(box):
    box.write("main/part.nc", CALL)
    box.write("library/O9401.nc", "%\n#100=5\nM99\n%\n")
    equal(found(box, "--library", "library"), 5, "#100")


@test("several programs of one library file are found, whatever the file is called")
def several_in_one_file(box):
    box.write("main/part.nc", "O1\nM98P9402\nM98P9401\nM30\n")
    box.write("library/ALL-PROG.TXT", "%\n" + program(1, "O9400") + "O9401\n#101=#100+1\nM99\n" +
              program(3, "O9402") + "%\n")
    equal(found(box, "--library", "library"), 3, "#100")
    equal(box.json("s.json")["variables"]["#101"], 4, "#101")


@test("the program's own file comes first, then its folder, then the libraries as they are named")
def order(box):
    box.write("first/O9401.nc", program(1))
    box.write("second/O9401.nc", program(2))
    box.write("main/part.nc", CALL)
    equal(found(box, "--library", "first", "--library", "second"), 1, "#100 from the first library")
    equal(found(box, "--library", "second", "--library", "first"), 2, "#100 from the second")
    box.write("main/part.nc", CALL + program(4))
    equal(found(box, "--library", "first"), 4, "#100 from the file itself")


@test("a program of the own folder and one of a library: one of the two runs, always the same")
def own_folder_and_library(box):
    box.write("first/O9401.nc", program(1))
    box.write("main/O9401.nc", program(3))
    box.write("main/part.nc", CALL)
    values = {found(box, "--library", "first") for _ in range(3)}
    check(values in ({1}, {3}), f"#100 is {values}")


@test("a file of that name counts more than a file that holds the number")
def name_before_content(box):
    box.write("library/A.nc", program(1))
    box.write("library/O9401.nc", program(2))
    box.write("main/part.nc", CALL)
    equal(found(box, "--library", "library"), 2, "#100")


@test("a file that is called otherwise than the program in it is found by the program's number")
def other_name(box):
    box.write("library/O5555.nc", program(6))
    box.write("main/part.nc", CALL)
    equal(found(box, "--library", "library"), 6, "#100")


@test("a program that is nowhere is PS0076 at its call")
def missing(box):
    box.write("main/part.nc", CALL)
    os.makedirs(box.path("library"))
    result = box.kerf("run", "main/part.nc", "--library", "library")
    alarm(result, "PS0076", 2)


@test("G65, G66 and calls by code look in the libraries as M98 does")
def other_calls(box):
    box.write("library/O9401.nc", "O9401\n#100=#1\nM99\n")
    box.write("library/O9010.nc", "O9010\n#101=#24\nM99\n")
    box.write("main/part.nc", "O1\nG21G90\nG65P9401A3.\n#102=#100\nG66P9401A4.\nG00X1.\nG67\n"
                              "G12X5.\nM30\n")
    equal(found(box, "--library", "library", "--param", "6050=12"), 4, "#100")
    variables = box.json("s.json")["variables"]
    equal((variables["#102"], variables["#101"]), (3, 5), "#102, #101")


@test("M198 calls from the libraries and the own folder, never from the program's own file")
def external(box):
    box.write("main/part.nc", "O1\nM198P9401\nM30\n" + program(1))
    box.write("library/O9401.nc", program(2))
    equal(found(box, "--library", "library"), 2, "#100")
    os.remove(box.path("library/O9401.nc"))
    alarm(box.kerf("run", "main/part.nc", "--library", "library"), "PS1079", 2)


@test("M198 finds a program that a call before it has read from a folder")
def external_that_is_known(box):
    box.write("main/part.nc", "O1\nM98P9402\nM198P9401\nM30\n" + program(1))
    box.write("library/ALL.nc", "O9402\n#101=1\nM99\nO9401\n#100=2\nM99\n")
    equal(found(box, "--library", "library"), 2, "#100")


@test("a program that is called by name is found")
def by_name(box):
    box.write("main/part.nc", "%\nO1\nM98<PROBE>\nM30\n%\n")
    box.write("library/dump.txt", "%\n<PROBE>\n#100=9\nM99\n%\n")
    equal(found(box, "--library", "library"), 9, "#100")


@test("the file that runs is not read a second time as its own library")
def own_file(box):
    box.write("main/O0001.nc", "O1\n#100=#100+1\nIF[#100GT3]GOTO9\nM98P1\nN9M99\n")
    box.write("main/part.nc", "O5\n#100=0\nM98P1\n#101=#100\nM30\n")
    equal(found(box), 4, "#100")


@test("files in a library that are no programs, or cannot be read, do no harm")
def strange_files(box):
    box.write("main/part.nc", CALL)
    box.write("library/picture.png", os.urandom(1000))
    box.write("library/notes.txt", "dear reader, O my!\n(O9401 is elsewhere)\n")
    box.write("library/empty.nc", "")
    box.write("library/binary.nc", bytes(range(256)) * 10)
    os.makedirs(box.path("library/O9401"))  # a folder of that name
    os.symlink("nowhere", box.path("library/dangling.nc"))
    os.symlink(".", box.path("library/round.nc"))
    os.chmod(box.path("library/empty.nc"), 0)
    box.write("library/z.nc", program(7))
    equal(found(box, "--library", "library"), 7, "#100")


@test("a library is found from the folder that kerf was started in")
def relative(box):
    box.write("main/part.nc", CALL)
    box.write("main/library/O9401.nc", program(2))
    status(box.kerf("run", "part.nc", "--library", "library", cwd=box.path("main")), 0)
    status(box.kerf("run", box.path("main/part.nc"), "--library", "main/library"), 0)


@test("a library may be large: only what is called is read")
def large(box):
    box.write("main/part.nc", CALL)
    box.write("library/O9401.nc", program(2))
    with open(box.path("library/A0.nc"), "wb") as file:
        file.write(b"O77\n")
        file.seek(40_000_000)
        file.write(b"\nM99\n")
    result = box.kerf("run", "main/part.nc", "--library", "library")
    status(result, 0)
    in_time(result, 2)


@test("records of --motion name their file where it is not the main one: two files may have one number")
def file_of_a_record(box):
    box.write("main/part.nc", "O1\nG90G01X1.F100\nM98P9401\nM198P9402\nX4.\nM30\n")
    box.write("one/O9401.nc", "O9401\nX2.\nM99\n")
    box.write("two/O9402.nc", "O9402\nX3.\nM99\n")
    status(box.kerf("run", "main/part.nc", "--library", "one", "--library", "two", "--motion", "m.jsonl"), 0)
    files = [m.get("file") for m in box.motions("m.jsonl")]
    equal([os.path.basename(file) if file else None for file in files],
          [None, "O9401.nc", "O9402.nc", None, None], "files")


@test("records of --motion say the column where their block begins: two blocks may share a line")
def column_of_a_record(box):
    box.write("part.nc", "O1\nG90G01X1.F100;X2.;\nX3.\nM30\n")
    status(box.kerf("run", "part.nc", "--motion", "m.jsonl"), 0)
    equal([(m["line"], m["column"]) for m in box.motions("m.jsonl")], [(2, 1), (2, 15), (3, 1), (4, 1)],
          "places")
