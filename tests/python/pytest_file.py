#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pytest_file.py FILE: the tests of a file, in a Python that has what the module needs; skipped without one."""

import importlib.util
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "program"))
import system_python  # noqa: E402

NEEDED = ("jinja2", "pandas", "pytest", "scipy")
system_python.need(*NEEDED)
if missing := [name for name in NEEDED if importlib.util.find_spec(name) is None]:
    print(f"no Python with {', '.join(missing)}")
    sys.exit(77)
import pytest  # noqa: E402

sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", *sys.argv[1:]]))
