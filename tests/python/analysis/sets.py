# SPDX-License-Identifier: MIT
"""Measured sets of hand-written values."""
from __future__ import annotations

import pathlib

import numpy
import pandas
from trophic.runs import Run
from trophic.values import VALUE_COLUMNS, MeasuredSet, Metric, RunValues


def run_of(seed: int, table: str = "paper", folder: str = "runs") -> Run:
    return Run(
        pathlib.Path(folder) / f"replicate-{seed:02}",
        {
            "rule_table": table,
            "backend": "kinematic 1",
            "seed": seed,
            "status": "complete",
            "fingerprint": "aa",
            "species": ["prey", "predator"],
            "arena": {"half_side_m": 10.0},
            "clock": {"until_s": 6000.0},
        },
    )


def metric(name: str, species: str = "prey", group: str = "all") -> Metric:
    return Metric(name, species, group, "m/s" if name.startswith("velocity") else "1")


def set_of(
    values: dict[Metric, list[float]],
    baselines: dict[tuple[Metric, str, str], list[float]] | None = None,
    shadow: MeasuredSet | None = None,
    label: str = "paper",
) -> MeasuredSet:
    """`values`: of each metric, one a run; `baselines`: of (metric, name, role)."""
    count = len(next(iter(values.values())))
    runs = []
    for i in range(count):
        rows = []
        for name, of_runs in values.items():
            rows.append([*name, "", "", of_runs[i]])
            rows += [
                [*name, baseline, role, its[i]] for (of, baseline, role), its in (baselines or {}).items() if of == name
            ]
        runs.append(RunValues(pandas.DataFrame(rows, columns=VALUE_COLUMNS)))
    return MeasuredSet(label, [run_of(i, label) for i in range(count)], runs, shadow, 6000.0)


def around(value: float, count: int = 6, spread: float = 0.01) -> list[float]:
    return [value + (spread if i % 2 == 0 else -spread) for i in range(count)]


def quick_set(
    values: dict[Metric, numpy.ndarray], shadow: MeasuredSet | None = None, label: str = "simulated"
) -> MeasuredSet:
    """A set without rows of runs, for thousands of simulated analyses."""
    count = len(next(iter(values.values())))
    made = MeasuredSet(
        label, [run_of(0, label)] * count, [RunValues(pandas.DataFrame(columns=VALUE_COLUMNS))] * count, shadow, 6000.0
    )
    made.__dict__.update(table={(name, ""): of for name, of in values.items()}, roles={})
    return made
