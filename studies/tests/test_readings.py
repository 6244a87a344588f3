# SPDX-License-Identifier: MIT
"""Each reading of the paper's open choices is the policy that it names."""

import tomllib

import pytest
from conftest import STUDIES

TABLES = ["events.csv", "agents.csv", "phylogeny.csv", "genomes.csv"]
RUN = ["--backend", "kinematic", "--duration", 1500]
CHOICES = {
    choice["name"]: choice for choice in tomllib.loads((STUDIES / "readings/open_choices.toml").read_text())["choice"]
}
# Choices whose other reading is the policy of the table `released`: as the ablation study has it, and the number that it sets there.
AS_ABLATION = {"decision_order": (["--set", "ecology.decision_order=in_turn"], []), "blind_robot": (["--set", "ecology.without_target=keeps_decision"], []),
               "tag_ratio": (["--rules", "paper_tag_ratio_of_active"], []),
               "orphan_label": (["--rules", "paper_genome_source"], ["--set", "rules.genome_source.second.random_share=0.34"])}  # fmt: skip


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
    folder.run("trophic-ablations", *RUN, *swap, "--out", "ablation")
    folder.run("trophic-readings", *RUN, *second(CHOICES[name]), *settings, "--out", "ours")
    assert folder.bytes_of("ours", TABLES) == folder.bytes_of("ablation", TABLES)


def test_the_cells_of_the_study_of_slow_predators_are_accepted(folder):
    sweep = STUDIES / "slow_predators/slow_predators.toml"
    if ", mujoco" not in folder.call("trophic-readings", "--help").stdout:
        pytest.skip("needs mujoco")
    folder.run("trophic", "plan", sweep, "--program", "trophic-readings", "--out", "plan")
    assert len((folder.path / "plan/plan.jsonl").read_text().splitlines()) == 96
