"""`kerf stock` runs the program as `kerf run` does: every option of a run counts there too."""

from harness import check, equal, status, test
from stock_check_tests import FLAT, HEAD, PLATE, SLOT, TAIL

ENDED = {"end": 0, "stopped": 0, "alarm": 1, "budget": 5}


def facts(box, command, words, into):
    result = box.kerf(command, "part.nc", "--tools", "tools.toml", *words)
    summary = box.json(into)
    status(result, ENDED[summary["status"]])
    return {key: summary[key] for key in ("status", "alarm", "time_s")}


def as_run(option, moves, *words, files=(), text=None):
    """With and without the option both commands do the same, and the option changes what they do."""
    @test(f"stock: {option} counts as it does for kerf run")
    def _(box):
        box.write("tools.toml", FLAT)
        box.write("part.nc", text or HEAD + "\n" + moves + TAIL)
        seen = []
        for more in ((), (option, *words)):
            for name, content in files:
                box.write(name, content)
            stock = ("--stock", PLATE, "--cell", "0.5", "--fail-on", "never", "--report", "r.json", *more)
            cut = facts(box, "stock", stock, "r.json")
            for name, content in files:
                box.write(name, content)
            equal(cut, facts(box, "run", ("--summary", "s.json", *more), "s.json"), f"{option}: {more}")
            seen.append(cut)
        check(seen[0] != seen[1], f"{option} changes nothing: {seen[0]}")


as_run("--block-skip", SLOT + "\n/Y30.", "all")
as_run("--optional-stop", SLOT + "\nM01\nY30.")
as_run("--set", SLOT + "\nY[20.+#500]", "#500=12")
as_run("--dialect", SLOT, "fanuc-lathe")
as_run("--library", SLOT + "\nM98P77", "folder", files=(("folder/O0077", "O77\nG01Y30.F900\nM99\n"),))
as_run("--max-motions", SLOT + "\nWHILE[1EQ1]DO1\nX61.\nX60.\nEND1", "9",
       text=HEAD + SLOT + "\n#1=0\nWHILE[#1LT50]DO1\nX61.\nX60.\n#1=#1+1\nEND1" + TAIL)
as_run("--interrupt-at", "M96P88\n" + SLOT + "\nM97", "3", "--library", "folder",
       files=(("folder/O0088", "O88\nG04P5000\nM99\n"),))
as_run("--skip-at", "G00X10.Y20.Z20.\nG31X60.F900", "X=30")
as_run("--offsets", SLOT + "\nG53Z0", "o.toml", files=(("o.toml", "[work.G54]\nZ = -40\n"),))
@test("stock: --state is read, and left as it is")
def state(box):
    box.write("tools.toml", FLAT)
    box.write("part.nc", HEAD + "\nIF[#500NE#0]GOTO9\nY30.\nN9#500=1\n" + SLOT + TAIL)
    cut = ("--stock", PLATE, "--cell", "0.5", "--report", "r.json", "--state", "memory")
    ran = ("--summary", "s.json", "--state", "memory")
    first = facts(box, "stock", cut, "r.json")
    equal(first, facts(box, "run", ran, "s.json"), "a control that knows nothing")
    kept = box.read("memory")
    second = facts(box, "stock", cut, "r.json")
    check(first != second, f"it did not read what the run has left: {second}")
    equal(box.read("memory"), kept, "the file behind it")
    equal(second, facts(box, "run", ran, "s.json"), "a run behind the first one")


@test("stock: the summary of the run stands above what is said of the part, once")
def once(box):
    box.write("tools.toml", FLAT)
    box.write("part.nc", HEAD + SLOT + TAIL)
    for command in ("run", "stock"):
        told = box.kerf(command, "part.nc", "--tools", "tools.toml", "--stock", PLATE, "--cell", "0.5").err
        for words in ("blocks,", "extents X", "  stock box:", "no findings"):
            equal(told.count(words), 1, f"{command}: {words}")
        check(told.index("extents X") < told.index("  stock box:"), command)


@test("stock: a run that takes longer than --max-seconds ends with what is cut by then")
def seconds(box):
    box.write("tools.toml", FLAT)
    box.write("part.nc", HEAD + SLOT + "\nWHILE[1EQ1]DO1\nX61.\nX60.\nEND1" + TAIL)
    result = box.kerf("stock", "part.nc", "--tools", "tools.toml", "--stock", PLATE, "--max-seconds", "0.3", "--report", "r.json")
    status(result, 5)
    report = box.json("r.json")
    equal(report["status"], "budget", "status")
    check(report["removed_mm3"] > 2500, "the slot is cut")
