# SPDX-License-Identifier: MIT
"""The tables that the module writes: every column with its unit, its cells and its meaning. docs/tables.md is made from them:
`python3 -m trophic.report.columns` prints its part."""
from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

_CELLS = {"text": "text", "whole": "whole number", "exact": "number, exact", "flag": "0 or 1"}
# Columns that several tables have.
_SHARED = """
metric text: what was measured
species text: of whom; of a metric of two: prey+predator
group text: as in metrics.csv
unit text: of means, differences and intervals
p: of this comparison alone
lower_corrected: of the interval that holds in all comparisons at once with 95 % (Bonferroni)
upper_corrected: of the same interval
scatter: deviation of the difference, of one run: with n runs in each set its error is scatter / sqrt(n); a design computes its runs from it
not_tested text: why the difference is described and not tested; empty if it is tested, or if another null answers
significant text: yes where p_holm <= 0.05, else no; empty without a p value
"""
# The content of each file, and a line for each column, "name cells unit: meaning"; cells are exact numbers or empty, and there is no unit, unless
# the line says so. A ? stands for cells that may be empty; a name alone for a column of _SHARED.
_TABLES = {
    "metrics.csv": (
        "Results of the analysis: every value and every curve of every run, one value per row.",
        """
set text: name of the rule table, with what differs from it
run text: name of the run's folder
seed whole: of the run
metric
species
group text: all, random, inherited, active or inactive (at that tick), inherited_active, inherited_inactive; of deaths a cause, of ticks_at a number of members
baseline text: empty: observed; shadow, one_sided_SPECIES, neutral or clones: observed in that null of the set
time_s exact? s: of a curve the end of its window; empty: of the whole run
value: in `unit`; empty: could not be computed
unit text: of the value; 1 for shares and counts
""",
    ),
    "means.csv": (
        "Each metric of a set next to each of its nulls, for tables of a paper.",
        """
set text: name of the rule table, with what differs from it
metric
species
group
unit
n whole: runs in which it could be measured
mean: over these runs; of extinct_at the restricted mean: how long the species lasts, up to the common end of the set and its nulls
deviation: between these runs
lower: of the mean's 95 % interval; empty for fewer than 6 runs
upper: of the mean's 95 % interval
published: the paper's mean, for its own rule tables; empty if it has none
null text: shadow, one_sided (of this species), neutral or clones, which are runs, or the name of a null that each run has of its own; empty: no null
null_n whole: runs that give the null
null_mean: over these runs
difference: mean - null_mean; of neutral and of a run's own null over the runs that have both
difference_lower: of its own 95 % interval
difference_upper: of its own 95 % interval
p: of this comparison alone; of extinct_at the log-rank test's; empty if it is not tested
p_holm: corrected for all comparisons of the set; at most 0.05: significant; empty if another null answers
lower_corrected
upper_corrected
scatter
not_tested
same_as text: an earlier metric that says the same (other reading, or the same in every run); then not compared again
""",
    ),
    "survival.csv": (
        "Survival of species in worlds whose numbers change (Kaplan and Meier): a row for each time at which one dies out in a run.",
        """
set text: name of the rule table, with what differs from it
null text: empty: of the set; shadow, one_sided_SPECIES, neutral or clones: of that null
species text: that dies out
time_s exact s: of the extinction
at_risk whole: runs in which it lived until then
extinctions whole: runs in which it dies out then
survival: the share of runs in which it lives on
lower: of its 95 % interval, by Greenwood's error of log(-log); empty where the share is 0
upper: of the same interval
""",
    ),
    "differences.csv": (
        "Each metric of two sets that were compared.",
        """
metric
species
group
unit
compared text: over_shadow: (b - its shadow) - (a - its shadow), the answer; over_one_sided, over_neutral: the same of these nulls; raw: b - a
n_a whole: runs of the first set
n_b whole: runs of the second set
mean_a: of the first set, raw; of extinct_at the restricted mean up to the common end of both sets
mean_b: of the second set, raw
difference: as `compared` says
lower: of this comparison's own 95 % interval; empty for fewer than 6 runs
upper: of this comparison's own 95 % interval
p: of this comparison alone; of extinct_at the log-rank test's; empty if it is not tested
p_holm: corrected for all comparisons; at most 0.05: significant; raw differences next to answers over nulls are corrected apart
lower_corrected
upper_corrected
scatter
not_tested
same_as text: an earlier metric that says the same (other reading, or the same in every run); then not compared again
""",
    ),
    "cells.csv": (
        "The cells of a sweep. After these columns there is one for each setting that varies between cells, named by its path.",
        """
cell whole: its number
rule_table text: of its runs
engine text: of its runs
runs whole: that were measured
runs_planned whole: that the plan has
shadow_runs whole: of its neutral shadow that were measured
until_s exact s: how much of each run was measured
""",
    ),
    "runs.csv": (
        "Results of the analysis of a sweep: one value of one run per row.",
        """
run whole: its index in the plan
cell whole: the number of its cell
replicate whole: its number in the cell
null text: none, or shadow or one_sided_SPECIES: a run of the cell's null of that name
seed whole: of the run
metric text: what was measured; what could not be has no row
species
group
value exact: in the metric's unit, as in sweep_metrics.csv
""",
    ),
    "sweep_metrics.csv": (
        "Each metric of each cell of a sweep, alone and over its shadow.",
        """
cell whole: the number of the cell
metric
species
group
unit text: of all values of the row; 1 for shares and counts
runs whole: in which it could be measured
mean: over these runs
deviation: between these runs
lower: of the mean's 95 % interval; empty for fewer than 6 runs
upper: of the mean's 95 % interval
shadow_runs whole: runs of the neutral shadow in which it could be measured
shadow: the mean over these runs
pairs whole: runs and shadows of one seed that both have a value
over_shadow: the mean over these pairs of run - shadow
over_lower: of the 95 % interval of over_shadow; empty for fewer than 6 pairs
over_upper: of the 95 % interval of over_shadow
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
compared text: over_shadow: each run over its shadow first, the answer; raw: the answer without shadows, else next to it
design text: paired: seed by seed, Student's t; independent: other seeds in each cell, Welch's t; exact: shares of runs, Fisher's test
runs whole: of the cell that were compared; of a paired sweep the pairs
runs_reference whole: of the reference cell that were compared
mean: over the cell's runs
mean_reference: over the reference cell's
difference: mean - mean_reference
lower: of this comparison's own 95 % interval; empty for fewer than 6 runs
upper: of this comparison's own 95 % interval
lower_corrected
upper_corrected
p
p_holm: corrected for all comparisons of the analysis; raw differences next to an answer apart
significant
hedges_g: the difference over the pooled standard deviation between runs of both cells, corrected for small numbers
smallest_detectable: the difference that the runs at hand would show with 80 % power at the corrected level
""",
    ),
    "sweep_effects.csv": (
        "The effect of each value of an axis on each metric, averaged over the other axes.",
        """
axis text: what varies: a setting's path, rule_table or engine
value text: its value here
reference text: its value in the reference cell
metric
species
group
unit
compared text: over_shadow: each run over its shadow first, the answer; raw: the answer without shadows, else next to it
settings whole: of the other axes, over which was averaged
seeds whole: with a value in all of these cells
mean: with the axis at this value, over settings and seeds
mean_reference: with the axis at the reference cell's value
difference: mean - mean_reference
lower: of this effect's own 95 % interval, over seeds; empty for fewer than 6
upper: of this effect's own 95 % interval
p: of this effect alone
p_holm: corrected for all effects of the analysis; raw differences next to an answer apart
lower_corrected
upper_corrected
significant
""",
    ),
    "contests.csv": (
        "Results of `trophic contest`: one row per contest of two teams.",
        """
shadow 0/1: whether both teams are from the neutral shadow
against own,others,panel_victims,panel_hunters: own: both teams are from one run; others: from two replicates; panel_victims or panel_hunters: these are the panel's
hunters_run text: folder of the run of the hunters
victims_run text: folder of the run of the victims
team whole: number of both teams, from 0
hunter text: species of the hunters
victim text: species of the victims
hunter_epoch_s exact s: time of the run at which the hunters lived
victim_epoch_s exact s: time of the run at which the victims lived
contact_s exact s: mean over victims of the time until a hunter is within reach, at most the contest's length
contacted exact 1: share of the victims that a hunter reached
""",
    ),
    "progress.csv": (
        "Progress that the contests show, and its test over the neutral shadow.",
        """
against own,others: own: opponents from the same run (historical); others: of another replicate (global)
species text: whose progress it is
role text: hunter or victim
opponent text: the species that it meets
period early,late: early: up to the split; late: from there on
from_s exact s: the epoch at which the period begins
to_s exact s: the epoch at which it ends
runs whole: replicates
mean_s exact? s: progress, mean over replicates: contact that much sooner (hunter) or later (victim)
lower_s exact? s: 95 % interval of the mean; empty with fewer than six replicates
upper_s exact? s: its other end
shadow_runs whole: replicates of the shadow; 0 without one
shadow_s exact? s: the same of the neutral shadow
over_shadow_s exact? s: mean_s - shadow_s
over_shadow_lower_s exact? s: 95 % interval of that difference, uncorrected
over_shadow_upper_s exact? s: its other end
p: of that difference, two-sided
p_holm: corrected for both roles of a link, period and kind of opponents (Holm)
lower_corrected_s exact? s: of the interval that holds for both roles at once with 95 % (Bonferroni)
upper_corrected_s exact? s: its other end
""",
    ),
    "selection.csv": (
        "Results of `trophic analyze --selection`: the terms of Price's equation for a trait of individuals.",
        """
trait text: as --selection names it
species text: whose trait it is
term text: start, end, change, survival, survival_CAUSE, parenthood, mutation, newcomers, cohorts, lives, lives_length, lives_rate, offspring_on_parent or mutation_a_birth
period all,first,second,third: the run or a third of it; of lives and births the third of the birth
unit text: of all means
missing whole: individuals of the runs without the trait, which are left out
runs_n whole: runs that have the term
runs_mean: over these runs
runs_lower: of the mean's 95 % interval; empty for fewer than 6 runs
runs_upper: of the mean's 95 % interval
shadow_n whole: runs of the neutral shadow that have the term
shadow_mean: over these runs
shadow_lower: of the mean's 95 % interval
shadow_upper: of the mean's 95 % interval
neutral_n whole: runs of the neutral null that have the term
neutral_mean: over these runs
neutral_lower: of the mean's 95 % interval
neutral_upper: of the mean's 95 % interval
null text: neutral: the runs are compared with the neutral null; empty: not tested
difference: runs_mean less that of the null
difference_lower: of its own 95 % interval
difference_upper: of its own 95 % interval
p
p_holm: corrected for survival, parenthood and mutation of every trait and species (Holm)
lower_corrected
upper_corrected
""",
    ),
    "cross_check.csv": (
        "Results of `trophic cross-check`: two rows per metric, of the first set and of the second.",
        """
engine text: name of the physics engine
quantity text: the metric
species text: as in metrics.csv
group text: as in metrics.csv
unit text: of mean, margin, difference and intervals
mean: over runs
lower: of its 95 % interval
upper: of its 95 % interval
n whole: runs
margin: within which engines are equivalent
difference: the second set's less the first's
difference_lower: of its 90 % interval
difference_upper: of its 90 % interval
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
