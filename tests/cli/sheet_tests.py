"""`kerf stock` of sheets under a laser: what is cut, what falls out, how much energy it got."""

import json

from harness import check, contains, equal, near, refused, status, test

SQUARE = "O1\nG90G54\nG00X0Y0\nM03S1000\nG01X20.F1500\nY20.\nX0\nY0\nM05\nM30\n"
LINE = "O1\nG90G54\nG00X-20.\nM03S800\nG01X20.F6000\nM05\nM30\n"


def cut(box, program, *words, exit_status=0, machine="laser3"):
    box.write("part.nc", program)
    result = box.kerf("stock", "part.nc", "--machine", machine, "--decimal-point", "calculator",
                      "--report", "report.json", *words)
    status(result, exit_status)
    return json.loads(box.read("report.json"))


@test("kerf stock cuts a sheet under a laser: its kerf, and the piece that falls out")
def square(box):
    report = cut(box, SQUARE, "--stock", "sheet:-10,-10,30,30,2", "--kerf", "0.2")
    sheet = report["sheet"]
    near(sheet["cut_mm2"], 15.9914159, 0.16, "area of the cut")
    near(sheet["cut_mm"], 80, 1e-6, "way of the beam")
    near(sheet["pieces"][1]["area_mm2"], 392.04, 0.2, "the piece")
    equal([piece["held"] for piece in sheet["pieces"]], [True, False], "held")
    equal(report["model"]["kind"], "sheet", "model")
    near(report["removed_mm3"], 2 * sheet["cut_mm2"], 1e-6, "2 mm thick")
    equal(report["stock"]["extents"]["Z"], [-2, 0], "the sheet's top is at Z0")
    contains(report["assumed"][0]["what"], "cuts through", "assumed")


@test("a sheet gets the energy of each period of the servo: 60 W at 80 % and 100 mm/s leave 0.48 J/mm")
def energy(box):
    report = cut(box, LINE, "--stock", "sheet:-30,-1.0125,30,1.0125,1", "--cell", "0.025")
    # 100 mm/s from rest with 3000 mm/s² take 1/30 s each way: 2 * 5/3 mm twice as long as at speed.
    seconds = 40 / 100 + 100 / 3000
    near(report["sheet"]["energy_j"], 48 * seconds, 0.1, "with constant power")
    check(report["sheet"]["peak_j_mm2"] > 6.11, "corners and ends get more than the cut at speed")
    even = cut(box, LINE.replace("M03", "M04"), "--stock", "sheet:-30,-1.0125,30,1.0125,1", "--cell",
               "0.025")
    near(even["sheet"]["energy_j"], 0.48 * 40, 0.02, "with power that follows the speed")


@test("a sheet lies around what the beam cuts, five millimetres wider, unless it is said")
def around(box):
    report = cut(box, "O1\nG90G54\nG00X-50.\nG01X0F1000\nM03S500\nX10.\nY20.\nM30\n")
    equal(report["stock"]["extents"]["X"], [-5, 15], "X")
    equal(report["stock"]["extents"]["Y"], [-5, 25], "Y")
    contains(report["assumed"][0]["what"], "around what is cut", "assumed")
    near(report["sheet"]["kerf_mm"], 0.1, 1e-12, "the spot")


@test("the kerf is what the command line, the file of tools or the machine says, in this order")
def kerf(box):
    box.write("tools.toml", "[beam]\nkerf = 0.3\n")
    words = ["--stock", "sheet:-10,-10,30,30,2", "--machine-set", "beam.kerf=0.4"]
    near(cut(box, SQUARE, *words)["sheet"]["kerf_mm"], 0.4, 1e-12, "machine")
    words += ["--tools", "tools.toml"]
    near(cut(box, SQUARE, *words)["sheet"]["kerf_mm"], 0.3, 1e-12, "tools")
    near(cut(box, SQUARE, *words, "--kerf", "0.5")["sheet"]["kerf_mm"], 0.5, 1e-12, "option")
    box.write("tools.toml", "[beam]\nkerf = -1\n")
    refused(box.kerf("stock", "part.nc", "--machine", "laser3", *words), 3, "tools.toml:2", "kerf")


@test("a sheet without a laser is wrong usage, and so is another stock under one")
def usage(box):
    box.write("part.nc", SQUARE)
    sheet = "sheet:-10,-10,30,30,2"
    for words in (["--machine", "mill3", "--stock", sheet], ["--machine", "mill3", "--kerf", "0.2"],
                  ["--machine", "laser3", "--stock", "box:0,0,-1,2,2,0"],
                  ["--machine", "laser3", "--stock", "bar:20,-10,0"],
                  ["--machine", "laser3", "--stock", sheet, "--model", "zmap"],
                  ["--machine", "laser3", "--stock", sheet, "--kerf", "0"]):
        refused(box.kerf("stock", "part.nc", *words), 2, words[-2])


@test("a beam beside the sheet is told, and so are cells that the memory does not hold")
def findings(box):
    missed = cut(box, SQUARE, "--stock", "sheet:100,100,130,130,2", exit_status=1)
    equal(list(missed["counts"]), ["STOCK_MISSED"], "beside the sheet")
    large = cut(box, SQUARE, "--stock", "sheet:-1000,-1000,1000,1000,2", "--kerf", "0.2", "--cell",
                "0.002", "--memory", "8", exit_status=1)
    equal(list(large["counts"]), ["CELL_ENLARGED"], "a small memory")
    check(large["model"]["bytes"] <= 8 << 20, "the memory is kept to")
    near(large["sheet"]["cut_mm2"], 15.9914159, 0.16, "with larger cells")


@test("a sheet does not depend on the number of threads")
def threads(box):
    reports = [cut(box, SQUARE, "--kerf", "0.2", "--jobs", jobs) for jobs in ("1", "2", "7")]
    equal(reports[1], reports[0], "two threads")
    equal(reports[2], reports[0], "seven threads")


@test("a hole that is pierced where the beam stands is a disc of the kerf's width")
def pierced(box):
    report = cut(box, "O1\nG90G54\nG00X5.Y5.\nM03S500\nG01\nG04P500\nM05\nM30\n", "--stock",
                 "sheet:0,0,10,10,1", "--kerf", "1", "--cell", "0.05")
    near(report["sheet"]["cut_mm2"], 0.785398163, 0.002, "disc")
    near(report["sheet"]["energy_j"], 15, 0.2, "half a second at 50 %")
    equal(report["sheet"]["cut_mm"], 0, "no way")
