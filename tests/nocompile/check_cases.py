#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_cases.py COMPILE_COMMANDS.json --family g++|clang++: this compiler prints exactly one error for each mistake of mistakes.toml, with
the sentence that it expects. With --valid instead, the programs in cases/ compile, so that only the mistake stops them. All are compiled
together, each in its own namespace. A mistake that says `alone` is compiled alone, because the includes of others would correct it.
Exit code 77: this compiler is not installed."""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))
from compile_command import compile_command  # noqa: E402

NOT_INSTALLED = 77
EVERY_ERROR = {
    "g++": ["-fmax-errors=0", "-ftemplate-backtrace-limit=0"],
    "clang++": ["-ferror-limit=0", "-ftemplate-backtrace-limit=0", "-fno-caret-diagnostics"],
}


def family_of(compiler: str) -> str:
    version = subprocess.run([compiler, "--version"], text=True, capture_output=True, check=True).stdout
    return "clang++" if "clang" in version else "g++"


def with_mistake(program: str, mistake: dict) -> str:
    if program.count(mistake["right"]) != 1:
        sys.exit(f"not once in its program: {mistake['right']}")
    return program.replace(mistake["right"], mistake["written"])


def together(sources: dict[str, str]) -> str:
    """Each source in a namespace of its own, behind what any of them includes."""
    include = re.compile(r"^#include .*\n", re.MULTILINE)
    lines = sorted({line for source in sources.values() for line in include.findall(source)})
    lines.append('#pragma GCC diagnostic ignored "-Wreturn-type"\n')  # a main in a namespace returns nothing by itself
    for name, source in sources.items():
        lines.append(f'namespace {name} {{\n#line 1 "{name}.cpp"\n{include.sub("", source)}}}\n')
    return "".join(lines)


def compiled(source: str, command: list[str], directory: str) -> subprocess.CompletedProcess:
    return subprocess.run(
        [*command, "-x", "c++", "-"],
        cwd=directory,
        env=os.environ | {"LC_ALL": "C"},
        input=source,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )


def errors_by_name(output: str, family: str, names: list[str]) -> dict[str, list[str]]:
    """Each error, with what the compiler says behind it, under the mistake that it is about; under "" where it names none. g++ says before an
    error where a template was instantiated, clang++ behind it."""
    named = re.compile(r"\b(" + "|".join(names) + r")(?:\.cpp\b|::)")
    lines = output.splitlines()
    starts = [i for i, line in enumerate(lines) if re.search(r"\berror: ", line)]
    errors: dict[str, list[str]] = {}
    for start, end in zip(starts, [*starts[1:], len(lines)]):
        where = lines[start:end] if family == "clang++" else reversed(lines[: start + 1])
        name = next((name[1] for line in where if (name := named.search(line))), "")
        errors.setdefault(name, []).append("\n".join(lines[start:end]))
    return errors


def complaints(mistakes: dict[str, dict], errors: dict[str, list[str]]) -> list[str]:
    """Mistakes without exactly one error with the expected sentence."""
    found = [f"an error names no mistake:\n{error}" for error in errors.get("", [])]
    for name, mistake in mistakes.items():
        own = errors.get(name, [])
        if not own:
            found.append(f"{name} compiles, although it must not")
        if len(own) > 1:
            found.append(f"{name} gives {len(own)} errors for one mistake:\n" + "\n".join(own))
        if mistake["says"] not in "\n".join(own):
            found.append(f"{name} does not say: {mistake['says']}\nbut:\n" + "\n".join(own))
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("database")
    how = parser.add_mutually_exclusive_group(required=True)
    how.add_argument("--family", choices=EVERY_ERROR)
    how.add_argument("--valid", action="store_true")
    options = parser.parse_args()
    programs = {path.stem: path.read_text() for path in sorted((HERE / "cases").glob("*.cpp"))}
    table = tomllib.loads((HERE / "mistakes.toml").read_text())
    if table.keys() != programs.keys():
        sys.exit(f"a program without a mistake, or a mistake without a program: {table.keys() ^ programs.keys()}")
    command, directory = compile_command(options.database, str(HERE / "cases/ecology.cpp"))
    own = family_of(command[0])
    family = options.family or own
    compiler = command[0] if family == own else family
    if not shutil.which(compiler):
        print(f"{compiler} is not installed")
        return NOT_INSTALLED
    command = [compiler, *command[1:], *EVERY_ERROR[family]]
    if options.valid:
        valid = compiled(together(programs), command, directory)
        print(valid.stdout, end="")
        return valid.returncode
    mistakes = {f"{program}_{name}": mistake for program, of_it in table.items() for name, mistake in of_it.items()}
    sources = {name: with_mistake(programs[name.split("_")[0]], mistake) for name, mistake in mistakes.items()}
    alone = {name for name, mistake in mistakes.items() if mistake.get("alone")}
    batches = [{name: sources[name]} for name in alone] + [
        {name: source for name, source in sources.items() if name not in alone}
    ]
    said = "".join(compiled(together(batch), command, directory).stdout for batch in batches)
    found = complaints(mistakes, errors_by_name(said, family, list(mistakes)))
    print(*found, sep="\n\n")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
