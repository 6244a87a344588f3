# SPDX-License-Identifier: MIT
"""The sweeps of `paper` and `released`: each cell has the rule in its name as the other table has it, and no other."""

import collections
import json
import re

import pytest
from conftest import STUDIES, Folder

TABLES = ("paper", "released")
GROUPS = ("perception", "reproduction", "death")
# Numbers that act on joints alone.
OF_JOINTS = {"ecology.cpg_integration", "ecology.idle_control_steps", "physics.timestep_s", "physics.integrator"}  # fmt: skip
# Rules that act only if ...
ELSEWHERE = {
    "heading": "robots tilt",
    "brain": "all inputs are 0, which no shipped sensor of distance gives",
    "distance_over_scale": "the scale is not the arena's",
    "activation": "a rule reads the age of prey",
}


def numbers(tree, path=""):
    """Each number of a manifest with its path."""
    if not isinstance(tree, dict):
        return {path: tree}
    flat = {}
    for name, part in tree.items():
        flat |= numbers(part, f"{path}.{name}" if path else name)
    return flat


def policies(run):
    """Each policy of a manifest with its slot; those of a policy that is made of parts with SLOT.PART."""
    found = {}
    for slot, policy in run["rules"].items():
        parts = dict(part.split(": ") for part in policy.split(", ")) if ": " in policy else {}
        found |= {f"{slot}.{part}": name for part, name in parts.items()} or {slot: policy}
    return found


def changes(a, b):
    """The slots, parts and paths of numbers in which two manifests differ; numbers of a policy that differs are not named."""
    here, there = policies(a), policies(b)
    rules = {rule for rule in here.keys() | there.keys() if here.get(rule) != there.get(rule)}
    x, y = numbers(a["params"]), numbers(b["params"])
    paths = {path.removeprefix("rules.") for path in x.keys() | y.keys() if x.get(path) != y.get(path)}
    return rules | {path for path in paths - {"seed"} if not any(path.startswith(f"{rule}.") for rule in rules)}


def sensors(run):
    return set(run["rules"]["sensors"].split(" + "))


@pytest.fixture(scope="module", params=TABLES)
def sweep(request, tmp_path_factory):
    """A sweep with one run in each cell: its table, and the line of the plan, the folder and the manifest of each cell."""
    folder = Folder(tmp_path_factory.mktemp(request.param))
    text = (STUDIES / f"ablations/from_{request.param}.toml").read_text()
    text = text.replace("replicates = 10", "replicates = 1").replace("shadow = true", "shadow = false")
    (folder.path / "sweep.toml").write_text(text)
    folder.run("trophic", "plan", "sweep.toml", "--program", "trophic-ablations", "--out", "sweep")
    folder.run("trophic-ablations", "--plan", "sweep/plan.jsonl", "--jobs", 2)
    lines = [json.loads(line) for line in (folder.path / "sweep/plan.jsonl").read_text().splitlines()]
    runs = [folder.path / "sweep" / line["folder"] for line in lines]
    return request.param, [
        (line, run, json.loads((run / "manifest.json").read_text())) for line, run in zip(lines, runs)
    ]


def test_the_cells_are_the_table_each_difference_alone_each_group_and_the_other_table(sweep):
    table, ((line, _, base), *cells, (last, _, there)) = sweep
    assert (line["rule_table"], line["settings"].keys()) == (table, {"ecology.duration_s"})
    assert {table, last["rule_table"]} == set(TABLES) and last["settings"] == line["settings"]
    differing = changes(base, there)
    assert len(differing) > 20 and OF_JOINTS < differing
    named = {f"{table}_{rule.replace('.', '_')}": rule for rule in differing}
    alone, together, extra = set(), set(), set()
    for line, _, swapped in cells:
        changed, name = changes(base, swapped), line["rule_table"].removeprefix(f"{table}_")
        settings = {path.removeprefix("rules.") for path in line["settings"]} - {"ecology.duration_s"}
        if name in GROUPS or len(settings) > 1:
            assert not together & changed and not changes(swapped, there) & changed, line
            together |= changed
        elif name == "brain_with_biases":
            assert changed == {"brain"}
            assert swapped["rules"]["brain"] == base["rules"]["brain"] + "_with_biases"
            assert swapped["params"]["rules"]["brain"] == base["params"]["rules"]["brain"]
            extra.add(name)
        elif name in sensors(there):
            assert changed == {"sensors"} and sensors(swapped) - sensors(base) == {name}
            assert len(sensors(base) - sensors(swapped)) == 1
            extra.add(name)
        else:
            (rule,) = settings or {named[line["rule_table"]]}
            assert changed == {rule}
            left = changes(swapped, there)
            assert rule not in left and not any(path.startswith(f"{rule}.") for path in left), (rule, left)
            alone.add(rule)
    assert alone == together == differing - OF_JOINTS
    assert extra == sensors(there) | {"brain_with_biases"}


def test_the_program_offers_the_tables_of_the_sweeps_and_no_others(folder):
    offered = re.search(
        r"--rules TEXT +rule table: ([\w, ]+?) \(",
        re.sub(r"\s+", " ", folder.run("trophic-ablations", "--help").stdout),
    )
    in_sweeps = {
        name
        for table in TABLES
        for name in re.findall(r'rule_table = "(\w+)"', (STUDIES / f"ablations/from_{table}.toml").read_text())
    }
    assert set(re.findall(r"\w+", offered[1])) - {"or"} == in_sweeps


def test_each_rule_changes_a_run(sweep):
    table, ((_, first, _), *cells) = sweep
    for line, run, _ in cells:
        name = line["rule_table"].removeprefix(f"{table}_")
        same = all((first / file).read_bytes() == (run / file).read_bytes() for file in ("events.csv", "agents.csv"))
        assert not same or name == table or name in ELSEWHERE, line


def test_every_death_has_a_birth(sweep, folder):
    for _, run, _ in sweep[1]:
        kinds = collections.Counter(row["event"] for row in folder.rows(run / "events.csv"))
        assert kinds["death"] > 0 and kinds["birth"] == kinds["death"] + 30, run
