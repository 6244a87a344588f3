# SPDX-License-Identifier: MIT
"""Is it open-ended? Complexity of brains and activity of types in runs of growing_race, each over the neutral null of the same run, and what they say of
Channon's two by two: space to grow, and limits of brain and body.

A curve is a row with set (the cell), run, null (empty for the runs), metric, species, time_s and value. Values of single runs come from curves."""
import data_rows
import numpy
import pandas
import ponds
from trophic import metrics, selection, statistics
from trophic.metrics import drift, forests

LOW_LIMITS = ["rules.brain.most_hidden=3", "rules.traits.walking_pace.most=1.25"]
CELLS = {
    "small space, low limits": ponds.SPACE + LOW_LIMITS,
    "small space, high limits": ponds.SPACE,
    "large space, low limits": LOW_LIMITS,
    "large space, high limits": [],
}
"""Parameters of growing_race."""
BOTH = "large space, high limits"
TWO_FOODS = "large space, high limits, two foods"
"""The fifth cell: BOTH in growing_race_two_foods, where prey inherit their diet."""
SIGNS = dict(zip(CELLS, (1.0, -1.0, -1.0, 1.0)))
"""Of the interaction: what both do together beyond what each does alone."""
SPECIES = ("prey", "predator")
TESTED = ("links", "most_links", "new_types")
DESCRIBED = ("hidden", "pace")
SPECIALISTS = "specialists"
"""Share of prey whose diet is within SPECIALISED of one food."""
SPECIALISED = 0.2
STRUCTURE = ("links", "most_links", *DESCRIBED, SPECIALISTS)
KINDS = {
    (SPECIALISTS, "prey", "level"): "neutral",
    ("kinds_silhouette", "prey", "late"): "same_parents",
    ("kinds_gene_flow", "prey", "late"): "same_parents",
}
"""What tells kinds of diets, and its null; clusters and the gene flow between them are those of trophic.metrics.kinds."""
GROUPS = ("level", "slope")
PAIRS = [(metric, species) for metric in TESTED for species in SPECIES]
MUST_GROW = ("links", "most_links")
"""Measures that also must grow in the run itself, as the null may fall."""
STEPS = 60
"""Times of a run at which the living are measured, besides its start."""
MOST_INPUTS = 12
"""Of a species, by which types of genomes are compared."""
OUTPUTS = 2


def links_in_use(genes, inputs, outputs=OUTPUTS):
    """The links and hidden neurons of a GrowingBrain's genes that lie on a path from an input to an output: the others decide nothing."""
    count, hidden = len(genes) // 3, int(genes[0])
    ends = numpy.asarray(genes[1 : 1 + 2 * count], int).tolist()
    links = list(zip(ends[::2], ends[1::2]))
    before = [True] * inputs + [False] * (hidden + outputs)  # reached from an input
    after = [False] * (inputs + hidden) + [True] * outputs
    for start, end in links:  # they ascend by end
        before[end] |= before[start]
    for start, end in sorted(links, reverse=True):
        after[start] |= after[end]
    used = sum(before[start] and after[end] for start, end in links)
    return used, sum(before[one] and after[one] for one in range(inputs, inputs + hidden))


class Lives:
    """Who lived in a run at its times, with genomes."""

    def __init__(self, run):
        table = pandas.read_csv(
            run.path / "phylogeny.csv", usecols=["id", "ancestor_id", "origin_time", "destruction_time", "species"]
        ).sort_values("id")
        self.times_s = run.reached_s / STEPS * numpy.arange(STEPS + 1)
        self.born_s, self.died_s = table["origin_time"].to_numpy(float), table["destruction_time"].to_numpy(float)
        self.species, self.ids = table["species"].to_numpy(str), table["id"].to_numpy()
        of_id = dict(zip(self.ids.tolist(), self.born_s.tolist()))
        parents_s = numpy.array([of_id[one] for one in table["ancestor_id"].tolist()])
        self.ages_s = numpy.where(table["ancestor_id"] == table["id"], numpy.nan, self.born_s - parents_s)
        first = numpy.searchsorted(self.times_s, self.born_s)
        self.seen = numpy.flatnonzero(first < numpy.searchsorted(self.times_s, self.died_s))
        self.genes = self._genes(run)
        traits = pandas.read_csv(run.path / "genomes.csv").set_index("id").reindex(self.ids[self.seen])
        self.pace = traits["walking_pace"].to_numpy()
        self.has_diets = "diet" in traits
        to_food = 0.5 - (traits["diet"] - 0.5).abs() if self.has_diets else numpy.full(len(self.seen), numpy.nan)
        self.specialised = numpy.where(numpy.isnan(to_food), numpy.nan, to_food <= SPECIALISED)

    def _genes(self, run):
        """Of each individual that is seen."""
        table = pandas.read_csv(run.path / "genes.csv", usecols=["id", "part", "value"], dtype={"part": "category"})
        table = table[table["part"] == "brain"]
        ids, values = table["id"].to_numpy(), table["value"].to_numpy(float)
        starts = numpy.flatnonzero(numpy.diff(ids, prepend=-1))
        of_id = dict(zip(ids[starts].tolist(), numpy.split(values, starts[1:])))
        return [of_id[one] for one in self.ids[self.seen].tolist()]

    def living(self, time_s, species):
        """Which of those that are seen live at a time."""
        own = (self.species == species) & (self.born_s <= time_s) & (self.died_s > time_s)
        return numpy.flatnonzero(own[self.seen])

    def presence(self, types, species):
        """Whether each type lives at each time, as forests.presence."""
        forest = forests.Forest(
            numpy.full(len(self.seen), -1),
            self.born_s[self.seen],
            self.died_s[self.seen],
            self.species[self.seen],
            types,
            numpy.zeros(len(self.seen)),
        )
        return forests.presence(forest, species, self.times_s, int(types.max(initial=0)) + 1)


def structure(lives, inputs):
    """{(metric, species): values at the times of a run}, nan without a living member."""
    of = numpy.array([links_in_use(genes, inputs) for genes in lives.genes], float).reshape(-1, 2)
    found = {(name, side): [] for name in STRUCTURE for side in SPECIES}
    for side in SPECIES:
        for time_s in lives.times_s:
            at = lives.living(time_s, side)
            each = (of[at, 0], of[at, 1], lives.pace[at], lives.specialised[at])
            links, hidden, pace, specialised = each if len(at) else (numpy.array([numpy.nan]),) * len(each)
            for name, value in zip(
                STRUCTURE, (links.mean(), links.max(), hidden.mean(), pace.mean(), specialised.mean())
            ):
                found[name, side].append(value)
    return {key: numpy.array(values) for key, values in found.items()}


def new_types(present, null):
    """How many types so far have lived longer, up to each time, than 95 % of the types of a null ever do."""
    types = max(len(present), len(null))
    present, null = (numpy.pad(each, ((0, types - len(each)), (0, 0))) for each in (present, null))
    return forests.activity(present, [null])[:, 3].cumsum()


def measured(cell, folder, program, met):
    """Curves of the runs in a folder in which both species live to the end, and of their neutral nulls, and values of all runs: whether they persist,
    until when, and the mean age of parents in the last third. `met`: the folder of a run with senses.csv, whose inputs make types.
    """
    inputs = drift.met_inputs(selection.read_sets([met], None, metrics.Measuring())[0]["runs"], MOST_INPUTS)
    sets = selection.read_sets([folder], None, metrics.Measuring())[0]
    curves, values, presence = [], [], []
    for run, neutral in zip(sets["runs"], sets["neutral"]):
        number, persists = ponds.number_of(run), "ended" not in run.manifest["result"]
        lived = {("persists", "all", "all"): float(persists), ("lived_s", "all", "all"): run.reached_s}
        values += [ponds.row_of(cell, number, "", key, value) for key, value in lived.items()]
        if not persists:
            continue
        both = [Lives(each) for each in (run, neutral)]
        species = [run.web.species.index(one) for lives in both for one in lives.species[lives.seen]]
        types = drift.signatures(
            str(program), run, inputs, species, [genes for lives in both for genes in lives.genes]
        )[:, 0]
        of_types = numpy.split(types, [len(both[0].seen)])
        values += kinds_of(cell, number, run, neutral) if both[0].has_diets else []
        for null, lives, its in zip(("", "neutral"), both, of_types):
            found = structure(lives, len(inputs[0][0]))
            known = {key: points for key, points in found.items() if not numpy.isnan(points).all()}
            curves += [(cell, number, null, *key, lives.times_s, points) for key, points in known.items()]
        presence.append(
            (
                number,
                both[0].times_s,
                [[lives.presence(its, side) for side in SPECIES] for lives, its in zip(both, of_types)],
            )
        )
        for side in SPECIES:
            late = (both[0].species == side) & (both[0].born_s > run.reached_s * 2.0 / 3.0)
            values.append(
                ponds.row_of(cell, number, "", ("generation_s", side, "last"), numpy.nanmean(both[0].ages_s[late]))
            )
    for place, (number, times_s, (own, null)) in enumerate(presence):
        other = presence[(place + 1) % len(presence)][2][1]  # the null of the next run, as a null has none of its own
        for name, its, against in (("", own, null), ("neutral", null, other)):
            for side, present, theirs in zip(SPECIES, its, against):
                curves.append((cell, number, name, "new_types", side, times_s, new_types(present, theirs)))
    return curves, values


def kinds_of(cell, number, run, neutral):
    """Rows of a run's clusters of diets among prey and the gene flow between them, of their null, and of the neutral null."""
    found = metrics.kinds.measure_run(run, ["diet"]).rows
    found += [
        (*row[:4], "neutral", *row[5:]) for row in metrics.kinds.measure_run(neutral, ["diet"]).rows if not row[4]
    ]
    unknown = {row[:3] for row in found if row[-1] != row[-1]}
    return [
        ponds.row_of(cell, number, row[4], row[:3], row[-1])
        for row in found
        if row[:3] in KINDS and row[:3] not in unknown
    ]


def ends_of(curves):
    """Rows of values of single runs: the level in the last third, and the slope there, per 1000 s."""
    rows = []
    for cell, number, null, metric, species, times_s, points in curves:
        late = (times_s > times_s[-1] * 2.0 / 3.0) & ~numpy.isnan(points)
        if late.sum() > 2:
            slope = 1000.0 * numpy.polyfit(times_s[late], points[late], 1)[0]
            for group, value in (("level", points[late].mean()), ("slope", slope)):
                rows.append(ponds.row_of(cell, number, null, (metric, species, group), value))
    return rows


def means_of(curves, every=4):
    """Rows of the mean curves over the runs of a cell, at every fourth time."""
    found = {}
    for cell, _, null, metric, species, times_s, points in curves:
        found.setdefault((cell, null, metric, species), []).append((times_s, points))
    return [
        {**dict(zip(("set", "null", "metric", "species"), key)), "time_s": f"{time_s:g}", "value": f"{value:.5g}"}
        for key, of in found.items()
        for time_s, value in list(zip(of[0][0], numpy.nanmean([points for _, points in of], axis=0)))[::every]
    ]


def over_null(values, cell, key, null="neutral"):
    """The values of a cell's runs less those of their nulls, run by run."""
    return values(cell, key) - values(cell, key, null)


def grows(values, cell, pairs=PAIRS, family="slope"):
    """Slopes in the last third, over the neutral null: one family. With p of growth, and the upper bounds a generation."""
    rows = []
    for metric, species in pairs:
        key = (metric, species, "slope")
        ours, less = values(cell, key), over_null(values, cell, key)
        of, own = (statistics.contrast((1.0, each)) for each in (less, ours))
        row = ponds.result(cell, key, family, ours, "neutral", values(cell, key, "neutral"), difference(less, of))
        if of and metric in MUST_GROW:  # both must be above 0
            row["of"].p = max(row["of"].p, statistics.p_value(own) if own.value > 0.0 else 1.0)
        if of and of.value <= 0.0:
            row["of"].p = 1.0
        generation_s = statistics.mean_of(values(cell, ("generation_s", species, "last")))
        row["generation_s"] = data_rows.number(generation_s)
        row["smallest"] = data_rows.number(of and statistics.detectable_difference(of, 0.05 / len(pairs)))
        rows.append(row)
    return ponds.with_tests(rows)


def interacts(values, group):
    """What space and limits do together beyond what each does alone, over the neutral null: one family, or described."""
    return combined(values, group, "interaction", f"interaction of {group}s", SIGNS, group == "level")


def by_foods(values):
    """Slopes over the neutral null with two foods, less those with one: one family."""
    return combined(values, "slope", "two foods less one", "two foods", {TWO_FOODS: 1.0, BOTH: -1.0}, True)


def combined(values, group, name, family, signs, is_tested):
    """A weighted sum of cells over the neutral null, for each measure of both species."""
    rows = []
    for metric, species in PAIRS:
        key = (metric, species, group)
        of = statistics.contrast(*((sign, over_null(values, cell, key)) for cell, sign in signs.items()))
        row = ponds.result(name, key, family, of=difference([], of))
        row["generation_s"], row["smallest"] = "", data_rows.number(
            of and statistics.detectable_difference(of, 0.05 / len(PAIRS))
        )
        rows.append(row)
    return ponds.with_tests(rows, is_tested)


def difference(values, of):
    scatter = statistics.scatter_of(values) if len(values) else None
    return statistics.difference_of(of.value if of else None, of, scatter)


def over(values, cell, key, family, null):
    less = over_null(values, cell, key, null)
    of = difference(less, statistics.contrast((1.0, less)))
    return ponds.result(cell, key, family, values(cell, key), null, values(cell, key, null), of)


def diverges(values):
    """Specialists, clusters of diets and gene flow between them in the cell with two foods, over their nulls: one family."""
    rows = ponds.with_tests([over(values, TWO_FOODS, key, "kinds of diet", null) for key, null in KINDS.items()])
    others = [
        over(values, TWO_FOODS, key, "kinds of diet", "neutral") for key, null in KINDS.items() if null != "neutral"
    ]
    return [row | {"generation_s": "", "smallest": ""} for row in [*rows, *ponds.with_tests(others, are_tested=False)]]


def described(values):
    """Levels and slopes in each cell over the null, and the shares of runs in which both species live to the end."""
    rows = []
    for cell in (*CELLS, TWO_FOODS):
        if not len(persists := values(cell, ("persists", "all", "all"))):
            continue
        rows.append(ponds.result(cell, ("persists", "all", "all"), "described", persists))
        told = [(name, species, group) for name in (*TESTED, *DESCRIBED) for species in SPECIES for group in GROUPS]
        rows += [over(values, cell, key, "described", "neutral") for key in told]
    return [row | {"generation_s": "", "smallest": ""} for row in ponds.with_tests(rows, False)]


def results(rows):
    values = ponds.Values(rows)
    cells = [*grows(values, BOTH), *interacts(values, "level"), *interacts(values, "slope"), *by_foods(values)]
    return [*cells, *results_of_foods(values), *described(values)]


def results_of_foods(values):
    return [*grows(values, TWO_FOODS, family="slope with two foods"), *diverges(values)]
