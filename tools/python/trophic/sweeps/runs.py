# SPDX-License-Identifier: MIT
"""The runs of a sweep: compared with its plan before any is measured, and measured."""
from __future__ import annotations

import dataclasses
import importlib.util
import json
import pathlib
import shlex
from collections.abc import Sequence

import numpy

from .. import metrics, pool
from ..errors import RunError
from ..metrics import Measuring, kept, own
from ..metrics.living import changes_numbers
from ..pool import PooledRun
from ..runs import listed, sealed
from ..values import METRIC, Metric, RunValues
from ..words import number_text
from .cells import SweepValues
from .grid import PLAN, Grid, PlannedRun, grid_of, is_paired, read_plan

MOST_NAMED = 10


@dataclasses.dataclass
class Sweep:
    """A sweep on the disk. It keeps the manifests of few runs: there may be tens of thousands."""

    folder: pathlib.Path
    plan: list[PlannedRun]
    grid: Grid
    is_there: list[bool]
    """of each planned run: complete, as planned"""
    missing: list[str]
    """a sentence for each that is not"""
    builds: list[str]
    """codes of the programs that made the runs"""
    first_of_web: list[PooledRun]
    """a run of each food web"""

    def folder_of(self, run: int) -> pathlib.Path:
        return self.folder / self.plan[run].folder

    def there(self) -> list[int]:
        return [place for place, is_there in enumerate(self.is_there) if is_there]

    def count(self, kind: str, cell: int) -> int:
        """How many of a cell's runs, or of their shadows, are there. `cell`: its place in the grid."""
        places = (getattr(one, kind) for one in self.grid.cells[cell].replicates)
        return sum(place is not None and self.is_there[place] for place in places)

    def missing_line(self) -> str:
        """The missing runs in one line, of many the first few, and the cells that have no run at all."""
        more = len(self.missing) - MOST_NAMED
        empty = [str(cell.number) for place, cell in enumerate(self.grid.cells) if self.count("run", place) == 0]
        named = ", ".join(empty[:MOST_NAMED]) + (", ..." if len(empty) > MOST_NAMED else "")
        return (
            f"{len(self.missing)} of {len(self.plan)} runs missing: {'; '.join(self.missing[:MOST_NAMED])}"
            + (f"; and {more} more" if more > 0 else "")
            + (f"; no run at all of {len(empty)} of {len(self.grid.cells)} cells: {named}" if empty else "")
        )

    def finished_by(self) -> str:
        """The command that makes the runs that are missing, those of the cells with the fewest runs first."""
        made = next((run.manifest.get("command_line", "") for run in self.first_of_web), "")
        program = made.split(" --plan ")[0] if " --plan " in made else "PROGRAM"
        return f"{program} --plan {shlex.quote(str(self.folder / PLAN))} makes them"


def is_sweep(folder: pathlib.Path) -> bool:
    return (folder / PLAN).exists()


def read_sweep(folder: pathlib.Path, accept_other_build: bool = False) -> Sweep:
    """Reads a sweep's plan and compares every run's manifest with it. Raises RunError for a broken plan, for a fingerprint, seed or duration that
    is not the planned one, for a shadow that is none, for runs that several builds of a program made unless `accept_other_build`, and if there are no runs. Runs that are missing or incomplete go to `missing`.
    """
    plan = read_plan(folder / PLAN)
    _check_beside(folder, plan)
    sweep = Sweep(folder, plan, grid_of(plan), [], [], [], [])
    webs: set[str] = set()
    builds: set[str] = set()
    for planned in plan:
        run, why = _run_of(sweep, planned)
        sweep.is_there.append(not why)
        if run is None or why:
            sweep.missing.append(f"run {planned.index} ({planned.folder}): {why}")
            continue
        builds.update(run.builds)
        web = json.dumps([run.manifest["species"], run.manifest["food_web"], run.manifest.get("tags")])
        if web not in webs:
            webs.add(web)
            sweep.first_of_web.append(run)
    sweep.builds = sorted(builds)
    if len(builds) > 1 and not accept_other_build:
        raise RunError(
            f"{folder}: its runs were made by {pool.builds_text(sweep.builds)}; rules may have the same names but other code in different builds: "
            "--accept-other-build pools them"
        )
    if not webs:
        raise RunError(f"{folder}: has no complete run; {sweep.missing[0]} ({sweep.finished_by()})")
    for cell in sweep.grid.cells:  # the first shadow of each
        for one in cell.replicates:
            if (
                one.run is not None
                and one.shadow is not None
                and sweep.is_there[one.run]
                and sweep.is_there[one.shadow]
            ):
                pool.check_shadow(
                    pool.read_pooled(sweep.folder_of(one.run)), pool.read_pooled(sweep.folder_of(one.shadow))
                )
                break
    return sweep


def _check_beside(folder: pathlib.Path, plan: Sequence[PlannedRun]) -> None:
    """Raises RunError, naming the file, unless sweep.toml and each replicates.json, as far as they are there, are of the plan."""
    file = folder / "sweep.toml"
    if file.exists() and importlib.util.find_spec("tomllib"):
        from .. import plan as planning

        sweep = planning.read_sweep(file)
        cells = {_text(cell) for cell in planning.settings_of(sweep)}
        if cells != {_text(run.settings) for run in plan}:
            raise RunError(f"{file}: has other settings than {PLAN}: it was modified after the plan was made")
        for run in plan:
            master_seed = sweep.seed if sweep.paired else planning.seed_of(sweep.seed, run.cell)
            here = (planning.seed_of(master_seed, run.replicate), sweep.replay_hz, sweep.agents_every)
            if run.replicate >= sweep.replicates or (run.seed, run.replay_hz, run.agents_every) != here:
                raise RunError(
                    f"{file}: has other replicates, seeds or tables than {PLAN}: it was modified after the plan was made"
                )
    planned: dict[pathlib.Path, list[PlannedRun]] = {}
    for run in plan:
        planned.setdefault(pathlib.Path(run.folder).parent, []).append(run)
    for place, runs in planned.items():
        if listed(folder / place) is None:
            continue
        file = folder / place / "replicates.json"
        content = sealed(file)
        seeds = {one["folder"]: one.get("seed") for one in content["replicates"]}
        for run in runs:
            if seeds.get(pathlib.Path(run.folder).name) != run.seed or content.get("fingerprint") != run.fingerprint:
                raise RunError(
                    f"{file}: must list {pathlib.Path(run.folder).name} with its seed and fingerprint, as {PLAN}"
                )


def _text(value: object) -> str:
    return json.dumps(value, sort_keys=True)


def _run_of(sweep: Sweep, planned: PlannedRun) -> tuple[PooledRun | None, str]:
    """A planned run, and why it is missing. Raises RunError if another run is in its place."""
    folder = sweep.folder_of(planned.index)
    if not folder.exists():
        return None, "no such folder"
    if not (folder / "manifest.json").exists():
        return None, "no manifest.json"
    try:
        run = pool.read_pooled(folder)
    except RunError as error:
        return None, str(error)
    for field, there, wanted in (
        ("fingerprint", run.fingerprint, planned.fingerprint),
        ("seed", str(run.seed), str(planned.seed)),
        ("until_s", number_text(run.until_s), number_text(planned.until_s)),
    ):
        if there != wanted:
            raise RunError(
                f"{folder}/manifest.json: {field} = {there}: must be {wanted}, as the plan has it for run {planned.index}"
            )
    return run, "" if run.complete else f'status "{run.manifest["status"]}", must be "complete"'


def check_sweep(sweep: Sweep, reference: int, allow_missing: bool, how: Measuring) -> None:
    """Raises RunError for everything that can be known of a sweep without measuring it."""
    place = sweep.grid.place(reference, "--reference ")
    for cell in sweep.grid.cells:
        is_paired(sweep.grid.cells[place], cell)
    first_s = sweep.plan[0].until_s
    for run in sweep.plan:
        here = f"{sweep.folder_of(run.index)}: {number_text(run.until_s)} s"
        if how.until_s is not None and run.until_s < how.until_s:
            raise RunError(f"{here}: must be >= {number_text(how.until_s)} s, as --until asks")
        if how.until_s is None and run.until_s != first_s:
            raise RunError(
                f"{here}, but {sweep.folder_of(0)} has {number_text(first_s)} s; runs of different length are not compared: use --until"
            )
    if sweep.missing and not allow_missing:
        raise RunError(f"{sweep.folder}: {sweep.missing_line()} ({sweep.finished_by()}; --allow-missing omits them)")
    for run in _Runs(sweep, how) if how.columns else ():
        for column in how.columns:
            own.check_column(column, run)  # type: ignore[arg-type]
    if sweep.count("run", place) == 0:
        raise RunError(f"--reference {reference}: must be a cell that has a complete run")
    metrics.check_names(_shipped(sweep, how), how)


def _shipped(sweep: Sweep, how: Measuring) -> list[Metric]:
    """The metrics of the runs' food webs, each once, in the order of the first one."""
    return list(dict.fromkeys(name for run in sweep.first_of_web for name in metrics.names(run, how)))


class _Runs(Sequence):
    """The runs that are there, each read when it is asked for."""

    def __init__(self, sweep: Sweep, how: Measuring):
        self.sweep, self.places, self.until_s = sweep, sweep.there(), how.until_s

    def __len__(self) -> int:
        return len(self.places)

    def __getitem__(self, place):
        run = pool.read_pooled(self.sweep.folder_of(self.places[place]))
        return run if self.until_s is None else dataclasses.replace(run, until_s=self.until_s)


def measure_sweep(sweep: Sweep, how: Measuring) -> tuple[SweepValues, list[str]]:
    """Measures the runs that are there; returns their observed values, and remarks in the order of the plan. A metric that a run of another food
    web does not have has no value there; those that metrics.kept leaves out are not there.
    Raises RunError for the first run in the plan's order that cannot be measured, with its index.
    """
    runs = _Runs(sweep, how)
    try:
        found = pool.measure(runs, how, _observed)
    except RunError as error:
        for place in runs.places:
            if str(error).startswith(f"{sweep.folder_of(place)}/"):
                raise RunError(f"run {place}: {error}") from None
        raise
    names = {
        name: number
        for number, name in enumerate(
            dict.fromkeys([*_shipped(sweep, how), *(name for values, _ in found for name in values)])
        )
    }
    values = numpy.full((len(sweep.plan), len(names)), numpy.nan)
    remarks = []
    for place, (of_run, its) in zip(runs.places, found):
        values[place, [names[name] for name in of_run]] = list(of_run.values())
        remarks += its
    has_value = {name: not numpy.isnan(values[:, number]).all() for name, number in names.items()}
    first = {run.cell: run.index for run in reversed(sweep.plan) if sweep.is_there[run.index]}
    is_constant = not any(changes_numbers(pool.read_pooled(sweep.folder_of(place))) for place in first.values())
    if not is_constant and any(run.shadow for run in sweep.plan):
        remarks.append(
            "numbers change: shadows do not control for one species, so cells are compared raw; trophic analyze judges a cell over its "
            "one-sided worlds"
        )
    measured = SweepValues(list(names), values, sweep.is_there, is_constant)
    return measured.only(kept(has_value, how.metrics)), list(dict.fromkeys(remarks))


def _observed(run: RunValues) -> tuple[dict[Metric, float], list[str]]:
    values = run.values[run.values["baseline"] == ""]
    return dict(zip(map(Metric._make, values[METRIC].itertuples(index=False, name=None)), values["value"])), run.remarks
