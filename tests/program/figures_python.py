# SPDX-License-Identifier: MIT
"""The Python that can draw figures: the one that runs the tests or else the system's, which apt-get's modules belong to."""

import importlib.util
import os
import subprocess
import sys


def can_draw(python: str) -> bool:
    try:
        return subprocess.run([python, "-c", "import matplotlib, pandas, scipy"], capture_output=True).returncode == 0
    except OSError:
        return False


PYTHON = next(filter(can_draw, (sys.executable, "/usr/bin/python3")), None)
if PYTHON is not None:  # for `trophic plot`
    os.environ["TROPHIC_PYTHON"] = PYTHON


def continue_with_pandas() -> None:
    """Call it first: the script starts anew in PYTHON if its own has no pandas, and is skipped without one that has it."""
    if PYTHON is None:
        print("no Python with pandas")
        sys.exit(77)
    if importlib.util.find_spec("pandas") is None:
        os.execv(PYTHON, [PYTHON, *sys.argv])
