# SPDX-License-Identifier: MIT
"""`trophic analyze` on a sweep: its cells compared with one of them, on the terminal and as tables."""
from __future__ import annotations

import dataclasses
import html
import math
import os
import pathlib
from typing import Any

import numpy
import pandas

from .. import __version__, judge, metrics, pool
from ..description import describe
from ..errors import RunError, printable, remark
from ..judge import Finding
from ..metrics import Measuring
from ..report import tables
from ..report.columns import names as column_names
from ..report.measuring import measuring_of
from ..runs import Runs, read_run
from ..statistics import MIN_RUNS_FOR_TEST, USUAL_POWER, is_significant
from ..values import METRIC, Metric
from ..words import Reading, columns, metric_title, number_text, p_text, runs_text
from ..writing import csv_text, json_text, result_folder, write_new
from . import arrays
from .cells import (
    ANSWER,
    SweepValues,
    answers,
    compare_cells,
    count,
    level_of,
    metric_of,
    metrics_in,
    runs_for_difference,
)
from .effects import axis_effects
from .grid import Axis, Grid
from .runs import Sweep, check_sweep, measure_sweep, read_sweep

SHOWN = 20
"""Lines of a table on the terminal; CSV tables have all."""


@dataclasses.dataclass
class SweepAnalysis:
    """A measured sweep and what its cells differ in."""

    sweep: Sweep
    label: str
    """rules and engine of the reference cell's runs"""
    values: SweepValues
    """of all metrics"""
    reference: int
    until_s: float
    """simulated time of each run that is measured, s"""
    is_chosen: bool
    """metrics were named"""
    differences: pandas.DataFrame
    """as compare_cells returns it"""
    effects: pandas.DataFrame
    """as axis_effects returns it"""
    asked: pandas.DataFrame
    """as runs_for_difference returns it; empty if no difference was asked for"""
    remarks: list[str]

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(text_of(self))}</pre>"

    def findings(self) -> list[tuple[Finding, Any]]:
        """The significant differences in words, each fact once: of its plainest metric the cell that differs most, with that row of `differences`."""
        of = answers(self.differences)
        plain = {metric_of(row) for row in judge.facts(of, ("above", "below"))}
        found = of[of["conclusion"].isin(("above", "below"))]
        largest = [rows.loc[rows["difference"].abs().idxmax()] for metric, rows in metrics_in(found) if metric in plain]
        by_metric = {metric_of(row): row for row in largest}
        return [
            (finding, by_metric[finding.metric])
            for finding in judge.findings(pandas.DataFrame(largest, columns=of.columns))
        ]


def analyze_sweep(
    folder: str | os.PathLike,
    *,
    reference: int | None = None,
    difference: float | None = None,
    allow_missing: bool = False,
    how: Measuring | None = None,
) -> SweepAnalysis:
    """Measures a sweep and compares its cells with one of them, the first if `reference` is None. `difference`: how many replicates one of this
    size, in the unit of the metrics that `how` names, would need. `allow_missing` leaves out runs that are missing or incomplete. Raises
    RunError before anything is measured for a sweep that is not as its plan says, and for options that do not fit it.
    """
    how = how or Measuring()
    if difference is not None and not (math.isfinite(difference) and difference > 0.0):
        raise RunError(f"--difference {number_text(difference)}: must be > 0")
    if difference is not None and not how.metrics:
        raise RunError("--difference: needs --metric to name a metric")
    sweep = read_sweep(pathlib.Path(folder), how.accept_other_build)
    reference = sweep.grid.cells[0].number if reference is None else reference
    check_sweep(sweep, reference, allow_missing, how)
    values, remarks = measure_sweep(sweep, how)
    if how.metrics:
        names = metrics.chosen(values.metrics, how.metrics)
    else:
        repeats = judge.repeated_values(
            {metric: values.runs[:, number] for number, metric in enumerate(values.metrics)}
        )
        names = [metric for metric in values.metrics if metric not in repeats]
    if len(sweep.builds) > 1:
        remarks.insert(
            0,
            f"{len(sweep.builds)} different builds made these runs: {pool.builds_text(sweep.builds)}; their rules may have the same names but "
            "other code",
        )
    if sweep.missing:
        remarks.insert(0, f"{sweep.missing_line()}; omitted; {sweep.finished_by()}")
    lost = dict.fromkeys(metrics.lost_to_thinning(run.agents_every) for run in sweep.plan)
    compared = values.only(names)
    differences = compare_cells(sweep.grid, compared, reference)
    asked = runs_for_difference(differences, difference) if difference is not None else pandas.DataFrame()
    return SweepAnalysis(
        sweep,
        _label_of(sweep, reference),
        values,
        reference,
        sweep.plan[0].until_s if how.until_s is None else how.until_s,
        bool(how.metrics),
        differences,
        axis_effects(sweep.grid, compared, reference),
        asked,
        [*filter(None, lost), *remarks],
    )


def _label_of(sweep: Sweep, reference: int) -> str:
    cell = sweep.grid.cells[sweep.grid.place(reference)]
    folder = sweep.folder_of(
        next(one.run for one in cell.replicates if one.run is not None and sweep.is_there[one.run])
    )
    return describe(Runs(folder.parent, [read_run(folder)])).title()


def run(request: dict) -> int:
    """The command, from its options by name."""
    with result_folder(request.get("out")) as out:
        analysis = analyze_sweep(
            request["runs"][0],
            reference=request.get("reference"),
            difference=request.get("difference"),
            allow_missing=bool(request.get("allow_missing")),
            how=measuring_of(request),
        )
        files = write(analysis, out)
    for what in [
        *analysis.remarks[:5],
        *([f"and {len(analysis.remarks) - 5} more"] if len(analysis.remarks) > 5 else []),
    ]:
        remark(request["who"], what)
    print(text_of(analysis) + f"files   {printable(str(out.with_suffix('')))}/{{{','.join(files)}}}")
    return 0


# Tables


def write(analysis: SweepAnalysis, out: pathlib.Path) -> list[str]:
    """Writes the tables and summary.json into a folder; returns their names. Nothing is overwritten."""
    content = {
        "cells.csv": cells_table(analysis),
        "runs.csv": runs_table(analysis.sweep, analysis.values),
        "sweep_metrics.csv": metrics_table(analysis.sweep.grid, analysis.values),
        "sweep_differences.csv": with_significance(analysis.differences),
        "sweep_effects.csv": with_significance(analysis.effects),
    }
    settings = [axis.name for axis in _settings(analysis.sweep.grid)]
    for name, frame in content.items():
        write_new(
            out / name,
            csv_text(frame.reindex(columns=[*column_names(name), *(settings if name == "cells.csv" else [])])),
        )
    write_new(out / "summary.json", json_text(summary_of(analysis)))
    return [*content, "summary.json"]


def _settings(grid: Grid) -> list[Axis]:
    return [axis for axis in grid.axes if axis.name not in ("rule_table", "engine")]


def with_significance(frame: pandas.DataFrame) -> pandas.DataFrame:
    """The frame with the column `significant`: yes if p_holm <= 0.05, else no; empty without a p value."""
    return frame.assign(significant=[("yes" if is_significant(p) else "no") if p == p else "" for p in frame["p_holm"]])


def cells_table(analysis: SweepAnalysis) -> pandas.DataFrame:
    sweep, rows = analysis.sweep, []
    for place, cell in enumerate(sweep.grid.cells):
        rows.append(
            {
                "cell": cell.number,
                "rule_table": cell.first.rule_table,
                "engine": cell.first.engine,
                "runs": sweep.count("run", place),
                "runs_planned": sum(one.run is not None for one in cell.replicates),
                "shadow_runs": sweep.count("shadow", place),
                "until_s": analysis.until_s,
                **{axis.name: axis.values[place] for axis in _settings(sweep.grid)},
            }
        )
    return pandas.DataFrame(rows)


def runs_table(sweep: Sweep, values: SweepValues) -> pandas.DataFrame:
    """One row a value of a run, none for what could not be computed."""
    places, numbers = numpy.nonzero(~numpy.isnan(values.runs))
    planned = pandas.DataFrame(
        {"run": run.index, "cell": run.cell, "replicate": run.replicate, "null": run.null, "seed": run.seed}
        for run in sweep.plan
    )
    named = pandas.DataFrame(values.metrics, columns=METRIC)
    return pandas.concat(
        [planned.iloc[places].reset_index(drop=True), named.iloc[numbers].reset_index(drop=True)], axis=1
    ).assign(value=values.runs[places, numbers])


def metrics_table(grid: Grid, values: SweepValues) -> pandas.DataFrame:
    """Each metric of each cell, alone and over its shadow."""
    frames = []
    for cell in grid.cells:
        raw, shadow = values.of(cell)
        alone, its_shadow, over = (arrays.moments(each) for each in (raw, shadow, raw - shadow))
        intervals = [arrays.interval_of(arrays.contrast((1.0, of))) for of in (alone, over)]
        frames.append(
            pandas.DataFrame(
                {
                    "cell": cell.number,
                    **dict(zip(METRIC, zip(*values.metrics))),
                    "runs": alone.runs,
                    "mean": alone.mean,
                    "deviation": numpy.sqrt(alone.variance),
                    "lower": intervals[0].lower,
                    "upper": intervals[0].upper,
                    "shadow_runs": its_shadow.runs,
                    "shadow": its_shadow.mean,
                    "pairs": over.runs,
                    "over_shadow": over.mean,
                    "over_lower": intervals[1].lower,
                    "over_upper": intervals[1].upper,
                },
                index=range(len(values.metrics)),
            )
        )
    return pandas.concat(frames, ignore_index=True)


def summary_of(analysis: SweepAnalysis) -> dict[str, Any]:
    """The summary that no table has: findings, the grid, missing runs, the correction of comparisons, significant differences, and the answer to --difference."""
    sweep, of = analysis.sweep, answers(analysis.differences)
    size = count(analysis.differences)

    def named(row: Any) -> dict[str, Any]:
        return {**metric_of(row)._asdict(), "over_shadow": row.compared == ANSWER}

    significant = [
        {
            "cell": row.cell,
            **named(row),
            "value": row.difference,
            "lower": row.lower,
            "upper": row.upper,
            "p": row.p,
            "p_adjusted": row.p_holm,
            "differs": True,
            "hedges_g": row.hedges_g,
        }
        for row in of[of["conclusion"].isin(("above", "below"))].itertuples(index=False)
    ]
    asked = [
        {
            **named(row),
            "difference": row.difference,
            **{
                name: None if math.isnan(runs) else int(runs)
                for name, runs in zip(("runs", "fewest", "most"), row[-4:])
            },
        }
        for row in analysis.asked.itertuples(index=False)
    ]
    content = {
        "label": analysis.label,
        "cells": len(sweep.grid.cells),
        "runs_planned": len(sweep.plan),
        "missing": sweep.missing,
        "builds": sweep.builds,
        "axes": [{"name": axis.name, "values": axis.values} for axis in sweep.grid.axes],
        "reference": analysis.reference,
        "min_runs_for_test": MIN_RUNS_FOR_TEST,
        "comparisons": size.comparisons,
        "level": level_of(of),
        "power": USUAL_POWER,
        "significant": significant,
        "asked": asked,
    }
    return {
        "trophic": __version__,
        "family": {**size._asdict(), "sentence": size.sentence()},
        "findings": [{**tables.finding(one), "cell": int(row.cell)} for one, row in analysis.findings()],
        "sweep": content,
    }


# The terminal


def text_of(analysis: SweepAnalysis) -> str:
    """The text of the terminal: the grid, what is significant and what is not, named metrics, effects of axes and the answer to --difference."""
    text = header_text(analysis)
    if len(analysis.differences):
        text += differences_text(analysis) + (named_text(analysis) if analysis.is_chosen else "")
    return text + effects_text(analysis.effects) + asked_text(analysis)


def counted(count: int, noun: str) -> str:
    return f"{count} {noun}{'' if count == 1 else 's'}"


def values_text(axis: Axis) -> str:
    """The values of an axis, each once, in the order of the cells; of many the first few."""
    values = [value or "unset" for value in dict.fromkeys(axis.values)]
    return ", ".join(values[:8]) + (f", ... ({len(values)} values)" if len(values) > 8 else "")


def header_text(analysis: SweepAnalysis) -> str:
    """The grid, the reference cell, how many comparisons there are and how they were made."""
    sweep, differences = analysis.sweep, analysis.differences
    grid = sweep.grid
    lines = [
        f"sweep of {counted(len(grid.cells), 'cell')}, {counted(sum(sweep.is_there), 'run')} of {number_text(analysis.until_s)} s"
    ]
    lines += [f"axis {axis.name}: {values_text(axis)}" for axis in grid.axes]
    lines.append(f"reference: {grid.cell_name(analysis.reference)}, {analysis.label}")
    if not len(differences):
        return "\n".join([*lines, "only one cell: there is nothing to compare\n"])
    designs = set(differences["design"]) - {"exact"}
    design = (
        "seed by seed where cells share seeds, else as independent sets"
        if len(designs) > 1
        else "seed by seed"
        if designs == {"paired"}
        else "as independent sets (different seeds in each cell)"
    )
    over = ", each run relative to its shadow" if (differences["compared"] == ANSWER).any() else ""
    lines.append(
        f"{counted(count(differences).comparisons, 'comparison')} with it, {design}{over}; p corrected for all of them (Holm)"
    )
    names, every = len(differences[METRIC].drop_duplicates()), len(analysis.values.metrics)
    if not analysis.is_chosen and every > names:
        lines.append(
            f"metrics {names}; {every - names} more repeat one of them, and are compared if --metric names them"
        )
    return "\n".join(lines) + "\n"


def compared_title(row: Any) -> str:
    return metric_title(metric_of(row)) + (", over shadow" if row.compared == ANSWER else "")


def _with_interval(row: Any) -> str:
    return Reading(metric_of(row)).with_interval(row.difference, judge.interval_of_row(row), True)


def _effect_size(row: Any) -> str:
    return "-" if math.isnan(row.hedges_g) else f"{row.hedges_g:+.1f}"


def differences_text(analysis: SweepAnalysis) -> str:
    """One line a fact that is significant anywhere, then what is not, in words."""
    of, grid = answers(analysis.differences), analysis.sweep.grid
    size = count(analysis.differences)
    text = size.sentence() + "\n"
    found = analysis.findings()
    significant = of[of["conclusion"].isin(("above", "below"))]
    if found:
        cells = significant.groupby(METRIC).size()
        text += columns(
            [
                ("significant metric", "cells", "largest difference [95 %]", "g", "in cell"),
                *(
                    (
                        compared_title(row),
                        f"{cells[finding.metric]}/{len(grid.cells) - 1}",
                        _with_interval(row),
                        _effect_size(row),
                        f"{row.cell} ({grid.cell_title(row.cell)})",
                    )
                    for finding, row in found[:SHOWN]
                ),
            ]
        )
        more = len(cells) - len(found[:SHOWN])
        if more > 0:
            text += f"and {counted(more, 'metric')} more, such as other groups and readings of these: significant in sweep_differences.csv\n"
        text += "g: Hedges'\n"
    inconclusive = size.comparisons - size.significant
    if inconclusive > 0:
        text += f"inconclusive: {inconclusive} of {size.comparisons} comparisons{'; this does not show equality' if found else ''}\n"
    tested = set(map(metric_of, significant.itertuples(index=False)))
    everywhere = [metric_title(metric) for metric, rows in metrics_in(of[of["is_comparison"]]) if metric not in tested]
    if everywhere:
        text += f"inconclusive in every cell: {counted(len(everywhere), 'metric')}: {'; '.join(everywhere[:6])}{'; ...' if len(everywhere) > 6 else ''}\n"
    if too_few := int((of["conclusion"] == "too few runs").sum()):
        text += f"too few runs for a test in {too_few} of them: {MIN_RUNS_FOR_TEST} in each cell are needed\n"
    if inconclusive > 0:
        text += (
            "smallest_detectable in sweep_differences.csv is the effect that such runs detect in 80 % of studies; --difference computes the "
            "runs for another effect; "
            "fewer metrics (--metric), chosen before looking, need fewer runs\n"
        )
    return text


def named_text(analysis: SweepAnalysis) -> str:
    """One line for each metric of each cell: means, difference, p and the runs that would be needed. For few metrics."""
    differences = analysis.differences
    raw = differences[differences["role"] != "null"].set_index(["cell", *METRIC])["difference"]
    head = [
        "metric",
        "cell",
        "mean",
        "reference",
        "difference [95 %]",
        *(["raw"] if len(raw) else []),
        "p",
        "g",
        "runs",
        "detectable",
    ]
    rows, constant = [], []
    of = answers(differences)
    varies = set(map(metric_of, of[of["is_comparison"]].itertuples(index=False)))
    for row in of.itertuples(index=False):
        metric = metric_of(row)
        if metric not in varies:
            constant.append(metric_title(metric))
            continue
        reading = Reading(metric)
        rows.append(
            (
                compared_title(row),
                f"{row.cell} ({analysis.sweep.grid.cell_title(row.cell)})",
                reading(row.mean),
                reading(row.mean_reference),
                _with_interval(row),
                *([reading(raw.get((row.cell, *metric), row.difference), True)] if len(raw) else []),
                p_text(row.p_holm),
                _effect_size(row),
                f"{row.runs}+{row.runs_reference}",
                reading(row.smallest_detectable) if row.conclusion in ("inconclusive", "too few runs") else "",
            )
        )
    lines = [f"identical in all runs, or without values: {title}\n" for title in dict.fromkeys(constant)]
    return (
        columns([head, *rows])
        + "".join(lines)
        + (
            "p: corrected for all comparisons (Holm), with intervals that hold for all at once (Bonferroni); detectable: the effect that such "
            "runs detect in 80 % of studies\n"
        )
    )


def effects_text(effects: pandas.DataFrame) -> str:
    """One line for each axis and metric with a significant value, the value with the largest effect."""
    if not len(effects):
        return ""
    of, size = answers(effects), count(effects)
    significant = of[of["conclusion"].isin(("above", "below"))]
    text = f"averaged over the other axes, {size.significant} of {size.comparisons} effects of an axis are significant (Holm)"
    if not len(significant):
        return text + "\n"
    plain = {metric_of(row) for row in judge.facts(significant, ("above", "below"))}
    largest = [
        rows.loc[rows["difference"].abs().idxmax()]
        for (*name, _), rows in significant.groupby([*METRIC, "axis"], sort=False)
        if Metric(*name) in plain
    ]
    text += "; the largest of each:\n" + columns(
        [
            ("effect of an axis", "difference [95 %]", "axis", "values"),
            *(
                (compared_title(row), _with_interval(row), row.axis, f"{row.reference} -> {row.value}")
                for row in largest[:SHOWN]
            ),
        ]
    )
    more = len(significant.groupby([*METRIC, "axis"])) - len(largest[:SHOWN])
    return text + (f"and {more} more, marked significant in sweep_effects.csv\n" if more > 0 else "")


def asked_text(analysis: SweepAnalysis) -> str:
    """One line a metric: how many replicates a difference of the size that was asked for would need."""
    text = ""
    for row in analysis.asked.itertuples(index=False):
        reading = Reading(metric_of(row))
        over = ", over shadow" if row.compared == ANSWER else ""
        text += f"a difference of {reading(row.difference)} in {metric_title(metric_of(row))}{over} needs "
        text += (
            "an unknown number of replicates: fewer than two were compared\n"
            if row.cells == 0
            else f"{runs_text(row.runs)} replicates a cell ({runs_text(row.fewest)} to {runs_text(row.most)}, cell by cell) for 80 % power\n"
        )
    if text:
        of = answers(analysis.differences)
        text += f"at the level of one of {counted(count(of).comparisons, 'comparison')}, {number_text(round(level_of(of), 5))}; based on the variance of these runs\n"
    return text
