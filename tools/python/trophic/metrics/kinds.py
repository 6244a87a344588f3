# SPDX-License-Identifier: MIT
"""`trophic analyze --kinds`: kinds within a species of the food web, that is, clusters of genomes or traits, and gene flow between them.

Kinds are found over a null that has the run's births, deaths and parents, and each parent's number of offspring. In it

- the genomes of founders are permuted among the founders, and those of later newcomers among these;
- the mutations of a birth, and from which parent each locus comes, are those of another birth with as many parents, permuted;
- mates are paired at random: births that follow one another exchange their second parents.

In a population of one parent a birth no genomes are exchanged, and families cluster without any selection. Its null has the same genealogy, so that
families are in the null as in the run: kinds are found there only if genomes lie in tighter clusters than this genealogy gives any neutral genome. To
shuffle loci between individuals would be a wrong null of it: it finds kinds in most neutral clonal populations (test_kinds.py). With two parents,
the null is random mating of the same parents. It keeps kinship, which shuffled loci have not.

Kinds say nothing about why parents mate within them. Where mates are neighbours, distance alone separates: compare with runs in which mate choice has
strength 0. A neutral genome of a run with kinds (`--neutral`) clusters as well, as far as parents mate within kinds."""
from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy
from scipy.cluster import hierarchy
from scipy.spatial import distance

from ..errors import RunError
from ..statistics import is_significant
from ..values import Metric
from . import drift
from .drift import Descent
from .tables import Results, Web, mean_of

if TYPE_CHECKING:
    from ..pool import PooledRun

GENOME = "genome"
"""All weights and traits but the sex, which is drawn at each birth and would make two clusters of any population."""
NULL = "same_parents"
FORESTS = 99
WINDOWS = 10
LEAST, MOST_KINDS = 10, 8
"""Living members below which a species is not measured; clusters into which it is cut at most."""
LEAST_SHARE = 0.1
"""Of the members a kind has, and two at least; smaller clusters are outliers."""
DESCRIBED = ("kinds", "kinds_p", "kinds_gene_flow_p")
"""Conclusions of each run by itself, which are not tested over runs."""
_DIGITS = 9
"""The order of rows changes silhouettes by rounding, and before the first births that order is all that the null changes."""
METRICS = ("kinds", "kinds_silhouette", "kinds_p", "kinds_gene_flow", "kinds_gene_flow_p")


def names(web: Web) -> list[Metric]:
    """The metrics, in the order of all tables."""
    return [
        Metric(metric, species, group, "1")
        for species in web.species
        for group in ("early", "late")
        for metric in METRICS
    ]


def check(run: PooledRun, loci: Sequence[str]) -> None:
    """Raises RunError, naming the file or the option, unless the run has genomes with these loci: GENOME, or columns of genomes.csv."""
    drift.check(run)
    _chosen(run, loci)


def _chosen(run: PooledRun, loci: Sequence[str]) -> list[str]:
    """The columns of genomes.csv that are compared."""
    with open(run.path / "genomes.csv", encoding="utf-8") as file:
        columns = file.readline().rstrip("\r\n").split(",")[3:]
    if not columns:
        raise RunError(f"{run.path / 'genomes.csv'}: has no weights and no traits; genes.csv is not measured")
    every = [name for name in columns if name != "sex"]
    if list(loci) == [GENOME]:
        return every
    if unknown := [name for name in loci if name not in columns]:
        shown = [name for name in columns if not re.fullmatch(r"w[1-9]\d*", name)]
        raise RunError(f"--kinds {unknown[0]}: must be {GENOME}, or columns of genomes.csv: {', '.join(shown)}, ...")
    return list(dict.fromkeys(loci))


def measure_run(run: PooledRun, loci: Sequence[str]) -> Results:
    """Measures a run in WINDOWS windows. Raises RunError for a table that is cut or was changed after the run."""
    check(run, loci)
    of = drift.read_descent(run, _chosen(run, loci))
    end_s = run.lived_s
    times_s = end_s * numpy.arange(1, WINDOWS + 1) / WINDOWS
    results = Results()
    for number, species in enumerate(run.web.species):
        rng = numpy.random.Generator(numpy.random.Philox(key=numpy.array([run.seed, number], dtype=numpy.uint64)))
        found = kinds_of(of, species, times_s, rng, FORESTS)
        if all(math.isnan(value) for value in found.silhouette[:, 0]):
            results.remarks.append(
                f"{run.path}: {species}: fewer than {LEAST} living members at the end of each window: no kinds are measured"
            )
        for group, chosen in (("early", times_s <= 0.5 * end_s), ("late", times_s > 0.5 * end_s)):
            _add(species, group, found.of(chosen), results)
        for metric, points in (("kinds_silhouette", found.silhouette), ("kinds_gene_flow", found.gene_flow())):
            results.add_curve(metric, species, "all", "1", times_s, points[:, 0])
            results.add_curve(
                metric, species, "all", "1", times_s, numpy.array([mean_of(of) for of in points[:, 1:]]), NULL
            )
    return results


def _add(species: str, group: str, found: Found, results: Results) -> None:
    silhouette = _means(found.silhouette)
    p = rank_p(silhouette)
    flow = found.gene_flow(over_windows=True)[0]
    kinds = mean_of(found.count[:, 0]) if is_significant(p) else 1.0
    for metric, value, null in (
        ("kinds", math.nan if math.isnan(p) else kinds, None),
        ("kinds_silhouette", silhouette[0], mean_of(silhouette[1:])),
        ("kinds_p", p, None),
        ("kinds_gene_flow", flow[0], mean_of(flow[1:])),
        ("kinds_gene_flow_p", rank_p(-flow), None),
    ):
        baselines = () if null is None else ((NULL, "null", round(null, _DIGITS)),)
        results.add(metric, species, group, "1", round(value, _DIGITS), baselines)


def rank_p(values: numpy.ndarray) -> float:
    """The share of all values, the first and those of the forests of the null, that are at least the first; nan without it."""
    if math.isnan(values[0]):
        return math.nan
    known = values[~numpy.isnan(values)]
    return float((known >= known[0]).mean())


def _means(values: numpy.ndarray) -> numpy.ndarray:
    """The mean of each column over the rows in which the first column has a value."""
    rows = values[~numpy.isnan(values[:, 0])]
    return rows.mean(axis=0) if len(rows) else numpy.full(values.shape[1], math.nan)


class Found(NamedTuple):
    """What is found in each window, in the run (column 0) and in the forests of the null; shape (windows, 1 + forests)."""

    silhouette: numpy.ndarray
    """of the best cut; nan of a window with fewer than LEAST living members"""
    count: numpy.ndarray
    """its kinds"""
    crosses: numpy.ndarray
    """births in the window across kinds: of two parents of different kinds, or of a child of another kind than its only parent"""
    expected: numpy.ndarray
    """the same if the same parents, or children, were paired at random"""

    def of(self, windows: numpy.ndarray) -> Found:
        return Found(*(values[windows] for values in self))

    def gene_flow(self, over_windows: bool = False) -> numpy.ndarray:
        """Births across kinds over those expected: 1 is random mating, 0 no gene flow; a row a window, or one over all."""
        crosses, expected = (
            values.sum(axis=0, keepdims=True) if over_windows else values for values in (self.crosses, self.expected)
        )
        with numpy.errstate(divide="ignore", invalid="ignore"):
            return numpy.where(expected > 0.0, crosses / expected, math.nan)


def kinds_of(of: Descent, species: str, times_s: numpy.ndarray, rng: numpy.random.Generator, forests: int) -> Found:
    """Finds the kinds of a species at the ends of windows, and the births across them in each window."""
    shape = (len(times_s), 1 + forests)
    found = Found(*(numpy.full(shape, math.nan) for _ in range(2)), *(numpy.zeros(shape) for _ in range(2)))
    for window, (genomes, living, births) in enumerate(_grown(of, species, times_s, rng, forests)):
        if len(living) < LEAST:
            continue
        spread = genomes[living].std(axis=0)
        genomes = genomes / numpy.where(spread > 0.0, spread, math.inf)
        for forest in range(1 + forests):
            rows = genomes[:, forest]
            silhouette, labels = best_cut(rows[living])
            found.silhouette[window, forest] = round(silhouette, _DIGITS)
            found.count[window, forest] = labels.max() + 1
            if labels.max() > 0:
                crossing = _crossing(rows, living, labels, births.pairs(forest))
                found.crosses[window, forest], found.expected[window, forest] = crossing
    return found


def _crossing(
    rows: numpy.ndarray,
    living: numpy.ndarray,
    labels: numpy.ndarray,
    pairs: Iterator[tuple[numpy.ndarray, numpy.ndarray]],
) -> tuple[float, float]:
    """Births across kinds, and those expected. Each parent and child is of the kind with the nearest mean."""
    means = numpy.array([rows[living[labels == kind]].mean(axis=0) for kind in range(labels.max() + 1)])
    kind = distance.cdist(rows, means).argmin(axis=1)
    crosses = expected = 0.0
    for first, second in pairs:
        a, b = (numpy.bincount(kind[each], minlength=len(means)) / len(first) for each in (first, second))
        crosses += float((kind[first] != kind[second]).sum())
        expected += len(first) * (1.0 - float(a @ b))
    return crosses, expected


def best_cut(rows: numpy.ndarray) -> tuple[float, numpy.ndarray]:
    """The greatest mean silhouette [rousseeuw1987] over the cuts of Ward's tree [ward1963] into 2 to MOST_KINDS clusters, and the kind of each row there.
    Clusters with less than LEAST_SHARE of the rows are outliers, of kind -1, whose silhouettes are 0. Without a cut into two kinds the silhouette is 0,
    and all rows are of one kind."""
    apart = distance.pdist(rows)
    best, kinds = 0.0, numpy.zeros(len(rows), int)
    if not apart.any():
        return best, kinds
    tree, square = hierarchy.ward(apart), distance.squareform(apart)
    for cut in hierarchy.cut_tree(tree, range(2, MOST_KINDS + 1)).T:
        sizes = numpy.bincount(cut)
        big = numpy.flatnonzero(sizes >= max(2, math.ceil(LEAST_SHARE * len(rows))))
        if len(big) < 2:
            continue
        kind_of = numpy.full(len(sizes), -1)
        kind_of[big] = numpy.arange(len(big))
        labels = kind_of[cut]
        sums = square[labels >= 0] @ (labels[:, None] == numpy.arange(len(big)))
        own = (numpy.arange(len(sums)), labels[labels >= 0])
        within = sums[own] / (sizes[big][own[1]] - 1)
        means = sums / sizes[big]
        means[own] = math.inf
        nearest = means.min(axis=1)
        silhouette = float(((nearest - within) / numpy.maximum(nearest, within).clip(1e-300)).sum()) / len(rows)
        if silhouette > best:
            best, kinds = silhouette, labels
    return best, kinds


class Births(NamedTuple):
    """The births of a window, as rows of its genomes."""

    parents: numpy.ndarray
    """(births, most parents, 1 + forests); -1 beyond their number"""
    children: numpy.ndarray

    def pairs(self, forest: int) -> Iterator[tuple[numpy.ndarray, numpy.ndarray]]:
        """The first and second parents of births with two or more, and the parents and children of those with one."""
        parents = self.parents[:, :, forest]
        if parents.shape[1] > 1 and (several := parents[:, 1] >= 0).any():
            yield parents[several, 0], parents[several, 1]
            parents, children = parents[~several], self.children[~several]
        else:
            children = self.children
        if len(children):
            yield parents[:, 0], children


def _grown(
    of: Descent, species: str, times_s: numpy.ndarray, rng: numpy.random.Generator, forests: int
) -> Iterator[tuple[numpy.ndarray, numpy.ndarray, Births]]:
    """Yields, at the end of each window, genomes in the run and in the forests of the null, shape (individuals, 1 + forests, loci); which of these
    individuals live; and the births in the window."""
    places = [place for place, one in enumerate(of.species) if one == species]
    local = {place: i for i, place in enumerate(places)}
    its = [[local[parent] for parent in of.parents[place]] for place in places]
    born_s, died_s = of.birth_s[places], of.death_s[places]
    weights = of.weights[places]
    given, source = _given(weights, its)
    parents, donor = _dealt(its, born_s, died_s, rng, forests)
    last_use = numpy.zeros(len(places), int)
    for i in range(len(places)):
        last_use[parents[i][parents[i] >= 0]] = i
    kept, genomes = numpy.empty(0, int), numpy.empty((0, 1 + forests, weights.shape[1]))
    column = numpy.arange(1 + forests)
    begin = 0
    for time_s in times_s:
        end = int(numpy.searchsorted(born_s, time_s, side="right"))
        new = numpy.arange(begin, end)
        row_of = numpy.full(len(places), -1)
        kept = numpy.concatenate([kept, new])
        row_of[kept] = numpy.arange(len(kept))
        genomes = numpy.concatenate([genomes, numpy.empty((len(new), *genomes.shape[1:]))])
        for i in new.tolist():
            made = given[donor[i]]
            for k in range(len(its[i])):
                inherited = genomes[row_of[parents[i, k]], column]
                made = made + inherited * (source[donor[i]] == k)
            genomes[row_of[i]] = made
        genomes[row_of[new], 0] = weights[new]
        births = new[[bool(its[i]) for i in new]]
        living = numpy.flatnonzero(died_s[kept] > time_s)
        rows = numpy.where(parents[births] >= 0, row_of[parents[births]], -1)
        yield genomes, living, Births(rows, row_of[births])
        stays = (died_s[kept] > time_s) | (last_use[kept] >= end)
        kept, genomes, begin = kept[stays], genomes[stays], end


def _given(weights: numpy.ndarray, parents: Sequence[Sequence[int]]) -> tuple[numpy.ndarray, numpy.ndarray]:
    """What each individual has from mutation, or of a root its genome, and which parent each locus comes from: the one with the nearest value."""
    given, source = weights.copy(), numpy.zeros(weights.shape, int)
    for i, its in enumerate(parents):
        if its:
            differences = weights[i] - weights[list(its)]
            source[i] = numpy.abs(differences).argmin(axis=0)
            given[i] = numpy.take_along_axis(differences, source[i][None], axis=0)[0]
    return given, source


def _dealt(
    its: Sequence[Sequence[int]],
    born_s: numpy.ndarray,
    died_s: numpy.ndarray,
    rng: numpy.random.Generator,
    forests: int,
) -> tuple[numpy.ndarray, numpy.ndarray]:
    """The parents of each individual, shape (individuals, most parents, 1 + forests), -1 beyond their number, and whose mutations or founder's genome
    it has, (individuals, 1 + forests). Column 0 is the run's."""
    n, most = len(its), max(map(len, its), default=0)
    parents = numpy.full((n, max(1, most), 1 + forests), -1)
    donor = numpy.tile(numpy.arange(n)[:, None], (1, 1 + forests))
    alike: dict[tuple[int, bool], list[int]] = {}
    for i, one in enumerate(its):
        parents[i, : len(one)] = numpy.array(one, int)[:, None]
        alike.setdefault((len(one), not one and bool(born_s[i] == born_s[0])), []).append(i)
    for members in alike.values():
        donor[members, 1:] = rng.permuted(donor[members, 1:], axis=0)
    couples = numpy.array([i for i, one in enumerate(its) if len(one) > 1], int)
    if not len(couples):
        return parents, donor
    ends_s = numpy.minimum(died_s, born_s[-1])
    span_s = max(float(born_s[-1] - born_s[0]), 1e-300)
    block = max(2, round(float((ends_s - born_s).sum()) / span_s / 4))  # births that replace a quarter of the living
    for start in range(0, len(couples), block):
        those = couples[start : start + block]
        for k in range(1, most):
            own = parents[those, k, 1:]
            other = rng.permuted(own, axis=0)
            fits = (other >= 0) & (own >= 0) & (born_s[other] < born_s[those][:, None])
            for other_k in range(k):
                fits &= other != parents[those, other_k, 1:]
            parents[those, k, 1:] = numpy.where(fits, other, own)
    return parents, donor
