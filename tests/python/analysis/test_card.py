# SPDX-License-Identifier: MIT
"""The docstrings of policies in the terminal."""
import re

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


def test_every_policy_says_how_many_random_numbers_it_draws():
    policies = [path for path in card.include_folder().glob("trophic/*/*/**/*.hpp") if "string_view source" in path.read_text()]
    assert len(policies) > 100
    assert not [str(path) for path in policies if path.name not in ("list.hpp", "per_species.hpp") and not re.search(r"Random\s+(/// )?draws", path.read_text())]
