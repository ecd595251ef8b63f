"""Whether a posted program cuts what the run cut, however its reader stood before.

Moves are dictionaries: kind (`rapid`, `line`, `arc`, `space-arc`, `burn`: a dwell with the beam), `from` and `to`, of an arc plane,
centre, direction and turns; `feed` in mm/min or None; `s`: what spindle or beam had, 0 off. Those of
a run come from --motion, those of a reader from --motion or from LinuxCNC's rs274.
"""

import math
import os
import re
import shutil
import subprocess
from pathlib import Path

from harness import Skipped, check

# --post writes four decimals and rs274 prints four: an end is off by half a digit of each along each
# axis. Kerf reads a FANUC's three decimals: half of such a digit more.
RS274_MM = 2e-4
KERF_MM = RS274_MM + 1.2e-3  # five axes
# Of the centre of an arc both coordinates are off, and its radii differ by as much as --post lets them.
RADII_MM = 5e-4
CHORD_MM = 1e-3
FEED = 2e-4
NORMAL = {"XY": "Z", "ZX": "Y", "YZ": "X"}
LOOKS = 8  # at a piece of the way


def of_records(records, length_at=lambda record: 0, laser=False, start=None):
    """The moves of a run by its --motion. `length_at`: what tool length adds to Z at a record;
    it is asked of every one, in order. `start`: where the machine stands, if that is not at 0."""
    at, s, moves = start, 0, []
    for record in records:
        kind = record["kind"]
        added = length_at(record)
        if kind == "spindle" and not laser:
            s = {"cw": 1, "ccw": -1}.get(record["direction"], 0) * record["speed"]
        if kind == "power" and laser:
            s = 10 * record["percent"] * record.get("beam", True) * (-1 if record.get("follows_speed") else 1)
        if kind == "dwell" and laser and s != 0:
            place = raised(at or {}, added)
            moves.append({**record, "kind": "burn", "s": s, "from": place, "to": place})
        if "to" not in record:
            continue
        at = at or dict.fromkeys(record["to"], 0.0)
        move = {**record, "kind": {"probe": "line", "thread": "line"}.get(kind, kind), "s": s,
                "from": raised(at, added), "to": raised(record["to"], added)}
        for point in ("via", "second_via"):
            if point in record:
                move[point] = raised(record[point], added)
        if added and kind == "arc" and "Z" in record["plane"]:
            move["center"] = [c + added * (axis == "Z") for axis, c in zip(record["plane"], record["center"])]
        if added and kind == "space-arc":
            move["center"] = [*record["center"][:2], record["center"][2] + added]
        if record.get("feed_mode") != "per-minute":
            move["feed"] = None
        moves.append(move)
        at = record["to"]
    return moves


def raised(point, added):
    return {**point, "Z": point["Z"] + added} if added else point


class Rs274:
    """What LinuxCNC's interpreter makes of a program."""

    def __init__(self, folder, name, laser=False, table=None):
        self.laser = laser
        if not shutil.which("rs274"):
            raise Skipped("rs274 of LinuxCNC (linuxcnc-uspace) is not installed")
        program = Path(folder, name).read_text()
        tools = sorted(set(re.findall(r"^T(\d+) M6$", program, re.MULTILINE)), key=int)
        if table is None:
            table = "tools.tbl"
            Path(folder, table).write_text("".join(f"T{tool} P{tool} D1 Z0 ;\n" for tool in tools))
        home = {**os.environ, "HOME": str(folder)}  # where it keeps the tools of a run
        result = subprocess.run(["rs274", "-g", "-t", table, name], cwd=folder, env=home,
                                capture_output=True, text=True, timeout=120, check=False)
        check(result.returncode == 0 and "error" not in result.stderr.lower(),
              f"rs274 refuses the posted program: {(result.stderr or result.stdout)[-300:]}")
        check("PROGRAM_END" in result.stdout, "rs274 does not come to the end of the program")
        self.moves = []
        self.plane, self.feed, self.s, self.turning = "XY", 0.0, 0.0, 0
        self.at = dict.fromkeys("XYZABC", 0.0)
        self.scale = 1.0  # mm of a unit
        for call, text in re.findall(r"^\s*\d+ \S+\s+(\w+)\((.*)\)$", result.stdout, re.MULTILINE):
            self.take(call, [word.strip() for word in text.split(",")])

    def take(self, name, words):
        if name == "SELECT_PLANE":
            self.plane = {"XY": "XY", "XZ": "ZX", "YZ": "YZ"}[words[0][-2:]]
        elif name == "USE_LENGTH_UNITS":
            scale = 25.4 if "INCH" in words[0] else 1.0
            self.at = {axis: value * (self.scale / scale if axis in "XYZ" else 1)
                       for axis, value in self.at.items()}
            self.scale = scale
        elif name == "SET_FEED_RATE":
            self.feed = float(words[0])
        elif name == "SET_SPINDLE_SPEED":
            self.s = float(words[-1])
        elif name.startswith(("START_SPINDLE", "STOP_SPINDLE")):
            self.turning = 0 if name.startswith("STOP") else -1 if "COUNTER" in name else 1
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            kind = "rapid" if name.endswith("TRAVERSE") else "line"
            to = dict(zip("XYZABC", map(float, words)))
            if kind == "rapid" or to != self.at:  # G1 alone turns a beam on where it stands
                self.add({"kind": kind, "to": to})
        elif name == "DWELL" and self.laser and self.turning != 0:
            self.add({"kind": "burn", "to": self.at, "seconds": float(words[0])})
        elif name == "ARC_FEED":
            self.arc([float(word) for word in words])

    def arc(self, words):
        first, second = self.plane
        to = dict(zip("ABC", words[6:9]), **{first: words[0], second: words[1],
                                             NORMAL[self.plane]: words[5]})
        self.add({"kind": "arc", "to": to, "center": words[2:4], "plane": self.plane, "turns": 0,
                  "direction": "ccw" if words[4] > 0 else "cw"})
        check(abs(words[4]) == 1, "an arc of more than a turn")

    def add(self, move):
        self.moves.append({**move, "from": self.at, "feed": self.feed, "s": self.s * self.turning})
        self.at = move["to"]


def distance(a, b, axes):
    return math.sqrt(sum((a[axis] - b[axis]) ** 2 for axis in axes))


class Way:
    """The way of a cut by the share of it that is done, 0 to 1."""

    def __init__(self, move):
        self.start, self.end, self.kind = move["from"], move["to"], move["kind"]
        self.axes = [axis for axis in self.end if axis in self.start]
        self.sweep = 0.0
        if self.kind == "arc":
            self.plane_arc(move)
        elif self.kind == "space-arc":
            self.space_arc(move)
        else:
            self.length = distance(self.start, self.end, self.axes)

    def plane_arc(self, move):
        first, second = move["plane"]
        self.in_plane = first, second
        u, v = self.centre = move["center"]
        a = math.atan2(self.start[second] - v, self.start[first] - u)
        b = math.atan2(self.end[second] - v, self.end[first] - u)
        self.sign = 1 if move["direction"] == "ccw" else -1
        closed = (self.start[first], self.start[second]) == (self.end[first], self.end[second])
        part = 0 if closed else (self.sign * (b - a)) % (2 * math.pi)
        self.begin_rad = a
        self.sweep = (part or 2 * math.pi) + 2 * math.pi * move["turns"]
        self.radii = [math.hypot(p[first] - u, p[second] - v) for p in (self.start, self.end)]
        beside = [axis for axis in self.axes if axis not in self.in_plane]
        self.length = math.hypot(self.sweep * max(self.radii), self.radii[1] - self.radii[0],
                                 distance(self.start, self.end, beside))

    def space_arc(self, move):
        self.centre, normal = move["center"], move["normal"]
        xyz = [axis for axis in "XYZ" if axis in self.end]
        arm = [self.start[axis] - c for axis, c in zip(xyz, self.centre)]
        radius = math.hypot(*arm)
        e1 = [a / radius for a in arm]
        e2 = [normal[1] * e1[2] - normal[2] * e1[1], normal[2] * e1[0] - normal[0] * e1[2],
              normal[0] * e1[1] - normal[1] * e1[0]]
        self.frame, self.radii, self.sweep = (e1, e2), [radius, radius], math.radians(move["sweep_deg"])
        self.length = radius * self.sweep
        knots = [(0.0, self.start)]
        for point in ("via", "second_via"):
            if point in move:
                knots.append((self.angle(move[point]) % (2 * math.pi), move[point]))
        self.knots = [*knots, (self.sweep, self.end)]

    def angle(self, point):
        if self.kind == "arc":
            first, second = self.in_plane
            a = math.atan2(point[second] - self.centre[1], point[first] - self.centre[0])
            return self.sign * (a - self.begin_rad)
        arm = [point[axis] - c for axis, c in zip("XYZ", self.centre)]
        along = [sum(a * b for a, b in zip(arm, e)) for e in self.frame]
        return math.atan2(along[1], along[0])

    def share_of(self, point, behind, digits_mm):
        """Where the point lies, not before the share `behind` but for what digits are worth."""
        if self.sweep == 0:
            ways = [self.end[axis] - self.start[axis] for axis in self.axes]
            square = sum(way * way for way in ways)
            done = sum(way * (point[axis] - self.start[axis]) for axis, way in zip(self.axes, ways))
            return min(1.0, max(0.0, done / square)) if square else 1.0
        slack = 3 * digits_mm / max(self.radii)
        angle = self.angle(point) % (2 * math.pi)
        while angle < behind * self.sweep - slack:
            angle += 2 * math.pi
        # Just before the start is where it starts.
        if angle - 2 * math.pi >= behind * self.sweep - slack:
            angle -= 2 * math.pi
        return self.nearer(point, min(1.0, max(0.0, angle / self.sweep)))

    def nearer(self, point, share):
        """On a steep helix the nearest place is not that of the same angle, and at a point where the rates of
        the rotary axes change at once each side has rates of its own."""
        off = lambda place: distance(point, self.at(place), self.axes)
        return min((share, *(self.moved(point, share, step) for step in (-1e-4, 1e-4))), key=off)

    def moved(self, point, share, step):
        """Nearer, by the rates between there and a step further."""
        here, there = self.at(share), self.at(share + step)
        ways = {axis: (there[axis] - here[axis]) / step for axis in self.axes}
        square = sum(way * way for way in ways.values())
        back = sum((point[axis] - here[axis]) * way for axis, way in ways.items())
        return min(1.0, max(0.0, share + back / square)) if square else share

    def at(self, share):
        point = {axis: self.start[axis] + share * (self.end[axis] - self.start[axis]) for axis in self.axes}
        if self.kind == "arc":
            angle = self.begin_rad + self.sign * share * self.sweep
            radius = self.radii[0] + share * (self.radii[1] - self.radii[0])
            first, second = self.in_plane
            point[first] = self.centre[0] + radius * math.cos(angle)
            point[second] = self.centre[1] + radius * math.sin(angle)
        elif self.kind == "space-arc":
            self.in_space(point, share * self.sweep)
        return point

    def in_space(self, point, angle):
        e1, e2 = self.frame
        for (a, p), (b, q) in zip(self.knots, self.knots[1:]):
            if angle <= b or (b, q) == self.knots[-1]:
                part = (angle - a) / (b - a) if b > a else 1.0
                point.update({axis: p[axis] + part * (q[axis] - p[axis]) for axis in self.axes})
                break
        for i, axis in enumerate("XYZ"):
            point[axis] = self.centre[i] + self.radii[0] * (math.cos(angle) * e1[i] + math.sin(angle) * e2[i])


class Comparison:
    """Follows the moves of a run with those of a reader: every cut is made in order along its way, with
    its feed and its spindle or beam, and nothing else is cut. Rapids behind the first cut end where
    those of the run do; those before it may be others. `laser`: rapids have no beam; `digits_mm`: what those of the reader are worth."""

    def __init__(self, run, read, laser=False, digits_mm=RS274_MM):
        self.read, self.next, self.laser, self.digits_mm = read, 0, laser, digits_mm
        self.begun = False
        for move in run:
            self.where = f"line {move['line']}, {move['kind']} to {move['to']}"
            if move["kind"] == "rapid":
                self.rapid(move)
            elif move["kind"] == "burn":
                self.burn(move)
            else:
                self.cut(move)
        self.where = "behind the last cut"
        check(all(self.pull()["kind"] == "rapid" for _ in range(len(read) - self.next)),
              f"{self.where}: something is cut")

    def peek(self):
        return self.read[self.next] if self.next < len(self.read) else None

    def pull(self):
        move = self.peek()
        check(move is not None, f"{self.where}: the reader makes no move")
        self.next += 1
        if move["kind"] == "rapid":
            check(not self.laser or move["s"] == 0, f"{self.where}: the beam is on in a rapid to {move['to']}")
        return move

    def rapid(self, wanted):
        if not self.begun:
            return
        axes = list(wanted["to"])
        if self.next and distance(self.read[self.next - 1]["to"], wanted["to"], axes) <= self.digits_mm:
            return  # it stands there: less than a digit, or G53 to where the length had brought it
        while True:
            move = self.pull()
            check(move["kind"] == "rapid", f"{self.where}: the reader cuts to {move['to']}")
            if distance(move["to"], wanted["to"], axes) <= self.digits_mm:
                return

    def go_to(self, start):
        """With rapids."""
        self.begun = True
        while self.peek() and self.peek()["kind"] == "rapid":
            self.pull()
        stands = self.read[self.next - 1]["to"] if self.next else dict.fromkeys(start, 0.0)
        axes = [axis for axis in start if axis in stands]
        check(distance(stands, start, axes) <= self.digits_mm, f"{self.where}: begins at {stands}, wanted {start}")

    def burn(self, wanted):
        self.go_to(wanted["to"])
        move = self.pull()
        check(move["kind"] == "burn", f"{self.where}: wanted a burn, the reader makes {move}")
        check(abs(move["seconds"] - wanted["seconds"]) <= 1e-4, f"{self.where}: {move['seconds']} s, wanted {wanted['seconds']} s")
        check(abs(move["s"] - wanted["s"]) <= 1e-3, f"{self.where}: S{move['s']}, wanted {wanted['s']}")

    def cut(self, wanted):
        way = Way(wanted)
        self.go_to(way.start)
        if way.length < 2 * self.digits_mm and not self.is_short_cut_to(way):
            return
        share = 0.0
        while True:
            piece = self.pull()
            check(piece["kind"] not in ("rapid", "burn"), f"{self.where}: the reader makes a {piece['kind']} to {piece['to']} at {share:.4f} of it")
            self.manner(piece, wanted)
            share = self.follow(Way(piece), way, share)
            done = distance(piece["to"], way.end, way.axes) <= 1.5 * self.digits_mm
            if done and (1 - share) * way.length <= 6 * self.digits_mm:
                return

    def is_short_cut_to(self, way):
        """A cut that the digits may have swallowed is there."""
        move = self.peek()
        return move is not None and move["kind"] not in ("rapid", "burn") and \
            Way(move).length <= 4 * self.digits_mm and distance(move["to"], way.end, way.axes) <= self.digits_mm

    def manner(self, piece, wanted):
        if wanted["feed"] is not None and piece["feed"] is not None:
            check(abs(piece["feed"] - wanted["feed"]) <= FEED, f"{self.where}: F{piece['feed']}, wanted {wanted['feed']}")
        check(abs(piece["s"] - wanted["s"]) <= 1e-3, f"{self.where}: S{piece['s']}, wanted {wanted['s']}")

    def follow(self, piece, way, share):
        is_arc = way.sweep > 0
        tolerance = self.digits_mm * (2 if is_arc else 1) + (0 if not is_arc else RADII_MM if piece.sweep > 0 else CHORD_MM)
        for look in range(1, LOOKS + 1):
            point = piece.at(look / LOOKS)
            share = way.share_of(point, share, self.digits_mm)
            off = distance(point, way.at(share), way.axes)
            check(off <= tolerance, f"{self.where}: {off:.6f} mm off its way at {point}, {share:.4f} of it")
        return share
