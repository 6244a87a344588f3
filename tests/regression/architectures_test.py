#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""architectures_test.py GOLDEN [NATIVE EMULATOR LIBRARIES PROGRAM]: the program compiled for ARM, in an emulator, writes the tables of the
native one and of the golden files. Skipped if CMake did not find what compiles and runs it (see CMakeLists.txt)."""

import json
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77
TABLES = ("events.csv", "agents.csv", "phylogeny.csv", "genomes.csv")


def main() -> int:
    if len(sys.argv) == 2:
        print("needs a cross compiler, an emulator and zlib for ARM")
        return SKIPPED
    golden, native, emulator, libraries, program = sys.argv[1:]
    golden = pathlib.Path(golden)
    with tempfile.TemporaryDirectory() as name:
        here, there = pathlib.Path(name) / "here", pathlib.Path(name) / "there"
        subprocess.run([native, here], check=True)
        subprocess.run(
            [emulator, "-L", "/usr/aarch64-linux-gnu", "-E", f"LD_LIBRARY_PATH={libraries}", program, there], check=True
        )
        runs = sorted(path.name for path in there.iterdir())
        failed = 0
        if runs != sorted(path.name for path in here.iterdir()):
            print("the two programs made other runs")
            failed += 1
        for run in runs:
            architecture = json.loads((there / run / "manifest.json").read_text())["architecture"]
            if architecture != "aarch64":
                print(f"{run}: ran on {architecture}")
                failed += 1
            for table in TABLES:
                rows = (there / run / table).read_bytes()
                if rows.count(b"\n") < 20:
                    print(f"{run}/{table}: hardly any rows")
                    failed += 1
                others = [here / run / table]
                if run.startswith("kinematic") and table != "agents.csv":
                    others.append(golden / run / table)
                for other in others:
                    if rows != other.read_bytes():
                        print(f"{run}/{table}: differs from {other}")
                        failed += 1
    print(f"compared on ARM: {', '.join(runs)}")
    return 1 if failed or "kinematic_paper" not in runs else 0


if __name__ == "__main__":
    sys.exit(main())
