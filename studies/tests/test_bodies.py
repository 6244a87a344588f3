# SPDX-License-Identifier: MIT
"""Runs in which bodies, gaits and brains evolve are recorded, measured and met in contests. Those with bodies need MuJoCo."""

import json
import shutil
import subprocess

import bodies_race
import numpy
import pytest

FEW = ["--duration", 8, "--set", "ecology.robots=8", "--set", "rules.community.predators=4", "--set", "rules.starvation.interval.base_ticks=1",
       "--set", "rules.floor.floor=1", "--set", "physics.timestep_s=0.002"]  # fmt: skip
needs_mujoco = pytest.mark.skipif(
    "mujoco" not in subprocess.run(["trophic-bodies", "--version"], capture_output=True, text=True).stdout,
    reason="built without MuJoCo",
)


def measured(folder, runs):
    folder.run("trophic", "analyze", runs, "--bodies", "--out", f"{runs}-measured")
    return {
        (row["metric"], row["species"], row["group"]): row["value"]
        for row in folder.rows(f"{runs}-measured/metrics.csv")
        if not row["time_s"]
    }


@needs_mujoco
def test_bodies_start_from_walkers_and_change_in_the_offspring(folder):
    folder.run("trophic-bodies", "--rules", "evolving_bodies", "--backend", "mujoco", *FEW, "--out", "run")
    bodies = folder.rows("run/bodies.csv")
    assert [row["id"] for row in bodies] == [
        row["id"] for row in folder.rows("run/events.csv") if row["event"] == "birth"
    ]
    assert len(bodies) > 8 and len({(row["species"], row["modules_text"]) for row in bodies[:8]}) == 2
    found = measured(folder, "run")
    for metric, species, least in (
        ("body_modules", "predator", 1.0),
        ("walked", "predator", 0.0),
        ("gait_genes", "prey", 6.0),
    ):
        assert float(found[metric, species, "late"]) > least, metric
    folder.run("trophic", "plot", "run-measured")
    captions = json.loads((folder.path / "run-measured/figures/captions.json").read_text())
    assert list(captions) == ["measures", "morphospace", "plans"]
    assert f"of {len({row['plan'] for row in bodies})} plans)" in captions["plans"]


@needs_mujoco
def test_a_pond_begets_bodies_and_gaits_in_growing_numbers(folder):
    few = [
        *FEW[:2],
        "--set",
        "ecology.robots=20",
        *FEW[4:6],
        *FEW[-2:],
        "--set",
        "rules.recruitment.spare_bodies=12",
        "--set",
        "rules.recruitment.birth_J=25",
    ]
    folder.run("trophic-bodies", "--rules", "evolving_pond", "--backend", "mujoco", *few, "--out", "run")
    born = [row for row in folder.rows("run/bodies.csv") if row["parent_plan"]]
    assert {row["species"] for row in born} == {"prey", "predator"}
    assert any(float(row["edit_distance"]) > 0 for row in born)
    assert int(folder.rows("run/energy.csv")[-1]["tick"]) == 4
    short = ["--against", "own", "--epochs", "0,8", "--team-size", 2, "--teams", 2, "--duration", 100, "--reach", 2.5]
    folder.run("trophic", "contest", "run", "--program", shutil.which("trophic-bodies"), *short, "--out", "met")
    assert len({row["contact_s"] for row in folder.rows("met/contests.csv")}) > 2


@needs_mujoco
def test_a_side_of_the_race_inherits_gaits_that_mutate_and_the_other_begins_anew(folder):
    sets = ["ecology.robots=30", "rules.community.predators=10", "rules.recruitment.spare_bodies=15", "rules.recruitment.birth_J=20",
            "physics.timestep_s=0.002", "rules.heredity.predator.inherited=false", "rules.gait.prey.first_sd=1"]  # fmt: skip
    options = [part for each in sets for part in ("--set", each)]
    folder.run(
        "trophic-bodies", "--rules", "gaits_race", "--backend", "mujoco", "--duration", 20, *options, "--out", "run"
    )
    genes, born = bodies_race.gaits(folder.path / "run"), {"prey": 0, "predator": 0}
    for row in folder.rows("run/phylogeny.csv"):
        if float(row["origin_time"]) > 0.0:
            own, parent = genes.loc[int(row["id"])], genes.loc[int(row["ancestor_id"])]
            born[row["species"]] += 1
            if row["species"] == "prey":  # founders differ by far more than a mutation of sd 0.05
                assert 0.0 < numpy.abs(own - parent).max() < 0.25
            assert row["species"] == "prey" or numpy.abs(own - bodies_race.SHIPPED).max() < 0.25
    assert min(born.values()) > 1


def test_brains_evolve_without_bodies_and_only_their_genes_are_measured(folder):
    folder.run(
        "trophic-bodies", "--rules", "evolving_brains", "--backend", "kinematic", "--duration", 600, "--out", "run"
    )
    found = measured(folder, "run")
    assert float(found["brain_genes", "predator", "late"]) > 10.0
    assert found["body_modules", "predator", "late"] == ""
