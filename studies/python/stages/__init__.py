# SPDX-License-Identifier: MIT
"""Stages of the studies, which make runs and write data, a module for each subject."""
