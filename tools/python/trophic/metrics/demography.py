# SPDX-License-Identifier: MIT
"""How many live, how hungry they are, how they die, and whether a species dies out."""
from __future__ import annotations

import math
from collections.abc import Collection, Sequence

import numpy
import pandas

from .tables import WINDOW_S, Agents, Means, Results, Web, means, window_of

CROWD_AT_FLOOR = 8
"""Hunters that the released rules leave when they starve and rescue at their floor: the authors' runs have 8 for 30 % of the time."""
CAUSES = ("caught", "starved", "sacrificed", "senescence")
"""The causes of deaths by rules; a body that diverges dies of none."""
_RULES = {
    "caught": ("capture",),
    "starved": ("starvation", "metabolism"),
    "sacrificed": ("minimum_predators",),
    "senescence": ("senescence",),
}
EXTINCTION = ("extinct", "extinct_at")


def causes_in(rules: Collection[str]) -> tuple[str, ...]:
    """The causes of death that a rule table has a rule for."""
    return tuple(cause for cause in CAUSES if any(slot in rules for slot in _RULES[cause]))


def population_size(agents: Agents, species: str, group: str = "all") -> Means:
    """Members of a group at each tick."""
    return means(agents.window, agents.count(agents.of(species, group)).astype(float))


def hunger(agents: Agents, species: str) -> Means:
    """Ticks since birth or last catch, averaged over the members of a species; ticks without a member are left out."""
    return means(
        agents.window, agents.mean(agents.of(species) & ~numpy.isnan(agents.hunger_ticks), agents.hunger_ticks)
    )


def ticks_at(agents: Agents, species: str, members: int) -> Means:
    """The share of the ticks at which a species has exactly so many members."""
    return means(agents.window, (agents.count(agents.of(species)) == members).astype(float))


def extinct_at(agents: Agents, species: str) -> float:
    """The first tick, in s, from which on a species has no member until the end; nan if it has one at the end, or never had any."""
    alive = numpy.flatnonzero(agents.count(agents.of(species)))
    return float(agents.time_s[alive[-1] + 1]) if len(alive) and alive[-1] + 1 < len(agents.ticks) else math.nan


def deaths(events: pandas.DataFrame, species: str, cause: str | None = None) -> numpy.ndarray:
    """The times of the deaths of members of a species, of one cause or of any, in s."""
    rows = (events.event == "death") & (events.species == species)
    return events.time_s[rows if cause is None else rows & (events.cause == cause)].to_numpy(float)


def per_window(time_s: numpy.ndarray, until_s: float) -> tuple[numpy.ndarray, numpy.ndarray]:
    """How many of these times are in each window up to `until_s`: the ends of the windows, and the counts."""
    ends = numpy.arange(1, max(0, math.ceil(until_s / WINDOW_S)) + 1) * WINDOW_S
    window = window_of(time_s)
    return ends, numpy.bincount(window[window < len(ends)], minlength=len(ends)).astype(float)


def measure_deaths(
    events: pandas.DataFrame, web: Web, until_s: float, results: Results, causes: Sequence[str] = CAUSES
) -> None:
    for species in web.species:
        for cause in (None, *causes):
            name = ("deaths", species, cause or "all", "1")
            time_s = deaths(events, species, cause)
            results.add(*name, float(len(time_s)) if len(events) else math.nan)
            results.add_curve(
                *name, *(per_window(time_s, until_s) if len(events) else (numpy.empty(0), numpy.empty(0)))
            )


def measure_populations(agents: Agents, web: Web, results: Results) -> None:
    for species in web.species:
        for group in ("all", "random", "inherited"):
            results.add_means("population", species, group, "1", population_size(agents, species, group))
        if web.hunts(species):
            results.add_means("hunger", species, "all", "ticks", hunger(agents, species))
            results.add_means("ticks_at", species, str(CROWD_AT_FLOOR), "1", ticks_at(agents, species, CROWD_AT_FLOOR))


def measure_extinction(agents: Agents, web: Web, results: Results) -> None:
    """Whether and when each species dies out. The mean of `extinct` over runs is the share in which it does, and its curve is one less the
    survival function; `extinct_at` has a value only in those runs, the others are censored at their end.
    """
    for species in web.species:
        time_s = extinct_at(agents, species)
        is_gone = numpy.where(agents.time_s >= time_s, 1.0, 0.0)
        last_of_window = numpy.flatnonzero(numpy.diff(agents.window, append=-1))
        ends = (agents.window[last_of_window] + 1) * WINDOW_S
        results.add(
            "extinct", species, "all", "1", math.nan if len(agents.ticks) == 0 else float(not math.isnan(time_s))
        )
        results.add_curve("extinct", species, "all", "1", ends, is_gone[last_of_window])
        results.add("extinct_at", species, "all", "s", time_s)
