#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""house_test.py ROOT: house.py finds offences that are planted in a copy of the library: headers of slots, includes, paths, long lists of parameters."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
LEFT = {  # folder of a slot -> the only policy that is left
    "initialization/community": "predator_prey",
    "control/steering": "targeted_steering",
    "reproduction/initial_genome": "uniform_weights",
    "death/activation": "always_active",
    "perception/sensors": "side_of_adversary",
}
PLANTED = (  # check, header, text, offence
    ("two_policies_per_slot", "control/brain/network.hpp", "// A part of several brains.", "control/brain/network.hpp: is not a policy"),
    ("library_alone", "run.hpp", "#ifdef TROPHIC_WITH_MPI\n#include <trophic/mpi/find_team.hpp>\n#endif", "the library cannot include trophic/mpi/find_team.hpp"),
    ("library_alone", "io/manifest.hpp", "#include <tools/command/words.hpp>", "the library cannot include tools/command/words.hpp"),
    ("library_alone", "run.hpp", "#  include <mujoco/mujoco.h>", "the library cannot include mujoco/mujoco.h"),
    ("library_alone", "run.hpp", "#include <trophic/backend/mujoco.hpp>", "the library cannot include trophic/backend/mujoco.hpp"),
    ("paths_exist", "run.hpp", '// "see trophic/rules/lost.hpp"', "trophic/rules/lost.hpp does not exist"),
    ("policies_have_tests", "death/floor/lost.hpp", "#pragma once", "death/floor/lost.hpp: no tests/**/lost_test.cpp"),
    ("few_parameters", "run.hpp", "void free(int a, int b, const Rules& c, Span<const double> d, Map<int, int> e, double f = 1.0, bool g = h(1, 2));", " free: 7 parameters"),
    ("few_parameters", "run.hpp", "struct Built { explicit Built(int a, int b, int c, int d, int e, int f, Genes&& g) : a_{a} {} };", "Built: 7 parameters"),
    ("few_parameters", "run.hpp", "template <class... Own>\nvoid parted(const Rules& a, int b, int c, int d,\n            int e, int f, Own&... own) {}", "parted: 7 parameters"),
    ("few_parameters", "run.hpp", "int unnamed(const A&, const B&, C*, D&&, const std::string&, int, double) { return 0; }", "unnamed: 7 parameters"),
    ("few_parameters", "run.hpp", "const auto lambda = [&](int a, int b, int c, int d, int e, int f, int g) { return a; };", "]: 7 parameters"),
    ("exported_includes", "death/senescence/old_age.hpp", "#include <trophic/population/view.hpp>", "trophic/death/senescence/contract.hpp exports #include <trophic/population/view.hpp>"),
    ("complete_umbrella", "trophic.hpp", "#include <trophic/ecology/ecology.hpp>", "another header includes trophic/ecology/ecology.hpp"),
    ("small_library", "run.hpp", "#include <trophic/run.hpp>\n" * 800, "must be <= 9"),
    ("complete_umbrella", "support/lost.hpp", "#pragma once", "trophic.hpp lacks #include <trophic/support/lost.hpp>"),
)


def offences(root: pathlib.Path, check: str) -> str:
    return subprocess.run([sys.executable, ROOT / "tests/static/house.py", root, check], capture_output=True, text=True).stdout


def main() -> int:
    missed = []
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        for part in ("include", "tests/unit"):
            shutil.copytree(ROOT / part, copy / part)
        (copy / "backends/mujoco").mkdir(parents=True)
        missed += [f"{check} finds in the tree as it is: {found}" for check in ("two_policies_per_slot", "library_alone", "policies_have_tests", "complete_umbrella", "few_parameters") if (found := offences(copy, check))]
        for check, header, text, offence in PLANTED:
            path = copy / "include/trophic" / header
            before = path.read_text() if path.exists() else None
            path.write_text(f"{before or ''}{text}\n")
            if offence not in offences(copy, check):
                missed.append(f"{check}: not found: {offence}")
            path.unlink() if before is None else path.write_text(before)
        for slot, left in LEFT.items():
            for path in (copy / "include/trophic" / slot).glob("*.hpp"):
                if path.stem not in ("contract", left):
                    path.unlink()
            if f"include/trophic/{slot}: {left}: must have at least 2 policies" not in offences(copy, "two_policies_per_slot"):
                missed.append(f"{slot}: not found")
    print("\n".join(missed) or "all were found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
