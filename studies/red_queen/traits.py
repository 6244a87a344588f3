# SPDX-License-Identifier: MIT
"""How far a heritable trait moves in a run, over drift: its mean over the living members of a species, less the same mean if nothing selects.

Drift drops the trait down the genealogy of the run itself: births, deaths and parents stay, and the mutation of each birth is drawn anew by the
run's rule, reproduction/traits/list.hpp. That is the neutral null, drawn as often as one likes, so that its mean has next to no error of its own."""
import math

import numpy
import pandas

DRAWS, POINTS = 200, 121
"""Draws of drift for a run, and times at which means are taken."""


def living(run):
    """The rows of the genealogy of those that live at the end."""
    lives = run.table("phylogeny")
    return lives[~numpy.isfinite(lives["destruction_time"])]


def born_of(run):
    """A row per individual in order of birth: its own genome's row and its life."""
    lives = run.table("phylogeny")[["id", "ancestor_id", "origin_time", "destruction_time", "species"]]
    return run.table("genomes").drop_duplicates("id").merge(lives, on="id").sort_values("id", ignore_index=True)


def dropped(born, rule, inherits, generator, draws=DRAWS):
    """Traits by drift, shape (individuals, draws). `inherits`: by species, whether the newborn start from their parent's trait."""
    mutations = generator.normal(0.0, rule["sd"], (len(born), draws))
    found, place = numpy.empty_like(mutations), {}
    for row, (id, parent, species) in enumerate(zip(born["id"], born["ancestor_id"], born["species"])):
        place[id] = row
        start = found[place[parent]] if parent != id and inherits[species] else rule["first"]
        found[row] = numpy.clip(start + mutations[row], rule["least"], rule["most"])
    return found


def lives_of(born, species, times_s):
    """Whether each individual lives, and is of a species, at each time, shape (times, individuals)."""
    begins, ends = born["origin_time"].to_numpy(), born["destruction_time"].fillna(math.inf).to_numpy()
    of = (born["species"] == species).to_numpy()
    return of & (begins <= times_s[:, None]) & (times_s[:, None] < ends)


def means_of(lives, values):
    """The mean over the living at each time, shape (times, columns of values); nan if none lives."""
    with numpy.errstate(invalid="ignore"):
        return lives @ values / lives.sum(axis=1, keepdims=True)


class Course:
    """The course of a trait in both species of a run."""

    def __init__(self, run, trait):
        self.end_s = run.manifest["result"]["reached_s"]
        self.times_s = numpy.linspace(0.0, self.end_s, POINTS)
        rules, born = run.manifest["params"]["rules"], born_of(run)
        rule, heredity = rules["traits"][trait], rules["heredity"]
        self.trait, self.inherits = trait, {each: heredity[each]["inherited"] for each in run.manifest["species"]}
        drift = dropped(born, rule, self.inherits, numpy.random.default_rng(int(run.manifest["seed"])))
        own = born[trait].to_numpy()[:, None]
        at_bound = (own >= 0.95 * rule["most"]).astype(float)
        lives = {species: lives_of(born, species, self.times_s) for species in self.inherits}
        self.number = {species: of.sum(axis=1) for species, of in lives.items()}
        self.own, self.drift, self.at_bound = (
            {species: means_of(of, values) for species, of in lives.items()} for values in (own, drift, at_bound)
        )
        self.persists = all(numpy.isfinite(of[-1, 0]) for of in self.own.values())

    def over(self, species):
        """The mean over drift at each time."""
        return self.own[species][:, 0] - self.drift[species].mean(axis=1)

    def values(self, species):
        """The measures of a species in the run, by name; nan if it has none. Those of the end are of runs in which both species live to it. Those of
        the first third's end and of the last time with both species are of all runs."""
        over, times_s = self.over(species), self.times_s
        both = numpy.isfinite(sum(self.over(each) for each in self.own))
        third = times_s >= 2.0 / 3.0 * self.end_s
        end, first = (
            (times_s > at_s - self.end_s / 12.0) & (times_s <= at_s) for at_s in (self.end_s, self.end_s / 3.0)
        )
        last_both = numpy.flatnonzero(both)[-1]
        found = {"trait_common": over[first].mean(), "trait_last_both": over[last_both], "lived_s": times_s[last_both]}
        if self.persists:
            found |= {
                "trait_end": over[end].mean(),
                "trait_slope": numpy.polyfit(times_s[third] / 1000.0, over[third], 1)[0],
                "at_bound": self.at_bound[species][end].mean(),
                "number": self.number[species][third].mean(),
            }
        return found


def series(course, world, run, every):
    """Rows of the mean of the species that inherit, and of drift, at some of the times, for a figure."""
    return pandas.DataFrame(
        [
            {
                "world": world,
                "run": run,
                "side": species,
                "trait": course.trait,
                "time_s": course.times_s[at],
                "mean": course.own[species][at, 0],
                "drift": course.drift[species][at].mean(),
                "drift_lower": numpy.quantile(course.drift[species][at], 0.025),
                "drift_upper": numpy.quantile(course.drift[species][at], 0.975),
            }
            for species, inherits in course.inherits.items()
            for at in range(0, len(course.times_s), every)
            if inherits and numpy.isfinite(course.own[species][at, 0])
        ]
    )
