# SPDX-License-Identifier: MIT
"""docs/tables.md is made from the columns of the code: those of the programs first, then those of the Python module."""
import pathlib

import pytest
from trophic.report import columns

PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs" / "tables.md"


def test_the_page_ends_with_the_tables_of_the_module():
    assert PAGE.read_text().endswith(columns.document())


@pytest.mark.parametrize(
    "name, expected",
    [
        ("species", columns.Column("species", "", "text", "the species measured; prey+predator for a metric of both")),
        (
            "time_s",
            columns.Column(
                "time_s",
                "s",
                "number, exact, or empty",
                "end of the window, for a curve; empty for a value of the whole run",
            ),
        ),
        (
            "value",
            columns.Column(
                "value", "", "number, exact, or empty", "value in `unit`; empty if it could not be computed"
            ),
        ),
    ],
)
def test_a_line_is_read_with_cells_unit_and_meaning(name, expected):
    assert next(column for column in columns.TABLES["metrics.csv"][1] if column.name == name) == expected


@pytest.mark.parametrize("file", columns.TABLES)
def test_columns_have_names_of_their_own_and_a_meaning(file):
    _, of_file = columns.TABLES[file]
    assert len(set(columns.names(file))) == len(of_file) > 5
    assert all(column.meaning and column.name.isidentifier() for column in of_file)
