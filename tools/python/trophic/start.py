# SPDX-License-Identifier: MIT
"""Starts trophic's programs. The rules are theirs: here are none."""
from __future__ import annotations

import os
import pathlib

from .programs import Page, ProgramError, call, find_program
from .runs import Analysis, Run, Runs, read_analysis, read_run, read_runs

__all__ = ["Page", "ProgramError", "analyze", "find_program", "run", "show"]


def run(experiment: str | os.PathLike = "paper", *, out: str | os.PathLike, backend: str | None = None, rules: str | None = None,
        set: dict | None = None, duration: float | None = None, robots: int | None = None, seed: int | None = None,
        replicates: int | None = None, shadow: bool = False, jobs: int | None = None, threads: int | None = None,
        options: list[str] | None = None) -> Run | Runs:
    """Runs an experiment into the new folder `out` and reads it: a Run or, of `replicates`, Runs.

    `experiment` is a rule table of trophic-predator-prey (paper, released) or the path of any experiment program, whose table `rules`
    names. `set` has parameters by their paths, {"rules.mutation.sd": 0.1}. `options` are further arguments of the program. Raises
    ProgramError with the program's sentence if it refuses or fails, and before it starts if `out` exists.
    """
    is_path = os.sep in str(experiment) or pathlib.Path(experiment).is_file()
    program = str(pathlib.Path(experiment).resolve()) if is_path else find_program("trophic-predator-prey")
    arguments: list = []
    named = {"--rules": rules if is_path else str(experiment), "--backend": backend, "--duration": duration, "--robots": robots, "--seed": seed,
             "--replicates": replicates, "--jobs": jobs, "--threads": threads}
    for option, value in named.items():
        if value is not None:
            arguments += [option, value]
    for path, value in (set or {}).items():
        arguments += ["--set", f"{path}={str(value).lower() if isinstance(value, bool) else value}"]
    if shadow:
        arguments.append("--shadow")
    if pathlib.Path(out).exists():
        raise ProgramError(f"out={out}: exists already; nothing is overwritten")
    call(program, [*arguments, *(options or []), "--out", out], f"{program} into {out}")
    return read_run(out) if replicates is None else read_runs(out)


def analyze(runs: Run | Runs | str | os.PathLike, *, out: str | os.PathLike, options: list[str] | None = None) -> Analysis:
    """`trophic analyze` of a run or replicates into the new folder `out`, read. `options`: further arguments, ["--metric", "deaths"]."""
    if pathlib.Path(out).exists():
        raise ProgramError(f"out={out}: exists already; nothing is overwritten")
    call(find_program("trophic"), ["analyze", getattr(runs, "path", runs), *(options or []), "--out", out], "trophic analyze")
    return read_analysis(out)


def show(run: Run, out: str | os.PathLike | None = None) -> Page:
    """A page of a recorded run, in `out` or in a temporary file."""
    return run.show(out)
