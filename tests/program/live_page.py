# SPDX-License-Identifier: MIT
"""A page of a live run, as a test: starts a program with --live and speaks with it by its web socket."""

import base64
import json
import os
import re
import socket
import struct
import subprocess

OPENING_S = 60


class LiveRun:
    """A program that runs with --live."""

    def __init__(self, command, folder, **how):
        self.process = subprocess.Popen(
            [*command, "--live"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **how
        )
        self.address = None
        for line in self.process.stdout:
            found = re.match(r"live    (http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32}))$", line)
            if found:
                self.address, self.port, self.token = found[1], int(found[2]), found[3]
                break
        if self.address is None:
            raise AssertionError(self.process.communicate()[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def wait(self):
        """Exit code and standard error of the program."""
        _, errors = self.process.communicate(timeout=OPENING_S)
        return self.process.returncode, errors

    def ask(self, request):
        """The answer to the bytes of a request: status and body."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=OPENING_S) as connection:
            connection.sendall(request)
            answer = b""
            try:
                while part := connection.recv(65536):
                    answer += part
            except ConnectionError:  # closed before all was read
                pass
        if not answer:
            return None, ""
        head, _, body = answer.partition(b"\r\n\r\n")
        return int(head.split()[1]), body.decode()

    def get(self, target, host=None, more=""):
        return self.ask(f"GET {target} HTTP/1.1\r\nHost: {host or f'127.0.0.1:{self.port}'}\r\n{more}\r\n".encode())

    def page(self, **headers):
        return Page(self, **headers)


class Page:
    """A web socket to a live run. `origin`, `host` and `token` as those of its own page unless given."""

    def __init__(self, run, origin=None, host=None, token=None):
        host = host or f"127.0.0.1:{run.port}"
        lines = [
            f"GET /live?token={run.token if token is None else token} HTTP/1.1",
            f"Host: {host}",
            "Upgrade: websocket",
            "Connection: Upgrade",
            "Sec-WebSocket-Version: 13",
            f"Sec-WebSocket-Key: {base64.b64encode(os.urandom(16)).decode()}",
            f"Origin: {origin or f'http://{host}'}",
        ]
        self.socket = socket.create_connection(("127.0.0.1", run.port), timeout=OPENING_S)
        self.socket.sendall("\r\n".join([*lines, "", ""]).encode())
        self.bytes = b""
        head = b""
        while not head.endswith(b"\r\n\r\n"):
            head += self.read(1)
        self.status = int(head.split()[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def read(self, count):
        while len(self.bytes) < count:
            part = self.socket.recv(65536)
            if not part:
                raise EOFError
            self.bytes += part
        taken, self.bytes = self.bytes[:count], self.bytes[count:]
        return taken

    def body(self):
        """What follows the head of a refusal."""
        try:
            while True:
                self.bytes += self.read(len(self.bytes) + 1)
        except EOFError:
            return self.bytes.decode()

    def send(self, wish):
        self.send_bytes((wish if isinstance(wish, str) else json.dumps(wish)).encode())

    def send_bytes(self, data):
        mask = os.urandom(4)
        size = len(data)
        head = bytes([0x81]) + (
            bytes([0x80 | size])
            if size < 126
            else bytes([0x80 | 126]) + struct.pack(">H", size)
            if size < 65536
            else bytes([0x80 | 127]) + struct.pack(">Q", size)
        )
        self.socket.sendall(head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(data)))

    def messages(self):
        """The messages of the run; bytes of poses are left out."""
        while True:
            kind, size = self.read(2)
            if size == 126:
                (size,) = struct.unpack(">H", self.read(2))
            elif size == 127:
                (size,) = struct.unpack(">Q", self.read(8))
            data = self.read(size)
            if kind & 0x0F == 8:
                raise EOFError
            if kind & 0x0F == 1:
                yield json.loads(data)

    def until(self, condition):
        """The first message for which a condition holds."""
        return next(message for message in self.messages() if condition(message))

    def until_kind(self, kind):
        return self.until(lambda message: message["kind"] == kind)
