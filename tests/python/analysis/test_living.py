# SPDX-License-Identifier: MIT
"""Worlds whose numbers change: each metric on populations of which the answer is known, and the rates of errors of their intervals and tests."""
import json
import math
import os
import subprocess

import numpy
import pandas
import pytest
from hand_written import WEB, event, events, robot, write_run, write_set
from scipy import signal, stats
from sets import metric, quick_set, set_of
from trophic import judge, pool, statistics
from trophic.metrics import Measuring, mean_field
from trophic.metrics.census import Census, dynamics, extinctions, responses
from trophic.metrics.cycles import autocorrelation, cycle_of, red_noise
from trophic.metrics.living import phase
from trophic.report import tables
from trophic.statistics import interval_of_mean, share_difference, share_interval, survival

NAN = math.nan


def test_the_census_counts_who_lives_and_who_is_caught_at_each_tick():
    census = Census(
        events(
            *(event("birth", 0, i, "prey") for i in range(3)),
            event("birth", 0, 3, "predator"),
            event("catch", 2, 3, "predator", victim_id=1),
            event("death", 2, 1, "prey", cause="caught"),
            event("birth", 4, 4, "prey"),
            event("death", 6, 3, "predator", cause="starved"),
        ),
        WEB,
        2.0,
        8.0,
    )
    assert census.numbers.tolist() == [[3, 2, 3, 3, 3], [1, 1, 1, 0, 0]] and census.catches.tolist() == [
        [0, 1, 0, 0, 0]
    ]
    assert (census.deaths - census.caught).tolist() == [[0] * 5, [0, 0, 0, 1, 0]]
    assert (
        extinctions(numpy.array([[1, 0, 1], [1, 1, 0], [0, 0, 0]])).tolist() == [3, 2, 3]
        and dynamics(census.numbers[1])[0] == 3
    )


@pytest.mark.parametrize("memory, points", [(0, 150), (3, 150), (20, 300)])
def test_at_most_8_percent_of_series_of_noise_have_a_cycle(memory, points):
    rng = numpy.random.default_rng(points + memory)
    found = [cycle_of(100.0 + series, 59, i).is_there for i, series in enumerate(red_noise(memory, points, 300, rng))]
    assert numpy.mean(found) <= 0.08


@pytest.mark.parametrize("coherence, error", [(1.0, 0.01), (0.98, 0.1)])
def test_the_period_and_amplitude_of_cycles_with_noise(coherence, error):
    rng, period = numpy.random.default_rng(1), 37.0
    turn = 2.0 * math.pi / period
    for _ in range(10):
        wave = (
            signal.lfilter([1.0], [1.0, -2.0 * coherence * math.cos(turn), coherence**2], rng.standard_normal(900))[
                500:
            ]
            if coherence < 1.0
            else (
                math.sqrt(2.0) * numpy.sin(turn * (numpy.arange(400) + rng.uniform(0.0, period)))
                + 0.3 * rng.standard_normal(400)
            )
        )
        cycle = cycle_of(10.0 + wave / wave.std())
        assert cycle.period == pytest.approx(period, rel=3.0 * error) and cycle.amplitude == pytest.approx(
            0.1 * math.sqrt(2.0), rel=0.2 if error < 0.1 else 0.6
        )
        assert phase(10.0 + wave, 10.0 + numpy.roll(wave, 9), cycle.period) == pytest.approx(9 / period, abs=0.05)
    assert math.isnan(cycle_of(numpy.ones(100)).p) and autocorrelation(numpy.arange(30.0) + [0.0, 1.0] * 15)[1] < -0.8


@pytest.mark.parametrize("handling_s", [0.0, 12.0])
def test_functional_responses_and_the_coverage_of_their_intervals_over_runs(handling_s):
    rng, search = numpy.random.default_rng(4), 3e-4
    inside, means = [], []
    for _ in range(40):
        values = []
        for noise in red_noise(20.0, 300, 6, rng):
            prey = numpy.maximum(1.0, numpy.rint(100.0 * numpy.exp(0.2 * noise)))
            values.append(
                responses(prey, numpy.full(300, 20.0), rng.poisson(20.0 / (1.0 / (search * prey) + handling_s)))[1:]
            )
        intervals = [interval_of_mean(of) for of in numpy.transpose(values)]
        inside.append([each.lower <= truth <= each.upper for each, truth in zip(intervals, (1.0 / search, handling_s))])
        means.append(numpy.mean(values, axis=0))
    assert (numpy.mean(inside, axis=0) >= 0.85).all()
    assert numpy.mean(means, axis=0) == pytest.approx((1.0 / search, handling_s), rel=0.05, abs=1.0)
    assert numpy.isnan(responses(numpy.ones(5), numpy.ones(5), numpy.zeros(5))).all()


def test_shares_of_runs_have_exact_intervals_and_tests_that_err_as_seldom_as_they_say():
    for n in (6, 10, 20):
        for k in (0, 1, n // 2, n):
            interval = stats.binomtest(k, n).proportion_ci(method="exact")
            assert share_interval([1.0] * k + [0.0] * (n - k)) == pytest.approx((interval.low, interval.high))
            found = share_difference([1.0] * k + [0.0] * (n - k), [1.0] * (n - k) + [0.0] * k)
            assert found.p == pytest.approx(stats.fisher_exact([[k, n - k], [n - k, k]])[1])
    rng = numpy.random.default_rng(2)
    for share, other in ((0.9, 0.9), (0.5, 0.5), (0.9, 0.5)):
        found = [share_difference(*(rng.random(10) < of for of in (share, other))) for _ in range(400)]
        assert numpy.mean([each.interval.lower <= share - other <= each.interval.upper for each in found]) >= 0.94
        assert share != other or numpy.mean([(each.p or 1.0) <= 0.05 for each in found]) <= 0.05
    assert share_interval([1.0] * 5) is None and share_difference([1.0] * 6, [1.0] * 6).p is None
    assert [statistics.is_by_chance(many, 10) for many in (0, 1, 2, 3)] == [True, True, True, False]


def test_survival_with_runs_that_end_before_the_species_dies_out():
    rows = survival([3, 5, 5, 8, 9, 12], [True, True, False, True, False, False])
    assert [row[:3] for row in rows] == [(3, 6, 1), (5, 5, 1), (8, 3, 1)]
    assert [row[3] for row in rows] == pytest.approx([5 / 6, 2 / 3, 4 / 9])
    rng, inside = numpy.random.default_rng(6), []
    for _ in range(400):
        dies, ends = rng.exponential(1000.0, 20), rng.uniform(500.0, 2000.0, 20)
        *_, last = [row for row in survival(numpy.minimum(dies, ends), dies <= ends) if row[0] <= 700.0]
        inside.append(last[4] <= math.exp(-0.7) <= last[5])
    assert numpy.mean(inside) >= 0.92


def well_mixed(
    rng,
    ticks=1500,
    prey=240,
    hunters=100,
    capacity=600.0,
    born=0.05,
    dies=0.02,
    meets=3e-4,
    handling=12.0,
    converts=0.5,
):
    """Numbers and events of an independent program of Rosenzweig and MacArthur's world, as a Census."""
    census = Census(events(event("birth", 0, 0, "prey")), WEB, 1.0, float(ticks))
    for name in ("births", "deaths", "caught", "numbers", "catches"):
        setattr(census, name, numpy.zeros((1 if name == "catches" else 2, ticks + 1), int))
    census.numbers[:, 0] = census.births[:, 0] = prey, hunters
    for tick in range(1, ticks + 1):
        n, p = census.numbers[:, tick - 1]
        caught = min(n, rng.poisson(p * meets * n / (1.0 + meets * handling * n)))
        census.births[:, tick] = rng.poisson(born * n * max(0.0, 1.0 - n / capacity)), rng.binomial(caught, converts)
        census.deaths[:, tick] = caught, rng.binomial(p, dies)
        census.caught[0, tick] = census.catches[0, tick] = caught
        census.numbers[:, tick] = census.numbers[:, tick - 1] + census.births[:, tick] - census.deaths[:, tick]
    return census


def test_the_mean_field_of_a_world_that_is_well_mixed_is_that_world():
    rng = numpy.random.default_rng(3)
    worlds = [well_mixed(rng) for _ in range(6)]
    rates = [mean_field.rates_of(world) for world in worlds]
    assert numpy.mean([rate.births[0] for rate in rates], axis=0) == pytest.approx([0.05, -0.05 / 600.0], rel=0.1)
    assert numpy.mean(
        [[rate.births[1, 0], rate.deaths[1, 0], *rate.waits[0]] for rate in rates], axis=0
    ) == pytest.approx([0.5, 0.02, 1 / 3e-4, 12.0], rel=0.1)
    series, step_s = mean_field.simulate(rates[0], worlds[0], 10_000, 20, rng, 1500.0)
    assert step_s == 1.0 and series[..., 500:].mean(axis=(1, 2)) == pytest.approx(
        numpy.mean([world.numbers[:, 500:].mean(axis=1) for world in worlds], axis=0), rel=0.1
    )
    assert mean_field.means_of(worlds[0], 10_000, 1, 1500.0)["persists", "all"] == 1.0
    extinct = well_mixed(rng, capacity=1600.0, prey=500)  # cycles grow until one dies out
    assert mean_field.means_of(extinct, 10_000, 1, 1500.0)["persists", "all"] <= 0.5


def early_set(folder):
    """Four runs of 1000 s in which a prey and a predator live; in the last two the predator dies at 300 s, which ends them by ecology.ends_when."""
    lives = (event("birth", 0, 0, "prey"), event("birth", 0, 1, "predator"))
    table = "id,ancestor_list,origin_time,destruction_time,species\n0,[none],0,inf,prey\n1,[none],0,inf,predator\n"
    for seed in (1, 2, 3, 4):
        end_s, more = (1000.0, {}) if seed < 3 else (300.0, {"ended": "gone: predator"})
        write_run(
            folder / str(seed),
            seed,
            until_s=1000.0,
            of_events=(*lives, *[event("death", 300, 1, "predator", cause="starved")] * (seed > 2)),
            of_agents=[robot(tick, 0, "prey") for tick in range(0, int(end_s / 2) + 1, 10)],
            files={"phylogeny.csv": table},
            rules={"heredity": "own_copy", "recruitment": "at_energy"},
            result={"reached_s": end_s, **more},
            clock={"until_s": 1000.0, "tick_s": 2.0},
            params={"seed": seed},
        )
    return [folder / str(seed) for seed in (1, 2, 3, 4)]


def test_runs_that_end_early_count_for_what_they_lived(tmp_path):
    measured = pool.read_set(early_set(tmp_path), how=Measuring(jobs=1))
    assert [run.lived_s for run in measured.runs] == [1000.0, 1000.0, 300.0, 300.0]
    assert [remark for remark in measured.remarks if "early" in remark] == [
        "2 of 4 runs ended early, by ecology.ends_when, after 300 s: metrics, windows and halves cover the time that each run lasted; persists omits the species that were alive at its end"
    ]
    each = {
        one: measured.table[metric("persists", one)._replace(unit="1"), ""].tolist()
        for one in ("all", "prey", "predator")
    }
    numpy.testing.assert_equal(each, {"all": [1, 1, 0, 0], "prey": [1, 1, NAN, NAN], "predator": [1, 1, 0, 0]})
    curves = [of.curves[of.curves.metric == "persists"] for of in measured.values]
    assert [len(curve[curve.species == "prey"]) for curve in curves] == [5, 5, 2, 2]
    gone = curves[3][curves[3].species == "predator"]
    assert gone.time_s.tolist() == [200, 400, 600, 800, 1000] and gone.value.tolist() == [1, 0, 0, 0, 0]
    deaths = measured.values[3].curves
    assert deaths[
        (deaths.metric == "deaths") & (deaths.group == "all") & (deaths.species == "prey")
    ].time_s.tolist() == [200, 400]
    assert (
        pool.read_set(early_set(tmp_path / "cut"), how=Measuring(until_s=600.0, jobs=1)).until_s == 600.0
    )  # those that ended earlier are not refused
    rows = tables.survivals(measured)
    assert rows[["species", "time_s"]].values.tolist() == [["predator", 300.0]]


def halving(rng, runs, endows, first_J=6.0):
    """Runs of a world without space in which who has 10 J gives half to an offspring; mean number, energy a head, and whether it lives at the end.
    Genomes, which change nothing, are not modelled. If not `endows`, an offspring begins as a founder, as in a shadow that hands over nothing.
    """
    energy = numpy.where(numpy.arange(120) < 40, first_J, NAN) * numpy.ones((runs, 1))
    numbers, stocks = [], []
    for _ in range(60):
        alive = ~numpy.isnan(energy)
        eats = rng.random(energy.shape) < 0.5 * 40.0 / numpy.maximum(40.0, alive.sum(axis=1, keepdims=True))
        energy += 4.0 * eats - 1.2
        energy[~(energy >= 0.0)] = NAN
        bears = energy >= 10.0
        energy[bears] /= 2.0
        for run, place in zip(*numpy.nonzero(bears)):
            if len(free := numpy.flatnonzero(numpy.isnan(energy[run]))):
                energy[run, free[0]] = energy[run, place] if endows else first_J
        numbers.append((~numpy.isnan(energy)).sum(axis=1))
        stocks.append(numpy.nansum(energy, axis=1) / numpy.maximum(1, numbers[-1]))
    return {
        metric("population"): numpy.mean(numbers, axis=0),
        metric("stock"): numpy.mean(stocks, axis=0),
        metric("persists"): (numbers[-1] > 0).astype(float),
    }


def found(ours, null, sets=100, runs=8):
    """The share of sets of runs in which the judge finds a difference from the null."""

    def part(of, i):
        return quick_set({name: values[i * runs : (i + 1) * runs] for name, values in of.items()})

    return numpy.mean(
        [judge.count(judge.summarize(_with(part(ours, i), part(null, i)))).significant > 0 for i in range(sets)]
    )


def _with(of, shadow):
    of.shadow = shadow
    return of


def test_a_world_whose_parents_give_half_of_their_energy_differs_from_its_shadow_in_at_most_7_of_100_analyses():
    rng = numpy.random.default_rng(11)
    ours = halving(rng, 800, True)
    assert found(ours, halving(rng, 800, True)) <= 0.07
    assert found(ours, halving(rng, 160, False), 20) >= 0.9  # a shadow that hands over another energy is another world


@pytest.fixture(scope="module")
def wolf_sheep(tmp_path_factory):
    if (program := os.environ.get("TROPHIC_WORLDS")) is None:
        pytest.skip("TROPHIC_WORLDS names no program")
    folder = tmp_path_factory.mktemp("runs") / "wolf_sheep"
    subprocess.run(
        [
            program,
            "--rules",
            "wolf_sheep",
            "--backend",
            "torus",
            "--replicates",
            "6",
            "--duration",
            "60",
            "--replay-hz",
            "0",
            "--checkpoint-s",
            "0",
            "--shadow",
            "--clones",
            "--agents-every",
            "1000",
            "--out",
            folder,
        ],
        check=True,
        capture_output=True,
    )
    return folder


def test_genomes_that_do_nothing_leave_shadow_and_clones_to_the_byte_as_the_runs(wolf_sheep):
    for null in ("shadow", "clones"):
        for file in ("events.csv", "energy.csv", "resource.csv"):
            assert (wolf_sheep / null / "replicate-03" / file).read_bytes() == (
                wolf_sheep / "replicate-03" / file
            ).read_bytes()
    assert (
        json.loads((wolf_sheep / "clones/replicate-03/manifest.json").read_text())["rules"]["heredity"]
        == "one_genome_for_all"
    )
    measured = pool.read_set([wolf_sheep], how=Measuring(jobs=1))
    frame = judge.summarize(measured)
    assert (
        judge.count(frame).significant == 0
        and {*frame["null"]} >= {"shadow", "clones", "mean_field"}
        and not (frame[frame["null"] == "clones"].role == "null").any()
    )
    assert judge.living_sentences(measured)[0] == (
        "All species live to the end of 6 of 6 runs, a share of [0.541, 1.000] (shadow 6 of 6, clones 6 of 6, mean field 1.00)."
    )
    means = {f"{row.metric}:{row.species}": row.mean for row in frame[frame.group == "all"].itertuples()}
    assert (
        means["birth_rate:sheep"] == pytest.approx(0.04, rel=0.1)
        and means["parents:wolf"] == 1.0
        and 0.05 < means["trophic_efficiency:wolf"] < 1.0
    )
    assert "extinct:wolf" not in means and means["pyramid_numbers:sheep+wolf"] < 1.0


def test_clones_have_one_genome_a_run_that_no_birth_changes(wolf_sheep):
    arguments = [
        "--rules",
        "pond",
        "--backend",
        "kinematic",
        "--replicates",
        "2",
        "--duration",
        "100",
        "--replay-hz",
        "0",
        "--clones",
        "--agents-every",
        "50",
    ]
    subprocess.run(
        [os.environ["TROPHIC_WORLDS"], *arguments, "--out", wolf_sheep / "pond"], check=True, capture_output=True
    )
    genomes = [
        pandas.read_csv(wolf_sheep / "pond" / null / f"replicate-0{i}/genomes.csv").filter(regex="^w").drop_duplicates()
        for null in ("clones", ".")
        for i in (0, 1)
    ]
    assert (
        [len(each) for each in genomes[:2]] == [1, 1]
        and min(map(len, genomes[2:])) >= 60
        and genomes[0].to_numpy().tolist() != genomes[1].to_numpy().tolist()
    )
    assert genomes[0].iloc[0].tolist() == genomes[2].iloc[0].tolist()  # the first founder's


def test_runs_of_constant_numbers_have_none_of_these_metrics(tmp_path):
    measured = pool.read_set([write_set(tmp_path / "set")])
    assert (
        not {name.metric for name in measured.metrics()} & {"persists", "cycles", "birth_rate"}
        and judge.living_sentences(measured) == []
    )
    assert len(tables.survivals(measured)) == 0


def test_sentences_of_a_set_in_which_a_species_dies_out_and_the_other_cycles():
    of = {
        metric("persists", "all"): [1.0] * 6 + [0.0] * 4,
        metric("persists", "prey"): [1.0] * 10,
        metric("persists", "predator"): [1.0] * 6 + [0.0] * 4,
        metric("cycles"): [1.0] * 9 + [0.0],
        metric("period")._replace(unit="s"): [100.0, 120.0] * 5,
        metric("amplitude"): [0.5] * 10,
        metric("cycles", "predator"): [1.0] + [0.0] * 9,
    }
    assert judge.living_sentences(set_of(of)) == [
        "All species live to the end of 6 of 10 runs, a share of [0.262, 0.878].",
        "Predators live to the end of 6 of 10 runs, a share of [0.262, 0.878].",
        "Prey cycle in 9 of 10 runs, a share of [0.555, 0.997], with a period of 110 s [102, 118] and an amplitude of 0.50 [0.50, 0.50] of their mean.",
        "Predators cycle in no more runs than by chance: red noise explains their numbers in 9 of 10 runs.",
    ]
