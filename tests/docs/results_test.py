#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""results_test.py ROOT: the tables of the pages, with their lines of origin, match studies/results/data; the screening design separates its effects."""

import collections
import itertools
import json
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path[:0] = [str(ROOT / "tests/program"), str(ROOT / "studies/python")]
import system_python

sys.argv[1:1] = [str(ROOT)]
system_python.need("scipy")
del sys.argv[1]
import data_rows
import designs
import provenance


class Pages(unittest.TestCase):
    def test_tables_match_the_data(self):
        result = subprocess.run(
            [sys.executable, ROOT / "studies/reproduce", "--tables", "--check"], capture_output=True, text=True
        )
        self.assertEqual(result.returncode, 0, result.stderr)


DATA = ROOT / "studies/results/data"


class Origins(unittest.TestCase):
    def test_each_data_file_has_one_row_of_origin(self):
        files = {path.stem for path in DATA.glob("*.csv")} - {"provenance"}
        rows = data_rows.read(DATA / "provenance.csv")
        self.assertEqual(sorted(files), [row["data"] for row in rows])
        for row in rows:
            self.assertFalse([field for field in provenance.FIELDS if not row[field]], row)

    def test_revisions_are_commits_of_the_history(self):
        if not (ROOT / ".git").exists():
            self.skipTest("not a checkout")
        for revision in {row["revision"] for row in data_rows.read(DATA / "provenance.csv")}:
            for commit in revision.removeprefix(provenance.BEFORE).split(", "):
                self.assertRegex(commit, "^[0-9a-f]{8,40}$")
                done = subprocess.run(["git", "-C", ROOT, "merge-base", "--is-ancestor", commit, "HEAD"])
                self.assertEqual(done.returncode, 0, revision)

    def test_values_of_runs_have_the_seeds_and_means_of_their_tables(self):
        origins = provenance.read(DATA)
        tables = [path for path in DATA.glob("*_runs.csv")]
        for path in tables:
            self.assertLess(path.stat().st_size, 200_000, path)
            data = path.stem.removesuffix("_runs")
            values = collections.defaultdict(dict)
            for row in data_rows.read(path):
                key = tuple(row[name] for name in ("set", "null", "metric", "species", "group"))
                values[key][int(row["run"])] = float(row["value"])
            runs = {run for of_key in values.values() for run in of_key}
            self.assertEqual(f"{len(runs)} of master seed", origins[data]["seeds"].rpartition(" ")[0], path)
            compared = 0
            for row in data_rows.read(DATA / f"{data}.csv"):
                key = (row["set"], "", row["metric"], row["species"], row["group"])
                if key in values and row["mean"]:
                    of_key = list(values[key].values())
                    self.assertEqual(len(of_key), int(row["runs"]), (path, key))
                    self.assertAlmostEqual(statistics.mean(of_key) / (float(row["mean"]) or 1.0), 1.0, delta=1e-4)
                    compared += 1
            self.assertGreater(compared, 0, path)

    def test_a_row_names_what_the_manifests_of_its_runs_have(self):
        with tempfile.TemporaryDirectory() as name:
            for seed, null in ((1, ""), (2, ""), (1, "shadow"), (2, "one_sided_prey")):
                run = pathlib.Path(name) / null / f"replicate-{seed:02}"
                run.mkdir(parents=True)
                table = "paper with heredity = nothing_inherited" if null else "paper"
                manifest = {"source_revision": "abc", "backend": "kinematic 1", "rule_table": table, "seed": 70 + seed}
                (run / "manifest.json").write_text(json.dumps(manifest))
            (pathlib.Path(name) / "replicates.json").write_text('{"master_seed": 1}')
            row = provenance.row("paper", "kinematic-paper", provenance.facts(name))
        self.assertEqual(row["runs"], "2 + 1 one-sided + 1 shadow")
        self.assertEqual((row["tables"], row["engine"], row["revision"]), ("paper", "kinematic 1", "abc"))
        self.assertEqual(row["seeds"], "2 of master seed 1")
        self.assertEqual(provenance.seeds_of([{"seed": 5, "master": None}]), "5")
        self.assertEqual(
            provenance.line([row, row | {"data": "paper_answers"}]),
            "*`studies/reproduce kinematic-paper`: 2 + 1 one-sided + 1 shadow runs of `paper`, kinematic 1, seeds: 2 of master seed 1, revision abc.*\n",
        )

    def test_data_are_stale_if_a_later_commit_touches_the_code_of_their_runs(self):
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)

            def commit(path, text):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text)
                identity = ("-c", "user.name=a", "-c", "user.email=a@b")
                for words in (("init", "-q"), ("add", "-A"), (*identity, "commit", "-q", "-m", "a")):
                    subprocess.run(["git", "-C", root, *words], check=True, capture_output=True)
                return provenance.git(root, "rev-parse", "HEAD").strip()

            first = commit("include/trophic/a.hpp", "1")
            row = dict.fromkeys(provenance.FIELDS, "") | {"stage": "mujoco-paper", "engine": "mujoco 2.2.2"}
            provenance.write(root, row | {"data": "bodies", "revision": first})
            provenance.write(root, row | {"data": "points", "engine": "kinematic 1", "revision": first})
            commit("docs/page.md", "1")
            self.assertEqual(provenance.stale(root, root), [])
            commit("backends/mujoco/a.hpp", "1")
            self.assertEqual(provenance.stale(root, root), [("bodies", first, 1)])
            before = f"{provenance.BEFORE}{first}"
            provenance.write(root, row | {"data": "points", "engine": "kinematic 1", "revision": before})
            commit("include/trophic/a.hpp", "2")
            self.assertEqual(provenance.stale(root, root), [("bodies", first, 2), ("points", before, 1)])
            provenance.write(root, row | {"data": "points", "revision": "unknown"})
            with self.assertRaisesRegex(SystemExit, "points: revision: unknown: must name a commit"):
                provenance.stale(root, root)


NUMBER = r"([-+]?[\d,]+\.?\d*)"
TRIPLE = re.compile(
    NUMBER + r"(?: (?:cm/s|s|m|types?|of [\w ]{1,20}|a run|cm/s a run))? \[" + NUMBER + ", " + NUMBER + r"\]"
)
INTERVALS = (
    ("mean", "lower", "upper"),
    ("contact_s", "lower", "upper"),
    ("difference", "lower", "upper"),
    ("difference", "difference_lower", "difference_upper"),
    ("difference", "together_lower", "together_upper"),
    ("effect", "lower", "upper"),
    ("over_shadow", "lower", "upper"),
    ("over_shadow", "over_lower", "over_upper"),
    ("over_shadow", "shadow_lower", "shadow_upper"),
    ("over_survival", "lower", "upper"),
    ("over_neutral", "neutral_lower", "neutral_upper"),
    ("runs_mean", "runs_lower", "runs_upper"),
    ("shadow_mean", "shadow_lower", "shadow_upper"),
    ("neutral_mean", "neutral_lower", "neutral_upper"),
)


def intervals_of_data():
    """Each effect with its interval in the data, also in units a hundred times smaller."""
    found = []
    for path in DATA.glob("*.csv"):
        for row in data_rows.read(path):
            for names in INTERVALS:
                try:
                    values = [float(row[name]) for name in names]
                except (KeyError, ValueError):
                    continue
                found += [values, [100.0 * value for value in values]]
    return found


def is_written(text, value):
    places = len(text.partition(".")[2])
    return abs(float(text.replace(",", "")) - value) <= 0.5000001 * 10.0**-places


class Prose(unittest.TestCase):
    """Pages: an effect with its interval outside a table is one of the data, or of a table of the page."""

    def test_effects_in_sentences_are_in_the_data(self):
        data, missing, self.maxDiff = intervals_of_data(), [], None
        for path in (ROOT / "README.md", *sorted((ROOT / "studies/results").glob("*.md"))):
            tables = [
                [float(text.replace(",", "")) for text in found.groups()]
                for table in re.findall(r"<!-- table: .*?<!-- /table -->", path.read_text(), re.S)
                for found in TRIPLE.finditer(table)
            ]
            prose = re.sub(r"<!-- table: .*?<!-- /table -->", "", path.read_text(), flags=re.S)
            for found in TRIPLE.finditer(re.sub(r"\s+", " ", prose)):
                texts = found.groups()
                flipped = [[-middle, -upper, -lower] for middle, lower, upper in data + tables]
                if not any(all(map(is_written, texts, values)) for values in data + tables + flipped):
                    missing.append(f"{path.name}: {found[0]}")
        self.assertEqual(missing, [])


class Rows(unittest.TestCase):
    def test_answers_have_no_observed_power(self):
        for path in DATA.glob("*.csv"):
            self.assertNotIn("runs would decide", path.read_text(), path)
        self.assertEqual(data_rows.without_observed_power("no (9 runs would decide the rest)"), "no")

    def test_numbers_that_are_not_zero_are_not_written_as_zero(self):
        self.assertEqual(
            [data_rows.fixed(value, 2, "+") for value in (0.274, -0.0016, 0.0)], ["+0.27", "-0.002", "+0.00"]
        )

    def test_prices_terms_are_tested_over_the_neutral_null_alone(self):
        def term(mean, neutral):
            of = {
                "term": "survival",
                "runs_n": 6,
                "runs_mean": mean,
                "runs_lower": mean - 1.0,
                "runs_upper": mean + 1.0,
                "p": 0.001,
            }
            null = {"neutral_n": 6, "neutral_mean": neutral}
            null |= {
                f"neutral_{end}": "" if neutral == "" else neutral + by for end, by in (("lower", -1), ("upper", 1))
            }
            return {key: str(value) for key, value in (of | null | {"p_holm": 0.001, "null": "zero"}).items()}

        alike, apart, alone = data_rows.over_neutral([term(3.0, 3.1), term(3.0, 0.0), term(3.0, "")])
        self.assertGreater(float(alike["p_holm"]), 0.5)
        self.assertLess(float(apart["p_holm"]), 0.01)
        self.assertEqual((alone["p"], alone["p_holm"], alone["difference"]), ("", "", ""))

    def test_stars_stand_over_the_null_of_the_measure(self):
        from page_tables import cells

        marked = [
            cells.star_over(null, metric, "0.01")
            for metric in ("body_plans", "walked")
            for null in ("shadow", "neutral")
        ]
        self.assertEqual(marked, ["", "*", "*", ""])

    def test_runs_for_an_effect_of_interest_depend_on_the_spread_alone(self):
        row = {"runs": "10", "lower": "-1.0", "upper": "1.0"}
        runs = data_rows.runs_for(row, 1.0, 0.05)
        self.assertEqual(runs, data_rows.runs_for(row | {"lower": "4.0", "upper": "6.0"}, 1.0, 0.05))
        self.assertGreater(data_rows.runs_for(row, 0.5, 0.05), 3 * runs)


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
