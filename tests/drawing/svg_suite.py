#!/usr/bin/env python3
"""Draws our own SVG files by rsvg-convert, and by Kerf's reader and then rsvg-convert, and compares the pictures.

Of svg/fill_*.svg the regions are filled: what both pictures share is at least SHARED of what either has. Of
svg/stroke_*.svg the lines are drawn: no black pixel of either is farther than FARTHEST from one of the other.

usage: svg_suite.py --reader READ_SVG [--keep FOLDER] [NAME…]     exit 1 when a picture differs, 77 without rsvg-convert
"""

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SVG = Path(__file__).resolve().parent / "svg"
SHARED = 0.995
FARTHEST = 1.5  # a neighbour, also across
WIDTH = 400


def render(svg: Path, png: Path) -> None:
    command = ["rsvg-convert", "--width", str(WIDTH), "--keep-aspect-ratio", "--background-color", "white"]
    subprocess.run([*command, svg, "--output", png], check=True)


def compared(reader: str, file: Path, folder: Path) -> str:
    """What is wrong; empty: nothing."""
    kind = file.name.split("_")[0]
    ours = folder / (file.stem + ".ours.svg")
    subprocess.run([reader, "draw", file, ours, kind], check=True, stderr=subprocess.DEVNULL)
    pictures = [folder / (file.stem + ".png"), folder / (file.stem + ".ours.png")]
    for svg, png in zip([file, ours], pictures):
        render(svg, png)
    said = subprocess.run([reader, "compare", *pictures], capture_output=True, text=True, check=False).stdout
    figures = re.fullmatch(r"iou (\S+) farthest (\S+) black (\d+)\n", said)
    if not figures:
        return "the pictures are not of one size"
    if int(figures[3]) < 50:
        return "there is nothing in it"
    if kind == "fill" and float(figures[1]) < SHARED:
        return f"only {figures[1]} is shared"
    if kind == "stroke" and float(figures[2]) > FARTHEST:
        return f"lines are {figures[2]} pixels apart"
    return ""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--reader", required=True)
    parser.add_argument("--keep", help="folder where the pictures stay")
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    if not shutil.which("rsvg-convert"):
        print("rsvg-convert is not there")
        return 77
    files = [f for f in sorted(SVG.glob("*.svg")) if not arguments.names or f.stem in arguments.names]
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(2) as pool:
        folder = Path(arguments.keep or scratch)
        folder.mkdir(exist_ok=True)
        wrong = list(pool.map(lambda file: compared(arguments.reader, file, folder), files))
    for file, sentence in zip(files, wrong):
        if sentence:
            print(f"{file.name}: {sentence}")
    print(f"{len(files)} drawings, {sum(map(bool, wrong))} differ")
    return 1 if any(wrong) or not files else 0


if __name__ == "__main__":
    sys.exit(main())
