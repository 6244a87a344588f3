#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""house.py ROOT CHECK: one house rule, checked on the source tree. Prints each offence; exit 0 kept, 1 broken, 77 not checkable."""

import functools
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(sys.argv[1])
CORE = ROOT / "include"
PARTS = ("backends", "tools")  # everything outside the core
SKIPPED = 77


def sources(*folders: str, suffixes: tuple[str, ...] = (".hpp", ".ipp", ".cpp")) -> list[pathlib.Path]:
    return sorted(path for folder in folders for path in (ROOT / folder).rglob("*") if path.suffix in suffixes)


def lines_with(pattern: str, files: list[pathlib.Path]) -> list[str]:
    found = re.compile(pattern)
    return [
        f"{path.relative_to(ROOT)}:{number}: {line.strip()}"
        for path in files
        for number, line in enumerate(path.read_text().splitlines(), 1)
        if found.search(line)
    ]


# Made by the installation.
INSTALLED = "trophic/habitat/load/installed_model_dir.hpp"


def library_alone():
    """The library includes no tool and no engine, under no condition: a header of trophic is in include/ or in the backend's own
    folder, and engines and their parsers are for backends alone. Studies, too, include only headers that are installed.
    """
    offences, engines = [], sorted(path.name for path in (ROOT / "backends").iterdir())
    for folder in ("include", "src", "studies", *(f"backends/{engine}" for engine in engines)):
        all_backends = (ROOT / "backends").glob("*/include")
        homes = [CORE, *(all_backends if folder in ("src", "studies") else [ROOT / folder / "include"])]
        for path in sources(folder):
            for name in re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)', path.read_text(), re.M):
                is_own = name.startswith(("trophic/", "tools/")) and name != INSTALLED
                is_engine = re.match(rf"({'|'.join(engines)})/|pugixml", name) and not folder.startswith("backends")
                if is_engine or is_own and not any((home / name).exists() for home in homes):
                    offences.append(f"{path.relative_to(ROOT)}: the library cannot include {name}")
    return offences


def rule_free_backends():
    """A backend knows bodies and arenas, never a rule of the ecology."""
    named = r"\b(predator|prey|starv\w*|hunger|(perception|reproduction|death|rules|analysis)(::|/[\w/]+\.hpp)|ecology\.hpp|population\.hpp)"
    return lines_with(named, [path for path in sources("backends") if "tests" not in path.parts])


def simulated_time_only():
    """No wall clock and no entropy outside the progress display and what only decides speed."""
    read = r"(system|steady|high_resolution)_clock|random_device|\bs?rand\(|\btime\((nullptr|NULL|0|&)|\bclock\(\)|clock_gettime|gettimeofday"
    allowed = {CORE / "trophic/observe/progress.hpp", CORE / "trophic/support/faster_mode.hpp"}
    return lines_with(read, [path for path in sources("include", "backends") if path not in allowed])


def header_length():
    """A header has at most 400 lines."""
    counted = [
        (path, len(path.read_text().splitlines()))
        for path in sources("include", *PARTS, "tests", suffixes=(".hpp", ".ipp"))
    ]
    return [f"{path.relative_to(ROOT)}: {lines} lines, must be <= 400" for path, lines in counted if lines > 400]


def header_start():
    """The licence comes first, then what the file is for; headers have #pragma once."""
    offences = []
    for path in sources("include", "src", *PARTS, "examples", "studies", "tests"):
        text = path.read_text()
        if not text.startswith("// SPDX-License-Identifier: MIT\n"):
            offences.append(f"{path.relative_to(ROOT)}: the first line must be // SPDX-License-Identifier: MIT")
        if path.suffix in (".hpp", ".ipp") and not re.match(r"//.*\n(//.*\n)+#pragma once\n", text):
            offences.append(f"{path.relative_to(ROOT)}: after the licence come a one-line summary and #pragma once")
    return offences


def policies_in_suites():
    """Each policy is named in tests/conformance/rules_test.cpp, but for rules made of parts and the slot Embodiment, which needs an engine."""
    named = set(re.findall(r"\w+", (ROOT / "tests/conformance/rules_test.cpp").read_text()))
    kinds = ("perception", "control", "reproduction", "death", "energy", "initialization")
    headers = [
        path
        for path in sources(*(f"include/trophic/{kind}" for kind in kinds), suffixes=(".hpp",))
        if path.parent.name != "embodiment"
    ]
    checked = [(path, path.read_text()) for path in headers if path.stem != "contract" and "detail" not in path.parts]
    policies = [
        (path, name)
        for path, text in checked
        if ": Parts<" not in text
        for name in re.findall(r"^static_assert\(\w+<(?:\w+::)*(\w+)", text, re.M)
    ]
    offences = [
        f"{path.relative_to(ROOT)}: {name} is in no suite of tests/conformance/rules_test.cpp"
        for path, name in policies
        if name not in named
    ]
    return offences or ([] if policies else ["no policies were found"])


def references() -> dict[str, str]:
    """Key -> entry of docs/references.bib."""
    entries = re.split(r"^@\w+\{", (ROOT / "docs/references.bib").read_text(), flags=re.MULTILINE)[1:]
    return {entry.split(",", 1)[0]: entry for entry in entries}


def sources_cited():
    """Every policy's `source`, and every citation of code and documents, names a section and equation of the paper or a key of
    references.bib; an entry has a DOI, an address or says that it has none."""
    entries = references()
    offences = [
        f"docs/references.bib: {key} needs a doi or a url"
        for key, text in entries.items()
        if not re.search(r"doi = |url = |no DOI", text)
    ]
    paper = entries["kachler2023"]
    sections = {" ".join(title.split()) for title in re.search(r"sections = \{([^}]*)\}", paper)[1].split(";")}
    equations = int(re.search(r"equations = \{(\d+)\}", paper)[1])
    own = r"control|released code|not in the paper|paper: silent|paper: no such rule"
    form = re.compile(rf'({own}|paper, Sec\. "[^"]*"(, Eq\. \d+)?)([;:].*)?')
    documents = [
        path
        for path in ROOT.rglob("*.md")
        if not any(part.startswith(("build", ".")) for part in path.relative_to(ROOT).parts)
    ]
    for path in [
        *sources("include", *PARTS, "examples", "studies", suffixes=(".hpp", ".ipp", ".cpp", ".py")),
        *documents,
    ]:
        name, text = path.relative_to(ROOT), path.read_text()
        for source in re.findall(r'string_view source =\s*"((?:[^"\\]|\\.)*)"', text):
            if not form.fullmatch(source.replace('\\"', '"')):
                offences.append(f'{name}: source "{source}" names neither a section of the paper nor one of: {own}')
        for title in re.findall(r'Sec\. \\?"([^"\\]*)\\?"', re.sub(r"\s*\n\s*(///?)? *", " ", text)):
            if title not in sections:
                offences.append(f'{name}: the paper has no section "{title}"')
        for number in re.findall(r"\bEq\. (\d+)", text):
            if not 1 <= int(number) <= equations:
                offences.append(f"{name}: the paper has no equation {number}")
        offences += [
            f"{name}: Eq. {label}: cite an equation by its number" for label in re.findall(r'Eq\. (\\?"\w+)', text)
        ]
        for key in re.findall(r"(?:\[|@)([a-z]+(?:1[89]|20)\d\d[a-z]?)\b", text):
            if key not in entries:
                offences.append(f"{name}: [{key}] is not in docs/references.bib")
    return offences


def pure_policies():
    """A policy remembers nothing by itself, reads no clock and draws from no engine but the stream that it is given."""
    kinds = [
        f"include/trophic/{kind}"
        for kind in ("perception", "control", "reproduction", "death", "energy", "initialization")
    ]
    impure = r"\bmutable\b|\bthread_local\b|^\s*static (?!constexpr|consteval|_assert|bool|auto|std::|double|void|State\b|Params\b)\w|#include <(random|chrono|ctime|thread|mutex|atomic|fstream|iostream)>|\bextern\b|\bvolatile\b"
    return lines_with(impure, sources(*kinds))


def reached_from(*names: str) -> set[pathlib.Path]:
    """The library's headers that these include, directly or not, in a program that compiles all definitions."""
    reached, waiting = set(), [CORE / name for name in names]
    while waiting:
        path = waiting.pop()
        if path not in reached and path.exists():
            reached.add(path)
            waiting += included_by(path)
    return reached


@functools.cache
def included_by(path: pathlib.Path) -> list[pathlib.Path]:
    text = re.sub(r"^#if !TROPHIC_HEADER_ONLY.*?^#endif", "", path.read_text(), flags=re.M | re.S)
    return [CORE / name for name in re.findall(r"#include <(trophic/[^>]+)>", text)]


def complete_umbrella():
    """trophic.hpp reaches every public header of the core, and names none that another one includes; the command line, which is
    compiled, and the worlds, tables that one includes, stand apart."""
    umbrella = "trophic/trophic.hpp"
    reached, named = reached_from(umbrella), re.findall(r"#include <(.+)>", (CORE / umbrella).read_text())
    missing = [
        path
        for path in sources("include")
        if path not in reached and not {"detail", "experiment", "experiment.hpp", "worlds"} & set(path.parts)
    ]
    twice = [name for name in named if CORE / name in reached_from(*(other for other in named if other != name))]
    return [f"{umbrella} lacks #include <{path.relative_to(CORE)}>" for path in missing] + [
        f"{umbrella}: another header includes {name}" for name in twice
    ]


def paths_exist():
    """Every source file that a comment, a message or a compile-time sentence names exists."""
    folders = ("include", "src", *PARTS, "examples", "studies", "tests")
    there = {part for path in sources(*folders) for part in ends_of(path.relative_to(ROOT))}
    return [
        f"{path.relative_to(ROOT)}:{number}: {name} does not exist"
        for path in sources(*folders)
        for number, line in enumerate(path.read_text().splitlines(), 1)
        if not re.match(r"\s*#\s*include", line)
        for name in re.findall(r"[\w/-]+\.[hi]pp\b", line)
        if name not in there | {INSTALLED} and name == name.lower()  # X.hpp is any
    ]


def ends_of(path: pathlib.PurePath) -> list[str]:
    """a/b/c -> a/b/c, b/c, c."""
    return ["/".join(path.parts[first:]) for first in range(len(path.parts))]


def formatted():
    """clang-format 14 (Debian 12) has nothing to change."""
    tool = shutil.which("clang-format-14") or shutil.which("clang-format")
    if not tool or " 14." not in subprocess.run([tool, "--version"], capture_output=True, text=True).stdout:
        print("clang-format 14 is not installed")
        sys.exit(SKIPPED)
    files = [str(path) for path in sources("include", "src", *PARTS, "examples", "studies", "tests")]
    done = subprocess.run([tool, "--dry-run", *files], capture_output=True, text=True, check=True)
    return sorted(
        {line.split(":")[0] + ": run clang-format -i on it" for line in done.stderr.splitlines() if "warning:" in line}
    )


def python_formatted():
    """black 23 (Debian 12) has nothing to change, in scripts without .py either; pyproject.toml has its settings."""
    tool = shutil.which("black")
    if not tool or not subprocess.run([tool, "--version"], capture_output=True, text=True).stdout.startswith(
        "black, 23."
    ):
        print("black 23 is not installed")
        sys.exit(SKIPPED)
    scripts = [
        path
        for folder in ("scripts", "studies")
        for path in sorted((ROOT / folder).glob("*"))
        if path.is_file() and not path.suffix
    ]
    scripts = [path for path in scripts if re.match(r"#!.*python", path.read_text())]
    done = subprocess.run([tool, "--check", "--fast", ROOT, *scripts], cwd=ROOT, capture_output=True, text=True)
    return [
        f"{line}: run black on it" for line in done.stderr.splitlines() if re.match("would reformat |error: ", line)
    ]


if __name__ == "__main__":
    broken = globals()[sys.argv[2]]()
    for offence in broken:
        print(offence)
    sys.exit(1 if broken else 0)
