# SPDX-License-Identifier: MIT
"""Exceptions whose message names the file, the option or the folder, and the printing of users' names."""
from __future__ import annotations

import contextlib
import re
import sys


class RunError(ValueError):
    """Raised for a folder that is not a run or a set of runs; the message names it."""


class ProgramError(RuntimeError):
    """Raised if a program does not exist or fails; the message is the program's own."""


def printable(text: str) -> str:
    """Writes control characters, which the name of a file may have, as \\x0a."""
    return re.sub(
        r"[\x00-\x1f\x7f-\x9f\u2028\u2029]", lambda found: "".join(f"\\x{byte:02x}" for byte in found[0].encode()), text
    )


def remark(who: str, text: object) -> None:
    """A line on standard error, if that is not closed."""
    with contextlib.suppress(OSError):
        print(f"{who}: {printable(str(text))}", file=sys.stderr)
