# SPDX-License-Identifier: MIT
"""Tables of what evolves: lineages, bodies, gaits and brains, and how selection acts on behaviour."""
import itertools

import data_rows
from data_rows import p_text
from page_tables.cells import signed, star, star_over, table

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


def selected(rows, of="pond"):
    """Price's terms over the neutral null. With generations they are cm/s a generation, otherwise in the trait's unit."""
    keys, lines = ("runs_mean", "neutral_mean", "difference", "difference_lower", "difference_upper"), []
    for row in data_rows.over_neutral(rows):
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


def tables(data):
    """The function that makes each table of these."""
    made = {
        "lineages": lambda: lineages(data("race_arms_race_lineages")),
        "turning": lambda: turning(data("selection")),
        "turning by distance": lambda: turning_by_distance(data("selection")),
        "evolved again": lambda: evolved_again(data("evolution_again")),
        "evolved lives": lambda: evolved_lives(data("evolution_lives")),
        "evolvable bodies": lambda: selected(data("evolvable_bodies"), "bodies"),
        "living evolving": lambda: evolving_ponds(data),
    }
    for name in EVOLVED:
        made[f"evolved {name}"] = lambda name=name: evolved(data("evolution"), name)
    return made
