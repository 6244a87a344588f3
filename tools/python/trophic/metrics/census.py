# SPDX-License-Identifier: MIT
"""Numbers of each species at each tick, what becomes of them, and what hunters catch at which number of victims."""
from __future__ import annotations

import math

import numpy
import pandas

from . import cycles
from .tables import Web


class Census:
    """Numbers and events of each species at each tick; shapes (species, ticks), of catches (links, ticks)."""

    def __init__(self, events: pandas.DataFrame, web: Web, tick_s: float, until_s: float):
        self.web, self.tick_s = web, tick_s
        ticks = int(until_s / tick_s * (1.0 + 1e-12)) + 1
        self.time_s = tick_s * numpy.arange(ticks)
        code = pandas.Categorical(events.species, categories=web.species).codes.astype(int)
        tick = numpy.minimum(numpy.rint(events.time_s.to_numpy(float) / tick_s).astype(int), ticks - 1)
        event = events.event.to_numpy(str)
        species_of = dict(zip(events.id[event == "birth"], code[event == "birth"]))
        victim = numpy.array([species_of.get(one, -1) for one in events.victim_id])

        def counted(rows: numpy.ndarray) -> numpy.ndarray:
            return numpy.bincount(tick[rows], minlength=ticks)

        each = range(len(web.species))
        self.births, self.deaths, self.caught = (
            numpy.array([counted((event == what) & (code == one) & of) for one in each]).reshape(-1, ticks)
            for what, of in (("birth", True), ("death", True), ("death", (events.cause == "caught").to_numpy()))
        )
        self.numbers = numpy.cumsum(self.births - self.deaths, axis=1)
        self.links = [(web.species.index(hunter), web.species.index(prey)) for hunter, prey in web.links]
        is_catch = event == "catch"
        self.catches = numpy.array(
            [counted(is_catch & (code == hunter) & (victim == prey)) for hunter, prey in self.links]
        ).reshape(-1, ticks)

    def meetings(self) -> list[tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]]:
        """Returns for each link and each tick but the first the victims at its beginning, the time that hunters had, s, and the catches."""
        return [
            (self.numbers[prey, :-1].astype(float), self.numbers[hunter, :-1] * self.tick_s, catches[1:])
            for (hunter, prey), catches in zip(self.links, self.catches)
        ]


def extinctions(numbers: numpy.ndarray) -> numpy.ndarray:
    """The first tick from which on each series along the last axis is 0; its length if none. A series of zeros never was there: its length too."""
    lives = numbers > 0
    last = numbers.shape[-1] - lives[..., ::-1].argmax(axis=-1)
    return numpy.where(lives.any(axis=-1), last, numbers.shape[-1])


def dynamics(numbers: numpy.ndarray, seed: int = 0, surrogates: int = cycles.SURROGATES) -> tuple[float, cycles.Cycle]:
    """The tick of extinction of a series, inf if it lives, and its cycle, in ticks. The first quarter is left out: it shows the founders."""
    gone = int(extinctions(numbers))
    points, every = (
        cycles.thinned(numbers[len(numbers) // 4 : gone].astype(float))
        if gone > len(numbers) // 4
        else (numpy.empty(0), 1)
    )
    cycle = cycles.cycle_of(points, surrogates, seed)
    return (math.inf if gone == len(numbers) else float(gone)), cycle._replace(period=cycle.period * every)


def responses(density: numpy.ndarray, hunter_s: numpy.ndarray, catches: numpy.ndarray) -> tuple[float, float, float]:
    """Functional responses [holling1959] of greatest likelihood, of catches as Poisson numbers. Type I: a hunter catches search_rate * density a
    second; type II: 1 / (reciprocal / density + handling_time), in which a handling time below 0 means that catches grow faster than density.

    `density`: victims, 1/m2; `hunter_s`: the time that hunters hunted at it. Returns the search rate of type I, m2/s, the reciprocal of that of type
    II, and the handling time, s; nan without catches, and of type II at one density."""
    from scipy import optimize

    values, place = numpy.unique(density, return_inverse=True)
    time_s, caught = (numpy.bincount(place, of, len(values))[values > 0.0] for of in (hunter_s, catches))
    values = values[values > 0.0]
    hunted = time_s > 0.0
    values, time_s, caught = values[hunted], time_s[hunted], caught[hunted]
    if caught.sum() == 0:
        return math.nan, math.nan, math.nan
    attack = caught.sum() / (time_s @ values)
    if len(values) < 3:
        return attack, math.nan, math.nan

    def loss(
        of: numpy.ndarray,
    ) -> float:  # of 1 / (search rate * mean density) and handling time, in units of the time between catches
        wait = of[0] * middle / values + of[1]
        return (
            math.inf
            if of[0] <= 0.0 or (wait <= 0.0).any()
            else float(time_s @ (1.0 / wait) / between_s + caught @ numpy.log(wait))
        )

    middle, between_s = (time_s @ values) / time_s.sum(), time_s.sum() / caught.sum()
    best = optimize.minimize(loss, [0.8, 0.2], method="Nelder-Mead", options={"xatol": 1e-5, "fatol": 1e-8})
    return attack, best.x[0] * middle * between_s, best.x[1] * between_s
