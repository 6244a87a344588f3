# SPDX-License-Identifier: MIT
"""Exceptions whose message is one sentence, which names the file, the option or the folder."""


class RunError(ValueError):
    """Raised for a folder that is not a run or a set of runs; the message names it."""


class ProgramError(RuntimeError):
    """A program that is not there or that failed; the message is the program's own sentence."""
