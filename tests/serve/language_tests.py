"""Languages: which one a text is in, and the tokens of its lines."""

import time

from harness import *  # noqa: F403

KIB = 1 << 10


def hello(client):
    said = lambda: [e for e in client.events if e["event"] == "hello"]
    client.wait_for(said, "hello")
    return said()[0]


def kinds(client, dialect, line):
    names = hello(client)["token_kinds"]
    tokens = client.do("tokens", dialect=dialect, lines=line)["tokens"][0]
    return [f"{names[kind]} {length}" for kind, length in zip(tokens[::2], tokens[1::2])]


@test("the first event tells what there is to know of each dialect")
def _(place):
    dialects = {d["name"]: d for d in hello(place.serve().client())["dialects"]}
    equal(list(dialects), ["fanuc-mill", "fanuc-lathe", "laser-basic", "teach", "motion", "pattern"], "dialects")
    equal(dialects["teach"]["comment"], [";", ""], "comment")
    equal(dialects["fanuc-mill"]["shows_by_ending"], False, "G-code has everybody's endings")
    equal([d["name"] for d in dialects.values() if d["is_listing"]], ["pattern"], "listings")


@test("a text is in the dialect of its ending, of its first lines, of the machine")
def _(place):
    client = place.serve().client()
    dialect = lambda name, text: client.do("dialect", name=name, text=text)["dialect"]
    equal(dialect("a.bas", "G01"), "laser-basic", "ending")
    equal(dialect("a.nc", "\nTEACH 1\n"), "teach", "first lines")
    equal(dialect("a.nc", "G01"), "fanuc-mill", "no machine")
    definition = client.do("watch", machine="laser")["definition"]
    equal(dialect("a.nc", "G01"), definition["dialect"], "machine")


@test("lines are cut as the compiler reads them, in units of UTF-16")
def _(place):
    client = place.serve().client()
    equal(kinds(client, "fanuc-mill", "IF[#1GT2]GOTO3"),
          ["keyword 2", "operator 1", "variable 2", "operator 2", "number 1", "operator 1", "keyword 4", "target 1"])
    equal(kinds(client, "fanuc-mill", "G01(程式😀)X1"), ["command 3", "comment 6", "dimension 2"])
    equal(kinds(client, "laser-basic", "wait(1) ' so"),
          ["command 4", "operator 1", "number 1", "operator 1", "blank 1", "comment 4"])
    equal(client.do("tokens", dialect="teach", lines="END\n\nEND")["tokens"][1], [], "an empty line")
    says(client.refused("tokens", dialect="rs274", lines=""), "one of fanuc-mill")
    says(client.refused("tokens", dialect="teach", lines=" " * (32 * KIB + 1)), "at most 32768 bytes")


@test("tokens of a screen come at once, whatever else is asked for")
def _(place):
    server = place.serve()
    busy = server.client()
    lines = "\n".join(f"N{i} G01 X{i}.5 Y[#1+COS[{i}]] (LINE {i})" for i in range(60))
    busy.post("check", name="long.nc", text="#1=#1+1\n" * 100_000)
    client = server.client()
    times = []
    for _ in range(20):
        began = time.monotonic()
        client.do("tokens", dialect="fanuc-mill", lines=lines)
        times.append(time.monotonic() - began)
    check(sorted(times)[10] < 0.1 * PATIENCE, times)


@test("a machine tells the groups of its modal codes, and the dialect of its program")
def _(place):
    client = place.serve().client()
    groups = client.do("watch", machine="mill")["definition"]["modal_groups"]
    equal([g["group"] for g in groups][:4], ["motion", "cycle", "plane", "distance"], "groups")
    codes = {c["code"]: c for g in groups for c in g["codes"]}
    equal(codes["G01"], {"code": "G01", "title": "Line", "sentence": "A straight cut at the feed F.", "quiet": False})
    check(codes["G40"]["quiet"] and codes["G21"]["quiet"] and not codes["G54"]["quiet"], codes)
    client.do("create", name="turning", definition="lathe2")
    groups = client.do("watch", machine="turning")["definition"]["modal_groups"]
    numbers = {g["group"]: g["number"] for g in groups}
    equal((numbers["plane"], numbers["speed"], numbers["feed"]), (16, 2, 5), "groups of a lathe")
    check("scaling" not in numbers and "distance" not in numbers, f"system A has no G91: {numbers}")
    codes = {c["code"]: (g["group"], c["title"]) for g in groups for c in g["codes"]}
    equal((codes["G98"][0], codes["G99"][0], codes["G90"][0]), ("feed", "feed", "motion"), "codes of system A")
    paths = lambda: [e for e in client.events if e["event"] == "path" and e["machine"] == "laser"]
    client.watch("laser")
    client.wait_for(paths, "a path")
    equal(paths()[0]["dialect"], "laser-basic", "of its program")
