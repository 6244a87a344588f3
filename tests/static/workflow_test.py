#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""workflow_test.py ROOT: the workflow runs scripts that exist on the systems that packaging/README.md names, each with the day and commit of its last
run; the Python package has the project's version, a script for each program and verb, and one version of MuJoCo, which CMake takes."""

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


class Package(unittest.TestCase):
    def setUp(self):
        self.project = (ROOT / "pyproject.toml").read_text()

    def test_every_program_and_verb_is_a_script(self):
        verbs = re.search(r"^set\(verbs (.*)\)$", (ROOT / "tools/CMakeLists.txt").read_text(), re.M)[1].split()
        scripts = dict(re.findall(r'^(trophic[\w-]*) = "trophic\.(\w+):script"$', self.project, re.M))
        programs = {"trophic", "trophic-predator-prey", "trophic-worlds"}
        self.assertEqual(
            scripts, {**dict.fromkeys(programs, "programs"), **{f"trophic-{verb}": "command" for verb in verbs}}
        )

    def test_its_version_is_the_projects(self):
        version = re.search(r"VERSION ([\d.]+)\n", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertIn(f'__version__ = "{version}"\n', (ROOT / "tools/python/trophic/__init__.py").read_text())

    def test_it_is_built_and_used_with_one_mujoco(self):
        versions = set(re.findall(r'"mujoco==([\d.]+)"', self.project))
        self.assertEqual(len(re.findall(r'"mujoco[^"]*"', self.project)), 2)
        self.assertEqual(len(versions), 1)
        finder = (ROOT / "cmake/trophic-find-mujoco.cmake").read_text()
        least = re.search(r"trophic_find_version\(mujoco ([\d.]+) ", finder)[1]
        self.assertLessEqual(*([int(part) for part in text.split(".")] for text in (least, *versions)))


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
