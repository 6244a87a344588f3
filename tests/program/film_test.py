#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""film_test.py PREDATOR_PREY TROPHIC OWN_BODIES: pictures and films of a recorded run, and bad requests."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import time
import unittest

import system_python

system_python.need("numpy", "PIL")

import numpy  # noqa: E402
from in_folder import InFolderWithSets, run_ok  # noqa: E402
from PIL import Image  # noqa: E402

PROGRAM, TROPHIC, OWN_BODIES = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
BLUE, ORANGE, RED = (0, 114, 178), (213, 94, 0), (194, 0, 46)


def near(picture, colour, reach=70):
    """How many pixels are near a colour: lit surfaces are a little darker."""
    return int((numpy.abs(picture.astype(int) - colour).sum(axis=-1) < reach).sum())


class Films(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        run_ok(PROGRAM, "--backend", "kinematic", "--duration", 200, "--seed", 3, "--out", cls.sets / "run")
        for modules in (3, 14):
            run_ok(
                OWN_BODIES,
                "--duration",
                4,
                "--seed",
                3,
                "--set",
                f"rules.body_plan.first_modules={modules}",
                "--out",
                cls.sets / f"bodies-{modules}",
            )

    def film(self, *arguments, run="run", **how):
        return self.call(TROPHIC, "film", self.sets / run, *arguments, **how)

    def draw(self, *arguments, run="run"):
        result = self.film(*arguments, "-o", "picture.png", run=run)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        picture = numpy.array(Image.open(self.folder / "picture.png"))
        (self.folder / "picture.png").unlink()
        return picture

    def rows_at(self, time_s):
        return [row for row in self.rows(self.sets, "run/agents.csv") if float(row["time_s"]) == time_s]

    def test_a_picture_has_both_species_and_changes_with_time(self):
        picture = self.draw("--from", 100, "--size", "640x360")
        self.assertEqual(picture.shape, (360, 640, 3))
        self.assertGreater(near(picture, BLUE, 90), 30)
        self.assertGreater(near(picture, ORANGE, 90), 30)
        self.assertTrue((picture[0, 0] == 255).all())
        self.assertGreater((picture != self.draw("--from", 140, "--size", "640x360")).mean(), 0.001)
        self.assertTrue((picture == self.draw("--from", 100, "--size", "640x360")).all())

    def test_the_followed_robot_is_in_the_middle(self):
        for species, colour in (("prey", BLUE), ("predator", ORANGE)):
            row = next(row for row in self.rows_at(100.0) if row["species"] == species and row["active"] == "1")
            picture = self.draw("--from", 100, "--follow", row["id"], "--size", "640x480")
            self.assertGreater(near(picture[200:280, 270:370], colour, 110), 400, species)

    def test_from_above_robots_are_at_their_rows_positions(self):
        picture = self.draw("--from", 100, "--view", "top", "--size", "800x800", "--legend", "off").astype(int)
        half = self.manifest(self.sets, "run")["arena"]["half_side_m"]
        # The camera is 3.255 half sides high and sees 38 degrees.
        scale = 400 / (3.255 * half * numpy.tan(numpy.radians(19)))
        for row in self.rows_at(100.0):
            near_wall = max(abs(float(row["x_m"])), abs(float(row["y_m"]))) > 0.9 * half
            if row["active"] == "0" or near_wall:
                continue
            x, y = int(400 + scale * float(row["x_m"])), int(400 - scale * float(row["y_m"]))
            part = picture[max(0, y - 8) : y + 9, max(0, x - 8) : x + 9]
            self.assertGreater(near(part, BLUE if row["species"] == "prey" else ORANGE, 110), 4, row)

    def draw_robot(self, *arguments):
        result = self.call(TROPHIC, "film", *arguments, "-o", "robot.png")
        self.assertEqual((result.returncode, result.stderr, result.stdout), (0, "", "robot.png: 1 picture\n"))
        picture = numpy.array(Image.open(self.folder / "robot.png"))
        (self.folder / "robot.png").unlink()
        return picture

    def test_a_robot_file_as_a_picture(self):
        spider = self.draw_robot("--robot", "spider", "--size", "640x480", "--view", "top", "--legend", "off")
        self.assertGreater(near(spider[200:280, 270:370], BLUE, 110), 1000)  # its core in the middle
        turned = numpy.rot90(spider[:, 80:560])
        self.assertLess(
            numpy.abs(near(turned[:, 240:], BLUE, 110) / near(turned[:, :240], BLUE, 110) - 1), 0.4
        )  # four legs alike
        gecko = self.draw_robot(
            "--robot",
            pathlib.Path(__file__).parents[2] / "models/robots/gecko.toml",
            "--size",
            "640x480",
            "--legend",
            "off",
        )
        self.assertGreater(
            (gecko != self.draw_robot("--robot", "spider", "--size", "640x480", "--legend", "off")).any(axis=-1).mean(),
            0.02,
        )
        for arguments, sentence in (
            (["--robot", "no_such", "-o", "x.png"], "robot"),
            (["--robot", "spider", "-o", "x.mp4"], "--out x.mp4: must end in .png with --robot"),
            (["--robot", "spider", "--catch", "1", "-o", "x.png"], "--robot: not with --from"),
            (["--robot", "spider", str(self.sets / "run"), "-o", "x.png"], "--robot: not with a run"),
            (["-o", "x.png"], "needs either the folder of a run, or --robot with a robot file"),
        ):
            with self.subTest(arguments):
                result = self.call(TROPHIC, "film", *arguments)
                self.assert_refused(result, sentence)
                self.assertEqual(result.stdout, "")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_individuals_with_bodies_of_their_own(self):
        drawn = []
        for modules in (3, 14):
            founder = next(
                row for row in self.rows(self.sets, f"bodies-{modules}/bodies.csv") if row["species"] == "predator"
            )
            self.assertEqual(int(founder["modules"]), modules)
            picture = self.draw(
                "--from",
                1,
                "--follow",
                founder["id"],
                "--size",
                "640x480",
                "--lines",
                "off",
                "--legend",
                "off",
                run=f"bodies-{modules}",
            )
            drawn.append(near(picture[165:360, 200:440], ORANGE, 110))  # below the name
        self.assertGreater(drawn[1], 1.3 * drawn[0], "14 modules against 3, next to the same ring")

    def test_a_contact_sheet(self):
        sheet = self.draw("--sheet", "3x2", "--from", 20, "--to", 180, "--size", "320x240")
        self.assertEqual(sheet.shape, (2 * 240 + 6, 3 * 320 + 2 * 6, 3))
        cells = [sheet[y : y + 240, x : x + 320] for y in (0, 246) for x in (0, 326, 652)]
        for i, cell in enumerate(cells):
            self.assertGreater(near(cell, BLUE) + near(cell, ORANGE), 8)
            for other in cells[:i]:
                self.assertFalse((cell == other).all())

    def test_a_contact_sheet_cuts_no_corner_of_the_arena(self):
        sheet = self.draw("--sheet", "2x1", "--from", 20, "--to", 180, "--lines", "off")
        for cell in (sheet[:, :480], sheet[:, 486:]):
            rows, columns = numpy.nonzero((cell != 255).any(axis=-1))
            self.assertGreater(columns.min(), 2)
            self.assertLess(columns.max(), 477)
            wall = (cell.astype(int).sum(axis=-1) < 690) & (numpy.arange(360)[:, None] < 330)  # above the caption
            self.assertGreater(numpy.nonzero(wall)[0].min(), 2)

    def catches(self):
        rows = self.rows(self.sets, "run/events.csv")
        lives = {row["id"]: row for row in rows if row["event"] == "birth"}
        return [(row, lives[row["victim_id"]]) for row in rows if row["event"] == "catch"]

    def test_a_catch_shows_both_and_its_own_mark(self):
        count = len(self.catches())
        self.assertGreater(count, 0)
        picture = self.draw("--catch", 1, "--size", "640x480", "--lines", "off")
        middle = picture[100:420]  # without the legend
        self.assertGreater(near(middle, BLUE, 110), 150)  # the victim is still in its body
        self.assertGreater(near(middle, ORANGE, 110), 150)
        self.assertGreater(near(middle, RED), 300)
        row, _ = self.catches()[0]
        before = self.draw(
            "--from", float(row["time_s"]) - 1, "--follow", row["id"], "--size", "640x480", "--lines", "off"
        )
        self.assertLess(near(before[100:420], RED), 30)
        self.assert_refused(
            self.film("--catch", count + 1, "-o", "x.png"), f"has {count} catches" if count > 1 else "has one catch"
        )

    def test_the_best_catch_has_whole_lives_before_it_and_is_named(self):
        result = self.film("--catch", "best", "--sheet", "2x2", "--size", "320x240", "-o", "strip.png")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        pattern = r"strip.png: 4 pictures; at ([\d.]+) s predator (\d+) catches prey (\d+): \w+, lived \d+ s\n"
        time_s, hunter, victim = re.fullmatch(pattern, result.stdout).groups()  # without a remark
        caught, life = next(
            (row, life) for row, life in self.catches() if (row["id"], row["victim_id"]) == (hunter, victim)
        )
        self.assertEqual(float(caught["time_s"]), float(time_s))
        self.assertLessEqual(float(life["time_s"]), float(time_s) - 8)
        sheet = numpy.array(Image.open(self.folder / "strip.png"))
        self.assertEqual(sheet.shape, (2 * 240 + 6, 2 * 320 + 6, 3))
        reds = [near(sheet[y : y + 240, x : x + 320], RED) for y in (0, 246) for x in (0, 326)]
        self.assertLess(max(reds[:2]), 20)
        self.assertGreater(min(reds[2:]), 100)

    def test_legend_lines_and_title_can_be_left_out(self):
        arguments = ("--from", 100, "--size", "640x360")
        whole = self.draw(*arguments)
        bare = self.draw(*arguments, "--legend", "off", "--lines", "off")
        self.assertGreater(int((whole[:30] != 255).any(axis=-1).sum()), 300)
        self.assertEqual(int((bare[:9] != 255).any(axis=-1).sum()), 0)
        self.assertGreater(
            int((whole != bare).any(axis=-1).sum()), int((whole[:30] != bare[:30]).any(axis=-1).sum()) + 100
        )

    @unittest.skipUnless(shutil.which("ffmpeg"), "no ffmpeg")
    def test_a_film_of_a_catch_stands_still_at_it(self):
        for name, codec in (("catch.gif", "gif"), ("catch.webm", "vp9")):
            result = self.film("--catch", 1, "--fps", 5, "--size", "320x180", "-o", name)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            pictures = f"{name}: {11 * 5 + 1 + 6} pictures, 12.4 s; "  # 8 s before, 3 s after, 1.2 s still
            self.assertTrue(result.stdout.startswith(pictures), result.stdout)
            asked = ["ffprobe", "-v", "error", "-show_entries", "stream=codec_name,width", "-of", "json", name]
            stream = json.loads(self.run_ok(*asked).stdout)["streams"][0]
            self.assertEqual((stream["codec_name"], stream["width"]), (codec, 320))

    @unittest.skipUnless(shutil.which("ffmpeg"), "no ffmpeg")
    def test_a_minute_at_its_own_speed_lasts_a_minute(self):
        result = self.film("--from", 60, "--to", 120, "--speed", 1, "--fps", 2, "--size", "64x36", "-o", "minute.mp4")
        self.assertEqual(
            (result.returncode, result.stderr, result.stdout), (0, "", "minute.mp4: 121 pictures, 60.5 s\n")
        )

    @unittest.skipUnless(shutil.which("ffmpeg"), "no ffmpeg")
    def test_a_film(self):
        result = self.film("--from", 50, "--to", 60, "--speed", 10, "--fps", 10, "--size", "320x180", "-o", "film.mp4")
        self.assertEqual((result.returncode, result.stderr, result.stdout), (0, "", "film.mp4: 11 pictures, 1.1 s\n"))
        asked = [
            "ffprobe",
            "-v",
            "error",
            "-count_frames",
            "-show_entries",
            "stream=width,height,nb_read_frames,codec_name",
            "-of",
            "json",
        ]
        stream = json.loads(self.run_ok(*asked, "film.mp4").stdout)["streams"][0]
        self.assertEqual(
            (stream["codec_name"], stream["width"], stream["height"], stream["nb_read_frames"]),
            ("h264", 320, 180, "11"),
        )

    def test_a_killed_film_leaves_no_file(self):
        arguments = ["--size", "320x180", "--to", "100", "-o", "film.mp4"]
        program = subprocess.Popen(
            [TROPHIC, "film", str(self.sets / "run"), *arguments], cwd=self.folder, stderr=subprocess.DEVNULL
        )
        part = self.folder / "film.mp4.part"
        while not (part.exists() and part.stat().st_size > 0) and program.poll() is None:
            time.sleep(0.001)
        program.kill()
        program.wait()
        self.assertEqual([path.name for path in self.folder.iterdir()], ["film.mp4.part"])
        self.run_ok(TROPHIC, "film", self.sets / "run", *arguments)  # while the other's ffmpeg still finishes
        self.assertEqual([path.name for path in self.folder.iterdir()], ["film.mp4"])

    def test_without_ffmpeg(self):
        result = self.film("--to", 2, "-o", "film.mp4", env={"PATH": "/nowhere"})
        self.assertEqual(result.returncode, 1)
        self.assertEqual(
            result.stderr,
            "trophic film: ffmpeg cannot be started: No such file or directory; apt-get install ffmpeg, or name a .png\n",
        )
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_events_of_another_run(self):
        shutil.copytree(self.sets / "run", self.folder / "run")
        events = (self.folder / "run/events.csv").read_text().splitlines(keepends=True)
        (self.folder / "run/events.csv").write_text("".join([*events[:-1], events[-1].replace(",", ",9", 2)]))
        result = self.call(TROPHIC, "film", "run", "-o", "x.png")
        self.assertEqual((result.returncode, result.stdout, (self.folder / "x.png").exists()), (2, "", False))
        self.assertRegex(
            result.stderr, r"^trophic film: run/events.csv: has checksum \d+: must be \d+, as its manifest says; .*\n$"
        )

    def test_refusals(self):
        (self.folder / "mine.png").write_text("mine")
        for arguments, sentence in (
            (["-o", "mine.png"], "--out mine.png: exists already; files are never overwritten"),
            (["-o", "x.avi"], "--out x.avi: must end in .png, .mp4, .webm or .gif"),
            (["-o", "x.png", "--from", "201"], "time 201 s: must be between 0 and 200"),
            (["-o", "x.mp4", "--from", "20", "--to", "10"], "--from 20: must be <= --to, 10"),
            (
                ["-o", "x.png", "--from", "10", "--follow", "9999"],
                "--follow 9999: no individual with this id lives between 10 and 10 s",
            ),
            (["-o", "x.png", "--size", "639x360"], "width = 639: must be even, >= 16 and <= 4096"),
            (
                ["-o", "x.png", "--size", "big"],
                "--size big: must be two whole numbers such as 4x3, each from 1 to 4096",
            ),
            (
                ["-o", "x.png", "--sheet", "0x3"],
                "--sheet 0x3: must be two whole numbers such as 4x3, each from 1 to 20",
            ),
            (["-o", "x.mp4", "--sheet", "2x2"], "--sheet: needs --out with .png"),
            (["-o", "x.png", "--view", "left"], "--view left: must be orbit or top"),
            (["-o", "x.png", "--lines", "some"], "--lines some: must be on or off"),
            (["-o", "x.png", "--catch", "0"], "--catch 0: must be best, or a number from 1"),
            (["-o", "x.png", "--catch", "9999"], "--catch 9999: "),
            (["-o", "x.png", "--catch", "1", "--follow", "3"], "--catch: not with --from, --to or --follow"),
            (["-o", "x.mp4", "--speed", "0"], "--speed 0: must be > 0 and <= 10000"),
        ):
            with self.subTest(arguments):
                result = self.film(*arguments)
                self.assert_refused(result, f"trophic film: {sentence}")
                self.assertEqual(result.stdout, "")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["mine.png"])
        self.assertEqual((self.folder / "mine.png").read_text(), "mine")
        result = self.film("-o", "none/x.png")
        self.assertEqual(
            (result.returncode, result.stderr),
            (1, "trophic film: cannot create none/x.png: No such file or directory\n"),
        )


if __name__ == "__main__":
    unittest.main()
