# SPDX-License-Identifier: MIT
"""Robots that are locked into each other: near the same other one for 12 s or longer. They hardly move, on legs for minutes to an hour, so
metrics are also given without them: NAME_not_locked."""
from __future__ import annotations

import itertools
from typing import NamedTuple

import numpy
import pandas

from .tables import Agents, Results, Web, means

REACH_M = 0.3
TICKS = 6
"""12 s."""


class Locks(NamedTuple):
    """row: whether the robot in each row of agents is locked, that is in a pair that stays near for at least TICKS ticks around that row. pairs: at
    each tick, pairs that are near, however long. longest_s: of a pair, unbroken; 0 without a pair, nan without a tick.
    """

    row: numpy.ndarray
    pairs: numpy.ndarray
    longest_s: float


def locks(agents: Agents, reach_m: float = REACH_M, ticks: int = TICKS) -> Locks:
    """Finds the pairs along x at each tick. Bodies count: a birth in one does not end a lock."""
    along = numpy.lexsort((agents.x_m, agents.at))
    its_at, x_m, y_m = agents.at[along], agents.x_m[along], agents.y_m[along]
    pairs, one = [numpy.empty((0, 2), int)], numpy.arange(len(along))
    for apart in itertools.count(1):  # places in the order of x: once the next but N is too far, all beyond it are
        one = one[: numpy.searchsorted(one, len(along) - apart)]
        offset_m = x_m[one + apart] - x_m[one]
        one, offset_m = (of[(its_at[one + apart] == its_at[one]) & (offset_m <= reach_m)] for of in (one, offset_m))
        if not len(one):
            break
        other = one + apart
        is_near = offset_m**2 + (y_m[other] - y_m[one]) ** 2 <= reach_m**2
        pairs.append(along[numpy.column_stack((one, other))[is_near]])
    near = numpy.concatenate(pairs)
    at, (low, high) = agents.at[near[:, 0]], numpy.sort(agents.body[near]).T
    order = numpy.lexsort((at, high, low))
    near, at, low, high = near[order], at[order], low[order], high[order]
    is_first = (
        (numpy.diff(low, prepend=-1) != 0) | (numpy.diff(high, prepend=-1) != 0) | (numpy.diff(at, prepend=-2) != 1)
    )
    first = numpy.flatnonzero(is_first)
    last = numpy.append(first[1:], len(at))[: len(first)] - 1
    is_long = agents.ticks[at[last]] - agents.ticks[at[first]] >= ticks
    row = numpy.zeros(len(agents.at), bool)
    row[near[is_long[numpy.cumsum(is_first) - 1]]] = True
    longest_s = (
        (agents.time_s[at[last]] - agents.time_s[at[first]]).max(initial=0.0) if len(agents.ticks) else numpy.nan
    )
    return Locks(row, numpy.bincount(at, minlength=len(agents.ticks)).astype(float), float(longest_s))


def events_of_free(events: pandas.DataFrame, agents: Agents, locked: numpy.ndarray) -> pandas.DataFrame:
    """The events of individuals that are not locked at the last tick before."""
    before = agents.find(
        numpy.searchsorted(agents.time_s, events.time_s.to_numpy(float)) - 1, events.id.to_numpy(float)
    )
    return events[~numpy.append(locked, False)[before]]  # -1: no row before


def measure(agents: Agents, web: Web, found: Locks | None, results: Results) -> None:
    """`found`: None if the table lacks the ticks for it."""
    for species in (*web.species, None):
        share = (
            agents.mean(agents.of(species), found.row.astype(float))
            if found
            else numpy.full(len(agents.ticks), numpy.nan)
        )
        results.add_means("locked", species or "all", "all", "1", means(agents.window, share))
    results.add_means(
        "near_pairs",
        "all",
        "all",
        "1",
        means(agents.window, found.pairs if found else numpy.full(len(agents.ticks), numpy.nan)),
    )
    results.add("near_longest", "all", "all", "s", found.longest_s if found else numpy.nan)
