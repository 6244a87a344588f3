#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""missing_folder_test.py ROOT CMAKE COMPILER: a folder of tests that is missing, or that no list contains, fails configuration."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT, CMAKE, COMPILER = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]


def configured(source: pathlib.Path, build: pathlib.Path) -> subprocess.CompletedProcess:
    options = ["-DTROPHIC_BUILD_EXAMPLES=OFF", "-DTROPHIC_BACKEND_MUJOCO=OFF", "-DTROPHIC_BACKEND_ODE=OFF", f"-DCMAKE_CXX_COMPILER={COMPILER}"]
    return subprocess.run([CMAKE, "-S", source, "-B", build, *options], capture_output=True, text=True)


def main() -> int:
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        copy, build = pathlib.Path(folder) / "trophic", pathlib.Path(folder) / "build"
        shutil.copytree(ROOT, copy, symlinks=True, ignore=shutil.ignore_patterns("build", ".git", ".cache", "runs", "node_modules"))

        def refused(sentence: str) -> None:
            done = configured(copy, build)
            said = " ".join(done.stderr.split())
            if done.returncode == 0 or sentence not in said:
                failures.append(f"must be refused with '{sentence}', said: {said}")

        (copy / "tests/kernel").rename(copy / "kernel-away")
        refused("tests/kernel are missing")
        (copy / "kernel-away").rename(copy / "tests/kernel")
        (copy / "tests/forgotten").mkdir()
        (copy / "tests/forgotten/CMakeLists.txt").write_text("")
        refused("does not list forgotten")
    print("\n".join(failures) or "both were refused")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
