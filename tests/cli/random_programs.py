"""Random programs of every language for every machine, each from a seed of its own."""

import math

# What the tips of a machine can reach from anywhere in it, and along lines between two such places.
BOXES = {
    "mill3": {"X": (-200, 200), "Y": (-150, 150), "Z": (-120, -5)},
    "mill4": {"X": (-200, 200), "Y": (-150, 150), "Z": (-120, -5), "A": (-170, 170)},
    "mill5": {"X": (-200, 200), "Y": (-150, 150), "Z": (-120, -5), "A": (-100, 20), "C": (-300, 300)},
    "laser3": {"X": (-200, 200), "Y": (-150, 150), "Z": (-20, 20)},
    "laser5": {"X": (-200, 200), "Y": (-200, 200), "Z": (-50, 150), "A": (-80, 80), "C": (-300, 300)},
    "laser-xtz": {"X": (40, 90), "Y": (-30, 30), "Z": (-20, 20)},
    "arm4": {"X": (120, 170), "Y": (-50, 50), "Z": (-20, 40), "C": (-90, 90)},
    "cartesian-step": {"X": (-90, 90), "Y": (-90, 90), "Z": (-20, 40), "C": (-90, 90)},
}
ROTARY = "ABC"
MILLS = ("mill3", "mill4", "mill5")
LANGUAGES = {machine: ("nc", "tch") if machine in ("mill3", "mill5", "laser5") else ("nc",) for machine in BOXES}
LANGUAGES["laser3"] = ("nc", "bas", "tch")
LANGUAGES["laser-xtz"] = ("nc", "bas")
LENGTHS = {1: 80.25, 2: 50.0, 3: 0.0, 4: 131.337, 5: -12.5}
TOOLS = "".join(f"[[tool]]\nnumber = {t}\ndiameter = 8\nlength = {length}\n" for t, length in LENGTHS.items())


class Program:
    """Its text, and what G43 adds to Z on each of its lines (from 1)."""

    def __init__(self, random, machine, language):
        self.random, self.machine, self.language = random, machine, language
        self.box, self.is_laser = BOXES[machine], machine.startswith("laser")
        self.lines, self.lengths = [], [0]
        self.returns = set()  # lines that end at a reference point, without length
        {"nc": GCode, "bas": Basic, "tch": Taught}[language](self)
        self.text = "\n".join(self.lines) + "\n"

    def add(self, line, length=0):
        self.lines.append(line)
        self.lengths.append(length)

    def somewhere(self, axis):
        """With three decimals; often one that is there already, often machine zero."""
        low, high = self.box[axis]
        if low <= 0 <= high and self.random.random() < 0.15:
            return 0.0
        return round(self.random.uniform(low, high), self.random.choice((0, 1, 3, 3)))

    def place(self):
        return {axis: self.somewhere(axis) for axis in self.box}


def words(place):
    return " ".join(f"{axis}{value:.3f}" for axis, value in place.items())


class GCode:
    """Milling and laser programs: offsets, lengths, cycles, arcs, loops."""

    def __init__(self, program):
        self.p, self.random = program, program.random
        self.length = self.wanted = 0
        self.at = dict.fromkeys(program.box, 0.0)
        self.begin()
        for _ in range(self.random.randint(3, 14)):
            self.random.choices((self.rapid, self.line, self.arc, self.helix, self.arc_by_radius, self.other,
                                 self.cycle, self.tool, self.loop, self.turned, self.reference),
                                (4, 6, 5, 2, 2, 3, 2, 2, 1, 1, 1))[0]()
        if self.random.random() < 0.7:
            self.move("G0", {"Z": self.p.box["Z"][1]})
        self.add(self.random.choice(("M30", "M5\nM30", "M02")))

    def add(self, text):
        for line in text.split("\n"):
            self.p.add(line, self.length)

    def begin(self):
        self.add("O1")
        self.add("G21 G90 G17 G94 G40 G49 G80 G54")
        self.offset = dict.fromkeys(self.p.box, 0.0)
        if self.random.random() < 0.4:
            self.offset.update({axis: round(self.random.uniform(-20, 20), 3) for axis in "XY"})
            self.add("G10 L2 P1 " + words({axis: self.offset[axis] for axis in "XY"}))
        if self.random.random() < 0.3:
            self.add(self.random.choice(("G28 G91 Z0\nG90", "M5", "M9", "G4 X0.1", "M1", "G53 G0 Z0")))
        self.f = False
        if self.random.random() < 0.6:
            self.tool()
        if self.random.random() < 0.8:
            self.spindle()
        if self.random.random() < 0.8:
            self.move("G0", self.some_axes(self.p.place()))

    def some_axes(self, place):
        kept = [axis for axis in place if self.random.random() < 0.75]
        return {axis: place[axis] for axis in kept or ["X"]}

    def move(self, code, place, more=""):
        """To a place of the machine, tool length left out."""
        if "Z" in place:
            self.length = self.wanted
        feed = "" if code == "G0" else self.feed()
        self.add(f"{code} " + words({a: v - self.offset[a] for a, v in place.items()}) + more + feed)
        self.at.update(place)

    def feed(self):
        if self.f and self.random.random() < 0.5:
            return ""
        self.f = True
        return f" F{self.random.choice((60, 240, 400.5, 1234, 99.875))}"

    def spindle(self):
        code = self.random.choice(("M3", "M3", "M4"))
        self.add(f"{code} S{self.random.choice((100, 500, 750, 1000))}")

    def tool(self):
        t = self.random.choice(list(LENGTHS))
        if self.p.machine not in MILLS:
            return
        self.add(f"T{t} M6")
        if self.random.random() < 0.85:
            self.wanted = self.length = LENGTHS[t]
            z = self.p.somewhere("Z")
            with_z = self.random.random() < 0.6
            self.add(f"G43 H{t}" + (f" G0 Z{z - self.offset['Z']:.3f}" if with_z else ""))
            if with_z:
                self.at["Z"] = z
        elif self.random.random() < 0.5:
            self.wanted = self.length = 0
            self.add("G49")

    def rapid(self):
        self.move("G0", self.some_axes(self.p.place()))

    def line(self):
        for _ in range(self.random.randint(1, 4)):
            self.move("G1", self.some_axes(self.p.place()))

    # A circle about a centre that keeps it in the box.
    def circle(self, plane):
        first, second = plane
        room = {axis: min(self.at[axis] - self.p.box[axis][0], self.p.box[axis][1] - self.at[axis])
                for axis in plane}
        most = min(max(room.values()) / 2, min(room.values()) + 10) if min(room.values()) > 1 else 0
        if most < 1:
            return None
        angle = self.random.uniform(0, 2 * math.pi)
        radius = self.random.uniform(0.5, max(0.6, min(room.values()) / 2))
        return (self.at[first] + radius * math.cos(angle), self.at[second] + radius * math.sin(angle), radius)

    def centred(self, helix):
        plane, code, letters = self.random.choice((("XY", "G17", "IJ"), ("ZX", "G18", "KI"), ("YZ", "G19", "JK")))
        circle = self.circle(plane)
        if circle is None:
            return
        u, v, _ = circle
        i, j = (round(c - self.at[axis], 3) for c, axis in zip((u, v), plane))
        if math.hypot(i, j) < 0.3:
            return
        c = self.at[plane[0]] + i, self.at[plane[1]] + j
        radius = math.hypot(i, j)
        whole = self.random.random() < 0.3
        end = self.random.uniform(0, 2 * math.pi)
        # To three decimals: the radius changes by up to the control's tolerance.
        slip = self.random.choice((0, 0, 0, self.random.uniform(-0.006, 0.006)))
        to = {} if whole else {plane[0]: round(c[0] + (radius + slip) * math.cos(end), 3),
                               plane[1]: round(c[1] + (radius + slip) * math.sin(end), 3)}
        if helix:
            normal = next(axis for axis in "XYZ" if axis not in plane)
            to[normal] = self.p.somewhere(normal)
        if not to:
            to = {plane[0]: self.at[plane[0]]}
        self.move(f"{code} {self.random.choice(('G2', 'G3'))}", to, f" {letters[0]}{i:.3f} {letters[1]}{j:.3f}")
        if self.random.random() < 0.5:
            self.add("G17")

    def arc(self):
        self.centred(helix=False)

    def helix(self):
        self.centred(helix=True)

    def arc_by_radius(self):
        circle = self.circle("XY")
        if circle is None:
            return
        u, v, radius = circle
        end = self.random.uniform(0, 2 * math.pi)
        to = {"X": round(u + radius * math.cos(end), 3), "Y": round(v + radius * math.sin(end), 3)}
        chord = math.hypot(to["X"] - self.at["X"], to["Y"] - self.at["Y"])
        if chord < 0.1:
            return
        r = round(max(radius, chord / 2 + 0.01), 3) * self.random.choice((1, 1, -1))
        self.move(f"G17 {self.random.choice(('G2', 'G3'))}", to, f" R{r:.3f}")

    def other(self):
        pick = self.random.randint(0, 8)
        if pick == 0:
            self.spindle()
        elif pick == 1:
            self.add("M5")
            if self.random.random() < 0.8:
                self.spindle()
        elif pick == 7:
            self.wanted = self.length = 0
            self.add("G49")
        elif pick == 8 and self.p.machine in MILLS:
            h = self.random.choice(list(LENGTHS))
            self.wanted = self.length = LENGTHS[h]
            self.add(f"G43 H{h}")
        else:
            self.add(self.random.choice(("G4 X0.25", "M8", "M9", "M0", "M1", "M77", "(A COMMENT)", "#3006=1(LOOK)")))

    def cycle(self):
        if self.p.machine in ("laser5", "arm4", "laser-xtz"):
            return
        top, bottom = self.p.box["Z"][1] - 1, self.p.box["Z"][0] / 2
        self.move("G0", {"Z": self.p.box["Z"][1]})
        r, z = round(top - self.random.uniform(1, 3), 3), round(bottom + self.random.uniform(0, 2), 3)
        code = self.random.choice(("G81", "G82", "G83", "G73", "G85", "G89", "G86"))
        more = {"G82": " P200", "G89": " P100", "G83": " Q8.", "G73": " Q9."}.get(code, "")
        self.f = False
        x, y = self.p.somewhere("X"), self.p.somewhere("Y")
        self.add(f"G17 {self.random.choice(('G98', 'G99'))} {code} X{x - self.offset['X']:.3f} Y{y - self.offset['Y']:.3f} "
                 f"R{r - self.offset['Z']:.3f} Z{z - self.offset['Z']:.3f}{more}{self.feed()}")
        self.at.update(X=x, Y=y)
        for _ in range(self.random.randint(0, 2)):
            self.at["X"] = self.p.somewhere("X")
            self.add(f"X{self.at['X'] - self.offset['X']:.3f}")
        self.add("G80")
        self.move("G0", {"Z": self.p.box["Z"][1]})

    def loop(self):
        self.f = True
        n, r = self.random.randint(2, 9), self.random.uniform(1, 9)
        x, y = (min(max(self.at[a], self.p.box[a][0] + 10), self.p.box[a][1] - 10) for a in "XY")
        self.add(f"#1=0\nWHILE[#1LE{n}]DO1\n"
                 f"G1 X[{x - self.offset['X']:.3f}+{r:.3f}*COS[#1*37]] Y[{y - self.offset['Y']:.3f}+{r:.3f}*SIN[#1*37]] F333.\n"
                 "#1=#1+1\nEND1")
        self.move("G1", {"X": round(x, 3), "Y": round(y, 3)})

    def turned(self):
        """A square turned or scaled about where the tool stands: ends that are no decimals."""
        x, y = (self.at[a] - self.offset[a] for a in "XY")
        reach = min(min(self.at[a] - self.p.box[a][0], self.p.box[a][1] - self.at[a]) for a in "XY")
        if reach < 3:
            return
        self.f = True
        side = self.random.uniform(0.5, reach / 3)
        self.add("G17 " + self.random.choice((f"G68 X{x:.3f} Y{y:.3f} R{self.random.uniform(1, 89):.3f}",
                                      f"G51 X{x:.3f} Y{y:.3f} P{self.random.randint(300, 1900)}")))
        off = "G69" if "G68" in self.p.lines[-1] else "G50"
        self.add(f"G1 X{x + side:.3f} Y{y:.3f} F500.\nG3 X{x:.3f} Y{y + side:.3f} I-{side:.3f} J0.\n"
                 f"G1 X{x:.3f} Y{y:.3f}\n{off}")
        self.move("G1", {"X": round(self.at["X"] + 0.5, 3), "Y": self.at["Y"]})

    def reference(self):
        if self.p.machine not in MILLS:
            return
        self.length = 0
        self.add(self.random.choice(("G91 G28 Z0\nG90", "G53 G0 Z0")))
        self.at["Z"] = 0.0
        if self.random.random() < 0.5:
            self.rapid()


class Basic:
    def __init__(self, program):
        random = program.random
        begin = [f"speed({random.choice((5, 20, 33.3))})", f"power({random.choice((10, 55.5, 80, 100))})",
                 "home", f"move({program.somewhere('X')},{program.somewhere('Y')})"]
        for line in begin:
            if random.random() < 0.7 or line.startswith(("speed", "power")):
                program.add(line)
        if program.machine == "laser-xtz":
            program.add("move(60,0)")
        for _ in range(random.randint(2, 10)):
            x, y = program.somewhere("X"), program.somewhere("Y")
            r = round(random.uniform(1, 9), 2)
            program.add(random.choice((
                f"line({x},{y})", f"line({x},{y})", f"line({x},{y},{program.somewhere('Z')})", f"move({x},{y})",
                f"circle({x},{y},{r})", f"arc({x},{y},{r},{random.randint(-90, 90)},{random.randint(100, 800)})",
                f"arc(xpos+{r},ypos+{r},{r + 3},{random.choice((1, -1))})", f"power({random.choice((0, 20, 70.2))})",
                f"speed({random.choice((7, 15))})", f"for i=1 to 5; line({x}+i/3*cos(i), {y}+sin(i)); next")))
        program.add("end")


class Taught:
    def __init__(self, program):
        random = program.random
        program.add("TEACH 1")
        at = self.place(program)
        if random.random() < 0.6:
            at = dict.fromkeys(at, 0)
        program.add("POINT " + self.values(at))
        program.add(f"FEED {random.choice((600, 1200, 2500.5))}")
        if random.random() < 0.8:
            program.add(f"LASER ON {random.choice((20, 55.5, 100))}")
        for _ in range(random.randint(1, 6)):
            self.record(program, random, at)
        program.add("END")

    def place(self, program):
        return {axis: program.somewhere(axis) if axis in program.box else 0 for axis in "XYZAC"}

    def values(self, place):
        return " ".join(f"{place[axis]:.4f}" for axis in "XYZAC")

    def record(self, program, random, at):
        flat = random.random() < 0.5
        a, b = self.place(program), self.place(program)
        if flat:
            for point in (a, b):
                point.update({axis: at[axis] for axis in random.choice(("ZAC", "XAC", "YAC"))})
            b.update({axis: a[axis] for axis in "AC"})
        kind = random.choice(("LINE", "LINE", "ARC", "ARC", "CIRCLE", "POINT", "OTHER"))
        if kind in ("LINE", "POINT"):
            program.add(f"{kind} {self.values(a)}")
            at.update(a)
        elif kind == "OTHER":
            program.add(random.choice(("DWELL 0.25", "LASER OFF", "LASER ON 40", "FEED 900")))
        else:
            # Small, so that no circle leaves the box by much.
            a, b = ({x: at[x] + (p[x] - at[x]) * 0.1 for x in at} for p in (a, b))
            program.add(f"{kind} {self.values(a)} {self.values(b)}")
            if kind == "ARC":
                at.update(b)
