# SPDX-License-Identifier: MIT
"""Error rates equal their nominal ones in ecologies without an effect: short kinematic runs that are all alike, and tags without a meaning."""
import os
import subprocess

import numpy
import pytest
from sets import quick_set
from trophic import judge, pool
from trophic.metrics import Measuring
from trophic.metrics.tags import bernoulli_symmetry, permuted_symmetry
from trophic.statistics import holm, interval_of_mean
from trophic.sweeps import arrays
from trophic.values import Metric

PROGRAM = os.environ.get("TROPHIC_PREDATOR_PREY")
HEADLINES = (
    "attribution_caught",
    "attribution_catches",
    "velocity",
    "wall_sticking",
)  # metrics of the paper for which 600 s suffice


@pytest.fixture(scope="module")
def pooled(tmp_path_factory):
    """The metrics of sixty short runs, all alike but for their seeds."""
    if PROGRAM is None:
        pytest.skip("TROPHIC_PREDATOR_PREY names no program")
    folder = tmp_path_factory.mktemp("runs") / "paper"
    subprocess.run(
        [
            PROGRAM,
            "--backend",
            "kinematic",
            "--replay-hz",
            "0",
            "--duration",
            "600",
            "--replicates",
            "60",
            "--out",
            folder,
        ],
        check=True,
        capture_output=True,
    )
    return pool.read_set([folder], how=Measuring(jobs=1)).matrix()


def draws(of, runs, trials, rng):
    """Rows of runs from a pool, none twice in a trial: (trials, runs, metrics)."""
    order = rng.random((trials, len(of))).argsort(axis=1)[:, :runs]
    return of.to_numpy()[order]


@pytest.mark.parametrize("runs", [6, 10])
def test_intervals_of_metrics_of_short_runs_leave_out_the_truth_in_5_percent_of_cases_within_2_5_points(pooled, runs):
    rng = numpy.random.default_rng(runs)
    values = pooled[[name for name in pooled if name[0] in HEADLINES and name[2] == "all"]]
    assert values.shape[1] >= 6 and values.notna().all(axis=None)
    drawn = values.to_numpy()[rng.integers(len(values), size=(8000, runs))]
    mean, error = drawn.mean(axis=1), drawn.std(axis=1, ddof=1) / runs**0.5
    half = error * arrays.t_quantile(0.975, runs - 1.0)
    outside = (numpy.abs(mean - values.to_numpy().mean(axis=0)) > half).mean(axis=0)
    assert (numpy.abs(outside - 0.05) <= 0.025).all(), dict(zip(values, outside))


def test_alike_runs_differ_in_at_most_7_percent_of_analyses_metric_by_metric_and_any_of_them_after_correction(pooled):
    rng = numpy.random.default_rng(5)
    names, trials = [Metric(*name) for name in pooled], 2000
    repeats = judge.repeated_values({name: pooled[name].to_numpy() for name in names})
    tested = [i for i, name in enumerate(names) if name not in repeats]
    single, any_found = numpy.zeros(len(names)), 0
    for trial, both in enumerate(draws(pooled, 20, trials, rng)):
        with numpy.errstate(all="ignore"):
            p = arrays.p_value(arrays.contrast((1.0, arrays.moments(both[:10])), (-1.0, arrays.moments(both[10:]))))
        single += p <= 0.05
        of_tested = p[tested][~numpy.isnan(p[tested])]
        any_found += holm(of_tested).min() <= 0.05
        if trial < 10:  # the judge says the same
            ours, null = (
                quick_set({name: half[:, i] for i, name in enumerate(names)}) for half in (both[:10], both[10:])
            )
            ours.shadow = null
            frame = judge.summarize(ours)
            numpy.testing.assert_allclose(frame["p"], p, rtol=1e-6)
            assert (len(judge.findings(frame)) > 0) == (judge.count(frame).significant > 0)
            raw = judge.compare(ours, null)
            assert judge.count(raw).comparisons == judge.count(frame).comparisons
    assert (single <= 0.07 * trials).all(), {name: share for name, share in zip(names, single / trials) if share > 0.07}
    assert any_found <= 0.07 * trials


def test_tags_that_say_nothing_about_the_species_differ_from_permuted_ones_in_5_percent_of_analyses_whatever_their_bias():
    """All robots of a run share one bias, which differs between runs, keep their tags for some ticks and draw them anew."""
    rng = numpy.random.default_rng(8)
    trials, runs, ticks, prey, robots = 1000, 10, 15, 13, 20
    share = rng.uniform(0.6, 0.95, (trials, runs, 1))
    plus = rng.random((trials, runs, robots)) < share
    observed, permuted = numpy.zeros((trials, runs)), numpy.zeros((trials, runs))
    by_number = permuted_symmetry([prey] * (robots + 1), [robots - prey] * (robots + 1), numpy.arange(robots + 1))
    for _ in range(ticks):
        drawn = rng.random(plus.shape) < share
        plus = numpy.where(rng.random(plus.shape) < 0.2, drawn, plus)
        of_prey, of_predators = plus[..., :prey].sum(axis=2), plus[..., prey:].sum(axis=2)
        observed += numpy.abs(2.0 * of_prey / prey - 1.0 + 2.0 * of_predators / (robots - prey) - 1.0) / ticks
        permuted += by_number[of_prey + of_predators] / ticks
    found = {
        name: numpy.mean(
            [not (interval := interval_of_mean(of)).lower <= 0.0 <= interval.upper for of in observed - null]
        )
        for name, null in (("permuted", permuted), ("bernoulli", bernoulli_symmetry(prey, robots - prey)))
    }
    assert 0.03 <= found["permuted"] <= 0.07
    assert found["bernoulli"] >= 0.9  # so Bernoulli(1/2) tags are not a null
