# SPDX-License-Identifier: MIT
"""The statistics of trophic.statistics for many comparisons at once: every value is an array, one element a comparison, and nan stands for
None."""
from __future__ import annotations

from typing import Any, NamedTuple

import numpy
from scipy import special

from ..statistics import MIN_RUNS_FOR_TEST, MOST_RUNS, USUAL_POWER

Array = Any  # of floats


class Moments(NamedTuple):
    """Numbers, means and variances of the columns of a matrix of values, one row a run; nan is left out."""

    runs: Array
    mean: Array
    variance: Array
    """with n - 1"""


class Contrast(NamedTuple):
    value: Array
    error: Array
    freedom: Array


class Interval(NamedTuple):
    lower: Array
    upper: Array


class Scatter(NamedTuple):
    variance: Array
    freedom: Array


def moments(values: Array) -> Moments:
    """`values`: (runs, comparisons)."""
    there = ~numpy.isnan(values)
    count = there.sum(axis=0)
    with numpy.errstate(all="ignore"):
        mean = numpy.where(there, values, 0.0).sum(axis=0) / count
        squares = (numpy.where(there, values - mean, 0.0) ** 2).sum(axis=0)
        return Moments(count, mean, numpy.where(count > 1, squares / (count - 1.0), numpy.nan))


def is_rounding(spread: Array, value: Array) -> Array:
    """Whether a spread is only the rounding of a value."""
    return spread <= 1e-14 * numpy.maximum(1.0, numpy.abs(value))


def contrast(*terms: tuple[float, Moments]) -> Contrast:
    """As statistics.contrast."""
    with numpy.errstate(all="ignore"):
        parts = [weight * weight * of.variance / of.runs for weight, of in terms]
        value, variance = sum(weight * of.mean for weight, of in terms), sum(parts)
        squares = sum(part * part / (of.runs - 1.0) for part, (_, of) in zip(parts, terms))
        is_point = is_rounding(numpy.sqrt(variance), value)
        error, freedom = numpy.where(is_point, 0.0, numpy.sqrt(variance)), numpy.where(
            is_point, 1.0, variance * variance / squares
        )
    enough = numpy.all([of.runs >= MIN_RUNS_FOR_TEST for _, of in terms], axis=0)
    return Contrast(*(numpy.where(enough, each, numpy.nan) for each in (value, error, freedom)))


def t_quantile(probability: float, freedom: Array) -> Array:
    """As statistics.t_quantile."""
    t = special.stdtrit(freedom, probability)  # exact to 1e-9; a step of Newton's gives the rest
    with numpy.errstate(all="ignore"):
        density = numpy.exp(
            special.gammaln((freedom + 1.0) / 2.0)
            - special.gammaln(freedom / 2.0)
            - (freedom + 1.0) / 2.0 * numpy.log1p(t * t / freedom)
        ) / (numpy.sqrt(numpy.pi * freedom))
        return t - (special.stdtr(freedom, t) - probability) / density


def interval_of(of: Contrast, level: float = 0.95) -> Interval:
    """As statistics.interval_of."""
    half = numpy.where(of.error == 0.0, 0.0, of.error * t_quantile((1.0 + level) / 2.0, of.freedom))
    return Interval(of.value - half, of.value + half)


def p_value(of: Contrast) -> Array:
    """As statistics.p_value, from zero."""
    with numpy.errstate(all="ignore"):
        p = 2.0 * special.stdtr(of.freedom, -numpy.abs(of.value) / of.error)
    return numpy.where(of.error == 0.0, numpy.where(of.value == 0.0, numpy.nan, 0.0), p)


def scatter_of(*sets: Moments) -> Scatter:
    """As statistics.scatter_of."""
    total, squares = sum(of.variance for of in sets), sum(of.variance**2 for of in sets)
    with numpy.errstate(all="ignore"):
        return Scatter(
            total, numpy.where(squares > 0.0, total * total / squares, numpy.where(numpy.isnan(total), numpy.nan, 1.0))
        )


def hedges_g(a: Moments, b: Moments) -> Array:
    """As statistics.hedges_g."""
    with numpy.errstate(all="ignore"):
        freedom = a.runs + b.runs - 2.0
        spread = numpy.sqrt(((a.runs - 1) * a.variance + (b.runs - 1) * b.variance) / freedom)
        correction = numpy.exp(special.gammaln(freedom / 2.0) - special.gammaln((freedom - 1.0) / 2.0)) / numpy.sqrt(
            freedom / 2.0
        )
        g = correction * (b.mean - a.mean) / spread
    return numpy.where(is_rounding(spread, b.mean - a.mean), numpy.nan, g)


def power_of_t(errors: Array, freedom: Array, level: float) -> Array:
    """As statistics.power_of_t, for errors >= 0."""
    critical = special.stdtrit(freedom, 1.0 - level / 2.0)
    with numpy.errstate(all="ignore"):
        far = special.chdtr(freedom, numpy.minimum(freedom * (errors / critical) ** 2, 1e300))
    near = numpy.minimum(errors, 200.0)
    return numpy.where(
        errors > 200.0, far, 1.0 - special.nctdtr(freedom, near, critical) + special.nctdtr(freedom, near, -critical)
    )


def detectable_difference(of: Contrast, level: float, power: float = USUAL_POWER) -> Array:
    """As statistics.detectable_difference."""
    freedoms, places = numpy.unique(of.freedom, return_inverse=True)  # a paired sweep has few
    low, high = numpy.zeros_like(freedoms), special.stdtrit(freedoms, 1.0 - level / 2.0) + numpy.maximum(
        0.0, special.stdtrit(freedoms, power)
    )
    while (short := power_of_t(high, freedoms, level) < power).any():
        low, high = numpy.where(short, high, low), numpy.where(short, 2.0 * high, high)
    for _ in range(36):
        middle = (low + high) / 2.0
        found = power_of_t(middle, freedoms, level) >= power
        low, high = numpy.where(found, low, middle), numpy.where(found, middle, high)
    return of.error * high[places]


def runs_for_power(difference: Array, scatter: Scatter, level: float, power: float = USUAL_POWER) -> Array:
    """As statistics.runs_for_power."""
    with numpy.errstate(all="ignore"):
        spreads = numpy.abs(difference) / numpy.sqrt(scatter.variance)
        fewest = (max(float(special.ndtri(1.0 - level / 2.0) + special.ndtri(power)), 0.0) / spreads) ** 2
    runs = numpy.where(
        is_rounding(numpy.sqrt(scatter.variance), difference) & (difference != 0.0), float(MIN_RUNS_FOR_TEST), numpy.nan
    )
    asked = numpy.flatnonzero(numpy.isnan(runs) & (difference != 0.0) & (fewest <= MOST_RUNS))

    def suffices(which: Array, runs: Array) -> Array:
        at = asked[which]
        return power_of_t(spreads[at] * numpy.sqrt(runs), scatter.freedom[at] * (runs - 1.0), level) >= power

    enough = numpy.maximum(MIN_RUNS_FOR_TEST, numpy.floor(fewest[asked]))
    few = enough - 1.0
    short, step = numpy.arange(len(asked)), 1
    while len(short := short[(enough[short] <= MOST_RUNS) & ~suffices(short, enough[short])]):
        few[short] = enough[short]
        enough[short] += step
        step *= 2
    is_open = numpy.flatnonzero((enough <= MOST_RUNS) & (enough - few > 1.0))
    while len(is_open):
        middle = numpy.floor((few[is_open] + enough[is_open]) / 2.0)
        found = suffices(is_open, middle)
        enough[is_open], few[is_open] = numpy.where(found, middle, enough[is_open]), numpy.where(
            found, few[is_open], middle
        )
        is_open = is_open[enough[is_open] - few[is_open] > 1.0]
    runs[asked] = numpy.where(enough <= MOST_RUNS, enough, numpy.nan)
    return runs
