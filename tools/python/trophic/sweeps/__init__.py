# SPDX-License-Identifier: MIT
"""Sweeps: grids of rules and parameters, whose cells are compared with one of them."""
from .report import SweepAnalysis, analyze_sweep, run
from .runs import is_sweep

__all__ = ["SweepAnalysis", "analyze_sweep", "is_sweep", "run"]
