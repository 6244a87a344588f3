#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""few_packages_test.py ROOT COMPILER PROGRAM.cpp EIGEN_INCLUDE RANDOM123_INCLUDE: an include path, Eigen and Random123 are enough for a
kinematic program that needs no file: it compiles, links nothing, runs, and includes no other package's header. In C++17, or without Eigen, one
line says what is missing."""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT, COMPILER, PROGRAM, *PACKAGES = sys.argv[1:]
OTHERS = r"/(toml\+\+|nlohmann|boost|CLI|mujoco|ode)/|/zlib\.h$"


def main() -> int:
    flags = ["-std=c++20", f"-I{ROOT}/include", *(f"-I{folder}" for folder in PACKAGES)]
    for missing, wrong in {
        "trophic needs C++20: compile with -std=c++20": [*flags, "-std=c++17"],
        "Eigen/Geometry": flags[:2],
    }.items():
        said = subprocess.run([COMPILER, *wrong, "-fsyntax-only", PROGRAM], capture_output=True, text=True).stderr
        errors = [line for line in said.splitlines() if "error: " in line]
        assert len(errors) == 1 and missing in errors[0], said
    with tempfile.TemporaryDirectory() as folder:
        program, listed = pathlib.Path(folder) / "program", pathlib.Path(folder) / "headers"
        subprocess.run([COMPILER, *flags, "-MD", "-MF", listed, PROGRAM, "-o", program], check=True)
        others = [name for name in listed.read_text().split() if not name.startswith(ROOT) and re.search(OTHERS, name)]
        assert not others, others
        said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    assert said == "30 robots at 200 s\n", said
    return 0


if __name__ == "__main__":
    sys.exit(main())
