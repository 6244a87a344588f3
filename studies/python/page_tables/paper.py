# SPDX-License-Identifier: MIT
"""Tables of the paper's rules: claims, readings of the text, ablations and inheritance."""
import data_rows
from data_rows import p_text
from page_tables.cells import digits, of_key, ranged, star, table, title


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
            middle, lower, upper = (digits(ours, value, True) for value in data_rows.welch(*numbers))
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
            middle, lower, upper = data_rows.welch(
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


def open_choices(choices):
    """The list of open choices."""
    lines = [
        [f"`{choice['name']}`", choice["question"], choice["text"], choice["first"], choice["other"]]
        for choice in choices
    ]
    return table(["choice", "question", "the text", "in `paper`", "other reading"], lines)


def tables(data):
    """The function that makes each table of these."""
    made = {
        "screen effects": lambda: effects(data("screen_effects")),
        "screen reached": lambda: reached(data("screen_cells"), data("kinematic_paper_published")),
        "ranges": lambda: ranges(data("ranges")),
        "bodies": lambda: bodies(data("bodies")),
        "bodies differences": lambda: changes(data("bodies")),
        "walls": lambda: bodies(data("walls"), "released"),
        "walls differences": lambda: at_walls(data("walls")),
        "ablations paper": lambda: swaps(data("ablations"), "paper"),
        "ablations released": lambda: swaps(data("ablations"), "released"),
        "inheritance": lambda: inheritance(data("inheritance")),
    }
    for backend in ("kinematic", "mujoco"):
        for rules in ("paper", "released"):
            name = f"{backend} {rules}"
            file = name.replace(" ", "_")
            made[f"{name} shadow"] = lambda file=file: against_shadow(data(file))
            made[f"{name} claims"] = lambda file=file: claims(data(f"{file}_published"))
    return made
