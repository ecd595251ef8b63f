"""Wrong usage, help, version and the list of machines."""

import re

from harness import check, contains, equal, last_test, one_sentence, refused, status, test

PROGRAM = "O1\nG21G90\nG00X1.Y2.Z3.\nM30\n"

WRONG_RUNS = {
    "an option that does not exist": ["--nosuch"],
    "a second program": ["more.nc"],
    "an option of check": ["--jobs", "3"],
    "--machine without its value": ["--machine"],
    "--dialect that does not exist": ["--dialect", "foo"],
    "--library without its value": ["--library"],
    "--set without an equals sign": ["--set", "#100"],
    "--set without a number sign": ["--set", "100=1"],
    "--set without a value": ["--set", "#100="],
    "--set with a word for a value": ["--set", "#100=abc"],
    "--set with more behind the number": ["--set", "#100=1mm"],
    "--set with an infinite value": ["--set", "#100=inf"],
    "--set with a value that is no number": ["--set", "#100=nan"],
    "--set with a value beyond all doubles": ["--set", "#100=1e999"],
    "--set of a variable that is always vacant": ["--set", "#0=1"],
    "--set of a variable that does not exist": ["--set", "#50=1"],
    "--set of a variable that cannot be written": ["--set", "#4001=1"],
    "--set of a modal word of the running program": ["--set", "#4115=1"],
    "--set of a macro alarm": ["--set", "#3000=1"],
    "--set of a message": ["--set", "#3006=1"],
    "--set of an input that does not exist": ["--set", "#1020=1"],
    "--set of a date that does not exist": ["--set", "#3011=20250230"],
    "--set of a time that does not exist": ["--set", "#3012=246000"],
    "--set of a fraction of a variable": ["--set", "#100.5=1"],
    "--set of a negative variable": ["--set", "#-1=1"],
    "--set of a BASIC variable": ["--set", "x=1"],
    "--param without an equals sign": ["--param", "DPI"],
    "--param that does not exist": ["--param", "nosuch=1"],
    "--param with a value out of range": ["--param", "DPI=7"],
    "--param with a word for a value": ["--param", "DPI=on"],
    "--param with a letter that it does not take": ["--param", "offset_memory=Q"],
    "--param with an empty value": ["--param", "DPI="],
    "--machine-set without an equals sign": ["--machine-set", "axis.X.velocity"],
    "--machine-set of an unknown key": ["--machine-set", "axis.X.colour=1"],
    "--machine-set of an unknown table": ["--machine-set", "spindle.speed=1"],
    "--machine-set of an axis that the machine lacks": ["--machine-set", "axis.Q.velocity=1"],
    "--machine-set of a velocity of 0": ["--machine-set", "axis.X.velocity=0"],
    "--machine-set with a word for a value": ["--machine-set", "axis.X.velocity=fast"],
    "--decimal-point of another kind": ["--decimal-point", "comma"],
    "--machine-set with two signs": ["--machine-set", "axis.X.velocity=+-5"],
    "--param with two signs": ["--param", "DPI=+-0"],
    "--set with two signs": ["--set", "#1=+-5"],
    "--set of more than a double holds": ["--set", "#1=1e400"],
    "--skip-at without a value": ["--skip-at", "X"],
    "--skip-at of an axis that the machine lacks": ["--skip-at", "Q=1"],
    "--skip-at with a word for a value": ["--skip-at", "X=here"],
    "--skip-at with a value that is no number": ["--skip-at", "X=nan"],
    "--interrupt-at a negative time": ["--interrupt-at", "-1"],
    "--interrupt-at with a word for a value": ["--interrupt-at", "soon"],
    "--block-skip level 0": ["--block-skip", "0"],
    "--block-skip level 10": ["--block-skip", "10"],
    "--block-skip with an empty item": ["--block-skip", "1,,2"],
    "--block-skip with a word": ["--block-skip", "some"],
    "--optional-stop with a value": ["--optional-stop=maybe"],
    "--max-seconds with a negative value": ["--max-seconds", "-1"],
    "--max-seconds with a word": ["--max-seconds", "long"],
    "--max-seconds with a value that is no number": ["--max-seconds", "nan"],
    "--max-motions with a negative value": ["--max-motions", "-1"],
    "--max-motions with a fraction": ["--max-motions", "1.5"],
    "--max-motions with a word": ["--max-motions", "many"],
    "--keep-partial with a value": ["--keep-partial=maybe"],
    "--summary without its file": ["--summary"],
    "--motion without its file": ["--motion"],
    "--plot without its file": ["--plot"],
    "--plot with an ending of another kind": ["--plot", "path.pdf"],
    "--plot without an ending": ["--plot", "path"],
    "--plot-speed without --plot": ["--plot-speed"],
    "--plot-energy without --plot": ["--plot-energy"],
    "--plot-energy on a machine without a laser": ["--plot", "path.svg", "--plot-energy"],
    "--dprnt without its file": ["--dprnt"],
    "--post without its file": ["--post"],
    "--coverage without its file": ["--coverage"],
    "--points without its file": ["--points"],
    "--pulses without its file": ["--pulses"],
    "--rows without its file": ["--rows"],
    "--pwm without its file": ["--pwm"],
    "--pwm on a machine without a laser": ["--pwm", "pwm.csv"],
    "--pattern without its file": ["--pattern"],
    "--pattern on a machine that takes none": ["--pattern", "part.pat"],
    "--pattern-plot without --pattern": ["--pattern-plot", "part.svg", "--machine", "arm4"],
    "--pattern-plot with an ending of another kind": ["--pattern-plot", "part.pdf"],
    "--pulses with an ending of another kind": ["--pulses", "pulses.txt"],
    "--tools without its file": ["--tools"],
    "--offsets without its file": ["--offsets"],
    "--state without its file": ["--state"],
    "--diagnostics of another kind": ["--diagnostics", "xml"],
}

WRONG_COMMANDS = {
    "kerf without a command": [],
    "a command that does not exist": ["mill"],
    "a command that is not built yet": ["simulate", "part.nc"],
    "run without a program": ["run"],
    "check without a file": ["check"],
    "check --jobs 0": ["check", "part.nc", "--jobs", "0"],
    "check --jobs with a word": ["check", "part.nc", "--jobs", "all"],
    "check --format of another kind": ["check", "part.nc", "--format", "xml"],
    "check --param that does not exist": ["check", "part.nc", "--param", "nosuch=1"],
    "check with an option of run": ["check", "part.nc", "--post", "out.nc"],
    "pattern without a command": ["pattern"],
    "pattern with a command that does not exist": ["pattern", "mirror", "part.nc"],
    "pattern decode without a file": ["pattern", "decode"],
    "pattern encode without --output": ["pattern", "encode", "part.nc"],
    "pattern encode with an option of decode": ["pattern", "encode", "part.nc", "--lenient"],
    "pattern decode with another byte order": ["pattern", "decode", "part.nc", "--byte-order", "middle"],
    "pattern replay on a machine that takes none": ["pattern", "replay", "part.nc", "--machine", "mill3"],
    "pattern replay on a machine that does not exist": ["pattern", "replay", "part.nc", "--machine", "mill99"],
    "pattern replay --machine-set of an unknown key": ["pattern", "replay", "part.nc", "--machine-set",
                                                       "pattern.colour=1"],
    "pattern replay --plot with an ending of another kind": ["pattern", "replay", "part.nc", "--plot",
                                                             "p.pdf"],
    "pattern replay --pulses with an ending of another kind": ["pattern", "replay", "part.nc",
                                                               "--pulses", "p.txt"],
    "machines with a name that is not built in": ["machines", "mill99"],
    "machines with two names": ["machines", "mill3", "mill4"],
}


def wrong_usage(words):
    def run(box):
        box.write("part.nc", PROGRAM)
        result = box.kerf(*words)
        refused(result, 2)
        equal(box.files(), ["part.nc"], "files behind it")
    return run


for name, words in WRONG_RUNS.items():
    test(f"wrong usage: {name}")(wrong_usage(["run", "part.nc", *words]))
for name, words in WRONG_COMMANDS.items():
    test(f"wrong usage: {name}")(wrong_usage(words))


@test("an option that is given twice where one can count is wrong usage")
def repeated_option(box):
    box.write("part.nc", PROGRAM)
    refused(box.kerf("run", "part.nc", "--summary", "a", "--summary", "b"), 2)
    equal(box.files(), ["part.nc"], "files behind it")


@test("--help goes to standard output and names exactly the commands that are built")
def help_of_kerf(box):
    result = box.kerf("--help")
    status(result, 0)
    equal(result.err, "", "standard error")
    commands = re.findall(r"^  ([a-z]+) {3,}", result.text, re.MULTILINE)
    equal(sorted(commands), ["check", "draw", "edit", "features", "machines", "materials", "notices", "pattern", "replay", "run", "serve", "stock",
                               "time", "tools"], "commands in the help")


@test("the help of every command is whole text without control characters")
def help_of_commands(box):
    last_words = {"run": "Example: kerf run part.nc", "check": "sarif or junit; default text",
                  "machines": "the machine whose file is printed"}
    for command, last in last_words.items():
        result = box.kerf(command, "--help")
        status(result, 0)
        contains(result.text, last, f"help of {command}")
        strange = sorted({c for c in result.text if not c.isprintable() and c != "\n"})
        equal(strange, [], f"control characters in the help of {command}")
        check(result.text.endswith("\n"),
              f"the help of {command} breaks off: …{result.text[-60:]!r}")


@test("--version names the program and its version")
def version(box):
    result = box.kerf("--version")
    status(result, 0)
    check(re.fullmatch(r"kerf \d+\.\d+\.\d+\n", result.text), f"the version is {result.text!r}")


@test("machines lists the built-in machines, one a line with a sentence")
def machines(box):
    result = box.kerf("machines")
    status(result, 0)
    equal(result.err, "", "standard error")
    names = [line.split()[0] for line in result.lines()]
    for name in ("mill3", "mill4", "mill5"):
        check(name in names, f"machines does not list {name}: {names}")
    check(all(len(line.split()) > 2 for line in result.lines()), "a machine has no sentence")


@test("machines NAME prints a file that can be copied, changed and used")
def machine_file(box):
    for line in box.kerf("machines").lines():
        name = line.split()[0]
        result = box.kerf("machines", name)
        status(result, 0)
        contains(result.text, f'name = "{name}"', f"the file of {name}")
        box.write("mine.toml", result.text.replace(f'name = "{name}"', 'name = "mine"'))
        box.write("part.nc", "O1\nG21\nG00X150.\nM30\n")  # within reach of all of them
        run = box.kerf("run", "part.nc", "--machine", "mine.toml", "--summary", "s.json")
        status(run, 0)
        equal(box.json("s.json")["machine"], "mine", "machine of the summary")


@test("a machine name that is not built in is refused with the names that are")
def unknown_machine(box):
    box.write("part.nc", PROGRAM)
    result = box.kerf("run", "part.nc", "--machine", "mill99")
    check(result.status in (2, 3), f"exit status {result.status}, wanted 2 or 3")
    one_sentence(result, "mill99", "mill3")


def machine_of_dialect(box, dialect):
    text = box.kerf("machines", "mill3").text
    return box.write("mine.toml", text.replace('dialect = "fanuc-mill"', f'dialect = "{dialect}"'))


@test("a machine whose dialect is no text is refused, unless another dialect is asked for")
def dialect_of_a_machine(box):
    box.write("part.nc", PROGRAM)
    machine_of_dialect(box, "pattern")
    for command in ("run", "check"):
        words = [command, "part.nc", "--machine", "mine.toml"]
        refused(box.kerf(*words), 3, "mine.toml", "pattern", "fanuc-mill")
        status(box.kerf(*words, "--dialect", "fanuc-mill"), 0)


@test("the help names every built-in machine and every dialect")
def help_names(box):
    machines = [line.split()[0] for line in box.kerf("machines").lines()]
    check(len(machines) >= 7, f"machines: {machines}")
    for command, dialects in (("run", {"fanuc-mill", "fanuc-lathe", "laser-basic", "teach", "motion", "pattern"}),
                              ("check", {"fanuc-mill", "fanuc-lathe", "laser-basic", "teach", "motion", "pattern"}),
                              ("time", {"fanuc-mill", "fanuc-lathe", "laser-basic", "teach", "motion"})):
        text = " ".join(box.kerf(command, "--help").text.split())
        options = text.split("--machine ", 1)[1]
        about_machines = options.split("--dialect", 1)[0]
        for name in machines:
            contains(about_machines, name, f"--machine of {command}")
        contains(about_machines, "default mill3, lathe2 for fanuc-lathe, laser3 for laser-basic, laser5 for teach, mill3 for motion", command)
        about = options.split("--dialect", 1)[1].split(";", 1)[0].split("language: ", 1)[1]
        equal(set(about.split(", ")), dialects, f"--dialect of {command}")
        for dialect in dialects - {"pattern"}:
            box.write("part", "" if dialect != "teach" else "TEACH 1\nEND\n")
            result = box.kerf(command, "part", "--dialect", dialect)
            check(result.status in (0, 1), f"{command} --dialect {dialect}: {result.err}")


@test("--dialect says what there is of a name that it does not take")
def wrong_dialects(box):
    box.write("part.nc", PROGRAM)
    there = "; available: fanuc-mill, fanuc-lathe, laser-basic, teach, motion"
    refused(box.kerf("run", "part.nc", "--dialect", "foo"), 2,
            "--dialect foo: there is no dialect foo" + there)
    refused(box.kerf("time", "part.nc", "--dialect", "pattern"), 2,
            "`kerf pattern replay` and `kerf run --dialect pattern`" + there)


@test("a machine whose dialect does not exist is refused with the line")
def wrong_dialect_of_a_machine(box):
    box.write("part.nc", PROGRAM)
    machine_of_dialect(box, "fanuc-mil")
    refused(box.kerf("run", "part.nc", "--machine", "mine.toml"), 3, "mine.toml:4:", "fanuc-mil")


WRONG_MACHINES = {
    "a dialect that is a number": ('dialect = "fanuc-mill"', "dialect = 5", 4),
    "an axis that is rotary in other words": ('name = "X"', 'name = "X"\nrotary = "no"', None),
    "a control that is no table": ('dialect = "fanuc-mill"', 'dialect = "fanuc-mill"\ncontrol = 1', 5),
    "no TOML": ('dialect = "fanuc-mill"', "dialect = ", 4),
}
for name, (old, new, line) in WRONG_MACHINES.items():
    def wrong_machine(box, old=old, new=new, line=line):
        text = box.kerf("machines", "mill3").text
        check(old in text, f"the file of mill3 has no {old}")
        if "control =" in new:
            text = text[:text.index("[control]")] if "[control]" in text else text
        box.write("mine.toml", text.replace(old, new, 1))
        box.write("part.nc", PROGRAM)
        refused(box.kerf("run", "part.nc", "--machine", "mine.toml"), 3,
                f"mine.toml:{line}:" if line else "mine.toml:")
    test(f"a machine file with {name} is refused with the line")(wrong_machine)


@test("a file name with control characters does not break the sentence")
def control_characters(box):
    for name in ("two\nlines.nc", "bell\x07.nc", "escape\x1b[31m.nc"):
        refused(box.kerf("run", name), 3)


@test("run and machines answer an unknown machine name with the same exit status")
def unknown_machine_twice(box):
    box.write("part.nc", PROGRAM)
    run = box.kerf("run", "part.nc", "--machine", "mill99")
    equal(run.status, box.kerf("machines", "mill99").status, "exit status of run")


@last_test("every option that the help names was used by a test")
def options_are_tested(box, commands):
    missing = {}
    for command in ("run", "stock", "edit", "check", "draw", "tools", "machines", "decode", "encode", "replay"):
        room = ["pattern"] if command in ("decode", "encode", "replay") else []
        named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", box.kerf(*room, command, "--help").text))
        used = {word.split("=")[0] for words in commands
                if command in words[:12] for word in words if word.startswith("--")}
        missing[command] = sorted(named - used - {"--help"})
    equal({command: options for command, options in missing.items() if options}, {}, "options without a test")
