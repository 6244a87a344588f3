# SPDX-License-Identifier: MIT
"""The command lines of the verbs."""
import pytest
from trophic.errors import RunError
from trophic.options import VERBS, parsed


def test_options_are_read_wherever_they_stand():
    request = parsed("analyze", ["--published", "a", "--until", "1e3", "--jobs", "2", "b"])
    assert (request["runs"], request["published"], request["until"], request["jobs"], request["who"]) == (
        ["a", "b"],
        True,
        1000.0,
        2,
        "trophic analyze",
    )
    assert request["metric"] is None and request["all"] is False
    assert parsed("analyze", ["a", "--metric", "x", "y", "--metric", "z"])["metric"] == ["x", "y", "z"]
    assert parsed("analyze", ["--compare", "a", "b"])["compare"] == ["a", "b"]


@pytest.mark.parametrize(
    "verb, words, sentence",
    [
        ("analyze", ["run", "--publish"], "--publish: unknown option; did you mean --published? (--help lists all)"),
        ("analyze", ["run", "--compare", "a", "b", "--published"], "--compare: not with --published"),
        ("analyze", ["run", "--selection", "turns_to", "--bodies"], "--selection: not with --bodies"),
        ("analyze", ["run", "--figures", "figures"], "--figures: needs --html"),
        ("analyze", ["run", "--until", "-1"], "--until -1: must be > 0"),
        ("analyze", ["run", "--until", "nan"], "--until nan: must be a number in decimal digits"),
        ("analyze", ["run", "--replays", "21"], "--replays 21: must be <= 20"),
        ("analyze", ["run", "--jobs", "0"], "--jobs 0: must be >= 1"),
        ("analyze", ["run", "--jobs", "010"], "--jobs 010: must be a whole number in decimal digits"),
        (
            "analyze",
            ["run", "--reference", "18446744073709551616"],
            "--reference 18446744073709551616: must be <= 18446744073709551615",
        ),
        ("analyze", ["run", "--out", ""], "--out: must not be empty"),
        ("analyze", ["run", "--out"], "--out: needs a value"),
        ("plot", [], "analysis is required"),
        ("plot", ["a", "--style", "ieeee"], "--style ieeee: must be plain, serif or ieee; did you mean ieee?"),
        ("cite", ["a", "b"], "b: unexpected argument (--help lists all)"),
    ],
)
def test_what_a_verb_does_not_take_is_refused(verb, words, sentence):
    with pytest.raises(RunError) as refusal:
        parsed(verb, words)
    assert str(refusal.value) == sentence


@pytest.mark.parametrize("verb", VERBS)
def test_help_and_its_examples(verb, capsys):
    with pytest.raises(SystemExit) as end:
        parsed(verb, ["--help"])
    text = capsys.readouterr().out
    assert end.value.code == 0 and text.startswith(f"usage: trophic {verb} ") and "Exit codes: 0 done; 1 " in text
    for example in VERBS[verb].examples:
        assert example.startswith(f"trophic {verb}") and f"\n  {example}\n" in text
        assert parsed(verb, example.split()[2:])
