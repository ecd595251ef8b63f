"""Programs on disk: uploads, revisions, and what is refused."""

import http.client
import os
import socket

import harness
from harness import *  # noqa: F403

MIB = 1 << 20


@test("a program that is uploaded can be read, listed, renamed and deleted")
def _(place):
    server = place.serve()
    text = "O1\nG0 X1.\nM30\n"
    answer, body = server.request("PUT", "/library/part%201.nc", text.encode())
    equal(answer.status, 201, body)
    client = server.client()
    equal(client.do("read", name="part 1.nc")["text"], text, "text")
    equal(server.request("GET", "/library/part%201.nc")[1].decode(), text, "over HTTP")
    client.do("rename", **{"from": "part 1.nc", "to": "part2.nc"})
    names = [p["name"] for p in client.do("programs")["programs"]]
    check("part2.nc" in names and "part 1.nc" not in names, names)
    client.do("delete", name="part2.nc")
    says(client.refused("read", name="part2.nc"), "no program part2.nc")
    equal(server.request("GET", "/library/part2.nc")[0].status, 404, "over HTTP")


@test("every save is a revision, also what somebody else has changed, and what was deleted")
def _(place):
    client = place.serve().client()
    for number in (1, 2, 3):
        equal(client.do("write", name="a.nc", text=f"O{number}\n")["revision"], number, "revision")
    (place.data / "library/a.nc").write_text("by hand\n")
    found = client.do("revisions", name="a.nc")["revisions"]
    equal([r["revision"] for r in found], [4, 3, 2, 1], "revisions")
    equal(client.do("read", name="a.nc", revision=2)["text"], "O2\n", "an old one")
    equal(client.do("read", name="a.nc", revision=4)["text"], "by hand\n", "what was changed by hand")
    client.do("delete", name="a.nc")
    equal(client.do("read", name="a.nc", revision=4)["text"], "by hand\n", "behind the deletion")
    says(client.refused("read", name="a.nc", revision=9), "no revision 9")


@test("renaming does not replace another program")
def _(place):
    client = place.serve().client()
    client.do("write", name="a.nc", text="A")
    client.do("write", name="b.nc", text="B")
    says(client.refused("rename", **{"from": "a.nc", "to": "b.nc"}), "already")
    equal(client.do("read", name="b.nc")["text"], "B", "text")


@test("no name leads out of the library")
def _(place):
    server = place.serve()
    client = server.client()
    secret = place.data / "secret.nc"
    secret.write_text("SECRET")
    (place.folder / "outside.nc").write_text("SECRET")
    names = ["../secret.nc", "..", ".", "", "/etc/passwd", "a/../../secret.nc", "..\\secret.nc", ".hidden", "a\u0000b", "a\nb",
             "x" * 101, " a.nc", "a.nc.", "con:1"]
    for name in names:
        for do in ("read", "delete", "revisions"):
            error = client.refused(do, name=name)
            check("SECRET" not in error, name)
        client.refused("write", name=name, text="X")
        client.refused("rename", **{"from": "flanges.nc", "to": name})
    for path in ("/library/../secret.nc", "/library/%2e%2e/secret.nc", "/library/..%2fsecret.nc", "/library//etc/passwd",
                 "/library/%2e%2e%2f%2e%2e%2foutside.nc"):
        for method in ("GET", "PUT"):
            answer, body = server.request(method, path, b"X" if method == "PUT" else None)
            check(answer.status in (400, 404), f"{method} {path}: {answer.status}")
            check(b"SECRET" not in body, path)
    equal(secret.read_text(), "SECRET", "the file outside")


@test("a symbolic link in the library is not followed")
def _(place):
    server = place.serve()
    client = server.client()
    target = place.folder / "target.nc"
    target.write_text("SECRET")
    os.symlink(target, place.data / "library/link.nc")
    says(client.refused("read", name="link.nc"), "no file")
    client.refused("write", name="link.nc", text="X")
    client.refused("delete", name="link.nc")
    equal(server.request("GET", "/library/link.nc")[0].status, 404, "GET")
    equal(server.request("PUT", "/library/link.nc", b"X")[0].status, 400, "PUT")
    equal(target.read_text(), "SECRET", "the file behind it")
    check("link.nc" not in [p["name"] for p in client.do("programs")["programs"]], "listed")


def leftovers(place):
    return [p.name for p in (place.data / "library").iterdir() if p.name.startswith(".") or p.name.startswith("big")]


@test("an upload of 1 GB is refused in words and in bounded memory")
def _(place):
    server = place.serve()
    before = server.memory_mib()
    connection = http.client.HTTPConnection(server.host, server.port, timeout=60)
    connection.putrequest("PUT", "/library/big.nc")
    connection.putheader("Content-Length", str(1 << 30))
    connection.endheaders()
    try:
        for _ in range(1024):
            connection.send(bytes(MIB))
    except OSError:
        pass  # the server has closed the connection meanwhile
    else:
        equal(connection.getresponse().status, 413, "status")
    equal(leftovers(place), [], "files")
    check(server.memory_mib("VmHWM") < before + 64 + harness.QUARANTINE_MIB, f"{before} MiB became {server.memory_mib('VmHWM')}")
    answer, body = server.request("PUT", "/library/big.nc", b"", {"Content-Length": str(1 << 30)})
    equal(answer.status, 413, "status")
    says(body.decode(), "256 MiB")


@test("an upload that does not say how long it is ends at 256 MiB, and nothing is kept")
def _(place):
    server = place.serve()
    before = server.memory_mib()
    raw = socket.create_connection((server.host, server.port), 60)
    raw.sendall(b"PUT /library/big.nc HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n")
    piece = b"100000\r\n" + bytes(MIB) + b"\r\n"
    answer = b""
    try:
        for _ in range(1024):
            raw.sendall(piece)
    except OSError:
        pass
    try:
        answer = raw.recv(4096)
    except OSError:
        pass
    check(answer == b"" or answer.startswith(b"HTTP/1.1 413"), answer[:40])
    equal(leftovers(place), [], "files")
    check(server.memory_mib("VmHWM") < before + 64 + harness.QUARANTINE_MIB, f"{before} MiB became {server.memory_mib('VmHWM')}")
    server.client().do("programs")


@test("an upload that breaks off leaves nothing behind")
def _(place):
    server = place.serve()
    raw = socket.create_connection((server.host, server.port), 20)
    raw.sendall(b"PUT /library/big.nc HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000\r\n\r\n" + b"x" * 500000)
    eventually(lambda: leftovers(place) != [], "the temporary file")
    raw.close()
    eventually(lambda: leftovers(place) == [], "its end")


@test("a large program is uploaded by a client that asks first")
def _(place):
    server = place.serve()
    raw = socket.create_connection((server.host, server.port), 20)
    text = b"G1 X1.\n" * (3 * MIB)
    raw.sendall(b"PUT /library/big.nc HTTP/1.1\r\nHost: localhost\r\nExpect: 100-continue\r\nContent-Length: %d\r\n\r\n"
                % len(text))
    says(raw.recv(100).decode(), "100 Continue")
    raw.sendall(text)
    says(raw.recv(1000).decode(), "201")
    equal((place.data / "library/big.nc").stat().st_size, len(text), "bytes")
    says(server.client().refused("read", name="big.nc"), "4 MiB")
