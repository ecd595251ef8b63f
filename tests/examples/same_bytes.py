#!/usr/bin/env python3
"""Runs every example with all outputs twice and holds the bytes against each other: as it is, and as on a processor
without fused multiplication and AVX, for which the C library has other code.

usage: same_bytes.py --kerf PATH [--other PATH] [--without-png] [NAME ...]

--other: the second run is by that program (another compiler, another C library, another processor under an emulator),
without the switches. --without-png: cairo draws those, and on another processor it shades a pixel by 1 of 255
otherwise. NAME: only examples whose folder begins so.

Exit status: 0 all the same, 1 something differs, 2 wrong usage.
"""

import argparse
import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLAIN_PROCESSOR = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX,-AVX512F,-SSE4_1,-SSE4_2"}
EVERYWHERE = ("--summary summary.json", "--motion motion.jsonl", "--points points.csv", "--rows rows.csv",
              "--plot path.svg", "--coverage coverage.txt", "--dprnt printed.txt")
SOMEWHERE = ("--plot path.png", "--plot speed.svg --plot-speed", "--plot energy.svg --plot-energy", "--post post.nc",
             "--teach taught.tch", "--pulses pulses.csv", "--pulses pulses.vcd", "--pwm pwm.csv",
             "--pattern pattern.pat", "--pattern pattern.pat --pattern-plot wheel.svg")
WITHOUT_VALUE = ("--plot-speed", "--plot-energy", "--optional-stop")
USAGE = 2
SECONDS = 1500  # an emulator takes its time


def inputs_of(words: list[str]) -> list[str]:
    """The words of an example's command but for what it writes."""
    written = {option.split()[0] for option in EVERYWHERE + SOMEWHERE}
    kept = [str(ROOT / words[2])]
    at = 3
    while at < len(words):
        width = 1 if words[at] in WITHOUT_VALUE else 2
        if words[at] not in written and words[at] not in WITHOUT_VALUE:
            kept += [str(ROOT / word) if (ROOT / word).is_file() else word for word in words[at : at + width]]
        at += width
    return kept


def run(kerf: str, words: list[str], environment: dict) -> dict:
    """Name of each thing that came out: its bytes."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([*shlex.split(kerf), "run", *words, "--max-seconds", "0"], cwd=folder,
                              env={**os.environ, **environment},
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS, check=False)
        found = {path.name: path.read_bytes() for path in Path(folder).iterdir()}
    return {"exit status": str(done.returncode).encode(), "standard output": done.stdout,
            "standard error": done.stderr, **found}


def is_taken(kerf: str, inputs: list[str], option: str) -> bool:
    """Whether this machine has that output."""
    words = [*inputs, "--max-motions", "1", *option.split()]
    return run(kerf, words, {})["exit status"] != str(USAGE).encode()


def runs_of(kerf: str, inputs: list[str], without_png: bool) -> list[list[str]]:
    """Options of as few runs as there can be, for none may be there twice: what every machine has, and what this one has."""
    taken = [option for option in SOMEWHERE if is_taken(kerf, inputs, option)]
    runs: list[list[str]] = []
    for option in (*EVERYWHERE, *taken):
        words = option.split()
        if without_png and words[-1].endswith(".png"):
            continue
        with_room = [run for run in runs if words[0] not in run]
        if with_room:
            with_room[0].extend(words)
        else:
            runs.append(words)
    return runs


def differences(first: dict, second: dict) -> list[str]:
    return [name for name in sorted(first.keys() | second.keys()) if first.get(name) != second.get(name)]


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--kerf", required=True)
    parser.add_argument("--other")
    parser.add_argument("--without-png", action="store_true")
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    kerf = str(Path(arguments.kerf).resolve())
    other, environment = (arguments.other, {}) if arguments.other else (kerf, PLAIN_PROCESSOR)
    outputs = different = 0
    for command in sorted((ROOT / "examples").glob("*/command*")):
        if arguments.names and not any(command.parent.name.startswith(name) for name in arguments.names):
            continue
        words = shlex.split(command.read_text())
        inputs = inputs_of(words)
        for options in runs_of(kerf, inputs, arguments.without_png):
            ours = run(kerf, [*inputs, *options], {})
            if ours["exit status"] == str(USAGE).encode():
                if words[1] != "run":  # it has options that `kerf run` does not have
                    break
                sys.exit(f"{command.relative_to(ROOT)}: {ours['standard error'].decode()}")
            outputs += len(ours)
            for name in differences(ours, run(other, [*inputs, *options], environment)):
                different += 1
                print(f"{command.relative_to(ROOT)}: {name} differs ({' '.join(options)})")
    print(f"{outputs} outputs, {different} differ")
    return 1 if different or not outputs else 0


if __name__ == "__main__":
    sys.exit(main())
