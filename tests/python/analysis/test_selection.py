# SPDX-License-Identifier: MIT
"""Where selection acts: exactness, planted effects and none in 1000 simulated sets, a stranger's numbers, and what is refused."""
import os
import pathlib
import subprocess

import numpy
import pandas
import pytest
from hand_written import event, robot, write_run, write_set
from scipy import special
from strangers_price import price as strangers_price
from trophic import selection
from trophic.metrics import Measuring
from trophic.runs import RunError
from trophic.sweeps import arrays

PROGRAM = os.environ.get("TROPHIC_PREDATOR_PREY")
# Prey 0 and 1 are founders; 0 begets 2; 1 is caught; 3 is a newcomer; the last prey dies and 4 comes; 9 is a predator whose parent is a prey.
EVENTS = [
    event("birth", 0, 0, "prey"),
    event("birth", 0, 1, "prey"),
    event("birth", 0, 8, "predator"),
    event("birth", 4, 2, "prey", origin="inherited", parent_id=0),
    event("death", 6, 1, "prey", cause="caught"),
    event("birth", 8, 3, "prey"),
    event("birth", 8, 9, "predator", origin="inherited", parent_id=0),
    event("death", 12, 0, "prey", cause="starved"),
    event("death", 20, 2, "prey", cause="caught"),
    event("death", 22, 3, "prey", cause="caught"),
    event("birth", 26, 4, "prey"),
]
Z = {0: 1.0, 1: 3.0, 2: 2.0, 3: 6.0, 4: 5.0, 8: 0.5, 9: 1.5}
# Births of 2 (mean 2 of two), 3 (1.5 of two) and 4 (alone; the last mean was 6); deaths of 1 (2 of three), 0 (3 of three), 2 (4 of two) and 3.
PREY = {
    ("start", "all"): 2.0,
    ("end", "all"): 5.0,
    ("change", "all"): 3.0,
    ("parenthood", "all"): -1 / 3,
    ("mutation", "all"): 1 / 3,
    ("newcomers", "all"): 1.5 - 1.0,
    ("survival", "all"): -0.5 + 1.0 + 2.0,
    ("survival_caught", "all"): -0.5 + 2.0,
    ("survival_starved", "all"): 1.0,
    ("survival", "first"): -0.5,
    ("newcomers", "first"): 1.5,
    ("survival", "second"): 1.0,
    ("survival", "third"): 2.0,
    ("newcomers", "third"): -1.0,
    ("change", "first"): 1.0,
    ("change", "second"): 1.0,
    ("change", "third"): 1.0,
    ("end", "second"): 4.0,
    ("mutation_a_birth", "all"): 1.0,
    ("lives", "all"): 1.0 - 3.4,
    ("lives_length", "all"): (12 * 1 + 6 * 3 + 16 * 2 + 14 * 6 + 4 * 5) / 52 - 3.4,
}


def frame_of(of_events=EVENTS):
    return pandas.DataFrame(of_events)


def test_a_population_written_by_hand():
    found = selection.terms(frame_of(), pandas.Series(Z), "prey", 30.0)
    assert {key: found[key] for key in PREY} == pytest.approx(PREY, abs=1e-12)
    predators = selection.terms(
        frame_of(), pandas.Series(Z), "predator", 30.0
    )  # a parent of another species: a newcomer
    assert (predators["newcomers", "all"], predators["mutation", "all"], predators["change", "all"]) == pytest.approx(
        (0.5, 0.0, 0.5)
    )


def test_two_parents_count_half_each():
    lists = {2: "[0,1]", 9: "[0]"}
    events = frame_of().assign(parents=lambda frame: frame["id"].map(lists).fillna("[none]"))
    found = selection.terms(
        events, pandas.Series(Z), "prey", 30.0
    )  # 2 is as the mean of its parents, which is that of the living
    changed = {
        ("parenthood", "all"): 0.0,
        ("mutation", "all"): 0.0,
        ("mutation_a_birth", "all"): 0.0,
        ("lives", "all"): 2.0 - 3.4,
    }
    assert {key: found[key] for key in PREY} == pytest.approx(PREY | changed, abs=1e-12)
    births = events[events["event"] == "birth"]
    assert selection.descent_of(births)["share"].tolist() == [0.5, 0.5, 1.0]


def test_who_lacks_the_trait_never_lived_and_a_trait_that_does_not_vary_is_exactly_zero():
    lacking = {id: z for id, z in Z.items() if id != 1}
    found = selection.terms(frame_of(), pandas.Series(lacking), "prey", 30.0)
    assert (found["start", "all"], found["parenthood", "all"], found["change", "all"]) == pytest.approx((1.0, 0.0, 4.0))
    same = selection.terms(frame_of(), pandas.Series(0.1, index=list(Z)), "prey", 30.0)
    assert [same[kind, "all"] for kind in ("change", *selection.KINDS)] == [0.0] * 6
    nobody = selection.terms(frame_of(), pandas.Series(Z).iloc[:0], "prey", 30.0)
    assert numpy.isnan(nobody["change", "all"]) and nobody["survival", "all"] == 0.0


def simulated(rng, runs, steps, survival=0.0, parenthood=0.0, mutation=0.0, size=12):
    """Populations in which at each step one dies, by exp(-survival z), and one is born: a newcomer once in three, else the offspring of one of the
    living, drawn by exp(parenthood z), with a mutation of mean `mutation`. Returns step, z and parent_z as selection.price takes them.
    """
    living = rng.normal(size=(runs, size))
    rows = numpy.arange(runs)
    z, parent_z, step = [*living.T.copy()], [numpy.full(runs, numpy.nan)] * size, [1] * size
    for _ in range(steps):

        def drawn(by):
            return (by * living + rng.gumbel(size=living.shape)).argmax(axis=1) if by else rng.integers(size, size=runs)

        dies = drawn(-survival)
        z.append(living[rows, dies])
        living[rows, dies] = -numpy.inf if parenthood > 0 else living[rows, dies]
        whose = drawn(parenthood)
        whose = numpy.where(whose == dies, (dies + 1) % size, whose)
        parent = living[rows, whose]
        is_new = rng.random(runs) < 1 / 3
        child = numpy.where(is_new, rng.normal(size=runs), parent + rng.normal(mutation, 0.2, size=runs))
        living[rows, dies] = child
        z.append(child)
        parent_z += [numpy.full(runs, numpy.nan), numpy.where(is_new, numpy.nan, parent)]
        step += [-1, 1]
    return numpy.broadcast_to(step, (runs, len(step))), numpy.array(z).T, numpy.array(parent_z).T


@pytest.mark.parametrize("planted", [{}, {"survival": 0.15}, {"parenthood": 0.2}, {"mutation": 0.04}])
def test_planted_effects_are_found_where_they_are_and_nowhere_else(planted):
    """1000 sets of ten runs each, in which age and origin do not matter: the test of each term at 5 %."""
    step, z, parent_z = simulated(numpy.random.default_rng(11), 10_000, 80, **planted)
    parts, mean = selection.price(step, z, parent_z)
    sums = numpy.nansum(parts[..., 12:], axis=-1)
    assert sums.sum(axis=0) == pytest.approx(mean[:, -1] - mean[:, 11], abs=1e-9)
    of_sets = sums[:4].reshape(4, 1000, 10)
    t = of_sets.mean(axis=-1) / (of_sets.std(axis=-1, ddof=1) / 10**0.5)
    found = dict(zip(selection.KINDS, (2 * special.stdtr(9, -abs(t)) <= 0.05).mean(axis=-1)))
    for kind in selection.TESTED:
        assert found[kind] >= 0.8 if kind in planted else found[kind] <= 0.07, (kind, found)


def structured(rng, runs, survival=0.0, parenthood=0.0, size=14, steps=120):
    """Sums of the terms of runs in which the young and the random die more, and only those older than four steps beget: by price without and with the
    weights by age and origin, (runs, 5) each."""
    found = []
    for _ in range(runs):
        z, origin, born, parents = [*rng.standard_normal(size)], [0] * size, [0.0] * size, [-1] * size
        living, events = list(range(size)), [(1, one, 0.0) for one in range(size)]
        for step in range(1, steps + 1):
            those = numpy.array(living)
            traits, age = numpy.array(z)[those], step - numpy.array(born)[those]
            weight = numpy.exp(-survival * traits) * numpy.where(age < 8, 3.0, 1.0)
            weight *= numpy.where(numpy.array(origin)[those] > 0, 1.0, 3.0)
            dead = living.pop(int(numpy.searchsorted(numpy.cumsum(weight) / weight.sum(), rng.random())))
            events.append((-1, dead, float(step)))
            old = [one for one in living if step - born[one] > 4] if rng.random() > 1 / 3 else []
            if old:
                chance = numpy.cumsum(numpy.exp(parenthood * numpy.array(z)[old]))
                parents.append(old[int(numpy.searchsorted(chance / chance[-1], rng.random()))])
            else:
                parents.append(-1)
            z.append(z[parents[-1]] + 0.3 * rng.standard_normal() if old else rng.standard_normal())
            origin.append(int(bool(old)))
            born.append(float(step))
            living.append(len(z) - 1)
            events.append((1, len(z) - 1, float(step)))
        step, place, time_s = (numpy.array(of) for of in zip(*events))
        of_all, parents = numpy.array(z), numpy.array(parents)
        deaths, births = numpy.flatnonzero(step < 0), numpy.flatnonzero((step > 0) & (parents[place] >= 0))
        choices = [(deaths, place[deaths], 1.0 + 0.0 * deaths), (births, parents[place[births]], 1.0 + 0.0 * births)]
        parent_z = numpy.where((step > 0) & (parents[place] >= 0), of_all[parents[place]], numpy.nan)
        expected = selection.expected_of(step, place, time_s, numpy.array(origin), of_all, choices)
        sums = [
            numpy.nansum(selection.price(step, of_all[place], parent_z, due)[0], axis=1) for due in (None, expected)
        ]
        assert sums[0].sum() == pytest.approx(sums[1].sum(), abs=1e-9)
        found.append(sums)
    return numpy.array(found).transpose(1, 0, 2)


def found_over(rng, ours, null, sets=3000):
    """The share of sets of ten runs, drawn from these, in which each term differs from the null's, p <= 0.05."""
    a, b = (of[rng.integers(len(of), size=(10, sets))].reshape(10, -1) for of in (ours, null))
    with numpy.errstate(all="ignore"):
        p = arrays.p_value(arrays.contrast((1.0, arrays.moments(a)), (-1.0, arrays.moments(b))))
    return dict(zip(selection.KINDS, (p.reshape(sets, -1) <= 0.05).mean(axis=0)))


def test_selection_by_survival_and_by_parenthood_are_not_mistaken_for_each_other_where_age_and_origin_matter():
    """Over the neutral null. By the plain mean of the living, parenthood looks like survival."""
    rng = numpy.random.default_rng(23)
    neutral, by_survival, by_parenthood = (
        structured(rng, runs, *planted) for runs, *planted in ((400,), (200, 0.35, 0.0), (200, 0.0, 0.8))
    )
    nothing = found_over(rng, neutral[1][:200], neutral[1][200:])
    assert max(nothing[kind] for kind in selection.TESTED) <= 0.07, nothing
    found = found_over(rng, by_parenthood[1], neutral[1])
    assert found["parenthood"] >= 0.8 and found["survival"] <= 0.07 and found["mutation"] <= 0.07, found
    assert found_over(rng, by_parenthood[0], neutral[0])["survival"] >= 0.15
    found = found_over(rng, by_survival[1], neutral[1])
    assert found["survival"] >= 0.8 and found["parenthood"] <= 0.07 and found["mutation"] <= 0.07, found


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    if PROGRAM is None:
        pytest.skip("TROPHIC_PREDATOR_PREY names no program")
    folder = tmp_path_factory.mktemp("selection") / "runs"
    subprocess.run(
        [
            PROGRAM,
            "--backend",
            "kinematic",
            "--duration",
            "600",
            "--replicates",
            "6",
            "--shadow",
            "--neutral",
            "--out",
            folder,
        ],
        check=True,
        capture_output=True,
    )
    return folder


def test_a_stranger_finds_the_same_to_the_digit(runs):
    frame, _, _ = selection.analyse([runs / "replicate-00"], ["gene:4"])
    of_run = frame[frame.period == "all"].set_index(["species", "term"]).runs_mean
    theirs = strangers_price(runs / "replicate-00", "w4")
    assert of_run.to_dict() == pytest.approx(theirs, abs=1e-12)


def test_the_command_has_shadow_and_neutral_null_next_to_the_runs(runs, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    request = {
        "who": "trophic analyze",
        "runs": [str(runs)],
        "selection": ["turns_to", "velocity_open", "open_speed", "agents.csv:tag:1"],
        "out": "found",
        "jobs": 1,
    }
    assert selection.run(request) == 0
    printed = capsys.readouterr().out
    assert (
        "neutral: paper with heredity = neutral_own_copy" in printed
        and "predator, turns_to" in printed
        and "24 comparisons" in printed
    )
    table = pandas.read_csv("found/selection.csv")
    tested = table[table.p.notna()]
    assert set(tested.null) == {"neutral"} and (table.runs_n <= 6).all() and len(tested) == 24
    parts = table[table.period == "all"].pivot_table(index=["trait", "species"], columns="term", values="runs_mean")
    assert parts[list(selection.KINDS)].sum(axis=1).to_numpy() == pytest.approx(parts.change.to_numpy(), abs=1e-9)
    thirds = table[(table.term == "survival") & (table.period != "all")].groupby(["trait", "species"]).runs_mean.sum()
    assert thirds.to_numpy() == pytest.approx(parts.survival.to_numpy(), abs=1e-9)


def test_the_inputs_of_turns_to(tmp_path):
    """A brain that looks at the side alone turns to it; its opposite turns away; a third always turns right."""
    rows = [
        [id, id, 0, *weights]
        for id, weights in enumerate([[1, 0, 0] * 3 + [1] * 6, [-1, 0, 0] * 3 + [1] * 6, [0, 1, 0] * 3 + [1] * 6])
    ]
    genomes = pandas.DataFrame(rows, columns=["id", "genome_id", "time_s", *(f"w{i}" for i in range(15))])
    rules = {"brain": "cognitive_brain", "sensors": "side_of_adversary + distance_over_terrain + tag_ratio_of_all"}
    folder = write_run(tmp_path / "run", files={"genomes.csv": genomes}, rules=rules)
    (run,), _ = selection.pool.pooled_runs([folder], Measuring())
    assert selection.trait_of("turns_to").read(run).tolist() == [1.0, 0.0, 0.5]


def test_behaviour_is_measured_away_from_walls(tmp_path):
    rows = [
        robot(tick, id, "prey", x_m, 0.0)
        for tick, places in enumerate([(1.0, 8.5), (1.2, 8.9), (1.6, 9.4)])
        for id, x_m in enumerate(places)
    ]
    folder = write_run(
        tmp_path / "run",
        of_agents=rows,
        of_events=[*EVENTS[:2], event("death", 4, 1, "prey", cause="diverged")],
        until_s=4.0,
    )
    (run,), _ = selection.pool.pooled_runs([folder], Measuring())
    assert selection.measure(["open_speed"], run)["open_speed", "prey", "missing", "all"] == 1
    assert selection.trait_of("open_speed").read(run).to_dict() == pytest.approx({0: 0.15, 1: 0.2})


@pytest.mark.parametrize(
    "trait, why",
    [
        ("turns", "--selection turns: must be turns_to"),
        ("turns_to:2", "--selection turns_to:2: must be"),
        ("gene:brain", "--selection gene:brain: must be"),
        ("../x.csv:a", "--selection ../x.csv:a: must be"),
        ("genomes.csv:w0", "runs/replicate-00/genomes.csv: cannot be read"),
        ("agents.csv:height", 'runs/replicate-00/agents.csv:1: no column "height"'),
        ("turns_to", "--selection turns_to: runs/replicate-00: brain = unknown"),
    ],
)
def test_traits_that_are_not_there_are_refused(trait, why, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_set("runs", shadow=False)
    with pytest.raises(RunError, match="^" + why.replace("(", r"\(")):
        selection.analyse(["runs"], [trait], how=Measuring(jobs=1))


def test_runs_without_their_beginning_and_another_neutral_null_are_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_run("late", of_events=EVENTS[4:5])
    with pytest.raises(RunError, match="late/events.csv: individual 1 dies but was never born"):
        selection.analyse(["late"], ["agents.csv:tag"])
    write_set("runs", shadow=False)
    write_set(pathlib.Path("runs/neutral"), shadow=False)
    with pytest.raises(
        RunError,
        match="runs/neutral/replicate-00: is not a neutral null of runs/replicate-00: its rule in slot heredity is own_copy",
    ):
        selection.analyse(["runs"], ["agents.csv:tag"])
