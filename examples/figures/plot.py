#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the paper's figures, and three more, from what `trophic analyze` wrote.

    python3 examples/figures/plot.py ANALYSIS [--out FOLDER] [--run K]

ANALYSIS is the folder with metrics.csv and summary.json. Each figure goes to FOLDER (ANALYSIS/figures) as PNG and PDF, in the
width of an article's column; of a comparison, each set gets its own. A figure whose data are missing is left out, with a line
that says so. Needs matplotlib and pandas (Debian: python3-matplotlib, python3-pandas).
"""
import argparse
import functools
import pathlib
import re
import sys

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from style import COLOURS, COLUMN_IN, NULL_COLOUR, Missing, colour, save_all

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from trophic.runs import RunError, read_analysis  # noqa: E402

CAUSES = {"caught": ("#56B4E9", ""), "sacrificed": ("#F0E442", "////"), "starved": ("#D55E00", ""), "senescence": ("#999999", "..")}
# Mean over the paper's ten runs; the range is that of its runs.
PAPER = {"attribution_caught": 0.65, "attribution_credited": 0.725, "wall_sticking": {"predator": 0.39, "prey": 0.60},
         "velocity": {"predator": 1.95, "prey": -0.67}, "tag_symmetry": (0.43, 0.33, 0.53)}

# Student's t at 97.5 %, by degrees of freedom; in between the next smaller is taken.
STUDENT = {5: 2.571, 6: 2.447, 7: 2.365, 8: 2.306, 9: 2.262, 11: 2.201, 14: 2.145, 19: 2.093, 29: 2.045, 59: 2.001, 119: 1.980}


def interval(runs):
    """The mean over runs (rows) of each column, and its 95 % interval as `trophic analyze` has it; NaN where fewer than six have a value."""
    runs = np.atleast_2d(np.asarray(runs, float))
    count = (~np.isnan(runs)).sum(axis=0)
    with np.errstate(all="ignore"):
        mean = np.nansum(runs, axis=0) / np.where(count == 0, np.nan, count)
        error = np.sqrt(np.nansum((runs - mean) ** 2, axis=0) / (count - 1) / count)
    half = np.array([STUDENT[max(f for f in STUDENT if f < n)] * e if n >= 6 else np.nan for n, e in zip(count, error)])
    return mean, mean - half, mean + half


class Data:
    """One set of runs."""

    def __init__(self, metrics, summary, run):
        self.metrics, self.summary = metrics, summary
        self.folders = [pathlib.Path(r["folder"]) for r in summary["runs"]]
        self.run = run
        self.species = list(dict.fromkeys(metrics.loc[metrics.metric == "population", "species"]))

    def rows(self, metric, species=None, group=None, baseline="", curve=False):
        m = self.metrics
        chosen = (m.metric == metric) & (m.baseline == baseline) & (m.time_s.notna() == curve)
        if species is not None:
            chosen &= m.species == species
        if group is not None:
            chosen &= m.group == group
        return m[chosen & m.value.notna()]

    def values(self, metric, species=None, group=None, baseline=""):
        """One number per run."""
        found = self.rows(metric, species, group, baseline)
        if found.empty:
            raise Missing(f"no value of {metric}" + (f" of {species}" if species else ""))
        return found.value.to_numpy()

    @property
    def has_shadow(self):
        return (self.metrics.baseline == "shadow").any()

    def curve(self, metric, species, group="all", baseline=""):
        """Window ends, and one row per run."""
        found = self.rows(metric, species, group, baseline, curve=True)
        if found.empty:
            raise Missing(f"no curve of {metric} of {species}")
        table = found.pivot_table(index="run", columns="time_s", values="value")
        return table.columns.to_numpy(), table.to_numpy()

    def table(self, folder, name, columns):
        try:
            return pd.read_csv(folder / name, usecols=columns, on_bad_lines="skip")
        except (OSError, ValueError) as error:
            raise Missing(f"{folder / name}: {error}") from error


def draw_shadow(ax, data, metric, species, group="all", label=None, scale=1.0):
    """The mean over the shadow's runs and its 95 % interval as a band."""
    if data.has_shadow and not data.rows(metric, species, group, "shadow").empty:
        mean, lower, upper = (scale * x[0] for x in interval(data.values(metric, species, group, "shadow")[:, None]))
        ax.axhspan(lower, upper, color="black", alpha=0.15, linewidth=0)
        ax.axhline(mean, color="black", linestyle=":", linewidth=1, label=label)


def draw_curve(ax, time_s, runs, label, colour_, style="-", average=True, scale=1.0):
    mean, lower, upper = interval(runs * scale)
    middle_s = time_s - (time_s[0] / 2 if len(time_s) else 0)
    ax.fill_between(middle_s, lower, upper, color=colour_, alpha=0.2, linewidth=0)
    ax.plot(middle_s, mean, style, color=colour_, label=label)
    if average:
        ax.axhline(np.nanmean(mean), color=colour_, linestyle=style, linewidth=0.6)


def attribution(data):
    bars = [("attribution_caught", "caught"), ("attribution_credited", "credited"), ("attribution_catches", "catches")]
    fig, ax = plt.subplots(figsize=(COLUMN_IN, 2.6))
    names, place = [], 0
    for metric, word in bars:
        for species in data.species:
            if data.rows(metric, species).empty:
                continue
            values = data.values(metric, species)
            mean, lower, upper = (x[0] for x in interval(values[:, None]))
            ax.bar(place, mean, 0.62, color=colour(species, data.species), alpha=0.75)
            if np.isfinite(lower):
                ax.errorbar(place - 0.18, mean, [[mean - lower], [upper - mean]], color="black", capsize=2, linewidth=1)
            ax.plot(place + np.linspace(-0.08, 0.08, len(values)), values, "o", ms=2, color="black", alpha=0.6)
            if data.has_shadow:
                mean, lower, upper = (x[0] for x in interval(data.values(metric, species, baseline="shadow")[:, None]))
                ax.fill_between([place - 0.31, place + 0.31], lower, upper, color="black", alpha=0.25, linewidth=0)
                ax.plot([place - 0.31, place + 0.31], [mean] * 2, color="black", linewidth=1.6,
                        label="null: nothing inherited" if place == 0 else None)
            if metric in PAPER and species in COLOURS:
                ax.plot(place + 0.22, PAPER[metric], "D", ms=4.5, mfc="white", mec="black",
                        label="published" if "published" not in ax.get_legend_handles_labels()[1] else None)
            names.append(f"{species}:\n{word}")
            place += 1
    if place == 0:
        raise Missing("no attribution: nobody was caught")
    ax.axhline(2 / 3, color="#CC0000", linestyle="--", linewidth=1, label="paper's baseline 2/3")
    ax.set(xticks=range(place), ylim=(0, 1.12), ylabel="inherited share (attribution)")
    ax.set_xticklabels(names)
    ax.legend(loc="upper left", ncol=2, columnspacing=1, handlelength=1.6)
    return fig


def velocity(data):
    fig, axes = plt.subplots(len(data.species), 1, figsize=(COLUMN_IN, 1.55 * len(data.species) + 0.3), sharex=True, squeeze=False)
    for ax, species in zip(axes[:, 0], data.species[::-1]):
        for group, style, shade in (("inherited", "-", colour(species, data.species)), ("random", "--", NULL_COLOUR)):
            time_s, runs = data.curve("velocity", species, group)
            draw_curve(ax, time_s, runs, group, shade, style, scale=100)
        draw_shadow(ax, data, "velocity", species, "inherited", "inherited, shadow", scale=100)
        ax.axhline(0, color="black", linewidth=0.4)
        if species in PAPER["velocity"]:
            ax.plot([1.0], [PAPER["velocity"][species]], "D", ms=4.5, mfc="white", mec="black", clip_on=False,
                    transform=ax.get_yaxis_transform(), label="published mean")
        ax.set_ylabel(f"{species}: velocity to\nadversary [cm/s]")
        low, high = ax.get_ylim()
        ax.set_ylim(low, high + 0.38 * (high - low))
        ax.legend(ncol=2, loc="upper right", columnspacing=1, handlelength=1.8)
    axes[-1, 0].set_xlabel("time [s]")
    return fig


def wall_sticking(data):
    fig, ax = plt.subplots(figsize=(COLUMN_IN, 2.3))
    for species in data.species:
        shade = colour(species, data.species)
        time_s, runs = data.curve("wall_sticking", species)
        draw_curve(ax, time_s, runs, species, shade, "-" if species == data.species[0] else "--")
        if data.has_shadow:
            mean = data.values("wall_sticking", species, "all", "shadow").mean()
            ax.axhline(mean, color=shade, linestyle="-.", linewidth=0.8, label=f"{species}, shadow")
        if species in PAPER["wall_sticking"]:
            ax.plot([1.0], [PAPER["wall_sticking"][species]], "D", ms=4.5, mfc="white", mec=shade, clip_on=False,
                    transform=ax.get_yaxis_transform(), label=f"{species}, published mean")
    spread = data.values("wall_sticking", data.species[0], "all", "even_spread")[0]
    ax.axhline(spread, color="black", linestyle=":", linewidth=1, label="evenly spread (no null)")
    ax.set(xlabel="time [s]", ylabel="share within 1 m of a wall", ylim=(0, 1.15))
    ax.legend(ncol=2, loc="upper left", columnspacing=1)
    return fig


def tag_symmetry(data):
    fig, ax = plt.subplots(figsize=(COLUMN_IN, 2.6))
    rows = [("ours", "", "#0072B2"), ("null: dealt tags", "dealt_tags", NULL_COLOUR), ("fair coins", "fair_coins", "#999999")]
    if data.has_shadow:
        rows.insert(1, ("null: nothing\ninherited", "shadow", NULL_COLOUR))
    uniform = data.values("tag_symmetry", baseline="uniform_pairs")[0]
    jitter = np.random.default_rng(2)
    for place, (_, baseline, shade) in enumerate(rows):
        numbers = data.values("tag_symmetry", baseline=baseline)
        ax.boxplot(numbers, positions=[place], widths=0.5, vert=False, showfliers=False, medianprops={"color": "black"},
                   boxprops={"color": shade}, whiskerprops={"color": shade}, capprops={"color": shade})
        ax.plot(numbers, place + jitter.uniform(-0.12, 0.12, len(numbers)), "o", ms=3, color=shade, alpha=0.8)
    top = len(rows)
    mean, low, high = PAPER["tag_symmetry"]
    ax.errorbar([mean], [top], xerr=[[mean - low], [high - mean]], fmt="D", ms=4.5, mfc="white", mec="black", color="black", capsize=2)
    ax.axvline(uniform, color="#CC0000", linestyle="--", linewidth=1)
    ax.text(uniform - 0.005, top + 0.42, "paper's baseline 2/3", color="#CC0000", ha="right", fontsize=7)
    ax.set(yticks=range(top + 1), ylim=(-0.5, top + 0.65), xlabel="tag symmetry, mean of each run")
    ax.set_yticklabels([name for name, _, _ in rows] + ["published\n(mean, range)"])
    return fig


def population(data):
    fig, axes = plt.subplots(3, 1, figsize=(COLUMN_IN, 4.2), sharex=True, gridspec_kw={"height_ratios": [1, 0.8, 1.2]})
    for species in data.species:
        time_s, runs = data.curve("population", species)
        draw_curve(axes[0], time_s, runs, species, colour(species, data.species), average=False)
        if not data.rows("hunger", species, curve=True).empty:
            draw_curve(axes[1], *data.curve("hunger", species), species, colour(species, data.species), average=False)
    axes[0].set_ylabel("individuals")
    axes[0].set_ylim(bottom=0)
    axes[0].legend(ncol=2)
    axes[1].set_ylabel("hunger [ticks]")
    axes[1].set_ylim(bottom=0)
    bottom = 0
    for species in data.species:
        for cause, (shade, hatch) in CAUSES.items():
            if data.rows("deaths", species, cause, curve=True).value.sum() == 0:
                continue
            time_s, runs = data.curve("deaths", species, cause)
            mean = np.nanmean(runs, axis=0)
            axes[2].bar(time_s - time_s[0] / 2, mean, time_s[0] * 0.9, bottom, color=shade, hatch=hatch, linewidth=0.3,
                        edgecolor="black", label=f"{species}, {cause}")
            bottom = bottom + mean
    axes[2].set(xlabel="time [s]", ylabel="deaths per 200 s")
    axes[2].set_ylim(0, 1.3 * np.max(bottom) if np.ndim(bottom) else 1)
    if np.ndim(bottom):
        axes[2].legend(ncol=2, columnspacing=1)
    return fig


def phylogeny(data):
    folder = data.folders[data.run]
    tree = data.table(folder, "phylogeny.csv", ["id", "ancestor_id", "origin_time", "destruction_time", "species"])
    if tree.empty:
        raise Missing(f"{folder / 'phylogeny.csv'}: nobody in it")
    tree = tree.sort_values("origin_time", kind="stable").set_index("id")
    end_s = max(tree.destruction_time.replace(np.inf, 0).max(), tree.origin_time.max())
    children = {}
    for child, parent in tree.ancestor_id.items():
        if parent != child and parent in tree.index:
            children.setdefault(parent, []).append(child)
    roots = [i for i in tree.index if tree.ancestor_id[i] == i or tree.ancestor_id[i] not in tree.index]
    rows, waiting = {}, roots[::-1]
    while waiting:
        individual = waiting.pop()
        rows[individual] = len(rows)
        waiting.extend(children.get(individual, []))
    fig, ax = plt.subplots(figsize=(COLUMN_IN, 4.4))
    for species in data.species:
        of = tree[tree.species == species]
        y = [rows[i] for i in of.index]
        ax.hlines(y, of.origin_time, of.destruction_time.replace(np.inf, end_s), color=colour(species, data.species), linewidth=0.7,
                  label=species)
    links = [(tree.origin_time[c], rows[p], rows[c]) for p, offspring in children.items() for c in offspring]
    if links:
        x, low, high = zip(*links)
        ax.vlines(x, low, high, color="black", linewidth=0.2, alpha=0.6)
    ax.set(xlabel="time [s]", ylabel=f"individuals of {folder.name}, by descent", ylim=(-2, len(rows) * 1.07), yticks=[])
    ax.legend(loc="upper left", ncol=len(data.species))
    return fig


def catches(data):
    places = []
    for folder in data.folders:
        events = data.table(folder, "events.csv", ["event", "x_m", "y_m"])
        places.append(events[events.event == "catch"])
    places = pd.concat(places)
    if places.empty:
        raise Missing("nobody was caught")
    half_m = data.summary["runs"][0]["half_side_m"]
    edge_m = max(half_m, places[["x_m", "y_m"]].abs().max().max())
    cells = 20
    counts, x_m, y_m = np.histogram2d(places.x_m, places.y_m, bins=cells, range=[[-edge_m, edge_m]] * 2)
    density = counts / len(data.folders) / (2 * edge_m / cells) ** 2
    fig, ax = plt.subplots(figsize=(COLUMN_IN, 2.9))
    image = ax.pcolormesh(x_m, y_m, density.T, cmap="cividis", vmin=0, rasterized=True)
    ax.plot(half_m * np.array([-1, 1, 1, -1, -1]), half_m * np.array([-1, -1, 1, 1, -1]), color="black", linewidth=1)
    ax.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title=f"{len(places)} catches in {len(data.folders)} runs")
    fig.colorbar(image, label="catches per m² and run", shrink=0.9)
    return fig


FIGURES = [attribution, velocity, wall_sticking, tag_symmetry, population, phylogeny, catches]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("analysis", type=pathlib.Path, help="folder that `trophic analyze` wrote")
    parser.add_argument("--out", type=pathlib.Path, help="folder for the figures (ANALYSIS/figures)")
    parser.add_argument("--run", type=int, default=0, help="whose phylogeny is drawn: the K-th run of a set (0)")
    options = parser.parse_args()
    try:
        analysis = read_analysis(options.analysis)
        sets = [Data(analysis.metrics[analysis.metrics["set"] == s["set"]], s, options.run) for s in analysis.summary["sets"]]
    except RunError as error:
        sys.exit(f"plot.py: {error}")
    except (OSError, ValueError, KeyError, AttributeError) as error:
        sys.exit(f"plot.py: {options.analysis}: not what trophic analyze writes: {error}")
    if any(not 0 <= options.run < len(data.folders) for data in sets):
        sys.exit(f"plot.py: --run {options.run}: must be >= 0 and < the number of runs")
    out = options.out or options.analysis / "figures"
    figures = []
    for data in sets:
        prefix = "" if len(sets) == 1 else re.sub(r"\W+", "_", data.summary["set"]).strip("_") + "-"
        figures += [(prefix + draw.__name__, functools.partial(draw, data)) for draw in FIGURES]
    drawn = save_all(figures, out)
    print(f"{drawn} figures in {out}")
    return 0 if drawn else 1


if __name__ == "__main__":
    sys.exit(main())
