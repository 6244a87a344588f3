# SPDX-License-Identifier: MIT
"""The bodies, gaits and brains of a run: their shape, their size, their number, and how fast they walk.

Each is measured among those alive at the ends of windows of 200 s, or of a twentieth of a shorter run, as means over the windows of the early
and of the late half of the run, and as curves. A measure whose table the run lacks has no value."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy
import pandas

from ..errors import RunError
from ..runs import Run
from ..values import Metric
from . import motion
from .plans import distances_from_first
from .tables import Agents, Results, Web, mean_of, numbers

if TYPE_CHECKING:
    from ..pool import PooledRun

_WINDOW_S = 200.0
_WINDOWS_OF_A_SHORT_RUN = 20
_SHAPES = {
    "size": "1",
    "proportion": "1",
    "coverage": "1",
    "branching": "1",
    "limbs": "1",
    "length_of_limbs": "1",
    "symmetry": "1",
    "joints": "1",
    "modules": "1",
    "hinges": "1",
    "mass_kg": "kg",
}
"""Columns of bodies.csv that are measures, with their units: the descriptors of docs/bodies.md, modules, hinges and mass."""
_MEASURES = {
    **{f"body_{column.removesuffix('_kg')}": unit for column, unit in _SHAPES.items()},
    # different plans, their Shannon number, and the tree edit distance from the plan of the species' first individual
    "body_plans": "1",
    "body_plans_shannon": "1",
    "body_change": "1",
    "brain_genes": "1",
    "gait_genes": "1",
    "walked": "m/s",
    "open_speed": "m/s",
    "upright_speed": "m/s",
    "overturned": "1",
    "wall_contact": "1",
}


def check(run: Run) -> None:
    """Raises RunError, naming the folder, unless the run has bodies.csv or genes.csv: a run has them if bodies, gaits or brains differ."""
    if not any((run.path / file).exists() for file in ("bodies.csv", "genes.csv")):
        raise RunError(
            f"{run.path}: has neither bodies.csv nor genes.csv; --bodies measures runs in which bodies, gaits or brains differ"
        )


def names(web: Web) -> list[Metric]:
    """The metrics, in the order of all tables."""
    return [
        Metric(metric, species, group, unit)
        for species in web.species
        for metric, unit in _MEASURES.items()
        for group in ("early", "late")
    ]


def measure_run(run: PooledRun, events: pandas.DataFrame, agents: pandas.DataFrame) -> Results:
    """Measures a run. Raises RunError for a table that is cut or was changed after the run."""
    check(run)
    end_s = run.lived_s
    window_s = min(_WINDOW_S, end_s / _WINDOWS_OF_A_SHORT_RUN)
    times_s = numpy.minimum(
        numpy.arange(1, int(end_s / window_s * (1 + 1e-12)) + 1) * window_s if window_s > 0 else numpy.empty(0), end_s
    )
    robots = Agents(agents, run.web)
    lives = _lives(events).join(_bodies(run)).join(_genes(run))
    results = Results()
    for species in run.web.species:
        curves = {
            metric: (times_s, points) for metric, points in _alive(lives[lives.species == species], times_s).items()
        }
        if len(times_s):
            curves.update(
                {metric: of[2:] for metric, of in motion.curves(robots, species, run.floor, window_s).items()}
            )
        for metric, unit in _MEASURES.items():
            time_s, points = curves.get(metric, (times_s, times_s))
            is_early = 2.0 * time_s <= end_s
            for group, chosen in (("early", is_early), ("late", ~is_early)):
                results.add(metric, species, group, unit, mean_of(points[chosen]))
            results.add_curve(metric, species, "all", unit, time_s, points)
    return results


def shannon_number(individuals: numpy.ndarray) -> float:
    """The Shannon number of kinds, given the individuals of each: exp(-sum p ln p), Hill's number of order 1. Equal to the number of kinds if
    all are as frequent; 0 without individuals."""
    share = individuals[individuals > 0] / max(1, individuals.sum())
    return float(numpy.exp(-(share * numpy.log(share)).sum())) if len(share) else 0.0


def _alive(lives: pandas.DataFrame, times_s: numpy.ndarray) -> dict[str, numpy.ndarray]:
    """The measures of those alive at these times."""
    born, died = lives.birth_s.to_numpy(), lives.death_s.to_numpy()
    columns = [column for column in lives.columns if column in _MEASURES]
    values, plan = lives[columns].to_numpy(float), lives.plan.to_numpy(float)
    curves = {metric: numpy.full(len(times_s), numpy.nan) for metric in _MEASURES}
    for place, time_s in enumerate(times_s):
        alive = (born <= time_s) & (died > time_s)
        for column, of in zip(columns, values[alive].T):
            curves[column][place] = mean_of(of)
        _, counts = numpy.unique(plan[alive & ~numpy.isnan(plan)], return_counts=True)
        if len(counts):
            curves["body_plans"][place], curves["body_plans_shannon"][place] = len(counts), shannon_number(counts)
    return curves


def _lives(events: pandas.DataFrame) -> pandas.DataFrame:
    """Species, birth and death of each individual, by id."""
    births, deaths = (
        events[events.event == kind].drop_duplicates("id", keep="last").set_index("id") for kind in ("birth", "death")
    )
    return pandas.DataFrame(
        {
            "species": births.species.astype(str),
            "birth_s": births.time_s.astype(float),
            "death_s": deaths.time_s.reindex(births.index).fillna(numpy.inf),
        }
    )


def _bodies(run: PooledRun) -> pandas.DataFrame:
    """The measures of each individual's body, and its plan, by id."""
    columns = [f"body_{column.removesuffix('_kg')}" for column in _SHAPES]
    path = run.path / "bodies.csv"
    if not path.exists():
        return pandas.DataFrame(columns=[*columns, "plan", "body_change"], dtype=float)
    table = _whole(run, "bodies.csv", ["id", "species", "modules_text", *_SHAPES])
    frame = pandas.DataFrame(
        {name: numbers(path, table[column]) for name, column in zip(columns, _SHAPES)},
        index=numbers(path, table["id"]).astype(int),
    )
    frame["plan"] = pandas.factorize(table["modules_text"])[0]
    try:
        frame["body_change"] = distances_from_first(
            frame.index.tolist(), table["species"].tolist(), table["modules_text"].tolist()
        )
    except ValueError as error:
        raise RunError(f"{path}: {error}") from None
    return frame


def _genes(run: PooledRun) -> pandas.DataFrame:
    """The number of genes of each individual's brain and gait, by id."""
    if not (run.path / "genes.csv").exists():
        return pandas.DataFrame(columns=["brain_genes", "gait_genes"], dtype=float)
    table = _whole(run, "genes.csv", ["id", "part"])
    ids = numbers(run.path / "genes.csv", table["id"]).astype(int)
    return pandas.DataFrame(
        {
            f"{part}_genes": pandas.Series((table["part"] == part).to_numpy(float)).groupby(ids).sum()
            for part in ("brain", "gait")
        }
    )


def _whole(run: PooledRun, file: str, columns: Sequence[str]) -> pandas.DataFrame:
    remarks: list[str] = []
    table = run.texts(file, columns, (), remarks)
    if remarks:
        raise RunError(f"{run.path / file}: the last line is truncated; resume the run")
    return table
