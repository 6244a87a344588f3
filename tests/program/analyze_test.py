#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""analyze_test.py PREDATOR_PREY TROPHIC: from replicates to figures, as users meet it: files, errors, exit codes."""

import html
import json
import re
import shutil
import sys
import unittest

import figures_python
from in_folder import InFolderWithSets, run_ok, sealed_text

PREDATOR_PREY, TROPHIC = (sys.argv.pop(1) for _ in range(2))
FIGURES = [
    "attribution",
    "velocity",
    "wall_sticking",
    "tag_symmetry",
    "population",
    "with_and_without",
    "phylogeny",
    "catches",
    "trajectories",
]


class Analyze(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        for rules in ("paper", "released"):
            for out, seed in ((rules, 1), (f"{rules}-as-shadow", 2)):
                run_ok(
                    PREDATOR_PREY,
                    "--backend",
                    "kinematic",
                    "--rules",
                    rules,
                    "--duration",
                    1000,
                    "--replicates",
                    6,
                    "--jobs",
                    2,
                    "--seed",
                    seed,
                    "--out",
                    out,
                    cwd=cls.sets,
                )
            for manifest in (cls.sets / f"{rules}-as-shadow").glob("*/manifest.json"):
                content = json.loads(manifest.read_text())
                content["rules"]["heredity"] = "nothing_inherited"
                content["fingerprint"] = "5ad0"
                manifest.with_name("checkpoint.bin").unlink()
                manifest.write_text(sealed_text(content))

    def setUp(self):
        super().setUp()
        shutil.copytree(self.sets / "paper", self.folder / "paper")

    def analyze(self, *arguments):
        return self.call(TROPHIC, "analyze", *arguments)

    def analyze_ok(self, *arguments):
        return self.run_ok(TROPHIC, "analyze", *arguments)

    def summary(self, out="analysis"):
        return json.loads((self.folder / out / "summary.json").read_text())

    def test_one_command_from_replicates_to_results(self):
        result = self.analyze_ok("paper", "--out", "analysis")
        self.assertEqual(result.stderr, "")
        for text in (
            "6 runs of 1000 s",
            "attribution_caught prey",
            "= permuted_tags",
            "bernoulli_tags",
            "0.725",
            "no shadow: ",
        ):
            self.assertIn(text, result.stdout)
        self.assertEqual([r["status"] for r in self.summary()["sets"][0]["runs"]], ["complete"] * 6)
        rows = self.rows("analysis/metrics.csv")
        self.assertEqual({r["run"] for r in rows}, {f"replicate-0{i}" for i in range(6)})
        self.assertNotIn("nan", {r["value"].lower() for r in rows})
        points = [
            r
            for r in rows
            if r["run"] == "replicate-00"
            and r["metric"] == "velocity"
            and r["species"] == "prey"
            and r["group"] == "all"
            and r["baseline"] == ""
            and r["time_s"]
        ]
        self.assertEqual(len(points), 5)
        self.assert_refused(self.analyze("paper", "--out", "analysis"), "exists already")

    def test_the_shadow_is_found_and_is_the_null_of_every_metric(self):
        shutil.copytree(self.sets / "paper-as-shadow", self.folder / "paper/shadow")
        result = self.analyze_ok("paper")
        self.assertIn("shadow: paper on kinematic 1, 6 runs of 1000 s", result.stdout)
        for metric in self.summary()["sets"][0]["metrics"]:
            shadow = metric["baselines"][0]
            self.assertEqual((shadow["name"], shadow["role"] == "null"), ("shadow", shadow["not_tested"] is None))
            if shadow["not_tested"]:
                continue
            self.assertIn(shadow["conclusion"], ("above", "below", "inconclusive", "same", "not compared"))
            self.assertLessEqual(shadow["lower"], shadow["difference"])
            self.assertTrue(all(b["conclusion"] is None for b in metric["baselines"] if b["role"] != "null"))
        shadows = [r for r in self.rows("analysis/metrics.csv") if r["baseline"] == "shadow"]
        self.assertEqual({r["set"] for r in shadows}, {"paper"})
        named = self.analyze(self.sets / "paper", "--shadow", "paper/shadow", "--out", "named")
        self.assertEqual(named.stdout.replace("named/", "analysis/"), result.stdout)
        self.assertEqual(result.stdout.count("\n  inconclusive "), 1)
        self.assertIn("inconclusive does not mean equal", result.stdout)
        self.assertLess(len(result.stdout.splitlines()), 20)
        self.assertIn("uniform_density", self.analyze("paper", "--all", "--out", "all").stdout)
        wrong = self.analyze("paper", "--shadow", self.sets / "released-as-shadow", "--out", "wrong")
        self.assert_refused(wrong, "is not a neutral shadow of paper/replicate-00: params/")
        self.assertFalse((self.folder / "wrong").exists())

    def test_folders_for_results_are_new_and_claimed_before_work(self):
        (self.folder / "analysis").mkdir()
        done = self.analyze_ok("paper")
        self.assertIn("files   analysis-1/{metrics.csv,means.csv,means.tex,summary.json}", done.stdout)
        self.assertEqual(list((self.folder / "analysis").iterdir()), [])
        with open(self.folder / "paper/replicate-02/events.csv", "a") as table:
            table.write("changed\n")
        refused = self.analyze("paper", "--out", "analysis-1")
        self.assertEqual(refused.stdout, "")
        self.assert_refused(refused, "analysis-1: exists already")
        self.assert_refused(self.analyze("paper", "--out", "broken"), "the table was cut or modified after the run")
        self.assertFalse((self.folder / "broken").exists())

    @unittest.skipUnless(figures_python.PYTHON, "needs matplotlib and pandas")
    def test_figures(self):
        self.analyze(self.sets / "released", "--out", "plain")
        self.run_ok(TROPHIC, "plot", "plain")
        shutil.copytree(self.sets / "paper-as-shadow", self.folder / "paper/shadow")
        self.analyze("paper", "--out", "analysis")
        self.run_ok(TROPHIC, "plot", "analysis", "--style", "ieee")
        has_film = (
            "built without pictures" not in self.call(TROPHIC, "film", "paper/replicate-00", "-o", "probe.png").stderr
        )
        captions = json.loads((self.folder / "analysis/figures/captions.json").read_text())
        self.assertEqual(list(captions), FIGURES + ["film_strip"] * has_film)
        tex = (self.folder / "analysis/figures/captions.tex").read_text()
        self.assertIn(
            "\\newcommand{\\trophicWallSticking}{Share of robots within 1 m of a wall, by the rules of paper on kinematic 1. Windows of 200 s",
            tex,
        )
        for name, caption in captions.items():
            self.assertRegex(caption, r"n = \d+ runs|replicate-00: ", name)
            self.assertRegex(caption, r"^[A-Z].*, by the rules of \w+ on kinematic 1\. |^replicate-00: ", name)
        for name in captions:
            for ending in ("png", "pdf"):
                self.assertGreater((self.folder / f"analysis/figures/{name}.{ending}").stat().st_size, 5000)
        again = self.call(TROPHIC, "plot", "analysis", "--out", "analysis/figures")
        self.assertEqual(again.stdout, "")
        self.assert_refused(again, "figures: exists already; files are never overwritten")
        self.assertIn("figures in analysis/figures-1, with", self.run_ok(TROPHIC, "plot", "analysis").stdout)
        self.analyze("--compare", "paper", self.sets / "released", "--out", "compared")
        self.run_ok(TROPHIC, "plot", "compared")
        self.assertIn("forest", json.loads((self.folder / "compared/figures/captions.json").read_text()))
        shutil.rmtree(self.folder / "paper")
        partly = self.run_ok(TROPHIC, "plot", "analysis", "--out", "partly")
        self.assertIn("phylogeny: left out: ", partly.stderr)
        self.assertIn("5 figures", partly.stdout)
        self.assert_refused(self.call(TROPHIC, "plot", "partly"), "not what trophic analyze writes")
        self.assertIn("nowhere: does not exist", self.call(TROPHIC, "plot", "nowhere").stderr)

    def test_a_page_of_table_figures_and_replays(self):
        set_, figures = self.sets / "released", self.folder / "figures"
        figures.mkdir()
        (figures / "captions.json").write_text('{"one": "n = 3 <runs>"}')
        (figures / "one.png").write_bytes(b"\x89PNG picture")
        done = self.call(TROPHIC, "analyze", set_, "--html", "page.html", "--figures", "figures", "--replays", "0")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("page    page.html: 1 figures, 0 replays, 0.", done.stdout)
        self.assertFalse((self.folder / "analysis").exists())  # only a page was asked for
        page = (self.folder / "page.html").read_text()
        table = done.stdout[: done.stdout.index("page    ")]
        self.assertIn("<figcaption>n = 3 &lt;runs&gt;</figcaption>", page)
        self.assertIn(table, html.unescape(page))
        self.assertIn("n = 3 &lt;runs&gt;", page)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)[^"]*"', page), [])
        self.analyze_ok(set_, "--html", "both.html", "--replays", "0", "--out", "both")
        self.assertTrue((self.folder / "both/metrics.csv").exists())
        for arguments, sentence in (
            (["--html", "page.html"], "--html page.html: exists already; files are never overwritten"),
            (["--html", "x.html", "--figures", "none"], "none/captions.json: "),
        ):
            with self.subTest(arguments):
                refused = self.analyze(set_, *arguments)
                self.assert_refused(refused, f"trophic analyze: {sentence}")
                self.assertEqual(refused.stdout, "")
        self.assertEqual((self.folder / "page.html").read_text(), page)
        (figures / "one.png").write_bytes(b"no picture")
        self.assertIn(
            "figures/one.png: is not a PNG",
            self.call(TROPHIC, "analyze", set_, "--html", "x.html", "--figures", "figures").stderr,
        )
        self.assertFalse((self.folder / "x.html").exists())


if __name__ == "__main__":
    unittest.main()
