# SPDX-License-Identifier: MIT
"""An analysis as one page that any browser opens from disk: question, findings, a table that can be sorted, figures, replays, rules, commands and
tables to download. It judges nothing: findings and conclusions are those of `trophic.judge`."""
from __future__ import annotations

import base64
import json
import math
import os
import pathlib
import re
import shlex
import sys
import tempfile
from collections.abc import Mapping, Sequence
from typing import Any, Dict, List, Tuple

import jinja2
import pandas

from .. import controls, description, judge
from ..errors import ProgramError, RunError, printable
from ..programs import call, find_program
from ..values import METRIC, MeasuredSet, Metric
from ..words import Reading, metric_title, null_title, over_text, p_text
from ..writing import csv_text, encoded, write_new
from .text import answers_of

Replays = Tuple[str, List[Dict[str, str]]]
"""The viewer's page, with a place for runs, and the runs as parts of it with their labels."""
_PART = re.compile(
    r'(.*?)(<script type="application/json" id="trophic-index">.*?</script>\n(?:<script type="text/plain" data-run="[^<]*</script>\n)*)(.*)',
    re.S,
)


def read_figures(folder: str | os.PathLike) -> list[dict[str, Any]]:
    """The figures that `trophic plot` drew into a folder: each PNG that its captions.json names. Raises RunError for a folder without them."""
    path = pathlib.Path(folder) / "captions.json"
    try:
        captions = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise RunError(f"{path}: {getattr(error, 'strerror', None) or 'is not a JSON object'}") from None
    if not isinstance(captions, dict):
        raise RunError(f"{path}: is not a JSON object")
    figures = []
    for name, caption in captions.items():
        if not isinstance(caption, str) or pathlib.PurePath(name).name != name:
            raise RunError(f'{path}: "{name}": must be the name of a figure, and its caption a text')
        file = path.with_name(f"{name}.png")
        try:
            png = file.read_bytes()
        except OSError as error:
            raise RunError(f"{file}: {error.strerror}") from None
        if not png.startswith(b"\x89PNG"):
            raise RunError(f"{file}: is not a PNG")
        figures.append({"name": name, "caption": caption, "png": _base64(png), "wide": name.endswith("film_strip")})
    return figures


def write(
    path: str | os.PathLike,
    sets: Sequence[MeasuredSet],
    frames: Sequence[pandas.DataFrame],
    findings: Sequence[judge.Finding],
    request: Mapping[str, Any],
    *,
    text: str = "",
    downloads: Mapping[str, str] | None = None,
    replays: Replays | None = None,
) -> str:
    """Writes the page into a new file and returns the line about it for the terminal.

    `frames`: of judge.summarize for each set, or of judge.compare; `findings`: what they found, in order. `text`: the table of the terminal.
    `downloads`: CSV texts by file name. The request has `figures` (a folder of `trophic plot` or null), `who` and the options for the command that
    makes the page again. Raises RunError if the file exists or a figure is missing; then nothing is written.
    """
    described = [description.describe(one) for one in sets]
    tables = [_table(frame) for frame in frames]
    figures = read_figures(request["figures"]) if request.get("figures") else []
    viewer, parts = replays or ("", [])
    files = {"table.csv": _csv(tables), **(downloads or {})}
    page = (
        jinja2.Environment(
            loader=jinja2.FileSystemLoader(pathlib.Path(__file__).parent), autoescape=True, keep_trailing_newline=True
        )
        .get_template("page.html.j2")
        .render(
            title=" and ".join(f"{one.label} on {its.engine}" for one, its in zip(sets, described)),
            question=_question(sets),
            sentences=_sentences(sets, frames, findings),
            facts=_told(sets, [its.facts() for its in described]),
            replays=parts,
            viewer=_base64(encoded(viewer)),
            tables=tables,
            text=text,
            figures=figures,
            rules=_told(sets, [one.runs[0].manifest.get("rules", {}) for one in sets]),
            commands=[
                *(
                    one.runs[0].manifest[key]
                    for one in sets
                    for key in ("command_line",)
                    if key in one.runs[0].manifest
                ),
                command_of(request),
            ],
            downloads=[(name, _base64(encoded(content))) for name, content in files.items()],
        )
    )
    write_new(path, page)
    return f"page    {printable(str(path))}: {len(figures)} figures, {len(parts)} replays, {len(encoded(page)) / 1e6:.1f} MB\n"


def command_of(request: Mapping[str, Any]) -> str:
    """The command line that makes the page of a request again: the options that were given."""
    words = [*(request.get("runs") or [])]
    for name, value in request.items():
        if name in ("who", "runs", "replays", "jobs", "out", "all") or value in (None, False, [], ""):
            continue
        option = "--" + name.replace("_", "-")
        if value is True:
            words += [option]
        elif name == "compare":
            words += [option, *value]
        else:
            words += [
                word
                for one in (value if isinstance(value, list) else [value])
                for word in (option, f"{one:.15g}" if isinstance(one, float) else str(one))
            ]
    return " ".join([str(request["who"]), *map(shlex.quote, words)])


def _told(sets: Sequence[MeasuredSet], facts: Sequence[Mapping[str, str]]) -> list[tuple[str, str]]:
    """The facts of the sets by their names; those that all have in common once."""
    told = []
    for name in dict.fromkeys(name for of in facts for name in of):
        of_each = [of.get(name, "none") for of in facts]
        told += (
            [(name, of_each[0])]
            if len(set(of_each)) == 1
            else [(f"{name}, {one.label}", fact) for one, fact in zip(sets, of_each)]
        )
    return told


def _question(sets: Sequence[MeasuredSet]) -> str:
    if len(sets) > 1:
        return f"In what do {' and '.join(one.label for one in sets)} differ?"
    if sets[0].one_sided and not sets[0].inherited:
        return (
            f"Does inheritance matter under the rules of {sets[0].label}? Each species is compared with its one-sided world: the same rules and seeds, in which it alone "
            "inherits nothing."
        )
    if sets[0].neutral and sets[0].inherited:
        return (
            f"What is selected under the rules of {sets[0].label}? Measures of genomes, bodies and brains are compared with the neutral null: the births, deaths "
            "and parents of the runs, repeated with other genomes."
        )
    if sets[0].shadow:
        return (
            f"Does inheritance matter under the rules of {sets[0].label}? Each metric is compared with the neutral shadow: the same rules and seeds, with nothing "
            "inherited."
        )
    return f"Runs of {sets[0].label}. Without a neutral shadow no difference can be attributed to inheritance."


def _sentences(
    sets: Sequence[MeasuredSet], frames: Sequence[pandas.DataFrame], findings: Sequence[judge.Finding]
) -> list[str]:
    sentences = [f"{sentence[0].upper()}{sentence[1:]}." for one in sets for sentence in judge.too_few(one)]
    if len(sets) == 1:
        sentences += [
            f"{question} {answer[0].upper()}{answer[1:]}: {effect} {over}."
            for question, answer, effect, _, over in answers_of(sets[0], frames[0])
        ]
    told = (
        [controls.sentences(one, judge.metrics_of(frame)) for one, frame in zip(sets, frames)] if len(sets) == 1 else []
    )
    sentences += [f"{sentence[0].upper()}{sentence[1:]}." for its in told for sentence in its]
    sentences += [
        (f"{one.set}: " if one.set and len(sets) > 1 else "") + one.sentence for one in findings[: judge.MOST_FINDINGS]
    ]
    return [*sentences, *(judge.count(frame).sentence() for frame in frames)]


def replays_of(sets: Sequence[MeasuredSet], most: int | None, who: str) -> Replays | None:
    """The viewer's page and the first `most` runs of each set, as `trophic show` makes them. By default there are two of each set, and a run that
    cannot be shown is a remark; otherwise it raises ProgramError."""
    viewer, parts = "", []
    with tempfile.TemporaryDirectory(prefix="trophic-") as folder:
        try:
            for run, label in [(run, one.label) for one in sets for run in one.runs[: 2 if most is None else most]]:
                made = pathlib.Path(folder) / f"{len(parts)}.html"
                for remark in call(
                    find_program("trophic"), ["show", run.path, "-o", made], "trophic show"
                ).splitlines():
                    print(remark.replace("trophic show", who, 1), file=sys.stderr)
                before, part, after = _PART.fullmatch(made.read_text(encoding="utf-8", errors="surrogateescape")).groups()  # type: ignore[union-attr]
                viewer, name = f"{before}<!--RUNS-->{after}", run.path.resolve().name
                parts.append({"label": f"{label} {name}" if len(sets) > 1 else name, "part": part})
        except ProgramError as error:
            if most is not None:
                raise
            print(f"{who}: no replays: {str(error).removeprefix('trophic show: ')}", file=sys.stderr)
            return None
    return (viewer, parts) if parts else None


def _table(frame: pandas.DataFrame) -> dict[str, Any]:
    """Headings and rows of cells (text, what it is sorted by, bar). Each metric has a row with each null, or one if it has none; the terminal's table
    has other baselines too."""
    compares = "compared" in frame
    if not compares:
        frame = judge.with_nulls(frame)
    sets = set() if compares else set(frame["set"])
    if compares:
        first = frame.iloc[0] if len(frame) else {"set_a": "a", "set_b": "b"}
        headings = [
            "metric",
            f"{first['set_a']} [95 %]",
            f"{first['set_b']} [95 %]",
            "compared",
            "difference [95 %]",
            "",
            "p",
            "conclusion",
        ]
    else:
        headings = [
            *(["set"] if len(sets) > 1 else []),
            "metric",
            "ours [95 %]",
            "null",
            "ours - null [95 %]",
            "",
            "p",
            "conclusion",
        ]
    rows = []
    for row in frame.itertuples(index=False):
        if not compares and row.metric == "deaths" and row.group != "all" and row.mean == 0.0:
            continue  # no individual died of it
        metric = Metric(*(getattr(row, column) for column in METRIC))
        reading = Reading(metric)
        lower, upper = judge.interval_of_row(row)
        if compares:
            cells = [
                _cell(metric_title(metric)),
                _cell(reading.of(_estimate(row, "_a")), row.mean_a),
                _cell(reading.of(_estimate(row, "_b")), row.mean_b),
                _cell(over_text(row.compared)),
            ]
        else:
            cells = [
                *([_cell(row.set)] if len(sets) > 1 else []),
                _cell(metric_title(metric)),
                _cell(reading.of(_estimate(row)), row.mean),
                _cell(f"{null_title(row.null)} {reading(row.null_mean)}" if row.null else ""),
            ]
        cells += [
            _cell(
                reading.with_interval(row.difference, (lower, upper), True) if _is_known(row.difference) else "",
                row.difference,
            ),
            {"text": "", "key": None, "bar": _bar(row.difference, lower, upper)},
            _cell(p_text(row.p_holm), row.p_holm) if row.role == "null" else _cell(""),
            _cell(
                f"tested as {row.same_as}"
                if row.conclusion == "same"
                else f"not tested: {row.not_tested}"
                if row.not_tested
                else row.conclusion
            ),
        ]
        rows.append({"cells": cells, "side": row.conclusion if row.conclusion in ("above", "below") else "neither"})
    return {"headings": headings, "rows": rows}


def _estimate(row: Any, suffix: str = "") -> tuple:
    interval = (getattr(row, f"lower{suffix}"), getattr(row, f"upper{suffix}"))
    return getattr(row, f"n{suffix}"), getattr(row, f"mean{suffix}"), getattr(row, f"deviation{suffix}"), interval


def _is_known(value: float | None) -> bool:
    return value is not None and not math.isnan(value)


def _cell(text: str, key: float | None = None) -> dict[str, Any]:
    return {"text": text, "key": f"{key:.6g}" if _is_known(key) else None, "bar": None}


def _bar(value: float, lower: float, upper: float) -> tuple[str, str, str] | None:
    """Places of lower bound, value and upper bound in a bar with zero at 70."""
    if not (_is_known(value) and _is_known(lower) and _is_known(upper)):
        return None
    most = max(abs(lower), abs(upper), 1e-300)
    low, at, high = (f"{70.0 + 64.0 * one / most:.6g}" for one in (lower, value, upper))
    return low, at, high


def _csv(tables: Sequence[Mapping[str, Any]]) -> str:
    texts = []
    for table in tables:
        headings = [heading or "bar" for heading in table["headings"]]
        frame = pandas.DataFrame([[cell["text"] for cell in row["cells"]] for row in table["rows"]], columns=headings)
        texts.append(csv_text(frame.drop(columns="bar")))
    return "\n".join(texts)


def _base64(content: bytes) -> str:
    return base64.b64encode(content).decode()
