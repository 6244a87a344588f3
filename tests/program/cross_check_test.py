#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""cross_check_test.py TROPHIC PREDATOR_PREY: two engines, or two settings of one, from a sweep over them to the figure."""

import csv
import sys
import unittest

import figures_python
from in_folder import InFolderWithSets, call as run, planned, run_ok

TROPHIC, PREDATOR_PREY = (sys.argv.pop(1) for _ in range(2))
SWEEP = """engine = "kinematic"
replicates = 10
[[runs]]
ecology.duration_s = 1200.0
[[runs]]
ecology.duration_s = 1200.0
backend.speed_scale = 1.5
[[runs]]
ecology.duration_s = 600.0
[[runs]]
ecology.duration_s = 1200.0
rule_table = "released"
"""


class CrossCheck(InFolderWithSets):
    program = (TROPHIC, "cross-check")

    @classmethod
    def make_sets(cls):
        (cls.sets / "sweep.toml").write_text(SWEEP)
        run_ok(*planned(PREDATOR_PREY, "sweep.toml", "runs", cls.sets), cwd=cls.sets)
        cls.slow, cls.fast, cls.short, cls.released = (cls.sets / f"runs/cell-00{cell}" for cell in range(4))

    def test_from_runs_to_a_figure(self):
        self.run_ok(self.slow, self.fast, "--out", "out")
        self.assertNotEqual(
            {float(row["difference"]) for row in self.rows("out/cross_check.csv") if row["conclusion"]}, {0.0}
        )
        if not figures_python.PYTHON:
            self.skipTest("the figure needs matplotlib and pandas")
        run_ok(TROPHIC, "plot", self.folder / "out")
        self.assertGreater((self.folder / "out/figures/cross_check.png").stat().st_size, 10_000)

    def test_a_gait_walks_alike_on_mujoco_and_ode(self):
        speeds = []
        for engine in ("mujoco", "ode"):
            walked = run(TROPHIC, "measure-gait", "--backend", engine, "--gait", "spider_steered", "--duration", 20)
            if walked.returncode != 0:
                self.skipTest(walked.stderr)
            speeds.append(
                [
                    float(row["forward_m_s"])
                    for row in csv.DictReader(walked.stdout.splitlines())
                    if row["timestep_s"] == "0.0012"
                ]
            )
        for mujoco, ode in zip(*speeds):
            self.assertAlmostEqual(ode / mujoco, 1.0, delta=0.1)
        self.assertNotEqual(*speeds)

    def test_refusals(self):
        (self.folder / "there").mkdir()
        for arguments, parts in [
            ([self.slow, self.fast, "--bogus"], ["--bogus"]),
            ([self.slow, "--out", "new"], ["runs"]),
            ([self.slow, self.slow, "--out", "new"], ["replicate-00: must not be in both of the compared sets"]),
            ([self.slow, self.fast, "--out", "there"], ["there", "exists already"]),
            ([self.slow, self.released, "--out", "new"], ["released", 'must be "paper"']),
            (
                [self.slow, self.short, "--out", "new"],
                ["600 of 600 s", 'must have status "complete" at 1200 of 1200 s'],
            ),
            ([self.slow, "nosuch", "--out", "new"], ["nosuch"]),
        ]:
            with self.subTest(arguments=arguments):
                self.assert_refused(self.call(*arguments), *parts)
                self.assertFalse((self.folder / "new").exists())


if __name__ == "__main__":
    unittest.main()
