#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""kill_test.py PREDATOR_PREY [--long CASES] [unittest arguments]: programs that are killed or stopped and resume to the same bytes.

The quick part kills a few runs. scripts/kill-and-resume runs `--long 100`."""

import argparse
import filecmp
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

from in_folder import InFolder, said_by, sealed_text

PARSER = argparse.ArgumentParser()
PARSER.add_argument("program")
PARSER.add_argument("--long", type=int, default=3, help="how many runs are killed (3)")
PARSER.add_argument("--backend", default="kinematic")
PARSER.add_argument("--rules", default="released")
PARSER.add_argument("--duration", default="10000")
PARSER.add_argument("--checkpoint-s", default="50")
PARSER.add_argument("--set", action="append", default=[], dest="numbers", help="PATH=VALUE, as the program takes it")
OPTIONS, REST = PARSER.parse_known_args()
TABLES = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"]
STOPPED = 3


class Killed(InFolder):
    def command(self, out, seed, *arguments, duration=OPTIONS.duration):
        chosen = ["--backend", OPTIONS.backend, "--rules", OPTIONS.rules, "--duration", duration]
        chosen += [word for number in OPTIONS.numbers for word in ("--set", number)]
        if not (self.folder / out).exists():
            arguments = [word for word in arguments if word != "--resume"]
        return [
            OPTIONS.program,
            *chosen,
            "--seed",
            str(seed),
            "--checkpoint-s",
            OPTIONS.checkpoint_s,
            "--out",
            out,
            *arguments,
        ]

    def start(self, *command, preexec=None):
        return subprocess.Popen(
            command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=preexec
        )

    def finish(self, *command):
        return self.call(*command, timeout=3600)

    def finish_ok(self, *command):
        return self.run_ok(*command, timeout=3600)

    def assert_same(self, one, two):
        for table in TABLES:
            self.assertTrue(filecmp.cmp(self.folder / one / table, self.folder / two / table, shallow=False), table)
        for out in (one, two):
            self.assertEqual(self.manifest(out)["status"], "complete")
        self.assertEqual(self.manifest(one)["tables"], self.manifest(two)["tables"])
        self.assertEqual(self.manifest(one)["result"], self.manifest(two)["result"])

    def whole(self, seed):
        began = time.monotonic()
        self.finish_ok(*self.command("whole", seed))
        return time.monotonic() - began

    def test_kill_9(self):
        chance = random.Random(1)
        killed = 0
        for case in range(OPTIONS.long):
            seed = chance.randrange(1000)
            wall_s = self.whole(seed)
            done = None
            for _ in range(chance.choice([1, 1, 2, 10])):
                run = self.start(*self.command("parts", seed, "--resume"))
                try:
                    run.communicate(timeout=chance.uniform(0.0, wall_s))
                    done = run.returncode
                    break
                except subprocess.TimeoutExpired:
                    run.kill()
                    run.communicate()
                    killed += 1
            if done is None:
                done = self.finish(*self.command("parts", seed, "--resume")).returncode
            with self.subTest(case=case, seed=seed):
                self.assertEqual(done, 0)
                self.assert_same("whole", "parts")
            for out in self.folder.iterdir():
                shutil.rmtree(out)
        print(f"{OPTIONS.long} runs, killed {killed} times", file=sys.stderr)
        self.assertGreater(killed, 0)

    def test_killed_at_the_end_of_a_time_that_is_not_a_whole_number_of_ticks(self):
        """The last checkpoint is then later than the end, and the manifest still has the status of a running run."""
        for out in ("whole", "parts"):
            self.finish_ok(*self.command(out, 7, duration="301"))
        manifest = self.manifest("parts")
        manifest["status"] = "running"
        (self.folder / "parts/manifest.json").write_text(sealed_text(manifest))
        self.finish_ok(*self.command("parts", 7, "--resume", duration="301"))
        self.assert_same("whole", "parts")
        self.assertTrue(filecmp.cmp(self.folder / "whole/replay.trp", self.folder / "parts/replay.trp", shallow=False))
        self.finish_ok(*self.command("parts", 7, "--resume", duration="300"))  # complete, and longer

    def test_killed_before_a_set_is_listed(self):
        (self.folder / "set").mkdir()
        (self.folder / "set/replicates.json.part").write_text("{")
        self.finish_ok(*self.command("set", 7, "--replicates", "2", "--resume", duration="100"))
        self.assertEqual(
            sorted(path.name for path in (self.folder / "set").iterdir()),
            ["replicate-00", "replicate-01", "replicates.json"],
        )
        (self.folder / "mine").mkdir()
        (self.folder / "mine/notes.txt").write_text("mine")
        done = self.finish(*self.command("mine", 7, "--replicates", "2", "--resume", duration="100"))
        self.assert_refused(done, "only a folder of replicates can be resumed")

    def test_signals_stop_and_lose_nothing(self):
        self.whole(7)
        for number, signals in enumerate(
            [
                [signal.SIGINT],
                [signal.SIGTERM],
                [signal.SIGHUP],
                [signal.SIGXCPU],
                [signal.SIGUSR1],
                [signal.SIGUSR2],
                [signal.SIGINT] * 2,
                [signal.SIGTERM, signal.SIGINT],
            ]
        ):
            with self.subTest(signals=signals):
                out = f"parts{number}"
                run = self.start(*self.command(out, 7))
                self.wait_for(f"{out}/agents.csv", run)
                time.sleep(0.05)
                before = resource.getrusage(resource.RUSAGE_CHILDREN)
                for one in signals:
                    run.send_signal(one)
                printed, errors = run.communicate(timeout=60)
                after = resource.getrusage(resource.RUSAGE_CHILDREN)
                self.assertLess(
                    after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 5.0
                )  # the run's whole processor time
                self.assertEqual(run.returncode, STOPPED, errors)
                self.assertIn("stopping; finished work is kept", errors)
                self.assertIn(f"repeat the command with --resume --out {out}", printed)
                self.assertEqual(self.manifest(out)["status"], "stopped")
                again = self.finish_ok(*self.command(out, 7, "--resume"))
                self.assertIn("resumes from its checkpoint at", again.stdout)
                self.assert_same("whole", out)

    def started_and_kept(self, out, preexec=None):
        """Returns a run that has kept two checkpoints and is paused before it ends. `failed` continues it."""
        for _ in range(20):
            run = self.start(*self.command(out, 7), preexec=preexec)
            self.wait_for(f"{out}/checkpoint.old.bin", run)
            run.send_signal(signal.SIGSTOP)
            if run.poll() is None and self.manifest(out)["status"] != "complete":
                return run
            run.send_signal(signal.SIGCONT)
            run.communicate(timeout=60)
            shutil.rmtree(self.folder / out)
        return self.fail("each run ended before it was paused")

    def failed(self, run):
        run.send_signal(signal.SIGCONT)
        _, errors = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 1, errors)
        complaint, where = said_by(errors)
        self.assertIn(": cannot ", complaint)
        return where

    def test_a_folder_that_is_moved_during_the_run(self):
        self.whole(7)
        run = self.started_and_kept("here")
        (self.folder / "here").rename(self.folder / "there")
        self.assertEqual(self.failed(run), "the run's folder was removed or moved: here")
        self.assertNotEqual(self.manifest("there")["status"], "complete")
        again = self.finish(*self.command("there", 7, "--resume"))
        self.assertIn("resumes from its checkpoint at", again.stdout, again.stderr)
        self.assert_same("whole", "there")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["there", "whole"])

    def test_a_folder_that_becomes_read_only(self):
        nobody = 65534

        def become_nobody():
            os.setgid(nobody)
            os.setuid(nobody)

        preexec = None
        if os.geteuid() == 0:  # root may write to any folder
            preexec = become_nobody
            os.chown(self.folder, nobody, nobody)
            try:
                self.run_ok(OPTIONS.program, "--version", preexec_fn=preexec)
            except (AssertionError, OSError, subprocess.SubprocessError):
                self.skipTest("an unprivileged user may not run the program here")
        self.whole(7)
        run = self.started_and_kept("run", preexec)
        (self.folder / "run").chmod(0o555)
        self.assertEqual(self.failed(run), "all output so far is in run")
        (self.folder / "run").chmod(0o755)
        self.assertNotEqual(self.manifest("run")["status"], "complete")
        again = self.finish(*self.command("run", 7, "--resume"))
        self.assertIn("resumes from its checkpoint at", again.stdout, again.stderr)
        self.assert_same("whole", "run")

    def test_a_file_that_reaches_its_size_limit(self):
        self.whole(7)
        limit = (self.folder / "whole" / "agents.csv").stat().st_size // 2
        run = self.call(
            *self.command("run", 7),
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY)),
        )
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertRegex(
            "\n".join(said_by(run.stderr)), r"^[^\n]*agents.csv: File too large\nall output so far is in run$"
        )
        self.assertNotEqual(self.manifest("run")["status"], "complete")
        again = self.finish(*self.command("run", 7, "--resume"))
        self.assertIn("resumes from its checkpoint at", again.stdout, again.stderr)
        self.assert_same("whole", "run")

    def test_replicates_whose_output_pipe_is_closed(self):
        program = self.start(*self.command("set", 5, "--replicates", "4", "--jobs", "2"))
        program.stdout.close()
        errors = said_by(program.stderr.read())
        self.assertEqual(
            (program.wait(timeout=60), errors), (1, ["trophic-predator-prey: cannot write to standard output"])
        )
        for number in range(4):
            self.assertEqual(self.manifest(f"set/replicate-0{number}")["status"], "complete")

    def test_a_complete_run_is_left_as_it_is(self):
        self.whole(3)
        before = {path.name: path.read_bytes() for path in (self.folder / "whole").iterdir()}
        (self.folder / "whole/manifest.json.part").write_text("{")  # a kill as the program adds its speed
        self.assertIn("is complete already", self.finish_ok(*self.command("whole", 3, "--resume")).stdout)
        self.assertEqual({path.name: path.read_bytes() for path in (self.folder / "whole").iterdir()}, before)

    def test_two_programs_in_one_folder(self):
        first = self.start(*self.command("one", 3, duration="100000000"))
        self.wait_for("one/agents.csv", first)
        for arguments, code, text in [
            ((), 2, "exists already"),
            (("--resume",), 1, "another program is running in it"),
        ]:
            self.assert_refused(self.finish(*self.command("one", 3, *arguments, duration="100000000")), text, code=code)
        first.send_signal(signal.SIGTERM)
        first.communicate(timeout=60)
        self.assertEqual(first.returncode, STOPPED)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["one"])

    def test_replicates(self):
        common = self.command("set", 5, "--replicates", "3", "--jobs", "2")
        self.finish_ok(*self.command("whole", 5, "--replicates", "3", "--jobs", "2"))
        killed = self.start(*common)
        self.wait_for("set/replicate-00/checkpoint.bin", killed)
        killed.kill()
        killed.communicate()
        resumed = self.finish_ok(*common, "--resume")
        self.assertIn("replicate-00 resumes from its checkpoint at", resumed.stdout)
        for number in range(3):
            self.assert_same(f"whole/replicate-0{number}", f"set/replicate-0{number}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + REST)
