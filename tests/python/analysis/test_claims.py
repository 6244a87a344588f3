# SPDX-License-Identifier: MIT
"""Twenty analyses of runs that a program made: what terminal, page, tables, LaTeX, JSON, Python and `cite` say about a set is the same."""
import html
import io
import json
import os
import re
import shutil
import subprocess

import claims
import numpy
import pandas
import pytest
from in_folder import planned
from sets import around, metric, set_of
from trophic import cite, judge, writing
from trophic.published import QUESTIONS, answers
from trophic.metrics import own
from trophic.report import analyze, page, tables, tex, text
from trophic.report.measuring import measuring_of
from trophic.runs import read_analysis
from trophic.sweeps import report as sweep_report
from trophic.values import Metric
from trophic.words import Reading, metric_title

PROGRAM = os.environ.get("TROPHIC_PREDATOR_PREY")
needs_program = pytest.mark.skipif(PROGRAM is None, reason="TROPHIC_PREDATOR_PREY names no program")
WHO = {"who": "trophic analyze"}


def title_of(row):
    return metric_title(Metric(row["metric"], row["species"], row["group"], row["unit"]))


def reading_of(row, value, lower, upper):
    of = Metric(row["metric"], row["species"], row["group"], row["unit"])
    return Reading(of).with_interval(value, None if lower is None else (lower, upper), True)


def outputs_of(outcome, folder):
    """Everything that is printed and written about an outcome, read again."""
    out = folder / "out"
    out.mkdir()
    analyze.write_tables(out, outcome)
    whole, brief = analyze.texts(outcome)
    request = {**WHO, "runs": ["runs"], "html": "page.html"}
    frames = outcome.frames if outcome.compared is None else [outcome.compared]
    page.write(folder / "page.html", outcome.sets, frames, judge.findings(outcome.answer), request, text=whole)
    found = {"summary.json": claims.of_json((out / "summary.json").read_text(), title_of, reading_of)}
    compares = outcome.compared is not None
    found["terminal --all"] = (claims.of_difference_table if compares else claims.of_table)(whole)
    found["page"] = claims.of_page((folder / "page.html").read_text())
    found["terminal"] = claims.Output([], claims.counts_in(brief), claims.findings_in(brief), [])
    table = "differences" if compares else "means"
    found[f"{table}.csv"] = claims.of_csv((out / f"{table}.csv").read_text(), title_of, reading_of)
    latex = claims.of_latex((out / f"{table}.tex").read_text())
    kind = ("over_shadow" if all(of.shadow for of in outcome.sets) else "raw") if compares else ""
    found[f"{table}.tex"] = latex._replace(claims=[claim._replace(null=kind or claim.null) for claim in latex.claims])
    for answer in [
        one for of in json.loads((out / "summary.json").read_text())["sets"] for one in of["answers"] if not compares
    ]:
        for shown in (
            whole,
            brief,
            html.unescape((folder / "page.html").read_text()),
            (out / "answers.tex").read_text().replace("\\,", "").replace("\\", ""),
        ):
            at = shown.index(answer["question"])
            assert shown[at + len(answer["question"]) :].lstrip(" &").lower().startswith(answer["answer"]), (
                answer,
                shown[at : at + 200],
            )
    read, made = read_analysis(out), outcome.analysis(None)
    for name, analysis in (("read_analysis", read), ("analysis in memory", made)):
        shown = (
            "\n".join(re.findall("<li>(.*?)</li>", analysis._repr_html_())).replace("&lt;", "<").replace("&#x27;", "'")
        )
        found[f"{name} in a notebook"] = claims.Output([], claims.counts_in(shown), claims.findings_in(shown), [])
        of = analysis.differences if compares else analysis.means
        found[f"{name} as frames"] = claims.of_csv(writing.csv_text(of), title_of, reading_of)
    return found


def check(outcome, folder):
    found = outputs_of(outcome, folder)
    assert claims.contradictions(found) == []
    truth = found["summary.json"]
    for name in (
        "terminal",
        "terminal --all",
        "page",
        "read_analysis in a notebook",
        "analysis in memory in a notebook",
    ):
        assert bool(found[name].findings) == bool(truth.findings), name
        assert found[name].counts or truth.counts[0][0] == 0, name
    shown = [
        row for row in truth.claims if row.difference != "missing" and not row.metric.startswith("deaths")
    ]  # causes of which none died are left out
    for name in ("terminal --all", "page", f"{'differences' if outcome.compared is not None else 'means'}.csv"):
        # Of two sets the comparison alone is shown.
        wanted = {row[:3] for row in shown if outcome.compared is None or not row.set}
        assert wanted <= {
            (row.set or shown[0].set, row.metric, row.null) if outcome.compared is None else row[:3]
            for row in found[name].claims
        }, name
    check_findings(outcome, truth)
    return found


def check_findings(outcome, truth):
    """Each finding is a significant comparison, says its numbers, and no fact is given twice."""
    answer = outcome.answer
    facts = []
    for finding in judge.findings(answer):
        of = finding.metric
        rows = answer[(answer[["metric", "species", "group", "unit"]] == list(of)).all(axis=1)]
        (row,) = rows[rows["null" if "null" in rows else "compared"] == finding.baseline].itertuples()
        assert row.p_holm <= 0.05 and row.difference == finding.effect and row.same_as == ""
        reading = Reading(of)
        low, high = sorted(abs(bound) for bound in finding.interval)
        for part in (reading(abs(finding.effect)), f"[{reading(low)}, {reading(high)}]"):
            assert part in finding.sentence, (part, finding.sentence)
        facts.append((of.metric.split("_")[0], of.species))
    assert len(set(facts)) == len(facts), facts
    answer = answer[answer["role"] == "null"]
    significant = answer[answer["p_holm"] <= 0.05]
    assert (len(facts) > 0) == (len(significant) > 0)
    assert truth.counts[0] == (int(answer["p_holm"].notna().sum()), len(significant))


# Sets of simulated values, in which much is significant


def simulated(seed, shift, label="paper", count=8, species=("prey", "predator"), shadow=True, neutral=False):
    rng = numpy.random.default_rng(seed)
    prey, predator = species
    names = [metric("velocity", one, group) for one in species for group in ("all", "inherited", "active")] + [
        metric("velocity_points", one) for one in species
    ]
    names += [
        metric("attribution_caught", prey),
        metric("attribution_credited", predator),
        metric("wall_sticking", prey),
        metric("wall_sticking", predator, "active"),
    ]
    names += [
        metric("deaths", prey),
        metric("deaths", prey, "caught"),
        metric("stuck", prey),
        metric("stuck", "all"),
        metric("my_own_metric", "", "left, right"),
    ]
    names += [reading.metric for reading in QUESTIONS[0].readings if reading.metric not in names]
    tags = metric("tag_symmetry", f"{prey}+{predator}", "inherited")
    ours = {name: list(rng.normal(0.2 + shift * (i % 3), 0.05, count)) for i, name in enumerate([*names, tags])}
    ours[metric("hunger", predator)] = [1.0] * count
    own = {
        (tags, "permuted_tags", "null"): list(rng.normal(0.2, 0.05, count)),
        (tags, "uniform_pairs", "paper"): [2 / 3] * count,
    }
    null = {name: list(rng.normal(0.2, 0.05, len(values))) for name, values in ours.items()}
    made = set_of(ours, own, set_of(null, label=label) if shadow else None, label)
    if neutral:
        made.neutral, made.inherited = set_of(
            {name: values[1:] + values[:1] for name, values in null.items()}, label=label
        ), frozenset({"stuck", "my_own_metric"})
    return made


def outcome_of(*sets):
    return analyze.Outcome(
        list(sets), [judge.summarize(of) for of in sets], judge.compare(*sets) if len(sets) > 1 else None
    )


SIMULATED = {
    "strong": lambda: outcome_of(simulated(1, 0.4)),
    "negative": lambda: outcome_of(simulated(2, -0.3)),
    "weak": lambda: outcome_of(simulated(3, 0.06)),
    "nothing": lambda: outcome_of(simulated(4, 0.0)),
    "own species": lambda: outcome_of(simulated(5, 0.4, "forest", species=("grass", "wolf"))),
    "neutral null": lambda: outcome_of(simulated(12, 0.4, neutral=True)),
    "no shadow": lambda: outcome_of(simulated(6, 0.4, shadow=False)),
    "five runs": lambda: outcome_of(simulated(7, 0.4, count=5)),
    "compared": lambda: outcome_of(simulated(8, 0.0), simulated(9, 0.5, "released")),
    "compared, equal": lambda: outcome_of(simulated(8, 0.1), simulated(9, 0.1, "released")),
    "compared raw": lambda: outcome_of(simulated(10, 0.0, shadow=False), simulated(11, 0.5, "mine, changed")),
}


@pytest.mark.parametrize("name", SIMULATED)
def test_simulated_sets(name, tmp_path):
    outcome = SIMULATED[name]()
    check(outcome, tmp_path)
    expected = {
        "strong": True,
        "neutral null": True,
        "negative": True,
        "own species": True,
        "compared": True,
        "compared raw": True,
        "five runs": False,
    }
    if name in expected:
        assert (judge.count(outcome.answer).significant > 0) == expected[name]
    if name in ("strong", "nothing"):
        (answer,) = answers(outcome.sets[0], outcome.frames[0])
        assert str(answer).split()[0] == {"strong": "depends", "nothing": "undecided"}[name]


# Sets of runs


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Sets of short kinematic runs."""
    folder = tmp_path_factory.mktemp("sets")

    def made(out, *options, replicates=6):
        subprocess.run(
            [
                PROGRAM,
                "--backend",
                "kinematic",
                "--replay-hz",
                "0",
                *(("--replicates", str(replicates)) if replicates else ()),
                *options,
                "--out",
                out,
            ],
            cwd=folder,
            check=True,
            capture_output=True,
        )

    (folder / "changes.csv").write_text("time_s,number,value\n100,rules.mutation.sd,0.2\n")
    made("paper", "--duration", "400", "--shadow")
    made("released", "--rules", "released", "--duration", "400", "--shadow", "--seed", "3")
    made("parameters", "--set", "rules.mutation.sd=0.4", "--duration", "400")
    made("changed", "--changes", "changes.csv", "--duration", "400", "--seed", "5")
    made("past", "--duration", "200", replicates=0)
    made("branch", "--from", "past", "--at", "200", "--duration", "400", "--seed", "6")
    made(
        "branch-changed",
        "--from",
        "past",
        "--at",
        "200",
        "--duration",
        "400",
        "--set",
        "rules.mutation.sd=0.2",
        "--seed",
        "7",
    )
    for name, edit in (("species", {b"prey": b"hare", b"predator": b"wolf"}), ("tags", {})):
        shutil.copytree(folder / "paper", folder / name)
        for path in (folder / name).rglob("*.*"):
            if path.suffix in (".csv", ".json"):
                content = path.read_bytes()
                for before, after in edit.items():
                    content = re.sub(rb"\b%s\b" % before, after, content)
                path.write_bytes(content)
            if path.name == "replicates.json":  # as of an older program
                path.write_text(
                    json.dumps(
                        {
                            key: value
                            for key, value in json.loads(path.read_text()).items()
                            if key not in ("format", "crc32")
                        }
                    )
                )
            if path.name == "manifest.json":
                manifest = json.loads(path.read_text())
                for key in ("tables", "format", "crc32"):  # as of an older program
                    del manifest[key]
                manifest.pop("description", None)
                manifest["tags"] = [-1, 1] if name == "species" else [-2, -1, 0, 1]
                manifest["rule_table"] = name
                path.write_text(json.dumps(manifest))
    for run in (folder / "paper").rglob("replicate-*"):
        (run / "own.csv").write_text(f"time_s,crowd\n100,{len(str(run)) % 7}\n200,{run.name[-1]}\n")
    return folder


def crowding(run):
    """An own metric in Python."""
    return run.table("agents", ["x_m"]).x_m.abs().mean()


@needs_program
@pytest.mark.parametrize(
    "name, options",
    [
        ("paper", {}),
        ("released", {}),
        ("paper", {"until": 200.0}),
        ("parameters", {}),
        ("changed", {}),
        ("branch", {}),
        ("branch-changed", {}),
        ("species", {}),
        ("tags", {}),
        ("paper", {"column": ["own.csv:crowd:robots"], "metric": ["crowd", "velocity"]}),
        ("paper", {"functions": [crowding]}),
        ("paper/replicate-00", {}),
        (("paper", "released"), {}),
        (("paper", "changed"), {}),
        (("branch", "branch-changed"), {}),
        (("paper", "species"), {}),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, (dict, tuple)) else value,
)
def test_sets_of_runs(folder, name, options, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    how = measuring_of({**options, "jobs": 1})
    how.functions = [own.own_metric(one) for one in options.get("functions", ())]
    compares = isinstance(name, tuple)
    outcome = analyze.analyse([] if compares else [name], name if compares else (), None, how)
    found = check(outcome, tmp_path)
    labels = found["summary.json"].names
    assert len(set(labels)) == len(labels)
    for of, folder_of in zip(outcome.sets, name if compares else [name]):
        assert cite.run({**WHO, "run": folder_of}) == 0
        sentence = capsys.readouterr().out
        of_table = of.label.split(" (")[0]
        is_plain = folder_of.split("/")[0] in ("paper", "released")
        assert is_plain == (of.label.removesuffix(" (a)").removesuffix(" (b)") in ("paper", "released"))
        assert f"rule table `{of_table}`" in sentence
        frame = outcome.frames[outcome.sets.index(of)]
        assert frame["published"].notna().any() == is_plain
        if folder_of in ("changed", "branch", "branch-changed", "parameters"):
            assert of.runs[0].identity in sentence
        if folder_of == "tags":
            assert not frame["metric"].isin(["tag_symmetry"]).any()


@needs_program
def test_sweep_says_the_same_everywhere_and_as_a_comparison(folder, tmp_path, monkeypatch):
    monkeypatch.chdir(folder)
    (folder / "sweep.toml").write_text(
        'rule_table = "paper"\nengine = "kinematic"\nreplicates = 6\nshadow = true\n[grid]\necology.duration_s = [400.0]\n'
        "rules.capture.reach_m = [1.0, 3.0]\n"
    )
    subprocess.run(planned(PROGRAM, "sweep.toml", "sweep", folder), check=True, capture_output=True)
    sweep = sweep_report.analyze_sweep("sweep", how=measuring_of({"jobs": 1}))
    shown, summary = sweep_report.text_of(sweep), sweep_report.summary_of(sweep)
    rows = sweep_report.with_significance(sweep.differences)
    answers = rows[rows["compared"] == "over_shadow"]
    assert claims.counts_in(shown)[0] == (
        int(answers["p_holm"].notna().sum()),
        int((answers["significant"] == "yes").sum()),
    )
    assert claims.counts_in(summary["family"]["sentence"]) == [claims.counts_in(shown)[0]]
    for finding in summary["findings"]:
        of = answers[
            (answers[["metric", "species", "group"]] == [finding[key] for key in ("metric", "species", "group")]).all(
                axis=1
            )
        ]
        assert (of["significant"] == "yes").any() and finding["effect"] in set(of["difference"])
    compared = analyze.analyse([], ["sweep/cell-000", "sweep/cell-001"], None, measuring_of({"jobs": 1}))
    check(compared, tmp_path)
    both = compared.compared[compared.compared["compared"] == "over_shadow"].merge(
        answers, on=["metric", "species", "group"], suffixes=("", "_of_sweep")
    )
    assert len(both) > 20
    same = both[both["n_a"] + both["n_b"] == 12].dropna(subset=["difference_of_sweep"])
    numpy.testing.assert_allclose(same["difference"], same["difference_of_sweep"], atol=1e-9)
