# SPDX-License-Identifier: MIT
"""Results of the four worlds of the pond, from values of single runs, and activity in a hand-written run."""
import pathlib

import numpy
import page_tables.ponds
import pandas
import ponds
import pytest
from scipy import stats

RUNS = [f"{run:02}" for run in range(12)]


def values_of(effects, lives_s=(), end_s=100.0):
    """Values of runs in which velocities differ from those of one-sided worlds by these (world, species): m/s, and both species live so long."""
    rng, rows = numpy.random.default_rng(1), []
    for world in ponds.WORLDS:
        for run in RUNS:
            for species, key in ponds.TESTED.items():
                rows.append(
                    ponds.row_of(world, run, "", key, effects.get((world, species), 0.0) + rng.normal(0, 0.001))
                )
                rows.append(ponds.row_of(world, run, ponds.one_sided(key), key, rng.normal(0, 0.001)))
        for run, life_s in zip(RUNS, dict(lives_s).get(world, [end_s] * len(RUNS))):
            rows.append(ponds.row_of(world, run, "", ("persists", "all", "all"), float(life_s >= end_s)))
            if life_s < end_s:
                rows.append(ponds.row_of(world, run, "", ("extinct_at", "predator", "all"), life_s))
                rows.append(ponds.row_of(world, run, "", ("extinct_at", "prey", "all"), life_s + 1.0))
    return rows


def found(rows):
    return {(row["set"], row["species"]) for row in rows if row["p_holm"] and float(row["p_holm"]) <= 0.05}


def test_what_evolves_is_found_where_it_is_planted_and_nowhere_else():
    values = ponds.Values(values_of({(ponds.BY_AGE, "prey"): -0.01, (ponds.AS_SHIPPED, "predator"): 0.01}))
    rows = ponds.evolved(values)
    assert len(rows) == 8
    assert found(rows) == {(ponds.BY_AGE, "prey"), (ponds.AS_SHIPPED, "predator")}
    for row in rows:
        bounds = [
            float(row[name]) for name in ("together_lower", "difference_lower", "difference_upper", "together_upper")
        ]
        assert bounds == sorted(bounds)
    assert found(ponds.contrasted(values)) == {("protection by age, not distance", "prey"), ("no protection", "prey")}


def test_a_difference_that_both_worlds_have_is_no_effect_of_their_condition():
    values = ponds.Values(values_of({(world, "prey"): -0.01 for world in ponds.WORLDS}))
    assert len(found(ponds.evolved(values))) == 4
    assert not found(ponds.contrasted(values))


def test_lives_end_with_the_first_species_and_those_of_runs_that_live_on_are_censored():
    early = [10.0, 20.0, 30.0] * 3 + [100.0] * 3
    values = ponds.Values(values_of({}, [(ponds.NONE_INACTIVE, early)]))
    lives = values.lives(ponds.NONE_INACTIVE, 100.0)
    assert sorted(lives.ends_s) == sorted(early) and lives.died.sum() == 9
    rows = {row["set"]: row for row in ponds.survived(values, 100.0)}
    assert float(rows["no protection"]["difference"]) == pytest.approx(-60.0)
    assert float(rows["no protection"]["p_holm"]) < 0.01
    assert rows["only the active breed"]["p_holm"] == ""
    shares = {row["set"]: row for row in ponds.described(values) if row["metric"] == "persists"}
    assert float(shares[ponds.NONE_INACTIVE]["mean"]) == 0.25
    assert float(shares[ponds.NONE_INACTIVE]["lower"]) == pytest.approx(0.0549, abs=1e-3)


def test_activity_is_of_prey_that_are_born_in_the_run(tmp_path):
    (tmp_path / "agents.csv").write_text(
        "time_s,id,species,active\n0,0,prey,0\n0,1,predator,1\n12,0,prey,1\n12,1,predator,1\n24,0,prey,1\n24,2,prey,0\n"
        "36,0,prey,1\n36,2,prey,0\n48,0,prey,1\n48,2,prey,0\n48,3,prey,1\n"
    )
    (tmp_path / "events.csv").write_text(
        "time_s,event,id,species\n0,birth,0,prey\n0,birth,1,predator\n20,birth,2,prey\n46,birth,3,prey\n"
    )
    of = {metric: value for (metric, *_), value in ponds.activity_of(tmp_path).items()}
    assert of == pytest.approx({"inactive_share": 4 / 9, "inactive_s": 18.0})


def test_a_table_shows_the_intervals_that_hold_for_the_whole_family():
    rows = ponds.results(values_of({(ponds.BY_AGE, "prey"): -0.01}), 100.0)
    row = next(
        row for row in rows if (row["set"], row["family"], row["species"]) == (ponds.BY_AGE, "behaviour", "prey")
    )
    cell = "{:+.2f} [{:+.2f}, {:+.2f}]".format(
        *(100 * float(row[name]) for name in ("difference", "together_lower", "together_upper"))
    )
    assert cell in page_tables.ponds.worlds(rows)


def test_published_results_are_those_of_scipy_from_the_published_values():
    data = pathlib.Path(ponds.__file__).resolve().parents[1] / "results/data"
    rows = {}
    for name in ("no_criterion", "no_criterion_selection"):
        values = pandas.read_csv(data / f"{name}_runs.csv", dtype={"null": str}).fillna({"null": ""})
        of = {key: group["value"] for key, group in values.groupby(["set", "null", "metric", "species", "group"])}
        for row in pandas.read_csv(data / f"{name}.csv").query("family in ('behaviour', 'selection')").itertuples():
            ours, theirs = (of[row.set, null, row.metric, row.species, row.group] for null in ("", row.null))
            assert len(ours) == len(theirs) == 30
            assert row.difference == pytest.approx(ours.mean() - theirs.mean(), rel=1e-4)
            assert row.p == pytest.approx(stats.ttest_ind(ours, theirs, equal_var=False).pvalue, rel=1e-4)
            rows.setdefault(row.family, []).append((row.p, row.p_holm))
    assert {family: len(of) for family, of in rows.items()} == {"behaviour": 8, "selection": 16}
    for of in rows.values():
        last = 0.0
        for rank, (p, p_holm) in enumerate(sorted(of)):
            last = max(last, min(1.0, (len(of) - rank) * p))
            assert p_holm == pytest.approx(last, rel=1e-4)
