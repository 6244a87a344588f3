#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""meadow_test.py MEADOW: a living world of a project of one's own has replicates, shadows and runs that resume."""

import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

MEADOW = sys.argv.pop(1)
SOURCE = pathlib.Path(__file__).with_name("project") / "meadow.cpp"


class Meadow(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def call(self, *words):
        done = subprocess.run([*map(str, words)], capture_output=True, text=True, cwd=self.folder, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_its_source_has_25_lines(self):
        lines = [line for line in SOURCE.read_text().splitlines() if line and not line.startswith(("//", "#include", "using namespace"))]
        self.assertLessEqual(len(lines), 25)

    def test_killed_set_with_shadows_that_resumes_to_the_same_bytes(self):
        set_of = [MEADOW, "--backend", "torus", "--replicates", 2, "--shadow", "--duration", 200, "--replay-hz", 0, "--checkpoint-s", 20]
        self.call(*set_of, "--out", "whole")
        with subprocess.Popen([*map(str, set_of), "--out", "parts"], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as killed:
            while killed.poll() is None and not (self.folder / "parts/replicate-00/checkpoint.bin").exists():
                time.sleep(0.01)
            killed.kill()
        self.call(*set_of, "--out", "parts", "--resume")
        for table in (self.folder / "whole").rglob("*.csv"):
            self.assertEqual(table.read_bytes(), (self.folder / "parts" / table.relative_to(self.folder / "whole")).read_bytes(), table)
        self.assertTrue((self.folder / "whole/shadow/replicate-01/energy.csv").exists())

    def test_a_run(self):
        self.assertRegex(self.call(MEADOW, "--backend", "torus", "--duration", 30, "--out", "run"), r"alive\s+\d+ prey \d+ predator")


if __name__ == "__main__":
    unittest.main()
