# SPDX-License-Identifier: MIT
"""The rows of agents.csv as arrays, means over windows of time, and the values of a run in the order of all tables."""
from __future__ import annotations

import dataclasses
import functools
import pathlib
from collections.abc import Sequence
from typing import NamedTuple

import numpy  # of arrays, places (numpy.flatnonzero) or compress choose elements several times as fast as a mask
import pandas

from ..errors import RunError
from ..values import METRIC, MOST_NUMBER, RunValues

WINDOW_S = 200.0
"""The paper's curves "are population averages measured every 200 seconds, resulting in 30 points"."""
GROUPS = ("all", "random", "inherited", "active")
APART = ("inactive", "inherited_active", "inherited_inactive")
"""Groups of behaviour where numbers change, and with them the shares of active and inactive members."""


class Web(NamedTuple):
    """The species of a run and its feeding links (hunter, victim), as the manifest lists them."""

    species: list[str]
    links: list[tuple[str, str]]

    def hunts(self, species: str) -> bool:
        return any(hunter == species for hunter, _ in self.links)

    def is_hunted(self, species: str) -> bool:
        return any(victim == species for _, victim in self.links)


class Means(NamedTuple):
    """Means over windows (k w, (k + 1) w], k = 0, 1, ...; time 0 belongs to the first. nan where there is no value."""

    mean: float
    """The mean of all values, each with the same weight."""
    mean_of_points: float
    """The mean of the windows' means, each with the same weight."""
    time_s: numpy.ndarray
    """The ends of the windows."""
    points: numpy.ndarray


def window_of(time_s: numpy.ndarray, window_s: float = WINDOW_S) -> numpy.ndarray:
    with numpy.errstate(invalid="ignore"):  # numpy 1.24 may report a flag that another operation left
        return numpy.maximum(0.0, numpy.ceil(time_s / window_s) - 1.0).astype(int)


def means(window: numpy.ndarray, values: numpy.ndarray, window_s: float = WINDOW_S) -> Means:
    """Means of values by their windows, as window_of returns them; nan is left out."""
    if not window_s > 0:
        raise ValueError(f"window_s = {window_s:g}: must be > 0")
    windows = int(window.max()) + 1 if len(window) else 0
    if not (known := ~numpy.isnan(values)).all():
        places = numpy.flatnonzero(known)
        window, values = window[places], values[places]
    count = numpy.bincount(window, minlength=windows)
    total = numpy.bincount(window, values, minlength=windows)
    points = ratio(total, count)
    return Means(mean_of(values), mean_of(points), numpy.arange(1, windows + 1) * window_s, points)


def ratio(total: numpy.ndarray, count: numpy.ndarray) -> numpy.ndarray:
    """total / count; nan where the count is 0."""
    return numpy.divide(total, count, out=numpy.full(len(total), numpy.nan), where=count > 0)


def mean_of(values: numpy.ndarray) -> float:
    """The mean of the values that are not nan; nan without any."""
    known = values.compress(~numpy.isnan(values))
    return float(known.mean()) if len(known) else float("nan")


def numbers(path: pathlib.Path, texts: pandas.Series, none: Sequence[str] = ()) -> numpy.ndarray:
    """The cells of a table's column as numbers; those of `none` are nan. Raises RunError, naming file and line, for the first other cell that
    is not a number from -1e60 to 1e60."""
    is_none = texts.isin(none).to_numpy()
    found = pandas.to_numeric(texts.where(~is_none, "nan"), errors="coerce").to_numpy(float)
    wrong = ~(numpy.abs(found) <= MOST_NUMBER) & ~is_none
    if wrong.any():
        cell = texts.iloc[place := int(wrong.argmax())]
        is_infinite = cell.lower() in ("nan", "-nan", "inf", "-inf")
        must = "finite" if is_infinite else "a number" if numpy.isnan(found[place]) else ">= -1e60 and <= 1e60"
        raise RunError(f'{path}:{place + 2}: {texts.name} = "{cell}": must be {must}')
    return texts.where(~is_none, "nan").to_numpy().astype(float)  # exact, which to_numeric is not


class Agents:
    """The rows of agents.csv, sorted by tick: for each row the place `at` of its tick in `ticks`, and the columns as arrays."""

    def __init__(self, frame: pandas.DataFrame, web: Web):
        def of(name: str, kind: type = int) -> numpy.ndarray:
            return frame[name].to_numpy(kind)

        self.species = pandas.Categorical(frame.species, categories=web.species).codes.astype(int)
        self.names = web.species
        self.inherited = (frame.origin == "inherited").to_numpy(bool)
        self.active = of("active") == 1
        self.id, self.body, self.tag = of("id"), of("body"), of("tag")
        self.x_m, self.y_m, self.adversary_id, self.hunger_ticks = (
            of(name, float) for name in ("x_m", "y_m", "adversary_id", "hunger_ticks")
        )
        self.tilt_rad, self.touches_wall = (
            frame[name].to_numpy(float) if name in frame else numpy.full(len(frame), numpy.nan)
            for name in ("tilt_rad", "touches_wall")
        )
        tick = of("tick")
        starts = numpy.flatnonzero(numpy.diff(tick, prepend=-1))
        self.ticks = tick[starts]
        self.time_s = frame.time_s.to_numpy(float)[starts]
        self.window = window_of(self.time_s)
        self.at = numpy.repeat(numpy.arange(len(starts)), numpy.diff(starts, append=len(frame)))
        self._starts = starts
        self._after: dict[int, numpy.ndarray] = {}
        self._width = int(self.body.max()) + 1 if len(frame) else 1
        keys = self.at * self._width + self.body
        self._order = None if (numpy.diff(keys) > 0).all() else numpy.argsort(keys, kind="stable")
        self._keys = keys if self._order is None else keys[self._order]
        self._body_of = numpy.full(int(self.id.max()) + 1 if len(frame) else 1, -1)
        self._body_of[self.id] = self.body

    def of(self, species: str | None = None, group: str = "all") -> numpy.ndarray:
        """The rows of a species, or of all, that belong to a group at that tick: one of GROUPS or APART."""
        mask = numpy.ones(len(self.at), bool) if species is None else self.species == self.names.index(species)
        if group != "all":
            for part in group.split("_"):
                mask &= {
                    "random": ~self.inherited,
                    "inherited": self.inherited,
                    "active": self.active,
                    "inactive": ~self.active,
                }[part]
        return mask

    def count(self, rows: numpy.ndarray, weights: numpy.ndarray | None = None) -> numpy.ndarray:
        """The number, or the sum of the weights, of these rows at each tick."""
        if weights is None:
            return numpy.add.reduceat(rows, self._starts, dtype=int) if len(rows) else numpy.zeros(0, int)
        places = numpy.flatnonzero(rows)
        return numpy.bincount(self.at[places], weights[places], minlength=len(self.ticks))

    def mean(self, rows: numpy.ndarray, values: numpy.ndarray) -> numpy.ndarray:
        """The mean of the values of these rows at each tick; nan at a tick without any."""
        return ratio(self.count(rows, values), self.count(rows))

    def find(self, tick_at: numpy.ndarray, ids: numpy.ndarray) -> numpy.ndarray:
        """The rows of individuals at ticks, which are places in `ticks`; -1 where there is none, and for nan. An individual keeps its body."""
        known = (ids >= 0) & (ids < len(self._body_of))  # false for nan
        ids = numpy.where(known, ids, 0).astype(int)
        rows = self.find_body(tick_at, numpy.where(known, self._body_of[ids], -1))
        return numpy.where((rows >= 0) & (self.id[rows] == ids), rows, -1) if len(self.id) else rows

    @functools.cached_property
    def before(self) -> numpy.ndarray:
        """For each row that of its individual at the tick before."""
        return self.find(self.at - 1, self.id)

    @functools.cached_property
    def adversary(self) -> numpy.ndarray:
        """For each row that of its adversary."""
        return self.find(self.at, self.adversary_id)

    def after(self, ticks: int) -> numpy.ndarray:
        """For each row that of its individual that many ticks later."""
        if ticks not in self._after:
            self._after[ticks] = self.find(self.later(ticks)[self.at], self.id)
        return self._after[ticks]

    def find_body(self, tick_at: numpy.ndarray, bodies: numpy.ndarray) -> numpy.ndarray:
        """The rows of bodies at ticks, as find."""
        known = numpy.flatnonzero((tick_at >= 0) & (bodies >= 0) & (bodies < self._width))  # without nan
        at, of = tick_at[known], bodies[known].astype(int)
        key = at * self._width + of
        last = len(self._keys) - 1
        # Where every body has a row, it is that of its number.
        place = numpy.minimum(self._starts[at] + of, last)
        if len(other := numpy.flatnonzero(self._keys[place] != key)):
            place[other] = numpy.minimum(numpy.searchsorted(self._keys, key[other]), last)
        there = self._keys[place] == key
        rows = numpy.full(len(tick_at), -1)
        rows[known[there]] = place[there] if self._order is None else self._order[place[there]]
        return rows

    def later(self, ticks: int) -> numpy.ndarray:
        """For each tick the place of the tick that many ticks later; -1 where the run has none."""
        place = numpy.searchsorted(self.ticks, self.ticks + ticks)
        there = place < len(self.ticks)
        there[there] = self.ticks[place[there]] == (self.ticks + ticks)[there]
        return numpy.where(there, place, -1)


@dataclasses.dataclass
class Results:
    """Collects what is measured in a run."""

    rows: list[tuple] = dataclasses.field(default_factory=list)
    curves: list[tuple] = dataclasses.field(default_factory=list)
    remarks: list[str] = dataclasses.field(default_factory=list)

    def add(self, metric: str, species: str, group: str, unit: str, value: float, baselines: tuple = ()) -> None:
        """A number, nan if it could not be computed, and its baselines (name, role, value)."""
        name = (metric, species, group, unit)
        self.rows += [(*name, "", "", value), *((*name, *baseline) for baseline in baselines)]

    def add_curve(
        self,
        metric: str,
        species: str,
        group: str,
        unit: str,
        time_s: numpy.ndarray,
        points: numpy.ndarray,
        baseline: str = "",
    ) -> None:
        self.curves.append(((metric, species, group, unit, baseline), time_s, points))

    def add_means(
        self,
        metric: str,
        species: str,
        group: str,
        unit: str,
        of: Means,
        value: float | None = None,
        baselines: tuple = (),
    ) -> None:
        """The mean of all values, unless another `value` is given, and the curve."""
        self.add(metric, species, group, unit, of.mean if value is None else value, baselines)
        self.add_curve(metric, species, group, unit, of.time_s, of.points)

    def run_values(self) -> RunValues:
        values = pandas.DataFrame(self.rows, columns=[*METRIC, "baseline", "role", "value"])
        names = pandas.DataFrame([name for name, _, _ in self.curves], columns=[*METRIC, "baseline"])
        curves = names.loc[names.index.repeat([len(time_s) for _, time_s, _ in self.curves])].reset_index(drop=True)
        for place, column in ((1, "time_s"), (2, "value")):
            curves[column] = (
                numpy.concatenate([curve[place] for curve in self.curves]) if self.curves else numpy.empty(0)
            )
        return RunValues(values, curves, self.remarks)
