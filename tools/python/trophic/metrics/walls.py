# SPDX-License-Identifier: MIT
"""Wall sticking: the share of a species that is close to a wall."""
from __future__ import annotations

import numpy

from .tables import GROUPS, Agents, Means, Results, Web, means

REACH_M = 1.0
"""The paper: "within one unit of distance to any of the four walls" (Sec. "Metrics for system dynamics")."""


def wall_sticking(agents: Agents, species: str, group: str, half_side_m: float, reach_m: float = REACH_M) -> Means:
    """At each tick, members of the group within reach of a wall (or, in an arena without walls, of where its slopes begin, and beyond) over
    all its members; ticks without a member are left out. `half_side_m`: of the flat floor."""
    return means(agents.window, agents.mean(agents.of(species, group), (to_wall_m(agents, half_side_m) <= reach_m).astype(float)))


def to_wall_m(agents: Agents, half_side_m: float) -> numpy.ndarray:
    """The distance of each row from the nearest wall, in m."""
    return half_side_m - numpy.maximum(numpy.abs(agents.x_m), numpy.abs(agents.y_m))


def share_of_floor(half_side_m: float, reach_m: float = REACH_M) -> float:
    """The share of robots that are spread evenly over the floor."""
    return 1.0 - max(0.0, 1.0 - reach_m / half_side_m) ** 2


def measure(agents: Agents, web: Web, half_side_m: float, results: Results, suffix: str = "") -> None:
    """`suffix`: of the metrics' names."""
    uniform = (("uniform_density", "reference", share_of_floor(half_side_m)),)
    shares = {}
    for species in web.species:
        for group in GROUPS:
            share = wall_sticking(agents, species, group, half_side_m)
            shares[species, group] = share.mean
            results.add_means(f"wall_sticking{suffix}", species, group, "1", share, baselines=uniform)
    for hunter, victim in web.links:
        for group in ("all", "active"):
            gap = shares[victim, group] - shares[hunter, group]
            results.add(f"wall_sticking_gap{suffix}", f"{victim}-{hunter}", group, "1", gap, (("zero", "reference", 0.0),))
