# SPDX-License-Identifier: MIT
"""Ecologies as PettingZoo environments: PettingZoo's own tests on every table, rewards, births and deaths, pictures."""
from __future__ import annotations

import warnings

import numpy
import pytest

trophic_ecologies = pytest.importorskip(
    "trophic_ecologies", reason="the module was not built: apt-get install pybind11-dev python3-dev"
)
pytest.importorskip("pettingzoo", reason="PettingZoo is not installed: pip install pettingzoo")

import pettingzoo.test
import trophic

TORUS = ("wolf_sheep", "rosenzweig_macarthur", "lotka_volterra")


def environment(table: str, **options) -> trophic.Environment:
    options.setdefault("backend", "torus" if table in TORUS else "kinematic")
    return trophic.env(table, **options)


def at_random(env: trophic.Environment) -> dict[str, numpy.ndarray]:
    return {agent: env.action_space(agent).sample() for agent in env.agents}


@pytest.mark.parametrize("table", trophic_ecologies.rule_tables())
def test_pettingzoos_own_tests(table):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # possible_agents is not there; who dies has no further entries
        pettingzoo.test.parallel_api_test(environment(table), num_cycles=50)
        pettingzoo.test.parallel_seed_test(lambda: environment(table), num_cycles=20)


def test_who_dies_has_a_last_step_and_no_id_comes_back():
    env = environment("pond", parameters={"ecology": {"duration_s": 300.0}})
    observations, infos = env.reset(seed=2)
    dead: set[str] = set()
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
            assert infos[agent]["energy_J"] > 0.0
        dead |= died
        ever |= born
        assert all(rewards[agent] == 0.0 for agent in rewards)
        assert any(truncated.values()) == (not env.agents)
    assert dead and len(ever) > 40


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
    while env.agents:
        env.step(at_random(env))
    with pytest.raises(ValueError, match="^step: no agent is alive"):
        env.step({})


def test_a_picture_shows_everybody():
    env = environment("paper", render_mode="rgb_array")
    env.reset()
    picture = env.render()
    assert picture.shape == (400, 400, 3) and picture.dtype == numpy.uint8
    assert len(numpy.unique(picture.reshape(-1, 3), axis=0)) == 3
    assert environment("paper").render() is None
    with pytest.raises(ValueError, match="^render_mode = human: must be rgb_array or None$"):
        environment("paper", render_mode="human")
