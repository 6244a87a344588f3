#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""recipes_test.py ROOT: the recipes of Spack and conda parse, have this version, name every library that CMake looks for with CMake's bounds,
and set only options that exist; the workflow runs scripts that exist on the systems that packaging/README.md names, each with the day and commit of its last run."""

import ast
import pathlib
import re
import sys
import unittest

try:
    import yaml
except ImportError:
    print("needs python3-yaml")
    sys.exit(77)

ROOT = pathlib.Path(sys.argv.pop(1))
CMAKE = (ROOT / "CMakeLists.txt").read_text()
# Names of the libraries in Spack and in conda-forge, which has no Random123: that is a source of the recipe.
NAMES = {
    "Eigen3": ("eigen", "eigen"),
    "Random123": ("random123", None),
    "tomlplusplus": ("tomlplusplus", "tomlplusplus"),
    "nlohmann_json": ("nlohmann-json", "nlohmann_json"),
    "ZLIB": ("zlib-api", "zlib"),
    "Boost": ("boost", "libboost-headers"),
    "CLI11": ("cli11", "cli11"),
    "yaml-cpp": ("yaml-cpp", "yaml-cpp"),
    "mujoco": ("mujoco", "libmujoco"),
    "pugixml": ("pugixml", "pugixml"),
}


def spack_calls(name: str) -> list[str]:
    """First arguments of the calls of a function in the recipe's class."""
    tree = ast.parse((ROOT / "packaging/spack/packages/trophic/package.py").read_text())
    return [
        node.args[0].value
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and getattr(node.func, "id", getattr(node.func, "attr", "")) == name
    ]


class Recipes(unittest.TestCase):
    def setUp(self):
        self.version = re.search(r"VERSION ([\d.]+)\n", CMAKE)[1]
        self.conda = yaml.safe_load((ROOT / "packaging/conda/recipe.yaml").read_text())
        wanted_by_programs = CMAKE.split("if(TROPHIC_BUILD_TESTS)")[0]
        self.libraries = set(re.findall(r"^ *trophic_find\(([\w-]+) ", wanted_by_programs, re.M)) | {
            "mujoco",
            "pugixml",
        }

    def test_versions_are_the_projects(self):
        self.assertEqual(spack_calls("version"), [self.version])
        self.assertEqual(self.conda["context"]["version"], self.version)

    def test_every_library_is_a_dependency_and_every_name_is_known(self):
        boost = re.search(r"trophic_find\(Boost \S+ ([\d.]+)", CMAKE)[1]
        eigen = re.search(r"trophic_find\(Eigen3 \S+ FROM ([\d.]+) BELOW (\d+)", CMAKE)
        mujoco = re.search(
            r'trophic_find_version\(mujoco ([\d.]+) ""\)', (ROOT / "cmake/trophic-find-mujoco.cmake").read_text()
        )
        spack = dict(re.fullmatch(r"([^@]+)@?(.*)", text).groups() for text in spack_calls("depends_on"))
        conda = dict(re.fullmatch(r"(\S+) ?(.*)", text).groups() for text in self.conda["requirements"]["host"])
        for library in self.libraries:
            with self.subTest(library=library):
                self.assertIn(NAMES[library][0], spack)
                if name := NAMES[library][1]:
                    self.assertIn(name, conda)
        self.assertEqual([source.get("target_directory") for source in self.conda["source"]], [None, "random123"])
        self.assertEqual(spack["boost"], f"{boost}:")
        self.assertEqual(conda["libboost-headers"], f">={boost}")
        self.assertEqual(spack["eigen"], f"{eigen[1]}:{int(eigen[2]) - 1}")
        self.assertEqual(conda["eigen"], f">={eigen[1]},<{eigen[2]}")
        self.assertEqual(spack["mujoco"], f"{mujoco[1]}:")
        self.assertEqual(conda["libmujoco"], f">={mujoco[1]}")

    def test_options_exist(self):
        set_by_recipes = set(spack_calls("define")) | set(
            re.findall(r"-D(\w+)=", " ".join(self.conda["build"]["script"]))
        )
        known = set(re.findall(r"(?:option\(|set\()(TROPHIC_\w+)", CMAKE)) | {"CMAKE_BUILD_TYPE", "mujoco_ROOT"}
        self.assertLessEqual(set_by_recipes, known)


class Workflow(unittest.TestCase):
    def test_systems_are_in_the_table_and_scripts_exist(self):
        jobs = yaml.safe_load((ROOT / ".github/workflows/tests.yml").read_text())["jobs"]
        readme = (ROOT / "packaging/README.md").read_text()
        for system in (
            jobs["tests"]["strategy"]["matrix"]["system"] + jobs["quickstart"]["strategy"]["matrix"]["system"]
        ):
            self.assertIn(f"| {system.replace(':', ' ').capitalize()}", readme)
        rows = re.findall(r"^\| .* \|$", readme.split("## Systems")[1], re.M)[1:]
        self.assertGreater(len(rows), 5)
        for row in rows:
            self.assertRegex(
                row.split("|")[3].strip(), r"^\d+ \w+ \d{4}, [0-9a-f]{7,}$|^every commit$", "a day and a commit"
            )
        for job in jobs.values():
            for step in job["steps"]:
                if script := re.match(r"scripts/\S+", step.get("run", "")):
                    self.assertTrue((ROOT / script[0]).is_file(), script[0])


if __name__ == "__main__":
    unittest.main()
