#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""cross_check_test.py TROPHIC PREDATOR_PREY: walks and ecologies on two engines, from the command to the figure."""

import sys
import unittest

import figures_python
from in_folder import InFolderWithSets, run_ok

TROPHIC, PREDATOR_PREY = (sys.argv.pop(1) for _ in range(2))


class CrossCheck(InFolderWithSets):
    program = (TROPHIC, "cross-check")

    @classmethod
    def make_sets(cls):
        for rules, duration in (("paper", 1200), ("released", 1200), ("paper", 600)):
            run_ok(PREDATOR_PREY, "--backend", "kinematic", "--rules", rules, "--duration", duration, "--replicates", 10,
                   "--out", f"{rules}-{duration}", cwd=cls.sets)

    def test_from_walks_and_runs_to_a_figure(self):
        paper = self.sets / "paper-1200"
        self.run_ok("--seconds", 10, "--runs", paper, paper, "--out", "out")
        rows = self.rows("out/cross_check.csv")
        walks = [r for r in rows if r["part"] == "gait"]
        self.assertEqual(len(walks), 3 * 10 * 6)
        speeds = {r["engine"]: float(r["mean"]) for r in walks
                  if (r["quantity"], r["settings"], r["timestep_s"], r["target_angle_rad"]) == ("speed_m_s", "default", "0.0012", "0.7")}
        self.assertAlmostEqual(speeds["ode"] / speeds["mujoco"], 1.0, delta=0.1)
        self.assertNotEqual(speeds["ode"], speeds["mujoco"])
        metrics = [r for r in rows if r["part"] == "ecology" and r["quantity"] == "velocity" and r["conclusion"]]
        self.assertEqual({float(r["difference"]) for r in metrics}, {0.0})
        self.assertIn("equivalent", {r["conclusion"] for r in metrics})
        if not figures_python.PYTHON:
            self.skipTest("the figure needs matplotlib and pandas")
        run_ok(TROPHIC, "plot", self.folder / "out")
        self.assertGreater((self.folder / "out/figures/cross_check.png").stat().st_size, 10_000)

    def test_refusals(self):
        (self.folder / "there").mkdir()
        paper = self.sets / "paper-1200"
        for arguments, parts in [
            ([], ["--out"]),
            (["--bogus"], ["--bogus"]),
            (["--out", "there"], ["there", "exists already"]),
            (["--out", "new", "--seconds", 11], ["--seconds 11", "even number from 10 to 1000"]),
            (["--out", "new", "--seconds", 0], ["--seconds 0", "nothing is left"]),
            (["--out", "new", "--jobs", 0], ["--jobs 0"]),
            (["--out", "new", "--runs", paper, self.sets / "released-1200"], ["released", "must be \"paper\""]),
            (["--out", "new", "--runs", paper, self.sets / "paper-600"], ["600 of 600 s", "must be as status \"complete\" at 1200 of 1200 s"]),
            (["--out", "new", "--robot", "gecko", "--gait", "spider_published"], ["gait"]),
            (["--out", "new", "--runs", paper, "nosuch"], ["nosuch"]),
            (["--out", "new", "--robot", "nosuch"], ["nosuch"]),
        ]:
            with self.subTest(arguments=arguments):
                self.assert_refused(self.call(*arguments), *parts)
                self.assertFalse((self.folder / "new").exists())


if __name__ == "__main__":
    unittest.main()
