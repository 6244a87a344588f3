# SPDX-License-Identifier: MIT
"""Worlds whose numbers change: whether species persist, their cycles, what hunters catch, energy from level to level, births and descent, and what
a well-mixed world of the same rates would have."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy
import pandas

from ..values import Metric
from . import mean_field
from .census import Census, dynamics, extinctions, responses
from .tables import WINDOW_S, Results, Web, means, window_of

if TYPE_CHECKING:
    from ..pool import PooledRun

OPTIONAL = (
    "period",
    "amplitude",
    "phase",
    "generation_time",
    "parents",
    "search_rate",
    "search_rate_holling",
    "handling_time",
    "trophic_efficiency",
)
MEAN_FIELD = "mean_field"
"""The baseline: the mean over simulated runs without space."""


def measure(run: PooledRun, events: pandas.DataFrame, results: Results) -> None:
    """Adds the metrics of a run; energy only of one with energy.csv."""
    lived_s = (
        run.lived_s if run.end_s is not None else min(run.until_s, float(events.time_s.max()) if len(events) else 0.0)
    )
    census = Census(events, run.web, run.manifest["clock"]["tick_s"], lived_s)
    until_s = run.until_s if run.complete else lived_s
    most = int(run.manifest.get("params", {}).get("ecology", {}).get("robots", 1_000_000))
    _measure_numbers(census, mean_field.means_of(census, most, run.seed, until_s), run.seed, until_s, results)
    has_newcomers = _measure_descent(census, run, results)
    area_m2 = (2.0 * run.floor.half_side_m) ** 2
    for (hunter, prey), met in zip(run.web.links, census.meetings()):
        attack, reciprocal, handling_s = responses(met[0] / area_m2, *met[1:])
        by_holling = (
            1.0 / reciprocal if reciprocal * attack > 0.1 else math.nan
        )  # else the density varies too little to know it
        for name, unit, value in (
            ("search_rate", "m2/s", attack),
            ("search_rate_holling", "m2/s", by_holling),
            ("handling_time", "s", handling_s),
        ):
            results.add(name, f"{prey}+{hunter}", "all", unit, value)
    if has_energy(run):
        _measure_energy(census, run, has_newcomers, results)


def changes_numbers(run: PooledRun) -> bool:
    return has_energy(run) or "recruitment" in (run.manifest.get("rules") or ())


def has_energy(run: PooledRun) -> bool:
    return "metabolism" in (run.manifest.get("rules") or ()) and (run.path / "energy.csv").exists()


def names(web: Web, has_energy: bool) -> list[Metric]:
    """The metrics of a run with these species, in the order of all tables."""
    pairs = [f"{prey}+{hunter}" for hunter, prey in web.links]
    of = [
        ("persists", "1", ["all", *web.species]),
        ("extinct_at", "s", web.species),
        ("cycles", "1", web.species),
        ("period", "s", web.species),
        ("amplitude", "1", web.species),
        ("phase", "1", pairs),
        ("birth_rate", "1/s", web.species),
        ("generation_time", "s", web.species),
        ("parents", "1", web.species),
        ("lineage_depth", "births", web.species),
        ("search_rate", "m2/s", pairs),
        ("search_rate_holling", "m2/s", pairs),
        ("handling_time", "s", pairs),
    ]
    if has_energy:
        of += [
            ("stock", "J", web.species),
            ("trophic_efficiency", "1", web.species),
            ("pyramid_numbers", "1", pairs),
            ("pyramid_energy", "1", pairs),
        ]
    return [Metric(name, one, "all", unit) for name, unit, its in of for one in its]


def _measure_numbers(
    census: Census, field: dict[tuple[str, str], float], seed: int, until_s: float, results: Results
) -> None:
    """`until_s`: the planned end. After an early end a species that was gone stays so; nothing is known of one that lived."""

    def add(name: str, species: str, unit: str, value: float) -> None:
        null = field.get((name, species), math.nan)
        results.add(
            name, species, "all", unit, value, ((MEAN_FIELD, "reference", null),) if name in mean_field.METRICS else ()
        )

    found = [dynamics(series, seed) for series in census.numbers]
    window = window_of(census.time_s)
    alive = {one: census.time_s < gone * census.tick_s for one, (gone, _) in zip(census.web.species, found)}
    never = {one for one, series in zip(census.web.species, census.numbers) if not series.any()}
    last = numpy.flatnonzero(numpy.diff(window, append=-1))
    later = WINDOW_S * numpy.arange(window[-1] + 2, math.ceil(until_s / WINDOW_S) + 1)
    is_early = census.time_s[-1] + census.tick_s < until_s
    for one, lives in {"all": numpy.logical_and.reduce([*alive.values()]), **alive}.items():
        add("persists", one, "1", math.nan if one in never or is_early and lives[-1] else float(lives[-1]))
        rest = later[:0] if lives[-1] else later
        results.add_curve(
            "persists",
            one,
            "all",
            "1",
            numpy.append((window[last] + 1) * WINDOW_S, rest),
            numpy.append(lives[last], 0.0 * rest),
        )
    for name, unit, values in (
        ("extinct_at", "s", [gone * census.tick_s if math.isfinite(gone) else math.nan for gone, _ in found]),
        ("cycles", "1", [cycle.is_there for _, cycle in found]),
        ("period", "s", [cycle.period * census.tick_s for _, cycle in found]),
        ("amplitude", "1", [cycle.amplitude for _, cycle in found]),
    ):
        for one, value in zip(census.web.species, values):
            add(name, one, unit, value)
    for (hunter, prey), (predator, victim) in zip(census.web.links, census.links):
        results.add(
            "phase",
            f"{prey}+{hunter}",
            "all",
            "1",
            phase(census.numbers[victim], census.numbers[predator], found[victim][1].period),
        )


def phase(first: numpy.ndarray, second: numpy.ndarray, period: float) -> float:
    """Returns by which share of the period, from -0.25 to 0.75, a second series follows the first: where they correlate most. nan without a period."""
    ends = min(int(extinctions(series)) for series in (first, second))
    if math.isnan(period) or ends - len(first) // 4 < 2 * period:
        return math.nan
    a, b = (series[len(series) // 4 : ends] - series[len(series) // 4 : ends].mean() for series in (first, second))
    lags = numpy.arange(-int(0.25 * period), int(0.75 * period) + 1)
    step = max(1, len(lags) // 100)
    products = [
        (a[max(0, -lag) : len(a) - max(0, lag)] * b[max(0, lag) : len(b) - max(0, -lag)]).mean()
        for lag in lags[::step].tolist()
    ]
    return float(lags[::step][int(numpy.argmax(products))] / period)


def _measure_descent(census: Census, run: PooledRun, results: Results) -> bool:
    """`birth_rate`: births without founders, by the time that all members lived. `generation_time`: age of parents at birth, over parents and births.
    A run that did not reach its end has only the first, as its phylogeny lacks who lived. Returns whether newcomers without parents were born.
    """
    table = run.texts("phylogeny.csv", ["id", "ancestor_list", "origin_time", "species"], (), results.remarks)
    table = table.assign(id=table.id.astype("int64"), born_s=table.origin_time.astype(float)).sort_values("id")
    table = table[(table.born_s <= run.until_s) & run.complete]
    parents = [
        [int(one) for one in text.strip("[]").split(",") if one not in ("", "none")] for text in table.ancestor_list
    ]
    born_s = dict(zip(table.id, table.born_s))
    depth: dict[int, int] = {}
    for one, its in zip(table.id, parents):
        depth[one] = max((depth.get(parent, 0) + 1 for parent in its), default=0)  # a branch lacks who died before it
    frame = pandas.DataFrame(
        {
            "species": table.species,
            "depth": [*depth.values()],
            "parents": [len(its) for its in parents],
            "born_s": table.born_s,
            "ages_s": [
                sum(time_s - born_s.get(parent, math.nan) for parent in its)
                for its, time_s in zip(parents, table.born_s)
            ],
        }
    )
    born = frame[frame.born_s > 0.0]
    lived_s = census.numbers[:, :-1].sum(axis=1) * census.tick_s
    of = {species: born[born.species == species] for species in run.web.species}
    for species, its_s, births in zip(run.web.species, lived_s, census.births[:, 1:].sum(axis=1)):
        results.add("birth_rate", species, "all", "1/s", _over(births, its_s))
    for name, unit, value in (
        ("generation_time", "s", lambda own: _over(own.ages_s.sum(), own.parents[own.ages_s.notna()].sum())),
        ("parents", "1", lambda own: _over(own.parents.sum(), len(own))),
        (
            "lineage_depth",
            "births",
            lambda own: float(own.depth.max()) if len(own) else 0.0 if run.complete else math.nan,
        ),
    ):
        for species in run.web.species:
            results.add(name, species, "all", unit, value(of[species]))
    return bool((born.parents == 0).any()) or not run.complete


def _over(total: float, count: float) -> float:
    return float(total / count) if count else math.nan


def _measure_energy(census: Census, run: PooledRun, has_newcomers: bool, results: Results) -> None:
    """`trophic_efficiency`: what a species gained by eating over what those below it gained, or over what the resource grew. Gains of hunters from
    outside, as in worlds whose meals are worth a fixed number, count if no newcomer brought energy.
    """
    table = run.table("energy", ["time_s", "tick", "species", "field_J", "victims_J", "outside_J", "stock_J"])
    sums = (
        table[table.tick > 0]
        .groupby("species")[["field_J", "victims_J", "outside_J"]]
        .sum()
        .reindex(run.web.species, fill_value=0.0)
    )
    grown_J = 0.0
    if (run.path / "resource.csv").exists():
        resource = run.table("resource", ["time_s", "tick", "grown_J"])
        grown_J = float(resource.grown_J[resource.tick > 0].sum())
    gained_J = sums.field_J + sums.victims_J + sums.outside_J * (not has_newcomers)
    stock_J = {one: table[table.species == one] for one in run.web.species}
    stocks = {
        one: means(window_of(rows.time_s.to_numpy(float)), rows.stock_J.to_numpy(float))
        for one, rows in stock_J.items()
    }
    for one, stock in stocks.items():
        results.add_means("stock", one, "all", "J", stock)
    for one in run.web.species:
        below_J = sum(gained_J[prey] for hunter, prey in run.web.links if hunter == one) + grown_J * bool(
            sums.field_J[one]
        )
        results.add("trophic_efficiency", one, "all", "1", _over(gained_J[one], below_J))
    for name, of in (
        ("pyramid_numbers", dict(zip(run.web.species, census.numbers.mean(axis=1)))),
        ("pyramid_energy", {one: stock.mean for one, stock in stocks.items()}),
    ):
        for hunter, prey in run.web.links:
            results.add(name, f"{prey}+{hunter}", "all", "1", _over(of[hunter], of[prey]))
