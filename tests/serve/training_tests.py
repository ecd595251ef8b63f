"""The training mode: exercises, and what a program is worth."""

import time

from harness import *  # noqa: F403
from stock_tests import Part


def exercise(client, name):
    return next(e for e in client.do("exercises")["exercises"] if e["name"] == name)


def found(answer, kind):
    return next(c for c in answer["criteria"] if c["kind"] == kind)


@test("exercises are told in two languages, with their start and without their solution")
def _(place):
    client = place.serve().client()
    listed = client.do("exercises")["exercises"]
    check(len(listed) >= 5, f"{len(listed)} exercises")
    definitions = client.do("machines")["definitions"]
    for each in listed:
        check(each["title"]["en"] and each["title"]["zh-Hant"] and each["task"]["zh-Hant"], each)
        check(each["machine"] in definitions, each["machine"])
        check("solution" not in each, "the solution is told")
        equal(len(each["zero_mm"]), 3, "zero")


@test("what is on the table of an exercise that is judged by its part can be set up, and its part is cut from that")
def _(place):
    client = place.serve().client()
    client.watch("mill")
    told = [each for each in client.do("exercises")["exercises"] if each["set_up"] is not None]
    equal([each["name"] for each in told], ["12_pocket_plate"], "judged by the part")
    client.load(told[0]["start"], told[0]["file"])
    client.do("stock", toml=told[0]["set_up"])
    part = Part(client)
    client.do("stock", shows=True)
    part.wait_for_end()
    equal((part.facts["stock"]["low"], part.facts["stock"]["high"]), ([0, 0, -20], [80, 60, 1]), "the stock")
    check(part.facts["removed_mm3"] > 4000, "the start faces it")


@test("the start of an exercise is not enough, and what is missing is told with its place")
def _(place):
    client = place.serve().client()
    plate = exercise(client, "1_rounded_plate")
    answer = client.do("assess", exercise="1_rounded_plate", text=plate["start"])
    equal(answer["score"], sum(c["points"] for c in answer["criteria"]), "sum")
    equal(sum(c["most"] for c in answer["criteria"]), 100, "sum of the greatest")
    check(answer["score"] < 60, answer["score"])
    missing = found(answer, "all")
    equal((missing["met"], missing["finding"]), (False, "missing"), "finding")
    says(missing["sentence"], "not cut", "X52", "Y0")
    # The solution by hand: the rest of the contour behind the first side.
    rest = "G03 X60. Y8. R8.\nG01 Y32.\nG03 X52. Y40. R8.\nG01 X8.\nG03 X0. Y32. R8.\nG01 Y8.\nG03 X8. Y0. R8.\n"
    text = plate["start"].replace("(HERE THE OTHER SIDES AND THE CORNERS)\n", rest)
    equal(client.do("assess", exercise="1_rounded_plate", text=text)["score"], 100, "score")


@test("an exercise with a stock is judged by its part: what is left, and what was run into, is told")
def _(place):
    client = place.serve().client()
    plate = exercise(client, "12_pocket_plate")
    answer = client.do("assess", exercise="12_pocket_plate", text=plate["start"])
    left = found(answer, "all")
    equal((left["met"], left["finding"]), (False, "excess"), "finding")
    says(left["sentence"], "mm³ too much are left")
    check(abs(left["values"]["max_mm"] - 6) < 1, left["values"])
    check(found(answer, "checks")["met"] and answer["score"] < 60, answer)
    crash = plate["start"].replace("(HERE THE POCKET, THEN THE HOLES WITH TOOL 3)", "G00 X40. Y30.\nG43 H2 Z-3.")
    checks = found(client.do("assess", exercise="12_pocket_plate", text=crash), "checks")
    equal((checks["finding"], checks["code"], checks["points"]), ("found", "RAPID_IN_STOCK", 0), "crash")
    check(crash.splitlines()[checks["line"] - 1].startswith("G43"), checks)


@test("an alarm is told with its code, message and line")
def _(place):
    client = place.serve().client()
    slot = exercise(client, "4_mend_the_slot")
    ends = found(client.do("assess", exercise="4_mend_the_slot", text=slot["start"]), "ends")
    equal((ends["finding"], ends["code"], ends["file"]), ("alarm", "PS0020", "mend-the-slot.nc"), "alarm")
    check(slot["start"].splitlines()[ends["line"] - 1].startswith("G03"), ends)


@test("while a program without an end is assessed, the server answers others")
def _(place):
    server = place.serve()
    client, other = server.client(), server.client()
    number = client.post("assess", exercise="1_rounded_plate", text="O1\nN1 #1=0\nGOTO1\nM30\n")
    begin = time.monotonic()
    other.do("programs")
    check(time.monotonic() - begin < 2 * PATIENCE, "it waited")
    ends = found(client.answer(number), "ends")
    equal(ends["finding"], "no-end", "finding")


@test("an exercise that there is not is refused")
def _(place):
    says(place.serve().client().refused("assess", exercise="9_none", text="M30\n"), "no exercise 9_none")


@test("one program of a client is assessed at a time, those of others beside it")
def _(place):
    server = place.serve()
    client, other = server.client(), server.client()
    endless = "O1\nN1 #1=0\nGOTO1\nM30\n"
    numbers = [client.post("assess", exercise="1_rounded_plate", text=endless) for _ in range(5)]
    other.do("assess", exercise="1_rounded_plate", text="M30\n")
    client.socket.socket.setblocking(False)
    try:
        answered = client.socket.socket.recv(1 << 20).count(b'"ok":true')
    except BlockingIOError:
        answered = 0
    check(answered < len(numbers), "the other one waited for all of them")
