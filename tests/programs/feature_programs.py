"""Programs whose features are known: those of tests/programs/features, as tests of Python need them."""

from pathlib import Path

FOLDER = Path(__file__).parent / "features"
FLATS = """[[tool]]
number = 1
type = "flat"
diameter = 10
[[tool]]
number = 2
type = "flat"
diameter = 6
"""


def program(name):
    return (FOLDER / name).read_text()


def blocks(first, last, text):
    """The blocks from one N word to another one, both included."""
    lines = text.splitlines(keepends=True)
    number = [int(line[1:].split()[0]) if line.startswith("N") else 0 for line in lines]
    return "".join(line for n, line in zip(number, lines) if first <= n <= last)


P1 = program("p1.nc")
# Two layers of two loops, a profile with four arcs, a circle, two plunges: without its head.
PART = blocks(10, 500, P1)
# A pocket of two layers and a hole.
POCKET = "O1\n" + blocks(20, 270, P1) + blocks(430, 460, P1) + blocks(500, 500, P1)
