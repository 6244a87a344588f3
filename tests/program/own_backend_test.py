#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""own_backend_test.py PROGRAM: a program with its own backend has that backend as its default."""

import pathlib
import re
import sys
import unittest

from in_folder import InFolder

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv.pop(1)
# What is said of the paper's rules with a single prey.
IDLE = [
    "rules.floor: floor = 7: no catch or sacrifice of prey, because the run starts with 1",
    "rules.floor.floor = 7 and rules.minimum_predators.below = 7: with 1 robots every prey above the floor is sacrificed, so no prey is left to be caught",
]


class OwnBackend(InFolder):
    program = (PROGRAM,)

    def test_its_own_backend_is_the_default_and_has_its_numbers(self):
        printed = self.run_ok("--print-config")
        self.assertIn("engine = 'toy'", printed.stdout)
        self.assertIn("[backend]\nbreaks_beyond_rad = 100", printed.stdout)
        self.assertIn("physics: toy, kinematic (default: toy)", self.call("--help").stdout)
        self.run_ok("--robots", 1, "--set", "rules.community.predators=0", "--duration", 20, "--out", "run")
        self.assertEqual(self.manifest("run")["backend"], "toy 1")

    def test_its_remark_on_its_speed_is_printed_and_in_the_manifests(self):
        run = ["--robots", 1, "--set", "rules.community.predators=0", "--duration", 20]
        printed = self.call(*run, "--out", "run")
        self.assertIn("\nremark  a toy is slow\n", printed.stdout)
        counted = self.call(*run, "--backend", "kinematic", "--profile", "--out", "counted")
        self.assertIn("\nremark  backend kinematic does not count steps\n", counted.stdout)
        self.run_ok(*run, "--replicates", 1, "--out", "set")
        for one in ("run", "set/replicate-00"):
            found = self.manifest(one)
            self.assertEqual(
                (found["remarks"], found["speed"]), (["physics has no effect: a toy", *IDLE], "a toy is slow")
            )

    def test_a_number_of_its_backend_is_read_and_checked(self):
        program = pathlib.Path(PROGRAM).name
        for assignment, message in (
            ("backend.breaks_beyond_rad=-1", "backend.breaks_beyond_rad = -1: must be > 0"),
            (
                "backend.breaks_beyond_rd=1",
                "--set backend.breaks_beyond_rd: unknown key; did you mean backend.breaks_beyond_rad?",
            ),
            ("backend.colour=1", "backend.colour: unknown key; known here: breaks_beyond_rad"),
            ("backend=1", "backend = 1: must be a table of parameters"),
        ):
            result = self.call("--set", assignment, "--out", "run")
            self.assertEqual((result.returncode, result.stderr), (2, f"{program}: {message}\n"))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_engine_that_it_lacks_is_an_error_of_one_sentence_with_its_packages(self):
        for engine in ("mujoco", "ode"):
            text = (ROOT / f"backends/{engine}/CMakeLists.txt").read_text()
            packages = re.search(r"apt-get install ([\w .-]+)\"", text) or re.search(
                r"not built, (libode-dev) is missing", text
            )
            result = self.call("--backend", engine, "--out", "run")
            self.assertEqual(
                (result.returncode, result.stderr),
                (
                    2,
                    f"{pathlib.Path(PROGRAM).name}: --backend {engine}: this program was built without it; run apt-get install {packages[1]} and build trophic again, or use --backend toy\n",
                ),
            )
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
