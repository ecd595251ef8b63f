"""--state: what the control remembers from run to run, and that it never gets lost."""

import json
import os
import random
import time

from harness import check, contains, equal, refused, status, test


def run(box, program, *words, wanted=0):
    box.write("part.nc", program)
    result = box.kerf("run", "part.nc", "--state", "memory", "--summary", "s.json", *words)
    status(result, wanted)
    return box.json("s.json")


@test("--state keeps #500 to #999 from run to run and forgets #1 and #100")
def variables(box):
    run(box, "O1\n#1=1\n#33=1\n#100=2\n#199=2\n#500=3.25\n#999=-.00001\n#501=0\nM30\n")
    kept = run(box, "O1\nM30\n")["variables"]
    equal(kept, {"#500": 3.25, "#501": 0, "#999": -1e-5}, "variables of the second run")


@test("--state keeps a variable that was made vacant vacant")
def vacant(box):
    run(box, "O1\n#500=1\nM30\n")
    run(box, "O1\n#500=#0\nM30\n")
    equal(run(box, "O1\nM30\n")["variables"], {}, "variables")


@test("--state keeps every double to its last bit")
def exact(box):
    values = ["0.1", "123456.789012", "-0.000001", "1/3", "99999999999.9", "SQRT[2]"]
    run(box, "O1\n" + "".join(f"#{500 + i}={text}\n" for i, text in enumerate(values)) + "M30\n")
    first = box.json("s.json")["variables"]
    for _ in range(3):
        equal(run(box, "O1\nM30\n")["variables"], first, "variables")


@test("--state keeps work offsets, tool offsets and the part count")
def offsets(box):
    run(box, "O1\nG21G90\nG10L2P0Z1.\nG10L2P1X10.Y20.Z30.\nG10L2P6X-6.\nG10L20P300X300.\n"
             "G10L10P1R100.\nG10L11P1R0.5\nG10L12P400R5.\nG10L13P400R-0.01\nG92X7.\nM30\n")
    equal(run(box, "O1\nM30\n")["parts"], 2, "parts")
    kept = run(box, "O1\n#500=#5203\n#501=#5221\n#502=#5222\n#503=#5223\n#504=#5321\n#505=#19981\n"
                    "#506=#11001\n#507=#10001\n#508=#13400\n#509=#12400\n#510=#3901\nM30\n")
    equal([kept["variables"][f"#{500 + i}"] for i in range(11)],
          [1, 10, 20, 30, -6, 300, 100, 0.5, 5, -0.01, 2], "offsets and parts")


@test("--state keeps the tool offsets of a lathe, and reads a state that was written before there were any")
def of_lathe(box):
    lathe = ("--machine", "lathe2")
    run(box, "O1\nG10P10005X-120.5Z-80.R.8Q3\nG10P5X-.02Z.01R.005\nM30\n", *lathe)
    read = "O1\n#500=#2705\n#501=#2805\n#502=#2905\n#503=#2005\n#504=#2105\n#505=#2205\n#506=#2305\nM30\n"
    kept = run(box, read, *lathe)["variables"]
    equal([kept[f"#{500 + i}"] for i in range(7)], [-120.5, -80, 0.8, -0.02, 0.01, 0.005, 3], "offsets")
    state = box.json("memory")
    equal(state["turning"]["5"]["geometry_x"], -120.5, "in the file")
    del state["turning"]
    box.write("memory", json.dumps(state))
    equal(run(box, read, *lathe)["variables"]["#500"], 0, "of an older state")


NO_TURNING = {
    "half a tip": {"5": {"tip": 0.5}},
    "a number that the lathe lacks": {"65": {"tip": 1}},
    "a part that no offset has": {"5": {"length_wear": 1}},
    "a text": {"5": {"wear_x": "1"}},
    "a list": {"5": [1, 2, 3]},
}
for what, rows in NO_TURNING.items():
    @test(f"--state whose offsets of a lathe hold {what} is refused and stays as it is")
    def no_turning(box, rows=rows):
        run(box, "O1\nM30\n", "--machine", "lathe2")
        state = box.json("memory")
        state["turning"] = rows
        box.write("memory", json.dumps(state))
        refused(box.kerf("run", "part.nc", "--machine", "lathe2", "--state", "memory"), 3)
        equal(box.json("memory"), state, "state")


@test("--state keeps names that SETVN gave")
def names(box):
    run(box, "O1\nSETVN510[TOOLNO,WORKNO]\n[#WORKNO]=7\nM30\n")
    equal(run(box, "O1\n#512=[#WORKNO]+1\nM30\n")["variables"], {"#511": 7, "#512": 8}, "variables")


def with_names(number):
    return lambda state: state["names"].update(TOOLNO=number)


def with_variable(key):
    return lambda state: state["variables"].update({key: 1})


NO_STATES = {
    "a name for variable -5": with_names(-5),
    "a name for half a variable": with_names(510.5),
    "a name for a variable that no number of 32 bits reaches": with_names(1e10),
    "a name for a variable beyond all numbers": with_names(1e300),
    "a variable with a blank before it": with_variable(" 510"),
    "a variable with a sign": with_variable("+510"),
    "a variable and a word": with_variable("510th"),
    "a variable beyond all numbers": with_variable("99999999999999999999"),
}
for what, spoil in NO_STATES.items():
    @test(f"--state with {what} is refused and stays as it is")
    def no_state_of_ours(box, spoil=spoil):
        run(box, "O1\nSETVN510[TOOLNO]\nM30\n")
        state = box.json("memory")
        spoil(state)
        box.write("memory", json.dumps(state))
        refused(box.kerf("run", "part.nc", "--state", "memory"), 3)
        equal(box.json("memory"), state, "state")


@test("--state is written at an alarm and at a budget as well: those are whole runs")
def other_ends(box):
    run(box, "O1\n#500=1\n#1=1/0\nM30\n", wanted=1)
    equal(run(box, "O1\nM30\n")["variables"], {"#500": 1}, "variables behind the alarm")
    run(box, "O1\n#500=2\nN1GOTO1\n", "--max-seconds", "0.05", wanted=5)
    equal(run(box, "O1\nM30\n")["variables"], {"#500": 2}, "variables behind the budget")


@test("--state that does not exist begins with an empty memory and is made")
def new_state(box):
    equal(run(box, "O1\nM30\n")["variables"], {}, "variables")
    check("memory" in box.files(), "no state was written")


@test("without --state nothing is kept")
def no_state(box):
    box.write("part.nc", "O1\n#500=1\nM30\n")
    for _ in range(2):
        status(box.kerf("run", "part.nc"), 0)
    equal(box.files(), ["part.nc"], "files behind it")


@test("--set and --offsets come on top of what --state remembers")
def order(box):
    run(box, "O1\n#500=1\n#501=1\nG10L2P1X1.Y1.\nM30\n")
    box.write("g10.nc", "G90G10L2P1X5.\n")
    kept = run(box, "O1\n#502=#5221\n#503=#5222\nM30\n", "--set", "#500=9", "--offsets", "g10.nc")
    equal(kept["variables"], {"#500": 9, "#501": 1, "#502": 5, "#503": 1}, "variables")


@test("a state of another kind is refused in one sentence and left alone")
def broken_states(box):
    run(box, "O1\n#500=1\nM30\n")
    good = box.read("memory")
    whole = json.loads(good)
    broken = [b"", b"{}", b"[]", b"null", b"hello", good[:-20], good[:len(good) // 2],
              b"\xff\xfe" + good, b"{" * 100000]
    for key in whole:
        if key != "turning":  # states that were written before there were lathes have none
            broken.append(json.dumps({k: v for k, v in whole.items() if k != key}).encode())
        broken.append(json.dumps({**whole, key: "no"}).encode())
    for changed in ({"variables": {"100": 1}}, {"variables": {"500": None}},
                    {"variables": {"500x": 1}}, {"variables": {"1000": 1}},
                    {"work": [[1]]}, {"work": [[1, 2, 3, 4, 5, 6, 7, 8, 9]] * 6},
                    {"extended": {"301": [1]}}, {"extended": {"0": [1]}},
                    {"tools": {"0": [1, 2, 3, 4]}}, {"tools": {"401": [1, 2, 3, 4]}},
                    {"tools": {"1": [1, 2, 3]}}, {"kerf_state": 2}):
        broken.append(json.dumps({**whole, **changed}).encode())
    for content in broken:
        box.write("memory", content)
        what = content[:120]
        result = box.kerf("run", "part.nc", "--state", "memory")
        check(result.status == 3, f"exit status {result.status} for the state {what!r}")
        refused(result, 3, "memory")
        check(box.read("memory") == content, f"the state {what!r} was changed")


@test("a failed or wrong run leaves the state as it was")
def unchanged(box):
    run(box, "O1\n#500=1\nM30\n")
    before = box.read("memory")
    box.write("part.nc", "O1\n#500=2\nM30\n")
    for words, wanted in ((["gone.nc"], 3), (["part.nc", "--motion", "gone/m.json"], 3),
                          (["part.nc", "--motion", "/dev/full"], 3),
                          (["part.nc", "--set", "100"], 2)):
        status(box.kerf("run", *words, "--state", "memory"), wanted)
        check(box.read("memory") == before, f"kerf run {' '.join(words)} changed the state")


@test("a file name of the state in another folder is written there")
def other_folder(box):
    os.makedirs(box.path("there"))
    box.write("part.nc", "O1\n#500=1\nM30\n")
    status(box.kerf("run", "part.nc", "--state", "there/memory"), 0)
    equal((box.files("there"), box.files()), (["memory"], ["part.nc", "there"]), "files")


# Each pass adds 1 to #500 and writes the same number to all other variables and offsets: a memory
# that mixes two runs shows.
COUNT = ("O1\nG21G90\n#500=#500+1\n#1=501\nWHILE[#1LT1000]DO1\n#[#1]=#500\n#1=#1+1\nEND1\n#1=1\n"
         "WHILE[#1LE400]DO1\n#[12000+#1]=#500/1000\n#1=#1+1\nEND1\n"
         "#1=1\nWHILE[#1LE300]DO1\n#[14001+20*[#1-1]]=#500\n#1=#1+1\nEND1\nM30\n")
KILLS = 150


def count_in(content):
    """The pass that wrote a memory; it must be one alone."""
    state = json.loads(content)
    passes = set(state["variables"].values()) | {axes[0] for axes in state["extended"].values()}
    passes |= {round(tool[3] * 1000) for tool in state["tools"].values()}
    check(len(state["variables"]) == 500, f"{len(state['variables'])} variables, wanted 500")
    check(len(passes) == 1, f"the memory mixes several runs: {sorted(passes)}")
    return passes.pop()


@test(f"kill -9 at {KILLS} random moments leaves the old memory or the new one, always whole")
def killed(box):
    box.write("part.nc", COUNT)
    seconds = []
    for _ in range(5):
        seconds.append(box.kerf("run", "part.nc", "--state", "memory").seconds)
    equal(count_in(box.read("memory")), 5, "passes")
    longest = 1.3 * sorted(seconds)[2]
    moments = random.Random(20260101)
    count, survived = 5, 0
    for kill in range(KILLS):
        process = box.start("run", "part.nc", "--state", "memory")
        time.sleep(moments.uniform(0, longest))
        process.kill()
        process.wait()
        now = count_in(box.read("memory"))
        check(now in (count, count + 1),
              f"kill {kill}: the memory is of pass {now}, wanted {count} or {count + 1}")
        survived += now != count
        count = now
    check(0 < survived < KILLS, f"{survived} of {KILLS} runs were over before their kill: the test "
                                "has missed the moment of writing")
    status(box.kerf("run", "part.nc", "--state", "memory"), 0)
    equal(count_in(box.read("memory")), count + 1, "passes behind the kills")


@test("a file that a killed run left behind is no obstacle to the next")
def leftovers(box):
    box.write("part.nc", COUNT)
    status(box.kerf("run", "part.nc", "--state", "memory"), 0)
    box.write(".memory.AbCdEf", '{"half": ')
    status(box.kerf("run", "part.nc", "--state", "memory"), 0)
    equal(count_in(box.read("memory")), 2, "passes")


@test("the memory is as readable by others after a run as it was before")
def mode(box):
    box.write("part.nc", COUNT)
    status(box.kerf(before=("sh", "-c", 'umask 022; "$1" run part.nc --state memory', "sh")), 0)
    equal(oct(os.stat(box.path("memory")).st_mode & 0o777), "0o644", "mode")
    contains(box.read("memory").decode(), '"kerf_state"', "the memory")
