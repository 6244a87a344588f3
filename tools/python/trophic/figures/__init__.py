# SPDX-License-Identifier: MIT
"""Figures of what `trophic analyze` and `trophic cross-check` wrote, as matplotlib figures and, by `trophic plot`, as files.

    from trophic import figures
    figures.use("ieee")
    data, = figures.sets_of("analysis")
    figures.velocity(data)

Needs matplotlib, pandas and scipy (Debian: python3-matplotlib, python3-pandas, python3-scipy)."""
from .paper import (FIGURES, Data, attribution, forest, own_metric, population, sets_of, tag_symmetry, velocity,  # noqa: F401
                    wall_sticking)
from .pictures import catches, film_strip, phylogeny, trajectories  # noqa: F401
from .style import Missing, save_all, use  # noqa: F401
