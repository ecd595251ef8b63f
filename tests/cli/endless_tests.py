"""Input without an end and programs of unpleasant size: an end in bounded time, with a sentence."""

import os
import subprocess
import sys

import harness
from harness import check, equal, test

LINES = 100_000


def nested(n):
    return "".join(f"FOR I{i}=1 TO 2\n" for i in range(n // 2)) + "".join(f"NEXT I{i}\n" for i in reversed(range(n // 2)))


# Each construct of the languages, so many lines of it.
SHAPES = {
    "loops within each other.nc": lambda n: "O1\n" + "WHILE[#1LT1]DO1\n" * (n // 2) + "END1\n" * (n // 2) + "M30\n",
    "loops without end.nc": lambda n: "O1\n" + "WHILE[#1LT1]DO1\n" * n + "M30\n",
    "ends of other loops.nc": lambda n: "O1\n" + "WHILE[#1LT1]DO1\n" * (n // 2) + "END2\n" * (n // 2) + "M30\n",
    "loops behind each other.nc": lambda n: "O1\n" + "WHILE[#1LT1]DO1\nX1\nX2\nEND1\n" * (n // 4) + "M30\n",
    "three deep.nc": lambda n: "O1\n" + "WHILE[#1LT1]DO1\nWHILE[#1LT1]DO2\nDO3\nEND3\nEND2\nEND1\n" * (n // 6) + "M30\n",
    "labels.nc": lambda n: "O1\n" + "".join(f"N{i % 99999 + 1}\n" for i in range(n)) + "M30\n",
    "gotos.nc": lambda n: "O1\n" + "".join(f"N{i % 99999 + 1}GOTO{i * 7919 % n + 1}\n" for i in range(n)) + "M30\n",
    "one line.nc": lambda n: "O1\n" + "".join(f"N{i};GOTO{n - i};" for i in range(1, n // 2)) + "\nM30\n",
    "one line of loops.nc": lambda n: "O1\n" + "DO1;" * (n // 2) + "END1;" * (n // 2) + "\nM30\n",
    "programs.nc": lambda n: "".join(f"O{i % 999 + 1}\nM99\n" for i in range(n // 2)),
    "programs by name.nc": lambda n: "".join(f"O<A{i}>\nM99\n" for i in range(n // 2)),
    "then.nc": lambda n: "O1\n" + "IF[#1EQ1]THEN#2=3\n" * n + "M30\n",
    "names.nc": lambda n: "O1\n" + "".join(f"SETVN{500 + i % 400}[V{i % 9999}]\n" for i in range(n)) + "M30\n",
    "mistakes.nc": lambda n: "O1\n" + "foo bar\n" * n + "M30\n",
    "for.bas": nested,
    "for behind for.bas": lambda n: "FOR I=1 TO 2\nNEXT I\n" * (n // 2),
    "for without next.bas": lambda n: "FOR I=1 TO 2\n" * n,
    "next.bas": lambda n: "FOR I=1 TO 2\n" + "NEXT I\n" * n,
    "if.bas": lambda n: "IF A<1 THEN B=1 ELSE IF A<2 THEN B=2 ELSE C=3\n" * n,
    "goto.bas": lambda n: "".join(f"{i} GOTO {n - i + 1}\n" for i in range(1, n + 1)),
    "gosub.bas": lambda n: "".join(f"{i} GOSUB {n - i + 1}\n" for i in range(1, n + 1)),
    "variables.bas": lambda n: "".join(f"A{i}={i}\n" for i in range(n)),
    "mistakes.bas": lambda n: "LINE LINE\n" * n,
    "points.tch": lambda n: "TEACH 1\nFEED 100\n" + "POINT 1 0 0 0 0\n" * n + "END\n",
    "mistakes.tch": lambda n: "TEACH 1\n" + "POINT x\n" * n + "END\n",
}


def that_ends_at_once(name, text):
    """A check reads all of a program and then runs it: that run is not looked at here."""
    if name.endswith(".bas"):
        return "END\n" + text
    if name.endswith(".tch"):
        return text
    if text.endswith("M30\n"):
        return text.replace("O1\n", "O1\nM30\n", 1)
    return "O9999\nM30\n" + text


def cpu_seconds(box, name, text):
    """Of a check: other processes of a busy computer do not count."""
    box.write(name, that_ends_at_once(name, text))
    script = ("import os,subprocess,sys; r=subprocess.run(sys.argv[1:],stdout=subprocess.DEVNULL,"
              "stderr=subprocess.DEVNULL); t=os.times(); print(r.returncode,t[2]+t[3])")
    words = [box.program, "check", name, "--max-seconds", "20", "--max-motions", "5"]
    out = subprocess.run([sys.executable, "-c", script, *words], cwd=box.folder, capture_output=True, text=True, check=True)
    status, seconds = out.stdout.split()
    check(int(status) in (0, 1, 5), f"{name}: exit status {status}")
    return float(seconds)


@test("a check of a hundred thousand lines of any construct takes time in proportion to them")
def proportion(box):
    for name, make in SHAPES.items():
        small, large = cpu_seconds(box, name, make(LINES // 8)), cpu_seconds(box, name, make(LINES))
        check(large < 24 * max(small, 0.05) or large < 1, f"{name}: {small:.2f} s became {large:.2f} s")
        check(large < 8 * harness.PATIENCE, f"{name}: {large:.2f} s")


@test("input without an end is refused in words, within --max-seconds")
def endless_input(box):
    for words in (["run"], ["check"], ["time"]):
        result = box.kerf(*words, "/dev/zero", "--max-seconds", "0.2")
        equal(result.status, 3, f"{words}: exit status")
        check("does not end within 0.2 s" in result.err, result.err)
        check(result.seconds < 10 * harness.PATIENCE, f"{result.seconds} s")
    slow = ("sh", "-c", 'while echo X1.; do sleep 0.01; done | "$@"', "sh")
    result = box.kerf("run", "-", "--max-seconds", "0.5", before=slow)
    equal(result.status, 3, "a slow pipe: exit status")
    check("does not end within 0.5 s" in result.err, result.err)
    result = box.kerf("run", "-", before=("sh", "-c", '(sleep 1; echo M30) | "$@" --max-seconds 0.5', "sh"))
    equal(result.status, 0, "who thinks before the first line is waited for")


@test("files of settings that are devices, or have no end, are refused in words")
def devices(box):
    box.write("part.nc", "O1\nM30\n")
    for option, word in (("--state", "state file"), ("--offsets", "offsets"), ("--tools", "offsets")):
        for device in ("/dev/zero", "/dev/full"):
            result = box.kerf("run", "part.nc", option, device)
            equal(result.status, 3, f"{option} {device}: exit status")
            check("does not end" in result.err or word in result.err, result.err)
            check(result.seconds < 20 * harness.PATIENCE, f"{result.seconds} s")


@test("a pipe in a library folder is no program, and is not waited for")
def pipe_in_library(box):
    box.write("part.nc", "O1\nM98P1234\nM30\n")
    os.mkdir(box.path("library"))
    os.mkfifo(box.path("library", "O1234.nc"))
    result = box.kerf("run", "part.nc", "--library", "library")
    equal(result.status, 1, "exit status")
    check("PS0076" in result.err, result.err)


@test("a line of input without an end is no number")
def endless_line(box):
    box.write("part.bas", "INPUT A\nEND\n")
    result = box.kerf("run", "part.bas", before=("sh", "-c", 'tr "\\0" 7 </dev/zero | "$@"', "sh"))
    equal(result.status, 1, "exit status")
    check("LB0025" in result.err, result.err)


@test("two outputs to one file, and an output that is an input, are refused before anything is written")
def one_file(box):
    part = "O1\nG1X1.F100.\nM30\n"
    box.write("part.nc", part)
    box.write("state.json", "")
    os.remove(box.path("state.json"))
    os.mkdir(box.path("sub"))
    os.link(box.path("part.nc"), box.path("linked.nc"))
    os.symlink("part.nc", box.path("symlink.nc"))
    for words, sentence in (
        (["--motion", "out", "--rows", "out"], "two outputs"),
        (["--motion", "out", "--summary", "sub/../out"], "two outputs"),
        (["--motion", box.path("out"), "--points", "./out"], "two outputs"),
        (["--post", "part.nc"], "is read by this command"),
        (["--post", "linked.nc"], "is read by this command"),
        (["--motion", "symlink.nc"], "is read by this command"),
        (["--state", "state.json", "--summary", "state.json"], "is read by this command"),
    ):
        result = box.kerf("run", "part.nc", *words)
        equal(result.status, 2, f"{words}: exit status")
        check(sentence in result.err, f"{words}: {result.err}")
        equal(box.read("part.nc"), part.encode(), f"{words}: the program")
    equal(box.files(), ["linked.nc", "part.nc", "sub", "symlink.nc"], "files")
    result = box.kerf("run", "part.nc", "--motion", "/dev/null", "--rows", "/dev/null", "--points", "-", "--summary", "-")
    equal(result.status, 0, "devices and streams may be shared")
    box.write("listing.txt", "")
    for action in ("encode", "decode"):
        result = box.kerf("pattern", action, "listing.txt", "--output", "./listing.txt")
        equal(result.status, 2, f"pattern {action}: exit status")
