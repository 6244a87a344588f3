#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""readings_test.py READINGS PREDATOR_PREY ABLATIONS CHOICES: each reading of the paper's open choices is the policy that it names."""

import json
import pathlib
import sys
import tomllib
import unittest

from in_folder import InFolder, call, planned

READINGS, PREDATOR_PREY, ABLATIONS, CHOICES = (sys.argv.pop(1) for _ in range(4))
TABLES = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"]
DURATION_S = 1500
# Choices whose other reading is the policy of the table `released`, and the other rules that the ablation study sets there.
AS_ABLATION = {"decision_order": ("ecology.decision_order", []), "blind_robot": ("ecology.without_target", []), "tag_ratio": ("sensor_tag_ratio_of_active", []),
               "orphan_label": ("genome_source", ["--set", "rules.genome_source.second.random_share=0.34"])}


class Readings(InFolder):
    def run_ok(self, program, out, *arguments, seed=1):
        super().run_ok(program, "--backend", "kinematic", "--duration", DURATION_S, "--seed", seed, *arguments, "--out", out)

    def read(self, out):
        return [(self.folder / out / table).read_bytes() for table in TABLES]

    def settings(self, choice):
        return [part for setting in choice["second"] for part in ("--set", setting)]

    def setUp(self):
        super().setUp()
        with open(CHOICES, "rb") as file:
            self.choices = {choice["name"]: choice for choice in tomllib.load(file)["choice"]}

    def test_first_readings_are_the_table_paper(self):
        self.run_ok(PREDATOR_PREY, "paper", "--rules", "paper")
        self.run_ok(READINGS, "first")
        self.assertEqual(self.read("first"), self.read("paper"))

    def test_each_other_reading_changes_the_run(self):
        self.run_ok(READINGS, "first")
        for name, choice in self.choices.items():
            with self.subTest(choice=name):
                self.run_ok(READINGS, name, *self.settings(choice))
                compare = self.assertNotEqual if choice["screen"] else self.assertEqual
                compare(self.read(name), self.read("first"), "without bodies" if not choice["screen"] else "")

    def test_other_readings_are_the_policies_of_the_ablation_study(self):
        for name, (swap, settings) in AS_ABLATION.items():
            with self.subTest(choice=name):
                swaps = self.folder / f"ablation-{name}"
                self.run_ok(ABLATIONS, swaps.name, "--from", "paper", "--only", swap, "--replicates", 1)
                (run,) = swaps.glob(f"from_paper/{swap}/replicate-*")
                seed = json.loads((run / "manifest.json").read_text())["seed"]
                self.run_ok(READINGS, f"ours-{name}", *self.settings(self.choices[name]), *settings, seed=seed)
                self.assertEqual(self.read(f"ours-{name}"), [(run / table).read_bytes() for table in TABLES])

    def test_the_cells_of_the_study_of_slow_predators_are_accepted(self):
        sweep = pathlib.Path(CHOICES).parents[1] / "studies/slow_predators/slow_predators.toml"
        if ", mujoco" not in call(READINGS, "--help").stdout:
            self.skipTest("needs mujoco")
        planned(READINGS, sweep, "plan", self.folder)
        self.assertEqual(len((self.folder / "plan/plan.jsonl").read_text().splitlines()), 96)


if __name__ == "__main__":
    unittest.main()
