# SPDX-License-Identifier: MIT
"""Measures of bodies, gaits and brains."""
import pathlib
import re

import numpy
import pandas
import pytest
from hand_written import WEB, event, robot, write_run
from trophic import pool
from trophic.metrics import OPTIONAL, Measuring, bodies
from trophic.metrics.plans import distances_from_first, edit_distance, read_plan
from trophic.runs import RunError

COLUMNS = (
    "id time_s species plan parent_plan edit_distance modules_text modules hinges bricks mass_kg reach_m size proportion coverage branching "
    "limbs length_of_limbs symmetry joints"
).split()


def body(id, text, modules, symmetry):
    return dict(
        zip(COLUMNS, (id, 0, "prey", 0, "", "", text, modules, 1, 1, 0.5, 0.2, 0.1, 1, 1, 0, 1, 0, symmetry, 0))
    )


@pytest.fixture
def run(tmp_path, monkeypatch):
    """40 s with two prey of one plan; at 10 s the second is followed by one with a module more."""
    monkeypatch.chdir(tmp_path)
    rows = [
        body(0, "core[left:hinge0]", 2, 0.0),
        body(1, "core[left:hinge0]", 2, 0.0),
        body(3, "core[left:hinge0 right:hinge0]", 3, 1.0),
    ]
    genes = [(0, "brain")] * 2 + [(0, "gait")] + [(1, "brain")] * 2 + [(3, "brain")] * 4
    write_run(
        "run",
        until_s=40.0,
        of_events=[
            event("birth", 0, 0, "prey"),
            event("birth", 0, 1, "prey"),
            event("death", 10, 1, "prey", cause="starved"),
            event("birth", 10, 3, "prey", body=1),
        ],
        of_agents=[robot(0, 0, "prey", 1.0, 2.0), robot(1, 0, "prey", 1.1, 2.0), robot(2, 0, "prey", 1.1, 2.3)],
        files={
            "bodies.csv": pandas.DataFrame(rows),
            "genes.csv": pandas.DataFrame(genes, columns=["id", "part"]).assign(index=0, value=1.0),
        },
    )
    return pathlib.Path("run")


def measured():
    (values,) = pool.read_set(["run"], how=Measuring(bodies=True)).values
    return values


# Four of ten early windows of 2 s end before the death. The robot walks 0.1 m and 0.3 m in 2 s each.
@pytest.mark.parametrize(
    "metric, early, late",
    [
        ("body_modules", 2.3, 2.5),
        ("body_symmetry", 0.3, 0.5),
        ("body_plans", 1.6, 2.0),
        ("body_plans_shannon", 1.6, 2.0),
        ("body_change", 0.3, 0.5),
        ("brain_genes", 2.6, 3.0),
        ("gait_genes", 0.5, 0.5),
        ("walked", 0.1, numpy.nan),
        ("open_speed", 0.1, numpy.nan),
    ],
)
def test_means_over_the_living_in_the_windows_of_each_half(run, metric, early, late):
    values = measured().values
    found = values[(values.metric == metric) & (values.species == "prey")]
    assert (found.group.tolist(), found.value.tolist()) == (
        ["early", "late"],
        pytest.approx([early, late], nan_ok=True),
    )


def test_a_curve_has_a_point_a_window(run):
    curves = measured().curves
    points = curves[(curves.metric == "body_plans") & (curves.species == "prey")]
    assert (len(points), points.value.iloc[3], points.value.iloc[4], points.time_s.iloc[-1]) == (20, 1.0, 2.0, 40.0)


def test_only_genes_and_a_species_without_individuals(run):
    (run / "bodies.csv").unlink()
    values = measured().values
    assert values[(values.metric == "brain_genes") & (values.species == "prey")].value.tolist() == pytest.approx(
        [2.6, 3.0]
    )
    assert values[values.metric.str.startswith("body_") | (values.species == "predator")].value.isna().all()


def test_the_names_are_those_of_the_values(run):
    values = measured().values
    names = [name for name in bodies.names(WEB) if name.metric not in OPTIONAL]
    assert names == list(zip(values.metric, values.species, values.group, values.unit)) and len(values) == 2 * 2 * 18


@pytest.mark.parametrize(
    "change, why",
    [
        (
            lambda run: [(run / file).unlink() for file in ("bodies.csv", "genes.csv")],
            "run: has neither bodies.csv nor genes.csv",
        ),
        (
            lambda run: (run / "bodies.csv").write_text((run / "bodies.csv").read_text().replace(",2,", ",many,", 1)),
            'run/bodies.csv:2: modules = "many": must be a number',
        ),
        (
            lambda run: (run / "bodies.csv").write_text((run / "bodies.csv").read_text()[:-3]),
            "run/bodies.csv: the last line is truncated",
        ),
        (
            lambda run: (run / "bodies.csv").write_text(
                (run / "bodies.csv").read_text().replace("core[left:hinge0 ", "core[left:hinge4 ")
            ),
            'run/bodies.csv: id 3: body plan "core[left:hinge4 right:hinge0]", character 6: must be FACE:hinge',
        ),
    ],
)
def test_tables_that_are_missing_or_damaged_are_refused(run, change, why):
    change(run)
    with pytest.raises(RunError, match="^" + re.escape(why)):
        measured()


@pytest.mark.parametrize("counts, number", [([], 0.0), ([4], 1.0), ([3, 3, 3], 3.0), ([1, 1, 2], 2**1.5)])
def test_shannon_number(counts, number):
    assert bodies.shannon_number(numpy.array(counts)) == pytest.approx(number)


@pytest.mark.parametrize(
    "a, b, distance",
    [
        ("core", "core", 0),
        ("core", "core[front:hinge0[front:brick1]]", 2),
        ("core[front:hinge0]", "core[front:hinge1]", 1),
        ("core[front:hinge0]", "core[left:brick1]", 1),
        ("core[front:hinge0[front:brick0]]", "core[front:brick0]", 1),
        ("core[front:brick0[left:hinge0 right:hinge0]]", "core[left:hinge0 right:hinge0]", 1),
        ("core[front:brick0 left:hinge0]", "core[left:hinge0]", 1),
    ],
)
def test_the_edit_distance_is_the_number_of_modules_that_change(a, b, distance):
    assert edit_distance(read_plan(a), read_plan(b)) == edit_distance(read_plan(b), read_plan(a)) == distance


def test_distances_are_from_the_first_of_a_species_by_id():
    assert distances_from_first(
        [4, 0, 1], ["prey", "prey", "predator"], ["core", "core[left:hinge0]", "core[left:hinge1]"]
    ) == [1, 0, 0]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "core[",
        "core[front:hinge4]",
        "core]",
        "core[front:hinge0 ]",
        "core[front:hinge0][back:brick0]",
        "core[up:hinge0]",
    ],
)
def test_a_text_that_is_not_a_plan_is_refused(text):
    with pytest.raises(ValueError, match="must be"):
        read_plan(text)


def test_a_plan_of_a_thousand_modules_is_read():
    assert len(read_plan("core" + "[front:brick0" * 999 + "]" * 999).labels) == 1000
