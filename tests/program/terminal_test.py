#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""terminal_test.py PREDATOR_PREY TROPHIC: what the terminal and its shell see: a progress line that fits, and completion in bash."""

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

    def test_fits_the_terminal(self):
        for more in ([], ["--replicates", "2", "--jobs", "2"]):
            for columns in (20, 50, 200):
                with self.subTest(columns=columns, more=more):
                    lines = self.drawn(columns, *more)
                    self.assertGreater(len(lines), 0)
                    self.assertLess(max(map(len, lines)), columns)
                    if columns == 200:
                        self.assertTrue(any("deaths" in line or "replicate-0" in line for line in lines), lines)


class Completion(InFolder):
    def offered(self, program, *words):
        """What bash offers for the last of these words."""
        name = pathlib.Path(program).name
        script = subprocess.run([program, "--completion", "bash"], capture_output=True, text=True, check=True).stdout
        ask = ("compopt() { :; }\nCOMP_WORDS=(\"$@\")\nCOMP_CWORD=$(($# - 1))\n"
               f"complete -p {name} >/dev/null || exit 1\n_{re.sub('[^0-9A-Za-z]', '_', name)}\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"\n")
        result = subprocess.run(["bash", "-c", script + ask, "bash", name, *words], capture_output=True, text=True, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout.split("\n")[:-1]

    def test_options_and_their_words(self):
        self.assertEqual(self.offered(PREDATOR_PREY, "--re"), ["--replicates", "--resume", "--replay-hz"])
        self.assertEqual(self.offered(PREDATOR_PREY, "--rules", ""), ["paper", "released"])
        self.assertEqual(self.offered(PREDATOR_PREY, "--rules", "=", "re"), ["released"])
        self.assertEqual(self.offered(PREDATOR_PREY, "--seed", "1", "--backend", "k"), ["kinematic"])
        self.assertEqual(self.offered(PREDATOR_PREY, "--set", "rules.mutation.s"), ["rules.mutation.sd="])
        self.assertIn("rules.mutation.half_width=", self.offered(PREDATOR_PREY, "--set", "rules.mut"))
        self.assertEqual(self.offered(PREDATOR_PREY, "--seed", ""), [""])

    def test_files(self):
        (self.folder / "numbers.toml").write_text("")
        self.assertEqual(self.offered(PREDATOR_PREY, "--config", "num"), ["numbers.toml"])
        self.assertEqual(self.offered(TROPHIC, "analyze", "num"), ["numbers.toml"])

    def test_subcommands(self):
        self.assertEqual(self.offered(TROPHIC, "a"), ["analyze", "ablation-table"])
        self.assertEqual(self.offered(TROPHIC, "evolve-gait", "--fit"), ["--fitness"])
        self.assertEqual(self.offered(TROPHIC, "evolve-gait", "--table", "r"), ["released"])
        self.assertEqual(self.offered(TROPHIC, "analyze", "--fit"), [""])


class Tool(InFolder):
    def call(self, *arguments):
        return subprocess.run([TROPHIC, *arguments], capture_output=True, text=True, cwd=self.folder)

    def test_commands(self):
        text = self.call("--help").stdout
        for command in ("analyze", "ablation-table", "cross-check", "evolve-gait", "measure-gait"):
            self.assertIn(command, text)
            inner = self.call(command, "--help")
            self.assertEqual((inner.returncode, inner.stderr), (0, ""))
            self.assertIn(command, inner.stdout)
        self.assertIn("trophic", self.call("--version").stdout)

    def test_refusals(self):
        for arguments, sentence in (
            ([], "trophic: needs a command: analyze, ablation-table, cross-check, evolve-gait, measure-gait, show, film or export\n"),
            (["analyse"], "trophic: analyse: must be analyze, ablation-table, cross-check, evolve-gait, measure-gait, show, film or export; did you mean analyze?\n"),
            (["analyze", "--publish"], "trophic analyze: --publish: unknown option; did you mean --published? (--help lists all)\n"),
            (["ablation-table"], "trophic ablation-table: runs is required\n"),
        ):
            result = self.call(*arguments)
            self.assertEqual((result.returncode, result.stderr), (2, sentence))


if __name__ == "__main__":
    unittest.main()
