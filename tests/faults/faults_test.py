#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""faults_test.py PREDATOR_PREY SHIM TROPHIC [--all]: the k-th write, fsync, rename, ftruncate, open, read or allocation fails.

After each of a run: no crash, one clear line, nothing that looks complete and is not, nothing that was written is set aside, and
--resume comes to the same bytes. After each of a tool: no crash, one clear line, and its outputs whole or absent. Every k of the
calls to the system of a run; of the allocations, and of the calls of tools, some, with --all every one. A tool that TROPHIC was built
without is left out."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from in_folder import InFolder, planned  # noqa: E402

PROGRAM, SHIM, TROPHIC = (sys.argv.pop(1) for _ in range(3))
ALL = "--all" in sys.argv
if ALL:
    sys.argv.remove("--all")
TABLES = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"]
RUN = ["--backend", "kinematic", "--robots", "16", "--duration", "12", "--checkpoint-s", "4"]
CRASHES = ("terminate called", "Segmentation", "Aborted", "Assertion")


class Faults(InFolder):
    def call(self, out, *arguments, fault=None, at=0, mode="once", count=""):
        environment = dict(os.environ)
        if fault:
            environment |= {
                "LD_PRELOAD": SHIM,
                "FAULT_CALL": fault,
                "FAULT_AT": str(at),
                "FAULT_MODE": mode,
                "FAULT_COUNT": count,
            }
        return super().call(PROGRAM, *RUN, "--out", out, *arguments, env=environment)

    def setUp(self):
        super().setUp()
        self.run_ok(PROGRAM, *RUN, "--out", "whole")
        self.tables = {name: (self.folder / "whole" / name).read_bytes() for name in TABLES}

    def count(self, fault, *arguments):
        shutil.rmtree(self.folder / "counted", ignore_errors=True)
        if arguments:
            shutil.copytree(self.folder / "cut", self.folder / "counted")
        self.assertEqual(self.call("counted", *arguments, fault=fault, count="count.txt").returncode, 0)
        return int((self.folder / "count.txt").read_text())

    def status(self, out):
        try:
            return json.loads((self.folder / out / "manifest.json").read_text())["status"]
        except (OSError, ValueError):
            return "none"

    def assert_sound(self, done):
        self.assertIn(done.returncode, (0, 1, 2), done.stderr)
        for word in CRASHES:
            self.assertNotIn(word, done.stderr)
        if done.returncode != 0:
            said = [line for line in done.stderr.splitlines() if not line.startswith("all output so far is in")]
            self.assertEqual(len(said), 1, done.stderr)
        if self.status("run") == "complete":
            self.assertEqual({name: (self.folder / "run" / name).read_bytes() for name in TABLES}, self.tables)

    def assert_resumes(self):
        resume = ["--resume"] if (self.folder / "run").exists() else []
        self.run_ok(PROGRAM, *RUN, "--out", "run", *resume)
        self.assertEqual(self.status("run"), "complete")
        self.assertEqual({name: (self.folder / "run" / name).read_bytes() for name in TABLES}, self.tables)

    def try_fault(self, fault, at, mode, *arguments):
        with self.subTest(fault=fault, at=at, mode=mode, arguments=arguments):
            if arguments:
                shutil.copytree(self.folder / "cut", self.folder / "run")
            done = self.call("run", *arguments, fault=fault, at=at, mode=mode)
            self.assert_sound(done)
            if arguments:
                self.assertEqual(list(self.folder.glob("run.incomplete*")), [], "what was written was set aside")
            self.assert_resumes()
        for path in self.folder.glob("run*"):
            shutil.rmtree(path)

    def cut_off(self):
        """A run that was stopped in the middle, for --resume."""
        for at in range(1, self.count("write")):
            self.call("cut", fault="write", at=at, mode="from")
            if (self.folder / "cut" / "checkpoint.bin").exists():
                return
            shutil.rmtree(self.folder / "cut")
        self.fail("no checkpoint before the end")

    def test_system_calls(self):
        tried = 0
        self.cut_off()
        for arguments in ((), ("--resume",)):
            for fault in ("write", "fsync", "rename", "ftruncate", "open", "read"):
                for at in range(1, self.count(fault, *arguments) + 1):
                    for mode in ("once", "from") if ALL or fault == "write" else ("once",):
                        self.try_fault(fault, at, mode, *arguments)
                        tried += 1
        print(f"{tried} faults of system calls", file=sys.stderr)
        self.assertGreater(tried, 50)

    def test_allocations(self):
        allocations = self.count("new")
        chosen = range(1, allocations + 1) if ALL else sorted({int(allocations * (i / 40) ** 2) + 1 for i in range(40)})
        for at in chosen:
            self.try_fault("new", at, "once")
        print(f"{len(chosen)} of {allocations} allocations failed", file=sys.stderr)

    def test_allocations_for_the_list_of_replicates(self):
        """Those before replicates.json is written; its value has a type before it has a content."""
        replicates = ("--replicates", "2", "--jobs", "1")

        def listed(at):
            shutil.rmtree(self.folder / "run", ignore_errors=True)
            done = self.call("run", *replicates, fault="new", at=at)
            # 2 where toml++ takes the lack of memory for a number it cannot read.
            self.assertIn(done.returncode, (1, 2), (at, done.stderr))
            return (self.folder / "run" / "replicates.json").exists()

        shutil.rmtree(self.folder / "counted", ignore_errors=True)
        self.assertEqual(self.call("counted", *replicates, fault="new", count="count.txt").returncode, 0)
        before, written = 1, int((self.folder / "count.txt").read_text())
        while written - before > 1:
            middle = (before + written) // 2
            before, written = (before, middle) if listed(middle) else (middle, written)
        for at in range(written - 100, written):
            with self.subTest(at=at):
                listed(at)

    def test_full_disk(self):
        """A file system that is full after so many KB, given more room afterwards."""
        in_namespace = ["unshare", "--map-root-user", "--mount", "sh", "-ec"]
        if subprocess.run([*in_namespace, "mount -t tmpfs none /mnt"], capture_output=True).returncode != 0:
            print("full disk: not tried, as nothing may be mounted here", file=sys.stderr)
            return
        full = 0
        for kilobytes in range(4, 200, 4 if ALL else 12):
            with self.subTest(kilobytes=kilobytes):
                (self.folder / "disk").mkdir()
                script = f"""
                    mount -t tmpfs -o size={kilobytes}k none disk
                    "$0" "$@" --out disk/run || echo $? > code
                    ls -R disk > left
                    mount -o remount,size=64m disk
                    "$0" "$@" --out disk/run --resume 2> again
                    cp -r disk/run run"""
                done = self.run_ok(*in_namespace, script, PROGRAM, *RUN)
                if (self.folder / "code").exists():
                    full += 1
                    self.assertEqual((self.folder / "code").read_text(), "1\n")
                    said = [line for line in done.stderr.splitlines() if not line.startswith("all output so far is in")]
                    self.assertEqual(len(said), 1, done.stderr)
                    self.assertIn("No space left", said[0])
                self.assertEqual(self.status("run"), "complete")
                self.assertEqual({name: (self.folder / "run" / name).read_bytes() for name in TABLES}, self.tables)
            for path in ("disk", "run"):
                shutil.rmtree(self.folder / path, ignore_errors=True)
            (self.folder / "code").unlink(missing_ok=True)
        print(f"{full} full disks", file=sys.stderr)
        self.assertGreater(full, 2)


SWEEP = """engine = "kinematic"
replicates = 2
[set]
ecology.robots = 16
ecology.duration_s = 12.0
[grid]
rules.mutation.sd = [0.05, 0.1]
"""
TOOLS = {
    "cite": (TROPHIC, "cite", "set"),
    "contest": (
        TROPHIC,
        "contest",
        "set",
        "--epochs",
        "0,8",
        "--duration",
        "4",
        "--teams",
        "2",
        "--team-size",
        "2",
        "--jobs",
        "1",
        "--out",
        "new",
    ),
    "convert": (TROPHIC, "convert", "body.txt", "--out", "new.toml"),
    "export": (TROPHIC, "export", "set/replicate-00", "--out", "new.glb"),
    "film": (TROPHIC, "film", "set/replicate-00", "--out", "new.png"),
    "show": (TROPHIC, "show", "set/replicate-00", "--out", "new.html"),
    "status": (PROGRAM, "--plan", "sweep/plan.jsonl", "--status"),
}
IN_PYTHON = ("cite", "contest")


class OfTools(InFolder):
    """The tools read runs and write files and folders whose names begin with "new"."""

    def call(self, words, **environment):
        return super().call(*words, env=os.environ | environment)

    def outputs(self):
        return {
            str(path.relative_to(self.folder)): path.read_bytes()
            for path in sorted(self.folder.rglob("new*/**/*")) + sorted(self.folder.glob("new*"))
            if path.is_file()
        }

    def clear(self):
        for path in self.folder.glob("new*"):
            shutil.rmtree(path) if path.is_dir() else path.unlink()

    def setUp(self):
        super().setUp()
        (self.folder / "sweep.toml").write_text(SWEEP)
        (self.folder / "body.txt").write_text("0 CoreComponent Core 0\n\t0 ActiveHinge Hip 1\n")
        for words in (
            (PROGRAM, *RUN, "--replicates", "2", "--out", "set"),
            planned(PROGRAM, "sweep.toml", "sweep", self.folder),
        ):
            self.run_ok(*words)

    def count(self, words, fault):
        self.call(words, LD_PRELOAD=SHIM, FAULT_CALL=fault, FAULT_AT="0", FAULT_COUNT="count.txt")
        self.clear()
        return int((self.folder / "count.txt").read_text())

    @staticmethod
    def chosen(fault, calls):
        if ALL:
            return range(1, calls + 1, 1 + calls // 200 if fault == "new" else 1)
        return sorted({calls // 2 + 1, calls} if fault == "new" else {1, calls} - {0})

    def check(self, words, whole, fault, at):
        done = self.call(words, LD_PRELOAD=SHIM, FAULT_CALL=fault, FAULT_AT=str(at), FAULT_MODE="once")
        left = self.outputs()
        self.clear()
        self.assertIn(done.returncode, (0, 1, 2), done.stderr)
        for word in CRASHES:
            self.assertNotIn(word, done.stderr)
        if "init_import_site" in done.stderr:  # the interpreter itself did not start
            self.assertEqual(left, {})
        elif done.returncode == 0:
            self.assertEqual(left, whole)
        else:
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            for name, content in left.items():
                if not name.endswith(".part/played.jsonl"):  # from which the same command continues
                    self.assertEqual(content, whole.get(name), f"{name}: is there, and is not whole")

    def test_tools(self):
        tried = 0
        for name, words in TOOLS.items():
            done = self.call(words)
            if done.returncode == 2 and "this program was built without" in done.stderr:
                print(f"{name}: not tried: {done.stderr.strip()}", file=sys.stderr)
                continue
            self.assertEqual(done.returncode, 0, (name, done.stderr))
            whole = self.outputs()
            self.clear()
            for fault in ("write", "fsync", "rename", "open", "read", "new"):
                if fault in ("read", "new") and name in IN_PYTHON:  # of the shell, the interpreter and its libraries
                    continue
                calls = self.count(words, fault)
                for at in self.chosen(fault, calls):
                    with self.subTest(name=name, fault=fault, at=at, of=calls):
                        self.check(words, whole, fault, at)
                    tried += 1
        print(f"{tried} faults of tools", file=sys.stderr)
        self.assertGreater(tried, 50)


if __name__ == "__main__":
    unittest.main()
