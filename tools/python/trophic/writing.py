# SPDX-License-Identifier: MIT
"""The one writer of generated files: tables, JSON and pages, and the new folder that they are in."""
from __future__ import annotations

import contextlib
import fcntl
import itertools
import json
import os
import pathlib
import re
import shutil
from collections.abc import Iterator
from typing import Any

import pandas

from .errors import RunError, printable
from .words import number_text


class _Taken(RunError):
    """Another program has the name, or had it a moment ago."""


@contextlib.contextmanager
def result_folder(out: str | os.PathLike | None, keeps: str = "", name: str = "analysis") -> Iterator[pathlib.Path]:
    """A folder OUT.part for results, which gets the name `out`, or the next free one of NAME, NAME-1, ..., when the work is done; `with_suffix("")` is that
    name. It goes again if the work fails; what a killed program left there is removed, but for a file called `keeps`. Raises RunError if the folder
    exists, or if another program works in OUT.part. Print when it is there: standard output may end early."""
    if out is not None:
        part, lock = _begun(path := pathlib.Path(out))
    else:
        for free in itertools.chain([name], (f"{name}-{i}" for i in itertools.count(1))):
            with contextlib.suppress(_Taken):
                part, lock = _begun(path := pathlib.Path(free))
                break
    try:
        _clear(part, keeps)
        yield part
        publish(part, path)
    except BaseException:
        with contextlib.suppress(OSError):
            _clear(part, keeps)
            part.rmdir()
        raise
    finally:
        os.close(lock)


def _begun(path: pathlib.Path) -> tuple[pathlib.Path, int]:
    """The folder PATH.part and its lock."""
    check_new(path)
    part = path.with_name(path.name + ".part")
    try:
        part.mkdir(parents=True, exist_ok=True)
        lock = os.open(part, os.O_RDONLY | os.O_NOFOLLOW | os.O_DIRECTORY)
    except OSError as error:
        raise RunError(f"--out {path}: cannot be made: {error.strerror}") from None
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(lock)
        raise _Taken(f"{part}: another program is running in it") from None
    except OSError:
        pass  # a file system without locks
    try:
        check_new(path)  # again: another program may have ended before the lock
    except _Taken:
        with contextlib.suppress(OSError):
            part.rmdir()
        os.close(lock)
        raise
    return part, lock


def check_new(path: pathlib.Path) -> None:
    """Raises RunError if a folder exists."""
    if os.path.lexists(path):
        raise _Taken(f"--out {path}: exists already; files are never overwritten")


def _clear(part: pathlib.Path, keeps: str) -> None:
    for left in part.iterdir():
        if left.name != keeps:
            shutil.rmtree(left) if left.is_dir() and not left.is_symlink() else left.unlink()


def publish(part: pathlib.Path, path: pathlib.Path) -> None:
    """Gives a folder of results its name. Raises RunError if something has it."""
    check_new(path)
    part.rename(path)


def encoded(text: str) -> bytes:
    """The text as UTF-8; a byte that is none, which the name of a file may have, as \\udcff."""
    return text.encode("utf-8", "backslashreplace")


def write_new(path: str | os.PathLike, content: str | bytes) -> None:
    """Writes a new file, whole or not at all. Raises RunError if it exists, and OSError if it cannot be written; both name it."""
    path = pathlib.Path(path)
    part = path.with_name(path.name + ".part")
    try:
        part.unlink(missing_ok=True)  # of a killed program, or a link
        with open(part, "xb") as file:
            file.write(encoded(content) if isinstance(content, str) else content)
        os.link(part, path)  # unlike a renaming, it never replaces a file
    except FileExistsError:
        raise RunError(f"{path}: exists already; files are never overwritten") from None
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(path)) from None
    finally:
        part.unlink(missing_ok=True)


def csv_text(frame: pandas.DataFrame) -> str:
    """A frame as trophic's CSV, a line a row: exact numbers, empty cells for nan and None, texts in quotes if they have a comma or a quote, and
    control characters as \\x0a."""
    columns = []
    for name in frame:
        if frame[name].dtype.kind in "fiu":
            columns.append([number_text(value) for value in frame[name].tolist()])
        else:
            columns.append([_cell(value) for value in frame[name].tolist()])
    return "".join(",".join(cells) + "\n" for cells in [tuple(map(_cell, frame.columns)), *zip(*columns)])


def _cell(value: Any) -> str:
    text = "" if value is None or value != value else printable(str(value))
    return '"' + text.replace('"', '""') + '"' if re.search('[,"]', text) else text


def json_text(content: Any) -> str:
    return json.dumps(without_nan(content), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def without_nan(value: Any) -> Any:
    """The value with null for each nan."""
    if isinstance(value, dict):
        return {key: without_nan(part) for key, part in value.items()}
    if isinstance(value, list):
        return [without_nan(part) for part in value]
    return None if value != value else value
