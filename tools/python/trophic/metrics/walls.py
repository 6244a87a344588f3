# SPDX-License-Identifier: MIT
"""Wall sticking: the share of a species that is close to a wall or an obstacle."""
from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy

from .tables import GROUPS, Agents, Means, Results, Web, means

REACH_M = 1.0
"""The paper: "within one unit of distance to any of the four walls" (Sec. "Metrics for system dynamics")."""


@dataclasses.dataclass(frozen=True)
class Floor:
    """The floor of an arena: a square, and what stands on it."""

    half_side_m: float
    obstacles: Sequence[tuple[float, ...]] = ()
    """of each, in m: x and y of the two ends of its axis, radius, height"""

    def to_wall_m(self, x_m: numpy.ndarray, y_m: numpy.ndarray) -> numpy.ndarray:
        """The distance of places from the nearest wall or obstacle, in m; negative in it."""
        nearest = self.half_side_m - numpy.maximum(numpy.abs(x_m), numpy.abs(y_m))
        for x1, y1, x2, y2, radius, _ in self.obstacles:
            length2 = (x2 - x1) ** 2 + (y2 - y1) ** 2
            part = (
                numpy.clip(((x_m - x1) * (x2 - x1) + (y_m - y1) * (y2 - y1)) / length2, 0.0, 1.0)
                if length2 > 0
                else numpy.zeros_like(x_m)
            )
            nearest = numpy.minimum(
                nearest, numpy.hypot(x_m - x1 - part * (x2 - x1), y_m - y1 - part * (y2 - y1)) - radius
            )
        return nearest


def wall_sticking(agents: Agents, species: str, group: str, floor: Floor, reach_m: float = REACH_M) -> Means:
    """At each tick, members of the group within reach of a wall or an obstacle (or, in an arena without walls, of where its slopes begin, and
    beyond) over all its members; ticks without a member are left out."""
    return _share(agents, species, group, (to_wall_m(agents, floor) <= reach_m).astype(float))


def to_wall_m(agents: Agents, floor: Floor) -> numpy.ndarray:
    """The distance of each row from the nearest wall or obstacle, in m."""
    return floor.to_wall_m(agents.x_m, agents.y_m)


def share_of_floor(floor: Floor, reach_m: float = REACH_M) -> float:
    """The share of robots that are spread evenly over the floor; with obstacles, from a grid of 400 x 400 places."""
    if not floor.obstacles:
        return 1.0 - max(0.0, 1.0 - reach_m / floor.half_side_m) ** 2
    line = (numpy.arange(400) + 0.5) / 200.0 * floor.half_side_m - floor.half_side_m
    from_wall = floor.to_wall_m(*numpy.meshgrid(line, line))
    return float(numpy.mean(from_wall[from_wall > 0.0] <= reach_m))


def measure(
    agents: Agents, web: Web, floor: Floor, results: Results, suffix: str = "", is_constant: bool = True
) -> None:
    """`suffix`: of the metrics' names. Unless numbers are constant, the inactive are a group of their own."""
    uniform = (("uniform_density", "reference", share_of_floor(floor)),)
    shares, is_near = {}, (to_wall_m(agents, floor) <= REACH_M).astype(float)
    for species in web.species:
        for group in GROUPS + ("inactive",) * (not is_constant):
            share = _share(agents, species, group, is_near)
            shares[species, group] = share.mean
            results.add_means(f"wall_sticking{suffix}", species, group, "1", share, baselines=uniform)
    for hunter, victim in web.links:
        for group in ("all", "active"):
            gap = shares[victim, group] - shares[hunter, group]
            results.add(
                f"wall_sticking_gap{suffix}", f"{victim}-{hunter}", group, "1", gap, (("zero", "reference", 0.0),)
            )


def _share(agents: Agents, species: str, group: str, is_near: numpy.ndarray) -> Means:
    return means(agents.window, agents.mean(agents.of(species, group), is_near))
