# SPDX-License-Identifier: MIT
"""The tables that the module writes: every column with its unit, cells and meaning. docs/tables.md is generated from them:
`python3 -m trophic.report.columns` prints its part."""
from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

_CELLS = {"text": "text", "whole": "whole number", "exact": "number, exact", "flag": "0 or 1"}
# Columns that several tables have.
_SHARED = """
metric text: what was measured
species text: the species measured; prey+predator for a metric of both
group text: as in metrics.csv
unit text: unit of means, differences and intervals
p: p value of this comparison alone
lower_corrected: lower end of the 95 % interval that holds for all comparisons at once (Bonferroni)
upper_corrected: upper end of the same interval
scatter: standard deviation of the difference per run: with n runs in each set its standard error is scatter / sqrt(n); designs compute numbers of runs from it
not_tested text: why the difference is only described and not tested; empty if it is tested, or if another null is the control
significant text: yes if p_holm <= 0.05, else no; empty without a p value
"""
# The content of each file and one line per column, "name cells unit: meaning". By default cells are exact numbers or empty, without a unit. A ?
# marks cells that may be empty; a name alone refers to a column of _SHARED.
_TABLES = {
    "metrics.csv": (
        "Results of the analysis: every value and every curve of every run, one value per row.",
        """
set text: name of the rule table, with the parameters that differ from it
run text: name of the run's folder
seed whole: seed of the run
metric
species
group text: all, random, inherited, active or inactive (at that tick), inherited_active, inherited_inactive; a cause for deaths, a number of members for ticks_at
baseline text: empty for an observed value; shadow, one_sided_SPECIES, neutral or clones for a value observed in that null of the set
time_s exact? s: end of the window, for a curve; empty for a value of the whole run
value: value in `unit`; empty if it could not be computed
unit text: unit of the value; 1 for shares and counts
""",
    ),
    "means.csv": (
        "Each metric of a set with each of its nulls, for tables in a paper.",
        """
set text: name of the rule table, with the parameters that differ from it
metric
species
group
unit
n whole: number of runs in which it could be measured
mean: mean over these runs; for extinct_at the restricted mean time that the species lasts, up to the common end of the set and its nulls
deviation: standard deviation between these runs
lower: lower end of the mean's 95 % interval; empty for fewer than 6 runs
upper: upper end of the mean's 95 % interval
published: the paper's mean, for the paper's rule tables; empty if it has none
null text: shadow, one_sided (of this species), neutral or clones, which are runs, or the name of a null computed from each run; empty without a null
null_n whole: number of runs that give the null
null_mean: mean over these runs
difference: mean - null_mean; for neutral and nulls computed from each run, over the runs that have both
difference_lower: lower end of its own 95 % interval
difference_upper: upper end of its own 95 % interval
p: p value of this comparison alone, of the log-rank test for extinct_at; empty if it is not tested
p_holm: p value corrected for all comparisons of the set; significant if <= 0.05; empty if another null is the control
lower_corrected
upper_corrected
scatter
not_tested
same_as text: an earlier metric that is equivalent (another reading, or equal in every run); the metric is then not compared again
""",
    ),
    "survival.csv": (
        "Survival of species in worlds whose numbers change (Kaplan and Meier): one row per time at which a species dies out in a run.",
        """
set text: name of the rule table, with the parameters that differ from it
null text: empty for the set; shadow, one_sided_SPECIES, neutral or clones for that null
species text: the species that dies out
time_s exact s: time of the extinction
at_risk whole: number of runs in which it lived until then
extinctions whole: number of runs in which it dies out then
survival: share of runs in which it survives
lower: lower end of its 95 % interval, by Greenwood's error of log(-log); empty if the share is 0
upper: upper end of the same interval
""",
    ),
    "differences.csv": (
        "Each metric of two compared sets.",
        """
metric
species
group
unit
compared text: over_shadow: (b - its shadow) - (a - its shadow), the controlled difference; over_one_sided, over_neutral: the same with these nulls; raw: b - a
n_a whole: number of runs in the first set
n_b whole: number of runs in the second set
mean_a: raw mean of the first set; for extinct_at the restricted mean up to the common end of both sets
mean_b: raw mean of the second set
difference: the difference that `compared` names
lower: lower end of this comparison's own 95 % interval; empty for fewer than 6 runs
upper: upper end of this comparison's own 95 % interval
p: p value of this comparison alone, of the log-rank test for extinct_at; empty if it is not tested
p_holm: p value corrected for all comparisons; significant if <= 0.05; raw differences are corrected separately if there are controlled ones
lower_corrected
upper_corrected
scatter
not_tested
same_as text: an earlier metric that is equivalent (another reading, or equal in every run); the metric is then not compared again
""",
    ),
    "cells.csv": (
        "The cells of a sweep. These columns are followed by one for each setting that varies between cells, named by its path.",
        """
cell whole: number of the cell
rule_table text: rule table of its runs
engine text: engine of its runs
runs whole: number of measured runs
runs_planned whole: number of planned runs
shadow_runs whole: number of measured runs of its neutral shadow
until_s exact s: measured time of each run
""",
    ),
    "runs.csv": (
        "Results of the analysis of a sweep: one value of one run per row.",
        """
run whole: its index in the plan
cell whole: the number of its cell
replicate whole: its number in the cell
null text: none, or the name of the cell's null to which the run belongs, shadow or one_sided_SPECIES
seed whole: seed of the run
metric text: what was measured; a metric without a value has no row
species
group
value exact: value in the metric's unit, as in sweep_metrics.csv
""",
    ),
    "sweep_metrics.csv": (
        "Each metric of each cell of a sweep, raw and relative to its shadow.",
        """
cell whole: the number of the cell
metric
species
group
unit text: unit of all values in the row; 1 for shares and counts
runs whole: number of runs in which it could be measured
mean: mean over these runs
deviation: standard deviation between these runs
lower: lower end of the mean's 95 % interval; empty for fewer than 6 runs
upper: upper end of the mean's 95 % interval
shadow_runs whole: number of runs of the neutral shadow in which it could be measured
shadow: mean over these runs
pairs whole: number of pairs of a run and a shadow with the same seed that both have a value
over_shadow: mean of run - shadow over these pairs
over_lower: lower end of the 95 % interval of over_shadow; empty for fewer than 6 pairs
over_upper: upper end of the 95 % interval of over_shadow
""",
    ),
    "sweep_differences.csv": (
        "Each metric of each cell of a sweep, compared with the reference cell.",
        """
cell whole: the number of the cell
reference whole: the number of the reference cell
metric
species
group
unit
compared text: over_shadow: each run relative to its shadow, the controlled difference; raw: not relative to a shadow
design text: paired: seed by seed, Student's t; independent: different seeds in each cell, Welch's t; exact: shares of runs, Fisher's test
runs whole: number of compared runs of the cell; in a paired sweep, of pairs
runs_reference whole: number of compared runs of the reference cell
mean: mean over the cell's runs
mean_reference: mean over the reference cell's runs
difference: mean - mean_reference
lower: lower end of this comparison's own 95 % interval; empty for fewer than 6 runs
upper: upper end of this comparison's own 95 % interval
lower_corrected
upper_corrected
p
p_holm: p value corrected for all comparisons of the analysis; raw differences are corrected separately if there are controlled ones
significant
hedges_g: the difference divided by the pooled standard deviation between runs of both cells, corrected for small samples
smallest_detectable: the difference that this number of runs detects with 80 % power at the corrected level
""",
    ),
    "sweep_effects.csv": (
        "The effect of each value of an axis on each metric, averaged over the other axes.",
        """
axis text: what varies: a setting's path, rule_table or engine
value text: value of the axis
reference text: value of the axis in the reference cell
metric
species
group
unit
compared text: over_shadow: each run relative to its shadow, the controlled difference; raw: not relative to a shadow
settings whole: number of settings of the other axes over which the effect is averaged
seeds whole: number of seeds with a value in all of these cells
mean: mean over settings and seeds with the axis at this value
mean_reference: mean with the axis at the reference cell's value
difference: mean - mean_reference
lower: lower end of this effect's own 95 % interval over seeds; empty for fewer than 6
upper: upper end of this effect's own 95 % interval
p: p value of this effect alone
p_holm: p value corrected for all effects of the analysis; raw differences are corrected separately if there are controlled ones
lower_corrected
upper_corrected
significant
""",
    ),
    "contests.csv": (
        "Results of `trophic contest`: one row per contest of two teams.",
        """
shadow 0/1: whether both teams are from the neutral shadow
against own,others,panel_victims,panel_hunters: own: both teams are from the same run; others: they are from different replicates; panel_victims or panel_hunters: that team is from the panel
hunters_run text: folder of the run of the hunters
victims_run text: folder of the run of the victims
team whole: number of both teams, counted from 0
hunter text: species of the hunters
victim text: species of the victims
hunter_epoch_s exact s: time of the run at which the hunters lived
victim_epoch_s exact s: time of the run at which the victims lived
contact_s exact s: time until a hunter is within reach, averaged over victims; at most the contest's length
contacted exact 1: share of the victims that a hunter reached
""",
    ),
    "progress.csv": (
        "Progress in the contests, and its test against the neutral shadow.",
        """
against own,others: own: opponents from the same run (historical); others: from other replicates (global)
species text: the species whose progress this is
role text: hunter or victim
opponent text: the species that it meets
period early,late: early: up to the split; late: from there on
from_s exact s: the epoch at which the period begins
to_s exact s: the epoch at which it ends
runs whole: number of replicates
mean_s exact? s: mean progress over replicates: how much sooner (hunter) or later (victim) contact happens
lower_s exact? s: lower end of the mean's 95 % interval; empty with fewer than six replicates
upper_s exact? s: upper end of the mean's 95 % interval
shadow_runs whole: number of replicates of the shadow; 0 without one
shadow_s exact? s: mean progress in the neutral shadow
over_shadow_s exact? s: mean_s - shadow_s
over_shadow_lower_s exact? s: lower end of that difference's uncorrected 95 % interval
over_shadow_upper_s exact? s: upper end of that interval
p: two-sided p value of that difference
p_holm: p value corrected for both roles of a link, period and kind of opponents (Holm)
lower_corrected_s exact? s: lower end of the 95 % interval that holds for both roles at once (Bonferroni)
upper_corrected_s exact? s: upper end of that interval
""",
    ),
    "selection.csv": (
        "Results of `trophic analyze --selection`: the terms of Price's equation for a trait of individuals.",
        """
trait text: name of the trait, as in --selection
species text: the species that has the trait
term text: start, end, change, survival (viability selection), survival_CAUSE, parenthood (fecundity selection), mutation, newcomers, cohorts, lives, lives_length, lives_rate, offspring_on_parent or mutation_a_birth
period all,first,second,third: the whole run or a third of it; for lives and births, the third in which the birth falls
unit text: unit of all means
missing whole: number of individuals in the runs that lack the trait and are omitted
runs_n whole: number of runs that have the term
runs_mean: mean over these runs
runs_lower: lower end of the mean's 95 % interval; empty for fewer than 6 runs
runs_upper: upper end of the mean's 95 % interval
shadow_n whole: number of runs of the neutral shadow that have the term
shadow_mean: mean over these runs
shadow_lower: lower end of the mean's 95 % interval
shadow_upper: upper end of the mean's 95 % interval
neutral_n whole: number of runs of the neutral null that have the term
neutral_mean: mean over these runs
neutral_lower: lower end of the mean's 95 % interval
neutral_upper: upper end of the mean's 95 % interval
null text: neutral: the runs are compared with the neutral null; empty: not tested
difference: runs_mean minus that of the null
difference_lower: lower end of its own 95 % interval
difference_upper: upper end of its own 95 % interval
p
p_holm: p value corrected for survival, parenthood and mutation of every trait and species (Holm)
lower_corrected
upper_corrected
""",
    ),
    "cross_check.csv": (
        "Results of `trophic cross-check`: two rows per metric, one for each set.",
        """
engine text: name of the physics engine
quantity text: the metric
species text: as in metrics.csv
group text: as in metrics.csv
unit text: unit of mean, margin, difference and intervals
mean: mean over runs
lower: lower end of its 95 % interval
upper: upper end of its 95 % interval
n whole: number of runs
margin: margin within which engines are equivalent
difference: the second set's mean minus the first's
difference_lower: lower end of its 90 % interval
difference_upper: upper end of its 90 % interval
conclusion text: equivalent, different, inconclusive or unknown
""",
    ),
}


class Column(NamedTuple):
    """A column of a table."""

    name: str
    unit: str
    cells: str
    meaning: str


def _read(text: str, shared: dict[str, Column]) -> Iterable[Column]:
    for line in text.strip().splitlines():
        head, colon, meaning = line.partition(": ")
        if not colon:
            yield shared[line]
            continue
        name, kind, unit = (*head.split(), *("exact?", "")[head.count(" ") :])[:3]
        cells = kind.rstrip("?")
        yield Column(
            name,
            unit,
            _CELLS.get(cells, cells.replace(",", ", ")) + (", or empty" if kind.endswith("?") else ""),
            meaning,
        )


_shared = {column.name: column for column in _read(_SHARED, {})}
TABLES: dict[str, tuple[str, list[Column]]] = {
    file: (what, list(_read(lines, _shared))) for file, (what, lines) in _TABLES.items()
}


def names(file: str) -> list[str]:
    """The names of a file's columns, in their order."""
    return [column.name for column in TABLES[file][1]]


def document() -> str:
    """The part of docs/tables.md about these tables."""
    text = ""
    for file, (what, columns) in TABLES.items():
        text += f"\n## {file}\n\n{what}\n\n| column | unit | cells | meaning |\n|---|---|---|---|\n"
        text += "".join(
            f"| {column.name} | {column.unit} | {column.cells} | {column.meaning} |\n" for column in columns
        )
    return text


if __name__ == "__main__":
    print(document(), end="")
