# SPDX-License-Identifier: MIT
"""Becomes the compiled module trophic_ecologies that pip installed; a compiled one in the same folder is imported instead of this file."""
from trophic.programs import become_compiled

become_compiled(__name__)
