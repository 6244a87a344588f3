# SPDX-License-Identifier: MIT
"""Reads what runs of trophic leave. Needs numpy."""

from .recording import Recording, RecordingError, read_replay

__all__ = ["Recording", "RecordingError", "read_replay"]
