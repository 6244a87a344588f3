# SPDX-License-Identifier: MIT
"""Sweeps: grids of rules and parameters, whose cells are compared with one of them."""
