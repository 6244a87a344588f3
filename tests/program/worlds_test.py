#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""worlds_test.py WORLDS: living worlds against independent programs, and what a run of changing numbers writes. Needs numpy and scipy: skipped without."""

import csv
import json
import re
import subprocess
import sys
import unittest

from figures_python import PYTHON
from in_folder import InFolder

WORLDS = sys.argv.pop(1)
SETS = 30

# An independent program of the model, in numpy: NetLogo's wolves, sheep and grass with its numbers. Prints the sheep, wolves and
# grown patches of each tick as JSON, for each seed from 1.
WOLF_SHEEP = """
import json, sys
import numpy

def world(rng, ticks, side=51, delay=30):
    def animals(count, gain):
        return numpy.array([rng.uniform(0, side, count), rng.uniform(0, side, count), rng.uniform(0, 360, count), rng.integers(0, 2 * gain, count)], float)

    def walk(herd):
        herd[2] += rng.uniform(0, 50, herd.shape[1]) - rng.uniform(0, 50, herd.shape[1])
        herd[0] = (herd[0] + numpy.cos(numpy.radians(herd[2]))) % side
        herd[1] = (herd[1] + numpy.sin(numpy.radians(herd[2]))) % side
        herd[3] -= 1

    def patch(herd):
        return numpy.minimum(herd[0].astype(int), side - 1) * side + numpy.minimum(herd[1].astype(int), side - 1)

    def reproduce(herd, chance):
        bears = rng.random(herd.shape[1]) < chance
        herd[3, bears] /= 2
        young = herd[:, bears].copy()
        young[2] = rng.uniform(0, 360, young.shape[1])
        young[0] = (young[0] + numpy.cos(numpy.radians(young[2]))) % side
        young[1] = (young[1] + numpy.sin(numpy.radians(young[2]))) % side
        return numpy.concatenate([herd, young], axis=1)

    sheep, wolves = animals(100, 4), animals(50, 20)
    grown = rng.random(side * side) < 0.5
    wait = rng.integers(0, delay, side * side)
    counts = []
    for _ in range(ticks):
        walk(sheep)
        walk(wolves)
        grown, wait = grown | (wait <= 0), wait - 1
        where = patch(sheep)
        for one in rng.permutation(sheep.shape[1]):
            if grown[where[one]]:
                grown[where[one]], wait[where[one]] = False, delay
                sheep[3, one] += 4
        here = {}
        for one, at in enumerate(where):
            here.setdefault(at, []).append(one)
        eaten, places = set(), patch(wolves)
        for wolf in rng.permutation(wolves.shape[1]):
            candidates = here.get(places[wolf])
            if candidates:
                eaten.add(candidates.pop(rng.integers(len(candidates))))
                wolves[3, wolf] += 20
        kept = numpy.ones(sheep.shape[1], bool)
        kept[list(eaten)] = False
        sheep, wolves = sheep[:, kept & (sheep[3] >= 0)], wolves[:, wolves[3] >= 0]
        sheep, wolves = reproduce(sheep, 0.04), reproduce(wolves, 0.05)
        counts.append([sheep.shape[1], wolves.shape[1], int(grown.sum())])
    return counts

print(json.dumps([world(numpy.random.default_rng(seed), int(sys.argv[2])) for seed in range(1, int(sys.argv[1]) + 1)]))
"""

# Compares two lists of runs by the statistics of PPHPC (Fachada et al. 2015): the largest and least value of each output, their times, and mean
# and deviation in the steady state. Prints the least p, corrected by Holm's first step.
COMPARE = """
import json, sys
import numpy, scipy.stats

def statistics(runs, steady):
    runs = numpy.array(runs, float)
    late = runs[:, steady:]
    both = [runs.max(1), runs.argmax(1), runs.min(1), runs.argmin(1), late.mean(1), late.std(1)]
    return numpy.concatenate(both, axis=1)

ours, theirs = (statistics(runs, 400) for runs in json.load(sys.stdin))
p = [scipy.stats.mannwhitneyu(a, b).pvalue if len(set(a) | set(b)) > 1 else 1.0 for a, b in zip(ours.T, theirs.T)]
print(min(p) * len(p))
"""


class Worlds(InFolder):
    def run_world(self, *arguments):
        made = subprocess.run([WORLDS, "--replay-hz", "0", "--checkpoint-s", "0", *map(str, arguments)], capture_output=True, text=True, cwd=self.folder, timeout=300)
        self.assertEqual(made.returncode, 0, made.stderr)
        return made.stdout

    def python(self, program, *arguments, given=""):
        done = subprocess.run([PYTHON, "-c", program, *map(str, arguments)], input=given, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def rows(self, table):
        with open(self.folder / table, encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def counts(self, folder):
        """Sheep, wolves and grown patches after each tick."""
        by_tick = {}
        for row in self.rows(f"{folder}/energy.csv"):
            by_tick.setdefault(int(row["tick"]), []).append(int(row["individuals"]))
        for row in self.rows(f"{folder}/resource.csv"):
            by_tick[int(row["tick"])].append(round(float(row["stock_J"]) / 4.0))
        return [by_tick[tick] for tick in range(1, len(by_tick))]

    @unittest.skipUnless(PYTHON, "needs Python with numpy and scipy")
    def test_wolves_sheep_and_grass_are_those_of_an_independent_program(self):
        ticks = 700
        self.run_world("--rules", "wolf_sheep", "--backend", "torus", "--replicates", SETS, "--duration", ticks, "--agents-every", 1000, "--out", "runs")
        ours = [self.counts(f"runs/replicate-{number:02}") for number in range(SETS)]
        theirs = self.python(WOLF_SHEEP, SETS, ticks)
        self.assertGreater(self.python(COMPARE, given=json.dumps([ours, theirs])), 0.01)
        # The comparison can tell: a birth rate of 5 instead of 4 per cent is seen.
        self.run_world("--rules", "wolf_sheep", "--backend", "torus", "--replicates", 15, "--duration", ticks, "--agents-every", 1000, "--set", "rules.recruitment.sheep=0.05", "--out", "other")
        other = [self.counts(f"other/replicate-{number:02}") for number in range(15)]
        self.assertLess(self.python(COMPARE, given=json.dumps([other, theirs])), 0.01)

    def test_sheep_without_grass_to_eat_die_out_and_wolves_after_them(self):
        out = self.run_world("--rules", "wolf_sheep", "--backend", "torus", "--duration", 300, "--set", "rules.resource.patch_J=0", "--out", "bare")
        self.assertRegex(out, r"alive\s+0 sheep 0 wolf")

    def test_both_species_of_the_pond_live_on_and_its_ledger_closes(self):
        out = self.run_world("--rules", "pond", "--backend", "kinematic", "--duration", 4000, "--agents-every", 100, "--out", "pond")
        alive = re.search(r"alive\s+(\d+) prey (\d+) predator", out)
        self.assertTrue(int(alive[1]) > 0 and int(alive[2]) > 0, out)
        self.assertGreater(int(re.search(r"births\s+(\d+)", out)[1]), 200)
        last = {}
        for row in self.rows("pond/energy.csv"):
            flow = sum(float(row[name]) for name in ("outside_J", "field_J", "victims_J", "received_J"))
            flow -= sum(float(row[name]) for name in ("upkeep_J", "eaten_J", "given_J", "lost_J"))
            stock = float(row["stock_J"])
            self.assertAlmostEqual(stock - last.get(row["species"], 0.0), flow, delta=1e-9 * max(1.0, stock))
            last[row["species"]] = stock


if __name__ == "__main__":
    unittest.main()
