"""Input of any size and shape: time and memory stay bounded, every end is one of the contract."""

import random

import harness
from harness import alarm, check, equal, in_time, near, status, test

MIB = 1024  # KiB
MOST_MIB = 256


def bounded(result, most_mib=MOST_MIB):
    if not harness.MEASURES_MEMORY:
        return
    check(0 < result.peak_kib < most_mib * MIB,
          f"{result.peak_kib / MIB:.0f} MiB of memory, wanted less than {most_mib} MiB")


def fill(box, name, head, piece, count, tail):
    """Writes a large file piece by piece: this process must stay small."""
    bundle = max(1, (1 << 18) // len(piece))
    with open(box.path(name), "wb") as file:
        file.write(head)
        for _ in range(count // bundle):
            file.write(piece * bundle)
        file.write(piece * (count % bundle))
        file.write(tail)
    return name


@test("a line of 300 MB is one alarm, in bounded time and memory")
def long_line(box):
    with open(box.path("part.nc"), "wb") as file:  # a hole in the file reads as zero bytes
        file.write(b"O1\nG21G90\nG00X1.\n")
        file.seek(300_000_000)
        file.write(b"\nG00X2.\nM30\n")
    result = box.kerf("run", "part.nc", "--motion", "m.json", peak=True)
    alarm(result, "BLOCK_TOO_LONG", 4)
    bounded(result)
    in_time(result, 20)
    equal([record["to"]["X"] for record in box.motions("m.json")], [1], "moves before it")


@test("a line of 300 MB on standard input is copied, not held")
def long_line_from_standard_input(box):
    with open(box.path("part.nc"), "wb") as file:
        file.write(b"O1\n")
        file.seek(300_000_000)
        file.write(b"\nM30\n")
    result = box.kerf("run", "-", peak=True, before=("sh", "-c", 'exec "$@" < part.nc', "sh"))
    alarm(result, "BLOCK_TOO_LONG", 2)
    bounded(result)


@test("the line numbers behind a line that is too long are right, however it ends")
def behind_a_long_line(box):
    for end in (b"\n", b"\r\n", b"\r\r\n", b"\r"):
        for more in (0, 1, 2, 3, 4):  # the end falls on both sides of whatever is read at once
            box.write("part.nc", b"O1" + end + b"GOTO9" + end +
                      b"(" + b"x" * ((1 << 20) + (1 << 15) - 4 + more) + end +
                      b"#1=1" + end + b"N9#1=1/0" + end + b"M30" + end)
            result = box.kerf("run", "part.nc")
            alarm(result, "PS0112")
            check("part.nc:5:" in result.err,
                  f"line end {end!r}, {more} more: {result.err.splitlines()[0]}, wanted line 5")


@test("lines of nearly a megabyte need no more memory than short ones")
def many_long_lines(box):
    line = b"X1.Y2." * 166_000 + b"\n"
    fill(box, "part.nc", b"O1\nG21G90G01F100\n", line, 48, b"M30\n")
    result = box.kerf("run", "part.nc", peak=True)
    status(result, 0)
    bounded(result)


@test("100,000 nested brackets are one alarm")
def nested_brackets(box):
    n = 100_000
    box.write("part.nc", b"O1\n#1=" + b"[" * n + b"1" + b"]" * n + b"\nM30\n")
    result = box.kerf("run", "part.nc", peak=True)
    alarm(result, "PS0118", 2)
    bounded(result)
    box.write("part.nc", b"O1\n#1=" + b"SIN[" * n + b"1" + b"]" * n + b"\nM30\n")
    alarm(box.kerf("run", "part.nc"), "PS0118", 2)
    box.write("part.nc", b"O1\n#1=" + b"#[" * n + b"1" + b"]" * n + b"\nM30\n")
    alarm(box.kerf("run", "part.nc"), "PS0118", 2)
    box.write("part.nc", b"O1\n#1=" + b"-" * n + b"1\nM30\n")
    result = box.kerf("run", "part.nc", peak=True)
    check(result.status in (0, 1), f"100,000 minus signs: exit status {result.status}")
    bounded(result)


SMALL = {
    "an empty file": b"",
    "a file of one line end": b"\n",
    "a file of one percent sign": b"%",
    "a file of percent signs": b"%\n%\n%\n",
    "a file of 100,000 percent signs": b"%" * 100_000,
    "a file of blanks": b" \t\r\n" * 1000,
    "a file of zero bytes": bytes(100_000),
    "a file of one O": b"O",
    "a file of O words without numbers": b"O\nO\nO\n",
    "a file of one open comment": b"(" * 100_000,
    "a file of one open name": b"O<" + b"N" * 100_000,
    "a file of slashes": b"/" * 100_000,
    "a file of one letter": b"X" * 100_000,
    "a file of one digit": b"1" * 100_000,
    "a file of minus signs": b"-" * 100_000,
    "a file of semicolons": b";" * 100_000,
    "a file of carriage returns": b"\r" * 100_000,
    "a file of high bytes": b"\xff" * 100_000,
}
for name, content in SMALL.items():
    def small(box, content=content):
        box.write("part.nc", content)
        result = box.kerf("run", "part.nc", "--max-seconds", "5", peak=True)
        check(result.status in (0, 1), f"exit status {result.status}: {result.err[:200]!r}")
        if result.status == 1:
            check("part.nc:" in result.err.splitlines()[0], f"no place: {result.err[:200]!r}")
        bounded(result)
        checked = box.kerf("check", "part.nc")
        equal(checked.status, result.status, "exit status of check")
    test(f"{name} is an alarm or nothing at all, never a crash")(small)


@test("binary files are alarms, never a crash")
def binary(box):
    for seed in range(20):
        box.write("part.nc", b"O1\n" * (seed % 2) + random.Random(seed).randbytes(30_000))
        for command in (["run", "part.nc", "--max-seconds", "2"], ["check", "part.nc"]):
            result = box.kerf(*command)
            check(result.status in (0, 1, 5), f"seed {seed}: exit status {result.status} of "
                                              f"{command[0]}: {result.err[:200]!r}")


@test("10 MB of nothing but comments run in bounded memory")
def comments(box):
    fill(box, "part.nc", b"O1\n", b"(THIS IS NOT A BLOCK)\n", 500_000, b"M30\n")
    result = box.kerf("run", "part.nc", peak=True)
    status(result, 0)
    bounded(result, 64)


@test("an endless GOTO ends after --max-seconds 1 with exit status 5")
def endless(box):
    box.write("part.nc", "O1\nN1GOTO1\n")
    result = box.kerf("run", "part.nc", "--max-seconds", "1", peak=True)
    status(result, 5)
    check(result.seconds >= 1, f"it took only {result.seconds:.1f} s")
    in_time(result, 5)
    bounded(result, 64)


ENDLESS = {
    "a loop without an end": "DO1\nEND1\n",
    "a loop of blocks": "N1G04P1\nGOTO1\n",
    "a main program that returns": "#1=#1+1\nM99\n",
    "a subprogram that is repeated": "N1M98P2L9999\nGOTO1\nM30\nO2\nM99\n",
    "calls that call": "N1G65P2\nGOTO1\nO2\nG65P3\nM99\nO3\nM99\n",
    "a computed GOTO": "#1=1\nN1GOTO#1\n",
    "a GOTO over many pages": "N1GOTO2\n" + "#2=1\n" * 5000 + "N2GOTO1\n",
    "holes without number": "G21G90F100\nN1G81X1.Y1.Z-1.R1.L9999\nGOTO1\n",
    "motions": "G21G91F100\nN1G01X.001\nX-.001\nGOTO1\n",
}
for name, blocks in ENDLESS.items():
    def without_end(box, blocks=blocks):
        box.write("part.nc", "O1\n" + blocks)
        result = box.kerf("run", "part.nc", "--max-seconds", "0.3", "--max-motions", "0", peak=True)
        status(result, 5)
        in_time(result, 5)
        bounded(result, 64)
    test(f"{name}, run without end, stops at the budget")(without_end)


# The head of a program, and a thousand lines of it.
STRAIGHT = (b"O1\nG21G90G17G94F500\n",
            b"".join(b"G01X%d.%dY-%d.25Z-1.\n" % (i % 397, i % 10, i % 241) for i in range(1000)))


@test("a straight program of 2 million lines runs in the memory of a short one")
def straight(box):
    box.write("short.nc", "O1\nG21G90G17G94F500\n" + "G01X1.Y2.Z-3.\nX4.\n" * 5 + "M30\n")
    short = box.kerf("run", "short.nc", peak=True)
    fill(box, "long.nc", *STRAIGHT, 2000, b"M30\n")
    result = box.kerf("run", "long.nc", "--summary", "s.json", peak=True)
    status(result, 0)
    equal(box.json("s.json")["blocks"], 2_000_002, "blocks")
    bounded(result, 64)
    bounded(result, short.peak_kib / MIB + 16)


@test("every output of a long program is written in bounded memory")
def long_outputs(box):
    fill(box, "long.nc", *STRAIGHT, 1000, b"M30\n")
    for option, name in (("--motion", "/dev/null"), ("--post", "/dev/null"), ("--plot", "p.svg"),
                         ("--coverage", "/dev/null")):
        result = box.kerf("run", "long.nc", option, name, peak=True)
        status(result, 0)
        try:
            bounded(result, 64)
        except Exception as error:
            raise type(error)(f"{option}: {error}") from None


@test("a million labels and jumps to the last of them stay bounded")
def many_labels(box):
    n = 300_000
    with open(box.path("part.nc"), "wb") as file:
        file.write(b"O1\n#1=0\nN1#1=#1+1\nIF[#1LT50]GOTO%d\nM30\n" % (n + 1))
        for i in range(2, n + 2, 1000):
            file.write(b"".join(b"N%d#2=1\n" % k for k in range(i, i + 1000)))
        file.write(b"GOTO1\n")
    result = box.kerf("run", "part.nc", "--max-seconds", "20", peak=True)
    status(result, 0)
    bounded(result)


@test("a file of 50,000 programs is read in bounded time")
def many_programs(box):
    with open(box.path("part.nc"), "wb") as file:
        for i in range(50_000):
            file.write(b"O%d\nM99\n" % (i + 2) if i else b"O1\nM98P50001\nM30\n")
    result = box.kerf("run", "part.nc", "--param", "long_program_numbers=1", "--max-seconds", "5",
                      peak=True)
    status(result, 0)
    bounded(result)
    in_time(result, 8)


@test("a loop over 100,000 lines keeps its speed and its memory")
def long_loop(box):
    fill(box, "part.nc", b"O1\n#1=0\nWHILE[#1LT5]DO1\n", b"#2=#1+1\n", 100_000,
         b"#1=#1+1\nEND1\n#100=#1\nM30\n")
    result = box.kerf("run", "part.nc", "--summary", "s.json", peak=True)
    status(result, 0)
    equal(box.json("s.json")["variables"]["#100"], 5, "#100")
    bounded(result)


@test("check of a file that is no program at all stays bounded")
def check_of_text(box):
    fill(box, "part.nc", b"O1\n", b"DEAR READER, THIS IS A LETTER AND NO PROGRAM\n", 100_000, b"")
    result = box.kerf("check", "part.nc", peak=True)
    status(result, 1)
    bounded(result)
    in_time(result, 15)


@test("numbers of 100,000 digits are alarms or values, never a crash")
def long_numbers(box):
    digits = "1" * 100_000
    for block in (f"#1={digits}", f"#1=0.{digits}", f"G00X{digits}", f"G00X.{digits}", f"N{digits}",
                  f"GOTO{digits}", f"M98P{digits}", f"#{digits}=1", f"#1=1E{digits}", f"O{digits}",
                  f"DPRNT[#1[{digits}]]", f"G{digits}", f"/{digits}X1."):
        box.write("part.nc", f"O1\n{block}\nM30\n")
        result = box.kerf("run", "part.nc")
        check(result.status in (0, 1), f"{block[:20]}…: exit status {result.status}")


@test("a position is right to the last digit after a million incremental moves")
def no_drift(box):
    box.write("part.nc", "O1\nG21G91F100\n#1=0\nWHILE[#1LT100000]DO1\nG01X.001\nX.1Y-.003\n"
                         "#1=#1+1\nEND1\nM30\n")
    status(box.kerf("run", "part.nc", "--summary", "s.json"), 0)
    position = box.json("s.json")["position"]["machine"]
    equal((position["X"], position["Y"]), (10100, -300), "position")
    length = 100000 * (0.001 + (0.1**2 + 0.003**2) ** 0.5)
    near(box.json("s.json")["cut_mm"], length, 1e-3, "cut_mm")
