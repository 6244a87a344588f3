# SPDX-License-Identifier: MIT
"""Published numbers, and whether runs reproduce them."""
import math

import numpy
import pytest
from pytest import approx
from sets import around, metric, set_of
from trophic.judge import summarize
from trophic.published import (
    CLAIMS,
    QUESTIONS,
    ClaimConclusion,
    ClaimReading,
    ReadingConclusion,
    Spread,
    answers,
    applies_to,
    conclusion_on,
    judge,
    judge_claims,
    less_published,
    margin_of,
    summary_of,
    value_of,
)
from trophic.statistics import contrast, estimate, interval_of_mean

TAGS = ClaimReading(metric("tag_symmetry", "prey+predator", "inherited"), 0.43, Spread(0.065, "published range"))
YES, NO, OPEN, NONE = "reproduced", "not reproduced", "inconclusive", "no conclusion"


def spread_out(count, mean, deviation):
    scale = deviation * math.sqrt((count - 1) / count)
    return [mean + (scale if i % 2 == 0 else -scale) for i in range(count)]


@pytest.mark.parametrize(
    "name, species, group, value",
    [
        ("attribution_credited", "predator", "all", 0.725),
        ("attribution_caught", "prey", "all", 0.65),
        ("velocity_stored", "prey", "all", -0.0067),
        ("tag_symmetry", "prey+predator", "inherited", 0.43),
        ("velocity", "predator", "all", 0.0195),
        ("velocity", "prey", "active", -0.0067),
        ("velocity_points", "predator", "inherited", 0.0195),
        ("wall_sticking_gap", "prey-predator", "active", 0.21),
        ("attribution_catches", "predator", "all", None),
        ("attribution_catchers", "predator", "all", None),
        ("attribution_died", "prey", "all", None),
        ("velocity", "prey", "random", None),
        ("wall_sticking", "wolf", "all", None),
    ],
)
def test_published_numbers_in_si_units_and_none_for_what_only_the_logs_count_in_another_way(
    name, species, group, value
):
    assert value_of(metric(name, species, group)) == value


@pytest.mark.parametrize(
    "label, applies", [("paper", True), ("released", True), ("paper_plus", False), ("mine", False)]
)
def test_published_numbers_stand_next_to_published_tables_alone(label, applies):
    assert applies_to(set_of({TAGS.metric: [0.4] * 6}, label=label)) is applies


def test_readings_of_a_claim_have_different_words_and_a_margin():
    for claim in CLAIMS:
        words = {(reading.members, reading.counting) for reading in claim.readings}
        assert len(words) == len(claim.readings) and (len(words) == 1) == (words == {("", "")}), claim.title
        assert all(margin_of(reading) > 0 for reading in claim.readings)


@pytest.mark.parametrize(
    "mean, deviation, conclusion",
    [(0.43, 0.05, YES), (0.44, 0.01, YES), (0.46, 0.01, OPEN), (0.55, 0.05, NO), (0.50, 0.02, NO), (0.45, 0.15, OPEN)],
)
def test_conclusion_from_mean_and_spread_of_ten_runs(mean, deviation, conclusion):
    judged = judge(TAGS, spread_out(10, mean, deviation))
    assert (
        judged.conclusion == conclusion
        and judged.difference == approx(mean - 0.43)
        and judged.interval.lower < mean - 0.43
    )


def test_no_spread_known_gives_a_difference_and_no_conclusion():
    values = spread_out(10, 0.55, 0.05)
    judged = judge(TAGS._replace(spread=None), values)
    assert (
        judged.conclusion == NONE
        and judged.difference == approx(0.12)
        and judged.interval.lower == approx(interval_of_mean(values).lower - 0.43)
    )


def test_five_runs_give_numbers_and_no_conclusion():
    few = judge(TAGS, spread_out(5, 0.43, 0.01))
    assert (few.conclusion, few.ours.runs, few.interval) == (NONE, 5, None) and few.difference is not None
    assert judge(TAGS, []).difference is None


def test_claims_have_the_readings_that_runs_measured():
    (claim,) = judge_claims(set_of({TAGS.metric: [0.43] * 6}))
    assert claim.claim.title == "tag symmetry" and [each.conclusion for each in claim.readings] == [YES]


ALL_A, ALL_B, FEW_A, FEW_B = (
    TAGS._replace(members=m, counting=c) for m in ("all count", "few count") for c in ("by a", "by b")
)


@pytest.mark.parametrize(
    "readings, summary",
    [
        ([(TAGS, OPEN)], "inconclusive"),
        ([(ALL_A, YES), (FEW_A, YES)], "reproduced under every reading"),
        ([(ALL_A, NO), (FEW_A, NO)], "not reproduced under any reading"),
        ([(ALL_A, OPEN), (FEW_A, OPEN)], "inconclusive under every reading"),
        ([(ALL_A, NONE), (FEW_A, NONE)], "no conclusion under any reading"),
        ([(ALL_A, NO), (ALL_B, NO), (FEW_A, YES), (FEW_B, YES)], "depends on who counts: reproduced if few count"),
        ([(ALL_A, YES), (ALL_B, OPEN), (FEW_A, YES), (FEW_B, NO)], "depends on how it is counted: reproduced if by a"),
        (
            [(ALL_A, YES), (ALL_B, NO), (FEW_A, NO), (FEW_B, YES)],
            "depends on the reading: reproduced if all count and by a, or few count and by b",
        ),
        ([(ALL_A, NO), (FEW_A, OPEN)], "reproduced under no reading, inconclusive if few count"),
        ([(ALL_A, NO), (FEW_A, NONE)], "reproduced under no reading"),
    ],
)
def test_summary_of_a_claims_readings(readings, summary):
    assert (
        summary_of(
            ClaimConclusion(
                CLAIMS[0],
                tuple(
                    ReadingConclusion(reading, estimate([]), conclusion=conclusion) for reading, conclusion in readings
                ),
            )
        )
        == summary
    )


SPREADS = {reading.spread.deviation / abs(reading.value): reading for claim in CLAIMS for reading in claim.readings}


@pytest.mark.parametrize("reading", [SPREADS[min(SPREADS)], SPREADS[max(SPREADS)]])
def test_published_system_is_rarely_not_reproduced_and_one_a_margin_away_rarely_reproduced(reading):
    """1000 sets of ten of our runs beside ten published ones. Conclusions depend on numbers over the spread alone, so two readings stand for all."""
    rng = numpy.random.default_rng(6)
    deviation = reading.spread.deviation

    def called(off):
        found = []
        for theirs, ours in zip(
            rng.normal(reading.value, deviation, (1000, 10)),
            rng.normal(reading.value + off * deviation, deviation, (1000, 10)),
        ):
            estimated = reading._replace(value=theirs.mean())
            found.append(conclusion_on(less_published(contrast((1.0, ours)), estimated), margin_of(estimated)))
        return {conclusion: found.count(conclusion) for conclusion in (YES, NO, OPEN)}

    same, away = called(0.0), called(1.0)
    assert 0 < same[NO] <= 70 and same[YES] >= 300
    assert 0 < away[YES] <= 60
    assert called(2.0)[NO] >= 950


# Questions about evolution

PREDATORS, PREY = QUESTIONS[:2]
STORED, CLOSEST, POINTS = "velocity_stored", "velocity", "velocity_points"
NOTHING, STRONG, BACK, WEAK = (0.4, 0.2, 0.4, 0.2), (2.0, 0.2, 1.0, 0.2), (0.5, 0.2, 1.5, 0.2), (1.3, 0.2, 1.0, 0.2)


def exact(rng, mean, deviation, count):
    """Values of exactly this mean and deviation."""
    values = rng.normal(size=count)
    return mean + deviation * (values - values.mean()) / values.std(ddof=1)


def asked(question, effects, count=10, family=30, alike=()):
    """The answer to a question of simulated runs. `effects`: mean and deviation of ours and of the shadow in cm/s, by metric and group, by group, by
    metric or of all (""); `alike`: pairs of metrics with the same values. `family`: other comparisons, none of them significant.
    """
    rng = numpy.random.default_rng(1)
    sides = ({}, {})
    for reading in question.readings:
        name, group = reading.metric.metric, reading.metric.group
        of = next(effects[key] for key in ((name, group), group, name, "") if key in effects)
        for side, mean, deviation in zip(sides, of[::2], of[1::2]):
            side[reading.metric] = exact(rng, mean / 100.0, deviation / 100.0, count)
    for later, earlier in alike:
        for side in sides:
            side.update({of: side[of._replace(metric=earlier)] for of in list(side) if of.metric == later})
    for i in range(family):
        for side in sides:
            side[metric(f"other_{i}")] = exact(rng, 1.0, 1.0, count)
    ours, null = (set_of({name: list(values) for name, values in side.items()}) for side in sides)
    ours.shadow = null
    return next(one for one in answers(ours, summarize(ours)) if one.question == question)


PREDATORS_ON_MUJOCO = {  # `paper`, ten runs of 6000 s and ten of the shadow
    "inherited": (0.648, 0.308, 0.379, 0.260),
    (POINTS, "inherited"): (0.651, 0.338, 0.369, 0.442),
    "all": (0.548, 0.151, 0.467, 0.181),
    (POINTS, "all"): (0.601, 0.173, 0.546, 0.256),
}
PREY_ON_MUJOCO = {
    "inherited": (-0.079, 0.130, 0.057, 0.154),
    (POINTS, "inherited"): (-0.096, 0.221, 0.119, 0.176),
    "all": (-0.034, 0.082, 0.037, 0.086),
    (POINTS, "all"): (-0.041, 0.149, 0.071, 0.130),
    "active": (-0.075, 0.095, 0.022, 0.074),
    (POINTS, "active"): (-0.085, 0.148, 0.034, 0.143),
}


@pytest.mark.parametrize(
    "question, effects, answer",
    [
        (PREDATORS, {"": STRONG}, "yes, they approach faster"),
        (PREDATORS, {"": BACK}, "no, they approach more slowly"),
        (PREY, {"": STRONG}, "no, they approach"),
        (PREY, {"": BACK}, "yes, they move away faster"),
        (PREDATORS, {"": NOTHING}, "undecided"),
        (PREDATORS, {"": WEAK}, "undecided"),
        (PREDATORS, PREDATORS_ON_MUJOCO, "undecided"),
        (PREY, PREY_ON_MUJOCO, "undecided"),
        (
            PREDATORS,
            {"inherited": STRONG, "all": NOTHING},
            "depends on who counts: yes, they approach faster if only the inherited count",
        ),
        (
            PREY,
            {"": BACK, "all": WEAK},
            "depends on who counts: yes, they move away faster if the inactive are left out or "
            "only the inherited count",
        ),
        (
            PREDATORS,
            {"": STRONG, POINTS: BACK},
            "depends on how it is counted: yes, they approach faster if the adversary is the stored one or "
            "the adversary is the closest that is perceived; no, they approach more slowly if velocity is measured only every 200 s",
        ),
        (
            PREDATORS,
            {"": NOTHING, (CLOSEST, "all"): STRONG},
            "depends on the reading: yes, they approach faster if every member counts and "
            "the adversary is the closest that is perceived",
        ),
    ],
)
def test_an_answer_stands_under_every_reading_or_says_what_it_depends_on(question, effects, answer):
    assert str(asked(question, effects)) == answer


def test_an_interval_off_zero_decides_nothing_in_a_family():
    alone, among_others = asked(PREDATORS, {"": WEAK}, family=0), asked(PREDATORS, {"": WEAK})
    assert str(alone) == "yes, they approach faster" and str(among_others).startswith("undecided")
    assert among_others.shown.difference.interval.lower > 0.0 and among_others.shown.difference.adjusted == approx(
        among_others.shown.difference.p * 32
    )
    assert among_others.shown.reading.metric == metric("velocity", "predator", "inherited")


def test_readings_that_are_one_number_count_once():
    answer = asked(PREDATORS, {"": STRONG}, alike=[(CLOSEST, STORED)])
    assert (
        len(answer.effects) == 4
        and answer.shown == answer.effects[2]
        and len(asked(PREDATORS, {"": STRONG}).effects) == 6
    )
    assert (
        answer.effects[0].reading.counting
        == "the adversary is the stored one or the adversary is the closest that is perceived"
    )
    stored = around(0.0195, spread=0.001)
    for closest, count in (([0.0195] * 6, 2), (stored, 1)):
        (claim,) = judge_claims(
            set_of({metric(STORED, "predator"): stored, metric(CLOSEST, "predator"): list(closest)})
        )
        assert len(claim.readings) == count


def test_no_answer_without_a_shadow_with_too_few_runs_and_without_all_readings():
    runs = set_of({reading.metric: around(0.02) for reading in PREDATORS.readings})
    assert answers(runs, summarize(runs)) == []
    for readings, count in ((PREDATORS.readings, 5), (PREDATORS.readings[1:], 6)):
        lacking = set_of({reading.metric: around(0.02, count) for reading in readings})
        lacking.shadow = lacking
        assert answers(lacking, summarize(lacking)) == []
