# SPDX-License-Identifier: MIT
"""The authors' log of positions as a run."""
import subprocess
import sys

import pandas
from conftest import STUDIES
from trophic import pool

SCRIPT = STUDIES / "python/authors_log.py"


def log(changes_at=99):
    """Two bodies, 0.2 m apart, for 16 s: body 1 walks to prey 0 at 0.01 m a row, and is a prey itself from a row on."""
    rows = [
        f'{body},{2.007 * (row + 1)},[{0.2 - 0.01 * row if body else 0.0}  1.5e+00 0.05],0.5,{"pred" if body and row < changes_at else "prey"},1,'
        f"{1 - body},{bool(body) or row > 3},{not body}"
        for row in range(8)
        for body in (0, 1)
    ]
    return "\n".join(["id,simTime,position,angle,predprey,tag,otherID,immCheck,RanW", *rows]) + "\n"


def test_the_log_is_measured_as_a_run_of_ours(tmp_path):
    (tmp_path / "countries.csv").write_text(log())
    for code in (0, 1):  # files are never overwritten
        assert bool(
            subprocess.run(
                [sys.executable, SCRIPT, tmp_path / "countries.csv", tmp_path / "out"], capture_output=True
            ).returncode
        ) == bool(code)
    (values,) = pool.read_set([tmp_path / "out"]).values
    found = {
        f"{row.metric}:{row.species}:{row.group}": row.value for row in values.values.itertuples() if not row.baseline
    }
    assert abs(found["velocity:predator:inherited"] - 0.01 / 2.007) < 1e-9 and found["locked:all:all"] == 1.0
    assert abs(found["near_longest:all:all"] - 7 * 2.007) < 1e-9 and found["population:prey:random"] == 1.0


def test_a_body_that_changes_its_species_has_another_individual(tmp_path):
    (tmp_path / "countries.csv").write_text(log(5))
    subprocess.run([sys.executable, SCRIPT, tmp_path / "countries.csv", tmp_path / "out"], check=True)
    rows = pandas.read_csv(tmp_path / "out/agents.csv")
    assert rows[rows.body == 1].id.tolist() == [1] * 5 + [3] * 3 and rows[rows.body == 0].adversary_id.isna().sum() == 3
    assert rows[rows.body == 0].active.tolist() == [0] * 4 + [1] * 4
