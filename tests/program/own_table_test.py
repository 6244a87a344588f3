#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""own_table_test.py PROGRAM: a program of one file, linked with no engine, has every option of predator_prey."""

import pathlib
import re
import sys
import unittest

from in_folder import InFolder, planned

PROGRAM = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parents[2]
AGEING = "ageing"


class OwnTable(InFolder):
    program = (PROGRAM,)

    def call_ok(self, *arguments):
        return self.run_ok(*arguments).stdout

    def test_help_names_both_tables_and_every_option(self):
        text = self.call_ok("--help")
        self.assertIn(f"rule table: {AGEING} or paper (default: {AGEING})", text)
        for option in (
            "rules",
            "backend",
            "seed",
            "duration",
            "robots",
            "robot",
            "threads",
            "replicates",
            "jobs",
            "resume",
            "shadow",
            "one-sided",
            "config",
            "set",
            "out",
            "replay-hz",
            "agents-every",
            "senses",
            "states",
            "save-mjcf",
            "print-config",
            "print-table",
            "version",
        ):
            self.assertIn(f"--{option} ", text)

    def test_the_first_table_is_the_default_and_its_numbers_are_listed(self):
        printed = self.call_ok("--backend", "kinematic", "--print-config")
        self.assertIn(f"rule_table = '{AGEING}'", printed)
        self.assertIn("[rules.senescence]\nmax_age_s = ", printed)
        self.assertNotIn(
            "[rules.senescence]", self.call_ok("--backend", "kinematic", "--rules", "paper", "--print-config")
        )

    def test_its_rules_are_printed_as_a_table_with_the_numbers_that_are_set(self):
        options = ["--backend", "kinematic", "--set", "rules.senescence.max_age_s=1234"]
        rows = [line for line in self.call_ok(*options, "--print-table").splitlines() if "| senescence |" in line]
        self.assertEqual(len(rows), 1)
        self.assertIn("old\\_age | max\\_age\\_s = 1234", rows[0])
        changed = self.call_ok(*options, "--print-table", "--set", "ecology.robots=17")
        self.assertIn("robots = 17", next(line for line in changed.splitlines() if line.startswith("| ecology |")))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_robots_of_a_run_die_of_old_age(self):
        self.call_ok(
            "--backend", "kinematic", "--set", "rules.senescence.max_age_s=50", "--duration", 200, "--out", "run"
        )
        manifest = self.manifest("run")
        self.assertEqual((manifest["status"], manifest["rule_table"]), ("complete", AGEING))
        self.assertGreater(manifest["result"]["senescence"], 30)

    def test_replicates_with_their_shadow(self):
        self.call_ok("--backend", "kinematic", "--duration", 100, "--replicates", 2, "--shadow", "--out", "set")
        for run in ("replicate-00", "replicate-01", "shadow/replicate-00", "shadow/replicate-01"):
            manifest = self.manifest("set", run)
            self.assertEqual(manifest["rules"]["senescence"], "old_age")
            self.assertEqual(manifest["rules"]["heredity"], "nothing_inherited" if "shadow" in run else "own_copy")

    def test_version_names_the_backends(self):
        lines = dict(line.split(None, 1) for line in self.call_ok("--version").splitlines())
        self.assertEqual(set(lines), {"trophic", "revision", "source", "code", "compiler", "build", "backends"})
        version = re.search(r'version = "([\d.]+)"', (ROOT / "include/trophic/support/version.hpp").read_text())[1]
        self.assertEqual((lines["trophic"], lines["backends"].split(",")[0]), (version, "kinematic 1"))
        self.assertRegex(lines["compiler"], r"^(g|clang)\+\+ \d+")
        self.call_ok("--backend", "kinematic", "--duration", 10, "--out", "run")
        manifest = self.manifest("run")
        keys = {"revision": "trophic_revision", "source": "source_revision", "build": "build"}
        self.assertEqual({name: lines[name] for name in keys}, {name: manifest[key] for name, key in keys.items()})

    def test_its_own_csv_table_is_in_every_run(self):
        options = ["--backend", "kinematic", "--duration", 100, "--replicates", 2, "--shadow"]
        self.call_ok(*options, "--out", "set")
        texts = []
        for run in ("replicate-00", "replicate-01", "shadow/replicate-00", "shadow/replicate-01"):
            lines = (self.folder / "set" / run / "crowd.csv").read_text().splitlines()
            self.assertEqual((lines[0], len(lines)), ("time_s,close", 1 + 51))
            manifest = self.manifest("set", run)
            self.assertEqual(manifest["tables"]["crowd.csv"]["rows"], 51)
            texts.append(lines)
        self.assertNotEqual(texts[0], texts[1])
        (self.folder / "sweep.toml").write_text(
            "replicates = 1\n[set]\nengine = 'kinematic'\necology.duration_s = 60.0\n[grid]\necology.robots = [20, 30]\n"
        )
        self.call_ok(*planned(PROGRAM, "sweep.toml", "sweep", self.folder)[1:])
        self.assertEqual(len(list((self.folder / "sweep").glob("cell-*/replicate-00/crowd.csv"))), 2)

    def test_a_resumed_run_continues_its_own_csv_table(self):
        options = ["--backend", "kinematic", "--seed", 5]
        self.call_ok(*options, "--duration", 100, "--out", "whole")
        self.call_ok(*options, "--duration", 40, "--out", "first")
        self.call_ok(*options, "--duration", 100, "--from", "first", "--at", 40, "--out", "rest")
        self.assertEqual((self.folder / "whole/crowd.csv").read_text(), (self.folder / "rest/crowd.csv").read_text())


if __name__ == "__main__":
    unittest.main()
