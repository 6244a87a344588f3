#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""flags_test.py SOURCES COMPILER EIGEN RANDOM123 PREDATOR_PREY LIBRARY [--full]: a run of a program that is compiled with a user's flags has the bytes of
predator_prey's, or the program is refused in one sentence, by the compiled library and, with --full, by the headers alone."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

FULL = sys.argv[-1] == "--full"
SOURCES, COMPILER, EIGEN, RANDOM123, PREDATOR_PREY, LIBRARY = sys.argv[1:7]
RUN = ["--backend", "kinematic", "--seed", "42", "--duration", "3000", "--out"]  # as contraction.cpp has it
FAST, DEBUG, ALIGNED, EXCEPTIONS = (
    "trophic cannot be compiled with -ffast-math",
    "compiled libraries without _GLIBCXX_DEBUG",
    "-DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MALLOC_ALREADY_ALIGNED=1 and no other",
    "trophic needs exceptions",
)
FUSED = (
    "this program was compiled so that it fuses multiplications with additions"  # says the program: no macro is defined
)
# Flags, the sentence of their refusal by the compiled library and by the headers; none: the run has the same bytes.
SETS = [
    ("-O0 -march=native -std=gnu++20 -D_GLIBCXX_ASSERTIONS", "", ""),
    ("-Ofast", FAST, FAST),
    ("-O2 -D_GLIBCXX_DEBUG", DEBUG, ""),
    ("-O2 -fno-exceptions", EXCEPTIONS, EXCEPTIONS),
    ("-O2 -mavx2 -UEIGEN_MAX_ALIGN_BYTES -DEIGEN_MAX_ALIGN_BYTES=32", ALIGNED, ALIGNED),
]
MORE = [
    ("-O3 -march=native", "", ""),
    ("-O2 -mavx2 -mfma", "", ""),
    ("-O2 -mavx2 -mfma -ffp-contract=fast", "", FUSED),
    ("-O3 -ffast-math", FAST, FAST),
    ("-O2 -funsafe-math-optimizations", FAST, FAST),
    ("-O2 -ffinite-math-only", FAST, FAST),
    ("-O0 -g -D_GLIBCXX_ASSERTIONS", "", ""),
    ("-O2 -flto", "", ""),
    ("-O2 -std=c++23", "", ""),
    ("-O2 -DEIGEN_DONT_VECTORIZE", ALIGNED, ""),
    ("-O2 -funroll-loops -fomit-frame-pointer -fvisibility=hidden", "", ""),
    ("-Os -DNDEBUG", "", ""),
    ("-O1 -fsanitize=undefined", "", ""),
    ("-O2 UNITY", "", ""),
]


def bytes_of(folder: pathlib.Path) -> list[bytes]:
    return [
        (folder / name).read_bytes()
        for name in ("events.csv", "agents.csv", "phylogeny.csv", "genomes.csv", "replay.trp")
    ]


def refusal(flags: str, compiled: bool, folder: pathlib.Path, expected: list[bytes] | None) -> str:
    """Compiles and runs. Returns the errors of the compiler or of the run, empty if the bytes are the expected ones."""
    ours = re.search("^Cflags: (.*) -I", (pathlib.Path(SOURCES) / "cmake/trophic-header-only.pc.in").read_text(), re.M)[
        1
    ].split()
    program = folder / "program.cpp"
    included = f'#include "{SOURCES}/tests/hostile/contraction.cpp"\n'
    if expected is None:
        included = "#include <trophic/habitat/pose.hpp>\n"
    program.write_text(("#include <map>\n#include <trophic/trophic.hpp>\n" if "UNITY" in flags else "") + included)
    mode = ["-DTROPHIC_HEADER_ONLY=0"] if compiled else []
    toml = subprocess.run(["pkg-config", "--libs", "tomlplusplus"], capture_output=True, text=True).stdout.split()
    libraries = [*([LIBRARY] if compiled else []), *toml, "-lz", "-pthread"]
    more = [flag for flag in flags.split() if flag != "UNITY"]
    command = [
        COMPILER,
        *ours,
        *more,
        *mode,
        f'-DTROPHIC_MODEL_DIR="{SOURCES}/models"',
        f"-I{SOURCES}/include",
        *(part for folder in (EIGEN, RANDOM123) if folder != "/usr/include" for part in ("-isystem", folder)),
        str(program),
    ]
    done = subprocess.run(
        [*command, *(["-o", str(folder / "program"), *libraries] if expected else ["-fsyntax-only"])],
        capture_output=True,
        text=True,
    )
    if done.returncode != 0 or expected is None:
        return done.stderr
    run = subprocess.run(
        [folder / "program", folder / "run"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    )
    if run.returncode != 0:
        return run.stderr
    assert bytes_of(folder / "run") == expected, f"{flags}: other bytes"
    return ""


def main() -> int:
    with tempfile.TemporaryDirectory() as name:
        reference = pathlib.Path(name) / "reference"
        subprocess.run([PREDATOR_PREY, *RUN, reference], check=True, stdout=subprocess.DEVNULL)
        for flags, by_library, by_headers in SETS + (MORE if FULL else []):
            for compiled, sentence in ((True, by_library), (False, by_headers))[: 2 if FULL else 1]:
                folder = pathlib.Path(name) / "one"
                folder.mkdir()
                runs = sentence in ("", FUSED)
                said = refusal(flags, compiled, folder, bytes_of(reference) if runs else None)
                assert (sentence in said) if sentence else not said, f"{flags}: {said[:2000]}"
                assert said.count("error: ") <= 1, f"{flags}: {said[:2000]}"
                print(
                    f"{flags:60} {'library' if compiled else 'headers'}: {'refused' if sentence else 'the same bytes'}",
                    flush=True,
                )
                subprocess.run(["rm", "-r", folder], check=True)
    return 0


if __name__ == "__main__":
    os.environ["LC_ALL"] = "C"
    sys.exit(main())
