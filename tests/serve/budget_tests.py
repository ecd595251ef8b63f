"""Budgets: whatever one client asks for, the others are served, and the server ends when it is told to."""

import os
import resource
import signal
import socket

import harness
from harness import *  # noqa: F403
from websocket import TEXT, Closed

NESTED = "O1\n" + "WHILE[#1LT1]DO1\n" * 20_000 + "END1\n" * 20_000 + "M30\n"
SLOW = "O1\n" + "GOTO1\n" * 140_000 + "M30\n"  # as many warnings as a message can ask for
ENDLESS = {
    "M00": "N1M0\nGOTO1\n",
    "a message": "N1#3006=1(LOOK)\nGOTO1\n",
    "M00 from the head": "O1\nM0\nM99\n",
    "computing": "N1#1=#1+1\nGOTO1\n",
    "a dwell": "N1G4X99999.\nGOTO1\n",
    "moves": "N1G1X1.F9999.\nX0\nGOTO1\n",
    "calls": "O1\nN1M98P2\nGOTO1\nO2\nM0\nM99\n",
}


def end_of(server):
    """The exit status; it must come within 3 s."""
    begin = time.monotonic()
    status = server.stop(signal.SIGTERM)
    seconds = time.monotonic() - begin
    check(seconds < 3.2 * harness.PATIENCE, f"it took {seconds:.1f} s to end")
    return status


def ask_soon(client, seconds, do, **arguments):
    begin = time.monotonic()
    answer = client.do(do, **arguments)
    took = time.monotonic() - begin
    check(took < seconds * harness.PATIENCE, f"{do} was answered after {took:.1f} s")
    return answer


# Cancelling


@test("previews that only stop give way to the next program, and do not keep the server")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    for text in ENDLESS.values():
        client.do("load", text=text, name="endless.nc")
    client.load("G1X5.F1000.\nM30\n")
    other = server.client().watch("arm")
    other.load("G1X5.F1000.\nM30\n")
    client.do("load", text=ENDLESS["M00"], name="endless.nc")
    equal(end_of(server), 0, "exit status")


def remove_under_way(server):
    client = server.client()
    client.do("create", name="short", definition="mill3")
    client.watch("short")
    client.do("load", text=ENDLESS["a message"], name="endless.nc")
    client.do("remove", name="short")


def instants(server):
    client = server.client().watch("mill")
    client.do("load", text=ENDLESS["moves"], name="endless.nc")
    client.post("instant", time_s=1e9)
    back = server.client().watch("laser")
    back.post("instant", time_s=1e9)


def starts_at_a_line(server):
    client = server.client().watch("mill")
    client.do("mode", mode="auto")
    client.do("load", text="N1#1=#1+1\nGOTO1\nM0\n", name="endless.nc")
    client.post("start-at", line=3)


def checks(server):
    client = server.client()
    for _ in range(30):
        client.post("check", text=NESTED, name="nested.nc")
    client.close()


def assessments(server):
    for _ in range(10):
        server.client().post("assess", exercise="1_rounded_plate", text="O1\nN1#1=0\nGOTO1\nM30\n")


def uploads(server):
    for i in range(8):
        line = socket.create_connection((server.host, server.port))
        line.sendall(f"PUT /library/{i}.nc HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000\r\n\r\nO1".encode())
        server.kept.append(line)


def running(server):
    client = server.client().watch("mill")
    client.do("mode", mode="auto")
    client.do("load", text=ENDLESS["computing"], name="endless.nc")
    client.do("cycle-start")


def writes(server):
    client = server.client()
    for i in range(60):
        client.post("write", name=f"{i}.nc", text="G1X1.\n" * 20_000)


def idle(server):
    for _ in range(100):
        server.kept.append(socket.create_connection((server.host, server.port)))


STATES = {
    **{f"a preview of {name}": lambda server, text=text: server.client().watch("mill").do("load", text=text, name="e.nc")
       for name, text in ENDLESS.items()},
    "a preview of a machine that is gone": remove_under_way,
    "an instant that is never reached": instants,
    "a search for a line": starts_at_a_line,
    "checks of one who has left": checks,
    "assessments": assessments,
    "uploads that stand still": uploads,
    "a program that computes": running,
    "writes that wait": writes,
    "idle connections": idle,
}


def ends_in(begin):
    def run(place):
        server = place.serve()
        server.kept = []
        setter = server.client()
        setter.do("create", name="kept", definition="mill3")
        setter.watch("kept").do("load", text="#500=4711\nM30\n", name="kept.nc")
        begin(server)
        time.sleep(0.3)
        setter.do("mode", mode="auto")
        setter.do("cycle-start")
        setter.wait_for_status("end")
        equal(end_of(server), 0, "exit status")
        says((place.data / "machines/kept/memory.json").read_text(), "4711")

    return run


for name, state in STATES.items():
    test(f"the server ends within three seconds, with its memory saved: {name}")(ends_in(state))


@test("whoever leaves takes along what his questions keep busy")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("load", text=ENDLESS["moves"], name="endless.nc")
    for _ in range(5):
        client.post("instant", time_s=1e9)
    client.socket.send(json.dumps({"id": 0, "do": "machines"}))
    client.close()
    other = server.client()
    ask_soon(other, 10, "watch", machine="mill")
    # That he has left is learned from his connection: until then he operates.
    other.wait_for(lambda: other.state.get("operator", 1) is None, "the operator has left")
    other.do("operate", take=True)
    ask_soon(other, 10, "mode", mode="auto")


# Checks


@test("loops within loops are checked at once, and one client's checks do not keep another's")
def _(place):
    server = place.serve()
    one, other = server.client(), server.client()
    numbers = [one.post("check", text=NESTED, name="nested.nc") for _ in range(30)]
    equal(ask_soon(other, 8, "check", text="M30\n", name="a.nc")["diagnostics"], [], "diagnostics")
    check(one.answer(numbers[0])["ok"], "the first of the others")
    gone = server.client()
    for _ in range(30):
        gone.post("check", text=SLOW, name="slow.nc")
    gone.close()
    ask_soon(other, 15, "check", text="M30\n", name="a.nc")
    ask_soon(other, 15, "assess", exercise="1_rounded_plate", text="M30\n")


@test("of a thousand mistakes and more the first thousand are told, and how many the others are")
def _(place):
    client = place.serve().client()
    for name, text, count in (
        ("foreign.nc", "O1\n" + "foo bar baz qux\n" * 30_000 + "M30\n", 30_000),
        ("goto.bas", "goto 77\n" * 50_000, 50_000),
        ("points.tch", "TEACH 1\n" + "POINT x\n" * 60_000 + "END\n", 60_000),
        ("programs.nc", "O7\nM99\n" * 70_000, 69_999),
    ):
        answer = client.do("check", text=text, name=name)
        if answer["diagnostics"][-1]["code"] == "BUDGET":  # a busy computer
            check(answer["more"] < count, f"{name}: the others")
            continue
        equal(len(answer["diagnostics"]), 1000, f"{name}: told")
        equal(answer["more"], count - 1000, f"{name}: the others")
    equal(client.do("check", text="M30\n", name="a.nc")["more"], 0, "the others of none")


@test("a client has so many commands under way and no more")
def _(place):
    client = place.serve().client().watch("mill")
    client.do("load", text=ENDLESS["moves"], name="endless.nc")
    numbers = [client.post("instant", time_s=1e9) for _ in range(70)]
    refused = [client.answer(n) for n in numbers[64:]]
    check(all(not a["ok"] for a in refused), "those behind the 64th")
    says(refused[-1]["error"], "64 commands of this connection are under way")


@test("a crowd that keeps its connections full keeps no operator from a feed hold")
def _(place):
    server = place.serve()
    operator = server.client().watch("arm")
    operator.load("G4X100.\nM30\n")
    operator.do("mode", mode="auto")
    operator.do("cycle-start")
    operator.wait_for_status("running")
    server.client().watch("mill").do("load", text=ENDLESS["moves"], name="endless.nc")
    crowd = [server.client().watch("mill", operate=False) for _ in range(20)]
    for client in crowd:
        for _ in range(64):
            client.post("instant", time_s=1e9)
    for client in crowd:
        says(client.refused("machines"), "64 commands of this connection are under way")
    ask_soon(operator, 5, "feed-hold")
    ask_soon(server.client(), 5, "machines")



# Messages


@test("an answer that is too large is a sentence, and the client stays")
def _(place):
    server = place.serve()
    client = server.client()
    (place.data / "library/control.nc").write_bytes(b"\x01" * (4 << 20))
    says(client.refused("read", name="control.nc"), "at most 6 MiB")
    (place.data / "library/lines.nc").write_bytes(b"G1 X1.\n" * ((4 << 20) // 7))
    check(len(client.do("read", name="lines.nc")["text"]) > 4_000_000, "a program of 4 MiB is read")
    client.do("machines")


@test("brackets, values and digits beyond all measure are refused, and cost next to nothing")
def _(place):
    server = place.serve()
    attacker, other = server.client(), server.client()
    half = 500_000
    for text, word in (
        ("[" * (1 << 20), "deep"),
        ("[" * half + "]" * half, "deep"),
        ('{"do":"machines","x":' + "[" * half + "]" * half + "}", "deep"),
        ('{"do":"machines","x":[' + "{}," * 340_000 + "{}]}", "values"),
        ('{"do":"machines","x":' + "1" * 1_000_000 + "}", "characters"),
        ('{' + '"a":1,' * 100_000 + '"do":"machines"}', "values"),
    ):
        before = server.cpu_seconds()
        for _ in range(10):
            attacker.socket.send(text)
            answer = attacker.answer(None)
            check(not answer["ok"] and word in answer["error"], f"{text[:40]}: {answer}")
        spent = (server.cpu_seconds() - before) / 10
        check(spent < 0.05 * harness.PATIENCE, f"{text[:40]} costs {spent:.3f} s")
    other.do("machines")
    equal(attacker.ask("check", text='"[{' * 1000, name="a.nc")["ok"], True, "brackets in a text are text")


@test("a program of as many bytes as allowed arrives however many of them are escaped")
def _(place):
    client = place.serve().client()
    text = "G1\n" * 300_000 + "\n" * 90_000
    equal(client.do("write", name="lines.nc", text=text)["ok"], True, "written")
    equal(client.do("write", name="quotes.nc", text='"' * 1_000_000)["ok"], True, "written")
    says(client.refused("write", name="long.nc", text="x" * 1_000_001), "text")
    client.socket.send_raw(client.socket.frame(TEXT, b"x" * (4 << 20)))
    try:
        while True:
            client.receive()
    except Closed as closed:
        equal(closed.code, 1009, "close code")
        says(closed.reason, "at most", "bytes")


# Connections


def many_sockets(server, count):
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, max(soft, count + 200)), hard))
    lines = []
    for _ in range(count):
        line = socket.socket()
        line.setblocking(False)
        line.connect_ex((server.host, server.port))
        lines.append(line)
    return lines


@test("two thousand idle connections keep out nobody")
def _(place):
    server = place.serve()
    panel = server.client().watch("mill")
    lines = many_sockets(server, 2000)
    begin = time.monotonic()
    equal(server.request("GET", "/health")[0].status, 200, "health")
    newcomer = server.client()
    newcomer.do("machines")
    took = time.monotonic() - begin
    check(took < 2 * harness.PATIENCE, f"a newcomer waited {took:.1f} s")
    panel.do("mode", mode="auto")
    check(len(os.listdir(f"/proc/{server.process.pid}/fd")) < 400, "connections stay bounded")
    for line in lines:
        line.close()


@test("uploads that bring nothing give way to one that does")
def _(place):
    server = place.serve()
    server.kept = []
    uploads(server)
    eventually(lambda: server.request("PUT", "/library/a.nc", b"M30\n")[0].status == 201, "the ninth upload", 20)
    equal(sorted(p.name for p in (place.data / "library").iterdir() if not p.name.startswith(".") and p.stem.isdigit()), [],
          "nothing of them is kept")


@test("few files that may be open mean few connections, too few a sentence")
def _(place):
    few = subprocess.run(["sh", "-c", 'ulimit -n 24; exec "$@"', "sh", place.kerf, "serve", "--port", "0", "--data",
                          str(place.data)], capture_output=True, text=True, timeout=20 * harness.PATIENCE)
    equal(few.returncode, 3, "exit status")
    says(few.stderr, "only 24 files may be open", "ulimit -n")
    script = place.folder / "kerf_with_64"
    script.write_text(f'#!/bin/sh\nulimit -n 64\nexec {place.kerf} "$@"\n')
    script.chmod(0o755)
    server = Server(str(script), place.data)
    place.servers.append(server)
    lines = many_sockets(server, 100)
    equal(server.request("GET", "/health")[0].status, 200, "health")
    server.client().watch("mill")
    for line in lines:
        line.close()
    equal(end_of(server), 0, "exit status")


# What is told


@test("no answer says where the server keeps its data")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    shutil.rmtree(place.data / "library")
    sentences = [client.refused("write", name="a.nc", text="M30\n"), client.refused("programs"),
                 client.refused("read", name="flanges.nc"), client.refused("load", program="flanges.nc"),
                 server.request("PUT", "/library/a.nc", b"M30\n")[1].decode(),
                 server.request("GET", "/library/a.nc")[1].decode()]
    for sentence in sentences:
        check(sentence and str(place.folder) not in sentence, sentence)


@test("names that mislead are refused in words")
def _(place):
    server = place.serve()
    client = server.client()
    for name, word in (("a\u202ecn.nc", "not seen"), ("a\u200bb.nc", "not seen"), ("u\u0308.nc", "NFC"), ("-rf", "begins with -"),
                       ("CON", "device"), ("con.nc", "device"), ("LPT1.nc", "device"), ("a\u0007.nc", "no text")):
        says(client.refused("write", name=name, text="M30\n"), word)
        says(client.refused("rename", **{"from": "flanges.nc", "to": name}), word)
    for name in ("\u00fc.nc", "零件.nc", "ガ.nc", "console.nc", "com10.nc", "a-b.nc", "O1"):
        client.do("write", name=name, text="M30\n")


# Tokens


@test("who guesses a token gets one answer a second, and the operator a line")
def _(place):
    server = place.serve("--token", "0123456789abcdef")
    begin = time.monotonic()
    for _ in range(2):
        equal(server.request("GET", "/api?token=wrong")[0].status, 401, "status")
    check(time.monotonic() - begin >= 2, "an answer came at once")
    says(server.errors(), "a wrong token came from 127.0.0.1")
    check("0123456789abcdef" not in server.errors() and "wrong\n" not in server.errors(), "no token is told")
    begin = time.monotonic()
    equal(server.request("GET", "/api")[0].status, 401, "without one")
    equal(server.request("GET", "/health")[0].status, 200, "health")


@test("a token comes from a file or the environment as well")
def _(place):
    token = place.folder / "token"
    token.write_text("0123456789abcdef-file\n")
    server = place.serve("--token-file", str(token))
    equal(server.request("GET", "/api?token=0123456789abcdef-file")[0].status, 200, "of the file")
    server.stop()
    os.environ["KERF_TOKEN"] = "0123456789abcdef-environment"
    try:
        server = place.serve()
    finally:
        del os.environ["KERF_TOKEN"]
    equal(server.request("GET", "/api?token=0123456789abcdef-environment")[0].status, 200, "of the environment")
    for words in (("--token", "fifteen-letters"), ("--token-file", str(place.folder / "none")),
                  ("--token-file", "/dev/zero"), ("--token-file", str(token), "--token", "0123456789abcdef")):
        result = place.run("serve", "--port", "0", "--data", str(place.folder / "d"), *words)
        check(result.returncode in (2, 3), f"{words}: {result.returncode}")
        says(result.stderr, "token")
