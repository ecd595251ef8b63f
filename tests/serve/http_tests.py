"""HTTP by its framing: where a request ends, server and whoever stands before it must agree."""

import socket

from harness import *  # noqa: F403

SMUGGLED = b"GET /library/smuggled.nc HTTP/1.1\r\nHost: localhost\r\n\r\n"
LAST = b"GET /health HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"

# What may stand behind the header of a request: its framing, and the bytes that follow.
BODIES = {
    "no body": ("", b""),
    "Content-Length: 0": ("Content-Length: 0\r\n", b""),
    "Content-Length": (f"Content-Length: {len(SMUGGLED)}\r\n", SMUGGLED),
    "chunked": ("Transfer-Encoding: chunked\r\n", b"%x\r\n%s\r\n0\r\n\r\n" % (len(SMUGGLED), SMUGGLED)),
    "gzip, x": ("Transfer-Encoding: gzip, x\r\n", SMUGGLED),
    "xchunked": ("Transfer-Encoding: xchunked\r\n", SMUGGLED),
    "chunked, identity": ("Transfer-Encoding: chunked, identity\r\n", SMUGGLED),
    "gzip, chunked": ("Transfer-Encoding: gzip, chunked\r\n", SMUGGLED),
    "two codings": ("Transfer-Encoding: gzip\r\nTransfer-Encoding: chunked\r\n", SMUGGLED),
    "both lengths": (f"Content-Length: {len(SMUGGLED)}\r\nTransfer-Encoding: chunked\r\n", SMUGGLED),
}
WRONG_CODINGS = ("gzip, x", "xchunked", "chunked, identity", "gzip, chunked", "two codings", "both lengths")
ROUTES = ("/", "/?token=0123456789abcdef", "/api", "/health", "/nothing", "/ws", "/library/part.nc", "/library/none.nc",
          "/library/..%2fx", "/library/empty.nc")
METHODS = ("GET", "HEAD", "POST", "DELETE", "OPTIONS", "PUT")


def all_of(server, request, patience=20):
    """What comes back for these bytes until the connection ends."""
    with socket.create_connection((server.host, server.port), patience) as line:
        line.sendall(request)
        line.shutdown(socket.SHUT_WR)
        got = b""
        while piece := line.recv(1 << 16):
            got += piece
        return got


def answers(got, methods):
    """(status, fields, body) of each answer; fails where they do not fill the bytes exactly."""
    found = []
    while got:
        method = methods[min(len(found), len(methods) - 1)]
        head, mark, got = got.partition(b"\r\n\r\n")
        check(head.startswith(b"HTTP/1.") and mark, f"this is no answer: {head[:80]!r}")
        lines = head.decode().split("\r\n")
        fields = {k.lower(): v for k, v in (line.split(": ", 1) for line in lines[1:])}
        status = int(lines[0].split()[1])
        empty = method == "HEAD" or status in (204, 304) or status < 200
        size = 0 if empty else int(fields["content-length"])
        check(len(got) >= size, f"the body of {lines[0]} is cut off")
        found.append((status, fields, got[:size]))
        got = got[size:]
    return found


def request(method, route, fields="", body=b""):
    return f"{method} {route} HTTP/1.1\r\nHost: localhost\r\nIf-None-Match: \"x\"\r\n{fields}\r\n".encode() + body


@test("each route, method and body: one answer a request, no body behind HEAD, nothing smuggled")
def _(place):
    for options in ((), ("--token", "0123456789abcdef")):
        server = place.serve(*options, data=place.folder / f"data{len(options)}")
        for name, text in (("part.nc", b"O1\nM30\n"), ("empty.nc", b"")):
            (place.folder / f"data{len(options)}" / "library" / name).write_bytes(text)
        for route in ROUTES:
            for method in METHODS:
                for name, (fields, body) in BODIES.items():
                    if options:
                        fields += "Cookie: kerf_token=0123456789abcdef\r\n"
                    if method == "PUT" and name in ("Content-Length", "chunked") and route.endswith("part.nc"):
                        continue  # an upload: below
                    what = f"{method} {route}, {name}"
                    got = all_of(server, request(method, route, fields, body) + LAST)
                    made = answers(got, [method, "GET"])
                    check(1 <= len(made) <= 2, f"{what}: {len(made)} answers")
                    check(b"smuggled.nc" not in got, f"{what}: the body was taken for a request")
                    closed = made[0][1].get("connection") == "close"
                    equal(len(made), 1 if closed else 2, f"{what}: answers behind connection: {made[0][1].get('connection')}")
                    if name in WRONG_CODINGS:
                        check(made[0][0] in (400, 501), f"{what}: {made[0][0]}")
                    if name.startswith(("no body", "Content-Length: 0")) and method in ("GET", "HEAD"):
                        check(not closed, f"{what}: closed for nothing")


@test("HEAD tells the length that GET has")
def _(place):
    server = place.serve()
    (place.data / "library/part.nc").write_bytes(b"O1\nM30\n" * 100_000)
    for route in ("/", "/api", "/library/part.nc", "/library/none.nc"):
        got, head = (answers(all_of(server, request(method, route)), [method])[0] for method in ("GET", "HEAD"))
        equal(head[0], got[0], f"{route}: status")
        equal(head[1]["content-length"], got[1]["content-length"], f"{route}: length")
        equal(len(got[2]), int(got[1]["content-length"]), f"{route}: bytes")


@test("an upload in an unknown coding leaves the program as it was")
def _(place):
    server = place.serve()
    part = place.data / "library/part.nc"
    for name in WRONG_CODINGS:
        part.write_bytes(b"O1\nM30\n")
        fields, body = BODIES[name]
        made = answers(all_of(server, request("PUT", "/library/part.nc", fields, body)), ["PUT"])
        check(made[0][0] in (400, 501), f"{name}: {made[0][0]}")
        equal(part.read_bytes(), b"O1\nM30\n", name)


@test("an upload by length and in chunks is what was sent, and the next request is answered")
def _(place):
    server = place.serve()
    for name in ("Content-Length", "chunked"):
        fields, body = BODIES[name]
        made = answers(all_of(server, request("PUT", "/library/part.nc", fields, body) + LAST), ["PUT", "GET"])
        equal([m[0] for m in made], [201, 200], name)
        equal((place.data / "library/part.nc").read_bytes(), SMUGGLED, name)


@test("a body that is not well formed, or breaks off, is answered with 400 and nothing is kept")
def _(place):
    server = place.serve()
    chunked = "Transfer-Encoding: chunked\r\n"
    for name, fields, body in (
        ("no number", chunked, b"xyz\r\nabc\r\n0\r\n\r\n"),
        ("longer than told", chunked, b"3\r\nabcdef\r\n0\r\n\r\n"),
        ("a long extension", chunked, b"3;" + b"x" * 200_000 + b"\r\nabc\r\n0\r\n\r\n"),
        ("cut off", chunked, b"30\r\nabc"),
        ("cut off by length", "Content-Length: 100\r\n", b"abc"),
    ):
        made = answers(all_of(server, request("PUT", "/library/broken.nc", fields, body)), ["PUT"])
        equal([m[0] for m in made], [400], name)
        says(made[0][2].decode(), "nothing was kept")
        check(not (place.data / "library/broken.nc").exists(), name)


@test("headers that can be read in two ways are refused")
def _(place):
    server = place.serve()
    for name, text in (
        ("two Hosts", b"GET /api HTTP/1.1\r\nHost: localhost\r\nHost: other.example\r\n\r\n"),
        ("a folded line", b"GET /api HTTP/1.1\r\nHost: localhost\r\nX-A: b\r\n c: d\r\n\r\n"),
        ("a folded line with a tab", b"GET /api HTTP/1.1\r\nHost: localhost\r\nX-A: b\r\n\tc: d\r\n\r\n"),
        ("HTTP/1.0 in chunks", b"PUT /library/a.nc HTTP/1.0\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n"),
    ):
        equal(answers(all_of(server, text), ["GET"])[0][0], 400, name)
    # Piece by piece it is the same request.
    with socket.create_connection((server.host, server.port), 20) as line:
        for byte in b"GET /api HTTP/1.1\r\nHost: localhost\r\nX-A: b\r\n c: d\r\n\r\n":
            line.sendall(bytes([byte]))
        says(line.recv(4096).decode(), "400 Bad Request")


@test("a Host that only begins like this computer is another one, for every address")
def _(place):
    server = place.serve()
    for host in ("[::1]evil", "[::1]evil:80", "[::1", "localhost.evil.example", "127.0.0.1.evil.example"):
        for route in ("/api", "/health"):
            text = f"GET {route} HTTP/1.1\r\nHost: {host}\r\n\r\n".encode()
            equal(answers(all_of(server, text), ["GET"])[0][0], 403, f"{route} of {host}")


@test("fifty requests at once have fifty answers")
def _(place):
    server = place.serve()
    (place.data / "library/part.nc").write_bytes(b"O1\nM30\n")
    routes = ["/health", "/library/part.nc", "/nothing", "/api", "/library/none.nc"] * 10
    made = answers(all_of(server, b"".join(request("GET", route) for route in routes)), ["GET"])
    equal([m[0] for m in made], [200, 200, 404, 200, 404] * 10, "statuses")
