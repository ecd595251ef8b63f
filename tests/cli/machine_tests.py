"""Machine files and --machine-set as a user meets them; each key by itself is in
tests/unit/machine/definition/machine_definition_test.cpp."""

from harness import equal, near, refused, status, test

PROGRAM = "O1\nG21G90\nG00X150.Y50.Z5.\nG01X100.F600\nG03X100.Y50.I10.J0\nM30\n"

BUILT_IN = ["arm4", "cartesian-step", "laser-xtz", "laser3", "laser5", "lathe2", "lathe3c", "mill3",
            "mill4", "mill5"]

# Keys that every machine has, and those of one linkage.
COMMON = ["axis.Z.velocity=500", "axis.Z.acceleration=10", "axis.Z.jerk=1000", "axis.Z.jerk=0",
          "axis.Z.steps_per_unit=-80", "axis.Z.max_rate=4000", "interpolator.period_ms=4",
          "interpolator.mode=planned", "interpolator.mode=tail", "interpolator.mode=equal",
          "interpolator.mode=literal", "interpolator.step_mm=0.5", "interpolator.tolerance=0",
          "interpolator.chord_tolerance=0.01", "drive.split=exact", "drive.split=integer"]
OF_LINKAGE = {
    "laser5": ["kinematics.r_a=100", "kinematics.r_c=-20"],
    "laser-xtz": ["kinematics.x1=30", "kinematics.theta0_deg=-90", "kinematics.z0=0",
                  "tip.velocity=1000"],
    "arm4": ["kinematics.upper_arm=140", "kinematics.forearm=120",
             "kinematics.forearm_absolute=true", "axis.T2.velocity=60", "tip.acceleration=9"],
}


@test("machines lists every built-in machine")
def all_machines(box):
    equal([line.split()[0] for line in box.kerf("machines").lines()], BUILT_IN, "names")


@test("every built-in machine runs a program, its motions those of the tool's tip")
def built_in(box):
    box.write("part.nc", PROGRAM)
    axes = {"arm4": "XYZC", "laser-xtz": "XYZ", "laser5": "XYZAC", "cartesian-step": "XYCZ"}
    for name in BUILT_IN:
        if name.startswith("lathe"):
            continue
        status(box.kerf("run", "part.nc", "--machine", name, "--motion", "m.json"), 0)
        records = box.motions("m.json")
        equal([record["kind"] for record in records], ["rapid", "line", "arc", "end"], name)
        to = records[1]["to"]
        equal((to["X"], to["Y"], to["Z"]), (100, 50, 5), f"the line of {name}")
        equal("".join(to), axes.get(name, "".join(to)), f"axes of {name}")


@test("a lathe runs a program, its records in diameters")
def a_lathe(box):
    box.write("part.nc", "O1\nG97S500M03\nG00X60.Z5.\nG01U-10.W-5.F.2\nM30\n")
    status(box.kerf("run", "part.nc", "--machine", "lathe2", "--motion", "m.json", "--summary", "s.json"), 0)
    equal([record["to"] for record in box.motions("m.json") if "to" in record],
          [{"X": 60, "Z": 5}, {"X": 50, "Z": 0}], "targets")
    equal(box.json("s.json")["extents"], {"X": [50, 60], "Z": [0, 5]}, "extents")
    equal(box.json("s.json")["position"]["work"], {"X": 50, "Z": 0}, "position")


def run_with(box, machine, key):
    box.write("part.nc", PROGRAM)
    return box.kerf("run", "part.nc", "--machine", machine, "--machine-set", key)


@test("--machine-set takes the keys that every machine has")
def common_keys(box):
    for key in COMMON:
        status(run_with(box, "mill3", key), 0)
        status(run_with(box, "arm4", key), 0)


@test("--machine-set takes the keys of a linkage on machines that have it, and on no other")
def keys_of_a_linkage(box):
    for machine, keys in OF_LINKAGE.items():
        for key in keys:
            status(run_with(box, machine, key), 0)
            if not key.startswith("axis"):
                refused(run_with(box, "mill3", key), 2, "type cartesian has no such key")


@test("--machine-set refuses what is no key and what a key does not take")
def wrong_keys(box):
    for key in ("kinematics.r_b=1", "kinematics.type=arm", "interpolator.period=1", "drive.mode=1",
                "name=x", "axis.X.travel=1"):
        refused(run_with(box, "laser5", key), 2, key, "there is no such key")
    for key, takes in (("interpolator.period_ms=0", "from 0.01 to 1000"),
                       ("interpolator.mode=fast", "planned, tail, equal or literal"),
                       ("interpolator.step_mm=-1", "a number from"),
                       ("interpolator.tolerance=-1", "a number from 0"),
                       ("interpolator.chord_tolerance=0", "a number from"),
                       ("drive.split=half", "exact or integer"),
                       ("axis.X.jerk=-1", "not negative"), ("kinematics.r_a=far", "a number")):
        refused(run_with(box, "laser5", key), 2, key, takes)


@test("a rapid of the tip has the rate of the tip")
def tip_rates(box):
    box.write("part.nc", "O1\nG21G90\nG00X60.\nM30\n")
    for words, seconds in (((), 51), (("--machine-set", "tip.velocity=3600"), 3.4)):  # from X264
        status(box.kerf("run", "part.nc", "--machine", "arm4", "--summary", "s.json", *words), 0)
        near(box.json("s.json")["time_feed_s"], seconds, 1e-9, f"time with {words}")


@test("a machine file of one's own may have any linkage, and says in which line it is wrong")
def own_machine(box):
    box.write("part.nc", PROGRAM)
    text = box.kerf("machines", "arm4").text.replace('name = "arm4"', 'name = "mine"')
    longer = text.replace("upper_arm = 132", "upper_arm = 200")
    box.write("mine.toml", longer)
    status(box.kerf("run", "part.nc", "--machine", "mine.toml"), 0)
    for old, new, said in (("upper_arm = 132", "upper_arm = -1", "a positive number"),
                           ("upper_arm = 132", "r_a = 132", "the type arm has no key"),
                           ("upper_arm = 132", "upper_limb = 132", "kinematics.upper_limb"),
                           ('type = "arm"', 'type = "leg"', "there is no kinematics leg"),
                           ('name = "T2"', 'name = "T9"', "T1 T2 T3"),
                           ('split = "exact"', 'split = "odd"', "exact or integer"),
                           ("period_ms = 1 ", 'period_ms = "1" ', "from 0.01 to 1000")):
        before = text[:text.index(old)]
        line = before.count("\n") + 1 - (1 if old.startswith("name") else 0)
        box.write("mine.toml", text.replace(old, new, 1))
        refused(box.kerf("run", "part.nc", "--machine", "mine.toml"), 3, f"mine.toml:{line}:", said)
