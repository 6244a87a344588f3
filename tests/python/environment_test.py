# SPDX-License-Identifier: MIT
"""Ecologies as environments: PettingZoo's and Gymnasium's own tests, births and deaths, rewards, genes, one agent, worlds on threads, pictures."""
from __future__ import annotations

import copy
import json
import pickle
import warnings

import numpy
import pytest

trophic_ecologies = pytest.importorskip(
    "trophic_ecologies", reason="the module was not built: apt-get install pybind11-dev python3-dev"
)
pytest.importorskip("pettingzoo", reason="PettingZoo is not installed: pip install pettingzoo")

import gymnasium.utils.env_checker
import pettingzoo.test
import pettingzoo.utils.conversions
import trophic

TORUS = ("wolf_sheep", "rosenzweig_macarthur", "lotka_volterra")


def environment(table: str, **options) -> trophic.Environment:
    options.setdefault("backend", "torus" if table in TORUS else "kinematic")
    return trophic.env(table, **options)


def at_random(env: trophic.Environment) -> dict[str, numpy.ndarray]:
    return {agent: env.action_space(agent).sample() for agent in env.agents}


@pytest.fixture(autouse=True)
def quiet():
    with warnings.catch_warnings():
        warnings.simplefilter(
            "ignore"
        )  # possible_agents is not there; who dies has no further entries; sensors without bounds
        yield


def render_mode_of(mode: str) -> str | None:
    """PettingZoo's test makes an environment of mode human, and reads only the modes of its metadata."""
    return None if mode == "human" else mode


@pytest.mark.parametrize("table", trophic_ecologies.rule_tables())
def test_pettingzoos_own_tests(table):
    pettingzoo.test.parallel_api_test(environment(table), num_cycles=50)
    pettingzoo.test.parallel_seed_test(lambda: environment(table), num_cycles=20)
    as_aec = pettingzoo.utils.conversions.parallel_to_aec
    pettingzoo.test.render_test(lambda render_mode: as_aec(environment(table, render_mode=render_mode_of(render_mode))))


@pytest.mark.parametrize("table", [name for name in trophic_ecologies.rule_tables() if name not in TORUS])
def test_pettingzoos_own_tests_on_mujoco(table):
    def on_mujoco():
        return trophic.env(table, backend="mujoco", parameters={"ecology.duration_s": 4.0})

    try:
        env = on_mujoco()
    except ValueError as error:
        pytest.skip(str(error))  # MuJoCo was not built in
    pettingzoo.test.parallel_api_test(env, num_cycles=3)
    pettingzoo.test.parallel_seed_test(on_mujoco, num_cycles=2)


def test_who_dies_has_a_last_step_and_no_id_comes_back():
    env = environment("pond", parameters={"ecology": {"duration_s": 300.0}})
    observations, infos = env.reset(seed=2)
    dead: set[str] = set()
    causes: set[str] = set()
    ever = set(env.agents)
    while env.agents:
        before = set(env.agents)
        observations, rewards, terminated, truncated, infos = env.step(at_random(env))
        assert set(observations) == set(rewards) == set(terminated) == set(truncated) == set(infos)
        died = {agent for agent, is_dead in terminated.items() if is_dead}
        assert died <= before and not died & dead
        born = set(env.agents) - before
        assert not born & ever
        for agent in env.agents:
            assert env.observation_space(agent).contains(observations[agent])
            assert infos[agent]["energy_J"] > 0.0 and infos[agent]["age_s"] >= 0.0
        for agent in born:
            assert observations[agent].shape == (3,)
            assert (
                infos[agent]["parents"]
                and f"prey_{infos[agent]['parents'][0]}" in ever | {agent}
                or "predator" in agent
            )
        causes |= {infos[agent]["cause"] for agent in died}
        dead |= died
        ever |= born
        assert all(rewards[agent] == 0.0 for agent in rewards)
        assert any(truncated.values()) == (not env.agents)
    assert dead and len(ever) > 40
    assert {"caught", "starved"} & causes <= causes <= {"caught", "starved"}


def test_rewards_are_what_one_says():
    env = environment("paper", rewards={"ate": 1.0, "caught": -2.0}, parameters={"ecology": {"duration_s": 600.0}})
    env.reset()
    eaten = caught = 0.0
    while env.agents:
        _, rewards, terminated, _, _ = env.step(at_random(env))
        eaten += sum(reward for agent, reward in rewards.items() if agent.startswith("predator") and reward > 0.0)
        caught += sum(reward for agent, reward in rewards.items() if reward < 0.0)
    assert eaten > 0.0 and caught == -2.0 * eaten
    with pytest.raises(ValueError, match="^rewards: eaten: must be ate, caught or offspring"):
        environment("paper", rewards={"eaten": 1.0})


def test_wrong_actions_are_refused_and_nothing_is_lost():
    env = environment("paper", parameters={"ecology": {"duration_s": 20.0}})
    env.reset()
    actions = at_random(env)
    with pytest.raises(ValueError, match="^actions: prey_999: must be an agent that is alive$"):
        env.step({**actions, "prey_999": numpy.zeros(2)})
    missing = dict(actions)
    del missing[env.agents[3]]
    with pytest.raises(ValueError, match=f"^actions: {env.agents[3]}: must be there$"):
        env.step(missing)
    with pytest.raises(ValueError, match=rf"^actions: {env.agents[2]}: shape \(3,\): must be \(2,\)$"):
        env.step({**actions, env.agents[2]: numpy.zeros(3)})
    with pytest.raises(ValueError, match=r"^outputs: row 1, individual 1 \(\w+\): turn = nan: must be finite$"):
        env.step({**actions, env.agents[1]: numpy.array([numpy.nan, 1.0])})
    steps = 0
    while env.agents:
        env.step(at_random(env))
        steps += 1
    assert steps == 11
    with pytest.raises(ValueError, match="^step: no agent is alive"):
        env.step({})
    env.reset()
    env.step(at_random(env))
    env.close()
    with pytest.raises(ValueError, match="^step: no agent is alive"):
        env.step(actions)
    env.reset()
    assert len(env.agents) == 30


def test_infos_are_dictionaries_however_they_are_read():
    env = environment("paper")
    _, expected = env.reset()
    plain = {agent: expected[agent] for agent in env.agents}
    assert plain[env.agents[0]]["parents"] == () and plain[env.agents[0]]["position_m"] != (0.0, 0.0)
    for read in (
        dict,
        lambda infos: {**infos},
        lambda infos: infos | {},
        lambda infos: {} | infos,
        lambda infos: dict(infos.items()),
        lambda infos: dict(zip(infos, infos.values())),
        lambda infos: infos.copy(),
        lambda infos: {agent: infos.get(agent) for agent in infos},
        lambda infos: {agent: infos.pop(agent) for agent in list(infos)},
        lambda infos: json.loads(json.dumps(infos), object_hook=as_read),
        copy.deepcopy,
        lambda infos: pickle.loads(pickle.dumps(infos)),
        lambda infos: eval(repr(infos)),
    ):
        _, infos = env.reset()
        assert read(infos) == plain
    _, infos = env.reset()
    assert infos == plain and not infos != plain
    env.step(at_random(env))
    assert infos == plain


def as_read(one: dict) -> dict:
    """Tuples, which JSON lacks."""
    return {key: tuple(value) if isinstance(value, list) else value for key, value in one.items()}


def test_the_own_brains_actions_are_the_run_of_the_own_brains():
    env = environment("pond", parameters={"ecology.duration_s": 200.0})
    env.reset()
    while env.agents:
        env.step(env.own_actions())
    alone = trophic_ecologies.Ecology({"rule_table": "pond", "engine": "kinematic", "ecology.duration_s": 200.0})
    alone.reset()
    assert not alone.run_until()
    assert env.ecology.individuals().tolist() == alone.individuals().tolist()


def test_steps_without_dictionaries_are_the_same_steps():
    one, two = (environment("pond", parameters={"ecology.duration_s": 60.0}) for _ in range(2))
    one.reset()
    two.reset()
    while one.agents:
        observations = one.step({agent: numpy.array([0.5, 1.0]) for agent in one.agents})[0]
        inputs = two.step_batch(numpy.full((len(two.ecology.ids), 2), (0.5, 1.0)))
        assert two.agents == one.agents
        if one.agents:
            own = [
                observations[name] for name in one.agents if one.observation_space(name).contains(observations[name])
            ]
            assert numpy.array_equal(numpy.stack(own)[one.ecology.individuals()["waits"]], inputs)
    assert inputs.shape == (0, 3) and two.ecology.time_s == 60.0


def test_one_species_decides_and_evolves_while_the_other_has_its_own_brains():
    options = {"parameters": {"ecology.duration_s": 400.0}, "start_s": 200.0}
    env = environment("pond", species="prey", **options)
    observations, _ = env.reset()
    assert env.ecology.time_s == 200.0 and all(agent.startswith("prey_") for agent in env.agents)
    assert set(observations) == set(env.agents)
    while env.agents:
        _, _, terminated, _, _ = env.step(env.own_actions())
        assert all(agent.startswith("prey_") for agent in terminated)
    whole = environment("pond", **options)
    whole.reset()
    while whole.agents:
        whole.step(whole.own_actions())
    assert env.ecology.individuals().tolist() == whole.ecology.individuals().tolist()
    with pytest.raises(ValueError, match="^species = wolf: must be one of prey, predator$"):
        environment("pond", species="wolf")


def test_genes_are_inherited_while_another_decides():
    env = environment("pond", genes=True, species="prey", parameters={"ecology.duration_s": 600.0})
    first, _ = env.reset()
    genes = {agent: observation[3:] for agent, observation in first.items()}
    parents, changes = {}, []
    while env.agents:
        actions = {agent: numpy.tanh(genes[agent][:2]) for agent in env.agents}  # the decisions depend on genes
        observations, _, _, _, infos = env.step(actions)
        for agent in set(env.agents) - set(genes):
            if not infos[agent]["asked"]:
                continue
            genes[agent] = observations[agent][3:]
            parent = genes.get(f"prey_{infos[agent]['parents'][0]}")
            if parent is not None:
                changes.append(numpy.abs(genes[agent] - parent).max())
        genes |= {agent: numpy.zeros(15) for agent in set(env.agents) - set(genes)}
    assert all(one.shape == (15,) for one in genes.values())
    founders = list(first.values())
    unrelated = numpy.abs(founders[0][3:] - founders[1][3:]).max()
    assert len(changes) > 10 and 0.0 < numpy.median(changes) < 0.5 * unrelated


def test_one_agent_among_evolved_others_is_a_gymnasium_environment():
    options = {"start_s": 300.0, "parameters": {"ecology.duration_s": 900.0}, "render_mode": "rgb_array"}
    gymnasium.utils.env_checker.check_env(trophic.OneAgent("pond", **options))
    env = trophic.OneAgent("pond", "predator", rewards={"ate": 1.0}, **options)
    lives = catches = 0.0
    for seed in range(8):
        env.reset(seed=seed)
        assert env.agent.startswith("predator_") and env.ecology.time_s == 300.0
        ended = False
        while not ended:
            _, reward, terminated, truncated, info = env.step(env.action_space.sample())
            catches += reward
            ended = terminated or truncated
        lives += 1
        assert terminated == ("cause" in info)
        with pytest.raises(ValueError, match="^step: the individual does not live: must be called after reset$"):
            env.step(env.action_space.sample())
    assert catches > 0.0


@pytest.mark.parametrize("threads", (1, 3))
def test_worlds_on_threads_are_what_each_is_alone(threads):
    options = {"parameters": {"ecology.duration_s": 120.0}}
    worlds = trophic.VectorEnv("pond", 3, seed=5, threads=threads, **options)
    inputs = worlds.reset(start_s=40.0)
    while len(inputs):
        assert len(inputs) == len(worlds.ids) == len(worlds.species) == len(worlds.worlds)
        inputs = worlds.step_batch(numpy.sign(inputs[:, [0, 0]] + 0.5))
    for world, together in enumerate(worlds.ecologies):
        alone = trophic_ecologies.Ecology(
            {"rule_table": "pond", "engine": "kinematic", "ecology.duration_s": 120.0, "seed": 5 + world}
        )
        alone.reset()
        waits = alone.run_until(40.0)
        while waits:
            alone.decide(numpy.sign(alone.inputs[:, [0, 0]] + 0.5))
            waits = alone.sense()
        assert together.individuals().tolist() == alone.individuals().tolist()
        assert len(worlds.events()[world]) == len(alone.events())
    with pytest.raises(RuntimeError, match="^step_batch: no robot waits for a decision$"):
        worlds.step_batch(numpy.zeros((0, 2)))


def test_wrong_outputs_change_no_world():
    worlds = trophic.VectorEnv("paper", 2, parameters={"ecology.duration_s": 20.0})
    inputs = worlds.reset()
    outputs = worlds.own_outputs()
    bad = outputs.copy()
    bad[-1, 1] = numpy.inf
    with pytest.raises(
        ValueError, match=r"^world 1: outputs: row 29, individual 29 \(\w+\): tag = inf: must be finite$"
    ):
        worlds.step_batch(bad)
    with pytest.raises(
        ValueError, match=r"^outputs of shape \(30, 2\): must be \(60, 2\), a row for each robot that waits$"
    ):
        worlds.step_batch(outputs[:30])
    assert [one.tick for one in worlds.ecologies] == [0, 0] and numpy.array_equal(worlds.inputs, inputs)
    worlds.step_batch(outputs)
    assert [one.tick for one in worlds.ecologies] == [1, 1]
    for options, sentence in (
        ({"worlds": 0}, "^worlds = 0: must be >= 1$"),
        ({"threads": 0}, "^threads = 0: must be >= 1$"),
    ):
        with pytest.raises(ValueError, match=sentence):
            trophic.VectorEnv("paper", **options)


def test_a_picture_shows_everybody():
    env = environment("paper", render_mode="rgb_array")
    env.reset()
    picture = env.render()
    assert picture.shape == (400, 400, 3) and picture.dtype == numpy.uint8
    assert len(numpy.unique(picture.reshape(-1, 3), axis=0)) == 3
    assert environment("paper").render() is None
    with pytest.raises(ValueError, match="^render_mode = human: must be rgb_array or None$"):
        environment("paper", render_mode="human")
