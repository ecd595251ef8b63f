"""kerf pattern: bytes and listings."""

import json
import os
import random

import harness
from harness import check, contains, equal, refused, status, test
from pattern_files import LISTING, WORKED, decoded, decoded_from


@test("a pattern is listed a record a line")
def listing(box):
    box.write("a.pat", WORKED)
    equal(decoded(box, "a.pat"), LISTING, "the listing")
    status(box.kerf("pattern", "decode", "a.pat", "--output", "a.txt"), 0)
    equal(box.read("a.txt").decode(), LISTING, "the file")


@test("a listing becomes the bytes that it came from")
def bytes_again(box):
    box.write("a.txt", LISTING)
    status(box.kerf("pattern", "encode", "a.txt", "--output", "a.pat"), 0)
    equal(box.read("a.pat"), WORKED, "the pattern")


@test("listing and pattern pass through standard input and output")
def pipes(box):
    equal(decoded_from(box, WORKED), LISTING, "the listing")
    result = box.kerf("pattern", "encode", "-", "--output", "-", stdin=LISTING)
    status(result, 0)
    equal(result.out, WORKED, "the pattern")


@test("the order of the bytes of a count can be chosen")
def byte_order(box):
    data = bytes.fromhex("1FE803 9FFFFF 9F7111")
    equal(decoded_from(box, data, "--byte-order", "little"), "F T1 1000\nF T1 -65535\nF T1 -4465\n",
          "little-endian")
    result = box.kerf("pattern", "encode", "-", "--output", "-", "--byte-order", "little",
                      stdin="F T1 1000\nF T1 -70000\n")
    equal(result.out, data, "encoded")


@test("a direction bit of a zero count is listed as -0 and comes back")
def minus_zero(box):
    data = bytes.fromhex("9F0000 1F0000 C080A0 400020")
    text = decoded_from(box, data)
    equal(text, "F T1 -0\nF T1 0\nS -0 -0 -0\nS 0 0 0\n", "the listing")
    equal(box.kerf("pattern", "encode", "-", "--output", "-", stdin=text).out, data, "encoded")


@test("moves beyond a field of a listing are split")
def split(box):
    text = "F Z 65536\nF T1 -70000\nS 4 61 -100\nS 70 5 5\n"
    result = box.kerf("pattern", "encode", "-", "--output", "-", stdin=text)
    equal(result.out, bytes.fromhex("7FFFFF 7F0001 9FFFFF 9F1171 440FB9 400FB9 400FB9 4010B9"
                                    "5E0020 5E0020 4A0525"), "the pattern")


@test("random bytes come back to the last bit through their listing")
def random_round_trip(box):
    dice = random.Random(4)
    data = bytearray()
    for _ in range(40000):
        if dice.random() < 0.3:
            data += bytes([dice.getrandbits(3) << 5 | 31, dice.getrandbits(8), dice.getrandbits(8)])
        else:
            data += bytes(dice.getrandbits(1) << 7 | axis << 5 | dice.randrange(31) for axis in (2, 0, 1))
    for order in ("big", "little"):
        box.write("a.pat", bytes(data))
        status(box.kerf("pattern", "decode", "a.pat", "--output", "a.txt", "--byte-order", order), 0)
        status(box.kerf("pattern", "encode", "a.txt", "--output", "b.pat", "--byte-order", order), 0)
        check(box.read("b.pat") == bytes(data), f"the bytes differ, {order}")


WRONG_BYTES = {
    "a record that breaks off": ("7F00C8 40", "PATTERN_TRUNCATED", 3),
    "a flag in the place of T1": ("7F00C8 401F20", "PATTERN_FIELD", 4),
    "a flag in the place of T2": ("40003F", "PATTERN_FIELD", 2),
    "another axis in the place of T3": ("000020", "PATTERN_AXIS", 0),
    "another axis in the place of T1": ("402020", "PATTERN_AXIS", 1),
    "another axis in the place of T2": ("7F00C8 400000", "PATTERN_AXIS", 5),
}


def wrong_bytes(data, code, offset):
    def run(box):
        box.write("a.pat", bytes.fromhex(data))
        for command in (["decode", "a.pat", "--output", "a.txt"],
                        ["replay", "a.pat", "--output", "b.pat", "--pulses", "p.csv"]):
            result = box.kerf("pattern", *command)
            status(result, 1)
            contains(result.err, f"a.pat:byte {offset}: error: {code} ", "standard error")
            equal(box.files(), ["a.pat"], "files behind it")
            result = box.kerf("pattern", *command, "--diagnostics", "json")
            status(result, 1)
            found = json.loads(result.err.splitlines()[0])
            equal((found["code"], found["offset"], found["file"]), (code, offset, "a.pat"), "as JSON")
    return run


for name, (data, code, offset) in WRONG_BYTES.items():
    test(f"a wrong pattern tells the byte: {name}")(wrong_bytes(data, code, offset))


@test("--lenient does not look at the axes of triplets")
def lenient(box):
    equal(decoded_from(box, bytes.fromhex("0364E5"), "--lenient"), "S 3 4 -5\n", "the listing")
    box.write("a.pat", bytes.fromhex("0364E5"))
    result = box.kerf("pattern", "replay", "a.pat", "--lenient", "--byte-order", "little", "--summary", "-")
    status(result, 0)
    equal(json.loads(result.text)["counters"], {"T1": 4, "T2": -5, "T3": 3, "Z": 0}, "counters")


@test("a wrong listing tells line and column, and no pattern is written")
def wrong_listing(box):
    box.write("a.txt", "F Z 5\n\nS 1 x 3 # here\n")
    result = box.kerf("pattern", "encode", "a.txt", "--output", "a.pat")
    status(result, 1)
    contains(result.err, "a.txt:3:5: error: PATTERN_TEXT ", "standard error")
    contains(result.err, "    S 1 x 3 # here\n        ^\n", "the source line")
    equal(box.files(), ["a.txt"], "files behind it")
    result = box.kerf("pattern", "encode", "-", "--output", "-", "--diagnostics", "json",
                      stdin="F Z 5\nF Y 1\n")
    found = json.loads(result.err)
    equal((found["code"], found["line"], found["column"]), ("PATTERN_TEXT", 2, 3), "as JSON")
    equal(result.out, b"", "standard output")


@test("an empty pattern is one")
def empty(box):
    equal(decoded_from(box, b""), "", "the listing")
    result = box.kerf("pattern", "encode", "-", "--output", "a.pat", stdin="# nothing\n\n")
    status(result, 0)
    equal(box.read("a.pat"), b"", "the pattern")
    result = box.kerf("pattern", "replay", "a.pat", "--summary", "-", "--points", "p.csv")
    status(result, 0)
    summary = json.loads(result.text)
    equal((summary["status"], summary["pattern"]["records"], summary["time_s"]), ("end", 0, 0), "the summary")
    equal(len(box.read("p.csv").splitlines()), 1, "lines of set-points")


@test("a file that is missing or cannot be written is said in one sentence")
def missing(box):
    for command in (["decode", "no.pat"], ["encode", "no.txt", "--output", "a"], ["replay", "no.pat"]):
        refused(box.kerf("pattern", *command), 3, command[1])
    box.write("a.pat", WORKED)
    box.write("a.txt", LISTING)
    refused(box.kerf("pattern", "decode", "a.pat", "--output", "no/a.txt"), 3, "no/a.txt")
    refused(box.kerf("pattern", "encode", "a.txt", "--output", "no/a.pat"), 3, "no/a.pat")
    refused(box.kerf("pattern", "replay", "a.pat", "--motion", "no/m.jsonl"), 3, "no/m.jsonl")
    refused(box.kerf("pattern", "decode", "."), 3)


@test("a pattern of 30 MB needs no more memory than a short one")
def huge(box):
    with open(box.path("a.pat"), "wb") as file:
        for _ in range(100):
            file.write(bytes.fromhex("400C27 40 8C A7") * 50000)
    result = box.kerf("pattern", "decode", "a.pat", "--output", "a.txt", peak=True)
    status(result, 0)
    equal(os.path.getsize(box.path("a.txt")), 5000000 * (len("S 0 12 7\n") + len("S 0 -12 -7\n")), "bytes")
    again = box.kerf("pattern", "encode", "a.txt", "--output", "b.pat", peak=True)
    status(again, 0)
    equal(os.path.getsize(box.path("b.pat")), 30000000, "bytes of the pattern")
    if harness.MEASURES_MEMORY:
        check(0 < result.peak_kib < 16 * 1024, f"{result.peak_kib} KiB of memory")
        check(0 < again.peak_kib < 16 * 1024, f"{again.peak_kib} KiB of memory")
