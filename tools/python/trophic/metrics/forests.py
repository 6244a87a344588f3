# SPDX-License-Identifier: MIT
"""Measures of a forest of descent: what persists (MODES), evolutionary activity of types, and the shape of descent."""
from __future__ import annotations

import dataclasses
import functools
from collections.abc import Sequence

import numpy


@dataclasses.dataclass(frozen=True)
class Forest:
    """Individuals in the order of their births, so that each parent is before its offspring. All arrays have one element an individual."""
    parent: numpy.ndarray
    """the parent's place in the forest; -1 for a root"""
    birth_s: numpy.ndarray
    death_s: numpy.ndarray
    """s; inf while it lives"""
    species: numpy.ndarray
    type: numpy.ndarray
    """whole numbers from 0; equal for genomes whose brains decide alike"""
    complexity: numpy.ndarray
    """pairs of an input and an output of its brain that depend on each other"""

    @functools.cached_property
    def parents(self) -> list[int]:
        return self.parent.tolist()

    @functools.cached_property
    def depths(self) -> list[int]:
        """The number of births between each individual and its root."""
        depths: list[int] = []
        for parent in self.parents:
            depths.append(depths[parent] + 1 if parent >= 0 else 0)
        return depths

    def living(self, time_s: float, species=None) -> numpy.ndarray:
        """Whether each individual lives after the rules of the tick at this time and is of the species, if one is given. Shape (individuals,)."""
        lives = (self.birth_s <= time_s) & (self.death_s > time_s)
        return lives if species is None else lives & (self.species == species)


def persistent(forest: Forest, species, start_s: float, end_s: float) -> list[int]:
    """The places of the individuals that lived at `start_s` and are the most recent ancestors, at that time, of the members of the species that
    live at `end_s`; ascending."""
    lived = forest.living(start_s).tolist()
    kept = set()
    for place in numpy.flatnonzero(forest.living(end_s, species)).tolist():
        while place >= 0 and not lived[place]:
            place = forest.parents[place]
        if place >= 0:
            kept.add(place)
    return sorted(kept)


def modes(forest: Forest, species, times_s: Sequence[float] | numpy.ndarray) -> numpy.ndarray:
    """The measures of MODES [dolson2019] in the windows between successive times, which see only what persists over the window.

    Returns shape (windows, 4): change, the types that persist and did not in the window before; novelty, those that persist for the first time;
    ecology, the entropy of the types of the individuals kept, bits; complexity, the greatest among them. nan: the first window has no change and
    no novelty, and a window without survivors no ecology and no complexity."""
    result = numpy.full((len(times_s) - 1, 4), numpy.nan)
    before: set[int] = set()
    ever: set[int] = set()
    for window, kept in enumerate(persistent(forest, species, *ends) for ends in zip(times_s, times_s[1:])):
        types, counts = numpy.unique(forest.type[kept], return_counts=True)
        now = set(types.tolist())
        if window > 0:
            result[window, :2] = len(now - before), len(now - ever)
        if kept:
            shares = counts / len(kept)
            result[window, 2:] = -(shares * numpy.log2(shares)).sum(), forest.complexity[kept].max()
        before = now
        ever |= now
    return result


def presence(forest: Forest, species, times_s: numpy.ndarray, types: int) -> numpy.ndarray:
    """Whether a member of the species bears each type at each time. Returns booleans of shape (types, times)."""
    members = forest.species == species
    bearers = numpy.zeros((types, len(times_s) + 1), dtype=int)
    first, last = (numpy.searchsorted(times_s, each[members]) for each in (forest.birth_s, forest.death_s))
    numpy.add.at(bearers, (forest.type[members], first), 1)
    numpy.add.at(bearers, (forest.type[members], numpy.maximum(first, last)), -1)
    return bearers[:, :-1].cumsum(axis=1) > 0


def activity(present: numpy.ndarray, nulls: Sequence[numpy.ndarray]) -> numpy.ndarray:
    """Evolutionary activity [bedau1998], compared type by type with that in `nulls`, presences in forests in which nothing was selected; at least
    one. All have shape (types, times). The activity of a type is the number of times, up to this one, at which it was present.

    Returns shape (times, 4): diversity, the types present; the mean activity of these; the mean of what each one's exceeds its own mean activity
    in the nulls by, or 0; the types whose activity first exceeds what 95 % of the types of the nulls ever reach."""
    own = present.cumsum(axis=1)
    others = [each.cumsum(axis=1) for each in nulls]
    reached = numpy.sort(numpy.concatenate([each[each[:, -1] > 0, -1] for each in others]))
    threshold = reached[-(-95 * len(reached) // 100) - 1] if len(reached) else 0
    diversity = present.sum(axis=0)
    excess = numpy.maximum(0.0, own - sum(others) / len(others))
    with numpy.errstate(invalid="ignore"):
        means = [numpy.where(diversity > 0, (each * present).sum(axis=0) / diversity, 0.0) for each in (own, excess)]
    return numpy.column_stack([diversity, *means, (present & (own == threshold + 1)).sum(axis=0)])


def descent(forest: Forest, species, time_s: float) -> numpy.ndarray:
    """The shape of the descent of the members of a species that live at a time. Random newcomers make it a forest, so nothing needs one tree.

    Returns roots with a living descendant; the share of the living that descend from the root with the most of them; the mean and the greatest
    number of births between a living individual and its root; the share of pairs with a common ancestor; the mean age of their most recent one, s;
    the length of all branches that lead to the living, per living individual, s. nan: all without living members, pairs of one individual, ages
    without a related pair. An individual that lives is its own descendant: with its offspring it is a pair whose common ancestor is itself. A
    branch is an individual's life from its birth to that of its last offspring with living descendants, or to `time_s` if it lives itself."""
    living = numpy.flatnonzero(forest.living(time_s, species)).tolist()
    if not living:
        return numpy.full(7, numpy.nan)
    clade = dict.fromkeys(living, 1)  # living descendants
    for place in living:
        while (place := forest.parents[place]) >= 0 and place not in clade:
            clade[place] = 0
    ends_s = dict.fromkeys(living, time_s)  # of branches
    below = dict.fromkeys(clade, 0)  # pairs of which both are in the clade of one offspring
    roots = largest = related = 0
    ages_s = length_s = 0.0
    for place in sorted(clade, reverse=True):
        birth_s, parent, size = float(forest.birth_s[place]), forest.parents[place], clade[place]
        pairs = size * (size - 1) // 2
        length_s += ends_s[place] - birth_s
        related += pairs - below[place]
        ages_s += (pairs - below[place]) * (time_s - birth_s)
        if parent >= 0:
            clade[parent] += size
            below[parent] += pairs
            ends_s[parent] = max(ends_s.get(parent, 0.0), birth_s)
        else:
            roots += 1
            largest = max(largest, size)
    n = len(living)
    depths = [forest.depths[place] for place in living]
    return numpy.array([roots, largest / n, sum(depths) / n, max(depths), related / (n * (n - 1) / 2) if n > 1 else numpy.nan,
                        ages_s / related if related else numpy.nan, length_s / n])
