#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""results_test.py ROOT: the tables of the pages match studies/results/data, and the screening design separates its effects."""

import itertools
import pathlib
import random
import subprocess
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path[:0] = [str(ROOT / "tests/program"), str(ROOT / "studies/python")]
import system_python

sys.argv[1:1] = [str(ROOT)]
system_python.need("scipy")
del sys.argv[1]
import designs


class Pages(unittest.TestCase):
    def test_tables_match_the_data(self):
        result = subprocess.run(
            [sys.executable, ROOT / "studies/reproduce", "--tables", "--check"], capture_output=True, text=True
        )
        self.assertEqual(result.returncode, 0, result.stderr)


class Design(unittest.TestCase):
    def test_main_effects_are_confounded_with_no_interaction_of_two(self):
        columns = list(zip(*[[2 * level - 1 for level in row] for row in designs.two_levels(32)]))
        self.assertEqual(len(columns[0]), 64)
        for a, b in itertools.combinations(columns, 2):
            self.assertEqual(sum(x * y for x, y in zip(a, b)), 0)
        for a, b, c in itertools.combinations(columns, 3):
            self.assertEqual(sum(x * y * z for x, y, z in zip(a, b, c)), 0)

    def test_too_many_choices_are_refused(self):
        with self.assertRaisesRegex(ValueError, "33 factors: must be <= 32"):
            designs.two_levels(33)

    def test_planted_effects_and_interactions_are_separated(self):
        random.seed(1)
        names = [f"choice{number}" for number in range(19)]
        cells = []
        for levels in designs.two_levels(len(names)):
            truth = 0.3 * levels[4] - 0.2 * levels[11] + 0.5 * (levels[0] ^ levels[7])
            cells.append(
                (levels, {key: [truth + random.gauss(0.0, 0.1) for _ in range(10)] for key in designs.SCREENED})
            )
        for row in designs.effect_rows(names, cells):
            planted = {"choice4": 0.3, "choice11": -0.2}.get(row["choice"], 0.0)
            self.assertAlmostEqual(float(row["effect"]), planted, delta=0.05)
            self.assertEqual(float(row["p_holm"]) <= 0.05, planted != 0.0, row)


if __name__ == "__main__":
    unittest.main()
