# SPDX-License-Identifier: MIT
"""Velocity: how fast robots approach the place at which their adversary was.

A sample is one robot over one stretch of time: (dist(P1, A1) - dist(P2, A1)) / duration with P1, P2 its own position at the start and the end
and A1 its adversary's at the start, positive towards the adversary (Eq. 6 of Sec. "Metrics for system dynamics"). A walk past something close
ends farther away on average, so the null is the neutral shadow, not zero."""
from __future__ import annotations

from typing import NamedTuple

import numpy
import pandas

from .tables import APART, GROUPS, Agents, Means, Results, Web, means

TICKS = 6
"""A stretch of the paper: 12 s."""


class Samples(NamedTuple):
    """The row of agents at which each stretch begins, its window, the place of the tick at which it ends, and its velocity in m/s."""

    row: numpy.ndarray
    window: numpy.ndarray
    end: numpy.ndarray
    velocity_m_s: numpy.ndarray


def samples(agents: Agents, ticks: int = TICKS) -> Samples:
    """Every stretch of every robot that has an adversary at its start, one from each tick. The adversary may die meanwhile; if the robot
    dies, there is no sample."""
    return _towards(agents, agents.adversary, ticks)


def stored_samples(agents: Agents, ticks: int = TICKS) -> Samples:
    """As samples, with the adversary that the authors' log stores: for each body the body that it last perceived as closest, kept across
    births and while it perceives none. The published velocities come from such a log. Needs the rows of every tick.
    """
    seen = agents.adversary
    body = numpy.where(seen >= 0, agents.body[seen] if len(seen) else 0, numpy.nan)
    stored = pandas.Series(body).groupby(agents.body).ffill().to_numpy()
    return _towards(agents, agents.find_body(agents.at, stored), ticks)


def at_marks(of: Samples, agents: Agents, every_s: float = 200.0, ticks: int = TICKS) -> Samples:
    """The samples of the stretches that end at a mark: at the first tick at or after 200, 400, ... s at which a stretch ends. The paper's
    "population averages measured every 200 seconds, resulting in 30 points" may be these instead of means over windows.
    """
    later = agents.later(ticks)
    ends = later[later >= 0]
    mark = numpy.floor(agents.time_s[ends] / every_s)
    first = numpy.flatnonzero(numpy.diff(mark, prepend=0.0))  # the first end from each mark on
    chosen = numpy.isin(of.end, ends[first])
    return _chosen(of, chosen)


def velocity(of: Samples, agents: Agents, species: str, group: str) -> Means:
    """The velocity of a group; `mean_of_points` is the straight line in the paper's figure."""
    return _mean(of, agents.of(species, group))


def of_rows(of: Samples, rows: numpy.ndarray) -> Samples:
    """The samples that begin at these rows."""
    return _chosen(of, rows[of.row])


def measure(
    agents: Agents,
    web: Web,
    every_ticks: int,
    results: Results,
    *,
    simulated_s_per_s: float,
    free: numpy.ndarray,
    is_open: numpy.ndarray,
    is_upright: numpy.ndarray,
    is_constant: bool = True,
) -> None:
    """`simulated_s_per_s`: simulated seconds in a second of the clock. The others: rows that are not locked, away from walls, and upright. Unless
    numbers are constant, the plain velocity is of the active and inactive apart as well."""
    walks = samples(agents)
    kinds = {
        "velocity": walks,
        "velocity_points": at_marks(walks, agents),
        "velocity_stored": stored_samples(agents)
        if every_ticks == 1
        else of_rows(walks, numpy.zeros(len(agents.at), bool)),
        "velocity_simulated": walks._replace(velocity_m_s=walks.velocity_m_s / simulated_s_per_s),
        "velocity_not_locked": of_rows(walks, free),
        "velocity_open": of_rows(walks, is_open),
        "velocity_upright": of_rows(walks, is_open & is_upright),
    }
    members = {(species, group): agents.of(species, group) for species in web.species for group in GROUPS + APART}
    for metric, of in kinds.items():
        for species in web.species:
            for group in GROUPS + APART * (metric == "velocity" and not is_constant):
                found = _mean(of, members[species, group])
                results.add_means(metric, species, group, "m/s", found, found.mean_of_points, (("zero", "paper", 0.0),))


def _chosen(of: Samples, chosen: numpy.ndarray) -> Samples:
    places = numpy.flatnonzero(chosen)
    return Samples(*(part[places] for part in of))


def _mean(of: Samples, rows: numpy.ndarray) -> Means:
    """Of the samples that begin at these rows."""
    chosen = numpy.flatnonzero(rows[of.row])
    return means(of.window[chosen], of.velocity_m_s[chosen])


def _towards(agents: Agents, adversary: numpy.ndarray, ticks: int) -> Samples:
    end, to = agents.later(ticks)[agents.at], agents.after(ticks)
    row = numpy.flatnonzero((adversary >= 0) & (to >= 0))
    to, adversary = to[row], adversary[row]

    def distance(place: numpy.ndarray) -> numpy.ndarray:
        return numpy.hypot(agents.x_m[adversary] - agents.x_m[place], agents.y_m[adversary] - agents.y_m[place])

    duration_s = agents.time_s[agents.at[to]] - agents.time_s[agents.at[row]]
    return Samples(row, agents.window[agents.at[row]], end[row], (distance(row) - distance(to)) / duration_s)
