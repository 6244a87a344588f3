#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bad_input_test.py PREDATOR_PREY TROPHIC: bad input is refused in one line, at once, and leaves no files behind."""

import json
import os
import resource
import shutil
import subprocess
import sys
import time
import unittest

from in_folder import InFolder, call

PREDATOR_PREY, TROPHIC = sys.argv.pop(1), sys.argv.pop(1)
HAS_MUJOCO = ", mujoco" in call(PREDATOR_PREY, "--help", env={**os.environ, "COLUMNS": "200"}).stdout
MEMORY = 2 << 30


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def without_rights():
    if os.geteuid() == 0:
        os.setgroups([])
        os.setgid(65534)
        os.setuid(65534)


def limit_threads():
    without_rights()  # no limit binds root
    resource.setrlimit(resource.RLIMIT_NPROC, (4, 4))


class BadInput(InFolder):
    def refused(self, program, *arguments, code=2):
        before = sorted(os.listdir(self.folder))
        began = time.monotonic()
        done = self.call(program, *arguments, preexec_fn=limit_memory)
        self.assertLess(time.monotonic() - began, 30)
        self.assertLess(len(done.stderr), 1000)
        self.assert_refused(done, code=code)
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        return done.stderr

    def run_refused(self, *arguments, code=2):
        return self.refused(
            PREDATOR_PREY, "--backend", "kinematic", "--duration", 10, "--out", "out", *arguments, code=code
        )

    def test_numbers_that_are_malformed_or_absurd(self):
        for argument, must in [
            ("--replicates=-1", ">= 0"),
            ("--jobs=-1", ">= 0"),
            ("--seed=-1", ">= 0"),
            ("--threads=-1", ">= 0"),
            ("--seed=0x10", "decimal digits"),
            ("--replicates=99999999999", "<= 100000"),
            ("--checkpoint-s=0x10", "decimal digits"),
            ("--checkpoint-s=-1", ">= 0"),
            ("--checkpoint-s=nan", ">= 0"),
            ("--run=-1", ">= 0"),
            ("--run=0", "needs --plan"),
        ]:
            with self.subTest(argument=argument):
                self.assertIn(must, self.run_refused(argument))
        for duration, must in [("0x10", "decimal digits"), ("1e9", "<= 1e+08")]:
            with self.subTest(duration=duration):
                said = self.refused(PREDATOR_PREY, "--backend", "kinematic", f"--duration={duration}", "--out", "out")
                self.assertIn(must, said)

    def test_empty_texts(self):
        texts = ["--config", "--from", "--plan", "--save-mjcf", "--robot", "--rules", "--backend", "--set"]
        for option in texts:
            with self.subTest(option=option):
                self.assertIn(f"{option}: must not be empty", self.run_refused(option, ""))
        for arguments in [("analyze", ""), ("analyze", "run", "--out", ""), ("show", "run", "-o", ""), ("film", "")]:
            with self.subTest(arguments=arguments):
                self.assertIn(": must not be empty", self.refused(TROPHIC, *arguments))

    def test_files_and_folders_that_are_not_there(self):
        for arguments, part in [
            (["--config", "no.toml"], "no.toml: cannot be read"),
            (["--robot", "no.toml"], 'no robot "no.toml"'),
            (["--set=ecology.arena=no.toml"], 'no arena "no.toml"'),
            (["--set=ecology.gait=no.toml"], 'no gait "no.toml"'),
            (["--from", "no", "--at", 3], "no/manifest.json: cannot be read"),
        ]:
            with self.subTest(arguments=arguments):
                self.assertIn(part, self.run_refused(*arguments))
        self.assertIn("no.toml: cannot be read", self.refused(PREDATOR_PREY, "--plan", "no.toml"))
        (self.folder / "empty").mkdir()
        for command in (
            ["analyze"],
            ["show", "-o", "x.html"],
            ["film", "-o", "x.png"],
            ["export", "-o", "x.glb"],
            ["analyze", "--compare", "no"],
        ):
            with self.subTest(command=command):
                self.assertIn("no: does not exist", self.refused(TROPHIC, *command, "no"))
        self.assertIn("empty/manifest.json: cannot be read", self.refused(TROPHIC, "analyze", "empty"))
        (self.folder / "many/one").mkdir(parents=True)
        (self.folder / "many/one/manifest.json").write_text("{}")
        for command in (["show", "-o", "x.html"], ["film", "-o", "x.png"], ["export", "-o", "x.glb"]):
            with self.subTest(command=command):
                self.assertIn("many: is not a run; in it are many/one", self.refused(TROPHIC, *command, "many"))
        self.assertIn("--out x.pdf: must end in .html or .htm", self.refused(TROPHIC, "show", "-o", "x.pdf", "empty"))
        self.assertIn("runs: needs 2 values", self.refused(TROPHIC, "cross-check", "one", "--out", "new"))
        for command in (
            ["evolve-gait", "--config", "no.toml", "--out", "x"],
            ["evolve-gait", "--robot", "no.toml", "--out", "x"],
            ["measure-gait", "--robot", "no.toml"],
            ["measure-gait", "--gait", "no.toml"],
        ):
            with self.subTest(command=command):
                self.assertIn("no.toml", self.refused(TROPHIC, *command))

    def test_texts_of_several_lines_are_shown_in_one(self):
        self.assertIn('no robot "a\\x0ab\\x1b[2J"', self.run_refused("--robot", "a\nb\x1b[2J"))
        self.assertIn("--seed 7\\x0a: must be", self.run_refused("--seed", "7\n"))
        self.assertIn("a\\x0ab", self.refused(TROPHIC, "analyze", "a\nb"))

    def test_a_folder_whose_name_is_not_utf_8(self):
        for replicates in ([], ["--replicates", "2"]):
            out = os.fsencode(self.folder / f"jos{len(replicates)}") + b"\xe9"
            done = subprocess.run(
                [PREDATOR_PREY, "--backend", "kinematic", "--duration", "10", *replicates, "--out", out],
                capture_output=True,
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, rb"\A(remark  .*\n)*\Z")
            with open(out + (b"/replicates.json" if replicates else b"/manifest.json")) as file:
                self.assertIn("\ufffd", json.load(file)["command_line"])

    @unittest.skipUnless(HAS_MUJOCO, "needs threads")
    def test_more_threads_than_the_system_gives(self):
        """The run makes do with those that it gets."""
        self.folder.chmod(0o777)

        def run(threads, preexec, out):
            return self.call(
                PREDATOR_PREY,
                "--backend",
                "mujoco",
                "--duration",
                4,
                "--threads",
                threads,
                "--out",
                out,
                preexec_fn=preexec,
            )

        try:
            able = run(1, without_rights, "one").returncode == 0
        except (PermissionError, subprocess.SubprocessError):
            able = False
        if not able:
            self.skipTest("the program cannot be run by a user who has no rights")
        done = run(20, limit_threads, "few")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "one/agents.csv").read_bytes(), (self.folder / "few/agents.csv").read_bytes())

    def test_standard_streams_that_are_closed(self):
        """Printed text must not end up in the tables, whose files would have the streams' numbers."""
        command = [PREDATOR_PREY, "--backend", "kinematic", "--duration", "100", "--seed", "3"]
        self.run_ok(*command, "--out", "open")
        for number, (closed, code) in enumerate(
            [("<&-", 0), (">&-", 1), ("2>&-", 0), ("<&- >&-", 1), (">&- 2>&-", 1), ("<&- >&- 2>&-", 1)]
        ):
            with self.subTest(closed=closed):
                out = f"closed{number}"
                shell = ["sh", "-c", f'"$0" "$@" {closed}', *command, "--out", out]
                done = self.call(*shell)
                self.assertEqual(done.returncode, code, done.stderr)
                for name in ("events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "replay.trp"):
                    whole = (self.folder / "open" / name).read_bytes()
                    self.assertTrue((self.folder / out / name).read_bytes() == whole, name)

    def test_a_key_of_a_million_dots(self):
        dots = "a" + ".a" * 1_000_000
        config = self.folder / "dots.toml"
        config.write_text(dots + " = 1\n")
        self.assertIn("a key of more than 32 parts", self.run_refused("--config", "dots.toml"))
        self.assertIn("a key of more than 32 parts", self.run_refused("--set", "ecology.robot=./dots.toml"))
        self.run_refused("--set", "a" + ".a" * 30_000 + "=1")

    def test_texts_that_break_the_parser(self):
        for number, text in enumerate(
            [b"[# a]\n", b"\xcd\x8b = 1\n", b"a = " + b"[" * 100_000, b"\x00", b"\xff\xfe", b"a = 1e"]
        ):
            with self.subTest(text=text[:20]):
                (self.folder / f"{number}.toml").write_bytes(text)
                self.run_refused("--config", f"{number}.toml")

    def test_a_pipe_in_the_place_of_a_file(self):
        os.mkfifo(self.folder / "pipe")
        self.assertIn("is not a regular file", self.run_refused("--config", "pipe"))
        for model in ("robot", "arena", "gait"):
            with self.subTest(model=model):
                self.assertIn("searched: ./pipe", self.run_refused("--set", f"ecology.{model}=./pipe"))
        for name in ("manifest.json", "events.csv", "agents.csv"):
            with self.subTest(name=name):
                shutil.rmtree(self.folder / "run", ignore_errors=True)
                self.make_run()
                (self.folder / "run" / name).unlink()
                os.mkfifo(self.folder / "run" / name)
                done = self.call(TROPHIC, "analyze", "run", "--out", "new", timeout=20)
                self.assertIn("is not a regular file", done.stderr)
                shutil.rmtree(self.folder / "new", ignore_errors=True)

    def make_run(self):
        self.run_ok(PREDATOR_PREY, "--backend", "kinematic", "--duration", 300, "--out", "run")

    def test_tables_that_are_not_what_the_run_wrote(self):
        self.make_run()
        events = self.folder / "run" / "events.csv"
        rows = events.read_text().splitlines(keepends=True)
        for name, changed in [
            ("cut at a line's end", rows[:-3]),
            ("doubled rows", rows[:5] + rows[4:]),
            ("doubled", rows + rows[1:]),
            ("reversed", rows[:1] + rows[:0:-1]),
            ("header alone", rows[:1]),
        ]:
            with self.subTest(name=name):
                events.write_text("".join(changed))
                said = self.refused(TROPHIC, "analyze", "run", "--out", "new")
                self.assertIn("events.csv: has", said)
                self.assertIn("as its manifest says", said)
        events.write_text("".join(rows))
        self.run_ok(TROPHIC, "analyze", "run", "--out", "new")


if __name__ == "__main__":
    unittest.main()
