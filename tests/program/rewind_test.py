#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""rewind_test.py PREDATOR_PREY: runs that begin at a moment of another run."""

import json
import pathlib
import subprocess
import sys
import time
import unittest

from in_folder import InFolder, said_by

PROGRAM = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"]


class Rewind(InFolder):
    program = (PROGRAM,)

    def table(self, out, name):
        return (self.folder / out / name).read_text().splitlines()

    def setUp(self):
        super().setUp()
        self.run_ok(
            "--backend",
            "kinematic",
            "--seed",
            7,
            "--duration",
            1500,
            "--set",
            "rules.mutation.sd=0.02",
            "--out",
            "whole",
        )

    def until(self, out, name, time_s):
        rows = self.table(out, name)
        column = rows[0].split(",").index("time_s")
        return [row for row in rows[1:] if float(row.split(",")[column]) <= time_s]

    def test_the_same_seed_gives_the_same_run(self):
        for at in (0, 701, 1500):
            with self.subTest(at=at):
                self.run_ok("--from", "whole", "--at", at, "--duration", 1500, "--out", f"same{at}")
                for name in TABLES:
                    self.assertEqual(self.table("whole", name), self.table(f"same{at}", name), name)
                self.assertEqual(self.manifest("whole")["result"], self.manifest(f"same{at}")["result"])
                self.assertEqual(self.manifest(f"same{at}")["origin"]["seed"], "7")
        self.assertEqual(len(list(self.folder.iterdir())), 4)

    def test_another_seed_or_number_shares_the_past_alone(self):
        self.run_ok("--from", "whole", "--at", 700, "--duration", 1500, "--seed", 8, "--out", "seed")
        self.run_ok(
            "--from", "whole", "--at", 700, "--duration", 1500, "--set", "rules.mutation.sd=0.5", "--out", "number"
        )
        self.assertEqual(self.manifest("number")["params"]["rules"]["mutation"]["sd"], 0.5)
        self.assertEqual(self.manifest("seed")["params"]["rules"]["mutation"]["sd"], 0.02)
        self.assertEqual(self.manifest("seed")["seed"], 8)
        self.assertNotIn("continued", self.manifest("seed"))
        for out in ("seed", "number"):
            with self.subTest(out=out):
                origin = self.manifest(out)["origin"]
                self.assertEqual((origin["run"], origin["at_s"], origin["seed"]), ("whole", "700", "7"))
                self.assertEqual(origin["fingerprint"], self.manifest("whole")["fingerprint"])
                for name in ("events.csv", "agents.csv", "genomes.csv"):
                    self.assertEqual(self.until(out, name, 700), self.until("whole", name, 700))
                self.assertNotEqual(self.table(out, "genomes.csv"), self.table("whole", "genomes.csv"))
                births = sum(",birth," in row for row in self.table(out, "events.csv"))
                self.assertEqual(len(self.table(out, "phylogeny.csv")), births + 1)

    def test_numbers_that_cannot_change_on_the_way_are_refused_and_no_files_are_left(self):
        for arguments, text in [
            (["--at", 700, "--robots", 20], "ecology.robots = 20: must be 30"),
            (["--at", 700, "--set", "ecology.tick_s=1"], "ecology.tick_s = 1: must be 2"),
            (["--at", -1], "--at -1: must be >= 0"),
            (["--at", 2000], "--at 2000: must be <= 1500"),
            (["--at", 700, "--replicates", 2, "--robots", 20], "ecology.robots = 20: must be 30"),
            (["--at", 2000, "--replicates", 2], "--at 2000: must be <= 1500"),
        ]:
            with self.subTest(arguments=arguments):
                self.assert_refused(self.call("--from", "whole", "--duration", 1500, "--out", "new", *arguments), text)
        self.assertEqual(self.call("--at", 5).returncode, 2)
        self.assertEqual(self.call("--from", "nothing", "--out", "new").returncode, 2)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["whole"])

    def test_without_a_moment_the_last_checkpoint_is_taken_and_it_can_be_resumed(self):
        self.run_ok("--from", "whole", "--duration", 2500, "--seed", 9, "--out", "longer")
        self.assertEqual(self.manifest("longer")["origin"]["at_s"], "1500")
        self.assertEqual(self.manifest("longer")["description"]["name"], "paper (mutation.sd 0.02; from 1500 s)")
        again = self.run_ok("--from", "whole", "--duration", 2500, "--seed", 9, "--out", "longer", "--resume")
        self.assertIn("is complete already", again.stdout)

    def test_a_run_that_began_elsewhere_is_not_continued(self):
        begun = ["--from", "whole", "--duration", 1500, "--seed", 8, "--out", "seed"]
        self.run_ok(*begun, "--at", 701)
        self.run_ok(*begun, "--at", 701, "--resume")
        self.run_ok(
            "--backend",
            "kinematic",
            "--seed",
            8,
            "--duration",
            1000,
            "--set",
            "rules.mutation.sd=0.02",
            "--out",
            "alone",
        )
        tables = {out: self.table(out, "events.csv") for out in ("seed", "alone")}
        for arguments, text in [
            (
                [*begun, "--at", 900],
                "seed: its run starts at 702 s of whole; it can be resumed, but it cannot start at 900 s of whole",
            ),
            (["--from", "alone", *begun[2:], "--at", 701], "cannot start at 701 s of alone"),
            ([*begun[:-1], "alone", "--at", 701], "alone: its run starts at 0 s"),
        ]:
            with self.subTest(arguments=arguments):
                self.assert_refused(self.call(*arguments, "--resume"), text)
        self.assertEqual(tables, {out: self.table(out, "events.csv") for out in tables})
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["alone", "seed", "whole"])

    def test_a_gait_that_was_named_with_its_path(self):
        text = (ROOT / "models/gaits/spider_published.toml").read_text()
        (self.folder / "file.toml").write_text(text.replace('"spider_published"', '"its own name"'))
        self.run_ok(
            "--backend",
            "kinematic",
            "--seed",
            7,
            "--duration",
            40,
            "--set",
            "ecology.gait=file.toml",
            "--out",
            "walked",
        )
        self.assertEqual(self.manifest("walked")["params"]["ecology"]["gait"], "file.toml")
        self.run_ok("--from", "walked", "--at", 20, "--duration", 40, "--out", "again")
        self.assertEqual(self.table("again", "events.csv"), self.table("walked", "events.csv"))

    REPLICATES = ["--from", "whole", "--at", 700, "--duration", 1500, "--seed", 5, "--replicates", 3, "--jobs", 2]

    def assert_futures_of_700_s(self, out):
        """Every replicate is the run that begins there with the replicate's seed."""
        listed = json.loads((self.folder / out / "replicates.json").read_text())
        self.assertEqual(
            (listed["origin"]["run"], listed["origin"]["at_s"], listed["master_seed"]), ("whole", "700", 5)
        )
        for replicate in listed["replicates"]:
            alone = f"alone-{replicate['seed']}"
            if not (self.folder / alone).exists():
                self.run_ok(
                    "--from", "whole", "--at", 700, "--duration", 1500, "--seed", replicate["seed"], "--out", alone
                )
            folder = f"{out}/{replicate['folder']}"
            with self.subTest(folder=folder):
                for name in TABLES:
                    self.assertEqual(self.table(folder, name), self.table(alone, name), name)
                self.assertEqual(self.manifest(folder)["origin"], self.manifest(alone)["origin"])
                self.assertEqual(self.manifest(folder)["identity"], self.manifest(alone)["identity"])
                self.assertEqual(self.manifest(folder)["status"], "complete")
        self.assertFalse([*self.folder.glob("**/*.snapshot-*"), *self.folder.glob("**/*.part")])

    def test_replicates_are_futures_of_one_moment(self):
        self.run_ok(*self.REPLICATES, "--shadow", "--one-sided", "--out", "set")
        self.assert_futures_of_700_s("set")
        for null in ("shadow", "one_sided_prey", "one_sided_predator"):
            self.assertEqual(
                self.until(f"set/{null}/replicate-00", "genomes.csv", 700), self.until("whole", "genomes.csv", 700)
            )
            self.assertNotEqual(
                self.table(f"set/{null}/replicate-00", "genomes.csv"), self.table("set/replicate-00", "genomes.csv")
            )
        self.assertEqual(len({tuple(self.table(f"set/replicate-0{i}", "events.csv")) for i in range(3)}), 3)

        before = sorted(path.name for path in self.folder.iterdir())
        again = self.run_ok(*self.REPLICATES, "--shadow", "--one-sided", "--resume", "--out", "set")
        self.assertNotIn("the snapshot", again.stdout)
        self.assert_refused(self.call(*self.REPLICATES, "--out", "set"), "exists already")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), before)

    def test_replicates_resume_after_a_kill_and_only_from_their_moment(self):
        for delay_s in (0.05, 0.1, 0.2, 0.4):
            resume = ["--resume"] if (self.folder / "set").exists() else []
            program = subprocess.Popen(
                [PROGRAM, *map(str, [*self.REPLICATES, "--checkpoint-s", 0, *resume, "--out", "set"])],
                cwd=self.folder,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            time.sleep(delay_s)
            program.kill()
            program.wait()
        self.run_ok(*self.REPLICATES, "--resume", "--out", "set")
        self.assert_futures_of_700_s("set")

        for name in ("checkpoint.bin", "checkpoint.old.bin", "manifest.json"):
            (self.folder / "set/replicate-01" / name).unlink(missing_ok=True)
        again = self.run_ok(*self.REPLICATES, "--resume", "--out", "set")
        self.assertIn("making the snapshot, whole until 700 s", again.stdout)
        self.assertIn("kept as replicate-01.incomplete-1, run anew; begins at 700 s of whole", again.stdout)
        self.assert_futures_of_700_s("set")

        elsewhere = [900 if word == 700 else word for word in self.REPLICATES]
        self.assert_refused(self.call(*elsewhere, "--resume", "--out", "set"), "replicates.json: origin")

    def test_a_run_without_a_checkpoint_begins_at_its_moment_again(self):
        begun = ["--from", "whole", "--at", 700, "--duration", 1500, "--seed", 8, "--out", "seed"]
        self.run_ok(*begun)
        events = self.table("seed", "events.csv")
        for name in ("checkpoint.bin", "manifest.json"):
            (self.folder / "seed" / name).unlink()
        self.assertIn(
            "kept as seed.incomplete-1, run anew; begins at 700 s of whole", self.run_ok(*begun, "--resume").stdout
        )
        self.assertEqual(self.table("seed", "events.csv"), events)

    def test_an_interrupted_past_is_made_again(self):
        past = self.folder / f"new.snapshot-{self.manifest('whole')['fingerprint']}-seed-7-700-s"
        (past / "run").mkdir(parents=True)
        (past / "run" / "events.csv").write_text("a part")
        own = self.folder / "new.origin"
        own.mkdir()
        (own / "notes.txt").write_text("mine")
        self.run_ok("--from", "whole", "--at", 700, "--duration", 1500, "--seed", 7, "--out", "new")
        self.assertEqual(self.table("new", "events.csv"), self.table("whole", "events.csv"))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["new", "new.origin", "whole"])
        self.assertEqual((own / "notes.txt").read_text(), "mine")

    def test_several_programs_in_one_folder(self):
        """One uses the folder; the others leave it, and each other's past, alone."""
        self.run_ok("--from", "whole", "--at", 700, "--duration", 1500, "--seed", 5, "--out", "alone")
        for number, arguments in enumerate([[], ["--resume"], [], ["--resume"]]):
            out = f"new{number}"
            begun = [
                PROGRAM,
                "--from",
                "whole",
                "--at",
                "700",
                "--duration",
                "1500",
                "--seed",
                "5",
                *arguments,
                "--out",
                out,
            ]
            if arguments:  # resumed is what is there: a shorter run
                self.run_ok("--from", "whole", "--at", 700, "--duration", 900, "--seed", 5, "--out", out)
            pipes = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "text": True}
            programs = [subprocess.Popen(begun, cwd=self.folder, **pipes) for _ in range(4)]
            errors = ["\n".join(said_by(program.communicate(timeout=60)[1])) for program in programs]
            with self.subTest(arguments=arguments, errors=errors):
                for program, error in zip(programs, errors, strict=True):
                    self.assertEqual(program.returncode != 0, bool(error))
                    self.assertRegex(
                        error,
                        "^$|^[^\n]*(another program is running in it|exists already; runs are never overwritten)$",
                    )
                for name in TABLES:
                    self.assertEqual(self.table(out, name), self.table("alone", name), name)
                self.assertEqual(self.manifest(out)["status"], "complete")
                self.assertEqual([path.name for path in self.folder.glob("new*.*")], [])

    def test_a_run_in_the_way_is_not_changed(self):
        there = f"new.snapshot-{self.manifest('whole')['fingerprint']}-seed-7-700-s"
        (self.folder / "whole").rename(self.folder / there)
        events = self.table(there, "events.csv")
        for replicates in ([], ["--replicates", 2]):
            with self.subTest(replicates=replicates):
                self.assert_refused(
                    self.call("--from", there, "--at", 700, "--duration", 1500, *replicates, "--out", "new"),
                    f"{there}: must not exist",
                )
                self.assertEqual([path.name for path in self.folder.iterdir()], [there])
                self.assertEqual(self.table(there, "events.csv"), events)

    def test_a_slash_behind_the_folder_changes_nothing(self):
        for replicates in ([], ["--replicates", 2]):
            with self.subTest(replicates=replicates):
                begun = [
                    "--from",
                    "whole/",
                    "--at",
                    700,
                    "--duration",
                    1000,
                    *replicates,
                    "--out",
                    f"new{len(replicates)}/",
                ]
                self.run_ok(*begun)
                self.run_ok(*begun, "--resume")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["new0", "new2", "whole"])
        self.assertEqual(
            sorted(path.name for path in (self.folder / "new2").iterdir()),
            ["replicate-00", "replicate-01", "replicates.json"],
        )


if __name__ == "__main__":
    unittest.main()
