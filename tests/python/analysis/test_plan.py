# SPDX-License-Identifier: MIT
"""Plans: the runs that a sweep file describes, and the files that are refused."""
import json
import os
import pathlib

import pytest

from trophic import plan
from trophic.runs import RunError

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("TROPHIC_PREDATOR_PREY")
# The sweep of the plan in the corpus of the fuzzers, which the program wrote when it planned sweeps itself.
SWEEP = """
rule_table = "paper"
engine = "kinematic"
replicates = 1
shadow = true
[set]
ecology.duration_s = 20.0
[grid]
rules.capture.reach_m = [0.5, 1.0]
rules.mutation.sd = [0.1, 0.2]
"""


def read(folder, text):
    path = folder / "sweep.toml"
    path.write_text(text)
    return plan.read_sweep(path)


def texts(folder, text):
    sweep = read(folder, text)
    return [plan.text_of(cell, sweep) for cell in plan.cells_of(sweep)]


def test_grid_has_every_combination_the_last_key_fastest(tmp_path):
    assert texts(tmp_path, "[grid]\nrules.b.x = [1, 2]\nrules.a.y = [0.5, 1.0]\n") == [
        "rules.b.x=1 rules.a.y=0.5",
        "rules.b.x=1 rules.a.y=1.0",
        "rules.b.x=2 rules.a.y=0.5",
        "rules.b.x=2 rules.a.y=1.0",
    ]


def test_lists_of_zip_advance_together_for_each_cell_of_a_grid(tmp_path):
    assert texts(tmp_path, "[zip]\na = [1, 2]\nb = [3, 4]\n[grid]\nc = [true, false]\n") == [
        "a=1 b=3 c=true",
        "a=1 b=3 c=false",
        "a=2 b=4 c=true",
        "a=2 b=4 c=false",
    ]


def test_listed_runs_have_the_common_settings(tmp_path):
    sweep = read(
        tmp_path,
        'rule_table = "paper"\n[set]\necology.duration_s = 60.0\n[[runs]]\nrules.a = 1\n[[runs]]\nrules.b = "x"\n',
    )
    assert plan.cells_of(sweep) == [
        {"ecology.duration_s": 60.0, "rule_table": "paper", "rules.a": 1},
        {"ecology.duration_s": 60.0, "rule_table": "paper", "rules.b": "x"},
    ]


GRID = "[grid]\na = [1]\n"


@pytest.mark.parametrize(
    "text, why",
    [
        ("", ": has no [grid], [zip] or [[runs]], so nothing varies"),
        ("[grid]\n", ": [grid]: is empty"),
        ("[grid]\na = []\n", ": [grid] a = []: must have a value"),
        ("[grid]\na = 1\n", ": [grid] a = 1: must be a list of values"),
        ("[grid]\na = [[1]]\n", "must be a finite number, a text, true or false"),
        ("[grid]\na = [nan]\n", "must be a finite number, a text, true or false"),
        ("[zip]\na = [1, 2]\nb = [1]\n", ": [zip] b: has 1 values: must have 2, as a"),
        ("[set]\na = 1\n" + GRID, ": a: is in [set] and in [grid]"),
        ("[zip]\na = [1]\n" + GRID, "a: is in [grid] and in [zip]"),
        ('engine = "ode"\n[grid]\nengine = ["ode"]\n', ": engine: is in [set] and in [grid]"),
        ("[grid]\nseed = [1, 2]\n", ": [grid] seed: is not allowed in a sweep"),
        ("replicates = 0\n" + GRID, ": replicates = 0: must be a whole number >= 1 and <= 1000000"),
        ("replicate = 3\n" + GRID, ": replicate: unknown key; did you mean replicates?"),
        ("[gird]\na = [1]\n", ": [gird]: unknown key; did you mean grid?"),
        ("color = 3\n" + GRID, ": color: unknown key; known here: "),
        ("replay_hz = 7\n" + GRID, ": replay_hz = 7: must be 0, 5, 10 or 30"),
        ("agents_every = 0\n" + GRID, ": agents_every = 0: must be"),
        ("senses = 3\n" + GRID, ": senses = 3: must be true"),
        ("grid = 3\n", ": grid: must be a section, [grid]"),
        ("runs = 3\n", ": runs: must be sections, [[runs]]"),
        ("[grid\n", ": is not TOML: "),
        (
            "[grid]\n" + "".join(f"{key} = {list(range(100))}\n" for key in "abcde"),
            ": makes too many runs (cells x replicates): must be <= 1000000",
        ),
    ],
)
def test_bad_sweep_is_refused(tmp_path, text, why):
    with pytest.raises(RunError) as error:
        read(tmp_path, text)
    assert f"sweep.toml{why}" in str(error.value) or why in str(error.value)


def test_seeds_are_those_of_replicates():
    assert [plan.seed_of(1, k) for k in range(3)] == [161574062546064, 7632529610284583, 8833179064769530]


@pytest.mark.skipif(PROGRAM is None, reason="needs a program")
def test_plan_has_the_lines_that_earlier_programs_wrote(tmp_path):
    lines = plan.plan_of(read(tmp_path, SWEEP), PROGRAM)
    before = [json.loads(line) for line in (ROOT / "tests/fuzz/corpus/plan/plan.jsonl").read_text().splitlines()]
    assert lines == before


@pytest.mark.skipif(PROGRAM is None, reason="needs a program")
def test_folder_with_another_plan_is_refused_and_a_grown_one_keeps_numbers(tmp_path):
    out = tmp_path / "out"
    first = plan.make_plan(read(tmp_path, SWEEP), PROGRAM, out)
    grown = plan.make_plan(
        read(tmp_path, SWEEP.replace("[0.5, 1.0]", "[2.0, 0.5, 1.0]").replace("20.0", "30.0")), PROGRAM, out
    )
    assert [line["folder"] for line in grown[:8]] == [line["folder"] for line in first]
    assert len(grown) == 12 and {line["cell"] for line in grown[8:]} == {4, 5}
    with pytest.raises(
        RunError, match=r"plan.jsonl:\d+: the folder has another plan, with a run that the sweep lacks: "
    ):
        plan.make_plan(read(tmp_path, SWEEP.replace("0.2", "0.3")), PROGRAM, out)
