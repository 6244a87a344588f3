# SPDX-License-Identifier: MIT
"""The matrices of what `trophic contest` wrote: mean contact time by epoch of hunters and of victims, next to the shadow's."""
from __future__ import annotations

import functools
import pathlib

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

from .style import Missing, caption, width_in

OPPONENTS = {
    "own": "opponents from the same run",
    "others": "opponents of other replicates",
    "panel_victims": "victims of a panel",
    "panel_hunters": "hunters of a panel",
}


def matrix(rows):
    """Mean over replicates of the means over teams: a row for each epoch of hunters, a column for each of victims."""
    by_run = rows.groupby(["hunters_run", "hunter_epoch_s", "victim_epoch_s"]).contact_s.mean()
    return by_run.groupby(["hunter_epoch_s", "victim_epoch_s"]).mean().unstack()


def draw_matrix(axes, cells, limits, hunter, victim):
    shown = axes.imshow(cells.to_numpy(), origin="lower", cmap="cividis", vmin=limits[0], vmax=limits[1])
    for (row, column), value in np.ndenumerate(cells.to_numpy()):
        is_dark = value < sum(limits) / 2
        axes.text(
            column, row, f"{value:.0f}", ha="center", va="center", fontsize=6, color="white" if is_dark else "black"
        )
    axes.set_xticks(range(len(cells.columns)), [f"{epoch:g}" for epoch in cells.columns], rotation=45, ha="right")
    axes.set_yticks(range(len(cells.index)), [f"{epoch:g}" for epoch in cells.index])
    axes.set_xlabel(f"epoch of {victim}, s")
    return shown


def contests(folder, against, hunter, victim):
    """The matrix of one feeding link and kind of opponents, and the shadow's."""
    table = pd.read_csv(pathlib.Path(folder) / "contests.csv")
    rows = table[(table.against == against) & (table.hunter == hunter) & (table.victim == victim)]
    sets = [(title, rows[rows.shadow == shadow]) for title, shadow in (("runs", 0), ("neutral shadow", 1))]
    sets = [(title, part) for title, part in sets if not part.empty]
    if not sets:
        raise Missing("no contests")
    matrices = [matrix(part) for _, part in sets]
    limits = (min(cells.to_numpy().min() for cells in matrices), max(cells.to_numpy().max() for cells in matrices))
    figure, panels = plt.subplots(
        1,
        len(sets),
        figsize=(width_in(), 0.57 * width_in() if len(sets) > 1 else 0.9 * width_in()),
        squeeze=False,
        layout="constrained",
    )
    for axes, (title, part), cells in zip(panels[0], sets, matrices):
        shown = draw_matrix(axes, cells, limits, hunter, victim)
        axes.set_title(f"{title} ({part.hunters_run.nunique()})", fontsize=7)
    panels[0][0].set_ylabel(f"epoch of {hunter}, s")
    figure.colorbar(shown, ax=list(panels[0]), label="contact time, s", shrink=0.6)
    return caption(
        figure,
        f"Mean time until a {hunter} reaches a {victim}, with {OPPONENTS[against]}. Rows: epoch of {hunter}; columns: epoch of "
        f"{victim}. Hunters' progress makes rows smaller upwards, victims' progress columns larger to the right. In brackets: replicates.",
    )


def figures_of(folder):
    """(name, function) of a figure for each feeding link and kind of opponents."""
    table = pd.read_csv(pathlib.Path(folder) / "contests.csv")
    kinds = table[["against", "hunter", "victim"]].drop_duplicates()
    return [
        (
            f"contests_{kind.hunter}_{kind.victim}_{kind.against}",
            functools.partial(contests, folder, kind.against, kind.hunter, kind.victim),
        )
        for kind in kinds.itertuples()
    ]
