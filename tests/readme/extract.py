#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""extract.py README.md FOLDER: writes each cpp block to FOLDER, as NN_program.cpp if it has a main, otherwise as NN_part.cpp (it
compiles alone), and each diff block as the program above it with the change applied."""

import pathlib
import re
import sys

LANGUAGES = {"cpp", "diff", "sh", "python", "toml", "text", "bibtex"}


def code_blocks(text: str) -> list[tuple[str, str]]:
    blocks = re.findall(r"^```(\S*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    for language, code in blocks:
        if language not in LANGUAGES:
            sys.exit(f"README: a block is marked '{language}', must be one of {sorted(LANGUAGES)}:\n{code}")
    return blocks


def changed(program: str, diff: str) -> str:
    """Applies a diff with hunks separated by lines that start with @@; the old lines of each must occur in the program once."""
    for hunk in re.split(r"^@@.*\n", diff, flags=re.MULTILINE):
        lines = hunk.splitlines(keepends=True)
        old = "".join(line[1:] for line in lines if line[0] in " -")
        new = "".join(line[1:] for line in lines if line[0] in " +")
        if lines and program.count(old) != 1:
            sys.exit(f"README: these lines of a diff must occur exactly once in the program above it:\n{old}")
        program = program.replace(old, new)
    return program


def main() -> None:
    readme, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    wanted: dict[str, str] = {}
    program = ""
    for language, code in code_blocks(readme.read_text()):
        if language == "diff":
            if not program:
                sys.exit(f"README: no program above this diff:\n{code}")
            wanted[f"{len(wanted) + 1:02}_changed_program.cpp"] = changed(program, code)
        elif language == "cpp" and re.search(r"^int main\(", code, re.MULTILINE):
            program = code
            wanted[f"{len(wanted) + 1:02}_program.cpp"] = code
        elif language == "cpp":
            wanted[f"{len(wanted) + 1:02}_part.cpp"] = code
    folder.mkdir(parents=True, exist_ok=True)
    for stale in set(folder.glob("*.cpp")) - {folder / name for name in wanted}:
        stale.unlink()
    for name, code in wanted.items():
        path = folder / name
        if not path.exists() or path.read_text() != code:
            path.write_text(code)


if __name__ == "__main__":
    main()
