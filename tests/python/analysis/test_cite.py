# SPDX-License-Identifier: MIT
"""`trophic cite` says of a set what its description says, and refuses what is not one set."""
import json
import re

import pytest

from trophic import cite
from trophic.runs import RunError

MANIFEST = {
    "trophic": "0.1.0",
    "trophic_revision": "abc",
    "source_revision": "abc",
    "status": "complete",
    "fingerprint": "0123456789abcdef",
    "identity": "0123456789abcdef",
    "seed": 7,
    "rule_table": "paper",
    "backend": "kinematic 1",
    "code": "c0de",
    "clock": {"until_s": 20.0},
    "arena": {"half_side_m": 5.0},
    "species": [],
    "food_web": [],
    "description": {
        "name": "paper",
        "sentence": "rule table `paper` and its parameters",
        "parameters": [],
        "changes": [],
    },
}
CHANGED = {
    "identity": "0123456789abcdef+01234567",
    "description": {
        **MANIFEST["description"],
        "sentence": "rule table `paper` and its parameters; at 5 s rules.a changes from 1 to 2",
    },
}


def write(folder, **entries):
    folder.mkdir(parents=True)
    (folder / "manifest.json").write_text(json.dumps({**MANIFEST, **entries}))


def replicates(folder, *entries):
    for i, each in enumerate(entries):
        write(folder / f"replicate-{i:02}", seed=i, master_seed="3", **each)
    (folder / "replicates.json").write_text(
        json.dumps({"replicates": [{"folder": f"replicate-{i:02}", "seed": i} for i in range(len(entries))]})
    )


def cited(folder, capsys):
    assert cite.run({"who": "trophic cite", "run": str(folder)}) == 0
    return capsys.readouterr().out.split("\n\n", 1)


def test_a_run(tmp_path, capsys):
    write(tmp_path / "run")
    sentence, entries = cited(tmp_path / "run", capsys)
    assert sentence == (
        "A run of 20 s on kinematic 1 in trophic 0.1.0 (revision abc, fingerprint 0123456789abcdef, seed 7), with the rule table `paper` and its "
        "parameters."
    )
    assert "note = {Software, version 0.1.0, revision abc}" in entries and "@article{kachler2023," in entries


@pytest.mark.parametrize(
    "entries, parts",
    [
        (
            [CHANGED] * 2,
            [
                "2 runs of 20 s",
                "fingerprint 0123456789abcdef+01234567, master seed 3",
                "; at 5 s rules.a changes from 1 to 2.",
            ],
        ),
        (
            [{}, {"code": "beef", "trophic_revision": "def", "source_revision": "def"}],
            ["(revision abc and def, f", "; 2 builds of the program made them."],
        ),
        ([{"description": {}}], ["with the rule table `paper`."]),
    ],
)
def test_what_a_set_is_stands_in_the_sentence(tmp_path, capsys, entries, parts):
    replicates(tmp_path / "set", *entries)
    sentence, _ = cited(tmp_path / "set", capsys)
    for part in parts:
        assert part in sentence


@pytest.mark.parametrize(
    "entries, words, note",
    [
        ({"source_revision": "mine"}, "(revision abc, program of revision mine, fingerprint", "0.1.0, revision abc}"),
        ({"trophic_revision": "unknown"}, "0.1.0 (program of revision abc, fingerprint", "version 0.1.0}"),
    ],
)
def test_the_revision_of_somebody_s_program_is_not_trophic_s(tmp_path, capsys, entries, words, note):
    write(tmp_path / "run", **entries)
    sentence, bibtex = cited(tmp_path / "run", capsys)
    assert words in sentence and note in bibtex and "mine" not in bibtex


def test_what_is_cited_is_what_ran(tmp_path, capsys):
    write(tmp_path / "run", status="stopped", result={"reached_s": 5.0})
    assert cited(tmp_path / "run", capsys)[0].startswith("A run of 5 s (stopped; 20 s planned) on kinematic 1")
    replicates(tmp_path / "set", {}, {}, {"status": "failed", "result": {"reached_s": 3.0}})
    (tmp_path / "set/replicate-00/manifest.json").unlink()  # was not begun
    assert cited(tmp_path / "set", capsys)[0].startswith(
        "2 of 3 planned runs of 3 to 20 s (1 failed; 20 s planned) on kinematic 1"
    )


def test_an_older_run_names_the_file_with_its_parameters(tmp_path, capsys):
    write(tmp_path / "run")
    old = {key: value for key, value in MANIFEST.items() if key not in ("description", "identity")}
    (tmp_path / "run/manifest.json").write_text(json.dumps(old))
    assert cited(tmp_path / "run", capsys)[0].endswith(
        "with the rule table `paper`. The parameters are in manifest.json."
    )


@pytest.mark.parametrize(
    "make, sentence",
    [
        (
            lambda folder: (folder.mkdir(), (folder / "plan.jsonl").write_text("{}\n")),
            "is a sweep; give one of its cells",
        ),
        (lambda folder: folder.mkdir(), "is set a run's folder?"),
        (lambda folder: (folder.mkdir(), replicates(folder)), "no runs found"),
        (
            lambda folder: replicates(folder, {}, CHANGED),
            "runs with different fingerprints: 0123456789abcdef, 0123456789abcdef+01234567",
        ),
    ],
)
def test_what_is_not_one_set_is_refused(tmp_path, monkeypatch, make, sentence):
    monkeypatch.chdir(tmp_path)
    make(tmp_path / "set")
    with pytest.raises(RunError, match=re.escape(sentence)):
        cite.run({"who": "trophic cite", "run": "set"})
