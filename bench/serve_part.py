#!/usr/bin/env python3
"""The part on the panel: how long until it is there, how long to go to an instant of it, and how many bytes that takes.

usage: serve_part.py --kerf PATH [--moves 1000000] [--looks 200] [--step-s 0.016] [--program FILE --set-up FILE]

Without --program the moves are a ball end mill of 6 mm over a wave of 100 × 100 mm, about 0.1 mm each. Prints a table: times
until the first picture and until all is cut, of `stock_at` at random instants (median, 95 %, worst), bytes of the first
picture and of a second of play, and the server's memory. Exit status 0.
"""

import argparse
import math
import random
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "serve"))

import harness

ROW = 1000


def surface(moves):
    lines = ["O1", "(T1 D=6. CR=3. - ball end mill)", "T1 M06", "S12000 M03", "G54", "G00 X0 Y0 Z20.", "G01 Z0 F6000"]
    for i in range(moves):
        row, k = divmod(i, ROW)
        x = 0.1 * (k if row % 2 == 0 else ROW - k)
        y = 100 * ROW * row / moves
        lines.append(f"X{x:.3f}Y{y:.3f}Z{-5.6 + 4 * math.sin(x / 11) * math.cos(y / 13):.3f}")
    return "\n".join(lines + ["G00 Z20.", "M30", ""])


def run(options):
    with tempfile.TemporaryDirectory() as folder:
        place = harness.Place(options.kerf, folder)
        try:
            measure(place, options)
        finally:
            place.clear()


class Told:
    """What the events of the part have told, newest last; the rest of what comes is let go of."""

    def __init__(self, client):
        self.client = client
        self.facts = {}

    def take(self):
        for event in self.client.events:
            if event["event"] == "stock":
                self.facts.update(event)
        self.client.events.clear()
        self.client.chunks.clear()
        return self.facts


def load(place, options):
    client = place.serve().client()
    client.do("create", name="bench", definition=options.machine)
    client.watch("bench")
    text = Path(options.program).read_text() if options.program else surface(options.moves)
    set_up = Path(options.set_up).read_text() if options.set_up else '[stock]\nshape = "box:0,0,-14,100,100,0"\n'
    (place.data / "library" / "bench.nc").write_text(text)
    client.do("load", program="bench.nc")
    client.do("stock", toml=set_up)
    return client


def measure(place, options):
    client = load(place, options)
    told = Told(client)
    begin = time.monotonic()
    client.do("stock", shows=True)
    client.wait_for(lambda: told.take() is not None and any(f.tiles for f in client.part_frames), "a picture", 120)
    print(f"first picture after {time.monotonic() - begin:.2f} s")
    client.wait_for(lambda: told.take().get("done"), "the end", 600)
    facts = told.facts
    print(f"all of {facts['done_s']:.0f} s of the program is cut after {time.monotonic() - begin:.2f} s, {facts['model']}")
    client.do("stock", shows=False)
    client.part_frames.clear()
    client.do("stock", shows=True)
    client.do("stock_at", time_s=facts["done_s"])
    print(f"a whole picture: {sum(f.bytes for f in client.part_frames) / 2**20:.2f} MiB in {len(client.part_frames)} frames")
    go_about(client, facts["done_s"], options)
    server = place.servers[0]
    print(f"the server has {server.memory_mib():.0f} MiB, {server.memory_mib('VmHWM'):.0f} MiB at most")


def go_about(client, end_s, options):
    """To instants anywhere, then forwards as during play."""
    dice = random.Random(1)
    times = []
    for _ in range(options.looks):
        begin = time.monotonic()
        client.do("stock_at", time_s=dice.uniform(0, end_s))
        times.append(1000 * (time.monotonic() - begin))
    times.sort()
    print(f"stock_at: median {times[len(times) // 2]:.0f} ms, 95 % {times[int(0.95 * len(times))]:.0f} ms, worst {times[-1]:.0f} ms")
    at = 0.4 * end_s
    client.do("stock_at", time_s=at)
    client.part_frames.clear()
    steps, begin = round(5 / options.step_s), time.monotonic()
    for i in range(steps):
        client.do("stock_at", time_s=at + i * options.step_s)
    spent = time.monotonic() - begin
    play = sum(f.bytes for f in client.part_frames)
    print(f"5 s of play in {steps} steps: {1000 * spent / steps:.1f} ms a step, {play / 5 / 2**10:.0f} KiB a second")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kerf", required=True)
    parser.add_argument("--moves", type=int, default=1_000_000)
    parser.add_argument("--looks", type=int, default=200)
    parser.add_argument("--step-s", type=float, default=1 / 60)
    parser.add_argument("--program")
    parser.add_argument("--set-up")
    parser.add_argument("--machine", default="mill3")
    run(parser.parse_args())
    return 0


if __name__ == "__main__":
    sys.exit(main())
