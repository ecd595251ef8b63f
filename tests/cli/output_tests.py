"""Where output goes: standard output, files that appear whole or not at all, full disks."""

import os
import shutil

from harness import Failed, Skipped, check, contains, equal, one_sentence, refused, status, test

# Enough of everything that each output of a run has more to write than a small disk holds.
BIG = ("O1\nG21G90G17G94F500\n#1=0\nWHILE[#1LT4000]DO1\nG01X[#1*0.01]Y[SIN[#1]*20]Z-[#1/1000]\n"
       "DPRNT[LINE*#1[60]*OF*THE*PROTOCOL]\n#1=#1+1\nEND1\nM30\n" + "(FILL)\n" * 2000)

# Option and the name of its file.
OUTPUTS = {"--motion": "out.json", "--summary": "out.txt", "--plot": "out.svg",
           "--dprnt": "out.log", "--post": "out.nc", "--coverage": "out.csv",
           "--points": "points.csv", "--pulses": "pulses.vcd", "--rows": "rows.csv",
           "--state": "out.state"}
# Those that are larger than a disk of this size for the program above.
LARGE_OUTPUTS = ("--motion", "--dprnt", "--post", "--coverage", "--points", "--pulses", "--rows")
SMALL_DISK = "48k"


def in_namespace(box, mount, command):
    """Words that run `command` (of sh, "$@" is kerf) with a disk of its own mounted at disk/."""
    if os.geteuid() != 0 or not shutil.which("unshare"):
        raise Skipped("only root can mount a disk of its own")
    os.makedirs(box.path("disk"), exist_ok=True)
    words = ("unshare", "-m", "sh", "-c", f"{mount} || exit 99; {command}", "sh")
    probe = box.kerf(before=("unshare", "-m", "sh", "-c", f"{mount} || exit 99; exit 0", "sh"))
    if probe.status != 0:
        raise Skipped(f"a disk cannot be mounted here: {probe.err.strip()}")
    return words


@test("data alone goes to standard output, the summary for people to standard error")
def streams(box):
    box.write("part.nc", "O1\nG21G90\nG00X1.\nM30\n")
    nothing = box.kerf("run", "part.nc")
    equal(nothing.out, b"", "standard output of a run that prints nothing")
    contains(nothing.err, "O0001 on mill3", "standard error")
    for option in ("--motion", "--summary", "--post", "--coverage", "--points", "--rows"):
        file = box.kerf("run", "part.nc", option, "out")
        equal(file.out, b"", f"standard output with {option} FILE")
        direct = box.kerf("run", "part.nc", option, "-")
        status(direct, 0)
        equal(direct.out, box.read("out"), f"standard output with {option} -")
        check("wrote -" not in direct.err, f"the summary of {option} - calls it a file")
        check("-" not in box.files(), f"{option} - made a file")


@test("--summary stays one JSON object and --motion one object a line when both go to -")
def two_on_standard_output(box):
    box.write("part.nc", "O1\nG21G90\nG00X1.\nM30\n")
    out = box.kerf("run", "part.nc", "--motion", "-", "--summary", "-").lines()
    equal(len(out), 3, "lines")
    equal(sum('"kind"' in line for line in out), 2, "records")


@test("the same input gives the same bytes in every output, run for run")
def same_bytes(box):
    box.write("part.nc", BIG)
    outputs = [word for option, name in OUTPUTS.items() for word in (option, name)]
    outputs += ["--offsets", "g10.nc", "--set", "#110=3"]
    box.write("g10.nc", "%\nG10L2P1X10.Y20.\n%\n")
    first = run_once(box, outputs)
    for name in OUTPUTS.values():
        os.remove(box.path(name))
    second = run_once(box, outputs)
    for name in first:
        check(first[name] == second[name], f"two runs differ in {name}")


@test("the same input gives the same bytes from another folder and with another environment")
def same_bytes_elsewhere(box):
    program = box.path(box.write("part.nc", BIG))
    os.makedirs(box.path("elsewhere"))
    outputs = [word for option, name in OUTPUTS.items() for word in (option, box.path(name))]
    first = run_once(box, outputs, program)
    for name in OUTPUTS.values():
        os.remove(box.path(name))
    environment = {"LANG": "de_DE.UTF-8", "LC_ALL": "de_DE.UTF-8", "TZ": "Asia/Tokyo",
                   "HOME": "/nowhere", "NO_COLOR": "1", "TERM": "dumb", "COLUMNS": "40"}
    second = run_once(box, outputs, program, cwd=box.path("elsewhere"), environment=environment)
    for name in first:
        check(first[name] == second[name], f"a run from another folder differs in {name}")


def run_once(box, outputs, program="part.nc", **options):
    result = box.kerf("run", program, *outputs, **options)
    status(result, 0)
    return {"standard output": result.out, "standard error": result.err,
            **{name: box.read(name) for name in OUTPUTS.values()}}


@test("PNG pictures of the same path are the same bytes")
def same_picture(box):
    box.write("part.nc", BIG)
    for name in ("a.png", "b.png"):
        status(box.kerf("run", "part.nc", "--plot", name, "--dprnt", "log"), 0)
    check(box.read("a.png") == box.read("b.png"), "two runs drew different pictures")


@test("an output replaces the file that was there, with its new content only")
def replaced(box):
    box.write("part.nc", "O1\nM30\n")
    box.write("out.json", "x" * 100000)
    status(box.kerf("run", "part.nc", "--motion", "out.json"), 0)
    equal([record["kind"] for record in box.motions("out.json")], ["end"], "records")
    equal(box.files(), ["out.json", "part.nc"], "files behind it")


@test("an output file is as readable as any new file")
def permissions(box):
    box.write("part.nc", "O1\nM30\n")
    box.kerf(before=("sh", "-c", 'umask 022; "$1" run part.nc --motion out.json', "sh"))
    equal(oct(os.stat(box.path("out.json")).st_mode & 0o777), "0o644", "mode")


def cannot_write(option, folder, *parts):
    def run(box):
        box.write("part.nc", BIG)
        box.write("in/the/way", "")
        name = os.path.join(folder, OUTPUTS[option])
        if folder == "in":
            os.makedirs(box.path(name))
        before = box.files("in")
        refused(box.kerf("run", "part.nc", option, name, *quiet(option)), 3, name)
        equal(box.files(), ["in", "part.nc"], "files behind it")
        equal(box.files("in"), before, "files in the folder")
    return run


def quiet(option):
    """What keeps the protocol of the program off standard output."""
    return [] if option == "--dprnt" else ["--dprnt", "/dev/null"]


for option in OUTPUTS:
    test(f"{option} in a folder that is missing is told in one sentence")(
        cannot_write(option, "gone"))
    test(f"{option} where a folder of that name stands is told in one sentence")(
        cannot_write(option, "in"))


def on_full_device(option):
    def run(box):
        box.write("part.nc", BIG)
        name = "full" + os.path.splitext(OUTPUTS[option])[1]  # may decide what is written
        os.symlink("/dev/full", box.path(name))
        result = box.kerf("run", "part.nc", option, name, *quiet(option))
        refused(result, 3, name)
        equal(box.files(), [name, "part.nc"], "files behind it")
    return run


for option in OUTPUTS:
    if option != "--state":  # a state is read first, and a device is no state
        test(f"{option} to a device without room is told in one sentence")(on_full_device(option))


def on_full_disk(option):
    """A disk that is full from the beginning: what stood there stays."""
    def run(box):
        box.write("part.nc", BIG)
        name = "disk/" + OUTPUTS[option]
        old = '{"old": 1}'
        state = ""
        if option == "--state":
            box.write("old.nc", "O1\n#500=42\nM30\n")
            status(box.kerf("run", "old.nc", "--state", "old.state"), 0)
            state = "cp old.state disk/out.state;"
        words = in_namespace(
            box, "mount -t tmpfs -o size=64k tmpfs disk",
            f"echo '{old}' > {name}; {state} cp {name} before; "
            "dd if=/dev/zero of=disk/filler 2>/dev/null; "
            f'"$@"; status=$?; cp {name} behind; ls -A disk > listing; exit $status')
        result = box.kerf("run", "part.nc", option, name, *quiet(option), before=words)
        refused(result, 3, name)
        equal(box.read("listing").split(), [b"filler", OUTPUTS[option].encode()],
              "files on the disk behind it")
        equal(box.read("behind"), box.read("before"), "the file that was there")
    return run


def on_small_disk(option):
    """A disk that becomes full while the output is written."""
    def run(box):
        box.write("part.nc", BIG)
        name = "disk/" + OUTPUTS[option]
        words = in_namespace(box, f"mount -t tmpfs -o size={SMALL_DISK} tmpfs disk",
                             '"$@"; status=$?; ls -A disk > listing; exit $status')
        result = box.kerf("run", "part.nc", option, name, *quiet(option), before=words)
        refused(result, 3, name)
        equal(box.read("listing"), b"", "files on the disk behind it")
    return run


def on_read_only_disk(option):
    def run(box):
        box.write("part.nc", BIG)
        name = "disk/" + OUTPUTS[option]
        if os.geteuid() == 0:
            words = in_namespace(box, "mount -t tmpfs -o ro tmpfs disk", '"$@"')
        else:
            os.makedirs(box.path("disk"))
            os.chmod(box.path("disk"), 0o555)
            words = ()
        result = box.kerf("run", "part.nc", option, name, *quiet(option), before=words)
        refused(result, 3, name)
        equal(box.files("disk"), [], "files on the disk behind it")
    return run


def beyond_file_size(option):
    def run(box):
        box.write("part.nc", BIG)
        name = OUTPUTS[option]
        result = box.kerf("run", "part.nc", option, name, *quiet(option),
                          before=("sh", "-c", 'ulimit -f 8; exec "$@"', "sh"))
        refused(result, 3, name)
        equal(box.files(), ["part.nc"], "files behind it")
    return run


for option in OUTPUTS:
    test(f"{option} on a full disk leaves what was there and says so in one sentence")(
        on_full_disk(option))
    test(f"{option} in a folder that cannot be written is told in one sentence")(
        on_read_only_disk(option))
for option in LARGE_OUTPUTS:
    test(f"{option} on a disk that becomes full leaves nothing and says so in one sentence")(
        on_small_disk(option))
    test(f"{option} beyond the file size limit leaves nothing and says so in one sentence")(
        beyond_file_size(option))


@test("standard output without room is an output that cannot be written, for every command")
def full_standard_output(box):
    box.write("part.nc", BIG)
    box.write("wrong.nc", "O1\n" + "G01 5X\n" * 400 + "M30\n")
    for words in (["run", "part.nc"], ["run", "part.nc", "--motion", "-", "--dprnt", "/dev/null"],
                  ["run", "part.nc", "--summary", "-", "--dprnt", "/dev/null"],
                  ["check", "wrong.nc"], ["check", "wrong.nc", "--format", "json"],
                  ["check", "wrong.nc", "--format", "sarif"],
                  ["check", "wrong.nc", "--format", "junit"],
                  ["machines"], ["machines", "mill3"], ["--help"], ["run", "--help"],
                  ["--version"]):
        result = box.kerf(*words, before=("sh", "-c", 'exec "$@" > /dev/full', "sh"))
        try:
            status(result, 3)
            one_sentence(result)
        except Failed as error:
            raise Failed(f"kerf {' '.join(words)} > /dev/full: {error}") from None


@test("a reader that has gone away ends the run without a crash")
def closed_pipe(box):
    box.write("part.nc", BIG.replace("4000", "400000"))
    result = box.kerf(before=("bash", "-c", '"$1" run part.nc --max-seconds 3 | head -n 1 '
                              '> first; exit ${PIPESTATUS[0]}', "bash"))
    status(result, 3)
    equal(box.read("first"), b"LINE 0 OF THE PROTOCOL\n", "what the reader took")


@test("one output that fails leaves no unfinished file of any other")
def others_stay_whole(box):
    box.write("part.nc", BIG)
    words = [word for option, name in OUTPUTS.items() if option != "--motion"
             for word in (option, name)]
    result = box.kerf("run", "part.nc", "--motion", "/dev/full", *words)
    refused(result, 3, "/dev/full")
    strange = [name for name in box.files() if name.startswith(".")]
    equal(strange, [], "unfinished files")
    check("out.state" not in box.files(),
          "the state was written although the run ended as failed: the next try counts twice")
