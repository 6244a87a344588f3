# SPDX-License-Identifier: MIT
"""Starts trophic's programs and reads their files: runs, studies and analyses as pandas frames, recordings as numpy arrays, figures."""
from __future__ import annotations

import importlib

__version__ = "0.1.0"
# The module of each name; __init__.pyi tells checkers of types. Modules are imported at first use, because numpy, pandas or matplotlib may be missing.
_MODULES = {
    "Recording": "recording",
    "RecordingError": "recording",
    "read_replay": "recording",
    "Run": "runs",
    "Runs": "runs",
    "Analysis": "runs",
    "RunError": "errors",
    "read_run": "runs",
    "read_runs": "runs",
    "read_study": "runs",
    "read_analysis": "runs",
    "verify": "runs",
    "study_frames": "runs",
    "to_parquet": "runs",
    "metric": "metrics.own",
    "Page": "programs",
    "env": "environment",
    "Environment": "environment",
    "OneAgent": "environment",
    "VectorEnv": "ecologies",
    "Meeting": "meetings",
    "meet": "meetings",
    "show": "start",
    "run": "start",
    "sweep": "start",
    "analyze": "start",
    "analyze_sweep": "sweeps",
    "SweepAnalysis": "sweeps",
    "ProgramError": "errors",
}
__all__ = sorted(_MODULES)
_PARTS = ("figures", "metrics", "pool", "programs", "recording", "runs", "start")


def __getattr__(name):
    if name in _MODULES:
        return getattr(importlib.import_module(f".{_MODULES[name]}", __name__), name)
    if name in _PARTS:
        return importlib.import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return [*globals(), *__all__]
