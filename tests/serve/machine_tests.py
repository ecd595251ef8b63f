"""Machines driven through the protocol, by one client and by two."""

import math
import threading

from harness import *  # noqa: F403

MACRO = """O1
G90 G21 G54
#100=0
G65 P2 A7. B3.
G01 X20. F3000
M30
O2
#101=#1*2
#102=#101+#2
G01 X#102 F3000
M99
"""


@test("at its first start there is a machine of each kind with a program loaded")
def _(place):
    client = place.serve().client()
    rows = {m["name"]: m for m in client.do("machines")["machines"]}
    equal(sorted(rows), ["arm", "five-axis", "laser", "laser-xtz", "lathe", "mill"], "machines")
    for name, row in rows.items():
        answer = client.do("watch", machine=name)
        equal(client.wait_for_path()["error"], None, name)
        check(sum(c.vertices for c in client.chunks) > 20, f"{name} has a picture")
        client.wait_for(lambda: client.state.get("machine") == name and client.state["file"], "the program")
        equal(answer["definition"]["name"], row["definition"], "definition")
        client.chunks.clear()
        client.events.clear()
        client.state.clear()
    client.do("create", name="second", definition="mill4")
    says(client.refused("create", name="second", definition="mill4"), "already")
    says(client.refused("create", name="third", definition="lathe9"), "no built-in machine")
    says(client.refused("create", name="../x", definition="mill4"), "letters")
    client.do("remove", name="second")
    equal(len(client.do("machines")["machines"]), 6, "machines")


@test("the preview's vertices are the programmed points, at the times of the run")
def _(place):
    program = "G90 G21 G54\nG00 X10. Y0. Z-5.\nG01 X30. F1200\nG02 X30. Y-20. I0. J-10. F600\nG04 P500\nG01 X10. F3000\nM30\n"
    path = place.folder / "p.nc"
    path.write_text(program)
    points = place.run("run", str(path), "--points", "-").stdout.splitlines()
    end_s = float(points[-1].split(",")[0])
    client = place.serve().client().watch("mill")
    event = client.load(program)
    equal(event["error"], None, "error")
    vertices = [(c.xyz[i], c.time_s[i], c.line[i], c.kind[i], c.speed[i]) for c in client.chunks
                for i in range(0 if c.number == 0 else 1, c.vertices)]
    close_to = lambda a, b, tolerance: all(abs(x - y) <= tolerance for x, y in zip(a, b))  # noqa: E731
    check(close_to(vertices[0][0], (0, 0, 0), 1e-6), "the start")
    for end, line in (((10, 0, -5), 2), ((30, 0, -5), 3), ((30, -20, -5), 4), ((10, -20, -5), 6)):
        check(any(v[2] == line and close_to(v[0], end, 1e-4) for v in vertices), f"line {line} ends at {end}")
    for xyz, _time, line, _kind, _speed in vertices:
        if line == 4:
            check(abs(math.hypot(xyz[0] - 30, xyz[1] + 10) - 10) < 1e-4, f"{xyz} is on the circle")
    arc = [v[0] for v in vertices if v[2] == 4]
    for a, b in zip(arc, arc[1:]):
        middle = math.hypot((a[0] + b[0]) / 2 - 30, (a[1] + b[1]) / 2 + 10)
        check(10 - middle <= 0.01 + 1e-5, f"chord error {10 - middle}")
    times = [v[1] for v in vertices]
    check(all(a <= b for a, b in zip(times, times[1:])), "times grow")
    check(abs(event["time_s"] - end_s) < 1e-3, f"{event['time_s']} s, kerf run says {end_s}")
    dwell = [(a[1], b[1]) for a, b in zip(vertices, vertices[1:]) if b[3] == 2]
    check(len(dwell) == 1 and abs(dwell[0][1] - dwell[0][0] - 0.5) < 2e-3, f"the dwell takes {dwell}")
    # When a segment ends the axes are there, but for corners that are rounded by 0.01 mm.
    rows = [tuple(map(float, row.split(",")[:4])) for row in points[1:]]
    for xyz, at_s, *_rest in vertices[1:]:
        nearest = min(rows, key=lambda row: abs(row[0] - at_s))
        way = 0.001 * 400  # of a period at the rapid rate
        check(math.dist(xyz, nearest[1:]) < way, f"at {at_s} s: {xyz}, kerf run says {nearest}")
    fastest = max(v[4] for v in vertices if v[2] == 4)
    check(fastest < 600 * (1 + 0.001 / 0.089), f"no faster than programmed, but for a period in a chord: {fastest}")


@test("a program runs, is held, goes on, and ends where it should")
def _(place):
    client = place.serve().client().watch("mill")
    client.load("G90 G21 G54\nG01 X50. F3000\nG01 Y10. F3000\nM30\n")
    client.do("cycle-start")
    client.wait_for_status("running")
    client.wait_for(lambda: client.state["position"]["machine"]["X"] > 5, "movement")
    client.do("feed-hold")
    client.wait_for_status("held")
    held = client.state["position"]["machine"]["X"]
    check(5 < held < 50, f"held at {held}")
    client.do("cycle-start")
    client.wait_for_status("end")
    equal(client.state["position"]["machine"], {"X": 50, "Y": 10, "Z": 0}, "end")


@test("it runs in real time")
def _(place):
    client = place.serve().client().watch("mill")
    total = client.load("G90 G21 G54\nG01 X50. F1500\nM30\n")["time_s"]
    begin = time.monotonic()
    client.do("cycle-start")
    client.wait_for_status("end")
    check(abs(time.monotonic() - begin - total) < 0.5 * PATIENCE, f"{time.monotonic() - begin} s instead of {total} s")


@test("stepping into a macro shows its local variables")
def _(place):
    client = place.serve().client().watch("mill")
    client.load(MACRO)
    for _ in range(12):
        client.do("step", how="into")
        if len(client.settle()["stack"]) == 2:
            break
    equal(len(client.state["stack"]), 2, "calls")
    values = {v["name"]: v["value"] for v in client.do("variables")["variables"]}
    equal((values["#1"], values["#2"]), (7, 3), "arguments")
    client.do("step", how="out")
    equal(len(client.settle()["stack"]), 1, "calls")
    values = {v["name"]: v["value"] for v in client.do("variables", names=["#102"])["variables"]}
    equal(values["#102"], 17, "#102")


@test("a breakpoint stops before its line, and on a variable's writing")
def _(place):
    client = place.serve().client().watch("mill")
    client.load(MACRO)
    client.do("breakpoints", list=[{"file": "test.nc", "line": 10}])
    client.do("cycle-start")
    equal(client.settle()["status"], "step", "status")
    equal(client.state["line"], 10, "line")
    equal(client.state["breakpoint"]["line"], 10, "breakpoint")
    client.do("reset")
    client.settle()
    client.do("breakpoints", list=[{"variable": "#102"}])
    client.do("cycle-start")
    equal(client.settle()["status"], "step", "status")
    equal(client.state["breakpoint"]["variable"], "#102", "breakpoint")
    says(client.refused("breakpoints", list=[{"file": "test.nc", "line": 3, "condition": "#1 +"}]), "breakpoint in line 3")
    says(client.refused("breakpoints", list=[{"file": "test.nc"}]), "line or a variable")


@test("an alarm is told in words with cause and place")
def _(place):
    client = place.serve().client().watch("mill")
    event = client.load("G90 G21\nG01 X1. F100\nG777\nM30\n")
    equal(event["error"]["line"], 3, "line of the preview's alarm")
    client.do("cycle-start")
    client.wait_for_status("alarm")
    alarm = client.state["alarm"]
    equal((alarm["code"], alarm["line"], alarm["file"]), ("PS0010", 3, "test.nc"), "alarm")
    says(alarm["cause"], "G code does not exist")
    client.do("reset")
    client.wait_for(lambda: client.state["alarm"] is None, "no alarm")


@test("the preview goes on behind alarms, the machine stops at the first")
def _(place):
    client = place.serve().client().watch("mill")
    event = client.load("O0000\nG01 X10. F6000\nG04 P1.0\nG01 X20.\nG04 P2.0\nM30\n")
    equal([(each["line"], each["code"]) for each in event["findings"]],
          [(1, "PS0074"), (3, "PS0007"), (5, "PS0007")], "findings")
    equal((event["error"]["line"], event["stop"], event["cut_short"]), (1, {"motion": 0, "time_s": 0}, False), "stop")
    event = client.load("G01 X10. F6000\nG04 P1.0\nG01 X20.\nG04 P2.0\nM30\n")
    equal((event["error"]["line"], event["stop"]["motion"], event["motions"]), (2, 1, 3), "stop in the middle")
    check(0 < event["stop"]["time_s"] < event["time_s"], f"time of the stop: {event}")
    equal(client.state["total_s"], None, "how long it takes")
    client.do("cycle-start")
    client.wait_for_status("alarm")
    equal(client.state["alarm"]["line"], 2, "line of the machine's alarm")
    equal(client.state["position"]["machine"]["X"], 10, "where the machine stands")
    client.do("reset")
    event = client.load("G01 X10. F6000\nM30\n")
    equal((event["findings"], event["stop"]), ([], None), "nothing wrong")


@test("a program tells for which machine it looks to be written, and machines which ones they suit")
def _(place):
    client = place.serve().client()
    for name, text, wanted in [
        ("turn.nc", "T101\nG00 Z0 X-25.5\nG97 M03 S500\nM30\n", ("lathe", 1, "T101", "lathe2")),
        ("polar.nc", "G50 S3000\nG00 X50.\nG12.1\nM30\n", ("lathe-c", 3, "G12.1", "lathe3c")),
        ("mill.nc", "T1 M06\nG00 X0 Y0\nM30\n", ("mill", 1, "M06", "mill3")),
        ("a.bas", "move(1,2)\n", ("laser-basic", 0, "", "laser3")),
        ("plain.nc", "G01 X1. F100\nM30\n", ("any", 0, "", "mill3")),
    ]:
        client.do("write", name=name, text=text)
        look = client.do("recognise", name=name)
        equal((look["kind"], look["line"], look["word"], look["usual"]), wanted, name)
    says(client.refused("recognise", name="none.nc"), "none.nc")
    suits = {row["name"]: row["suits"] for row in client.do("machines")["machines"]}
    equal(suits["mill"], ["mill"], "mill")
    check("laser-basic" in suits["laser"] and "mill" not in suits["laser"], f"laser: {suits}")
    equal(suits["five-axis"], ["laser", "laser-basic", "teach"], "five-axis")
    equal(suits["arm"], ["pattern"], "arm")
    equal(suits["lathe"], ["lathe"], "lathe")


@test("MDI executes, jog moves until it is let go, teaching captures")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("mode", mode="mdi")
    client.do("mdi", text="G90 G21 G01 X3. F3000")
    client.wait_for(lambda: client.state["position"]["machine"].get("X") == 3, "MDI")
    client.wait_for_status("end", "idle", "stopped")
    client.do("mode", mode="jog")
    client.do("jog", axis="Y", speed_mm_min=600)
    client.wait_for(lambda: client.state["position"]["machine"]["Y"] > 0.5, "jog")
    client.do("jog-stop")
    client.wait_for(lambda: client.state["status"] != "running", "standstill")
    stands = client.state["position"]["machine"]["Y"]
    time.sleep(0.3)
    client.do("machines")
    equal(client.state["position"]["machine"]["Y"], stands, "Y")


@test("who loses the connection lets go of the jog key")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("mode", mode="jog")
    client.do("jog", axis="X", speed_mm_min=600)
    client.wait_for(lambda: client.state["position"]["machine"]["X"] > 0.3, "jog")
    client.close()
    other = server.client().watch("mill", operate=False)
    other.wait_for(lambda: other.state.get("operator", 1) is None and other.state["status"] != "running", "standstill")
    equal(other.state["position"]["machine"]["X"] < 5, True, "not far")


@test("one client operates, the other is refused in words, and control can be handed over")
def _(place):
    server = place.serve()
    first, second = server.client().watch("mill"), server.client().watch("mill", operate=False)
    says(second.refused("cycle-start"), "operated by " + first.name)
    says(second.refused("operate", take=True), "operated by " + first.name)
    says(second.refused("operate", take=True, hand_to=second.name), "only who operates")
    says(first.refused("operate", take=False, hand_to="client-99"), "no client client-99")
    first.do("operate", take=False, hand_to=second.name)
    second.wait_for(lambda: second.state.get("operator") == second.name, "the hand-over")
    second.do("mode", mode="auto")
    says(first.refused("mode", mode="edit"), "operated by " + second.name)
    second.close()
    first.wait_for(lambda: first.state.get("operator", 1) is None, "freedom")
    says(first.refused("mode", mode="edit"), "nobody operates")
    first.do("operate", take=True)


@test("of two who take a free machine at once and press cycle start, one runs it")
def _(place):
    server = place.serve()
    for _round in range(10):
        clients = [server.client() for _ in range(2)]
        names = [c.watch("mill", operate=False).name for c in clients]
        taken = [None, None]

        def press(i):
            taken[i] = [clients[i].ask("operate", take=True), clients[i].ask("cycle-start")]

        threads = [threading.Thread(target=press, args=(i,)) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        winners = [i for i in range(2) if taken[i][1]["ok"]]
        equal(len(winners), 1, f"who runs it: {taken}")
        says(taken[1 - winners[0]][1]["error"], "operated by " + names[winners[0]])
        says(clients[winners[0]].refused("cycle-start"), "")
        clients[winners[0]].do("reset")
        clients[winners[0]].settle()
        for client in clients:
            client.close()
        watcher = server.client().watch("mill", operate=False)
        watcher.wait_for(lambda: watcher.state.get("operator", 1) is None and watcher.state["status"] != "running", "rest")
        watcher.close()


@test("offsets, tools and variables can be read and set; the preview follows")
def _(place):
    client = place.serve().client().watch("mill")
    client.load("G90 G21 G54\nG01 X10. F1000\nM30\n")
    client.events.clear()
    client.chunks.clear()
    client.do("set-offset", offset="G54", axis="X", value=100)
    rows = {(r["offset"], r["axis"]): r["value"] for r in client.do("offsets")["offsets"]}
    equal(rows[("G54", "X")], 100, "G54")
    client.wait_for_path()
    equal(client.chunks[-1].xyz[-1][0], 110, "the picture's end")
    client.do("set-tool", number=5, length_geometry=80, radius_geometry=4)
    row = next(t for t in client.do("tools")["tools"] if t["number"] == 5)
    equal((row["length_geometry"], row["radius_geometry"]), (80, 4), "tool 5")
    client.do("set-variable", name="#500", value=12.5)
    equal(client.do("variables", names=["#500"])["variables"][0]["value"], 12.5, "#500")
    client.do("set-variable", name="#500", value=None)
    client.refused("set-offset", offset="G99", axis="X", value=1)
    client.refused("set-variable", name="#-1", value=1)


@test("optional stop, block skip and the interrupt act where the axes are")
def _(place):
    client = place.serve().client().watch("mill")
    client.load("O1\nM96 P2\nG91 G61 G01 X2. F120\n/Y5.\nX2.\nM01\nX1.\nM97\nM30\nO2\nY1.\nM99\n")
    client.do("mode", mode="auto")
    client.do("cycle-start")
    client.wait_for(lambda: client.state["position"]["machine"]["X"] > 0.2, "the first cut")
    client.do("block-skip", levels=[1])
    client.do("switch", switch="optional-stop", on=True)
    client.do("interrupt")
    client.wait_for(lambda: client.state["status"] == "stopped", "M01")
    place_of = client.state["position"]["machine"]
    equal((round(place_of["X"], 6), round(place_of["Y"], 6)), (4, 1), "where it has stopped")
    client.do("interrupt")
    client.do("cycle-start")
    client.wait_for(lambda: client.state["status"] == "end", "the end")
    place_of = client.state["position"]["machine"]
    equal((round(place_of["X"], 6), round(place_of["Y"], 6)), (5, 2), "where it ends")


@test("the machine file can be replaced by a right one")
def _(place):
    client = place.serve().client().watch("mill")
    toml = client.do("settings")["toml"]
    says(client.refused("set-settings", toml="nonsense = 1"), "mill")
    client.do("set-settings", toml=toml.replace("velocity = 24000", "velocity = 12000", 1))
    client.wait_for(lambda: any(e["event"] == "definition" for e in client.events), "the new definition")
    definition = next(e for e in client.events if e["event"] == "definition")["definition"]
    equal(definition["rapid_mm_min"]["X"], 12000, "rapid rate")


@test("arguments are held against the table")
def _(place):
    client = place.serve().client()
    says(client.refused("mode", mode="auto"), "no machine is watched")
    client.watch("mill")
    says(client.refused("nothing"), "no command nothing")
    says(client.refused("mode", mode="fast"), "one of edit")
    says(client.refused("mode"), "missing")
    says(client.refused("override", feed=201), "0 to 200")
    says(client.refused("override", feed="50"), "number")
    says(client.refused("block-skip", levels=[0]), "whole numbers 1 to 9")
    says(client.refused("cycle-start", speed=1), "no argument speed")
    says(client.refused("watch", machine="none"), "no machine none")
    client.socket.send("not json")
    client.wait_for(lambda: None in client.answers, "an answer")
    says(client.answers.pop(None)["error"], "JSON")
    client.do("override", feed=50)
    client.wait_for(lambda: client.state.get("override", {}).get("feed") == 50, "the dial")


@test("a text is checked without being loaded")
def _(place):
    client = place.serve().client()
    found = client.do("check", name="x.nc", text="G01 X1.\nG01 X1..2\nIF [#1 EQ] GOTO 1\nM30\n")["diagnostics"]
    equal([d["line"] for d in found], [2, 3], "lines")
    says(found[0]["cause"], "decimal point")
    found = client.do("check", name="x.bas", text="LET A = (1\n")["diagnostics"]
    equal(found[0]["line"], 1, "BASIC by its ending")


@test("speeds along the path, pulses and instants are told")
def _(place):
    client = place.serve().client().watch("mill")
    path = client.load("G90 G21 G54\nG01 X10. F600\nG01 X20. F1200\nM30\n")
    speeds = client.do("speeds", from_s=0, to_s=path["time_s"], points=100)
    equal(len(speeds["speed_mm_min"]), 100, "points")
    check(590 < speeds["speed_mm_min"][30] < 601, f"{speeds['speed_mm_min'][30]} at line 2")
    check(1150 < speeds["speed_mm_min"][90] < 1201, f"{speeds['speed_mm_min'][90]} at line 3")
    equal((speeds["line"][30], speeds["line"][90]), (2, 3), "lines")
    client.do("pulses", seconds=5)
    client.do("cycle-start")
    client.wait_for_status("end")
    pulses = client.do("pulses", seconds=10)["pulses"]
    steps = sum(pulses["X"][1::2])
    equal(steps, 20 * 200, "steps of X")
    instant = client.do("instant", time_s=0.5)
    check(4 < instant["position"]["machine"]["X"] < 6, instant["position"])
    equal(instant["line"], 2, "line at that instant")
