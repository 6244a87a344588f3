#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""runs_test.py PREDATOR_PREY TROPHIC: the Python module reads what the programs wrote, and agrees with `trophic analyze`."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/program"), str(ROOT / "tools/python")]
import figures_python  # noqa: E402

figures_python.continue_with_pandas()
import pandas  # noqa: E402
import trophic.runs as runs  # noqa: E402
from in_folder import run_ok, sealed_text  # noqa: E402

PREDATOR_PREY, TROPHIC = sys.argv.pop(1), sys.argv.pop(1)


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        for name, rules in (("set", "paper"), ("study/one", "paper"), ("study/two", "released")):
            count = "6" if name == "set" else "1"
            duration = "1200" if name == "set" else "60"
            cls.call(
                PREDATOR_PREY,
                "--backend",
                "kinematic",
                "--rules",
                rules,
                "--duration",
                duration,
                "--replicates",
                count,
                "--shadow",
                *(["--one-sided", "--clones"] if name != "set" else []),
                "--out",
                name,
            )
        cls.call(TROPHIC, "analyze", "set", "--out", "analysis")

    @classmethod
    def call(cls, *command):
        run_ok(*command, cwd=cls.folder)

    def test_a_run_with_senses(self):
        self.call(PREDATOR_PREY, "--backend", "kinematic", "--duration", "60", "--senses", "--out", "sensing")
        run = runs.read_run(self.folder / "sensing")
        self.assertEqual(len(run.senses), 30 * 31)
        self.assertEqual(
            [name for name in run.senses.columns if name.startswith("input")],
            [f"input{i}" for i in range(len(run.inputs))],
        )
        self.assertTrue(run.senses.height_m.isna().all())
        self.assertLessEqual(set(run.senses.tag_outcome), {"", "kept", "switched", "denied"})
        self.assertEqual(run.senses.input2.dtype, float)

    def test_a_run_has_its_manifest_and_every_row(self):
        run = runs.read_run(self.folder / "set/replicate-00")
        self.assertTrue(run.complete)
        self.assertEqual(run.manifest, json.loads((run.path / "manifest.json").read_text()))
        for name in ("events", "agents", "phylogeny", "genomes"):
            lines = (run.path / f"{name}.csv").read_text().splitlines()
            self.assertEqual(len(getattr(run, name)), len(lines) - 1, name)
            self.assertEqual(list(getattr(run, name).columns), lines[0].split(","), name)
        self.assertEqual(set(run.agents.species), {"prey", "predator"})
        self.assertEqual(len(run.agents), 30 * 601)
        births = run.events[run.events.event == "birth"]
        self.assertEqual(set(births.cause), {""})  # a missing cause is an empty text, not a number
        self.assertTrue(births.killer_id.isna().all())

    def test_numbers_are_read_as_they_were_written(self):
        run = runs.read_run(self.folder / "set/replicate-01")
        first = (run.path / "genomes.csv").read_text().splitlines()[1].split(",")
        read = run.genomes.iloc[0]
        for column, text in zip(run.genomes.columns, first):
            if column.startswith("weight") or column.startswith("w"):
                self.assertEqual(float(text), read[column])

    def test_a_set_and_its_shadow(self):
        paper = runs.read_runs(self.folder / "set")
        self.assertEqual((len(paper), len(paper.shadow)), (6, 6))
        self.assertEqual([run.seed for run in paper], [run.seed for run in paper.shadow])
        events = paper.table("events", ["time_s", "event", "species"])
        self.assertEqual(list(events.columns), ["run", "seed", "time_s", "event", "species"])
        self.assertEqual(events.run.nunique(), 6)
        self.assertEqual(len(events), sum(len(run.events) for run in paper))

    def test_counts_are_those_of_analyze(self):
        analysis = runs.read_analysis(self.folder / "analysis")
        metrics = analysis.metrics
        values = metrics[(metrics.baseline == "") & metrics.time_s.isna()]
        for run in runs.read_runs(self.folder / "set"):
            of_run = values[values.run == run.path.name]

            def analysed(metric, species, group="all"):
                return of_run[
                    (of_run.metric == metric) & (of_run.species == species) & (of_run.group == group)
                ].value.item()

            deaths = run.events[run.events.event == "death"]
            for species in ("prey", "predator"):
                self.assertEqual((deaths.species == species).sum(), analysed("deaths", species))
            caught = deaths[(deaths.species == "prey") & (deaths.cause == "caught")]
            self.assertGreater(len(caught), 5)
            self.assertAlmostEqual(
                (caught.origin == "inherited").mean(), analysed("attribution_caught", "prey"), places=12
            )
            half_m = analysis.summary["sets"][0]["runs"][0]["half_side_m"]
            near = run.agents[["x_m", "y_m"]].abs().max(axis=1) >= half_m - 1.0
            share = near[run.agents.species == "prey"].groupby(run.agents.tick).mean().mean()
            self.assertAlmostEqual(share, analysed("wall_sticking", "prey"), places=2)

    def test_a_study_is_read_set_by_set(self):
        study = runs.read_study(self.folder / "study")
        self.assertEqual(list(study), ["one", "two"])
        self.assertEqual([sets[0].manifest["rule_table"] for sets in study.values()], ["paper", "released"])

    def test_a_set_and_its_one_sided_worlds(self):
        two = runs.read_runs(self.folder / "study/two")
        self.assertEqual(list(two.one_sided), ["prey", "predator"])
        for species, world in two.one_sided.items():
            self.assertEqual([run.seed for run in world], [run.seed for run in two])
            self.assertEqual(world[0].manifest["rules"]["heredity"], f"shared_copy, nothing_inherited for {species}")
        nulls = pandas.concat(runs.study_frames(two, "events"))["null"]
        self.assertEqual(list(nulls.unique()), ["none", "shadow", "one_sided_prey", "one_sided_predator"])
        two.measure("rows", lambda run: len(run.events))
        for folder in (".", "shadow", "one_sided_prey", "one_sided_predator"):
            self.assertTrue((two.path / folder / "replicate-00/rows.csv").is_file())
        self.assertEqual(runs.read_runs(self.folder / "set").one_sided, {})

    def test_a_folder_that_is_not_a_run_is_named_in_the_error(self):
        (self.folder / "empty").mkdir(exist_ok=True)
        (self.folder / "broken").mkdir(exist_ok=True)
        (self.folder / "broken/manifest.json").write_text("{")
        (self.folder / "mixed").mkdir(exist_ok=True)
        for number, origin in enumerate(("study/one", "study/two")):
            link = self.folder / f"mixed/replicate-0{number}"
            if not link.exists():
                link.symlink_to(self.folder / origin / "replicate-00")
        for read, name, said in (
            (runs.read_run, "empty", "no manifest.json"),
            (runs.read_run, "broken", "is not a JSON object"),
            (runs.read_runs, "empty", "no complete replicates"),
            (runs.read_runs, "mixed", "different fingerprints"),
            (runs.read_study, "empty", "no set of runs"),
            (runs.read_analysis, "empty", "not what trophic analyze writes"),
        ):
            with self.assertRaises(runs.RunError) as refused:
                read(self.folder / name)
            self.assertIn(said, str(refused.exception))
            self.assertIn(name, str(refused.exception))

    def test_an_incomplete_run_is_left_out_unless_asked_for(self):
        folder = self.folder / "cut"
        if not folder.exists():
            subprocess.run(["cp", "-r", self.folder / "set", folder], check=True)
            manifest = json.loads((folder / "replicate-00/manifest.json").read_text())
            manifest["status"] = "running"
            (folder / "replicate-00/manifest.json").write_text(sealed_text(manifest))
        self.assertEqual(len(runs.read_runs(folder)), 5)
        self.assertEqual(len(runs.read_runs(folder, incomplete=True)), 6)

    def test_a_table_that_is_not_what_the_run_wrote_is_refused(self):
        folder = self.folder / "damaged"
        subprocess.run(["cp", "-r", self.folder / "set/replicate-00", folder], check=True)
        for name in ("events", "agents", "phylogeny", "genomes"):
            path = folder / f"{name}.csv"
            whole = path.read_bytes()
            for damaged in (
                whole[:-9],
                b"\xef\xbb\xbf" + whole,
                whole.replace(b"\n", b"\r\n"),
                whole.replace(b"0", b"1", 1),
            ):
                path.write_bytes(damaged)
                with self.subTest(name=name), self.assertRaisesRegex(
                    runs.RunError, f"damaged/{name}.csv: has .* as its manifest says"
                ):
                    getattr(runs.read_run(folder), name)
            path.unlink()
            with self.assertRaisesRegex(runs.RunError, f"damaged/{name}.csv: cannot be read"):
                getattr(runs.read_run(folder), name)
            path.write_bytes(whole)

    def test_a_table_that_cannot_be_read_is_refused_also_without_checksums(self):
        folder = self.folder / "unsummed"
        subprocess.run(["cp", "-r", self.folder / "set/replicate-00", folder], check=True)
        manifest = json.loads((folder / "manifest.json").read_text())
        del manifest["tables"]
        (folder / "manifest.json").write_text(sealed_text(manifest))
        path = folder / "events.csv"
        whole = path.read_bytes()
        lines = whole.splitlines(keepends=True)
        for damaged, said in (
            (b"\xef\xbb\xbf" + whole, "byte order mark"),
            (b"", "no header"),
            (whole + b"1,2\n", "2 cells, the header has 16"),
            (b"".join([lines[0], *reversed(lines[1:])]), "tick: must be >= that of the row before"),
            (whole.replace(b",prey,", b",wolf,", 1), "species = 'wolf': must be a species"),
            (b"".join([*lines[:-1], b"inf" + lines[-1][lines[-1].index(b",") :]]), "time_s: must be finite numbers"),
            (b"".join([*lines[:-1], b"nan" + lines[-1][lines[-1].index(b",") :]]), "time_s: must be finite numbers"),
        ):
            path.write_bytes(damaged)
            with self.subTest(said), self.assertRaisesRegex(runs.RunError, said):
                runs.read_run(folder).events
        path.unlink()
        os.mkfifo(path)
        with self.assertRaisesRegex(runs.RunError, "is not a regular file"):
            runs.read_run(folder).events
        path.unlink()
        path.write_bytes(whole)
        for manifest in (
            b"[]",
            b"\xff",
            b'{"status": "complete"}',
            b'{"status": 1, "seed": 1, "fingerprint": "0", "rule_table": "paper"}',
        ):
            (folder / "manifest.json").write_bytes(manifest)
            with self.subTest(manifest), self.assertRaisesRegex(
                runs.RunError, "manifest.json: (is not a JSON object|not a run's)"
            ):
                runs.read_run(folder)

    def test_runs_of_two_builds_are_a_set_only_if_that_is_accepted(self):
        folder = self.folder / "builds"
        subprocess.run(["cp", "-r", self.folder / "set", folder], check=True)
        path = folder / "replicate-00/manifest.json"
        path.write_text(
            sealed_text(json.loads(path.read_text()) | {"continued": [{"code": "another", "other_build": "accepted"}]})
        )
        with self.assertRaisesRegex(runs.RunError, "builds: made by different builds: "):
            runs.read_runs(folder)
        mixed = runs.read_runs(folder, accept_other_build=True)[0]
        self.assertEqual(mixed.builds, sorted([mixed.manifest["code"], "another"]))

    def test_an_incomplete_last_line_is_not_a_row(self):
        folder = self.folder / "killed"
        subprocess.run(["cp", "-r", self.folder / "set/replicate-00", folder], check=True)
        whole = runs.read_run(folder).agents
        path = folder / "agents.csv"
        manifest = json.loads((folder / "manifest.json").read_text())
        del manifest["tables"]  # a killed program writes none
        (folder / "manifest.json").write_text(sealed_text(manifest))
        path.write_bytes(path.read_bytes()[:-9])
        cut = runs.read_run(folder).agents
        self.assertEqual(len(cut), len(whole) - 1)
        self.assertEqual(list(cut.dtypes), list(whole.dtypes))


if __name__ == "__main__":
    unittest.main()
