#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""how_to_test.py ROOT PROGRAMS MY_EXPERIMENT: the robot, arena, sweep and Python of the how-tos work as written, and the commands of the first
research questions with six replicates; CMake compiles the C++. MY_EXPERIMENT is the program of my-program.md."""

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


def main() -> int:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def run(*command: str) -> str:
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
            assert done.returncode == 0, f"{command}: {done.stderr}"
            return done.stdout

        for document in ("my-body", "my-arena"):
            for block in parse(ROOT / f"docs/how-to/{document}.md").blocks:
                if block.language == "toml":
                    (folder / f"{block.code.split(chr(34))[1]}.toml").write_text(block.code)
        ecology = [str(PROGRAMS / "trophic-predator-prey"), "--backend", "kinematic"]
        few = ["--robots", "12", "--set", "rules.community.predators=5", "--duration", "20"]
        gait = ["--set", f"ecology.gait={gait_of_three_legs(folder)}"]
        run(*ecology, *few, "--robot", "tripod.toml", "--set", "ecology.arena=pit.toml", *gait, "--out", "runs/own")
        run(*ecology, "--duration", "600", "--out", "runs/first-1")
        run(*ecology, "--duration", "60", "--senses", "--out", "runs/senses")
        run(*ecology, "--duration", "200", "--replicates", "2", "--shadow", "--out", "runs/paper")
        follow(ROOT / "docs/how-to/a-living-world.md", folder, {"PATH": f"{PROGRAMS}:{os.environ['PATH']}"})
        follow(ROOT / "docs/how-to/a-sweep.md", folder, {"PATH": f"{PROGRAMS}:{os.environ['PATH']}"})
        tables = next(
            block.code
            for block in parse(ROOT / "docs/how-to/from-runs-to-results.md").blocks
            if block.language == "toml"
        )
        assert "ecology.duration_s = 6000.0" in tables and "replicates = 10" in tables
        (folder / "tables.toml").write_text(
            tables.replace("6000.0", "100.0").replace("replicates = 10", "replicates = 2")
        )
        run(str(PROGRAMS / "trophic"), "plan", "tables.toml", "--program", ecology[0], "--out", "runs/tables")
        run(ecology[0], "--plan", "runs/tables/plan.jsonl")
        run(
            str(PROGRAMS / "trophic"),
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
            for block in parse(ROOT / f"docs/how-to/{document}.md").blocks:
                if block.language == "python" and PYTHON:
                    run(PYTHON, "-c", block.code)
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


def gait_of_three_legs(folder: pathlib.Path) -> str:
    """The gait that my-body.md evolves takes a minute; any one with its hinges shows that the robot is accepted."""
    (folder / "tripod_gait.toml").write_text(
        'name = "tripod_gait"\nrobot = "tripod"\nhinges = ["back", "left", "right"]\ninternal = [0.5, 0.5, 0.5]\n'
    )
    return "tripod_gait.toml"


if __name__ == "__main__":
    sys.exit(main())
