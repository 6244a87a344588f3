# SPDX-License-Identifier: MIT
"""Four worlds of the pond: which condition of births and of protection does what. Rows of results from the values of single runs.

A value is a row with set (the world), seed, null (empty for the runs), metric, species, group and value, as results/data/no_criterion_runs.csv has it."""
import json

import designs
import numpy
import pandas
from trophic import selection, statistics

WORLDS = {
    "as shipped": ["pond"],
    "the inactive breed": ["pond", "rules.recruitment.only_active=false"],
    "none inactive": ["pond", "rules.recruitment.only_active=false", "rules.activation.distance_m=0"],
    "protected by age": [
        "pond_with_conditions",
        "rules.recruitment.energy.only_active=false",
        "rules.activation.distance_m=0",
        "rules.activation.min_age_s=200",
    ],
}
"""Rule table and parameters."""
AS_SHIPPED, INACTIVE_BREED, NONE_INACTIVE, BY_AGE = WORLDS
CONTRASTS = {
    "only the active breed": (AS_SHIPPED, INACTIVE_BREED),
    "protection by age, not distance": (BY_AGE, INACTIVE_BREED),
    "no protection": (NONE_INACTIVE, BY_AGE),
}
"""Worlds that differ in one condition: the first less the second."""
TESTED = {"prey": ("velocity", "prey", "inherited_active"), "predator": ("velocity", "predator", "inherited")}
DESCRIBED = [("velocity", "prey", "inherited_inactive"), ("velocity", "prey", "inherited")]
MEASURED = [
    *TESTED.values(),
    *DESCRIBED,
    ("persists", "all", "all"),
    ("extinct_at", "prey", "all"),
    ("extinct_at", "predator", "all"),
]
ACTIVITY = [(name, "prey", "all") for name in ("inactive_share", "inactive_s", "born_of_inactive")]
TERMS = ("survival", "parenthood")


def folder_of(world):
    return "no-criterion/" + world.replace(" ", "-")


def activity_of(run):
    """Of the prey of a run: the share of its rows that are inactive, how long newborn are inactive on average, and the share of them whose parent was
    inactive in its last row before the birth."""
    agents = pandas.read_csv(run / "agents.csv", usecols=["time_s", "id", "species", "active"])
    prey = agents[agents["species"] == "prey"]
    events = pandas.read_csv(run / "events.csv", usecols=["time_s", "event", "id", "species", "parent_id"])
    born = events[(events["event"] == "birth") & (events["species"] == "prey") & (events["time_s"] > 0.0)]
    step_s = numpy.diff(agents["time_s"].unique()).min()
    waits = prey[prey["active"] == 0].groupby("id").size().reindex(born["id"], fill_value=0) * step_s
    births = born.dropna(subset="parent_id").astype({"parent_id": "int64"}).sort_values("time_s")
    parents = pandas.merge_asof(
        births[["time_s", "parent_id"]],
        prey.rename(columns={"id": "parent_id"})[["time_s", "parent_id", "active"]].sort_values("time_s"),
        on="time_s",
        by="parent_id",
    )
    shares = (1.0 - prey["active"].mean(), waits.mean(), 1.0 - parents["active"].mean())
    return {key: float(value) for key, value in zip(ACTIVITY, shares) if value == value}


def seed_of(run):
    return str(json.loads((run / "manifest.json").read_text())["seed"])


def row_of(world, seed, null, key, value):
    return {
        "set": world,
        "seed": seed,
        "null": null,
        **dict(zip(("metric", "species", "group"), key)),
        "value": f"{value:.5g}",
    }


def term_values(world, runs):
    """Price's terms of turns_to in each run of a folder and of its neutral null."""
    rows = []
    for null, folder in (("", runs), ("neutral", runs / "neutral")):
        for run in selection.read_sets([folder], None, selection.Measuring())[0]["runs"]:
            terms = selection.measure(["turns_to"], run)
            for species in TESTED:
                for term in TERMS:
                    value = terms["turns_to", species, term, "all"]
                    if value == value:
                        rows.append(row_of(world, str(run.seed), null, ("turns_to", species, term), value))
    return rows


class Values:
    """The values of single runs, by world, null and metric."""

    def __init__(self, rows):
        self.of = {}
        for row in rows:
            key = tuple(row[name] for name in ("set", "null", "metric", "species", "group"))
            self.of.setdefault(key, {})[row["seed"]] = float(row["value"])

    def __call__(self, world, key, null=""):
        of = self.of.get((world, null, *key), {})
        return numpy.array([of[seed] for seed in sorted(of, key=int)])

    def lives(self, world, end_s):
        """How long both species live in each run of a world, censored at the end."""
        ends = [self.of.get((world, "", "extinct_at", species, "all"), {}) for species in TESTED]
        seeds = sorted(self.of[world, "", "persists", "all", "all"], key=int)
        first = numpy.array([min(of.get(seed, end_s) for of in ends) for seed in seeds])
        return statistics.Lives(first, first < end_s, end_s)


def result(world, key, family, values=(), null="", others=(), of=None):
    """A row of results: the mean of a world's runs, that of a null, and a contrast; p and intervals of a family come later."""
    ours, theirs = statistics.estimate(values), statistics.estimate(others)
    interval = statistics.share_interval(values) if key[0] == "persists" else ours.interval
    return {
        "set": world,
        **dict(zip(("metric", "species", "group"), key)),
        "family": family,
        "runs": ours.runs or "",
        "mean": designs.number(ours.mean),
        **dict(zip(("lower", "upper"), map(designs.number, interval or (None, None)))),
        "null": null,
        "null_runs": theirs.runs or "",
        "null_mean": designs.number(theirs.mean),
        "difference": designs.number(of.value if of else None),
        "of": of,
    }


def with_tests(rows):
    """The rows of a family with their intervals, those that hold for all of it at once (Bonferroni), and p, also corrected (Holm). Each `of` is a
    Contrast, or a Difference with its own p."""
    p_values = [row["of"].p if hasattr(row["of"], "p") else statistics.p_value(row["of"]) for row in rows]
    tested = [p for p in p_values if p is not None]
    adjusted = iter(statistics.holm(tested))
    for row, p in zip(rows, p_values):
        of = row.pop("of")
        for name, level in (("difference", 0.95), ("together", 1.0 - statistics.SIGNIFICANCE / max(1, len(tested)))):
            interval = (
                of.at(level)
                if hasattr(of, "at") and of.at
                else statistics.interval_of(of, level)
                if not hasattr(of, "at")
                else None
            )
            row |= dict(zip((f"{name}_lower", f"{name}_upper"), map(designs.number, interval or (None, None))))
        row |= {"p": designs.number(p), "p_holm": designs.number(None if p is None else float(next(adjusted)))}
    return rows


def over(values, world, key, family, null):
    ours, theirs = values(world, key), values(world, key, null)
    return result(world, key, family, ours, null, theirs, statistics.contrast((1.0, ours), (-1.0, theirs)))


def evolved(values, worlds=tuple(WORLDS)):
    """Velocities over the one-sided world of their species: one family."""
    return with_tests(
        [
            row
            for world in worlds
            for key in TESTED.values()
            if (row := over(values, world, key, "behaviour", "one_sided"))["of"]
        ]
    )


def contrasted(values):
    """What evolves in prey, compared between worlds that differ in one condition: one family."""
    key, rows = TESTED["prey"], []
    for name, (first, second) in CONTRASTS.items():
        terms = [
            (sign * side, values(world, key, null))
            for sign, world in ((1.0, first), (-1.0, second))
            for side, null in ((1.0, ""), (-1.0, "one_sided"))
        ]
        if of := statistics.contrast(*terms):
            rows.append(result(name, key, "contrast", of=of))
    return with_tests(rows)


def survived(values, end_s):
    """How long both species live, compared between those worlds by the log-rank test: one family."""
    key, rows = ("lived", "all", "all"), []
    for name, worlds in CONTRASTS.items():
        if all(len(values(world, ("persists", "all", "all"))) for world in worlds):
            lives = [values.lives(world, end_s) for world in worlds]
            rows.append(result(name, key, "survival", of=statistics.survival_difference(*lives)))
    return with_tests(rows)


def described(values):
    """Persistence, activity and what is not tested."""
    rows = []
    for world in WORLDS:
        for key, null in (
            (("persists", "all", "all"), "shadow"),
            *((key, "one_sided") for key in DESCRIBED),
            *((key, "shadow") for key in TESTED.values()),
            *((key, "") for key in ACTIVITY),
        ):
            ours, theirs = values(world, key), values(world, key, null) if null else ()
            if len(ours):
                row = result(world, key, "described", ours, null, theirs)
                of = row.pop("of") or (
                    statistics.contrast((1.0, ours), (-1.0, theirs)) if len(theirs) and key[0] != "persists" else None
                )
                interval = statistics.interval_of(of) or (None, None)
                empty = dict.fromkeys(("together_lower", "together_upper", "p", "p_holm"), "")
                names = ("difference", "difference_lower", "difference_upper")
                rows.append(row | dict(zip(names, map(designs.number, (of.value if of else None, *interval)))) | empty)
    return rows


def selected(values):
    """Price's terms of turns_to over the neutral null: one family."""
    keys = [("turns_to", species, term) for species in TESTED for term in TERMS]
    return with_tests(
        [row for world in WORLDS for key in keys if (row := over(values, world, key, "selection", "neutral"))["of"]]
    )


def results(rows, end_s):
    """The rows of no_criterion.csv."""
    values = Values(rows)
    return [*evolved(values), *contrasted(values), *survived(values, end_s), *described(values)]
