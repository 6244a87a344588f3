# SPDX-License-Identifier: MIT
"""The measures of change of the Red Queen study on hand-written runs."""
import math
import types

import change
import numpy
import pandas
import pytest
import traits


def run_of(genome_ids):
    """Two prey of 60 s: one lives throughout, the other is born at 25 s. They hold these genomes; windows are 20 to 30 s and 50 to 60 s."""
    tables = {
        "genomes": pandas.DataFrame({"id": [0, 1], "genome_id": genome_ids, "time_s": [0.0, 25.0]}),
        "phylogeny": pandas.DataFrame(
            {"id": [0, 1], "species": "prey", "origin_time": [0.0, 25.0], "destruction_time": math.inf}
        ),
    }
    return types.SimpleNamespace(
        table=tables.__getitem__, manifest={"species": ["prey", "predator"], "result": {"reached_s": 60.0}}
    )


@pytest.mark.parametrize(
    "genome_ids, early, late",
    [
        ([0, 1], (10 * 1.0 + 5 * 3.0) / 15, 2.0),  # a genome each
        ([0, 0], (5 * 1.0 + 10 * 3.0) / 15, 3.0),  # both have the values of the birth, from then on
    ],
)
def test_the_mean_moves_as_the_living_and_what_they_share(genome_ids, early, late):
    (prey, moved), (predator, none) = change.moved(run_of(genome_ids), numpy.array([[1.0], [3.0]]))
    assert (prey, predator) == ("prey", "predator") and moved == pytest.approx(late - early) and math.isnan(none)


RULE = {"first": 1.0, "least": -9.0, "most": 9.0, "sd": 0.1}


def racing(**rule):
    """A run of 60 s: of prey 0, 1 and 2 each is the child of the one before and has 0.5 more; two predators are founders, one dies at 40 s."""
    tables = {
        "genomes": pandas.DataFrame({"id": range(5), "pace": [1.0, 1.5, 2.0, 1.0, 1.0]}),
        "phylogeny": pandas.DataFrame(
            {
                "id": range(5),
                "ancestor_id": [0, 0, 1, 3, 4],
                "species": ["prey"] * 3 + ["predator"] * 2,
                "origin_time": [0.0, 10.0, 20.0, 0.0, 0.0],
                "destruction_time": [15.0, 30.0, math.inf, math.inf, 40.0],
            }
        ),
    }
    rules = {
        "traits": {"pace": RULE | rule},
        "heredity": {"prey": {"inherited": True}, "predator": {"inherited": False}},
    }
    return types.SimpleNamespace(
        table=tables.__getitem__,
        manifest={
            "species": ["prey", "predator"],
            "seed": "1",
            "result": {"reached_s": 60.0},
            "params": {"rules": rules},
        },
    )


def test_drift_adds_up_along_a_lineage_that_inherits_and_only_there():
    born = traits.born_of(racing())
    inherits = {"prey": True, "predator": False}
    found = traits.dropped(born, RULE, inherits, numpy.random.default_rng(1), 40_000)
    assert found.mean(axis=1) == pytest.approx(1.0, abs=0.005)
    assert found.var(axis=1) / 0.01 == pytest.approx([1.0, 2.0, 3.0, 1.0, 1.0], rel=0.05)
    alone = traits.dropped(born, RULE, {"prey": False, "predator": False}, numpy.random.default_rng(1), 40_000)
    assert alone.var(axis=1) / 0.01 == pytest.approx([1.0] * 5, rel=0.05)


def test_drift_stays_within_the_bounds_of_the_trait():
    rule = RULE | {"least": 0.95, "most": 1.02}
    found = traits.dropped(
        traits.born_of(racing()), rule, {"prey": True, "predator": True}, numpy.random.default_rng(1)
    )
    assert found.min() == 0.95 and found.max() == 1.02


def test_a_trait_that_rises_is_over_drift_and_one_that_does_not_is_not():
    course = traits.Course(racing(sd=0.0), "pace")
    assert course.persists and course.own["prey"][0, 0] == 1.0 and course.own["prey"][-1, 0] == 2.0
    prey, predator = (course.values(side) for side in ("prey", "predator"))
    assert prey["trait_end"] == pytest.approx(1.0) and prey["trait_slope"] == pytest.approx(0.0)
    assert prey["trait_common"] == pytest.approx((0.5 + 1.0) / 2.0, abs=0.3)  # near 20 s
    assert predator["trait_end"] == 0.0 and predator["lived_s"] == 60.0


def test_a_run_that_loses_a_species_has_no_end():
    run = racing()
    run.table("phylogeny").loc[2, "destruction_time"] = 50.0
    course = traits.Course(run, "pace")
    found = course.values("prey")
    assert not course.persists and "trait_end" not in found and found["lived_s"] == pytest.approx(49.5)
