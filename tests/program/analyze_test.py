#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""analyze_test.py PREDATOR_PREY ANALYZE PLOT: from replicates to figures, as users meet it: files, errors, exit codes."""

import csv
import json
import shutil
import signal
import subprocess
import sys
import time
import unittest

import figures_python
from in_folder import InFolderWithSets

PREDATOR_PREY, ANALYZE, PLOT = (sys.argv.pop(1) for _ in range(3))
FIGURES = ["attribution", "velocity", "wall_sticking", "tag_symmetry", "population", "phylogeny", "catches"]


def call(*arguments, cwd):
    return subprocess.run([*map(str, arguments)], capture_output=True, text=True, cwd=cwd, timeout=300)


class Analyze(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        for rules in ("paper", "released"):
            made = call(PREDATOR_PREY, "--backend", "kinematic", "--rules", rules, "--duration", 1000, "--replicates", 3, "--jobs", 2,
                        "--out", rules, cwd=cls.sets)
            assert made.returncode == 0, made.stderr

    def setUp(self):
        super().setUp()
        shutil.copytree(self.sets / "paper", self.folder / "paper")

    def call(self, *arguments):
        return call(*arguments, cwd=self.folder)

    def test_one_command_from_replicates_to_results(self):
        result = self.call(ANALYZE, "paper", "--out", "analysis")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        for text in ("3 runs", "attribution_caught prey", "share_alive", "fair_coins", "0.725"):
            self.assertIn(text, result.stdout)
        summary = json.loads((self.folder / "analysis/summary.json").read_text())
        self.assertEqual([r["status"] for r in summary["sets"][0]["runs"]], ["complete"] * 3)
        with open(self.folder / "analysis/metrics.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual({r["run"] for r in rows}, {"replicate-00", "replicate-01", "replicate-02"})
        self.assertNotIn("nan", {r["value"].lower() for r in rows})
        points = [r for r in rows if r["run"] == "replicate-00" and r["metric"] == "velocity" and r["species"] == "prey"
                  and r["group"] == "all" and r["baseline"] == "" and r["time_s"]]
        self.assertEqual(len(points), 5)
        again = self.call(ANALYZE, "paper", "--out", "analysis")
        self.assertEqual(again.returncode, 2)
        self.assertIn("exists already", again.stderr)

    def test_same_runs_same_bytes(self):
        for out in ("one", "two"):
            self.assertEqual(self.call(ANALYZE, "paper", "--out", out).returncode, 0)
        self.assertEqual((self.folder / "one/metrics.csv").read_bytes(), (self.folder / "two/metrics.csv").read_bytes())
        self.assertEqual((self.folder / "one/summary.json").read_bytes(), (self.folder / "two/summary.json").read_bytes())

    def test_other_rules_are_compared_but_not_pooled(self):
        other = self.sets / "released"
        pooled = self.call(ANALYZE, "paper", other, "--out", "pooled")
        self.assertEqual(pooled.returncode, 2)
        self.assertIn("use --compare", pooled.stderr)
        self.assertFalse((self.folder / "pooled").exists())
        compared = self.call(ANALYZE, "--compare", "paper", other, "--out", "compared")
        self.assertEqual(compared.returncode, 0, compared.stderr)
        self.assertIn("b - a [95 %]", compared.stdout)
        summary = json.loads((self.folder / "compared/summary.json").read_text())
        self.assertEqual([s["set"] for s in summary["sets"]], ["paper", "released"])
        self.assertTrue(any(d["difference"] for d in summary["differences"]))

    def test_bad_input_is_named_and_the_rest_is_used(self):
        with open(self.folder / "paper/replicate-00/agents.csv", "ab") as table:
            table.write(b"1000,500,0,1,pr")
        (self.folder / "paper/replicate-01/events.csv").write_text("generation,fitness\n1,2\n")
        shutil.rmtree(self.folder / "paper/replicate-02")
        result = self.call(ANALYZE, "paper")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 3, result.stderr)
        for text in ("replicate-00/agents.csv:15032: cut off", 'replicate-01/events.csv:1: no column "time_s"', "replicate-02: missing"):
            self.assertIn(text, result.stderr)
        self.assertIn("(1 of 2 runs)", result.stdout)

    def test_usage_errors(self):
        for arguments, text in ((["nowhere"], "nowhere: is not a folder"), ([], "either folders of runs, or --compare"),
                                (["paper", "--compare", "paper", "paper"], "either folders of runs, or --compare"),
                                (["paper", "--resamples", 0], "bootstrap.resamples = 0: must be >= 1")):
            with self.subTest(arguments=arguments):
                result = self.call(ANALYZE, *arguments)
                self.assertIn(result.returncode, (1, 2))
                self.assertIn(text, result.stderr)
                self.assertFalse((self.folder / "analysis").exists())

    def test_interrupted_replicates_are_resumed(self):
        command = [PREDATOR_PREY, "--backend", "kinematic", "--duration", "20000", "--replicates", "3", "--jobs", "2", "--out", "set"]
        running = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        log = self.folder / "set/replicate-00/agents.csv"
        for _ in range(3000):
            if log.exists() and log.stat().st_size > 10_000:
                break
            time.sleep(0.01)
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=120)
        self.assertEqual(running.returncode, 1, errors)
        self.assertIn("replicate-00: stopped", errors)
        self.assertIn("--resume", errors)
        refused = self.call(*command)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("exists already", refused.stderr)
        resumed = self.call(*command, "--resume")
        self.assertEqual(resumed.returncode, 0, resumed.stderr)
        self.assertIn("kept as replicate-00.incomplete-1, run anew", resumed.stdout)
        self.assertIn("3 of 3 replicates complete", resumed.stdout)

    @unittest.skipUnless(figures_python.PYTHON, "needs matplotlib and pandas")
    def test_figures(self):
        self.call(ANALYZE, "paper", "--out", "analysis")
        result = self.call(figures_python.PYTHON, PLOT, "analysis")
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in FIGURES:
            for ending in ("png", "pdf"):
                self.assertGreater((self.folder / f"analysis/figures/{name}.{ending}").stat().st_size, 5000)
        shutil.rmtree(self.folder / "paper")
        partly = self.call(figures_python.PYTHON, PLOT, "analysis", "--out", "partly")
        self.assertEqual(partly.returncode, 0, partly.stderr)
        self.assertIn("phylogeny: left out: ", partly.stderr)
        self.assertIn("5 figures", partly.stdout)
        self.assertIn("not what analyze writes", self.call(figures_python.PYTHON, PLOT, "partly").stderr)


if __name__ == "__main__":
    unittest.main()
