"""G31 and the stock: where probes stop, what a run and a check on a table say."""

from harness import contains, equal, near, refused, status, test

TOOLS = '[[tool]]\nnumber = 1\ntype = "flat"\ndiameter = 10\n[[tool]]\nnumber = 10\ntype = "probe"\ndiameter = 6\n'
BOX = "box:0,0,-20,70,40,0"


def probed(box, moves, *words, wanted=0, machine="mill3", stock=BOX, tool="T10M06\n"):
    """Summary of a program of these moves."""
    box.write("tools.toml", TOOLS)
    box.write("p.nc", "O1\n" + tool + "G90G54\n" + moves + "\nM30\n")
    table = ("--stock", stock) if stock else ()
    result = box.kerf("run", "p.nc", "--machine", machine, "--tools", "tools.toml", *table, "--summary", "s.json",
                      "--motion", "m.jsonl", *words)
    status(result, wanted)
    return box.json("s.json")["variables"]


@test("probe: a ball stops at a level face, at a wall and in a corner of it, a point without one")
def faces(box):
    moves = ("G00X30.Y20.Z10.\nG31Z-5.F100\n#100=#5063\nG00Z10.\nX-20.\nZ-10.\nG31X20.F100\n#101=#5061\n"
             "G00X-20.\nY60.\nX30.\nG31Y20.F100\n#102=#5062")
    for model in ("tridexel", "zmap", "auto"):
        found = probed(box, moves, "--model", model, "--cell", "0.5")
        near(found["#100"], 0, 1e-5, model)
        near(found["#101"], -3, 1e-5, model)
        near(found["#102"], 43, 1e-5, model)
    contains(box.read("m.jsonl").decode(), '"contact":true', "record")
    found = probed(box, moves, "--cell", "0.5", "--fail-on", "never", tool="T1M06\n")
    near(found["#101"], 0, 1e-5, "the tip of a mill")


@test("probe: what was cut before the touch is not there, with any number of threads")
def cut_before(box):
    moves = ("S3000M03\nG00X10.Y20.Z5.\nG01Z-5.F300\nX60.F600\nG00Z5.\nT10M06\nG00X30.Y20.\nG31Z-15.F100\n#100=#5063\n"
             "G01Z-4.\nG31Y40.F100\n#101=#5062")
    texts = set()
    for jobs in ("1", "7"):
        found = probed(box, moves, "--cell", "0.25", "--jobs", jobs, tool="T1M06\n")
        near(found["#100"], -5, 1e-5, "floor")
        near(found["#101"], 22, 1e-3, "wall")
        texts.add(box.read("s.json"))
    equal(len(texts), 1, "summaries")


@test("probe: inside of material it stops at once, away from it it does not")
def inside(box):
    found = probed(box, "G00X30.Y20.Z10.\nG31Z-5.F100\n#100=#5063\nG31Z-6.F100\n#101=#5063\nG31Z20.F100\n#102=#5063",
                   "--cell", "0.5")
    near(found["#100"], 0, 1e-5, "touch")
    near(found["#101"], 0, 1e-5, "again")
    equal(found["#102"], 20, "away")


@test("probe: a fixture is met, a tilted table turns the stock under it")
def others(box):
    found = probed(box, "G00X30.Y20.Z30.\nG31Z-5.F100\n#100=#5063", "--fixture", "box:20,10,0,40,30,15", "--cell", "0.5")
    near(found["#100"], 15, 1e-5, "fixture")
    found = probed(box, "G00X0Y0Z45.A30.\nG31Z0F100\n#100=#5063", "--cell", "0.5", "--machine-set",
                   "kinematics.primary_point=0,0,0", stock="cylinder:X,0,0,-20,20,40", machine="mill4")
    near(found["#100"], 20, 0.02, "round")


@test("probe: without a stock, and where --skip-at says it, nothing of it counts")
def without(box):
    equal(probed(box, "G00Z10.\nG31Z-5.F100\n#100=#5063", stock=None)["#100"], -5, "no stock")
    equal(probed(box, "G00X30.Y20.Z10.\nG31Z-5.F100\n#100=#5063", "--skip-at", "Z=4", "--cell", "0.5")["#100"], 4,
          "said")


@test("probe: a run on a table has findings in its summary, and fails by them")
def findings(box):
    box.write("tools.toml", TOOLS)
    box.write("crash.nc", "O1\nT1M06\nS1000M03\nG90G54G00X-20.Y20.Z5.\nZ-5.\nX20.\nG01X30.F100\nM30\n")
    words = ("--machine", "mill3", "--tools", "tools.toml", "--stock", BOX, "--cell", "0.5")
    status(box.kerf("run", "crash.nc", *words, "--summary", "s.json", "--motion", "m.jsonl"), 1)
    summary = box.json("s.json")
    equal([(f["code"], f["line"]) for f in summary["findings"]], [("RAPID_IN_STOCK", 6)], "findings")
    equal(summary["counts"], {"RAPID_IN_STOCK": 1}, "counts")
    equal(summary["status"], "end", "status")
    status(box.kerf("run", "crash.nc", *words, "--no-check", "RAPID_IN_STOCK"), 0)
    status(box.kerf("run", "crash.nc", *words, "--fail-on", "never"), 0)
    checked = box.kerf("check", "crash.nc", *words, "--format", "json")
    status(checked, 1)
    contains(checked.text, "RAPID_IN_STOCK", "check")


@test("probe: options of a table without one are wrong")
def no_table(box):
    box.write("p.nc", "O1\nM30\n")
    for words in (("--cell", "0.5"), ("--model", "zmap"), ("--fail-on", "never")):
        refused(box.kerf("run", "p.nc", *words), 2, "--stock")
