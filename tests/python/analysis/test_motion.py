# SPDX-License-Identifier: MIT
"""Locked robots, metrics without them, and how robots walk, lie and touch walls."""
import math

import numpy
import pandas
import pytest
from hand_written import WEB, agents, event, events, robot, write_run
from trophic import judge, pool
from trophic.metrics import (
    AGENTS,
    OPTIONAL,
    READINGS,
    Agents,
    Measuring,
    living,
    locked,
    motion,
    names_of,
    shipped,
    walls,
)
from trophic.runs import RunError
from trophic.values import Metric

NAN = math.nan


def pair(ticks, apart_m=0.29, last=20, **of_second):
    """A prey (0) at rest and a predator (1), `apart_m` from it at these ticks and far away at the others up to `last`."""
    return [
        row
        for tick in range(last + 1)
        for row in (robot(tick, 0, "prey"), robot(tick, 1, "predator", apart_m if tick in ticks else 5.0, **of_second))
    ]


@pytest.mark.parametrize(
    "ticks, apart_m, share, pairs, longest_s",
    [
        (range(3, 10), 0.29, 7 / 21, 7 / 21, 12.0),
        (range(3, 9), 0.29, 0.0, 6 / 21, 10.0),
        (range(3, 10), 0.31, 0.0, 0.0, 0.0),
        ([*range(3), *range(4, 11)], 0.2, 7 / 21, 10 / 21, 12.0),
        ([*range(0, 6), *range(7, 13)], 0.2, 0.0, 12 / 21, 10.0),
        (range(21), 0.0, 1.0, 1.0, 40.0),
    ],
)
def test_a_pair_that_stays_near_for_12_s_is_locked_from_its_first_to_its_last_tick(
    ticks, apart_m, share, pairs, longest_s
):
    robots = agents(*pair(ticks, apart_m))
    found = locked.locks(robots)
    assert (found.row[::2].mean(), found.row[1::2].mean()) == pytest.approx((share, share))
    assert (found.pairs.mean(), found.longest_s) == pytest.approx((pairs, longest_s))


def test_a_robot_near_one_and_then_near_another_is_not_locked_and_a_birth_ends_no_lock():
    rows = [
        row
        for tick in range(9)
        for row in (
            robot(tick, 0, "prey"),
            robot(tick, 1, "prey", 0.1 if tick < 4 else 3.0),
            robot(tick, 2, "predator", 9.0 if tick < 4 else -0.1),
        )
    ]
    assert not locked.locks(agents(*rows)).row.any()
    born = locked.locks(
        agents(*({**row, "id": 77} if row["id"] == 1 and row["tick"] > 3 else row for row in pair(range(7), last=6)))
    )
    assert born.row.all() and born.longest_s == 12.0
    empty = locked.locks(agents())
    assert (len(empty.row), len(empty.pairs)) == (0, 0) and math.isnan(empty.longest_s)


def test_locks_are_those_of_every_pair_tried_out():
    generator = numpy.random.default_rng(1)
    place_m = numpy.cumsum(generator.normal(0, 0.06, (40, 12, 2)), axis=0)
    robots = agents(
        *(robot(tick, i, "prey" if i % 2 else "predator", *place_m[tick, i]) for tick in range(40) for i in range(12))
    )
    near = numpy.linalg.norm(place_m[:, :, None] - place_m[:, None], axis=-1) <= 0.3
    expected = numpy.zeros((40, 12), bool)
    for first in range(34):
        expected[first : first + 7] |= (near[first : first + 7].all(axis=0) & ~numpy.eye(12, dtype=bool)).any(axis=1)
    found = locked.locks(robots)
    assert 0 < expected.mean() < 1 and (found.row.reshape(40, 12) == expected).all()
    assert found.pairs.tolist() == ((near.sum(axis=(1, 2)) - 12) / 2).tolist()


def measured(rows, of_events=(), **how):
    frames = pandas.DataFrame(of_events, columns=list(events().columns)), pandas.DataFrame(
        rows, columns=[*AGENTS, "tilt_rad", "touches_wall"]
    )
    found = shipped(WEB, *frames, **{"until_s": 6000.0, "floor": walls.Floor(10.0), **how}).rows
    return {Metric(*row[:4]): row[6] for row in found if row[4] == ""}


def value(found, name):
    (number,) = (number for of, number in found.items() if str(of) == name)
    return number


def test_metrics_without_locked_robots_are_those_of_the_others():
    # At a wall lie a predator and a prey, of other tags and locked; a predator walks 0.1 m a tick to a prey in the open.
    rows = [
        row
        for tick in range(10)
        for row in (
            robot(tick, 0, "prey", 9.5, adversary_id=1, tag=-1),
            robot(tick, 1, "predator", 9.4, adversary_id=0, tag=-1),
            robot(tick, 2, "prey"),
            robot(tick, 3, "predator", 5 - 0.1 * tick, adversary_id=2),
        )
    ]
    of_events = [
        event("catch", 10, 1, "predator"),
        event("catch", 10, 3, "predator", origin="inherited"),
        event("death", 10, 0, "prey", cause="caught"),
        event("catch", 0, 1, "predator", origin="inherited"),
    ]
    found = measured(rows, of_events)
    expected = {
        "locked:prey:all": 0.5,
        "locked:all:all": 0.5,
        "near_pairs:all:all": 1.0,
        "near_longest:all:all": 18.0,
        "velocity:predator:all": 0.025,
        "velocity_not_locked:predator:all": 0.05,
        "velocity_not_locked:prey:all": NAN,
        "velocity_open:predator:inherited": 0.05,
        "wall_sticking:prey:all": 0.5,
        "wall_sticking_not_locked:prey:all": 0.0,
        "wall_sticking_gap_not_locked:prey-predator:all": 0.0,
        "tag_symmetry:prey+predator:inherited": 0.0,
        "tag_symmetry_not_locked:prey+predator:inherited": 2.0,
        "attribution_catches:predator:all": 2 / 3,
        "attribution_catches_not_locked:predator:all": 1.0,
        "attribution_caught:prey:all": 0.0,
        "attribution_caught_not_locked:prey:all": NAN,
    }
    assert {name: value(found, name) for name in expected} == pytest.approx(expected, nan_ok=True)
    lost = measured(rows[::5], of_events, every_ticks=5)
    assert all(
        math.isnan(number) for name, number in lost.items() if name.metric in ("locked", "near_pairs", "near_longest")
    )


def test_a_clock_of_1_2_simulated_seconds_a_second():
    found = measured(
        [
            row
            for tick in range(9)
            for row in (robot(tick, 0, "prey"), robot(tick, 1, "predator", 5 - 0.12 * tick, adversary_id=0))
        ],
        simulated_s_per_s=1.2,
    )
    assert [value(found, f"{name}:predator:all") for name in ("velocity", "velocity_simulated")] == pytest.approx(
        [0.06, 0.05]
    )


def test_readings_are_tested_with_what_they_read():
    names = [*names_of(WEB), *living.names(WEB, True)]
    plain = {name: READINGS[name.metric] for name in names if name.metric in READINGS}
    assert {name.metric for name in plain} == set(READINGS) and {(of, *name[1:3]) for name, of in plain.items()} <= {
        name[:3] for name in names
    }
    values = {name: numpy.random.default_rng(i).normal(size=8) for i, name in enumerate(names)}
    assert {later: earlier.metric for later, earlier in judge.repeated_values(values).items()} == plain


def walk(lies=(), touches=()):
    """A prey that walks 0.1 m a tick from 0 to the wall at 10 m, and a predator that rests."""
    return [
        {**row, "tilt_rad": 3.0 if tick in lies else 0.1, "touches_wall": float(tick in touches)}
        for tick in range(101)
        for row in (robot(tick, 0, "prey", 0.1 * tick), robot(tick, 1, "predator"))
    ]


def test_speed_in_the_open_is_away_from_walls_and_upright_speed_of_those_that_stand():
    rows = [
        {**row, "y_m": 0.3 * row["tick"] if row["tick"] > 90 else 0.0}
        for row in walk(lies=range(50, 81), touches=[100])
    ]
    of = {name: means.mean for name, means in motion.curves(agents_of(rows), "prey", walls.Floor(10.0)).items()}
    assert of["open_speed"] == pytest.approx(0.05) and of["upright_speed"] == pytest.approx(0.05) and of["walked"] > 0.1
    assert (of["overturned"], of["wall_contact"]) == pytest.approx((31 / 101, 1 / 101))
    rows = [
        {**row, "x_m": 2.0} if row["tick"] in range(50, 81) and row["id"] == 0 else row
        for row in walk(lies=range(49, 82))
    ]
    of = motion.curves(agents_of(rows), "prey", walls.Floor(10.0))
    assert of["upright_speed"].mean == pytest.approx(0.05) and of["open_speed"].mean != pytest.approx(0.05)
    unknown = motion.curves(agents(*walk()), "prey", walls.Floor(10.0))
    assert all(math.isnan(unknown[name].mean) for name in ("upright_speed", "overturned", "wall_contact"))


def agents_of(rows):
    return Agents(pandas.DataFrame(rows, columns=[*AGENTS, "tilt_rad", "touches_wall"]), WEB)


SENSES = "time_s,tick,body,tilt_rad,touches_wall\n" + "".join(
    f"{2 * tick},{tick},{body},{tilt},{wall}\n"
    for tick, body, tilt, wall in [(0, 0, 3.0, 1), (0, 1, 0.1, 0), (1, 1, "", ""), (1, 0, 0.2, 0)]
)


@pytest.mark.parametrize(
    "files, params, overturned, wall_contact",
    [
        ({"senses.csv": SENSES}, {}, {"prey": 1.0, "predator": 0.0}, {"prey": 1.0, "predator": 0.0}),
        ({}, {"radius_m": 0.5}, {}, {"prey": 1.0, "predator": 0.0}),
        ({}, {"radius_m": 0.4}, {}, {"prey": 0.0, "predator": 0.0}),
        ({}, {}, {}, {}),
    ],
)
def test_tilt_and_contacts_come_from_senses_csv_or_from_the_radius_of_points(
    tmp_path, files, params, overturned, wall_contact
):
    write_run(tmp_path / "run", files=files, params={"backend": params})
    (values,) = pool.read_set([tmp_path / "run"]).values
    for metric, expected in (("overturned", overturned), ("wall_contact", wall_contact)):
        rows = values.values[values.values.metric == metric]
        assert dict(zip(rows.species, rows.value)) == expected
    (asked,) = pool.read_set([tmp_path / "run"], how=Measuring(metrics=["overturned"])).values
    assert set(OPTIONAL) & set(asked.values.metric) >= {"overturned"}


def test_a_cell_of_senses_csv_must_be_a_number(tmp_path):
    write_run(tmp_path / "run", files={"senses.csv": SENSES.replace("0.1", "steep")})
    with pytest.raises(RunError, match='senses.csv:3: tilt_rad = "steep": must be a number'):
        pool.read_set([tmp_path / "run"])
