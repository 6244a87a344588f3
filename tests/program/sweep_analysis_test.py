#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""sweep_analysis_test.py PREDATOR_PREY TROPHIC: a sweep from its folder to figures, as users meet it: files, errors, exit codes."""

import json
import shutil
import sys
import unittest

import figures_python
from in_folder import InFolderWithSets, run_ok, sealed_text

PREDATOR_PREY, TROPHIC = (sys.argv.pop(1) for _ in range(2))
SPEEDS, TICKS, REPLICATES, UNTIL_S = (1.0, 4.0), (15, 25), 6, 400.0
FILES = ("cells.csv", "runs.csv", "sweep_metrics.csv", "sweep_differences.csv", "sweep_effects.csv", "summary.json")


class SweepAnalysis(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        """A grid of four cells with shadows, as a sweep writes it."""
        cls.plan = []
        for cell, (speed, ticks) in enumerate((speed, ticks) for speed in SPEEDS for ticks in TICKS):
            settings = {"backend.speed_scale": speed, "rules.starvation.interval.base_ticks": ticks}
            cls.run_cell(cls.sets / "sweep", cls.plan, cell, "paper", settings)
        cls.write_plan(cls.sets / "sweep", cls.plan)

    @classmethod
    def run_cell(cls, sweep, plan, cell, rules, settings):
        run_ok(
            PREDATOR_PREY,
            "--backend",
            "kinematic",
            "--rules",
            rules,
            "--duration",
            UNTIL_S,
            "--replicates",
            REPLICATES,
            "--jobs",
            2,
            "--replay-hz",
            0,
            "--shadow",
            "--out",
            "cell",
            *(word for path, value in settings.items() for word in ("--set", f"{path}={value}")),
            cwd=cls.sets,
        )
        for shadow in (False, True):
            for replicate in range(REPLICATES):
                folder = f"cell-{cell:03}/{'shadow/' if shadow else ''}replicate-{replicate:02}"
                (sweep / folder).parent.mkdir(parents=True, exist_ok=True)
                (cls.sets / "cell" / ("shadow" if shadow else "") / f"replicate-{replicate:02}").rename(sweep / folder)
                manifest = json.loads((sweep / folder / "manifest.json").read_text())
                plan.append(
                    {
                        "cell": cell,
                        "replicate": replicate,
                        "null": "shadow" if shadow else "none",
                        "rule_table": rules,
                        "engine": "kinematic",
                        "settings": {**settings, "ecology.duration_s": UNTIL_S},
                        "seed": manifest["seed"],
                        "until_s": UNTIL_S,
                        "replay_hz": 0.0,
                        "agents_every": 1,
                        "senses": False,
                        "states": False,
                        "work": 30 * UNTIL_S * 60,
                        "folder": folder,
                        "fingerprint": manifest["fingerprint"],
                    }
                )
        shutil.rmtree(cls.sets / "cell")

    @staticmethod
    def write_plan(sweep, plan):
        (sweep / "plan.jsonl").write_text("".join(json.dumps(line) + "\n" for line in plan))

    def setUp(self):
        super().setUp()
        shutil.copytree(self.sets / "sweep", self.folder / "sweep")
        self.lines = [dict(line) for line in self.plan]

    def analyze(self, *arguments):
        return self.call(TROPHIC, "analyze", *arguments)

    def analyzed(self, *arguments):
        return self.run_ok(TROPHIC, "analyze", "sweep", *arguments, "--out", "analysis")

    def refused(self, part, *arguments):
        self.assert_refused(self.analyze(*(arguments or ["sweep"])), part)
        self.assertFalse((self.folder / "analysis").exists())

    def test_a_sweep_is_grouped_by_cell_and_compared_with_one(self):
        result = self.analyzed("--jobs", 2)
        self.assertEqual(result.stderr, "")
        for text in (
            "sweep of 4 cells, 48 runs of 400 s",
            "axis backend.speed_scale: 1.0, 4.0",
            "reference: cell 0 (speed_scale 1.0, base_ticks 15)",
            "seed by seed, each run relative to its shadow; p corrected for all of them (Holm)",
            "inconclusive: ",
        ):
            self.assertIn(text, result.stdout)
        self.assertNotIn("no effect", result.stdout)
        self.assertEqual({path.name for path in (self.folder / "analysis").iterdir()}, set(FILES))
        cells = self.rows("analysis/cells.csv")
        self.assertEqual([cell["backend.speed_scale"] for cell in cells], ["1.0", "1.0", "4.0", "4.0"])
        self.assertEqual(
            {(cell["runs"], cell["shadow_runs"], cell["engine"]) for cell in cells}, {("6", "6", "kinematic")}
        )
        rows = self.rows("analysis/sweep_differences.csv")
        self.assertEqual({row["cell"] for row in rows}, {"1", "2", "3"})
        self.assertEqual([row["compared"] for row in rows], ["over_shadow", "raw"] * (len(rows) // 2))
        answers = [row for row in rows if row["compared"] == "over_shadow"]
        tested = [row for row in answers if row["p"]]
        content = json.loads((self.folder / "analysis/summary.json").read_text())
        summary = content["sweep"]
        self.assertEqual(summary["comparisons"], len(tested))
        self.assertAlmostEqual(summary["level"] * len(tested), 0.05)
        significant = sum(row["significant"] == "yes" for row in answers)
        self.assertEqual((len(summary["significant"]), content["family"]["significant"]), (significant, significant))
        self.assertIn(
            f"\n{significant} of {len(tested)} comparisons are significant (p <= 0.05, corrected for all of them: Holm).",
            result.stdout,
        )
        smallest = min(tested, key=lambda row: float(row["p"]))
        self.assertAlmostEqual(float(smallest["p_holm"]), min(1.0, float(smallest["p"]) * len(tested)))
        for row in tested:
            self.assertEqual(row["significant"], "yes" if float(row["p_holm"]) <= 0.05 else "no")
            self.assertEqual((row["design"], row["runs"]), ("paired", row["runs_reference"]))
            self.assertLessEqual(float(row["lower_corrected"]), float(row["lower"]))
            self.assertGreater(float(row["smallest_detectable"]), 0.0)
            if float(row["lower_corrected"]) > 0 or float(row["upper_corrected"]) < 0:
                self.assertEqual(row["significant"], "yes")

    def test_missing_runs_are_listed_and_left_out_only_when_asked(self):
        shutil.rmtree(self.folder / "sweep/cell-001/replicate-02")
        stopped = self.folder / "sweep/cell-002/shadow/replicate-01/manifest.json"
        stopped.write_text(sealed_text({**json.loads(stopped.read_text()), "status": "stopped"}))
        words = (
            "sweep: 2 of 48 runs missing: run 14 (cell-001/replicate-02): no such folder; run 31 (cell-002/shadow/replicate-01): status "
            '"stopped", must be "complete"'
        )
        by = "PROGRAM --plan sweep/plan.jsonl makes them"
        self.refused(f"{words} ({by}; --allow-missing omits them)")
        result = self.analyzed("--allow-missing")
        self.assertIn(words.removeprefix("sweep: ") + f"; omitted; {by}", result.stderr)
        cells = self.rows("analysis/cells.csv")
        self.assertEqual(
            [(cell["runs"], cell["runs_planned"], cell["shadow_runs"]) for cell in cells],
            [("6", "6", "6"), ("5", "6", "6"), ("6", "6", "5"), ("6", "6", "6")],
        )
        few = [row for row in self.rows("analysis/sweep_differences.csv") if row["cell"] == "1"]
        self.assertTrue(any(row["difference"] for row in few))
        self.assertEqual({(row["p"], row["significant"], row["lower"]) for row in few}, {("", "", "")})
        self.assertIn("too few runs for a test in ", result.stdout)
        self.assertEqual(len(json.loads((self.folder / "analysis/summary.json").read_text())["sweep"]["missing"]), 2)
        shutil.rmtree(self.folder / "sweep/cell-000")
        self.assert_refused(
            self.analyze("sweep", "--allow-missing", "--out", "none"),
            "--reference 0: must be a cell that has a complete run",
        )

    def test_a_sweep_is_analyzed_alone(self):
        shutil.copytree(self.sets / "sweep", self.folder / "other")
        cell = "sweep/cell-000/replicate-00"
        for arguments, part in (
            (["sweep", "other"], "sweep: is a sweep and must be analysed alone"),
            ([cell, "sweep"], "sweep: is a sweep and must be analysed alone"),
            (["--compare", "sweep", cell], "--compare sweep: is a sweep"),
            (["sweep", "--published"], "sweep: is a sweep: not with --published"),
            (["sweep", "--shadow", "other"], "sweep: is a sweep: not with --shadow"),
            ([cell, "--reference", 1], "--reference: needs a sweep"),
            ([cell, "--allow-missing"], "--allow-missing: needs a sweep"),
            (["sweep", "--reference", 4], "--reference 4: must be a cell of the sweep, 0 to 3"),
            (["sweep", "--metric", "hungr"], "metric hungr: must be METRIC"),
            (["sweep", "--difference", 1], "--difference: needs --metric"),
            (["sweep", "--difference", 0, "--metric", "hunger"], "--difference 0: must be > 0"),
            (["sweep", "--jobs", 0], "--jobs 0: must be >= 1"),
            (["sweep", "--until", 500], "must be >= 500 s, as --until asks"),
        ):
            with self.subTest(arguments=arguments):
                self.refused(part, *arguments)
        self.assertIn("runs of 200 s", self.analyzed("--until", 200).stdout)
        self.assert_refused(self.analyze("sweep", "--out", "analysis"), "exists already")

    @unittest.skipUnless(figures_python.PYTHON, "needs matplotlib and pandas")
    def test_figures(self):
        self.analyzed()
        self.run_ok(TROPHIC, "plot", "analysis")
        names = {path.name for path in (self.folder / "analysis/figures").iterdir()}
        for name in ("response-deaths", "heat-deaths-speed_scale-base_ticks", "response-velocity"):
            for ending in ("png", "pdf"):
                self.assertIn(f"{name}.{ending}", names)
                self.assertGreater((self.folder / f"analysis/figures/{name}.{ending}").stat().st_size, 5000)
        one = self.run_ok(
            TROPHIC,
            "plot",
            "analysis",
            "--metric",
            "deaths:prey:caught",
            "--axes",
            "rules.starvation.interval.base_ticks",
            "--out",
            "one",
        )
        self.assertEqual(one.stdout, "1 figure in one, with captions.json and captions.tex\n")
        for arguments, part in (
            (["--metric", "no"], "--metric no: sweep_metrics.csv has no such metric"),
            (["--axes", "no"], "--axes no: must be one of "),
        ):
            self.assert_refused(self.call(TROPHIC, "plot", "analysis", "--out", "wrong", *arguments), part)
        self.assertIn("not what trophic analyze writes", self.call(TROPHIC, "plot", "sweep").stderr)


if __name__ == "__main__":
    unittest.main()
