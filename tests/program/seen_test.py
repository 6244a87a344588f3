#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""seen_test.py WORLDS TROPHIC: page, live page, film and glTF of a run whose numbers go from 10 animals to about 70 and down to 20."""

import base64
import csv
import json
import re
import sys
import unittest
import zlib

import system_python

system_python.need("numpy", "PIL")

import numpy  # noqa: E402
from in_folder import InFolderWithSets, call, run_ok, sealed_text  # noqa: E402
from live_page import LiveRun  # noqa: E402
from PIL import Image  # noqa: E402

WORLDS, TROPHIC = sys.argv.pop(1), sys.argv.pop(1)
PIXELS_A_M = 400 / (3.255 * 10 * numpy.tan(numpy.radians(19)))  # of a picture of 800 pixels from above
GRASS, TOP = 400, 15.0  # cells of the floor, and the most that one has, J
RULES = {
    "recruitment.spare_bodies": 140,
    "recruitment.birth_J": 40,
    "community.predators": 1,
    "resource.growth_1_s": 0,
    "resource.seed_1_s": 0,
}
RUN = [
    WORLDS,
    "--rules",
    "pond",
    "--backend",
    "kinematic",
    "--seed",
    "4",
    *(word for path, value in RULES.items() for word in ("--set", f"rules.{path}={value}")),
]


class Seen(InFolderWithSets):
    @classmethod
    def make_sets(cls):
        run_ok(*RUN, "--duration", 1000, "--out", cls.sets / "run")
        cls.agents, cls.events, cls.energy = (
            cls.rows_of((cls.sets / f"run/{name}.csv").read_text()) for name in ("agents", "events", "energy")
        )
        cls.alive = {
            time_s: {int(row["id"]): row for row in cls.agents if float(row["time_s"]) == time_s}
            for time_s in range(0, 1001, 20)
        }

    @staticmethod
    def rows_of(text):
        return list(csv.DictReader(text.splitlines()))

    def make(self, command, out, *options, run=None):
        self.assertEqual(self.run_ok(TROPHIC, command, run or self.sets / "run", "-o", out, *options).stderr, "")
        return self.folder / out

    def picture(self, out, *options, run=None):
        if call(TROPHIC, "film", "--help").returncode != 0:
            self.skipTest("built without films")
        options = ("--view", "top", "--lines", "off", "--legend", "off", "--size", "800x800", *options)
        return numpy.array(Image.open(self.make("film", out, *options, run=run))).astype(int)

    def test_the_run_goes_up_and_down(self):
        numbers = [len(alive) for alive in self.alive.values()]
        self.assertEqual(numbers[0], 10)
        self.assertGreater(max(numbers), 50)
        self.assertLess(numbers[-1], 30)

    def test_a_page_has_who_lives_at_each_tick_energy_by_species_and_the_food_of_each_cell(self):
        page = self.make("show", "page.html", "--from", 300, "--to", 500).read_text()
        tables = {}
        for name in ("agents", "energy", "food"):
            packed = re.search(rf'data-file="{name}">([^<]*)<', page)[1]
            tables[name] = self.rows_of(zlib.decompress(base64.b64decode(packed)).decode())
        wanted = [(row["tick"], row["body"], row["id"]) for row in self.agents if 298 < float(row["time_s"]) <= 500]
        self.assertEqual([(row["tick"], row["body"], row["id"]) for row in tables["agents"]], wanted)
        stock_J = [float(row["stock_J"]) for row in self.energy if 298 < float(row["time_s"]) <= 500]
        numpy.testing.assert_allclose(
            [float(row["stock_J"]) for row in tables["energy"]][-len(stock_J) :], stock_J, rtol=1e-3
        )
        times = sorted({float(row["time_s"]) for row in tables["food"]})
        self.assertTrue(times[0] <= 300 and numpy.diff(times).max() <= 20, times)
        self.assertEqual(len(tables["food"]), GRASS * len(times))

    def test_gltf_shows_each_animal_from_its_birth_in_its_place_to_its_death_on_the_food(self):
        scene = json.loads(self.make("export", "scene.gltf", "--from", 300, "--to", 340).read_text())
        data = base64.b64decode(scene["buffers"][0]["uri"].split(",")[1])

        def numbers(accessor):
            one = scene["accessors"][accessor]
            width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[one["type"]]
            return numpy.frombuffer(
                data, "<f4", one["count"] * width, scene["bufferViews"][one["bufferView"]]["byteOffset"]
            ).reshape(-1, width)

        nodes = {node["extras"]["id"]: at for at, node in enumerate(scene["nodes"]) if "extras" in node}
        moves = {}
        for channel in scene["animations"][0]["channels"]:
            sampler = scene["animations"][0]["samplers"][channel["sampler"]]
            moves[channel["target"]["node"], channel["target"]["path"]] = numbers(sampler["input"])[
                :, 0
            ] + 300, numbers(sampler["output"])
        stretch = [row for row in self.agents if 300 <= float(row["time_s"]) <= 340]
        self.assertEqual(set(nodes), {int(row["id"]) for row in stretch})
        self.assertLess(len(nodes), 150)
        births = [row for row in self.events if row["event"] == "birth" and 300 < float(row["time_s"]) < 338]
        self.assertGreater(len(births), 2)
        for row in births:
            times_s, places_m = moves[nodes[int(row["id"])], "translation"]
            self.assertLess(
                numpy.hypot(places_m[:3, 0] - float(row["x_m"]), places_m[:3, 1] - float(row["y_m"])).max(), 0.1
            )
            times_s, scales = moves[nodes[int(row["id"])], "scale"]
            self.assertEqual((list(scales[:2, 0]), times_s[1]), ([0.0, 1.0], float(row["time_s"])))
        for row in self.events:
            if row["event"] != "death" or not 300 < float(row["time_s"]) < 340:
                continue
            times_s, scales = moves[nodes[int(row["id"])], "scale"]
            self.assertEqual((scales[-1, 0], round(float(times_s[-1]), 3)), (0.0, float(row["time_s"])))
        plates = [
            at
            for at, node in enumerate(scene["nodes"])
            if "mesh" in node and scene["meshes"][node["mesh"]]["name"] == "food"
        ]
        areas = numpy.array([moves[plate, "scale"][1][[0, -1], 0] ** 2 for plate in plates])
        self.assertEqual(len(areas), GRASS)
        self.assertTrue((areas[:, 1] <= areas[:, 0] + 1e-6).all())
        self.assertLess(areas[:, 1].sum(), 0.99 * areas[:, 0].sum())

    def test_a_film_shows_the_living_and_less_food_when_it_is_eaten(self):
        blue, green = [], []
        for time_s in (0, 420, 1000):
            picture = self.picture(f"at-{time_s}.png", "--from", time_s)
            blue.append((numpy.abs(picture - (0, 114, 178)).sum(axis=-1) < 70).sum())
            green.append((2 * picture[:, :, 1] - picture[:, :, 0] - picture[:, :, 2] > 40).sum())
        self.assertGreater(blue[1], 2 * max(blue[0], blue[2]))
        self.assertGreater(green[0], 1.5 * green[1])
        self.assertGreater(green[1], 1.5 * green[2])
        strip = numpy.array(
            Image.open(
                self.make(
                    "film",
                    "strip.png",
                    "--sheet",
                    "2x1",
                    "--from",
                    0,
                    "--to",
                    1000,
                    "--lines",
                    "off",
                    "--size",
                    "800x600",
                )
            )
        )
        corner = strip[60:200, -175:-5].astype(int)  # the curves are 160 pixels wide and end at the last moment
        is_prey = numpy.abs(corner - (0, 114, 178)).sum(axis=-1) < 30
        tops = numpy.array([column.argmax() if column.any() else 140 for column in is_prey.T])
        highest_s = max(self.alive, key=lambda time_s: len(self.alive[time_s]))
        self.assertLess(abs((tops.argmin() - numpy.flatnonzero(tops < 140)[0]) / 160 * 1000 - highest_s), 60)

    def test_a_live_page_gets_empty_bodies_energy_and_food(self):
        with LiveRun([*RUN, "--duration", "40", "--out", "run"], self.folder) as run, run.page() as page:
            page.send({"do": "speed", "value": 0})
            tick = page.until(lambda message: message["kind"] == "tick" and message["time_s"] == 40.0)
        alive = self.alive[40]
        self.assertEqual({id_ for id_ in tick["id"] if id_ >= 0}, set(alive))
        self.assertEqual(len(tick["id"]), 150)
        energy = [float(row["stock_J"]) for row in self.energy if row["time_s"] == "40"]
        numpy.testing.assert_allclose(tick["stock"], energy, atol=1e-4)
        self.assertEqual(list(tick["foods"]), ["food"])
        self.assertTrue(len(tick["foods"]["food"]) == GRASS and 0.5 * TOP < max(tick["foods"]["food"]) <= TOP)

    def test_each_of_two_foods_is_on_page_live_page_film_and_in_gltf(self):
        run = self.folder / "run"
        command = [WORLDS, "--rules", "two_foods", "--backend", "kinematic", "--duration", "40"]
        run_ok(*command, "--out", run)
        page = self.make("show", "page.html", run=run).read_text()
        packed = re.search(r'data-file="food">([^<]*)<', page)[1]
        rows = self.rows_of(zlib.decompress(base64.b64decode(packed)).decode())
        for food in ("grass", "fruit"):
            self.assertEqual(sum(row["food"] == food and row["time_s"] == "0" for row in rows), GRASS)
        scene = json.loads(self.make("export", "scene.gltf", run=run).read_text())
        names = [scene["meshes"][node["mesh"]]["name"] for node in scene["nodes"] if "mesh" in node]
        self.assertEqual((names.count("grass"), names.count("fruit")), (GRASS, GRASS))
        both = numpy.array((0.885, 0.905, 0.925))
        for food in ((0.61, 0.77, 0.5), (0.78, 0.63, 0.86)):  # each filters the light of the floor
            both = both * numpy.array(food) / (0.885, 0.905, 0.925)
        picture = self.picture("start.png", "--from", 0, run=run)
        near = numpy.abs(picture - 255 * both).sum(axis=-1) < 60
        self.assertGreater(near.mean(), 0.3)
        with LiveRun([*command, "--out", "live"], self.folder) as live, live.page() as watched:
            watched.send({"do": "speed", "value": 0})
            tick = watched.until(lambda message: message["kind"] == "tick" and message["time_s"] == 40.0)
        self.assertEqual({food: len(cells) for food, cells in tick["foods"].items()}, {"grass": GRASS, "fruit": GRASS})

    def test_births_at_the_start_are_shown_filmed_and_exported(self):
        """A rule that gives bodies to predators at time 0. A killed run is compared with its recording row by row."""
        run = self.folder / "run"
        options = ("--duration", 20, "--set", "rules.minimum_predators.below=30", "--out", run)
        run_ok(WORLDS, "--rules", "pond_with_conditions", "--backend", "kinematic", *options)
        agents = self.rows(self.folder, "run/agents.csv")
        events = self.rows(self.folder, "run/events.csv")
        founders = len([row for row in agents if row["time_s"] == "0"])
        births = [row for row in events if row["event"] == "birth" and row["time_s"] == "0"]
        self.assertGreater(len(births), founders)
        for is_killed in (False, True):
            if is_killed:
                self.forget_sums(run)
            with self.subTest(is_killed=is_killed):
                page = self.make("show", f"page-{is_killed}.html", run=run).read_text()
                packed = re.search(r'data-file="agents">([^<]*)<', page)[1]
                self.assertEqual(len(self.rows_of(zlib.decompress(base64.b64decode(packed)).decode())), len(agents))
                scene = json.loads(self.make("export", f"scene-{is_killed}.gltf", run=run).read_text())
                nodes = {node["extras"]["id"] for node in scene["nodes"] if "extras" in node}
                self.assertEqual(nodes, {int(row["id"]) for row in agents})
                picture = self.picture(f"start-{is_killed}.png", "--from", 0, run=run)
                for row in births[founders:]:
                    x, y = int(400 + PIXELS_A_M * float(row["x_m"])), int(400 - PIXELS_A_M * float(row["y_m"]))
                    part = picture[max(0, y - 8) : y + 9, max(0, x - 8) : x + 9]
                    self.assertGreater((numpy.abs(part - (213, 94, 0)).sum(axis=-1) < 110).sum(), 4, row)

    def forget_sums(self, run):
        """As of a run that was killed, whose manifest has no checksums."""
        manifest = json.loads((run / "manifest.json").read_text())
        del manifest["tables"], manifest["recording"]
        (run / "manifest.json").write_text(sealed_text(manifest))

    def test_refuges_are_in_a_film_and_in_gltf(self):
        run_ok(WORLDS, "--rules", "pond_with_refuges", "--backend", "kinematic", "--duration", 4, "--out",
               self.folder / "run")  # fmt: skip
        run = self.folder / "run"
        scene = json.loads(self.make("export", "scene.gltf", run=run).read_text())
        nodes = [node for node in scene["nodes"] if "mesh" in node]
        rings = [node for node in nodes if scene["meshes"][node["mesh"]]["name"] == "refuge"]
        self.assertEqual({tuple(ring["translation"][:2]) for ring in rings}, {(x, y) for x in (-5, 5) for y in (-5, 5)})
        picture = self.picture("refuges.png", "--from", 0, run=run)
        turns = numpy.linspace(0, 6.28, 60)
        places = zip(400 + PIXELS_A_M * (5 + 1.98 * numpy.cos(turns)), 400 - PIXELS_A_M * (5 + 1.98 * numpy.sin(turns)))
        on_edge = [picture[int(y) - 2 : int(y) + 4, int(x) - 2 : int(x) + 4] for x, y in places]
        seen = [(numpy.abs(part - (74, 89, 105)).sum(axis=-1) < 90).any() for part in on_edge]
        self.assertGreater(numpy.mean(seen), 0.9)


if __name__ == "__main__":
    unittest.main()
