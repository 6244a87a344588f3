#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""headers_compile_alone.py COMPILE_COMMANDS.json SOURCE HEADERS.txt: the compiler takes each header that HEADERS.txt names, one a
line, with nothing before it, by the flags of SOURCE. All are tried; those that fail are printed."""

import concurrent.futures
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from compile_command import compile_command  # noqa: E402


def main() -> int:
    database, source, listed = sys.argv[1:]
    headers = pathlib.Path(listed).read_text().split()
    if not headers:
        sys.exit(f"{listed} names no header")
    command, directory = compile_command(database, source)

    def complaint(header: str) -> str:
        # Not as the main file, in which `#pragma once` is a warning.
        done = subprocess.run(
            [*command, "-include", header, "-x", "c++", "/dev/null"], cwd=directory, capture_output=True, text=True
        )
        return "" if done.returncode == 0 else f"{header}:\n{done.stderr}"

    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        complaints = [text for text in pool.map(complaint, headers) if text]
    print(*complaints, f"{len(headers) - len(complaints)} of {len(headers)} headers compile alone", sep="\n")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
