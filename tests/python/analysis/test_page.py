# SPDX-License-Identifier: MIT
"""The page of an analysis shows what the judge found, no more, and carries figures, replays and tables."""
import base64
import html
import json
import re

import numpy
import pandas
import pytest

from trophic import controls, judge
from trophic.report import page
from trophic.runs import Run, RunError
from trophic.values import VALUE_COLUMNS, MeasuredSet, Metric, RunValues

VELOCITY = Metric("velocity", "prey", "all", "m/s")
STARVED = Metric("deaths", "prey", "starved", "1")
REQUEST = {
    "who": "trophic analyze",
    "runs": ["runs/a<b"],
    "compare": [],
    "until": 600.0,
    "metric": ["velocity"],
    "html": "page.html",
    "all": True,
    "shadow": None,
}

INDEX = '<script type="application/json" id="trophic-index">{"a": "b"}</script>\n'
FILE = '<script type="text/plain" data-run="0" data-file="replay">AAAA</script>\n'


def set_of(folder, label, mean, shadow=None, runs=10):
    rng = numpy.random.default_rng(len(label) + (0 if shadow else 1))
    manifest = {
        "rule_table": label,
        "backend": "kinematic 1",
        "fingerprint": f"{label:0>16}",
        "seed": 1,
        "status": "complete",
        "trophic": "0.1.0",
        "code": "c0de",
        "clock": {"until_s": 600.0},
        "rules": {"capture": "catch_within_reach", "floor": f"{label}_floor"},
        "command_line": "predator_prey --out a",
    }
    values = [
        RunValues(
            pandas.DataFrame(
                [
                    [*VELOCITY, "", "", mean + 0.001 * rng.normal()],
                    [*STARVED, "", "", 0.0],
                    [*VELOCITY, "zero", "reference", 0.0],
                ],
                columns=VALUE_COLUMNS,
            )
        )
        for _ in range(runs)
    ]
    return MeasuredSet(
        label, [Run(folder / label / f"replicate-{i:02}", manifest) for i in range(runs)], values, shadow, 600.0
    )


@pytest.fixture
def paper(tmp_path):
    return set_of(tmp_path, "paper", 0.02, set_of(tmp_path, "paper shadow", 0.0))


def written(tmp_path, sets, frame, request=REQUEST, **more):
    said = page.write(tmp_path / "page.html", sets, [frame], judge.findings(frame), request, **more)
    return said, (tmp_path / "page.html").read_text()


def cells(text):
    return [
        [html.unescape(re.sub("<[^>]*>", "", cell)) for cell in re.findall(r"<td.*?</td>", row)]
        for row in re.findall(r"<tr>(<td.*)</tr>", text)
    ]


def test_findings_conclusions_and_counts_are_the_judge_s(tmp_path, paper):
    frame = judge.summarize(paper)
    said, text = written(tmp_path, [paper], frame, text="a < b")
    assert f"{tmp_path / 'page.html'}: 0 figures, 0 replays" in said
    shown = [html.unescape(line) for line in re.findall("<li>(.*?)</li>", text)]
    told = [f"{one[0].upper()}{one[1:]}." for one in controls.sentences(paper, judge.metrics_of(frame))]
    assert shown == [*told, *(one.sentence for one in judge.findings(frame)), judge.count(frame).sentence()]
    rows = cells(text)
    assert [row[0] for row in rows] == ["velocity prey, cm/s"]  # nobody starved
    assert [row[-1] for row in rows] == ["above"]
    assert "<title>paper on kinematic 1</title>" in text and "10 runs of 600 s, 10 of the shadow" in text
    assert "trophic analyze &#39;runs/a&lt;b&#39; --until 600 --metric velocity --html page.html\n" in text
    assert "a &lt; b" in text and "http" not in text.replace("http-equiv", "")
    files = dict(re.findall(r'<a download="([^"]*)" href="data:text/csv;base64,([^"]*)"', text))
    assert (
        base64.b64decode(files["table.csv"])
        .decode()
        .startswith('metric,ours [95 %],null,ours - null [95 %],p,conclusion\n"velocity prey, cm/s"')
    )


def test_too_few_runs_are_said(tmp_path):
    few = set_of(tmp_path, "paper", 0.02, runs=3)
    _, text = written(tmp_path, [few], judge.summarize(few))
    assert "<li>Too few runs for a test: 6 are needed, paper has 3.</li>" in text
    assert "Without a neutral shadow" in text


def test_two_sets_show_their_difference_and_common_facts_once(tmp_path, paper):
    other = set_of(tmp_path, "released", 0.03, set_of(tmp_path, "released shadow", 0.0))
    frame = judge.compare(paper, other)
    _, text = written(tmp_path, [paper, other], frame)
    assert [row[3] for row in cells(text)][:2] == ["over the shadow", "raw"]
    assert text.count("<dt>capture</dt>") == 1 and "<dt>floor, released</dt><dd>released_floor</dd>" in text
    assert "In what do paper and released differ?" in text


def test_figures_and_replays_are_carried(tmp_path, paper, monkeypatch, capsys):
    figures = tmp_path / "figures"
    figures.mkdir()
    (figures / "captions.json").write_text(json.dumps({"tree": "A & B"}))
    (figures / "tree.png").write_bytes(b"\x89PNG...")
    shown = tmp_path / "trophic"  # a program that shows a run as `trophic show RUN -o PAGE` does
    shown.write_text(f"#!/bin/sh\ncat > $4 <<'END'\n<p>{INDEX}{FILE}</p>\nEND\necho trophic show: a remark >&2\n")
    shown.chmod(0o755)
    monkeypatch.setenv("TROPHIC_BIN", str(tmp_path))
    replays = page.replays_of([paper], 1, "trophic analyze")
    assert capsys.readouterr().err == "trophic analyze: a remark\n"
    said, text = written(
        tmp_path, [paper], judge.summarize(paper), {**REQUEST, "figures": str(figures)}, replays=replays
    )
    assert "1 figures, 1 replays" in said
    assert (
        f'src="data:image/png;base64,{base64.b64encode(b"%cPNG..." % 0x89).decode()}"' in text
        and "<figcaption>A &amp; B</figcaption>" in text
    )
    viewer = base64.b64encode(b"<p><!--RUNS--></p>\n").decode()
    assert f'id="viewer">{viewer}</script>' in text
    assert '<template data-replay="0">' + INDEX + FILE + "</template>" in text and ">replicate-00</button>" in text


@pytest.mark.parametrize(
    "captions, png, sentence",
    [
        (None, b"", "captions.json: No such file"),
        ("[]", b"", "is not a JSON object"),
        ('{"../a": "b"}', b"", "must be the name of a figure"),
        ('{"a": 1}', b"", "its caption a text"),
        ('{"a": "b"}', None, "a.png: No such file"),
        ('{"a": "b"}', b"GIF", "a.png: is not a PNG"),
    ],
)
def test_a_folder_without_figures_is_refused(tmp_path, captions, png, sentence):
    if captions is not None:
        (tmp_path / "captions.json").write_text(captions)
    if png is not None:
        (tmp_path / "a.png").write_bytes(png)
    with pytest.raises(RunError, match=re.escape(sentence)):
        page.read_figures(tmp_path)


def test_nothing_is_overwritten(tmp_path, paper):
    (tmp_path / "page.html").write_text("mine")
    with pytest.raises(RunError, match="exists already; files are never overwritten"):
        written(tmp_path, [paper], judge.summarize(paper))
    assert (tmp_path / "page.html").read_text() == "mine"
