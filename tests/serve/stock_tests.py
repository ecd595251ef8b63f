"""The part on the panel: cut by the server, seen at any time of the run."""

import math
import zlib

import harness  # noqa: F401
from harness import *  # noqa: F403

SLOT = (
    "O1 (SLOT)\n(T1 D=10. CR=0. - flat end mill)\nT1 M06\nS3000 M03\nG00 X10. Y20. Z5.\nG01 Z-5. F300\nX60. F600\nG00 Z5.\n"
    "X10. Y40.\nG01 Z-3. F300\nX60. F600\nG00 Z50.\nM30\n"
)
SLOT_SET_UP = '[stock]\nshape = "box:0,0,-20,70,60,0"\n'


class Part:
    """What a page would know: facts of the event, and the picture that the frames make."""

    def __init__(self, client):
        self.client = client
        self.facts = {}
        self.owners = []
        self.events = 0
        self.frames = 0
        self.tiles = {}
        self.told = {}  # what is known besides, by kind and tile
        self.head = None  # run and level of what is shown
        self.kind = None
        self.time_s = None

    def take(self):
        stock = [e for e in self.client.events if e["event"] == "stock"]
        for event in stock[self.events :]:
            if event.get("run", self.facts.get("run")) != self.facts.get("run"):
                self.facts, self.owners = {}, []
                self.time_s = None  # what is seen is of the run before
            self.facts.update(event)
            told = event.get("owners")
            if told:
                if told["from"] == 0:
                    self.owners = []
                check(told["from"] <= len(self.owners), f"rows from {told['from']} on, {len(self.owners)} are there")
                self.owners[told["from"] : told["from"] + len(told["rows"])] = told["rows"]
        self.events = len(stock)
        for frame in self.client.part_frames[self.frames :]:
            if frame.kind == 4:
                equal((frame.run, frame.level), self.head, "facts are of what is shown")
                self.told.update({(fact["what"], fact["at"]): fact for fact in frame.tiles})
                continue
            if frame.number == 0 or (frame.run, frame.level) != self.head:
                equal(frame.number, 0, "the first frame of a picture")
                self.tiles, self.told = {}, {}
            self.head, self.kind = (frame.run, frame.level), frame.kind
            self.time_s = frame.time_s if frame.run == self.facts.get("run") else None
            if frame.kind == 2:
                if frame.tiles:
                    self.tiles, self.told = {0: frame.tiles}, {}
                continue
            for tile in frame.tiles:
                self.tiles[tile["at"]] = tile
                self.told.pop(("deviation", (*tile["at"], 0)[:3]), None)
        self.frames = len(self.client.part_frames)
        return self

    def wait(self, condition, what, seconds=20):
        self.client.wait_for(lambda: condition(self.take()), what, seconds)
        return self

    def wait_for_end(self, seconds=30):
        return self.wait(lambda p: p.facts.get("done") and p.time_s == p.facts["done_s"], "the whole part", seconds)

    def at(self, time_s, **wish):
        """Shown at this time; the answer."""
        answer = self.client.do("stock_at", time_s=time_s, **wish)
        self.take()
        return answer

    def column(self, x, y):
        """The tile that a column of the level that is shown is in, and its number there."""
        grid = self.facts["levels"][self.head[1]]
        i, j = (round((v - first) / cell) for v, first, cell in zip((x, y), grid["first"], grid["cell_mm"]))
        tile = self.tiles[i // 64, j // 64]
        return tile, j % 64 * tile["nx"] + i % 64

    def height(self, x, y):
        """Height of a column, and file, line and tool that cut it."""
        tile, k = self.column(x, y)
        return tile["z"][k], self.owners[tile["owner"][k]][:3]

    def picture(self):
        """Its tiles, each as a number that other bytes do not have."""
        return {at: zlib.crc32(repr(tile).encode()) for at, tile in self.tiles.items()}


def shown(client, text=SLOT, name="part.nc", set_up=None):
    """Loads a program, sets it up, and asks to see its part."""
    client.load(text, name)
    if set_up is not None:
        client.do("stock", toml=set_up)
    client.part_frames.clear()
    part = Part(client)
    client.do("stock", shows=True)
    return part


def mill(place, name="miller", definition="mill3"):
    client = place.serve().client()
    client.do("create", name=name, definition=definition)
    return client.watch(name)


@test("the part of a mill is seen as it is at the end, with who cut it")
def _(place):
    part = shown(mill(place), set_up=SLOT_SET_UP).wait_for_end()
    equal((part.facts["model"], part.facts["error"], part.facts["findings"]), ("zmap", None, []), "facts")
    equal((part.facts["stock"]["low"], part.facts["stock"]["high"]), ([0, 0, -20], [70, 60, 0]), "the stock")
    z, owner = part.height(35, 20)
    check(abs(z + 5) < 1e-3, f"the floor of the slot is at {z}")
    equal(owner, [0, 7, 1], "file, line and tool that cut it")
    z, owner = part.height(35, 40)
    check(abs(z + 3) < 1e-3 and owner == [0, 11, 1], f"the second slot: {z}, {owner}")
    z, owner = part.height(35, 30)
    check(abs(z) < 1e-3 and owner == [0, 0, 0], f"nobody cut here: {z}, {owner}")
    slots = 10 * 50 + math.pi * 25
    check(abs(part.facts["removed_mm3"] - 8 * slots) < 0.01 * 8 * slots, f"removed {part.facts['removed_mm3']}")
    equal(part.facts["files"], ["part.nc"], "files")


@test("a part is seen at any time, there and back with the same bytes, and what is removed is that up to there")
def _(place):
    client = mill(place)
    part = shown(client, set_up=SLOT_SET_UP).wait_for_end()
    end = part.facts["done_s"]
    pictures = {}
    for share in (0.5, 0.2, 0.8, 0.35, 1, 0):
        answer = part.at(share * end)
        equal(answer["time_s"], share * end, "time that is shown")
        pictures[share] = (part.picture(), part.facts["removed_mm3"])
    for share in (0.35, 0.8, 0, 0.5, 1, 0.2):
        part.at(share * end)
        equal((part.picture(), part.facts["removed_mm3"]), pictures[share], f"the part at {share}")
    removed = [pictures[share][1] for share in sorted(pictures)]
    equal(removed[0], 0, "removed before the first cut")
    check(removed == sorted(removed) and removed[1] < removed[-1], f"it grows: {removed}")
    # A second one who looks for the first time sees the same.
    other = Client(place.servers[0])
    other.watch("miller", operate=False)
    seen = Part(other)
    other.do("stock", shows=True)
    seen.wait(lambda p: p.facts.get("done") and p.time_s is not None, "his part")
    seen.at(0.35 * end)
    equal(seen.picture(), pictures[0.35][0], "what the other one sees")


@test("only what has changed is sent, and a first picture has at most 4 MiB")
def _(place):
    client = mill(place)
    part = shown(client, set_up=SLOT_SET_UP).wait_for_end()
    first = sum(frame.bytes for frame in client.part_frames)
    check(first <= 4 << 20, f"{first} bytes")
    end = part.facts["done_s"]
    part.at(0.9 * end)
    sent = len(client.part_frames)
    part.at(0.9 * end)
    equal(len(client.part_frames), sent, "frames of what is seen already")
    part.at(0.9 * end + 0.01)
    step = client.part_frames[sent:]
    tiles = [tile["at"] for frame in step for tile in frame.tiles]
    check(len(tiles) <= 2, f"a hundredth of a second changes {tiles}")


@test("finer cells are there when they are asked for")
def _(place):
    wide = '[stock]\nshape = "box:0,0,-20,400,60,0"\n'
    part = shown(mill(place), set_up=wide).wait_for_end()
    coarse, fine = part.facts["levels"]
    check(max(coarse["cells"]) <= 500 and fine["cell_mm"][0] < coarse["cell_mm"][0], f"{coarse} {fine}")
    part.at(part.facts["done_s"], level=1)
    part.wait(lambda p: p.head[1] == 1 and len(p.tiles) == math.prod((n + 63) // 64 for n in fine["cells"]), "all tiles")
    z, owner = part.height(35, 20)
    check(abs(z + 5) < 1e-3 and owner == [0, 7, 1], f"{z} {owner}")


LATHE = (
    "O2\nG50 S2000\nG97 S500 M03\nT0101\nG00 X52. Z2.\nG01 X40. F0.3\nZ-30.\nX52.\nG00 Z2.\nX30.\nG01 Z-10.\nX52.\nG00 X80. Z20.\nM30\n"
)
LATHE_SET_UP = '[stock]\nshape = "bar:50,-60,0"\n[[tool]]\nnumber = 1\ntype = "turning"\nnose_radius = 0\ntip = 3\nic = 40\nkapr = 95\ntip_angle = 80\n'


def area(loops):
    """Of closed lines without arcs, mm²."""
    return sum(
        (a[0] * b[1] - b[0] * a[1]) / 2 for loop in loops for a, b in zip(loop, loop[1:] + loop[:1])
    )


@test("the part of a lathe is its half section, and comes back")
def _(place):
    client = place.serve().client()
    client.do("create", name="turner", definition="lathe2")
    part = shown(client.watch("turner"), LATHE, "shaft.nc", LATHE_SET_UP).wait_for_end()
    equal((part.facts["model"], part.kind, part.facts["levels"]), ("profile", 2, [None]), "facts")
    whole, turned = 60 * 25, 60 * 25 - 30 * 5 - 10 * 5
    check(abs(area(part.tiles[0]) - turned) < 1e-6, f"area {area(part.tiles[0])}")
    volume = math.pi * (30 * (25**2 - 20**2) + 10 * (20**2 - 15**2))
    check(abs(part.facts["removed_mm3"] - volume) < 1e-6 * volume, f"removed {part.facts['removed_mm3']}")
    end = part.facts["done_s"]
    part.at(0)
    check(abs(area(part.tiles[0]) - whole) < 1e-9, "the bar")
    equal(part.facts["removed_mm3"], 0, "removed at the beginning")
    part.at(0.4 * end)
    then = part.tiles[0]
    check(turned < area(then) < whole, f"area {area(then)}")
    part.at(end)
    part.at(0.4 * end)
    equal(part.tiles[0], then, "the same half section")


TILTED = (
    "O3\n(T1 D=10. CR=0. - flat end mill)\nT1 M06\nS3000 M03\nG00 A30. X0 Y0 Z30.\nG01 Z-5. F600\nX40.\nG00 Z30.\nM30\n"
)


@test("the part of a tilted cut is made of triangles, of which only those that change are sent")
def _(place):
    client = mill(place, "five", "mill5")
    set_up = '[stock]\nshape = "box:-10,-30,-30,50,30,0"\n'
    part = shown(client, TILTED, "tilted.nc", set_up).wait_for_end(60)
    equal((part.facts["model"], part.kind, part.facts["error"]), ("tridexel", 1, None), "facts")
    check(sum(f.bytes for f in client.part_frames) <= 4 << 20, "the first picture")
    check(abs(part.facts["removed_mm3"] - 2392.69908) < 60, f"removed {part.facts['removed_mm3']}")
    part.at(part.facts["done_s"])  # all of it: a picture may take more than one frame
    check(abs(mesh_volume(part.tiles.values()) - (60 * 60 * 30 - part.facts["removed_mm3"])) < 60,
          f"the triangles enclose {mesh_volume(part.tiles.values())} mm³")
    equal({o for t in part.tiles.values() for o in t["owner"]}, {0, 1, 2}, "who cut them")
    end = part.facts["done_s"]
    at_half = part.at(0.7 * end) and part.picture()
    part.at(0.5 * end)
    part.at(0.7 * end)
    equal(part.picture(), at_half, "the same triangles")
    sent = len(client.part_frames)
    part.at(0.7 * end + 0.01)
    step = [tile["at"] for frame in client.part_frames[sent:] for tile in frame.tiles]
    check(len(step) < len(part.tiles) / 2, f"{len(step)} of {len(part.tiles)} tiles")


def mesh_volume(tiles):
    six = 0
    for tile in tiles:
        p, index = tile["points"], tile["index"]
        for a, b, c in zip(index[::3], index[1::3], index[2::3]):
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = p[a], p[b], p[c]
            six += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return six / 6


LASER = (
    "G21 G90\nG00 X10 Y10\nM03 S1000\nG01 X30 F1200\nY30\nX10\nY10\nM05\nG00 X0 Y0\nM30\n"
)


@test("a sheet under a beam shows where it is cut, and its energy")
def _(place):
    client = place.serve().client()
    client.do("create", name="beam", definition="laser3")
    program = "LASER 100\nSPEED(20)\nPOWER(80)\nMOVE(10,10,0)\nLINE(30,10,0)\nLINE(30,30,0)\nLINE(10,30,0)\nLINE(10,10,0)\nEND\n"
    part = shown(client.watch("beam"), program.replace("LASER 100\n", ""), "square.bas", '[stock]\nshape = "sheet:0,0,40,40,2"\n')
    part.wait_for_end()
    equal((part.facts["model"], part.kind, part.facts["error"]), ("sheet", 3, None), "facts")
    cut = sum(sum(t["coverage"]) for t in part.tiles.values()) / 255
    grid = part.facts["levels"][0]
    kerf = cut * grid["cell_mm"][0] * grid["cell_mm"][1] / 80
    check(0.01 < kerf < 1, f"the kerf is {kerf} wide")
    check(abs(part.facts["removed_mm3"] - 2 * 80 * kerf) < 0.01 * 160 * kerf, f"removed {part.facts['removed_mm3']}")
    check(all(max(t["energy"]) == 255 for t in part.tiles.values() if t["full"] > 0), "energy fills its scale")
    whole = part.picture()
    end = part.facts["done_s"]
    part.at(end / 2)
    half = part.facts["removed_mm3"]
    check(0 < half < 0.8 * 160 * kerf, f"half of it: {half}")
    part.at(end)
    equal(part.picture(), whole, "the same sheet")


CRASH = SLOT.replace("G00 Z5.\nX10. Y40.\n", "G00 Y40.\nZ5.\nX10.\n")


@test("a finding has its line, its time and its place")
def _(place):
    part = shown(mill(place), CRASH, "crash.nc", SLOT_SET_UP).wait_for_end()
    (finding,) = part.facts["findings"]
    equal((finding["code"], finding["severity"], finding["file"], finding["line"], finding["tool"]),
          ("RAPID_IN_STOCK", "error", "crash.nc", 8, 1), "the finding")
    check(0 < finding["time_s"] < part.facts["done_s"], f"at {finding['time_s']} s")
    x, y, z = finding["at"]
    check(55 <= x <= 66 and 20 <= y <= 46 and -5.1 <= z <= 0, f"at {finding['at']}")
    check(finding["count"] == 1 and finding["depth_mm"] > 4 and finding["volume_mm3"] > 100, f"{finding}")


@test("what a set-up says is kept with the program, and one that is none is refused")
def _(place):
    server = place.serve()
    client = server.client()
    client.do("create", name="miller", definition="mill3")
    client.watch("miller")
    says(client.refused("stock", toml=""), "no program")
    client.load(SLOT, "part.nc")
    answer = client.do("stock")
    equal((answer["toml"], answer["is_default"]), ("", True), "of nobody")
    for toml, *words in (
        ("[stock]\nshape = \n", "2"),
        ("[stuck]\nshape = 'extents'\n", "stuck"),
        ("[stock]\nshape = 'box:0,0'\n", "box"),
        ("[stock]\nshape = 'ball:5'\n", "ball:5"),
        ("[[fixture]]\nname = 'jaw'\n", "shape"),
        ("[[tool]]\nnumber = 1\ntype = 'ball:5'\n", "ball:5"),
        ("[[tool]]\nnumber = 1\ntype = 'bull'\ndiameter = 4\ncorner_radius = 3\n", "corner"),
        ("[checks]\nno_check = ['NOTHING']\n", "NOTHING"),
        ("[stock]\nshape = '../../machines/miller/machine.toml'\n", ".."),
        ("[stock]\nshape = '/etc/passwd.stl'\n", "/etc/passwd.stl"),
    ):
        says(client.refused("stock", toml=toml), *words)
    equal(client.do("stock")["toml"], "", "nothing was kept")
    whole = SLOT_SET_UP + "zero = 'G54'\nplace = [0, 0, 0]\n[[fixture]]\nshape = 'box:-20,0,-20,-5,60,10'\nname = 'jaw'\n" \
        "[material]\ngroup = 'P'\n[checks]\nno_check = ['RAPID_IN_STOCK']\n[[tool]]\nnumber = 1\ntype = 'flat'\ndiameter = 10\n"
    client.do("stock", toml=whole)
    equal((client.do("stock")["toml"], client.do("stock")["is_default"]), (whole, False), "what is kept")
    client.load(CRASH, "other.nc")
    equal(client.do("stock")["is_default"], True, "of another program")
    server.stop()
    again = place.serve().client().watch("miller")
    again.load(CRASH, "part.nc")
    equal(again.do("stock")["toml"], whole, "after the server has begun anew")
    part = Part(again)
    again.do("stock", shows=True)
    part.wait_for_end()
    equal(part.facts["findings"], [], "a check that is left out finds nothing")


@test("a set-up given while the part is shown has it cut anew")
def _(place):
    client = mill(place)
    part = shown(client, set_up=SLOT_SET_UP).wait_for_end()
    run = part.facts["run"]
    client.do("stock", toml='[stock]\nshape = "box:0,0,-4,70,60,0"\n')
    part.wait(lambda p: p.facts["run"] != run and p.facts.get("done") and p.time_s == p.facts["done_s"], "the new part")
    equal(part.facts["stock"]["low"], [0, 0, -4], "the new stock")
    z, owner = part.height(35, 20)
    equal((z, owner), (None, [0, 7, 1]), "the slot goes through")


@test("a probe tells place, tool and line")
def _(place):
    client = mill(place)
    shown(client, set_up=SLOT_SET_UP).wait_for_end()
    answer = client.do("stock_probe", x=35, y=20, z=3)
    equal(answer["owner"], {"file": 0, "line": 7, "tool": 1, "motion": answer["owner"]["motion"]}, "who cut there")
    check(abs(answer["at"][2] + 5) < 1e-6, f"{answer['at']}")
    equal(client.do("stock_probe", x=35, y=30, z=0)["owner"], None, "where nobody has cut")
    equal(client.do("stock_probe", x=500, y=30, z=0)["at"], None, "beside the part")


def relief(lines):
    """So many short moves over a wave."""
    text = ["O9", "(T1 D=6. CR=3. - ball end mill)", "T1 M06", "S6000 M03", "G00 X0 Y0 Z10.", "G01 Z0 F3000"]
    for i in range(lines):
        row, k = divmod(i, 400)
        x = 0.25 * (k if row % 2 == 0 else 400 - k)
        text.append(f"X{x:.3f} Y{0.4 * row:.3f} Z{-3 + 2 * math.sin(x / 8 + row / 9):.3f}")
    return "\n".join(text + ["G00 Z20.", "M30", ""])


@test("who takes slowly gets the newest state, not each, and nobody waits for him")
def _(place):
    server = place.serve()
    client = server.client()
    client.do("create", name="miller", definition="mill3")
    client.watch("miller")
    client.load(relief(40_000), "relief.nc")
    slow = Client(server, receive_buffer=4096).watch("miller", operate=False)
    slow.do("stock", shows=True)
    quick = Part(client)
    client.do("stock", shows=True)
    quick.wait_for_end(60)
    end = quick.facts["done_s"]
    for i in range(30):
        quick.at(end * (i % 7) / 7)  # the slow one takes nothing meanwhile
    seen = Part(slow)
    answer = slow.do("stock_at", time_s=end / 2)
    equal(answer["time_s"], end / 2, "what the slow one asks for comes")
    seen.take()
    quick.at(end / 2)
    equal(seen.picture(), quick.picture(), "both see the same")
    check(len(slow.part_frames) < 40, f"{len(slow.part_frames)} frames for the slow one")


@test("what is behind the machine says so, and comes")
def _(place):
    client = mill(place)
    client.load(relief(25_000), "relief.nc")
    part = Part(client)
    client.do("stock", shows=True)
    answer = client.do("stock_at", time_s=1e6)
    part.take()
    if not part.facts.get("done"):
        check(answer["behind"], f"it is not cut as far: {answer}")
    part.wait_for_end(60)
    equal(part.facts["behind"], True, "nobody ever comes to a million seconds")
    check(not client.do("stock_at", time_s=part.facts["done_s"] / 3)["behind"], "not behind")


@test("who hides the part gets no more of it, and it ends with the last one who looks")
def _(place):
    client = mill(place)
    shown(client, set_up=SLOT_SET_UP).wait_for_end()
    client.do("stock", shows=False)
    says(client.refused("stock_at", time_s=1), "nothing is shown")
    frames = len(client.part_frames)
    client.load(CRASH, "part.nc")
    client.do("ping")
    equal(len(client.part_frames), frames, "frames of what is hidden")
    client.do("stock", shows=True)
    part = Part(client)
    part.wait_for_end()


@test("a part that cannot be cut says why in a sentence")
def _(place):
    client = place.serve().client()
    client.do("create", name="engraver-arm", definition="arm4")
    client.watch("engraver-arm")
    client.load("MOVE(10,10,0)\nEND\n", "arm.bas")
    part = Part(client)
    client.do("stock", shows=True)
    part.wait(lambda p: p.facts.get("error"), "the sentence")
    says(part.facts["error"]["message"], "stock is cut on mills, lathes and lasers")
