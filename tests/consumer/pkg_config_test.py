#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pkg_config_test.py PREFIX LIBDIR COMPILER PROGRAM.cpp README.md: a program compiles with README's line, with pkg-config's flags alone, from
headers and against the compiled library, and finds the installed models."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PREFIX, LIBDIR, COMPILER, PROGRAM, README = sys.argv[1:]
SKIPPED = 77


def main() -> int:
    if not shutil.which("pkg-config"):
        print("pkg-config is not installed")
        return SKIPPED
    environment = {**os.environ, "PKG_CONFIG_PATH": f"{PREFIX}/{LIBDIR}/pkgconfig"}
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(PROGRAM, f"{folder}/first.cpp")
        line = re.search(r"`g\+\+ (.* trophic\) -o first)`", pathlib.Path(README).read_text())[1].replace("-O2 ", "")
        for command in (line, line.replace(" trophic)", " trophic-compiled)")):
            subprocess.run(["sh", "-c", f"{COMPILER} {command}"], cwd=folder, env=environment, check=True)
            done = subprocess.run(["./first"], cwd=folder, capture_output=True, text=True, check=True)
            assert f'spider in walled_square, from "{PREFIX}/share/' in done.stdout, done.stdout
    return 0


if __name__ == "__main__":
    sys.exit(main())
