#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""how_to_test.py ROOT PROGRAMS: the robot, arena, sweep and Python of the how-tos work as written; CMake compiles their C++."""

import os
import pathlib
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
        for document in ("read-in-pandas", "a-null-for-my-metric", "a-living-world"):
            for block in parse(ROOT / f"docs/how-to/{document}.md").blocks:
                if block.language == "python" and PYTHON:
                    run(PYTHON, "-c", block.code)
    return 0


def gait_of_three_legs(folder: pathlib.Path) -> str:
    """The gait that my-body.md evolves takes a minute; any one with its hinges shows that the robot is accepted."""
    (folder / "tripod_gait.toml").write_text(
        'name = "tripod_gait"\nrobot = "tripod"\nhinges = ["back", "left", "right"]\ninternal = [0.5, 0.5, 0.5]\n'
    )
    return "tripod_gait.toml"


if __name__ == "__main__":
    sys.exit(main())
