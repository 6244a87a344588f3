# SPDX-License-Identifier: MIT
"""Starts trophic's programs, which contain the rules, and analyses their output."""
from __future__ import annotations

import os
import pathlib
import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .errors import ProgramError
from .plan import cells_of, make_plan, read_sweep, settings_of_table, sweep_of
from .programs import Page, call, find_program, program_named, program_of_table
from .progress import is_watched
from .runs import Analysis, Run, Runs, read_run, read_runs, read_study
from .sweeps.grid import PLAN

__all__ = ["Page", "ProgramError", "analyze", "find_program", "run", "show", "sweep"]


def run(
    table: str | None = "paper",
    *,
    out: str | os.PathLike,
    backend: str | None = None,
    duration: float | None = None,
    seed: int | None = None,
    params: Mapping[str, Any] | None = None,
    robots: int | None = None,
    replicates: int | None = None,
    shadow: bool = False,
    neutral: bool = False,
    one_sided: bool = False,
    jobs: int | None = None,
    threads: int | None = None,
    program: str | os.PathLike | None = None,
    options: Sequence[str] = (),
    resume: bool = False,
    progress: bool | None = None,
) -> Run | Runs:
    """Runs an ecology, writes it to the new folder `out` and reads it: a Run or, with `replicates`, Runs.

    `table` is a rule table that trophic ships (paper, released, pond, ...) or one of `program`, the path or name of an experiment program; None is
    its first. `backend`: kinematic, torus, mujoco or ode (default: the table's). `duration`: simulated seconds. `params` maps paths of parameters to
    values in the units of `--print-config`, flat or nested: {"rules.mutation.sd": 0.1} or {"rules": {"mutation": {"sd": 0.1}}}. `robots`: number of
    bodies. `shadow`, `neutral` and `one_sided` also run these nulls. `jobs`: replicates in parallel; `threads`: of the physics. `options` are further
    arguments of the program. `progress` shows how far it is (default: on a terminal and in a notebook), by tqdm if it is installed.

    A program does it, whose remarks go to standard error. Raises ProgramError with the program's message if it refuses or fails, and before it starts
    if `out` exists. An interrupt stops it after a tick, with a checkpoint; `resume` continues that.
    """
    arguments: list[Any] = []
    named = {
        "--rules": table,
        "--backend": backend,
        "--duration": duration,
        "--seed": seed,
        "--robots": robots,
        "--replicates": replicates,
        "--jobs": jobs,
        "--threads": threads,
    }
    for option, value in named.items():
        if value is not None:
            arguments += [option, value]
    for path, value in settings_of_table(params or {}).items():
        arguments += ["--set", f"{path}={str(value).lower() if isinstance(value, bool) else value}"]
    arguments += [
        option
        for option, is_on in (
            ("--shadow", shadow),
            ("--neutral", neutral),
            ("--one-sided", one_sided),
            ("--resume", resume),
        )
        if is_on
    ]
    if pathlib.Path(out).exists() and not resume:
        raise ProgramError(f"out={out}: exists already; files are never overwritten")
    _make(_program(program, table), [*arguments, *options, "--out", out], str(out), progress)
    return read_run(out) if replicates is None else read_runs(out)


def sweep(
    of: str | os.PathLike | Mapping[str, Any],
    *,
    out: str | os.PathLike,
    program: str | os.PathLike | None = None,
    jobs: int | None = None,
    progress: bool | None = None,
) -> dict[str, Runs]:
    """Makes the runs of a sweep in the folder `out`, or those that it lacks, and reads them: Runs by the name of the cell.

    `of` is a sweep file (docs/how-to/a-sweep.md) or a dictionary with its keys: {"rule_table": "paper", "replicates": 10, "grid":
    {"rules.mutation.sd": [0.05, 0.2]}}. `program`, `jobs` and `progress` as in `run`; the program is chosen by the first table. `analyze_sweep(out)` compares the cells.
    Raises RunError for a wrong sweep, before any run, and for a folder with another plan; ProgramError if the program fails.
    """
    asked = sweep_of(of) if isinstance(of, Mapping) else read_sweep(of)
    makes = _program(program, next((str(cell["rule_table"]) for cell in cells_of(asked) if "rule_table" in cell), None))
    make_plan(asked, makes, pathlib.Path(out))
    _make(makes, ["--plan", pathlib.Path(out) / PLAN, *(["--jobs", jobs] if jobs else [])], str(out), progress)
    return read_study(out)


def _program(named: str | os.PathLike | None, table: str | None) -> str:
    """The program of that name or path or, without one, the shipped one that has the table."""
    return program_of_table(table) if named is None else program_named(named)


def _make(program: str, arguments: list, what: str, progress: bool | None) -> None:
    remarks = call(program, arguments, what, progress=is_watched(progress))
    print(remarks, end="", file=sys.stderr)


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


def show(run: Run | str | os.PathLike, out: str | os.PathLike | None = None) -> Page:
    """Makes a page of a recorded run or of one in a folder, in `out` or in a temporary file. A notebook displays it; `open()` opens a browser."""
    return (run if isinstance(run, Run) else read_run(run)).show(out)
