#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scripts_test.py ROOT: each script that a page names runs in a short form. Tools that build or install are replaced by programs that record
their arguments; every file of the tree and every preset among these must exist."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from documents import all_documents

ROOT = pathlib.Path(sys.argv[1]).resolve()
SHORT = {"build-deb": "", "fuzz": "1 manifest", "hostile": "build/ci", "kill-and-resume": "1 build/ci", "quickstart": "", "run-tests": "", "setup": "g++",
         "soak": "120 6000", "compile-time": "--help", "mutation-check": "--list", "check-systems": "trixie"}  # fmt: skip
ELSEWHERE = {"architecture-picture", "pictures", "release", "size"}  # tests of their own, or pictures to look at
PROGRAMS = {f"ci/{name}": "echo mujoco" for name in ("examples/trophic-predator-prey", "tests/soak/soak", "tests/fuzz/fuzz_extremes", "tests/hostile/contraction")} | {
    "fuzz/fuzz": "echo stat::peak_rss_mb >&2", "quickstart/tools/first_run": "", "bin/dpkg-query": "echo installed", "bin/dpkg-parsechangelog": "echo 1.0-1",
    "bin/dpkg-buildpackage": "test -f debian/rules && : > ../trophic.deb", "bin/ctest": "mkdir -p build/ci build/sanitize build/threads build/clang"}  # fmt: skip
PRESETS = {preset["name"] for preset in json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]}


def commands_of(folder: pathlib.Path, name: str) -> str:
    """What a script runs in a tree of links, whose build folder has programs that do nothing."""
    for part in ROOT.iterdir():
        if not part.name.startswith("build"):
            (folder / part.name).symlink_to(part)
    for path, line in (
        {f"bin/{tool}": "" for tool in ("apt-get", "clang++", "cmake", "g++", "lintian", "python3", "sudo")} | PROGRAMS
    ).items():
        path = folder / "build" / path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f'#!/bin/sh\necho " {path.name} $* " >> {folder}/build/log\n{line}\n')
        path.chmod(0o755)
    script = folder / "scripts" / name
    path = (
        os.environ["PATH"]
        if "python3" in script.read_text().split("\n")[0]
        else f"{folder}/build/bin:{os.environ['PATH']}"
    )
    done = subprocess.run(
        [script, *SHORT[name].split()], cwd=folder, capture_output=True, text=True, env=os.environ | {"PATH": path}
    )
    assert (
        done.returncode == (name == "run-tests") and "unbound" not in done.stderr
    ), f"{name}: exit {done.returncode}: {done.stdout[-500:]}{done.stderr[-2000:]}"
    if name == "mutation-check":
        tests_include_their_headers(dict(re.findall(r"^(\S+?):\d+: .*\[(.+)\]$", done.stdout, re.MULTILINE)))
    return log.read_text().replace(f"{folder}/", "") if (log := folder / "build/log").exists() else ""


def tests_include_their_headers(tests: dict[str, str]) -> None:
    assert len(tests) > 60
    for header in ("trophic/control/brain/detail/network.hpp", "trophic/control/gait/inherited_cpg.hpp"):
        command = [
            "g++",
            "-std=c++20",
            "-MM",
            "-DTROPHIC_HEADER_ONLY=0",
            f"-I{ROOT}/include",
            f"-I{ROOT}/tests",
            *tests[header].split(),
        ]
        assert (
            f"include/{header}" in subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
        ), f"{tests[header]}: does not include {header}"


def main() -> None:
    named = {
        name
        for document in all_documents(ROOT)
        for name in re.findall(r"\bscripts/([a-z-]+)", document.path.read_text())
        if (ROOT / "scripts" / name).is_file()
    }
    assert (
        named == set(SHORT) | ELSEWHERE
    ), f"named by a page and not run here, or the reverse: {named ^ (set(SHORT) | ELSEWHERE)}"
    modes = subprocess.run(["git", "ls-files", "-s"], cwd=ROOT, capture_output=True, text=True).stdout
    assert all(
        (ROOT / name).read_bytes().startswith(b"#!") for name in re.findall(r"^100755 .*\t(.+)$", modes, re.MULTILINE)
    ), "executable without #!"
    for name in SHORT if (ROOT / ".git").exists() else set(SHORT) - {"build-deb"}:
        with tempfile.TemporaryDirectory() as folder:
            commands = commands_of(pathlib.Path(folder), name)
        lost = [
            file
            for file in re.findall(r" ((?:tests|tools|scripts|models|examples|packaging)/\S*\.\w+)", commands)
            if not (ROOT / file).exists()
        ]
        lost += sorted(set(re.findall(r" --preset (\w+)", commands)) - PRESETS)
        assert not lost, f"{name}: not there: {lost}"


if __name__ == "__main__":
    main()
