# SPDX-License-Identifier: MIT
"""`trophic cross-check`: what depends on the engine, by two one-sided tests of equivalence of the metrics of two sets of runs, as two cells of a sweep
over engines."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy
import pandas

from . import pool
from .errors import RunError, printable
from .report.columns import names
from .statistics import EquivalenceTest, contrast, estimate, test_equivalence
from .values import MeasuredSet
from .words import Reading, columns, metric_title, number_text
from .writing import csv_text, result_folder, write_new

MARGINS = {
    ("attribution_caught", "all"): 0.05,
    ("attribution_catches", "all"): 0.05,
    ("attribution_catchers", "all"): 0.05,
    ("velocity", "all"): 0.005,
    ("velocity", "inherited"): 0.005,
    ("velocity", "random"): 0.005,
    ("wall_sticking", "all"): 0.1,
    ("wall_sticking_gap", "all"): 0.1,
    ("tag_symmetry", "inherited"): 0.05,
    ("deaths", "all"): 0.2,
}
"""The difference of a metric and group between engines that would still leave the paper's conclusion alone: shares by 0.05 and wall sticking by 0.1, a
fraction of what separates the published values from their baselines; velocities by 0.5 cm/s; deaths by this share of the first set's."""
SHARES_OF_FIRST = ("deaths",)
_TABLE = "cross_check.csv"


def run(request: dict) -> int:
    """Compares the two sets of `runs`, writes cross_check.csv into the new folder `out` and prints it."""
    if len(request["runs"]) != 2:
        raise RunError("runs: needs 2 values")
    with result_folder(request["out"], name="cross-check") as folder:
        sets = [pool.read_set([path]) for path in request["runs"]]
        pool.check_apart(*(of.runs for of in sets))
        check(*sets)
        found = list(metrics(*sets))
        write_new(
            folder / _TABLE, csv_text(pandas.DataFrame([row for pair in found for row in pair], columns=names(_TABLE)))
        )
    print(metrics_text(sets, found) + f"files   {printable(str(folder.with_suffix('')))}")
    return 0


def _row(
    engine: str,
    quantity: str,
    unit: str,
    values: Sequence[float] | numpy.ndarray,
    test: EquivalenceTest | None,
    **more: Any,
) -> dict[str, Any]:
    ours = estimate(values)
    lower, upper = ours.interval or (None, None)
    row = {
        "engine": engine,
        "quantity": quantity,
        "unit": unit,
        "mean": ours.mean,
        "lower": lower,
        "upper": upper,
        "n": ours.runs,
        **more,
    }
    if test is not None:
        lower, upper = test.interval or (None, None)
        row |= {
            "margin": test.margin,
            "difference": test.difference,
            "difference_lower": lower,
            "difference_upper": upper,
            "conclusion": test.conclusion,
        }
    return row


def metrics(first: MeasuredSet, second: MeasuredSet) -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
    """Yields the rows of each metric with a margin, of the first set and of the second."""
    for metric in first.metrics():
        margin = MARGINS.get((metric.metric, metric.group))
        if margin is None:
            continue
        values = [of.baseline(metric, "") for of in (first, second)]
        if metric.metric in SHARES_OF_FIRST:
            margin *= max(1.0, estimate(values[0]).mean or 1.0)
        test = test_equivalence(contrast((-1.0, values[0]), (1.0, values[1])), margin)
        one, other = (
            _row(
                str(of.runs[0].manifest["backend"]),
                metric.metric,
                metric.unit,
                its,
                tested,
                species=metric.species,
                group=metric.group,
            )
            for of, its, tested in ((first, values[0], None), (second, values[1], test))
        )
        yield one, other


def check(first: MeasuredSet, second: MeasuredSet) -> None:
    """Raises RunError if rules, parameters other than the engine's, or durations of two sets differ."""
    a, b = (of.runs[0] for of in (first, second))

    def ecology(manifest: dict) -> dict:
        params = {key: value for key, value in manifest["params"].items() if key not in ("seed", "physics", "backend")}
        if "ecology" in params:
            params["ecology"] = {key: value for key, value in params["ecology"].items() if key != "duration_s"}
        return {"rule_table": manifest["rule_table"], "rules": manifest["rules"], "params": params}

    if why := pool.first_difference(ecology(a.manifest), ecology(b.manifest)):
        raise RunError(f"{b.path}: {why} as in {a.path}")
    if not pool.lasted_alike(a, b):  # type: ignore[arg-type]
        raise RunError(f"{b.path}: {pool.lasted_text(b)}: must have {pool.lasted_text(a)}, as in {a.path}")  # type: ignore[arg-type]


def metrics_text(sets: Sequence[MeasuredSet], found: Sequence[tuple[dict[str, Any], dict[str, Any]]]) -> str:
    """A line for each metric."""
    lines: list[tuple[str, ...]] = [
        ("metric", "first [95 %]", "second [95 %]", "margin", "difference [90 %]", "conclusion")
    ]
    by_title = {(metric.metric, metric.species, metric.group): metric for metric in sets[0].metrics()}
    for one, other in found:
        metric = by_title[one["quantity"], one["species"], one["group"]]
        reading = Reading(metric)
        lines.append(
            (
                metric_title(metric),
                *(
                    reading.with_interval(row["mean"], None if row["lower"] is None else (row["lower"], row["upper"]))
                    for row in (one, other)
                ),
                reading(other["margin"]),
                reading.with_interval(
                    other["difference"],
                    None
                    if other["difference_lower"] is None
                    else (other["difference_lower"], other["difference_upper"]),
                ),
                other["conclusion"],
            )
        )
    first, second = (of.runs[0].manifest["backend"] for of in sets)
    remarks = "".join(f"remark: {remark}\n" for of in sets for remark in of.remarks)
    return (
        f"rules {sets[0].runs[0].manifest['rule_table']}: first {first}, {len(sets[0].runs)} runs; second {second}, {len(sets[1].runs)} runs; "
        f"{number_text(sets[0].until_s)} s each\n" + columns(lines) + remarks
    )
