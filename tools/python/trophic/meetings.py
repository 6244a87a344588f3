# SPDX-License-Identifier: MIT
"""Contests of brains that one names, such as a trained network, against the evolved opponents of some runs."""
from __future__ import annotations

import dataclasses
import os
import pathlib
import tempfile
from collections.abc import Mapping
from typing import Any

import numpy
import pandas

from . import contest_plan, pool
from .errors import RunError
from .metrics import Measuring
from .programs import program_of_table
from .runs import verify
from .statistics import Difference, adjust_together, contrast, difference_of, estimate
from .words import columns, p_text


@dataclasses.dataclass
class Meeting:
    """Contact times of teams with the opponents of each run, s. For hunters less is better, for victims more."""

    times_s: pandas.DataFrame
    """a row for each run, whose opponents all teams met at the same places; a column for each of the brains"""
    species: str
    role: str
    """hunter or victim"""

    def differences(self, reference: str) -> dict[str, Difference]:
        """Of each of the other brains from `reference`, run by run, corrected together (Holm, Bonferroni). Without interval and test if there are
        fewer runs than a test needs."""
        found = {}
        for name in self.times_s.columns.drop(reference):
            of = (self.times_s[name] - self.times_s[reference]).to_numpy()
            found[name] = difference_of(float(of.mean()), contrast((1.0, of)))
        adjust_together(found.values())
        return found

    def text(self, reference: str) -> str:
        """A line for each of the brains: mean contact time and interval over runs, and the difference from `reference`."""
        rows: list[tuple[str, ...]] = [(self.species, "contact, s [95 %]", f"minus {reference} [95 %]", "p (Holm)")]
        others = self.differences(reference)
        for name in self.times_s.columns:
            mean = estimate(self.times_s[name].to_numpy())
            of = others.get(name, Difference())
            rows.append(
                (
                    name,
                    _with(mean.mean, mean.interval),
                    _with(of.value, of.corrected or of.interval),
                    p_text(of.adjusted),
                )
            )
        better = "less" if self.role == "hunter" else "more"
        return columns(rows) + f"{len(self.times_s)} runs; for {self.role}s {better} is better\n"


def _with(value: float | None, interval: tuple[float, float] | None) -> str:
    if value is None:
        return "-"
    ends = "" if interval is None else f" [{interval[0]:.1f}, {interval[1]:.1f}]"
    return f"{value:.1f}{ends}"


def meet(
    runs: Any,
    species: str,
    brains: Mapping[str, Any],
    *,
    teams: int = 6,
    team_size: int | None = None,
    duration_s: float = 300.0,
    reach_m: float = 1.0,
    seed: int = 1,
    program: str | os.PathLike | None = None,
    jobs: int | None = None,
) -> Meeting:
    """Lets teams of a species meet the last living opponents of each run, in the contests of `trophic contest` (docs/how-to/contests.md).

    `runs`: Runs or their folder, of one rule table with one link between hunters and victims. `brains` maps a name to weights of the table's brain,
    an array that all members of all teams have, or a list of arrays, which the teams of all runs take in turn, one each: give as many as there are
    teams, so that intervals over runs hold for such brains and not for a few of them. None stands for the last living of the species in the next
    run, which have never met these opponents. All brains meet the same opponents at the same places. `teams` meet those of a run, of `team_size`
    robots each (default: half of the table's). `program` plays (default: the shipped one that has the table). Raises RunError.
    """
    paths = [pathlib.Path(getattr(runs, "path", runs))]
    pooled, _ = pool.pooled_runs(paths, Measuring())
    for run in pooled:
        verify(run.path)
    first = pooled[0]
    links = [link for link in first.web.links if species in link]
    if len(links) != 1:
        raise RunError(f"species = {species}: must be a hunter or a victim of one other species of {first.path}")
    hunter, victim = links[0]
    opponent = victim if species == hunter else hunter
    if any(of is None for of in brains.values()) and len(pooled) < 2:
        raise RunError("brains = None: needs at least two runs, because individuals meet the opponents of another run")
    names = list(first.manifest["species"])
    size = team_size or max(1, first.manifest["params"]["ecology"]["robots"] // 2)
    living = [contest_plan.living_genomes(run, [run.reached_s or 0.0])[0] for run in pooled]

    def drawn(replicate: int, of: str, team: int) -> list:
        if not living[replicate].get(of):
            raise RunError(f"{pooled[replicate].path}: no {of} is alive at the end")
        all_ = living[replicate][of]
        return [
            all_[one] for one in contest_plan.members(seed, (replicate, 0, 0, names.index(of), team), len(all_), size)
        ]

    def chosen(of: Any, replicate: int, team: int) -> list:
        own = drawn((replicate + 1) % len(pooled), species, team)
        if of is None:
            return own
        weights = of if isinstance(of, numpy.ndarray) else of[(replicate * teams + team) % len(of)]
        if len(own[0][0]) != len(weights):
            raise RunError(f"brains: {len(weights)} weights: must be {len(own[0][0])}, those of the table's brain")
        return [[[float(one) for one in weights], *own[0][1:]] for _ in range(size)]

    planned = contest_plan.Planned()
    for replicate in range(len(pooled)):
        for team in range(teams):
            theirs = len(planned.teams)
            planned.teams.append({"species": names.index(opponent), "genomes": drawn(replicate, opponent, team)})
            for name, of in brains.items():
                ours = len(planned.teams)
                planned.teams.append({"species": names.index(species), "genomes": chosen(of, replicate, team)})
                pair = [ours, theirs] if species == hunter else [theirs, ours]
                planned.matches.append([*pair, contest_plan.places(seed, replicate, team)])
                planned.rows.append({"run": str(pooled[replicate].path), "brains": name})
    plan = contest_plan.plan_for(first, duration_s, reach_m, planned)
    named = program or program_of_table(contest_plan.table_of(first))
    with tempfile.TemporaryDirectory() as folder:
        outcomes = contest_plan.play(plan, str(named), jobs or os.cpu_count() or 1, pathlib.Path(folder))
    rows = pandas.DataFrame([{**row, "contact_s": outcome[0]} for row, outcome in zip(planned.rows, outcomes)])
    times = rows.groupby(["run", "brains"])["contact_s"].mean().unstack()[list(brains)]
    return Meeting(times, species, "hunter" if species == hunter else "victim")
