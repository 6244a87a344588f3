# SPDX-License-Identifier: MIT
"""Follows a document's instructions in a folder, block after block. <!-- file NAME --> and <!-- append NAME --> write the block to a
file. A sh block is run; a python block is run if <!-- run --> precedes it. <!-- skipped: why --> omits a block."""

import os
import pathlib
import subprocess
import sys

from documents import parse

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from figures_python import PYTHON  # noqa: E402


def follow(
    path: pathlib.Path, folder: pathlib.Path, environment: dict[str, str], shorter: dict[str, str] | None = None
) -> None:
    """Raises SystemExit at the first command that fails. `shorter`: texts of the document that others replace."""
    for block in parse(path).blocks:
        for long, short in (shorter or {}).items():
            block.code = block.code.replace(long, short)
        key, name = block.note
        if key in ("file", "append"):
            with open(folder / name, "a" if key == "append" else "w") as file:
                file.write(block.code)
            continue
        if key == "skipped":
            continue
        command = None
        if block.language == "sh":
            command = ["bash", "-euo", "pipefail", "-c", block.code]
        elif block.language == "python" and key == "run" and PYTHON:
            command = [PYTHON, "-c", block.code]
        if command:
            done = subprocess.run(
                command, cwd=folder, env={**os.environ, **environment}, capture_output=True, text=True
            )
            if done.returncode != 0:
                raise SystemExit(
                    f"{path.name}:{block.line}: exit code {done.returncode}\n{block.code}\n{done.stdout}{done.stderr}"
                )
