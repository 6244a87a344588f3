# SPDX-License-Identifier: MIT
"""The race with sight: it is the race without sight if sight is free and covers the floor, and costs grow with the square of each trait."""

import pytest

RUN = ["--backend", "kinematic", "--duration", 300, "--seed", 5, "--replay-hz", 0]
BOTH = ("prey", "predator")


def settings(**values):
    return [word for path, value in values.items() for word in ("--set", f"rules.{path.replace('__', '.')}={value}")]


def paces(first):
    return settings(traits__walking_pace__sd=0, traits__walking_pace__first=first)


def sights(cost, first=60):
    costs = {f"metabolism__{species}__sight_W_per_m2": cost for species in BOTH}
    return settings(traits__sight_m__sd=0, traits__sight_m__first=first, **costs)


def race(**metabolism):
    return settings(metabolism__predator__efficiency=0.25, **metabolism)


@pytest.mark.parametrize("pace", [1, 2])
def test_with_free_sight_it_is_the_race_and_a_metre_costs_as_many_times_as_much_as_pace(folder, pace):
    metres = {f"metabolism__{species}__walking_J_per_m": pace for species in BOTH}
    folder.run("trophic-worlds", "--rules", "pond_race", *RUN, *paces(pace), *race(**metres), "--out", "race")
    folder.run("trophic-race", *RUN, *paces(pace), *sights(0), "--out", "sight")
    tables = ["events.csv", "energy.csv"]
    assert folder.bytes_of("race", tables) == folder.bytes_of("sight", tables)


def test_sight_costs_its_square_and_hides_what_is_farther(folder):
    found = {}
    for name, *of in (("near", 1e-4, 30), ("far", 1e-4, 60), ("short", 1e-4, 1)):
        folder.run("trophic-race", *RUN, *paces(1), *sights(*of), "--out", name)
        found[name] = [float(row["upkeep_J"]) for row in folder.rows(f"{name}/energy.csv") if row["tick"] == "1"]
    for species, robots in enumerate((192, 48)):
        assert found["far"][species] - found["near"][species] == pytest.approx(
            1e-4 * (60**2 - 30**2) * 2.0 * robots
        )
    seen = [row["adversary_id"] for row in folder.rows("short/agents.csv") if row["tick"] == "0"]
    assert sum(seen_id != "" for seen_id in seen) < len(seen) / 4
