# SPDX-License-Identifier: MIT
"""The metrics of a run. Each module answers one question; measure_run puts their values into the order of all tables."""
from __future__ import annotations

import dataclasses
import difflib
import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy
import pandas

from ..errors import RunError
from ..runs import verify
from ..values import METRIC, Metric, RunValues
from ..words import number_text
from . import attribution, demography, living, locked, motion, own, stuck, tags, velocity, walls
from .own import OwnColumn, OwnMetric, metric
from .tables import Agents, Results, Web

if TYPE_CHECKING:
    from ..pool import PooledRun

__all__ = [
    "Agents",
    "Measuring",
    "OwnColumn",
    "OwnMetric",
    "Results",
    "Web",
    "chosen",
    "lost_to_thinning",
    "measure_run",
    "metric",
    "names",
    "shipped",
]

EVENTS = ("time_s", "event", "id", "species", "body", "origin", "cause", "victim_id")
AGENTS = (
    "time_s",
    "tick",
    "body",
    "id",
    "species",
    "origin",
    "active",
    "tag",
    "x_m",
    "y_m",
    "adversary_id",
    "hunger_ticks",
)
OPTIONAL = ("upright_speed", "overturned", "wall_contact", "velocity_upright", *living.OPTIONAL)
"""Left out if no run has a value, unless a choice names it."""
READINGS = {
    **dict.fromkeys(
        ("velocity_points", "velocity_stored", "velocity_simulated", "velocity_open", "velocity_upright"), "velocity"
    ),
    **{
        f"{metric}_not_locked": metric
        for metric in (
            "velocity",
            "wall_sticking",
            "wall_sticking_gap",
            "tag_symmetry",
            "attribution_caught",
            "attribution_catches",
        )
    },
    "search_rate_holling": "search_rate",
    "near_pairs": "locked",
    "near_longest": "locked",
    "upright_speed": "open_speed",
    "wall_contact": "wall_sticking",
}
"""Metrics that are another reading of a metric, which is tested for them."""
_INHERITED = ("modes_", "activity_", "body_", "brain_genes", "gait_genes", "kinds")


@dataclasses.dataclass
class Measuring:
    """How runs are measured."""

    until_s: float | None = None
    """Only the first seconds."""
    accept_other_build: bool = False
    columns: Sequence[OwnColumn | str] = ()
    """Columns of tables, as "FILE:COLUMN" or "FILE:COLUMN:UNIT"."""
    functions: Sequence = ()
    """Own metrics: functions of a Run."""
    bodies: bool = False
    """Measures of bodies, and no others but own ones."""
    kinds: Sequence[str] = ()
    """Measures of kinds by these loci, kinds.GENOME or columns of genomes.csv, and no others but own ones."""
    lineages: str | None = None
    """The program that made the runs, whose brains are asked: measures of lineages, and no others."""
    inputs: Sequence = ()
    """The inputs by which brains are compared for lineages, by species."""
    first: PooledRun | None = None
    """The run whose rule table has the brains that are asked for lineages; its nulls have the same."""
    window_s: float | None = None
    """The length of the windows of lineages, s."""
    jobs: int | None = None
    """Runs measured at a time; as many as there are cores if None. Results do not depend on it."""
    metrics: Sequence[str] = ()
    """Choices: METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP; all metrics if empty."""

    def __post_init__(self) -> None:
        self.columns = [own.own_column(column) for column in self.columns]
        self.functions = [own.own_metric(function) for function in self.functions]
        if self.until_s is not None and not 0 < self.until_s < math.inf:
            raise RunError(f"--until {number_text(self.until_s)}: must be > 0")
        if self.jobs is not None and self.jobs < 1:
            raise RunError(f"--jobs {self.jobs}: must be >= 1")


def shipped(
    web: Web,
    events: pandas.DataFrame,
    agents: pandas.DataFrame,
    *,
    until_s: float,
    floor: walls.Floor,
    every_ticks: int = 1,
    tag_values: Sequence[int] = (-1, 1),
    simulated_s_per_s: float = 1.0,
    is_constant: bool = True,
    causes: Sequence[str] = demography.CAUSES,
) -> Results:
    """All metrics of tables with the columns EVENTS and AGENTS, and what motion.with_contacts adds, for any number of species, in an order that
    depends only on the food web and the tags. A metric whose table has no row or lacks the ticks for it is there with the value nan.

    `until_s`: the time of the run that is measured, s. `every_ticks`: agents has the ticks that are
    multiples of it. `tag_values`: the tags that the brains may choose. `simulated_s_per_s`: simulated seconds in a second of the clock.
    `is_constant`: numbers are, so that extinction is measured here. `causes`: of death."""
    results = Results()
    robots = Agents(agents, web)
    locks = locked.locks(robots) if locked.TICKS % every_ticks == 0 else None
    is_free = ~locks.row if locks else numpy.zeros(len(agents), bool)
    free = Agents(agents[is_free], web)
    attribution.measure(events, locked.events_of_free(events, robots, ~is_free) if locks else events[:0], web, results)
    demography.measure_deaths(events, web, until_s, results, causes)
    velocity.measure(
        robots,
        web,
        every_ticks,
        results,
        simulated_s_per_s=simulated_s_per_s,
        free=is_free,
        is_open=walls.to_wall_m(robots, floor) > walls.REACH_M,
        is_upright=motion.is_upright(robots),
        is_constant=is_constant,
    )
    for rows, suffix in ((robots, ""), (free, "_not_locked")):
        walls.measure(rows, web, floor, results, suffix, is_constant)
        tags.measure(rows, web, tag_values, results, suffix)
    locked.measure(robots, web, locks, results)
    motion.measure(robots, web, floor, results)
    demography.measure_populations(robots, web, results)
    stuck.measure(robots, web, results)
    if is_constant:
        demography.measure_extinction(robots, web, results)
    return results


def measure_run(run: PooledRun, how: Measuring) -> RunValues:
    """Reads and measures a run. Raises RunError, naming the file, for a table that cannot be read or is not what the run wrote."""
    if how.lineages is not None:
        from . import lineages

        verify(run.path)
        return lineages.measure_run(run, how)  # type: ignore[arg-type]  # known since the runs were pooled
    status = run.manifest["status"]
    remarks = (
        [] if status == "complete" else [f'{run.path}/manifest.json: status "{status}": the run did not reach its end']
    )
    events, agents = run.load("events.csv", EVENTS, remarks), run.load("agents.csv", AGENTS, remarks)
    verify(run.path, ("events.csv", "agents.csv"))
    agents = motion.with_contacts(agents, run, remarks)
    if how.bodies:
        from . import bodies

        results = bodies.measure_run(run, events, agents)
    elif how.kinds:
        from . import kinds

        results = kinds.measure_run(run, how.kinds)
    else:
        is_constant = not living.changes_numbers(run)
        results = shipped(
            run.web,
            events,
            agents,
            until_s=run.lived_s,
            floor=run.floor,
            every_ticks=run.every_ticks,
            tag_values=run.tags,
            simulated_s_per_s=run.manifest["clock"].get("simulated_s_per_clock_s", 1.0),
            is_constant=is_constant,
            causes=_causes_of(run),
        )
        if not is_constant:
            living.measure(run, events, results)
    results.remarks[:0] = remarks
    shipped_rows = len(results.rows)
    for column in how.columns:
        own.measure_column(column, run, results)  # type: ignore[arg-type]
    for function in how.functions:
        own.measure_function(function, run, results)
    results.rows = results.rows[shipped_rows:] + results.rows[:shipped_rows]  # one's own stand first everywhere
    return results.run_values()


def _causes_of(run: PooledRun) -> Sequence[str]:
    """The causes of death that are measured: where numbers change those that can happen."""
    return demography.causes_in(run.manifest["rules"]) if living.changes_numbers(run) else demography.CAUSES


def lost_to_thinning(every: int) -> str:
    """Half a sentence about the metrics that a run loses if agents.csv has only the ticks that are multiples of `every`; empty if it loses
    none. All other metrics are means over ticks or come from events."""
    if every == 1:
        return ""
    lost = "no velocity_stored, which needs every tick"
    for name, apart in (
        ("velocity", velocity.TICKS),
        ("velocity_points", velocity.TICKS),
        ("locked", locked.TICKS),
        ("stuck", stuck.TICKS),
    ):
        if apart % every != 0:
            lost += f", no {name}, which needs rows {apart} ticks apart"
    return f"agents.csv: has only ticks that are multiples of {every}: {lost}"


def names(run: PooledRun, how: Measuring | None = None) -> list[Metric]:
    """The shipped metrics that a run is measured by, in the order of all tables."""
    if how is not None and how.lineages is not None:
        from . import lineages  # type: ignore[attr-defined]

        return lineages.metric_names(run.web.species)
    if how is not None and how.bodies:
        from . import bodies

        return bodies.names(run.web)
    if how is not None and how.kinds:
        from . import kinds

        return kinds.names(run.web)
    is_constant = not living.changes_numbers(run)
    return names_of(run.web, run.tags, is_constant, _causes_of(run)) + (
        [] if is_constant else living.names(run.web, living.has_energy(run))
    )


def inherited(of: Iterable[Metric], how: Measuring) -> frozenset[str]:
    """The names of the metrics of genomes, bodies and brains, whose null is the neutral one, among the shipped ones `of` and own ones. All others
    are of behaviour and numbers, or of descent, which the neutral null repeats."""
    return frozenset(
        {name.metric for name in of if name.metric.startswith(_INHERITED)}
        | {one.name for one in how.functions if one.inherited}
        | {one.column for one in how.columns if one.file in own.INHERITED}
    )  # type: ignore[union-attr]


def names_of(
    web: Web, tag_values: Sequence[int] = (-1, 1), is_constant: bool = True, causes: Sequence[str] = demography.CAUSES
) -> list[Metric]:
    """The metrics of a run of these species and tags, in the order of all tables, without those of changing numbers."""
    nothing = [pandas.DataFrame(columns=list(columns), dtype=float) for columns in (EVENTS, AGENTS)]
    found = shipped(
        web,
        *nothing,
        until_s=0.0,
        floor=walls.Floor(1.0),
        tag_values=tag_values,
        is_constant=is_constant,
        causes=causes,
    )
    return [Metric(*row[:4]) for row in found.rows if row[4] == ""]


def check_names(shipped_names: Sequence[Metric], how: Measuring) -> None:
    """Raises RunError unless own metrics have names of their own and each choice names a metric, before anything is measured."""
    own.check(how.columns, how.functions, [name.metric for name in shipped_names])  # type: ignore[arg-type]
    own_names = [*(column.column for column in how.columns), *(function.name for function in how.functions)]  # type: ignore[union-attr]
    # The species and groups of an own metric are known when it is measured.
    others = [choice for choice in how.metrics if choice.split(":")[0] not in own_names]
    chosen([*shipped_names, *(Metric(name, "", "all", "1") for name in own_names)], others)


def chosen(of: Iterable[Metric], choices: Sequence[str]) -> list[Metric]:
    """Those that any of the choices names, all if there is no choice, in their order. Raises RunError, with the names of all metrics, for a
    choice that names none."""
    of = list(of)

    def chooses(choice: str, name: Metric) -> bool:
        parts = choice.split(":")
        return tuple(parts) == name[:3][: len(parts)]

    for choice in choices:
        if not any(chooses(choice, name) for name in of):
            words = dict.fromkeys(
                word for name in of for word in (name.metric, f"{name.metric}:{name.species}", str(name))
            )
            near = difflib.get_close_matches(choice, words, 1)
            known = ", ".join(dict.fromkeys(name.metric for name in of))
            hint = f"; did you mean {near[0]}?" if near else ""
            raise RunError(f"metric {choice}: must be METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP of {known}{hint}")
    return [name for name in of if not choices or any(chooses(choice, name) for choice in choices)]


def kept(has_value: Mapping[Metric, bool], choices: Sequence[str]) -> list[Metric]:
    """The metrics that are shown, given whether any run has a value of each: not the extinction of a species that dies out in no run, nor one of
    OPTIONAL or of inactive members without a value, unless a choice names it."""
    asked = {choice.split(":")[0] for choice in choices}
    gone = {of.species for of, value in has_value.items() if of.metric == "extinct_at" and value}
    return [
        of
        for of, value in has_value.items()
        if of.metric in asked
        or (
            of.species in gone
            if of.metric in demography.EXTINCTION
            else value or of.metric not in OPTIONAL and "inactive" not in of.group
        )
    ]


def same_metrics(runs: Sequence[RunValues], choices: Sequence[str] = ()) -> None:
    """Makes all runs measure the same, as far as `kept` keeps it: what one lacks, such as a species of an own column, it gets without a value."""
    values = pandas.concat([run.values for run in runs])
    has_value = values[values.baseline == ""].groupby(METRIC, sort=False).value.count() > 0
    its = {Metric(*name): value for name, value in has_value.items()}
    stay = {of[:3] for of in kept(its, choices)}
    if leave := [of[:3] for of in its if of[:3] not in stay]:
        for run in runs:
            run.values, run.curves = (
                frame[~pandas.MultiIndex.from_frame(frame[METRIC[:3]]).isin(leave)].reset_index(drop=True)
                for frame in (run.values, run.curves)
            )
    keys = [*METRIC, "baseline", "role"]
    if all(run.values[keys].equals(runs[0].values[keys]) for run in runs):
        return
    every = pandas.concat([run.values[keys] for run in runs]).drop_duplicates(ignore_index=True)
    for run in runs:
        run.values = every.merge(run.values, how="left", on=keys)
