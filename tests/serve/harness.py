"""What the tests of `kerf serve` share: the real server in a folder of its own, a client that speaks its protocol, checks.

A test is a function with one parameter, a Place, under @test("a sentence").
"""

import http.client
import json
import os
import re
import shutil
import signal
import struct
import subprocess
import tempfile
import time
from pathlib import Path

from websocket import Closed, WebSocket

PATIENCE = 1  # a sanitizer's build takes longer for everything
# A sanitizer keeps what was freed for a while: bounds of memory are wider by this many MiB.
QUARANTINE_MIB = 0
KILLS = 0  # of the test that kills servers; 0: as many as it has usually
TESTS = []
LONG_ONES = []  # their sentences


def test(sentence, long=False):
    """`long`: it waits for ten seconds or so. Those begin first: none of them is left over at the end."""

    def add(function):
        TESTS.insert(len(LONG_ONES) if long else len(TESTS), (sentence, function))
        if long:
            LONG_ONES.append(sentence)
        return function

    return add


class Failed(Exception):
    pass


def check(condition, message):
    if not condition:
        raise Failed(message)


def equal(got, wanted, what=""):
    check(got == wanted, f"{what}: wanted {wanted!r}, got {got!r}")


def says(text, *words):
    for word in words:
        check(word in text, f"{word!r} is not in {text!r}")


class Server:
    """`kerf serve` on a free port."""

    def __init__(self, kerf, data, *options):
        self.log = tempfile.TemporaryFile()
        self.process = subprocess.Popen(
            [kerf, "serve", "--port", "0", "--data", str(data), *options],
            stdout=subprocess.PIPE,
            stderr=self.log,
            text=True,
            restore_signals=False,  # SIGXFSZ stays ignored: a limit of the size of files is a full disk
        )
        line = self.process.stdout.readline()
        match = re.search(r"http://([\d.]+):(\d+)/", line)
        check(match, f"no address in {line!r}; {self.errors()}")
        self.host, self.port = match[1], int(match[2])
        self.host = "127.0.0.1" if self.host == "0.0.0.0" else self.host

    def errors(self):
        self.log.seek(0)
        return self.log.read().decode()

    def client(self, **options):
        return Client(self, **options)

    def request(self, method, path, body=None, headers=None):
        connection = http.client.HTTPConnection(self.host, self.port, timeout=60)
        connection.request(method, path, body, headers or {})
        answer = connection.getresponse()
        text = answer.read()
        connection.close()
        return answer, text

    def memory_mib(self, which="VmRSS"):
        status = Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(rf"{which}:\s+(\d+)", status)[1]) / 1024

    def cpu_seconds(self):
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def reset_peak(self):
        Path(f"/proc/{self.process.pid}/clear_refs").write_text("5")

    def stop(self, how=signal.SIGTERM):
        """The exit status."""
        if self.process.poll() is None:
            self.process.send_signal(how)
        return self.process.wait(30 * PATIENCE)


class Client:
    """One who is connected; events and chunks that come in between are kept."""

    def __init__(self, server, path="/ws", headers=None, receive_buffer=None):
        self.socket = WebSocket(server.host, server.port, path, headers, receive_buffer)
        self.state = {}
        self.events = []
        self.chunks = []
        self.part_frames = []  # of the part, as they come
        self.answers = {}
        self.next_id = 1
        self.name = None

    def receive(self, timeout=60 * PATIENCE):
        message = self.socket.receive(timeout)
        if isinstance(message, bytes):
            if message[:4] == b"KSTK":
                self.part_frames.append(PartFrame(message))
            else:
                self.chunks.append(Chunk(message))
            return
        frame = json.loads(message)
        if "id" in frame:
            self.answers[frame["id"]] = frame
        elif frame["event"] == "state":
            self.state.update(frame)
        else:
            self.events.append(frame)

    def post(self, do, **arguments):
        number = self.next_id
        self.next_id += 1
        self.socket.send(json.dumps({"id": number, "do": do, **arguments}))
        return number

    def answer(self, number):
        while number not in self.answers:
            self.receive()
        return self.answers.pop(number)

    def ask(self, do, **arguments):
        return self.answer(self.post(do, **arguments))

    def do(self, do, **arguments):
        answer = self.ask(do, **arguments)
        check(answer["ok"], f"{do}: {answer.get('error')}")
        return answer

    def refused(self, do, **arguments):
        """The sentence."""
        answer = self.ask(do, **arguments)
        check(not answer["ok"], f"{do} is not refused: {answer}")
        return answer["error"]

    def wait_for(self, condition, what, seconds=60):
        end = time.monotonic() + seconds * PATIENCE
        while not condition():
            left = end - time.monotonic()
            check(left > 0, f"{what} did not come; the state is {self.state}")
            try:
                self.receive(left)
            except TimeoutError:
                pass

    def wait_for_status(self, *wanted, seconds=60):
        self.wait_for(lambda: self.state.get("status") in wanted, f"status {wanted}", seconds)

    def settle(self, seconds=30):
        """Waits until the machine does not run, and has not begun to for a moment."""
        quiet_since = time.monotonic()
        end = quiet_since + seconds * PATIENCE
        while time.monotonic() - quiet_since < 0.25:
            check(time.monotonic() < end, f"it does not come to rest: {self.state}")
            try:
                self.receive(0.05)
            except TimeoutError:
                pass
            if self.state.get("status", "running") == "running":
                quiet_since = time.monotonic()
        return self.state

    def watch(self, machine, operate=True):
        self.name = self.do("watch", machine=machine)["client"]
        if operate:
            self.do("operate", take=True)
        self.wait_for(lambda: self.state, "the first state")
        return self

    def load(self, text, name="test.nc"):
        """Loads a text and waits for its preview; the last `path` event."""
        self.chunks.clear()
        self.events.clear()
        self.do("load", text=text, name=name)
        return self.wait_for_path()

    def wait_for_path(self, seconds=60):
        def paths():
            return [e for e in self.events if e["event"] == "path"]

        self.wait_for(lambda: paths() and paths()[-1]["done"], "the end of the preview", seconds)
        path = paths()[-1]

        def have():
            return 1 + sum(c.vertices - 1 for c in self.chunks if c.run == path["run"])

        self.wait_for(lambda: path["vertices"] == 0 or have() == path["vertices"], "all chunks", seconds)
        self.chunks = [c for c in self.chunks if c.run == path["run"]]
        return path

    def close(self):
        self.socket.close()


class Chunk:
    """A binary frame of a path, as docs/panel-protocol.md has it."""

    def __init__(self, data):
        magic, version, self.source, self.run, self.number, self.first_motion, n, base = struct.unpack_from(
            "<4sHHIIIId", data
        )
        equal(magic, b"KPTH", "magic")
        equal(version & 0xFF, 1, "version")
        self.vertices = n
        self.at = struct.calcsize("<4sHHIIIId")
        self.data = data
        flat = self.array("f", 3 * n)
        self.xyz = [flat[3 * i : 3 * i + 3] for i in range(n)]
        self.time_s = [base + t for t in self.array("f", n)]
        self.feed = self.array("f", n)
        self.speed = self.array("f", n)
        self.motion = self.array("I", n)
        self.line = self.array("I", n)
        self.file = self.array("H", n)
        self.kind = self.array("B", n)
        self.tool = self.array("B", n)
        self.power = self.array("B", n)
        self.rotary = self.array("f", 2 * n) if version & 0x100 else None
        equal(self.at, len(data), "bytes of the chunk")

    def array(self, kind, count):
        values = struct.unpack_from(f"<{count}{kind}", self.data, self.at)
        self.at += (count * struct.calcsize("<" + kind) + 3) // 4 * 4
        return values


class PartFrame:
    """A binary frame of the part, as docs/panel-protocol.md has it."""

    def __init__(self, data):
        magic, version, self.kind, self.run, self.number, self.level, count, self.time_s = struct.unpack_from("<4sHHIIIId", data)
        equal((magic, version), (b"KSTK", 1), "magic and version")
        self.data = data
        self.bytes = len(data)
        self.at = struct.calcsize("<4sHHIIIId")
        read = {0: self.heights, 1: self.mesh, 2: self.loop, 3: self.sheet, 4: self.facts}[self.kind]
        self.tiles = []
        for _ in range(count):
            self.tiles.append(read())
            self.at = (self.at + 3) // 4 * 4
        equal(self.at, len(data), "bytes of the frame")

    def take(self, form):
        values = struct.unpack_from("<" + form, self.data, self.at)
        self.at += struct.calcsize("<" + form)
        return values

    def heights(self):
        x, y, nx, ny, z0, dz = self.take("iiHHff")
        check(0 < nx <= 65 and 0 < ny <= 65, f"a tile of {nx} x {ny}")
        raw = self.take(f"{nx * ny}H")
        return {"at": (x, y), "nx": nx, "ny": ny, "z": [None if h == 65535 else z0 + dz * h for h in raw],
                "owner": self.take(f"{nx * ny}H")}

    def mesh(self):
        *at, vertices, triangles = self.take("iiiII")
        *origin, scale = self.take("ffff")
        flat = self.take(f"{3 * vertices}h")
        points = [tuple(o + scale * p for o, p in zip(origin, flat[3 * i : 3 * i + 3])) for i in range(vertices)]
        self.take(f"{2 * vertices}b")
        owner = self.take(f"{vertices}H")
        index = self.take(f"{3 * triangles}H")
        check(all(i < vertices for i in index), "triangles of vertices that are there")
        return {"at": tuple(at), "points": points, "owner": owner, "index": index}

    def loop(self):
        (n,) = self.take("I")
        flat = self.take(f"{3 * n}d")
        return [flat[3 * i : 3 * i + 3] for i in range(n)]

    def sheet(self):
        x, y, nx, ny, full = self.take("iiHHf")
        return {"at": (x, y), "nx": nx, "ny": ny, "full": full, "energy": self.take(f"{nx * ny}B"),
                "coverage": self.take(f"{nx * ny}B")}


    def facts(self):
        *at, what, _, n, scale = self.take("iiiHHIf")
        return {"at": tuple(at), "what": ("deviation", "owner")[what], "scale": scale, "value": self.take(f"{n}h")}


class Place:
    """A folder of its own and the servers in it, which end with the test."""

    def __init__(self, kerf, root):
        self.kerf = kerf
        self.root = Path(root)
        self.folder = Path(tempfile.mkdtemp(prefix="kerf-serve-"))
        self.data = self.folder / "data"
        self.servers = []

    def serve(self, *options, data=None):
        server = Server(self.kerf, data or self.data, *options)
        self.servers.append(server)
        return server

    def run(self, *words):
        return subprocess.run([self.kerf, *words], capture_output=True, text=True, timeout=60 * PATIENCE)

    def clear(self):
        for server in self.servers:
            if server.process.poll() is None:
                server.process.kill()
            server.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


def eventually(condition, what, seconds=60):
    end = time.monotonic() + seconds * PATIENCE
    while not condition():
        check(time.monotonic() < end, f"{what} did not happen")
        time.sleep(0.02)


__all__ = [name for name in dir() if not name.startswith("_")]
assert Closed and os  # for those who import all of it
