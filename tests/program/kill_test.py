#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""kill_test.py PREDATOR_PREY [--long CASES] [unittest arguments]: programs that are killed or stopped and resume to the same bytes.

The quick part kills a few runs. scripts/kill-and-resume runs `--long 100`."""

import argparse
import filecmp
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

from in_folder import InFolder, sealed_text

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
        return [OPTIONS.program, *chosen, "--seed", str(seed), "--checkpoint-s", OPTIONS.checkpoint_s, "--out", out, *arguments]

    def start(self, *command, preexec=None):
        return subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=preexec)

    def finish(self, *command):
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=3600)

    def manifest(self, out):
        return json.loads((self.folder / out / "manifest.json").read_text())

    def assert_same(self, one, two):
        for table in TABLES:
            self.assertTrue(filecmp.cmp(self.folder / one / table, self.folder / two / table, shallow=False), table)
        for out in (one, two):
            self.assertEqual(self.manifest(out)["status"], "complete")
        self.assertEqual(self.manifest(one)["tables"], self.manifest(two)["tables"])
        self.assertEqual(self.manifest(one)["result"], self.manifest(two)["result"])

    def whole(self, seed):
        began = time.monotonic()
        done = self.finish(*self.command("whole", seed))
        self.assertEqual(done.returncode, 0, done.stderr)
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
                subprocess.run(["rm", "-r", out], check=True)
        print(f"{OPTIONS.long} runs, killed {killed} times", file=sys.stderr)
        self.assertGreater(killed, 0)

    def test_killed_at_the_end_of_a_time_that_is_not_a_whole_number_of_ticks(self):
        """The last checkpoint is then later than the end, and the manifest still has the status of a running run."""
        self.assertEqual(self.finish(*self.command("whole", 7, duration="301")).returncode, 0)
        self.assertEqual(self.finish(*self.command("parts", 7, duration="301")).returncode, 0)
        manifest = self.manifest("parts")
        manifest["status"] = "running"
        (self.folder / "parts/manifest.json").write_text(sealed_text(manifest))
        again = self.finish(*self.command("parts", 7, "--resume", duration="301"))
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assert_same("whole", "parts")
        self.assertTrue(filecmp.cmp(self.folder / "whole/replay.trp", self.folder / "parts/replay.trp", shallow=False))
        shorter = self.finish(*self.command("parts", 7, "--resume", duration="300"))
        self.assertEqual(shorter.returncode, 0, shorter.stderr)  # complete, and longer

    def test_killed_before_a_set_is_listed(self):
        (self.folder / "set").mkdir()
        (self.folder / "set/replicates.json.part").write_text("{")
        done = self.finish(*self.command("set", 7, "--replicates", "2", "--resume", duration="100"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(path.name for path in (self.folder / "set").iterdir()), ["replicate-00", "replicate-01", "replicates.json"])
        (self.folder / "mine").mkdir()
        (self.folder / "mine/notes.txt").write_text("mine")
        done = self.finish(*self.command("mine", 7, "--replicates", "2", "--resume", duration="100"))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("only a folder of replicates can be resumed", done.stderr)

    def test_signals_stop_within_a_second_and_lose_nothing(self):
        self.whole(7)
        for number, signals in enumerate([[signal.SIGINT], [signal.SIGTERM], [signal.SIGHUP], [signal.SIGXCPU], [signal.SIGUSR1], [signal.SIGUSR2], [signal.SIGINT] * 2, [signal.SIGTERM, signal.SIGINT]]):
            with self.subTest(signals=signals):
                out = f"parts{number}"
                run = self.start(*self.command(out, 7))
                while not (self.folder / out / "agents.csv").exists():
                    time.sleep(0.005)
                time.sleep(0.05)
                began = time.monotonic()
                for one in signals:
                    run.send_signal(one)
                printed, errors = run.communicate(timeout=60)
                self.assertLess(time.monotonic() - began, 5.0)
                self.assertEqual(run.returncode, STOPPED, errors)
                self.assertIn("stopping: finished work is kept", errors)
                self.assertIn(f"--resume --out {out} resumes it", printed)
                self.assertEqual(self.manifest(out)["status"], "stopped")
                again = self.finish(*self.command(out, 7, "--resume"))
                self.assertEqual(again.returncode, 0, again.stderr)
                self.assertIn("continues from its checkpoint at", again.stdout)
                self.assert_same("whole", out)

    def started_and_kept(self, out, preexec=None):
        """Returns a run that has kept two checkpoints and is paused before it ends. `failed` continues it."""
        for _ in range(20):
            run = self.start(*self.command(out, 7), preexec=preexec)
            while not (self.folder / out / "checkpoint.old.bin").exists() and run.poll() is None:
                time.sleep(0.001)
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
        complaint, where = errors.splitlines()
        self.assertIn(": cannot ", complaint)
        return where

    def test_a_folder_that_is_moved_during_the_run(self):
        self.whole(7)
        run = self.started_and_kept("here")
        (self.folder / "here").rename(self.folder / "there")
        self.assertEqual(self.failed(run), "its folder was removed or moved: here")
        self.assertNotEqual(self.manifest("there")["status"], "complete")
        again = self.finish(*self.command("there", 7, "--resume"))
        self.assertIn("continues from its checkpoint at", again.stdout, again.stderr)
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
                subprocess.run([OPTIONS.program, "--version"], cwd=self.folder, preexec_fn=preexec, capture_output=True, check=True)
            except (OSError, subprocess.SubprocessError):
                self.skipTest("an unprivileged user may not run the program here")
        self.whole(7)
        run = self.started_and_kept("run", preexec)
        (self.folder / "run").chmod(0o555)
        self.assertEqual(self.failed(run), "everything written so far is in run")
        (self.folder / "run").chmod(0o755)
        self.assertNotEqual(self.manifest("run")["status"], "complete")
        again = self.finish(*self.command("run", 7, "--resume"))
        self.assertIn("continues from its checkpoint at", again.stdout, again.stderr)
        self.assert_same("whole", "run")

    def test_a_file_that_reaches_its_size_limit(self):
        self.whole(7)
        limit = (self.folder / "whole" / "agents.csv").stat().st_size // 2
        run = subprocess.run(self.command("run", 7), cwd=self.folder, capture_output=True, text=True, timeout=60,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY)))
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertRegex(run.stderr, r"^[^\n]*agents.csv: File too large\neverything written so far is in run\n$")
        self.assertNotEqual(self.manifest("run")["status"], "complete")
        again = self.finish(*self.command("run", 7, "--resume"))
        self.assertIn("continues from its checkpoint at", again.stdout, again.stderr)
        self.assert_same("whole", "run")

    def test_replicates_whose_output_pipe_is_closed(self):
        program = self.start(*self.command("set", 5, "--replicates", "4", "--jobs", "2"))
        program.stdout.close()
        errors = program.stderr.read()
        self.assertEqual((program.wait(timeout=60), errors), (1, "trophic-predator-prey: cannot write to standard output\n"))
        for number in range(4):
            self.assertEqual(self.manifest(f"set/replicate-0{number}")["status"], "complete")

    def test_a_complete_run_is_left_as_it_is(self):
        self.whole(3)
        before = {path.name: path.read_bytes() for path in (self.folder / "whole").iterdir()}
        (self.folder / "whole/manifest.json.part").write_text("{")  # a kill as the program adds its speed
        again = self.finish(*self.command("whole", 3, "--resume"))
        self.assertEqual(again.returncode, 0)
        self.assertIn("is complete already", again.stdout)
        self.assertEqual({path.name: path.read_bytes() for path in (self.folder / "whole").iterdir()}, before)

    def test_two_programs_in_one_folder(self):
        first = self.start(*self.command("one", 3, duration="100000000"))
        while not (self.folder / "one" / "agents.csv").exists():
            time.sleep(0.005)
        for arguments, code, text in [((), 2, "exists already"), (("--resume",), 1, "another program is running in it")]:
            second = self.finish(*self.command("one", 3, *arguments, duration="100000000"))
            self.assertEqual((second.returncode, text in second.stderr), (code, True), second.stderr)
        first.send_signal(signal.SIGTERM)
        first.communicate(timeout=60)
        self.assertEqual(first.returncode, STOPPED)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["one"])

    def test_replicates(self):
        common = self.command("set", 5, "--replicates", "3", "--jobs", "2")
        self.assertEqual(self.finish(*self.command("whole", 5, "--replicates", "3", "--jobs", "2")).returncode, 0)
        killed = self.start(*common)
        while not (self.folder / "set/replicate-00/checkpoint.bin").exists() and killed.poll() is None:
            time.sleep(0.002)
        killed.kill()
        killed.communicate()
        resumed = self.finish(*common, "--resume")
        self.assertEqual(resumed.returncode, 0, resumed.stderr)
        self.assertIn("replicate-00 continues from its checkpoint at", resumed.stdout)
        for number in range(3):
            self.assert_same(f"whole/replicate-0{number}", f"set/replicate-0{number}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + REST)
