#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""start_test.py PREDATOR_PREY TROPHIC: runs that Python starts are those of the programs; what it cannot do is one sentence, and files are never overwritten."""

import importlib.util
import os
import pathlib
import re
import signal
import sys
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/program"), str(ROOT / "tools/python")]
import figures_python  # noqa: E402

figures_python.continue_with_pandas()
import pandas  # noqa: E402
import trophic  # noqa: E402
from in_folder import InFolder  # noqa: E402
from trophic.metrics import Measuring  # noqa: E402

PREDATOR_PREY, TROPHIC = sys.argv.pop(1), sys.argv.pop(1)
os.environ["TROPHIC_BIN"] = str(pathlib.Path(TROPHIC).parent)


class Start(InFolder):
    def test_a_run_is_that_of_the_program(self):
        run = trophic.run(
            "released",
            backend="kinematic",
            params={"rules": {"mutation": {"half_width": 0.3}}},
            duration=60,
            seed=7,
            out=self.folder / "mine",
        )
        self.run_ok(
            PREDATOR_PREY,
            "--rules",
            "released",
            "--backend",
            "kinematic",
            "--set",
            "rules.mutation.half_width=0.3",
            "--duration",
            60,
            "--seed",
            7,
            "--out",
            "its",
        )
        self.assertEqual((run.seed, run.manifest["rule_table"], run.complete), (7, "released", True))
        for name in ("events", "agents", "genomes"):
            self.assertEqual(
                (self.folder / f"mine/{name}.csv").read_bytes(), (self.folder / f"its/{name}.csv").read_bytes()
            )
        self.assertIn("rule table `released`", run._repr_html_())

    def test_replicates_measures_and_analysis(self):
        runs = trophic.run(
            program=PREDATOR_PREY, backend="kinematic", duration=400, replicates=6, shadow=True, out=self.folder / "set"
        )
        self.assertEqual((len(runs), len(runs.shadow)), (6, 6))
        runs.measure("catches", lambda run: (run.events.event == "catch").sum())
        analysis = trophic.analyze(runs, out=self.folder / "analysis", columns=["catches.csv:catches"])
        row = analysis.means[analysis.means.metric == "catches"].iloc[0]
        of = [float((run.events.event == "catch").sum()) for run in runs]
        null = [float((run.events.event == "catch").sum()) for run in runs.shadow]
        self.assertAlmostEqual(row["mean"], sum(of) / 6)
        self.assertAlmostEqual(row["difference"], sum(of) / 6 - sum(null) / 6)
        self.assertIn("runs", analysis._repr_html_())
        self.assertIn("6 runs of 400 s", runs._repr_html_())
        before = sorted(self.folder.rglob("*.csv"))
        for name, function, sentence in (
            ("catches", lambda run: 1, "exists already; files are never overwritten"),
            ("broken", lambda run: 1 / 0, "ZeroDivisionError"),
            ("texts", lambda run: "many", "must return a number or a frame, not str"),
            ("frames", lambda run: pandas.DataFrame({"x": [1]}), "the frame has no column frames"),
        ):
            with self.assertRaisesRegex(trophic.RunError, sentence):
                runs.measure(name, function)
        self.assertEqual(sorted(self.folder.rglob("*.csv")), before)
        runs.measure("odd", lambda run: float("nan") if run is runs[0] else 1.0)
        odd = trophic.analyze(runs, out=self.folder / "odd", columns=["odd.csv:odd"])
        self.assertEqual(odd.means[odd.means.metric == "odd"].n.iloc[0], 5)

    def test_categories(self):
        run = trophic.run("paper", backend="kinematic", duration=60, out=self.folder / "run")
        table = run.table("agents", categories=True)
        self.assertEqual(str(table.species.dtype), "category")
        self.assertLess(table.memory_usage(deep=True).sum(), run.agents.memory_usage(deep=True).sum())
        pandas.testing.assert_series_equal(table.species.astype(str), run.agents.species.astype(str))

    def test_newick_has_every_individual_at_its_time(self):
        run = trophic.run("paper", backend="kinematic", duration=1500, out=self.folder / "run")
        tree = run.phylogeny
        ends = tree.destruction_time.replace(float("inf"), float("nan"))
        end_s = max(ends.max(), tree.origin_time.max())
        died = dict(zip(tree.id, ends.fillna(end_s)))
        tips = {}
        for line in run.to_newick().splitlines():
            self.assertTrue(line.endswith(";"))
            for name, depth in leaves(line[:-1]):
                tips[name] = depth
        self.assertEqual(set(tips), {str(i) for i in tree.id})
        parent = dict(zip(tree.id, tree.ancestor_id))
        tree.loc[5, "ancestor_list"] = "[0,1]"
        with self.assertRaisesRegex(
            trophic.RunError, "must be at most one parent, because Newick trees have no second parent"
        ):
            run.to_newick()
        born = dict(zip(tree.id, tree.origin_time))
        for one in tree.id:
            root = one
            while not pandas.isna(parent[root]) and parent[root] != root and parent[root] in born:
                root = parent[root]
            self.assertAlmostEqual(tips[str(one)], died[one] - born[root], places=6)

    def study(self):
        """Sets whose tables differ: times with fractions in one of them alone, and two weights more."""
        runs = [
            trophic.run(
                table,
                backend="kinematic",
                params=numbers,
                duration=60,
                replicates=2,
                shadow=True,
                out=self.folder / name,
            )
            for name, table, numbers in (("a", "paper", {}), ("b", "released", {"ecology.tick_s": 2.5}))
        ]
        return {"a": runs[0], "b": runs[1]}

    def test_frames_of_a_study_have_the_same_columns_and_types(self):
        study = self.study()
        for name in ("events", "agents", "phylogeny", "genomes"):
            with self.subTest(name):
                frames = list(trophic.study_frames(study, name))
                self.assertEqual(len(frames), 8)
                for frame in frames[1:]:
                    pandas.testing.assert_series_equal(frame.dtypes, frames[0].dtypes)
                whole = pandas.concat(frames, ignore_index=True)
                for label, runs in study.items():
                    for null, part in (("none", runs), ("shadow", runs.shadow)):
                        ours = (
                            whole[(whole["set"] == label) & (whole.null == null)]
                            .drop(columns=["set", "null"])
                            .reset_index(drop=True)
                        )
                        its = part.table(name)
                        pandas.testing.assert_frame_equal(ours[list(its.columns)], its, check_dtype=False)
                        self.assertTrue(ours.drop(columns=list(its.columns)).isna().all(axis=None))
        self.assertEqual(
            whole.dtypes[["set", "null", "run", "seed", "id", "time_s"]].astype(str).tolist(),
            ["object", "object", "object", "uint64", "int64", "float64"],
        )

    def test_frames_of_an_own_table_have_texts_if_one_run_has(self):
        runs = trophic.run("paper", backend="kinematic", duration=20, replicates=2, out=self.folder / "set")
        runs[0].add_table("own", pandas.DataFrame({"what": [1.5]}))
        with self.assertRaisesRegex(trophic.RunError, "replicate-01/own.csv: cannot be read"):
            list(trophic.study_frames(runs, "own"))
        runs[1].add_table("own", pandas.DataFrame({"what": ["many"], "more": [2]}))
        frames = list(trophic.study_frames(runs, "own"))
        self.assertEqual([frame.what.tolist() for frame in frames], [["1.5"], ["many"]])
        self.assertEqual([frame.more.dtype for frame in frames], [float, float])

    def test_parquet_of_a_study(self):
        study = self.study()
        (self.folder / "there").mkdir()
        with self.assertRaisesRegex(trophic.RunError, "there: exists already; files are never overwritten"):
            trophic.to_parquet(study, self.folder / "there")
        before = sorted(self.folder.iterdir())
        try:
            import pyarrow  # noqa: F401
        except ModuleNotFoundError:
            with self.assertRaisesRegex(
                trophic.RunError, "^to_parquet: needs the Python module pyarrow: pip install pyarrow$"
            ):
                trophic.to_parquet(study, self.folder / "study")
            self.assertEqual(sorted(self.folder.iterdir()), before)
            self.skipTest("no pyarrow")
        paths = trophic.to_parquet(study, self.folder / "study")
        self.assertEqual(sorted(self.folder.iterdir()), sorted([*before, self.folder / "study"]))
        for path in paths:
            pandas.testing.assert_frame_equal(
                pandas.read_parquet(path), pandas.concat(trophic.study_frames(study, path.stem), ignore_index=True)
            )

    def test_refusals_are_one_sentence(self):
        (self.folder / "there").mkdir()
        for arguments, sentence in (
            (dict(out=self.folder / "there"), "exists already; files are never overwritten"),
            (dict(out=self.folder / "x", backend="none"), "must be"),
            (dict(out=self.folder / "x", params={"rules.mutatio.sd": 1}), "did you mean rules.mutation.sd"),
        ):
            with self.assertRaisesRegex(trophic.ProgramError, sentence) as raised:
                trophic.run("paper", **arguments)
            self.assertEqual(len(str(raised.exception).splitlines()), 1)
            self.assertFalse((self.folder / "x").exists())
        with self.assertRaisesRegex(trophic.ProgramError, "No such file"):
            trophic.run(program="./no/such/program", out=self.folder / "x")
        with self.assertRaisesRegex(trophic.ProgramError, "must be pond, .*; did you mean pond"):
            trophic.run("pnd", out=self.folder / "x")
        with self.assertRaisesRegex(trophic.RunError, r"^rules.x = \[1\]: must be a finite number"):
            trophic.run("paper", params={"rules": {"x": [1]}}, out=self.folder / "x")

    def watched(self, code):
        """What Python writes to standard error when it makes a run that takes half a second, with \\n for \\r."""
        run = 'import trophic; trophic.run("paper", backend="kinematic", duration=6000, out=sys.argv[1], progress=True)'
        environment = {**os.environ, "PYTHONPATH": str(ROOT / "tools/python")}
        return self.run_ok(
            sys.executable, "-c", f"import sys; {code}; {run}", self.folder / code[:5], env=environment
        ).stderr

    def test_progress_is_drawn_and_remarks_stay(self):
        without = self.watched("sys.modules['tqdm'] = None")
        self.assertRegex(without, r"\n[\d.]+ of 6000 s  [\d.]+ %  .*\x1b\[K")
        remark = r"remark  physics.timestep_s, .* have no effect: .*\n$"
        self.assertRegex(without, remark)
        if importlib.util.find_spec("tqdm") is None:
            self.skipTest("no tqdm")
        bar = self.watched("pass")
        self.assertRegex(bar, r"\d+%\|.*[\d.]+ of 6000 s, .*x real time")
        self.assertIn("100%|", bar)
        self.assertRegex(bar, remark)

    def test_an_interrupt_leaves_a_run_that_continues(self):
        whole = trophic.run("paper", backend="kinematic", duration=20000, out=self.folder / "whole")
        timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                trophic.run("paper", backend="kinematic", duration=20000, out=self.folder / "run")
        finally:
            timer.cancel()
        self.assertEqual(trophic.read_run(self.folder / "run").manifest["status"], "stopped")
        run = trophic.run("paper", backend="kinematic", duration=20000, out=self.folder / "run", resume=True)
        self.assertTrue(run.complete)
        for name in ("events", "agents", "genomes"):
            self.assertEqual((run.path / f"{name}.csv").read_bytes(), (whole.path / f"{name}.csv").read_bytes())

    def test_a_sweep_is_that_of_its_file(self):
        sweep = {
            "rule_table": "pond",
            "engine": "kinematic",
            "replicates": 2,
            "set": {"ecology": {"duration_s": 60}},
            "grid": {"rules.mutation.sd": (0.05, 0.2)},
        }
        cells = trophic.sweep(sweep, out=self.folder / "sweep")
        self.assertEqual([(name, len(runs)) for name, runs in cells.items()], [("cell-000", 2), ("cell-001", 2)])
        self.assertTrue(all(run.complete for runs in cells.values() for run in runs))
        self.assertIn(
            "<pre>sweep of 2 cells, 4 runs of 60 s",
            trophic.analyze_sweep(self.folder / "sweep", how=Measuring(jobs=1))._repr_html_(),
        )
        again = trophic.sweep(self.folder / "sweep/sweep.toml", out=self.folder / "again")
        plan = [(self.folder / name / "plan.jsonl").read_bytes() for name in ("sweep", "again")]
        self.assertEqual(plan[0], plan[1])
        for name, runs in again.items():
            pandas.testing.assert_frame_equal(runs.table("events"), cells[name].table("events"))
        for wrong, sentence in (
            ({"grid": {"x": 3}}, r"^sweep: \[grid\] x = 3: must be a list"),
            ({**sweep, "gird": {}}, r"^sweep: \[gird\]: unknown key; did you mean grid"),
            ({**sweep, "grid": {"rules.mutatio.sd": [1]}}, r"^sweep: cell 0 .* did you mean rules.mutation.sd"),
            ({"runs": [3]}, r"^sweep: runs: must be sections"),
        ):
            with self.assertRaisesRegex(trophic.RunError, sentence):
                trophic.sweep(wrong, out=self.folder / "wrong")
        with self.assertRaisesRegex(trophic.RunError, "the folder has another plan"):
            trophic.sweep({**sweep, "seed": 2}, out=self.folder / "sweep")
        self.assertFalse((self.folder / "wrong").exists())

    def test_a_checker_of_types_sees_every_name(self):
        text = (ROOT / "tools/python/trophic/__init__.pyi").read_text()
        self.assertEqual(sorted(re.findall(r"(\w+) as \1\b", text)), sorted({*trophic.__all__, *trophic._PARTS}))


def leaves(text):
    """(name, distance from the root) of each leaf of a Newick tree."""
    nodes, groups, closed = [], [[]], None  # a node: name, length, parent, whether it is a leaf
    for token in re.findall(r"[()]|[^(),]+", text):
        if token == "(":
            groups.append([])
        elif token == ")":
            closed = groups.pop()
        else:
            name, _, length = token.partition(":")
            for child in closed or []:
                nodes[child][2] = len(nodes)
            groups[-1].append(len(nodes))
            nodes.append([name, float(length), None, closed is None])
            closed = None

    def depth(node):
        total = 0.0
        while node is not None:
            total += nodes[node][1]
            node = nodes[node][2]
        return total

    return [(node[0], depth(number)) for number, node in enumerate(nodes) if node[3]]


if __name__ == "__main__":
    unittest.main()
