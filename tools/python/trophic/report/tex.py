# SPDX-License-Identifier: MIT
"""Results for papers: LaTeX tables (booktabs, tabularx) as wide as the line that they are put into."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pandas

from .. import controls
from ..description import describe
from ..judge import count, interval_of_row, metrics_of, runs_of
from ..values import SHADOW, MeasuredSet, Metric
from ..words import Reading, latex_text, metric_title, null_title, one_line, over_nulls, p_text
from .text import answers_of, estimate_of

_PACKAGES = "% \\usepackage{booktabs,tabularx}; \\input{} this file in a table, or in a table* of two columns.\n"


def means(of: MeasuredSet, frame: pandas.DataFrame) -> str:
    """The table of a set, each metric next to each null once; `frame`: of judge.summarize."""
    rows = []
    for row in frame[(frame["role"] == "null") & (frame["same_as"] == "") & frame["difference"].notna()].itertuples(
        index=False
    ):
        metric = Metric(row.metric, row.species, row.group, row.unit)
        reading = Reading(metric)
        null = "" if row.null == SHADOW else f" (null: {null_title(row.null)})"
        rows.append(
            [
                latex_text(metric_title(metric) + null),
                math(reading.of(estimate_of(row))),
                math(reading(row.null_mean)),
                math(reading.with_interval(row.difference, interval_of_row(row), True)),
                math(p_text(row.p_holm)),
                math(runs_of(row).replace("+", "{+}")),
            ]
        )
    about = f"% {heading(of)}. Null: the neutral shadow, unless another is named. {_family(frame)}\n"
    about += "".join(f"% {one_line(sentence)}\n" for sentence in controls.sentences(of, metrics_of(frame)))
    return (
        _PACKAGES
        + about
        + _table(["metric", "mean [95\\,\\%]", "null", "mean $-$ null [95\\,\\%]", "$p$", "$n$"], rows)
    )


def answers(of: MeasuredSet, frame: pandas.DataFrame) -> str:
    """The answers to the paper's questions about evolution."""
    rows = [
        [
            latex_text(question),
            latex_text(answer),
            math(effect.removesuffix(" cm/s")) + " cm/s" * effect.endswith("cm/s"),
        ]
        for question, answer, effect, *_ in answers_of(of, frame)
    ]
    return (
        _PACKAGES
        + f"% {heading(of)}. Effects: {', '.join(dict.fromkeys(over for *_, over in answers_of(of, frame)))}; their intervals hold for all comparisons at once (Bonferroni).\n"
        + _table(["question", "answer", "effect [95\\,\\%]"], rows, 2)
    )


def differences(a: MeasuredSet, b: MeasuredSet, frame: pandas.DataFrame) -> str:
    """The answer of a comparison: over nulls if both sets have one, else raw; `frame`: of judge.compare."""
    over, short, _ = over_nulls(frame["compared"])
    rows = []
    for row in frame[(frame["role"] == "null") & (frame["same_as"] == "") & frame["difference"].notna()].itertuples(
        index=False
    ):
        metric = Metric(row.metric, row.species, row.group, row.unit)
        reading = Reading(metric)
        rows.append(
            [
                latex_text(metric_title(metric)),
                math(reading(row.mean_a)),
                math(reading(row.mean_b)),
                math(reading.with_interval(row.difference, interval_of_row(row), True)),
                math(p_text(row.p_holm)),
                math(runs_of(row).replace("+", "{+}")),
            ]
        )
    what = over or "b - a"
    about = f"% a: {heading(a)}; b: {heading(b)}; {what}. {_family(frame)}\n"
    column = f"{short} [95\\,\\%]" if short else "difference [95\\,\\%]"
    return _PACKAGES + about + _table(["metric", latex_text(a.label), latex_text(b.label), column, "$p$", "$n$"], rows)


def heading(of: MeasuredSet) -> str:
    """A set in half a line of a comment."""
    said = describe(of)
    return one_line(f"{of.label} on {said.engine}, {said.length()}")


def math(text: Any) -> str:
    """A number with its interval in mathematics; a dash if there is none."""
    return "--" if text in ("", "missing") else "$" + str(text).replace(" ", "\\ ") + "$"


def _family(frame: pandas.DataFrame) -> str:
    return f"p: Holm, corrected for {count(frame).comparisons} comparisons; their intervals hold at once (Bonferroni)."


def _table(head: Sequence[str], rows: Sequence[Sequence[str]], texts: int = 1) -> str:
    """Numbers behind first columns of texts, which take the rest of the line."""
    lines = [" & ".join(cells) + " \\\\\n" for cells in (head, *rows)]
    return (
        "{\\scriptsize\\setlength{\\tabcolsep}{3pt}%\n\\begin{tabularx}{\\linewidth}{@{}*{"
        + str(texts)
        + "}{>{\\raggedright\\arraybackslash}X}*{"
        + str(len(head) - texts)
        + "}{r}@{}}\n\\toprule\n"
        + lines[0]
        + "\\midrule\n"
        + "".join(lines[1:])
        + "\\bottomrule\n\\end{tabularx}}\n"
    )
