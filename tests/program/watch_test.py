#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""watch_test.py PREDATOR_PREY WITHOUT_WINDOW OWN_BODIES: a run in a window: keys, mouse and picture; its files are those of a run without a window."""

import csv
import json
import math
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

import system_python
import virtual_screen

system_python.need("numpy", "PIL")

import numpy  # noqa: E402
from in_folder import InFolderWithSets  # noqa: E402
from PIL import Image  # noqa: E402

PROGRAM, WITHOUT_WINDOW, OWN_BODIES = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
BLUE, ORANGE = (0, 114, 178), (213, 94, 0)
RUN = ["--backend", "kinematic", "--duration", "100", "--seed", "3"]
OWN_RUN = ["--duration", "100", "--seed", "3", "--set", "rules.body_plan.first_modules=6"]


def near(picture, colour, reach=110):
    return int((numpy.abs(picture.astype(int) - colour).sum(axis=-1) < reach).sum())


def files_of(folder):
    """All files but manifest and checkpoint, which contain the command line."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.name not in ("manifest.json", "checkpoint.bin", ".lock")}


class Watched(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        done = subprocess.run([PROGRAM, *RUN, "--out", str(cls.sets / "alone")], capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, done.stderr
        command = [OWN_BODIES, *OWN_RUN, "--out", str(cls.sets / "bodies")]
        subprocess.run(command, capture_output=True, check=True, timeout=300)
        cls.screen = cls.enterClassContext(virtual_screen.VirtualScreen())

    def start(self, *arguments, program=PROGRAM, run=RUN):
        """Starts a watched run and pauses it."""
        command = [program, *run, "--watch", "--out", str(self.folder / "run"), *arguments]
        self.name = f"{'own_bodies' if program == OWN_BODIES else 'trophic-predator-prey'}: "
        self.program = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.screen.environment)
        self.addCleanup(self.program.communicate)
        self.addCleanup(self.program.kill)
        self.id = self.screen.window(self.name, self.program)
        self.screen.xdotool("windowfocus", self.id)
        self.wait_for(r"\d s, 10x")
        self.press("space")
        self.wait_for("paused")

    def press(self, *keys):
        self.screen.xdotool("windowfocus", self.id, "key", *keys)

    def title(self):
        return self.screen.xdotool("getwindowname", self.id).removeprefix(self.name)

    def wait_for(self, pattern, within_s=60):
        for _ in range(20 * within_s):
            title = self.title()
            if re.search(pattern, title):
                return title
            time.sleep(0.05)
        raise AssertionError(f"the title never had {pattern}, it is: {title}")

    def seen_s(self):
        return float(self.title().split(" s")[0])

    def step(self):
        """To the next tick; returns its time."""
        before = self.seen_s()
        self.press("Right")
        expected = 2.0 * (math.floor(before / 2.0 + 1e-6) + 1)
        self.wait_for(rf"^{expected:.1f} s, paused")
        return expected

    def picture(self):
        self.screen.screenshot(self.folder / "screen.png")
        return numpy.array(Image.open(self.folder / "screen.png").convert("RGB"))

    def rows(self, time_s):
        with open(self.sets / "alone/agents.csv", newline="") as table:
            return [row for row in csv.DictReader(table) if float(row["time_s"]) == time_s]

    def ends(self, code):
        out, err = self.program.communicate(timeout=120)
        self.assertEqual(self.program.returncode, code, out + err)
        return out, err

    def check_same_files(self, of="alone"):
        alone, watched = files_of(self.sets / of), files_of(self.folder / "run")
        self.assertEqual(alone.keys(), watched.keys())
        for name in alone:
            self.assertTrue(alone[name] == watched[name], name)
        manifests = [json.loads((folder / "manifest.json").read_text()) for folder in (self.sets / of, self.folder / "run")]
        self.assertEqual(manifests[0]["fingerprint"], manifests[1]["fingerprint"])

    def test_pause_step_click_follow_and_to_the_end(self):
        self.start()
        paused = self.title()
        time.sleep(0.5)
        self.assertEqual(self.title(), paused)
        self.press("t", "h")
        self.step()
        time_s = self.step()
        half = json.loads((self.sets / "alone/manifest.json").read_text())["arena"]["half_side_m"]
        scale = 360 / (3.1 * half * math.tan(math.radians(19)))
        rows = self.rows(time_s)
        places = numpy.array([[float(row["x_m"]), float(row["y_m"])] for row in rows])
        time.sleep(0.5)
        picture = self.picture()
        self.assertTrue((picture[5, 640] > 245).all())  # next to the arena
        for species, colour in (("prey", BLUE), ("predator", ORANGE)):
            alone = [i for i, row in enumerate(rows) if row["species"] == species and row["active"] == "1"]
            body = max(alone, key=lambda i: sorted(numpy.hypot(*(places - places[i]).T))[1])
            x, y = round(640 + scale * places[body][0]), round(360 - scale * places[body][1])
            self.assertGreater(near(picture[y - 9 : y + 10, x - 9 : x + 10], colour), 6, species)
            self.screen.xdotool("mousemove", "--window", self.id, x, y, "click", 1)
            self.wait_for(rf"^{time_s:.1f} s, paused, robot {rows[body]['id']}$")
        self.press("f")
        time.sleep(0.5)
        picture = self.picture()
        self.assertGreater(near(picture[300:420, 560:720], ORANGE), 400)
        self.assertLess(picture[20:60, 10:60].mean(), 200)  # the inspector's text, on a dark ground
        self.press("Escape")
        self.wait_for("paused$")
        self.press("space", *["Up"] * 8)
        self.wait_for("^100.0 s, as fast as possible, the run has ended$")
        self.press("q")
        out, err = self.ends(0)
        self.assertIn("files   ", out)
        self.assertEqual(err, "")
        self.check_same_files()

    def test_individuals_with_bodies_of_their_own(self):
        self.start(program=OWN_BODIES, run=OWN_RUN)
        self.press("t", "h")
        self.step()
        time.sleep(0.5)
        picture = self.picture()
        for colour in (BLUE, ORANGE):
            self.assertGreater(near(picture, colour), 40)
        self.press("a", "space", *["Up"] * 8)
        self.wait_for("^100.0 s, as fast as possible, the run has ended$")  # with newborns in bodies of other sizes
        self.press("q")
        self.assertEqual(self.ends(0)[1], "")
        self.check_same_files("bodies")

    def test_the_run_continues_without_its_window(self):
        self.start()
        self.step()
        self.press("q")
        out, _ = self.ends(0)
        self.assertIn("files   ", out)
        self.check_same_files()

    def test_a_signal_stops_a_paused_run_which_can_be_resumed_in_a_window(self):
        self.start()
        self.step()
        self.program.send_signal(signal.SIGINT)
        out, _ = self.ends(3)
        self.assertIn("stopped by signal 2", out)
        self.start("--resume")
        self.press("q")
        self.ends(0)
        self.check_same_files()


class Refusals(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        pass

    def refused(self, sentence, *arguments, program=PROGRAM, environment=None):
        done = subprocess.run([program, *RUN, "--watch", *arguments], capture_output=True, text=True, cwd=self.folder, env=environment, timeout=60)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn(sentence, done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_without_a_screen_nothing_is_run(self):
        for environment in ({}, {"DISPLAY": ":4711"}):
            self.refused("--watch: no window can be opened (", environment=environment)

    def test_only_one_run_can_be_watched(self):
        for arguments in (["--replicates", "2"], ["--save-mjcf", "world.xml"]):
            self.refused("--watch: needs a run, and one only", *arguments)

    def test_a_program_without_a_window_refuses_watch(self):
        self.refused("--watch: this program was built without a window; apt-get install libglfw3-dev", program=WITHOUT_WINDOW)


if __name__ == "__main__":
    if virtual_screen.missing():
        print(f"skipped what needs a screen: {virtual_screen.missing()}")
        del Watched
    unittest.main()
