# SPDX-License-Identifier: MIT
"""Continues in the system's Python, which has apt-get's modules, if the one that runs the tests lacks some."""

import importlib.util
import os
import sys

SYSTEM = "/usr/bin/python3"


def need(*modules: str) -> None:
    """Call it first: the script starts anew in the other Python."""
    if all(importlib.util.find_spec(module) for module in modules) or sys.executable == SYSTEM:
        return
    os.execv(SYSTEM, [SYSTEM, *sys.argv])
