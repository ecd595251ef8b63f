"""Who may come in, and what is served to whom."""

import gzip

from harness import *  # noqa: F403
from websocket import Closed, Refused


@test("another address than loopback needs a token")
def _(place):
    for options in (["--host", "0.0.0.0"], ["--host", "0.0.0.0", "--token", "fifteen-letters"]):
        result = place.run("serve", "--port", "0", "--data", str(place.data), *options)
        equal(result.returncode, 2, "exit status")
        says(result.stderr, "token")


@test("the page of another site is refused, with or without a WebSocket")
def _(place):
    server = place.serve()
    try:
        server.client(headers={"Origin": "http://evil.example"})
        raise Failed("a foreign origin was let in")
    except Refused as refused:
        equal(refused.status, 403, "status")
        says(refused.body, "another site")
    answer, text = server.request("PUT", "/library/a.nc", b"M30\n", {"Origin": "http://evil.example"})
    equal(answer.status, 403, "status")
    says(text.decode(), "another site")
    server.client(headers={"Origin": f"http://127.0.0.1:{server.port}"}).do("machines")


@test("a name that leads to this computer by a foreign name server is refused")
def _(place):
    server = place.serve()
    answer, text = server.request("GET", "/api", headers={"Host": f"evil.example:{server.port}"})
    equal(answer.status, 403, "status")
    says(text.decode(), "localhost only")
    for host in ("localhost", "127.0.0.1", "[::1]"):
        equal(server.request("GET", "/api", headers={"Host": f"{host}:{server.port}"})[0].status, 200, host)


@test("without the token nobody comes in, with it everybody")
def _(place):
    server = place.serve("--host", "0.0.0.0", "--token", "secret-token-0001")
    answer, text = server.request("GET", "/")
    equal(answer.status, 401, "status")
    says(text.decode(), "token is needed")
    try:
        server.client().receive()
        raise Failed("a client without a token was let in")
    except Closed as closed:
        equal(closed.code, 1008, "close code")
        says(closed.reason, "token is needed")
    for wrong in ("secret-token-0002", "secret-token-000", "secret-token-00011", ""):
        equal(server.request("GET", f"/api?token={wrong}")[0].status, 401, wrong)
    equal(server.request("PUT", "/library/a.nc", b"M30\n")[0].status, 401, "an upload")
    server.client(path="/ws?token=secret-token-0001").do("machines")


@test("the token moves from the address into a cookie that scripts cannot read")
def _(place):
    server = place.serve("--host", "0.0.0.0", "--token", "secret-token-0001")
    answer, _text = server.request("GET", "/?token=secret-token-0001")
    equal(answer.status, 303, "status")
    equal(answer.getheader("Location"), "/", "where it goes on")
    cookie = answer.getheader("Set-Cookie")
    says(cookie, "HttpOnly", "SameSite=Strict")
    value = cookie.split(";")[0]
    check(server.request("GET", "/", headers={"Cookie": value})[0].status in (200, 503), "the page")
    server.client(headers={"Cookie": "other=1; " + value}).do("machines")


@test("the page is served compressed, and not again to who has it")
def _(place):
    server = place.serve()
    answer, body = server.request("GET", "/")
    if answer.status == 503:
        says(body.decode(), "tools/build_web")
        return
    equal(answer.status, 200, "status")
    equal(answer.getheader("Content-Encoding"), "gzip", "encoding")
    says(gzip.decompress(body).decode(), "<script")
    etag = answer.getheader("ETag")
    equal(server.request("GET", "/", headers={"If-None-Match": etag})[0].status, 304, "the second time")
    says(answer.getheader("Content-Security-Policy"), "default-src 'self'")


@test("what is not there, or not a request, is answered in words")
def _(place):
    server = place.serve()
    equal(server.request("GET", "/health")[0].status, 200, "health")
    answer, text = server.request("GET", "/nothing")
    equal(answer.status, 404, "status")
    says(text.decode(), "nothing at this address")
    equal(server.request("POST", "/", b"x")[0].status, 405, "POST")
    equal(server.request("GET", "/ws")[0].status, 426, "a WebSocket without an upgrade")
    answer, text = server.request("GET", "/", headers={"X": "x" * 20000})
    equal(answer.status, 431, "a header of 20 kB")
    says(text.decode(), "16 KiB")


@test("the licences of what others wrote are printed and served")
def _(place):
    notices = (place.root / "THIRD_PARTY_NOTICES").read_text()
    equal(place.run("notices").stdout, notices, "kerf notices")
    answer, text = place.serve().request("GET", "/notices")
    equal(answer.getheader("Content-Type"), "text/plain; charset=utf-8", "type")
    equal(text.decode(), notices, "/notices")


@test("the protocol in the documents is the one that is served")
def _(place):
    printed = place.run("serve", "--protocol")
    equal(printed.returncode, 0, "exit status")
    document = (place.root / "docs/panel-protocol.md").read_text()
    check(printed.stdout == document, "docs/panel-protocol.md: run `kerf serve --protocol > docs/panel-protocol.md`")
    says(place.serve().request("GET", "/api")[1].decode(), "cycle-start")
