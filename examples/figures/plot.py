#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the paper's figures, and pictures of runs, from what `trophic analyze` wrote.

    python3 examples/figures/plot.py ANALYSIS [--out FOLDER] [--run K] [--trophic PROGRAM]

ANALYSIS is the folder with metrics.csv and summary.json. Each figure goes to FOLDER (ANALYSIS/figures) as PNG and PDF, in the
width of an article's column, and what its caption says to FOLDER/captions.json; of a comparison, each set gets its own. A figure
whose data are missing is left out, with a line that says so. The film strip of a catch is drawn by `trophic film`. Needs
matplotlib, pandas and scipy (Debian: python3-matplotlib, python3-pandas, python3-scipy).
"""
import argparse
import functools
import pathlib
import re
import sys

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from scipy import stats
from pictures import catches, film_strip, phylogeny, trajectories
from style import COLOURS, COLUMN_IN, NULL_COLOUR, Missing, caption, colour, line, save_all

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/python"))
from trophic.runs import RunError, read_analysis  # noqa: E402

HATCHES = {"caught": "", "starved": "////", "sacrificed": "xxxx", "senescence": "...."}


def interval(runs):
    """The mean over runs (rows) of each column, and its 95 % interval as `trophic analyze` has it; NaN where fewer than six have a value."""
    runs = np.atleast_2d(np.asarray(runs, float))
    count = (~np.isnan(runs)).sum(axis=0)
    with np.errstate(all="ignore"):
        mean = np.nansum(runs, axis=0) / np.where(count == 0, np.nan, count)
        error = np.sqrt(np.nansum((runs - mean) ** 2, axis=0) / (count - 1) / count)
    half = np.where(count >= 6, stats.t.ppf(0.975, np.maximum(count - 1, 1)) * error, np.nan)
    return mean, mean - half, mean + half


class Data:
    """One set of runs."""

    def __init__(self, metrics, summary, run, trophic):
        self.metrics, self.summary, self.trophic = metrics, summary, trophic
        self.folders = [pathlib.Path(r["folder"]) for r in summary["runs"]]
        self.run = run
        self.species = list(dict.fromkeys(metrics.loc[metrics.metric == "population", "species"]))

    def published(self, metric, species, group="all"):
        """The paper's mean of a metric as `trophic analyze` has it; None where it has none."""
        rows = [row for row in self.summary["metrics"] if (row["metric"], row["species"], row["group"]) == (metric, species, group)]
        return rows[0].get("published") if rows else None

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

    @property
    def n(self):
        """How many runs there are, and of the shadow, in words."""
        shadow = self.metrics[self.metrics.baseline == "shadow"].seed.nunique()
        return f"n = {len(self.folders)} runs" + (f" and {shadow} of the shadow" if shadow else "")

    def intervals(self, sign, with_shadow=True):
        """What `sign` (bands, bars) means, where there are runs enough."""
        n = self.n if with_shadow else self.n.split(" and ")[0]
        if len(self.folders) < 6:
            return f"{n}: too few for an interval, which needs 6."
        return f"{n}; {sign}: 95 % interval of the mean over runs (Student's t)."

    def curve(self, metric, species, group="all", baseline=""):
        """Window ends, and one row per run."""
        found = self.rows(metric, species, group, baseline, curve=True)
        if found.empty:
            raise Missing(f"no curve of {metric} of {species}")
        table = found.pivot_table(index="seed", columns="time_s", values="value")
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
    middle_s = time_s - window_s(time_s) / 2
    ax.fill_between(middle_s, lower, upper, color=colour_, alpha=0.2, linewidth=0)
    ax.plot(middle_s, mean, linestyle=style, color=colour_, label=label)
    if average:
        ax.axhline(np.nanmean(mean), color=colour_, linestyle=style, linewidth=0.6)


def window_s(time_s):
    """The length of the windows whose ends these are."""
    if len(time_s) == 0:
        return 0
    return np.diff(time_s).min() if len(time_s) > 1 else time_s[0]


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
            if (published := data.published(metric, species)) is not None:
                ax.plot(place + 0.22, published, "D", ms=4.5, mfc="white", mec="black",
                        label="published" if "published" not in ax.get_legend_handles_labels()[1] else None)
            names.append(f"{species}:\n{word}")
            place += 1
    if place == 0:
        raise Missing("no attribution: nobody was caught")
    ax.axhline(2 / 3, color="#CC0000", linestyle="--", linewidth=1, label="paper's baseline 2/3")
    ax.set(xticks=range(place), ylim=(0, 1.12), ylabel="inherited share (attribution)")
    ax.set_xticklabels(names)
    ax.legend(loc="upper left", ncol=2, columnspacing=1, handlelength=1.6)
    return caption(fig, f"Bar: mean over runs; point: a run. {data.intervals('whisker and grey box')} Caught: of the prey that were caught; "
                        "credited: of all prey deaths, by the last killer in that body; catches: of all catches.")


def velocity(data):
    fig, axes = plt.subplots(len(data.species), 1, figsize=(COLUMN_IN, 1.55 * len(data.species) + 0.3), sharex=True, squeeze=False)
    for ax, species in zip(axes[:, 0], data.species[::-1]):
        for group, style, shade in (("inherited", "-", colour(species, data.species)), ("random", "--", NULL_COLOUR)):
            time_s, runs = data.curve("velocity", species, group)
            draw_curve(ax, time_s, runs, group, shade, style, scale=100)
        draw_shadow(ax, data, "velocity", species, "inherited", "inherited, shadow", scale=100)
        ax.axhline(0, color="black", linewidth=0.4)
        if (published := data.published("velocity", species)) is not None:
            ax.plot([1.0], [100 * published], "D", ms=4.5, mfc="white", mec="black", clip_on=False,
                    transform=ax.get_yaxis_transform(), label="published mean")
        ax.set_ylabel(f"{species}: velocity to\nadversary [cm/s]")
        low, high = ax.get_ylim()
        ax.set_ylim(low, high + 0.38 * (high - low))
        ax.legend(ncol=2, loc="upper right", columnspacing=1, handlelength=1.8)
    axes[-1, 0].set_xlabel("time [s]")
    return caption(fig, f"Windows of {window_s(time_s):g} s; thick: mean over runs; thin: its mean over time. {data.intervals('bands')} "
                        "Above 0: towards the closest adversary that was perceived.")


def wall_sticking(data):
    fig, ax = plt.subplots(figsize=(COLUMN_IN, 2.3))
    for species in data.species:
        shade = colour(species, data.species)
        time_s, runs = data.curve("wall_sticking", species)
        style = line(species, data.species)
        draw_curve(ax, time_s, runs, species, shade, style)
        if data.has_shadow:
            mean = data.values("wall_sticking", species, "all", "shadow").mean()
            ax.axhline(mean, color=shade, linestyle="-.", linewidth=0.8, label=f"{species}, shadow's mean")
        if (published := data.published("wall_sticking", species)) is not None:
            ax.plot([1.0], [published], "D", ms=4.5, mfc="white", mec=shade, clip_on=False,
                    transform=ax.get_yaxis_transform(), label=f"{species}, published mean")
    spread = data.values("wall_sticking", data.species[0], "all", "uniform_density")[0]
    ax.axhline(spread, color="black", linestyle=":", linewidth=1, label="evenly spread (no null)")
    ax.set(xlabel="time [s]", ylabel="share within 1 m of a wall", ylim=(0, 1.15))
    ax.legend(ncol=2, loc="upper left", columnspacing=1)
    return caption(fig, f"Windows of {window_s(time_s):g} s; thick: mean over runs; thin: its mean over time. {data.intervals('bands')}")


def tag_symmetry(data):
    fig, ax = plt.subplots(figsize=(COLUMN_IN, 2.6))
    rows = [("ours", "", "#0072B2"), ("null: permuted tags", "permuted_tags", NULL_COLOUR), ("fair coins", "bernoulli_tags", "#999999")]
    if data.has_shadow:
        rows.insert(1, ("null: nothing\ninherited", "shadow", NULL_COLOUR))
    uniform = data.values("tag_symmetry", group="inherited", baseline="uniform_pairs")[0]
    jitter = np.random.default_rng(2)
    for place, (_, baseline, shade) in enumerate(rows):
        numbers = data.values("tag_symmetry", group="inherited", baseline=baseline)
        ax.plot(numbers, place + jitter.uniform(-0.22, -0.08, len(numbers)), "o", ms=3, color=shade, alpha=0.7, mew=0)
        mean, lower, upper = (x[0] for x in interval(numbers[:, None]))
        bars = [[mean - lower], [upper - mean]] if np.isfinite(lower) else None
        ax.errorbar([mean], [place + 0.1], xerr=bars, fmt="s", ms=4, color=shade, capsize=2.5, linewidth=1.4)
    top = len(rows)
    published = data.published("tag_symmetry", "prey+predator", "inherited")
    if published is not None:
        ax.plot([published], [top], "D", ms=4.5, mfc="white", mec="black")
    ax.axvline(uniform, color="#CC0000", linestyle="--", linewidth=1)
    ax.text(uniform - 0.005, top + 0.42, "paper's baseline 2/3", color="#CC0000", ha="right", fontsize=7)
    ax.set(yticks=range(top + 1), ylim=(-0.5, top + 0.65), xlabel="tag symmetry, mean of each run")
    ax.set_yticklabels([name for name, _, _ in rows] + ["published\nmean"])
    return caption(fig, f"Point: a run; square: mean over runs. {data.intervals('bars')} Dealt tags: the tags of the same tick, permuted anew.")


def population(data):
    fig, axes = plt.subplots(3, 1, figsize=(COLUMN_IN, 4.6), sharex=True, gridspec_kw={"height_ratios": [1, 0.8, 1.3]})
    for species in data.species:
        look = (species, colour(species, data.species), line(species, data.species))
        time_s, runs = data.curve("population", species)
        draw_curve(axes[0], time_s, runs, *look, average=False)
        if not data.rows("hunger", species, curve=True).empty:
            draw_curve(axes[1], *data.curve("hunger", species), *look, average=False)
    axes[0].set_ylabel("individuals")
    axes[0].set_ylim(bottom=0)
    axes[0].legend(ncol=2)
    axes[1].set_ylabel("hunger [ticks]")
    axes[1].set_ylim(bottom=0)
    bottom = 0
    for species in data.species:
        for cause, hatch in HATCHES.items():
            if data.rows("deaths", species, cause, curve=True).value.sum() == 0:
                continue
            time_s, runs = data.curve("deaths", species, cause)
            mean = np.nanmean(runs, axis=0)
            axes[2].bar(time_s - window_s(time_s) / 2, mean, window_s(time_s) * 0.9, bottom, color=colour(species, data.species), hatch=hatch,
                        linewidth=0.3, edgecolor="white", label=f"{species}, {cause}")
            bottom = bottom + mean
    axes[2].set(xlabel="time [s]", ylabel=f"deaths per {window_s(time_s):g} s")
    rows = np.ceil(len(axes[2].get_legend_handles_labels()[1]) / 2)
    axes[2].set_ylim(0, (1.15 + 0.13 * rows) * np.max(bottom) if np.ndim(bottom) else 1)
    if np.ndim(bottom):
        axes[2].legend(ncol=2, columnspacing=1, loc="upper left")
    return caption(fig, f"Means over runs in windows of {window_s(time_s):g} s. {data.intervals('bands', False)} Hunger: ticks since birth or the last catch.")


FIGURES = [attribution, velocity, wall_sticking, tag_symmetry, population, phylogeny, catches, trajectories, film_strip]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("analysis", type=pathlib.Path, help="folder that `trophic analyze` wrote")
    parser.add_argument("--out", type=pathlib.Path, help="folder for the figures (ANALYSIS/figures)")
    parser.add_argument("--run", type=int, default=0, help="whose phylogeny, paths and catch are drawn: the K-th run of a set (0)")
    parser.add_argument("--trophic", default="trophic", help="the program whose film draws the strip of a catch (trophic, where it is on PATH)")
    options = parser.parse_args()
    try:
        analysis = read_analysis(options.analysis)
        sets = [Data(analysis.metrics[analysis.metrics["set"] == s["set"]], s, options.run, options.trophic)
                for s in analysis.summary["sets"]]
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
