# SPDX-License-Identifier: MIT
"""The plan of a sweep: its runs, the cells of its grid, what varies between them, and which of their runs belong together."""
from __future__ import annotations

import dataclasses
import json
import math
import pathlib
import re
from collections.abc import Callable, Sequence
from typing import Any

from ..errors import RunError
from ..pool import MOST_TIME_S
from ..values import one_sided_name, one_sided_species

PLAN = "plan.jsonl"


@dataclasses.dataclass(frozen=True)
class PlannedRun:
    """A line of plan.jsonl: a run with its place in the grid."""

    index: int
    """its place in the plan, from 0"""
    cell: int
    replicate: int
    null: str
    """none, shadow or one_sided_SPECIES"""
    rule_table: str
    engine: str
    settings: dict[str, Any]
    """by their paths"""
    seed: int
    until_s: float
    replay_hz: float
    agents_every: int
    senses: bool
    states: bool
    work: float
    folder: str
    """from the folder of the plan"""
    fingerprint: str

    @property
    def shadow(self) -> bool:
        return self.null == "shadow"


@dataclasses.dataclass
class Replicate:
    """Places in the plan of a run, of its shadow and, by species, of its one-sided worlds."""

    seed: int
    run: int | None = None
    shadow: int | None = None
    one_sided: dict[str, int] = dataclasses.field(default_factory=dict)


@dataclasses.dataclass
class Cell:
    """A point of the grid."""

    number: int
    first: PlannedRun
    """one of its runs: all have one rule table, engine and settings"""
    replicates: list[Replicate]


@dataclasses.dataclass
class Axis:
    """A setting that varies between cells."""

    name: str
    """its path, rule_table or engine"""
    values: list[str]
    """one a cell, in their order; empty if a cell does not have the setting"""


@dataclasses.dataclass
class Grid:
    cells: list[Cell]
    axes: list[Axis]

    def place(self, number: int, name: str = "reference = ") -> int:
        """The place of a cell. Raises RunError, beginning with `name`, if there is no such cell."""
        numbers = [cell.number for cell in self.cells]
        if number not in numbers:
            raise RunError(f"{name}{number}: must be a cell of the sweep, {numbers[0]} to {numbers[-1]}")
        return numbers.index(number)

    def axis_title(self, axis: Axis) -> str:
        """The last part of a setting's path, or the whole if two axes end alike."""
        tails = [other.name.rsplit(".", 1)[-1] for other in self.axes]
        tail = axis.name.rsplit(".", 1)[-1]
        return axis.name if tails.count(tail) > 1 else tail

    def cell_title(self, number: int) -> str:
        """ "reach_m 0.5, sd 0.05"; empty without an axis."""
        place = self.place(number)
        return ", ".join(f"{self.axis_title(axis)} {axis.values[place] or 'unset'}" for axis in self.axes)

    def cell_name(self, number: int) -> str:
        """ "cell 1 (reach_m 0.5, sd 0.05)"."""
        return f"cell {number}" + (f" ({self.cell_title(number)})" if self.axes else "")


def grid_of(plan: Sequence[PlannedRun]) -> Grid:
    """The grid of a plan, cells and replicates by their numbers. Axes: rule_table, engine, then settings in the order in which the plan names
    them; only those in which cells differ."""
    first: dict[int, PlannedRun] = {}
    replicates: dict[tuple[int, int], Replicate] = {}
    names = {"rule_table": None, "engine": None}
    for run in plan:
        first.setdefault(run.cell, run)
        replicate = replicates.setdefault((run.cell, run.replicate), Replicate(run.seed))
        if run.null in ("none", "shadow"):
            setattr(replicate, "shadow" if run.shadow else "run", run.index)
        else:
            replicate.one_sided[one_sided_species(run.null)] = run.index
        names.update(dict.fromkeys(run.settings))
    cells = [
        Cell(number, first[number], [replicates[place] for place in sorted(replicates) if place[0] == number])
        for number in sorted(first)
    ]

    def value_on(run: PlannedRun, name: str) -> str:
        value = getattr(run, name) if name in ("rule_table", "engine") else run.settings.get(name, "")
        return value if isinstance(value, str) else _json(value)

    axes = [Axis(name, [value_on(cell.first, name) for cell in cells]) for name in names]
    return Grid(cells, [axis for axis in axes if len(set(axis.values)) > 1])


def is_paired(a: Cell, b: Cell) -> bool:
    """Whether the replicates of two cells are compared seed by seed: all seeds of the smaller one are in the other. If they have none in common
    their runs are independent. Raises RunError, naming both cells, for seeds of which only some are in common.
    """
    seeds = {replicate.seed for replicate in a.replicates}
    common = sum(replicate.seed in seeds for replicate in b.replicates)
    fewer = min(len(a.replicates), len(b.replicates))
    if common not in (0, fewer):
        raise RunError(
            f"cell {b.number} has {common} of {fewer} seeds in common with cell {a.number}: must be all, to be compared seed by seed, or none"
        )
    return common != 0


# plan.jsonl


def read_plan(path: pathlib.Path) -> list[PlannedRun]:
    """Reads the runs of a plan. Raises RunError, naming line and field, for anything that trophic does not write."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    runs: list[PlannedRun] = []
    so_far: dict[Any, Any] = {}
    for number, text in enumerate(lines, 1):
        where = f"{path}:{number}"
        try:
            line = json.loads(text)
        except (json.JSONDecodeError, RecursionError):
            line = None
        if not isinstance(line, dict):
            raise RunError(f"{where}: must be a JSON object on a line of its own")
        for field, (is_right, must) in _FIELDS.items():
            if field not in line:
                raise RunError(f"{where}: {field}: must be there")
            if not is_right(line[field]):
                raise RunError(f"{where}: {field} = {_json(line[field])}: must {must}")
        runs.append(PlannedRun(number - 1, **{field: line[field] for field in _FIELDS}))
        for field, must in _conflicts(runs, so_far):
            raise RunError(f"{where}: {field} = {_json(line[field])}: must be {must}")
    if not runs:
        raise RunError(f"{path}: must list at least one run")
    return runs


def _conflicts(runs: Sequence[PlannedRun], so_far: dict[Any, Any]):
    """(field, what it must be) for each conflict of the last run with those before it, of which `so_far` keeps what is compared."""
    run = runs[-1]
    cell = f"cell {run.cell}"

    def is_new(*key: Any) -> bool:
        return so_far.setdefault(key, run.index) == run.index

    if not is_new("folder", run.folder):
        yield "folder", "unique among the runs"
    if not is_new(run.cell, run.null, "replicate", run.replicate):
        yield "replicate", f"unique among the runs of {cell}"
    if not is_new(run.cell, run.null, "seed", run.seed):
        yield "seed", f"unique among the replicates of {cell}"
    beside = so_far.setdefault((run.cell, "replicate", run.replicate), run.index)
    if runs[beside].seed != run.seed:
        yield "seed", f"{runs[beside].seed}, as a replicate and its nulls have one"
    for key, fields in (
        ((run.cell,), ("rule_table", "engine", "settings", "until_s", "replay_hz", "agents_every", "senses", "states")),
        ((run.cell, run.null), ("fingerprint",)),
    ):
        first = runs[so_far.setdefault(key, run.index)]
        for field in fields:
            if getattr(run, field) != getattr(first, field):
                yield field, f"{_json(getattr(first, field))}, as in the other runs of {cell}"


def _json(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False)


def _is_whole(value: Any) -> bool:
    return type(value) is int and 0 <= value < 2**64


def _is_number(value: Any, lowest: float = 0.0, largest: float = math.inf) -> bool:
    return type(value) in (int, float) and math.isfinite(value) and lowest <= value <= largest


def _is_text(value: Any) -> bool:
    return (
        isinstance(value, str)
        and value != ""
        and not any(ord(letter) < 32 or 127 <= ord(letter) < 160 for letter in value)
    )


def _are_settings(value: Any) -> bool:
    return isinstance(value, dict) and all(
        path and (isinstance(one, (str, bool)) or _is_number(one, -math.inf)) for path, one in value.items()
    )


def _is_folder(value: Any) -> bool:
    return (
        _is_text(value) and not value.startswith("/") and all(part not in ("", ".", "..") for part in value.split("/"))
    )


def _is_null(value: Any) -> bool:
    return value in ("none", "shadow") or _is_text(value) and re.fullmatch(one_sided_name(".+"), value) is not None


_WHOLE = _is_whole, "be a whole number >= 0"
_SWITCH = (lambda value: isinstance(value, bool)), "be true or false"
_TEXT = _is_text, "be a text, and not empty, without control characters"
_FIELDS: dict[str, tuple[Callable[[Any], bool], str]] = {
    "cell": _WHOLE,
    "replicate": _WHOLE,
    "null": (_is_null, "be none, shadow or one_sided_SPECIES"),
    "rule_table": _TEXT,
    "engine": _TEXT,
    "settings": (_are_settings, "be an object with settings by their paths: numbers, texts, true or false"),
    "seed": _WHOLE,
    "until_s": (lambda value: _is_number(value, largest=MOST_TIME_S) and value > 0, f"be > 0 and <= {MOST_TIME_S:.0f}"),
    "replay_hz": (lambda value: _is_number(value, largest=1000.0), "be >= 0 and <= 1000"),
    "agents_every": (lambda value: _is_whole(value) and 1 <= value < 2**63, f"be >= 1 and <= {2**63 - 1}"),
    "senses": _SWITCH,
    "states": _SWITCH,
    "work": (_is_number, "be >= 0"),
    "folder": (_is_folder, "be a folder within that of the plan, without . and .."),
    "fingerprint": _TEXT,
}
