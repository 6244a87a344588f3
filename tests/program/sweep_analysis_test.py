#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""sweep_analysis_test.py PREDATOR_PREY TROPHIC: a sweep from its folder to figures, as users meet it: files, errors, exit codes."""

import csv
import json
import shutil
import subprocess
import sys
import unittest

import figures_python
from in_folder import InFolderWithSets

PREDATOR_PREY, TROPHIC = (sys.argv.pop(1) for _ in range(2))
SPEEDS, TICKS, REPLICATES, UNTIL_S = (1.0, 4.0), (15, 25), 6, 400.0
FILES = ("cells.csv", "runs.csv", "sweep_metrics.csv", "sweep_differences.csv", "sweep_effects.csv", "summary.json")


def call(*arguments, cwd):
    return subprocess.run([*map(str, arguments)], capture_output=True, text=True, cwd=cwd, timeout=300)


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


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
        made = call(PREDATOR_PREY, "--backend", "kinematic", "--rules", rules, "--duration", UNTIL_S, "--replicates", REPLICATES,
                    "--jobs", 2, "--replay-hz", 0, "--shadow", "--out", "cell",
                    *(word for path, value in settings.items() for word in ("--set", f"{path}={value}")), cwd=cls.sets)
        assert made.returncode == 0, made.stderr
        for shadow in (False, True):
            for replicate in range(REPLICATES):
                folder = f"cell-{cell:03}/{'shadow/' if shadow else ''}replicate-{replicate:02}"
                (sweep / folder).parent.mkdir(parents=True, exist_ok=True)
                (cls.sets / "cell" / ("shadow" if shadow else "") / f"replicate-{replicate:02}").rename(sweep / folder)
                manifest = json.loads((sweep / folder / "manifest.json").read_text())
                plan.append({"index": len(plan), "cell": cell, "replicate": replicate, "shadow": shadow, "rule_table": rules,
                             "engine": "kinematic", "settings": {**settings, "ecology.duration_s": UNTIL_S}, "seed": manifest["seed"],
                             "until_s": UNTIL_S, "replay_hz": 0.0, "agents_every": 1, "senses": False, "states": False,
                             "work": 30 * UNTIL_S * 60, "folder": folder, "fingerprint": manifest["fingerprint"]})
        shutil.rmtree(cls.sets / "cell")

    @staticmethod
    def write_plan(sweep, plan):
        (sweep / "plan.jsonl").write_text("".join(json.dumps(line) + "\n" for line in plan))

    def setUp(self):
        super().setUp()
        shutil.copytree(self.sets / "sweep", self.folder / "sweep")
        self.lines = [dict(line) for line in self.plan]

    def analyze(self, *arguments):
        return call(TROPHIC, "analyze", *arguments, cwd=self.folder)

    def analyzed(self, *arguments, out="analysis"):
        result = self.analyze("sweep", *arguments, "--out", out)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def refused(self, part, *arguments):
        result = self.analyze(*(arguments or ["sweep"]))
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn(part, result.stderr)
        self.assertFalse((self.folder / "analysis").exists())

    def test_a_sweep_is_grouped_by_cell_and_compared_with_one(self):
        result = self.analyzed("--jobs", 2)
        self.assertEqual(result.stderr, "")
        for text in ("sweep of 4 cells, 48 runs of 400 s", "axis backend.speed_scale: 1.0, 4.0", "reference: cell 0 (speed_scale 1.0, base_ticks 15)",
                     "seed by seed, each run over its shadow; p corrected for all of them (Holm)", "deaths prey", "/3 ", "inconclusive: "):
            self.assertIn(text, result.stdout)
        self.assertNotIn("no effect", result.stdout)
        self.assertEqual({path.name for path in (self.folder / "analysis").iterdir()}, set(FILES))
        cells = table(self.folder / "analysis/cells.csv")
        self.assertEqual([cell["backend.speed_scale"] for cell in cells], ["1.0", "1.0", "4.0", "4.0"])
        self.assertEqual({(cell["runs"], cell["shadow_runs"], cell["engine"]) for cell in cells}, {("6", "6", "kinematic")})
        rows = table(self.folder / "analysis/sweep_differences.csv")
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
        self.assertIn(f"\n{significant} of {len(tested)} comparisons are significant (p <= 0.05, corrected for all of them: Holm).", result.stdout)
        smallest = min(tested, key=lambda row: float(row["p"]))
        self.assertAlmostEqual(float(smallest["p_holm"]), min(1.0, float(smallest["p"]) * len(tested)))
        self.assertEqual(smallest["significant"], "yes")
        for row in tested:
            self.assertEqual((row["design"], row["runs"]), ("paired", row["runs_reference"]))
            self.assertLessEqual(float(row["lower_corrected"]), float(row["lower"]))
            self.assertGreaterEqual(int(row["runs_needed"] or 1_000_001), 6)
            if float(row["lower_corrected"]) > 0 or float(row["upper_corrected"]) < 0:
                self.assertEqual(row["significant"], "yes")

    def test_means_and_differences_follow_from_the_runs(self):
        self.analyzed("--reference", 3)
        values = {}
        for row in table(self.folder / "analysis/runs.csv"):
            if (row["metric"], row["species"], row["group"]) == ("velocity", "prey", "all"):
                values[int(row["cell"]), row["shadow"], int(row["replicate"])] = float(row["value"])
        over = [[values[cell, "0", k] - values[cell, "1", k] for k in range(REPLICATES)] for cell in range(4)]
        key = {"cell": "1", "metric": "velocity", "species": "prey", "group": "all"}
        (mean,) = [row for row in table(self.folder / "analysis/sweep_metrics.csv") if row.items() >= key.items()]
        difference, raw = [row for row in table(self.folder / "analysis/sweep_differences.csv") if row.items() >= key.items()]
        self.assertEqual((difference["compared"], raw["compared"]), ("over_shadow", "raw"))
        self.assertAlmostEqual(float(mean["over_shadow"]), sum(over[1]) / REPLICATES)
        self.assertAlmostEqual(float(difference["difference"]), sum(a - b for a, b in zip(over[1], over[3])) / REPLICATES)
        self.assertEqual(difference["reference"], "3")

    def test_the_number_of_jobs_changes_nothing(self):
        self.analyzed("--jobs", 1, out="one")
        self.analyzed("--jobs", 3, out="two")
        for name in FILES:
            self.assertEqual((self.folder / "one" / name).read_bytes(), (self.folder / "two" / name).read_bytes())

    def test_how_many_replicates_a_difference_needs(self):
        result = self.analyzed("--metric", "deaths:prey:caught", "hunger", "--difference", 5)
        self.assertIn("a difference of 5.0 in deaths prey (caught), over shadow needs ", result.stdout)
        self.assertIn("at the level of one of 6 comparisons", result.stdout)
        summary = json.loads((self.folder / "analysis/summary.json").read_text())["sweep"]
        self.assertEqual([answer["metric"] for answer in summary["asked"]], ["deaths", "hunger"])
        for answer in summary["asked"]:
            self.assertLessEqual(answer["fewest"], answer["runs"])
            self.assertLessEqual(answer["runs"], answer["most"])
        self.assertEqual({row["metric"] for row in table(self.folder / "analysis/sweep_differences.csv")}, {"deaths", "hunger"})

    def test_cells_without_common_seeds_are_independent_sets(self):
        for line in self.lines:
            if line["cell"] > 0:
                manifest = self.folder / "sweep" / line["folder"] / "manifest.json"
                content = json.loads(manifest.read_text())
                line["seed"] = content["seed"] = line["seed"] + line["cell"]
                manifest.write_text(json.dumps(content))
        self.write_plan(self.folder / "sweep", self.lines)
        self.assertIn("as independent sets (other seeds in each cell)", self.analyzed().stdout)
        self.assertEqual({row["design"] for row in table(self.folder / "analysis/sweep_differences.csv")}, {"independent"})

    def test_missing_runs_are_listed_and_left_out_only_when_asked(self):
        shutil.rmtree(self.folder / "sweep/cell-001/replicate-02")
        stopped = self.folder / "sweep/cell-002/shadow/replicate-01/manifest.json"
        stopped.write_text(stopped.read_text().replace('"complete"', '"stopped"'))
        words = ('sweep: 2 of 48 runs missing: run 14 (cell-001/replicate-02): no such folder; run 31 (cell-002/shadow/replicate-01): status '
                 '"stopped", must be "complete"')
        self.refused(words + " (--allow-missing leaves them out)")
        result = self.analyzed("--allow-missing")
        self.assertIn(words.removeprefix("sweep: ") + "; left out", result.stderr)
        cells = table(self.folder / "analysis/cells.csv")
        self.assertEqual([(cell["runs"], cell["runs_planned"], cell["shadow_runs"]) for cell in cells],
                         [("6", "6", "6"), ("5", "6", "6"), ("6", "6", "5"), ("6", "6", "6")])
        few = [row for row in table(self.folder / "analysis/sweep_differences.csv") if row["cell"] == "1"]
        self.assertTrue(any(row["difference"] for row in few))
        self.assertEqual({(row["p"], row["significant"], row["lower"]) for row in few}, {("", "", "")})
        self.assertIn("too few runs for a test in ", result.stdout)
        self.assertEqual(len(json.loads((self.folder / "analysis/summary.json").read_text())["sweep"]["missing"]), 2)
        shutil.rmtree(self.folder / "sweep/cell-000")
        again = self.analyze("sweep", "--allow-missing", "--out", "none")
        self.assertEqual(again.returncode, 2)
        self.assertIn("--reference 0: must be a cell with a complete run", again.stderr)

    def test_a_run_in_the_place_of_another_is_refused(self):
        one, other = (self.folder / f"sweep/cell-00{cell}/replicate-00/manifest.json" for cell in (0, 1))
        fingerprint = json.loads(one.read_text())["fingerprint"]
        shutil.copy(one, other)
        self.refused(f"cell-001/replicate-00/manifest.json: fingerprint = {fingerprint}: must be {self.lines[12]['fingerprint']}, as the plan")
        content = json.loads(one.read_text())
        content["fingerprint"], content["seed"] = self.lines[12]["fingerprint"], 7
        other.write_text(json.dumps(content))
        self.refused(f"seed = 7: must be {self.lines[12]['seed']}, as the plan has it for run 12")

    def test_broken_tables_are_an_error_with_the_run(self):
        (self.folder / "sweep/cell-001/replicate-03/events.csv").unlink()
        result = self.analyze("sweep")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("run 15: ", result.stderr)
        self.assertFalse((self.folder / "analysis").exists())

    def test_a_column_is_a_metric_of_every_cell_and_a_run_without_it_is_named(self):
        for line in self.lines:
            (self.folder / "sweep" / line["folder"] / "own.csv").write_text(f"level\n{1 + line['cell'] + line['replicate'] / 10}\n")
        self.analyzed("--column", "own.csv:level", "--metric", "level")
        rows = table(self.folder / "analysis/sweep_differences.csv")
        self.assertEqual([(row["cell"], round(float(row["difference"]), 9)) for row in rows if row["compared"] == "raw"], [("1", 1.0), ("2", 2.0), ("3", 3.0)])
        (self.folder / "sweep/cell-001/replicate-02/own.csv").write_text("level\nnan\n")
        done = self.analyzed("--column", "own.csv:level", "--metric", "level", out="without")
        self.assertIn("sweep/cell-001/replicate-02/own.csv: level has no value; the run is left out of its mean\n", done.stderr)
        (self.folder / "sweep/cell-002/shadow/replicate-01/own.csv").unlink()
        shutil.rmtree(self.folder / "analysis")
        self.refused("--column own.csv:level: sweep/cell-002/shadow/replicate-01 has no such file", "sweep", "--column", "own.csv:level")

    def test_broken_plans_are_refused(self):
        for change, part in ((lambda lines: lines[3].update(index=2), "plan.jsonl:4: index = 2: must be 3"),
                             (lambda lines: lines[3].update(folder=lines[2]["folder"]), "plan.jsonl:4: folder = "),
                             (lambda lines: lines[3].update(folder="../x"), "must be a folder within that of the plan"),
                             (lambda lines: lines[3].update(rule_table="released"), 'plan.jsonl:4: rule_table = "released": must be "paper"'),
                             (lambda lines: lines[3].pop("seed"), "plan.jsonl:4: seed: must be there"),
                             (lambda lines: lines[3].update(until_s=300.0), "plan.jsonl:4: until_s = 300.0: must be 400.0"),
                             (lambda lines: lines.clear(), "plan.jsonl: must list a run")):
            lines = [dict(line) for line in self.lines]
            change(lines)
            with self.subTest(part=part):
                self.write_plan(self.folder / "sweep", lines)
                self.refused(part)
        (self.folder / "sweep/plan.jsonl").write_text('{"index": 0')
        self.refused("plan.jsonl:1: must be a JSON object")

    def test_a_sweep_is_analyzed_alone(self):
        shutil.copytree(self.sets / "sweep", self.folder / "other")
        cell = "sweep/cell-000/replicate-00"
        for arguments, part in ((["sweep", "other"], "sweep: is a sweep, which must be analyzed alone"),
                                ([cell, "sweep"], "sweep: is a sweep, which must be analyzed alone"),
                                (["--compare", "sweep", cell], "--compare sweep: is a sweep"),
                                (["sweep", "--published"], "not with --shadow or --published"),
                                (["sweep", "--shadow", "other"], "not with --shadow or --published"),
                                ([cell, "--reference", 1], "--reference: only with a sweep"),
                                ([cell, "--allow-missing"], "--allow-missing: only with a sweep"),
                                (["sweep", "--reference", 4], "--reference 4: must be a cell of the sweep, 0 to 3"),
                                (["sweep", "--metric", "hungr"], "metric hungr: must be METRIC"),
                                (["sweep", "--difference", 1], "--difference: needs --metric"),
                                (["sweep", "--difference", 0, "--metric", "hunger"], "--difference 0: must be > 0"),
                                (["sweep", "--jobs", 0], "--jobs 0: must be >= 1"),
                                (["sweep", "--until", 500], "must be >= 500 s, as --until asks")):
            with self.subTest(arguments=arguments):
                self.refused(part, *arguments)
        self.assertIn("runs of 200 s", self.analyzed("--until", 200).stdout)
        again = self.analyze("sweep", "--out", "analysis")
        self.assertEqual(again.returncode, 2)
        self.assertIn("exists already", again.stderr)

    def test_named_metrics_are_on_the_screen(self):
        shown = self.analyzed("--metric", "deaths:prey:all", "hunger").stdout
        self.assertRegex(shown, r"metric +cell +mean +reference +difference \[95 %\] +raw +p +g +runs +runs needed\n")
        for cell in (1, 2, 3):
            for metric in ("deaths prey", "hunger predator"):
                self.assertRegex(shown, rf"\n{metric}, over shadow +{cell} \(speed_scale [14].0, base_ticks \d+\) .*\[.*\] +[+-][0-9.]+ +[<0-9].* 6\+6")

    def test_named_metrics_that_never_differ_are_one_line(self):
        shown = self.analyzed("--metric", "deaths:prey").stdout
        self.assertIn("\nthe same in all runs, or without a value: deaths prey (senescence)\n", shown)
        self.assertEqual(shown.count("deaths prey (senescence)"), 1)

    def test_rule_tables_may_be_an_axis(self):
        plan = [line for line in self.lines if line["cell"] == 0]
        self.run_cell(self.folder / "sweep", plan, 4, "released", plan[0]["settings"] | {"rules.starvation.interval.base_ticks": 15})
        self.write_plan(self.folder / "sweep", plan)
        result = self.analyzed()
        self.assertIn("axis rule_table: paper, released\nreference: cell 0 (rule_table paper)", result.stdout)
        self.assertEqual([cell["rule_table"] for cell in table(self.folder / "analysis/cells.csv")], ["paper", "released"])

    @unittest.skipUnless(figures_python.PYTHON, "needs matplotlib and pandas")
    def test_figures(self):
        self.analyzed()
        result = call(TROPHIC, "plot", "analysis", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        names = {path.name for path in (self.folder / "analysis/figures").iterdir()}
        for name in ("response-deaths", "heat-deaths-speed_scale-base_ticks", "response-velocity"):
            for ending in ("png", "pdf"):
                self.assertIn(f"{name}.{ending}", names)
                self.assertGreater((self.folder / f"analysis/figures/{name}.{ending}").stat().st_size, 5000)
        one = call(TROPHIC, "plot", "analysis", "--metric", "deaths:prey:caught", "--axes",
                   "rules.starvation.interval.base_ticks", "--out", "one", cwd=self.folder)
        self.assertEqual((one.returncode, one.stdout), (0, "1 figures in one, with captions.json and captions.tex\n"), one.stderr)
        for arguments, part in ((["--metric", "no"], "--metric no: no such metric"), (["--axes", "no"], "--axes no: must be one of ")):
            wrong = call(TROPHIC, "plot", "analysis", "--out", "wrong", *arguments, cwd=self.folder)
            self.assertEqual(wrong.returncode, 2)
            self.assertIn(part, wrong.stderr)
        self.assertIn("not what trophic analyze writes", call(TROPHIC, "plot", "sweep", cwd=self.folder).stderr)

    @unittest.skipUnless(figures_python.PYTHON, "needs matplotlib and pandas")
    def test_tables_read_in_pandas(self):
        self.analyzed()
        program = ("import pandas as p; d = p.read_csv('analysis/sweep_differences.csv').merge(p.read_csv('analysis/cells.csv'), on='cell');"
                   "assert (d['backend.speed_scale'] >= 1).all() and d.p.max() <= 1 and set(d.significant.dropna()) <= {'yes', 'no'};"
                   "r = p.read_csv('analysis/runs.csv'); assert r.value.notna().all() and r.run.nunique() == 48")
        read = call(figures_python.PYTHON, "-c", program, cwd=self.folder)
        self.assertEqual(read.returncode, 0, read.stderr)


if __name__ == "__main__":
    unittest.main()
