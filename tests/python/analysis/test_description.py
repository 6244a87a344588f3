# SPDX-License-Identifier: MIT
"""A set of runs is described from its manifests, those of older programs included."""
import json
import zlib

import pandas
import pytest

from trophic import description, judge
from trophic.report import text
from trophic.runs import RunError, Runs, read_run, read_runs
from trophic.values import VALUE_COLUMNS, MeasuredSet, RunValues

MANIFEST = {
    "trophic": "0.1.0",
    "status": "complete",
    "fingerprint": "0123456789abcdef",
    "seed": 7,
    "rule_table": "paper",
    "backend": "kinematic 1",
    "code": "c0de",
    "clock": {"tick_s": 1.0, "until_s": 20.0},
    "tables": {},
}
ORIGIN = {"at_s": "700", "run": "runs/a", "seed": "7", "fingerprint": "fedcba9876543210"}
SAID = {
    "name": "paper (capture.reach_m 0.5 at 10 s)",
    "sentence": "rule table `paper` and its parameters; at 10 s rules.capture.reach_m changes from 0.3 to 0.5",
    "parameters": [],
    "changes": [{"time_s": 10.0, "number": "rules.capture.reach_m", "value": "0.5", "before": "0.3"}],
}
CHANGES = "time_s,tick,number,value,before\n"


def run_in(folder, changes="", **entries):
    folder.mkdir(parents=True)
    (folder / "manifest.json").write_text(json.dumps({**MANIFEST, **entries}))
    if changes:
        (folder / "changes.csv").write_text(CHANGES + changes)
    return read_run(folder)


def described(run):
    return description.describe(Runs(run.path, [run]))


def test_a_manifest_s_own_words_are_used(tmp_path):
    one = described(run_in(tmp_path / "a", identity="0123456789abcdef+01234567", description=SAID))
    assert one.label == SAID["name"]
    assert one.title() == "paper (capture.reach_m 0.5 at 10 s) on kinematic 1"
    assert one.sentence() == f"A run of 20 s on kinematic 1, with the {SAID['sentence']}."
    assert one.sentence("in trophic 0.1.0").startswith("A run of 20 s on kinematic 1 in trophic 0.1.0, with")
    assert one.changes == (description.Change(10.0, "rules.capture.reach_m", "0.5", "0.3"),)
    assert one.facts()["fingerprint"] == "0123456789abcdef+01234567"


@pytest.mark.parametrize(
    "changes, origin, identity, label",
    [
        ("", None, "", "paper"),
        ("5,5,rules.a,1,1\n", None, "", "paper"),  # no effect
        ("5,5,rules.a,2,1\n5,5,rules.a,1,2\n", None, "", "paper"),  # nor has this, at the end of the tick
        ("5,5,rules.a,2,1\n", None, "5 rules.a=2\n", "paper (1 change)"),
        (
            "5,5,rules.b,2,1\n5,5,rules.a,x,y\n12,12,rules.a,y,x\n",
            None,
            "5 rules.a=x\n5 rules.b=2\n12 rules.a=y\n",
            "paper (3 changes)",
        ),
        ("", ORIGIN, "700 7 fedcba9876543210\n", "paper (from 700 s)"),
        ("800,800,rules.a,2,1\n", ORIGIN, "700 7 fedcba9876543210\n800 rules.a=2\n", "paper (1 change; from 700 s)"),
    ],
)
def test_an_older_run_with_changes_has_a_name_of_its_own(tmp_path, changes, origin, identity, label):
    run = run_in(tmp_path / "a", changes, **({"origin": origin} if origin else {}))
    assert run.identity == MANIFEST["fingerprint"] + (f"+{zlib.crc32(identity.encode()):08x}" if identity else "")
    assert described(run).label == label
    assert ("begins at 700 s of runs/a (seed 7)" in described(run).sentence()) == bool(origin)


def test_replicates_have_one_identity(tmp_path):
    run_in(tmp_path / "replicate-00", "5,5,rules.a,2,1\n")
    run_in(tmp_path / "replicate-01", "5,5,rules.a,2,1\n", seed=8)
    set_ = read_runs(tmp_path)
    assert description.describe(set_).length() == "2 runs of 20 s"
    run_in(tmp_path / "replicate-02", seed=9)
    with pytest.raises(RunError, match="different fingerprints: 0123456789abcdef, 0123456789abcdef\\+"):
        read_runs(tmp_path)


@pytest.mark.parametrize(
    "status, result, rows, until_s, length",
    [
        ("complete", {"reached_s": 21.0}, "", 20.0, "A run of 20 s"),  # the last tick ends later
        ("complete", {"reached_s": 20.0}, "", 5.0, "A run of the first 5 of 20 s"),
        ("stopped", {"reached_s": 5.0}, "", 20.0, "A run of 5 s (stopped; 20 s planned)"),
        ("stopped", {"reached_s": 5.0}, "", 3.0, "A run of the first 3 of 5 s (stopped; 20 s planned)"),
        ("failed", {"reached_s": 0.0}, "", 20.0, "A run of 0 s (failed; 20 s planned)"),
        ("running", None, "4,2,x\n7.5,3,x\n8,", 20.0, "A run of 7.5 s (killed or still running; 20 s planned)"),
        ("running", None, "", 20.0, "A run of 0 s (killed or still running; 20 s planned)"),
        (
            "complete",
            {"reached_s": 9.0, "ended": "prey"},
            "",
            20.0,
            "A run of 9 s (ended early, by ecology.ends_when; 20 s planned)",
        ),
    ],
)
def test_a_run_is_as_long_as_it_lived(tmp_path, status, result, rows, until_s, length):
    run = run_in(tmp_path / "a", status=status, **({"result": result} if result else {}))
    (run.path / "events.csv").write_text("time_s,tick,event\n" + rows)
    assert description.describe(MeasuredSet("", [run], [], until_s=until_s)).length() == length


def test_runs_that_are_not_there_are_planned(tmp_path):
    for seed in (1, 2):
        run_in(tmp_path / f"replicate-0{seed}", seed=seed, **({"status": "stopped"} if seed == 2 else {}))
    (tmp_path / "replicates.json").write_text(
        json.dumps({"replicates": [{"folder": f"replicate-0{i}"} for i in range(4)]})
    )
    assert description.describe(read_runs(tmp_path)).length() == "1 of 4 planned runs of 20 s"
    assert description.describe(read_runs(tmp_path, incomplete=True)).length() == (
        "2 of 4 planned runs of 0 to 20 s (1 stopped; 20 s planned)"
    )


def test_several_builds_are_counted(tmp_path):
    runs = [run_in(tmp_path / "a"), run_in(tmp_path / "b", seed=8, code="beef")]
    assert description.describe(Runs(tmp_path, runs)).sentence().endswith("; 2 builds of the program made them.")


def test_equal_labels_are_distinguished():
    assert description.distinct(["paper", "released", "paper"]) == ["paper (a)", "released", "paper (b)"]


@pytest.mark.parametrize(
    "said, line",
    [
        (SAID, f"rules: {SAID['sentence']}\n"),
        ({**SAID, "name": "paper", "sentence": "rule table `paper` and its parameters"}, ""),
    ],
)
def test_the_terminal_prints_what_differs_from_the_table(tmp_path, said, line):
    values = RunValues(pandas.DataFrame([["hunger", "prey", "all", "1", "", "", 1.0]], columns=VALUE_COLUMNS))
    of = MeasuredSet(
        said["name"],
        [run_in(tmp_path / "a", description=said, identity="0123456789abcdef+01234567")],
        [values],
        None,
        20.0,
    )
    shown = text.table(of, judge.summarize(of))
    assert shown.startswith(
        f"{said['name']} on kinematic 1, a run of 20 s, fingerprint 0123456789abcdef+01234567\n{line}not tested: behaviour and counts: no shadow"
    )
