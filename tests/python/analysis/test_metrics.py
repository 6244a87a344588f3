# SPDX-License-Identifier: MIT
"""Windows of time, walls, populations, stuck robots, and all metrics of a run."""
import math

import numpy
import pandas
import pytest
from hand_written import WEB, agents, event, events, robot
from trophic import help as trophic_help
from trophic.metrics import AGENTS, EVENTS, Web, demography, living, lost_to_thinning, shipped, stuck, velocity, walls
from trophic.metrics.tables import means, window_of

NAN = math.nan


def test_windows_are_closed_at_their_end_and_one_without_values_is_none():
    time_s = numpy.array([0.0, 10.0, 20.0, 30.5])
    found = means(window_of(time_s, 10.0), numpy.array([1.0, 3.0, NAN, 8.0]), 10.0)
    assert found.time_s.tolist() == [10.0, 20.0, 30.0, 40.0]
    assert found.points.tolist() == pytest.approx([2.0, NAN, NAN, 8.0], nan_ok=True)
    assert (found.mean, found.mean_of_points) == (4.0, 5.0)
    empty = means(window_of(numpy.empty(0)), numpy.empty(0))
    assert math.isnan(empty.mean) and len(empty.points) == 0
    with pytest.raises(ValueError, match="window_s = 0: must be > 0"):
        means(window_of(time_s), time_s, 0.0)


def test_rows_are_found_by_tick_and_individual_or_body():
    robots = agents(robot(1, 7, "prey"), robot(1, 3, "prey"), robot(4, 3, "prey"))
    at, ids = numpy.array([0, 0, 0, 1, -1, 0]), numpy.array([3, 7, 5, 3, 3, NAN])
    assert robots.find(at, ids).tolist() == [1, 0, -1, 2, -1, -1]
    assert robots.find_body(at, ids).tolist() == [1, 0, -1, 2, -1, -1]
    assert (robots.later(3).tolist(), robots.later(2).tolist()) == ([1, -1], [-1, -1])
    assert agents().find(numpy.array([0]), numpy.array([0])).tolist() == [-1]


@pytest.mark.parametrize(
    "group, members", [("all", 4), ("random", 2), ("inherited", 2), ("active", 2), ("inherited_active", 1)]
)
def test_groups(group, members):
    robots = agents(
        *(
            robot(1, 2 * active + (origin == "random"), "prey", origin=origin, active=active)
            for active in (0, 1)
            for origin in ("random", "inherited")
        )
    )
    assert robots.of("prey", group).sum() == members and robots.of("predator", group).sum() == 0


def test_within_1_m_of_any_wall_sticks():
    robots = agents(
        robot(1, 0, "prey", 9.0, 0.0),
        robot(1, 1, "prey", 0.0, -9.5),
        robot(1, 2, "prey", 8.99, 8.99),
        robot(1, 3, "predator"),
        robot(2, 0, "prey"),
        robot(2, 1, "prey", 11.0, 0.0, active=0),
        robot(2, 3, "predator", -9.9, 9.9),
        robot(3, 3, "predator", 9.9, 0.0),
    )
    assert walls.wall_sticking(robots, "prey", "all", walls.Floor(10.0)).mean == pytest.approx(
        (2 / 3 + 1 / 2) / 2
    )  # no prey at tick 3
    assert walls.wall_sticking(robots, "prey", "active", walls.Floor(10.0)).mean == pytest.approx((2 / 3 + 0) / 2)
    assert walls.wall_sticking(robots, "prey", "all", walls.Floor(10.0), 2.0).mean == pytest.approx((1 + 1 / 2) / 2)
    assert walls.wall_sticking(robots, "predator", "all", walls.Floor(10.0)).mean == pytest.approx(2 / 3)
    assert math.isnan(walls.wall_sticking(robots, "predator", "random", walls.Floor(10.0)).mean)
    court = walls.Floor(10.0, [[0.0, 0.0, 0.0, 0.0, 2.0, 0.5], [-5.0, 3.0, 5.0, 3.0, 0.5, 0.5]])
    assert list(court.to_wall_m(numpy.array([0.0, 0.0, 9.5, 6.0]), numpy.array([0.0, 2.5, 0.0, 3.0]))) == pytest.approx(
        [-2.0, 0.0, 0.5, 0.5]
    )
    near = (
        math.pi * (3.0**2 - 2.0**2) / 2 + 400 - 18.0**2
    )  # a part of the ring around the pillar, and the band at the walls
    assert near / 400 < walls.share_of_floor(court) < 0.45
    assert (
        walls.wall_sticking(robots, "prey", "all", walls.Floor(100.0, [[0.0, 0.0, 0.0, 0.0, 200.0, 1.0]])).mean == 1.0
    )
    assert (walls.share_of_floor(walls.Floor(10.0)), walls.share_of_floor(walls.Floor(0.5))) == (
        pytest.approx(0.19),
        1.0,
    )


def test_populations_hunger_and_crowds():
    robots = agents(
        robot(1, 0, "prey"),
        robot(1, 1, "predator", hunger_ticks=4),
        robot(1, 2, "predator", origin="random", hunger_ticks=10),
        robot(2, 0, "prey"),
    )
    assert [demography.population_size(robots, "predator", group).mean for group in ("all", "random")] == [1.0, 0.5]
    assert demography.hunger(robots, "predator").mean == 7.0 and math.isnan(demography.hunger(robots, "prey").mean)
    assert [demography.ticks_at(robots, "predator", members).mean for members in (2, 0, 1)] == [0.5, 0.5, 0.0]
    assert math.isnan(demography.population_size(agents(), "prey").mean)


@pytest.mark.parametrize(
    "alive, expected", [("1101", NAN), ("1100", 4.0), ("1010", 6.0), ("0000", NAN), ("1111", NAN), ("", NAN)]
)
def test_the_time_of_extinction_is_when_the_last_one_is_gone_for_good(alive, expected):
    robots = agents(
        *(
            row
            for tick, lives in enumerate(alive)
            for row in [robot(tick, 0, "prey")] + [robot(tick, 1, "predator")] * (lives == "1")
        )
    )
    assert demography.extinct_at(robots, "predator") == pytest.approx(expected, nan_ok=True)
    assert math.isnan(demography.extinct_at(robots, "prey"))


def test_extinction_as_a_share_and_as_a_curve():
    rows = [robot(tick, 0, "prey") for tick in range(0, 301, 50)] + [
        robot(tick, 1, "predator") for tick in range(0, 151, 50)
    ]
    found = shipped(
        WEB,
        events(),
        pandas.DataFrame(sorted(rows, key=lambda row: row["tick"]), columns=list(AGENTS)),
        until_s=600.0,
        floor=walls.Floor(10.0),
    )
    values = {(row[0], row[1]): row[6] for row in found.rows if row[0] in demography.EXTINCTION}
    assert values == pytest.approx(
        {
            ("extinct", "prey"): 0.0,
            ("extinct_at", "prey"): NAN,
            ("extinct", "predator"): 1.0,
            ("extinct_at", "predator"): 400.0,
        },
        nan_ok=True,
    )
    curve = [points.tolist() for name, _, points in found.curves if name[:2] == ("extinct", "predator")]
    assert curve == [[0.0, 1.0, 1.0]]  # at 200, 400 and 600 s


def test_deaths_by_cause_in_all_and_per_window():
    rows = events(
        event("death", 0, 0, "prey", cause="caught"),
        event("death", 200, 1, "prey", cause="sacrificed"),
        event("death", 202, 2, "prey", cause="caught"),
        event("death", 202, 3, "predator", cause="starved"),
    )
    assert [len(demography.deaths(rows, *of)) for of in (("prey",), ("prey", "caught"), ("predator", "caught"))] == [
        3,
        2,
        0,
    ]
    times = demography.deaths(rows, "prey")
    assert [part.tolist() for part in demography.per_window(times, 600.0)] == [[200.0, 400.0, 600.0], [2.0, 1.0, 0.0]]
    assert [len(demography.per_window(times, until_s)[0]) for until_s in (200.0, 200.5, 1e8, 0.0)] == [1, 2, 500_000, 0]


def test_stuck_is_less_than_5_cm_away_after_10_s_wherever_it_was_meanwhile():
    rows = [
        row
        for t in range(6)
        for row in (
            robot(t, 0, "prey", 0.0, 0.0098 * t),
            robot(t, 1, "prey", 3 + 0.0102 * t),
            robot(t, 2, "predator", 5.0 if t == 3 else 1.0),
            robot(t, 3, "predator", 9 - 0.5 * t, 9.0),
            robot(t, 4, "predator", 9 - 0.5 * t, 2.0),
        )
    ]
    assert [stuck.stuck(agents(*rows), species).mean for species in ("prey", "predator", None)] == pytest.approx(
        [1 / 2, 1 / 3, 2 / 5]
    )
    assert stuck.stuck(agents(*rows), "prey", 0.06).mean == 1.0
    born = agents(robot(0, 0, "prey"), robot(5, 77, "predator", body=0))
    assert stuck.stuck(born, "prey").mean == 1.0 and math.isnan(stuck.stuck(born, "predator").mean)
    for never in (agents(robot(0, 0, "prey"), robot(4, 0, "prey"), robot(6, 0, "prey")), agents()):
        assert math.isnan(stuck.stuck(never, "prey").mean)


def measured(web=WEB, of_agents=(), **how):
    frames = pandas.DataFrame(columns=list(EVENTS)), pandas.DataFrame(of_agents, columns=list(AGENTS))
    return shipped(web, *frames, **{"until_s": 6000.0, "floor": walls.Floor(10.0), **how}).rows


def value(rows, *name):
    (found,) = [row[6] for row in rows if row[:3] == name and row[4] == ""]
    return found


def test_an_empty_run_has_every_metric_and_no_value():
    rows = measured()
    assert all(math.isnan(row[6]) for row in rows if row[4] == "")
    names = {row[:3] for row in rows}
    expected = {
        ("attribution_caught", "prey", "all"),
        ("attribution_catchers", "predator", "all"),
        ("ticks_at", "predator", "8"),
        ("stuck", "all", "all"),
        *(
            (metric, "prey", group)
            for metric in ("velocity", "velocity_points", "velocity_stored")
            for group in ("all", "random", "inherited", "active")
        ),
        *(("wall_sticking_gap", "prey-predator", group) for group in ("all", "active")),
        *(("tag_symmetry", "prey+predator", group) for group in ("inherited", "inherited_active")),
    }
    assert expected <= names and not names & {("attribution_caught", "predator", "all"), ("ticks_at", "prey", "8")}


def test_only_permuted_tags_are_a_null_and_what_the_paper_compares_with_is_marked_as_its_own():
    roles = {(row[3], row[4]): row[5] for row in measured() if row[4]}
    assert roles == {
        ("1", "two_thirds"): "paper",
        ("m/s", "zero"): "paper",
        ("1", "uniform_pairs"): "paper",
        ("1", "permuted_tags"): "null",
        ("1", "bernoulli_tags"): "reference",
        ("1", "uniform_density"): "reference",
        ("1", "zero"): "reference",
    }


def test_each_link_of_three_species_is_measured():
    web = Web(["grass", "sheep", "wolf"], [("sheep", "grass"), ("wolf", "sheep")])
    rows = measured(web, [robot(0, 0, "grass", 9.5), robot(0, 1, "sheep"), robot(0, 2, "wolf", tag=-1)])
    assert value(rows, "wall_sticking_gap", "grass-sheep", "all") == 1.0
    assert (
        value(rows, "tag_symmetry", "grass+sheep", "inherited"),
        value(rows, "tag_symmetry", "sheep+wolf", "inherited"),
    ) == (2.0, 0.0)


def test_the_help_lists_every_metric_once_with_its_unit(capsys):
    assert trophic_help.run({"topic": "metrics"}) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert lines[1] == ["metric", "unit", "of"] and ["hunger", "ticks", "predator:all"] in lines
    of = {row[0] for row in measured()} | {name.metric for name in living.names(WEB, True)}
    assert sorted(line[0] for line in lines[2:]) == sorted(of)


@pytest.mark.parametrize("every", [1, 2, 3, 4, 5, 6, 10])
def test_a_thinned_table_gives_the_same_velocities_from_fewer_starts_or_none(every):
    # A predator that walks 0.1 m a tick towards a prey at rest: 0.05 m/s, and neither is stuck.
    rows = measured(
        of_agents=[
            row
            for tick in range(0, 61, every)
            for row in (robot(tick, 0, "prey"), robot(tick, 1, "predator", 9 - 0.1 * tick, adversary_id=0))
        ],
        every_ticks=every,
    )
    expected = {
        "velocity": 0.05 if velocity.TICKS % every == 0 else NAN,
        "velocity_stored": 0.05 if every == 1 else NAN,
        "stuck": 0.0 if stuck.TICKS % every == 0 else NAN,
        "wall_sticking": 1 / 61 if every == 1 else None,
    }
    for metric, number in expected.items():
        assert (
            number is None
            or metric == "wall_sticking"
            or value(rows, metric, "predator", "all") == pytest.approx(number, nan_ok=True)
        ), metric
    assert value(rows, "wall_sticking", "prey", "all") == 0.0


@pytest.mark.parametrize(
    "every, lost",
    [
        (1, ""),
        (
            3,
            "agents.csv: has only ticks that are multiples of 3: no velocity_stored, which needs every tick, no stuck, which needs rows 5 ticks apart",
        ),
        (
            5,
            "agents.csv: has only ticks that are multiples of 5: no velocity_stored, which needs every tick, no velocity, which needs rows 6 ticks apart, "
            "no velocity_points, which needs rows 6 ticks apart, no locked, which needs rows 6 ticks apart",
        ),
    ],
)
def test_what_a_thinned_table_loses_is_said(every, lost):
    assert lost_to_thinning(every) == lost
