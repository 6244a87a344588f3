#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""cite_test.py TROPHIC PREDATOR_PREY: `trophic cite` gives what a paper needs of a run, and README, CITATION.cff and it make one request."""

import pathlib
import re
import shutil
import sys
import unittest

import figures_python
from in_folder import InFolder

if figures_python.PYTHON is None:
    print("no Python with pandas")
    sys.exit(77)

PREDATOR_PREY = sys.argv.pop(2)
TROPHIC = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parents[2]
OF_AN_OLDER_PROGRAM = """import sys, trophic
for folder in sys.argv[1:]:
    run = trophic.read_run(folder)
    del run.manifest["identity"], run.manifest["description"]
    print(run.identity)"""
REQUEST = "If you use trophic, please cite it and the experiment that it reproduces [kachler2023]."


class Cite(InFolder):
    def make(self, *options):
        self.run_ok(PREDATOR_PREY, "--backend", "kinematic", "--duration", 20, *options)

    @staticmethod
    def revision_of(manifest):
        """trophic's own, if the program that made the run knows it."""
        if "trophic_revision" in manifest:
            return f"revision {manifest['trophic_revision']}"
        return f"program of revision {manifest['source_revision']}"

    def cited(self, run):
        done = self.run_ok(TROPHIC, "cite", run)
        self.assertEqual(done.stderr, "")
        sentence, entries = done.stdout.split("\n\n", 1)
        return sentence, entries

    def test_the_sentence_has_table_engine_version_fingerprint_seed_and_numbers_that_changed(self):
        self.make("--seed", 7, "--set", "rules.mutation.sd=0.125", "--out", "run")
        manifest = self.manifest("run")
        sentence, entries = self.cited("run")
        self.assertEqual(
            sentence,
            f"A run of 20 s on kinematic 1 in trophic {manifest['trophic']} "
            f"({self.revision_of(manifest)}, fingerprint {manifest['fingerprint']}, seed 7), "
            "with the rule table `paper` and rules.mutation.sd = 0.125 (the table's: 0.05).",
        )
        self.assertEqual(manifest["identity"], manifest["fingerprint"])
        its = f", revision {manifest['trophic_revision']}" if "trophic_revision" in manifest else ""
        self.assertIn(f"note = {{Software, version {manifest['trophic']}{its}}}", entries)

    def test_changes_during_the_run_and_its_branch_are_said(self):
        (self.folder / "changes.csv").write_text(
            "time_s,number,value\n8,rules.capture.reach_m,0.5\n12,rules.mutation.sd,0.05\n"
        )
        self.make("--replicates", 2, "--changes", "changes.csv", "--out", "changed")
        self.make("--out", "plain")
        self.make("--from", "plain", "--at", 10, "--seed", 2, "--out", "branch")
        changed, also, plain, branch = map(
            self.manifest, ("changed/replicate-00", "changed/replicate-01", "plain", "branch")
        )
        self.assertEqual({one["fingerprint"] for one in (changed, also, plain, branch)}, {plain["identity"]})
        self.assertEqual(changed["identity"], also["identity"])
        self.assertEqual(len({changed["identity"], plain["identity"], branch["identity"]}), 3)
        self.assertEqual(changed["description"]["name"], "paper (capture.reach_m 0.5 at 8 s)")
        for run, manifest, words in (
            ("changed", changed, "; at 8 s rules.capture.reach_m changes from 1 to 0.5."),
            ("branch", branch, "; begins at 10 s of plain (seed 1)."),
        ):
            sentence, _ = self.cited(run)
            self.assertIn(f"fingerprint {manifest['identity']}, ", sentence)
            self.assertTrue(sentence.endswith(f"with the rule table `paper` and its parameters{words}"), sentence)
        one = self.call(
            figures_python.PYTHON,
            "-c",
            OF_AN_OLDER_PROGRAM,
            self.folder / "changed/replicate-00",
            self.folder / "branch",
            cwd=ROOT / "tools/python",
        )
        self.assertEqual((one.stderr, one.stdout.split()), ("", [changed["identity"], branch["identity"]]))

    def test_readme_citation_file_and_program_make_the_same_request(self):
        self.make("--out", "run")
        _, entries = self.cited("run")
        plain = re.sub(r", revision [^}]*", "", entries).strip()
        readme = (ROOT / "README.md").read_text()
        self.assertIn(plain, readme)
        for text in (readme, (ROOT / "docs/how-to/into-a-paper.md").read_text()):
            self.assertEqual(text.count(REQUEST), 1)
        citation = (ROOT / "CITATION.cff").read_text()
        self.assertIn(f"message: {REQUEST}\n", citation)
        title = re.search(r'^title: "(.*)"$', citation, re.M)[1]
        preferred = citation[citation.index("preferred-citation:") : citation.index("\nreferences:")]
        self.assertIn(f'  title: "{title}"', preferred)
        self.assertIn(f"title = {{{title}}}", entries)
        for field in ("version", "license"):
            self.assertIn("  " + re.search(rf"^{field}: .*$", citation, re.M)[0], preferred)
        self.assertIn("  year: " + re.search(r"year = {(\d+)}", entries)[1], preferred)

    def test_the_entries_are_read_by_bibtex(self):
        if not (shutil.which("bibtex") and shutil.which("pdflatex")):
            self.skipTest("no bibtex")
        self.make("--out", "run")
        (self.folder / "runs.bib").write_text(self.cited("run")[1])
        (self.folder / "paper.tex").write_text(
            "\\documentclass{article}\\begin{document}\\cite{trophic,kachler2023}\n"
            "\\bibliographystyle{plain}\\bibliography{runs}\\end{document}\n"
        )
        self.run_ok("pdflatex", "-interaction=batchmode", "paper")
        done = self.run_ok("bibtex", "paper")
        self.assertNotIn("Warning", done.stdout)
        self.assertEqual((self.folder / "paper.bbl").read_text().count("\\bibitem"), 2)


if __name__ == "__main__":
    unittest.main()
