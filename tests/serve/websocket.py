"""A WebSocket client of the standard library alone, which can also break the rules on purpose."""

import base64
import hashlib
import os
import socket
import struct

GUID = b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


class Closed(Exception):
    """The server has closed the connection: its code and its reason."""

    def __init__(self, code, reason):
        super().__init__(f"closed with {code}: {reason}")
        self.code = code
        self.reason = reason


class Refused(Exception):
    """The server has not opened a WebSocket: its status and its body."""

    def __init__(self, status, body):
        super().__init__(f"refused with {status}: {body}")
        self.status = status
        self.body = body


class WebSocket:
    def __init__(self, host, port, path="/ws", headers=None, receive_buffer=None):
        self.socket = socket.socket()
        if receive_buffer:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        self.socket.settimeout(20)
        self.socket.connect((host, port))
        self.pending = b""
        self._open(host, port, path, headers or {})

    def _open(self, host, port, path, headers):
        key = base64.b64encode(os.urandom(16)).decode()
        lines = {
            "Host": f"{host}:{port}",
            "Upgrade": "websocket",
            "Connection": "Upgrade",
            "Sec-WebSocket-Key": key,
            "Sec-WebSocket-Version": "13",
            **headers,
        }
        head = f"GET {path} HTTP/1.1\r\n" + "".join(f"{k}: {v}\r\n" for k, v in lines.items())
        self.socket.sendall(head.encode() + b"\r\n")
        while b"\r\n\r\n" not in self.pending:
            self._more()
        head, _, self.pending = self.pending.partition(b"\r\n\r\n")
        status = int(head.split()[1])
        if status != 101:
            raise Refused(status, self._rest().decode())
        accept = base64.b64encode(hashlib.sha1(key.encode() + GUID).digest())
        assert b"Sec-WebSocket-Accept: " + accept in head, head

    def _rest(self):
        try:
            while True:
                self._more()
        except (Closed, OSError):
            return self.pending

    def _more(self):
        data = self.socket.recv(1 << 16)
        if not data:
            raise Closed(1006, "without a close frame")
        self.pending += data

    def _take(self, count):
        while len(self.pending) < count:
            self._more()
        taken, self.pending = self.pending[:count], self.pending[count:]
        return taken

    def frame(self, opcode, payload, final=True, masked=True, reserved=0):
        """The bytes of a frame; what is not masked, or has reserved bits, breaks the rules."""
        head = bytes([(0x80 if final else 0) | reserved | opcode])
        mask_bit = 0x80 if masked else 0
        if len(payload) < 126:
            head += bytes([mask_bit | len(payload)])
        elif len(payload) < 1 << 16:
            head += bytes([mask_bit | 126]) + struct.pack(">H", len(payload))
        else:
            head += bytes([mask_bit | 127]) + struct.pack(">Q", len(payload))
        if not masked:
            return head + payload
        mask = os.urandom(4)
        long_mask = (mask * (len(payload) // 4 + 1))[: len(payload)]
        scrambled = (
            int.from_bytes(payload, "big") ^ int.from_bytes(long_mask, "big")
        ).to_bytes(len(payload), "big")
        return head + mask + scrambled

    def send_raw(self, data):
        self.socket.sendall(data)

    def send(self, text):
        self.send_raw(self.frame(TEXT, text.encode()))

    def receive(self, timeout=20):
        """The next message: str or bytes. Answers pings on the way."""
        self.socket.settimeout(timeout)
        first, second = self._take(2)
        opcode, size = first & 15, second & 127
        if size == 126:
            size = struct.unpack(">H", self._take(2))[0]
        elif size == 127:
            size = struct.unpack(">Q", self._take(8))[0]
        payload = self._take(size)
        assert first & 0x80, "the server does not split its messages"
        if opcode == CLOSE:
            code = struct.unpack(">H", payload[:2])[0] if payload else 1005
            raise Closed(code, payload[2:].decode())
        if opcode == PING:
            self.send_raw(self.frame(PONG, payload))
            return self.receive(timeout)
        return payload.decode() if opcode == TEXT else payload

    def close(self):
        self.socket.close()
