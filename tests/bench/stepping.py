#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""stepping.py [--rounds N] [--seconds S] BUILD: what stepping an ecology from Python costs, next to the C++ loop and to other environments.

All rows are measured in turn, in each of the rounds, and the least processor time of each counts, because other programs disturb it least. The rule
table is `paper`: 30 robots on the kinematic backend. What is not installed is left out: pip install pettingzoo mpe2 mesa networkx."""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("build", type=pathlib.Path, metavar="BUILD")
parser.add_argument("--rounds", type=int, default=7)
parser.add_argument("--seconds", type=float, default=2000.0, help="simulated time of a run (default: 2000)")
arguments = parser.parse_args()
sys.path[:0] = [str(arguments.build / "share/trophic/module"), str(ROOT / "tools/python")]
os.environ.setdefault("TROPHIC_MODELS", str(ROOT / "models"))

import numpy  # noqa: E402
import trophic_ecologies  # noqa: E402

PAPER = {"rule_table": "paper", "engine": "kinematic", "seed": 1, "ecology.duration_s": arguments.seconds}
ROBOTS = 30
random = numpy.random.RandomState(1)
FIRST, SECOND = random.randn(3, 64), random.randn(64, 2)


def program(*options, description=PAPER):
    command = [arguments.build / "tests/bench/bench_stepping", json.dumps(description), *options]
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def network(inputs):
    return numpy.tanh(numpy.tanh(inputs @ FIRST) @ SECOND)


def batch(decide, description=PAPER):
    """Processor seconds of a tick by step_batch."""
    ecology = trophic_ecologies.Ecology(description)
    ecology.reset()
    ecology.sense()
    began, inputs = time.process_time(), ecology.inputs
    while len(inputs):
        inputs = ecology.step_batch(decide(ecology, inputs))
    return (time.process_time() - began) / ecology.tick


def dictionaries():
    import trophic

    env = trophic.env("paper", parameters={"ecology.duration_s": arguments.seconds})
    env.reset()
    action = numpy.ones(2)
    began = time.process_time()
    while env.agents:
        env.step(dict.fromkeys(env.agents, action))
    return (time.process_time() - began) / env.ecology.tick


def simple_tag():
    from mpe2 import simple_tag_v3

    env = simple_tag_v3.parallel_env(num_good=15, num_adversaries=15, max_cycles=100)
    env.reset(seed=1)
    began = time.process_time()
    while env.agents:
        env.step({agent: 1 + place % 4 for place, agent in enumerate(env.agents)})
    return (time.process_time() - began) / 100


def wolf_sheep():
    """A tick of as many animals as the others have robots."""
    from mesa.examples.advanced.wolf_sheep.model import WolfSheep
    from mesa.experimental.devs import ABMSimulator

    simulator = ABMSimulator()
    model = WolfSheep(simulator=simulator, seed=1)
    animals, began = 0, time.process_time()
    for _ in range(50):
        animals += sum(len(of) for kind, of in model.agents_by_type.items() if kind.__name__ != "GrassPatch")
        simulator.run_for(1)
    return (time.process_time() - began) / animals * ROBOTS


def numpy_world():
    """30 points that turn and walk, each with the nearest of the other species as its observation, in dictionaries."""
    x_m, y_m, heading = random.uniform(-10.0, 10.0, (3, ROBOTS))
    names = [f"agent_{place}" for place in range(ROBOTS)]
    is_hunter = numpy.arange(ROBOTS) < ROBOTS // 2
    action = numpy.ones(2)
    began = time.process_time()
    for _ in range(500):
        actions = dict.fromkeys(names, action)
        heading += 0.7 * numpy.stack([actions[name] for name in names])[:, 0]
        x_m = numpy.clip(x_m + 0.1 * numpy.cos(heading), -10.0, 10.0)
        y_m = numpy.clip(y_m + 0.1 * numpy.sin(heading), -10.0, 10.0)
        dx_m, dy_m = x_m[None, :] - x_m[:, None], y_m[None, :] - y_m[:, None]
        distance = numpy.where(is_hunter[None, :] == is_hunter[:, None], numpy.inf, numpy.hypot(dx_m, dy_m))
        nearest = distance.argmin(axis=1)
        every = numpy.arange(ROBOTS)
        bearing = numpy.arctan2(dy_m[every, nearest], dx_m[every, nearest]) - heading
        observations = dict(zip(names, numpy.stack([numpy.sign(numpy.sin(bearing)), distance[every, nearest]], axis=1)))
        dict.fromkeys(names, 0.0), dict.fromkeys(names, False), dict.fromkeys(names, False), {
            name: {} for name in names
        }
        assert len(observations) == ROBOTS
    return (time.process_time() - began) / 500


ONES = numpy.ones((ROBOTS, 2))
BATCH, DICTIONARIES = "step_batch, a constant", "dictionaries (PettingZoo), a constant"
WAYS = {
    "C++, run_until": program,
    "C++, stepped by own brains": lambda: program("stepped"),
    "step_batch, own brains": lambda: batch(lambda ecology, _: ecology.own_outputs()),
    "C++, stepped by a constant": lambda: program("constant"),
    BATCH: lambda: batch(lambda _, inputs: ONES[: len(inputs)]),
    "step_batch, a shared network of 64": lambda: batch(lambda _, inputs: network(inputs)),
    DICTIONARIES: dictionaries,
    "a world in numpy, dictionaries": numpy_world,
    "PettingZoo's simple_tag": simple_tag,
    "Mesa's wolf-sheep, for each 30 animals": wolf_sheep,
}


def worlds_together():
    """How many times as fast two worlds of 180 robots are on two threads as on one, by the clock."""
    from trophic.ecologies import VectorEnv

    best_s = {}
    for _ in range(arguments.rounds):
        for threads in (1, 2):
            worlds = VectorEnv("pond", 2, threads=threads, parameters={"ecology.duration_s": 1000.0})
            inputs = worlds.reset()
            began = time.perf_counter()
            while len(inputs):
                inputs = worlds.step_batch(worlds.own_outputs())
            best_s[threads] = min(best_s.get(threads, 1e9), time.perf_counter() - began)
    return best_s[1] / best_s[2]


def main():
    best_s = {}
    for _ in range(arguments.rounds):
        for name, measure in WAYS.items():
            try:
                best_s[name] = min(best_s.get(name, 1e9), measure())
            except ImportError as error:
                best_s[name] = None
                print(f"{name}: left out: {error}", file=sys.stderr)
        for name in [name for name, seconds in best_s.items() if seconds is None]:
            WAYS.pop(name, None)
    loop_s = best_s["C++, run_until"]
    print(
        "| what decides | microseconds a tick of 30 | robot-steps/s of one core | of the C++ loop |\n|---|---|---|---|"
    )
    for name, seconds in best_s.items():
        if seconds is not None:
            print(f"| {name} | {1e6 * seconds:.1f} | {ROBOTS / seconds:,.0f} | {loop_s / seconds:.3g} |")
    constant_s = best_s["C++, stepped by a constant"]
    print("\nOf the C++ loop with the same decisions:", end=" ")
    print(", ".join(f"{name}: {constant_s / best_s[name]:.2f}" for name in (BATCH, DICTIONARIES) if best_s[name]))
    on_mujoco = {**PAPER, "engine": "mujoco", "ecology.duration_s": 20.0}
    tick_s = program(description=on_mujoco)
    added_s = best_s[DICTIONARIES] or best_s[BATCH]
    print(
        f"\nA tick on MuJoCo: {1e6 * tick_s:,.0f} microseconds; Python adds {100 * (added_s - constant_s) / tick_s:.2f} %"
    )
    print(f"Two worlds on two threads: {worlds_together():.2f} times as fast as on one, load {os.getloadavg()[0]:.1f}")


main()
