"""The part on the panel, kept in the library: as a file of triangles, as the stock of the next program."""

import harness  # noqa: F401
from harness import *  # noqa: F403
from stock_tests import SLOT, SLOT_SET_UP, Part, mill


@test("the part is kept in the library, as triangles and as the stock of the next program")
def _(place):
    server = place.serve()
    client = server.client()
    client.do("create", name="miller", definition="mill3")
    client.watch("miller")
    says(client.refused("stock_export", format="stl"), "no program")
    client.load(SLOT, "part.nc")
    client.do("stock", toml=SLOT_SET_UP)
    says(client.refused("stock_export", format="obj"), "format")
    for form, head in (("stl", b""), ("glb", b"glTF"), ("3mf", b"PK"), ("kstock", b"KSTOCK1")):
        answer = client.do("stock_export", format=form)
        equal(answer["name"], f"part.{form}", "name")
        content = server.request("GET", f"/library/part.{form}")[1]
        equal(len(content), answer["bytes"], f"bytes of {form}")
        check(content.startswith(head), f"{form} begins with {content[:8]}")
    triangles = int.from_bytes(server.request("GET", "/library/part.stl")[1][80:84], "little")
    check(triangles > 100, f"{triangles} triangles")
    client.load(SLOT, "next.nc")
    client.do("stock", toml='[stock]\nshape = "part.kstock"\n')
    part = Part(client)
    client.do("stock", shows=True)
    part.wait_for_end()
    equal(part.facts["removed_mm3"], 0, "all of it is cut before")
    z, owner = part.height(35, 20)
    check(abs(z + 5) < 1e-3, f"the floor of the slot: {z}")


@test("a part does not take the place of what it is cut from, and one of half a program is no stock")
def _(place):
    client = mill(place)
    client.load(SLOT, "part.nc")
    client.do("stock", toml=SLOT_SET_UP)
    client.do("stock_export", format="kstock")
    client.do("stock", toml='[stock]\nshape = "part.kstock"\n')
    says(client.refused("stock_export", format="kstock"), "part.kstock is what the part is cut from")
    client.load(SLOT.replace("G00 Z50.", "G00 Z[1/0]"), "half.nc")
    client.do("stock", toml=SLOT_SET_UP)
    says(client.refused("stock_export", format="kstock"), "did not reach its end")
    check(client.do("stock_export", format="stl")["bytes"] > 84, "what is there by then can be looked at")
    says(client.refused("read", name="half.kstock"), "half.kstock")
