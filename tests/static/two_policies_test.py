#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""two_policies_test.py ROOT: house.py finds each slot of a copy of the core in which one policy is left, and a header that is none."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
SLOTS = {  # folder -> the policy that is left
    "initialization/community": "predator_prey",
    "control/steering": "targeted_steering",
    "reproduction/initial_genome": "uniform_weights",
    "death/activation": "always_active",
    "perception/sensors": "side_of_adversary",
}


def offences(root: pathlib.Path) -> str:
    house = [sys.executable, ROOT / "tests/static/house.py", root, "two_policies_per_slot"]
    return subprocess.run(house, capture_output=True, text=True).stdout


def main() -> int:
    missed = []
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        shutil.copytree(ROOT / "include", copy / "include")
        if found := offences(copy):
            missed.append(f"found in the tree as it is: {found}")
        stray = copy / "include/trophic/control/brain/network.hpp"
        stray.write_text("// A part of several brains.\n")
        if "control/brain/network.hpp: is not a policy" not in offences(copy):
            missed.append(f"{stray}: not found")
        for slot, left in SLOTS.items():
            for path in (copy / "include/trophic" / slot).glob("*.hpp"):
                if path.stem not in ("contract", left):
                    path.unlink()
            if f"include/trophic/{slot}: {left}: must have at least 2 policies" not in offences(copy):
                missed.append(f"{slot}: not found")
    print("\n".join(missed) or f"{len(SLOTS)} slots were found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
