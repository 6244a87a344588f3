#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""interrupted_test.py PREDATOR_PREY TROPHIC [BODIES] [--times N] [--only NAME]: each command that writes is killed, stopped or refused space
at N random moments (1). A file that then has its final name is complete, and the same command makes the same bytes as without an interruption.
scripts/kill-and-resume has 20 of each."""

import argparse
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from in_folder import planned

PARSER = argparse.ArgumentParser()
PARSER.add_argument("programs", nargs="+", type=os.path.realpath)
PARSER.add_argument("--times", type=int, default=1)
PARSER.add_argument("--only", default="")
OPTIONS = PARSER.parse_args()
PREDATOR_PREY, TROPHIC, *BODIES = OPTIONS.programs
KINEMATIC = (PREDATOR_PREY, "--backend", "kinematic", "--duration", "4000")
SWEEP = 'engine = "kinematic"\nreplicates = 2\n[set]\necology.duration_s = 3000.0\n[grid]\nrules.mutation.sd = [0.05, 0.1]\n'
EVOLVE = (TROPHIC, "evolve-gait", "--generations", "3", *(part for name in ("plan.population", "plan.parents", "plan.children") for part in ("--set", f"{name}=4")),
          "--set", "trial.duration_s=6")  # fmt: skip
# Commands without --out, and how their results are named; those with --resume say so when they begin, too.
COMMANDS = {
    "run": ((*KINEMATIC, "--resume"), ""), "set": ((*KINEMATIC, "--replicates", "2", "--shadow", "--one-sided", "--resume"), ""),
    "branch": ((PREDATOR_PREY, "--from", "set/replicate-00", "--at", "200", "--seed", "9", "--duration", "4000", "--resume"), ""),
    "neutral": ((*KINEMATIC, "--replicates", "2", "--neutral", "--resume"), ""),
    "analyze": ((TROPHIC, "analyze", "set"), ""), "html": ((TROPHIC, "analyze", "set", "--html"), ".html"), "analyze-sweep": ((TROPHIC, "analyze", "grid"), ""), "page": ((TROPHIC, "show", "set"), ".html"), "plot": ((TROPHIC, "plot", "tables"), ""),
    "cross-check": ((TROPHIC, "cross-check", "set", "other"), ""), "contest": ((TROPHIC, "contest", "set", "--duration", "20", "--jobs", "1"), ""),
    "picture": ((TROPHIC, "film", "set/replicate-00", "--size", "320x180", "--from", "100"), ".png"), "export": ((TROPHIC, "export", "set/replicate-00"), ".glb"),
    "film": ((TROPHIC, "film", "set/replicate-00", "--size", "320x180", "--from", "100", "--to", "120", "--fps", "15"), ".gif"), "evolve-gait": (EVOLVE, ""),
}  # fmt: skip
if BODIES:
    COMMANDS |= {"bodies": ((BODIES[0], "--backend", "mujoco", "--robots", "6", "--set", "rules.community.predators=3", "--duration", "20", "--checkpoint-s", "4", "--resume"), "")}  # fmt: skip
THEIR_OWN = {
    "manifest.json",
    "checkpoint.bin",
    "checkpoint.old.bin",
    "replicates.json",
    "plan.jsonl",
    "sweep.json",
    "study.json",
    "captions.json",
}  # name times, hosts and continuations


def contents(out: pathlib.Path) -> dict[str, bytes]:
    files = (
        [out]
        if out.is_file()
        else sorted(path for path in out.rglob("*") if path.is_file() and path.name not in THEIR_OWN)
    )
    return {
        str(path.relative_to(out)): path.read_bytes()
        for path in files
        if path.suffix != ".pdf" and ".lock" not in path.name and ".incomplete-" not in str(path)
    }


def interrupt(command: list[str], folder: pathlib.Path, draw: random.Random, wall_s: float, largest: int) -> str:
    """Runs a command that is killed, stopped, or may write so many bytes to a file; what happened to it."""
    how = draw.choice(("SIGKILL", "SIGTERM", "refused"))
    most = draw.randrange(largest)
    limit = (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))) if how == "refused" else None
    program = subprocess.Popen(
        command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, preexec_fn=limit
    )
    try:
        said, _ = program.communicate(timeout=draw.uniform(0.0, wall_s) if how != "refused" else None)
    except subprocess.TimeoutExpired:
        program.send_signal(getattr(signal, how))
        said, _ = program.communicate()
    code = program.returncode
    allowed = {"SIGKILL": (0, -9), "SIGTERM": (0, 3, -15), "refused": (0, 1)}[how]
    assert code in allowed, f"{how}: exit {code}: {said[-2000:]}"
    return "done" if code == 0 else how


def check(name: str, folder: pathlib.Path, draw: random.Random) -> None:
    words, suffix = COMMANDS[name]
    out = folder / f"out{suffix}"
    command = [*words, *(() if words[-1] == "--html" else ("--out",)), out.name]
    began = time.monotonic()
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    wall_s, whole = time.monotonic() - began, contents(out)
    largest = max(map(len, whole.values())) + 1
    counts: dict[str, int] = {}
    is_new = True
    while sum(counts.values()) - counts.get("done", 0) < OPTIONS.times and counts.get("done", 0) < 3 * OPTIONS.times:
        if is_new:
            shutil.rmtree(out, ignore_errors=True) if out.is_dir() else out.unlink(missing_ok=True)
        happened = interrupt(command, folder, draw, wall_s, largest)
        counts[happened] = counts.get(happened, 0) + 1
        done = happened == "done" or out.exists() and "--resume" not in words and contents(out) == whole
        if done or draw.random() < 0.5:  # or it is interrupted once more
            again = None if done else subprocess.run(command, cwd=folder, capture_output=True, text=True)
            assert (
                done or again.returncode == 0
            ), f"{name} after {happened}: exit {again.returncode}: {again.stderr[-2000:]}"
            now = contents(out)
            assert (
                now == whole
            ), f"{name} after {happened}: differs in {[path for path in whole.keys() | now.keys() if whole.get(path) != now.get(path)]}"
            assert not list(
                folder.glob("out*.part*")
            ), f"{name} after {happened}: left {list(folder.glob('out*.part*'))}"
            is_new = True
        else:
            is_new = False
    print(f"{name}: {counts}", flush=True)


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "sweep.toml").write_text(SWEEP)
        for prepared in (
            [*KINEMATIC, "--replicates", "2", "--out", "set"],
            [*KINEMATIC, "--replicates", "2", "--seed", "2", "--out", "other"],
            planned(PREDATOR_PREY, "sweep.toml", "grid", folder),
            [TROPHIC, "analyze", "set", "--out", "tables"],
        ):
            subprocess.run(prepared, cwd=folder, check=True, capture_output=True)
        there = subprocess.run([TROPHIC, "--help"], capture_output=True, text=True, check=True).stdout
        for one, (words, _) in COMMANDS.items():
            if OPTIONS.only in one and (words[0] != TROPHIC or f"\n  {words[1]} " in there):
                check(one, folder, random.Random(f"{one} {OPTIONS.times}"))
                subprocess.run(["rm", "-rf", *folder.glob("out*")], check=True)


if __name__ == "__main__":
    sys.exit(main())
