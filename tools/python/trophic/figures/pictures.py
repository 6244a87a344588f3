# SPDX-License-Identifier: MIT
"""Pictures of what happened in runs: descent, places of catches, paths of robots, and a catch frame by frame."""
from __future__ import annotations

import pathlib
import subprocess
import tempfile

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.collections import LineCollection
from matplotlib.colors import PowerNorm

from ..errors import ProgramError
from ..programs import find_program
from ..runs import first_parents
from .style import Missing, caption, colour, legend_above, line, width_in

MOST_ROWS = 150


def families(tree):
    """The individuals of each root's family, in drawing order; families by their root's birth."""
    children = {}
    for child, parent in tree.parent.items():
        if parent in tree.index:
            children.setdefault(parent, []).append(child)
    found = []
    for root in tree.index:
        if tree.parent[root] in tree.index:
            continue
        family, waiting = [], [root]
        while waiting:
            individual = waiting.pop()
            family.append(individual)
            waiting.extend(children.get(individual, [])[::-1])
        found.append(family)
    return found, children


def chosen_families(found):
    """The largest families that fit, at least one; those of a single individual only if there are no others."""
    largest = sorted((family for family in found if len(family) > 1), key=len, reverse=True) or found[:MOST_ROWS]
    chosen, rows = [], 0
    for family in largest:
        if chosen and rows + len(family) > MOST_ROWS:
            break
        chosen.append(family)
        rows += len(family)
    return sorted(chosen, key=found.index)


def phylogeny(data):
    folder = data.folders[data.run]
    tree = data.table(folder, "phylogeny.csv", ["id", "ancestor_list", "origin_time", "destruction_time", "species"])
    if tree.empty:
        raise Missing(f"{folder / 'phylogeny.csv'}: no robot in it")
    has_couples = tree.ancestor_list.str.contains(",").any()
    tree = tree.assign(parent=first_parents(tree)).sort_values("origin_time", kind="stable").set_index("id")
    end_s = max(tree.destruction_time.replace(np.inf, 0).max(), tree.origin_time.max())
    found, children = families(tree)
    chosen = chosen_families(found)
    rows, bands, row = {}, [], 0
    for family in chosen:
        for individual in family:
            rows[individual] = row
            row += 1
        bands.append((row - len(family) - 0.5, row - 0.5))
        row += 1.2
    fig, ax = plt.subplots(figsize=(width_in(), float(np.clip(0.032 * row + 1.4, 2.6, 7.0))))
    for low, high in bands[::2]:
        ax.axhspan(low - 0.3, high + 0.3, color="black", alpha=0.05, linewidth=0)
    shown = tree.loc[list(rows)]
    links = [(tree.origin_time[c], rows[p], rows[c]) for p in rows for c in children.get(p, [])]
    if links:
        x, low, high = zip(*links)
        ax.vlines(x, low, high, color="black", linewidth=0.6)
    waits = [
        (rows[p], tree.destruction_time[p], max(tree.origin_time[c] for c in children[p]))
        for p in rows
        if p in children
    ]
    waits = [wait for wait in waits if wait[2] > wait[1]]
    if waits:
        y, death_s, birth_s = zip(*waits)
        ax.hlines(y, death_s, birth_s, color="black", linewidth=0.5, linestyle=(0, (1, 2)))
    for species in data.species:
        of = shown[shown.species == species]
        shade = colour(species, data.species)
        y = [rows[i] for i in of.index]
        ax.hlines(
            y,
            of.origin_time,
            of.destruction_time.replace(np.inf, end_s),
            color=shade,
            linewidth=1.5,
            label=species,
            linestyle=line(species, data.species) if len(data.species) > 2 else "-",
        )
        living = of[np.isinf(of.destruction_time)]
        ax.plot([end_s] * len(living), [rows[i] for i in living.index], ">", ms=3, mew=0, color=shade)
    ax.set(
        xlabel="time [s]",
        ylabel="a line a life, a stripe a family",
        ylim=(-1.5, row),
        yticks=[],
        xlim=(-0.01 * end_s, 1.02 * end_s),
    )
    legend_above(ax, len(data.species))
    left_out = len(tree) - len(rows)
    alone = sum(len(family) == 1 for family in found)
    rest = (
        ""
        if left_out == 0
        else (f" Not shown: {left_out} in smaller families, {alone} of them without parent and offspring.")
    )
    return caption(
        fig,
        f"{folder.name}: the {len(chosen)} largest of {len(found)} families, {len(rows)} of {len(tree)} individuals. Black: from "
        f"{'the first ' if has_couples else ''}parent to offspring, at the birth (dotted: the parent is dead); arrow: alive at the end.{rest}",
    )


def catches(data):
    places = []
    for folder in data.folders:
        events = data.table(folder, "events.csv", ["event", "x_m", "y_m"])
        places.append(events[events.event == "catch"])
    places = pd.concat(places)
    if places.empty:
        raise Missing("no robot was caught")
    half_m = data.summary["runs"][0]["half_side_m"]
    edge_m = max(half_m, places[["x_m", "y_m"]].abs().max().max())
    fig, ax = plt.subplots(figsize=(width_in(), 3.2))
    # A cell should have ten catches on average, or its shade is chance.
    cells = min(20, int(np.sqrt(len(places) / 10)))
    text = f"{data.subject('Places of catches')} {len(places)} catches in n = {len(data.folders)} runs."
    if cells >= 4:
        counts, x_m, y_m = np.histogram2d(places.x_m, places.y_m, bins=cells, range=[[-edge_m, edge_m]] * 2)
        density = counts / len(data.folders) / (2 * edge_m / cells) ** 2
        image = ax.pcolormesh(x_m, y_m, density.T, cmap="cividis", norm=PowerNorm(0.5, vmin=0), rasterized=True)
        fig.colorbar(image, label="catches per m² and run", shrink=0.9)
        text += f" {len(places) / cells**2:.0f} per cell on average ({2 * edge_m / cells:.1f} m wide); square-root colour scale."
    else:
        ax.plot(places.x_m, places.y_m, "o", ms=3, mew=0, color=colour("predator", data.species), alpha=0.6)
        text += " Each point is one catch: too few for a density."
    ax.plot(half_m * np.array([-1, 1, 1, -1, -1]), half_m * np.array([-1, -1, 1, 1, -1]), color="black", linewidth=1)
    ax.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
    return caption(fig, text + " Frame: the walls.")


def trajectories(data):
    folder = data.folders[data.run]
    rows = data.table(folder, "agents.csv", ["time_s", "body", "species", "x_m", "y_m"])
    if rows.empty:
        raise Missing(f"{folder / 'agents.csv'}: no robot in it")
    half_m = data.summary["runs"][0]["half_side_m"]
    count = len(data.species)
    fig, axes = plt.subplots(
        1, count, figsize=(max(width_in(), 1.75 * count), 2.5), sharex=True, sharey=True, squeeze=False
    )
    paths = {species: [] for species in data.species}
    for _, body in rows.groupby("body", sort=False):
        # A body's path is cut where it passes from one species to another.
        of = (body.species != body.species.shift()).cumsum()
        for _, part in body.groupby(of):
            paths[part.species.iloc[0]].append(part[["x_m", "y_m"]].to_numpy())
    points = len(rows) / max(1, count)
    for ax, species in zip(axes[0], data.species):
        ax.add_collection(
            LineCollection(
                paths[species],
                colors=colour(species, data.species),
                linewidths=0.35,
                alpha=float(np.clip(12000 / max(1.0, points), 0.2, 0.8)),
                rasterized=True,
            )
        )
        ax.plot(
            half_m * np.array([-1, 1, 1, -1, -1]), half_m * np.array([-1, -1, 1, 1, -1]), color="black", linewidth=1
        )
        ax.set(
            aspect="equal",
            title=species,
            xlabel="x [m]",
            xlim=(-1.04 * half_m, 1.04 * half_m),
            ylim=(-1.04 * half_m, 1.04 * half_m),
        )
    axes[0][0].set_ylabel("y [m]")
    step_s = np.diff(np.unique(rows.time_s))
    return caption(
        fig,
        f"{folder.name}: the paths of all {rows.body.nunique()} robots in {rows.time_s.max():g} s, a place every "
        f"{np.min(step_s) if len(step_s) else 0:g} s. A body that passes to the other species continues in the other panel. Frame: the "
        "walls.",
    )


def film(*words):
    """The pixels of a picture by `trophic film`, and the line that it prints."""
    with tempfile.TemporaryDirectory() as name:
        picture = pathlib.Path(name) / "picture.png"
        try:
            done = subprocess.run(
                [find_program("trophic"), "film", *map(str, words), "-o", str(picture)],
                capture_output=True,
                encoding="utf-8",
                errors="surrogateescape",
                timeout=120,
            )
        except ProgramError as error:
            raise Missing(str(error)) from None
        if done.returncode != 0:
            raise Missing(done.stderr.strip() or "trophic film failed")
        return plt.imread(picture), done.stdout.strip()


def film_strip(data):
    """A catch in four pictures, by `trophic film`: the one at which a page of the run opens."""
    folder = data.folders[data.run]
    if not (folder / "replay.trp").exists():
        raise Missing(f"{folder / 'replay.trp'}: no recording")
    pixels, said = film(folder, "--catch", "best", "--sheet", "2x2", "--size", "520x360", "--lines", "off")
    fig, ax = plt.subplots(figsize=(width_in(), width_in() * pixels.shape[0] / pixels.shape[1]))
    fig.get_layout_engine().set(w_pad=0, h_pad=0)
    ax.imshow(pixels)
    ax.set_axis_off()
    what = said.partition("; ")[2]  # "at 390 s predator 29 catches prey 12: random, lived 390 s"
    return caption(
        fig,
        f"{folder.name}: {what}. The camera stands still; only the two robots of the catch are named. Ring on the floor: filled "
        "or hollow by its robot's tag, with a pointer ahead; red ring: the catch, at which a newborn (grey: inactive) takes over the victim's body.",
    )
