# SPDX-License-Identifier: MIT
"""One figure of a cross-check: the equivalence of the metrics."""
from __future__ import annotations

import functools
import pathlib

import matplotlib.pyplot as plt
import pandas as pd

from .style import Missing, caption


def draw_metrics(axes, metrics, engines):
    """Differences in units of their margins: equivalent if the bar stays within +-1. `engines`: of the first set and the second."""
    rows = metrics.iloc[::-1].reset_index(drop=True)
    names = [f"{r.quantity} {r.species}" + ("" if r.group == "all" else f" ({r.group})") for r in rows.itertuples()]
    middle = rows.difference / rows.margin
    errors = [middle - rows.difference_lower / rows.margin, rows.difference_upper / rows.margin - middle]
    axes.errorbar(middle, rows.index, xerr=errors, fmt="o", color="black", markersize=3, linewidth=1)
    axes.axvspan(-1, 1, color="#009E73", alpha=0.15)
    axes.axvline(0, color="#555555", linewidth=0.6)
    axes.set_yticks(rows.index, names, fontsize=6)
    axes.set_xlabel(" - ".join(engine.split()[0] for engine in reversed(engines)) + ", in margins [90 %]", loc="right")


def cross_check(folder):
    """The figure of a cross-check's folder."""
    table = pd.read_csv(pathlib.Path(folder) / "cross_check.csv")
    if table.difference.isna().all():
        raise Missing("no difference is known")
    figure, panel = plt.subplots(figsize=(5.0, 4.0))
    draw_metrics(panel, table[table.conclusion.notna()], table.engine.unique())
    return caption(
        figure,
        "Differences between engines in units of their margins with 90 % intervals: equivalent within the green band.",
    )


def figures_of(folder):
    """(name, function) of the one figure."""
    return [("cross_check", functools.partial(cross_check, folder))]
