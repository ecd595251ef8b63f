#!/usr/bin/env python3
"""How long a large program takes until there is a picture of it, and what the server needs for it.

usage: bench/serve_picture.py [--kerf PATH] [--motions N]

Writes a program of N short moves into the library of a server of its own, loads it, and takes the chunks as a page does. Prints
the time to the first chunk and to the last one, how much there was, and the memory of the server. Exit status 1: the first
chunk came later than a second after the command.
"""

import argparse
import http.client
import json
import math
import os
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/serve"))
sys.path.insert(0, str(ROOT / "bench"))
sys.dont_write_bytecode = True
from serve_load import Client, peak_mib, start  # noqa: E402

FIRST_S = 1.0


def program(motions):
    """A waved surface in lines of half a millimetre, as a CAM system writes it."""
    lines = ["%", "O1", "G90 G21 G54", "G00 X-200. Y-200. Z0.", "G01 F4000"]
    across = 800
    for i in range(motions):
        row, column = divmod(i, across)
        x = -200 + 0.5 * (column if row % 2 == 0 else across - 1 - column)
        y = -200 + 0.3 * row
        lines.append(f"X{x:.3f} Y{y:.3f} Z{-20 + 10 * math.sin(x / 15) * math.cos(y / 20):.3f}")
    return "\n".join([*lines, "M30", "%", ""]).encode()


def upload(port, name, text):
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
    connection.request("PUT", f"/library/{name}", text)
    answer = connection.getresponse()
    if answer.status != 201:
        raise SystemExit(answer.read().decode())


class Picture:
    """What comes between the command and the end of the preview."""

    def __init__(self, client):
        self.client = client
        self.begin = time.monotonic()
        self.first_s = None
        self.bytes = self.chunks = self.vertices = 0

    def take(self):
        client, path = self.client, None
        client.post("load", program="large.nc")
        while path is None or self.vertices < path["vertices"]:
            message = client.socket.receive(600)
            if isinstance(message, bytes):
                self.take_chunk(message)
            elif '"event":"path"' in message[:20]:
                event = json.loads(message)
                path = event if event["done"] else path
                if path and path["error"]:
                    raise SystemExit(str(path["error"]))
        return path

    def take_chunk(self, message):
        if self.first_s is None:
            self.first_s = time.monotonic() - self.begin
        self.vertices += int.from_bytes(message[20:24], "little") - (1 if self.chunks else 0)
        self.chunks += 1
        self.bytes += len(message)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kerf", default=str(ROOT / "build/release/bin/kerf"))
    parser.add_argument("--motions", type=int, default=1_000_000)
    options = parser.parse_args()
    text = program(options.motions)
    with tempfile.TemporaryDirectory(prefix="kerf-picture-") as folder:
        process, port = start(options.kerf, folder)
        try:
            upload(port, "large.nc", text)
            client = Client(port)
            client.do("create", name="bench", definition="mill3")
            client.do("watch", machine="bench")
            client.do("operate", take=True)
            before = peak_mib(process.pid)
            picture = Picture(client)
            path = picture.take()
            whole_s = time.monotonic() - picture.begin
            peak = peak_mib(process.pid)
        finally:
            process.terminate()
            process.wait(60)
    print(f"program     {options.motions} moves, {len(text) / 1e6:.1f} MB, runs {path['time_s'] / 60:.1f} min; load {os.getloadavg()[0]:.1f}")
    print(f"first chunk {picture.first_s:.3f} s behind the command, the last one {whole_s:.1f} s")
    print(f"picture     {picture.vertices} vertices in {picture.chunks} chunks, {picture.bytes / 1e6:.1f} MB")
    print(f"memory      {peak:.0f} MiB at most, {before:.0f} MiB before")
    return 1 if picture.first_s > FIRST_S else 0


if __name__ == "__main__":
    sys.exit(main())
