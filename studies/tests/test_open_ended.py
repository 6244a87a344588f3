# SPDX-License-Identifier: MIT
"""Links in use, new types, growth over the null and the interaction of space and limits, from hand-written brains, lives and values."""
import pathlib
import types

import numpy
import open_ended
from page_tables import open_ended as tables
import pandas
import ponds
import pytest
from scipy import stats

RUNS = [f"{run:02}" for run in range(10)]


def test_links_in_use_lie_on_a_path_from_an_input_to_an_output():
    # inputs 0 and 1, hidden 2 and 3, outputs 4 and 5: 0-2, 2-4 decide; 1-3 leads nowhere; 3 has no further link
    genes = [2, 0, 2, 1, 3, 2, 4, 0.1, 0.2, 0.3]
    assert open_ended.links_in_use(genes, 2) == (2, 1)
    assert open_ended.links_in_use([2, 0, 2, 1, 3, 2, 4, 3, 5, 1, 1, 1, 1], 2) == (4, 2)
    assert open_ended.links_in_use([1, 2, 3, 1.0], 2, 1) == (0, 0)  # from a neuron without an input
    assert open_ended.links_in_use([0], 2) == (0, 0)
    assert open_ended.links_in_use([0, 0, 2, 1, 3, 0.5, 0.5], 2) == (2, 0)


def test_new_types_outlive_those_of_the_null():
    null = numpy.zeros((40, 20), bool)
    for one in range(40):
        null[one, : 2 + one % 3] = True  # at most four times
    own = numpy.zeros((3, 20), bool)
    own[0, :4] = own[1, 3:9] = own[2, 10:20] = True
    assert open_ended.new_types(own, null).tolist() == [0] * 7 + [1] * 7 + [2] * 6
    assert open_ended.new_types(null, null).max() == 0


def run_in(folder):
    """Two prey, a parent that dies at 45 s and its offspring, and a predator, in a run of 60 s."""
    folder.mkdir()
    (folder / "phylogeny.csv").write_text(
        "id,ancestor_id,origin_time,destruction_time,species\n0,0,0,45,prey\n1,1,0,inf,predator\n2,0,20,inf,prey\n3,0,20.2,20.8,prey\n"
    )
    genes = {0: [0, 0, 2, 1.0], 1: [0, 1, 2, 1.0], 2: [1, 0, 2, 2, 3, 1.0, 1.0], 3: [0]}
    lines = [f"{one},brain,{place},{gene}" for one, of in genes.items() for place, gene in enumerate(of)]
    (folder / "genes.csv").write_text("\n".join(["id,part,index,value", *lines, ""]))
    (folder / "genomes.csv").write_text("id,walking_pace\n0,1\n1,2\n2,1.5\n3,4\n")
    return types.SimpleNamespace(path=folder, reached_s=60.0)


def test_structure_is_that_of_the_living(tmp_path):
    lives = open_ended.Lives(run_in(tmp_path / "run"))
    assert lives.ids[lives.seen].tolist() == [0, 1, 2] and lives.ages_s[2] == 20.0
    of = open_ended.structure(lives, 2)
    assert of["pace", "prey"][[0, 19, 20, 44, 45, 60]].tolist() == [1, 1, 1.25, 1.25, 1.5, 1.5]
    assert of["most_links", "prey"][30] == 2 and of["links", "prey"][30] == 1.5 and of["hidden", "prey"][50] == 1
    assert set(of["links", "predator"]) == {1}
    present = lives.presence(numpy.array([0, 0, 1]), "prey")
    assert present.sum(axis=1).tolist() == [45, 41]


def test_levels_and_slopes_are_of_the_last_third():
    times_s = 100.0 * numpy.arange(61)
    points = numpy.where(times_s < 4000.0, 50.0, 2.0 + times_s / 500.0)
    rows = open_ended.ends_of([("cell", "00", "", "links", "prey", times_s, points)])
    of = {row["group"]: float(row["value"]) for row in rows}
    assert of == pytest.approx({"level": 2.0 + 5050.0 / 500.0, "slope": 2.0}, rel=1e-4)


def values_of(own=(), null=(), group="slope"):
    """Values of runs that scatter by 0.1 about these means, {(cell, metric, species): mean}, and about 0 otherwise."""
    rng, rows = numpy.random.default_rng(1), []
    for cell in (*open_ended.CELLS, open_ended.TWO_FOODS):
        for run in RUNS:
            rows.append(ponds.row_of(cell, run, "", ("persists", "all", "all"), 1.0))
            for species in open_ended.SPECIES:
                rows.append(ponds.row_of(cell, run, "", ("generation_s", species, "last"), 500.0))
            for metric in (*open_ended.TESTED, "hidden", "pace"):
                for species in open_ended.SPECIES:
                    for name, means in (("", own), ("neutral", null)):
                        for each in ("level", "slope"):
                            mean = dict(means).get((cell, metric, species), 0.0) if each == group else 0.0
                            rows.append(
                                ponds.row_of(cell, run, name, (metric, species, each), mean + rng.normal(0, 0.1))
                            )
    return rows


def found(rows, family):
    return {
        (row["metric"], row["species"])
        for row in rows
        if row["family"] == family and row["p_holm"] and float(row["p_holm"]) <= 0.05
    }


def test_growth_is_above_zero_and_above_the_null():
    both = open_ended.BOTH
    planted = {(both, "links", "prey"): 0.5, (both, "new_types", "predator"): 0.5}
    rows = open_ended.results(values_of(planted))
    assert found(rows, "slope") == {("links", "prey"), ("new_types", "predator")}
    falling = {(both, "links", "prey"): -0.5, (both, "new_types", "prey"): -0.5}
    assert found(open_ended.results(values_of(null=falling)), "slope") == {("new_types", "prey")}
    assert not found(open_ended.results(values_of(planted, planted)), "slope")
    assert not found(open_ended.results(values_of(falling)), "slope")
    assert "+0.5" in tables.growth(rows)


def test_only_what_both_do_together_is_an_interaction():
    cells = list(open_ended.CELLS)
    alone = {(cell, "links", "prey"): 1.0 for cell in cells[2:]}
    assert not found(open_ended.results(values_of(alone, group="level")), "interaction of levels")
    together = {(open_ended.BOTH, "most_links", "prey"): 1.0}
    rows = open_ended.results(values_of(together, group="level"))
    assert found(rows, "interaction of levels") == {("most_links", "prey")}
    assert not found(rows, "interaction of slopes") and tables.two_by_two(rows, "level").count("\n") == 12


def test_two_foods_are_compared_with_one_and_kinds_with_their_nulls():
    foods = open_ended.TWO_FOODS
    rows = open_ended.results(values_of({(foods, "new_types", "prey"): 0.5}))
    assert found(rows, "slope with two foods") == found(rows, "two foods") == {("new_types", "prey")}
    assert not found(rows, "slope") and "| new_types | prey | +0.46" in tables.by_foods(rows)
    planted = open_ended.diverges(ponds.Values(kinds_of(0.2, -0.2)))
    assert found(planted, "kinds of diet") == {
        ("specialists", "prey"),
        ("kinds_silhouette", "prey"),
        ("kinds_gene_flow", "prey"),
    }
    assert not found(open_ended.diverges(ponds.Values(kinds_of(0.0, 0.0))), "kinds of diet")
    assert tables.kinds_of_diet(planted, planted).count("\n") == 12


def kinds_of(more, less):
    """Values of runs whose diets cluster by so much more, with so much less gene flow between them, than in the nulls."""
    rng, rows = numpy.random.default_rng(1), []
    for key, null in open_ended.KINDS.items():
        for run in RUNS:
            for name, mean in {"": less if key[0] == "kinds_gene_flow" else more, null: 0.0, "neutral": 0.0}.items():
                rows.append(ponds.row_of(open_ended.TWO_FOODS, run, name, key, 0.5 + mean + 0.02 * rng.normal()))
    return rows


def test_diets_near_one_food_are_specialised(tmp_path):
    run = run_in(tmp_path / "run")
    (run.path / "genomes.csv").write_text("id,walking_pace,diet\n0,1,0.1\n1,2,0.5\n2,1.5,0.85\n3,4,0.5\n")
    of = open_ended.structure(open_ended.Lives(run), 2)
    assert set(of["specialists", "prey"]) == {1.0} and set(of["specialists", "predator"]) == {0.0}


def test_published_results_are_those_of_scipy_from_the_published_values():
    data = pathlib.Path(open_ended.__file__).resolve().parents[1] / "results/data"
    values = pandas.read_csv(data / "open_ended_runs.csv", dtype={"null": str, "run": str}).fillna({"null": ""})
    of = values.set_index(["set", "null", "metric", "species", "group", "run"])["value"].sort_index()
    rows = pandas.read_csv(data / "open_ended.csv").query("family == 'slope'")
    assert len(rows) == 6
    for row in rows.itertuples():
        ours, null = (of[row.set, name, row.metric, row.species, row.group] for name in ("", "neutral"))
        less = ours - null
        assert row.difference == pytest.approx(less.mean(), rel=1e-4) and row.runs == len(less)
        p = stats.ttest_1samp(less, 0.0).pvalue if less.mean() > 0.0 else 1.0
        if row.metric != "new_types":
            p = max(p, stats.ttest_1samp(ours, 0.0).pvalue if ours.mean() > 0.0 else 1.0)
        assert row.p == pytest.approx(p, rel=1e-3)
