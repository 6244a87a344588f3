# SPDX-License-Identifier: MIT
"""Ablation studies: which differences answer, their correction over all swaps, and the tables."""
import json
import re
import shutil

import pandas
import pytest
from hand_written import CATCH, WALK, event, write_set
from pytest import approx
from sets import set_of
from trophic import ablations, statistics
from trophic.ablations import effects_of, shares_table, significant_table
from trophic.report.columns import names as column_names
from trophic.runs import RunError
from trophic.values import Metric

ATTRIBUTION, HUNGER = Metric("attribution_caught", "prey", "all", "1"), Metric("hunger", "predator", "all", "ticks")


def around(attribution, hunger, shadow=None):
    """Six runs with two metrics around these values."""
    shifts = [0.01, -0.01] * 3
    return set_of(
        {
            ATTRIBUTION: [attribution + shift for shift in shifts],
            HUNGER: [hunger + shift for shift in [0.01, 0.01, -0.01, -0.01, 0.01, -0.01]],
        },
        shadow=shadow,
    )


BASE = around(0.5, 10.0, around(0.4, 9.0))


def test_all_metrics_are_compared_over_the_shadows_and_raw_differences_stand_behind():
    frame = effects_of(BASE, {"f": around(0.7, 12.0, around(0.6, 11.0))}, "from_paper")
    assert list(frame["compared"]) == ["over_shadow", "raw"] * 2
    assert list(frame["difference"]) == approx([0.0, 0.2, 0.0, 2.0], abs=1e-9)
    assert list(frame["base"]) == approx([0.5, 0.5, 10.0, 10.0], rel=1e-2)


def test_without_shadows_the_raw_difference_answers_and_says_so():
    frame = effects_of(around(0.5, 10.0), {"f": around(0.7, 12.0)}, "from_paper")
    assert (list(frame["compared"]), list(frame["role"])) == (["raw"] * 2, ["null"] * 2)
    assert list(frame["difference"]) == approx([0.2, 2.0])


def test_p_values_are_corrected_for_all_swaps_and_metrics_each_family_alone():
    swaps = {
        f"f{place}": around(0.5, hunger, around(0.4, 9.0 + place / 100))
        for place, hunger in enumerate((10.01, 10.02, 10.0))
    }
    frame = effects_of(BASE, swaps, "from_paper")
    for family in ("over_shadow", "raw"):
        of = frame[frame["compared"] == family]
        assert len(of) == 6 and list(of["p_holm"]) == approx(list(statistics.holm(of["p"])))


def test_a_metric_that_repeats_another_in_all_sets_is_not_compared_again():
    copy = HUNGER._replace(group="active")

    def doubled(of, shadow=None):
        return set_of(
            {
                metric: list(of.table[metric if metric != copy else HUNGER, ""])
                for metric in (ATTRIBUTION, HUNGER, copy)
            },
            shadow=shadow,
        )

    frame = effects_of(
        doubled(around(0.5, 10.0)), {"f": doubled(around(0.7, 12.0)), "g": doubled(around(0.5, 10.5))}, "from_paper"
    )
    repeats = frame[frame["group"] == "active"]
    assert list(repeats["conclusion"]) == ["same"] * 2 and repeats["p_holm"].isna().all() and repeats["p"].notna().all()
    assert frame["p_holm"].notna().sum() == 4


def test_the_table_has_the_significant_effects_alone():
    text = significant_table(effects_of(BASE, {"wide": around(0.5, 12.0, around(0.4, 9.0))}, "from_paper"))
    assert "\n| wide | hunger predator, over shadow | 10.0 | 12.0 | +2.0 [" in text
    assert (
        "attribution" not in text
        and text.startswith("| swap | metric |")
        and text.splitlines()[1] == "|---|---|---|---|---|---|"
    )


def test_shares_have_opposite_signs_into_and_out_of_a_table_and_no_sum_if_an_effect_is_missing():
    second = around(0.5, 14.0, around(0.4, 9.0))

    def swapped(**hungers):
        return {name: around(0.5, hunger, around(0.4, 9.0)) for name, hunger in hungers.items()}

    text = shares_table(
        effects_of(BASE, {"second": second}, "a_to_b"),
        effects_of(BASE, swapped(a=11.0, b=12.0), "from_a"),
        effects_of(second, swapped(a=12.5), "from_b"),
        ["a", "b"],
    )
    assert "| +1.0* | +1.5* | +2.0* | missing | +3.0 | missing |" in text and "attribution" not in text


@pytest.fixture
def study(tmp_path, monkeypatch):
    """A study of two tables, each with a base and two swaps, of two runs with shadows."""
    monkeypatch.chdir(tmp_path)
    for table in ("paper", "released"):
        for place, name in enumerate(("base", "death", "floor")):
            deaths = [event("death", 4 + k, 1, "predator", cause="starved") for k in range(place)]
            write_set(
                f"study/from_{table}/{name}", 2, of_events=(*CATCH, *deaths), of_agents=WALK, fingerprint=table + name
            )
    return tmp_path / "study"


def test_a_study_becomes_two_tables(study, capsys):
    assert ablations.run({"who": "trophic ablation-table", "runs": "study", "out": "tables", "jobs": 1}) == 0
    assert capsys.readouterr().out == "files   tables/{ablations.csv,ablations.md}\n"
    table = pandas.read_csv("tables/ablations.csv")
    assert list(table) == column_names("ablations.csv")
    assert {direction: set(rows["swap"]) for direction, rows in table.groupby("direction")} == {
        "from_paper": {"death", "floor"},
        "from_released": {"death", "floor"},
        "paper_to_released": {"released"},
    }
    deaths = table[
        (table["metric"] == "deaths")
        & (table["species"] == "predator")
        & (table["group"] == "starved")
        & (table["compared"] == "raw")
    ]
    assert list(deaths["difference"]) == [1.0, 2.0, 1.0, 2.0, 0.0]
    text = open("tables/ablations.md").read()
    assert re.findall("^## .*", text, re.MULTILINE) == ["## from_paper", "## from_released", "## Together"]
    with pytest.raises(RunError, match="exists already"):
        ablations.ablation_table("study", "tables", jobs=1)


@pytest.mark.parametrize(
    "damage, part",
    [
        (
            lambda study: (study / "from_paper/floor/replicate-00/manifest.json").unlink(),
            "floor: .*manifest.json: cannot be read",
        ),
        (
            lambda study: [
                set_status(study / "from_paper/base" / run, "stopped") for run in ("replicate-00", "replicate-01")
            ],
            'status "stopped"',
        ),
        (
            lambda study: shutil.rmtree(study / "from_paper/floor/replicate-01"),
            "floor: .*replicate-01: missing, the replicate was not run",
        ),
        (
            lambda study: (study / "from_paper/floor/shadow").rename(study / "gone"),
            "one of it and its base has a shadow, the other has none",
        ),
        (
            lambda study: [(study / f"from_{table}/base").rename(study / table) for table in ("paper", "released")],
            "study: has no folder from_TABLE with a base",
        ),
        (
            lambda study: [(study / name / "base").mkdir(parents=True) for name in ("from_a", "from_b")],
            "has more than two folders from_TABLE",
        ),
    ],
)
def test_a_study_that_cannot_be_compared_is_refused_before_it_is_measured(study, monkeypatch, damage, part):
    damage(study)
    monkeypatch.setattr(ablations.pool, "read_set", lambda *_, **__: pytest.fail("measured"))
    with pytest.raises(RunError, match=part):
        ablations.ablation_table("study", "tables", jobs=1)
    assert not (study.parent / "tables").exists()


def set_status(run, status):
    manifest = json.loads((run / "manifest.json").read_text())
    (run / "manifest.json").write_text(json.dumps({**manifest, "status": status}))
