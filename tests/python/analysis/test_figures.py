# SPDX-License-Identifier: MIT
"""Figures take what `trophic.analyze` returns."""
import numpy
import pandas
import pytest
from sets import metric, set_of
from trophic import judge
from trophic.report.analyze import Outcome
from trophic.runs import RunError

pytest.importorskip("matplotlib").use("Agg")
from trophic import figures  # noqa: E402


def example(mean, label="paper"):
    """Six runs with curves of velocities."""
    rng = numpy.random.default_rng(3)
    names = [
        metric(name, species, group)
        for name in ("velocity", "population")
        for species in ("prey", "predator")
        for group in ("inherited", "random")
    ]
    of = set_of({name: list(rng.normal(mean, 0.1, 6)) for name in names}, label=label)
    for run in of.values:
        run.curves = pandas.concat(
            [run.values.drop(columns="role").assign(time_s=time_s, baseline="") for time_s in (200.0, 400.0)]
        )
    return of


def analysis_of(*sets):
    return Outcome(
        list(sets), [judge.summarize(of) for of in sets], judge.compare(*sets) if len(sets) > 1 else None
    ).analysis(None)


def test_figure_takes_an_analysis():
    figure = figures.velocity(analysis_of(example(0.01)))
    assert len(figure.axes) == 2 and "n = 6 runs" in figure.caption


def test_figure_of_a_comparison_takes_the_name_of_a_set():
    both = analysis_of(example(0.01), example(0.5, "released"))
    assert "by the rules of released on kinematic 1" in figures.velocity(both, set="released").caption
    with pytest.raises(RunError, match="set=None: must be paper or released"):
        figures.velocity(both)
    significant = sum(row["raw"]["differs"] is True for row in both.summary["differences"])
    filled = [
        line
        for line in figures.forest(both).axes[0].lines
        if line.get_markerfacecolor() == "black" and line.get_marker() == "o"
    ]
    assert len(filled) == significant == both.summary["family"]["significant"] > 0
