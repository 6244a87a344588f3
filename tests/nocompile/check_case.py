#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_case.py COMPILE_COMMANDS.json CASE.cpp: with -DVALID the case compiles; without, the build's compiler and, where it is
installed, the other of g++ and clang++ give exactly one error, and say what the case expects."""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

MEANING = ("-std=", "-D", "-I", "-isystem")  # of a compiler's flags, those that say what the source means


def compile_command(database: str, source: str) -> tuple[list[str], str]:
    """The build system's own command for the source: its compiler and the flags that give the source its meaning."""
    for entry in json.loads(pathlib.Path(database).read_text()):
        if os.path.samefile(os.path.join(entry["directory"], entry["file"]), source):
            words = shlex.split(entry["command"])
            compiler = next(word for word in words if "ccache" not in pathlib.Path(word).name)
            flags = [
                word
                for before, word in zip(words, words[1:])
                if word.startswith(MEANING) or before in ("-D", "-I", "-isystem")
            ]
            return [compiler, *flags, "-fsyntax-only"], entry["directory"]
    sys.exit(f"{source} is not in {database}")


def family(compiler: str) -> str:
    version = subprocess.run([compiler, "--version"], text=True, capture_output=True, check=True).stdout
    return "clang++" if "clang" in version else "g++"


def main() -> int:
    database, source = sys.argv[1:]
    lines = pathlib.Path(source).read_text().splitlines()
    expected = [line.split("// expect: ", 1)[1].strip() for line in lines if line.startswith("// expect: ")]
    if not expected:
        sys.exit(f"{source} has no line '// expect: SENTENCE'")
    command, directory = compile_command(database, source)

    def compiled(compiler: str, *flags: str) -> subprocess.CompletedProcess:
        return subprocess.run(
            [compiler, *command[1:], *flags, source],
            cwd=directory,
            env=os.environ | {"LC_ALL": "C"},
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )

    valid = compiled(command[0], "-DVALID")
    if valid.returncode != 0:
        print("does not compile with -DVALID, so the mistake is not what stops it:", valid.stdout, sep="\n")
        return 1
    own = family(command[0])
    others = [name for name in ("g++", "clang++") if name != own and shutil.which(name)]
    for compiler in [command[0], *others]:
        invalid = compiled(compiler)
        if invalid.returncode == 0:
            print(f"{compiler} compiles it, although it must not")
            return 1
        missing = [sentence for sentence in expected if sentence not in invalid.stdout]
        if missing:
            print(f"{compiler} fails to compile it without saying:", *missing, "\nbut with:", invalid.stdout, sep="\n")
            return 1
        errors = re.findall(r"^.*\berror: .*", invalid.stdout, re.MULTILINE)
        if len(errors) != 1:
            print(f"{compiler} gives {len(errors)} errors for one mistake:", *errors, sep="\n")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
