#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""installed_programs_test.py FOLDER: the programs in PREFIX/bin, under names that begin with trophic, with the models of PREFIX/share, and the
libraries next to them."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BIN = pathlib.Path(sys.argv.pop(1))
SOURCES = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = ["trophic", "trophic-predator-prey", "trophic-worlds"]
VERBS = [f"trophic-{verb}" for verb in ("analyze", "cite", "contest", "cross-check", "help", "plan", "plot")]


class InstalledPrograms(unittest.TestCase):
    def test_names(self):
        self.assertEqual(sorted(path.name for path in BIN.iterdir()), sorted(PROGRAMS + VERBS))
        for program in PROGRAMS:
            shown = subprocess.run([BIN / program, "--version"], capture_output=True, text=True)
            self.assertEqual((shown.returncode, shown.stderr), (0, ""))
            self.assertIn("backends  kinematic", shown.stdout)

    def test_no_installed_file_names_the_sources(self):
        files = [path for path in BIN.parent.rglob("*") if path.is_file() and path.parent.name != "__pycache__"]
        self.assertLess(
            {"trophic", "libtrophic_compiled.a", "trophic.pc", "trophic-config.cmake"}, {path.name for path in files}
        )
        for file in files:
            self.assertIsNone(
                re.search(rb"(?<![\w.-])" + re.escape(bytes(SOURCES)) + rb"(?![\w.-])", file.read_bytes()), file
            )

    def test_a_run_takes_the_models_that_were_installed(self):
        with tempfile.TemporaryDirectory() as folder:
            prefix = pathlib.Path(folder) / "elsewhere"
            shutil.copytree(BIN.parent, prefix)
            robot = prefix / "share/trophic/models/robots/spider.toml"
            robot.write_text("broken = = 1\n")
            run = [prefix / "bin/trophic-predator-prey", "--backend", "kinematic", "--duration", "10", "--out", "run"]
            refused = subprocess.run(run, capture_output=True, text=True, cwd=folder)
            self.assertNotEqual(refused.returncode, 0)
            self.assertIn(str(robot), refused.stderr)
            self.assertFalse((pathlib.Path(folder) / "run").exists())

    def test_an_analysis_takes_the_module_that_was_installed(self):
        with tempfile.TemporaryDirectory() as folder:
            prefix = pathlib.Path(folder) / "elsewhere"
            shutil.copytree(BIN.parent, prefix)
            self.assertTrue((prefix / "share/trophic/python/trophic/report/page.html.j2").exists())
            (prefix / "share/trophic/python/trophic/__main__.py").write_text("print('installed')\n")
            done = subprocess.run([prefix / "bin/trophic", "cite", folder], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (0, "installed\n"), done.stderr)


if __name__ == "__main__":
    unittest.main()
