# SPDX-License-Identifier: MIT
"""`python3 -m trophic.command`: does what a program's command asks by one JSON object on standard input. Its exit code is the program's."""
from __future__ import annotations

import importlib
import json
import shutil
import signal
import sys

# The module whose run(request) does a command.
MODULES = {"plot": "plot"}


def run(request: dict) -> int:
    """Does the command of a request and returns the exit code; errors are one line on standard error that begins with the request's `who`."""
    try:
        module = importlib.import_module(f".{MODULES[request['command']]}", __package__)
        code = module.run(request)
        sys.stdout.flush()
        return code
    except ModuleNotFoundError as error:
        if str(error.name).startswith("trophic"):
            raise
        why = (f"needs the Python module {error.name}, which {sys.executable} lacks: apt-get install python3-matplotlib python3-pandas "
               "python3-scipy, or TROPHIC_PYTHON=/usr/bin/python3 if it is installed there")
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
    except Exception as error:
        if type(error).__name__ != "RunError":  # compared by name: its module needs pandas
            raise
        why = str(error)
    print(f"{request['who']}: {why}", file=sys.stderr)
    return 2


def main() -> int:
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))  # an exit, which removes the temporary folder
    request = json.load(sys.stdin)
    try:
        return run(request)
    finally:
        if request.get("temporary"):
            shutil.rmtree(request["temporary"], ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
