# SPDX-License-Identifier: MIT
"""Engines compared: sets with known values, and what is refused."""
import json

import pytest
from hand_written import write_set
from pytest import approx
from sets import around, metric, set_of
from trophic import cross_check
from trophic.runs import RunError


@pytest.mark.parametrize("shift, conclusion", [(0.0, "equivalent"), (0.04, "equivalent"), (0.2, "different")])
def test_metrics_of_two_sets_are_equivalent_within_their_margin(shift, conclusion):
    wall, other = metric("wall_sticking"), metric("population")
    sets = [set_of({wall: around(value), other: around(3.0)}) for value in (0.5, 0.5 + shift)]
    ((first, second),) = cross_check.metrics(*sets)
    assert (first["quantity"], second["margin"], second["difference"]) == (
        "wall_sticking",
        0.1,
        approx(shift, abs=1e-12),
    )
    assert "conclusion" not in first and second["conclusion"] == conclusion


@pytest.mark.parametrize(
    "change, sentence",
    [
        ({"rule_table": "released"}, "rule_table"),
        ({"params": {"rules": {"floor": {"floor": 8}}}}, "floor"),
        ({"clock": {"until_s": 60.0}}, "60 of 60 s"),
    ],
)
def test_other_rules_parameters_and_lengths_are_refused(tmp_path, change, sentence):
    folders = [write_set(tmp_path / name, runs=2, shadow=False) for name in ("a", "b")]
    for path in folders[1].glob("*/manifest.json"):
        path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    with pytest.raises(RunError, match=sentence):
        cross_check.run({"runs": [str(folder) for folder in folders], "out": str(tmp_path / "out")})
    assert not (tmp_path / "out").exists()
