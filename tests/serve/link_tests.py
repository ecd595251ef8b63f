"""Heartbeats, dated commands, names, and how the operation of a machine is taken over."""

import signal

import harness
from harness import *  # noqa: F403

LONG = "G90 G21 G54\nG01 X100. F300\nM30\n"


def server_ms(client):
    return client.do("ping")["time_ms"]


@test("the first event names the run of the server, which is another one after a restart")
def _(place):
    def hello():
        server = place.serve()
        client = server.client().watch("mill")
        event = client.events[0]
        equal((event["event"], event["client"]), ("hello", client.name), "the first event")
        check(abs(event["began_ms"] / 1000 - time.time()) < 60 * harness.PATIENCE, "when it began")
        server.stop()
        return event["server"]

    check(hello() != hello(), "both runs have one name")


@test("a dated command that comes late is refused in words, and nothing moves")
def _(place):
    client = place.serve().client().watch("mill")
    client.load(LONG)
    now = server_ms(client)
    for do, arguments in [
        ("cycle-start", {}),
        ("step", {"how": "over"}),
        ("run-to", {"file": "test.nc", "line": 2}),
        ("set-offset", {"offset": "G54", "axis": "X", "value": 5}),
    ]:
        says(client.refused(do, at_ms=now - 5000, **arguments), do, "s ago", "older than 2 s is not carried out")
    equal(client.settle()["status"], "idle", "status")
    says(client.refused("cycle-start", at_ms="now"), "at_ms must be a number")
    client.do("cycle-start", at_ms=server_ms(client))
    client.wait_for_status("running")
    client.do("feed-hold")
    client.do("reset")


@test("a key that was pressed while the server hung does nothing when it goes on")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.load(LONG)
    now = server_ms(client)
    server.process.send_signal(signal.SIGSTOP)
    dated = client.post("cycle-start", at_ms=now)
    hold = client.post("reset")
    time.sleep(3)
    server.process.send_signal(signal.SIGCONT)
    says(client.answer(dated)["error"], "not carried out")
    check(client.answer(hold)["ok"], "what stops the machine is never too late")
    equal(client.settle()["status"], "idle", "status")


def jogging_with_pings(place):
    client = place.serve().client().watch("mill")
    client.do("mode", mode="jog")
    client.do("ping")
    client.do("jog", axis="X", speed_mm_min=60)
    client.wait_for(lambda: client.state["status"] == "running", "the jog")
    return client


@test("who has sent pings and falls silent lets go of the jog key")
def _(place):
    client = jogging_with_pings(place)
    client.wait_for(lambda: client.state["status"] != "running", "its end")
    check(client.state["position"]["machine"]["X"] < 15, "not far")


@test("pings keep a jog going")
def _(place):
    client = jogging_with_pings(place)
    end = time.monotonic() + 5
    while time.monotonic() < end:
        client.do("ping")
        time.sleep(0.2)
    equal(client.state["status"], "running", "status")
    client.do("jog-stop")


def two(place):
    server = place.serve()
    first, second = server.client().watch("mill"), server.client().watch("mill", operate=False)
    return server, first, second


@test("a request is granted when the operator says nothing for ten seconds, and not before", long=True)
def _(place):
    _server, first, second = two(place)
    second.do("introduce", name="Lee")
    begin = time.monotonic()
    second.do("request-operation", ask=True)
    first.wait_for(lambda: first.state.get("request"), "the request")
    equal(first.state["request"]["client"], second.name, "who asks")
    equal(first.state["people"], {second.name: "Lee"}, "people")
    check(0 < first.state["request"]["until_ms"] - server_ms(first) <= 10_000, "until when")
    second.wait_for(lambda: second.state["operator"] == second.name, "the operation")
    check(9.5 < time.monotonic() - begin, f"it was granted after {time.monotonic() - begin} s")
    equal(second.state["request"], None, "request")
    second.do("mode", mode="auto")
    says(first.refused("mode", mode="edit"), "operated by Lee (" + second.name + ")")


@test("a request can be granted, refused and withdrawn; who leaves frees the machine for who asked")
def _(place):
    server, first, second = two(place)
    second.do("request-operation", ask=True)
    first.wait_for(lambda: first.state.get("request"), "the request")
    third = server.client().watch("mill", operate=False)
    says(third.refused("request-operation", ask=True), "has asked for mill already")
    first.do("answer-request", grant=False)
    second.wait_for(lambda: any(e["event"] == "request-refused" for e in second.events), "the refusal")
    equal(first.state["operator"], first.name, "operator")
    says(first.refused("answer-request", grant=True), "nobody asks")

    second.do("request-operation", ask=True)
    second.do("request-operation", ask=False)
    first.wait_for(lambda: first.state["request"] is None, "that it is withdrawn")

    second.do("request-operation", ask=True)
    first.do("answer-request", grant=True)
    second.wait_for(lambda: second.state["operator"] == second.name, "the operation")

    third.do("request-operation", ask=True)
    second.close()
    third.wait_for(lambda: third.state["operator"] == third.name, "the operation")

    first.do("request-operation", ask=True)
    first.close()
    third.wait_for(lambda: third.state["request"] is None, "the end of the request")


@test("a machine that nobody operates is given to who asks for it")
def _(place):
    _server, first, second = two(place)
    first.do("operate", take=False)
    second.do("request-operation", ask=True)
    second.wait_for(lambda: second.state["operator"] == second.name, "the operation")


@test("the machines tell which program each of them has loaded")
def _(place):
    client = place.serve().client().watch("mill")
    client.load(LONG, name="mine.nc")
    client.wait_for(
        lambda: any(
            row["program"] == "mine.nc" for e in client.events if e["event"] == "machines" for row in e["machines"]
        ),
        "the program",
    )


@test("a refusal that operators meet has its code and values beside the sentence")
def _(place):
    server, first, second = two(place)
    first.do("mode", mode="jog")
    wrong_mode = first.ask("cycle-start")
    equal((wrong_mode["code"], wrong_mode["values"]), ("start-in-mode", {"mode": "jog"}), "cycle start in jog")
    says(wrong_mode["error"], "mode jog: turn the switch to auto")
    watching = second.ask("reset")
    values = {"command": "reset", "machine": "mill", "name": first.name}
    equal((watching["code"], watching["values"]), ("operated-by", values), "who only watches")
    missing = first.ask("load", program="<none>.nc")
    equal((missing["code"], missing["values"]["character"]), ("program-name-character", "<"), "a name")
    late = first.ask("home", at_ms=server_ms(first) - 9000)
    equal((late["code"], late["values"]["command"]), ("command-late", "home"), "a late command")
