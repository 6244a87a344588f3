#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""recording_test.py PREDATOR_PREY TROPHIC: a run's replay.trp as users read it: with the Python package and the code of docs/recording.md."""

import json
import math
import pathlib
import re
import resource
import shutil
import struct
import sys
import unittest
import zlib

import system_python

system_python.need("numpy")

import numpy  # noqa: E402
from in_folder import InFolderWithSets, call, run_ok, sealed_text  # noqa: E402

PROGRAM, TROPHIC = sys.argv.pop(1), sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parents[2]
HAS_MUJOCO = ", mujoco" in call(PROGRAM, "--help").stdout
sys.path.insert(0, str(ROOT / "tools/python"))
from trophic import RecordingError, read_replay  # noqa: E402


class Recordings(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        cls.make("kinematic", "--backend", "kinematic", "--duration", 100)
        cls.make(
            "rewound",
            "--from",
            cls.sets / "kinematic",
            "--at",
            45,
            "--duration",
            80,
            "--seed",
            9,
            "--set",
            "rules.mutation.sd=0.5",
        )
        cls.make("released", "--backend", "kinematic", "--rules", "released", "--duration", 60, "--replay-hz", 10)
        cls.make(
            "begun_anew", "--from", cls.sets / "released", "--at", 20, "--duration", 30, "--seed", 9
        )  # its past is made from the beginning
        if HAS_MUJOCO:
            cls.make("mujoco", "--backend", "mujoco", "--duration", 12, "--threads", 1)

    @classmethod
    def make(cls, name, *options):
        run_ok(PROGRAM, "--out", cls.sets / name, *options)

    def names(self):
        return sorted(path.name for path in self.sets.iterdir())

    def test_frames_at_ticks_are_the_rows_of_agents_csv(self):
        for name in self.names():
            with self.subTest(name):
                recording = read_replay(self.sets / name)
                self.assertTrue(recording.complete)
                per_tick = recording.head["frames_per_tick"]
                rows = self.rows(self.sets, name, "agents.csv")
                frames = numpy.array([int(row["tick"]) * per_tick for row in rows])
                bodies = numpy.array([int(row["body"]) for row in rows])
                self.assertEqual(frames.max() + 1, len(recording.time_s))
                numpy.testing.assert_allclose(
                    recording.time_s[frames], [float(row["time_s"]) for row in rows], atol=1e-9
                )
                place = [[float(row["x_m"]), float(row["y_m"])] for row in rows]
                numpy.testing.assert_allclose(recording.position_m[frames, bodies, :2], place, atol=0.000502)
                numpy.testing.assert_allclose(numpy.linalg.norm(recording.orientation, axis=-1), 1.0, atol=1e-12)
                if name != "mujoco":  # its yaw is the robot's heading
                    w, z = recording.orientation[frames, bodies, 0], recording.orientation[frames, bodies, 3]
                    heading = 2 * numpy.arctan2(z, w) + recording.head["robot"]["forward_rad"]
                    off = heading - [float(row["heading_rad"]) for row in rows]
                    self.assertLess(numpy.abs((off + numpy.pi) % (2 * numpy.pi) - numpy.pi).max(), 0.002)

    def test_rates_of_the_recording(self):
        self.assertEqual(read_replay(self.sets / "kinematic").head["frames_per_tick"], 10)
        steps = numpy.diff(read_replay(self.sets / "released").time_s)
        self.assertEqual(
            read_replay(self.sets / "released").head["clock_scale"] * 10 * 2,
            read_replay(self.sets / "released").head["frames_per_tick"],
        )
        numpy.testing.assert_allclose(steps, steps[0], rtol=0.1)
        self.assertEqual(
            read_replay(self.sets / "begun_anew").head["frames_per_tick"],
            read_replay(self.sets / "released").head["frames_per_tick"],
        )

    def test_a_rewound_run_has_the_frames_of_its_past_and_its_own_identity(self):
        whole, rewound = read_replay(self.sets / "kinematic"), read_replay(self.sets / "rewound")
        manifest = self.manifest(self.sets, "rewound")
        for key in ("fingerprint", "seed"):
            self.assertEqual(rewound.head[key], manifest[key])
            self.assertNotEqual(rewound.head[key], whole.head[key])
        past = whole.time_s <= 46  # the tick at or after --at
        numpy.testing.assert_array_equal(rewound.position_m[: past.sum()], whole.position_m[past])
        self.assertEqual((rewound.time_s[0], rewound.time_s[-1], rewound.complete), (0, 80, True))

    @unittest.skipUnless(HAS_MUJOCO, "needs joints")
    def test_joints_move_as_a_gait_does(self):
        recording = read_replay(self.sets / "mujoco")
        self.assertEqual(recording.joint_rad.shape[2], len(recording.head["robot"]["links"]) - 1)
        self.assertTrue((recording.joint_rad[0] == 0).all())
        self.assertGreater(numpy.ptp(recording.joint_rad, axis=0).min(), 0.1)
        self.assertLess(numpy.abs(recording.joint_rad).max(), 1.6)

    def test_a_part_of_the_frames(self):
        whole, part = read_replay(self.sets / "kinematic"), read_replay(self.sets / "kinematic", 150, 333)
        for name in ("time_s", "position_m", "orientation", "joint_rad"):
            numpy.testing.assert_array_equal(getattr(part, name), getattr(whole, name)[150:333])

    def test_the_code_of_the_document_reads_the_same_frames(self):
        code = re.search(r"```python\n(.*?)```", (ROOT / "docs/recording.md").read_text(), re.S)[1]
        self.assertLessEqual(len(code.splitlines()), 31)
        for name in self.names():
            with self.subTest(name):
                found = {}
                argv, sys.argv = sys.argv, ["read.py", str(self.sets / name / "replay.trp")]
                try:
                    exec(code, found)
                finally:
                    sys.argv = argv
                recording = read_replay(self.sets / name)
                for array in ("position_m", "joint_rad", "orientation"):
                    numpy.testing.assert_allclose(found[array], getattr(recording, array), atol=2e-6)

    def test_damaged_recordings_are_errors(self):
        content = (self.sets / "kinematic" / "replay.trp").read_bytes()
        path = self.folder / "replay.trp"
        for at in (0, 5, 9, 400, len(content) // 2, len(content) - 20):
            with self.subTest(at):
                path.write_bytes(content[:at] + bytes([content[at] ^ 4]) + content[at + 1 :])
                try:
                    self.assertFalse(read_replay(path).complete)
                except RecordingError as error:
                    self.assertIn(f"{path}: ", str(error))
        path.write_bytes(content[: len(content) // 2])
        self.assertFalse(read_replay(path).complete)

    def test_forged_recordings_are_errors_and_take_no_memory(self):
        content = (self.sets / "kinematic" / "replay.trp").read_bytes()
        (size,) = struct.unpack_from("<I", content, 8)
        head = json.loads(content[16 : 16 + size])
        first = content[8 + size + 12 :]
        (first_size,) = struct.unpack_from("<I", first, 0)
        frames = first[8 : 8 + first_size]

        def block(kind, data):
            return struct.pack("<I", len(data)) + kind + data + struct.pack("<I", zlib.crc32(kind + data))

        def with_head(**changes):
            return content[:8] + block(b"HEAD", json.dumps({**head, **changes}).encode()) + first

        def with_frames(data):
            return content[: 8 + size + 12] + block(b"POSE", data)

        bomb = zlib.compressobj()
        packed = b"".join(bomb.compress(bytes(1 << 20)) for _ in range(512)) + bomb.flush()
        forged = {
            "head": content[:8] + block(b"HEAD", b"[") + first,
            "head of no object": content[:8] + block(b"HEAD", b"[1]") + first,
            "head of depth": content[:8] + block(b"HEAD", b"[" * 100000) + first,
            "no head": content[:8] + first,
            "version": with_head(version=3),
            "no bodies": with_head(version=2),
            "robots": with_head(robots=2**31),
            "joints": with_head(joints=2**31),
            "negative": with_head(robots=-1),
            "no robots": with_head(robots=0),
            "fraction": with_head(robots=30.5),
            "far too many": with_head(robots=10**30),
            "text": with_head(frames_per_tick="10"),
            "nothing a tick": with_head(frames_per_tick=0),
            "tick": with_head(tick_s=[2]),
            "units": with_head(units=3),
            "no clock": with_head(first_time_s=math.nan),
            "bomb": with_frames(frames[:8] + packed),
            "no zlib": with_frames(frames[:8] + b"abc"),
            "more frames": with_frames(frames[:4] + b"\xff\xff\xff\xff" + frames[8:]),
            "other frames": with_frames(struct.pack("<I", 7) + frames[4:]),
            "short": with_frames(b"abc"),
        }
        path = self.folder / "replay.trp"
        most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for what, bytes_of_it in forged.items():
            with self.subTest(what):
                path.write_bytes(bytes_of_it)
                with self.assertRaises(RecordingError) as refused:
                    read_replay(path)
                self.assertTrue(str(refused.exception).startswith(f"{path}: "), str(refused.exception))
                self.assertNotIn("\n", str(refused.exception))
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - most, 100_000)  # kB; the bomb is 537 MB


class Pages(InFolderWithSets):
    """`trophic show`, and its errors of one line about bad runs."""

    @classmethod
    def make_sets(cls):
        for name, seed in (("run", 1), ("other", 2)):
            Recordings.make.__func__(cls, name, "--backend", "kinematic", "--duration", 60, "--seed", seed)
        Recordings.make.__func__(cls, "rewound", "--from", cls.sets / "run", "--at", 31, "--duration", 50, "--seed", 3)
        Recordings.make.__func__(
            cls, "rewound_again", "--from", cls.sets / "rewound", "--at", 50, "--duration", 50, "--seed", 4
        )
        Recordings.make.__func__(cls, "sensed", "--backend", "kinematic", "--duration", 60, "--senses")
        Recordings.make.__func__(cls, "unrecorded", "--backend", "kinematic", "--duration", 20, "--replay-hz", 0)
        Recordings.make.__func__(cls, "thinned", "--backend", "kinematic", "--duration", 20, "--agents-every", 2)
        Recordings.make.__func__(cls, "set", "--backend", "kinematic", "--duration", 20, "--replicates", 2)

    def show(self, *arguments):
        return self.call(TROPHIC, "show", *arguments)

    def copy(self, name="run"):
        copied = self.folder / "copy"
        shutil.copytree(self.sets / name, copied)
        return copied

    def refused(self, sentence, *arguments):
        result = self.show(*arguments, "-o", "page.html")
        self.assert_refused(result)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, sentence)
        self.assertFalse((self.folder / "page.html").exists())

    def setUp(self):
        super().setUp()
        if "built without the viewer" in self.show(self.sets / "run", "-o", "probe.html").stderr:
            self.skipTest("built without the viewer")
        (self.folder / "probe.html").unlink()

    def test_a_page_contains_all_its_data(self):
        result = self.show(self.sets / "run", self.sets / "set", "-o", "page.html")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        page = (self.folder / "page.html").read_text()
        self.assertEqual(page.count('data-file="replay"'), 3)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)[^"]*"', page.split("<script>")[0]), [])

    def test_runs_that_began_at_a_moment_of_another_are_shown(self):
        self.assertEqual(self.show(self.sets / "rewound", self.sets / "rewound_again", "-o", "page.html").returncode, 0)
        part = self.show(self.sets / "rewound", "--from", 10, "--to", 20, "-o", "part.html")
        self.assertEqual((part.returncode, part.stderr), (0, ""))

    def test_nothing_is_overwritten(self):
        (self.folder / "page.html").write_text("mine")
        result = self.show(self.sets / "run", "-o", "page.html")
        self.assertEqual(
            (result.returncode, result.stderr),
            (2, "trophic show: --out page.html: exists already; files are never overwritten\n"),
        )
        self.assertEqual((self.folder / "page.html").read_text(), "mine")

    def test_folders_without_a_recorded_run_are_refused(self):
        self.refused(r"none: does not exist", "none")
        self.refused(
            r"unrecorded/replay.trp: does not exist; a run with --replay-hz 0 writes no recording",
            self.sets / "unrecorded",
        )
        self.refused(
            r"thinned/agents.csv: has only ticks that are multiples of 2: must have all ticks to be shown",
            self.sets / "thinned",
        )
        self.refused(r"10 runs: must be <= 9", *[self.sets / "run"] * 10)

    def test_damaged_and_foreign_recordings_are_refused(self):
        run = self.copy()
        content = (run / "replay.trp").read_bytes()
        for damaged, sentence in (
            (
                content[:7000] + bytes([content[7000] ^ 1]) + content[7001:],
                r"replay.trp: damaged, wrong checksum of the block at byte \d+",
            ),
            (content[:100], r"replay.trp: ends before its first frames"),
            (b"\x89PNG\r\n\x1a\n" + content[8:], r"replay.trp: is not a trophic recording"),
            (
                (self.sets / "other" / "replay.trp").read_bytes(),
                r"manifest.json: fingerprint \w+, seed 1, but replay.trp next to it is of .* different runs",
            ),
        ):
            (run / "replay.trp").write_bytes(damaged)
            self.refused(sentence, run)

    def test_tables_of_another_run_are_refused(self):
        run = self.copy()
        (run / "events.csv").write_bytes((self.sets / "other" / "events.csv").read_bytes())
        self.forget_sums(run)
        self.refused(
            r"events.csv:2: body 0 at 0 s is at .* in the recording next to it elsewhere; they belong to different runs",
            run,
        )

    def test_each_table_of_another_run_with_the_same_start_is_refused(self):
        """A run of the same seed with other rules begins alike: rows that belong to it alone are found."""
        Recordings.make.__func__(
            self, "sister", "--backend", "kinematic", "--duration", 60, "--seed", 1, "--set", "rules.capture.reach_m=9"
        )
        for table, sentence in (
            ("events.csv", r"events.csv: has checksum \d+: must be \d+, as its manifest says"),
            ("agents.csv", r"agents.csv: has checksum \d+: must be \d+, as its manifest says"),
            ("phylogeny.csv", r"phylogeny.csv: has checksum \d+: must be \d+, as its manifest says"),
        ):
            with self.subTest(table):
                run = self.copy()
                (run / table).write_bytes((self.sets / "sister" / table).read_bytes())
                self.refused(sentence, run)
                self.forget_sums(run)
                self.refused(rf"{table}:\d+: ", run)  # row by row
                shutil.rmtree(run)

    def forget_sums(self, run):
        """As of a run that was killed, whose manifest has no checksums."""
        manifest = json.loads((run / "manifest.json").read_text())
        del manifest["tables"], manifest["recording"]
        (run / "manifest.json").write_text(sealed_text(manifest))

    def test_senses_of_another_run_are_refused_and_of_a_killed_one_shown(self):
        Recordings.make.__func__(
            self, "sensed-2", "--backend", "kinematic", "--duration", 60, "--senses", "--set", "rules.capture.reach_m=9"
        )
        run = self.copy("sensed")
        own, foreign = ((self.sets / name / "senses.csv").read_bytes() for name in ("sensed", "sensed-2"))
        (run / "senses.csv").write_bytes(foreign)
        self.refused(r"senses.csv: has checksum \d+: must be \d+, as its manifest says", run)
        self.forget_sums(run)
        self.refused(
            r"senses.csv:\d+: is not of the robot and tick in that row of agents.csv; they belong to different runs",
            run,
        )
        for cut_off in (own, own[:-1000]):
            (run / "senses.csv").write_bytes(cut_off)
            shown = self.show(run, "-o", "page.html")
            self.assertEqual(shown.returncode, 0, shown.stderr)
            (self.folder / "page.html").unlink()

    def test_events_that_contradict_the_recording_are_refused(self):
        run = self.copy()
        events = (run / "events.csv").read_text().splitlines(keepends=True)
        born = events[1].split(",")
        for changes, sentence in (
            ({13: "5"}, r"events.csv: has checksum \d+: must be \d+, as its manifest says"),
            ({0: "61", 1: "30"}, r"events.csv:2: body 0 at 61 s: must be at 60 s, tick 30 of the recording next to it"),
            ({0: "62", 1: "31"}, r"events.csv:2: body 0 at 62 s: the recording next to it ends at 60 s"),
            ({5: "30"}, r"events.csv:2: body 30 at 0 s: the recording next to it has 30 bodies"),
            (
                {2: "activation", 3: "4711"},
                r"events.csv:2: body 0 at 0 s: robot 4711 was never born there; they belong to different runs",
            ),
        ):
            row = list(born)
            for column, cell in changes.items():
                row[column] = cell
            (run / "events.csv").write_text("".join([events[0], ",".join(row), *events[2:]]))
            self.refused(sentence, run)
            if 13 in changes:
                self.forget_sums(run)

    def test_a_killed_run_is_shown_without_checksums(self):
        run = self.copy()
        self.forget_sums(run)
        self.assertEqual(self.show(run, "-o", "page.html").returncode, 0)

    def test_an_interrupted_run_is_shown_with_a_remark(self):
        run = self.copy()
        self.forget_sums(run)
        content = (run / "replay.trp").read_bytes()
        (run / "replay.trp").write_bytes(content[:-30])
        result = self.show(run, "-o", "page.html")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(
            result.stderr,
            r"^trophic show: \S+replay.trp: ends early, in the middle of the block after \d+ frames \([\d.]+ s\)\n$",
        )

    def test_an_impossible_block_length_is_where_a_killed_run_ends(self):
        run = self.copy()
        self.forget_sums(run)
        content = (run / "replay.trp").read_bytes()
        (run / "replay.trp").write_bytes(content[:-16] + b"\xf4\xff\xff\xffPOSE" + bytes(20))
        shown = self.show(run, "--from", 20, "--to", 30, "-o", "page.html")
        self.assertEqual(shown.returncode, 0, shown.stderr)
        self.assertRegex(shown.stderr, r"ends early, in the middle of the block after \d+ frames")

    def test_a_window_of_time_is_shown_alone(self):
        whole, part = self.show(self.sets / "run", "-o", "whole.html"), self.show(
            self.sets / "run", "--from", 20, "--to", 30, "-o", "part.html"
        )
        self.assertEqual((whole.returncode, part.returncode), (0, 0), part.stderr)
        self.assertLess((self.folder / "part.html").stat().st_size, (self.folder / "whole.html").stat().st_size)
        self.refused(r"time 61 s: must be between 0 and 60", self.sets / "run", "--to", 61)
        self.refused(r"--from 30: must be <= --to, 20", self.sets / "run", "--from", 30, "--to", 20)

    def test_a_folder_that_cannot_be_written_is_an_error(self):
        result = self.show(self.sets / "run", "-o", "none/page.html")
        self.assertEqual(
            (result.returncode, result.stderr),
            (1, "trophic show: cannot create none/page.html: No such file or directory\n"),
        )


if __name__ == "__main__":
    unittest.main()
