# SPDX-License-Identifier: MIT
import math

import pytest
from hand_written import WEB, event, events
from trophic.metrics import Web, attribution

# Prey 0 and 1 (random) and 2 (inherited), hunters 3 (random) and 4 (inherited). Hunter 4 catches 0 and 2, hunter 3 catches 1.
HISTORY = (
    event("birth", 0, 0, "prey"),
    event("birth", 0, 1, "prey"),
    event("birth", 0, 2, "prey", origin="inherited"),
    event("birth", 0, 3, "predator"),
    event("birth", 0, 4, "predator", origin="inherited"),
    event("catch", 2, 4, "predator", origin="inherited", victim_id=0),
    event("death", 2, 0, "prey", cause="caught"),
    event("birth", 2, 5, "predator", body=0, origin="inherited"),
    event("catch", 4, 4, "predator", origin="inherited", victim_id=2),
    event("death", 4, 2, "prey", origin="inherited", cause="caught"),
    event("birth", 4, 6, "predator", body=2, origin="inherited"),
    event("catch", 6, 3, "predator", victim_id=1),
    event("death", 6, 1, "prey", cause="caught"),
    event("birth", 6, 7, "predator", body=1),
)
# Body 0 becomes a prey again and is sacrificed. Body 4 once caught it; its present occupant is a random hunter.
SACRIFICE = (
    event("death", 8, 5, "predator", body=0, origin="inherited", cause="starved"),
    event("birth", 8, 8, "prey", body=0, origin="inherited"),
    event("birth", 8, 9, "predator", body=4),
    event("death", 9, 8, "prey", body=0, origin="inherited", cause="sacrificed"),
)
NEVER_CAUGHT = (
    event("birth", 0, 0, "prey"),
    event("birth", 0, 1, "predator", origin="inherited"),
    event("death", 9, 0, "prey", cause="sacrificed"),
)
QUIET = (
    event("birth", 0, 0, "prey"),
    event("birth", 0, 1, "predator"),
    event("death", 9, 1, "predator", cause="starved"),
)


@pytest.mark.parametrize(
    "rows, caught, catches, catchers, died, credited",
    [
        (HISTORY, 1 / 3, 2 / 3, 1 / 2, 1 / 3, 2 / 3),
        (HISTORY + SACRIFICE, 1 / 3, 2 / 3, 1 / 2, 2 / 4, 2 / 4),
        (NEVER_CAUGHT, math.nan, math.nan, math.nan, 0.0, 1.0),  # a body that was never caught has the killer in body 1
        (QUIET, *[math.nan] * 5),
        ((), *[math.nan] * 5),
    ],
)
def test_shares_of_the_inherited(rows, caught, catches, catchers, died, credited):
    found = (
        attribution.caught(events(*rows), "prey"),
        attribution.catches(events(*rows), "predator"),
        attribution.catchers(events(*rows), "predator"),
        attribution.died(events(*rows), "prey"),
        attribution.credited(events(*rows), WEB, "predator"),
    )
    assert found == pytest.approx((caught, catches, catchers, died, credited), nan_ok=True)


def test_a_species_that_hunts_and_is_hunted_has_both():
    web = Web(["grass", "sheep", "wolf"], [("sheep", "grass"), ("wolf", "sheep")])
    rows = events(
        event("birth", 0, 0, "grass", origin="inherited"),
        event("birth", 0, 1, "sheep"),
        event("birth", 0, 2, "wolf", origin="inherited"),
        event("catch", 2, 1, "sheep", victim_id=0),
        event("death", 2, 0, "grass", origin="inherited", cause="caught"),
        event("catch", 4, 2, "wolf", origin="inherited", victim_id=1),
        event("death", 4, 1, "sheep", cause="caught"),
    )
    assert [attribution.caught(rows, species) for species in web.species] == pytest.approx(
        [1.0, 0.0, math.nan], nan_ok=True
    )
    assert [attribution.catches(rows, species) for species in web.species] == pytest.approx(
        [math.nan, 0.0, 1.0], nan_ok=True
    )
    assert attribution.credited(rows, web, "sheep") == 0.0
