"""`kerf check`: all findings of a file, in four formats."""

import json
import os
import xml.etree.ElementTree as xml

from harness import Failed, check, contains, equal, status, test

# Mistakes in lines 3, 5, 7, 8 (twice: two blocks), 11, 14 and 16; 6 is the first that a run meets.
WRONG = ("%\n"
         "O1 (PART)\n"
         "/G01 5X\n"                     # 3: behind a switch that is off
         "GOTO6\n"
         "#1=[2+\n"                      # 5: jumped over
         "N6#1=1\n"
         "#3=SIN30\n"                    # 7: raises the alarm of the run
         "G01 X1.2.3; #5=;\n"            # 8: two blocks
         "M30\n"
         "\n"
         "X\n"                           # 11: behind the end
         "O2\n"
         "G00X1.\n"
         "WHILE[#1]DO1\n"                # 14: a program that nobody calls
         "M99\n"
         "G00 Y1 {\n"                    # 16: behind its end
         "%\n")
WRONG_LINES = [3, 5, 7, 8, 8, 11, 14, 16]
GOOD = "O1\nG21G90\nG00X1.\nM30\n"


def findings(box, *words, wanted=1):
    result = box.kerf("check", *words, "--format", "json")
    status(result, wanted)
    return [json.loads(line) for line in result.lines()]


@test("check lists every wrong block of a file, also those that are never reached")
def all_findings(box):
    box.write("wrong.nc", WRONG)
    result = box.kerf("check", "wrong.nc")
    status(result, 1)
    equal(result.err, "", "standard error")
    heads = [line for line in result.lines() if line.startswith("wrong.nc:")]
    equal(sorted(int(head.split(":")[1]) for head in heads), WRONG_LINES, "lines")


@test("check finds what only the run shows, next to what does not compile")
def alarms_of_the_run(box):
    box.write("wrong.nc", "O1\nG21G90\nG00X1.\n#1=0\n#2=1/#1\nM30\nG01 5X\n")
    told = findings(box, "wrong.nc")
    equal(sorted((item["line"], item["code"]) for item in told),
          [(5, "PS0112"), (7, "PS0004")], "findings")


@test("check goes on behind alarms of the run, which run itself never does")
def behind_alarms(box):
    box.write("many.nc", "O0000\nG04 P1.0\nG01 X10. F100\nM98 P7777\nG02 X20. Y5. R1.\n#1=1/0\nG01 X30.\nM30\n")
    told = [(item["line"], item["code"]) for item in findings(box, "many.nc")]
    equal(told, [(1, "PS0074"), (2, "PS0007"), (4, "PS0076"), (5, "PS0020"), (6, "PS0112")], "findings")
    box.write("one.nc", "O1\nG01 X10. F100\nG04 P1.0\nG01 X20.\nM30\n")
    result = box.kerf("run", "one.nc", "--summary", "one.json", "--motion", "one.jsonl")
    status(result, 1)
    summary = box.json("one.json")
    equal((summary["status"], summary["alarm"]["line"], summary["motions"]), ("alarm", 3, 1), "run")
    check(all(motion["line"] < 4 for motion in box.motions("one.jsonl")), "no motion behind the alarm")


@test("check is silent and ends with 0 when nothing is wrong")
def nothing_wrong(box):
    box.write("good.nc", GOOD)
    for words in ([], ["--format", "json"]):
        result = box.kerf("check", "good.nc", *words)
        status(result, 0)
        equal((result.out, result.err), (b"", ""), "output")


@test("check of an NC program prints nothing of what the program itself prints")
def prints_nothing(box):
    box.write("good.nc", "O1\nDPRNT[HELLO]\nM30\n")
    equal(box.kerf("check", "good.nc").out, b"", "standard output")


@test("check as text gives each finding its source line and caret")
def text_format(box):
    box.write("wrong.nc", WRONG)
    lines = box.kerf("check", "wrong.nc", "--format", "text").lines()
    source = WRONG.splitlines()
    for i, line in enumerate(lines):
        if line.startswith("wrong.nc:"):
            row = int(line.split(":")[1])
            equal(lines[i + 1], "    " + source[row - 1], f"source of line {row}")
            check("^" in lines[i + 2], f"no caret below line {row}")


@test("check as JSON gives one object a line with all keys")
def json_format(box):
    box.write("wrong.nc", WRONG)
    told = findings(box, "wrong.nc")
    equal(sorted(item["line"] for item in told), WRONG_LINES, "lines")
    for item in told:
        equal(list(item), ["severity", "code", "message", "file", "line", "column", "program",
                           "hint"], "keys")
        check(item["column"] > 0, f"column {item['column']} in line {item['line']}")


def check_good_and_wrong(box, form):
    box.write("wrong.nc", WRONG)
    box.write("good.nc", GOOD)
    result = box.kerf("check", "good.nc", "wrong.nc", "--format", form)
    status(result, 1)
    return result


@test("check as SARIF 2.1.0 has a run with a result per finding")
def sarif_format(box):
    result = check_good_and_wrong(box, "sarif")
    document = json.loads(result.text)
    equal((document["version"], len(document["runs"])), ("2.1.0", 1), "version, runs")
    contains(document["$schema"], "sarif", "the schema")
    equal(document["runs"][0]["tool"]["driver"]["name"], "kerf", "tool")
    results = document["runs"][0]["results"]
    rows = []
    for item in results:
        check(item["ruleId"] and item["message"]["text"], f"a result without rule or text: {item}")
        equal(item["level"], "error", "level")
        location = item["locations"][0]["physicalLocation"]
        equal(location["artifactLocation"]["uri"], "wrong.nc", "file")
        check(location["region"]["startColumn"] >= 1, f"column in {location}")
        rows.append(location["region"]["startLine"])
    equal(sorted(rows), WRONG_LINES, "lines")
    clean = json.loads(box.kerf("check", "good.nc", "--format", "sarif").text)
    equal(clean["runs"][0]["results"], [], "results of a good file")


@test("check as JUnit has a test case per file, and the findings in those that failed")
def junit_format(box):
    result = check_good_and_wrong(box, "junit")
    suite = xml.fromstring(result.out)
    equal((suite.tag, suite.get("tests"), suite.get("failures")), ("testsuite", "2", "1"), "suite")
    cases = suite.findall("testcase")
    equal([case.get("name") for case in cases], ["good.nc", "wrong.nc"], "cases")
    equal([len(case.findall("failure")) for case in cases], [0, 1], "failures")
    failure = cases[1].find("failure")
    for line in WRONG_LINES:
        contains(failure.text, f"wrong.nc:{line}:", "the failure")


NASTY_NAMES = ["a&b.nc", "a<b>.nc", "\"quoted\" 'name'.nc", "two\nlines.nc", "tab\there.nc",
               "bell\x07.nc", "größe 日本.nc", "]]>.nc", "%20 100%.nc",
               b"latin1 gr\xf6\xdfe.nc".decode(errors="surrogateescape")]
NASTY_TEXT = (b"O1\n#3000=1(<a href=\"x\">&amp; ]]> \xe4 \x01\x0b\x1f\x7f \xef\xbf\xbe "
              b"\xef\xbf\xbf \xc2\x85 \xed\xa0\x80)\nM30\nG01 5X (\xef\xbf\xbe \x08 <&\">)\n")


@test("check stays valid in every format whatever bytes names and programs hold")
def nasty_bytes(box):
    names = []
    for name in NASTY_NAMES:
        box.write(name, NASTY_TEXT)
        names.append(name)
    for name in names:
        for form in ("json", "sarif", "junit"):
            result = box.kerf("check", name, "--format", form)
            try:
                status(result, 1)
                told = parsed(result.out, form)
                equal(told, 2, "findings")
            except (Failed, ValueError, xml.ParseError) as error:
                raise Failed(f"{name!r} as {form}: {error}") from None


def parsed(out, form):
    """How many findings a document holds; raises when it is not valid."""
    if form == "json":
        return len([json.loads(line) for line in out.decode().split("\n") if line])
    if form == "sarif":
        return len(json.loads(out.decode())["runs"][0]["results"])
    failure = xml.fromstring(out).find("testcase/failure")
    return failure.text.count(": error: ")


@test("check of many files gives the same bytes with any number of jobs")
def jobs(box):
    names = []
    for i in range(24):
        text = WRONG.replace("O1", f"O{i + 10}") if i % 3 else GOOD + "(FILL)\n" * (i * 400)
        names.append(box.write(f"f{i:02}.nc", text))
    names.insert(7, "gone.nc")
    for form in ("text", "json", "sarif", "junit"):
        one = box.kerf("check", *names, "--jobs", "1", "--format", form)
        status(one, 3)
        for count in ("2", "8", "64"):
            many = box.kerf("check", *names, "--jobs", count, "--format", form)
            status(many, 3)
            check(many.out == one.out, f"--jobs {count} gives other bytes than --jobs 1 as {form}")
            equal(many.err, one.err, f"standard error with --jobs {count}")


@test("check of good files with any number of jobs is silent")
def jobs_of_good_files(box):
    names = [box.write(f"f{i}.nc", GOOD) for i in range(9)]
    result = box.kerf("check", *names, "--jobs", "4")
    status(result, 0)
    equal((result.out, result.err), (b"", ""), "output")


@test("check names the program of every finding: its O number, or its name")
def program_of_a_finding(box):
    box.write("wrong.nc", WRONG + "\n")
    told = {item["line"]: item["program"] for item in findings(box, "wrong.nc")}
    equal((told[3], told[7], told[14]), ("O0001", "O0001", "O0002"), "programs")
    box.write("name.nc", "%\nO1\nM30\n<PROBE>\nG01 5X\nM99\n%\n")
    equal([item["program"] for item in findings(box, "name.nc")], ["PROBE"], "program")
    box.write("twice.nc", "%\nO1\nM30\nO1\nM99\n%\n")
    equal([item["program"] for item in findings(box, "twice.nc")], ["O0001"], "program")


@test("a program that does not end is a warning with its place and exit status 5")
def without_end(box):
    box.write("endless.nc", "O1\n#1=0\nN1#1=#1+1\nGOTO1\n")
    box.write("motions.nc", "O1\nG21G91F100\nN1G01X1.\nGOTO1\n")
    box.write("wrong.nc", WRONG)
    for name, words in (("endless.nc", ["--max-seconds", "0.1"]),
                        ("motions.nc", ["--max-motions", "100"])):
        told = findings(box, name, *words, wanted=5)
        equal([(item["severity"], item["code"], item["program"]) for item in told],
              [("warning", "BUDGET", "O0001")], f"findings of {name}")
        check(told[0]["line"] in (3, 4), f"{name}: line {told[0]['line']}")
        findings(box, name, "wrong.nc", *words, wanted=1)


@test("a warning alone is a finding: exit status 1, level warning in SARIF, a failure in JUnit")
def warnings(box):
    box.write("part.nc", "O1\nGOTO2\nGOTO99\nN2M30\n")
    equal([item["severity"] for item in findings(box, "part.nc")], ["warning"], "severities")
    document = json.loads(box.kerf("check", "part.nc", "--format", "sarif").text)
    equal([item["level"] for item in document["runs"][0]["results"]], ["warning"], "levels")
    suite = xml.fromstring(box.kerf("check", "part.nc", "--format", "junit").out)
    equal(suite.get("failures"), "1", "failures")


@test("check as SARIF writes file names as URIs")
def sarif_uris(box):
    for name, uri in (("sub/a b.nc", "sub/a%20b.nc"), ("100%.nc", "100%25.nc"),
                      ("größe#1.nc", "gr%C3%B6%C3%9Fe%231.nc")):
        box.write(name, WRONG)
        document = json.loads(box.kerf("check", name, "--format", "sarif").text)
        location = document["runs"][0]["results"][0]["locations"][0]["physicalLocation"]
        equal(location["artifactLocation"]["uri"], uri, f"URI of {name}")


@test("an option that is wrong is told once, however many files are checked")
def wrong_option_once(box):
    names = [box.write(f"f{i}.nc", GOOD) for i in range(4)]
    for words, wanted in ((["--param", "nosuch=1"], 2), (["--library", "gone"], 3),
                          (["--dialect", "foo"], 2)):
        result = box.kerf("check", *names, *words)
        status(result, wanted)
        equal(len(result.err.splitlines()), 1, f"sentences about {words}")
    status(box.kerf("check", *names, "--dialect", "fanuc-mill"), 0)


@test("check goes on behind a file that is missing and ends with 3")
def missing_file(box):
    box.write("wrong.nc", WRONG)
    result = box.kerf("check", "gone.nc", "wrong.nc", "gone too.nc")
    status(result, 3)
    contains(result.text, "wrong.nc:7:", "standard output")
    equal(len(result.err.splitlines()), 2, "sentences on standard error")
    suite = xml.fromstring(box.kerf("check", "gone.nc", "wrong.nc", "--format", "junit").out)
    equal(suite.get("failures"), "2", "failures as JUnit")


@test("check --machine, --param and --library change what is wrong")
def options(box):
    box.write("axis.nc", "O1\nG21G90\nG00A90.\nM30\n")
    status(box.kerf("check", "axis.nc"), 1)
    status(box.kerf("check", "axis.nc", "--machine", "mill4"), 0)
    box.write("call.nc", "O1\nM98P9000\nM30\n")
    box.write("folder/O9000.nc", "O9000\nM99\n")
    status(box.kerf("check", "call.nc"), 1)
    status(box.kerf("check", "call.nc", "--library", "folder"), 0)
    box.write("levels.nc", "O1\nG65P2\nM30\nO2\nG65P3\nM99\nO3\nM99\n")
    status(box.kerf("check", "levels.nc"), 0)
    status(box.kerf("check", "levels.nc", "--param", "macro_levels=1"), 1)


@test("check reads standard input as -")
def standard_input(box):
    result = box.kerf("check", "-", stdin=WRONG)
    status(result, 1)
    contains(result.text, "-:7:", "standard output")


@test("check names each wrong O number once")
def program_numbers(box):
    box.write("twice.nc", "%\nO1\nM30\nO2\nM99\nO2\nM99\n%\n")
    told = findings(box, "twice.nc")
    equal([(item["code"], item["line"]) for item in told], [("PS0073", 6)], "findings")


@test("check writes no file")
def no_files(box):
    box.write("wrong.nc", WRONG)
    box.kerf("check", "wrong.nc")
    equal(os.listdir(box.folder), ["wrong.nc"], "files behind it")


@test("check checks patterns beside programs: good ones silently, each mistake with its byte")
def patterns(box):
    good = bytes.fromhex("7F00C8 3F0FA0 400CA7 FF00C8")
    box.write("good.nc", GOOD)
    box.write("w.pat", good)
    result = box.kerf("check", "good.nc", "w.pat")
    status(result, 0)
    equal(result.text + result.err, "", "nothing to say")
    box.write("cut.pat", good[:-1])
    found = findings(box, "good.nc", "cut.pat")
    equal([(f["code"], f["file"], f["offset"]) for f in found], [("PATTERN_TRUNCATED", "cut.pat", 9)], "a cut pattern")
    box.write("far.txt", "F T1 60000\n")
    status(box.kerf("pattern", "encode", "far.txt", "--output", "far.pat"), 0)
    equal([f["code"] for f in findings(box, "far.pat")], ["LIMIT"], "beyond the travel")
    status(box.kerf("check", "w.pat", "--machine", "mill3"), 2)


LATHE = "T0101\nG0 X52. Z0.\nG1 X-1. F0.2\nM30\n"


@test("a program for a lathe on a mill that was named is a warning, and its first alarm names the lathe")
def lathe(box):
    box.write("turn.nc", LATHE)
    named = ("--machine", "mill3")
    for line in (box.kerf("run", "turn.nc", *named).err, box.kerf("check", "turn.nc", *named).text):
        contains(line, "turn.nc:1:1: warning: LATHE_PROGRAM", "the hint")
        contains(line, "T0101 looks like a lathe's, and the program runs on mill3", "the hint")
        contains(line, "--machine lathe2", "the way out")
    box.write("wrong.nc", "G50 S3000\nG28 U0\nM30\n")
    for line in (box.kerf("run", "wrong.nc", *named).err, box.kerf("check", "wrong.nc", *named).text):
        check(any("PS" in text and "error" in text for text in line.splitlines()), "it is an alarm")
        contains(line, "a program for a lathe: --machine lathe2", "its hint")
    check("LATHE" not in box.kerf("run", "turn.nc", *named, "--dialect", "fanuc-lathe").err, "who names it knows")


@test("a program that turns C is told so on a lathe without C")
def lathe_without_c(box):
    box.write("drill.nc", "G50 S3000\nG98\nG00 X60. Z2. C90.\nM30\n")
    contains(box.kerf("run", "drill.nc", "--machine", "lathe2").err,
             "C90. looks like that of a lathe with C, and the program runs on lathe2", "the hint")
    check("LATHE" not in box.kerf("run", "drill.nc").err, "lathe3c runs it")


@test("a program for a lathe finds its lathe, and says why")
def chosen(box):
    box.write("turn.nc", LATHE)
    result = box.kerf("run", "turn.nc", "--summary", "turn.json")
    contains(result.err, "machine lathe2 and dialect fanuc-lathe because of T0101 in line 1", "why")
    summary = box.json("turn.json")
    equal((summary["machine"], summary["dialect"]), ("lathe2", "fanuc-lathe"), "the choice")
    equal(summary["chosen"], {"dialect": "likely", "machine": "dialect"}, "how")
    contains(str(summary["assumed"]), "'line': 1, 'what': 'dialect fanuc-lathe (likely): T0101'", "assumed")
    equal(box.kerf("check", "turn.nc").text, "", "check chooses likewise")
    box.write("drill.nc", "G50 S3000\nG98\nG00 X60. Z2. C90.\nM30\n")
    box.kerf("run", "drill.nc", "--summary", "drill.json")
    summary = box.json("drill.json")
    equal((summary["machine"], summary["chosen"]), ("lathe3c", {"dialect": "likely", "machine": "axes"}), "with C")
    box.kerf("run", "drill.nc", "--dialect", "fanuc-lathe", "--summary", "drill.json")
    summary = box.json("drill.json")
    equal((summary["machine"], summary["chosen"]), ("lathe3c", {"dialect": "named", "machine": "axes"}), "named")


@test("how dialect and machine were chosen stands in the summary")
def how_chosen(box):
    box.write("mill.nc", "O1\nT1M06\nG43H1Z10.\nG90G00X0Y0\nG01Z-1.F0.5\nM30\n")
    box.write("cut.bas", "home\nspeed(10)\npower(5)\nline(1,1)\n")

    def chosen_of(*words):
        box.kerf("run", *words, "--summary", "s.json")
        made = box.json("s.json")["chosen"]
        return made["dialect"], made["machine"]

    equal(chosen_of("mill.nc"), ("default", "default"), "nothing")
    equal(chosen_of("mill.nc", "--machine", "mill4"), ("named", "named"), "the machine")
    equal(chosen_of("mill.nc", "--dialect", "fanuc-mill"), ("named", "dialect"), "the dialect")
    equal(chosen_of("cut.bas"), ("certain", "dialect"), "the ending")
    equal(chosen_of("cut.bas", "--machine", "laser3"), ("certain", "named"), "ending and machine")


@test("a mill's program stays on the mill")
def stays_on_mill(box):
    box.write("mill.nc", "O1\nT1M06\nG43H1Z10.\nG90G00X0Y0\nG01Z-1.F0.5\nM30\n")
    check("LATHE" not in box.kerf("run", "mill.nc").err, "a mill's program")
