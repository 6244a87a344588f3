# SPDX-License-Identifier: MIT
"""The measures of change of the Red Queen study on hand-written runs."""
import math
import types

import change
import numpy
import pandas
import pytest


def run_of(genome_ids):
    """Two prey of 60 s: one lives throughout, the other is born at 25 s. They hold these genomes; windows are 20 to 30 s and 50 to 60 s."""
    tables = {
        "genomes": pandas.DataFrame({"id": [0, 1], "genome_id": genome_ids, "time_s": [0.0, 25.0]}),
        "phylogeny": pandas.DataFrame(
            {"id": [0, 1], "species": "prey", "origin_time": [0.0, 25.0], "destruction_time": math.inf}
        ),
    }
    return types.SimpleNamespace(
        table=tables.__getitem__, manifest={"species": ["prey", "predator"], "result": {"reached_s": 60.0}}
    )


@pytest.mark.parametrize(
    "genome_ids, early, late",
    [
        ([0, 1], (10 * 1.0 + 5 * 3.0) / 15, 2.0),  # a genome each
        ([0, 0], (5 * 1.0 + 10 * 3.0) / 15, 3.0),  # both have the values of the birth, from then on
    ],
)
def test_the_mean_moves_as_the_living_and_what_they_share(genome_ids, early, late):
    (prey, moved), (predator, none) = change.moved(run_of(genome_ids), numpy.array([[1.0], [3.0]]))
    assert (prey, predator) == ("prey", "predator") and moved == pytest.approx(late - early) and math.isnan(none)
