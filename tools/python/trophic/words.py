# SPDX-License-Identifier: MIT
"""Numbers, metrics and tests as people read them, and texts as LaTeX and the terminal show them."""
from __future__ import annotations

import decimal
import unicodedata
from collections.abc import Iterable, Sequence

from .errors import printable
from .statistics import MOST_RUNS, Estimate
from .values import CLONES, NEUTRAL, ONE_SIDED, SHADOW, Metric, one_sided_species

_PLAIN_UNITS = (
    "",
    "1",
    "ticks",
)  # shares and counts; hunger in ticks is a metric of trophic's own, whose unit the glossary gives
_DECIMALS = {
    **dict.fromkeys(
        ("deaths", "population", "extinct_at", "period", "generation_time", "handling_time", "lineage_depth", "stock"),
        1,
    ),
    "birth_rate": 5,
    "search_rate": 4,
    "search_rate_holling": 4,
}
NULLS = {SHADOW: "shadow", ONE_SIDED: "one-sided world", NEUTRAL: "neutral null", CLONES: "clones"}
"""The nulls that are runs of their own. A null that each run has by itself has its own name."""
NO_NEUTRAL = (
    "no neutral null: what is inherited changes by mutation alone, so a difference from the shadow need not be selection (--replicates with "
    "--neutral makes one)"
)
_SHOWN = {
    SHADOW: "what inheritance does",
    ONE_SIDED: "what the inheritance of each species does",
    NEUTRAL: "what selection does",
}


def over_nulls(compared: Iterable[str]) -> tuple[str, str, str]:
    """("over shadows: (b - shadow) - (a - shadow)", "over shadows", "what inheritance does"), or the same of all nulls that two sets were compared
    over. Empty texts for raw differences."""
    titles = {name: title for name, title in NULLS.items() if f"over_{name}" in set(compared)}
    short = "" if not titles else "over nulls" if len(titles) > 1 else f"over {[*titles.values()][0]}s"
    whole = ", ".join(f"over {title}s: (b - {title}) - (a - {title})" for title in titles.values())
    return whole, short, ", ".join(_SHOWN[name] for name in titles)


def null_title(name: str) -> str:
    """The title of a null by the name of its baseline or folder: "shadow", "one-sided world (prey)"; its own name for any other."""
    species = one_sided_species(name)
    return f"{NULLS[ONE_SIDED]} ({species})" if species else NULLS.get(name, name)


def over_text(compared: str) -> str:
    """The basis of a comparison of two sets: "over the shadow", "over the neutral null" or "raw"."""
    return f"over the {NULLS[compared.removeprefix('over_')]}" if compared.startswith("over_") else compared


def excerpt(text: str) -> str:
    """A text to be quoted in a sentence: its beginning, if it is long."""
    return text if len(text) <= 100 else f"{text[:100]}..."


def number_text(value: float | int | None) -> str:
    """The fewest digits that read back as the same number, as trophic's tables have them; empty for None and nan."""
    if value is None or value != value:
        return ""
    if isinstance(value, (bool, int)):
        return str(int(value))
    text = repr(float(value))
    if "e" not in text and not text.endswith(".0") and abs(value) >= 0.001 or text in ("inf", "-inf"):
        return text
    sign, digits, exponent = decimal.Decimal(text).normalize().as_tuple()
    first, rest = str(digits[0]), "".join(map(str, digits[1:]))
    power = int(exponent) + len(rest)
    scientific = f"{'-' * sign}{first}{'.' * bool(rest)}{rest}e{'-' if power < 0 else '+'}{abs(power):02}"
    plain = format(decimal.Decimal(text).normalize(), "f")
    return plain if len(plain) <= len(scientific) else scientific


def metric_title(metric: Metric) -> str:
    """The name and the unit that is not plain: "velocity prey (random), cm/s"."""
    group = "" if metric.group in ("", "all") else f" ({metric.group})"
    unit = ", cm/s" if metric.unit == "m/s" else "" if metric.unit in _PLAIN_UNITS else f", {metric.unit}"
    return f"{metric.metric}{' ' * bool(metric.species)}{metric.species}{group}{unit}"


class Reading:
    """A metric's values in the unit that people read: velocities in cm/s, shares with three decimals, counts with one."""

    def __init__(self, metric: Metric):
        self.factor = 100.0 if metric.unit == "m/s" else 1.0
        self.decimals = 2 if metric.unit == "m/s" else 1 if metric.unit == "ticks" else _DECIMALS.get(metric.metric, 3)
        self.unit = "cm/s" if metric.unit == "m/s" else "" if metric.unit in _PLAIN_UNITS else metric.unit

    def __call__(self, value: float | None, sign: bool = False) -> str:
        if value is None or value != value:
            return "missing"
        return self._written(value, self.decimals, sign)

    def with_interval(self, value: float | None, interval: Sequence[float] | None, sign: bool = False) -> str:
        """ "+1.10 [+0.85, +1.35]"; an interval of None or nan is left out. Decimals are added, six at most, if a part would be written as
        zero that is not."""
        if interval is None or value is None or value != value or interval[0] is None or interval[0] != interval[0]:
            return self(value, sign)
        parts, decimals = (value, *interval[:2]), self.decimals
        while decimals < self.decimals + 6 and any(
            part and float(self._written(part, decimals)) == 0.0 for part in parts
        ):
            decimals += 1
        middle, low, high = (self._written(part, decimals, sign) for part in parts)
        return f"{middle} [{low}, {high}]"

    def _written(self, value: float, decimals: int, sign: bool = False) -> str:
        """A number that rounds to zero has no sign."""
        text = f"{self.factor * value:{'+' * sign}.{decimals}f}"
        return text.lstrip("+-") if float(text) == 0.0 else text

    def of(self, estimate: Estimate | Sequence) -> str:
        """A mean with its interval, or with the spread between runs if there are too few for one."""
        _, mean, deviation, interval = estimate
        if interval is not None and interval[0] == interval[0] or deviation is None or deviation != deviation:
            return self.with_interval(mean, interval)
        return f"{self(mean)} (sd {self(deviation)})"


def p_text(p: float | None) -> str:
    """ "0.032", "<0.001"; empty without a p value."""
    if p is None or p != p:
        return ""
    return "<0.001" if p < 0.0005 else f"{p:.3f}"


def runs_text(runs: float | None) -> str:
    """How many runs are needed: "34", or "more than 1000000" for None."""
    return f"more than {MOST_RUNS}" if runs is None or runs != runs else str(int(runs))


_LATEX = {
    "\\": r"\textbackslash{}",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    "_": r"\_\allowbreak{}",
    "/": r"/\allowbreak{}",
    **{letter: "\\" + letter for letter in "{}$&#%"},
}


def latex_text(text: str) -> str:
    """The text as LaTeX shows it letter by letter. Quotation marks open and close, a line may break after _ and /, and control characters are
    written as \\x0a."""
    text = printable(text)
    quotes = iter(("``", "''") * text.count('"'))
    return "".join(next(quotes) if letter == '"' else _LATEX.get(letter, letter) for letter in text)


def one_line(text: str) -> str:
    """The text for a comment or a cell: blanks for all that some reader takes for the end of a line."""
    return " ".join(text.split())


def width_of(text: str) -> int:
    """Columns of a text on the terminal: wide characters take two, combining ones none."""
    return sum(
        0 if unicodedata.combining(letter) else 2 if unicodedata.east_asian_width(letter) in "WF" else 1
        for letter in text
    )


def columns(rows: Iterable[Sequence[str]], indent: str = "") -> str:
    """Rows of cells as lines, each column as wide as its widest cell and two blanks from the next. No line ends with a blank. A row of one cell
    is a heading, which no column has to hold."""
    rows = [list(row) for row in rows]
    widths: list[int] = []
    for row in rows:
        if len(row) > 1:
            widths += [0] * (len(row) - len(widths))
            widths[: len(row)] = [max(width, width_of(cell)) for width, cell in zip(widths, row)]
    lines = []
    for row in rows:
        cells = row if len(row) == 1 else [cell + " " * (width - width_of(cell)) for cell, width in zip(row, widths)]
        lines.append((indent + "  ".join(cells)).rstrip(" ") + "\n")
    return "".join(lines)
