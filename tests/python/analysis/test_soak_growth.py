# SPDX-License-Identifier: MIT
"""The test of soak runs: growth by the margin passes as flat in one run of twenty, no growth passes in most."""
import collections
import importlib.util
import pathlib

import numpy
import pytest

spec = importlib.util.spec_from_file_location(
    "growth", pathlib.Path(__file__).resolve().parents[2] / "soak" / "growth.py"
)
growth = importlib.util.module_from_spec(spec)
spec.loader.exec_module(growth)


def conclusions(by: float, deviation: float, runs: int = 400) -> collections.Counter:
    """Like the memory of crowds: 600 measurements about a mean of 1, each of which remembers half of the one before; growth in the middle of what
    is left of them without a tenth."""
    shocks = numpy.random.default_rng(1).normal(0.0, deviation, (runs, 600))
    about = numpy.zeros_like(shocks)
    for i in range(600):
        about[:, i] = shocks[:, i] + (0.5 * about[:, i - 1] if i else 0.0)
    return collections.Counter(
        growth.growth_of(1.0 + row + by * (numpy.arange(600) >= 330)).conclusion for row in about
    )


def test_growth_by_the_margin_is_found_and_none_is_flat():
    flat = conclusions(0.0, 0.15)
    assert flat["equivalent"] > 360 and flat["different"] < 32
    by_margin = conclusions(growth.SAME_WITHIN, 0.2)
    assert by_margin["equivalent"] < 32 and by_margin["different"] > 280
    assert conclusions(0.0, 2.0)["inconclusive"] > 360


@pytest.mark.parametrize(
    "measured, conclusion", [([1.0] * 21, "unknown"), ([1.0] * 22, "equivalent"), ([0.0] * 600, "unknown")]
)
def test_short_and_empty_series(measured, conclusion):
    assert growth.growth_of(measured).conclusion == conclusion
