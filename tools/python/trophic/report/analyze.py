# SPDX-License-Identifier: MIT
"""`trophic analyze` and `trophic.analyze`: from runs to results."""
from __future__ import annotations

import contextlib
import math
import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import pandas

from .. import judge, pool, published
from ..description import describe, distinct
from ..errors import RunError, printable, remark
from ..metrics import Measuring
from ..runs import Analysis
from ..values import MeasuredSet
from ..words import number_text
from ..writing import csv_text, json_text, result_folder, write_new
from . import tables, tex, text
from .measuring import measuring_of


class Outcome(NamedTuple):
    """Measured sets and what the judge made of them."""

    sets: list[MeasuredSet]
    frames: list[pandas.DataFrame]
    """of judge.summarize, one a set"""
    compared: pandas.DataFrame | None
    """of judge.compare, of two sets"""

    @property
    def answer(self) -> pandas.DataFrame:
        """The frame whose family and findings answer what was asked."""
        return self.frames[0] if self.compared is None else self.compared

    def remarks(self) -> list[str]:
        return [remark for one in self.sets for of in (one, *one.nulls.values()) for remark in of.remarks]

    def analysis(self, path: pathlib.Path | None) -> Analysis:
        """As `read_analysis` has it; `path` is the folder of the tables, None for an analysis in memory."""
        content = tables.summary(self.sets, self.frames, self.compared)
        made = Analysis(path, tables.metrics(self.sets), content)
        made.__dict__["means"] = tables.means(pandas.concat(self.frames, ignore_index=True))
        if self.compared is not None:
            made.__dict__["differences"] = tables.differences(self.compared)
        return made


def analyse(
    runs: Sequence[str | os.PathLike],
    compare: Sequence[str | os.PathLike] = (),
    shadow: str | os.PathLike | None = None,
    how: Measuring | None = None,
) -> Outcome:
    """Measures the runs of some folders, or of two sets that are compared, and judges them. Raises RunError, naming what is wrong."""
    how = how or Measuring()
    groups = [[folder] for folder in compare] or [list(runs)]
    if compare:
        both = [pool.pooled_runs([pathlib.Path(folder)], how)[0] for folder in compare]
        pool.check_apart(*both)
        first, second = (of[0] for of in both)
        if how.until_s is None and not pool.lasted_alike(first, second):
            raise RunError(
                f"{second.path}: {pool.lasted_text(second)}, but {first.path} has {pool.lasted_text(first)}; runs of different length "
                "are not compared: use --until"
            )
    sets = [pool.read_set(group, shadow, how) for group in groups]
    for of, label in zip(sets, distinct([describe(of).label for of in sets])):
        of.label = label
        for null in of.nulls.values():
            null.label = describe(null).label
    frames = [judge.summarize(of, how.metrics) for of in sets]
    return Outcome(sets, frames, judge.compare(sets[0], sets[1], how.metrics) if compare else None)


def is_sweep(folder: str | os.PathLike) -> bool:
    return (pathlib.Path(folder) / "plan.jsonl").exists()


def _check(request: Mapping[str, Any]) -> None:
    """Raises RunError for options that do not go together."""
    runs, compare = request.get("runs") or [], request.get("compare") or []
    if bool(runs) == bool(compare):
        raise RunError("needs either folders of runs, or --compare with two folders")
    for folder in filter(is_sweep, compare):
        raise RunError(f"--compare {folder}: is a sweep; give two of its cells")
    if not (sweeps := [folder for folder in runs if is_sweep(folder)]):
        for option in ("reference", "allow_missing"):
            if request.get(option) not in (None, False):
                raise RunError(f"--{option.replace('_', '-')}: needs a sweep, a folder with plan.jsonl")
    elif len(runs) > 1:
        raise RunError(f"{sweeps[0]}: is a sweep and must be analysed alone")
    for option in ("shadow", "published"):
        if sweeps and request.get(option):
            raise RunError(f"{sweeps[0]}: is a sweep: not with --{option}")
    for option in ("html", "lineages", "selection"):
        if sweeps and request.get(option):
            raise RunError(f"{sweeps[0]}: is a sweep: not with --{option}; name one of its cells")


def run(request: Mapping[str, Any]) -> int:
    """The command. Raises RunError before any work for options that do not go together, and for a file or folder that exists."""
    _check(request)
    if request.get("selection"):
        from .. import selection

        return selection.run(request)
    if request["runs"] and is_sweep(request["runs"][0]):
        from ..sweeps import report

        return report.run(request)
    how = measuring_of(request)
    asked = request.get("difference")
    if asked is not None and not (math.isfinite(asked) and asked > 0.0):
        raise RunError(f"--difference {number_text(asked)}: must be > 0")
    if asked is not None and not how.metrics:
        raise RunError("--difference: needs --metric to name a metric")
    if request.get("html"):
        from . import page

        if not request["html"].lower().endswith((".html", ".htm")):
            raise RunError(f"--html {request['html']}: must end in .html")
        if os.path.lexists(request["html"]):
            raise RunError(f"--html {request['html']}: exists already; files are never overwritten")
        if not pathlib.Path(request["html"]).absolute().parent.is_dir():
            raise RunError(f"--html {request['html']}: cannot be made, because its folder does not exist")
        if request.get("figures"):
            page.read_figures(request["figures"])
    wants_tables = request.get("out") is not None or not request.get("html")
    files, about_page = [], ""
    with result_folder(request.get("out")) if wants_tables else contextlib.nullcontext() as folder:
        outcome = analyse(request.get("runs") or (), request.get("compare") or (), request.get("shadow"), how)
        replays = page.replays_of(outcome.sets, request.get("replays"), request["who"]) if request.get("html") else None
        whole, brief = texts(outcome, bool(request.get("published")))
        if folder is not None:
            files = write_tables(folder, outcome)
        if request.get("html"):
            frames = outcome.frames if outcome.compared is None else [outcome.compared]
            downloads = {"metrics.csv": csv_text(tables.metrics(outcome.sets))}
            about_page = page.write(
                request["html"],
                outcome.sets,
                frames,
                judge.findings(outcome.answer),
                request,
                text=whole,
                downloads=downloads,
                replays=replays,
            )
    # Files first: the reader of the text may stop reading.
    for what in outcome.remarks():
        remark(request["who"], what)
    print(whole if request.get("all") or how.metrics else brief, end="")
    if asked is not None:
        print(text.runs_for(outcome.answer, asked), end="")
    if folder is not None:
        print(f"files   {printable(str(folder.with_suffix('')))}/{{{','.join(files)}}}")
    print(about_page, end="")
    return 0


def texts(outcome: Outcome, is_published: bool = False) -> tuple[str, str]:
    """The text of the terminal with --all, and without."""
    sets, compared = outcome.sets, outcome.compared
    if compared is not None:
        return text.difference_table(sets[0], sets[1], compared), text.difference_findings(sets[0], sets[1], compared)
    if is_published:
        claims = text.claims(sets[0])
        return claims, claims
    return text.table(sets[0], outcome.frames[0]), text.findings(sets[0], outcome.frames[0])


def write_tables(folder: pathlib.Path, outcome: Outcome) -> list[str]:
    """Writes every table of an analysis into a folder. Returns the names of the files."""
    sets, compared = outcome.sets, outcome.compared
    made = outcome.analysis(folder)
    files = {
        "metrics.csv": csv_text(made.metrics),
        "means.csv": csv_text(made.means),
        "means.tex": "".join(tex.means(of, frame) for of, frame in zip(sets, outcome.frames)),
    }
    if compared is not None:
        files |= {
            "differences.csv": csv_text(made.differences),
            "differences.tex": tex.differences(sets[0], sets[1], compared),
        }
    elif published.answers(sets[0], outcome.frames[0]):
        files["answers.tex"] = tex.answers(sets[0], outcome.frames[0])
    if len(survivals := pandas.concat([tables.survivals(of) for of in sets])):
        files["survival.csv"] = csv_text(survivals)
    files["summary.json"] = json_text(made.summary)
    for name, content in files.items():
        write_new(folder / name, content)
    return list(files)
