# SPDX-License-Identifier: MIT
"""How fast robots walk away from walls, how often they touch one, and how long they lie on their backs.

Tilt and contacts are in senses.csv, which runs with --senses have; a point of the kinematic backend touches a wall if its radius reaches it."""
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy
import pandas

from .tables import WINDOW_S, Agents, Means, Results, Web, means, numbers, window_of
from .walls import REACH_M, Floor, to_wall_m

if TYPE_CHECKING:
    from ..pool import PooledRun


def with_contacts(agents: pandas.DataFrame, run: PooledRun, remarks: list[str]) -> pandas.DataFrame:
    """The rows of agents.csv with the columns tilt_rad and touches_wall, as far as they are known. Raises RunError for a cell of senses.csv that
    is not a number."""
    radius_m = run.manifest.get("params", {}).get("backend", {}).get("radius_m")
    if radius_m is not None:
        from_wall_m = run.floor.to_wall_m(agents.x_m, agents.y_m)
        return agents.assign(touches_wall=(from_wall_m <= radius_m + 1e-6).astype(float))  # positions are rounded
    if not (run.path / "senses.csv").exists():
        return agents
    table = run.texts("senses.csv", ["tick", "body", "tilt_rad", "touches_wall"], (), remarks)
    senses = pandas.DataFrame({name: numbers(run.path / "senses.csv", table[name], ("",)) for name in table})
    return agents.merge(senses.astype({"tick": int, "body": int}), how="left", on=["tick", "body"])


def is_upright(agents: Agents) -> numpy.ndarray:
    """Rows whose root's z axis does not point down; false if the tilt is not known."""
    return agents.tilt_rad <= 0.5 * numpy.pi


def curves(agents: Agents, species: str, floor: Floor, window_s: float = WINDOW_S) -> dict[str, Means]:
    """Means over the members of a species, by the window of the row. walked: distance per second, in m/s, from an individual's row at the tick
    before; it includes turns. open_speed: with both rows more than 1 m from any wall; upright_speed: and upright in both. overturned and
    wall_contact: the share of those of whom it is known."""
    own, is_open = agents.of(species), to_wall_m(agents, floor) > REACH_M
    before = agents.before
    time_s = agents.time_s[agents.at]
    with numpy.errstate(divide="ignore", invalid="ignore"):
        speed = numpy.hypot(agents.x_m - agents.x_m[before], agents.y_m - agents.y_m[before]) / (
            time_s - time_s[before]
        )

    def both(rows: numpy.ndarray) -> numpy.ndarray:
        return rows & (before >= 0) & rows[before]

    of = {
        "walked": (both(own), speed),
        "open_speed": (both(own & is_open), speed),
        "upright_speed": (both(own & is_open & is_upright(agents)), speed),
        "overturned": (own & ~numpy.isnan(agents.tilt_rad), (~is_upright(agents)).astype(float)),
        "wall_contact": (own & ~numpy.isnan(agents.touches_wall), agents.touches_wall),
    }
    window = window_of(agents.time_s, window_s)
    return {name: means(window, agents.mean(*rows_and_values), window_s) for name, rows_and_values in of.items()}


def measure(agents: Agents, web: Web, floor: Floor, results: Results) -> None:
    for species in web.species:
        of = curves(agents, species, floor)
        for name in ("open_speed", "upright_speed", "overturned", "wall_contact"):
            results.add_means(name, species, "all", "m/s" if name.endswith("speed") else "1", of[name])
