#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""planted_lies_test.py ROOT PROGRAMS: check_documents.py finds each kind of error that is planted in a document of a copy of the tree."""

import collections
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT, PROGRAMS = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
CHECK = ROOT / "tests/docs/check_documents.py"
HOUSE = ROOT / "tests/static/house.py"

# check, document, text added at its end, text that the check must print
LIES = [
    ("names", "README.md", "See `tests/unit/no_such_test.cpp`.", "there is no 'tests/unit/no_such_test.cpp'"),
    ("names", "CONTRIBUTING.md", "The test `golden_that_never_was` holds it.", "nothing is called 'golden_that_never_was'"),
    ("names", "README.md", "It leaves `no_such_output.csv`.", "there is no 'no_such_output.csv'"),
    ("names", "studies/results/README.md", "<!-- former: normal_mutation -->", "'normal_mutation' is marked as a former name"),
    ("names", "README.md", "`include/trophic/death/<slot>/no_such.hpp` is it.", "there is no 'include/trophic/death/<slot>/no_such.hpp'"),
    ("links", "README.md", "[here](docs/no_such_page.md)", "which does not exist"),
    ("links", "README.md", "[here](studies/results/README.md#no-such-heading)", "no such heading"),
    ("links", "README.md", "![picture](docs/no_such.png)", "which does not exist"),
    ("commands", "README.md", "```sh\ntrophic-prey-predator --help\n```", "nothing is called 'trophic-prey-predator'"),
    ("commands", "README.md", "```sh\nscripts/no-such\n```", "there is no scripts/no-such"),
    ("commands", "README.md", "```sh\ncmake --preset no_such\n```", "no configure preset 'no_such'"),
    ("commands", "README.md", "```sh\ncmake --build --preset dev --target no_such_target\n```", "CMake has no target 'no_such_target'"),
    ("commands", "README.md", "```sh\ncmake --preset release -DTROPHIC_NO_SUCH=ON\n```", "CMake reads no 'TROPHIC_NO_SUCH'"),
    ("commands", "README.md", "```sh\nctest --preset dev -R 'no such test'\n```", "no test's name matches"),
    ("commands", "README.md", "```text\ntrophic evolve-gait --robott gecko\n```", "has no --robott"),
    ("commands", "README.md", "```text\ntrophic breed-gait\n```", "trophic has no command 'breed-gait'"),
    ("commands", "README.md", "```text\ntrophic-predator-prey --set no.such_key=3\n```", "refused"),
    ("commands", "README.md", "```text\ntrophic-predator-prey --set rules.mutation.sd=-1\n```", "refused"),
    ("commands", "README.md", "```text\ntrophic-predator-prey --rules no_such\n```", "refused"),
    ("commands", "README.md", "```text\ntrophic evolve-gait --robot models/robots/no_such.toml\n```", "there is no models/robots/no_such.toml"),
    ("commands", "README.md", "```sh\ntrophic plot --no-such x\n```", "has no --no-such"),
    ("commands", "README.md", "```text\nbuild/ci/tests/bench/bench_no_such\n```", "builds no 'bench_no_such'"),
    ("commands", "README.md", "The flag `--no-such-flag` does it.", "no program has --no-such-flag"),
    ("excerpts", "README.md", "<!-- from examples/01_minimal.cpp -->\n```cpp\nint no_such;\n```", "are not in examples/01_minimal.cpp"),
    ("figures", "README.md", "# New\n\n| robots | steps |\n|---|---|\n| 1 | 2.5 |\n| 10 | 3.5 |\n", "names no command that made them"),
    ("sources_cited", "README.md", "As in [nobody1999].", "[nobody1999] is not in docs/references.bib"),
    ("sources_cited", "README.md", 'As in Sec. "No such section".', 'no section "No such section"'),
    ("sources_cited", "include/trophic/death/floor/no_floor.hpp", 'static std::string_view source = "hearsay";', 'source "hearsay" names neither'),
    ("sources_cited", "include/trophic/death/floor/no_floor.hpp", "// Eq. 9", "no equation 9"),
    ("slots", "include/trophic/rules/slots.hpp", "  SLOT(Weather, weather, perception, Weather, detail::NoPolicy, false)", "no heading of the slot Weather"),
    ("reading", "docs/read-in-an-hour.md", "## 13. [io/csv.hpp](../include/trophic/io/csv.hpp)\n\nIt has `no_such_name`. It is one.", "csv.hpp has no 'no_such_name'"),
    ("reading", "docs/read-in-an-hour.md", "## 14. [io/csv.hpp](../include/trophic/io/csv.hpp)\n\nOne sentence.", "1 sentences about io/csv.hpp"),
    ("reading", "docs/read-in-an-hour.md", "", "14 files of"),
    ("lengths", "README.md", "\n" * 250, "must be <= 250"),
    ("lengths", "README.md", "| a |\n|---|\n| " + "long " * 150 + "|", "a cell of 749 characters"),
    ("speed", "README.md", "It is 30 times faster.", "'30 times faster': the figure of docs/performance.md is"),
    ("readme", "README.md", "A vacancy.", "'vacancy' is a word of the glossary"),
]  # fmt: skip


def main() -> int:
    missed = []
    together = collections.defaultdict(list)  # the errors for one check of one document are planted together
    for check, document, lie, said in LIES:
        together[check, document].append((lie, said))
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "trophic"
        shutil.copytree(ROOT, copy, symlinks=True, ignore=shutil.ignore_patterns("build", ".git", ".cache", "runs", "node_modules"))
        for (check, document), lies in together.items():
            path = copy / document
            before = path.read_text()
            path.write_text("\n".join([before, *(f"{lie}\n" for lie, _ in lies)]))
            read = document if document.endswith(".md") else "docs/how-to/which-slot.md"
            command = [CHECK, copy, check, "--only", read, "--programs", PROGRAMS]
            if check == "sources_cited":
                command = [HOUSE, copy, check]
            done = subprocess.run([sys.executable, *command], capture_output=True, text=True)
            path.write_text(before)
            all_said = [said for _, said in lies]
            for lie, said in lies:
                if done.returncode != 1 or done.stdout.count(said) < all_said.count(said):
                    missed.append(f"{check}: not found: {lie}\n{done.stdout}{done.stderr}")
    print("\n".join(missed) or f"{len(LIES)} planted errors were found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
