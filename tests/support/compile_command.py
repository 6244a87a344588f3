# SPDX-License-Identifier: MIT
"""The build system's own command for a source, out of its compile_commands.json."""

import json
import os
import pathlib
import shlex
import sys

MEANING = ("-std=", "-D", "-I", "-isystem")  # of a compiler's flags, those that say what the source means


def compile_command(database: str, source: str) -> tuple[list[str], str]:
    """Compiler, flags that give the source its meaning, and that nothing is made; and the folder that they are for."""
    for entry in json.loads(pathlib.Path(database).read_text()):
        file = os.path.join(entry["directory"], entry["file"])
        if os.path.exists(file) and os.path.samefile(file, source):
            words = shlex.split(entry["command"])
            compiler = next(word for word in words if "++" in pathlib.Path(word).name)  # after a launcher
            flags = [
                word
                for before, word in zip(words, words[1:])
                if word.startswith(MEANING) or before in ("-D", "-I", "-isystem")
            ]
            return [compiler, *flags, "-fsyntax-only"], entry["directory"]
    sys.exit(f"{source} is not in {database}")
