# SPDX-License-Identifier: MIT
"""The docstrings of policies in the terminal."""
import pytest
from trophic import card
from trophic.runs import RunError


@pytest.mark.parametrize("policy, name, words", [("normal_mutation", "NormalMutation", "Random draws"), ("killer", "Killer", "Rule"),
                                                 ("own_copy", "OwnCopy", "the offspring's genome is a copy")])
def test_a_policy_has_the_docstring_of_its_header(policy, name, words):
    text = card.card(policy, card.include_folder())
    assert text.startswith(f"{policy} ({name}, trophic/") and words in text and "///" not in text


def test_an_unknown_policy_is_refused():
    with pytest.raises(RunError, match="nosuch: has no header of its own"):
        card.card("nosuch", card.include_folder())
