# SPDX-License-Identifier: MIT
"""Ctrl-C and SIGTERM while a command imports modules."""
import subprocess
import sys

import pytest
from conftest import ROOT

# A module that loses exceptions during its import, as compiled ones do, and a command that begins and imports it.
MODULE = """
import os, signal, time
try:
    os.kill(os.getpid(), signal.{name})
    time.sleep(0.1)
except BaseException:
    pass
"""
COMMAND = """
import sys, time
from trophic import command
command._begins()
try:
    import loses_exceptions
    time.sleep(20)
except KeyboardInterrupt:
    sys.exit(command.STOPPED)
"""


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_a_signal_during_an_import_ends_the_command_after_it(name, tmp_path, monkeypatch):
    (tmp_path / "loses_exceptions.py").write_text(MODULE.format(name=name))
    monkeypatch.setenv("PYTHONPATH", str(ROOT / "tools/python"))
    program = subprocess.run([sys.executable, "-c", COMMAND], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert (program.returncode, program.stderr) == (3, "")
