# SPDX-License-Identifier: MIT
"""The controls: for each measure and kind of world the null that is asked, and why. All that compares runs with a null asks here.

The right null differs from the runs by the effect alone. Which one does depends on what is measured and on whether numbers change; RULES has each case.
A measure without the runs of its null, or that no null fits, is described and not tested, and `Control.not_tested` says why."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy

from .metrics import kinds
from .metrics.living import changes_numbers
from .statistics import Lives
from .values import NEUTRAL, ONE_SIDED, SHADOW, MeasuredSet, Metric

SURVIVAL = ("extinct_at",)
"""Metrics of when something ends: the log-rank test and the restricted mean, with runs in which it does not end censored."""
SHARES = ("persists", "extinct", "cycles")
"""0 or 1 in each run, so that means are shares of runs: Fisher's exact test."""
_BEHAVIOUR = (
    "velocity",
    "wall_",
    "tag_",
    "walked",
    "open_speed",
    "upright_speed",
    "overturned",
    "stuck",
    "locked",
    "near_",
)
_MIXED = ("all", "random", "inherited")
"""Groups that have active and inactive members."""


class Rule(NamedTuple):
    """A case: which null answers, and why."""

    measures: str
    """whose control it is"""
    null: str
    why: str
    """a clause"""
    option: str
    """makes the runs of the null"""

    def sentence(self) -> str:
        return f"{self.measures} over {_THE[self.null]}: {self.why}"


_THE = {SHADOW: "the shadow", ONE_SIDED: "the one-sided world of their species", NEUTRAL: "the neutral null"}
RULES = {
    "inherited": Rule(
        "genomes, bodies and brains",
        NEUTRAL,
        "they change by mutation and drift alone, which it has and the shadow does not",
        "--neutral",
    ),
    "constant": Rule("behaviour and counts", SHADOW, "numbers are constant, so only inheritance differs", "--shadow"),
    "changing": Rule(
        "measures of one species",
        ONE_SIDED,
        "numbers change, and in the shadow the other species does not evolve either",
        "--one-sided",
    ),
    "several": Rule(
        "measures of several species",
        SHADOW,
        "none inherits there, so they show what the inheritance of all does together",
        "--shadow",
    ),
    "alone": Rule(
        "measures of the only species", SHADOW, "without another species it is the one-sided world", "--shadow"
    ),
}
MIXED = "it mixes active and inactive members, whose shares change with the numbers; the groups active and inactive are tested apart"


BY_RUN = "each is a conclusion about one run"
_WHOSE = {MIXED: "behaviour of a mixed group", BY_RUN: "kinds and their p values"}


class Control(NamedTuple):
    """The control of a metric of a set."""

    rule: Rule
    null: str
    """the null that it is tested against; empty if it is not tested against any"""
    not_tested: str
    """why it is not; empty if it is"""


def control_of(of: MeasuredSet, metric: Metric) -> Control:
    """The null that answers for a metric of a set, as far as the set has it."""
    rule = RULES[_case(of, metric)]
    if metric.metric in kinds.DESCRIBED:
        return Control(rule, "", BY_RUN)
    if rule.null not in of.nulls_of(metric):
        described = (
            "; mutation alone makes a difference from the shadow, which is described" if rule.null == NEUTRAL else ""
        )
        if rule.null == ONE_SIDED:
            described = "; the shadow's numbers differ, so it is described"
        return Control(rule, "", f"no {_TITLES[rule.null]}: {rule.option} makes {_IT[rule.null]}{described}")
    if _is_mixed(of, metric):
        return Control(rule, "", MIXED)
    return Control(rule, rule.null, "")


_TITLES = {SHADOW: "shadow", ONE_SIDED: "one-sided worlds", NEUTRAL: "neutral null"}
_IT = {SHADOW: "one", ONE_SIDED: "them", NEUTRAL: "one"}


def _case(of: MeasuredSet, metric: Metric) -> str:
    if metric.metric in of.inherited:
        return "inherited"
    if not changes_numbers(of.runs[0]):  # type: ignore[arg-type]
        return "constant"
    species = of.runs[0].manifest.get("species", [])
    return "several" if metric.species not in species else "changing" if len(species) > 1 else "alone"


def _is_mixed(of: MeasuredSet, metric: Metric) -> bool:
    """Whether a metric of behaviour is over a group with active and inactive members, in a world whose numbers change."""
    if metric.group not in _MIXED or not metric.metric.startswith(_BEHAVIOUR) or _case(of, metric) == "constant":
        return False
    inactive = {
        name.species
        for (name, baseline), values in of.table.items()
        if name[::2] == ("velocity", "inactive") and not baseline and not numpy.isnan(values).all()
    }
    whose = set(metric.species.replace("-", "+").split("+"))
    return bool(inactive if whose == {"all"} else inactive & whose)


def lack(*sets: Sequence[float] | numpy.ndarray) -> str:
    """Why a mean over those runs of these sets that have a value is not tested; empty if all have one, or none has. A run lacks a value if what it
    measures did not happen, so that those that have one are chosen by their outcome."""
    has = [int((~numpy.isnan(numpy.asarray(values, float))).sum()) for values in sets]
    if not any(has) or all(count == len(values) for count, values in zip(has, sets)):
        return ""
    shares = " and ".join(f"{count} of {len(values)}" for count, values in zip(has, sets))
    return f"only {shares} runs have a value: a mean over the runs in which it happened is only described"


def lives_of(of: MeasuredSet, metric: Metric) -> Lives:
    """How long a species lives in each run in which it was there: a metric of SURVIVAL as censored values."""
    died_s = of.baseline(metric, "")
    ends_s = numpy.array([getattr(run, "lived_s", of.until_s) for run in of.runs], float)
    persists = of.table.get((metric._replace(metric="persists", unit="1"), ""))
    died = ~numpy.isnan(died_s)
    was_there = died | (ends_s < of.until_s) | (True if persists is None else ~numpy.isnan(persists))
    return Lives(numpy.where(died, died_s, ends_s)[was_there], died[was_there], of.until_s)


def sentences(of: MeasuredSet, metrics: Iterable[Metric]) -> list[str]:
    """Which nulls answer for these metrics and why, and what is not tested and why: a sentence each."""
    found = [control_of(of, metric) for metric in metrics]
    said = dict.fromkeys(f"tested: {one.rule.sentence()}" for one in found if one.null)
    why = dict.fromkeys(
        (_WHOSE.get(one.not_tested, one.rule.measures), one.not_tested) for one in found if one.not_tested
    )
    return [*said, *(f"not tested: {measures}: {reason}" for measures, reason in why)]
