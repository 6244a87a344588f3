# SPDX-License-Identifier: MIT
"""Error rates of lineage measures: simulated analyses of runs in which parents are drawn by chance, and of runs with a planted effect."""
import functools
import itertools

import numpy
import pytest
from scipy import special
from trophic.metrics.forests import Forest
from trophic.metrics.lineages import DRIFT, lineage_values

RUN_S, WINDOW_S, POPULATION = 400.0, 50.0, 12
INPUTS = numpy.array(list(itertools.product((1.0, -1.0), (0.1, 0.4, 0.9))))


def decisions(weights, inputs):
    """The side depends on two inputs, the tag on one. Returns both, shape (individuals,)."""
    return numpy.sign(weights[:, 0] * inputs[0] + weights[:, 1] * inputs[1]), weights[:, 2] > inputs[1]


def signatures(weights):
    """The type of each individual, and its complexity."""
    met = [decisions(weights, inputs) for inputs in INPUTS]
    _, types = numpy.unique(
        sum(7**i * (side + 2 + 3 * tag) for i, (side, tag) in enumerate(met)), return_inverse=True
    )
    depends = numpy.zeros((2, 2, len(weights)), dtype=bool)
    for inputs, before in zip(INPUTS, met):
        for place, end in itertools.product((0, 1), (min, max)):
            after = decisions(
                weights, [end(INPUTS[:, place]) if i == place else value for i, value in enumerate(inputs)]
            )
            depends[place] |= [before[0] != after[0], before[1] != after[1]]
    return types, depends.sum(axis=(0, 1))


def simulated(rng, fitness, has_heredity=True):
    """A population of 12 in which an individual dies by chance every 4 s, on average. A third of the newborn are random. The others have a parent
    among the living, drawn by `fitness(weights, birth_s, living, place)`, and its weights with a mutation; without heredity, random ones.
    Returns parents, times of birth and death and weights."""
    steps = int(RUN_S / 2)
    chance = rng.random((steps, 4)).tolist()
    drawn = rng.uniform(-1, 1, (steps + POPULATION, 3)).tolist()
    mutation = rng.normal(0, 0.1, (steps, 3)).tolist()
    parent, birth_s, death_s, weights = (
        [-1] * POPULATION,
        [0.0] * POPULATION,
        [numpy.inf] * POPULATION,
        drawn[:POPULATION],
    )
    living = list(range(POPULATION))
    for step, (dies, who, is_random, whose) in enumerate(chance):
        if dies >= 0.5:
            continue
        death_s[living.pop(int(who * len(living)))] = time_s = 2.0 * (step + 1)
        chosen, own = -1, drawn[POPULATION + step]
        if is_random >= 1 / 3:
            shares = list(itertools.accumulate(fitness(weights, birth_s, living, place) for place in living))
            chosen = living[next(i for i, share in enumerate(shares) if whose * shares[-1] <= share)]
            if has_heredity:
                own = [a + b for a, b in zip(weights[chosen], mutation[step])]
        living.append(len(parent))
        for column, value in zip((parent, birth_s, death_s, weights), (chosen, time_s, numpy.inf, own)):
            column.append(value)
    return numpy.array(parent), numpy.array(birth_s), numpy.array(death_s), numpy.array(weights)


def drift(rng, parent, birth_s, death_s, weights):
    """Parents by chance among those alive before a birth, with mutations, and genomes of founders and newcomers, permuted among themselves."""
    chance = rng.random(len(parent)).tolist()
    given = numpy.where(parent[:, None] < 0, weights, weights - weights[parent])
    for kind in (parent >= 0, (parent < 0) & (birth_s == 0), (parent < 0) & (birth_s > 0)):
        given[kind] = rng.permutation(given[kind])
    mutations = drifted = given.tolist()
    born, dies, chosen = birth_s.tolist(), death_s.tolist(), parent.tolist()
    living: list[int] = []
    for place, time_s in enumerate(born):
        living = [one for one in living if dies[one] > time_s]
        if chosen[place] >= 0:
            candidates = [one for one in living if born[one] < time_s]
            chosen[place] = candidates[int(chance[place] * len(candidates))]
            drifted[place] = [a + b for a, b in zip(drifted[chosen[place]], mutations[place])]
        living.append(place)
    return numpy.array(chosen), birth_s, death_s, numpy.array(drifted)


@functools.lru_cache(maxsize=None)
def measured(runs, seed, fitness, has_heredity=True):
    """Returns the measures' titles with their values in the runs and under drift, shape (runs, measures)."""
    own, nulls = [], []
    for run in range(runs):
        rng = numpy.random.Generator(numpy.random.Philox([seed, run]))
        first = simulated(rng, fitness, has_heredity)
        drawn = [first, *(drift(rng, *first) for _ in range(4))]
        types, complexity = signatures(numpy.concatenate([each[3] for each in drawn]))
        size = len(first[0])
        forests = [
            Forest(*each[:3], numpy.zeros(size, dtype=int), types[i * size :][:size], complexity[i * size :][:size])
            for i, each in enumerate(drawn)
        ]
        found = lineage_values(forests, [0], WINDOW_S, RUN_S).values
        own.append(found.value[found.baseline == ""].to_numpy())
        nulls.append(found.value[found.baseline == DRIFT].to_numpy())
    names = found[found.baseline == ""]
    return list(names.metric + " " + names.group), numpy.array(own), numpy.array(nulls)


def side(mean, variance, freedom):
    """Whether a mean is above and below zero, each test at 5 %."""
    half = special.stdtrit(freedom, 0.975) * numpy.sqrt(variance)
    return mean - half > 0, mean + half < 0


def found(ours, shadows, size, analyses):
    """The shares of analyses of `size` runs in which each measure is above and below drift and the shadow: {title: (above, below)}."""
    rng = numpy.random.Generator(numpy.random.Philox([size, 1]))
    titles, own, drifted = ours
    own_rows, shadow_rows = (
        rng.permuted(numpy.tile(numpy.arange(len(each)), (analyses, 1)), axis=1)[:, :size] for each in (own, shadows[1])
    )

    def moments(values):
        counts = (~numpy.isnan(values)).sum(axis=1)
        return numpy.nanmean(values, axis=1), numpy.nanvar(values, axis=1, ddof=1) / counts, counts - 1

    shares = {}
    a, b = moments(own[own_rows]), moments(shadows[1][shadow_rows])
    with numpy.errstate(invalid="ignore", divide="ignore"):
        welch = (a[1] + b[1]) ** 2 / (a[1] ** 2 / a[2] + b[1] ** 2 / b[2])
    for null, judged in (
        (DRIFT, side(*moments((own - drifted)[own_rows]))),
        ("shadow", side(a[0] - b[0], a[1] + b[1], welch)),
    ):
        shares.update(
            {f"{title}, {null}": pair for title, *pair in zip(titles, *(each.mean(axis=0) for each in judged))}
        )
    return shares


def by_chance(weights, birth_s, living, place):
    return 1.0


def half_of_the_types(weights, birth_s, living, place):
    return 10.0 if weights[place][2] > 0.4 else 1.0


def quarter_of_the_types(weights, birth_s, living, place):
    return 50.0 if weights[place][0] > 0.5 else 1.0


def most_complex(weights, birth_s, living, place):
    first, second, tag = weights[place]
    return 20.0 if 0.1 < tag <= 0.9 and abs(first) < 0.9 * abs(second) else 1.0


def rare_and_complex(weights, birth_s, living, place):
    kind = lambda one: (one[0] > 0, abs(one[0]) > abs(one[1]), (one[2] > 0.1) + (one[2] > 0.4) + (one[2] > 0.9))
    is_only_one = sum(kind(weights[one]) == kind(weights[place]) for one in living) == 1
    return most_complex(weights, birth_s, living, place) * (20.0 if is_only_one else 1.0)


def quarter_of_individuals(weights, birth_s, living, place):
    return 20.0 if int(birth_s[place]) % 8 == 0 else 1.0


def youngest_three(weights, birth_s, living, place):
    return 100.0 if living.index(place) + 3 >= len(living) else 1.0


DIVERSITIES = [
    f"{measure} {half}, drift"
    for measure in ("modes_change", "modes_novelty", "modes_ecology", "activity_diversity")
    for half in ("early", "late")
]


def test_parents_by_chance_at_most_7_percent_of_1000_analyses_find_a_difference():
    shares = found(measured(600, 1, by_chance), measured(400, 2, by_chance), 10, 1000)
    assert len(shares) == 2 * (2 * 8 + 7)
    assert max((sum(both), title) for title, both in shares.items()) <= (0.07, "z")


@pytest.mark.parametrize(
    "fitness, above, below",
    [
        (half_of_the_types, ["activity_excess late, drift"], []),
        (quarter_of_the_types, ["activity_mean late, drift"], DIVERSITIES),
        (
            most_complex,
            [f"modes_complexity {half}, {null}" for half in ("early", "late") for null in ("drift", "shadow")],
            [],
        ),
        (rare_and_complex, [title for title in DIVERSITIES if title != "modes_novelty late, drift"], []),
        (
            quarter_of_individuals,
            [
                f"descent_{measure} all, {null}"
                for measure in ("related_pairs", "largest_clade")
                for null in ("shadow", "drift")
            ],
            ["descent_roots all, drift"],
        ),
        (
            youngest_three,
            ["descent_mean_depth all, shadow", "descent_greatest_depth all, shadow"],
            ["descent_common_ancestor all, shadow", "descent_diversity all, shadow"],
        ),
    ],
)
def test_a_planted_effect_is_found_in_at_least_80_percent_of_analyses_of_30_runs(fitness, above, below):
    shares = found(measured(150, 3, fitness), measured(400, 2, by_chance), 30, 200)
    missed = {
        title: shares[title][place]
        for place, titles in enumerate((above, below))
        for title in titles
        if shares[title][place] < 0.8
    }
    assert not missed


def test_next_to_a_shadow_in_which_nothing_is_inherited_the_calibration_fails():
    shares = found(measured(600, 1, by_chance), measured(100, 4, by_chance, False), 10, 200)
    assert sum(shares["modes_change late, shadow"]) > 0.14
    assert sum(shares["modes_change late, drift"]) <= 0.1
