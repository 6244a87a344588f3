# SPDX-License-Identifier: MIT
"""Starts trophic's programs, which contain the rules, and analyses their output."""
from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Sequence
from typing import Any

from .errors import ProgramError
from .programs import Page, call, find_program
from .runs import Analysis, Run, Runs, read_run, read_runs

__all__ = ["Page", "ProgramError", "analyze", "find_program", "run", "show"]


def run(
    experiment: str | os.PathLike = "paper",
    *,
    out: str | os.PathLike,
    backend: str | None = None,
    rules: str | None = None,
    set: dict | None = None,
    duration: float | None = None,
    robots: int | None = None,
    seed: int | None = None,
    replicates: int | None = None,
    shadow: bool = False,
    neutral: bool = False,
    one_sided: bool = False,
    jobs: int | None = None,
    threads: int | None = None,
    options: list[str] | None = None,
) -> Run | Runs:
    """Runs an experiment, writes it to the new folder `out` and reads it: a Run or, with `replicates`, Runs.

    `experiment` is a rule table of trophic-predator-prey (paper, released) or the path of any experiment program, whose table `rules`
    names. `set` maps paths of parameters to values, {"rules.mutation.sd": 0.1}. `options` are further arguments of the program. Raises
    ProgramError with the program's message if it refuses or fails, and before it starts if `out` exists.
    """
    is_path = os.sep in str(experiment) or pathlib.Path(experiment).is_file()
    program = str(pathlib.Path(experiment).resolve()) if is_path else find_program("trophic-predator-prey")
    arguments: list = []
    named = {
        "--rules": rules if is_path else str(experiment),
        "--backend": backend,
        "--duration": duration,
        "--robots": robots,
        "--seed": seed,
        "--replicates": replicates,
        "--jobs": jobs,
        "--threads": threads,
    }
    for option, value in named.items():
        if value is not None:
            arguments += [option, value]
    for path, value in (set or {}).items():
        arguments += ["--set", f"{path}={str(value).lower() if isinstance(value, bool) else value}"]
    if shadow:
        arguments.append("--shadow")
    if neutral:
        arguments.append("--neutral")
    if one_sided:
        arguments.append("--one-sided")
    if pathlib.Path(out).exists():
        raise ProgramError(f"out={out}: exists already; files are never overwritten")
    call(program, [*arguments, *(options or []), "--out", out], f"{program} into {out}")
    return read_run(out) if replicates is None else read_runs(out)


def analyze(
    runs: Run | Runs | str | os.PathLike | Sequence,
    compare: Run | Runs | str | os.PathLike | None = None,
    *,
    out: str | os.PathLike | None = None,
    shadow: Runs | str | os.PathLike | None = None,
    until: float | None = None,
    metrics: Sequence[str | Callable[[Run], Any]] = (),
    columns: Sequence[str] = (),
    accept_other_build: bool = False,
    jobs: int | None = None,
) -> Analysis:
    """Measures runs, or two compared sets, and tests them, like `trophic analyze` but in this process.

    `out` is a new folder for the tables; without it the analysis is only in memory. `shadow`: folder of the neutral shadow (default:
    RUNS/shadow). `until`: measure only the first seconds of every run. `metrics`: choices such as "velocity:prey", and your own metrics,
    functions of a Run (`trophic.metric` names them and their units); without a choice all are tested. `columns`: your own metrics that are
    columns of tables, "FILE:COLUMN:UNIT". `jobs`: number of runs measured in parallel. Lineages and bodies need a program: `trophic analyze
    --lineages`, which `read_analysis` reads. Raises
    RunError, with a message that names it, for anything that cannot be analysed."""
    from .metrics import Measuring
    from .report import analyze as report
    from .writing import result_folder

    paths = [_path(each) for each in (runs if isinstance(runs, (list, tuple)) else [runs])]
    sets = [] if compare is None else [*paths, _path(compare)]
    its_shadow = None if shadow is None else _path(shadow)
    how = Measuring(
        until_s=until,
        accept_other_build=accept_other_build,
        columns=columns,
        functions=[each for each in metrics if callable(each)],
        metrics=[each for each in metrics if not callable(each)],
        jobs=jobs,
    )
    if out is None:
        return report.analyse(paths, sets, its_shadow, how).analysis(None)
    with result_folder(out) as folder:
        outcome = report.analyse(paths, sets, its_shadow, how)
        report.write_tables(folder, outcome)
    return outcome.analysis(pathlib.Path(out))


def _path(of: Any) -> str | os.PathLike:
    """The folder of a run or of runs, or the path itself."""
    return getattr(of, "path", of)


def show(run: Run, out: str | os.PathLike | None = None) -> Page:
    """Makes a page of a recorded run, in `out` or in a temporary file."""
    return run.show(out)
