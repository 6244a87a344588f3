#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""own_metric_test.py PROGRAM TROPHIC: a Python function of a run has what shipped metrics have in sets, comparisons, sweeps and pages; one that fails
names the run and leaves nothing."""

import sys
import unittest

from in_folder import InFolderWithSets, planned, run_ok

PROGRAM, TROPHIC = (sys.argv.pop(1) for _ in range(2))
METRICS = """import numpy, trophic

@trophic.metric(unit="m")
def from_centre(run):
    robots = run.agents
    return robots.assign(from_centre=numpy.hypot(robots.x_m, robots.y_m))
"""
FAILS = (
    METRICS
    + """
@trophic.metric
def odd(run):
    if run.path.name == "replicate-01":
        raise ValueError("no robot is there")
    return 1
"""
)


class OwnMetric(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        (cls.sets / "metrics.py").write_text(METRICS)
        (cls.sets / "fails.py").write_text(FAILS)
        (cls.sets / "sweep.toml").write_text(
            "replicates = 2\n[set]\nengine = 'kinematic'\necology.duration_s = 100.0\n[grid]\necology.robots = [20, 30]\n"
        )
        for arguments in (
            ["--backend", "kinematic", "--duration", 600, "--replicates", 6, "--shadow", "--out", "runs"],
            [
                "--backend",
                "kinematic",
                "--duration",
                600,
                "--replicates",
                6,
                "--set",
                "ecology.robots=20",
                "--out",
                "fewer",
            ],
            planned(PROGRAM, "sweep.toml", "sweep", cls.sets)[1:],
        ):
            run_ok(PROGRAM, *arguments, cwd=cls.sets)

    def analyze(self, *arguments):
        return self.run_ok(TROPHIC, "analyze", *arguments, "--metric-file", "metrics.py", cwd=self.sets)

    def rows(self, file):
        return super().rows(self.sets / file)

    def test_it_has_value_interval_shadow_correction_and_curve(self):
        self.analyze("runs", "--out", "own")
        rows = [
            row
            for row in self.rows("own/metrics.csv")
            if (row["metric"], row["species"], row["baseline"]) == ("from_centre", "prey", "")
        ]
        value = {row["run"]: float(row["value"]) for row in rows if not row["time_s"]}
        self.assertEqual(len(value), 6)
        prey = [row for row in self.rows("runs/replicate-03/agents.csv") if row["species"] == "prey"]
        by_hand = sum((float(row["x_m"]) ** 2 + float(row["y_m"]) ** 2) ** 0.5 for row in prey) / len(prey)
        self.assertAlmostEqual(value["replicate-03"], by_hand, places=9)
        self.assertEqual(
            [float(row["time_s"]) for row in rows if row["run"] == "replicate-00" and row["time_s"]],
            [200.0, 400.0, 600.0],
        )
        (mean,) = [
            row
            for row in self.rows("own/means.csv")
            if (row["metric"], row["species"], row["null"]) == ("from_centre", "prey", "shadow")
        ]
        self.assertEqual((mean["unit"], mean["n"]), ("m", "6"))
        self.assertLess(float(mean["lower"]), float(mean["mean"]))
        self.assertNotEqual(mean["p"], "")

    def test_it_is_chosen_by_name_compared_and_in_every_cell_of_a_sweep(self):
        done = self.analyze("--compare", "runs", "fewer", "--metric", "from_centre:prey", "--out", "compared")
        self.assertIn("from_centre prey", done.stdout)
        self.assertEqual({row["metric"] for row in self.rows("compared/differences.csv")}, {"from_centre"})
        self.analyze("sweep", "--metric", "from_centre", "--out", "swept")
        self.assertEqual(
            {(row["metric"], row["species"]) for row in self.rows("swept/sweep_differences.csv")},
            {("from_centre", "prey"), ("from_centre", "predator")},
        )

    def test_one_that_fails_names_the_run_and_leaves_nothing(self):
        for of, where in (("runs", "runs"), ("sweep", "sweep/cell-000")):
            refused = self.call(TROPHIC, "analyze", of, "--out", "nothing", "--metric-file", "fails.py", cwd=self.sets)
            self.assertEqual(refused.stdout, "")
            self.assert_refused(refused, f" analyze: metric odd: {where}/replicate-01: ValueError: no robot is there\n")
            self.assertFalse((self.sets / "nothing").exists())

    def test_the_page_has_it_and_names_the_program_and_the_file(self):
        self.analyze("runs", "--html", "page.html", "--replays", 0)
        page = (self.sets / "page.html").read_text()
        self.assertIn("--metric-file metrics.py", page)
        self.assertIn("from_centre", page)


if __name__ == "__main__":
    unittest.main()
