#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""meadow_test.py MEADOW TROPHIC: living worlds of a project of one's own have replicates, shadows, runs that resume, and pages."""

import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

MEADOW, TROPHIC = sys.argv.pop(1), sys.argv.pop(1)
PROJECT = pathlib.Path(__file__).with_name("project")


class Meadow(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def call(self, *words):
        done = subprocess.run([*map(str, words)], capture_output=True, text=True, cwd=self.folder, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_the_worlds_have_25_and_40_lines(self):
        for source, most in (("meadow.cpp", 25), ("hide_and_seek.hpp", 40)):
            world = (PROJECT / source).read_text().split("int main")[0].splitlines()
            self.assertLessEqual(
                len([line for line in world if line and not line.startswith(("//", "#", "using namespace"))]), most
            )

    def test_killed_set_with_shadows_that_resumes_to_the_same_bytes(self):
        set_of = [
            MEADOW,
            "--rules",
            "meadow",
            "--backend",
            "torus",
            "--replicates",
            2,
            "--shadow",
            "--duration",
            200,
            "--replay-hz",
            0,
            "--checkpoint-s",
            20,
        ]
        self.call(*set_of, "--out", "whole")
        with subprocess.Popen(
            [*map(str, set_of), "--out", "parts"], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        ) as killed:
            while killed.poll() is None and not (self.folder / "parts/replicate-00/checkpoint.bin").exists():
                time.sleep(0.01)
            killed.kill()
        self.call(*set_of, "--out", "parts", "--resume")
        for table in (self.folder / "whole").rglob("*.csv"):
            self.assertEqual(
                table.read_bytes(),
                (self.folder / "parts" / table.relative_to(self.folder / "whole")).read_bytes(),
                table,
            )
        self.assertTrue((self.folder / "whole/shadow/replicate-01/energy.csv").exists())

    def test_pages_of_runs(self):
        for world, backend in (("meadow", "torus"), ("hide_and_seek", "kinematic")):
            out = self.call(MEADOW, "--rules", world, "--backend", backend, "--duration", 30, "--out", world)
            self.assertRegex(out, r"alive\s+\d+ prey \d+ predator")
            self.call(TROPHIC, "show", world, "--out", f"{world}.html")
            self.assertIn("</html>", (self.folder / f"{world}.html").read_text())


if __name__ == "__main__":
    unittest.main()
