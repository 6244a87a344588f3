# SPDX-License-Identifier: MIT
"""Two-level designs and sweeps, and their effects."""
import itertools
import json
import pathlib

import data_rows
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


def runs_of(metrics):
    """{(metric, species, group, over the shadow): [a value for each run]} of a metrics.csv; differences are paired by seed."""
    own, shadow = {}, {}
    for row in data_rows.read(metrics):
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
                    "mean": f"{data_rows.mean(runs):.6g}" if runs else "",
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
            effects = [
                2.0 * data_rows.mean([sign * values[seed] for sign, values in zip(signs, runs)])
                for seed in range(count)
            ]
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


def swap_rows(table, other, analysis):
    """The significant effects in the analysis of a sweep of studies/ablations on the metrics of the claims, corrected (Holm) for these metrics and all
    cells but the other table."""
    cells = {row["cell"]: row for row in data_rows.read(analysis / "cells.csv") if row["rule_table"] != other}
    effects = []
    for row in data_rows.read(analysis / "sweep_differences.csv"):
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
                    "base": data_rows.number(float(row["mean_reference"])),
                    "swapped": data_rows.number(float(row["mean"])),
                    **{name: data_rows.number(float(row[name])) for name in ("difference", "lower", "upper")},
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


def sweep_rows(effects):
    """Effects of a sweep's values from `trophic analyze`: velocities and attributions over the shadow, the others raw."""
    rows = []
    for row in data_rows.read(effects):
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
                        name: row[name] and data_rows.number(float(row[name]))
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
        for row in data_rows.read(events):
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
