"""Patterns of the arm and their listings, as several tests write and read them."""

import math

from harness import equal, status

WORKED = bytes.fromhex("7F00C8 3F0FA0 400CA7 FF00C8")
LISTING = "F Z 200\nF T2 4000\nS 0 12 -7\nF Z -200\n"
HEAD = "O1\nG21G90G17\n"
CIRCLE = HEAD + "G00Z5.\nX175.Y60.\nG01Z-.1F60.\nG03I-25.F78.\nG00Z5.\nM30\n"
AXES = ("T1", "T2", "T3", "Z")
STEP = (1 / 200, 1 / 200, 0.75, 1 / 100)


def records_of(text):
    return [line.split() for line in text.splitlines()]


def decoded(box, name, *words):
    result = box.kerf("pattern", "decode", name, *words)
    status(result, 0)
    equal(result.err, "", "standard error")
    return result.text


def decoded_from(box, data, *words):
    result = box.kerf("pattern", "decode", "-", *words, stdin=data)
    status(result, 0)
    return result.text


def forward(t1, t2):
    a, b = math.radians(t2), math.radians(t1 + t2)
    return 132 * (math.cos(a) + math.cos(b)), 132 * (math.sin(a) + math.sin(b))


def listed_as(box, text, more=b""):
    """Writes a.pat: the records of a listing, and bytes behind them."""
    result = box.kerf("pattern", "encode", "-", "--output", "-", stdin=text)
    status(result, 0)
    box.write("a.pat", result.out + more)
