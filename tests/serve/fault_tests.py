"""Clients that break the rules, and servers that are killed."""

import json
import signal

import harness
from harness import *  # noqa: F403
from websocket import BINARY, TEXT, Closed

MIB = 1 << 20


def close_code(client):
    try:
        while True:
            client.receive()
    except Closed as closed:
        return closed.code


@test("frames that break the protocol close their connection with its code, and nothing else")
def _(place):
    server = place.serve()
    good = server.client().watch("mill")
    frames = {
        "unmasked": (lambda s: s.frame(TEXT, b"{}", masked=False), 1002),
        "reserved opcode": (lambda s: s.frame(3, b"{}"), 1002),
        "reserved bit": (lambda s: s.frame(TEXT, b"{}", reserved=0x40), 1002),
        "control frame in pieces": (lambda s: s.frame(9, b"x", final=False), 1002),
        "continuation of nothing": (lambda s: s.frame(0, b"x"), 1002),
        "no UTF-8": (lambda s: s.frame(TEXT, b"\xff\xfe"), 1007),
        "2 MiB": (lambda s: s.frame(TEXT, b"x" * (2 * MIB)), 1009),
        "binary": (lambda s: s.frame(BINARY, b"x"), 1003),
    }
    for name, (make, code) in frames.items():
        client = server.client()
        try:
            client.socket.send_raw(make(client.socket))
        except OSError:
            pass
        equal(close_code(client), code, name)
    half = server.client()
    half.socket.send_raw(half.socket.frame(TEXT, b"x" * 1000)[:500])
    half.close()
    good.do("mode", mode="auto")
    good.wait_for(lambda: good.state.get("operator") == good.name, "who operates it")


@test("more commands than the server takes are refused in words")
def _(place):
    client = place.serve().client()
    began = time.monotonic()
    numbers = [client.post("machines") for _ in range(900)]
    answers = [client.answer(n) for n in numbers]
    seconds = time.monotonic() - began
    refused = [a for a in answers if not a["ok"]]
    check(900 - len(refused) <= 200 * (seconds + 2), f"{len(refused)} are refused in {seconds:.1f} s")
    check(refused or seconds > 2.5, f"none is refused in {seconds:.1f} s")  # a slow computer sends no more than 200 itself
    for answer in refused:
        says(answer["error"], "200 commands a second")
    time.sleep(1)
    client.do("machines")


@test("a client that reads no answers is closed when too many wait for it, and memory stays bounded")
def _(place):
    server = place.serve()
    good = server.client().watch("mill")
    good.do("write", name="big.nc", text="G1 X1.\n" * 100_000)
    before = server.memory_mib()
    lazy = server.client(receive_buffer=4096)
    try:
        for _ in range(100):
            lazy.post("read", name="big.nc")
    except OSError:
        pass
    eventually(lambda: "client-2 is closed" in server.errors(), "the end of the connection", 20)
    says(server.errors(), "answers were waiting")
    good.do("machines")
    check(server.memory_mib("VmHWM") < before + 200 + harness.QUARANTINE_MIB, f"{before} MiB became {server.memory_mib('VmHWM')}")


@test("a client that stops reading is closed, the others go on", long=True)
def _(place):
    server = place.serve()
    good = server.client().watch("mill")
    good.do("write", name="long.nc", text="G90 G21\n" + "G1 X10. F3000\nG1 X0.\n" * 40_000 + "M30\n")
    good.do("load", program="long.nc")
    good.wait_for_path(60)
    lazy = server.client(receive_buffer=4096)
    lazy.post("watch", machine="mill")
    eventually(lambda: "takes nothing for 10 s" in server.errors(), "the end of the connection", 30)
    good.wait_for(lambda: good.state["clients"] == [good.name], "only one is left")


@test("a server that is killed loses nothing that was answered")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("write", name="kept.nc", text="O5\nG90 G21\nG01 X5. F1000\nM30\n")
    client.do("load", program="kept.nc")
    client.do("set-offset", offset="G55", axis="Y", value=-12.25)
    client.do("set-variable", name="#512", value=7)
    client.do("create", name="new", definition="laser5")
    server.process.send_signal(signal.SIGKILL)
    server.process.wait()
    server = place.serve()
    client = server.client().watch("mill")
    client.wait_for(lambda: client.state.get("file") == "kept.nc", "the loaded program")
    rows = {(r["offset"], r["axis"]): r["value"] for r in client.do("offsets")["offsets"]}
    equal(rows[("G55", "Y")], -12.25, "G55")
    equal(client.do("variables", names=["#512"])["variables"][0]["value"], 7, "#512")
    equal(client.do("read", name="kept.nc")["text"].splitlines()[0], "O5", "the program")
    equal(len(client.do("revisions", name="kept.nc")["revisions"]), 1, "its revisions")
    check("new" in [m["name"] for m in client.do("machines")["machines"]], "the new machine")


@test("what a program writes into permanent variables survives a kill a moment later")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.load("#530=42.5\nG90 G01 X1. F3000\nM30\n")
    client.do("cycle-start")
    client.wait_for_status("end")
    time.sleep(2 * PATIENCE)
    server.stop(signal.SIGKILL)
    client = place.serve().client().watch("mill")
    equal(client.do("variables", names=["#530"])["variables"][0]["value"], 42.5, "#530")


@test("SIGTERM tells the clients, writes the memory and ends with 0")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.load("#531=43.5\nG90 G01 X100. F1000\nM30\n")
    client.do("cycle-start")
    client.wait_for_status("running")
    server.process.send_signal(signal.SIGTERM)
    equal(close_code(client), 1001, "close code")
    equal(server.stop(), 0, "exit status")
    equal(server.errors(), "", "what it says")
    memory = json.loads((place.data / "machines/mill/memory.json").read_text())
    says(json.dumps(memory), "43.5")


@test("two servers do not share a folder")
def _(place):
    place.serve()
    result = place.run("serve", "--port", "0", "--data", str(place.data))
    equal(result.returncode, 3, "exit status")
    says(result.stderr, "another `kerf serve`")


@test("a damaged machine is left out in words, the others run")
def _(place):
    place.serve().stop()
    (place.data / "machines/laser/machine.toml").write_text("nonsense")
    server = place.serve()
    names = [m["name"] for m in server.client().do("machines")["machines"]]
    equal(names, ["arm", "five-axis", "laser-xtz", "lathe", "mill"], "machines")
    says(server.errors(), "laser is left out")
    equal((place.data / "machines/laser/machine.toml").read_text(), "nonsense", "the file stays")


@test("a program that never ends computes beside the others")
def _(place):
    server = place.serve()
    stuck, other = server.client().watch("mill"), server.client().watch("arm")
    stuck.do("load", text="N1 #100=#100+1\nGOTO 1\n", name="loop.nc")
    stuck.do("cycle-start")
    stuck.wait_for_status("running")
    other.do("cycle-start")
    other.wait_for_status("running")
    other.state["time_s"] = 0
    other.wait_for(lambda: other.state["time_s"] > 1, "progress", 10)
    stuck.do("reset")
    stuck.wait_for_status("idle")
