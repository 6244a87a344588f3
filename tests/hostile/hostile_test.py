#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""hostile_test.py PREDATOR_PREY TROPHIC OWN_RULE_1 OWN_RULE_3 [SUITE] [--damages=N]: damaged, linked, mixed and foreign input is noticed, never continued."""

import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import time
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from in_folder import InFolder, planned, said_by, sealed_text  # noqa: E402

PREDATOR_PREY, TROPHIC, OWN_RULE_1, OWN_RULE_3 = (sys.argv.pop(1) for _ in range(4))
RANDOM_DAMAGES = int(sys.argv.pop().removeprefix("--damages=")) if sys.argv[-1].startswith("--damages=") else 12
FILES = ("events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "replay.trp")
KINEMATIC = ("--backend", "kinematic", "--robots", "16")


def zero_a_page(content):
    start = content.index(b"\n") + 1
    return content[:start] + bytes(64) + content[start + 64 :]


def change_a_digit(content):
    at = next(i for i in range(content.index(b"\n"), len(content)) if chr(content[i]).isdigit())
    return content[:at] + (b"7" if content[at : at + 1] != b"7" else b"3") + content[at + 1 :]


DAMAGES = (zero_a_page, change_a_digit, lambda content: content.replace(b"\n", b"\r\n"))


class Hostile(InFolder):
    def refused(self, code, *words):
        """The one line on standard error."""
        done = self.call(*words)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        said = [line for line in said_by(done.stderr) if not line.startswith("all output so far is in")]
        self.assertEqual(len(said), 1, done.stderr)
        return said[0]

    def contents(self, folder):
        return {str(path): path.read_bytes() for path in sorted((self.folder / folder).rglob("*")) if path.is_file()}

    def change(self, path, change):
        path = self.folder / path
        path.write_bytes(change(path.read_bytes()))


class Damage(Hostile):
    def test_a_damaged_run_is_not_resumed(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--out", "run")
        for name in FILES:
            for damage in DAMAGES:
                with self.subTest(name=name, damage=damage):
                    shutil.rmtree(self.folder / "damaged", ignore_errors=True)
                    shutil.copytree(self.folder / "run", self.folder / "damaged")
                    self.change(f"damaged/{name}", damage)
                    damaged = self.contents("damaged")[str(self.folder / "damaged" / name)]
                    said = self.refused(1, PREDATOR_PREY, *KINEMATIC, "--duration", 80, "--out", "damaged", "--resume")
                    self.assertIn(f"damaged/{name}: its first", said)
                    self.assertEqual((self.folder / "damaged" / name).read_bytes(), damaged)
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 80, "--out", "run", "--resume")

    def test_a_damaged_run_does_not_begin_another(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--out", "run")
        self.change("run/events.csv", change_a_digit)
        said = self.refused(
            1, PREDATOR_PREY, *KINEMATIC, "--duration", 80, "--out", "new", "--from", "run", "--at", 40, "--seed", 5
        )
        self.assertIn("run/events.csv: has checksum", said)

    def test_a_damaged_run_of_a_sweep_is_not_resumed(self):
        (self.folder / "sweep.toml").write_text(
            'engine = "kinematic"\nreplicates = 1\nreplay_hz = 5.0\n[set]\necology.robots = 16\necology.duration_s = 40.0\n'
            "[grid]\nrules.mutation.sd = [0.05, 0.1]\n"
        )
        plan = (*planned(PREDATOR_PREY, "sweep.toml", "out", self.folder), "--jobs", 1)
        self.run_ok(*plan)
        whole = self.contents("out")
        run = next((self.folder / "out").glob("cell-*0/replicate-00"))
        (run / "manifest.json").write_text(sealed_text(self.manifest(run) | {"status": "running"}))
        self.change(run / "agents.csv", zero_a_page)
        failed = self.call(*plan)
        self.assertEqual(failed.returncode, 1, failed.stderr)
        self.assertIn("agents.csv: its first", failed.stderr)
        self.assertIn("replicate-00.incomplete-1; the next attempt starts without it", failed.stderr)
        self.run_ok(*plan)
        tables = {path: content for path, content in whole.items() if path.endswith((".csv", ".trp"))}
        again = self.contents("out")
        self.assertEqual({path: again[path] for path in tables}, tables)

    def test_a_damaged_table_is_not_pooled(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--replicates", 2, "--out", "set")
        self.run_ok(TROPHIC, "analyze", "set", "--out", "before")
        for name in FILES:
            for damage in (*DAMAGES, lambda content: b"\xef\xbb\xbf" + content):
                for more in ((), ("--published",)):
                    with self.subTest(name=name, damage=damage, more=more):
                        path = self.folder / "set/replicate-01" / name
                        whole = path.read_bytes()
                        path.write_bytes(damage(whole))
                        said = self.refused(2, TROPHIC, "analyze", "set", *more, "--out", "after")
                        path.write_bytes(whole)
                        self.assertIn(f"set/replicate-01/{name}: has ", said)
                        self.assertFalse((self.folder / "after").exists())
        (self.folder / "set/replicate-01/genomes.csv").unlink()
        self.assertIn("genomes.csv: cannot be read", self.refused(2, TROPHIC, "analyze", "set", "--out", "after"))

    def test_a_table_that_no_checksum_covers_is_not_pooled_when_it_cannot_be_read(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--replicates", 2, "--out", "set")
        manifest = self.manifest("set/replicate-01")
        del manifest["tables"], manifest["recording"]
        (self.folder / "set/replicate-01/manifest.json").write_text(sealed_text(manifest))
        self.change("set/replicate-01/events.csv", lambda content: b"\xef\xbb\xbf" + content)
        for more in ((), ("--published",)):
            said = self.refused(2, TROPHIC, "analyze", "set", *more, "--out", "after")
            self.assertIn("replicate-01/events.csv:1: begins with a byte order mark", said)

    def test_a_damaged_complete_run_is_made_anew_by_the_same_command(self):
        (self.folder / "sweep.toml").write_text(
            'engine = "kinematic"\nreplicates = 2\nreplay_hz = 5.0\n[set]\necology.robots = 16\necology.duration_s = 20.0\n'
            "[grid]\nrules.mutation.sd = [0.05, 0.1]\n"
        )
        run = (PREDATOR_PREY, *KINEMATIC, "--duration", 20, "--resume")
        for out, folder, command in (
            ("run", "run", (*run, "--out", "run")),
            ("set", "set/replicate-01", (*run, "--replicates", 2, "--out", "set")),
            ("sweep", "sweep/cell-000/replicate-01", planned(PREDATOR_PREY, "sweep.toml", "sweep", self.folder)),
        ):
            with self.subTest(out):
                self.run_ok(*(word for word in command if word != "--resume"))
                whole = {name: (self.folder / folder / name).read_bytes() for name in FILES}
                self.change(f"{folder}/genomes.csv", change_a_digit)
                damaged = (self.folder / folder / "genomes.csv").read_bytes()
                self.assertNotIn("damaged", self.run_ok(*command, "--no-verify").stdout)
                self.assertIn("kept as", self.run_ok(*command).stdout)
                self.assertEqual({name: (self.folder / folder / name).read_bytes() for name in FILES}, whole)
                self.assertEqual((self.folder / f"{folder}.incomplete-1/genomes.csv").read_bytes(), damaged)

    def test_no_random_damage_is_silent(self):
        command = (PREDATOR_PREY, *KINEMATIC, "--duration", 20, "--senses", "--out", "run", "--resume")
        self.run_ok(*command[:-1])
        whole = {path: path.read_bytes() for path in sorted((self.folder / "run").iterdir())}
        draw = random.Random(RANDOM_DAMAGES)
        others = (
            (TROPHIC, "analyze", "run", "--out", "new"),
            (TROPHIC, "cite", "run"),
            (TROPHIC, "show", "run", "--out", "new.html"),
            (TROPHIC, "export", "run", "--out", "new.glb"),
            (TROPHIC, "contest", "run", "--out", "new", "--against", "own", "--duration", 1),
            (PREDATOR_PREY, "--from", "run", "--at", 10, "--out", "new"),
        )
        for number in range(RANDOM_DAMAGES):
            path, content = draw.choice(list(whole.items()))
            at, end = sorted(draw.randrange(len(content) + 1) for _ in range(2))
            damaged = draw.choice(
                (
                    content[:at],
                    content[:at] + content[end:],
                    content + content[at:end] + b"1",
                    content[:at] + bytes(64) + content[at + 64 :],
                    content[:at] + bytes([content[at - 1] ^ 1 << draw.randrange(8)]) + content[at + 1 :],
                )
            )
            if damaged == content:
                continue
            other = draw.choice(others)
            with self.subTest(number=number, path=path.name, command=other):
                path.write_bytes(damaged)
                said = self.call(*other)
                self.assertIn(said.returncode, (1, 2), said.stdout)
                self.assertIn(f"run/{path.name}: ", said.stderr)
                self.assertNotIn("json.exception", said.stderr)
                self.assertFalse((self.folder / "new").exists(), other)
                self.assertRegex(
                    self.run_ok(*command).stdout,
                    "was complete, but damaged|because its manifest.json is incomplete|was incomplete",
                )
                tables = [name for name in whole if name.name not in ("manifest.json", "checkpoint.bin")]
                self.assertEqual([name.read_bytes() for name in tables], [whole[name] for name in tables])
            for folder in self.folder.glob("run*"):
                shutil.rmtree(folder)
            (self.folder / "run").mkdir()
            for name, bytes_ in whole.items():
                name.write_bytes(bytes_)


class Killed(Hostile):
    """tests/program/interrupted_test.py kills the other commands."""

    def test_a_stopped_contest_continues(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 400, "--replicates", 2, "--out", "set")
        contest = (TROPHIC, "contest", "set", "--duration", 300, "--teams", 20, "--jobs", 1)
        self.run_ok(*contest, "--out", "whole")
        program = subprocess.Popen(
            [str(word) for word in (*contest, "--out", "parts")], cwd=self.folder, stderr=subprocess.PIPE, text=True
        )
        played = self.folder / "parts.part/played.jsonl"
        while program.poll() is None and not (played.exists() and played.read_bytes().count(b"\n") > 5):
            time.sleep(0.001)
        program.terminate()
        said = program.communicate()[1]
        self.assertEqual(program.returncode, 3, said)
        self.assertIn("interrupted; to resume, repeat the command with --out parts", said)
        with open(played, "ab") as file:
            file.write(b"[7, 1")  # of a line that was cut
        self.assertRegex(
            self.run_ok(*contest, "--out", "parts").stderr,
            r"^trophic contest: \d+ of \d+ contests have been played already\n",
        )
        for name in ("contests.csv", "progress.csv"):
            self.assertEqual((self.folder / "parts" / name).read_bytes(), (self.folder / "whole" / name).read_bytes())
        self.assertEqual(
            sorted(path.name for path in (self.folder / "parts").iterdir()), ["contests.csv", "progress.csv"]
        )


class Links(Hostile):
    def setUp(self):
        super().setUp()
        self.precious = self.folder / "precious"
        self.precious.write_text("a PhD's worth of data")
        self.elsewhere = self.folder / "elsewhere"
        self.elsewhere.mkdir()
        (self.elsewhere / "kept").write_text("kept")

    def tearDown(self):
        self.assertEqual(self.precious.read_text(), "a PhD's worth of data")
        self.assertEqual([path.name for path in self.elsewhere.rglob("*")], ["kept"])
        super().tearDown()

    def test_a_run_with_links_is_not_resumed(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--out", "run")
        for name in ("manifest.json.part", "checkpoint.bin.part", "checkpoint.old.bin", "manifest.json", *FILES):
            for link in (lambda path: path.symlink_to(self.precious), lambda path: path.hardlink_to(self.precious)):
                with self.subTest(name=name):
                    shutil.rmtree(self.folder / "linked", ignore_errors=True)
                    shutil.copytree(self.folder / "run", self.folder / "linked")
                    path = self.folder / "linked" / name
                    path.unlink(missing_ok=True)
                    link(path)
                    said = self.refused(2, PREDATOR_PREY, *KINEMATIC, "--duration", 80, "--out", "linked", "--resume")
                    self.assertIn(f"linked/{name}: ", said)
                    self.assertIn("link", said)

    def test_replicates_in_links_are_not_resumed(self):
        command = (PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--replicates", 2, "--out", "set")
        self.run_ok(*command)
        shutil.rmtree(self.folder / "set/replicate-01")
        (self.folder / "set/replicate-01").symlink_to(self.elsewhere)
        self.assertIn("set/replicate-01: is a symbolic link", self.refused(2, *command, "--resume"))
        (self.folder / "set/replicate-01").unlink()
        (self.folder / "set/replicates.json.part").symlink_to(self.precious)
        self.assertIn("set/replicates.json.part: is a symbolic link", self.refused(2, *command, "--resume"))

    def test_a_sweep_writes_into_no_link(self):
        (self.folder / "sweep.toml").write_text(
            'engine = "kinematic"\nreplicates = 1\n[set]\necology.duration_s = 40.0\n'
            "[grid]\nrules.mutation.sd = [0.05]\n"
        )
        plan = planned(PREDATOR_PREY, "sweep.toml", "out", self.folder)
        self.run_ok(*plan)
        run = next((self.folder / "out").glob("cell-*/replicate-00"))
        shutil.rmtree(run)
        for name in ("replicate-00", "replicate-00.lock"):
            with self.subTest(name=name):
                link = run.with_name(name)
                link.symlink_to(self.elsewhere)
                done = self.call(*plan)
                link.unlink(missing_ok=True)
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                self.assertIn(f"{name}: is a symbolic link", done.stderr)
        self.run_ok(*plan)

    def test_the_past_of_a_run_is_made_in_no_link(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--out", "run")
        manifest = self.manifest("run")
        name = f"new.snapshot-{manifest['fingerprint']}-seed-{manifest['seed']}-40-s"
        (self.folder / name).symlink_to(self.elsewhere)
        said = self.refused(
            2, PREDATOR_PREY, *KINEMATIC, "--duration", 80, "--out", "new", "--from", "run", "--at", 40, "--seed", 5
        )
        self.assertIn(f"{name}: is a symbolic link", said)

    def test_an_out_that_is_a_link_is_the_folder_that_it_names(self):
        """As on clusters, where a home's folder of runs is a link to a scratch disk; what is in the folder must be its own."""
        disk = self.folder / "disk"
        for name in ("run", "sweep"):
            (disk / name).mkdir(parents=True)
            (self.folder / name).symlink_to(disk / name)
        run = (PREDATOR_PREY, *KINEMATIC, "--out")
        self.assertIn("exists already", self.refused(2, *run, "run", "--duration", 40))
        (disk / "run").rmdir()
        self.run_ok(*run, disk / "run", "--duration", 40)
        self.run_ok(*run, "run", "--duration", 80, "--resume")
        self.run_ok(*run, "straight", "--duration", 80)
        for name in FILES:
            self.assertEqual((disk / "run" / name).read_bytes(), (self.folder / "straight" / name).read_bytes(), name)
        (self.folder / "sweep.toml").write_text(
            'engine = "kinematic"\nreplicates = 1\n[set]\necology.duration_s = 40.0\n'
            "[grid]\nrules.mutation.sd = [0.05]\n"
        )
        (disk / "sweep").rmdir()
        self.run_ok(*planned(PREDATOR_PREY, "sweep.toml", disk / "sweep", self.folder))
        shutil.rmtree(next((disk / "sweep").glob("cell-*/replicate-00")))
        self.run_ok(*planned(PREDATOR_PREY, "sweep.toml", "sweep", self.folder))
        self.assertTrue(next((disk / "sweep").glob("cell-*/replicate-00")).is_dir())
        self.assertTrue((self.folder / "run").is_symlink() and (self.folder / "sweep").is_symlink())

    def test_what_trophic_writes_goes_into_no_link(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--out", "run")
        (self.folder / "page.html").symlink_to(self.precious)
        (self.folder / "new.html.part").symlink_to(self.precious)
        self.assertIn("page.html: exists already", self.refused(2, TROPHIC, "analyze", "run", "--html", "page.html"))
        self.run_ok(TROPHIC, "analyze", "run", "--html", "new.html", "--replays", 0)
        self.assertFalse((self.folder / "new.html").is_symlink())


class Builds(Hostile):
    """Two programs whose rule has the same name and numbers, and another constant in its code."""

    def test_another_build_does_not_resume_a_run_unless_that_is_accepted(self):
        self.run_ok(OWN_RULE_1, *KINEMATIC, "--duration", 40, "--out", "run")
        first = self.manifest("run")
        resume = (OWN_RULE_3, *KINEMATIC, "--duration", 80, "--out", "run", "--resume")
        said = self.refused(2, *resume)
        self.assertIn(f"the checkpoint's code = {first['code']}: must be ", said)
        self.assertEqual(self.manifest("run"), first)
        self.assertIn("which another build of this program wrote", self.run_ok(*resume, "--accept-other-build").stdout)
        mixed = self.manifest("run")
        self.assertEqual(mixed["fingerprint"], first["fingerprint"])
        self.assertEqual(mixed["code"], first["code"])
        self.assertNotEqual(mixed["continued"][0]["code"], first["code"])
        self.assertEqual(mixed["continued"][0]["other_build"], "accepted")
        self.assertIn(
            "2 different builds made these runs", self.run_ok(TROPHIC, "analyze", "run", "--out", "mixed").stderr
        )
        self.run_ok(OWN_RULE_3, *KINEMATIC, "--duration", 120, "--out", "run", "--resume")
        self.assertEqual(len({program["code"] for program in self.manifest("run")["continued"]}), 1)
        self.assertNotIn("other_build", self.manifest("run")["continued"][1])

    def test_runs_of_two_builds_are_not_pooled_unless_that_is_accepted(self):
        for name, program, seed in (("one", OWN_RULE_1, 1), ("three", OWN_RULE_3, 2)):
            self.run_ok(program, *KINEMATIC, "--duration", 40, "--seed", seed, "--out", name)
        said = self.refused(2, TROPHIC, "analyze", "one", "three", "--out", "pooled")
        self.assertIn("three: made by ", said)
        done = self.run_ok(TROPHIC, "analyze", "one", "three", "--accept-other-build", "--out", "pooled")
        self.assertIn("2 different builds made these runs", done.stderr)
        runs = json.loads((self.folder / "pooled/summary.json").read_text())["sets"][0]["runs"]
        self.assertEqual([run["builds"] for run in runs], [[self.manifest(name)["code"]] for name in ("one", "three")])

    def test_a_set_is_not_made_by_two_builds_unless_that_is_accepted(self):
        command = (*KINEMATIC, "--duration", 40, "--out", "set", "--replicates")
        self.run_ok(OWN_RULE_1, *command, 1)
        self.assertIn("set/replicate-00/manifest.json: code = ", self.refused(2, OWN_RULE_3, *command, 2, "--resume"))
        self.run_ok(OWN_RULE_3, *command, 2, "--resume", "--accept-other-build")
        self.assertIn("made by", self.refused(2, TROPHIC, "analyze", "set", "--out", "pooled"))

    def test_a_run_does_not_begin_at_a_moment_of_another_build_unless_that_is_accepted(self):
        self.run_ok(OWN_RULE_1, *KINEMATIC, "--duration", 40, "--out", "run")
        begin = (OWN_RULE_3, "--from", "run", "--at", 20, "--seed", 9, "--duration", 60, "--out", "new")
        self.run_ok(*begin, "--accept-other-build")
        self.assertEqual(self.manifest("new")["origin"]["code"], self.manifest("run")["code"])

    def test_a_sweep_is_not_made_by_two_builds_unless_that_is_accepted(self):
        (self.folder / "sweep.toml").write_text(
            'engine = "kinematic"\nreplicates = 2\nreplay_hz = 5.0\n[set]\necology.duration_s = 40.0\n'
            "[grid]\nrules.mutation.sd = [0.05]\n"
        )
        command = planned(OWN_RULE_1, "sweep.toml", "out", self.folder)[1:]
        self.run_ok(OWN_RULE_1, *command)
        self.run_ok(OWN_RULE_3, *command)  # there is nothing to do
        shutil.rmtree(next((self.folder / "out").glob("cell-*/replicate-01")))
        self.assertIn("replicate-00/manifest.json: code = ", self.refused(2, OWN_RULE_3, *command))
        self.run_ok(OWN_RULE_3, *command, "--accept-other-build")
        self.assertIn("--accept-other-build", self.refused(2, TROPHIC, "analyze", "out", "--out", "new"))
        self.assertIn(
            "2 different builds made these runs",
            self.run_ok(TROPHIC, "analyze", "out", "--accept-other-build", "--out", "new").stderr,
        )


ROBOGEN = """0 CoreComponent Core 0
\t0 ActiveHinge Hip1 1
\t\t0 FixedBrick Leg1 1
\t\t\t0 ActiveHinge Knee1 0
\t\t\t\t0 FixedBrick Foot1 0
\t\t\t2 FixedBrick Side1 0
\t1 ActiveHinge Hip2 0
\t2 I Hip3 0
\t\t0 F Leg3 3

Hip1 Hip2 0.5
"""


def robogen_result(text):
    """The JSON that RoboGen writes of a body that it reads as text."""
    parts, connections, above = [], [], []
    for line in text.split("\n\n")[0].splitlines():
        (slot, kind, name, turns), depth = line.split(), line.count("\t")
        parts.append({"id": name, "type": kind, "root": depth == 0, "orientation": int(turns)})
        if depth:
            connections.append(
                {"src": above[depth - 1], "dest": name, "srcSlot": int(slot) + (depth > 1), "destSlot": 0}
            )
        above[depth:] = [name]
    return {"id": 1, "body": {"part": parts, "connection": connections}, "brain": {"neuron": []}}


REVOLVE = """---
id: bot  # a comment
body:
  id          : Core
  type        : Core
  children    :
    0:
      slot        : 0
      id          : Back
      type        : ActiveHinge
      orientation : 90
      children:
        1:
          id: BackLeg
          type: FixedBrick
          orientation: -90
          params: {blue: 1,
            green: 0}
          children:
            2: {id: none}
    2:
      id: 'Right'
      type: FixedBrick
brain:
  - weights: [0.1, 0.2]
"""
REVOLVE2 = {
    "type": "core",
    "children": {
        "front": {"type": "active_hinge", "rotation": 1.5707963267948966, "children": [{"type": "brick"}]},
        "2": {"type": "brick", "children": {"1": None, "left": {"type": "hinge"}}},
    },
}


class Converted(Hostile):
    """Bodies in the formats of RoboGen, Revolve and revolve2."""

    def converted(self, name, text):
        (self.folder / name).write_text(text)
        (self.folder / "robot.toml").unlink(missing_ok=True)
        said = self.run_ok(TROPHIC, "convert", name, "--out", "robot.toml", "--name", "bot").stdout
        with open(self.folder / "robot.toml", "rb") as file:
            robot = tomllib.load(file)
        self.run_ok(
            PREDATOR_PREY,
            "--robots",
            2,
            "--set",
            "rules.community.predators=1",
            "--backend",
            "kinematic",
            "--robot",
            "./robot.toml",
            "--print-config",
        )
        return said, {name: value for name, value in robot.items()}

    def modules(self, tree):
        """(module, quarter turns, below) by face."""
        return {
            face: (below["module"], below["rotation_deg"] // 90, self.modules(below))
            for face, below in tree.items()
            if isinstance(below, dict)
        }

    def test_robogen(self):
        said, robot = self.converted("body.txt", ROBOGEN)
        self.assertEqual(self.converted("result.json", json.dumps(robogen_result(ROBOGEN)))[1], robot)
        self.assertRegex(
            said,
            "4 hinges, 4 bricks, from RoboGen's text.*\nslot 0, which RoboGen calls left, is on the right of its front",
        )
        self.assertEqual(robot["name"], "bot")
        # Hips on the core's sides whose axis is turned by 90 degrees, and on its front as it is, sweep; bricks lie flat.
        modules = self.modules(robot["core"])
        self.assertEqual(set(modules), {"right", "left", "front"})
        hinge, turns, below = modules["right"]
        self.assertEqual(below["front"][:2], ("brick", (-turns) % 4))
        self.assertEqual(
            {face: (kind, turned % 2) for face, (kind, turned, _) in below["front"][2].items()},
            {"front": ("hinge", 0), "left": ("brick", 0)},
        )
        self.assertEqual(
            (modules["left"], hinge, turns % 2, modules["front"][0], modules["front"][1] % 2),
            (("hinge", 0, {}), "hinge", 1, "hinge", 1),
        )

    def test_revolve(self):
        text = REVOLVE.replace("2: {id: none}", "2:")
        for form in (
            text,
            text.replace("type:", "type :").replace("children:", "children  :"),
            text.replace("id: 'Right'", "{id: 'Right',").replace("Brick\nbrain", "Brick}\nbrain"),
        ):
            _, robot = self.converted("body.yaml", form)
            self.assertEqual(
                self.modules(robot["core"]),
                {"back": ("hinge", 1, {"front": ("brick", 3, {})}), "right": ("brick", 0, {})},
            )

    def test_revolve_part_attached_by_another_slot_is_turned_round(self):
        text = REVOLVE.replace("params: {blue: 1,\n            green: 0}", "slot: 1\n          label: ''").replace(
            "2: {id: none}", "2: {id: Far, type: ActiveHinge, slot: 1, children: {0: {id: End, type: FixedBrick}}}"
        )
        said, robot = self.converted("body.yaml", text)
        self.assertIn(
            "turned around, because they are attached by their far end there: ActiveHinge Far (line 20)", said
        )
        self.assertEqual(
            self.modules(robot["core"])["back"],
            ("hinge", 1, {"front": ("brick", 3, {"left": ("hinge", 0, {"front": ("brick", 0, {})})})}),
        )

    def test_parts_that_carry_nothing_are_left_out_with_their_lines(self):
        more = ROBOGEN.replace(
            "\n\nHip1", "\n\t\t\t1 B Rod 0 0.02 45 0\n\t\t\t\t0 IrSensor Eye 0\n\t3 ActiveWheel W 0 0.04\n\nHip1"
        )
        eye = json.dumps(REVOLVE2, indent="\t").replace("null", '{"type": "sensor", "id": "Eye"}')
        for name, text, plain, left in (
            ("body.txt", more, ROBOGEN, "B Rod (line 10), ActiveWheel W (line 12)"),
            ("body.json", eye, json.dumps(REVOLVE2), "sensor Eye (line 16)"),
        ):
            said, robot = self.converted(name, text)
            self.assertIn("omitted, because trophic does not have it: " + left, said)
            self.assertEqual(robot, self.converted(name, plain)[1])

    def test_revolve2(self):
        expected = {
            "front": ("hinge", 1, {"front": ("brick", 0, {})}),
            "back": ("brick", 0, {"left": ("hinge", 0, {})}),
        }
        _, robot = self.converted("body.json", json.dumps(REVOLVE2))
        self.assertEqual(self.modules(robot["core"]), expected)
        yaml = (
            "type: core\nchildren:\n  front:\n    type: active_hinge\n    rotation: 1.5708\n    children: {attachment: {type: brick}}\n"
            "  back: {type: brick, children: {left: {type: hinge}}}\n"
        )
        self.assertEqual(self.modules(self.converted("body.yaml", yaml)[1]["core"]), expected)

    def test_the_spider_is_the_one_of_the_models(self):
        legs = {
            face: {"type": "hinge", "rotation": turn, "children": {"attachment": {"type": "brick"}}}
            for face, turn in (("front", 0.0), ("back", 1.57079632679), ("left", 0.0), ("right", 1.57079632679))
        }
        _, robot = self.converted("spider.json", json.dumps({"type": "core", "children": legs}))
        with open(pathlib.Path(__file__).resolve().parents[2] / "models/robots/spider.toml", "rb") as file:
            spider = tomllib.load(file)["core"]
        for leg in spider.values():
            leg["front"].setdefault("rotation_deg", 0)
        self.assertEqual(robot["core"], spider)

    def test_what_is_not_such_a_body_is_refused_in_one_sentence(self):
        deep = {"type": "hinge"}
        for _ in range(40):
            deep = {"type": "hinge", "children": {"front": deep}}
        for text, sentence in (
            ('<robot name="two"/>', "is URDF: must be a body of revolve2 or Revolve"),
            ("no body", "is in an unknown format"),
            (
                "0 CoreComponent Core 0\n\t0 ActiveWheel W 0 0.04\n",
                ":1: Core: has no hinge without ActiveWheel W (line 2), which trophic does not have",
            ),
            (
                "0 CoreComponent Core 0\n\t0 ParametricJoint J 0 0.02 0 0\n\t\t0 ActiveHinge H 0\n",
                ":2: J: is of type ParametricJoint: must be a core, an active hinge or a brick, because it carries ActiveHinge H (line 3)",
            ),
            *(
                (json.dumps(robogen_result(ROBOGEN)).replace(right, wrong), sentence)
                for right, wrong, sentence in (
                    ('"src": "Core"', '"src": "X"', 'src = "X": is not the id of a part'),
                    ("true", "false", 'no part has "root": true'),
                    ('"src": "Leg1"', '"src": "Foot1"', "Knee1: is not attached to the root"),
                )
            ),
            ("<!-- <mujoco> -->\n<sdf/>", "is SDF: must be"),
            ("Fitness: 99", "is YAML without body or type: must be a body"),
            ("0 CoreComponent Core 0\n\t4 ActiveHinge H 0\n", ':2: H: place = "4": a core has no such place'),
            ("0 CoreComponent Core 0\n\t\t0 ActiveHinge H 0\n", ":2: H: 2 tabs: must be 1 to 1"),
            ("0 CoreComponent Core 0\n\t0 ActiveHinge H 4\n", ":2: H: turns = 4: must be 0 to 3"),
            (
                "0 CoreComponent Core 0\n\t0 ActiveHinge H 0\n\t0 ActiveHinge I 0\n",
                ":3: I: right: two modules on one face",
            ),
            (
                "0 CoreComponent Core 0\n\t0 ActiveHinge H\x1b[2J 0\n",
                ":2: its name must be text without control characters",
            ),
            (
                "0 CoreComponent Core 0\n\t0 ActiveHinge H 99999999999999999999\n",
                ':2: H: turns = "99999999999999999999": must be one digit',
            ),
            ("0 CoreComponent Core 0\n\tx ActiveHinge H 0\n", ':2: H: slot = "x": must be one digit'),
            ("0 CoreComponent Core 0\n\t0 ActiveHinge H\udcff 0\n", ":2: its name must be UTF-8"),
            ("0 CoreComponent Core 0\n", "body: has only a core: must have a hinge or a brick"),
            (REVOLVE, ":20: none: type: missing"),
            (REVOLVE.replace("{id: none}", "none"), ":14: core.0.1.2: must be a module with a type"),
            (
                REVOLVE.replace("2: {id: none}", "2:").replace("orientation : 90", "orientation : 45"),
                ":8: Back: orientation = 45: must be a multiple of 90 degrees",
            ),
            (
                REVOLVE.replace("orientation : 90", "rotation : 90"),
                ":8: Back: rotation: is an unknown key here; orientation turns",
            ),
            (
                REVOLVE.replace("type        : ActiveHinge", "type        : *x"),
                ":10: the referenced anchor is not defined",
            ),
            (REVOLVE.replace("      id: 'Right'", "     id: 'Right'"), ":23: end of map not found"),
            (REVOLVE.replace("    2:\n      id: 'R", "    0:\n      id: 'R"), ":21: 0: appears twice"),
            *(
                (REVOLVE.replace("{id: none}", "[" * depth + "]" * depth), ":20: nested more than 128 deep")
                for depth in (200, 20000)
            ),
            (
                REVOLVE.replace("{id: none}", "{" + ", ".join(f"k{i}: 0" for i in range(101)) + "}"),
                ":20: more than 100 keys",
            ),
            (
                REVOLVE.replace(
                    "{id: none}",
                    "[&a [x], "
                    + ", ".join(f"&{b} [{', '.join(['*' + a] * 9)}]" for a, b in zip("abcdef", "bcdefg"))
                    + "]",
                ),
                ": more than 100000 values",
            ),
            (REVOLVE.replace("{id: none}", "&a [*a]"), ":20: nested more than 128 deep"),
            (
                json.dumps({"type": "core", "children": {"front": {"type": "hinge", "rotation": 1.0}}}),
                ":1: core.front: rotation = 1.0: must be a multiple",
            ),
            (
                json.dumps({"type": "core", "children": {"top": {"type": "hinge"}}}),
                ':1: core.top: place = "top": a core has no such place',
            ),
            (
                json.dumps({"type": "core", "children": {"front": {"type": "core"}}}),
                ":1: core.front: front: a robot has only one core",
            ),
            (
                json.dumps({"type": "core", "children": {"front": deep}}),
                "is JSON nested more than 64 levels deep, which is refused",
            ),
            ('{"type": "core", "children": {"front": ', "body: [json.exception.parse_error.101] parse error"),
        ):
            with self.subTest(text):
                (self.folder / "body").write_bytes(text.encode(errors="surrogateescape"))
                said = self.refused(2, TROPHIC, "convert", "body", "--out", "robot.toml")
                self.assertIn(sentence, said)
                self.assertNotRegex(said, "[\x00-\x1f\x7f-\x9f]")
                self.assertFalse((self.folder / "robot.toml").exists())

    def test_nothing_is_overwritten(self):
        (self.folder / "body").write_text(ROBOGEN)
        (self.folder / "robot.toml").write_text("mine")
        self.assertIn("robot.toml: exists already", self.refused(2, TROPHIC, "convert", "body", "--out", "robot.toml"))
        self.assertIn("must end in .toml", self.refused(2, TROPHIC, "convert", "body", "--out", "robot"))


BODIES = {
    "mod.xml": (
        '<mujoco model="two"><worldbody><body name="core"><freejoint/></body></worldbody></mujoco>',
        "MJCF, MuJoCo's XML",
    ),
    "mod.urdf": ('<?xml version="1.0"?><robot name="two"><link name="core"/></robot>', "URDF"),
    "body.json": ('{"id": 1, "type": "core", "children": {"front": {"type": "hinge"}}}', "JSON"),
    "robogen.txt": (
        "0 CoreComponent Core 0\n\t0 ActiveHinge HingeA 1\n\t\t0 FixedBrick BrickA 0\n\nHingeA HingeA 0.5\n",
        "RoboGen's text",
    ),
    "robot.yaml": ("---\nid: bot\nbody:\n  id: Core\n  type: Core\n", "YAML"),
}


class Foreign(Hostile):
    def test_robots_of_other_programs_get_a_sentence_that_names_their_format(self):
        for name, (text, format_) in BODIES.items():
            with self.subTest(name):
                (self.folder / name).write_text(text)
                said = self.refused(
                    2, PREDATOR_PREY, *KINEMATIC, "--robot", f"./{name}", "--duration", 4, "--out", "run"
                )
                self.assertIn(
                    f"{name}: is {format_}: must be TOML that describes the robot as a tree of cores, hinges and bricks",
                    said,
                )
                self.assertEqual("trophic convert" in said, name not in ("mod.xml", "mod.urdf"))

    def test_a_number_beyond_its_bound_is_refused(self):
        for number in ("ecology.tick_s=1e18", "ecology.tick_s=3601", "ecology.clock_scale=1000"):
            more = () if "tick" in number else ("--set", "ecology.tick_s=10")
            said = self.refused(2, PREDATOR_PREY, *KINEMATIC, "--set", number, *more, "--duration", 1e8, "--out", "run")
            self.assertIn("must", said)
        spider = (pathlib.Path(__file__).resolve().parents[2] / "models/robots/spider.toml").read_text()
        (self.folder / "slippery.toml").write_text("friction = 100\n" + spider)
        said = self.refused(2, PREDATOR_PREY, *KINEMATIC, "--robot", "./slippery.toml", "--duration", 4, "--out", "run")
        self.assertIn("friction = 100", said)

    def test_a_height_field_without_a_rim_is_refused(self):
        for rim, refused in (("0", True), ("5", False)):
            edge = f"[{rim}, {rim}, {rim}, {rim}]"
            (self.folder / "field.toml").write_text(
                f'name = "field"\nhalf_extent_m = 30\nheight_m = [{edge}, [5, 0, 0, 5], [5, 0, 0, 5], {edge}]\n'
            )
            words = (PREDATOR_PREY, *KINEMATIC, "--set", "ecology.arena=./field.toml", "--duration", 4, "--out", "run")
            if refused:
                self.assertIn("height_m: must be higher at its edge than anywhere inside", self.refused(2, *words))
            else:
                self.run_ok(*words)

    def test_a_time_has_no_exponent_and_a_tick_of_0_7_s_comes_on_time(self):
        self.run_ok(
            PREDATOR_PREY,
            *KINEMATIC,
            "--set",
            "ecology.tick_s=2500",
            "--set",
            "ecology.control_hz=1",
            "--duration",
            105000,
            "--out",
            "long",
        )
        for name in ("agents.csv", "events.csv"):
            times = {line.split(",")[0] for line in (self.folder / "long" / name).read_text().splitlines()[1:]}
            self.assertFalse([time for time in times if "e" in time], name)
        self.assertIn("\n100000,40,", (self.folder / "long/agents.csv").read_text())
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--set", "ecology.tick_s=0.7", "--duration", 2.1, "--out", "short")
        times = [line.split(",")[0] for line in (self.folder / "short/agents.csv").read_text().splitlines()[1:]]
        self.assertEqual(sorted(set(times)), ["0", "0.7", "1.4", "2.1"])

    def test_nothing_of_a_manifest_moves_the_cursor(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 40, "--out", "run")
        whole = (self.folder / "run/manifest.json").read_text()
        for key in ("rule_table", "backend", "status", "fingerprint", "trophic", "source_revision", "arena", "params"):
            for escape in ("\x1b[2J", "\u009b2J", "\x07", "\x7f", "a\nb"):
                with self.subTest(key=key, escape=escape):
                    manifest = json.loads(whole)
                    if isinstance(manifest[key], dict):
                        manifest[key][f"key{escape}"] = 1
                    else:
                        manifest[key] = f"{manifest[key]}{escape}"
                    (self.folder / "run/manifest.json").write_text(sealed_text(manifest))
                    for command in (("analyze", "run", "--out", "new"), ("cite", "run")):
                        said = self.refused(2, TROPHIC, *command)
                        self.assertIn("without control characters", said)
                        self.assertNotRegex(said, "[\x00-\x1f\x7f-\x9f]")

    def test_nothing_of_a_list_of_replicates_moves_the_cursor(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 4, "--replicates", 2, "--out", "set")
        listed = json.loads((self.folder / "set/replicates.json").read_text())
        listed["replicates"][1]["folder"] = "replicate-01\x1b[2J"
        (self.folder / "set/replicates.json").write_text(sealed_text(listed))
        self.assertIn("without control characters", self.refused(2, TROPHIC, "analyze", "set", "--out", "new"))

    def test_a_pipe_in_the_place_of_a_file_is_not_waited_for(self):
        self.run_ok(PREDATOR_PREY, *KINEMATIC, "--duration", 8, "--replay-hz", 5, "--out", "run")
        for name in (*FILES, "manifest.json"):
            whole = self.folder / "run" / name
            with self.subTest(name):
                whole.rename(self.folder / "kept")
                os.mkfifo(whole)
                self.assertIn(
                    f"run/{name}: is not a regular file", self.refused(2, TROPHIC, "analyze", "run", "--out", "new")
                )
                if name in ("events.csv", "agents.csv", "replay.trp", "manifest.json"):
                    self.assertIn(
                        f"run/{name}: is not a regular file",
                        self.refused(2, TROPHIC, "show", "run", "--out", "page.html"),
                    )
                if name != "manifest.json":
                    said = self.refused(
                        1, PREDATOR_PREY, *KINEMATIC, "--replay-hz", 5, "--duration", 12, "--out", "run", "--resume"
                    )
                    self.assertIn(f"run/{name}: it is not a regular file", said)
                whole.unlink()
                (self.folder / "kept").rename(whole)


if __name__ == "__main__":
    unittest.main()
