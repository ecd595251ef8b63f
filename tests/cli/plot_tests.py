"""--plot-speed: pictures whose colours are the speeds that were reached."""

import re
import xml.etree.ElementTree as xml

from harness import check, contains, equal, refused, status, test
from limit_tests import bounded, fill

HEAD = "O1\nG21G90G17G94\n"
SLOWEST, FASTEST = "#440154", "#7ad151"


def shapes(box, name, color):
    """The paths of an SVG that have this colour."""
    return [path.get("d") for path in xml.fromstring(box.read(name)).iter()
            if path.tag.endswith("path") and path.get("stroke") == color]


def widest(data):
    """The longest line of a path along X, pixels."""
    numbers = [re.findall(r"-?(?:\d+\.?\d*|\.\d+)", lines) for lines in re.findall("l([^a-z]*)", data)]
    return max(abs(float(x)) for line in numbers for x in line[0::2])


@test("--plot-speed colours a cut by the speed reached: full feed in the middle, slow at the ends")
def colours(box):
    box.write("part.nc", HEAD + "G00Z5.\nG01X100.F6000\nM30\n")
    status(box.kerf("run", "part.nc", "--plot", "speed.svg", "--plot-speed"), 0)
    fast, slow = shapes(box, "speed.svg", FASTEST), shapes(box, "speed.svg", SLOWEST)
    equal(len(fast), 2, "shapes at full feed, one a view")
    check(len(slow) >= 2, f"{len(slow)} shapes at rest, wanted one a view at least")
    # 100 mm/s and 3000 mm/s²: ramps of 1.7 mm; in the view from above 100 mm are over 500 pixels.
    check(max(map(widest, fast)) > 400, "the middle is not at full feed")
    check(max(map(widest, slow)) < 10, "much of the line is at rest")
    contains(box.read("speed.svg").decode(), "fastest cut 6000", "the legend")


@test("the colours of --plot-speed follow the machine's acceleration, not the programmed feed")
def acceleration(box):
    box.write("part.nc", HEAD + "G00Z5.\nG01X100.F6000\nM30\n")
    slow = ["--machine-set", "axis.X.acceleration=10"]  # 31.6 mm/s in the middle
    status(box.kerf("run", "part.nc", "--plot", "slow.svg", "--plot-speed", *slow), 0)
    contains(box.read("slow.svg").decode(), "fastest cut 1897", "the legend")


@test("--plot-speed draws any machine, as SVG and PNG, the same each time")
def machines(box):
    programs = {"mill4": "G00Z5.\nG01X50.A30.F600\nG02X70.Y20.R20.\n",
                "mill5": "G00Z5.\nG01X50.A30.F600\nA60.\nG02X70.Y20.R20.\n",
                "laser5": "G01X50.A30.F3000\nX0A0\n",
                "arm4": "G00X200.Y100.\nG01X150.Y200.F200\nG03X-50.R150.\n",
                "laser-xtz": "G01X40.F200\nZ5.\n"}
    for machine, moves in programs.items():
        box.write("part.nc", HEAD + moves + "M30\n")
        files = [f"{machine}.svg", f"{machine}-again.svg", f"{machine}.png"]
        for name in files:
            status(box.kerf("run", "part.nc", "--machine", machine, "--plot", name,
                            "--plot-speed"), 0)
        equal(box.read(files[0]), box.read(files[1]), f"the second picture of {machine}")
        contains(box.read(files[0]).decode(), "fastest cut", f"the picture of {machine}")
        equal(box.read(files[2])[:4], b"\x89PNG", f"the beginning of the PNG of {machine}")


@test("--plot-speed shows how far a run came that ends in an alarm")
def alarm_on_the_way(box):
    box.write("part.nc", HEAD + "G01X100.F6000\nG01X[1/0]\nM30\n")
    status(box.kerf("run", "part.nc", "--plot", "speed.svg", "--plot-speed"), 1)
    equal(len(shapes(box, "speed.svg", FASTEST)), 2, "shapes at full feed, one a view")


@test("--plot-speed without --plot is refused")
def needs_plot(box):
    box.write("part.nc", HEAD + "M30\n")
    refused(box.kerf("run", "part.nc", "--plot-speed"), 2, "--plot-speed", "--plot FILE")
    equal(box.files(), ["part.nc"], "files")


@test("--plot-speed of an hour of machine time needs no more memory than a minute")
def an_hour(box):
    for passes in (500, 30_000):  # 0.12 s each, all different
        fill(box, "part.nc", HEAD.encode() + b"G01F6000G91\n", b"X9.9Y.01\nX-9.9\n", passes // 2,
             b"M30\n")
        result = box.kerf("run", "part.nc", "--plot", "speed.svg", "--plot-speed", peak=True)
        status(result, 0)
        bounded(result, 48)
        check(len(box.read("speed.svg")) < 2_000_000, "the picture is larger than 2 MB")
