#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""how_to_test.py ROOT PROGRAMS MY_EXPERIMENT: the how-tos hold what they promise, at their printed length or a shorter one: an arena in which prey
are caught, a robot that walks ahead, a sweep that compares, a metric of one's own first on the screen, and the commands of the first research questions
with six replicates. CMake compiles their C++. MY_EXPERIMENT is the program of my-program.md."""

import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from documents import parse
from follow import PYTHON, follow

ROOT, PROGRAMS = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


def blocks(document: str, language: str) -> list[str]:
    return [block.code for block in parse(ROOT / f"docs/how-to/{document}.md").blocks if block.language == language]


def rows(path: pathlib.Path) -> list[dict[str, str]]:
    with open(path) as file:
        return list(csv.DictReader(file))


def main() -> int:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = {"PATH": f"{PROGRAMS}:{os.environ['PATH']}"}

        def run(*command: str) -> subprocess.CompletedProcess:
            done = subprocess.run(
                command, cwd=folder, capture_output=True, text=True, env={**os.environ, **path}, shell=len(command) == 1
            )
            assert done.returncode == 0, f"{command}: {done.stderr}"
            return done

        arena(folder, run)
        body(folder, run)
        ecology = ["trophic-predator-prey", "--backend", "kinematic"]
        run(*ecology, "--duration", "600", "--out", "runs/first-1")
        run(*ecology, "--duration", "60", "--senses", "--out", "runs/senses")
        run(*ecology, "--duration", "200", "--replicates", "6", "--shadow", "--out", "runs/paper")
        metric(folder, run)
        follow(ROOT / "docs/how-to/a-living-world.md", folder, path)
        for file in ("pond.html", "pond/figures/numbers.png", "pond/figures/energy.png"):
            assert (folder / file).stat().st_size > 10_000, file
        assert float(rows(folder / "pond/agents.csv")[-1]["energy_J"]) > 0.0
        follow(ROOT / "docs/how-to/a-sweep.md", folder, path, {"duration_s = 3000.0": "duration_s = 300.0"})
        tested = {row["cell"] for row in rows(folder / "analysis/reach/sweep_differences.csv") if row["p_holm"]}
        assert tested == {"1", "2", "3"}, f"a-sweep.md: cells that were compared: {tested}"
        (tables,) = blocks("from-runs-to-results", "toml")
        assert "ecology.duration_s = 6000.0" in tables and "replicates = 10" in tables
        (folder / "tables.toml").write_text(
            tables.replace("6000.0", "100.0").replace("replicates = 10", "replicates = 2")
        )
        run("trophic", "plan", "tables.toml", "--out", "runs/tables")
        run(ecology[0], "--plan", "runs/tables/plan.jsonl")
        run(
            "trophic",
            "analyze",
            "runs/tables",
            "--metric",
            "velocity:predator",
            "attribution_caught",
            "--out",
            "analysis/tables",
        )
        first_questions()
        for document in ("read-in-pandas", "a-null-for-my-metric", "a-living-world"):
            for code in blocks(document, "python"):
                if PYTHON:
                    run(PYTHON, "-c", code)
    return 0


def first_questions() -> None:
    """Every command of the page with six replicates, without the pond of 600 s: the pilot states how many runs it needs, and a long reach costs
    the pond its predators."""
    programs = {name: str(PROGRAMS / name) for name in ("trophic", "trophic-predator-prey", "trophic-worlds")}
    programs["my_experiment"] = str(pathlib.Path(sys.argv[3]).resolve())
    said, commands = "", 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for block in parse(ROOT / "docs/first-questions.md").blocks:
            if block.language == "toml":
                short = re.sub(r"replicates = \d+", "replicates = 6", block.code)
                if block.note[1] != "reach.toml":
                    short = re.sub(r"\[set\]\n.*\n", "", short) + "\n[set]\necology.duration_s = 600.0\n"
                (folder / block.note[1]).write_text(short)
            for line in block.code.splitlines() if block.language == "text" else []:
                words = [programs.get(word, word) for word in line.split()]
                done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
                assert done.returncode == 0, f"{line}: {done.stderr}"
                said, commands = said + done.stdout, commands + 1
        assert commands == 11, commands
        assert re.search(r"needs \d+ replicates a cell", said), said
        with open(folder / "analysis/reach/sweep_metrics.csv") as file:
            rows = [row for row in csv.DictReader(file) if (row["metric"], row["species"]) == ("persists", "predator")]
        assert float(rows[0]["mean"]) == 1.0 and float(rows[2]["mean"]) < 1.0, rows


def arena(folder: pathlib.Path, run) -> None:
    """Prey are caught in the arena, with its obstacles too; with the paper's floor and minimum none is, and the program remarks on it before the run."""
    (command,) = blocks("my-arena", "text")
    tables = blocks("my-arena", "toml")
    for number, text in enumerate((tables[0], "".join(tables))):
        (folder / "pit.toml").write_text(text)
        done = run(f"{command.strip()} --out runs/pit-{number}")
        caught = [row for row in rows(folder / f"runs/pit-{number}/events.csv") if row["event"] == "capture"]
        assert len(caught) > 30 and "remark  rules.floor" not in done.stderr, f"my-arena.md: {len(caught)} catches"
    crowded = re.sub(r" --set rules\.(floor|minimum_predators)\S+", "", command.strip())
    done = run(f"{crowded} --out runs/idle")
    assert "none is left to be caught" in done.stderr, done.stderr
    assert not [row for row in rows(folder / "runs/idle/events.csv") if row["event"] == "capture"]


def body(folder: pathlib.Path, run) -> None:
    """The robot walks ahead after a tenth of its evolution, and an ecology accepts it."""
    (robot,) = blocks("my-body", "toml")
    (folder / "strider.toml").write_text(robot)
    evolve, measure, _, ecology = blocks("my-body", "text")[0].strip().splitlines()
    run(f"{evolve} --generations 2")
    measured = run(f"{measure} --duration 20")
    ahead = [float(row["forward_m_s"]) for row in csv.DictReader(measured.stdout.splitlines())]
    assert len(ahead) == 3 and min(ahead) > 0.003 and not measured.stderr, f"my-body.md: {ahead} m/s\n{measured.stderr}"
    run(ecology.replace("--duration 600", "--duration 4 --out runs/own"))


def metric(folder: pathlib.Path, run) -> None:
    """A metric of one's own is the first that a reader sees."""
    if not PYTHON:
        return
    (folder / "metrics.py").write_text(blocks("my-metric", "python")[0])
    first, second = run(blocks("my-metric", "text")[0].splitlines()[0]).stdout.splitlines()[:2]
    assert first.split()[0] == "yours" and second.split()[0] == "from_centre", f"my-metric.md: {first}\n{second}"


if __name__ == "__main__":
    sys.exit(main())
