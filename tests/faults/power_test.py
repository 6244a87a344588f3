#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""power_test.py PREDATOR_PREY SHIM [--all]: the power fails at any moment of a run, of a resumed run and of the runs of a plan.

A shim logs what the program does to files. Up to each fsync and each change of a name (with --all: each call) the log is replayed into
three states that a file system may leave, as ALICE does (Pillai and others, OSDI 2014): all of it; all names, but of each file's content
only what was put on the disk; of names, too, only those of folders that were put on the disk. From each of them the same command, with
--resume for a run, must come to the bytes of the run that nothing disturbed."""

import os
import pathlib
import shutil
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from in_folder import InFolder, planned  # noqa: E402

PROGRAM, SHIM = sys.argv.pop(1), sys.argv.pop(1)
ALL = "--all" in sys.argv
if ALL:
    sys.argv.remove("--all")
RUN = ["--backend", "kinematic", "--robots", "16", "--duration", "12", "--checkpoint-s", "4"]
TABLES = (".csv", ".trp")
SWEEP = """engine = "kinematic"
replicates = 2
[set]
ecology.robots = 16
ecology.duration_s = 8.0
[grid]
rules.mutation.sd = [0.05]
"""


class Disk:
    """A folder as programs see it and as it is on the disk. Everything has a number; folders have entries, files have content."""

    def __init__(self, root):
        self.root = str(root)
        self.entries, self.kept_entries = [{}], [{}]  # of folders; of a file None
        self.content, self.kept_content = [b""], [b""]

    def parts(self, path):
        return path[len(self.root) + 1 :].split("/") if path != self.root else []

    def find(self, parts):
        at = 0
        for part in parts:
            at = self.entries[at][part]
        return at

    def make(self, path, entries):
        *folder, name = self.parts(path)
        self.entries[self.find(folder)][name] = len(self.entries)
        self.entries.append(entries)
        self.kept_entries.append(None if entries is None else {})
        self.content.append(b"")
        self.kept_content.append(b"")

    def apply(self, call, path, what):
        *folder, name = self.parts(path)
        if call == "create":
            self.make(path, None)
        elif call == "mkdir":
            self.make(path, {})
        elif call == "write":
            place, data = what.split(" ")
            place, data, file = int(place), bytes.fromhex(data), self.find([*folder, name])
            before = self.content[file].ljust(place, b"\0")
            self.content[file] = before[:place] + data + before[place + len(data) :]
        elif call == "truncate":
            file = self.find([*folder, name])
            self.content[file] = self.content[file][: int(what)]
        elif call == "rename":
            *new_folder, new_name = self.parts(what)
            moved = self.entries[self.find(folder)].pop(name)
            self.entries[self.find(new_folder)][new_name] = moved
        elif call == "remove":
            del self.entries[self.find(folder)][name]
        elif call == "fsync":
            self.keep([*folder, name])

    def keep(self, parts):
        """Puts a file's content on the disk, or a folder's entries with the names that lead to it."""
        one = self.find(parts)
        if self.entries[one] is None:
            self.kept_content[one] = self.content[one]
            return
        self.name_on_disk(one, self.entries[one])
        self.kept_entries[one] = dict(self.entries[one])
        for count, part in enumerate(parts):
            self.name_on_disk(self.find(parts[:count]), {part: self.find(parts[: count + 1])})

    def name_on_disk(self, folder, names):
        """Adds names to those on the disk. A renamed file has one name at any time, because a rename is complete or absent."""
        for each in filter(None, self.kept_entries):
            for name in [name for name, one in each.items() if one in names.values()]:
                del each[name]
        self.kept_entries[folder] |= names

    def states(self):
        yield "all", self.files(self.entries, self.content)
        yield "unsynced content lost", self.files(self.entries, self.kept_content)
        yield "unsynced content and names lost", self.files(self.kept_entries, self.kept_content)

    def files(self, entries, content, at=0, path=""):
        """Contents by path; of a folder None."""
        found = {}
        for name, one in entries[at].items():
            found[f"{path}{name}"] = content[one] if entries[one] is None else None
            if entries[one] is not None:
                found |= self.files(entries, content, one, f"{path}{name}/")
        return found

    def write(self, files):
        for name, content in sorted(files.items()):
            path = pathlib.Path(self.root, name)
            path.mkdir() if content is None else path.write_bytes(content)


class PowerFailure(InFolder):
    def call(self, *words, **environment):
        return super().call(PROGRAM, *words, env=os.environ | environment)

    def logged(self, *words):
        """The calls of a program that ends well, as lists of three texts."""
        log = self.folder / "log"
        log.unlink(missing_ok=True)
        done = self.call(*words, LD_PRELOAD=SHIM, CRASH_LOG=str(log), CRASH_ROOT=str(self.folder / "root"))
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line.split("\t") for line in log.read_text().splitlines()]

    def tables(self):
        return {
            path.relative_to(self.folder): path.read_bytes()
            for path in sorted((self.folder / "root").rglob("*"))
            if path.suffix in TABLES and "incomplete" not in str(path)
        }

    def disk(self):
        return Disk(self.folder / "root")

    def clear(self):
        shutil.rmtree(self.folder / "root", ignore_errors=True)
        (self.folder / "root").mkdir()

    def check(self, disk, calls, again, whole):
        """Replays the calls; at each crash `again` must come to the tables."""
        tried, seen = 0, set()
        for at, (call, path, what) in enumerate(calls):
            disk.apply(call, path, what)
            if not ALL and call not in ("fsync", "rename", "remove", "mkdir", "create"):
                continue
            for state, files in disk.states():
                if (key := hash(tuple(sorted(files.items(), key=str)))) in seen:
                    continue
                seen.add(key)
                with self.subTest(after=(at, call, path), state=state):
                    self.clear()
                    disk.write(files)
                    is_there = (self.folder / "root/run").exists()
                    done = self.call(*(word for word in again if word != "--resume" or is_there))
                    self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                    self.assertEqual(self.tables(), whole)
                tried += 1
        print(f"{tried} states after a power failure", file=sys.stderr)
        self.assertGreater(tried, 20)

    def test_a_run(self):
        self.clear()
        calls = self.logged(*RUN, "--out", "root/run")
        whole = self.tables()
        self.assertEqual(len(whole), 5)
        self.check(self.disk(), calls, [*RUN, "--out", "root/run", "--resume"], whole)

    def test_a_resumed_run(self):
        self.clear()
        disk = self.disk()
        for call in self.logged(*RUN, "--out", "root/run"):
            disk.apply(*call)
        longer = [*RUN[:-3], "24", *RUN[-2:], "--out", "root/run", "--resume"]
        calls = self.logged(*longer)
        self.check(disk, calls, longer, self.tables())

    def test_a_plan(self):
        self.clear()
        (self.folder / "sweep.toml").write_text(SWEEP)
        disk = self.disk()
        plan = [*planned(PROGRAM, "sweep.toml", "root/out", self.folder)[1:], "--jobs", "1", "--checkpoint-s", "4"]
        for path in sorted((self.folder / "root").rglob("*")):
            disk.apply("mkdir" if path.is_dir() else "create", str(path), "")
            if path.is_file():
                disk.apply("write", str(path), f"0 {path.read_bytes().hex()}")
            disk.keep(disk.parts(str(path)))
            disk.keep(disk.parts(str(path.parent)))
        calls = self.logged(*plan)
        whole = self.tables()
        self.assertEqual(len(whole), 8)
        self.check(disk, calls, plan, whole)


if __name__ == "__main__":
    unittest.main()
