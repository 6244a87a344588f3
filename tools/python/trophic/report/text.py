# SPDX-License-Identifier: MIT
"""Results for people, on the terminal."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pandas

from .. import controls, judge, published
from ..description import describe
from ..statistics import Estimate, Interval, mean_of
from ..values import CLONES, MeasuredSet, Metric
from ..words import (
    NULLS,
    Reading,
    columns,
    metric_title,
    null_title,
    number_text,
    over_nulls,
    over_text,
    p_text,
    runs_text,
)

MOST_INCONCLUSIVE = 3
_INCONCLUSIVE = "inconclusive does not mean equal: all differences in the interval remain possible\n"
_AT_ONCE = "intervals of corrected comparisons hold for all of them at once (Bonferroni), others individually\n"
_UNATTRIBUTED = "without its control in both sets no difference can be attributed to inheritance\n"


def estimate_of(row: Any, side: str = "") -> Estimate:
    """The mean of a row of a judge's frame; side: "", "_a" or "_b"."""
    n, mean, deviation, lower, upper = (
        getattr(row, name + side) for name in ("n", "mean", "deviation", "lower", "upper")
    )
    return Estimate(n, mean, deviation, Interval(lower, upper) if lower == lower else None)


def _metric(row: Any) -> Metric:
    return Metric(row.metric, row.species, row.group, row.unit)


def described(of: MeasuredSet) -> str:
    """ "LABEL on ENGINE, N runs of T s"."""
    said = describe(of)
    length = said.length()
    return f"{of.label} on {said.engine}, {length[0].lower()}{length[1:]}"


def _rules(of: MeasuredSet) -> str:
    """A line with what differs from the rule table, if anything does."""
    said = describe(of)
    return f"rules: {said.rules}\n" if said.label != said.table else ""


def _heading(of: MeasuredSet, frame: pandas.DataFrame) -> str:
    text = f"{described(of)}, fingerprint {describe(of).identity}\n{_rules(of)}"
    if (locked := mean_of(of.table.get((Metric("locked", "all", "all", "1"), ""), ()))) is not None:
        text += f"locked: {locked:.3f} of robots are within 0.3 m of another for 12 s or longer; --all prints the metrics without them\n"
    text += "".join(f"{null_title(name)}: {described(null)}\n" for name, null in of.nulls.items())
    text += "".join(f"{sentence}\n" for sentence in judge.living_sentences(of))
    return text + "".join(f"{sentence}\n" for sentence in controls.sentences(of, judge.metrics_of(frame)))


def _too_few(*sets: MeasuredSet) -> str:
    return "".join(sentence + "\n" for of in sets for sentence in judge.too_few(of))


def _conclusion(row: Any) -> str:
    """ "above", "below" or "inconclusive"; of what is not tested only that."""
    if row.conclusion in ("above", "below", "inconclusive"):
        return row.conclusion
    return "not tested" if row.not_tested and row.null != CLONES else ""


def findings_text(frame: pandas.DataFrame, most: int | None = None) -> str:
    """How many comparisons are significant, and each finding in a sentence; at most the first `most`."""
    found = judge.findings(frame)
    text = judge.count(frame).sentence() + "\n" + "".join(f"  {finding.sentence}\n" for finding in found[:most])
    return text + (
        f"  and {len(found) - most} more findings (--all)\n" if most is not None and len(found) > most else ""
    )


def answers_of(of: MeasuredSet, frame: pandas.DataFrame) -> list[list[str]]:
    """The paper's questions about evolution, each with its answer, the plainest reading's effect, the number of readings and the null."""
    rows = []
    for one in published.answers(of, frame):
        reading, difference = Reading(one.shown.reading.metric), one.shown.difference
        effect = reading.with_interval(difference.value, difference.corrected, True) + f" {reading.unit}" * bool(
            reading.unit
        )
        count = f"{len(one.effects)} reading{'s' * (len(one.effects) > 1)}"
        rows.append([one.question.text, str(one), effect, count, f"over the {null_title(one.shown.null)}"])
    return rows


def _answers(of: MeasuredSet, frame: pandas.DataFrame) -> str:
    rows = answers_of(of, frame)
    return (
        "The paper's questions; an answer must hold under every reading of the text, corrected for all comparisons (undecided: under none):\n"
        + columns(rows, "  ")
        if rows
        else ""
    )


def _inconclusive(frame: pandas.DataFrame, head: Sequence[str], cells: Any) -> str:
    """The inconclusive facts of the smallest p values; `cells` gives those of a row in front of p."""
    rows = judge.inconclusive(frame)
    if not rows:
        return ""
    lines = [["inconclusive", *head, "p"]]
    lines += [[metric_title(_metric(row)), *cells(row), p_text(row.p_holm)] for row in rows[:MOST_INCONCLUSIVE]]
    more = f"  and {len(rows) - MOST_INCONCLUSIVE} more (--all)\n" if len(rows) > MOST_INCONCLUSIVE else ""
    return columns(lines, "  ") + more + _INCONCLUSIVE


_HEAD = ["ours [95 %]", "null", "its mean", "runs", "ours - null [95 %]"]


def _cells(row: Any) -> list[str]:
    """What _HEAD names."""
    reading = Reading(_metric(row))
    return [
        reading.of(estimate_of(row)),
        NULLS.get(row.null, row.null),
        reading(row.null_mean),
        judge.runs_of(row),
        reading.with_interval(row.difference, judge.interval_of_row(row), True),
    ]


def _own(of: MeasuredSet, frame: pandas.DataFrame) -> str:
    """The metrics of one's own with their nulls, whatever their p; none without one."""
    rows = [row for row in frame.itertuples(index=False) if row.metric in of.own and row.role in ("null", "")]
    lines = [["yours", *_HEAD, "p", ""]]
    for row in rows:
        tested = _cells(row) if row.role else [Reading(_metric(row)).of(estimate_of(row)), "", "", "", ""]
        lines.append([metric_title(_metric(row)), *tested, p_text(row.p_holm) if row.role else "", _conclusion(row)])
    return columns(lines, "  ") if rows else ""


def findings(of: MeasuredSet, frame: pandas.DataFrame) -> str:
    """The metrics of one's own, the findings about a set, then the inconclusive comparisons of the smallest p values. The whole table if the set has no
    null of runs or nothing was tested."""
    if not of.nulls or judge.count(frame).comparisons == 0:
        return table(of, frame)
    return (
        _own(of, frame)
        + _heading(of, frame)
        + _answers(of, frame)
        + findings_text(frame, judge.MOST_FINDINGS)
        + _inconclusive(frame, _HEAD, _cells)
        + _too_few(of)
    )


def table(of: MeasuredSet, frame: pandas.DataFrame) -> str:
    """The whole table. One line for each metric: ours with its 95 % interval over runs (or its spread, if runs are too few) and the paper's value.
    Below it one line for each null with the difference and its test, and one for each reference without; causes from which no individual died
    are left out. The findings stand behind it."""
    has_published = bool(frame["published"].notna().any())
    lines = [
        ["metric", "ours [95 %]", *(["published"] if has_published else []), "ours - null [95 %]", "p", "conclusion"]
    ]
    gap = [""] * has_published
    last = None
    for row in frame.itertuples(index=False):
        metric, reading = _metric(row), Reading(_metric(row))
        if metric.metric == "deaths" and metric.group != "all" and row.mean == 0.0:
            continue
        if metric != last:
            note = f"tested as {_title_of(frame, row.same_as)}" if row.same_as else ""
            if 0 < row.n < len(of.runs):
                note = f"({row.n} of {len(of.runs)} runs)"
            its = [reading(row.published) if row.published == row.published else "-"] if has_published else []
            lines.append([metric_title(metric), reading.of(estimate_of(row)), *its, "", "", note])
        last = metric
        if not row.null:
            continue
        line = [
            f"    {'*' if row.role == 'paper' else '=' if row.role == 'null' else ' '} {NULLS.get(row.null, row.null)}",
            reading(row.null_mean),
        ]
        if row.role == "null" or row.null in NULLS:
            line += [
                *gap,
                reading.with_interval(row.difference, judge.interval_of_row(row), True),
                p_text(row.p_holm),
                _conclusion(row),
            ]
        lines.append(line)
    size = judge.count(frame)
    return _heading(of, frame) + columns(
        lines
    ) + "= null model: what the rules give without the effect   * the paper's own baseline, shown for reference and not tested\n" f"p: corrected for {size.comparisons} comparisons (Holm); {_AT_ONCE}" + _answers(
        of, frame
    ) + (
        findings_text(frame) if size.comparisons else ""
    ) + _too_few(
        of
    )


def _title_of(frame: pandas.DataFrame, choice: str) -> str:
    metric, species, group = choice.split(":", 2)
    unit = frame.loc[(frame["metric"] == metric) & (frame["species"] == species) & (frame["group"] == group), "unit"]
    return metric_title(Metric(metric, species, group, unit.iloc[0]))


def _sets(a: MeasuredSet, b: MeasuredSet) -> str:
    return "".join(
        f"{letter}: {described(of)}{''.join(f'; {null_title(name)}: {len(null.runs)} runs' for name, null in of.nulls.items())}\n{_rules(of)}"
        for letter, of in (("a", a), ("b", b))
    )


def _not_tested(frame: pandas.DataFrame) -> str:
    """How many metrics of a comparison are described alone, if any are."""
    many = int((frame["role"] == "reference").sum())
    return (
        f"not tested: {many} metric{'s' * (many > 1)} that some runs lack; means over the runs in which something happened are described (--all)\n"
        * bool(many)
    )


def difference_findings(a: MeasuredSet, b: MeasuredSet, frame: pandas.DataFrame) -> str:
    """The findings of a comparison, then the inconclusive differences of the smallest p values."""
    over, short, shown = over_nulls(frame["compared"])

    def cells(row: Any) -> list[str]:
        reading = Reading(_metric(row))
        return [
            reading(row.mean_a),
            reading(row.mean_b),
            judge.runs_of(row),
            reading.with_interval(row.difference, judge.interval_of_row(row), True),
        ]

    about = (
        f"the answer is the difference {over}: {shown}. Raw differences, which the rules alone can cause, are shown by --all\n"
        if over
        else f"the differences are raw: {_UNATTRIBUTED}"
    )
    head = ["a", "b", "runs", (short or "b - a") + " [95 %]"]
    return (
        _sets(a, b)
        + about
        + _not_tested(frame)
        + findings_text(frame, judge.MOST_FINDINGS)
        + _inconclusive(frame, head, cells)
        + _too_few(a, b)
    )


def difference_table(a: MeasuredSet, b: MeasuredSet, frame: pandas.DataFrame) -> str:
    """The whole comparison. One line for each metric: a, b, b - a with its 95 % interval and, as the answer with its test, what each has over its
    null; without a null of both the raw difference is the answer."""
    over, short, shown = over_nulls(frame["compared"])
    lines = [["metric", "a", "b", "raw: b - a [95 %]", *([f"{over} [95 %]"] if over else []), "p", ""]]
    rows = list(frame.itertuples(index=False))
    answers = {_metric(row): row for row in rows if row.compared != "raw" or row.role != ""}
    for row in rows:
        if row.compared != "raw" or (row.metric == "deaths" and row.mean_a == row.mean_b == 0.0):
            continue
        reading, answer = Reading(_metric(row)), answers.get(_metric(row))
        line = [metric_title(_metric(row)), reading(row.mean_a), reading(row.mean_b)]
        line.append(reading.with_interval(row.difference, judge.interval_of_row(row), True))
        if over:
            line.append(
                reading.with_interval(answer.difference, judge.interval_of_row(answer), True) if answer else "missing"
            )
        note = f"tested as {_title_of(frame, row.same_as)}" if row.same_as else ""
        if answer and not note:
            note = "*" if answer.conclusion in ("above", "below") else "not tested" if answer.not_tested else ""
        lines.append([*line, p_text(answer.p_holm) if answer else "", note])
    about = f"those {short} are the answer: {shown}\n" if over else _UNATTRIBUTED
    return _sets(a, b) + columns(
        lines
    ) + f"p: corrected for {judge.count(frame).comparisons} comparisons (Holm); * significant, p <= 0.05; {_AT_ONCE}" f"raw differences also reflect the composition of the populations; {about}" + findings_text(
        frame
    ) + _too_few(
        a, b
    )


def runs_for(frame: pandas.DataFrame, difference: float) -> str:
    """A line for each tested comparison: how many runs a difference of a size would need."""
    text = "".join(
        f"a difference of {Reading(_metric(row))(difference)} in {metric_title(_metric(row))}"
        f"{' ' + over_text(getattr(row, 'compared', '')) if hasattr(row, 'compared') else f' over the {null_title(row.null)}'} needs "
        f"{runs_text(runs)} runs in each set for 80 % power\n"
        for row, runs in judge.runs_for_difference(frame, difference)
    )
    return (
        text
        and text
        + f"at the level of one of {judge.count(frame).comparisons} comparisons; based on the variance of these runs\n"
    )


def claims(of: MeasuredSet) -> str:
    """For each published claim one line that says under which readings it is reproduced, then one line for each reading: the published value, the
    margin and its origin, ours and the difference with 95 % intervals, the conclusion.
    """
    lines = [
        [
            "claim and its readings",
            "published",
            "",
            "margin",
            "margin from",
            "ours [95 %]",
            "ours - published [95 %]",
            "conclusion",
        ]
    ]
    for claim in published.judge_claims(of):
        lines.append([f"{claim.claim.title}: {published.summary_of(claim)}"])
        lines += [_claim_line(each) for each in claim.readings]
    said = describe(of)
    text = f"{described(of)}, fingerprint {said.identity}\n{_what_was_published(of)}\n{columns(lines)}"
    text += (
        "reproduced: two one-sided tests at 5 % place ours within the margin of the published system\n"
        "not reproduced: they do not, and ours - published is not 0 at 5 %   inconclusive: neither\n"
        "margin: one standard deviation between runs. The published mean is one of ten runs; its error is in the interval\n"
        "published: text: in the paper; logs: counted from the event logs of its ten runs\n"
        "The paper does not say whether inactive prey count. Leaving them out (active) is an inference: the authors' log marks them.\n"
        "Each reading is tested alone: a claim with more readings is more easily reproduced under one of them.\n"
    )
    if min(of.until_s, said.lived_s[1]) != published.DURATION_S:
        text += f"the claims concern runs of {number_text(published.DURATION_S)} s; counts of deaths in runs of other lengths are not comparable (--until)\n"
    return text + _too_few(of)


def _claim_line(each: published.ReadingConclusion) -> list[str]:
    reading, margin = Reading(each.reading.metric), published.margin_of(each.reading)
    return [
        f"  {metric_title(each.reading.metric)}",
        reading(each.reading.value),
        each.reading.source,
        "-" if margin is None else reading(margin),
        each.reading.spread.origin if each.reading.spread else "unknown",
        reading.of(each.ours),
        reading.with_interval(each.difference, each.interval, True),
        each.conclusion,
    ]


def _what_was_published(of: MeasuredSet) -> str:
    """The published system, and how this set differs from it."""
    said = describe(of)
    text = f"published: ten runs of `released` with bodies in MuJoCo, {number_text(published.DURATION_S)} s"
    if said.engine.startswith("kinematic"):
        text += "; these are points without bodies, so velocities and wall-following compare only the rules"
    if said.label == "released" and said.engine.startswith("mujoco"):
        return text + ", as here"
    return (
        text
        if said.engine.startswith("kinematic") and published.applies_to(of)
        else f"{text}; here: {said.label} on {said.engine}"
    )
