# SPDX-License-Identifier: MIT
"""The Python that can draw figures: the one that runs the tests or else the system's, which apt-get's modules belong to."""

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
