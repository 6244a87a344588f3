# SPDX-License-Identifier: MIT
"""Two-level designs, their effects, and rows from the output of `trophic analyze`."""
import csv
import itertools
import json
import math
import pathlib
import re

import installed

installed.make_importable()
from trophic import statistics
from trophic.statistics import holm

# Metrics of the screening design: (metric, species, group, over the shadow).
SCREENED = [
    ("velocity", "prey", "inherited", True),
    ("velocity", "predator", "inherited", True),
    ("velocity", "prey", "active", False),
    ("velocity", "prey", "all", False),
    ("velocity", "predator", "all", False),
    ("attribution_caught", "prey", "all", False),
    ("attribution_credited", "predator", "all", False),
    ("wall_sticking", "prey", "all", False),
    ("wall_sticking", "predator", "all", False),
    ("wall_sticking_gap", "prey-predator", "all", False),
    ("tag_symmetry", "prey+predator", "inherited", False),
]


def two_levels(factors):
    """64 rows of 0 and 1, one column a factor, at most 32: a fraction of resolution IV.

    Each column is the product of an odd number of the six basic ones. So no product of two or three columns is constant, and no
    main effect is confounded with another or with an interaction of two choices.
    """
    basic = range(6)
    words = [word for size in (1, 3, 5) for word in itertools.combinations(basic, size)]
    if factors > len(words):
        raise ValueError(f"{factors} factors: must be <= {len(words)}")
    rows = []
    for levels in itertools.product((0, 1), repeat=6):
        rows.append([sum(levels[letter] for letter in word) % 2 for word in words[:factors]])
    return rows


def read(table):
    """The rows of a CSV file."""
    with open(table, newline="") as file:
        return list(csv.DictReader(file))


def runs_of(metrics):
    """{(metric, species, group, over the shadow): [a value for each run]} of a metrics.csv; differences are paired by seed."""
    own, shadow = {}, {}
    for row in read(metrics):
        if row["time_s"] or row["baseline"] not in ("", "shadow") or not row["value"]:
            continue
        key = (row["metric"], row["species"], row["group"])
        (shadow if row["baseline"] else own).setdefault(key, {})[row["seed"]] = float(row["value"])
    values = {}
    for metric, species, group, over_shadow in SCREENED:
        ours, null = own.get((metric, species, group), {}), shadow.get((metric, species, group), {})
        seeds = sorted(seed for seed in ours if not over_shadow or seed in null)
        values[metric, species, group, over_shadow] = [
            ours[seed] - (null[seed] if over_shadow else 0.0) for seed in seeds
        ]
    return values


def write(table, rows):
    """Writes the rows of a CSV file."""
    with open(table, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def p_text(p):
    return "" if p == "" else "<0.001" if float(p) < 0.0005 else f"{float(p):.3f}"


def mean(values):
    return sum(values) / len(values)


def welch(ours, theirs):
    """Difference of two means, each given as mean, deviation and number of runs, with Welch's 95 % interval."""
    variances = [deviation**2 / count for _, deviation, count in (ours, theirs)]
    freedom = sum(variances) ** 2 / sum(
        variance**2 / (count - 1) for variance, (_, _, count) in zip(variances, (ours, theirs))
    )
    middle = ours[0] - theirs[0]
    return middle, *statistics.interval_of(statistics.Contrast(middle, math.sqrt(sum(variances)), freedom))


def named(key):
    metric, species, group, over_shadow = key
    return {"metric": metric, "species": species, "group": group, "over_shadow": int(over_shadow)}


def cell_rows(names, cells):
    """The mean of each metric in each cell."""
    rows = []
    for levels, values in cells:
        for key, runs in values.items():
            rows.append(
                {
                    **dict(zip(names, levels)),
                    **named(key),
                    "runs": len(runs),
                    "mean": f"{mean(runs):.6g}" if runs else "",
                }
            )
    return rows


def effect_rows(names, cells):
    """The effect of each choice on each metric: mean of the cells with the second reading less that of those with the first.

    Replicates of one number have one seed in all cells, so each seed gives an effect, and the interval is that of their mean.
    """
    rows = []
    for key in SCREENED:
        runs = [values[key] for _, values in cells]
        count = min(map(len, runs))
        if count < statistics.MIN_RUNS_FOR_TEST:
            continue
        for factor, name in enumerate(names):
            signs = [1 if levels[factor] else -1 for levels, _ in cells]
            effects = [2.0 * mean([sign * values[seed] for sign, values in zip(signs, runs)]) for seed in range(count)]
            of = statistics.contrast((1.0, effects))
            (lower, upper), p = statistics.interval_of(of), statistics.p_value(of)
            rows.append(
                {
                    **named(key),
                    "choice": name,
                    "runs": count,
                    "effect": f"{of.value:.6g}",
                    "lower": f"{lower:.6g}",
                    "upper": f"{upper:.6g}",
                    "p": 1.0 if p is None else p,
                }
            )
    for row, p in zip(rows, holm([row["p"] for row in rows])):
        row["p"] = f"{row['p']:.3g}"
        row["p_holm"] = f"{p:.3g}"
    return rows


def fixed(value, places, sign=""):
    """A number with these decimals, and more if it is not zero but would be written as zero."""
    while value and float(f"{value:.{places}f}") == 0.0 and places < 6:
        places += 1
    return f"{value:{sign}.{places}f}"


def number(value):
    return "" if value is None else f"{value:.6g}"


def set_rows(name, summary):
    """A row for each metric of a set: the set, its shadow and the difference."""
    rows = []
    for metric in summary["sets"][0]["metrics"]:
        shadow = next((one for one in metric["baselines"] if one["name"] == "shadow"), {})
        rows.append(
            {
                "set": name,
                "metric": metric["metric"],
                "species": metric["species"],
                "group": metric["group"],
                "unit": metric["unit"],
                "runs": metric["runs"],
                **{key: number(metric[key]) for key in ("mean", "deviation", "lower", "upper")},
                "shadow": number(shadow.get("value")),
                "difference": number(shadow.get("difference")),
                "difference_lower": number(shadow.get("lower")),
                "difference_upper": number(shadow.get("upper")),
                "p_holm": number(shadow.get("p_adjusted")),
                "conclusion": shadow.get("conclusion") or "",
            }
        )
    return rows


def without_observed_power(answer):
    """An answer without the runs that would find the effect that was seen: they say no more than its p value."""
    return re.sub(r" \([^()]*runs would decide[^()]*\)", "", answer)


def answer_rows(summary):
    """A row for each question about evolution: the answer under all readings, and the effect of the plainest."""
    rows = []
    for answer in summary["sets"][0]["answers"]:
        shown = answer["readings"][answer["shown"]]
        rows.append(
            {
                "question": answer["question"],
                "answer": without_observed_power(answer["answer"]),
                "metric": shown["metric"],
                "runs": len(summary["sets"][0]["runs"]),
                "readings": len(answer["readings"]),
                **{name: number(shown[name]) for name in ("difference", "lower", "upper")},
                "p_holm": number(shown["p_adjusted"]),
            }
        )
    return rows


def swap_rows(table, other, analysis):
    """The significant effects in the analysis of a sweep of studies/ablations on the metrics of the claims, corrected (Holm) for these metrics and all
    cells but the other table."""
    cells = {row["cell"]: row for row in read(analysis / "cells.csv") if row["rule_table"] != other}
    effects = []
    for row in read(analysis / "sweep_differences.csv"):
        over_shadow = row["compared"] == "over_shadow"
        is_screened = (row["metric"], row["species"], row["group"], over_shadow) in SCREENED
        if is_screened and row["p"] and row["cell"] in cells:
            effects.append((row, over_shadow))
    rows = []
    for (row, over_shadow), p in zip(effects, holm([float(row["p"]) for row, _ in effects])):
        if p <= 0.05:
            rows.append(
                {
                    "from": table,
                    "swap": swap_name(table, cells[row["cell"]]),
                    "metric": row["metric"],
                    "species": row["species"],
                    "group": row["group"],
                    "over_shadow": int(over_shadow),
                    "base": number(float(row["mean_reference"])),
                    "swapped": number(float(row["mean"])),
                    **{name: number(float(row[name])) for name in ("difference", "lower", "upper")},
                    "p_holm": f"{p:.2g}",
                }
            )
    return rows


def swap_name(table, cell):
    """What a cell has of the other table: "capture", "floor.floor"."""
    parts = [cell["rule_table"].removeprefix(table).removeprefix("_")]
    parts += [
        name.removeprefix("rules.")
        for name, value in cell.items()
        if name.startswith(("rules.", "ecology.")) and value and name != "ecology.duration_s"
    ]
    return ", ".join(filter(None, parts))


def claim_rows(summary):
    """A row for each published figure and reading."""
    rows = []
    for claim in summary["sets"][0]["claims"]:
        for reading in claim["readings"]:
            row = {"claim": claim["claim"], "summary": claim["summary"], **reading}
            row.pop("runs_needed", None)
            rows.append(
                {
                    key: number(value) if isinstance(value, float) else "" if value is None else value
                    for key, value in row.items()
                }
            )
    return rows


def sweep_rows(effects):
    """Effects of a sweep's values from `trophic analyze`: velocities and attributions over the shadow, the others raw."""
    rows = []
    for row in read(effects):
        over_shadow = row["compared"] == "over_shadow"
        if over_shadow == row["metric"].startswith(("velocity", "attribution")):
            rows.append(
                {
                    "axis": row["axis"],
                    "value": row["value"],
                    "reference": row["reference"],
                    "metric": row["metric"],
                    "species": row["species"],
                    "group": row["group"],
                    "over_shadow": int(over_shadow),
                    "seeds": row["seeds"],
                    **{
                        name: row[name] and number(float(row[name]))
                        for name in ("difference", "lower", "upper", "p_holm")
                    },
                }
            )
    return rows


def orphans(runs):
    """The share of births after a starvation with a parent, divided by the share that should inherit."""
    births = inherited = 0
    for events in sorted(pathlib.Path(runs).glob("replicate-*/events.csv")):
        starved = set()
        for row in read(events):
            place = (row["tick"], row["body"])
            if row["event"] == "death" and row["cause"] == "starved":
                starved.add(place)
            elif row["event"] == "birth" and place in starved:
                births += 1
                inherited += row["parent_id"] != ""
    return f"{inherited / births / (2 / 3):.3f}" if births else ""


def cells_of(sweep, grid):
    """(number, settings) of each cell of a sweep; the settings are its values of the grid's axes, as one text."""
    cells = {}
    for line in (pathlib.Path(sweep) / "plan.jsonl").read_text().splitlines():
        run = json.loads(line)
        of_run = {**run["settings"], "rule_table": run["rule_table"]}
        words = [
            str(of_run[key]) if key == "rule_table" else f"{key.split('.')[-1]} {of_run[key]:.4g}"
            for key, _ in flat(grid)
        ]
        cells[run["cell"]] = ", ".join(words)
    return sorted(cells.items())


def flat(table, path=""):
    """(path, value) of each value of nested tables."""
    for key, value in table.items():
        name = f"{path}.{key}" if path else key
        yield from flat(value, name) if isinstance(value, dict) else [(name, value)]


def progress_rows(cell, progress):
    """Progress over the shadow, by kind of opponents, species and period, from a progress.csv."""
    return [
        {
            **cell,
            "measure": f"{'global' if row['against'] == 'others' else 'historical'} {row['period']}",
            "species": row["species"],
            "runs": row["runs"],
            **{
                key: row[name] and number(float(row[name]))
                for key, name in (
                    ("mean", "mean_s"),
                    ("shadow", "shadow_s"),
                    ("over_shadow", "over_shadow_s"),
                    ("lower", "over_shadow_lower_s"),
                    ("upper", "over_shadow_upper_s"),
                    ("p_holm", "p_holm"),
                )
            },
        }
        for row in read(progress)
    ]


def raced_rows(cell, summary, shadow=None):
    """Velocities over the shadow, in cm/s. `shadow`: the summary of the shadow's runs, if the set has none of its own."""
    rows = []
    for row in raced(summary):
        names = ("shadow", "difference", "difference_lower", "difference_upper")
        if shadow:
            theirs = next(one for one in raced(shadow) if one["species"] == row["species"])
            row.update(
                zip(
                    names,
                    (
                        theirs["mean"],
                        *welch(*([float(one[key]) for key in ("mean", "deviation", "runs")] for one in (row, theirs))),
                    ),
                )
            )
        rows.append(
            {
                **cell,
                "measure": "velocity",
                "species": row["species"],
                "runs": row["runs"],
                **{
                    key: number(100.0 * float(row[name])) if row[name] != "" else ""
                    for key, name in zip(("mean", "shadow", "over_shadow", "lower", "upper"), ("mean", *names))
                },
                "p_holm": "",
            }
        )
    return rows


def raced(summary):
    return [
        row
        for row in set_rows("", summary)
        if row["metric"] == "velocity" and row["group"] == "inherited" and row["mean"]
    ]


def lineage_rows(cell, summary):
    """Each lineage measure with its difference from each null."""
    rows = []
    for metric in summary["sets"][0]["metrics"]:
        for null in metric["baselines"]:
            rows.append(
                {
                    **cell,
                    "measure": metric["metric"],
                    "species": metric["species"],
                    "group": metric["group"],
                    "unit": metric["unit"],
                    "runs": metric["runs"],
                    "mean": number(metric["mean"]),
                    "null": null["name"],
                    "null_mean": number(null.get("value")),
                    **{key: number(null.get(key)) for key in ("difference", "lower", "upper")},
                    "p_holm": number(null.get("p_adjusted")),
                }
            )
    return rows


def over_neutral(rows):
    """Price's terms that are tested, each with its difference from the neutral null by Welch's interval, corrected for them all (Holm). Terms
    without that null have no difference and no p: another null, or zero, does not show selection."""
    found = []
    for row in (row for row in rows if row["term"] in ("survival", "parenthood", "mutation")):
        of = dict.fromkeys(("difference", "difference_lower", "difference_upper", "p"), "")
        if row["neutral_mean"]:
            means = [float(row[f"{of_set}_mean"]) for of_set in ("runs", "neutral")]
            counts = [int(row[f"{of_set}_n"]) for of_set in ("runs", "neutral")]
            errors = [
                (float(row[f"{of_set}_upper"]) - float(row[f"{of_set}_lower"]))
                / 2.0
                / statistics.t_quantile(0.975, count - 1)
                for of_set, count in zip(("runs", "neutral"), counts)
            ]
            squares = [error**2 for error in errors]
            freedom = sum(squares) ** 2 / sum(square**2 / (count - 1) for square, count in zip(squares, counts))
            contrast = statistics.Contrast(means[0] - means[1], math.sqrt(sum(squares)), freedom)
            lower, upper = statistics.interval_of(contrast)
            values = (contrast.value, lower, upper, statistics.p_value(contrast))
            of = dict(zip(of, (f"{value:.6g}" for value in values)))
        found.append({**row, **of, "null": "neutral" if of["p"] else "", "p_holm": ""})
    tested = [row for row in found if row["p"]]
    for row, p in zip(tested, holm([float(row["p"]) for row in tested])):
        row["p_holm"] = f"{p:.6g}"
    return found


def error_of(row):
    """The error of the difference of two sets of equally many runs, and its degrees of freedom, from a row's 95 % interval."""
    freedom = 2 * (int(row["runs"]) - 1)
    return (float(row["upper"]) - float(row["lower"])) / 2.0 / statistics.t_quantile(0.975, freedom), freedom


def runs_for(row, smallest, level):
    """The runs in each set with which 80 % of studies find a difference of `smallest` at `level`, at the spread of a row's difference of two sets."""
    error, _ = error_of(row)
    return statistics.runs_for_power(smallest, statistics.Scatter(int(row["runs"]) * error**2, 2.0), level)


def together(row, tests):
    """A row with the interval that holds in all of these tests at once with 95 % (Bonferroni)."""
    error, freedom = error_of(row)
    width = error * statistics.t_quantile(1.0 - 0.025 / tests, freedom)
    middle = float(row["difference"])
    return {**row, "lower": f"{middle - width:.6g}", "upper": f"{middle + width:.6g}"}


def persisting(metrics):
    """The names of the runs in which every species lives to the end."""
    return [
        row["run"]
        for row in read(metrics)
        if (row["metric"], row["species"], row["baseline"], row["time_s"], row["value"])
        == ("persists", "all", "", "", "1")
    ]


LIVING = {
    "persists",
    "velocity",
    "generation_time",
    "lineage_depth",
    "pyramid_numbers",
    "cycles",
    "period",
    "phase",
    "search_rate_holling",
    "handling_time",
    "trophic_efficiency",
}


def living_rows(name, summary):
    """Measures of a world whose numbers change, with those of its nulls; p of the two velocities is corrected for them alone (Holm)."""
    rows = []
    for metric in summary["sets"][0]["metrics"]:
        if metric["metric"] not in LIVING or metric["metric"] == "velocity" and metric["group"] != "inherited":
            continue
        nulls = {null["name"]: null for null in metric["baselines"]}
        shadow = nulls.get("shadow", {})
        rows.append(
            {
                "set": name,
                "metric": metric["metric"],
                "species": metric["species"],
                "unit": metric["unit"],
                "runs": metric["runs"],
                **{key: number(metric[key]) for key in ("mean", "lower", "upper")},
                **{null: number(nulls.get(null, {}).get("value")) for null in ("shadow", "clones", "mean_field")},
                **{key: number(shadow.get(key)) for key in ("difference", "p")},
                **{f"difference_{key}": number(shadow.get(key)) for key in ("lower", "upper")},
                "p_holm": "",
            }
        )
    tested = [row for row in rows if row["metric"] == "velocity" and row["p"]]
    for row, p in zip(tested, holm([float(row["p"]) for row in tested])):
        row["p_holm"] = number(p)
    return rows


def atlas_rows(analysis):
    """Persistence and velocities over the shadow in each cell of a sweep, with its two settings."""
    cells = {
        row["cell"]: {"reach_m": row["rules.capture.reach_m"], "growth_1_s": row["rules.resource.growth_1_s"]}
        for row in read(analysis / "cells.csv")
    }
    keys = (
        "metric",
        "species",
        "unit",
        "runs",
        "mean",
        "lower",
        "upper",
        "shadow",
        "over_shadow",
        "over_lower",
        "over_upper",
    )
    return [
        {**cells[row["cell"]], **{key: row[key] for key in keys}}
        for row in read(analysis / "sweep_metrics.csv")
        if (row["metric"], row["group"]) in (("persists", "all"), ("velocity", "inherited"))
    ]


def compared_raw(differences):
    """The rows of raw differences that have both means."""
    return [row for row in read(differences) if row["compared"] == "raw" and row["mean_a"] and row["mean_b"]]


def over_survival(row, scale):
    """Numbers of runs, means and difference of a comparison with survival alone; the numbers in the unit that `scale` makes."""
    scaled = {
        name: row[key] and number(scale * float(row[key]))
        for name, key in (
            ("mean", "mean_b"),
            ("survival", "mean_a"),
            ("over_survival", "difference"),
            ("lower", "lower"),
            ("upper", "upper"),
        )
    }
    return {"runs": row["n_b"], "survival_runs": row["n_a"], **scaled}


def evolved_rows(study, differences, means, neutral=None):
    """Measures of bodies, gaits and brains in the late half of runs, with their differences from survival alone, from the shadow and, if there are
    such differences, from the neutral null."""
    shadows = {(row["metric"], row["species"], row["group"]): row for row in read(means) if row["null"] == "shadow"}
    neutrals = {
        (row["metric"], row["species"], row["group"]): row for row in (compared_raw(neutral) if neutral else ())
    }
    rows = []
    for row in compared_raw(differences):
        key = (row["metric"], row["species"], row["group"])
        scale = 100.0 if row["unit"] == "m/s" else 1.0
        shadow = shadows.get(key, {})
        of_shadow = {
            name: shadow.get(column) and number(scale * float(shadow[column]))
            for name, column in (
                ("shadow", "null_mean"),
                ("over_shadow", "difference"),
                ("shadow_lower", "difference_lower"),
                ("shadow_upper", "difference_upper"),
            )
        }
        null = neutrals.get(key, {})
        of_neutral = {
            name: number(scale * float(null[column])) if null.get(column) else ""
            for name, column in (
                ("neutral", "mean_a"),
                ("over_neutral", "difference"),
                ("neutral_lower", "lower"),
                ("neutral_upper", "upper"),
            )
        }
        p_values = {
            name: of.get("p_holm") and number(float(of["p_holm"]))
            for name, of in (("p_holm", row), ("shadow_p_holm", shadow), ("neutral_p_holm", null))
        }
        rows.append(
            {
                "study": study,
                "metric": row["metric"],
                "species": row["species"],
                "group": row["group"],
                "unit": "cm/s" if scale == 100.0 else row["unit"],
                **over_survival(row, scale),
                **of_shadow,
                **of_neutral,
                **p_values,
            }
        )
    return rows


def walked_rows(differences):
    """How far prey walk in the late half of runs, over survival alone, in cm/s: one measure, so p needs no correction."""
    rows = [
        row
        for row in compared_raw(differences)
        if (row["metric"], row["species"], row["group"]) == ("walked", "prey", "late")
    ]
    return [
        {
            "metric": row["metric"],
            "species": row["species"],
            "group": row["group"],
            **over_survival(row, 100.0),
            "p": row["p"] and number(float(row["p"])),
        }
        for row in rows
    ]


def lives_of(runs):
    """Births, mean and greatest number of ancestors of newborn, and deaths of diverged bodies, as means over the runs of a set."""
    counts = []
    for phylogeny in sorted(pathlib.Path(runs).glob("replicate-*/phylogeny.csv")) or sorted(
        pathlib.Path(runs).glob("phylogeny.csv")
    ):
        depth, depths = {}, []
        for row in sorted(read(phylogeny), key=lambda row: int(row["id"])):
            depth[row["id"]] = 0 if row["ancestor_id"] == row["id"] else depth[row["ancestor_id"]] + 1
            depths.append(depth[row["id"]])
        diverged = sum(
            row["event"] == "death" and row["cause"] == "diverged" for row in read(phylogeny.parent / "events.csv")
        )
        counts.append((len(depths), mean(depths), max(depths), diverged))
    return {
        name: number(mean(values))
        for name, values in zip(("births", "mean_depth", "greatest_depth", "diverged"), zip(*counts))
    }


def generations_of(runs):
    """Births after the start by founder of each species, as means over runs."""
    births = {}
    for events in sorted(pathlib.Path(runs).glob("replicate-*/events.csv")):
        for row in read(events):
            if row["event"] == "birth":
                births.setdefault(row["species"], [0, 0])[int(row["tick"]) > 0] += 1
    return {species: number(born / founders) for species, (founders, born) in births.items()}
