"""What a machine keeps is on the disk: whoever changed it, however the server ends, and when the disk does not take it."""

import json
import random
import resource
import signal
import sqlite3

import harness
from harness import *  # noqa: F403

SHORT_KILLS = 20


def stored(place, machine="mill"):
    return json.loads((place.data / "machines" / machine / "memory.json").read_text())


def first(place, machine="mill"):
    """G54 X, #500 and the length of tool 1, as they are on the disk."""
    memory = stored(place, machine)
    work = memory["work"][0]
    return work[0] if work else 0, memory["variables"].get("500"), memory["tools"].get("1", [0])[0]


def shown(client):
    rows = {(r["offset"], r["axis"]): r["value"] for r in client.do("offsets")["offsets"]}
    variable = client.do("variables", names=["#500"])["variables"][0]["value"]
    tools = {t["number"]: t["length_geometry"] for t in client.do("tools")["tools"]}
    return rows[("G54", "X")], variable, tools.get(1, 0)


def start(client):
    client.do("mode", mode="auto")
    client.do("cycle-start")


class Disk:
    """The disk of a server, which is full for a while: no file of it can grow. Works for every account."""

    def __init__(self, server):
        self.pid = server.process.pid
        self.usual = resource.prlimit(self.pid, resource.RLIMIT_FSIZE)

    def fill(self):
        resource.prlimit(self.pid, resource.RLIMIT_FSIZE, (0, self.usual[1]))

    def free(self):
        resource.prlimit(self.pid, resource.RLIMIT_FSIZE, self.usual)


def refused_start_on_a_full_disk(place):
    def full():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (0, resource.RLIM_INFINITY))

    result = subprocess.run([place.kerf, "serve", "--port", "0", "--data", str(place.data)], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, preexec_fn=full, restore_signals=False, timeout=60 * harness.PATIENCE)
    equal(result.returncode, 3, "exit status")
    says(result.stderr, str(place.data))


@test("what a program wrote and a command put back is on the disk")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.load("O1\nG10L2P1X10.\nM0\nM30\n")
    start(client)
    client.wait_for_status("stopped")
    eventually(lambda: first(place)[0] == 10, "the value of the program on the disk")
    client.do("reset")
    client.settle()
    client.do("set-offset", offset="G54", axis="X", value=12)
    equal(first(place)[0], 12, "on the disk when it is answered")
    client.do("cycle-start")
    client.wait_for_status("stopped")
    equal(shown(client)[0], 10, "in the memory")
    equal(server.stop(), 0, "exit status")
    equal(first(place)[0], 10, "on the disk")
    equal(shown(place.serve().client().watch("mill"))[0], 10, "after the start")


@test("in any order of commands and programs the disk has what the memory has", long=True)
def _(place):
    chance = random.Random(1)
    server = place.serve()
    client = server.client().watch("mill")
    for turn in range(12):
        for _ in range(3):
            value = chance.choice([1, 2])
            how = chance.randrange(6)
            if how == 0:
                client.do("set-offset", offset="G54", axis="X", value=value)
            elif how == 1:
                client.do("set-variable", name="#500", value=value)
            elif how == 2:
                client.do("set-tool", number=1, length_geometry=value)
            else:
                client.do("load", name="p.nc", text=f"O1\nG10L2P1X{value}.\n#500={value}\nG10L10P1R{value}.\nM0\nM30\n")
                start(client)
                client.settle()
                client.do("reset")
                client.settle()
        wanted = shown(client)
        eventually(lambda: first(place) == wanted, f"turn {turn}: {wanted} on the disk, not {first(place)}", 20)
        if turn % 4 == 3:
            server.stop()
            equal(first(place), wanted, "after the end")
            server = place.serve()
            client = server.client().watch("mill")
            equal(shown(client), wanted, "after the start")


@test("a reset under way and a kill keep what the panel showed", long=True)
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    text = "O1\n#500=0\nG91G94\nWHILE[#500LT100000]DO1\n#500=#500+1\nG01X[0.5-[#500AND1]]F600\nEND1\nM30\n"
    client.load(text)
    start(client)
    client.wait_for(lambda: client.state.get("motion", 0) > 20, "some moves")
    client.do("reset")
    client.settle()
    kept = shown(client)[1]
    check(10 < kept < 1000, f"{kept} are kept")
    eventually(lambda: first(place)[1] == kept, "the same on the disk")
    client.do("cycle-start")
    client.wait_for(lambda: client.state.get("motion", 0) > 40 and client.state["status"] == "running", "some moves")
    time.sleep(1.5)
    counted = shown(client)[1]
    server.stop(signal.SIGKILL)
    client = place.serve().client().watch("mill")
    kept = shown(client)[1]
    check(0 < kept <= counted + 2, f"{kept} of {counted} are kept")


def with_unsaved_memory(server):
    """A client whose program has set offset and variable, and the full disk that they were not written to."""
    client = server.client().watch("mill")
    client.load("O1\n#500=42\nG10L2P1X10.\nM0\nM30\n")
    disk = Disk(server)
    disk.fill()
    start(client)
    client.wait_for(lambda: client.state.get("unsaved"), "the trouble")
    return client, disk


@test("a full disk: what was not written is told, and is written when there is room")
def _(place):
    server = place.serve()
    client, disk = with_unsaved_memory(server)
    says(client.state["unsaved"], "memory.json")
    other = server.client().watch("mill", operate=False)
    check(other.state["unsaved"], "who comes later sees it, too")
    equal(first(place)[0], 0, "on the disk")
    disk.free()
    client.wait_for(lambda: client.state["unsaved"] is None, "the end of the trouble", 60)
    equal(first(place)[:2], (10, 42), "on the disk")
    says(server.errors(), "the memory of mill is on the disk again")


@test("a disk that was full is tried once more at the end")
def _(place):
    server = place.serve()
    _, disk = with_unsaved_memory(server)
    disk.free()
    equal(server.stop(), 0, "exit status")
    equal(first(place)[:2], (10, 42), "on the disk")


@test("a full disk: a start says so and leaves what is there")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("write", name="kept.nc", text="O1\nM30\n")
    client.do("set-variable", name="#500", value=7)
    equal(server.stop(), 0, "exit status")
    refused_start_on_a_full_disk(place)
    client = place.serve().client().watch("mill")
    equal(client.do("read", name="kept.nc")["text"], "O1\nM30\n", "the program")
    equal(first(place)[1], 7, "the variable")


@test("a full disk: a command that is refused has no effect")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("write", name="old.nc", text="O1\nM30\n")
    client.do("load", program="old.nc")
    client.do("set-offset", offset="G54", axis="X", value=1)
    client.do("set-variable", name="#500", value=1)
    client.do("set-tool", number=1, length_geometry=1)
    before = shown(client)
    settings = client.do("settings")["toml"]
    disk = Disk(server)
    disk.fill()
    client.refused("set-offset", offset="G54", axis="X", value=2)
    client.refused("set-variable", name="#500", value=2)
    client.refused("set-tool", number=1, length_geometry=2)
    client.refused("create", name="full", definition="mill3")
    client.refused("set-settings", toml=settings + "\n# changed\n")
    client.refused("load", text="O2\nM30\n", name="new.nc")
    client.refused("write", name="old.nc", text="O3\nM30\n")
    client.refused("write", name="fresh.nc", text="O3\nM30\n")
    equal(shown(client), before, "in the memory")
    equal(first(place), before, "on the disk")
    equal(client.do("settings")["toml"], settings, "the machine file")
    check("full" not in [m["name"] for m in client.do("machines")["machines"]], "there is no machine")
    client.wait_for(lambda: client.state["file"] == "old.nc", "the old program is loaded")
    disk.free()
    equal(client.do("read", name="old.nc")["text"], "O1\nM30\n", "the program")
    equal(len(client.do("revisions", name="old.nc")["revisions"]), 1, "its revisions")
    client.do("create", name="full", definition="mill3")
    client.do("set-offset", offset="G54", axis="X", value=3)
    equal(first(place)[0], 3, "on the disk")
    server.stop()
    server = place.serve()
    equal(server.errors(), "", "what it says")
    client = server.client().watch("mill")
    equal(client.state["file"], "old.nc", "the program")
    check("fresh.nc" not in [p["name"] for p in client.do("programs")["programs"]], "no program of a refused write")


@test("a set-tool of which one part is wrong changes nothing")
def _(place):
    client = place.serve().client().watch("mill")
    client.refused("set-tool", number=1, length_geometry=5, radius_geometry=1e9)
    equal(shown(client)[2], 0, "the length")


@test("a machine file with fewer tools leaves a machine that starts")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("set-tool", number=90, length_geometry=5)
    client.do("set-tool", number=9, length_geometry=6)
    toml = client.do("settings")["toml"]
    check("n_offsets = 400" in toml, "the machine has 400 tools")
    client.do("set-settings", toml=toml.replace("n_offsets = 400", "n_offsets = 10"))
    server.stop(signal.SIGKILL)
    server = place.serve()
    check("mill" in [m["name"] for m in server.client().do("machines")["machines"]], server.errors())


@test("commands behind a new machine file are kept")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    toml = client.do("settings")["toml"]
    numbers = [client.post("set-settings", toml=toml + "\n# new\n")]
    numbers += [client.post("set-offset", offset="G54", axis="X", value=n) for n in range(1, 20)]
    for number in numbers:
        check(client.answer(number)["ok"], "it is done")
    equal(shown(client)[0], 19, "in the memory")
    server.stop(signal.SIGKILL)
    equal(shown(place.serve().client().watch("mill"))[0], 19, "after the start")


@test("a killed server leaves no unfinished files behind its next start")
def _(place):
    place.serve().stop()
    folder = place.data / "machines" / "mill"
    left = [
        folder / ".memory.json.Ab3xYz",
        folder / ".program.json.Ab3xYz",
        place.data / ".preview.Ab3xYz",
        place.data / "library" / ".flanges.nc.Ab3xYz",
    ]
    for path in left:
        path.write_text("half")
    (place.data / "machines" / "nothing").mkdir()
    (place.data / "library" / ".gitignore").write_text("*.bak\n")
    server = place.serve()
    equal([str(p) for p in left if p.exists()], [], "what is left")
    check(not (place.data / "machines" / "nothing").exists(), "an empty folder is no machine")
    check((place.data / "library" / ".gitignore").exists(), "what others have put there stays")
    equal(server.errors(), "", "what it says")


@test("create does not write over a machine that could not be read")
def _(place):
    place.serve().stop()
    memory = place.data / "machines" / "mill" / "memory.json"
    memory.write_text("{ a person can mend this")
    server = place.serve()
    client = server.client()
    says(client.refused("create", name="mill", definition="mill3"), "mend or remove")
    equal(memory.read_text(), "{ a person can mend this", "the file")


@test("the database says its format; a later one and a foreign one are refused by name")
def _(place):
    place.serve().stop()
    path = place.data / "revisions.sqlite"

    def run(statement):
        database = sqlite3.connect(path)
        found = database.execute(statement).fetchone()
        database.commit()
        database.close()
        return found

    equal(run("PRAGMA user_version"), (1,), "format")
    run("PRAGMA user_version = 99")
    result = place.run("serve", "--port", "0", "--data", str(place.data))
    equal(result.returncode, 3, "exit status")
    says(result.stderr, "revisions.sqlite", "99")
    run("PRAGMA user_version = 0")  # as before formats were counted
    place.serve().stop()
    equal(run("PRAGMA user_version"), (1,), "format")
    run("DROP TABLE revisions")
    run("CREATE TABLE revisions (something TEXT)")
    run("PRAGMA user_version = 0")
    result = place.run("serve", "--port", "0", "--data", str(place.data))
    equal(result.returncode, 3, "exit status")
    says(result.stderr, "revisions.sqlite", "not one of Kerf's")
    path.write_text("this is no database")
    result = place.run("serve", "--port", "0", "--data", str(place.data))
    equal(result.returncode, 3, "exit status")
    says(result.stderr, "revisions.sqlite")


@test("a locked database refuses programs before their files are touched, and delays nothing else")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("write", name="a.nc", text="O1\nM30\n")
    other = sqlite3.connect(place.data / "revisions.sqlite", isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    write = client.post("write", name="a.nc", text="O2\nM30\n")
    offset = client.post("set-offset", offset="G54", axis="X", value=2)
    check(client.answer(offset)["ok"], "the offset is set")
    check(write not in client.answers, "while the library waits")
    says(client.answer(write)["error"], "revisions.sqlite", "locked")
    says(client.refused("rename", **{"from": "a.nc", "to": "b.nc"}), "locked")
    other.execute("ROLLBACK")
    equal(client.do("read", name="a.nc")["text"], "O1\nM30\n", "the program")
    equal(len(client.do("revisions", name="a.nc")["revisions"]), 1, "its revisions")
    check("b.nc" not in [p["name"] for p in client.do("programs")["programs"]], "no second name")


@test("the data folder is for its account alone")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("write", name="a.nc", text="O1\n")
    client.do("create", name="new", definition="mill3")
    client.do("set-offset", offset="G54", axis="X", value=2)

    def open_ones():
        return [str(p) for p in [place.data, *place.data.rglob("*")] if p.stat().st_mode & 0o077]

    equal(open_ones(), [], "what others can open")
    server.stop()
    place.data.chmod(0o755)
    server = place.serve()
    equal(place.data.stat().st_mode & 0o777, 0o700, "the folder")
    says(server.errors(), "closed to them now")


@test("a first start on a full disk ends with a sentence, and the next one makes all machines")
def _(place):
    refused_start_on_a_full_disk(place)
    equal(len(place.serve().client().do("machines")["machines"]), 6, "machines")


def killed_and_back(place, kills):
    """Kills a server with changes under way, again and again; all that was answered is there after each start."""
    chance = random.Random(kills)
    answered = {}
    for kill in range(kills):
        server = place.serve()
        client = server.client().watch("mill")
        if answered:
            equal(shown(client)[0], answered["X"], f"kill {kill}: G54 X")
            equal(client.do("variables", names=["#501"])["variables"][0]["value"], answered["#501"], f"kill {kill}: #501")
            counted = shown(client)[1]
            check(counted >= answered["#500"], f"kill {kill}: #500 is {counted}, {answered['#500']} was on the disk")
        else:
            client.do("set-variable", name="#500", value=0)
            client.do("load", name="count.nc", text="O1\nN1#500=#500+1\nG4P20\nGOTO1\n")
        answered["X"], answered["#501"] = kill + 0.25, kill + 0.5
        client.do("set-offset", offset="G54", axis="X", value=answered["X"])
        client.do("set-variable", name="#501", value=answered["#501"])
        start(client)
        client.wait_for_status("running")
        before = first(place)[1]
        if kill % 10 == 0:  # a save of what the program has written
            eventually(lambda: first(place)[1] > before, "a save", 20)
        else:
            time.sleep(chance.random() * 0.05)
        answered["#500"] = first(place)[1]
        unfinished = client.post("set-variable", name="#502", value=1)  # may or may not come through
        check(unfinished, "it was sent")
        server.stop(signal.SIGKILL)
        client.close()


@test("a server that is killed again and again loses nothing that was answered")
def _(place):
    killed_and_back(place, harness.KILLS or SHORT_KILLS)

