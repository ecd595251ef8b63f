#!/usr/bin/env python3
"""How a server bears many machines that run in real time while others watch.

usage: bench/serve_load.py [--kerf PATH] [--machines N] [--clients N] [--seconds N]

Makes N machines in a server of its own, runs a program of ten minutes on each, and lets clients watch one each. Prints the load of
the server, the time between two states at each client, and its memory. Exit status 1: a state came later than 100 ms.
"""

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/serve"))
sys.dont_write_bytecode = True
from websocket import WebSocket  # noqa: E402

PROGRAM = """G90 G21 G54
#1=0
WHILE [#1 LT 100] DO1
G01 X50. Y0. F2400
G02 X50. Y40. J20. F1800
G01 X0. F2400
G03 X0. Y0. J-20. F1800
#1=#1+1
END1
M30
"""
LONGEST_GAP_S = 0.1
# Twenty clients who come at once get their pictures first, 2 MB each.
SETTLE_S = 3


class Client:
    def __init__(self, port):
        self.socket = WebSocket("127.0.0.1", port)
        self.next_id = 0

    def post(self, do, **arguments):
        self.next_id += 1
        self.socket.send(json.dumps({"id": self.next_id, "do": do, **arguments}))
        return self.next_id

    def do(self, do, **arguments):
        number = self.post(do, **arguments)
        while True:
            message = self.socket.receive(120)
            if isinstance(message, str) and json.loads(message).get("id") == number:
                answer = json.loads(message)
                if not answer["ok"]:
                    raise SystemExit(f"{do}: {answer['error']}")
                return answer


def start(kerf, folder):
    process = subprocess.Popen([kerf, "serve", "--port", "0", "--data", folder], stdout=subprocess.PIPE, text=True)
    return process, int(re.search(r":(\d+)/", process.stdout.readline())[1])


def run_machines(port, count):
    """Each as an operator does it, by a connection of its own: one may not send so many commands a second."""
    for i in range(count):
        name = f"m{i}"
        client = Client(port)
        client.do("create", name=name, definition="mill3")
        client.do("watch", machine=name)
        client.do("operate", take=True)
        client.do("load", text=PROGRAM, name="load.nc")
        client.do("cycle-start")
        client.socket.close()


def watch(port, machine, until, gaps):
    client = Client(port)
    client.do("watch", machine=machine)
    last, begin = None, time.monotonic() + SETTLE_S
    while time.monotonic() < until:
        message = client.socket.receive(30)
        if not isinstance(message, str) or '"time_s"' not in message[:400] or '"event":"state"' not in message[:40]:
            continue
        now = time.monotonic()
        if last is not None and last > begin:
            gaps.append(now - last)
        last = now
    client.socket.close()


def sleep_and_note(until, late):
    """How late this computer wakes a thread that has slept: no server can be better."""
    while time.monotonic() < until:
        begin = time.monotonic()
        time.sleep(0.05)
        late.append(time.monotonic() - begin - 0.05)


def cpu_seconds(pid):
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def peak_mib(pid):
    return int(re.search(r"VmHWM:\s+(\d+)", Path(f"/proc/{pid}/status").read_text())[1]) / 1024


def measure(process, port, options):
    gaps = [[] for _ in range(options.clients)]
    until = time.monotonic() + SETTLE_S + options.seconds
    threads = [
        threading.Thread(target=watch, args=(port, f"m{i * options.machines // options.clients}", until, gaps[i]))
        for i in range(options.clients)
    ]
    late = []
    threads.append(threading.Thread(target=sleep_and_note, args=(until, late)))
    before, begin = cpu_seconds(process.pid), time.monotonic()
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    used = (cpu_seconds(process.pid) - before) / (time.monotonic() - begin)
    return used, [gap for each in gaps for gap in each], max(late)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kerf", default=str(ROOT / "build/release/bin/kerf"))
    parser.add_argument("--machines", type=int, default=200)
    parser.add_argument("--clients", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=30)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="kerf-load-") as folder:
        process, port = start(options.kerf, folder)
        try:
            run_machines(port, options.machines)
            used, gaps, wakes_late = measure(process, port, options)
            peak = peak_mib(process.pid)
        finally:
            process.terminate()
            process.wait(60)
    gaps.sort()
    late = [gap for gap in gaps if gap > LONGEST_GAP_S]
    print(f"machines {options.machines}, clients {options.clients}, {options.seconds:.0f} s, load before {os.getloadavg()[0]:.1f}")
    print(f"processor   {used:.2f} of {os.cpu_count()}")
    print(f"memory      {peak:.0f} MiB")
    print(f"states      {len(gaps)}; {len(gaps) / options.clients / options.seconds:.1f} a second for each client")
    print(
        f"gaps        median {statistics.median(gaps) * 1000:.1f} ms, 99.9 % {gaps[int(len(gaps) * 0.999)] * 1000:.1f} ms, "
        f"longest {gaps[-1] * 1000:.1f} ms; {len(late)} above {LONGEST_GAP_S * 1000:.0f} ms"
    )
    print(f"computer    wakes a sleeping thread up to {wakes_late * 1000:.1f} ms late")
    return 1 if late else 0


if __name__ == "__main__":
    sys.exit(main())
