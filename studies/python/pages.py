# SPDX-License-Identifier: MIT
"""Tables of the documents between <!-- table: NAME --> and <!-- /table -->, from results/data."""
import itertools
import re
import sys

import answers
import bodies_race
import designs
import open_ended
import ponds
import provenance
import zones
from designs import p_text
from trophic import statistics

MARKED = re.compile(r"(<!-- table: ([\w ]+) -->\n).*?(<!-- /table -->)", re.S)
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


class Data:
    """The rows of data files by their names; `used` are those read since it was last emptied."""

    def __init__(self, folder):
        self.folder = folder
        self.origins = provenance.read(folder)
        self.used = []

    def __call__(self, name):
        self.used += [name] if name not in self.used else []
        path = self.folder / f"{name}.csv"
        if not path.exists():
            raise SystemExit(f"{path}: no such file; the stage of studies/reproduce that writes it has not run")
        return designs.read(path)


def is_velocity(row):
    return row["metric"].startswith("velocity")


def digits(row, text, sign=False):
    """A formatted value: cm/s with two decimals, counts with one, shares with three."""
    if text == "":
        return ""
    scale, places = (100.0, 2) if is_velocity(row) else (1.0, 1) if row["metric"] == "deaths" else (1.0, 3)
    return designs.fixed(scale * float(text), places, "+" if sign else "")


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


def claims(rows):
    """The conclusion about each published figure under each reading."""
    lines, last = [], None
    for row in rows:
        claim = row["claim"] if row["claim"] != last else ""
        last = row["claim"]
        reading = ", ".join(part for part in (row["members"], row["counting"]) if part)
        margin = f"{digits(row, row['margin'])} ({row['margin_from']})" if row["margin"] else "unknown"
        lines.append(
            [
                claim,
                reading,
                digits(row, row["published"]),
                margin,
                ranged(row, ("mean", "lower", "upper")),
                row["conclusion"],
            ]
        )
    return table(["published figure", "reading", "published", "margin", "ours", "conclusion"], lines)


AGAINST_SHADOW = [
    ("attribution_caught", "prey", "all"),
    ("attribution_catches", "predator", "all"),
    ("attribution_catchers", "predator", "all"),
    ("attribution_credited", "predator", "all"),
    ("velocity", "prey", "random"),
    ("velocity", "prey", "inherited"),
    ("velocity", "prey", "active"),
    ("velocity", "predator", "random"),
    ("velocity", "predator", "inherited"),
    ("wall_sticking", "prey", "all"),
    ("wall_sticking", "predator", "all"),
    ("wall_sticking_gap", "prey-predator", "all"),
    ("tag_symmetry", "prey+predator", "inherited"),
    ("deaths", "prey", "caught"),
    ("deaths", "predator", "all"),
    ("ticks_at", "predator", "8"),
]


def against_shadow(rows):
    """A set and its neutral shadow."""
    lines = []
    for key in AGAINST_SHADOW:
        for row in rows:
            if (row["metric"], row["species"], row["group"]) != key or not row["mean"]:
                continue
            says = {"inconclusive": "no significant difference", "same": "as the metric that it repeats"}.get(
                row["conclusion"], row["conclusion"]
            )
            lines.append(
                [
                    title(row),
                    ranged(row, ("mean", "lower", "upper")),
                    digits(row, row["shadow"]),
                    ranged(row, ("difference", "difference_lower", "difference_upper"), True),
                    p_text(row["p_holm"]),
                    says,
                ]
            )
    return table(["metric", "ours", "shadow", "difference", "p (Holm)", "against the shadow"], lines)


GRID = [
    ("attribution_caught", "prey", "all"),
    ("attribution_credited", "predator", "all"),
    ("velocity", "prey", "all"),
    ("velocity", "prey", "inherited"),
    ("velocity", "predator", "all"),
    ("velocity", "predator", "inherited"),
    ("wall_sticking", "prey", "all"),
    ("wall_sticking", "predator", "all"),
    ("tag_symmetry", "prey+predator", "inherited"),
]
SHORT = [
    "caught prey inherited",
    "credited to inherited predators",
    "prey",
    "inherited prey",
    "predators",
    "inherited predators",
    "prey at walls",
    "predators at walls",
    "tag symmetry",
]


def key_of(row):
    return row["metric"], row["species"], row["group"]


def of_key(rows, key):
    return next((row for row in rows if key_of(row) == key), None)


def ranges(rows):
    """The parent's range and activity, and the distance of activation."""
    lines = []
    for parent in ("active", "any"):
        for activation in sorted({row["activation_m"] for row in rows}, reverse=True):
            for range_m in sorted({row["range_m"] for row in rows}, key=float):
                cell = [
                    row
                    for row in rows
                    if (row["parent"], row["activation_m"], row["range_m"]) == (parent, activation, range_m)
                ]
                prey = of_key(cell, ("velocity", "prey", "inherited"))
                caught = of_key(cell, ("attribution_caught", "prey", "all"))
                lines.append(
                    [
                        parent,
                        range_m,
                        activation,
                        cell[0]["parent_found"],
                        digits(caught, caught["shadow"]),
                        *(digits(of_key(cell, key), of_key(cell, key)["mean"]) for key in GRID),
                        ranged(prey, ("difference", "difference_lower", "difference_upper"), True),
                    ]
                )
    return table(
        [
            "parent",
            "range, m",
            "activation, m",
            "parent found",
            "caught prey inherited, shadow",
            *SHORT,
            "inherited prey over the shadow",
        ],
        lines,
    )


def bodies(rows, base="paper"):
    """Choices swapped on MuJoCo."""
    lines = []
    for name in dict.fromkeys(row["set"] for row in rows):
        cell = [row for row in rows if row["set"] == name]
        lines.append([name, cell[0]["runs"], *(ranged(of_key(cell, key), ("mean", "lower", "upper")) for key in GRID)])
    return table([f"swapped in `{base}`", "runs", *SHORT], lines)


COMPARED = [
    ("attribution_credited", "predator", "all"),
    ("velocity", "prey", "all"),
    ("velocity", "predator", "all"),
    ("velocity", "predator", "inherited"),
    ("wall_sticking", "prey", "all"),
    ("wall_sticking", "predator", "all"),
]


def changes(rows, base="paper"):
    """The differences of choices swapped on MuJoCo from the set without a change, with Welch's intervals."""
    lines = []
    for name in dict.fromkeys(row["set"] for row in rows if row["set"] != base):
        line = [name]
        for key in COMPARED:
            ours, theirs = (of_key([row for row in rows if row["set"] == of], key) for of in (name, base))
            numbers = ([float(one[column]) for column in ("mean", "deviation", "runs")] for one in (ours, theirs))
            middle, lower, upper = (digits(ours, value, True) for value in designs.welch(*numbers))
            line.append(f"{middle} [{lower}, {upper}]")
        lines.append(line)
    return table([f"swapped in `{base}`", *(SHORT[GRID.index(key)] for key in COMPARED)], lines)


def at_walls(rows, base="released"):
    """The share of predators at walls with one thing changed, and Welch's interval of the difference to the set without a change."""
    of_set = {
        row["set"]: row
        for row in rows
        if (row["metric"], row["species"], row["group"]) == ("wall_sticking", "predator", "all")
    }
    lines = []
    for name, row in of_set.items():
        if name != base:
            middle, lower, upper = designs.welch(
                *([float(one[key]) for key in ("mean", "deviation", "runs")] for one in (row, of_set[base]))
            )
            lines.append(
                [
                    name,
                    row["runs"],
                    digits(row, row["mean"]),
                    digits(row, of_set[base]["mean"]),
                    f"{middle:+.3f} [{lower:+.3f}, {upper:+.3f}]",
                ]
            )
    return table([f"swapped in `{base}`", "runs", "predators at walls", f"in `{base}`", "difference"], lines)


EFFECTS = [
    ("velocity", "prey", "inherited", "1"),
    ("velocity", "predator", "inherited", "1"),
    ("velocity", "prey", "all", "0"),
    ("velocity", "predator", "all", "0"),
    ("attribution_caught", "prey", "all", "0"),
    ("attribution_credited", "predator", "all", "0"),
    ("wall_sticking", "prey", "all", "0"),
    ("wall_sticking", "predator", "all", "0"),
    ("tag_symmetry", "prey+predator", "inherited", "0"),
]
EFFECT_HEADS = [
    "inherited prey over the shadow, cm/s",
    "inherited predators over the shadow, cm/s",
    "prey, cm/s",
    "predators, cm/s",
    "caught prey inherited",
    "credited to inherited predators",
    "prey at walls",
    "predators at walls",
    "tag symmetry",
]


def effects(rows):
    """The effect of the other reading of each open choice, averaged over both readings of the others."""
    names = list(dict.fromkeys(row["choice"] for row in rows))
    lines, sizes = [], {}
    for name in names:
        line = [f"`{name}`"]
        for key in EFFECTS:
            row = next(
                row
                for row in rows
                if row["choice"] == name and (row["metric"], row["species"], row["group"], row["over_shadow"]) == key
            )
            line.append(digits(row, row["effect"], True) + star(row["p_holm"]))
            sizes[name] = sizes.get(name, 0) + line[-1].endswith("*")
        lines.append(line)
    lines.sort(key=lambda line: -sizes[line[0].strip("`")])
    return table(["choice", *EFFECT_HEADS], lines)


PUBLISHED = {
    ("velocity", "prey", "all", "0"): (-0.0067, "prey velocity, all"),
    ("velocity", "prey", "active", "0"): (-0.0067, "prey velocity, active"),
    ("velocity", "predator", "all", "0"): (0.0195, "predator velocity, all"),
    ("attribution_caught", "prey", "all", "0"): (0.65, "attribution of prey"),
    ("attribution_credited", "predator", "all", "0"): (0.725, "attribution of predators"),
    ("wall_sticking", "prey", "all", "0"): (0.60, "prey at walls"),
    ("wall_sticking", "predator", "all", "0"): (0.39, "predators at walls"),
    ("wall_sticking_gap", "prey-predator", "all", "0"): (0.21, "difference at walls"),
    ("tag_symmetry", "prey+predator", "inherited", "0"): (0.43, "tag symmetry"),
}


def margins_of(claims):
    """The margin of each metric of a table of claims, {(metric, species): margin}; other readings have that of the first."""
    plain = {"velocity": "velocity_stored"}
    return {
        (key[0], key[1]): float(
            next(
                row["margin"]
                for row in claims
                if row["metric"] == plain.get(key[0], key[0]) and row["species"] == key[1]
            )
        )
        for key in PUBLISHED
    }


def reached(rows, claims):
    """The number of cells of the design with a mean within a margin of each published figure."""
    margins = margins_of(claims)
    names = [name for name in rows[0] if name not in ("metric", "species", "group", "over_shadow", "runs", "mean")]
    lines = []
    for key, (value, words) in PUBLISHED.items():
        cells = [
            row
            for row in rows
            if (row["metric"], row["species"], row["group"], row["over_shadow"]) == key and row["mean"]
        ]
        margin = margins[key[0], key[1]]
        inside = [row for row in cells if abs(float(row["mean"]) - value) <= margin]
        low, high = min(float(row["mean"]) for row in cells), max(float(row["mean"]) for row in cells)
        lines.append(
            [
                words,
                digits(cells[0], str(value)),
                digits(cells[0], str(margin)),
                f"{digits(cells[0], str(low))} to {digits(cells[0], str(high))}",
                f"{len(inside)} of {len(cells)}",
            ]
        )
    within = {}
    for key, (value, _) in PUBLISHED.items():
        for row in rows:
            if (row["metric"], row["species"], row["group"], row["over_shadow"]) == key and row["mean"]:
                cell = tuple(row[name] for name in names)
                within[cell] = within.get(cell, 0) + (abs(float(row["mean"]) - value) <= margins[key[0], key[1]])
    most = max(within.values())
    lines.append(
        [
            "most figures in one cell",
            "",
            "",
            "",
            f"{most} of {len(PUBLISHED)} (cells: {sum(count == most for count in within.values())})",
        ]
    )
    return table(
        ["published figure", "published", "margin", "range of the cells' means", "cells within the margin"], lines
    )


def swaps(rows, into):
    """Rule swaps with a significant effect on a metric of the claims."""
    return table(
        [f"put into `{into}`", "metric", "before", "after", "difference", "p (Holm)"],
        [
            [
                row["swap"],
                title(row) + (", over the shadow" if row["over_shadow"] == "1" else ""),
                digits(row, row["base"]),
                digits(row, row["swapped"]),
                ranged(row, ("difference", "lower", "upper"), True),
                row["p_holm"],
            ]
            for row in rows
            if row["from"] == into
        ],
    )


def inheritance(rows):
    """The effect of each value of a grid on each metric, averaged over the other axes."""
    values = list(dict.fromkeys((row["axis"], row["reference"], row["value"]) for row in rows))
    metrics = list(
        dict.fromkeys(
            (row["metric"], row["species"], row["group"], row["over_shadow"])
            for row in rows
            if "active" not in row["group"]
        )
    )
    lines = []
    for axis, reference, value in values:
        cells = [row for row in rows if (row["axis"], row["value"]) == (axis, value)]
        line = [f"`{axis}`", f"{float(reference):.3g} -> {float(value):.3g}"]
        for metric in metrics:
            row = next(
                row for row in cells if (row["metric"], row["species"], row["group"], row["over_shadow"]) == metric
            )
            line.append(ranged(row, ("difference", "lower", "upper"), True) + star(row["p_holm"]))
        lines.append(line)
    heads = []
    for metric in metrics:
        row = dict(zip(("metric", "species", "group"), metric))
        heads.append(title(row) + (", over the shadow" if metric[3] == "1" else ""))
    return table(["parameter", "change", *heads], lines)


def seconds(row, places=1):
    """A difference from the shadow with its interval."""
    if not row or not row["lower"]:
        return "too few runs"
    return "{} [{}, {}]".format(
        *(designs.fixed(float(row[key]), places, "+") for key in ("over_shadow", "lower", "upper"))
    )


def race_answer(late, cells):
    """The decision rule of the study: late global progress of both species above the shadow, Holm over the two, corrected for the cells of the table."""
    better = [
        species
        for species, row in late.items()
        if row["p_holm"] and cells * float(row["p_holm"]) <= 0.05 and float(row["over_shadow"]) > 0.0
    ]
    if any(not row["p_holm"] for row in late.values()):
        return "too few runs"
    return (
        "arms race"
        if len(better) == 2
        else f"progress of {better[0].replace('predator', 'predators')}"
        if better
        else "none found"
    )


RACED = [
    ("velocity", "prey", "prey, cm/s"),
    ("velocity", "predator", "predators, cm/s"),
    ("global early", "predator", "predators early, s"),
    ("global early", "prey", "prey early, s"),
    ("global late", "predator", "predators late, s"),
    ("global late", "prey", "prey late, s"),
]


def race(rows):
    """Velocity and global progress over the shadow, as far as they are measured, and the answer of the decision rule, in each cell."""
    columns = [column for column in RACED if any((row["measure"], row["species"]) == column[:2] for row in rows)]
    lines = []
    cells = list(dict.fromkeys(row["cell"] for row in rows))
    for cell in cells:
        of_cell = {(row["measure"], row["species"]): row for row in rows if row["cell"] == cell}
        late = {species: of_cell["global late", species] for species in ("predator", "prey")}
        lines.append(
            [
                f"`{cell}`",
                *(
                    seconds(of_cell.get((measure, species)), 2 if measure == "velocity" else 1)
                    for measure, species, _ in columns
                ),
                late["prey"]["runs"],
                race_answer(late, len(cells)),
            ]
        )
    return table(["cell", *(head for _, _, head in columns), "runs", "arms race"], lines)


def historical(rows):
    """Progress against opponents from the same run."""
    lines = []
    for cell in dict.fromkeys(row["cell"] for row in rows if row["measure"].startswith("historical")):
        of_cell = {(row["measure"], row["species"]): row for row in rows if row["cell"] == cell}
        lines.append(
            [
                f"`{cell}`",
                *(
                    seconds(of_cell.get((f"historical {period}", species)))
                    for period in ("early", "late")
                    for species in ("predator", "prey")
                ),
            ]
        )
    return table(["cell", "predators early, s", "prey early, s", "predators late, s", "prey late, s"], lines)


LINEAGES = [
    "modes_change",
    "modes_novelty",
    "modes_ecology",
    "modes_complexity",
    "activity_excess",
    "activity_new",
    "descent_roots",
    "descent_largest_clade",
    "descent_common_ancestor",
]


def lineages(rows):
    """Lineage measures of each cell that differ significantly from the null that fits: drift for types, the shadow for descent."""
    lines = []
    for cell in dict.fromkeys(row["cell"] for row in rows):
        for measure in LINEAGES:
            group, null = ("all", "shadow") if measure.startswith("descent") else ("late", "drift")
            line = [f"`{cell}`", f"{measure}, {group}", null]
            for species in ("prey", "predator"):
                row = next(
                    row
                    for row in rows
                    if (row["cell"], row["measure"], row["species"], row["group"], row["null"])
                    == (cell, measure, species, group, null)
                )
                line.append(f"{float(row['mean']):.3g}" if row["mean"] else "")
                line.append(signed(row, ("difference", "lower", "upper")) + star(row["p_holm"]) if row["lower"] else "")
            lines += [line] if "*" in "".join(line) else []
    return table(
        ["cell", "measure", "null", "prey", "prey over the null", "predators", "predators over the null"], lines
    )


EVOLVED = {
    "brains": ["walked", "open_speed", "wall_contact", "brain_genes"],
    "gaits": ["walked", "gait_genes"],
    "bodies": [
        "walked",
        "body_modules",
        "body_hinges",
        "body_proportion",
        "body_symmetry",
        "body_plans",
        "body_change",
    ],
}


def evolved(rows, study):
    """Measures of the late half of the runs, over survival alone, the shadow and, if it was run, the neutral null; * after Holm's correction for all
    measures of a comparison."""
    lines, has_neutral = [], any(row["neutral"] for row in rows if row["study"] == study)
    for metric in EVOLVED[study]:
        for species in ("predator", "prey"):
            found = [
                row
                for row in rows
                if (row["study"], row["metric"], row["species"], row["group"]) == (study, metric, species, "late")
            ]
            for row in found:
                neutral = (
                    signed(row, ("over_neutral", "neutral_lower", "neutral_upper"))
                    + star_over("neutral", metric, row["neutral_p_holm"])
                    if row["neutral"]
                    else ""
                )
                lines.append(
                    [
                        f"{metric}, {row['unit']}" if row["unit"] != "1" else metric,
                        {"predator": "predators"}.get(species, species),
                        f"{float(row['mean']):.3g}",
                        f"{float(row['survival']):.3g}",
                        signed(row, ("over_survival", "lower", "upper")) + star(row["p_holm"]),
                        row["shadow"] and f"{float(row['shadow']):.3g}",
                        signed(row, ("over_shadow", "shadow_lower", "shadow_upper"))
                        + star_over("shadow", metric, row["shadow_p_holm"]),
                        *([neutral] if has_neutral else []),
                        f"{row['runs']} + {row['survival_runs']}",
                    ]
                )
    return table(
        [
            "measure, late half",
            "of",
            "inheritance",
            "survival alone",
            "over survival alone",
            "shadow",
            "over the shadow",
            *(["over the neutral null"] if has_neutral else []),
            "runs",
        ],
        lines,
    )


def evolved_again(rows):
    """The measure of the second study of bodies, over survival alone; p is uncorrected, since there is one measure."""
    return table(
        ["measure, late half", "of", "inheritance", "survival alone", "over survival alone", "p", "runs"],
        [
            [
                "walked, cm/s",
                row["species"],
                f"{float(row['mean']):.3g}",
                f"{float(row['survival']):.3g}",
                signed(row, ("over_survival", "lower", "upper")),
                f"{float(row['p']):.2g}",
                f"{row['runs']} + {row['survival_runs']}",
            ]
            for row in rows
        ],
    )


def evolved_lives(rows):
    """Births and ancestors a run."""
    return table(
        ["study", "rule table", "births", "ancestors of a newborn, mean", "at most", "bodies that diverged"],
        [
            [
                row["study"],
                f"`{row['table']}`",
                *(
                    f"{float(row[key]):.{places}f}"
                    for key, places in (("births", 0), ("mean_depth", 1), ("greatest_depth", 0), ("diverged", 1))
                ),
            ]
            for row in rows
        ],
    )


QUEEN = {
    "gene_change": "gene_change",
    "turn_change": "turn_change",
    "progress_late": "progress, late, s",
    "progress_early": "progress, early, s",
}


def queen(rows, primary, *names):
    """Differences of a side between worlds in which the other one inherits and does not, in these tables; * after Holm's correction for the family."""
    lines = []
    for row in rows:
        name = row["table"].removesuffix("_by_side")
        if name not in names or (row["family"] == "primary") != primary or row["measure"].startswith("mutation"):
            continue
        words = QUEEN.get(
            row["measure"],
            row["measure"].replace("_all", " of `turns_to`").replace("_late", " of `turns_to`, last third"),
        )
        lines.append(
            [
                f"`{name}`",
                words,
                {"predator": "predators"}.get(row["side"], row["side"]),
                *(row[key] and f"{float(row[key]):+.3g}" for key in ("both", row["side"])),
                signed(row, ("difference", "lower", "upper")) + star(row["p_holm"]),
                p_text(row["p_holm"]),
                row["detectable"] and f"{float(row['detectable']):.2g}",
                row["runs"],
            ]
        )
    return table(
        [
            "table",
            "measure",
            "side",
            "both inherit",
            "this side alone",
            "both less alone",
            "p (Holm)",
            "found in 80 %",
            "runs",
        ],
        lines,
    )


PACE = {
    "trait_end": "pace at the end",
    "trait_slope": "rise of pace in the last third, per 1000 s",
    "trait_common": "pace near 8000 s, all runs",
    "trait_last_both": "pace at the last time with both, all runs",
    "sight_m_trait_end": "sight at the end, m",
    "sight_m_trait_slope": "rise of sight in the last third, m per 1000 s",
    "at_bound": "share within 5 % of the bound",
    "number": "number in the last third",
    "progress_early": "progress to 8000 s, s",
    "progress_third": "progress in the last third, s",
    "progress_late": "progress from 8000 s on, s",
}
RACE = {"pond_race": "first", "pond_race_again": "fresh", "pond_race_more": "further"}
OTHER_RACES = {"pond_race_small_steps": "sd 0.03", "pond_sight": "sight, square costs"}
SIDES = {"prey": "prey", "predator": "predators"}


def race_sets(data, file, sets):
    """The rows of sets of runs that are made, with their names in words."""
    return [
        (words, row) for name, words in sets.items() if f"{name}{file}" in data.origins for row in data(name + file)
    ]


def paces(data, sets=RACE):
    """Primary differences of a side between the world in which both inherit and that in which it alone does; * after Holm's correction."""
    lines = [
        [
            PACE[row["measure"]],
            SIDES[row["side"]],
            words,
            *(row[key] and f"{float(row[key]):+.3g}" for key in ("both", row["side"], "none")),
            signed(row, ("difference", "lower", "upper")) + star(row["p_holm"]),
            p_text(row["p_holm"]),
            row["detectable"] and f"{float(row['detectable']):.2g}",
            f"{row['runs']}, {row['alone_runs']}",
        ]
        for words, row in race_sets(data, "", sets)
        if row["family"] == "primary"
    ]
    lines.sort(key=lambda line: (list(PACE.values()).index(line[0]), list(SIDES.values()).index(line[1])))
    head = ["measure", "side", "seeds", "both inherit", "this side alone", "none", "both less alone", "p (Holm)"]
    return table([*head, "found in 80 %", "runs: both, alone"], lines)


def in_each_world(data, sets=RACE):
    """The mean of each measure of a side, with its interval over runs, in the worlds in which the side inherits."""
    found = {}
    for words, row in race_sets(data, "_values", sets):
        if row["measure"] in PACE and row["value"]:
            found.setdefault((row["measure"], row["side"], words), {}).setdefault(row["world"], []).append(
                float(row["value"])
            )
    lines = []
    for measure, words in PACE.items():
        for side, sides in SIDES.items():
            for of_set in sets.values():
                worlds = found.get((measure, side, of_set), {})
                cells = [statistics.estimate(worlds.get(world, [])) for world in ("both", side)]
                if any(cell.runs for cell in cells):
                    lines.append([words, sides, of_set, *(estimated(cell) for cell in cells)])
    return table(["measure", "side", "seeds", "both inherit", "this side alone"], lines)


def estimated(of):
    if not of.runs:
        return "not run"
    return f"{of.mean:.3g}" + (f" [{of.interval[0]:.3g}, {of.interval[1]:.3g}]" if of.interval else "")


QUESTIONS = {
    "Does it go on?": ("_goes_on", {"trait_slope": "pace", "progress_third": "contests"}, "goes on"),
    "Does the other side drive it?": ("", {"trait_end": "pace", "progress_late": "contests"}, "driven"),
}


def race_answers(data):
    """The answers by the rule of the design: yes, if both measures of a side are greater after correction in two sets that follow one another."""
    lines = []
    for question, (file, measures, word) in QUESTIONS.items():
        rows = race_sets(data, file, RACE)
        for side, sides in SIDES.items():
            greater = {
                words: [
                    name
                    for measure, name in measures.items()
                    for of, row in rows
                    if (of, row["side"], row["measure"]) == (words, side, measure)
                    and star(row["p_holm"])
                    and float(row["difference"]) > 0.0
                ]
                for words in dict.fromkeys(of for of, _ in rows)
            }
            all_of = [len(greater.get(of, [])) == len(measures) for of in RACE.values()]
            answer = word if any(all(pair) for pair in itertools.pairwise(all_of)) else "undecided"
            lines.append(
                [
                    question,
                    sides,
                    *(" and ".join(greater.get(of, ["not run"])) or "neither" for of in RACE.values()),
                    answer,
                ]
            )
    return table(["question", "side", *(f"greater in the {of} runs" for of in RACE.values()), "answer"], lines)


def pooled_paces(data):
    """Differences of a side between the world in which both inherit and that in which it alone does, over the runs of all sets; described."""
    values = {}
    for _, row in race_sets(data, "_values", RACE):
        if row["value"]:
            values.setdefault((row["measure"], row["side"], row["world"]), []).append(float(row["value"]))
    lines = []
    for measure, side in itertools.product(QUESTIONS["Does the other side drive it?"][1], SIDES):
        both, alone = (values.get((measure, side, world), []) for world in ("both", side))
        if of := statistics.contrast((1.0, both), (-1.0, alone)):
            interval = "{:+.3g} [{:+.3g}, {:+.3g}]".format(of.value, *statistics.interval_of(of))
            lines.append([PACE[measure], SIDES[side], interval, f"{len(both)}, {len(alone)}"])
    return table(["measure", "side", "both less alone", "runs: both, alone"], lines)


def going_on(data, sets=RACE):
    """Whether pace and contests still move in the last third where both inherit; * after Holm's correction."""
    lines = [
        [
            PACE[row["measure"]],
            SIDES[row["side"]],
            words,
            signed(row, ("difference", "lower", "upper")) + star(row["p_holm"]),
            {"none": "the world of none"}.get(row["over"], row["over"]),
            p_text(row["p_holm"]),
            row["detectable"] and f"{float(row['detectable']):.2g}",
            row["runs"],
        ]
        for words, row in race_sets(data, "_goes_on", sets)
    ]
    lines.sort(key=lambda line: (list(PACE.values()).index(line[0]), list(SIDES.values()).index(line[1])))
    return table(["measure", "side", "seeds", "both inherit", "over", "p (Holm)", "found in 80 %", "runs"], lines)


def through_time(data, sets=RACE):
    """How long hunters of each time take to reach victims of each time."""
    lines = {}
    for words, row in race_sets(data, "_through_time", sets):
        lines.setdefault((words, row["hunters_s"]), []).append(signed(row, ("contact_s", "lower", "upper"), 1.0, ""))
    times = ("the start", "12,000 s", "24,000 s")
    found = {words: [of for (set_, _), of in lines.items() if set_ == words] for words, _ in lines}
    return table(
        ["seeds", "predators of", *(f"prey of {time}" for time in times)],
        [[words, time, *of] for words, rows in found.items() for time, of in zip(times, rows)],
    )


def lasting(data, sets=RACE):
    """How many runs of each world keep both species to the end."""
    lives = {}
    for words, row in race_sets(data, "_values", sets):
        if row["measure"] == "lived_s" and row["side"] == "prey":
            lives.setdefault((words, row["world"]), []).append(float(row["value"]) >= 24000.0)
    worlds = {"both": "both inherit", "prey": "prey alone", "predator": "predators alone", "none": "none"}
    lines = [
        [
            words,
            *(
                f"{sum(of)} of {len(of)}" if of else "not run"
                for of in (lives.get((words, each), []) for each in worlds)
            ),
        ]
        for words in dict.fromkeys(words for words, _ in lives)
    ]
    return table(["seeds", *worlds.values()], lines)


def draw_race(rows, path):
    """The mean pace of each run by time: of each side, if both inherit and if it alone does, with the range of drift."""
    import matplotlib.pyplot as plt

    fig, axes = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained", sharey=True)
    colors = {"both": {"prey": "#1b7837", "predator": "#b2182b"}, "alone": "#8073ac"}
    for ax, (side, words) in zip(axes, SIDES.items()):
        other = SIDES["predator" if side == "prey" else "prey"]
        drift = {}
        for world in (side, "both"):
            of = [row for row in rows if (row["world"], row["side"], row["trait"]) == (world, side, "walking_pace")]
            if not of:
                continue
            color = colors["both"][side] if world == "both" else colors["alone"]
            label = f"{other} evolve too" if world == "both" else f"{words} alone evolve"
            lines, means = {}, {}
            for row in of:
                time_s = float(row["time_s"])
                lines.setdefault(row["run"], []).append((time_s, float(row["mean"])))
                means.setdefault(time_s, []).append(float(row["mean"]))
                drift.setdefault(time_s, []).append((float(row["drift_lower"]), float(row["drift_upper"])))
            for line in lines.values():
                ax.plot(*zip(*line), color=color, alpha=0.25, lw=0.8)
            mean = [(time_s, sum(of) / len(of)) for time_s, of in sorted(means.items())]
            ax.plot(*zip(*mean), color=color, lw=2.5, label=label)
        band = [(time_s, *(sum(each) / len(of) for each in zip(*of))) for time_s, of in sorted(drift.items())]
        times, low, high = zip(*band)
        ax.fill_between(times, low, high, color="grey", alpha=0.25, lw=0, label="drift of a run, 95 %")
        ax.set(title=words, xlabel="time [s]", xlim=(0, max(times)))
        ax.legend(fontsize=8, loc="upper left", frameon=False)
    axes[0].set(ylabel="mean walking pace", ylim=(0, None))
    fig.savefig(path, dpi=150)


def living(rows):
    """Measures of the pond and of its nulls, described: numbers change, so the shadow is not a control of one species."""
    lines, nulls = [], [null for null in ("shadow", "clones", "mean_field") if any(row[null] for row in rows)]
    for row in rows:
        if (
            row["set"] != "pond"
            or not row["mean"]
            or row["metric"]
            in ("persists", "trophic_efficiency", "pyramid_numbers", "search_rate_holling", "handling_time")
        ):
            continue
        scale, unit = (100.0, "cm/s") if row["unit"] == "m/s" else (1.0, "" if row["unit"] == "1" else row["unit"])
        name = ", ".join(filter(None, [row["metric"] + (" (inherited)" if unit == "cm/s" else ""), unit]))
        lines.append(
            [
                name,
                row["species"],
                signed(row, ("mean", "lower", "upper"), scale, ""),
                *(row[null] and f"{scale * float(row[null]):.3g}" for null in nulls),
                signed(row, ("difference", "difference_lower", "difference_upper"), scale),
            ]
        )
    return table(["measure", "of", "pond", *(null.replace("_", " ") for null in nulls), "over the shadow"], lines)


def settings(rows):
    """Persistence and velocity in each setting of the pond."""
    lines = []
    for name in dict.fromkeys(row["set"] for row in rows):
        of = {(row["metric"], row["species"]): row for row in rows if row["set"] == name}
        shares = [of["persists", species] for species in ("all", "prey", "predator")]
        lines.append(
            [
                name,
                *(f"{float(row['mean']):.2f} [{float(row['lower']):.2f}, {float(row['upper']):.2f}]" for row in shares),
                *(
                    "{:+.2f} [{:+.2f}, {:+.2f}]".format(
                        *(
                            100.0 * float(of["velocity", species][key])
                            for key in ("difference", "difference_lower", "difference_upper")
                        )
                    )
                    for species in ("prey", "predator")
                ),
                shares[0]["runs"],
            ]
        )
    return table(
        [
            "setting",
            "both persist",
            "prey",
            "predators",
            "prey over the shadow, cm/s",
            "predators over the shadow, cm/s",
            "runs",
        ],
        lines,
    )


def family(row, scale=1.0, places=2):
    """A difference with the interval that holds for its whole family at once, or with its own if it is not tested."""
    kind = "together" if row["together_lower"] else "difference"
    middle, *bounds = (scale * float(row[name]) for name in ("difference", f"{kind}_lower", f"{kind}_upper"))
    return f"{middle:+.{places}f} [{bounds[0]:+.{places}f}, {bounds[1]:+.{places}f}]"


def share(row):
    return f"{float(row['mean']):.2f} [{float(row['lower']):.2f}, {float(row['upper']):.2f}]"


def worlds(rows):
    """Persistence in the four worlds of the pond, and velocities over the one-sided world of their species."""
    lines = []
    for world in ponds.WORLDS:
        of = {(row["metric"], row["species"], row["family"]): row for row in rows if row["set"] == world}
        tested = [of["velocity", species, "behaviour"] for species in ponds.TESTED]
        lines.append(
            [world, share(of["persists", "all", "described"])]
            + [cell for row in tested for cell in (family(row, 100.0), p_text(row["p_holm"]))]
            + [of["persists", "all", "described"]["runs"]]
        )
    head = ["world", "both persist", "active prey over those that inherit nothing, cm/s", "p (Holm)"]
    return table([*head, "predators over those that inherit nothing, cm/s", "p (Holm)", "runs"], lines)


def world_contrasts(rows):
    """What one condition changes: in what evolves in prey, and in how long both species live."""
    lines = []
    for name, (first, second) in ponds.CONTRASTS.items():
        evolved, lived = (
            next(row for row in rows if (row["set"], row["family"]) == (name, kind))
            for kind in ("contrast", "survival")
        )
        longer = family(lived, places=0) if lived["p"] else "none dies out"
        cells = [family(evolved, 100.0), p_text(evolved["p_holm"]), longer, p_text(lived["p_holm"])]
        lines.append([name, f"{first} less {second}", *cells])
    head = ["condition", "worlds", "active prey, cm/s", "p (Holm)", "both live longer by, s", "p (log-rank, Holm)"]
    return table(head, lines)


def world_activity(rows):
    """Activity in the four worlds, and velocities that are described."""
    lines = []
    for world in ponds.WORLDS:
        of = {
            (row["metric"], row["species"], row["group"], row["null"]): row
            for row in rows
            if (row["set"], row["family"]) == (world, "described")
        }
        shares = [f"{float(of[*key, '']['mean']):.3g}" for key in ponds.ACTIVITY]
        keys = [(*key, ponds.one_sided(key)) for key in ponds.DESCRIBED]
        keys += [(*key, "shadow") for key in ponds.TESTED.values()]
        lines.append([world, *shares, *(family(of[key], 100.0) if key in of else "" for key in keys)])
    head = ["world", "inactive share of prey", "newborn inactive, s"]
    head += [
        "inactive prey over those that inherit nothing, cm/s",
        "all prey, cm/s",
        "active prey over the shadow, cm/s",
    ]
    return table([*head, "predators over the shadow, cm/s"], lines)


def world_selection(rows):
    """Price's terms of turns_to over the neutral null in the four worlds; * after Holm's correction for all."""
    lines = []
    for world in ponds.WORLDS:
        of = {(row["species"], row["group"]): row for row in rows if row["set"] == world}
        keys = [(species, term) for species in ponds.TESTED for term in ponds.TERMS]
        lines.append([world, *(family(of[key]) + star(of[key]["p_holm"]) for key in keys)])
    names = ["prey, survival", "prey, parenthood", "predators, survival", "predators, parenthood"]
    return table(["world", *names], lines)


def draw_worlds(rows, runs, end_s, path):
    """How long both species live in the four worlds, and velocities over the one-sided world of their species."""
    import matplotlib.pyplot as plt

    fig, axes = plt.subplots(1, 3, figsize=(10, 2.9), layout="constrained", width_ratios=(1.3, 1, 1))
    values, colors = ponds.Values(runs), ("#1b7837", "#b2abd2", "#e66101", "#5e3c99")
    for number, (world, color) in enumerate(zip(ponds.WORLDS, colors)):
        lives = values.lives(world, end_s)
        times = sorted(lives.ends_s[lives.died])
        steps = [(0.0, 1.0), *((time, 1.0 - (k + 1) / len(lives.died)) for k, time in enumerate(times))]
        steps.append((end_s, steps[-1][1]))
        axes[0].step(*zip(*steps), where="post", color=color, label=world, ls="-" if number != 1 else ":", lw=2)
        for ax, (species, key) in zip(axes[1:], ponds.TESTED.items()):
            row = next(
                row for row in rows if (row["set"], row["family"], row["species"]) == (world, "behaviour", species)
            )
            middle, low, high = (
                100.0 * float(row[name] or "nan") for name in ("difference", "together_lower", "together_upper")
            )
            ax.errorbar(middle, -number, xerr=[[middle - low], [high - middle]], fmt="o", color=color, capsize=3)
    axes[0].set(xlabel="time [s]", ylabel="share of runs with both species", ylim=(0, 1.03))
    axes[0].legend(fontsize=8, loc="lower left")
    for ax, words in zip(axes[1:], ("active prey", "predators")):
        ax.axvline(0.0, color="grey", lw=0.8)
        ax.set(title=words, xlabel="difference [cm/s]", yticks=[0, -1, -2, -3], ylim=(-3.5, 0.5))
        ax.set_yticklabels(list(ponds.WORLDS) if ax is axes[1] else [""] * 4, fontsize=8)
    fig.savefig(path, dpi=150)


def growth(rows, name="slope"):
    """Slopes at the end in a cell, over the neutral null, and their upper bounds."""
    lines = []
    for row in (row for row in rows if row["family"] == name):
        bound = row["difference_upper"] and row["generation_s"]
        per_generation = f"{float(row['difference_upper']) * float(row['generation_s']) / 1000.0:+.2f}" if bound else ""
        lines.append(
            [
                row["metric"],
                row["species"],
                signed(row, ("mean", "lower", "upper")),
                row["null_mean"] and f"{float(row['null_mean']):+.3g}",
                family(row) if row["together_lower"] else "",
                p_text(row["p_holm"]),
                row["difference_upper"] and f"{float(row['difference_upper']):+.2f}",
                per_generation,
                row["smallest"] and f"{float(row['smallest']):.2f}",
                row["runs"],
            ]
        )
    head = ["measure", "species", "slope per 1000 s", "null", "over the null", "p (Holm)", "at most per 1000 s"]
    return table([*head, "at most per generation", "found in 80 % of studies", "runs"], lines)


def two_by_two(rows, group):
    """Levels or slopes over the neutral null in the cells that are there, and the interaction of all four."""
    of = {
        (row["set"], row["metric"], row["species"], row["group"]): row for row in rows if row["family"] == "described"
    }
    cells = [cell for cell in open_ended.CELLS if any(cell == key[0] for key in of)]
    both = {(row["metric"], row["species"]): row for row in rows if row["family"] == f"interaction of {group}s"}
    described = [(metric, species) for metric in open_ended.DESCRIBED for species in open_ended.SPECIES]
    keys, lines = ("difference", "difference_lower", "difference_upper"), []
    for metric, species in [*open_ended.PAIRS, *described]:
        row = both.get((metric, species))
        lines.append([metric, species, *(signed(of[cell, metric, species, group], keys) for cell in cells)])
        lines[-1] += [family(row), p_text(row["p_holm"])] if row and row["difference"] else ["", ""]
    return table(["measure", "species", *cells, "interaction", "p (Holm)"], lines)


def by_foods(rows):
    """Slopes over the neutral null with two foods, less those with one."""
    of = [row for row in rows if row["family"] == "two foods"]
    lines = [
        [row["metric"], row["species"], family(row), p_text(row["p_holm"]), f"{float(row['smallest'] or 'nan'):.2f}"]
        for row in of
        if row["difference"]
    ]
    return table(["measure", "species", "two foods less one", "p (Holm)", "found in 80 % of studies"], lines)


def kinds_of_diet(first, again):
    """Specialists and clusters among prey with two foods, over their nulls, in the first runs and on fresh seeds."""
    lines = []
    for seeds, rows in (("first", first), ("fresh", again)):
        for row in (row for row in rows if row["family"] == "kinds of diet"):
            mean = signed(row, ("mean", "lower", "upper"))
            null = row["null_mean"] and f"{float(row['null_mean']):+.3g}"
            lines.append(
                [row["metric"], seeds, mean, row["null"], null, family(row), p_text(row["p_holm"]), row["runs"]]
            )
    return table(["measure", "seeds", "mean", "null", "its mean", "over the null", "p (Holm)", "runs"], lines)


def persisting_cells(rows):
    """The share of runs in which both species live to the end, by cell."""
    of = [row for row in rows if row["metric"] == "persists"]
    return table(["cell", "both persist", "runs"], [[row["set"], share(row), row["runs"]] for row in of])


def draw_two_by_two(rows, path):
    """Mean curves of the four cells and of their neutral nulls."""
    import matplotlib.pyplot as plt

    curves = {}
    for row in rows:
        key = (row["metric"], row["species"], row["set"], row["null"])
        curves.setdefault(key, []).append((float(row["time_s"]) / 1000.0, float(row["value"])))
    fig, axes = plt.subplots(2, 4, figsize=(12, 5), layout="constrained", sharex=True)
    colors = dict(zip(open_ended.CELLS, ("#b2abd2", "#5e3c99", "#fdb863", "#e66101")))
    named = {"links": "links in use", "most_links": "greatest links in use", "new_types": "new types", "pace": "pace"}
    for line, species in zip(axes, open_ended.SPECIES):
        for ax, (metric, words) in zip(line, named.items()):
            for cell, color in colors.items():
                for null, style in (("", "-"), ("neutral", ":")):
                    points = curves.get((metric, species, cell, null))
                    label = cell if not null else None
                    if points:
                        ax.plot(*zip(*points), color=color, ls=style, lw=1.6, label=label)
            ax.set(title=f"{words}, {species}" if species == "prey" else f"{words}, predators", ylim=(0, None))
            if species == "predator":
                ax.set_xlabel("time [1000 s]")
    axes[0][0].legend(fontsize=7, loc="lower left")
    fig.savefig(path, dpi=130)
    plt.close(fig)


def selected(rows, of="pond"):
    """Price's terms over the neutral null. With generations they are cm/s a generation, otherwise in the trait's unit."""
    keys, lines = ("runs_mean", "neutral_mean", "difference", "difference_lower", "difference_upper"), []
    for row in designs.over_neutral(rows):
        scale = 100.0 / float(row["generations"]) if "generations" in row else 100.0 if row["unit"] == "m/s" else 1.0
        lines.append(
            [
                row["species"],
                row["term"],
                *(row[key] and f"{scale * float(row[key]):+.3g}" for key in keys[:2]),
                signed(row, keys[2:], scale),
                p_text(row["p_holm"]),
            ]
        )
    return table(["species", "term", of, "neutral null", "over the neutral null", "p (Holm)"], lines)


TURNS = {
    "survival": "survival",
    "parenthood": "parenthood",
    "mutation": "mutation",
    "newcomers": "newcomers",
    "change": "change of the mean: their sum",
    "lives_length": "of a life: by its length",
    "lives_rate": "of a life: by offspring a second",
}


def turning(rows):
    """Terms of the share of inputs at which a brain turns to its adversary; * after Holm's correction for all tests of the command."""
    lines = []
    for term, words in TURNS.items():
        line = [words]
        for species in ("prey", "predator"):
            row = next(
                row for row in rows if (row["trait"], row["species"], row["term"]) == ("turns_to", species, term)
            )
            line.append(signed(row, ("runs_mean", "runs_lower", "runs_upper")))
            difference = signed(row, ("difference", "difference_lower", "difference_upper")) if row["p"] else ""
            line.append(difference + star(row["p_holm"]))
        lines.append(line)
    return table(["sum over a run", "prey", "over the neutral null", "predators", "over the neutral null"], lines)


def turning_by_distance(rows):
    """The tested terms over the neutral null by the distance of the adversary, in metres of the arena of 20 m; * after Holm's correction."""
    lines = []
    for trait in dict.fromkeys(row["trait"] for row in rows if ":" in row["trait"]):
        line = [f"{20.0 * float(trait.partition(':')[2]):.0f}"]
        for species, term in itertools.product(("prey", "predator"), ("survival", "parenthood")):
            row = next(row for row in rows if (row["trait"], row["species"], row["term"]) == (trait, species, term))
            line.append(signed(row, ("difference", "difference_lower", "difference_upper")) + star(row["p_holm"]))
        lines.append(line)
    heads = [f"{words}, {term}" for words, term in itertools.product(("prey", "predators"), ("survival", "parenthood"))]
    return table(["adversary at, m", *heads], lines)


def evolving_ponds(data):
    """Velocities over the shadow and Price's terms of speed of ponds in which gaits, or bodies too, evolve. Without stars: numbers change, so the
    shadow does not control for one species, and these runs have no neutral null."""
    lines = []
    for name, species in itertools.product(("gaits", "bodies"), ("prey", "predator")):
        rows = [
            row
            for part in ("", "_selection")
            for row in data(f"no_criterion_{name}{part}")
            if row["species"] == species and (row["p_holm"] if not part else row["p"])
        ]
        lines.append(
            [
                name,
                species,
                *(signed(row, ("difference", "difference_lower", "difference_upper"), 100.0) for row in rows),
            ]
        )
    return table(["evolve", "species", "velocity over the shadow, cm/s", "survival", "parenthood", "mutation"], lines)


def draw_atlas(rows, path):
    """Maps of persistence and of velocities over the shadow, by reach and growth of food. Bold: the 95 % interval of a cell's difference excludes 0."""
    import matplotlib.pyplot as plt

    fig, axes = plt.subplots(1, 3, figsize=(12, 3.4), sharey=True, layout="constrained")
    towards = "{} over the shadow [cm/s]\n+ towards {}, - away from them"
    for ax, metric, species, key, scale, words in (
        (axes[0], "persists", "all", "mean", 1, "both species live on\n[share of runs]"),
        (axes[1], "velocity", "predator", "over_shadow", 100, towards.format("predators", "prey")),
        (axes[2], "velocity", "prey", "over_shadow", 100, towards.format("prey", "predators")),
    ):
        cells = {
            (float(row["growth_1_s"]), float(row["reach_m"])): row
            for row in rows
            if (row["metric"], row["species"]) == (metric, species)
        }
        of = {at: scale * float(row[key] or "nan") for at, row in cells.items()}
        growths, reaches = (sorted(set(values)) for values in zip(*of))
        limit = max(abs(value) for value in of.values() if value == value)
        image = ax.imshow(
            [[of[growth, reach] for reach in reaches] for growth in growths],
            origin="lower",
            aspect="auto",
            cmap="Greys" if metric == "persists" else "RdBu_r",
            vmin=0 if metric == "persists" else -limit,
            vmax=2 if metric == "persists" else limit,
            alpha=0.7,
        )
        bar = fig.colorbar(image, ax=ax)
        if metric == "persists":
            bar.ax.set_ylim(0, 1)
        for row, growth in enumerate(growths):
            for column, reach in enumerate(reaches):
                cell = cells[growth, reach]
                lower, upper = (float(cell[f"over_{end}"] or "nan") for end in ("lower", "upper"))
                ax.text(
                    column,
                    row,
                    f"{of[growth, reach]:{'.1f' if scale == 1 else '+.2f'}}".replace("+nan", "no run"),
                    ha="center",
                    va="center",
                    fontsize=8,
                    weight="bold" if lower > 0 or upper < 0 else "normal",
                )
        ax.set_title(words, fontsize=9)
        ax.set(
            xlabel="reach of predators [m]",
            xticks=range(len(reaches)),
            xticklabels=reaches,
            yticks=range(len(growths)),
            yticklabels=growths,
        )
    axes[0].set_ylabel("growth of food [1/s]")
    counts = {row["runs"] for row in rows if row["metric"] == "persists"}
    fig.supxlabel(
        f"n = {' to '.join(sorted(counts))} runs and as many shadows a cell; bold: the 95 % interval of the difference from the shadow excludes 0, each cell alone",
        fontsize=8,
    )
    fig.savefig(path, dpi=150)


def walked(row):
    """A speed with its interval, cm/s."""
    return signed(row, ("speed_m_s", "lower", "upper"), 100.0, "")


def walks(rows):
    """How the spider as shipped walks at each pace."""
    of = [bodies_race.of_walks(rows, "as shipped", steering) for steering in ("straight", "steered")]
    lines = []
    for straight, steered in zip(*of):
        line = [straight["pace"]]
        for row in (straight, steered):
            line += [walked(row), f"{row['upright_walks']} of {row['walks']}"]
        error, swing, airborne = (float(steered[name]) for name in ("error_rad", "swing", "airborne"))
        lines.append(
            [*line, f"{error:.3f}", f"{swing:.3f}", f"{100.0 * float(steered['slip_m_s']):.1f}", f"{airborne:.2f}"]
        )
    head = ["pace", "straight, cm/s", "upright walks", "steered, cm/s", "upright walks"]
    return table([*head, "tracking error, rad", "swing", "slip, cm/s", "airborne"], lines)


def walk_ceilings(rows):
    """The ceiling of each variant and steering, and where it lies."""
    lines = []
    for variant in bodies_race.VARIANTS:
        for steering in ("straight", "steered"):
            of = bodies_race.of_walks(rows, variant, steering)
            at_one = next(row for row in of if row["pace"] == "1")
            best, beyond = bodies_race.ceiling(of)
            times = float(best["speed_m_s"]) / float(at_one["speed_m_s"])
            lines.append(
                [
                    variant,
                    steering,
                    walked(at_one),
                    walked(best),
                    best["pace"],
                    f"{times:.1f}",
                    f"{float(best['error_rad']):.3f}",
                    f"{float(best['swing']):.3f}",
                    f"{100.0 * float(best['slip_m_s']):.1f}",
                    f"{float(best['airborne']):.2f}",
                    f"{beyond['upright_walks']} of {beyond['walks']} at {beyond['pace']}" if beyond else "",
                ]
            )
    head = ["spider", "steering", "at pace 1, cm/s", "ceiling, cm/s", "at pace", "times pace 1", "tracking error, rad"]
    return table([*head, "swing", "slip, cm/s", "airborne", "upright walks beyond"], lines)


def raced_with_bodies(data, name):
    """The family of tests of the race with bodies, and persistence; a sentence if no run is complete."""
    if not (data.folder / f"{name}.csv").exists():
        return "No run of this design is complete.\n"
    rows = data(name)
    words = {"end": "at the end", "late_change": "late change"}
    lines = []
    for row in rows:
        if row["metric"] == "persists":
            continue
        lines.append(
            [
                {"both": "both inherit", "prey": "prey alone", "predator": "predators alone"}.get(
                    row["set"], row["set"]
                ),
                {"predator": "predators"}.get(row["species"], row["species"]),
                words[row["group"]],
                row["mean"] and f"{float(row['mean']):.3g}",
                row["null_mean"] and f"{float(row['null_mean']):.3g}",
                signed(row, ("difference", "difference_lower", "difference_upper")) + star(row["p_holm"]),
                p_text(row["p_holm"]),
                row["detectable"] and f"{float(row['detectable']):.2g}",
                row["runs"] + (f" and {row['null_runs'] or 0}" if row["null"] == "alone" else ""),
            ]
        )
    persists = [
        [row["set"], signed(row, ("mean", "lower", "upper"), 1.0, ""), row["runs"]]
        for row in rows
        if row["metric"] == "persists"
    ]
    head = [
        "world",
        "of",
        "when",
        "mean",
        "null, or alone",
        "difference",
        "p (Holm)",
        "found in 80 %",
        "runs that persist",
    ]
    return table(head, lines) + "\n" + table(["who inherits", "both persist", "runs"], persists)


def contests_with_bodies(data):
    """Progress on MuJoCo of genomes that evolved without bodies, in the first runs and on fresh seeds."""
    sets = {"race_with_bodies_contests": "first", "race_with_bodies_contests_again": "fresh"}
    lines = [
        [
            SIDES[row["species"]],
            words,
            signed(row, ("mean", "lower", "upper")),
            row["null_mean"] and f"{float(row['null_mean']):+.3g}",
            signed(row, ("difference", "difference_lower", "difference_upper")) + star(row["p_holm"]),
            p_text(row["p_holm"]),
            row["detectable"] and f"{float(row['detectable']):.2g}",
            f"{row['runs']}, {row['null_runs']}",
        ]
        for words, row in race_sets(data, "", sets)
    ]
    head = ["progress of", "seeds", "both inherit, s", "none, s", "difference, s", "p (Holm)", "found in 80 %"]
    return table([*head, "runs: both, none"], lines)


def open_choices(choices):
    """The list of open choices."""
    lines = [
        [f"`{choice['name']}`", choice["question"], choice["text"], choice["first"], choice["other"]]
        for choice in choices
    ]
    return table(["choice", "question", "the text", "in `paper`", "other reading"], lines)


def tables(data, choices):
    """The function that makes each table."""
    made = {
        "open choices": lambda: open_choices(choices),
        "screen effects": lambda: effects(data("screen_effects")),
        "screen reached": lambda: reached(data("screen_cells"), data("kinematic_paper_published")),
        "ranges": lambda: ranges(data("ranges")),
        "bodies": lambda: bodies(data("bodies")),
        "bodies differences": lambda: changes(data("bodies")),
        "walls": lambda: bodies(data("walls"), "released"),
        "walls differences": lambda: at_walls(data("walls")),
        "conclusions": lambda: table(answers.conclusion_heads(), answers.conclusions(data)),
        "answers": lambda: table(answers.HEADS, answers.evolved(data) + answers.choices_that_matter(data)),
        "ablations paper": lambda: swaps(data("ablations"), "paper"),
        "ablations released": lambda: swaps(data("ablations"), "released"),
        "inheritance": lambda: inheritance(data("inheritance")),
        "lineages": lambda: lineages(data("race_arms_race_lineages")),
        "historical": lambda: historical(data("race_arms_race")),
    }
    made["turning"] = lambda: turning(data("selection"))
    made["turning by distance"] = lambda: turning_by_distance(data("selection"))
    made["evolved again"] = lambda: evolved_again(data("evolution_again"))
    made["evolvable bodies"] = lambda: selected(data("evolvable_bodies"), "bodies")
    made["evolved lives"] = lambda: evolved_lives(data("evolution_lives"))
    for name in EVOLVED:
        made[f"evolved {name}"] = lambda name=name: evolved(data("evolution"), name)
    made |= {
        "queen primary": lambda: queen(data("red_queen"), True, "paper", "pond", "growing"),
        "queen other": lambda: queen(data("red_queen"), False, "paper"),
        "queen mujoco": lambda: queen(data("red_queen_mujoco"), True, "released"),
    }
    made |= {
        "paces worlds": lambda: in_each_world(data),
        "paces answers": lambda: race_answers(data),
        "paces driven": lambda: paces(data),
        "paces pooled": lambda: pooled_paces(data),
        "paces go on": lambda: going_on(data),
        "paces through time": lambda: through_time(data),
        "paces last": lambda: lasting(data, RACE | OTHER_RACES),
        "paces other driven": lambda: paces(data, OTHER_RACES),
        "paces other worlds": lambda: in_each_world(data, OTHER_RACES),
        "paces other go on": lambda: going_on(data, OTHER_RACES),
    }
    made |= {
        "worlds": lambda: worlds(data("no_criterion")),
        "worlds contrasts": lambda: world_contrasts(data("no_criterion")),
        "worlds activity": lambda: world_activity(data("no_criterion")),
        "worlds selection": lambda: world_selection(data("no_criterion_selection")),
        "open ended": lambda: growth(data("open_ended")),
        "open ended two foods": lambda: growth(data("open_ended"), "slope with two foods"),
        "open ended foods": lambda: by_foods(data("open_ended")),
        "open ended kinds": lambda: kinds_of_diet(data("open_ended"), data("open_ended_again")),
        "open ended levels": lambda: two_by_two(data("open_ended"), "level"),
        "open ended slopes": lambda: two_by_two(data("open_ended"), "slope"),
        "open ended persistence": lambda: persisting_cells(data("open_ended")),
        "living": lambda: living([row for row in data("no_criterion_settings") if row["metric"] != "velocity"]),
        "living settings": lambda: settings(data("no_criterion_settings")),
    }
    made["zones critical"] = lambda: table(*zones.critical_lines(data("mating_zones_critical")))
    for name in ("rules", "again", "mujoco"):
        made[f"zones {name}"] = lambda name=name: table(*zones.rule_lines(data(f"mating_zones_{name}")))
    made["living mujoco"] = lambda: living([row for row in data("no_criterion_mujoco") if row["metric"] == "velocity"])
    made["living evolving"] = lambda: evolving_ponds(data)
    made |= {
        "walks": lambda: walks(data("race_with_bodies_walks")),
        "walks ceilings": lambda: walk_ceilings(data("race_with_bodies_walks")),
        "race with bodies contests": lambda: contests_with_bodies(data),
        "race with bodies": lambda: raced_with_bodies(data, "race_with_bodies"),
        "race with bodies again": lambda: raced_with_bodies(data, "race_with_bodies_again"),
        "race with bodies gaits": lambda: raced_with_bodies(data, "race_with_bodies_gaits"),
    }
    for name in ("arms_race", "ranges", "room", "mujoco", "mujoco_brains"):
        made[f"race {name}"] = lambda name=name: race(data(f"race_{name}"))
    for backend in ("kinematic", "mujoco"):
        for rules in ("paper", "released"):
            name = f"{backend} {rules}"
            file = name.replace(" ", "_")
            made[f"{name} shadow"] = lambda file=file: against_shadow(data(file))
            made[f"{name} claims"] = lambda file=file: claims(data(f"{file}_published"))
    return made


def pages_of(studies):
    return sorted((studies / "results").glob("*.md"))


def with_line(data, make):
    """A table, and the line that says where its data come from."""
    data.used.clear()
    text = make()
    if missing := [name for name in data.used if name not in data.origins]:
        raise SystemExit(f"{data.folder / 'provenance.csv'}: has no row of {', '.join(missing)}")
    return text + ("\n" + provenance.line([data.origins[name] for name in data.used]) if data.used else "")


def pages_of_data(studies, choices):
    """{data: the pages with a table of it}."""
    data, found = Data(studies / "results/data"), {}
    made = tables(data, choices)
    for path in pages_of(studies):
        for match in MARKED.finditer(path.read_text()):
            data.used.clear()
            made[match[2]]()
            for name in data.used:
                pages = found.setdefault(name, [])
                pages += [path.name] if path.name not in pages else []
    return found


def update(studies, choices, check=False):
    """Writes the tables of all pages; with `check` only reports differences from the data. Returns the exit code."""
    data = Data(studies / "results/data")
    made = tables(data, choices)
    differing = []
    for path in pages_of(studies):
        page = path.relative_to(studies.parent)
        old = path.read_text()

        def renewed(match):
            if match[2] not in made:
                raise SystemExit(f"{page}: table {match[2]}: must be one of {', '.join(made)}")
            new = match[1] + with_line(data, made[match[2]]) + match[3]
            if new != match[0]:
                differing.append(f"{page}: {match[2]}")
            return new

        text = MARKED.sub(renewed, old)
        if not check and text != old:
            path.write_text(text)
    if check and differing:
        print(
            "tables differ from results/data; run studies/reproduce --tables: " + ", ".join(differing), file=sys.stderr
        )
        return 1
    return 0
