"""Input signals: programs and previews that wait for them."""

import time

from harness import *  # noqa: F403


@test("a program that waits for an input signal goes on when it is given, running or held")
def _(place):
    client = place.serve().client().watch("mill")
    program = "O1\nG91 G01 X1. F3000\nWHILE [#1003 EQ 0] DO1\nG04 P100\nEND1\nX1.\nM30\n"
    client.do("load", text=program, name="waits.nc")  # its preview waits, too
    client.do("mode", mode="auto")
    for held in (False, True):
        client.do("set-input", input=1003, value=0)
        start = client.state["position"]["machine"]["X"]
        client.do("cycle-start")
        client.wait_for(lambda: client.state["line"] == 4, "the loop")
        if held:
            client.do("feed-hold")
            client.wait_for(lambda: client.state["status"] == "held", "feed hold")
            client.do("set-variable", name="#100", value=7)
        client.do("set-input", input=1003, value=1)
        if held:
            client.do("cycle-start")
        client.wait_for(lambda: client.state["status"] == "end", "the end")
        equal(client.state["inputs"], [8, 0, 0, 0], "inputs")
        check(abs(client.state["position"]["machine"]["X"] - start - 2) < 1e-6, "where it stands")
    says(client.refused("set-input", input=1016, value=1), "no such input")
    says(client.refused("set-input", input=999, value=1), "1000 to 1035")


WAITS = "O1\nG90 G01 X1. F3000\nN10 IF [#1003 EQ 0] GOTO 10\nX5.\nM30\n"


@test("a preview that waits for an input ends at once and says so, and goes on when it is given")
def _(place):
    client = place.serve().client().watch("mill")
    for text in (WAITS, WAITS.replace("N10", "N10 G04 P500\n")):
        client.do("set-input", input=1003, value=0)
        waiting = client.load(text, name="waits.nc")
        equal(waiting["error"]["code"], "INPUT_WAIT", "why the preview ends")
        equal(waiting["error"]["severity"], "warning", "it is no mistake")
        equal(waiting["error"]["line"] in (3, 4), True, "where")
        equal(waiting["stop"], None, "the control does not stop")
        client.do("set-input", input=1003, value=1)
        client.wait_for(
            lambda: [e for e in client.events if e["event"] == "path" and e["done"] and e["error"] is None],
            "a path to the end",
        )


@test("the preview of what is loaded has the inputs that were set before it")
def _(place):
    client = place.serve().client().watch("mill")
    for i in range(40):
        client.do("set-input", input=1003, value=i % 2)
        error = client.load(WAITS, name="waits.nc")["error"]
        equal(error and error["code"], None if i % 2 else "INPUT_WAIT", f"the preview of load {i}")


@test("many inputs make few previews, and a program that reads none has its preview once")
def _(place):
    client = place.serve().client().watch("mill")
    client.load(WAITS, name="waits.nc")
    first = client.state["preview_run"]
    begin = time.monotonic()
    for i in range(150):
        client.do("set-input", input=1003, value=i % 2)
        time.sleep(0.02)
    took_s = time.monotonic() - begin
    client.wait_for(
        lambda: any(
            e["event"] == "path" and e["run"] > first and e["done"] and e["error"] is None for e in client.events
        ),
        "the path with the last input",
    )
    made = client.state["preview_run"] - first
    check(1 <= made <= took_s / 0.5 + 2, f"{made} previews in {took_s:.1f} s")
    client.load("O1\nG90 G01 X1. F3000\nM30\n", name="reads-none.nc")
    run = client.state["preview_run"]
    client.do("set-input", input=1003, value=0)
    time.sleep(1.2)
    equal(client.state["preview_run"], run, "previews of a program without inputs")
