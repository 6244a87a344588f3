#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_cases.py COMPILE_COMMANDS.json --family g++|clang++ CASE.cpp...: this compiler prints exactly one error for each case, with the
sentence that the case expects. With --valid instead, all cases compile with -DVALID, so that only the mistake stops them. The cases are compiled
together, each in its own namespace. A case with a line "// alone" is compiled alone, because the includes of others would fix its mistake.
Exit code 77: this compiler is not installed."""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from compile_command import compile_command  # noqa: E402

NOT_INSTALLED = 77
EVERY_ERROR = {
    "g++": ["-fmax-errors=0", "-ftemplate-backtrace-limit=0"],
    "clang++": ["-ferror-limit=0", "-ftemplate-backtrace-limit=0", "-fno-caret-diagnostics"],
}


def family_of(compiler: str) -> str:
    version = subprocess.run([compiler, "--version"], text=True, capture_output=True, check=True).stdout
    return "clang++" if "clang" in version else "g++"


def includes(case: pathlib.Path, valid: bool) -> list[str]:
    """The includes of a case; those between #ifdef VALID and #endif only if it is valid."""
    found, only_valid = [], False
    for line in case.read_text().splitlines():
        only_valid = line.startswith("#ifdef VALID") or (only_valid and not line.startswith(("#endif", "#else")))
        if line.startswith("#include") and (valid or not only_valid):
            found.append(line)
    return found


def together(cases: list[pathlib.Path], valid: bool) -> str:
    """Each case in a namespace of its own, behind what any of them includes."""
    lines = sorted({line for case in cases for line in includes(case, valid)})
    lines += ["#define VALID"] if valid else []
    lines.append('#pragma GCC diagnostic ignored "-Wreturn-type"')  # a main in a namespace returns nothing by itself
    for case in cases:
        lines += [f"namespace {case.stem} {{", f'#include "{case}"', "}"]
    return "\n".join(lines) + "\n"


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


def errors_by_case(output: str, family: str, names: list[str]) -> dict[str, list[str]]:
    """Each error, with what the compiler says behind it, under the case that it is about; under "" where it names none. g++ says before an
    error where a template was instantiated, clang++ behind it."""
    named = re.compile(r"\b(" + "|".join(names) + r")(?:\.cpp\b|::)")
    lines = output.splitlines()
    starts = [i for i, line in enumerate(lines) if re.search(r"\berror: ", line)]
    errors: dict[str, list[str]] = {}
    for start, end in zip(starts, [*starts[1:], len(lines)]):
        where = lines[start:end] if family == "clang++" else reversed(lines[: start + 1])
        case = next((name[1] for line in where if (name := named.search(line))), "")
        errors.setdefault(case, []).append("\n".join(lines[start:end]))
    return errors


def complaints(cases: list[pathlib.Path], errors: dict[str, list[str]]) -> list[str]:
    """Cases without exactly one error with the expected sentence."""
    found = [f"an error names no case:\n{error}" for error in errors.get("", [])]
    for case in cases:
        expected = [line.split("// expect: ", 1)[1].strip() for line in case.read_text().splitlines() if line.startswith("// expect: ")]
        own = errors.get(case.stem, [])
        if not expected:
            found.append(f"{case} has no line '// expect: SENTENCE'")
        if not own:
            found.append(f"{case} compiles, although it must not")
        if len(own) > 1:
            found.append(f"{case} gives {len(own)} errors for one mistake:\n" + "\n".join(own))
        found += [f"{case} does not say: {sentence}\nbut:\n" + "\n".join(own) for sentence in expected if sentence not in "\n".join(own)]
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("database")
    parser.add_argument("cases", nargs="+", type=pathlib.Path)
    how = parser.add_mutually_exclusive_group(required=True)
    how.add_argument("--family", choices=EVERY_ERROR)
    how.add_argument("--valid", action="store_true")
    options = parser.parse_args()
    command, directory = compile_command(options.database, options.cases[0])
    own = family_of(command[0])
    family = options.family or own
    compiler = command[0] if family == own else family
    if not shutil.which(compiler):
        print(f"{compiler} is not installed")
        return NOT_INSTALLED
    command = [compiler, *command[1:], *EVERY_ERROR[family]]
    if options.valid:
        valid = compiled(together(options.cases, valid=True), command, directory)
        print(valid.stdout, end="")
        return valid.returncode
    alone = [case for case in options.cases if "// alone" in case.read_text().splitlines()]
    batches = [[case] for case in alone] + [[case for case in options.cases if case not in alone]]
    said = "".join(compiled(together(batch, valid=False), command, directory).stdout for batch in batches)
    found = complaints(options.cases, errors_by_case(said, family, [case.stem for case in options.cases]))
    print(*found, sep="\n\n")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
