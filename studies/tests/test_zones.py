# SPDX-License-Identifier: MIT
"""Mating zones: the mean field, the critical number of zones with its interval, and the answers of rules, on planted counts and runs."""
import json

import numpy
import zones


def planted(critical, slope, rng, runs=30, numbers=(4, 6, 8, 10, 12, 14, 16, 18, 20, 24, 40), lasting=0.1):
    """Counts of runs that explode with probability 1/2 at this number of zones."""
    cells = []
    for number in numbers:
        explodes = 1.0 / (1.0 + (critical / number) ** slope)
        extinct, exploded, lasted = rng.multinomial(
            runs, [(1.0 - lasting) * (1.0 - explodes), (1.0 - lasting) * explodes, lasting]
        )
        cells.append({"zones": number, "extinct": extinct, "exploded": exploded, "lasted": lasted})
    return cells


def test_mean_field_without_zones_dies_when_its_energy_is_spent_and_with_many_zones_explodes():
    rng = numpy.random.default_rng(1)
    assert zones.mean_field(rng, 0, 1) == ("extinct", 20)
    assert all(zones.mean_field(rng, 100, 2)[0] == "exploded" for _ in range(5))
    assert all(zones.mean_field(rng, 20, 1, endows=True)[0] == "extinct" for _ in range(5))
    assert zones.mean_field(rng, 0, 1, food_J=300.0) == ("lasted", 100)


def test_interval_of_the_critical_number_covers_it_in_about_95_of_100():
    rng, covered = numpy.random.default_rng(3), []
    for _ in range(100):
        middle, lower, upper = zones.critical(planted(13.0, 8.0, rng))
        assert lower <= middle <= upper
        covered.append(lower <= 13.0 <= upper)
    assert 0.88 <= numpy.mean(covered) <= 0.99


def test_interval_of_a_jump_between_two_numbers_of_zones_reaches_both():
    cells = [
        {"zones": number, "extinct": 30 * (number < 10), "exploded": 30 * (number > 10), "lasted": 0}
        for number in (4, 8, 12, 16)
    ]
    middle, lower, upper = zones.critical(cells)
    assert 7.5 < lower < 8.5 and 11.5 < upper < 12.5 and 9.0 < middle < 11.0
    assert zones.critical(cells[:2]) is None


def run_in(folder, living, turns, ends_s=6000.0):
    """A run of these numbers of living robots whose robots turn to the side of the nearest zone in this share of decisions."""
    folder.mkdir(parents=True)
    (folder / "manifest.json").write_text(json.dumps({"params": {"ecology": {"robots": 100}}}))
    times = numpy.linspace(0.0, ends_s, len(living))
    lines = [f"{time_s},{number}" for time_s, number in zip(times, living)]
    (folder / "energy.csv").write_text("\n".join(["time_s,individuals", *lines]) + "\n")
    senses = ["time_s,angle_output,input1,input2", "100,1,-1,1"]
    senses += [f"{4000 + step},1,{1 if step < 100 * turns else -1},0.4" for step in range(100)]
    (folder / "senses.csv").write_text("\n".join(senses) + "\n")


def test_run_is_read_by_how_it_ends_and_what_its_robots_do_late(tmp_path):
    run_in(tmp_path / "set/replicate-00", [30, 60, 58], 0.7)
    run_in(tmp_path / "set/replicate-01", [30, 60, 100], 0.7, 600.0)
    run_in(tmp_path / "set/shadow/replicate-00", [30, 0], 0.5, 1200.0)
    first, second, shadow = zones.values_of(tmp_path / "set")
    assert (first["outcome"], second["outcome"], shadow["outcome"]) == ("lasted", "exploded", "extinct")
    assert float(first["turns"]) == 0.7 and float(first["distance_m"]) == 5.0 and second["turns"] == ""
    assert shadow["null"] == "shadow" and shadow["minutes"] == "20.0"


def values_of(lasting, gain, seed):
    rng, rows = numpy.random.default_rng(seed), []
    for null in ("", "shadow"):
        for run in range(30):
            lasts = run < lasting
            turns = rng.normal(0.3 + (0.0 if null else gain), 0.04)
            values = (
                {"robots": "60", "turns": f"{turns}", "distance_m": "4"}
                if lasts
                else dict.fromkeys(("robots", "turns", "distance_m"), "")
            )
            outcome = "lasted" if lasts else "exploded"
            rows.append({"run": f"{run:02}", "null": null, "outcome": outcome, "minutes": "100", **values})
    return rows


def test_rule_is_a_yes_only_if_enough_runs_last_and_turns_exceed_those_of_the_shadow():
    cases = {"both": (28, 0.08), "finite food": (20, 0.08), "parents endow": (30, 0.0), "as published": (0, 0.0)}
    rows = zones.with_answers(
        [
            zones.cell_rows(rule, rule, 1, 8, values_of(*planted, seed))
            for seed, (rule, planted) in enumerate(cases.items())
        ]
    )
    answers = {row["rule"]: row["answer"] for row in rows}
    assert answers == {
        "both": "yes",
        "finite food": "no",
        "parents endow": "lasts, no progress shown",
        "as published": "no",
    }
    assert rows[0]["p_holm"] and not rows[3]["p_holm"]
