"""kerf run --post: arcs of posted programs, also those that their digits cannot say."""

import math
import re

from harness import check, near, status, test
from post_tests import HEAD, TOLERANCE, post_and_run, posted


@test("an arc whose centre is too far away to be written is posted as chords, or as the line that it is")
def far_centre(box):
    for radius, way, direction in ((120000, 60, 1), (120000, 60, -1), (5e6, 300, 1), (1e9, 300, -1), (1e12, 0.002, 1)):
        box.write("part.bas", f"power(50)\nmove(10,0)\narc({10 + way},0,{radius},{direction})\n")
        status(box.kerf("run", "part.bas", "--post", "post.nc"), 0)
        code = box.read("post.nc").decode()
        check(not re.search(r"e\+|\bG[23]\b", code), f"R{radius}: {code}")
        ends = [(10 + way, 0) if "Y" not in line else tuple(map(float, re.findall(r"[XY](\S+)", line)))
                for line in code.splitlines() if line.startswith(("G1 ", "X"))]
        near(ends[-1][0], 10 + way, 1e-4, f"R{radius}: the end")
        for x, y in ends:
            u = x - 10 - way / 2
            wanted = -direction * ((way / 2) ** 2 - u ** 2) / (2 * radius)
            near(y, wanted, 1e-4, f"R{radius}: Y at X{x}")
        rise = way * way / (8 * radius)
        check((len(ends) > 1) == (rise > 0.001), f"R{radius}: {len(ends)} chords for a rise of {rise}")


def swept(records):
    """Length of all arcs, from their own records."""
    at, total = None, 0
    for record in records:
        if record["kind"] == "arc":
            u, v = record["center"]
            a = math.atan2(at["Y"] - v, at["X"] - u)
            b = math.atan2(record["to"]["Y"] - v, record["to"]["X"] - u)
            turn = (b - a) if record["direction"] == "ccw" else (a - b)
            same = (at["X"], at["Y"]) == (record["to"]["X"], record["to"]["Y"])
            turn = 2 * math.pi if same else turn % (2 * math.pi)
            total += turn * math.hypot(at["X"] - u, at["Y"] - v)
        at = record.get("to", at)
    return total


@test("a posted arc that is shorter than a digit of the output does not become a full circle")
def tiny_arc(box):
    first, second = post_and_run(
        box, HEAD + "G00X10.Y0\nG51X0Y0P10\nG01X10.Y0F100\nG03X10.Y.001I-10.J0\nG50\nM30\n")
    near(swept(second), swept(first), TOLERANCE, "length of all arcs")


@test("a posted circle that ends a digit of the output beside its start stays a whole turn")
def nearly_full(box):
    first, second = post_and_run(
        box, HEAD + "G00X10.Y0\nG51X0Y0P10\nG01X10.Y0F100\nG02X10.Y.001I-10.J0\nG50\nM30\n")
    near(swept(second), swept(first), TOLERANCE, "length of all arcs")


@test("an arc whose radius changes is posted as chords, and F comes again with a plane")
def spiral(box):
    box.write("part.nc", HEAD + "G0X10.Y0\nG2X0Y-10.008I-10.J0F300\nG18G3X5.Z0I2.5\nM30\n")
    blocks = posted(box, "part.nc")
    chords = blocks[blocks.index("G18") - 1:0:-1]
    check(len(chords) > 30 and not any(line.startswith("G2") for line in blocks), str(blocks))
    x, y = 10.0, 0.0
    for block in blocks[3:blocks.index("G18")]:
        x = float((re.search(r"X(\S+)", block) or [0, x])[1])
        y = float((re.search(r"Y(\S+)", block) or [0, y])[1])
        share = (math.atan2(-y, x) % (2 * math.pi)) / (math.pi / 2)
        near(math.hypot(x, y), 10 + 0.008 * share, 2e-4, f"radius at {x} {y}")
    check(blocks[blocks.index("G18") + 1].endswith("F300."), "no F behind G18")
    box.write("part.nc", HEAD + "G0X10.Y0\nG2X0Y-10.0004I-10.J0F300\nM30\n")
    check(any(line.startswith("G2") for line in posted(box, "part.nc")), "chords for less than the tolerance")
