# SPDX-License-Identifier: MIT
"""Models and Python module of the trophic whose program `trophic` is in PATH; in a checkout of trophic, those of the sources."""
import importlib.util
import pathlib
import shutil
import sys

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]


def share():
    """PREFIX/share/trophic."""
    program = shutil.which("trophic")
    if program is None:
        raise SystemExit("trophic: is not in PATH: install trophic, and put PREFIX/bin in PATH")
    return pathlib.Path(program).resolve().parents[1] / "share/trophic"


def models():
    return CHECKOUT / "models" if (CHECKOUT / "models").is_dir() else share() / "models"


def make_importable():
    """Lets `import trophic` find the module."""
    if (CHECKOUT / "tools/python/trophic").is_dir():
        sys.path.append(str(CHECKOUT / "tools/python"))
    elif importlib.util.find_spec("trophic") is None:
        sys.path.append(str(share() / "python"))
