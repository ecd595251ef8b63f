"""--tools and --offsets: TOML, and the control's own G10 punch-out."""

from harness import check, contains, equal, near, refused, status, test

# #100 to #107: X, Y of G54; Z of EXT; X of G54.1 P3; length geometry, wear and radius geometry,
# wear of number 5.
READ = ("O1\nG21G90\n#100=#5221\n#101=#5222\n#102=#5203\n#103=#7041\n"
        "#104=#11005\n#105=#10005\n#106=#13005\n#107=#12005\nM30\n")


def values(box, *words, program=READ):
    box.write("part.nc", program)
    status(box.kerf("run", "part.nc", "--summary", "s.json", *words), 0)
    variables = box.json("s.json")["variables"]
    return [variables.get(f"#{100 + i}", 0) for i in range(8)]


TOML = ("[work.G54]\nX = 10\nY = -20.5\n[work.EXT]\nZ = 1\n[work.\"G54.1 P3\"]\nX = 3\n"
        "[tool_offset.5]\nlength_geometry = 100\nlength_wear = -0.1\n"
        "radius_geometry = 6\nradius_wear = 0.01\n")
G10 = ("%\nG90G10L2P1X10.Y-20.5\nG10L2P0Z1.\nG10L20P3X3.\nG10L10P5R100.\nG10L11P5R-0.1\n"
       "G10L12P5R6.\nG10L13P5R0.01\n%\n")
WANTED = [10, -20.5, 1, 3, 100, -0.1, 6, 0.01]


@test("--offsets reads work and tool offsets from TOML")
def toml(box):
    equal(values(box, "--offsets", box.write("o.toml", TOML)), WANTED, "offsets")
    short = TOML.replace("[tool_offset.5]", "[tool.5]").replace("G54.1 P3", "G54.1P3")
    equal(values(box, "--offsets", box.write("o.toml", short)), WANTED, "offsets")
    equal(values(box, "--offsets", box.write("o.toml", "# none\n[work.G59]\nX=1\n")), [0] * 8,
          "offsets of a file that sets others")


@test("--offsets reads the control's own G10 punch-out, with and without %, O number and M30")
def g10(box):
    for name, text in (("%", G10), ("no %", G10.replace("%\n", "")),
                       ("an O number", G10.replace("%\n", "%\nO9999(OFFSETS)\n", 1)),
                       ("M30", G10.replace("R0.01\n%", "R0.01\nM30\n%")),
                       ("CR LF", G10.replace("\n", "\r\n")),
                       ("a variable", G10.replace("X10.", "X[#1+10]"))):
        equal(values(box, "--offsets", box.write("g10.nc", text)), WANTED,
              f"offsets of a punch-out with {name}")


@test("a G10 punch-out changes offsets and nothing else: no part is counted, no variable kept")
def g10_side_effects(box):
    box.write("g10.nc", "%\nO9999\n#101=5\nG10L2P1X10.\nG00X5.\nG91\nG20\nM30\n%\n")
    box.write("part.nc", "O1\n#110=#4003\n#111=#4006\nG90G21G00X1.\nM30\n")
    status(box.kerf("run", "part.nc", "--offsets", "g10.nc", "--summary", "s.json",
                    "--motion", "m.json"), 0)
    done = box.json("s.json")
    equal(done["parts"], 1, "parts")
    equal(done["variables"], {"#110": 90, "#111": 21}, "variables")
    equal([(r["kind"], r.get("to", {}).get("X")) for r in box.motions("m.json")],
          [("rapid", 11), ("end", None)], "records")


@test("offsets of --offsets and --state hold from the first block on, without G54")
def from_the_first_block(box):
    box.write("part.nc", "O1\nG21G90\nG00X1.\nM30\n")
    box.write("o.toml", TOML)
    status(box.kerf("run", "part.nc", "--offsets", "o.toml", "--motion", "m.json"), 0)
    equal(box.motions("m.json")[0]["to"], {"X": 11, "Y": 0, "Z": 0}, "target with --offsets")
    box.write("set.nc", "O1\nG10L2P1X10.\nM30\n")
    status(box.kerf("run", "set.nc", "--state", "memory"), 0)
    status(box.kerf("run", "part.nc", "--state", "memory", "--motion", "m.json"), 0)
    equal(box.motions("m.json")[0]["to"], {"X": 11, "Y": 0, "Z": 0}, "target with --state")


@test("--offsets as TOML and as G10 give the same path")
def twins(box):
    part = ("O1\nG21G90G17\nG54G00X0Y0\nG43H5Z50.\nG41D5G01X10.Y0F200\nY30.\nX40.\nG40X60.\n"
            "G49\nM30\n")
    box.write("part.nc", part)
    box.write("o.toml", TOML)
    box.write("g10.nc", G10)
    for name in ("o.toml", "g10.nc"):
        status(box.kerf("run", "part.nc", "--offsets", name, "--motion", name + ".json"), 0)
    check(box.read("o.toml.json") == box.read("g10.nc.json"), "the two paths differ")


@test("--tools sets the offsets of each tool's number from its length and diameter")
def tools(box):
    box.write("t.toml", "[[tool]]\nnumber = 5\nname = \"mill\"\ndiameter = 12\nlength = 100\n"
                        "corner_radius = 1\n[[tool]]\nnumber = 7\ndiameter = 3\n")
    got = values(box, "--tools", "t.toml", program=READ.replace("M30", "#108=#13007\nM30"))
    equal(got, [0, 0, 0, 0, 100, 0, 6, 0], "offsets")
    near(box.json("s.json")["variables"]["#108"], 1.5, 1e-12, "radius of tool 7")


@test("--tools takes tool tables and libraries of other programs for their lengths and diameters")
def of_other_programs(box):
    table = box.write("tool.tbl", "T5 P5 D12.0 Z+100 ;end mill\nT999999 P6 D1 Z1\n")
    equal(values(box, "--tools", table), [0, 0, 0, 0, 100, 0, 6, 0], "a table of LinuxCNC")
    inches = values(box, "--tools", table, "--tools-unit", "inch")
    near(inches[4], 2540, 1e-9, "length in inches")
    library = box.write("lib.json", '{"data": [{"type": "drill", "unit": "millimeters", "geometry": '
                        '{"DC": 12, "assemblyGaugeLength": 100}, "post-process": {"number": 5}}]}')
    equal(values(box, "--tools", library), [0, 0, 0, 0, 100, 0, 6, 0], "a library of Fusion")
    box.write("bad.json", '{"data": [')
    refused(box.kerf("run", "part.nc", "--tools", "bad.json"), 3, "bad.json: this is no library of tools")


@test("kerf tools takes the unit of a table that says none")
def unit(box):
    box.write("tool.tbl", "T5 P5 D0.5 Z+4 ;end mill\n")
    for words, diameter, length in ((("--tools-unit", "inch"), "diameter = 12.7", "length = 101.6"),
                                    (("--tools-unit", "mm"), "diameter = 0.5", "length = 4"), ((), "diameter = 0.5", "length = 4")):
        got = box.kerf("tools", "tool.tbl", *words)
        status(got, 0)
        contains(got.text, diameter, f"{words}")
        contains(got.text, length, f"{words}")
    refused(box.kerf("tools", "tool.tbl", "--tools-unit", "ell"), 2, "--tools-unit")


@test("kerf tools writes tools of other programs as tables that --tools takes")
def written(box):
    box.write("tool.tbl", "T5 P5 D12.0 Z+100 ;\"1/2\" end mill\nT6 D0 Z5 ;new\n")
    got = box.kerf("tools", "tool.tbl")
    status(got, 0)
    equal(got.err, "kerf: tool.tbl: T6: a tool of type flat needs its diameter\n", "what is told")
    equal(values(box, "--tools", box.write("t.toml", got.text)), [0, 0, 0, 0, 100, 0, 6, 0], "offsets")
    refused(box.kerf("tools", "part.nc"), 3, "these are no tools")
    status(box.kerf("tools"), 2)


@test("tools of a machine file are where the table of offsets begins")
def of_the_machine(box):
    machine = box.kerf("machines", "mill3").out.decode() + "\n[[tool]]\nnumber = 5\ndiameter = 12\nlength = 100\n"
    box.write("mine.toml", machine)
    equal(values(box, "--machine", "mine.toml"), [0, 0, 0, 0, 100, 0, 6, 0], "offsets")
    box.write("t.toml", "[[tool]]\nnumber = 5\nlength = 90\n")
    equal(values(box, "--machine", "mine.toml", "--tools", "t.toml"), [0, 0, 0, 0, 90, 0, 6, 0], "the option")
    box.write("wrong.toml", machine + "type = \"hammer\"\n")
    refused(box.kerf("run", "part.nc", "--machine", "wrong.toml"), 3, "there is no type hammer of tools")


@test("--tools and --offsets are read one after the other")
def both(box):
    box.write("t.toml", "[[tool]]\nnumber = 5\ndiameter = 12\nlength = 100\n")
    box.write("g10.nc", "G10L11P5R-0.1\nG10L13P5R0.01\nG10L2P1X1.\n")
    equal(values(box, "--tools", "t.toml", "--offsets", "g10.nc"),
          [1, 0, 0, 0, 100, -0.1, 6, 0.01], "offsets")


@test("TOML values are mm whatever the program's own unit is")
def inch(box):
    box.write("o.toml", TOML)
    got = values(box, "--offsets", "o.toml", "--param", "unit=inch",
                 program=READ.replace("G21", "G20"))
    near(got[0], 10 / 25.4, 1e-9, "X of G54 in inches")


@test("memory A and B take the offsets that they have")
def memories(box):
    box.write("t.toml", "[[tool]]\nnumber = 5\ndiameter = 12\n[[tool]]\nnumber = 6\nlength = 50\n")
    box.write("part.nc", "O1\nG21G90\n#100=#2005\n#101=#2006\nM30\n")
    status(box.kerf("run", "part.nc", "--tools", "t.toml", "--param", "offset_memory=A",
                    "--summary", "s.json"), 0)
    variables = box.json("s.json")["variables"]
    equal((variables["#100"], variables["#101"]), (6, 50), "offsets of memory A")
    box.write("g10.nc", "G10L1P5R5.\nG10L11P6R6.\n")
    status(box.kerf("run", "part.nc", "--offsets", "g10.nc", "--param", "offset_memory=A",
                    "--summary", "s.json"), 0)
    variables = box.json("s.json")["variables"]
    equal((variables["#100"], variables["#101"]), (5, 6), "offsets of memory A by G10")


WRONG_TOML = {
    "no TOML": ("[work.G54\nX = 1\n", 1),
    "a work system that does not exist": ("[work.G60]\nX = 1\n", 1),
    "a work system with more behind its number": ("[work.\"G54.1 P3 of 300\"]\nX = 1\n", 1),
    "an extended system 301": ("[work.\"G54.1 P301\"]\nX = 1\n", 1),
    "an axis that the machine lacks": ("[work.G54]\nX = 1\nQ = 2\n", 3),
    "a word for a number": ("[work.G54]\nX = \"ten\"\n", 2),
    "an infinite number": ("[work.G54]\nX = inf\n", 2),
    "a number that is none": ("[work.G54]\nX = nan\n", 2),
    "tool offset 0": ("[tool_offset.0]\nlength_wear = 1\n", 1),
    "tool offset 401": ("[tool_offset.401]\nlength_wear = 1\n", 1),
    "a tool offset that is no number": ("[tool_offset.five]\nlength_wear = 1\n", 1),
    "an unknown key of an offset": ("[tool_offset.5]\nlenght_wear = 1\n", 2),
    "an unknown key of a tool": ("[[tool]]\nnumber = 5\ncolour = 1\n", 3),
    "a tool without number": ("[[tool]]\ndiameter = 5\n", 1),
    "a tool of negative number": ("[[tool]]\nnumber = -5\ndiameter = 5\n", 2),
    "an unknown table": ("[toools.5]\nlength_wear = 1\n", 1),
    "a key outside of all tables": ("X = 1\n[work.G54]\n", 1),
}


def wrong(text, *parts):
    def run(box):
        box.write("part.nc", READ)
        box.write("wrong", text)
        for option in ("--offsets", "--tools"):
            refused(box.kerf("run", "part.nc", option, "wrong", "--motion", "m.json"), 3, *parts)
        equal(box.files(), ["part.nc", "wrong"], "files behind it")
    return run


for name, (text, line) in WRONG_TOML.items():
    test(f"offsets with {name} are refused with the line")(wrong(text, f"wrong:{line}:"))

WRONG_G10 = {
    "an offset number that is too large": ("%\nG10L2P1X1.\nG10L10P401R1.\n%\n", "PS0030", 3),
    "a bad P": ("G10L2P7X0\n", "PS1144", 1),
    "no R": ("G10L10P5\n", "PS1144", 1),
    "an axis that the machine lacks": ("G10L2P1A1.\n", "PS0009", 1),
    "letters": ("THIS IS NOT A PUNCH-OUT\n", "wrong:1:", 1),
    "a value that is too large": ("G10L10P5R99999.\n", "PS", 1),
}
for name, (text, number, line) in WRONG_G10.items():
    test(f"a G10 punch-out with {name} is refused with its alarm and line")(
        wrong(text, f"wrong:{line}:", number))


@test("a file of offsets that is wrong at its end changes nothing of the state")
def nothing_taken_over(box):
    box.write("part.nc", READ)
    box.write("wrong.nc", "G10L2P1X10.\nG10L2P7X0\n")
    refused(box.kerf("run", "part.nc", "--offsets", "wrong.nc", "--state", "memory"), 3)
    check("memory" not in box.files(), "a state was written")


@test("an empty file of offsets sets none")
def empty(box):
    equal(values(box, "--offsets", box.write("none", "")), [0] * 8, "offsets")


@test("a file of offsets may be standard input")
def standard_input(box):
    box.write("part.nc", READ)
    result = box.kerf("run", "part.nc", "--offsets", "-", "--summary", "-", stdin=TOML)
    status(result, 0)
    contains(result.text, '"#100":10', "the summary")


# Geometry X Z radius, wear X Z radius, tip of a lathe's number 5; EXT Z.
OF_LATHE = ("O1\n#100=#2705\n#101=#2805\n#102=#2905\n#103=#2005\n#104=#2105\n#105=#2205\n#106=#2305\n"
            "#107=#5202\nM30\n")
LATHE_TOML = ("[work.EXT]\nZ = 1\n[tool.5]\ngeometry_x = -120.5\ngeometry_z = -80\ngeometry_radius = 0.8\n"
              "wear_x = -0.02\nwear_z = 0.01\nwear_radius = 0.005\ntip = 3\n")
LATHE_G10 = "%\nG10P0Z1.\nG10P10005X-120.5Z-80.R.8Q3\nG10P5X-.02Z.01R.005\n%\n"
LATHE_WANTED = [-120.5, -80, 0.8, -0.02, 0.01, 0.005, 3, 1]


@test("--offsets of a lathe reads geometry, wear, nose and tip from TOML and from its G10 punch-out")
def of_lathe(box):
    for name, text in (("TOML", LATHE_TOML), ("G10", LATHE_G10)):
        equal(values(box, "--machine", "lathe2", "--offsets", box.write("o", text), program=OF_LATHE),
              LATHE_WANTED, f"offsets of a lathe as {name}")
    tool = "[[tool]]\nnumber = 5\nnose_radius = 0.4\ntip = 2\n"
    equal(values(box, "--machine", "lathe2", "--tools", box.write("t", tool), program=OF_LATHE),
          [0, 0, 0.4, 0, 0, 0, 2, 0], "a tool of a lathe")


@test("X of a lathe's offset is a diameter: the tool goes so far, and the nose compensates")
def of_lathe_in_force(box):
    box.write("part.nc", "O1\nT0505\nG00X50.Z0.\nM30\n")
    box.write("o.toml", LATHE_TOML)
    status(box.kerf("run", "part.nc", "--machine", "lathe2", "--offsets", "o.toml", "--summary", "s.json"), 0)
    near(box.json("s.json")["position"]["machine"]["X"], 50 - 120.52, 1e-6, "X of the machine")


WRONG_OF_LATHE = {
    "half a tip": ("[tool.5]\ntip = 1.5\n", "tip is a whole number from 0 to 9"),
    "a tip that does not exist": ("[tool.5]\ntip = 10\n", "tip is a whole number from 0 to 9"),
    "a part that no offset has": ("[tool.5]\ngeometry_q = 1\n", "no key geometry_q"),
    "a number that the lathe lacks": ("[tool.65]\nwear_x = 1\n", "no tool offset 65"),
}
for what, (text, sentence) in WRONG_OF_LATHE.items():
    @test(f"--offsets of a lathe with {what} is refused")
    def wrong_of_lathe(box, text=text, sentence=sentence):
        box.write("part.nc", OF_LATHE)
        result = box.kerf("run", "part.nc", "--machine", "lathe2", "--offsets", box.write("o.toml", text))
        refused(result, 3)
        contains(result.err, sentence, "the message")
