# SPDX-License-Identifier: MIT
"""Mating zones: the number of zones at which extinction changes to explosion, and which rule makes runs last. Rows of results from single runs.

A row of a run has run, null (empty or "shadow"), outcome, minutes, and how its robots turn and how far they are from the nearest zone, late in the run."""
import json

import data_rows
import numpy
import pandas
from scipy import stats
from trophic import statistics

OUTCOMES = ("extinct", "exploded", "lasted")
RULES = {
    "as published": [],
    "finite food": ["rules.resource.food_W=5"],
    "parents endow": ["rules.metabolism.newborn_J=0"],
    "both": ["rules.resource.food_W=5", "rules.metabolism.newborn_J=0"],
    "both, room for 300": [
        "rules.resource.food_W=5",
        "rules.metabolism.newborn_J=0",
        "ecology.robots=300",
        "rules.recruitment.spare_bodies=270",
    ],
}
"""The published rules, and what each other world changes."""
ON_TORUS = ["backend.speed_m_s=0.0429", "backend.turn_1_s=0.067", "ecology.control_hz=1"]
"""The walk of the robot `spider`, as the backend `kinematic` has it."""
STANDING = ["backend.speed_m_s=0", *ON_TORUS[1:]]
ZONES = [
    ("mean field", 1, (10, 12, 14, 15, 16, 17, 18, 19, 20, 22, 24, 40)),
    ("walking", 1, (3, 4, 5, 6, 8, 10, 15, 25, 40)),
    ("standing", 1, (6, 8, 10, 12, 14, 16, 18, 20, 24)),
    ("mean field", 2, (2, 3, 4, 5, 6, 7, 8, 9, 10, 12)),
    ("walking", 2, (1, 2, 3, 4, 6, 8)),
    ("standing", 2, (2, 3, 4, 5, 6, 8, 12)),
]
"""The numbers of zones, by robots and by the newborns of a pair."""
LASTING = ("both", "both, room for 300")
"""The rules whose runs have a shadow: runs of the others are not expected to last, and are compared with nothing."""
TRIED_RULES = [
    ("both", 1),
    ("as published", 1),
    ("finite food", 1),
    ("parents endow", 1),
    ("both, room for 300", 2),
    ("both", 2),
]
AGAIN = [("both", 1), ("both, room for 300", 2)]
"""Rules and the newborns of a pair, in the first runs and in those that confirm."""
TRIED = (8, 15, 25)
"""The numbers of zones at which each rule is tried."""
LATE_S = 4000
NEEDED = 0.9
"""The share of runs that must last."""


def mean_field(rng, zones, offspring, food_J=0.0, endows=False, side_m=25.0, radius_m=2.0, limit=100, minutes=100):
    """The outcome and the minutes of a run without robots: individuals and zones fall anywhere, uniformly, each minute."""
    energy_J = numpy.full(30, 100.0)
    for minute in range(1, minutes + 1):
        energy_J -= 5.0
        energy_J = energy_J[energy_J > 0.0]
        if len(energy_J) == 0:
            return "extinct", minute
        energy_J = numpy.maximum(energy_J, numpy.minimum(energy_J + food_J / len(energy_J), 100.0))
        at_m, born = rng.uniform(0.0, side_m, (len(energy_J), 2)), []
        single = numpy.ones(len(energy_J), dtype=bool)
        centres_m = rng.uniform(0.0, side_m, (zones, 1, 2))
        ways_m = numpy.abs(at_m - centres_m)
        ways_m = numpy.minimum(ways_m, side_m - ways_m)
        is_inside = (ways_m**2).sum(axis=2) <= radius_m**2
        for zone in numpy.flatnonzero(is_inside.sum(axis=1) > 1):
            inside = numpy.flatnonzero(single & is_inside[zone])
            for pair in zip(inside[::2], inside[1::2]):
                each_J = min(25.0, *energy_J[list(pair)])
                energy_J[list(pair)] -= each_J
                single[list(pair)] = False
                born += [2.0 * each_J / offspring if endows else 100.0] * offspring
        energy_J = numpy.concatenate([energy_J, born])
        if len(energy_J) >= limit:
            return "exploded", minute
    return "lasted", minutes


def counts_of(outcomes):
    outcomes = list(outcomes)
    return {outcome: sum(one == outcome for one in outcomes) for outcome in OUTCOMES}


def value_of(run):
    """The outcome of a run, and what its robots did from 4000 s on."""
    manifest = json.loads((run / "manifest.json").read_text())
    energy = pandas.read_csv(run / "energy.csv", usecols=["time_s", "individuals"])
    last, robots = energy["individuals"].iloc[-1], manifest["params"]["ecology"]["robots"]
    found = {"outcome": "extinct" if last == 0 else "exploded" if last >= robots else "lasted"}
    found["minutes"] = f"{energy['time_s'].iloc[-1] / 60.0:.1f}"
    found |= {"robots": "", "turns": "", "distance_m": ""}
    late = energy[energy["time_s"] >= LATE_S]
    if found["outcome"] == "lasted" and len(late) and (run / "senses.csv").exists():
        senses = pandas.read_csv(run / "senses.csv", usecols=["time_s", "angle_output", "input1", "input2"]).dropna()
        senses = senses[senses["time_s"] >= LATE_S]
        turns = (senses["angle_output"] > 0.0) == (senses["input1"] > 0.0)
        found["robots"] = f"{late['individuals'].mean():.2f}"
        found["turns"] = f"{turns.mean():.4f}"
        found["distance_m"] = f"{senses['input2'].mean() * 12.5:.3f}"
    return found


def values_of(folder):
    """The rows of the runs in a folder and of their shadow."""
    rows = []
    for null, runs in (("", folder), ("shadow", folder / "shadow")):
        for run in sorted(runs.glob("replicate-*")):
            rows.append({"run": run.name.removeprefix("replicate-"), "null": null, **value_of(run)})
    return rows


def profile(critical, zones, exploded, ended):
    """The largest log likelihood at each critical number, if a run that ends among n zones explodes with probability 1 / (1 + (critical / n) ** slope),
    over the slopes."""
    ways = numpy.log(numpy.asarray(zones, dtype=float)) - numpy.log(critical)[:, None]
    best = numpy.full(len(critical), -numpy.inf)
    for slope in numpy.geomspace(0.5, 200.0, 50):
        odds = slope * ways
        best = numpy.maximum(best, (exploded * odds - ended * numpy.logaddexp(0.0, odds)).sum(axis=1))
    return best


def critical(cells):
    """(n_c, lower, upper) of rows with zones, extinct, exploded and lasted: where as many runs explode as die out, by maximum likelihood, with the
    interval of the profile likelihood. If no number of zones has both outcomes, n_c is the middle of the interval. A bootstrap over runs covers less.
    """
    zones = numpy.array([int(row["zones"]) for row in cells])
    extinct, exploded = (numpy.array([int(row[outcome]) for row in cells]) for outcome in OUTCOMES[:2])
    if extinct.sum() == 0 or exploded.sum() == 0:
        return None
    tried = numpy.geomspace(0.5 * zones.min(), 2.0 * zones.max(), 800)
    likelihood = profile(tried, zones, exploded, extinct + exploded)
    best = tried[likelihood >= likelihood.max() - 1e-6]
    inside = tried[likelihood >= likelihood.max() - 0.5 * stats.chi2.ppf(0.95, 1)]
    return float(numpy.sqrt(best[0] * best[-1])), float(inside[0]), float(inside[-1])


def critical_rows(cells):
    """A row per kind of robots, null and newborns of a pair: n_c with its interval."""
    rows = []
    for key in dict.fromkeys((row["robots"], row["offspring"]) for row in cells):
        of = [row for row in cells if (row["robots"], row["offspring"]) == key]
        found = critical(of)
        runs = sum(int(row[outcome]) for row in of for outcome in OUTCOMES)
        lasted = sum(int(row["lasted"]) for row in of)
        numbers = dict(zip(("n_c", "lower", "upper"), map(data_rows.number, found or (None, None, None))))
        rows.append({"robots": key[0], "offspring": key[1], "runs": runs, "lasted": lasted, **numbers})
    return rows


def lasting_without_robots(rule, offspring, zones, runs=100):
    """The share of runs of the mean field that last under a rule."""
    changes = RULES[rule]
    food_J, endows = 300.0 * ("rules.resource.food_W=5" in changes), "rules.metabolism.newborn_J=0" in changes
    limit = 300 if "ecology.robots=300" in changes else 100
    rng = numpy.random.default_rng(1)
    return numpy.mean(
        [mean_field(rng, zones, offspring, food_J, endows, limit=limit)[0] == "lasted" for _ in range(runs)]
    )


def cell_rows(name, rule, offspring, zones, values):
    """What the runs of one world say: outcomes, and the turns and distances of those that last, over their shadow."""
    ours, theirs = ([row for row in values if row["null"] == null] for null in ("", "shadow"))
    row = {"set": name, "rule": rule, "offspring": offspring, "zones": zones, "runs": len(ours)}
    row |= counts_of(one["outcome"] for one in ours)
    row["minutes"] = data_rows.number(numpy.median([float(one["minutes"]) for one in ours]))
    row["shadow_lasted"] = counts_of(one["outcome"] for one in theirs)["lasted"]
    row["mean_field_lasted"] = data_rows.number(lasting_without_robots(rule, offspring, zones))
    row["robots"] = data_rows.number(statistics.mean_of([float(one["robots"]) for one in ours if one["robots"]]))
    for measure in ("turns", "distance_m"):
        ends = [[float(one[measure]) for one in side if one[measure]] for side in (ours, theirs)]
        row[measure] = data_rows.number(statistics.mean_of(ends[0]))
        row[f"{measure}_shadow"] = data_rows.number(statistics.mean_of(ends[1]))
        is_told = min(map(len, ends)) >= 6
        of = statistics.contrast((1.0, ends[0]), (-1.0, ends[1])) if is_told else None
        row[measure + "_of"] = statistics.difference_of(of.value if of else None, of)
    return row


def with_answers(rows):
    """The rows of one family with differences of turns, p corrected by Holm, and whether enough runs last with progress; distances are described."""
    statistics.adjust_together(row["turns_of"] for row in rows if row["turns_of"].value is not None)
    for row in rows:
        for measure in ("turns", "distance_m"):
            of = row.pop(measure + "_of")
            row[f"{measure}_difference"] = data_rows.number(of.value)
            bounds = zip(("lower", "upper"), map(data_rows.number, of.interval or (None, None)))
            row |= {f"{measure}_{name}": bound for name, bound in bounds}
            if measure == "turns":
                row["p"], row["p_holm"] = data_rows.number(of.p), data_rows.number(of.adjusted)
                progress = of.value is not None and of.value > 0.0 and of.adjusted is not None and of.adjusted <= 0.05
        lasts = row["lasted"] >= NEEDED * row["runs"]
        row["answer"] = "yes" if lasts and progress else "lasts, no progress shown" if lasts else "no"
    return rows
