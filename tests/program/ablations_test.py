#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""ablations_test.py ABLATIONS PREDATOR_PREY TROPHIC: ablations of the two tables, as users run and read them."""

import collections
import itertools
import json
import shutil
import sys
import unittest

from in_folder import InFolderWithSets, run_ok

ABLATIONS, PREDATOR_PREY, TROPHIC = sys.argv[1:4]
GROUPS = {"perception", "reproduction", "death", "ecology"}
TABLES = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"]


def manifest(run):
    return json.loads((run / "manifest.json").read_text())


def numbers(tree, path=""):
    """Each number of a manifest with its path."""
    if not isinstance(tree, dict):
        return {path: tree}
    flat = {}
    for name, part in tree.items():
        flat.update(numbers(part, f"{path}.{name}" if path else name))
    return flat


def policies(run):
    """Each policy of a manifest with its slot; those of a policy that is made of parts with SLOT.PART."""
    found = {}
    for slot, policy in run["rules"].items():
        parts = dict(part.split(": ") for part in policy.split(", ")) if ": " in policy else {}
        found |= {f"{slot}.{part}": name for part, name in parts.items()} or {slot: policy}
    return found


def changed_rules(a, b):
    """The slots, parts and paths of numbers in which two manifests differ; numbers of a policy that differs are not named."""
    here, there = policies(a), policies(b)
    rules = {rule for rule in here.keys() | there.keys() if here.get(rule) != there.get(rule)}
    x, y = numbers(a["params"]), numbers(b["params"])
    paths = {path.removeprefix("rules.") for path in x.keys() | y.keys() if x.get(path) != y.get(path)}
    return rules | {path for path in paths if not any(path.startswith(f"{rule}.") for rule in rules)}


class Ablations(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        for rules in ("paper", "released"):
            run_ok(
                PREDATOR_PREY,
                "--rules",
                rules,
                "--backend",
                "kinematic",
                "--duration",
                20,
                "--seed",
                3,
                "--out",
                cls.sets / rules,
            )

    def run_ok(self, *arguments):
        return super().run_ok(ABLATIONS, *arguments).stdout

    def listed(self, table):
        start = f"from_{table}/"
        lines = self.run_ok("--list").splitlines()
        return {line.split()[0].removeprefix(start): line for line in lines if line.startswith(start)}

    def differing(self):
        """Slots and numbers in which the manifests of both tables differ."""
        paper, released = (manifest(self.sets / table) for table in ("paper", "released"))
        return changed_rules(paper, released) - {"ecology.duration_s"}

    def sensor_swaps(self, towards):
        """The ablations that take one sensor of the other table."""
        return {f"sensor_{name}" for name in manifest(self.sets / towards)["rules"]["sensors"].split(" + ")}

    def test_every_difference_is_listed(self):
        differing = self.differing()
        self.assertGreater(len(differing), 20)
        for table in ("paper", "released"):
            with self.subTest(table=table):
                sensors = self.sensor_swaps("released" if table == "paper" else "paper")
                self.assertEqual(len(sensors), 3)
                self.assertEqual(set(self.listed(table)), differing | sensors | GROUPS | {"base", "brain_with_biases"})

    def changes(self, a, b):
        """The rules and numbers in which two manifests differ."""
        return changed_rules(a, b) - {"seed"}

    def assert_lived(self, run):
        """Robots died; every vacancy and each of the 30 bodies at the start had a birth."""
        kinds = collections.Counter(row["event"] for row in self.rows(run, "events.csv"))
        self.assertGreater(kinds["death"], 0, run)
        self.assertEqual(kinds["birth"], kinds["death"] + 30, run)

    def test_each_ablation_changes_the_rules_in_its_name_and_no_others(self):
        out = self.folder / "out"
        self.run_ok("--duration", 300, "--replicates", 1, "--jobs", 2, "--out", out)
        skipped = {
            "ecology.robot",
            "ecology.cpg_integration",
            "ecology.idle_control_steps",
            "physics.timestep_s",
            "physics.integrator",
        }
        for table, other in (("paper", "released"), ("released", "paper")):
            base = manifest(out / f"from_{table}/base/replicate-00")
            there = manifest(self.sets / other)
            swaps = set(self.listed(table)) - {"base"}
            self.assertEqual({path.name for path in (out / f"from_{table}").iterdir()}, swaps - skipped | {"base"})
            together = set()
            for swap in swaps - skipped:
                with self.subTest(table=table, swap=swap):
                    self.assert_lived(out / f"from_{table}" / swap / "replicate-00")
                    swapped = manifest(out / f"from_{table}" / swap / "replicate-00")
                    changed = self.changes(base, swapped)
                    if swap == "brain_with_biases":
                        self.assertEqual(changed, {"brain"})
                        self.assertEqual(swapped["rules"]["brain"], base["rules"]["brain"] + "_with_biases")
                        self.assertEqual(swapped["params"]["rules"]["brain"], base["params"]["rules"]["brain"])
                    elif swap.startswith("sensor_"):
                        self.assertEqual(changed, {"sensors"})
                        before, after = (one["rules"]["sensors"].split(" + ") for one in (base, swapped))
                        self.assertEqual(set(after) - set(before), {swap.removeprefix("sensor_")})
                        self.assertEqual(len(set(before) - set(after)), 1)
                    elif swap in GROUPS:
                        self.assertFalse(together & changed)
                        self.assertFalse(self.changes(swapped, there) & changed)
                        together |= changed
                    else:
                        self.assertEqual(changed, {swap})
                        self.assertNotIn(swap, self.changes(swapped, there))
            self.assertEqual(together, self.differing())

    def test_only_shadow_and_resume(self):
        out = self.folder / "out"
        options = ["--from", "paper", "--only", "base", "heredity", "--duration", 200, "--shadow", "--out", out]
        self.run_ok(*options, "--replicates", 2)
        self.assertEqual({path.name for path in out.iterdir()}, {"from_paper"})
        self.assertEqual({path.name for path in (out / "from_paper").iterdir()}, {"base", "heredity"})
        shadow = out / "from_paper/heredity/shadow/replicate-01"
        self.assertEqual(manifest(shadow)["rules"]["heredity"], "nothing_inherited")
        before = {file: (shadow / file).read_bytes() for file in TABLES}
        self.assert_refused(self.call(ABLATIONS, *options, "--replicates", 2), "never overwritten")

        removed = out / "from_paper/base/shadow/replicate-00"
        kept = {file: (removed / file).read_bytes() for file in TABLES}
        shutil.rmtree(removed)
        printed = self.run_ok(*options, "--replicates", 3, "--resume", "--jobs", 2)
        self.assertIn("3 of 3 replicates complete", printed)
        self.assertEqual(kept, {file: (removed / file).read_bytes() for file in TABLES})
        self.assertEqual(before, {file: (shadow / file).read_bytes() for file in TABLES})
        self.assertEqual(len(list((out / "from_paper/heredity").glob("replicate-*"))), 3)

    def test_refusals_and_skips(self):
        out = self.folder / "out"
        for arguments, part in [
            (["--only", "heresy", "--out", out], "heresy"),
            (["--only", "heredty", "--out", out], "did you mean heredity?"),
            (["--from", "text", "--out", out], "text"),
            (["--backend", "nope", "--out", out], "--backend nope"),
            ([], "out"),
            (["--replicates", 0, "--out", out], "replicates = 0"),
        ]:
            with self.subTest(arguments=arguments):
                self.assert_refused(self.call(ABLATIONS, *arguments), part)
        self.assertIn("ecology.robot: skipped", self.run_ok("--only", "ecology.robot", "--out", out))
        self.assertFalse(out.exists())

    def test_flip_table(self):
        out = self.folder / "out"
        self.run_ok(
            "--only",
            "base",
            "floor.floor",
            *sorted(GROUPS),
            "--duration",
            600,
            "--replicates",
            6,
            "--shadow",
            "--out",
            out,
        )
        super().run_ok(TROPHIC, "ablation-table", out, "--jobs", 2, "--out", "table")
        rows = self.rows("table/ablations.csv")
        self.assertEqual({row["direction"] for row in rows}, {"from_paper", "from_released", "paper_to_released"})
        self.assertEqual({row["swap"] for row in rows if row["direction"] == "from_paper"}, GROUPS | {"floor.floor"})
        for direction, family in itertools.product(("from_paper", "from_released"), ("over_shadow", "raw")):
            tested = [
                row for row in rows if row["direction"] == direction and row["compared"] == family and row["p_holm"]
            ]
            smallest = min(float(row["p"]) for row in tested)
            least = min(float(row["p_holm"]) for row in tested)
            self.assertAlmostEqual(least, min(1.0, smallest * len(tested)), delta=1e-9)
            for row in tested:
                self.assertEqual(row["significant"], "yes" if float(row["p_holm"]) <= 0.05 else "no")
        self.assertEqual([row["compared"] for row in rows], ["over_shadow", "raw"] * (len(rows) // 2))
        text = (self.folder / "table/ablations.md").read_text()
        for title in ("## from_paper", "## from_released", "## Together"):
            self.assertIn(title, text)

        (out / "from_paper/floor.floor/replicate-00/manifest.json").unlink()
        self.assert_refused(self.call(TROPHIC, "ablation-table", out, "--out", "broken"), "floor.floor")
        self.assertFalse((self.folder / "broken").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
