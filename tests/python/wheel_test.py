#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""wheel_test.py SOURCES: the wheel is built without a network, has every module and none else, and its syntax is that of Python 3.9.

Exit code 77, skipped, without pip and setuptools >= 61."""

import ast
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

SOURCES = pathlib.Path(sys.argv.pop(1))
PROBE = (
    "from importlib.metadata import version as v; v('pip'), v('wheel'); assert int(v('setuptools').split('.')[0]) >= 61"
)
PYTHON = next(
    (
        p
        for p in (sys.executable, "/usr/bin/python3")
        if subprocess.run([p, "-c", PROBE], capture_output=True).returncode == 0
    ),
    None,
)
if PYTHON is None:
    print("no Python with pip, setuptools >= 61 and wheel")
    sys.exit(77)


class Wheel(unittest.TestCase):
    def test_the_wheel_has_the_modules(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            shutil.copytree(
                SOURCES, folder / "source", ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info")
            )
            built = subprocess.run(
                [
                    PYTHON,
                    "-m",
                    "pip",
                    "wheel",
                    "--no-deps",
                    "--no-build-isolation",
                    "--no-index",
                    "-w",
                    "out",
                    "./source",
                ],
                cwd=folder,
                capture_output=True,
                text=True,
            )
            self.assertEqual(built.returncode, 0, built.stderr)
            (wheel,) = (folder / "out").glob("trophic-*-py3-none-any.whl")
            with zipfile.ZipFile(wheel) as archive:
                names = {item for item in archive.namelist() if item.endswith(".py")}
                metadata = next(archive.read(item).decode() for item in archive.namelist() if item.endswith("METADATA"))
        modules = {str(path.relative_to(SOURCES)) for path in (SOURCES / "trophic").rglob("*.py")}
        self.assertEqual(names, modules)
        self.assertIn("Requires-Python: >=3.9", metadata)

    def test_the_syntax_is_that_of_python_3_9(self):
        for path in (SOURCES / "trophic").rglob("*.py"):
            tree = ast.parse(path.read_text(), feature_version=(3, 9))
            # Annotations such as str | None are not evaluated.
            first = next(
                (node for node in tree.body if isinstance(node, ast.ImportFrom) or not isinstance(node, ast.Expr)), None
            )
            if any(isinstance(node, (ast.FunctionDef, ast.AnnAssign)) for node in ast.walk(tree)):
                if path.parent.name != "figures" or "from __future__" in path.read_text():
                    self.assertEqual(getattr(first, "module", None), "__future__", path)


if __name__ == "__main__":
    unittest.main()
