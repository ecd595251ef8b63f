"""Diagnostics: where they point, as text and as JSON."""

import json
import re

from harness import alarm, check, contains, equal, status, test

KEYS = ["severity", "code", "message", "file", "line", "column", "program", "hint"]


def underlined(text):
    """The head, the shown source line and what the caret underlines in it."""
    lines = text.split("\n")
    head, shown, caret = lines[0], lines[1], lines[2]
    check(shown.startswith("    ") and caret.startswith("    "),
          f"the source line and the caret must be indented: {lines[:3]!r}")
    check(re.fullmatch(r" *\^~*", caret[4:]), f"this is no caret: {caret!r}")
    first = caret.index("^")
    return head, shown[4:], shown[first:len(caret)]


def points_at(line, number, offending, shown=None, before=b"O1\n", behind=b"\nM30\n", at=None):
    """A test: the diagnostic of `line` points exactly at `offending`."""
    def run(box):
        content = before + line + behind
        box.write("part.nc", content)
        result = box.kerf("run", "part.nc")
        alarm(result, number)
        head, text, caret = underlined(result.err)
        row, column = (int(n) for n in re.match(r"part\.nc:(\d+):(\d+): error: ", head).groups())
        equal(row, 2 if at is None else at, "line")
        got = line[column - 1:column - 1 + len(offending)]
        equal(got, offending, f"text at column {column}")
        wanted = shown if shown is not None else offending.decode()
        equal(caret, wanted, f"text above the caret in {text!r}")
        told = json_of(box, "part.nc")[0]
        equal((told["line"], told["column"]), (row, column), "line and column of the JSON form")
    return run


def json_of(box, *words):
    result = box.kerf("run", *words, "--diagnostics", "json")
    return [json.loads(line) for line in result.err.splitlines()]


CASES = {
    "a stray number": (b"G01 5X", "PS0004", b"5"),
    "a word in the middle": (b"G00 X1. G999 Y1.", "PS0010", b"G999"),
    "the last word of a line": (b"G00 X1. M3.", "PS0007", b"M3."),
    "text behind tabs": (b"\tG00\tX1.\tG999\tY1.", "PS0010", b"G999"),
    "a word that holds a tab": (b"G00 G\t999 X1.", "PS0010", b"G\t999", "G 999"),
    "text behind 8-bit bytes": (b"(\xe4\xf6\xfc\x80\xff) G999", "PS0010", b"G999"),
    "text behind UTF-8": ("(Größe 日本 é) G999".encode(), "PS0010", b"G999"),
    "text before UTF-8": ("G999 (Größe 日本)".encode(), "PS0010", b"G999"),
    "text behind control characters": (b"\x01\x02\x7f G999", "PS0010", b"G999"),
    "a character that is none of the language": (b"G00 X1. \xb0", "PS0009", b"\xb0", "?"),
    "text behind a broken UTF-8 character": (b"(\xe6\x97) G999", "PS0010", b"G999"),
    "the second block of a line": (b"#1=1; G999 X1.; X2.", "PS0010", b"G999"),
    "the block behind a comment with a semicolon": (b"(A;B) ; G999", "PS0010", b"G999"),
    "a mistake in an expression": (b"#1=[2+*3]", "PS0114", b"*"),
}
for name, case in CASES.items():
    test(f"the caret stands under {name}")(points_at(*case))

LONG = {"4,000": 4_000, "60,000": 60_000, "200,000": 200_000}
for name, length in LONG.items():
    test(f"the caret stands under a mistake behind {name} characters on its line")(
        points_at(b"(" + b"c" * length + b") G01 5X", "PS0004", b"5"))
    test(f"the caret stands under a word that alarms behind {name} characters on its line")(
        points_at(b"(" + b"c" * length + b") G999 X1.", "PS0010", b"G999"))
test("the caret stands under a mistake before 200,000 characters on its line")(
    points_at(b"G01 5X (" + b"c" * 200_000 + b")", "PS0004", b"5"))
test("the caret stands under a mistake in the middle of 60,000 UTF-8 characters")(
    points_at(("(" + "é" * 20_000 + ") G01 5X (" + "é" * 20_000 + ")").encode(), "PS0004", b"5"))

for name, end in (("LF", b"\n"), ("CR LF", b"\r\n"), ("CR", b"\r"), ("CR CR LF", b"\r\r\n")):
    test(f"line and column are right in a file whose lines end in {name}")(
        points_at(b"G00 X1. G999 Y1.", "PS0010", b"G999", before=b"%" + end + b"O1" + end + end +
                  b"#1=1" + end, behind=end + b"M30" + end + b"%" + end, at=5))
test("line and column are right where line ends of all kinds meet")(
    points_at(b"G999", "PS0010", b"G999", before=b"O1\r\n#1=1\n#1=2\r#1=3\r\r\n\n#1=4\n", at=7))
test("line and column are right in the last line of a file that ends without a line end")(
    points_at(b"G00 G999", "PS0010", b"G999", behind=b""))


@test("a diagnostic reads path:line:column: error: code, message, and the program")
def text_form(box):
    box.write("sub/part.nc", "O1\nM98P20\nM30\nO20\n#1=1/0\nM99\n")
    result = box.kerf("run", "sub/part.nc")
    status(result, 1)
    first = result.err.splitlines()[0]
    check(re.fullmatch(r"sub/part\.nc:5:\d+: error: PS0112 .*zero divide.*\(O0020\)", first),
          f"the first line is {first!r}")


@test("a long line is shown in part, with the caret inside of it")
def excerpt(box):
    box.write("part.nc", "O1\n(" + "c" * 5000 + ") G999 (" + "c" * 5000 + ")\nM30\n")
    _, shown, caret = underlined(box.kerf("run", "part.nc").err)
    equal(caret, "G999", "text above the caret")
    check(len(shown) <= 130, f"{len(shown)} characters of the line are shown")
    check(shown.startswith("…") and shown.endswith("…"), f"no sign of what is left out: {shown}")


@test("a hint stands on a line of its own")
def hint(box):
    box.write("part.nc", "O1\nGO1X1.\nM30\n")
    result = box.kerf("run", "part.nc")
    status(result, 1)
    check(re.search(r"^    hint: .*0", result.err, re.MULTILINE), f"no hint: {result.err!r}")
    contains(json_of(box, "part.nc")[0]["hint"], "0", "the hint in JSON")


@test("the JSON form has all keys in order and the values of the text form")
def json_form(box):
    box.write("part.nc", "O1\n#100=1\nG00 X1. G999\nM30\n")
    told = json_of(box, "part.nc")
    equal(len(told), 1, "diagnostics")
    equal(list(told[0]), KEYS, "keys")
    equal({key: told[0][key] for key in ("severity", "code", "file", "line", "column", "program")},
          {"severity": "error", "code": "PS0010", "file": "part.nc", "line": 3, "column": 9,
           "program": "O0001"}, "values")
    contains(told[0]["message"], "G999", "the message")


@test("the JSON form stays JSON whatever bytes the program holds")
def json_of_bytes(box):
    box.write("part.nc", b"O1\n#3000=5(\xe4\"\\\x01\x7f\xff\xe6\x97 \xe6\x97\xa5)\nM30\n")
    told = json_of(box, "part.nc")
    equal((told[0]["code"], list(told[0])), ("MC3005", KEYS), "code and keys")
    contains(told[0]["message"], "日", "the message")
    box.write("name.nc", b"O<\xffX>\nG999\nM30\n")
    equal(list(json_of(box, "name.nc")[0]), KEYS, "keys")


@test("a user alarm shows the number and the text of the control")
def user_alarm(box):
    box.write("part.nc", "O1\n#3000=5(NO PROBE)\nM30\n")
    result = box.kerf("run", "part.nc")
    alarm(result, "MC3005", 2)
    contains(result.err.splitlines()[0], "NO PROBE", "the diagnostic")
    alarm(box.kerf("run", "part.nc", "--param", "MCA=1"), "MC0005", 2)


@test("an alarm in a called file names that file")
def other_file(box):
    box.write("part.nc", "O1\nM98P20\nM30\n")
    box.write("O0020.nc", "O20\n\n#1=1/0\nM99\n")
    result = box.kerf("run", "part.nc", "--summary", "s.json")
    status(result, 1)
    check(re.match(r"(\./)?O0020\.nc:3:", result.err), f"the diagnostic is {result.err!r}")
    stands = box.json("s.json")["alarm"]
    equal((stands["line"], stands["program"]), (3, "O0020"), "alarm of the summary")
    check(stands["file"].endswith("O0020.nc"), f"file of the alarm: {stands['file']}")


@test("a budget is a warning that says where the run stood")
def budget(box):
    box.write("part.nc", "O1\n#1=0\nN1#1=#1+1\nGOTO1\n")
    told = json_of(box, "part.nc", "--max-seconds", "0.05")
    equal((told[0]["severity"], list(told[0])), ("warning", KEYS), "severity and keys")
    check(told[0]["line"] in (3, 4), f"line {told[0]['line']}")


@test("standard error holds no colour codes when it is no terminal")
def colours(box):
    box.write("part.nc", "O1\nG999\nM30\n")
    check("\x1b" not in box.kerf("run", "part.nc").err, "escape codes on standard error")
