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
        return [line for line in lines if line and not line.startswith("remark  ")]

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
        for group in (
            "The experiment:",
            "How long and how many:",
            "A plan of runs:",
            "Output:",
            "Look:",
            "Resume and branch:",
            "Print:",
        ):
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
        self.assertIn("velocity_stored", self.text(TROPHIC, "help", "metrics"))

    def test_a_program_on_the_path_is_found_and_no_file_of_the_user_shadows_a_module(self):
        (self.folder / "trophic-hello").write_text("#!/bin/sh\necho hello $1\n")
        (self.folder / "trophic-hello").chmod(0o755)
        found = {"env": os.environ | {"PATH": f"{self.folder}:{os.environ['PATH']}"}}
        self.assertEqual(self.run_ok(TROPHIC, "hello", "you", **found).stdout, "hello you\n")
        self.assertIn("hello", self.run_ok(TROPHIC, "--help", **found).stdout)
        self.assert_refused(self.call(TROPHIC, "hello"), "hello: must be")
        for module in ("json", "pandas", "trophic"):
            (self.folder / f"{module}.py").write_text("raise SystemExit('shadowed')\n")
        self.assertIn("usage: trophic analyze", self.run_ok(TROPHIC, "analyze", "--help").stdout)
        self.assert_refused(self.call(TROPHIC, "cite", "nowhere"), "nowhere: does not exist")


class Tool(InFolder):
    program = (TROPHIC,)

    def test_commands(self):
        text = self.call("--help").stdout
        for command in ("analyze", "plot", "cite", "help", "cross-check", "evolve-gait", "measure-gait", "convert"):
            self.assertIn(command, text)
            inner = self.run_ok(command, "--help")
            self.assertEqual(inner.stderr, "")
            self.assertIn(command, inner.stdout)
        self.assertIn("trophic", self.call("--version").stdout)

    def test_refusals(self):
        for arguments, sentence in (
            ([], r"trophic: needs a command: show, .*analyze, .*\n"),
            (["analyse"], r"trophic: analyse: must be show, .*analyze, .*; did you mean analyze\?\n"),
            (
                ["analyze", "--publish"],
                r"trophic analyze: --publish: unknown option; did you mean --published\? \(--help lists all\)\n",
            ),
            (["cite"], "trophic cite: run is required\n"),
        ):
            result = self.call(*arguments)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, f"^{sentence}$")


if __name__ == "__main__":
    unittest.main()
