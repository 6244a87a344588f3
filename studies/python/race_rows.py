# SPDX-License-Identifier: MIT
"""Rows of races: progress in contests, velocities, and lineages."""
import data_rows


def progress_rows(cell, progress):
    """Progress over the shadow, by kind of opponents, species and period, from a progress.csv."""
    return [
        {
            **cell,
            "measure": f"{'global' if row['against'] == 'others' else 'historical'} {row['period']}",
            "species": row["species"],
            "runs": row["runs"],
            **{
                key: row[name] and data_rows.number(float(row[name]))
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
        for row in data_rows.read(progress)
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
                        *data_rows.welch(
                            *([float(one[key]) for key in ("mean", "deviation", "runs")] for one in (row, theirs))
                        ),
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
                    key: data_rows.number(100.0 * float(row[name])) if row[name] != "" else ""
                    for key, name in zip(("mean", "shadow", "over_shadow", "lower", "upper"), ("mean", *names))
                },
                "p_holm": "",
            }
        )
    return rows


def raced(summary):
    return [
        row
        for row in data_rows.set_rows("", summary)
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
                    "mean": data_rows.number(metric["mean"]),
                    "null": null["name"],
                    "null_mean": data_rows.number(null.get("value")),
                    **{key: data_rows.number(null.get(key)) for key in ("difference", "lower", "upper")},
                    "p_holm": data_rows.number(null.get("p_adjusted")),
                }
            )
    return rows
