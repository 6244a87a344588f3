# SPDX-License-Identifier: MIT
"""Tests of programs that leave files: each test works in a temporary folder of its own."""

import csv
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
import zlib


def _named_skip(result, test, why, add=unittest.TextTestResult.addSkip):
    """A skipped test has a line, from which scripts/run-tests takes it."""
    add(result, test, why)
    print(f"\nskipped: {test.id().removeprefix('__main__.')}: {' '.join(why.split())}", file=sys.stderr)


unittest.TextTestResult.addSkip = _named_skip


def sealed_text(value):
    """A manifest or a list of replicates as trophic writes it, with its checksum at the end."""
    body = json.dumps({key: entry for key, entry in value.items() if key != "crc32"}, indent=2)[:-2]
    return f'{body},\n  "crc32": {zlib.crc32(body.encode())}\n}}\n'


def planned(program, sweep, out, cwd):
    """Writes the plan of a sweep file into a folder; the words that make its runs."""
    code = "import pathlib, sys; from trophic import plan; plan.make_plan(plan.read_sweep(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3]))"
    tools = pathlib.Path(__file__).resolve().parents[2] / "tools/python"
    python = sys.executable if importlib.util.find_spec("pandas") else "/usr/bin/python3"
    run_ok(python, "-c", code, sweep, program, out, cwd=cwd, env={**os.environ, "PYTHONPATH": str(tools)})
    return program, "--plan", f"{out}/plan.jsonl"


def call(*words, **how):
    """A command that has ended. `how` is for subprocess.run."""
    return subprocess.run([*map(str, words)], **{"capture_output": True, "text": True, "timeout": 300, **how})


def run_ok(*words, **how):
    """A command that has succeeded."""
    ended = call(*words, **how)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    return ended


def said_by(errors):
    """The lines on standard error, but for remarks on a run that began."""
    return [line for line in errors.strip().splitlines() if not line.startswith("remark  ")]


class InFolder(unittest.TestCase):
    program = ()  # the first words of each command of the class

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def call(self, *words, **how):
        return call(*self.program, *words, **{"cwd": self.folder, **how})

    def run_ok(self, *words, **how):
        return run_ok(*self.program, *words, **{"cwd": self.folder, **how})

    def assert_refused(self, ended, *parts, code=2):
        """A command has ended with this code and, but for remarks on a run that began, one line, which has these parts."""
        self.assertEqual(ended.returncode, code, ended.stdout + ended.stderr)
        self.assertEqual(len(said_by(ended.stderr)), 1, ended.stderr)
        for part in parts:
            self.assertIn(part, ended.stderr)

    def wait_for(self, pattern, program):
        """Until there is such a path in the folder, or the program has ended."""
        while not any(self.folder.glob(pattern)) and program.poll() is None:
            time.sleep(0.001)

    def rows(self, *path):
        """Of a CSV table in the folder, or in another one if the path is absolute."""
        with open(self.folder.joinpath(*path), newline="") as table:
            return list(csv.DictReader(table))

    def manifest(self, *run):
        return json.loads(self.folder.joinpath(*run, "manifest.json").read_text())


class InFolderWithSets(InFolder):
    """Also has `sets`, a folder that a class fills once with `make_sets` for all of its tests."""

    @classmethod
    def setUpClass(cls):
        cls.sets = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.make_sets()
