#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_commands.py ROOT: the README's two commands exist, continuous integration calls the second and nothing else, and every
local link leads to a file."""

import os
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
COMMANDS = ["scripts/quickstart", "scripts/run-tests"]


def main() -> int:
    readme = (ROOT / "README.md").read_text()
    offences = []
    shell = "".join(re.findall(r"^```sh\n(.*?)^```$", readme, re.MULTILINE | re.DOTALL)).splitlines()
    for command in COMMANDS:
        if command not in shell:
            offences.append(f"README: no line '{command}' in a sh block")
        if not os.access(ROOT / command, os.X_OK):
            offences.append(f"{command} is not an executable file")
    ci = [line for line in (ROOT / ".ci/run").read_text().splitlines() if line and not line.startswith(("#", "set ", "cd "))]
    if ci != [f"exec {COMMANDS[1]}"]:
        offences.append(f".ci/run must only call {COMMANDS[1]}, it has: {ci}")
    for link in re.findall(r"\]\(([^)#]+)[^)]*\)", readme):
        if "://" not in link and not (ROOT / link).exists():
            offences.append(f"README links to {link}, which does not exist")
    for offence in offences:
        print(offence)
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
