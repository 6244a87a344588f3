# SPDX-License-Identifier: MIT
"""A run with a damaged manifest or table is measured or refused in one sentence, and nothing else."""
import json
import math
import random

import pytest
from hand_written import write_run
from trophic import pool
from trophic.metrics import Measuring
from trophic.runs import RunError

VALUES = [None, True, -1, 0, 1e300, math.nan, math.inf, "", [], {}, "x", "\x1b", [1], {"a": 1}, 10**30, [[]], [None]]
BYTES = b'0123456789,.-"\n\r\x00\xffnaeinf '
MORE = {"code": "a", "origin": {"at_s": "1", "run": "x", "seed": "1", "fingerprint": "a"}, "tables": {}, "result": {"reached_s": 6000.0},
        "continued": [{"code": "b"}],
        "agents_every_ticks": 1}


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
    return content[:place] + bytes(draw.choices(BYTES, k=draw.randrange(20))) + content[place + draw.randrange(30):]


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
