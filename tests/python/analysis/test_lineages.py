# SPDX-License-Identifier: MIT
"""Lineage measures of forests by hand."""
import dataclasses
import itertools
import math

import numpy
import pandas
import pytest
from pytest import approx
from trophic.metrics.forests import Forest, activity, descent, modes, persistent, presence
from trophic.metrics.lineages import DRIFT, lineage_values, metric_names, window_of
from trophic.errors import RunError
from trophic.runs import Run

ALIVE = math.inf


def forest(*individuals, types=None, complexity=None):
    """(parent, birth_s, death_s[, species]) each; the parent of a root is -1."""
    rows = [(*one, "prey")[:4] for one in individuals]
    parent, birth, death, species = zip(*rows)
    places = numpy.arange(len(rows))
    return Forest(
        numpy.array(parent),
        numpy.array(birth, dtype=float),
        numpy.array(death, dtype=float),
        numpy.array(species),
        places if types is None else numpy.array(types),
        places if complexity is None else numpy.array(complexity),
    )


def two_trees(**kinds):
    """0 has the offspring 1 and 2, 1 has 5, 2 has 3; 4 is alone. 0 and 2 die."""
    return forest((-1, 0, 50), (0, 10, ALIVE), (0, 20, 60), (2, 40, ALIVE), (-1, 30, ALIVE), (1, 70, ALIVE), **kinds)


@pytest.mark.parametrize(
    "species, start_s, end_s, kept",
    [
        ("prey", 0, 25, [0]),
        ("prey", 25, 100, [1, 2]),  # 0 is alive at 25 s, but 1 and 2 are more recent
        ("prey", 55, 100, [1, 3, 4]),
        ("predator", 0, 100, []),
    ],
)
def test_the_most_recent_ancestors_at_the_start_of_those_alive_at_the_end_are_kept(species, start_s, end_s, kept):
    assert persistent(two_trees(), species, start_s, end_s) == kept


def test_change_novelty_ecology_and_complexity_of_two_trees():
    windows = modes(two_trees(types=[7, 7, 8, 9, 8, 5]), "prey", [0, 25, 55, 100])
    numpy.testing.assert_allclose(
        windows, [[math.nan, math.nan, 0, 0], [1, 1, 1, 2], [1, 1, math.log2(3), 4]]  # 7 and 8
    )  # 7, 9 and 8


def test_a_type_that_returns_is_a_change_and_not_a_novelty():
    chain = forest((-1, 0, 12), (0, 10, 22), (1, 20, 32), types=[1, 2, 1])
    assert modes(chain, "prey", [5, 11, 21, 31])[1:, :2].tolist() == [[1, 1], [1, 0]]


def test_a_window_without_survivors_has_no_ecology():
    assert numpy.isnan(modes(forest((-1, 0, 5)), "prey", [0, 10])[0]).all()


@pytest.mark.parametrize(
    "types, present", [([4, 4, 9], {4: [1, 1, 1, 0]}), ([4, 2, 9], {4: [1, 1, 0, 0], 2: [0, 1, 1, 0]})]
)
def test_a_type_is_present_while_a_bearer_of_the_species_lives(types, present):
    found = presence(
        forest((-1, 0, 20), (0, 10, 30), (-1, 10, 11, "predator"), types=types),
        "prey",
        numpy.array([0.0, 10.0, 20.0, 30.0]),
        10,
    )
    assert {place: row.astype(int).tolist() for place, row in enumerate(found) if row.any()} == present


def test_activity_with_one_null_by_hand():
    ours = numpy.array([[1, 1, 1], [1, 0, 0], [0, 0, 1]], dtype=bool)  # types by times
    null = numpy.array([[1, 1, 0], [0, 0, 1], [0, 0, 0]], dtype=bool)  # type 0 reaches 2, type 1 reaches 1
    numpy.testing.assert_allclose(
        activity(ours, [null]),
        [[2, 1, 0.5, 0], [1, 2, 0, 0], [2, (3 + 1) / 2, (1 + 1) / 2, 1]],  # 0.5: of type 1, which the null lacks
    )  # type 0 exceeds 2


def test_activity_without_living_is_zero():
    nobody = numpy.zeros((2, 1), dtype=bool)
    assert activity(nobody, [nobody]).tolist() == [[0, 0, 0, 0]]


@pytest.mark.parametrize(
    "time_s, expected",
    [
        # 1, 3, 4 and 5 live; the pairs 1-3, 1-5 and 3-5 have the ancestors 0, 1 and 0
        (100, [2, 3 / 4, 5 / 4, 2, 3 / 6, (100 + 90 + 100) / 3, (20 + 90 + 20 + 60 + 70 + 30) / 4]),
        (15, [1, 1, 1 / 2, 1, 1, 15, (15 + 5) / 2]),
    ],
)  # 0 and its offspring 1
def test_descent_of_two_trees_by_hand(time_s, expected):
    assert descent(two_trees(), "prey", time_s) == approx(expected)


def pedigree():
    """2 is of 0 and 1, 4 of 2 and 3, 5 of 2 alone. 0 and 1 die."""
    one = forest((-1, 0, 50), (-1, 0, 60), (0, 10, ALIVE), (-1, 20, ALIVE), (2, 30, ALIVE), (2, 40, ALIVE))
    return dataclasses.replace(one, others={2: [1], 4: [3]})


def test_lines_of_both_parents_count():
    # 2, 3, 4 and 5 live, of depths 1, 0, 1.5 and 2; the common ancestor of 2-4, 2-5 and 4-5 is 2, that of 3-4 is 3
    found = descent(pedigree(), "prey", 100)
    assert found == approx(
        [3, 3 / 4, (1 + 0 + 1.5 + 2) / 4, 2, 4 / 6, (3 * 90 + 80) / 4, (10 + 10 + 90 + 80 + 70 + 60) / 4]
    )
    assert pedigree().mean_depths == [0, 0, 1, 0, 1.5, 2] and pedigree().greatest_depths == [0, 0, 1, 0, 2, 2]
    assert [persistent(pedigree(), "prey", *window) for window in ((25, 100), (5, 100), (5, 15))] == [
        [2, 3],
        [0, 1],
        [0, 1],
    ]


def test_common_ancestors_in_random_pedigrees_are_those_that_a_search_of_all_pairs_finds():
    rng = numpy.random.default_rng(5)
    for size in (12, 40):
        parents = [
            rng.choice(place, min(place, int(rng.integers(0, 3))), replace=False).tolist() if place > 3 else []
            for place in range(size)
        ]
        births = numpy.arange(size)
        one = forest(
            *((its[0] if its else -1, time_s, rng.choice([time_s + 5, ALIVE])) for its, time_s in zip(parents, births))
        )
        one = dataclasses.replace(one, others={place: its[1:] for place, its in enumerate(parents)})
        lines = []
        for place, its in enumerate(parents):
            lines.append({place}.union(*(lines[parent] for parent in its)))
        living = numpy.flatnonzero(one.living(size)).tolist()
        shared = [lines[a] & lines[b] for a, b in itertools.combinations(living, 2)]
        roots = [sum(root in lines[a] for a in living) for root in range(size) if not parents[root]]
        expected = [
            sum(count > 0 for count in roots),
            max(roots) / len(living),
            numpy.mean([bool(both) for both in shared]),
            size - numpy.mean([max(both) for both in shared if both]),
        ]
        assert descent(one, "prey", size)[[0, 1, 4, 5]].tolist() == approx(expected)


def test_descent_of_a_single_individual_and_of_none():
    numpy.testing.assert_allclose(descent(forest((-1, 0, ALIVE)), "prey", 10), [1, 1, 0, 0, math.nan, math.nan, 10])
    assert numpy.isnan(descent(two_trees(), "predator", 100)).all()


def chain(**changes):
    """Each birth has one possible parent; the type of the k-th is k."""
    return forest((-1, 0, 12), (0, 10, 22), (1, 20, 32), (2, 30, ALIVE), **changes)


def test_measures_of_a_chain_and_its_drift():
    found = lineage_values([chain()] * 5, ["prey", "predator"], 10, 40).values
    names = found[["metric", "species", "group", "unit"]].drop_duplicates()
    assert list(names.itertuples(index=False, name=None)) == metric_names(["prey", "predator"]) and len(names) == 2 * (
        2 * 8 + 7
    )
    value = found[(found.species == "prey") & (found.baseline == "")].set_index(["metric", "group"]).value
    # Windows end at 10, 20, 30 and 40 s; 0, 1, 2 and 3 persist in turn, 0 in the first.
    assert value["modes_novelty", "late"] == 1 and value["modes_ecology", "late"] == 0
    assert (
        value["descent_mean_depth", "all"] == approx((0.5 + 1.5 + 2.5 + 3) / 4) and value["descent_roots", "all"] == 1
    )
    drift = found[found.baseline == DRIFT]
    assert set(drift.role) == {"null"}
    pandas.testing.assert_series_equal(
        found[found.baseline == ""].value.reset_index(drop=True), drift.value.reset_index(drop=True)
    )


def test_the_null_is_the_mean_over_forests_and_activity_is_compared_with_the_first_two():
    alone, orphan = chain(types=[0] * 4), forest(
        (-1, 0, 12), (-1, 10, 22), (-1, 20, 32), (-1, 30, ALIVE), types=[0] * 4
    )
    found = lineage_values([chain(), alone, alone, alone, orphan], ["prey"], 10, 40)
    drift = found.values[found.values.baseline == DRIFT].set_index(["metric", "group"]).value
    assert drift["descent_mean_depth", "all"] == approx(0.75 * (0.5 + 1.5 + 2.5 + 3) / 4)
    assert drift["activity_excess", "late"] == 0  # type 0 is as active in each
    own = found.values[found.values.baseline == ""].set_index(["metric", "group"]).value
    assert own["activity_excess", "late"] == approx(own["activity_mean", "late"])  # types that the nulls lack
    assert found.curves.baseline[:8].tolist() == [""] * 4 + [DRIFT] * 4 and set(found.curves.metric[:8]) == {
        "modes_change"
    }
    curve = found.curves[(found.curves.metric == "descent_mean_depth") & (found.curves.baseline == DRIFT)]
    assert curve.time_s.tolist() == [10, 20, 30, 40] and curve.value.tolist() == approx([0.375, 1.125, 1.875, 2.25])


@pytest.mark.parametrize("reached_s, window_s", [([6000.0], 500.0), ([100.0], 25.0)])
def test_a_window_is_a_quarter_of_a_short_run_by_default_and_no_more(reached_s, window_s):
    runs = [Run(None, {"result": {"reached_s": each}}) for each in reached_s]
    assert window_of(runs) == window_s == window_of(runs, window_s)
    for wrong in (0.0, 0.26 * reached_s[0], math.nan):
        with pytest.raises(RunError, match=f"must be > 0 and <= {reached_s[0] / 4:g}, a quarter of the shortest run"):
            window_of(runs, wrong)
