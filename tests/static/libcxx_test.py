#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""libcxx_test.py ROOT [FLAG...]: every public header of the core, with its definitions, compiles with clang++ and libc++, LLVM's standard
library, which is also that of macOS; and with the C library musl, if its headers are installed. Skipped without a libc++ that has std::jthread
(Debian: clang-19 libc++-19-dev, musl-dev)."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
SKIPPED = 77
MUSL = pathlib.Path("/usr/include/x86_64-linux-musl")
# What the core includes of other libraries, without the headers of the C library beside them.
OTHERS = ("Random123", "toml++", "nlohmann", "zlib.h", "zconf.h")


def compiles(compiler: str, file: pathlib.Path, text: str, *flags: str) -> str | None:
    """None if the text compiles, else the errors."""
    file.write_text(text)
    done = subprocess.run(
        [compiler, "-std=c++20", "-stdlib=libc++", "-fexperimental-library", "-fsyntax-only", *flags, file],
        capture_output=True,
        text=True,
    )
    return None if done.returncode == 0 else done.stderr


def of_musl(compiler: str, folder: pathlib.Path) -> list[str]:
    """Flags that take musl's headers instead of those of this system."""
    for name in OTHERS:
        for place in (pathlib.Path("/usr/include"), pathlib.Path("/usr/include/x86_64-linux-gnu")):
            if (place / name).exists() and not (folder / name).exists():
                (folder / name).symlink_to(place / name)
    own = pathlib.Path(
        subprocess.run([compiler, "-print-resource-dir"], capture_output=True, text=True, check=True).stdout.strip()
    )
    folders = [own.parents[2] / "include/c++/v1", own / "include", MUSL, folder]
    return [
        "--target=x86_64-linux-musl",
        "-D_LIBCPP_HAS_MUSL_LIBC",
        "-nostdinc",
        "-nostdinc++",
        *(f"-isystem{path}" for path in folders),
    ]


def main() -> int:
    names = [f"clang++-{number}" for number in range(30, 17, -1)] + ["clang++"]
    with tempfile.TemporaryDirectory() as name:
        file = pathlib.Path(name) / "one.cpp"
        probe = "#include <thread>\nint main() { std::jthread thread{[] {}}; }\n"
        compiler = next((c for c in names if shutil.which(c) and compiles(c, file, probe) is None), None)
        if compiler is None:
            print("no clang++ here has a libc++ with std::jthread")
            return SKIPPED
        flags = ["-DTROPHIC_HEADER_ONLY=1", '-DTROPHIC_MODEL_DIR="models"', f"-I{ROOT}/include", *sys.argv[2:]]
        libraries = {"libc++": []}
        if MUSL.is_dir():
            libraries["libc++ and musl"] = of_musl(compiler, pathlib.Path(name))
        for library, extra in libraries.items():
            if errors := compiles(compiler, file, "#include <trophic/trophic.hpp>\n", *flags, *extra):
                print(f"{library}:\n" + ("\n".join(re.findall(r".*error:.*", errors)) or errors))
                return 1
        planted = "#include <trophic/support/units.hpp>\nint planted = trophic::no_such_name;\n"
        if compiles(compiler, file, planted, *flags) is None:
            print("a planted mistake was not found")
            return 1
    print(f"{compiler}: compiles with {', '.join(libraries)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
