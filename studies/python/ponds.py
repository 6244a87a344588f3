# SPDX-License-Identifier: MIT
"""Four worlds of the pond: which condition of births and of protection does what. Rows of results from the values of single runs, and of analyses of the pond's other settings.

A value is a row with set (the world), run, null (empty for the runs), metric, species, group and value, as results/data/no_criterion_runs.csv has it."""
import data_rows
import numpy
import pandas
from trophic import metrics, selection, statistics
from trophic.values import one_sided_name

SPACE = [
    "ecology.robots=150",
    "rules.community.predators=12",
    "rules.recruitment.spare_bodies=90",
    "rules.resource.cells_in_a_row=20",
]
"""The numbers of `pond` in a table derived from pond_race, which has four times of all."""
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
ACTIVITY = [(name, "prey", "all") for name in ("inactive_share", "inactive_s")]
TERMS = ("survival", "parenthood")


def activity_of(run):
    """Of the prey of a run: the share of its rows that are inactive, and how long newborn are inactive on average."""
    agents = pandas.read_csv(run / "agents.csv", usecols=["time_s", "id", "species", "active"])
    prey = agents[agents["species"] == "prey"]
    events = pandas.read_csv(run / "events.csv", usecols=["time_s", "event", "id", "species"])
    born = events[(events["event"] == "birth") & (events["species"] == "prey") & (events["time_s"] > 0.0)]
    step_s = numpy.diff(agents["time_s"].unique()).min()
    waits = prey[prey["active"] == 0].groupby("id").size().reindex(born["id"], fill_value=0) * step_s
    return {key: float(value) for key, value in zip(ACTIVITY, (1.0 - prey["active"].mean(), waits.mean()))}


def lives_of(run):
    """Whether both species live to the end of a run, and when each that does not is gone."""
    energy = pandas.read_csv(run / "energy.csv", usecols=["time_s", "species", "individuals"])
    gone_s = energy[energy["individuals"] == 0].groupby("species")["time_s"].min()
    ends = {("extinct_at", species, "all"): float(time_s) for species, time_s in gone_s.items()}
    return {("persists", "all", "all"): float(not ends), **ends}


def velocities_of(run):
    """The metric velocity of all groups that are tested or described, m/s."""
    agents = metrics.Agents(run.load("agents.csv", metrics.AGENTS, []), run.web)
    samples = metrics.velocity.samples(agents)
    keys = [*TESTED.values(), *DESCRIBED]
    return {key: metrics.velocity.velocity(samples, agents, *key[1:]).mean for key in keys}


def number_of(run):
    return run.path.name.removeprefix("replicate-")


def row_of(world, run, null, key, value):
    of = {"set": world, "run": run, "null": null, **dict(zip(("metric", "species", "group"), key))}
    return {**of, "value": f"{value:.5g}"}


def values_of(world, folder):
    """The values of each run in a folder, and of those of its shadow and its one-sided worlds."""
    rows = []
    for name, runs in selection.read_sets([folder], None, metrics.Measuring())[0].items():
        null = "" if name == "runs" else name
        for run in runs if null != "neutral" else ():
            found = lives_of(run.path) | velocities_of(run) | (activity_of(run.path) if not null else {})
            kept = {key: value for key, value in found.items() if null in nulls_of(key) and value == value}
            rows += [row_of(world, number_of(run), null, key, value) for key, value in kept.items()]
    return rows


def term_values(world, folder):
    """Price's terms of turns_to in each run in a folder and of its neutral null."""
    sets, rows = selection.read_sets([folder], None, metrics.Measuring())[0], []
    for null, name in (("", "runs"), ("neutral", "neutral")):
        for run in sets[name]:
            terms = selection.measure(["turns_to"], run)
            for key in (("turns_to", species, term) for species in TESTED for term in TERMS):
                if (value := terms[(*key, "all")]) == value:
                    rows.append(row_of(world, number_of(run), null, key, value))
    return rows


class Values:
    """The values of single runs, by world, null and metric."""

    def __init__(self, rows):
        self.of = {}
        for row in rows:
            key = tuple(row[name] for name in ("set", "null", "metric", "species", "group"))
            self.of.setdefault(key, {})[row["run"]] = float(row["value"])

    def __call__(self, world, key, null=""):
        of = self.of.get((world, null, *key), {})
        return numpy.array([of[run] for run in sorted(of)])

    def lives(self, world, end_s):
        """How long both species live in each run of a world, censored at the end."""
        ends = [self.of.get((world, "", "extinct_at", species, "all"), {}) for species in TESTED]
        runs = sorted(self.of[world, "", "persists", "all", "all"])
        first = numpy.array([min(of.get(run, end_s) for of in ends) for run in runs])
        return statistics.Lives(first, first < end_s, end_s)


def result(world, key, family, values=(), null="", others=(), of=None):
    """A row of results: the mean of a world's runs, that of a null, and their difference `of`, of which with_tests makes columns."""
    ours, theirs = statistics.estimate(values), statistics.estimate(others)
    interval = statistics.share_interval(values) if key[0] == "persists" else ours.interval
    return {
        "set": world,
        **dict(zip(("metric", "species", "group"), key)),
        "family": family,
        "runs": str(ours.runs or ""),
        "mean": data_rows.number(ours.mean),
        **dict(zip(("lower", "upper"), map(data_rows.number, interval or (None, None)))),
        "null": null,
        "null_runs": str(theirs.runs or ""),
        "null_mean": data_rows.number(theirs.mean),
        "of": of or statistics.Difference(),
    }


def with_tests(rows, are_tested=True):
    """The rows of a family with their differences and intervals and, if they are tested, p, p corrected for the family (Holm), and the intervals
    that hold for all of it at once (Bonferroni)."""
    if are_tested:
        statistics.adjust_together(row["of"] for row in rows)
    for row in rows:
        of = row.pop("of")
        together = of.corrected or (None, None)
        row["difference"] = data_rows.number(of.value)
        for name, bounds in (("difference", of.interval or (None, None)), ("together", together)):
            row |= dict(zip((f"{name}_lower", f"{name}_upper"), map(data_rows.number, bounds)))
        row["p"], row["p_holm"] = map(data_rows.number, (of.p, of.adjusted) if are_tested else (None, None))
    return rows


def difference(*terms):
    of = statistics.contrast(*terms)
    return statistics.difference_of(of.value if of else None, of)


def one_sided(key):
    """The null in which the species of a key inherits nothing."""
    return one_sided_name(key[1])


def nulls_of(key):
    """The nulls whose runs are kept beside a key's."""
    return ("", "shadow", *(map(one_sided, TESTED.values()) if key[1] == "all" else [one_sided(key)]))


def over(values, world, key, family, null):
    ours, theirs = values(world, key), values(world, key, null)
    return result(world, key, family, ours, null, theirs, difference((1.0, ours), (-1.0, theirs)))


def evolved(values, worlds=tuple(WORLDS)):
    """Velocities over the one-sided world of their species: one family."""
    return with_tests(
        [over(values, world, key, "behaviour", one_sided(key)) for world in worlds for key in TESTED.values()]
    )


def contrasted(values):
    """What evolves in prey, compared between worlds that differ in one condition: one family."""
    key, rows = TESTED["prey"], []
    for name, worlds in CONTRASTS.items():
        terms = [
            (sign * side, values(world, key, null))
            for sign, world in zip((1.0, -1.0), worlds)
            for side, null in ((1.0, ""), (-1.0, one_sided(key)))
        ]
        rows.append(result(name, key, "contrast", of=difference(*terms)))
    return with_tests(rows)


def survived(values, end_s):
    """How long both species live (restricted mean), compared between those worlds by the log-rank test: one family."""
    return with_tests(
        [
            result(
                name,
                ("lived", "all", "all"),
                "survival",
                of=statistics.survival_difference(*(values.lives(world, end_s) for world in worlds)),
            )
            for name, worlds in CONTRASTS.items()
        ]
    )


def selected(values):
    """Price's terms of turns_to over the neutral null: one family."""
    keys = [("turns_to", species, term) for species in TESTED for term in TERMS]
    return with_tests([over(values, world, key, "selection", "neutral") for world in WORLDS for key in keys])


def described(values):
    """Persistence, activity, and velocities that are not tested."""
    rows = []
    for world in WORLDS:
        for key in (("persists", "all", "all"), *ACTIVITY):
            rows.append(result(world, key, "described", values(world, key)))
        rows += [over(values, world, key, "described", one_sided(key)) for key in DESCRIBED]
        rows += [over(values, world, key, "described", "shadow") for key in TESTED.values()]
    return with_tests([row for row in rows if row["runs"]], are_tested=False)


def results(rows, end_s):
    """The rows of no_criterion.csv."""
    values = Values(rows)
    return [*evolved(values), *contrasted(values), *survived(values, end_s), *described(values)]


def persisting(table):
    """The names of the runs in which every species lives to the end."""
    return [
        row["run"]
        for row in data_rows.read(table)
        if (row["metric"], row["species"], row["baseline"], row["time_s"], row["value"])
        == ("persists", "all", "", "", "1")
    ]


LIVING = {
    "persists",
    "velocity",
    "generation_time",
    "lineage_depth",
    "pyramid_numbers",
    "cycles",
    "period",
    "phase",
    "search_rate_holling",
    "handling_time",
    "trophic_efficiency",
}


def living_rows(name, summary):
    """Measures of a world whose numbers change, with those of its nulls; p of the two velocities is corrected for them alone (Holm)."""
    rows = []
    for metric in summary["sets"][0]["metrics"]:
        if metric["metric"] not in LIVING or metric["metric"] == "velocity" and metric["group"] != "inherited":
            continue
        nulls = {null["name"]: null for null in metric["baselines"]}
        shadow = nulls.get("shadow", {})
        rows.append(
            {
                "set": name,
                "metric": metric["metric"],
                "species": metric["species"],
                "unit": metric["unit"],
                "runs": metric["runs"],
                **{key: data_rows.number(metric[key]) for key in ("mean", "lower", "upper")},
                **{
                    null: data_rows.number(nulls.get(null, {}).get("value"))
                    for null in ("shadow", "clones", "mean_field")
                },
                **{key: data_rows.number(shadow.get(key)) for key in ("difference", "p")},
                **{f"difference_{key}": data_rows.number(shadow.get(key)) for key in ("lower", "upper")},
                "p_holm": "",
            }
        )
    tested = [row for row in rows if row["metric"] == "velocity" and row["p"]]
    for row, p in zip(tested, statistics.holm([float(row["p"]) for row in tested])):
        row["p_holm"] = data_rows.number(p)
    return rows


def atlas_rows(analysis):
    """Persistence and velocities over the shadow in each cell of a sweep, with its two settings."""
    cells = {
        row["cell"]: {"reach_m": row["rules.capture.reach_m"], "growth_1_s": row["rules.resource.growth_1_s"]}
        for row in data_rows.read(analysis / "cells.csv")
    }
    keys = (
        "metric",
        "species",
        "unit",
        "runs",
        "mean",
        "lower",
        "upper",
        "shadow",
        "over_shadow",
        "over_lower",
        "over_upper",
    )
    return [
        {**cells[row["cell"]], **{key: row[key] for key in keys}}
        for row in data_rows.read(analysis / "sweep_metrics.csv")
        if (row["metric"], row["group"]) in (("persists", "all"), ("velocity", "inherited"))
    ]
