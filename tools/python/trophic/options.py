# SPDX-License-Identifier: MIT
"""The command lines of the verbs: their options, the allowed combinations, and error messages."""
from __future__ import annotations

import argparse
import dataclasses
import difflib
import math
import re
import textwrap
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

from .errors import RunError

_EXIT_CODES = "Exit codes: 0 done; 1 a run or a computation failed; 2 wrong arguments, nothing was started; 3 interrupted by a signal"
_MOST = 2**64 - 1
_WIDTH = 100


@dataclasses.dataclass(frozen=True)
class Verb:
    """A command of `trophic` that Python implements."""

    module: str
    """the module whose run(request) executes the verb; `request` holds the options by name"""
    about: str
    options: Callable[[argparse.ArgumentParser], Any]
    examples: Sequence[str]
    not_with: dict[str, Sequence[str]] = dataclasses.field(default_factory=dict)
    """combinations of options that are refused"""
    needs: dict[str, str] = dataclasses.field(default_factory=dict)


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        message = re.sub(r"^argument (\S+): expected .*", r"\1: needs a value", message)
        message = re.sub(r"^argument (\S+): (?!must)", r"\1 ", message).removeprefix("argument ")
        missing = re.fullmatch(r"the following arguments are required: (\w+).*", message)
        raise RunError(f"{missing[1]} is required" if missing else message)


def parsed(name: str, words: Sequence[str]) -> dict[str, Any]:
    """Returns the options of a verb by name (None if not given), and `who`, which begins messages. Raises RunError for arguments that the verb does not
    take. `--help` prints and exits."""
    if name not in VERBS:
        raise RunError(f"must be {one_of(sorted(VERBS))}")
    verb, who = VERBS[name], f"trophic {name}"
    parser = _Parser(
        who,
        description=textwrap.fill(verb.about, _WIDTH),
        epilog="\n".join([_EXIT_CODES, "", "Examples:", *(f"  {one}" for one in verb.examples)]),
        formatter_class=lambda prog: argparse.RawDescriptionHelpFormatter(prog, max_help_position=26, width=_WIDTH),
        add_help=False,
        allow_abbrev=False,
    )
    verb.options(parser)
    parser.add_argument("-h", "--help", action="help", help="print this help and exit")
    options, extras = parser.parse_known_intermixed_args(words)
    if extras:
        raise RunError(_about_extra(next((one for one in extras if one.startswith("-")), extras[0]), parser))
    request = vars(options)
    given = {
        action.option_strings[-1]: request.get(action.dest) not in (None, False, [])
        for action in parser._actions
        if action.option_strings
    }
    for option, others in verb.not_with.items():
        for other in others:
            if given[option] and given[other]:
                raise RunError(f"{option}: not with {other}")
    for option, other in verb.needs.items():
        if given[option] and not given[other]:
            raise RunError(f"{option}: needs {other}")
    return {**request, "who": who}


def _about_extra(word: str, parser: argparse.ArgumentParser) -> str:
    if not word.startswith("-"):
        return f"{word}: unexpected argument (--help lists all)"
    word = word.split("=")[0]
    return f"{word}: unknown option{did_you_mean(word, [name for action in parser._actions for name in action.option_strings])} (--help lists all)"


def one_of(words: Sequence[str]) -> str:
    """ "a, b or c"."""
    return " or ".join(filter(None, [", ".join(words[:-1]), *words[-1:]]))


def did_you_mean(word: str, words: Sequence[str]) -> str:
    near = difflib.get_close_matches(word, words, 1)
    return f"; did you mean {near[0]}?" if near else ""


# Texts, numbers and words that options take


def _text(text: str) -> str:
    if not text:
        raise argparse.ArgumentTypeError("must not be empty")
    return text


def _whole(text: str, least: int = 0, most: int = _MOST) -> int:
    if re.fullmatch(r"-[0-9]+", text):
        raise argparse.ArgumentTypeError(f"{text}: must be >= {least}")
    if not re.fullmatch(r"0|[1-9][0-9]*", text):
        raise argparse.ArgumentTypeError(f"{text}: must be a whole number in decimal digits")
    for is_wrong, bound in (
        (len(text) > 20 or int(text) > most, f"<= {most}"),
        (len(text) <= 20 and int(text) < least, f">= {least}"),
    ):
        if is_wrong:
            raise argparse.ArgumentTypeError(f"{text}: must be {bound}")
    return int(text)


def _within(least: int, most: int = _MOST) -> Callable[[str], int]:
    return lambda text: _whole(text, least, most)


def _number(text: str) -> float:
    if not re.fullmatch(r"-?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?", text) or len(text) > 1000:
        raise argparse.ArgumentTypeError(f"{text}: must be a number in decimal digits")
    return float(text)


def _positive(text: str) -> float:
    if not 0.0 < (value := _number(text)) < math.inf:
        raise argparse.ArgumentTypeError(f"{text}: must be > 0")
    return value


def _word(*words: str) -> Callable[[str], str]:
    def checked(text: str) -> str:
        if text not in words:
            raise argparse.ArgumentTypeError(f"{text}: must be {one_of(words)}{did_you_mean(text, words)}")
        return text

    return checked


_TEXT: dict[str, Any] = {"type": _text, "metavar": "TEXT"}
_TEXTS: dict[str, Any] = {**_TEXT, "nargs": "+", "action": "extend"}
_FLAG: dict[str, Any] = {"action": "store_true"}
_N: dict[str, Any] = {"type": _whole, "metavar": "N"}
_JOBS: dict[str, Any] = {
    "type": _within(1),
    "metavar": "N",
    "help": "number of runs measured in parallel (default: one per core); results do not depend on it",
}


# The verbs


def _analyze(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add(
        "runs",
        nargs="*",
        type=_text,
        help="folders of runs or of replicates, which are pooled and so must share one fingerprint; or the folder of one sweep",
    )
    add(
        "--compare",
        nargs=2,
        type=_text,
        metavar="TEXT",
        help="two such folders: report the difference of every metric, raw and relative to their nulls",
    )
    add("--shadow", **_TEXT, help="folder of the runs' neutral shadow (default: RUNS/shadow, if it exists)")
    add("--until", type=_positive, metavar="X", help="measure only the first X seconds of every run")
    add(
        "--metric",
        **_TEXTS,
        help="test only these metrics: METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP; fewer tests need fewer runs. `trophic help metrics` "
        "lists the metrics",
    )
    add(
        "--column",
        **_TEXTS,
        help="your own metric: the mean of a column of a CSV table in each run's folder, as FILE:COLUMN or FILE:COLUMN:UNIT, tested like any "
        "metric; may be repeated",
    )
    add(
        "--metric-file",
        **_TEXTS,
        help="your own metrics: a Python file whose functions of a run are decorated with @trophic.metric; may be repeated",
    )
    add(
        "--lineages",
        **_FLAG,
        help="measure lineages instead: the change, novelty, ecology and complexity of persistent types, evolutionary activity and descent, "
        "each compared with its null; docs/how-to/is-it-open-ended.md explains them",
    )
    add(
        "--window",
        type=_positive,
        metavar="X",
        help="for --lineages: seconds for which a type must persist (default: 500, or a quarter of a run if that is shorter)",
    )
    add(
        "--program",
        **_TEXT,
        help="for --lineages: the program that made the runs, which evaluates their brains (default: trophic-predator-prey)",
    )
    add(
        "--bodies",
        **_FLAG,
        help="measure bodies instead: shape, size, number of body plans, genes of gaits and brains, and walking speed; tests for selection "
        "need the runs' neutral null (made with --neutral)",
    )
    add(
        "--selection",
        **_TEXTS,
        help="measure selection on a trait instead, by its episodes, with Price's equation: turns_to, open_speed, velocity_open, gene:NUMBER or "
        "FILE:COLUMN:UNIT; may be repeated; docs/how-to/where-does-selection-act.md explains it",
    )
    add(
        "--accept-other-build",
        **_FLAG,
        help="pool runs made by different builds of a program, whose rules may have the same names but other code",
    )
    add(
        "--published",
        **_FLAG,
        help="state for every published claim whether it is reproduced, not reproduced or inconclusive, under each reading that the paper allows",
    )
    add("--all", **_FLAG, help="print all metrics, not only the clearest findings")
    add(
        "--reference",
        **_N,
        help="for a sweep: number of the cell with which all others are compared (default: the first)",
    )
    add(
        "--difference",
        type=_number,
        metavar="X",
        help="print the number of runs per set that gives 80 %% power to detect a difference of this size in --metric, in the unit of the "
        "tables; choose the smallest effect of interest",
    )
    add("--allow-missing", **_FLAG, help="for a sweep: analyse it without its missing or incomplete runs")
    add("--jobs", **_JOBS)
    add(
        "--out",
        **_TEXT,
        help="new folder for the tables and summary.json (default: analysis, or the next free analysis-1, -2, ...; none if only --html is given)",
    )
    add("--html", **_TEXT, help="write a new HTML page with the table, figures and replays, which opens from disk")
    add("--figures", **_TEXT, help="for the page: folder of figures and captions.json made by `trophic plot`")
    add(
        "--replays",
        type=_within(0, 20),
        metavar="N",
        help="for the page: number of runs per set that it replays, at most 20 (default: 2, if they were recorded)",
    )


def _plot(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("analysis", type=_text, help="folder of an analysis or of a run")
    add(
        "--out",
        **_TEXT,
        help="new folder for the figures (default: figures in that folder, or the next free figures-1, ...)",
    )
    add(
        "--style",
        type=_word("plain", "serif", "ieee"),
        default="plain",
        metavar="TEXT",
        help="fonts and widths: plain, serif or ieee (default: plain)",
    )
    add(
        "--columns",
        type=_within(1, 2),
        default=1,
        metavar="N",
        help="width of a figure in page columns, 1 or 2 (default: 1)",
    )
    add("--with-captions", **_FLAG, help="also draw the captions into the figures")
    add("--run", **_N, help="draw the phylogeny, paths and catch of the N-th run of a set, counted from 0 (default: 0)")
    add(
        "--metric",
        **_TEXTS,
        help="for a sweep: draw only these metrics: METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP",
    )
    add("--axes", **_TEXTS, help="for a sweep: parameters to draw along x, as lines and as panels, in this order")


def _cite(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("run", type=_text, help="folder of a run or of replicates")


def _plan(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("sweep", type=_text, help="sweep file in TOML; docs/how-to/a-sweep.md describes the format")
    add(
        "--program",
        **_TEXT,
        dest="experiment",
        default="trophic-predator-prey",
        help="experiment program that makes the runs (default: trophic-predator-prey)",
    )
    add(
        "--out",
        **_TEXT,
        help="folder for the plan and its runs (default: runs/SWEEP); if it has a plan already, runs are added to it",
    )
    add(
        "--dry-run", **_FLAG, help="print the cells and how long they will take, estimated by short runs; write nothing"
    )
    add("--sbatch", **_N, help="print a Slurm script with N array tasks; short runs estimate its time limit")


def _contest(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("runs", nargs="+", type=_text, help="folders of runs, or of replicates")
    add("--shadow", **_TEXT, help="folder of the runs' neutral shadow (default: RUNS/shadow, if it exists)")
    add("--epochs", **_TEXT, help="comma-separated times, e.g. 0,2000,6000 (default: four, evenly spaced)")
    add(
        "--against",
        type=_word("others", "own", "both"),
        default="others",
        metavar="TEXT",
        help="opponents: others (from other replicates), own (from the same replicate) or both (default: others)",
    )
    add(
        "--panel",
        **_TEXT,
        help="folder of runs whose last living individuals are the opponents in all contests, instead of --against",
    )
    add("--split", type=_number, metavar="X", help="epoch at which the late period begins (default: the middle one)")
    add(
        "--teams",
        type=_whole,
        default=6,
        metavar="N",
        help="teams drawn for each epoch and species, at least 2 (default: 6)",
    )
    add("--team-size", **_N, help="robots per team (default: half of the runs' robots)")
    add(
        "--duration",
        type=_number,
        default=300.0,
        metavar="X",
        help="length of a contest in simulated seconds (default: 300)",
    )
    add(
        "--reach",
        type=_number,
        default=1.0,
        metavar="X",
        help="distance in metres at which a hunter reaches a victim (default: 1)",
    )
    add("--seed", type=_whole, default=1, metavar="N", help="seed of teams, pairings and positions (default: 1)")
    add("--backend", **_TEXT, help="play on this backend, with its default parameters (default: the runs' backend)")
    add(
        "--program",
        **_TEXT,
        dest="experiment",
        default="trophic-predator-prey",
        help="program that made the runs (default: trophic-predator-prey)",
    )
    add(
        "--jobs",
        type=_whole,
        metavar="N",
        help="number of contests in parallel (default: one per core); results do not depend on it",
    )
    add(
        "--record",
        **_FLAG,
        help="also write each contest, of at most 100, as a run in OUT/contest-N, N its row in contests.csv from 0, for trophic show and film",
    )
    add("--accept-other-build", **_FLAG, help="accept runs made by different builds of a program")
    add(
        "--out",
        **_TEXT,
        help="new folder for contests.csv and progress.csv (default: the next free contests, contests-1, ...)",
    )


def _cross_check(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("runs", nargs="+", type=_text, help="two folders of replicates, each on one engine")
    parser.add_argument(
        "--out", **_TEXT, help="new folder for cross_check.csv (default: the next free cross-check, cross-check-1, ...)"
    )


def _help(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "topic", nargs="?", type=_text, help="a command, `slots`, `metrics`, or the name of a slot or a policy"
    )


VERBS = {
    "analyze": Verb(
        "report.analyze",
        "Measures runs: the paper's metrics with 95 % confidence intervals over runs, next to the published values and null models. The "
        "neutral shadow (runs in which nothing is inherited) is read from RUNS/shadow. Metrics of genomes, bodies and brains are compared "
        "with the neutral null in RUNS/neutral, if --neutral made one. In a sweep, each cell is compared with a reference cell, corrected for "
        "the number of comparisons. Needs Python with pandas, scipy and jinja2.",
        _analyze,
        [
            "trophic analyze runs/paper --out analysis",
            "trophic analyze --compare runs/paper runs/released --metric velocity:predator",
            "trophic analyze runs/sweep --reference 3 --jobs 4",
        ],
        {
            "--compare": ["--shadow", "--published"],
            "--lineages": ["--published", "--until", "--compare", "--column", "--metric-file"],
            "--bodies": ["--published", "--lineages"],
            "--published": ["--metric"],
            "--selection": [
                "--compare",
                "--published",
                "--lineages",
                "--bodies",
                "--metric",
                "--column",
                "--metric-file",
                "--html",
            ],
        },
        {"--window": "--lineages", "--program": "--lineages", "--figures": "--html", "--replays": "--html"},
    ),
    "plot": Verb(
        "plot",
        "Draws figures of the output of `trophic analyze` or `trophic cross-check` as PNG and PDF, with captions.json and captions.tex: the "
        "paper's figures, a forest plot of a comparison, response curves and heat maps of a sweep. For the folder of a run it draws the numbers "
        "of each species over time and, with a rule Metabolism, their energy. Needs Python with matplotlib, pandas and scipy.",
        _plot,
        [
            "trophic plot analysis",
            "trophic plot runs/pond",
            "trophic plot analysis --style ieee --out figures",
            "trophic plot analysis/sweep --metric velocity:predator:inherited",
        ],
    ),
    "cite": Verb(
        "cite",
        "Prints how to cite a run or a set of replicates: a sentence with the rule table, changed parameters, engine, version and seed from "
        "its manifest, and BibTeX entries. Needs Python with pandas.",
        _cite,
        ["trophic cite runs/paper"],
    ),
    "plan": Verb(
        "plan",
        "Writes a plan, the list of runs that a sweep file describes: settings from [grid], [zip] and [[runs]], with replicates and nulls. "
        "PROGRAM --plan FOLDER/plan.jsonl makes the runs. Needs Python with numpy and pandas.",
        _plan,
        ["trophic plan sweep.toml --out runs/sweep", "trophic plan sweep.toml --dry-run"],
    ),
    "contest": Verb(
        "contest_plan",
        "Plays contests between hunters of one epoch and victims of another, in the runs' arena but without catches, births and deaths. A "
        "species makes progress if its later hunters reach the victims of all epochs sooner, or if its later victims are reached later. "
        "Progress is global against opponents from other replicates and historical against opponents from the same run. It is compared with "
        "the neutral shadow in RUNS/shadow. Needs Python with pandas and scipy.",
        _contest,
        [
            "trophic contest runs/study",
            "trophic contest runs/study --against both --epochs 0,2000,4000,6000",
            "trophic contest runs/mine --program build/my_experiment",
        ],
    ),
    "cross-check": Verb(
        "cross_check",
        "Compares two engines, or two settings of one engine: the metrics of two sets of runs under the same rules, such as two cells of a "
        "sweep over engines, with two one-sided tests (TOST) for the equivalence of each metric. Needs Python with pandas and scipy.",
        _cross_check,
        ["trophic cross-check runs/engines/cell-000 runs/engines/cell-001 --out engines"],
    ),
    "help": Verb(
        "help",
        "Prints the help of a command; what each slot of a rule table decides (`slots`); the documentation of a slot or a policy; or the list "
        "of metrics (`metrics`).",
        _help,
        ["trophic help analyze", "trophic help slots", "trophic help mutation", "trophic help normal_mutation"],
    ),
}
