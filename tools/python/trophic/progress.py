# SPDX-License-Identifier: MIT
"""The progress line of a program that Python started: as a bar of tqdm, or as the program draws it."""
from __future__ import annotations

import contextlib
import fcntl
import importlib.util
import os
import pty
import re
import struct
import sys
import termios
from collections.abc import Iterator

_LINE = re.compile(rb"\r([^\r\n]*)\x1b\[K")  # a line replaces the one before (include/trophic/observe/progress.hpp)
_COLUMNS = 160  # of the terminal that the program sees


def is_watched(asked: bool | None) -> bool:
    """Whether progress is shown: as asked, or else on a terminal and in a notebook."""
    return (sys.stderr.isatty() or "ipykernel" in sys.modules) if asked is None else asked


class Errors:
    """Takes what a program writes to standard error. If `watched`, the program sees a terminal there, so it draws its progress, which is drawn here."""

    def __init__(self, what: str, watched: bool):
        self._what = what
        self._drawn: _Tqdm | _Plain | None = None
        self._reader, self.writer = pty.openpty() if watched else os.pipe()
        if watched:
            attributes = termios.tcgetattr(self.writer)
            attributes[1] &= ~termios.OPOST  # type: ignore[operator]  # a new line stays one character
            termios.tcsetattr(self.writer, termios.TCSANOW, attributes)
            fcntl.ioctl(self.writer, termios.TIOCSWINSZ, struct.pack("HHHH", 24, _COLUMNS, 0, 0))

    def read(self) -> str:
        """All but the progress, when the program has closed it."""
        os.close(self.writer)
        said = b""
        try:
            for piece in self._pieces():
                said += piece
                lines = _LINE.findall(said)
                said = _LINE.sub(b"", said)
                if lines and lines[-1]:
                    self._draw(lines[-1].decode())
        finally:
            os.close(self._reader)
        return said.decode("utf-8", "surrogateescape")

    def end(self, done: bool) -> None:
        """Ends the drawing; `done`: the program has done all."""
        if self._drawn is not None:
            self._drawn.end(done)

    def _draw(self, line: str) -> None:
        if self._drawn is None:
            self._drawn = _Tqdm(self._what) if importlib.util.find_spec("tqdm") else _Plain()
        self._drawn.draw(line)

    def _pieces(self) -> Iterator[bytes]:
        with contextlib.suppress(OSError):  # a terminal that the last program closed gives an error on Linux
            while piece := os.read(self._reader, 1 << 16):
                yield piece


class _Tqdm:
    """The share that is done as a bar; behind it what the program tells beside the share and the remaining time."""

    def __init__(self, what: str):
        from tqdm.auto import tqdm

        form = "{desc}: {percentage:3.0f}%|{bar}| {elapsed}<{remaining}{postfix}"
        self._bar = tqdm(total=100.0, desc=what, bar_format=form)

    def draw(self, line: str) -> None:
        parts = line.split("  ")
        for part in parts:
            if found := re.fullmatch(r"([\d.]+) %", part):
                self._bar.n = min(100.0, float(found[1]))
        self._bar.set_postfix_str(", ".join(part for part in parts if not part.endswith((" %", " left"))))

    def end(self, done: bool) -> None:
        if done:
            self._bar.n = 100.0
            self._bar.set_postfix_str("", refresh=False)
        self._bar.close()


class _Plain:
    def draw(self, line: str) -> None:
        print(f"\r{line}\033[K", end="", file=sys.stderr, flush=True)

    def end(self, _: bool) -> None:
        print("\r\033[K", end="", file=sys.stderr, flush=True)
