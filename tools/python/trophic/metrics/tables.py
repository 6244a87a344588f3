# SPDX-License-Identifier: MIT
"""The rows of agents.csv as arrays, means over windows of time, and the values of a run in the order of all tables."""
from __future__ import annotations

import dataclasses
import pathlib
from collections.abc import Sequence
from typing import NamedTuple

import numpy
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
    known = ~numpy.isnan(values)
    windows = int(window.max()) + 1 if len(window) else 0
    count = numpy.bincount(window[known], minlength=windows)
    total = numpy.bincount(window[known], values[known], minlength=windows)
    points = ratio(total, count)
    return Means(mean_of(values), mean_of(points), numpy.arange(1, windows + 1) * window_s, points)


def ratio(total: numpy.ndarray, count: numpy.ndarray) -> numpy.ndarray:
    """total / count; nan where the count is 0."""
    return numpy.divide(total, count, out=numpy.full(len(total), numpy.nan), where=count > 0)


def mean_of(values: numpy.ndarray) -> float:
    """The mean of the values that are not nan; nan without any."""
    known = values[~numpy.isnan(values)]
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
        self._ids = _Places(self.at, self.id)
        self._bodies = _Places(self.at, self.body)

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
        return numpy.bincount(self.at[rows], None if weights is None else weights[rows], minlength=len(self.ticks))

    def mean(self, rows: numpy.ndarray, values: numpy.ndarray) -> numpy.ndarray:
        """The mean of the values of these rows at each tick; nan at a tick without any."""
        return ratio(self.count(rows, values), self.count(rows))

    def find(self, tick_at: numpy.ndarray, ids: numpy.ndarray) -> numpy.ndarray:
        """The rows of individuals at ticks, which are places in `ticks`; -1 where there is none, and for nan."""
        return self._ids.find(tick_at, ids)

    def find_body(self, tick_at: numpy.ndarray, bodies: numpy.ndarray) -> numpy.ndarray:
        """The rows of bodies at ticks, as find."""
        return self._bodies.find(tick_at, bodies)

    def later(self, ticks: int) -> numpy.ndarray:
        """For each tick the place of the tick that many ticks later; -1 where the run has none."""
        place = numpy.searchsorted(self.ticks, self.ticks + ticks)
        there = place < len(self.ticks)
        there[there] = self.ticks[place[there]] == (self.ticks + ticks)[there]
        return numpy.where(there, place, -1)


class _Places:
    """Finds rows by tick and number."""

    def __init__(self, at: numpy.ndarray, numbers: numpy.ndarray):
        self._width = int(numbers.max()) + 1 if len(numbers) else 1
        keys = at * self._width + numbers
        self._order = None if (numpy.diff(keys) > 0).all() else numpy.argsort(keys, kind="stable")
        self._keys = keys if self._order is None else keys[self._order]

    def find(self, at: numpy.ndarray, numbers: numpy.ndarray) -> numpy.ndarray:
        known = (at >= 0) & (numbers >= 0) & (numbers < self._width)  # false for nan
        key = numpy.where(known, at * self._width + numpy.nan_to_num(numbers), -1).astype(int)
        place = numpy.searchsorted(self._keys, key)
        there = known & (place < len(self._keys))
        there[there] = self._keys[place[there]] == key[there]
        rows = numpy.full(len(key), -1)
        rows[there] = place[there] if self._order is None else self._order[place[there]]
        return rows


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
