#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_case.py COMPILE_COMMANDS.json PRELUDE_FOLDER CASE.cpp: the build's compiler and, where it is installed, the other of g++ and
clang++ give exactly one error, and say what the case expects. With --compile-prelude HEADER the header is compiled for each compiler into
the folder instead, with the flags of the case; every case then starts from it. With --valid CASE.cpp... these cases compile with -DVALID,
all in one go, so that the mistake is what stops them."""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from compile_command import compile_command  # noqa: E402


def family(compiler: str) -> str:
    version = subprocess.run([compiler, "--version"], text=True, capture_output=True, check=True).stdout
    return "clang++" if "clang" in version else "g++"


def compilers(own: str) -> dict[str, str]:
    """The build's compiler first, then the other family's where it is installed: family to command."""
    found = {family(own): own}
    for name in ("g++", "clang++"):
        if name not in found and shutil.which(name):
            found[name] = name
    return found


def with_prelude(kind: str, folder: pathlib.Path) -> list[str]:
    return ["-include-pch", str(folder / "clang++.pch")] if kind == "clang++" else ["-include", str(folder / "g++.hpp")]


def compile_prelude(header: str, folder: pathlib.Path, command: list[str], directory: str) -> int:
    folder.mkdir(exist_ok=True)
    flags = [flag for flag in command[1:] if flag != "-fsyntax-only"]
    running = []
    for kind, compiler in compilers(command[0]).items():
        compiled = folder / ("clang++.pch" if kind == "clang++" else "g++.hpp.gch")
        running.append(subprocess.Popen([compiler, *flags, "-x", "c++-header", header, "-o", str(compiled)], cwd=directory))
    return int(any([one.wait() != 0 for one in running]))


def compile_valid(cases: list[pathlib.Path], folder: pathlib.Path, command: list[str], directory: str) -> int:
    """Each case in a namespace of its own: what it includes stands before all of them."""
    includes = sorted({line for case in cases for line in case.read_text().splitlines() if line.startswith("#include")})
    # A main in a namespace returns nothing by itself.
    lines = [*includes, "#define VALID", '#pragma GCC diagnostic ignored "-Wreturn-type"']
    for case in cases:
        lines += [f"namespace {case.stem} {{", f'#include "{case}"', "}"]
    together = [*command, *with_prelude(family(command[0]), folder), "-x", "c++", "-"]
    done = subprocess.run(together, cwd=directory, input="\n".join(lines) + "\n", text=True)
    if done.returncode != 0:
        print("a case that does not compile with -DVALID is stopped by something else than its mistake")
    return done.returncode


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("database")
    parser.add_argument("prelude_folder", type=pathlib.Path)
    parser.add_argument("case")
    parser.add_argument("--compile-prelude", metavar="HEADER")
    parser.add_argument("--valid", metavar="CASE", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    command, directory = compile_command(options.database, options.case)
    if options.compile_prelude:
        return compile_prelude(options.compile_prelude, options.prelude_folder, command, directory)
    if options.valid:
        return compile_valid(options.valid, options.prelude_folder, command, directory)
    lines = pathlib.Path(options.case).read_text().splitlines()
    expected = [line.split("// expect: ", 1)[1].strip() for line in lines if line.startswith("// expect: ")]
    if not expected:
        sys.exit(f"{options.case} has no line '// expect: SENTENCE'")

    def compiled(kind: str, compiler: str) -> subprocess.CompletedProcess:
        return subprocess.run(
            [compiler, *command[1:], *with_prelude(kind, options.prelude_folder), options.case],
            cwd=directory,
            env=os.environ | {"LC_ALL": "C"},
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )

    for kind, compiler in compilers(command[0]).items():
        invalid = compiled(kind, compiler)
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
