# SPDX-License-Identifier: MIT
"""Progress across generations: what contests of hunters of one epoch against victims of another add up to."""
from __future__ import annotations

import dataclasses
import pathlib
from collections.abc import Sequence

import numpy
import pandas

from .errors import RunError, printable
from .statistics import MIN_RUNS_FOR_TEST, Difference, Estimate, adjust_together, contrast, difference_of, estimate
from .values import Metric
from .words import Reading, columns, number_text, p_text
from .writing import csv_text, write_new

AGAINST = ("own", "others", "panel")
"""The origin of the opponents: the same run, another replicate, which they never met, or a panel that all runs meet."""
_OPPONENTS = {"own": "own", "others": "others'", "panel": "the panel's"}
_SECONDS = Reading(Metric("progress", "", "", "ticks"))


@dataclasses.dataclass
class Progress:
    """Progress of a species against opponents of all epochs, over a period, in seconds of contact time: greater is better for both roles. The
    tests over the two roles of one link, period and kind of opponents are corrected together (Holm), and so are their intervals (Bonferroni).
    """

    against: str
    species: str
    role: str
    """hunter or victim"""
    opponent: str
    period: str
    """early: up to the split; late: from there on"""
    from_s: float
    to_s: float
    ours: Estimate
    shadow: Estimate
    over_shadow: Difference
    """empty without a shadow; without interval and test if there are fewer runs than a test needs"""

    def conclusion(self) -> str:
        if self.shadow.runs == 0:
            return "no shadow"
        if self.over_shadow.interval is None or self.over_shadow.value is None:
            return "not tested"
        if not self.over_shadow.differs():
            return "no significant difference"
        return "above the shadow" if self.over_shadow.value > 0.0 else "below the shadow"


def epochs_of(contests: pandas.DataFrame) -> list[float]:
    """The epochs of the runs, s, ascending; not that of a panel."""
    return sorted(
        {
            *contests["hunter_epoch_s"][contests["against"] != "panel_hunters"],
            *contests["victim_epoch_s"][contests["against"] != "panel_victims"],
        }
    )


def progress_of(contests: pandas.DataFrame, split_s: float | None = None) -> list[Progress]:
    """The progress that the rows of contests.csv show: early from the first epoch to `split_s`, late from there to the last. The split is one of
    the epochs, by default that in the middle, of an even number the earlier one; a split at an end leaves one period. Raises RunError for another
    split and for fewer than two epochs."""
    epochs = epochs_of(contests)
    if len(epochs) < 2:
        raise RunError(f"contests of {len(epochs)} epochs: must be of at least two")
    split_s = epochs[(len(epochs) - 1) // 2] if split_s is None else split_s
    if split_s not in epochs:
        raise RunError(
            f"--split {number_text(split_s)}: must be one of the epochs, {', '.join(map(number_text, epochs))} s"
        )
    periods = [("early", epochs[0], split_s), ("late", split_s, epochs[-1])]
    found = []
    for against in AGAINST:
        for (hunter, victim), link in contests[contests["against"].str.split("_").str[0] == against].groupby(
            ["hunter", "victim"]
        ):
            sets = [link[link["shadow"] == of_shadow] for of_shadow in (0, 1)]
            for period, from_s, to_s in periods:
                if from_s == to_s:
                    continue
                both = []
                for role, names in (("hunter", (hunter, victim)), ("victim", (victim, hunter))):
                    own = [
                        of[of["against"] != f"panel_{role}s"] for of in sets
                    ]  # where the role is the panel's, the other one is ours
                    ours, shadow = (progress_of_runs(of_set, role, epochs, from_s, to_s) for of_set in own)
                    value = ours.mean() - shadow.mean() if len(ours) and len(shadow) else None
                    over = difference_of(value, contrast((1.0, ours), (-1.0, shadow)))
                    both.append(
                        Progress(
                            against,
                            names[0],
                            role,
                            names[1],
                            period,
                            from_s,
                            to_s,
                            estimate(ours),
                            estimate(shadow),
                            over,
                        )
                    )
                adjust_together([each.over_shadow for each in both])
                found += both
    return found


def progress_of_runs(
    contests: pandas.DataFrame, role: str, epochs: Sequence[float], from_s: float, to_s: float
) -> numpy.ndarray:
    """For each run of the species in a role, the mean over opponents of all epochs of how much sooner (hunter) or later (victim) contact is at `to_s`
    than at `from_s`, s. The contact time of a pair of epochs is the mean over teams. A run that lacks a contest is left out.
    """
    runs, names = pandas.factorize(contests[f"{role}s_run"], sort=True)
    own = numpy.searchsorted(epochs, contests[f"{role}_epoch_s"])
    other, others = pandas.factorize(contests["victim_epoch_s" if role == "hunter" else "hunter_epoch_s"])
    shape = (len(names), len(epochs), max(1, len(others)))
    cells = numpy.ravel_multi_index((runs, own, other), shape)
    number, sum_s = (
        numpy.bincount(cells, weights, numpy.prod(shape)).reshape(shape) for weights in (None, contests["contact_s"])
    )
    with numpy.errstate(invalid="ignore"):
        contact_s = sum_s / number
    later_s = (contact_s[:, list(epochs).index(to_s)] - contact_s[:, list(epochs).index(from_s)]).mean(axis=1)
    return (-later_s if role == "hunter" else later_s)[~numpy.isnan(later_s)]


def table(progress: Sequence[Progress]) -> pandas.DataFrame:
    """progress.csv: one row per species, role, kind of opponents and period."""
    lower, upper = (lambda interval, place=place: None if interval is None else interval[place] for place in (0, 1))
    return pandas.DataFrame(
        [
            {
                "against": one.against,
                "species": one.species,
                "role": one.role,
                "opponent": one.opponent,
                "period": one.period,
                "from_s": one.from_s,
                "to_s": one.to_s,
                "runs": one.ours.runs,
                "mean_s": one.ours.mean,
                "lower_s": lower(one.ours.interval),
                "upper_s": upper(one.ours.interval),
                "shadow_runs": one.shadow.runs,
                "shadow_s": one.shadow.mean,
                "over_shadow_s": one.over_shadow.value,
                "over_shadow_lower_s": lower(one.over_shadow.interval),
                "over_shadow_upper_s": upper(one.over_shadow.interval),
                "p": one.over_shadow.p,
                "p_holm": one.over_shadow.adjusted,
                "lower_corrected_s": lower(one.over_shadow.corrected),
                "upper_corrected_s": upper(one.over_shadow.corrected),
            }
            for one in progress
        ]
    )


def text(progress: Sequence[Progress]) -> str:
    """A line for each, and how many runs a test needs if there are too few."""
    rows: list[tuple[str, ...]] = [
        (
            "progress of",
            "against",
            "from",
            "to",
            "mean, s",
            "shadow",
            "over the shadow [95 %]",
            "p (Holm)",
            "conclusion",
        )
    ]
    for one in progress:
        over = one.over_shadow
        rows.append(
            (
                one.species,
                f"{_OPPONENTS[one.against]} {one.opponent}",
                *(number_text(round(epoch_s, 1)) for epoch_s in (one.from_s, one.to_s)),
                _SECONDS.of(one.ours),
                _SECONDS.of(one.shadow),
                _SECONDS.with_interval(over.value, over.corrected or over.interval, True),
                p_text(over.adjusted),
                one.conclusion(),
            )
        )
    fewest = min(
        (runs for one in progress for runs in (one.ours.runs, one.shadow.runs or one.ours.runs)),
        default=MIN_RUNS_FOR_TEST,
    )
    few = (
        f"{fewest} replicates: too few for intervals and tests, which need {MIN_RUNS_FOR_TEST}\n"
        if fewest < MIN_RUNS_FOR_TEST
        else ""
    )
    return columns(rows) + few


def report(folder: pathlib.Path, request: dict, taken_s: float) -> str:
    """Reads FOLDER/contests.csv, writes FOLDER/progress.csv and returns the progress as a text. `taken_s`: the time that playing took."""
    contests = pandas.read_csv(
        folder / "contests.csv",
        dtype={name: str for name in ("hunters_run", "victims_run", "hunter", "victim")},
        float_precision="round_trip",
        keep_default_na=False,
    )
    progress = progress_of(contests, request["split"])
    write_new(folder / "progress.csv", csv_text(table(progress)))
    return text(progress) + (
        f"tables  {printable(str(folder.with_suffix('')))}/contests.csv, progress.csv: {len(contests)} contests of "
        f"{number_text(request['duration'])} s in {number_text(round(taken_s, 1))} s\n"
    )
