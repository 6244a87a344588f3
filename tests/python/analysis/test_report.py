# SPDX-License-Identifier: MIT
"""Tables, LaTeX, JSON and the terminal: all of what the judge says, and nothing else."""
import json
import math
import re

import pytest
from sets import around, metric, set_of
from trophic import judge, writing
from trophic.report import analyze, tables, tex, text
from trophic.runs import RunError

CATCHES, VELOCITY, STORED = metric("attribution_catches", "predator"), metric("velocity"), metric("velocity_stored")
TAGS, STARVED = metric("tag_symmetry", "prey+predator", "inherited"), metric("deaths", "prey", "starved")
NAN = math.nan


def outcome_of(*sets, compares=False):
    return analyze.Outcome(list(sets), [judge.summarize(of) for of in sets], judge.compare(*sets) if compares else None)


def example(count=6, catches=1.0, null=0.0, label="paper", shadow=True):
    """Catches of predators that all inherited (without spread), velocities that could not be computed, tags with a null of their own."""
    values = {
        CATCHES: [catches] * count,
        VELOCITY: [NAN] * count,
        STORED: [NAN] * count,
        TAGS: around(0.5, count),
        STARVED: [0.0] * count,
    }
    own = {(CATCHES, "two_thirds", "paper"): [2 / 3] * count, (TAGS, "permuted_tags", "null"): around(0.4, count, 0.02)}
    nothing = set_of({**values, CATCHES: [null] * count, TAGS: around(0.45, count)}, label=label) if shadow else None
    return set_of(values, own, nothing, label)


def squeezed(of):
    return re.sub(" +", " ", of)


# Tables


def test_means_csv_has_each_metric_next_to_each_of_its_nulls():
    lines = writing.csv_text(tables.means(judge.summarize(example()))).splitlines()
    assert lines[0] == (
        "set,metric,species,group,unit,n,mean,deviation,lower,upper,published,null,null_n,null_mean,difference,difference_lower,difference_upper,p,"
        "p_holm,lower_corrected,upper_corrected,scatter,not_tested,same_as"
    )
    assert lines[1] == "paper,attribution_catches,predator,all,1,6,1,0,1,1,,shadow,6,0,1,1,1,0,0,1,1,0,,"
    assert "paper,velocity_stored,prey,all,m/s,0,,,,,-0.0067,shadow,0,,,,,,,,,,,velocity:prey:all" in lines
    assert [line.split(",")[11] for line in lines if "tag_symmetry" in line] == ["shadow", "permuted_tags"]


def test_means_csv_has_one_row_for_a_metric_without_a_null_and_none_of_the_papers_baseline():
    table = tables.means(judge.summarize(example(shadow=False)))
    assert list(table.metric) == ["attribution_catches", "velocity", "velocity_stored", "tag_symmetry", "deaths"]
    assert (
        list(table.null) == ["", "", "", "permuted_tags", ""]
        and table.null_n[0] == 0
        and math.isnan(table.null_mean[0])
    )


def test_metrics_csv_has_one_value_a_row_and_the_shadows_values_as_a_baseline():
    of = example(label="mine, all")
    of.values[0].curves = of.values[0].values.iloc[:1].drop(columns="role").assign(time_s=200.0, baseline="")
    lines = writing.csv_text(tables.metrics([of])).splitlines()
    assert lines[0] == "set,run,seed,metric,species,group,baseline,time_s,value,unit"
    for row in (
        "replicate-00,0,attribution_catches,predator,all,,,1,1",
        "replicate-00,0,attribution_catches,predator,all,two_thirds,,0.6666666666666666,1",
        "replicate-00,0,attribution_catches,predator,all,,200,1,1",
        "replicate-01,1,velocity,prey,all,,,,m/s",
        "replicate-05,5,attribution_catches,predator,all,shadow,,0,1",
    ):
        assert f'"mine, all",{row}' in lines
    assert not any("shadow,,0.4" in line and "permuted" in line for line in lines)


def test_differences_csv_has_the_answer_first_and_the_raw_difference_behind_it():
    frame = judge.compare(example(), example(catches=0.0, label="released"))
    lines = writing.csv_text(tables.differences(frame)).splitlines()
    assert lines[1:3] == [
        "attribution_catches,predator,all,1,over_shadow,6,6,1,0,-1,-1,-1,0,0,-1,-1,0,,",
        "attribution_catches,predator,all,1,raw,6,6,1,0,-1,-1,-1,0,0,-1,-1,0,,",
    ]


def test_runs_for_the_smallest_effect_of_interest_depend_on_the_scatter_and_not_on_what_was_observed():
    def asked(shift):
        ours, null = ({VELOCITY: around(1.0 + by, spread=0.01), TAGS: around(0.5)} for by in (shift, 0.0))
        return text.runs_for(judge.summarize(set_of(ours, shadow=set_of(null)), ["velocity"]), 0.005)

    assert (
        asked(0.0)
        == asked(0.3)
        == (
            "a difference of 0.50 in velocity prey, cm/s over the shadow needs 77 runs in each set for 80 % power\n"
            "at the level of one of 1 comparisons; based on the variance of these runs\n"
        )
    )


def test_what_rounds_to_zero_has_more_digits_and_no_sign():
    reading = text.Reading(VELOCITY)
    assert reading.with_interval(0.0027, (0.00002, 0.0054), True) == "+0.270 [+0.002, +0.540]"
    assert reading.with_interval(-0.0000001, (-0.0013, 0.0014), True) == "-0.00001 [-0.13000, +0.14000]"
    assert reading.with_interval(0.0, (-0.0013, 0.0014), True) == "0.00 [-0.13, +0.14]"
    assert reading.with_interval(0.011, (0.0085, 0.0135), True) == "+1.10 [+0.85, +1.35]"
    assert reading(-0.00001, True) == "0.00"


def test_summary_json_has_null_for_what_could_not_be_computed_and_no_conclusion_of_one_run():
    one = outcome_of(
        set_of(
            {CATCHES: [1.0], VELOCITY: [NAN], TAGS: [0.43]},
            {(CATCHES, "two_thirds", "paper"): [2 / 3], (TAGS, "permuted_tags", "null"): [0.4]},
        )
    )
    content = json.loads(writing.json_text(one.analysis(None).summary))
    (its,) = content["sets"]
    assert (
        its["set"] == "paper" and its["runs"][0]["seed"] == 0 and its["shadow_runs"] == [] and content["findings"] == []
    )
    catches, velocity, tags = its["metrics"]
    assert (catches["mean"], catches["lower"], catches["deviation"], velocity["mean"], tags["published"]) == (
        1.0,
        None,
        None,
        None,
        0.43,
    )
    assert catches["baselines"][0]["role"] == "paper" and catches["baselines"][0]["conclusion"] is None
    assert tags["baselines"][0]["conclusion"] == "too few runs" and tags["baselines"][0]["differs"] is None
    assert {reading["conclusion"] for claim in its["claims"] for reading in claim["readings"]} == {"no conclusion"}
    assert content["family"]["comparisons"] == 0


def test_summary_json_has_the_family_the_findings_and_the_differences():
    both = outcome_of(example(), example(catches=0.0, label="released"), compares=True)
    content = tables.summary(both.sets, both.frames, both.compared)
    assert (content["family"]["comparisons"], content["family"]["significant"]) == judge.count(both.compared)
    assert (
        [one["sentence"] for one in content["findings"]]
        == [one.sentence for one in judge.findings(both.compared)]
        != []
    )
    first = content["differences"][0]
    assert (
        first["over_shadow"]["conclusion"] == "below"
        and first["raw"]["p_adjusted"] == 0.0
        and first["raw"]["differs"] is None
        and first["a"]["mean"] == 1.0
    )
    assert content["sets"][0]["metrics"][0]["baselines"][0]["name"] == "shadow"
    assert content["sets"][0]["family"]["comparisons"] == judge.count(both.frames[0]).comparisons


def test_claims_are_left_out_for_a_table_that_is_not_published():
    assert tables.summary([example(label="mine")], [judge.summarize(example(label="mine"))])["sets"][0]["claims"] == []
    assert "published" not in text.table(example(label="mine"), judge.summarize(example(label="mine")))


def test_result_folder_is_new_and_goes_again_if_the_work_fails(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("analysis", "analysis-1"):
        with writing.result_folder(None) as folder:
            assert folder.name == f"{name}.part"
            (folder / "tables").write_text("")
    with pytest.raises(
        RunError, match="--out analysis: exists already; files are never overwritten"
    ), writing.result_folder("analysis"):
        pass
    with pytest.raises(RuntimeError), writing.result_folder("broken") as folder:
        (folder / "x").write_text("")
        raise RuntimeError
    (tmp_path / "killed.part").mkdir()
    (tmp_path / "killed.part/half").write_text("")
    with writing.result_folder("killed") as folder, pytest.raises(
        RunError, match="killed.part: another program is running in it"
    ):
        assert not list(folder.iterdir())
        with writing.result_folder("killed"):
            pass
    assert sorted(path.name for path in tmp_path.iterdir()) == ["analysis", "analysis-1", "killed"]
    writing.write_new("new", "1")
    with pytest.raises(RunError, match="new: exists already"):
        writing.write_new("new", "2")
    assert (tmp_path / "new").read_text() == "1" and not (tmp_path / "new.part").exists()


# LaTeX


def test_latex_has_what_was_compared_once():
    of = example()
    table = tex.means(of, judge.summarize(of))
    assert (
        r"attribution\_\allowbreak{}catches predator & $1.000\ [1.000,\ 1.000]$ & $0.000$ & $+1.000\ [+1.000,\ +1.000]$ & $<0.001$ & $6{+}6$ \\"
        "\n"
    ) in table
    assert (
        "(null: permuted" in table
        and "velocity" not in table
        and f"corrected for {judge.count(judge.summarize(of)).comparisons} comparisons" in table
    )
    b = example(catches=0.0, label="a_b")
    assert r"& a\_\allowbreak{}b & over shadows [95\,\%]" in tex.differences(of, b, judge.compare(of, b))
    alone = example(shadow=False)
    assert r"& difference [95\,\%]" in tex.differences(alone, b, judge.compare(alone, b))


# Terminal


def test_table_has_ours_the_papers_value_nulls_with_a_test_and_references_without():
    of = example()
    shown = squeezed(text.table(of, judge.summarize(of)))
    for part in (
        "paper on kinematic 1, 6 runs of 6000 s, fingerprint aa\n",
        "\nshadow: paper on kinematic 1, 6 runs of 6000 s\n",
        "\nattribution_catches predator 1.000 [1.000, 1.000] -\n",
        " = shadow 0.000 +1.000 [+1.000, +1.000] <0.001 above\n",
        " * two_thirds 0.667\n",
        "\nvelocity_stored prey, cm/s missing -0.67 tested as velocity prey, cm/s\n",
    ):
        assert part in shown, part
    assert not any(word in shown for word in ("nan", "starved", "too few"))


def test_metrics_of_ones_own_stand_first_whatever_their_p():
    of = example()
    of.own = frozenset({"tag_symmetry"})
    shown = text.findings(of, judge.summarize(of)).splitlines()
    assert shown[0].split()[0] == "yours" and shown[1].strip().startswith("tag_symmetry")
    assert text.findings(example(), judge.summarize(example())).splitlines()[0].split()[0] != "yours"


def test_findings_are_sentences_and_the_whole_table_without_a_shadow():
    of = example()
    frame = judge.summarize(of)
    shown = text.findings(of, frame)
    for finding in judge.findings(frame):
        assert f"  {finding.sentence}\n" in shown
    assert judge.count(frame).sentence() in shown and "two_thirds" not in shown
    alone = example(shadow=False)
    assert text.findings(alone, judge.summarize(alone)) == text.table(alone, judge.summarize(alone))


@pytest.mark.parametrize("count", [1, 2, 5])
def test_too_few_runs_get_numbers_no_test_and_a_sentence_that_says_so(count):
    of = example(count, shadow=False)
    frame = judge.summarize(of)
    shown = text.table(of, frame)
    assert (
        f"too few runs for a test: 6 are needed, paper has {count}\n" in shown
        and "not tested: behaviour and counts: no shadow: --shadow makes one\n" in shown
    )
    assert ("1.000 (sd 0.000)" in shown) == (count > 1) and not any(
        word in shown for word in (" above", " below", "inconclusive", "significant")
    )
    claims = text.claims(of)
    assert (
        "no conclusion\n" in claims
        and "  reproduced\n" not in claims
        and "too few runs for a test: 6 are needed" in claims
    )
    compared = judge.compare(of, of)
    for show in (text.difference_table, text.difference_findings):
        assert "too few runs for a test: 6 are needed" in show(of, of, compared) and "*\n" not in show(of, of, compared)


def test_comparison_shows_the_raw_difference_next_to_the_answer_over_the_shadows():
    a, b = example(), example(catches=0.0, label="released")
    frame = judge.compare(a, b)
    shown = squeezed(text.difference_table(a, b, frame))
    assert "over shadows: (b - shadow) - (a - shadow) [95 %] p" in shown
    assert (
        "attribution_catches predator 1.000 0.000 -1.000 [-1.000, -1.000] -1.000 [-1.000, -1.000] <0.001 *\n" in shown
    )
    findings = text.difference_findings(a, b, frame)
    assert "the answer is the difference over shadows" in findings and judge.findings(frame)[0].sentence in findings
    a, b = example(shadow=False), example(catches=0.0, label="released", shadow=False)
    for show in (text.difference_table, text.difference_findings):
        assert "without its control in both sets no difference can be attributed to inheritance" in show(
            a, b, judge.compare(a, b)
        )
    assert "attribution_catches predator 1.000 0.000 -1.000 [-1.000, -1.000] <0.001 *\n" in squeezed(
        text.difference_table(a, b, judge.compare(a, b))
    )


def test_claims_have_a_summary_and_for_each_reading_value_margin_origin_ours_and_conclusion():
    caught = metric("attribution_caught")
    shown = squeezed(
        text.claims(
            set_of(
                {
                    caught: [1.0] * 6,
                    metric("attribution_died"): [1.0] * 6,
                    metric("velocity_points", "predator", "inherited"): [NAN] * 6,
                }
            )
        )
    )
    for part in (
        "these are points without bodies, so velocities and wall-following compare only the rules\n",
        "\nattribution of prey: not reproduced under any reading\n",
        "\n attribution_caught prey 0.650 text 0.037 authors' logs 1.000 [1.000, 1.000] +0.350 [+0.324, +0.376] not reproduced\n",
        "\n attribution_died prey 0.620 logs 0.028 authors' logs ",
        "\nvelocity of predators: no conclusion\n",
        "\n velocity_points predator (inherited), cm/s 1.95 text 0.21 our runs, another reading missing ",
        "Leaving them out (active) is an inference",
    ):
        assert part in shown, part
