# SPDX-License-Identifier: MIT
"""Rows of what evolves: over survival alone, and lives and generations."""
import pathlib

import data_rows


def compared_raw(differences):
    """The rows of raw differences that have both means."""
    return [row for row in data_rows.read(differences) if row["compared"] == "raw" and row["mean_a"] and row["mean_b"]]


def over_survival(row, scale):
    """Numbers of runs, means and difference of a comparison with survival alone; the numbers in the unit that `scale` makes."""
    scaled = {
        name: row[key] and data_rows.number(scale * float(row[key]))
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
    shadows = {
        (row["metric"], row["species"], row["group"]): row for row in data_rows.read(means) if row["null"] == "shadow"
    }
    neutrals = {
        (row["metric"], row["species"], row["group"]): row for row in (compared_raw(neutral) if neutral else ())
    }
    rows = []
    for row in compared_raw(differences):
        key = (row["metric"], row["species"], row["group"])
        scale = 100.0 if row["unit"] == "m/s" else 1.0
        shadow = shadows.get(key, {})
        of_shadow = {
            name: shadow.get(column) and data_rows.number(scale * float(shadow[column]))
            for name, column in (
                ("shadow", "null_mean"),
                ("over_shadow", "difference"),
                ("shadow_lower", "difference_lower"),
                ("shadow_upper", "difference_upper"),
            )
        }
        null = neutrals.get(key, {})
        of_neutral = {
            name: data_rows.number(scale * float(null[column])) if null.get(column) else ""
            for name, column in (
                ("neutral", "mean_a"),
                ("over_neutral", "difference"),
                ("neutral_lower", "lower"),
                ("neutral_upper", "upper"),
            )
        }
        p_values = {
            name: of.get("p_holm") and data_rows.number(float(of["p_holm"]))
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
            "p": row["p"] and data_rows.number(float(row["p"])),
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
        for row in sorted(data_rows.read(phylogeny), key=lambda row: int(row["id"])):
            depth[row["id"]] = 0 if row["ancestor_id"] == row["id"] else depth[row["ancestor_id"]] + 1
            depths.append(depth[row["id"]])
        diverged = sum(
            row["event"] == "death" and row["cause"] == "diverged"
            for row in data_rows.read(phylogeny.parent / "events.csv")
        )
        counts.append((len(depths), data_rows.mean(depths), max(depths), diverged))
    return {
        name: data_rows.number(data_rows.mean(values))
        for name, values in zip(("births", "mean_depth", "greatest_depth", "diverged"), zip(*counts))
    }


def generations_of(runs):
    """Births after the start by founder of each species, as means over runs."""
    births = {}
    for events in sorted(pathlib.Path(runs).glob("replicate-*/events.csv")):
        for row in data_rows.read(events):
            if row["event"] == "birth":
                births.setdefault(row["species"], [0, 0])[int(row["tick"]) > 0] += 1
    return {species: data_rows.number(born / founders) for species, (founders, born) in births.items()}
