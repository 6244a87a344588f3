# SPDX-License-Identifier: MIT
"""Sweeps: grids, comparisons of cells, effects of axes, tables and texts; by hand, and their error rates by simulation."""
import dataclasses
import json
import math
import re
import shutil

import numpy
import pandas
import pytest
from hand_written import refusal, write_run
from in_folder import sealed_text
from pytest import approx
from trophic import statistics
from trophic.metrics import Measuring
from trophic.plan import seed_of
from trophic.report.columns import names as column_names
from trophic.runs import RunError
from trophic.sweeps import analyze_sweep, arrays, cells, is_sweep, report
from trophic.sweeps import runs as sweep_runs
from trophic.sweeps.cells import SweepValues, answers, compare_cells, runs_for_difference
from trophic.sweeps.effects import axis_effects
from trophic.sweeps.grid import PlannedRun, grid_of, is_paired, read_plan
from trophic.sweeps.report import SweepAnalysis
from trophic.sweeps.runs import Sweep, check_sweep, measure_sweep, read_sweep
from trophic.values import Metric

HUNGER, VELOCITY = Metric("hunger", "predator", "all", "ticks"), Metric("velocity", "prey", "all", "m/s")


def plan_of(
    count=2,
    replicates=2,
    with_shadow=False,
    paired=True,
    settings=lambda cell: {"ecology.duration_s": 6000.0, "x.y": 0.5 * cell},
):
    """A plan whose cells differ in x.y; seeds count from 100."""
    plan = []
    for cell in range(count):
        for shadow in (False, True)[: 1 + with_shadow]:
            for k in range(replicates):
                plan.append(
                    PlannedRun(
                        len(plan),
                        cell,
                        k,
                        "shadow" if shadow else "none",
                        "paper",
                        "kinematic",
                        settings(cell),
                        100 + k + (0 if paired else cell * replicates),
                        6000.0,
                        0.0,
                        1,
                        False,
                        False,
                        1.0,
                        f"cell-{cell}{'/shadow' if shadow else ''}/replicate-{k}",
                        f"f{cell}{'s' if shadow else ''}",
                    )
                )
    return plan


def plan_of_two_axes(replicates=6, with_shadow=False, paired=True):
    """a = 0, 1, 2 and b = 0, 1; cells are numbered a first."""
    return plan_of(6, replicates, with_shadow, paired, lambda cell: {"a": cell // 2, "b": cell % 2})


def values_of(plan, value, metric=HUNGER):
    return SweepValues([metric], numpy.array([[float(value(run))] for run in plan]), [True] * len(plan))


# Files beside the runs

TOML = """rule_table = "paper"
engine = "kinematic"
replicates = 2
seed = 5
[set]
ecology.duration_s = 6000.0
[grid]
x.y = [0.0, 0.5]
"""


@pytest.mark.parametrize(
    "file, old, new, why",
    [
        ("sweep.toml", "0.5]", "0.7]", "sweep.toml: has other settings than plan.jsonl: it was modified after"),
        ("sweep.toml", "seed = 5", "seed = 6", "sweep.toml: has other replicates, seeds or tables than plan.jsonl"),
        ("sweep.toml", "replicates = 2", "replicates = 1", "sweep.toml: has other replicates, seeds or tables"),
        ("sweep.toml", "[grid]", "[grid", "sweep.toml: is not TOML"),
        ("cell-1/replicates.json", "f1", "f2", "replicates.json: was cut short or modified after trophic wrote it"),
        ("cell-1/replicates.json", "}\n", "", "replicates.json: is not a JSON object"),
        ("cell-1/replicates.json", None, {"fingerprint": "f2"}, "must list replicate-0 with its seed and fingerprint"),
        ("cell-1/replicates.json", None, {"replicates": []}, "must list replicate-0 with its seed and fingerprint"),
        ("cell-1/replicates.json", None, {"replicates": 1}, "replicates: must be a list of folders"),
    ],
)
def test_files_beside_the_runs_are_those_of_the_plan(tmp_path, file, old, new, why):
    pytest.importorskip("tomllib")
    plan = [dataclasses.replace(run, seed=seed_of(5, run.replicate)) for run in plan_of()]
    (tmp_path / "sweep.toml").write_text(TOML)
    listed = {}
    for cell in (0, 1):
        (tmp_path / f"cell-{cell}").mkdir()
        runs = [{"folder": f"replicate-{k}", "seed": seed_of(5, k)} for k in (0, 1)]
        listed = {"format": 2, "fingerprint": f"f{cell}", "replicates": runs}
        (tmp_path / f"cell-{cell}/replicates.json").write_text(sealed_text(listed))
    sweep_runs._check_beside(tmp_path, plan)
    text = (tmp_path / file).read_text()
    (tmp_path / file).write_text(sealed_text({**listed, **new}) if old is None else text.replace(old, new))
    assert why in refusal(sweep_runs._check_beside, tmp_path, plan)


# Grids


def test_a_plans_cells_have_their_replicates_each_with_its_shadow():
    grid = grid_of(plan_of(3, 2, with_shadow=True))
    cell = grid.cells[1]
    assert (len(grid.cells), cell.number, cell.first.index, grid.place(2)) == (3, 1, 4, 2)
    assert [(one.seed, one.run, one.shadow) for one in cell.replicates] == [(100, 4, 6), (101, 5, 7)]
    assert refusal(grid.place, 3) == "reference = 3: must be a cell of the sweep, 0 to 2"


def test_axes_are_what_differs_between_cells():
    plan = plan_of(2, 1)
    assert [(axis.name, axis.values) for axis in grid_of(plan).axes] == [("x.y", ["0.0", "0.5"])]
    plan[1] = dataclasses.replace(
        plan[1], rule_table="released", settings={**plan[1].settings, "robot": "gecko", "flag": True}
    )
    grid = grid_of(plan)
    assert [(axis.name, axis.values) for axis in grid.axes] == [
        ("rule_table", ["paper", "released"]),
        ("x.y", ["0.0", "0.5"]),
        ("robot", ["", "gecko"]),
        ("flag", ["", "true"]),
    ]
    assert grid.cell_name(0) == "cell 0 (rule_table paper, y 0.0, robot unset, flag unset)"
    assert grid_of(plan_of(1)).axes == [] and grid_of(plan_of(1)).cell_name(0) == "cell 0"


def test_axes_that_end_alike_keep_their_paths():
    grid = grid_of(plan_of(2, 1, settings=lambda cell: {"a.sd": cell, "b.sd": 2 - cell}))
    assert grid.cell_title(1) == "a.sd 1, b.sd 1"


def test_cells_are_paired_by_seeds_all_of_them_or_none():
    paired, independent = grid_of(plan_of(2, 3)).cells, grid_of(plan_of(2, 3, paired=False)).cells
    assert is_paired(*paired) and not is_paired(*independent)
    more = dataclasses.replace(paired[1], replicates=[*paired[1].replicates, independent[1].replicates[0]])
    assert is_paired(paired[0], more)
    mixed = dataclasses.replace(paired[1], replicates=[independent[1].replicates[0], *paired[1].replicates[1:]])
    assert (
        refusal(is_paired, paired[0], mixed)
        == "cell 1 has 2 of 3 seeds in common with cell 0: must be all, to be compared seed by seed, or none"
    )


def write_plan(folder, plan):
    folder.mkdir(exist_ok=True)
    lines = [one if isinstance(one, dict) else dataclasses.asdict(one) for one in plan]
    (folder / "plan.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))


@pytest.mark.parametrize(
    "change, part",
    [
        ({"folder": "cell-0/shadow/replicate-0"}, ":4: folder = "),
        ({"folder": "../x"}, "must be a folder within that of the plan"),
        ({"rule_table": "released"}, ':4: rule_table = "released": must be "paper", as in the other runs of cell 0'),
        ({"until_s": 300.0}, ":4: until_s = 300.0: must be 6000.0, as in the other runs"),
        ({"until_s": 0}, ":4: until_s = 0: must be > 0 and <= 100000000"),
        ({"seed": -1}, ":4: seed = -1: must be a whole number >= 0"),
        ({"seed": 7}, ":4: seed = 7: must be 101, as a replicate and its nulls have one"),
        ({"seed": 100}, ":4: seed = 100: must be unique among the replicates of cell 0"),
        ({"replicate": 0}, ":4: replicate = 0: must be unique among the runs of cell 0"),
        ({"fingerprint": "other"}, ':4: fingerprint = "other": must be "f0s"'),
        ({"engine": "a\nb"}, "without control characters"),
        ({"settings": {"a": [1]}}, ":4: settings = "),
        ({"null": 1}, ":4: null = 1: must be none, shadow or one_sided_SPECIES"),
        ({"agents_every": 0}, ":4: agents_every = 0: must be >= 1"),
        ({"work": math.inf}, ":4: work = Infinity: must be >= 0"),
    ],
)
def test_a_broken_plan_is_refused(tmp_path, change, part):
    lines = [dataclasses.asdict(run) for run in plan_of(2, 2, with_shadow=True)]
    write_plan(tmp_path, lines)
    assert read_plan(tmp_path / "plan.jsonl") == plan_of(2, 2, with_shadow=True)
    lines[3].update(change)
    write_plan(tmp_path, lines)
    assert part in refusal(read_plan, tmp_path / "plan.jsonl")


@pytest.mark.parametrize(
    "text, part",
    [
        ("", "plan.jsonl: must list at least one run"),
        ('{"cell": 0', "plan.jsonl:1: must be a JSON object"),
        ("{}", "plan.jsonl:1: cell: is missing"),
        ("[1]", "plan.jsonl:1: must be a JSON object on a line of its own"),
    ],
)
def test_a_file_that_is_not_a_plan_is_refused(tmp_path, text, part):
    (tmp_path / "plan.jsonl").write_text(text)
    assert part in refusal(read_plan, tmp_path / "plan.jsonl")


# Runs on the disk


@pytest.fixture
def disk(tmp_path, monkeypatch):
    """A sweep of two cells with shadows."""
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "sweep"
    plan = plan_of(2, 2, with_shadow=True)
    write_plan(folder, plan)
    for run in plan:
        write_run(
            folder / run.folder,
            run.seed,
            heredity="nothing_inherited" if run.shadow else "own_copy",
            fingerprint=run.fingerprint,
        )
    return folder


def change(folder, what, by):
    path = folder / "manifest.json"
    path.write_text(path.read_text().replace(what, by, 1))


def test_every_run_as_planned_is_there(disk):
    assert is_sweep(disk) and not is_sweep(disk / "cell-0")
    sweep = read_sweep(disk)
    assert (sweep.is_there, sweep.missing, len(sweep.first_of_web)) == ([True] * 8, [], 1)
    assert sweep.folder_of(6) == disk / "cell-1/shadow/replicate-0"


def test_an_absent_or_incomplete_run_is_missing_with_the_reason(disk):
    shutil.rmtree(disk / "cell-0/replicate-1")
    (disk / "cell-0/shadow/replicate-1/manifest.json").unlink()
    change(disk / "cell-1/replicate-0", '"complete"', '"stopped"')
    change(disk / "cell-1/replicate-1", "{", "")
    sweep = read_sweep(disk)
    assert sweep.is_there == [True, False, True, False, False, False, True, True]
    assert sweep.missing_line().startswith(
        "4 of 8 runs missing: run 1 (cell-0/replicate-1): no such folder; run 3 (cell-0/shadow/replicate-1): no manifest.json; run 4 "
        '(cell-1/replicate-0): status "stopped", must be "complete"; run 5 (cell-1/replicate-1): '
    )
    assert refusal(check_sweep, sweep, 0, False, Measuring()).endswith(
        " (PROGRAM --plan " + str(disk / "plan.jsonl") + " makes them; --allow-missing omits them)"
    )
    check_sweep(sweep, 0, True, Measuring())


def test_of_many_missing_runs_the_first_are_named(tmp_path):
    plan = plan_of(1, 20)
    write_plan(tmp_path, plan)
    write_run(tmp_path / plan[0].folder, 100, fingerprint="f0")
    line = read_sweep(tmp_path).missing_line()
    assert line.startswith("19 of 20 runs missing: run 1 (cell-0/replicate-1): no such folder; ") and line.endswith(
        "run 10 (cell-0/replicate-10): no such folder; and 9 more"
    )
    shutil.rmtree(tmp_path / plan[0].folder)
    assert (
        refusal(read_sweep, tmp_path)
        == f"{tmp_path}: has no complete run; run 0 (cell-0/replicate-0): no such folder (PROGRAM --plan {tmp_path}/plan.jsonl makes them)"
    )


@pytest.mark.parametrize(
    "what, by, part",
    [
        ('"f1"', '"f0"', "fingerprint = f0: must be f1, as the plan has it for run 4"),
        ('"seed": 100', '"seed": 7', "seed = 7: must be 100"),
        ("6000", "5", "until_s = 5: must be 6000"),
    ],
)
def test_another_run_in_the_place_of_the_planned_one_is_refused(disk, what, by, part):
    change(disk / "cell-1/replicate-0", what, by)
    assert f"cell-1/replicate-0/manifest.json: {part}" in refusal(read_sweep, disk)


def test_a_run_in_a_shadows_place_that_is_not_a_shadow_is_refused(disk):
    change(disk / "cell-1/shadow/replicate-0", "nothing_inherited", "own_copy")
    assert "cell-1/shadow/replicate-0: is not a neutral shadow of " in refusal(read_sweep, disk)


def test_several_builds_are_refused_unless_they_are_accepted(disk):
    for number, run in enumerate(plan_of(2, 2, with_shadow=True)):
        change(disk / run.folder, "{", f'{{"code": "0{"ab"[number // 4]}",')
    assert "its runs were made by 0a and 0b; rules may have the same names but other code" in refusal(read_sweep, disk)
    assert read_sweep(disk, True).builds == ["0a", "0b"]


@pytest.mark.parametrize(
    "options, part",
    [
        ({"reference": 2}, "--reference 2: must be a cell of the sweep, 0 to 1"),
        ({"difference": 0.0}, "--difference 0: must be > 0"),
        ({"difference": 1.0}, "--difference: needs --metric to name a metric"),
        ({"how": Measuring(until_s=7000.0)}, "must be >= 7000 s, as --until asks"),
        ({"how": Measuring(metrics=["hungr"])}, "metric hungr: must be METRIC"),
        ({"how": Measuring(columns=["own.csv:level"])}, "has no such file"),
    ],
)
def test_what_does_not_fit_is_refused_before_anything_is_measured(disk, monkeypatch, options, part):
    monkeypatch.setattr(sweep_runs.pool, "measure", lambda *_: pytest.fail("measured"))
    assert part in refusal(analyze_sweep, disk, **options)


def test_values_do_not_depend_on_jobs_and_missing_runs_have_none(disk):
    shutil.rmtree(disk / "cell-0/replicate-1")
    sweep = read_sweep(disk)
    values, remarks = measure_sweep(sweep, Measuring(jobs=1))
    assert (
        numpy.array_equal(measure_sweep(sweep, Measuring(jobs=3))[0].runs, values.runs, equal_nan=True)
        and remarks == []
    )
    place = values.metrics.index(Metric("attribution_caught", "prey", "all", "1"))
    assert values.runs[0, place] == 1.0 and numpy.isnan(values.runs[1]).all()
    population = values.metrics.index(Metric("population", "prey", "all", "1"))
    assert values.runs[0, population] == 0.5
    assert measure_sweep(sweep, Measuring(jobs=1, until_s=1.0))[0].runs[0, population] == 1.0


def test_a_run_that_cannot_be_read_is_an_error_with_its_number(disk):
    (disk / "cell-1/replicate-1/agents.csv").unlink()
    why = refusal(measure_sweep, read_sweep(disk), Measuring(jobs=2))
    assert why.startswith("run 5: ") and "cell-1/replicate-1/agents.csv: cannot be read" in why


# Comparisons


def test_arrays_have_the_numbers_of_single_comparisons():
    rng = numpy.random.default_rng(5)
    for _ in range(100):
        a, b = rng.normal(0.0, 1.0, rng.integers(6, 12)), rng.normal(rng.normal(), 2.0, rng.integers(6, 12))
        of_a, of_b, level = arrays.moments(a[:, None]), arrays.moments(b[:, None]), 0.05 / rng.integers(1, 300)
        one, many = statistics.contrast((-1.0, a), (1.0, b)), arrays.contrast((-1.0, of_a), (1.0, of_b))
        assert tuple(map(float, many)) == approx(one) and arrays.p_value(many)[0] == approx(statistics.p_value(one))
        assert tuple(map(float, arrays.interval_of(many, 1 - level))) == approx(statistics.interval_of(one, 1 - level))
        assert arrays.hedges_g(of_a, of_b)[0] == approx(statistics.hedges_g(a, b))
        scatter, scatters = statistics.scatter_of(a, b), arrays.scatter_of(of_a, of_b)
        assert tuple(map(float, scatters)) == approx(scatter)
        needed = statistics.runs_for_power(b.mean() - a.mean(), scatter, level)
        assert arrays.runs_for_power(of_b.mean - of_a.mean, scatters, level)[0] == approx(
            math.nan if needed is None else needed, nan_ok=True
        )
        assert arrays.detectable_difference(many, level)[0] == approx(statistics.detectable_difference(one, level))


@pytest.mark.parametrize("values", [[[1.0] * 6], [[math.nan] * 6], [[1.0, 2.0, 3.0, 4.0, 5.0]], [[2.0] * 7]])
def test_arrays_have_nan_where_single_comparisons_have_none(values):
    of = arrays.moments(numpy.array(values).T)
    one = statistics.contrast((1.0, values[0]))
    assert tuple(map(float, arrays.contrast((1.0, of)))) == approx(one or (math.nan,) * 3, nan_ok=True)
    assert numpy.isnan(arrays.hedges_g(of, of)[0]) == (statistics.hedges_g(values[0], values[0]) is None)


def test_cells_are_compared_seed_by_seed_and_corrected_for_all_comparisons():
    plan = plan_of(3, 6)
    frame = compare_cells(
        grid_of(plan), values_of(plan, lambda run: run.cell * (10.0 + (0.5 if run.replicate % 2 == 0 else -0.5))), 0
    )
    assert list(frame["cell"]) == [1, 2] and set(frame["compared"]) == {"raw"} and set(frame["design"]) == {"paired"}
    second = frame.iloc[1]
    error = math.sqrt(6 / 5) / math.sqrt(6)
    assert (second.difference, second.runs, second.runs_reference, second.conclusion) == (approx(20.0), 6, 6, "above")
    assert second.upper == approx(20.0 + statistics.t_quantile(0.975, 5) * error)
    assert second.upper_corrected == approx(20.0 + statistics.t_quantile(1 - 0.05 / 4, 5) * error)
    assert (frame["level"] == 0.025).all() and frame["p_holm"].max() == approx(2 * frame["p"].min(), rel=1e-6)
    assert second.smallest_detectable == approx(error * statistics.errors_for_power(5, 0.025))
    assert cells.count(frame) == (2, 2)


@pytest.mark.parametrize("paired", [True, False])
def test_cells_that_share_seeds_are_compared_seed_by_seed_others_as_independent_sets(paired):
    # What seeds have in common is large, and what the cell adds is nearly the same for each.
    plan = plan_of(3, 6, paired=paired)
    frame = compare_cells(
        grid_of(plan),
        values_of(plan, lambda run: 10 * run.replicate + run.cell * (1.01 if run.replicate % 2 == 0 else 0.99)),
        0,
    )
    row = frame.iloc[1]
    assert (row.design, row.runs, row["mean"], row.difference) == (
        "paired" if paired else "independent",
        6,
        approx(27.0),
        approx(2.0),
    )
    assert row.hedges_g < 0.2  # runs of one cell are far apart, whatever the pairs say
    assert (row.conclusion == "above", row.smallest_detectable < 2.0) == (paired,) * 2
    assert row.lower_corrected < row.lower < row.upper < row.upper_corrected


def test_any_cell_may_be_the_reference_and_missing_values_leave_their_pair_out():
    plan = plan_of(3, 7)
    values = values_of(plan, lambda run: 0.1 * run.replicate if run.cell == 2 else 0.1)
    values.runs[16] = numpy.nan
    frame = compare_cells(grid_of(plan), values, 0)
    assert list(frame["conclusion"]) == ["not compared", "inconclusive"] and math.isnan(frame.iloc[0].upper_corrected)
    assert (frame.iloc[1].runs, frame.iloc[1].runs_reference, frame.iloc[1].p_holm) == (6, 6, frame.iloc[1].p)
    other = compare_cells(grid_of(plan), values, 2)
    assert list(other["cell"]) == [0, 1] and other.iloc[0].difference == approx(-frame.iloc[1].difference)
    assert refusal(compare_cells, grid_of(plan), values, 3) == "reference = 3: must be a cell of the sweep, 0 to 2"


def test_with_shadows_in_every_cell_the_answer_is_over_them_and_the_raw_difference_a_family_of_its_own():
    plan = plan_of(3, 6, with_shadow=True)
    values = values_of(
        plan,
        lambda run: run.cell * (1.0 if run.shadow else 4.0) + run.replicate * (1 + run.cell) + 0.1 * (run.index % 3),
    )
    values = SweepValues(
        [HUNGER, VELOCITY],
        numpy.hstack([values.runs, numpy.random.default_rng(1).normal(size=values.runs.shape)]),
        values.is_there,
    )
    frame = compare_cells(grid_of(plan), values, 0)
    assert list(frame["compared"]) == ["over_shadow", "raw"] * 4 and list(frame["role"]) == ["null", ""] * 4
    hunger = frame[(frame["metric"] == "hunger") & (frame["cell"] == 1)]
    assert list(hunger["difference"].round(6)) == [approx(3.0), approx(6.5)]
    for family in ("over_shadow", "raw"):
        of = frame[frame["compared"] == family]
        assert list(of["p_holm"]) == approx(list(statistics.holm(of["p"])))
    assert cells.count(frame).comparisons == 4
    assert set(frame.loc[frame["role"] != "null", "conclusion"]) == {"not compared"}
    values.is_there = [run.cell != 2 or not run.shadow for run in plan]
    without = compare_cells(grid_of(plan), values, 0)
    assert set(without["compared"]) == {"raw"} and set(without["role"]) == {"null"}
    values.is_there, values.is_constant = [True] * len(
        plan
    ), False  # numbers change: the shadow does not control for one species
    assert set(compare_cells(grid_of(plan), values, 0)["compared"]) == {"raw"}


def test_too_few_runs_have_no_test_but_count_and_nothing_that_varies_does_not():
    plan = plan_of(3, 5)
    frame = compare_cells(grid_of(plan), values_of(plan, lambda run: (run.cell == 2) * (1.0 + run.replicate)), 0)
    assert list(frame["conclusion"]) == ["not compared", "too few runs"]
    assert cells.count(frame) == (1, 0) and frame["p_holm"].isna().all()


def test_a_metric_that_some_runs_lack_is_described_and_not_compared():
    plan = plan_of(2, 8)
    values = values_of(plan, lambda run: run.cell + 0.01 * run.replicate * (-1) ** run.cell)
    assert compare_cells(grid_of(plan), values, 0)["conclusion"].tolist() == ["above"]
    both = SweepValues([HUNGER, HUNGER._replace(metric="period")], numpy.hstack([values.runs] * 2), values.is_there)
    both.runs[9, 1] = numpy.nan  # a run of the second cell has no period
    assert compare_cells(grid_of(plan), both, 0)["conclusion"].tolist() == ["above", "not compared"]


def test_a_difference_needs_so_many_runs_by_the_scatter_of_cells():
    plan = plan_of(2, 6)
    frame = compare_cells(
        grid_of(plan), values_of(plan, lambda run: run.cell * (10.0 + (0.5 if run.replicate % 2 == 0 else -0.5))), 0
    )
    asked = runs_for_difference(frame, 0.5).iloc[0]
    assert (asked.runs, asked.fewest, asked.most, asked.cells) == (12, 12, 12, 1)
    assert runs_for_difference(frame, 0.5 / 1000).iloc[0].isna()["runs"]
    plan = plan_of(3, 4)  # variances of 4/3 and 16/3 between pairs
    frame = compare_cells(
        grid_of(plan), values_of(plan, lambda run: run.cell * (1 if run.replicate % 2 == 0 else -1)), 0
    )
    asked = runs_for_difference(frame, 2.0).iloc[0]
    assert [asked.fewest, asked.runs, asked.most] == [
        statistics.runs_for_power(2.0, statistics.Scatter(variance / 3, 1.0), 0.025) for variance in (4, 10, 16)
    ]


# Effects of axes


def effect(frame, axis, value):
    (row,) = answers(frame[(frame["axis"] == axis) & (frame["value"] == value)]).itertuples()
    return row


def test_an_axis_effect_is_the_mean_difference_over_the_other_axes_values_with_an_interval_over_seeds():
    plan = plan_of_two_axes()
    # 10 a + 3 b a + the seed's own number: b does nothing at a = 0, 3 at a = 1 and 6 at a = 2.
    values = values_of(
        plan,
        lambda run: 10 * (run.cell // 2) + 3 * (run.cell % 2) * (run.cell // 2) + run.replicate * (1 + run.cell // 2),
    )
    frame = axis_effects(grid_of(plan), values, 0)
    assert len(frame) == 3
    a1, b1 = effect(frame, "a", "1"), effect(frame, "b", "1")
    half = 2.570581835636314 * math.sqrt(
        3.5 / 6
    )  # the seeds' 0, ..., 5 have the mean 2.5 and the standard error sqrt(3.5 / 6)
    assert (a1.reference, a1.settings, a1.seeds, a1.difference, a1.lower, a1.upper) == (
        "0",
        2,
        6,
        approx(14.0),
        approx(14.0 - half),
        approx(14.0 + half),
    )
    assert effect(frame, "a", "2").difference == approx(28.0)
    assert (b1.settings, b1.difference, b1.mean_reference) == (3, approx(3.0), approx(15.0))


def test_only_settings_at_which_both_values_were_run_are_averaged_and_seeds_that_all_of_their_cells_have():
    plan = plan_of_two_axes()
    values = values_of(plan, lambda run: run.cell + run.replicate)
    values.runs[3] = numpy.nan  # replicate 3 of a = 0, b = 0
    of = effect(axis_effects(grid_of(plan), values, 1), "a", "1")
    assert of.seeds == 5 and math.isnan(of.lower)
    fewer = [dataclasses.replace(run, index=place) for place, run in enumerate(run for run in plan if run.cell != 3)]
    frame = axis_effects(grid_of(fewer), values_of(fewer, lambda run: run.cell + run.replicate), 0)
    assert (effect(frame, "a", "1").settings, effect(frame, "b", "1").settings) == (1, 2)


def test_effects_are_over_the_shadows_and_cells_with_seeds_of_their_own_have_none():
    plan = plan_of_two_axes(with_shadow=True)
    frame = axis_effects(
        grid_of(plan), values_of(plan, lambda run: (1 if run.shadow else 4) * (run.cell // 2) + run.replicate), 0
    )
    assert (effect(frame, "a", "1").compared, effect(frame, "a", "1").difference) == ("over_shadow", approx(3.0))
    assert list(frame["compared"]) == ["over_shadow", "raw"] * 3
    unpaired = plan_of_two_axes(with_shadow=True, paired=False)
    assert len(axis_effects(grid_of(unpaired), values_of(unpaired, lambda run: run.index), 0)) == 0


# Error rates: every simulated sweep is a metric of one large sweep, so that thousands are compared at once


def simulate(trials, seed, count=6, replicates=8, paired=True, shared=0.7, own=1.0, widening=0.0, effect=0.0):
    """Sweeps of normal values; cells differ in mean (by `effect` from the first) and spread (`own`, wider by `widening` in each further cell), and
    replicates of one seed have a part of deviation `shared` in common. Returns shares of sweeps or comparisons, by name.
    """
    rng = numpy.random.default_rng(seed)
    plan = plan_of(count, replicates, paired=paired)
    grid = grid_of(plan)
    common = rng.normal(0.0, shared, (replicates, trials))
    values = numpy.array(
        [
            (common[run.replicate] if paired else rng.normal(0.0, shared, trials))
            + rng.normal(effect * (run.cell > 0), own * (1 + widening * run.cell), trials)
            for run in plan
        ]
    )
    of = SweepValues([HUNGER] * trials, values, [True] * len(plan))
    base = grid.cells[0]
    frames = [
        cells._compared(base, of.compared(base, False), cell, of.compared(cell, False), of.metrics)
        for cell in grid.cells[1:]
    ]
    level = 0.05 / len(frames)
    differs = numpy.apply_along_axis(statistics.holm, 0, numpy.array([frame["p"] for frame in frames])) <= 0.05
    corrected = [
        arrays.interval_of(
            arrays.Contrast(*(frame[name].to_numpy() for name in ("value", "error", "freedom"))), 1 - level
        )
        for frame in frames
    ]
    misses = numpy.array([(one.lower > effect) | (one.upper < effect) for one in corrected])
    alone = numpy.array([(frame["lower"] > effect) | (frame["upper"] < effect) for frame in frames])
    at_level = numpy.array([frame["p"] <= level for frame in frames])
    return {
        "any_differs": differs.any(axis=0).mean(),
        "any_misses": misses.any(axis=0).mean(),
        "single_misses": alone.mean(),
        "significant": differs.mean(),
        "at_level": at_level.mean(),
    }


@pytest.mark.parametrize("paired", [True, False])
@pytest.mark.parametrize("widening", [0.0, 0.5])
def test_without_an_effect_any_cell_differs_in_at_most_5_percent_of_sweeps_within_1_2_points(paired, widening):
    found = simulate(4000, 1, paired=paired, widening=widening)
    assert found["any_differs"] <= 0.062 and 0.015 <= found["any_misses"] <= 0.062
    assert abs(found["single_misses"] - 0.05) <= 0.01


@pytest.mark.parametrize("paired", [True, False])
def test_with_an_effect_in_every_cell_corrected_intervals_hold_it_in_all_of_them(paired):
    assert simulate(4000, 11, paired=paired, effect=3.0)["any_misses"] <= 0.062


def test_seeds_that_are_alike_are_worth_more_in_pairs_those_that_are_not_cost_the_pairs_their_degrees_of_freedom():
    alike = {"replicates": 10, "shared": 2.0, "effect": 1.6}
    assert simulate(1000, 21, **alike)["significant"] > simulate(1000, 21, paired=False, **alike)["significant"] + 0.3
    apart = {**alike, "shared": 0.0}
    assert simulate(2000, 22, **apart)["significant"] < simulate(2000, 22, paired=False, **apart)["significant"]


PERSISTS = Metric("persists", "prey", "all", "1")


def simulated_shares(trials, seed, shares, replicates=10, alike=0.0):
    """Sweeps of a metric of 0 and 1, true in a cell with its of `shares`; with probability `alike` the replicates of one seed have the same luck."""
    rng, plan = numpy.random.default_rng(seed), plan_of(len(shares), replicates)
    luck = rng.random((replicates, trials))
    values = numpy.array(
        [
            numpy.where(rng.random(trials) < alike, luck[run.replicate], rng.random(trials)) < shares[run.cell]
            for run in plan
        ],
        float,
    )
    grid = grid_of(plan)
    return cells.judged(
        cells.as_family(
            pandas.concat(
                [
                    cells._compared(
                        grid.cells[0],
                        values[:replicates],
                        cell,
                        values[replicates * cell.number :][:replicates],
                        [PERSISTS] * trials,
                    )
                    for cell in grid.cells[1:]
                ],
                ignore_index=True,
            ),
            "raw",
            ["raw"],
        )
    )


@pytest.mark.parametrize("shares", [(0.9, 0.9, 0.9), (0.5, 0.5, 0.5), (0.9, 0.4, 0.9)])
@pytest.mark.parametrize("alike", [0.0, 0.6])
def test_shares_of_runs_have_exact_tests_that_err_in_at_most_5_percent_and_intervals_that_hold(shares, alike):
    frame = simulated_shares(150, 3, shares, alike=alike)
    truth = numpy.repeat(numpy.subtract(shares[1:], shares[0]), 150)
    assert ((frame["lower"] <= truth) & (truth <= frame["upper"])).mean() >= 0.94
    assert (frame["lower_corrected"] <= frame["lower"]).all() and (
        frame["p"].dropna()[truth[frame["p"].notna()] == 0.0] <= 0.05
    ).mean() <= 0.05
    assert set(frame["design"]) == {"exact"} and (shares[1] > 0.4 or (frame["p"] <= 0.05)[truth != 0.0].mean() >= 0.4)


def test_shares_are_answers_without_shadows_and_once_and_effects_of_axes_pool_their_runs():
    plan = plan_of_two_axes(with_shadow=True)
    values = SweepValues(
        [PERSISTS, HUNGER],
        numpy.array(
            [[float(run.cell < 2 or run.shadow), run.replicate + 2 * run.cell * (not run.shadow)] for run in plan]
        ),
        [True] * len(plan),
    )
    frame = compare_cells(grid_of(plan), values, 0)
    its = frame[frame["metric"] == "persists"]
    assert (
        set(its["compared"]) == {"raw"}
        and set(its["role"]) == {"null"}
        and len(its) == 5
        and list(frame["compared"][:3]) == ["raw", "over_shadow", "raw"]
    )
    assert its["p"].tolist() == approx([math.nan, *[statistics.share_difference([0] * 6, [1] * 6).p] * 4], nan_ok=True)
    assert report.named_text(analysis_of(plan, values)).count("persists prey ") == 5
    effects = axis_effects(grid_of(plan), values, 0)
    ours = effects[effects["metric"] == "persists"]
    assert ours["p"].tolist() == approx([statistics.share_difference([0] * 12, [1] * 12).p] * 2 + [1.0]) and set(
        ours["compared"]
    ) == {"raw"}


@pytest.mark.parametrize("paired", [True, False])
@pytest.mark.parametrize("own", [0.5, 1.0])
def test_as_many_runs_as_are_asked_for_find_the_difference_in_80_percent_of_comparisons(paired, own):
    variance = 2 * own**2 if paired else 2 * (own**2 + 0.7**2)
    scatter = arrays.Scatter(numpy.array([variance]), numpy.array([1.0 if paired else 2.0]))
    (runs,) = arrays.runs_for_power(numpy.array([1.0]), scatter, 0.01)
    found = simulate(1500, 31, replicates=int(runs), paired=paired, own=own, effect=1.0)
    assert found["at_level"] == approx(0.8, abs=0.07)
    assert (
        0.78 <= found["significant"] <= 0.97
    )  # Holm finds more than one comparison at this level, where many cells differ


def test_the_smallest_effect_that_the_present_runs_would_show_is_found_in_80_percent_of_comparisons():
    values = numpy.random.default_rng(41).normal(size=(9, 4000))
    (effect,) = arrays.detectable_difference(
        arrays.Contrast(numpy.zeros(1), numpy.array([1 / 3]), numpy.array([8.0])), 0.01
    )
    p = arrays.p_value(arrays.contrast((1.0, arrays.moments(values + effect))))
    assert (p <= 0.01).mean() == approx(0.8, abs=0.025)


def test_without_an_effect_any_axis_is_significant_in_at_most_5_percent_of_sweeps_within_1_5_points():
    trials, plan = 2000, plan_of_two_axes(8)
    rng = numpy.random.default_rng(3)
    values = SweepValues(
        [Metric(str(trial), "prey", "all", "1") for trial in range(trials)],
        numpy.array([rng.normal(0.0, 1.0 if run.cell < 2 else 2.0, trials) for run in plan]),
        [True] * len(plan),
    )
    p = axis_effects(grid_of(plan), values, 0)["p"].to_numpy().reshape(trials, 3)
    wrong = (numpy.apply_along_axis(statistics.holm, 1, p) <= 0.05).any(axis=1).mean()
    assert 0.01 <= wrong <= 0.065


# Texts and tables


def analysis_of(plan, values, reference=0, is_chosen=False, difference=None):
    grid = grid_of(plan)
    sweep = Sweep("sweep", plan, grid, list(values.is_there), [], ["0a"], [])
    differences = compare_cells(grid, values, reference)
    asked = runs_for_difference(differences, difference) if difference else pandas.DataFrame()
    return SweepAnalysis(
        sweep,
        "paper on kinematic 1",
        values,
        reference,
        6000.0,
        is_chosen,
        differences,
        axis_effects(grid, values, reference),
        asked,
        [],
    )


def analyzed(per_cell, count=3, replicates=6, paired=True, **options):
    plan = plan_of(count, replicates, paired=paired)
    return analysis_of(
        plan, values_of(plan, lambda run: run.cell * (per_cell + (0.5 if run.replicate % 2 == 0 else -0.5))), **options
    )


def test_what_was_compared_and_what_is_significant_is_said():
    text = report.text_of(analyzed(10.0))
    assert text.startswith(
        "sweep of 3 cells, 18 runs of 6000 s\naxis x.y: 0.0, 0.5, 1.0\nreference: cell 0 (y 0.0), paper on kinematic 1\n"
        "2 comparisons with it, seed by seed; p corrected for all of them (Holm)\n"
        "2 of 2 comparisons are significant (p <= 0.05, corrected for all of them: Holm).\n"
    )
    (line,) = [line for line in text.splitlines() if line.startswith("hunger predator") and "2/2" in line]
    assert line.split("  ")[-1] == "2 (y 1.0)" and "+20.0 [+18.6, +21.4]" in line
    assert "inconclusive" not in text


def test_what_is_not_significant_is_inconclusive_not_absent():
    text = report.text_of(analyzed(0.1, paired=False))
    assert "as independent sets (different seeds in each cell)" in text
    assert (
        "0 of 2 comparisons are significant" in text
        and "This does not show that nothing differs.\ninconclusive: 2 of 2 comparisons\n" in text
    )
    assert "inconclusive in every cell: 1 metric: hunger predator\n" in text and "no effect" not in text


def test_named_metrics_have_a_line_for_each_cell_with_the_difference_that_an_inconclusive_one_would_detect():
    assert "hunger predator  1 (y 0.5)  10.0  0.0        +10.0 [+9.3, +10.7]   <0.001" in report.named_text(
        analyzed(10.0)
    )
    open_ = report.named_text(analyzed(0.1))
    assert "detectable\n" in open_ and "  6+6   " in open_
    assert report.named_text(analyzed(10.0, 2, is_chosen=True)) in report.text_of(analyzed(10.0, 2, is_chosen=True))


def test_too_few_runs_are_said_and_a_cell_alone_has_nothing_to_be_compared_with():
    assert "too few runs for a test in 1 of them: 6 in each cell are needed" in report.text_of(analyzed(10.0, 2, 5))
    assert report.text_of(analyzed(10.0, 1)) == (
        "sweep of 1 cell, 6 runs of 6000 s\nreference: cell 0, paper on kinematic 1\n"
        "only one cell: there is nothing to compare\n"
    )


def test_the_answer_to_a_difference_is_a_sentence_with_the_number_of_replicates():
    text = report.asked_text(analyzed(10.0, 2, difference=0.5))
    assert text.startswith(
        "a difference of 0.5 in hunger predator needs 12 replicates a cell (12 to 12, cell by cell) for 80 % power\n"
    )
    assert "at the level of one of 1 comparison, 0.05;" in text


def test_a_fact_is_one_line_of_the_cell_that_differs_most():
    plan, rng = plan_of(3, 6), numpy.random.default_rng(2)
    readings = [VELOCITY, VELOCITY._replace(metric="velocity_stored"), VELOCITY._replace(group="inherited"), HUNGER]
    values = numpy.array(
        [[run.cell * 5.0 + rng.normal(0.0, 0.1)] * 3 + [run.cell * 3.0 + rng.normal(0.0, 0.1)] for run in plan]
    )
    analysis = analysis_of(
        plan, SweepValues(readings, values + rng.normal(0.0, 0.01, values.shape), [True] * len(plan))
    )
    found = analysis.findings()
    assert [(finding.metric, row.cell) for finding, row in found] == [(VELOCITY, 2), (HUNGER, 2)]
    assert "in runs of cell 2 (y 1.0) than in runs of cell 0 (y 0.0)" in found[0][0].sentence
    assert "and 2 metrics more, such as other groups and readings of these" in report.text_of(analysis)
    summary = report.summary_of(analysis)
    assert (
        summary["family"]["comparisons"],
        summary["family"]["significant"],
        len(summary["sweep"]["significant"]),
    ) == (8, 8, 8)
    assert [(one["metric"], one["cell"]) for one in summary["findings"]] == [("velocity", 2), ("hunger", 2)]


def test_effects_of_axes_are_counted_and_their_largest_shown():
    plan = plan_of_two_axes()
    effects = axis_effects(
        grid_of(plan), values_of(plan, lambda run: 10.0 * (run.cell // 2) + (run.replicate % 2) * run.cell), 0
    )
    text = report.effects_text(effects)
    assert "of 3 effects of an axis are significant (Holm); the largest of each:" in text and "0 -> 2\n" in text
    row = report.with_significance(effects).iloc[0]
    assert list(
        row[["axis", "value", "reference", "settings", "seeds", "mean", "mean_reference", "difference", "significant"]]
    ) == ["a", "1", "0", 2, 6, 11.25, 0.25, 11.0, "yes"]


def test_tables_have_their_columns_and_what_was_measured(tmp_path):
    plan = plan_of(2, 6, with_shadow=True)
    values = values_of(plan, lambda run: run.cell + (0 if run.shadow else 0.5 * run.replicate), VELOCITY)
    values.runs[5], values.is_there[5] = numpy.nan, False
    files = report.write(analysis_of(plan, values, 1), tmp_path)
    assert files == [
        "cells.csv",
        "runs.csv",
        "sweep_metrics.csv",
        "sweep_differences.csv",
        "sweep_effects.csv",
        "summary.json",
    ]
    tables = {name: (tmp_path / name).read_text() for name in files}
    for name in files[1:5]:
        assert tables[name].splitlines()[0].split(",") == column_names(name)
    assert tables["cells.csv"] == (
        "cell,rule_table,engine,runs,runs_planned,shadow_runs,until_s,x.y\n0,paper,kinematic,5,6,6,6000,0.0\n"
        "1,paper,kinematic,6,6,6,6000,0.5\n"
    )
    assert (
        "\n0,0,0,none,100,velocity,prey,all,0\n" in tables["runs.csv"]
        and "\n5," not in tables["runs.csv"]
        and "\n23,1,5,shadow,105,velocity,prey,all,1\n" in tables["runs.csv"]
    )
    assert "\n0,velocity,prey,all,m/s,5,1,0.790569415042094" in tables["sweep_metrics.csv"]
    assert ",,,6,0,5,1,,\n1,velocity,prey,all,m/s,6,2.25," in tables["sweep_metrics.csv"]  # five pairs: no interval
    assert "\n0,1,velocity,prey,all,m/s,over_shadow,paired,5,5,1,1,0," in tables["sweep_differences.csv"]
    assert json.loads(tables["summary.json"])["sweep"]["cells"] == 2
    with pytest.raises(RunError, match="exists already"):
        report.write(analysis_of(plan, values, 1), tmp_path)


def test_a_sweep_is_analysed_from_its_folder(disk, capsys):
    for run in plan_of(2, 2, with_shadow=True):
        (disk / run.folder / "own.csv").write_text(f"level\n{1 + (2 - run.shadow) * run.cell + run.replicate / 10}\n")
    request = {
        "who": "trophic analyze",
        "runs": ["sweep"],
        "column": ["own.csv:level"],
        "metric": ["level"],
        "difference": 0.1,
        "jobs": 1,
        "out": "out",
    }
    assert report.run(request) == 0
    shown = capsys.readouterr().out
    assert (
        re.search(r"level, over shadow +1 \(y 0.5\) +1.000 +0.000 +\+1.000 +\+2.000", shown)
        and "a difference of 0.100 in level, over shadow needs " in shown
    )
    assert shown.endswith(
        "files   out/{cells.csv,runs.csv,sweep_metrics.csv,sweep_differences.csv,sweep_effects.csv,summary.json}\n"
    )
    table = pandas.read_csv("out/sweep_differences.csv")
    assert list(table["compared"]) == ["over_shadow", "raw"] and list(table["difference"].round(9)) == [1.0, 2.0]
    assert "exists already" in refusal(report.run, request)
