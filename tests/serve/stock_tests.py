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
        self.head = None  # run and level of what is shown
        self.kind = None
        self.time_s = None

    def take(self):
        stock = [e for e in self.client.events if e["event"] == "stock"]
        for event in stock[self.events :]:
            if event.get("run", self.facts.get("run")) != self.facts.get("run"):
                self.facts, self.owners = {}, []
            self.facts.update(event)
            told = event.get("owners")
            if told:
                self.owners[told["from"] :] = told["rows"]
        self.events = len(stock)
        for frame in self.client.part_frames[self.frames :]:
            if frame.number == 0 or (frame.run, frame.level) != self.head:
                equal(frame.number, 0, "the first frame of a picture")
                self.tiles = {}
            self.head, self.kind, self.time_s = (frame.run, frame.level), frame.kind, frame.time_s
            if frame.kind == 2:
                if frame.tiles:
                    self.tiles = {0: frame.tiles}
                continue
            for tile in frame.tiles:
                self.tiles[tile["at"]] = tile
        self.frames = len(self.client.part_frames)
        return self

    def wait(self, condition, what, seconds=20):
        self.client.wait_for(lambda: condition(self.take()), what, seconds)
        return self

    def wait_for_end(self, seconds=30):
        return self.wait(lambda p: p.facts.get("done") and p.time_s == p.facts["done_s"], "the whole part", seconds)

    def at(self, time_s, level=0):
        """Shown at this time; the answer."""
        answer = self.client.do("stock_at", time_s=time_s, level=level)
        self.take()
        return answer

    def height(self, x, y):
        """Height and owner of a column of the level that is shown."""
        grid = self.facts["levels"][self.head[1]]
        i, j = (round((v - first) / cell) for v, first, cell in zip((x, y), grid["first"], grid["cell_mm"]))
        tile = self.tiles[i // 64, j // 64]
        k = j % 64 * tile["nx"] + i % 64
        return tile["z"][k], self.owners[tile["owner"][k]]

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
    part = shown(mill(place), set_up=SLOT_SET_UP).wait_for_end()
    coarse, fine = part.facts["levels"]
    check(max(coarse["cells"]) <= 400 and fine["cell_mm"][0] < coarse["cell_mm"][0], f"{coarse} {fine}")
    part.at(part.facts["done_s"], level=1)
    part.wait(lambda p: p.head[1] == 1 and len(p.tiles) == math.prod((n + 63) // 64 for n in fine["cells"]), "all tiles")
    z, owner = part.height(35, 20)
    check(abs(z + 5) < 1e-3 and owner == [0, 7, 1], f"{z} {owner}")
