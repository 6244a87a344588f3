# SPDX-License-Identifier: MIT
"""What is compared, corrected, the same, significant and a finding: on hand-written sets, and by simulation."""
import ast
import math
import pathlib
import re

import numpy
import pytest
from pytest import approx
from sets import around, metric, set_of
from trophic import judge
from trophic.runs import RunError

NAN = math.nan
TAGS = metric("tag_symmetry", "prey+predator", "inherited")
X, Y, CONSTANT = metric("x"), metric("y"), metric("constant")


def tags_around(value, null, count=6, shadow=None):
    return set_of(
        {TAGS: around(value, count)},
        {(TAGS, "permuted_tags", "null"): around(null, count, 0.02), (TAGS, "uniform_pairs", "paper"): [2 / 3] * count},
        shadow,
    )


def near(x, spread=0.01):
    """Six runs with three metrics: x around `x`, y around 1 whatever x is, and a constant."""
    return {X: around(x, spread=spread), Y: [1.1] * 3 + [0.9] * 3, CONSTANT: [0.0] * 6}


def row_of(frame, null="shadow", **parts):
    for name, value in {**({"null": null} if "null" in frame else {}), **parts}.items():
        frame = frame[frame[name] == value]
    (row,) = frame.itertuples()
    return row


# Sets and their nulls


def test_only_nulls_get_a_difference_and_a_conclusion_and_the_papers_baseline_is_shown():
    frame = judge.summarize(tags_around(0.50, 0.40))
    assert list(frame.null) == ["permuted_tags", "uniform_pairs"]
    null, paper = frame.itertuples()
    assert (null.conclusion, null.role, null.mean, null.published) == ("above", "null", approx(0.5), 0.43)
    assert (paper.conclusion, paper.role, paper.null_mean) == ("not compared", "paper", approx(2 / 3))
    assert math.isnan(paper.difference) and math.isnan(paper.p)
    assert judge.count(frame) == (1, 1)


def test_runs_own_null_is_paired_with_it():
    levels = [0.2, 0.9, 0.5, 0.7, 0.3, 0.6]
    frame = judge.summarize(
        set_of({TAGS: [level + 0.01 for level in levels]}, {(TAGS, "permuted_tags", "null"): levels})
    )
    assert frame.conclusion[0] == "above" and frame.difference_lower[0] == approx(0.01)


def test_shadow_comes_first_and_its_runs_are_a_set_of_their_own():
    ours, shadow = tags_around(0.5, 0.5, 8), tags_around(0.4, 0.4, 6)
    frame = judge.summarize(tags_around(0.5, 0.5, 8, shadow))
    assert list(frame.null) == ["shadow", "permuted_tags", "uniform_pairs"]
    assert (frame.role[0], frame.null_n[0], frame.null_mean[0], frame.difference[0], frame.conclusion[0]) == (
        "null",
        6,
        approx(0.4),
        approx(0.1),
        "above",
    )
    assert judge.summarize(tags_around(0.4, 0.4, 6, ours)).conclusion[0] == "below"
    assert judge.summarize(tags_around(0.5, 0.5, 8, ours)).conclusion[0] == "inconclusive"


@pytest.mark.parametrize("ours, shadow", [(5, 5), (6, 5), (5, 6)])
def test_five_runs_or_five_of_the_shadow_have_numbers_and_no_conclusion(ours, shadow):
    of = tags_around(0.5, 0.1, ours, tags_around(0.5, 0.1, shadow))
    row = row_of(judge.summarize(of))
    assert row.n == ours and not math.isnan(row.deviation) and not math.isnan(row.difference)
    assert math.isnan(row.lower) == (ours == 5) and math.isnan(row.difference_lower) and math.isnan(row.p_holm)
    assert row.conclusion == "too few runs"
    assert len(judge.too_few(of)) == (ours < 6) + (shadow < 6)
    assert "too few runs for a test: 6 are needed, paper has 5" in judge.too_few(of)


def test_runs_without_a_value_are_left_out():
    row = judge.summarize(set_of({TAGS: [0.6, NAN, 0.8]}, {(TAGS, "permuted_tags", "null"): [0.5, NAN, NAN]})).iloc[0]
    assert (row.n, row["mean"], row.difference) == (2, approx(0.7), approx(0.1))
    none = judge.summarize(set_of({TAGS: [NAN]})).iloc[0]
    assert none.n == 0 and math.isnan(none["mean"]) and none.null == "" and none.conclusion == "not compared"


def test_shadow_of_another_food_web_is_refused():
    with pytest.raises(RunError, match="different food webs"):
        judge.summarize(set_of({X: around(1)}, shadow=set_of({metric("x", "wolf"): around(1)})))


def test_family_is_every_null_comparison_that_repeats_no_other():
    values = {X: [1.0, 5.0, 3.0, 2.0, 9.0, 4.0], Y: [2.0, 6.0, 4.0, 3.0, 10.0, 5.0], CONSTANT: [0.0] * 6}
    frame = judge.summarize(set_of(values, {(X, "permuted", "null"): [0.5] * 6}, set_of(values)))
    assert row_of(frame, metric="y").conclusion == "same" and row_of(frame, metric="y").same_as == "x:prey:all"
    assert row_of(frame, metric="constant").conclusion == "not compared"
    assert judge.count(frame) == (2, 0)
    assert row_of(frame, "permuted", metric="x").p_holm == approx(2 * row_of(frame, "permuted", metric="x").p)


@pytest.mark.parametrize("chosen, kept", [(["x"], 1), (["x:prey"], 1), (["y:prey:all", "x"], 2), ([], 3)])
def test_choices_keep_the_order_of_the_metrics_and_make_the_family_smaller(chosen, kept):
    frame = judge.summarize(set_of(near(0.5), shadow=set_of(near(0.4))), chosen)
    assert list(frame.metric) == ["x", "y", "constant"][:kept]


def test_choice_that_names_no_metric_is_refused():
    names = [metric("deaths"), metric("deaths", group="caught"), metric("hunger", "predator")]
    assert judge.chosen(names, ["hunger", "deaths:prey:all"]) == [names[0], names[2]]
    for wrong in ("hungr", "death", "deaths:predator", "deaths:prey:caught:1", ""):
        with pytest.raises(
            RunError, match=f"metric {wrong}: must be METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP of deaths, hunger"
        ):
            judge.chosen(names, [wrong])
    with pytest.raises(RunError, match="; did you mean hunger\\?"):
        judge.chosen(names, ["hungr"])


# Metrics that say the same


@pytest.mark.parametrize(
    "a, b, repeats",
    [
        ([0.1, 0.7, 0.3, 0.2, 0.9, 0.4], [0.1, 0.7, 0.3, 0.2, 0.9, 0.4], True),
        ([1, 5, 3, 2, 9, 4], [29, 25, 27, 28, 21, 26], True),
        ([1, 5, 3, 2, 9, 4], [2, 6, 4, 3, 10, 5], True),
        ([1, NAN, 3, 2, 9, 4, 7], [1, NAN, 3, 2, 9, 4, 7], True),
        ([1, 5, 3, 2, 9, 4], [1, 5, 3, 2, 9, 4.001], False),
        ([1, 5, 3, 2, 9, 4], [2, 10, 6, 4, 18, 8], False),
        ([1, 5, 3, 2, 9, 4, 7], [1, 5, 3, 2, 9, 4, NAN], False),
        ([1] * 6, [2] * 6, False),
        ([1, 5, 3, 2, 9], [1, 5, 3, 2, 9], False),
    ],
)
def test_metric_repeats_an_earlier_one_if_equal_shifted_or_reversed_in_every_run(a, b, repeats):
    half = len(a) // 2
    sets = [
        set_of({X: [float(v) for v in a[part]], Y: [float(v) for v in b[part]]})
        for part in (slice(half), slice(half, None))
    ]
    assert judge.repeated([X, Y], sets) == ({Y: X} if repeats else {})


def test_another_reading_of_velocity_repeats_it_unless_it_stands_alone():
    plain, stored = metric("velocity"), metric("velocity_stored")
    assert judge.repeated([plain, stored], []) == {stored: plain} and judge.repeated([stored], []) == {}


# Two sets


def test_difference_that_the_shadows_have_too_is_raw_and_none_over_the_shadows():
    def compared(a, null_a, b, null_b):
        return judge.compare(
            set_of(near(a), shadow=set_of(near(null_a))), set_of(near(b), shadow=set_of(near(null_b)), label="released")
        )

    both = compared(0.5, 0.4, 0.7, 0.6)
    raw, over = row_of(both, metric="x", compared="raw"), row_of(both, metric="x", compared="over_shadow")
    assert raw.difference == approx(0.2) and raw.p < 1e-6
    assert (raw.conclusion, raw.role) == ("not compared", "") and raw.p_holm <= 0.05  # the answer is the other
    assert judge.count(both) == (2, 0)
    assert over.difference == approx(0.0) and over.conclusion == "inconclusive"
    assert judge.findings(both) == []
    (finding,) = judge.findings(compared(0.5, 0.4, 0.7, 0.4))
    assert (finding.baseline, finding.effect) == ("over_shadow", approx(0.2))
    assert (
        finding.sentence
        == "X of prey is 0.200 higher in runs of released than in runs of paper, each over its shadow [0.178, 0.222] (p <0.001, 6+6 runs)."
    )


def test_without_a_shadow_of_both_the_raw_difference_is_the_answer():
    frame = judge.compare(set_of(near(0.5), shadow=set_of(near(0.4))), set_of(near(0.7)))
    assert set(frame.compared) == {"raw"} and row_of(frame, metric="x").conclusion == "above"


def test_p_values_are_corrected_for_the_metrics_that_vary():
    x, y, constant = judge.compare(set_of(near(0.5)), set_of(near(0.51))).itertuples()
    assert (
        x.p_holm == approx(2 * x.p)
        and y.p_holm == 1.0
        and math.isnan(constant.p)
        and constant.conclusion == "not compared"
    )


def test_metric_that_one_set_lacks_is_left_out_and_five_runs_have_no_interval():
    five = {name: values[:5] for name, values in near(0.5).items()}
    other = {metric("x", "wolf"): around(0.7), Y: near(0.7)[Y], CONSTANT: [0.0] * 6}
    y, _ = judge.compare(set_of(five), set_of(other)).itertuples()
    assert (
        y.metric == "y"
        and not math.isnan(y.difference)
        and math.isnan(y.lower)
        and math.isnan(y.p)
        and y.conclusion == "too few runs"
    )


def test_sets_without_a_common_metric_are_refused():
    with pytest.raises(RunError, match="paper and forest: have no metric in common"):
        judge.compare(set_of(near(0.5)), set_of({metric("x", "wolf"): around(1)}, label="forest"))


# Findings


def findings_of(values, null):
    return judge.findings(judge.summarize(set_of(values, shadow=set_of(null))))


def apart(places):
    """Sets in which the metrics of `places`, (metric, mean, mean of the shadow), differ, each with noise of its own."""
    rng = numpy.random.default_rng(7)
    return tuple(
        {name: list(rng.normal(place[side], 0.01 * abs(place[0] - place[1]), 10)) for name, *place in places}
        for side in (0, 1)
    )


def test_findings_say_each_fact_once_in_the_words_of_its_plainest_row():
    found = findings_of(
        *apart(
            [
                (metric("deaths", group="caught"), 9.0, 5.0),
                (metric("velocity", group="active"), -0.02, 0.02),
                (metric("velocity"), -0.01, 0.01),
                (metric("velocity_points"), -0.03, 0.02),
                (metric("stuck", "all"), 0.2, 0.1),
                (metric("stuck"), 0.3, 0.1),
            ]
        )
    )
    assert [str(f.metric) for f in found] == ["velocity:prey:all", "deaths:prey:caught", "stuck:prey:all"] or [
        str(f.metric) for f in found
    ] == ["velocity:prey:all", "stuck:prey:all", "deaths:prey:caught"]


def test_findings_begin_with_the_papers_questions_then_go_by_strength():
    names = [
        metric("weak"),
        metric("strong"),
        TAGS,
        metric("wall_sticking"),
        metric("attribution_caught"),
        metric("velocity", "predator"),
    ]
    rng = numpy.random.default_rng(1)
    sets = [
        {name: list(rng.normal(side, 0.001 if name.metric == "strong" else 0.02, 10)) for name in names}
        for side in (1.0, 1.2)
    ]
    assert [f.metric.metric for f in findings_of(*sets)] == [
        "velocity",
        "attribution_caught",
        "wall_sticking",
        "tag_symmetry",
        "strong",
        "weak",
    ]


# The neutral null


def with_neutral(label="paper", shift=0.01):
    """Runs that inherit X, whose levels their repetitions share, in another order and without the last; Y is behaviour."""
    levels = [0.2, 0.9, 0.5, 0.7, 0.3, 0.6, 0.4]
    made = set_of(
        {X: [level + shift for level in levels], Y: around(1.0, 7)},
        shadow=set_of({X: around(0.9, 7), Y: around(0.8, 7)}),
        label=label,
    )
    made.neutral = set_of({X: levels[5::-1], Y: around(3.0, 6)})
    made.neutral.runs = made.runs[5::-1]
    made.inherited = frozenset({"x"})
    return made


def test_what_is_inherited_is_tested_against_the_neutral_null_paired_by_seed_and_all_else_against_the_shadow():
    frame = judge.summarize(with_neutral())
    assert list(zip(frame.metric, frame.null, frame.role)) == [
        ("x", "shadow", "reference"),
        ("x", "neutral", "null"),
        ("y", "shadow", "null"),
    ]
    neutral, shadow = row_of(frame, "neutral"), row_of(frame, metric="x")
    assert (
        neutral.difference,
        neutral.difference_lower,
        neutral.null_n,
        neutral.conclusion,
        judge.runs_of(neutral),
    ) == (approx(0.01), approx(0.01), 6, "above", "6")
    assert (shadow.difference, shadow.conclusion) == (
        approx(0.5243 - 0.9 - 0.01 / 7, abs=1e-3),
        "not compared",
    ) and math.isnan(shadow.p_holm)
    assert judge.count(frame).comparisons == 2
    assert "X of prey is 0.52, 0.01 higher than in the neutral null" in re.sub(
        r"(\.\d\d)\d", r"\1", " ".join(one.sentence for one in judge.findings(frame))
    )
    assert list(judge.with_nulls(frame).null) == ["shadow", "neutral", "shadow"]
    assert judge.too_few(with_neutral()) == []


def test_two_sets_are_compared_over_the_null_that_both_have():
    a, b = with_neutral(), with_neutral("released", 0.05)
    frame = judge.compare(a, b)
    assert list(frame.compared) == ["over_neutral", "raw", "over_shadow", "raw"] and list(frame.role) == [
        "null",
        "",
        "null",
        "",
    ]
    assert (frame.difference[0], frame.lower[0]) == (approx(0.04), approx(0.04))
    assert (
        "X of prey is 0.040 higher in runs of released than in runs of paper, each over its neutral null"
        in judge.findings(frame)[0].sentence
    )
    b.neutral = None
    assert list(judge.compare(a, b).compared) == [
        "raw",
        "over_shadow",
        "raw",
    ]  # the shadow does not answer for what is inherited


@pytest.mark.parametrize(
    "name, mean, null, sentence",
    [
        (
            metric("velocity"),
            -0.0069,
            -0.0024,
            r"Prey move away from predators at 0\.6. cm/s, 0\.4. cm/s faster than in the shadow \[0\.4., 0\.4.\] \(p <0\.001, 10\+10 runs\)\.",
        ),
        (
            metric("velocity", "predator", "inherited"),
            0.01,
            0.02,
            r"Inherited predators move towards prey at 1\.00 cm/s, 1\.0. cm/s slower than in the shadow \[.*",
        ),
        (
            metric("velocity"),
            -0.01,
            0.01,
            r"Prey move away from predators at 1\.0. cm/s; in the shadow they move towards them at (1\.0.|0\.99) cm/s: a difference of [12]\.\d\d cm/s \[.*",
        ),
        (
            metric("velocity", "wolf"),
            0.02,
            0.01,
            r"The velocity of wolf individuals towards their adversaries is 2\.0. cm/s, 1\.0. cm/s higher than in the shadow \[.*",
        ),
        (
            metric("wall_sticking", group="active"),
            0.5,
            0.6,
            r"The share of active prey within 1 m of a wall is 0\.\d+, 0\.\d+ lower than in the shadow \[0\.\d+, .*",
        ),
        (
            metric("wall_sticking_gap", "prey-predator"),
            0.5,
            0.3,
            r"The excess of prey over predators within 1 m of a wall is .*",
        ),
        (metric("deaths", group="caught"), 50.0, 40.0, r"The number of prey that are caught in a run is 50\.\d, .*"),
        (metric("ticks_at", "predator", "8"), 0.5, 0.4, r"The share of time with 8 predators is .*"),
        (
            metric("tag_symmetry", "prey+predator", "inherited_active"),
            0.5,
            0.4,
            r"The tag symmetry of inherited active prey and predators is .*",
        ),
        (metric("my_own", "prey", "left"), 0.5, 0.4, r"My own of prey \(left\) is .*"),
        (metric("lone", "", "all"), 0.5, 0.4, r"Lone is .*"),
    ],
)
def test_sentences(name, mean, null, sentence):
    (found,) = findings_of(*apart([(name, mean, null)]))
    assert numpy.sign(found.effect) == numpy.sign(mean - null)
    assert re.fullmatch(sentence, found.sentence), found.sentence


def test_inconclusive_facts_are_those_without_a_finding_the_nearest_to_significance_first():
    rng = numpy.random.default_rng(4)
    names = [metric("velocity"), metric("velocity", group="random"), metric("far"), metric("near")]
    shift = {"velocity": 1.0, "far": 0.01, "near": 0.4}
    ours = {name: list(rng.normal(0.0, 0.3, 10)) for name in names}
    shadow = {
        name: list(rng.normal(0.0, 0.3, 10) + (shift[name.metric] if name.group == "all" else 0.0)) for name in names
    }
    frame = judge.summarize(set_of(ours, shadow=set_of(shadow)))
    assert [f.metric.metric for f in judge.findings(frame)] == ["velocity"]
    assert [row.metric for row in judge.inconclusive(frame)] == ["near", "far"]


def test_only_the_statistics_and_the_judge_know_the_level():
    package = pathlib.Path(judge.__file__).parent
    for path in package.rglob("*.py"):
        if path not in (package / "statistics.py", package / "judge.py"):
            compared = [
                ast.unparse(node) for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Compare)
            ]
            assert not [text for text in compared if re.search(r"\b0\.05\b|SIGNIFICANCE", text)], path


@pytest.mark.parametrize(
    "size, sentence",
    [
        ((0, 0), "Nothing was compared with a null."),
        ((39, 6), "6 of 39 comparisons are significant (p <= 0.05, corrected for all of them: Holm)."),
        (
            (39, 0),
            "0 of 39 comparisons are significant (p <= 0.05, corrected for all of them: Holm). This does not show that nothing differs.",
        ),
    ],
)
def test_count_in_words(size, sentence):
    assert judge.Count(*size).sentence() == sentence
