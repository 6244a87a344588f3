# SPDX-License-Identifier: MIT
"""The effect of each value of an axis of a sweep, averaged over the rest of the grid: all cells count."""
from __future__ import annotations

import numpy
import pandas

from ..values import METRIC
from . import arrays
from .cells import ANSWER, RAW, SweepValues, as_family, by_seed, corrected, exact, with_intervals
from .grid import Axis, Grid, is_paired


def axis_effects(grid: Grid, values: SweepValues, reference: int) -> pandas.DataFrame:
    """Every metric with an axis at each of its values, compared with the axis at the reference cell's value, by metrics, axes and values.

    The mean over all settings of the other axes at which both values were run, one number a seed, and Student's t over seeds; of shares of runs
    Fisher's exact test over settings and seeds. Over the shadows and raw, two families, as compare_cells. Columns: sweep_effects.csv's, `role`,
    `level` and `conclusion`. Empty if the cells do not share their seeds, as then no seed is in all of them.
    """
    columns = [
        "axis",
        "value",
        "reference",
        *METRIC,
        "compared",
        "settings",
        "seeds",
        "mean",
        "mean_reference",
        "difference",
        "lower",
        "upper",
        "p",
    ]
    place = grid.place(reference)
    families = [ANSWER, RAW] if values.have_shadows(grid) else [RAW]
    parts = []
    if all(is_paired(grid.cells[place], cell) for cell in grid.cells):
        for family in families:
            blocks = _effects(grid, values, place, family == ANSWER)
            if blocks:
                frame = pandas.concat(blocks).sort_index(kind="stable").reset_index(drop=True)  # by metrics first
                frame = as_family(exact(frame), family, families)
                parts.append(with_intervals(corrected(frame.assign(is_comparison=frame["p"].notna()))))
    if not parts:
        more = ["p_holm", "lower_corrected", "upper_corrected", "role", "level", "conclusion", "is_comparison"]
        return pandas.DataFrame(columns=[*columns, *more])
    return pandas.concat(parts).sort_index(kind="stable").reset_index(drop=True)


def _effects(grid: Grid, values: SweepValues, place: int, over_shadow: bool) -> list[pandas.DataFrame]:
    """A frame of all metrics for each value of each axis. `place`: of the reference cell."""
    seeds = {seed: row for row, seed in enumerate(sorted({one.seed for cell in grid.cells for one in cell.replicates}))}
    of_cells = numpy.full((len(grid.cells), len(seeds), len(values.metrics)), numpy.nan)
    for number, cell in enumerate(grid.cells):
        of_cells[number, [seeds[one.seed] for one in by_seed(cell)]] = values.compared(cell, over_shadow)
    blocks = []
    for axis in grid.axes:
        reference = axis.values[place]
        for value in dict.fromkeys(axis.values):
            pairs = [] if value == reference else _pairs_along(grid, axis, reference, value)
            if not pairs:
                continue
            before, after = (of_cells[list(cells)].sum(axis=0) / len(pairs) for cells in zip(*pairs))
            missing = numpy.isnan(before) | numpy.isnan(after)
            of = arrays.moments(after - before)
            contrast = arrays.contrast((1.0, of))
            interval = arrays.interval_of(contrast)
            means = [arrays.moments(numpy.where(missing, numpy.nan, each)).mean for each in (after, before)]
            blocks.append(
                pandas.DataFrame(
                    {
                        "axis": axis.name,
                        "value": value,
                        "reference": reference,
                        **dict(zip(METRIC, zip(*values.metrics))),
                        "compared": "",
                        "settings": len(pairs),
                        "seeds": of.runs,
                        "runs": len(pairs) * of.runs,
                        "runs_reference": len(pairs) * of.runs,
                        "mean": means[0],
                        "mean_reference": means[1],
                        "difference": of.mean,
                        "lower": interval.lower,
                        "upper": interval.upper,
                        "p": arrays.p_value(contrast),
                        "error": contrast.error,
                        "freedom": contrast.freedom,
                    },
                    index=range(len(values.metrics)),
                )
            )
    return blocks


def _pairs_along(grid: Grid, axis: Axis, reference: str, value: str) -> list[tuple[int, int]]:
    """Places of the pairs of cells with an axis at `reference` and at `value`, all other axes alike."""
    others = [other.values for other in grid.axes if other is not axis]
    rest = [tuple(values[cell] for values in others) for cell in range(len(grid.cells))]
    at_reference = {rest[cell]: cell for cell in range(len(grid.cells)) if axis.values[cell] == reference}
    return [
        (at_reference[rest[cell]], cell)
        for cell in range(len(grid.cells))
        if axis.values[cell] == value and rest[cell] in at_reference
    ]
