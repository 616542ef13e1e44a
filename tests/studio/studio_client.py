# SPDX-License-Identifier: Apache-2.0
"""A running studio, and clients that connect to it like a page or like a stranger: HTTP and WebSocket over plain
sockets."""

from __future__ import annotations

import base64
import json
import os
import re
import signal
import socket
import struct
import subprocess
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any


PAGES: list[Page] = []  # all pages that were connected, with their messages


@dataclass
class Response:
    status: int
    headers: dict[str, str]
    body: bytes


class Studio:
    """The program, serving a folder on a port of its own. With `environment`, which may name a desktop, it opens a browser."""

    def __init__(self, program: str, root: Path, *arguments: str, path: str | None = None,
                 environment: dict[str, str] | None = None) -> None:  # fmt: skip
        browser = ["--no-browser"] if environment is None else []
        self.process = subprocess.Popen(
            [program, "studio", *browser, "--port", "0", "--root", str(root), *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            env=os.environ | ({"PATH": path} if path else {}) | (environment or {}),
        )  # fmt: skip
        assert self.process.stdout is not None
        self.address = self.process.stdout.readline().strip()
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/([0-9a-f]{32})/", self.address)
        assert found, f"no address but {self.address!r}"
        self.port, self.token = int(found[1]), found[2]

    def __enter__(self) -> Studio:
        return self

    def __exit__(self, *_: object) -> None:
        if self.process.poll() is None:
            self.stop()
        for stream in (self.process.stdout, self.process.stderr):
            if stream is not None:
                stream.close()

    def stop(self, by: signal.Signals = signal.SIGINT) -> int:
        self.process.send_signal(by)
        return self.process.wait(timeout=60)

    def connect(self) -> socket.socket:
        return socket.create_connection(("127.0.0.1", self.port), timeout=60)

    def raw(self, request: bytes) -> Response:
        """Sends bytes and returns the answer."""
        with self.connect() as connection:
            connection.sendall(request)
            return read_response(connection.makefile("rb"))

    def get(self, path: str = "", *, method: str = "GET", host: str | None = None, **headers: str) -> Response:
        """Asks for a path below the token; a `path` that begins with "/" is asked for as it is."""
        target = path if path.startswith("/") else f"/{self.token}/{path}"
        lines = [f"{method} {target} HTTP/1.1", f"Host: {host or f'127.0.0.1:{self.port}'}", "Connection: close"]
        lines += [f"{name.replace('_', '-')}: {value}" for name, value in headers.items()]
        return self.raw("\r\n".join([*lines, "", ""]).encode())

    def page(self) -> Page:
        page = Page(self)
        PAGES.append(page)
        return page


def read_response(stream: Any) -> Response:
    first = stream.readline().decode()
    status = int(first.split()[1]) if first else 0
    headers = {}
    while (line := stream.readline().decode().strip()) != "":
        name, _, value = line.partition(":")
        headers[name.lower()] = value.strip()
    length = headers.get("content-length")
    body = stream.read(int(length)) if length is not None else b""
    return Response(status, headers, body)


class Closed(Exception):
    def __init__(self, code: int, reason: str) -> None:
        super().__init__(f"{code} {reason}")
        self.code, self.reason = code, reason


def upgrade(studio: Studio, origin: str | None, host: str | None = None) -> tuple[socket.socket, Any, Response]:
    connection = studio.connect()
    key = base64.b64encode(os.urandom(16)).decode()
    lines = [
        f"GET /{studio.token}/socket HTTP/1.1", f"Host: {host or f'127.0.0.1:{studio.port}'}", "Upgrade: websocket",
        "Connection: Upgrade", f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13",
    ]  # fmt: skip
    if origin is not None:
        lines.append(f"Origin: {origin}")
    connection.sendall("\r\n".join([*lines, "", ""]).encode())
    stream = connection.makefile("rb")
    return connection, stream, read_response(stream)


def check_recorded(program: str, folder: Path) -> list[str]:
    """Compares the messages of all pages with the tables of the protocol. Returns a line for each fault.

    In:  the program meristem_studio_protocol; a folder for a file of each page.
    """
    faults = []
    for number, page in enumerate(PAGES):
        file = folder / f"page_{number}.jsonl"
        file.write_text("".join(json.dumps(message) + "\n" for message in page.recorded))
        checked = subprocess.run([program, "--check", str(file)], capture_output=True, text=True, check=False)
        assert checked.returncode in (0, 1) and not checked.stderr, checked.stderr
        faults += [line for line in checked.stdout.splitlines() if not line.startswith("answered ")]
    return faults


@dataclass
class Page:
    """A page that takes packets over: it counts them, and says that it shows them."""

    studio: Studio
    messages: list[dict[str, Any]] = field(default_factory=list)  # of the server, without packets
    recorded: list[dict[str, Any]] = field(default_factory=list)  # requests, messages and heads of packets, in order
    packets: list[tuple[dict[str, Any], int]] = field(default_factory=list)  # heads and sizes
    hash: str = ""

    def __post_init__(self) -> None:
        self.id = 0
        self.connection, self.stream, response = upgrade(self.studio, f"http://127.0.0.1:{self.studio.port}")
        assert response.status == 101, response
        self.hello = self.wait(lambda message: message["is"] == "hello")

    def __enter__(self) -> Page:
        return self

    def __exit__(self, *_: object) -> None:
        self.stream.close()
        self.connection.close()

    def send_frame(self, opcode: int, payload: bytes) -> None:
        mask = os.urandom(4)
        size = len(payload)
        if size < 126:
            head = struct.pack(">BB", 0x80 | opcode, 0x80 | size)
        elif size < 65536:
            head = struct.pack(">BBH", 0x80 | opcode, 0x80 | 126, size)
        else:
            head = struct.pack(">BBQ", 0x80 | opcode, 0x80 | 127, size)
        repeated = mask * (size // 4 + 1)
        masked = (int.from_bytes(payload, "big") ^ int.from_bytes(repeated[:size], "big")).to_bytes(size, "big")
        self.connection.sendall(head + mask + masked)

    def read_frame(self) -> tuple[int, bytes]:
        head = self.stream.read(2)
        if len(head) < 2:
            raise Closed(1006, "")
        size = head[1] & 0x7F
        if size == 126:
            size = struct.unpack(">H", self.stream.read(2))[0]
        elif size == 127:
            size = struct.unpack(">Q", self.stream.read(8))[0]
        return head[0] & 0x0F, self.stream.read(size)

    def receive(self) -> dict[str, Any] | None:
        """Receives one message. Returns None for a packet."""
        while True:
            opcode, payload = self.read_frame()
            if opcode == 1:
                message = json.loads(payload)
                self.messages.append(message)
                self.recorded.append(message)
                return message
            if opcode == 2:
                assert payload[:4] in (b"MSP1", b"MSA1")
                size = struct.unpack("<I", payload[4:8])[0]
                head = json.loads(payload[8 : 8 + size])
                self.recorded.append(head)
                if payload[:4] == b"MSA1":
                    self.messages.append(head)
                    return head
                self.packets.append((head, len(payload)))
                self.send("shown", packet=head["packet"])
                return None
            if opcode == 8:
                code = struct.unpack(">H", payload[:2])[0] if payload else 1005
                raise Closed(code, payload[2:].decode())

    def wait(self, holds: Any) -> dict[str, Any]:
        while True:
            message = self.receive()
            if message is not None and holds(message):
                return message

    def send(self, what: str, **members: Any) -> int:
        self.id += 1
        request = {"do": what, "id": self.id, **members}
        self.recorded.append({"do": what, "id": self.id})
        self.send_frame(1, json.dumps(request).encode())
        return self.id

    def ask(self, what: str, **members: Any) -> dict[str, Any]:
        number = self.send(what, **members)
        answer = self.wait(lambda message: message.get("re") == number and message["is"] != "working")
        self.hash = answer.get("hash", self.hash)
        return answer

    def edit(self, *edits: dict[str, Any]) -> dict[str, Any]:
        return self.ask("edit", base=self.hash, edits=list(edits))

    def show(self) -> tuple[dict[str, Any], int]:
        """The packet that shows the present text in full."""
        while True:
            if self.packets and self.packets[-1][0]["hash"] == self.hash and not self.packets[-1][0]["draft"]:
                return self.packets[-1]
            self.receive()
