# SPDX-License-Identifier: MIT
"""Figures of what `trophic analyze` and `trophic cross-check` wrote, as matplotlib figures and, by `trophic plot`, as files.

    from trophic import figures
    figures.use("ieee")
    figures.velocity(trophic.analyze("runs/paper"))

`numbers` and `energy` take a Run. Each other figure takes an Analysis, the folder of one, or a set of one (sets_of). `set` names one of two sets that were compared, `run` is the number of
the run whose phylogeny, paths and catch are drawn. Needs matplotlib, pandas and scipy (Debian: python3-matplotlib, python3-pandas,
python3-scipy)."""
import functools

from . import paper, pictures
from .run import energy, numbers  # noqa: F401
from .paper import Data, data_of, sets_of  # noqa: F401
from .style import Missing, save_all, use  # noqa: F401


def _of_analysis(draw):
    @functools.wraps(draw)
    def figure(analysis, *arguments, set=None, run=0):
        return draw(data_of(analysis, set, run), *arguments)

    return figure


attribution, velocity, wall_sticking, tag_symmetry, population, with_and_without, own_metric = map(
    _of_analysis,
    (
        paper.attribution,
        paper.velocity,
        paper.wall_sticking,
        paper.tag_symmetry,
        paper.population,
        paper.with_and_without,
        paper.own_metric,
    ),
)
phylogeny, catches, trajectories, film_strip = map(
    _of_analysis, (pictures.phylogeny, pictures.catches, pictures.trajectories, pictures.film_strip)
)
FIGURES = [
    attribution,
    velocity,
    wall_sticking,
    tag_symmetry,
    population,
    with_and_without,
    phylogeny,
    catches,
    trajectories,
    film_strip,
]


def forest(analysis):
    """The differences of two sets that were compared, from an Analysis, its folder or its summary."""
    return paper.forest(analysis if isinstance(analysis, dict) else paper.analysis_of(analysis).summary)
