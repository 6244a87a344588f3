# SPDX-License-Identifier: MIT
"""Reads what runs of trophic leave: recordings, which needs numpy; tables in trophic.runs, which needs pandas too."""

from .recording import Recording, RecordingError, read_replay

__all__ = ["Recording", "RecordingError", "read_replay"]
