#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""own_metric_test.py PROGRAM TROPHIC: metrics of a program's own have what shipped ones have; wrong ones give one sentence and cost nothing."""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

TROPHIC = sys.argv.pop(2)
PROGRAM = sys.argv.pop(1)
NAME = pathlib.Path(PROGRAM).name


class OwnMetric(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.room = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.room.name)
        cls.call_ok("--backend", "kinematic", "--duration", 600, "--replicates", 6, "--shadow", "--out", "runs")

    @classmethod
    def tearDownClass(cls):
        cls.room.cleanup()

    @classmethod
    def call(cls, *arguments, metric=None, program=PROGRAM):
        environment = {**os.environ, **({"METRIC": metric} if metric else {})}
        return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=cls.folder, env=environment, timeout=300)

    @classmethod
    def call_ok(cls, *arguments, **named):
        done = cls.call(*arguments, **named)
        assert done.returncode == 0, done.stderr
        return done

    def rows(self, file):
        with open(self.folder / file, newline="") as text:
            return list(csv.DictReader(text))

    def by_hand(self, run, species):
        rows = [row for row in self.rows(f"{run}/agents.csv") if row["species"] == species]
        return sum((float(row["x_m"]) ** 2 + float(row["y_m"]) ** 2) ** 0.5 for row in rows) / len(rows)

    def test_it_has_value_interval_shadow_correction_and_curve_and_all_else_is_the_same(self):
        self.call_ok("analyze", "runs", "--jobs", 3, "--out", "own")
        self.call_ok("analyze", "runs", "--out", "plain", program=TROPHIC)
        rows = [row for row in self.rows("own/metrics.csv") if row["metric"] == "from_centre" and row["baseline"] == ""]
        value = {(row["set"], row["run"]): row for row in rows if row["species"] == "prey" and row["time_s"] == ""}
        self.assertEqual(len(value), 6)
        for (_, run), row in value.items():
            self.assertAlmostEqual(float(row["value"]), self.by_hand(f"runs/{run}", "prey"), places=9)
        curve = [row["time_s"] for row in rows if row["species"] == "prey" and row["run"] == "replicate-00" and row["time_s"]]
        self.assertEqual([float(time) for time in curve], [200.0, 400.0, 600.0])
        (mean,) = [row for row in self.rows("own/means.csv") if (row["metric"], row["species"], row["null"]) == ("from_centre", "prey", "shadow")]
        self.assertEqual((mean["unit"], mean["n"]), ("m", "6"))
        self.assertLess(float(mean["lower"]), float(mean["mean"]))
        self.assertNotEqual(mean["p"], "")
        def others(file):
            return [[row[c] for c in ("metric", "species", "group", "mean", "difference", "p")] for row in self.rows(file) if row["metric"] != "from_centre"]
        self.assertEqual(others("own/means.csv"), others("plain/means.csv"))

    def test_it_is_chosen_by_name_and_compared(self):
        self.call_ok("--backend", "kinematic", "--duration", 600, "--replicates", 6, "--set", "ecology.robots=20", "--out", "fewer")
        done = self.call_ok("analyze", "--compare", "runs", "fewer", "--metric", "from_centre:prey", "--out", "compared")
        self.assertIn("from_centre prey, m", done.stdout)
        self.assertEqual({row["metric"] for row in self.rows("compared/differences.csv")}, {"from_centre"})
        refused = self.call("analyze", "runs", "--metric", "from_center", "--out", "refused")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("did you mean from_centre?", refused.stderr)
        self.assertTrue(refused.stderr.startswith(f"{NAME} analyze: "))

    def test_a_sweep_has_it_in_every_cell(self):
        (self.folder / "sweep.toml").write_text("replicates = 2\n[set]\nengine = 'kinematic'\necology.duration_s = 100.0\n[grid]\necology.robots = [20, 30]\n")
        self.call_ok("--sweep", "sweep.toml", "--out", "sweep")
        self.call_ok("analyze", "sweep", "--metric", "from_centre", "--out", "swept")
        rows = self.rows("swept/sweep_differences.csv")
        self.assertEqual({(row["metric"], row["species"]) for row in rows}, {("from_centre", "prey"), ("from_centre", "predator")})
        refused = self.call("analyze", "sweep", "--out", "nothing", metric="throws")
        self.assertEqual((refused.returncode, refused.stdout), (1, ""))
        self.assertEqual(refused.stderr, f"{NAME} analyze: metric odd: sweep/cell-000/replicate-01: no robot is there\n")
        self.assertFalse((self.folder / "nothing").exists())
        done = self.call_ok("analyze", "sweep", "--metric", "odd", "--out", "without", metric="nan")
        for cell in ("000", "001"):
            self.assertIn(f"{NAME} analyze: sweep/cell-{cell}/replicate-01: odd has no value; the run is left out of its mean\n", done.stderr)

    def test_what_goes_wrong_in_one_run_names_the_run_and_leaves_nothing(self):
        for metric, sentence in (("throws", "no robot is there"), ("throws_a_number", "throws something that is not a std::exception"),
                                 ("infinity", "value = inf: must be finite, or NaN if there is none"),
                                 ("time", "time_s = 1e+300: must be >= 0 and <= 600"), ("species", "species = 7: must be < 2"),
                                 ("group", 'group "a,b": must be letters, digits and _')):
            with self.subTest(metric):
                refused = self.call("analyze", "runs", "--out", "nothing", metric=metric)
                self.assertEqual((refused.returncode, refused.stdout), (1, ""))
                self.assertEqual(refused.stderr, f"{NAME} analyze: metric odd: runs/replicate-01: {sentence}\n")
                self.assertFalse((self.folder / "nothing").exists())

    def test_a_run_without_a_value_is_left_out_and_named(self):
        for metric in ("nan", "none"):
            done = self.call_ok("analyze", "runs", "--metric", "odd", "--out", metric, metric=metric)
            self.assertIn(f"{NAME} analyze: runs/replicate-01: odd has no value; the run is left out of its mean\n", done.stderr)
            self.assertIn(f"{NAME} analyze: runs/shadow/replicate-01: odd has no value", done.stderr)
            self.assertEqual({row["n"] for row in self.rows(f"{metric}/means.csv")}, {"5"})

    def test_names_that_are_taken_and_metrics_without_a_part_are_refused_before_any_work(self):
        for metric, sentence in (("taken", "metric hunger: trophic has a metric of this name; choose another"),
                                 ("twice", "metric from_centre: is there twice"), ("no_word", "metric a:b: its name must be letters, digits and _"),
                                 ("no_unit", 'metric odd: unit "": must be letters, digits and _ . / ^ % -'), ("no_function", "metric odd: has no function")):
            for arguments in (["analyze", "runs"], ["--backend", "kinematic", "--duration", 10]):
                refused = self.call(*arguments, "--out", "nothing", metric=metric)
                self.assertEqual((refused.returncode, refused.stdout, refused.stderr), (2, "", f"{NAME}: {sentence}\n"))
                self.assertFalse((self.folder / "nothing").exists())

    def test_an_option_of_a_run_is_refused_with_analyze(self):
        refused = self.call("--seed", 3, "analyze", "runs")
        self.assertEqual((refused.returncode, refused.stderr), (2, f"{NAME} analyze: --seed: not with analyze\n"))
        self.assertIn("analyze", self.call_ok("--help").stdout)
        self.assertIn(f"{NAME} analyze runs/paper", self.call_ok("analyze", "--help").stdout)

    def test_the_page_names_the_program_that_makes_it(self):
        self.call_ok("analyze", "runs", "--html", "page.html")
        page = (self.folder / "page.html").read_text()
        self.assertIn(f"{NAME} analyze runs --html page.html", page)
        self.assertIn("from_centre", page)


if __name__ == "__main__":
    unittest.main()
