# SPDX-License-Identifier: MIT
"""The verbs of `trophic` that Python implements, each a program trophic-VERB: their command lines, errors and exit codes."""
from __future__ import annotations

import contextlib
import errno
import importlib
import os
import pathlib
import signal
import sys
import warnings
from collections.abc import Callable
from types import FrameType
from typing import NoReturn

from .errors import ProgramError, RunError, remark
from .options import VERBS, parsed

STOPPED = 3  # the exit code of a command that a signal ends
SYSTEM = "/usr/bin/python3"  # has the packages of apt-get


def run(module: str, request: dict, begins: Callable[[], None] = lambda: None) -> int:
    """Does what a request asks and returns the exit code; errors are one line on standard error that begins with the request's `who`. `begins` is
    called when all modules are there."""

    def work() -> int:
        done = importlib.import_module(f".{module}", __package__).run
        begins()
        return done(request)

    return _guarded(request["who"], work)


def _guarded(who: str, work: Callable[[], int]) -> int:
    try:
        code = work()
        sys.stdout.flush()
        return code
    except ModuleNotFoundError as error:
        if str(error.name).startswith("trophic"):
            raise
        _continue_with_system()
        code, why = 2, (
            f"needs the Python module {error.name}, which {sys.executable} lacks: apt-get install python3-jinja2 python3-matplotlib "
            "python3-pandas python3-scipy, or set TROPHIC_PYTHON to a Python that has it"
        )
    except OSError as error:
        is_output = error.filename is None and error.errno in (
            errno.EBADF,
            errno.EIO,
            errno.ENOSPC,
            errno.EFBIG,
            errno.EDQUOT,
        )
        where = "cannot write to standard output" if is_output else error.filename
        code, why = 1, ": ".join(str(part) for part in (where, error.strerror or error) if part)
    except MemoryError:
        code, why = 1, "there is not enough memory"
    except KeyboardInterrupt:
        return STOPPED
    except (RunError, ProgramError) as error:
        code, why = 2, str(error)
    remark(who, why)
    return code


def _continue_with_system() -> None:
    """Restarts in the system's Python unless TROPHIC_PYTHON names another one: python3 may belong to a virtual environment that lacks packages."""
    if "TROPHIC_PYTHON" not in os.environ and os.access(SYSTEM, os.X_OK):
        os.environ["TROPHIC_PYTHON"] = SYSTEM
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})  # until it has begun (__main__.py)
        os.execv(SYSTEM, [SYSTEM, *_again])


_again: list[str] = []  # the arguments of Python that begin again


def main(words: list[str]) -> NoReturn:
    """A verb and its arguments, as the shell passes them."""
    warnings.simplefilter("ignore")  # of libraries: a user is given sentences
    _occupy_closed_streams()
    for stream in (sys.stdout, sys.stderr):  # whatever the locale
        stream.reconfigure(encoding="utf-8", errors="surrogateescape")  # type: ignore[union-attr]
    _again[:] = ["-I", "-X", "utf8", str(pathlib.Path(__file__).with_name("__main__.py")), *words]
    verb, *rest = words or ["help"]
    request, why = None, ""
    try:
        request = parsed(verb, rest)
    except RunError as error:
        why = str(error)
    except SystemExit:  # --help, which has printed
        _end(lambda: _guarded(f"trophic {verb}", lambda: 0))
    if request is not None:
        _end(lambda: run(VERBS[verb].module, request, _begins))
    remark(f"trophic {verb}", why)
    sys.exit(2)


def _occupy_closed_streams() -> None:
    """Keeps the numbers of standard streams that were closed (`>&-`) from files. Writing to the replacement fails, so that it is noticed."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_WRONLY if number == 0 else os.O_RDONLY)  # takes the lowest free number
    sys.stdout = sys.stdout or open(1, "w", encoding="utf-8", closefd=False)
    sys.stderr = sys.stderr or open(2, "w", encoding="utf-8", closefd=False)


def script() -> NoReturn:
    """The program trophic-VERB that pip installs."""
    main([pathlib.Path(sys.argv[0]).name.removeprefix("trophic-"), *sys.argv[1:]])


def _begins() -> None:
    """Signals are exceptions from now on, so that temporary folders go; before, they end the program at once (__main__.py)."""
    if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
        signal.signal(signal.SIGINT, _stop)
    signal.signal(signal.SIGTERM, _stop)


def _stop(number: int, frame: FrameType | None) -> None:
    """Raises what ends the command. During an import it tries again later, because a compiled module may lose the exception."""
    at = frame
    while at is not None:
        if at.f_code.co_filename == "<frozen importlib._bootstrap>":
            signal.signal(signal.SIGALRM, lambda _, later: _stop(number, later))
            signal.setitimer(signal.ITIMER_REAL, 0.02)
            return
        at = at.f_back
    raise KeyboardInterrupt if number == signal.SIGINT else SystemExit(STOPPED)


def _end(work) -> NoReturn:
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    code = work()
    with contextlib.suppress(OSError):  # it may be closed
        sys.stderr.flush()
    os._exit(code)  # standard output was flushed; a second failure to write it would be reported again
