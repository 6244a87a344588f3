# SPDX-License-Identifier: MIT
"""Ecologies of the compiled module, which Python steps by arrays: one, or several on threads."""
from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from typing import Any, Union

import numpy

#: An event of an individual: (tick, time_s, event, id, species, other or -1, cause or "").
Event = tuple
#: The worth of events by name, or a function of a tick's events that returns rewards by id.
Rewards = Union[dict[str, float], Callable[[list[Event]], dict[int, float]], None]


def ecology_of(
    rule_table: str, *, backend: str = "kinematic", seed: int = 1, parameters: dict | None = None, module: Any = None
) -> Any:
    """The `Ecology` of a rule table of trophic's module, or of another module of trophic_add_python_module. All robots decide together. Raises
    ValueError with field, value and bound."""
    if module is None:
        import trophic_ecologies as module
    description = {"rule_table": rule_table, "engine": backend, "ecology.decision_order": "together", "seed": seed}
    return module.Ecology({**description, **(parameters or {})})


def rewards_of(rewards: Rewards) -> Callable[[list[Event]], dict[int, float]] | None:
    """The function of a tick's events that gives individuals rewards; None if there are none."""
    if callable(rewards) or not rewards:
        return rewards or None
    worth = dict(rewards)
    if unknown := set(worth) - {"ate", "caught", "offspring"}:
        raise ValueError(
            f"rewards: {sorted(unknown)[0]}: must be ate, caught or offspring, or rewards a function of events"
        )

    def sum_of(events: list[Event]) -> dict[int, float]:
        sums: dict[int, float] = {}
        for _, _, event, individual, _, other, cause in events:
            if event == "catch":
                sums[individual] = sums.get(individual, 0.0) + worth.get("ate", 0.0)
            if event == "death" and cause == "caught":
                sums[individual] = sums.get(individual, 0.0) + worth.get("caught", 0.0)
            if event == "birth" and other >= 0:
                sums[other] = sums.get(other, 0.0) + worth.get("offspring", 0.0)
        return sums

    return sum_of


class VectorEnv:
    """Worlds of one rule table with different seeds, which threads step together while Python waits. Robots of all worlds that wait for decisions
    are rows of one array, world after world. A world that has ended has no rows.

        worlds = trophic.VectorEnv("pond", worlds=8)
        inputs = worlds.reset()
        while len(inputs):
            inputs = worlds.step_batch(policy(inputs, worlds.species))
    """

    def __init__(
        self,
        rule_table: str = "paper",
        worlds: int = 2,
        *,
        threads: int | None = None,
        backend: str = "kinematic",
        seed: int = 1,
        parameters: dict | None = None,
        module: Any = None,
    ):
        """`seed` is that of the first world; each next one has the next seed. `threads`: None for one per processor core."""
        if worlds < 1:
            raise ValueError(f"worlds = {worlds}: must be >= 1")
        if threads is not None and threads < 1:
            raise ValueError(f"threads = {threads}: must be >= 1")
        self.seed = seed
        self.ecologies = [
            ecology_of(rule_table, backend=backend, seed=seed + world, parameters=parameters, module=module)
            for world in range(worlds)
        ]
        compiled = sys.modules[type(self.ecologies[0]).__module__]
        self._together = compiled.Worlds(self.ecologies, min(worlds, threads or len(os.sched_getaffinity(0))))

    def reset(self, seed: int | None = None, start_s: float = 0.0) -> numpy.ndarray:
        """Begins all worlds anew; the table's own brains decide until `start_s`. Returns the inputs of the robots that wait."""
        self.seed = self.seed if seed is None else seed
        for world, ecology in enumerate(self.ecologies):
            ecology.reset(seed=self.seed + world)
        self._together.run_until(start_s)
        return self.inputs

    def step_batch(self, outputs: Any) -> numpy.ndarray:
        """Decides for all robots that wait, a row of outputs for each, and steps each world until robots wait. Returns their inputs. Raises
        ValueError for wrong outputs; all robots then still wait."""
        self._together.step_batch(outputs)
        return self.inputs

    def run_until(self, until_s: float) -> numpy.ndarray:
        """Lets the table's own brains decide until the clocks are at `until_s`, s. Returns the inputs of the robots that wait."""
        self._together.run_until(until_s)
        return self.inputs

    @property
    def inputs(self) -> numpy.ndarray:
        """The sensors' values of the robots that wait."""
        return self._joined("inputs")

    @property
    def ids(self) -> numpy.ndarray:
        """The ids of the robots that wait, each unique in its world."""
        return self._joined("ids")

    @property
    def species(self) -> numpy.ndarray:
        """Their species, as indices of `ecologies[0].species_names`."""
        return self._joined("species")

    @property
    def worlds(self) -> numpy.ndarray:
        """Their worlds, as indices of `ecologies`."""
        return numpy.repeat(numpy.arange(len(self.ecologies)), [len(one.ids) for one in self.ecologies])

    def own_outputs(self) -> numpy.ndarray:
        """The outputs of the table's own brains for the robots that wait."""
        return numpy.concatenate([one.own_outputs() for one in self.ecologies if one.waits])

    def events(self) -> list[list[Event]]:
        """The events of each world since its last decisions."""
        return [one.events() for one in self.ecologies]

    def close(self) -> None:
        for ecology in self.ecologies:
            ecology.close()

    def _joined(self, name: str) -> numpy.ndarray:
        parts: Sequence[numpy.ndarray] = [getattr(one, name) for one in self.ecologies]
        return numpy.concatenate(parts)
