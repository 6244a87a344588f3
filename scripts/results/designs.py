# SPDX-License-Identifier: MIT
"""Two-level designs, their effects, and rows of what `trophic analyze` wrote."""
import csv
import itertools
import math
import pathlib

# What the screening design reports: (metric, species, group, over the shadow).
SCREENED = [("velocity", "prey", "inherited", True), ("velocity", "predator", "inherited", True),
            ("velocity", "prey", "active", False), ("velocity", "prey", "all", False), ("velocity", "predator", "all", False),
            ("attribution_caught", "prey", "all", False), ("attribution_credited", "predator", "all", False),
            ("wall_sticking", "prey", "all", False), ("wall_sticking", "predator", "all", False),
            ("wall_sticking_gap", "prey-predator", "all", False), ("tag_symmetry", "prey+predator", "inherited", False)]


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
    with open(metrics, newline="") as file:
        for row in csv.DictReader(file):
            if row["time_s"] or row["baseline"] not in ("", "shadow") or not row["value"]:
                continue
            key = (row["metric"], row["species"], row["group"])
            (shadow if row["baseline"] else own).setdefault(key, {})[row["seed"]] = float(row["value"])
    values = {}
    for metric, species, group, over_shadow in SCREENED:
        ours, null = own.get((metric, species, group), {}), shadow.get((metric, species, group), {})
        seeds = sorted(seed for seed in ours if not over_shadow or seed in null)
        values[metric, species, group, over_shadow] = [ours[seed] - (null[seed] if over_shadow else 0.0) for seed in seeds]
    return values


def mean(values):
    return sum(values) / len(values)


def interval(values):
    """Mean, 95 % interval of Student's t and p of no effect."""
    from scipy import stats

    middle = mean(values)
    if len(values) < 2:
        return middle, math.nan, math.nan, math.nan
    error = math.sqrt(sum((value - middle) ** 2 for value in values) / (len(values) - 1) / len(values))
    reach = stats.t.ppf(0.975, len(values) - 1) * error
    p = 2.0 * stats.t.sf(abs(middle) / error, len(values) - 1) if error > 0.0 else float(middle == 0.0)
    return middle, middle - reach, middle + reach, p


def holm(p_values):
    """p-values corrected for their number."""
    order = sorted(range(len(p_values)), key=p_values.__getitem__)
    corrected, largest = [0.0] * len(p_values), 0.0
    for rank, place in enumerate(order):
        largest = max(largest, min(1.0, (len(p_values) - rank) * p_values[place]))
        corrected[place] = largest
    return corrected


def named(key):
    metric, species, group, over_shadow = key
    return {"metric": metric, "species": species, "group": group, "over_shadow": int(over_shadow)}


def cell_rows(names, cells):
    """The mean of each metric in each cell."""
    rows = []
    for levels, values in cells:
        for key, runs in values.items():
            rows.append({**dict(zip(names, levels)), **named(key), "runs": len(runs), "mean": f"{mean(runs):.6g}" if runs else ""})
    return rows


def effect_rows(names, cells):
    """The effect of each choice on each metric: mean of the cells with the second reading less that of those with the first.

    Replicates of one number have one seed in all cells, so each seed gives an effect, and the interval is that of their mean.
    """
    rows = []
    for key in SCREENED:
        runs = [values[key] for _, values in cells]
        count = min(map(len, runs))
        if count < 2:
            continue
        for factor, name in enumerate(names):
            signs = [1 if levels[factor] else -1 for levels, _ in cells]
            effects = [2.0 * mean([sign * values[seed] for sign, values in zip(signs, runs)]) for seed in range(count)]
            middle, lower, upper, p = interval(effects)
            rows.append({**named(key), "choice": name, "runs": count, "effect": f"{middle:.6g}", "lower": f"{lower:.6g}",
                         "upper": f"{upper:.6g}", "p": p})
    for row, p in zip(rows, holm([row["p"] for row in rows])):
        row["p"] = f"{row['p']:.3g}"
        row["p_holm"] = f"{p:.3g}"
    return rows


def number(value):
    return "" if value is None else f"{value:.6g}"


def set_rows(name, summary):
    """A row a metric of a set: ours, its shadow and the difference."""
    rows = []
    for metric in summary["sets"][0]["metrics"]:
        shadow = next((one for one in metric["baselines"] if one["name"] == "shadow"), {})
        rows.append({"set": name, "metric": metric["metric"], "species": metric["species"], "group": metric["group"],
                     "unit": metric["unit"], "runs": metric["runs"], **{key: number(metric[key]) for key in ("mean", "deviation", "lower", "upper")},
                     "shadow": number(shadow.get("value")), "difference": number(shadow.get("difference")),
                     "difference_lower": number(shadow.get("lower")), "difference_upper": number(shadow.get("upper"))})
    return rows


def swap_rows(swaps):
    """The significant effects of a ablations.csv on the metrics of the claims, corrected (Holm) for these metrics and all swaps of a table."""
    compared = {}
    with open(swaps, newline="") as file:
        for row in csv.DictReader(file):
            over_shadow = row["compared"] == "over_shadow"
            if (row["metric"], row["species"], row["group"], over_shadow) in SCREENED and row["p"]:
                compared.setdefault(row["direction"].removeprefix("from_"), []).append((row, over_shadow))
    rows = []
    for table, effects in compared.items():
        for (row, over_shadow), p in zip(effects, holm([float(row["p"]) for row, _ in effects])):
            if p <= 0.05:
                rows.append({"from": table, "swap": row["swap"], "metric": row["metric"], "species": row["species"], "group": row["group"],
                             "over_shadow": int(over_shadow),
                             **{name: number(float(row[name])) for name in ("base", "swapped", "difference", "lower", "upper")}, "p_holm": f"{p:.2g}"})
    return rows


def claim_rows(summary):
    """A row a published figure and reading."""
    rows = []
    for claim in summary["sets"][0]["claims"]:
        for reading in claim["readings"]:
            row = {"claim": claim["claim"], "summary": claim["summary"], **reading}
            rows.append({key: number(value) if isinstance(value, float) else "" if value is None else value for key, value in row.items()})
    return rows


def sweep_rows(effects):
    """What `trophic analyze` says of a sweep's values: velocities and attributions over the shadow, the others raw."""
    rows = []
    with open(effects, newline="") as file:
        for row in csv.DictReader(file):
            over_shadow = row["compared"] == "over_shadow"
            if over_shadow == row["metric"].startswith(("velocity", "attribution")):
                rows.append({"axis": row["axis"], "value": row["value"], "reference": row["reference"], "metric": row["metric"],
                             "species": row["species"], "group": row["group"], "over_shadow": int(over_shadow), "seeds": row["seeds"],
                             **{name: row[name] and number(float(row[name])) for name in ("difference", "lower", "upper", "p_holm")}})
    return rows


def orphans(runs):
    """Of the births at a starvation, the share that descends from a prey, over the share that should inherit."""
    births = inherited = 0
    for events in sorted(pathlib.Path(runs).glob("replicate-*/events.csv")):
        starved = set()
        with open(events, newline="") as file:
            for row in csv.DictReader(file):
                place = (row["tick"], row["body"])
                if row["event"] == "death" and row["cause"] == "starved":
                    starved.add(place)
                elif row["event"] == "birth" and place in starved:
                    births += 1
                    inherited += row["parent_id"] != ""
    return f"{inherited / births / (2 / 3):.3f}" if births else ""
