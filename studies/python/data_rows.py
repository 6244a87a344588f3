# SPDX-License-Identifier: MIT
"""Rows of data files: read, written, formatted, and made of an analysis of `trophic analyze`."""
import csv
import math
import re

import installed

installed.make_importable()
from trophic import statistics
from trophic.statistics import holm


def read(table):
    """The rows of a CSV file."""
    with open(table, newline="") as file:
        return list(csv.DictReader(file))


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
