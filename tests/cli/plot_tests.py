"""--plot-speed and --plot-energy: pictures whose colours are the speeds that were reached, and what a
laser left on each millimetre."""

import re
import xml.etree.ElementTree as xml
from pathlib import Path

from harness import check, contains, equal, near, refused, status, test
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


BURN = "#d62728"
SQUARE = ("speed(100)\npower(80)\nmove(0,0)\nline(20,0)\nline(20,20)\nline(0,20)\nline(0,0)\n"
          "end\n")


@test("--plot-energy counts what burns where the beam rests, in G-code, taught points and laser BASIC")
def energy_of_holes(box):
    programs = {"a.nc": "G21G90\nM03S500\nG00X10.\nG01\nG04P500\nG00X20.\nM30\n",
                "a.tch": "TEACH 1\nPOINT 0 0 0 0 0\nFEED 600\nLASER ON 50\nDWELL 0.5\nLASER OFF\nLINE 10 0 0 0 0\nEND\n",
                "a.bas": "power(50)\nmove(10,10)\nburn(0.5)\nmove(0,0)\n"}
    for name, program in programs.items():
        box.write(name, program)
        result = box.kerf("run", name, "--machine", "laser5" if name == "a.tch" else "laser3", "--plot", "e.svg",
                          "--plot-energy", "--summary", "s.json", "--machine-set", "drive.max_power_w=60",
                          "--machine-set", "drive.spot_mm=0.1", "--machine-set", "interpolator.period_ms=1")
        status(result, 0)
        contains(result.err, "energy of the beam: 15 J", name)
        energy = box.json("s.json")["energy"]
        near(energy["total_j"], 15, 0.04, f"energy of {name}")  # a period more or less of 60 W at 50 %
        near(energy["most_j_mm"], 150, 0.4, f"energy of a spot of {name}")


@test("--plot-energy marks the corners of a square as burns, and says the most energy and its line")
def energy_of_corners(box):
    box.write("part.bas", SQUARE)
    stop = ["--machine-set", "interpolator.tolerance=0"]
    result = box.kerf("run", "part.bas", "--plot", "energy.svg", "--plot-energy", *stop)
    status(result, 0)
    contains(result.err, "energy of the cuts: median 0.48 J/mm", "the summary")  # 60 W 0.8 / 100 mm/s
    most = float(re.search(r"most ([\d.]+) J/mm at line [4567]\n", result.err)[1])
    # From rest at 3000 mm/s2 a spot of 0.1 mm takes 8.2 ms: 3.9 J/mm; braking is in it besides.
    check(3.5 < most < 8, f"the most is {most} J/mm")
    burns = shapes(box, "energy.svg", BURN)
    check(burns and max(map(widest, burns)) < 40, "burns are short places at the corners")
    svg = box.read("energy.svg").decode()
    contains(svg, "Energy of the cuts, J/mm", "the legend")
    contains(svg, "red: burns, more than 0.96", "the legend")


@test("--plot-energy has the energy of the speed reached where nothing slows the beam down")
def energy_of_constant_feed(box):
    box.write("part.bas", SQUARE.replace("speed(100)", "speed(40)"))
    for name in ("one.svg", "two.svg"):
        result = box.kerf("run", "part.bas", "--plot", name, "--plot-energy", "--machine-set",
                          "interpolator.mode=equal")
        status(result, 0)
        contains(result.err, "median 1.2 J/mm, most 1.2 J/mm", "the summary")  # 48 W / 40 mm/s
    equal(shapes(box, "one.svg", BURN), [], "burns")
    equal(box.read("one.svg"), box.read("two.svg"), "the second picture")


@test("drive.burn_j_mm says from where a cut burns")
def burn_key(box):
    box.write("part.bas", SQUARE)
    result = box.kerf("run", "part.bas", "--plot", "energy.svg", "--plot-energy", "--machine-set",
                      "drive.burn_j_mm=0.4")
    status(result, 0)
    burns = shapes(box, "energy.svg", BURN)
    check(max(map(widest, burns)) > 100, "the sides do not burn")
    contains(box.read("energy.svg").decode(), "red: burns, more than 0.4", "the legend")


@test("--plot-energy is refused without --plot, without a laser and beside --plot-speed")
def energy_usage(box):
    box.write("part.bas", SQUARE)
    refused(box.kerf("run", "part.bas", "--plot-energy"), 2, "--plot-energy", "--plot FILE")
    refused(box.kerf("run", "part.bas", "--plot", "a.svg", "--plot-energy", "--machine", "mill3"), 2,
            "--plot-energy", "mill3", "laser")
    refused(box.kerf("run", "part.bas", "--plot", "a.svg", "--plot-energy", "--plot-speed"), 2,
            "--plot-energy", "--plot-speed")
    equal(box.files(), ["part.bas"], "files")


@test("--plot-energy of a run whose beam is never on shows no cut")
def no_beam(box):
    box.write("part.nc", HEAD + "G01X100.F6000\nM30\n")
    result = box.kerf("run", "part.nc", "--machine", "laser3", "--plot", "a.png", "--plot-energy")
    status(result, 0)
    check("energy" not in result.err, "the summary tells of an energy")


@test("the half section of the documents is the one that their command draws")
def half_section(box):
    images = Path(__file__).resolve().parents[2] / "docs" / "images" / "lathe"
    box.write("shaft.nc", (images / "shaft.nc").read_bytes())
    status(box.kerf("run", "shaft.nc", "--machine", "lathe2", "--plot", "shaft.svg"), 0)
    equal(box.read("shaft.svg"), (images / "shaft.svg").read_bytes(), "shaft.svg")


@test("a lathe is drawn as a half section by its axis X, not by its name, also coloured by speeds")
def lathes_by_their_axes(box):
    box.write("part.nc", "O1\nG98\nG00X40.Z5.\nG01Z-20.F100\nM30\n")
    box.write("own.toml", box.kerf("machines", "lathe2").text.replace('name = "lathe2"', 'name = "own"', 1))
    for words in (["--machine", "own.toml"], ["--machine", "lathe3c"], ["--machine", "lathe2", "--plot-speed"]):
        status(box.kerf("run", "part.nc", *words, "--plot", "a.svg"), 0)
        contains(box.read("a.svg").decode(), "Half section", f"the picture of {words}")
    box.write("own.toml", box.kerf("machines", "lathe2").text.replace("diameter = true", ""))
    status(box.kerf("run", "part.nc", "--machine", "own.toml", "--plot", "a.svg"), 0)
    check("Half section" not in box.read("a.svg").decode(), "X is no diameter there")
