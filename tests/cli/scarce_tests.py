"""`kerf stock` on a computer that gives little: no thread beside the first one, and half of the memory taken by the design."""

import os
import struct
import sys

from compare_tests import FACE, HEAD, STOCK, TAIL, codes, faced, stl
from harness import Skipped, equal, near, refused, status, test

# Denies what makes a thread (EAGAIN, as where a limit is reached) and becomes the words behind: struct sock_filter for
# clone3() and, of clone(), what has CLONE_VM and not CLONE_VFORK.
ALONE = """
import ctypes, os, struct, sys
libc = ctypes.CDLL(None, use_errno=True)
clone = {"x86_64": 56, "aarch64": 220}[os.uname().machine]
steps = ((0x20, 0, 0, 0), (0x15, 1, 0, 435), (0x15, 0, 1, clone), (0x06, 0, 0, 0x00050000 | 11), (0x06, 0, 0, 0x7FFF0000))
code = ctypes.create_string_buffer(b"".join(struct.pack("HBBI", *step) for step in steps))
program = struct.pack("HxxxxxxP", len(steps), ctypes.addressof(code))
if libc.prctl(38, 1, 0, 0, 0) or libc.prctl(22, 2, program, 0, 0): sys.exit(77)
os.execvp(sys.argv[1], sys.argv[1:])
"""


def alone(*words):
    return (sys.executable, "-I", "-S", "-c", ALONE, *words)


@test("scarce: where the computer gives no threads a part is cut, compared and drawn as with them, to the last byte")
def no_threads(box):
    if os.uname().machine not in ("x86_64", "aarch64"):
        raise Skipped("no filter for this processor")
    box.write("part.nc", HEAD + faced("1.2") + TAIL)
    box.write("tools.toml", FACE)
    box.write("design.stl", stl(((0, 0, -20), (40, 30, -1))))
    for model in ("zmap", "tridexel"):
        words = ("stock", "part.nc", "--machine", "mill3", "--stock", STOCK, "--tools", "tools.toml", "--cell", "1", "--design",
                 "design.stl", "--model", model, "--jobs", "4")
        outputs = ("--report", "--save", "--stl", "--picture")
        names = ("r.json", "s.kstock", "m.stl", "p.png")
        status(box.kerf(*words, *(w for pair in zip(outputs, names) for w in pair)), 1)
        wanted = [box.read(name) for name in names]
        result = box.kerf(*words, *(w for pair in zip(outputs, names) for w in pair), before=alone())
        if result.status == 77:
            raise Skipped("this computer lets nobody filter what is asked of it")
        status(result, 1)
        equal([box.read(name) for name in names] == wanted, True, model)


def fine_plate(parts):
    """The block of faced("1."), its top divided into squares; binary."""
    at = [[(40 * i / parts, 30 * j / parts) for j in range(parts + 1)] for i in range(parts + 1)]
    top, bottom = -1, -20
    triangles = []
    for i in range(parts):
        for j in range(parts):
            a, b, c, d = ((*at[k][m], top) for k, m in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            triangles += [(a, b, c), (a, c, d)]
    rim = [at[k][0] for k in range(parts)] + [at[parts][k] for k in range(parts)]
    rim += [at[parts - k][parts] for k in range(parts)] + [at[0][parts - k] for k in range(parts)]
    for p, q in zip(rim, rim[1:] + rim[:1]):
        triangles += [((*p, bottom), (*q, bottom), (*q, top)), ((*p, bottom), (*q, top), (*p, top)),
                      ((*q, bottom), (*p, bottom), (20, 15, bottom))]
    facets = (struct.pack("<12fH", 0, 0, 0, *a, *b, *c, 0) for a, b, c in triangles)
    return b"\0" * 80 + struct.pack("<I", len(triangles)) + b"".join(facets)


@test("scarce: a design counts in the memory: one that takes half of it leaves the other half to the part, a larger one is refused")
def half_for_the_design(box):
    box.write("part.nc", HEAD + faced("1.2") + TAIL)
    box.write("tools.toml", FACE)
    box.write("fine.stl", fine_plate(60))
    box.write("finer.stl", fine_plate(90))
    words = ("stock", "part.nc", "--machine", "mill3", "--stock", STOCK, "--tools", "tools.toml", "--cell", "0.125", "--memory", "1",
             "--report", "r.json")
    status(box.kerf(*words), 0)
    equal(box.json("r.json")["model"]["cells"], [320, 240], "there is room for the part")
    status(box.kerf(*words, "--design", "fine.stl"), 1)
    report = box.json("r.json")
    equal(sorted(codes(report)), ["CELL_ENLARGED", "GOUGE"], "told")
    near(report["model"]["bytes"] / (1 << 20), 0.45, 0.1, "half of the memory")
    near(report["compare"]["gouge"]["max_mm"], 0.2, 1e-4, "and it is compared as with small cells")
    near(report["compare"]["gouge"]["volume_mm3"], 240, 0.5, "volume")
    refused(box.kerf(*words, "--design", "finer.stl"), 3, "finer.stl", "17280 triangles")
