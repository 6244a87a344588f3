#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""analyze_test.py PREDATOR_PREY TROPHIC PLOT: from replicates to figures, as users meet it: files, errors, exit codes."""

import csv
import html
import json
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

import figures_python
from in_folder import InFolderWithSets

PREDATOR_PREY, TROPHIC, PLOT = (sys.argv.pop(1) for _ in range(3))
FIGURES = ["attribution", "velocity", "wall_sticking", "tag_symmetry", "population", "phylogeny", "catches", "trajectories"]


def call(*arguments, cwd):
    return subprocess.run([*map(str, arguments)], capture_output=True, text=True, cwd=cwd, timeout=300)


class Analyze(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        for rules in ("paper", "released"):
            for out, seed in ((rules, 1), (f"{rules}-as-shadow", 2)):
                made = call(PREDATOR_PREY, "--backend", "kinematic", "--rules", rules, "--duration", 1000, "--replicates", 6, "--jobs", 2,
                            "--seed", seed, "--out", out, cwd=cls.sets)
                assert made.returncode == 0, made.stderr
            for manifest in (cls.sets / f"{rules}-as-shadow").glob("*/manifest.json"):
                content = json.loads(manifest.read_text())
                content["rules"]["heredity"] = "nothing_inherited"
                content["fingerprint"] = "5ad0"
                manifest.write_text(json.dumps(content))

    def setUp(self):
        super().setUp()
        shutil.copytree(self.sets / "paper", self.folder / "paper")

    def call(self, *arguments):
        return call(*arguments, cwd=self.folder)

    def analyze(self, *arguments):
        return self.call(TROPHIC, "analyze", *arguments)

    def summary(self, out="analysis"):
        return json.loads((self.folder / out / "summary.json").read_text())

    def remove_replicates(self, *numbers):
        for number in numbers:
            shutil.rmtree(self.folder / f"paper/replicate-0{number}")

    def test_one_command_from_replicates_to_results(self):
        result = self.analyze("paper", "--out", "analysis")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        for text in ("6 runs of 1000 s", "attribution_caught prey", "= permuted_tags", "bernoulli_tags", "0.725", "no shadow: "):
            self.assertIn(text, result.stdout)
        self.assertEqual([r["status"] for r in self.summary()["sets"][0]["runs"]], ["complete"] * 6)
        with open(self.folder / "analysis/metrics.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual({r["run"] for r in rows}, {f"replicate-0{i}" for i in range(6)})
        self.assertNotIn("nan", {r["value"].lower() for r in rows})
        points = [r for r in rows if r["run"] == "replicate-00" and r["metric"] == "velocity" and r["species"] == "prey"
                  and r["group"] == "all" and r["baseline"] == "" and r["time_s"]]
        self.assertEqual(len(points), 5)
        again = self.analyze("paper", "--out", "analysis")
        self.assertEqual(again.returncode, 2)
        self.assertIn("exists already", again.stderr)

    def test_the_shadow_is_found_and_is_the_null_of_every_metric(self):
        shutil.copytree(self.sets / "paper-as-shadow", self.folder / "paper/shadow")
        result = self.analyze("paper")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("shadow: paper on kinematic 1, 6 runs of 1000 s", result.stdout)
        for metric in self.summary()["sets"][0]["metrics"]:
            shadow = metric["baselines"][0]
            self.assertEqual((shadow["name"], shadow["role"]), ("shadow", "null"))
            self.assertIn(shadow["conclusion"], ("above", "below", "not significant"))
            self.assertLessEqual(shadow["lower"], shadow["difference"])
            self.assertTrue(all(b["conclusion"] is None for b in metric["baselines"] if b["role"] != "null"))
        with open(self.folder / "analysis/metrics.csv", newline="") as table:
            shadows = [r for r in csv.DictReader(table) if r["baseline"] == "shadow"]
        self.assertEqual({r["set"] for r in shadows}, {"paper"})
        named = self.analyze(self.sets / "paper", "--shadow", "paper/shadow", "--out", "named")
        self.assertEqual(named.stdout.replace("named", "analysis"), result.stdout)
        wrong = self.analyze("paper", "--shadow", self.sets / "released-as-shadow", "--out", "wrong")
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("is no neutral shadow of paper/replicate-00: params/", wrong.stderr)
        self.assertFalse((self.folder / "wrong").exists())

    def test_few_runs_have_numbers_and_no_verdict(self):
        self.remove_replicates(5, 4, 3, 2, 1)
        (self.folder / "paper/replicates.json").unlink()
        for count, arguments in ((1, ["paper/replicate-00"]), (5, [f"{self.sets}/paper/replicate-0{i}" for i in range(5)])):
            for option, words in (("--published", (": reproduced", "inconclusive (")), ("--until", (" above", " below"))):
                out = f"few-{count}{option}"
                more = [option] if option == "--published" else [option, 1000]
                result = self.analyze(*arguments, *more, "--out", out)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn(f"too few runs for a conclusion: 6 are needed, paper has {count}", result.stdout)
                for word in words:
                    self.assertNotIn(word, result.stdout)
                readings = [r for c in self.summary(out)["sets"][0]["claims"] for r in c["readings"]]
                self.assertEqual({r["conclusion"] for r in readings}, {"no conclusion"})

    def test_every_published_claim_has_a_conclusion_under_each_reading(self):
        result = self.analyze("--published", "paper")
        self.assertEqual(result.returncode, 0, result.stderr)
        claims = self.summary()["sets"][0]["claims"]
        self.assertEqual(len(claims), 12)
        readings = [r for c in claims for r in c["readings"]]
        self.assertEqual(len(readings), 29)
        self.assertLessEqual({r["conclusion"] for r in readings}, {"reproduced", "not reproduced", "inconclusive"})
        self.assertIn("Leaving them out (active) is an inference", result.stdout)
        self.assertIn("the claims are about runs of 6000 s", result.stdout)
        # A sixth of the published time has far fewer deaths.
        self.assertEqual(next(c for c in claims if c["claim"] == "prey caught in a run")["summary"], "not reproduced")
        for claim in claims:
            self.assertIn(f"\n{claim['claim']}: {claim['summary']}\n", result.stdout)
        for reading in readings:
            self.assertIn(reading["margin_from"], result.stdout)
            if reading["conclusion"] == "inconclusive":
                runs = reading["runs_needed"]
                self.assertIn(f"inconclusive (about {runs} runs would decide)" if runs else "(1000 runs would not decide)", result.stdout)
            else:
                self.assertIsNone(reading["runs_needed"])

    def test_runs_of_different_length_are_not_pooled_unless_cut(self):
        longer = call(PREDATOR_PREY, "--backend", "kinematic", "--duration", 1200, "--out", "longer", cwd=self.folder)
        self.assertEqual(longer.returncode, 0, longer.stderr)
        manifest = self.folder / "paper/replicate-03/manifest.json"
        content = json.loads(manifest.read_text())
        content["status"], content["result"]["reached_s"] = "stopped", 700
        manifest.write_text(json.dumps(content))
        pooled = self.analyze("paper")
        self.assertEqual(pooled.returncode, 2)
        self.assertIn('replicate-03: status "stopped" at 700 of 1000 s, but paper/replicate-00 has status "complete" at 1000', pooled.stderr)
        short = self.analyze("paper", "--until", 800)
        self.assertEqual(short.returncode, 2)
        self.assertIn("replicate-03: reached 700 s (status stopped): must be >= 800 s", short.stderr)
        self.assertEqual(self.analyze("paper", "--until", 600).returncode, 0)
        self.assertEqual({r["until_s"] for r in self.summary()["sets"][0]["runs"]}, {600})
        different = self.analyze("--compare", self.sets / "paper", "longer", "--out", "different")
        self.assertEqual(different.returncode, 2)
        self.assertIn('longer: status "complete" at 1200 of 1200 s, but', different.stderr)
        self.assertEqual(self.analyze("--compare", self.sets / "paper", "longer", "--until", 1000, "--out", "cut").returncode, 0)

    def test_same_runs_same_bytes(self):
        for out in ("one", "two"):
            self.assertEqual(self.analyze("paper", "--out", out).returncode, 0)
        self.assertEqual((self.folder / "one/metrics.csv").read_bytes(), (self.folder / "two/metrics.csv").read_bytes())
        self.assertEqual((self.folder / "one/summary.json").read_bytes(), (self.folder / "two/summary.json").read_bytes())

    def test_other_rules_are_compared_but_not_pooled(self):
        other = self.sets / "released"
        pooled = self.analyze("paper", other, "--out", "pooled")
        self.assertEqual(pooled.returncode, 2)
        self.assertIn("use --compare", pooled.stderr)
        self.assertFalse((self.folder / "pooled").exists())
        compared = self.analyze("--compare", "paper", other, "--out", "compared")
        self.assertEqual(compared.returncode, 0, compared.stderr)
        self.assertIn("raw: b - a [95 %]", compared.stdout)
        self.assertIn("without a shadow of each set no difference can be put down to inheritance", compared.stdout)
        summary = self.summary("compared")
        self.assertEqual([s["set"] for s in summary["sets"]], ["paper", "released"])
        self.assertTrue(any(d["raw"]["value"] for d in summary["differences"]))
        for d in summary["differences"]:
            adjusted = d["raw"]["p_adjusted"]
            self.assertEqual(d["raw"]["differs"], None if adjusted is None else adjusted <= 0.05)
        self.assertFalse(any(d["over_shadow"]["value"] for d in summary["differences"]))

    def test_differences_over_the_shadows_are_told_from_raw_ones(self):
        shutil.copytree(self.sets / "paper-as-shadow", self.folder / "paper/shadow")
        shutil.copytree(self.sets / "released", self.folder / "released")
        shutil.copytree(self.sets / "released-as-shadow", self.folder / "released/shadow")
        compared = self.analyze("--compare", "paper", "released")
        self.assertEqual(compared.returncode, 0, compared.stderr)
        self.assertIn("over shadows: (b - shadow) - (a - shadow) [95 %], p", compared.stdout)
        summary = self.summary()
        both = [{m["metric"] + m["species"] + m["group"]: m for m in s["metrics"]} for s in summary["sets"]]
        for d in summary["differences"]:
            a, b = (of[d["metric"] + d["species"] + d["group"]] for of in both)
            expected = b["baselines"][0]["difference"] - a["baselines"][0]["difference"]
            self.assertAlmostEqual(d["over_shadow"]["value"], expected)
            for part in ("raw", "over_shadow"):
                if d[part]["p"] is not None:
                    self.assertGreaterEqual(d[part]["p_adjusted"], d[part]["p"])

    def test_the_end_that_a_killed_run_left_is_named_and_another_kind_of_table_is_an_error(self):
        for replicate in (0, 1):  # as of runs that were killed, whose tables nobody summed up
            path = self.folder / f"paper/replicate-0{replicate}/manifest.json"
            content = json.loads(path.read_text())
            del content["tables"]
            path.write_text(json.dumps(content))
        with open(self.folder / "paper/replicate-00/agents.csv", "ab") as table:
            table.write(b"1000,500,0,1,pr")
        self.remove_replicates(2, 3, 4, 5)
        result = self.analyze("paper")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 5, result.stderr)
        for text in ("replicate-00/agents.csv:15032: cut off", "replicate-02: missing"):
            self.assertIn(text, result.stderr)
        (self.folder / "paper/replicate-01/events.csv").write_text("generation,fitness\n1,2\n")
        refused = self.call(TROPHIC, "analyze", "paper", "--out", "other")
        self.assertEqual((refused.returncode, refused.stdout), (2, ""), refused.stderr)
        self.assertIn('replicate-01/events.csv:1: no column "time_s"', refused.stderr)

    def test_usage_errors(self):
        for arguments, text in ((["nowhere"], "nowhere: is not a folder"), ([], "either folders of runs, or --compare"),
                                (["paper", "--compare", "paper", "paper"], "either folders of runs, or --compare"),
                                (["--compare", "paper", "paper", "--published"], "--compare: not with --shadow or --published"),
                                (["paper", "--until", -1], "--until -1: must be > 0"),
                                (["paper", "--until", 1002], "must be >= 1002 s"),
                                (["paper", "--shadow", "nowhere"], "nowhere: is not a folder")):
            with self.subTest(arguments=arguments):
                result = self.analyze(*arguments)
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
        self.assertEqual(running.returncode, 3, errors)
        self.assertIn("replicate-00: stopped", errors)
        self.assertIn("--resume", errors)
        refused = self.call(*command)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("exists already", refused.stderr)
        resumed = self.call(*command, "--resume")
        self.assertEqual(resumed.returncode, 0, resumed.stderr)
        self.assertIn("replicate-00 continues from its checkpoint at", resumed.stdout)
        self.assertIn("3 of 3 replicates complete", resumed.stdout)

    @unittest.skipUnless(figures_python.PYTHON, "needs matplotlib and pandas")
    def test_figures(self):
        self.analyze(self.sets / "released", "--out", "plain")
        self.assertEqual(self.call(figures_python.PYTHON, PLOT, "plain").returncode, 0)
        shutil.copytree(self.sets / "paper-as-shadow", self.folder / "paper/shadow")
        self.analyze("paper", "--out", "analysis")
        result = self.call(figures_python.PYTHON, PLOT, "analysis", "--trophic", TROPHIC)
        self.assertEqual(result.returncode, 0, result.stderr)
        has_film = "built without pictures" not in self.call(TROPHIC, "film", "paper/replicate-00", "-o", "probe.png").stderr
        captions = json.loads((self.folder / "analysis/figures/captions.json").read_text())
        self.assertEqual(list(captions), FIGURES + ["film_strip"] * has_film)
        for name, caption in captions.items():
            self.assertRegex(caption, r"n = \d+ runs|replicate-00: ", name)
        for name in captions:
            for ending in ("png", "pdf"):
                self.assertGreater((self.folder / f"analysis/figures/{name}.{ending}").stat().st_size, 5000)
        shutil.rmtree(self.folder / "paper")
        partly = self.call(figures_python.PYTHON, PLOT, "analysis", "--out", "partly")
        self.assertEqual(partly.returncode, 0, partly.stderr)
        self.assertIn("phylogeny: left out: ", partly.stderr)
        self.assertIn("5 figures", partly.stdout)
        self.assertIn("not what trophic analyze writes", self.call(figures_python.PYTHON, PLOT, "partly").stderr)


    def test_a_page_of_table_figures_and_replays(self):
        set_, figures = self.sets / "released", self.folder / "figures"
        figures.mkdir()
        (figures / "captions.json").write_text('{"one": "n = 3 <runs>"}')
        (figures / "one.png").write_bytes(b"\x89PNG picture")
        done = self.call(TROPHIC, "analyze", set_, "--html", "page.html", "--figures", "figures", "--replays", "0")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("page    page.html: 1 figures, 0 replays, 0.", done.stdout)
        self.assertFalse((self.folder / "analysis").exists())  # a page alone was asked for
        page = (self.folder / "page.html").read_text()
        table = done.stdout[: done.stdout.index("page    ")]
        self.assertIn(html.escape(table, quote=False).replace('"', "&quot;"), page)
        self.assertIn("n = 3 &lt;runs&gt;", page)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)[^"]*"', page), [])
        both = self.call(TROPHIC, "analyze", set_, "--html", "both.html", "--replays", "0", "--out", "both")
        self.assertEqual(both.returncode, 0, both.stderr)
        self.assertTrue((self.folder / "both/metrics.csv").exists())
        for arguments, sentence in (
            (["--html", "page.html"], "--html page.html: exists already; nothing is overwritten"),
            (["--figures", "figures"], "--figures and --replays: need --html"),
            (["--html", "x.html", "--replays", "21"], "--replays 21: must be <= 20"),
            (["--html", "x.html", "--figures", "none"], "none/captions.json: "),
        ):
            with self.subTest(arguments):
                refused = self.call(TROPHIC, "analyze", set_, *arguments)
                self.assertEqual((refused.returncode, refused.stdout, len(refused.stderr.splitlines())), (2, "", 1), refused.stderr)
                self.assertTrue(refused.stderr.startswith(f"trophic analyze: {sentence}"), refused.stderr)
        self.assertEqual((self.folder / "page.html").read_text(), page)
        (figures / "one.png").write_bytes(b"no picture")
        self.assertIn("figures/one.png: is no PNG", self.call(TROPHIC, "analyze", set_, "--html", "x.html", "--figures", "figures").stderr)
        self.assertFalse((self.folder / "x.html").exists())


if __name__ == "__main__":
    unittest.main()
