#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""options_test.py PREDATOR_PREY TROPHIC [--all]: every option of every command, with texts that no user would mean.

Each is refused in one line that leaves nothing behind, or does its work; nothing crashes, hangs or takes all memory. Options are
those that --help lists. A command takes at most 1 GiB of memory and 20 s of processor time. With --all many more texts."""

import os
import re
import resource
import shutil
import subprocess
import sys
import unittest

from in_folder import InFolderWithSets, run_ok, said_by

PREDATOR_PREY, TROPHIC = (sys.argv.pop(1) for _ in range(2))
ALL = "--all" in sys.argv
if ALL:
    sys.argv.remove("--all")
MOST_BYTES, MOST_S, STOPPED = 1 << 30, 20, 3
AMOUNTS = {
    "--duration",
    "--generations",
    "--replicates",
    "--robots",
}  # of work that is asked for: SIGXCPU stops it, and --resume continues
TEXTS = ["", "-1", "nan", "18446744073709551616", "a\nb"]
MORE_TEXTS = [
    "0",
    "-0",
    "010",
    "0x10",
    "+5",
    " 5",
    "5 ",
    "1,5",
    "1_000",
    "1.5",
    "1e3",
    "1e300",
    "1e999",
    "inf",
    "-inf",
    "4294967296",
]
MORE_TEXTS += [
    "99999999999",
    "99999999999999999999",
    "9223372036854775807",
    "1e-300",
    "1000000",
    "٣",
    "--",
    "\x01",
    "\x1b[2J",
    "a" * 100_000,
    "/",
    ".",
    "/dev/null",
    "/dev/full",
    "no/such/place",
]

WITHOUT_VALUES = ("cite", "help")  # they have words alone

COMMANDS = {
    "": [PREDATOR_PREY, "--backend", "kinematic", "--duration", "20", "--out", "new"],
    "replicates": [PREDATOR_PREY, "--backend", "kinematic", "--duration", "20", "--out", "new", "--replicates", "2"],
    "branch": [PREDATOR_PREY, "--from", "run", "--at", "20", "--duration", "40", "--out", "new"],
    "analyze": [TROPHIC, "analyze", "run"],
    "evolve-gait": [TROPHIC, "evolve-gait", "--generations", "1", "--backend", "kinematic"],
    "measure-gait": [TROPHIC, "measure-gait", "--duration", "5.1"],
    "contest": [
        TROPHIC,
        "contest",
        "set",
        "--epochs",
        "0,40",
        "--duration",
        "10",
        "--teams",
        "2",
        "--team-size",
        "2",
        "--out",
        "new",
    ],
    "convert": [TROPHIC, "convert", "body.txt", "--out", "new.toml"],
    "plot": [TROPHIC, "plot", "run"],
    "cite": [TROPHIC, "cite", "run"],
    "help": [TROPHIC, "help"],
    "show": [TROPHIC, "show", "run"],
    "film": [TROPHIC, "film", "run", "--out", "new.png"],
    "export": [TROPHIC, "export", "run", "--out", "new.glb"],
}


def limits():
    resource.setrlimit(resource.RLIMIT_AS, (4 * MOST_BYTES, 4 * MOST_BYTES))  # addresses; pages are counted at the end
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_S, MOST_S + 5))  # SIGXCPU, then SIGKILL


def options_of(command):
    """The options that take a value, as --help lists them."""
    program = command[:2] if command[0] == TROPHIC else command[:1]
    text = run_ok(*program, "--help").stdout
    return re.findall(r"^  (?:-\w,)?(--[a-z-]+) (?:N|X|TEXT)\b", text, re.M)


def without(command, option):
    if option not in command:
        return command
    at = command.index(option)
    return command[:at] + command[at + 2 :]


class Options(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        run = [PREDATOR_PREY, "--backend", "kinematic", "--duration", "60", "--out"]
        for out in (["run"], ["set", "--replicates", "2"]):
            run_ok(*run, *out, cwd=cls.sets)

    def setUp(self):
        super().setUp()
        for name in ("run", "set"):
            shutil.copytree(self.sets / name, self.folder / name)
        (self.folder / "body.txt").write_text("0 CoreComponent Core 0\n\t0 ActiveHinge Hip 1\n")

    def files(self):
        return {path.relative_to(self.folder) for path in self.folder.rglob("*")}

    def try_out(self, command, option, text):
        before = self.files()
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(
            [*command, option, text], cwd=self.folder, capture_output=True, timeout=600, preexec_fn=limits
        )
        now = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.ends[done.returncode] = self.ends.get(done.returncode, 0) + 1
        self.longest_s = max(self.longest_s, now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime)
        new = self.files() - before
        errors = done.stderr.decode(errors="replace")
        self.assertIn(done.returncode, (0, 1, 2, *([STOPPED] if option in AMOUNTS else [])), errors[-1000:])
        self.assertLess(
            now.ru_maxrss, max(used.ru_maxrss, MOST_BYTES // 1024) + 1, "pages of the largest command so far, KiB"
        )
        if text == "":
            self.assertEqual(done.returncode, 2, "an empty text counts as one that is not given")
        if done.returncode in (1, 2):
            self.assertEqual(len(said_by(errors)), 1, errors[:1000])
            self.assertEqual(new, set())
        for path in sorted(new, reverse=True):
            (os.rmdir if (self.folder / path).is_dir() else os.remove)(self.folder / path)

    def test_what_cannot_be_done_is_refused_before_any_work(self):
        (self.folder / "changes.csv").write_text("time_s,number,value\n8,rules.capture.reach_m,0.5\n")
        for words, said in (
            ([TROPHIC, "contest", "set", "--team-size", "0"], "--team-size 0: must be >= 1 and <= 10000"),
            (
                [TROPHIC, "contest", "set", "--epochs", "0,40,"],
                "--epochs 0,40,: must be comma-separated times in seconds",
            ),
            ([TROPHIC, "film", "run", "--speed", "1e-9", "--out", "new.mp4"], "pictures: must have <= 1e+06"),
            (
                [
                    PREDATOR_PREY,
                    "--backend",
                    "kinematic",
                    "--duration",
                    "60",
                    "--out",
                    "run",
                    "--resume",
                    "--changes",
                    "changes.csv",
                ],
                "--changes changes.csv: must be omitted, because the run in run has no changes.csv",
            ),
        ):
            with self.subTest(words):
                before = self.files()
                done = self.call(*words, preexec_fn=limits)
                if "without pictures" in done.stderr:
                    continue
                self.assert_refused(done, said)
                self.assertEqual(self.files(), before)

    def test_every_option(self):
        there = run_ok(TROPHIC, "--help").stdout
        self.ends, self.longest_s = {}, 0.0
        for name, command in COMMANDS.items():
            if command[0] == TROPHIC and not re.search(rf"(\n  |[:,] ){name}\b", there):
                continue
            options = options_of(command)
            self.assertGreater(len(options), -1 if name in WITHOUT_VALUES else 0, name)
            for option in options:
                for text in TEXTS + (MORE_TEXTS if ALL else []):
                    with self.subTest(name=name, option=option, text=text[:50]):
                        self.try_out(without(command, option), option, text)
        largest = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024
        print(
            f"{self.ends.get(0, 0)} commands done, {self.ends.get(1, 0)} failed, {self.ends.get(2, 0)} refused, {self.ends.get(STOPPED, 0)} stopped; at most {self.longest_s:.1f} s and {largest} MiB",
            file=sys.stderr,
        )


if __name__ == "__main__":
    unittest.main()
