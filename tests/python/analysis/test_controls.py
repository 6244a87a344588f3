# SPDX-License-Identifier: MIT
"""Which null is asked for which measure and kind of world, what is not tested, and the error rates of each control by simulation."""
import json
import math

import numpy
import pytest
from hand_written import event, refusal, robot, write_run, write_set
from sets import around, metric, quick_set, run_of, set_of
from trophic import controls, judge, pool, published, statistics
from trophic.metrics import Measuring
from trophic.report import analyze, tables, tex, text
from trophic.runs import Run
from trophic.statistics import Lives, common_end, log_rank, restricted_mean, survival_difference
from trophic.sweeps import arrays
from trophic.values import Metric

NAN = math.nan
CHANGING = {"heredity": "own_copy", "recruitment": "at_energy"}
ACTIVE, INACTIVE, ALL = (metric("velocity", group=group) for group in ("active", "inactive", "all"))
COUNT, PAIR, GENE = metric("population"), metric("search_rate", "prey+predator"), metric("body_mass")
EXTINCT = Metric("extinct_at", "prey", "all", "s")


def world(values, rules=CHANGING, species=("prey", "predator"), **nulls):
    """A set of runs of these rules. `nulls`: as in MeasuredSet."""
    made = set_of(values)
    made.runs = [Run(run.path, {**run.manifest, "rules": dict(rules), "species": list(species)}) for run in made.runs]
    made.inherited = frozenset({"body_mass"})
    for name, of in nulls.items():
        setattr(made, name, of)
    return made


def of_all(value=1.0):
    return {
        name: around(value + 0.001 * place) for place, name in enumerate((ACTIVE, INACTIVE, ALL, COUNT, PAIR, GENE))
    }


def every_null():
    return {
        "shadow": world(of_all(2.0)),
        "neutral": world(of_all(3.0)),
        "one_sided": {"prey": world(of_all(4.0)), "predator": world(of_all(5.0))},
    }


# Which null


@pytest.mark.parametrize(
    "rules, species, nulls",
    [
        ({"heredity": "own_copy"}, ("prey", "predator"), ["shadow"] * 5 + ["neutral"]),
        (CHANGING, ("prey", "predator"), ["one_sided", "one_sided", "", "one_sided", "shadow", "neutral"]),
        (CHANGING, ("prey",), ["shadow", "shadow", "", "shadow", "shadow", "neutral"]),
    ],
)
def test_the_null_of_each_measure_in_each_kind_of_world(rules, species, nulls):
    of = world(of_all(), rules, species, **every_null())
    assert [controls.control_of(of, name).null for name in of.metrics()] == nulls
    frame = judge.summarize(of)
    tested = frame[frame.role == "null"]
    assert dict(zip(tested.metric + tested.group, tested.null)) == {
        name.metric + name.group: null for name, null in zip(of.metrics(), nulls) if null
    }
    of_one_sided = frame[(frame.metric == "population") & (frame.null == "one_sided")]
    assert (of_one_sided.null_mean.round() == 4.0).all()  # the world of prey, not of predators


def test_behaviour_of_active_and_inactive_members_together_is_described_and_not_tested_where_numbers_change():
    of = world(of_all(), **every_null())
    row = judge.summarize(of).query("metric == 'velocity' and group == 'all' and null == 'one_sided'").iloc[0]
    assert (row.role, row.conclusion, row.not_tested) == ("reference", "not compared", controls.MIXED)
    assert row.difference == pytest.approx(-3.0) and math.isnan(row.p)
    always = world({**of_all(), INACTIVE: [NAN] * 6}, **every_null())
    assert controls.control_of(always, ALL).null == "one_sided"  # of a species that is always active


def test_without_one_sided_worlds_the_shadow_is_described_and_said_to_be_no_control():
    of = world(of_all(), shadow=world(of_all(2.0)))
    frame = judge.summarize(of)
    why = "no one-sided worlds: --one-sided makes them; the shadow's numbers differ, so it is described"
    assert set(frame[frame.metric == "population"].not_tested) == {why}
    assert [row.metric for row in frame.itertuples() if row.role == "null"] == ["search_rate"]
    for said in (text.findings(of, frame), text.table(of, frame)):
        assert f"not tested: measures of one species: {why}\n" in said
        assert "\ntested: measures of several species over the shadow: none inherits there, " in said
        assert "not tested: genomes, bodies and brains: no neutral null: --neutral makes one; " in said
    assert f"% not tested: measures of one species: {why}\n" in tex.means(of, frame)
    outcome = analyze.Outcome([of], [frame], None)
    content = outcome.analysis(None).summary["sets"][0]
    assert content["controls"] == controls.sentences(of, of.metrics()) and len(content["controls"]) == 3
    its = {one["metric"]: one["baselines"][0] for one in content["metrics"]}
    assert its["population"]["not_tested"] == why and its["population"]["differs"] is None
    assert set(outcome.analysis(None).means.query("metric == 'population'").not_tested) == {why}


def test_two_worlds_are_compared_over_their_one_sided_worlds():
    a, b = (world(of_all(value), **every_null()) for value in (1.0, 1.5))
    frame = judge.compare(a, b)
    assert list(frame[frame.metric == "population"].compared) == ["over_one_sided", "raw"]
    assert "in runs of paper, each over its one-sided world" in judge.findings(frame)[0].sentence
    assert "over one-sided worlds: (b - one-sided world)" in text.difference_table(a, b, frame)


def test_the_papers_questions_are_answered_under_the_readings_that_the_world_can_judge():
    question = published.QUESTIONS[1]
    names = [reading.metric for reading in question.readings] + [INACTIVE]
    rng = numpy.random.default_rng(3)

    def of(shift):
        return world({name: list(rng.normal(shift, 0.001, 6)) for name in names})

    made = of(-0.05)
    made.shadow, made.one_sided = of(-0.02), {"prey": of(0.0), "predator": of(0.0)}
    (answer,) = published.answers(made, judge.summarize(made))
    assert {effect.reading.metric.group for effect in answer.effects} == {"active"}
    assert answer.effects[0].null == "one_sided" and str(answer) == "yes, they move away faster"
    assert answer.shown.difference.value == pytest.approx(-0.05, abs=0.002)
    for run in made.runs:
        run.manifest["rule_table"] = "pond"
    assert published.answers(made, judge.summarize(made)) == []  # a world of its own
    for run in made.runs:
        run.manifest["rule_table"] = "paper with metabolism = fixed_gains"
    made.one_sided = {}
    assert published.answers(made, judge.summarize(made)) == []


# Folders


LIVES = (
    event("birth", 0, 0, "prey"),
    event("birth", 0, 1, "predator"),
    event("birth", 4, 2, "prey", origin="inherited"),
)
WALKS = tuple(
    robot(tick, id, one, 0.1 * tick * (id + 1), 0.0, adversary_id=1 - id % 2, active=int(id != 2), origin="inherited")
    for tick in range(13)
    for id, one in ((0, "prey"), (1, "predator"), (2, "prey"))
    if tick > 1 or id < 2
)
TREE = "id,ancestor_list,origin_time,destruction_time,species\n0,[none],0,inf,prey\n1,[none],0,inf,predator\n2,[0],4,inf,prey\n"


def pond(folder, heredity="own_copy", **more):
    return write_set(
        folder,
        shadow=False,
        of_agents=WALKS,
        of_events=LIVES,
        until_s=24.0,
        rules={**CHANGING, "heredity": heredity},
        result={"reached_s": 24.0},
        clock={"until_s": 24.0, "tick_s": 2.0},
        files={"phylogeny.csv": TREE},
        params={},
        **more,
    )


def test_the_one_sided_worlds_in_the_folder_are_found_and_another_is_refused(tmp_path):
    folder = pond(tmp_path / "pond")
    for one in ("prey", "predator"):
        pond(folder / f"one_sided_{one}", f"own_copy, nothing_inherited for {one}", fingerprint=one)
    of = pool.read_set([folder], how=Measuring(jobs=1))
    assert list(of.nulls) == ["one_sided_prey", "one_sided_predator"]
    frame = judge.summarize(of)
    groups = set(frame[(frame.metric == "velocity") & (frame.species == "prey")].group)
    assert groups == {"all", "random", "inherited", "active", "inactive", "inherited_active", "inherited_inactive"}
    assert not (frame[(frame.species == "predator")].group.str.contains("inactive")).any()
    assert {"shadow", "neutral", "clones"}.isdisjoint(frame.null) and "one_sided" in set(frame.null)
    assert set(tables.metrics([of]).baseline) >= {"one_sided_prey", "one_sided_predator"}
    assert "one-sided world (prey): paper on kinematic 1, 6 runs of 24 s\n" in text.findings(of, frame)
    wrong = pond(tmp_path / "wrong")
    pond(wrong / "one_sided_prey", "own_copy, nothing_inherited for predator")
    assert refusal(pool.read_set, [wrong]) == (
        f"{wrong}/one_sided_prey/replicate-00: is not a one-sided world of prey of {wrong}/replicate-00: its rule in slot heredity is "
        "own_copy, nothing_inherited for predator: must be own_copy, nothing_inherited for prey"
    )


# What happened only in some runs


def test_a_mean_over_the_runs_in_which_something_happened_is_described_and_not_tested():
    period, cycles = Metric("period", "prey", "all", "s"), metric("cycles")
    few = {period: [*around(100.0, 8), NAN, NAN], cycles: [1.0] * 8 + [0.0] * 2}
    many = {period: around(90.0, 10), cycles: [1.0] * 10}
    a, b = world(few), world(many)
    rows = {row.metric: row for row in judge.compare(a, b).itertuples()}
    assert "not tested: 1 metric that some runs lack" in text.difference_findings(a, b, judge.compare(a, b))
    assert rows["period"].not_tested == (
        "only 8 of 10 and 10 of 10 runs have a value: a mean over the runs in which it happened is only described"
    )
    assert rows["period"].difference == pytest.approx(-10.0) and math.isnan(rows["period"].p)
    assert rows["cycles"].role == "null" and rows["cycles"].p == pytest.approx(0.474, abs=0.001)  # the share is tested
    both = judge.compare(world(many), world({**many, period: around(80.0, 10)}))
    assert both.conclusion[0] == "below" and both.not_tested[0] == ""  # all runs have one
    of = world(few, one_sided={"prey": world(many), "predator": world(many)})
    row = judge.summarize(of).query("metric == 'period'").iloc[0]
    assert (row.role, row.n, row.null_n) == ("reference", 8, 10) and "8 of 10 and 10 of 10" in row.not_tested


def dying(ends_s, until_s=60.0):
    """Runs in which prey die out at these times; nan: they live to the end."""
    made = world({metric("persists"): [float(math.isnan(at)) for at in ends_s], EXTINCT: list(ends_s)})
    made.until_s = until_s
    return made


def test_when_a_species_dies_out_is_compared_with_the_runs_that_it_survives():
    """In b few die out, early: the mean over those that die would say earlier, but prey last longer."""
    a, b = dying([*around(36.0, 35, 6.0), *[NAN] * 5]), dying([*around(18.0, 7, 6.0), *[NAN] * 33])
    row = judge.compare(a, b).query("metric == 'extinct_at'").iloc[0]
    assert (row.n_a, row.n_b, row.mean_a, row.mean_b) == (40, 40, pytest.approx(39.17, 1e-3), pytest.approx(52.5, 1e-2))
    assert row.conclusion == "above" and row.p < 1e-6 and row.lower > 5.0
    (sentence,) = [one.sentence for one in judge.findings(judge.compare(a, b)) if one.metric == EXTINCT]
    assert sentence.startswith(
        "The mean time that prey last, up to the common end of the runs, is 13.7 s higher in runs of"
    )
    none = world({metric("persists"): [1.0] * 40})  # no species dies out, so the set has no metric of when
    none.until_s = 60.0
    rows = judge.compare(a, none).query("metric == 'extinct_at'")
    assert rows.mean_b.tolist() == [60.0] and rows.conclusion.tolist() == ["above"]
    assert judge.compare(none, a).query("metric == 'extinct_at'").conclusion.tolist() == ["below"]


# Survival, by hand


def lives(ends_s, died, planned_s=10.0):
    return Lives(numpy.array(ends_s, float), numpy.array(died, bool), planned_s)


A = lives([2, 4, 4, 10, 7, 10], [1, 1, 1, 0, 0, 0])
B = lives([1, 2, 2, 3, 9, 10], [1, 1, 1, 1, 1, 0])


def test_restricted_means_by_hand():
    # Shares 5/6 from 2 s and 1/2 from 4 s: 2 + 2 x 5/6 + 6 x 1/2. Greenwood: (4.667^2 / (6 x 5) + 3^2 x 2 / (5 x 3)) x 6 / 5.
    found = restricted_mean(A, 10.0)
    assert found.value == pytest.approx(2 + 10 / 6 + 3)
    assert found.error**2 == pytest.approx((14 / 3) ** 2 / 30 * 1.2 + 9 * 2 / 15 * 1.2)
    whole = [3.0, 5.0, 1.0, 9.0, 2.0, 4.0]
    assert restricted_mean(lives(whole, [1] * 6), 10.0) == pytest.approx(statistics.contrast((1.0, whole)))
    assert restricted_mean(lives(whole, [1] * 6), 4.0) == pytest.approx(
        statistics.contrast((1.0, numpy.minimum(whole, 4.0)))
    )


def test_log_rank_by_hand():
    # At 1, 2, 3, 4 and 9 s: deaths 1, 3, 1, 2, 1 of 12, 11, 8, 7, 4 at risk, of which 6, 6, 5, 5, 2 in a, and 0, 1, 0, 2, 0 die there.
    expected = 6 / 12 + 3 * 6 / 11 + 5 / 8 + 2 * 5 / 7 + 2 / 4
    variance = 1 / 4 + 3 * 6 / 11 * 5 / 11 * 8 / 10 + 5 / 8 * 3 / 8 + 2 * 5 / 7 * 2 / 7 * 5 / 6 + 2 / 4 * 2 / 4
    z = (3 - expected) / math.sqrt(variance)
    assert log_rank(A, B) == pytest.approx(math.erfc(abs(z) / math.sqrt(2.0))) == log_rank(B, A)
    assert log_rank(A, lives(B.ends_s[:5], B.died[:5])) is None  # five runs
    assert log_rank(lives([10] * 6, [0] * 6), lives([10] * 6, [0] * 6)) is None  # nothing died


def test_the_common_end_is_that_of_the_shorter_set():
    short = lives([2, 5, 5, 5, 5, 5], [1, 0, 0, 0, 0, 0], 5.0)
    assert common_end(A, short) == 5.0 and common_end(A, B) == 10.0
    assert common_end(A, lives([2, 3], [0, 0])) == 3.0  # ended early, alive: nothing is known of later
    late = lives([2, 8, 8, 8, 8, 8], [1] * 6)  # die after the common end: as if they lived
    found = survival_difference(short, late)
    assert found.value == pytest.approx(0.0) and found.p == pytest.approx(1.0)


# Error rates


def simulated_lives(rng, runs, mean_s, planned_s, frail=0.0):
    """Lives with a constant hazard; runs of a set with `frail` ones differ in it. Some runs are cut off before the planned end."""
    ends = rng.exponential(mean_s * numpy.exp(frail * rng.standard_normal(runs)), runs)
    cut = numpy.where(rng.random(runs) < 0.2, rng.uniform(0.3, 1.0, runs), 1.0) * planned_s
    return Lives(numpy.minimum(ends, cut), ends <= cut, planned_s)


@pytest.mark.parametrize("runs", [(6, 6), (10, 10), (10, 30)])
@pytest.mark.parametrize("planned_s", [(60.0, 60.0), (40.0, 90.0)])
def test_survival_differs_by_chance_in_at_most_7_percent_of_sets_also_of_unequal_length_and_intervals_hold(
    runs, planned_s
):
    rng = numpy.random.default_rng([3, *runs, int(planned_s[0])])
    found, outside, sets = 0, 0, 1500
    for _ in range(sets):
        a, b = (simulated_lives(rng, count, 50.0, until) for count, until in zip(runs, planned_s))
        of = survival_difference(a, b)
        found += of.p is not None and of.p <= 0.05
        outside += not of.interval.lower <= 0.0 <= of.interval.upper
    assert found <= 0.07 * sets and outside <= 0.07 * sets, (found / sets, outside / sets)


def test_survival_that_differs_is_found_and_a_mean_over_those_that_died_says_the_opposite():
    """In b prey die at a third of the rate of a, but b has runs of 40 s and a of 90 s: those that die in b die earlier."""
    rng = numpy.random.default_rng(5)
    found, earlier, sets = 0, 0, 300
    for _ in range(sets):
        a, b = simulated_lives(rng, 60, 50.0, 90.0), simulated_lives(rng, 60, 150.0, 40.0)
        of = survival_difference(b, a)
        found += of.p <= 0.05 and of.value > 0.0
        those = statistics.contrast((1.0, b.ends_s[b.died]), (-1.0, a.ends_s[a.died]))
        earlier += those is not None and statistics.p_value(those) <= 0.05 and those.value < 0.0
    assert found >= 0.8 * sets and earlier >= 0.3 * sets


SETS, RUNS, PREY, PREDATORS, STEPS = 300, 10, 16, 8, 100


def ecology(rng, prey=True, predators=True, flight=0.0):
    """Velocities of prey, the active and all, in worlds in which predators evolve skill, and prey flight if `flight` selects it. A species that
    does not inherit has new genomes. Prey run from skilled predators whatever their genome, and their young are inactive longer. Shape (runs,).
    """
    runs = SETS * RUNS
    rows = numpy.arange(runs)
    z, skill = rng.standard_normal((runs, PREY)), rng.standard_normal((runs, PREDATORS))
    awake, total, count = numpy.zeros((runs, PREY)), 0.0, 0.0
    for step in range(STEPS):
        for trait, inherits, selects in ((z, prey, flight), (skill, predators, 1.0)):
            dies = (rng.gumbel(size=trait.shape) - selects * trait).argmax(axis=1)
            parent = (dies + rng.integers(1, trait.shape[1], runs)) % trait.shape[1]
            child = trait[rows, parent] + 0.5 * rng.standard_normal(runs) if inherits else rng.standard_normal(runs)
            trait[rows, dies] = child
            if trait is z:
                awake[rows, dies] = step + 2.0 + rng.poisson(numpy.exp(0.7 * skill.mean(axis=1)))
        velocity = z + 0.3 * skill.mean(axis=1, keepdims=True)
        active = awake <= step
        if 2 * step >= STEPS:
            total, count = total + (velocity * active).sum(axis=1), count + active.sum(axis=1)
    return {"active": total / count, "all": total / (STEPS // 2 * PREY)}


def share_found(ours, null):
    """The share of sets of ten runs in which a difference is found, p <= 0.05."""
    sets = [arrays.moments(values.reshape(SETS, RUNS).T) for values in (ours, null)]
    return float((arrays.p_value(arrays.contrast((1.0, sets[0]), (-1.0, sets[1]))) <= 0.05).mean())


def test_where_the_other_species_evolves_the_one_sided_world_finds_5_percent_and_the_shadow_nearly_all_of_what_is_not_there():
    rng = numpy.random.default_rng(17)
    ours, shadow, one_sided = ecology(rng), ecology(rng, prey=False, predators=False), ecology(rng, prey=False)
    assert share_found(ours["active"], one_sided["active"]) <= 0.07
    assert share_found(ours["active"], shadow["active"]) >= 0.8  # predators evolved, prey did not
    assert share_found(one_sided["active"], shadow["active"]) >= 0.8


def test_flight_that_evolves_is_found_over_the_one_sided_world_and_by_the_active_apart():
    rng = numpy.random.default_rng(19)
    ours, one_sided = ecology(rng, flight=1.0), ecology(rng, prey=False, flight=1.0)
    assert share_found(ours["active"], one_sided["active"]) >= 0.9
    assert share_found(ours["all"], one_sided["all"]) <= 0.6  # who is inactive longer hides it


def test_the_judge_finds_in_simulated_worlds_what_the_simulation_of_its_controls_finds():
    rng = numpy.random.default_rng(18)
    ours, shadow, one_sided = ecology(rng), ecology(rng, False, False), ecology(rng, prey=False)
    significant = {"shadow": 0, "one_sided": 0}
    for i in range(40):
        sets = {
            name: quick_set({ACTIVE: of["active"][i * RUNS : (i + 1) * RUNS], INACTIVE: numpy.zeros(RUNS)})
            for name, of in (("ours", ours), ("shadow", shadow), ("one_sided", one_sided))
        }
        of = sets["ours"]
        of.runs = [Run(run_of(0).path, {**run_of(0).manifest, "rules": CHANGING})] * RUNS
        of.shadow = sets["shadow"]
        assert judge.count(judge.summarize(of)).comparisons == 0
        of.one_sided = {"prey": sets["one_sided"]}
        significant["one_sided"] += judge.count(judge.summarize(of)).significant
        of.runs = sets["shadow"].runs  # as if its numbers were constant
        significant["shadow"] += judge.count(judge.summarize(of)).significant
    assert significant["one_sided"] <= 6 and significant["shadow"] >= 15, significant
