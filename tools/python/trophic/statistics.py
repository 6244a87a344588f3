# SPDX-License-Identifier: MIT
"""Means over runs, their intervals and tests by Student's t, survival, corrections for many comparisons, equivalence, effect sizes and power.

Values are numbers, one a run; nan is a value that could not be computed and is left out. Functions that need more values than there are
return None.

Intervals are Student's, chosen by simulation. Share of 95 % intervals that leave out the true mean, in %, at 6 / 10 / 20 runs. 2000 samples
each; 40,000 of t. "Kinematic": medians over eight metrics of 150 runs each of `paper` and `released`, drawn with replacement.

                           Student's t       percentile          BCa                 studentised bootstrap
      normal               5.0 / 5.2 / 4.9   15.8 / 10.8 / 7.8   14.9 / 10.7 / 8.2   5.1 / 5.3 / 5.2
      uniform              6.0 / 5.4 / 5.1   13.1 /  9.8 / 7.4   12.9 /  7.7 / 5.5   3.9 / 3.0 / 3.6
      gamma, skewness 0.5  5.3 / 5.4 / 5.3   13.7 / 10.9 / 7.5   14.2 / 11.7 / 8.2   6.8 / 5.6 / 6.5
      gamma, skewness 1.0  6.7 / 6.5 / 5.7   14.0 / 10.6 / 7.1   15.3 / 10.8 / 8.8   6.7 / 5.8 / 6.1
      kinematic            5.3 / 5.4 / 5.7   15.1 / 10.6 / 7.7   14.9 / 10.8 / 8.0   5.8 / 5.8 / 5.6

So t: no worse than the studentised bootstrap, and without random draws. Of 58 metrics of those runs 48 are within 1.5 points at 6 and 10
runs. Not so: tag symmetry (7.5 to 8.1 at 6 runs), velocity of predators (6.7 to 7.8), and counts that hardly vary but for single odd runs
(deaths of predators and hunger in `paper`, 14 to 37), for which no method of so few runs is right."""
from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple, Union

import numpy
from scipy import special  # scipy.stats takes three times as long to import

MIN_RUNS_FOR_TEST = 6
"""A set of fewer runs gets its mean and spread, but no interval and no test result."""
SIGNIFICANCE = 0.05
"""A corrected p value of at most this is significant."""
USUAL_POWER = 0.8
"""The share of studies that are to find what is there."""
MOST_RUNS = 1_000_000
"""A difference that needs more runs than this is called undetectable."""
Values = Union[Sequence[float], numpy.ndarray]


class Interval(NamedTuple):
    lower: float
    upper: float


class Contrast(NamedTuple):
    """A weighted sum of the means of independent sets, its standard error and the degrees of freedom of that error."""

    value: float
    error: float
    freedom: float


class Scatter(NamedTuple):
    """With n runs in each set, or n pairs, the squared error of a comparison is `variance` / n, of `freedom` (n - 1) degrees of freedom."""

    variance: float
    freedom: float = 1.0


class Estimate(NamedTuple):
    """A mean over `runs` values, the deviation between them and, from MIN_RUNS_FOR_TEST on, the mean's 95 % interval."""

    runs: int
    mean: float | None
    deviation: float | None
    interval: Interval | None


class EquivalenceTest(NamedTuple):
    difference: float | None
    interval: Interval | None
    """of the difference, at 1 - 2 alpha"""
    margin: float
    conclusion: str
    """equivalent: the difference is smaller than the margin. different: it is not zero, and not shown to be smaller than the margin.
    inconclusive: the runs are too scattered for either. unknown: too few values."""


def known(values: Values) -> numpy.ndarray:
    """The values without nan."""
    array = numpy.asarray(values, dtype=float)
    return array[~numpy.isnan(array)]


def mean_of(values: Values) -> float | None:
    array = known(values)
    return float(array.mean()) if len(array) else None


def deviation_of(values: Values) -> float | None:
    """The standard deviation between runs, with n - 1; None if there are fewer than two values."""
    array = known(values)
    return float(array.std(ddof=1)) if len(array) > 1 else None


def is_rounding(spread: float, value: float) -> bool:
    """Whether a spread is only the rounding of a value, and counts as none."""
    return spread <= 1e-14 * max(1.0, abs(value))


def contrast(*terms: tuple[float, Values]) -> Contrast | None:
    """The contrast of (weight, values) terms: for one set Student's t with n - 1 degrees of freedom, for several Welch's approximation
    [welch1947], which lets every set have its own spread. None if a set has fewer than MIN_RUNS_FOR_TEST values.
    """
    value, parts = 0.0, []
    for weight, values in terms:
        array = known(values)
        if len(array) < MIN_RUNS_FOR_TEST:
            return None
        value += weight * float(array.mean())
        parts.append((weight * weight * float(array.var(ddof=1)) / len(array), len(array) - 1.0))
    return _welch(value, parts)


def _welch(value: float, parts: Iterable[tuple[float, float]]) -> Contrast:
    """A sum of independent estimates, each given as the square of its error and its degrees of freedom."""
    variance = squares = 0.0
    for part, freedom in parts:
        variance += part
        squares += part * part / freedom
    if is_rounding(math.sqrt(variance), value):
        return Contrast(value, 0.0, 1.0)
    return Contrast(value, math.sqrt(variance), variance * variance / squares)


def t_quantile(probability: float, freedom: float) -> float:
    """The value that a t of `freedom` > 0 degrees of freedom stays below with this probability, 0 < probability < 1."""
    tail = min(probability, 1.0 - probability)
    t = float(special.stdtrit(freedom, tail))  # right to 1e-9; a step of Newton's method makes it right to rounding
    log_density = (
        math.lgamma((freedom + 1.0) / 2.0)
        - math.lgamma(freedom / 2.0)
        - (freedom + 1.0) / 2.0 * math.log1p(t * t / freedom)
    )
    t -= (float(special.stdtr(freedom, t)) - tail) / (math.exp(log_density) / math.sqrt(freedom * math.pi))
    return t if probability <= 0.5 else -t


def t_two_sided(t: float, freedom: float) -> float:
    """The probability that |t| is `t` >= 0 or more."""
    return float(2.0 * special.stdtr(freedom, -t))


def interval_of(of: Contrast | None, level: float = 0.95) -> Interval | None:
    """The interval that holds the true value of a contrast with probability `level`; a point where no set has any spread."""
    if of is None:
        return None
    half = of.error * t_quantile((1.0 + level) / 2.0, of.freedom) if of.error else 0.0
    return Interval(of.value - half, of.value + half)


def p_value(of: Contrast | None, origin: float = 0.0) -> float | None:
    """Two-sided: how often a contrast this far from `origin` would come by chance alone. None where nothing varies and nothing differs."""
    if of is None or (of.error == 0.0 and of.value == origin):
        return None
    return t_two_sided(abs(of.value - origin) / of.error, of.freedom) if of.error else 0.0


def interval_of_mean(values: Values, level: float = 0.95) -> Interval | None:
    return interval_of(contrast((1.0, values)), level)


def estimate(values: Values) -> Estimate:
    return Estimate(len(known(values)), mean_of(values), deviation_of(values), interval_of_mean(values))


def share_interval(values: Values, level: float = 0.95) -> Interval | None:
    """Clopper and Pearson's interval [clopper1934] of the share of runs, of values 0 and 1: it holds the true share with `level` at least. None if a
    set has fewer than MIN_RUNS_FOR_TEST values."""
    array = known(values)
    n, k = len(array), array.sum()
    if n < MIN_RUNS_FOR_TEST:
        return None
    tail = (1.0 - level) / 2.0
    return Interval(
        float(special.betaincinv(k, n - k + 1, tail)) if k > 0 else 0.0,
        float(special.betaincinv(k + 1, n - k, 1.0 - tail)) if k < n else 1.0,
    )


def share_difference(a: Values, b: Values, level: float = 0.95) -> Difference:
    """The difference of two shares of runs, a - b: Fisher's exact test, and Newcombe's interval [newcombe1998] of both exact ones. Without p and
    interval if a set has fewer than MIN_RUNS_FOR_TEST values, without p where all values are the same.
    """
    a, b = known(a), known(b)
    its, others = share_interval(a, level), share_interval(b, level)
    value = float(a.mean() - b.mean()) if len(a) and len(b) else None
    if value is None or its is None or others is None:
        return Difference(value, None, None, None, scatter_of(a, b))
    low = math.hypot(a.mean() - its.lower, others.upper - b.mean())
    high = math.hypot(its.upper - a.mean(), b.mean() - others.lower)
    both = int(a.sum() + b.sum())
    p = None
    if 0 < both < len(a) + len(b):
        k = numpy.arange(max(0, both - len(b)), min(both, len(a)) + 1)
        chance = special.binom(len(a), k) * special.binom(len(b), both - k)
        here = chance[int(a.sum()) - k[0]]
        p = float(min(1.0, chance[chance <= here * (1.0 + 1e-9)].sum() / chance.sum()))
    return Difference(
        value,
        Interval(value - low, value + high),
        p,
        None,
        scatter_of(a, b),
        at=lambda level: share_difference(a, b, level).interval,
    )


def is_by_chance(many: int, count: int) -> bool:
    """Whether tests at 5 % find so many of `count` runs in more than 5 % of sets in which there is nothing."""
    return many == 0 or float(special.bdtrc(many - 1, count, SIGNIFICANCE)) > SIGNIFICANCE


def survival(ends: Values, died: Sequence[bool] | numpy.ndarray) -> list[tuple[float, int, int, float, float, float]]:
    """Kaplan and Meier's estimate [kaplan1958]: of each time at which a run died its time, the runs at risk, those that died, the share that survives
    it, and its 95 % interval by Greenwood's error of log(-log), nan where the share is 0. `ends`: the time of each run's end or death.
    """
    rows, share, error, quantile = [], 1.0, 0.0, float(special.ndtri(0.975))
    ends, died = numpy.asarray(ends, float), numpy.asarray(died, bool)
    for time in numpy.unique(ends[died]):
        at_risk, deaths = int((ends >= time).sum()), int((died & (ends == time)).sum())
        share *= 1.0 - deaths / at_risk
        bounds = (math.nan, math.nan)
        if share > 0.0:
            error += deaths / (at_risk * (at_risk - deaths))
            spread = math.exp(quantile * math.sqrt(error) / abs(math.log(share)))
            bounds = (share**spread, share ** (1.0 / spread))
        rows.append((float(time), at_risk, deaths, share, *bounds))
    return rows


class Lives(NamedTuple):
    """When something ended in each of several runs, or until when it was watched: censored values."""

    ends_s: numpy.ndarray
    """of the death, or of the run"""
    died: numpy.ndarray
    """whether it died; if not, it lived at the end of the run"""
    planned_s: float
    """the planned end; who died stays dead until then"""

    @property
    def known_until_s(self) -> float:
        """The time up to which the share of survivors is known."""
        return float(numpy.where(self.died, self.planned_s, self.ends_s).max(initial=0.0))

    def until(self, end_s: float) -> Lives:
        """As if every run ended there: who dies later is censored."""
        return Lives(numpy.minimum(self.ends_s, end_s), self.died & (self.ends_s <= end_s), end_s)


def common_end(*sets: Lives) -> float:
    """The time up to which the survival of all sets is known: that of the shortest. 0 if a set has no run."""
    return min(of.known_until_s for of in sets)


def restricted_mean(of: Lives, end_s: float) -> Contrast | None:
    """The mean survival up to `end_s`, which is the area under Kaplan and Meier's estimate [royston2013], and its error by Greenwood's formula, times
    n / (n - 1). If no life is cut off before `end_s`, it is the mean of min(life, end_s) with its usual error. None without a run; an error
    needs MIN_RUNS_FOR_TEST runs."""
    of = of.until(end_s)
    n = len(of.ends_s)
    if n == 0:
        return None
    rows = survival(of.ends_s, of.died)
    times, shares = [0.0, *(row[0] for row in rows), end_s], [1.0, *(row[3] for row in rows)]
    areas = [share * (to - at) for share, at, to in zip(shares, times, times[1:])]
    value, variance, rest = sum(areas), 0.0, sum(areas[1:])
    for (_, at_risk, deaths, *_), area in zip(rows, areas[1:]):
        variance += rest * rest * deaths / (at_risk * (at_risk - deaths)) if at_risk > deaths else 0.0
        rest -= area
    return Contrast(value, math.sqrt(variance * n / max(1, n - 1)), max(1.0, n - 1.0))


def log_rank(a: Lives, b: Lives) -> float | None:
    """The log-rank test of two sets of lives up to their common end [mantel1966]: how often deaths fall so unequally if both die at the same rate.
    Two-sided, by the chi-square distribution. None if nothing died, or if a set has fewer than MIN_RUNS_FOR_TEST runs.
    """
    end_s = common_end(a, b)
    a, b = a.until(end_s), b.until(end_s)
    if min(len(a.ends_s), len(b.ends_s)) < MIN_RUNS_FOR_TEST:
        return None
    excess = variance = 0.0
    for time in numpy.unique(numpy.concatenate([a.ends_s[a.died], b.ends_s[b.died]])):
        (risk_a, dead_a), (risk, dead) = (
            (
                sum(int((of.ends_s >= time).sum()) for of in sets),
                sum(int((of.died & (of.ends_s == time)).sum()) for of in sets),
            )
            for sets in ((a,), (a, b))
        )
        share = risk_a / risk
        excess += dead_a - dead * share
        variance += dead * share * (1.0 - share) * (risk - dead) / (risk - 1) if risk > 1 else 0.0
    return float(special.chdtrc(1.0, excess * excess / variance)) if variance > 0.0 else None


def survival_difference(a: Lives, b: Lives, end_s: float | None = None) -> Difference:
    """The difference a - b of the restricted mean survivals up to the common end, or to an earlier `end_s`, with Welch's interval, and the p value of
    the log-rank test."""
    end_s = common_end(a, b) if end_s is None else end_s
    a, b = a.until(end_s), b.until(end_s)
    ours, theirs = restricted_mean(a, end_s), restricted_mean(b, end_s)
    if ours is None or theirs is None:
        return Difference()
    value = ours.value - theirs.value
    if min(len(a.ends_s), len(b.ends_s)) < MIN_RUNS_FOR_TEST:
        return Difference(value)
    of = _welch(value, [(ours.error**2, ours.freedom), (theirs.error**2, theirs.freedom)])
    scatter = Scatter(len(a.ends_s) * ours.error**2 + len(b.ends_s) * theirs.error**2)
    return Difference(value, interval_of(of), log_rank(a, b), None, scatter, at=lambda level: interval_of(of, level))


def holm(p_values: Values) -> numpy.ndarray:
    """Holm's step-down correction [holm1979]: a corrected value <= 0.05 is found in at most 5 % of analyses in which nothing differs, however the
    comparisons depend on each other. The k-th smallest of m values becomes the largest (m - j + 1) p_j of j = 1, ..., k.
    """
    p = numpy.asarray(p_values, dtype=float)
    order = numpy.argsort(p, kind="stable")
    adjusted = numpy.empty(len(p))
    adjusted[order] = numpy.minimum(1.0, numpy.maximum.accumulate((len(p) - numpy.arange(len(p))) * p[order]))
    return adjusted


def is_significant(p_holm: float | None) -> bool:
    """Whether a p value that is corrected for all comparisons of an analysis is at most 0.05; None and nan are not."""
    return p_holm is not None and p_holm <= SIGNIFICANCE


def hedges_correction(freedom: float) -> float:
    """Factor by which the standardised difference of two samples is unbiased; about 1 - 3 / (4 freedom - 1). `freedom` > 1: degrees of freedom
    of the standard deviation that divides it."""
    return math.exp(math.lgamma(freedom / 2.0) - math.lgamma((freedom - 1.0) / 2.0)) / math.sqrt(freedom / 2.0)


def hedges_g(a: Values, b: Values) -> float | None:
    """Hedges' g [hedges1981]: mean(b) - mean(a) over the pooled spread between runs of both sets, corrected for the number of runs.

    Sets that are compared run by run are taken as if they were independent, so that paired and unpaired sweeps have the same measure: it says
    how far apart runs are, not how sure the difference is. None with fewer than two values in a set, or without any spread.
    """
    a, b = known(a), known(b)
    if len(a) < 2 or len(b) < 2:
        return None
    freedom = len(a) + len(b) - 2
    spread = math.sqrt(((len(a) - 1) * a.var(ddof=1) + (len(b) - 1) * b.var(ddof=1)) / freedom)
    difference = float(b.mean() - a.mean())
    return None if is_rounding(spread, difference) else hedges_correction(freedom) * difference / spread


def test_equivalence(difference: Contrast | None, margin: float, alpha: float = 0.05) -> EquivalenceTest:
    """Two one-sided tests [schuirmann1987], each at level `alpha`: equivalent iff the interval of the difference at 1 - 2 alpha lies within
    +-margin; different iff it does not and the interval at 1 - alpha leaves out zero. Raises ValueError unless margin > 0 and 0 < alpha < 0.5.
    """
    if not margin > 0.0:
        raise ValueError(f"margin = {margin}: must be > 0")
    if not 0.0 < alpha < 0.5:
        raise ValueError(f"alpha = {alpha}: must be > 0 and < 0.5")
    narrow, wide = interval_of(difference, 1.0 - 2.0 * alpha), interval_of(difference, 1.0 - alpha)
    if difference is None or narrow is None or wide is None:
        return EquivalenceTest(None, None, margin, "unknown")
    within = narrow.lower > -margin and narrow.upper < margin
    apart = wide.lower > 0.0 or wide.upper < 0.0
    return EquivalenceTest(
        difference.value, narrow, margin, "equivalent" if within else "different" if apart else "inconclusive"
    )


def scatter_of(*sets: Values) -> Scatter | None:
    """The scatter of the mean of one set of values, one a pair, or of a sum or difference of the means of independent sets, to be repeated with
    equally many runs in each. None if a set has fewer than two. Sets without any spread have the freedom of one.
    """
    arrays = [known(each) for each in sets]
    if any(len(each) < 2 for each in arrays):
        return None
    variances = numpy.array([each.var(ddof=1) for each in arrays])
    squares = float((variances * variances).sum())
    total = float(variances.sum())
    return Scatter(total, total * total / squares if squares > 0.0 else 1.0)


def power_of_t(errors: float, freedom: float, level: float) -> float:
    """How often a two-sided t test at `level` finds a difference of this many errors, by the noncentral t distribution [cohen1988].
    `freedom` > 0,    0 < level < 1."""
    critical = -t_quantile(level / 2.0, freedom)
    errors = abs(errors)
    if errors > 200.0:  # the normal part of the noncentral t is negligible next to the spread of the estimated error
        return float(special.chdtr(freedom, min(freedom * (errors / critical) ** 2, 1e300)))
    return float(1.0 - special.nctdtr(freedom, errors, critical) + special.nctdtr(freedom, errors, -critical))


def errors_for_power(freedom: float, level: float, power: float = USUAL_POWER) -> float:
    """How many errors a difference must have for a two-sided t test at `level` to find it with `power`. Bounds as power_of_t."""
    if power_of_t(0.0, freedom, level) >= power:
        return 0.0
    from scipy import optimize

    high = -t_quantile(level / 2.0, freedom) + max(0.0, t_quantile(power, freedom))
    while power_of_t(high, freedom, level) < power:
        high *= 2.0
    return float(
        optimize.brentq(lambda errors: power_of_t(errors, freedom, level) - power, 0.0, high, xtol=1e-12, rtol=1e-12)
    )


def detectable_difference(of: Contrast, level: float, power: float = USUAL_POWER) -> float:
    """The smallest difference that a comparison with this error and freedom would find with `power` at `level`, two-sided."""
    return of.error * errors_for_power(of.freedom, level, power) if of.error else 0.0


def runs_for_power(difference: float, scatter: Scatter, level: float, power: float = USUAL_POWER) -> int | None:
    """The fewest runs in each set (or pairs), MIN_RUNS_FOR_TEST at least, with which a difference is found with `power` at `level`, two-sided,
    if the scatter is what it is said to be. `difference`: the smallest effect of interest, which a design names before the runs. A difference that
    was observed would say no more than its p value does [hoenig2001]. None for no difference, and where MOST_RUNS are too few. Raises ValueError
    unless level and power lie between 0 and 1."""
    for name, value in (("level", level), ("power", power)):
        if not 0.0 < value < 1.0:
            raise ValueError(f"{name} = {value}: must be > 0 and < 1")
    if difference == 0.0:
        return None
    if is_rounding(math.sqrt(scatter.variance), difference):
        return MIN_RUNS_FOR_TEST
    spreads = abs(difference) / math.sqrt(scatter.variance)

    def suffices(runs: int) -> bool:
        return power_of_t(spreads * math.sqrt(runs), scatter.freedom * (runs - 1), level) >= power

    # The normal distribution asks for fewer runs than t does: from there upwards in growing steps, then back by halving.
    fewest = (max(float(special.ndtri(power) - special.ndtri(level / 2.0)), 0.0) / spreads) ** 2
    if fewest > MOST_RUNS:
        return None
    enough = max(MIN_RUNS_FOR_TEST, int(fewest))
    few, step = enough - 1, 1
    while not suffices(enough):
        few, enough, step = enough, enough + step, 2 * step
        if enough > MOST_RUNS:
            return None
    while enough - few > 1:
        middle = (few + enough) // 2
        few, enough = (few, middle) if suffices(middle) else (middle, enough)
    return enough


@dataclasses.dataclass
class Difference:
    """A difference of sets. The interval and `p` are of this difference alone; `adjusted` and `corrected` hold for all that are compared."""

    value: float | None = None
    interval: Interval | None = None
    p: float | None = None
    adjusted: float | None = None
    """p corrected for all comparisons (Holm)"""
    scatter: Scatter | None = None
    """run by run; None if it was not asked for"""
    at: Callable[[float], Interval | None] | None = None
    """its interval at another level"""
    corrected: Interval | None = None
    """the interval of a family in which all hold at once with 95 % (Bonferroni)"""

    def differs(self) -> bool:
        return is_significant(self.adjusted)


def difference_of(value: float | None, of: Contrast | None, scatter: Scatter | None = None) -> Difference:
    """`value` is given by the caller, as a contrast needs more runs than a difference does."""
    return Difference(value, interval_of(of), p_value(of), None, scatter, at=lambda level: interval_of(of, level))


def adjust_together(differences: Iterable[Difference]) -> None:
    """Holm's correction over all of `differences` together, and the intervals that hold for all of them at once. One without a p value, in which
    nothing varies, is not a comparison.

    The intervals are Bonferroni's: with m comparisons each has level 1 - 0.05 / m. Holm's test finds all that these intervals show and sometimes
    more: its simultaneous intervals would say of such a difference no more than its sign [strassburger2008], so its interval may reach over zero.
    """
    differences = list(differences)
    p_values = [each.p for each in differences if each.p is not None]
    adjusted = iter(holm(p_values))
    for each in differences:
        is_compared = each.p is not None
        each.adjusted = float(next(adjusted)) if is_compared else None
        each.corrected = each.at(1.0 - SIGNIFICANCE / len(p_values)) if is_compared and each.at else None
