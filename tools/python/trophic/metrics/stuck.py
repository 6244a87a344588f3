# SPDX-License-Identifier: MIT
"""How many robots stand still."""
from __future__ import annotations

from collections.abc import Sequence

import numpy

from .tables import Agents, Means, Results, Web, means

REACH_M = 0.05
"""A robot is stuck that ends less than this far from where it was TICKS ticks before."""
TICKS = 5
"""10 s."""


def stuck(agents: Agents, species: str | None = None, reach_m: float = REACH_M, ticks: int = TICKS) -> Means:
    """At each tick the share of stuck robots of a species, or of all; ticks without a member or without one `ticks` later are left out.
    Bodies count, for the species that they belong to at the start: a birth meanwhile does not move them.
    """
    return _shares(agents, [species], reach_m, ticks)[0]


def measure(agents: Agents, web: Web, results: Results) -> None:
    of = (*web.species, None)
    for species, share in zip(of, _shares(agents, of, REACH_M, TICKS)):
        results.add_means("stuck", species or "all", "all", "1", share)


def _shares(agents: Agents, of: Sequence[str | None], reach_m: float, ticks: int) -> list[Means]:
    later = agents.later(ticks)
    to = agents.find_body(later[agents.at], agents.body)
    is_there = to >= 0
    is_stuck = (numpy.hypot(agents.x_m[to] - agents.x_m, agents.y_m[to] - agents.y_m) < reach_m).astype(float)
    shares = [agents.mean(agents.of(species) & is_there, is_stuck) for species in of]
    return [means(agents.window[later >= 0], share[later >= 0]) for share in shares]
