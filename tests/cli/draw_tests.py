"""kerf draw: drawings become programs, and the report's numbers are those of formulas."""

import json
import math

import harness
from harness import alarm, check, contains, equal, refused, status, test

LASER = "[job]\nmachine = \"laser3\"\nend = \"stay\"\n"


def near(got, wanted, tolerance, what):
    """As that of all tests, also of lists."""
    if not isinstance(wanted, list):
        got, wanted = [got], [wanted]
    equal(len(got), len(wanted), f"{what}: how many")
    for one, other in zip(got, wanted):
        harness.near(one, other, tolerance, what)


def dxf(*entities, unit=4):
    """A drawing of entities, each a list of (group, value)."""
    groups = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, unit),
              (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
    for entity in entities:
        groups += entity
    groups += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code}\n{value}\n" for code, value in groups)


def line(x1, y1, x2, y2, layer="CUT"):
    return [(0, "LINE"), (8, layer), (10, x1), (20, y1), (11, x2), (21, y2)]


def circle(x, y, radius, layer="CUT"):
    return [(0, "CIRCLE"), (8, layer), (10, x), (20, y), (40, radius)]


def polyline(points, layer="CUT", closed=1):
    groups = [(0, "LWPOLYLINE"), (8, layer), (90, len(points)), (70, closed)]
    for point in points:
        groups += [(10, point[0]), (20, point[1])]
        if len(point) > 2:
            groups.append((42, point[2]))
    return groups


def square(size, layer="CUT"):
    return polyline([(0, 0), (size, 0), (size, size), (0, size)], layer)


def operation(process, *keys, layers='["*"]', name="a"):
    lines = ["[[operation]]", f'name = "{name}"', f"layers = {layers}", f'process = "{process}"', "power = 50", "feed = 3000", *keys]
    return "\n".join(lines) + "\n"


def drawn(box, drawing, job=None, *words, wanted=0, name="a.dxf"):
    """Draws and returns the report."""
    box.write(name, drawing)
    order = ["draw", name, "--report", "report.json", *words]
    if job is not None:
        order += ["--job", box.write("job.toml", job)]
    status(box.kerf(*order), wanted)
    return box.json("report.json")


def codes(report):
    return [finding["code"] for finding in report["findings"]]


@test("draw: lines and bulges keep their length, area, extents and exact arcs")
def exact_contours(box):
    slot = dxf(polyline([(0, 0), (40, 0, 1), (40, 20), (0, 20, 1)]))
    contour = drawn(box, slot)["contours"][0]
    near(contour["length_mm"], 80 + 20 * math.pi, 1e-9, "length")
    near(contour["area_mm2"], 800 + 100 * math.pi, 1e-9, "area")
    equal((contour["lines"], contour["arcs"], contour["closed"]), (2, 2, True), "edges")
    near(contour["extents"]["X"], [-10, 50], 1e-9, "extents")


@test("draw: loose lines are joined over small gaps, what is drawn twice is taken once, larger gaps are told")
def cleaning(box):
    box_of_lines = [line(0, 0, 20, 0), line(20, 0.004, 20, 20), line(0, 20, 20, 20), line(0, 20, 0, 0)]
    report = drawn(box, dxf(*box_of_lines, line(20, 0, 0, 0)))
    equal(report["cleaned"], {"zero_length": 0, "duplicates": 1, "joined": 4, "gaps": 0}, "cleaned")
    equal(len(report["contours"]), 1, "contours")
    report = drawn(box, dxf(line(0, 0, 20, 0), line(20.1, 0, 40, 0)))
    equal(codes(report), ["DRAW_GAP"], "findings")
    report = drawn(box, dxf(line(0, 0, 20, 0), line(20.1, 0, 40, 0)), None, "--join", "0.2")
    equal((codes(report), len(report["contours"])), ([], 1), "with --join")
    report = drawn(box, dxf(line(0, 0, 0.003, 0), line(5, 0, 9, 0)), None, "--same", "0.004", "--tolerance", "0.005")
    equal(report["cleaned"]["zero_length"], 1, "without length")


@test("draw: the unit is the file's, or --unit, or assumed and told")
def units(box):
    inch = drawn(box, dxf(line(0, 0, 1, 0), unit=1))
    near(inch["contours"][0]["length_mm"], 25.4, 1e-9, "an inch")
    equal((inch["drawings"][0]["unit"], inch["drawings"][0]["unit_from"]), ("in", "$INSUNITS"), "unit")
    forced = drawn(box, dxf(line(0, 0, 1, 0), unit=1), None, "--unit", "cm")
    near(forced["contours"][0]["length_mm"], 10, 1e-9, "--unit cm")
    unknown = drawn(box, dxf(line(0, 0, 1, 0), unit=0))
    equal(codes(unknown), ["DRAW_UNIT"], "findings")
    svg = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 96 96"><path d="M0 0h96" stroke="red"/></svg>'
    near(drawn(box, svg, None, "--dpi", "48", name="a.svg")["contours"][0]["length_mm"], 50.8, 1e-9, "--dpi")


@test("draw: a cut is compensated to the scrap side, the hole is made first, and the part is as drawn")
def compensated(box):
    job = LASER + operation("cut", "kerf = 0.2", "overcut = 0")
    report = drawn(box, dxf(square(20), circle(10, 10, 5)), job, "--output", "a.nc")
    near(report["plan"]["beam_mm"], 80 + 0.2 * math.pi + 2 * math.pi * 4.9, 1e-6, "way with the beam on")
    equal(report["plan"]["order"], [1, 0], "order")
    summary = box.kerf("run", "a.nc", "--machine", "laser3", "--summary", "-")
    status(summary, 0)
    near(json.loads(summary.out)["cut_mm"], report["plan"]["beam_mm"], 1e-3, "the program's cuts")


@test("draw: a hatch has its lines, spares a hole, and runs up with the beam off")
def hatches(box):
    rectangle = polyline([(0, 0), (20, 0), (20, 10), (0, 10)])
    report = drawn(box, dxf(rectangle), LASER + operation("fill", "spacing = 0.5", "overscan = 3"))
    plan = report["plan"]
    near([plan["beam_mm"], plan["overscan_mm"]], [400, 120], 1e-6, "beam and run-ups")
    equal(plan["operations"][0]["lines"], 20, "lines")
    oblique = drawn(box, dxf(rectangle), LASER + operation("fill", "spacing = 1", "angle = 45"))["plan"]
    equal(oblique["operations"][0]["lines"], 21, "lines at 45 degrees")
    near(oblique["beam_mm"], 199.979797, 1e-5, "way at 45 degrees")
    holed = drawn(box, dxf(rectangle, circle(10, 5, 3)), LASER + operation("fill", "spacing = 0.5"))["plan"]
    near(holed["beam_mm"], 343.034197, 1e-4, "way beside the hole")
    offsets = drawn(box, dxf(rectangle), LASER + operation("fill", 'kind = "offset"', "spacing = 1"))["plan"]
    near(offsets["beam_mm"], 200, 1e-6, "way of offsets")
    open_one = drawn(box, dxf(line(0, 0, 9, 0)), LASER + operation("fill"), wanted=1)
    contains(" ".join(codes(open_one)), "DRAW_OPEN", "an open contour")


@test("draw: energy, holes, seams and tracks are those of the formulas")
def processes(box):
    follow = drawn(box, dxf(line(0, 0, 100, 0)), LASER + operation("engrave", 'beam = "follow"'))["plan"]
    near(follow["energy_j"], 60, 0.01, "energy of power that follows the speed")
    drill = drawn(box, dxf(circle(10, 10, 0.4), circle(20, 10, 0.4)),
                  '[[operation]]\nname = "a"\nlayers = ["*"]\nprocess = "drill"\npulses = 500\nton_ms = 0.2\ntoff_ms = 0.3\n')["plan"]
    near([drill["beam_s"], drill["energy_j"]], [0.5, 12], 0.01, "drilling")
    equal(drill["pierces"], 2, "holes")
    weld = drawn(box, dxf(line(0, 0, 50, 0)),
                 LASER + operation("weld", 'weave = {shape = "zigzag", width = 1, pitch = 2}'))["plan"]
    near(weld["beam_mm"], 50 * math.sqrt(2), 1e-5, "a zigzag")
    heat = drawn(box, dxf(polyline([(0, 0), (40, 0), (40, 20), (0, 20)])),
                 LASER + operation("heat", "track_width = 5", "overlap = 0.2"))["plan"]
    equal(heat["operations"][0]["lines"], 5, "tracks")
    near(heat["beam_mm"], 200, 1e-6, "way of the tracks")
    strong = drawn(box, dxf(square(20)), LASER + operation("heat", "track_width = 5").replace("power = 50\nfeed = 3000", "power = 100\nfeed = 480"),
                   "--machine-set", "drive.max_power_w=1000")["plan"]["operations"][0]
    near(strong["j_mm2"], 25, 1e-9, "1000 W at 480 mm/min on 5 mm")
    pulses = drawn(box, dxf(line(0, 0, 9, 0)), LASER + operation("engrave", "ton_ms = 0.4", "toff_ms = 0.1").replace("power = 50\n", ""))
    near(pulses["plan"]["operations"][0]["power"], 80, 1e-9, "power of 0.4 ms on and 0.1 ms off")
    tabs = drawn(box, dxf(square(20)), LASER + operation("cut", "kerf = 0.2", "overcut = 0", "tabs = {count = 4, width = 0.5}"))
    near(tabs["plan"]["beam_mm"], 80 + 0.2 * math.pi - 2.8, 1e-6, "way beside tabs")


@test("draw: a laser BASIC program, taught points and motions make the same way as G-code")
def targets(box):
    job = LASER + operation("engrave", 'beam = "constant"')
    drawing = dxf(polyline([(0, 0), (40, 0, 1), (40, 20), (0, 20, 1)]), circle(80, 10, 7), line(0, 40, 30, 60))
    report = drawn(box, drawing, job, "--output", "a.nc", "--output", "a.bas", "--output", "a.jsonl", "--flavour", "plain")
    equal([target["language"] for target in report["targets"]], ["gcode", "laser-basic", "motion"], "languages")
    ways = []
    for name in ("a.nc", "a.bas", "a.jsonl"):
        result = box.kerf("run", name, "--machine", "laser3", "--summary", "-")
        status(result, 0)
        ways.append(json.loads(result.out)["cut_mm"])
    near(ways, [report["plan"]["beam_mm"]] * 3, 1e-3, "ways")
    contains(box.read("a.nc").decode(), "LWPOLYLINE", "the comment of a contour")
    tch = drawn(box, drawing, LASER.replace("laser3", "laser5") + operation("engrave"), "--output", "a.out", "--language", "teach")
    equal(tch["targets"][0]["language"], "teach", "language")
    status(box.kerf("run", "a.out", "--machine", "laser5", "--dialect", "teach"), 0)


@test("draw: text of the single-line font is as tall as the job says, with serials from copy to copy")
def texts(box):
    job = ("array = {columns = 3, rows = 1, dx = 60, dy = 0}\n" + LASER +
           '[text]\nfont = "kerf-line"\nheight = 10\n[text.serial]\nstart = 7\nwidth = 3\nkeep = "serial.txt"\n'
           '[[text.line]]\ntext = "{word} {serial}"\nat = [0, 20]\nlayer = "T"\n' + operation("engrave"))
    report = drawn(box, dxf(line(0, 0, 1, 0)), job, "--set", "word=H")
    equal(report["texts"], ["H 007"], "texts")
    layer = [layer for layer in report["layers"] if layer["name"] == "T"][0]
    near(layer["extents"]["Y"], [20, 30], 1e-9, "height of the letters")
    check("serial.txt" not in box.files(), "a serial was kept without a program")
    drawn(box, dxf(line(0, 0, 1, 0)), job, "--set", "word=H", "--output", "a.nc")
    equal(drawn(box, dxf(line(0, 0, 1, 0)), job, "--set", "word=H")["texts"], ["H 010"], "texts of the next run")
    unknown = drawn(box, dxf(line(0, 0, 1, 0)), job, wanted=1)
    contains(" ".join(codes(unknown)), "JOB_TEXT", "a variable without a value")


@test("draw: a material fills what the job leaves out, and more power than there is slows down")
def materials(box):
    listed = box.kerf("materials")
    status(listed, 0)
    contains(listed.text, "co2-plywood-3", "materials")
    contains(box.kerf("materials", "co2-plywood-3").text, "power_w", "the file of a material")
    refused(box.kerf("materials", "nosuch"), 2)
    job = '[job]\nmachine = "laser3"\nmaterial = "co2-plywood-3"\n[[operation]]\nname = "a"\nlayers = ["*"]\nprocess = "cut"\n'
    cut = drawn(box, dxf(square(20)), job)["plan"]["operations"][0]
    near([cut["power"], cut["feed"]], [80, 900], 1e-9, "48 W of 60 W")
    unknown = drawn(box, dxf(square(20)), job.replace("plywood", "marble"), wanted=3)
    equal([(f["code"], f["file"], f["line"]) for f in unknown["findings"]], [("MATERIAL_UNKNOWN", "job.toml", 3)], "findings")
    own = '[[material]]\nname = "thick"\n[material.cut]\npower_w = 120\nfeed = 1000\n'
    box.write("own.toml", own)
    report = drawn(box, dxf(square(20)), job.replace("co2-plywood-3", "thick"), "--materials", "own.toml")
    cut = report["plan"]["operations"][0]
    near([cut["power"], cut["feed"]], [100, 500], 1e-9, "twice the power of the laser")
    contains(" ".join(codes(report)), "PRESET_SCALED", "findings")


@test("draw: keys of the job are changed on the command line, and a wrong one is told with its place")
def job_keys(box):
    job = LASER + operation("engrave", name="outline")
    report = drawn(box, dxf(line(0, 0, 10, 0)), job, "--job-set", "operation.outline.feed=600", "--job-set", "place.scale=2")
    near([report["plan"]["operations"][0]["feed"], report["plan"]["beam_mm"]], [600, 20], 1e-9, "feed and way")
    box.write("bad.toml", job + "kerv = 0.2\n")
    result = box.kerf("draw", "a.dxf", "--job", "bad.toml")
    status(result, 3)
    contains(result.err, "bad.toml:10:1: error: JOB_KEY", "the place")
    refused(box.kerf("draw", "a.dxf", "--job", "nosuch.toml"), 3)
    refused(box.kerf("draw", "a.dxf", "--job-set", "feed"), 2)


@test("draw: layers are chosen, those that nothing takes are told, and warnings may fail")
def layers(box):
    drawing = dxf(line(0, 0, 10, 0, "A"), line(0, 5, 20, 5, "B1"), line(0, 9, 30, 9, "B2"))
    near(drawn(box, drawing, None, "--layer", "B*")["plan"]["beam_mm"], 50, 1e-9, "way of B*")
    job = LASER + operation("engrave", layers='["A", "C"]')
    report = drawn(box, drawing, job)
    equal(sorted(codes(report)), ["DRAW_LAYER", "DRAW_LAYER_UNUSED", "DRAW_LAYER_UNUSED"], "findings")
    drawn(box, drawing, job, "--fail-on", "warning", wanted=1)


@test("draw: nothing is written of a plan beyond the travel, but with --keep-partial")
def outside(box):
    job = LASER + operation("engrave")
    report = drawn(box, dxf(circle(0, 0, 300)), job, "--output", "a.nc", wanted=1)
    equal(codes(report)[0], "DRAW_OUTSIDE", "findings")
    check("a.nc" not in box.files(), "a.nc was written")
    drawn(box, dxf(circle(0, 0, 300)), job, "--output", "a.nc", "--keep-partial", wanted=1)
    check("a.nc" in box.files(), "a.nc was not written")


@test("draw: what is read is written again, and read as the same")
def contours(box):
    drawing = dxf(polyline([(0, 0), (40, 0, 1), (40, 20), (0, 20, 1)]), circle(80, 10, 7, "B"), line(0, 40, 30, 60, "B"))
    first = drawn(box, drawing, None, "--contours", "c.json")
    lengths = sorted(contour["length_mm"] for contour in first["contours"])
    for name in ("c.json", "c.dxf", "c.svg"):
        status(box.kerf("draw", "a.dxf", "--contours", name), 0)
        status(box.kerf("draw", name, "--report", "again.json"), 0)
        again = sorted(contour["length_mm"] for contour in box.json("again.json")["contours"])
        near(again, lengths, 1e-6, name)
    refused(box.kerf("draw", "a.dxf", "--contours", "c.txt"), 2)


@test("draw: a picture of pixels is burnt row by row")
def rasters(box):
    import zlib
    rows = b"".join(b"\0" + bytes([0] * 4 + [255] * 4) for _ in range(4))

    def chunk(kind, data):
        return len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")

    header = (8).to_bytes(4, "big") + (4).to_bytes(4, "big") + bytes([8, 0, 0, 0, 0])
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
    job = "image = {width = 0.8}\n" + LASER + operation("raster", 'mode = "threshold"', "interval = 0.1", "overscan = 1")
    report = drawn(box, png, job, name="p.png")
    equal(report["rasters"][0]["pixels"], [8, 4], "pixels")
    equal((report["rasters"][0]["burnt"], report["rasters"][0]["runs"]), (16, 4), "burnt")
    near(report["plan"]["beam_mm"], 1.6, 1e-9, "way with the beam on")


@test("draw: a rectangle on a pipe goes round it in arcs, the beam square on it")
def wrapped(box):
    job = ('[job]\nmachine = "laser5"\n[wrap]\nshape = "cylinder"\naxis = "X"\nradius = 20\ncenter = [0, 0, -20]\n' +
           operation("cut", 'side = "on"', "overcut = 0"))
    drawn(box, dxf(polyline([(0, -10), (30, -10), (30, 10), (0, 10)])), job, "--output", "a.jsonl", "--machine", "laser5")
    for record in box.motions("a.jsonl"):
        if record["kind"] in ("line", "arc3") and "to" in record:
            to = record["to"]
            near(math.hypot(to["Y"], to["Z"] + 20), 20, 1e-6, "distance from the axis")
            near(to["A"], -math.degrees(math.atan2(to["Y"], to["Z"] + 20)), 1e-6, "A")
    twice = drawn(box, dxf(line(0, -70, 0, 70)), job, "--machine", "laser5")
    contains(" ".join(twice["assumed"]), "more than once round", "assumed")
    ball = job.replace('"cylinder"\naxis = "X"', '"sphere"')
    stretched = drawn(box, dxf(line(0, 0, 20, 0)), ball, "--machine", "laser5")
    contains(" ".join(stretched["assumed"]), f"{1 / math.sin(1):.3f}", "assumed of a sphere")
    on_mill = drawn(box, dxf(square(9)), job, "--machine", "laser3", wanted=1)
    equal(codes(on_mill)[0], "PROCESS_MACHINE", "findings")


@test("draw: bad drawings are sentences with a place, and budgets end")
def bad_drawings(box):
    box.write("cut.dxf", dxf(square(40))[:-60])
    result = box.kerf("draw", "cut.dxf")
    status(result, 1)
    contains(result.err, "DXF_TRUNCATED", "a file that is cut off")
    box.write("no.txt", "nothing of the kind\n")
    contains(box.kerf("draw", "no.txt").err, "DRAW_FORMAT", "no drawing")
    refused(box.kerf("draw", "nosuch.dxf"), 3)
    refused(box.kerf("draw", "lens:box:1,2"), 2)
    refused(box.kerf("draw", "lens:round:50", "--output", "a.xyz"), 2)
    box.write("many.dxf", dxf(*[line(i, 0, i, 5) for i in range(50)]))
    status(box.kerf("draw", "many.dxf", "--max-entities", "20"), 5)
    box.write("empty.dxf", dxf())
    contains(box.kerf("draw", "empty.dxf", "--diagnostics", "json").err, "DRAW_EMPTY", "an empty drawing")
    status(box.kerf("draw", "many.dxf", "--max-motions", "10", "--max-seconds", "20"), 5)


@test("draw: a lens from its measures, and its picture coloured by energy")
def lens(box):
    words = ["draw", "lens:oval:50,40", "--process", "engrave", "--machine", "laser-xtz", "--machine-set", "tip.acceleration=2000",
             "--picture", "lens.png", "--plot-energy", "--report", "report.json"]
    status(box.kerf(*words), 0)
    near(box.json("report.json")["contours"][0]["length_mm"], 141.808339, 0.02, "length")
    check(box.read("lens.png").startswith(b"\x89PNG"), "no PNG")
    refused(box.kerf("draw", "lens:round:50", "--plot-energy"), 2)
    refused(box.kerf("draw", "lens:round:50", "--picture", "lens.txt"), 2)


@test("draw: what was assumed is told, and the same order gives the same bytes")
def assumed(box):
    report = drawn(box, dxf(square(20)), None, "--process", "cut")
    equal(len(report["assumed"]), 3, "machine, power and feed")
    words = ["draw", "a.dxf", "--output", "-", "--language", "gcode"]
    equal(box.kerf(*words).out, box.kerf(*words).out, "bytes")
    alarm(box.kerf("draw", "a.dxf", "--job-set", "place.at=[900, 0]"), "DRAW_OUTSIDE", None)


@test("draw: a mill goes down along contours alone, and a machine without a plane makes nothing")
def mills(box):
    job = '[job]\nmachine = "mill3"\nend = "stay"\n' + operation("engrave", "depth = 2", "step_down = 1", "safe_z = 0", "spindle = 8000", "tool = 1")
    report = drawn(box, dxf(line(10, 10, 30, 10)), job, "--output", "a.jsonl")
    lows = sorted({record["to"]["Z"] for record in box.motions("a.jsonl") if record["kind"] == "line"})
    equal((lows, report["assumed"]), ([-2, -1], []), "levels")
    hatch = drawn(box, dxf(square(9)), job.replace("engrave", "fill"), wanted=1)
    equal(codes(hatch), ["PROCESS_MACHINE"], "a hatch on a mill")
    bare = drawn(box, dxf(square(9)), None, "--machine", "mill3")
    equal(len(bare["assumed"]), 3, "feed, depth and spindle")
    equal(codes(drawn(box, dxf(square(9)), None, "--machine", "lathe2", wanted=1)), ["PROCESS_MACHINE"], "on a lathe")
