"""A lathe on the panel: X is said and shown as a diameter, tools have the offsets of lathes, the speed is that of the spindle."""

import json
import math

import harness  # noqa: F401
from harness import *  # noqa: F403

PROGRAM = ("O1\nG50S2000\nG96S200M03\nT0101\nG00X60.Z2.\nG01Z-30.F.2\nX20.Z-32.\nM00\nG97S500\nG00X40.Z0.\nM00\nG00X90.Z10.\nM30\n")


def lathe(place):
    client = place.serve().client()
    client.do("create", name="turner", definition="lathe2")
    return client.watch("turner")


def start(client):
    client.do("mode", mode="auto")
    client.do("cycle-start")


def run_to_stop(client, text=PROGRAM):
    client.load(text)
    start(client)
    client.wait_for_status("stopped", "end")


def tool(client, number):
    return {t["number"]: t for t in client.do("tools")["tools"]}.get(number, {})


def at(client, frame="work"):
    return client.state["position"][frame]


def mdi(client, text):
    client.do("mode", mode="mdi")
    client.do("mdi", text=text)
    client.settle()


@test("positions of a lathe are diameters in X, its joints are the ways of the axes, and the definition says so")
def _(place):
    client = lathe(place)
    mdi(client, "G00X60.Z-5.\n")
    equal(at(client), {"X": 60, "Z": -5}, "work")
    equal(at(client, "machine"), {"X": 60, "Z": -5}, "machine")
    equal(client.state["joints"], {"X": 30, "Z": -5}, "joints")
    definition = client.do("watch", machine="turner")["definition"]
    equal([(a["name"], a["diameter"], a["min"], a["max"]) for a in definition["axes"]], [("X", True, -20, 400), ("Z", False, -600, 300)],
          "axes")
    equal((definition["lathe"], definition["joints"][0]["max"]), (True, 200), "definition")


@test("what is still to go of X is a diameter, too")
def _(place):
    client = lathe(place)
    client.load("O1\nG98G01X100.F60\nM30\n")
    start(client)
    client.wait_for(lambda: at(client)["X"] > 0.2, "a way")
    client.do("feed-hold")
    client.wait_for_status("held")
    client.settle()
    x, distance = at(client)["X"], at(client, "distance")["X"]
    check(abs(x + distance - 100) < 1e-5, f"{x} and {distance} to go make 100")


@test("a jog of X by a distance changes the diameter by it, and the end of its travel is a diameter")
def _(place):
    client = lathe(place)
    client.do("mode", mode="jog")
    client.do("jog", axis="X", speed_mm_min=3000, distance_mm=10)
    client.settle()
    equal(at(client)["X"], 10, "X")
    client.do("jog", axis="X", speed_mm_min=20000)
    client.wait_for_status("alarm")
    equal(at(client)["X"], 400, "the end of X")
    says(client.state["alarm"]["message"], "400")


@test("offsets of tools of a lathe are set by their names, whole ones whole, and those of a mill it has not")
def _(place):
    client = lathe(place)
    for part, value in {"geometry_x": -120.5, "wear_z": 0.02, "geometry_radius": 0.8, "tip": 3}.items():
        client.do("set-offset", offset=f"tool.5.{part}", value=value)
    row = tool(client, 5)
    equal([row[key] for key in ("geometry_x", "geometry_z", "wear_z", "geometry_radius", "tip")], [-120.5, 0, 0.02, 0.8, 3], "row")
    client.do("set-tool", number=6, geometry_z=12, tip=2)
    equal((tool(client, 6)["geometry_z"], tool(client, 6)["tip"]), (12, 2), "row 6")
    equal(client.do("tools")["count"], 64, "rows")
    says(client.refused("set-offset", offset="tool.5.tip", value=1.5), "a whole number from 0 to 9")
    says(client.refused("set-offset", offset="tool.5.length_geometry", value=1), "no offset")
    says(client.refused("set-offset", offset="tool.65.wear_x", value=1), "no offset")
    client.watch("mill")
    says(client.refused("set-offset", offset="tool.5.wear_x", value=1), "no offset")
    says(client.refused("measure-offset", number=5, axis="X", reads=1), "no offset")


@test("a tool that is touched off reads what was measured, wear and work system counted in")
def _(place):
    client = lathe(place)
    client.do("set-offset", offset="G54", axis="X", value=4)
    client.do("set-offset", offset="G54", axis="Z", value=-100)
    client.do("set-offset", offset="tool.3.wear_x", value=0.1)
    mdi(client, "G53X52.Z-80.\n")
    client.do("measure-offset", number=3, axis="X", reads=38.25)
    client.do("measure-offset", number=3, axis="Z", reads=0)
    row = tool(client, 3)
    equal((row["geometry_x"], row["geometry_z"]), (round(52 - 4 - 38.25 - 0.1, 6), 20), "geometry")
    mdi(client, "T0303\nG00X38.25Z0.\n")
    equal((at(client), at(client, "machine")), ({"X": 38.25, "Z": 0}, {"X": 52, "Z": -80}), "with the offset in force")
    equal(client.state["tool_offset"], 3, "the offset in force")
    client.do("measure-offset", number=3, axis="X", reads=30)
    equal(tool(client, 3)["geometry_x"], round(52 - 4 - 30 - 0.1, 6), "measured again with the offset in force")
    says(client.refused("measure-offset", number=3, axis="C", reads=1), "no axis")
    says(client.refused("measure-offset", number=65, axis="X", reads=1), "no offset")


@test("offsets of a lathe are on the disk, come back, and go back with a step back")
def _(place):
    client = lathe(place)
    client.do("set-offset", offset="tool.7.geometry_x", value=-33.5)
    memory = json.loads((place.data / "machines" / "turner" / "memory.json").read_text())
    equal(memory["turning"], {"7": {"geometry_x": -33.5}}, "on the disk")
    client.load("O1\nG10P10007X-40.\nG10P7Z.25Q2\nG04X.5\nM30\n")
    client.do("mode", mode="auto")
    for _ in range(4):
        client.do("step", how="over")
        client.settle()
    equal((tool(client, 7)["geometry_x"], tool(client, 7)["wear_z"]), (-40, 0.25), "behind the blocks")
    for _ in range(3):
        client.do("step", how="back")
        client.settle()
    equal((tool(client, 7)["geometry_x"], tool(client, 7)["wear_z"]), (-33.5, 0), "back")


@test("the speed of the spindle follows the diameter under G96, to the clamp, and is what G97 says", long=True)
def _(place):
    client = lathe(place)
    run_to_stop(client)
    spindle = client.state["spindle"]
    equal((spindle["surface_m_min"], spindle["limit_rpm"]), (200, 2000), "as programmed")
    equal(spindle["speed_rpm"], 2000, "at a diameter of 20, clamped")
    client.do("cycle-start")
    client.wait_for(lambda: client.state["status"] == "stopped" and client.state["line"] == 11, "the second stop")
    spindle = client.state["spindle"]
    equal((spindle["surface_m_min"], spindle["speed_rpm"]), (0, 500), "G97")


@test("under way the speed is that of the diameter, and the feed says mm a turn")
def _(place):
    client = lathe(place)
    client.load("O1\nG96S150M03\nG00X80.Z2.\nG01Z-300.F.25\nM30\n")
    start(client)
    client.wait_for(lambda: client.state["feed"]["programmed_mm_rev"] == 0.25, "the cut")
    rpm = 150_000 / (math.pi * 80)
    check(abs(client.state["spindle"]["speed_rpm"] - rpm) < 1e-3, f"{client.state['spindle']} is not {rpm}")
    client.wait_for(lambda: abs(client.state["feed"]["actual_mm_min"] - rpm * 0.25) < 0.1, "the feed")


@test("a thread keeps the speed that it begins with")
def _(place):
    client = lathe(place)
    client.load("O1\nG96S60M03\nG00X40.Z5.\nG32X30.Z-300.F1.5\nM30\n")
    start(client)
    client.wait_for(lambda: client.state["feed"]["programmed_mm_rev"] == 1.5, "the thread")
    rpm = 60_000 / (math.pi * 40)
    client.wait_for(lambda: at(client)["X"] < 39, "a part of it")
    check(abs(client.state["spindle"]["speed_rpm"] - rpm) < 1e-3, f"{client.state['spindle']} is not {rpm}")
