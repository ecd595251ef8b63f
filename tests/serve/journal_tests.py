"""What was done is saved, and done again by another program."""

from harness import *  # noqa: F403

PROGRAM = "O1\nG90 G21 G54\nDPRNT[RUN]\nG01 X20. F3000\n/G01 Y5.\nM00\nG01 X[#500] F3000\n#101=1/0\nM30\n"


@test("the journal of a run is done again by kerf replay, which ends where the machine stands")
def _(place):
    server = place.serve()
    client = server.client().watch("mill")
    client.do("set-variable", name="#500", value=30)
    client.load(PROGRAM)
    client.do("block-skip", levels=[1])
    client.do("override", feed=120)
    client.do("cycle-start")
    client.wait_for_status("stopped")
    client.do("override", feed=80)
    client.do("cycle-start")
    client.wait_for_status("alarm")
    answer = server.client().watch("mill", operate=False).do("journal")
    equal(answer["name"], "mill.journal.json", "name")
    check(str(place.folder) not in answer["text"], "folders of the server are not in it")
    path = place.folder / "mill.journal.json"
    path.write_text(answer["text"])
    done = place.run("replay", str(path))
    equal(done.returncode, 1, "an alarm")
    lines = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    state = client.state
    equal(lines["status"], "alarm", "status")
    check(abs(float(lines["time"].split()[0]) - state["time_s"]) < 1e-5, "time")
    check(state["alarm"]["code"] in lines["alarm"], lines["alarm"])


@test("a machine that nobody has touched has a journal, and so has one with another machine file")
def _(place):
    client = place.serve().client().watch("arm")
    client.do("set-settings", toml=client.do("settings")["toml"] + "\n# another\n")
    path = place.folder / "arm.journal.json"
    path.write_text(client.do("journal")["text"])
    check("# another" in path.read_text(), "the machine file")
    done = place.run("replay", str(path))
    equal((done.returncode, done.stdout), (0, "status: idle\ntime: 0 s\n"), "replay")
