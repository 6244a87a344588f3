# SPDX-License-Identifier: MIT
"""An ecology as a PettingZoo ParallelEnv, whose agents are individuals that are born and die, and one individual as a Gymnasium environment."""
from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy

from .ecologies import Event, Rewards, ecology_of, rewards_of

try:
    import gymnasium
    from gymnasium.spaces import Box
    from pettingzoo import ParallelEnv
except ImportError as error:
    raise ImportError(f"trophic.env needs PettingZoo and Gymnasium: pip install pettingzoo ({error})") from None

_COLOURS = ((31, 119, 180), (214, 39, 40), (44, 160, 44), (148, 103, 189), (255, 127, 14))


class _Infos(dict):
    """The infos of agents, which are made when the first is read: most learners read none."""

    def __init__(self, agents: list[str], parents: list[tuple[int, ...]], people: numpy.ndarray):
        super().__init__(dict.fromkeys(agents))
        self._of = agents, parents, people

    def _make(self) -> None:
        if self._of is None:
            return
        (agents, parents, people), self._of = self._of, None
        columns = (people[name].tolist() for name in ("energy_J", "age_s", "x_m", "y_m", "waits"))
        for agent, born_of, energy_J, age_s, x_m, y_m, asked in zip(agents, parents, *columns):
            self[agent] = {
                "energy_J": energy_J,
                "age_s": age_s,
                "parents": born_of,
                "position_m": (x_m, y_m),
                "asked": asked,
            }

    def __iter__(self):  # with an iterator of its own dict(infos) does not copy what has not been made
        return super().__iter__()

    def __reduce__(self):
        return dict, (dict(self),)


def _after_making(name: str) -> Callable:
    plain = getattr(dict, name)

    def method(self, *arguments):
        self._make()
        return plain(self, *arguments)

    return method


for _name in (
    "__eq__",
    "__getitem__",
    "__ne__",
    "__or__",
    "__repr__",
    "__ror__",
    "copy",
    "get",
    "items",
    "pop",
    "popitem",
    "setdefault",
    "values",
):
    setattr(_Infos, _name, _after_making(_name))


class Environment(ParallelEnv):
    """A rule table whose individuals are agents, "prey_17". An id is used once. The dead get a last step with `terminated`; newborns
    appear with their first observation; `truncated` comes at the end of time alone.

    Observations are the table's sensors, actions the outputs of its acts (`channels`); all robots decide together. Reward is 0:
    there is no fitness. `rewards` names the worth of events (`ate`, `caught`, `offspring`) or is a function of a tick's events that
    returns rewards by id. `infos` have energy (J), age (s), parents, position (m) and whether the rules ask the robot: if they do
    not, its action is not used. The last info of the dead is the cause. `possible_agents` does not exist: who will be born is not known.

    `species`: only its individuals are agents; all others decide by their own brains. `start_s`: all do until then. `genes`: observations
    end with the inherited numbers of the individual. Mutation and selection act on these under any decider.
    """

    metadata = {"name": "trophic", "render_modes": ["rgb_array"], "is_parallelizable": True}

    def __init__(
        self,
        rule_table: str = "paper",
        *,
        backend: str = "kinematic",
        seed: int = 1,
        parameters: dict | None = None,
        rewards: Rewards = None,
        species: str | None = None,
        start_s: float = 0.0,
        genes: bool = False,
        render_mode: str | None = None,
        module: Any = None,
    ):
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode = {render_mode}: must be rgb_array or None")
        self.ecology = ecology_of(rule_table, backend=backend, seed=seed, parameters=parameters, module=module)
        self.render_mode = render_mode
        self._rewards = rewards_of(rewards)
        self._seed, self._start_s, self._genes = seed, start_s, genes
        self.ecology.reset()
        self.ecology.sense()
        self.channels = self.ecology.spaces
        self._species_names = self.ecology.species_names
        if species is not None and species not in self._species_names:
            raise ValueError(f"species = {species}: must be one of {', '.join(self._species_names)}")
        self._only = None if species is None else self._species_names.index(species)
        inherited = {len(genome) for genome in self.ecology.genomes()} if genes else {0}
        if len(inherited) > 1:
            raise ValueError("genes = True: genomes have different sizes: must have one")
        self._inherited = inherited.pop()
        sizes = [len(self.channels["inputs"][name]) for name in self._species_names]
        self._is_uneven = len(set(sizes)) > 1
        self._columns = [numpy.r_[0:size, max(sizes) : max(sizes) + self._inherited] for size in sizes]
        self._observation_spaces = {
            name: self._box(self.channels["inputs"][name], self._inherited) for name in self._species_names
        }
        self._action_spaces = {name: self._box(self.channels["outputs"]) for name in self._species_names}
        self._forget()

    @staticmethod
    def _box(channels: list[tuple], unbounded: int = 0) -> Box:
        low, high = (
            numpy.array([channel[place] for channel in channels] + [end] * unbounded, dtype=numpy.float64)
            for place, end in ((2, -numpy.inf), (3, numpy.inf))
        )
        return Box(low, high, dtype=numpy.float64)

    def observation_space(self, agent: str) -> Box:
        return self._observation_spaces[agent.rpartition("_")[0]]

    def action_space(self, agent: str) -> Box:
        return self._action_spaces[agent.rpartition("_")[0]]

    @property
    def agents(self) -> list[str]:
        """The living, in the order of their bodies; empty before reset and after the end."""
        if self._is_old:
            self._look()
        return self._agents

    def reset(self, seed: int | None = None, options: dict | None = None):
        self.ecology.reset(seed=self._seed if seed is None else seed)
        self._forget()
        self._is_over = not self.ecology.run_until(self._start_s)
        self._look()
        return self._observe(), self._infos()

    def step(self, actions: dict[str, numpy.ndarray]):
        if not self.agents:
            raise ValueError("step: no agent is alive: must be called after reset")
        self._decide(actions)
        names, last = self._names, self._last
        self._is_over = not self.ecology.sense()
        self._look()
        now = self._living
        observations, infos = self._observe(), self._infos()
        terminated, truncated = dict.fromkeys(now, False), dict.fromkeys(now, self._is_over)
        rewards = dict.fromkeys(now, 0.0)
        if self._names is not names:
            causes = {event[3]: event[6] for event in self.ecology.events() if event[2] == "death"}
            for gone in names.keys() - self._names.keys():
                agent = names[gone]
                observations[agent] = last[agent]
                rewards[agent], terminated[agent], truncated[agent] = 0.0, True, False
                infos[agent] = {"cause": causes.get(gone, "")}
        if self._rewards is not None:
            for individual, reward in self._rewards(self.ecology.events()).items():
                agent = self._names.get(individual) or names.get(individual)
                if agent in rewards:
                    rewards[agent] = float(reward)
        return observations, rewards, terminated, truncated, infos

    def own_actions(self) -> dict[str, numpy.ndarray]:
        """The actions that the brains of their genomes choose, of those whom the rules ask."""
        if self._is_old:
            self._look()
        outputs = self.ecology.own_outputs()
        return dict(zip(self._asked, outputs if self._only is None else outputs[self.ecology.species == self._only]))

    def step_batch(self, outputs: Any) -> numpy.ndarray:
        """A step without dictionaries: `outputs` has a row for each robot that waits, of all species (`ecology.ids`, `ecology.species`). Returns
        the inputs of those that wait next, which have no rows at the end."""
        self._is_old = True
        inputs = self.ecology.step_batch(outputs)
        self._is_over = not self.ecology.waits
        return inputs

    def render(self) -> numpy.ndarray | None:
        """The arena from above, 400 x 400 pixels: a disc in the colour of its species and a line to where it heads."""
        if self.render_mode is None:
            return None
        side, half_m = 400, self.ecology.half_side_m
        picture = numpy.full((side, side, 3), 245, dtype=numpy.uint8)
        pixel_m = 2.0 * half_m / side
        radius_m = 5.0 * pixel_m
        around = numpy.arange(-11, 12)
        for one in self.ecology.individuals():
            column, row = int((one["x_m"] + half_m) / pixel_m), int((half_m - one["y_m"]) / pixel_m)
            columns, rows = numpy.meshgrid(around + column, around + row)
            dx_m = (columns + 0.5) * pixel_m - half_m - one["x_m"]
            dy_m = half_m - (rows + 0.5) * pixel_m - one["y_m"]
            cosine, sine = numpy.cos(one["heading_rad"]), numpy.sin(one["heading_rad"])
            along_m, across_m = dx_m * cosine + dy_m * sine, dy_m * cosine - dx_m * sine
            is_head = (along_m >= 0.0) & (along_m <= 2.0 * radius_m) & (numpy.abs(across_m) <= 0.3 * radius_m)
            is_drawn = ((dx_m**2 + dy_m**2 <= radius_m**2) | is_head) & (columns >= 0) & (rows >= 0)
            is_drawn &= (columns < side) & (rows < side)
            picture[rows[is_drawn], columns[is_drawn]] = _COLOURS[one["species"] % len(_COLOURS)]
        return picture

    def close(self) -> None:
        self.ecology.close()
        self._forget()

    def _forget(self) -> None:
        """Notes that there are no agents."""
        self._is_old = self._is_over = False
        self._agents: list[str] = []
        self._living: list[str] = []
        self._asked: list[str] = []
        self._names: dict[int, str] = {}
        self._parents: list[tuple[int, ...]] = []
        self._last: dict[str, numpy.ndarray] = {}
        self._ids = self._waits = b""

    def _look(self) -> None:
        """Notes who lives and who waits."""
        self._is_old = False
        people = self.ecology.individuals()
        if self._only is not None:
            mine = people["species"] == self._only
            people = people[mine]
        if (ids := people["id"].tobytes()) != self._ids:
            known, species = self._names, self._species_names
            self._ids, self._waits = ids, b""
            self._names = {
                individual: known.get(individual) or f"{species[of]}_{individual}"
                for individual, of in zip(people["id"].tolist(), people["species"].tolist())
            }
            self._living = list(self._names.values())
            last = self._last
            self._last = {
                agent: last[agent] if agent in last else numpy.zeros(self.observation_space(agent).shape)
                for agent in self._living
            }
            parents = self.ecology.parents()
            self._parents = parents if self._only is None else list(itertools.compress(parents, mine.tolist()))
        if (waits := people["waits"].tobytes()) != self._waits:
            self._waits = waits
            self._asked = list(itertools.compress(self._living, people["waits"].tolist()))
        self._people = people
        self._agents = [] if self._is_over else self._living.copy()

    def _decide(self, actions: dict[str, numpy.ndarray]) -> None:
        if not actions.keys() <= set(self._agents):
            unknown = min(map(str, actions.keys() - set(self._agents)))
            raise ValueError(f"actions: {unknown}: must be an agent that is alive")
        try:
            rows = [actions[agent] for agent in self._asked]
        except KeyError as missing:
            raise ValueError(f"actions: {missing.args[0]}: must be there") from None
        try:
            if self._only is None:
                self.ecology.decide(rows)
            else:
                outputs = self.ecology.own_outputs()
                if rows:
                    outputs[self.ecology.species == self._only] = numpy.stack(rows)
                self.ecology.decide(outputs)
        except (TypeError, ValueError):
            size = len(self.channels["outputs"])
            for agent, row in zip(self._asked, rows):
                if (shape := numpy.shape(row)) != (size,):
                    raise ValueError(f"actions: {agent}: shape {shape}: must be ({size},)") from None
            raise

    def _observe(self) -> dict[str, numpy.ndarray]:
        """The observations of all who live. Who is not asked at this tick keeps its last one."""
        rows = self.ecology.inputs
        if self._genes and len(rows):
            rows = numpy.hstack([rows, numpy.stack(self.ecology.genomes())])
        if self._only is not None:
            rows = rows[self.ecology.species == self._only][:, self._columns[self._only]]
        elif self._is_uneven:
            rows = [row[self._columns[species]] for row, species in zip(rows, self.ecology.species.tolist())]
        self._last.update(zip(self._asked, rows))
        return self._last.copy()

    def _infos(self) -> dict[str, dict]:
        return _Infos(self._living, self._parents, self._people)


#: An ecology of a rule table as a PettingZoo ParallelEnv: `trophic.env("pond", backend="kinematic", seed=1)`.
env = Environment


class OneAgent(gymnasium.Env):
    """One individual of a species as a Gymnasium environment, among others that decide by their own brains, which evolve. An episode is its
    life, from `start_s` on: a random one that lives then. `terminated`: it has died. `truncated`: the run has ended. A step lasts until the
    rules ask it again. Options, observations, actions and rewards are those of `Environment`.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}

    def __init__(self, rule_table: str = "paper", species: str = "prey", **options: Any):
        self._all = Environment(rule_table, species=species, **options)
        self.ecology, self.render_mode = self._all.ecology, self._all.render_mode
        self.observation_space = self._all._observation_spaces[species]
        self.action_space = self._all._action_spaces[species]
        self.agent = ""

    def reset(self, *, seed: int | None = None, options: dict | None = None):
        super().reset(seed=seed)
        start = int(self.np_random.integers(2**31)) if seed is None else seed
        observations, infos = self._all.reset(seed=start)
        candidates = [agent for agent, info in infos.items() if info["asked"]]
        if not candidates:
            raise RuntimeError(f"seed = {start}: no individual of the species is asked at {self.ecology.time_s:g} s")
        self.agent = candidates[int(self.np_random.integers(len(candidates)))]
        return observations[self.agent], infos[self.agent]

    def step(self, action: numpy.ndarray):
        if not self.agent:
            raise ValueError("step: the individual does not live: must be called after reset")
        agent, total = self.agent, 0.0
        is_asked = False
        while not is_asked:
            actions = {**self._all.own_actions(), agent: action}
            observations, rewards, terminated, truncated, infos = self._all.step(actions)
            total += rewards[agent]
            is_over = terminated[agent] or truncated[agent]
            is_asked = is_over or infos[agent]["asked"]
        if is_over:
            self.agent = ""
        return (observations[agent], total, terminated[agent], truncated[agent], infos[agent])

    def render(self) -> numpy.ndarray | None:
        return self._all.render()

    def close(self) -> None:
        self._all.close()
