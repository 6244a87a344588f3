# SPDX-License-Identifier: MIT
"""Metrics of one's own: a column of a table that each run's folder has, or a Python function of a run."""
from __future__ import annotations

import difflib
import pathlib
import re
import runpy
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy
import pandas

from ..errors import RunError
from ..runs import Run
from ..values import MOST_NUMBER
from ..words import number_text
from .tables import Results, means, numbers, window_of

if TYPE_CHECKING:
    from ..pool import PooledRun

_NONE = ("", "nan", "-nan", "NaN", "NA")
_MOST_PARTS = 1000
INHERITED = ("genomes.csv", "genes.csv", "bodies.csv")
"""Tables of which each column is of what is inherited."""


class OwnColumn(NamedTuple):
    """A column of a CSV table in a run's folder."""

    file: str
    column: str
    unit: str = "1"

    def __str__(self) -> str:
        return f"--column {self.file}:{self.column}"


def own_column(text: str | OwnColumn) -> OwnColumn:
    """Reads "FILE:COLUMN" or "FILE:COLUMN:UNIT". Raises RunError, naming the option, for anything else."""
    if isinstance(text, OwnColumn):
        return text
    parts = text.split(":")
    if len(parts) not in (2, 3) or not all(parts[1:]):
        raise RunError(f"--column {text}: must be FILE:COLUMN or FILE:COLUMN:UNIT")
    if not parts[0] or pathlib.PurePath(parts[0]).name != parts[0]:
        raise RunError(f"--column {text}: must name a file in each run's folder, without a path")
    return OwnColumn(*parts)


class OwnMetric(NamedTuple):
    """A function of a run with the name and the unit of what it returns."""

    name: str
    unit: str
    function: Callable[[Run], Any]
    inherited: bool = False
    """whether it measures genomes, bodies or brains, so that its null is the neutral one"""


def metric(
    function: Callable | None = None, *, name: str | None = None, unit: str = "1", inherited: bool = False
) -> Callable:
    """Marks a function of a Run as a metric of `trophic analyze --metric-file`, or of `trophic.analyze(..., metrics=[...])`.

    The function returns a number, or a frame with a column that has the metric's name and optionally time_s (s), species and group: rows with
    one species and group are one metric, and rows with a time also make a curve. nan is a value that cannot be computed. The metric has the
    function's name unless `name` is given; its unit is 1 unless `unit` is given. Mark a measure of genomes, bodies or brains as `inherited`: it is
    compared with the neutral null, if there is one. With --until the tables of the run end at that time.
    """

    def mark(marked: Any) -> Any:
        marked.metric, marked.unit, marked.inherited = (name or marked.__name__, unit, inherited)
        return marked

    return mark if function is None else mark(function)


def own_metric(function: Callable[[Run], Any]) -> OwnMetric:
    """The name and unit of a function: those of @trophic.metric, else its own name and 1. Raises RunError for what cannot be called."""
    if isinstance(function, OwnMetric):
        return function
    if not callable(function):
        raise RunError(f"metric {function!r}: must be a function of a run")
    name = getattr(function, "metric", None) or getattr(function, "__name__", type(function).__name__)
    return OwnMetric(
        str(name), str(getattr(function, "unit", "1")), function, bool(getattr(function, "inherited", False))
    )


def read_metrics(path: str | pathlib.Path) -> list[OwnMetric]:
    """The functions of a Python file that are marked with @trophic.metric, in their order. Raises RunError, naming the file, if there is none
    or the file fails."""
    if not pathlib.Path(path).is_file():
        why = "is not a regular file" if pathlib.Path(path).exists() else "No such file or directory"
        raise RunError(f"--metric-file {path}: cannot be read: {why}")
    try:
        values = runpy.run_path(str(path)).values()
    except Exception as error:
        raise RunError(f"--metric-file {path}: {type(error).__name__}: {error}") from error
    found = [
        own_metric(value) for value in values if callable(value) and hasattr(value, "metric") and hasattr(value, "unit")
    ]
    if not found:
        raise RunError(f"--metric-file {path}: has no metric: decorate a function of a run with @trophic.metric")
    return found


def check(columns: Sequence[OwnColumn], functions: Sequence[OwnMetric], shipped: Sequence[str]) -> None:
    """Raises RunError for a name that is taken, and for a name or unit that is not a word."""
    taken = set(shipped)
    for column in columns:
        if column.column in taken:
            raise RunError(f"{column}: a metric already has this name; rename the column")
        taken.add(column.column)
    own: set[str] = set()
    for each in functions:
        if not re.fullmatch(r"\w+", each.name, re.ASCII):
            raise RunError(f"metric {each.name}: its name must be letters, digits and _")
        if not re.fullmatch(r"[\w./^%-]+", each.unit, re.ASCII):
            raise RunError(f'metric {each.name}: unit "{each.unit}": must be letters, digits and _ . / ^ % -')
        if each.name in own:
            raise RunError(f"metric {each.name}: is given twice")
        if each.name in taken:
            raise RunError(f"metric {each.name}: trophic already has a metric with this name; choose another")
        own.add(each.name)


def measure_column(column: OwnColumn, run: PooledRun, results: Results) -> None:
    """Adds the means of a column over the run for each species and group, in the order in which they come, and its curves. Empty cells and
    nan have no value. Raises RunError, naming file and line, for a cell that is not a number.
    """
    path = run.path / column.file
    check_column(column, run)
    table = run.texts(column.file, [column.column], ["time_s", "species", "group"], results.remarks)
    frame = pandas.DataFrame(index=table.index)
    for name in table.columns.intersection(["time_s", column.column]):
        frame["value" if name == column.column else name] = numbers(
            path, table[name], _NONE if name == column.column else ()
        )
    if "time_s" in frame:
        frame = frame[frame.time_s <= run.until_s]
    for name in table.columns.intersection(["species", "group"]):
        frame[name] = table[name]
    _add(column.column, column.unit, frame, str(column), str(path), results)


def check_column(column: OwnColumn, run: Run) -> None:
    """Raises RunError for a run without the file."""
    if not (run.path / column.file).exists():
        raise RunError(f"{column}: {run.path} has no such file")


def measure_function(of: OwnMetric, run: PooledRun, results: Results) -> None:
    """Adds what the function returns. Raises RunError "metric NAME: FOLDER: ..." if it raises, or returns infinity, a time outside the run or
    a species that is not there."""
    who = f"metric {of.name}: {run.path}"
    try:
        found = of.function(run)
        if not isinstance(found, pandas.DataFrame):
            found = pandas.DataFrame({of.name: [float(found)]})
        if of.name not in found:
            raise RunError(
                f"the frame has no column {of.name}{_did_you_mean(of.name, [str(name) for name in found.columns])}"
            )
        frame = pandas.DataFrame({"value": found[of.name].to_numpy(float)})
        if "time_s" in found:
            frame["time_s"] = found.time_s.to_numpy(float)
        for name in {"species", "group"}.intersection(found.columns):
            frame[name] = found[name].astype(str).to_numpy()
        _check_samples(frame, run)
    except RunError as error:
        raise RunError(f"{who}: {error}") from None
    except Exception as error:
        raise RunError(f"{who}: {type(error).__name__}: {error}") from error
    _add(of.name, of.unit, frame, who, str(run.path), results)


def _check_samples(frame: pandas.DataFrame, run: PooledRun) -> None:
    def refuse_first(wrong: pandas.Series, name: str, must: str, quote: str = "") -> None:
        if wrong.any():
            raise RunError(f"{name} = {quote}{frame.loc[wrong.idxmax(), name]}{quote}: must be {must}")

    refuse_first(numpy.isinf(frame.value), "value", "finite, or nan if there is none")
    refuse_first(frame.value.abs() > MOST_NUMBER, "value", ">= -1e60 and <= 1e60")
    if "time_s" in frame:
        refuse_first(~frame.time_s.between(0.0, run.until_s), "time_s", f">= 0 and <= {number_text(run.until_s)}")
    if "species" in frame:
        refuse_first(
            ~frame.species.isin(["", *run.web.species]), "species", f"one of {', '.join(run.web.species)}", '"'
        )
    if "group" in frame:
        refuse_first(~frame.group.str.fullmatch(r"[A-Za-z0-9_]+"), "group", "letters, digits and _", '"')


def _add(name: str, unit: str, frame: pandas.DataFrame, who: str, where: str, results: Results) -> None:
    """Adds the means of samples, one for each species and group, and the curves of those with times."""
    if any(row[0] == name for row in results.rows):
        raise RunError(f"{who}: trophic already has a metric with this name; choose another")
    has_times, is_one = "time_s" in frame, not {"species", "group"} & set(frame.columns)
    samples = pandas.DataFrame(
        {
            "species": frame.get("species", ""),
            "group": frame.get("group", "all"),
            "value": frame.value,
            "window": window_of(frame.time_s.to_numpy()) if has_times else 0,
        },
        index=frame.index,
    )
    parts = list(samples.groupby(["species", "group"], sort=False))
    if len(parts) > _MOST_PARTS:
        raise RunError(f"{who}: must cover at most {_MOST_PARTS} species and groups")
    for (species, group), of in parts or ([(("", "all"), samples)] if is_one else []):
        found = means(of.window.to_numpy(), of.value.to_numpy())
        if numpy.isnan(found.mean):
            named = " ".join([name, *filter(None, [species, group if group != "all" else ""])])
            results.remarks.append(f"{where}: {named} has no value; the mean omits this run")
        results.add(name, species, group, unit, found.mean)
        if has_times:
            results.add_curve(name, species, group, unit, found.time_s, found.points)


def _did_you_mean(word: str, words: Sequence[str]) -> str:
    near = difflib.get_close_matches(word, words, 1)
    return f"; did you mean {near[0]}?" if near else ""
