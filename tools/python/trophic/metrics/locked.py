# SPDX-License-Identifier: MIT
"""Robots that are locked into each other: near the same other one for 12 s or longer. They hardly move, on legs for minutes to an hour, so
metrics are also given without them: NAME_not_locked."""
from __future__ import annotations

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
    """Finds the pairs by a tree of the positions of each tick. Bodies count: a birth in one does not end a lock."""
    from scipy.spatial import cKDTree

    place_m = numpy.column_stack((agents.x_m, agents.y_m))
    ends = numpy.searchsorted(agents.at, numpy.arange(len(agents.ticks) + 1))
    near = numpy.concatenate(
        [
            numpy.empty((0, 2), int),
            *(
                first + cKDTree(place_m[first:last]).query_pairs(reach_m, output_type="ndarray")
                for first, last in zip(ends, ends[1:])
            ),
        ]
    )
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
