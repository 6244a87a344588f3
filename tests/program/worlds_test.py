#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""worlds_test.py WORLDS: living worlds against independent programs, and what a run of changing numbers writes. Needs pandas: skipped without."""

import json
import math
import random
import re
import sys
import unittest

import figures_python

figures_python.continue_with_pandas()

import numpy  # noqa: E402
import pandas  # noqa: E402
import scipy.stats  # noqa: E402
from in_folder import InFolder  # noqa: E402

WORLDS = sys.argv.pop(1)


def wolf_sheep(seed, ticks, side=51, delay=30):
    """NetLogo's wolves, sheep and grass with its numbers and in its order, an independent program: sheep, wolves and grown patches after each tick.
    In random order each sheep walks, eats, dies or reproduces before the next one does, then each wolf; then grass grows.
    """
    chance = random.Random(seed)

    def born(count, gain):
        return [
            [chance.uniform(0, side), chance.uniform(0, side), chance.uniform(0, 360), chance.randrange(2 * gain)]
            for _ in range(count)
        ]

    def step(animal):
        animal[0] = (animal[0] + math.cos(math.radians(animal[2]))) % side
        animal[1] = (animal[1] + math.sin(math.radians(animal[2]))) % side

    def walk(animal):
        animal[2] += chance.randrange(50) - chance.randrange(50)
        step(animal)
        animal[3] -= 1

    def patch(animal):
        return min(int(animal[0]), side - 1) * side + min(int(animal[1]), side - 1)

    def survivors(animal, births):
        """Those who are left of an animal that has eaten: none, itself, or also its offspring."""
        if animal[3] < 0:
            return []
        if chance.random() >= births:
            return [animal]
        animal[3] /= 2
        young = animal[:]
        young[2] += chance.uniform(0, 360)
        step(young)
        return [animal, young]

    sheep, wolves = born(100, 4), born(50, 20)
    grown = [chance.random() < 0.5 for _ in range(side * side)]
    wait = [delay if is_grown else chance.randrange(delay) for is_grown in grown]
    counts = []
    for _ in range(ticks):
        here, pack = {}, []
        chance.shuffle(sheep)
        for one in sheep:
            walk(one)
            if grown[patch(one)]:
                grown[patch(one)] = False
                one[3] += 4
            for left in survivors(one, 0.04):
                here.setdefault(patch(left), []).append(left)
        chance.shuffle(wolves)
        for wolf in wolves:
            walk(wolf)
            if victims := here.get(patch(wolf)):
                victims.pop(chance.randrange(len(victims)))
                wolf[3] += 20
            pack += survivors(wolf, 0.05)
        sheep, wolves = [one for flock in here.values() for one in flock], pack
        for at in range(side * side):
            if not grown[at]:
                grown[at], wait[at] = wait[at] <= 0, wait[at] - 1 if wait[at] > 0 else delay
        counts.append([len(sheep), len(wolves), sum(grown)])
    return counts


def well_mixed(seed, ticks, prey, predators, a, r, K, e, m, h):
    """Rosenzweig's and MacArthur's world as a process of numbers, an independent program: prey and predators after each tick. `busy`: ticks until
    each predator hunts again."""
    rng = numpy.random.default_rng(seed)
    busy = numpy.zeros(predators, int)
    counts = []
    for _ in range(ticks):
        draws = rng.random(len(busy))
        catches = []
        for hunter in numpy.flatnonzero((busy == 0) & (draws < 1 - (1 - a) ** prey)):
            if draws[hunter] < 1 - (1 - a) ** (prey - len(catches)):
                catches.append(hunter)
        prey -= len(catches)
        busy = numpy.maximum(busy - 1, 0)
        busy[catches] = h
        kept = rng.random(len(busy)) >= m
        young = rng.binomial(int(kept[catches].sum()), e)
        busy = numpy.concatenate([busy[kept], numpy.zeros(young, int)])
        prey += rng.binomial(prey, r * max(0, 1 - prey / K))
        counts.append([prey, len(busy)])
    return counts


def statistics(runs, steady=400):
    """Those of PPHPC [fachada2015]: the largest and least value of each output, their times, and mean and deviation in the steady state."""
    runs = numpy.array(runs, float)
    late = runs[:, steady:]
    both = [runs.max(1), runs.argmax(1), runs.min(1), runs.argmin(1), late.mean(1), late.std(1)]
    return numpy.concatenate(both, axis=1)


def late_differences(ours, theirs, steady=400):
    """Of the means of each output in the steady state between two lists of runs, in shares of theirs: the ends of their 95 % intervals."""
    ours, theirs = (numpy.array(runs, float)[:, steady:].mean(1) for runs in (ours, theirs))
    error = numpy.sqrt(ours.var(0, ddof=1) / len(ours) + theirs.var(0, ddof=1) / len(theirs))
    half = error * scipy.stats.t.ppf(0.975, min(len(ours), len(theirs)) - 1)
    middle = ours.mean(0) - theirs.mean(0)
    return (middle - half) / theirs.mean(0), (middle + half) / theirs.mean(0)


def are_equivalent(ours, theirs, margin=0.05):
    """Whether the means of all outputs are: each interval lies within the margin, which the intervals of two equal programs do."""
    low, high = late_differences(ours, theirs)
    return bool(low.min() > -margin and high.max() < margin)


def least_p(ours, theirs):
    """Of the tests of all statistics between two lists of runs, by Holm's first step."""
    pairs = zip(statistics(ours).T, statistics(theirs).T)
    p = [scipy.stats.mannwhitneyu(a, b).pvalue if len(set(a) | set(b)) > 1 else 1.0 for a, b in pairs]
    return min(p) * len(p)


class Worlds(InFolder):
    def run_world(self, rules, backend, *options):
        """The folder of the runs, or of the only run, and what was printed."""
        self.number = getattr(self, "number", 0) + 1
        folder = self.folder / str(self.number)
        made = self.run_ok(
            WORLDS,
            "--rules",
            rules,
            "--backend",
            backend,
            "--replay-hz",
            0,
            "--checkpoint-s",
            0,
            "--agents-every",
            1000,
            "--out",
            folder,
            *options,
        )
        return folder, made.stdout

    def runs(self, rules, replicates, ticks, *options):
        folder, _ = self.run_world(rules, "torus", "--replicates", replicates, "--duration", ticks, *options)
        return sorted(folder.glob("replicate-*"))

    def wolf_sheep(self, replicates, ticks, *options):
        """As the independent program counts."""
        runs = []
        for folder in self.runs("wolf_sheep", replicates, ticks, *options):
            numbers = pandas.read_csv(folder / "energy.csv").pivot(
                index="tick", columns="species", values="individuals"
            )
            numbers["grass"] = (pandas.read_csv(folder / "resource.csv").set_index("tick").stock_J / 4.0).round()
            runs.append(numbers[["sheep", "wolf", "grass"]].iloc[1:].to_numpy())
        return runs

    def well_mixed(self, rules, replicates, ticks, *options):
        """Prey and predators after each tick of each run."""
        runs = []
        for folder in self.runs(rules, replicates, ticks, *options):
            events = pandas.read_csv(folder / "events.csv", usecols=["tick", "event", "species"])
            change = events.event.map({"birth": 1, "death": -1}).fillna(0)
            numbers = change.groupby([events.tick, events.species]).sum().unstack(fill_value=0).cumsum()
            runs.append(numbers.reindex(range(ticks + 1)).ffill()[["prey", "predator"]].iloc[1:].to_numpy())
        return numpy.array(runs)

    def test_wolves_sheep_and_grass_are_those_of_an_independent_program_in_the_order_of_netlogo(self):
        theirs, others = ([wolf_sheep(seed + first, 700) for seed in range(30)] for first in (1, 31))
        self.assertTrue(are_equivalent(others, theirs), late_differences(others, theirs))
        ours = self.wolf_sheep(30, 700)
        self.assertGreater(least_p(ours, theirs), 0.01)
        self.assertTrue(are_equivalent(ours, theirs), late_differences(ours, theirs))
        # The comparison can tell: the other order is seen, and a birth rate of 5 instead of 4 per cent.
        together = self.wolf_sheep(30, 700, "--set", "rules.order.acts=together")
        self.assertFalse(are_equivalent(together, theirs), late_differences(together, theirs))
        self.assertLess(least_p(together, theirs), 0.01)
        self.assertLess(least_p(self.wolf_sheep(10, 700, "--set", "rules.recruitment.sheep.chance=0.05"), theirs), 0.01)

    def test_neutral_null_repeats_wolves_and_sheep_that_act_in_turn(self):
        folder, _ = self.run_world("wolf_sheep", "torus", "--replicates", 1, "--neutral", "--duration", 150)
        events = [
            pandas.read_csv(
                folder / null / "replicate-00" / "events.csv", usecols=["tick", "event", "id", "species", "body"]
            )
            for null in ("", "neutral")
        ]
        self.assertTrue(events[0].equals(events[1]))
        self.assertGreater(len(events[0]), 1000)

    def test_sheep_without_grass_to_eat_die_out_and_wolves_after_them(self):
        for run in self.wolf_sheep(30, 150, "--set", "rules.resource.patch_J=0"):
            self.assertEqual(list(run[-1]), [0, 0, 0])

    def test_wolves_and_sheep_that_need_no_grass_are_unstable(self):
        for run in self.wolf_sheep(
            10, 350, "--set", "rules.resource.patch_J=0", "--set", "rules.metabolism.sheep.tick_J=0"
        ):
            self.assertTrue(run[-1, :2].min() == 0 or run[:, 0].max() > 1500, run[::50])

    def test_numbers_of_rosenzweig_and_macarthur_are_those_of_an_independent_program_and_cycle_in_a_rich_world(self):
        ours = self.well_mixed("rosenzweig_macarthur", 6, 3000)
        numbers = dict(prey=260, predators=180, a=numpy.pi * 1e-4, r=0.05, e=0.5, m=0.02, h=12)
        theirs = numpy.array([well_mixed(seed, 3000, K=600, **numbers) for seed in range(1, 13)])
        for mean, expected in zip(ours[:, 500:].mean((0, 1)), theirs[:, 500:].mean((0, 1))):
            self.assertAlmostEqual(mean / expected, 1.0, delta=0.03)
        self.assertLess(ours[:, 500:].std(1).max() / ours[:, 500:].mean(), 0.35)
        for run in self.well_mixed("rosenzweig_macarthur", 2, 1500, "--set", "rules.recruitment.K=1600"):
            self.assertTrue(run.min() == 0 or run[:, 0].max() > 10 * run[:, 0].min(), run[::100])

    def test_means_over_periods_of_lotka_and_volterra_are_those_of_their_equations(self):
        means = []
        for prey, predators in (run.T for run in self.well_mixed("lotka_volterra", 3, 3000)):
            smooth = pandas.Series(prey).rolling(100, center=True).mean()
            crossings = numpy.flatnonzero((smooth >= 500) & (smooth.shift(1) < 500))
            means.append([prey[crossings[0] : crossings[-1]].mean(), predators[crossings[0] : crossings[-1]].mean()])
        for mean in numpy.mean(means, axis=0):
            self.assertAlmostEqual(mean / 500.0, 1.0, delta=0.05)

    def pyramid(self, rules, duration, *species):
        """The energy of each species late in a run in which all of these live on."""
        folder, out = self.run_world(rules, "kinematic", "--duration", duration)
        for one in species:
            self.assertGreater(int(re.search(rf"alive.* (\d+) {one}", out)[1]), 0, out)
        self.assertGreater(int(re.search(r"births\s+(\d+)", out)[1]), 200)
        energy = pandas.read_csv(folder / "energy.csv")
        agents = pandas.read_csv(folder / "agents.csv").groupby(["time_s", "species"]).energy_J.sum()
        stock = energy.set_index(["time_s", "species"]).stock_J
        numpy.testing.assert_allclose(agents, stock[agents.index], atol=1e-6 * energy.stock_J.max())
        flows = energy.eval("outside_J + field_J + victims_J + received_J - upkeep_J - eaten_J - given_J - lost_J")
        for name, ledger in energy.groupby("species"):
            numpy.testing.assert_allclose(
                ledger.stock_J.diff().iloc[1:],
                flows[ledger.index].iloc[1:],
                atol=1e-9 * energy.stock_J.max(),
                err_msg=name,
            )
        late = energy[energy.time_s > duration / 2]
        return [late[late.species == one].stock_J.mean() for one in species]

    def test_each_cell_of_each_table_has_the_type_that_the_manifest_says(self):
        """Of every table of the program, with all that it can write: as docs/how-to/read-in-pandas.md reads them."""
        tables = re.search(r"rule table: (.*?) \(", re.sub(r"\s+", " ", self.run_ok(WORLDS, "--help").stdout))[1]
        for rules in re.split(", | or ", tables):
            with self.subTest(rules):
                out = self.folder / rules
                self.run_ok(WORLDS, "--rules", rules, "--duration", 8, "--states", "--senses", "--out", out)
                told = json.loads((out / "manifest.json").read_text())["tables"]
                self.assertEqual(set(told), {path.name for path in out.glob("*.csv")})
                for file, table in told.items():
                    types = {name: kind.replace("int", "Int") for name, kind in table["columns"].items()}
                    read = pandas.read_csv(out / file, dtype=types)
                    self.assertEqual(list(read.columns), list(types), file)
                    self.assertEqual(len(read), table["rows"], file)

    def test_a_world_runs_on_its_own_backend_and_refuses_others(self):
        made = self.run_ok(WORLDS, "--rules", "lotka_volterra", "--duration", 2, "--out", "own")
        self.assertIn("lotka_volterra on torus 1", made.stdout)
        refused = self.call(WORLDS, "--rules", "lotka_volterra", "--backend", "kinematic", "--out", "other")
        self.assert_refused(refused, "rule table lotka_volterra on backend kinematic: must be on torus")
        self.assertFalse((self.folder / "other").exists())

    def test_both_species_of_the_pond_live_on_and_its_ledger_closes(self):
        self.pyramid("pond", 4000, "prey", "predator")

    def test_prey_of_the_race_have_the_pace_of_their_parent_unless_they_inherit_nothing(self):
        for inherited, least, most in (("true", 0.5, 0.9), ("false", -0.2, 0.2)):
            setting = f"rules.heredity.prey.inherited={inherited}"
            folder, _ = self.run_world("pond_race", "kinematic", "--duration", 1000, "--set", setting)
            pace = pandas.read_csv(folder / "genomes.csv").set_index("id")["walking_pace"]
            births = pandas.read_csv(folder / "events.csv").query("event == 'birth' and tick > 0 and species == 'prey'")
            self.assertGreater(len(births), 200)
            alike = numpy.corrcoef(pace.loc[births["id"]], pace.loc[births["parent_id"].astype(int)])[0, 1]
            self.assertTrue(least < alike < most, alike)

    def test_conditions_of_the_pond_act_and_without_them_it_is_the_pond(self):
        def events(rules, setting):
            folder, _ = self.run_world(rules, "kinematic", "--duration", 1000, "--set", setting)
            return pandas.read_csv(folder / "events.csv").query("tick > 0")

        pond, free, rescued, escaping = (
            events(*run)
            for run in (
                ("pond", "rules.mutation.sd=0.05"),
                *(
                    ("pond_with_conditions", setting)
                    for setting in (
                        "rules.mutation.sd=0.05",
                        "rules.minimum_predators.below=14",
                        "rules.recruitment.escapes=1",
                    )
                ),
            )
        )
        self.assertTrue(pond.equals(free))
        self.assertEqual(
            len(rescued.query("cause == 'sacrificed'")),
            len(rescued.query("event == 'birth' and species == 'predator' and parent_id.isna()")),
        )
        self.assertGreater(len(rescued.query("cause == 'sacrificed'")), 0)
        self.assertLess(*(len(one.query("event == 'birth' and species == 'prey'")) for one in (escaping, free)))

    def sizes_of_agents(self, said, folder):
        """The size of agents.csv that a run estimates, the largest that it could have, and the true one, MB."""
        words = re.search(r"^writes  agents.csv, about ([\d.]+) MB(?: .*, at most ([\d.]+) MB)?", said, re.M)
        return float(words[1]), float(words[2] or 0), (folder / "agents.csv").stat().st_size / 1e6

    def test_a_run_estimates_the_size_of_agents_csv_within_a_factor_of_one_and_a_half(self):
        for place, (rules, backend, duration, *more) in enumerate(
            (
                ("pond", "kinematic", 2000),
                ("pond", "kinematic", 2000, "--agents-every", 6),
                ("food_chain", "kinematic", 500),
                ("wolf_sheep", "torus", 500),
                ("lotka_volterra", "torus", 300),
            )
        ):
            folder = self.folder / f"size-{place}"
            options = ("--duration", duration, "--replay-hz", 0, "--out", folder, *more)
            said = self.run_ok(WORLDS, "--rules", rules, "--backend", backend, *options).stdout
            about, most, size = self.sizes_of_agents(said, folder)
            self.assertTrue(about / 1.5 < size < min(1.5 * about, most), (rules, size, said))

    def test_activity_protects_and_lets_breed_in_the_pond_until_parameters_say_otherwise(self):
        def run(rules, *settings):
            words = [word for setting in settings for word in ("--set", f"rules.{setting}")]
            self.number = getattr(self, "number", 0) + 1
            folder = self.folder / str(self.number)
            options = ("--duration", 1000, "--replay-hz", 0, "--out", folder, *words)
            said = self.run_ok(WORLDS, "--rules", rules, "--backend", "kinematic", *options).stdout
            _, most, size = self.sizes_of_agents(said, folder)
            self.assertLess(size, most)
            return [pandas.read_csv(folder / f"{table}.csv").query("tick > 0") for table in ("events", "agents")]

        def parents_active(events):
            born = events.query("event == 'birth' and species == 'prey'")
            at_birth = born.merge(agents, left_on=["tick", "parent_id"], right_on=["tick", "id"])
            return len(at_birth), at_birth.active_y.mean()

        events, agents = run("pond")
        count, share = parents_active(events)
        self.assertGreater(count, 20)
        self.assertEqual(share, 1)
        events, agents = run("pond", "recruitment.only_active=false")
        count, share = parents_active(events)
        self.assertGreater(count, 20)
        self.assertLess(share, 1)
        at_once = ["activation.distance_m=0", "activation.min_age_s=0"]
        of_age = [at_once[0], "activation.min_age_s=100"]
        waits = []
        for settings in (at_once, of_age):
            events, agents = run("pond_with_conditions", *settings)
            born = events.query("event == 'birth' and species == 'prey'").set_index("id").time_s
            age_s = agents.time_s - agents.id.map(born)
            waits.append(age_s[agents.active == 0].max())
            caught = events.query("cause == 'caught'")
            self.assertGreater((caught.time_s - caught.id.map(born)).min(), waits[-1])
        self.assertLessEqual(waits[0], 2)
        self.assertEqual(waits[1], 98)

    def test_three_levels_of_the_food_chain_live_on_and_each_has_less_than_the_one_below(self):
        energies = self.pyramid("food_chain", 4000, "grazer", "hunter", "apex")
        self.assertEqual(energies, sorted(energies, reverse=True))


if __name__ == "__main__":
    unittest.main()
