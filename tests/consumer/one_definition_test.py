#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""one_definition_test.py OBJECT FUNCTION: of all definitions of an object, the linker would refuse this function alone in a second
object. The object's source includes all headers, so their definitions may stand in every part of a program."""

import subprocess
import sys

OBJECT, FUNCTION = sys.argv[1:]
MAY_STAND_TWICE = "abdnrtuUvVwW"  # local, weak, unique or undefined, as nm calls it


def main() -> int:
    symbols = subprocess.run(
        ["nm", "--demangle", OBJECT], text=True, capture_output=True, check=True
    ).stdout.splitlines()
    strong = [line[19:] for line in symbols if line[17] not in MAY_STAND_TWICE]  # address, kind, name
    if strong != [FUNCTION]:
        print(f"{OBJECT} must define {FUNCTION} alone, but has", *strong, sep="\n")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
