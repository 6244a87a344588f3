#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pkg_config_test.py PREFIX LIBDIR COMPILER PROGRAM.cpp: a program compiles with pkg-config's flags alone, from headers and against the
compiled library, and finds the installed models."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

PREFIX, LIBDIR, COMPILER, PROGRAM = sys.argv[1:]
SKIPPED = 77


def main() -> int:
    if not shutil.which("pkg-config"):
        print("pkg-config is not installed")
        return SKIPPED
    environment = {**os.environ, "PKG_CONFIG_PATH": f"{PREFIX}/{LIBDIR}/pkgconfig"}
    with tempfile.TemporaryDirectory() as folder:
        for package in ("trophic", "trophic-compiled"):
            program = pathlib.Path(folder) / package
            command = f"{COMPILER} -std=c++20 {PROGRAM} $(pkg-config --cflags --libs {package}) -o {program}"
            subprocess.run(["sh", "-c", command], env=environment, check=True)
            done = subprocess.run([program], cwd=folder, capture_output=True, text=True, check=True)
            assert f'spider in walled_square, from "{PREFIX}/share/' in done.stdout, done.stdout
    return 0


if __name__ == "__main__":
    sys.exit(main())
