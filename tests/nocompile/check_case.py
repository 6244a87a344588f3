#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_case.py COMPILE_COMMANDS.json CASE.cpp: the case fails to compile and says what it must; with -DVALID it compiles."""

import json
import os
import pathlib
import shlex
import subprocess
import sys


def compile_command(database: str, source: str) -> tuple[list[str], str]:
    """The build system's own command for the source, without its output file."""
    for entry in json.loads(pathlib.Path(database).read_text()):
        if os.path.samefile(os.path.join(entry["directory"], entry["file"]), source):
            words = shlex.split(entry["command"])
            output = words.index("-o")
            return words[:output] + words[output + 2 :], entry["directory"]
    sys.exit(f"{source} is not in {database}")


def main() -> int:
    database, source = sys.argv[1:]
    expected = [
        line.split("// expect: ", 1)[1].strip()
        for line in pathlib.Path(source).read_text().splitlines()
        if line.startswith("// expect: ")
    ]
    if not expected:
        sys.exit(f"{source} has no line '// expect: SENTENCE'")
    command, directory = compile_command(database, source)

    def compiled(*flags: str) -> subprocess.CompletedProcess:
        return subprocess.run(
            [*command, *flags, "-o", os.devnull], cwd=directory, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
        )

    valid = compiled("-DVALID")
    if valid.returncode != 0:
        print("does not compile with -DVALID, so the mistake is not what stops it:", valid.stdout, sep="\n")
        return 1
    invalid = compiled()
    if invalid.returncode == 0:
        print("compiles, although it must not")
        return 1
    missing = [sentence for sentence in expected if sentence not in invalid.stdout]
    if missing:
        print("fails to compile without saying:", *missing, "\nbut with:", invalid.stdout, sep="\n")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
