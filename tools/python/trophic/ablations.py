# SPDX-License-Identifier: MIT
"""Ablation studies: many sets of runs, each with one rule or group of rules swapped, compared with the one set in which nothing is."""
from __future__ import annotations

import dataclasses
import os
import pathlib
from collections.abc import Sequence
from typing import Any

import pandas

from . import judge, pool
from .errors import RunError
from .metrics import Measuring
from .report import tables
from .report.columns import names as column_names
from .sweeps.cells import answers, corrected, count, metric_of
from .sweeps.report import compared_title, with_significance
from .values import MeasuredSet, Metric
from .words import Reading, markdown_text, p_text

PREFIX, BASE = "from_", "base"
"""Folders of a study: from_TABLE/base and from_TABLE/SWAP."""
GROUPS = ("perception", "reproduction", "death", "ecology")
"""Groups of rules that together are all differences of two tables, as `trophic-ablations` has them."""


@dataclasses.dataclass
class Direction:
    """All swaps of one table compared with its base."""

    name: str
    base: MeasuredSet
    effects: pandas.DataFrame
    """as `effects_of` returns it"""


def effects_of(base: MeasuredSet, swapped: dict[str, MeasuredSet], direction: str) -> pandas.DataFrame:
    """The effect of each swap on each metric, by swaps, one row each, with a raw one behind it if sets have shadows.

    Columns: those of ablations.csv (docs/tables.md), and as in judge.compare `role` ("null" of an answer), `same_as`, `level`, `conclusion`. Holm's
    correction is over all swaps and metrics that repeat no other in all sets together; raw differences behind answers are a family of their own.
    """
    every = [one for each in (base, *swapped.values()) for one in (each, each.shadow) if one]
    repeats = judge.repeated(
        [metric for metric in base.metrics() if all((metric, "") in one.table for one in every)], every
    )
    frames = [judge.compare(base, one).assign(swap=swap, direction=direction) for swap, one in swapped.items()]
    if not frames:
        return pandas.DataFrame(
            columns=[*column_names("ablations.csv"), "role", "conclusion", "same_as", "is_comparison"]
        )
    frame = pandas.concat(frames, ignore_index=True)
    frame["same_as"] = [str(repeats.get(metric_of(row), "")) for row in frame.itertuples(index=False)]
    frame["is_comparison"] = frame["p"].notna() & (frame["same_as"] == "")
    parts = [corrected(frame[is_answer]) for is_answer in (frame["role"] == "null", frame["role"] != "null")]
    frame = pandas.concat(parts).sort_index()
    frame.loc[frame["same_as"] != "", ["p_holm", "conclusion"]] = float("nan"), "same"
    return frame.rename(columns={"n_a": "runs_base", "n_b": "runs_swapped", "mean_a": "base", "mean_b": "swapped"})


def read_study(folder: str | os.PathLike, jobs: int | None = None) -> list[Direction]:
    """Measures the sets of a study, FOLDER/from_TABLE/SWAP, of one table or two. Raises RunError, before anything is measured, for a study without a
    base, of more than two tables, and for sets that are incomplete or cannot be compared.
    """
    folder = pathlib.Path(folder)
    tables_ = sorted(path for path in folder.glob(f"{PREFIX}*") if (path / BASE).is_dir())
    if not tables_:
        raise RunError(f"{folder}: has no folder from_TABLE with a base")
    if len(tables_) > 2:
        raise RunError(f"{folder}: has more than two folders from_TABLE")
    names = {
        table: sorted(path.parent.name for path in table.glob("*/replicates.json") if path.parent.name != BASE)
        for table in tables_
    }
    first = None
    for table in tables_:
        base, shadow = _complete_runs(table / BASE)
        first = first or base
        check_comparable(first, base)
        for name in names[table]:
            try:
                swapped, its_shadow = _complete_runs(table / name)
                check_comparable(base, swapped)
                if (shadow is None) != (its_shadow is None):
                    raise RunError(f"{table / name}: one of it and its base has a shadow, the other has none")
            except RunError as error:
                raise RunError(f"{name}: {error}") from None
    return [_measure(table, names[table], Measuring(jobs=jobs)) for table in tables_]


def _complete_runs(path: pathlib.Path) -> tuple[pool.PooledRun, pool.PooledRun | None]:
    """The first runs of a set and of its shadow, if there is one."""
    firsts: list[pool.PooledRun] = []
    for folder in [path, *pool.null_folders([path])]:
        found, remarks = pool.pooled_runs([folder], Measuring())
        for run in found:
            if not run.complete:
                raise RunError(f'{run.path}: status "{run.manifest["status"]}": must be complete')
        if remarks:
            raise RunError(remarks[0])
        firsts.append(found[0])
    return firsts[0], firsts[1] if len(firsts) > 1 else None


def check_comparable(a: pool.PooledRun, b: pool.PooledRun) -> None:
    """Raises RunError, naming both, if two runs did not last equally long, or it is not known."""
    if not pool.lasted_alike(a, b):
        raise RunError(
            f"{b.path}: {pool.lasted_text(b)}, but {a.path} has {pool.lasted_text(a)}; runs of different length are not compared: use --until"
        )


def _measure(folder: pathlib.Path, names: Sequence[str], how: Measuring) -> Direction:
    def read(name: str) -> MeasuredSet:
        of = pool.read_set([folder / name], how=how)
        for one in filter(None, (of, of.shadow)):
            if one.remarks:
                raise RunError(one.remarks[0])
        return of

    base = read(BASE)
    return Direction(folder.name, base, effects_of(base, {name: read(name) for name in names}, folder.name))


def whole_difference(first: Direction, second: Direction) -> pandas.DataFrame:
    """The effects of all rules of the second table at once, as `effects_of` has them."""
    here, there = (one.name.removeprefix(PREFIX) for one in (first, second))
    return effects_of(first.base, {there: second.base}, f"{here}_to_{there}")


def ablation_table(
    runs: str | os.PathLike, out: str | os.PathLike | None = None, *, jobs: int | None = None
) -> pandas.DataFrame:
    """Compares each swap of an ablation study with its base: the rows of ablations.csv (docs/tables.md) as a frame, with `role` and `conclusion`. `out`: a new
    folder for ablations.csv and ablations.md. Raises RunError for a study that is incomplete or cannot be compared, and if the folder exists.
    """
    directions = read_study(runs, jobs)
    whole = whole_difference(*directions) if len(directions) == 2 else None
    frame = pandas.concat([one.effects for one in directions] + ([] if whole is None else [whole]), ignore_index=True)
    frame = with_significance(frame)
    if out is not None:
        with tables.result_folder(out) as folder:
            tables.write_new(folder / "ablations.csv", tables.csv_text(frame[column_names("ablations.csv")]))
            tables.write_new(folder / "ablations.md", markdown(directions, whole))
    return frame


def run(request: dict) -> int:
    """`trophic ablation-table`, from its options by name."""
    out = request.get("out") or "swaps"
    ablation_table(request["runs"], out, jobs=request.get("jobs"))
    print(f"files   {out}/{{ablations.csv,ablations.md}}")
    return 0


# Markdown


def markdown(directions: Sequence[Direction], whole: pandas.DataFrame | None) -> str:
    """ablations.md: the significant effects, and what groups of rules make of the whole difference of two tables."""
    text = ""
    for one in directions:
        text += f"## {markdown_text(one.name)}\n\n{count(one.effects).sentence()}\n\n{significant_table(one.effects)}"
        text += (
            "\np: corrected for all swaps and metrics of this direction; intervals are those of single comparisons.\n\n"
        )
    if whole is not None:
        first, second = (one.name.removeprefix(PREFIX) for one in directions)
        text += f"## Together\n\nFirst: {markdown_text(first)}. Second: {markdown_text(second)}. Each group of rules alone put into the first, and taken out of the second.\n\n"
        text += shares_table(whole, directions[0].effects, directions[1].effects)
        text += "\n*: significant in its direction. Sums that miss the whole difference show that the groups act on each other.\n"
    return text


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    return "".join(f"| {' | '.join(row)} |\n" for row in (head, *rows)).replace(
        "\n", "\n|" + "---|" * len(head) + "\n", 1
    )


def significant_table(effects: pandas.DataFrame) -> str:
    """A Markdown table of the significant effects, in the units that people read."""
    rows = []
    for row in _significant(effects):
        reading = Reading(metric_of(row))
        rows.append(
            (
                markdown_text(row.swap),
                markdown_text(compared_title(row)),
                reading(row.base),
                reading(row.swapped),
                reading.with_interval(row.difference, (row.lower, row.upper), True),
                p_text(row.p_holm),
            )
        )
    return _table(("swap", "metric", "base", "swapped", "difference [95 %]", "p (Holm)"), rows)


def _significant(effects: pandas.DataFrame) -> list:
    of = answers(effects)
    return list(of[of["conclusion"].isin(("above", "below"))].itertuples(index=False))


def shares_table(
    whole: pandas.DataFrame, forward: pandas.DataFrame, backward: pandas.DataFrame, names: Sequence[str] = GROUPS
) -> str:
    """How much of the difference between two tables the swaps of some names make: one line per metric, each swap's effect. `forward`: swaps from the
    first table towards the second. `backward`: from the second towards the first, whose effects have the sign turned, so that both say what the
    second table's rules do. Only metrics whose `whole` is significant."""
    sides = [(1.0, _by_swap(forward)), (-1.0, _by_swap(backward))]
    rows = []
    for row in _significant(whole):
        metric = metric_of(row)
        reading = Reading(metric)
        cells, sums = [], [0.0, 0.0]
        for name in names:
            for side, (sign, effects) in enumerate(sides):
                effect = effects.get((name, metric))
                value = float("nan") if effect is None else sign * effect.difference
                sums[side] += value
                cells.append(
                    reading(value, True)
                    + ("*" if effect is not None and effect.conclusion in ("above", "below") else "")
                )
        rows.append(
            (
                markdown_text(compared_title(row)),
                reading(row.base),
                reading(row.swapped),
                reading.with_interval(row.difference, (row.lower, row.upper), True),
                *cells,
                *(reading(value, True) for value in sums),
            )
        )
    head = [f"{name} {way}" for name in names for way in ("into first", "out of second")]
    return _table(
        ("metric", "first", "second", "whole difference [95 %]", *head, "sum into first", "sum out of second"), rows
    )


def _by_swap(effects: pandas.DataFrame) -> dict[tuple[str, Metric], Any]:
    return {(row.swap, metric_of(row)): row for row in answers(effects).itertuples(index=False)}
