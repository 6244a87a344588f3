#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bodies_test.py ENCODING TROPHIC: runs in which bodies and gaits of an encoding of one's own evolve are recorded and measured. studies/tests has more bodies."""

import sys
import unittest

import figures_python  # noqa: F401
from in_folder import InFolder

TROPHIC = sys.argv.pop(2)
ENCODING = sys.argv.pop(1)
FEW = [
    "--duration",
    "8",
    "--set",
    "ecology.robots=8",
    "--set",
    "rules.community.predators=4",
    "--set",
    "rules.starvation.interval.base_ticks=1",
    "--set",
    "rules.floor.floor=1",
    "--set",
    "physics.timestep_s=0.002",
]


class Bodies(InFolder):
    def measured(self, runs):
        self.run_ok(TROPHIC, "analyze", runs, "--bodies", "--out", f"{runs}-measured")
        return {
            (row["metric"], row["species"], row["group"]): row["value"]
            for row in self.rows(f"{runs}-measured/metrics.csv")
            if not row["time_s"]
        }

    def test_bodies_that_diverge_again_and_again_do_not_stop_the_neutral_null(self):
        diverging = ("physics.timestep_s=0.012", "physics.integrator=rk4", "rules.viability.trial_s=0.01")
        self.run_ok(
            ENCODING,
            "--backend",
            "mujoco",
            "--duration",
            "40",
            *FEW[2:-2],
            *(part for setting in diverging for part in ("--set", setting)),
            "--replicates",
            "1",
            "--neutral",
            "--out",
            "runs",
        )
        events = [self.rows(f"runs/{null}replicate-00/events.csv") for null in ("", "neutral/")]
        self.assertTrue(all("diverged" in {row["cause"] for row in of} for of in events))
        self.assertEqual(*([(row["id"], row["parent_id"]) for row in of if row["event"] == "birth"] for of in events))

    def test_an_encoding_of_ones_own_has_command_line_tables_and_measures(self):
        self.run_ok(ENCODING, "--backend", "mujoco", *FEW[:-2], "--out", "run")
        self.assertNotIn("diverged", {row["cause"] for row in self.rows("run/events.csv")})
        self.assertNotRegex(
            " ".join(row["modules_text"] for row in self.rows("run/bodies.csv")), r"hinge\d\[front:hinge"
        )
        self.assertGreater(len({row["plan"] for row in self.rows("run/bodies.csv")}), 4)
        self.assertGreater(float(self.measured("run")["body_plans", "predator", "early"]), 1.0)

    def test_what_cannot_be_shown_or_measured_is_refused_in_a_sentence(self):
        number = "rules.viability.bodies.limits.most_modules"
        for arguments, part in (
            (["--backend", "kinematic"], "must be a backend with joints"),
            (["--backend", "mujoco", "--set", f"{number}=1000"], number),
        ):
            self.assert_refused(self.call(ENCODING, *arguments, "--out", "run"), part)


if __name__ == "__main__":
    unittest.main()
