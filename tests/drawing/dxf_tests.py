#!/usr/bin/env python3
"""Drawings that ezdxf writes, of all releases, are read back: every entity with its length and extents, by formulas.

usage: dxf_tests.py --reader kerf_read_drawing      exit 1 when anything differs; 77: ezdxf is not installed
"""

import argparse
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import ezdxf
    from ezdxf.math import BSpline, Vec3
except ImportError:
    print("ezdxf is not installed")
    sys.exit(77)

import shapes
from shapes import arc, chords, conic, mirrored, polyline, unmatched

RELEASES = ["R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018"]
VERSIONS = ["AC1009", "AC1015", "AC1018", "AC1021", "AC1024", "AC1027", "AC1032"]
# $INSUNITS of each, which R12 has in no drawing of its own.
UNITS = [4, 1, 5, 4, 13, 6, 2]
NAMES = {1: "in", 2: "ft", 4: "mm", 5: "cm", 6: "m", 13: "um"}
MM = {1: 25.4, 2: 304.8, 4: 1, 5: 10, 6: 1000, 13: 0.001}
EXACT = 1e-9
DOWN = (0, 0, -1)


class Scene:
    """A drawing that is written, and what should be read of it."""

    def __init__(self, release: str, unit: int):
        self.doc = ezdxf.new(release, setup=True)
        self.doc.header["$INSUNITS"] = unit
        self.mm = MM[unit]
        self.unit = unit
        self.space = self.doc.modelspace()
        self.is_old = release == "R12"
        self.paths = []  # (handle or "", measure, how far off, layer)
        self.words = []
        self.points = []
        self.ignored = {}
        self.codes = ["DRAW_UNIT"] if self.is_old else []  # R12 has no $INSUNITS
        self.colours = {}

    def expect(self, entity, measure, most=EXACT, name=None):
        """`most` in mm; lengths and coordinates of `measure` in the drawing's unit."""
        handle = entity.dxf.handle if entity is not None else ""
        self.paths.append((name if name is not None else handle, measure.scaled(self.mm), most))


def curves(scene: Scene):
    space = scene.space
    line = space.add_line((1, 2), (4, 6))
    scene.expect(line, chords([(1, 2), (4, 6)]))
    for start, end in [(0, 90), (350, 10), (30, 29), (180, 540), (-45, 45)]:
        scene.expect(space.add_arc((3, -2), 7.5, start, end), arc((3, -2), 7.5, start, end))
    scene.expect(space.add_circle((-20, 5), 4), arc((-20, 5), 4, 0, 360))
    vertices = [(0, 0, 0), (40, 0, 1), (40, 20, 0), (0, 20, 1)]
    flat = [(x, y, 0, 0, b) for x, y, b in vertices]
    for closed in (True, False):
        if scene.is_old:
            entity = space.add_polyline2d(flat, format="xyseb", close=closed)
        else:
            entity = space.add_lwpolyline(flat, format="xyseb", close=closed)
        scene.expect(entity, polyline(vertices, closed))
    heavy = space.add_polyline2d([(x, y, 0, 0, -0.3) for x, y, _ in vertices], format="xyseb", close=True)
    scene.expect(heavy, polyline([(x, y, -0.3) for x, y, _ in vertices], True))
    spatial = space.add_polyline3d([(0, 0, 0), (3, 0, 4), (3, 4, 9)])
    scene.expect(spatial, chords([(0, 0), (3, 0), (3, 4)]))
    scene.ignored["Z"] = 1
    corners = [(0, 0), (10, 0), (0, 8), (10, 8)]
    scene.expect(space.add_solid(corners), chords([corners[i] for i in (0, 1, 3, 2)], True))
    scene.expect(space.add_trace(corners), chords([corners[i] for i in (0, 1, 3, 2)], True))
    scene.expect(space.add_solid(corners[:3]), chords(corners[:3], True))
    scene.expect(space.add_3dface([(0, 0), (9, 0), (9, 5), (0, 5)]), chords([(0, 0), (9, 0), (9, 5), (0, 5)], True))
    space.add_point((12.5, -3))
    scene.points.append((12.5, -3))
    if not scene.is_old:
        bent_curves(scene)


def spline_measure(spline: BSpline) -> shapes.Measure:
    return chords(list(spline.approximate(4000)))


def bent_curves(scene: Scene):
    space = scene.space
    near = 0.011 + 1e-3 * scene.mm  # the tolerance, and that of the chords that the curve is compared with
    for major, ratio, start, end in [((25, 0), 0.8, 0, math.tau), ((3, 4), 0.5, 0.5, 4), ((0, 9), 1, 6, 1),
                                     ((5, 0), 0.05, 1, 0.5)]:
        entity = space.add_ellipse((7, -8), major, ratio, start, end)
        minor = (-ratio * major[1], ratio * major[0])
        sweep = (end - start) % math.tau or math.tau
        scene.expect(entity, conic((7, -8), major, minor, start, sweep), near)
    points = [(0, 0), (10, 30), (20, -30), (30, 0), (45, 10), (50, 40), (35, 50)]
    for degree in (1, 2, 3, 5):
        entity = space.add_open_spline(points, degree=degree)
        measure = chords(points) if degree == 1 else spline_measure(BSpline(points, order=degree + 1))
        scene.expect(entity, measure, near)
    weights = [1, 2, 1, 0.5, 3, 1, 1]
    entity = space.add_rational_spline(points, weights, degree=3)
    scene.expect(entity, spline_measure(BSpline(points, order=4, weights=weights)), near)
    closed = space.add_spline()
    closed.set_closed([(x, y, 0) for x, y in points], degree=3)
    scene.expect(closed, spline_measure(closed.construction_tool()), near)
    # A rational spline of degree 2 that is a circle stays one.
    quarter = math.sqrt(0.5)
    circle = space.add_spline(degree=2)
    round_points = [(5, 0), (5, 5), (0, 5), (-5, 5), (-5, 0), (-5, -5), (0, -5), (5, -5), (5, 0)]
    circle.set_open_rational([(x, y, 0) for x, y in round_points], [1, quarter, 1, quarter, 1, quarter, 1, quarter, 1], degree=2)
    circle.knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
    scene.expect(circle, arc((0, 0), 5, 0, 360), 1e-6 * max(1, scene.mm))
    # Through points on a straight line a spline is that line, there and back none.
    straight = space.add_spline([(0, 0), (1, 2), (4, 8), (5, 10)])
    scene.expect(straight, chords([(0, 0), (5, 10)]), 1e-5)


def planes(scene: Scene):
    space = scene.space
    seen = {"extrusion": DOWN}
    scene.expect(space.add_arc((3, 2), 5, 10, 80, dxfattribs=seen), mirrored(arc((3, 2), 5, 10, 80)))
    scene.expect(space.add_circle((8, 2), 5, dxfattribs=seen), mirrored(arc((8, 2), 5, 0, 360)))
    scene.expect(space.add_line((1, 2), (4, 6), dxfattribs=seen), chords([(1, 2), (4, 6)]))
    vertices = [(0, 0, 0.4), (9, 0, 0), (9, 5, -0.2), (0, 5, 0)]
    flat = [(x, y, 0, 0, b) for x, y, b in vertices]
    heavy = space.add_polyline2d(flat, format="xyseb", close=True, dxfattribs=seen)
    scene.expect(heavy, mirrored(polyline(vertices, True)))
    scene.expect(space.add_solid([(0, 0), (4, 0), (0, 3)], dxfattribs=seen), mirrored(chords([(0, 0), (4, 0), (0, 3)], True)))
    space.add_circle((1, 1), 2, dxfattribs={"extrusion": (0, 1, 1)})
    scene.codes.append("DXF_PLANE")
    block = scene.doc.blocks.new("TURNED", base_point=(1, 0))
    block.add_line((1, 0), (5, 3))
    block.add_arc((2, 2), 3, 20, 110, dxfattribs=seen)
    insert = space.add_blockref("TURNED", (10, 4), dxfattribs={"extrusion": DOWN, "xscale": 2, "yscale": 2, "rotation": 30})
    expect_block(scene, insert)
    if scene.is_old:
        return
    scene.expect(space.add_lwpolyline(flat, format="xyseb", close=True, dxfattribs=seen), mirrored(polyline(vertices, True)))
    below = space.add_ellipse((3, 1), (6, 2), 0.5, 0.3, 2, dxfattribs=seen)
    scene.expect(below, conic((3, 1), (6, 2), (1, -3), 0.3, 1.7), 0.011)


def measure_of(entity) -> shapes.Measure:
    """Of a LINE, ARC, CIRCLE or ELLIPSE, wherever its plane faces, seen from above."""
    kind = entity.dxftype()
    if kind == "LINE":
        return chords([entity.dxf.start, entity.dxf.end])
    if kind == "ELLIPSE":
        major, minor = entity.dxf.major_axis, entity.minor_axis
        sweep = (entity.dxf.end_param - entity.dxf.start_param) % math.tau or math.tau
        centre = entity.dxf.center
        return conic((centre.x, centre.y), (major.x, major.y), (minor.x, minor.y), entity.dxf.start_param, sweep)
    ocs = entity.ocs()
    centre = ocs.to_wcs(Vec3(entity.dxf.center))
    first = ocs.to_wcs(Vec3(entity.dxf.radius, 0))
    second = ocs.to_wcs(Vec3(0, entity.dxf.radius))
    start, end = (entity.dxf.start_angle, entity.dxf.end_angle) if kind == "ARC" else (0, 360)
    sweep = (end - start) % 360 or 360
    return conic((centre.x, centre.y), (first.x, first.y), (second.x, second.y), math.radians(start), math.radians(sweep))


def expect_block(scene: Scene, insert):
    """What ezdxf itself makes of an INSERT: blocks in blocks, rows and columns of the outermost."""
    for one in insert.multi_insert() if insert.mcount > 1 else [insert]:
        for entity in one.virtual_entities():
            if entity.dxftype() == "INSERT":
                expect_block(scene, entity)
            else:
                is_bent = entity.dxftype() == "ELLIPSE"
                scene.expect(None, measure_of(entity), 0.011 if is_bent else EXACT * max(1, scene.mm), name="")


def blocks(scene: Scene):
    space = scene.space
    scene.doc.layers.add("A", color=1)
    inner = scene.doc.blocks.new("INNER", base_point=(1, 1))
    inner.add_line((1, 1), (6, 2), dxfattribs={"layer": "0", "color": 0})
    inner.add_circle((3, 3), 2, dxfattribs={"layer": "0"})
    inner.add_arc((0, 4), 3, 300, 40, dxfattribs={"layer": "A", "color": 5})
    outer = scene.doc.blocks.new("OUTER", base_point=(-2, 3))
    outer.add_line((0, 0), (10, 0))
    outer.add_blockref("inner", (4, 5), dxfattribs={"rotation": 25, "xscale": -1.5, "yscale": 1.5})
    grid = {"column_count": 3, "row_count": 2, "column_spacing": 8, "row_spacing": -7, "rotation": -10}
    outer.add_blockref("INNER", (9, 9), dxfattribs=grid)
    # The same without a grid inside, which ezdxf does not scale with the block: drawn nowhere, to compare with.
    twin = scene.doc.blocks.new("TWIN", base_point=(-2, 3))
    twin.add_line((0, 0), (10, 0))
    twin.add_blockref("INNER", (4, 5), dxfattribs={"rotation": 25, "xscale": -1.5, "yscale": 1.5})
    for column in range(3):
        for row in range(2):
            cell = Vec3(9, 9) + Vec3(8 * column, -7 * row).rotate_deg(-10)
            twin.add_blockref("INNER", cell, dxfattribs={"rotation": -10})
    nowhere = scene.doc.blocks.new("NEVER_INSERTED")
    for attributes in [{}, {"rotation": 45, "xscale": 2, "yscale": 2}, {"xscale": -1}, {"yscale": -0.5, "xscale": 0.5},
                       {"xscale": 2, "yscale": 0.7}, {"column_count": 2, "row_count": 3, "column_spacing": 50, "row_spacing": 60, "rotation": 90}]:
        is_even = abs(attributes.get("xscale", 1)) == abs(attributes.get("yscale", 1))
        name = "OUTER" if is_even else "INNER"
        space.add_blockref(name, (20, -10), dxfattribs={"layer": "A", "color": 3, **attributes})
        expect_block(scene, nowhere.add_blockref("TWIN" if is_even else name, (20, -10), dxfattribs=attributes))
    scene.colours = {("LINE", "A"): {"#00ff00", "#ff0000"}, ("CIRCLE", "A"): {"#ff0000"}, ("ARC", "A"): {"#0000ff"}}
    space.add_blockref("NOWHERE", (0, 0))
    scene.codes.append("DXF_BLOCK")


def hatches(scene: Scene):
    if scene.is_old:
        return curves(scene)
    space = scene.space
    hatch = space.add_hatch(color=2)
    outline = [(0, 0, 0), (30, 0, 0.5), (30, 20, 0), (0, 20, 0)]
    hatch.paths.add_polyline_path(outline, is_closed=True)
    scene.expect(hatch, polyline(outline, True))
    hole = hatch.paths.add_edge_path()
    hole.add_arc((10, 10), 4, 0, 360)
    scene.expect(hatch, arc((10, 10), 4, 0, 360))
    slot = hatch.paths.add_edge_path()
    slot.add_line((18, 6), (24, 6))
    slot.add_arc((24, 8), 2, 270, 90)
    slot.add_line((24, 10), (18, 10))
    slot.add_arc((18, 8), 2, 90, 270)
    scene.expect(hatch, polyline([(18, 6, 0), (24, 6, 1), (24, 10, 0), (18, 10, 1)], True))
    notch = hatch.paths.add_edge_path()
    notch.add_line((40, 0), (50, 0))
    notch.add_line((50, 0), (50, 10))
    notch.add_arc((45, 10), 5, 180, 360, ccw=False)
    notch.add_line((40, 10), (40, 0))
    scene.expect(hatch, polyline([(40, 0, 0), (50, 0, 0), (50, 10, -1), (40, 10, 0)], True))
    bent = space.add_hatch()
    oval = bent.paths.add_edge_path()
    oval.add_ellipse((5, 5), (8, 0), 0.5, 0, 360)
    scene.expect(bent, conic((5, 5), (8, 0), (0, 4), 0, math.tau), 0.011)
    half = bent.paths.add_edge_path()
    half.add_ellipse((5, 5), (8, 0), 0.5, 0, 180)
    half.add_line((-3, 5), (13, 5))
    scene.expect(bent, shapes.together([conic((5, 5), (8, 0), (0, 4), 0, math.pi), chords([(-3, 5), (13, 5)])]), 0.011)
    wave = bent.paths.add_edge_path()
    points = [(0, 0), (10, 30), (20, -30), (30, 0)]
    wave.add_spline(control_points=points, degree=3)
    wave.add_line((30, 0), (30, -40))
    wave.add_line((30, -40), (0, 0))
    scene.expect(bent, shapes.together([spline_measure(BSpline(points, order=4)), chords([(30, 0), (30, -40), (0, 0)])]),
                 0.011 + 1e-3 * scene.mm)
    bent.set_pattern_fill("ANSI31", scale=0.5)
    below = space.add_hatch(dxfattribs={"extrusion": DOWN})
    below.paths.add_polyline_path(outline, is_closed=True)
    scene.expect(below, mirrored(polyline(outline, True)))


def words(scene: Scene):
    space = scene.space
    layer = "切割 №1" if not scene.is_old else "Grün"
    scene.doc.layers.add(layer, color=30)
    if scene.is_old:
        scene.doc.header["$DWGCODEPAGE"] = "ANSI_1252"
    text = space.add_text("45%%d %%c8 %%p0.1 100%%% %%uÄ", dxfattribs={"height": 3, "rotation": 30, "insert": (5, 6), "layer": layer})
    scene.words.append((text, "45° Ø8 ±0.1 100% Ä", 0, 0, (5, 6), 30, 3))
    for across, code in enumerate(["LEFT", "CENTER", "RIGHT"]):
        for upright, prefix in enumerate(["", "BOTTOM_", "MIDDLE_", "TOP_"]):
            entity = space.add_text(f"{across}{upright}", dxfattribs={"height": 2}).set_pos((7, 8), align=prefix + code)
            scene.words.append((entity, f"{across}{upright}", across, upright, (7, 8), 0, 2))
    between = space.add_text("between", dxfattribs={"height": 2}).set_pos((0, 0), (3, 4), align="ALIGNED")
    scene.words.append((between, "between", 3, 0, (0, 0), math.degrees(math.atan2(4, 3)), 2))
    if not scene.is_old:
        mtext = space.add_mtext("{\\fArial|b1;Kerf} \\H2x;0.2\\Pline \\S1#2; \\{x\\} \\C1;\\~end",
                                dxfattribs={"char_height": 4, "insert": (1, 2), "rotation": 60, "attachment_point": 5})
        scene.words.append((mtext, "Kerf 0.2\nline 1/2 {x} \u00a0end", 1, 2, (1, 2), 60, 4))
        long = "abcdefghij" * 60
        scene.words.append((space.add_mtext(long, dxfattribs={"char_height": 1}), long, 0, 3, (0, 0), 0, 1))
    block = scene.doc.blocks.new("PLATE")
    block.add_attdef("SERIAL", (1, 1), dxfattribs={"height": 2})
    insert = space.add_blockref("PLATE", (50, 50))
    attribute = insert.add_attrib("SERIAL", "007", (51, 51), dxfattribs={"height": 2})
    scene.words.append((attribute, "007", 0, 0, (51, 51), 0, 2))
    scene.ignored["ATTDEF"] = 1
    scene.colours = {("TEXT", layer): {"#ff7f00"}}


def hidden(scene: Scene):
    space = scene.space
    scene.doc.layers.add("OFF").off()
    scene.doc.layers.add("COLD").freeze()
    space.add_line((0, 0), (1, 1), dxfattribs={"layer": "OFF"})
    space.add_circle((0, 0), 3, dxfattribs={"layer": "COLD"})
    space.add_arc((0, 0), 3, 0, 90, dxfattribs={"layer": "cold"})
    scene.ignored = {"layer OFF": 1, "layer COLD": 2}
    if not scene.is_old:
        scene.doc.layout("Layout1").add_line((0, 0), (9, 9))
        scene.ignored["paper space"] = 1
        space.add_xline((0, 0), (1, 1))
        space.add_ray((0, 0), (1, 1))
        space.add_leader([(0, 0), (5, 5)])
        space.add_mesh()
        scene.ignored |= {"XLINE": 1, "RAY": 1, "LEADER": 1, "MESH": 1}
    space.add_linear_dim(base=(3, 2), p1=(0, 0), p2=(3, 0)).render()
    space.add_polymesh((3, 3))
    scene.ignored |= {"DIMENSION": 1, "mesh": 1}
    scene.expect(space.add_line((0, 0), (2, 2)), chords([(0, 0), (2, 2)]))


SCENES = [curves, planes, blocks, hatches, words, hidden]


def found_paths(read: dict) -> list[tuple[str, shapes.Measure]]:
    return [(path["handle"], polyline(path["vertices"], path["closed"])) for path in read["paths"]]


def check_paths(scene: Scene, read: dict):
    found = found_paths(read)
    own = {name for name, _, _ in scene.paths if name}
    for handle in sorted(own):
        expected = [entry for entry in scene.paths if entry[0] == handle]
        yield from unmatched(expected, [item for item in found if item[0] == handle])
    yield from unmatched([entry for entry in scene.paths if not entry[0]], [item for item in found if item[0] not in own])


def check_words(scene: Scene, read: dict):
    by_handle = {text["handle"]: text for text in read["texts"]}
    if len(read["texts"]) != len(scene.words):
        yield f"{len(read['texts'])} texts, not {len(scene.words)}"
    for entity, expected, across, upright, at, angle, height in scene.words:
        text = by_handle.get(entity.dxf.handle)
        if text is None:
            yield f"no text {expected!r}"
            continue
        turn = math.radians(angle)
        matrix = [scene.mm * v for v in (math.cos(turn), math.sin(turn), -math.sin(turn), math.cos(turn), *at)]
        off = max(abs(a - b) for a, b in zip(matrix, text["to_mm"]))
        is_same = text["words"] == expected and text["height"] == height
        if not is_same or (text["across"], text["upright"]) != (across, upright) or off > EXACT * scene.mm:
            yield f"{expected!r} is {text}"


def check_rest(scene: Scene, read: dict, version: str):
    facts = read["files"][0]
    if facts["version"] != version:
        yield f"version {facts['version']}"
    if (facts["unit"], facts["scale_mm"]) != (NAMES[scene.unit], scene.mm):
        yield f"unit {facts['unit']} of {facts['scale_mm']} mm"
    if facts["ignored"] != scene.ignored:
        yield f"ignored {facts['ignored']}, not {scene.ignored}"
    codes = [finding["code"] for finding in read["findings"]]
    if codes != scene.codes:
        yield f"findings {read['findings']}, not {scene.codes}"
    for (kind, layer), colours in scene.colours.items():
        seen = {one["colour"] for one in read["paths"] + read["texts"] if (one["kind"], one["layer"]) == (kind, layer)}
        if seen != colours:
            yield f"{kind} on {layer} is {seen}, not {colours}"
    points = [tuple(point["at"]) for point in read["points"]]
    if any(math.dist(a, (scene.mm * b[0], scene.mm * b[1])) > EXACT for a, b in zip(points, scene.points, strict=True)):
        yield f"points {points}"


def check(scene: Scene, version: str, file: Path, reader: str):
    scene.doc.saveas(file)
    done = subprocess.run([reader, str(file)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        yield f"exit {done.returncode} {done.stderr}"
        return
    read = json.loads(done.stdout)
    yield from check_paths(scene, read)
    yield from check_words(scene, read)
    yield from check_rest(scene, read, version)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--reader", required=True)
    parser.add_argument("--keep", help="a folder in which the drawings stay")
    arguments = parser.parse_args()
    wrong = count = 0
    with tempfile.TemporaryDirectory() as folder:
        for release, version, unit in zip(RELEASES, VERSIONS, UNITS):
            for build in SCENES:
                scene = Scene(release, unit)
                build(scene)
                file = Path(arguments.keep or folder) / f"{build.__name__}-{release}.dxf"
                count += 1
                for complaint in check(scene, version, file, arguments.reader):
                    wrong += 1
                    print(f"{file.name}: {complaint}")
    print(f"{count} drawings, {wrong} differences")
    return 1 if wrong or count < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
