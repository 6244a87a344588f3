# SPDX-License-Identifier: MIT
"""`trophic analyze --selection`: where selection acts on a trait of individuals, by Price's equation [price1970].

Each birth and each death changes the mean trait of the n living members of a species, mean z. With z the trait of who is born or dies and z_p
that of its parent, of several parents their mean, the change is exactly

    death        -(z - E z) / (n - 1)        survival
    birth        (z_p - E z_p) / (n + 1)     parenthood, and (z - z_p) / (n + 1)   mutation
    birth without a parent of its species   (z - mean z) / (n + 1)   newcomers
    the rest     (mean z - E z) / (n - 1) of deaths and (E z_p - mean z) / (n + 1) of births   cohorts

so that the sums over a run add up to what the mean changes by from the founders to the end. E is the mean over the living, weighted by how often
their age and origin die of this cause, or become parents. Who dies is not a random member: the young and the old, the inherited and the random
die at other rates, and under selection of either kind their traits differ. Without E the choice of parents looks like survival.

Lives that the end of the run cuts off bias none of these. Over whole lives, with w the offspring and L the length of a life, cov(w, z) / mean w =
(z_L - mean z) + (z_w - z_L): means weighted by L and by w, so length of life and offspring a second. There the end of the run cuts lives off, and
a trend of the mean counts as length of life.

Terms are tested over the neutral null, which repeats births, deaths and parents with other genomes. No term is tested over zero."""
from __future__ import annotations

import concurrent.futures
import functools
import multiprocessing
import os
import pathlib
import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy
import pandas

from . import pool, statistics
from .description import describe
from .errors import RunError, printable, remark
from .metrics import AGENTS, Agents, Measuring, velocity, walls
from .metrics.tables import numbers, ratio
from .pool import PooledRun
from .report.columns import names
from .runs import verify
from .values import NEUTRAL, MeasuredSet, Metric
from .words import Reading, columns, number_text, p_text
from .writing import csv_text, result_folder, write_new

PERIODS = ("all", "first", "second", "third")
KINDS = ("survival", "parenthood", "mutation", "newcomers", "cohorts")
TESTED = KINDS[:3]
AGES, LEAST_CHOSEN = 6, 10
"""Classes of age at most, and those that die of a cause, or become parents, in each at least. Origins are apart if twice as many do."""
DISTANCES = (0.05, 0.15, 0.25, 0.35, 0.45)
TAG_RATIOS = (-0.2, 0.0, 0.2)
"""The inputs of turns_to: an adversary on either side, so far away in sides of the arena, at these tag ratios."""
_SETS = ("runs", "shadow", "neutral")


# Traits


class Trait(NamedTuple):
    name: str
    unit: str
    read: Callable[[PooledRun], pandas.Series]
    """the trait of each individual that has it, by id"""
    is_behaviour: bool = False
    """measured during a life, so that luck is part of it"""


def trait_of(text: str) -> Trait:
    """Reads a trait as --selection names it. Raises RunError, naming the option and what it may be, for anything else."""
    kind, *parts = text.split(":")
    if kind in ("open_speed", "velocity_open") and not parts:
        return Trait(text, "m/s", functools.partial(_behaviour, kind), True)
    if kind == "gene" and len(parts) in (1, 2) and parts[-1].isdigit():
        of = (
            ("genomes.csv", f"w{int(parts[0])}", {})
            if len(parts) == 1
            else ("genes.csv", "value", {"part": parts[0], "index": str(int(parts[1]))})
        )
        return Trait(text, "1", functools.partial(_column, *of))
    if kind == "turns_to" and len(parts) < 2:
        distances = [float(each) if each.replace(".", "", 1).isdigit() else numpy.nan for each in parts] or list(
            DISTANCES
        )
        if all(0.0 < each <= 1.0 for each in distances):
            return Trait(text, "1", functools.partial(_turns_to, distances))
    elif len(parts) in (1, 2) and all((kind, *parts)) and pathlib.PurePath(kind).name == kind and kind.endswith(".csv"):
        return Trait(f"{kind}:{parts[0]}", (*parts, "1")[1], functools.partial(_column, kind, parts[0], {}))
    raise RunError(
        f"--selection {text}: must be turns_to, turns_to:DISTANCE with 0 < DISTANCE <= 1, open_speed, velocity_open, gene:NUMBER, "
        "gene:PART:NUMBER, FILE:COLUMN or FILE:COLUMN:UNIT"
    )


def _column(file: str, column: str, only: Mapping[str, str], run: PooledRun) -> pandas.Series:
    """A column of a table with a column id, of the rows with the cells `only`; the mean of an individual's rows."""
    table = run.texts(file, ["id", column, *only], (), [])
    for name, cell in only.items():
        table = table[table[name] == cell]
    ids, values = (numbers(run.path / file, table[name], none) for name, none in (("id", ()), (column, ("", "nan"))))
    return pandas.Series(values, index=ids.astype(int)).dropna().groupby(level=0).mean()


def _turns_to(distances: Sequence[float], run: PooledRun) -> pandas.Series:
    """The share of inputs at which the paper's network chooses the side of its adversary. Raises RunError for another brain or other sensors."""
    rules, path = run.manifest.get("rules", {}), run.path / "genomes.csv"
    brain, sensors = rules.get("brain", "unknown"), str(rules.get("sensors", "unknown"))
    if not brain.startswith("cognitive_brain") or not sensors.startswith(
        "side_of_adversary + distance_over_terrain + tag_ratio_of_"
    ):
        raise RunError(
            f"--selection turns_to: {run.path}: brain = {brain}, sensors = {sensors}: must be cognitive_brain with side_of_adversary, "
            "distance_over_terrain and a tag ratio"
        )
    per_neuron = 1 if brain.endswith("_with_biases") else 0
    width = [f"w{i}" for i in range(3 * (3 + per_neuron) + 2 * (3 + per_neuron))]
    table = run.texts("genomes.csv", ["id", *width], (), [])
    weights = numpy.column_stack([numbers(path, table[name]) for name in width])
    inputs = numpy.array([(side, far, tags) for side in (-1.0, 1.0) for far in distances for tags in TAG_RATIOS])
    hidden = inputs @ weights[:, :9].reshape(-1, 3, 3).transpose(0, 2, 1)  # genomes x inputs x neurons
    second = 9 + 3 * per_neuron
    hidden = numpy.tanh(hidden + (weights[:, None, 9:second] if per_neuron else 0.0))
    out = (hidden @ weights[:, second : second + 3, None])[..., 0] + (
        weights[:, None, second + 6] if per_neuron else 0.0
    )
    turns_right = out >= 0.0 if "zero_right" in brain else out > 0.0
    return (
        pandas.Series((turns_right == (inputs[:, 0] > 0.0)).mean(axis=1), index=table["id"].astype(int))
        .groupby(level=0)
        .first()
    )


def _behaviour(kind: str, run: PooledRun) -> pandas.Series:
    """The mean over an individual's life of what the metrics open_speed and velocity_open are means of."""
    agents = Agents(run.load("agents.csv", AGENTS, []), run.web)
    is_open = walls.to_wall_m(agents, run.floor) > walls.REACH_M
    if kind == "velocity_open":
        found = velocity.of_rows(velocity.samples(agents), is_open)
        return pandas.Series(found.velocity_m_s, index=agents.id[found.row]).groupby(level=0).mean()
    before = agents.before
    rows = numpy.flatnonzero((before >= 0) & is_open & is_open[before])
    moved_m = numpy.hypot(agents.x_m[rows] - agents.x_m[before[rows]], agents.y_m[rows] - agents.y_m[before[rows]])
    time_s = agents.time_s[agents.at[rows]] - agents.time_s[agents.at[before[rows]]]
    return pandas.Series(moved_m / time_s, index=agents.id[rows]).groupby(level=0).mean()


# Price's equation


def price(
    step: numpy.ndarray, z: numpy.ndarray, parent_z: numpy.ndarray, expected: numpy.ndarray | None = None
) -> tuple[numpy.ndarray, numpy.ndarray]:
    """The change of the mean trait of the living at each event, by KINDS, shape (5, ..., events), and the mean after it, (..., events).

    `step`: 1 of a birth, -1 of a death; `z`: of the newborn or the dead; `parent_z`: of a newborn's parent, nan without one; `expected`: of the dead,
    or of the parent, by age and origin, as `expected_of` returns it; the mean of the living without it. The first birth changes the mean by nan. An
    empty species keeps the mean of its last member."""
    origin = z[..., :1]  # means of a trait that does not vary are exact
    z, parent_z, living = z - origin, parent_z - origin, numpy.cumsum(step, axis=-1)
    total = numpy.cumsum(step * z, axis=-1)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        mean = numpy.where(living > 0, total / living, numpy.nan)
        last = numpy.maximum.accumulate(numpy.where(living > 0, numpy.arange(step.shape[-1]), 0), axis=-1)
        mean = numpy.take_along_axis(mean, last, axis=-1)
        before = numpy.concatenate([numpy.full_like(mean[..., :1], numpy.nan), mean[..., :-1]], axis=-1)
        due = before if expected is None else numpy.where(numpy.isnan(expected), before, expected - origin)
        is_birth, has_parent = step > 0, ~numpy.isnan(parent_z)
        is_death, is_descended = ~is_birth & (living > 0), is_birth & has_parent
        parts = (
            numpy.where(is_death, (due - z) / living, 0.0),
            numpy.where(is_descended, (parent_z - due) / living, 0.0),
            numpy.where(is_descended, (z - parent_z) / living, 0.0),
            numpy.where(is_birth & ~has_parent, (z - before) / living, 0.0),
            numpy.where(is_death, (before - due) / living, numpy.where(is_descended, (due - before) / living, 0.0)),
        )
    return (numpy.where(numpy.isnan(before), numpy.nan, numpy.stack(parts)), mean + origin)


def expected_of(
    step: numpy.ndarray,
    place: numpy.ndarray,
    time_s: numpy.ndarray,
    is_inherited: numpy.ndarray,
    z: numpy.ndarray,
    choices: Sequence[tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]],
) -> numpy.ndarray:
    """The mean trait of the living before each event of a run, weighted by how often their age and origin are chosen in events of its kind, shape
    (..., events); nan at events of no kind. Weights have the greatest conditional likelihood.

    `step`: as in price; `place`: the number of who is born or dies, in the order of births; `time_s`: of each event; `is_inherited`: of each individual;
    `z`: of each individual, (..., individuals); `choices`: of each kind its events, who is chosen there, -1 if none of the living is, and with what
    share."""
    born_s = time_s[step > 0]
    kind_of = numpy.full(len(step), -1)
    edges: list[numpy.ndarray | None] = []
    for kind, (event, who, _) in enumerate(choices):
        kind_of[event] = kind
        ages_s = (time_s[event] - born_s[who])[who >= 0]
        classes = min(AGES, len(ages_s) // LEAST_CHOSEN)
        edges.append(numpy.unique(numpy.quantile(ages_s, numpy.arange(1, classes) / classes)) if classes > 1 else None)

    def stratum(kind: int, at_s: Any, who: numpy.ndarray) -> numpy.ndarray:
        if (limits := edges[kind]) is None:
            return numpy.zeros(len(who), int)
        return numpy.searchsorted(limits, at_s - born_s[who]) * 2 + is_inherited[who]

    strata = 2 * AGES
    counts, sums = numpy.zeros((len(step), strata)), numpy.zeros((*z.shape[:-1], len(step), strata))
    living, at, n = numpy.zeros(len(born_s), int), numpy.zeros(len(born_s), int), 0
    for event, (its_step, who, kind) in enumerate(zip(step.tolist(), place.tolist(), kind_of.tolist())):
        if kind >= 0 and n:
            those = living[:n]
            of = stratum(kind, time_s[event], those)
            counts[event] = numpy.bincount(of, minlength=strata)
            sums[..., event, :] = z[..., those] @ numpy.eye(strata)[of]
        if its_step > 0:
            living[n], at[who], n = who, n, n + 1
        else:
            n -= 1
            living[at[who]], at[living[n]] = living[n], at[who]
    expected = numpy.full((*z.shape[:-1], len(step)), numpy.nan)
    for kind, (event, who, share) in enumerate(choices):
        is_there = who >= 0
        chosen = numpy.bincount(
            stratum(kind, time_s[event[is_there]], who[is_there]), share[is_there], minlength=strata
        )
        its, weights = numpy.unique(event[is_there]), numpy.ones(strata)
        shares = numpy.bincount(event[is_there], share[is_there], minlength=len(step))[its]
        with numpy.errstate(divide="ignore", invalid="ignore"):
            for _ in range(30):
                due = (shares[:, None] * counts[its] * weights / (counts[its] @ weights)[:, None]).sum(axis=0)
                weights = weights * (chosen + 0.5) / (due + 0.5)
            every = numpy.unique(event)
            expected[..., every] = (sums[..., every, :] @ weights) / (counts[every] @ weights)
    return expected


def events_of(run: PooledRun) -> pandas.DataFrame:
    """Births and deaths in their order; if a rule Recruitment may name several parents, with column `parents`, as an ancestor_list. Raises RunError
    for the death of an individual without a birth."""
    found = run.load("events.csv", ("time_s", "tick", "event", "id", "species", "parent_id", "cause"), [])
    found = (
        found[found["event"].isin(["birth", "death"])]
        .astype({"event": str, "species": str, "cause": str})
        .reset_index(drop=True)
    )
    born = set(found["id"][found["event"] == "birth"])
    for id in found["id"]:
        if id not in born:
            raise RunError(
                f"{run.path}/events.csv: individual {id} dies but was never born; --selection needs runs from their beginning"
            )
    births = run.texts("events.csv", ["event", "id"], ["ancestor_list"], []).query("event == 'birth'")
    if "ancestor_list" in births:
        found["parents"] = found["id"].map(
            births.set_index(numbers(run.path / "events.csv", births["id"]).astype(int))["ancestor_list"]
        )
    return found


def descent_of(births: pandas.DataFrame) -> pandas.DataFrame:
    """A row for each parent of some births: `id`, `parent` and its `share`, one over the number of parents."""
    if "parents" not in births:
        return pandas.DataFrame({"id": births["id"], "parent": births["parent_id"], "share": 1.0}).dropna()
    lists = births.set_index("id")["parents"].str.strip("[]")
    parents = lists[lists != "none"].str.split(",").explode().astype(float)
    each = pandas.DataFrame({"id": parents.index, "parent": parents.to_numpy()})
    return each.assign(share=1.0 / each.groupby("id")["parent"].transform("size"))


def terms(events: pandas.DataFrame, z: pandas.Series, species: str, end_s: float) -> dict[tuple[str, str], float]:
    """The terms of a species by (term, period), where PERIODS are the run and its thirds. `events`: as events_of; `z`: traits by id; those who
    lack it are left out as if they had never lived. Terms of lives and births belong to the third of the birth. nan is what cannot be computed.
    """
    of = events[(events["species"] == species) & events["id"].isin(z.index)]
    is_birth = (of["event"] == "birth").to_numpy()
    births = events[(events["species"] == species) & (events["event"] == "birth")]
    descent = descent_of(births)
    descent["z"] = descent["share"] * descent["parent"].where(descent["parent"].isin(births["id"])).map(z)
    means = descent.groupby("id")["z"].sum().where(~descent["z"].isna().groupby(descent["id"]).any())
    its_z, parent_z = of["id"].map(z).to_numpy(float), of["id"].map(means).where(is_birth).to_numpy(float)
    time_s, cause, step = of["time_s"].to_numpy(float), of["cause"].to_numpy(), numpy.where(is_birth, 1, -1)
    place = of["id"].map({one: number for number, one in enumerate(of["id"][is_birth])}).to_numpy(int)
    event_of = pandas.Series(numpy.flatnonzero(is_birth), of["id"][is_birth])
    parents = descent[descent["id"].isin(of["id"][is_birth & ~numpy.isnan(parent_z)])]
    choices = [
        *(
            (event, place[event], numpy.ones(len(event)))
            for one in sorted(set(cause[~is_birth]))
            for event in [numpy.flatnonzero(~is_birth & (cause == one))]
        ),
        (
            event_of[parents["id"]].to_numpy(int),
            parents["parent"].map(dict(zip(of["id"], place))).to_numpy(int),
            parents["share"].to_numpy(float),
        ),
    ]
    is_inherited = ~numpy.isnan(parent_z[is_birth])
    origin = its_z[0] if len(of) else 0.0  # means of a trait that does not vary are exact
    expected = expected_of(step, place, time_s, is_inherited.astype(int), its_z[is_birth] - origin, choices)
    parts, mean = price(step, its_z, parent_z, expected + origin)
    founds = (
        is_birth & (of["tick"] == events["tick"].iloc[0]).to_numpy() | numpy.isnan(parts[0]) if len(of) else is_birth
    )
    third = numpy.minimum(2, (3.0 * time_s / end_s).astype(int))
    lives = pandas.DataFrame(
        {"z": its_z[is_birth], "birth_s": time_s[is_birth], "third": third[is_birth], "parent_z": parent_z[is_birth]},
        index=of["id"][is_birth],
    )
    deaths = of[~is_birth].set_index("id")["time_s"]
    lives["life_s"] = deaths.reindex(lives.index).fillna(end_s) - lives["birth_s"]
    lives["offspring"] = descent.groupby("parent")["share"].sum().reindex(lives.index).fillna(0.0)
    found: dict[tuple[str, str], float] = {}
    for number, period in enumerate(PERIODS):
        first, last = (0, 2) if period == "all" else (number - 1, number - 1)
        is_in = ~founds & (third >= first) & (third <= last)
        start, end = (
            mean[numpy.flatnonzero(founds | before)[-1]] if len(of) else numpy.nan
            for before in (third < first, third <= last)
        )
        values = {"start": start, "end": end, "change": end - start, **dict(zip(KINDS, parts[:, is_in].sum(axis=1)))}
        values |= {f"survival_{one}": parts[0, is_in & (cause == one)].sum() for one in sorted(set(cause[~is_birth]))}
        values |= _of_lives(lives[(lives["third"] >= first) & (lives["third"] <= last)])
        found |= {(term, period): float(value) for term, value in values.items()}
    return found


def _of_lives(lives: pandas.DataFrame) -> dict[str, float]:
    z, parent_z = lives["z"].to_numpy(), lives["parent_z"].to_numpy()
    mean = z.mean() if len(z) else numpy.nan
    by_length, by_offspring = (
        float(ratio(numpy.array([(weights * z).sum()]), numpy.array([weights.sum()]))[0])
        for weights in (lives["life_s"].to_numpy(), lives["offspring"].to_numpy())
    )
    child, parent = z[~numpy.isnan(parent_z)], parent_z[~numpy.isnan(parent_z)]
    varies = len(parent) > 2 and parent.std() > 1e-12 * numpy.abs(parent).max()
    slope = float(numpy.cov(parent, child)[0, 1] / parent.var(ddof=1)) if varies else numpy.nan
    return {
        "lives": by_offspring - mean,
        "lives_length": by_length - mean,
        "lives_rate": by_offspring - by_length,
        "offspring_on_parent": slope,
        "mutation_a_birth": (child - parent).mean() if len(child) else numpy.nan,
    }


def measure(texts: Sequence[str], run: PooledRun) -> pandas.Series:
    """The terms of all traits and species of a run, by (trait, species, term, period), and the term missing: the individuals without the trait."""
    verify(run.path)
    events, found = events_of(run), dict[tuple, float]()
    end_s = run.lived_s
    for trait in map(trait_of, texts):
        z = trait.read(run).drop(
            events["id"][trait.is_behaviour & (events["cause"] == "diverged")], errors="ignore"
        )  # no behaviour
        for species in run.web.species:
            found |= {(trait.name, species, *key): value for key, value in terms(events, z, species, end_s).items()}
            born = events["id"][(events["event"] == "birth") & (events["species"] == species)]
            found[trait.name, species, "missing", "all"] = float((~born.isin(z.index)).sum())
    return pandas.Series(found)


# The table


def table(texts: Sequence[str], sets: Mapping[str, pandas.DataFrame]) -> pandas.DataFrame:
    """selection.csv. `sets`: of runs, shadow and neutral those that there are, a row of `measure` a run. The term of a cause is 0 in a run
    without such deaths."""
    rows, differences = [], []
    for trait in map(trait_of, texts):
        of_trait = {name: of[trait.name] for name, of in sets.items()}
        keys = [key for of in of_trait.values() for key in of]
        for species in dict.fromkeys(key[0] for key in keys):
            order = list(dict.fromkeys(term for name, term, _ in keys if name == species and term != "missing"))
            order.sort(
                key=lambda term: (term != "start", term != "end", term != "change", not term.startswith("survival"))
            )
            for term, period in [(term, period) for term in order for period in PERIODS]:
                values = {name: _values(of_trait.get(name), species, term, period) for name in _SETS}
                unit = "1" if term == "offspring_on_parent" else trait.unit
                row = {
                    "trait": trait.name,
                    "species": species,
                    "term": term,
                    "period": period,
                    "unit": unit,
                    "missing": int(of_trait["runs"][species, "missing", "all"].sum()),
                }
                for name in _SETS:
                    n, mean, _, interval = statistics.estimate(values[name])
                    row |= {
                        f"{name}_{part}": value
                        for part, value in zip(("n", "mean", "lower", "upper"), (n, mean, *(interval or (None, None))))
                    }
                tested = statistics.Difference()
                if term in TESTED and period == "all" and row["neutral_n"] and row["runs_n"]:
                    row["null"] = NEUTRAL
                    against = statistics.contrast((1.0, values["runs"]), (-1.0, values["neutral"]))
                    tested = statistics.difference_of(row["runs_mean"] - row["neutral_mean"], against)
                    differences.append(tested)
                rows.append((row, tested))
    statistics.adjust_together(differences)
    for row, tested in rows:
        (lower, upper), at_once = tested.interval or (None, None), tested.corrected or (None, None)
        row |= {
            "difference": tested.value,
            "difference_lower": lower,
            "difference_upper": upper,
            "p": tested.p,
            "p_holm": tested.adjusted,
            "lower_corrected": at_once[0],
            "upper_corrected": at_once[1],
        }
    frame = pandas.DataFrame([row for row, _ in rows], columns=names("selection.csv"))
    texts_of = ("trait", "species", "term", "period", "unit", "null")
    return frame.astype(
        {name: float for name in frame.columns.difference(texts_of) if frame[name].dtype == object}
    ).fillna({"null": ""})


def _values(of: pandas.DataFrame | None, species: str, term: str, period: str) -> numpy.ndarray:
    if of is None:
        return numpy.empty(0)
    key = (species, term, period)
    values = of[key].to_numpy(float) if key in of else numpy.full(len(of), numpy.nan)
    return numpy.nan_to_num(values) if term.startswith("survival_") else values


_HEADS = {
    "start": "mean at the start",
    "end": "mean at the end",
    "change": "change, the sum of:",
    "survival": "  viability selection (survival)",
    "parenthood": "  fecundity selection (parenthood)",
    "lives": "over lives: cov(w, z) / mean w",
    "lives_length": "  by length of life",
    "lives_rate": "  by offspring per second",
    "offspring_on_parent": "slope of offspring on parent",
    "mutation_a_birth": "mutation per birth",
}

_SELECTION = {"survival": "viability selection", "parenthood": "fecundity selection"}


def text(frame: pandas.DataFrame) -> str:
    """The terminal's table of each trait and species, and a sentence about each."""
    lines, said = [], ""

    def cell(reading: Reading, row: pandas.Series, name: str) -> str:
        if not row[f"{name}_n"]:
            return "-"
        return reading.with_interval(row[f"{name}_mean"], (row[f"{name}_lower"], row[f"{name}_upper"]), True)

    for (trait, species), of in frame.groupby(["trait", "species"], sort=False):
        lines.append(
            [f"{species}, {trait}", "whole run [95 %]", "first third", "second", "last", "shadow", "neutral null", "p"]
        )
        for term, rows in of.groupby("term", sort=False):
            head = _HEADS.get(term, f"    {term.split('_')[1]}" if "_" in term else f"  {term}")
            row, reading = rows.iloc[0], Reading(Metric(trait, species, "all", rows.iloc[0]["unit"]))
            runs, shadow, neutral = (cell(reading, row, name) for name in _SETS)
            thirds = [reading(value, True) for value in rows["runs_mean"].iloc[1:]]
            lines.append([f"  {head}", runs, *thirds, shadow, neutral, p_text(row["p_holm"])])
        said += _sentence(of)
    tested = int(frame["p"].notna().sum())
    about = (
        f"p values and sentences: relative to the neutral null, corrected for {tested} comparisons (Holm), with simultaneous intervals (Bonferroni)\n"
        if tested
        else "no neutral null (--neutral makes one): terms are described, not tested; a difference from zero does not show selection\n"
        if not frame["neutral_n"].any()
        else f"fewer than {statistics.MIN_RUNS_FOR_TEST} runs: no intervals and no tests\n"
    )
    if any(trait_of(one).is_behaviour for one in frame["trait"].unique()):
        about += "behavioural traits include luck, so selection on them need not be on inherited differences; the slope of offspring on parent shows how much is inherited\n"
    return columns(lines) + said + about


def _sentence(of: pandas.DataFrame) -> str:
    first = of.iloc[0]
    reading, words = (Reading(Metric(first["trait"], first["species"], "all", first["unit"])), [])
    for row in of[of["p_holm"].notna()].itertuples():
        amount = reading.with_interval(row.difference, (row.lower_corrected, row.upper_corrected), True)
        does = (
            ("raises it," if row.difference > 0 else "lowers it,")
            if statistics.is_significant(row.p_holm)
            else "has no significant effect,"
        )
        words.append(f"{_SELECTION.get(row.term, row.term)} {does} {amount}")
    left = f"{first['missing']} individuals in the runs lack it and are omitted. " if first["missing"] else ""
    unit = f", {reading.unit}" if reading.unit else ""
    return (
        f"{first['species']}, {first['trait']}{unit}: {left}{'; '.join(words) or 'not tested'}\n"
        if words or left
        else ""
    )


# The command


def read_sets(
    paths: Sequence[str | os.PathLike], shadow: str | os.PathLike | None, how: Measuring
) -> tuple[dict[str, list[PooledRun]], list[str]]:
    """The runs of some folders, their shadow and their neutral null, as far as they are there, and remarks. Raises RunError for runs that may not
    be pooled and for a shadow or a neutral null that is not one."""
    runs, nulls = pool.pooled_sets(paths, shadow, how)
    sets = {"runs": runs, **nulls}
    return {name: of for name, (of, _) in sets.items()}, [remark for _, remarks in sets.values() for remark in remarks]


def analyse(
    paths: Sequence[str | os.PathLike],
    texts: Sequence[str],
    shadow: str | os.PathLike | None = None,
    how: Measuring | None = None,
) -> tuple[pandas.DataFrame, dict[str, list[PooledRun]], list[str]]:
    """selection.csv of some runs, the runs and remarks. `texts`: traits, as trait_of reads them. Raises RunError, naming what is wrong."""
    how = how or Measuring()
    for each in texts:
        trait_of(each)
    sets, remarks = read_sets(paths, shadow, how)
    every = [run for of in sets.values() for run in of]
    jobs = how.jobs or len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else how.jobs or 1
    with concurrent.futures.ProcessPoolExecutor(min(jobs, len(every)), multiprocessing.get_context("fork")) as executor:
        rows = iter(list(executor.map(functools.partial(measure, texts), every, chunksize=4)))
    return (
        table(texts, {name: pandas.concat([next(rows) for _ in of], axis=1).T for name, of in sets.items()}),
        sets,
        remarks,
    )


def run(request: Mapping[str, Any]) -> int:
    """The command. Raises RunError before any work for a trait that cannot be and for a folder that exists."""
    how = Measuring(
        until_s=request.get("until"),
        accept_other_build=bool(request.get("accept_other_build")),
        jobs=request.get("jobs"),
    )
    with result_folder(request.get("out")) as folder:
        frame, sets, remarks = analyse(request["runs"], request["selection"], request.get("shadow"), how)
        write_new(folder / "selection.csv", csv_text(frame))
    for what in remarks:
        remark(request["who"], what)
    for name, of in sets.items():
        said = describe(MeasuredSet("", list(of), [], until_s=of[0].until_s))
        length = said.length()
        print(f"{printable(name)}: {said.label} on {said.engine}, {length[0].lower()}{length[1:]}")
    print(text(frame) + f"files   {printable(str(folder.with_suffix('')))}/selection.csv")
    return 0
