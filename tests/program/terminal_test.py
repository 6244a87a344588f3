#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""terminal_test.py PREDATOR_PREY TROPHIC: a progress line that fits the terminal, and the help of every command."""

import fcntl
import os
import pathlib
import pty
import re
import struct
import subprocess
import sys
import termios
import unittest

from in_folder import InFolder

PREDATOR_PREY, TROPHIC = (sys.argv.pop(1) for _ in range(2))


class ProgressLine(InFolder):
    def drawn(self, columns, *arguments):
        """The lines that a run draws on a terminal of this width."""
        here, there = pty.openpty()
        fcntl.ioctl(there, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        command = [PREDATOR_PREY, "--backend", "kinematic", "--duration", "10000", *arguments]
        with subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=there) as process:
            os.close(there)
            read = b""
            while True:
                try:
                    piece = os.read(here, 4096)
                except OSError:
                    break
                if not piece:
                    break
                read += piece
        os.close(here)
        self.assertEqual(process.returncode, 0, read)
        lines = [line.replace("\x1b[K", "").strip("\r\n") for line in read.decode().split("\r")]
        return [line for line in lines if line]

    def test_progress_line_fits_the_terminal(self):
        for more in ([], ["--replicates", "2", "--jobs", "2"]):
            for columns in (20, 50, 200):
                with self.subTest(columns=columns, more=more):
                    lines = self.drawn(columns, *more)
                    self.assertGreater(len(lines), 0)
                    self.assertLess(max(map(len, lines)), columns)
                    if columns == 200:
                        self.assertTrue(any("deaths" in line or "replicate-0" in line for line in lines), lines)


class Help(InFolder):
    def text(self, *command):
        return self.run_ok(*command).stdout

    def test_groups_exit_codes_and_examples(self):
        head, examples = self.text(PREDATOR_PREY, "--help").split("\nExamples:\n")
        self.assertEqual(len(examples.splitlines()), 3)
        for group in ("The experiment:", "How long and how many:", "A plan of runs:", "Output:", "Look:", "Resume and branch:", "Print:"):
            self.assertIn(f"\n{group}\n  --", head)
        self.assertIn("\nExit codes: 0 done; 1 ", head)

    def test_examples_are_accepted(self):
        """Each example's options are those of its command."""
        for command in ([PREDATOR_PREY], *([TROPHIC, name] for name in ("analyze", "plot", "cite", "show", "help"))):
            text = self.text(*command, "--help")
            for example in text.split("\nExamples:\n")[1].splitlines():
                for option in re.findall(r"--[a-z-]+", example):
                    self.assertIn(f"{option} ", text)

    def test_help_of_a_command_is_its_help(self):
        self.assertEqual(self.text(TROPHIC, "help", "plot"), self.text(TROPHIC, "plot", "--help"))
        self.assertEqual(self.text(TROPHIC, "help"), self.text(TROPHIC, "--help"))
        self.assert_refused(self.call(TROPHIC, "help", "slot"), "did you mean slots?")

    def test_every_slot_is_asked_about_with_its_policies(self):
        text = self.text(TROPHIC, "help", "slots")
        include = pathlib.Path(__file__).resolve().parents[2] / "include/trophic"
        slots = re.findall(r"^(\w+) \((\w+)\)\n  (.*\?)\n  policies: (.*)\n  swap: with_\1<", text, re.M)
        self.assertEqual(len(slots), text.count("\n  policies: "))
        for slot, kind, question, policies in slots:
            folder = include / kind / slot
            self.assertTrue((folder / "contract.hpp").exists(), folder)
            of_parts = dict(part.split(": ") for part in f"{slot}: {policies.removeprefix('list of: ')}".split("; "))
            no_policies = {"contract", "list"} if policies.startswith("list of: ") else {"contract"}
            there = {path.parent.name: {other.stem for other in path.parent.glob("*.hpp")} - no_policies for path in folder.rglob("contract.hpp")}
            self.assertEqual({part: set(names.split()) for part, names in of_parts.items()}, there)
        self.assertIn("Who becomes a parent?", self.text(TROPHIC, "help", "slots", "parent"))
        self.assertIn("velocity_stored", self.text(TROPHIC, "help", "metrics"))


class Tool(InFolder):
    program = (TROPHIC,)

    def test_commands(self):
        text = self.call("--help").stdout
        for command in ("analyze", "plot", "cite", "help", "ablation-table", "cross-check", "evolve-gait", "measure-gait", "convert"):
            self.assertIn(command, text)
            inner = self.run_ok(command, "--help")
            self.assertEqual(inner.stderr, "")
            self.assertIn(command, inner.stdout)
        self.assertIn("trophic", self.call("--version").stdout)

    def test_refusals(self):
        for arguments, sentence in (
            ([], "trophic: needs a command: plan, analyze, contest, plot, cite, show, film, export, ablation-table, cross-check, evolve-gait, measure-gait, convert or help\n"),
            (["analyse"], "trophic: analyse: must be plan, analyze, contest, plot, cite, show, film, export, ablation-table, cross-check, evolve-gait, measure-gait, convert or help; did you mean analyze?\n"),
            (["analyze", "--publish"], "trophic analyze: --publish: unknown option; did you mean --published? (--help lists all)\n"),
            (["ablation-table"], "trophic ablation-table: runs is required\n"),
        ):
            result = self.call(*arguments)
            self.assertEqual((result.returncode, result.stderr), (2, sentence))


if __name__ == "__main__":
    unittest.main()
