# SPDX-License-Identifier: MIT
"""How the runs that a command names are measured."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..metrics import Measuring, own
from ..programs import program_named


def measuring_of(request: Mapping[str, Any]) -> Measuring:
    """How the runs of a request are measured."""
    functions = [function for file in request.get("metric_file") or () for function in own.read_metrics(file)]
    return Measuring(
        until_s=request.get("until"),
        accept_other_build=bool(request.get("accept_other_build")),
        columns=request.get("column") or (),
        functions=functions,
        bodies=bool(request.get("bodies")),
        kinds=request.get("kinds") or (),
        lineages=_program_of(request),
        window_s=request.get("window"),
        jobs=request.get("jobs"),
        metrics=request.get("metric") or (),
    )


def _program_of(request: Mapping[str, Any]) -> str | None:
    """The program that --lineages asks: a path, or one of trophic's by its name."""
    if not request.get("lineages"):
        return None
    return program_named(request.get("program") or "trophic-predator-prey")
