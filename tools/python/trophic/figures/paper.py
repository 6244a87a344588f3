# SPDX-License-Identifier: MIT
"""The paper's figures, and a forest plot of a comparison, from what `trophic analyze` wrote. Each function takes one set of runs (Data) and
returns a matplotlib figure whose `caption` says what bands and points mean."""
from __future__ import annotations

import functools
import json
import pathlib
import re

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

from ..errors import RunError
from ..metrics import Web, names_of
from ..runs import Analysis, read_analysis
from ..sweeps import arrays
from ..values import SHADOW, one_sided_name
from ..words import null_title, over_nulls
from .pictures import catches, film_strip, phylogeny, trajectories
from .style import COLOURS, NULL_COLOUR, Missing, caption, colour, legend_above, line, width_in, wrapped

HATCHES = {"caught": "", "starved": "////", "sacrificed": "xxxx", "senescence": "...."}


def interval(runs):
    """The mean over runs (rows) of each column, and its 95 % interval as `trophic analyze` has it; NaN if fewer than six have a value."""
    of = arrays.moments(np.atleast_2d(np.asarray(runs, float)))
    return of.mean, *arrays.interval_of(arrays.contrast((1.0, of)))


class Data:
    """One set of runs."""

    def __init__(self, metrics, summary, run):
        self.metrics, self.summary = metrics, summary
        self.folders = [pathlib.Path(r["folder"]) for r in summary["runs"]]
        self.run = run
        self.species = list(dict.fromkeys(metrics.loc[metrics.metric == "population", "species"]))

    def published(self, metric, species, group="all"):
        """The paper's mean of a metric as `trophic analyze` has it, or None."""
        rows = [
            row
            for row in self.summary["metrics"]
            if (row["metric"], row["species"], row["group"]) == (metric, species, group)
        ]
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

    def own_metrics(self):
        """Metrics that `trophic analyze --column` read."""
        known = {name.metric for name in names_of(Web(["prey", "predator"], [("predator", "prey")]))}
        return [name for name in dict.fromkeys(self.metrics.metric) if name not in known]

    @property
    def tick_s(self):
        """Seconds of a tick, from the manifest of a run."""
        path = self.folders[0] / "manifest.json"
        try:
            return json.loads(path.read_text(encoding="utf-8"))["params"]["ecology"]["tick_s"]
        except (OSError, ValueError, KeyError) as error:
            raise Missing(f"{path}: {error}") from error

    @property
    def has_shadow(self):
        return (self.metrics.baseline == "shadow").any()

    def null_of(self, species):
        """The baseline of the null of what a species does: its one-sided world, if the analysis has one, as `trophic.controls` asks for where numbers
        change; else the shadow."""
        one_sided = one_sided_name(species)
        return one_sided if (self.metrics.baseline == one_sided).any() else SHADOW

    @property
    def n(self):
        """The number of runs and of their shadows, in words."""
        shadow = self.metrics[self.metrics.baseline == "shadow"].seed.nunique()
        return f"n = {len(self.folders)} runs" + (f" and {shadow} of the shadow" if shadow else "")

    def subject(self, what):
        """The first sentence of a caption: what a figure shows, of which runs."""
        return f"{what}, by the rules of {self.summary['set']} on {self.summary['backend']}."

    def intervals(self, sign, with_shadow=True):
        """The meaning of `sign` (bands, bars), if there are enough runs."""
        n = self.n if with_shadow else self.n.split(" and ")[0]
        if len(self.folders) < 6:
            return f"{n}: too few for an interval (at least 6 are needed)."
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
    """The mean over the runs of the shadow, or of the one-sided world, and its 95 % interval as a band."""
    null = data.null_of(species)
    if not data.rows(metric, species, group, null).empty:
        mean, lower, upper = (scale * x[0] for x in interval(data.values(metric, species, group, null)[:, None]))
        label = label and label.replace("shadow", null_title(null))
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
    """The length of the windows with these ends."""
    if len(time_s) == 0:
        return 0
    return np.diff(time_s).min() if len(time_s) > 1 else time_s[0]


def attribution(data):
    bars = [("attribution_caught", "caught"), ("attribution_credited", "credited"), ("attribution_catches", "catches")]
    fig, ax = plt.subplots(figsize=(width_in(), 2.6))
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
            if not data.rows(metric, species, baseline=data.null_of(species)).empty:
                null = data.values(metric, species, baseline=data.null_of(species))
                mean, lower, upper = (x[0] for x in interval(null[:, None]))
                ax.fill_between([place - 0.31, place + 0.31], lower, upper, color="black", alpha=0.25, linewidth=0)
                ax.plot(
                    [place - 0.31, place + 0.31],
                    [mean] * 2,
                    color="black",
                    linewidth=1.6,
                    label="null: nothing inherited" if place == 0 else None,
                )
            if (published := data.published(metric, species)) is not None:
                ax.plot(
                    place + 0.22,
                    published,
                    "D",
                    ms=4.5,
                    mfc="white",
                    mec="black",
                    label="published" if "published" not in ax.get_legend_handles_labels()[1] else None,
                )
            names.append(f"{species}:\n{word}")
            place += 1
    if place == 0:
        raise Missing("no attribution: no robot was caught")
    ax.axhline(2 / 3, color="#CC0000", linestyle="--", linewidth=1, label="paper's baseline 2/3")
    ax.set(xticks=range(place), ylim=(0, 1), ylabel="inherited share (attribution)")
    if place > 6:
        ax.set_xticklabels([name.replace("\n", " ") for name in names], rotation=60, ha="right", rotation_mode="anchor")
    else:
        ax.set_xticklabels(names)
    legend_above(ax)
    return caption(
        fig,
        f"{data.subject('Attribution, the share of inherited individuals')} Bar: mean over runs; point: a run. {data.intervals('whisker and grey box')} Caught: of the prey that were caught; "
        "credited: of all prey deaths, by the last killer in that body; catches: of all catches.",
    )


def velocity(data):
    fig, axes = plt.subplots(
        len(data.species), 1, figsize=(width_in(), 1.55 * len(data.species) + 0.3), sharex=True, squeeze=False
    )
    for ax, species in zip(axes[:, 0], data.species[::-1]):
        for group, style, shade in (("inherited", "-", colour(species, data.species)), ("random", "--", NULL_COLOUR)):
            time_s, runs = data.curve("velocity", species, group)
            draw_curve(ax, time_s, runs, group, shade, style, scale=100)
        draw_shadow(ax, data, "velocity", species, "inherited", "inherited, shadow", scale=100)
        ax.axhline(0, color="black", linewidth=0.4)
        if (published := data.published("velocity", species)) is not None:
            ax.plot(
                [1.0],
                [100 * published],
                "D",
                ms=4.5,
                mfc="white",
                mec="black",
                clip_on=False,
                transform=ax.get_yaxis_transform(),
                label="published mean",
            )
        ax.set_ylabel(f"{species}: velocity [cm/s]\n(+ towards adversary)")
        legend_above(ax)
    axes[-1, 0].set_xlabel("time [s]")
    return caption(
        fig,
        f"{data.subject('Velocity relative to the closest perceived adversary')} Above 0: towards it. Windows of {window_s(time_s):g} s; "
        f"thick: mean over runs; thin: its mean over time. {data.intervals('bands')}",
    )


def wall_sticking(data):
    fig, ax = plt.subplots(figsize=(width_in(), 2.3))
    for species in data.species:
        shade = colour(species, data.species)
        time_s, runs = data.curve("wall_sticking", species)
        style = line(species, data.species)
        draw_curve(ax, time_s, runs, species, shade, style)
        null = data.null_of(species)
        if not data.rows("wall_sticking", species, "all", null).empty:
            mean = data.values("wall_sticking", species, "all", null).mean()
            ax.axhline(mean, color=shade, linestyle="-.", linewidth=0.8, label=f"{species}, {null_title(null)}'s mean")
        if (published := data.published("wall_sticking", species)) is not None:
            ax.plot(
                [1.0],
                [published],
                "D",
                ms=4.5,
                mfc="white",
                mec=shade,
                clip_on=False,
                transform=ax.get_yaxis_transform(),
                label=f"{species}, published mean",
            )
    spread = data.values("wall_sticking", data.species[0], "all", "uniform_density")[0]
    ax.axhline(spread, color="black", linestyle=":", linewidth=1, label="uniform density (not a null)")
    ax.set(xlabel="time [s]", ylabel="share within 1 m of a wall", ylim=(0, 1))
    legend_above(ax)
    return caption(
        fig,
        f"{data.subject('Share of robots within 1 m of a wall')} Windows of {window_s(time_s):g} s; thick: mean over runs; thin: its mean over "
        f"time. {data.intervals('bands')}",
    )


def tag_symmetry(data):
    fig, ax = plt.subplots(figsize=(width_in(), 2.6))
    rows = [
        ("ours", "", "#0072B2"),
        ("null: permuted\ntags", "permuted_tags", NULL_COLOUR),
        ("Bernoulli(1/2)", "bernoulli_tags", "#999999"),
    ]
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
    return caption(
        fig,
        f"{data.subject('Tag symmetry: the absolute sum of the mean tags of both species')} Point: a run; square: mean over runs. "
        f"{data.intervals('bars')} Permuted tags: the tags of the same tick, drawn again among the same robots; Bernoulli(1/2): tags drawn with "
        "equal chances.",
    )


def population(data):
    fig, axes = plt.subplots(3, 1, figsize=(width_in(), 4.6), sharex=True, gridspec_kw={"height_ratios": [1, 0.8, 1.3]})
    for species in data.species:
        look = (species, colour(species, data.species), line(species, data.species))
        time_s, runs = data.curve("population", species)
        draw_curve(axes[0], time_s, runs, *look, average=False)
        if not data.rows("hunger", species, curve=True).empty:
            draw_curve(axes[1], *data.curve("hunger", species), *look, average=False, scale=data.tick_s)
    axes[0].set_ylabel("individuals")
    axes[0].set_ylim(bottom=0)
    legend_above(axes[0])
    axes[1].set_ylabel("hunger [s]")
    axes[1].set_ylim(bottom=0)
    bottom = 0
    for species in data.species:
        for cause, hatch in HATCHES.items():
            if data.rows("deaths", species, cause, curve=True).value.sum() == 0:
                continue
            time_s, runs = data.curve("deaths", species, cause)
            mean = np.nanmean(runs, axis=0)
            axes[2].bar(
                time_s - window_s(time_s) / 2,
                mean,
                window_s(time_s) * 0.9,
                bottom,
                color=colour(species, data.species),
                hatch=hatch,
                linewidth=0.3,
                edgecolor="white",
                label=f"{species}, {cause}",
            )
            bottom = bottom + mean
    axes[2].set(xlabel="time [s]", ylabel=f"deaths per {window_s(time_s):g} s")
    legend_above(axes[2])
    return caption(
        fig,
        f"{data.subject('Individuals, hunger and deaths')} Means over runs in windows of {window_s(time_s):g} s. {data.intervals('bands', False)} Hunger: time since birth or the last catch.",
    )


def with_and_without(data):
    """Numbers, and velocities of the inherited, of a set and of the null of each species; where numbers change, of the active among them."""
    fig, axes = plt.subplots(2, 1, figsize=(width_in(), 3.2), sharex=True)
    whose = "inherited" if data.rows("velocity", group="inherited_active").empty else "inherited_active"
    for ax, metric, group, scale in ((axes[0], "population", "all", 1), (axes[1], "velocity", whose, 100)):
        for species in data.species:
            null = data.null_of(species)
            for baseline, style, words in (("", "-", "inheritance"), (null, (0, (1, 1)), "nothing inherited")):
                time_s, runs = data.curve(metric, species, group, baseline)
                draw_curve(
                    ax,
                    time_s,
                    runs,
                    f"{species}, {words}",
                    colour(species, data.species),
                    style,
                    average=False,
                    scale=scale,
                )
    axes[0].set(ylabel="individuals", ylim=(0, None))
    axes[1].set(ylabel="velocity [cm/s]\n(+ towards adversary)", xlabel="time [s]")
    axes[1].axhline(0, color="black", linewidth=0.4)
    legend_above(axes[0])
    return caption(
        fig,
        f"{data.subject(f'Numbers, and velocity of the {whose.replace(chr(95), chr(32))} towards the closest perceived adversary')} Windows of {window_s(time_s):g} s. {data.intervals('bands')}",
    )


def own_metric(data, metric):
    """A metric of one's own: its curves if it has any, else a point for each run, with the shadow's."""
    rows = data.metrics[data.metrics.metric == metric]
    parts = list(rows[["species", "group", "unit"]].drop_duplicates().itertuples(index=False))
    has_curve = rows.time_s.notna().any()
    fig, ax = plt.subplots(figsize=(width_in(), 2.3))
    for place, part in enumerate(parts):
        label = " ".join(filter(None, [part.species, "" if part.group == "all" else part.group])) or "runs"
        shade = colour(part.species, data.species) if part.species in data.species else "#0072B2"
        if has_curve:
            time_s, runs = data.curve(metric, part.species, part.group)
            draw_curve(ax, time_s, runs, label, shade, style=["-", "--", ":", "-."][place % 4], average=False)
            draw_shadow(ax, data, metric, part.species, part.group, f"{label}, shadow")
            continue
        null = data.null_of(part.species)
        for shift, baseline, look in ((-0.1, "", shade), (0.1, null, NULL_COLOUR)):
            if data.rows(metric, part.species, part.group, baseline).empty:
                continue
            values = data.values(metric, part.species, part.group, baseline)
            mean, lower, upper = (x[0] for x in interval(values[:, None]))
            ax.plot([place + shift] * len(values), values, "o", ms=2.5, mew=0, color=look, alpha=0.6)
            bars = [[mean - lower], [upper - mean]] if np.isfinite(lower) else None
            ax.errorbar(
                [place + 1.8 * shift],
                [mean],
                yerr=bars,
                fmt="s",
                ms=4,
                color=look,
                capsize=2.5,
                label=(null_title(null) if baseline else "ours") if place == 0 else None,
            )
    if not has_curve:
        ax.set_xticks(range(len(parts)), [" ".join(filter(None, [p.species, p.group])) for p in parts])
    unit = "" if parts[0].unit == "1" else f" [{parts[0].unit}]"
    direction = "\n(+ towards adversary)" if metric.startswith("velocity") else ""
    ax.set(ylabel=metric.replace("_", " ") + unit + direction, xlabel="time [s]" if has_curve else "")
    legend_above(ax)
    return caption(fig, f"{data.subject(metric)} {data.intervals('bands' if has_curve else 'bars')}")


MOST_LINES_OF_A_FOREST = 30


def forest(summary):
    """The differences of two sets that were compared, each in standard deviations between runs, with intervals; filled: significant. Intervals of what
    is corrected hold for all at once with 95 %."""
    kinds = ("over_neutral", "over_one_sided", "over_shadow", "raw")
    answers = [
        next(kind for kind in kinds if kind == "raw" or d.get(kind, {}).get("value") is not None)
        for d in summary["differences"]
    ]
    _, over, _ = over_nulls(answers)
    rows = []
    for d, kind in zip(summary["differences"], answers):
        spread = [d[side]["deviation"] for side in "ab"]
        of = d[kind]
        if d["same_as"] or of["lower"] is None or of["differs"] is None or None in spread or not any(spread):
            continue
        unit = (sum(s * s for s in spread) / 2) ** 0.5
        at_once = "_corrected" if of.get("lower_corrected") is not None else ""
        rows.append((d, of, [of[key] / unit for key in ("value", f"lower{at_once}", f"upper{at_once}")]))
    if not rows:
        raise Missing("no difference with an interval: six runs of each set are needed")
    left_out = len(rows) - MOST_LINES_OF_A_FOREST
    rows = sorted(rows, key=lambda row: row[1]["p"])[:MOST_LINES_OF_A_FOREST] if left_out > 0 else rows
    rows = sorted(rows, key=lambda row: row[2][0])
    fig, ax = plt.subplots(figsize=(width_in(), 0.7 + 0.17 * len(rows)))
    for place, (d, of, (value, lower, upper)) in enumerate(rows):
        ax.plot([lower, upper], [place, place], color="black", linewidth=1)
        ax.plot([value], [place], "o", ms=4, color="black", mfc="black" if of["differs"] else "white")
    names = [
        f"{d['metric'].replace('_', ' ')} {d['species']}" + ("" if d["group"] == "all" else f" ({d['group']})")
        for d, _, _ in rows
    ]
    ax.axvline(0, color="#555555", linewidth=0.6)
    ax.set_yticks(range(len(rows)), names, fontsize=6)
    ax.set_ylim(-0.7, len(rows) - 0.3)
    first, second = (s["set"] for s in summary["sets"])
    ax.set_xlabel(
        wrapped(f"{second} \u2212 {first}" + (f", {over}" if over else "")) + "\n[standard deviations between runs]",
        loc="right",
    )
    rest = f" The {left_out} least significant are left out." if left_out > 0 else ""
    return caption(
        fig,
        f"Differences {second} - {first}"
        + (f", {over}" if over else " (raw)")
        + f", n = {len(summary['sets'][0]['runs'])} and "
        f"{len(summary['sets'][1]['runs'])} runs, in pooled standard deviations between runs; bars: intervals that hold for all at once with 95 % (Bonferroni). "
        f"Filled: p <= 0.05 after Holm's correction for all metrics.{rest}",
    )


FIGURES = [
    attribution,
    velocity,
    wall_sticking,
    tag_symmetry,
    population,
    with_and_without,
    phylogeny,
    catches,
    trajectories,
    film_strip,
]


def analysis_of(analysis):
    """The Analysis itself, or the one in a folder."""
    return analysis if isinstance(analysis, Analysis) else read_analysis(analysis)


def sets_of(analysis, run=0):
    """The sets of an Analysis, or of its folder, each as Data. Raises RunError for a folder that is not one, and IndexError for a `run` that is not
    there."""
    analysis = analysis_of(analysis)
    sets = [Data(analysis.metrics[analysis.metrics["set"] == s["set"]], s, run) for s in analysis.summary["sets"]]
    if any(not 0 <= run < len(data.folders) for data in sets):
        raise IndexError(f"--run {run}: must be >= 0 and < the number of runs")
    return sets


def data_of(analysis, set=None, run=0):
    """One set of an Analysis, or of its folder: the one with the label `set`, which need not be named if it is the only one. Raises RunError."""
    if isinstance(analysis, Data):
        return analysis
    sets = {data.summary["set"]: data for data in sets_of(analysis, run)}
    if set is None and len(sets) == 1:
        return next(iter(sets.values()))
    if set not in sets:
        raise RunError(f"set={set}: must be {' or '.join(sets)}")
    return sets[set]


def figures_of(folder, run=0):
    """(name, function) for each figure of an analysis; of a comparison each set has its own, and there is a forest plot."""
    sets = sets_of(folder, run)
    figures = []
    for data in sets:
        prefix = "" if len(sets) == 1 else re.sub(r"\W+", "_", data.summary["set"]).strip("_") + "-"
        figures += [
            (prefix + draw.__name__, functools.partial(draw, data))
            for draw in FIGURES
            if draw is not with_and_without or data.has_shadow
        ]
        own = data.own_metrics()
        figures += [
            (f"{prefix}own-{re.sub(r'[^A-Za-z0-9]+', '_', metric)}", functools.partial(own_metric, data, metric))
            for metric in own
        ]
    summary = json.loads((pathlib.Path(folder) / "summary.json").read_text(encoding="utf-8"))
    if "differences" in summary:
        figures.insert(0, ("forest", functools.partial(forest, summary)))
    return figures
