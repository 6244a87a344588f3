# SPDX-License-Identifier: MIT
"""Results of an analysis for the terminal, tables, LaTeX and a page. All of them print what `trophic.judge` decided."""
