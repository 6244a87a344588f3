#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""saved_world_test.py PREDATOR_PREY: MuJoCo's own program opens a world that --save-mjcf wrote and shows both species."""

import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree

import system_python

system_python.need("numpy", "PIL")

import numpy  # noqa: E402
from in_folder import InFolder  # noqa: E402
from PIL import Image  # noqa: E402

PROGRAM = sys.argv.pop(1)
BLUE, ORANGE = (0, 114, 178), (213, 94, 0)
NEEDED = ("mujoco-simulate", "Xvfb", "ffmpeg")


class SavedWorld(InFolder):
    def save(self, *arguments):
        return self.call(PROGRAM, "--save-mjcf", "world.xml", *arguments)

    def test_robots_have_the_colours_of_their_species(self):
        self.assertEqual(self.save("--set", "rules.community.predators=7").returncode, 0)
        root = xml.etree.ElementTree.parse(self.folder / "world.xml").getroot()
        cores = [body.find("geom").get("rgba") for body in root.find("worldbody").findall("body")]
        self.assertEqual(sorted(cores.count(colour) for colour in set(cores)), [7, 23])
        self.assertNotIn("collision", root.find("option").attrib)  # MuJoCo 3 refuses it
        self.assertTrue(root.findall(".//light") and root.findall(".//camera"))

    def test_nothing_is_overwritten(self):
        (self.folder / "world.xml").write_text("mine")
        done = self.save()
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(
            done.stderr, "trophic-predator-prey: --save-mjcf world.xml: exists already; files are never overwritten\n"
        )
        self.assertEqual((self.folder / "world.xml").read_text(), "mine")

    def test_a_missing_folder_is_refused(self):
        done = self.call(PROGRAM, "--save-mjcf", "none/world.xml")
        self.assertEqual(
            (done.returncode, done.stderr),
            (1, "trophic-predator-prey: cannot create none/world.xml: No such file or directory\n"),
        )

    def start(self, *command, **how):
        program = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **how)
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        return program

    @unittest.skipUnless(all(map(shutil.which, NEEDED)), "apt-get install libmujoco-samples xvfb ffmpeg")
    def test_simulate_shows_both_species(self):
        reads, writes = os.pipe()
        self.start(
            "Xvfb",
            "-displayfd",
            str(writes),
            "-screen",
            "0",
            "1280x720x24",
            "-nolisten",
            "tcp",
            "-noreset",
            pass_fds=[writes],
        )
        os.close(writes)
        with os.fdopen(reads) as pipe:
            display = f":{pipe.readline().strip()}"
        picture = [
            "ffmpeg",
            "-v",
            "error",
            "-y",
            "-f",
            "x11grab",
            "-video_size",
            "1280x720",
            "-i",
            display,
            "-frames:v",
            "1",
            "screen.png",
        ]
        for arena in ("walled_square", "height_field"):
            with self.subTest(arena):
                pathlib.Path(self.folder / "world.xml").unlink(missing_ok=True)
                self.assertEqual(self.save("--set", f"ecology.arena={arena}").returncode, 0)
                program = self.start(
                    "mujoco-simulate",
                    self.folder / "world.xml",
                    env={**os.environ, "DISPLAY": display},
                    cwd=self.folder,
                )
                deadline = time.monotonic() + 160
                seen = {}
                while time.monotonic() < deadline and (not seen or min(seen.values()) < 10):
                    time.sleep(1)
                    self.assertIsNone(program.poll(), "mujoco-simulate ended")
                    subprocess.run(picture, check=True, timeout=60, capture_output=True, cwd=self.folder)
                    world = numpy.array(Image.open(self.folder / "screen.png").convert("RGB"))[:480, 275:580].astype(
                        int
                    )
                    seen = {
                        colour: int((numpy.abs(world - colour).sum(axis=-1) < 110).sum()) for colour in (BLUE, ORANGE)
                    }
                self.assertGreaterEqual(min(seen.values()), 10, seen)
                program.kill()


if __name__ == "__main__":
    unittest.main()
