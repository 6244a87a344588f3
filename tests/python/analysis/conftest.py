# SPDX-License-Identifier: MIT
"""The module under test is that of the sources; tests of programs share helpers."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "tools/python"), str(ROOT / "tests/program")]
