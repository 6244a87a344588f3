# SPDX-License-Identifier: MIT
"""`python3 -m trophic.command`: does what a program's command asks by one JSON object on standard input. Its exit code is the program's."""
from __future__ import annotations

import importlib
import json
import os
import re
import shutil
import signal
import sys

# The module whose run(request) does a command.
MODULES = {"ablation-table": "ablations", "analyze": "report.analyze", "analyze-sweep": "sweeps.report", "card": "card", "cite": "cite", "contest": "contest_plan",
           "analyze-selection": "selection", "cross-check": "cross_check", "metrics": "metrics.help", "plan": "plan", "plot": "plot"}
STOPPED = 3  # the exit code of a command that a signal ends
SYSTEM = "/usr/bin/python3"  # has the packages of apt-get


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
        _continue_with_system()
        code, why = 2, (f"needs the Python module {error.name}, which {sys.executable} lacks: apt-get install python3-jinja2 python3-matplotlib "
                        "python3-pandas python3-scipy, or let TROPHIC_PYTHON name a Python that has it")
    except OSError as error:
        code, why = 1, f"{error.filename or 'cannot write to standard output'}: {error.strerror}"
    except MemoryError:
        code, why = 1, "there is not enough memory"
    except KeyboardInterrupt:
        return STOPPED
    except Exception as error:
        if type(error).__name__ not in ("RunError", "ProgramError"):  # compared by name: its module needs pandas
            raise
        code, why = 2, str(error)
    print(f"{request['who']}: {_one_line(why)}", file=sys.stderr)
    return code


def _one_line(text: str) -> str:
    """Writes control characters, which the name of a file may have, as \\x0a."""
    return re.sub(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]", lambda found: "".join(f"\\x{byte:02x}" for byte in found[0].encode()), text)


def _continue_with_system() -> None:
    """Begins again in the system's Python unless TROPHIC_PYTHON names another: python3 may be one of a virtual environment that lacks packages."""
    if "TROPHIC_PYTHON" not in os.environ and os.access(SYSTEM, os.X_OK) and sys.stdin.seekable():
        os.environ["TROPHIC_PYTHON"] = SYSTEM
        os.lseek(0, 0, os.SEEK_SET)
        os.execv(SYSTEM, [SYSTEM, "-m", __package__ + ".command"])


def main() -> int:
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(STOPPED))  # an exit, which removes the temporary folder
    request = json.load(sys.stdin)
    try:
        return run(request)
    finally:
        if request.get("temporary"):
            shutil.rmtree(request["temporary"], ignore_errors=True)


if __name__ == "__main__":
    code = main()
    sys.stderr.flush()
    os._exit(code)  # standard output was flushed; a second failure to write it would be reported again
