"""`kerf stock`: the files of the part. Surfaces are read here as other programs read them: corners at one place are one."""

import collections
import json
import re
import struct
import subprocess
import xml.etree.ElementTree as xml
import zipfile
from pathlib import Path

from harness import check, contains, equal, near, refused, status, test

PART = """O1
(T1 D=10. - flat end mill)
G90 G54
T1 M06
S3000 M03
G00 X10. Y20. Z5.
G01 Z-5. F500
X60.
G00 Z5.
G00 X70. Y30.
Z-8.
G00 X10.
G00 Z5.
M30
"""
TURNED = "O2\nT0101\nG97S1000M03\nG00X40.Z2.\nG01Z-20.F0.2\nG03X50.Z-25.R5.\nG00X60.\nM30\n"
SQUARE = "O3\nG90G54\nG00X0Y0\nM03S1000\nG01X20.F1500\nY20.\nX0\nY0\nM05\nM30\n"
TURNING_TOOL = '[[tool]]\nnumber = 1\ntype = "turning"\nnose_radius = 0\ntip = 3\nkapr = 95\ntip_angle = 80\nic = 40\n'


def folder_of(box):
    return Path(box.folder)


def stl_triangles(data):
    count = struct.unpack_from("<I", data, 80)[0]
    equal(len(data), 84 + 50 * count, "size of the STL")
    for i in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * i)
        yield numbers[3:6], numbers[6:9], numbers[9:12]


def sound(triangles, what):
    """Euler characteristic and volume of a surface, which must be closed and oriented."""
    places, edges, volume, seen = {}, collections.Counter(), 0, set()
    for triangle in triangles:
        a, b, c = (places.setdefault(tuple(p), len(places)) for p in triangle)
        check(len({a, b, c}) == 3, f"{what}: a triangle without area")
        check(frozenset((a, b, c)) not in seen, f"{what}: a triangle is there twice")
        seen.add(frozenset((a, b, c)))
        for edge in ((a, b), (b, c), (c, a)):
            edges[edge] += 1
        (x1, y1, z1), (x2, y2, z2), (x3, y3, z3) = triangle
        volume += (x1 * (y2 * z3 - y3 * z2) - y1 * (x2 * z3 - x3 * z2) + z1 * (x2 * y3 - x3 * y2)) / 6
    check(all(n == 1 and edges[(b, a)] == 1 for (a, b), n in edges.items()), f"{what}: an edge is open or crowded")
    return len(places) - len(edges) // 2 + len(seen), volume


def glb_triangles(data):
    magic, version, length = struct.unpack_from("<4sII", data)
    equal((magic, version, length), (b"glTF", 2, len(data)), "head of the GLB")
    size = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + size])
    binary = data[20 + size + 8:]

    def values(number, form, width):
        accessor = document["accessors"][number]
        begin = document["bufferViews"][accessor["bufferView"]]["byteOffset"]
        return list(struct.iter_unpack(form, binary[begin:begin + width * accessor["count"]]))

    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            points = values(primitive["attributes"]["POSITION"], "<3f", 12)
            equal(len(values(primitive["attributes"]["_MOTION"], "<f", 4)), len(points), "motions of points")
            indices = [i for (i,) in values(primitive["indices"], "<I", 4)]
            for i in range(0, len(indices), 3):
                yield tuple(points[k] for k in indices[i:i + 3])


def three_mf_triangles(path):
    name = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    with zipfile.ZipFile(path) as archive:
        equal(archive.testzip(), None, "the archive")
        model = xml.fromstring(archive.read("3D/3dmodel.model"))
    equal(model.get("unit"), "millimeter", "unit")
    for mesh in model.iter(name + "mesh"):
        points = [tuple(float(v.get(k)) for k in "xyz") for v in mesh.iter(name + "vertex")]
        for t in mesh.iter(name + "triangle"):
            yield tuple(points[int(t.get(k))] for k in ("v1", "v2", "v3"))


def cut(box, program, *words, exit_status=0):
    box.write("part.nc", program)
    result = box.kerf("stock", "part.nc", "--report", "report.json", *words)
    status(result, exit_status)
    return json.loads(box.read("report.json"))


def faults_of(path):
    """What another mesh library says of the edges as they are, none of them mended."""
    told = subprocess.run(["admesh", "--exact", str(path)], capture_output=True, text=True, check=True).stdout
    found = dict(re.findall(r"^(Total disconnected facets|Degenerate facets|Backwards edges|Facets reversed) *: *(\d+)", told, re.M))
    return {name: int(count) for name, count in found.items()}


BLOCK = ("--stock", "box:0,0,-20,70,40,0", "--cell", "1")


@test("the part as STL, GLB and 3MF is closed, oriented and has the volume of the report, whatever the model")
def solids(box):
    for model in ("zmap", "tridexel"):
        report = cut(box, PART, *BLOCK, "--model", model, "--stl", "p.stl", "--glb", "p.glb", "--3mf", "p.3mf",
                     "--fail-on", "never")
        folder = folder_of(box)
        for what, triangles in (("STL", stl_triangles((folder / "p.stl").read_bytes())),
                                ("GLB", glb_triangles((folder / "p.glb").read_bytes())),
                                ("3MF", three_mf_triangles(folder / "p.3mf"))):
            euler, volume = sound(triangles, f"{model} {what}")
            equal(euler, 2, f"{model} {what}: Euler characteristic")
            near(volume, report["left_mm3"], report["model"]["error_mm3"], f"{model} {what}: volume")
        equal(faults_of(folder / "p.stl"), {"Total disconnected facets": 0, "Degenerate facets": 0, "Backwards edges": 0,
                                            "Facets reversed": 0}, f"{model}: what admesh finds")


@test("with --triangles the part has no more of them, and stays closed, whatever the model")
def triangles(box):
    for words in (("--model", "zmap"), ("--model", "zmap", "--mesh", "exact"), ("--model", "tridexel")):
        for most in (3000, 400):
            report = cut(box, PART, *BLOCK, *words, "--triangles", str(most), "--stl", "p.stl", "--glb", "p.glb", "--fail-on", "never")
            for what, listed in (("STL", stl_triangles((folder_of(box) / "p.stl").read_bytes())),
                                 ("GLB", glb_triangles((folder_of(box) / "p.glb").read_bytes()))):
                listed = list(listed)
                check(len(listed) <= most, f"{what}: {len(listed)} triangles")
                euler, volume = sound(listed, f"{words} {what}")
                equal(euler, 2, "Euler characteristic")
                near(volume, report["left_mm3"], 2 * report["model"]["error_mm3"], f"{words} {most} {what}: volume")
    refused(box.kerf("stock", "part.nc", *BLOCK, "--triangles", "100"), 2, "without --stl")
    refused(box.kerf("stock", "part.nc", *BLOCK, "--triangles", "3", "--stl", "p.stl"), 2, "--triangles")


@test("files of the part have the same bytes whatever the threads, and nothing of a day or a place in them")
def same_bytes(box):
    names = ("p.stl", "p.glb", "p.3mf", "p.png")
    kept = []
    for jobs in ("1", "3"):
        cut(box, PART, *BLOCK, "--model", "tridexel", "--jobs", jobs, "--stl", "p.stl", "--glb", "p.glb", "--3mf", "p.3mf",
            "--picture", "p.png", "--fail-on", "never")
        kept.append([(folder_of(box) / name).read_bytes() for name in names])
    for name, one, other in zip(names, *kept):
        check(one == other, f"{name} depends on --jobs")


@test("--mesh exact is a height field's own steps, and has its volume to the last digits")
def steps(box):
    report = cut(box, PART, *BLOCK, "--stl", "p.stl", "--mesh", "exact", "--fail-on", "never")
    euler, volume = sound(stl_triangles((folder_of(box) / "p.stl").read_bytes()), "steps")
    equal(euler, 2, "Euler characteristic")
    near(volume, report["left_mm3"], 1e-5 * report["left_mm3"], "volume")


@test("a picture of the part is a PNG or an SVG; a finding has its number in it and a row below it")
def picture(box):
    cut(box, PART, *BLOCK, "--picture", "p.svg", exit_status=1)
    text = box.read("p.svg").decode()
    contains(text, "RAPID_IN_STOCK  line 12", "the list of findings")
    contains(text, "data:image/png;base64,", "the rendered part")
    for view in ("top", "front", "left", "1,2,0.5"):
        cut(box, PART, *BLOCK, "--picture", "p.png", "--view", view, exit_status=1)
        equal((folder_of(box) / "p.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n", view)
    for words in (("--view", "behind", "--picture", "p.png"), ("--view", "0,0,0", "--picture", "p.png"), ("--view", "top"),
                  ("--picture", "p.gif"), ("--profile", "p.dxf")):
        result = box.kerf("stock", "part.nc", *BLOCK, *words)
        refused(result, 2, words[0])


@test("a turned part is revolved, its contour is exact lines and arcs, its picture has a half section")
def turned(box):
    box.write("tools.toml", TURNING_TOOL)
    report = cut(box, TURNED, "--machine", "lathe2", "--stock", "bar:50,-80,0", "--tools", "tools.toml", "--stl", "p.stl",
                 "--profile", "p.csv", "--picture", "p.svg", "--fail-on", "never")
    euler, volume = sound(stl_triangles((folder_of(box) / "p.stl").read_bytes()), "turned")
    equal(euler, 2, "Euler characteristic")
    near(volume, report["left_mm3"], 1e-6 * report["left_mm3"], "volume: that of the profile, but for float32")
    rows = box.read("p.csv").decode().splitlines()
    equal(rows[0], "z,x,bulge", "head of the contour")
    contains(rows, "0,40,0", "the corner at the front has its diameter")
    check(any(abs(float(row.split(",")[2])) > 0.4 for row in rows[1:]), "the arc has a bulge")
    contains(box.read("p.svg").decode(), "half section", "the picture")
    cut(box, TURNED, "--machine", "lathe2", "--stock", "bar:50,-80,0", "--tools", "tools.toml", "--profile", "p.dxf", "--fail-on",
        "never")
    dxf = box.read("p.dxf").decode()
    contains(dxf, "POLYLINE", "DXF")
    check(dxf.endswith("0\nEOF\n"), "the DXF is whole")


@test("a sheet's pieces stand on their outlines, and the outline of what is left is written")
def sheet(box):
    report = cut(box, SQUARE, "--machine", "laser3", "--stock", "sheet:-10,-10,30,30,2", "--kerf", "0.2", "--stl", "p.stl",
                 "--profile", "p.csv", "--picture", "p.png")
    euler, volume = sound(stl_triangles((folder_of(box) / "p.stl").read_bytes()), "sheet")
    equal(euler, 2 * (2 - 1), "a frame with a handle, and the square")
    near(volume, 2 * (1600 - 15.9914159), 0.01, "volume, exact but for the chords of the corners")
    equal(box.read("p.csv").decode().splitlines()[0], "x,y,bulge", "head of the outline")
    equal(len(report["pieces"]), 2, "pieces")


@test("what an alarm left is written, and says so; a file that cannot be written is told before the run")
def whole(box):
    report = cut(box, PART.replace("G00 X70.", "G01 X#1000000 (wrong)\nG00 X70."), *BLOCK, "--stl", "p.stl", exit_status=1)
    equal(report["status"], "alarm", "status")
    euler, _ = sound(stl_triangles((folder_of(box) / "p.stl").read_bytes()), "behind an alarm")
    equal(euler, 2, "Euler characteristic")
    result = box.kerf("stock", "part.nc", *BLOCK, "--stl", "missing/p.stl")
    status(result, 3)
    refused(box.kerf("stock", "part.nc", *BLOCK, "--stl", "part.nc"), 2, "part.nc")
