# SPDX-License-Identifier: MIT
"""Cells of tables of the documents, and their rows."""
import data_rows

TITLES = {
    "attribution_caught": "inherited among the caught prey",
    "attribution_credited": "prey deaths credited to inherited predators",
    "attribution_catches": "catches by inherited predators",
    "attribution_catchers": "inherited among the predators that ever caught",
    "velocity": "velocity",
    "wall_sticking": "at walls",
    "wall_sticking_gap": "at walls, prey less predators",
    "tag_symmetry": "tag symmetry",
    "deaths": "deaths in a run",
    "ticks_at": "share of time with",
    "stuck": "stuck",
}


def is_velocity(row):
    return row["metric"].startswith("velocity")


def digits(row, text, sign=False):
    """A formatted value: cm/s with two decimals, counts with one, shares with three."""
    if text == "":
        return ""
    scale, places = (100.0, 2) if is_velocity(row) else (1.0, 1) if row["metric"] == "deaths" else (1.0, 3)
    return data_rows.fixed(scale * float(text), places, "+" if sign else "")


def ranged(row, keys, sign=False):
    middle, lower, upper = (digits(row, row[key], sign) for key in keys)
    return middle if lower == "" else f"{middle} [{lower}, {upper}]"


def signed(row, keys, scale=1.0, sign="+"):
    """A difference with its interval, to three figures; alone if it has no interval."""
    middle, lower, upper = (row[key] and f"{scale * float(row[key]):{sign}.3g}" for key in keys)
    return middle + (f" [{lower}, {upper}]" if lower else "")


def star(p):
    return "*" if p and float(p) <= 0.05 else ""


GENOMES = ("brain_", "gait_", "body_", "gene")  # measures of genomes begin so


def star_over(null, metric, p):
    """A star of a difference from this null, if it is the one that the measure asks for where numbers are constant: the neutral null of a measure of
    genomes, the shadow of behaviour. Without inheritance genomes stay founders', so a difference from the shadow shows mutation, not selection.
    """
    return star(p) if null == ("neutral" if metric.startswith(GENOMES) else "shadow") else ""


def title(row):
    """The name of a metric in words."""
    metric, species, group = row["metric"], row["species"], row["group"]
    if metric.startswith("attribution") or metric.startswith("tag_symmetry") or metric == "wall_sticking_gap":
        words = TITLES.get(metric, metric)
        return words if group in ("all", "inherited") else f"{words} ({group.replace('_', ', ')})"
    if metric == "deaths":
        species = {"predator": "predators"}.get(species, species)
        return f"{species} dead" if group == "all" else f"{species} {group}"
    if metric == "ticks_at":
        return f"share of time with {group} predators"
    species = {"predator": "predators"}.get(species, species)
    who = species if group == "all" else f"{group} {species}"
    kinds = {"velocity_stored": "velocity to the stored adversary", "velocity_points": "velocity every 200 s"}
    words = kinds.get(metric, TITLES.get(metric, metric))
    return f"{words} of {who}" + (", cm/s" if is_velocity(row) else "")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def key_of(row):
    return row["metric"], row["species"], row["group"]


def of_key(rows, key):
    return next((row for row in rows if key_of(row) == key), None)


SIDES = {"prey": "prey", "predator": "predators"}


def estimated(of):
    if not of.runs:
        return "not run"
    return f"{of.mean:.3g}" + (f" [{of.interval[0]:.3g}, {of.interval[1]:.3g}]" if of.interval else "")


def family(row, scale=1.0, places=2):
    """A difference with the interval that holds for its whole family at once, or with its own if it is not tested."""
    kind = "together" if row["together_lower"] else "difference"
    middle, *bounds = (scale * float(row[name]) for name in ("difference", f"{kind}_lower", f"{kind}_upper"))
    return f"{middle:+.{places}f} [{bounds[0]:+.{places}f}, {bounds[1]:+.{places}f}]"


def share(row):
    return f"{float(row['mean']):.2f} [{float(row['lower']):.2f}, {float(row['upper']):.2f}]"
