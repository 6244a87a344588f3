# SPDX-License-Identifier: MIT
"""Figures of what `trophic analyze --bodies` wrote: measures over time, bodies in the space of their descriptors, and the tree of plans of a run.
A set of a comparison with parents at random or with the neutral null is the null."""
from __future__ import annotations

import pathlib
import re
import tempfile

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

from ..runs import read_analysis
from ..words import NULLS
from .paper import Data, draw_curve, window_s
from .pictures import film
from .style import Missing, NULL_COLOUR, caption, colour, legend_above, width_in

MEASURES = {
    "walked": "walked [cm/s]",
    "wall_contact": "touch a wall",
    "body_modules": "modules",
    "body_mass": "mass [kg]",
    "body_proportion": "proportion",
    "body_coverage": "coverage",
    "body_branching": "branching",
    "body_limbs": "limbs",
    "body_length_of_limbs": "limb length",
    "body_symmetry": "symmetry",
    "body_joints": "joints",
    "body_plans_shannon": "plans",
    "body_change": "change",
    "brain_genes": "brain genes",
    "gait_genes": "gait genes",
}
DESCRIPTORS = ["size", "proportion", "coverage", "branching", "limbs", "length_of_limbs", "symmetry", "joints"]


def has_bodies(metrics):
    """Whether these metrics are those of `--bodies`."""
    return (metrics.metric == "body_size").any()


def null_of(data):
    """The null that a set is; empty for a set with inheritance and its parent rule."""
    return (
        "survival alone"
        if "by_survival" in data.summary["set"]
        else "neutral null"
        if " = neutral_" in data.summary["set"]
        else ""
    )


def species_of(data):
    return list(dict.fromkeys(data.metrics.species))


def measures(sets):
    """Every measure that changes, over time: lines with bands; the null dashed and grey, the shadow dotted."""
    shown = [name for name in MEASURES if any(data.rows(name, curve=True).value.nunique() > 1 for data in sets)]
    if not shown:
        raise Missing("no measure with a curve")
    species = species_of(sets[0])
    fig, axes = plt.subplots(
        len(shown),
        len(species),
        figsize=(width_in() * 1.6, 0.85 * len(shown) + 0.6),
        sharex=True,
        sharey="row",
        squeeze=False,
    )
    for row, name in zip(axes, shown):
        scale = 100 if name == "walked" else 1
        for ax, one in zip(row, species):
            for data in sets:
                if data.rows(name, one, curve=True).empty:
                    continue
                time_s, runs = data.curve(name, one)
                draw_curve(
                    ax,
                    time_s,
                    runs,
                    null_of(data) or "inheritance",
                    NULL_COLOUR if null_of(data) else colour(one, species),
                    (0, (4, 1.5)) if null_of(data) else "-",
                    average=False,
                    scale=scale,
                )
                for baseline, look in (("shadow", ":"), ("neutral", "-.")):
                    if not data.rows(name, one, baseline=baseline, curve=True).empty:
                        null_s, nulls = data.curve(name, one, baseline=baseline)
                        ax.plot(
                            null_s - window_s(null_s) / 2,
                            scale * np.nanmean(nulls, axis=0),
                            look,
                            color="black",
                            linewidth=1,
                            label=None if NULLS[baseline] in ax.get_legend_handles_labels()[1] else NULLS[baseline],
                        )
        row[0].set_ylabel(MEASURES[name], fontsize=7)
    for ax, one in zip(axes[0], species):
        ax.set_title(one, pad=4 + 11 * legend_above(ax, columns=3))
    for ax in axes[-1]:
        ax.set_xlabel("time [s]")
    ours = [data for data in sets if not null_of(data)] or sets
    null = next(filter(None, map(null_of, sets)), "")
    return caption(
        fig,
        f"{ours[0].subject('Measures of docs/bodies.md, means over those alive at the ends of windows (plans: their Shannon number)')} Windows of {window_s(time_s):g} s; lines: mean over "
        f"runs; {f'grey, dashed: {null}; ' * bool(null)}dotted: mean of the shadow, in which nothing is inherited; dash-dotted: of the neutral null. {sets[-1].intervals('bands', False)}",
    )


def living_bodies(data):
    """The bodies of founders, and of those alive at the end, of all runs: rows of bodies.csv."""
    founders, living = [], []
    for folder in data.folders:
        bodies = data.table(folder, "bodies.csv", ["id", "time_s", "species", *DESCRIPTORS])
        lives = data.table(folder, "phylogeny.csv", ["id", "destruction_time"])
        founders.append(bodies[bodies.time_s == 0])
        living.append(bodies[bodies.id.isin(lives[np.isinf(lives.destruction_time)].id)])
    return pd.concat(founders), pd.concat(living)


def morphospace(sets):
    """The two first principal components of the descriptors: founders, the living, and the living of the null."""
    found = [(data, *living_bodies(data)) for data in sets]
    everything = pd.concat([part for _, founders, living in found for part in (founders, living)])[
        DESCRIPTORS
    ].to_numpy()
    mean = everything.mean(axis=0)
    _, sizes, components = np.linalg.svd(everything - mean, full_matrices=False)
    if len(sizes) < 2 or sizes[0] == 0:
        raise Missing("all bodies are alike")
    shares = sizes**2 / (sizes**2).sum()
    species = species_of(sets[0])
    fig, axes = plt.subplots(1, len(species), figsize=(width_in() * 1.6, 2.9), sharex=True, sharey=True, squeeze=False)
    for ax, one in zip(axes[0], species):
        for data, founders, living in found:
            for rows, mark, label in ((living, "o", null_of(data) or "inheritance"), (founders, "*", "founders")):
                at = (rows[rows.species == one][DESCRIPTORS].to_numpy() - mean) @ components[:2].T
                places, counts = (
                    np.unique(at.round(6), axis=0, return_counts=True) if len(at) else (np.empty((0, 2)), [])
                )
                if mark == "*" and null_of(data) and len(sets) > 1:
                    continue
                ax.scatter(
                    *places.T,
                    s=70 if mark == "*" else 6 + 6 * np.sqrt(counts),
                    marker=mark,
                    label=label,
                    linewidths=0.6,
                    zorder=3 if mark == "*" else 2,
                    facecolors="white" if mark == "*" else NULL_COLOUR if null_of(data) else colour(one, species),
                    alpha=1 if mark == "*" else 0.6,
                    edgecolors="black" if mark == "*" else "none",
                )
        ax.set(title=one, xlabel=f"component 1 ({shares[0]:.0%})")
        ax.legend(loc="best", fontsize=6)
    axes[0][0].set_ylabel(f"component 2 ({shares[1]:.0%})")
    named = [
        ", ".join(
            f"{weight:+.2f} {name.replace('_', ' ')}"
            for weight, name in sorted(zip(component, DESCRIPTORS), key=lambda pair: -abs(pair[0]))[:3]
        )
        for component in components[:2]
    ]
    runs = ", ".join(f"{len(data.folders)} of {null_of(data) or 'inheritance'}" for data in sets)
    return caption(
        fig,
        f"Principal components of the eight descriptors of bodies at the ends of runs ({runs}); larger: more individuals; stars: founders. "
        f"Component 1: {named[0]}; component 2: {named[1]}.",
    )


def robot_file(plan):
    """A robot file of a plan as text."""
    lines, path, last = ["name = 'plan'"], ["core"], "core"
    for token in re.findall(r"(front|back|left|right):(hinge|brick)(\d)|(\[)|(\])", plan.removeprefix("core")):
        face, module, turns, opens, closes = token
        if opens:
            path.append(last)
        elif closes:
            path.pop()
        else:
            last = face
            lines += [
                f"[{'.'.join([*path, face])}]".replace("core.core", "core"),
                f"module = '{module}'",
                f"rotation_deg = {90 * int(turns)}",
            ]
    return "\n".join(lines) + "\n"


def picture_of(plan):
    """The picture of a plan by `trophic film`."""
    with tempfile.TemporaryDirectory() as name:
        robot = pathlib.Path(name) / "plan.toml"
        robot.write_text(robot_file(plan), encoding="utf-8")
        return film("--robot", robot, "--size", "240x180", "--legend", "off")[0][24:174, 30:210]


def plans(data, most=5):
    """The tree of plans of one run: plans of the living and their ancestors, with pictures of founders and of the commonest of the living."""
    folder = data.folders[data.run]
    bodies = data.table(folder, "bodies.csv", ["id", "time_s", "species", "plan", "parent_plan", "modules_text"])
    lives = data.table(folder, "phylogeny.csv", ["id", "destruction_time"])
    end_s = bodies.time_s.max()
    bodies["until_s"] = bodies.id.map(lives.set_index("id").destruction_time).fillna(end_s).clip(upper=end_s)
    alive = bodies.id.isin(lives[np.isinf(lives.destruction_time)].id)
    first = bodies.drop_duplicates("plan").set_index("plan")
    parent = first.parent_plan.where(first.parent_plan != first.index)
    last_s = bodies.groupby("plan").until_s.max()
    counts = bodies[alive].groupby("plan").size().sort_values(ascending=False, kind="stable")
    kept, order = set(), []
    for plan in counts.index:
        while plan not in kept:
            kept.add(plan)
            if pd.isna(parent[plan]):
                break
            plan = int(parent[plan])

    def visit(plan):
        children = [child for child in sorted(kept) if parent[child] == plan]
        half = len(children) // 2
        for child in children[:half]:
            visit(child)
        order.append(plan)
        for child in children[half:]:
            visit(child)

    for root in sorted(plan for plan in kept if pd.isna(parent[plan])):
        visit(root)
    height = {plan: place for place, plan in enumerate(order)}
    pictured = list(dict.fromkeys([*(plan for plan in order if pd.isna(parent[plan])), *counts.index[:most]]))
    rows = (len(pictured) + 1) // 2
    fig, (ax, side) = plt.subplots(
        1, 2, figsize=(width_in() * 1.8, max(0.8 * rows, 0.14 * len(order)) + 0.6), width_ratios=[2, 1]
    )
    species = list(dict.fromkeys(bodies.species))
    for plan in order:
        shade = colour(first.species[plan], species)
        ax.plot(
            [first.time_s[plan], last_s[plan]],
            [height[plan]] * 2,
            color=shade,
            linewidth=1 + min(4, 0.4 * counts.get(plan, 0)),
        )
        if not pd.isna(parent[plan]):
            ax.plot([first.time_s[plan]] * 2, [height[int(parent[plan])], height[plan]], color="black", linewidth=0.5)
    for number, plan in enumerate(pictured):
        mark = chr(ord("A") + number)
        ax.annotate(
            mark,
            (first.time_s[plan], height[plan]),
            xytext=(-7, -2),
            textcoords="offset points",
            fontsize=7,
            fontweight="bold",
        )
        frame = side.inset_axes([0.5 * (number % 2), 1 - (number // 2 + 1) / rows, 0.48, 0.84 / rows])
        frame.imshow(picture_of(first.modules_text[plan]))
        frame.set_title(f"{mark}: {counts.get(plan, 0)} alive", fontsize=6, pad=1)
        frame.set_axis_off()
    side.set_axis_off()
    ax.set(xlabel="time [s]", ylabel="plans", yticks=[], xlim=(-0.04 * end_s, 1.01 * end_s), ylim=(-1, len(order)))
    for one in species:
        ax.plot([], [], color=colour(one, species), label=f"first born as {one}")
    ax.legend(loc="upper left", fontsize=6)
    return caption(
        fig,
        f"{folder.name}: plans of bodies of those alive at {end_s:g} s, and of their ancestors ({len(order)} of {bodies.plan.nunique()} plans). A line: from "
        "the first birth to the last death; thicker: more alive at the end; joined to the plan that it changed from. Pictures: founders, and the "
        "commonest plans of the living.",
    )


def figures_of(folder, run=0):
    """(name, function) for each figure of an analysis by `--bodies`."""
    analysis = read_analysis(folder)
    sets = [Data(analysis.metrics[analysis.metrics["set"] == s["set"]], s, run) for s in analysis.summary["sets"]]
    sets.sort(key=lambda data: bool(null_of(data)), reverse=True)
    if any(not 0 <= run < len(data.folders) for data in sets):
        raise IndexError(f"--run {run}: must be >= 0 and < the number of runs")
    figures = [("measures", lambda: measures(sets))]
    if all((data.folders[run] / "bodies.csv").exists() for data in sets):
        figures += [("morphospace", lambda: morphospace(sets)), ("plans", lambda: plans(sets[-1]))]
    return figures
