# SPDX-License-Identifier: MIT
"""How long analyses take, and how much memory: of ten runs of 6000 s with their shadows, and of a sweep of 50 such runs.

    python3 tests/bench/analysis.py PROGRAMS

PROGRAMS is the folder of trophic-predator-prey, trophic-plan and trophic-analyze. Processor time includes all processes."""
from __future__ import annotations

import os
import pathlib
import resource
import subprocess
import sys
import tempfile

SWEEP = """rule_table = "paper"
engine = "kinematic"
replicates = 10

[grid]
rules.mutation.sd = [0.02, 0.05, 0.1, 0.2, 0.4]
"""


def measure(what: str, *words: str | os.PathLike) -> None:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.Popen(list(map(str, words)), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, process.returncode, own = os.wait4(process.pid, 0)
    if process.returncode != 0:
        sys.exit(f"{what}: {words[0]} failed")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    took_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(
        f"{what:28} {took_s:6.2f} s of processor time, {own.ru_maxrss / 1024:5.0f} MB the largest process", flush=True
    )


def main(programs: pathlib.Path) -> None:
    run, plan, analyze = (programs / f"trophic-{name}" for name in ("predator-prey", "plan", "analyze"))
    with tempfile.TemporaryDirectory() as folder:
        room = pathlib.Path(folder)
        options = ("--backend", "kinematic", "--replay-hz", "0", "--replicates", "10", "--shadow")
        measure("ten runs and their shadows", run, *options, "--out", room / "set")
        measure("their analysis", analyze, room / "set", "--out", room / "analysis")
        (room / "sweep.toml").write_text(SWEEP)
        measure("plan of 50 runs", plan, room / "sweep.toml", "--out", room / "sweep")
        measure("50 runs", run, "--plan", room / "sweep" / "plan.jsonl")
        measure("their analysis", analyze, room / "sweep", "--out", room / "of-sweep")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
