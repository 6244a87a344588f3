# SPDX-License-Identifier: MIT
"""Lineage measures of a run, each with the same measure under drift: in forests in which the run's births and deaths have parents, newcomers'
genomes and mutations by chance, so that no genome lives longer or has more offspring for what it does.

The program that made the runs says which genomes' brains decide alike."""
from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy
import pandas

from ..errors import RunError
from ..runs import Run
from ..values import CURVE_COLUMNS, VALUE_COLUMNS, Metric, RunValues
from ..words import number_text
from . import drift
from .forests import Forest, activity, descent, modes, presence

if TYPE_CHECKING:
    from ..pool import PooledRun
    from . import Measuring

DRIFT = "drift"
"""The baseline: the mean of a measure over the forests of drift."""
_MODES = (("modes_change", "types"), ("modes_novelty", "types"), ("modes_ecology", "bits"), ("modes_complexity", "1"))
_ACTIVITY = (
    ("activity_diversity", "types"),
    ("activity_mean", "s"),
    ("activity_excess", "s"),
    ("activity_new", "types"),
)
_DESCENT = (
    ("descent_roots", "1"),
    ("descent_largest_clade", "1"),
    ("descent_mean_depth", "births"),
    ("descent_greatest_depth", "births"),
    ("descent_related_pairs", "1"),
    ("descent_common_ancestor", "s"),
    ("descent_diversity", "s"),
)
_HALVES = ("early", "late")
_NULLS_OF_ACTIVITY = (
    2  # the activity of the run and of the other forests of drift is compared with that in the first ones
)
MOST_WINDOWS = 10_000
_COUNTS = 10  # of presence in a window


def window_of(runs: Sequence[Run], asked_s: float | None = None) -> float:
    """The length of windows, s: `asked_s`, else 500 s or a quarter of a shorter run. Raises RunError if a run has fewer than four windows."""
    lengths_s = [run.manifest["result"]["reached_s"] for run in runs]
    window_s = min(500.0, 0.25 * lengths_s[0]) if asked_s is None else asked_s
    if not (window_s > 0.0 and 4.0 * window_s <= min(lengths_s)):
        raise RunError(
            f"--window {number_text(window_s)}: must be > 0 and <= {number_text(0.25 * min(lengths_s))}, a quarter of the shortest run"
        )
    if window_s * MOST_WINDOWS < max(lengths_s):
        raise RunError(
            f"--window {number_text(window_s)}: must be >= {number_text(max(lengths_s) / MOST_WINDOWS)}, for at most {MOST_WINDOWS} windows"
        )
    return window_s


def metric_names(species: Sequence[str]) -> list[Metric]:
    """The metrics of a run with these species, in the order of its values."""
    return [
        Metric(name, one, group, unit)
        for one in species
        for names in (_MODES, _ACTIVITY, _DESCENT)
        for name, unit in names
        for group in (("all",) if names is _DESCENT else _HALVES)
    ]


def prepared(
    runs: Sequence[PooledRun], shadow: Sequence[PooledRun], every: Sequence[PooledRun], how: Measuring
) -> Measuring:
    """How these runs and their nulls are measured: with the windows, and with inputs that brains met in the first run and in the first one of the
    shadow. Raises RunError if a run lacks what lineage measures need, or if the program has not the rule table that made the runs.
    """
    for run in every:
        drift.check(run)
    window_s = window_of(every, how.window_s)
    drift.ask(str(how.lineages), runs[0], [[] for _ in runs[0].web.species])
    return dataclasses.replace(how, window_s=window_s, first=runs[0], inputs=drift.met_inputs([runs[0], *shadow[:1]]))


def measure_run(run: PooledRun, how: Measuring) -> RunValues:
    """Measures a run, in windows of `how.window_s` up to its end. Raises RunError if a table was changed or the program cannot ask its brains."""
    return lineage_values(
        read_forests(run, how), run.manifest["species"], how.window_s, run.manifest["result"]["reached_s"]
    )


def read_forests(run: PooledRun, how: Measuring) -> list[Forest]:
    """Returns the run's forest, and those of drift after it."""
    own = drift.read_descent(run)
    every = [
        own,
        *(drift.drift_of(own, run.web.species, drift.stream(run.seed, number)) for number in range(drift.FORESTS)),
    ]
    found = drift.ask(str(how.lineages), how.first or run, how.inputs, every)
    return [drift.forest_of(of, *its) for of, its in zip(every, found)]


def lineage_values(forests: Sequence[Forest], species: Sequence, window_s: float, end_s: float) -> RunValues:
    """The measures of each species at the ends of windows: of MODES and activity means over the early and the late half of the run, of descent
    means over the whole run, all as curves. `forests`: the run's, then those of drift, at least three.
    """
    times_s = window_s * numpy.arange(int(end_s / window_s * (1.0 + 1e-12)) + 1)
    ends_s = times_s[1:]
    halves = (("early", ends_s <= 0.5 * end_s), ("late", ends_s > 0.5 * end_s))
    values, curves = [], []
    for one in species:
        for names, own, drifted in _measured(forests, one, window_s, times_s):
            groups = (("all", ends_s <= end_s),) if names is _DESCENT else halves
            means = [(_mean(own[within]), _mean(_mean(drifted[:, within], 1))) for _, within in groups]
            for i, (name, unit) in enumerate(names):
                for (group, _), (ours, drift) in zip(groups, means):
                    values += [
                        (name, one, group, unit, "", "", ours[i]),
                        (name, one, group, unit, DRIFT, "null", drift[i]),
                    ]
            series = (("", own), (DRIFT, _mean(drifted)))
            curves += [
                (name, one, "all", unit, baseline, *point)
                for i, (name, unit) in enumerate(names)
                for baseline, points in series
                for point in zip(ends_s, points[:, i])
            ]
    return RunValues(pandas.DataFrame(values, columns=VALUE_COLUMNS), pandas.DataFrame(curves, columns=CURVE_COLUMNS))


def _measured(
    forests: Sequence[Forest], species, window_s: float, times_s: numpy.ndarray
) -> Iterator[tuple[tuple, numpy.ndarray, numpy.ndarray]]:
    """Yields the names of measures, their values in the run, shape (windows, measures), and in forests of drift, shape (forests, windows, measures)."""
    found = numpy.array([modes(forest, species, times_s) for forest in forests])
    yield _MODES, found[0], found[1:]
    types = 1 + max((int(forest.type.max()) for forest in forests if len(forest.type)), default=0)
    counts_s = window_s * numpy.arange(_COUNTS * (len(times_s) - 1) + 1) / _COUNTS
    own, *drifted = (presence(forest, species, counts_s, types) for forest in forests)
    nulls, others = drifted[:_NULLS_OF_ACTIVITY], drifted[_NULLS_OF_ACTIVITY:]
    found = numpy.array([_by_window(activity(each, nulls), counts_s[1]) for each in (own, *others)])
    yield _ACTIVITY, found[0], found[1:]
    found = numpy.array([[descent(forest, species, time_s) for time_s in times_s[1:].tolist()] for forest in forests])
    yield _DESCENT, found[0], found[1:]


def _by_window(counted: numpy.ndarray, step_s: float) -> numpy.ndarray:
    """Activity at the ends of windows, in seconds instead of counts; the new types of a window are summed."""
    ends = counted[_COUNTS::_COUNTS] * (1.0, step_s, step_s, 1.0)
    ends[:, 3] = counted[1:, 3].reshape(-1, _COUNTS).sum(axis=1)
    return ends


def _mean(values: numpy.ndarray, axis: int = 0) -> numpy.ndarray:
    """The mean along an axis of the values that are not nan; nan without any."""
    known = ~numpy.isnan(values)
    with numpy.errstate(invalid="ignore"):
        return numpy.where(known, values, 0.0).sum(axis) / known.sum(axis)
