# SPDX-License-Identifier: MIT
import math

import numpy
import pytest
from hand_written import agents, robot
from trophic.metrics import velocity


def approach(from_x_m=5.0, to_x_m=4.4, last=6, step=1, **changes):
    """A prey (0) at rest and a predator (1) on the x axis that walks towards it; `changes`: functions of the tick for the predator's row."""
    rows = []
    for tick in range(0, last + 1, step):
        walker = dict(x_m=from_x_m + (to_x_m - from_x_m) * tick / 6, adversary_id=0)
        rows += [
            robot(tick, 0, "prey"),
            {**robot(tick, 1, "predator", **walker), **{name: change(tick) for name, change in changes.items()}},
        ]
    return rows


def of(rows):
    return velocity.samples(agents(*rows)).velocity_m_s


@pytest.mark.parametrize(
    "rows, expected",
    [
        (approach(), [0.05]),  # tick 0 only: the others have no tick six later, and the prey has no adversary
        (approach(to_x_m=5.3), [-0.025]),
        (
            [{**row, "x_m": -100.0} if row["id"] == 0 and row["tick"] else row for row in approach()],
            [0.05],
        ),  # its own walk does not count
        (
            [{**row, "id": 77} if row["body"] == 0 and row["tick"] > 2 else row for row in approach()],
            [0.05],
        ),  # it may die
        (approach(id=lambda tick: 78 if tick > 4 else 1, body=lambda tick: 1), []),  # born meanwhile
        (approach(adversary_id=lambda tick: math.nan), []),
        (approach(last=5), []),
        ([], []),
    ],
)
def test_the_approach_to_where_the_adversary_was(rows, expected):
    assert of(rows) == pytest.approx(expected)


def test_the_stored_adversary_follows_its_body_and_outlives_births():
    # The predator sees the prey at tick 0 only; from then on the prey's body stands elsewhere, and has another occupant.
    rows = approach(5.0, 5.6, 7, adversary_id=lambda tick: 0 if tick == 0 else math.nan)
    rows = [{**row, "id": 77, "x_m": 10.0} if row["body"] == 0 and row["tick"] else row for row in rows]
    assert velocity.stored_samples(agents(*rows)).velocity_m_s == pytest.approx([-0.05, 0.05])
    rows = approach(
        5.0, 4.4, 7, id=lambda tick: 78 if tick else 1, adversary_id=lambda tick: 0 if tick == 0 else math.nan
    )
    found = velocity.stored_samples(agents(*rows))
    assert (found.row.tolist(), found.velocity_m_s) == (
        [3],
        pytest.approx([0.05]),
    )  # at tick 1; the individual of tick 0 is dead at tick 6
    assert len(velocity.stored_samples(agents(*approach(adversary_id=lambda tick: math.nan))).row) == 0
    assert len(velocity.stored_samples(agents()).row) == 0


@pytest.mark.parametrize("active_at_start", [0, 1])
def test_active_is_who_is_active_at_the_start(active_at_start):
    robots = agents(*approach(active=lambda tick: active_at_start if tick == 0 else 1 - active_at_start))
    found = velocity.velocity(velocity.samples(robots), robots, "predator", "active").mean_of_points
    assert found == pytest.approx(0.05 if active_at_start else math.nan, nan_ok=True)


def test_points_are_the_stretches_that_end_at_200_400_to_6000_s():
    # A predator that walks 1 m from 188 to 200 s, ..., and stands in between, towards a prey at rest.
    x_m = 100.0 - numpy.cumsum([tick > 0 and (tick - 1) % 100 >= 94 for tick in range(3001)]) / 6
    robots = agents(*approach(last=3000, x_m=lambda tick: x_m[tick]))
    walks = velocity.samples(robots)
    points = velocity.at_marks(walks, robots)
    assert robots.time_s[points.end].tolist() == [200.0 * k for k in range(1, 31)]
    curve = velocity.velocity(points, robots, "predator", "all")
    assert (curve.mean_of_points, curve.time_s[0], len(curve.points)) == (pytest.approx(1 / 12), 200.0, 30)
    assert velocity.velocity(walks, robots, "predator", "all").mean_of_points < 0.5 / 12


def test_points_without_a_row_at_the_mark_are_the_next_stretch():
    robots = agents(*approach(last=210, step=3))
    assert robots.time_s[velocity.at_marks(velocity.samples(robots), robots).end].tolist() == [204.0, 402.0]
    for rows in ((), approach()):
        assert len(velocity.at_marks(velocity.samples(agents(*rows)), agents(*rows)).row) == 0
