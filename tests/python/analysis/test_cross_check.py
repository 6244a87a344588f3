# SPDX-License-Identifier: MIT
"""Engines compared: walks written by hand, sets with known values, and what is refused."""
import json

import pandas
import pytest
from hand_written import write_set
from pytest import approx
from sets import around, metric, set_of
from trophic import cross_check
from trophic.report.columns import names
from trophic.runs import RunError

SCALE = {"speed_m_s": 0.04, "turn_rate_rad_s": -0.03, "power_W": 0.7, "torque_N_m": 0.1}
CONDITIONS = [("mujoco", "default", 0.0012, 1.0), ("mujoco", "default", 0.0006, 1.01), ("ode", "default", 0.0012, 1.02), ("ode", "springs 4x", 0.0012, 1.3)]


def write_walks(folder):
    """Twelve robots of each condition that do its factor times SCALE; the robot of a condition ends as many cm from the start as its place."""
    walks, paths = [], []
    for place, (*condition, factor) in enumerate(CONDITIONS):
        for robot in range(12):
            walks.append([*condition, 0.7, robot, *(value * (factor + 0.001 * (robot % 2)) for value in SCALE.values())])
            paths += [[*condition, 0.7, robot, time_s, 0.01 * place * (time_s == 10.0), 1.0, 0.0] for time_s in (0.0, 10.0)]
    of_both = ["engine", "settings", "timestep_s", "target_angle_rad", "robot"]
    pandas.DataFrame(walks, columns=[*of_both, *SCALE]).to_csv(folder / "walks.csv", index=False)
    pandas.DataFrame(paths, columns=[*of_both, "time_s", "x_m", "y_m", "heading_rad"]).to_csv(folder / "trajectories.csv", index=False)


def test_walks_are_compared_with_mujocos_at_its_default_timestep(tmp_path, capsys):
    (tmp_path / "part").mkdir()
    write_walks(tmp_path / "part")
    assert cross_check.run({"folder": str(tmp_path / "part"), "out": str(tmp_path / "out"), "runs": []}) == 0
    table = pandas.read_csv(tmp_path / "out" / "cross_check.csv")
    assert list(table.columns) == names("cross_check.csv") and len(table) == 4 * 6
    speed = table[table.quantity == "speed_m_s"].reset_index(drop=True)
    assert speed["mean"].tolist() == approx([0.04 * (factor + 0.0005) for *_, factor in CONDITIONS])
    assert speed["margin"].tolist() == approx([0.004 * 1.0005] * 4)
    assert speed["difference"].tolist() == approx([0.0, 0.0004, 0.0008, 0.012], abs=1e-12)
    assert speed["conclusion"].tolist() == ["equivalent", "equivalent", "equivalent", "different"]
    turning = table[table.quantity == "turn_rate_rad_s"]
    assert (turning["margin"] > 0).all() and turning["conclusion"].iloc[-1] == "different"
    off, own = (table.loc[table.quantity == f"distance_to_{name}_m", "mean"].tolist() for name in ("mujoco", "own"))
    assert off == approx([0.01, 0.0, 0.01, 0.02]) and own == approx([0.01, 0.0, 0.0, 0.01])
    shown = capsys.readouterr().out
    assert "2.0 % equivalent" in shown and "30.0 % different" in shown and shown.endswith(f"files   {tmp_path}/out\n")


@pytest.mark.parametrize("shift, conclusion", [(0.0, "equivalent"), (0.04, "equivalent"), (0.2, "different")])
def test_metrics_of_two_sets_are_equivalent_within_their_margin(shift, conclusion):
    wall, other = metric("wall_sticking"), metric("population")
    sets = [set_of({wall: around(value), other: around(3.0)}) for value in (0.5, 0.5 + shift)]
    ((first, second),) = cross_check.metrics(*sets)
    assert (first["quantity"], second["margin"], second["difference"]) == ("wall_sticking", 0.1, approx(shift, abs=1e-12))
    assert "conclusion" not in first and second["conclusion"] == conclusion


@pytest.mark.parametrize("change, sentence", [({"rule_table": "released"}, "rule_table"), ({"params": {"rules": {"floor": {"floor": 8}}}}, "floor"),
                                              ({"clock": {"until_s": 60.0}}, "60 of 60 s")])
def test_other_rules_parameters_and_lengths_are_refused(tmp_path, change, sentence):
    folders = [write_set(tmp_path / name, runs=2, shadow=False) for name in ("a", "b")]
    for path in folders[1].glob("*/manifest.json"):
        path.write_text(json.dumps({**json.loads(path.read_text()), **change}))
    with pytest.raises(RunError, match=sentence):
        cross_check.run({"folder": str(tmp_path), "runs": [str(folder) for folder in folders]})
    assert not (tmp_path / "cross_check.csv").exists()
