#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pkg_config_test.py PREFIX LIBDIR COMPILER PROGRAM.cpp README.md: a program compiles with README's line, with pkg-config's flags alone, against
the compiled library, from headers alone and with MuJoCo, and finds the models, wherever the installed copy was moved to."""

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
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        moved = folder / "moved"
        for part in ("include", LIBDIR, "share"):
            shutil.copytree(f"{PREFIX}/{part}", moved / part)
        environment = {**os.environ, "PKG_CONFIG_PATH": f"{moved}/{LIBDIR}/pkgconfig"}
        shutil.copy(PROGRAM, folder / "first.cpp")
        line = re.search(r"`g\+\+ (.* trophic\) -o first)`", pathlib.Path(README).read_text())[1].replace("-O2 ", "")
        mujoco = (
            " trophic-mujoco) -DCONSUMER_HAS_mujoco"
            if (moved / LIBDIR / "pkgconfig/trophic-mujoco.pc").exists()
            else " trophic)"
        )
        for packages in (" trophic)", " trophic-header-only)", mujoco):
            subprocess.run(
                ["sh", "-c", f"{COMPILER} {line.replace(' trophic)', packages)}"],
                cwd=folder,
                env=environment,
                check=True,
            )
            done = subprocess.run(["./first"], cwd=folder, capture_output=True, text=True, check=True)
            assert f'spider in walled_square, from "{moved}/share/trophic/models/' in done.stdout, done.stdout
    return 0


if __name__ == "__main__":
    sys.exit(main())
