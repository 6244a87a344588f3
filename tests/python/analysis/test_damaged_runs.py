# SPDX-License-Identifier: MIT
"""A run with a damaged manifest or table is measured or refused in one sentence, and nothing else."""
import json
import math
import random

import pytest
from hand_written import write_run, write_sealed_run
from in_folder import sealed_text
from trophic import pool, runs
from trophic.metrics import Measuring
from trophic.runs import RunError

VALUES = [None, True, -1, 0, 1e300, math.nan, math.inf, "", [], {}, "x", "\x1b", [1], {"a": 1}, 10**30, [[]], [None]]
BYTES = b'0123456789,.-"\n\r\x00\xffnaeinf '
MORE = {
    "code": "a",
    "origin": {"at_s": "1", "run": "x", "seed": "1", "fingerprint": "a"},
    "tables": {},
    "result": {"reached_s": 6000.0},
    "continued": [{"code": "b"}],
    "agents_every_ticks": 1,
}


def damaged_json(draw, manifest):
    node = manifest
    while True:
        key = draw.choice(list(node)) if isinstance(node, dict) else draw.randrange(len(node))
        if node[key] and isinstance(node[key], (dict, list)) and draw.random() < 0.5:
            node = node[key]
        elif isinstance(node, dict) and draw.random() < 0.3:
            return node.pop(key)
        else:
            node[key] = draw.choice(VALUES)
            return node[key]


def damaged_bytes(draw, content):
    place = draw.randrange(len(content))
    return content[:place] + bytes(draw.choices(BYTES, k=draw.randrange(20))) + content[place + draw.randrange(30) :]


def test_a_long_cell_is_quoted_by_its_beginning_and_a_column_is_there_once(tmp_path):
    run = write_run(tmp_path / "run")
    events = (run / "events.csv").read_text()
    for damaged, why in (
        (events.replace(",prey,", f",{'x' * 10**6},", 1), 'species = "x{100}\\.\\.\\.": must be'),
        (events.replace("x_m", "tag", 1), "column 'tag': must be"),
    ):
        (run / "events.csv").write_text(damaged)
        with pytest.raises(RunError, match=why) as caught:
            pool.read_set([run], how=Measuring(jobs=1))
        assert len(str(caught.value)) < 500


@pytest.mark.parametrize("seed", range(4))
def test_damage_is_refused_in_one_sentence(seed, tmp_path):
    draw = random.Random(seed)
    run = write_run(tmp_path / "run", files={"own.csv": "time_s,species,x\n0,prey,1\n3,predator,2\n"}, **MORE)
    whole = {file: file.read_bytes() for file in run.iterdir()}
    refused = 0
    for _ in range(60):
        for file, content in whole.items():
            file.write_bytes(content)
        file = draw.choice(list(whole))
        if file.name == "manifest.json":
            manifest = json.loads(whole[file])
            damaged_json(draw, manifest)
            file.write_text(json.dumps(manifest))
        else:
            file.write_bytes(damaged_bytes(draw, whole[file]))
        try:
            pool.read_set([run], how=Measuring(jobs=1, columns=["own.csv:x"], until_s=draw.choice([None, 1.0])))
        except RunError as error:
            refused += 1
            assert str(tmp_path) in str(error) and "\n" not in str(error)
    assert refused > 30


def test_no_damage_of_a_complete_run_is_silent(tmp_path):
    draw = random.Random(1)
    run = write_sealed_run(tmp_path / "run")
    runs.verify(run)
    whole = {file: file.read_bytes() for file in sorted(run.iterdir())}
    for number in range(120):
        file = draw.choice(list(whole))
        content = whole[file]
        place = draw.randrange(len(content))
        damaged = draw.choice(
            [
                content[:place],
                content + content[:1],
                content[:place] + bytes([content[place] ^ 1 << draw.randrange(8)]) + content[place + 1 :],
                content[:place] + content[place + 1 :],
                content.replace(b"\n", b"\r\n"),
            ]
        )
        if number % 10 == 0:
            manifest = json.loads(whole[run / "manifest.json"])
            damaged_json(draw, manifest)
            file, damaged = run / "manifest.json", json.dumps(manifest, indent=2).encode() + b"\n"
        if damaged == whole[file]:
            continue
        file.write_bytes(damaged)
        with pytest.raises(RunError, match=f"^{file}: [^\n]+$"):
            runs.verify(run)
        file.write_bytes(whole[file])
    for file in whole:
        file.rename(tmp_path / "away")
        if file.name != "checkpoint.bin":  # a run can be read without it
            with pytest.raises(RunError, match=file.name):
                runs.verify(run)
        (tmp_path / "away").rename(file)
    other = {**json.loads(whole[run / "manifest.json"]), "seed": 2}
    (run / "manifest.json").write_text(sealed_text(other))
    with pytest.raises(
        RunError, match="checkpoint.bin: is of fingerprint aa, seed 1: must be of aa, 2, as manifest.json"
    ):
        runs.verify(run)
