#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bodies_test.py BODIES ENCODING TROPHIC: runs in which bodies, gaits and brains evolve, and an encoding of one's own, are recorded and measured."""

import json
import sys
import unittest

import figures_python  # noqa: F401
from in_folder import InFolder

TROPHIC = sys.argv.pop(3)
ENCODING = sys.argv.pop(2)
BODIES = sys.argv.pop(1)
FEW = ["--duration", "8", "--set", "ecology.robots=8", "--set", "rules.community.predators=4", "--set", "rules.starvation.interval.base_ticks=1",
       "--set", "rules.floor.floor=1", "--set", "physics.timestep_s=0.002"]


class Bodies(InFolder):
    def measured(self, runs):
        self.run_ok(TROPHIC, "analyze", runs, "--bodies", "--out", f"{runs}-measured")
        return {(row["metric"], row["species"], row["group"]): row["value"] for row in self.rows(f"{runs}-measured/metrics.csv") if not row["time_s"]}

    def test_bodies_start_from_walkers_and_change_in_the_offspring(self):
        self.run_ok(BODIES, "--rules", "evolving_bodies", "--backend", "mujoco", *FEW, "--out", "run")
        bodies = self.rows("run/bodies.csv")
        births = [row for row in self.rows("run/events.csv") if row["event"] == "birth"]
        self.assertEqual([row["id"] for row in bodies], [row["id"] for row in births])
        self.assertGreater(len(bodies), 8)
        self.assertEqual(len({(row["species"], row["modules_text"]) for row in bodies[:8]}), 2)
        found = self.measured("run")
        for metric, species, least in (("body_modules", "predator", 1.0), ("walked", "predator", 0.0), ("gait_genes", "prey", 6.0)):
            self.assertGreater(float(found[metric, species, "late"]), least)
        self.run_ok(TROPHIC, "plot", "run-measured")
        captions = json.loads((self.folder / "run-measured/figures/captions.json").read_text())
        self.assertEqual(list(captions), ["measures", "morphospace", "plans"])
        self.assertRegex(captions["plans"], rf"\(\d+ of {len({row['plan'] for row in bodies})} plans\)")

    def test_a_pond_begets_bodies_and_gaits_in_growing_numbers(self):
        few = [*FEW[:2], "--set", "ecology.robots=20", *FEW[4:6], *FEW[-2:], "--set", "rules.recruitment.spare_bodies=12", "--set", "rules.recruitment.birth_J=25"]
        self.run_ok(BODIES, "--rules", "evolving_pond", "--backend", "mujoco", *few, "--out", "run")
        born = [row for row in self.rows("run/bodies.csv") if row["parent_plan"]]
        self.assertEqual({row["species"] for row in born}, {"prey", "predator"})
        self.assertTrue(any(float(row["edit_distance"]) > 0 for row in born))
        self.assertEqual(int(self.rows("run/energy.csv")[-1]["tick"]), 4)
        short = ["--against", "own", "--epochs", "0,8", "--team-size", 2, "--teams", 2, "--duration", 100, "--reach", 2.5]
        self.run_ok(TROPHIC, "contest", "run", "--program", BODIES, *short, "--out", "met")
        self.assertGreater(len({row["contact_s"] for row in self.rows("met/contests.csv")}), 2)

    def test_bodies_that_diverge_again_and_again_do_not_stop_the_neutral_null(self):
        diverging = ("physics.timestep_s=0.012", "physics.integrator=rk4", "rules.viability.trial_s=0.01", "rules.body_plan.prey.first_robot=spider",
                     "rules.gait.prey.gait=spider_published")
        self.run_ok(BODIES, "--backend", "mujoco", "--duration", "40", *FEW[2:-2], *(part for setting in diverging for part in ("--set", setting)),
                    "--replicates", "1", "--neutral", "--out", "runs")
        events = [self.rows(f"runs/{null}replicate-00/events.csv") for null in ("", "neutral/")]
        self.assertEqual(*([(row["id"], row["parent_id"]) for row in of if row["event"] == "birth"] for of in events))

    def test_an_encoding_of_ones_own_has_command_line_tables_and_measures(self):
        self.run_ok(ENCODING, "--backend", "mujoco", *FEW[:-2], "--out", "run")
        self.assertNotIn("diverged", {row["cause"] for row in self.rows("run/events.csv")})
        self.assertNotRegex(" ".join(row["modules_text"] for row in self.rows("run/bodies.csv")), r"hinge\d\[front:hinge")
        self.assertGreater(len({row["plan"] for row in self.rows("run/bodies.csv")}), 4)
        self.assertGreater(float(self.measured("run")["body_plans", "predator", "early"]), 1.0)

    def test_brains_evolve_without_bodies_and_only_their_genes_are_measured(self):
        self.run_ok(BODIES, "--rules", "evolving_brains", "--backend", "kinematic", "--duration", "600", "--out", "run")
        found = self.measured("run")
        self.assertGreater(float(found["brain_genes", "predator", "late"]), 10.0)
        self.assertEqual(found["body_modules", "predator", "late"], "")
        self.assert_refused(self.call(TROPHIC, "analyze", "run", "--bodies", "--lineages"), "--bodies: not with --lineages")

    def test_what_cannot_be_shown_or_measured_is_refused_in_a_sentence(self):
        number = "rules.viability.bodies.limits.most_modules"
        for arguments, part in ((["--backend", "kinematic"], "must be a backend with joints"), (["--backend", "mujoco", "--set", f"{number}=1000"], number)):
            self.assert_refused(self.call(BODIES, "--rules", "evolving_bodies", *arguments, "--out", "run"), part)


if __name__ == "__main__":
    unittest.main()
