"""By what a part can be coloured: how far its tools were engaged, who cut it, and how far it is from its design."""

import csv
import json
import math

import harness  # noqa: F401
import solids
from harness import *  # noqa: F403
from stock_tests import LATHE, LATHE_SET_UP, SLOT, SLOT_SET_UP, TILTED, Part, mill, shown

# Line 10 goes along the side, a quarter of the mill wide, and then through the middle; line 16 only along the side.
ENGAGED = (
    "O1 (ENGAGED)\n(T1 D=10. CR=0. - flat end mill)\nT1 M06\nS3000 M03\n#1=0\nWHILE [#1 LT 2] DO1\nG00 Z5.\nX-10. Y[62.5-22.5*#1]\n"
    "G01 Z-3. F300\nX80. F600\n#1=#1+1\nEND1\nG00 Z5.\nX-10. Y-2.5\nG01 Z-3. F300\nX80. F600\nG00 Z5.\nX30. Y20.\nG01 Z-2. F300\nG00 Z50.\nM30\n"
)


def told_by_stock(place, program, set_up, *words, fails=False):
    """The report of `kerf stock`, and the rows of its motions."""
    folder = place.folder / "stock"
    folder.mkdir(exist_ok=True)
    (folder / "part.nc").write_text(program)
    (folder / "job.toml").write_text(set_up)
    result = place.run("stock", str(folder / "part.nc"), "--setup", str(folder / "job.toml"), "--report", str(folder / "r.json"),
                       "--blocks", str(folder / "rows.csv"), *words)
    equal(result.returncode, int(fails), f"status of kerf stock: {result.stderr}")
    with open(folder / "rows.csv") as rows:
        return json.loads((folder / "r.json").read_text()), list(csv.DictReader(rows))


def put(place, name, content):
    equal(place.servers[0].request("PUT", f"/library/{name}", content)[0].status, 201, f"{name} is in the library")


def off(fact):
    """The deviations of a part, None where nothing is known."""
    return [None if v == -32768 else fact["scale"] * v for v in fact["value"]]


def deviations(part):
    return {at: fact for (what, at), fact in part.told.items() if what == "deviation"}


def seen_against(part, tiles=None, **wish):
    """Asks for deviations and waits until all of the picture has them."""
    part.at(part.facts["done_s"], deviation=True, **wish)
    wanted = tiles or (lambda p: p.tiles)
    return part.wait(lambda p: len(deviations(p)) == len(wanted(p)), "deviations of all tiles")


@test("a block tells the largest angle that its tool was engaged, as kerf stock does")
def _(place):
    part = shown(mill(place), ENGAGED, set_up=SLOT_SET_UP).wait_for_end()
    told = {row[1]: row[3] for row in part.owners}
    equal(told[10], 180, "a full slot in the second of two passes")
    # From ae = D / 4, which is right to half a cell on one side.
    check(abs(told[16] - 60) < 4, f"along the side: {told[16]}")
    equal((told[19], part.owners[0]), (None, [0, 0, 0, None]), "a plunge, and nobody")
    report, rows = told_by_stock(place, ENGAGED, SLOT_SET_UP, "--cell", str(part.facts["cell_mm"]))
    equal(max(report["model"]["cell_mm"]), part.facts["cell_mm"], "the same cells")
    for line in (10, 16):
        largest = max(float(row["phi_deg"] or 0) for row in rows if row["line"] == str(line))
        check(abs(told[line] - largest) <= 0.05 + 1e-9, f"line {line}: {told[line]}, by kerf stock {largest}")


# Two grooves along X: the program cuts the first one 0.2 mm too deep, of the second it leaves 0.1 mm.
GROOVES = (
    "O1 (GROOVES)\n(T1 D=10. CR=0. - flat end mill)\nT1 M06\nS3000 M03\nG00 X-10. Y20. Z5.\nG01 Z-5. F300\nX80. F600\nG00 Z5.\n"
    "X-10. Y40.\nG01 Z-2.9 F300\nX80. F600\nG00 Z50.\nM30\n"
)
OUTLINE = [(0, -20), (60, -20), (60, 0), (45, 0), (45, -3), (35, -3), (35, 0), (25, 0), (25, -4.8), (15, -4.8), (15, 0), (0, 0)]
CAPS = [(11, 0, 9), (11, 9, 10), (0, 8, 9), (0, 1, 8), (8, 1, 5), (8, 5, 7), (5, 6, 7), (1, 4, 5), (1, 2, 4), (2, 3, 4)]
DESIGN = '[design]\nfile = "grooves.stl"\ntolerance = 0.04\n'


def grooves(place, name="miller"):
    client = mill(place, name)
    put(place, "grooves.stl", solids.bar(OUTLINE, CAPS, 0, 70))
    return client


@test("a part is seen as far off its design as kerf stock tells, within the steps of its frames")
def _(place):
    client = grooves(place)
    part = shown(client, GROOVES, set_up=SLOT_SET_UP + DESIGN).wait_for_end()
    equal(part.facts["design"], {"file": "grooves.stl", "tolerance_mm": 0.04}, "the design")
    equal((part.facts["error"], part.told), (None, {}), "nothing is told that nobody asked for")
    seen_against(part)
    step = max(fact["scale"] for fact in deviations(part).values())
    check(step < 0.001, f"a step is {step} mm")
    for (x, y), wanted in {(35, 20): -0.2, (35, 40): 0.1, (35, 30): 0}.items():
        tile, k = part.column(x, y)
        found = off(part.told["deviation", (*tile["at"], 0)])[k]
        check(abs(found - wanted) <= step, f"at {x}, {y}: {found}, not {wanted}")
        probed = client.do("stock_probe", x=x, y=y, z=0)["deviation_mm"]
        check(abs(probed - wanted) < 1e-5, f"the probe at {x}, {y}: {probed}")
    (place.folder / "stock").mkdir()
    (place.folder / "stock" / "grooves.stl").write_bytes(solids.bar(OUTLINE, CAPS, 0, 70))
    report, _ = told_by_stock(place, GROOVES, SLOT_SET_UP + DESIGN, fails=True)
    all_of_it = [d for fact in deviations(part).values() for d in off(fact)]
    for side, found in (("gouge", -min(all_of_it)), ("excess", max(all_of_it))):
        wanted = report["compare"][side]["max_mm"]
        check(abs(found - wanted) <= step, f"{side}: {found}, by kerf stock {wanted}")
    told = [(finding["code"], finding["line"]) for finding in part.facts["findings"]]
    equal(told, [(finding["code"], finding["line"]) for finding in report["findings"]], "what is found")
    equal({code for code, _ in told}, {"GOUGE", "EXCESS"}, "both sides")


@test("deviations come for what has changed, behind its shape")
def _(place):
    part = shown(grooves(place), GROOVES, set_up=SLOT_SET_UP + DESIGN).wait_for_end()
    seen_against(part)
    end = part.facts["done_s"]
    whole = {at: fact["value"] for at, fact in deviations(part).items()}
    sent = len(part.client.part_frames)
    part.at(0.8 * end, deviation=True)
    part.wait(lambda p: len(deviations(p)) == len(p.tiles), "those of the new instant")
    frames = part.client.part_frames[sent:]
    equal([frame.kind for frame in frames], [0, 4], "shape, then what is known of it")
    equal([(*tile["at"], 0) for tile in frames[0].tiles], [tile["at"] for tile in frames[1].tiles], "of the same tiles")
    check(len(frames[1].tiles) < len(part.tiles), f"{len(frames[1].tiles)} of {len(part.tiles)} tiles have changed")
    seen_against(part)
    equal({at: fact["value"] for at, fact in deviations(part).items()}, whole, "the same deviations at the end")
    sent = len(part.client.part_frames)
    part.at(0.8 * end)
    equal([frame.kind for frame in part.client.part_frames[sent:]], [0], "none where nobody asks for them")


@test("deviations of finer cells are told as well, and of a larger picture in several frames")
def _(place):
    wide = '[stock]\nshape = "box:0,0,-20,400,60,0"\n'
    part = shown(grooves(place), GROOVES, set_up=wide + DESIGN).wait_for_end()
    seen_against(part, level=1)
    equal((part.head[1], len(part.facts["levels"])), (1, 2), "the fine level")
    tile, k = part.column(35, 20)
    fact = part.told["deviation", (*tile["at"], 0)]
    check(abs(off(fact)[k] + 0.2) <= fact["scale"], f"as far off: {off(fact)[k]}")
    frames = [frame for frame in part.client.part_frames if frame.kind == 4]
    columns = math.prod(part.facts["levels"][1]["cells"])
    check(len(frames) >= columns // (65536 + 4096), f"{len(frames)} frames of {columns} columns")
    check(all(frame.bytes < 1.1 * (1 << 20) for frame in frames), "none is large")


@test("of a column of which nothing is left no deviation is known")
def _(place):
    thin = '[stock]\nshape = "box:0,0,-4,70,60,0"\n'
    part = shown(grooves(place), GROOVES, set_up=thin + DESIGN).wait_for_end()
    seen_against(part)
    tile, k = part.column(35, 20)
    equal((tile["z"][k], off(part.told["deviation", (*tile["at"], 0)])[k]), (None, None), "the groove goes through")


@test("a part without a design has no deviations, whatever is asked for")
def _(place):
    client = grooves(place)
    part = shown(client, GROOVES, set_up=SLOT_SET_UP).wait_for_end()
    equal(part.facts["design"], None, "no design")
    part.at(part.facts["done_s"], deviation=True)
    part.at(0.5 * part.facts["done_s"], deviation=True)
    equal({frame.kind for frame in client.part_frames}, {0}, "frames")
    equal(client.do("stock_probe", x=35, y=20, z=0)["deviation_mm"], None, "the probe")
    run = part.facts["run"]
    client.do("stock", toml=SLOT_SET_UP + DESIGN)
    part.wait(lambda p: p.facts["run"] != run and p.facts.get("done"), "the part anew")
    equal(part.facts["design"]["file"], "grooves.stl", "its design")
    part.wait(lambda p: p.tiles and len(deviations(p)) == len(p.tiles), "deviations, which are still asked for")


@test("a design that is not there or is none is said in a sentence")
def _(place):
    client = mill(place)
    put(place, "open.stl", b"solid\nendsolid\n")
    for name in ("lost.stl", "open.stl"):
        client.load(SLOT, f"{name[:-4]}.nc")
        client.do("stock", toml=f'{SLOT_SET_UP}[design]\nfile = "{name}"\n')
        part = Part(client)
        client.do("stock", shows=True)
        part.wait(lambda p: name in str(p.facts.get("error")), "the sentence")
        check(str(place.data) not in part.facts["error"]["message"], "the folder is nobody's business")


@test("triangles are as far off as their corners are from the design")
def _(place):
    client = mill(place, "five", "mill5")
    put(place, "block.stl", solids.box((-10, -30, -30), (50, 30, 0)))
    set_up = '[stock]\nshape = "box:-10,-30,-30,50,30,0"\n[design]\nfile = "block.stl"\n'
    part = shown(client, TILTED, "tilted.nc", set_up).wait_for_end(60)
    equal(part.kind, 1, "triangles")
    there = lambda p: {at: tile for at, tile in p.tiles.items() if tile["points"]}  # noqa: E731
    seen_against(part, there)
    deepest = 0
    for at, tile in there(part).items():
        fact = part.told["deviation", at]
        equal(len(fact["value"]), len(tile["points"]), f"places of the tile {at}")
        for (x, y, z), found in zip(tile["points"], off(fact)):
            wanted = -min(x + 10, 50 - x, y + 30, 30 - y, z + 30, -z)  # all of the part lies in the block
            check(abs(found - wanted) <= fact["scale"] + 0.002, f"at {x}, {y}, {z}: {found}, not {wanted}")
            deepest = min(deepest, found)
    check(-9 < deepest < -4, f"the groove is {deepest} deep")


def corners(part, what):
    """Z, radius and what is told of each corner."""
    return [
        (z, rho, value)
        for number, loop in enumerate(part.tiles[0])
        for (z, rho, _), value in zip(loop, what(part, number), strict=True)
    ]


def who(part, number):
    return [part.owners[value & 0xFFFF][1] for value in part.told["owner", (number, 0, 0)]["value"]]


def of_design(part, number):
    return off(part.told["deviation", (number, 0, 0)])


@test("a turned part tells who cut each of its lines, and how far it is from its design all along them")
def _(place):
    client = place.serve().client()
    client.do("create", name="turner", definition="lathe2")
    client.watch("turner")
    part = shown(client, LATHE, "shaft.nc", LATHE_SET_UP).wait_for_end()
    part.wait(lambda p: ("owner", (0, 0, 0)) in p.told, "who cut it")
    check(("deviation", (0, 0, 0)) not in part.told and part.facts["design"] is None, "no design")
    # The outline has the material on its left: turned lines begin at their right ends.
    for from_z, from_rho, wanted in ((-10, 20, 7), (0, 15, 11)):
        lines = [line for z, rho, line in corners(part, who) if math.dist((z, rho), (from_z, from_rho)) < 1e-6]
        equal(lines, [wanted], f"from {from_z}, {from_rho}")
    equal({line for _, _, line in corners(part, who)} >= {0, 7, 11}, True, "lines that cut, and the bar")
    part.at(0.4 * part.facts["done_s"])
    part.wait(lambda p: ("owner", (0, 0, 0)) in p.told, "who had cut it then")
    check(11 not in {line for _, _, line in corners(part, who)}, "what comes behind has not cut yet")
    # 0.1 mm more was wanted of the middle, and 0.2 less of the end.
    put(place, "shaft.stl", solids.turned([(-60, 25), (-30, 25), (-30, 20.1), (-10, 20.1), (-10, 14.8), (0, 14.8)]))
    run = part.facts["run"]
    client.do("stock", toml='[design]\nfile = "shaft.stl"\n' + LATHE_SET_UP)
    part.wait(lambda p: p.facts["run"] != run and p.facts.get("done"), "the part anew")
    part.at(part.facts["done_s"], deviation=True)
    part.wait(lambda p: ("deviation", (0, 0, 0)) in p.told, "deviations")
    middle = [found for z, rho, found in corners(part, of_design) if -29 < z < -11 and abs(rho - 20) < 1e-6]
    check(len(middle) >= 35, f"{len(middle)} corners along 18 mm")
    check(all(abs(found + 0.1) < 0.002 for found in middle), f"cut away: {middle}")
    end = [found for z, rho, found in corners(part, of_design) if -9.5 < z < -1 and abs(rho - 15) < 1e-6]
    check(len(end) >= 16 and all(abs(found - 0.2) < 0.002 for found in end), f"left: {end}")
    equal({line for _, _, line in corners(part, who)} >= {0, 7, 11}, True, "who cut it, as before")
    check(math.isclose(max(rho for _, rho, _ in corners(part, who)), 25), "the bar")


@test("who looks at a part against its design is not waited for, nor does a later wish wait for him")
def _(place):
    client = grooves(place)
    part = shown(client, GROOVES, set_up=SLOT_SET_UP + DESIGN).wait_for_end()
    end = part.facts["done_s"]
    for share in (0.3, 0.9, 0.5, 1):
        equal(part.at(share * end, deviation=True)["time_s"], share * end, "the time that is shown")
        equal(part.time_s, share * end, "its shape has come with the answer")
    part.wait(lambda p: len(deviations(p)) == len(p.tiles), "and then what is known of it")
