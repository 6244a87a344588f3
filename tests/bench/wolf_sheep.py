# SPDX-License-Identifier: MIT
"""Wolves, sheep and grass as a Python world of objects, and in Mesa: how long a tick of a large one takes.

    python3 tests/bench/wolf_sheep.py [SIDE ...]

The numbers are those of PPHPC's first parameter set: 4 sheep and 2 wolves per 100 patches at first, and grass that regrows in 10 ticks. Mesa's part
is left out, with a sentence, if Mesa is not installed (pip install mesa networkx)."""
from __future__ import annotations

import math
import random
import sys
import time

WARM_UP, TICKS = 100, 10
REGROWS, GAIN, CHANCE = 10, (4.0, 20.0), (0.04, 0.05)


class Animal:
    """One of the first species (sheep) or the second (wolves)."""

    __slots__ = ("species", "x", "y", "energy")

    def __init__(self, species: int, x: float, y: float, energy: float):
        self.species, self.x, self.y, self.energy = species, x, y, energy


class World:
    """The order of NetLogo's model: all sheep one after another, then all wolves, then the grass."""

    def __init__(self, side: int, seed: int = 1):
        self.side, self.rng = side, random.Random(seed)
        self.wait = [0 if self.rng.random() < 0.5 else self.rng.randrange(REGROWS) for _ in range(side * side)]
        self.animals = [
            [self.newborn(species, 2.0 * GAIN[species] * self.rng.random()) for _ in range(side * side * per // 100)]
            for species, per in ((0, 4), (1, 2))
        ]

    def newborn(self, species: int, energy: float) -> Animal:
        return Animal(species, self.rng.random() * self.side, self.rng.random() * self.side, energy)

    def patch(self, one: Animal) -> int:
        return int(one.y) * self.side + int(one.x)

    def tick(self) -> None:
        for species in (0, 1):
            self.animals[species] = self.act(species)
        self.wait = [max(0, ticks - 1) for ticks in self.wait]

    def act(self, species: int) -> list[Animal]:
        sheep_on: dict[int, list[Animal]] = {}
        if species == 1:
            for one in self.animals[0]:
                sheep_on.setdefault(self.patch(one), []).append(one)
        left = []
        self.rng.shuffle(self.animals[species])
        for one in self.animals[species]:
            angle = self.rng.uniform(-math.pi, math.pi)
            one.x, one.y = (one.x + math.cos(angle)) % self.side, (one.y + math.sin(angle)) % self.side
            one.energy -= 1.0
            place = self.patch(one) % len(self.wait)
            if species == 0 and self.wait[place] == 0:
                one.energy += GAIN[0]
                self.wait[place] = REGROWS
            if species == 1 and sheep_on.get(place):
                one.energy += GAIN[1]
                sheep_on[place].pop(self.rng.randrange(len(sheep_on[place]))).energy = -math.inf
            if one.energy < 0.0:
                continue
            left.append(one)
            if self.rng.random() < CHANCE[species]:
                one.energy *= 0.5
                left.append(Animal(species, one.x, one.y, one.energy))
        if species == 1:
            self.animals[0] = [one for one in self.animals[0] if one.energy >= 0.0]
        return left

    @property
    def living(self) -> int:
        return sum(map(len, self.animals))


def mesa_world(side: int):
    """Mesa's own example, in its newest form, with these numbers."""
    from mesa.examples.advanced.wolf_sheep.agents import Sheep, Wolf
    from mesa.examples.advanced.wolf_sheep.model import WolfSheep
    from mesa.experimental.devs import ABMSimulator

    names = {"initial_sheep": side * side * 4 // 100, "initial_wolves": side * side * 2 // 100}
    simulator = ABMSimulator()
    model = WolfSheep(
        width=side,
        height=side,
        sheep_reproduce=CHANCE[0],
        wolf_reproduce=CHANCE[1],
        wolf_gain_from_food=GAIN[1],
        sheep_gain_from_food=GAIN[0],
        grass=True,
        grass_regrowth_time=REGROWS,
        seed=1,
        simulator=simulator,
        **names,
    )
    return lambda: simulator.run_for(1), lambda: len(model.agents_by_type[Sheep]) + len(model.agents_by_type[Wolf])


def measure(name: str, side: int, tick, living) -> None:
    for _ in range(WARM_UP):
        tick()
    began = time.process_time()
    for _ in range(TICKS):
        tick()
    took = (time.process_time() - began) / TICKS
    print(
        f"{name:24} {side:5} x {side:<5} {took * 1e3:10.2f} ms a tick  {took * 4000.0:9.1f} s in 4000 ticks  {living():8} living",
        flush=True,
    )


def main(sides: list[int]) -> None:
    for side in sides:
        world = World(side)
        measure("Python objects", side, world.tick, lambda: world.living)
    try:
        import mesa
    except ImportError:
        print("Mesa is not installed: pip install mesa networkx")
        return
    for side in sides:
        measure(f"Mesa {mesa.__version__}", side, *mesa_world(side))


if __name__ == "__main__":
    main([int(side) for side in sys.argv[1:]] or [100, 200])
