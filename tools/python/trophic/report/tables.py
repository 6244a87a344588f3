# SPDX-License-Identifier: MIT
"""Results for machines: metrics.csv, means.csv, differences.csv and summary.json."""
from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy
import pandas

from .. import __version__, controls, judge, published
from ..statistics import MIN_RUNS_FOR_TEST, is_significant, survival
from ..values import METRIC, NEUTRAL, ONE_SIDED, SHADOW, MeasuredSet
from ..writing import without_nan
from .columns import names


# Tables


def metrics(sets: Sequence[MeasuredSet]) -> pandas.DataFrame:
    """metrics.csv: every value and every curve of every run, one value a row. The nulls' own baselines are left out: they say nothing about the
    set."""
    parts = []
    for one in sets:
        for of, null in ((one, ""), *((its, name) for name, its in one.nulls.items())):
            for run, measured in zip(of.runs, of.values):
                rows = pandas.concat([part for part in (measured.values, measured.curves) if len(part)]).reset_index(
                    drop=True
                )
                if null:
                    rows = rows[rows["baseline"] == ""].assign(baseline=null)
                rows = rows.assign(set=one.label, run=run.path.resolve().name, seed=run.seed)
                parts.append(rows.reindex(columns=names("metrics.csv")))
    frame = pandas.concat(parts, ignore_index=True)
    return frame.astype({"time_s": float, "value": float, "seed": "uint64"})


def means(frame: pandas.DataFrame) -> pandas.DataFrame:
    """means.csv of a frame of judge.summarize, or of several below each other: each metric next to each of its nulls, one row each; one row for a
    metric without a null."""
    table = judge.with_nulls(frame)
    return table[names("means.csv")].reset_index(drop=True)


def differences(frame: pandas.DataFrame) -> pandas.DataFrame:
    """differences.csv of a frame of judge.compare."""
    return frame[names("differences.csv")].reset_index(drop=True)


def survivals(of: MeasuredSet) -> pandas.DataFrame:
    """survival.csv: of a set whose numbers change and of its nulls each species' survival; empty for any other set."""
    rows: list[tuple] = []
    for null, one in (("", of), *of.nulls.items()):
        for (metric, baseline), values in one.table.items():
            if (metric.metric, baseline) == ("extinct_at", "") and (
                metric._replace(metric="persists", unit="1"),
                "",
            ) in one.table:
                ends = [getattr(run, "lived_s", one.until_s) for run in one.runs]
                died = ~numpy.isnan(values)
                rows += [
                    (of.label, null, metric.species, *row) for row in survival(numpy.where(died, values, ends), died)
                ]
    return pandas.DataFrame(rows, columns=names("survival.csv"))


# summary.json


def summary(
    sets: Sequence[MeasuredSet], frames: Sequence[pandas.DataFrame], compared: pandas.DataFrame | None = None
) -> dict[str, Any]:
    """summary.json: each set with its runs, means, every baseline, the size of its family and its findings; of two sets their differences. The
    top's `family` and `findings` answer what was asked: of one set its own, of two sets those of their differences. null is what could not be
    computed."""
    answer = frames[0] if compared is None else compared
    content: dict[str, Any] = {
        "trophic": __version__,
        "family": _family(answer),
        "findings": _findings(answer),
        "sets": [_set(of, frame) for of, frame in zip(sets, frames)],
    }
    if compared is not None:
        content["differences"] = [_difference(rows) for rows in _by_metric(compared)]
    return without_nan(content)


def _family(frame: pandas.DataFrame) -> dict[str, Any]:
    size = judge.count(frame)
    return {**size._asdict(), "sentence": size.sentence()}


def finding(one: judge.Finding) -> dict[str, Any]:
    """As summary.json has it."""
    return {
        "sentence": one.sentence,
        **one.metric._asdict(),
        "baseline": one.baseline,
        "effect": one.effect,
        "lower": one.interval[0],
        "upper": one.interval[1],
        "p_holm": one.p_holm,
    }


def _findings(frame: pandas.DataFrame) -> list[dict[str, Any]]:
    return [finding(one) for one in judge.findings(frame)]


def _set(of: MeasuredSet, frame: pandas.DataFrame) -> dict[str, Any]:
    from ..description import describe

    said = describe(of)
    return {
        "set": of.label,
        "description": said.sentence(),
        "backend": said.engine,
        "fingerprint": of.runs[0].fingerprint,
        "identity": said.identity,
        "min_runs_for_test": MIN_RUNS_FOR_TEST,
        "family": _family(frame),
        "findings": _findings(frame),
        "runs": _runs(of),
        **{
            f"{name}_runs": _runs(of.nulls[name]) if name in of.nulls else []
            for name in {SHADOW: 0, NEUTRAL: 0, **of.nulls}
        },
        "controls": controls.sentences(of, judge.metrics_of(frame)),
        "metrics": [_metric(rows) for rows in _by_metric(frame)],
        "answers": [_answer(one) for one in published.answers(of, frame)],
        "claims": _claims(of) if published.applies_to(of) else [],
        **({"living": sentences} if (sentences := judge.living_sentences(of)) else {}),
        "remarks": [remark for one in (of, *of.nulls.values()) for remark in one.remarks],
    }


def _runs(of: MeasuredSet) -> list[dict[str, Any]]:
    return [
        {
            "folder": os.path.abspath(run.path),
            "seed": run.seed,
            "status": run.manifest["status"],
            "builds": run.builds,
            "half_side_m": run.manifest.get("arena", {}).get("half_side_m"),
            "until_s": of.until_s,
            "lived_s": getattr(run, "lived_s", of.until_s),
        }
        for run in of.runs
    ]


def _test(row: Any) -> dict[str, Any]:
    tested = row.p_holm == row.p_holm and row.role == "null"
    return {
        "p": row.p,
        "p_adjusted": row.p_holm,
        "differs": is_significant(row.p_holm) if tested else None,
        "lower_corrected": row.lower_corrected,
        "upper_corrected": row.upper_corrected,
        "scatter": row.scatter,
        "not_tested": row.not_tested or None,
    }


def _by_metric(frame: pandas.DataFrame) -> list[list[Any]]:
    """The rows of each metric, as tuples, whose type takes longer to make than all of its rows."""
    of: dict[tuple, list[Any]] = {}
    for row in frame.itertuples(index=False):
        of.setdefault(tuple(getattr(row, name) for name in METRIC), []).append(row)
    return list(of.values())


def _metric(rows: Sequence[Any]) -> dict[str, Any]:
    first = rows[0]
    baselines = [
        {
            "name": row.null,
            "role": row.role,
            "value": row.null_mean,
            "runs": row.null_n,
            "difference": row.difference,
            "lower": row.difference_lower,
            "upper": row.difference_upper,
            **_test(row),
            "conclusion": row.conclusion if row.role == "null" else None,
        }
        for row in rows
        if row.null
    ]
    return {
        **{name: getattr(first, name) for name in METRIC},
        "runs": first.n,
        "mean": first.mean,
        "deviation": first.deviation,
        "lower": first.lower,
        "upper": first.upper,
        "same_as": first.same_as or None,
        "published": first.published,
        "baselines": baselines,
    }


def _difference(rows: Sequence[Any]) -> dict[str, Any]:
    parts = {row.compared: row for row in rows}
    raw = parts["raw"]
    nothing = {
        "value": None,
        "lower": None,
        "upper": None,
        "p": None,
        "p_adjusted": None,
        "differs": None,
        "lower_corrected": None,
        "upper_corrected": None,
        "scatter": None,
        "not_tested": None,
        "conclusion": None,
    }
    return {
        **{name: getattr(raw, name) for name in METRIC},
        "same_as": raw.same_as or None,
        **{
            side: {
                "runs": getattr(raw, f"n_{side}"),
                **{name: getattr(raw, f"{name}_{side}") for name in ("mean", "deviation", "lower", "upper")},
            }
            for side in "ab"
        },
        **{
            kind: {
                "value": row.difference,
                "lower": row.lower,
                "upper": row.upper,
                **_test(row),
                "conclusion": row.conclusion,
            }
            if (row := parts.get(kind))
            else nothing
            for kind in ("raw", f"over_{SHADOW}", f"over_{ONE_SIDED}", f"over_{NEUTRAL}")
        },
    }


def _answer(one: published.Answer) -> dict[str, Any]:
    effects = [
        {
            **each.reading.metric._asdict(),
            "members": each.reading.members,
            "counting": each.reading.counting,
            "null": each.null,
            "difference": each.difference.value,
            **(each.difference.interval._asdict() if each.difference.interval else {}),
            "p": each.difference.p,
            "p_adjusted": each.difference.adjusted,
            "lower_corrected": each.difference.corrected and each.difference.corrected.lower,
            "upper_corrected": each.difference.corrected and each.difference.corrected.upper,
            "conclusion": each.conclusion,
        }
        for each in one.effects
    ]
    return {
        "question": one.question.text,
        "answer": str(one),
        "shown": one.effects.index(one.shown),
        "readings": effects,
    }


def _claims(of: MeasuredSet) -> list[dict[str, Any]]:
    return [
        {
            "claim": claim.claim.title,
            "summary": published.summary_of(claim),
            "readings": [_reading(each) for each in claim.readings],
        }
        for claim in published.judge_claims(of)
    ]


def _reading(each: published.ReadingConclusion) -> dict[str, Any]:
    lower, upper = each.interval or (None, None)
    ours = each.ours.interval or (None, None)
    return {
        **each.reading.metric._asdict(),
        "members": each.reading.members,
        "counting": each.reading.counting,
        "published": each.reading.value,
        "source": each.reading.source,
        "margin": published.margin_of(each.reading),
        "margin_from": each.reading.spread and each.reading.spread.origin,
        "runs": each.ours.runs,
        "mean": each.ours.mean,
        "deviation": each.ours.deviation,
        "lower": ours[0],
        "upper": ours[1],
        "difference": each.difference,
        "difference_lower": lower,
        "difference_upper": upper,
        "conclusion": each.conclusion,
    }
