# SPDX-License-Identifier: MIT
"""Each reading of the paper's open choices is the policy that it names."""

import json
import tomllib

import pytest
from conftest import STUDIES

TABLES = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"]
RUN = ["--backend", "kinematic", "--duration", 1500]
CHOICES = {
    choice["name"]: choice for choice in tomllib.loads((STUDIES / "readings/open_choices.toml").read_text())["choice"]
}
# Choices whose other reading is the policy of the table `released`, and the other rules that the ablation study sets there.
AS_ABLATION = {"decision_order": ("ecology.decision_order", []), "blind_robot": ("ecology.without_target", []), "tag_ratio": ("sensor_tag_ratio_of_active", []),
               "orphan_label": ("genome_source", ["--set", "rules.genome_source.second.random_share=0.34"])}  # fmt: skip


def second(choice):
    return [part for setting in choice["second"] for part in ("--set", setting)]


def test_first_readings_are_the_table_paper(folder):
    folder.run("trophic-predator-prey", *RUN, "--rules", "paper", "--out", "paper")
    folder.run("trophic-readings", *RUN, "--out", "first")
    assert folder.bytes_of("first", TABLES) == folder.bytes_of("paper", TABLES)


def test_each_other_reading_changes_the_run_unless_it_needs_bodies(folder):
    folder.run("trophic-readings", *RUN, "--out", "first")
    first = folder.bytes_of("first", TABLES)
    for name, choice in CHOICES.items():
        folder.run("trophic-readings", *RUN, *second(choice), "--out", name)
        assert (folder.bytes_of(name, TABLES) != first) == choice["screen"], name


@pytest.mark.parametrize("name", AS_ABLATION)
def test_other_readings_are_the_policies_of_the_ablation_study(folder, name):
    swap, settings = AS_ABLATION[name]
    folder.run(
        "trophic-ablations",
        "--from",
        "paper",
        "--only",
        swap,
        "--replicates",
        1,
        "--duration",
        1500,
        "--backend",
        "kinematic",
        "--out",
        "ablation",
    )
    (run,) = folder.path.glob(f"ablation/from_paper/{swap}/replicate-*")
    seed = json.loads((run / "manifest.json").read_text())["seed"]
    folder.run("trophic-readings", *RUN, "--seed", seed, *second(CHOICES[name]), *settings, "--out", "ours")
    assert folder.bytes_of("ours", TABLES) == folder.bytes_of(run, TABLES)


def test_the_cells_of_the_study_of_slow_predators_are_accepted(folder):
    sweep = STUDIES / "slow_predators/slow_predators.toml"
    if ", mujoco" not in folder.call("trophic-readings", "--help").stdout:
        pytest.skip("needs mujoco")
    folder.run("trophic", "plan", sweep, "--program", "trophic-readings", "--out", "plan")
    assert len((folder.path / "plan/plan.jsonl").read_text().splitlines()) == 96
