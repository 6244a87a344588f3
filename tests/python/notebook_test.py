#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""notebook_test.py PREDATOR_PREY TROPHIC NOTEBOOK [MODULE]: the notebook runs from its first cell to its last; without the programs it says so.
MODULE: folder of the module trophic_ecologies.

Exit code 77, skipped, without nbclient and ipykernel (Debian: python3-nbclient python3-ipykernel) or matplotlib."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = "import ipykernel, matplotlib, nbclient, nbformat, pandas, scipy"
PYTHON = next(
    (
        p
        for p in (sys.executable, "/usr/bin/python3")
        if shutil.which(p) and subprocess.run([p, "-c", MODULES], capture_output=True).returncode == 0
    ),
    None,
)
if PYTHON is None:
    print("no Python with nbclient, ipykernel, matplotlib, pandas and scipy")
    sys.exit(77)
if pathlib.Path(PYTHON) != pathlib.Path(sys.executable):
    os.execv(PYTHON, [PYTHON, *sys.argv])

import nbclient  # noqa: E402
import nbformat  # noqa: E402

PREDATOR_PREY, TROPHIC, NOTEBOOK = (sys.argv.pop(1) for _ in range(3))
MODULE = [sys.argv.pop(1)] if len(sys.argv) > 1 else []
EXPECTED = {
    "study": (
        [
            "6 runs of 2000 s, 6 of the shadow",
            "caught",
            "n = 6 runs and 6 of the shadow",
            "image/png",
            "lower_corrected",
            ")n",
        ],
        ["analysis", "runs"],
    ),
    "policy": (
        ["image/png", "minus untrained [95 %]", "minus evolved [95 %]", "8 runs; for victims more is better"],
        ["runs"],
    ),
}


class Notebook(unittest.TestCase):
    def execute(self, programs):
        with tempfile.TemporaryDirectory() as folder:
            environment = {
                "PYTHONPATH": os.pathsep.join([*MODULE, str(ROOT / "tools/python")]),
                "TROPHIC_BIN": str(programs),
                "PATH": "/usr/bin:/bin",
            }
            old = {name: os.environ.get(name) for name in environment}
            os.environ.update(environment)
            try:
                notebook = nbformat.read(NOTEBOOK, as_version=4)
                kernel = notebook.metadata.kernelspec.name
                nbclient.NotebookClient(
                    notebook, timeout=600, kernel_name=kernel, resources={"metadata": {"path": folder}}
                ).execute()
                return notebook, sorted(path.name for path in pathlib.Path(folder).iterdir())
            finally:
                for name, value in old.items():
                    os.environ.pop(name) if value is None else os.environ.update({name: value})

    def test_every_cell(self):
        notebook, files = self.execute(pathlib.Path(PREDATOR_PREY).parent)
        outputs = "".join(str(cell.get("outputs", "")) for cell in notebook.cells)
        texts, made = EXPECTED[pathlib.Path(NOTEBOOK).stem]
        for text in texts:
            self.assertIn(text, outputs)
        self.assertEqual(files, made)
        if MODULE:
            above_untrained = re.search(r"trained +\S+ \[.*?\] +\S+ \[(\S+), \S+\]", outputs)
            self.assertGreater(float(above_untrained[1]), 0.0)

    @unittest.skipIf(MODULE, "it trains first")
    def test_without_the_programs_one_sentence_says_so(self):
        with self.assertRaises(nbclient.exceptions.CellExecutionError) as raised:
            self.execute("/nowhere")
        self.assertIn(
            "ProgramError: trophic-predator-prey: is not on the PATH; install trophic, or set TROPHIC_BIN",
            str(raised.exception),
        )


if __name__ == "__main__":
    unittest.main()
