# SPDX-License-Identifier: MIT
"""Numbers, metrics and texts as people, LaTeX and the terminal show them."""
import math

import pytest
from trophic.statistics import Estimate, Interval
from trophic.values import Metric
from trophic.words import Reading, columns, latex_text, metric_title, number_text, one_line, p_text, width_of

VELOCITY = Reading(Metric("velocity", "prey", "all", "m/s"))
SHARE = Reading(Metric("stuck", "prey", "all", "1"))
ODD = r'50 % of "A & B" {$5} #1 a_b ^ ~ \ <c|d> *'


@pytest.mark.parametrize(
    "value, text",
    [
        (6000.0, "6000"),
        (0.1, "0.1"),
        (1e5, "1e+05"),
        (123456.0, "123456"),
        (1e-4, "1e-04"),
        (0.001, "0.001"),
        (0.00012345, "0.00012345"),
        (-2.5e-07, "-2.5e-07"),
        (1 / 3, "0.3333333333333333"),
        (0.0, "0"),
        (7, "7"),
        (1e22, "1e+22"),
        (math.nan, ""),
        (None, ""),
    ],
)
def test_number_text_has_the_fewest_digits_that_read_back(value, text):
    assert number_text(value) == text
    assert not text or float(text) == value


def test_values_are_read_in_handy_units():
    assert VELOCITY(0.01234) == "1.23" and VELOCITY(0.01, True) == "+1.00" and VELOCITY.unit == "cm/s"
    assert Reading(Metric("deaths", "prey", "all", "1"))(12.0) == "12.0"
    assert Reading(Metric("hunger", "prey", "all", "ticks"))(1.25) == "1.2"
    assert SHARE(0.25) == "0.250" and SHARE.unit == ""
    assert VELOCITY(None) == VELOCITY(math.nan) == "missing"


@pytest.mark.parametrize(
    "estimate, text",
    [
        (Estimate(6, 0.5, 0.1, Interval(0.4, 0.6)), "0.500 [0.400, 0.600]"),
        (Estimate(2, 0.5, 0.1, None), "0.500 (sd 0.100)"),
        (Estimate(1, 0.5, None, None), "0.500"),
        (Estimate(0, None, None, None), "missing"),
        (Estimate(0, math.nan, math.nan, (math.nan, math.nan)), "missing"),
    ],
)
def test_mean_is_read_with_its_interval_or_its_spread_or_alone(estimate, text):
    assert SHARE.of(estimate) == text


def test_title_names_the_group_and_the_unit_that_is_not_plain():
    assert metric_title(Metric("velocity", "prey", "random", "m/s")) == "velocity prey (random), cm/s"
    assert metric_title(Metric("stuck", "all", "all", "1")) == "stuck all"
    assert metric_title(Metric("mine", "", "", "J")) == "mine, J"


@pytest.mark.parametrize("p, text", [(None, ""), (math.nan, ""), (0.0004, "<0.001"), (0.0319, "0.032"), (1.0, "1.000")])
def test_p_values(p, text):
    assert p_text(p) == text


def test_special_characters_show_letter_by_letter():
    assert latex_text(ODD) == (
        r"50 \% of ``A \& B'' \{\$5\} \#1 a\_\allowbreak{}b \textasciicircum{} \textasciitilde{} \textbackslash{} "
        r"\textless{}c\textbar{}d\textgreater{} *"
    )
    assert latex_text("a/b") == r"a/\allowbreak{}b"
    assert one_line("% a\r\\input{b}\u2028\x85c") == r"% a \input{b} c"


def test_columns_are_as_wide_as_the_widest_cell_and_headings_hold_none():
    rows = [
        ["metric", "mean", "p"],
        ["a long name of a metric"],
        ["deaths", "1.5", ""],
        ["m² of floor", "10.25", "0.01"],
        ["日本", "1"],
    ]
    lines = columns(rows, "  ").splitlines()
    assert [line.split() for line in lines] == [" ".join(row).split() for row in rows]
    starts = [
        width_of(line[: line.index(cell)]) for line, cell in zip([lines[0], *lines[2:]], ["mean", "1.5", "10.25", "1"])
    ]
    assert len(set(starts)) == 1, starts
    assert width_of("日本") == 4 and width_of("e\u0301") == 1
