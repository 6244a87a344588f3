# SPDX-License-Identifier: MIT
"""Programs of the studies and of the installed trophic, those of PATH, and the modules of the studies."""

import csv
import pathlib
import subprocess
import sys

import pytest

STUDIES = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(STUDIES / "python"), str(STUDIES / "red_queen")]
import installed

installed.make_importable()


class Folder:
    """A temporary folder in which programs run."""

    def __init__(self, path):
        self.path = path

    def call(self, *words):
        return subprocess.run([*map(str, words)], cwd=self.path, capture_output=True, text=True)

    def run(self, *words):
        ended = self.call(*words)
        assert ended.returncode == 0, ended.stdout + ended.stderr
        return ended

    def rows(self, table):
        with open(self.path / table, newline="") as file:
            return list(csv.DictReader(file))

    def bytes_of(self, run, tables):
        return [(self.path / run / table).read_bytes() for table in tables]


@pytest.fixture
def folder(tmp_path):
    return Folder(tmp_path)
