#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""export_test.py PREDATOR_PREY TROPHIC: a stretch of a run as glTF: which robots are in it, where and when, and bad requests."""

import base64
import json
import os
import struct
import sys
import unittest

import system_python

system_python.need("numpy")

import numpy  # noqa: E402
from in_folder import InFolderWithSets, run_ok  # noqa: E402

PROGRAM, TROPHIC = sys.argv.pop(1), sys.argv.pop(1)


class Gltf:
    def __init__(self, path):
        content = path.read_bytes()
        if path.suffix == ".glb":
            magic, version, size = struct.unpack_from("<4sII", content)
            assert (magic, version, size) == (b"glTF", 2, len(content))
            length, kind = struct.unpack_from("<I4s", content, 12)
            assert kind == b"JSON" and length % 4 == 0
            self.json = json.loads(content[20 : 20 + length])
            binary, kind = struct.unpack_from("<I4s", content, 20 + length)
            assert kind == b"BIN\0" and binary % 4 == 0
            self.bytes = content[28 + length :]
            assert len(self.bytes) == binary
        else:
            self.json = json.loads(content)
            self.bytes = base64.b64decode(self.json["buffers"][0]["uri"].split(",")[1])
        self.channels = {}
        for animation in self.json.get("animations", []):
            for channel in animation["channels"]:
                sampler = animation["samplers"][channel["sampler"]]
                target = channel["target"]
                self.channels[target["node"], target["path"]] = (
                    self.numbers(sampler["input"]),
                    self.numbers(sampler["output"]),
                    sampler["interpolation"],
                )

    def numbers(self, accessor):
        accessor = self.json["accessors"][accessor]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        assert accessor["componentType"] == 5126
        numbers = numpy.frombuffer(self.bytes, "<f4", accessor["count"] * width, view["byteOffset"])
        return numbers if width == 1 else numbers.reshape(-1, width)

    def robots(self):
        return {node["extras"]["id"]: i for i, node in enumerate(self.json["nodes"]) if "extras" in node}

    def value(self, node, path, time_s):
        """As a program that plays the animation would have it."""
        if (node, path) not in self.channels:
            return numpy.array(self.json["nodes"][node].get(path, [1.0, 1.0, 1.0]))
        times, values, kind = self.channels[node, path]
        if kind == "STEP":
            return values[max(0, numpy.searchsorted(times, time_s + 1e-4) - 1)]
        return numpy.array([numpy.interp(time_s, times, column) for column in values.T])


class Exports(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        run_ok(PROGRAM, "--backend", "kinematic", "--duration", 300, "--seed", 3, "--out", cls.sets / "run")

    def export(self, *arguments):
        return self.call(TROPHIC, "export", self.sets / "run", *arguments)

    def scene(self, name, *arguments):
        result = self.export(*arguments, "-o", name)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return Gltf(self.folder / name)

    def rows_at(self, time_s):
        return [row for row in self.rows(self.sets, "run/agents.csv") if float(row["time_s"]) == time_s]

    def test_the_living_are_seen_at_their_rows_positions_and_no_other_robot_is(self):
        scene = self.scene("all.glb")
        robots = scene.robots()
        self.assertEqual(set(robots), {int(row["id"]) for row in self.rows(self.sets, "run/phylogeny.csv")})
        self.assertGreater(len(robots), 30)
        for time_s in range(0, 299, 14):
            alive = {int(row["id"]): row for row in self.rows_at(time_s)}
            for robot, node in robots.items():
                self.assertEqual(scene.value(node, "scale", time_s)[0], 1.0 if robot in alive else 0.0, (robot, time_s))
            for robot, row in alive.items():
                place = scene.value(robots[robot], "translation", time_s)
                self.assertLess(numpy.hypot(place[0] - float(row["x_m"]), place[1] - float(row["y_m"])), 0.002)

    def test_robots_that_die_in_the_last_frame_are_gone_there(self):
        death = next(
            row
            for row in self.rows(self.sets, "run/events.csv")
            if row["event"] == "death" and float(row["time_s"]) >= 20
        )
        end = float(death["time_s"])
        scene = self.scene("end.glb", "--from", end - 10, "--to", end)
        alive = {int(row["id"]) for row in self.rows_at(end)}
        for robot, node in scene.robots().items():
            self.assertEqual(scene.value(node, "scale", 10)[0], 1.0 if robot in alive else 0.0, robot)
        self.assertEqual(scene.value(scene.robots()[int(death["id"])], "scale", 9.7)[0], 1.0)

    def test_gltf_and_glb_have_the_same_contents(self):
        one, other = (self.scene(name, "--from", 20, "--to", 30) for name in ("a.glb", "a.gltf"))
        self.assertEqual(one.json["nodes"], other.json["nodes"])
        self.assertEqual(one.channels.keys(), other.channels.keys())
        for key, (times, values, _) in one.channels.items():
            self.assertTrue((times == other.channels[key][0]).all() and (values == other.channels[key][1]).all())
            self.assertTrue(numpy.diff(times).min() > 0)
        self.assertEqual(min(times[0] for times, _, _ in one.channels.values()), 0.0)
        self.assertAlmostEqual(max(times[-1] for times, _, _ in one.channels.values()), 10.0, places=5)

    def test_one_moment_does_not_move_and_one_robot_is_alone(self):
        moment = self.scene("moment.glb", "--from", 20, "--to", 20)
        self.assertNotIn("animations", moment.json)
        self.assertEqual(len(moment.robots()), 30)
        robot = int(self.rows_at(100.0)[3]["id"])
        alone = self.scene("alone.gltf", "--from", 100, "--to", 110, "--follow", robot)
        self.assertEqual(list(alone.robots()), [robot])
        self.assertEqual(len(alone.json["materials"]), 6)

    def test_colours_are_those_of_the_species(self):
        scene = self.scene("x.glb", "--from", 0, "--to", 0)
        for name, rgb in (("prey", (0, 114, 178)), ("predator", (213, 94, 0))):
            linear = next(m for m in scene.json["materials"] if m["name"] == name)["pbrMetallicRoughness"][
                "baseColorFactor"
            ][:3]
            screen = [12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in linear]
            self.assertEqual(tuple(round(255 * c) for c in screen), rgb)
        for row in self.rows_at(0.0):
            node = scene.json["nodes"][scene.robots()[int(row["id"])]]
            self.assertEqual(node["extras"]["species"], row["species"])
            meshes = {scene.json["nodes"][child].get("mesh") for child in node["children"]} - {None}
            self.assertEqual({scene.json["meshes"][mesh]["name"] for mesh in meshes}, {row["species"]})

    def test_refusals(self):
        (self.folder / "mine.glb").write_text("mine")
        for arguments, sentence in (
            (["-o", "mine.glb"], "--out mine.glb: exists already; files are never overwritten"),
            (["-o", "x.obj"], "--out x.obj: must end in .glb or .gltf"),
            (["-o", "x.glb", "--from", "301"], "time 301 s: must be between 0 and 300"),
            (["-o", "x.glb", "--from", "20", "--to", "10"], "--from 20: must be <= --to, 10"),
            (
                ["-o", "x.glb", "--follow", "9999", "--to", "10"],
                "--follow 9999: no individual with this id lives between 0 and 10 s",
            ),
        ):
            with self.subTest(arguments):
                result = self.export(*arguments)
                self.assert_refused(result, f"trophic export: {sentence}")
                self.assertEqual(result.stdout, "")
        self.assert_refused(self.export("-o", "none/x.glb"), "none/x.glb", code=1)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["mine.glb"])
        self.assertEqual((self.folder / "mine.glb").read_text(), "mine")

    @unittest.skipIf(os.geteuid() == 0, "root writes everywhere")
    def test_a_folder_that_cannot_be_written(self):
        self.folder.chmod(0o555)
        self.assert_refused(self.export("-o", "x.glb", "--to", 2), code=1)


if __name__ == "__main__":
    unittest.main()
