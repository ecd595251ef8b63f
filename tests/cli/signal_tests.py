"""Ctrl-C and its like in the middle of a run."""

import os
import signal
import time

import harness
from harness import check, equal, status, test

ENDLESS = "O1\nG21G90G17G94F500\nN1G91G01X0.01Y0.01\nDPRNT[AGAIN*AND*AGAIN]\nGOTO1\n"


def running(box, *words):
    """Starts an endless run and waits until its outputs have grown."""
    box.write("part.nc", ENDLESS)
    process = box.start("run", "part.nc", "--max-seconds", "40", "--max-motions", "0", *words)
    for _ in range(2000):
        unfinished = [name for name in os.listdir(box.folder) if name.startswith(".")]
        if any(os.path.getsize(box.path(name)) > 0 for name in unfinished):
            return process, unfinished
        check(process.poll() is None, f"the run ended by itself with {process.returncode}")
        time.sleep(0.005)
    process.kill()
    process.wait()
    check(False, "the outputs did not grow within 10 s")


def stopped_by(number, exit_status):
    def run(box):
        box.write("old.state", box_state(box))
        before = box.read("old.state")
        process, unfinished = running(
            box, "--motion", "m.json", "--post", "p.nc", "--plot", "p.svg", "--dprnt", "log",
            "--coverage", "c.csv", "--points", "t.csv", "--pulses", "u.vcd", "--rows", "r.csv",
            "--summary", "s.json", "--state", "old.state")
        check(len(unfinished) >= 9, f"unfinished files while it runs: {unfinished}")
        process.send_signal(number)
        begin = time.monotonic()
        process.wait(timeout=harness.TIMEOUT_S)
        check(time.monotonic() - begin < 5 * harness.PATIENCE, "it took too long to stop")
        check(process.returncode in (exit_status, -number),
              f"exit status {process.returncode}, wanted {exit_status}")
        equal(box.files(), ["old.nc", "old.state", "part.nc"], "files behind it")
        equal(box.read("old.state"), before, "the state")
    return run


def box_state(box):
    box.write("old.nc", "O1\n#500=42\nM30\n")
    status(box.kerf("run", "old.nc", "--state", "made.state"), 0)
    content = box.read("made.state")
    os.remove(box.path("made.state"))
    return content


for name, number in (("Ctrl-C", signal.SIGINT), ("SIGTERM", signal.SIGTERM),
                     ("a closed terminal", signal.SIGHUP)):
    test(f"{name} in the middle of a run leaves no file and no changed state")(
        stopped_by(number, 128 + number))


@test("Ctrl-C twice in a row does no harm")
def twice(box):
    process, _ = running(box, "--motion", "m.json")
    process.send_signal(signal.SIGINT)
    try:
        process.send_signal(signal.SIGINT)
    except ProcessLookupError:
        pass
    process.wait(timeout=20)
    check(process.returncode in (130, -signal.SIGINT), f"exit status {process.returncode}")
    equal(box.files(), ["part.nc"], "files behind it")


@test("a run under nohup goes on when the terminal closes")
def nohup(box):
    box.write("part.nc", "O1\nN1G04P1\nGOTO1\n")
    process = box.start("run", "part.nc", "--max-seconds", "1.5", "--motion", "m.json",
                        preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    time.sleep(0.3)
    process.send_signal(signal.SIGHUP)
    process.wait(timeout=20)
    equal(process.returncode, 5, "exit status of a run under nohup that got SIGHUP")
