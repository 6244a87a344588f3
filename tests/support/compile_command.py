#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The build system's own command for a source, out of its compile_commands.json.

compile_command.py DATABASE source...: each source compiles by it without a warning; nothing is made."""

import json
import os
import pathlib
import shlex
import subprocess
import sys

MEANING = ("-std=", "-D", "-I", "-isystem")  # of a compiler's flags, those that say what the source means


def compile_command(database: str, source: str, more: tuple[str, ...] = ()) -> tuple[list[str], str]:
    """Compiler, flags that give the source its meaning and those that begin like one of `more`, and that nothing is made; and the folder that
    they are for."""
    for entry in json.loads(pathlib.Path(database).read_text()):
        file = os.path.join(entry["directory"], entry["file"])
        if os.path.exists(file) and os.path.samefile(file, source):
            words = shlex.split(entry["command"])
            compiler = next(word for word in words if "++" in pathlib.Path(word).name)  # after a launcher
            flags = [
                word
                for before, word in zip(words, words[1:])
                if word.startswith((*MEANING, *more)) or before in ("-D", "-I", "-isystem")
            ]
            return [compiler, *flags, "-fsyntax-only"], entry["directory"]
    sys.exit(f"{source} is not in {database}")


def main() -> int:
    database, *sources = sys.argv[1:]
    commands = [(source, *compile_command(database, source, ("-W",))) for source in sources]
    return max(subprocess.run([*command, source], cwd=directory).returncode for source, command, directory in commands)


if __name__ == "__main__":
    sys.exit(main())
