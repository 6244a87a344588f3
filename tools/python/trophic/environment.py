# SPDX-License-Identifier: MIT
"""An ecology as a PettingZoo ParallelEnv: agents are individuals that are born and die."""
from __future__ import annotations

import os
import pathlib
from collections.abc import Callable

import numpy

try:
    from gymnasium.spaces import Box
    from pettingzoo import ParallelEnv
except ImportError as error:
    raise ImportError(f"trophic.env needs PettingZoo: pip install pettingzoo ({error})") from None

#: An event of an individual: (tick, time_s, event, id, species, other or -1, cause or "").
Event = tuple


def _module():
    """The compiled module; the models lie next to an installed copy of this package."""
    models = pathlib.Path(__file__).resolve().parents[2] / "models"
    if models.is_dir():
        os.environ.setdefault("TROPHIC_MODELS", str(models))
    import trophic_ecologies

    return trophic_ecologies


def _rewards_of(rewards: dict[str, float] | Callable | None) -> Callable[[list[Event]], dict[int, float]]:
    """The function of a tick's events that gives individuals rewards."""
    if callable(rewards):
        return rewards
    worth = dict(rewards or {})
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


class Environment(ParallelEnv):
    """A rule table whose individuals are agents, "prey_17". An id is used once. The dead get a last step with `terminated`; newborns
    appear with their first observation; `truncated` comes at the end of time alone.

    Observations are the table's sensors, actions the outputs of its acts (`channels`); all robots decide together. Reward is 0:
    there is no fitness. `rewards` names the worth of events (`ate`, `caught`, `offspring`) or is a function of a tick's events that
    returns rewards by id. `infos` have energy (J), age (s), parent (-1: none), position (m) and whether the rules ask the robot;
    if they do not, its action is not used. `possible_agents` does not exist: who will be born is not known.
    """

    metadata = {"name": "trophic", "render_modes": ["rgb_array"], "is_parallelizable": True}

    def __init__(
        self,
        rule_table: str = "paper",
        *,
        backend: str = "kinematic",
        seed: int = 1,
        parameters: dict | None = None,
        rewards: dict[str, float] | Callable[[list[Event]], dict[int, float]] | None = None,
        render_mode: str | None = None,
        module=None,
    ):
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode = {render_mode}: must be rgb_array or None")
        description = {"rule_table": rule_table, "engine": backend, "ecology.decision_order": "together", "seed": seed}
        self.ecology = (module or _module()).Ecology({**description, **(parameters or {})})
        self.render_mode = render_mode
        self._rewards = _rewards_of(rewards)
        self._seed = seed
        self.agents: list[str] = []
        self._names: dict[int, str] = {}
        self._species: dict[str, int] = {}
        self._last: dict[str, numpy.ndarray] = {}
        self.ecology.reset()
        self.channels = self.ecology.spaces
        names = self.ecology.species_names
        self._observation_spaces = [self._box(self.channels["inputs"][name]) for name in names]
        self._action_spaces = [self._box(self.channels["outputs"]) for _ in names]

    @staticmethod
    def _box(channels: list[tuple]) -> Box:
        low, high = (numpy.array([channel[place] for channel in channels], dtype=numpy.float64) for place in (2, 3))
        return Box(low, high, dtype=numpy.float64)

    def observation_space(self, agent: str) -> Box:
        return self._observation_spaces[self._species[agent]]

    def action_space(self, agent: str) -> Box:
        return self._action_spaces[self._species[agent]]

    def reset(self, seed: int | None = None, options: dict | None = None):
        self.ecology.reset(seed=self._seed if seed is None else seed)
        self._names, self._species, self._last = {}, {}, {}
        self.ecology.sense()
        self.ecology.events()
        observations, infos = self._perceive()
        self.agents = list(observations)
        return observations, infos

    def step(self, actions: dict[str, numpy.ndarray]):
        if not self.agents:
            raise ValueError("step: no agent is alive: must be called after reset")
        if unknown := set(actions) - set(self.agents):
            raise ValueError(f"actions: {sorted(unknown)[0]}: must be an agent that is alive")
        asked = [self._names[individual] for individual in self.ecology.ids.tolist()]
        if missing := [agent for agent in asked if agent not in actions]:
            raise ValueError(f"actions: {missing[0]}: must be there")
        before = self.agents
        self.ecology.decide(
            numpy.array([actions[agent] for agent in asked], dtype=numpy.float64).reshape(len(asked), -1)
        )
        is_over = not self.ecology.sense()
        rewards_of = self._rewards(self.ecology.events())
        observations, infos = self._perceive()
        self.agents = list(observations)
        everybody = list(dict.fromkeys([*before, *self.agents]))
        for agent in everybody:
            if agent not in observations:
                observations[agent], infos[agent] = self._last[agent], {}
        alive = set(self.agents)
        terminated = {agent: agent not in alive for agent in everybody}
        truncated = {agent: is_over and agent in alive for agent in everybody}
        rewards = {agent: 0.0 for agent in everybody}
        for individual, reward in rewards_of.items():
            if self._names.get(individual) in rewards:
                rewards[self._names[individual]] = float(reward)
        if is_over:
            self.agents = []
        return observations, rewards, terminated, truncated, infos

    def _perceive(self) -> tuple[dict[str, numpy.ndarray], dict[str, dict]]:
        """The observations and infos of all who live. Who is not asked at this tick keeps its last observation."""
        all_ = self.ecology.individuals()
        names = self.ecology.species_names
        rows = dict(zip(self.ecology.ids.tolist(), self.ecology.inputs))
        observations, infos = {}, {}
        for place, (individual, species) in enumerate(zip(all_["id"].tolist(), all_["species"].tolist())):
            agent = self._names.setdefault(individual, f"{names[species]}_{individual}")
            self._species[agent] = species
            size = self._observation_spaces[species].shape[0]
            if individual in rows:
                self._last[agent] = rows[individual][:size]
            observations[agent] = self._last.setdefault(agent, numpy.zeros(size))
            infos[agent] = {
                "energy_J": float(all_["energy_J"][place]),
                "age_s": float(all_["age_s"][place]),
                "parent": int(all_["parent"][place]),
                "position_m": (float(all_["x_m"][place]), float(all_["y_m"][place])),
                "asked": individual in rows,
            }
        for gone in set(self._last) - set(observations):
            if gone not in self.agents:
                del self._last[gone], self._species[gone]
        return observations, infos

    def render(self) -> numpy.ndarray | None:
        """The arena from above, 400 x 400 pixels: a disc in the colour of its species and a line to where it heads."""
        if self.render_mode is None:
            return None
        side, half_m = 400, self.ecology.half_side_m
        picture = numpy.full((side, side, 3), 245, dtype=numpy.uint8)
        rows, columns = numpy.mgrid[0:side, 0:side]
        x_m = (columns + 0.5) / side * 2.0 * half_m - half_m
        y_m = half_m - (rows + 0.5) / side * 2.0 * half_m
        colours = ((31, 119, 180), (214, 39, 40), (44, 160, 44), (148, 103, 189), (255, 127, 14))
        all_ = self.ecology.individuals()
        radius_m = max(0.012 * 2.0 * half_m, 0.01)
        for place, species in enumerate(all_["species"].tolist()):
            dx_m, dy_m = x_m - all_["x_m"][place], y_m - all_["y_m"][place]
            heading = all_["heading_rad"][place]
            along_m = dx_m * numpy.cos(heading) + dy_m * numpy.sin(heading)
            across_m = dy_m * numpy.cos(heading) - dx_m * numpy.sin(heading)
            is_body = dx_m**2 + dy_m**2 <= radius_m**2
            is_head = (along_m >= 0.0) & (along_m <= 2.0 * radius_m) & (numpy.abs(across_m) <= 0.3 * radius_m)
            picture[is_body | is_head] = colours[species % len(colours)]
        return picture

    def close(self) -> None:
        self.ecology.close()


def env(rule_table: str = "paper", **options) -> Environment:
    """An ecology of a rule table as a PettingZoo ParallelEnv: `trophic.env("pond", backend="kinematic", seed=1)`."""
    return Environment(rule_table, **options)
