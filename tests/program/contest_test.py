#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""contest_test.py PREDATOR_PREY TROPHIC OWN_TABLE: contests and lineages across generations, from runs to tables, and what is refused."""

import functools
import json
import shutil
import sys
import unittest

import figures_python
from in_folder import InFolder, sealed_text

OWN_TABLE = sys.argv.pop(3)
TROPHIC = sys.argv.pop(2)
PREDATOR_PREY = sys.argv.pop(1)


class Contest(InFolder):
    def runs(self, name, *arguments, program=PREDATOR_PREY, duration=120, replicates=3):
        self.run_ok(
            program,
            "--backend",
            "kinematic",
            "--duration",
            duration,
            "--replicates",
            replicates,
            "--replay-hz",
            0,
            "--out",
            name,
            *arguments,
        )
        return name

    def contest(self, *arguments):
        return self.run_ok(TROPHIC, "contest", *arguments)

    def refused(self, *arguments, says, command=("contest",)):
        self.assert_refused(self.call(TROPHIC, *command, *arguments, "--out", "refused"), says)
        self.assertFalse((self.folder / "refused").exists())

    def test_recorded_contests_are_runs_that_last_as_long_as_until_all_are_reached(self):
        self.runs("study", replicates=2)
        few = ["--teams", 2, "--team-size", 4, "--reach", 2, "--duration", 100, "--epochs", "0,120"]
        self.contest("study", *few, "--record", "--jobs", 2, "--out", "recorded")
        self.contest("study", *few, "--out", "plain")
        self.assertEqual(self.rows("recorded/contests.csv"), self.rows("plain/contests.csv"))
        rows = self.rows("recorded/contests.csv")
        self.assertEqual(len(list((self.folder / "recorded").glob("contest-*"))), len(rows))
        alike = []
        for number, row in enumerate(rows):
            run = self.folder / f"recorded/contest-{number}"
            result = json.loads((run / "manifest.json").read_text())["result"]
            self.assertEqual(result["reached_s"] < 100, float(row["contacted"]) == 1 and float(row["contact_s"]) < 100)
            self.assertGreater((run / "replay.trp").stat().st_size, 1000)
            alike.append(
                [row["x_m"] for row in self.rows(f"recorded/contest-{number}/agents.csv") if row["tick"] == "0"]
            )
        self.assertEqual(alike[0], alike[2])  # hunters of two epochs, at the same places
        self.run_ok(TROPHIC, "show", "recorded/contest-0", "recorded/contest-2", "-o", "both.html")
        self.refused("study", "--record", "--epochs", "0,40,80,120", says="--record: 192 contests: must be <= 100")

    def test_every_pair_of_epochs_meets_in_runs_and_shadow_and_jobs_do_not_matter(self):
        self.runs("study", "--shadow")
        short = ["--duration", 150, "--reach", 3, "--against", "both", "--epochs", "0,60,120", "--team-size", 5]
        # A shadow is played as if it were real.
        self.contest(
            "study/shadow",
            "--shadow",
            self.runs("again", "--shadow", "--seed", 9) + "/shadow",
            *short[:4],
            "--out",
            "control",
        )
        self.assertEqual(
            {(row["shadow"], row["hunters_run"].split("/")[0]) for row in self.rows("control/contests.csv")},
            {("0", "study"), ("1", "again")},
        )
        done = self.contest("study", *short, "--out", "one", "--jobs", 1)
        self.assertIn("3 replicates: too few for intervals and tests, which need 6", done.stdout)
        rows = self.rows("one/contests.csv")
        self.assertEqual(len(rows), 2 * 2 * 3 * 6 * 9)  # shadow, against, replicates, teams, pairs
        for row in rows:
            self.assertTrue(0 <= float(row["contact_s"]) <= 150)
            self.assertEqual(row["against"] == "own", row["hunters_run"] == row["victims_run"])
            self.assertEqual(row["shadow"] == "1", "shadow" in row["hunters_run"])
        self.assertGreater(len({row["contact_s"] for row in rows}), 50)
        progress = self.rows("one/progress.csv")
        self.assertEqual(
            [(row["against"], row["species"], row["period"]) for row in progress],
            [
                (against, species, period)
                for against in ("own", "others")
                for period in ("early", "late")
                for species in ("predator", "prey")
            ],
        )
        self.assertTrue(all(row["over_shadow_s"] and not row["p_holm"] for row in progress))
        if figures_python.PYTHON:
            self.run_ok(TROPHIC, "plot", "one")
            for against in ("own", "others"):
                self.assertTrue(
                    (self.folder / f"one/figures/contests_predator_prey_{against}.png").stat().st_size > 10000
                )
        self.contest("study", *short, "--out", "two", "--jobs", 2)
        self.assertEqual(
            (self.folder / "one/contests.csv").read_bytes(), (self.folder / "two/contests.csv").read_bytes()
        )
        self.contest("study", "--panel", "again", *short[:4], "--team-size", 5, "--epochs", "0,120", "--out", "panel")
        rows, met = self.rows("panel/contests.csv"), {}
        self.assertEqual(len(rows), 2 * 2 * 3 * 6 * 2)  # shadow, role, replicates, teams, epochs
        for row in rows:
            theirs, ours = ("victim", "hunter") if row["against"] == "panel_victims" else ("hunter", "victim")
            self.assertEqual(
                (row[f"{theirs}s_run"].split("/")[0], row[f"{ours}s_run"].split("/")[0]), ("again", "study")
            )
            met.setdefault((row[f"{ours}s_run"][-2:], row["team"], ours), set()).add(
                (row[f"{theirs}s_run"], row[f"{theirs}_epoch_s"])
            )
        self.assertEqual(
            {len(opponents) for opponents in met.values()}, {1}
        )  # the same in all epochs, and in the shadow
        self.assertEqual(
            [(row["against"], row["species"]) for row in self.rows("panel/progress.csv")],
            [("panel", "predator"), ("panel", "prey")],
        )
        self.contest("study", *short, "--out", "other", "--seed", 2)
        self.assertNotEqual(
            (self.folder / "one/contests.csv").read_bytes(), (self.folder / "other/contests.csv").read_bytes()
        )

    def test_the_program_that_made_the_runs_plays_the_same_contests(self):
        self.runs("study", "--one-sided")
        short = ["study", "--duration", 40, "--team-size", 5, "--epochs", "0,120"]
        self.contest("study/one_sided_prey", *short[1:], "--out", "sided")
        self.assertEqual(len(self.rows("sided/contests.csv")), 3 * 6 * 4)
        self.assertIn("no shadow", self.contest(*short, "--out", "here").stdout)
        self.contest(*short, "--out", "there", "--program", PREDATOR_PREY)
        for table in ("contests.csv", "progress.csv"):
            self.assertEqual((self.folder / "here" / table).read_bytes(), (self.folder / "there" / table).read_bytes())
        self.assertEqual(
            sorted(path.name for path in (self.folder / "there").iterdir()), ["contests.csv", "progress.csv"]
        )

    def test_runs_of_a_table_of_ones_own_need_their_program(self):
        self.runs("mine", program=OWN_TABLE)
        self.refused(
            "mine",
            says="rule table ageing: must be paper or released, those of this program; --program names the one that made the runs",
        )
        self.contest(
            "mine", "--program", OWN_TABLE, "--duration", 20, "--team-size", 3, "--epochs", "0,120", "--out", "contests"
        )
        self.assertEqual(len(self.rows("contests/contests.csv")), 3 * 6 * 4)

    def test_lineages_have_a_shadow_and_drift_and_say_what_they_lack(self):
        self.runs("study", "--shadow", "--senses")
        lineages = ("analyze", "--lineages")
        done = self.run_ok(
            TROPHIC, *lineages, "study", "--window", 20, "--all", "--html", "page.html", "--out", "measured"
        )
        for words in ("modes_novelty prey", "activity_excess predator", "descent_roots prey", "= drift", "= shadow"):
            self.assertIn(words, done.stdout)
        self.assertIn("descent_roots", (self.folder / "page.html").read_text())
        rows = [row for row in self.rows("measured/metrics.csv") if not row["time_s"]]
        self.assertEqual(len(rows), 3 * 2 * 23 * 3)  # runs, species, measures; own, drift, shadow
        self.assertEqual({row["baseline"] for row in rows}, {"", "drift", "shadow"})
        self.run_ok(TROPHIC, *lineages, "study", "--window", 20, "--jobs", 2, "--out", "again")
        self.assertEqual(*((self.folder / name / "metrics.csv").read_bytes() for name in ("measured", "again")))
        refused = functools.partial(self.refused, command=lineages)
        refused("study", "--window", 31, says="--window 31: must be > 0 and <= 30, a quarter of the shortest run")
        refused("study", "--until", 60, says="--lineages: not with")
        refused("study", "--metric", "velocity", says="velocity")
        self.runs("shared", "--rules", "released", "--senses")
        refused("shared", says="rule heredity = shared_copy: must give each individual its own genome")
        self.runs("mine", "--senses", program=OWN_TABLE)
        refused(
            "mine",
            says="rule table ageing: must be paper or released, those of this program; --program names the one that made the runs",
        )
        self.run_ok(TROPHIC, *lineages, "mine", "--program", OWN_TABLE, "--out", "ageing")
        first = self.folder / "study/replicate-00"
        (first / "senses.csv").unlink()
        refused("study", says="senses.csv: is missing")
        (first / "genomes.csv").unlink()
        refused("study", says="genomes.csv: is missing")
        self.runs("blind")
        refused("blind", says="senses.csv: is missing; lineage measures need it from the first run: run with --senses")

    def test_what_runs_cannot_give_is_refused_in_a_sentence(self):
        self.runs("study")
        first = self.folder / "study/replicate-00"
        self.refused("nowhere", says="nowhere")
        self.refused("study", "--epochs", "0,500", says="the run reached 120 s: must be >= 500 s, an epoch")
        self.refused("study", "--epochs", "60", says="--epochs: 1 epochs: must be at least 2")
        self.refused("study", "--epochs", "60,0", says="--epochs 0: must be > 60, the epoch before it")
        self.refused("study", "--epochs", "0,x", says="--epochs 0,x: must be comma-separated times in seconds")
        self.refused("study", "--split", 7, says="--split 7: must be one of the epochs, 0, 40, 80, 120 s")
        self.refused("study", "--teams", 1, says="--teams 1: must be >= 2")
        self.refused("study", "--duration", 0, says="--duration 0: must be > 0")
        self.refused("study", "--reach", -1, says="--reach -1: must be > 0")
        self.refused("study", "--jobs", 0, says="--jobs 0: must be >= 1")
        self.refused(first, says="--against others: needs at least two replicates")
        self.refused("study", "--program", "no-such-program", says="no-such-program: is not on the PATH")
        self.runs("other", "--set", "rules.mutation.sd=0.1")
        self.refused("study", "other", says="runs with different rules or parameters are not pooled")
        self.refused("study", "--shadow", "other", says="other")
        self.refused(
            "study",
            "--panel",
            self.runs("released", "--rules", "released"),
            says="--panel released: has runs of released: must have runs of paper",
        )
        shutil.move(first / "genomes.csv", self.folder / "genomes.csv")
        self.refused("study", says="genomes.csv")
        shutil.copy(self.folder / "genomes.csv", first / "genomes.csv")
        with open(first / "genomes.csv", "a", encoding="utf-8") as file:
            file.write("1,2")
        self.refused("study", says="genomes.csv")
        shutil.move(self.folder / "genomes.csv", first / "genomes.csv")
        for path in (self.folder / "other").glob("replicate-*/manifest.json"):
            path.write_text(
                sealed_text(
                    json.loads(path.read_text().replace('"backend": {', '"backend": {"stepping": "screening",'))
                )
            )
        self.refused(
            "study",
            "--panel",
            "other",
            says="other: has runs of paper with backend.stepping = screening: must have runs of paper",
        )
        for path in (self.folder / "study").glob("replicate-*/manifest.json"):
            path.write_text(sealed_text({**json.loads(path.read_text()), "food_web": []}))
        self.refused("study", says="this food web has no hunting species; a contest needs hunters and victims")


if __name__ == "__main__":
    unittest.main()
