# SPDX-License-Identifier: MIT
"""The genomes of a run's individuals, forests of drift with the run's births and deaths but parents by chance, and the inputs that brains met."""
from __future__ import annotations

import copy
import dataclasses
import json
import os
import re
import subprocess
import tempfile
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING

import numpy

from ..errors import RunError
from ..words import number_text
from .forests import Forest

if TYPE_CHECKING:
    from ..pool import PooledRun

FORESTS = 4  # of drift
MOST_INPUTS = 24  # of a species, by which brains are compared
_NULL_MODEL = 11  # the purpose of the stream, as trophic::Stream numbers it
_ROUNDING_S = 1e-6


@dataclasses.dataclass
class Descent:
    """The individuals of a run in the order of their births, with their genomes."""

    ids: list[int]
    birth_s: numpy.ndarray
    death_s: numpy.ndarray
    species: list[str]
    parents: list[list[int]]
    """the places of each one's parents, none of a root; those of drift differ"""
    weights: numpy.ndarray
    """a row an individual, with zeros beyond the genome of its species"""
    sizes: dict[str, int]
    """the number of weights of a genome, by species"""


def stream(seed: int, individual: int) -> Callable[[], float]:
    """Uniform numbers of trophic's own stream for null models, bit by bit."""
    counter = ((individual << 64) - 1) % 2**256  # numpy counts up before it draws
    words = [counter >> shift & (2**64 - 1) for shift in (0, 64, 128, 192)]
    return numpy.random.Generator(
        numpy.random.Philox(
            key=numpy.array([seed, _NULL_MODEL], dtype=numpy.uint64), counter=numpy.array(words, dtype=numpy.uint64)
        )
    ).random


def check(run: PooledRun) -> None:
    """Raises RunError, naming the file, unless the manifest says that the run has what lineage measures need: it was written to its end, has
    phylogeny.csv and genomes.csv, and no genome changes after its individual's birth.
    """
    if run.reached_s is None:
        raise RunError(
            f"{run.path / 'manifest.json'}: status \"{run.manifest['status']}\": phylogeny.csv lists living individuals only at the end of a "
            "run; resume the run"
        )
    for name in ("phylogeny.csv", "genomes.csv"):
        if not (run.path / name).exists():
            raise RunError(f"{run.path / name}: is missing; lineage measures need the phylogeny and the genomes")
    if run.manifest.get("rules", {}).get("heredity") == "shared_copy":
        _refuse_shared(run)


def _refuse_shared(run: PooledRun) -> None:
    heredity = run.manifest.get("rules", {}).get("heredity", "unknown")
    raise RunError(
        f"{run.path / 'genomes.csv'}: rule heredity = {heredity}: must give each individual its own genome, like own_copy; a shared genome "
        "changes after birth"
    )


def read_descent(run: PooledRun, loci: Sequence[str] | None = None) -> Descent:
    """Reads phylogeny.csv and genomes.csv, of which it takes the columns `loci`, by default all weights. Raises RunError as `check`, and for a table
    that is cut, was changed since the run, or lacks a genome or a parent."""
    check(run)
    table = _whole(run, "phylogeny.csv", ["id", "ancestor_list", "origin_time", "destruction_time", "species"])
    path, end_s = run.path / "phylogeny.csv", run.reached_s or 0.0
    try:
        table = table.assign(
            id=table["id"].astype("uint64"),
            origin_time=table.origin_time.astype(float),
            destruction_time=table.destruction_time.astype(float),
        )
    except (ValueError, OverflowError) as error:
        raise RunError(f"{path}: {error}") from None
    table = table.sort_values("id", kind="stable")
    places: dict[int, int] = {}
    parents: list[list[int]] = []

    def refuse(one: int, what: str) -> None:
        raise RunError(f"{path}: id {one}: {what}")

    for place, (one, text, born_s, died_s, species) in enumerate(
        zip(*(table[name].tolist() for name in table.columns))
    ):
        if not 0.0 <= born_s <= end_s + _ROUNDING_S:
            refuse(one, f"origin_time = {number_text(born_s)}: must be >= 0 and <= {number_text(end_s)}, the run's end")
        if not (died_s == numpy.inf or born_s <= died_s <= end_s + _ROUNDING_S):
            refuse(
                one,
                f"destruction_time = {number_text(died_s)}: must be >= its origin_time, {number_text(born_s)}, and <= {number_text(end_s)}, "
                "the run's end",
            )
        if species not in run.web.species:
            refuse(one, f'species = "{species}": must be a species of the run\'s manifest')
        if not re.fullmatch(r"\[(none|\d+(,\d+)*)\]", text):
            refuse(one, f"ancestor_list = {text}: must be [none] or its parents, as [7,9]")
        named = [] if text == "[none]" else [int(word) for word in re.findall(r"\d+", text)]
        if unknown := [other for other in named if other not in places]:
            refuse(one, f"its parent {unknown[0]} was not born before it")
        if places.setdefault(one, place) != place:
            refuse(one, "has two rows")
        parents.append([places[other] for other in named])
    species = table.species.tolist()
    return Descent(
        [*places],
        table.origin_time.to_numpy(),
        table.destruction_time.to_numpy(),
        species,
        parents,
        *_weights(run, places, species, loci),
    )


def _weights(
    run: PooledRun, places: dict[int, int], species: Sequence[str], loci: Sequence[str] | None
) -> tuple[numpy.ndarray, dict[str, int]]:
    """The weights and sizes of the individuals' genomes, as Descent has them."""
    path = run.path / "genomes.csv"
    with open(path, encoding="utf-8") as file:
        header = file.readline().rstrip("\r\n").split(",")
    columns = [name for name in header if re.fullmatch(r"w\d+", name)] if loci is None else list(loci)
    table = _whole(run, "genomes.csv", ["id", "genome_id", *columns])
    if (table.groupby("genome_id")["id"].nunique() > 1).any():
        _refuse_shared(run)
    rows = table[columns].to_numpy()
    try:
        at = numpy.array([places.get(int(one), -1) for one in table["id"]], dtype=int)
        values = numpy.where(rows == "", "0", rows).astype(float)
    except ValueError as error:
        raise RunError(f"{path}: {error}") from None
    if not numpy.isfinite(values).all():
        raise RunError(f"{path}: a weight is not finite")
    sizes = numpy.full(len(places), 0)
    weights = numpy.zeros((len(places), len(columns)))
    sizes[at[at >= 0]] = (rows != "").sum(axis=1)[at >= 0]
    weights[at[at >= 0]] = values[at >= 0]
    of_species: dict[str, int] = {}
    for one, place in places.items():
        if sizes[place] == 0:
            raise RunError(f"{path}: has no genome of individual {one}")
        if sizes[place] != (must := of_species.setdefault(species[place], int(sizes[place]))):
            raise RunError(f"{path}: id {one}: {sizes[place]} weights: must be {must}, as of others of its species")
    return weights, of_species


def _whole(run: PooledRun, name: str, columns: Sequence[str]):
    remarks: list[str] = []
    table = run.texts(name, columns, (), remarks)
    if remarks:
        raise RunError(f"{run.path / name}: the last line is truncated; resume the run")
    return table[list(columns)]


def drift_of(of: Descent, web: Sequence[str], draw: Callable[[], float]) -> Descent:
    """The same births, deaths and mutations with parents by chance.

    The parents of each individual that has any are drawn among those of its species that are alive just before its birth and after its tick's
    deaths; if these are fewer than its parents, it keeps them. Genomes of roots are permuted among the founders of a species, and among its later
    roots. Each offspring's weights are the mean of its new parents' plus the mutation, with two parents also the crossover, of another offspring of
    its species, also permuted. So births, deaths and the numbers of newcomers are the run's, and no genome lives longer or has more offspring for
    what it does. `draw` gives uniform numbers."""
    parents, weights = copy.deepcopy(of.parents), of.weights.copy()
    alike: dict[tuple[int, bool, bool], list[int]] = {}
    for place, its in enumerate(of.parents):
        alike.setdefault(
            (web.index(of.species[place]), bool(its), bool(of.birth_s[place] == of.birth_s[0])), []
        ).append(place)
        _add_parents(weights, place, its, of.weights, -1.0)
    for _, places in sorted(alike.items()):
        order = list(range(len(places)))
        for left in range(len(order), 1, -1):
            other = int(draw() * left)
            order[left - 1], order[other] = order[other], order[left - 1]
        weights[places] = weights[numpy.array(places)[order]]
    born_s, died_s = of.birth_s.tolist(), of.death_s.tolist()
    living: list[int] = []
    for place, its in enumerate(of.parents):
        living = [one for one in living if died_s[one] > born_s[place]]
        if its:
            candidates = [one for one in living if of.species[one] == of.species[place] and born_s[one] < born_s[place]]
            if len(candidates) >= len(its):
                for i in range(len(its)):
                    drawn = int(draw() * len(candidates))
                    candidates[drawn], candidates[-1] = candidates[-1], candidates[drawn]
                    parents[place][i] = candidates.pop()
            _add_parents(weights, place, parents[place], weights, 1.0)
        living.append(place)
    return Descent(of.ids, of.birth_s, of.death_s, of.species, parents, weights, of.sizes)


def _add_parents(weights: numpy.ndarray, place: int, parents: Sequence[int], of: numpy.ndarray, factor: float) -> None:
    """Adds `factor` times the mean of its parents' weights to an individual's."""
    for parent in (*parents[1:], *parents[:1]):
        weights[place] += factor / len(parents) * of[parent]


def met_inputs(runs: Sequence[PooledRun], most: int = MOST_INPUTS) -> list[list[list[float]]]:
    """For each species of the food web up to `most` different inputs that brains of the species had in these runs, drawn at random and always
    alike. Raises RunError, naming the file, if a run has no senses.csv, or if it is cut or was changed since the run.
    """
    drawn = []
    for number, species in enumerate(runs[0].web.species):
        met = [rows for run in runs for rows in _met(run, species)]
        inputs = [rows.tolist() for rows in _different(numpy.concatenate(met))] if met else []
        draw = stream(0, number)
        for left in range(len(inputs), 1, -1):
            other = int(draw() * left)
            inputs[left - 1], inputs[other] = inputs[other], inputs[left - 1]
        drawn.append(inputs[:most])
    return drawn


def _met(run: PooledRun, species: str) -> list[numpy.ndarray]:
    """The inputs of a species in a run, or nothing."""
    path = run.path / "senses.csv"
    if not path.exists():
        raise RunError(f"{path}: is missing; lineage measures need it from the first run: run with --senses")
    columns = [f"input{i}" for i in range(len(run.manifest.get("senses", {}).get("inputs", [])))]
    table = _whole(run, "senses.csv", ["species", *columns])
    cells = table.loc[table.species == species, columns].to_numpy()
    if not columns or not len(cells := cells[cells[:, 0] != ""]):
        return []  # no brain was asked
    try:
        return [cells[:, (cells != "").all(axis=0)].astype(float)]  # cells beyond the inputs of a species are empty
    except ValueError as error:
        raise RunError(f"{path}: {error}") from None


def _different(rows: numpy.ndarray) -> numpy.ndarray:
    """The different rows, sorted; of equal ones the first."""
    rows = rows[numpy.lexsort(rows.T[::-1])]
    return rows[numpy.concatenate([[True], (rows[1:] != rows[:-1]).any(axis=1)])]


def ask(
    program: str, first: PooledRun, inputs: Sequence, descents: Sequence[Descent] = ()
) -> list[tuple[numpy.ndarray, numpy.ndarray]]:
    """The types and the complexity of the genomes of these individuals, as `signatures`."""
    species = [first.web.species.index(name) for of in descents for name in of.species]
    genomes = (row[: of.sizes[name]] for of in descents for name, row in zip(of.species, of.weights))
    found = signatures(program, first, inputs, species, genomes)
    ends = numpy.cumsum([len(of.ids) for of in descents])[:-1]
    return [(part[:, 0], part[:, 1]) for part in numpy.split(found, ends)] if descents else []


def signatures(
    program: str, first: PooledRun, inputs: Sequence, species: Sequence[int], genomes: Iterable[numpy.ndarray]
) -> numpy.ndarray:
    """The type and the complexity of each genome, by the brain of the rule table that made the run `first`. Genomes of one type decide alike on all
    inputs of their species. They may differ in size. Raises RunError with the program's sentence if it has not this table, or if its brain does not
    take them. Shape (genomes, 2)."""
    genomes = list(genomes)
    manifest = first.manifest
    head = {
        "rule_table": manifest["rule_table"],
        "engine": manifest["backend"].split(" ")[0],
        "fingerprint": manifest["fingerprint"],
        "params": manifest["params"],
        "inputs": inputs,
        "species": list(species),
        "sizes": [len(genome) for genome in genomes],
    }
    with tempfile.TemporaryDirectory(prefix="trophic-") as folder:
        path = os.path.join(folder, "genomes")
        with open(path, "wb") as file:
            file.write(json.dumps(head).encode() + b"\n")
            file.writelines(numpy.asarray(genome, "<f8").tobytes() for genome in genomes)
        done = subprocess.run(
            [program, "--signatures", path], capture_output=True, encoding="utf-8", errors="surrogateescape"
        )
    if done.returncode != 0:
        raise RunError(done.stderr.strip() or f"{program} --signatures: exit code {done.returncode}")
    return numpy.array(done.stdout.split(), dtype=int).reshape(-1, 2)


def forest_of(of: Descent, types: numpy.ndarray, complexity: numpy.ndarray) -> Forest:
    """The individuals as the measures of forests take them."""
    first = numpy.array([its[0] if its else -1 for its in of.parents], dtype=int)
    return Forest(
        first,
        of.birth_s,
        of.death_s,
        numpy.array(of.species, dtype=object),
        types,
        complexity,
        {place: its[1:] for place, its in enumerate(of.parents) if len(its) > 1},
    )
