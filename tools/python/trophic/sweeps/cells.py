# SPDX-License-Identifier: MIT
"""The cells of a sweep, metric by metric, compared with one of them: differences corrected for their number, how large they are, and how many
runs a difference of a given size needs."""
from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence

import numpy
import pandas

from ..controls import SHARES
from ..judge import Count, conclusions
from ..statistics import SIGNIFICANCE, holm, share_difference
from ..values import METRIC, Metric
from . import arrays
from .arrays import Array, Contrast, Scatter
from .grid import Cell, Grid, is_paired

ANSWER, RAW = "over_shadow", "raw"
_STATISTICS = ("value", "error", "freedom", "variance", "scatter_freedom")


@dataclasses.dataclass
class SweepValues:
    """The observed values of each run of a sweep."""

    metrics: list[Metric]
    runs: Array
    """(planned runs, metrics); nan in a run that is missing, and where there is no value"""
    is_there: Sequence[bool]
    """of each planned run: it is measured"""
    is_constant: bool = True
    """numbers are constant in all cells; if not, shadows do not control for one species, and differences are raw"""

    def of(self, cell: Cell) -> tuple[Array, Array]:
        """Values of a cell's runs and of their shadows: (replicates in the order of their seeds, metrics) each."""
        nothing = numpy.full(len(self.metrics), numpy.nan)
        rows = [
            [nothing if place is None else self.runs[place] for place in (one.run, one.shadow)] for one in by_seed(cell)
        ]
        both = numpy.array(rows).reshape(len(rows), 2, len(self.metrics))
        return both[:, 0], both[:, 1]

    def compared(self, cell: Cell, over_shadow: bool) -> Array:
        """Values of a cell's runs, or by how much they exceed those of their shadows, but for shares of runs."""
        raw, shadow = self.of(cell)
        return raw - numpy.where(self.are_shares, 0.0, shadow) if over_shadow else raw

    @property
    def are_shares(self) -> Array:
        return numpy.array([metric.metric in SHARES for metric in self.metrics])

    def have_shadows(self, grid: Grid) -> bool:
        """Whether every cell has a run and its shadow, and numbers are constant, so that the difference over the shadows is the answer."""
        if not self.is_constant:
            return False

        def is_there(place: int | None) -> bool:
            return place is not None and self.is_there[place]

        return all(any(is_there(one.run) and is_there(one.shadow) for one in cell.replicates) for cell in grid.cells)

    def only(self, metrics: Sequence[Metric]) -> "SweepValues":
        return SweepValues(
            list(metrics),
            self.runs[:, [self.metrics.index(metric) for metric in metrics]],
            self.is_there,
            self.is_constant,
        )


def by_seed(cell: Cell) -> list:
    return sorted(cell.replicates, key=lambda replicate: replicate.seed)


def compare_cells(grid: Grid, values: SweepValues, reference: int) -> pandas.DataFrame:
    """Every cell but the reference compared with it in each metric, by cells, then metrics.

    The answer is over the shadows, each run less its shadow first, if every cell has shadows; raw differences stand behind it then, a family of
    their own. Cells are compared seed by seed if they share seeds (mean of the pairs' differences, Student's t), else as independent sets (Welch).
    Shares of runs, which are 0 or 1 in each, are compared without their shadows, by Fisher's exact test: seeds that are alike make it err less often.

    Columns: those of sweep_differences.csv (docs/tables.md), and as in judge.compare `role` ("null" of an answer, else ""), `level` and
    `conclusion`; `set_a`, `set_b`, `n_a`, `n_b`; and `scatter`, the deviation of a difference of one run. nan is what could not be computed.
    Raises RunError for a reference that is not a cell, and for seeds of which only some are in common.
    """
    base = grid.cells[grid.place(reference)]
    families = [ANSWER, RAW] if values.have_shadows(grid) else [RAW]
    parts = []
    for family in families:
        of_base = values.compared(base, family == ANSWER)
        blocks = [
            _compared(base, of_base, cell, values.compared(cell, family == ANSWER), values.metrics)
            for cell in grid.cells
            if cell is not base
        ]
        if not blocks:
            continue
        frame = pandas.concat(blocks, ignore_index=True)
        parts.append(judged(as_family(frame, family, families)))
    if not parts:
        return pandas.DataFrame(columns=["cell", *METRIC, "compared", "role", "conclusion", "p_holm", "is_comparison"])
    found = pandas.concat(parts)
    found = found.sort_index(kind="stable").reset_index(drop=True)  # the raw difference behind its answer
    found["reference"], found["set_a"] = reference, grid.cell_name(reference)
    found["set_b"] = found["cell"].map({cell.number: grid.cell_name(cell.number) for cell in grid.cells})
    found["n_a"], found["n_b"] = found["runs_reference"], found["runs"]
    return found


def as_family(frame: pandas.DataFrame, family: str, families: Sequence[str]) -> pandas.DataFrame:
    """The rows of a family, with `compared` and `role`: shares of runs are answers without shadows, once."""
    is_share = frame["metric"].isin(SHARES)
    frame = frame.assign(compared=numpy.where(is_share, RAW, family), role="null" if family == families[0] else "")
    return frame if family == families[0] else frame[~is_share]


def exact(
    frame: pandas.DataFrame, names: Sequence[str] = ("lower", "upper", "p"), level: float = 0.95
) -> pandas.DataFrame:
    """The frame with exact intervals and p values of the differences of shares of runs, by share_difference."""
    frame = frame.copy()
    for row in frame[frame["metric"].isin(SHARES)].itertuples():
        its, others = (
            numpy.arange(n) < numpy.rint(n * mean)
            for n, mean in ((row.runs, row.mean), (row.runs_reference, row.mean_reference))
        )
        of = share_difference(its, others, level)
        frame.loc[row.Index, list(names)] = [
            *(of.interval or (numpy.nan, numpy.nan)),
            numpy.nan if of.p is None else of.p,
        ][: len(names)]
    return frame


def _lacks(values: Array) -> Array:
    """Whether each metric lacks a value in some run that has others: it did not happen there, and a mean over the rest is not tested, as in
    controls.lack. `values`: (runs, metrics)."""
    return (numpy.isnan(values) & ~numpy.isnan(values).all(axis=1, keepdims=True)).any(axis=0)


def _compared(base: Cell, of_base: Array, cell: Cell, of_cell: Array, metrics: Sequence[Metric]) -> pandas.DataFrame:
    """Two cells in all metrics, without a correction. `of_base`, `of_cell`: (replicates by seed, metrics)."""
    paired = is_paired(base, cell)
    lacks = numpy.any([_lacks(each) for each in (of_base, of_cell)], axis=0)
    if paired:
        places = [{one.seed: place for place, one in enumerate(by_seed(each))} for each in (base, cell)]
        seeds = [seed for seed in places[0] if seed in places[1]]
        of_base, of_cell = (
            values[[place[seed] for seed in seeds]] for values, place in zip((of_base, of_cell), places)
        )
        missing = numpy.isnan(of_base) | numpy.isnan(of_cell)
        of_base, of_cell = numpy.where(missing, numpy.nan, of_base), numpy.where(missing, numpy.nan, of_cell)
    a, b = arrays.moments(of_base), arrays.moments(of_cell)
    if paired:
        pairs = arrays.moments(of_cell - of_base)
        of, scatter = arrays.contrast((1.0, pairs)), arrays.scatter_of(pairs)
    else:
        of, scatter = arrays.contrast((-1.0, a), (1.0, b)), arrays.scatter_of(a, b)
    difference = b.mean - a.mean
    varies = ~arrays.is_rounding(numpy.sqrt(scatter.variance), b.mean) | ~arrays.is_rounding(
        numpy.abs(difference), b.mean
    )
    is_comparison = varies & ~numpy.isnan(scatter.variance) & ~numpy.isnan(difference) & ~lacks
    interval = arrays.interval_of(of)
    columns = {
        "cell": cell.number,
        **dict(zip(METRIC, zip(*metrics))),
        "design": "paired" if paired else "independent",
        "runs": b.runs,
        "runs_reference": a.runs,
        "mean": b.mean,
        "mean_reference": a.mean,
        "difference": difference,
        "lower": interval.lower,
        "upper": interval.upper,
        "p": numpy.where(is_comparison, arrays.p_value(of), numpy.nan),
        "hedges_g": arrays.hedges_g(a, b),
        "is_comparison": is_comparison,
        "scatter": numpy.sqrt(scatter.variance),
    }
    frame = pandas.DataFrame({**columns, **dict(zip(_STATISTICS, (*of, *scatter)))}, index=range(len(metrics)))
    return exact(frame.assign(design=frame["design"].where(~frame["metric"].isin(SHARES), "exact")))


def judged(frame: pandas.DataFrame) -> pandas.DataFrame:
    """A family with its correction: Holm's over all comparisons, of which one with fewer runs than a test needs has no p value, but counts, as
    more runs would give it one; intervals that all hold at once with 95 % (Bonferroni); conclusions; and what is detected with USUAL_POWER.
    The frame's columns `is_comparison`, `p` and _STATISTICS are used."""
    frame = with_intervals(corrected(frame))
    tested = frame[frame["is_comparison"]]
    of = Contrast(*(tested[column].to_numpy() for column in _STATISTICS[:3]))
    detectable = arrays.detectable_difference(of, level_of(frame))
    return frame.assign(smallest_detectable=pandas.Series(detectable, tested.index))


def with_intervals(frame: pandas.DataFrame) -> pandas.DataFrame:
    """The frame with the intervals of its comparisons that all hold at once with 95 % (Bonferroni)."""
    level, bounds = 1.0 - level_of(frame), ("lower_corrected", "upper_corrected")
    tested = frame[frame["is_comparison"]]
    of = Contrast(*(tested[column].to_numpy(float) for column in ("difference", "error", "freedom")))
    interval = arrays.interval_of(of, level)
    frame = frame.assign(**{name: pandas.Series(of, tested.index) for name, of in zip(bounds, interval)})
    return exact(frame, bounds, level)


def corrected(frame: pandas.DataFrame) -> pandas.DataFrame:
    """The frame with `p_holm`, `level` and `conclusion` of its comparisons as one family, of which only answers conclude anything."""
    is_comparison, p = frame["is_comparison"].to_numpy(bool), frame["p"].to_numpy(float)
    p_holm = numpy.full(len(frame), numpy.nan)
    p_holm[is_comparison] = holm(numpy.where(numpy.isnan(p), 1.0, p)[is_comparison])
    p_holm[numpy.isnan(p)] = numpy.nan
    conclusion = numpy.where(
        ~is_comparison | (frame["role"] != "null"),
        "not compared",
        numpy.where(numpy.isnan(p), "too few runs", conclusions(p_holm, frame["difference"])),
    )
    return frame.assign(
        p_holm=p_holm, level=numpy.where(is_comparison, level_of(frame), numpy.nan), conclusion=conclusion
    )


def level_of(frame: pandas.DataFrame) -> float:
    """The level of one comparison of a family, so that all together err in at most 5 % of analyses [dunn1961]."""
    return SIGNIFICANCE / max(1, int(frame["is_comparison"].sum()))


def answers(frame: pandas.DataFrame) -> pandas.DataFrame:
    """The rows that answer, of which conclusions and counts are."""
    return frame[frame["role"] == "null"]


def count(frame: pandas.DataFrame) -> Count:
    """The size of the family that answers."""
    of = answers(frame)
    return Count(int(of["is_comparison"].sum()), int(of["conclusion"].isin(("above", "below")).sum()))


def metric_of(row) -> Metric:
    return Metric(row.metric, row.species, row.group, row.unit)


def metrics_in(frame: pandas.DataFrame) -> Iterable[tuple[Metric, pandas.DataFrame]]:
    """Each metric with its rows, in the order of the frame."""
    return ((Metric(*name), rows) for name, rows in frame.groupby(METRIC, sort=False))


def runs_for_difference(frame: pandas.DataFrame, difference: float) -> pandas.DataFrame:
    """How many runs in each cell a difference of a size, in the metric's unit, would need in each metric at the level of one comparison.

    Columns: METRIC, `compared`, `difference`, `runs` by the scatter that cells have on average, `fewest` and `most` by that of the least and of the
    most scattered cell (nan: more than MOST_RUNS), and `cells` whose scatter is known.
    """
    of, rows = answers(frame), []
    for metric, its in metrics_in(of):
        known = its[its["variance"].notna()]
        row = {**metric._asdict(), "compared": its["compared"].iloc[0], "difference": difference, "cells": len(known)}
        if len(known):
            order = known["variance"].to_numpy().argsort(kind="stable")
            each = [known[column].to_numpy()[[order[0], order[-1]]] for column in _STATISTICS[3:]]
            scatter = Scatter(
                *(numpy.append(known[column].mean(), values) for column, values in zip(_STATISTICS[3:], each))
            )
            row.update(
                zip(("runs", "fewest", "most"), arrays.runs_for_power(numpy.full(3, difference), scatter, level_of(of)))
            )
        rows.append({"runs": numpy.nan, "fewest": numpy.nan, "most": numpy.nan, **row})
    return pandas.DataFrame(rows, columns=[*METRIC, "compared", "difference", "runs", "fewest", "most", "cells"])
