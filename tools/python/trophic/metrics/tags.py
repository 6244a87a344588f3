# SPDX-License-Identifier: MIT
"""Tag symmetry: whether two species show opposite tags, and what tags without any meaning would give.

It is a metric of two tags, of which one counts as -1 and the other as +1. Rules with another number of tags do not have it."""
from __future__ import annotations

import functools
import math
from collections.abc import Sequence

import numpy

from .tables import Agents, Means, Results, Web, means

UNIFORM_PAIRS = 0.6667591563386976
"""The paper's baseline: the mean of |u + v| over 100,000 pairs of numbers uniform in [-1, 1), drawn once (2/3 in the limit). It stands for
two infinitely large species whose mean tags can be anything, not for 30 robots."""
_MOST_NUMBERS = 1_000_000  # held in memory at a time


@functools.lru_cache(maxsize=100_000)
def bernoulli_symmetry(a: int, b: int) -> float:
    """E|mean of `a` fair coins + mean of `b` fair coins|, coins showing -1 or +1: the tag symmetry of populations of these numbers if each
    robot tosses a coin. Exact for up to 1000 coins in all. Beyond that the mean of the more is taken as normal, and of the fewer, too, from
    250 on: sqrt(2 (1/a + 1/b) / pi). The relative error is then below 1e-3. Both must be > 0.
    """
    import scipy.special

    few, many = sorted((a, b))
    is_large = few + many > 1000
    if is_large and few >= 250:
        return math.sqrt(2.0 * (1.0 / few + 1.0 / many) / math.pi)
    mean, probability = _coins(few)
    if is_large:
        deviation = math.sqrt(1.0 / many)
        z = mean / deviation
        folded = math.sqrt(2.0 / math.pi) * numpy.exp(-0.5 * z * z) + z * scipy.special.erf(z / math.sqrt(2.0))
        return float(probability @ folded * deviation)
    other, probability_of_other = _coins(many)
    return float(probability @ numpy.abs(numpy.add.outer(mean, other)) @ probability_of_other)


def permuted_symmetry(a, b, plus) -> numpy.ndarray:
    """E|mean tag of `a` robots + mean tag of `b` robots| if `plus` tags of +1 and the others of -1 are dealt out among all of them: exact,
    by the hypergeometric distribution, for arrays of these numbers. It keeps what all robots have in common, such as a bias to one tag.
    a and b must be > 0."""
    a, b, plus = (numpy.atleast_1d(numpy.asarray(of, int)) for of in (a, b, plus))
    a, b = numpy.minimum(a, b), numpy.maximum(a, b)  # the mean is the same
    at_once = max(1, _MOST_NUMBERS // (int(a.max(initial=0)) + 1))
    pieces = [
        _permuted(a[i : i + at_once], b[i : i + at_once], plus[i : i + at_once]) for i in range(0, len(a), at_once)
    ]
    return numpy.concatenate(pieces) if pieces else numpy.empty(0)


def tag_symmetry(agents: Agents, a: str, b: str, group: str = "inherited", plus_tag: int = 1) -> dict[str, Means]:
    """At each tick |mean tag of one species + mean tag of the other|, of members of the group only: the inherited ones (Sec. "Metrics for
    system dynamics"). Ticks at which either species has no such member are left out. Close to 0: the species show opposite tags.

    Returns it as "observed", and with the tags alive at the tick dealt out between the species ("permuted_tags", the null) and with every
    robot's tag a fair coin ("bernoulli_tags"). The mean of the tags (-1, 1, 1, 1) is 0.5; the paper's example of an average tag gives 0.75
    for it, which is wrong. `plus_tag`: the tag that counts as +1; all others count as -1.
    """
    rows = [agents.of(species, group) for species in (a, b)]
    both = [agents.count(of) for of in rows]
    there = numpy.flatnonzero((both[0] > 0) & (both[1] > 0))
    is_plus = agents.tag == plus_tag
    plus_of = [agents.count(of & is_plus)[there] for of in rows]
    in_a, in_b = both[0][there], both[1][there]
    observed = numpy.abs(2.0 * plus_of[0] / in_a - 1.0 + 2.0 * plus_of[1] / in_b - 1.0)
    counts, place = _distinct(in_a, in_b, plus_of[0] + plus_of[1])
    pairs, place_of_pair = _distinct(*counts[:2])
    coins = numpy.array([bernoulli_symmetry(int(few), int(many)) for few, many in zip(*pairs)])[place_of_pair]
    of = {"observed": observed, "permuted_tags": permuted_symmetry(*counts)[place], "bernoulli_tags": coins[place]}
    return {name: means(agents.window[there], values) for name, values in of.items()}


def measure(agents: Agents, web: Web, tags: Sequence[int], results: Results, suffix: str = "") -> None:
    """`tags`: those that the rule table's brains may choose. `suffix`: of the metric's name."""
    if len(tags) != 2:
        return
    for hunter, victim in web.links:
        for group in ("inherited", "inherited_active"):
            name = (f"tag_symmetry{suffix}", f"{victim}+{hunter}", group, "1")
            of = tag_symmetry(agents, victim, hunter, group, max(tags))
            nulls = (
                ("permuted_tags", "null", of["permuted_tags"].mean),
                ("uniform_pairs", "paper", UNIFORM_PAIRS),
                ("bernoulli_tags", "reference", of["bernoulli_tags"].mean),
            )
            results.add_means(*name, of["observed"], baselines=nulls)
            for null in ("permuted_tags", "bernoulli_tags"):
                results.add_curve(*name, of[null].time_s, of[null].points, null)


def _distinct(*numbers: numpy.ndarray) -> tuple[list[numpy.ndarray], numpy.ndarray]:
    """The distinct tuples of whole numbers >= 0, in order, and the place of each tuple among them: as numpy.unique over an axis, which is slow."""
    key = numpy.zeros(len(numbers[0]), int)
    for of in numbers:
        key = key * (int(of.max(initial=0)) + 1) + of
    _, first, place = numpy.unique(key, return_index=True, return_inverse=True)
    return [of[first] for of in numbers], place


@functools.lru_cache(maxsize=10_000)
def _coins(coins: int) -> tuple[numpy.ndarray, numpy.ndarray]:
    """The means of fair coins with k = 0, 1, ... heads, and their probabilities."""
    k = numpy.arange(coins + 1)
    log = _log_factorials(coins)
    return 2.0 * k / coins - 1.0, numpy.exp(log[coins] - log[k] - log[coins - k] - coins * math.log(2.0))


def _log_factorials(most: int) -> numpy.ndarray:
    import scipy.special

    return scipy.special.gammaln(numpy.arange(most + 1) + 1.0)


def _permuted(a: numpy.ndarray, b: numpy.ndarray, plus: numpy.ndarray) -> numpy.ndarray:
    in_a = numpy.arange(int(a.max()) + 1)
    a, b, plus = (of[:, None] for of in (a, b, plus))
    in_b = plus - in_a
    possible = (in_a <= a) & (in_b >= 0) & (in_b <= b)
    log = _log_factorials(int((a + b).max()))

    def log_choose(n: numpy.ndarray, k: numpy.ndarray) -> numpy.ndarray:
        return log[n] - log[numpy.clip(k, 0, n)] - log[numpy.clip(n - k, 0, n)]

    probability = numpy.exp(
        numpy.where(possible, log_choose(a, in_a) + log_choose(b, in_b) - log_choose(a + b, plus), -numpy.inf)
    )
    return (probability * numpy.abs(2.0 * in_a / a - 1.0 + 2.0 * in_b / b - 1.0)).sum(axis=1)
