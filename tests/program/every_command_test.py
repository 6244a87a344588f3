#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""every_command_test.py TROPHIC: every command that `trophic --help` lists, in folders whose names have quotes and a line break.

Locale, environment and working folder change nothing of what a command prints and writes. A reader that stops, a closed or full standard output,
Ctrl-C in the first second and two more of the same command at once leave whole results or none, and at most one line on standard error."""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

import figures_python
from in_folder import InFolderWithSets, said_by

if figures_python.PYTHON is None:
    print("no Python with matplotlib, pandas and scipy")
    sys.exit(77)

TROPHIC = pathlib.Path(sys.argv.pop(1))
BIN = TROPHIC.parent
ENVIRONMENT = os.environ | {"PATH": f"{BIN}:/usr/bin:/bin"}
NAME = 'it\'s "<evil>"\n,é\x1b[2J'
OUT = "new\x1b[2J"
RUN = ("--backend", "kinematic", "--robots", "16", "--set", "rules.community.predators=8")
# The words after `trophic`, without --out, and how the result is named: "" is a folder, None is nothing.
COMMANDS = {
    "analyze": (("analyze", f"{NAME}/set", "--all"), ""),
    "cite": (("cite", f"{NAME}/set"), None),
    "contest": (("contest", f"{NAME}/set", "--duration", "4", "--teams", "2", "--team-size", "2", "--epochs", "0,40"), ""),
    "convert": (("convert", f"{NAME}/body.txt", "--name", "hinge"), ".toml"),
    "cross-check": (("cross-check", f"{NAME}/set", f"{NAME}/torus"), ""),
    "evolve-gait": (
        ("evolve-gait", "--generations", "1", "--set", "trial.duration_s=1", "--set", "plan.population=4", "--set", "plan.parents=2", "--set", "plan.children=2"),
        "",
    ),
    "export": (("export", f"{NAME}/set/replicate-00"), ".glb"),
    "film": (("film", f"{NAME}/set/replicate-00", "--size", "160x90"), ".png"),
    "help": (("help", "slots"), None),
    "measure-gait": (("measure-gait", "--duration", "5.1"), None),
    "plan": (("plan", f"{NAME}/sweep.toml"), ""),
    "plot": (("plot", f"{NAME}/analysis"), ""),
    "predator-prey": (("predator-prey", *RUN, "--duration", "60"), ""),
    "show": (("show", f"{NAME}/set"), ".html"),
    "worlds": (("worlds", "--backend", "kinematic", "--duration", "10"), ""),
}  # fmt: skip
OF_THE_CLOCK = {"manifest.json", "checkpoint.bin", "plan.jsonl"}  # times, the host and the program's path
MODULES = ("html", "json", "numbers", "pandas", "random", "sitecustomize", "statistics", "trophic", "usercustomize")


def contents(out):
    files = [out] if out.is_file() else sorted(path for path in out.rglob("*") if path.is_file())
    return {
        str(path.relative_to(out)): path.read_bytes()
        for path in files
        if path.name not in OF_THE_CLOCK and path.suffix != ".pdf"
    }


def remove(paths):
    for path in paths:
        shutil.rmtree(path) if path.is_dir() else path.unlink()


def hostile_surroundings(folder):
    """An environment, and a working folder, that would change what a program does if it heeded them."""
    for name in MODULES:
        (folder / f"{name}.py").write_text("raise SystemExit(9)\n")
    (folder / "matplotlibrc").write_bytes(b"lines.linewidth: 50\nsavefig.dpi: 20\n")
    (folder / "stop.sh").write_text("exit 9\n")
    for program in ("python3", "trophic-cite", "env", "readlink"):
        (folder / program).write_text("#!/bin/sh\nexit 9\n")
        (folder / program).chmod(0o755)
    here, nowhere = str(folder), "/proc/nowhere"
    locale = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"], capture_output=True)
    variables = {
        "LC_ALL": "tr_TR.ISO-8859-9" if locale.returncode else "de_DE.UTF-8",
        "LOCPATH": here,
        "LANGUAGE": "de",
        "TZ": "Asia/Kolkata",
    }
    variables |= {
        name: nowhere for name in ("HOME", "TMPDIR", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "MPLCONFIGDIR", "PYTHONHOME")
    }
    variables |= {
        "PYTHONPATH": here,
        "PYTHONSTARTUP": f"{here}/trophic.py",
        "PYTHONINSPECT": "1",
        "PYTHONWARNINGS": "error",
        "PYTHONOPTIMIZE": "2",
    }
    variables |= {
        "PYTHONUTF8": "0",
        "PYTHONIOENCODING": "utf-16",
        "PYTHONUSERBASE": here,
        "PYTHONHASHSEED": "7",
        "PYTHONPLATLIBDIR": here,
    }
    variables |= {
        "CDPATH": "/:/usr",
        "ENV": f"{here}/stop.sh",
        "BASH_ENV": f"{here}/stop.sh",
        "COLUMNS": "20",
        "TERM": "dumb",
        "NO_COLOR": "1",
    }
    variables |= {"MPLBACKEND": "nonsense", "MATPLOTLIBRC": here, "OMP_NUM_THREADS": "3", "POSIXLY_CORRECT": "1"}
    return variables


class EveryCommand(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        at = cls.sets / NAME
        at.mkdir()
        (at / "body.txt").write_text("0 CoreComponent Core 0\n\t0 ActiveHinge Hip 1\n")
        (at / "sweep.toml").write_text(
            'engine = "kinematic"\nreplicates = 1\n[set]\necology.duration_s = 8.0\n[grid]\nrules.mutation.sd = [0.05, 0.1]\n'
        )

        def done(*words):
            ended = subprocess.run([TROPHIC, *words], cwd=at, env=ENVIRONMENT, capture_output=True, text=True)
            assert ended.returncode == 0, ended.stderr

        for out, backend in (("set", ()), ("torus", ("--backend", "torus"))):
            run = (*RUN[2:], *backend) if backend else RUN
            done("predator-prey", *run, "--duration", "80", "--replicates", "2", "--out", out)
        done("analyze", "set", "--out", "analysis")
        cls.there = subprocess.run([TROPHIC, "--help"], env=ENVIRONMENT, capture_output=True, text=True).stdout
        cls.whole = {}
        for name in cls.listed():
            said, code, errors = cls.ended(cls.start(name, cls.sets, out=OUT))
            assert (code, errors) == (0, ""), (name, code, errors)
            suffix = COMMANDS[name][1]
            cls.whole[name] = said, contents(cls.sets / f"{OUT}{suffix}") if suffix is not None else {}
            remove(cls.sets.glob("new*"))

    @classmethod
    def listed(cls):
        own = re.findall(r"^  ([a-z][a-z-]+)  ", cls.there.split("\nCommands:\n")[1], re.M)
        return sorted(
            [*own, *re.search(r"^Further commands, each with its own --help: (.*)$", cls.there, re.M)[1].split(", ")]
        )

    @classmethod
    def start(cls, name, folder, out=None, env=ENVIRONMENT, **how):
        words, suffix = COMMANDS[name]
        more = ("--out", f"{out}{suffix}") if out is not None and suffix is not None else ()
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL}
        return subprocess.Popen(
            [TROPHIC, *words, *more], cwd=folder, env=env, text=True, encoding="utf-8", **(streams | how)
        )

    @staticmethod
    def ended(program):
        """What it printed, its exit code and its errors, without remarks on a run and the figures that `plot` leaves out."""
        said, errors = program.communicate(timeout=240)
        return said, program.returncode, "\n".join(line for line in said_by(errors) if ": left out: " not in line)

    def setUp(self):
        super().setUp()
        shutil.copytree(self.sets / NAME, self.folder / NAME)

    def check_result(self, name, out, has_it):
        """The result is whole; if it need not be there, it is whole or absent."""
        suffix = COMMANDS[name][1]
        if suffix is None:
            return
        path = self.folder / f"{out}{suffix}"
        if has_it or path.exists():
            self.check_same(contents(path), self.whole[name][1])
        self.assertEqual([left.name for left in self.folder.iterdir() if ".part" in left.name], [])

    def plain(self, content):
        """Without the names of results and of the temporary folder, and without times of the clock on the wall."""
        for name in (str(self.folder), str(self.sets)):
            content = content.replace(name.encode(), b"")
        return re.sub(rb"[0-9.e+]+ (s\b|evaluations/s|simulated s per wall s)", b"", content)

    def check_same(self, files, others):
        self.assertEqual(files.keys(), others.keys())
        for name, content in files.items():
            self.assertTrue(self.plain(content) == self.plain(others[name]), f"{name} differs")

    def test_every_command_is_here(self):
        self.assertEqual(set(self.listed()) | {"film"}, set(COMMANDS))

    def test_locale_environment_and_folder_change_nothing(self):
        env = ENVIRONMENT | hostile_surroundings(self.folder)
        for name, (said, _) in self.whole.items():
            with self.subTest(name):
                its, code, errors = self.ended(self.start(name, self.folder, OUT, env))
                self.assertEqual((code, errors), (0, ""))
                self.assertEqual(self.plain(its.encode()), self.plain(said.encode()))
                self.check_result(name, OUT, True)
                self.assertNotRegex(said, "[\x00-\x08\x0b-\x1f\x7f-\x9f]")
                if COMMANDS[name][1] == ".html":
                    self.assertNotIn(b"<evil>", self.whole[name][1]["."])
            self.clear()

    def test_a_reader_that_stops_and_an_output_that_cannot_be_written(self):
        for name in self.whole:
            with self.subTest(name):
                program = self.start(name, self.folder, OUT)
                program.stdout.close()
                _, code, errors = self.ended(program)
                self.assertIn(code, (0, 1, -signal.SIGPIPE), errors)
                self.assertLessEqual(len(said_by(errors)), 1, errors)
                self.check_result(name, OUT, True)
            self.clear()
            with self.subTest(name, full=True), open("/dev/full", "w") as full:
                _, code, errors = self.ended(self.start(name, self.folder, OUT, stdout=full))
                self.assertEqual((code, len(said_by(errors))), (1, 1), errors)
                self.assertIn("cannot write to standard output", errors)
                self.check_result(name, OUT, False)
            self.clear()
            with self.subTest(name, closed=True):
                _, code, errors = self.ended(
                    self.start(name, self.folder, OUT, stdout=None, preexec_fn=lambda: os.close(1))
                )
                self.assertEqual((code, len(said_by(errors))), (1, 1), errors)
                self.assertIn("cannot write to standard output", errors)
                self.check_result(name, OUT, False)
            self.clear()

    def test_three_at_once_in_one_folder(self):
        for name in self.whole:
            if COMMANDS[name][1] is None:
                continue
            takes_free_name = name in ("analyze", "contest", "cross-check", "predator-prey", "worlds")
            with self.subTest(name, takes_free_name=takes_free_name):
                before = set(self.folder.rglob("*"))
                programs = [self.start(name, self.folder, None if takes_free_name else OUT) for _ in range(3)]
                codes = []
                for program in programs:
                    _, code, errors = self.ended(program)
                    codes.append(code)
                    self.assertIn((code, len(said_by(errors))), ((0, 0), (1, 1), (2, 1)), errors)
                    self.assertEqual(
                        code != 0, bool(re.search("exists already|it exists|another program is", errors)), errors
                    )
                wanted = (1, 2, 3) if name == "plan" else (3,) if takes_free_name else (1,)  # a plan may be made again
                self.assertIn(codes.count(0), wanted, codes)
                new = [
                    path
                    for path in set(self.folder.rglob("*")) - before
                    if path.parent == self.folder or path.parent.name == "runs"
                ]
                made = [path for path in new if path.name != "runs"]
                self.assertEqual(len(made), 1 if name == "plan" else codes.count(0), made)
                for path in made:
                    self.assertEqual(contents(path).keys(), self.whole[name][1].keys())
            self.clear()

    def test_an_interruption_in_the_first_second(self):
        for name in self.whole:
            for delay_s in (0.02, 0.05, 0.12, 0.3, 1.0):
                with self.subTest(name, delay_s=delay_s):
                    program = self.start(name, self.folder, OUT)
                    time.sleep(delay_s)
                    program.send_signal(signal.SIGINT)
                    _, code, errors = self.ended(program)
                    self.assertIn(code, (0, 3, -signal.SIGINT), errors)
                    self.assertIn(errors.strip(), ("", "stopping; finished work is kept"))
                    if code == 0:
                        self.check_result(name, OUT, True)
                is_over = code == 0
                self.clear()
                if is_over:
                    break

    def clear(self):
        for path in self.folder.iterdir():
            if path.name.startswith(("new", "runs", "analysis", "contests")):
                shutil.rmtree(path) if path.is_dir() else path.unlink()


if __name__ == "__main__":
    unittest.main()
