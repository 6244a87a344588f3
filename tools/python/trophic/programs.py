# SPDX-License-Identifier: MIT
"""Trophic's programs as commands and its compiled module: their location, their errors, and the page that `trophic show` makes."""
from __future__ import annotations

import importlib.machinery
import importlib.util
import os
import pathlib
import shutil
import signal
import subprocess
import sys
from typing import NoReturn

from .errors import ProgramError
from .progress import Errors


def compiled() -> pathlib.Path | None:
    """The folder of the programs that pip installed: those with MuJoCo if the wheel of the MuJoCo that they need is beside trophic."""
    package = pathlib.Path(__file__).resolve().parent
    for folder in sorted((package / "compiled").glob("mujoco-*")):
        version = folder.name.removeprefix("mujoco-")
        if (package.parent / f"mujoco/libmujoco.so.{version}").exists():
            return folder
    kinematic = package / "compiled/kinematic"
    return kinematic if kinematic.is_dir() else None


def find_program(name: str) -> str:
    """The path of one of trophic's programs: in $TROPHIC_BIN, where pip installed it, next to an installed copy of this module, or on the PATH."""
    places = [os.environ.get("TROPHIC_BIN"), compiled(), pathlib.Path(__file__).resolve().parents[4] / "bin"]
    for place in filter(None, places):
        if (found := shutil.which(name, path=str(place))) is not None:
            return found
    if (found := shutil.which(name)) is not None:
        return found
    raise ProgramError(f"{name}: is not on the PATH; install trophic, or set TROPHIC_BIN to its folder of programs")


def program_named(named: str | os.PathLike) -> str:
    """The path of a program that is named by a path, which has a folder, or by its name alone."""
    named = os.fspath(named)
    return os.path.abspath(named) if os.sep in named else find_program(named)


def program_of_table(table: str | None) -> str:
    """The path of the shipped program that has this rule table; None is the first table of all."""
    return find_program("trophic-predator-prey" if table in (None, "paper", "released") else "trophic-worlds")


def script() -> NoReturn:
    """Becomes the program of the name under which pip installed this script."""
    name = pathlib.Path(sys.argv[0]).name
    if (folder := compiled()) is None:
        sys.exit(f"{name}: pip installed trophic without its programs; run pip install without -e and without settings")
    os.environ.setdefault("TROPHIC_PYTHON", sys.executable)  # of its verbs
    os.execv(folder / name, sys.argv)


def become_compiled(name: str) -> None:
    """Replaces the module of this name by the compiled one that pip installed."""
    folder = compiled()
    found = importlib.machinery.PathFinder.find_spec(name, [str(folder)]) if folder is not None else None
    if found is None or found.loader is None:
        raise ModuleNotFoundError(
            f"{name}: is not compiled here: run pip install in the sources of trophic, or cmake", name=name
        )
    sys.modules[name] = importlib.util.module_from_spec(found)
    found.loader.exec_module(sys.modules[name])


def call(program: str, arguments: list, what: str, *, progress: bool = False) -> str:
    """Calls a program and returns its remarks on standard error, and draws its progress if asked. If it fails, raises ProgramError with its message,
    or with `what` and the exit code. An interrupt lets it end as Ctrl-C does: after a tick and with a checkpoint."""
    errors = Errors(what, progress)
    try:
        called = subprocess.Popen([program, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=errors.writer)
    except OSError as error:
        errors.read()
        raise ProgramError(f"{program}: {error.strerror}") from None
    try:
        with called:
            try:
                said = errors.read()
            except BaseException:
                called.send_signal(signal.SIGINT)
                raise
    finally:
        errors.end(called.returncode == 0)
    if called.returncode != 0:
        raise ProgramError(said.strip() or f"{what}: exit code {called.returncode}")
    return said


class Page:
    """A page of `trophic show`: displayed in a notebook, opened in a browser by open()."""

    def __init__(self, path: pathlib.Path):
        self.path = path

    def _repr_html_(self) -> str:
        import html

        text = html.escape(self.path.read_text(encoding="utf-8"), quote=True)
        return f'<iframe srcdoc="{text}" style="width: 100%; height: 640px; border: 1px solid #ccc"></iframe>'

    def open(self) -> None:
        import webbrowser

        webbrowser.open(self.path.resolve().as_uri())


def show(folder: pathlib.Path, out: str | os.PathLike | None = None) -> Page:
    """A page of the recorded run in a folder, in `out` or in a temporary file."""
    if out is None:
        import tempfile

        out = pathlib.Path(tempfile.mkdtemp(prefix="trophic-")) / "run.html"
    call(find_program("trophic"), ["show", folder, "-o", out], "trophic show")
    return Page(pathlib.Path(out))
