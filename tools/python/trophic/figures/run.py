# SPDX-License-Identifier: MIT
"""The curves of one run: numbers and, in a table with a rule Metabolism, energy."""
from __future__ import annotations

import functools
import pathlib

import matplotlib.pyplot as plt
import numpy as np

from ..description import describe
from ..runs import Runs, read_run
from .style import caption, colour, legend_above, line, width_in


def _steps(run, species):
    """The times at which the number of a species changes, s, and the numbers from then on."""
    events = run.events
    own = events[(events.species == species) & events.event.isin(["birth", "death"])]
    change = np.where(own.event == "birth", 1, -1)
    time_s, first = np.unique(own.time_s.to_numpy(float), return_index=True)
    numbers = np.add.reduceat(change, first).cumsum() if len(first) else np.empty(0)
    end_s = float(events.time_s.max()) if len(events) else 0.0
    return np.append(time_s, end_s), np.append(numbers, numbers[-1:] if len(numbers) else [0])


def _figure(run, draw, ylabel, what):
    figure, axes = plt.subplots(figsize=(width_in(), 0.62 * width_in()), layout="constrained")
    species = run.manifest["species"]
    for one in species:
        time_s, values = draw(one)
        axes.step(
            time_s,
            values,
            where="post",
            color=colour(one, species),
            linestyle=line(one, species),
            label=one,
            linewidth=1,
        )
    axes.set(xlabel="time, s", ylabel=ylabel, ylim=(0, None))
    legend_above(axes, 3)
    said = describe(Runs(run.path, [run]))
    return caption(figure, f"{what} of one run, {said.label} on {said.engine}, seed {run.seed}.")


def numbers(run):
    return _figure(run, functools.partial(_steps, run), "individuals", "Individuals of each species")


def energy(run):
    table = run.table("energy")
    its = {species: rows for species, rows in table.groupby("species")}
    return _figure(
        run,
        lambda species: (its[species].time_s.to_numpy(float), its[species].stock_J.to_numpy(float)),
        "stock of energy, J",
        "Energy of all members of each species",
    )


def figures_of(folder):
    """(name, function) of each figure of a run's folder."""
    run = read_run(pathlib.Path(folder))
    figures = [("numbers", functools.partial(numbers, run))]
    return figures + [("energy", functools.partial(energy, run))] * (run.path / "energy.csv").exists()
