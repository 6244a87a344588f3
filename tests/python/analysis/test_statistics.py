# SPDX-License-Identifier: MIT
"""Means, intervals, tests and corrections: by hand, against printed tables, and by simulation."""
import math

import numpy
import pytest
from pytest import approx
from trophic.statistics import (
    MIN_RUNS_FOR_TEST,
    Contrast,
    Difference,
    Interval,
    Scatter,
    adjust_together,
    contrast,
    detectable_difference,
    deviation_of,
    difference_of,
    errors_for_power,
    estimate,
    hedges_correction,
    hedges_g,
    holm,
    interval_of,
    interval_of_mean,
    is_significant,
    mean_of,
    p_value,
    power_of_t,
    runs_for_power,
    scatter_of,
    t_quantile,
    t_two_sided,
)
from trophic.statistics import test_equivalence as equivalence_of

SIX = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]


# Student's t


def test_quantiles_are_those_of_printed_tables():
    assert t_quantile(0.975, 9) == approx(2.262, rel=1e-3)
    assert t_quantile(0.95, 5) == approx(2.015, rel=1e-3)
    assert t_quantile(0.5, 3) == approx(0.0, abs=1e-12)


@pytest.mark.parametrize("t", [0.0, 0.3, 1.0, 12.7])
def test_t_of_one_degree_of_freedom_is_cauchys(t):
    assert t_two_sided(t, 1) == approx(1 - 2 * math.atan(t) / math.pi)


@pytest.mark.parametrize("freedom", [1.0, 4.5, 200.0])
def test_tails_beyond_a_quantile_have_the_probability_that_it_leaves(freedom):
    assert t_two_sided(t_quantile(0.975, freedom), freedom) == approx(0.05)


# Intervals and tests


def test_interval_of_six_values_by_hand():
    # Mean 3.5, deviation sqrt(3.5), error sqrt(3.5 / 6) = 0.763763, t(5) = 2.570582 at 95 % and 2.015048 at 90 %.
    assert interval_of_mean(SIX) == approx((3.5 - 2.570582 * 0.763763, 3.5 + 2.570582 * 0.763763), rel=1e-6)
    assert interval_of_mean(SIX, 0.90).upper == approx(3.5 + 2.015048 * 0.763763, rel=1e-6)
    assert deviation_of(SIX) == approx(math.sqrt(3.5))
    assert interval_of_mean([*SIX, math.nan]) == interval_of_mean(SIX)


@pytest.mark.parametrize("count", range(6))
def test_fewer_than_six_runs_have_mean_and_spread_but_no_interval(count):
    few = SIX[:count]
    assert interval_of_mean(few) is None and contrast((-1, SIX), (1, few)) is None
    assert (mean_of(few) is not None) == (count > 0) and (deviation_of(few) is not None) == (count > 1)


def test_difference_is_welchs():
    a = [2.0, 4.0, 6.0, 8.0, 10.0, 12.0]
    of = contrast((-1, a), (1, SIX))
    assert of == approx((3.5 - 7.0, math.sqrt(14 / 6 + 3.5 / 6), 25 / (17 / 5)))  # v_a = 4 v_b
    interval = interval_of(of)
    assert interval.upper - interval.lower == approx(2 * 2.345856 * of.error, rel=2e-3)
    assert contrast((-1, SIX), (1, SIX)).freedom == approx(10)
    assert contrast((-1, SIX), (1, SIX), (1, SIX), (-1, SIX)).freedom == approx(20)


def test_p_values():
    of = contrast((1, SIX))
    assert p_value(of, interval_of(of).lower) == approx(0.05)
    assert p_value(of, 3.5) == approx(1.0)
    constant, other = [0.1] * 6, [0.4] * 6
    assert p_value(contrast((-1, constant), (1, constant))) is None
    assert p_value(contrast((-1, constant), (1, other))) == 0.0
    assert p_value(None) is None
    assert interval_of_mean(constant).lower == interval_of_mean(constant).upper


def test_estimate_has_what_its_number_of_runs_allows():
    assert estimate([]).runs == 0 and estimate([]).mean is None and estimate([2.0]).deviation is None
    assert estimate([1.0, 2.0, 3.0, 4.0, 5.0]) == (5, 3.0, approx(1.5811388), None)
    six = estimate([1.0, 2.0, 3.0, 4.0, 5.0, 3.0])
    assert six.interval.lower < 3.0 < six.interval.upper


def missed(draw, truth, runs, trials=8000):
    """Share of 95 % intervals that leave out the true mean; `draw(shape)` gives values."""
    values = draw((trials, runs))
    outside = 0
    for row in values:
        interval = interval_of_mean(row)
        outside += not interval.lower <= truth <= interval.upper
    return outside / trials


@pytest.mark.parametrize("runs", [6, 10, 20])
@pytest.mark.parametrize("world", ["normal", "uniform", "gamma"])
def test_intervals_leave_out_the_truth_in_5_percent_of_cases_within_1_5_points(world, runs):
    rng = numpy.random.default_rng(runs)
    # Gamma with shape 8: a skewness of 0.71, that of the sacrifices among the released rules' runs.
    draw, truth = {
        "normal": (lambda shape: rng.normal(3, 2, shape), 3.0),
        "uniform": (lambda shape: rng.uniform(0, 1, shape), 0.5),
        "gamma": (lambda shape: rng.gamma(8, 1, shape), 8.0),
    }[world]
    assert abs(missed(draw, truth, runs) - 0.05) <= 0.015


# Many comparisons


def test_holm_by_hand():
    assert list(holm([0.01, 0.9, 0.04, 0.03])) == approx(
        [0.04, 0.9, 0.09, 0.09]
    )  # 2 x 0.04 = 0.08 would pass the one before
    assert list(holm([0.6, 0.7])) == [1.0, 1.0] and list(holm([])) == [] and list(holm([0.05])) == [0.05]


def test_holm_finds_one_of_twenty_comparisons_without_an_effect_in_5_percent_of_analyses():
    rng = numpy.random.default_rng(11)
    found = numpy.mean([holm(p).min() <= 0.05 for p in rng.uniform(size=(4000, 20))])
    assert 0.035 < found < 0.065


def test_difference_has_a_p_value_where_its_contrast_has_one():
    a, b = [1.0, 1.1, 0.9, 1.0, 1.1, 0.9], [2.0, 2.1, 1.9, 2.0, 2.1, 1.9]
    found = difference_of(1.0, contrast((-1, a), (1, b)))
    assert found.p < 1e-6 and found.interval.lower > 0.8
    assert not found.differs()  # not before it is adjusted
    assert difference_of(1.0, None).p is None


def test_differences_are_corrected_together_and_those_without_a_p_value_do_not_count():
    small = Difference(1.0, p=0.02, at=lambda level: Interval(0.0, level))
    none, large = Difference(0.0, adjusted=0.001), Difference(2.0, p=0.03)
    adjust_together([small, none, large])
    assert small.adjusted == large.adjusted == 0.04 and none.adjusted is None
    assert small.corrected == (0.0, 0.975) and none.corrected is None  # half of 5 % is left to each of the two
    assert small.differs() and not none.differs()


def test_corrected_intervals_hold_in_all_of_twenty_comparisons_at_once_in_95_percent_of_analyses():
    rng = numpy.random.default_rng(12)
    truth, inside, alone = numpy.linspace(-1.0, 1.0, 20), 0, 0
    for sets in rng.normal(0.0, 1.0, (300, 20, 8)):
        found = [difference_of(of.mean(), contrast((1.0, of))) for of in sets + truth[:, None]]
        adjust_together(found)
        inside += all(one.corrected.lower <= at <= one.corrected.upper for one, at in zip(found, truth))
        alone += all(one.interval.lower <= at <= one.interval.upper for one, at in zip(found, truth))
    assert inside >= 0.93 * 300 and alone <= 0.5 * 300


@pytest.mark.parametrize("p_holm, significant", [(0.05, True), (0.0501, False), (None, False), (math.nan, False)])
def test_significant_is_a_corrected_p_value_of_at_most_5_percent(p_holm, significant):
    assert is_significant(p_holm) is significant


# Effect sizes


def test_hedges_correction_has_closed_forms_at_few_degrees_of_freedom():
    assert hedges_correction(2) == approx(1 / math.sqrt(math.pi))
    assert hedges_correction(4) == approx(math.sqrt(2 / math.pi))
    assert hedges_correction(18) == approx(1 - 3 / (4 * 18 - 1), rel=1e-3)


def test_hedges_g_by_hand():
    a, b, c = [1.0, 2.0, 3.0], [4.0, 6.0, 8.0], [4.0, 6.0, 8.0, 6.0, 6.0]
    # Means 2 and 6, variances 1 and 4: the pooled deviation is sqrt(2.5) with 4 degrees of freedom.
    assert hedges_g(a, b) == approx(4 / math.sqrt(2.5) * math.sqrt(2 / math.pi))
    assert hedges_g(b, a) == -hedges_g(a, b)
    # Squares 2 and 8 over 2 + 4 degrees of freedom; the correction at 6 is 2 / sqrt(3) / (3 sqrt(pi) / 4).
    assert hedges_g(a, c) == approx(4 / math.sqrt(10 / 6) * 8 / (3 * math.sqrt(3 * math.pi)))
    assert hedges_g([1.0, 1.0], [2.0, 2.0]) is None and hedges_g([1.0, 1.0], [2.0]) is None


def test_hedges_g_of_six_runs_is_unbiased():
    rng = numpy.random.default_rng(3)
    sets = zip(rng.normal(0.0, 2.0, (20000, 6)), rng.normal(1.6, 2.0, (20000, 6)))
    assert numpy.mean([hedges_g(a, b) for a, b in sets]) == approx(0.8, rel=0.02)


# Equivalence


def test_equal_sets_are_equivalent_far_ones_different_scattered_ones_inconclusive_five_runs_unknown():
    a = [1.0, 1.1, 0.9, 1.0, 1.05, 0.95]

    def test(b, margin=0.2):
        return equivalence_of(contrast((-1, a), (1, b)), margin)

    same = test(a)
    assert same.conclusion == "equivalent" and same.difference == 0.0
    assert same.interval.lower == approx(-same.interval.upper)
    assert test([x + 1 for x in a]).conclusion == "different"
    assert test([-3.0, 5.0, 1.0, 4.0, -2.0, 1.0]).conclusion == "inconclusive"
    assert test(a[:5]) == (None, None, 0.2, "unknown")
    sure = [1.05, 1.06, 1.04, 1.05, 1.06, 1.04]
    small = contrast((-1, [x - 0.05 for x in sure]), (1, sure))
    assert (
        equivalence_of(small, 0.1).conclusion == "equivalent" and equivalence_of(small, 0.04).conclusion == "different"
    )


@pytest.mark.parametrize("runs", [6, 30])
def test_sets_that_differ_by_the_margin_are_called_equivalent_in_5_percent_of_cases(runs):
    rng = numpy.random.default_rng(runs)
    wrong = [
        equivalence_of(contrast((-1, a), (1, b)), 1.0).conclusion == "equivalent"
        for a, b in zip(rng.normal(0.0, 0.3, (4000, runs)), rng.normal(1.0, 0.3, (4000, runs)))
    ]
    assert 0.035 < numpy.mean(wrong) < 0.065


@pytest.mark.parametrize("margin, alpha", [(0.0, 0.05), (math.nan, 0.05), (1.0, 0.5)])
def test_equivalence_refuses_a_bad_margin_or_level(margin, alpha):
    with pytest.raises(ValueError, match="must be > 0"):
        equivalence_of(contrast((1, SIX)), margin, alpha)


# Power


def test_power_of_a_t_test_as_in_printed_tables():
    assert power_of_t(0.5 * math.sqrt(34), 33, 0.05) == approx(0.8078, rel=1e-3)  # one sample, half a deviation
    assert power_of_t(0.5 * math.sqrt(32), 126, 0.05) == approx(0.8015, rel=1e-3)  # two samples of 64
    assert power_of_t(0.8 * math.sqrt(13), 50, 0.05) == approx(0.8075, rel=1e-3)
    assert power_of_t(0.0, 7, 0.05) == approx(0.05)
    assert power_of_t(-3.0, 7, 0.01) == power_of_t(3.0, 7, 0.01)


def test_power_far_away_is_one_without_a_step_where_the_formula_changes():
    assert power_of_t(1e9, 5, 1e-9) == approx(1.0) and power_of_t(1e9, 1, 0.05) == approx(1.0)
    # One degree of freedom: 200 errors lie in the middle of the curve at this level.
    assert power_of_t(200.0001, 1, 0.003) == approx(power_of_t(199.9999, 1, 0.003), rel=1e-4)
    assert power_of_t(200.0, 1, 0.003) < 0.9
    assert runs_for_power(1e6, Scatter(1.0), 1e-7) == MIN_RUNS_FOR_TEST


@pytest.mark.parametrize(
    "difference, scatter, runs",
    [
        (0.5, (1, 1), 34),
        (-0.5, (2, 2), 64),
        (0.2, (2, 2), 394),
        (0.8, (2, 2), 26),
        (100, (1, 1), 6),
        (1, (0, 1), 6),
        (0, (1, 1), None),
        (1e-4, (1, 1), None),
    ],
)
def test_fewest_runs_that_are_enough(difference, scatter, runs):
    assert runs_for_power(difference, Scatter(*scatter), 0.05) == runs


@pytest.mark.parametrize("level", [0.05, 1e-3, 1e-6])
@pytest.mark.parametrize("difference", [0.05, 0.4, 1.0, 3.0])
def test_fewest_runs_are_enough_and_one_fewer_is_not(difference, level):
    runs = runs_for_power(difference, Scatter(1.0), level)
    assert power_of_t(difference * math.sqrt(runs), runs - 1, level) >= 0.8
    assert runs == MIN_RUNS_FOR_TEST or power_of_t(difference * math.sqrt(runs - 1), runs - 2, level) < 0.8


@pytest.mark.parametrize("freedom", [5.0, 9.3, 38.0, 4000.0])
@pytest.mark.parametrize("level", [0.05, 1e-4, 1e-7])
def test_smallest_detectable_effect_is_found_with_80_percent_power(freedom, level):
    assert power_of_t(errors_for_power(freedom, level), freedom, level) == approx(0.8, rel=1e-6)


def test_detectable_difference_is_in_errors():
    assert detectable_difference(Contrast(1.0, 2.0, 9.0), 0.05) == 2 * errors_for_power(9.0, 0.05)
    assert detectable_difference(Contrast(1.0, 0.0, 1.0), 0.05) == 0.0


def test_scatter_of_pairs_and_of_sets():
    a, b = [1.0, 2.0, 3.0], [4.0, 6.0, 8.0]
    assert (
        scatter_of(b) == approx((4.0, 1.0))
        and scatter_of(a, b) == approx((5.0, 25 / 17))
        and scatter_of(a, a).freedom == approx(2.0)
    )
    assert scatter_of([1.0]) is None and scatter_of(a, [1.0]) is None


@pytest.mark.parametrize("level, power", [(0.0, 0.8), (0.05, 1.0)])
def test_runs_for_power_refuses_a_bad_level_or_power(level, power):
    with pytest.raises(ValueError, match="must be > 0 and < 1"):
        runs_for_power(1.0, Scatter(1.0), level, power)


@pytest.mark.parametrize("level", [0.05, 0.001])
@pytest.mark.parametrize("deviations", [(1.0, 1.0), (2.0, 0.5), (1.0, 1.0, 1.5, 0.5)])
def test_simulated_studies_of_so_many_runs_as_needed_find_the_difference_in_80_percent(deviations, level):
    variances = numpy.square(deviations)
    scatter = Scatter(variances.sum(), variances.sum() ** 2 / numpy.square(variances).sum())
    runs = runs_for_power(1.0, scatter, level)

    def found(count):
        rng = numpy.random.default_rng(count)
        sets = [rng.normal(float(i == 0), deviation, (2000, count)) for i, deviation in enumerate(deviations)]
        return numpy.mean([p_value(contrast(*zip((1, -1, -1, 1), study))) <= level for study in zip(*sets)])

    assert found(runs) == approx(0.80, abs=0.035)
    assert found(runs // 2) < 0.65
