#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""python_module_test.py FOLDER INSTALLED: the module my_ecology of a project's own table, in FOLDER, has everything that the installed module
trophic_ecologies has. Both run in one process, find the installed models, and write their own hashes into manifests."""

import importlib.machinery
import json
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
from system_python import need

need("numpy")
OWN, INSTALLED = map(pathlib.Path, sys.argv[1:])
SKIPPED = 77


def manifest_of(module, table: str) -> dict:
    ecology = module.Ecology({"rule_table": table, "engine": "kinematic", "seed": 1, "ecology.duration_s": 1300.0})
    with tempfile.TemporaryDirectory() as folder:
        ecology.reset(out=pathlib.Path(folder) / "run")
        causes = set()
        while ecology.sense():
            causes |= {event[6] for event in ecology.events()}
            ecology.decide(ecology.own_outputs())
        assert ("senescence" in causes) == (table == "my_table"), causes
        return json.loads((pathlib.Path(folder) / "run/manifest.json").read_text())


def main() -> int:
    suffixes = importlib.machinery.EXTENSION_SUFFIXES
    if not any((OWN / f"my_ecology{suffix}").exists() for suffix in suffixes):
        print(f"the module was built for another Python: none of {suffixes}")
        return SKIPPED
    sys.path[:0] = [str(OWN), str(INSTALLED)]
    import my_ecology
    import trophic_ecologies

    assert my_ecology.rule_tables() == ["my_table"]
    assert len(trophic_ecologies.rule_tables()) >= 9
    assert dir(my_ecology) == dir(trophic_ecologies)
    assert dir(my_ecology.Ecology) == dir(trophic_ecologies.Ecology)
    assert my_ecology.Ecology is not trophic_ecologies.Ecology
    own, shipped = manifest_of(my_ecology, "my_table"), manifest_of(trophic_ecologies, "paper")
    assert own["rule_table"] == "my_table with brain = outside"
    assert own["rules"]["senescence"] == "old_age"
    assert own["code"] != shipped["code"]
    assert own["trophic_revision"] == shipped["trophic_revision"]
    return 0


if __name__ == "__main__":
    sys.exit(main())
