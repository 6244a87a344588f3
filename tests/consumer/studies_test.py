#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""studies_test.py ROOT PREFIX CMAKE COMPILER: a copy of studies/ outside the tree builds on the trophic installed in PREFIX, runs a stage at a fraction
of its length, and passes the tests of two programs and of the studies' scripts. The other programs take more minutes to compile."""

import csv
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "program"))
import figures_python

ROOT, PREFIX, CMAKE, COMPILER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), *sys.argv[3:]
TESTS = ["authors_log", "red_queen", "open_ended", "readings", "ablations"]


def main() -> int:
    python = figures_python.PYTHON
    if python is None or subprocess.run([python, "-c", "import pytest"], capture_output=True).returncode != 0:
        print("no Python with matplotlib, pandas, pytest and scipy")
        return 77
    with tempfile.TemporaryDirectory() as name:
        studies, build = pathlib.Path(name) / "studies", pathlib.Path(name) / "build"
        shutil.copytree(ROOT / "studies", studies, ignore=shutil.ignore_patterns("__pycache__"))
        variables = os.environ | {
            "PATH": f"{PREFIX}/bin:{build}:{os.environ['PATH']}",
            "TROPHIC_PYTHON": python,
            "PYTHONDONTWRITEBYTECODE": "1",
        }

        def run(*command: object) -> None:
            done = subprocess.run([*map(str, command)], cwd=name, env=variables, capture_output=True, text=True)
            assert done.returncode == 0, f"{command}: {done.stdout[-3000:]}{done.stderr[-3000:]}"

        run(
            CMAKE,
            "-S",
            studies,
            "-B",
            build,
            f"-DCMAKE_PREFIX_PATH={PREFIX}",
            f"-DCMAKE_CXX_COMPILER={COMPILER}",
            "-DCMAKE_COMPILE_WARNING_AS_ERROR=ON",
        )
        run(CMAKE, "--build", build, "--parallel", 2, "--target", "trophic-readings", "trophic-ablations")
        run(python, studies / "reproduce", "--out", "quick", "--programs", build, "--quick", "ranges")
        with open(f"{name}/quick/data/ranges.csv", newline="") as file:
            cells = {(row["parent"], row["range_m"], row["activation_m"]) for row in csv.DictReader(file)}
        assert len(cells) == 4, cells
        run(
            python,
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            *(studies / f"tests/test_{test}.py" for test in TESTS),
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
