# SPDX-License-Identifier: MIT
"""Kinds: clusters of genomes over random mating of the same parents, and gene flow between them."""
import functools
import math
import re

import numpy
import pytest
from hand_written import WEB, write_run
from scipy import stats
from trophic import controls, judge, pool
from trophic.errors import RunError
from trophic.metrics import Measuring, kinds
from trophic.metrics.drift import Descent

FORESTS = 19  # of the null, so that p <= 0.05 is: above all of them


def simulated(rng, parents=2, groups=1, migration=0.0, skew=0.0, niches=0.0, loci=8, sd=0.1, members=24, births=240):
    """A population in which each birth replaces a random member of its group. Parents are of this group, or with probability `migration` of any, drawn by
    an individual's luck, exp(skew N), and in the births of two niches by exp(+-niches w0)."""
    group = [i % groups for i in range(members)]
    weights, luck = list(rng.normal(0.0, 1.0, (members, loci))), list(numpy.exp(skew * rng.normal(size=members)))
    parents_of, born, died = [[] for _ in range(members)], [0.0] * members, [math.inf] * members
    living = list(range(members))
    for birth in range(births):
        out = living.pop(rng.integers(len(living)))
        chosen = []
        for _ in range(parents):
            is_any = rng.random() < migration
            others = [i for i in living if (is_any or group[i] == group[out]) and i not in chosen]
            others = others or [i for i in living if i not in chosen]
            side = niches if birth % 2 else -niches
            shares = numpy.cumsum([luck[i] * math.exp(side * weights[i][0]) for i in others])
            chosen.append(others[int(numpy.searchsorted(shares, rng.random() * shares[-1]))])
        own = numpy.array([weights[i] for i in chosen])[rng.integers(parents, size=loci), range(loci)]
        weights.append(own + rng.normal(0.0, sd, loci))
        died[out] = birth + 1.0
        living.append(len(born))
        for column, value in zip(
            (group, luck, parents_of, born, died),
            (group[out], math.exp(skew * rng.normal()), chosen, birth + 1.0, math.inf),
        ):
            column.append(value)
    return Descent(
        list(range(len(born))),
        numpy.array(born),
        numpy.array(died),
        ["prey"] * len(born),
        parents_of,
        numpy.array(weights),
        {"prey": loci},
    )


def populations(runs, **world):
    for run in range(runs):
        rng = numpy.random.Generator(numpy.random.Philox([run, 7]))
        yield rng, simulated(rng, **world)


@functools.lru_cache(maxsize=None)
def measured(runs, **world):
    """The p values of silhouette and gene flow in simulated runs, and the kinds and the gene flow of the runs."""
    rows = []
    for rng, of in populations(runs, **world):
        found = kinds.kinds_of(of, "prey", of.birth_s[-1:], rng, FORESTS)
        flow = found.gene_flow()[0]
        rows.append((kinds.rank_p(found.silhouette[0]), kinds.rank_p(-flow), found.count[0, 0], flow[0]))
    return numpy.array(rows).T


RUNS = 40
MOST = int(stats.binom.ppf(0.999, RUNS, 0.05))  # errors of a test at 5 %


# Without kinds


@pytest.mark.parametrize(
    "world",
    [{}, {"skew": 1.0}, {"parents": 1}, {"parents": 1, "skew": 1.0}, {"parents": 1, "groups": 2}, {"loci": 1}],
    ids=str,
)
def test_neutral_populations_have_kinds_in_at_most_5_percent(world):
    of_silhouette, of_flow, _, flow = measured(RUNS, **world)
    assert (of_silhouette <= 0.05).sum() <= MOST and (of_flow <= 0.05).sum() <= MOST
    assert numpy.mean(of_silhouette) > 0.4
    if world.get("parents") != 1:
        assert 0.85 < numpy.nanmean(flow) < 1.1


def test_shuffled_loci_are_the_wrong_null_of_clones():
    wrong = 0
    for rng, of in populations(20, parents=1):
        rows = of.weights[numpy.isinf(of.death_s)]
        shuffled = [kinds.best_cut(rng.permuted(rows, axis=0))[0] for _ in range(FORESTS)]
        wrong += kinds.best_cut(rows)[0] > max(shuffled)
    assert wrong >= 18


# With kinds


@pytest.mark.parametrize(
    "world, found, number, flow",
    [
        ({"groups": 2, "births": 480}, 0.9, 2, (0.0, 0.4)),
        ({"groups": 3, "births": 480, "members": 30}, 0.9, 3, (0.0, 0.3)),
        ({"groups": 2, "migration": 0.02, "births": 480}, 0.6, 2, (0.1, 0.7)),
        ({"parents": 1, "niches": 5.0, "loci": 1}, 0.7, 2, (0.0, 0.2)),
    ],
    ids=str,
)
def test_planted_kinds_are_found(world, found, number, flow):
    of_silhouette, of_flow, counts, flows = measured(20, **world)
    assert (of_silhouette <= 0.05).mean() >= found
    assert numpy.bincount(counts.astype(int)).argmax() == number
    assert flow[0] <= numpy.mean(flows) <= flow[1]
    if world.get("parents") != 1:
        assert (of_flow <= 0.05).mean() >= 0.9


def test_much_gene_flow_leaves_no_kinds():
    of_silhouette, _, _, flows = measured(20, groups=2, migration=0.5)
    assert (of_silhouette <= 0.05).sum() <= 5 and numpy.mean(flows) == pytest.approx(1.0, abs=0.12)


# The parts


@pytest.mark.parametrize(
    "rows, labels",
    [
        ([0, 1, 2, 20, 21, 22], [0, 0, 0, 1, 1, 1]),
        ([0, 1, 2, 20, 21, 22, 90], [0, 0, 0, 1, 1, 1, -1]),
        ([0, 1, 40, 41, 20, 21], [0, 0, 1, 1, 2, 2]),
        ([5] * 6, [0] * 6),
    ],
)
def test_the_best_cut_of_a_row_of_points(rows, labels):
    silhouette, found = kinds.best_cut(numpy.array(rows, float)[:, None])
    first = {label: place for place, label in reversed(list(enumerate(found))) if label >= 0}
    order = {label: i for i, label in enumerate(sorted(first, key=first.get))}
    assert [order.get(label, -1) for label in found] == labels
    assert (silhouette > 0.7) == (len(set(rows)) > 1)


def test_the_silhouette_by_hand():
    # 0 and 1 are 1 apart and 10 and 9 from the others on average, these 2 apart and 10.5 and 8.5
    silhouette, _ = kinds.best_cut(numpy.array([[0.0], [1.0], [9.0], [11.0]]))
    assert silhouette == pytest.approx((9 / 10 + 8 / 9 + 6.5 / 8.5 + 8.5 / 10.5) / 4)


def test_mutations_and_the_parents_of_loci():
    weights = numpy.array([[0.0, 5.0, 1.0], [2.0, 9.0, 1.0], [2.1, 5.2, 1.0]])
    given, source = kinds._given(weights, [[], [], [0, 1]])
    assert given[2] == pytest.approx([0.1, 0.2, 0.0]) and source[2].tolist() == [1, 0, 0]
    assert given[:2].tolist() == weights[:2].tolist()


def test_the_null_keeps_first_parents_and_the_offspring_of_second_ones():
    rng = numpy.random.Generator(numpy.random.Philox(1))
    of = simulated(rng)
    parents, donor = kinds._dealt(of.parents, of.birth_s, of.death_s, rng, 50)
    births = numpy.array([bool(its) for its in of.parents])
    assert (
        parents[births, :, 0].tolist() == [its for its in of.parents if its]
        and (donor[:, 0] == numpy.arange(len(donor))).all()
    )
    first, second = parents[births, 0], parents[births, 1]
    assert (first == first[:, :1]).all() and (second != first).all()
    assert (second != second[:, :1]).mean() > 0.7
    assert (of.birth_s[second] < of.birth_s[births][:, None]).all()
    counts = [numpy.bincount(column, minlength=len(births)) for column in second.T]
    assert abs(numpy.array(counts) - counts[0]).mean() < 0.25  # those whose exchange does not fit keep theirs
    assert (births[donor] == births[:, None]).all() and (
        numpy.sort(donor, axis=0) == numpy.arange(len(donor))[:, None]
    ).all()


@pytest.mark.parametrize("parents", [1, 2, 3])
def test_without_mutation_the_null_has_only_loci_of_founders(parents):
    rng = numpy.random.Generator(numpy.random.Philox(2))
    of = simulated(rng, parents=parents, sd=0.0, loci=3)
    for genomes, living, _ in kinds._grown(of, "prey", numpy.array([60.0, 240.0]), rng, 5):
        assert len(living) == 24
        for locus in range(3):
            assert numpy.isin(genomes[living, :, locus], of.weights[:24, locus]).all()
    alive = numpy.isinf(of.death_s)
    assert genomes[living, 0] == pytest.approx(of.weights[alive]) and (genomes[living, 1] != genomes[living, 0]).any()


# A run


def written(folder, of=None, species="prey", **more):
    of = of or simulated(numpy.random.Generator(numpy.random.Philox(3)), groups=2, births=480)
    texts = [str(its).replace(" ", "") if its else "[none]" for its in of.parents]
    phylogeny = "".join(
        f'{one},"{text}",{born},{died},{species}\n'
        for one, text, born, died in zip(of.ids, texts, of.birth_s, of.death_s)
    )
    sexes = numpy.arange(len(of.ids)) % 2
    columns = [f"w{i}" for i in range(of.weights.shape[1] - 1)] + ["hue", "sex"]
    genomes = "".join(
        f"{one},{one},{born}," + ",".join(map(repr, [*row.tolist(), int(sex)])) + "\n"
        for one, born, row, sex in zip(of.ids, of.birth_s, of.weights, sexes)
    )
    files = {
        "phylogeny.csv": "id,ancestor_list,origin_time,destruction_time,species\n" + phylogeny,
        "genomes.csv": f"id,genome_id,time_s,{','.join(columns)}\n" + genomes,
    }
    end_s = float(of.birth_s[-1])
    write_run(folder, until_s=end_s, **{"result": {"reached_s": end_s}, "params": {"seed": 1}, "files": files, **more})
    return files


@pytest.fixture(autouse=True)
def few_forests(monkeypatch):
    monkeypatch.setattr(kinds, "FORESTS", FORESTS)


def test_a_run_has_kinds_and_gene_flow_of_each_half_and_curves(tmp_path):
    written(tmp_path / "run")
    of = pool.read_set([tmp_path / "run"], how=Measuring(kinds=["genome"]))
    values = of.values[0].values
    assert [name for name in of.metrics()] == kinds.names(WEB)
    value = {(row.metric, row.group, row.baseline): row.value for row in values[values.species == "prey"].itertuples()}
    assert (
        value["kinds", "late", ""] >= 2
        and value["kinds_p", "late", ""] == 0.05 == value["kinds_gene_flow_p", "late", ""]
    )
    assert value["kinds_silhouette", "late", ""] > 1.5 * value["kinds_silhouette", "late", kinds.NULL]
    assert value["kinds_gene_flow", "late", ""] < 0.4 < value["kinds_gene_flow", "late", kinds.NULL]
    assert values[values.species == "predator"].value.isna().all()
    assert any(
        "predator: fewer than 10 living members at the end of each window" in remark for remark in of.values[0].remarks
    )
    curves = of.values[0].curves
    assert (
        len(curves[(curves.metric == "kinds_silhouette") & (curves.species == "prey") & (curves.baseline == "")])
        == kinds.WINDOWS
    )
    frame = judge.summarize(of)
    assert set(frame.not_tested[frame.metric.isin(kinds.DESCRIBED)]) == {controls.BY_RUN}
    again = pool.read_set([tmp_path / "run"], how=Measuring(kinds=["genome"]))
    assert again.values[0].values.equals(values)


def test_one_trait_and_the_sex(tmp_path):
    written(tmp_path / "run")
    run = pool.read_pooled(tmp_path / "run")
    assert kinds._chosen(run, ["genome"]) == [*(f"w{i}" for i in range(7)), "hue"] and kinds._chosen(run, ["sex"]) == [
        "sex"
    ]
    of = pool.read_set([tmp_path / "run"], how=Measuring(kinds=["hue"]))
    assert of.table[kinds.names(WEB)[1], ""][0] > 0.4  # silhouettes of one number are high


@pytest.mark.parametrize(
    "loci, change, why",
    [
        (["size"], {}, "--kinds size: must be genome, or columns of genomes.csv: w0, hue, sex, ..."),
        (["genome", "hue"], {}, "--kinds genome: must be genome, or columns of genomes.csv: w0, hue, sex, ..."),
        (
            ["genome"],
            {"genomes.csv": None},
            "genomes.csv: is missing; lineage measures need the phylogeny and the genomes",
        ),
        (
            ["genome"],
            {"genomes.csv": "id,genome_id,time_s\n0,0,0\n"},
            "genomes.csv: has no weights and no traits; genes.csv is not measured",
        ),
        (["genome"], {"phylogeny.csv": "id,ancestor_list,origin_time,destruction_time,species\n"}, None),
    ],
)
def test_what_cannot_be_measured_is_a_sentence(tmp_path, loci, change, why):
    files = written(tmp_path / "first") | change
    written(tmp_path / "run", files={name: text for name, text in files.items() if text is not None})
    if why is None:
        (values,) = pool.read_set([tmp_path / "run"], how=Measuring(kinds=loci)).values
        assert values.values.value.isna().all() and len(values.remarks) == 2
        return
    with pytest.raises(RunError, match=re.escape(why)):
        pool.read_set([tmp_path / "run"], how=Measuring(kinds=loci))
