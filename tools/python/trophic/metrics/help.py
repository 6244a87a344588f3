# SPDX-License-Identifier: MIT
"""`trophic help metrics`: the names that --metric takes."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..words import columns
from . import Web, living, names_of


def run(request: Mapping[str, Any]) -> int:
    rows: dict[tuple[str, str], list[str]] = {}
    web = Web(["prey", "predator"], [("predator", "prey")])
    for name in [*names_of(web), *living.names(web, True)]:
        rows.setdefault((name.metric, name.unit), []).append(f"{name.species}:{name.group}")
    print("METRIC:SPECIES:GROUP as --metric takes them, in a food web of prey and predators; docs/GLOSSARY.md defines them")
    print(columns([("metric", "unit", "of"), *((*of, " ".join(groups)) for of, groups in rows.items())]), end="")
    return 0
