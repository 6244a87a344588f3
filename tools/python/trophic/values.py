# SPDX-License-Identifier: MIT
"""The data model of an analysis: measured values of a run, and sets of runs that are replicates."""
from __future__ import annotations

import dataclasses
import functools
from typing import TYPE_CHECKING, NamedTuple

import numpy
import pandas

if TYPE_CHECKING:
    from .runs import Run


class Metric(NamedTuple):
    """The name of a number, written METRIC:SPECIES:GROUP.

    `species` of a metric of two is "prey+predator". `group`: all, random, inherited, active, inactive, inherited_active, inherited_inactive; of
    deaths a cause, of ticks_at a number of members. `unit` is "1" for shares and counts."""

    metric: str
    species: str
    group: str
    unit: str

    def __str__(self) -> str:
        return f"{self.metric}:{self.species}:{self.group}"


METRIC = list(Metric._fields)
SHADOW, NEUTRAL, CLONES, ONE_SIDED = "shadow", "neutral", "clones", "one_sided"
"""The names of the baselines that a set's neutral shadow, its neutral null, its clones and its one-sided worlds give. Those of the first three are
also their folders; `one_sided_name` has those of the last."""
MOST_NUMBER = 1e60
"""The largest absolute number of a table or of a metric that is analysed: sums of fourth powers of such numbers are finite."""
VALUE_COLUMNS = [*METRIC, "baseline", "role", "value"]
CURVE_COLUMNS = [*METRIC, "baseline", "time_s", "value"]


def one_sided_name(species: str) -> str:
    """The name of the world in which this species alone inherits nothing, and of the folder of its runs in that of the replicates."""
    return f"{ONE_SIDED}_{species}"


def one_sided_species(name: str) -> str:
    """The species of the one-sided world of this name; empty for another null."""
    prefix = one_sided_name("")
    return name[len(prefix) :] if name.startswith(prefix) else ""


@dataclasses.dataclass
class RunValues:
    """The measured values and curves of a run."""

    values: pandas.DataFrame
    """columns VALUE_COLUMNS, in the order of all tables. `baseline` is empty for what was observed; `role` of a baseline: "null", the value that
    chance alone would give, which is tested against, "paper" or "reference", which are not. `value` is nan if it could not be computed"""
    curves: pandas.DataFrame = dataclasses.field(default_factory=lambda: pandas.DataFrame(columns=CURVE_COLUMNS))
    """columns CURVE_COLUMNS; time_s: the end of a window, s"""
    remarks: list[str] = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class MeasuredSet:
    """Runs that are replicates, with what was measured in each."""

    label: str
    """unique in an analysis: the rule table, or the changed table's own name"""
    runs: list["Run"]
    values: list[RunValues]
    """one a run, with the same metrics and baselines in the same order"""
    shadow: "MeasuredSet | None" = None
    until_s: float = float("nan")
    """simulated time that was measured, s"""
    remarks: list[str] = dataclasses.field(default_factory=list)
    neutral: "MeasuredSet | None" = None
    """its neutral null, of which each run repeats the run that has its seed"""
    clones: "MeasuredSet | None" = None
    """runs in which all have one genome: shown next to the set, not tested against"""
    inherited: frozenset[str] = frozenset()
    """the names of its metrics of genomes, bodies and brains"""
    own: frozenset[str] = frozenset()
    """the names of the metrics of one's own"""

    one_sided: "dict[str, MeasuredSet]" = dataclasses.field(default_factory=dict)
    """by species the world in which it alone inherits nothing"""
    planned: int = 0
    """how many runs the lists of their folders name; 0 without a list"""

    @property
    def nulls(self) -> "dict[str, MeasuredSet]":
        """The sets of the shadow, the one-sided worlds, the neutral null and the clones, as far as there are any, by the names of their folders."""
        sides = ((one_sided_name(species), one) for species, one in self.one_sided.items())
        every = ((SHADOW, self.shadow), *sides, (NEUTRAL, self.neutral), (CLONES, self.clones))
        return {name: one for name, one in every if one is not None}

    def nulls_of(self, metric: Metric) -> "dict[str, MeasuredSet]":
        """The nulls of runs that a metric stands next to, by baseline: of the one-sided worlds that of its species, and the neutral null for what is
        inherited."""
        return {
            ONE_SIDED if one_sided_species(name) else name: one
            for name, one in self.nulls.items()
            if one_sided_species(name) in ("", metric.species) and (name != NEUTRAL or metric.metric in self.inherited)
        }

    def null_values(self, metric: Metric, name: str) -> numpy.ndarray:
        """The values of a metric in a null, one a run of it; those of the neutral null by the runs that they repeat, nan if there is none."""
        null = self.nulls_of(metric)[name]
        values = null.baseline(metric, "")
        if name != NEUTRAL:
            return values
        of_seed = dict(zip((run.seed for run in null.runs), values))
        return numpy.array([of_seed.get(run.seed, numpy.nan) for run in self.runs])

    @functools.cached_property
    def table(self) -> dict[tuple[Metric, str], numpy.ndarray]:
        """The values of each metric and baseline ("": observed), one a run, in the order of the runs' rows; nan in a run without one."""
        table: dict[tuple[Metric, str], numpy.ndarray] = {}
        for i, run in enumerate(self.values):
            for *name, baseline, value in zip(*(run.values[column] for column in [*METRIC, "baseline", "value"])):
                table.setdefault((Metric(*name), baseline), numpy.full(len(self.values), numpy.nan))[i] = value
        return table

    @functools.cached_property
    def roles(self) -> dict[tuple[Metric, str], str]:
        """The role of each metric's baselines."""
        roles: dict[tuple[Metric, str], str] = {}
        for run in self.values:
            for *name, baseline, role in zip(*(run.values[column] for column in [*METRIC, "baseline", "role"])):
                if baseline:
                    roles.setdefault((Metric(*name), baseline), role)
        return roles

    def metrics(self) -> list[Metric]:
        """The metrics of the runs, in the order of their rows."""
        return [metric for metric, baseline in self.table if not baseline]

    def matrix(self) -> pandas.DataFrame:
        """Observed values: rows runs, columns metrics, a MultiIndex named METRIC."""
        metrics = self.metrics()
        columns = pandas.MultiIndex.from_tuples(metrics, names=METRIC)
        return pandas.DataFrame(numpy.column_stack([self.table[metric, ""] for metric in metrics]), columns=columns)

    def baseline(self, metric: Metric, name: str) -> numpy.ndarray:
        """The values of a baseline, one a run; nan in a run without it."""
        return self.table.get((metric, name), numpy.full(len(self.values), numpy.nan))
