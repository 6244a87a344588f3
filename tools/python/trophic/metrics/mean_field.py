# SPDX-License-Identifier: MIT
"""A world without space that has the rates of a run: all meet all, and births, deaths and catches come by chance [rosenzweig1963]."""
from __future__ import annotations

from typing import NamedTuple

import numpy

from .census import Census, dynamics, extinctions, responses

METRICS = ("persists", "extinct_at", "cycles", "period", "amplitude")
RUNS = 20
_SURROGATES = 99
_MOST_STEPS = 2000


class Rates(NamedTuple):
    """Rates per second. Births and deaths a head of a species without victims are lines over its number, `births[i, 0] + births[i, 1] * number`;
    hunters bear `births[i, 0]` for each catch. `waits`: for each link the time that a hunter needs per catch, times the number of victims, and the
    time that it handles one."""

    births: numpy.ndarray
    deaths: numpy.ndarray
    waits: numpy.ndarray


def rates_of(census: Census) -> Rates:
    """The rates of a run; zero for what never happened."""
    births, deaths = (numpy.zeros((len(census.web.species), 2)) for _ in range(2))
    for i, species in enumerate(census.web.species):
        alive = census.numbers[i, :-1].astype(float)
        deaths[i] = linear(alive, (census.deaths - census.caught)[i, 1:], not census.web.hunts(species)) / census.tick_s
        if census.web.hunts(species):
            births[i, 0] = census.births[i, 1:].sum() / max(
                1, census.catches[[hunter == i for hunter, _ in census.links]].sum()
            )
        else:
            births[i] = linear(alive, census.births[i, 1:]) / census.tick_s
    waits = numpy.full((len(census.links), 2), (numpy.inf, 0.0))
    for wait, met in zip(waits, census.meetings()):
        attack, reciprocal, handling_s = responses(*met)
        if attack > 0.0:
            wait[:] = (reciprocal, handling_s) if handling_s > 0.0 else (1.0 / attack, 0.0)
    return Rates(births, deaths, waits)


def linear(alive: numpy.ndarray, events: numpy.ndarray, is_dense: bool = True) -> numpy.ndarray:
    """Events a head and tick as a line over the number alive, by least squares with weights of Poisson numbers; level if not `is_dense`."""
    lives = alive > 0
    alive, events = alive[lives], events[lives]
    if len(alive) == 0:
        return numpy.zeros(2)
    level = numpy.array([events.sum() / alive.sum(), 0.0])
    if not is_dense or numpy.ptp(alive) == 0.0:
        return level
    return numpy.linalg.lstsq(numpy.column_stack([alive**0.5, alive**1.5]), events / alive**0.5, rcond=None)[0]


def simulate(
    rates: Rates, census: Census, most: int, runs: int, rng: numpy.random.Generator, until_s: float
) -> tuple[numpy.ndarray, float]:
    """Numbers of each species in simulated runs that begin as the run and last until its planned end: shape (species, runs, steps), and the length
    of a step, s. A step is so short that few die or are born in it."""
    ticks = int(until_s / census.tick_s * (1.0 + 1e-12)) + 1
    every = max(1, -(-ticks // _MOST_STEPS))
    step_s = every * census.tick_s
    numbers = numpy.repeat(census.numbers[:, :1], runs, axis=1)
    series = [numbers]
    for _ in range(1, -(-ticks // every)):
        after, gained = numbers.copy(), numpy.zeros(numbers.shape)
        for (hunter, prey), (reciprocal, handling_s) in zip(census.links, rates.waits):
            with numpy.errstate(divide="ignore"):
                per_hunter = 1.0 / (reciprocal / numbers[prey] + handling_s)
            caught = numpy.minimum(rng.poisson(numbers[hunter] * per_hunter * step_s), after[prey])
            after[prey] -= caught
            gained[hunter] += caught
        for i, species in enumerate(census.web.species):
            died = numpy.maximum(rates.deaths[i, 0] + rates.deaths[i, 1] * numbers[i], 0.0) * step_s
            born = (
                gained[i] * rates.births[i, 0]
                if census.web.hunts(species)
                else numbers[i] * step_s * numpy.maximum(rates.births[i, 0] + rates.births[i, 1] * numbers[i], 0.0)
            )
            after[i] += rng.poisson(born) - rng.binomial(after[i], 1.0 - numpy.exp(-died))
        over = after.sum(axis=0) > most
        after[:, over] = after[:, over] * most // after[:, over].sum(axis=0)
        numbers = after
        series.append(numbers)
    return numpy.stack(series, axis=2), step_s


def means_of(census: Census, most: int, seed: int, until_s: float) -> dict[tuple[str, str], float]:
    """The means of METRICS over simulated runs, by metric and species; empty without links or ticks."""
    if not census.links or census.numbers.shape[1] < 2:
        return {}
    series, step_s = simulate(rates_of(census), census, most, RUNS, numpy.random.default_rng(seed), until_s)
    persists = extinctions(series) == series.shape[2]
    found: dict[tuple[str, str], float] = {("persists", "all"): persists.all(axis=0).mean()}
    for species, runs, lives in zip(census.web.species, series, persists):
        each = [dynamics(one, seed + i, _SURROGATES) for i, one in enumerate(runs)]
        found["persists", species] = lives.mean()
        with numpy.errstate(all="ignore"):
            for name, values in (
                ("extinct_at", [gone * step_s for gone, _ in each if gone < numpy.inf]),
                ("cycles", [cycle.is_there for _, cycle in each if cycle.p == cycle.p]),
                ("period", [cycle.period * step_s for _, cycle in each if cycle.period == cycle.period]),
                ("amplitude", [cycle.amplitude for _, cycle in each if cycle.amplitude == cycle.amplitude]),
            ):
                found[name, species] = float(numpy.mean(values)) if values else numpy.nan
    return found
