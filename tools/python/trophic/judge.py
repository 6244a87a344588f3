# SPDX-License-Identifier: MIT
"""The one judge: what is compared, corrected, the same, significant, inconclusive and a finding. Terminal, tables, pages and Python print what
stands here and decide nothing.

Which null a metric is compared with is `controls`'. A family is all comparisons that answer one question: those of a set with its nulls, or those of
two sets with each other. Holm's correction is over a family, and a comparison is significant if its corrected p value is at most 0.05. Intervals of
corrected answers hold for the whole family at once (Bonferroni)."""
from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy
import pandas

from . import controls, published
from .controls import SHARES, SURVIVAL
from .errors import RunError
from .metrics import READINGS, chosen, living
from .statistics import (
    MIN_RUNS_FOR_TEST,
    SIGNIFICANCE,
    Difference,
    Scatter,
    adjust_together,
    common_end,
    contrast,
    difference_of,
    estimate,
    interval_of,
    is_by_chance,
    known,
    mean_of,
    restricted_mean,
    runs_for_power,
    scatter_of,
    share_difference,
    share_interval,
    survival_difference,
)
from .values import METRIC, NEUTRAL, SHADOW, MeasuredSet, Metric
from .words import NULLS, Reading, null_title, over_text, p_text

NAN = float("nan")
MOST_FINDINGS = 7
"""Findings that are printed; tables have all."""


class Count(NamedTuple):
    """The size of a family: comparisons, and those that are significant."""

    comparisons: int
    significant: int

    def sentence(self) -> str:
        if self.comparisons == 0:
            return "Nothing was compared with a null."
        rest = "" if self.significant else " This does not show that nothing differs."
        return f"{self.significant} of {self.comparisons} comparisons are significant (p <= 0.05, corrected for all of them: Holm).{rest}"


class Finding(NamedTuple):
    """A significant difference in words."""

    sentence: str
    metric: Metric
    baseline: str
    """the null, or for two sets what was compared: over_shadow, over_one_sided, over_neutral or raw"""
    effect: float
    """ours - null, or b - a, in the metric's unit"""
    interval: tuple[float, float]
    """of the effect; it holds with 95 % for all comparisons at once"""
    p_holm: float
    set: str
    """label of the set; empty for two sets"""


# Comparisons


def repeated(metrics: Sequence[Metric], sets: Sequence[MeasuredSet]) -> dict[Metric, Metric]:
    """The first earlier metric that a metric repeats, for each that repeats one.

    READINGS repeat the metric that they read. Otherwise, in every run of every set both have a value, or neither, and
    either their difference or their sum is the same in all runs: their tests are then one test. A metric repeats none if it is constant, or has
    fewer than six values, of which two may agree by chance."""
    missing = [numpy.full(len(one.values), NAN) for one in sets]
    return repeated_values(
        {
            metric: numpy.concatenate(
                [one.table.get((metric, ""), lack) for one, lack in zip(sets, missing)] or [numpy.empty(0)]
            )
            for metric in metrics
        }
    )


def repeated_values(values: dict[Metric, numpy.ndarray]) -> dict[Metric, Metric]:
    """As `repeated`, of values by metric, one a run."""
    repeats: dict[Metric, Metric] = {}
    for place, (later, of_later) in enumerate(values.items()):
        read = (READINGS.get(later.metric, ""), *later[1:3])
        if plain := next((metric for metric in values if metric[:3] == read), None):
            repeats[later] = plain
            continue
        there = ~numpy.isnan(of_later)
        if there.sum() < MIN_RUNS_FOR_TEST or numpy.ptp(of_later[there]) == 0.0:
            continue
        for earlier, of_earlier in list(values.items())[:place]:
            if earlier in repeats or earlier.unit != later.unit or (there != ~numpy.isnan(of_earlier)).any():
                continue
            a, b = of_earlier[there], of_later[there]
            if min(numpy.ptp(b - a), numpy.ptp(b + a)) <= 1e-12 * max(numpy.abs(a).max(), numpy.abs(b).max()):
                repeats[later] = earlier
                break
    return repeats


# Frames


def summarize(of: MeasuredSet, choices: Sequence[str] = ()) -> pandas.DataFrame:
    """Each metric of a set next to each of its baselines, one row each, the nulls that are runs first; one row for a metric without a baseline.

    Columns: those of means.csv (docs/tables.md), of which `null` names any baseline; `role` of the baseline ("null" is tested against; "paper",
    "reference" and "" are not) and `conclusion`: above, below, inconclusive, too few runs, same, not compared. nan is what could not be computed.

    A metric is tested against the null that `controls` names. Others that are runs are references next to it, with a difference that belongs to no
    family; so are all of a metric that cannot be judged.

    Runs and nulls are independent sets (Welch). Runs and shadows of one seed are slightly alike (kinematic, 60 seeds, 41 metrics: correlation
    0.13 in the median, 0.47 at most), so that intervals are rather too wide. Pairing would gain that, and at ten runs lose as much in degrees of
    freedom. A baseline that each run has of its own is paired by run, and so is the neutral null, which repeats each run. Raises RunError for a
    choice that names no metric, and for a null of other metrics.
    """
    if any(null.metrics() != of.metrics() for null in of.nulls.values()):
        raise RunError(f"{of.label}: runs with different food webs cannot be pooled or compared with a null")
    wanted = chosen(of.metrics(), choices)
    answers = {metric: controls.control_of(of, metric) for metric in wanted}
    repeats = {
        later: earlier
        for later, earlier in repeated(wanted, [of, *of.nulls.values()]).items()
        if answers[earlier].null or not answers[later].null
    }
    has_published = published.applies_to(of)
    rows: list[dict[str, Any]] = []
    differences: list[Difference | None] = []
    for metric in wanted:
        values, control, nulls = of.table[metric, ""], answers[metric], of.nulls_of(metric)
        end_s = _end_of(metric, of, *nulls.values())
        row = {
            "set": of.label,
            **metric._asdict(),
            **_estimated(of, metric, end_s),
            "published": published.value_of(metric) if has_published else None,
            "same_as": str(repeats.get(metric, "")),
        }
        baselines: list[tuple[str, str, float | None, int, Difference | None, str]] = []
        for name, null in nulls.items():
            its, is_null = _estimated(null, metric, end_s), name == control.null
            count, mean = its["n"], its["mean"]
            if name == NEUTRAL:
                paired = of.null_values(metric, name)
                count, mean = len(known(paired)), mean_of(paired)
            lacks = _lack(metric, of, null)
            difference = _described(_over_null(of, metric, name, end_s, is_null), bool(lacks))
            why = (lacks if is_null and not row["same_as"] else "") or control.not_tested
            baselines.append((name, "null" if is_null and not why else "reference", mean, count, difference, why))
        for (other, name), role in of.roles.items():
            if other == metric:
                its_values = of.table[metric, name]
                why = controls.lack(values, its_values) if role == "null" and not row["same_as"] else ""
                own = _paired(values - its_values) if role == "null" else None
                role = "reference" if why else role
                baselines.append(
                    (name, role, mean_of(its_values), len(known(its_values)), _described(own, bool(why)), why)
                )
        for name, role, mean, count, difference, why in baselines or [("", "", None, 0, None, control.not_tested)]:
            rows.append({**row, "null": name, "null_n": count, "null_mean": mean, "role": role, "not_tested": why})
            differences.append(difference)
    return _judged(rows, differences, "difference_lower", "difference_upper")


def compare(a: MeasuredSet, b: MeasuredSet, choices: Sequence[str] = ()) -> pandas.DataFrame:
    """The difference b - a of every metric that both sets have, in the order of `a`.

    Columns: those of differences.csv (docs/tables.md), `set_a`, `set_b`, the deviations and intervals of both means, and as in `summarize` role and
    conclusion. If both sets have the null that `controls` names, the answer is the difference over it, such as (b - its shadow) - (a - its shadow).
    The raw difference stands behind it: p values of these are corrected as a family of their own, which answers nothing. When species die out is
    compared up to the common end of both sets, by the log-rank test. Raises RunError for a choice that names no metric, and for sets without a
    common one.
    """
    both = [metric for metric in a.metrics() if _is_in(b, metric)]
    both += [metric for metric in b.metrics() if metric.metric in SURVIVAL and metric not in both and _is_in(a, metric)]
    if not both:
        raise RunError(f"{a.label} and {b.label}: have no metric in common")
    wanted = chosen(both, choices)
    repeats = repeated(wanted, [a, b, *a.nulls.values(), *b.nulls.values()])
    rows: list[dict[str, Any]] = []
    differences: list[Difference | None] = []
    for metric in wanted:
        end_s = _end_of(metric, a, b)
        row = {
            "set_a": a.label,
            "set_b": b.label,
            **metric._asdict(),
            **_estimated(a, metric, end_s, "_a"),
            **_estimated(b, metric, end_s, "_b"),
            "same_as": str(repeats.get(metric, "")),
        }
        null = controls.control_of(a, metric).null
        if null != controls.control_of(b, metric).null or metric.metric in SHARES + SURVIVAL:
            null = ""  # no exact test and no log-rank test compares two differences
        if null:
            why = "" if row["same_as"] else _lack(metric, a, b, a.nulls_of(metric)[null], b.nulls_of(metric)[null])
            over = _difference(metric, [*_over(a, metric, null, -1.0), *_over(b, metric, null)])
            if over.value is not None:
                role = "reference" if why else "null"
                rows.append({**row, "compared": f"over_{null}", "role": role, "not_tested": why})
                differences.append(_described(over, bool(why)))
        if metric.metric in SURVIVAL:
            why, raw = "", survival_difference(controls.lives_of(b, metric), controls.lives_of(a, metric), end_s)
        else:
            why = "" if row["same_as"] else _lack(metric, a, b)
            raw = _difference(metric, [(1.0, b.baseline(metric, "")), (-1.0, a.baseline(metric, ""))])
        role = "" if null else "reference" if why else "null"
        rows.append({**row, "compared": "raw", "role": role, "not_tested": why})
        differences.append(_described(raw, bool(why)))
    return _judged(rows, differences, "lower", "upper")


def _is_in(of: MeasuredSet, metric: Metric) -> bool:
    """Whether a set has a metric. If a species lives to the end of all runs, the set has none of when it dies out, and is compared all the same."""
    if (metric, "") in of.table:
        return True
    return metric.metric in SURVIVAL and metric.species in of.runs[0].manifest.get("species", [])


def _lack(metric: Metric, *sets: MeasuredSet) -> str:
    return "" if metric.metric in SURVIVAL else controls.lack(*(of.baseline(metric, "") for of in sets))


def _described(of: Difference | None, is_described: bool) -> Difference | None:
    """A difference that is not tested keeps its value alone."""
    return Difference(of.value) if of and is_described else of


def _end_of(metric: Metric, *sets: MeasuredSet) -> float:
    return common_end(*(controls.lives_of(of, metric) for of in sets)) if metric.metric in SURVIVAL else math.nan


def _estimated(of: MeasuredSet, metric: Metric, end_s: float, suffix: str = "") -> dict[str, Any]:
    """The number of runs, mean, deviation and interval; of a metric of SURVIVAL the restricted mean up to a common end."""
    values = of.baseline(metric, "")
    n, mean, deviation, interval = estimate(values)
    if metric.metric in SURVIVAL:
        lives = controls.lives_of(of, metric)
        survives = restricted_mean(lives, end_s)
        n, mean, deviation = len(lives.ends_s), survives and survives.value, None
        interval = interval_of(survives) if n >= MIN_RUNS_FOR_TEST else None
    elif metric.metric in SHARES:
        interval = share_interval(values)
    named = {
        "n": n,
        "mean": mean,
        "deviation": deviation,
        "lower": interval and interval.lower,
        "upper": interval and interval.upper,
    }
    return {name + suffix: value for name, value in named.items()}


def _over_null(of: MeasuredSet, metric: Metric, name: str, end_s: float, is_tested: bool) -> Difference:
    """The difference from a null of runs, without its test if another null answers."""
    if metric.metric in SURVIVAL:
        its = controls.lives_of(of.nulls_of(metric)[name], metric)
        found = survival_difference(controls.lives_of(of, metric), its, end_s)
    else:
        found = _difference(metric, _over(of, metric, name))
    return found if is_tested else dataclasses.replace(found, p=None)


def _over(of: MeasuredSet, metric: Metric, null: str, sign: float = 1.0) -> list[tuple[float, numpy.ndarray]]:
    """The difference of a set and a null, as weighted values of independent sets of runs."""
    values, its = of.baseline(metric, ""), of.null_values(metric, null)
    return [(sign, values - its)] if null == NEUTRAL else [(sign, values), (-sign, its)]


def _paired(differences: numpy.ndarray) -> Difference:
    return difference_of(mean_of(differences), contrast((1.0, differences)), scatter_of(differences))


def _difference(metric: Metric, terms: list[tuple[float, numpy.ndarray]]) -> Difference:
    if metric.metric in SHARES and [sign for sign, _ in terms] == [1.0, -1.0]:
        return share_difference(terms[0][1], terms[1][1])
    return difference_of(_sum(*terms), contrast(*terms), scatter_of(*(values for _, values in terms)))


def _sum(*terms: tuple[float, numpy.ndarray]) -> float | None:
    """The weighted sum of means; None if a set has no value."""
    total = 0.0
    for weight, values in terms:
        mean = mean_of(values)
        if mean is None:
            return None
        total += weight * mean
    return total


def _judged(
    rows: list[dict[str, Any]], differences: Sequence[Difference | None], lower: str, upper: str
) -> pandas.DataFrame:
    """The rows with their differences: corrects those with the role of a null that repeat no other, and concludes. Raw ones are a family apart."""
    for role in ("null", ""):
        adjust_together(
            one for row, one in zip(rows, differences) if one and row["role"] == role and not row["same_as"]
        )
    for row, one in zip(rows, differences):
        one = one or Difference()
        row.update(
            {
                "difference": one.value,
                lower: one.interval and one.interval.lower,
                upper: one.interval and one.interval.upper,
                "p": one.p,
                "p_holm": one.adjusted,
                "lower_corrected": one.corrected and one.corrected.lower,
                "upper_corrected": one.corrected and one.corrected.upper,
                "scatter": one.scatter and math.sqrt(one.scatter.variance),
                "freedom": one.scatter and one.scatter.freedom,
                "conclusion": _conclusion(row, one),
            }
        )
    frame = pandas.DataFrame(rows)
    texts = {
        "set",
        "set_a",
        "set_b",
        *METRIC,
        "null",
        "same_as",
        "role",
        "compared",
        "conclusion",
        "not_tested",
        "n",
        "n_a",
        "n_b",
        "null_n",
    }
    return frame.astype({column: float for column in frame.columns if column not in texts})


def _conclusion(row: dict[str, Any], difference: Difference) -> str:
    if row["role"] != "null":
        return "not compared"
    if row["same_as"]:
        return "same"
    if difference.adjusted is None:
        return "too few runs" if difference.interval is None else "not compared"
    return str(conclusions(difference.adjusted, difference.value))


def conclusions(p_holm: Any, difference: Any) -> numpy.ndarray:
    """The conclusions on tested comparisons: above, below or inconclusive. Arrays of corrected p values and of differences."""
    return numpy.where(
        numpy.asarray(p_holm, float) <= SIGNIFICANCE,
        numpy.where(numpy.asarray(difference, float) > 0.0, "above", "below"),
        "inconclusive",
    )


def metrics_of(frame: pandas.DataFrame) -> list[Metric]:
    """The metrics of a frame, in its order."""
    return [Metric(*name) for name in frame[METRIC].drop_duplicates().itertuples(index=False)]


def with_nulls(frame: pandas.DataFrame) -> pandas.DataFrame:
    """The rows of a frame of `summarize` next to a null, also one that is a reference; the first row of a metric without any, without its baseline."""
    key = ["set", *METRIC]
    is_null = (frame["role"] == "null") | frame["null"].isin(NULLS)
    has_null = frame.assign(is_null=is_null).groupby(key, sort=False)["is_null"].transform("any")
    table = frame[is_null | (~has_null & ~frame.duplicated(key))].copy()
    alone = ~is_null[table.index]
    table.loc[alone, "null"], table.loc[alone, "null_n"], table.loc[alone, "null_mean"] = "", 0, NAN
    return table


def count(frame: pandas.DataFrame) -> Count:
    """The size of a frame's family."""
    return Count(
        int((frame["p_holm"].notna() & (frame["role"] == "null")).sum()),
        int(frame["conclusion"].isin(("above", "below")).sum()),
    )


def runs_for_difference(frame: pandas.DataFrame, difference: float) -> list[tuple[Any, int | None]]:
    """The rows of the tested comparisons, each with the runs in each set by which a difference of this size, in the metric's unit, is found with 80 %
    power at the level of one comparison (Bonferroni); None if MOST_RUNS are too few. It is for the next study, whose smallest effect of interest is named
    before its runs: that of the runs at hand would say no more than their p value."""
    level = SIGNIFICANCE / max(1, count(frame).comparisons)
    rows = frame[frame["p_holm"].notna() & (frame["role"] == "null") & frame["scatter"].notna()]
    return [
        (row, runs_for_power(difference, Scatter(row.scatter**2, row.freedom), level)) for row in rows.itertuples()
    ]


def runs_of(row: Any) -> str:
    """The runs of a comparison: "10+10" of two sets, "10" if each run has a null of its own."""
    if hasattr(row, "compared"):
        return f"{row.n_a}+{row.n_b}"
    return f"{row.n}+{row.null_n}" if row.null in NULLS and row.null != NEUTRAL else str(min(row.n, row.null_n))


def too_few(of: MeasuredSet) -> list[str]:
    """A sentence for a set, and one for each of its nulls, of too few runs for a test."""
    return [
        f"too few runs for a test: {MIN_RUNS_FOR_TEST} are needed, {one.label} has {len(one.runs)}"
        for one in (of, *of.nulls.values())
        if len(one.runs) < MIN_RUNS_FOR_TEST
    ]


# Worlds whose numbers change


def living_sentences(of: MeasuredSet) -> list[str]:
    """Sentences about persistence and cycles in a set whose numbers change, with those of its nulls; none for any other set."""
    sentences = []
    for metric in of.metrics():
        values = known(of.table[metric, ""])
        nulls = {name: known(null.baseline(metric, "")) for name, null in of.nulls.items()}
        is_asked = (
            metric.metric == "cycles"
            or metric.species == "all"
            or any((its == 0.0).any() for its in (values, *nulls.values()))
        )
        if metric.metric not in ("persists", "cycles") or len(values) == 0 or not is_asked:
            continue
        who = "All species" if metric.species == "all" else _who(metric.species).capitalize()
        many, count = int(values.sum()), len(values)
        has_none = metric.metric == "cycles" and is_by_chance(int(values.sum()), len(values))
        beside = [
            f"{null_title(name)} {len(its) - int(its.sum()) if has_none else int(its.sum())} of {len(its)}"
            for name, its in nulls.items()
            if len(its)
        ]
        field = mean_of(of.baseline(metric, living.MEAN_FIELD))
        beside += [] if field is None else [f"mean field {1.0 - field if has_none else field:.2f}"]
        interval = share_interval(values)
        share = f"{many} of {count} runs" + (
            f", a share of [{interval.lower:.3f}, {interval.upper:.3f}]" if interval else ""
        )
        if metric.metric == "persists":
            text = f"{who} live to the end of {share}"
        elif has_none:
            text = f"{who} cycle in no more runs than by chance: red noise explains their numbers in {count - many} of {count} runs"
        else:
            period, amplitude = (
                estimate(of.baseline(Metric(name, *metric[1:3], unit), ""))
                for name, unit in (("period", "s"), ("amplitude", "1"))
            )
            text = f"{who} cycle in {share}, with a period of {_plain(period, 0, ' s')} and an amplitude of {_plain(amplitude, 2)} of their mean"
        sentences.append(f"{text} ({', '.join(beside)})." if beside else f"{text}.")
    return sentences


def _plain(of: Any, digits: int, unit: str = "") -> str:
    bounds = f" [{of.interval[0]:.{digits}f}, {of.interval[1]:.{digits}f}]" if of.interval else ""
    return f"{of.mean:.{digits}f}{unit}{bounds}"


# Findings

# The paper's questions: metric -> (place of its question, measure, how plain a reading of the measure it is).
_MEASURES = {
    "velocity": (0, "velocity", 0),
    "velocity_stored": (0, "velocity", 1),
    "velocity_points": (0, "velocity", 2),
    "attribution_credited": (1, "catches", 0),
    "attribution_catches": (1, "catches", 1),
    "attribution_catchers": (1, "catches", 2),
    "attribution_caught": (1, "caught", 0),
    "attribution_died": (1, "caught", 1),
    "wall_sticking": (2, "walls", 0),
    "wall_sticking_gap": (2, "walls gap", 0),
    "tag_symmetry": (3, "tags", 0),
}
_GROUPS = ("", "all", "inherited", "active", "inherited_active", "random", "inactive", "inherited_inactive")


def _fact(row: Any) -> tuple[str, str]:
    """Readings and groups of one measure of one species, next to any null, are one fact; what the inactive do is another."""
    return (
        _MEASURES.get(row.metric, (9, row.metric, 0))[1] + " of the inactive" * ("inactive" in row.group),
        row.species,
    )


def _plainness(row: Any) -> tuple:
    group = _GROUPS.index(row.group) if row.group in _GROUPS else len(_GROUPS)
    return _MEASURES.get(row.metric, (9, "", 0))[2], group, getattr(row, "null", SHADOW) not in NULLS


def facts(frame: pandas.DataFrame, conclusions: Sequence[str]) -> list[Any]:
    """The plainest row of each fact with one of these conclusions, the first of equally plain ones. A fact about all species is left out if it is
    one about a species."""
    plainest: dict[tuple[str, str], Any] = {}
    for row in frame[frame["conclusion"].isin(conclusions)].itertuples(index=False):
        fact = _fact(row)
        if fact not in plainest or _plainness(row) < _plainness(plainest[fact]):
            plainest[fact] = row
    measures = {measure for measure, species in plainest if species != "all"}
    return [row for (measure, species), row in plainest.items() if species != "all" or measure not in measures]


def findings(frame: pandas.DataFrame) -> list[Finding]:
    """The significant differences of a frame of `summarize` or `compare`: each fact once, in the words of its plainest row; velocity, attribution,
    walls and tags first, then by strength."""
    rows = facts(frame, ("above", "below"))
    rows.sort(
        key=lambda row: (
            _MEASURES.get(row.metric, (9,))[0],
            row.p,
            -abs(row.difference) / row.scatter if row.scatter > 0.0 else -math.inf,
        )
    )
    return [_finding(row) for row in rows]


def inconclusive(frame: pandas.DataFrame) -> list[Any]:
    """The plainest row of each fact that is not a finding, those of the smallest p value first. Inconclusive does not mean equal."""
    seen = {_fact(row) for row in facts(frame, ("above", "below"))}
    rows = [row for row in facts(frame, ("inconclusive",)) if _fact(row) not in seen]
    return sorted(rows, key=lambda row: row.p)


def interval_of_row(row: Any) -> tuple[float, float]:
    """The interval of a row's difference: of an answer that was corrected the one that holds for its family at once, else its own."""
    if row.lower_corrected == row.lower_corrected:
        return row.lower_corrected, row.upper_corrected
    return (row.lower, row.upper) if hasattr(row, "compared") else (row.difference_lower, row.difference_upper)


def _finding(row: Any) -> Finding:
    metric, interval = Metric(row.metric, row.species, row.group, row.unit), interval_of_row(row)
    if hasattr(row, "compared"):
        sentence = _difference_sentence(metric, row)
        return Finding(sentence, metric, row.compared, row.difference, interval, row.p_holm, "")
    return Finding(_sentence(metric, row), metric, row.null, row.difference, interval, row.p_holm, row.set)


# Words

_WHO = {"prey": "prey", "predator": "predators", "all": "robots", "": ""}
_NULLS = {
    **{name: f"in the {title}" for name, title in NULLS.items()},
    "permuted_tags": "with permuted tags",
    "drift": "under drift",
    "same_parents": "with the same parents, mated at random",
}
_NOUNS = {
    "velocity": "the velocity of {who} towards their adversaries",
    "velocity_stored": "the velocity of {who} towards their stored adversaries",
    "velocity_points": "the velocity of {who} towards their adversaries, every 200 s,",
    "attribution_credited": "the share of deaths of their prey that are credited to inherited {who}",
    "attribution_catches": "the share of catches that inherited {who} make",
    "attribution_catchers": "the share of the inherited among {who} that caught",
    "attribution_caught": "the share of the inherited among {who} that are caught",
    "attribution_died": "the share of the inherited among {who} that die",
    "wall_sticking": "the share of {who} within 1 m of a wall",
    "wall_sticking_gap": "the excess of {first} over {second} within 1 m of a wall",
    "tag_symmetry": "the tag symmetry of {who}",
    "population": "the number of {who}",
    "kinds_silhouette": "the silhouette of kinds of {who}",
    "kinds_gene_flow": "the gene flow between kinds of {who}",
    "hunger": "the hunger of {who}",
    "ticks_at": "the share of time with {group} {who}",
    "deaths": "the number of {who} that die in a run",
    "stuck": "the share of {who} that are stuck",
    "locked": "the share of {who} that are locked into another one",
    "near_pairs": "the number of pairs of {who} within 0.3 m",
    "near_longest": "the longest time that a pair of {who} stays within 0.3 m",
    "walked": "the speed of {who}",
    "open_speed": "the speed of {who} away from walls",
    "upright_speed": "the speed of upright {who} away from walls",
    "overturned": "the share of {who} that lie on their backs",
    "wall_contact": "the share of {who} that touch a wall",
    "persists": "the share of runs that {who} survive",
    "cycles": "the share of runs in which {who} cycle",
    "period": "the period of the cycle of {who}",
    "amplitude": "the relative amplitude of the cycle of {who}",
    "phase": "the phase between {who}",
    "birth_rate": "the birth rate of {who}",
    "generation_time": "the generation time of {who}",
    "parents": "the number of parents of {who}",
    "lineage_depth": "the depth of the lineages of {who}",
    "search_rate": "the search rate between {who}",
    "search_rate_holling": "the search rate between {who} of type II",
    "handling_time": "the handling time between {who}",
    "stock": "the stock of energy of {who}",
    "trophic_efficiency": "the trophic efficiency of {who}",
    "pyramid_numbers": "the pyramid of numbers of {who}",
    "pyramid_energy": "the pyramid of energy of {who}",
    "extinct": "the share of runs in which {who} die out",
    "extinct_at": "the mean time that {who} last, up to the common end of the runs,",
}
_CAUSES = {
    "caught": "are caught",
    "starved": "starve",
    "sacrificed": "are sacrificed",
    "senescence": "die of senescence",
}


def _who(species: str) -> str:
    """The members of a species: "predators", "wolf individuals"."""
    return _WHO.get(species, species if species.endswith("s") else f"{species} individuals")


def noun_of(metric: Metric) -> str:
    """The metric as the subject of a sentence: "the velocity of inherited prey towards their adversaries"."""
    name, species, group, _ = metric
    who = " and ".join(_who(one) for one in species.split("+"))
    if group in _GROUPS[2:]:
        who = f"{group.replace('_', ' ')} {who}"
    if name in _NOUNS:
        first, _, second = (_who(one) for one in species.partition("-"))
        noun = _NOUNS[name].format(who=who, group=group, first=first, second=second)
        if name == "deaths" and group != "all":
            return f"the number of {who} that {_CAUSES.get(group, f'die ({group})')} in a run"
        return noun + (
            f" ({group})" if group in ("early", "late") or name == "wall_sticking_gap" and group != "all" else ""
        )
    noun = name.replace("_", " ") + (f" of {who}" if who else "")
    return noun + (f" ({group})" if group not in _GROUPS else "")


def _magnitude(metric: Metric, effect: float, lower: float, upper: float) -> tuple[str, str]:
    """An effect and its interval without their sign: "0.45 cm/s", "[0.30, 0.60]"."""
    low, high = (lower, upper) if effect >= 0.0 else (-upper, -lower)
    middle, _, interval = Reading(metric).with_interval(abs(effect), (low, high)).partition(" ")
    return f"{middle}{_unit(metric)}", interval


def _amount(metric: Metric, value: float) -> str:
    return f"{Reading(metric)(value)}{_unit(metric)}"


def _unit(metric: Metric) -> str:
    unit = "ticks" if metric.unit == "ticks" else Reading(metric).unit
    return f" {unit}" if unit else ""


def _sentence(metric: Metric, row: Any) -> str:
    size, interval = _magnitude(metric, row.difference, *interval_of_row(row))
    test = f"{interval} (p {p_text(row.p_holm)}, {runs_of(row)} runs)."
    null = _NULLS.get(row.null, f"in its null, {row.null.replace('_', ' ')},")
    if metric.metric.startswith("velocity") and metric.species in ("prey", "predator"):
        other = "predators" if metric.species == "prey" else "prey"
        whom = _who(metric.species)
        whom = whom if metric.group == "all" else f"{metric.group.replace('_', ' ')} {whom}"
        begin = f"{whom.capitalize()} move {'towards' if row.mean >= 0.0 else 'away from'} {other} at {_amount(metric, abs(row.mean))}"
        if row.mean * row.null_mean >= 0.0:
            return f"{begin}, {size} {'faster' if abs(row.mean) >= abs(row.null_mean) else 'slower'} than {null} {test}"
        back = "towards" if row.null_mean >= 0.0 else "away from"
        return f"{begin}; {null} they move {back} them at {_amount(metric, abs(row.null_mean))}: a difference of {size} {test}"
    noun = noun_of(metric)
    return f"{noun[0].upper()}{noun[1:]} is {_amount(metric, row.mean)}, {size} {'higher' if row.difference > 0.0 else 'lower'} than {null} {test}"


def _difference_sentence(metric: Metric, row: Any) -> str:
    size, interval = _magnitude(metric, row.difference, *interval_of_row(row))
    noun = noun_of(metric)
    over = "" if row.compared == "raw" else f", each {over_text(row.compared).replace('the', 'its')}"
    side = "higher" if row.difference > 0.0 else "lower"
    return (
        f"{noun[0].upper()}{noun[1:]} is {size} {side} in runs of {row.set_b} than in runs of {row.set_a}{over} {interval} "
        f"(p {p_text(row.p_holm)}, {runs_of(row)} runs)."
    )
