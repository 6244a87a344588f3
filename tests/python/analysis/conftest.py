# SPDX-License-Identifier: MIT
"""The module under test is that of the sources."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tools" / "python"))
