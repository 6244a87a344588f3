# SPDX-License-Identifier: MIT
"""`trophic help`: policies, slots and metrics as their headers and modules document them."""
import re

import pytest
from trophic import help as trophic_help
from trophic.errors import RunError

HEADERS = trophic_help.include_folder()


@pytest.mark.parametrize(
    "policy, name, words",
    [
        ("normal_mutation", "NormalMutation", "Random draws"),
        ("killer", "Killer", "Rule"),
        ("own_copy", "OwnCopy", "the offspring's genome is a copy"),
    ],
)
def test_a_policy_has_the_docstring_of_its_header(policy, name, words, capsys):
    trophic_help.run({"topic": policy})
    text = capsys.readouterr().out
    assert text.startswith(f"{policy} ({name}, trophic/") and words in text and "///" not in text


@pytest.mark.parametrize(
    "spelling, first",
    [
        ("Mutation", "mutation (reproduction)"),
        ("TagSwitch", "tag_switch (perception)"),
        ("tagswitch", "tag_switch (perception)"),
        ("OwnCopy", "own_copy (OwnCopy, "),
        ("Slots", "community (initialization)"),
        ("Metrics", "METRIC:SPECIES:GROUP"),
    ],
)
def test_any_spelling_of_a_name_is_that_name(spelling, first, capsys):
    trophic_help.run({"topic": spelling})
    assert capsys.readouterr().out.startswith(first)


def test_every_policy_says_how_many_random_numbers_it_draws():
    policies = [path for path in HEADERS.glob("trophic/*/*/**/*.hpp") if "string_view source" in path.read_text()]
    assert len(policies) > 100
    assert not [
        str(path)
        for path in policies
        if path.name not in ("list.hpp", "per_species.hpp")
        and not re.search(r"Random\s+(/// )?draws", path.read_text())
    ]


def test_every_slot_has_a_sentence_and_the_policies_of_its_folder(capsys):
    trophic_help.run({"topic": "slots"})
    slots = re.findall(r"^(\w+) \((\w+)\)\n  (.*\.)\n  policies: (.*)\n  swap: with_\1<", capsys.readouterr().out, re.M)
    assert [slot for slot, *_ in slots] == list(trophic_help.slots_in(HEADERS)) and len(slots) > 25
    for slot, kind, _, policies in slots:
        folder = HEADERS / "trophic" / kind / slot
        of_parts = dict(part.split(": ") for part in f"{slot}: {policies.removeprefix('list of: ')}".split("; "))
        no_policies = {"contract", "list"} if policies.startswith("list of: ") else {"contract"}
        there = {
            path.parent.name: {other.stem for other in path.parent.glob("*.hpp")} - no_policies
            for path in folder.rglob("contract.hpp")
        }
        assert {part: set(names.split()) for part, names in of_parts.items()} == there


def test_one_slot_the_metrics_and_a_mistake(capsys):
    trophic_help.run({"topic": "parent"})
    assert "the parent of the next individual in a vacant body" in capsys.readouterr().out
    trophic_help.run({"topic": "metrics"})
    assert "velocity_stored" in capsys.readouterr().out
    with pytest.raises(RunError, match="did you mean slots"):
        trophic_help.run({"topic": "slot"})
