# SPDX-License-Identifier: MIT
"""Measures of a forest of descent: what persists (MODES), evolutionary activity of types, and the shape of descent."""
from __future__ import annotations

import dataclasses
import functools
import statistics
from collections.abc import Callable, Mapping, Sequence

import numpy


@dataclasses.dataclass(frozen=True)
class Forest:
    """Individuals in the order of their births, so that each parent is before its offspring. All arrays have one element an individual."""

    parent: numpy.ndarray
    """the first parent's place in the forest; -1 for a root"""
    birth_s: numpy.ndarray
    death_s: numpy.ndarray
    """s; inf while it lives"""
    species: numpy.ndarray
    type: numpy.ndarray
    """whole numbers from 0; equal for genomes whose brains decide alike"""
    complexity: numpy.ndarray
    """pairs of an input and an output of its brain that depend on each other"""
    others: Mapping[int, Sequence[int]] = dataclasses.field(default_factory=dict)
    """by place, the places of further parents"""

    @functools.cached_property
    def parents(self) -> list[tuple[int, ...]]:
        """The places of all parents of each individual; none of a root."""
        return [
            (first, *self.others.get(place, ())) if first >= 0 else ()
            for place, first in enumerate(self.parent.tolist())
        ]

    @functools.cached_property
    def mean_depths(self) -> list[float]:
        """The generation coefficient of each individual [pattie1965]: 0 of a root, else one more than the mean of its parents'. It is the expected
        number of births from a root to it, along parents drawn at random."""
        return self._depths(statistics.fmean)

    @functools.cached_property
    def greatest_depths(self) -> list[float]:
        """The number of births between each individual and its furthest root."""
        return self._depths(max)

    def _depths(self, of: Callable[[list[float]], float]) -> list[float]:
        depths: list[float] = []
        for its in self.parents:
            depths.append(of([depths[one] for one in its]) + 1 if its else 0)
        return depths

    def living(self, time_s: float, species=None) -> numpy.ndarray:
        """Whether each individual lives after the rules of the tick at this time and is of the species, if one is given. Shape (individuals,)."""
        lives = (self.birth_s <= time_s) & (self.death_s > time_s)
        return lives if species is None else lives & (self.species == species)


def persistent(forest: Forest, species, start_s: float, end_s: float) -> list[int]:
    """The places of the individuals that lived at `start_s` and are the most recent ancestors, at that time, of the members of the species that
    live at `end_s`, along each line of parents; ascending."""
    lived = forest.living(start_s).tolist()
    waiting = numpy.flatnonzero(forest.living(end_s, species)).tolist()
    met: set[int] = set()
    while waiting:
        if (place := waiting.pop()) not in met:
            met.add(place)
            waiting += () if lived[place] else forest.parents[place]
    return sorted(place for place in met if lived[place])


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
    in the nulls by, or 0; the types whose activity first exceeds what 95 % of the types of the nulls ever reach.
    """
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
    """The shape of the descent of the members of a species that live at a time. Random newcomers make it a forest, so nothing needs one tree. With
    two parents an individual descends from the roots of both, as in genealogies [chang1999].

    Returns roots with a living descendant; the share of the living that descend from the root with the most of them; of the living, the mean of
    Forest.mean_depths and the greatest of Forest.greatest_depths; the share of pairs with a common ancestor; the mean age of their most recent one,
    s; the length of all branches that lead to the living, per living individual, s. nan: all without living members, pairs of one individual, ages
    without a related pair. An individual that lives is its own descendant: with its offspring it is a pair whose common ancestor is itself. A
    branch is an individual's life from its birth to that of its last offspring with living descendants, or to `time_s` if it lives itself.
    """
    living = numpy.flatnonzero(forest.living(time_s, species)).tolist()
    if not living:
        return numpy.full(7, numpy.nan)
    clade = {place: 1 << bit for bit, place in enumerate(living)}  # the living descendants of each ancestor, as bits
    waiting = living.copy()
    while waiting:
        for parent in forest.parents[waiting.pop()]:
            if parent not in clade:
                clade[parent] = 0
                waiting.append(parent)
    ends_s = dict.fromkeys(living, time_s)  # of branches
    relatives = [1 << bit for bit in range(len(living))]  # of each of the living, those with a common ancestor
    roots, largest, related, ages_s, length_s = 0, 0, 0, 0.0, 0.0
    for place in sorted(clade, reverse=True):  # the most recent first
        birth_s, members = float(forest.birth_s[place]), clade[place]
        length_s += ends_s[place] - birth_s
        pairs = 0
        rest = members if related < len(living) * (len(living) - 1) // 2 and members & (members - 1) else 0
        while rest:
            bit = (rest & -rest).bit_length() - 1
            rest &= rest - 1
            pairs += bin(members & ~relatives[bit]).count("1")
            relatives[bit] |= members
        related += pairs // 2
        ages_s += pairs // 2 * (time_s - birth_s)
        for parent in forest.parents[place]:
            clade[parent] |= members
            ends_s[parent] = max(ends_s.get(parent, 0.0), birth_s)
        if not forest.parents[place]:
            roots += 1
            largest = max(largest, bin(members).count("1"))
    n = len(living)
    return numpy.array(
        [
            roots,
            largest / n,
            sum(forest.mean_depths[place] for place in living) / n,
            max(forest.greatest_depths[place] for place in living),
            related / (n * (n - 1) / 2) if n > 1 else numpy.nan,
            ages_s / related if related else numpy.nan,
            length_s / n,
        ]
    )
