#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tutorial_test.py ROOT PREFIX FOLDER COMPILER: follows the tutorial from its first file to its figure, with the trophic installed in PREFIX."""

import csv
import json
import pathlib
import shutil
import sys

from follow import PYTHON, follow

ROOT, PREFIX, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
SKIPPED = 77


def main() -> int:
    if not PYTHON:
        print("no Python with matplotlib and pandas")
        return SKIPPED
    shutil.rmtree(FOLDER, ignore_errors=True)
    (FOLDER / "bin").mkdir(parents=True)
    (FOLDER / "bin/python3").symlink_to(PYTHON)
    path = f"{FOLDER}/bin:{PREFIX}/bin:{__import__('os').environ['PATH']}"
    follow(ROOT / "docs/tutorial.md", FOLDER, {"PATH": path, "CMAKE_PREFIX_PATH": str(PREFIX), "CXX": sys.argv[4]})

    assert (FOLDER / "tags.png").stat().st_size > 10_000, "no figure"
    manifest = json.loads((FOLDER / "runs/chain/replicate-00/manifest.json").read_text())
    assert manifest["status"] == "complete" and manifest["rule_table"] == "wearing_chain", manifest
    with open(FOLDER / "runs/chain/replicate-00/events.csv") as file:
        deaths = [row for row in csv.DictReader(file) if row["event"] == "death"]
    assert {row["species"] for row in deaths} >= {"grazer", "hunter"}, "two species at least must have died"
    assert any(row["cause"] == "senescence" for row in deaths), "no individual died of wear"
    assert (FOLDER / "analysis/metrics.csv").is_file()
    assert (FOLDER / "census.html").stat().st_size > 500_000, "no page"
    with open(FOLDER / "runs/census/tags.csv") as file:
        assert {row["species"] for row in csv.DictReader(file)} == {"grazer", "hunter", "apex"}
    return 0


if __name__ == "__main__":
    sys.exit(main())
