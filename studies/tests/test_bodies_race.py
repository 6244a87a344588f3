# SPDX-License-Identifier: MIT
"""The race with bodies: walks of single robots, and drift of an inherited trait."""
import csv
import pathlib

import bodies_race
import data_rows
import numpy
import page_tables.bodies_race
import pages
import ponds
import pandas
import pytest


def test_the_frequency_of_a_gait_is_a_multiple_of_the_shipped_one():
    assert bodies_race.frequency(bodies_race.SHIPPED) == pytest.approx(1.0)
    assert bodies_race.frequency(2.5 * bodies_race.SHIPPED) == pytest.approx(2.5)
    apart = numpy.array([0.5, -1.0, 2.0, 0.1, 0, 0, 0, 0, 0, 0])  # oscillators without links: the fastest is 2 rad/s
    shipped = numpy.abs(numpy.linalg.eigvals(bodies_race.generator(bodies_race.SHIPPED)).imag).max()
    assert bodies_race.frequency(numpy.stack([apart, bodies_race.SHIPPED])) == pytest.approx([2.0 / shipped, 1.0])


def test_a_mutation_changes_the_frequency_of_a_gait_less_than_pace():
    rule = bodies_race.FREQUENCY
    genes = rule.first + numpy.random.default_rng(1).normal(0.0, rule.sd, (20000, len(rule.first)))
    assert bodies_race.frequency(genes).std() == pytest.approx(0.018, abs=0.001)
    assert 5.0 < bodies_race.PACE.sd / bodies_race.frequency(genes).std() < 6.0


def written(folder, births):
    """A run of prey of 60 s: ids with their parents (their own id: none) and times of birth and death."""
    rows = [f"{id},{parent},{born},{died},prey" for id, (parent, born, died) in enumerate(births)]
    (folder / "phylogeny.csv").write_text(
        "\n".join(["id,ancestor_id,origin_time,destruction_time,species", *rows]) + "\n"
    )
    return folder


def test_drift_of_each_gene_is_independent_and_makes_the_trait(tmp_path):
    run = written(tmp_path, [(0, 0, 10), (0, 5, 30), (1, 20, 60), (3, 0, 60)])
    pace = bodies_race.PACE.drift(run, {"prey": True}, draws=4000)
    assert pace.mean(axis=1).to_numpy() == pytest.approx(numpy.ones(4), abs=0.02)
    assert pace.std(axis=1).to_numpy() == pytest.approx(0.1 * numpy.sqrt([1, 2, 3, 1]), rel=0.05)
    # a trait of ten genes: their squares add up
    squares = bodies_race.FREQUENCY._replace(of=lambda genes: ((genes - bodies_race.SHIPPED) ** 2).sum(axis=-1))
    found = squares.drift(run, {"prey": True}, draws=4000).mean(axis=1).to_numpy()
    assert found == pytest.approx(10 * 0.05**2 * numpy.array([1, 2, 3, 1]), rel=0.05)
    assert bodies_race.FREQUENCY.drift(run, {"prey": False}).mean(axis=1).to_numpy() == pytest.approx(1.0, abs=0.01)


def test_a_mean_weights_individuals_by_their_time(tmp_path):
    run = written(tmp_path, [(0, 0, 10), (0, 5, 30), (1, 20, "inf")])
    values = pandas.DataFrame({0: [1.0, 2.0, 5.0]})
    assert bodies_race.means_of(run, values, 0.0, 60.0)["prey"] == pytest.approx((10 * 1 + 25 * 2 + 40 * 5) / 75)
    assert bodies_race.means_of(run, values, 25.0, 35.0)["prey"] == pytest.approx((5 * 2 + 10 * 5) / 15)


def family(runs, both, alone):
    """Values of so many runs a world: pace of prey where both inherit and where prey alone do, and 1 otherwise; the first run of each has none."""
    spread, rows = numpy.linspace(-0.1, 0.1, runs), []
    for world, species in bodies_race.WORLDS.items():
        for run in range(runs):
            rows.append(ponds.row_of(world, f"{run:02}", "", ("persists", "all", "all"), float(run > 0)))
            for side, on in zip(bodies_race.SPECIES, species):
                level = {"both": both, "prey": alone}.get(world, 1.0) if side == "prey" else 1.0
                for kind, value in (("end", level), ("late_change", level - 1.0)):
                    key = ("pace", side, kind)
                    if on and run > 0:
                        rows.append(ponds.row_of(world, f"{run:02}", "", key, value + spread[run]))
                        rows.append(ponds.row_of(world, f"{run:02}", "neutral", key, 1.0 if kind == "end" else 0.0))
    return rows


def test_a_family_of_six_finds_what_is_there_and_the_page_shows_it(tmp_path):
    rows = bodies_race.results(family(11, both=1.6, alone=1.2), "pace")
    tested = {(row["set"], row["species"], row["group"]): row for row in rows if row["p"]}
    assert len(tested) == 6 and all(row["runs"] == "10" for row in tested.values())
    assert float(tested["both", "prey", "end"]["difference"]) == pytest.approx(0.6, abs=0.02)
    assert float(tested["both less alone", "prey", "end"]["difference"]) == pytest.approx(0.4, abs=0.001)
    assert {key[1] for key, row in tested.items() if float(row["p_holm"]) < 0.05} == {"prey"}
    assert [row["mean"] for row in rows if row["metric"] == "persists"] == ["0.909091"] * 4
    data = pages.Data(tmp_path)
    assert page_tables.bodies_race.raced_with_bodies(data, "few") == "No run of this design is complete.\n"
    for name, of in (("few", bodies_race.results(family(2, 1.6, 1.2), "pace")), ("all", rows)):
        with open(tmp_path / f"{name}.csv", "w", newline="") as file:
            table = csv.DictWriter(file, of[0].keys(), lineterminator="\n")
            table.writeheader()
            table.writerows(of)
    assert data_rows.read(tmp_path / "few.csv")[0][
        "p"
    ] == "" and "| both | 0.5 |" in page_tables.bodies_race.raced_with_bodies(data, "few")
    assert "+0.61 [" in page_tables.bodies_race.raced_with_bodies(data, "all")


def walks(pace, speeds, overturned):
    return [
        f"spider,{pace},0,{place},{speed},0.03,0.99,0.05,0.1,{share},MuJoCo 2.2.2,abc"
        for place, (speed, share) in enumerate(zip(speeds, overturned))
    ]


def test_the_ceiling_is_below_the_first_pace_at_which_a_walk_turns_over(tmp_path):
    head = "robot,pace,target_angle_rad,place,speed_m_s,error_rad,swing,slip_m_s,airborne,overturned,engine,revision"
    rows = [*walks(1, (0.04, 0.06), (0, 0)), *walks(2, (0.11, 0.09), (0, 0)), *walks(3, (0.2, 0.3), (0, 0.5))]
    (tmp_path / "walks.csv").write_text("\n".join([head, *rows, *walks(4, (0.4, 0.4), (0, 0))]) + "\n")
    rows = bodies_race.walk_rows("as shipped", tmp_path / "walks.csv")
    best, beyond = bodies_race.ceiling(rows)
    assert (best["pace"], best["speed_m_s"], beyond["pace"], beyond["upright_walks"]) == ("2", "0.1", "3", 1)
    assert bodies_race.ceiling(rows[2:3]) == (None, rows[2])
    assert len(bodies_race.walk_facts(tmp_path / "walks.csv")) == 8


def test_speed_is_how_far_an_individual_moves_between_rows_by_its_pace(tmp_path):
    run = tmp_path / "both/replicate-00"
    run.mkdir(parents=True)
    moved = [(12, 1, 0.0, 0.0), (24, 1, 0.3, 0.4), (36, 1, 0.3, 0.4), (12, 2, 1.0, 0.0), (24, 2, 1.0, 0.6)]
    rows = [f"{time_s},{id},prey,{x_m},{y_m},{1.1 if id == 1 else 2.3}" for time_s, id, x_m, y_m in moved]
    (run / "agents.csv").write_text("\n".join(["time_s,id,species,x_m,y_m,walking_pace", *rows, ""]))
    found = bodies_race.speeds_of(tmp_path)
    of = {row["pace_from"]: (row["rows"], float(row["speed_cm_s"])) for row in found}
    assert of == {"1": (2, pytest.approx(100 * 0.5 / 12 / 2, rel=1e-3)), "2.25": (1, pytest.approx(5.0, rel=1e-3))}
    lines = page_tables.bodies_race.speeds(found, fewest=2).splitlines()
    assert lines[2:] == ["| 1 to 1.25 | 2.08 |  |"]


def test_progress_is_that_of_both_epochs_and_over_the_runs_without_inheritance(tmp_path):
    lines = ["against,hunters_run,victims_run,hunter_epoch_s,victim_epoch_s,contact_s"]
    for run in "ab":
        for hunters, victims, contact_s in ((0, 0, 200), (0, 600, 240), (600, 0, 100), (600, 600, 160)):
            lines += [f"others,{run},{run},{hunters},{victims},{contact_s + shift}" for shift in (-10, 10)]
    (tmp_path / "contests.csv").write_text("\n".join([*lines, ""]))
    rows = bodies_race.progress_rows("both", tmp_path / "contests.csv", 600)
    assert [(row["run"], row["species"], row["value"]) for row in rows] == [
        ("00", "predator", "90"),
        ("01", "predator", "90"),
        ("00", "prey", "50"),
        ("01", "prey", "50"),
    ]
    rng = numpy.random.default_rng(1)
    rows = [
        ponds.row_of(world, f"{run:02}", "", ("progress", species, "all"), mean + rng.normal())
        for world, mean in (("both", 5.0), ("none", 0.0))
        for species in ("prey", "predator")
        for run in range(12)
    ]
    found = bodies_race.progress(rows)
    assert all(float(row["p_holm"]) < 0.001 and 4 < float(row["difference"]) < 6 for row in found) and len(found) == 2


def test_comparisons_whose_runs_are_not_made_count_in_the_family():
    rng, rows = numpy.random.default_rng(2), []
    for run in range(10):
        rows.append(ponds.row_of("both", f"{run:02}", "", ("persists", "all", "all"), 1.0))
        for species in ("prey", "predator"):
            for kind, mean in (("end", 0.3), ("late_change", 0.0)):
                for null, more in (("", mean), ("neutral", 0.0)):
                    key = ("pace", species, kind)
                    rows.append(ponds.row_of("both", f"{run:02}", null, key, 1.0 + more + 0.2 * rng.normal()))
    tested = [row for row in bodies_race.results(rows, "pace") if row["family"] == "primary"]
    first = min((row for row in tested if row["p"]), key=lambda row: float(row["p"]))
    assert len(tested) == 6 and float(first["p_holm"]) == pytest.approx(6 * float(first["p"]), rel=1e-3)
    assert [row["p"] == row["difference"] == "" for row in tested] == [False] * 4 + [True] * 2


def test_the_picture_has_the_same_prey_before_early_and_late_predators():
    times = [(hunters, victims) for hunters in ("0", "600") for victims in ("0", "600")]
    contests = [
        {"team": team, "hunter_epoch_s": hunters, "victim_epoch_s": victims}
        for team in ("0", "1")
        for hunters, victims in times
    ]
    assert bodies_race.meetings(contests, 600) == [0, 2]


def test_the_program_measures_walks_and_refuses_bad_input(folder):
    for words, error in (
        (("9", "9.81", "spider"), "SECONDS = 9: must be >= 10"),
        (("10", "0", "spider"), "GRAVITY = 0: must be >= 0.1"),
        (("10", "9.81"), "usage"),
        (("10", "9.81", "no_robot"), "no_robot"),
    ):
        done = folder.call("trophic-walks", *words)
        assert done.returncode == 1 and error in done.stderr
    (pathlib.Path(folder.path) / "walks.csv").write_text(folder.run("trophic-walks", "10", "9.81", "spider").stdout)
    rows = {(row["steering"], row["pace"]): row for row in bodies_race.walk_rows("", folder.path / "walks.csv")}
    assert len(rows) == 32 and rows["straight", "1"]["walks"] == 10
    speed = {key: float(row["speed_m_s"]) for key, row in rows.items()}
    assert speed["straight", "1"] == pytest.approx(0.049, rel=0.2)  # of 10 s of a gait that does not repeat exactly
    assert speed["steered", "1"] == pytest.approx(0.0429, rel=0.2)  # the robot file's own measure
    assert speed["straight", "2"] == pytest.approx(2.0 * speed["straight", "1"], rel=0.3)
    assert rows["straight", "2"]["upright_walks"] == 10 and rows["straight", "10"]["upright_walks"] < 10
