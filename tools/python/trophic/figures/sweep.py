# SPDX-License-Identifier: MIT
"""Figures of a sweep from what `trophic analyze` wrote of it: response curves, and heat maps of the difference to the reference cell.

A metric is METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP; without one those that `trophic analyze --metric` compared are drawn or, if it
compared all, the headline metrics of all groups together. An axis is a column of cells.csv: the first is drawn along x, the second as lines,
the third as panels; further ones stay at the reference cell's value."""
from __future__ import annotations

import functools
import itertools
import json
import re

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from .style import OTHER_COLOURS, Missing, caption, width_in

HEADLINE = [
    "attribution_caught",
    "attribution_credited",
    "velocity",
    "wall_sticking",
    "tag_symmetry",
    "population",
    "deaths",
    "hunger",
]
MARKERS = "os^Dvp*X"
MOST_PANELS, MOST_LINES, MOST_NUMBERS = 6, 8, 64
UNITS = {"m/s": ("cm/s", 100.0), "1": ("", 1.0)}


def is_number(value):
    try:
        return np.isfinite(float(value))
    except ValueError:
        return False


class Axis:
    """An axis of the sweep with its values in order."""

    def __init__(self, name, column, names):
        self.name = name
        tail = name.rsplit(".", 1)[-1]
        self.title = tail if sum(other.rsplit(".", 1)[-1] == tail for other in names) == 1 else name
        self.values = list(dict.fromkeys(column))
        self.numeric = all(map(is_number, self.values))
        if self.numeric:
            self.values.sort(key=float)

    def positions(self):
        """Positions of values along x: to scale if they are numbers that are about evenly spaced, else side by side."""
        if self.numeric and len(self.values) > 1:
            numbers = np.array(list(map(float, self.values)))
            steps = np.diff(numbers)
            if steps.max() <= 6 * steps.min():
                return numbers
        return np.arange(len(self.values), dtype=float)

    def text(self, value):
        return f"{float(value):g}" if self.numeric else (value or "unset")


class Sweep:
    """The tables of an analysed sweep."""

    def __init__(self, folder, axes=None):
        self.cells = pd.read_csv(folder / "cells.csv", dtype=str, keep_default_na=False)
        self.metrics = pd.read_csv(folder / "sweep_metrics.csv", dtype={"unit": str})
        differences = pd.read_csv(folder / "sweep_differences.csv", dtype={"unit": str, "significant": str})
        over = differences.compared == "over_shadow"
        self.differences = differences[over] if over.any() else differences  # the answers
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["sweep"]
        self.reference = summary["reference"]
        self.cells["cell"] = self.cells.cell.astype(int)
        self.cells = self.cells.set_index("cell")
        names = [axis["name"] for axis in summary["axes"]]
        for name in axes or []:
            if name not in names:
                raise KeyError(f"--axes {name}: must be one of {', '.join(names)}")
        self.axes = [Axis(name, self.cells[name], names) for name in axes or names]
        if not axes:
            self.axes.sort(key=lambda axis: (not axis.numeric, -len(axis.values)))
        self.fixed = {name: self.cells.loc[self.reference, name] for name in names}

    def chosen(self, choices):
        """(metric, rows of its series) of each metric to draw."""
        keys = self.metrics[["metric", "species", "group", "unit"]].drop_duplicates()
        if choices:
            parts = [choice.split(":") for choice in choices]
            named = [any(list(key[: len(part)]) == part for part in parts) for key in keys.itertuples(index=False)]
            for choice, part in zip(choices, parts):
                if not any(list(key[: len(part)]) == part for key in keys.itertuples(index=False)):
                    raise KeyError(f"--metric {choice}: sweep_metrics.csv has no such metric")
            keys = keys[named]
        elif self.chosen_before_looking(keys):
            keys = keys.merge(self.differences[["metric", "species", "group"]].drop_duplicates())
        else:
            keys = keys[
                keys.metric.isin(HEADLINE)
                & ((keys.group == "all") | (keys.metric + keys.group == "tag_symmetryinherited"))
            ]
        metrics = ((metric, list(rows.itertuples(index=False))) for metric, rows in keys.groupby("metric", sort=False))
        return [(metric, list(filter(self.varies, rows))) for metric, rows in metrics]

    def chosen_before_looking(self, keys):
        """Whether metrics were chosen in `trophic analyze`."""
        return 0 < len(self.differences[["metric", "species", "group"]].drop_duplicates()) < len(keys)

    def at(self, free):
        """The cells with the reference cell's values on all axes that are not free."""
        fixed = {name: value for name, value in self.fixed.items() if name not in {axis.name for axis in free}}
        chosen = self.cells
        for name, value in fixed.items():
            chosen = chosen[chosen[name] == value]
        titles = [f"{name.rsplit('.', 1)[-1]} {value or 'unset'}" for name, value in fixed.items()]
        return chosen, ", ".join(titles)

    def rows(self, table, key):
        found = table[(table.metric == key.metric) & (table.species == key.species) & (table.group == key.group)]
        return found.set_index("cell")

    def over_shadow(self, key):
        of = self.rows(self.differences, key)
        return len(of) > 0 and (of.compared == "over_shadow").all()

    def means(self, key):
        """mean, lower and upper by cell: over the shadow if cells were compared over it."""
        rows = self.rows(self.metrics, key)
        names = ["over_shadow", "over_lower", "over_upper"] if self.over_shadow(key) else ["mean", "lower", "upper"]
        return rows[names].set_axis(["mean", "lower", "upper"], axis=1) * UNITS.get(key.unit, ("", 1.0))[1]

    def is_significant(self, key):
        return self.rows(self.differences, key).significant == "yes"

    def title(self, key):
        unit = UNITS.get(key.unit, (key.unit, 1.0))[0]
        of = key.species + ("" if key.group == "all" else f", {key.group}")
        details = ("over shadow " if self.over_shadow(key) else "") + (f"[{unit}]" if unit else "")
        return f"{key.metric.replace('_', ' ')}\n{of}" + ("\n" + details if details else "")

    def varies(self, key):
        """Whether it varies between cells or between runs of a cell."""
        means = self.means(key)
        return means["mean"].nunique() > 1 or (means.upper > means.lower).any()


def shades(axis):
    """A colour for each value: along a scale for numbers, distinct for names."""
    count = len(axis.values)
    if axis.numeric and count > 1:
        return [plt.get_cmap("viridis")(0.9 * i / (count - 1)) for i in range(count)]
    return [(["#0072B2", "#D55E00"] + OTHER_COLOURS)[i % 6] for i in range(count)]


def panels_of(sweep, axis):
    """(value, title) of each panel; one panel without an axis."""
    if axis is None:
        return [(None, "")]
    if len(axis.values) > MOST_PANELS:
        return [(sweep.fixed[axis.name], f"{axis.title} {axis.text(sweep.fixed[axis.name])}")]
    return [(value, f"{axis.title} {axis.text(value)}") for value in axis.values]


def frame(rows, columns, size, legends, fixed, **sharing):
    """A figure with a grid of panels, above them a strip with a row for each legend, and below them the fixed settings."""
    legends = [handles for handles in legends if handles]
    in_a_row = max(1, int(size[0] / 1.1))
    heights = [0.04 + 0.17 * -(-len(handles) // in_a_row) for handles in legends]
    fig = plt.figure(figsize=(size[0], size[1] + sum(heights)))
    *strips, below = fig.subfigures(len(legends) + 1, 1, height_ratios=[*heights, size[1]])
    for strip, handles in zip(strips, legends):
        strip.legend(
            handles=handles, loc="center", ncol=min(len(handles), in_a_row), columnspacing=1.2, handlelength=1.6
        )
    if fixed:
        below.supxlabel(f"at {fixed}", fontsize=6.5, color="#555555")
    return fig, below, below.subplots(rows, columns, squeeze=False, **sharing)


def draw_line(ax, sweep, key, cells, x, shift, style, label):
    means = sweep.means(key).reindex(cells.index)
    position = dict(zip(x.values, x.positions()))
    where = np.array([position[value] for value in cells[x.name]]) + shift
    order = np.argsort(where)
    errors = np.vstack([means["mean"] - means.lower, means.upper - means["mean"]])
    ax.errorbar(
        where,
        means["mean"],
        np.nan_to_num(errors),
        fmt="none",
        color=style["color"],
        capsize=1.5,
        linewidth=0.8,
        alpha=0.8,
    )
    ax.plot(where[order], means["mean"].to_numpy()[order], color=style["color"], linewidth=1, label=label, zorder=3)
    significant = sweep.is_significant(key).reindex(cells.index, fill_value=False).to_numpy()
    for chosen, face in ((significant, style["color"]), (~significant, "white")):
        ax.plot(
            where[chosen],
            means["mean"].to_numpy()[chosen],
            style["marker"],
            ms=4,
            mfc=face,
            mec=style["color"],
            zorder=4,
        )
    for place in where[cells.index == sweep.reference]:
        ax.plot([place], [means["mean"].loc[sweep.reference]], "o", ms=9, mfc="none", mec="black", mew=0.8, zorder=5)


def response(sweep, keys):
    """A metric along the first axis: lines for the second, panels for the third, rows for its species and groups."""
    if not sweep.axes:
        raise Missing("the sweep has only one cell")
    if not keys:
        raise Missing("equal in all runs")
    x, lines, panels = (sweep.axes + [None, None])[:3]
    cells, fixed = sweep.at([axis for axis in (x, lines, panels) if axis])
    columns = panels_of(sweep, panels)
    values = lines.values[:MOST_LINES] if lines else [None]
    styles = [
        {"color": colour, "marker": MARKERS[i % len(MARKERS)]}
        for i, colour in enumerate(shades(lines) if lines else ["#0072B2"])
    ]
    of_lines = (
        [
            Line2D(
                [], [], color=s["color"], marker=s["marker"], ms=4, mfc="white", label=f"{lines.title} {lines.text(v)}"
            )
            for v, s in zip(values, styles)
        ]
        if lines
        else []
    )
    marks = [
        Line2D([], [], linestyle="", marker="o", ms=4, color="black", label="significant (corrected)"),
        Line2D([], [], linestyle="", marker="o", ms=4, mfc="white", mec="black", label="inconclusive"),
        Line2D([], [], linestyle="", marker="o", ms=9, mfc="none", mec="black", label="reference"),
    ]
    size = (max(width_in(), 1.1 + 1.9 * len(columns)), 0.4 + 1.5 * len(keys))
    fig, _, grid = frame(len(keys), len(columns), size, [of_lines, marks], fixed, sharex=True, sharey="row")
    step = np.diff(x.positions()).min() if len(x.values) > 1 else 1.0
    for row, key in enumerate(keys):
        for column, (panel, title) in enumerate(columns):
            ax = grid[row, column]
            here = cells if panel is None else cells[cells[panels.name] == panel]
            for i, (value, style) in enumerate(zip(values, styles)):
                of_line = here if value is None else here[here[lines.name] == value]
                shift = 0.0 if len(values) == 1 else 0.24 * step * (i / (len(values) - 1) - 0.5)
                draw_line(ax, sweep, key, of_line, x, shift, style, lines and lines.text(value))
            if row == 0 and title:
                ax.set_title(title)
            if row == len(keys) - 1:
                ax.set_xlabel(x.title)
            ax.set_xticks(
                x.positions(), [x.text(value) for value in x.values], rotation=0 if len(x.values) <= 6 else 60
            )
            ax.margins(x=0.08, y=0.12)
        grid[row, 0].set_ylabel(sweep.title(key), fontsize=7)
    return caption(
        fig,
        f"{keys[0].metric.replace('_', ' ').capitalize()} by {x.title}: means of the runs of a cell with 95 % intervals. Filled: differs from the reference cell, p <= 0.05 corrected for all comparisons.",
    )


def signed(value, largest):
    """A difference with the decimals that give two digits for the largest one."""
    decimals = max(0, 1 - int(np.floor(np.log10(largest))))
    return f"{round(value, decimals) + 0.0:+.{decimals}f}"


def draw_map(ax, sweep, key, cells, x, y, limit, with_numbers):
    """Draws one heat map; the legend explains its cells."""
    differences = sweep.rows(sweep.differences, key)
    factor = UNITS.get(key.unit, ("", 1.0))[1]
    values = np.full((len(y.values), len(x.values)), np.nan)
    significant = sweep.is_significant(key)
    for cell, at in cells.iterrows():
        place = y.values.index(at[y.name]), x.values.index(at[x.name])
        if cell == sweep.reference:
            values[place] = 0.0
            ax.add_patch(
                Rectangle(
                    (place[1] - 0.5, place[0] - 0.5),
                    1,
                    1,
                    fill=False,
                    edgecolor="black",
                    linewidth=1.6,
                    zorder=4,
                    clip_on=False,
                )
            )
        elif cell in differences.index:
            values[place] = factor * differences.difference[cell]
            if not significant[cell]:
                ax.add_patch(
                    Rectangle(
                        (place[1] - 0.5, place[0] - 0.5),
                        1,
                        1,
                        fill=False,
                        edgecolor="#777777",
                        hatch="////",
                        linewidth=0,
                        zorder=2,
                    )
                )
    image = ax.imshow(values, cmap="RdBu_r", vmin=-limit, vmax=limit, origin="lower", aspect="auto")
    image.cmap.set_bad("#dddddd")
    if with_numbers:
        for (row, column), value in np.ndenumerate(values):
            if np.isnan(value):
                continue
            is_reference = (
                cells.index[(cells[x.name] == x.values[column]) & (cells[y.name] == y.values[row])][0]
                == sweep.reference
            )
            text = "ref" if is_reference else signed(value, limit)
            ax.text(
                column,
                row,
                text,
                ha="center",
                va="center",
                fontsize=6,
                zorder=5,
                bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "alpha": 0.85, "linewidth": 0},
            )
    ax.set_xticks(range(len(x.values)), [x.text(value) for value in x.values], rotation=0 if len(x.values) <= 6 else 60)
    ax.set_yticks(range(len(y.values)), [y.text(value) for value in y.values])
    for spine in ax.spines.values():
        spine.set_visible(False)
    ax.tick_params(length=0)
    return image


def heat(sweep, keys, x, y):
    """The difference to the reference cell over two axes, panels for a third, rows for species and groups."""
    if not keys:
        raise Missing("equal in all runs")
    rest = [axis for axis in sweep.axes if axis not in (x, y)]
    panels = rest[0] if rest else None
    cells, fixed = sweep.at([axis for axis in (x, y, panels) if axis])
    columns = panels_of(sweep, panels)
    size = (
        max(width_in(), 1.3 + len(columns) * max(1.3, 0.38 * len(x.values))),
        0.4 + len(keys) * max(1.1, 0.3 * len(y.values)),
    )
    handles = [
        Patch(facecolor="white", edgecolor="#777777", hatch="////", linewidth=0, label="inconclusive"),
        Patch(facecolor="#d6604d", label="significant (corrected)"),
        Patch(facecolor="white", edgecolor="black", linewidth=1.6, label="reference"),
    ]
    if cells.shape[0] < len(x.values) * len(y.values) * len(columns):
        handles.append(Patch(facecolor="#dddddd", label="no such cell"))
    fig, panel_figure, grid = frame(len(keys), len(columns), size, [handles], fixed, sharex=True, sharey=True)
    for row, key in enumerate(keys):
        differences = (
            sweep.rows(sweep.differences, key).difference.reindex(cells.index) * UNITS.get(key.unit, ("", 1.0))[1]
        )
        limit = differences.abs().max()
        if not limit > 0:
            limit = 1.0
        for column, (panel, title) in enumerate(columns):
            ax = grid[row, column]
            here = cells if panel is None else cells[cells[panels.name] == panel]
            image = draw_map(ax, sweep, key, here, x, y, limit, len(x.values) * len(y.values) <= MOST_NUMBERS)
            if row == 0 and title:
                ax.set_title(title)
            if row == len(keys) - 1:
                ax.set_xlabel(x.title)
            if column == 0:
                ax.set_ylabel(y.title)
        bar = panel_figure.colorbar(image, ax=grid[row, :], pad=0.02)
        bar.set_label(sweep.title(key) + "\n- reference", fontsize=7)
        bar.outline.set_visible(False)
    return caption(
        fig,
        f"{keys[0].metric.replace('_', ' ').capitalize()} by {x.title} and {y.title}: difference of each cell to the reference cell. Hatched: inconclusive after the correction for all comparisons.",
    )


def figures_of(folder, metrics=None, axes=None):
    """(name, function) for each figure of an analysed sweep. Raises KeyError, naming the option, for a metric or axis that it lacks."""
    sweep = Sweep(folder, axes)
    figures = []
    for metric, keys in sweep.chosen(metrics):
        figures.append((f"response-{metric}", functools.partial(response, sweep, keys)))
        for x, y in itertools.combinations(sweep.axes, 2):
            pair = "-".join(re.sub(r"\W+", "_", axis.title) for axis in (x, y))
            figures.append((f"heat-{metric}-{pair}", functools.partial(heat, sweep, keys, x, y)))
    return figures
