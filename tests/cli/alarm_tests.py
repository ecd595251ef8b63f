"""Alarms that need more than one file: other machines, libraries."""

from harness import alarm, test

# A mill with a second axis along X.
PARALLEL = "".join(f"""
[[axis]]
name = "{letter}"
velocity = 10000
acceleration = 1000
jerk = 10000
travel = [-100, 100]
reference = [0, 0, 0, 0]
""" for letter in "XYZU")


def on_four_axes(box, program):
    box.write("mill.toml", 'name = "parallel"\ndescription = "X Y Z and U along X"\n'
                           'dialect = "fanuc-mill"\n' + PARALLEL)
    box.write("part.nc", program)
    return box.kerf("run", "part.nc", "--machine", "mill.toml")


@test("a plane of two parallel axes raises PS0028")
def two_parallel_axes(box):
    alarm(on_four_axes(box, "O1\nG17X1.U2.\nM30\n"), "PS0028", 2)


@test("a plane of a parallel axis, which Kerf does not have, raises PS0028")
def a_parallel_axis(box):
    alarm(on_four_axes(box, "O1\nG18U2.Z1.\nM30\n"), "PS0028", 2)


@test("a turning cycle with another axis than X and Z raises PS0330")
def a_cycle_with_y(box):
    lathe = box.kerf("machines", "lathe2").text
    box.write("lathe.toml", lathe.replace('[[axis]]\nname = "Z"', '[[axis]]\nname = "Y"\nvelocity = 6000\n\n[[axis]]\nname = "Z"'))
    box.write("part.nc", "O1\nG97S500M03\nG00X52.Z2.\nG90X46.Y1.Z-30.F.2\nM30\n")
    alarm(box.kerf("run", "part.nc", "--machine", "lathe.toml"), "PS0330", 4)


@test("an external subprogram that calls an external subprogram raises PS1080")
def external_in_external(box):
    box.write("main/part.nc", "O1\nM198P9401\nM30\n")
    box.write("library/O9401.nc", "O9401\nM198P9402\nM99\n")
    box.write("library/O9402.nc", "O9402\nM99\n")
    alarm(box.kerf("run", "main/part.nc", "--library", "library"), "PS1080", 2)
