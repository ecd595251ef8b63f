"""The engraver's own data on the engraver's panel: bytes in the library, their listing on the machine."""

import json
import tempfile
from pathlib import Path

from harness import *

BYTES = bytes.fromhex("7F00C8 3F0FA0 400CA7 FF00C8")
LISTING = "F Z 200\nF T2 4000\nS 0 12 -7\nF Z -200\n"


def put(server, data, name="w.pat"):
    answer, body = server.request("PUT", "/library/" + name, data)
    equal(answer.status, 201, body)


def get(server, name="w.pat"):
    answer, body = server.request("GET", "/library/" + name)
    equal(answer.status, 200, body)
    return body


def arm_with_pattern(place):
    """A server with the pattern in its library, and a client that operates the arm."""
    server = place.serve()
    put(server, BYTES)
    return server, server.client().watch("arm")


def path_of_load(client, **arguments):
    client.chunks.clear()
    client.events.clear()
    client.do("load", **arguments)
    return client.wait_for_path()


def replayed(place, data):
    """The summary of `kerf pattern replay`."""
    with tempfile.TemporaryDirectory() as folder:
        file, summary = Path(folder) / "w.pat", Path(folder) / "w.json"
        file.write_bytes(data)
        place.run("pattern", "replay", str(file), "--summary", str(summary))
        return json.loads(summary.read_text())


@test("a pattern is loaded, shown and previewed as its listing, and ends where a replay ends", long=True)
def _(place):
    server, client = arm_with_pattern(place)
    equal(client.do("recognise", name="w.pat")["usual"], "arm4")
    equal(client.do("read", name="w.pat")["text"], LISTING)
    path = path_of_load(client, program="w.pat")
    equal((path["error"], path["findings"]), (None, []))
    expected = replayed(place, BYTES)
    check(abs(path["time_s"] - expected["time_s"]) < 0.002, f"{path} {expected}")
    client.do("mode", mode="auto")
    client.do("cycle-start")
    client.wait_for(lambda: client.state.get("text") == "F T2 4000", "the second record")
    client.do("feed-hold")
    client.wait_for_status("held")
    held = client.state["joints"]["T2"] / 0.005
    check(abs(held - round(held)) < 1e-6, f"the motor rests between its pulses: {held}")
    client.do("cycle-start")
    client.wait_for_status("end", seconds=40)
    at = client.state["position"]["machine"]
    for axis, value in expected["position"]["machine"].items():
        check(abs(at[axis] - value) < 1e-6, f"{axis}: {at[axis]} {value}")


@test("the library gives back the bytes of a pattern, and saves a listing as bytes")
def _(place):
    server, client = arm_with_pattern(place)
    client.do("load", program="w.pat")
    equal(get(server), BYTES)
    equal(client.do("write", name="w.pat", text=LISTING)["text"], LISTING)
    equal(get(server), BYTES)
    made = client.do("write", name="v.pat", text="# two moves\nF Z -0\nF T1 -70000 # long\n\n")
    equal(made["text"], "F Z -0\nF T1 -65535\nF T1 -4465\n")
    equal(get(server, "v.pat"), bytes.fromhex("FF0000 9FFFFF 9F1171"))
    equal(client.do("read", name="v.pat", revision=made["revision"])["text"], made["text"])


@test("a broken pattern is told with its place, and nothing of it is loaded")
def _(place):
    server = place.serve()
    client = server.client().watch("arm")
    before = client.state["file"]
    for data, words in [
        (BYTES[:-1], ["byte 9", "record 4", "PATTERN_TRUNCATED"]),
        (bytes.fromhex("7F00C8 401FA7"), ["byte 4", "record 2", "PATTERN_FIELD"]),
        (bytes.fromhex("400CC7"), ["byte 2", "record 1", "PATTERN_AXIS"]),
    ]:
        put(server, data)
        says(client.refused("load", program="w.pat"), "w.pat", *words)
        says(client.refused("read", name="w.pat"), *words)
    equal(client.state["file"], before)
    says(client.refused("write", name="w.pat", text="F Z 200\nS 1 2\n"), "line 2", "PATTERN_TEXT")
    equal(get(server), bytes.fromhex("400CC7"), "what was refused has changed nothing")
    found = client.do("check", name="w.pat", text="F Z 200\nF Q 1\nS 1 2\n", machine="arm")["diagnostics"]
    equal([(d["code"], d["line"]) for d in found], [("PATTERN_TEXT", 2), ("PATTERN_TEXT", 3)])
    path = path_of_load(client, text="F Z 200\nF Q 1\n", name="w.pat")
    equal((path["error"]["code"], path["error"]["line"]), ("PATTERN_TEXT", 2))
    path = path_of_load(client, text="F Z 200\nF Z 20000\n", name="w.pat")
    equal((path["error"]["code"], path["error"]["line"]), ("LIMIT", 2))


@test("a line of a thousand million pulses is refused before it is written out")
def _(place):
    server = place.serve()
    client = server.client().watch("arm")
    says(client.refused("write", name="w.pat", text="S 0 2147483647 0\n"), "has more than 4 MiB")
    says(client.refused("write", name="w.pat", text="S 2147483647 0 0\n"), "has more than 4 MiB")
    says(client.refused("write", name="w.pat", text="S 0 20000000 0\n"), "has more than 4 MiB", "kerf pattern decode")
    put(server, bytes.fromhex("5E9EBE") * 400_000)
    says(client.refused("read", name="w.pat"), "the listing of w.pat has more than 4 MiB")
    put(server, bytes(3 * 1_400_000))
    says(client.refused("load", program="w.pat"), "has more than 4 MiB")


@test("a machine without motors that count refuses a pattern")
def _(place):
    server = place.serve()
    put(server, BYTES)
    for machine in ("mill", "laser"):
        client = server.client().watch(machine)
        says(client.refused("load", program="w.pat"), "has no controller for patterns", "arm4")
        says(client.refused("check", name="w.pat", text=LISTING, machine=machine), "has no controller for patterns")
        client.close()


@test("the bytes of a count are read in the order of the machine")
def _(place):
    server = place.serve()
    put(server, bytes.fromhex("7FC800"))
    client = server.client().watch("arm")
    toml = client.do("settings")["toml"]
    client.do("set-settings", toml=toml.replace('byte_order = "big" ', 'byte_order = "little" '))
    equal(client.do("read", name="w.pat")["text"], "F Z 200\n")
    client.do("write", name="w.pat", text="F Z 201\n")
    equal(get(server), bytes.fromhex("7FC900"))
    path_of_load(client, program="w.pat")
    client.wait_for(lambda: client.state["file"] == "w.pat", "the program")


@test("a machine file in a language that is not run is refused")
def _(place):
    client = place.serve().client().watch("mill")
    toml = client.do("settings")["toml"]
    wrong = toml.replace('dialect = "fanuc-mill"', 'dialect = "pattern"')
    check(wrong != toml, "the dialect of the file")
    client.refused("set-settings", toml=wrong)
    equal(client.do("settings")["toml"], toml)


@test("a pattern that was loaded is there after the server comes again")
def _(place):
    server, client = arm_with_pattern(place)
    client.do("load", program="w.pat")
    client.close()
    server.stop()
    client = place.serve().client().watch("arm")
    client.wait_for(lambda: client.state.get("file") == "w.pat", "the pattern")
    client.do("mode", mode="auto")
    client.do("cycle-start")
    client.wait_for(lambda: client.state.get("text") == "F T2 4000", "the second record")


@test("what a pattern does not have is refused with a code, as all that operators meet")
def _(place):
    server, client = arm_with_pattern(place)
    client.do("load", program="w.pat")
    answer = client.ask("set-variable", name="#500", value=1)
    equal((answer["ok"], answer.get("code")), (False, "pattern-variables"))
    answer = client.ask("breakpoints", list=[{"file": "w.pat", "line": 1, "condition": "#500EQ1"}])
    says(answer["error"], "breakpoint in line 1", "a pattern has no variables, and so no conditions")
