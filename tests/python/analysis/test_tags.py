# SPDX-License-Identifier: MIT
import math

import numpy
import pandas
import pytest
from hand_written import WEB, agents, events, robot
from trophic.metrics import AGENTS, shipped, walls
from trophic.metrics.tags import bernoulli_symmetry, permuted_symmetry, tag_symmetry

ROWS = [
    robot(1, 0, "prey"),
    robot(1, 1, "prey"),
    robot(1, 2, "prey", tag=-1, origin="random"),
    robot(1, 3, "predator", tag=-1),
    robot(1, 4, "predator", tag=-1),
    robot(1, 5, "predator"),  # |1 - 1/3|
    robot(2, 0, "prey", tag=-1),
    robot(2, 3, "predator", tag=-1),  # |-2|
    robot(3, 0, "prey"),
]  # left out


def test_it_is_the_sum_of_the_mean_tags_of_the_inherited():
    found = {name: of.mean for name, of in tag_symmetry(agents(*ROWS), "prey", "predator").items()}
    assert found == pytest.approx(
        {
            "observed": (2 / 3 + 2) / 2,
            "permuted_tags": (permuted_symmetry(2, 3, 3)[0] + 2) / 2,
            # 3 of 5 positive, then none of 2
            "bernoulli_tags": (bernoulli_symmetry(2, 3) + bernoulli_symmetry(1, 1)) / 2,
        }
    )
    only_active = agents(*(dict(row, active=int(row["id"] != 1)) for row in ROWS[:2]), robot(1, 3, "predator", tag=-1))
    assert [
        tag_symmetry(only_active, "prey", "predator", group)["observed"].mean
        for group in ("inherited", "inherited_active")
    ] == [0.0, 0.0]
    for rows in ([robot(1, 0, "prey"), robot(1, 1, "predator", origin="random")], []):
        assert all(math.isnan(of.mean) for of in tag_symmetry(agents(*rows), "prey", "predator").values())


@pytest.mark.parametrize(
    "tags, expected",
    [((-1, 1), 0.0), ((2, 3), 0.0), ((0, 1), 0.0), ((0,), None), ((-1, 0, 1), None), (tuple(range(1001)), None)],
)
def test_two_tags_of_any_name_have_it_and_other_numbers_of_tags_do_not(tags, expected):
    rows = pandas.DataFrame(
        [robot(1, 0, "prey", tag=max(tags)), robot(1, 1, "predator", tag=min(tags))], columns=list(AGENTS)
    )
    results = shipped(WEB, events(), rows, until_s=10.0, floor=walls.Floor(10.0), tag_values=tags)
    found = {row[6] for row in results.rows if row[0] == "tag_symmetry" and not row[4]}
    assert found == (set() if expected is None else {expected})


@pytest.mark.parametrize(
    "a, b, plus, expected", [(1, 1, 1, 0.0), (1, 1, 2, 2.0), (3, 4, 0, 2.0), (1, 2, 1, (1 * 0 + 2 * 1) / 3)]
)  # |1 - 1| or |-1 + 0|
def test_permuted_tags_by_hand(a, b, plus, expected):
    assert permuted_symmetry([a, b], [b, a], [plus, plus]) == pytest.approx([expected, expected])


def test_permuted_tags_keep_a_common_bias_and_over_all_numbers_are_fair_coins():
    assert permuted_symmetry(10, 10, 19)[0] > 1.7
    assert permuted_symmetry(9, 21, 13) == pytest.approx(permuted_symmetry(9, 21, 17))  # the other tag
    probability = [math.comb(12, plus) / 2**12 for plus in range(13)]
    assert permuted_symmetry([5] * 13, [7] * 13, range(13)) @ probability == pytest.approx(bernoulli_symmetry(5, 7))


def test_many_permutations_are_computed_in_pieces():
    whole = permuted_symmetry([2000] * 1200, [3000] * 1200, numpy.arange(1200) * 4)
    assert whole[[0, 700]] == pytest.approx([permuted_symmetry(2000, 3000, plus)[0] for plus in (0, 2800)])


def test_exact_values_are_those_of_shuffled_and_of_tossed_tags():
    random = numpy.random.default_rng(8)
    deck = random.permuted(numpy.tile([1] * 7 + [-1] * 4, (50_000, 1)), axis=1)
    assert numpy.abs(deck[:, :4].mean(axis=1) + deck[:, 4:].mean(axis=1)).mean() == pytest.approx(
        permuted_symmetry(4, 7, 7)[0], rel=0.01
    )
    coins = random.choice([-1, 1], (100_000, 18))
    assert numpy.abs(coins[:, :5].mean(axis=1) + coins[:, 5:].mean(axis=1)).mean() == pytest.approx(
        bernoulli_symmetry(5, 13), rel=0.01
    )


@pytest.mark.parametrize(
    "a, b, expected, rel",
    [
        (1, 1, 1.0, 1e-12),
        (1, 2, 1.0, 1e-12),
        (2, 2, 0.75, 1e-12),
        (9, 21, 0.32, 0.01),
        (1, 999, 1.0, 1e-9),
        (1000, 1, 1.0, 1e-9),
        (400, 600, math.sqrt(2 * (1 / 400 + 1 / 600) / math.pi), 1e-3),
        (401, 600, bernoulli_symmetry(400, 600), 2e-3),
        (251, 751, bernoulli_symmetry(249, 749), 5e-3),
        *((few, 1002 - few, bernoulli_symmetry(few, 1000 - few), 5e-4) for few in (2, 7, 40, 248)),
    ],
)
def test_fair_coins_by_hand_and_at_the_bounds_of_the_exact_sum(a, b, expected, rel):
    assert bernoulli_symmetry(a, b) == pytest.approx(expected, rel=rel) and bernoulli_symmetry(
        b, a
    ) == bernoulli_symmetry(a, b)
